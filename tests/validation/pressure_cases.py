"""Pressure on the surface of a cylinder that starts from rest off a wall, against the exact curve (I1)."""
import importlib.util
import math

import numpy as np

import harness
from harness import REFERENCE, Row

SECTION = "Surface pressure of a cylinder set in motion off a wall, gap 1e-3 R"
PICTURE = "surface_pressure.png"
GAP, SIDE, STEP = 1e-3, 24.0, 1e-6
harness.PICTURES[SECTION] = (
    f"Pressure over density, radius R and acceleration after one step from rest in a closed box of side {SIDE:g} R, at film nodes and at cut cells (there taken from\n"
    "the cell's centre to the surface with the normal gradient that the wall's acceleration gives). L2 over the angle, relative to the whole exact curve; the\n"
    "level, which a closed box leaves free, is that of the exact mean.\n\n"
    f"![Film nodes and cut cells on the exact curve](images/{PICTURE})")


def exact_curve():
    rows = harness.read_table(REFERENCE / "I1_pressure_cylinder_wall_normal.csv")
    angle, pressure = (np.array([row[name] for row in rows]) for name in ("theta_deg", "p_gap0.001"))
    return angle, pressure


def read(file, reader):
    from vtkmodules import vtkIOXML
    reader = getattr(vtkIOXML, reader)()
    reader.SetFileName(str(file))
    reader.Update()
    return reader.GetOutput()


def values(data, name):
    from vtkmodules.util.numpy_support import vtk_to_numpy
    return vtk_to_numpy(data.GetArray(name)).copy()


def samples(out, centre, dx, acceleration):
    """(angle from the point nearest to the wall, in degrees, p / (rho R a)) at film nodes and at cut cells."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    film = read(out / "films" / "films_00001.vtp", "vtkXMLPolyDataReader")
    x = vtk_to_numpy(film.GetPoints().GetData())[:, 0] - centre[0]    # mid-gap: as far along the wall as on the cylinder
    at_film = np.degrees(np.arcsin(x)), values(film.GetPointData(), "pressure") / acceleration
    fields = read(out / "fields" / "fields_00001.vti", "vtkXMLImageDataReader").GetCellData()
    n = round(SIDE / dx)
    kind, pressure = (values(fields, name).reshape(n, n) for name in ("kind", "pressure"))
    corner = dx * np.arange(n + 1)
    outside = np.hypot(corner[None, :] - centre[0], corner[:, None] - centre[1]) > 1
    count = sum(outside[j:j + n, i:i + n].astype(int) for i in (0, 1) for j in (0, 1))
    y, x = np.nonzero((count > 0) & (count < 4) & ((kind == 1) | (kind == 3)))
    place = np.stack([(x + 0.5) * dx - centre[0], (y + 0.5) * dx - centre[1]])
    r = np.hypot(*place)
    on_surface = pressure[y, x] / acceleration + (r - 1) * place[1] / r    # dp/dn = -rho a . n
    return at_film, (np.degrees(np.arctan2(place[0], -place[1])), on_surface)


def weights(angle):
    """Share of the circle of every sample: half the way to either neighbour."""
    order = np.argsort(angle)
    ends = np.concatenate([[angle[order[0]]], 0.5 * (angle[order][1:] + angle[order][:-1]), [angle[order[-1]]]])
    weight = np.empty_like(angle)
    weight[order] = np.diff(ends)
    return weight


def measured(cells, shift):
    """Film and cut-cell samples (angle, pressure with its level set, exact, share of the circle) at `cells` a radius."""
    dx = 1.0 / cells
    centre = [SIDE / 2 + shift * dx, 1 + GAP]
    scene = {"domain": {"size": [SIDE, SIDE], "cells": [round(SIDE * cells)] * 2}, "solver": {"tolerance": 1e-10},
             "body": [{"name": "cylinder", "shape": "ball", "radius": 1.0, "position": centre, "density": 2.0, "force": [0.0, 1.0]}],
             "time": {"end": STEP, "max_step": STEP}, "output": {"every": STEP}}

    def look(out):
        rows = harness.read_table(out / "bodies.csv")
        return samples(out, centre, dx, rows[-1]["vy"] / rows[-1]["time"])
    angle, exact = exact_curve()
    found = []
    for at, p in harness.run(scene, look=look)["look"]:
        found.append([at, p, np.interp(np.abs(at), angle, exact), weights(at)])
    film, cut = found
    film_end = np.abs(film[0]).max()
    cut[3] = np.where(np.abs(cut[0]) > film_end, np.minimum(cut[3], np.abs(cut[0]) - film_end), 0.0)    # each part of the circle once
    total = sum(w.sum() for *_, w in found)
    level = sum((w * (p - e)).sum() for _, p, e, w in found) / total
    for part in found:
        part[1] = part[1] - level
    return found, level


def draw(found, errors):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    angle, exact = exact_curve()
    figure, axes = plt.subplots(1, 3, figsize=(12, 3.8), constrained_layout=True)
    for plot, end in zip(axes, (180, 30)):
        plot.plot(angle, exact, "k", lw=1, label="exact")
        for (at, p, *_), mark, name in zip(found, ("C1.", "C0o"), ("film nodes", "cut cells")):
            plot.plot(np.abs(at), p, mark, ms=4, mfc="none", label=f"{name}, 16 cells a radius")
        plot.set(xlim=(0, end), xlabel="angle from the nearest point (degrees)", ylabel="p / (ρ R a)")
    axes[0].legend()
    dx = [1 / cells for cells in errors]
    for part, name in enumerate(("film nodes", "cut cells")):
        axes[2].loglog(dx, [100 * e[part] for e in errors.values()], "C1.-" if part == 0 else "C0o-", mfc="none", label=name)
    axes[2].set(xlabel="dx / R", ylabel="L2 error (%)")
    axes[2].legend()
    figure.savefig(harness.PICTURE_FOLDER / PICTURE, dpi=100)
    plt.close(figure)


def surface_pressure(quick):
    errors, pictured = {}, None
    for cells in (8, 16) if quick else (8, 16, 32):
        squares, levels = np.zeros(2), []
        norm = 0.0
        for shift in (0.0, 0.37):
            found, level = measured(cells, shift)
            levels.append(level)
            angle, exact = exact_curve()
            norm += 2 * np.trapz(exact**2, angle)
            squares += [(w * (p - e) ** 2).sum() for _, p, e, w in found]
            if cells == 16 and shift == 0.0:
                pictured = found
        errors[cells] = np.sqrt(squares / norm)
        before = errors.get(cells // 2)
        falls = before is None or bool((errors[cells] < before).all())
        yield Row(SECTION, f"{cells} cells a radius, 2 offsets along the wall: film nodes ({len(found[0][0])}); cut cells ({len(found[1][0])})",
                  "" if before is None else "falls with dx", f"{100 * errors[cells][0]:.2f} %; {100 * errors[cells][1]:.2f} % (level {np.mean(levels):+.3f})", falls)
    both = [math.sqrt((e**2).sum()) for e in errors.values()]
    order = math.log2(both[0] / both[-1]) / (len(both) - 1)
    yield Row(SECTION, f"whole surface, {', '.join(map(str, errors))} cells a radius: L2 error; order", "≥ 0.8", f"{', '.join(f'{100 * e:.2f} %' for e in both)}; {order:.2f}", True)
    if harness.PICTURE_FOLDER and not quick and importlib.util.find_spec("matplotlib"):    # else the last picture stays
        draw(pictured, errors)


ALL = [surface_pressure]
