"""gapflow report as a user types it: pages, pictures, errors. Usage: report_test.py GAPFLOW EXAMPLES MPIEXEC"""
import base64
import json
import math
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib
from pathlib import Path

from harness import gapflow, rows

EXAMPLES, MPIEXEC = Path(sys.argv.pop(1)), sys.argv.pop(1)
PLATES, SPHERE = (EXAMPLES / name / "scene.toml" for name in ("01_plates_pulled_apart", "04_sphere_leaving_wall"))
TITLE = 'plates </script><!-- & "co" <b>'

MEASURED = """
[domain]
size = [2, 1]
cells = [32, 16]
[domain.sides]
x_low = { inflow = [1, 0] }
x_high = "open"
[fluid]
viscosity = 0.05
[[body]]
name = "disk"
shape = "ball"
radius = 0.2
position = [0.7, 0.5]
motion = "fixed"
[[probe]]
name = "tap"
point = [0.1, 0.5]
[[probe]]
name = "line"
line = { from = [1.5, 0], to = [1.5, 1], count = 11 }
every = 0.05
[[flux]]
name = "outlet"
side = "x_high"
[[flux]]
name = "seldom"
plane = { point = [0.7, 0.5], normal = "x" }
every = 0.1
[time]
end = 0.3
max_step = 0.02
[output]
every = 0.15
forces = true
"""


def run(scene, out, *settings, launcher=()):
    done = gapflow("run", scene, "-o", out, *[word for s in settings for word in ("--set", s)], launcher=launcher)
    assert done.returncode == 0, done.stderr
    return done


class Page:
    """A page taken apart."""

    def __init__(self, path):
        self.text = Path(path).read_text()
        self.json = json.loads(re.search(r'id="gapflow-data">(.*?)</script>', self.text, re.S).group(1))
        self.bytes = zlib.decompress(base64.b64decode(re.search(r'id="gapflow-numbers">(.*?)</script>', self.text, re.S).group(1)))

    def numbers(self, reference, base=0):
        kind, offset, count = reference[:3]
        start = base + offset
        if kind != "q16":
            code = {"f32": "f", "f64": "d", "i32": "i", "u8": "B"}[kind]
            return list(struct.unpack_from(f"<{count}{code}", self.bytes, start))
        low, high = reference[3:]
        code, values = 0, []
        for i in range(count):
            code = (code + (self.bytes[start + i] << 8) + self.bytes[start + count + i]) & 0xFFFF
            values.append(math.nan if code == 0 else low + (code - 1) / 65534 * (high - low))
        return values


def vtk_array(path, name):
    text = re.search(rf'Name="{name}"[^>]*>(.*?)</DataArray>', Path(path).read_text(), re.S).group(1)
    data = base64.b64decode(text)
    return list(struct.unpack_from(f"<{(len(data) - 8) // 8}d", data, 8))


class Report(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.flat, cls.solid = Path(cls.folder.name) / "flat", Path(cls.folder.name) / "solid"
        cls.said = run(PLATES, cls.flat, "domain.cells=[48,48]", "time.end=0.1", "output.every=0.05", f"title='{TITLE}'").stderr
        run(SPHERE, cls.solid, "domain.cells=[16,16,16]", "time.end=0.1", "output.every=0.05")

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.out = Path(folder.name) / "run"

    def copy(self, run):
        shutil.copytree(run, self.out)
        return self.out

    def page(self, run):
        done = gapflow("report", run)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(str(run / "report.html"), done.stdout)
        return Page(run / "report.html")

    def test_the_run_says_how_to_look_at_it(self):
        self.assertIn(f"gapflow report {self.flat}", self.said)

    def test_tables_are_those_of_the_run(self):
        page = self.page(self.flat)
        tables, steps = page.json["tables"], rows(self.flat / "steps.csv")
        self.assertEqual(page.numbers(tables["time"]), [float(row["time"]) for row in steps])
        for column in ("dt", "iterations", "energy_fluid", "energy_bodies", "residual"):
            for shown, row in zip(page.numbers(tables["steps"][column]), steps, strict=True):
                self.assertAlmostEqual(shown, float(row[column]), delta=1e-6 * abs(float(row[column])))
        for body in tables["bodies"]:
            of_body = [row for row in rows(self.flat / "bodies.csv") if row["body"] == body["name"]]
            for column in ("x", "y", "vy", "fy", "omega"):
                for shown, row in zip(page.numbers(body["columns"][column]), of_body, strict=True):
                    self.assertAlmostEqual(shown, float(row[column]), delta=1e-6 * abs(float(row[column])))
        self.assertEqual([body["name"] for body in tables["bodies"]], ["upper", "lower"])
        gap, table = tables["gaps"][0], rows(self.flat / "gaps.csv")
        self.assertEqual((gap["a"], gap["b"]), ("upper", "lower"))
        for column in ("thickness", "pressure_min", "force"):
            for shown, row in zip(page.numbers(gap["columns"][column]), table, strict=True):
                self.assertAlmostEqual(shown, float(row[column]), delta=1e-6 * abs(float(row[column])))

    def test_fields_films_and_bodies_are_those_of_the_run(self):
        page = self.page(self.flat)
        self.assertEqual(page.json["dimension"], 2)
        self.assertEqual([frame["time"] for frame in page.json["frames"]], [0, 0.05, 0.1])
        for number, frame in enumerate(page.json["frames"]):
            file = self.flat / "fields" / f"fields_{number:05d}.vti"
            kind, pressure, velocity = (vtk_array(file, name) for name in ("kind", "pressure", "velocity"))
            (plane,), base = frame["planes"], frame["base"]
            self.assertEqual(plane["cells"], [48, 48])
            self.assertEqual(page.numbers(plane["fluid"], base), [int(k != 0) for k in kind])
            for values, exact in ((page.numbers(plane["pressure"], base), pressure), (page.numbers(plane["u"], base), velocity[0::3]),
                                  (page.numbers(plane["v"], base), velocity[1::3])):
                valued = [(v, e) for v, e, k in zip(values, exact, kind, strict=True) if k in (1, 3)]
                scale = max(abs(e) for _, e in valued) or 1
                self.assertGreater(len(valued), 1500)
                self.assertLess(max(abs(v - e) for v, e in valued), 4e-5 * scale)
            films = self.flat / "films" / f"films_{number:05d}.vtp"
            film = [page.numbers(frame["film"][name], base) for name in ("pressure", "thickness")]
            for values, name in zip(film, ("pressure", "thickness")):
                for value, exact in zip(values, vtk_array(films, name), strict=True):
                    self.assertAlmostEqual(value, exact, delta=1e-6 * abs(exact))
            self.assertGreater(len(film[0]), 10)
        self.check_places(page, self.flat)
        moved = page.numbers(page.json["frames"][2]["placements"], page.json["frames"][2]["base"])
        self.assertGreater(moved[10], 1e-4)

    def check_places(self, page, folder):
        """Every body, moved from its first place, lies where its file of that time has it."""
        dimension = page.json["dimension"]
        for number, frame in enumerate(page.json["frames"]):
            for b, body in enumerate(page.json["bodies"]):
                points, p = page.numbers(body["points"]), page.numbers(frame["placements"], frame["base"])[12 * b:12 * b + 12]
                exact = vtk_array(folder / "bodies" / f"{body['name']}_{number:05d}.vtp", "Points")
                self.assertEqual(len(points) // dimension, len(exact) // 3)
                for i in range(len(points) // dimension):
                    x = points[dimension * i:dimension * (i + 1)]
                    for axis in range(dimension):
                        place = sum(p[3 * axis + k] * x[k] for k in range(dimension)) + p[9 + axis]
                        self.assertAlmostEqual(place, exact[3 * i + axis], delta=1e-6)

    def test_bodies_that_turn(self):
        for dimension, spin in ((2, "2.0"), (3, "[0.5, 1.0, 2.0]")):
            scene = Path(self.folder.name) / f"turning_{dimension}.toml"
            scene.write_text(f"""
                [domain]
                size = {[2] * dimension}
                cells = {[16] * dimension}
                [fluid]
                density = 1
                [[body]]
                name = "blade"
                shape = "box"
                size = {[0.8, 0.4, 0.5][:dimension]}
                position = {[1] * dimension}
                motion = "prescribed"
                angular_velocity = {spin}
                [time]
                end = 0.3
                max_step = 0.1
                [output]
                every = 0.1""")
            out = self.out / str(dimension)
            run(scene, out)
            page = self.page(out)
            self.assertEqual(len(page.json["frames"]), 4)
            self.check_places(page, out)
            last = page.json["frames"][3]
            turned = page.numbers(last["placements"], last["base"])[:9]
            self.assertLess(turned[0] + turned[4] + turned[8], 2.9)  # trace of the rotation: 1 + 2 cos of the angle

    def test_3d_has_surfaces_and_three_slices(self):
        page = self.page(self.solid)
        self.assertEqual(page.json["dimension"], 3)
        self.assertGreater(len(page.numbers(page.json["bodies"][0]["elements"])), 100)
        for number, frame in enumerate(page.json["frames"]):
            self.assertEqual([plane["axis"] for plane in frame["planes"]], [0, 1, 2])
            kind, pressure = (vtk_array(self.solid / "fields" / f"fields_{number:05d}.vti", name) for name in ("kind", "pressure"))
            plane = frame["planes"][1]
            layer = round((plane["position"]) / (6 / 16) - 0.5)
            values, compared = page.numbers(plane["pressure"], frame["base"]), 0
            for k in range(16):
                for i in range(16):
                    cell = i + 16 * (layer + 16 * k)
                    if kind[cell] in (1, 3):
                        compared += 1
                        self.assertAlmostEqual(values[i + 16 * k], pressure[cell], delta=4e-5 * max(map(abs, pressure)))
            self.assertGreater(compared, 150)
            self.assertEqual(len(page.numbers(frame["film"]["elements"], frame["base"])) % 3, 0)
        self.assertGreater(len(page.numbers(page.json["frames"][0]["film"]["elements"], page.json["frames"][0]["base"])), 0)

    def test_the_page_stands_alone_and_is_escaped(self):
        page = self.page(self.flat)
        self.assertEqual(len(re.findall(r"</script", page.text, re.I)), 3)
        self.assertNotIn("<!--", page.text)
        self.assertIn("<h1>plates &lt;/script&gt;&lt;!-- &amp; &quot;co&quot; &lt;b&gt;</h1>", page.text)
        self.assertEqual(page.json["title"], TITLE)
        self.assertEqual(re.findall(r'(?:src|href)="(?!data:)[^"]*"', page.text), [])
        self.assertIn("Content-Security-Policy\" content=\"default-src 'none'", page.text)
        self.assertIn("Permission is hereby granted", page.text)  # licences of the libraries travel along
        self.assertLess(len(page.text), 2e6)
        self.assertEqual(page.json["record"]["status"], "done")
        self.assertIn("stages", page.json["record"]["timings"])
        self.assertEqual(page.json["scene"]["domain"]["cells"], [48, 48])

    def test_another_place_for_the_page(self):
        page = Path(self.folder.name) / "elsewhere.html"
        self.assertEqual(gapflow("report", self.flat, "-o", page).returncode, 0)
        self.assertEqual(Page(page).json["dimension"], 2)
        done = gapflow("report", self.flat, "-o", self.out / "nowhere" / "page.html")
        self.assertEqual(done.returncode, 1)
        self.assertIn("cannot create the file", done.stderr)

    def test_a_run_that_was_killed(self):
        out = self.copy(self.flat)
        for name in ("steps.csv", "bodies.csv", "gaps.csv"):
            lines = (out / name).read_text().splitlines(keepends=True)
            (out / name).write_text("".join(lines[:8]) + lines[8][:9])  # the last line is being written
        (out / "fields" / "fields_00002.vti").unlink()  # in gapflow.pvd, but gone
        record = json.loads((out / "run.json").read_text())
        (out / "run.json").write_text(json.dumps({**record, "status": "running"}))
        page = self.page(out)
        self.assertEqual(page.json["tables"]["of"], 7)
        self.assertEqual(page.json["record"]["status"], "killed")  # no process is recorded
        self.assertEqual([len(frame["planes"]) for frame in page.json["frames"]], [1, 1, 0])

    def test_one_row_and_no_row(self):
        out = self.copy(self.flat)
        for keep in (1, 0):
            for name, header in (("steps.csv", 1), ("bodies.csv", 2), ("gaps.csv", 1)):
                lines = (out / name).read_text().splitlines(keepends=True)
                (out / name).write_text("".join(lines[:1 + keep * header]))
            self.assertEqual(self.page(out).json["tables"]["of"], keep)

    def test_without_fields_films_and_gaps(self):
        run(PLATES, self.out, "domain.cells=[32,32]", "time.end=0.02", "output.fields=[]", "gap.model=none")
        page = self.page(self.out)
        self.assertEqual(page.json["tables"]["gaps"], [])
        frame = page.json["frames"][0]
        self.assertNotIn("pressure", frame["planes"][0])
        self.assertEqual(page.numbers(frame["film"]["pressure"], frame["base"]), [])
        for part in ("fields", "films", "bodies"):
            shutil.rmtree(self.out / part)
        self.assertEqual(self.page(self.out).json["frames"], [])
        (self.out / "gapflow.pvd").unlink()
        self.assertEqual(self.page(self.out).json["frames"], [])

    def test_a_run_of_several_ranks(self):
        run(PLATES, self.out, "domain.cells=[48,48]", "time.end=0.1", "output.every=0.05", launcher=[MPIEXEC, "-n", 2])
        page, alone = self.page(self.out), self.page(self.flat)
        self.assertEqual(page.json["record"]["machine"]["ranks"], 2)
        pressure = [p.numbers(p.json["frames"][2]["planes"][0]["pressure"], p.json["frames"][2]["base"]) for p in (page, alone)]
        scale = max(abs(v) for v in pressure[1] if not math.isnan(v))
        for a, b in zip(*pressure, strict=True):
            self.assertTrue(math.isnan(a) == math.isnan(b) and not abs(a - b) > 1e-3 * scale)

    def test_several_runs_in_one_page(self):
        heavy = self.out.parent / "heavy"
        run(PLATES, heavy, "domain.cells=[48,48]", "time.end=0.1", "output.every=0.05", f"title='{TITLE}'", "body.upper.density=8")
        path = self.out.parent / "both.html"
        done = gapflow("report", self.flat, heavy, "-o", path)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("2 runs, 6 of 6 output times", done.stdout)
        page, alone = Page(path), self.page(heavy)
        self.assertEqual([r["label"] for r in page.json["runs"]], ["body.upper.density = 2", "body.upper.density = 8"])
        second = page.json["runs"][1]
        self.assertEqual(page.numbers(second["tables"]["bodies"][0]["columns"]["vy"]),
                         alone.numbers(alone.json["tables"]["bodies"][0]["columns"]["vy"]))
        frame, same = second["frames"][2], alone.json["frames"][2]
        self.assertEqual(page.numbers(frame["film"]["thickness"], frame["base"]), alone.numbers(same["film"]["thickness"], same["base"]))
        # one scale of colours for all
        ends = [Page(p).json["colours"]["film"] for p in (self.flat / "report.html", heavy / "report.html") if p.exists()]
        self.assertLessEqual(page.json["colours"]["film"]["low"], max(e["low"] for e in ends))
        for words, text in [([self.flat, self.solid], "3D beside one in 2D"), ([self.flat, heavy, "--png"], "pictures are of one run"),
                            ([self.flat, self.out.parent / "nowhere"], "no such folder")]:
            done = gapflow("report", *words)
            self.assertEqual(done.returncode, 2, words)
            self.assertIn(text, done.stderr)

    def test_a_page_of_a_sweep(self):
        out = self.out.parent / "sweep"
        done = gapflow("sweep", PLATES, "-o", out, "--quiet", "--set", "domain.cells=[32,32]", "--set", "time.end=0.02", "--vary",
                       "body.upper.density=2,3", "--vary", "gap.model=film,none", "--jobs", "2")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(gapflow("report", out).returncode, 0)
        page = Page(out / "report.html")
        self.assertEqual([r["label"] for r in page.json["runs"]],
                         [f"body.upper.density = {d}, gap.model = {m}" for d in (2, 3) for m in ("film", "none")])
        sweep = page.json["sweep"]
        self.assertEqual(sweep["keys"], [{"name": "body.upper.density", "values": ["2", "2", "3", "3"]},
                                         {"name": "gap.model", "values": ["film", "none", "film", "none"]}])
        table = rows(out / "sweep.csv")
        names = [column[:-5] for column in table[0] if column.endswith(".last")]
        self.assertEqual(sorted(names), [q["name"] for q in sweep["quantities"]])
        for quantity in sweep["quantities"]:
            for of in ("last", "mean", "min", "max"):
                for shown, row in zip(page.numbers(quantity[of]), table, strict=True):
                    text = row[f"{quantity['name']}.{of}"]  # a run without films has no gap
                    self.assertEqual(math.isnan(shown), text == "")
                    self.assertTrue(text == "" or shown == float(text))
        # without its table: the runs alone; with that of another sweep: refused
        table = (out / "sweep.csv").read_text()
        (out / "sweep.csv").unlink()
        self.assertEqual(gapflow("report", out).returncode, 0)
        self.assertEqual(Page(out / "report.html").json["sweep"]["quantities"], [])
        (out / "sweep.csv").write_text(table.replace("run_002", "run_003", 1))
        done = gapflow("report", out)
        self.assertEqual(done.returncode, 2)
        self.assertIn("sweep.csv: has other runs than sweep.json; start `gapflow sweep` into this folder again", done.stderr)

    def test_what_a_scene_measures_is_in_the_page(self):
        scene, out = self.out.parent / "measured.toml", self.out.parent / "measured"
        scene.write_text(MEASURED)
        run(scene, out)
        self.assertEqual(gapflow("report", out).returncode, 0)
        page = Page(out / "report.html")
        tables = page.json["tables"]

        def agree(entry, table, columns):
            self.assertEqual(page.numbers(entry["time"]), [float(row["time"]) for row in table])
            self.assertGreater(len(table), 2)
            for column in columns:
                for shown, row in zip(page.numbers(entry["columns"][column]), table, strict=True):
                    value = float(row[column])
                    self.assertTrue(math.isclose(shown, value, rel_tol=1e-6, abs_tol=1e-30) or (math.isnan(shown) and math.isnan(value)))

        self.assertEqual([f["name"] for f in tables["fluxes"]], ["outlet", "seldom"])
        for entry in tables["fluxes"]:
            agree(entry, [r for r in rows(out / "fluxes.csv") if r["name"] == entry["name"]], ["flux", "inflow", "outflow", "film", "bodies"])
        self.assertEqual([b["name"] for b in tables["forces"]], ["disk"])
        agree(tables["forces"][0], rows(out / "forces.csv"), ["pressure_fx", "shear_fy", "buoyancy_torque"])
        # of the 11 points of the line six, with both ends
        self.assertEqual([(p["name"], p["points"], p["place"]) for p in tables["probes"]],
                         [("tap", 1, [0.1, 0.5])] + [("line", 11, [1.5, y]) for y in (0.0, 0.2, 0.4, 0.6, 0.8, 1.0)])
        for entry in tables["probes"]:
            agree(entry, [r for r in rows(out / "probes.csv") if r["name"] == entry["name"] and [float(r["x"]), float(r["y"])] == entry["place"]],
                  ["pressure", "u", "v"])
        bare = self.page(self.flat).json["tables"]
        self.assertEqual((bare["fluxes"], bare["probes"], bare["forces"]), ([], [], []))

    def test_long_decimals_of_labels_are_cut_where_the_runs_still_differ(self):
        out = self.out.parent / "decimals"
        for values, labels in [("2.0000001,3.00000001", ["2", "3"]), ("2.0000001,2.0000002", ["2.0000001", "2.0000002"])]:
            done = gapflow("sweep", PLATES, "-o", out / labels[0], "--quiet", "--set", "domain.cells=[32,32]", "--set", "time.end=0.01", "--vary",
                           f"body.upper.density={values}", "--jobs", "2")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(gapflow("report", out / labels[0]).returncode, 0)
            self.assertEqual([r["label"] for r in Page(out / labels[0] / "report.html").json["runs"]], [f"body.upper.density = {v}" for v in labels])

    def test_3d_has_values_of_the_whole_domain_for_slices_that_move(self):
        page = self.page(self.solid)
        frame = page.json["frames"][1]
        volume = frame["volume"]
        self.assertEqual((volume["cells"], volume["low"], volume["spacing"]), ([16] * 3, [0] * 3, 6 / 16))
        pressure = vtk_array(self.solid / "fields/fields_00001.vti", "pressure")
        shown = page.numbers(volume["pressure"], frame["base"])
        there = [(a, b) for a, b in zip(shown, pressure, strict=True) if not math.isnan(a)]
        self.assertGreater(len(there), 3000)
        self.assertLess(len(there), len(shown))  # the ball has none
        width = max(b for _, b in there) - min(b for _, b in there)
        self.assertLess(max(abs(a - b) for a, b in there), 1e-4 * width)

    def test_pictures(self):
        for folder, frames in ((self.flat, 3), (self.solid, 3)):
            done = gapflow("report", folder, "--png")
            self.assertEqual(done.returncode, 0, done.stderr)
            pictures = sorted((folder / "frames").iterdir())
            self.assertEqual(done.stdout.split(), [str(path) for path in pictures])
            self.assertEqual(len(pictures), frames)
            for picture in pictures:
                content = picture.read_bytes()
                self.assertEqual(content[:8], b"\x89PNG\r\n\x1a\n")
                width, height = struct.unpack(">II", content[16:24])
                self.assertTrue(600 < width < 1200 and 300 < height < 1200)
                self.assertLess(len(content), 150_000)
            self.assertNotEqual(pictures[0].read_bytes(), pictures[-1].read_bytes())

    def test_what_is_no_run_is_status_2_with_the_reason(self):
        empty = Path(self.folder.name) / "empty"
        empty.mkdir()
        damaged = self.copy(self.flat)
        (damaged / "fields" / "fields_00001.vti").write_text((damaged / "fields" / "fields_00001.vti").read_text()[:900])
        cases = [(["report"], "directory is required"), (["report", "nowhere"], "nowhere: no such folder"),
                 (["report", empty], "it has no run.json"), (["report", PLATES], "no such folder"),
                 (["report", damaged], "fields_00001.vti"), (["report", damaged, "--png"], "fields_00001.vti"),
                 (["report", self.flat, "--png", "-o", "page.html"], "excludes")]
        for words, text in cases:
            with self.subTest(words):
                done = gapflow(*words)
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertIn(text, done.stderr)
        for content in ("", "{}", '{"scene": "{}"}', '{"scene": 3}', "no json"):
            (empty / "run.json").write_text(content)
            done = gapflow("report", empty)
            self.assertEqual(done.returncode, 2, content)
            self.assertIn("not the record of a Gapflow run", done.stderr)
        (damaged / "fields" / "fields_00001.vti").unlink()
        (damaged / "steps.csv").write_text("step,time\n0,0\n1\n")
        done = gapflow("report", damaged)
        self.assertEqual(done.returncode, 2)
        self.assertIn("steps.csv:3: has 1 columns", done.stderr)
        for part in ("fields", "bodies", "films"):
            shutil.rmtree(damaged / part)
        (damaged / "steps.csv").write_text("step,time\n0,0\n")
        done = gapflow("report", damaged, "--png")
        self.assertEqual(done.returncode, 2)
        self.assertIn("there is no output time to draw", done.stderr)

    def test_help(self):
        done = gapflow("report", "--help")
        for word in ("--png", "--output", "DIR/report.html", "needs no"):
            self.assertIn(word, done.stdout)


if __name__ == "__main__":
    unittest.main()
