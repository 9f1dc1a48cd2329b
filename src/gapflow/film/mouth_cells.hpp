// The faces that films close, and the cells behind those at a mouth (method, "Mouths and joints", "Films of viscous fluid").
#pragma once

#include "gapflow/core/threads.hpp"
#include "gapflow/film/mouths.hpp"

#include <span>
#include <vector>

namespace gapflow {

/// A face that a film closes, seen from a cell beside the film.
template <int D>
struct ClosedArea {
    long key;    ///< of the cell
    Vec<D> x;    ///< centroid of its open part, in the film's frame
    Vec<D> area; ///< normal times open area, out of the cell
};

/// A face that a film closes, seen from a cell beside it that is not the film's own.
template <int D>
struct ClosedFace {
    int film;
    ClosedArea<D> area;
    Index<D> offset; ///< of the film's frame, in cells
};

/// Those seen from cells whose key `counts`, in the order of the film cells beside them.
template <int D, class Counts>
std::vector<ClosedFace<D>> closed_faces(const Grid<D>& grid, const FilmNetwork<D>& network, Counts&& counts)
{
    const FilmCells<D>& cells = network.cells;
    const FaceCache<D>& faces = *network.faces;
    return items_of<ClosedFace<D>>(static_cast<long>(cells.cells.size()), [&](long i, std::vector<ClosedFace<D>>& found) {
        const auto& [key, cell] = cells.cells.item(static_cast<int>(i));
        for (const CellSide<D>& side : sides_of(grid, grid.cell_of_key(key))) {
            const int* closed = side.inside ? cells.closed.find(faces.key(side.axis, side.face)) : nullptr;
            if (!closed)
                continue;
            const long beyond = grid.key(grid.wrapped(side.cell));
            const bool here = !(cell.kind == CellKind::film && cell.owner == *closed) && counts(key);
            const bool there = !cells.cells.contains(beyond) && counts(beyond);
            if (!here && !there) // faces far from this rank's block are not known to it
                continue;
            const Index<D> offset = cell.offset(*closed);
            const Vec<D> x = faces.open_centroid(side.axis, side.face) + grid.dx() * offset.template cast<double>();
            const Vec<D> area = (2 * side.end - 1) * faces.open(side.axis, side.face) * grid.face_area() * unit<D>(side.axis);
            if (here)
                found.push_back({*closed, {key, x, area}, offset});
            if (there)
                found.push_back({*closed, {beyond, x, -area}, offset});
        }
    });
}

/// The faces that each film closes, from all cells that are no film's.
template <int D>
std::vector<std::vector<ClosedArea<D>>> closed_areas(const Grid<D>& grid, const FilmNetwork<D>& network);

/// Of each film, the places of its mouths that lead to cells.
template <int D>
std::vector<std::vector<Vec<D>>> mouth_places(const FilmNetwork<D>& network);

/// The cell gets the share weight + lean of the flux that the master drags out of a mouth, weight - lean of the other wall's. Weights sum to 1, leans to 0.
struct CarriedCell {
    long key;
    double weight, lean;
};

/// The cells behind the faces that the film closes at a smooth mouth, each face by its area across the film and by the share that either wall has of
/// linear flow there. Empty where other films close most of the mouth. `places`: of all of the film's mouths; each face belongs to the nearest.
template <int D>
std::vector<CarriedCell> cells_behind(const Mouth<D>& mouth, const Film<D>& film, std::span<const ClosedArea<D>> closed,
                                      std::span<const Vec<D>> places, double dx);

/// The cells of the mouth's pressure. The flux that a wall drags out of a smooth mouth thicker than two cells falls linearly towards the other wall.
template <int D>
std::vector<CarriedCell> cells_around(const Grid<D>& grid, const Mouth<D>& mouth, const Film<D>& film);

} // namespace gapflow
