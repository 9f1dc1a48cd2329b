"""Scenes changed such that what becomes of them is known: mirrored, bodies in another order, moved by whole cells, carried along.

A Case is a scene and the texts of the files that it names. A change takes a Case and makes another, and `back` of what it returns turns a row
of the other's bodies.csv into what the first should have.
"""
import copy
import math
import tomllib
from dataclasses import dataclass, field
from pathlib import Path

import harness
import random_scene_kinds as kinds


@dataclass
class Case:
    scene: dict
    files: dict = field(default_factory=dict)    # name -> text

    def copy(self):
        return Case(copy.deepcopy(self.scene), dict(self.files))

    @property
    def dimension(self):
        return len(self.scene["domain"]["size"])

    @property
    def dx(self):
        return self.scene["domain"]["size"][0] / self.scene["domain"]["cells"][0]

    @property
    def sides(self):
        """All of them, by name."""
        return {side: "wall" for side in sides_of(self.dimension)} | self.scene["domain"].get("sides", {})

    @property
    def used_files(self):
        return {body["file"]: self.files[body["file"]] for body in self.scene["body"] if "file" in body}

    def text(self):
        return "\n".join([harness.scene_text(self.scene), *self.used_files.values()])

    def write(self, folder, name="scene"):
        """Scene and files into a folder; returns the scene's path."""
        for file, text in self.used_files.items():
            (Path(folder) / file).write_text(text)
        path = Path(folder) / f"{name}.toml"
        path.write_text(harness.scene_text(self.scene))
        return path


def sides_of(dimension):
    return [f"{axis}_{end}" for axis in "xyz"[:dimension] for end in ("low", "high")]


def read_case(file):
    """A Case of a scene file."""
    scene = tomllib.loads(Path(file).read_text())
    names = {body["file"] for body in scene["body"] if "file" in body}
    return Case(scene, {name: (Path(file).parent / name).read_text() for name in names})


def random_case(number, folder):
    """A Case of a random scene's number."""
    scene, _ = kinds.make(number, folder)
    return Case(scene, {body["file"]: (Path(folder) / body["file"]).read_text() for body in scene["body"] if "file" in body})


# ---- mirrored in x

def flip(vector):
    return [-vector[0], *vector[1:]]


def flip_axial(vector):
    """Of what turns: a number in 2D, a pseudovector in 3D."""
    return -vector if isinstance(vector, (int, float)) else [vector[0], *(-v for v in vector[1:])]


def flip_mesh(text, name):
    """Vertices mirrored, faces turned round."""
    if not name.endswith(".obj"):
        points = [line.split() for line in text.splitlines() if line.strip()]
        return "".join(f"{-float(x)!r} {y}\n" for x, y in reversed(points))
    lines = []
    for line in text.splitlines():
        kind, *words = line.split()
        lines.append(f"v {-float(words[0])!r} {words[1]} {words[2]}" if kind == "v" else " ".join(["f", *reversed(words)]))
    return "\n".join(lines) + "\n"


def other_side(name):
    return name.replace("x_low", "x_HIGH").replace("x_high", "x_low").replace("x_HIGH", "x_high")


def mirrored(case):
    made = case.copy()
    scene, width = made.scene, 2 * case.scene["domain"].get("origin", [0.0])[0] + case.scene["domain"]["size"][0]

    def place(x):
        return [width - x[0], *x[1:]]

    if "gravity" in scene:
        scene["gravity"] = flip(scene["gravity"])
    if "velocity" in scene["fluid"]:
        scene["fluid"]["velocity"] = flip(scene["fluid"]["velocity"])
    if sides := scene["domain"].get("sides"):
        scene["domain"]["sides"] = {other_side(side): {k: flip(v) for k, v in what.items()} if isinstance(what, dict) else what for side, what in sides.items()}
    for pair in scene.get("pair", []):
        pair["bodies"] = [other_side(name) for name in pair["bodies"]]
    for body in scene["body"]:
        body["position"] = place(body.get("position", [0.0] * case.dimension))
        for key, change in {"velocity": flip, "force": flip, "normal": flip, "angular_velocity": flip_axial, "torque": flip_axial}.items():
            if key in body:
                body[key] = change(body[key])
        if "rotation" in body:    # 2D: an angle; 3D: a quaternion, its vector turns
            body["rotation"] = -body["rotation"] if case.dimension == 2 else [body["rotation"][0], *flip_axial(body["rotation"][1:])]
        if "hinge" in body:
            body["hinge"]["point"] = place(body["hinge"]["point"])
            if "axis" in body["hinge"]:
                body["hinge"]["axis"] = flip_axial(body["hinge"]["axis"])
        if "spring" in body:
            body["spring"]["anchor"] = place(body["spring"]["anchor"])
    made.files = {name: flip_mesh(text, name) for name, text in made.files.items()}

    def back(row):
        return {**row, "x": width - row["x"], "vx": -row["vx"], **{k: -row[k] for k in ("angle", "omega", "wy", "wz") if k in row}}

    return made, back


# ---- the same in another order

def reordered(case):
    made = case.copy()
    made.scene["body"].reverse()
    return made, dict


# ---- moved

def moved(case, way):
    """Everything in the tank by a vector; the tank stays where it is."""
    made = case.copy()
    for body in made.scene["body"]:
        body["position"] = [x + w for x, w in zip(body.get("position", [0.0] * case.dimension), way)]
        for table, key in (("hinge", "point"), ("spring", "anchor")):
            if table in body:
                body[table][key] = [x + w for x, w in zip(body[table][key], way)]
    return made


def shifted(case, cells=5):
    """Along x by whole cells, in a tank that is periodic there."""
    if case.sides["x_low"] != "periodic":
        return None
    way = cells * case.dx
    return moved(case, [way] + [0.0] * (case.dimension - 1)), lambda row: {**row, "x": row["x"] - way}


def unbounded(case):
    """What there is of a scene without anything that stands still: periodic sides, no weight, no bodies that are held. Bodies at rest get velocities."""
    made = case.copy()
    scene = made.scene
    scene["gravity"] = [0.0] * case.dimension
    scene["domain"]["sides"] = {side: "periodic" for side in sides_of(case.dimension)}
    scene["fluid"] = {key: value for key, value in scene["fluid"].items() if key in ("density", "viscosity")}
    scene["body"] = [body for body in scene["body"] if body.get("motion", "free") == "free" and "hinge" not in body and not body.get("inside_out")]
    scene["pair"] = [pair for pair in scene.get("pair", []) if not any(name.startswith("wall:") for name in pair["bodies"])]
    scene["gap"] = {key: value for key, value in scene.get("gap", {}).items() if key != "contact"}
    for k, body in enumerate(scene["body"]):
        for key in ("spring", "force", "torque"):
            body.pop(key, None)
        if not any(body.get("velocity", [0.0])):
            turn, speed = 2.4 * (k + 1), 0.1 * case.dx / scene["time"]["max_step"]    # a tenth of a cell a step, each its own way
            body["velocity"] = [speed * math.cos(turn), speed * math.sin(turn), 0.0][:case.dimension]
    return made if scene["body"] else None


def carried(case, cells):
    """Fluid and bodies get a velocity of so many cells a step along x more; where nothing stands still."""
    if set(case.sides.values()) != {"periodic"} or any(body.get("motion", "free") != "free" or "hinge" in body or "spring" in body for body in case.scene["body"]):
        return None
    made = case.copy()
    speed = cells * case.dx / case.scene["time"]["max_step"]
    way = [speed] + [0.0] * (case.dimension - 1)
    made.scene["fluid"]["velocity"] = [a + b for a, b in zip(made.scene["fluid"].get("velocity", [0.0] * 3), way)]
    for body in made.scene["body"]:
        body["velocity"] = [a + b for a, b in zip(body.get("velocity", [0.0] * 3), way)]
    return made, lambda row: {**row, "x": row["x"] - speed * row["time"], "vx": row["vx"] - speed}
