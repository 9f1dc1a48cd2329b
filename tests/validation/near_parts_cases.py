"""Gaps of gap.model = "parts" that are hard on the numbers: random scenes with near contacts of all kinds of shapes, seats whose valve lifts, walls beside planes of the grid, walls that touch.

Seats: the jump of M from one lift to the next is what its local power of the lift changes, taken against the mean of the steps before and after.
"""
import math
import tempfile
from pathlib import Path

import harness
from added_mass_cases import domain, plates3d, quaternion, rotation_matrix, times
from harness import Row

NEAR_MASSES = "Parts: random scenes with near contacts"
SEATS = "Parts: seats, over the lift in steps of 0.02 cells"
PLANES = "Parts: walls beside planes of the grid"
TOUCHING = "Parts: roughness as a distance"
COUNTS = "Parts: iterations with half of the bodies light"

KNIFE = [[-0.1856478436834314, 0.6928471849421709], [0.0, 0.0], [0.1856478436834314, 0.6928471849421709]]
POPPET = [[-2, 17], [2, 17], [7, 22], [7, 24], [2, 24], [2, 29], [-2, 29], [-2, 24], [-7, 24], [-7, 22]]    # of failure F54, in mm


def random_near_masses(quick):
    """All kinds of shapes beside each other at gaps of 1e-7 to 1 cells, some that touch or overlap; then the same at 0.3 of the size, down to less than a cell."""
    for dimension in (2, 3):
        for name, size in (("ArePositive", ""), ("OfSmallBodiesArePositive", ", small")):
            scenes = {2: 200, 3: 20}[dimension] if quick else {2: 1000, 3: 300}[dimension]
            found, passed = harness.unit_figures("unit_coupling", f"NearMasses.{name}{dimension}D", GAPFLOW_SCENES=str(scenes))
            yield Row(NEAR_MASSES, f"{dimension}D{size}: eigenvalues of the added mass over its diagonal and the displaced fluid's mass", "none below -1e-10", found["masses"], passed)


def seat_boxes():
    return [dict(name=name, shape="box", size=[0.35, 0.15], position=[x, 0.425], motion="fixed") for name, x in (("left", 0.175), ("right", 0.825))]


def seats_in(folder):
    """{name: scene of cells and lift}."""
    def polygon(name, points):
        file = Path(folder) / f"{name}.txt"
        file.write_text("".join(f"{x!r} {y!r}\n" for x, y in points))
        return str(file)

    knife_file, poppet_file = polygon("knife", KNIFE), polygon("poppet", [[1e-3 * x for x in p] for p in POPPET])
    up, across = dict(y_low="open", y_high="open"), dict(x_low="open", x_high="open", y_high="open")    # the knife ends just below the top
    touching = 0.5 + math.sqrt(0.2 ** 2 - 0.15 ** 2)

    def valve(sides, others, **body):
        return lambda n, lift: dict(domain=domain((1.0, 1.0), (n, n), sides=sides), body=[*others, dict(body, name="valve", density=2.0, position=[0.5, body["position"] + lift / n])])

    def poppet(n, lift):
        seats = [dict(name=name, shape="box", size=[0.005, 0.005], position=[x, 0.0175], motion="fixed") for name, x in (("left", -0.0075), ("right", 0.0075))]
        return dict(domain=domain((0.02, 0.06), (n, 3 * n), origin=[-0.01, 0.0], sides=up), body=[*seats, dict(name="valve", shape="mesh", file=poppet_file, density=2000.0, position=[0.0, lift * 0.02 / n])])

    return {
        "ball on the corners of two boxes (F24 … F26)": valve(up, seat_boxes(), shape="ball", radius=0.2, position=touching),
        "box whose edges lie above those of two others (F27)": valve(up, seat_boxes(), shape="box", size=[0.3, 0.12], position=0.56),
        "the same, 4.8 cells wider on each side": valve(up, seat_boxes(), shape="box", size=[0.5, 0.12], position=0.56),
        "knife over a block (F28, F29)": valve(across, [dict(name="block", shape="box", size=[1.0, 0.3], position=[0.5, 0.15], motion="fixed")], shape="mesh", file=knife_file, position=0.3),
        "the same knife in a domain that its back does not leave": lambda n, lift: dict(domain=domain((1.0, 1.25), (n, 5 * n // 4), sides=across), body=[
            dict(name="block", shape="box", size=[1.0, 0.3], position=[0.5, 0.15], motion="fixed"), dict(name="valve", shape="mesh", file=knife_file, density=2.0, position=[0.5, 0.3 + lift / n])]),
        "poppet of 45 degrees over a port (F54)": poppet,
    }


def largest_jump(lifts, masses):
    """Largest, over ln M, and the lift at which it is."""
    powers = [math.log(b / a) / math.log(y / x) for x, y, a, b in zip(lifts, lifts[1:], masses, masses[1:])]
    return max((abs(powers[k] - 0.5 * (powers[k - 1] + powers[k + 1])) * math.log(lifts[k + 1] / lifts[k]), lifts[k]) for k in range(1, len(powers) - 1))


def seats(quick):
    with tempfile.TemporaryDirectory() as folder:
        for name, scene in seats_in(folder).items():
            for n in (48,) if "F54" in name else (24, 48):
                if quick:
                    continue
                lifts = [0.1 + 0.02 * k for k in range(91)]
                masses = [harness.added_mass({**scene(n, lift), "gap": dict(model="parts")})["matrix"][1][1] for lift in lifts]
                jump, at = largest_jump(lifts, masses)
                rise = max((b / a - 1, x) for a, b, x in zip(masses, masses[1:], lifts))
                yield Row(SEATS, f"{name}, {n} cells: largest jump of the mass along the lift; largest rise in a step", "≤ 5 %; ≤ 1 %",
                          f"{100 * jump:.2f} % at {at:.2f} cells; {100 * max(rise[0], 0):.2f} %" + (f" at {rise[1]:.2f}" if rise[0] > 0 else ""), jump <= 0.05 and rise[0] <= 0.01)


def walls_beside_planes(quick):
    """Two boxes, one of a hundredth of the fluid's density, the gap between them around a plane of the grid, above one, or off all."""
    for gap in (1e-1, 1e-3, 1e-5, 1e-7):
        most, first = 0, 0
        for low in (22 - gap / 2, 22.0, 22.3):
            for turned in (False, True):
                boxes = [dict(name="light", shape="box", size=[16.0, 4.0], position=[24.0, low - 2], density=0.01), dict(name="heavy", shape="box", size=[16.0, 4.0], position=[24.3, low + gap + 2], density=2.0)]
                if turned:
                    boxes = [dict(b, size=b["size"][::-1], position=b["position"][::-1]) for b in boxes]
                result = harness.added_mass(dict(domain=domain((48.0, 48.0), (48, 48)), gap=dict(model="parts"), solver=dict(tolerance=1e-8), gravity=[0.3, -1.0], body=boxes), accelerations=True)
                most, first = max(most, *result["iterations"]), max(first, result["acceleration_iterations"])
        yield Row(PLANES, f"gap of {gap:g} cells: iterations at 1e-8 of the added mass; of the first accelerations", "≤ 12; ≤ 12", f"{most}; {first}", most <= 12 and first <= 12)


def touching_wheel(quick):
    """The wheel of failure F44 touches a wall: its gap is that at the distance of the roughness."""
    def mass(distance, roughness):
        wheel = dict(name="wheel", shape="ball", radius=0.4, position=[2.0, 0.4 + distance], density=2.0)
        return harness.added_mass(dict(domain=domain((4.0, 2.0), (96, 48), sides=dict(y_high="open")), gap=dict(model="parts", roughness=roughness), body=[wheel]))["matrix"]

    for roughness in (1e-3, 1e-4, 1e-5):
        touching, apart = mass(0.0, roughness), mass(roughness, 0.0)
        error = max(abs(touching[c][c] / apart[c][c] - 1) for c in (0, 1))
        yield Row(TOUCHING, f"wheel that touches a wall, roughness {24 * roughness:g} cells: added mass against that at that distance", "≤ 1 %", f"{100 * error:.3f} %", error <= 0.01)


def iterations_of_gaps(quick):
    """Bodies of which one in two has a thousandth of the fluid's density, the gaps between them from a tenth to 1e-7 cells."""
    def pair(shape, size, density, gap, turn):
        """Along the domain's middle, the first axis of `turn` across the gap."""
        n = 24 if len(turn) == 3 else 48
        for name, sign, d in (("light", 1, 1e-3), ("heavy", -1, density)):
            yield dict(shape, name=name, density=d, position=[n / 2 + 0.13 + sign * (size + gap / 2) * row[0] for row in turn])

    def plates(n, gap, pose):
        scene, _ = plates3d(n, 3 * gap / n, "box", *pose, (0.31, 0.17, 0.23))
        scene["body"][0]["density"] = 1e-3
        return scene

    def balls(gap):
        return [dict(name=f"b{k}", shape="ball", radius=4.0, density=(1e-3, 2.0)[k % 2], position=[12.13 + x, 12.07 + y, 12.2 + z]) for k, (x, y, z) in enumerate(
            [(sx * (4 + gap / 2), sy * (4 + gap / 2), 0.0) for sx in (-1, 1) for sy in (-1, 1)])]

    flat = [[math.cos(math.radians(20)), -math.sin(math.radians(20))], [math.sin(math.radians(20)), math.cos(math.radians(20))]]
    turn = rotation_matrix((1, 2, -1), 40.0)
    square, cube = dict(domain=domain((48.0, 48.0), (48, 48))), dict(domain=domain((24.0,) * 3, (24,) * 3))
    kinds = [("two boxes at 20 degrees, 48²", 12, lambda gap: dict(square, body=list(pair(dict(shape="box", size=[4.0, 16.0], rotation=20.0), 2.0, 2.0, gap, flat)))),
             ("two disks, 48²", 25, lambda gap: dict(square, body=list(pair(dict(shape="ball", radius=6.0), 6.0, 2.0, gap, flat)))),
             ("two square plates in a skew pose, 36³", 12, lambda gap: plates(36, gap, ((1, 2, -1), 40.0))),
             ("two square plates along the grid, 36³", 12, lambda gap: plates(36, gap, ((0, 0, 1), 0.0))),
             ("four balls, 24³", 25, lambda gap: dict(cube, body=balls(gap))),
             ("two capsules crossed at a right angle, 24³", 25, lambda gap: dict(cube, body=[
                 dict(b, rotation=times(quaternion((1, 2, -1), 40.0), quaternion((1, 0, 0) if b["name"] == "light" else (0, 0, 1), 90.0))) for b in pair(dict(shape="capsule", radius=3.0, length=8.0), 3.0, 2.0, gap, turn)])),
             ("box on an edge over the floor, light, 24³", 25, lambda gap: dict(cube, body=[dict(name="light", shape="box", size=[8.0, 8.0, 4.0], density=1e-3, rotation=quaternion((0, 1, 0), -10.0),
                                                                                                  position=[12.13, 12.07, gap + 4 * math.sin(math.radians(10)) + 2 * math.cos(math.radians(10))])]))]
    for name, most, make in kinds[:2] if quick else kinds:
        counts, first = [], []
        gaps = (1e-1, 1e-3, 1e-5) if quick else (1e-1, 1e-3, 1e-5, 1e-7)    # boxes take 15 at the last one
        for gap in gaps:
            scene = make(gap)
            result = harness.added_mass({**scene, "gap": dict(model="parts"), "solver": dict(tolerance=1e-8), "gravity": [0.3, -1.0] + [0.2] * (len(scene["domain"]["cells"]) - 2)}, accelerations=True)
            counts.append(max(result["iterations"]))
            first.append(result["acceleration_iterations"])
        yield Row(COUNTS, f"{name}, gaps of {', '.join(f'{gap:g}' for gap in gaps)} cells: iterations at 1e-8 of the added mass; of the first accelerations", f"≤ {most}",
                  f"{', '.join(map(str, counts))}; {', '.join(map(str, first))}", max(counts + first) <= most)


ALL = [random_near_masses, seats, walls_beside_planes, touching_wheel, iterations_of_gaps]
