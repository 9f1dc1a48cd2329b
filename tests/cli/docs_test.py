"""The tutorial and the how-tos as a reader follows them: files are saved, commands run in order in one folder, and what the page
says that they print must be printed.

In a page, a fence after "Save this as `NAME`" or "as `NAME`:" is a file, and one after "add this to the end of `NAME`" is added to it; a
fence `sh` is run and must succeed (`sh fails`: must fail); a fence `text` after it lists lines of its output, in order, "..." for
anything and any number of blanks alike. Usage: docs_test.py GAPFLOW REPOSITORY
"""
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from harness import GAPFLOW, gapflow

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
