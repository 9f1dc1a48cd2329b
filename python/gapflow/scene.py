"""Scenes as Python objects.

The classes have the names and keys of a TOML scene (`Fluid.viscosity` is `fluid.viscosity`); what is left `None` is not
written, so the reader's default holds. Nothing is checked here but names: `Scene.to_toml()` writes the TOML that the one reader
of scenes checks, and its messages ("scene:12:5: body.size = ...") count the lines of that text. Any value may be a NumPy array
or number.
"""
from __future__ import annotations

import dataclasses
import json
import os
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal, Mapping, Sequence, Union

from .names import checked_names

Vector = Sequence[float]
"""Two numbers in 2D, three in 3D; NumPy arrays will do."""
Spin = Union[float, Vector]
"""About the centre of mass: a number in 2D, three numbers (world axes) in 3D."""
Side = Union[str, Mapping[str, Any]]
"""`"wall"`, `"open"`, `"periodic"`, `"far"`, `"surface"`, `{"inflow": [u, v]}`, `{"inflow": "file.csv"}`, `{"pressure": value}`,
`{"pressure": "file.csv"}` or `{"wall": [u, v]}`."""


@checked_names
@dataclass(kw_only=True, slots=True)
class Sides:
    """Boundary conditions at the domain's sides. `"wall"` by default."""

    x_low: Side | None = None
    x_high: Side | None = None
    y_low: Side | None = None
    y_high: Side | None = None
    z_low: Side | None = None
    z_high: Side | None = None


@checked_names
@dataclass(kw_only=True, slots=True)
class Domain:
    """The box of fluid and its grid: two numbers in `size` and `cells` make a 2D scene (per unit depth), three a 3D one.

    size: edge lengths. cells: along each axis, with the same spacing on all. origin: low corner, default 0.
    Instead of cells: spacing, the edge of a cell; outside a core, a box { low, high }, cells may be wider: each at most growth (default 1.1)
    times as wide as its neighbour nearer to the core, and no wider than largest. follow: name of a body with which the grid moves, or
    { body, axes }.
    leaving: "warn", "stop" (the run ends) or "remove": of bodies on their way out of an open side.
    """

    size: Vector
    cells: Sequence[int] | None = None
    origin: Vector | None = None
    spacing: float | None = None
    core: Mapping[str, Vector] | None = None
    growth: float | None = None
    largest: float | None = None
    follow: str | Mapping[str, Any] | None = None
    sides: Sides | Mapping[str, Side] | None = None
    leaving: Literal["warn", "stop", "remove"] | None = None


@checked_names
@dataclass(kw_only=True, slots=True)
class Fluid:
    """density (default 1), viscosity (dynamic), reference_pressure (absolute, at open, far and surface sides), vapour_pressure (absolute, or
    "none"), velocity (at the start), initial ("rest" or "potential"); pressure_gradient or
    mean_velocity (of fluid and bodies) along periodic axes."""

    density: float | None = None
    viscosity: float | None = None
    reference_pressure: float | None = None
    vapour_pressure: float | Literal["none"] | None = None
    velocity: Vector | None = None
    initial: Literal["rest", "potential"] | None = None
    pressure_gradient: Vector | None = None
    mean_velocity: Vector | None = None


@checked_names
@dataclass(kw_only=True, slots=True)
class GridOptions:
    """[grid]: fractions ("cut-cell" or "voxel"), advection ("maccormack" or "semi-lagrangian"), thin ("refuse" or "allow": bodies
    thinner than a cell)."""

    fractions: Literal["cut-cell", "voxel"] | None = None
    advection: Literal["maccormack", "semi-lagrangian"] | None = None
    thin: Literal["refuse", "allow"] | None = None


@checked_names
@dataclass(kw_only=True, slots=True)
class Gap:
    """Defaults for the gaps of all pairs: model ("film", "none", or "parts" for ideal fluid), threshold (cells, or "auto"), contact ("wet" or
    "dry"), roughness (length, or "auto"), entrance_loss, exit ("auto", "reversible" or "jet")."""

    model: Literal["film", "none", "parts"] | None = None
    threshold: float | Literal["auto"] | None = None
    contact: Literal["wet", "dry"] | None = None
    roughness: float | Literal["auto"] | None = None
    entrance_loss: float | None = None
    exit: Literal["auto", "reversible", "jet"] | None = None


@checked_names
@dataclass(kw_only=True, slots=True)
class Contact:
    """Defaults for the contacts of all pairs: restitution, friction, thickness (surfaces are held this far apart)."""

    restitution: float | None = None
    friction: float | None = None
    thickness: float | None = None


@checked_names
@dataclass(kw_only=True, slots=True)
class Pair:
    """Keys of Gap and Contact for one pair; `bodies`: two names, of bodies or one of a wall ("wall:x_low" ... "wall:z_high")."""

    bodies: tuple[str, str]
    model: Literal["film", "none"] | None = None
    threshold: float | Literal["auto"] | None = None
    contact: Literal["wet", "dry"] | None = None
    roughness: float | Literal["auto"] | None = None
    entrance_loss: float | None = None
    exit: Literal["auto", "reversible", "jet"] | None = None
    restitution: float | None = None
    friction: float | None = None
    thickness: float | None = None


@checked_names
@dataclass(kw_only=True, slots=True)
class Spring:
    """Pulls a body's position towards `anchor`: stiffness (force per length), damping (force per velocity)."""

    anchor: Vector
    stiffness: float
    damping: float | None = None


@checked_names
@dataclass(kw_only=True, slots=True)
class Hinge:
    """The body only turns about `point`; in 3D about `axis` through it."""

    point: Vector
    axis: Vector | None = None


@checked_names
@dataclass(kw_only=True, slots=True)
class Body:
    """Keys of bodies of all shapes.

    position: of the shape's own origin (its centre, but for a mesh). rotation: degrees in 2D; {"axis", "degrees"} or a
    quaternion [w, x, y, z] in 3D. density, or mass and inertia (about the centre of mass, body axes). motion: "free", "fixed"
    or "prescribed" (by velocity and angular_velocity, or by motion_file, with interpolation "cubic" or "linear" between its rows).
    free: which of x y z rx ry rz move; all if not given. velocity: of the centre of mass, at the start or prescribed. force
    and torque: constant, until a controller sets others (`BodyState.set_force`). inside_out: the solid is everything outside the shape.
    """

    name: str
    position: Vector | None = None
    rotation: float | Vector | Mapping[str, Any] | None = None
    density: float | None = None
    mass: float | None = None
    inertia: float | Sequence[float] | Sequence[Sequence[float]] | None = None
    motion: Literal["free", "fixed", "prescribed"] | None = None
    motion_file: str | Path | None = None
    interpolation: Literal["linear", "cubic"] | None = None
    free: Sequence[str] | None = None
    velocity: Vector | None = None
    angular_velocity: Spin | None = None
    force: Vector | None = None
    torque: Spin | None = None
    spring: Spring | Mapping[str, Any] | None = None
    hinge: Hinge | Mapping[str, Any] | None = None
    inside_out: bool | None = None


@checked_names
@dataclass(kw_only=True, slots=True)
class Box(Body):
    """A box (2D: a rectangle) with edge lengths `size`."""

    size: Vector
    shape: Literal["box"] = field(default="box", init=False)


@checked_names
@dataclass(kw_only=True, slots=True)
class Ball(Body):
    """A ball; in 2D a disk."""

    radius: float
    shape: Literal["ball"] = field(default="ball", init=False)


@checked_names
@dataclass(kw_only=True, slots=True)
class Capsule(Body):
    """All points within `radius` of a segment of `length` along body x."""

    radius: float
    length: float
    shape: Literal["capsule"] = field(default="capsule", init=False)


@checked_names
@dataclass(kw_only=True, slots=True)
class Cylinder(Body):
    """A cylinder of `length` along body x; 3D only (in 2D take a Ball)."""

    radius: float
    length: float
    shape: Literal["cylinder"] = field(default="cylinder", init=False)


@checked_names
@dataclass(kw_only=True, slots=True)
class HalfSpace(Body):
    """All points on one side of a plane through `position`; `normal` points out of the solid. Cannot be free."""

    normal: Vector
    shape: Literal["half-space"] = field(default="half-space", init=False)


@checked_names
@dataclass(kw_only=True, slots=True)
class Mesh(Body):
    """A closed surface from `file` (OBJ or STL; 2D: a polygon), its coordinates times `scale`."""

    file: str | Path
    scale: float | None = None
    shape: Literal["mesh"] = field(default="mesh", init=False)


@checked_names
@dataclass(kw_only=True, slots=True)
class Sheet(Body):
    """A thin body of `thickness` around a middle surface: `points` of a polyline (2D), or `file` (an open OBJ or STL mesh; 2D: a polyline)."""

    thickness: float
    points: Sequence[Vector] | None = None
    file: str | Path | None = None
    scale: float | None = None
    shape: Literal["sheet"] = field(default="sheet", init=False)


@checked_names
@dataclass(kw_only=True, slots=True)
class Crowd:
    """Many bodies of one shape, called NAME_0001, NAME_0002 ...: either `number` or `volume_fraction` (of the region).

    shape with its lengths ("ball": radius; "box": size; "capsule", "cylinder": radius, length; "mesh": file, scale; "sheet": points or file, scale, thickness). region: {"low", "high"},
    {"centre", "radius"} or {"from", "to", "radius"}; the domain if not given. sizes: {"distribution", "mean", "deviation", "low", "high"} of a
    factor on all lengths. arrangement: "random" (without overlap) or "lattice" with `jitter`. spacing: smallest distance. rotation: as of a
    body, or "random". The other keys are those of a body.
    """

    name: str
    shape: Literal["ball", "box", "capsule", "cylinder", "mesh", "sheet"]
    number: int | None = None
    volume_fraction: float | None = None
    region: Mapping[str, Any] | None = None
    sizes: Mapping[str, Any] | None = None
    seed: int | None = None
    arrangement: Literal["random", "lattice"] | None = None
    spacing: float | Literal["auto"] | None = None
    jitter: float | None = None
    rotation: float | Vector | Mapping[str, Any] | Literal["random"] | None = None
    size: Vector | None = None
    radius: float | None = None
    length: float | None = None
    file: str | Path | None = None
    scale: float | None = None
    points: Sequence[Vector] | None = None
    thickness: float | None = None
    density: float | None = None
    mass: float | None = None
    inertia: float | Sequence[float] | Sequence[Sequence[float]] | None = None
    motion: Literal["free", "fixed", "prescribed"] | None = None
    free: Sequence[str] | None = None
    velocity: Vector | None = None
    angular_velocity: Spin | None = None
    force: Vector | None = None
    torque: Spin | None = None


@checked_names
@dataclass(kw_only=True, slots=True)
class Time:
    """end: `Simulation.run()` goes to here. max_step: largest time step. cfl: cells that the fluid may cross in a step.
    gap_cfl: part of its thickness that a gap may change by in a step; with long_ways only where its film matters for the motion. until_steady: the run ends once the flow's unsteadiness is below it."""

    end: float
    max_step: float
    cfl: float | None = None
    gap_cfl: float | None = None
    long_ways: bool | None = None
    until_steady: float | None = None


@checked_names
@dataclass(kw_only=True, slots=True)
class Solver:
    """tolerance: relative residual. backend: "multigrid" or "petsc"."""

    tolerance: float | None = None
    backend: Literal["multigrid", "petsc"] | None = None


@checked_names
@dataclass(kw_only=True, slots=True)
class Output:
    """For runs that write files (`Simulation(..., output=...)`): directory, every (time between fields), fields, bodies (the table of bodies:
    "csv", "binary", "both" or "auto"), precision and format of fields, bodies and films, forces: a table of the forces' parts."""

    directory: str | Path | None = None
    every: float | None = None
    fields: Sequence[str] | None = None
    checkpoint_every: float | None = None
    bodies: Literal["auto", "csv", "binary", "both"] | None = None
    precision: Literal["double", "single"] | None = None
    format: Literal["inline", "appended"] | None = None
    forces: bool | None = None


@checked_names
@dataclass(kw_only=True, slots=True)
class Scene:
    """A whole scene; `domain` is always needed, `time` by simulations. probes, fluxes: dicts with the keys of [[probe]] and [[flux]], for the tables of a
    run with an output folder."""

    domain: Domain | Mapping[str, Any]
    bodies: list[Body] = field(default_factory=list)
    crowds: list[Crowd] = field(default_factory=list)
    pairs: list[Pair] = field(default_factory=list)
    probes: list[Mapping[str, Any]] = field(default_factory=list)
    fluxes: list[Mapping[str, Any]] = field(default_factory=list)
    time: Time | Mapping[str, Any] | None = None
    title: str | None = None
    gravity: Vector | None = None
    fluid: Fluid | Mapping[str, Any] | None = None
    grid: GridOptions | Mapping[str, Any] | None = None
    gap: Gap | Mapping[str, Any] | None = None
    contact: Contact | Mapping[str, Any] | None = None
    solver: Solver | Mapping[str, Any] | None = None
    output: Output | Mapping[str, Any] | None = None

    def to_toml(self) -> str:
        """The scene as TOML, what the reader gets. Raises InputError if a value has no form in TOML."""
        return to_toml(self)


@dataclass(frozen=True, slots=True)
class Toml:
    """A scene as TOML text; files that it names are looked for in `folder`."""

    text: str
    folder: str | Path = "."


SceneLike = Union[Scene, Mapping[str, Any], Toml, str, "os.PathLike[str]"]
"""A Scene, a nested dict with the keys of the TOML, a Toml, or the path of a TOML file."""


def _plain(value: Any) -> Any:
    """Dataclasses as dicts without what is None, NumPy's arrays and numbers as Python's, paths as text."""
    if dataclasses.is_dataclass(value) and not isinstance(value, type):
        entries = {f.name: getattr(value, f.name) for f in dataclasses.fields(value)}
        if isinstance(value, Scene):
            entries["body"] = entries.pop("bodies") or None
            entries["crowd"] = entries.pop("crowds") or None
            entries["pair"] = entries.pop("pairs") or None
            entries["probe"] = entries.pop("probes") or None
            entries["flux"] = entries.pop("fluxes") or None
        return _plain(entries)
    if isinstance(value, Mapping):
        return {key: _plain(item) for key, item in value.items() if item is not None}
    if hasattr(value, "tolist"):
        return value.tolist()
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, (list, tuple)):
        return [_plain(item) for item in value]
    return value


def _text(value: str) -> str:
    return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007F")


def toml_value(value: Any) -> str:
    """One value as TOML on one line. Raises InputError if it has no form there."""
    from ._core import InputError

    value = _plain(value)
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, str):
        return _text(value)
    if isinstance(value, list):
        return "[" + ", ".join(toml_value(item) for item in value) + "]"
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{_key(key)} = {toml_value(item)}" for key, item in value.items()) + " }" if value else "{}"
    raise InputError(f"{value!r}: a {type(value).__name__} has no form in a scene; give numbers, text, lists or dicts")


def _key(key: Any) -> str:
    from ._core import InputError

    if not isinstance(key, str):
        raise InputError(f"{key!r}: a key of a scene is text")
    return key if key and all(c.isascii() and (c.isalnum() or c in "_-") for c in key) else _text(key)


def _is_table_list(value: Any) -> bool:
    return isinstance(value, list) and len(value) > 0 and all(isinstance(item, dict) for item in value)


def to_toml(scene: Scene | Mapping[str, Any]) -> str:
    """A scene, or a nested dict with its keys, as TOML with one key a line. Raises InputError if a value has no form there."""
    document = _plain(scene)
    lines, tables = [], []
    for key, value in document.items():
        if _is_table_list(value):
            tables += [(f"[[{_key(key)}]]", row) for row in value]
        elif isinstance(value, dict):
            tables.append((f"[{_key(key)}]", value))
        else:
            lines.append(f"{_key(key)} = {toml_value(value)}")
    for header, table in tables:
        lines += ["", header, *(f"{_key(key)} = {toml_value(value)}" for key, value in table.items())]
    return "\n".join(lines).lstrip("\n") + "\n"
