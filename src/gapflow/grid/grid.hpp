// The MAC grid and its distribution over ranks (PETSc's DMDA).
//
// Cells are squares (cubes) of edge dx in a core; outside it, along each axis, they may be wider (method, "Graded spacing"): the grid is a
// product of its axes. A uniform grid is all core. Cells have integer indices 0 .. cells-1 on every axis; the face of cell c on its low side along an axis has the index c,
// the one on its high side c + step(axis). Fields cover this rank's cells [low, high) and `ghost` layers around them.
#pragma once

#include "gapflow/core/communicator.hpp"
#include "gapflow/core/types.hpp"

#include <petscdmda.h>

#include <algorithm>
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

/// Widths of the cells outside the core over dx, along each axis outwards from the core; empty: the core ends at the domain's side.
template <int D>
struct Grading {
    std::array<std::vector<double>, D> below, above;

    bool empty() const
    {
        bool none = true;
        for (int axis = 0; axis < D; ++axis)
            none = none && below[axis].empty() && above[axis].empty();
        return none;
    }
};

template <int D>
class Grid {
public:
    /// `cells`: all of them, the core's and those of `grading` (none along periodic axes). Throws InputError if the cells cannot be shared
    /// out over the ranks.
    Grid(const Vec<D>& origin, double dx, const Index<D>& cells, const std::array<SideKind, 2 * D>& sides, int ghost,
         const Communicator& comm, const Grading<D>& grading = {});

    /// Puts the grid where `by` from where it was constructed; 0 along periodic axes.
    void shift_to(const Vec<D>& by);

    /// Edge of the core's cells.
    double dx() const { return dx_; }
    const Vec<D>& origin() const { return origin_; }
    /// Where the corner of cell 0 would lie if all cells were as those of the core: places in the core are anchor() + dx() index.
    const Vec<D>& anchor() const { return anchor_; }
    Vec<D> size() const { return graded_ ? size_ : Vec<D>(dx_ * cells_.template cast<double>()); }
    const Index<D>& cells() const { return cells_; }
    /// Whether any cell lies outside the core.
    bool graded() const { return graded_; }
    /// The core's cells are core_low <= c < core_high.
    const Index<D>& core_low() const { return core_low_; }
    const Index<D>& core_high() const { return core_high_; }
    bool in_core(const Index<D>& c) const
    {
        return (c.array() >= core_low_.array()).all() && (c.array() < core_high_.array()).all();
    }
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

    /// Width of cell i along an axis over dx: 1 in the core; beyond the domain that of the last cell.
    double width(int axis, int i) const { return axes_->width[axis][stored(axis, i)]; }
    /// Distance over dx between the centres of the cells on the two sides of face i of an axis.
    double spread(int axis, int i) const { return axes_->spread[axis][stored(axis, i)]; }
    /// The same from index i on, for rows; valid for ghost() + 2 cells beyond the domain.
    const double* widths(int axis, int i) const { return &axes_->width[axis][stored(axis, i)]; }
    const double* spreads(int axis, int i) const { return &axes_->spread[axis][stored(axis, i)]; }
    /// Area of a face over face_area().
    double relative_area(int axis, const Index<D>& f) const
    {
        double area = 1;
        for (int k = 0; k < D && graded_; ++k)
            area *= k == axis ? 1.0 : width(k, f[k]);
        return area;
    }
    /// Volume of a cell over dx^D.
    double relative_volume(const Index<D>& c) const
    {
        double volume = 1;
        for (int k = 0; k < D && graded_; ++k)
            volume *= width(k, c[k]);
        return volume;
    }
    /// Largest width of a cell over dx along any axis, and the largest ratio of two edges of one cell.
    double largest_width() const { return largest_width_; }
    double largest_aspect() const;

    /// Position of face i of an axis, and of the centre of cell i.
    double face_place(int axis, int i) const
    {
        return in_core(axis, i) || i == core_high_[axis] ? anchor_[axis] + dx_ * i : outer_place(axis, i);
    }
    double centre_place(int axis, int i) const
    {
        return in_core(axis, i) ? anchor_[axis] + dx_ * (i + 0.5) : outer_place(axis, i) + 0.5 * dx_ * width(axis, i);
    }
    Vec<D> cell_centre(const Index<D>& c) const
    {
        if (!graded_)
            return origin_ + dx_ * (c.template cast<double>() + Vec<D>::Constant(0.5));
        Vec<D> x;
        for (int k = 0; k < D; ++k)
            x[k] = centre_place(k, c[k]);
        return x;
    }
    Vec<D> face_centre(int axis, const Index<D>& f) const
    {
        Vec<D> x = cell_centre(f);
        if (graded_)
            x[axis] = face_place(axis, f[axis]);
        else
            x -= 0.5 * dx_ * unit<D>(axis);
        return x;
    }
    /// Low corner of a cell.
    Vec<D> corner(const Index<D>& c) const
    {
        if (!graded_)
            return origin_ + dx_ * c.template cast<double>();
        Vec<D> x;
        for (int k = 0; k < D; ++k)
            x[k] = face_place(k, c[k]);
        return x;
    }
    /// Area of a face of the core (2D: length).
    double face_area() const { return D == 2 ? dx_ : dx_ * dx_; }
    /// Index of the cell that holds a point, not wrapped and not clipped.
    Index<D> cell_of(const Vec<D>& x) const
    {
        Index<D> c = ((x - anchor_) / dx_).array().floor().template cast<int>();
        for (int k = 0; k < D && graded_; ++k)
            if (!in_core(k, c[k]))
                c[k] = outer_cell(k, x[k]);
        return c;
    }
    /// Place of x in indices of a lattice with its values at whole numbers: along axis k at the faces if bit k of `faces` is set, else at
    /// the cells' centres. Linear between them.
    Vec<D> lattice_place(unsigned faces, const Vec<D>& x) const;
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
    /// The cell of the domain nearest to x, or to its image in the domain.
    Index<D> nearest_cell(Vec<D> x) const
    {
        for (int axis = 0; axis < D; ++axis) {
            const double size = this->size()[axis];
            x[axis] -= periodic(axis) ? size * std::floor((x[axis] - origin_[axis]) / size) : 0.0;
            x[axis] = std::clamp(x[axis], origin_[axis], origin_[axis] + size);
        }
        return cell_of(x).cwiseMax(0).cwiseMin(cells_ - Index<D>::Ones());
    }
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
    /// Of cells -margin_ .. cells + margin_.
    struct Axes {
        std::array<std::vector<double>, D> width, spread, place;
    };

    bool in_core(int axis, int i) const { return i >= core_low_[axis] && i < core_high_[axis]; }
    std::size_t stored(int axis, int i) const
    {
        const int last = cells_[axis] + 2 * margin_;
        return static_cast<std::size_t>(i < -margin_ ? 0 : i + margin_ > last ? last : i + margin_);
    }
    double outer_place(int axis, int i) const;
    int outer_cell(int axis, double x) const;
    void set_axes(const Grading<D>& grading);

    Vec<D> origin_, anchor_, size_;
    double dx_, largest_width_ = 1;
    bool graded_;
    int margin_;
    Index<D> core_low_, core_high_;
    std::shared_ptr<const Axes> axes_, unshifted_;
    Vec<D> unshifted_origin_, unshifted_anchor_;
    Index<D> cells_, low_, high_;
    std::array<SideKind, 2 * D> sides_;
    int ghost_;
    Communicator comm_;
    std::shared_ptr<DM> dm_;
    std::array<std::vector<int>, D> partition_;
    std::array<int, 2 * D> neighbours_;
};

/// Grid::spread across the faces normal to `axis` in a row along the first axis, from `first` on.
template <int D>
class SpreadRow {
public:
    SpreadRow(const Grid<D>& grid, int axis, const Index<D>& first)
        : values_(axis == 0 ? grid.spreads(0, first[0]) : nullptr), value_(grid.spread(axis, first[axis]))
    {
    }
    double operator[](int i) const { return values_ ? values_[i] : value_; }

private:
    const double* values_;
    double value_;
};

} // namespace gapflow
