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
#include <numbers>
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
        const double width = way.norm();
        const std::array<Turn, 2> turn{turn_of(placed_[image].shape, at, along, -direction, radius),
                                       turn_of(shape_of(wall), end, along, direction, radius)};
        double wider = 0; // half a cell away
        for (const Turn& of : turn)
            wider += 0.5 * std::tan(std::clamp(of.seen, -steepest, steepest));
        GapMouthSide side;
        side.gap = share_up_to(wider, parameters.gap_start, parameters.gap_end);
        if (side.gap < 1) {
            std::array<double, 2> turns{turn[0].angle, turn[1].angle};
            for (int k = 0; k < 2; ++k)
                turns[k] = turn_beyond(turns, k, turn[k], width, radius);
            const double corner = std::max(0.0, turns[0]), other = std::max(0.0, turns[1]);
            side.angle = corner + other;
            side.apex = side.angle > 0 ? corner / side.angle : 0.5;
            side.outlet = outlet_resistance(width, turns, radius);
        }
        return side;
    }

    /// Up to there lines turn from the way to the other wall to the bisector.
    static constexpr double turning_end = 2 * parameters.gap_end - parameters.gap_start;

private:
    /// How a wall turns away from the direction along it.
    struct Turn {
        double seen;   ///< of a wall that turns at once: by the sine of the angle at a distance
        double angle;  ///< where it turns
        double beyond; ///< the way up to there
    };
    /// Of the wall at x from the direction `along`, seen at a distance; behind: into the solid. What lies behind counts as far as the wall turns away at all: of an acute
    /// corner or a thin plate it is the other side.
    Turn turn_of(const PlacedShape<D>& shape, const Vec<D>& x, const Vec<D>& along, const Vec<D>& behind, double distance) const
    {
        const auto nearest = [&](const Vec<D>& way) { return closest_point<D>(shape, planes_.in_world(x + distance * way)); };
        const auto share = [&](const SurfacePoint<D>& point) { return point.distance / (planes_.dx * distance); };
        const SurfacePoint<D> point = nearest(along);
        const double sine = std::clamp(share(point), -1.0, 1.0),
                     other = std::asin(std::clamp(share(nearest(behind)), 0.0, 1.0));
        Turn turn{std::asin(sine) + std::max(0.0, sine) * other, 0, 0};
        turn.angle = turn.seen;
        if (!(sine > 0) || shape.shape().curvature(point.patch) != 0)
            return turn;
        const Vec<D> way = planes_.in_world(x + distance * along) - point.x; // along the wall's normal where it has turned
        const double whole = way.dot(along) / way.norm();
        if (!(whole >= sine))
            return turn;
        turn.angle = std::min(std::atan2(way.dot(along), -way.dot(behind)), 0.5 * std::numbers::pi) + whole * other;
        turn.beyond = distance * (1 - sine / whole);
        return turn;
    }

    /// The angle that has the resistance of a mouth one of whose walls turns `beyond` its end only. The channel is longer by half of that, between the ends of both; and up
    /// to there the sector is that of the other wall alone: the resistance grows by c ln(1 + beyond/(2 c h)), c the difference of the inverse angles, up to that of a wall that
    /// goes on.
    static double turn_beyond(std::array<double, 2> turns, int k, const Turn& turn, double width, double radius)
    {
        std::array<double, 2> one = turns;
        one[k] = 0;
        const double full = outlet_resistance(width, turns, radius), none = outlet_resistance(width, one, radius);
        if (!(turns[k] > 0 && one[1 - k] > 0 && full < none))
            return turn.seen;
        const double c = 1 / one[1 - k] - 1 / (turns[0] + turns[1]),
                     sought = full + c * std::log1p(turn.beyond / (2 * c * width));
        double low = 0, high = turns[k];
        for (int step = 0; step < halvings && turn.beyond > 0; ++step) {
            turns[k] = sought < none ? 0.5 * (low + high) : 0;
            (outlet_resistance(width, turns, radius) < sought ? high : low) = turns[k];
        }
        return turns[k];
    }

    static constexpr int halvings = 50;     ///< of an angle, to round-off
    static constexpr double steepest = 1.4; // any larger turn is no gap

    const GridPlanes<D>& planes_;
    std::span<const Solid<D>> solids_;
    const std::vector<PlacedSolid<D>>& placed_;
    std::vector<int> sides_;
};

} // namespace gapflow
