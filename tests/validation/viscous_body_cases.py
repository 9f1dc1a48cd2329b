"""Bodies in viscous fluid with inertia: drag, settling, bouncing, plates pulled apart."""
import bisect
import math

import harness
from harness import REFERENCE, Row
from viscous_cases import error_row

DRAG = "Viscosity: drag of a sphere and of a cylinder"
SETTLING = "Viscosity: settling sphere (ten Cate et al. 2002)"
BOUNCING = "Viscosity: bouncing steel sphere (Gondret, Lance & Petit 2002)"
PLATES = "Viscosity: plates pulled apart with inertia (V3)"


def interpolate(x, xs, ys):
    """Linear, xs rising."""
    i = min(max(bisect.bisect(xs, x), 1), len(xs) - 1)
    return ys[i - 1] + (ys[i] - ys[i - 1]) * (x - xs[i - 1]) / (xs[i] - xs[i - 1])


def stream(dimension, reynolds, cells, width, length, time, cfl=1.0):
    """Rows of bodies.csv of a ball of diameter 1, three diameters behind the inflow, in a stream of speed 1 and density 1 between walls
    that move along with it; `cells` a diameter, lengths in diameters."""
    sides = {f"{axis}_{end}": {"wall": [1.0, 0.0, 0.0][:dimension]} for axis in "yz"[:dimension - 1] for end in ("low", "high")}
    middle = 0.5 * width + 0.003
    scene = {"domain": {"size": [float(length)] + [float(width)] * (dimension - 1), "cells": [length * cells] + [width * cells] * (dimension - 1),
                        "sides": {"x_low": {"inflow": [1.0, 0.0, 0.0][:dimension]}, "x_high": "open", **sides}},
             "fluid": {"viscosity": 1 / reynolds, "velocity": [1.0, 0.0, 0.0][:dimension]},
             "body": [{"name": "ball", "shape": "ball", "radius": 0.5, "position": [0.4 * length, middle, middle + 0.004][:dimension], "motion": "fixed"}],
             "time": {"end": time, "max_step": 0.5 * time / 20, "cfl": cfl}, "output": {"every": time}}
    return harness.run(scene)["bodies"]


def steady(rows):
    """Drag, mean over the last tenth of the time. Without the last step, which is cut short: what a shorter step changes costs an impulse."""
    late = [row["fx"] for row in rows[:-1] if row["time"] > 0.9 * rows[-1]["time"]]
    return sum(late) / len(late)


def sphere_drag(quick):
    """Schiller & Naumann's fit, 24 / Re (1 + 0.15 Re^0.687), good to 5 % itself. At Re 0.1 the walls of the channel count: the
    creeping-flow value times 1 / (1 - 1.9033 a / l), l half its width (Happel & Brenner). From Re 10 on what channels of 12 x 20 and 20 x 30
    diameters change, on coarser grids, corrects the force."""
    if quick:
        return

    def drag(reynolds, cells, width, length, time):
        return steady(stream(3, reynolds, cells, width, length, time)) / (0.5 * math.pi / 4)

    exact = 240 / (1 - 1.9033 / 8)
    yield error_row(DRAG, "sphere, Re 0.1, 10 cells a diameter, channel of 8 diameters", 0.05, drag(0.1, 10, 8, 10, 4.0) / exact - 1)
    for reynolds in (10, 100, 200):
        exact = 24 / reynolds * (1 + 0.15 * reynolds**0.687)
        correction = (drag(reynolds, 6, 12, 20, 12.0) / drag(reynolds, 6, 6, 10, 12.0)
                      * drag(reynolds, 4, 20, 30, 16.0) / drag(reynolds, 4, 12, 20, 16.0))
        error = correction * drag(reynolds, 12, 6, 10, 12.0) / exact - 1
        yield error_row(DRAG, f"sphere, Re {reynolds}, 12 cells a diameter, channel of 6 diameters, corrected by {100 * (correction - 1):+.1f} %", 0.05, error)


def cylinder_drag(quick):
    """Steady: 2.02 and 1.51, with which published values for unbounded flow agree to 2 % (Dennis & Chang 1970: 2.045, 1.522; Fornberg
    1980: 2.000, 1.498); Re 100: mean drag 1.34, Strouhal number 0.165 (Williamson 1989: 0.1643). The domain counts more than anything:
    corrected by domains of 64 and 128 diameters at 8 and 4 cells a diameter; at Re 100 by one of 48 at 12 cells: at 8 the shedding is damped
    (lift 0.24 instead of 0.33), and with it what it adds to the drag."""
    if quick:
        return
    import numpy as np

    def shedding(cells, size, time=120.0):
        """Mean drag and Strouhal number over whole periods at the end."""
        t, fx, fy = (np.array([row[name] for row in stream(2, 100, cells, size, size, time)[:-1]]) for name in ("time", "fx", "fy"))
        rising = np.flatnonzero((fy[:-1] < 0) & (fy[1:] >= 0) & (t[1:] > 0.7 * time))
        crossings = t[rising] - fy[rising] * (t[rising + 1] - t[rising]) / (fy[rising + 1] - fy[rising])
        within = (t >= crossings[0]) & (t <= crossings[-1])
        t_in, fx_in = t[within], fx[within]
        mean = float(np.sum(0.5 * (fx_in[1:] + fx_in[:-1]) * np.diff(t_in))) / (t_in[-1] - t_in[0])
        return 2 * mean, (len(crossings) - 1) / (crossings[-1] - crossings[0])

    for reynolds, exact in ((20, 2.02), (40, 1.51)):
        coarse = {(cells, size): steady(stream(2, reynolds, cells, size, size, 60.0)) for cells, size in ((8, 16), (8, 64), (4, 64), (4, 128))}
        change = coarse[8, 64] / coarse[8, 16] * coarse[4, 128] / coarse[4, 64]
        drag = 2 * steady(stream(2, reynolds, 16, 16, 16, 60.0)) * change
        yield error_row(DRAG, f"cylinder, Re {reynolds}, 16 cells a diameter, channel of 16 diameters, corrected by {100 * (change - 1):+.1f} % to {drag:.3f}",
                        0.03, drag / exact - 1)
    narrow, wide, fine = shedding(12, 16), shedding(12, 48), shedding(24, 16)
    for name, i, exact in (("mean drag", 0, 1.34), ("Strouhal number", 1, 0.165)):
        change = wide[i] / narrow[i]
        yield error_row(DRAG, f"cylinder, Re 100, 24 cells a diameter, channel of 16 diameters: {name}, corrected by {100 * (change - 1):+.1f} % "
                        f"to {fine[i] * change:.4f}", 0.03, fine[i] * change / exact - 1)


def settling(quick):
    """Largest speed, and rest on the floor."""
    runs = ((970, 0.373, 0.0360, 5.0), (965, 0.212, 0.0572, 3.0), (962, 0.113, 0.0873, 2.0), (960, 0.058, 0.1222, 1.6))
    cells = 8 if quick else 12
    for density, viscosity, published, end in runs[3:] if quick else runs:
        n = [round(0.1 / 0.015 * cells), round(0.1 / 0.015 * cells), round(0.16 / 0.015 * cells)]
        size = [0.1, 0.1, 0.1 * n[2] / n[0]]
        scene = {"gravity": [0.0, 0.0, -9.81], "domain": {"size": size, "cells": n}, "fluid": {"density": density, "viscosity": viscosity},
                 "body": [{"name": "sphere", "shape": "ball", "radius": 0.0075, "position": [0.05, 0.05, 0.1275], "density": 1120.0}],
                 "time": {"end": 1.0 if quick else end, "max_step": end / 100, "cfl": 1.0}, "output": {"every": end}}
        rows = harness.run(scene)["bodies"]
        speed = -min(row["vz"] for row in rows)
        name = f"{viscosity:g} Pa s, {cells} cells a diameter"
        yield error_row(SETTLING, f"{name}: largest speed", 0.06 if quick else 0.04, speed / published - 1)
        if not quick:
            gap = rows[-1]["z"] - 0.0075
            yield Row(SETTLING, f"{name}: gap at the end, of the diameter; speed left, of the largest", "0 to 0.01; ≤ 1 %",
                      f"{gap / 0.015:.1e}; {100 * abs(rows[-1]['vz']) / speed:.2f} %", bool(-1e-9 <= gap / 0.015 <= 0.01 and abs(rows[-1]["vz"]) <= 0.01 * speed))


def bounce(reynolds, diameter, density, viscosity, cells, speed=None, roughness=1e-6, window=2e-3):
    """(restitution, gap at the end over the diameter): mean speed over `window` after the impact over that before it; None: it stays."""
    speed = speed or reynolds * viscosity / (density * diameter)
    dx = diameter / cells
    n = [5 * cells, 5 * cells, 6 * cells]
    end = 4.2 * diameter / speed
    scene = {"gravity": [0.0, 0.0, -9.81], "domain": {"size": [k * dx for k in n], "cells": n},
             "fluid": {"density": density, "viscosity": viscosity, "initial": "potential"}, "contact": {"restitution": 0.97}, "gap": {"roughness": roughness},
             "body": [{"name": "ball", "shape": "ball", "radius": 0.5 * diameter, "position": [n[0] * dx / 2, n[1] * dx / 2, 3.5 * diameter],
                       "velocity": [0.0, 0.0, -speed], "density": 7800.0}],
             "time": {"end": end, "max_step": 0.5 * dx / speed, "cfl": 1.0}, "output": {"every": end}}
    rows = harness.run(scene)["bodies"]
    time, gap = [row["time"] for row in rows], [row["z"] - 0.5 * diameter for row in rows]
    at = min(range(len(gap)), key=lambda i: gap[i])
    if max(gap[at:]) < 0.02 * diameter:
        return None, gap[-1] / diameter
    return ((interpolate(time[at] + window, time, gap) - gap[at]) / (interpolate(time[at] - window, time, gap) - gap[at])), gap[-1] / diameter


def bouncing(quick):
    for stokes, published, spread, numbers in ((27, 0.47, 0.08, (30, 0.006, 965.0, 0.1)), (152, 0.78, 0.05, (164, 0.003, 935.0, 0.01))):
        for cells in (8,) if quick else (8, 12) if stokes == 27 else (8, 12, 16):
            if quick and stokes != 27:
                continue
            e, _ = bounce(*numbers, cells)
            shown = stokes == 152 and cells == 8 # how it converges
            yield Row(BOUNCING, f"St {stokes}, roughness 1 µm, {cells} cells a diameter: restitution (speeds over 2 ms)", "" if shown else f"{published:g} ± {spread:g}",
                      "none" if e is None else f"{e:.3f}", shown or (e is not None and abs(e - published) <= spread))
    if not quick:
        for viscosity, speed in ((0.25, 0.385), (0.4, 0.25)):
            e, gap = bounce(0, 0.006, 965.0, viscosity, 8, speed)
            yield Row(BOUNCING, f"St {7800 * speed * 0.006 / (9 * viscosity):.2g}: rebound; gap at the end, of the diameter", "none; ≤ 0.01",
                      f"{'none' if e is None else f'{e:.3f}'}; {gap:.1e}", e is None and abs(gap) <= 0.01)


def pulled_plates(thicknesses, outside):
    """(time, opening rate) at each thickness by the table's model L (gap-averaged, linear drag, the head of the fluid that enters:
    film terms h'^2 / (24 h^2) - nu h' / h^3 and mass 1 / (12 h)), with the mass of the fluid outside, `outside`(h), that the table
    leaves out. Runge-Kutta."""
    nu, step = 2e-5, 2e-4

    def rate(h, v):
        slope = (outside(1.01 * h) - outside(0.99 * h)) / (0.02 * h)
        return (1 + v * v / (24 * h * h) - nu * v / h**3 - 0.5 * slope * v * v) / (0.5 + outside(h) + 1 / (12 * h))

    h, v, t, found = 0.01, 0.0, 0.0, []
    while len(found) < len(thicknesses):
        k1, k2 = (v, rate(h, v)), None
        k2 = (v + 0.5 * step * k1[1], rate(h + 0.5 * step * k1[0], v + 0.5 * step * k1[1]))
        k3 = (v + 0.5 * step * k2[1], rate(h + 0.5 * step * k2[0], v + 0.5 * step * k2[1]))
        k4 = (v + step * k3[1], rate(h + step * k3[0], v + step * k3[1]))
        h_next, v_next = (x + step / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]) for i, x in enumerate((h, v)))
        while len(found) < len(thicknesses) and thicknesses[len(found)] <= h_next:
            share = (thicknesses[len(found)] - h) / (h_next - h)
            found.append((t + share * step, v + share * (v_next - v)))
        h, v, t = h_next, v_next, t + step
    return found


def inertial_plates(quick):
    table = [row for row in harness.read_table(REFERENCE / "V3_inertial_plates_nu2e-05.csv") if row["h"] <= 0.06]
    model = pulled_plates([row["h"] for row in table], lambda h: 0.0)
    worst = max(max(abs(t / row["t_L"] - 1), abs(v / row["hdot_L"] - 1)) for (t, v), row in zip(model, table))
    yield Row(PLATES, "the model integrated here against the table's column L: largest difference", "≤ 0.1 %", f"{100 * worst:.3f} %", bool(worst <= 1e-3))
    known = sorted((math.log(row["h"]), row["M_opening_minus_lubrication"]) for row in harness.read_table(REFERENCE / "I4_rectangles_box4.csv"))
    thicknesses = [0.0105, 0.012, 0.015, 0.02, 0.03, 0.05]
    exact = pulled_plates(thicknesses, lambda h: interpolate(math.log(h), *zip(*known)))
    for cells in (64,) if quick else (64, 128):
        plates = [{"name": name, "shape": "box", "size": [1.0, 0.5], "density": 2.0, "position": [2.0, 2 + sign * 0.255], "force": [0.0, sign * 1.0],
                   "free": ["y"]} for name, sign in (("lower", -1), ("upper", 1))]
        scene = {"domain": {"size": [4.0, 4.0], "cells": [cells, cells]}, "fluid": {"viscosity": 2e-5}, "body": plates,
                 "time": {"end": 0.8, "max_step": 0.01}, "output": {"every": 0.8}}
        rows = harness.run(scene)["bodies"]
        lower, upper = ([row for row in rows if row["body"] == name] for name in ("lower", "upper"))
        h = [b["y"] - a["y"] - 0.5 for a, b in zip(lower, upper)]
        series = ([row["time"] for row in upper], [b["vy"] - a["vy"] for a, b in zip(lower, upper)])
        for what, which in (("time to reach", 0), ("opening rate at", 1)):
            errors = [interpolate(thickness, h, series[which]) / value[which] - 1 for thickness, value in zip(thicknesses, exact)]
            yield error_row(PLATES, f"{what} h = 0.0105 … 0.05, model L and the mass of the fluid outside, {cells}²: worst", 0.05, max(errors, key=abs))


ALL = [inertial_plates, bouncing, settling, sphere_drag, cylinder_drag]
