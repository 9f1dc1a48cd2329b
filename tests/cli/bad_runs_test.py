"""Scenes that the reader takes and a run must refuse: too much memory, bodies in the wrong place, broken meshes, motion that has
nowhere to go, places that cannot be written. The first line of each file in tests/data/bad_runs is "# expect STATUS: TEXT", the
text of the message; "..." stands for anything. A second one, "# on parts STATUS: TEXT", takes its place with gap.model = "parts".

Usage: bad_runs_test.py GAPFLOW FOLDER
"""
import re
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

from harness import gapflow

SCENES = Path(sys.argv.pop(1))


class BadRuns(unittest.TestCase):
    def test_are_refused_with_the_expected_message(self):
        self.expect_refused()

    def test_are_refused_on_parts(self):
        self.expect_refused("--set", "gap.model=parts", left_out={"thin.toml"})    # which parts run

    def expect_refused(self, *options, left_out=frozenset()):
        files = [file for file in sorted(SCENES.glob("*.toml")) if file.name not in left_out]
        self.assertGreaterEqual(len(files), 20)
        for file in files:
            with self.subTest(file.name), tempfile.TemporaryDirectory() as folder:
                for used in SCENES.iterdir():
                    shutil.copy(used, folder)
                first, second = file.read_text().splitlines()[:2]
                status, text = re.fullmatch(r"# expect (\d): (.*)", first).groups()
                on_parts = re.fullmatch(r"# on parts (\d): (.*)", second) if options else None
                if on_parts:
                    status, text = on_parts.groups()
                done = gapflow("run", file.name, "--quiet", *options, cwd=folder, timeout=60)
                self.assertEqual(done.returncode, int(status), done.stderr)
                pattern = ("(?m)" if on_parts else "") + "^(gapflow: error|warning): " + ".*".join(map(re.escape, text.split("...")))
                self.assertRegex(done.stderr, pattern)
                self.assertNotRegex(done.stderr, r"(?<!\")\b(nan|inf)\b|internal error")
                self.assertTrue(status == "0" or "; " in done.stderr, done.stderr)  # the remedy
                if status == "2":
                    self.assertFalse((Path(folder) / "out" / "steps.csv").exists())
                if status == "2" and not file.name.startswith("output_"):
                    checked = gapflow("check", file.name, *options, cwd=folder, timeout=60)
                    self.assertEqual((checked.returncode, checked.stderr.splitlines()[-1]), (2, done.stderr.splitlines()[-1]))

    def test_memory_is_refused_before_it_is_taken(self):
        scene = str(SCENES / "memory.toml")
        for command in (["run"], ["check"], ["added-mass"]):
            done = gapflow(*command, scene, timeout=60)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertRegex(done.stderr, r"cells need about [0-9.e+]+ GiB of memory")


if __name__ == "__main__":
    unittest.main()
