import os
import sys
from pathlib import Path

import pytest

import gapflow


@pytest.fixture
def command():
    """The gapflow command, to compare with."""
    path = os.environ.get("GAPFLOW_COMMAND")
    if not path:
        pytest.skip("GAPFLOW_COMMAND is not set")
    return path


@pytest.fixture
def python():
    """The words that start a Python which imports the same package."""
    return [sys.executable]


@pytest.fixture
def environment():
    return os.environ | {"PYTHONPATH": str(Path(gapflow.__file__).parent.parent)}


def ball_scene(dimension=2, cells=32, **keys):
    """A heavy ball in the middle of a closed box of 4, under gravity 1."""
    gravity = [0.0] * dimension
    gravity[-1] = -1.0
    body = dict(name="ball", radius=0.5, position=[2.0] * dimension, density=2.0) | keys
    return gapflow.Scene(gravity=gravity, domain=gapflow.Domain(size=[4.0] * dimension, cells=[cells] * dimension),
                         bodies=[gapflow.Ball(**body)], time=gapflow.Time(end=0.1, max_step=0.01))


def plates_scene():
    """Two plates a tenth of a cell apart in a 2D box, pulled apart."""
    plates = [gapflow.Box(name=name, size=[1.0, 0.5], position=[2.0, 2.0 + side * 0.255], density=2.0, force=[0.0, side * 1.0])
              for name, side in (("upper", 1), ("lower", -1))]
    return gapflow.Scene(domain=gapflow.Domain(size=[4.0, 4.0], cells=[40, 40]), bodies=plates,
                         time=gapflow.Time(end=0.05, max_step=0.01))
