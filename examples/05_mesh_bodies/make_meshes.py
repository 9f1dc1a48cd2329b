#!/usr/bin/env python3
"""Writes torus.obj (tube radius 0.2 about a circle of radius 0.6 in the xy plane) and slab.stl (a 1.8 x 1.8 x 0.4 box)."""
from math import cos, pi, sin
from pathlib import Path

HERE = Path(__file__).resolve().parent


def torus(path, ring=0.6, tube=0.2, n=64, m=32):
    with open(path, "w") as f:
        for i in range(n):
            for j in range(m):
                u, v = 2 * pi * i / n, 2 * pi * j / m
                r = ring + tube * cos(v)
                f.write(f"v {r * cos(u):.17g} {r * sin(u):.17g} {tube * sin(v):.17g}\n")
        for i in range(n):
            for j in range(m):
                a, b = i * m + j, (i + 1) % n * m + j
                c, d = (i + 1) % n * m + (j + 1) % m, i * m + (j + 1) % m
                f.write(f"f {a + 1} {b + 1} {c + 1}\nf {a + 1} {c + 1} {d + 1}\n")


def slab(path, size=(1.8, 1.8, 0.4)):
    corner = [[s * k / 2 for s, k in zip(size, (x, y, z))] for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    with open(path, "w") as f:
        f.write("solid slab\n")
        for a, b, c, d in quads:
            for t in ((a, b, c), (a, c, d)):
                f.write("facet normal 0 0 0\n outer loop\n")
                for v in t:
                    f.write("  vertex {:.9g} {:.9g} {:.9g}\n".format(*corner[v]))
                f.write(" endloop\nendfacet\n")
        f.write("endsolid slab\n")


if __name__ == "__main__":
    torus(HERE / "torus.obj")
    slab(HERE / "slab.stl")
