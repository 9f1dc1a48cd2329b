"""Viscous flow: channels at an angle, a slider across the film's threshold, parallel motion along a wall, invariances, energy."""
import math
from pathlib import Path

import harness
from harness import REFERENCE, Row
from viscous_cases import body, error_row

CHANNEL = "Viscosity: channel between two bodies, at an angle to the grid"
SLIDER = "Viscosity: slider bearing, thickness from 0.16 to 0.04 of a pad of length 4 (Reynolds)"
PARALLEL = "Viscosity: cylinder along a wall, Stokes flow (V2)"
INVARIANCE = "Viscosity: uniform motion and rotation of everything"
ENERGY = "Viscosity: energy in a closed box without forces"


def fields(shape):
    """Reader of the last frame: velocity at cell centres (shape, 3), pressure and kind (shape)."""
    def look(out):
        from pressure_cases import read, values
        data = read(sorted((Path(out) / "fields").glob("*.vti"))[-1], "vtkXMLImageDataReader").GetCellData()
        return tuple(values(data, name).reshape(*shape, *tail) for name, tail in (("velocity", (3,)), ("pressure", ()), ("kind", ())))
    return look


def channel(degrees, cells, offset, wall_speed):
    """Channel of width 1 between two half-spaces: (flow through it, and its upper wall's speed, are given) largest error of the
    velocity along it in the middle, over the largest velocity; error of the pressure gradient (None without one)."""
    import numpy as np
    angle = math.radians(degrees)
    along, across = np.array([math.cos(angle), math.sin(angle)]), np.array([-math.sin(angle), math.cos(angle)])
    nx = 3 * cells
    ny = math.ceil((3 * math.tan(angle) + 1 / math.cos(angle) + 0.4) * cells)
    foot = np.array([0.0, 0.2 + offset / cells])
    driven = wall_speed != 0
    scene = {"domain": {"size": [3.0, ny / cells], "cells": [nx, ny],
                        "sides": {"x_low": "open" if driven else {"inflow": [1.0, 0.0]}, "x_high": "open"}},
             "fluid": {"density": 1e-6, "viscosity": 1.0},
             "body": [{"name": "lower", "shape": "half-space", "normal": list(across), "position": list(foot), "motion": "fixed"},
                      {"name": "upper", "shape": "half-space", "normal": list(-across), "position": list(foot + across), "motion": "prescribed",
                       "velocity": list(wall_speed * along)}],
             "time": {"end": 2e-6, "max_step": 5e-8, "cfl": 10.0}, "output": {"every": 2e-6}}
    u, p, _ = harness.run(scene, look=fields((ny, nx)))["look"]
    x, y = np.meshgrid((np.arange(nx) + 0.5) / cells, (np.arange(ny) + 0.5) / cells)
    place = np.stack([x, y], axis=-1) - foot
    s, d = place @ along, place @ across
    length = 3 / math.cos(angle)
    middle = (abs(s - 0.5 * length) < 0.3) & (d > 1.5 / cells) & (d < 1 - 1.5 / cells)
    if driven:
        return float(np.abs(u[..., :2] @ along - wall_speed * d)[middle].max() / abs(wall_speed)), None
    flux = 1 / math.cos(angle)
    error = np.abs(u[..., :2] @ along - 6 * flux * d * (1 - d))[middle].max() / (1.5 * flux)
    slope = np.polyfit(s[middle], p[middle], 1)[0]
    return float(error), float(slope / (-12 * flux) - 1)


def channels(quick):
    for degrees in (20,) if quick else (0, 20, 33, 45):
        for cells in (16,) if quick else (8, 16, 32):
            velocity, gradient = channel(degrees, cells, 0.37, 0.0)
            name = f"Poiseuille flow, {degrees}°, {cells} cells across: velocity"
            shear, _ = channel(degrees, cells, 0.37, 1.0)
            rows = ((name, velocity), (name.replace("velocity", "pressure gradient"), gradient),
                    (f"Couette flow, {degrees}°, {cells} cells across: velocity", shear))
            for text, error in rows:
                if cells < 16:
                    yield Row(CHANNEL, text, "", f"{100 * error:+.2f} %", True)
                else:
                    yield error_row(CHANNEL, text, 0.02, error)


def slider(cells, threshold):
    """Errors of a slider's load and of the friction on its pad, film nodes. The pad stands, the domain's wall slides under it; films where
    it is thinner than `threshold` cells."""
    thick, thin, length = 0.16, 0.04, 4.0
    slope, dx = math.atan((thick - thin) / length), 1 / cells
    step = 2e-6 * dx * dx
    scene = {"domain": {"size": [length, 1.5], "cells": [4 * cells, 3 * cells // 2],
                        "sides": {"x_low": "open", "x_high": "open", "y_low": {"wall": [1.0, 0.0]}}},
             "fluid": {"density": 1e-6, "viscosity": 1.0}, "gap": {"threshold": threshold},
             "body": [{"name": "pad", "shape": "box", "size": [8.0, 1.0], "rotation": -math.degrees(slope), "motion": "prescribed", "velocity": [0.0, 0.0],
                       "position": [0.5 * length + 0.5 * math.sin(slope), 0.5 * (thick + thin) + 0.5 * math.cos(slope)]}],
             "time": {"end": 60 * step, "max_step": step, "cfl": 10.0}, "output": {"every": 60 * step}}
    result = harness.run(scene)
    last, k = result["bodies"][-1], thick / thin
    load = 6 * (length / (thick - thin))**2 * (math.log(k) - 2 * (k - 1) / (k + 1))
    friction = length / (thick - thin) * (4 * math.log(k) - 6 * (k - 1) / (k + 1))
    return last["fy"] / load - 1, last["fx"] / friction - 1, int(result["steps"][-1]["film_nodes"])


def sliders(quick):
    for cells, threshold in ((20, 1.5),) if quick else ((20, 0.5), (20, 1.0), (20, 1.5), (20, 2.0), (20, 3.0), (40, 0.5), (40, 2.0), (40, 3.0)):
        load, friction, nodes = slider(cells, threshold)
        name = f"{0.04 * cells:g} to {0.16 * cells:g} cells, films below {threshold:g} cells ({nodes} nodes)"
        yield error_row(SLIDER, f"{name}: load", 0.03, load)
        yield error_row(SLIDER, f"{name}: friction", 0.03, friction)


def along_wall(gap, cells, side, step, offset=0.23):
    """Force factor on a cylinder that moves along a wall of a box, open above. Nothing has inertia."""
    scene = {"domain": {"size": [side, side], "cells": [round(side * cells)] * 2, "sides": {"y_high": "open"}},
             "fluid": {"density": 1e-6, "viscosity": 1.0},
             "body": [body("cylinder", radius=1.0, position=[0.5 * side + offset / cells, 1 + gap], velocity=[gap, 0.0])],
             "time": {"end": 60e-6 * step, "max_step": 1e-6 * step, "cfl": 10.0}, "output": {"every": 60e-6 * step}}
    return abs(harness.run(scene)["bodies"][-1]["fx"]) / gap


def parallel(quick):
    """What the box adds falls as its side squared: taken away from runs at sides 16 and 32, 6 cells a radius."""
    table = harness.read_table(REFERENCE / "V2_cylinder_stokes.csv")
    for gap in (1e-3,) if quick else (0.1, 1e-2, 1e-3, 1e-5):
        row = min(table, key=lambda r: abs(math.log(r["gap_over_a"] / gap)))
        gap, exact = row["gap_over_a"], row["F_parallel_over_muU"]
        small, large = (along_wall(gap, 6, side, 0.2) for side in (16.0, 32.0))
        box = (small - large) * 4 / 3
        value = along_wall(gap, 12, 16.0, 0.1) - box
        yield error_row(PARALLEL, f"gap {gap:.3g}, 12 cells a radius, less {100 * box / exact:.1f} % of the box", 0.05, value / exact - 1)


def drift(dimension, viscosity, gap=1e-3):
    """Two free balls, a film between them, and the fluid in uniform motion through a periodic box: largest change of a body's velocity,
    over the speed."""
    speed = [0.3, 0.2, 0.1][:dimension]
    n, steps = (32, 40) if dimension == 2 else (20, 10)
    scene = {"domain": {"size": [1.0] * dimension, "cells": [n] * dimension,
                        "sides": {f"{axis}_{end}": "periodic" for axis in "xyz"[:dimension] for end in ("low", "high")}},
             "fluid": {"viscosity": viscosity, "velocity": speed},
             "body": [{"name": name, "shape": "ball", "radius": 0.15, "density": density, "position": [x, 0.5, 0.5][:dimension], "velocity": speed}
                      for name, density, x in (("a", 2.0, 0.3), ("b", 0.5, 0.6 + gap))],
             "time": {"end": 0.02 * steps, "max_step": 0.02, "cfl": 10.0}, "output": {"every": 0.02 * steps}}
    spins = ["omega"] if dimension == 2 else ["wx", "wy", "wz"]
    largest = 0.0
    for row in harness.run(scene)["bodies"]:
        largest = max(largest, *(abs(row[f"v{axis}"] - u) for axis, u in zip("xyz", speed)), *(0.15 * abs(row[spin]) for spin in spins))
    return largest / math.hypot(*speed)


def turning(step):
    """Drum full of fluid that turns with it, after the start: torque on it over 4 pi mu omega R^2, and the same without inertia."""
    def torque(density, viscosity, step, steps):
        scene = {"domain": {"size": [1.0, 1.0], "cells": [32, 32]}, "fluid": {"density": density, "viscosity": viscosity},
                 "body": [{"name": "drum", "shape": "ball", "radius": 0.45, "inside_out": True, "position": [0.503, 0.497], "motion": "prescribed",
                           "angular_velocity": 1.0}],
                 "time": {"end": step * steps, "max_step": step, "cfl": 10.0}, "output": {"every": step * steps}}
        return abs(harness.run(scene)["bodies"][-1]["torque"]) / (4 * math.pi * viscosity * 0.45**2)
    return torque(1.0, 0.1, step, round(20 / step)), torque(1e-7, 1.0, 1e-8, 200)


def invariance(quick):
    for dimension, viscosity in ((2, 1.0),) if quick else ((2, 0.01), (2, 1.0), (3, 0.01), (3, 1.0)):
        change = drift(dimension, viscosity)
        yield Row(INVARIANCE, f"{dimension}D, two balls with a film 1e-3 thick, viscosity {viscosity:g}: change of their velocities, of the speed", "≤ 1e-6",
                  f"{change:.1e}", bool(change <= 1e-6))
    inertial, creeping = turning(0.02)
    yield Row(INVARIANCE, "drum full of fluid that turns with it, no inertia: torque over 4πμωR²", "≤ 1e-6", f"{creeping:.1e}", bool(creeping <= 1e-6))
    yield Row(INVARIANCE, "the same with inertia (Re 2, 314 steps a turn): torque over 4πμωR²", "≤ 1e-5", f"{inertial:.1e}", bool(inertial <= 1e-5))


def energies(quick):
    """A free ball that coasts in a closed box, until it comes near a wall."""
    for dimension, cells in ((2, 32),) if quick else ((2, 32), (2, 64), (3, 24)):
        scene = {"domain": {"size": [2.0] * dimension, "cells": [cells] * dimension}, "fluid": {"viscosity": 0.02},
                 "body": [{"name": "ball", "shape": "ball", "radius": 0.4, "position": [1.2, 0.9, 1.0][:dimension], "density": 2.0,
                           "velocity": [-0.7, 0.6, 0.2][:dimension], "angular_velocity": 2.0 if dimension == 2 else [0.0, 1.0, 2.0]}],
                 "time": {"end": 4.0, "max_step": 0.02}, "output": {"every": 4.0}}
        steps = harness.run(scene)["steps"]
        energy = [row["energy_fluid"] + row["energy_bodies"] for row in steps]
        rise = max(b - a for a, b in zip(energy, energy[1:])) / energy[0]
        taken = sum(row["dt"] * (row["dissipation_grid"] + row["dissipation_film"]) for row in steps)
        yield Row(ENERGY, f"{dimension}D, {cells} cells along x, free ball, {len(steps) - 1} steps: largest rise in a step, of the energy; dissipation reported, of the loss",
                  "≤ 0; 0.8 to 1.02", f"{rise:.1e}; {taken / (energy[0] - energy[-1]):.3f}",
                  bool(rise <= 0 and 0.8 <= taken / (energy[0] - energy[-1]) <= 1.02))


ALL = [channels, sliders, parallel, invariance, energies]
