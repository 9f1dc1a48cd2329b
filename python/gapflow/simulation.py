"""Simulations: a scene in time, its state as NumPy arrays.

Shapes: D is the dimension, n the number of bodies. Fields are indexed `[x, y]` or `[x, y, z]`, vectors have one more axis at the
end. On several MPI ranks (`mpirun -n 4 python script.py`) every rank runs the same script: fields hold the rank's own cells,
everything else is the same on all, and calls that compute are collective.

Arrays are read-only and belong to whoever holds them: they keep the values of the step they were read in, also when the
simulation goes on or is gone. Asked for again in the same step, the same array comes back without a copy. The two exceptions
are `Simulation.face_velocity` and `Simulation.face_fraction`.
"""
from __future__ import annotations

import copy
import json
import math
import os
import warnings
from dataclasses import dataclass, replace
from typing import Any, Callable, Iterator, Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from .names import Named, checked_arguments
from .records import AddedMass, Budget, Films, Floats, Grid, SealedPocket, StepReport
from .scene import Scene, SceneLike, Side, Spin, Spring, Toml, Vector, to_toml, toml_value


class SceneWarning(UserWarning):
    """A setting of a scene that has no effect, or that makes its results doubtful."""


class BodyState(Named):
    """A body of a simulation as it is now. World axes; linear quantities are those of the centre of mass.

    force, torque, velocity, angular_velocity and spring can be set, from the next step on; what else there is can be read.
    """

    __slots__ = ("_simulation", "_index", "name", "motion")

    def __init__(self, simulation: Simulation, index: int, name: str, motion: str) -> None:
        self._simulation = simulation
        self._index = index
        self.name = name
        self.motion = motion
        """"free", "fixed" or "prescribed"."""

    def _row(self, key: str) -> Any:
        value = self._simulation.body_table[key][self._index]
        return value if value.ndim else float(value)

    @property
    def centre(self) -> Floats:
        """(D,): centre of mass."""
        return self._row("centre")

    @property
    def position(self) -> Floats:
        """(D,): of the shape's own origin, as the scene's key."""
        return self._row("position")

    @property
    def angle(self) -> float:
        """2D: radians, counted on beyond a full turn."""
        if self._simulation.dimension == 3:
            raise AttributeError("a body in 3D has a quaternion and a rotation matrix, no angle")
        return self._row("angle")

    @property
    def quaternion(self) -> Floats:
        """3D: (4,), w x y z, from body axes to world axes."""
        if self._simulation.dimension == 2:
            raise AttributeError("a body in 2D has an angle, no quaternion")
        return self._row("quaternion")

    @property
    def rotation(self) -> Floats:
        """(D, D): matrix from body axes to world axes."""
        if self._simulation.dimension == 2:
            c, s = math.cos(self.angle), math.sin(self.angle)
            return np.array([[c, -s], [s, c]])
        w, x, y, z = self.quaternion
        return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                         [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                         [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])

    @property
    def velocity(self) -> Floats:
        """(D,); of a prescribed body it can be set, as by `set_velocity`."""
        return self._row("velocity")

    @velocity.setter
    def velocity(self, value: ArrayLike) -> None:
        self.set_velocity(value)

    @property
    def angular_velocity(self) -> Any:
        """A float in 2D, (3,) in 3D; radians per time. Of a prescribed body it can be set, as by `set_velocity`."""
        return self._row("angular_velocity")

    @angular_velocity.setter
    def angular_velocity(self, value: ArrayLike) -> None:
        self.set_velocity(angular_velocity=value)

    @property
    def fluid_force(self) -> Floats:
        """(D,): mean over the last step, buoyancy included, contact excluded."""
        return self._row("fluid_force")

    @property
    def fluid_torque(self) -> Any:
        """A float in 2D, (3,) in 3D: about the centre of mass, as `fluid_force`."""
        return self._row("fluid_torque")

    @property
    def force(self) -> Floats:
        """(D,): external force in effect; of a free body it can be set, as by `set_force`."""
        return self._row("force")

    @force.setter
    def force(self, value: ArrayLike) -> None:
        self.set_force(value)

    @property
    def torque(self) -> Any:
        """A float in 2D, (3,) in 3D: external torque in effect; of a free body it can be set, as by `set_force`."""
        return self._row("torque")

    @torque.setter
    def torque(self, value: ArrayLike) -> None:
        self.set_force(torque=value)

    @property
    def spring(self) -> Spring | None:
        """The spring that pulls the body's position towards its anchor; None: none. It can be set, to a `Spring`, a dict with its
        keys, or None, which takes it away."""
        spring = self._entry().get("spring")
        return Spring(**spring) if spring else None

    @spring.setter
    def spring(self, value: Spring | Mapping[str, Any] | None) -> None:
        if value is None:
            value = {"anchor": list(self.position), "stiffness": 0.0, "damping": 0.0} if self.spring else {}
        keys = {name: getattr(value, name) for name in ("anchor", "stiffness", "damping")} if isinstance(value, Spring) else value
        self._simulation.change({f"body.{self.name}.spring.{key}": entry for key, entry in keys.items() if entry is not None})

    def _entry(self) -> dict[str, Any]:
        return self._simulation.resolved_scene["body"][self._index]

    @property
    def mass(self) -> float:
        """2D: per unit depth. Meaningless if the body is not free."""
        return self._row("mass")

    @property
    def inertia(self) -> Any:
        """About the centre of mass, body axes: a float in 2D, (3, 3) in 3D."""
        return self._row("inertia")

    @property
    def volume(self) -> float:
        """Of fluid displaced (2D: area); negative for a container."""
        return self._row("volume")

    def set_force(self, force: ArrayLike | None = None, torque: ArrayLike | None = None) -> None:
        """External force (D,) at the centre of mass and torque (a number in 2D, (3,) in 3D) about it, world axes.

        In place of the scene's, from the next step on, until set again; what is None stays. Raises InputError if the body is
        not free, or numbers are too many, too few or not finite.
        """
        self._simulation._set("set_force", self.name, self.force if force is None else force,
                              self.torque if torque is None else torque)

    def set_velocity(self, velocity: ArrayLike | None = None, angular_velocity: ArrayLike | None = None) -> None:
        """The motion of a prescribed body from now on: constant velocity (D,) of the centre of mass and angular velocity (a
        number in 2D, (3,) in 3D), from where it is; what is None stays. Raises InputError as `set_force`."""
        self._simulation._set("set_velocity", self.name, self.velocity if velocity is None else velocity,
                              self.angular_velocity if angular_velocity is None else angular_velocity)

    def surface(self, tolerance: float | None = None) -> tuple[Floats, NDArray[np.int32]]:
        """Vertices (V, D) in the world and elements (E, D) of the surface, chords at most `tolerance` (default: a twentieth
        of a cell) off. Half-spaces have none."""
        return self._simulation._session.surface(self.name, tolerance or 0.05 * self._simulation.grid.spacing)

    def __repr__(self) -> str:
        return f"<body {self.name!r}, {self.motion}, centre {self.centre}, velocity {self.velocity}>"


class Bodies(Mapping[str, BodyState]):
    """The bodies by name, in the scene's order."""

    def __init__(self, bodies: dict[str, BodyState]) -> None:
        self._bodies = bodies

    def __getitem__(self, name: str) -> BodyState:
        try:
            return self._bodies[name]
        except KeyError:
            raise KeyError(f"no body is named {name!r}; there are: {', '.join(self._bodies)}") from None

    def __iter__(self) -> Iterator[str]:
        return iter(self._bodies)

    def __len__(self) -> int:
        return len(self._bodies)

    def __repr__(self) -> str:
        return f"<bodies {', '.join(self._bodies)}>"


Control = Callable[["Simulation"], Any]
Callback = Callable[["Simulation", StepReport], Any]
VelocityLike = Callable[[Floats], ArrayLike] | Sequence[ArrayLike]


class SideValues(Mapping[str, Side]):
    """What the sides of the domain are now, by name: "x_low" ... "z_high". An inflow and a wall that slides can be given another velocity,
    from the next step on: sim.sides["x_low"] = {"inflow": [1, 0]}. A side stays what it is."""

    def __init__(self, simulation: Simulation) -> None:
        self._simulation = simulation

    def _now(self) -> dict[str, Side]:
        return self._simulation.resolved_scene["domain"]["sides"]

    def __getitem__(self, name: str) -> Side:
        return self._now()[name]

    def __setitem__(self, name: str, side: Side) -> None:
        self._simulation.change({f"domain.sides.{name}": side})

    def __iter__(self) -> Iterator[str]:
        return iter(self._now())

    def __len__(self) -> int:
        return len(self._now())

    def __repr__(self) -> str:
        return f"<sides {self._now()}>"


CHANGEABLE = ("gravity", "fluid.viscosity", "fluid.pressure_gradient", "fluid.mean_velocity", "domain.sides.SIDE", "body.NAME.spring.KEY",
              "contact.restitution", "contact.friction", "time.max_step", "time.cfl", "time.gap_cfl", "solver.tolerance")
"""Keys of the scene that `Simulation.change` can change."""


def _changeable(key: str) -> bool:
    if key.startswith("body."):
        return ".spring." in key
    return key in CHANGEABLE or key.startswith("domain.sides.")


class Simulation(Named):
    """A scene in time, at its start (time 0) once built.

    scene: a `Scene`, a nested dict with the keys of the TOML, a `Toml` text, or the path of a TOML file.
    set: values to replace, {"domain.cells": [64, 64], "body.upper.position": [2, 2.3]}, as the command's --set.
    output: a folder for the files of a run, the same that `gapflow run` writes; True: the scene's own output.directory;
    None: no files. Files are complete after each step; `close()` or the end of a `with` block writes how the run ended, before
    time.end also a checkpoint to go on from.
    resume: a checkpoint.h5 of the same scene to go on from; with `output` the files there are cut back to it first and continued.
    Forces and velocities that were set are part of it.
    velocity: of the fluid at the start, in place of the scene's fluid.velocity, for `gap.model = "parts"`: a function of points (n, D) that
    returns velocities (n, D), called once for the centres of the faces normal to each axis; or D arrays, one an axis, with the velocity along
    the axis on the faces normal to it, shapes as of `face_velocity(axis)`. In solids too: what lies within one is the circulation around it.
    The fluid starts with the part of it that has no divergence and, at walls, their normal velocity.

    Raises InputError (a ValueError) for a bad scene, also for a body thinner than a cell (grid.thin), for a velocity of wrong shape, not finite,
    with `resume`, or of a scene that cannot have it (docs/theory/step.md, "Limits"), and ComputationError (a
    RuntimeError) if the start cannot be computed. What it is told of at the start comes as SceneWarning.
    Calls that compute let other Python threads run, but only one computes at a time; to another thread the simulation is then
    busy (RuntimeError). After a ComputationError the simulation has no state to read any more.
    """

    __slots__ = ("_source", "_scene", "_changed", "_resolved", "_folder", "_session", "_cache", "_bodies", "__weakref__")

    @checked_arguments
    def __init__(self, scene: SceneLike, *, set: Mapping[str, Any] | None = None,
                 output: str | os.PathLike[str] | bool | None = None, resume: str | os.PathLike[str] | None = None,
                 velocity: VelocityLike | None = None) -> None:
        self._source = _source_of(scene, set)
        self._scene = self._source.read("run")
        _warn(self._scene, 3)
        folder = "" if output is None or output is False else self._scene.output_directory if output is True else os.fspath(output)
        self._folder = folder
        if velocity is not None and resume is not None:
            raise _core.InputError("velocity: a run that goes on from a checkpoint has the velocity from there; give either of velocity and resume")
        faces = [] if velocity is None else _on_faces(velocity, Grid(**_core.Session.start_grid(self._scene)))
        self._session = _core.Session(self._scene, folder, "" if resume is None else os.fspath(resume), faces)
        for note in self._session.report()["notes"]:
            warnings.warn(note, SceneWarning, stacklevel=3)
        self._start()

    def _start(self) -> None:
        self._changed: Any = None  # a scene to go on with from the next step on
        self._resolved: dict[str, Any] | None = None
        self._cache: dict[str, Any] = {}
        states = [BodyState(self, i, name, motion) for i, (name, motion) in enumerate(self._scene.bodies)]
        self._bodies = Bodies({body.name: body for body in states})

    @property
    def bodies(self) -> Bodies:
        """Bodies by name."""
        return self._bodies

    @property
    def grid(self) -> Grid:
        """The grid, and this rank's part of it; a grid that follows a body lies where it is now."""
        return Grid(**self._session.grid())

    # States that are put back

    @classmethod
    @checked_arguments
    def restore(cls, path: str | os.PathLike[str], *, scene: SceneLike | None = None, set: Mapping[str, Any] | None = None,
                output: str | os.PathLike[str] | bool | None = None) -> Simulation:
        """The simulation of a checkpoint, of `save`, of a run's files or of the command's, as it was: it goes on with the same bits.

        scene: None takes the scene from the checkpoint, which has it resolved, with files by their names from where the run was started;
        crowds have to be given. set, output: as of a new simulation. Raises InputError for a file that is none, or of another scene.
        """
        return cls(_scene_of_checkpoint(os.fspath(path)) if scene is None else scene, set=set, output=output, resume=path)

    def copy(self) -> Simulation:
        """Another simulation in the same state, without files: both go on with the same bits, and neither knows of the other. Collective."""
        self._apply()
        other = object.__new__(type(self))
        other._source, other._scene, other._folder = self._source, self._scene, ""
        other._session = self._session.copy()
        other._start()
        return other

    def save(self, path: str | os.PathLike[str]) -> None:
        """The state of this moment as a checkpoint, for `restore`, or for the command's --resume. Collective. Raises ComputationError."""
        self._apply()
        self._session.write_checkpoint(os.fspath(path))

    # What a loop may change

    def change(self, values: Mapping[str, Any]) -> None:
        """Other values for keys of the scene, from the next step on: {"gravity": [0, -2], "fluid.viscosity": 0.1}.

        Checked like a scene at once. The keys: gravity, fluid.viscosity (not to or from 0), fluid.pressure_gradient and mean_velocity (where
        the scene has them), domain.sides.SIDE (the velocity of an inflow or a wall), body.NAME.spring.KEY, contact.restitution and
        friction, time.max_step, cfl and gap_cfl, solver.tolerance. Forces and prescribed velocities: `BodyState`. A change costs about half a
        step's time. Raises InputError for a bad value or another key.
        """
        for key in values:
            if not _changeable(key):
                near = _core.nearest_name(key, list(CHANGEABLE))
                raise _core.InputError(f"{key}: does not change during a run{f'; did you mean {near!r}?' if near else ''} (what does: "
                                       f"{', '.join(CHANGEABLE)}); start another simulation with the new value")
        source = self._source.with_values(values)
        scene = source.read("run")
        self._session.demand_changeable(scene)
        self._source, self._changed, self._resolved = source, scene, None

    def _apply(self) -> None:
        if self._changed is None:
            return
        self._session.change(self._changed)
        self._scene, self._changed = self._changed, None

    @property
    def gravity(self) -> Floats:
        """(D,); it can be set, from the next step on."""
        return np.array(self.resolved_scene["gravity"], dtype=float)

    @gravity.setter
    def gravity(self, value: Vector) -> None:
        self.change({"gravity": value})

    @property
    def viscosity(self) -> float:
        """Dynamic; it can be set, from the next step on, but not to or from 0."""
        return float(self.resolved_scene["fluid"]["viscosity"])

    @viscosity.setter
    def viscosity(self, value: float) -> None:
        self.change({"fluid.viscosity": value})

    @property
    def sides(self) -> SideValues:
        """The sides of the domain: sim.sides["x_low"] = {"inflow": [1, 0]} changes an inflow from the next step on."""
        return SideValues(self)

    # Time

    @property
    def dimension(self) -> int:
        """2 or 3."""
        return self._scene.dimension

    @property
    def time(self) -> float:
        """Of the state, in the scene's unit; 0 at the start."""
        return self._session.time

    @property
    def steps(self) -> int:
        """Steps done."""
        return self._session.steps

    @property
    def report(self) -> StepReport:
        """Of the last step; at first of the start."""
        return self._cached("report", lambda: StepReport(**self._session.report()))

    @property
    def end(self) -> float:
        """The scene's time.end."""
        return self._scene.end

    @property
    def ended_by(self) -> str | None:
        """The scene's key that ended the run: "time.end", "time.until_steady" or "domain.leaving"; None before. Steps can go on beyond it; what
        `change` sets begins anew."""
        return self._session.ended_by or None

    def step(self, until: float = math.inf) -> StepReport:
        """One time step, as long as the flow allows, that does not pass `until`, nor time.end, nor, with files, an output time.

        Once time.end is reached further steps go on beyond it. Ctrl-C during the step raises KeyboardInterrupt after it (on all
        ranks): the state is that of a whole step, and one can go on. Raises InputError if `until` is not later than the time;
        BufferError while face views are alive; ComputationError.
        """
        self._apply()
        self._cache.clear()
        return self._cached("report", lambda: StepReport(**self._session.step(until)))

    @checked_arguments
    def run(self, until: float | None = None, *, control: Control | None = None, callback: Callback | None = None) -> StepReport:
        """Steps until a time, exactly; without one until the run ends: at time.end, or before it as time.until_steady and
        domain.leaving = "stop" ask (`ended_by` tells). Returns the last report. Raises InputError for a time that has passed.

        control(sim): called before every step, to set forces or velocities.
        callback(sim, report): called after every step; if it returns True, the run stops there.
        """
        ends = until is None
        until = self.end if until is None else until
        if not ends and not until >= self.time:
            raise _core.InputError(f"until = {until:g}: the time is {self.time:g} already; give a later one")
        while self.time < until and not (ends and self.ended_by):
            if control is not None:
                control(self)
            report = self.step(until)
            if callback is not None and callback(self, report) is True:
                break
        return self.report

    # State

    def _cached(self, name: str, make: Callable[[], Any]) -> Any:
        if name not in self._cache:
            self._cache[name] = make()
        return self._cache[name]

    @property
    def velocity(self) -> Floats:
        """(*cells, D): fluid velocity at cell centres, the mean of two faces. In solids: extrapolated from the fluid."""
        return self._cached("velocity", lambda: _frozen(self._session.velocity()))

    @property
    def vorticity(self) -> Floats:
        """(*cells,) in 2D, (*cells, 3) in 3D: curl of the velocity at cell centres, by central differences of second order; next to and in
        solids, of the velocity that is extrapolated into them."""
        return self._cached("vorticity", lambda: _frozen(self._session.vorticity()))

    @property
    def pressure(self) -> Floats:
        """(*cells,): full pressure, hydrostatic part and reference included, mean over the last step. NaN in cells without a
        pressure of the grid: in solids, and where films stand for the fluid."""
        return self._cached("pressure", lambda: _frozen(self._session.pressure()))

    @property
    def kind(self) -> NDArray[np.int8]:
        """(*cells,): 0 solid, 1 bulk, 2 film, 3 both film and bulk."""
        return self._cached("kind", lambda: _frozen(self._session.kind()))

    @property
    def films(self) -> Films:
        """Meshes, thicknesses, pressures and velocities of all films, or of the gaps of gap.model = "parts". Collective."""
        return self._cached("films", lambda: Films(**{key: _frozen(v) for key, v in self._session.films().items()}))

    @property
    def gaps(self) -> np.ndarray:
        """A row a pair with a film or in contact, the columns of `gaps.csv` but step and time: gaps["thickness"] (smallest
        distance, negative: overlap), body_a, body_b, opening_rate, film_nodes, film_area, pressure_min, pressure_max, force (of
        the film on body_a, along the normal that pushes it away from body_b), contact_force, contact_impulse, void_volume."""
        return self._cached("gaps", self._gap_table)

    def _gap_table(self) -> np.ndarray:
        rows = self._session.gaps()
        width = max((len(name) for row in rows for name in row[:2]), default=1)
        return _frozen(np.array(rows, dtype=[(name, f"U{width}" if kind == "U" else kind) for name, kind in _core.gap_columns()]))

    @property
    def body_table(self) -> dict[str, Floats]:
        """All bodies at once, a row each in the scene's order: centre (n, D), position (n, D), angle (n,) in 2D or quaternion
        (n, 4) in 3D, velocity (n, D), angular_velocity (n,) or (n, 3), fluid_force, fluid_torque, force, torque, mass (n,),
        inertia (n,) or (n, 3, 3), volume (n,). As the properties of `BodyState`."""
        return self._cached("bodies", lambda: {key: _frozen(value) for key, value in self._session.bodies().items()})

    @property
    def budget(self) -> Budget:
        """Momentum and energy now. Collective."""
        return self._cached("budget", lambda: Budget(**{key: _frozen(v) for key, v in self._session.budget().items()}))

    @property
    def seconds(self) -> dict[str, float]:
        """Wall clock of each stage of the method so far."""
        return self._session.stages()

    @property
    def resolved_scene(self) -> dict[str, Any]:
        """The scene with all defaults filled in, as in `run.json`; with what was changed since."""
        if self._resolved is None:
            self._resolved = json.loads((self._scene if self._changed is None else self._changed).json())
        return copy.deepcopy(self._resolved)

    def face_velocity(self, axis: int) -> Floats:
        """The solver's own normal velocities on the faces normal to an axis, without a copy: entry [i, j(, k)] is the face on
        the low side of that cell; one more along the axis at the domain's high side, unless periodic.

        A read-only view. It keeps the simulation alive; while it lives, `step()` raises BufferError, as it would change what
        the view shows: delete it (`del view`) or keep a copy (`view.copy()`).
        """
        return self._session.face_velocity(axis)

    def face_fraction(self, axis: int) -> Floats:
        """Which part of each face is open to the fluid of the grid, 0 to 1; a view as `face_velocity`."""
        return self._session.face_fraction(axis)

    def _set(self, what: str, body: str, linear: ArrayLike, angular: ArrayLike) -> None:
        getattr(self._session, what)(body, _numbers(linear), _numbers(angular))
        self._cache.pop("bodies", None)

    # Files

    def write_checkpoint(self, file: str | os.PathLike[str] | None = None) -> None:
        """The state of this moment, to go on from with `resume`, here or in the command; None: checkpoint.h5 in the run's folder, where
        output.checkpoint_every also puts it. Collective. Raises InputError if there is no such folder, ComputationError."""
        if file is None and not self._folder:
            raise _core.InputError("write_checkpoint: the simulation has no output folder; give a file")
        self._apply()
        self._session.write_checkpoint(os.path.join(self._folder, "checkpoint.h5") if file is None else os.fspath(file))

    def close(self) -> None:
        """Ends the files of the run and frees the simulation; arrays read before stay. Raises BufferError while face views are
        alive."""
        self._session.close()
        self._cache.clear()

    def __enter__(self) -> Simulation:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __repr__(self) -> str:
        cells = " x ".join(map(str, self.grid.cells))
        return f"<gapflow.Simulation {self.dimension}D, {cells} cells, {len(self.bodies)} bodies>"


@checked_arguments
def added_mass(scene: SceneLike, *, set: Mapping[str, Any] | None = None) -> AddedMass:
    """The added-mass matrix at the scene's poses, as `gapflow added-mass`. Needs no [time]. Collective.

    Raises InputError, also for a body thinner than a cell (grid.thin), and ComputationError if a solve does not converge.
    """
    result = _core.added_mass(_read(scene, set, "added_mass"))
    for warning in result["warnings"]:
        warnings.warn(warning, SceneWarning, stacklevel=3)
    sealed = [SealedPocket(**pocket) for pocket in result.pop("sealed")]
    return AddedMass(**{key: _frozen(value) for key, value in result.items()}, sealed=sealed)


@checked_arguments
def first_accelerations(scene: SceneLike, *, set: Mapping[str, Any] | None = None) -> dict[str, Floats]:
    """Of each free body its acceleration and angular acceleration, in one array, when bodies and fluid start from rest: by gravity with buoyancy, given
    forces and springs, in ideal fluid. Prescribed bodies are held, contacts do not act. Needs no [time]. Collective. Raises as added_mass()."""
    return _core.first_accelerations(_read(scene, set, "added_mass"))


@checked_arguments
def check(scene: SceneLike, *, set: Mapping[str, Any] | None = None) -> dict[str, Any]:
    """Validates a scene, computing nothing, and returns it with all defaults filled in. Raises InputError."""
    return json.loads(_read(scene, set, "check").json())


def rank() -> tuple[int, int]:
    """This process's number among the ranks of the run, and their number: (0, 1) without mpirun. Starts MPI."""
    return _core.rank()


@dataclass(frozen=True)
class _Source:
    """A scene as it came: text, the name that stands for its file, and values set besides."""

    text: str | None  # None: a file that cannot be read as text, of which the reader of scenes tells
    name: str
    sets: tuple[tuple[str, str], ...]
    quaternions: tuple[Sequence[float], ...] = ()  # of the bodies of a checkpoint in 3D

    def read(self, purpose: str) -> Any:
        if self.text is None:
            return _core.read_scene(self.name, list(self.sets), purpose)
        scene = _core.parse_scene(self.text, self.name, list(self.sets), purpose)
        for body, quaternion in enumerate(self.quaternions):
            scene.put_back_quaternion(body, quaternion)
        return scene

    def with_values(self, values: Mapping[str, Any]) -> _Source:
        more = tuple((key, toml_value(value)) for key, value in values.items())
        kept = tuple(entry for entry in self.sets if entry[0] not in values)
        return replace(self, sets=kept + more)


def _text_of(file: str) -> str | None:
    try:
        with open(file, encoding="utf-8", newline="") as content:
            return content.read()
    except (OSError, UnicodeDecodeError):
        return None


def _source_of(scene: SceneLike | _Source, overrides: Mapping[str, Any] | None) -> _Source:
    if isinstance(scene, _Source):
        return scene.with_values(overrides or {})
    if isinstance(scene, (Scene, Mapping)):
        scene = Toml(to_toml(scene))
    if isinstance(scene, Toml):
        name = os.path.normpath(os.path.join(scene.folder, "scene"))  # stands for the file in messages
        text = scene.text
    else:
        name = os.fspath(scene)
        text = _text_of(name)
    return _Source(text, name, ()).with_values(overrides or {})


def _warn(read: Any, level: int) -> None:
    for warning in read.warnings:
        warnings.warn(warning, SceneWarning, stacklevel=level + 1)


def _read(scene: SceneLike, overrides: Mapping[str, Any] | None, purpose: str) -> Any:
    read = _source_of(scene, overrides).read(purpose)
    _warn(read, 4)
    return read


def _scene_of_checkpoint(path: str) -> _Source:
    """The scene that a checkpoint holds, resolved, as one that reads to the same resolved scene."""
    stored = json.loads(_core.checkpoint_scene(path))
    if stored.get("crowd"):
        raise _core.InputError(f"{path}: its scene has crowds, and a checkpoint has only what they became; give the scene, "
                               "restore(path, scene=...)")
    scene = {key: value for key, value in stored.items() if key != "crowd"}
    flat = len(stored["domain"]["size"]) == 2
    for body in scene["body"] if flat else ():  # degrees as they were typed: 30, not 30.000000000000004
        body["rotation"] = float(f"{body['rotation']:.15g}")
    quaternions = () if flat else tuple(body["rotation"] for body in scene["body"])

    for table in (scene["gap"], *scene["pair"]):
        if table.pop("automatic_roughness", False):
            table["roughness"] = "auto"
    source = replace(_source_of(scene, None), quaternions=quaternions)
    try:
        source.read("run")
    except _core.InputError as error:
        raise _core.InputError(f"{path}: its scene cannot be built again ({error}); give it, restore(path, scene=...)") from None
    return source


def _numbers(values: ArrayLike) -> Sequence[float]:
    try:
        return np.atleast_1d(np.asarray(values, dtype=float)).ravel().tolist()
    except (TypeError, ValueError) as error:
        raise _core.InputError(f"{values!r}: are not numbers") from error


def _on_faces(velocity: VelocityLike, grid: Grid) -> list[Floats]:
    """The velocity along each axis on the faces normal to it."""
    axes = range(len(grid.cells))
    if not callable(velocity) and (not hasattr(velocity, "__len__") or len(velocity) != len(axes)):
        raise _core.InputError(f"velocity: give a function of points, or {len(axes)} arrays, one for the faces normal to each axis")
    faces = []
    for axis in axes:
        if callable(velocity):
            places = np.meshgrid(*(grid.faces(k) if k == axis else grid.centres(k) for k in axes), indexing="ij")
            points = np.stack(places, axis=-1).reshape(-1, len(axes))
            values = _array("velocity(points)", velocity(points), points.shape)[:, axis].reshape(places[0].shape)
        else:
            shape = tuple(len(grid.faces(k) if k == axis else grid.centres(k)) for k in axes)
            values = _array(f"velocity[{axis}]", velocity[axis], shape)
        faces.append(values)
    return faces


def _array(name: str, values: ArrayLike, shape: tuple[int, ...]) -> Floats:
    try:
        array = np.asarray(values, dtype=float)
    except (TypeError, ValueError) as error:
        raise _core.InputError(f"{name}: are not numbers in an array") from error
    if array.shape != shape:
        raise _core.InputError(f"{name}: has the shape {array.shape}; give {shape}")
    if not np.isfinite(array).all():
        raise _core.InputError(f"{name}: {np.count_nonzero(~np.isfinite(array))} of its values are not finite; give numbers everywhere, in solids too")
    return array


def _frozen(value: Any) -> Any:
    if isinstance(value, np.ndarray):
        value.flags.writeable = False
    return value
