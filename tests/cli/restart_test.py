"""Checkpoints: a resumed run leaves what one run would have left, bit for bit; whatever ends a run leaves valid files.

Usage: restart_test.py GAPFLOW MPIEXEC. The environment variable GAPFLOW_KILLS is the number of runs that are killed at random
moments (3 if not set); GAPFLOW_SEED chooses them.
"""
import hashlib
import json
import os
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import xml.etree.ElementTree
from pathlib import Path

from harness import GAPFLOW, rows

MPIEXEC = sys.argv.pop(1)
KILLS = int(os.environ.get("GAPFLOW_KILLS", "3"))
SEED = int(os.environ.get("GAPFLOW_SEED", "1"))

# A box rises off the floor over a film and a ball slides over the floor while another is driven along above it.
SCENE = """
title = "crowd"
gravity = {gravity}
[domain]
size = {size}
cells = {cells}
[domain.sides]
x_low = {{ inflow = {inflow} }}
x_high = "open"
{sides}
[contact]
friction = 0.3
[[pair]]
bodies = ["ball", "wall:y_low"]
model = "none"
[[body]]
name = "box"
shape = "box"
size = {box}
position = {box_at}
density = 3.0
force = {lift}
[[body]]
name = "ball"
shape = "ball"
radius = 0.2
position = {ball_at}
velocity = {ball_speed}
density = 3.0
[[body]]
name = "driven"
shape = "ball"
radius = 0.15
position = {driven_at}
motion = "prescribed"
velocity = {driven_speed}
[time]
end = {end}
max_step = {step}
[output]
every = {every}
checkpoint_every = {checkpoint}
"""


def scene(dimension):
    extra = [] if dimension == 2 else [0.52]
    still = [] if dimension == 2 else [0.0]
    n = 24 if dimension == 2 else 10
    return SCENE.format(
        gravity=[0.0, -1.0] + still, size=[3.0, 1.0] + [1.0] * len(extra), cells=[3 * n, n] + [n] * len(extra),
        inflow=[0.05, 0.0] + still, sides="" if dimension == 2 else 'z_low = "periodic"\nz_high = "periodic"',
        box=[0.6, 0.4] + [0.5] * len(extra), box_at=[0.9, 0.2 + 0.6 / n] + extra, ball_at=[1.6, 0.2] + extra,
        lift=[0.002, 0.6] if dimension == 2 else [0.001, 0.3, 0.0], ball_speed=[0.3, 0.0] + still, driven_at=[1.6, 0.75] + extra, driven_speed=[0.1, 0.02] + still,
        end=1.0 if dimension == 2 else 0.75, step=0.01 if dimension == 2 else 0.0075,
        every=0.25 if dimension == 2 else 0.125, checkpoint=0.11)


def without_seconds(table):
    return b"\n".join(line.rpartition(b",")[0] for line in table.splitlines())


def result(folder):
    """What a run leaves but for wall-clock times, by file."""
    files = {}
    for path in sorted(folder.rglob("*")):
        if path.is_dir() or path.name == "report.html":
            continue
        content = path.read_bytes()
        if path.name == "steps.csv":
            content = without_seconds(content)
        elif path.name == "run.json":
            record = json.loads(content)
            del record["timings"], record["peak_memory_bytes"]
            content = json.dumps(record).encode()
        files[str(path.relative_to(folder))] = hashlib.sha256(content).hexdigest()
    return files


class Restart(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        for dimension in (2, 3):
            (self.folder / f"scene{dimension}.toml").write_text(scene(dimension))

    def words(self, place, *more, dimension=2):
        # Run from a folder of their own, so that all runs have the same -o, which is in the files.
        (self.folder / place).mkdir(exist_ok=True)
        return [GAPFLOW, "run", str(self.folder / f"scene{dimension}.toml"), "-o", "out", "--quiet", *more]

    def run_to_end(self, place, *more, dimension=2, status=0, before=(), **options):
        done = subprocess.run([*before, *self.words(place, *more, dimension=dimension)], cwd=self.folder / place,
                              capture_output=True, text=True, timeout=300, **options)
        self.assertEqual(done.returncode, status, done.stderr)
        return done.stderr

    def start(self, place, *more, steps=0, **options):
        process = subprocess.Popen(self.words(place, *more), cwd=self.folder / place, stderr=subprocess.PIPE, text=True, **options)
        table = self.folder / place / "out" / "steps.csv"
        deadline = time.time() + 60
        while time.time() < deadline and steps and not (table.exists() and table.read_bytes().count(b"\n") > steps + 1):
            time.sleep(0.002)
        return process

    def assert_same(self, one, other):
        self.assertEqual(result(self.folder / one / "out"), result(self.folder / other / "out"))

    def assert_readable(self, out):
        """All files but tables' last lines are whole, and the tables go on to the last complete step."""
        for path in out.rglob("*"):
            if path.suffix in (".vti", ".vtp", ".pvd"):
                xml.etree.ElementTree.parse(path)
        if (out / "gapflow.pvd").exists():
            for entry in xml.etree.ElementTree.parse(out / "gapflow.pvd").iter("DataSet"):
                self.assertTrue((out / entry.get("file")).exists(), entry.get("file"))
        if (out / "run.json").exists():
            json.loads((out / "run.json").read_text())
            report = subprocess.run([GAPFLOW, "report", str(out)], capture_output=True, text=True, timeout=300)
            self.assertEqual(report.returncode, 0, report.stderr)
        if (out / "steps.csv").exists():
            steps = [int(row["step"]) for row in rows(out / "steps.csv")]
            self.assertEqual(steps, list(range(len(steps))))

    def test_two_halves_are_the_whole(self):
        for dimension, half in ((2, "0.5"), (3, "0.375")):
            with self.subTest(dimension=dimension):
                whole, part = f"whole{dimension}", f"part{dimension}"
                self.run_to_end(whole, dimension=dimension)
                self.run_to_end(part, "--set", f"time.end={half}", dimension=dimension)
                first = len(rows(self.folder / part / "out" / "steps.csv")) - 1
                self.run_to_end(part, "--resume", "out/checkpoint.h5", dimension=dimension)
                self.assert_same(whole, part)
                total = len(rows(self.folder / whole / "out" / "steps.csv")) - 1
                self.assertGreaterEqual(total, 100)
                self.assertGreater(total - first, total // 3)
                gaps = [row for row in rows(self.folder / whole / "out" / "gaps.csv") if int(row["step"]) > first]
                self.assertTrue(any(int(row["film_nodes"]) > 0 for row in gaps), "films after the checkpoint")
                self.assertTrue(any(float(row["contact_impulse"]) > 0 for row in gaps), "contacts after the checkpoint")

    def test_on_other_ranks_to_solver_tolerance(self):
        self.run_to_end("one")
        shutil.copytree(self.folder / "one", self.folder / "two")
        self.run_to_end("two", "--set", "time.end=0.5")
        self.run_to_end("two", "--resume", "out/checkpoint.h5", before=[MPIEXEC, "-n", "2"])
        self.run_to_end("two", "--resume", "out/checkpoint.h5", "--set", "time.end=1.01")  # and back to one rank
        one, two = rows(self.folder / "one" / "out" / "bodies.csv"), rows(self.folder / "two" / "out" / "bodies.csv")
        last = [row for row in one if row["step"] == one[-1]["step"]]
        again = {row["body"]: row for row in two if row["time"] == one[-1]["time"]}
        for row in last:
            for key in ("x", "y", "angle", "vx", "vy", "omega"):
                self.assertAlmostEqual(float(row[key]), float(again[row["body"]][key]), delta=1e-6, msg=(row["body"], key))

    def test_signals_end_after_the_step_and_the_run_goes_on(self):
        self.run_to_end("whole")
        for number, status in ((signal.SIGTERM, 143), (signal.SIGINT, 130)):
            place = f"stopped{status}"
            process = self.start(place, steps=20)
            process.send_signal(number)
            _, message = process.communicate(timeout=60)
            self.assertEqual(process.returncode, status)
            self.assertIn("--resume out/checkpoint.h5", message)
            out = self.folder / place / "out"
            self.assert_readable(out)
            record = json.loads((out / "run.json").read_text())
            self.assertEqual(record["status"], "interrupted")
            self.assertEqual(record["steps"], int(rows(out / "steps.csv")[-1]["step"]))
            entries = list(xml.etree.ElementTree.parse(out / "gapflow.pvd").iter("DataSet"))
            self.assertEqual(float(entries[-1].get("timestep")), record["time"])
            self.run_to_end(place, "--resume", "out/checkpoint.h5")
            self.assert_same("whole", place)

    def test_second_signal_ends_at_once(self):
        # A step of a large grid takes a while: the first signal waits for it.
        process = self.start("large", "--set", "domain.cells=[768,256]", "--set", "time.max_step=1e-3", steps=1)
        process.send_signal(signal.SIGINT)
        time.sleep(0.05)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=60)
        if process.returncode == 130:
            self.skipTest("the step ended between the signals")
        self.assertEqual(process.returncode, -signal.SIGINT)
        self.assertEqual(json.loads((self.folder / "large" / "out" / "run.json").read_text())["status"], "running")

    def test_killed_at_random_moments(self):
        begin = time.time()
        self.run_to_end("whole")
        duration = time.time() - begin
        chance = random.Random(SEED)
        resumed = 0
        for trial in range(KILLS):
            place, resume = f"killed{trial}", ()
            for _ in range(chance.choice((1, 1, 2))):
                process = self.start(place, *resume)
                time.sleep(chance.uniform(0.1, 1) * duration)
                process.kill()
                process.communicate(timeout=60)
                out = self.folder / place / "out"
                self.assert_readable(out)
                resume = ("--resume", "out/checkpoint.h5") if (out / "checkpoint.h5").exists() else ()
            resumed += bool(resume)
            with self.subTest(trial=trial, resumed=bool(resume)):
                self.run_to_end(place, *resume)
                self.assert_same("whole", place)
            shutil.rmtree(self.folder / place)
        self.assertGreater(resumed, 0)

    def test_half_a_row_is_cut_and_tolerated(self):
        self.run_to_end("whole")
        self.run_to_end("half", "--set", "time.end=0.5")
        out = self.folder / "half" / "out"
        for name in ("bodies.csv", "gaps.csv", "steps.csv"):
            text = (out / name).read_bytes()
            (out / name).write_bytes(text + text.splitlines()[-1][: len(text.splitlines()[-1]) // 2])
        (out / "fields" / "fields_00003.vti.partial").write_text("half a file")
        (out / "fields" / "fields_00007.vti").write_text("of a run before")
        report = subprocess.run([GAPFLOW, "report", str(out)], capture_output=True, text=True, timeout=300)
        self.assertEqual(report.returncode, 0, report.stderr)
        self.run_to_end("half", "--resume", "out/checkpoint.h5")
        self.assert_same("whole", "half")

    def test_into_another_folder(self):
        self.run_to_end("from", "--set", "time.end=0.5")
        before = result(self.folder / "from" / "out")
        self.run_to_end("to", "--resume", str(self.folder / "from" / "out" / "checkpoint.h5"))
        steps = rows(self.folder / "to" / "out" / "steps.csv")
        self.assertEqual(int(steps[0]["step"]), len(rows(self.folder / "from" / "out" / "steps.csv")))
        self.assertEqual(float(steps[-1]["time"]), 1.0)
        self.assertEqual(result(self.folder / "from" / "out"), before)

    def test_new_run_removes_the_old_checkpoint(self):
        self.run_to_end("again", "--set", "time.end=0.25")
        os.remove(self.folder / "again" / "out" / "steps.csv")
        process = self.start("again", "--set", "output.checkpoint_every=0", "--set", "domain.cells=[384,128]", steps=1)
        process.kill()
        process.communicate(timeout=60)
        self.assertFalse((self.folder / "again" / "out" / "checkpoint.h5").exists())

    def test_wrong_files_are_status_2_with_file_and_remedy(self):
        self.run_to_end("good", "--set", "time.end=0.25")
        out = self.folder / "good" / "out"
        good = (out / "checkpoint.h5").read_bytes()
        bad = self.folder / "good" / "bad.h5"

        def refusal(content, *more):
            bad.write_bytes(content)
            before = result(out)
            message = self.run_to_end("good", "--resume", "bad.h5", *more, status=2)
            self.assertEqual(result(out), before, "a refusal changes nothing")
            self.assertIn("bad.h5: ", message)
            return message

        self.assertIn("not a checkpoint, or damaged", refusal(b"hello"))
        for length in (100, len(good) // 2, len(good) - 100):
            self.assertIn("damaged", refusal(good[:length]))
        chance = random.Random(SEED)
        middle = good.index(b'"title"')
        self.assertIn("damaged", refusal(good[:middle] + b'"TITLE"' + good[middle + 7:]))
        damage = 0
        for _ in range(20):
            at = chance.randrange(len(good) // 2, len(good))  # arrays, for the most part
            changed = good[:at] + bytes([good[at] ^ 0x10]) + good[at + 1:]
            bad.write_bytes(changed)
            done = subprocess.run(self.words("good", "--resume", "bad.h5", "--set", "time.end=0.25", "-o", "other"),
                                  cwd=self.folder / "good", capture_output=True, text=True, timeout=300)
            self.assertIn(done.returncode, (0, 2), done.stderr)  # 0: bytes of the file that hold nothing
            damage += done.returncode == 2
        self.assertGreater(damage, 10)
        for change, text in (("domain.cells=[144,48]", "domain.cells: was [72,24], is [144,48]"),
                             ("body.ball.radius=0.19", "body.ball.radius: was 0.2, is 0.19"),
                             ("gravity=[0,-2]", "gravity: was [0.0,-1.0], is [0.0,-2.0]"),
                             ("gap.model=none", "gap.model")):
            message = refusal(good, "--set", change)
            self.assertIn(text, message)
            self.assertIn("start the run anew", message)
        text = (self.folder / "scene2.toml").read_text()
        without = re.sub(r'\[\[body\]\]\nname = "driven".*?(?=\[time\])', "", text, flags=re.S)
        (self.folder / "scene2.toml").write_text(without)
        self.assertIn("number of [[body]]: was 3, is 2", refusal(good))
        (self.folder / "scene2.toml").write_text(text)
        self.assertIn("no such file", self.run_to_end("good", "--resume", "nowhere.h5", status=2))
        # What may change.
        self.run_to_end("good", "--resume", "out/checkpoint.h5", "--set", "solver.tolerance=1e-7", "--set", "time.max_step=0.02",
                        "--set", "title=other", "--set", "output.every=0.5", "--set", "time.end=0.3")

    def test_other_format_is_named(self):
        self.run_to_end("old", "--set", "time.end=0.05")
        path = self.folder / "old" / "out" / "checkpoint.h5"
        content = path.read_bytes()
        # The attribute: its name, padded, then type, space and the number.
        name = content.index(b"format_version\0")
        current = (8).to_bytes(8, "little")
        candidates = [content.index(current, name + 16)]
        while candidates[-1] >= 0 and len(candidates) < 8:
            candidates.append(content.find(current, candidates[-1] + 1))
        for at in filter(lambda at: at > 0, candidates):
            path.write_bytes(content[:at] + (9).to_bytes(8, "little") + content[at + 8:])
            message = self.run_to_end("old", "--resume", "out/checkpoint.h5", status=2)
            if "a checkpoint of format 9" in message:
                self.assertIn("resume with the version that wrote it", message)
                return
        self.fail("no place in the file is the format's number")

    def test_full_disk_is_told_and_keeps_what_is_there(self):
        self.run_to_end("full", "--set", "time.end=0.25")
        out = self.folder / "full" / "out"
        before = result(out)
        process = self.start("full", "--resume", "out/checkpoint.h5", steps=len(rows(out / "steps.csv")) + 2)
        resource.prlimit(process.pid, resource.RLIMIT_FSIZE, (10000, 10000))
        _, message = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 1, message)
        self.assertRegex(message, r"out/\S+: cannot write the (file|table): File too large; free space on that disk")
        self.assertEqual(list(out.rglob("*.partial")), [])
        self.assert_readable(out)
        after = result(out)
        for name in ("fields/fields_00000.vti", "fields/fields_00001.vti", "films/films_00001.vtp", "checkpoint.h5"):
            self.assertEqual(after[name], before[name])
        self.run_to_end("whole")
        self.run_to_end("full", "--resume", "out/checkpoint.h5")
        self.assert_same("whole", "full")

    def test_small_disk(self):
        place = self.folder / "disk" / "out"
        place.mkdir(parents=True)
        mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=400k", "tmpfs", str(place)], capture_output=True)
        if mounted.returncode:
            self.skipTest("may not mount")
        try:
            message = self.run_to_end("disk", status=1)
            self.assertRegex(message, r"out/\S+: cannot write the (file|table).*: No space left on device; free space")
            self.assert_readable_without_report(place)
            self.assertEqual(list(place.rglob("*.partial")), [])
        finally:
            subprocess.run(["umount", str(place)], check=True)

    def assert_readable_without_report(self, out):
        record = (out / "run.json").read_text() if (out / "run.json").exists() else "{}"
        json.loads(record)
        for path in out.rglob("*.vt?"):
            xml.etree.ElementTree.parse(path)
        self.assertGreater(len(rows(out / "steps.csv")), 1)


if __name__ == "__main__":
    unittest.main()
