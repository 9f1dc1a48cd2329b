"""Added masses with gap.model = "parts" of bodies with flat faces and edges near walls and each other in space; those in the plane are in gap_parts_cases.

References: lubrication for thin gaps between plates; else the same model and pose on a grid one and a half to three times finer.
"""
import math
import tempfile

from added_mass_cases import apply, domain, energy, opening, quaternion, rotate, rotation_matrix, times
from gap_parts_cases import SHIFTS, falling, masses_of, moved
from harness import Row
from parts_cases import compare, parts, prism, write_mesh

PLANE = "Parts: box over a plane in any pose"
EDGE = "Parts: edge over a wall in space"
WEDGE = "Parts: wedge in a slot in space"
POCKET = "Parts: three bodies around a pocket in space"
CORNER = "Parts: box in a corner in space"
TILTED = "Parts: two square plates, tilted against each other"

POSES = (((1, 2, -1), 40.0), ((3, 1, 2), 75.0), ((1, 0, 0), 20.0))
GAPS = (0.6, 0.06, 1e-3)    # cells of 36 over three lengths


def resolutions(quick):
    return (36,) if quick else (36, 72)


def box_over_plane(quick):
    """A box 1 x 1 x 0.5 over a face of a large box, both turned on the grid."""
    def masses(n, gap, pose, shift):
        turn, q = rotation_matrix(*pose), quaternion(*pose)
        centre = moved((1.5,) * 3, n, shift)
        bodies = [dict(name=name, shape="box", size=size, rotation=q, position=[c + x for c, x in zip(centre, apply(turn, (0.0, 0.0, z)))], **more) for name, size, z, more in (
            ("b", [1.0, 1.0, 0.5], gap + 0.25, dict(density=2.0)), ("wall", [8.0, 8.0, 4.0], -2.0, dict(motion="fixed")))]
        return masses_of(parts(dict(domain=domain((3.0,) * 3, (n,) * 3), body=bodies)), [apply(turn, d) for d in ((0.0, 0.0, 1.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0))])

    fine, poses = (72, POSES[:1]) if quick else (108, POSES)
    for gap in GAPS[1:2] if quick else GAPS:
        references = {pose: masses(fine, gap / 12, pose, SHIFTS[1]) for pose in poses}
        yield from falling(PLANE, lambda n, count: f"box 1 x 1 x 0.5 over a plane, {n}³, gap of {gap * n / 36:g} cells, {count} poses, against {fine} cells", ("lift", "slide", "across"), resolutions(quick),
                           lambda n: [compare(masses(n, gap / 12, pose, shift), of) for pose, of in references.items() for shift in SHIFTS[:2]])


def edge_in_space(quick):
    """A box 1 x 1 x 0.5 that stands on an edge over the floor, its longer side at an angle to the floor."""
    def masses(n, gap, tilt, spin, shift):
        turn, a = rotation_matrix((0, 0, 1), spin), math.radians(tilt)
        return masses_of(parts(dict(domain=domain((3.0, 3.0, 2.0), (n, n, 2 * n // 3)), body=[
            dict(name="b", shape="box", size=[1.0, 1.0, 0.5], density=2.0, rotation=times(quaternion((0, 0, 1), spin), quaternion((0, 1, 0), -tilt)),
                 position=[*moved((1.5, 1.5), n, shift), gap + 0.5 * math.sin(a) + 0.25 * math.cos(a)])])), ((0.0, 0.0, 1.0), apply(turn, (1.0, 0.0, 0.0)), apply(turn, (0.0, 1.0, 0.0))))

    fine, spins = (72, (25.0,)) if quick else (108, (0.0, 25.0))
    for tilt in (20.0,) if quick else (5.0, 20.0, 45.0):
        for gap in GAPS[1:2] if quick else GAPS:
            references = {spin: masses(fine, gap / 12, tilt, spin, SHIFTS[1]) for spin in spins}
            yield from falling(EDGE, lambda n, count: f"{tilt:g} degrees, {n}³, gap of {gap * n / 36:g} cells, at 0 and 25 degrees on the grid, {count} poses, against {fine} cells", ("lift", "slide", "along"), resolutions(quick),
                               lambda n: [compare(masses(n, gap / 12, tilt, spin, shift), of) for spin, of in references.items() for shift in SHIFTS[:2]])


def wedge_in_space(quick):
    """A prism, a length long, with its edge in a slot of the same angle between two boxes; it moves out of the slot, across it and along it."""
    if quick:
        return
    side = 0.9

    def masses(folder, n, gap, half, pose, shift):
        turn, q, a = rotation_matrix(*pose), quaternion(*pose), math.radians(half)
        x, y = side * math.sin(a), side * math.cos(a)
        centre, low, high, thick = moved((1.5,) * 3, n, shift), -0.6, side + 0.1, 0.3
        bodies = [dict(name="b", shape="mesh", file=write_mesh(folder, "wedge", *prism([(0.0, -y / 2), (x, y / 2), (-x, y / 2)], 1.0)), rotation=q, position=centre, density=2.0)]
        for name, s in (("left", -1), ("right", 1)):    # each along one side of the wedge; below the tip they overlap
            along, out = (s * math.sin(a), math.cos(a)), (s * math.cos(a), -math.sin(a))
            place = [(low + high) / 2 * u + (gap + thick / 2) * v + w for u, v, w in zip(along, out, (0.0, -y / 2))]
            bodies.append(dict(name=name, shape="box", size=[high - low, thick, 1.0], position=[c + p for c, p in zip(centre, apply(turn, (*place, 0.0)))],
                               rotation=times(q, quaternion((0, 0, 1), 90 - s * half)), motion="fixed"))
        return masses_of(parts(dict(domain=domain((3.0,) * 3, (n,) * 3), body=bodies)), [apply(turn, d) for d in ((0.0, 1.0, 0.0), (1.0, 0.0, 0.0), (0.0, 0.0, 1.0))])

    with tempfile.TemporaryDirectory() as folder:
        for half in (10.0, 30.0):
            for gap in GAPS:
                references = {pose: masses(folder, 108, gap / 12, half, pose, SHIFTS[1]) for pose in (((0, 0, 1), 0.0), ((1, 2, -1), 40.0))}
                yield from falling(WEDGE, lambda n, count: f"prism of {2 * half:g} degrees, a length long, {n}³, gap of {gap * n / 36:g} cells, {count} poses, against 108 cells", ("out", "across", "along"), (36, 72),
                                   lambda n: [compare(masses(folder, n, gap / 12, half, pose, shift), of) for pose, of in references.items() for shift in SHIFTS[:2]])


def pocket_in_space(quick):
    """Three balls, and three mitred bars 0.4 high, around a pocket; all move outward, or one."""
    if quick:
        return

    def masses(body, distance, n, pose, shift):
        turn, q, centre = rotation_matrix(*pose), quaternion(*pose), moved((1.5,) * 3, n, shift)
        placed, motion = [], {}
        for k in range(3):
            e = motion[f"b{k}"] = apply(turn, (*rotate((1.0, 0.0), 90 + 120 * k), 0.0))
            placed.append(dict(body, name=f"b{k}", rotation=times(q, quaternion((0, 0, 1), 120.0 * k)), position=[c + distance * x for c, x in zip(centre, e)], density=2.0))
        result = parts(dict(domain=domain((3.0,) * 3, (n,) * 3), body=placed))
        return [energy(result, motion), energy(result, {"b0": motion["b0"]})]

    def bars(folder, gap):
        """Sides of an equilateral triangle of the inner side 0.8, 0.3 thick, cut by the bisectors of its angles, moved outward until their ends are `gap` apart."""
        a, t = 0.4, 0.3
        x = a + t * math.sqrt(3)
        return dict(shape="mesh", file=write_mesh(folder, "bar", *prism([(-a, -t / 2), (a, -t / 2), (x, t / 2), (-x, t / 2)], 0.4))), (a + gap) / math.sqrt(3) + t / 2

    with tempfile.TemporaryDirectory() as folder:
        for name, make in (("balls of a diameter of one", lambda gap: (dict(shape="ball", radius=0.5), (1.0 + gap) / math.sqrt(3))), ("mitred bars 0.4 high", lambda gap: bars(folder, gap))):
            for gap in GAPS:
                body = make(gap / 12)
                references = {pose: masses(*body, 108, pose, SHIFTS[1]) for pose in (((0, 0, 1), 0.0), ((1, 2, -1), 40.0))}
                yield from falling(POCKET, lambda n, count: f"three {name}, {n}³, gap of {gap * n / 36:g} cells, {count} poses, against 108 cells", ("all outward", "one"), (36, 72),
                                   lambda n: [compare(masses(*body, n, pose, shift), of) for pose, of in references.items() for shift in SHIFTS[:2]])


def corner_in_space(quick):
    """A box 1 x 1 x 0.5 in the corner of floor and side, as far from both."""
    def masses(n, gap, size, y):
        return masses_of(parts(dict(domain=domain((3.0, 3.0, 2.0), (n, n, 2 * n // 3)), body=[
            dict(name="b", shape="box", size=size, position=[gap + size[0] / 2, y, gap + size[2] / 2], density=2.0)])), ((0.0, 0.0, 1.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)))

    sizes, fine = ([1.0, 1.0, 0.5], [1.013, 0.986, 0.507], [0.972, 1.031, 0.481]), 72 if quick else 108
    for gap in GAPS[1:2] if quick else GAPS:
        references = [(size, masses(fine, gap / 12, size, 1.5)) for size in (sizes[1:2] if quick else sizes)]
        yield from falling(CORNER, lambda n, count: f"{n}³, gap of {gap * n / 36:g} cells, {len(references)} sizes in two places, against {fine} cells", ("lift", "side", "along"), resolutions(quick),
                           lambda n: [compare(masses(n, gap / 12, size, 1.5 + shift[0] * 3 / n), of) for size, of in references for shift in SHIFTS[:2]])


def thin_and_tilted(gap, tilt):
    """Mass of opening of two square plates whose gap grows from `gap` with the tilt: a potential in the plane of the gap, the closing its source, outlets as those of parallel plates (opening_of_plates).
    Finite volumes of half of the plate, 30 and 60 to a length, extrapolated."""
    slope = math.tan(math.radians(tilt))

    def mass(n):
        d, half = 1.0 / n, n // 2
        band, size = half, n * half
        rows, right = [[0.0] * (band + 1) for _ in range(size)], [d * d] * size    # row k: its columns k .. k + band

        def outlet(h):
            return d / (d / 2 / h + (math.log(1 / h) + (0.134 + 0.19 * h) / 0.0894941) / math.pi) if h > 0 else 0.0

        for i in range(n):
            low, middle, high = (gap + slope * (i + x) * d for x in (0.0, 0.5, 1.0))
            for j in range(half):
                k = i * half + j
                rows[k][0] += outlet(middle) * (j == 0) + (outlet(low) if i == 0 else 0.0) + (outlet(high) if i == n - 1 else 0.0)
                for step, h in ((1, middle if j < half - 1 else 0.0), (half, high if i < n - 1 else 0.0)):
                    if h > 0:
                        rows[k][0] += h
                        rows[k + step][0] += h
                        rows[k][step] -= h
        total = 0.0
        for k in range(size):    # b A^-1 b of the elimination's squares
            total += right[k] ** 2 / rows[k][0]
            for m in range(1, min(band, size - 1 - k) + 1):
                if factor := rows[k][m] / rows[k][0]:
                    right[k + m] -= factor * right[k]
                    for l in range(m, min(band, size - 1 - k) + 1):
                        rows[k + m][l - m] -= factor * rows[k][l]
        return 2 * total

    coarse, fine = mass(30), mass(60)
    return fine + (fine - coarse) / 3


def plates_tilted(quick):
    """Two plates 1 x 1 x 0.25, one turned about its lower edge, which is over the other's edge: opening along the other's normal."""
    def mass(n, gap, tilt, pose, shift):
        turn, a = rotation_matrix(*pose), math.radians(tilt)
        arm = (0.5 * math.cos(a) - 0.125 * math.sin(a), 0.0, gap / 2 + 0.5 * math.sin(a) + 0.125 * math.cos(a))    # from the edge to the centre
        middle = moved((1.5,) * 3, n, shift)
        result = parts(dict(domain=domain((3.0,) * 3, (n,) * 3), body=[
            dict(name=name, shape="box", size=[1.0, 1.0, 0.25], density=2.0, rotation=times(quaternion(*pose), quaternion((0, 1, 0), own)), position=[x + r for x, r in zip(middle, apply(turn, place))])
            for name, place, own in (("upper", (arm[0] - 0.5, 0.0, arm[2]), -tilt), ("lower", (0.0, 0.0, -gap / 2 - 0.125), 0.0))]))
        iterations.append(max(result["iterations"]))
        return opening(result, apply(turn, (0.0, 0.0, 1.0)))

    places, in_plane = ((0.31, 0.17, 0.23), (-0.23, 0.41, -0.38)), ((0, 0, 1), 0.0)
    for tilt in (1.0, 20.0) if quick else (1.0, 3.0, 8.0, 20.0):
        for k, gap in enumerate((0.06,) if quick else (0.6, 0.06, 0.0)):
            iterations = []
            apart = f"edges {gap / 12:g} lengths apart" if gap else "edges that touch"
            if thin := tilt < 5:
                poses, fine, text = POSES, [thin_and_tilted(gap / 12, tilt)] * 3, "lubrication with outlets"
            else:
                poses = (POSES[k],)
                fine, text = [mass(72 if quick else 108, gap / 12, tilt, poses[0], places[0])], "72 cells" if quick else "108 cells"
            for n, target in ((36, 4.0),) if quick else ((36, 4.0), (72, 2.0)):
                iterations = []
                errors = [100 * (mass(n, gap / 12, tilt, pose, shift) / of - 1) for pose, of in zip(poses, fine) for shift in (places[:1] if thin and n == 72 else places)]
                yield Row(TILTED, f"{n}³, tilted by {tilt:g} degrees, {apart}, {len(errors)} poses, against {text}", f"≤ {target:g} %",
                          f"{min(errors):+.2f} … {max(errors):+.2f} % (at most {max(iterations)} iterations)", max(map(abs, errors)) <= target)
                if thin and not quick:
                    error = 100 * (mass(n, gap / 12, tilt, in_plane, (0.0, 0.0, 0.0)) / fine[0] - 1)
                    yield Row(TILTED, f"{n}³, the same along the grid, the edges in a plane of it", f"≤ {target:g} %", f"{error:+.2f} %", abs(error) <= target)


ALL = [box_over_plane, edge_in_space, wedge_in_space, pocket_in_space, corner_in_space, plates_tilted]
