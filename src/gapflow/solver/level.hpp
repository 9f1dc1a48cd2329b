// One level of the geometric multigrid: coefficients and vectors of a block of cells, in single precision.
#pragma once

#include "gapflow/coupling/system.hpp"
#include "gapflow/solver/halo.hpp"

#include <array>
#include <vector>

namespace gapflow {

template <int D>
struct Level {
    Index<D> cells;                  ///< of the whole level
    Index<D> low, high;              ///< the cells of this rank; all of them once the level is gathered
    Index<D> finest_cells;           ///< of the finest level
    Index<D> unit;                   ///< width of a cell along each axis in cells of the finest level; the last may be narrower
    std::array<bool, D> periodic;
    std::array<int, 2 * D> neighbours;
    Block<D> block;                  ///< what is stored: one ghost layer around low .. high
    std::array<std::vector<float>, D> conductance; ///< of each cell's low face; on all faces of this rank's cells
    std::vector<float> inverse_diagonal;           ///< 0: no unknown here
    std::vector<float> x, b;                       ///< correction, right-hand side
    /// Relaxation weight of each cell of a row: [row on a seam][parity of the first axis' index]. 0: other colour.
    std::array<std::array<std::vector<float>, 2>, 2> weight;
    Halo<D, float> halo;

    /// Width of a cell along an axis, in cells of the finest level.
    int width(int axis, int i) const { return std::min(unit[axis], finest_cells[axis] - i * unit[axis]); }
    /// Distance across face i of an axis between the pressures that it joins; to the face itself at the domain's end.
    double distance(int axis, int i) const;
    /// An odd number of cells around a periodic axis: its first and last cell have the same colour.
    bool seam(int axis) const { return periodic[axis] && cells[axis] > 1 && cells[axis] % 2 == 1; }
    bool on_seam(int axis, int i) const { return seam(axis) && (i == 0 || i == cells[axis] - 1); }
    /// Whether the next level halves the cells along the axis.
    bool halves(int axis) const { return cells[axis] > 1; }
    long bytes() const;
};

/// The finest level: the system's conductances times `scale`.
template <int D>
Level<D> finest_level(const CoupledSystem<D>& system, double scale);

/// Whether this rank's block can be halved with all the others.
template <int D>
bool can_halve(const Level<D>& level, const Grid<D>& grid);

/// The next level on the same ranks. A face's coefficient is the sum of its fine faces' times the ratio of the distances
/// across them: half the Galerkin operator of piecewise constant transfer away from the ends.
template <int D>
Level<D> coarsened(const Level<D>& fine, const Communicator& comm);

/// Storage, inverse diagonal and weights for a level whose cells and conductances (or the want of them) are known.
template <int D>
void allocate(Level<D>& level, const Communicator& comm);
template <int D>
void finish(Level<D>& level);

/// The same level with all cells on every rank. Collective.
template <int D>
Level<D> gathered(const Level<D>& part, const Communicator& comm);

} // namespace gapflow
