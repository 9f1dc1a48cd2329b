"""Runs the gapflow command on scenes made here, and collects rows of measured against exact.

A module of cases has ALL, a list of generators of Row that take `quick`: the few that every change must pass (minutes); else all.
"""
import csv
import json
import math
import os
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
REFERENCE = ROOT / "tests" / "data" / "reference"
COMMAND = os.environ.get("GAPFLOW", str(ROOT / "build" / "release" / "apps" / "gapflow"))
MODEL = None             # gap.model of the scenes that name none; None: the program's default
PICTURES = {}            # Markdown shown under a section's heading, set by the modules that have pictures
PICTURE_FOLDER = None    # where cases draw them; None: they do not


@dataclass
class Row:
    section: str    # heading in docs/validation.md
    case: str       # what, with resolution and parameters
    target: str     # as text; "" if only reported
    measured: str
    ok: bool        # True where there is no target


def toml(value):
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return json.dumps(value)
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(toml(v) for v in value) + "]"
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{k} = {toml(v)}" for k, v in value.items()) + " }"
    return repr(float(value)) if not isinstance(value, int) else str(value)


def on_parts(scene, viscous=True):
    """The scene with gap.model = "parts", of ideal fluid if not `viscous`, without what such runs have not or ignore."""
    def kept(table):
        return {key: value for key, value in table.items() if key not in ("exit", "entrance_loss", "threshold")}
    left_out = () if viscous else ("viscosity", "vapour_pressure", "velocity")
    scene = {**scene, "gap": {**kept(scene.get("gap", {})), "model": "parts"}}
    if "fluid" in scene:
        scene["fluid"] = {key: value for key, value in scene["fluid"].items() if key not in left_out}
    if "pair" in scene:
        scene["pair"] = [kept(pair) for pair in scene["pair"]]
    return scene


def scene_text(scene):
    """TOML of {"domain": {...}, "body": [{...}], ...}, on MODEL where it names no model; a dict of dicts becomes tables, a list of dicts array tables."""
    if MODEL == "parts" and "model" not in scene.get("gap", {}):
        scene = on_parts(scene)
    lines = [f"{k} = {toml(v)}" for k, v in scene.items() if not isinstance(v, dict) and k not in ("body", "pair", "probe")]
    for name, table in scene.items():
        if isinstance(table, dict):
            lines.append(f"\n[{name}]")
            lines += [f"{k} = {toml(v)}" for k, v in table.items()]
        elif name in ("body", "pair", "probe"):
            for entry in table:
                lines.append(f"\n[[{name}]]")
                lines += [f"{k} = {toml(v)}" for k, v in entry.items()]
    return "\n".join(lines) + "\n"


def single_process():
    """Environment of one process: no MPI daemon and nothing shared with other runs, a quarter of the start-up time."""
    return {**os.environ, "OMPI_MCA_plm": "isolated", "OMPI_MCA_ess_singleton_isolated": "1", "OMPI_MCA_orte_create_session_dirs": "0",
            "OMPI_MCA_pml": "ob1", "OMPI_MCA_btl": "self"}


def command(args, ranks=1, check=True, timeout=1800):
    words = [COMMAND, *map(str, args)]
    env = single_process()
    if ranks > 1:
        words = ["mpirun", "-n", str(ranks), *words]
        env = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1", OMPI_MCA_rmaps_base_oversubscribe="1",
                   OMPI_MCA_hwloc_base_binding_policy="none", OMPI_MCA_pml="ob1", OMPI_MCA_btl="self,vader")
    done = subprocess.run(words, env=env, capture_output=True, text=True, timeout=timeout)
    if check and done.returncode != 0:
        raise RuntimeError(f"{' '.join(words)}: exit {done.returncode}\n{done.stderr[-2000:]}")
    return done


def added_mass(scene, ranks=1, accelerations=False):
    """The parsed JSON of `gapflow added-mass --json` for a scene."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "scene.toml"
        file.write_text(scene_text(scene))
        return json.loads(command(["added-mass", file, "--json", *(["--accelerations"] if accelerations else [])], ranks).stdout)


def smooth(scene):
    """The scene with surfaces of no roughness unless it gives one: exact solutions are for such, in gaps of any thickness."""
    return {**scene, "gap": {"roughness": 0.0, **scene.get("gap", {})}}


def run(scene, ranks=1, look=None):
    """Runs a scene with smooth surfaces; returns {"bodies": rows, "gaps": rows, "steps": rows}, each a list of dicts of floats and strings. `look`, if
    given, is called with the output folder while it exists; what it returns is "look"."""
    with tempfile.TemporaryDirectory() as folder:
        file, out = Path(folder) / "scene.toml", Path(folder) / "out"
        file.write_text(scene_text(smooth(scene)))
        command(["run", file, "-o", out, "--quiet"], ranks)
        result = {name: read_table(out / f"{name}.csv") for name in ("bodies", "gaps", "steps")}
        if look:
            result["look"] = look(out)
        return result


def unit_figures(program, test, **environment):
    """{name: text} that a unit test recorded, and whether it passed; `environment`: further variables that it reads."""
    executable = Path(COMMAND).parents[1] / "tests" / program
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "result.json"
        subprocess.run([executable, f"--gtest_filter={test}", f"--gtest_output=json:{file}"], capture_output=True, timeout=1800,
                       env={**single_process(), **environment})
        found = json.loads(file.read_text())["testsuites"]
    tests = [entry for suite in found for entry in suite["testsuite"]]
    if len(tests) != 1:
        raise RuntimeError(f"{executable} has no test {test}")
    return tests[0], "failures" not in tests[0]


def volume(body, dimension):
    """Of a body of a scene (2D: area)."""
    if body["shape"] == "box":
        return math.prod(body["size"])
    r, length = body["radius"], body.get("length", 0)
    if dimension == 2:
        return math.pi * r**2 + (2 * r * length if body["shape"] == "capsule" else 0)
    round_part = 4 / 3 * math.pi * r**3 if body["shape"] in ("ball", "capsule") else 0
    return round_part + math.pi * r**2 * length


def read_table(path):
    def number(text):
        try:
            return float(text)
        except ValueError:
            return text
    with open(path) as f:
        return [{k: number(v) for k, v in row.items()} for row in csv.DictReader(line for line in f if not line.startswith("#"))]
