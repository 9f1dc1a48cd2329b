"""Random configurations that a solver must survive: touching, overlapping, outside the domain, smaller than a cell.

Every case yields one Row a group of configurations. Every configuration follows from its number alone, so a failure is repeated by
    python3 robustness_cases.py added-mass NUMBER...        or      run NUMBER...       or      show added-mass NUMBER
"""
import json
import math
import os
import random
import subprocess
import sys
import tempfile
from collections import defaultdict
from pathlib import Path

import numpy as np

import harness
from harness import Row

SECTION = "Robustness"
CONFIGURATIONS, RUNS = 300, 40
SYMMETRY, SEMIDEFINITE = 1e-6, 1e-6   # relative to the largest entry, eigenvalue


# ---- geometry: rotations, shapes with their support function (furthest point along a direction, in the body's frame)

def rotation_matrix(dimension, rotation):
    if dimension == 2:
        a = math.radians(rotation)
        return np.array([[math.cos(a), -math.sin(a)], [math.sin(a), math.cos(a)]])
    w, x, y, z = np.array(rotation) / np.linalg.norm(rotation)
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def random_rotation(rng, dimension):
    if dimension == 2:
        return rng.choice([0.0, 0.0, 90.0, 45.0, rng.uniform(0, 360)])
    if rng.random() < 0.4:
        return [1.0, 0.0, 0.0, 0.0]
    return [rng.gauss(0, 1) for _ in range(4)]


def unit_vector(rng, dimension):
    v = np.array([rng.gauss(0, 1) for _ in range(dimension)])
    return v / np.linalg.norm(v)


class Shape:
    """A body's shape: its scene keys, support function, flat face normals (body frame), volume, half extent."""

    def __init__(self, keys, support, normals, volume, extent):
        self.keys, self.support, self.normals, self.volume, self.extent = keys, support, normals, volume, extent


def make_box(sides):
    half = 0.5 * np.array(sides)
    d = len(sides)
    normals = [s * np.eye(d)[i] for i in range(d) for s in (1, -1)]
    return Shape({"shape": "box", "size": list(map(float, sides))}, lambda n: np.where(n >= 0, half, -half), normals,
                 float(np.prod(sides)), float(half.max()))


def make_ball(dimension, radius):
    volume = math.pi * radius**2 if dimension == 2 else 4 / 3 * math.pi * radius**3
    return Shape({"shape": "ball", "radius": radius}, lambda n: radius * n / np.linalg.norm(n), [], volume, radius)


def make_capsule(dimension, radius, length):
    axis = np.eye(dimension)[0]
    volume = (math.pi * radius**2 + 2 * radius * length if dimension == 2
              else math.pi * radius**2 * length + 4 / 3 * math.pi * radius**3)
    return Shape({"shape": "capsule", "radius": radius, "length": length},
                 lambda n: radius * n / np.linalg.norm(n) + 0.5 * length * np.sign(n[0]) * axis, [], volume,
                 radius + 0.5 * length)


def make_cylinder(radius, length):
    def support(n):
        side = np.array([0.0, n[1], n[2]])
        size = np.linalg.norm(side)
        return np.array([0.5 * length * (1 if n[0] >= 0 else -1), 0, 0]) + (radius / size * side if size > 1e-12 else 0)
    return Shape({"shape": "cylinder", "radius": radius, "length": length}, support,
                 [np.array([1.0, 0, 0]), np.array([-1.0, 0, 0])], math.pi * radius**2 * length, max(radius, 0.5 * length))


def make_polygon(rng, folder, name, size):
    """A star-shaped polygon, written to a file."""
    count = rng.randint(3, 9)
    angles = [2 * math.pi * (k + 0.6 * rng.random()) / count for k in range(count)]
    points = np.array([size * rng.uniform(0.4 if count > 4 else 0.8, 1.0) * np.array([math.cos(a), math.sin(a)]) for a in angles])
    file = Path(folder) / f"{name}.txt"
    file.write_text("".join(f"{x!r} {y!r}\n" for x, y in points.tolist()))
    x, y = points.T
    area = 0.5 * float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y))
    return Shape({"shape": "mesh", "file": str(file)}, lambda n: points[np.argmax(points @ n)], [], area, size)


def make_mesh(rng, folder, name, size):
    """A tetrahedron, an octahedron (stretched) or a box with the corners of its triangles moved, written as OBJ."""
    kind = rng.choice(["tetrahedron", "octahedron", "box"])
    if kind == "tetrahedron":
        points = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]], float) / math.sqrt(3)
        faces = [(0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)]
    elif kind == "octahedron":
        points = np.vstack([np.eye(3), -np.eye(3)])
        faces = [(0, 1, 2), (1, 3, 2), (3, 4, 2), (4, 0, 2), (1, 0, 5), (3, 1, 5), (4, 3, 5), (0, 4, 5)]
    else:
        points = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], float) / math.sqrt(3)
        quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
        faces = [f for a, b, c, d in quads for f in ((a, b, c), (a, c, d))]
    points = size * points * np.array([rng.uniform(0.5, 1) for _ in range(3)])
    volume = sum(np.dot(points[a], np.cross(points[b], points[c])) for a, b, c in faces) / 6
    if volume < 0:
        faces = [(a, c, b) for a, b, c in faces]
    file = Path(folder) / f"{name}.obj"
    file.write_text("".join("v {!r} {!r} {!r}\n".format(*p) for p in points.tolist()) +
                    "".join(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in faces))
    return Shape({"shape": "mesh", "file": str(file)}, lambda n: points[np.argmax(points @ n)], [], abs(float(volume)), size)


def random_shape(rng, dimension, size, folder, name):
    kind = rng.choice(["box", "box", "box", "ball", "ball", "capsule", "mesh"] + (["cylinder"] if dimension == 3 else []))
    if kind == "box":
        return make_box([size * rng.uniform(0.3, 1.5) for _ in range(dimension)])
    if kind == "ball":
        return make_ball(dimension, 0.5 * size)
    if kind == "capsule":
        return make_capsule(dimension, 0.3 * size, size * rng.uniform(0.3, 1.2))
    if kind == "cylinder":
        return make_cylinder(0.5 * size * rng.uniform(0.5, 1), size * rng.uniform(0.3, 1.2))
    return (make_polygon if dimension == 2 else make_mesh)(rng, folder, name, 0.6 * size)


class Body:
    def __init__(self, name, shape, rotation, dimension):
        self.name, self.shape, self.rotation = name, shape, rotation
        self.matrix = rotation_matrix(dimension, rotation)
        self.position = np.zeros(dimension)
        self.keys = {}

    def support(self, n):
        return self.position + self.matrix @ self.shape.support(self.matrix.T @ n)

    def entry(self):
        return {"name": self.name, **self.shape.keys, "position": self.position.tolist(), "rotation": self.rotation, **self.keys}


# ---- configurations

def random_sides(rng, dimension, cells):
    sides = {}
    for axis in "xyz"[:dimension]:
        kind = rng.choice(["wall", "wall", "open", "mixed", "periodic"])
        if kind == "mixed":
            sides[f"{axis}_{rng.choice(['low', 'high'])}"] = "open"
        elif kind != "wall":
            sides[f"{axis}_low"] = sides[f"{axis}_high"] = kind
    return sides


def place_beside(rng, dimension, body, host, gap):
    """Puts the body against the host (convex hulls `gap` apart, negative: overlapping); faces meet where both have some."""
    inside = host.keys.get("inside_out", False)
    if host.shape.normals and rng.random() < 0.7:
        n = host.matrix @ rng.choice(host.shape.normals)
        if body.shape.normals and rng.random() < 0.8:
            body.rotation, body.matrix = host.rotation, host.matrix
    else:
        n = unit_vector(rng, dimension)
    along = unit_vector(rng, dimension)
    along = (along - along.dot(n) * n) * rng.choice([0, 0, 1]) * rng.uniform(0, 0.8) * min(host.shape.extent, body.shape.extent)
    own = body.matrix @ body.shape.support(body.matrix.T @ (n if inside else -n))
    body.position = host.support(n) + (-gap if inside else gap) * n - own + along


def random_bodies(rng, dimension, size, dx, mode, folder):
    count = rng.randint(2, 12 if dimension == 2 else 6 if rng.random() < 0.8 else 12)
    scale = 0.35 * min(size) * (3 / (count + 2)) ** (1 / dimension) * rng.uniform(0.7, 1.3)
    bodies = []
    for k in range(count):
        tiny = mode == "small" and rng.random() < 0.5
        body_size = dx * 10 ** rng.uniform(-2, 0) if tiny else max(scale * rng.uniform(0.5, 1.2), 2 * dx)
        name = f"b{k}"
        body = Body(name, random_shape(rng, dimension, body_size, folder, name), random_rotation(rng, dimension), dimension)
        body.position = np.array([rng.uniform(0.1, 0.9) * s for s in size])
        if mode == "container" and k == 0:
            box = rng.random() < 0.5
            shape = make_box([rng.uniform(0.5, 1.2) * s for s in size]) if box else make_ball(dimension, rng.uniform(0.3, 0.6) * min(size))
            body = Body(name, shape, random_rotation(rng, dimension), dimension)
            body.position = np.array([0.5 * s + rng.choice([0, rng.uniform(-0.05, 0.05) * s]) for s in size])
            body.keys["inside_out"] = True
        elif bodies and mode in ("touching", "overlapping", "gap", "container") and (k == 1 or rng.random() < 0.7):
            gap = {"touching": 0.0, "overlapping": -rng.choice([1e-9, 1e-3, 0.3, 1, 3]) * dx * rng.uniform(0.5, 1),
                   "gap": 10 ** rng.uniform(-7, 0) * dx,
                   "container": rng.choice([0.0, 0.0, 1e-6, 0.1, -0.1, -1.0]) * dx}[mode]
            place_beside(rng, dimension, body, bodies[0] if mode == "container" else rng.choice(bodies), gap)
        elif mode == "overlapping" and bodies:
            body.position = rng.choice(bodies).position + 0.3 * body_size * unit_vector(rng, dimension)
        elif mode == "outside" and (k == 0 or rng.random() < 0.6):
            axis = rng.randrange(dimension)
            depth = rng.choice([0.0, rng.uniform(-0.5, 0.5), 3.0]) * body_size   # half outside, partly, wholly
            body.position[axis] = -depth if rng.random() < 0.5 else size[axis] + depth
        elif mode == "wall" and (k == 0 or rng.random() < 0.7):
            for axis in rng.sample(range(dimension), rng.choice([1, 1, 2])):
                n = np.eye(dimension)[axis] * rng.choice([1, -1])
                gap = rng.choice([0.0, 0.0, 1e-7, 1e-2, -1e-3, -0.5]) * dx
                wall = size[axis] if n[axis] > 0 else 0.0
                body.position[axis] += wall - n[axis] * gap - body.support(n)[axis]
        bodies.append(body)
    return bodies


def sealing_bodies(rng, dimension, size, dx):
    """A frame of boxes that overlap at its corners around a hole; returns the bodies and the hole's volume."""
    hole = np.array([rng.uniform(4, 8) * dx for _ in range(dimension)])
    thick = 3 * dx
    rotation = random_rotation(rng, dimension)
    centre = np.array([0.5 * s for s in size])
    bodies = []
    for axis in range(dimension):
        for end in (1, -1):
            sides = hole + 2 * thick
            sides[axis] = thick
            body = Body(f"frame{len(bodies)}", make_box(sides), rotation, dimension)
            body.position = centre + body.matrix @ (0.5 * end * (hole[axis] + thick) * np.eye(dimension)[axis])
            bodies.append(body)
    return bodies, float(np.prod(hole))


MODES = ["touching", "overlapping", "gap", "wall", "outside", "small", "container", "random", "touching", "overlapping", "sealing"]


def configuration(number, folder):
    """(scene, facts) of added-mass configuration `number`."""
    rng = random.Random(f"gapflow added mass {number}")
    mode = MODES[number % len(MODES)]
    dimension = 3 if rng.random() < 0.4 else 2
    if mode == "sealing":
        cells = [rng.randrange(32, 65) if dimension == 2 else rng.randrange(20, 29) for _ in range(dimension)]
    elif dimension == 2:
        cells = [rng.randrange(32, 97) for _ in range(2)]
    else:
        cells = [rng.randrange(16, 33) for _ in range(3)]
    dx = rng.choice([0.0625, 0.1, 1 / 30])
    size = [c * dx for c in cells]
    hole = None
    if mode == "sealing":
        bodies, hole = sealing_bodies(rng, dimension, size, dx)
    else:
        bodies = random_bodies(rng, dimension, size, dx, mode, folder)
    still = {"velocity": [0.0] * dimension}
    for body in bodies:
        motion = rng.choice(["free", "free", "free", "fixed", "prescribed"])
        if body.keys.get("inside_out") and motion == "free":
            motion = "prescribed"
        body.keys["motion"] = motion
        if motion == "prescribed":
            body.keys.update(still)
    if all(body.keys["motion"] == "fixed" for body in bodies):
        bodies[-1].keys.update(motion="prescribed", **still)
    fractions = rng.choice(["cut-cell", "cut-cell", "voxel"])
    scene = {"domain": {"size": size, "cells": cells, "sides": random_sides(rng, dimension, cells)},
             "grid": {"fractions": fractions, "thin": "allow"}, "body": [body.entry() for body in bodies]}
    facts = {"mode": mode, "dimension": dimension, "hole": hole, "dx": dx, "fractions": fractions,
             "names": {body.name for body in bodies}}
    return scene, facts


def defects_of_added_mass(number, timeout=60):
    """What is wrong with configuration `number`: a list of short texts, empty when all is well; and its facts."""
    with tempfile.TemporaryDirectory() as folder:
        scene, facts = configuration(number, folder)
        file = Path(folder) / "scene.toml"
        file.write_text(harness.scene_text(scene))
        try:
            done = harness.command(["added-mass", file, "--json"], check=False, timeout=timeout)
        except subprocess.TimeoutExpired:
            return [f"not done in {timeout} s"], facts
    if done.returncode != 0:
        return [f"exit {done.returncode}: {done.stderr.strip()[-300:]}"], facts
    result = json.loads(done.stdout)
    facts["seconds"] = result["seconds"]
    facts["iterations"] = max(result["iterations"])
    if any(entry is None for row in result["matrix"] for entry in row):
        return ["NaN in the matrix"], facts
    matrix = np.array(result["matrix"], float)
    if not np.isfinite(matrix).all():
        return ["NaN in the matrix"], facts
    defects = []
    largest = np.abs(matrix).max()
    asymmetry = np.abs(matrix - matrix.T).max() / max(largest, 1e-300)
    if asymmetry > SYMMETRY:
        defects.append(f"asymmetry {asymmetry:.1e}")
    values = np.linalg.eigvalsh(0.5 * (matrix + matrix.T))
    if values[0] < -SEMIDEFINITE * values[-1]:
        defects.append(f"eigenvalue {values[0] / values[-1]:.1e}")
    if facts["hole"]:
        cells = facts["hole"] / facts["dx"] ** facts["dimension"]
        named = [pocket for pocket in result["sealed"] if set(pocket["bodies"]) == facts["names"]]
        if not any(0.5 * cells < pocket["cells"] < 2.5 * cells for pocket in named):
            defects.append(f"a sealed hole of {cells:.0f} cells is not named: {json.dumps(result['sealed'])}")
    return defects, facts


# ---- short runs

def run_configuration(number, folder):
    rng = random.Random(f"gapflow run {number}")
    dimension = 3 if number % 4 == 3 else 2
    cells = [rng.randrange(32, 65) if dimension == 2 else rng.randrange(16, 25) for _ in range(dimension)]
    dx = rng.choice([0.0625, 0.1])
    size = [c * dx for c in cells]
    mode = ["touching", "random", "gap", "overlapping", "wall", "small", "outside"][number % 7]
    bodies = random_bodies(rng, dimension, size, dx, mode, folder)[:6]
    for body in bodies:
        body.keys.update(motion="free", density=10 ** rng.uniform(-3, 3))
        if rng.random() < 0.5:
            body.keys["velocity"] = (0.3 * unit_vector(rng, dimension)).tolist()
    gravity = (-rng.choice([1.0, 9.81]) * np.eye(dimension)[dimension - 1]).tolist()
    scene = {"gravity": gravity, "domain": {"size": size, "cells": cells, "sides": random_sides(rng, dimension, cells)},
             "grid": {"fractions": rng.choice(["cut-cell", "cut-cell", "voxel"]), "thin": "allow"}, "body": [body.entry() for body in bodies],
             "time": {"end": 5 * 0.01, "max_step": 0.01, "cfl": 1.0, "gap_cfl": 1.0},
             "output": {"every": 10.0, "checkpoint_every": 10.0}}
    return scene, {"mode": mode, "dimension": dimension, "bodies": bodies, "gravity": gravity}


def defects_of_run(number, timeout=120):
    with tempfile.TemporaryDirectory() as folder:
        scene, facts = run_configuration(number, folder)
        file, out = Path(folder) / "scene.toml", Path(folder) / "out"
        file.write_text(harness.scene_text(scene))
        try:
            done = harness.command(["run", file, "-o", out, "--quiet"], check=False, timeout=timeout)
        except subprocess.TimeoutExpired:
            return [f"not done in {timeout} s"], facts
        if done.returncode != 0:
            return [f"exit {done.returncode}: {done.stderr.strip()[-300:]}"], facts
        tables = {name: harness.read_table(out / f"{name}.csv") for name in ("bodies", "gaps", "steps")}
    defects = [f"not finite: {name}.csv {key} at step {row['step']:.0f}" for name, table in tables.items() for row in table
               for key, value in row.items() if isinstance(value, float) and not math.isfinite(value)
               and not (name == "gaps" and key.startswith("pressure"))][:3]
    # Energy: no more than what gravity's work can give (reduced weight times the way fallen), with a margin.
    steps, first = tables["steps"], {row["body"]: row for row in tables["bodies"] if row["step"] == 0}
    energy = [row["energy_fluid"] + row["energy_bodies"] for row in steps]
    volume = {body.name: (body.shape.volume, body.keys["density"]) for body in facts["bodies"]}
    work = defaultdict(float)
    for row in tables["bodies"]:
        v, density = volume[row["body"]]
        way = [row[a] - first[row["body"]][a] for a in "xyz"[:facts["dimension"]]]
        work[row["step"]] += (density - 1) * v * np.dot(facts["gravity"], way)
    worst = max(e - energy[0] - max(work[row["step"]], 0) for e, row in zip(energy, steps))
    margin = 0.1 * (energy[0] + max(abs(w) for w in work.values())) + 1e-12
    facts["excess"] = worst / margin * 0.1
    if worst > margin:
        defects.append(f"energy grows by {worst:.2e} more than gravity's work, allowed {margin:.2e}")
    return defects, facts


# ---- rows

def rows_of(groups, target):
    for name in sorted(groups):
        count, defects = groups[name]
        bad = len({defect.split(":")[0] for defect in defects})
        yield Row(SECTION, f"{name}: {count} random configurations", target(name),
                  f"{count - bad} of {count}" + ("; " + "; ".join(defects)[:300] if defects else ""), not defects)


def grouped(numbers, examine, name):
    """{group: [count, defects]}"""
    groups = defaultdict(lambda: [0, []])
    for number in numbers:
        defects, facts = examine(number)
        group = groups[name(facts)]
        group[0] += 1
        group[1] += [f"{number}: {defect}" for defect in defects]
    return groups


def random_added_mass(quick):
    groups = grouped(range(40 if quick else CONFIGURATIONS), defects_of_added_mass, lambda facts: f"added mass, {facts['mode']}, {facts['dimension']}D")
    yield from rows_of(groups, lambda name: "converged, symmetric and semidefinite to 1e-6" + (", pocket named" if "sealing" in name else ""))


def random_runs(quick):
    if quick:
        return    # free bodies that overlap need contact: known misses, in the long table
    groups = grouped(range(RUNS), defects_of_run, lambda facts: f"5 steps of free bodies, densities 1e-3 to 1e3, {facts['dimension']}D")
    yield from rows_of(groups, lambda name: "no crash, no NaN, energy bounded")


ALL = [random_added_mass, random_runs]


def main():
    kind, *numbers = sys.argv[1:]
    show = kind == "show"
    if show:
        kind, *numbers = numbers
    make, examine = ((configuration, defects_of_added_mass) if kind == "added-mass" else (run_configuration, defects_of_run))
    failed = 0
    for word in numbers:
        first, _, last = word.partition("-")
        for number in range(int(first), int(last or first) + 1):
            if show:   # the scene and its meshes into the current folder
                scene, _ = make(number, os.getcwd())
                print(harness.scene_text(scene))
                continue
            defects, facts = examine(number)
            facts = {k: facts[k] for k in ("mode", "dimension", "fractions", "seconds", "iterations", "excess") if k in facts}
            failed += bool(defects)
            print(number, "FAIL " + "; ".join(defects) if defects else "ok", facts, flush=True)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
