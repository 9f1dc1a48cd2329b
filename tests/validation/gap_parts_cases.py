"""Added masses with gap.model = "parts" of bodies with flat faces and edges near walls and each other (docs/theory/gap-energy.md).

References: closed forms where the text says so; else the same model and pose on a grid three or four times finer.
"""
import math
import tempfile

from added_mass_cases import domain, energy, opening, plates3d, quaternion, rotate, rotation_matrix, times, wall_mouth
from harness import Row
from parts_cases import compare, opening_of_plates, parts, write_polygon

OVER_WALL = "Parts: box over a wall"
EDGE = "Parts: edge over a wall"
WEDGE = "Parts: wedge in a slot"
POCKET = "Parts: three bodies around a pocket"
CORNER = "Parts: box in a corner"
STEPS = "Parts: added mass of edges and plates over 60 shifts of 0.02 cells"

SHIFTS = ((0.0, 0.0, 0.0), (0.31, 0.17, 0.23), (-0.23, 0.41, -0.38))


def falling(section, case, names, numbers, errors_at):
    """Rows of the resolutions `numbers`, cells over the case's length. `errors_at`: of each run those of the directions, in %."""
    last = math.inf
    for n in numbers:
        errors = errors_at(n)
        worst = max(abs(x) for e in errors for x in e)
        text = "; ".join(f"{name} {min(e):+.2f} … {max(e):+.2f}" for name, e in zip(names, zip(*errors)))
        yield Row(section, case(n, len(errors)), "≤ 3 %" + (", falling or ≤ 1 %" if n != numbers[0] else ""), f"{text} %", worst <= min(3.0, max(last, 1.0)))
        last = worst


def moved(place, cells, shift, length=3.0):
    return [x + s * length / cells for x, s in zip(place, shift)]


def masses_of(result, directions):
    return [energy(result, {"b": d}) for d in directions]


def box_over_wall(quick):
    """A box 1 x 1 x 0.25 over the floor of a box 3 x 3 x 1.5: by its mirror image two plates across twice the gap."""
    def over_floor(n, gap, spin, shift):
        return masses_of(parts(dict(domain=domain((3.0, 3.0, 1.5), (n, n, n // 2)), body=[
            dict(name="b", shape="box", size=[1.0, 1.0, 0.25], density=2.0, rotation=quaternion((0, 0, 1), spin), position=[*moved((1.5, 1.5), n, shift), gap + 0.125])])), ((0.0, 0.0, 1.0),))

    numbers = (36,) if quick else (36, 72)
    for gap in (0.3, 1e-3) if quick else (1.2, 0.6, 0.3, 0.06, 1e-2, 1e-3):
        h, shifts = gap / 12, SHIFTS[1:] if quick else SHIFTS
        exact = [2 * opening_of_plates(2 * h)] if gap < 1 else over_floor(144, h, 0.0, SHIFTS[1])
        yield from falling(OVER_WALL, lambda n, count: f"box 1 x 1 x 0.25 over the floor, {n}³, gap of {gap * n / 36:g} cells, {count} poses, against " + ("two plates" if gap < 1 else "144 cells"), ("lift",), numbers,
                           lambda n: [compare(over_floor(n, h, spin, shift), exact) for spin in (0.0, 30.0) for shift in shifts])


def edge_over_wall(quick):
    """A box 1 x 0.5 that stands on an edge over the floor, its longer side at an angle to the floor."""
    def height(gap, tilt):
        return gap + 0.5 * math.sin(math.radians(tilt)) + 0.25 * math.cos(math.radians(tilt))

    def flat(n, gap, tilt, shift):
        return masses_of(parts(dict(domain=domain((3.0, 2.0), (n, 2 * n // 3)), body=[
            dict(name="b", shape="box", size=[1.0, 0.5], density=2.0, rotation=tilt, position=[*moved((1.5,), n, shift), height(gap, tilt)])])), ((0.0, 1.0), (1.0, 0.0)))

    fine, numbers, gaps = (288, (36,), (0.3, 1e-3)) if quick else (576, (36, 72), (1.2, 0.6, 0.3, 0.06, 1e-2, 1e-3))
    for tilt in (5.0, 20.0) if quick else (5.0, 10.0, 20.0, 30.0, 45.0):
        for gap in gaps:
            reference = flat(fine, gap / 12, tilt, SHIFTS[1])
            yield from falling(EDGE, lambda n, count: f"2D, {tilt:g} degrees, {n} cells over three lengths, gap of {gap * n / 36:g} cells, {count} places, against {fine} cells", ("lift", "slide"), numbers,
                               lambda n: [compare(flat(n, gap / 12, tilt, (k / 8 + 0.01,)), reference) for k in range(8)])


def wedge_in_slot(quick):
    """A wedge with its tip down in a slot of the same angle, which ends beyond it or before it; the wedge moves out of the slot and across it."""
    side = 0.9

    def corners(half):
        x, y = side * math.sin(math.radians(half)), side * math.cos(math.radians(half))
        return [(0.0, -y / 2), (x, y / 2), (-x, y / 2)]

    def slot(half, gap, turn, centre, more):
        """Two boxes, each along one side of the wedge, longer by `more`; below the tip they overlap."""
        a, thick, low, high = math.radians(half), 0.3, -0.6, side + more
        for name, s in (("left", -1), ("right", 1)):
            along, out = (s * math.sin(a), math.cos(a)), (s * math.cos(a), -math.sin(a))
            place = rotate([(low + high) / 2 * u + (gap + thick / 2) * v + w for u, v, w in zip(along, out, (0.0, -side * math.cos(a) / 2))], turn)
            yield name, [high - low, thick], [c + x for c, x in zip(centre, place)], turn + 90 - s * half

    def flat(folder, n, gap, half, turn, more, shift):
        centre = moved((1.5, 1.5), n, shift)
        bodies = [dict(name="b", shape="mesh", file=write_polygon(folder, "wedge", corners(half)), rotation=turn, position=centre, density=2.0)]
        bodies += [dict(name=name, shape="box", size=size, position=place, rotation=angle, motion="fixed") for name, size, place, angle in slot(half, gap, turn, centre, more)]
        return masses_of(parts(dict(domain=domain((3.0, 3.0), (n, n)), body=bodies)), [rotate(d, turn) for d in ((0.0, 1.0), (1.0, 0.0))])

    fine, numbers, turns = (288, (36,), (0.0, 25.0)) if quick else (576, (36, 72), (0.0, 25.0, 72.0))
    with tempfile.TemporaryDirectory() as folder:
        for half in (15.0,) if quick else (10.0, 15.0, 30.0):
            for more, name in ((0.1, "in the slot"), (-0.1, "out of the slot")):
                for gap in (1e-2, 1e-3) if quick else (0.6, 0.3, 0.06, 1e-2, 1e-3):
                    references = {turn: flat(folder, fine, gap / 12, half, turn, more, SHIFTS[1]) for turn in turns}
                    yield from falling(WEDGE, lambda n, count: f"2D, {2 * half:g} degrees, its end {name}, {n} cells over three lengths, gap of {gap * n / 36:g} cells, {count} poses, against {fine} cells", ("out", "across"), numbers,
                                       lambda n: [compare(flat(folder, n, gap / 12, half, turn, more, shift), of) for turn, of in references.items() for shift in SHIFTS[:2 if quick else 3]])


def three_around_a_pocket(quick):
    """Three disks, and three mitred bars, around a pocket; all move outward, or one. Disks at a gap of 1e-4 against the expansion in multipoles (added_mass_cases)."""
    def pocket(body, distance, n, turn, shift):
        centre, placed, motion = moved((2.0, 2.0), n, shift, 4.0), [], {}
        for k in range(3):
            e = motion[f"b{k}"] = rotate((1.0, 0.0), 90 + turn + 120 * k)
            placed.append(dict(body, name=f"b{k}", rotation=turn + 120.0 * k, position=[c + distance * x for c, x in zip(centre, e)], density=2.0))
        result = parts(dict(domain=domain((4.0, 4.0), (n, n)), body=placed))
        return [energy(result, motion), energy(result, {"b0": motion["b0"]})]

    def disks(gap, folder):
        return dict(shape="ball", radius=0.5), (1.0 + gap) / math.sqrt(3)

    def bars(gap, folder):
        """Sides of an equilateral triangle of the inner side 1, 0.3 thick, cut by the bisectors of its angles, moved outward until their ends are `gap` apart."""
        t = 0.3
        x = 0.5 + t * math.sqrt(3)
        return dict(shape="mesh", file=write_polygon(folder, "bar", [(-0.5, -t / 2), (0.5, -t / 2), (x, t / 2), (-x, t / 2)])), (0.5 + gap) / math.sqrt(3) + t / 2

    fine, numbers, turns = (384, (48,), (0.0, 37.0)) if quick else (768, (48, 96), (0.0, 37.0, 90.0))
    with tempfile.TemporaryDirectory() as folder:
        for name, make, gaps in (("disks of a diameter of one", disks, (0.3, 0.06, 1e-2, 1.2e-3)), ("mitred bars of one to two lengths", bars, (0.6, 0.3, 0.06, 1e-2, 1e-3))):
            for gap in gaps[1::2] if quick else gaps:
                body = make(gap / 12, folder)
                references = {turn: pocket(*body, fine, turn, SHIFTS[1]) for turn in turns}
                if make == disks and gap == 1.2e-3:
                    references = {turn: [169.86087857, of[1]] for turn, of in references.items()}
                yield from falling(POCKET, lambda n, count: f"2D, {name}, {n // 4} cells a length, gap of {gap * n / 48:g} cells, {count} poses, against {fine // 4} cells a length", ("all outward", "one"), numbers,
                                   lambda n: [compare(pocket(*body, n, turn, shift), of) for turn, of in references.items() for shift in SHIFTS[:2 if quick else 3]])


def box_in_corner(quick):
    """A box in a corner of the closed domain, as far from the floor as from the side. In thin gaps against a network of one-dimensional gaps with their mouths."""
    def network(gap, w, height):
        """Lift: the flux q0 - x along the floor, q0 down the side; both ends at the potential of the bulk."""
        r = wall_mouth(gap)
        q0 = (w * w / 2 / gap + w * r) / ((w + height) / gap + 2 * r)
        return (height * q0 ** 2 + ((w - q0) ** 3 + q0 ** 3) / 3) / gap + r * (q0 ** 2 + (w - q0) ** 2)

    def flat(n, gap, size):
        return masses_of(parts(dict(domain=domain((3.0, 3.0), (n, n)), body=[dict(name="b", shape="box", size=size, position=[gap + x / 2 for x in size], density=2.0)])), ((0.0, 1.0), (1.0, 0.0)))

    def turned(n, gap, turn, shift):
        """The corner is that of a container, a box turned on the grid."""
        centre = moved((2.0, 2.0), n, shift, 4.0)
        bodies = [dict(name="container", shape="box", size=[2.2, 2.2], inside_out=True, position=centre, rotation=turn, motion="fixed"),
                  dict(name="b", shape="box", size=[1.0, 1.0], position=[c + x for c, x in zip(centre, rotate((gap - 0.6, gap - 0.6), turn))], rotation=turn, density=2.0)]
        return masses_of(parts(dict(domain=domain((4.0, 4.0), (n, n)), body=bodies)), [rotate(d, turn) for d in ((0.0, 1.0), (1.0, 0.0))])

    sizes, numbers, gaps = ([1.0, 1.0], [1.013, 0.986], [0.972, 1.031]), (36,) if quick else (36, 72), (0.3, 1e-3) if quick else (1.2, 0.6, 0.3, 0.06, 1e-2, 1e-3)
    for gap in gaps:
        h = gap / 12
        exact = [[network(h, *size), network(h, *size[::-1])] if gap <= 1e-2 else flat(576, h, size) for size in sizes]
        yield from falling(CORNER, lambda n, count: f"2D, {n}², gap of {gap * n / 36:g} cells, {count} sizes, against " + ("a network of gaps" if gap <= 1e-2 else "576 cells"), ("lift", "side"), numbers,
                           lambda n: [compare(flat(n, h, size), of) for size, of in zip(sizes, exact)])
        if not quick:
            references = {turn: turned(768, h, turn, SHIFTS[1]) for turn in (10.0, 30.0)}
            yield from falling(CORNER, lambda n, count: f"2D, container and box turned by 10 and 30 degrees, {n // 4} cells a length, gap of {gap * n / 48:g} cells, {count} poses, against 192 cells a length", ("lift", "side"), (48, 96),
                               lambda n: [compare(turned(n, h, turn, shift), of) for turn, of in references.items() for shift in SHIFTS])


def steps_of_edges(quick):
    """Largest change of the added mass from one of 60 shifts to the next, 0.02 cells along the floor or along a skew direction."""
    if quick:
        return
    pose = ((1, 2, -1), 40.0)
    turn = rotation_matrix(*pose)

    def floor(body, gap, height):
        def make(shift):
            result = parts(dict(domain=domain((24, 24, 12), (24, 24, 12)), body=[dict(body, name="b", density=2.0, position=[12 + shift[0], 12 + shift[1], height + gap])]))
            return [result["matrix"][i][i] for i in range(3)]
        return make

    def plates(gap, pose):
        def make(shift):
            scene, normal = plates3d(36, gap / 12, "box", *pose, shift)
            result = parts(scene)
            m = result["matrix"]
            return [opening(result, normal)] + [m[i][i] for i in range(3)]
        return make

    spin, tilt = quaternion((0, 0, 1), 25.0), math.radians(10.0)
    for gap in (0.3, 0.03, 1e-3):
        for name, make in (("box 8 x 8 x 4 cells over the floor, along the grid", floor(dict(shape="box", size=[8.0, 8.0, 4.0]), gap, 2.0)),
                           ("box 8 x 8 x 4 cells over the floor, at 25 degrees on the grid", floor(dict(shape="box", size=[8.0, 8.0, 4.0], rotation=spin), gap, 2.0)),
                           ("the same on an edge, at 10 degrees to the floor", floor(dict(shape="box", size=[8.0, 8.0, 4.0], rotation=times(spin, quaternion((0, 1, 0), -10.0))), gap,
                                                                                     4 * math.sin(tilt) + 2 * math.cos(tilt))),
                           ("two square plates, 12 cells a side, along the grid", plates(gap, ((1, 0, 0), 0.0))),
                           ("two square plates, 12 cells a side, in a skew pose", plates(gap, pose))):
            last, largest = None, 0.0
            for k in range(61):
                m = make((0.02 * k, 0.012 * k, 0.008 * k))
                if last:
                    largest = max(largest, max(abs(x / y - 1) for x, y in zip(m, last)))
                last = m
            yield Row(STEPS, f"{name}, gap of {gap:g} cells", "largest change ≤ 1 %", f"{100 * largest:.2f} %", largest <= 0.01)


ALL = [box_over_wall, edge_over_wall, wedge_in_slot, three_around_a_pocket, box_in_corner, steps_of_edges]
