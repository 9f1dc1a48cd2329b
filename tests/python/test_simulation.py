"""Stepping, state as arrays and how long they live, controllers, failures, files, added mass; in 2D and 3D."""
import gc
import json
import subprocess
import threading

import numpy as np
import pytest
from conftest import ball_scene, plates_scene

import gapflow


@pytest.mark.parametrize("dimension, cells", [(2, 32), (3, 16)])
def test_shapes_and_meaning_of_the_state(dimension, cells):
    sim = gapflow.Simulation(ball_scene(dimension, cells))
    assert (sim.dimension, sim.time, sim.steps, sim.end) == (dimension, 0, 0, 0.1)
    report = sim.step()
    assert report == sim.report and report.step == sim.steps == 1 and report.time == sim.time == report.dt == 0.01
    shape = (cells,) * dimension
    assert sim.grid.cells == shape == sim.grid.high and sim.grid.spacing == 4 / cells
    assert sim.velocity.shape == (*shape, dimension) and sim.pressure.shape == sim.kind.shape == shape
    ball = sim.bodies["ball"]
    assert list(sim.bodies) == ["ball"] and ball.motion == "free"
    assert ball.centre.shape == ball.velocity.shape == ball.fluid_force.shape == (dimension,)
    assert np.asarray(ball.angular_velocity).shape == (() if dimension == 2 else (3,))
    assert np.allclose(ball.rotation, np.eye(dimension))
    volume = np.pi * 0.25 if dimension == 2 else np.pi / 6
    assert ball.volume == pytest.approx(volume) and ball.mass == pytest.approx(2 * volume)

    # Cells in the ball are solid: no pressure there, and nowhere else.
    centres = np.meshgrid(*(sim.grid.centres(axis) - 2 for axis in range(dimension)), indexing="ij")
    inside = sum(x * x for x in centres) < (0.5 - sim.grid.spacing) ** 2
    assert inside.any() and (sim.kind[inside] == 0).all() and np.array_equal(np.isnan(sim.pressure), sim.kind == 0)
    # The motion balances: m dV/dt = weight + fluid force.
    assert ball.velocity[-1] * ball.mass == pytest.approx(sim.time * (ball.fluid_force[-1] - ball.mass), rel=1e-9)
    assert ball.velocity[-1] < 0 and np.abs(ball.velocity[:-1]).max() < 1e-9


@pytest.mark.parametrize("dimension, cells", [(2, 16), (3, 8)])
def test_fields_are_indexed_x_y_z(dimension, cells):
    """Water at rest around a fixed ball: p = -rho g z. Water that streams along x: velocity (1, 0, 0)."""
    still = gapflow.Simulation(ball_scene(dimension, cells, motion="fixed", density=None))
    still.step()
    for axis in range(dimension):
        rise = np.diff(still.pressure, axis=axis)
        rise = rise[np.isfinite(rise)]
        assert rise.size and np.allclose(rise, -still.grid.spacing if axis == dimension - 1 else 0, atol=1e-10)
    streaming = {"domain.sides.x_low": "periodic", "domain.sides.x_high": "periodic", "fluid.velocity": [1, 0, 0][:dimension],
                 "body.ball.radius": 0.01, "body.ball.position": [0] * dimension}
    sim = gapflow.Simulation(ball_scene(dimension, cells, motion="fixed", density=None), set=streaming)
    assert np.allclose(sim.velocity[cells // 2, cells // 2], [1, 0, 0][:dimension], atol=0.02)
    assert sim.face_velocity(0).shape[0] == cells == len(sim.grid.faces(0))


def test_films_and_gaps_are_consistent():
    sim = gapflow.Simulation(plates_scene())
    sim.run(until=0.02)
    films, gaps = sim.films, sim.gaps
    assert films.bodies in ([("upper", "lower")], [("lower", "upper")])
    n, m = len(films.nodes), len(films.elements)
    assert films.nodes.shape == (n, 2) and films.thickness.shape == films.pressure.shape == films.void_depth.shape == (n,)
    assert films.elements.shape == films.velocity.shape == films.normal.shape == (m, 2) and films.area.shape == (m,)
    assert films.elements.min() == 0 and films.elements.max() == n - 1
    lengths = np.linalg.norm(np.diff(films.nodes[films.elements], axis=1)[:, 0], axis=1)
    assert np.allclose(lengths, films.area) and np.allclose(np.linalg.norm(films.normal, axis=1), 1)
    assert len(gaps) == 1 and {gaps["body_a"][0], gaps["body_b"][0]} == {"upper", "lower"}
    gap = sim.bodies["upper"].centre[1] - sim.bodies["lower"].centre[1] - 0.5
    assert gaps["thickness"][0] == pytest.approx(gap, rel=1e-9) == films.thickness.min()
    assert gaps["opening_rate"][0] == pytest.approx(2 * sim.bodies["upper"].velocity[1], rel=1e-6)
    assert gaps["film_nodes"][0] == n and gaps["film_area"][0] == pytest.approx(films.area.sum())
    assert gaps["pressure_min"][0] == films.pressure.min() and gaps["pressure_min"][0] < 0  # suction
    empty = gapflow.Simulation(ball_scene())
    assert len(empty.gaps) == 0 and empty.gaps["thickness"].shape == (0,) and empty.films.nodes.shape == (0, 2)


def test_gaps_of_parts_have_meshes():
    sim = gapflow.Simulation(plates_scene(), set={"gap.model": "parts"})
    sim.run(until=0.02)
    films, gaps = sim.films, sim.gaps
    assert films.bodies == [("upper", "lower")] and len(gaps) == 1
    gap = sim.bodies["upper"].centre[1] - sim.bodies["lower"].centre[1] - 0.5
    assert np.allclose(films.thickness, gap, rtol=1e-4) and gaps["thickness"][0] == pytest.approx(films.thickness.min(), rel=1e-6)  # they turn a little
    lengths = np.linalg.norm(np.diff(films.nodes[films.elements], axis=1)[:, 0], axis=1)
    assert np.allclose(lengths, films.area) and films.pressure.min() < 0 and gaps["film_nodes"][0] > 0


def test_face_velocities_are_divergence_free_and_sum_to_cell_values():
    sim = gapflow.Simulation(ball_scene())
    sim.run(until=0.03)
    u, v = (sim.face_velocity(axis) for axis in range(2))
    a, b = (sim.face_fraction(axis) for axis in range(2))
    assert u.shape == (33, 32) == a.shape and v.shape == (32, 33) == b.shape
    assert np.array_equal(sim.velocity[..., 0], 0.5 * (u[1:] + u[:-1]))
    outflow = np.diff(a * u, axis=0) + np.diff(b * v, axis=1)
    far = np.ones_like(outflow, dtype=bool)
    far[10:22, 10:22] = False
    assert np.abs(outflow[far]).max() < 1e-7 < 1e-3 < np.abs(u).max()


def test_arrays_keep_their_step_and_outlive_the_simulation():
    sim = gapflow.Simulation(plates_scene())
    sim.step()
    velocity, thickness, centre, gaps = sim.velocity, sim.films.thickness, sim.bodies["upper"].centre, sim.gaps
    assert sim.velocity is velocity and sim.gaps is gaps  # no second copy in a step
    for array in (velocity, thickness, centre, gaps):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0
    before = [array.copy() for array in (velocity, thickness, centre, gaps)]
    sim.step()
    assert sim.velocity is not velocity and not np.array_equal(sim.velocity, velocity)
    assert sim.films.thickness.min() > thickness.min()
    del sim
    gc.collect()
    gapflow.Simulation(plates_scene()).step()  # would reuse freed memory
    for array, copy in zip((velocity, thickness, centre, gaps), before):
        assert np.array_equal(array, copy)


def test_views_of_faces_have_no_copy_and_forbid_steps():
    sim = gapflow.Simulation(ball_scene())
    sim.step()
    view = sim.face_velocity(1)
    assert not view.flags.owndata and not view.flags.writeable and np.shares_memory(view, sim.face_velocity(1))
    part = view[3:5, ::2]
    del view
    for forbidden in (sim.step, sim.close):
        with pytest.raises(BufferError, match="1 view"):
            forbidden()
    assert sim.steps == 1
    del part
    sim.step()
    with pytest.raises(IndexError):
        sim.face_velocity(2)

    view = sim.face_velocity(1)
    copy = view.copy()
    del sim
    gc.collect()
    gapflow.Simulation(ball_scene(force=[3.0, 5.0])).step()
    assert np.array_equal(view, copy)


def test_a_view_alive_at_the_end_of_python_does_no_harm(python, environment):
    script = "import gapflow, conftest; sim = gapflow.Simulation(conftest.ball_scene()); keep = sim.face_velocity(0); del sim"
    folder = __file__.rsplit("/", 1)[0]
    done = subprocess.run([*python, "-c", script], env=environment, cwd=folder, capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")


def test_run_lands_on_times_and_a_callback_can_stop_it():
    sim = gapflow.Simulation(ball_scene())
    assert sim.run(until=0.025).time == 0.025 == sim.time
    seen = []
    sim.run(callback=lambda s, report: seen.append((s.time, report.step)) or len(seen) == 2)
    assert len(seen) == 2 and sim.time < 0.1 and seen[-1] == (sim.time, sim.steps)
    assert sim.run() is sim.report and sim.time == 0.1
    assert sim.run().step == sim.steps  # nothing left to do
    assert sim.step().time > 0.1
    for past in (lambda: sim.step(until=0.05), lambda: sim.run(until=0.05), lambda: sim.run(until=float("nan"))):
        with pytest.raises(gapflow.InputError, match="give a later one"):
            past()
    assert sim.run(until=sim.time) is sim.report  # is there already


def test_a_run_ends_where_the_scene_asks_and_can_go_on():
    still = {"time.until_steady": 1e-3, "time.end": 5, "time.max_step": 0.01}
    sim = gapflow.Simulation(ball_scene(2, 16, motion="fixed", density=None), set=still)
    assert sim.ended_by is None
    sim.run()
    assert sim.ended_by == "time.until_steady" and sim.steps == 10
    sim.run()
    assert sim.steps == 10
    sim.run(until=0.2)
    assert sim.time == 0.2
    sim = gapflow.Simulation(ball_scene(2, 16), set={"time.end": 0.02})
    sim.run()
    assert sim.ended_by == "time.end" and sim.time == 0.02


@pytest.mark.parametrize("dimension, cells", [(2, 32), (3, 16)])
def test_a_controller_holds_a_body_still_against_gravity(dimension, cells):
    """PID with a guess of the mass only: it has to find the weight in the fluid, (density - 1) volume g, by itself."""
    sim = gapflow.Simulation(ball_scene(dimension, cells, velocity=[0.1] * dimension), set={"time.end": 4.0, "time.max_step": 0.02})
    ball, target, integral = sim.bodies["ball"], np.full(dimension, 2.0), np.zeros(dimension)

    def control(sim):
        error = target - ball.centre
        integral[:] += error * sim.report.dt
        ball.set_force(ball.mass * (24 * error + 8 * -ball.velocity + 24 * integral))

    sim.run(control=control)
    assert np.abs(ball.centre - target).max() < 2e-3 and np.abs(ball.velocity).max() < 5e-3
    weight = ball.volume * (2 - 1)
    assert ball.force[-1] == pytest.approx(weight, rel=0.02) and np.abs(ball.force[:-1]).max() < 0.02 * weight


def test_forces_and_torques_replace_the_scenes():
    sim = gapflow.Simulation(ball_scene(force=[0.0, 7.0]))
    ball = sim.bodies["ball"]
    assert ball.force.tolist() == [0, 7] and ball.torque == 0
    ball.set_force([1, 0], torque=0.5)
    assert ball.force.tolist() == [1, 0] and ball.torque == 0.5
    ball.set_force(torque=0.25)
    assert ball.force.tolist() == [1, 0] and ball.torque == 0.25
    sim.step()
    momentum = sim.time * (np.array([1, -ball.mass]) + ball.fluid_force)
    assert np.allclose(ball.mass * ball.velocity, momentum, rtol=1e-9)
    assert ball.angular_velocity * ball.inertia == pytest.approx(sim.time * (0.25 + ball.fluid_torque), rel=1e-6)
    for force, torque, text in [([1, 2, 3], 0, "force: has 3 number"), ([0, np.nan], 0, "not finite"),
                                ([0, 0], [0, 0, 1], "torque: has 3 number"), ("up", 0, "not numbers")]:
        with pytest.raises(gapflow.InputError, match=text):
            ball.set_force(force, torque)
    with pytest.raises(KeyError, match="no body is named 'bal'; there are: ball"):
        sim.bodies["bal"]


def test_a_sudden_force_shortens_the_step():
    """A gap must not change by more than time.gap_cfl of its thickness in a step, also right after the force is set."""
    sim = gapflow.Simulation(plates_scene())
    sim.run(until=0.02)
    before = sim.gaps["thickness"][0]
    sim.bodies["upper"].set_force([0, 2000.0])
    report = sim.step()
    assert report.dt < 2e-3 and sim.gaps["thickness"][0] < 1.3 * before


def test_prescribed_velocities_can_change():
    sim = gapflow.Simulation(ball_scene(motion="prescribed", velocity=[1.0, 0.0], density=None))
    ball = sim.bodies["ball"]
    sim.run(until=0.03)
    ball.set_velocity([0, -2], angular_velocity=3)
    assert ball.velocity.tolist() == [0, -2]
    sim.run(until=0.05)
    assert np.allclose(ball.centre, [2.03, 1.96], atol=1e-14) and ball.angle == pytest.approx(0.06)
    assert np.allclose(ball.velocity, [0, -2]) and np.abs(sim.velocity[..., 1]).max() > 1
    with pytest.raises(gapflow.InputError, match="force on body 'ball': its motion is not \"free\""):
        ball.set_force([0, 1])
    with pytest.raises(gapflow.InputError, match="not \"prescribed\""):
        gapflow.Simulation(ball_scene()).bodies["ball"].set_velocity([0, 1])


def lid_scene(velocity):
    """A box reaches into a closed tank; pushed further in, it leaves the fluid nowhere to go."""
    lid = gapflow.Box(name="lid", size=[6, 6], position=[2, 6], motion="prescribed", velocity=velocity)
    return gapflow.Scene(domain=gapflow.Domain(size=[4, 4], cells=[32, 32]), bodies=[lid],
                         time=gapflow.Time(end=0.1, max_step=0.01))


def test_a_failed_computation_is_a_runtime_error_with_the_commands_text(command, tmp_path):
    scene = lid_scene(velocity=[0, -1])
    file = tmp_path / "scene.toml"
    file.write_text(scene.to_toml())
    done = subprocess.run([command, "run", file, "-q", "-o", tmp_path / "command"], capture_output=True, text=True)
    assert done.returncode == 1 and "changes the volume" in done.stderr
    with pytest.raises(gapflow.ComputationError) as caught:
        gapflow.Simulation(scene).run()
    assert isinstance(caught.value, RuntimeError) and done.stderr == f"gapflow: error: {caught.value}\n"


def test_after_a_failure_there_is_no_state_but_files(tmp_path):
    sim = gapflow.Simulation(lid_scene(velocity=[0, 0]), output=tmp_path)
    lid = sim.bodies["lid"]
    sim.step()
    lid.set_velocity([0, -1])
    with pytest.raises(gapflow.ComputationError) as caught:
        sim.run()
    for read in (lambda: sim.velocity, lambda: lid.centre, sim.step):
        with pytest.raises(gapflow.ComputationError, match="no state to read: ") as again:
            read()
        assert str(caught.value) in str(again.value)
    assert sim.time == 0.01
    record = json.loads((tmp_path / "run.json").read_text())
    assert record["status"] == "failed" and record["message"] == str(caught.value)
    sim.close()


def test_added_mass_is_the_commands(command, tmp_path):
    scene = gapflow.Scene(domain=gapflow.Domain(size=[8, 8], cells=[64, 64]), fluid=gapflow.Fluid(density=1.5),
                          bodies=[gapflow.Ball(name="left", radius=1, position=[2.9, 4]),
                                  gapflow.Ball(name="right", radius=1, position=[4.91, 4])])
    file = tmp_path / "scene.toml"
    file.write_text(scene.to_toml())
    printed = json.loads(subprocess.run([command, "added-mass", file, "--json"], capture_output=True, check=True).stdout)
    mass = gapflow.added_mass(scene)
    assert mass.labels == printed["labels"] and mass.bodies == ["left", "right"] and mass.film_nodes == printed["film_nodes"] > 0
    assert np.allclose(mass.matrix, printed["matrix"], rtol=1e-12, atol=1e-12)
    assert mass["right.vx", "left.vx"] == mass.matrix[3, 0]


@pytest.mark.parametrize("model", ["film", "parts"])
def test_first_acceleration_is_that_of_the_added_mass(model):
    ball = {"name": "b", "shape": "ball", "radius": 0.2, "position": [0.5, 0.5], "density": 0.25}
    scene = {"domain": {"size": [1, 1], "cells": [32, 32]}, "gravity": [0, -1], "gap": {"model": model}, "body": [ball]}
    volume = np.pi * 0.04
    mass = gapflow.added_mass(scene)["b.vy", "b.vy"]
    a = gapflow.first_accelerations(scene)["b"]
    assert a[1] == pytest.approx(0.75 * volume / (0.25 * volume + mass), rel=1e-6)
    assert abs(a[0]) < 1e-6 and a.shape == (3,)


def test_added_mass_of_one_cylinder():
    """rho pi R^2, and a few percent for the walls and the grid."""
    cylinder = gapflow.Ball(name="cylinder", radius=0.5, position=[4, 4])
    mass = gapflow.added_mass({"domain": {"size": [8, 8], "cells": [128, 128]}, "fluid": {"density": 1.5}, "body": [cylinder]})
    assert mass.matrix.shape == (3, 3) and np.allclose(mass.matrix, mass.matrix.T, atol=1e-9)
    for label in ("cylinder.vx", "cylinder.vy"):
        assert mass[label, label] == pytest.approx(1.5 * np.pi / 4, rel=0.05)
    assert abs(mass["cylinder.omega", "cylinder.omega"]) < 1e-9


def test_files_are_those_of_the_command(command, tmp_path):
    scene = plates_scene()
    file = tmp_path / "scene.toml"
    file.write_text(scene.to_toml())
    words = ["--set", "output.every=0.02"]
    subprocess.run([command, "run", file, "-q", "-o", tmp_path / "command", *words], check=True)
    with gapflow.Simulation(scene, output=tmp_path / "python", set={"output.every": 0.02}) as sim:
        sim.run()
    names = [sorted(str(path.relative_to(tmp_path / who)) for path in (tmp_path / who).rglob("*")) for who in ("command", "python")]
    assert names[0] == names[1] and "fields/fields_00003.vti" in names[0]
    for name in ("bodies.csv", "gaps.csv", "films/films_00002.vtp", "gapflow.pvd"):
        assert (tmp_path / "command" / name).read_text() == (tmp_path / "python" / name).read_text()
    assert json.loads((tmp_path / "python/run.json").read_text())["status"] == "done"
    with pytest.raises(RuntimeError, match="closed"):
        sim.step()
    with gapflow.Simulation(scene, output=tmp_path / "short") as sim:
        sim.step()
    assert json.loads((tmp_path / "short/run.json").read_text())["status"] == "interrupted"


@pytest.mark.parametrize("way", ["closed", "due", "asked for"])
def test_a_run_goes_on_from_a_checkpoint_bit_for_bit(tmp_path, way):
    """Steered bodies included: a force that was set, a prescribed velocity that was set."""
    def scene():
        scene = ball_scene(2, 24)
        scene.bodies.append(gapflow.Ball(name="driven", radius=0.4, position=[1.0, 1.0], motion="prescribed", velocity=[0.1, 0.0]))
        scene.output = gapflow.Output(checkpoint_every=0.04 if way == "due" else 0.0)
        return scene

    def start(output, resume=None):
        return gapflow.Simulation(scene(), output=output, resume=resume)

    def steered(sim):
        sim.step()
        sim.bodies["ball"].set_force([0.3, 2.0], 0.1)
        sim.bodies["driven"].set_velocity([0.0, 0.2], -0.5)
        sim.run(0.05)

    with start(tmp_path / "whole") as whole:
        steered(whole)
        whole.run()
        expected = whole.body_table, whole.report
    parts, stored = tmp_path / "parts", tmp_path / "parts" / "checkpoint.h5"
    with start(parts) as first:
        steered(first)
        if way == "asked for":
            stored = tmp_path / "mine.h5"
            first.write_checkpoint(stored)
            first.step()
    with start(parts, resume=stored) as second:
        assert second.steps == 5 if way != "due" else second.steps in (4, 5)
        assert second.bodies["driven"].velocity[1] == pytest.approx(0.2) and second.bodies["ball"].force[1] == 2.0
        second.run()
        for name, values in expected[0].items():
            assert np.array_equal(second.body_table[name], values), name
        assert (second.report.step, second.report.time, second.report.energy_fluid) == \
            (expected[1].step, expected[1].time, expected[1].energy_fluid)
    for name in ("bodies.csv", "gaps.csv", "gapflow.pvd"):
        assert (parts / name).read_text() == (tmp_path / "whole" / name).read_text()


def test_a_checkpoint_needs_a_place_and_the_same_scene(tmp_path):
    sim = gapflow.Simulation(ball_scene(2, 16))
    with pytest.raises(gapflow.InputError, match="give a file"):
        sim.write_checkpoint()
    sim.write_checkpoint(tmp_path / "a.h5")
    with pytest.raises(gapflow.InputError, match="cells"):
        gapflow.Simulation(ball_scene(2, 24), resume=tmp_path / "a.h5")
    assert gapflow.Simulation(ball_scene(2, 16), resume=tmp_path / "a.h5").time == 0


def state_of(sim):
    return [sim.velocity, sim.pressure, sim.films.pressure, *sim.body_table.values(), *(sim.report.__getattribute__(k) for k in ("step", "time", "energy_fluid"))]


def same(a, b):
    return all(np.array_equal(x, y, equal_nan=True) for x, y in zip(state_of(a), state_of(b), strict=True))


@pytest.mark.parametrize("scene", [plates_scene(), ball_scene(3, 12)])
def test_a_copy_goes_on_with_the_same_bits_and_alone(scene):
    sim = gapflow.Simulation(scene)
    sim.run(0.02)
    copy = sim.copy()
    assert same(sim, copy) and copy.bodies is not sim.bodies
    before = [np.copy(x) for x in state_of(sim)]
    copy.run(0.05)
    assert all(np.array_equal(x, y, equal_nan=True) for x, y in zip(before, state_of(sim))), "the original has not moved"
    sim.run(0.05)
    assert same(sim, copy)
    # three forces from one state
    body = next(iter(sim.bodies))
    ends = []
    for push in (0, 1, 0):
        trial = sim.copy()
        trial.bodies[body].force = [push] + [0.0] * (sim.dimension - 1)
        trial.step()
        ends.append(trial.bodies[body].velocity[0])
    assert ends[0] == ends[2] and ends[1] > ends[0]


def test_a_saved_state_is_restored_with_the_same_bits(tmp_path, command):
    scene = ball_scene(2, 24)
    scene.bodies.append(gapflow.Box(name="tilted", size=[0.5, 0.3], position=[1, 1], rotation=30, density=1.5,
                                    spring=gapflow.Spring(anchor=[1, 1], stiffness=2)))
    sim = gapflow.Simulation(scene)
    sim.run(0.03)
    sim.bodies["ball"].set_force([0.2, 0.1])
    sim.save(tmp_path / "state.h5")
    back = gapflow.Simulation.restore(tmp_path / "state.h5")
    assert (back.time, back.steps) == (sim.time, sim.steps) and back.bodies["ball"].force[0] == 0.2
    sim.run()
    back.run()
    assert same(sim, back)
    # a checkpoint of the command, and one that the command goes on from
    toml = tmp_path / "scene.toml"
    toml.write_text(scene.to_toml())
    subprocess.run([command, "run", toml, "-o", tmp_path / "half", "--quiet", "--set", "time.end=0.05"], check=True)
    mine = gapflow.Simulation.restore(tmp_path / "half/checkpoint.h5", set={"time.end": 0.1})
    mine.run()
    subprocess.run([command, "run", toml, "-o", tmp_path / "half", "--quiet", "--resume", tmp_path / "half/checkpoint.h5"], check=True)
    last = (tmp_path / "half/bodies.csv").read_text().splitlines()[-2].split(",")
    assert float(last[4]) == mine.bodies["ball"].centre[1]
    with pytest.raises(gapflow.InputError, match="no such file"):
        gapflow.Simulation.restore(tmp_path / "nowhere.h5")


def test_scenes_of_checkpoints_are_built_again_exactly(tmp_path):
    """Roughness of both kinds, of bodies that start in touch too, quaternions, tables, pairs, normals that are brought to unit length."""
    (tmp_path / "in.csv").write_text("time,u,v,w\n0,0,0,0\n1,1,0,0\n")
    scenes = [plates_scene(), ball_scene(3, 12, rotation={"axis": [1, 2, 3], "degrees": 33}),
              gapflow.Scene(domain=gapflow.Domain(size=[2, 2, 2], cells=[12] * 3, sides={"x_low": {"inflow": str(tmp_path / "in.csv")}, "x_high": "open"}),
                            fluid=gapflow.Fluid(viscosity=0.1), gap=gapflow.Gap(roughness=1e-3), contact=gapflow.Contact(friction=0.3),
                            pairs=[gapflow.Pair(bodies=("b", "wall:z_low"), roughness=2e-3, contact="dry")],
                            bodies=[gapflow.Capsule(name="b", radius=0.3, length=0.4, position=[1, 1, 1], rotation=[0.5, 0.5, 0.1, 0.2], density=2)],
                            time=gapflow.Time(end=0.1, max_step=0.01))]
    scenes.append(ball_scene(2, 32, position=[2.0, 0.5]))
    scenes[-1].fluxes.append({"name": "slanted", "plane": {"point": [2, 2], "normal": [1, 2]}})
    for scene in scenes:
        sim = gapflow.Simulation(scene)
        sim.save(tmp_path / "a.h5")
        back = gapflow.Simulation.restore(tmp_path / "a.h5")
        assert back.resolved_scene == sim.resolved_scene
        sim.run(0.02)
        back.run(0.02)
        assert same(sim, back)


def test_gravity_springs_viscosity_and_inflow_change_in_a_loop():
    scene = gapflow.Scene(
        gravity=[0, -1], domain=gapflow.Domain(size=[4, 4], cells=[32, 32], sides=gapflow.Sides(x_low={"inflow": [0.5, 0]}, x_high="open")),
        fluid=gapflow.Fluid(viscosity=0.05), bodies=[gapflow.Ball(name="ball", radius=0.4, position=[2, 2], density=2)],
        time=gapflow.Time(end=0.2, max_step=0.01))
    sim = gapflow.Simulation(scene)
    sim.run(0.05)
    ball = sim.bodies["ball"]
    # what changes nothing changes no bit
    other = sim.copy()
    other.gravity, other.viscosity = [0, -1], 0.05
    for each in (sim, other):
        each.run(0.08)
    assert same(sim, other)
    falls = sim.bodies["ball"].velocity[1]
    sim.gravity = np.array([0.0, 3.0])
    assert sim.gravity.tolist() == [0, 3] and sim.resolved_scene["gravity"] == [0, 3]
    sim.run(0.12)
    other.run(0.12)
    assert ball.velocity[1] > falls > other.bodies["ball"].velocity[1]
    sim.sides["x_low"] = {"inflow": [1.5, 0]}
    sim.step()
    assert np.allclose(sim.face_velocity(0)[0], 1.5) and sim.sides["x_low"] == {"inflow": [1.5, 0]}
    assert sim.report.divergence_max < 1e-5
    assert ball.spring is None
    ball.spring = gapflow.Spring(anchor=[2, 2], stiffness=1e4, damping=200)
    sim.run(0.2)
    assert ball.spring.stiffness == 1e4 and np.linalg.norm(ball.position - 2) < 0.02
    ball.spring = None
    assert sim.bodies["ball"].spring is None or sim.bodies["ball"].spring.stiffness == 0
    sim.viscosity = 5.0
    sim.step()
    thick = sim.report.dissipation_grid
    other.step()
    assert thick > 5 * other.report.dissipation_grid


def test_changes_that_cannot_be_are_refused_with_the_reason(tmp_path):
    sim = gapflow.Simulation(ball_scene(2, 16))
    ball = sim.bodies["ball"]
    for change, text in [
        (lambda: setattr(sim, "gravity", [1]), "gravity"), (lambda: setattr(sim, "gravity", "down"), "gravity"),
        (lambda: setattr(sim, "viscosity", 0.1), "fluid.viscosity = 0.1: cannot be switched on during a run"),
        (lambda: setattr(sim, "viscosity", -1), "fluid.viscosity"),
        (lambda: sim.sides.__setitem__("x_low", "open"), "domain.sides.x_low: a side stays"),
        (lambda: sim.sides.__setitem__("x_low", {"inflow": [1, 0]}), "no side lets it out"),
        (lambda: sim.sides.__setitem__("x_lo", "wall"), "did you mean"),
        (lambda: sim.change({"domain.cells": [8, 8]}), "domain.cells: does not change during a run"),
        (lambda: sim.change({"fluid.viscosty": 1}), "did you mean 'fluid.viscosity'"),
        (lambda: setattr(ball, "spring", {"stiffness": 1}), "anchor"),
        (lambda: setattr(ball, "spring", {"anchor": [1, 1], "stifness": 1}), "did you mean"),
        (lambda: setattr(ball, "force", [1]), "give 2"), (lambda: setattr(ball, "velocity", [1, 0]), "not \"prescribed\""),
    ]:
        with pytest.raises(gapflow.InputError, match=text.replace("[", r"\[")):
            change()
    assert sim.gravity.tolist() == [0, -1] and sim.step().step == 1
    for owner, name, near in [(sim, "gravty", "gravity"), (ball, "forc", "force"), (sim, "viscosty", "viscosity")]:
        with pytest.raises(AttributeError, match=f"{name}: unknown attribute; did you mean '{near}'"):
            setattr(owner, name, 1)
    for owner, name in [(sim, "time"), (sim, "bodies"), (ball, "centre"), (ball, "mass")]:
        with pytest.raises(AttributeError):
            setattr(owner, name, 1)
    view = sim.face_velocity(0)
    sim.gravity = [0, -2]
    with pytest.raises(BufferError):
        sim.step()
    del view
    sim.step()


@pytest.mark.parametrize("dimension", [2, 3])
def test_vorticity_of_a_body_turning_flow(dimension):
    """A box of fluid that a moving lid shears: vorticity is the curl of the velocity, and of the lid's sign beside it."""
    size, cells = [1.0] * dimension, [16] * dimension
    scene = gapflow.Scene(domain=gapflow.Domain(size=size, cells=cells, sides={"y_high": {"wall": [1.0, 0.0, 0.0][:dimension]}}),
                          fluid=gapflow.Fluid(viscosity=0.1), time=gapflow.Time(end=0.1, max_step=0.02))
    sim = gapflow.Simulation(scene)
    sim.run()
    u = sim.velocity
    curl = np.gradient(u[..., 1], sim.grid.spacing, axis=0) - np.gradient(u[..., 0], sim.grid.spacing, axis=1)
    z = sim.vorticity if dimension == 2 else sim.vorticity[..., 2]
    assert sim.vorticity.shape == (*cells, 3)[:4 if dimension == 3 else 2] and np.allclose(z[1:-1, 1:-1], curl[1:-1, 1:-1])
    assert z[8, -1].max() < -2  # -du/dy: the ghost beyond the lid holds its speed
    if dimension == 3:
        other = np.gradient(u[..., 0], sim.grid.spacing, axis=2) - np.gradient(u[..., 2], sim.grid.spacing, axis=0)
        assert np.allclose(sim.vorticity[1:-1, :, 1:-1, 1], other[1:-1, :, 1:-1])


def test_other_threads_run_during_long_calls():
    sim = gapflow.Simulation(ball_scene(3, 48))
    ticks, done = [], threading.Event()

    def tick():
        while not done.is_set():
            ticks.append(None)
            done.wait(1e-3)

    thread = threading.Thread(target=tick)
    thread.start()
    start = len(ticks)
    report = sim.step()
    during = len(ticks) - start
    done.set()
    thread.join()
    assert report.seconds > 0.03 and during > 5


def test_simulations_in_threads_give_the_same_as_one_after_the_other():
    def run(results, name):
        sim = gapflow.Simulation(plates_scene())
        sim.run()
        results[name] = sim.bodies["upper"].centre[1]

    results = {}
    threads = [threading.Thread(target=run, args=(results, i)) for i in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    run(results, "alone")
    assert len(results) == 4 and len(set(results.values())) == 1
