"""Runs two short examples and tries their pages in a browser. Usage: browser_test.py NODE GAPFLOW PROJECT; exit status 77: skipped."""
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

node, gapflow, project = sys.argv[1], sys.argv[2], Path(sys.argv[3])
if not (project / "web" / "node_modules" / "playwright-core").is_dir():
    print("skipped: no web/node_modules; web/test installs them")
    sys.exit(77)
runs = {"01_plates_pulled_apart": ["domain.cells=[64,64]", "time.end=0.2", "output.every=0.05"],
        "04_sphere_leaving_wall": ["domain.cells=[24,24,24]", "time.end=0.2", "output.every=0.05"]}


# Enough disks that a button each would be too many.
CROWD = """
gravity = [0, -1]
[domain]
size = [2, 2]
cells = [32, 32]
[[crowd]]
name = "sand"
shape = "ball"
radius = 0.08
number = 60
density = 2
[time]
end = 0.04
max_step = 0.02
[output]
every = 0.02
"""

# All that a scene can ask to be measured.
MEASURED = """
[domain]
size = [2, 1]
cells = [32, 16]
[domain.sides]
x_low = { inflow = [1, 0] }
x_high = "open"
[fluid]
viscosity = 0.05
[[body]]
name = "disk"
shape = "ball"
radius = 0.2
position = [0.7, 0.5]
motion = "fixed"
[[probe]]
name = "tap"
point = [0.1, 0.5]
fields = ["pressure"]
[[probe]]
name = "wake"
line = { from = [0.95, 0.5], to = [2, 0.5], count = 12 }
fields = ["velocity"]
every = 0.05
[[flux]]
name = "outlet"
side = "x_high"
[[flux]]
name = "above"
plane = { point = [0.7, 0.5], normal = "x", low = [0, 0.5], high = [2, 1] }
[time]
end = 0.6
max_step = 0.02
[output]
every = 0.2
forces = true
"""


# A disk that falls with its graded grid.
GRADED = """
gravity = [0, -1]
[domain]
size = [8, 8]
origin = [-4, -4]
spacing = 0.1
core = { low = [-1, -1], high = [1, 1] }
follow = "disk"
[domain.sides]
x_low = "far"
x_high = "far"
y_low = "far"
y_high = "far"
[[body]]
name = "disk"
shape = "ball"
radius = 0.4
position = [0, 0]
density = 3
[time]
end = 1
max_step = 0.1
[output]
every = 0.5
"""


def comparison(folder):
    """The page of a sweep."""
    words = ["sweep", project / "examples/01_plates_pulled_apart/scene.toml", "-o", folder / "sweep", "--quiet", "--vary", "body.upper.density=2,8"]
    subprocess.run([gapflow, *words, *(word for s in runs["01_plates_pulled_apart"] for word in ("--set", s))], check=True)
    subprocess.run([gapflow, "report", folder / "sweep"], check=True)
    return folder / "sweep" / "report.html"


def measured(folder):
    """Pages of a run, of a sweep and of a sweep of steady runs of a scene that measures."""
    scene = folder / "measured.toml"
    scene.write_text(MEASURED)
    subprocess.run([gapflow, "run", scene, "-o", folder / "measured", "--quiet"], check=True)
    vary = ["--vary", "fluid.viscosity=0.01:0.1:3:log", "--vary", "body.disk.position=[0.7,0.5],[0.7,0.4]"]
    subprocess.run([gapflow, "sweep", scene, "-o", folder / "measured_sweep", "--quiet", *vary], check=True)
    steady = ["--set", "time.until_steady=0.5", "--vary", "fluid.viscosity=0.05,0.1"]
    subprocess.run([gapflow, "sweep", scene, "-o", folder / "steady_sweep", "--quiet", *steady], check=True)
    pages = [folder / "measured", folder / "measured_sweep", folder / "steady_sweep"]
    for page in pages:
        subprocess.run([gapflow, "report", page], check=True)
    return [page / "report.html" for page in pages]


def page_of(folder, name, scene):
    (folder / f"{name}.toml").write_text(scene)
    subprocess.run([gapflow, "run", folder / f"{name}.toml", "-o", folder / name, "--quiet"], check=True)
    subprocess.run([gapflow, "report", folder / name], check=True)
    return folder / name / "report.html"


def others(folder, pages):
    """Pages of runs that have less: one row, no row and no frames, no fields, no gaps."""
    less = []

    def page(name):
        less.append(folder / name / "report.html")
        subprocess.run([gapflow, "report", folder / name], check=True)

    for name, keep in (("one_row", 2), ("nothing", 1)):
        shutil.copytree(pages[0].parent, folder / name)
        for table in ("steps.csv", "bodies.csv", "gaps.csv"):
            file = folder / name / table
            file.write_text("".join(file.read_text().splitlines(keepends=True)[:keep]))
    (folder / "nothing" / "gapflow.pvd").unlink()
    page("one_row")
    page("nothing")
    for name in runs:
        done = [gapflow, "run", project / "examples" / name / "scene.toml", "-o", folder / f"bare_{name}", "--quiet", "--set",
                "time.end=0.02", "--set", "output.fields=[]", "--set", "gap.model=none", "--set",
                f"domain.cells={[16] * (2 if '01' in name else 3)}"]
        subprocess.run(done, check=True)
        page(f"bare_{name}")
    return less


with tempfile.TemporaryDirectory() as folder:
    pages = []
    for name, settings in runs.items():
        out = Path(folder) / name
        sets = [word for setting in settings for word in ("--set", setting)]
        subprocess.run([gapflow, "run", project / "examples" / name / "scene.toml", "-o", out, "--quiet", *sets], check=True)
        subprocess.run([gapflow, "report", out], check=True)
        pages.append(out / "report.html")
    pages += [comparison(Path(folder)), page_of(Path(folder), "crowd", CROWD), *measured(Path(folder)), *others(Path(folder), pages),
              page_of(Path(folder), "graded", GRADED)]
    sys.exit(subprocess.run([node, project / "web" / "browser_test.mjs", *pages]).returncode)
