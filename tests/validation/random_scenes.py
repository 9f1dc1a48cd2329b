"""Random scenes of bodies that touch, 200 steps each with the default settings: they run, none crawls, and no energy comes from nowhere.

Scenes are made in random_scene_kinds.py and follow from their number alone: 0 to 299 in 2D, 300 to 359 in 3D, 360 to 499 attacks of other kinds.
    python3 random_scenes.py run NUMBERS|A-B... [--out FILE.jsonl] [--jobs N] [--limit SECONDS] [--save FOLDER] [--reynolds LEAST LARGEST] [--parts]
    python3 random_scenes.py judge FILE.jsonl...        what failed, by kind; what is slow among its kind
    python3 random_scenes.py show N                     the scene on the screen, its meshes into the current folder
`run` appends a JSON line a scene to FILE; scenes that FILE has already are left out, so a batch that was stopped goes on.

Energy is that of fluid, bodies and springs and what reduced weight (m - rho V) g and constant forces can still give. In a closed tank it
may only fall: it must not rise above its start by more than 2 % of the largest kinetic energy so far. (That counts at least as a twentieth of
the run's largest, and as what weight gives over a quarter of a cell: the first step, which knows no acceleration yet, is of first order.) Overlaps at the start may lift bodies when they
are taken out, by a cell and a half within five steps. Open sides do work too: there kinetic energy must stay below three times what start, weight, forces
and prescribed motion give.
"""
import argparse
import json
import math
import os
import resource
import signal
import statistics
import subprocess
import sys
import tempfile
import time
from collections import defaultdict
from concurrent.futures import ProcessPoolExecutor, as_completed
from pathlib import Path

import numpy as np

import harness
import random_scene_kinds as kinds
from harness import Row

SECTION = "Random scenes of touching bodies"
STEPS, LIMIT = kinds.STEPS, 120    # steps, seconds of the processor
ENERGY, DRIVEN = 0.02, 3.0         # of the largest kinetic energy; of what drives
LEAST = 0.25                       # cells: what weight gives over this way is the least energy that counts as large
COLLAPSED, CRAWLING = 1e-3, 1e-3   # of the median step; the median step of max_step
JUMP = 2                           # cells in a step
SLOW, ENOUGH = 10, 20              # times the median of the kind; steps, fewer are mostly the start


# ---- running

def steps_so_far(table):
    """Rows after the start in a steps.csv that is being written."""
    try:
        return max(0, table.read_bytes().count(b"\n") - 2)
    except FileNotFoundError:
        return 0


def processor_seconds(process):
    """That a running process has used; 0 where the system does not tell."""
    try:
        fields = Path(f"/proc/{process.pid}/stat").read_text().rpartition(")")[2].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
    except (OSError, IndexError):
        return 0.0


def run_some_steps(file, out, limit):
    """Runs a scene until it has STEPS steps, an end or no more time (`limit` of the processor, ten times it at all): (exit status or None, standard error, seconds of the processor)."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    with open(out.parent / "stderr.txt", "w+") as errors:
        process = subprocess.Popen([harness.COMMAND, "run", file, "-o", out, "--quiet"], stderr=errors, stdout=subprocess.DEVNULL,
                                   env={"OMP_NUM_THREADS": "1", **harness.single_process()})
        deadline, asked, late = time.monotonic() + 10 * limit, False, False
        while process.poll() is None:
            time.sleep(0.03)
            if not asked and steps_so_far(out / "steps.csv") >= STEPS:
                process.send_signal(signal.SIGINT)
                asked, deadline = True, time.monotonic() + 30
            if time.monotonic() > deadline or (not asked and processor_seconds(process) > limit):
                late = not asked    # one that has its steps and does not end has done what it should
                process.kill()
        errors.seek(0)
        text = errors.read()
    now = resource.getrusage(resource.RUSAGE_CHILDREN)
    status = 0 if asked and process.returncode in (128 + signal.SIGINT, -signal.SIGKILL, 0) else None if late else process.returncode
    return status, text, now.ru_utime + now.ru_stime - used.ru_utime - used.ru_stime


def rows_before(table, step):
    return [row for row in harness.read_table(table) if row["step"] <= step] if table.exists() else []


# ---- judging

class Energies:
    """Of a run, from its tables: kinetic, and what weight and constant forces can still give, per step; and what drives it."""

    def __init__(self, tank, steps, bodies):
        dimension, axes = tank.dimension, "xyz"[:tank.dimension]
        entries = {body.name: (body.keys, body.shape.volume) for body in tank.bodies}
        potential, springs = defaultdict(float), defaultdict(float)
        self.lift = self.start = self.least = 0.0
        self.driven = tank.carried
        for name, (keys, volume) in entries.items():
            mass, fluid = keys.get("density", tank.rho) * volume, tank.rho * volume
            velocity = np.array(keys.get("velocity", [0.0] * dimension))
            spin = np.linalg.norm(np.atleast_1d(keys.get("angular_velocity", 0.0))) * next(b.shape.extent for b in tank.bodies if b.name == name)
            if keys.get("motion", "free") != "fixed":
                self.start += 0.5 * (mass + 2 * fluid) * (float(velocity @ velocity) + spin**2)
            if keys.get("motion", "free") == "free":
                pull = (mass - fluid) * tank.gravity + np.array(keys.get("force", [0.0] * dimension))
                self.least += LEAST * tank.dx * float(np.linalg.norm(pull))
                if tank.kind == "overlapping":
                    self.lift += 1.5 * tank.dx * float(np.linalg.norm(pull))
                for row in bodies:
                    if row["body"] == name:
                        x = np.array([row[a] for a in axes])
                        potential[row["step"]] -= float(pull @ x)
                        if "spring" in keys:
                            springs[row["step"]] += 0.5 * keys["spring"]["stiffness"] * float(np.sum((x - keys["spring"]["anchor"])**2))
        numbers = [row["step"] for row in steps]
        self.whole = np.array([row["energy_fluid"] + row["energy_bodies"] + potential[row["step"]] for row in steps])
        self.kinetic = np.array([row["energy_fluid"] + row["energy_bodies"] - springs[row["step"]] for row in steps])
        if self.lift > 0:    # what the first steps have taken of it
            self.lift = min(self.lift, max(0.0, float((self.whole[:6] - self.whole[0]).max())))
        work = [potential[numbers[0]] + springs[numbers[0]] - potential[n] for n in numbers]
        self.driven += 2 * self.start + self.least + np.maximum.accumulate(np.maximum(work, 0.0))


def judge_energy(tank, steps, bodies, record):
    """Puts the figures of energy into the record; returns the defects."""
    energies = Energies(tank, steps, bodies)
    kinetic, defects = np.maximum(energies.kinetic, 0.0), []
    if kinetic[0] > 10 * energies.start + 1e-12 * kinetic.max():
        defects.append(f"starts with {kinetic[0] / max(energies.start, 1e-300):.3g} times the energy that velocities bring")
        record["start_energy"] = kinetic[0] / max(energies.start, 1e-300)
    if kinetic.max() <= 0:
        return defects
    if tank.judge == "energy":
        largest = np.maximum(np.maximum.accumulate(kinetic), max(0.05 * kinetic.max(), energies.least))
        rise = (energies.whole - energies.whole[0] - energies.lift) / largest
        from_lowest = (energies.whole - np.minimum.accumulate(energies.whole)) / largest
        allowed, text = ENERGY, "energy rises by {:.3g} % of the largest kinetic energy"
        record["rise_from_lowest"] = 100 * float(from_lowest.max())
        record["rise_plain"] = 100 * float((energies.whole - energies.whole[0] - energies.lift).max() / kinetic.max())
    else:
        rise = (kinetic - DRIVEN * energies.driven) / np.maximum(DRIVEN * energies.driven, 1e-300)
        allowed, text = 0.0, "kinetic energy exceeds three times what drives by {:.3g} %"
    worst = int(rise.argmax())
    record.update(rise=100 * float(rise[worst]), rise_step=int(steps[worst]["step"]), rise_time=steps[worst]["time"])
    if rise[worst] > allowed:
        first = int(np.argmax(rise > allowed))
        record["rise_first"] = int(steps[first]["step"])
        defects.append(text.format(100 * rise[worst]) + f" (step {steps[worst]['step']:.0f}, first above at {steps[first]['step']:.0f})")
    return defects


def judge_steps(steps, scene, record, near_longest):
    """`near_longest`: whether max_step is what a body's way allows."""
    dts = [row["dt"] for row in steps[1:]]
    median, most = statistics.median(dts), scene["time"]["max_step"]
    small = sum(dt < COLLAPSED * median for dt in dts)
    record.update(dt_median=median / most, dt_min=min(dts) / most, dt_mean=statistics.fmean(dts) / most, small_steps=small,
                  iterations_mean=statistics.fmean(row["iterations"] for row in steps[1:]), iterations_max=max(row["iterations"] for row in steps[1:]))
    defects = []
    if small:
        defects.append(f"{small} steps below a thousandth of the median, the least {min(dts) / median:.1e} of it")
    if near_longest and median < CRAWLING * most:
        defects.append(f"crawls: the median step is {median / most:.1e} of max_step")
    return defects


def not_finite(tables):
    return [f"not finite: {name}.csv {key} at step {row['step']:.0f}" for name, table in tables.items() for row in table
            for key, value in row.items() if isinstance(value, float) and not math.isfinite(value)][:1]


def deepest(tank, gaps):
    """Overlaps deeper than the tank allows, of pairs that start apart or in touch."""
    if tank.overlap is None or not gaps:
        return []
    row = min(gaps, key=lambda row: row["thickness"])
    depth = -row["thickness"] / tank.dx
    return [f"{row['body_a']} and {row['body_b']} overlap by {depth:.3g} cells in step {row['step']:.0f}"] if depth > tank.overlap else []


def thrown(tank, bodies):
    """Bodies in the tank that a step moves by more than JUMP cells. (One that has left through an open side only falls.)"""
    reach = {body.name: body.shape.extent for body in tank.bodies}
    last = {}
    for row in bodies:
        x = np.array([row[a] for a in "xyz"[:tank.dimension]])
        way = np.abs(x - last.get(row["body"], x)).max() / tank.dx
        outside = (last.get(row["body"], x) < -reach[row["body"]]).any() or (last.get(row["body"], x) > tank.size + reach[row["body"]]).any()
        if JUMP < way < 0.5 * min(tank.cells) and not outside:    # more: from one end of a periodic tank to the other
            return [f"{row['body']} moves {way:.3g} cells in step {row['step']:.0f}"]
        last[row["body"]] = x
    return []


def examine(number, limit=LIMIT, save=None, reynolds=None, parts=False):
    """Runs a scene; a record of what it did, "defects" being a list of short texts, empty when all is well (slowness is judged among a kind)."""
    with tempfile.TemporaryDirectory() as folder:
        scene, tank = kinds.make(number, folder, reynolds)
        if parts:
            scene = harness.on_parts(scene, reynolds is not None)
        file, out = Path(folder) / "scene.toml", Path(folder) / "out"
        file.write_text(harness.scene_text(scene))
        start = time.monotonic()
        status, errors, processor = run_some_steps(file, out, limit)
        record = {"number": number, "kind": tank.kind, "dimension": tank.dimension, "cells": tank.cells, "viscous": tank.reynolds is not None,
                  "bodies": len(tank.bodies), "exit": status, "seconds": time.monotonic() - start, "processor": processor}
        lines = [line.strip() for line in errors.splitlines() if line.strip()]
        record["warnings"] = [line[:300] for line in lines if "warning:" in line and "interrupted" not in line]
        failures = [line.replace(str(folder) + "/", "") for line in lines if "warning:" not in line]
        tables = {name: rows_before(out / f"{name}.csv", STEPS) for name in ("steps", "bodies", "gaps")}
        steps = tables["steps"]
        record.update(steps=max(0, len(steps) - 1), time=steps[-1]["time"] if steps else 0.0)
        record["seconds_per_step"] = processor / max(1, record["steps"])
        defects = []
        if status != 0:
            record["message"] = f"not done in {limit} s, at step {record['steps']}" if status is None else f"exit {status}: " + " ".join(failures)[-400:]
            defects.append(record["message"])
        defects += not_finite(tables)
        if len(steps) > 1:
            defects += judge_steps(steps, scene, record, tank.overlap is None)
            if not any("not finite" in defect for defect in defects):
                defects += deepest(tank, tables["gaps"])
                if tank.overlap is None:    # else steps are meant to be long
                    defects += thrown(tank, tables["bodies"])
                if tank.judge:
                    defects += judge_energy(tank, steps, tables["bodies"], record)
        defects += sorted({line for line in record["warnings"] if "settle" in line})
        record["defects"] = defects
        if save and defects:
            Path(save).mkdir(parents=True, exist_ok=True)
            show(number, save, reynolds)
    return record


def slow_ones(records):
    """{number: times the median seconds a step of its kind and dimension}, of those that are too slow."""
    groups = defaultdict(list)
    for record in records:
        if record["steps"] >= ENOUGH:
            groups[record["kind"], record["dimension"]].append(record)
    found = {}
    for group in groups.values():
        median = statistics.median(record["seconds_per_step"] for record in group)
        found.update({record["number"]: record["seconds_per_step"] / median for record in group if record["seconds_per_step"] > SLOW * median})
    return found


def rows_of(records):
    """A Row a kind and dimension."""
    slow, groups = slow_ones(records), defaultdict(list)
    for record in sorted(records, key=lambda r: r["number"]):
        if record["number"] in slow:
            record = {**record, "defects": [*record["defects"], f"{slow[record['number']]:.0f} times slower than the median of its kind"]}
        groups[record["kind"], record["dimension"]].append(record)
    for (kind, dimension), group in sorted(groups.items(), key=lambda item: (item[0][1], [*kinds.KINDS, *kinds.ATTACK_KINDS].index(item[0][0]))):
        bad = [record for record in group if record["defects"]]
        target = f"{STEPS} steps, none slow; " + ("energy rises by no more than 2 %" if kind not in ("dry", "leaving", "entering") else "speeds bounded")
        yield Row(SECTION, f"{kind}, {dimension}D: {len(group)} scenes", target,
                  "; ".join([f"{len(group) - len(bad)} of {len(group)}"] + [f"{r['number']}: {', '.join(r['defects'])}"[:160] for r in bad]), not bad)


def case_of(kind):
    def case(quick):
        if quick:
            return    # minutes; tests of single defects are among those of units and of the command
        numbers = [n for n in range(kinds.FIRST_ATTACK + kinds.ATTACKS) if kinds.kind_of(n) == kind]
        yield from rows_of([examine(number) for number in numbers])
    case.__name__ = f"random_{kind}"
    return case


ALL = [case_of(kind) for kind in [*kinds.KINDS, *kinds.ATTACK_KINDS]]


# ---- command line

def show(number, folder, reynolds=None):
    """The scene and its meshes into a folder, as scene_N.toml, their names made the scene's own; returns its text."""
    with tempfile.TemporaryDirectory() as made:
        scene, _ = kinds.make(number, made, reynolds)
        for body in scene["body"]:
            if "file" in body:
                own = f"scene_{number}_{body['file']}"
                (Path(folder) / own).write_text((Path(made) / body["file"]).read_text())
                body["file"] = own
    text = harness.scene_text(scene)
    (Path(folder) / f"scene_{number}.toml").write_text(text)
    return text


def told(record):
    figures = f"{record['steps']} steps, {1e3 * record['seconds_per_step']:.1f} ms a step, dt {record.get('dt_median', 0):.2g} least {record.get('dt_min', 0):.1e}, " \
              f"iterations {record.get('iterations_mean', 0):.1f} most {record.get('iterations_max', 0):.0f}, rise {record.get('rise', 0):+.2g} % at {record.get('rise_step', 0)}"
    head = f"{record['number']} {record['kind']} {record['dimension']}D {'viscous' if record['viscous'] else 'ideal'} {'x'.join(map(str, record['cells']))}"
    return f"{head}: " + ("FAIL " + "; ".join(record["defects"]) if record["defects"] else "ok") + f"  [{figures}]"


def numbers_of(words):
    for word in words:
        first, _, last = word.partition("-")
        yield from range(int(first), int(last or first) + 1)


def run_command(options):
    known = {json.loads(line)["number"] for line in options.out.read_text().splitlines()} if options.out and options.out.exists() else set()
    numbers, failed = [n for n in numbers_of(options.number) if n not in known], 0
    with ProcessPoolExecutor(options.jobs) as pool:    # a process each: the processor's seconds are those of one scene
        for task in as_completed([pool.submit(examine, number, options.limit, options.save, options.reynolds, options.parts) for number in numbers]):
            record = task.result()
            failed += bool(record["defects"])
            print(told(record), flush=True)
            if options.out:
                with open(options.out, "a") as file:
                    file.write(json.dumps(record) + "\n")
    return 1 if failed else 0


def judge_command(options):
    records = list({r["number"]: r for file in options.file for r in map(json.loads, file.read_text().splitlines())}.values())
    rows = list(rows_of(records))
    for row in rows:
        print("ok  " if row.ok else "MISS", row.case + ":", row.measured.replace("; ", "\n       "))
    rising = sorted((r for r in records if r.get("rise_first") is not None), key=lambda r: -r["rise"])
    print("\nenergy above its bound, worst first:", " ".join(f"{r['number']} ({r['rise']:.3g} %)" for r in rising) or "none")
    print("slow among their kind:", " ".join(f"{n} ({times:.0f}x)" for n, times in slow_ones(records).items()) or "none")
    good = sum(not r["defects"] for r in records) - sum(r["number"] in slow_ones(records) and not r["defects"] for r in records)
    print(f"{good} of {len(records)} scenes have no defect")
    return 0 if good == len(records) else 1


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    run = commands.add_parser("run")
    run.add_argument("number", nargs="+", help="N or A-B")
    run.add_argument("--out", metavar="FILE", type=Path, help="a JSON line a scene is appended; scenes in it are left out")
    run.add_argument("--jobs", metavar="N", type=int, default=1)
    run.add_argument("--limit", metavar="SECONDS", type=float, default=LIMIT, help="of the processor, for a scene")
    run.add_argument("--reynolds", metavar=("LEAST", "LARGEST"), nargs=2, type=float, help="between these instead of a scene's own, all fluid viscous")
    run.add_argument("--save", metavar="FOLDER", help="scenes with defects go here")
    run.add_argument("--parts", action="store_true", help="gap.model = \"parts\", without jets; ideal fluid without vapour pressure, at rest at the start, but with --reynolds")
    judge = commands.add_parser("judge")
    judge.add_argument("file", nargs="+", type=Path)
    commands.add_parser("show").add_argument("number", type=int)
    options = parser.parse_args()
    if options.command == "show":
        print(show(options.number, os.getcwd()))
        return 0
    return run_command(options) if options.command == "run" else judge_command(options)


if __name__ == "__main__":
    sys.exit(main())
