// A disc in a convex polygon. Private to grid/.
#pragma once

#include <Eigen/Core>

#include <span>

namespace gapflow {

struct Disc {
    Eigen::Vector2d centre;
    double radius;
};

struct AreaMoment {
    double area = 0;
    Eigen::Vector2d moment = Eigen::Vector2d::Zero(); ///< integral of the place
};

/// Area and first moment of a convex polygon (its corners counterclockwise).
AreaMoment area_of(std::span<const Eigen::Vector2d> polygon);

/// Those of the disc's part inside it. Errors of the area: round-off of the places, times the polygon's size.
AreaMoment area_inside(const Disc& disc, std::span<const Eigen::Vector2d> polygon);

} // namespace gapflow
