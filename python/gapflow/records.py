"""Data about simulations, as plain values. D is the dimension."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class StepReport:
    """What a step did, and the state's sums after it; the columns of `steps.csv`."""

    step: int
    time: float
    dt: float
    cells: int
    """Unknowns of the grid."""
    film_nodes: int
    iterations: int
    """Of the pressure solves of this step."""
    residual: float
    """Relative, of the last one."""
    divergence_max: float
    """Largest net outflow of a cell over its volume, 1/time."""
    energy_fluid: float
    energy_bodies: float
    """Kinetic energy of the free bodies and energy of their springs."""
    viscous_iterations: int
    """Of the bulk's viscous solve."""
    dissipation_grid: float
    """Power that viscosity dissipates in the bulk."""
    dissipation_film: float
    """The same in films and their mouths."""
    solves: int
    """Of the pressure: more than one where contacts or voids change."""
    seconds: float
    """Wall clock."""
    notes: list[str]
    """For the user: thin bodies, contacts that do not converge, films with blind ends; once each."""


@dataclass(frozen=True, slots=True)
class Budget:
    """Sums over fluid, films and free bodies."""

    momentum: Floats
    """(D,)"""
    angular_momentum: Floats
    """(1,) in 2D, (3,) in 3D; about the domain's origin."""
    energy_grid: float
    energy_film: float
    energy_bodies: float


@dataclass(frozen=True, slots=True)
class Grid:
    """The grid, and this rank's part of it."""

    origin: Floats
    """(D,): low corner of the domain."""
    spacing: float
    """Edge of a cell; of a graded grid in its core."""
    cells: tuple[int, ...]
    """Of the whole domain."""
    low: tuple[int, ...]
    """This rank's cells are low <= index < high."""
    high: tuple[int, ...]
    periodic: tuple[bool, ...]
    places: tuple[Floats, ...] | None = None
    """Of a graded grid, the coordinates of all faces along each axis; None if all cells are equal."""

    def centres(self, axis: int) -> Floats:
        """Coordinates along an axis of the centres of this rank's cells."""
        if self.places is not None:
            x = self.places[axis][self.low[axis]:self.high[axis] + 1]
            return 0.5 * (x[:-1] + x[1:])
        return self.origin[axis] + self.spacing * (np.arange(self.low[axis], self.high[axis]) + 0.5)

    def faces(self, axis: int) -> Floats:
        """Coordinates along an axis of the faces normal to it, as `Simulation.face_velocity(axis)` has them."""
        last = not self.periodic[axis] and self.high[axis] == self.cells[axis]
        if self.places is not None:
            return self.places[axis][self.low[axis]:self.high[axis] + last]
        return self.origin[axis] + self.spacing * np.arange(self.low[axis], self.high[axis] + last)

    def corners(self, axis: int) -> Floats:
        """Coordinates along an axis of the low ends of this rank's cells, and of the last one's high end."""
        if self.places is not None:
            return self.places[axis][self.low[axis]:self.high[axis] + 1]
        return self.origin[axis] + self.spacing * np.arange(self.low[axis], self.high[axis] + 1)


@dataclass(frozen=True, slots=True)
class Films:
    """The films in all gaps, with gap.model = "parts" the gaps thinner than about a cell: meshes half-way between the surfaces, N nodes and M elements
    (2D: segments, 3D: triangles)."""

    bodies: list[tuple[str, str]]
    """The two bodies (or walls) of each film."""
    nodes: Floats
    """(N, D): their positions."""
    node_film: NDArray[np.int32]
    """(N,): number of the node's film in `bodies`."""
    thickness: Floats
    """(N,)"""
    pressure: Floats
    """(N,): full, hydrostatic part and reference included."""
    void_depth: Floats
    """(N,): void volume over area; 0 where there is no void."""
    elements: NDArray[np.int32]
    """(M, D): their nodes."""
    element_film: NDArray[np.int32]
    """(M,)"""
    velocity: Floats
    """(M, D): of the fluid, tangential part, mean over the thickness, world axes."""
    normal: Floats
    """(M, D): unit, from the film's first body to its second."""
    area: Floats
    """(M,): 2D: length."""


@dataclass(frozen=True, slots=True)
class SealedPocket:
    """Enclosed fluid without a way out."""

    cells: int
    """Of the grid."""
    film_nodes: int
    """Of films."""
    bodies: list[str]
    """That bound it; walls too where films hold all of it."""
    at: list[float]
    """A point of it."""


@dataclass(frozen=True, slots=True)
class AddedMass:
    """Added mass of all bodies that are not fixed, in the scene's fluid density: kinetic energy 1/2 V^T matrix V."""

    matrix: Floats
    """(k, k), symmetric: rows and columns are twists about the centres of mass, world axes."""
    labels: list[str]
    """Of its rows: "upper.vx", "upper.vy", "upper.omega" (3D: vx vy vz wx wy wz)."""
    bodies: list[str]
    cells: int
    film_nodes: int
    iterations: list[int]
    """One for each column."""
    sealed: list[SealedPocket]
    warnings: list[str]
    """For the user, also shown as SceneWarning: thin bodies, films with blind ends."""
    seconds: float

    def __getitem__(self, labels: tuple[str, str]) -> float:
        """One entry: added_mass["upper.vy", "lower.vy"]."""
        row, column = (self.labels.index(label) for label in labels)
        return float(self.matrix[row, column])
