"""What a run measures, how it ends, and whose folder it takes: probes, fluxes, forces, until_steady, leaving, fields, --force.

Usage: measure_test.py GAPFLOW MPIEXEC
"""
import json
import math
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from harness import GAPFLOW, gapflow, rows

MPIEXEC = sys.argv.pop(1)

CHANNEL = """
[domain]
size = [2.0, 1.0]
cells = [32, 16]
[domain.sides]
x_low = { inflow = [0.3, 0.0] }
x_high = "open"
[fluid]
viscosity = 0.05
[[body]]
name = "ball"
shape = "ball"
radius = 0.2
position = [0.7, 0.52]
motion = "fixed"
[[probe]]
name = "tap"
point = [0.5, 0.52]
fields = ["pressure"]
[[probe]]
name = "wake"
line = { from = [0.7, 0.52], to = [2.0, 0.52], count = 4 }
fields = ["velocity", "vorticity"]
every = 0.1
[[probe]]
name = "plane"
plane = { origin = [1.5, 0.1], u = [0.4, 0.0], v = [0.0, 0.8], counts = [2, 3] }
every = 10.0
[[flux]]
name = "in"
side = "x_low"
[[flux]]
name = "out"
side = "x_high"
every = 0.1
[[flux]]
name = "half"
plane = { point = [0.7, 0.5], normal = "x", low = [0.0, 0.5], high = [2.0, 1.0] }
[time]
end = 0.4
max_step = 0.02
[output]
every = 0.2
"""

RISING = """
gravity = [0.0, -1.0]
[domain]
size = [1.0, 1.0]
cells = [32, 32]
[domain.sides]
y_high = "open"
[[body]]
name = "cork"
shape = "ball"
radius = 0.12
position = [0.53, 0.8]
velocity = [0.0, 1.0]
density = 0.5
[[body]]
name = "stone"
shape = "ball"
radius = 0.1
position = [0.3, 0.3]
density = 1.5
[time]
end = 0.6
max_step = 0.01
"""


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.scene, self.out = self.folder / "scene.toml", self.folder / "out"

    def run_scene(self, text, *words, status=0, out=None, name="scene.toml"):
        (self.folder / name).write_text(text)
        done = gapflow("run", self.folder / name, "-o", out or self.out, *words)
        self.assertEqual(done.returncode, status, done.stderr)
        return done.stderr

    def record(self, out=None):
        return json.loads(((out or self.out) / "run.json").read_text())


class Measured(Case):
    def test_tables_of_probes_and_fluxes(self):
        self.run_scene(CHANNEL)
        steps, probes, fluxes = (rows(self.out / f"{name}.csv") for name in ("steps", "probes", "fluxes"))
        self.assertEqual(list(probes[0]), ["step", "time", "name", "point", "x", "y", "kind", "pressure", "u", "v", "vorticity"])
        self.assertEqual(list(fluxes[0]), ["step", "time", "name", "flux", "inflow", "outflow", "film", "bodies"])
        of = lambda table, name: [row for row in table if row["name"] == name]
        self.assertEqual([row["step"] for row in of(probes, "tap")], [row["step"] for row in steps])
        self.assertTrue(all(row["u"] == "nan" and float(row["pressure"]) > 0 for row in of(probes, "tap")[1:]))
        wake = of(probes, "wake")
        times = sorted({float(row["time"]) for row in wake})
        self.assertEqual(len(times), 5)  # 0, 0.1 ... 0.4
        self.assertTrue(all(math.isclose(a, b, abs_tol=0.021) and a >= b - 1e-9 for a, b in zip(times, (0, 0.1, 0.2, 0.3, 0.4))))
        self.assertEqual([row["kind"] for row in wake[:4]], ["0", "1", "1", "1"])  # the first point is the ball's centre
        self.assertTrue(all(row["u"] == "nan" for row in wake if row["point"] == "1"))
        self.assertTrue(all(row["pressure"] == "nan" for row in wake))
        plane = of(probes, "plane")
        self.assertEqual([(row["x"], row["y"]) for row in plane], [("1.5", "0.1"), ("1.9", "0.1"), ("1.5", "0.5"), ("1.9", "0.5"),
                                                                   ("1.5", "0.9"), ("1.9", "0.9")])
        for row in of(fluxes, "in"):
            self.assertAlmostEqual(float(row["flux"]), -0.3, delta=1e-9)
        self.assertEqual(len(of(fluxes, "out")), 5)
        self.assertAlmostEqual(float(of(fluxes, "out")[-1]["flux"]), 0.3, delta=1e-6)
        self.assertLess(abs(float(of(fluxes, "half")[-1]["flux"]) - 0.15), 0.03)
        self.assertIn("probes.csv, fluxes.csv", self.run_scene(CHANNEL))

    def test_parts_of_forces_add_up(self):
        self.run_scene(CHANNEL, "--set", "output.forces=true", "--set", "gravity=[0,-2]")
        for force, body in zip(rows(self.out / "forces.csv"), rows(self.out / "bodies.csv"), strict=True):
            for axis in ("fx", "fy", "torque"):
                parts = [float(force[f"{part}_{axis}"]) for part in ("pressure", "shear", "film", "buoyancy")]
                self.assertAlmostEqual(sum(parts), float(body[axis]), delta=1e-12 * sum(map(abs, parts)))
            self.assertAlmostEqual(float(force["buoyancy_fy"]), 2 * math.pi * 0.04, delta=1e-12)

    def test_a_run_that_goes_on_has_the_same_tables(self):
        words = ["--set", "output.forces=true", "--quiet"]
        self.run_scene(CHANNEL, *words)
        half = self.folder / "half"
        self.run_scene(CHANNEL, *words, "--set", "time.end=0.2", out=half)
        self.run_scene(CHANNEL, *words, "--resume", half / "checkpoint.h5", out=half)
        for name in ("probes.csv", "fluxes.csv", "forces.csv"):
            self.assertEqual((self.out / name).read_text(), (half / name).read_text(), name)

    def test_on_two_ranks_to_solver_tolerance(self):
        self.run_scene(CHANNEL, "--quiet")
        two = self.folder / "two"
        done = gapflow("run", self.scene, "-o", two, "--quiet", launcher=[MPIEXEC, "-n", "2"])
        self.assertEqual(done.returncode, 0, done.stderr)
        for name in ("probes.csv", "fluxes.csv"):
            for one, other in zip(rows(self.out / name), rows(two / name), strict=True):
                for key, value in one.items():
                    if key not in ("name", "inflow", "outflow", "film", "bodies") and value != "nan":
                        self.assertAlmostEqual(float(value), float(other[key]), delta=1e-5, msg=(name, key))

    def test_fields_in_every_form(self):
        sizes = []
        for words in ([], ["--set", "output.format=appended"], ["--set", "output.format=appended", "--set", "output.precision=single"]):
            self.run_scene(CHANNEL, "--set", 'output.fields=["velocity","pressure","vorticity","divergence"]', *words, "--quiet")
            content = (self.out / "fields" / "fields_00001.vti").read_bytes()
            for name in (b"vorticity", b"divergence"):
                self.assertIn(b'Name="' + name + b'"', content)
            sizes.append(len(content))
            done = gapflow("report", self.out)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("3 of 3 output times", done.stdout)
        self.assertLess(sizes[1], 0.8 * sizes[0])
        self.assertLess(sizes[2], 0.6 * sizes[1])
        self.assertIn("no q", gapflow("run", self.scene, "-o", self.out, "--set", 'output.fields=["q"]').stderr)


class Ends(Case):
    def test_until_steady(self):
        said = self.run_scene(CHANNEL, "--set", "time.end=50", "--set", "time.until_steady=1e-3")
        steps = rows(self.out / "steps.csv")
        self.assertEqual(list(steps[0])[-1], "unsteadiness")
        calm = next(i for i, row in enumerate(reversed(steps)) if not float(row["unsteadiness"]) < 1e-3)  # at the end, in a row
        times = [float(row["time"]) for row in steps]
        self.assertGreaterEqual(calm, 10)
        self.assertTrue(calm == 10 or times[-2] - times[-calm - 1] < 0.05 * times[-2] <= times[-1] - times[-calm - 1])
        self.assertGreater(float(steps[-1]["unsteadiness"]), 0)
        self.assertLess(times[-1], 20)
        self.assertIn("the flow is steady", said)
        self.assertRegex(said, r"unsteadiness [0-9.e-]+")
        record = self.record()
        self.assertEqual((record["status"], record["ended_by"]), ("done", "time.until_steady"))
        self.assertEqual(record["time"], float(steps[-1]["time"]))
        self.assertTrue((self.out / "checkpoint.h5").exists())
        # It goes on where it ended, and ends again.
        self.run_scene(CHANNEL, "--set", "time.end=50", "--set", "time.until_steady=1e-5", "--resume", self.out / "checkpoint.h5")
        self.assertGreater(len(rows(self.out / "steps.csv")), len(steps))
        self.run_scene(CHANNEL)
        self.assertEqual(list(rows(self.out / "steps.csv")[0])[-1], "seconds")
        self.assertEqual(self.record()["ended_by"], "time.end")

    def test_a_table_without_the_column_goes_on_without(self):
        self.run_scene(CHANNEL, "--set", "time.end=0.1")
        self.run_scene(CHANNEL, "--set", "time.until_steady=0.5", "--resume", self.out / "checkpoint.h5")
        self.assertEqual(list(rows(self.out / "steps.csv")[0])[-1], "seconds")

    def test_a_body_that_leaves(self):
        bodies = lambda: [row["body"] for row in rows(self.out / "bodies.csv")]
        said = self.run_scene(RISING)
        self.assertIn("'cork' is on its way out of the domain through the side y_high", said)
        self.assertIn('write domain.sides.y_high = "surface"', said)
        self.assertEqual(bodies().count("cork"), bodies().count("stone"))

        said = self.run_scene(RISING, "--set", "domain.leaving=stop")
        self.assertIn("ended because a body is on its way out", said)
        self.assertEqual((self.record()["status"], self.record()["ended_by"]), ("done", "domain.leaving"))
        self.assertLess(self.record()["time"], 0.3)
        self.assertTrue((self.out / "checkpoint.h5").exists())
        # To go on is possible.
        self.run_scene(RISING, "--set", "domain.leaving=stop", "--resume", self.out / "checkpoint.h5")
        self.assertEqual(self.record()["ended_by"], "time.end")

        said = self.run_scene(RISING, "--set", "domain.leaving=remove", "--set", "output.forces=true")
        out_at = float(re.search(r"body 'cork' has left the domain at time ([0-9.]+) and is taken out", said)[1])
        last = [float(row["time"]) for row in rows(self.out / "bodies.csv") if row["body"] == "cork"][-1]
        self.assertLess(last, out_at + 1e-6)
        self.assertGreater(last, out_at - 0.02)
        self.assertEqual(float([row["time"] for row in rows(self.out / "bodies.csv") if row["body"] == "stone"][-1]), 0.6)
        self.assertNotIn("cork_00001.vtp", os.listdir(self.out / "bodies"))
        self.assertIn("is taken out", " ".join(self.record()["warnings"]))
        self.assertEqual(gapflow("report", self.out).returncode, 0)

    def test_a_body_that_floats(self):
        """It comes up through the surface and stays half out, which is no way out of the domain."""
        floating = RISING.replace('y_high = "open"', 'y_high = "surface"').replace("velocity = [0.0, 1.0]\n", "")
        said = self.run_scene(floating, "--set", "time.end=3", "--set", "time.max_step=0.05", "--set", "fluid.viscosity=0.02",
                              "--set", "output.forces=true", "--set", "domain.leaving=remove")
        self.assertNotIn("way out", said)
        self.assertNotIn("has left", said)
        self.assertAlmostEqual(float([row["y"] for row in rows(self.out / "bodies.csv") if row["body"] == "cork"][-1]), 1.0, delta=0.06)
        buoyancy = [float(row["buoyancy_fy"]) for row in rows(self.out / "forces.csv") if row["body"] == "cork"]
        self.assertAlmostEqual(buoyancy[0] / (math.pi * 0.12 ** 2), 1, delta=1e-6)
        self.assertAlmostEqual(buoyancy[-1] / (math.pi * 0.12 ** 2), 0.5, delta=0.3)
        self.assertEqual(json.loads(self.record()["scene"])["domain"]["sides"]["y_high"], "surface")


class Folders(Case):
    def test_another_scenes_run_is_refused_without_force(self):
        self.run_scene(CHANNEL, "--set", "time.end=0.1", "--quiet")
        (self.out / "notes.txt").write_text("mine")
        before = (self.out / "bodies.csv").read_bytes()
        said = self.run_scene(RISING, status=2, name="other.toml")
        self.assertIn("holds another run, of " + str(self.scene.resolve()), said)
        self.assertIn("--force", said)
        self.assertEqual((self.out / "bodies.csv").read_bytes(), before)
        self.run_scene(RISING, "--force", "--quiet", "--set", "time.end=0.05", name="other.toml")
        self.assertFalse((self.out / "probes.csv").exists())
        self.assertFalse((self.out / "bodies" / "ball_00000.vtp").exists())
        self.assertEqual((self.out / "notes.txt").read_text(), "mine")
        self.assertEqual({row["body"] for row in rows(self.out / "bodies.csv")}, {"cork", "stone"})

    def test_the_same_scene_is_run_anew(self):
        self.run_scene(CHANNEL, "--quiet")
        self.assertTrue((self.out / "fields" / "fields_00002.vti").exists())
        self.run_scene(CHANNEL.replace("0.3, 0.0", "0.2, 0.0"), "--set", "time.end=0.1", "--quiet")  # edited
        self.assertFalse((self.out / "fields" / "fields_00002.vti").exists())

    def test_a_killed_run_is_told_from_one_that_runs(self):
        self.scene.write_text(CHANNEL)
        words = [GAPFLOW, "run", str(self.scene), "-o", str(self.out), "--quiet", "--set", "time.max_step=1e-4", "--set", "time.end=100"]
        process = subprocess.Popen(words)
        try:
            deadline = time.time() + 60
            while time.time() < deadline and not (self.out / "run.json").exists():
                time.sleep(0.01)
            record = self.record()
            self.assertEqual((record["status"], record["process"]["id"]), ("running", process.pid))
            for more in ([], ["--force"]):
                self.assertIn(f"process {process.pid} writes a run there", self.run_scene(CHANNEL, *more, status=2))
            self.assertNotIn("was killed", gapflow("report", self.out).stderr)
            self.assertIn('"status":"running"', (self.out / "report.html").read_text())
        finally:
            process.send_signal(signal.SIGKILL)
        time.sleep(0.2)  # not waited for: a zombie counts as gone
        report = gapflow("report", self.out)
        self.assertEqual(report.returncode, 0, report.stderr)
        self.assertIn("the run was killed", report.stderr)
        self.assertIn('"status":"killed"', (self.out / "report.html").read_text())
        process.wait()
        self.run_scene(CHANNEL, "--quiet", "--set", "time.end=0.1")
        self.assertNotIn("process", self.record())


if __name__ == "__main__":
    unittest.main()
