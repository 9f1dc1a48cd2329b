"""What the commands tell of a scene: bodies too thin for the grid, ends of films, memory; each once. Usage: warnings_test.py GAPFLOW"""
import json
import re
import tempfile
import unittest
from pathlib import Path

from harness import gapflow

PLATE = """
[domain]
size = [1, 1]
cells = [32, 32]
[time]
end = 0.002
max_step = 0.001
[[body]]
name = "plate"
shape = "box"
size = [0.5, {thickness}]
position = [0.5, 0.5]
density = 2
force = [0, 1]
{more}
"""

FRAME = """
[domain]
size = [1, 1]
cells = [32, 32]
[time]
end = 0.002
max_step = 0.001
[[body]]
name = "frame"
shape = "mesh"
file = "frame.txt"
position = [0.5, 0.5]
motion = "fixed"
[[body]]
name = "core"
shape = "box"
size = [0.48, 0.48]
position = [0.5, 0.5]
density = 2
"""
OVERLAPPING = """
[domain]
size = [1,1]
cells = [32,32]
[[body]]
name = "b0"
shape = "box"
position = [0.528,0.621]
rotation = 0
density = 2
size = [0.249,0.235]
[[body]]
name = "b1"
shape = "capsule"
position = [0.452,0.384]
rotation = 45
density = 2
radius = 0.077
length = 0.252
[[body]]
name = "b2"
shape = "box"
position = [0.578,0.407]
rotation = 288.65749211873407
density = 2
size = [0.384,0.370]
"""


class Warnings(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.scene, self.out = self.folder / "scene.toml", self.folder / "out"

    def write(self, cells, more=""):
        self.scene.write_text(PLATE.format(thickness=cells / 32, more=more))

    def commands(self):
        return (["run", self.scene, "-o", self.out], ["check", self.scene], ["added-mass", self.scene],
                ["converge", self.scene, "--cells", "16,32", "-o", self.out])

    def test_a_gap_thinner_than_the_default_roughness_is_told_of(self):
        scene = PLATE.format(thickness=4 / 32, more="").replace("position = [0.5, 0.5]", f"position = [0.5, {{y}}]")
        for gap, sets, told in ((1e-4, [], True), (1e-4, ["--set", "gap.roughness=0"], False), (0.0, [], False), (0.01, [], False)):
            with self.subTest(gap=gap, sets=sets):
                self.scene.write_text(scene.format(y=2 / 32 + gap / 32))
                for words in (["run", self.scene, "-o", self.out], ["check", self.scene]):
                    done = gapflow(*words, *sets)
                    self.assertEqual("their film counts as 0.000156 (0.005 cells) thick" in done.stdout + done.stderr, told, done.stdout + done.stderr)

    def test_many_gaps_thinner_than_the_default_roughness_are_counted(self):
        radius = 2.5 / 32
        balls, x = "", 0.1 + radius
        for k, gap in enumerate((3e-4, 1e-4, 4e-4, 2e-4, 0.0)):  # of a cell, to the next one; 0.005 is the roughness
            balls += f'[[body]]\nname = "ball{k}"\nshape = "ball"\nradius = {radius!r}\nposition = [{x!r}, 0.5]\ndensity = 2\n'
            x += 2 * radius + gap / 32
        self.scene.write_text('[domain]\nsize = [1, 1]\ncells = [32, 32]\n[time]\nend = 0.002\nmax_step = 0.001\n' + balls.replace("[[body]]", "\n[[body]]"))
        told = gapflow("check", self.scene).stdout
        named = [{m[1], m[2]} for m in re.finditer(r"'ball(\d)' and 'ball(\d)' are .* their film counts as", told)]
        self.assertEqual(named, [{"1", "2"}, {"3", "4"}, {"0", "1"}], told)  # the gap between 2 and 3 is the widest
        self.assertIn("so it is with 1 more pair", told)

    def test_solids_that_stand_still_and_touch_have_no_film(self):
        seat = PLATE.format(thickness=4 / 32, more='motion = "fixed"').replace("position = [0.5, 0.5]", "position = [0.5, 0.0625]").replace("force = [0, 1]", "")
        ball = '[[body]]\nname = "ball"\nshape = "ball"\nradius = 0.2\nposition = [0.5, 0.34]\ndensity = 2\n'
        pair = '[[pair]]\nbodies = ["plate", "wall:y_low"]\n'
        for more, film in ((ball, False), (ball + pair, True)):
            self.scene.write_text(seat + more)
            told = gapflow("check", self.scene).stdout
            self.assertRegex(told, "film +ball - plate|film +plate - ball")
            self.assertEqual(bool(re.search("film +plate - wall:y_low", told)), film, told)

    def test_a_body_of_half_a_cell_is_refused(self):
        self.write(0.5)
        for words in self.commands():
            with self.subTest(words[0]):
                done = gapflow(*words)
                self.assertEqual(done.returncode, 2, done.stderr)
                cells = "0.25" if words[0] == "converge" else "0.5"
                self.assertRegex(done.stderr, rf"error: .*scene.toml: body 'plate' is {cells} cells thin at \(0\.\d+, 0\.5\).*thin = \"allow\"")
                self.assertFalse(self.out.exists())
        self.assertIn("warning   body 'plate' is 0.5 cells thin", gapflow("check", self.scene).stdout)

    def test_parts_take_bodies_of_any_thickness(self):
        parts = '[gap]\nmodel = "parts"'
        self.scene.write_text(PLATE.format(thickness=0.001, more=parts).replace("position = [0.5, 0.5]", "position = [0.51, 0.508]"))
        done = json.loads(gapflow("added-mass", self.scene, "--json").stdout)
        self.assertAlmostEqual(done["matrix"][1][1] / (3.1416 / 16), 1.12, delta=0.04) # the closed box adds 12 %
        self.assertEqual(done["warnings"], [])
        self.assertIn("gaps      model parts", gapflow("check", self.scene).stdout)
        for key, value, words in (("fluid.velocity", "[1, 0]", "along axes without walls"),
                                  ("gap.exit", "jet", "reversible exits")):
            with self.subTest(key):
                refused = gapflow("run", self.scene, "-o", self.out, "--set", f"{key}={value}")
                self.assertEqual(refused.returncode, 2, refused.stderr)
                self.assertRegex(refused.stderr, f"{key}.*{words}")
                self.assertFalse(self.out.exists())
        self.assertEqual(gapflow("run", self.scene, "-o", self.out).returncode, 0)
        last = (self.out / "bodies.csv").read_text().splitlines()[-1].split(",")
        self.assertAlmostEqual(float(last[7]) / (0.002 / (0.001 + 1.12 * 3.1416 / 16)), 1, delta=0.06)
        self.scene.write_text(PLATE.format(thickness=0.001, more=parts).replace("[0.5, 0.001]", "[0.125, 0.001]"))
        self.assertIn("body 'plate' is thin and 4 cells long: its added mass errs by some 8.5 %", gapflow("check", self.scene).stdout)
        self.write(3, '[[pair]]\nbodies = ["plate", "wall:x_low"]\nmodel = "parts"')
        refused = gapflow("added-mass", self.scene)
        self.assertEqual(refused.returncode, 2)
        self.assertIn("a model of the whole scene", refused.stderr)

    def test_one_that_is_allowed_or_of_one_and_a_half_is_told_of_once(self):
        for cells, sets in ((0.5, ["--set", "grid.thin=allow"]), (1.5, [])):
            self.write(cells)
            for words in self.commands()[:3]:
                with self.subTest(cells=cells, command=words[0]):
                    done = gapflow(*words, *sets)
                    self.assertEqual(done.returncode, 0, done.stderr)
                    self.assertEqual((done.stdout + done.stderr).count(f"body 'plate' is {cells} cells thin"), 1, done.stderr)
            record = json.loads((self.out / "run.json").read_text())
            self.assertEqual(len(record["warnings"]), 1)
            self.assertEqual(gapflow("report", self.out).returncode, 0)
            self.assertIn(f"is {cells} cells thin at", (self.out / "report.html").read_text().split('id="gapflow-data"')[0])
        self.write(3)
        done = gapflow("run", self.scene, "-o", self.out)
        self.assertNotIn("warning", done.stderr)
        self.assertEqual(json.loads((self.out / "run.json").read_text())["warnings"], [])
        gapflow("report", self.out)
        self.assertNotIn("Warnings", (self.out / "report.html").read_text().split('id="gapflow-data"')[0])

    def test_a_warning_of_the_reader_comes_once(self):
        self.write(3, '[[body]]\nname = "post"\nshape = "box"\nsize = [0.1, 0.1]\nposition = [0.1, 0.1]\nmotion = "fixed"\nforce = [0, 1]')
        for words in self.commands():
            with self.subTest(words[0]):
                done = gapflow(*words)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertEqual(len(re.findall("body.post.force is ignored", done.stdout + done.stderr)), 1, done.stderr)
        self.assertIn("body.post.force is ignored", json.loads((self.out / "cells_32" / "run.json").read_text())["warnings"][0])

    def test_a_sealed_film_has_its_pair_place_and_meaning(self):
        square = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
        loops = [[(0.35 * x, 0.35 * y) for x, y in square], [(0.25 * x, 0.25 * y) for x, y in reversed(square)]]
        (self.folder / "frame.txt").write_text("\n\n".join("\n".join(f"{x} {y}" for x, y in loop) for loop in loops) + "\n")
        self.scene.write_text(FRAME)
        for words in self.commands()[:3]:
            with self.subTest(words[0]):
                done = gapflow(*words)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertRegex(done.stdout + done.stderr, r"a film at \(0\.\d+, 0\.\d+\) between frame, core: nothing lets this fluid out")
                self.assertNotIn("0 cells of fluid", done.stdout + done.stderr)

    def test_a_blind_end_has_its_pair_place_and_remedy(self):
        self.scene.write_text(OVERLAPPING)
        for command in ("check", "added-mass"):
            done = gapflow(command, self.scene)
            self.assertEqual(done.returncode, 0, done.stderr)
            said = re.findall(r"the film between 'b\d' and 'b\d' ends at \(0\.\d+, 0\.\d+\) where nothing continues it.*; use a finer grid",
                              done.stdout + done.stderr)
            self.assertEqual(len(said), 1, done.stdout + done.stderr)

    def test_memory_is_that_of_a_run(self):
        scene = ["--set", "domain.cells=[512,512]", "--set", "fluid.viscosity=0.001"]
        self.write(3)
        said = float(re.search(r"memory +about ([0-9.e+]+) MiB", gapflow("check", self.scene, *scene).stdout)[1])
        done = gapflow("run", self.scene, "-o", self.out, "--quiet", *scene)
        self.assertEqual(done.returncode, 0, done.stderr)
        used = json.loads((self.out / "run.json").read_text())["peak_memory_bytes"]["sum"] / 1048576
        self.assertLess(abs(said / used - 1), 0.25, (said, used))


if __name__ == "__main__":
    unittest.main()
