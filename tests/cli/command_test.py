"""The command as a user types it: examples in short, files, exit codes, messages. Usage: command_test.py GAPFLOW EXAMPLES"""
import base64
import json
import os
import re
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path
from xml.etree import ElementTree

from harness import GAPFLOW, gapflow, rows

EXAMPLES = Path(sys.argv.pop(1))
SHORT = {  # settings that keep each example to seconds
    "01_plates_pulled_apart": ["domain.cells=[64,64]", "time.end=0.1", "output.every=0.05"],
    "02_cylinders_from_contact": ["domain.cells=[48,48]", "time.end=0.3", "output.every=0.15"],
    "03_square_plates": ["domain.cells=[24,24,24]", "time.end=0.04", "output.every=0.02"],
    "04_sphere_leaving_wall": ["domain.cells=[24,24,24]", "time.end=0.1", "output.every=0.05"],
    "05_mesh_bodies": ["domain.cells=[24,24,24]", "time.end=0.04", "output.every=0.02"],
    "06_wet_separation_2d": ["domain.cells=[48,48]", "time.end=0.1", "output.every=0.05"],
    "08_wet_separation_3d": ["domain.cells=[24,24,24]", "time.end=0.04", "output.every=0.02"],
}
VISCOUS = {  # the same, and a body that moves down meanwhile
    "14_settling_sphere": ("sphere", "z", ["domain.size=[0.1,0.1,0.16]", "domain.cells=[20,20,32]", "time.end=0.1"]),
    "15_bouncing_sphere": ("ball", "z", ["domain.cells=[20,20,24]", "time.end=0.01"]),
    "17_squeeze_film": ("disk", "y", ["domain.cells=[16,8,16]", "time.end=3"]),
    "18_drafting_kissing_tumbling": ("upper", "z", ["domain.cells=[18,18,72]", "time.end=0.05"]),
}
DRY = "10_dry_separation"


def vtu_cells(file):
    """{name: values} of the cell data of a VTK file with inline arrays of doubles."""
    data = ElementTree.parse(file).getroot().find(".//CellData")
    return {array.get("Name"): [x for x, in struct.iter_unpack("<d", base64.b64decode(array.text)[8:])] for array in data}


class Command(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.out = Path(self.folder.name) / "out"
        self.addCleanup(self.folder.cleanup)

    def run_example(self, name, *more):
        sets = [word for key in [*SHORT.get(name, []), *more] for word in ("--set", key)]
        done = gapflow("run", EXAMPLES / name / "scene.toml", "-o", self.out, *sets, "--quiet", "--force")
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def test_examples_open_their_gaps(self):
        for name in SHORT:
            with self.subTest(name):
                self.run_example(name)
                gaps = rows(self.out / "gaps.csv")
                first, last = float(gaps[0]["thickness"]), float(gaps[-1]["thickness"])
                self.assertGreater(last, first)
                steps = rows(self.out / "steps.csv")
                self.assertEqual(steps[0]["step"], "0")
                self.assertLess(max(float(row["divergence_max"]) for row in steps), 1e-5)
                self.assertLessEqual(max(int(row["iterations"]) for row in steps), 60)
                for file in ("gapflow.pvd", "run.json", "bodies.csv", "fields/fields_00002.vti", "films/films_00002.vtp"):
                    self.assertTrue((self.out / file).exists(), file)
                self.assertEqual(json.loads((self.out / "run.json").read_text())["status"], "done")

    def test_viscous_examples(self):
        for name, (body, axis, settings) in VISCOUS.items():
            with self.subTest(name):
                self.run_example(name, *settings)
                heights = [float(row[axis]) for row in rows(self.out / "bodies.csv") if row["body"] == body]
                self.assertLess(heights[-1], heights[0])
                steps = rows(self.out / "steps.csv")[1:]
                self.assertTrue(all(1 <= int(row["viscous_iterations"]) <= 60 for row in steps))
                self.assertTrue(all(float(row["dissipation_grid"]) > 0 for row in steps))
                films = any(int(row["film_nodes"]) > 0 for row in steps)
                self.assertEqual(any(float(row["dissipation_film"]) > 0 for row in steps), films)
                # The tolerance is one of what gravity drives in a step, far above what viscosity leaves of it.
                self.assertLess(max(float(row["divergence_max"]) for row in steps), 2e-5)

    def test_journal_bearing_carries_sommerfelds_load(self):
        self.run_example("16_journal_bearing")
        shaft = [row for row in rows(self.out / "bodies.csv") if row["body"] == "shaft"][-1]
        load = (float(shaft["fx"]) ** 2 + float(shaft["fy"]) ** 2) ** 0.5
        self.assertAlmostEqual(load / 145.1, 1, delta=0.03)
        self.assertAlmostEqual(abs(float(shaft["torque"])) / 58.0e-3, 1, delta=0.04)

    def test_without_gap_pressures_bodies_stick(self):
        name = "01_plates_pulled_apart"
        self.run_example(name)
        film = float(rows(self.out / "bodies.csv")[-1]["vy"])
        self.run_example(name, "gap.model=none", "grid.fractions=voxel")
        stuck = float(rows(self.out / "bodies.csv")[-1]["vy"])
        self.assertGreater(abs(film), 1e-3)
        self.assertLess(abs(stuck), 1e-2 * abs(film))

    def test_dry_blocks_hold_or_lift(self):
        self.run_example(DRY, "time.end=0.1", "output.every=0.05")
        last = {row["body_a"]: row for row in rows(self.out / "gaps.csv")}
        self.assertAlmostEqual(float(last["held"]["thickness"]), 1e-3, delta=1e-12)
        self.assertGreater(float(last["held"]["contact_force"]), 0.4)
        self.assertGreater(float(last["lifted"]["thickness"]), 2e-3)
        self.assertGreater(float(last["lifted"]["void_volume"]), 1.5e-3)
        self.assertEqual(float(last["wet"]["void_volume"]), 0)
        self.assertGreater(float(last["wet"]["thickness"]), 1.01e-3)
        self.assertLess(max(float(row["divergence_max"]) for row in rows(self.out / "steps.csv")), 1e-7)
        self.assertIn("void_depth", (self.out / "films" / "films_00002.vtp").read_text(errors="ignore"))

    def test_dry_contact_in_a_closed_box_is_refused(self):
        done = gapflow("run", EXAMPLES / DRY / "scene.toml", "-o", self.out, "--set", "domain.sides.y_high=wall")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("has no pressure level", done.stderr)
        self.assertFalse(self.out.exists())

    def test_backends_agree(self):
        scene = EXAMPLES / "01_plates_pulled_apart" / "scene.toml"
        results = [json.loads(gapflow("added-mass", scene, "--json", "--set", "domain.cells=[64,64]", "--set",
                                      f"solver.backend={backend}").stdout)["matrix"] for backend in ("multigrid", "petsc")]
        scale = max(abs(v) for row in results[0] for v in row)
        for a, b in zip(*results):
            for x, y in zip(a, b):
                self.assertAlmostEqual(x / scale, y / scale, delta=1e-7)

    def test_check_names_films(self):
        done = gapflow("check", EXAMPLES / "01_plates_pulled_apart" / "scene.toml")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("lower - upper", done.stdout)

    def test_check_writes_a_picture_of_parts(self):
        scene, picture = self.out.parent / "gap.toml", self.out.parent / "parts.vtu"
        scene.write_text("""[domain]
size = [6, 6]
cells = [6, 6]
[[body]]
name = "low"
shape = "box"
size = [4, 2]
position = [3, 1.5]
density = 2
[[body]]
name = "high"
shape = "box"
size = [4, 2]
position = [3, 4]
density = 2
""")
        done = gapflow("check", scene, "--parts", picture)
        self.assertEqual(done.returncode, 2)
        self.assertIn("add --set gap.model=parts", done.stderr)
        done = gapflow("check", scene, "--set", "gap.model=parts", "--parts", self.out.parent / "parts.txt")
        self.assertEqual(done.returncode, 2)
        self.assertIn(".vtu", done.stderr)
        done = gapflow("check", scene, "--set", "gap.model=parts", "--parts", picture)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("thin: " + str(picture), done.stdout)
        fields = vtu_cells(picture)
        # The gap of half a cell between the boxes: thin cells between body 0 and body 1.
        gap = [k for k, kind in enumerate(fields["kind"]) if kind == 2 and {fields["first_wall"][k], fields["second_wall"][k]} == {0, 1}]
        self.assertGreaterEqual(len(gap), 4)
        for k in gap:
            if fields["open"][k] == 0.5:
                self.assertAlmostEqual(fields["thickness"][k], 0.5, delta=1e-12)
        self.assertTrue(any(fields["open"][k] == 0.5 for k in gap))
        self.assertAlmostEqual(sum(fields["open"]), 36 - 16, delta=1e-9)

    def test_check_tells_that_a_run_needs_a_time(self):
        text = (EXAMPLES / "01_plates_pulled_apart" / "scene.toml").read_text()
        self.assertNotIn("needs both", gapflow("check", EXAMPLES / "01_plates_pulled_apart" / "scene.toml").stdout)
        for key in ("end", "max_step"):
            scene = self.out.parent / "without.toml"
            scene.write_text("\n".join(line for line in text.splitlines() if not line.startswith(key + " =")))
            done = gapflow("check", scene)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("'gapflow run' needs both", done.stdout)

    def test_bad_use_is_status_2_with_place_and_remedy(self):
        scene = EXAMPLES / "01_plates_pulled_apart" / "scene.toml"
        for words, text in ((["run", scene, "--set", "time.endd=1"], "time.end"), (["run", "nowhere.toml"], "nowhere.toml"),
                            (["fly"], "fly"), (["run", scene, "--set", "fluid.viscosity=-1"], "viscosity")):
            done = gapflow(*words)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(text, done.stderr)

    def test_interrupted_run_leaves_valid_files(self):
        for number, status in ((signal.SIGTERM, 143), (signal.SIGINT, 130)):
            run = subprocess.Popen([GAPFLOW, "run", str(EXAMPLES / "01_plates_pulled_apart" / "scene.toml"), "-o", str(self.out),
                                    "--set", "time.max_step=1e-5", "--quiet"], stderr=subprocess.PIPE)
            deadline = time.time() + 60
            while time.time() < deadline and not ((self.out / "steps.csv").exists() and len(rows(self.out / "steps.csv")) > 3):
                time.sleep(0.1)
            run.send_signal(number)
            run.communicate(timeout=60)
            self.assertEqual(run.returncode, status)
            self.assertEqual(json.loads((self.out / "run.json").read_text())["status"], "interrupted")
            os.remove(self.out / "steps.csv")

    def test_waiting_threads_sleep_unless_told_how_to_wait(self):
        def looks(**more):
            own = {k: v for k, v in os.environ.items() if not k.startswith(("OMP_", "GOMP_"))}
            shown = gapflow("--version", env={**own, "OMP_DISPLAY_ENV": "verbose", **more}).stderr
            found = re.findall(r"GOMP_SPINCOUNT = '(\d+)'", shown)
            if not found:
                self.skipTest("built without OpenMP, or with another one than GCC's")
            return int(found[-1])
        self.assertEqual(looks(), 1000)
        self.assertEqual(looks(GOMP_SPINCOUNT="20"), 20)
        self.assertGreater(looks(OMP_WAIT_POLICY="active"), 1000)


if __name__ == "__main__":
    unittest.main()
