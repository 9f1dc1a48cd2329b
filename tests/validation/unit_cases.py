"""Figures that unit tests of the library record: what no scene of the command can show."""
import harness
from harness import Row


def film_advection(quick):
    section = "Film advection in a narrow annulus (radii 0.98 and 1, inner circle 0.01 off centre)"
    for test, name, least in (("ConvectedSwirlIsFirstOrder", "swirl carried along the film without pressure, mean error of the speed", 1),
                              ("SteadySwirlKeepsItsCirculation", "steady swirl, loss of circulation in a turn", 1.8)):
        found, passed = harness.unit_figures("unit_stepping", f"FilmAdvection.{test}")
        order = round(float(found["order"]), 2)
        yield Row(section, f"{name}, 24² to 96²: order", f"≥ {least:g}", f"{order:.2f} ({found['series']})", passed and order >= least)
    found, passed = harness.unit_figures("unit_stepping", "FilmZonalFlow.KeepsItsSpinBetweenSpheres")
    yield Row("Zonal flow in the gap between two spheres (radii 0.97 and 1, 0.015 off centre along the axis)",
              "angular momentum (and energy) lost in a turn", "≤ 1 % on the finer grid, falling", found["series"].replace("^3", "³"), passed)


def momentum(quick):
    section = "Momentum of fluid, films and bodies across one projection of a random state"
    for test, name in (("BallInContainer2D", "2D, ball in a free container, linear and angular"), ("BallInContainer3D", "3D, ball in a free container, linear and angular"),
                       ("PeriodicBox2D", "2D, turned plates and a disk in a periodic box, linear"), ("PeriodicBox3D", "3D, turned plates and a ball in a periodic box, linear")):
        found, passed = harness.unit_figures("unit_coupling", f"Momentum.{test}")
        yield Row(section, name + ", both backends: change relative to the largest component", "≤ 1e-10", found["change"], passed)


def taylor_green(quick):
    section = "Viscosity: Taylor–Green vortex, whole steps of 0.4 cells, t = 0.2, viscosity 0.01 (Re 100)"
    found, passed = harness.unit_figures("unit_stepping", "Viscosity.TaylorGreenVortexDecays")
    for name, text in (("standing", "standing"), ("carried", "carried along by a stream (0.6, 0.35)")):
        order = round(float(found[f"{name}_order"]), 2)
        yield Row(section, f"{text}, root mean square of the error, 16² to 64²: order", "≥ 1.8", f"{order:.2f} ({found[name]})", passed and order >= 1.8)


def drag_of_gaps(quick):
    """The gaps' own form, the rest of the fluid without resistance. Worst of all directions on the grid."""
    section = "Parts: drag of gaps alone"
    for test, name in (("CylinderOverAWall", "cylinder over a wall"), ("CylinderInAContainer", "cylinder in a container of twice its radius"), ("BallOverAWall", "ball over a wall"),
                       ("TwoBalls", "two balls")):
        found, _ = harness.unit_figures("unit_complex", f"GapDrag.{test}")
        for key in (k for k in found if " cells, " in k):
            cells, gap = key.split(", ")
            errors = [float(x) for x in found[key].split()]
            yield Row(section, f"{name}, {cells} a radius, gap of {gap} R: normal; along; turning, against the integrals of lubrication", "≤ 3 %", "; ".join(f"{e:.2f}" for e in errors) + " %", max(errors) <= 3)
    found, passed = harness.unit_figures("unit_complex", "GapDrag.Bearing")
    yield Row(section, "bearing, clearance 0.01, 64², eccentricities to 0.999: torque; load, against Wannier", "≤ 0.5 %", f"{float(found['torque']):.2f}; {float(found['load']):.2f} %", passed)


ALL = [film_advection, momentum, taylor_green, drag_of_gaps]
