// Preconditioner of one component of the viscous system: a V-cycle of geometric multigrid on this rank's lattice points,
//
//     (m + w + sum links) x_i - sum links x_j = b_i,     m: mass, w: edges to walls (and to other ranks' points).
//
// Pairs of points along every axis make a coarse one (on graded grids those that are narrow enough, see solver/merging), with constant
// transfer; coarse links and wall edges carry half of what Galerkin's product gives (as in the pressure's multigrid: piecewise constants make it twice too stiff), masses all of it.
// Smoother: red-black Gauss-Seidel V(2,2), colours in reverse on the way up, so the cycle is symmetric and positive definite.
// Levels end where masses dominate.
#pragma once

#include "gapflow/viscosity/viscous_system.hpp"

#include <vector>

namespace gapflow {

template <int D>
class ViscousMultigrid {
public:
    ViscousMultigrid(const ViscousSystem<D>& system, int axis);
    /// z = one cycle for r, on this rank's active points.
    void cycle(const CellField<D>& r, CellField<D>& z);

private:
    struct Level {
        Index<D> count;                           ///< points along each axis
        std::array<std::vector<double>, D> width; ///< of the fluid around the points along each axis, over dx
        std::array<std::vector<int>, D> parent;   ///< point of the next level that each belongs to along each axis
        Block<D> block;                           ///< with a layer of zeros (periodic: copies) around them
        std::array<LargeVector<float>, D> link;   ///< to the next point along an axis
        LargeVector<float> inverse_diagonal, x, b;
    };
    struct Masses {
        LargeVector<float> mass, wall;
    };

    Level finest(const ViscousSystem<D>& system, int axis, Masses& masses) const;
    Level coarsened(Level& fine, double target, const Masses& fine_masses, Masses& masses) const;
    void set_diagonal(Level& level, const Masses& masses) const;
    void copy_around(const Level& level, LargeVector<float>& field) const;
    void smooth(Level& level, int colour) const;
    void restrict_residual(Level& fine, Level& coarse) const;
    void prolong(const Level& coarse, Level& fine) const;
    void descend(std::size_t l);

    const Grid<D>& grid_;
    Index<D> low_;
    std::array<bool, D> wraps_; ///< periodic within this rank
    std::vector<Level> levels_;
    const ViscousSystem<D>& system_;
    int axis_;
};

} // namespace gapflow
