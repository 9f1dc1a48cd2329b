"""Pictures of a simulation's state, with matplotlib; and the state as VTK objects, for PyVista and ParaView's Python.

matplotlib and VTK are imported when they are used; the package needs neither (Debian: python3-matplotlib, python3-vtk9).

    from gapflow import plot
    axes = plot.state(sim, "pressure")
    axes.figure.savefig("pressure.png")
"""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal, get_args

import numpy as np

from .names import checked_arguments
from .simulation import Simulation

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.collections import LineCollection, PolyCollection
    from matplotlib.image import AxesImage

Quantity = Literal["pressure", "speed", "vorticity", "velocity_x", "velocity_y", "velocity_z", "kind"]


@checked_arguments
def state(sim: Simulation, quantity: Quantity = "pressure", *, axes: Axes | None = None, normal: int = 1,
          position: float | None = None) -> Axes:
    """The field with a colour bar; in 2D with bodies and films on it. Returns the matplotlib axes.

    quantity: "pressure", "speed", "vorticity" (3D: its size), "velocity_x", "velocity_y", "velocity_z", "kind" (0 solid, 1 bulk, 2 film, 3
    both). Raises ValueError, with a list, for one that there is not.
    """
    import matplotlib.pyplot as plt

    _demand_quantity(sim, quantity)
    if axes is None:
        axes = plt.subplots(constrained_layout=True)[1]
    image = field(sim, quantity, axes=axes, normal=normal, position=position)
    axes.figure.colorbar(image, ax=axes, label=quantity, shrink=0.8)
    if sim.dimension == 2:
        bodies(sim, axes=axes)
        films(sim, axes=axes)
    axes.set_title(f"{quantity}, t = {sim.time:.4g}")
    return axes


def field(sim: Simulation, quantity: Quantity = "pressure", *, axes: Axes, normal: int = 1, position: float | None = None,
          **options: Any) -> AxesImage | QuadMesh:
    """The field in cells that hold fluid of the grid. 3D: on the plane across axis `normal` at `position` (default: the
    middle). `options` go to imshow (of a graded grid: pcolormesh); colours span 99 % of the values, symmetric about 0 where a quantity other than the speed has both signs.
    Raises ValueError as `state`."""
    _demand_quantity(sim, quantity)
    values = _values(sim, quantity)
    if quantity != "kind":
        values = np.where(np.isin(sim.kind, (1, 3)), values, np.nan)
    shown = [axis for axis in range(sim.dimension) if sim.dimension == 2 or axis != normal]
    if sim.dimension == 3:
        centres = sim.grid.centres(normal)
        values = values.take(len(centres) // 2 if position is None else int(np.abs(centres - position).argmin()), axis=normal)
    low, high = np.nanpercentile(values, (0.5, 99.5)) if np.isfinite(values).any() else (0.0, 1.0)
    signed = quantity not in ("speed", "kind") and low < 0 < high
    if signed:
        high = max(-low, high)
        low = -high
    if quantity == "kind":
        low, high = 0, 3
    options = {"cmap": "RdBu_r" if signed or quantity == "pressure" else "viridis", "vmin": low, "vmax": high} | options
    axes.set_xlabel("xyz"[shown[0]])
    axes.set_ylabel("xyz"[shown[1]])
    if sim.grid.places is None:
        extent = [end for axis in shown for end in sim.grid.faces(axis)[[0, -1]]]
        return axes.imshow(values.T, origin="lower", extent=extent, **options)
    x, y = (sim.grid.corners(axis) for axis in shown)
    axes.set_aspect("equal")
    return axes.pcolormesh(x, y, values.T, **options)


def bodies(sim: Simulation, *, axes: Axes, **options: Any) -> PolyCollection:
    """Outlines of the bodies, filled; 2D only. `options` go to the collection."""
    from matplotlib.collections import PolyCollection

    _demand_2d(sim)
    outlines = [outline for body in sim.bodies.values() if body.volume > 0 for outline in _outlines(*body.surface())]
    options = {"facecolors": "0.8", "edgecolors": "0.2", "linewidths": 0.8} | options
    return axes.add_collection(PolyCollection(outlines, **options), autolim=False)


def films(sim: Simulation, *, axes: Axes, **options: Any) -> LineCollection:
    """The films as lines half-way between the surfaces; 2D only. `options` go to the collection."""
    from matplotlib.collections import LineCollection

    _demand_2d(sim)
    options = {"colors": "tab:orange", "linewidths": 2.0} | options
    return axes.add_collection(LineCollection(sim.films.nodes[sim.films.elements], **options), autolim=False)


def to_vtk(sim: Simulation) -> dict[str, Any]:
    """The state as VTK objects: "fields" (vtkImageData, of a graded grid vtkRectilinearGrid, with velocity, pressure and kind in its cells), "films" (vtkPolyData)
    and "body NAME" each. PyVista takes them by `pyvista.wrap`. On several ranks the fields are this rank's."""
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonDataModel import vtkImageData, vtkRectilinearGrid

    def attach(data: Any, **arrays: np.ndarray) -> None:
        for name, values in arrays.items():
            array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
            array.SetName(name)
            data.AddArray(array)

    def along_x_first(values: np.ndarray) -> np.ndarray:
        cells = values.shape[:sim.dimension]
        return values.transpose(*reversed(range(len(cells))), *range(len(cells), values.ndim)).reshape(np.prod(cells), -1)

    grid = sim.grid
    image = vtkImageData() if grid.places is None else vtkRectilinearGrid()
    image.SetDimensions(*_three(np.subtract(grid.high, grid.low) + 1, 1).tolist())
    if grid.places is None:
        image.SetSpacing(*[grid.spacing] * 3)
        image.SetOrigin(*_three(grid.origin + grid.spacing * np.array(grid.low)))
    else:
        for axis, name in enumerate("XYZ"):
            x = grid.corners(axis) if axis < sim.dimension else np.zeros(1)
            getattr(image, f"Set{name}Coordinates")(numpy_to_vtk(np.ascontiguousarray(x), deep=True))
    attach(image.GetCellData(), velocity=_three(along_x_first(sim.velocity)), pressure=along_x_first(sim.pressure)[:, 0],
           kind=along_x_first(sim.kind)[:, 0])
    out = {"fields": image, "films": _poly_data(sim.films.nodes, sim.films.elements)}
    attach(out["films"].GetPointData(), thickness=sim.films.thickness, pressure=sim.films.pressure, void_depth=sim.films.void_depth)
    attach(out["films"].GetCellData(), velocity=_three(sim.films.velocity))
    for name, body in sim.bodies.items():
        out[f"body {name}"] = _poly_data(*body.surface())
    return out


def _demand_quantity(sim: Simulation, quantity: str) -> None:
    there = [name for name in get_args(Quantity) if sim.dimension == 3 or name != "velocity_z"]
    if quantity not in there:
        raise ValueError(f"cannot draw {quantity!r}; the quantities are: {', '.join(map(repr, there))}")


def _values(sim: Simulation, quantity: str) -> np.ndarray:
    """(*cells,)"""
    if quantity in ("pressure", "kind"):
        return getattr(sim, quantity)
    if quantity == "speed":
        return np.linalg.norm(sim.velocity, axis=-1)
    if quantity == "vorticity":
        return sim.vorticity if sim.dimension == 2 else np.linalg.norm(sim.vorticity, axis=-1)
    return sim.velocity[..., "xyz".index(quantity[-1])]


def _demand_2d(sim: Simulation) -> None:
    if sim.dimension != 2:
        raise ValueError("outlines are for 2D scenes; in 3D, to_vtk() gives surfaces")


def _outlines(vertices: np.ndarray, elements: np.ndarray) -> list[np.ndarray]:
    """Closed chains of segments (each vertex the start of one)."""
    after = dict(elements.tolist())
    outlines = []
    while after:
        chain = [next(iter(after))]
        while chain[-1] in after:
            chain.append(after.pop(chain[-1]))
        outlines.append(vertices[chain])
    return outlines


def _three(values: np.ndarray, fill: float = 0) -> np.ndarray:
    """The last axis filled up to three."""
    missing = 3 - values.shape[-1]
    return np.concatenate([values, np.full((*values.shape[:-1], missing), fill, values.dtype)], axis=-1) if missing else values


def _poly_data(points: np.ndarray, elements: np.ndarray) -> Any:
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

    coordinates = vtkPoints()
    coordinates.SetData(numpy_to_vtk(np.ascontiguousarray(_three(points)), deep=True))
    cells = vtkCellArray()
    sized = np.insert(elements.astype(np.int64), 0, elements.shape[1], axis=1)
    cells.SetCells(len(elements), numpy_to_vtkIdTypeArray(np.ascontiguousarray(sized).ravel(), deep=True))
    data = vtkPolyData()
    data.SetPoints(coordinates)
    (data.SetLines if elements.shape[1] == 2 else data.SetPolys)(cells)
    return data
