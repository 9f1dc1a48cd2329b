"""The tutorial and the how-tos as a reader follows them: files are saved, commands run in order in one folder, and what the page
says that they print must be printed.

In a page, a fence after "Save this as `NAME`" or "as `NAME`:" is a file, and one after "add this to the end of `NAME`" is added to it; a
fence `sh` is run and must succeed (`sh fails`: must fail); a fence `text` after it lists lines of its output, in order, "..." for
anything and any number of blanks alike. And figures that READMEs of examples quote are those of their runs. Usage: docs_test.py GAPFLOW REPOSITORY
"""
import math
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from harness import GAPFLOW, gapflow, rows

ROOT = Path(sys.argv.pop(1)).resolve()
PAGES = {"tutorial.md": [], **{f"how-to/{name}.md": [] for name in ("added-mass", "valve", "many-particles", "cad-mesh", "convergence", "viscous", "measuring", "choosing", "unbounded-water")},
         "how-to/cluster.md": ["tutorial.md"]}  # page: those whose files it uses
FENCE = re.compile(r"^```(\S+)([^\n]*)\n(.*?)^```$", re.M | re.S)


def saved_file(before):
    """Name and mode of the file that a page's text before a fence announces."""
    paragraph = before.rstrip().rsplit("\n\n", 1)[-1].replace("\n", " ")
    added = re.search(r"add this to the end of `([^`]+)`:$", paragraph)
    saved = re.search(r"as `([^`]+)`:$", paragraph)
    return (added.group(1), "a") if added else (saved.group(1), "w") if saved else (None, "")


class Page(unittest.TestCase):
    def follow(self, name, folder, run=True):
        text = (ROOT / "docs" / name).read_text()
        output, commands = "", 0
        environment = {**os.environ, "PATH": f"{Path(GAPFLOW).parent}:{os.environ['PATH']}"}
        for fence in FENCE.finditer(text):
            kind, how, content = fence.group(1), fence.group(2).strip(), fence.group(3)
            file, mode = saved_file(text[:fence.start()])
            if file:
                with open(folder / file, mode) as out:
                    out.write(content)
            elif kind == "sh" and run:
                done = subprocess.run(["bash", "-e", "-o", "pipefail", "-c", content], cwd=folder, env=environment, text=True,
                                      stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=300)
                output, commands = done.stdout, commands + 1
                self.assertEqual(done.returncode != 0, how == "fails", f"{name}: {content}{output}")
                self.assertTrue(how in ("", "fails"), f"{name}: ```sh {how}")
            elif kind == "text" and run:
                place = 0
                for line in content.splitlines():
                    parts = [r" +".join(map(re.escape, part.split())) for part in line.split("...")]
                    found = re.compile(" *[^\n]*".join(parts)).search(output, place)
                    self.assertTrue(found, f"{name}: not printed: {line}\n{output}")
                    place = found.end()
        return commands

    def test_pages_run_as_written(self):
        for name, needed in PAGES.items():
            with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                for other in needed:
                    self.follow(other, Path(folder), run=False)
                self.assertGreater(self.follow(name, Path(folder)), 0)

    def test_no_how_to_is_left_out(self):
        self.assertEqual({f"how-to/{path.name}" for path in (ROOT / "docs" / "how-to").glob("*.md")} | {"tutorial.md"}, set(PAGES))


class Reference(unittest.TestCase):
    def test_pages_are_what_the_command_generates(self):
        for page, kind in (("scene", "scene-markdown"), ("command", "markdown")):
            done = gapflow("generate", kind)
            self.assertEqual(done.returncode, 0, done.stderr)
            written = (ROOT / "docs" / "reference" / f"{page}.md").read_text()
            self.assertEqual(done.stdout, written, f"run: gapflow generate {kind} -o docs/reference/{page}.md")

    def test_keys_are_listed(self):
        names = gapflow("keys", "--names").stdout.split()
        self.assertIn("body.NAME.spring.anchor", names)
        self.assertEqual(len(names), len(set(names)))
        self.assertIn("one of \"wet\", \"dry\"; default: \"wet\"", gapflow("keys", "gap.contact").stdout)
        done = gapflow("keys", "gpa")
        self.assertEqual(done.returncode, 2)
        self.assertIn("did you mean 'gap'?", done.stderr)


class Figures(unittest.TestCase):
    """What READMEs of examples quote is what their runs give, within one of the last digit."""

    def run_of(self, example, *sets):
        with tempfile.TemporaryDirectory() as out:
            done = gapflow("run", example / "scene.toml", "-o", out, "--quiet", *(word for value in sets for word in ("--set", value)))
            self.assertEqual(done.returncode, 0, done.stderr)
            return [[{key: value if key.startswith("body") else float(value) for key, value in row.items()} for row in rows(Path(out) / name)]
                    for name in ("bodies.csv", "gaps.csv")]

    def example(self, number):
        return next((ROOT / "examples").glob(f"{number}_*"))

    def quoted(self, number, pattern):
        text = " ".join((self.example(number) / "README.md").read_text().split())
        found = re.search(pattern, text)
        self.assertTrue(found, f"{number}: {pattern}")
        return found.groups()

    def assert_quoted(self, text, value):
        self.assertLess(abs(float(text) - value), 10.0 ** -len(text.partition(".")[2]), f"the README says {text}, the run {value}")

    def test_plates_pulled_apart(self):
        thickness, time = self.quoted("01", r"h = ([0-9.]+) at t = ([0-9.]+) within 1\.5 %")
        bodies, _ = self.run_of(self.example("01"))
        upper, lower = ([row for row in bodies if row["body"] == name] for name in ("upper", "lower"))
        track = [(a["time"], a["y"] - b["y"] - 0.5) for a, b in zip(upper, lower)]
        self.assert_quoted(time, next(t for t, h in track if h >= float(thickness)))

    def test_check_valve(self):
        opening, fine, force = self.quoted("12", r"openings of ([0-9.]+) \(on twice the cells the first is ([0-9.]+)\).* on the two is ([0-9.]+) together")
        (rough,) = self.quoted("12", r"\(gap ([0-9.e-]+), the roughness\)")
        lift = lambda bodies: [(row["time"], row["y"] - 1.351) for row in bodies if row["body"] == "poppet"]
        bodies, gaps = self.run_of(self.example("12"))
        for period in range(3):
            self.assert_quoted(opening, max(y for t, y in lift(bodies) if period <= t <= period + 1))
            ends = [row for row in gaps if abs(row["time"] - period - 1) < 1e-9]
            self.assertEqual([row["body_a"] for row in ends], ["seat_left", "seat_right"])
            self.assert_quoted(force, sum(row["contact_force"] for row in ends))
            self.assertLess(max(abs(row["thickness"] / float(rough) - 1) for row in ends), 0.05)
        bodies, _ = self.run_of(self.example("12"), "domain.cells=[128, 192]", "time.end=1")
        self.assert_quoted(fine, max(y for _, y in lift(bodies)))

    def test_flap_valve(self):
        *openings, low, high = self.quoted("13", r"openings of ([0-9.]+), ([0-9.]+) and ([0-9.]+) radians \(([0-9]+) to ([0-9]+)°\)")
        bodies, _ = self.run_of(self.example("13"))
        track = [(row["time"], abs(row["angle"])) for row in bodies if row["body"] == "leaflet"]
        largest = [max(angle for t, angle in track if 2 * period <= t <= 2 * period + 2) for period in range(3)]
        for period, opening in enumerate(openings):
            self.assert_quoted(opening, largest[period])
            self.assertLess(min(angle for t, angle in track if 2 * period + 1.5 <= t <= 2 * period + 2), 1e-6)
        self.assert_quoted(low, math.degrees(min(largest)))
        self.assert_quoted(high, math.degrees(max(largest)))


class Links(unittest.TestCase):
    def test_none_is_dead(self):
        done = subprocess.run([sys.executable, ROOT / "tools" / "check-links"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout)

    def test_a_dead_one_is_found(self):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "a.html").write_text('<a href="b.html#x">b</a><a href="c.html">c</a><img src="d.png">')
            (Path(folder) / "b.html").write_text('<p id="y">here</p>')
            done = subprocess.run([sys.executable, ROOT / "tools" / "check-links", folder], capture_output=True, text=True)
            self.assertEqual(done.returncode, 1)
            self.assertIn("2 pages, 3 links, 3 dead", done.stdout)


if __name__ == "__main__":
    unittest.main()
