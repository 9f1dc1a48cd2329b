"""Periodic boxes that a mean pressure gradient drives: channels, arrays of spheres and cylinders; neutral disks in shear, suspensions that settle."""
import math
import statistics

import harness
from harness import Row
from viscous_cases import error_row

CHANNEL = "Driven channels"
ARRAYS = "Stokes flow through periodic arrays, driven by a pressure gradient"
DISK = "A neutrally buoyant disk in a driven channel"
FRAMES = "Lift on a disk that goes with the fluid in shear: the same in every uniformly moving frame"
COUETTE = f"{DISK}: Couette flow (Feng, Hu & Joseph 1994)"
POISEUILLE = f"{DISK}: Poiseuille flow (Pan & Glowinski 2002)"
SUSPENSION = "A settling suspension of balls, Reynolds number 0.3, periodic box of 24³ cells, 5 cells a diameter"

# Drag of a sphere over 6 pi mu a U, U the mean velocity of the whole volume: Zick and Homsy, J. Fluid Mech. 115 (1982), table 2, simple cubic.
ZICK_HOMSY = {0.027: 2.008, 0.064: 2.810, 0.125: 4.292, 0.216: 7.442, 0.45: 28.1, 0.5236: 42.1}
# Drag of a cylinder per length over mu U: Sangani and Acrivos, Int. J. Multiphase Flow 8 (1982), square arrays.
SANGANI_ACRIVOS = {0.05: 15.56, 0.2: 51.53, 0.4: 217.89, 0.6: 1763.0, 0.75: 126300.0}


def sides(periodic):
    return {f"{axis}_{end}": "periodic" for axis in periodic for end in ("low", "high")}


def stokes(dimension, cells, periodic, drive, bodies=(), size=1.0, steps=60):
    """Mean velocity and gradient along x of the last step; density next to nothing, viscosity 1."""
    scene = {"domain": {"size": [size] * dimension, "cells": [cells] * dimension, "sides": sides(periodic)},
             "fluid": {"density": 1e-6, "viscosity": 1.0, **drive}, "body": list(bodies),
             "time": {"end": steps * 5e-8 * size**2, "max_step": 5e-8 * size**2, "cfl": 5.0}}
    last = harness.run(scene)["steps"][-1]
    return last["mean_velocity_x"], last["pressure_gradient_x"]


def channels(quick):
    for dimension in (2,) if quick else (2, 3):
        for cells in (8,) if quick else (8, 16):
            flow, _ = stokes(dimension, cells, "xz"[:dimension - 1], {"pressure_gradient": [-12.0, 0.0, 0.0][:dimension]})
            yield error_row(CHANNEL, f"Poiseuille flow, {dimension}D, {cells} cells, pressure gradient given: mean velocity", 2e-4, flow - 1)
            flow, gradient = stokes(dimension, cells, "xz"[:dimension - 1], {"mean_velocity": [1.0, 0.0, 0.0][:dimension]}, steps=100)
            yield error_row(CHANNEL, f"the same, mean velocity given: pressure gradient (mean velocity kept to {abs(flow - 1):.0e})", 2e-4, gradient / -12 - 1)


def array(dimension, fraction, cells, drive, bodies_a_side=1):
    radius = (math.sqrt(fraction / math.pi) if dimension == 2 else (0.75 * fraction / math.pi)**(1 / 3))
    shift = [0.013, 0.007, 0.003][:dimension]
    places = [[]]
    for axis in range(dimension):
        places = [place + [i + 0.5 + shift[axis]] for place in places for i in range(bodies_a_side)]
    bodies = [{"name": f"body_{n}", "shape": "ball", "radius": radius, "position": place, "motion": "fixed"} for n, place in enumerate(places)]
    flow, gradient = stokes(dimension, cells * bodies_a_side, "xyz"[:dimension], drive, bodies, float(bodies_a_side), 60 if dimension == 3 else 800)  # thin throats take hundreds of steps to be steady
    return -gradient / (6 * math.pi * radius * flow if dimension == 3 else flow)


def spheres(quick):
    if quick:
        return
    for fraction, exact in ZICK_HOMSY.items():
        touching = fraction > 0.5
        for cells in (16, 32):
            error = array(3, fraction, cells, {"pressure_gradient": [-1.0, 0.0, 0.0]}) / exact - 1
            case = f"cubic array of spheres, volume fraction {fraction:g}{' (touching)' if touching else ''}, {cells} cells a side: drag (Zick and Homsy {exact:g})"
            yield Row(ARRAYS, case, "", f"{error:+.2%}", True) if touching or cells < 32 else error_row(ARRAYS, case, 0.03, error)


def cylinders(quick):
    for fraction, exact in {0.2: SANGANI_ACRIVOS[0.2]}.items() if quick else SANGANI_ACRIVOS.items():
        for cells in (32,) if quick else (16, 32, 64):
            for number in (1, 2) if fraction > 0.7 else (1,):
                error = array(2, fraction, cells, {"pressure_gradient": [-1.0, 0.0]}, number) / exact - 1
                case = (f"square array of cylinders, volume fraction {fraction:g}, {cells} cells a side{', four in a box' if number > 1 else ''}: "
                        f"drag (Sangani and Acrivos {exact:g})")
                yield error_row(ARRAYS, case, 0.03, error) if cells == 32 else Row(ARRAYS, case, "", f"{error:+.2%}", True)


def lift_in_shear(drift, step, ranks=1):
    """Lift on a disk that goes with the fluid, between walls that all move by `drift`; Reynolds number 40 on the channel's height."""
    scene = {"domain": {"size": [1.0, 1.0], "cells": [32, 32], "sides": {**sides("x"), "y_low": {"wall": [drift - 0.5, 0.0]}, "y_high": {"wall": [drift + 0.5, 0.0]}}},
             "fluid": {"density": 1.0, "viscosity": 1 / 40, "velocity": [drift, 0.0]},
             "body": [{"name": "disk", "shape": "ball", "radius": 0.125, "position": [0.513, 0.3], "motion": "prescribed",
                       "velocity": [drift - 0.2, 0.0], "angular_velocity": -0.45}],
             "time": {"end": 3.0, "max_step": step, "cfl": 10.0}}
    late = [b["fy"] for b in harness.run(scene, ranks)["bodies"] if b["time"] > 2]
    return sum(late) / len(late)


def frames(quick):
    for step in (16,) if quick else (16, 32, 64):
        with_it, against = (lift_in_shear(drift, 1 / step) for drift in (0.5, -0.5))
        yield Row(FRAMES, f"step 1/{step}: lift between walls that move by +0.5, and its difference from -0.5", "≤ 0.0008",
                  f"{with_it:.5f}, {with_it - against:+.5f}", abs(with_it - against) <= 8e-4)
    change = lift_in_shear(0.5, 1 / 16, ranks=2) - lift_in_shear(0.5, 1 / 16)
    yield Row(FRAMES, "step 1/16, 2 ranks: change of the lift", "≤ 1e-7", f"{change:.1e}", abs(change) <= 1e-7)


# Heights of the disk at times 20 and 70 after its release at 0.25 in figure 2 of Feng, Hu and Joseph, J. Fluid Mech. 277 (1994), as two others read it, who agree
# to 0.0015 and 0.0005; and as one of them has it a second time, as if of another length or release.
FENG, FENG_OTHER = (0.349, 0.476), (0.339, 0.473)

harness.PICTURES[COUETTE] = """Radius 0.125 of the height, Reynolds number 40, walls that move at -0.5 and +0.5, periodic along x, times in heights over the walls' relative speed. A scene cannot
start from a linear profile: the disk is released at rest at 0.235, and times count from where it passes 0.25, in a flow that has developed. The figure's heights are 0.349 and 0.476 as two others read
them; "other reading": 0.339 and 0.473, a second curve that one of them gives without a word about it. The length matters below 4 heights."""
harness.PICTURES[POISEUILLE] = """Channel 1 x 1, periodic along x, radius 0.125, released at 0.4, followed for about 50 heights. Pressure gradients, viscosities and heights of the paper are taken from others who
repeat it; its Reynolds numbers are close to those of the mean velocity with the disk (last figure of a row), not without it (13.91, 30.25, 106.1). With walls at rest the disk crosses the grid."""
harness.PICTURES[SUSPENSION] = """Twice the fluid's density, nothing passes the box's cross-sections in the mean, mean over times from 2 to 6 diameters over Stokes' speed. A single ball is measured in unbounded fluid (far
sides, a graded grid of 5 cells a diameter that follows it). Boxes of 21 to 63 balls settle more slowly than large ones: Ladd's correction is for Stokes flow."""


def at(rows, time, column):
    for a, b in zip(rows, rows[1:]):
        if a["time"] <= time <= b["time"]:
            return a[column] + (time - a["time"]) / (b["time"] - a["time"]) * (b[column] - a[column])
    raise RuntimeError(f"no row at time {time:g}")


def in_couette_flow(cells, length, step, from_rest=False, drift=0.0):
    """Heights at times 20 and 70 after the release at 0.25: from rest there, or where a disk released at 0.235 passes it in a flow that has developed."""
    scene = {"domain": {"size": [float(length), 1.0], "cells": [cells * length, cells],
                        "sides": {**sides("x"), "y_low": {"wall": [drift - 0.5, 0.0]}, "y_high": {"wall": [drift + 0.5, 0.0]}}},
             "fluid": {"density": 1.0, "viscosity": 1 / 40, "velocity": [drift, 0.0]},
             "body": [{"name": "disk", "shape": "ball", "radius": 0.125, "position": [length / 2, 0.25 if from_rest else 0.235], "velocity": [drift, 0.0], "density": 1.0}],
             "time": {"end": 70.0 if from_rest else 80.0, "max_step": step, "cfl": 4.0}}
    rows = harness.run(scene)["bodies"]
    start = 0.0 if from_rest else next(b["time"] for a, b in zip(rows, rows[1:]) if a["y"] <= 0.25 < b["y"])
    return [at(rows, start + time, "y") for time in (20, 70)]


def disk_in_couette_flow(quick):
    if quick:
        return
    moving = {"drift": 0.2}
    for cells, length, step, options, text in (
            (16, 4, 64, {}, ""), (32, 4, 64, {}, ""), (64, 4, 64, {}, ""), (64, 2, 64, {}, ""), (32, 2, 64, {}, ""), (32, 1, 64, {}, ""),
            (32, 4, 64, {"from_rest": True}, ", disk and fluid released from rest"),
            (32, 8, 32, {}, ""), (32, 4, 32, {}, ""), (32, 4, 16, {}, ""), (32, 4, 32, moving, ", the channel moving by 0.2"),
            (32, 4, 16, moving, ", the channel moving by 0.2")):
        heights = in_couette_flow(cells, length, 1 / step, **options)
        errors, others = ([f"{height / of - 1:+.2%}" for height, of in zip(heights, curve)] for curve in (FENG, FENG_OTHER))
        worst = max(abs(height / of - 1) for height, of in zip(heights, FENG))
        targeted = (cells, length, step) in ((32, 4, 64), (64, 4, 64), (64, 2, 64)) and not options
        yield Row(COUETTE, f"{cells} cells a height, length {length}, step 1/{step}{text}: heights at t = 20 and 70 (figure: 0.349 and 0.476)", "≤ 2 %" if targeted else "",
                  f"{heights[0]:.4f}, {heights[1]:.4f}: {errors[0]}, {errors[1]} (other reading {others[0]}, {others[1]})", not targeted or worst <= 0.02)


# Number: pressure gradient, viscosity, Reynolds number, equilibrium height of Pan and Glowinski, J. Comput. Phys. 181 (2002), as others repeat them.
PAN = {1: (1.763e-3, 3.2498036e-3, 12.78, 0.2732), 2: (8.167e-4, 1.5e-3, 27.73, 0.2725), 3: (2.337e-4, 4.2834760e-4, 96.74, 0.2722)}


def in_poiseuille_flow(number, cells, step, moving):
    """Height and Reynolds number of the mean velocity after the disk has travelled 50 heights; the walls may move back at the disk's speed."""
    gradient, viscosity, _, _ = PAN[number]
    speed = gradient / (12 * viscosity)    # mean, without the disk
    frame = -1.05 * speed if moving else 0.0
    wall = {"wall": [frame, 0.0]}
    scene = {"domain": {"size": [1.0, 1.0], "cells": [cells, cells], "sides": {**sides("x"), "y_low": wall, "y_high": wall}},
             "fluid": {"density": 1.0, "viscosity": viscosity, "pressure_gradient": [-gradient, 0.0], "velocity": [speed + frame, 0.0]},
             "body": [{"name": "disk", "shape": "ball", "radius": 0.125, "position": [0.5, 0.4], "velocity": [1.4 * speed + frame, 0.0], "density": 1.0}],
             "time": {"end": 48 / speed, "max_step": step / cells / speed, "cfl": 4.0}}
    result = harness.run(scene)
    return result["bodies"][-1]["y"], (result["steps"][-1]["mean_velocity_x"] - frame) / viscosity


def disk_in_poiseuille_flow(quick):
    if quick:
        return
    for number, cells, step, moving in ((1, 16, 0.5, True), (1, 32, 0.5, True), (1, 64, 0.5, True), (2, 32, 0.5, True), (3, 32, 0.5, True), (3, 32, 0.25, True), (3, 64, 0.5, True),
                                        (1, 32, 0.5, False), (1, 32, 0.25, False), (1, 32, 0.125, False), (1, 64, 0.25, False)):
        gradient, viscosity, reynolds, exact = PAN[number]
        height, found = in_poiseuille_flow(number, cells, step, moving)
        targeted = moving and cells >= 32
        case = (f"{cells} cells a height, pressure gradient {gradient:g}, viscosity {viscosity:g}, {'walls move back with the disk' if moving else 'walls at rest'}, "
                f"{step:g} cells a step at the mean velocity: height (Re {reynolds}: {exact})")
        yield Row(POISEUILLE, case, "≤ 2 %" if targeted else "", f"{height:.4f}: {height / exact - 1:+.2%}; Re {found:.2f}", not targeted or abs(height / exact - 1) <= 0.02)


def settling(fraction, seed=1, end=6.0):
    """Mean speed of the balls over the last two thirds of a run; a fraction of 0: of a single ball far from all else, at its end."""
    side = 24 / 5
    scene = {"gravity": [0.0, 0.0, -60.0], "fluid": {"density": 1.0, "viscosity": 1 / 0.3}, "time": {"end": end, "max_step": 0.1}, "output": {"bodies": "csv"},
             "domain": {"size": [side] * 3, "cells": [24] * 3, "sides": sides("xyz")}}
    ball = {"shape": "ball", "radius": 0.5, "density": 2.0}
    if not fraction:
        scene["domain"] = {"size": [20.0] * 3, "spacing": 0.2, "core": {"low": [8.8] * 3, "high": [11.2] * 3}, "growth": 1.2, "follow": "ball",
                           "sides": {f"{axis}_{end}": "far" for axis in "xyz" for end in ("low", "high")}}
        scene["body"] = [{"name": "ball", "position": [10.013, 10.007, 10.003], **ball}]
        return -harness.run(scene)["bodies"][-1]["vz"]
    scene["fluid"]["mean_velocity"] = [0.0, 0.0, 0.0]
    if fraction == "one":
        scene["body"] = [{"name": "ball", "position": [side / 2 + 0.013, side / 2 + 0.007, side / 2 + 0.003], **ball}]
        return -harness.run(scene)["bodies"][-1]["vz"]
    scene["crowd"] = [{"name": "ball", "volume_fraction": fraction, "seed": seed, **ball}]
    rows = harness.run(scene, look=lambda out: harness.read_table(out / "crowds.csv"))["look"]
    late = [(a, b) for a, b in zip(rows, rows[1:]) if a["time"] >= end / 3]
    return -sum((b["time"] - a["time"]) * b["vz"] for a, b in late) / (rows[-1]["time"] - late[0][0]["time"])


def box_correction(fraction, side):
    """Ladd, J. Chem. Phys. 93 (1990): what a cubic periodic box, its side in diameters, takes off the mean speed over Stokes' speed, without inertia. Structure factor
    at wave number 0 of hard spheres (Carnahan and Starling), Ladd's fit of the viscosity."""
    structure = (1 - fraction)**4 / ((1 + 2 * fraction)**2 + fraction**3 * (fraction - 4))
    dense = fraction * (1 + fraction - 0.189 * fraction**2)
    return 1.7601 * structure * (1 - dense) / (1 + 1.5 * dense) * (math.pi / 6)**(1 / 3) / side


def suspension(quick):
    if quick:
        return
    single, box = settling(0, end=2.0), settling("one", end=2.0)
    yield Row(SUSPENSION, "a single ball in unbounded fluid, of the speed by the drag of Schiller and Naumann (0.944 of Stokes' speed); a single ball in the periodic box, of that in unbounded fluid",
              "", f"{single / 0.944:.3f}; {box / single:.3f}", True)
    for fraction, seeds in ((0.1, 3), (0.2, 2), (0.3, 2)):
        speeds = [settling(fraction, seed) / single for seed in range(1, seeds + 1)]
        mean = statistics.mean(speeds)
        yield Row(SUSPENSION, f"volume fraction {fraction}, {seeds} seeds: mean speed over that of a single ball in unbounded fluid, (1 - fraction)^4.65 = {(1 - fraction)**4.65:.3f}", "",
                  f"{mean:.3f} (seeds {min(speeds):.3f} … {max(speeds):.3f}): exponent {math.log(mean) / math.log(1 - fraction):.2f}; with Ladd's correction for the box "
                  f"{mean + box_correction(fraction, 24 / 5):.3f}", True)


ALL = [channels, frames, spheres, cylinders, disk_in_couette_flow, disk_in_poiseuille_flow, suspension]
