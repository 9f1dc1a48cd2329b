"""gapflow.plot: pictures hold what the simulation has; VTK objects have it in VTK's order."""
import numpy as np
import pytest
from conftest import ball_scene, plates_scene

import gapflow
from gapflow import plot


@pytest.fixture
def axes():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    figure, axes = plt.subplots()
    yield axes
    plt.close(figure)


def test_a_picture_in_2d_has_field_bodies_and_films(axes):
    sim = gapflow.Simulation(plates_scene())
    sim.step()
    assert plot.state(sim, "pressure", axes=axes) is axes
    shown = axes.images[0].get_array()
    fluid = np.isin(sim.kind, (1, 3)).T
    assert np.array_equal(shown.compressed(), sim.pressure.T[fluid]) and axes.images[0].get_extent() == [0, 4, 0, 4]
    outlines, films = axes.collections
    corners = {tuple(np.round(corner, 9)) for path in outlines.get_paths() for corner in path.vertices}
    x, y = sim.bodies["upper"].centre
    assert len(outlines.get_paths()) == 2 and (round(x + 0.5, 9), round(y - 0.25, 9)) in corners
    assert len(films.get_segments()) == len(sim.films.elements)


def test_a_quantity_that_there_is_not_is_refused(axes):
    sim = gapflow.Simulation(plates_scene())
    plot.state(sim, "speed", axes=axes)
    assert axes.get_title().startswith("speed")
    for draw in (plot.state, plot.field):
        with pytest.raises(ValueError, match="'swirl'.*'pressure', 'speed', 'vorticity', 'velocity_x', 'velocity_y', 'kind'"):
            draw(sim, "swirl", axes=axes)
        with pytest.raises(ValueError, match="'velocity_z'"):
            draw(sim, "velocity_z", axes=axes)
    with pytest.raises(TypeError, match="plot.*|state: axis: unknown argument; did you mean 'axes'"):
        plot.state(sim, axis=axes)


def test_vorticity_and_components_are_drawn(axes):
    sim = gapflow.Simulation(plates_scene())
    sim.run(0.02)
    fluid = np.isin(sim.kind, (1, 3)).T
    for quantity, values in (("vorticity", sim.vorticity), ("velocity_y", sim.velocity[..., 1])):
        image = plot.field(sim, quantity, axes=axes)
        assert np.array_equal(image.get_array().compressed(), values.T[fluid]) and image.get_clim()[0] == -image.get_clim()[1]
    assert np.array_equal(plot.field(sim, "kind", axes=axes).get_array(), sim.kind.T)


def test_a_picture_in_3d_is_a_slice(axes):
    sim = gapflow.Simulation(ball_scene(3, 16))
    sim.step()
    image = plot.field(sim, "speed", axes=axes, normal=0, position=1.1)
    assert np.allclose(image.get_array(), np.linalg.norm(sim.velocity[4], axis=-1).T)  # cell 4 is 1 ... 1.25
    with pytest.raises(ValueError, match="2D"):
        plot.bodies(sim, axes=axes)


@pytest.mark.parametrize("scene", [plates_scene(), ball_scene(3, 16)])
def test_vtk_objects_have_vtks_order(scene):
    pytest.importorskip("vtkmodules")
    from vtkmodules.util.numpy_support import vtk_to_numpy
    sim = gapflow.Simulation(scene)
    sim.step()
    data = plot.to_vtk(sim)
    assert list(data) == ["fields", "films", *(f"body {name}" for name in sim.bodies)]
    image = data["fields"]
    pressure, velocity = (vtk_to_numpy(image.GetCellData().GetArray(name)) for name in ("pressure", "velocity"))
    place = (12, 5) if sim.dimension == 2 else (12, 5, 3)
    cell = image.ComputeCellId([*place, 0][:3])
    bounds = np.reshape(image.GetCell(cell).GetBounds(), (3, 2))[:sim.dimension]
    assert np.allclose(bounds.mean(axis=1), [sim.grid.centres(axis)[i] for axis, i in enumerate(place)])
    assert pressure[cell] == sim.pressure[place] and np.array_equal(velocity[cell][:sim.dimension], sim.velocity[place])
    assert data["films"].GetNumberOfPoints() == len(sim.films.nodes) and data["films"].GetNumberOfCells() == len(sim.films.elements)
    for name, body in sim.bodies.items():
        low, high = np.reshape(data[f"body {name}"].GetBounds(), (3, 2))[:sim.dimension].T
        assert np.allclose((low + high) / 2, body.centre, atol=0.01) and (high - low).min() > 0.4
