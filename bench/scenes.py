"""Scenes that measure speed, as TOML text: two plates with a thin gap, balls packed at random, and balls on a jittered lattice."""
import sys

import numpy as np


def toml(value):
    return "[" + ", ".join(repr(float(v)) for v in value) + "]"


def document(title, cells, bodies, dimension, gravity=0.0):
    lines = [f'title = "{title}"', f"gravity = {toml([0.0] * (dimension - 1) + [-gravity])}", "", "[domain]",
             f"size = {toml([1.0] * dimension)}", f"cells = {[cells] * dimension}", "", "[fluid]", "density = 1.0"]
    for name, keys in bodies:
        lines += ["", "[[body]]", f'name = "{name}"', *keys, "density = 2.0"]
    lines += ["", "[time]", "end = 1000.0", "max_step = 0.01", "cfl = 0.5", "gap_cfl = 0.25"]
    return "\n".join(lines) + "\n"


def plates(cells, gap, dimension=3):
    """Two flat plates in the middle of a closed unit box, a third of it wide, `gap` apart, pulled apart."""
    bodies = []
    thickness = 1 / 12
    for name, side in (("upper", 1), ("lower", -1)):
        position = [0.5] * (dimension - 1) + [0.5 + side * 0.5 * (gap + thickness)]
        bodies.append((name, ['shape = "box"', f"size = {toml([1 / 3] * (dimension - 1) + [thickness])}",
                              f"position = {toml(position)}", f"force = {toml([0.0] * (dimension - 1) + [0.04 * side])}"]))
    return document(f"two plates, gap {gap}, {cells} cells a side", cells, bodies, dimension)


def balls(n, cells, diameter=8.0):
    """n balls of this diameter (in cells) that settle in a closed unit box of cells^3.

    Packed at random, always alike: each has a shell of 0 to 0.15 cells, so that neighbours' gaps go from almost nothing to
    0.3 cells; balls at random places are pushed apart until no shells overlap by more than 1e-6 cells.
    """
    rng = np.random.default_rng(1)
    shell = diameter / 2 + 0.15 * rng.random(n) ** 3
    x = shell[:, None] + rng.random((n, 3)) * (cells - 2 * shell[:, None])
    step = 0
    while True:
        if step % 20 == 0:
            order = np.argsort(x[:, 0])
            x, shell = x[order], shell[order]
            last = np.searchsorted(x[:, 0], x[:, 0] + 1.5 * diameter)
            near = [(i, i + 1 + np.flatnonzero(np.abs(x[i + 1:last[i], 1:] - x[i, 1:]).max(axis=1) < 1.5 * diameter))
                    for i in range(n)]
            a = np.concatenate([np.full(len(js), i) for i, js in near])
            b = np.concatenate([js for _, js in near])
        to = x[b] - x[a]
        distance = np.linalg.norm(to, axis=1)
        overlap = shell[a] + shell[b] - distance
        if overlap.max(initial=0) < 1e-6 and step % 20 == 0:
            break
        push = np.maximum(overlap, 0)[:, None] * to / np.maximum(distance, 1e-9)[:, None]
        np.add.at(x, a, -0.52 * push)
        np.add.at(x, b, 0.52 * push)
        x = np.clip(x, shell[:, None], cells - shell[:, None])
        step += 1
    bodies = [(f"ball{i}", ['shape = "ball"', f"radius = {0.5 * diameter / cells!r}", f"position = {toml(c / cells)}"])
              for i, c in enumerate(x)]
    return document(f"{n} balls of {diameter:g} cells, {cells} cells a side", cells, bodies, 3, gravity=1.0)


def lattice(a_side, cells, diameter=8.0):
    """a_side^3 balls of this diameter (in cells) on a cubic lattice in a closed unit box of cells^3, each moved by up to 0.3 cells
    along each axis, always alike."""
    x = (np.indices([a_side] * 3).reshape(3, -1).T + 0.5) * cells / a_side
    x += np.random.default_rng(1).uniform(-0.3, 0.3, x.shape)
    bodies = [(f"ball{i}", ['shape = "ball"', f"radius = {0.5 * diameter / cells!r}", f"position = {toml(c / cells)}"])
              for i, c in enumerate(x)]
    return document(f"{a_side**3} balls of {diameter:g} cells on a jittered lattice, {cells} cells a side", cells, bodies, 3, gravity=1.0)


def on_parts(text):
    """The same scene with `gap.model = "parts"`."""
    return text.replace("[time]\n", '[gap]\nmodel = "parts"\n\n[time]\n')


def viscous(text):
    """The same scene with a viscosity of 1e-3."""
    return text.replace("[fluid]\n", "[fluid]\nviscosity = 1e-3\n")


if __name__ == "__main__":
    kind, first, second = sys.argv[1:4]  # plates CELLS GAP | balls N CELLS | lattice A_SIDE CELLS
    scene = {"plates": plates, "balls": balls, "lattice": lattice}[kind]
    sys.stdout.write(scene(int(first), float(second) if kind == "plates" else int(second)))
