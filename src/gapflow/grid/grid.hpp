// The uniform MAC grid and its distribution over ranks (PETSc's DMDA).
//
// Cells have integer indices 0 .. cells-1 on every axis; the face of cell c on its low side along an axis has the index c,
// the one on its high side c + step(axis). Fields cover this rank's cells [low, high) and `ghost` layers around them.
#pragma once

#include "gapflow/core/communicator.hpp"
#include "gapflow/core/types.hpp"

#include <petscdmda.h>

#include <array>
#include <cmath>
#include <memory>
#include <vector>

namespace gapflow {

/// Boundary condition on a side of the domain. Far: the fluid goes on without end.
enum class SideKind { wall, open, periodic, inflow, far };

/// Whether fluid passes a side as the pressure wants.
inline bool is_open(SideKind kind)
{
    return kind == SideKind::open || kind == SideKind::far;
}

template <int D>
class Grid {
public:
    /// Throws InputError if the cells cannot be shared out over the ranks.
    Grid(const Vec<D>& origin, double dx, const Index<D>& cells, const std::array<SideKind, 2 * D>& sides, int ghost,
         const Communicator& comm);

    double dx() const { return dx_; }
    const Vec<D>& origin() const { return origin_; }
    Vec<D> size() const { return dx_ * cells_.template cast<double>(); }
    const Index<D>& cells() const { return cells_; }
    /// Kind of the low (end = 0) or high (end = 1) side of an axis.
    SideKind side(int axis, int end) const { return sides_[2 * axis + end]; }
    bool periodic(int axis) const { return side(axis, 0) == SideKind::periodic; }
    int ghost() const { return ghost_; }
    const Communicator& comm() const { return comm_; }
    DM dm() const { return *dm_; }

    /// This rank's cells are low <= c < high.
    const Index<D>& low() const { return low_; }
    const Index<D>& high() const { return high_; }
    long owned_cells() const { return (high_ - low_).template cast<long>().prod(); }
    bool owns(const Index<D>& c) const { return (c.array() >= low_.array()).all() && (c.array() < high_.array()).all(); }
    /// Number of ranks along each axis, and where each starts (one more entry: the end).
    const std::array<std::vector<int>, D>& partition() const { return partition_; }
    /// Rank across the low (end = 0) or high side of this rank's block along an axis; -1: none.
    int neighbour(int axis, int end) const { return neighbours_[2 * axis + end]; }

    Vec<D> cell_centre(const Index<D>& c) const { return origin_ + dx_ * (c.template cast<double>() + Vec<D>::Constant(0.5)); }
    Vec<D> face_centre(int axis, const Index<D>& f) const { return cell_centre(f) - 0.5 * dx_ * unit<D>(axis); }
    /// Area of a face (2D: length).
    double face_area() const { return D == 2 ? dx_ : dx_ * dx_; }
    /// Index of the cell that holds a point, not wrapped and not clipped.
    Index<D> cell_of(const Vec<D>& x) const { return ((x - origin_) / dx_).array().floor().template cast<int>(); }
    /// The same cell within 0 .. cells-1 along periodic axes.
    Index<D> wrapped(Index<D> c) const
    {
        for (int axis = 0; axis < D; ++axis)
            if (periodic(axis))
                c[axis] = ((c[axis] % cells_[axis]) + cells_[axis]) % cells_[axis];
        return c;
    }
    /// A way from one point to another, or to that one's nearest image.
    Vec<D> nearest_image(Vec<D> way) const
    {
        for (int axis = 0; axis < D; ++axis)
            if (periodic(axis))
                way[axis] -= size()[axis] * std::round(way[axis] / size()[axis]);
        return way;
    }
    bool in_domain(const Index<D>& c) const { return (c.array() >= 0).all() && (c.array() < cells_.array()).all(); }
    /// Number of a cell in the whole grid, first axis fastest (a key for maps).
    long key(const Index<D>& c) const
    {
        long k = c[D - 1];
        for (int axis = D - 2; axis >= 0; --axis)
            k = k * cells_[axis] + c[axis];
        return k;
    }
    Index<D> cell_of_key(long key) const
    {
        Index<D> c;
        for (int axis = 0; axis < D; ++axis) {
            c[axis] = static_cast<int>(key % cells_[axis]);
            key /= cells_[axis];
        }
        return c;
    }

private:
    Vec<D> origin_;
    double dx_;
    Index<D> cells_, low_, high_;
    std::array<SideKind, 2 * D> sides_;
    int ghost_;
    Communicator comm_;
    std::shared_ptr<DM> dm_;
    std::array<std::vector<int>, D> partition_;
    std::array<int, 2 * D> neighbours_;
};

} // namespace gapflow
