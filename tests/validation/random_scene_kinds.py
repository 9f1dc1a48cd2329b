"""Random scenes of bodies that touch, by kind, and of what was once wrong without a word: every scene follows from its number alone.

make(number, folder) makes one. Lengths are laid out in cells and multiples of the tank; gravity, the fluid's density and the tank's
size are drawn from round values, so that no result depends on units. Bodies are at least three cells thick. A step of full length
takes what has fallen a fifth of the tank a quarter of a cell.
"""
import math
import random
from pathlib import Path

import numpy as np

import robustness_cases as shapes

FLAT, SOLID = 300, 60    # scenes in 2D, numbered from 0, and in 3D, numbered after them
FIRST_ATTACK = FLAT + SOLID
ATTACKS = 140            # scenes of what was once wrong without a word, numbered after those: of each kind five in 2D to two in 3D
STEPS = 200
THICK = 3                # cells: the least of a body
SCATTER = 40             # tries to find a body a place


def directions(dimension):
    if dimension == 2:
        return [np.array([math.cos(a), math.sin(a)]) for a in np.arange(120) * math.pi / 60]
    count, golden = 200, math.pi * (3 - math.sqrt(5))
    heights = [1 - 2 * (k + 0.5) / count for k in range(count)]
    return [np.array([math.sqrt(1 - z * z) * math.cos(k * golden), math.sqrt(1 - z * z) * math.sin(k * golden), z]) for k, z in enumerate(heights)]


DIRECTIONS = {2: directions(2), 3: directions(3)}


def separation(a, b):
    """Distance of two convex bodies (negative: how deep they overlap), found from above by a few hundred directions."""
    towards = b.position - a.position
    normals = [body.matrix @ n for body in (a, b) for n in body.shape.normals] + DIRECTIONS[len(towards)] + [towards / max(np.linalg.norm(towards), 1e-300)]
    return max(float((b.support(-n) - a.support(n)) @ n) for n in normals)


def triangles(points):
    """Of a simple polygon, counterclockwise: triples of indices (ear clipping)."""
    def turn(a, b, c):
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    left, found = list(range(len(points))), []
    while len(left) > 3:
        for k in range(len(left)):
            i, j, m = left[k - 1], left[k], left[(k + 1) % len(left)]
            a, b, c = points[i], points[j], points[m]
            others = [points[q] for q in left if q not in (i, j, m)]
            if turn(a, b, c) > 1e-14 and not any(turn(a, b, p) >= 0 and turn(b, c, p) >= 0 and turn(c, a, p) >= 0 for p in others):
                found.append((i, j, m))
                left.pop(k)
                break
        else:
            raise ValueError("not a simple polygon")
    return found + [tuple(left)]


def make_outline(points, folder, name, depth=None):
    """A body of a counterclockwise polygon; in 3D extruded along z by `depth`. Its support function is that of the convex hull."""
    points = [tuple(map(float, p)) for p in points]
    x, y = np.array(points).T
    area = 0.5 * float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y))
    if depth is None:
        file = Path(folder) / f"{name}.txt"
        file.write_text("".join(f"{a!r} {b!r}\n" for a, b in points))
        corners = np.array(points)
    else:
        n = len(points)
        corners = np.array([(a, b, z) for z in (-0.5 * depth, 0.5 * depth) for a, b in points])
        faces = [(c, b, a) for a, b, c in triangles(points)] + [(a + n, b + n, c + n) for a, b, c in triangles(points)]
        faces += [f for k in range(n) for f in ((k, (k + 1) % n, n + k), ((k + 1) % n, n + (k + 1) % n, n + k))]
        file = Path(folder) / f"{name}.obj"
        file.write_text("".join("v {!r} {!r} {!r}\n".format(*p) for p in corners.tolist()) + "".join(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in faces))
    return shapes.Shape({"shape": "mesh", "file": file.name}, lambda d: corners[np.argmax(corners @ d)], [], area * (depth or 1.0), float(np.abs(corners).max()))


class Tank:
    """A scene while it is made. Lengths in its own units; `down` is the last axis."""

    def __init__(self, number, folder, attempt=0):
        self.rng = rng = random.Random(f"gapflow random scene {number} {attempt}")
        self.number, self.folder = number, folder
        self.dimension = d = dimension_of(number)
        self.kind = kind_of(number)
        self.cells = [rng.randrange(32, 65) if d == 2 else rng.randrange(16, 25) for _ in range(d)]
        if d == 3 and self.kind in ("cups", "combs"):    # what they are made of takes room
            self.cells = [max(c, 20) for c in self.cells]
        self.dx = rng.choice([1.0, 0.01]) / 40
        self.size = np.array(self.cells) * self.dx
        self.g, self.rho = rng.choice([1.0, 9.81]), rng.choice([1.0, 1000.0])
        self.speed = math.sqrt(0.4 * self.g * self.size[-1])
        self.reynolds = 10 ** rng.uniform(-0.5, 4) if rng.random() < 0.5 else None
        self.gravity = self.axis(-1) * -self.g
        self.bodies, self.sides, self.fluid, self.tables = [], {}, {}, {}
        self.time, self.overlap = {}, None    # of [time]; the deepest overlap allowed, in cells
        self.judge, self.carried = "energy", 0.0    # "energy" of a closed tank, or "speed": bounded by what drives, open sides work too; None: neither
        {**KINDS, **ATTACK_KINDS}[self.kind](self)

    def axis(self, k):
        return np.eye(self.dimension)[k]

    def uniform(self, low, high):
        return self.rng.uniform(low, high)

    def chance(self, p):
        return self.rng.random() < p

    def density(self, low=-3.0, high=3.0):
        return self.rho * 10 ** self.uniform(low, high)

    def turn(self, axis, degrees):
        """A rotation; 2D: about the only axis there is."""
        if self.dimension == 2:
            return float(degrees)
        half = math.radians(degrees) / 2
        return [math.cos(half), *(math.sin(half) * np.eye(3)[axis]).tolist()]

    def lean(self, degrees):
        """Turns the x axis towards the last one."""
        return self.turn(1, degrees if self.dimension == 2 else -degrees)

    def upright(self, degrees):
        """Of an outline: its y axis upwards (0) or downwards (180)."""
        return degrees if self.dimension == 2 else self.turn(0, 90 - degrees)

    def new(self, shape, position=None, rotation=None, **keys):
        body = shapes.Body(f"b{len(self.bodies)}", shape, self.turn(0, 0) if rotation is None else rotation, self.dimension)
        if position is not None:
            body.position = np.array(position, float)
        body.keys.update(keys)
        return body

    def add(self, shape, position, rotation=None, **keys):
        self.bodies.append(self.new(shape, position, rotation, **keys))
        return self.bodies[-1]

    def convex(self, low=None, high=None):
        """A ball, box, capsule, cylinder or convex polygon of so many cells."""
        rng, d, dx = self.rng, self.dimension, self.dx
        s = self.uniform(low or (5 if d == 2 else 4), high or (13 if d == 2 else 8)) * dx
        kind = rng.choice(["ball", "ball", "box", "box", "capsule", "mesh" if d == 2 else "cylinder"])
        if kind == "box":
            return shapes.make_box([max(s * rng.uniform(0.5, 1.3), THICK * dx) for _ in range(d)])
        if kind == "capsule":
            return shapes.make_capsule(d, max(0.3 * s, 0.5 * THICK * dx), s * rng.uniform(0.3, 1.0))
        if kind == "cylinder":
            return shapes.make_cylinder(max(0.5 * s, 0.5 * THICK * dx), max(s * rng.uniform(0.4, 1.2), THICK * dx))
        if kind == "mesh":
            count = rng.randint(3, 7)
            angles = [2 * math.pi * (k + rng.uniform(0, 0.5)) / count for k in range(count)]
            return make_outline([(0.6 * s * math.cos(a), 0.6 * s * math.sin(a)) for a in angles], self.folder, f"b{len(self.bodies)}")
        return shapes.make_ball(d, 0.5 * s)

    def ball(self, low, high):
        return shapes.make_ball(self.dimension, 0.5 * self.uniform(low, high) * self.dx)

    def box(self, sides):
        """Of so many cells along x and the last axis; in 3D as many along y as along x."""
        sides = [s * self.dx for s in sides]
        return shapes.make_box(sides if self.dimension == 2 else [sides[0], sides[0], sides[1]])

    def ridge(self, sides):
        """Of lengths along x and the last axis; in 3D from wall to wall along y."""
        return shapes.make_box(sides if self.dimension == 2 else [sides[0], self.size[1], sides[1]])

    def at(self, x, last):
        """A point in the tank's middle plane."""
        return [x, last] if self.dimension == 2 else [x, 0.5 * self.size[1], last]

    def fits(self, body, overlap=0.0):
        slack = 0.02 * self.dx + overlap
        for k in range(self.dimension):
            low, high = body.support(-self.axis(k))[k], body.support(self.axis(k))[k]
            if low < -slack or high > self.size[k] + slack:
                return False
        return all(separation(other, body) >= -slack for other in self.bodies)

    def against_wall(self, body, axis, end, gap=0.0):
        n = self.axis(axis) * end
        body.position[axis] += (self.size[axis] if end > 0 else 0.0) - end * gap - body.support(n)[axis]

    def cluster(self, count, gap, overlap=0.0, **keys):
        """Bodies beside each other or walls, each `gap()` away from one; those for which there is no room are left out."""
        for _ in range(count):
            shape = self.convex()
            for _ in range(SCATTER):
                body = self.new(shape, [self.uniform(0.15, 0.85) * s for s in self.size], shapes.random_rotation(self.rng, self.dimension))
                if self.bodies and self.chance(0.7):
                    shapes.place_beside(self.rng, self.dimension, body, self.rng.choice(self.bodies), gap())
                else:
                    for axis in self.rng.sample(range(self.dimension), self.rng.choice([1, 1, 2])):
                        self.against_wall(body, axis, self.rng.choice([-1, 1]), gap())
                if self.fits(body, overlap):
                    body.keys.update({"density": self.density(), **{k: v() for k, v in keys.items()}})
                    self.bodies.append(body)
                    break

    def velocity(self, share=0.5):
        return (share * self.speed * shapes.unit_vector(self.rng, self.dimension)).tolist()

    def friction(self, chance=0.5):
        if self.chance(chance):
            self.tables["contact"] = {"friction": self.rng.choice([0.1, 0.3, 1.0])}

    def tilt(self, degrees):
        a = math.radians(degrees)
        self.gravity = self.g * (math.sin(a) * self.axis(0) - math.cos(a) * self.axis(-1))

    def scene(self):
        if self.reynolds:
            self.fluid["viscosity"] = self.rho * self.speed * 0.2 * float(self.size[-1]) / self.reynolds
        step = 0.25 * self.dx / self.speed
        return {"title": f"random scene {self.number}: {self.kind}", "gravity": self.gravity.tolist(),
                "domain": {"size": self.size.tolist(), "cells": self.cells, **({"sides": self.sides} if self.sides else {})},
                "fluid": {"density": self.rho, **self.fluid}, **self.tables,
                "body": [body.entry() for body in self.bodies],
                "time": {"end": 100 * STEPS * step, "max_step": step, **self.time}}


# ---- kinds

def touching(t):
    """Bodies of all shapes that touch each other and walls, at rest or with velocities."""
    moving = t.chance(0.3)
    t.cluster(t.rng.randint(2, 6), lambda: 0.0, **({"velocity": lambda: t.velocity(0.3)} if moving else {}))


def overlapping(t):
    """The same, overlapping by up to a cell."""
    moving = {"velocity": lambda: t.velocity(0.3)} if t.chance(0.4) else {}
    t.cluster(t.rng.randint(2, 5), lambda: -t.rng.choice([1e-3, 0.1, 0.3, 0.6, 1.0]) * t.uniform(0.5, 1) * t.dx, overlap=t.dx, **moving)


def stacked(t):
    """Flat contact: boxes on the floor, on each other, in corners."""
    x, top = t.uniform(0.3, 0.7) * t.size[0], 0.0
    for k in range(t.rng.randint(1, 4)):
        body = t.box([t.uniform(5, 12), t.uniform(3, 6)])
        height = body.keys["size"][-1]
        if top + height > t.size[-1]:
            break
        t.add(body, t.at(x + t.uniform(-2, 2) * t.dx * (k > 0), top + 0.5 * height), density=t.density(-0.5, 3) if k == 0 else t.density())
        top += height
    corner = t.new(t.box([t.uniform(3, 6), t.uniform(3, 6)]), t.size * 0.5, density=t.density())
    t.against_wall(corner, 0, t.rng.choice([-1, 1]))
    t.against_wall(corner, t.dimension - 1, t.rng.choice([-1, 1]))
    if t.chance(0.6) and t.fits(corner):
        t.bodies.append(corner)
    t.friction()


def ceiling(t):
    """Light bodies that rise against the ceiling, some from contact, and against each other."""
    for _ in range(t.rng.randint(1, 4)):
        shape = t.convex()
        for _ in range(SCATTER):
            body = t.new(shape, [t.uniform(0.15, 0.85) * s for s in t.size], shapes.random_rotation(t.rng, t.dimension), density=t.density(-3, -0.05))
            t.against_wall(body, t.dimension - 1, 1, t.rng.choice([0.0, 0.3, 1.0, 3.0]) * t.dx)
            if t.bodies and t.chance(0.3):
                shapes.place_beside(t.rng, t.dimension, body, t.rng.choice(t.bodies), t.rng.choice([0.0, 0.5]) * t.dx)
            if t.fits(body):
                t.bodies.append(body)
                break


def rolling(t):
    """Balls, rollers and boxes on an inclined floor or ramp, with friction."""
    t.friction(1.0)
    angle = t.uniform(5, 35)
    ramp = t.chance(0.4)
    if ramp:
        t.add(t.ridge([0.7 * t.size[0], 4 * t.dx]), t.at(0.5 * t.size[0], 0.45 * t.size[-1]), t.lean(-angle), motion="fixed")
    else:
        t.tilt(angle)
    for _ in range(t.rng.randint(1, 3)):
        shape = t.ball(5, 11) if t.chance(0.7) else t.convex()
        for _ in range(SCATTER):
            body = t.new(shape, [t.uniform(0.1, 0.6) * s for s in t.size], t.turn(2, t.rng.choice([0, 90])), density=t.density(0.1, 3))
            if ramp:
                host = t.bodies[0]
                n = host.matrix @ t.axis(-1)
                along = host.matrix @ t.axis(0) * t.uniform(-0.25, 0.2) * t.size[0]
                body.position = host.position + 2 * t.dx * n + along - (body.support(-n) - body.position)
            else:
                t.against_wall(body, t.dimension - 1, -1)
            if t.fits(body):
                if t.chance(0.4) and shape.keys["shape"] == "ball":
                    speed = 0.4 * t.speed
                    along = host.matrix @ t.axis(0) if ramp else t.axis(0)
                    body.keys["velocity"] = (speed * along).tolist()
                    body.keys["angular_velocity"] = -speed / shape.keys["radius"] if t.dimension == 2 else [0.0, speed / shape.keys["radius"], 0.0]
                t.bodies.append(body)
                break


def flaps(t):
    """Hinged flaps that touch walls, the floor, each other or a ball."""
    d, dx = t.dimension, t.dx
    thick = t.uniform(THICK, 4.5) * dx
    length = min(t.uniform(9, 14) * dx * (1.0 if d == 2 else 0.7), 0.45 * t.size[0] - thick)
    round_ends = t.chance(0.5)

    def flap(hinge, degrees, **keys):
        """From the hinge towards the angle; 2D counterclockwise from x."""
        along = np.array([math.cos(math.radians(degrees)), *([0.0] * (d - 2)), math.sin(math.radians(degrees))])
        shape = shapes.make_capsule(d, 0.5 * thick, length) if round_ends else shapes.make_box([length, thick] if d == 2 else [length, 0.5 * t.size[1], thick])
        centre = np.array(hinge) + 0.5 * length * along
        hinged = {"point": list(map(float, hinge)), **({} if d == 2 else {"axis": [0.0, 1.0, 0.0]})}
        return t.add(shape, centre, t.lean(degrees), density=t.density(-2, 2), hinge=hinged, **keys)

    reach = length + (0.5 * thick if round_ends else 0.0)
    where = t.rng.choice(["wall", "floor", "pair", "ball"])
    height = t.uniform(0.4, 0.6) * t.size[-1]
    gap = t.rng.choice([0.0, 0.0, 0.1, 0.5]) * dx
    if where == "wall":     # the tip touches a wall, or a fixed stop
        flap(t.at(t.size[0] - reach - gap, height), 0)
    elif where == "floor":  # lies on the floor
        flap(t.at(0.3 * t.size[0], 0.5 * thick + gap), 0)
    elif where == "pair":   # tip to tip
        middle = 0.5 * t.size[0]
        flap(t.at(middle - reach - 0.5 * gap, height), 0)
        flap(t.at(middle + reach + 0.5 * gap, height), 180)
    else:                   # one with a ball on it, or above
        first = flap(t.at(0.3 * t.size[0], height), t.rng.choice([0, 10]))
        ball = t.ball(5, 9)
        n = first.matrix @ t.axis(-1)
        t.add(ball, first.position + (0.5 * thick + ball.keys["radius"] + gap) * n, density=t.density(-1, 2))
    if where != "ball" and t.chance(0.3):
        body = t.new(t.ball(5, 8), t.at(0.5 * t.size[0], 0.85 * t.size[-1]), density=t.density(0, 2))
        if t.fits(body):
            t.bodies.append(body)
    if t.chance(0.3):
        t.tilt(t.uniform(-30, 30))


def springs(t):
    """Bodies on springs, great stiffness among them, that touch others and walls."""
    t.cluster(t.rng.randint(2, 4), lambda: t.rng.choice([0.0, 0.0, 0.3]) * t.dx)
    for body in t.bodies:
        if body.shape.keys["shape"] == "mesh" or not t.chance(0.8):    # a spring acts at a shape's origin
            continue
        weight = max(body.keys["density"], t.rho) * body.shape.volume * t.g
        stiffness = weight / t.dx * 10 ** t.uniform(-1, 7)
        anchor = body.position + (t.uniform(-2, 2) * t.dx * shapes.unit_vector(t.rng, t.dimension) if stiffness * t.dx < 10 * weight else 0.0)
        body.keys["spring"] = {"anchor": anchor.tolist(), "stiffness": stiffness}


def edges(t):
    """Balls on two edges, heavy or light, and rollers."""
    d, dx = t.dimension, t.dx
    ball = t.ball(8, 14) if d == 2 else t.ball(6, 9)
    r = ball.keys["radius"]
    width = 2 * r * t.uniform(0.3, 0.95)
    top, middle = t.uniform(0.3, 0.5) * t.size[-1], (t.uniform(0.4, 0.6) if d == 2 else 0.5) * t.size[0]
    upside = t.chance(0.3)
    if upside:
        top = max(top, 5 * dx + 2 * r + 2.5 * dx)
    for end in (-1, 1):
        length = max(0.5 * t.size[0] - 4 * dx - 0.5 * width if t.chance(0.5) else 6 * dx, THICK * dx)
        t.add(t.ridge([length, 5 * dx]), t.at(middle + end * 0.5 * (width + length), top - 2.5 * dx), motion="fixed")
    gap = t.rng.choice([0.0, 0.0, 0.1, 1.0, 2.0]) * dx
    rise = math.sqrt(r * r - 0.25 * width * width) + gap
    if upside:    # a light one from below
        t.add(ball, t.at(middle, top - 5 * dx - rise), density=t.density(-3, -0.1))
    else:
        t.add(ball, t.at(middle, top + rise), density=t.density(0.05, 3))
        if t.chance(0.4):
            second = t.new(t.ball(5, 8), t.at(middle + t.uniform(-1, 1) * dx, top + rise + r + 6 * dx), density=t.density(0.05, 2))
            if t.fits(second):
                t.bodies.append(second)
    t.friction(0.3)


def funnels(t):
    """Two inclined plates or half-spaces, with balls in the throat or above it."""
    d, dx = t.dimension, t.dx
    angle, slot = t.uniform(25, 60), t.rng.choice([0.0, 3.0, 6.0]) * dx
    middle, low = 0.5 * t.size[0], 0.3 * t.size[-1]
    a = math.radians(angle)
    slab = t.chance(0.7)
    for end in (-1, 1):
        lip = np.array(t.at(middle + end * 0.5 * slot, low))    # the corner of the throat, on the upper face
        along = np.array([end * math.cos(a), *([0.0] * (d - 2)), math.sin(a)])
        normal = np.array([-end * math.sin(a), *([0.0] * (d - 2)), math.cos(a)])
        if slab:
            length = 0.45 * float(min(t.size[0], t.size[-1]))
            t.add(t.ridge([length, 4 * dx]), lip + 0.5 * length * along - 2 * dx * normal, t.lean(end * angle), motion="fixed")
        else:
            t.add(shapes.Shape({"shape": "half-space", "normal": normal.tolist()}, None, [], 0.0, 0.0), lip, motion="fixed")
    r = 0.5 * t.uniform(max(6, slot / dx + 2), 12 if d == 2 else 9) * dx
    # touches both faces: its centre is r away from each
    height = (r - 0.5 * slot * math.sin(a)) / math.cos(a)
    gap = t.rng.choice([0.0, 0.0, 0.3, 2.0]) * dx
    centre = low + height + gap
    for _ in range(t.rng.randint(1, 3)):
        if centre + r > t.size[-1]:
            break
        t.add(shapes.make_ball(d, r), t.at(middle, centre), density=t.density(0.05, 3))
        r_next = 0.5 * t.uniform(5, 8) * dx
        centre, r = centre + r + r_next + t.rng.choice([0.0, 1.0]) * dx, r_next
    t.friction(0.4)


def cups(t):
    """Balls in cups and rings, free or fixed, with clearances below a cell and above."""
    d, dx = t.dimension, t.dx
    r = 0.5 * (t.uniform(7, 12) if d == 2 else t.uniform(4.5, 6)) * dx
    clear, wall = t.rng.choice([0.05, 0.24, 0.5, 1.5]) * dx, t.uniform(THICK, 4 if d == 2 else 3.3) * dx
    depth = None if d == 2 else 2 * r + 2 * dx
    held = {"motion": "fixed"} if t.chance(0.4) else {"density": t.density(0.05, 1.5)}
    middle = t.at(0.5 * t.size[0], 0.45 * t.size[-1])
    what = t.rng.choice(["cup", "cup", "ring", "container"])
    inner = r + clear
    if what == "cup":
        rim, below = inner + wall, r * t.uniform(0.6, 1.4)
        outline = [(-rim, -below - wall), (rim, -below - wall), (rim, below), (inner, below), (inner, -below), (-inner, -below), (-inner, below), (-rim, below)]
        cup = t.add(make_outline(outline, t.folder, "b0", depth), middle, t.upright(0), **held)
        if t.chance(0.5):
            t.against_wall(cup, d - 1, -1)
        # The ball on the bottom (a clearance above it), half in, or two cells above the rim.
        above = t.rng.choice([-below + r + clear, below + 0.2 * r, below + r + 2 * dx])
        t.add(shapes.make_ball(d, r), cup.position + above * t.axis(-1), density=t.density(0.05, 2))
    elif what == "ring":
        half, count = math.radians(t.uniform(20, 40)), 20
        angles = [math.pi / 2 + half + (2 * math.pi - 2 * half) * k / count for k in range(count + 1)]
        inside = inner / math.cos(0.5 * (angles[1] - angles[0]))
        outline = [((inside + wall) * math.cos(a), (inside + wall) * math.sin(a)) for a in angles] + [(inside * math.cos(a), inside * math.sin(a)) for a in reversed(angles)]
        ring = t.add(make_outline(outline, t.folder, "b0", depth), middle, t.upright(0), **held)
        t.add(shapes.make_ball(d, r), ring.position - (clear if t.chance(0.5) else 0.0) * t.axis(-1), density=t.density())
    else:
        big = 0.48 * float(min(t.size))
        t.add(shapes.make_ball(d, big), 0.5 * t.size, inside_out=True, motion="fixed")
        n = shapes.unit_vector(t.rng, d)
        t.add(shapes.make_ball(d, r), 0.5 * t.size + (big - r - t.rng.choice([0.0, clear])) * n, density=t.density())
        t.add(t.ball(5, 6), 0.5 * t.size - (big - 3.2 * dx) * n, density=t.density())


def combs(t):
    """Combs of fins, fixed or free: balls between the fins, or a second comb that meshes with the first."""
    d, dx = t.dimension, t.dx
    fin, back = (t.uniform(THICK, 4 if d == 2 else 3.3) * dx for _ in range(2))
    tall = (t.uniform(4, 8) if d == 2 else t.uniform(3, 4.5)) * dx
    count = t.rng.randint(2, 3) if d == 2 else 2
    clear = t.rng.choice([0.1, 0.5, 1.0, 1.0 if count == 3 or d == 3 else 3.0]) * dx
    space = fin + 2 * clear
    depth = None if d == 2 else 6 * dx

    def outline(fins):
        width = fins * fin + (fins - 1) * space
        points = [(-0.5 * width, 0.0), (0.5 * width, 0.0)]
        for k in reversed(range(fins)):
            left = -0.5 * width + k * (fin + space)
            points += [(left + fin, tall + back), (left, tall + back)] + ([(left, back), (left - space, back)] if k else [])
        return points

    low = (t.uniform(0.15, 0.25) if d == 2 else 0.1) * t.size[-1]
    keys = {"motion": "fixed"} if t.chance(0.5) else {"density": t.density(0.1, 2)}
    t.add(make_outline(outline(count), t.folder, "b0", depth), t.at(0.5 * t.size[0], low), t.upright(0), **keys)
    if t.chance(0.5):    # meshing from above, fins a part of their length in
        shape = make_outline(outline(count - 1), t.folder, "b1", depth)
        height = low + back + tall + back + t.rng.choice([0.05, 0.5, 0.9]) * tall
        t.add(shape, t.at(0.5 * t.size[0], height), t.upright(180), density=t.density(0.1, 2))
    else:
        r = 0.5 * (space - 2 * clear * t.uniform(0.1, 0.9))
        for k in range(count - 1):
            x = 0.5 * t.size[0] + (k - 0.5 * (count - 2)) * (fin + space)
            t.add(shapes.make_ball(d, r), t.at(x, low + back + r + t.rng.choice([0.0, 1.0, 0.7 * tall / dx]) * dx), density=t.density())


def dry(t):
    """Balls that lie dry on the floor and against each other, with friction, pulled up or sideways."""
    t.judge, t.sides = "speed", {["y_high", "z_high"][t.dimension - 2]: "open"}
    head = t.rho * t.g * float(t.size[-1])
    t.fluid = {"reference_pressure": head * t.rng.choice([0.5, 2.0, 20.0]), **({"vapour_pressure": -0.1 * head} if t.chance(0.3) else {})}
    t.tables = {"gap": {"contact": "dry"}, "contact": {"thickness": t.rng.choice([0.002, 0.01, 0.05]) * t.dx, "friction": t.rng.choice([0.1, 0.3, 1.0])}}
    gap = t.tables["contact"]["thickness"]
    r = 0.5 * t.uniform(6, 10 if t.dimension == 2 else 7) * t.dx
    x = r + t.uniform(1, 4) * t.dx
    for _ in range(t.rng.randint(1, 3)):
        if x + r > t.size[0]:
            break
        body = t.add(shapes.make_ball(t.dimension, r), t.at(x, r + gap), density=t.density(0.1, 2))
        weight = (body.keys["density"] - t.rho) * body.shape.volume * t.g
        held = (t.fluid["reference_pressure"] + head) * (2 * r if t.dimension == 2 else math.pi * r * r)
        if t.chance(0.8):
            pull = t.uniform(0, 0.4) * min(held, 20 * weight)
            body.keys["force"] = ((weight + pull) * t.axis(-1) + t.uniform(-0.3, 0.3) * weight * t.axis(0)).tolist()
        x += 2 * r + gap * t.rng.choice([1.0, 1.0, 30.0])


def leaving(t):
    """Bodies that leave through open sides: carried by a stream, moved as prescribed, thrown, fallen or risen."""
    t.judge = "speed"
    axis, end = t.rng.choice([(0, 1), (t.dimension - 1, 1), (t.dimension - 1, -1)])
    name = "xyz"[axis]
    t.sides[f"{name}_{'high' if end > 0 else 'low'}"] = "open"
    how = t.rng.choice(["prescribed", "thrown", "thrown", "weight", "stream"])
    if how == "stream":
        axis, end = 0, 1
        u = 0.4 * t.speed * t.axis(0)
        t.sides = {"x_low": {"inflow": u.tolist()}, "x_high": "open"}
        t.fluid["velocity"] = u.tolist()
        t.carried += 4 * t.rho * float(u @ u) * float(np.prod(t.size))
        if t.chance(0.5):
            t.gravity = 0.0 * t.gravity
    elif how == "weight":
        axis = t.dimension - 1
        t.sides = {f"{'xyz'[axis]}_{'high' if end > 0 else 'low'}": "open"}
    elif t.chance(0.5):
        t.gravity = 0.0 * t.gravity
    for _ in range(1 if how == "prescribed" else t.rng.randint(1, 3)):
        shape = t.convex()
        for _ in range(SCATTER):
            body = t.new(shape, [t.uniform(0.2, 0.8) * s for s in t.size], shapes.random_rotation(t.rng, t.dimension))
            t.against_wall(body, axis, end, t.uniform(1, 6) * t.dx)
            if t.fits(body):
                heavy = (0.2, 1.5) if end < 0 else (-1.5, -0.1)
                body.keys["density"] = t.density(*heavy) if how == "weight" else t.density(-1, 1)
                velocity = (t.uniform(0.5, 1.0) * t.speed * end * t.axis(axis)).tolist()
                if how == "prescribed":
                    body.keys["motion"] = "prescribed"
                    del body.keys["density"]
                if how in ("prescribed", "thrown"):
                    body.keys["velocity"] = velocity
                    if t.chance(0.3):
                        spin = t.speed / (8 * t.dx) * 0.3
                        body.keys["angular_velocity"] = spin if t.dimension == 2 else (spin * shapes.unit_vector(t.rng, 3)).tolist()
                elif how == "stream":
                    body.keys["velocity"] = t.fluid["velocity"]
                t.bodies.append(body)
                break


def entering(t):
    """Bodies partly outside that come in through an open side, by their weight or thrown."""
    t.judge = "speed"
    axis, end = t.rng.choice([(0, 1), (0, -1), (t.dimension - 1, 1), (t.dimension - 1, -1)])
    t.sides[f"{'xyz'[axis]}_{'high' if end > 0 else 'low'}"] = "open"
    weight = axis == t.dimension - 1 and t.chance(0.5)
    for _ in range(t.rng.randint(1, 2)):
        shape = t.convex()
        for _ in range(SCATTER):
            body = t.new(shape, [t.uniform(0.25, 0.75) * s for s in t.size], shapes.random_rotation(t.rng, t.dimension))
            inside = all(body.support(t.axis(k))[k] < t.size[k] and body.support(-t.axis(k))[k] > 0 for k in range(t.dimension) if k != axis)
            t.against_wall(body, axis, end, -t.uniform(0.1, 0.9) * 2 * shape.extent * 0.7)
            if inside and all(separation(other, body) > 0 for other in t.bodies):
                heavy = (0.2, 2.0) if end > 0 else (-2.0, -0.1)
                body.keys["density"] = t.density(*heavy) if weight else t.density(-1, 2)
                if not weight:
                    body.keys["velocity"] = (-t.uniform(0.3, 1.0) * t.speed * end * t.axis(axis)).tolist()
                t.bodies.append(body)
                break
    if not weight and t.chance(0.5):
        t.gravity = 0.0 * t.gravity


def tank(t):
    """A crowd of all shapes with velocities, apart or nearly touching; some tanks are periodic along x."""
    if t.chance(0.3):
        t.sides = {"x_low": "periodic", "x_high": "periodic"}
    for _ in range(t.rng.randint(3, 8)):
        shape = t.convex()
        for _ in range(SCATTER):
            body = t.new(shape, [t.uniform(0.1, 0.9) * s for s in t.size], shapes.random_rotation(t.rng, t.dimension), density=t.density())
            if t.chance(0.5):
                body.keys["velocity"] = t.velocity(0.6)
            if t.bodies and t.chance(0.4):
                shapes.place_beside(t.rng, t.dimension, body, t.rng.choice(t.bodies), 10 ** t.uniform(-3, 0) * t.dx)
            if t.fits(body):
                t.bodies.append(body)
                break
    t.friction(0.2)


KINDS = {kind.__name__: kind for kind in (touching, overlapping, stacked, ceiling, rolling, flaps, springs, edges, funnels, cups, combs, dry, leaving, entering, tank)}


# ---- kinds of attacks: apart from those above, so that scenes keep their numbers

def scattered(t, count, room, make_keys):
    """Bodies of all shapes at random places, `room` cells from walls and each other."""
    for _ in range(count):
        shape = t.convex(5 if t.dimension == 2 else 4, 10 if t.dimension == 2 else 7)
        for _ in range(SCATTER):
            body = t.new(shape, [t.uniform(0.15, 0.85) * s for s in t.size], shapes.random_rotation(t.rng, t.dimension))
            inside = all(body.support(sign * t.axis(k))[k] * sign < (t.size[k] if sign > 0 else 0) - room * t.dx for k in range(t.dimension) for sign in (1, -1))
            if inside and all(separation(other, body) > room * t.dx for other in t.bodies):
                body.keys.update(make_keys(body))
                t.bodies.append(body)
                break


def nearly_ideal(t):
    """Viscosity: none, or so little that a cell's Reynolds number is up to 1e7; Courant numbers up to 5."""
    t.gravity = 0.0 * t.gravity
    t.reynolds = 10 ** t.uniform(1, 8) if t.chance(0.85) else None
    if t.chance(0.3):
        t.sides = {f"{a}_{end}": "periodic" for a in "xyz"[:t.dimension] for end in ("low", "high")}
    t.time = {"cfl": t.rng.choice([0.5, 1.0, 1.0, 2.0, 5.0]), "max_step": 10 * t.dx / t.speed}
    t.overlap = 0.05


def coasting(t):
    """One to three bodies that coast or spin in a tank of next to no viscosity."""
    nearly_ideal(t)
    spin = t.chance(0.3)
    turn = lambda: t.rng.gauss(0, 1) * t.speed / (8 * t.dx)
    scattered(t, t.rng.randint(1, 3), 1.5, lambda body: {"density": t.density(-1, 1), "velocity": t.velocity(0.6),
              **({"angular_velocity": turn() if t.dimension == 2 else [turn() for _ in range(3)]} if spin else {})})


def swinging(t):
    """The same on springs, without damping: no slower than twenty steps a period."""
    nearly_ideal(t)
    t.sides = {}

    def keys(body):
        density = t.density(-1, 1)
        anchor = body.position + t.uniform(2, 6) * t.dx * shapes.unit_vector(t.rng, t.dimension)
        rate = t.speed / (6 * t.dx) * t.uniform(0.2, 1)    # of oscillation in a vacuum
        return {"density": density, **({} if body.shape.keys["shape"] == "mesh" else
                {"spring": {"anchor": anchor.tolist(), "stiffness": density * body.shape.volume * rate**2}})}
    scattered(t, t.rng.randint(1, 2), 2, keys)


def thrown_far(t):
    """Bodies thrown at walls and each other, by cells in a step: none ends in a wall."""
    t.gravity = t.gravity * t.rng.choice([0, 1, 1])
    t.time = {"cfl": t.uniform(2, 10), "max_step": t.rng.choice([1, 4, 40]) * t.dx / t.speed}
    t.overlap = 0.05
    scattered(t, t.rng.randint(1, 4), 0.5, lambda body: {"density": t.density(-0.3, 2), "velocity": t.velocity(1.5)})


def pushing(t):
    """A prescribed body that pushes a free one through a closed tank."""
    t.gravity = 0.0 * t.gravity
    high = t.uniform(3, 8)
    pusher = t.add(t.box([t.uniform(4, 8), high]), t.at(0.25 * t.size[0], 0.5 * t.size[-1]), motion="prescribed", velocity=(0.4 * t.speed * t.axis(0)).tolist())
    shape = t.box([t.uniform(4, 8), t.uniform(3, 8)]) if t.chance(0.6) else t.convex(5, 8)
    body = t.new(shape, t.at(0.5 * t.size[0], 0.5 * t.size[-1]), density=t.density(-1, 1))
    front = pusher.support(t.axis(0))[0] + t.rng.choice([0.0, 0.008, 0.3]) * t.dx
    body.position[0] += front - body.support(-t.axis(0))[0]
    if t.fits(body):
        t.bodies.append(body)
    room = float(t.size[0] - body.support(t.axis(0))[0]) - 2 * t.dx    # before the wall stops it
    t.time = {"end": min(0.35 * float(t.size[0]), room) / (0.4 * t.speed)}
    t.judge = None    # the flow out of a thin gap has any energy at the start
    t.friction(0.3)


def wedged(t):
    """A narrow wedge that leans on a block's corner and sinks along it."""
    dx = t.dx
    width, height = 0.4 * t.size[0], t.uniform(7, 10) * dx
    t.add(t.ridge([width, height]), t.at(t.size[0] - 0.5 * width, 0.5 * height), motion="fixed")
    half = math.radians(t.uniform(5, 15))
    length = t.uniform(9, 14) * dx
    outline = [(0.0, -0.5 * length), (length * math.tan(half) + 1.5 * dx, 0.5 * length), (-length * math.tan(half) - 1.5 * dx, 0.5 * length)]
    depth = None if t.dimension == 2 else 5 * dx
    body = t.new(make_outline(outline, t.folder, "b1", depth), t.at(t.size[0] - width - t.uniform(1, 4) * dx, height + 0.45 * length),
                 t.upright(t.uniform(0, 25)) if t.dimension == 2 else t.upright(0), density=t.density(0.3, 1.5))
    if t.fits(body):
        t.bodies.append(body)
    t.tables["gap"] = {"roughness": 0.003 * dx}
    t.overlap = 0.05


def striking(t):
    """Bodies that start in touch with walls, and approach them, with restitution."""
    t.gravity = 0.0 * t.gravity
    t.tables["contact"] = {"restitution": t.rng.choice([0.5, 1.0])}
    for _ in range(t.rng.randint(1, 2)):
        shape = t.convex()
        for _ in range(SCATTER):
            body = t.new(shape, [t.uniform(0.2, 0.8) * s for s in t.size], shapes.random_rotation(t.rng, t.dimension), density=t.density(-0.5, 1))
            axis, end = t.rng.randrange(t.dimension), t.rng.choice([-1, 1])
            t.against_wall(body, axis, end)
            if t.fits(body):
                body.keys["velocity"] = (t.uniform(0.3, 0.8) * t.speed * end * t.axis(axis)).tolist()
                t.bodies.append(body)
                break


def treacle(t):
    """Bodies light and heavy in touch in fluid so viscous that it takes far less than a step to come to rest."""
    number = 10 ** t.uniform(1, 3)    # nu dt / dx^2
    t.cluster(t.rng.randint(2, 4), lambda: t.rng.choice([0.0, 0.3]) * t.dx)
    t.reynolds = 0.25 * t.dx * 0.2 * float(t.size[-1]) / (number * t.dx**2)
    t.friction()


ATTACK_KINDS = {kind.__name__: kind for kind in (coasting, swinging, thrown_far, pushing, wedged, striking, treacle)}


def kind_of(number):
    if number < FIRST_ATTACK:
        return list(KINDS)[number % len(KINDS)]
    return list(ATTACK_KINDS)[(number - FIRST_ATTACK) % len(ATTACK_KINDS)]


def dimension_of(number):
    if number < FIRST_ATTACK:
        return 2 if number < FLAT else 3
    return 2 if (number - FIRST_ATTACK) // len(ATTACK_KINDS) % 7 < 5 else 3


def make(number, folder, reynolds=None):
    """(scene, tank) of a scene's number; its meshes are written into `folder`. `reynolds`: least and largest Reynolds number, all fluid viscous then."""
    for attempt in range(100):
        t = Tank(number, folder, attempt)
        if any(body.keys.get("motion") != "fixed" for body in t.bodies):    # there was room for one
            if reynolds:
                t.reynolds = 10**random.Random(number).uniform(*map(math.log10, reynolds))
            return t.scene(), t
    raise ValueError(f"scene {number} has no bodies that move")
