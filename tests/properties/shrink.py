"""The smallest scene that still fails: bodies, keys, steps, cells and digits are taken away as long as the failure stays.

    smallest(case, fails, seconds)    fails: Case -> whether it fails
Every change makes a scene smaller in the order of size(), so the search ends: where no change is left that fails, or when its time is over.
"""
import math
import re
import time

import scene_changes as changes

LEAST_CELLS = 4
SHAPES = ("ball", "box", "capsule", "cylinder", "half-space", "mesh")    # simplest first
NEEDED = {"name", "shape", "size", "radius", "length", "normal", "file", "density", "mass", "inertia", "position"}    # of a body, as its shape has it


def steps_of(case):
    return math.ceil(case.scene["time"]["end"] / case.scene["time"]["max_step"] - 1e-6)


def digits(value):
    """Significant digits of all numbers in a value."""
    if isinstance(value, dict):
        return sum(map(digits, value.values()))
    if isinstance(value, (list, tuple)):
        return sum(map(digits, value))
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return 0
    mantissa = f"{abs(value)!r}".partition("e")[0].replace(".", "").strip("0")
    return len(mantissa)


def keys(table):
    return sum(keys(value) if isinstance(value, dict) else 1 for value in table.values())


def size(case):
    """What is to become small, first things first."""
    scene, bodies = case.scene, case.scene["body"]
    tables = {name: table for name, table in scene.items() if isinstance(table, dict)}
    pairs = scene.get("pair", [])
    return (len(bodies), len(pairs) + sum(map(keys, [*tables.values(), *bodies, *pairs])) + len(scene) + any(scene.get("gravity", [])),
            sum(SHAPES.index(body["shape"]) for body in bodies) + sum(text.count("\n") for text in case.used_files.values()),
            steps_of(case), math.prod(scene["domain"]["cells"]),
            digits([v for k, v in scene.items() if k not in ("domain", "time")] + [scene["domain"].get("sides", {}), round(case.dx, 12), scene["time"]["max_step"]])
            + sum(digits([float(n) for n in re.findall(r"-?\d\S*", text)]) for text in case.used_files.values()))


# ---- changes: each takes a case and yields smaller ones

def fewer_bodies(case):
    count = len(case.scene["body"])
    part = count // 2
    while part > 0:
        for first in range(0, count, part):
            made = case.copy()
            gone = {body["name"] for body in made.scene["body"][first:first + part]}
            del made.scene["body"][first:first + part]
            if "pair" in made.scene:
                made.scene["pair"] = [pair for pair in made.scene["pair"] if not gone & set(pair["bodies"])]
                if not made.scene["pair"]:
                    del made.scene["pair"]
            if made.scene["body"]:
                yield made
        part //= 2


def fewer_keys(case):
    def without(*path):
        made = case.copy()
        table = made.scene
        for key in path[:-1]:
            table = table[key]
        del table[path[-1]]
        return made

    for name in ("pair", "gap", "contact", "grid", "solver", "output", "gravity", "title"):
        if name in case.scene:
            yield without(name)
    for k in range(len(case.scene.get("pair", [])) if len(case.scene.get("pair", [])) > 1 else 0):
        yield without("pair", k)
    for name in ("fluid", "gap", "contact", "grid", "solver"):
        for key in case.scene.get(name, {}):
            yield without(name, key)
    if sides := case.scene["domain"].get("sides"):
        yield without("domain", "sides")
        for axis in "xyz":
            both = [side for side in sides if side[0] == axis]
            if len(both) == 2:    # periodic at one end alone there is not
                made = without("domain", "sides", both[0])
                del made.scene["domain"]["sides"][both[1]]
                yield made
            for side in both:
                yield without("domain", "sides", side)
    for k, body in enumerate(case.scene["body"]):
        for key in body:
            if key not in NEEDED:
                yield without("body", k, key)


def simpler_shapes(case):
    """Meshes and others by balls and boxes; meshes of fewer points."""
    for k, body in enumerate(case.scene["body"]):
        reach = body["radius"] + body.get("length", 0.0) / 2 if "radius" in body else min(body["size"]) / 2 if "size" in body else None
        if body["shape"] == "mesh":
            text = case.files[body["file"]]
            numbers = [abs(float(n)) for line in text.splitlines() if not line.startswith("f") for n in line.split() if n != "v"]
            reach = max(numbers)
            if not body["file"].endswith(".obj"):
                lines = text.splitlines()
                for i in range(len(lines) if len(lines) > 3 else 0):
                    made = case.copy()
                    made.files[body["file"]] = "\n".join(lines[:i] + lines[i + 1:]) + "\n"
                    yield made
        if reach is None:
            continue
        for shape in ("ball", "box"):
            for part in (1.0, 0.7):
                made = case.copy()
                entry = {key: value for key, value in body.items() if key not in ("shape", "size", "radius", "length", "file")}
                other = {"radius": part * reach} if shape == "ball" else {"size": [2 * part * reach] * case.dimension}
                made.scene["body"][k] = {"name": entry.pop("name"), "shape": shape, **other, **entry}
                yield made


def fewer_steps(case):
    steps = steps_of(case)
    for count in sorted({1, 2, steps // 4, steps // 2, steps * 3 // 4, steps - 1} - {0}):
        if count < steps:
            made = case.copy()
            made.scene["time"]["end"] = count * made.scene["time"]["max_step"]
            yield made


def fewer_cells(case):
    """Coarser, or cut off at one end."""
    cells, dx = case.scene["domain"]["cells"], case.dx

    def tank(of, spacing):
        made = case.copy()
        made.scene["domain"].update(cells=of, size=[n * spacing for n in of])
        return made

    if min(cells) >= 2 * LEAST_CELLS:
        yield tank([n // 2 for n in cells], 2 * dx)
        yield tank([(n * 3 + 3) // 4 for n in cells], 4 / 3 * dx)
    for axis in range(case.dimension):
        for less in (cells[axis] // 2, cells[axis] // 4, 8, 4, 2, 1):
            if 0 < less and cells[axis] - less >= LEAST_CELLS:
                made = tank([n - less * (k == axis) for k, n in enumerate(cells)], dx)
                yield made
                yield changes.moved(made, [-less * dx * (k == axis) for k in range(case.dimension)])


def rounded(value, count):
    """To so many significant digits."""
    if isinstance(value, bool) or not isinstance(value, float) or not math.isfinite(value) or value == 0:
        return value
    return float(f"{value:.{count - 1}e}")


def numbers_in(value, path=()):
    """(path, number) of all numbers that are not whole ones."""
    for key, part in value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ():
        if isinstance(part, float):
            yield (*path, key), part
        else:
            yield from numbers_in(part, (*path, key))


def rounder_numbers(case):
    """All at once; the spacing; one by one, to 0, 1 or few digits; a mesh's."""
    def put(made, path, value):
        table = made.scene
        for key in path[:-1]:
            table = table[key]
        table[path[-1]] = value

    def grid(made, spacing):
        made.scene["domain"]["size"] = [n * spacing for n in made.scene["domain"]["cells"]]

    def step_length(made, count):
        step = rounded(case.scene["time"]["max_step"], count)
        made.scene["time"].update(max_step=step, end=steps * step)

    steps = steps_of(case)
    paths = [(path, number) for path, number in numbers_in(case.scene) if path[0] != "time" and (path[0] != "domain" or path[1] == "sides")]
    for count in (1, 2, 3, 4, 6):
        made = case.copy()
        for path, number in paths:
            put(made, path, rounded(number, count))
        grid(made, rounded(case.dx, count))
        step_length(made, count)
        yield made
    for count in (1, 2, 3):
        made = case.copy()
        grid(made, rounded(case.dx, count))
        yield made
        made = case.copy()
        step_length(made, count)
        yield made
    for path, number in paths:
        for value in dict.fromkeys([0.0, math.copysign(1.0, number), *(rounded(number, count) for count in (1, 2, 3, 4))]):
            if value != number:
                made = case.copy()
                put(made, path, value)
                yield made
    for name, text in case.used_files.items():
        for count in (1, 2, 3):
            made = case.copy()
            made.files[name] = re.sub(r"-?\d+\.\S*", lambda number: repr(rounded(float(number[0]), count)), text)
            yield made


CHANGES = (fewer_bodies, fewer_steps, fewer_cells, fewer_keys, simpler_shapes, rounder_numbers)


def smallest(case, fails, seconds=60.0, tell=lambda text: None):
    """(the smallest case found, whether nothing smaller is left)."""
    until, tried = time.monotonic() + seconds, set()
    found = True
    while found:
        found = False
        for change in CHANGES:
            again = True
            while again:
                again = False
                for made in change(case):
                    if time.monotonic() > until:
                        return case, False
                    text = made.text()
                    if text in tried or size(made) >= size(case):
                        continue
                    tried.add(text)
                    if fails(made):
                        case, found, again = made, True, True
                        tell(f"{change.__name__.replace('_', ' ')}: {described(case)}")
                        break
    return case, True


def described(case):
    bodies, cells = len(case.scene["body"]), "x".join(map(str, case.scene["domain"]["cells"]))
    return f"{bodies} {'body' if bodies == 1 else 'bodies'}, {steps_of(case)} {'step' if steps_of(case) == 1 else 'steps'}, {cells} cells, {size(case)[1]} keys"
