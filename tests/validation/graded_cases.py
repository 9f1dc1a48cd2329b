"""Graded grids: bodies in domains of tens to hundreds of radii, without corrections for a box."""
import csv
import math
from pathlib import Path

import harness
from harness import Row

PAIR = "Graded grids: added mass of two equal cylinders, domain 200 radii wide"
WALL = "Graded grids: added mass of a sphere above a wall"
SHARE = "Graded grids: share of the grading in the added mass"
WORK = "Graded grids: iterations to 1e-8"
MOVING = "Graded grids: in motion"
VISCOUS = "Graded grids: viscous flow"
REFERENCE = Path(__file__).parent.parent / "data" / "reference"


def table(name):
    with open(REFERENCE / name) as file:
        return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]


def at(rows, key, value):
    """Row of a table, linear in the logarithm between its rows."""
    rows = [row for row in rows if row[key] > 0]
    for before, after in zip(rows, rows[1:]):
        if before[key] <= value <= after[key] * (1 + 1e-12):
            f = math.log(value / before[key]) / math.log(after[key] / before[key])
            return {name: (1 - f) * before[name] + f * after[name] for name in before}
    raise ValueError(value)


def sides(dimension, kind, **others):
    return {**{f"{axis}_{end}": kind for axis in "xyz"[:dimension] for end in ("low", "high")}, **others}


def graded(size, origin, spacing, low, high, growth, all_sides):
    return {"size": size, "origin": origin, "spacing": spacing, "core": {"low": low, "high": high}, "growth": growth, "sides": all_sides}


def two_cylinders(quick):
    """Six places on the grid: at 12 cells a radius cut cells make differences of a percent between them, the grading none."""
    rows, n, found = table("I2_two_cylinders_equal.csv"), 12, {}
    places = [(0.036, 0.084), (0, 0), (0.31, 0.17), (-0.23, 0.41), (0.47, -0.38), (-0.11, -0.27)]    # in cells
    cells = most = 0
    for gap, place in ((gap, place) for gap in ((1e-1, 1e-3) if quick else (1e-1, 1e-2, 1e-3, 1e-4, 1e-6)) for place in places):
        off = [f / n for f in place]
        bodies = [{"name": name, "shape": "ball", "radius": 1.0, "position": [sign * (1 + 0.5 * gap) + off[0], off[1]], "density": 1.0}
                  for name, sign in (("left", -1), ("right", 1))]
        result = harness.added_mass({"domain": graded([200.0] * 2, [-100.0] * 2, 1 / n, [-5.0, -5.0], [5.0, 5.0], 1.1, sides(2, "wall")), "body": bodies})
        m, exact = result["matrix"], at(rows, "gap", gap)
        cells, most = result["cells"], max(most, *result["iterations"])
        for name, value, key in (("opening", 0.5 * (m[0][0] - m[0][3]), "M_gap_equal_opposite"), ("together", 2 * (m[0][0] + m[0][3]), "M_common_along_line"),
                                 ("across", 2 * (m[1][1] + m[1][4]), "M_common_transverse")):
            found.setdefault(name, {}).setdefault(gap, []).append(100 * (value / exact[key] - 1))
    for name, gaps in found.items():
        means, worst = [sum(errors) / len(errors) for errors in gaps.values()], max((abs(e), e) for errors in gaps.values() for e in errors)[1]
        label = f"{n} cells a radius, {cells} cells, gaps {', '.join(f'{gap:g}' for gap in gaps)} R: {name}"
        yield Row(PAIR, f"{label}, mean of six places on the grid", "≤ 0.5 %", ", ".join(f"{e:+.2f}" for e in means) + " %", max(map(abs, means)) <= 0.5)
        yield Row(PAIR, f"{label}, worst place", "≤ 0.5 %", f"{worst:+.2f} %", abs(worst) <= 0.5)
    yield Row(WORK, "two cylinders, 2D", "≤ 12", f"{most}", most <= 12)


def sphere_above_wall(quick):
    rows, n = table("I3_sphere_wall.csv"), 6 if quick else 12
    for gap in ((0.1,) if quick else (0.1, 1e-3)):
        result = harness.added_mass({"domain": graded([40.0, 20.0, 40.0], [-20.0, 0.0, -20.0], 1 / n, [-1.5, 0.0, -1.5], [1.5, 3.0, 1.5], 1.1, {"x_low": "far", "x_high": "far", "y_high": "far", "z_low": "far", "z_high": "far"}),
                                     "body": [{"name": "ball", "shape": "ball", "radius": 1.0, "position": [0.003, 1 + gap, 0.007], "density": 1.0}]})
        m, exact = result["matrix"], at(rows, "gap_over_R", gap)
        volume = 4 / 3 * math.pi
        errors = {"normal": 100 * (m[1][1] / volume / exact["C_normal"] - 1), "parallel": 100 * (m[0][0] / volume / exact["C_parallel"] - 1)}
        for name, error in errors.items():
            yield Row(WALL, f"{n} cells a radius, {result['cells']} cells, gap {gap:g} R: {name}", "≤ 0.5 %", f"{error:+.2f} %", abs(error) <= 0.5)
        yield Row(WORK, f"sphere above a wall, gap {gap:g} R, {result['cells']} cells", "≤ 12", f"{max(result['iterations'])}", max(result["iterations"]) <= 12)


ALL = [two_cylinders, sphere_above_wall]
