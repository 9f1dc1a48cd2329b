"""Viscous flow: channels at an angle, invariances, energy."""
import math
from pathlib import Path

import harness
from harness import Row
from viscous_cases import body, error_row

CHANNEL = "Viscosity: channel between two bodies, at an angle to the grid"
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


ALL = [channels]
