#include "gapflow/complex/mouth.hpp"

#include "gapflow/complex/mouth_walls.hpp"
#include "gapflow/complex/parameters.hpp"
#include "gapflow/complex/plane_poses.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gapflow {
namespace {

/// 1 + 1/2 + .. + 1/x, for all x >= 0.
double harmonic_number(double x)
{
    double y = x + 1, sum = 0;
    for (; y < 10; ++y)
        sum -= 1 / y;
    const double z = 1 / (y * y);
    return std::numbers::egamma + sum + std::log(y) - 0.5 / y - z * (1.0 / 12 - z * (1.0 / 120 - z / 252));
}

class MouthFinder {
public:
    MouthFinder(const GridPlanes<2>& planes, std::span<const Solid<2>> solids, std::vector<PlacedSolid<2>>& placed)
        : planes_(planes), placed_(placed), walls_(planes, solids, placed)
    {
    }

    std::vector<GapMouth<2>> find()
    {
        struct Found {
            int image, corner;
            OtherWall<2> wall;
        };
        for (PlacedSolid<2>& solid : placed_)
            for (SharpCorner& corner : solid.corners)
                corner.bisector = corner.outward;
        std::vector<Found> found;
        for (int i = 0; i < static_cast<int>(placed_.size()); ++i)
            for (int k = 0; k < static_cast<int>(placed_[i].corners.size()); ++k)
                if (const OtherWall<2> wall = walls_.nearest(i, placed_[i].corners[k].at); wall.distance < turning_end)
                    found.push_back({i, k, wall});
        for (const Found& f : found)
            add(f.image, f.corner, f.wall);
        return std::move(mouths_);
    }

private:
    /// The corner of a solid at a place, -1: none.
    int corner_at(int image, const Vec<2>& x) const
    {
        if (image >= 0)
            for (int k = 0; k < static_cast<int>(placed_[image].corners.size()); ++k)
                if ((placed_[image].corners[k].at - x).norm() < in_plane)
                    return k;
        return -1;
    }

    /// How far the corner lies beyond the end of the wall that faces it from a place at the corner's side: 0 where it is in front of one of
    /// the two sides that meet there.
    static double beyond(const SharpCorner& corner, const Vec<2>& from)
    {
        const Vec<2> way = from - corner.at;
        const double angle =
            std::abs(std::atan2(corner.bisector[0] * way[1] - corner.bisector[1] * way[0], corner.bisector.dot(way)));
        return way.norm() * std::sin(std::clamp(0.5 * (std::numbers::pi - corner.angle) - angle, 0.0, 0.5 * std::numbers::pi));
    }

    /// The corner of the solid across whose way to this corner's solid crosses the way from this corner to `end`, where both gaps end on the same
    /// side; -1: none. The two have one mouth, beside which one of the walls goes on: two lines that cross would make two of it, one behind the other.
    int crossing_corner(int image, const SharpCorner& corner, int across, const Vec<2>& end) const
    {
        const auto cross = [](const Vec<2>& a, const Vec<2>& b) { return a[0] * b[1] - a[1] * b[0]; };
        const Vec<2> way = end - corner.at;
        for (int k = 0; across >= 0 && k < static_cast<int>(placed_[across].corners.size()); ++k) {
            const SharpCorner& other = placed_[across].corners[k];
            if (!((other.at - corner.at).norm() < turning_end + parameters.gap_end))
                continue;
            const OtherWall<2> back = walls_.nearest(across, other.at);
            const Vec<2> foot = planes_.in_cells(back.nearest.x);
            if (back.image != image || !(back.distance < parameters.gap_end) || corner_at(image, foot) >= 0)
                continue;
            const Vec<2> from = other.at - corner.at, to = foot - corner.at, there = to - from;
            const bool crosses = cross(way, from) * cross(way, to) <= 0 && cross(there, from) * cross(there, from - way) <= 0;
            if (crosses && cross(way, corner.bisector) * cross(way, other.bisector) > 0)
                return k;
        }
        return -1;
    }

    void add(int image, int number, const OtherWall<2>& wall)
    {
        SharpCorner& corner = placed_[image].corners[number];
        const double share = share_up_to(wall.distance, parameters.mouth_start, parameters.gap_end);
        Vec<2> end = planes_.in_cells(wall.nearest.x);
        const int across = corner_at(wall.image, end);
        if (across >= 0) { // two corners: one mouth
            const SharpCorner& other = placed_[wall.image].corners[across];
            const SurfacePoint<2> back = placed_[image].shape.closest(planes_.in_world(other.at));
            const bool mutual = (planes_.in_cells(back.x) - corner.at).norm() < in_plane;
            if (!mutual || std::pair(image, number) > std::pair(wall.image, across)) {
                corner.own = 1 - share;
                if (!mutual) {
                    const double away = std::min(1.0, beyond(other, corner.at));
                    corner.own = std::max(corner.own, away * away * (3 - 2 * away));
                }
                return;
            }
            end = other.at;
        } else if (const int other = crossing_corner(image, corner, wall.image, end);
                   other >= 0 && std::pair(image, number) > std::pair(wall.image, other)) {
            corner.own = 1 - share; // it lies beside the other one's mouth
            return;
        } else
            for (int axis = 0; axis < 2; ++axis) // as far as places are told from each other
                if (const Vec<2> way = (end - corner.at).cwiseAbs(); way[axis] < in_plane && !(way[1 - axis] < in_plane))
                    end[axis] = corner.at[axis];
        const Vec<2> way = end - corner.at, direction = way.normalized();
        const double h = way.norm();
        if (!(std::acos(std::clamp(direction.dot(corner.bisector), -1.0, 1.0)) < std::numbers::pi - 0.5 * corner.angle))
            return; // through the solid itself
        const double turned = share_up_to(h, parameters.gap_end, turning_end);
        corner.outward = ((1 - turned) * corner.bisector + turned * direction).normalized();
        if (!(share > 0))
            return;
        GapMouth<2> mouth{{placed_[image].solid, walls_.solid_of(wall)}, corner.at, end, 0, share, 1, 1, {}};
        walls_.find_room(image, wall, mouth);
        for (int side = 0; side < 2; ++side)
            mouth.sides[side] =
                walls_.side(image, wall, corner.at, end, (side == 0 ? 1 : -1) * left_of(direction), mouth.radius);
        corner.own = 1 - share;
        corner.mouth = static_cast<int>(mouths_.size());
        mouth.length = h / std::max(corner.outward.dot(direction), parameters.least_facing);
        corner.reach = mouth.length + 10 * parameters.joint_distance;
        for (int axis = 0; axis < 2; ++axis)
            if (const int plane = planes_.cell_of(axis, corner.at[axis]);
                corner.at[axis] == planes_.place_of(axis, plane) && end[axis] == corner.at[axis]) {
                mouth.axis = axis;
                mouth.plane = plane;
            }
        mouths_.push_back(mouth);
        if (mouth.axis >= 0) {
            corner.own = 0;
            corner.mouth = -1;
        } else
            add_lines(placed_[image], number);
    }

    /// The cells beside the corner's own through which its line passes.
    void add_lines(PlacedSolid<2>& solid, int number)
    {
        const SharpCorner& corner = solid.corners[number];
        const Vec<2>& n = corner.outward;
        Index<2> cell;
        int from_edge = -1;
        for (int axis = 0; axis < 2; ++axis) {
            cell[axis] = planes_.cell_of(axis, corner.at[axis]);
            if (planes_.place_of(axis, cell[axis]) == corner.at[axis]) {
                from_edge = axis == 0 ? (n[axis] < 0 ? 1 : 3) : (n[axis] < 0 ? 2 : 0);
                cell[axis] -= n[axis] < 0;
            }
        }
        const bool within = from_edge < 0;
        Vec<2> from = corner.at;
        for (int cells = 0; cells < 8; ++cells) {
            double way = std::numeric_limits<double>::infinity();
            int exit = -1;
            Vec<2> to = from;
            for (int axis = 0; axis < 2; ++axis) {
                const double plane = planes_.place_of(axis, cell[axis] + (n[axis] > 0));
                if (const double t = (plane - corner.at[axis]) / n[axis]; n[axis] != 0 && t < way) {
                    way = t;
                    exit = axis == 0 ? (n[axis] > 0 ? 1 : 3) : (n[axis] > 0 ? 2 : 0);
                    to[axis] = plane;
                    to[1 - axis] = corner.at[1 - axis] + way * n[1 - axis];
                }
            }
            const bool ends = !(way < corner.reach);
            if (cells > 0 || !within)
                solid.lines.push_back(
                    {cell, number, from, ends ? Vec<2>(corner.at + corner.reach * n) : to, from_edge, ends ? -1 : exit});
            if (ends)
                return;
            from = to;
            from_edge = (exit + 2) % 4;
            cell[exit == 1 || exit == 3 ? 0 : 1] += exit == 1 || exit == 2 ? 1 : -1;
        }
    }

    static constexpr double turning_end = MouthWalls<2>::turning_end;

    const GridPlanes<2>& planes_;
    std::vector<PlacedSolid<2>>& placed_;
    const MouthWalls<2> walls_;
    std::vector<GapMouth<2>> mouths_;
};

} // namespace

double outlet_resistance(double h, const std::array<double, 2>& turns, double radius)
{
    double beta = 0, sum = 0;
    for (const double turn : turns) {
        const double a = std::max(turn, 0.0) / std::numbers::pi;
        beta += turn;
        sum += a * a * harmonic_number(a);
    }
    if (!(beta > 0))
        return 0;
    return (std::log(beta * radius / h) + sum * std::numbers::pi / beta - 0.25) / beta;
}

std::vector<GapMouth<2>> find_mouths(const GridPlanes<2>& planes, std::span<const Solid<2>> solids,
                                     std::vector<PlacedSolid<2>>& placed)
{
    return MouthFinder(planes, solids, placed).find();
}

} // namespace gapflow
