// What cells are and how they are open once films have closed their faces.
#pragma once

#include "gapflow/film/film_cells.hpp"

#include <atomic>
#include <cstdint>
#include <vector>

namespace gapflow {

// Open fractions below this do not count.
constexpr double negligible_opening = 1e-12;

/// Kind of any cell of the domain, near films or not.
template <int D>
CellKind kind_of(const FaceCache<D>& faces, const FilmCells<D>& cells, const Index<D>& cell);

/// Open fraction of a face after films have closed theirs.
template <int D>
double open_after_closing(const FaceCache<D>& faces, const FilmCells<D>& cells, int axis, const Index<D>& face);

template <int D>
struct CellState {
    CellKind kind;
    unsigned open;   ///< bit 2 axis + end: that face is open and leads to another cell of the domain
    bool leads_out;  ///< a face is open and leads out of the domain
    double aperture; ///< sum of open fractions
};

/// States of cells, found when first asked for and kept, for the cells of this rank and two around them. Threads may ask at once.
template <int D>
class CellStates {
public:
    /// The faces that films close are known; both must outlive it, unchanged.
    CellStates(const FaceCache<D>& faces, const FilmCells<D>& cells);
    /// The cell may lie outside the domain along periodic axes.
    CellState<D> operator()(const Index<D>& cell) const;
    const Grid<D>& grid() const { return faces_.grid(); }

private:
    CellState<D> find(const Index<D>& cell) const;

    const FaceCache<D>& faces_;
    const FilmCells<D>& cells_;
    Block<D> block_;
    /// A known cell's kind, whether it leads out, and its open faces, with a bit that says that it is known; its aperture is stored before.
    mutable std::vector<std::atomic<std::uint16_t>> known_;
    mutable std::vector<std::atomic<double>> apertures_;
};

} // namespace gapflow
