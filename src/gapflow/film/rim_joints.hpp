// Ties films where their rims meet (method, "Mouths and joints").
#pragma once

#include "gapflow/film/mouths.hpp"
#include "gapflow/film/rim_points.hpp"

namespace gapflow {

/// Number of a cell in the domain or outside (rims lie on walls, to round-off).
template <int D>
long cell_number(const Index<D>& cell)
{
    long k = 0;
    for (int axis = 0; axis < D; ++axis)
        k = (k << 21) + cell[axis];
    return k;
}

/// Finds the rims of other films near a point of a rim.
template <int D>
class RimJoints {
public:
    /// `films` and `points` must last.
    RimJoints(const Grid<D>& grid, std::span<const Film<D>> films, const std::vector<RimPoint<D>>& points);

    /// Ties the point to the nearest rim of other films within factor * (h + h_other) + reach. 2D: to the nearest end of every
    /// film there, for tied to both ends of one it would lead around that film. Whether there is one.
    bool add(const RimPoint<D>& point, double factor, double reach, std::vector<Joint<D>>& joints) const;

private:
    /// The points in a cell.
    struct Bin {
        std::vector<int> points;
        double h = 0, edge = 0; ///< the largest thickness, and length of their edges
    };
    double distance_to_cell(const Vec<D>& x, const Index<D>& cell) const;
    Vec<D> towards(const Vec<D>& x, const RimPoint<D>& other) const;
    bool near(const Vec<D>& x, const RimPoint<D>& other, double reach) const;
    double distance_to_rim(const Vec<D>& x, const RimPoint<D>& other, std::array<double, D - 1>& shape) const;
    Joint<D> tie(const RimPoint<D>& a, const RimPoint<D>& b, const std::array<double, D - 1>& shape_b) const;

    const Grid<D>& grid_;
    std::span<const Film<D>> films_;
    const std::vector<RimPoint<D>>& points_;
    KeyMap<Bin> bins_; ///< by the cell
    double largest_h_ = 0, longest_edge_ = 0;
};

} // namespace gapflow
