// Volume of a solid as the planes of the grid see it, and the mass D that makes uniform motion exact (theory, "Energy").
//
// The planes normal to axis d see the volume V_d of a solid, with the centroid c_d. In a fluid that moves with a uniform velocity the
// pressure is linear, and the impulse of a solid with the volume V and the centroid c is that of the fluid it displaces if
//
//     D = sum_d V_d w_d(c_d) w_d(c_d)^T - V w_d(c) w_d(c)^T,    w_d(x) = (e_d, (x - r) x e_d),
//
// r the reference point of its twist: w_d . twist is the velocity along d of a point that moves with the solid. To the block of two rotations comes what
// seen_rotation.hpp gives.
#pragma once

#include "gapflow/complex/area_derivative.hpp"
#include "gapflow/complex/complex.hpp"
#include "gapflow/complex/placed.hpp"

namespace gapflow {

/// From a solid's reference point to the middle of a cell; along a periodic axis the short way.
template <int D>
Vec<D> way_from(const Grid<D>& grid, const GridPlanes<D>& planes, const Vec<D>& reference, const Index<D>& cell);

/// D of a solid.
template <int D>
TwistMatrix<D> seen_mass(const SeenSolid<D>& seen);

/// Derivative of 1/2 V . D V at a fixed twist V: by the solid's place and angle, and by the area vectors S of its walls as
/// sum by_walls . (x - reference) S, component by component, x the middle of the wall's cell.
template <int D>
struct SeenEnergyRate {
    Twist<D> by_place = Twist<D>::Zero();
    Vec<D> by_walls = Vec<D>::Zero();
};
template <int D>
SeenEnergyRate<D> half_square_rate(const SeenRate<D>& rate, const Twist<D>& V);

/// D of each solid; of unbounded ones 0. `derivatives`: fills the rates; null: not wanted.
template <int D>
std::vector<TwistMatrix<D>> seen_masses(const Grid<D>& grid, const GridPlanes<D>& planes, std::span<const Solid<D>> solids,
                                        const std::vector<PlacedSolid<D>>& placed, const Complex<D>& complex,
                                        FaceDerivatives<D>* derivatives);

} // namespace gapflow
