// The part of a solid below a plane, as the wet part of a float below the water's level.
#pragma once

#include "gapflow/geometry/shape.hpp"

namespace gapflow {

/// In the solid's frame. Of a shape turned inside out all numbers are those of its cavity with the sign turned.
template <int D>
struct PartBelow {
    double volume = 0;              ///< 2D: area
    Vec<D> moment = Vec<D>::Zero(); ///< integral of x over the part
    // The solid's section with the plane, 2D: its length and so on. Integrals of 1, x and x x^T over it.
    double section = 0;
    Vec<D> section_moment = Vec<D>::Zero();
    Mat<D> section_square = Mat<D>::Zero();
};

/// Of a bounded shape; `plane` in the solid's frame, its normal of unit length. Exact to round-off; cylinders and capsules that are turned inside
/// out as good as a surface of facets.
template <int D>
PartBelow<D> part_below(const Shape<D>& shape, const Plane<D>& plane);

} // namespace gapflow
