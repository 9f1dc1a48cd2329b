"""Added masses with gap.model = "parts" (docs/theory/complex.md): single bodies, walls, crowds, thin plates, uniform motion.

References: exact series where the text says so; else Richardson's value of two finer grids of the same model, or the literature.
"""
import json
import math
import random
import tempfile
from pathlib import Path

import harness
from added_mass_cases import apply, cylinder_exact, domain, energy, in_container, interpolate, opening, plates3d, quaternion, rectangles, rotate, rotation_matrix, table, times
from harness import Row

SINGLE = "Parts: one body, over its places on the grid"
THIN = "Parts: thin plates"
SHEET = "Parts: sheets, thin discs and square plates"
SLIT = "Parts: slits and holes in thin walls"
NEAR = "Parts: ball over a wall, two balls"
IN_PLANE = "Parts: gaps in 2D"
CURVED = "Parts: gaps of curved walls in space"
PLATES = "Parts: two square plates"
SUMS = "Parts: uniform motion and sums"
LIGHT = "Parts: light bodies"
CROWD = "Parts: crowd of 48 balls"
SHIFTS = "Parts: added mass over 200 small shifts"
MESHES = "Parts: meshes"
FORCE = "Parts: derivative of the energy by places and angles"


def parts(scene, **more):
    return harness.added_mass({**scene, "gap": dict(model="parts"), **more})


def mean_and_scatter(values):
    mean = sum(values) / len(values)
    return mean, math.sqrt(sum((v - mean) ** 2 for v in values) / len(values))


def alone(dimension, radius, shift, **body):
    """A body of `radius` cells in a closed box of ten radii, moved by `shift` cells."""
    n = round(10 * radius)
    centre = [0.5 + s / n for s in shift]
    return dict(domain=domain([1.0] * dimension, [n] * dimension),
                body=[{**dict(name="b", shape="ball", radius=radius / n, position=centre, density=2.0), **body}])


def coefficients(dimension, radius, shift):
    n = round(10 * radius)
    result = parts(alone(dimension, radius, shift))
    volume = math.pi * radius ** 2 / n ** 2 if dimension == 2 else 4 / 3 * math.pi * (radius / n) ** 3
    return [result["matrix"][k][k] / volume for k in range(dimension)], result


def round_bodies(quick):
    places = random.Random(1)
    for dimension, fine in ((2, (24, 48)), (3, (10, 15))):
        if quick and dimension == 3:
            return
        c = [sum(coefficients(dimension, r, [0.31, 0.17, 0.23][:dimension])[0]) / dimension for r in fine]
        reference = c[1] + (c[1] - c[0]) / ((fine[1] / fine[0]) ** 2 - 1)
        for radius, target in ((3.2, 0.3), (4, 0.1)) if quick else ((3.2, 0.3), (4, 0.1), (8, 0.02)):
            errors, iterations = [], 0
            for _ in range(12 if dimension == 2 else 4 if radius < 8 else 1):
                found, result = coefficients(dimension, radius, [places.uniform(-0.5, 0.5) for _ in range(dimension)])
                errors += [100 * (x / reference - 1) for x in found]
                iterations = max(iterations, *result["iterations"])
            mean, scatter = mean_and_scatter(errors)
            yield Row(SINGLE, f"{'disk' if dimension == 2 else 'ball'} of {radius:g} cells a radius in a closed box, against {fine[0]} and {fine[1]} cells by Richardson",
                      f"scatter ≤ {target} %, mean told", f"{mean:+.3f}, {scatter:.3f} % (at most {iterations} iterations)", scatter <= target)


def boxes(quick):
    """2D boxes in a closed square of five lengths; reference: 96 cells long, aligned and turned."""
    places = random.Random(2)

    def scene(cells, degrees, shift):
        n = 5 * cells
        return dict(domain=domain((1.0, 1.0), (n, n)), body=[dict(name="b", shape="box", size=[0.2, 0.1], position=[0.5 + shift[0] / n, 0.5 + shift[1] / n],
                                                                 rotation=degrees, density=2.0)])

    def components(cells, degrees, shift):
        result = parts(scene(cells, degrees, shift))
        e, f = rotate((1.0, 0.0), degrees), rotate((0.0, 1.0), degrees)
        return [energy(result, {"b": d}) for d in (e, f)]

    if quick:
        return
    references = {}
    for cells, target in ((8, 3.0), (16, 1.5), (24, 1.0)):
        errors = ([], [])
        for _ in range(12):
            degrees = places.uniform(0, 90)
            if not references: # turned boxes in a square box: the box's share is below 0.1 %
                coarse, finer = components(48, 20.0, (0.31, 0.17)), components(96, 20.0, (0.31, 0.17))
                references = [b + (b - a) / 3 for a, b in zip(coarse, finer)]
            for k, m in enumerate(components(cells, degrees, (places.uniform(-0.5, 0.5), places.uniform(-0.5, 0.5)))):
                errors[k].append(100 * (m / references[k] - 1))
        for k, name in ((0, "along"), (1, "across")):
            mean, scatter = mean_and_scatter(errors[k])
            yield Row(SINGLE, f"box {cells} x {cells // 2} cells, {name}, 12 poses, against 48 and 96 cells by Richardson", f"mean and scatter ≤ {target:g} %",
                      f"{mean:+.2f}, {scatter:.2f} %", max(abs(mean), scatter) <= target)


def rectangle(length, thickness):
    """Added mass of a rectangle normal to its length in unbounded fluid (Schwarz and Christoffel: corners at angles +-a, pi +- a)."""
    def side(a, low, high):
        middle, half, steps = (low + high) / 2, (high - low) / 2, 400
        s = [math.pi * ((k + 0.5) / steps - 0.5) for k in range(steps)]
        return sum(math.sqrt(2 * abs(math.cos(2 * (middle + half * math.sin(x))) - math.cos(2 * a))) * half * math.cos(x) for x in s) * math.pi / steps

    low, high = 1e-9, math.pi / 4 + 0.01
    for _ in range(80):
        a = (low + high) / 2
        low, high = (a, high) if side(a, -a, a) / side(a, a, math.pi - a) < thickness / length else (low, a)
    c = length / side(low, low, math.pi - low)
    return 2 * math.pi * c * c * (1 + math.cos(2 * low)) - length * thickness


def in_closed_square(m, area, width):
    """The same in the middle of a closed square: the body is a dipole, and its images act on it."""
    k = math.pi / 6 - math.pi * sum((-1) ** i / math.sinh(math.pi * i) ** 2 for i in range(1, 6))
    return (m + area) / (1 - k * (m + area) / width ** 2) - area


def thin_plates(quick):
    """Added mass of a plate normal to itself, in a closed square of six lengths."""
    angles, shifts = (0.0, 10.0, 25.0, 45.0), ((0.31, 0.17), (0.13, 0.47), (0.07, 0.29), (0.44, 0.38))

    def errors(cells, thickness, shifts):
        exact = in_closed_square(rectangle(1.0, thickness / cells), thickness / cells, 6.0)
        n = 6 * cells
        for degrees in angles:
            for shift in shifts:
                result = parts(dict(domain=domain((6.0, 6.0), (n, n)), body=[
                    dict(name="b", shape="box", size=[1.0, thickness / cells], position=[3 + shift[0] / cells, 3 + shift[1] / cells], rotation=degrees, density=2.0)]))
                yield energy(result, {"b": rotate((0.0, 1.0), degrees)}) / exact - 1

    for cells, target in ((16, 2.5), (32, 1.2)):
        if quick and cells == 32:
            return
        for thickness in (1.0, 0.1, 0.01, 0.001):
            found = list(errors(cells, thickness, shifts))
            rms = math.sqrt(sum(e * e for e in found) / len(found))
            yield Row(THIN, f"plate {cells} x {thickness:g} cells, normal, 0, 10, 25, 45 degrees, four places", f"rms ≤ {target} %",
                      f"{100 * rms:.2f} % ({100 * min(found):+.2f} … {100 * max(found):+.2f})", rms <= target / 100)
    yield Row(THIN, "plate 16 x 0.001 cells on planes of the grid, its ends on lines of it", "", f"{100 * next(errors(16, 0.001, ((0.0, 0.0),))):+.2f} %", True)


def walls_of_any_thickness(quick):
    """A wall across a channel at any angle: the fluid on its two sides is two parts, and no flux passes."""
    for thickness in (1.0, 0.1, 0.001):
        for degrees in (0.0, 10.0, 37.0):
            n = 32
            result = parts(dict(domain=domain((1.0, 1.0), (n, n)), body=[
                dict(name="wall", shape="box", size=[3.0, thickness / n], position=[0.5, 0.517], rotation=degrees, motion="fixed"),
                dict(name="b", shape="ball", radius=0.1, position=[0.5, 0.25], density=2.0), dict(name="c", shape="ball", radius=0.1, position=[0.5, 0.8], density=2.0)]))
            across = max(abs(result["matrix"][i][j]) for i in range(3) for j in range(3, 6)) / result["matrix"][0][0]
            yield Row(THIN, f"wall {thickness:g} cells thick at {degrees:g} degrees between two disks: what one feels of the other, sealed parts", "0 to round-off; 1",
                      f"{across:.1e}; {len(result['sealed'])}", across < 1e-9 and len(result["sealed"]) == 1)


def rms_row(section, case, target, errors, iterations=None, most=None):
    rms = math.sqrt(sum(e * e for e in errors) / len(errors))
    text = f"{100 * rms:.2f} % ({100 * min(errors):+.2f} … {100 * max(errors):+.2f})" + (f"; {iterations}" if iterations else "")
    return Row(section, case, f"rms ≤ {target} %" + (f"; ≤ {most} iterations" if most else ""), text, rms <= target / 100 and (not most or iterations <= most))


def arc_of(radius, half_angle, segments=96):
    """Polyline of a circular arc whose axis is y, its chord's middle at the origin."""
    return [[radius * math.sin(a), radius * (math.cos(a) - math.cos(half_angle))] for a in (half_angle * (2 * k / segments - 1) for k in range(segments + 1))]


def arc_masses(radius, half_angle):
    """Of a circular arc of no thickness in unbounded fluid, along and normal to its chord (Joukowsky: chord 4k, height 2h)."""
    k, h = radius * math.sin(half_angle) / 2, radius * (1 - math.cos(half_angle)) / 2
    return 2 * math.pi * h * h, 2 * math.pi * (h * h + 2 * k * k)


def sheets(quick):
    """Polylines in a closed square of six lengths: an arc of 200 degrees, of a radius of half a length, and a plate bent by a right angle in its middle."""
    if quick:
        return
    places, half = random.Random(3), math.radians(100)
    masses = [in_closed_square(m, 0.0, 6.0) for m in arc_masses(0.5, half)]

    def scene(points, cells, thickness, degrees, shift):
        n = 6 * cells
        return dict(domain=domain((6.0, 6.0), (n, n)), body=[dict(name="b", shape="sheet", points=points, thickness=thickness / cells, density=2.0,
                                                                  position=[3 + shift[0] / cells, 3 + shift[1] / cells], rotation=degrees)])

    bent = [[-0.5 / math.sqrt(2), 0.0], [0.0, 0.5 / math.sqrt(2)], [0.5 / math.sqrt(2), 0.0]]
    reference = None
    for cells, target in ((16, 2.5), (32, 1.2)):
        for thickness in (0.01, 0.001):
            errors, iterations = ([], []), 0
            for degrees in (0.0, 10.0, 25.0, 45.0):
                for _ in range(3):
                    result = parts(scene(arc_of(0.5, half), cells, thickness, degrees, (places.uniform(-0.5, 0.5), places.uniform(-0.5, 0.5))))
                    iterations = max(iterations, *result["iterations"])
                    for k, v in enumerate(((1.0, 0.0), (0.0, 1.0))):
                        errors[k].append(energy(result, {"b": rotate(v, degrees)}) / masses[k] - 1)
            for k, name in enumerate(("along its chord", "normal to it")):
                yield rms_row(SHEET, f"arc of 200 degrees, {cells} cells a diameter, {thickness:g} cells thick, {name}", target, errors[k], iterations, 25)
        if not reference:
            coarse, finer = ([energy(parts(scene(bent, n, 0.001 * n / 16, 20.0, (0.31, 0.17))), {"b": rotate(v, 20.0)}) for v in ((1.0, 0.0), (0.0, 1.0))] for n in (64, 128))
            reference = [2 * b - a for a, b in zip(coarse, finer)]
        for k, name in enumerate(("along", "normal")):
            found = []
            for degrees in (0.0, 10.0, 25.0, 45.0):
                result = parts(scene(bent, cells, 0.001 * cells / 16, degrees, (places.uniform(-0.5, 0.5), places.uniform(-0.5, 0.5))))
                found.append(energy(result, {"b": rotate(((1.0, 0.0), (0.0, 1.0))[k], degrees)}) / reference[k] - 1)
            yield rms_row(SHEET, f"plate of {cells} cells bent by a right angle, 0.001 cells thick, {name} the line of its ends, against 64 and 128 cells", target, found)


def write_obj(path, vertices, quads):
    path.write_text("".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in vertices) + "".join("f " + " ".join(str(k + 1) for k in q) + "\n" for q in quads))


def bent_mesh(path, points, low, high):
    """A polyline in the plane, swept from z = low to high."""
    n = len(points)
    write_obj(path, [(*x, z) for z in (low, high) for x in points], [(k, k + 1, n + k + 1, n + k) for k in range(n - 1)])


def bent_plate_in_space(quick):
    """A sheet of a mesh that reaches through a slice of four cells between two walls: the flow is that of the polyline in the plane."""
    if quick:
        return
    bent = [[-0.35, 0.0], [0.0, 0.35], [0.35, 0.0]]
    with tempfile.TemporaryDirectory() as folder:
        mesh = Path(folder) / "bent.obj"
        bent_mesh(mesh, bent, -0.126, 0.126)
        for thickness in (0.5, 0.01):
            differences = []
            for degrees, shift in ((0.0, (0.31, 0.17)), (25.0, (0.07, 0.29))):
                place = [1 + shift[0] / 16, 1 + shift[1] / 16]
                body = dict(name="b", shape="sheet", thickness=thickness / 16, mass=1.0)
                flat = parts(dict(domain=domain((2.0, 2.0), (32, 32)), body=[dict(body, points=bent, inertia=1.0, position=place, rotation=degrees)]))
                deep = parts(dict(domain=domain((2.0, 2.0, 0.25), (32, 32, 4)), body=[
                    dict(body, file=str(mesh), inertia=[1.0, 1.0, 1.0], position=[*place, 0.125], rotation=quaternion((0, 0, 1), degrees))]))
                differences += [deep["matrix"][i][j] / 0.25 / flat["matrix"][1][1] - flat["matrix"][i][j] / flat["matrix"][1][1] for i in range(2) for j in range(2)]
            worst = 100 * max(map(abs, differences))
            yield Row(SHEET, f"plate bent by a right angle, {thickness:g} cells thick, as a mesh between two walls: against the polyline", "", f"{worst:.1e} %", True)


def plates_in_space(quick):
    """A disc (a cylinder) and a square plate normal to themselves, far sides at three lengths; 8/3 a^3 and 0.579 pi/4 L^3 (Meyerhoff 1970)."""
    poses = ((None, 0.0), ((0, 1, 0), 25.0), ((1, 2, -1), 50.0))
    far = {f"{axis}_{end}": "far" for axis in "xyz" for end in ("low", "high")}

    def masses(kind, cells, thickness, width=3.0, few=False):
        n = round(width * cells)
        for axis, degrees in poses[:1] if few else poses:
            for shift in ((0.31, 0.17, 0.23),) if few else ((0.31, 0.17, 0.23), (0.07, 0.44, 0.38)):
                body = dict(shape="cylinder", radius=0.5, length=thickness / cells) if kind == "disc" else dict(shape="box", size=[thickness / cells, 1.0, 1.0])
                normal = apply(rotation_matrix(axis, degrees), [1.0, 0.0, 0.0]) if axis else [1.0, 0.0, 0.0]
                result = parts(dict(domain=domain((width,) * 3, (n,) * 3, sides=far), body=[
                    dict(body, name="b", mass=1.0, inertia=[1.0, 1.0, 1.0], position=[width / 2 + s / cells for s in shift], rotation=quaternion(axis or (1, 0, 0), degrees))]))
                yield energy(result, {"b": normal}), max(result["iterations"])

    if quick:
        return
    for kind, exact, name in (("disc", 8 / 3 * 0.5 ** 3, "disc"), ("plate", 0.579 * math.pi / 4, "square plate")):
        near, away = (next(masses(kind, 16, 0.001, width, True))[0] for width in (3.0, 6.0))
        share = near / away - 1
        for cells, thicknesses, target in ((16, (0.01, 0.001), 2.5), (32, (0.001,), 1.2)):
            for thickness in thicknesses:
                found = list(masses(kind, cells, thickness))
                yield rms_row(SHEET, f"{name}, {cells} cells a length, {thickness:g} cells thick, normal, 0, 25, 50 degrees, two places each, less the share of the box ({100 * share:+.2f} %)",
                              target, [m / exact - 1 - share for m, _ in found], max(i for _, i in found), 25)


def sealed_by_sheets(quick):
    """Walls of sheets between two bodies: what one feels of the other."""
    def across(result):
        half = len(result["matrix"]) // 2
        return max(abs(result["matrix"][i][j]) for i in range(half) for j in range(half, 2 * half)) / result["matrix"][0][0]

    for thickness in (1.0, 0.1, 0.001):
        wave = [[-1.0 + 0.05 * k, 0.06 * math.sin(1.1 * k)] for k in range(41)]
        worst, sealed = 0, set()
        for degrees in (0.0, 10.0, 37.0):
            result = parts(dict(domain=domain((1.0, 1.0), (32, 32)), body=[
                dict(name="wall", shape="sheet", points=wave, thickness=thickness / 32, position=[0.5, 0.517], rotation=degrees, motion="fixed"),
                dict(name="b", shape="ball", radius=0.08, position=[0.5, 0.2], density=2.0), dict(name="c", shape="ball", radius=0.08, position=[0.5, 0.85], density=2.0)]))
            worst = max(worst, across(result))
            sealed.add(len(result["sealed"]))
        yield Row(THIN, f"wavy sheet {thickness:g} cells thick at 0, 10, 37 degrees between two disks, sealed parts", "0 to round-off; 1", f"{worst:.1e}; {', '.join(map(str, sorted(sealed)))}", worst < 1e-9 and sealed == {1})
    if quick:
        return
    with tempfile.TemporaryDirectory() as folder:
        mesh, n = Path(folder) / "wave.obj", 16
        at = [(-1.5 + 3 * i / n, -1.5 + 3 * j / n) for j in range(n + 1) for i in range(n + 1)]
        write_obj(mesh, [(x, y, 0.05 * math.sin(5 * x) * math.cos(4 * y)) for x, y in at], [(k, k + 1, k + n + 2, k + n + 1) for k in range((n + 1) * n) if k % (n + 1) != n])
        for thickness in (1.0, 0.1, 0.001):
            for shape in (dict(shape="box", size=[3.0, 3.0, thickness / 16]), dict(shape="sheet", file=str(mesh), thickness=thickness / 16)):
                worst, sealed = 0, set()
                for axis, degrees in (((1, 0, 0), 0.0), ((1, 0.3, 0), 10.0), ((1, -1, 0.2), 30.0)):
                    result = parts(dict(domain=domain((1.0,) * 3, (16,) * 3), body=[
                        dict(shape, name="wall", position=[0.5, 0.5, 0.517], rotation=quaternion(axis, degrees), motion="fixed"),
                        dict(name="b", shape="ball", radius=0.1, position=[0.5, 0.5, 0.2], density=2.0), dict(name="c", shape="ball", radius=0.1, position=[0.5, 0.5, 0.85], density=2.0)]))
                    worst = max(worst, across(result))
                    sealed.add(len(result["sealed"]))
                yield Row(THIN, f"3D: {'box' if shape['shape'] == 'box' else 'wavy sheet'} {thickness:g} cells thick in three poses between two balls, sealed parts", "0 to round-off; 1",
                          f"{worst:.1e}; {', '.join(map(str, sorted(sealed)))}", worst < 1e-9 and sealed == {1})


def slits(quick):
    """A wall of two boxes across a closed channel of 32 cells moves: all fluid passes the slit. Inertance (2/pi) ln(1/sin(pi w / 2H))."""
    n = 32
    if quick:
        return
    exact = lambda w: 2 / math.pi * math.log(1 / math.sin(math.pi * w / (2 * n)))
    for width in (0.02, 0.1, 0.3, 1.0, 4.0):
        found, iterations = [], 0
        for middle in (16.5, 16.37, 16.0, 16.12):
            for x in (48.31, 48.0, 48.5):
                low, high = (middle - width / 2) / n, (middle + width / 2) / n
                result = parts(dict(domain=domain((3.0, 1.0), (3 * n, n)), body=[
                    dict(name="low", shape="box", size=[0.001 / n, 2.0], position=[x / n, low - 1], density=2.0),
                    dict(name="high", shape="box", size=[0.001 / n, 2.0], position=[x / n, high + 1], density=2.0)]))
                found.append(energy(result, {"low": (1.0, 0.0), "high": (1.0, 0.0)}) / exact(width) - 1)
                iterations = max(iterations, *result["iterations"])
        yield Row(SLIT, f"slit of {width:g} cells in a wall 0.001 cells thick, 12 places: inertance {exact(width):.2f}, error", "",
                  f"{100 * min(found):+.1f} … {100 * max(found):+.1f} % (at most {iterations} iterations)", True)


def holes(quick):
    """A thin wall with a round hole of radius a across a closed box of 32 cells moves: inertance 1 / 2a, less the wall's share (Fok)."""
    if quick:
        return
    n, corners = 32, 48

    def scene(folder, radius, place, degrees):
        vertices = [(0.0, r * math.cos(a), r * math.sin(a)) for r in (radius / n, None) for a in (2 * math.pi * k / corners for k in range(corners)) for r in
                    [r if r else 3 / max(abs(math.cos(a)), abs(math.sin(a)))]]
        mesh = Path(folder) / "wall.obj"
        write_obj(mesh, vertices, [(k, (k + 1) % corners, corners + (k + 1) % corners, corners + k) for k in range(corners)])
        return dict(domain=domain((2.0, 1.0, 1.0), (2 * n, n, n)), body=[
            dict(name="wall", shape="sheet", file=str(mesh), thickness=0.01 / n, mass=1.0, inertia=[1.0, 1.0, 1.0], position=[x / n for x in place], rotation=quaternion((0, 0, 1), degrees))])

    with tempfile.TemporaryDirectory() as folder:
        for radius in (0.2, 0.5, 1.5, 3.0):
            polygon = math.sqrt(math.sin(2 * math.pi / corners) / (2 * math.pi / corners)) * radius # of the same area
            xi = polygon / (n / math.sqrt(math.pi))
            exact = (1 - 1.4092 * xi + 0.33818 * xi ** 3 + 0.06793 * xi ** 5) / (2 * polygon / n)
            found, iterations = [], 0
            for place, degrees in (((32.31, 16.17, 16.4), 0.0), ((32.6, 16.5, 16.5), 0.0), ((32.43, 16.23, 16.07), 20.0)):
                result = parts(scene(folder, radius, place, degrees))
                # A tilted wall moves along the channel: every cross-section has the same flux.
                found.append(energy(result, {"wall": (1.0, 0.0, 0.0)}) / exact - 1)
                iterations = max(iterations, *result["iterations"])
            yield Row(SLIT, f"hole of {radius:g} cells a radius in a wall 0.01 cells thick, three poses: conductance 2a, error of the inertance", "≤ 35 iterations",
                      f"{', '.join(f'{100 * e:+.1f}' for e in found)} % (at most {iterations} iterations)", iterations <= 35)


def ball_over_wall(quick):
    """A ball over a wall and two balls across the same plane, which need not be one of the grid."""
    if quick:
        return
    rows = table("I3_sphere_wall.csv")
    displaced, normal, along = 4 * math.pi / 3, (0, 0, 1), (1, 0, 0)

    def over(cells, gap, shift, side=8.0):
        n = int(side * cells)
        return dict(domain=domain((side, side, side), (n, n, n)), body=[
            dict(name="ball", shape="ball", radius=1.0, position=[side / 2 + shift[0] / cells, side / 2 + shift[1] / cells, 1 + gap], density=2.0)])

    def two(cells, gap, shift, direction, side=8.0):
        n = int(side * cells)
        return dict(domain=domain((side, side, side), (n, n, n)), body=[
            dict(name=name, shape="ball", radius=1.0, position=[side / 2 + s / cells + sign * (1 + gap) * d for s, d in zip(shift, direction)], density=2.0)
            for name, sign in (("upper", 1), ("lower", -1))])

    def of_wall(result):
        return energy(result, {"ball": normal}) / displaced, energy(result, {"ball": along}) / displaced

    def of_two(result, direction):
        across = [x / math.hypot(direction[0], direction[1]) for x in (-direction[1], direction[0], 0.0)] if direction[2] != 1 else along
        return tuple(2 * opening(result, v) / displaced for v in (direction, across))

    def effect_of_box(values):
        return [(c[0] - c[1]) / (1 - (8 / 14) ** 3) for c in zip(*values)]

    shifts, directions = ((0.0, 0.0, 0.0), (0.31, 0.17, 0.23)), ((0.0, 0.0, 1.0), (1 / math.sqrt(5), 2 / math.sqrt(5), 0.0), (1 / math.sqrt(3),) * 3)
    box_wall = effect_of_box([of_wall(parts(over(6, 0.1, (0, 0), side))) for side in (8.0, 14.0)])
    box_two = effect_of_box([of_two(parts(two(6, 0.1, (0, 0, 0), directions[0], side)), directions[0]) for side in (8.0, 14.0)])
    for cells, target in ((4, 1.0), (6, 0.6), (8, 0.4)):
        for gap in (0.4, 0.1, 0.02, 1e-3, 1e-5, 1e-7):
            for kind in ("wall", "two"):
                columns = ("C_normal", "C_parallel" if kind == "wall" else "C_parallel_image_opposed")
                exact = [interpolate(rows, "gap_over_R", c, gap) for c in columns]
                box, text = (box_wall, "over a wall") if kind == "wall" else (box_two, "two balls, gap twice that,")
                found, films = [], []
                for k, shift in enumerate(shifts if kind == "wall" else (shifts[0], shifts[1], shifts[1])):
                    scene = over(cells, gap, shift) if kind == "wall" else two(cells, gap, shift, directions[k])
                    for values, result in ((found, parts(scene)), (films, harness.added_mass(scene) if gap < 0.1 else None)):
                        if result:
                            values.append([100 * ((x - b) / e - 1) for x, b, e in zip(of_wall(result) if kind == "wall" else of_two(result, directions[k]), box, exact)])
                for i, name in enumerate(("normal", "along")):
                    e, f = [x[i] for x in found], [x[i] for x in films]
                    yield Row(NEAR, f"{cells} cells a radius, {text} {gap:g} R, {name}, less what the box of 8 R adds ({100 * box[i] / exact[i]:.2f} %)"
                              + (f" (films {min(f):+.2f} … {max(f):+.2f} %)" if f else ""), f"≤ {target} %", f"{min(e):+.2f} … {max(e):+.2f} %", max(map(abs, e)) <= target)


def gaps_in_the_plane(quick):
    """Rectangles across a gap, a cylinder in a container, joints of gaps, against exact values; steps of M as corners pass the grid; uniform motion."""
    exact = {row["h"]: row for row in table("I4_rectangles_box4.csv")}
    shifts = ((0.0, 0.0), (0.31, 0.17), (-0.23, 0.41), (0.47, -0.38), (-0.11, -0.27))
    for n in (64,) if quick else (64, 128):
        for h in (0.005, 1e-5) if quick else (0.1, 0.05, 0.02, 0.01, 0.005, 1e-3, 1e-4, 1e-5):
            for name, turns, target in (("along the grid", (0, 90), 1.0 if h <= 0.05 else 3.3), ("turned by 10, 25, 45, 62 degrees", (10, 25, 45, 62), 1.0 if h <= 0.02 else 3.3)):
                opens, common, iterations = [], [], 0
                for turn in turns:
                    for shift in shifts[:2 if quick else 5]:
                        result = parts(rectangles(n, h, shift, turn))
                        up, across = rotate((0.0, 1.0), turn), rotate((1.0, 0.0), turn)
                        opens.append(100 * (opening(result, up) / exact[h]["M_opening"] - 1))
                        common += [100 * (energy(result, {"upper": d, "lower": d}) / exact[h][f"M_common_{c}"] - 1) for d, c in ((up, "y"), (across, "x"))]
                        iterations = max(iterations, *result["iterations"])
                yield Row(IN_PLANE, f"two rectangles, {n}², h = {h:g} ({h * n / 4:g} cells), {name}, {len(opens)} poses: opening", f"≤ {target:g} %",
                          f"{min(opens):+.2f} … {max(opens):+.2f} % (at most {iterations} iterations)", max(map(abs, opens)) <= target)
                if not quick:
                    yield Row(IN_PLANE, f"two rectangles, {n}², h = {h:g}, {name}: together along the normal and across", "≤ 2 %", f"{min(common):+.2f} … {max(common):+.2f} %", max(map(abs, common)) <= 2)
    # As sides and corners pass lines of the grid.
    for name, turn, way in (("along the grid", 0, (0.02, 0.013)), ("turned by 25 degrees", 25, (0.017, 0.011))):
        for h in () if quick else (0.3, 0.03, 1e-3):
            m = [opening(parts(rectangles(64, h * 4 / 64, (way[0] * k, way[1] * k), turn)), rotate((0.0, 1.0), turn)) for k in range(201)]
            jump = 100 * max(abs(b / a - 1) for a, b in zip(m, m[1:]))
            yield Row(IN_PLANE, f"two rectangles, 64², gap of {h:g} cells, {name}, {len(m)} small shifts: largest change of the opening mass", "≤ 1 %", f"{jump:.2f} %", jump <= 1)
    for n, target in ((33, 0.6), (66, 0.3)):
        for gap in (1e-2, 1e-5) if quick else (0.1, 1e-2, 1e-3, 1e-5, 1e-7):
            normal, along = [], []
            for angle in (17, 45) if quick else (0, 17, 30, 45):
                for shift in shifts[:2 if quick else 5]:
                    result, d = parts(in_container(n, gap, angle, shift)), rotate((1.0, 0.0), angle)
                    for values, direction in ((normal, d), (along, (-d[1], d[0]))):
                        values.append(100 * (energy(result, {"inner": direction}) / cylinder_exact(gap) - 1))
            yield Row(IN_PLANE, f"cylinder in a container, {n}², gap {gap:g}, {len(normal)} poses: normal; along", f"≤ {target} %",
                      f"{min(normal):+.2f} … {max(normal):+.2f}; {min(along):+.2f} … {max(along):+.2f} %", max(map(abs, normal + along)) <= target)
    worst = 0
    for turn in (0, 25, 45):
        for h in (1.0, 0.3, 1e-3):
            for shift in shifts[:2]:
                bodies = [dict(name="container", shape="ball", radius=1.6, position=[2.03, 1.97], inside_out=True, mass=4.0, inertia=2.0, force=[1.0, 0.5])]
                bodies += [{**body, "density": 1.0, "position": [x + 0.1 * (body["name"] == "upper") for x in body["position"]]} for body in rectangles(64, h * 4 / 64, shift, turn)["body"]]
                result = harness.added_mass(dict(domain=domain((4.0, 4.0), (64, 64)), solver=dict(tolerance=1e-13), gap=dict(model="parts"), body=bodies), accelerations=True)
                whole = [f / (4 + math.pi * 1.6 ** 2) for f in (1.0, 0.5)]
                worst = max(worst, max(abs(x - y) for a in result["accelerations"].values() for x, y in zip(a, whole + [0.0])) / whole[0])
    yield Row(IN_PLANE, "free container full of fluid with two neutral rectangles, gaps of 1 to 1e-3 cells, pushed: accelerations, against force over all mass", "1e-10", f"{worst:.1e}", worst < 1e-10)


def opening_of_plates(h):
    """Two square plates 1 x 1 x 0.25 in a closed box of three lengths. The first two terms: the gap, k/h, and the outlets, ln(1/h)/pi times the integral of the squared flux over the rim. The others: a graded
    finite-volume grid with edges of the plates in its planes, of up to 450000 cells in an octant, extrapolated (order 1.8), h = 0.1, 0.05, 0.02; within 0.1 %."""
    return 0.0351442 / h + 0.0894941 * math.log(1 / h) + 0.134 + 0.19 * h


def square_plates(quick):
    """The mass of opening in poses of every kind."""
    for cells, target, count in ((36, 2.5, 60), (72, 1.0, 8)):
        if quick and cells > 36:
            return
        for gap in (0.6, 1e-3) if quick else (0.6, 0.24, 0.06, 1e-2, 1e-3, 1e-4):
            places, h = random.Random(5), gap / 12
            errors, iterations = [], 0
            for k in range(4 if quick else count):
                axis, degrees = ((0, 0, 1), 30.0) if k == 0 else ([places.gauss(0, 1) for _ in range(3)], places.uniform(0, 90))
                scene, normal = plates3d(cells, h, "box", axis, degrees, [places.uniform(-0.5, 0.5) for _ in range(3)])
                result = parts(scene)
                errors.append(100 * (opening(result, normal) / opening_of_plates(h) - 1))
                iterations = max(iterations, *result["iterations"])
            yield Row(PLATES, f"{cells}³, gap of {cells * h / 3:g} cells, {len(errors)} poses: opening", f"≤ {target:g} %; ≤ 12 iterations",
                      f"{min(errors):+.2f} … {max(errors):+.2f} % (at most {iterations} iterations)", max(map(abs, errors)) <= target and iterations <= 12)
        if not quick:
            found = []
            for h in (gap / 12 for gap in (0.6, 0.24, 1e-2, 1e-4)):
                result = parts(plates3d(cells, h, "box")[0])
                found.append((100 * (opening(result, [0.0, 0.0, 1.0]) / opening_of_plates(h) - 1), max(result["iterations"])))
            yield Row(PLATES, f"{cells}³, edges and the middle of the gap in planes of the grid, gaps of {', '.join(f'{cells / 36 * g:g}' for g in (0.6, 0.24, 1e-2, 1e-4))} cells: opening (iterations)", f"≤ {target:g} %",
                      ", ".join(f"{e:+.2f} ({i})" for e, i in found) + " %", max(abs(e) for e, _ in found) <= target)


GAP_TARGETS = ((4, 2.5), (8, 1.2)) # cells a radius, %
GAPS_OVER_R = (0.25, 0.05, 1e-2, 1e-3, 2.5e-5) # over the radius: 1 to 1e-4 cells at four cells a radius


def gap_row(cells, target, case, errors, names=("opening", "along", "across"), section=CURVED):
    """`errors`: for each run those of the directions, in %."""
    text = "; ".join(f"{name} {min(e):+.2f} … {max(e):+.2f}" for name, e in zip(names, zip(*errors)))
    return Row(section, f"{cells} cells a radius: {case}", f"≤ {target} %", f"{text} %", max(abs(x) for e in errors for x in e) <= target)


def compare(values, reference):
    return [100 * (a / b - 1) for a, b in zip(values, reference)]


def single_over_floor(body, height, cells, shift, size):
    """Added mass of one body over the floor of a box, its lowest point at `height` less its own reach."""
    domain_ = domain(size, [round(cells * s) for s in size])
    return parts(dict(domain=domain_, body=[dict(body, name="b", density=2.0, position=[size[0] / 2 + shift[0] / cells, size[1] / 2 + shift[1] / cells, height])]))


def capsules_over_a_wall(quick):
    """A capsule of six radii over the floor, along it in two directions on the grid and tilted; against 12 cells a radius at the same pose."""
    if quick:
        return
    size, half = (8.0, 8.0, 4.0), 2.0

    def masses(cells, gap, spin, tilt, shift):
        body = dict(shape="capsule", radius=1.0, length=2 * half, rotation=times(quaternion((0, 0, 1), spin), quaternion((0, 1, 0), tilt)))
        result = single_over_floor(body, half * math.sin(math.radians(tilt)) + 1 + gap, cells, shift, size)
        turn = rotation_matrix((0, 0, 1), spin)
        return [energy(result, {"b": v}) for v in ((0, 0, 1), apply(turn, [1, 0, 0]), apply(turn, [0, 1, 0]))]

    for tilt in (0.0, 1.0, 5.0, 20.0):
        references = {(gap, spin): masses(12, gap, spin, tilt, (0.31, 0.17)) for gap in GAPS_OVER_R for spin in (0.0, 25.0)}
        for cells, target in GAP_TARGETS:
            errors = [compare(masses(cells, gap, spin, tilt, shift), of) for (gap, spin), of in references.items() for shift in ((0.0, 0.0), (0.31, 0.17), (0.1, 0.44))[:3 if cells == 4 else 2]]
            yield gap_row(cells, target, f"capsule of six radii over the floor, tilted by {tilt:g} degrees, at 0 and 25 degrees on the grid, gaps of 0.25 to 2.5e-5 R, against 12 cells", errors)


def eccentric(gap, a=1.0, b=2.0):
    """Added mass over density of a cylinder of radius a in a container of radius b, a length of one (bipolar series)."""
    e = b - a - gap
    d = b * b - a * a - e * e
    c = math.sqrt(d * d - 4 * e * e * a * a) / (2 * e)
    inner, outer = math.asinh(c / a), math.asinh(c / b)
    return 4 * math.pi * c * c * sum(n * math.exp(-2 * n * inner) / math.tanh(n * (inner - outer)) for n in range(1, int(60 / inner + 10)))


def cylinders_in_containers(quick):
    """A cylinder in a container twice as wide, closed by the domain's sides, or by its own flat ends in any direction: the flow is plane."""
    if quick:
        return

    def masses(cells, gap, pose, degrees, shift):
        turn, q = (rotation_matrix(*pose), quaternion(*pose)) if pose else (rotation_matrix((1, 0, 0), 0), [1.0, 0.0, 0.0, 0.0])
        length, n = (2.0, 6 * cells) if pose else (1.0, round(4.5 * cells))
        size = [n / cells] * 3 if pose else [n / cells, n / cells, length]
        along = [math.cos(math.radians(degrees)), math.sin(math.radians(degrees)), 0.0]
        normal, across = apply(turn, along), apply(turn, [-along[1], along[0], 0.0])
        centre = [s / 2 + (t / cells if pose or axis < 2 else 0.0) for axis, (s, t) in enumerate(zip(size, shift))]
        rotation = times(q, quaternion((0, 1, 0), 90.0))
        result = parts(dict(domain=domain(size, [round(s * cells) for s in size]), body=[
            dict(name="container", shape="cylinder", inside_out=True, radius=2.0, length=length if pose else 3.0, position=centre, rotation=rotation, motion="fixed"),
            dict(name="b", shape="cylinder", radius=1.0, length=3.0, position=[x + (1 - gap) * d for x, d in zip(centre, normal)], rotation=rotation, mass=1.0, inertia=[1.0, 1.0, 1.0])]))
        return [energy(result, {"b": v}) / length / eccentric(gap) for v in (normal, across)]

    shifts = ((0.0, 0.0, 0.0), (0.31, 0.17, 0.23), (0.13, 0.47, -0.2))
    for cells, target in GAP_TARGETS:
        for gaps, allowed in (((0.25, 0.05, 1e-2, 1e-3), target), ((1e-4,), 4.0 if cells == 4 else target)):
            text = "gaps of 0.25 to 1e-3 R" if len(gaps) > 1 else "a gap of 1e-4 R"
            errors = [compare(masses(cells, gap, None, degrees, shift), (1, 1)) for gap in gaps for degrees in (0.0, 15.0, 30.0, 45.0) for shift in shifts]
            yield gap_row(cells, allowed, f"cylinder in a container twice as wide, along the grid, at 0, 15, 30, 45 degrees, {text}, against the exact series", errors)
            errors = [compare(masses(cells, gap, pose, degrees, shift), (1, 1)) for gap in gaps for pose in (((1, 0, 0), 30.0), ((1, 2, -1), 40.0), ((3, 1, 2), 75.0)) for degrees in (17.0, 115.0)
                      for shift in shifts[:2]]
            yield gap_row(cells, allowed, f"the same with flat ends, in three directions on the grid, {text}", errors)


def gaps_over_shifts(quick):
    """Largest change of the added mass from one of 200 shifts to the next, of bodies near a wall or each other that move over the grid together, a cell in all."""
    if quick:
        return
    capsule = dict(shape="capsule", radius=3.0, length=8.0, rotation=times(quaternion((0, 0, 1), 25.0), quaternion((0, 1, 0), 2.0)))
    for gap in (0.3, 0.03, 1e-3):
        cases = (
            ("ball of 4 cells a radius over a wall", (24, 24, 16), lambda s: [dict(name="b", shape="ball", radius=4.0, position=[12 + s[0], 12 + s[1], 4 + gap])]),
            ("capsule of 3 cells a radius over a wall, tilted by 2 degrees", (28, 24, 14),
             lambda s: [dict(capsule, name="b", position=[14 + s[0], 12 + s[1], 3 + gap + 4 * math.sin(math.radians(2.0))])]),
            ("two cylinders of 4 cells a radius, at 20 degrees", (40, 40), lambda s: [
                dict(name=name, shape="ball", radius=4.0, position=[20 + x + sign * (4 + gap / 2) * d for x, d in zip(s, rotate((1.0, 0.0), 20.0))]) for name, sign in (("upper", 1), ("lower", -1))]))
        for name, cells, bodies in cases:
            last, largest = None, 0.0
            for k in range(201):
                shift = [k / 200, k / 400]
                result = parts(dict(domain=domain(cells, cells), body=[dict(body, density=2.0) for body in bodies(shift)]))
                m = [opening(result, rotate((1.0, 0.0), 20.0)), opening(result, rotate((0.0, 1.0), 20.0))] if len(result["bodies"]) == 2 else [result["matrix"][i][i] for i in range(3)]
                if last:
                    largest = max(largest, max(abs(x / y - 1) for x, y in zip(m, last)))
                last = m
            yield Row(SHIFTS, f"{name}, gap of {gap:g} cells", "largest change ≤ 1 %", f"{100 * largest:.3f} %", largest <= 0.01)


def uniform_motion(quick):
    """With all bodies in uniform motion the fluid in a closed box of moving walls would follow; of M the columns of one body and their reaction balance."""
    scene = rectangles(64, 0.05, (0.31, 0.17), 20)
    result = parts(scene)
    m = result["matrix"]
    asymmetry = max(abs(m[i][j] - m[j][i]) for i in range(len(m)) for j in range(len(m))) / max(m[i][i] for i in range(len(m)))
    yield Row(SUMS, "two rectangles at 20 degrees, 64²: asymmetry of M, closure", "≤ 1e-7; ≤ 1e-12", f"{asymmetry:.1e}; {result['closure']:.1e}" if "closure" in result else f"{asymmetry:.1e}",
              asymmetry < 1e-7)
    # A container full of fluid that moves as a whole: added mass of the container = the fluid's mass.
    for n in (24, 48):
        result = parts(dict(domain=domain((1.0, 1.0), (n, n)), body=[dict(name="c", shape="ball", radius=0.4, position=[0.507, 0.493], inside_out=True, mass=1.0, inertia=0.1)]))
        error = result["matrix"][0][0] / (math.pi * 0.16) - 1
        yield Row(SUMS, f"container of {0.4 * n:g} cells a radius full of fluid: added mass over the fluid's mass", "1 to round-off", f"{error:+.1e}", abs(error) < 1e-9)


def uniform_acceleration(quick):
    """A free container, full of fluid and of neutral bodies, pushed through its centre: everything moves as one."""
    capsule, box = dict(shape="capsule", radius=0.03, length=0.15, position=[0.63, 0.43], rotation=31.0), dict(shape="box", size=[0.2, 0.08], position=[0.37, 0.66], rotation=17.0)
    for name, n, inside in (
            ("three disks", 64, [dict(shape="ball", radius=0.09, position=[0.31, 0.42]), dict(shape="ball", radius=0.06, position=[0.63, 0.71]), dict(shape="ball", radius=0.031, position=[0.5, 0.22])]),
            ("capsule and box", 64, [capsule, box]),
            ("two balls", 24, [dict(shape="ball", radius=0.13, position=[0.35, 0.42, 0.5]), dict(shape="ball", radius=0.1, position=[0.64, 0.55, 0.47])]),
            ("capsule, box and cylinder", 24, [dict(shape="capsule", radius=0.06, length=0.12, position=[0.3, 0.45, 0.5], rotation=quaternion((1, 2, -1), 31.0)),
                                               dict(shape="box", size=[0.2, 0.12, 0.15], position=[0.62, 0.6, 0.42], rotation=quaternion((0, 1, 1), 17.0)),
                                               dict(shape="cylinder", radius=0.08, length=0.14, position=[0.6, 0.35, 0.6], rotation=quaternion((2, 1, 0), 50.0))])):
        if quick and n == 24:
            continue
        dimension = len(inside[0]["position"])
        container = dict(name="container", shape="ball", radius=0.4, position=[0.507, 0.493, 0.501][:dimension], inside_out=True, mass=0.2, inertia=0.1 if dimension == 2 else [0.1, 0.1, 0.1],
                         force=[1.0, 0.5, 0.3][:dimension])
        bodies = [container] + [dict(name=f"b{k}", density=1.0, **body) for k, body in enumerate(inside)]
        result = harness.added_mass(dict(domain=domain([1.0] * dimension, [n] * dimension), solver=dict(tolerance=1e-13), gap=dict(model="parts"), body=bodies), accelerations=True)
        total = 0.2 + (math.pi * 0.16 if dimension == 2 else 4 / 3 * math.pi * 0.064)
        exact = [f / total for f in container["force"]]
        error = max(max(abs(x - y) for x, y in zip(a, exact + [0.0] * 3)) for a in result["accelerations"].values()) / exact[0]
        yield Row(SUMS, f"free container, {0.4 * n:g} cells a radius, full of fluid, with neutral {name}: accelerations, against force over all mass",
                  "1e-10", f"{error:.1e}; {result['acceleration_iterations']} iterations", error < 1e-10)


def light_bodies(quick):
    """First accelerations by gravity at densities of 0.001 to 1000 of the fluid, against the dense system with the added-mass matrix."""
    places = random.Random(4)

    def shifted(n, dimension):
        return [n / 2 + places.uniform(-0.5, 0.5) for _ in range(dimension)]

    kinds = [(f"disk of {r} cells a radius", 2, 12 * r, lambda r=r: dict(shape="ball", radius=float(r), position=shifted(12 * r, 2)), math.pi * r * r, 0.5 * r * r) for r in (2, 3, 4, 8)]
    kinds += [(f"ball of {r} cells a radius", 3, 8 * r, lambda r=r: dict(shape="ball", radius=float(r), position=shifted(8 * r, 3)), 4 / 3 * math.pi * r ** 3, 0.4 * r * r) for r in (2, 4)]
    kinds += [(f"plate 16 x 0.1 cells at {a:g} degrees", 2, 64, lambda a=a: dict(shape="box", size=[16.0, 0.1], rotation=a, position=shifted(64, 2)), 1.6, (256.01) / 12) for a in (0.0, 25.0)]
    kinds += [("plate 8 x 8 x 0.1 cells", 3, 24, lambda: dict(shape="box", size=[8.0, 8.0, 0.1], position=shifted(24, 3)), 6.4, None)]
    for name, dimension, n, make, volume, gyration in kinds[:3] + kinds[6:7] if quick else kinds:
        error, iterations = 0, 0
        for density in (0.001, 0.01, 1.0, 1000.0):
            for _ in range(2 if dimension == 2 else 1):
                gravity = [0.6, -0.8, 0.3][:dimension]
                result = harness.added_mass(dict(domain=domain([float(n)] * dimension, [n] * dimension), gravity=gravity, gap=dict(model="parts"),
                                                 body=[dict(name="b", density=density, force=[0.1 * volume] * dimension, **make())]), accelerations=True)
                turns = 1 if dimension == 2 else 3
                inertia = [density * volume * gyration] * turns if gyration else [density * volume * (64 + 0.01) / 12] * 2 + [density * volume * 128 / 12]
                own = [density * volume] * dimension + inertia
                m = [[x + (own[i] if i == j else 0) for j, x in enumerate(row)] for i, row in enumerate(result["matrix"])]
                right = [[(density - 1) * volume * g + 0.1 * volume] for g in gravity] + [[0.0]] * turns
                exact = [row[0] for row in solve(m, right)]
                error = max(error, max(abs(x - y) for x, y in zip(result["accelerations"]["b"], exact)) / max(map(abs, exact)))
                iterations = max(iterations, result["acceleration_iterations"])
        yield Row(LIGHT, f"{name}, densities 0.001, 0.01, 1, 1000: first accelerations, against the added-mass matrix", "1e-6; ≤ 25 iterations", f"{error:.1e}; {iterations} iterations", error < 1e-6 and iterations <= 25)


def random_masses(quick):
    """Smallest eigenvalue of the added mass, over the displaced fluid's, in random scenes: bodies that touch, overlap, leave the domain."""
    import numpy as np    # only here: other cases need no NumPy

    import random_scene_kinds as kinds
    numbers = list(range(-24, 0)) + list(range(300, 306)) + [316, 343] if quick else range(-500, 500)
    worst, failed = (math.inf, None), []
    for number in numbers:
        with tempfile.TemporaryDirectory() as folder:
            scene, _ = kinds.make(number, folder, None)
            scene = {**{k: v for k, v in scene.items() if k != "pair"}, "gap": dict(model="parts"), "solver": dict(tolerance=1e-13)}
            file = Path(folder) / "scene.toml"
            file.write_text(harness.scene_text(scene))
            done = harness.command(["added-mass", file, "--json"], check=False)
        if done.returncode != 0:
            failed.append(f"{number}: {done.stderr.strip().splitlines()[-1][:80]}")
            continue
        m = np.array(json.loads(done.stdout)["matrix"])
        scale = 1 / np.sqrt(np.maximum(np.diag(m), 1e-9 * np.diag(m).max()))
        worst = min(worst, (float(np.linalg.eigvalsh(0.5 * scale[:, None] * (m + m.T) * scale)[0]), number))
    yield Row(LIGHT, f"{len(numbers)} random scenes: smallest eigenvalue of the added mass, its diagonal scaled to 1", "≥ -1e-12", f"{worst[0]:.1e} (scene {worst[1]}); {len(failed)} failed {'; '.join(failed[:3])}",
              worst[0] >= -1e-12 and not failed)


def solve(matrix, right):
    """Gauss with pivots; no numpy on a machine that only validates."""
    n = len(matrix)
    a = [row[:] + list(r) for row, r in zip(matrix, right)]
    for k in range(n):
        pivot = max(range(k, n), key=lambda i: abs(a[i][k]))
        a[k], a[pivot] = a[pivot], a[k]
        for i in range(k + 1, n):
            if factor := a[i][k] / a[k][k]:
                a[i] = [x - factor * y for x, y in zip(a[i], a[k])]
    for k in reversed(range(n)):
        a[k][n:] = [x / a[k][k] for x in a[k][n:]]
        for i in range(k):
            if a[i][k]:
                a[i][n:] = [x - a[i][k] * y for x, y in zip(a[i][n:], a[k][n:])]
    return [row[n:] for row in a]


def write_polygon(folder, name, corners):
    file = Path(folder) / f"{name}.txt"
    file.write_text("".join(f"{x!r} {y!r}\n" for x, y in corners))
    return str(file)


def write_mesh(folder, name, vertices, facets):
    file = Path(folder) / f"{name}.obj"
    file.write_text("".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in vertices) + "".join(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in facets))
    return str(file)


def regular(n, radius):
    return [(radius * math.cos(2 * math.pi * k / n), radius * math.sin(2 * math.pi * k / n)) for k in range(n)]


def prism(corners, height):
    """A convex polygon times a height, as triangles."""
    n = len(corners)
    vertices = [(x, y, z) for z in (-height / 2, height / 2) for x, y in corners]
    facets = [(0, k + 1, k) for k in range(1, n - 1)] + [(n, n + k, n + k + 1) for k in range(1, n - 1)]
    for k in range(n):
        j = (k + 1) % n
        facets += [(k, j, n + j), (k, n + j, n + k)]
    return vertices, facets


def over_shifts(quick):
    """Largest change of a translation's added mass from one of 200 shifts to the next; at the first and the hundredth, walls and corners lie on the grid."""
    if quick:
        return
    with tempfile.TemporaryDirectory() as folder:
        triangle = write_polygon(folder, "triangle", regular(3, 6.0))
        half_disk = write_polygon(folder, "half_disk", [(4 * math.cos(math.pi * k / 60), 4 * math.sin(math.pi * k / 60)) for k in range(61)])
        flat = [("box 8 x 4 cells along the grid", dict(shape="box", size=[8.0, 4.0]), 0), ("box 8 x 4 cells at 20 degrees", dict(shape="box", size=[8.0, 4.0]), 20),
                ("plate 16 x 0.1 cells along the grid", dict(shape="box", size=[16.0, 0.1]), 0), ("triangle of 10.4 cells a side, one side along the grid", dict(shape="mesh", file=triangle), 0),
                ("half disk of 4 cells a radius, its side along the grid", dict(shape="mesh", file=half_disk), 0)]
        solid = [("box 4 x 4 x 2 cells along the grid", dict(shape="box", size=[4.0, 4.0, 2.0])), ("plate 6 x 6 x 0.1 cells along the grid", dict(shape="box", size=[6.0, 6.0, 0.1])),
                 ("cylinder 3 cells a radius, 2 long, along the grid", dict(shape="cylinder", radius=3.0, length=2.0))]
        cases = [(2, name, {**body, "rotation": degrees}) for name, body, degrees in flat] + [(3, name, body) for name, body in solid]
        for dimension, name, body in cases:
            n, steps = (64, 200) if dimension == 2 else (16, 200)
            direction, last, largest = (1.0, 0.5, 0.5)[:dimension], None, 0.0
            for k in range(steps + 1):
                for off in (-1e-6, 1e-6) if k % 100 == 0 else (0.0,):    # across the grid's lines, and on from there
                    shift = [(k / steps + off) * d for d in direction]
                    result = parts(dict(domain=domain([n] * dimension, [n] * dimension),
                                        body=[dict(name="b", position=[n / 2 + s for s in shift], density=2.0, **body)]))
                    m = [result["matrix"][i][i] for i in range(dimension)]
                    if last:
                        largest = max(largest, max(abs(x - y) for x, y in zip(m, last)) / max(m))
                    last = m
            yield Row(SHIFTS, name, "largest change ≤ 1 %", f"{100 * largest:.2f} %", largest <= 0.01)


def sphere_mesh(levels):
    """An octahedron, each triangle in four `levels` times, vertices on the unit sphere."""
    vertices = [(1.0, 0.0, 0.0), (-1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, -1.0, 0.0), (0.0, 0.0, 1.0), (0.0, 0.0, -1.0)]
    facets = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
    for _ in range(levels):
        middle, finer = {}, []

        def between(a, b):
            if (key := (min(a, b), max(a, b))) not in middle:
                x = [p + q for p, q in zip(vertices[a], vertices[b])]
                r = math.sqrt(sum(c * c for c in x))
                middle[key] = len(vertices)
                vertices.append(tuple(c / r for c in x))
            return middle[key]
        for a, b, c in facets:
            d, e, f = between(a, b), between(b, c), between(c, a)
            finer += [(a, d, f), (d, b, e), (f, e, c), (d, e, f)]
        facets = finer
    return vertices, facets


def mesh_volume(vertices, facets):
    return sum(sum(vertices[a][i] * (vertices[b][(i + 1) % 3] * vertices[c][(i + 2) % 3] - vertices[b][(i + 2) % 3] * vertices[c][(i + 1) % 3]) for i in range(3)) for a, b, c in facets) / 6


def rotation_of(q):
    w, x, y, z = q
    return [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)], [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]


def lamb(a, b):
    """Added mass over displaced mass of a spheroid of semi-axes a, b, b along its axis and across it (Lamb, art. 114)."""
    def coefficient(square):    # a b b int_0^inf ds / ((square + s) sqrt((a² + s) (b² + s)²)), s = x/(1 - x) squared
        steps, total = 4000, 0.0
        for k in range(steps):
            x = (k + 0.5) / steps
            w = x / (1 - x)
            s = w * w
            total += 2 * w / (1 - x) ** 2 / ((square + s) * math.sqrt(a * a + s) * (b * b + s))
        return a * b * b * total / steps
    return [c / (2 - c) for c in (coefficient(a * a), coefficient(b * b))]


def ellipsoids(quick):
    """Prolate spheroids as fine meshes (32768 facets, scaled to the exact volume) between far sides, two lengths by eight widths."""
    if quick:
        return
    vertices, facets = sphere_mesh(6)
    scale = (4 / 3 * math.pi / mesh_volume(vertices, facets)) ** (1 / 3)
    all_sides = {f"{axis}_{end}": "far" for axis in "xyz" for end in ("low", "high")}
    with tempfile.TemporaryDirectory() as folder:
        for ratio in (2, 5):
            exact = lamb(ratio, 1)
            for cells, target in ((8, 2.0), (16, 0.7)):
                r = cells / 2
                file = write_mesh(folder, f"e{ratio}{cells}", [(scale * ratio * r * x, scale * r * y, scale * r * z) for x, y, z in vertices], facets)
                size = [4 * ratio * r, 16 * r, 16 * r]
                errors = ([], [])
                for shift in ((0.0, 0.0, 0.0), (0.31, 0.17, 0.43)):
                    result = parts(dict(domain=domain(size, [round(s) for s in size], sides=all_sides),
                                        body=[dict(name="b", shape="mesh", file=file, position=[s / 2 + t for s, t in zip(size, shift)], density=2.0)]))
                    displaced = 4 / 3 * math.pi * ratio * r ** 3
                    for axis in range(3):
                        errors[min(axis, 1)].append(100 * (result["matrix"][axis][axis] / displaced / exact[min(axis, 1)] - 1))
                for name, found in zip(("along", "across"), errors):
                    yield Row(MESHES, f"ellipsoid {ratio}:1:1, {cells} cells the short axis, {name}, against Lamb, two places", f"≤ {target} %", f"{min(found):+.2f} … {max(found):+.2f} %",
                              max(map(abs, found)) <= target)


def boxes_as_meshes(quick):
    """The same box as a box and as a polygon or mesh: difference of the added mass normal to its longest side."""
    with tempfile.TemporaryDirectory() as folder:
        for dimension in (2,) if quick else (2, 3):
            size = [8.0, 4.0] if dimension == 2 else [4.0, 4.0, 2.0]
            corners = [(-size[0] / 2, -size[1] / 2), (size[0] / 2, -size[1] / 2), (size[0] / 2, size[1] / 2), (-size[0] / 2, size[1] / 2)]
            file = write_polygon(folder, "box", corners) if dimension == 2 else write_mesh(folder, "box", *prism(corners, size[2]))
            n, places = (40, random.Random(4)) if dimension == 2 else (16, random.Random(4))
            worst = 0.0
            for _ in range(6):
                pose = dict(position=[n / 2 + places.uniform(-0.5, 0.5) for _ in range(dimension)],
                            rotation=places.uniform(0, 90) if dimension == 2 else dict(axis=[places.gauss(0, 1) for _ in range(3)], degrees=places.uniform(0, 90)))
                m = [parts(dict(domain=domain([n] * dimension, [n] * dimension), body=[dict(name="b", density=2.0, **pose, **shape)]))["matrix"]
                     for shape in (dict(shape="box", size=size), dict(shape="mesh", file=file))]
                worst = max(worst, *(abs(m[0][i][i] / m[1][i][i] - 1) for i in range(dimension)))
            name = "box 8 x 4 cells as a polygon against itself, six poses" if dimension == 2 else "box 4 x 4 x 2 cells as a mesh against itself, six poses"
            yield Row(MESHES, name, "≤ 1e-6", f"{worst:.1e}", worst <= 1e-6)
        if quick:
            return
        n, sides, places, worst = 20, 96, random.Random(7), 0.0
        radius = 3 * math.sqrt(2 * math.pi / sides / math.sin(2 * math.pi / sides)) # of the same volume
        vertices, facets = prism([(radius * math.cos(2 * math.pi * k / sides), radius * math.sin(2 * math.pi * k / sides)) for k in range(sides)], 3.0)
        file = write_mesh(folder, "cylinder", [(z, x, y) for x, y, z in vertices], facets)
        for _ in range(4):
            pose = dict(position=[n / 2 + places.uniform(-0.5, 0.5) for _ in range(3)], rotation=dict(axis=[places.gauss(0, 1) for _ in range(3)], degrees=places.uniform(0, 90)))
            m = [parts(dict(domain=domain([n] * 3, [n] * 3), body=[dict(name="b", density=2.0, **pose, **shape)]))["matrix"]
                 for shape in (dict(shape="cylinder", radius=3.0, length=3.0), dict(shape="mesh", file=file))]
            worst = max(worst, *(abs(m[1][i][i] / m[0][i][i] - 1) for i in range(3)))
        yield Row(MESHES, f"cylinder of 3 cells a radius and length as a prism of {sides} sides against itself, four poses", "≤ 1 %", f"{100 * worst:.2f} %", worst <= 0.01)


def crowd(quick):
    """48 balls on a shaken lattice, volume fraction 0.31, density 2: accelerations by gravity and by random forces."""
    if quick:
        return
    radius, shake, forces = 0.115, random.Random(5), random.Random(6)
    places = [[(i + 0.5) / 4 + shake.uniform(-0.008, 0.008), (j + 0.5) / 4 + shake.uniform(-0.008, 0.008), (k + 0.5) / 3 + shake.uniform(-0.04, 0.04)]
              for i in range(4) for j in range(4) for k in range(3)]
    volume = 4 / 3 * math.pi * radius ** 3
    right = [[1.0 * volume if axis == 2 else 0.0, forces.gauss(0, volume)] for _ in places for axis in range(3)]

    def accelerations(n, model="parts"):
        result = harness.added_mass(dict(domain=domain((1.0, 1.0, 1.0), (n, n, n)), gap=dict(model=model), body=[
            dict(name=f"b{k}", shape="ball", radius=radius, position=x, density=2.0) for k, x in enumerate(places)]))
        keep = [6 * b + axis for b in range(len(places)) for axis in range(3)]
        m = [[result["matrix"][i][j] + (2 * volume if i == j else 0) for j in keep] for i in keep]
        return solve(m, right), max(result["iterations"])

    reference, _ = accelerations(105)
    for n, cells, targets in ((26, 3, (1, 1.5)), (35, 4, (0.6, 0.8)), (70, 8, (0.15, 0.2))):
        found, iterations = accelerations(n)
        rms = [100 * math.sqrt(sum((x[k] - y[k]) ** 2 for x, y in zip(found, reference)) / sum(y[k] ** 2 for y in reference)) for k in (0, 1)]
        films, _ = accelerations(n, "film")
        rms_films = [100 * math.sqrt(sum((x[k] - y[k]) ** 2 for x, y in zip(films, reference)) / sum(y[k] ** 2 for y in reference)) for k in (0, 1)]
        yield Row(CROWD, f"{cells} cells a radius, against 12: gravity; random forces (films {rms_films[0]:.2f}, {rms_films[1]:.2f} %)", f"rms ≤ {targets[0]}; {targets[1]} %",
                  f"{rms[0]:.2f}; {rms[1]:.2f} % (at most {iterations} iterations)", rms[0] <= targets[0] and rms[1] <= targets[1])


def energy_derivative(quick):
    """dT/dx in closed form against central differences of T, all components of all bodies: random poses of single bodies of every kind, of needles whose D is limited, of pairs that overlap and
    of pairs with gaps of 0.05 to 0.3 cells, and of walls that face each other over gaps of 1e-3 to 0.3 cells; good: all components within 1e-5 of the largest one."""
    for dimension, kinds, all_poses in ((2, 16, 1000), (3, 18, 500)):
        poses = -(-(30 if quick else all_poses) // kinds)
        found, _ = harness.unit_figures("unit_coupling", f"EnergyDerivative.IsThatOfDifferences{dimension}D", GAPFLOW_POSES=str(poses))
        count, good, jump = int(found["poses"]), int(found["good"]), float(found["jump"])
        yield Row(FORCE, f"{dimension}D, {count} random poses: share of them within 1e-5; largest jump of T over a difference among the others", "≥ 99 %; ≤ 1e-3 of T",
                  f"{100 * good / count:.1f} %; {jump:.1e}", good >= (0.9 if quick and dimension == 3 else 0.99) * count and jump <= 1e-3)


def random_scenes_closed(quick):
    """Uniform motion in 1000 random scenes: up to six bodies of all shapes that touch, overlap with faces in common, have corners and faces in planes of the grid, parts thinner than a cell, slivers of
    facets, and reach over open, closed and periodic sides."""
    for dimension in (2, 3):
        found, _ = harness.unit_figures("unit_complex", f"RandomScenes.AreClosed{dimension}D", GAPFLOW_SCENES="300" if quick else "1000")
        yield Row(SUMS, f"{dimension}D, {found['scenes']} random scenes: largest outflow of a uniform motion from a part; scenes over 1e-10", "≤ 1e-10; 0",
                  f"{found['closure']}; {found['open']}", float(found["closure"]) <= 1e-10 and int(found["open"]) == 0)


ALL = [random_scenes_closed, energy_derivative, round_bodies, boxes, thin_plates, walls_of_any_thickness, sealed_by_sheets, sheets, bent_plate_in_space, plates_in_space, slits, holes, ball_over_wall, gaps_in_the_plane, square_plates, capsules_over_a_wall, cylinders_in_containers, gaps_over_shifts, crowd, uniform_motion, uniform_acceleration, light_bodies, random_masses,
       over_shifts, ellipsoids, boxes_as_meshes]
