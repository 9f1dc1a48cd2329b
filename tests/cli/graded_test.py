"""Graded grids as a user meets them: all commands work on one, VTK reads its fields, a body that leaves the core ends the run. Usage: graded_test.py GAPFLOW EXAMPLES"""
import json
import math
import sys
import tempfile
import unittest
from pathlib import Path

from harness import gapflow, rows

EXAMPLES = Path(sys.argv.pop(1))

# A ball in a core of 2.4 x 2 at the floor of a sea that is 12 wide and 8 deep.
SEA = """
[domain]
size = [12.0, 8.0]
origin = [-6.0, 0.0]
spacing = 0.1
core = { low = [-1.0, 0.0], high = [1.4, 2.0] }
growth = 1.2
largest = 0.9
[domain.sides]
x_low = "far"
x_high = "far"
y_high = "far"
[fluid]
viscosity = 0.01
[[body]]
name = "ball"
shape = "ball"
radius = 0.4
position = [0.0, 1.003]
velocity = [1.0, 0.0]
density = 2.0
[[body]]
name = "cliff"
shape = "box"
size = [1.0, 8.0]
position = [-5.5, 4.0]
motion = "fixed"
[time]
end = 0.2
max_step = 0.05
[output]
every = 0.1
fields = ["velocity", "pressure", "vorticity", "divergence"]
"""


def widths(length, spacing, growth, largest):
    """The least number of cells outside a core that reach a side."""
    count, reached, width = 0, 0.0, spacing
    while reached < length * (1 - 1e-9):
        width = min(width * growth, largest)
        reached += width
        count += 1
    return count


class Graded(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.out = self.folder / "out"
        self.scene = self.folder / "sea.toml"
        self.scene.write_text(SEA)

    def run_scene(self, *settings):
        return gapflow("run", self.scene, "-o", self.out, "--quiet", *(word for setting in settings for word in ("--set", setting)))

    def rectilinear(self, number):
        try:
            from vtkmodules.util.numpy_support import vtk_to_numpy
            from vtkmodules.vtkIOXML import vtkXMLRectilinearGridReader
        except ImportError:
            self.skipTest("VTK's Python package is not installed")
        reader = vtkXMLRectilinearGridReader()
        reader.SetFileName(str(self.out / "fields" / f"fields_{number:05d}.vtr"))
        reader.Update()
        grid = reader.GetOutput()
        axes = [vtk_to_numpy(values) for values in (grid.GetXCoordinates(), grid.GetYCoordinates(), grid.GetZCoordinates())]
        data = grid.GetCellData()
        return axes, {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i)) for i in range(data.GetNumberOfArrays())}

    def test_check_tells_what_the_grading_comes_to(self):
        done = gapflow("check", self.scene)
        self.assertEqual(done.returncode, 0, done.stderr)
        left, right, above = (widths(length, 0.1, 1.2, 0.9) for length in (5.0, 4.6, 6.0))
        self.assertRegex(done.stdout, f"cells +{left + 24 + right} x {20 + above} = ")
        self.assertRegex(done.stdout, r"core +24 x 20 cells; outside it cells grow by up to 1\.2 to a width of 0\.\d+, aspect up to \d")

    def test_vtk_reads_the_fields_where_they_are(self):
        done = self.run_scene()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(list((self.out / "fields").glob("*.vti")), [])
        self.assertIn("fields/fields_00002.vtr", (self.out / "gapflow.pvd").read_text())
        (x, y, z), data = self.rectilinear(2)
        self.assertEqual(len(z), 1)
        for place, side in ((x[0], -6), (x[-1], 6), (y[0], 0), (y[-1], 8)):
            self.assertAlmostEqual(place, side, places=12)
        first = int(abs(x + 1.0).argmin())
        for i in range(25):
            self.assertAlmostEqual(x[first + i], -1.0 + 0.1 * i, places=12)
        for j in range(21):
            self.assertAlmostEqual(y[j], 0.1 * j, places=12)
        for places, start, step in ((x, first + 24, 1), (x, first, -1), (y, 20, 1)):
            outwards = abs(places[start::step][1:] - places[start::step][:-1])
            self.assertGreater(len(outwards), 5)
            for inner, outer in zip([0.1, *outwards], outwards):
                self.assertTrue(inner * (1 - 1e-6) <= outer <= 1.2 * inner * (1 + 1e-9) and outer <= 0.9 * (1 + 1e-9), outwards)
        nx, ny = len(x) - 1, len(y) - 1
        self.assertEqual(data["kind"].size, nx * ny)
        kind = data["kind"].reshape(ny, nx)
        ball = {row["body"]: row for row in rows(self.out / "bodies.csv")}["ball"]
        middle = (0.5 * (x[1:] + x[:-1]), 0.5 * (y[1:] + y[:-1]))
        column, row = (int(abs(values - float(ball[name])).argmin()) for values, name in zip(middle, "xy"))
        self.assertEqual(kind[row, column], 0)
        self.assertEqual(set(kind[:, x[1:] < -5.0].ravel().tolist()), {0}, "in the cliff, outside the core")
        self.assertEqual(set(kind[:, (x[:-1] > -5.0) & (x[1:] < -1.0)].ravel().tolist()), {1})
        volume = (x[1:] - x[:-1])[None, :] * (y[1:] - y[:-1])[:, None]
        divergence = data["divergence"].reshape(ny, nx)
        self.assertLess(float((abs(divergence) * volume).max()), 1e-7)

    def test_added_mass_is_that_of_the_same_domain_all_fine(self):
        whole = self.folder / "whole.toml"
        whole.write_text("\n".join(line for line in SEA.splitlines() if not line.startswith(("core", "growth", "largest"))))
        found = []
        for scene in (self.scene, whole):
            done = gapflow("added-mass", scene, "--json")
            self.assertEqual(done.returncode, 0, done.stderr)
            found.append(json.loads(done.stdout))
        graded, uniform = found
        self.assertEqual(uniform["cells"], 120 * 80)
        self.assertLess(5 * graded["cells"], uniform["cells"])
        for i in range(2):
            self.assertLess(abs(graded["matrix"][i][i] / uniform["matrix"][i][i] - 1), 0.01, found)

    def test_report_and_pictures(self):
        self.assertEqual(self.run_scene().returncode, 0)
        for words in ((), ("--png",)):
            done = gapflow("report", self.out, *words)
            self.assertEqual(done.returncode, 0, done.stderr)
        self.assertGreater((self.out / "report.html").stat().st_size, 10000)

    def test_converge_counts_the_core(self):
        done = gapflow("converge", self.scene, "--cells", "12,24", "-o", self.out, "--quiet", "--set", "output.every=0", "--set", "time.end=0.1",
                       "--quantity", "ball.vx")
        self.assertEqual(done.returncode, 0, done.stderr)
        for n, spacing, growth in ((12, 0.2, 1.44), (24, 0.1, 1.2)):
            domain = json.loads(json.loads((self.out / f"cells_{n}" / "run.json").read_text())["scene"])["domain"]
            self.assertAlmostEqual(domain["spacing"], spacing, places=14)
            self.assertAlmostEqual(domain["growth"], growth, places=14)
        done = gapflow("converge", self.scene, "--cells", "12,24", "-o", self.out / "fitted", "--quiet", "--set", "output.every=0", "--set",
                       "time.end=0.05", "--quantity", "ball.vx", "--set", "domain.core.high=[1.37,1.6]")  # 23.7 cells, taken as 24
        self.assertEqual(done.returncode, 0, done.stderr)
        for n in (12, 24):
            domain = json.loads(json.loads((self.out / "fitted" / f"cells_{n}" / "run.json").read_text())["scene"])["domain"]
            self.assertAlmostEqual(domain["core"]["high"][0], 1.4, places=14)
        done = gapflow("converge", self.scene, "--cells", "13,24", "-o", self.out)
        self.assertEqual(done.returncode, 2)
        self.assertIn("domain.core", done.stderr)

    def test_a_body_that_leaves_the_core_ends_the_run(self):
        done = self.run_scene("time.end=4", "body.ball.velocity=[3.0,0.0]", "output.every=2")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertRegex(done.stderr, r"at time 0\.\d+ body 'ball' reaches out of the core: it lies from .* along x, the core from -1 to 1\.4; "
                         "choose a larger domain.core")
        ball = [row for row in rows(self.out / "bodies.csv") if row["body"] == "ball"][-1]
        self.assertTrue(1.0 < float(ball["x"]) < 1.2, ball)
        self.assertTrue((self.out / "checkpoint.h5").exists())
        self.assertEqual(json.loads((self.out / "run.json").read_text())["status"], "failed")

    def test_a_body_outside_the_core_is_refused_at_the_start(self):
        done = self.run_scene("body.ball.position=[1.2,1.003]")
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr, "domain.core: body 'ball' reaches out of the core: it lies from .* to 1.6 along x, .*; bodies that move, and gaps, stay in "
                         "the core: choose a larger one, or another place")
        for command in ("check", "added-mass"):
            done = gapflow(command, self.scene, "--set", "body.ball.position=[1.2,1.003]")
            self.assertEqual(done.returncode, 2)
            self.assertIn("domain.core: body 'ball' reaches out of the core", done.stderr)

    def test_thin_bodies_are_told_the_spacing_that_sees_them(self):
        done = gapflow("check", self.scene, "--set", "body.ball.radius=0.09")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("use domain.spacing = 0.05 or less, or a thicker body", done.stdout)
        done = gapflow("check", self.scene, "--set", "body.ball.radius=0.09", "--set", "domain.spacing=0.05")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("thin", done.stdout)

    def test_blade_has_the_added_mass_of_its_ellipsoid(self):
        """Half-axes 0.25, 0.25 / 6 and 0.5: 105.0 kg across the face and 3.1 along the chord, whose sum twist leaves nearly as it is."""
        done = gapflow("added-mass", EXAMPLES / "24_propeller_blade" / "scene.toml", "--json", "--set", "domain.spacing=0.04")
        self.assertEqual(done.returncode, 0, done.stderr)
        matrix = json.loads(done.stdout)["matrix"]
        self.assertLess(abs((matrix[0][0] + matrix[1][1]) / 108.1 - 1), 0.16)    # 2.1 cells thick
        self.assertLess(abs(matrix[2][2] / 1.06 - 1), 0.3)
        self.assertLess(abs(matrix[0][1] / matrix[1][0] - 1), 1e-4)
        self.assertLess(matrix[0][1], -20)

    def test_cylinder_from_rest_has_the_drag_of_its_layer(self):
        done = gapflow("run", EXAMPLES / "25_cylinder_from_rest" / "scene.toml", "-o", self.out, "--quiet", "--set", "domain.spacing=0.1", "--set", "time.end=0.3",
                       "--set", "output.every=0.3")
        self.assertEqual(done.returncode, 0, done.stderr)
        late = [row for row in rows(self.out / "bodies.csv")[:-1] if float(row["time"]) > 0.15]
        for row in late:
            law = 4 * (2 * math.pi / (550 * float(row["time"])))**0.5
            self.assertTrue(0.8 * law < float(row["fx"]) < 1.6 * law, (row["time"], row["fx"], law))
            self.assertLess(abs(float(row["fy"])), 1e-3 * float(row["fx"]))


if __name__ == "__main__":
    unittest.main()
