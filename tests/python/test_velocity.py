"""A velocity of the fluid at the start, for the fluid on parts: a function of points, or arrays of faces."""
import numpy as np
import pytest

import gapflow


def vortices(points):
    """Taylor-Green vortices, one wave a unit: ideal fluid keeps them as they are."""
    x, y = 2 * np.pi * points.T
    return np.stack([np.sin(x) * np.cos(y), -np.cos(x) * np.sin(y)], axis=1)


def box(cells=16, dimension=2, kind="periodic", bodies=(), max_step=0.02):
    names = [f"{axis}_{end}" for axis in "xyz"[:dimension] for end in ("low", "high")]
    domain = gapflow.Domain(size=[1.0] * dimension, cells=[cells] * dimension, sides=gapflow.Sides(**dict.fromkeys(names, kind)))
    return gapflow.Scene(domain=domain, bodies=list(bodies), time=gapflow.Time(end=0.25, max_step=max_step), gap=gapflow.Gap(model="parts"))


DISK = gapflow.Ball(name="disk", radius=0.15, position=[0.613, 0.457], density=2.0)


def on_faces(grid, velocity):
    """The component along the axis at the centres of the faces normal to it."""
    faces = []
    for axis in range(2):
        x, y = np.meshgrid(*(grid.faces(k) if k == axis else grid.centres(k) for k in range(2)), indexing="ij")
        faces.append(velocity(np.stack([x, y], axis=-1).reshape(-1, 2))[:, axis].reshape(x.shape))
    return faces


def error_of_vortices(cells, time):
    """Of the velocity at faces, root mean square, as a uniform flow carries the vortices along."""
    stream = np.array([0.5, 0.3])

    def exact(time):
        return lambda points: stream + vortices(points - time * stream)

    sim = gapflow.Simulation(box(cells, max_step=0.5 / cells), velocity=exact(0.0))
    sim.run(until=time)
    return np.sqrt(sum(np.mean((sim.face_velocity(axis) - of_axis) ** 2) for axis, of_axis in enumerate(on_faces(sim.grid, exact(time)))))


def test_vortices_are_carried_along():
    assert error_of_vortices(16, 0.0) < 1e-9
    coarse, fine = error_of_vortices(16, 0.25), error_of_vortices(32, 0.25)
    assert fine < 0.01 and np.log2(coarse / fine) > 1.8


@pytest.mark.parametrize("kind", ["periodic", "wall"])
def test_a_function_and_its_values_on_faces_give_the_same_bits(kind):
    scene = box(kind=kind, bodies=[DISK])
    function = gapflow.Simulation(scene, velocity=vortices)
    arrays = gapflow.Simulation(scene, velocity=on_faces(function.grid, vortices))
    assert [array.shape for array in on_faces(function.grid, vortices)] == [function.face_velocity(axis).shape for axis in range(2)]
    at_rest = gapflow.Simulation(scene)
    for sim in (function, arrays, at_rest):
        sim.run(until=0.1)
    assert np.array_equal(function.velocity, arrays.velocity) and np.array_equal(function.bodies["disk"].centre, arrays.bodies["disk"].centre)
    assert np.abs(function.bodies["disk"].velocity).max() > 0.01 > 1e-9 > np.abs(at_rest.bodies["disk"].velocity).max()


def test_points_and_components_are_those_of_the_axes_in_3d():
    def shear(points):
        assert points.shape == (8**3, 3)
        return np.stack([np.sin(2 * np.pi * points[:, 2]), 0.3 + 0 * points[:, 0], np.cos(2 * np.pi * points[:, 1])], axis=1)

    sim = gapflow.Simulation(box(8, 3), velocity=shear)
    x, y, z = np.meshgrid(*(sim.grid.centres(axis) for axis in range(3)), indexing="ij")
    expected = np.stack([np.sin(2 * np.pi * z), np.full_like(x, 0.3), np.cos(2 * np.pi * y)], axis=-1)
    assert np.abs(sim.velocity - expected).max() < 1e-9


def test_nothing_goes_through_walls():
    sim = gapflow.Simulation(box(kind="wall", bodies=[DISK]), velocity=lambda points: vortices(points) + [1.0, 0.5])
    for _ in range(2):
        assert sim.report.divergence_max < 1e-6
        assert all(np.abs(np.take(sim.face_velocity(axis), [0, -1], axis=axis)).max() == 0 for axis in range(2))
        sim.step()


def test_copies_and_checkpoints_have_the_vorticity(tmp_path):
    sim = gapflow.Simulation(box(bodies=[DISK]), velocity=vortices)
    sim.step()
    sim.save(tmp_path / "state.h5")
    others = [sim.copy(), gapflow.Simulation.restore(tmp_path / "state.h5")]
    for one in (sim, *others):
        one.step()
    assert all(np.array_equal(sim.velocity, other.velocity) for other in others)
    with pytest.raises(ValueError, match="either of velocity and resume"):
        gapflow.Simulation(box(bodies=[DISK]), velocity=vortices, resume=tmp_path / "state.h5")


@pytest.mark.parametrize("velocity, message", [
    (lambda points: points[:, 0], r"velocity\(points\): has the shape \(256,\); give \(256, 2\)"),
    (lambda points: np.full_like(points, np.inf), r"velocity\(points\): 512 of its values are not finite"),
    (lambda points: "fast", r"velocity\(points\): are not numbers"),
    ([np.zeros((16, 16))], "2 arrays"),
    (1.0, "2 arrays"),
    ([np.zeros((16, 16)), np.zeros((16, 17))], r"velocity\[1\]: has the shape \(16, 17\); give \(16, 16\)"),
    ([np.zeros((16, 16)), np.full((16, 16), np.nan)], r"velocity\[1\]: 256 of its values are not finite"),
])
def test_values_that_are_no_velocity_are_refused(velocity, message):
    with pytest.raises(ValueError, match=message):
        gapflow.Simulation(box(), velocity=velocity)


@pytest.mark.parametrize("changes, message", [
    ({"gap.model": "film"}, "gap.model: a velocity of the fluid at the start needs \"parts\""),
    ({"fluid.pressure_gradient": [1, 0]}, "nothing drives the mean flow"),
    ({"domain.sides.x_low": {"inflow": [1, 0]}, "domain.sides.x_high": "open"}, "domain.sides.x_low"),
])
def test_scenes_that_cannot_have_it_are_refused(changes, message):
    with pytest.raises(ValueError, match=message):
        gapflow.Simulation(box(bodies=[DISK]), set=changes, velocity=lambda points: 0 * points)


def test_an_error_of_the_function_comes_through():
    def broken(points):
        raise KeyError("missing table")

    with pytest.raises(KeyError, match="missing table"):
        gapflow.Simulation(box(), velocity=broken)
