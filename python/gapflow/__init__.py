"""Gapflow: rigid bodies in incompressible flow, two-way coupled through thin gaps and contact.

    import gapflow

    sim = gapflow.Simulation("scene.toml", set={"domain.cells": [64, 64]})
    sim.run(until=0.5)
    print(sim.time, sim.bodies["upper"].velocity, sim.gaps["thickness"])

Scenes come from TOML files, from TOML text (`Toml`), or from Python objects (`Scene` and its parts). All numbers are in the
scene's own units, SI or any consistent ones. Importing the package starts nothing; the first simulation (or added mass) starts
MPI, unless the process has done so already, and the end of the process ends it. docs/python.md is the tutorial.
"""
from __future__ import annotations

import atexit as _atexit
import os as _os

if "OMP_WAIT_POLICY" not in _os.environ:  # read as the library is loaded: threads that wait for each other soon sleep, as the command's do
    _os.environ.setdefault("GOMP_SPINCOUNT", "1000")

from . import _core
from ._core import ComputationError, InputError
from .scene import (Ball, Body, Box, Capsule, Contact, Crowd, Cylinder, Domain, Fluid, Gap, GridOptions, HalfSpace, Hinge, Mesh, Output,
                    Pair, Scene, SceneLike, Sheet, Sides, Solver, Spring, Time, Toml)
from .records import AddedMass, Budget, Films, Grid, SealedPocket, StepReport
from .simulation import BodyState, SceneWarning, SideValues, Simulation, added_mass, check, first_accelerations, rank

__version__: str = _core.__version__

__all__ = [
    "AddedMass", "Ball", "Body", "BodyState", "Box", "Budget", "Capsule", "ComputationError", "Contact", "Crowd", "Cylinder", "Domain",
    "Films", "Fluid", "Gap", "Grid", "GridOptions", "HalfSpace", "Hinge", "InputError", "Mesh", "Output", "Pair", "Scene",
    "SceneLike", "SceneWarning", "SealedPocket", "Sheet", "SideValues", "Sides", "Simulation", "Solver", "Spring", "StepReport", "Time", "Toml",
    "added_mass", "check", "first_accelerations", "rank",
]

InputError.__doc__ = "A bad scene or argument, found before anything is computed: the command's text (place, key, value, remedy)."
ComputationError.__doc__ = "The computation failed (no convergence, sealed fluid squeezed by a prescribed body, disk full)."

# MPI can be ended once only, and after everything that uses it.
_atexit.register(_core.shutdown)
