"""Momentum in films: flow through throats, bodies that roll over corners, a collision after its impact."""
import json
import tempfile
from pathlib import Path

import contact_cases
import harness
from harness import ROOT, Row


def throats(quick):
    """The films' own part. In 2D a swirl around a cylinder that nearly touches the ring around it; in 3D fluxes through the film's mouths and the flow around it are given, and energy
    above the first is vorticity."""
    if quick:
        return
    section = "Steady flow through the throat of bodies that nearly touch, films alone: gaps of 0.1, 0.01, 0.001, 1e-4 cells"
    for test, name in (("CylinderInARingKeepsItsFlow", "swirl around a cylinder in a ring (clearance 0.04 of the radius)"), ("BallsKeepTheirFlow", "two balls"),
                       ("BallOverAFloorKeepsItsFlow", "ball over a floor")):
        found, _ = harness.unit_figures("unit_stepping", f"FilmThroat.{test}")
        for key, steps in (("resolved", "20 crossings of the throat, 20 steps each"), ("as_runs", "400 steps as long as in runs")):
            pairs = [[float(x) for x in pair.split(",")] for pair in found[key].replace("%", "").split(";")]
            yield Row(section, f"{name}, 4 cells a radius, {steps}: highest energy over the first, last", "≤ +0.1 %, ≥ -5 %", found[key],
                      all(highest <= 0.1 and last >= -5 for highest, last in pairs))


def corner_scene(dimension, turn, held):
    """A light capsule is pushed onto the top of a box, along it and over its edge; the box is fixed, or heavy and free. No friction: it slides and tips."""
    flat = dimension == 2
    middle, push = ([], [0.01, -0.02]) if flat else ([0.5], [0.002, 0.0, -0.004])
    box = {"name": "box", "shape": "box", "size": [0.4, *([0.4] * len(middle)), 0.3], "position": [0.32, *middle, 0.25], "density": 4.0,
           "motion": "fixed" if held else "free"}
    capsule = {"name": "capsule", "shape": "capsule", "radius": 0.08, "length": 0.08, "position": [0.44, *middle, 0.53], "density": 0.5, "force": push,
               "velocity": [0.3, *([0.05] * len(middle)), -0.2], "rotation": turn if flat else {"axis": [0.3, 1.0, 0.2], "degrees": turn}}
    return {"domain": {"size": [1.0] * dimension, "cells": [64 if flat else 32] * dimension}, "fluid": {"initial": "potential"}, "contact": {"restitution": 0.5},
            "gap": {"roughness": 1e-3}, "body": [box, capsule], "time": {"end": 0.7, "max_step": 0.01}, "output": {"every": 1.0}}


def rolled(scene):
    """Largest rise of the whole energy over its peak while there is a film (before and after, a body's passage through cells shakes it), whether the capsule ends beyond the
    corner, and how many steps have a film."""
    result = harness.run(scene)
    with_film = [row for row in result["steps"] if row["film_nodes"] > 0]
    rise = contact_cases.energy_rise({"capsule": scene["body"][1]["force"]}, with_film, result["bodies"])
    place = {name: contact_cases.track(result, name)[-1]["x"] for name in ("box", "capsule")}
    return rise, place["capsule"] > place["box"] + 0.2, len(with_film)


def corners(quick):
    if quick:
        return
    section = "A light capsule is pushed over a box's corner in a closed tank"
    for dimension in (2, 3):
        turns = (0.0, 25.0, 60.0, 90.0) if dimension == 2 else (30.0, 90.0)
        for held in (True, False):
            runs = [rolled(corner_scene(dimension, turn, held)) for turn in turns]
            worst, all_beyond = max(rise for rise, _, _ in runs), all(beyond for _, beyond, _ in runs)
            yield Row(section, f"{dimension}D, box {'fixed' if held else 'free'}, capsule turned by {', '.join(f'{turn:g}' for turn in turns)}°, {sum(n for _, _, n in runs)} steps "
                      "with a film: largest rise of the whole energy over the largest kinetic energy; all get beyond the corner", "≤ 0.1 %; yes",
                      f"{', '.join(f'{rise:.2%}' for rise, _, _ in runs)}; {'yes' if all_beyond else 'no'}", worst <= 1e-3 and all_beyond)


def collision(quick):
    if quick:
        return
    section = "Example 07, two cylinders meet and part, after the impact: largest errors against 256²"
    scene = next((ROOT / "examples").glob("07*")) / "scene.toml"
    with tempfile.TemporaryDirectory() as folder:
        harness.command(["converge", scene, "--cells", "32,64,128,256", "--window", "0.3,1.2", "-o", folder, "--quiet", "--set", "output.every=1.2"], timeout=7200)
        found = json.loads((Path(folder) / "converge.json").read_text())["convergence"]
    for entry in found:
        if not entry["quantity"].endswith((".x", ".y", ".vx", ".vy")):
            continue
        errors, slope = [row["error_max"] * entry["range"] for row in entry["rows"]], entry["slope_max"]
        yield Row(section, f"`{entry['quantity']}`, t = 0.3 to 1.2, 32², 64², 128²; slope", "fall; ≥ 0.8",
                  ", ".join(f"{e:.1e}" for e in errors) + ("; none" if slope is None else f"; {slope:.2f}"),
                  all(b < a for a, b in zip(errors, errors[1:])) and slope is not None and slope >= 0.8)


ALL = [throats, corners, collision]
