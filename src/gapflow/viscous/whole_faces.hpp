// Whole faces of cubic cells in space: one element for all of them.
#pragma once

#include <Eigen/Dense>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace gapflow {

/// In the unit square: its four vertices counterclockwise, the sides from each of them to the next, the mean.
struct UnitFace {
    static constexpr int traces = 8, size = 9;
    Eigen::Matrix<double, size, size> stiffness;
    Eigen::Matrix<double, 2, size> moment; ///< int (x - centroid) u
    /// For preconditioners: what a lattice of such faces between whole cells resists with on a face's own traces, over the roots of its diagonal, inverted.
    Eigen::Matrix<double, traces, traces> inverse;
    /// Resistance to one face's velocity, with all traces at rest and with each at the mean of the faces beside it.
    double alone, followed;
};

const UnitFace& unit_face();

/// Each has nine columns, and two moments that are columns of their own.
struct WholeFaces {
    std::vector<std::array<std::int32_t, UnitFace::size>> columns;

    int count() const { return static_cast<int>(columns.size()); }
    /// Moments of all, two a face.
    void find_moments(std::span<const double> x, std::span<double> moments) const;
    /// y += A x, and of what the moments have in y.
    void add_product(std::span<const double> x, std::span<const double> by_moments, std::span<double> y) const;
};

} // namespace gapflow
