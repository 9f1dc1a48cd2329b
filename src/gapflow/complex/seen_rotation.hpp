// What the planes of the grid miss of a solid that turns (theory of the complex, "Energy").
//
// The sum over the planes normal to d less the integral over the solid is an integral over its surface, with the sawtooth sigma(x_d), which falls from 1/2 to
// -1/2 at each plane. Of the velocity of the fluid at a wall that turns with the velocity omega about c the part along the normal n is known:
//
//     S = - sum_d int sigma(x_d) n_d (u^2 - 1/12 sum_(t != d) (du/dx_t)^2) dS,   u = n . omega x (x - c)
//
// on flat walls: a face has one velocity, whose square lacks the variance of u within it.
#pragma once

#include "gapflow/complex/area_derivative.hpp"
#include "gapflow/complex/window.hpp"

#include <array>

namespace gapflow {

/// S by omega of the surface within the window (null: of all). `c`: the solid's centroid, in cells. Of solids whose surface is round in 3D zero.
template <int D>
SpinMatrix<D> seen_rotation(const PlacedSolid<D>& solid, const Vec<D>& c, const Window<D>* window = nullptr);

/// Its derivative by the solid's twist; `c` moves with the solid and by `by_twist` more.
template <int D>
std::array<SpinMatrix<D>, twist_size<D>>
seen_rotation_rate(const PlacedSolid<D>& solid, const Vec<D>& c, const Window<D>* window = nullptr,
                   const Eigen::Matrix<double, D, twist_size<D>>& by_twist = Eigen::Matrix<double, D, twist_size<D>>::Zero());

} // namespace gapflow
