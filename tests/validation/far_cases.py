"""Sides of the domain: what is left of the box beyond far sides, what leaves through far and open sides, flows that pressure sides drive."""
import math
import tempfile
from pathlib import Path

import harness
from harness import Row

MASS = "Far sides: added mass of a ball in unbounded fluid, box 20 radii wide"
WALL = "Far sides: added mass of a cylinder above a wall, box 20 radii wide"
LEAVING = "Far sides: what stays in the box"
DRAG = "Far sides: drag in an unbounded stream"
PRESSURE = "Pressure sides"


def sides(dimension, kind, **others):
    return {**{f"{axis}_{end}": kind for axis in "xyz"[:dimension] for end in ("low", "high")}, **others}


def box(dimension, width, cells, all_sides):
    """`width` in units of length, `cells` a unit."""
    return {"size": [float(width)] * dimension, "cells": [round(width * cells)] * dimension, "sides": all_sides}


def mass(dimension, width, cells, kind, **others):
    """Added mass of a ball of radius 1 in the middle, along x, and the most iterations."""
    place = [0.5 * width + 0.003] * dimension
    result = harness.added_mass({"domain": box(dimension, width, cells, sides(dimension, kind, **others)),
                                 "body": [{"name": "ball", "shape": "ball", "radius": 1.0, "position": place, "density": 1.0}]})
    return result["matrix"][0][0], max(result["iterations"])


def added_mass(quick):
    """The share of the box: against far sides four times (3D: twice) as far away, on the same cells."""
    for dimension, cells, times, target in ((2, 8 if quick else 16, 4, 0.05), *(() if quick else ((3, 4, 2, 0.01),))):
        far, few = mass(dimension, 20, cells, "far")
        unbounded, more = mass(dimension, 20 * times, cells, "far")
        share = 100 * (far / unbounded - 1)
        wall, opened = (100 * (mass(dimension, 20, cells, kind)[0] / unbounded - 1) for kind in ("wall", "open"))
        name = f"{dimension}D, {cells} cells a radius"
        yield Row(MASS, f"{name}: share of the box (between walls; open)", f"≤ {target:g} %", f"{share:+.3f} % ({wall:+.2f} %; {opened:+.2f} %)", abs(share) <= target)
        yield Row(MASS, f"{name}: iterations to 1e-8, {20 * cells} and {20 * times * cells} cells an axis", "≤ 12", f"{few}, {more}", max(few, more) <= 12)


def above_a_wall(quick):
    def matrix(width, cells, high):
        all_sides = {"x_low": high, "x_high": high, "y_high": high}
        return harness.added_mass({"domain": box(2, width, cells, all_sides),
                                   "body": [{"name": "ball", "shape": "ball", "radius": 1.0, "position": [0.5 * width + 0.003, 1.5], "density": 1.0}]})["matrix"]
    cells = 6 if quick else 12
    unbounded = matrix(80, cells, "far")
    for axis, name in enumerate(("along", "normal")):
        far, wall = (100 * (matrix(20, cells, high)[axis][axis] / unbounded[axis][axis] - 1) for high in ("far", "wall"))
        yield Row(WALL, f"{cells} cells a radius, gap 0.5 R, {name}: share of the box (walls all around)", "≤ 0.5 %", f"{far:+.3f} % ({wall:+.2f} %)", abs(far) <= 0.5)


def vortex_pair(quick):
    found, passed = harness.unit_figures("unit_stepping", "FarSides.LetAVortexPairGo")
    yield Row(LEAVING, "two vortices, 0.8 from each other, that carry each other 12 through a side of a box of edge 4 (64²): energy left", "≤ 1 % (far)", found["left"], passed)


def start_and_stop(quick):
    """A disk of radius 0.25 moves 0.5 and stops: in unbounded ideal fluid all comes to rest."""
    for kind in ("far", "open", "wall"):
        with tempfile.TemporaryDirectory() as folder:
            table = Path(folder) / "motion.csv"
            lines = ["time,x,y,angle"]
            for time in (t / 40 for t in range(41)):
                lines.append(f"{time},{1.75 + 0.5 * (time - math.sin(2 * math.pi * time) / (2 * math.pi))},2,0")
            lines.append("2,2.25,2,0")
            table.write_text("\n".join(lines) + "\n")
            result = harness.run({"domain": box(2, 4, 16, sides(2, kind)),
                                  "body": [{"name": "disk", "shape": "ball", "radius": 0.25, "motion": "prescribed", "file": str(table)}],
                                  "time": {"end": 1.5, "max_step": 0.02}, "output": {"every": 1.5}})
        energies = [row["energy_fluid"] for row in result["steps"]]
        yield Row(LEAVING, f"a disk of radius 0.25 moves by 0.5 and stops, box of edge 4, 16 cells a unit, {kind} sides: energy left, of the largest",
                  "≤ 1 %" if kind == "far" else "", f"{100 * energies[-1] / max(energies):.2f} %", kind != "far" or energies[-1] < 0.01 * max(energies))


def stream(dimension, reynolds, cells, length, width, place, time, step, cfl):
    """Drag of a ball of diameter 1 in a stream of speed 1, far sides all around: mean over the last tenth of the time."""
    middle = 0.5 * width + 0.003
    velocity = [1.0, 0.0, 0.0][:dimension]
    rows = harness.run({"domain": {"size": [float(length)] + [float(width)] * (dimension - 1), "cells": [length * cells] + [width * cells] * (dimension - 1),
                                   "sides": sides(dimension, "far")},
                        "fluid": {"viscosity": 1 / reynolds, "velocity": velocity},
                        "body": [{"name": "ball", "shape": "ball", "radius": 0.5, "position": [place + 0.003, middle, middle][:dimension], "motion": "fixed"}],
                        "time": {"end": time, "max_step": step, "cfl": cfl}, "output": {"every": time}})["bodies"]
    late = [row["fx"] for row in rows[:-1] if row["time"] > 0.9 * rows[-1]["time"]]
    return sum(late) / len(late)


def drag(quick):
    """The share of the box falls with its width as 1/width: a point force's velocity fades that slowly, and on flat sides the condition is exact for its mean alone."""
    if quick:
        return
    errors = {width: stream(3, 0.01, 8, width, width, 0.5 * width, 2.0, 0.05, 4.0) / (3 * math.pi * 100) - 1 for width in (4, 8)}
    yield Row(DRAG, "sphere, Re 0.01 (Stokes), 4 cells a radius, box of 8 and of 16 radii", "", ", ".join(f"{100 * error:+.1f} %" for error in errors.values()), True)
    coefficient = 2 * stream(2, 40, 8, 20, 12, 6, 120.0, 0.1, 1.0)
    yield Row(DRAG, "cylinder, Re 40, 8 cells a diameter, box of 20 x 12 diameters: drag coefficient (published: 1.50 to 1.54)", "", f"{coefficient:.3f}", True)


def pressure_driven(quick):
    """Poiseuille flow; and the steady flow through a short channel without viscosity, whose head is the difference of pressure."""
    scene = {"domain": {"size": [4.0, 1.0], "cells": [64, 16], "sides": {"x_low": {"pressure": 1e5 + 48.0}, "x_high": {"pressure": 1e5}}},
             "fluid": {"density": 1e-6, "viscosity": 1.0}, "time": {"end": 4e-5, "max_step": 1e-6}, "output": {"every": 4e-5}}

    def flow(shape):
        def look(out):
            from pressure_cases import read, values
            data = read(sorted((Path(out) / "fields").glob("*.vti"))[-1], "vtkXMLImageDataReader").GetCellData()
            return float(values(data, "velocity").reshape(*shape, 3)[:, shape[1] // 2, 0].mean())
        return look
    error = harness.run(scene, look=flow((16, 64)))["look"] - 1
    yield Row(PRESSURE, "Poiseuille flow in a channel 4 long and 1 wide (64 x 16), flow", "≤ 2 %", f"{100 * error:+.2f} %", abs(error) <= 0.02)
    scene = {"domain": {"size": [2.0, 1.0], "cells": [32, 16], "sides": {"x_low": {"pressure": 2.0}, "x_high": {"pressure": 0.0}}},
             "time": {"end": 10.0, "max_step": 0.05}, "output": {"every": 10.0}}
    error = harness.run(scene, look=flow((16, 32)))["look"] / 2 - 1
    yield Row(PRESSURE, "steady flow without viscosity: speed against that of the head, steps at a CFL number of 1", "≤ 0.5 %", f"{100 * error:+.2f} %", abs(error) <= 0.005)


ALL = [added_mass, above_a_wall, vortex_pair, start_and_stop, drag, pressure_driven]
