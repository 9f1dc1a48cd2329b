// Which cells hold film, and which grid faces films close (method, "Cells and faces").
//
// The same on every rank: each classifies the cells of its block, and all get the result.
#pragma once

#include "gapflow/film/face_cache.hpp"
#include "gapflow/film/film_set.hpp"
#include "gapflow/film/key_map.hpp"
#include "gapflow/grid/inline_vector.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace gapflow {

enum class CellKind : std::int8_t { solid, bulk, film, mixed };

/// A film that passes through a cell.
template <int D>
struct Touch {
    int film;
    double measure;  ///< of the quadrature points whose gap segment passes through; 0: the cell was given to the film
    Index<D> offset; ///< from the cell in the domain to where the film is, in cells (periodic domains)
};

template <int D>
struct FilmCell {
    CellKind kind = CellKind::bulk;
    int owner = -1;                    ///< film; of mixed cells the one that touches it most
    InlineVector<Touch<D>, 2> touches; ///< the one with the largest measure first

    /// Of a film's touch, rounded: films that touch the cell alike do so whatever the round-off.
    float touched_by(int film) const
    {
        float sum = 0;
        for (const Touch<D>& touch : touches)
            if (touch.film == film)
                sum += static_cast<float>(touch.measure);
        return sum;
    }

    /// From the cell in the domain to where a film (one of `touches`) is.
    Index<D> offset(int film) const
    {
        for (const Touch<D>& touch : touches)
            if (touch.film == film)
                return touch.offset;
        return touches.empty() ? Index<D>(Index<D>::Zero()) : touches[0].offset;
    }
};

template <int D>
struct FilmCells {
    KeyMap<FilmCell<D>> cells; ///< by Grid::key, in order: touched cells and those that became film
    KeyMap<int> closed;        ///< FaceCache::key of closed faces -> film

    CellKind kind(long key, CellKind otherwise) const
    {
        const FilmCell<D>* cell = cells.find(key);
        return cell ? cell->kind : otherwise;
    }
};

/// A face of a cell: which, and the cell beyond it (key -1: outside the domain).
template <int D>
struct CellSide {
    int axis, end;
    Index<D> face;
    Index<D> cell;
    bool inside; ///< the cell beyond lies in the domain
};

/// The 2 D sides of a cell; indices are not wrapped.
template <int D>
std::array<CellSide<D>, 2 * D> sides_of(const Grid<D>& grid, const Index<D>& cell);

/// The gaps of films: tests whether points lie in them.
template <int D>
class FilmGaps {
public:
    FilmGaps(const Grid<D>& grid, std::span<const Solid<D>> solids, std::span<const Film<D>> films);

    /// Does the point lie in the film's gap? x is next to the film (not wrapped).
    bool holds(int film, const Vec<D>& x) const
    {
        return in_gap<D>(solids_[films_[film].pair.master].shape, others_[film], x, films_[film].threshold);
    }
    std::span<const Film<D>> films() const { return films_; }
    const PlacedShape<D>& master(int film) const { return solids_[films_[film].pair.master].shape; }
    const PlacedShape<D>& other(int film) const { return others_[film]; }

private:
    std::span<const Solid<D>> solids_;
    std::span<const Film<D>> films_;
    std::vector<PlacedShape<D>> others_;
};

/// Cells that the segment x..y passes through, exact traversal; not wrapped.
template <int D>
void cells_on_segment(const Grid<D>& grid, const Vec<D>& x, const Vec<D>& y, std::vector<Index<D>>& result);

/// Classifies the cells of all films (method, "Cells and faces", without pockets). Collective.
template <int D>
FilmCells<D> classify_cells(const FaceCache<D>& faces, const FilmGaps<D>& gaps);

/// Finds the faces that films close; to be called again after cells changed kind. Collective.
template <int D>
void close_faces(const FaceCache<D>& faces, const FilmGaps<D>& gaps, FilmCells<D>& cells);

template <int D>
class CellStates;

/// Turns small components of the grid that touch a film and that no mouth reaches into film; `reached` are the keys of
/// cells in mouths' stencils, `states` those of `cells`. Returns the keys of the cells that changed (close_faces and the mouths must then
/// be redone). Collective.
template <int D>
std::vector<long> absorb_pockets(const FaceCache<D>& faces, const CellStates<D>& states, const std::vector<long>& reached,
                                 FilmCells<D>& cells);

} // namespace gapflow
