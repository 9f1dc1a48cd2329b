// Solids that overlap in a rectangle: of their borders what lies outside all others is kept.
#include "gapflow/complex/parameters.hpp"
#include "gapflow/complex/square_helpers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace gapflow {

namespace {

/// Where an arc leads along x(t), the sign of a distance changes: by halving.
template <class F>
double root(F&& f, double positive, double negative)
{
    for (int k = 0; k < 60 && positive != negative; ++k) {
        const double middle = 0.5 * (positive + negative);
        (f(middle) > 0 ? positive : negative) = middle;
    }
    return positive;
}

/// The point of the whole ellipse next to x (Newton, from the point whose normal leads to x on a circle).
Vec<2> closest_on(const Curve& c, const Vec<2>& x)
{
    if (c.semi1 == c.semi2)
        return x; // of the same angle
    const Vec<2> scaled = c.scaled(x), local(c.semi1 * scaled[0], c.semi2 * scaled[1]);
    double angle = std::atan2(c.semi1 * local[1], c.semi2 * local[0]);
    for (int k = 0; k < 20; ++k) {
        const double cosine = std::cos(angle), sine = std::sin(angle), dx = c.semi1 * cosine - local[0],
                     dy = c.semi2 * sine - local[1], slope = -dx * c.semi1 * sine + dy * c.semi2 * cosine,
                     rise = c.semi1 * c.semi1 * sine * sine + c.semi2 * c.semi2 * cosine * cosine - dx * c.semi1 * cosine -
                            dy * c.semi2 * sine;
        if (!(rise > 0))
            break;
        const double change = slope / rise;
        angle -= change;
        if (std::abs(change) < parameters.least_stretch)
            break;
    }
    return c.centre + c.semi1 * std::cos(angle) * c.e1 + c.semi2 * std::sin(angle) * Vec<2>(-c.e1[1], c.e1[0]);
}

} // namespace

/// From the solid's own border in the rectangle, so that what it covers is the same here as on the rectangle's edges.
double Square::distance(int solid, const Vec<2>& x) const
{
    constexpr double infinite = std::numeric_limits<double>::infinity();
    double result = solids[solid].corner[0] ? -infinite : infinite, size = infinite, steepest = -1;
    for (const SquareArc& arc : arcs)
        for (const ArcSegment& segment : arc.segments) {
            if (arc.solid != solid || (!segment.whole && segment.from == segment.to))
                continue;
            const double t = segment.nearest(segment.curve ? closest_on(*segment.curve, x) : x),
                         step = parameters.tangent_share;
            const Vec<2> away = x - segment.at(t),
                         way = segment.curve ? Vec<2>(segment.at(std::min(t + step, 1.0)) - segment.at(std::max(t - step, 0.0)))
                                             : Vec<2>(segment.to - segment.from);
            const double far = away.norm(), turn = cross(way, away) / way.norm(), steep = far > 0 ? std::abs(turn) / far : 0;
            // Where two segments meet the one that faces the point tells its side.
            if (far < size - parameters.least_stretch || (far < size + parameters.least_stretch && steep > steepest)) {
                result = std::copysign(far, turn);
                size = far;
                steepest = steep;
            }
        }
    // Beyond the end of a border that lies on an edge of the rectangle: as the edge has it.
    if (size > parameters.joint_distance && steepest < parameters.parallel)
        for (int e = 0; e < 4; ++e)
            if (std::abs(x[1 - e % 2] - (e == 1 || e == 2 ? high : low)[1 - e % 2]) < parameters.joint_distance)
                result = std::any_of(solids[solid].edges[e].begin(), solids[solid].edges[e].end(),
                                     [&](const Stretch& s) { return x[e % 2] >= s.from && x[e % 2] <= s.to; })
                             ? -size
                             : size;
    return result;
}

void Square::keep_outer()
{
    // Distance of an arc's point from all other solids, and the nearest of them. What touches another solid is shut; where both have their fluid on
    // the same side the border is that of the first one.
    const auto outside = [&](int solid, const ArcSegment& segment, double t) {
        const double near = parameters.joint_distance;
        const Vec<2> x = segment.at(t);
        std::pair nearest{std::numeric_limits<double>::infinity(), -1};
        for (int other = 0; other < static_cast<int>(solids.size()); ++other) {
            if (other == solid)
                continue;
            const double there = distance(other, x);
            double beyond = there - near;
            if (std::abs(there) <= near) {
                const Vec<2> way = segment.at(std::min(t + parameters.tangent_share, 1.0)) -
                                   segment.at(std::max(t - parameters.tangent_share, 0.0)),
                             fluid = Vec<2>(-way[1], way[0]) / std::max(way.norm(), std::numeric_limits<double>::min());
                if (solid < other && distance(other, x + 4 * near * fluid) > there + 2 * near)
                    beyond = there + 2 * near;
            }
            nearest = std::min(nearest, std::pair{beyond, other});
        }
        return nearest;
    };
    // Where borders of two solids cross, both are split.
    std::vector<std::vector<std::pair<std::size_t, double>>> splits(arcs.size());
    const auto split_other = [&](int solid, const Vec<2>& x) {
        double least = std::numeric_limits<double>::infinity(), t = 0;
        std::size_t arc = 0, segment = 0;
        for (std::size_t a = 0; a < arcs.size(); ++a)
            for (std::size_t k = 0; arcs[a].solid == solid && k < arcs[a].segments.size(); ++k) {
                const double at = arcs[a].segments[k].nearest(x), distance = (arcs[a].segments[k].at(at) - x).squaredNorm();
                if (distance < least) {
                    least = distance;
                    arc = a;
                    segment = k;
                    t = at;
                }
            }
        if (least < 1)
            splits[arc].push_back({segment, t});
    };
    bool any = false;
    for (std::size_t a = 0; a < arcs.size(); ++a)
        for (std::size_t k = 0; k < arcs[a].segments.size(); ++k) {
            const ArcSegment& segment = arcs[a].segments[k];
            const int solid = arcs[a].solid, steps = parameters.overlap_samples;
            const double length = (segment.to - segment.from).norm();
            const Vec<2> middle = segment.at(0.5);
            const double there = outside(solid, segment, 0.5).first;
            if (!segment.whole && (middle - segment.from).norm() <= length && there > length)
                continue; // nothing comes near
            const auto at = [&](double t) { return outside(solid, segment, t).first; };
            any = any || there <= 0;
            // Evenly, and on both sides of places where a segment of another border ends on this one.
            std::vector<double> places;
            for (int i = 0; i <= steps; ++i)
                places.push_back(static_cast<double>(i) / steps);
            for (const SquareArc& other : arcs)
                for (const ArcSegment& across : other.segments)
                    for (const Vec<2>& end : {across.from, across.to})
                        if (const double t = segment.nearest(end);
                            other.solid != solid && (segment.at(t) - end).norm() < 4 * parameters.joint_distance)
                            places.push_back(t);
            if (static_cast<int>(places.size()) > steps + 1) {
                std::sort(places.begin(), places.end());
                for (std::size_t i = places.size(); i-- > 1;)
                    places.push_back(0.5 * (places[i] + places[i - 1]));
                std::sort(places.begin(), places.end());
            }
            double before = at(0);
            for (std::size_t i = 1; i < places.size(); ++i) {
                const double t0 = places[i - 1], t1 = places[i], after = at(t1);
                if ((before > 0) != (after > 0)) {
                    const double t = before > 0 ? root(at, t0, t1) : root(at, t1, t0);
                    splits[a].push_back({k, t});
                    split_other(outside(solid, segment, t).second, segment.at(t));
                    any = true;
                }
                before = after;
            }
        }
    if (!any)
        return;
    std::vector<SquareArc> kept;
    for (std::size_t a = 0; a < arcs.size(); ++a) {
        const SquareArc& arc = arcs[a];
        auto& list = splits[a];
        std::sort(list.begin(), list.end());
        const bool closed = arc.start.edge < 0;
        std::vector<std::pair<std::size_t, double>> ends{{0, 0.0}};
        for (const auto& split : list) // the same crossing is found along either border
            if (split.first != ends.back().first || split.second > ends.back().second + 1e-9)
                ends.push_back(split);
        ends.push_back({arc.segments.size() - 1, 1.0});
        for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
            SquareArc part = arc;
            part.segments.clear();
            double longest = -1, middle = 0;
            const ArcSegment* longest_one = nullptr;
            for (std::size_t k = ends[i].first; k <= ends[i + 1].first; ++k) {
                const double t0 = k == ends[i].first ? ends[i].second : 0, t1 = k == ends[i + 1].first ? ends[i + 1].second : 1;
                if (t1 <= t0)
                    continue;
                part.segments.push_back(arc.segments[k].part(t0, t1));
                const double length = (t1 - t0) * ((arc.segments[k].at(0.5) - arc.segments[k].from).norm() +
                                                   (arc.segments[k].at(0.5) - arc.segments[k].to).norm());
                if (length > longest) {
                    longest = length;
                    longest_one = &arc.segments[k];
                    middle = 0.5 * (t0 + t1);
                }
            }
            if (part.segments.empty() || outside(arc.solid, *longest_one, middle).first <= 0)
                continue;
            const bool begins = i == 0 && !closed, finishes = i + 2 == ends.size() && !closed;
            part.from = part.segments[0].from;
            part.to = part.segments[part.segments.size() - 1].to;
            part.start = begins ? arc.start : OnEdge{};
            part.end = finishes ? arc.end : OnEdge{};
            kept.push_back(part);
        }
    }
    // Where one arc ends within the rectangle another one starts; so does an arc where the open border ends at one that is not kept, and the open
    // border where an arc ends. The nearest first.
    struct Ending {
        double distance;
        int end, start; ///< of kept arcs; beyond their number: of ring_
    };
    const int n = static_cast<int>(kept.size());
    const auto kept_at = [&](const OnEdge& place, int solid, bool start) {
        return std::any_of(kept.begin(), kept.end(),
                           [&](const SquareArc& arc) { return arc.solid == solid && (start ? arc.start : arc.end) == place; });
    };
    std::vector<std::pair<int, Vec<2>>> ends, starts;
    // An end on an edge of the rectangle that another solid closes there is one within it, if what goes on is found next to it.
    const auto within = [&](const OnEdge& place, bool start) {
        return place.edge < 0 || std::none_of(ring_.begin(), ring_.end(),
                                              [&](const RingStretch& r) { return (start ? r.end : r.start) == place; });
    };
    for (int k = 0; k < n; ++k) {
        if (within(kept[k].end, false))
            ends.push_back({k, kept[k].to});
        if (within(kept[k].start, true))
            starts.push_back({k, kept[k].from});
    }
    for (int r = 0; r < static_cast<int>(ring_.size()); ++r) {
        if (ring_[r].after >= 0 && !kept_at(ring_[r].end, ring_[r].after, true))
            ends.push_back({n + r, point(ring_[r].end)});
        if (ring_[r].before >= 0 && !kept_at(ring_[r].start, ring_[r].before, false))
            starts.push_back({n + r, point(ring_[r].start)});
    }
    const auto attach_end = [&](SquareArc& arc, const OnEdge& place) {
        if (const Vec<2> x = point(place); x != arc.to) {
            arc.segments.push_back({arc.to, x, nullptr, -1, false, false}); // equal to round-off
            arc.to = x;
        }
        arc.end = place;
    };
    std::vector<Ending> pairs;
    for (const auto& [end, from] : ends)
        for (const auto& [start, to] : starts)
            if (const double distance = (to - from).norm();
                (end < n || start < n) &&
                (((end >= n || kept[end].end.edge < 0) && (start >= n || kept[start].start.edge < 0)) ||
                 distance < 4 * parameters.joint_distance))
                pairs.push_back({distance, end, start});
    std::stable_sort(pairs.begin(), pairs.end(), [](const Ending& a, const Ending& b) { return a.distance < b.distance; });
    std::vector<char> ended(n + ring_.size(), 0), started(n + ring_.size(), 0);
    for (const Ending& pair : pairs) {
        if (ended[pair.end] || started[pair.start])
            continue;
        ended[pair.end] = started[pair.start] = 1;
        if (pair.end >= n)
            kept[pair.start].start = ring_[pair.end - n].end;
        else if (pair.start >= n)
            attach_end(kept[pair.end], ring_[pair.start - n].start);
        else {
            kept[pair.end].joins = pair.start;
            kept[pair.end].end = kept[pair.start].start = {};
        }
    }
    arcs = kept;
}

} // namespace gapflow
