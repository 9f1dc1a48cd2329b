"""Scenes from objects, dicts, text and files: one reader, its messages as Python exceptions."""
import numpy as np
import pytest
from conftest import ball_scene

import gapflow


def test_objects_become_toml_with_the_scenes_keys():
    scene = gapflow.Scene(domain=gapflow.Domain(size=np.array([4, 2]), cells=(8, 4), sides=gapflow.Sides(y_high="open")),
                          bodies=[gapflow.Box(name='a "b"', size=[1, np.float64(0.5)], free=["y"])],
                          pairs=[gapflow.Pair(bodies=("a", "wall:y_low"), contact="dry")], fluid={"viscosity": None})
    assert scene.to_toml() == (
        '[domain]\nsize = [4, 2]\ncells = [8, 4]\nsides = { y_high = "open" }\n\n[fluid]\n\n'
        '[[body]]\nname = "a \\"b\\""\nfree = ["y"]\nsize = [1, 0.5]\nshape = "box"\n\n'
        '[[pair]]\nbodies = ["a", "wall:y_low"]\ncontact = "dry"\n')


def test_every_part_of_a_scene_reaches_the_reader(tmp_path):
    (tmp_path / "square.csv").write_text("0,0\n1,0\n1,1\n0,1\n")
    (tmp_path / "inflow.csv").write_text("time,u,v\n0,0,0\n1,1,0\n")
    (tmp_path / "motion.csv").write_text("time,x,y,angle\n0,3,3,0\n1,3,4,0\n")
    scene = gapflow.Scene(
        title="all", gravity=[0, -1],
        domain=gapflow.Domain(size=[8, 8], cells=[32, 32], origin=[-1, 0],
                              sides=gapflow.Sides(x_low={"inflow": "inflow.csv"}, x_high="open", y_low={"wall": [1, 0]})),
        fluid=gapflow.Fluid(density=3, reference_pressure=2, vapour_pressure="none", velocity=[0.5, 0], initial="potential"),
        grid=gapflow.GridOptions(fractions="voxel", advection="semi-lagrangian", thin="allow"),
        gap=gapflow.Gap(threshold=0.4, entrance_loss=0.5, exit="jet"), contact=gapflow.Contact(restitution=0.1, friction=0.2),
        pairs=[gapflow.Pair(bodies=("c", "wall:y_low"), thickness=0.01)],
        bodies=[gapflow.Ball(name="b", radius=0.3, position=[3, 3], motion="prescribed", motion_file="motion.csv", interpolation="linear"),
                gapflow.Capsule(name="c", radius=0.3, length=1, position=[3, 6], mass=2, inertia=1,
                                spring=gapflow.Spring(anchor=[3, 6], stiffness=1), rotation=30),
                gapflow.Box(name="d", size=[1, 0.5], position=[5, 5], density=1, hinge=gapflow.Hinge(point=[5, 5])),
                gapflow.HalfSpace(name="h", normal=[0, -1], position=[0, 7.8], motion="fixed"),
                gapflow.Mesh(name="m", file="square.csv", scale=0.5, position=[5, 2], density=1)],
        time=gapflow.Time(end=1, max_step=0.1, cfl=0.5, gap_cfl=0.2), solver=gapflow.Solver(tolerance=1e-6, backend="petsc"),
        output=gapflow.Output(directory="there", every=0.1, fields=["pressure"]))
    resolved = gapflow.check(gapflow.Toml(scene.to_toml(), folder=tmp_path))
    assert resolved["domain"]["origin"] == [-1, 0] and resolved["fluid"]["density"] == 3
    assert resolved["grid"] == {"fractions": "voxel", "advection": "semi-lagrangian", "thin": "allow"}
    assert resolved["solver"] == {"tolerance": 1e-6, "backend": "petsc"}
    assert [body["shape"] for body in resolved["body"]] == ["ball", "capsule", "box", "half-space", "mesh"]
    assert resolved["body"][0]["interpolation"] == "linear"
    assert resolved["output"]["every"] == 0.1 and resolved["time"]["cfl"] == 0.5 and resolved["gap"]["exit"] == "jet"
    assert gapflow.check(ball_scene(3))["body"][0]["shape"] == "ball"
    cylinder = gapflow.Cylinder(name="c", radius=0.3, length=1, position=[1, 1, 1], density=1)
    three = gapflow.Scene(domain=gapflow.Domain(size=[2, 2, 2], cells=[8, 8, 8]), bodies=[cylinder])
    assert gapflow.check(three)["body"][0]["length"] == 1


def test_far_and_pressure_sides_reach_the_reader():
    for sides in (gapflow.Sides(x_low={"pressure": 3.5}, x_high={"pressure": 0}, y_high="far"), {"x_low": {"pressure": 3.5}, "x_high": {"pressure": 0}, "y_high": "far"}):
        resolved = gapflow.check(gapflow.Scene(domain=gapflow.Domain(size=[4, 4], cells=[32, 32], sides=sides)))["domain"]["sides"]
        assert resolved == {"x_low": {"pressure": 3.5}, "x_high": {"pressure": 0}, "y_low": "wall", "y_high": "far"}


def test_objects_dict_text_and_file_are_the_same_scene(tmp_path):
    scene = ball_scene()
    as_dict = {"gravity": [0, -1], "domain": {"size": [4, 4], "cells": [32, 32]}, "time": {"end": 0.1, "max_step": 0.01},
               "body": [{"name": "ball", "shape": "ball", "radius": 0.5, "position": [2, 2], "density": 2}]}
    file = tmp_path / "scene.toml"
    file.write_text(scene.to_toml())
    resolved = [gapflow.check(each) for each in (scene, as_dict, gapflow.Toml(scene.to_toml()), file, str(file))]
    assert all(each == resolved[0] for each in resolved)


def test_set_replaces_values():
    resolved = gapflow.check(ball_scene(), set={"domain.cells": np.array([16, 16]), "body.ball.position": (1, 2),
                                                "gap.model": "none", "title": "7"})
    assert resolved["domain"]["cells"] == [16, 16] and resolved["body"][0]["position"] == [1, 2]
    assert resolved["gap"]["model"] == "none" and resolved["title"] == "7"
    with pytest.raises(gapflow.InputError, match="^--set body.bal.radius: no body is named 'bal', did you mean 'ball'?"):
        gapflow.check(ball_scene(), set={"body.bal.radius": 1})


def test_a_bad_scene_is_a_value_error_with_the_readers_text():
    with pytest.raises(gapflow.InputError) as caught:
        gapflow.check(gapflow.Toml("[domain]\nsize = [1, 1]\ncells = [8, -8]\n"))
    assert str(caught.value) == ("scene:3:9: domain.cells = [8, -8]: -8 is out of range; allowed: a list of 2 whole numbers, each "
                                 ">= 1 and <= 1000000")
    assert isinstance(caught.value, ValueError) and type(caught.value).__module__ == "gapflow"
    with pytest.raises(ValueError, match="scene:2:1: fluid.viscosty: unknown key; did you mean 'fluid.viscosity'?"):
        gapflow.check(gapflow.Toml("[fluid]\nviscosty = 1\n"))
    with pytest.raises(gapflow.InputError, match="not valid TOML"):
        gapflow.check(gapflow.Toml("a = [1"))
    with pytest.raises(gapflow.InputError, match="nowhere.toml: cannot be read"):
        gapflow.check("nowhere.toml")
    with pytest.raises(gapflow.InputError, match="time.end"):
        gapflow.Simulation(gapflow.Scene(domain=gapflow.Domain(size=[1, 1], cells=[8, 8])))
    with pytest.raises(gapflow.InputError, match="no body moves"):
        gapflow.added_mass(ball_scene(motion="fixed"))


def test_values_without_a_form_in_toml_and_misspelt_names_are_refused():
    with pytest.raises(gapflow.InputError, match="has no form in a scene"):
        gapflow.check({"domain": {"size": [1, 1], "cells": {8, 8}}})
    with pytest.raises(TypeError, match="Ball: radiuss: unknown key; did you mean 'radius'?"):
        gapflow.Ball(name="b", radiuss=1)
    with pytest.raises(AttributeError, match="Fluid: viscosty: unknown attribute; did you mean 'viscosity'?"):
        gapflow.Fluid().viscosty = 1
    with pytest.raises(TypeError, match="Simulation: outptu: unknown argument; did you mean 'output'?"):
        gapflow.Simulation(ball_scene(), outptu="here")
    with pytest.raises(TypeError, match="check: sett: unknown argument; did you mean 'set'?"):
        gapflow.check(ball_scene(), sett={})


def test_what_the_reader_does_not_follow_is_a_warning():
    with pytest.warns(gapflow.SceneWarning, match="force is ignored: the body's motion is \"fixed\""):
        gapflow.check(ball_scene(motion="fixed", force=[1, 0]))
