// Multilinear interpolation of face velocities.
#pragma once

#include "gapflow/grid/field.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {

/// Value of the velocity component normal to `axis` at x, linear in every axis between faces; x is clamped to the field's
/// block. Ghosts must be filled.
template <int D>
double interpolate_face(const Grid<D>& grid, const CellField<D>& component, int axis, const Vec<D>& x)
{
    const Block<D>& block = component.block();
    const Vec<D> place = grid.graded() ? Vec<D>(grid.lattice_place(1u << axis, x) - block.low.template cast<double>())
                                       : Vec<D>((x - grid.face_centre(axis, block.low)) / grid.dx());
    long corner = 0;
    Vec<D> f;
    for (int k = 0; k < D; ++k) {
        const double p = std::clamp(place[k], 0.0, static_cast<double>(block.high[k] - block.low[k] - 1) - 1e-9);
        const int i = static_cast<int>(p);
        f[k] = p - i;
        corner += static_cast<long>(i) * block.stride[k];
    }
    double value = 0;
    for (int c = 0; c < (1 << D); ++c) {
        double weight = 1;
        long at = corner;
        for (int k = 0; k < D; ++k) {
            weight *= c >> k & 1 ? f[k] : 1 - f[k];
            at += (c >> k & 1) * static_cast<long>(block.stride[k]);
        }
        value += weight * component.data()[at];
    }
    return value;
}

} // namespace gapflow
