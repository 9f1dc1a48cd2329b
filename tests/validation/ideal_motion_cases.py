"""Runs of ideal fluid with gap.model = "parts": bodies near walls against finer grids and against the Lagrangian equations of motion of their own added mass, noise of forces, energy of tanks."""
import math
import random

import harness
import ideal_step_cases
import random_scenes
from ideal_step_cases import PARTS
from harness import Row

NEAR = "Ideal fluid on parts: bodies near walls, 32² against 64²"
LAGRANGE = "Ideal fluid on parts: balls towards and off walls, against the Lagrangian equation of motion"
FALL = "Ideal fluid on parts: 48 balls that fall"
NOISE = "Ideal fluid on parts: force on bodies at constant speed in fluid otherwise at rest"
TANKS = "Ideal fluid on parts: energy of random tanks"
LONG_STEPS = "Ideal fluid on parts: steps of five cells"


def near_walls(quick):
    """Bodies that coast in a closed square, 32² against 64²: speed and spin at the end, over the speed of the start."""
    if quick:
        return
    plate = {"shape": "box", "size": [0.4, 0.05]}
    cases = { # and how long
        "plate 8:1, thrown at 20 degrees to its normal": ({**plate, "position": [0.35, 0.41], "rotation": 20.0, "velocity": [0.0, 0.5]}, 0.3),
        "plate 8:1 along a wall at 0.05 cells": ({**plate, "position": [0.35, 0.025 + 0.05 / 32], "velocity": [0.5, 0.0]}, 0.3),
        "capsule 2:1, thrown at 45 degrees to its axis": ({"shape": "capsule", "radius": 0.1, "length": 0.2, "position": [0.4, 0.35], "rotation": 45.0, "velocity": [0.0, 0.5]}, 0.6),
        "cylinder along a wall at 0.01 R, which it meets and slides along": ({"shape": "ball", "radius": 0.15, "position": [0.3, 0.1515], "velocity": [0.5, 0.0]}, 0.6),
    }
    for name, (body, end) in cases.items():
        ends = []
        for cells in (32, 64):
            result = harness.run({"domain": {"size": [1.0, 1.0], "cells": [cells, cells]}, "gap": PARTS, "body": [{"name": "b", "density": 1.0, **body}],
                                  "time": {"end": end, "max_step": 1.0, "cfl": 0.5}, "output": {"every": end}})
            last, steps = result["bodies"][-1], result["steps"]
            corrected = sum(row["corrected_energy"] for row in steps) / (steps[0]["energy_fluid"] + steps[0]["energy_bodies"])
            ends.append((last["vx"], last["vy"], 0.2 * last["omega"], corrected))
        speed = math.hypot(*ends[1][:2])
        across, turned = math.dist(ends[0][:2], ends[1][:2]) / speed, abs(ends[0][2] - ends[1][2]) / speed
        yield Row(NEAR, f"{name}: velocity; spin times half a length (0.2), over the speed", "within 1 %; 1 %",
                  f"{across:.2%}; {turned:.2%} (corrected energy {ends[0][3]:+.2%}, {ends[1][3]:+.2%})", max(across, turned) <= 0.01)


def mass_of(scene, direction):
    """Kinetic energy of fluid and bodies at unit speed, times two: all bodies along `direction` (a dict)."""
    result = harness.added_mass({**scene, "gap": PARTS})
    dimension = len(scene["domain"]["cells"])
    columns = dimension + (1 if dimension == 2 else 3)
    twist = [component for other in scene["body"] for component in [*direction[other["name"]], *[0.0] * (columns - dimension)]]
    fluid = sum(twist[i] * twist[j] * result["matrix"][i][j] for i in range(len(twist)) for j in range(len(twist)) if twist[i] and twist[j])
    return fluid + sum(harness.volume(other, dimension) * other["density"] * sum(c * c for c in direction[other["name"]]) for other in scene["body"])


def lagrangian(quick):
    """A ball towards a wall and off it, and two balls: what moves along one line keeps M(h) h'^2, M the program's own added mass and the bodies' mass. So h' = h'_0 sqrt(M_0/M(h)) at every step."""
    if quick:
        return
    for kind in ("ball and wall", "two balls"):
        for cells in (4, 6):
            side = 4.0 if kind == "ball and wall" else 5.0
            n = round(side * cells)

            def scene(gap, speed=0.0):
                x = [side / 2 + 0.31 / cells, side / 2 + 0.17 / cells]
                common = {"shape": "ball", "radius": 1.0, "density": 2.0}
                if kind == "ball and wall":
                    bodies = [{"name": "a", **common, "position": [*x, 1 + gap], "velocity": [0.0, 0.0, speed]}]
                else:
                    bodies = [{"name": name, **common, "position": [*x, side / 2 + 0.23 / cells + sign * (1 + gap / 2)], "velocity": [0.0, 0.0, sign * speed / 2]}
                              for name, sign in (("a", 1), ("b", -1))]
                return {"domain": {"size": [side] * 3, "cells": [n] * 3}, "body": bodies}

            def mass(gap):
                # Two balls in a box do not go as mirror images; their middle's motion is left out by the small difference.
                return mass_of(scene(gap), {"a": [0.0, 0.0, 1.0]} if kind == "ball and wall" else {"a": [0.0, 0.0, 0.5], "b": [0.0, 0.0, -0.5]})

            for first, last in ((0.4, 1e-3), (1e-3, 0.4)):
                speed = -1.0 if last < first else 1.0
                end = 1.0 if speed > 0 else 1.2 * (first - last) * math.sqrt(mass(last) / mass(first))
                result = harness.run({**scene(first, speed), "gap": PARTS, "time": {"end": end, "max_step": 0.1, "cfl": 0.5}, "output": {"every": end}})
                track = {}
                for row in result["bodies"]:
                    track.setdefault(row["body"], []).append(row)
                if kind == "ball and wall":
                    places = [(row["z"] - 1, row["vz"]) for row in track["a"]]
                else:
                    places = [(a["z"] - b["z"] - 2, a["vz"] - b["vz"]) for a, b in zip(track["a"], track["b"])]
                within = [(h, v) for h, v in places if min(first, last) <= h <= max(first, last) * (1 + 1e-12)]
                chosen = [within[round(k * (len(within) - 1) / 8)] for k in range(9)]
                start = mass(first)
                errors = [v / (speed * math.sqrt(start / mass(h))) - 1 for h, v in chosen[1:]]
                yield Row(LAGRANGE, f"{kind}, {cells} cells a radius, from {first:g} to {last:g} R: speed at eight gaps ({len(within)} steps)", "within ±0.3 %",
                          f"{min(errors):+.2%} … {max(errors):+.2%} (last gap {chosen[-1][0]:.2g})", max(map(abs, errors)) <= 0.003)


def falling(quick):
    """48 balls on the shaken lattice of the crowd's rows (parts_cases.crowd) fall from rest, 20 steps."""
    if quick:
        return
    radius, shake, cells = 0.115, random.Random(5), 35
    places = [[(i + 0.5) / 4 + shake.uniform(-0.008, 0.008), (j + 0.5) / 4 + shake.uniform(-0.008, 0.008), (k + 0.5) / 3 + shake.uniform(-0.04, 0.04)]
              for i in range(4) for j in range(4) for k in range(3)]
    step = 0.02
    result = harness.run({"gravity": [0.0, 0.0, -1.0], "domain": {"size": [1.0] * 3, "cells": [cells] * 3}, "gap": PARTS,
                          "body": [{"name": f"b{k}", "shape": "ball", "radius": radius, "density": 2.0, "position": x} for k, x in enumerate(places)],
                          "time": {"end": 20 * step, "max_step": step, "cfl": 1.0}, "output": {"every": 20 * step}})
    heights = {}
    for row in result["bodies"]:
        heights.setdefault(row["time"], []).append(row["z"])
    volume = 4 / 3 * math.pi * radius ** 3
    rows = result["steps"][:21]    # later some balls meet, which takes energy
    first, last = rows[0]["time"], rows[-1]["time"]
    released = volume * (sum(heights[first]) - sum(heights[last]))    # density 2 less that of the fluid
    kinetic = rows[-1]["energy_fluid"] + rows[-1]["energy_bodies"]
    corrected = sum(row["corrected_energy"] for row in rows)
    error = kinetic / released - 1
    yield Row(FALL, f"4 cells a radius, {len(rows) - 1} steps: kinetic energy over the potential energy set free (without the correction)", "within ±0.05 %",
              f"{error:+.3%} ({(kinetic - corrected) / released - 1:+.3%})", abs(error) <= 5e-4)


def noise_row(name, bodies, cells, length, limit, dimension=2):
    """The bodies move three cells at constant speed 1 in a box eight lengths wide; the whole force's root mean square over rho V² L (3D L²)."""
    dx = 1.0 / cells
    side = 8 if dimension == 2 else 5
    n = round(side * length * cells)
    end = 3 * dx
    scene = {"domain": {"size": [n * dx] * dimension, "cells": [n] * dimension, "sides": {f"{a}_{e}": "far" for a in "xyz"[:dimension] for e in ("low", "high")}}, "gap": PARTS,
             "body": [{"motion": "prescribed", "velocity": [1.0, 0.3, 0.2][:dimension], **body} for body in bodies],
             "time": {"end": end, "max_step": 1.0, "cfl": 0.3}, "output": {"every": end}}
    result = harness.run(scene)
    sums = {}    # of all bodies: two attract or repel each other as they should
    for row in result["bodies"]:
        if row["time"] > 0:
            sums.setdefault(row["time"], []).append([row[k] for k in ("fx", "fy", "fz") if k in row])
    square = sum(sum(parts) ** 2 for forces in sums.values() for parts in zip(*forces)) / len(sums)
    rms = math.sqrt(square) / (1.09 if dimension == 2 else 1.13) / length ** (dimension - 1)
    return Row(NOISE, f"{name}: root mean square over ρV²L{'²' if dimension == 3 else ''}, {len(sums)} steps", f"≤ {limit:g}", f"{rms:.4f}", rms <= limit)


def noise(quick):
    if quick:
        return
    for radius, limit in ((4, 0.06), (8, 0.03)):    # L is the diameter, 1
        place = [4.003, 4.007]
        yield noise_row(f"disk of {radius} cells a radius", [{"name": "b", "shape": "ball", "radius": 0.5, "position": place}], 2 * radius, 1.0, limit)
    yield noise_row("ball of 4 cells a radius", [{"name": "b", "shape": "ball", "radius": 0.5, "position": [2.403, 2.407, 2.405]}], 8, 1.0, 0.06, 3)
    for length, limit in ((16, 0.12), (24, 0.1)):
        for angle in (0.0, 25.0, 115.0):
            turn = math.radians(angle)
            offset = 0.25 + 0.025 / length
            pair = [{"name": name, "shape": "box", "size": [1.0, 0.5], "rotation": angle, "position": [4.003 - sign * offset * math.sin(turn), 4.007 + sign * offset * math.cos(turn)]}
                    for name, sign in (("upper", 1), ("lower", -1))]
            yield noise_row(f"pair of boxes 2:1, {length} cells long, gap of 0.05 cells, at {angle:g} degrees", pair, length, 1.0, limit)
    for angle in (0.0, 25.0):
        yield noise_row(f"plate 16 x 0.1 cells at {angle:g} degrees", [{"name": "b", "shape": "box", "size": [1.0, 0.1 / 16], "rotation": angle, "position": [4.003, 4.007]}], 16, 1.0, 0.1)


def long_steps(quick):
    """Bodies that coast three diameters, steps of five cells."""
    if quick:
        return
    for dimension, name in ((2, "disk"), (3, "ball")):
        runs = [ideal_step_cases.coasting(dimension, 3.2, 1.0, cfl, 0.3) for cfl in (1.0, 5.0)]
        worst = [max(map(abs, errors)) for errors, *_ in runs]
        yield Row(LONG_STEPS, f"{name}, 3.2 cells a radius: error of the speed at Courant number 5 (and 1); energy", "≤ 3 times 0.5 %; no gain",
                  f"{worst[1]:.2%} ({worst[0]:.2%}); {runs[1][1]:+.4%}", worst[1] <= 0.015 and runs[1][1] <= 1e-4)


def tanks(quick):
    """Random closed and periodic tanks: the judge of random_scenes."""
    if quick:
        return
    records = [random_scenes.examine(number, parts=True) for number in range(0, 300, 5)]
    bad = [record for record in records if record["defects"]]
    yield Row(TANKS, f"{len(records)} of the 300 scenes in 2D: the judge of random scenes", "no defect",
              "; ".join([f"{len(records) - len(bad)} of {len(records)}"] + [f"{r['number']}: {', '.join(r['defects'])}"[:90] for r in bad]), not bad)


ALL = [near_walls, lagrangian, falling, noise, long_steps, tanks]
