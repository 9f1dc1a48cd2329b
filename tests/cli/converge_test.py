"""gapflow converge as a user types it. Usage: converge_test.py GAPFLOW EXAMPLES"""
import json
import math
import sys
import tempfile
import unittest
from pathlib import Path

from harness import gapflow, rows

EXAMPLES = Path(sys.argv.pop(1))
PLATES = EXAMPLES / "01_plates_pulled_apart" / "scene.toml"
# A ball on a damped spring in next to no fluid: its motion is known.
SPRING = """
[domain]
size = [2, 1]
cells = [16, 8]
[fluid]
density = 1e-9
[[body]]
name = "ball"
shape = "ball"
radius = 0.2
position = [1.1, 0.5]
mass = 2
inertia = 1
free = ["x"]
spring = { anchor = [1.0, 0.5], stiffness = 50, damping = 2 }
[time]
end = 0.8
max_step = 0.05
"""


class Converge(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.out = self.folder / "out"
        self.scene = self.folder / "spring.toml"
        self.scene.write_text(SPRING)

    def converge(self, *words):
        return gapflow("converge", self.scene, "-o", self.out, "--quiet", *words)

    def exact(self, steps=4000):
        """time, place and speed of the ball"""
        rate, w = 2 / (2 * 2), math.sqrt(50 / 2 - 0.25)
        for i in range(steps + 1):
            t = 0.8 * i / steps
            decay = 0.1 * math.exp(-rate * t)
            yield (t, 1 + decay * (math.cos(w * t) + rate / w * math.sin(w * t)),
                   -decay * (w + rate * rate / w) * math.sin(w * t))

    def reference(self):
        file = self.folder / "exact.csv"
        file.write_text("t,place,ball.vx\n" + "".join(f"{t},{x},{v}\n" for t, x, v in self.exact()))
        return file

    def test_sprung_ball_against_the_exact_motion(self):
        done = self.converge("--cells", "16,32,64", "--reference", self.reference(), "--column", "ball.x=place", "--column",
                             "ball.vx=ball.vx")
        self.assertEqual(done.returncode, 0, done.stderr)
        table = rows(self.out / "converge.csv")
        self.assertEqual([(row["quantity"], row["cells"]) for row in table],
                         [(q, n) for q in ("ball.x", "ball.vx") for n in ("16", "32", "64")])
        record = json.loads((self.out / "converge.json").read_text())["convergence"]
        self.assertAlmostEqual(record[0]["window"][1], 0.8)
        speed = [float(row["error_l2"]) for row in table[3:]]
        self.assertLess(speed[-1], 0.01)
        self.assertGreater(record[1]["slope_l2"], 1.7)  # second order in time
        self.assertIn("slope", done.stdout)
        for n, factor in ((16, 1), (32, 2), (64, 4)):
            scene = json.loads(json.loads((self.out / f"cells_{n}" / "run.json").read_text())["scene"])
            self.assertEqual(scene["domain"]["cells"], [n, n // 2])
            self.assertAlmostEqual(scene["time"]["max_step"], 0.05 / factor, places=14)
            self.assertAlmostEqual(scene["time"]["gap_cfl"], 0.25 / factor, places=14)

    def test_limit_of_a_monotone_sequence_and_reason_where_there_is_none(self):
        done = self.converge("--cells", "16,32,64", "--quantity", "ball.x", "--quantity", "ball.vx")
        self.assertEqual(done.returncode, 0, done.stderr)
        table = rows(self.out / "converge_limits.csv")
        self.assertIn("finest off", done.stdout)
        at_end = [row for row in table if (row["quantity"], row["of"]) == ("ball.x", "end")]
        self.assertEqual(len(at_end), 1)
        exact = list(self.exact())[-1][1]
        values = [float(at_end[0][f"cells_{n}"]) for n in (16, 32, 64)]
        self.assertGreater((values[0] - values[1]) * (values[1] - values[2]), 0, values)
        self.assertLess(abs(float(at_end[0]["limit"]) - exact), 0.5 * abs(values[2] - exact), (table, exact))
        for row in table:
            self.assertEqual(row["limit"] == "", row["reason"] != "", row)
        self.assertEqual(self.converge("--cells", "16,32", "--quantity", "ball.x").returncode, 0)
        self.assertEqual({row["reason"] for row in rows(self.out / "converge_limits.csv")}, {"takes three grids"})

    def test_errors_in_the_table_are_those_of_the_runs(self):
        self.assertEqual(self.converge("--cells", "16,32", "--quantity", "ball.vx", "--reference", self.reference(),
                                       "--window", "0.1,0.6").returncode, 0)
        exact = list(self.exact())
        speeds = [v for t, x, v in exact if 0.1 <= t <= 0.6]
        for row in rows(self.out / "converge.csv"):
            run = rows(self.out / f"cells_{row['cells']}" / "bodies.csv")
            errors = [abs(float(r["vx"]) - exact[round(float(r["time"]) / 0.8 * 4000)][2]) for r in run
                      if 0.1 <= float(r["time"]) <= 0.6]
            # exact at the nearest of 4000 times: a speed changes by 0.0005 in between
            self.assertAlmostEqual(float(row["error_max"]), max(errors) / (max(speeds) - min(speeds)), delta=1e-3)
            self.assertEqual(int(row["steps"]), len(run) - 1)

    def test_default_is_the_motion_of_free_bodies_against_the_finest_run(self):
        done = gapflow("converge", PLATES, "--cells", "32,48,64", "-o", self.out, "--set", "time.end=0.1", "--set",
                       "output.every=0")
        self.assertEqual(done.returncode, 0, done.stderr)
        table = rows(self.out / "converge.csv")
        quantities = {row["quantity"] for row in table}
        self.assertLessEqual({"upper.y", "upper.vy", "lower.y", "lower.vy"}, quantities)
        self.assertEqual({row["cells"] for row in table}, {"32", "48"})
        self.assertIn("run 3 of 3: 64 cells", done.stderr)
        self.assertIn("the run with 64 cells", done.stdout)

    def test_gaps_can_be_compared(self):
        done = gapflow("converge", PLATES, "--cells", "32,64", "-o", self.out, "--quiet", "--set", "time.end=0.05", "--set",
                       "output.every=0", "--quantity", "upper-lower.thickness")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([row["cells"] for row in rows(self.out / "converge.csv")], ["32"])

    def test_bad_use_is_status_2_and_runs_nothing(self):
        reference = self.reference()
        cases = [
            (["--cells", "16"], "two different grids"),
            (["--cells", "16,16"], "two different grids"),
            (["--cells", "16,many"], "'many' is not a number of cells"),
            (["--cells", "16,33"], "33 cells along x make no whole number of cells along y"),
            (["--cells", "2,16"], "time.gap_cfl = 2: out of range"),
            ([], "--cells is required"),
            (["--cells", "16,32", "--quantity", "bal.x"], "did you mean 'ball.x'?"),
            (["--cells", "16,32", "--quantity", "ball.w"], "choose from x, y, angle"),
            (["--cells", "16,32", "--quantity", "ball"], "write BODY.COLUMN"),
            (["--cells", "16,32", "--window", "0,2"], "FROM < TO <= time.end = 0.8"),
            (["--cells", "16,32", "--column", "ball.x=place"], "add --reference FILE.csv"),
            (["--cells", "16,32", "--reference", "nowhere.csv"], "nowhere.csv: cannot be read"),
            (["--cells", "16,32", "--reference", reference, "--quantity", "ball.y"], "--column ball.y=NAME"),
            (["--cells", "16,32", "--reference", reference, "--column", "ball.x=plac"], "did you mean 'place'?"),
            (["--cells", "16,32", "--reference", reference, "--column", "ball.x"], "--column upper.vy=speed"),
        ]
        for words, text in cases:
            with self.subTest(words):
                done = self.converge(*words)
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertIn(text, done.stderr)
                self.assertFalse(self.out.exists())

    def test_what_stands_still_has_no_order(self):
        done = self.converge("--cells", "16,32", "--quantity", "ball.y")
        self.assertEqual(done.returncode, 2)
        self.assertIn("nothing to compare", done.stderr)

    def test_help(self):
        done = gapflow("converge", "--help")
        self.assertEqual(done.returncode, 0)
        for word in ("--cells", "--reference", "--quantity", "--column", "--window", "converge.csv"):
            self.assertIn(word, done.stdout)


if __name__ == "__main__":
    unittest.main()
