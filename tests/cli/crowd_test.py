"""Scenes with crowds: the tables of a run, the binary one too, a run that is resumed, and wrong input. Usage: crowd_test.py GAPFLOW"""
import json
import math
import tempfile
import unittest
from pathlib import Path

import numpy

from harness import gapflow, rows

SCENE = """
gravity = [0.0, -1.0]
[domain]
size = [1.0, 1.0]
cells = [32, 32]
[domain.sides]
x_low = "periodic"
x_high = "periodic"
y_low = "periodic"
y_high = "periodic"
[fluid]
viscosity = 0.02
[[crowd]]
name = "grain"
shape = "ball"
radius = 0.06
density = 2.0
number = 12
[[crowd]]
name = "stone"
shape = "ball"
radius = 0.08
density = 3.0
number = 2
[[body]]
name = "post"
shape = "ball"
radius = 0.1
position = [0.5, 0.5]
motion = "fixed"
[time]
end = 0.04
max_step = 0.01
[output]
every = 0.02
bodies = "both"
"""


class Crowds(unittest.TestCase):
    def setUp(self):
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.scene = self.folder / "scene.toml"
        self.scene.write_text(SCENE)

    def run_scene(self, name, *words):
        done = gapflow("run", self.scene, "-o", self.folder / name, "--quiet", *words)
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.folder / name

    def test_tables_agree(self):
        out = self.run_scene("out")
        csv = rows(out / "bodies.csv")
        binary = numpy.load(out / "bodies.npy")
        self.assertEqual(len(binary), len(csv))
        for row, record in zip(csv, binary):
            for name in binary.dtype.names:
                self.assertEqual(str(record[name]) if name == "body" else float(record[name]), row[name] if name == "body" else float(row[name]))
        last = csv[-1]["step"]
        grains = [row for row in csv if row["step"] == last and row["body"].startswith("grain_")]
        self.assertEqual(len(grains), 12)
        crowd = [row for row in rows(out / "crowds.csv") if row["step"] == last and row["crowd"] == "grain"]
        self.assertEqual(len(crowd), 1)
        mean = sum(float(row["vy"]) for row in grains) / 12
        self.assertLess(mean, 0)
        self.assertAlmostEqual(float(crowd[0]["vy"]), mean, delta=1e-12)
        self.assertAlmostEqual(float(crowd[0]["vy_rms"]), math.sqrt(sum((float(row["vy"]) - mean)**2 for row in grains) / 12), delta=1e-12)
        profile = [row for row in rows(out / "crowd_profiles.csv") if row["step"] == last and row["crowd"] == "grain"]
        heights = [float(row["height"]) for row in profile]
        share = sum(float(row["volume_fraction"]) for row in profile) / len(profile)
        self.assertEqual(heights, sorted(heights))
        self.assertAlmostEqual(share, 12 * math.pi * 0.06**2, delta=1e-6)
        self.assertIn("mean_velocity_y", rows(out / "steps.csv")[0])
        scene = json.loads(json.loads((out / "run.json").read_text())["scene"])
        self.assertEqual(len(scene["body"]), 15)

    def test_resumed_run_leaves_the_same_tables(self):
        whole = self.run_scene("whole")
        self.run_scene("parts", "--set", "time.end=0.02")
        self.scene.write_text(SCENE)
        done = gapflow("run", self.scene, "-o", self.folder / "parts", "--quiet", "--resume", self.folder / "parts" / "checkpoint.h5")
        self.assertEqual(done.returncode, 0, done.stderr)
        for name in ("bodies.csv", "bodies.npy", "crowds.csv", "crowd_profiles.csv"):
            self.assertEqual((whole / name).read_bytes(), (self.folder / "parts" / name).read_bytes(), name)

    def test_default_table_of_a_large_crowd_is_binary(self):
        self.scene.write_text(SCENE.replace('bodies = "both"\n', "").replace("number = 12", "number = 60").replace("radius = 0.06", "radius = 0.03"))
        out = self.run_scene("large", "--set", "time.end=0.01")
        self.assertFalse((out / "bodies.csv").exists())
        self.assertEqual(len(numpy.unique(numpy.load(out / "bodies.npy")["body"])), 63)
        done = gapflow("report", out, "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_what_does_not_fit_is_refused_with_a_remedy(self):
        self.scene.write_text(SCENE.replace("number = 12", "number = 1200"))
        done = gapflow("check", self.scene)
        self.assertEqual(done.returncode, 2)
        self.assertIn("scene.toml:", done.stderr)
        self.assertIn("crowd.grain", done.stderr)


if __name__ == "__main__":
    unittest.main()
