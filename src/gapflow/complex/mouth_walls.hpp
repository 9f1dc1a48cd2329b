// What lies around a mouth: the nearest other wall, how walls turn away from it, the room up to a third wall.
#pragma once

#include "gapflow/complex/complex.hpp"
#include "gapflow/complex/gap_way.hpp"
#include "gapflow/complex/mouth.hpp"
#include "gapflow/complex/parameters.hpp"
#include "gapflow/complex/placed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace gapflow {

/// As PlacedShape::closest, compiled as all of this folder is.
template <int D>
[[gnu::flatten]] SurfacePoint<D> closest_point(const PlacedShape<D>& shape, const Vec<D>& x)
{
    return shape.closest(x);
}

/// The wall of another solid, or of an image or a side of the domain.
template <int D>
struct OtherWall {
    int image = -1, side = -1; ///< among the placed solids; among the solids
    SurfacePoint<D> nearest;   ///< in the world
    double distance = std::numeric_limits<double>::infinity();
};

template <int D>
class MouthWalls {
public:
    MouthWalls(const GridPlanes<D>& planes, std::span<const Solid<D>> solids, const std::vector<PlacedSolid<D>>& placed)
        : planes_(planes), solids_(solids), placed_(placed)
    {
        for (std::size_t s = 0; s < solids.size(); ++s)
            if (solids[s].wall)
                sides_.push_back(static_cast<int>(s));
    }

    /// Nearest to a place of a placed solid, up to turning_end.
    OtherWall<D> nearest(int image, const Vec<D>& at) const
    {
        OtherWall<D> wall;
        const Vec<D> x = planes_.in_world(at);
        const auto offer = [&](const PlacedShape<D>& shape, int i, int side) {
            const SurfacePoint<D> point = closest_point<D>(shape, x);
            if (const double distance = point.distance / planes_.dx; distance > 0 && distance < wall.distance)
                wall = {i, side, point, distance};
        };
        for (int i = 0; i < static_cast<int>(placed_.size()); ++i) {
            const PlacedSolid<D>& other = placed_[i];
            if (i == image)
                continue;
            const double outside = (other.low - at).cwiseMax(at - other.high).maxCoeff();
            if (other.inverse || outside < turning_end)
                offer(other.shape, i, -1);
        }
        for (const int s : sides_)
            offer(solids_[s].shape, -1, s);
        return wall;
    }

    const PlacedShape<D>& shape_of(const OtherWall<D>& wall) const
    {
        return wall.image >= 0 ? placed_[wall.image].shape : solids_[wall.side].shape;
    }
    int solid_of(const OtherWall<D>& wall) const { return wall.image >= 0 ? placed_[wall.image].solid : wall.side; }

    /// Of the sector around a mouth: it ends at a third wall.
    void find_room(int image, const OtherWall<D>& wall, GapMouth<D>& mouth) const
    {
        const double radius = std::max(1.0, (mouth.end - mouth.at).norm());
        mouth.room = room(image, wall, 0.5 * (mouth.at + mouth.end), radius + std::sqrt(static_cast<double>(D)));
        mouth.radius = std::min(mouth.room, radius);
    }

    /// Up to `radius`, but no further than to a third wall.
    double room(int image, const OtherWall<D>& wall, const Vec<D>& x, double radius) const
    {
        const auto offer = [&](const PlacedShape<D>& shape) {
            radius = std::min(radius, std::max(0.0, closest_point<D>(shape, planes_.in_world(x)).distance / planes_.dx));
        };
        for (int i = 0; i < static_cast<int>(placed_.size()); ++i) {
            const PlacedSolid<D>& other = placed_[i];
            if (i != image && i != wall.image &&
                (other.inverse || (other.low - x).cwiseMax(x - other.high).maxCoeff() < radius))
                offer(other.shape);
        }
        for (const int s : sides_)
            if (s != wall.side)
                offer(solids_[s].shape);
        return radius;
    }

    /// What lies on one side of the mouth from a solid's place `at` to `end` on another wall, in the direction `along`.
    GapMouthSide side(int image, const OtherWall<D>& wall, const Vec<D>& at, const Vec<D>& end, const Vec<D>& along,
                      double radius) const
    {
        const Vec<D> way = end - at, direction = way.normalized();
        const std::array<double, 2> turns{turn_of(placed_[image].shape, at, along, -direction, radius),
                                          turn_of(shape_of(wall), end, along, direction, radius)};
        double wider = 0; // half a cell away
        for (const double angle : turns)
            wider += 0.5 * std::tan(std::clamp(angle, -steepest, steepest));
        GapMouthSide side;
        side.gap = share_up_to(wider, parameters.gap_start, parameters.gap_end);
        if (side.gap < 1) {
            const double corner = std::max(0.0, turns[0]), other = std::max(0.0, turns[1]);
            side.angle = corner + other;
            side.apex = side.angle > 0 ? corner / side.angle : 0.5;
            side.outlet = outlet_resistance(way.norm(), turns, radius);
        }
        return side;
    }

    /// Up to there lines turn from the way to the other wall to the bisector.
    static constexpr double turning_end = 2 * parameters.gap_end - parameters.gap_start;

private:
    /// By how much a wall turns away from the direction `along` at x, seen at a distance; behind: into the solid. What lies behind counts as far as the wall
    /// turns away at all: of an acute corner or a thin plate it is the other side.
    double turn_of(const PlacedShape<D>& shape, const Vec<D>& x, const Vec<D>& along, const Vec<D>& behind,
                   double distance) const
    {
        const auto away = [&](const Vec<D>& y) {
            return closest_point<D>(shape, planes_.in_world(y)).distance / (planes_.dx * distance);
        };
        const double ahead = std::clamp(away(x + distance * along), -1.0, 1.0);
        return std::asin(ahead) + std::max(0.0, ahead) * std::asin(std::clamp(away(x + distance * behind), 0.0, 1.0));
    }

    static constexpr double steepest = 1.4; // any larger turn is no gap

    const GridPlanes<D>& planes_;
    std::span<const Solid<D>> solids_;
    const std::vector<PlacedSolid<D>>& placed_;
    std::vector<int> sides_;
};

} // namespace gapflow
