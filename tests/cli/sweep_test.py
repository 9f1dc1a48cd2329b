"""gapflow sweep as a user types it. Usage: sweep_test.py GAPFLOW"""
import json
import os
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

from harness import GAPFLOW, gapflow, rows

SCENE = """
gravity = [0, -1]
[domain]
size = [2, 2]
cells = [16, 16]
[domain.sides]
y_high = "open"
[[body]]
name = "ball"
shape = "ball"
radius = 0.3
position = [1, 1.2]
density = 2
[[body]]
name = "post"
shape = "box"
size = [0.5, 0.5]
position = [0.5, 0.25]
motion = "fixed"
[time]
end = 0.2
max_step = 0.02
"""


class Sweep(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.out = self.folder / "out"
        self.scene = self.folder / "ball.toml"
        self.scene.write_text(SCENE)

    def words(self, *words):
        return ["sweep", self.scene, "-o", self.out, *words]

    def sweep(self, *words, **options):
        return gapflow(*self.words(*words), **options)

    def table(self):
        return rows(self.out / "sweep.csv")

    def scene_of(self, folder):
        return json.loads(json.loads((self.out / folder / "run.json").read_text())["scene"])

    def test_fluxes_are_quantities(self):
        self.scene.write_text(SCENE + '[[flux]]\nname = "top"\nside = "y_high"\n')
        done = self.sweep("--vary", "body.ball.density=2,4", "--set", "time.end=0.06", "--jobs", "1")
        self.assertEqual(done.returncode, 0, done.stderr)
        for row in self.table():
            last = rows(self.out / row["folder"] / "fluxes.csv")[-1]
            self.assertEqual(float(row["top.flux.last"]), float(last["flux"]))
        done = self.sweep("--vary", "body.ball.density=2,4", "--set", "time.end=0.06", "--jobs", "1", "--quantity", "top.inflow")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("top.inflow.last", self.table()[0])
        for name, text in [("top.fluxx", "did you mean 'flux'"), ("tup.flux", "did you mean 'top.flux'?")]:
            done = self.sweep("--vary", "body.ball.density=2", "--quantity", name)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(text, done.stderr)

    def test_every_combination_in_folders_and_one_table(self):
        done = self.sweep("--vary", "body.ball.density=1:4:3:log", "--vary", "gap.model=film,none", "--quantity", "ball.y", "--jobs", "2")
        self.assertEqual(done.returncode, 0, done.stderr)
        table = self.table()
        self.assertEqual([(r["run"], r["folder"], r["body.ball.density"], r["gap.model"], r["status"]) for r in table],
                         [(str(i + 1), f"run_{i + 1:03}", d, m, "done")
                          for i, (d, m) in enumerate((d, m) for d in ("1", "2", "4") for m in ("film", "none"))])
        self.assertEqual(self.scene_of("run_004")["body"][0]["density"], 2)
        self.assertEqual(self.scene_of("run_004")["gap"]["model"], "none")
        for row in table:
            run = rows(self.out / row["folder"] / "bodies.csv")
            y = [float(r["y"]) for r in run if r["body"] == "ball"]
            times = [float(r["time"]) for r in run if r["body"] == "ball"]
            self.assertAlmostEqual(float(row["ball.y.last"]), y[-1], places=12)
            self.assertAlmostEqual(float(row["ball.y.min"]), min(y), places=12)
            self.assertAlmostEqual(float(row["ball.y.max"]), max(y), places=12)
            mean = sum(v * (b - a) for v, a, b in zip(y[1:], times, times[1:])) / times[-1]
            self.assertAlmostEqual(float(row["ball.y.mean"]), mean, places=10)
            self.assertEqual(int(row["steps"]), len(y) - 1)
            self.assertAlmostEqual(float(row["time"]), 0.2)
            self.assertGreater(float(row["seconds"]), 0)
        # heavier balls fall faster
        self.assertGreater(float(table[0]["ball.y.last"]), float(table[2]["ball.y.last"]))
        self.assertGreater(float(table[2]["ball.y.last"]), float(table[4]["ball.y.last"]))
        self.assertIn("run_006 done (body.ball.density = 4, gap.model = none)", done.stderr)
        self.assertIn("ball.y last", done.stdout)
        same = gapflow("run", self.scene, "-o", self.folder / "alone", "--quiet", "--set", "body.ball.density=2")
        self.assertEqual(same.returncode, 0)
        self.assertEqual((self.folder / "alone" / "bodies.csv").read_text(), (self.out / "run_003" / "bodies.csv").read_text())

    def test_pairs_vectors_and_the_default_table(self):
        done = self.sweep("--vary", "body.ball.position=[1,1.2]:[1,1.4]:3", "--vary", "domain.cells=[16,16],[24,24],[32,32]", "--zip")
        self.assertEqual(done.returncode, 0, done.stderr)
        table = self.table()
        self.assertEqual([r["body.ball.position"] for r in table], ["[1,1.2]", "[1,1.3]", "[1,1.4]"])
        self.assertEqual(self.scene_of("run_002")["domain"]["cells"], [24, 24])
        self.assertEqual(self.scene_of("run_002")["body"][0]["position"], [1, 1.3])
        for column in ("ball.y.last", "ball.vy.min", "ball.fy.mean", "post.fx.max"):
            self.assertNotEqual(table[0][column], "")
        self.assertNotIn("post.y.last", table[0])

    def test_done_runs_are_kept_and_a_longer_list_goes_on(self):
        self.assertEqual(self.sweep("--vary", "body.ball.density=2,3").returncode, 0)
        stamp = (self.out / "run_001" / "run.json").stat().st_mtime_ns
        before = self.table()
        again = self.sweep("--vary", "body.ball.density=2,3,4")
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertIn("2 of them done before", again.stderr)
        self.assertEqual((self.out / "run_001" / "run.json").stat().st_mtime_ns, stamp)
        self.assertEqual(len(self.table()), 3)
        self.assertEqual({k: v for k, v in self.table()[0].items() if k in before[0]}, before[0])
        other = self.sweep("--vary", "body.ball.density=2,5")
        self.assertEqual(other.returncode, 2)
        self.assertIn("run_002: holds a run of another scene (body.ball.density: was 3.0, is 5.0)", other.stderr)

    def test_interrupted_sweep_ends_cleanly_and_goes_on_with_the_same_bits(self):
        words = ["--vary", "body.ball.density=2,3,4", "--set", "time.end=0.6", "--set", "time.max_step=2e-3", "--set",
                 "domain.cells=[48,48]", "--jobs", "1"]
        process = subprocess.Popen([GAPFLOW, *map(str, self.words(*words))], stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        table = self.out / "run_002" / "steps.csv"
        for _ in range(3000):
            if table.exists() and table.read_text().count("\n") > 5:
                break
            time.sleep(0.02)
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=100)
        self.assertEqual(process.returncode, 130, errors)
        self.assertIn("the same command goes on", errors)
        self.assertEqual([row["status"] for row in self.table()], ["done", "interrupted", "waiting"])
        self.assertEqual(json.loads((self.out / "run_002" / "run.json").read_text())["status"], "interrupted")
        again = self.sweep(*words)
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertIn("1 of them done before, 1 go on from checkpoints", again.stderr)
        self.assertEqual([row["status"] for row in self.table()], ["done"] * 3)
        straight = gapflow("run", self.scene, "-o", self.folder / "straight", "--quiet", "--set", "body.ball.density=3", *words[2:-2])
        self.assertEqual(straight.returncode, 0, straight.stderr)
        self.assertEqual((self.folder / "straight" / "bodies.csv").read_text(), (self.out / "run_002" / "bodies.csv").read_text())

    def test_failures_are_told_by_folder_and_others_are_done(self):
        # a prescribed box that squeezes sealed fluid fails while it runs
        self.scene.write_text(SCENE.replace('y_high = "open"', 'y_high = "wall"') + """
[[body]]
name = "piston"
shape = "box"
size = [2, 0.3]
position = [1, 1.85]
motion = "prescribed"
""")
        done = self.sweep("--vary", "body.piston.velocity=[0,0],[0,-1]")
        self.assertEqual(done.returncode, 1, done.stderr)
        table = self.table()
        self.assertEqual([row["status"] for row in table], ["done", "failed"])
        self.assertNotEqual(table[1]["message"], "")
        self.assertIn(f"{self.out}/run_002 failed: {table[1]['message']}", done.stderr)
        self.assertIn(table[1]["message"], (self.out / "run_002.log").read_text())

    def test_bad_use_is_status_2_and_runs_nothing(self):
        vary = lambda text: ["--vary", text]
        for words, text in [
            ([], "--vary is required"),
            (vary("body.ball.density"), "not key=VALUES"),
            (vary("body.ball.densty=1,2"), "did you mean"),
            (vary("body.bal.density=1,2"), "did you mean 'ball'?"),
            (vary("body.ball.density=1:2"), "not FROM:TO:COUNT"),
            (vary("body.ball.density=1:2:1"), "COUNT = 1 is out of range"),
            (vary("body.ball.density=0:2:3:log"), "same sign"),
            (vary("body.ball.density=1,,2"), "a value of the list is empty"),
            (vary("body.ball.density=1,2,1"), "the value 1 is there twice"),
            (vary("body.ball.density=1,-2"), "out of range"),
            (vary("body.ball.density=1,2") + vary("body.ball.density=3,4"), "is there twice"),
            (vary("body.ball.density=1,2") + vary("gap.model=film") + ["--zip"], "gap.model has 1 values, body.ball.density has 2"),
            (vary("body.ball.density=1,2") + ["--quantity", "ball.w"], "choose from x, y, angle"),
            (vary("body.ball.density=1,2") + ["--window", "0,3"], "FROM < TO <= time.end = 0.2"),
            (vary("body.ball.density=1,2") + ["--jobs", "0"], "--jobs"),
        ]:
            with self.subTest(words):
                done = self.sweep(*words)
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertIn(text, done.stderr)
                self.assertFalse(self.out.exists())
        self.out.mkdir()
        done = self.sweep("--vary", "body.ball.density=1,2", env={**os.environ, "OMPI_COMM_WORLD_SIZE": "1"})
        self.assertEqual(done.returncode, 2)
        self.assertIn("call it without mpirun", done.stderr)


if __name__ == "__main__":
    unittest.main()
