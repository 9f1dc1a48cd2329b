"""What holds for every scene: its energy does not rise, and a changed scene does what the change says (scene_changes.py).

A Property says how a random scene is prepared for it, and what of a Case breaks it: `broken(case)` gives a text, or none. A scene that it
says nothing about, or that does not run, does not break it; that a random scene runs at all is the property `runs`.
"""
import re
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path
from types import SimpleNamespace

import numpy as np

import harness
import random_scenes
import scene_changes as changes

LIMIT = 120     # seconds of a run
SLACK = 0.015   # cells: what weight gives over this way is no rise of energy


# ---- runs

@dataclass
class Run:
    status: int | None    # none: out of time
    errors: str
    steps: list
    bodies: list
    gaps: list

    @property
    def ok(self):
        return self.status == 0 and len(self.steps) > 1


known = {}    # runs by the text of their scene


def run(case):
    """The tables of a case's run, in one thread. The last runs are remembered: properties share the run of the scene as it is."""
    key = case.text()
    if key not in known:
        while len(known) >= 16:
            known.pop(next(iter(known)))
        known[key] = run_now(case)
    return known[key]


def run_now(case):
    with tempfile.TemporaryDirectory() as folder:
        made = case.copy()
        made.scene["output"] = {"fields": []}
        file, out = made.write(folder), Path(folder) / "out"
        try:
            done = subprocess.run([harness.COMMAND, "run", file, "-o", out, "--quiet"], capture_output=True, text=True, timeout=LIMIT,
                                  env={**harness.single_process(), "OMP_NUM_THREADS": "1"})
        except subprocess.TimeoutExpired:
            return Run(None, f"not done in {LIMIT} s", [], [], [])
        tables = [harness.read_table(out / name) if (out / name).exists() else [] for name in ("steps.csv", "bodies.csv", "gaps.csv")]
        return Run(done.returncode, done.stderr.replace(folder + "/", ""), *tables)


# ---- energy

def mesh_volume(text, name):
    """Volume and reach of a mesh; 2D: area."""
    words = [line.split() for line in text.splitlines() if line.strip()]
    if not name.endswith(".obj"):
        points = np.array(words, float)
        x, y = points.T
        return 0.5 * abs(float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y))), float(np.abs(points).max())
    points = np.array([w[1:] for w in words if w[0] == "v"], float)
    faces = [[int(i) - 1 for i in w[1:]] for w in words if w[0] == "f"]
    return abs(sum(float(points[a] @ np.cross(points[b], points[c])) for a, b, c in faces)) / 6, float(np.abs(points).max())


def volume_and_reach(case, body):
    if body["shape"] == "mesh":
        return mesh_volume(case.files[body["file"]], body["file"])
    if body["shape"] == "half-space":
        return 0.0, 0.0
    reach = max(body["size"]) / 2 if body["shape"] == "box" else body["radius"] + body.get("length", 0.0) / 2
    return harness.volume(body, case.dimension), reach


def tank_of(case, overlapping):
    """A case as random_scenes judges it."""
    scene = case.scene
    bodies = [SimpleNamespace(name=body["name"], keys=body, shape=SimpleNamespace(volume=v, extent=reach))
              for body in scene["body"] for v, reach in [volume_and_reach(case, body)]]
    return SimpleNamespace(dimension=case.dimension, dx=case.dx, rho=scene["fluid"].get("density", 1.0), bodies=bodies, judge="energy", carried=0.0,
                           gravity=np.array(scene.get("gravity", [0.0] * case.dimension)), kind="overlapping" if overlapping else "")


def closed(case):
    """Whether nothing drives: no open side, no wall that slides, no body that moves as told."""
    return (all(side in ("wall", "periodic") for side in case.sides.values()) and not any(b.get("motion") == "prescribed" for b in case.scene["body"])
            and not any(case.scene["fluid"].get("velocity", [0.0])))


def judge_energy(case, ran):
    """Of a closed scene: fluid, bodies, springs and what weight and forces can still give may not have more than at the start. Allowed are 2 % of the largest
    kinetic energy so far and what weight and forces give over 0.015 cells (the first steps, which know little of what came before, give 0.011 in
    the worst of the validation's 240 closed scenes in 2D that are right), and what random_scenes allows where overlaps are taken out."""
    energies = random_scenes.Energies(tank_of(case, "bodies overlap at the start" in ran.errors), ran.steps, ran.bodies)
    over_a_cell = energies.least / random_scenes.LEAST
    largest = np.maximum.accumulate(np.maximum(energies.kinetic, 0.0))
    surplus = energies.whole - energies.whole[0] - energies.lift - random_scenes.ENERGY * largest - SLACK * over_a_cell
    worst = int(surplus.argmax())
    if surplus[worst] <= 1e-9 * (largest[-1] + over_a_cell):
        return None
    rise = energies.whole[worst] - energies.whole[0] - energies.lift
    return (f"energy rises by {rise:.3g}, {100 * rise / max(largest[worst], 1e-300):.3g} % of the largest kinetic energy so far"
            + (f", as much as weight gives over {rise / over_a_cell:.3g} cells" if over_a_cell else "") + f" (step {worst})")


def energy_rises(case):
    ran = run(case) if closed(case) else None
    return judge_energy(case, ran) if ran and ran.ok else None


# ---- comparisons

def by_body(rows, step):
    return {row["body"]: row for row in rows if row["step"] == step}


def distance(case, ours, theirs):
    """Of two sets of bodies' rows: (of places, cells; of velocities, cells a full step). What turns counts at half of the body's reach."""
    width = [length if case.sides[f"{axis}_low"] == "periodic" else 0.0 for axis, length in zip("xyz", case.scene["domain"]["size"])]

    def apart(a, b, period):    # in a periodic tank a body stands at many places
        return abs(a - b - (period * round((a - b) / period) if period else 0.0))

    places, velocities = [0.0], [0.0]
    for body in case.scene["body"]:
        a, b, r = ours[body["name"]], theirs[body["name"]], 0.5 * volume_and_reach(case, body)[1]
        places += [apart(a[k], b[k], period) for k, period in zip("xyz", width)] + [r * abs(a[k] - b[k]) for k in ("angle",) if k in a]
        velocities += [abs(a[k] - b[k]) for k in ("vx", "vy", "vz") if k in a] + [r * abs(a[k] - b[k]) for k in ("omega", "wx", "wy", "wz") if k in a]
    return max(places) / case.dx, max(velocities) / case.dx * case.scene["time"]["max_step"]


@dataclass
class Same:
    """That a change changes nothing. Bounds: of velocities after the first step (cells a step); of places at the end (cells, and a part of the way of the
    body that went furthest)."""
    change: object
    first: float
    last: float
    of_way: float = 0.0

    def figures(self, case):
        """(first, last, way), or a text where the changed scene does not run; none where there is nothing to say."""
        changed, ours = self.change(case), run(case)
        if changed is None or not ours.ok:
            return None
        other, back = changed
        theirs = run(other)
        if not theirs.ok:
            return f"the changed scene does not run: {told(theirs)}"
        rows, start, end = [back(row) for row in theirs.bodies], by_body(ours.bodies, 0), by_body(ours.bodies, ours.steps[-1]["step"])
        first = distance(case, by_body(ours.bodies, 1), by_body(rows, 1))[1]
        return first, distance(case, end, by_body(rows, theirs.steps[-1]["step"]))[0], distance(case, start, end)[0]

    def __call__(self, case):
        figures = self.figures(case)
        if figures is None or isinstance(figures, str):
            return figures
        first, last, way = figures
        if first > self.first:
            return f"velocities after the first step are off by {first:.2g} cells a step, more than {self.first:.2g}"
        allowed = self.last + self.of_way * way
        return f"bodies end {last:.2g} cells off, more than {allowed:.2g}, having gone {way:.2g}" if last > allowed else None


# ---- the properties

def told(ran):
    return f"exit {ran.status}: {' '.join(ran.errors.split())[-300:]}"


def does_not_run(case):
    ran = run(case)
    return None if ran.ok else told(ran)


def kind_of(text):
    """Of a message: its start, less names and numbers."""
    return re.sub(r"'[^']*'|[-+.\deE]*\d[-+.\deE]*", "", text)[:60]


def warnings(case):
    return {kind_of(line) for line in run(case).errors.splitlines() if "warning:" in line}


def sound(case, of):
    """Whether a case is still of the kind that another one is: bodies in the tank that were there, nothing to warn of that is new (overlaps, what is too thin)."""
    def inside(case):
        size, low = case.scene["domain"]["size"], case.scene["domain"].get("origin", [0.0] * case.dimension)
        for body in case.scene["body"]:
            least = 0.49 * min(body["size"]) if "size" in body else 0.98 * body.get("radius", 0.0)
            if not body.get("inside_out") and not all(o + least <= x <= o + s - least for x, s, o in zip(body.get("position", low), size, low)):
                yield body["name"]
    return set(inside(case)) <= set(inside(of)) and warnings(case) <= warnings(of)


def in_a_stream(case):
    """An unbounded scene whose steps do not depend on how fast it is carried."""
    made = changes.unbounded(case)
    if made:
        made.scene["time"]["cfl"] = 10.0
    return made


@dataclass
class Property:
    broken: object                         # Case -> text or none
    prepare: object = lambda case: case    # what of a random scene it is about; none: nothing of it


# Bounds: what the validation's scenes in 2D are off by over 20 full steps, and some room; a scene in fifty is beyond them where contacts decide otherwise.
# Between two runs of the same flow there are only the solver's tolerance and round-off, which steps and contacts let grow: order is off by 1e-12
# cells in the median, shift and mirror by 1e-9; mirror in 3D by up to 1e-5: cuts through triangles fall otherwise. Motion: carried over the grid, the flow is interpolated at other places: 1 % of the way in the median.
PROPERTIES = {
    "runs": Property(does_not_run),
    "energy": Property(energy_rises),
    "mirror": Property(Same(changes.mirrored, first=1e-5, last=1e-3)),
    "order": Property(Same(changes.reordered, first=1e-6, last=1e-3)),
    "shift": Property(Same(changes.shifted, first=1e-4, last=1e-3), changes.unbounded),
    "motion": Property(Same(lambda case: changes.carried(case, 1.0), first=0.02, last=0.02, of_way=0.1), in_a_stream),
}
