// A disc in a convex polygon. Private to grid/.
#pragma once

#include "gapflow/grid/clip_kernels.hpp"

namespace gapflow {

struct Disc {
    Eigen::Vector2d centre;
    double radius;
};

/// Area and first moment of a convex polygon (its corners counterclockwise).
PartSum<3> area_of(std::span<const Eigen::Vector2d> polygon);

/// Those of the disc's part inside it. Errors of the area: round-off of the places, times the polygon's size.
PartSum<3> area_inside(const Disc& disc, std::span<const Eigen::Vector2d> polygon);

} // namespace gapflow
