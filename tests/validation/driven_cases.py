"""Periodic boxes that a mean pressure gradient drives: channels, arrays of spheres and cylinders, neutral disks in shear."""
import math

import harness
from harness import Row
from viscous_cases import error_row

CHANNEL = "Driven channels"
ARRAYS = "Stokes flow through periodic arrays, driven by a pressure gradient"
DISK = "A neutrally buoyant disk in a driven channel"

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
    flow, gradient = stokes(dimension, cells * bodies_a_side, "xyz"[:dimension], drive, bodies, float(bodies_a_side), 60 if dimension == 3 else 100)
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


ALL = [channels, spheres, cylinders]
