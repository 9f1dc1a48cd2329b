"""Graded grids: the scene, the places of faces and cells, pictures and VTK objects."""
import numpy as np
import pytest

import gapflow
from gapflow import plot


def sea(**keys):
    """A falling disk in a core of 2 x 2 in the middle of a box 8 wide and 6 high."""
    domain = dict(size=[8.0, 6.0], origin=[-4.0, -3.0], spacing=0.125, core={"low": [-1.0, -1.0], "high": [1.0, 1.0]}, growth=1.2) | keys
    return gapflow.Scene(gravity=[0.0, -1.0], domain=gapflow.Domain(**domain),
                         bodies=[gapflow.Ball(name="ball", radius=0.4, position=[0.1, 0.2], density=2.0)], time=gapflow.Time(end=0.1, max_step=0.02))


@pytest.fixture
def axes():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    figure, axes = plt.subplots()
    yield axes
    plt.close(figure)


def test_the_scene_takes_a_spacing_and_a_core():
    domain = gapflow.check(sea(largest=0.5))["domain"]
    assert (domain["spacing"], domain["core"], domain["growth"], domain["largest"]) == (0.125, {"low": [-1, -1], "high": [1, 1]}, 1.2, 0.5)
    assert gapflow.Simulation(gapflow.Scene(domain=gapflow.Domain(size=[2, 1], spacing=0.25), bodies=[
        gapflow.Ball(name="ball", radius=0.3, position=[1.0, 0.5], density=2.0)], time=gapflow.Time(end=1, max_step=0.1))).grid.cells == (8, 4)
    with pytest.raises(gapflow.InputError, match="give one of the two"):
        gapflow.check(sea(cells=[64, 48]))


def test_places_are_those_of_the_faces():
    sim = gapflow.Simulation(sea())
    grid = sim.grid
    for axis, half in ((0, 4.0), (1, 3.0)):
        x = grid.places[axis]
        assert len(x) == grid.cells[axis] + 1 and np.allclose(x[[0, -1]], [-half, half])
        widths = np.diff(x)
        inside = (x[:-1] > -1 - 1e-9) & (x[1:] < 1 + 1e-9)
        assert inside.sum() == 16 and np.allclose(widths[inside], 0.125) and widths[~inside].min() > 0.125
        above = widths[np.flatnonzero(inside)[-1]:]
        assert np.all(above[1:] / above[:-1] <= 1.2 + 1e-9) and above[-1] > 3 * 0.125
        assert np.allclose(grid.faces(axis), x) and np.allclose(grid.corners(axis), x)
        assert np.allclose(grid.centres(axis), 0.5 * (x[1:] + x[:-1]))
        assert sim.face_velocity(axis).shape[axis] == len(x)
    centres = np.meshgrid(*(grid.centres(axis) for axis in (0, 1)), indexing="ij")
    far_inside = np.hypot(centres[0] - 0.1, centres[1] - 0.2) < 0.4 - 0.125
    assert far_inside.any() and (sim.kind[far_inside] == 0).all() and (sim.kind[np.hypot(*centres) > 1] == 1).all()
    assert gapflow.Simulation(sea(core=None, growth=None)).grid.places is None


def test_vorticity_is_the_curl_on_wide_cells_too():
    sim = gapflow.Simulation(sea())
    sim.run(0.06)
    u, x = sim.velocity, [sim.grid.centres(axis) for axis in (0, 1)]
    curl = np.gradient(u[..., 1], x[0], axis=0) - np.gradient(u[..., 0], x[1], axis=1)
    outside = np.s_[2:8, 2:-2]    # left of the core
    assert np.abs(u[outside]).max() > 1e-5
    slopes = np.abs(np.gradient(u[..., 1], x[0], axis=0)[outside]).max()
    assert np.abs(sim.vorticity[outside] - curl[outside]).max() < 0.25 * slopes


def test_a_picture_has_cells_where_they_are(axes):
    sim = gapflow.Simulation(sea())
    sim.run(0.04)
    mesh = plot.field(sim, "pressure", axes=axes)
    corners = mesh.get_coordinates()
    for axis in (0, 1):
        assert np.allclose(corners[..., axis], sim.grid.places[axis] if axis == 0 else sim.grid.places[axis][:, None])
    fluid = np.isin(sim.kind, (1, 3)).T
    assert np.array_equal(mesh.get_array().compressed(), sim.pressure.T[fluid]) and axes.get_aspect() in (1.0, "equal")
    assert plot.state(sim, "speed", axes=axes) is axes


def test_vtk_objects_have_the_coordinates():
    pytest.importorskip("vtkmodules")
    from vtkmodules.util.numpy_support import vtk_to_numpy
    sim = gapflow.Simulation(sea())
    sim.run(0.04)
    fields = plot.to_vtk(sim)["fields"]
    assert fields.IsA("vtkRectilinearGrid")
    for values, places in ((fields.GetXCoordinates(), sim.grid.places[0]), (fields.GetYCoordinates(), sim.grid.places[1])):
        assert np.array_equal(vtk_to_numpy(values), places)
    pressure = vtk_to_numpy(fields.GetCellData().GetArray("pressure")).reshape(sim.grid.cells[::-1])
    assert np.array_equal(pressure, sim.pressure.T, equal_nan=True)
