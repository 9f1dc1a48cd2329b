// One level of the geometric multigrid: coefficients and vectors of a block of cells, in single precision.
#pragma once

#include "gapflow/coupling/system.hpp"
#include "gapflow/solver/halo.hpp"
#include "gapflow/solver/shared_rows.hpp"

#include <array>
#include <vector>

namespace gapflow {

/// What a level of these cells stores: one layer of ghosts around them.
template <int D>
Block<D> block_of_level(const Index<D>& low, const Index<D>& high)
{
    return Block<D>(low - Index<D>::Ones(), high + Index<D>::Ones());
}

template <int D>
struct Level {
    Index<D> cells;                           ///< of the whole level
    Index<D> low, high;                       ///< the cells of this rank; all of them once the level is gathered
    bool graded = false;                      ///< of a grid whose cells differ in width
    double target = 1;                        ///< width over dx that merging cells have come to
    std::array<std::vector<double>, D> width; ///< of the level's cells along each axis, over dx
    std::array<std::vector<int>, D> finest;   ///< first cell of the finest level in each cell; one more entry: their number
    std::array<std::vector<int>, D>
        partition; ///< where the ranks' blocks start along each axis; one more entry: the number of cells
    std::array<std::vector<int>, D> parent; ///< cell of the next level that each cell belongs to
    std::array<bool, D> periodic;
    std::array<int, 2 * D> neighbours;
    Block<D> block;                               ///< what is stored: block_of_level(low, high)
    std::array<SharedRows<float>, D> conductance; ///< of each cell's low face, by row_number; on all faces of this rank's cells
    SharedRows<float> inverse_diagonal;           ///< 0: no unknown here
    LargeVector<float> x, b;                      ///< correction, right-hand side
    /// Relaxation weight of each cell of a row: [row on a seam][parity of the first axis' index]. 0: other colour.
    std::array<std::array<std::vector<float>, 2>, 2> weight;
    Halo<D, float> halo;

    /// Distance over dx across face i of an axis between the pressures that it joins; to the face itself at the domain's end.
    double distance(int axis, int i) const;
    /// Whether the cells of this rank along the axis are pairs of the next level, from the first on.
    bool in_pairs(int axis) const;
    /// An odd number of cells around a periodic axis: its first and last cell have the same colour.
    bool seam(int axis) const { return periodic[axis] && cells[axis] > 1 && cells[axis] % 2 == 1; }
    bool on_seam(int axis, int i) const { return seam(axis) && (i == 0 || i == cells[axis] - 1); }
    /// Number of the row that holds a cell among the block's rows along the first axis.
    long row_number(const Index<D>& c) const
    {
        long row = c[D - 1] - block.low[D - 1];
        for (int axis = D - 2; axis > 0; --axis)
            row = row * (block.high[axis] - block.low[axis]) + (c[axis] - block.low[axis]);
        return row;
    }
    /// Increase of a row's number by a step along an axis other than the first.
    long row_stride(int axis) const { return block.stride[axis] / block.stride[1]; }
    float face(int axis, const Index<D>& f) const { return conductance[axis].value(row_number(f), f[0] - low[0]); }
    float inverse(const Index<D>& c) const { return inverse_diagonal.value(row_number(c), c[0] - low[0]); }
    long bytes() const;
};

/// The coefficients of a chunk of cells of a row: conductances of the low and high faces normal to axes 1 and 2.
template <int D>
struct Stencil {
    const float *a0, *inverse;
    std::array<const float*, D - 1> below, above;

    Stencil(const Level<D>& level, long row, int c) : a0(level.conductance[0](row, c)), inverse(level.inverse_diagonal(row, c))
    {
        for (int axis = 1; axis < D; ++axis) {
            below[axis - 1] = level.conductance[axis](row, c);
            above[axis - 1] = level.conductance[axis](row + level.row_stride(axis), c);
        }
    }
};

/// Conductances of the system's faces on this rank's block, by Level::row_number of a block with one layer of ghosts;
/// `with_films`: with those that its film_faces would have on the grid, as far as links let flow pass there.
template <int D>
std::array<SharedRows<double>, D> shared_conductances(const CoupledSystem<D>& system, bool with_films = false);

/// The finest level: the system's conductances times `scale`.
template <int D>
Level<D> finest_level(const CoupledSystem<D>& system, const std::array<SharedRows<double>, D>& conductance, double scale);

/// Whether this rank's block can be coarsened with all the others.
template <int D>
bool can_coarsen(const Level<D>& level);

/// The next level on the same ranks; sets fine.parent. Neighbours merge in pairs; on a graded grid those that stay narrow enough, so that
/// coarser levels become uniform. A face's coefficient is the sum of its fine faces' times the ratio of the distances across them: half the
/// Galerkin operator of piecewise constant transfer away from the ends. `grid`: the finest level's.
template <int D>
Level<D> coarsened(Level<D>& fine, const Grid<D>& grid);

/// Storage, inverse diagonal and weights for a level whose cells and conductances (possibly none) are known.
template <int D>
void allocate(Level<D>& level, const Communicator& comm);
template <int D>
void finish(Level<D>& level);

/// The same level with all cells on every rank, as one block. Collective.
template <int D>
Level<D> gathered(const Level<D>& part, const Communicator& comm);

} // namespace gapflow
