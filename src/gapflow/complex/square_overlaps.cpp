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

} // namespace

void Square::keep_outer(const Depth& depth)
{
    const auto outside = [&](int solid, const Vec<2>& x) { // distance from all others, and the nearest of them
        std::pair nearest{std::numeric_limits<double>::infinity(), -1};
        for (int other = 0; other < static_cast<int>(solids.size()); ++other)
            if (other != solid)
                nearest = std::min(
                    nearest, std::pair{depth.distance(other, x) - parameters.joint_distance, other}); // what touches is shut
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
            const double depth_there = outside(solid, middle).first;
            if (!segment.whole && (middle - segment.from).norm() <= length && depth_there > length)
                continue; // nothing comes near
            const auto at = [&](double t) { return outside(solid, segment.at(t)).first; };
            any = any || depth_there <= 0;
            double before = at(0);
            for (int i = 0; i < steps; ++i) {
                const double t0 = static_cast<double>(i) / steps, t1 = static_cast<double>(i + 1) / steps, after = at(t1);
                if ((before > 0) != (after > 0)) {
                    const double t = before > 0 ? root(at, t0, t1) : root(at, t1, t0);
                    splits[a].push_back({k, t});
                    const Vec<2> x = segment.at(t);
                    split_other(outside(solid, x).second, x);
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
            double longest = -1;
            Vec<2> middle = arc.from;
            for (std::size_t k = ends[i].first; k <= ends[i + 1].first; ++k) {
                const double t0 = k == ends[i].first ? ends[i].second : 0, t1 = k == ends[i + 1].first ? ends[i + 1].second : 1;
                if (t1 <= t0)
                    continue;
                part.segments.push_back(arc.segments[k].part(t0, t1));
                const double length = (t1 - t0) * ((arc.segments[k].at(0.5) - arc.segments[k].from).norm() +
                                                   (arc.segments[k].at(0.5) - arc.segments[k].to).norm());
                if (length > longest) {
                    longest = length;
                    middle = arc.segments[k].at(0.5 * (t0 + t1));
                }
            }
            if (part.segments.empty() || outside(arc.solid, middle).first <= 0)
                continue;
            const bool begins = i == 0 && !closed, finishes = i + 2 == ends.size() && !closed;
            part.from = part.segments[0].from;
            part.to = part.segments[part.segments.size() - 1].to;
            part.start = begins ? arc.start : OnEdge{};
            part.end = finishes ? arc.end : OnEdge{};
            kept.push_back(part);
        }
    }
    // Where one arc ends within the rectangle another one starts.
    std::vector<bool> taken(kept.size(), false);
    for (SquareArc& arc : kept) {
        if (arc.end.edge >= 0)
            continue;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < kept.size(); ++k) {
            const double distance = (kept[k].from - arc.to).squaredNorm();
            if (kept[k].start.edge < 0 && !taken[k] && distance < least) {
                least = distance;
                arc.joins = static_cast<int>(k);
            }
        }
        if (arc.joins >= 0)
            taken[arc.joins] = true;
    }
    arcs = kept;
}

} // namespace gapflow
