"""Motion and inflow from tables: forces are smooth, columns are what their names say. Usage: table_test.py GAPFLOW"""
import math
import tempfile
import unittest
from pathlib import Path

from harness import gapflow, rows

OSCILLATION = """
[domain]
size = [4, 4]
cells = [32, 32]
[domain.sides]
x_low = "open"
x_high = "open"
[[body]]
name = "disk"
shape = "ball"
radius = 0.5
motion = "prescribed"
motion_file = "table.csv"
[time]
end = 0.6
max_step = 0.005
"""

CHANNEL = """
[domain]
size = [4, 2]
cells = [32, 16]
[domain.sides]
x_low = { inflow = "inflow.csv" }
x_high = "open"
[[flux]]
name = "out"
side = "x_high"
[[body]]
name = "plate"
shape = "box"
size = [0.8, 0.5]
position = [3, 1]
rotation = 30
motion = "prescribed"
file = "table.csv"
[time]
end = 0.02
max_step = 0.01
"""


class Tables(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_scene(self, text, *sets):
        (self.folder / "scene.toml").write_text(text)
        done = gapflow("run", "scene.toml", "-o", "out", "--quiet", "--force", *(word for value in sets for word in ("--set", value)), cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stderr

    def force(self, count, *sets):
        lines = (f"{k / count},{2 + 0.3 * math.sin(2 * math.pi * k / count):.12f},2,0\n" for k in range(count + 1))
        (self.folder / "table.csv").write_text("time,x,y,angle\n" + "".join(lines))
        told = self.run_scene(OSCILLATION, *sets)
        return [float(row["fx"]) for row in rows(self.folder / "out" / "bodies.csv")][10:], told

    def test_the_force_on_an_oscillating_body_does_not_depend_on_the_number_of_rows(self):
        (fine, _), (coarse, told), (linear, warned) = self.force(1000), self.force(50), self.force(50, "body.disk.interpolation=linear")
        deviation = lambda other: max(abs(a - b) for a, b in zip(fine, other)) / max(map(abs, fine))
        self.assertLess(deviation(coarse), 0.002)
        self.assertEqual(told, "")
        self.assertGreater(deviation(linear), 1)
        self.assertIn("body.disk.interpolation: the velocity jumps at every row of table.csv", warned)

    def test_columns_are_what_their_names_say(self):
        (self.folder / "inflow.csv").write_text("v,u,time\n0,1,0\n0,1,1\n")
        (self.folder / "table.csv").write_text("time,x,y,angle_deg\n0,2,1,0\n1,2,1,90\n")
        told = self.run_scene(CHANNEL)
        for key in ("position", "rotation"):
            self.assertRegex(told, rf"scene.toml:\d+:\d+: body.plate.{key} is ignored: the body moves as in table.csv")
        self.assertAlmostEqual(float(rows(self.folder / "out" / "fluxes.csv")[-1]["flux"]), 2, places=6)
        self.assertAlmostEqual(float(rows(self.folder / "out" / "bodies.csv")[-1]["angle"]), 0.02 * math.pi / 2, places=12)


if __name__ == "__main__":
    unittest.main()
