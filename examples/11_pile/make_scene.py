#!/usr/bin/env python3
"""Writes scene.toml: balls and boxes let go at random places of a tank of water, that settle into a pile.

make_scene.py [BODIES [WIDTH HEIGHT]] prints the same with another number of bodies, in a tank of so many diameters; 100 5 14 if not given.
"""
import math
import random
import sys
from pathlib import Path

DIAMETER = 0.002     # m, of the balls; the boxes' edges are 0.6 to 0.9 of it
CELLS = 5            # a diameter

HEAD = """\
# Written by make_scene.py.
title = "a pile of {bodies} balls and boxes in water"
gravity = [0.0, 0.0, -9.81]

[domain]
size = [{w}, {w}, {h}]                 # m; {cells} cells a ball's diameter
cells = [{nw}, {nw}, {nh}]

[fluid]
density = 1000.0                            # water
viscosity = 0.001

[gap]
roughness = 10e-6

[contact]
friction = 0.3

[time]
end = {end}
max_step = 0.002
gap_cfl = 1.0

[output]
directory = "out"
every = 0.02
fields = ["velocity", "pressure"]
"""


def bodies_at_random(count, width, height):
    """[(shape, size in diameters, place)]: half balls, half boxes, apart by a hundredth of a diameter at least, whichever way they are turned."""
    rng = random.Random(1)
    bodies = []
    while len(bodies) < count:
        box = len(bodies) % 2 == 1
        size = [round(rng.uniform(0.6, 0.9), 3) for _ in range(3)] if box else 1.0
        reach = 0.5 * math.hypot(*size) if box else 0.5
        for _ in range(10000):
            place = [rng.uniform(reach + 0.01, side - reach - 0.01) for side in (width, width, height)]
            if all(math.dist(place, other) > reach + far + 0.01 for _, _, other, far, _ in bodies):
                break
        else:
            sys.exit("no room")
        bodies.append(("box" if box else "ball", size, place, reach, [round(rng.gauss(0, 1), 4) for _ in range(4)]))
    return bodies


def scene(count=100, width=5, height=14, end=0.4):
    def metres(values):
        return "[" + ", ".join(f"{v * DIAMETER:.7g}" for v in values) + "]"
    text = HEAD.format(bodies=count, w=width * DIAMETER, h=height * DIAMETER, cells=CELLS, nw=width * CELLS, nh=height * CELLS, end=end)
    for i, (shape, size, place, _, rotation) in enumerate(bodies_at_random(count, width, height)):
        text += f'\n[[body]]\nname = "{shape}{i}"\nshape = "{shape}"\nposition = {metres(place)}\n'
        if shape == "ball":
            text += f"radius = {0.5 * DIAMETER}\ndensity = 2500.0\n"
        else:
            text += f"size = {metres(size)}\nrotation = {rotation}\ndensity = 1400.0\n"
    return text


if __name__ == "__main__":
    if len(sys.argv) > 1:
        sys.stdout.write(scene(*map(int, sys.argv[1:])))
    else:
        (Path(__file__).resolve().parent / "scene.toml").write_text(scene())
