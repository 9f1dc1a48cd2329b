// Added masses of two boxes of 16 x 8 cells in a box of 64 x 64 cells.
#pragma once

#include "../grid/scenes.hpp"
#include "direct_mass.hpp"

#include "gapflow/coupling/parts.hpp"

#include <array>

namespace gapflow::testing {

inline Grid<2> grid_of_boxes()
{
    return unit_grid<2>(64);
}

/// The upper and the lower one.
inline Scene<2> two_boxes(const Grid<2>& grid, const std::array<Pose<2>, 2>& at)
{
    Scene<2> scene(grid);
    for (int k = 0; k < 2; ++k) {
        scene.add(k == 0 ? "upper" : "lower", make_box<2>(grid.dx() * Vec<2>(16, 8)), at[k]);
        scene.solids.back().motion = Motion::free;
    }
    return scene;
}

/// At density 1.
template <int D>
Eigen::MatrixXd mass_on_parts(const Grid<D>& grid, const std::vector<Solid<D>>& solids)
{
    const Complex<D> complex = build_complex<D>(grid, solids);
    const Inertia<D> inertia =
        find_inertia<D>(grid, complex, find_gap_arms<D>(grid, solids, complex), find_mouth_arms<D>(grid, solids, complex));
    const std::vector<TwistMatrix<D>> mass(solids.size(), TwistMatrix<D>::Identity());
    return direct_added_mass(couple_parts<D>(grid, solids, mass, 1.0, complex, inertia));
}

/// By twists in radii of the boxes, over the mass of the fluid that one displaces.
inline Eigen::MatrixXd mass_of_boxes(const Grid<2>& grid, const std::vector<Solid<2>>& solids)
{
    const double dx = grid.dx();
    Eigen::MatrixXd M = mass_on_parts(grid, solids);
    for (const int spin : {2, 5}) {
        M.row(spin) /= 8 * dx;
        M.col(spin) /= 8 * dx;
    }
    return M / (128 * dx * dx);
}

/// The largest difference, over the roots of the second one's diagonal.
inline double mass_difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
    const Eigen::VectorXd scale = b.diagonal().cwiseSqrt().cwiseInverse();
    return (scale.asDiagonal() * (a - b) * scale.asDiagonal()).cwiseAbs().maxCoeff();
}

} // namespace gapflow::testing
