// Which cells hold film, and which grid faces films close (method, section 3.2).
//
// The same on every rank: cells near films are classified from clipped faces that any rank can compute.
#pragma once

#include "gapflow/film/film_set.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <unordered_map>
#include <vector>

namespace gapflow {

enum class CellKind : std::int8_t { solid, bulk, film, mixed };

/// Clipped faces near films, computed when first asked for. Indices may lie outside the domain along periodic axes.
template <int D>
class FaceCache {
public:
    FaceCache(const Grid<D>& grid, const FaceClipper<D>& clipper) : grid_(&grid), clipper_(&clipper) {}

    const ClippedFace<D>& face(int axis, const Index<D>& f) const;
    /// Centroid of the open piece that holds the face's deepest point, next to the index asked for.
    Vec<D> open_point(int axis, const Index<D>& f) const;
    /// Displacement of the index asked for from the one that is stored.
    Vec<D> displacement(const Index<D>& f) const;
    long key(int axis, const Index<D>& f) const;
    const Grid<D>& grid() const { return *grid_; }

private:
    struct Entry {
        ClippedFace<D> parts;
        Vec<D> open_point;
        bool has_open_point = false;
    };
    Entry& entry(int axis, const Index<D>& f) const;
    Index<D> stored(const Index<D>& f) const;

    const Grid<D>* grid_;
    const FaceClipper<D>* clipper_;
    mutable std::unordered_map<long, Entry> entries_;
};

/// A film that passes through a cell.
template <int D>
struct Touch {
    int film;
    int points;      ///< quadrature points whose gap segment passes through
    Index<D> offset; ///< from the cell in the domain to where the film is, in cells (periodic domains)
};

template <int D>
struct FilmCell {
    CellKind kind = CellKind::bulk;
    int owner = -1;             ///< film; of mixed cells the one with most points
    std::vector<Touch<D>> touches; ///< most points first

    /// From the cell in the domain to where a film (one of `touches`) is.
    Index<D> offset(int film) const
    {
        for (const Touch<D>& touch : touches)
            if (touch.film == film)
                return touch.offset;
        return touches.empty() ? Index<D>(Index<D>::Zero()) : touches.front().offset;
    }
};

template <int D>
struct FilmCells {
    std::map<long, FilmCell<D>> cells;          ///< by Grid::key: touched cells and those that became film
    std::unordered_map<long, int> closed;       ///< FaceCache::key of closed faces -> film

    CellKind kind(long key, CellKind otherwise) const
    {
        auto it = cells.find(key);
        return it == cells.end() ? otherwise : it->second.kind;
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

/// Does the point lie in the film's gap? x is next to the film (not wrapped).
template <int D>
bool in_film_gap(const Grid<D>& grid, std::span<const Solid<D>> solids, const Film<D>& film, const Vec<D>& x);

/// Cells that the segment x..y passes through, exact traversal; not wrapped.
template <int D>
void cells_on_segment(const Grid<D>& grid, const Vec<D>& x, const Vec<D>& y, std::vector<Index<D>>& result);

/// Classifies the cells of all films (section 3.2, item 4, without pockets).
template <int D>
FilmCells<D> classify_cells(const FaceCache<D>& faces, std::span<const Solid<D>> solids, std::span<const Film<D>> films);

/// Finds the faces that films close (item 5); to be called again after cells changed kind.
template <int D>
void close_faces(const FaceCache<D>& faces, std::span<const Solid<D>> solids, std::span<const Film<D>> films, FilmCells<D>& cells);

/// Turns small components of the grid that touch a film and that no conduit reaches into film; `reached` are the keys of
/// cells that conduits draw on. Returns whether any cell changed (close_faces and the conduits must then be redone).
template <int D>
bool absorb_pockets(const FaceCache<D>& faces, const std::vector<long>& reached, FilmCells<D>& cells);

/// Kind of any cell of the domain, near films or not.
template <int D>
CellKind kind_of(const FaceCache<D>& faces, const FilmCells<D>& cells, const Index<D>& cell);

/// Open fraction of a face after films have closed theirs.
template <int D>
double open_after_closing(const FaceCache<D>& faces, const FilmCells<D>& cells, int axis, const Index<D>& face);

} // namespace gapflow
