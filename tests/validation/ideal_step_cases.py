"""Runs of ideal fluid with gap.model = "parts": bodies that coast, spin, are pulled apart, pile up."""
import math

import harness
import motion_cases as motion
import random_scenes
from harness import Row

COASTING = "Ideal fluid on parts: bodies that coast far from walls"
PLATES = "Ideal fluid on parts: plates and cylinders pulled apart"
SPIN = "Ideal fluid on parts: a box that spins"
VORTICES = "Ideal fluid on parts: vortices"
SCENES = "Ideal fluid on parts: random scenes of touching bodies"
PARTS = {"model": "parts", "roughness": 0.0}


def coasting(dimension, radius, density, cfl, angle):
    """Three diameters; `radius` in cells; the domain is 16 (3D 10) radii wide, far on all sides."""
    cells = round(radius * (16 if dimension == 2 else 10))
    dx = 1.0 / cells
    r = radius * dx
    way = [math.cos(angle), math.sin(angle)] if dimension == 2 else [math.cos(angle) * math.cos(0.4), math.sin(angle) * math.cos(0.4), math.sin(0.4)]
    start = [0.5 - 3 * r * c + 0.0137 * (k + 1) * dx for k, c in enumerate(way)]
    sides = {f"{axis}_{end}": "far" for axis in "xyz"[:dimension] for end in ("low", "high")}
    result = harness.run({
        "domain": {"size": [1.0] * dimension, "cells": [cells] * dimension, "sides": sides}, "gap": PARTS,
        "body": [{"name": "b", "shape": "ball", "radius": r, "density": density, "position": start, "velocity": way}],
        "time": {"end": 6 * r, "max_step": 1.0, "cfl": cfl}, "output": {"every": 6 * r}})
    speeds = [math.sqrt(sum(row[k] ** 2 for k in ("vx", "vy", "vz") if k in row)) for row in result["bodies"]]
    energy = [row["energy_fluid"] + row["energy_bodies"] for row in result["steps"]]
    corrected = sum(row["corrected_energy"] for row in result["steps"])
    return [s / speeds[0] - 1 for s in speeds], energy[-1] / energy[0] - 1, corrected / energy[0]


def coasting_cases(quick):
    limits = {2.0: (0.015, 0.03), 3.2: (0.005, 0.015), 6.4: (0.002, 0.005)}
    for dimension, name in ((2, "disk"), (3, "ball")):
        for radius, (speed, energy) in limits.items():
            if (quick and radius != 3.2) or (quick and dimension == 3):
                continue
            few = quick or (dimension == 3 and radius == 6.4)    # minutes each
            densities, cfls, angles = ((1.0,), (1.0,), (0.3,)) if few else ((0.1, 1.0, 10.0), (0.5, 1.0), (0.0, 0.3, math.pi / 4, 1.1, 2.0))
            runs = [coasting(dimension, radius, density, cfl, angle) for density in densities for cfl in cfls for angle in angles]
            errors = [error for run in runs for error in run[0]]
            yield Row(COASTING, f"{name}, {radius:g} cells a radius, {len(runs)} runs: speed over that of the start", f"within ±{speed:.1%}",
                      f"{min(errors):+.2%} … {max(errors):+.2%}", max(map(abs, errors)) <= speed)
            kept = max(abs(run[1]) for run in runs)
            yield Row(COASTING, f"{name}, {radius:g} cells a radius: energy", "<= 0.01 %", f"{kept:.4%}", kept <= 1e-4)
            if not quick:
                lost = [-run[2] for run in runs]
                yield Row(COASTING, f"{name}, {radius:g} cells a radius: energy without the correction", f"within ±{energy:.1%}",
                          f"{min(lost):+.2%} … {max(lost):+.2%}", max(map(abs, lost)) <= energy)


def spinning_cases(quick):
    """A turn of a 4:1 box in a closed square at 32² against 64². No motion of its middle is exact: what the grid gives it is taken from the spin."""
    def turn(length, cells):
        result = harness.run({
            "domain": {"size": [1.0, 1.0], "cells": [cells, cells]}, "gap": PARTS,
            "body": [{"name": "b", "shape": "box", "size": [length, length / 4], "density": 1.0, "position": [0.51, 0.507], "angular_velocity": 1.0}],
            "time": {"end": 2 * math.pi, "max_step": 1.0, "cfl": 0.5}, "output": {"every": 2 * math.pi}})
        return result["bodies"][-1]["omega"], result["bodies"][-1]["angle"]

    if quick:
        return
    for length in (0.48, 0.25):
        (spin, angle), (fine_spin, fine_angle) = (turn(length, cells) for cells in (32, 64))
        yield Row(SPIN, f"4:1 box of {32 * length:.0f} cells, a turn, 32² against 64²: spin; angle", "within ±1 %; ±1 %",
                  f"{spin / fine_spin - 1:+.2%}; {angle / fine_angle - 1:+.2%}", max(abs(spin / fine_spin - 1), abs(angle / fine_angle - 1)) <= 0.01)


def plates_cases(quick):
    for cells in (64,) if quick else (64, 128):
        rows = motion.plates_pulled_apart(cells, gap=PARTS, end=0.5 if quick else 0.915)
        early = motion.worst(error for _, h, error in rows if h < 0.03)
        limit = {64: 0.004, 128: 0.0015}[cells]
        yield Row(PLATES, f"two rectangles (example 01), {cells}²: h(t) while h < 0.03", f"<= {limit:.2%}", f"{early:.2%}", early <= limit)
    if quick:
        return
    for cells in (48, 96):
        scene = motion.changed(motion.example("02"), domain={"cells": [cells, cells]}, gap=PARTS, time={"end": 3.39, "max_step": 1.92 / cells, "gap_cfl": 0.25, "cfl": 0.5})
        rows = motion.gap_errors(harness.run(scene), ("right", "left"), 2.0, "I6_cylinders_from_contact_box8.csv", 3.39)
        error = motion.worst(e for t, _, e in rows if t >= 0.3)
        yield Row(PLATES, f"cylinders from contact (example 02), {cells}²: h(t) from t = 0.3", "<= 0.4 %", f"{error:.2%}", error <= 0.004)
    # No exact solution: the finer grid.
    ends = {}
    for cells in (36, 54):
        result = harness.run(motion.changed(motion.example("03"), domain={"cells": [cells] * 3}, gap=PARTS))
        upper, lower = (track[-1] for track in motion.tracks(result).values())
        energy = [row["energy_fluid"] + row["energy_bodies"] for row in result["steps"]]
        ends[cells] = (upper["z"] - lower["z"] - 0.25, 0.5 * (upper["vz"] - lower["vz"]), sum(row["corrected_energy"] for row in result["steps"]) / energy[-1])
    gap, speed = (ends[36][k] / ends[54][k] - 1 for k in (0, 1))
    yield Row(PLATES, "square plates (example 03), 36³ against 54³, at t = 0.4: gap, speed", "within ±1 %, -1.5 … +0.5 %", f"{gap:+.2%}, {speed:+.2%} (corrected energy {ends[36][2]:+.2%})",
              abs(gap) <= 0.01 and -0.015 <= speed <= 0.005)


def random_cases(quick):
    """Touching, rolling, edges and funnels: they run 200 steps, and energy rises by no more than 2 % of the largest kinetic energy so far. A step whose forces do not settle is a defect, too."""
    if quick:
        return
    records = [random_scenes.examine(number, parts=True) for number in range(300) if number % 15 in (0, 4, 7, 8)]
    bad = [record for record in records if record["defects"]]
    ended = [record for record in records if record["exit"] != 0]
    yield Row(SCENES, f"{len(records)} scenes in 2D, 200 steps: without an error", "all", f"{len(records) - len(ended)} of {len(records)}", not ended)
    yield Row(SCENES, f"{len(records)} scenes in 2D, 200 steps: energy rises by <= 2 %, forces settle", "all",
              "; ".join([f"{len(records) - len(bad)} of {len(records)}"] + [f"{r['number']}: {', '.join(r['defects'])}"[:90] for r in bad]), not bad)


def vortex_cases(quick):
    """Flows with vorticity; figures of the unit tests."""
    if quick:
        return
    for dimension, name, cells in ((2, "Taylor–Green vortices", "16, 32"), (3, "an ABC flow", "8, 16")):
        found, passed = harness.unit_figures("unit_step", f"Circulation.VorticesAreCarriedAlong{dimension}D")
        order, energy = float(found["order"]), float(found["energy"])
        case = f"{name} carried by a uniform flow, {cells} cells a period, Courant number 0.5: "
        yield Row(VORTICES, case + "order (errors)", ">= 1.8", f"{order:.2f} ({found['errors']})", passed and order >= 1.8)
        yield Row(VORTICES, case + "energy", "within ±0.5 %", f"{energy:.3%}", passed and energy <= 5e-3)
        if dimension == 2:
            ratio = float(found["far_error"]) / float(found["one_error"])
            yield Row(VORTICES, "the same, 32 cells, Courant number 4: error over that at 1; energy", "<= 3; no gain above 0.5 %",
                      f"{ratio:.1f}; {float(found['far_energy']):.3%}", passed and ratio <= 3 and float(found["far_energy"]) <= 5e-3)
    found, passed = harness.unit_figures("unit_step", "Circulation.AVortexRingGoesOn")
    speed, energy = float(found["speed"]), float(found["energy"])
    yield Row(VORTICES, "a vortex ring in 3D, Gaussian core of 0.3 radii, 6.4 cells a radius, half a radius of way: speed over Saffman's (1970); energy", "0.95 … 1.05; within ±0.5 %",
              f"{speed:.3f}; {energy:.3%}", passed and abs(speed - 1) <= 0.05 and abs(energy) <= 5e-3)
    found, passed = harness.unit_figures("unit_step", "Circulation.UniformVorticityStaysUniform")
    worst = max(float(found["fixed"]), float(found["free"]))
    yield Row(VORTICES, "uniform vorticity beside a fixed disk and a free box, a quarter turn, 24 cells: error of the vorticity", "<= 1e-8", f"{worst:.1e}", passed and worst <= 1e-8)
    found, passed = harness.unit_figures("unit_step", "Circulation.AVortexAndADiskKeepTheirEnergy")
    energy = max(float(found["energy0"]), float(found["energy1"]))
    yield Row(VORTICES, "a neutral disk in a vortex that fills a box, a quarter turn, 24, 36 cells: energy (magnitudes of its correction)", "within ±0.5 %",
              f"{energy:.4%} ({', '.join(f'{float(c):.2%}' for c in found['corrected'].split(', '))})", passed and energy <= 5e-3)
    found, passed = harness.unit_figures("unit_step", "Circulation.AVortexCarriesADiskRound")
    order = float(found["order"])
    yield Row(VORTICES, "the same, a turn, 24, 48 cells, distance from the middle against 0.175 (extrapolated): order (errors)", ">= 1", f"{order:.2f} ({found['errors']})", passed and order >= 1)
    found, passed = harness.unit_figures("unit_step", "Circulation.ADiskWithCirculationGoesInACircle")
    way = float(found["way_over_exact"])
    yield Row(VORTICES, "a free disk of 3.2 cells a radius with circulation around it: way in half a turn over the circle's diameter", "0.9 … 1.1", f"{way:.3f}", passed and abs(way - 1) <= 0.1)


ALL = [coasting_cases, spinning_cases, plates_cases, vortex_cases, random_cases]
