"""Contact: collisions against Lagrange's equation, rest, restitution, friction, stacks, valves, random scenes."""
import math
import random
import tempfile
from pathlib import Path

import harness
from harness import REFERENCE, Row

SECTION = "Contact"
OPEN_TOP = {"size": [4.0, 2.0], "cells": [64, 32], "sides": {"y_high": "open"}}


def track(result, body):
    return [row for row in result["bodies"] if row["body"] == body]


def interpolated(file, column, x_name, singular=lambda x: 0.0):
    """`singular` and a rest that is linear in log x."""
    rows = sorted(harness.read_table(REFERENCE / file), key=lambda row: row[x_name])
    rows = [row for row in rows if row[x_name] > 0]

    def value(x):
        x = min(max(x, rows[0][x_name]), rows[-1][x_name])
        for a, b in zip(rows, rows[1:]):
            if x <= b[x_name]:
                s = math.log(x / a[x_name]) / math.log(b[x_name] / a[x_name])
                rest = [row[column] - singular(row[x_name]) for row in (a, b)]
                return singular(x) + rest[0] + s * (rest[1] - rest[0])
        return rows[-1][column]
    return value


# ---- collisions ---------------------------------------------------------------------------------------------------------------

def collide(dimension, cells_a_radius):
    """[(h, speed of closing over the exact one)] of two cylinders or balls of radius 1 and density 2 that meet from gap 0.3, and the steps."""
    side = 8 if dimension == 2 else 10
    middle, n = [side / 2] * dimension, side * cells_a_radius
    scene = {"domain": {"size": [float(side)] * dimension, "cells": [n] * dimension}, "fluid": {"initial": "potential"},
             "body": [{"name": name, "shape": "ball", "radius": 1.0, "position": [middle[0] + at * 1.15] + middle[1:],
                       "velocity": [-0.5 * at] + [0.0] * (dimension - 1), "density": 2.0} for name, at in (("right", 1), ("left", -1))],
             "time": {"end": 0.45, "max_step": 0.16 / cells_a_radius, "gap_cfl": 0.25}, "output": {"every": 0.45}}
    result = harness.run(scene)
    if dimension == 2:
        mass = 2 * math.pi
        M = interpolated("I2b_two_cylinders_box8.csv", "M_opening_box8", "gap")
    else:  # each ball has its own added mass, that beside the plane of symmetry
        mass, displaced = 2 * 4 / 3 * math.pi, 4 / 3 * math.pi
        beside_a_wall = interpolated("I3_sphere_wall.csv", "C_normal", "gap_over_R")

        def M(gap):
            return displaced / 2 * beside_a_wall(gap / 2)
    energy = mass / 2 + M(0.3)
    rows = []
    for a, b in zip(track(result, "right"), track(result, "left")):
        h, speed = a["x"] - b["x"] - 2, b["vx"] - a["vx"]
        if h < 1e-4:
            break
        rows.append((h, speed / math.sqrt(energy / (mass / 2 + M(h)))))
    return rows, len(result["steps"]) - 1


def head_on(quick):
    for dimension, cells in ((2, 8), (2, 16)) if quick else ((2, 8), (2, 16), (2, 24), (3, 6), (3, 8)):
        rows, steps = collide(dimension, cells)
        error = max(abs(ratio - 1) for _, ratio in rows)
        judged = cells >= (16 if dimension == 2 else 8)
        yield Row(SECTION, f"two {'cylinders' if dimension == 2 else 'balls'} meet head-on from gap 0.3, {cells} cells a radius, to h = {min(h for h, _ in rows):.1g}, {steps} steps",
                  "≤ 3 % in ḣ" if judged else "", f"{100 * error:.2f} %", not judged or error <= 0.03)


def plates_approach(cells, h0, exit_law, **changes):
    """[(h, ḣ over its law)] of the reference's rectangles from h0 with ḣ = -1 down to h = 0.002, and the whole run. They may not turn: a tilt grows as h falls (the added mass
    has its least at parallel faces), and while h falls 4000-fold the solver's residual becomes a tilt of the gap's size."""
    scene = {"domain": {"size": [4.0, 4.0], "cells": [cells, cells]}, "fluid": {"initial": "potential"}, "gap": {"exit": exit_law},
             "body": [{"name": name, "shape": "box", "size": [1.0, 0.5], "position": [2.0, 2.0 + side * (0.25 + h0 / 2)], "velocity": [0.0, -0.5 * side],
                       "density": 2.0, "free": ["y"]} for name, side in (("upper", 1), ("lower", -1))],
             "time": {"end": 5 * h0 if h0 < 0.1 else 0.5, "max_step": 0.32 / cells, "cfl": 0.5, "gap_cfl": 8.0 / cells}, "output": {"every": 1.0}}
    for table, keys in changes.items():
        scene[table] = scene.get(table, {}) | keys
    result = harness.run(scene)
    M = interpolated("I4_rectangles_box4.csv", "M_opening", "h", lambda h: 1 / (12 * h))
    states = [(a["y"] - b["y"] - 0.5, a["vy"] - b["vy"]) for a, b in zip(track(result, "upper"), track(result, "lower"))]
    if exit_law == "reversible":
        def law(h):
            return math.sqrt((0.5 + M(h0)) / (0.5 + M(h)))
    else:    # (1/2 + M) h'' + M'/2 h'^2 = h'^2 / (8 h^2) as an equation for v^2(h), integrated down from h0
        table, v2, h, count = [(h0, 1.0)], 1.0, h0, 20000
        dh = (h0 - 0.0015) / count
        for _ in range(count):
            def slope(x, y):
                derivative = (M(x * 1.001) - M(x * 0.999)) / (0.002 * x)
                return 2 * y * (1 / (8 * x * x) - derivative / 2) / (0.5 + M(x))
            k = slope(h, v2)
            v2 -= dh * slope(h - dh / 2, v2 - dh / 2 * k)
            h -= dh
            table.append((h, v2))

        def law(x):
            i = min(int((h0 - x) / dh), count - 1)
            return math.sqrt(table[i][1])
    closing = []
    for h, v in states:
        if v >= 0 or h < 0.002:
            break
        closing.append((h, -v / law(h)))
    return closing, states, result


def plates_meet(quick):
    for cells, reversible, jet in () if quick else ((64, 0.01, 0.02), (128, 0.005, 0.01)):
        closing, states, result = plates_approach(cells, 0.02, "reversible")
        error = max(abs(ratio - 1) for _, ratio in closing)
        yield Row(SECTION, f"rectangles approach from h = 0.02, reversible mouths, {cells}²: ḣ(h) down to {closing[-1][0]:.2g}",
                  f"≤ {100 * reversible:g} %", f"{100 * error:.1f} %", error <= reversible)
        back = [v for (h, v), (h1, _) in zip(states, states[1:]) if v > 0 and h <= 0.02 <= h1]
        impulse = sum(row["contact_impulse"] for row in result["gaps"] if row["body_a"] in ("upper", "lower"))
        regained = f"{back[0]:.3f}" if back else f"never (smallest gap {min(h for h, _ in states):.2g}, last {states[-1][0]:.2g} at {states[-1][1]:.2g})"
        yield Row(SECTION, f"the same goes on: speed regained at h = 0.02; contact impulse over the momentum, {cells}²", "0.97 … 1.03; ≤ 1 %",
                  f"{regained}; {100 * impulse / 0.5:.2g} %", bool(back) and abs(back[0] - 1) <= 0.03 and impulse <= 0.005)
        _, states, _ = plates_approach(cells, 0.02, "reversible", gap={"roughness": 0.002}, contact={"restitution": 1.0}, time={"end": 0.06})
        speed = next(v + (0.02 - h) / (h1 - h) * (v1 - v) for (h, v), (h1, v1) in zip(states, states[1:]) if h <= 0.02 < h1 and v > 0)
        yield Row(SECTION, f"the same with roughness 0.002 and restitution 1, {cells}²: speed at h = 0.02 on the way back", "0.9 … 1.005", f"{speed:.3f}", 0.9 <= speed <= 1.005)
        closing, _, _ = plates_approach(cells, 0.02, "jet")
        error = max(abs(ratio - 1) for _, ratio in closing)
        yield Row(SECTION, f"the same with jets at the mouths, {cells}²: ḣ(h) down to {closing[-1][0]:.2g}", f"≤ {100 * jet:g} %",
                  f"{100 * error:.1f} %", error <= jet)
    if not quick:
        for cells in (64, 128):
            closing, _, _ = plates_approach(cells, 0.2, "reversible")
            at = {mark: min(closing, key=lambda row, mark=mark: abs(row[0] - mark)) for mark in (0.1, 0.05, 0.02, 0.01)}
            yield Row(SECTION, f"rectangles approach from h = 0.2, {cells}²: ḣ over the law of potential flow at h = 0.1, 0.05, 0.02, 0.01", "",
                      ", ".join(f"{at[m][1]:.2f}" for m in at), True)


# ---- rest, rebound, friction --------------------------------------------------------------------------------------------------

def box_on_floor(end):
    return {"gravity": [0.0, -1.0], "domain": OPEN_TOP,
            "body": [{"name": "box", "shape": "box", "size": [1.0, 0.5], "position": [2.013, 0.25], "density": 2.0}],
            "time": {"end": end, "max_step": 0.05}, "output": {"every": end}}


def rest(quick):
    end = 10.0 if quick else 100.0
    result = harness.run(box_on_floor(end))
    gaps, rows = [row for row in result["gaps"] if row["time"] > 1], track(result, "box")
    force = max(abs(row["contact_force"] / 0.5 - 1) for row in gaps)
    drift = max(math.hypot(row["x"] - 2.013, row["y"] - 0.25) for row in rows)
    yield Row(SECTION, f"box on the floor to t = {end:g} √(size/g): contact force over weight less buoyancy − 1 after t = 1, drift over size", "≤ 1e-6",
              f"{force:.1e}, {drift:.1e}", force <= 1e-6 and drift <= 1e-6)


def rebound(quick):
    for e in (0.0, 0.5, 1.0):
        scene = {"gravity": [0.0, -1.0], "domain": {"size": [2.0, 2.0], "cells": [32, 32], "sides": {"y_high": "open"}}, "fluid": {"density": 1e-6},
                 "contact": {"restitution": e},
                 "body": [{"name": "ball", "shape": "ball", "radius": 0.25, "position": [1.0, 0.45], "velocity": [0.0, -1.0], "density": 1.0}],
                 "time": {"end": 0.3, "max_step": 0.01}, "output": {"every": 0.3}}
        rows = track(harness.run(scene), "ball")
        before, after = next((a, b) for a, b in zip(rows, rows[1:]) if b["vy"] > a["vy"] + 0.5)
        # Energy at the floor before, and just after from what the ball still has some steps later.
        v0 = math.sqrt(1 + 2 * 0.2)
        last = rows[-1]
        v1 = math.sqrt(max(2 * (last["y"] - 0.25) + last["vy"] ** 2, 0)) if e > 0 else abs(after["vy"])
        if e == 0:
            v1 = max(abs(row["vy"]) for row in rows if row["time"] > before["time"] + 0.02)
        error = abs(v1 / v0 - e)
        yield Row(SECTION, f"ball on a floor in a fluid of density 1e-6, restitution {e:g}: rebound speed", "± 0.5 % of the speed of impact",
                  f"{v1 / v0:.5f}", error <= 0.005)


def friction(quick):
    for dimension in (2,) if quick else (2, 3):
        moved = {}
        for factor in (0.99, 1.01):
            domain = OPEN_TOP if dimension == 2 else {"size": [2.0, 1.0, 1.0], "cells": [32, 16, 16], "sides": {"z_high": "open"}}
            size, position = ([1.0, 0.5], [1.5, 0.25]) if dimension == 2 else ([0.5, 0.4, 0.3], [0.8, 0.5, 0.15])
            scene = {"gravity": [0.3] + [0.0] * (dimension - 2) + [-1.0], "domain": domain, "contact": {"friction": 0.3 * factor},
                     "body": [{"name": "block", "shape": "box", "size": size, "position": position, "density": 2.0}],
                     "time": {"end": 0.5, "max_step": 0.02}, "output": {"every": 0.5}}
            rows = track(harness.run(scene), "block")
            moved[factor] = rows[-1]["x"] - rows[0]["x"]
        yield Row(SECTION, f"block on a floor tilted by tan θ = 0.3, {dimension}D: way in t = 0.5 at μ = 0.99 and 1.01 tan θ", "slides; holds (< 1e-6)",
                  f"{moved[0.99]:.1e}; {moved[1.01]:.1e}", moved[0.99] > 1e-5 and abs(moved[1.01]) < 1e-6)


def stack(quick):
    bodies = [{"name": f"box{i}", "shape": "box", "size": [0.8, 0.3], "position": [2 + 0.05 * (-1) ** i, 0.15 + 0.3 * i + 0.002 * (i + 1)], "density": 2.0}
              for i in range(5)]
    scene = {"gravity": [0.0, -1.0], "domain": {"size": [4.0, 2.0], "cells": [64, 32], "sides": {"y_high": "open"}}, "contact": {"friction": 0.3},
             "gap": {"roughness": 1e-3}, "body": bodies, "time": {"end": 2.0 if quick else 10.0, "max_step": 0.02}, "output": {"every": 10.0}}
    result = harness.run(scene)
    overlap = max(1e-3 - row["thickness"] for row in result["gaps"])
    speed = max(math.hypot(row["vx"], row["vy"]) for row in result["bodies"][-5:])
    energy = [row["energy_fluid"] + row["energy_bodies"] for row in result["steps"]]
    yield Row(SECTION, f"stack of 5 boxes, let go {2:g} … 10 thousandths too high, to t = {scene['time']['end']:g}: overlap in cells, last speed, "
              "largest kinetic energy", "overlap ≤ 1e-3", f"{max(overlap, 0) * 16:.1e}, {speed:.1e}, {max(energy):.1e}",
              overlap * 16 <= 1e-3 and speed < 0.05)


def leak(quick):
    """A gate that rests between two seats, held `roughness` off them; the flow is given, and the force along it is the drop of pressure
    times the height. What the mouths and the channel add to the slots' inertia, some thousandths here, is left out."""
    ramp, speed, loss = 1.0, 0.01, 0.5
    for cells, roughness in ((48, 5e-4),) if quick else ((32, 3e-3), (64, 3e-3), (48, 5e-4)):
        with tempfile.TemporaryDirectory() as folder:
            table = Path(folder) / "inflow.csv"
            table.write_text(f"time,u,v\n0,0,0\n{ramp},{speed},0\n{10 * ramp},{speed},0\n")
            scene = {"gravity": [0.0, -10.0],
                     "domain": {"size": [4.0, 1.0], "cells": [4 * cells, cells], "sides": {"x_low": {"inflow": str(table)}, "x_high": "open"}},
                     "gap": {"contact": "wet", "roughness": roughness, "exit": "jet", "entrance_loss": loss},
                     "body": [{"name": "gate", "shape": "box", "size": [1.0, 1.0 - 2 * roughness], "position": [2.0, 0.5], "density": 50.0, "free": ["y"]}],
                     "time": {"end": 2 * ramp, "max_step": 0.02}, "output": {"every": 10.0}}
            result = harness.run(scene)
        worst, steps, divergence = 0, track(result, "gate"), max(row["divergence_max"] for row in result["steps"])
        for before, row in zip(steps, steps[1:]):
            if before["time"] < ramp <= row["time"]:
                continue     # the step in which the flow stops growing
            flux, growth = 0.5 * speed * min(row["time"] / ramp, 1), 0.5 * speed / ramp * (row["time"] <= ramp)    # of either slot
            law = growth / roughness + (1 + loss) / 2 * (flux / roughness) ** 2
            worst = max(worst, abs(row["fx"] / law - 1))
        yield Row(SECTION, f"gate on its seats, roughness {roughness:g} = {roughness * cells:.2g} cells, flow that grows and then stays: drop of pressure against "
                  f"the law of the slot with ζ = {loss:g}; divergence", "≤ 10 %; ≤ 1e-6", f"{100 * worst:.2f} %; {divergence:.0e}",
                  worst <= 0.1 and divergence <= 1e-6)


# ---- dry contact and cavitation -----------------------------------------------------------------------------------------------

AMBIENT, THICKNESS = 10.0, 1e-4


def dry_block(dimension, cells, pull, end):
    """A block of mass 1 and facing area 1, dry on the floor of a tank with an open top, pulled up by a share of p0 A."""
    side = {2: "y_high", 3: "z_high"}[dimension]
    block = {"name": "block", "shape": "box", "mass": 1.0, "force": [0.0] * (dimension - 1) + [pull * AMBIENT]}
    if dimension == 2:
        domain = {"size": [4.0, 2.0], "cells": [cells, cells // 2]}
        block |= {"size": [1.0, 0.5], "position": [2.013, 0.25 + THICKNESS], "inertia": 0.1}
    else:
        domain = {"size": [3.0, 3.0, 1.5], "cells": [cells, cells, cells // 2]}
        block |= {"size": [1.0, 1.0, 0.5], "position": [1.513, 1.49, 0.25 + THICKNESS], "inertia": [0.1, 0.1, 0.1]}
    return {"domain": domain | {"sides": {side: "open"}}, "fluid": {"reference_pressure": AMBIENT},
            "gap": {"contact": "dry", "entrance_loss": 0.5}, "contact": {"thickness": THICKNESS}, "body": [block],
            "time": {"end": end, "max_step": 2e-3}, "output": {"every": end}}


def rise(result, dimension):
    rows = track(result, "block")
    return rows[-1]["xyz"[dimension - 1]] - rows[0]["xyz"[dimension - 1]]


def threshold(quick):
    for dimension, cells, step in ((2, 32, 0.001), (2, 64, 0.001), (3, 16, 0.01)) if quick else \
            ((2, 32, 0.001), (2, 64, 0.001), (2, 128, 0.001), (3, 16, 0.001), (3, 24, 0.001), (3, 48, 0.001)):
        end = 0.1 if dimension == 2 else 0.02
        held, lifted = (harness.run(dry_block(dimension, cells, pull, end)) for pull in (1 - step, 1 + step))
        force = held["gaps"][-1]["contact_force"] / AMBIENT
        worst = max(row["divergence_max"] for row in lifted["steps"])
        yield Row(SECTION, f"dry block of facing area A under ambient pressure p0, {dimension}D, {cells} cells along x: pull + contact force over p0 A − 1 at "
                  f"{1 - step:g} p0 A; its rise; rise at {1 + step:g} p0 A by t = {end:g}; divergence there", "≤ 1e-5; 0; > 0; ≤ 1e-7",
                  f"{1 - step + force - 1:.1e}; {rise(held, dimension):.1e}; {rise(lifted, dimension):.2e}; {worst:.0e}",
                  abs(force - step) <= 1e-5 and abs(rise(held, dimension)) < 1e-10 and rise(lifted, dimension) > 1e-8 and worst <= 1e-7)


def lifting(quick):
    prototype = {1.001: 3.5e-5, 1.03: 1.1e-3, 1.1: 3.4e-3, 1.5: 1.6e-2}
    for cells in (32, 64) if quick else (32, 64, 128):
        rises = {pull: rise(harness.run(dry_block(2, cells, pull, 0.1)), 2) for pull in prototype}
        yield Row(SECTION, f"the same lifts off, 2D, {cells} cells along x: rise by t = 0.1 at " + ", ".join(f"{p:g}" for p in prototype) + " p0 A",
                  "from 1.03 p0 A on ± 10 % of " + ", ".join(f"{v:.2g}" for v in prototype.values()), ", ".join(f"{v:.2e}" for v in rises.values()),
                  all(abs(rises[p] / prototype[p] - 1) <= 0.1 for p in (1.03, 1.1, 1.5)))


def flood(quick):
    """Lifted by 0.01 within 0.005 and held: water runs in under both ends over a void."""
    for cells in (32, 64) if quick else (32, 64, 128):
        scene = dry_block(2, cells, 0.0, 0.18)
        y = scene["body"][0]["position"][1]
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "lift.csv"
            file.write_text(f"time,x,y,angle\n0,2.013,{y},0\n0.005,2.013,0.26,0\n1,2.013,0.26,0\n")
            scene["body"][0] |= {"motion": "prescribed", "file": str(file)}
            result = harness.run(scene)
        volume = [(row["time"], row["void_volume"]) for row in result["gaps"]]
        at = {t: min(volume, key=lambda row, t=t: abs(row[0] - t)) for t in (0.08, 0.13)}
        speed = (at[0.08][1] - at[0.13][1]) / (at[0.13][0] - at[0.08][0]) / 0.02
        last, worst = result["gaps"][-1], max(row["divergence_max"] for row in result["steps"][1:])
        yield Row(SECTION, f"the same held 0.01 above the floor over a void, {cells} cells along x: speed of the flood fronts over √(2 p0/(ρ(1 + ζ))); "
                  "void and least pressure over p0 once it is full; divergence", "1 ± 0.06; 0; 1 ± 0.01; ≤ 1e-6",
                  f"{speed / math.sqrt(2 * AMBIENT / 1.5):.3f}; {last['void_volume']:g}; {last['pressure_min'] / AMBIENT:.4f}; {worst:.0e}",
                  abs(speed / math.sqrt(2 * AMBIENT / 1.5) - 1) <= 0.06 and last["void_volume"] == 0 and abs(last["pressure_min"] / AMBIENT - 1) <= 0.01
                  and worst <= 1e-6)


def cavitation(quick):
    for cells in (32, 64) if quick else (32, 64, 128):
        plates = [{"name": name, "shape": "box", "size": [1.0, 0.5], "position": [2.0, 2.0 + side * 0.255], "density": 1.0, "force": [0.0, 4.0 * side]}
                  for name, side in (("upper", 1), ("lower", -1))]
        scene = {"domain": {"size": [4.0, 4.0], "cells": [cells, cells], "sides": {"y_high": "open"}}, "gap": {"exit": "jet"}, "body": plates,
                 "time": {"end": 0.1, "max_step": 2e-3}, "output": {"every": 0.1}}
        rows = {}
        for vapour in ("none", 0.2):
            result = harness.run(scene | {"fluid": {"reference_pressure": 1.0, "vapour_pressure": vapour}})
            rows[vapour] = [row for row in result["gaps"] if row["step"] > 0 and {row["body_a"], row["body_b"]} == {"upper", "lower"}]
        least = {vapour: min(row["pressure_min"] for row in gaps) for vapour, gaps in rows.items()}
        yield Row(SECTION, f"plates pulled apart from 0.01 with four times the ambient pressure, {cells}²: least pressure without and with vapour pressure 0.2; "
                  "gap at t = 0.1; largest void over the gap's volume", "< 0; 0.2; –; > 0",
                  f"{least['none']:.2f}; {least[0.2]:.9g}; {rows['none'][-1]['thickness']:.4f} and {rows[0.2][-1]['thickness']:.4f}; "
                  f"{max(row['void_volume'] / row['thickness'] for row in rows[0.2]):.2f}",
                  least["none"] < 0 and abs(least[0.2] - 0.2) <= 1e-9 and max(row["void_volume"] for row in rows[0.2]) > 0)


# ---- many bodies --------------------------------------------------------------------------------------------------------------

def random_scene(number):
    """3 to 12 bodies of all shapes in a tank, apart by their bounding balls, that fall on each other. Odd numbers: the tank is closed."""
    rng = random.Random(number)
    dimension = rng.choice((2, 2, 3))
    n = 32 if dimension == 2 else 16
    bodies, balls = [], []
    for i in range(rng.randint(3, 12)):
        shape = rng.choice(("box", "ball", "capsule") + (("cylinder",) if dimension == 3 else ()))
        for _ in range(200):
            r = rng.uniform(0.06, 0.13)
            reach = {"box": math.sqrt(dimension) * r, "ball": r}.get(shape, 1.5 * r)
            place = [rng.uniform(reach, 1 - reach) for _ in range(dimension)]
            if all(math.dist(place, other) > reach + far for other, far in balls):
                break
        else:
            continue
        balls.append((place, reach))
        body = {"name": f"b{i}", "shape": shape, "position": place, "density": rng.choice((0.5, 1.0, 2.0, 8.0)),
                "velocity": [rng.gauss(0, 0.3) for _ in range(dimension)]}
        if shape == "box":
            body["size"] = [rng.uniform(r, 2 * r) for _ in range(dimension)]
        else:
            body["radius"] = r
        if shape in ("capsule", "cylinder"):
            body["length"] = r
        body["rotation"] = rng.uniform(0, 360) if dimension == 2 else [rng.gauss(0, 1) for _ in range(4)]
        bodies.append(body)
    scene = {"gravity": [0.0] * (dimension - 1) + [-1.0],
             "domain": {"size": [1.0] * dimension, "cells": [n] * dimension, "sides": {} if number % 2 else {"xyz"[dimension - 1] + "_high": "open"}},
             "contact": {"friction": rng.choice((0.0, 0.3)), "restitution": rng.choice((0.0, 0.0, 0.5))},
             "gap": {"roughness": rng.choice((0.0, 1e-3))}, "body": bodies,
             "time": {"end": 1000.0, "max_step": 0.01}, "output": {"every": 1000.0}}
    return scene, dimension


def energy_rise(pulls, steps, bodies):
    """Largest rise of the whole energy over the peak of the kinetic, in a closed tank (through an open side some comes in). `pulls`: {body: constant force on it}, reduced weight
    included."""
    potential = {}
    for row in bodies:
        pull = pulls.get(row["body"], ())
        potential[row["step"]] = potential.get(row["step"], 0.0) - sum(f * row[axis] for f, axis in zip(pull, "xyz"))
    lowest, rise, peak = math.inf, 0.0, 0.0
    for row in steps:
        kinetic = row["energy_fluid"] + row["energy_bodies"]
        energy = kinetic + potential[row["step"]]
        lowest = min(lowest, energy)
        rise, peak = max(rise, energy - lowest), max(peak, kinetic)
    return rise / peak


def random_scenes(quick):
    if quick:
        return
    count, steps = 200, 50
    bad, unsettled, grown, rises = [], 0, 0.0, []
    for number in range(count):
        scene, dimension = random_scene(number)
        scene["time"]["end"] = 0.01 * steps
        scene["grid"] = {**scene.get("grid", {}), "thin": "allow"}    # some have bodies of less than a cell
        with tempfile.TemporaryDirectory() as folder:
            file, out = Path(folder) / "scene.toml", Path(folder) / "out"
            file.write_text(harness.scene_text(scene))
            done = harness.command(["run", file, "-o", out, "--quiet"], check=False, timeout=900)
            rows = harness.read_table(out / "steps.csv") if (out / "steps.csv").exists() else []
            if done.returncode != 0:
                bad.append(f"{number}: {done.stderr.strip()[-120:]}")
                continue
            unsettled += "did not settle" in done.stderr
            values = [row["energy_bodies"] for row in rows]
            if any(not math.isfinite(v) for v in values):
                bad.append(f"{number}: not finite")
            # What falls from the top of the tank to its floor gains its weight times the height, and no more.
            masses = sum(b.get("density") * 0.15 for b in scene["body"])
            grown = max(grown, max(values) / (values[0] + masses))
            if not scene["domain"]["sides"]:
                pulls = {b["name"]: [0.0] * (dimension - 1) + [(1 - b["density"]) * harness.volume(b, dimension)] for b in scene["body"]}
                rises.append(energy_rise(pulls, rows, harness.read_table(out / "bodies.csv")))
    yield Row(SECTION, f"{count} random scenes of 3 to 12 bodies in 2D and 3D, t = {0.01 * steps:g}: failures; contacts unsettled; largest kinetic energy over a bound",
              "0; –; ≤ 1", f"{len(bad)}{' (' + '; '.join(bad[:3]) + ')' if bad else ''}; {unsettled}; {grown:.2f}", not bad and grown <= 1)
    rises = rises or [math.inf]
    yield Row(SECTION, f"the {len(rises)} of them whose tank is closed: largest rise of the whole energy over the largest kinetic energy, in the worst, in the mean",
              "≤ 2 %, ≤ 0.5 %", f"{max(rises):.2%}, {sum(rises) / len(rises):.2%}", max(rises) <= 0.02 and sum(rises) / len(rises) <= 0.005)


ALL = (head_on, plates_meet, rest, rebound, friction, stack, leak, threshold, lifting, flood, cavitation, random_scenes)
