#!/usr/bin/env python3
"""Writes blade.obj: a propeller blade of span 1 along z, its middle at the origin, the shaft along x a distance of 0.7 below it.

Sections are ellipses, chord 0.5 in the middle of the span and less towards hub and tip, a sixth as thick, turned by the pitch angle
atan(pitch / (2 pi r)) out of the plane of the propeller, r the distance from the shaft. Tip and hub are closed by half an ellipsoid each."""
from math import atan2, cos, pi, sin, sqrt
from pathlib import Path

HUB, PITCH, SPAN, CHORD, THICKNESS = 0.7, 1.4, 1.0, 0.5, 1 / 6
SECTIONS, POINTS = 40, 32


def section(z):
    """(half chord, half thickness, pitch angle) at z between -SPAN / 2 and SPAN / 2."""
    half = 0.5 * CHORD * sqrt(max(0.0, 1 - (2 * z / SPAN)**2))
    return half, THICKNESS * half, atan2(PITCH, 2 * pi * (HUB + z))


def point(z, angle):
    half, thick, pitch = section(z)
    along, across = half * cos(angle), thick * sin(angle)        # along the chord and across it
    return across * cos(pitch) + along * sin(pitch), along * cos(pitch) - across * sin(pitch), z


def blade(path):
    heights = [-0.5 * SPAN * cos(pi * i / SECTIONS) for i in range(1, SECTIONS)]
    vertices = [(0.0, 0.0, -0.5 * SPAN)] + [point(z, 2 * pi * j / POINTS) for z in heights for j in range(POINTS)] + [(0.0, 0.0, 0.5 * SPAN)]
    faces, last = [], len(vertices) - 1

    def ring(i, j):
        return 1 + i * POINTS + j % POINTS
    for j in range(POINTS):
        faces.append((0, ring(0, j + 1), ring(0, j)))
        faces.append((last, ring(len(heights) - 1, j), ring(len(heights) - 1, j + 1)))
        for i in range(len(heights) - 1):
            a, b, c, d = ring(i, j), ring(i, j + 1), ring(i + 1, j + 1), ring(i + 1, j)
            faces += [(a, b, c), (a, c, d)]
    with open(path, "w") as file:
        file.writelines("v {:.9g} {:.9g} {:.9g}\n".format(*vertex) for vertex in vertices)
        file.writelines("f {} {} {}\n".format(*(index + 1 for index in face)) for face in faces)


if __name__ == "__main__":
    blade(Path(__file__).resolve().parent / "blade.obj")
