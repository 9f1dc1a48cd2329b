#include "gapflow/complex/square.hpp"

#include "gapflow/complex/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gapflow {
namespace {

/// Whether edge e runs against its axis, counterclockwise.
bool reversed(int e)
{
    return e >= 2;
}

double cross(const Vec<2>& a, const Vec<2>& b)
{
    return a[0] * b[1] - a[1] * b[0];
}

/// Ends of an edge's stretch in counterclockwise order.
std::pair<double, double> ends(int e, double from, double to)
{
    return reversed(e) ? std::pair{to, from} : std::pair{from, to};
}

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

/// SquareArc::joins of an arc that ends where another one is about to start.
constexpr int pending = -2;

} // namespace

Bulge ArcSegment::bulge() const
{
    if (!curve)
        return {};
    if (whole)
        return backwards ? -whole_ellipse(*curve) : whole_ellipse(*curve);
    return backwards ? -ellipse_bulge(*curve, to, from) : ellipse_bulge(*curve, from, to);
}

double ArcSegment::length() const
{
    if (!curve)
        return (to - from).norm();
    return curve->semi1 * (whole       ? 2 * std::numbers::pi
                           : backwards ? ellipse_angle(*curve, to, from)
                                       : ellipse_angle(*curve, from, to));
}

Vec<2> ArcSegment::at(double t) const
{
    if (!curve)
        return from + t * (to - from);
    const Vec<2> a = curve->scaled(from), b = curve->scaled(to), chord = curve->axes(Vec<2>(to - from));
    if (const double half = 0.5 * chord.norm(); !whole && half < 0.5 && a.dot(b) > 0 && (cross(a, chord) <= 0) != backwards) {
        // A small angle: between the ends, so that the centre of a long ellipse costs no digits.
        const double angle = 2 * std::asin(half), to_share = std::sin(t * angle) / std::sin(angle),
                     rest = -2 * std::sin(0.5 * t * angle) * std::sin(0.5 * (1 - t) * angle) / std::cos(0.5 * angle);
        return from + to_share * (to - from) + rest * (curve->centre - from);
    }
    double angle = -std::atan2(cross(a, b), a.dot(b)); // clockwise from a to b
    if (whole)
        angle = 2 * std::numbers::pi;
    else if (backwards)
        angle = angle > 0 ? angle - 2 * std::numbers::pi : angle;
    else
        angle = angle < 0 ? angle + 2 * std::numbers::pi : angle;
    const double c = std::cos(t * angle), s = std::sin(t * angle);
    const Vec<2> at(c * a[0] + s * a[1], c * a[1] - s * a[0]), e2(-curve->e1[1], curve->e1[0]);
    return curve->centre + at[0] * curve->semi1 * curve->e1 + at[1] * curve->semi2 * e2;
}

double ArcSegment::nearest(const Vec<2>& x) const
{
    if (!curve) {
        const Vec<2> way = to - from;
        const double length2 = way.squaredNorm();
        return length2 > 0 ? std::clamp((x - from).dot(way) / length2, 0.0, 1.0) : 0.0;
    }
    const Vec<2> a = curve->scaled(from), b = curve->scaled(to), s = curve->scaled(x);
    if (const Vec<2> chord = curve->axes(Vec<2>(to - from));
        !whole && chord.norm() < 1e-4 && (cross(a, chord) <= 0) != backwards) // straight but for a millionth
        return std::clamp((x - from).dot(to - from) / (to - from).squaredNorm(), 0.0, 1.0);
    const double turn = backwards ? -1 : 1;
    const auto angle = [&](const Vec<2>& y) { // from a, along the way
        const double way = -turn * std::atan2(cross(a, y), a.dot(y));
        return way < 0 ? way + 2 * std::numbers::pi : way;
    };
    const double all = whole ? 2 * std::numbers::pi : angle(b), here = angle(s);
    if (here <= all)
        return all > 0 ? here / all : 0.0;
    return (x - from).squaredNorm() < (x - to).squaredNorm() ? 0.0 : 1.0;
}

ArcSegment ArcSegment::part(double t0, double t1) const
{
    ArcSegment result = *this;
    result.from = t0 > 0 ? at(t0) : from;
    result.to = t1 < 1 ? at(t1) : to;
    result.whole = whole && t0 == 0 && t1 == 1;
    return result;
}

Bulge SquareArc::bulge() const
{
    Bulge sum;
    for (std::size_t k = 0; k < segments.size(); ++k) {
        sum += segments[k].bulge();
        if (k > 0)
            sum += triangle(from, segments[k].from, segments[k].to);
    }
    return sum;
}

void add_walk(SquareArc& arc, const Section& section, const Vec<2>& A, const Vec<2>& B, bool around, bool backwards)
{
    const Section::Walk way = section.walk(A, B, around);
    const std::size_t n = way.points.size() - 1;
    for (std::size_t k = 0; k < n; ++k) {
        const std::size_t at = backwards ? n - 1 - k : k;
        const Curve& c = section.curve[way.curves[at]];
        ArcSegment segment{way.points[at], way.points[at + 1], c.kind == Curve::Kind::ellipse ? &c : nullptr,
                           c.surface,      backwards,          false};
        if (backwards)
            std::swap(segment.from, segment.to);
        if (around && n == 1 && segment.curve && (A - B).squaredNorm() < 1e-20)
            segment.whole = true;
        arc.segments.push_back(segment);
    }
}

Vec<2> Square::corner(int c) const
{
    return {c == 0 || c == 3 ? low[0] : high[0], c < 2 ? low[1] : high[1]};
}

Vec<2> Square::point(const OnEdge& place) const
{
    switch (place.edge) {
    case 0:
        return {place.at, low[1]};
    case 1:
        return {high[0], place.at};
    case 2:
        return {place.at, high[1]};
    default:
        return {low[0], place.at};
    }
}

double Square::along_ring(const OnEdge& place) const
{
    const int axis = place.edge % 2;
    const double share = (place.at - low[axis]) / (high[axis] - low[axis]);
    return place.edge + (reversed(place.edge) ? 1 - share : share);
}

void Square::find_open_stretches()
{
    struct Cover {
        double from, to;
        int solid;
    };
    struct Open { // counterclockwise; solids at its ends, -1: the corner
        int edge;
        double start, end;
        int before, after;
    };
    // The open stretches of each edge are found from the same numbers, in the same order, by both rectangles beside it.
    InlineVector<Open, 8> open;
    std::array<Cover, 4> first, last; // covers next to each edge's start and end
    for (int e = 0; e < 4; ++e) {
        const double from = low[e % 2], to = high[e % 2];
        InlineVector<Cover, 6> covers;
        for (std::size_t s = 0; s < solids.size(); ++s)
            for (const Stretch& c : solids[s].edges[e])
                covers.push_back({c.from, c.to, static_cast<int>(s)});
        std::sort(covers.begin(), covers.end(),
                  [](const Cover& a, const Cover& b) { return a.from < b.from || (a.from == b.from && a.to < b.to); });
        InlineVector<OpenStretch, 4> found; // piece: the solid before
        InlineVector<int, 4> behind;
        double reached = from;
        int before = -1;
        Cover lowest{from, from, -1}, highest{to, to, -1};
        for (const Cover& c : covers) {
            if (lowest.solid < 0)
                lowest = c;
            if (c.from > reached + parameters.least_stretch) {
                found.push_back({reached, c.from, before});
                behind.push_back(c.solid);
            }
            if (c.to > reached || before < 0) {
                reached = std::max(c.to, from);
                before = c.solid;
                highest = c;
            }
        }
        if (to > reached + parameters.least_stretch) {
            found.push_back({reached, to, before});
            behind.push_back(-1);
        }
        first[e] = reversed(e) ? highest : lowest;
        last[e] = reversed(e) ? lowest : highest;
        stretches[e].assign(found.begin(), found.end());
        ring_of_[e].assign(found.size(), -1);
        for (std::size_t k = 0; k < found.size(); ++k) {
            const std::size_t at = reversed(e) ? found.size() - 1 - k : k;
            const OpenStretch& o = found[at];
            open.push_back(reversed(e) ? Open{e, o.to, o.from, behind[at], o.piece}
                                       : Open{e, o.from, o.to, o.piece, behind[at]});
        }
    }
    // Joined around corners. What ends at a corner where nothing goes on (what opens there is below what counts) ends at the solid beyond.
    ring_.clear();
    const int n = static_cast<int>(open.size());
    const auto joins = [&](int k) { // with the one before
        const Open &o = open[k], &p = open[(k + n - 1) % n];
        return o.before < 0 && p.after < 0 && p.edge == (o.edge + 3) % 4;
    };
    int begin = 0;
    while (begin < n && joins(begin))
        ++begin;
    const bool all = begin == n && n > 0;
    begin = all ? 0 : begin;
    for (int k = 0; k < n; ++k) {
        const Open& o = open[(begin + k) % n];
        if (k == 0 || !joins((begin + k) % n)) {
            const Cover& c = last[(o.edge + 3) % 4];
            const bool here = o.before >= 0 || all;
            ring_.push_back(
                {here ? OnEdge{o.edge, o.start} : OnEdge{(o.edge + 3) % 4, reversed((o.edge + 3) % 4) ? c.from : c.to},
                 {},
                 here ? o.before : c.solid,
                 -1});
        }
        const Cover& c = first[(o.edge + 1) % 4];
        const bool here = o.after >= 0 || all;
        ring_.back().end = here ? OnEdge{o.edge, o.end} : OnEdge{(o.edge + 1) % 4, reversed((o.edge + 1) % 4) ? c.to : c.from};
        ring_.back().after = here ? o.after : c.solid;
    }
    int ring = -1;
    for (int k = 0; k < n; ++k) { // which of them each edge's stretches belong to
        const int at = (begin + k) % n, e = open[at].edge;
        if (k == 0 || !joins(at))
            ++ring;
        int place = 0;
        for (int j = 0; j < at; ++j)
            place += open[j].edge == e;
        ring_of_[e][reversed(e) ? ring_of_[e].size() - 1 - place : place] = ring;
    }
}

void Square::arcs_of_convex(int s)
{
    SquareSolid& solid = solids[s];
    if (solid.section_inside) {
        const Section& section = *solid.section;
        SquareArc arc;
        arc.solid = s;
        arc.from = arc.to = section.single() ? Vec<2>(section.curve[0].centre + section.curve[0].semi1 * section.curve[0].e1)
                                             : section.corner[0];
        add_walk(arc, section, arc.from, arc.to, true, solid.inverse);
        arcs.push_back(arc);
        return;
    }
    // Its covered stretches, joined around corners.
    struct Interval {
        OnEdge start, end;
    };
    InlineVector<Interval, 4> intervals;
    bool joins = false, first_at_corner = false;
    for (int e = 0; e < 4; ++e) {
        const auto& list = solid.edges[e];
        const double lo = low[e % 2], hi = high[e % 2];
        for (std::size_t k = 0; k < list.size(); ++k) {
            const Stretch& c = list[reversed(e) ? list.size() - 1 - k : k];
            const auto [start, end] = ends(e, c.from, c.to);
            const bool at_start = start == (reversed(e) ? hi : lo), at_end = end == (reversed(e) ? lo : hi);
            if (k == 0 && at_start && joins)
                intervals[intervals.size() - 1].end = {e, end};
            else {
                if (intervals.empty())
                    first_at_corner = e == 0 && at_start;
                intervals.push_back({{e, start}, {e, end}});
            }
            joins = at_end;
        }
        if (list.empty())
            joins = false;
    }
    std::size_t n = intervals.size();
    if (n == 0)
        return;
    if (joins && first_at_corner) {
        if (n == 1)
            return; // all of the border is covered
        intervals[0].start = intervals[n - 1].start;
        --n;
    }
    for (std::size_t k = 0; k < n; ++k) {
        SquareArc arc;
        arc.solid = s;
        arc.start = intervals[k].start;
        arc.end = solid.inverse ? intervals[k].end : intervals[(k + n - 1) % n].end;
        arc.from = point(arc.start);
        arc.to = point(arc.end);
        // Where both ends are one point to round-off, it is the whole border or nothing.
        const double touching = parameters.joint_distance;
        const bool inside = (solid.section->low.array() > low.array() - touching).all() &&
                            (solid.section->high.array() < high.array() + touching).all();
        if (solid.section->empty())
            arc.segments.push_back({arc.from, arc.to, nullptr, -1, false, false});
        else if (solid.inverse)
            add_walk(arc, *solid.section, arc.to, arc.from, inside, true);
        else
            add_walk(arc, *solid.section, arc.from, arc.to, inside, false);
        arcs.push_back(arc);
    }
}

void Square::find_arcs()
{
    arcs.clear();
    for (std::size_t s = 0; s < solids.size(); ++s) {
        if (solids[s].section) {
            arcs_of_convex(static_cast<int>(s));
            continue;
        }
        for (SquareArc arc : solids[s].arcs) {
            arc.solid = static_cast<int>(s);
            arcs.push_back(arc);
        }
    }
}

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

void Square::add_border(int ring)
{
    const RingStretch& r = ring_[ring];
    const auto to = [&](const Vec<2>& x) {
        sum_ += triangle(start_, here_, x);
        here_ = x;
    };
    const double from = along_ring(r.start), end = from + ring_length(r);
    for (int c = static_cast<int>(std::floor(from)) + 1; c < end; ++c)
        to(corner(c % 4));
    to(point(r.end));
}

void Square::add_arc(int arc)
{
    const SquareArc& a = arcs[arc];
    sum_ += triangle(start_, here_, a.from); // nothing, but for what joins to round-off only
    sum_ += triangle(start_, a.from, a.to);
    sum_ += a.bulge();
    here_ = a.to;
}

void Square::join(SquareArc& arc, const SquareArc& next)
{
    if (arc.to == next.from)
        return;
    arc.segments.push_back({arc.to, next.from, nullptr, -1, false, false}); // equal to round-off
    arc.to = next.from;
}

int Square::next_ring(SquareArc& arc)
{
    for (std::size_t r = 0; r < ring_.size(); ++r)
        if (ring_[r].start == arc.end && ring_[r].before == arc.solid)
            return static_cast<int>(r);
    // What opens there is below what counts: the next one, along the border.
    int best = -1;
    double least = 5;
    const double from = along_ring(arc.end);
    for (std::size_t r = 0; r < ring_.size(); ++r) {
        double way = along_ring(ring_[r].start) - from;
        if (way < -1e-9)
            way += 4;
        if (way < least) {
            least = way;
            best = static_cast<int>(r);
        }
    }
    if (best >= 0) {
        const Vec<2> x = point(ring_[best].start);
        arc.segments.push_back({arc.to, x, nullptr, -1, false, false});
        arc.to = x;
    }
    return best;
}

double Square::ring_length(const RingStretch& r) const
{
    const double length = along_ring(r.end) - along_ring(r.start);
    return length > 0 ? length : length + 4;
}

/// The joint of a solid's border at x between whose two segments, at the fluid's side, a direction leads.
Square::Hit Square::joint_at(int solid, const Vec<2>& x, const Vec<2>& direction) const
{
    Hit hit;
    double best = -1;
    const auto try_joint = [&](int arc, int k, const ArcSegment& in, const ArcSegment& out) {
        const double distance = (in.to - x).norm();
        if (distance > parameters.joint_distance)
            return;
        // Counterclockwise from the way out to the way back.
        const Vec<2> w = out.at(parameters.tangent_share) - out.from, v = in.at(1 - parameters.tangent_share) - in.to;
        const auto angle = [&](const Vec<2>& y) {
            const double t = std::atan2(cross(w, y), w.dot(y));
            return t < 0 ? t + 2 * std::numbers::pi : t;
        };
        double all = angle(v);
        if (all < parameters.least_stretch)
            all = 2 * std::numbers::pi; // a fin's end
        const double here = angle(direction), inside = std::min(here, all - here);
        if (inside > best) {
            best = inside;
            hit = {0, arc, k, 1};
        }
    };
    for (int a = 0; a < static_cast<int>(arcs.size()); ++a) {
        const SquareArc& arc = arcs[a];
        const int n = static_cast<int>(arc.segments.size());
        if (arc.solid != solid || n == 0)
            continue;
        for (int k = 0; k + 1 < n; ++k)
            try_joint(a, k, arc.segments[k], arc.segments[k + 1]);
        if (arc.start.edge < 0 && arc.end.edge < 0 && (arc.joins == -1 || arc.joins == a))
            try_joint(a, n - 1, arc.segments[n - 1], arc.segments[0]);
        else if (arc.end.edge < 0 && arc.joins >= 0 && arcs[arc.joins].solid == solid && !arcs[arc.joins].segments.empty())
            try_joint(a, n - 1, arc.segments[n - 1], arcs[arc.joins].segments[0]);
    }
    return hit;
}

/// Splits the border at a hit, or opens the joint there.
Square::End Square::open_at(const Hit& hit, const Vec<2>& x)
{
    End end;
    end.ends = hit.arc;
    SquareArc& arc = arcs[hit.arc];
    const bool last = hit.segment + 1 == static_cast<int>(arc.segments.size()) && hit.t >= 1;
    if (last && arc.end.edge < 0 && arc.joins >= 0 && arc.joins != hit.arc) {
        end.starts = arc.joins;
        arc.joins = pending;
    } else
        end.starts = split_arc(hit.arc, hit.segment, hit.t, x);
    return end;
}

Square::Hit Square::nearest_hit(const Vec<2>& start, const Vec<2>& direction, double least) const
{
    Hit hit;
    hit.way = std::numeric_limits<double>::infinity();
    const double near = parameters.least_stretch, touching = parameters.joint_distance;
    for (std::size_t a = 0; a < arcs.size(); ++a)
        for (std::size_t k = 0; k < arcs[a].segments.size(); ++k) {
            const ArcSegment& segment = arcs[a].segments[k];
            double way, t;
            if (!segment.curve) { // start + way direction = from + t along, from its left
                const Vec<2> along = segment.to - segment.from, r = segment.from - start;
                const double turn = cross(direction, along);
                if (!(turn > touching * along.norm())) // away from it, or along it to round-off
                    continue;
                way = cross(r, along) / turn;
                t = cross(r, direction) / turn;
                const double margin = near / along.norm();
                if (t < -margin || t > 1 + margin)
                    continue;
                t = std::clamp(t, 0.0, 1.0);
            } else { // into the ellipse, or out of it where the solid is its outside
                const Vec<2> s = segment.curve->scaled(start), e = segment.curve->axes(direction);
                const double A = e.squaredNorm(), B = s.dot(e), C = s.squaredNorm() - 1, root2 = B * B - A * C;
                if (!(root2 > 0))
                    continue;
                way = (-B + (segment.backwards ? 1 : -1) * std::sqrt(root2)) / A;
                const Vec<2> x = start + way * direction;
                t = segment.nearest(x);
                if ((segment.at(t) - x).norm() > touching)
                    continue;
            }
            if (way > least && way < hit.way)
                hit = {std::max(way, 0.0), static_cast<int>(a), static_cast<int>(k), t};
        }
    return hit;
}

int Square::split_arc(int a, int segment, double t, const Vec<2>& x)
{
    SquareArc& arc = arcs[a];
    SquareArc rest = arc;
    rest.segments.clear();
    InlineVector<ArcSegment, 3> head;
    for (int k = 0; k < static_cast<int>(arc.segments.size()); ++k) {
        const ArcSegment& s = arc.segments[k];
        if (k < segment || (k == segment && t > 0)) {
            head.push_back(k < segment ? s : s.part(0, t));
            if (k == segment)
                head[head.size() - 1].to = x;
        }
        if (k > segment || (k == segment && t < 1)) {
            rest.segments.push_back(k > segment ? s : s.part(t, 1));
            if (k == segment)
                rest.segments[rest.segments.size() - 1].from = x;
        }
    }
    const bool loop = arc.start.edge < 0 && arc.end.edge < 0 && (arc.joins == -1 || arc.joins == a);
    if (loop) {
        for (const ArcSegment& s : head)
            rest.segments.push_back(s);
        arc.segments = rest.segments;
        arc.from = arc.to = x;
        arc.joins = pending;
        return a;
    }
    rest.start = {};
    rest.from = x;
    arc.segments = head;
    arc.end = {};
    arc.to = x;
    arc.joins = pending;
    arcs.push_back(rest);
    return static_cast<int>(arcs.size()) - 1;
}

/// The stretch of the ring within which a place lies; -1: none, or at its end.
int Square::ring_at(const OnEdge& place) const
{
    for (std::size_t r = 0; r < ring_.size(); ++r) {
        if (ring_[r].after < 0)
            return static_cast<int>(r);
        double way = along_ring(place) - along_ring(ring_[r].start);
        way += way < 0 ? 4 : 0;
        if (way > parameters.least_stretch && way < ring_length(ring_[r]) - parameters.least_stretch)
            return static_cast<int>(r);
    }
    return -1;
}

void Square::split_ring(int r, const OnEdge& place, int solid)
{
    const RingStretch old = ring_[r];
    const bool whole = old.after < 0;
    const double start = along_ring(old.start);
    const auto way = [&](const OnEdge& x) {
        const double w = along_ring(x) - start;
        return w < 0 ? w + 4 : w;
    };
    const double here = way(place);
    const int other = static_cast<int>(ring_.size());
    if (whole)
        ring_[r] = {place, place, solid, solid};
    else {
        ring_[r].end = place;
        ring_[r].after = solid;
        ring_.push_back({place, old.end, solid, old.after});
    }
    for (int e = 0; e < 4; ++e) {
        auto& list = stretches[e];
        for (std::size_t k = 0; k < list.size(); ++k) {
            if (ring_of_[e][k] != r)
                continue;
            if (e == place.edge && place.at > list[k].from && place.at < list[k].to) {
                list.insert(list.begin() + static_cast<long>(k), list[k]);
                list[k].to = list[k + 1].from = place.at;
                ring_of_[e].insert(ring_of_[e].begin() + static_cast<long>(k), r);
            }
            if (!whole && way({e, 0.5 * (list[k].from + list[k].to)}) > here)
                ring_of_[e][k] = other;
        }
    }
}

/// The nearest arc that ends or starts at a place of the border, as a hit.
Square::Hit Square::arc_end(const OnEdge& place) const
{
    const Vec<2> x = point(place);
    Hit hit;
    double least = parameters.joint_distance * parameters.joint_distance;
    for (std::size_t a = 0; a < arcs.size(); ++a) {
        if (arcs[a].segments.empty())
            continue;
        if (arcs[a].start.edge >= 0 && (arcs[a].from - x).squaredNorm() < least) {
            least = (arcs[a].from - x).squaredNorm();
            hit = {0, static_cast<int>(a), 0, 0};
        }
        if (arcs[a].end.edge >= 0 && (arcs[a].to - x).squaredNorm() < least) {
            least = (arcs[a].to - x).squaredNorm();
            hit = {0, static_cast<int>(a), static_cast<int>(arcs[a].segments.size()) - 1, 1};
        }
    }
    return hit;
}

/// Where a ray leaves the rectangle.
std::pair<double, OnEdge> Square::exit_of(const Vec<2>& start, const Vec<2>& direction) const
{
    double way = std::numeric_limits<double>::infinity();
    OnEdge exit;
    for (int axis = 0; axis < 2; ++axis) {
        const double to = direction[axis] > 0 ? high[axis] : low[axis], t = (to - start[axis]) / direction[axis];
        if (direction[axis] != 0 && t < way) {
            way = t;
            exit.edge = axis == 0 ? (direction[axis] > 0 ? 1 : 3) : (direction[axis] > 0 ? 2 : 0);
        }
    }
    const int along = exit.edge % 2;
    exit.at = start[along] + way * direction[along];
    for (const double end : {low[along], high[along]})
        if (std::abs(exit.at - end) < parameters.least_stretch)
            exit.at = end;
    return {way, exit};
}

/// A fin from p to q, at both of which the border is open: on return it is led along the fin's two sides.
void Square::add_fin(const Vec<2>& p, End from, const Vec<2>& q, const End& to, int solid, int fin)
{
    if (from.ends >= 0 && from.ends == to.ends && to.starts != to.ends)
        from.ends = to.starts; // what ended at p now starts at q
    SquareArc out, back;
    out.solid = back.solid = solid;
    out.from = back.to = p;
    out.to = back.from = q;
    out.segments.push_back({p, q, nullptr, -1, false, false, fin});
    back.segments.push_back({q, p, nullptr, -1, false, false, fin});
    const int o = static_cast<int>(arcs.size()), b = o + 1;
    out.start = back.end = from.place;
    out.end = back.start = to.place;
    if (from.ends >= 0) {
        arcs[from.ends].joins = o;
        back.joins = from.starts;
    }
    if (to.ends >= 0) {
        arcs[to.ends].joins = b;
        out.joins = to.starts;
    } else if (to.place.edge < 0)
        out.joins = b; // it ends in the fluid
    arcs.push_back(out);
    arcs.push_back(back);
}

/// At a place of the rectangle's border; nothing where it is covered.
std::optional<Square::End> Square::open_border(const OnEdge& place, int solid)
{
    if (const int ring = ring_at(place); ring >= 0) {
        split_ring(ring, place, solid);
        End end;
        end.place = place;
        return end;
    }
    if (const Hit hit = arc_end(place); hit.arc >= 0)
        return open_at(hit, point(place));
    return {};
}

void Square::divide(int number)
{
    const SquareCorner& corner = corners[number];
    const Hit joint = joint_at(corner.solid, corner.at, corner.outward);
    if (joint.arc < 0)
        return; // covered by another solid
    const Vec<2> p = arcs[joint.arc].segments[joint.segment].to;
    const auto [way, exit] = exit_of(p, corner.outward);
    const Hit hit = nearest_hit(p, corner.outward, -parameters.joint_distance);
    const bool border = hit.way > way;
    if (border && ring_at(exit) < 0 && arc_end(exit).arc < 0)
        return;
    const End from = open_at(joint, p);
    if (border) {
        const auto to = open_border(exit, corner.solid);
        add_fin(p, from, point(exit), *to, corner.solid, number);
    } else {
        const Hit again = nearest_hit(p, corner.outward, -parameters.joint_distance); // the joint's arc was split
        const Vec<2> q = arcs[again.arc].segments[again.segment].at(again.t);
        const End to = open_at(again, q);
        add_fin(p, from, q, to, corner.solid, number);
    }
}

/// Draws a line from its first end (turned: its last) if the border is open there; to the next solid or to the line's other end.
bool Square::draw(int number, bool turned)
{
    const SquareLine& line = lines[number];
    const int fin = static_cast<int>(corners.size()) + number;
    const Vec<2>&p = turned ? line.to : line.from, &q = turned ? line.from : line.to;
    const OnEdge &start = turned ? line.to_border : line.from_border, &end = turned ? line.from_border : line.to_border;
    const Vec<2> direction = (q - p).normalized();
    std::optional<End> from;
    if (start.edge >= 0)
        from = open_border(start, line.solid);
    else if (const Hit joint = joint_at(line.solid, p, direction); joint.arc >= 0)
        from = open_at(joint, p);
    if (!from)
        return false;
    const double touching = parameters.joint_distance;
    const Hit hit = nearest_hit(p, direction, touching);
    if (hit.way < (q - p).norm() - touching) {
        const Vec<2> x = arcs[hit.arc].segments[hit.segment].at(hit.t);
        const End to = open_at(hit, x);
        add_fin(p, *from, x, to, line.solid, fin);
        return true;
    }
    End to;
    if (end.edge >= 0) {
        if (const auto opened = open_border(end, line.solid))
            to = *opened;
    } else if (const Hit joint = joint_at(line.solid, q, -direction); joint.arc >= 0)
        to = open_at(joint, q);
    add_fin(p, *from, q, to, line.solid, fin);
    return true;
}

/// Those first that hang on what is there.
void Square::draw_lines()
{
    std::vector<bool> drawn(lines.size(), false);
    for (bool any = true; any;) {
        any = false;
        for (std::size_t k = 0; k < lines.size(); ++k)
            for (const bool turned : {false, true})
                if (!drawn[k] && draw(static_cast<int>(k), turned))
                    any = drawn[k] = true;
    }
}

void Square::find_links()
{
    struct Side {
        double from, to;
        int piece;
    };
    for (std::size_t k = 0; k < corners.size() + lines.size(); ++k) {
        std::array<InlineVector<Side, 2>, 2> sides;
        const bool ray = k < corners.size();
        const std::size_t number = ray ? k : k - corners.size();
        const Vec<2> p = ray ? corners[k].at : lines[number].from,
                     direction = ray ? corners[k].outward : Vec<2>((lines[number].to - lines[number].from).normalized());
        for (const SquareArc& arc : arcs)
            for (const ArcSegment& segment : arc.segments)
                if (segment.fin == static_cast<int>(k)) {
                    const double from = (segment.from - p).dot(direction), to = (segment.to - p).dot(direction);
                    sides[to > from ? 0 : 1].push_back({std::min(from, to), std::max(from, to), arc.piece});
                }
        for (const Side& a : sides[0])
            for (const Side& b : sides[1]) {
                const double open = std::min(a.to, b.to) - std::max(a.from, b.from);
                if (open > 0 && a.piece != b.piece)
                    links.push_back({static_cast<int>(k), a.piece, b.piece, open});
            }
    }
}

/// The line of which one of two arcs that follow each other is a side.
int Square::fin_between(int a, int b) const
{
    for (const int arc : {a, b})
        if (arc >= 0 && !arcs[arc].segments.empty() && arcs[arc].segments[0].fin >= 0)
            return arcs[arc].segments[0].fin;
    return -1;
}

void Square::walk()
{
    const auto arc_at = [&](const OnEdge& place, int solid) {
        for (std::size_t a = 0; a < arcs.size(); ++a)
            if (arcs[a].piece < 0 && arcs[a].start.edge >= 0 && arcs[a].start == place && arcs[a].solid == solid)
                return static_cast<int>(a);
        return -1;
    };
    const auto nearest_arc = [&](const Vec<2>& x) {
        int best = -1;
        double least = parameters.joint_distance * parameters.joint_distance;
        for (std::size_t a = 0; a < arcs.size(); ++a)
            if (arcs[a].piece < 0 && arcs[a].start.edge >= 0 && (arcs[a].from - x).squaredNorm() < least) {
                least = (arcs[a].from - x).squaredNorm();
                best = static_cast<int>(a);
            }
        return best;
    };
    for (std::size_t first = 0; first < ring_.size(); ++first) {
        if (ring_[first].piece >= 0)
            continue;
        const int piece = static_cast<int>(pieces.size());
        sum_ = {};
        if (ring_[first].after < 0) { // all of the border
            const Vec<2> size = high - low;
            sum_ = {size.prod(), size.prod() * 0.5 * (low + high)};
            ring_[first].piece = piece;
        } else {
            start_ = here_ = point(ring_[first].start);
            int ring = static_cast<int>(first), last = -1;
            while (ring >= 0 && ring_[ring].piece < 0) {
                ring_[ring].piece = piece;
                add_border(ring);
                int arc = arc_at(ring_[ring].end, ring_[ring].after);
                int from = ring_[ring].after;
                if (arc < 0)
                    arc = nearest_arc(here_);
                ring = -1;
                while (arc >= 0) {
                    SquareArc& a = arcs[arc];
                    if (a.piece >= 0)
                        break;
                    a.piece = piece;
                    if (a.solid != from)
                        junctions.push_back({piece, from, a.solid, a.from, fin_between(last, arc)});
                    last = arc;
                    from = a.solid;
                    if (a.end.edge < 0) {
                        if (a.joins >= 0)
                            join(a, arcs[a.joins]);
                        add_arc(arc);
                        arc = a.joins;
                        continue;
                    }
                    // At the border: open there, or closed by another solid that touches this one.
                    bool opens = false;
                    for (const RingStretch& r : ring_)
                        opens = opens || (r.start == a.end && r.before == a.solid);
                    const int other = opens ? -1 : nearest_arc(a.to);
                    if (other >= 0) {
                        join(a, arcs[other]);
                        add_arc(arc);
                        arc = other;
                        continue;
                    }
                    ring = next_ring(a);
                    add_arc(arc);
                    break;
                }
            }
            if (last >= 0 && here_ != start_) { // solids that overlap in a way that was not resolved: straight back
                arcs[last].segments.push_back({here_, start_, nullptr, -1, false, false});
                arcs[last].to = start_;
            }
        }
        pieces.push_back({sum_.area, sum_.moment});
    }
}

void Square::close_loops()
{
    struct Loop {
        Bulge sum;
        std::vector<int> arcs;
    };
    std::vector<Loop> holes;
    const auto own = [&](const std::vector<int>& loop, int piece) {
        for (const int k : loop) {
            arcs[k].piece = piece;
            if (const int next = arcs[k].joins; next >= 0 && arcs[next].solid != arcs[k].solid)
                junctions.push_back({piece, arcs[k].solid, arcs[next].solid, arcs[k].to, fin_between(k, next)});
        }
    };
    for (std::size_t first = 0; first < arcs.size(); ++first) {
        if (arcs[first].piece >= 0 || arcs[first].start.edge >= 0)
            continue;
        Loop loop;
        start_ = here_ = arcs[first].from;
        sum_ = {};
        int a = static_cast<int>(first);
        bool closed = false;
        while (a >= 0 && arcs[a].piece == -1 && arcs[a].start.edge < 0) {
            arcs[a].piece = -2; // under way
            loop.arcs.push_back(a);
            if (arcs[a].joins >= 0)
                join(arcs[a], arcs[arcs[a].joins]);
            add_arc(a);
            closed = arcs[a].joins == static_cast<int>(first) || (arcs[a].joins < 0 && arcs[a].end.edge < 0);
            a = arcs[a].joins;
        }
        for (const int k : loop.arcs)
            arcs[k].piece = -1;
        if (!closed)
            for (const int k : loop.arcs)
                arcs[k].start.edge = 4; // belongs to nothing
        if (!closed)
            continue;
        sum_ += triangle(start_, here_, start_);
        loop.sum = sum_;
        if (sum_.area > 0) {
            own(loop.arcs, static_cast<int>(pieces.size()));
            pieces.push_back({sum_.area, sum_.moment});
        } else
            holes.push_back(loop);
    }
    for (const Loop& hole : holes) {
        if (pieces.empty())
            continue;
        int owner = 0;
        if (pieces.size() > 1) { // the piece around it: its border turns once around a point of the hole
            const Vec<2> x = arcs[hole.arcs[0]].from;
            for (std::size_t p = 0; p < pieces.size(); ++p) {
                double turn = 0;
                Vec<2> last = Vec<2>::Zero();
                const auto go = [&](const Vec<2>& a, const Vec<2>& b) {
                    const Vec<2> r = a - x, q = b - x;
                    turn += std::atan2(cross(r, q), r.dot(q));
                    last = b;
                };
                for (const RingStretch& r : ring_)
                    if (r.piece == static_cast<int>(p)) {
                        Vec<2> from = point(r.start);
                        const double begin = along_ring(r.start), end = begin + ring_length(r);
                        for (int c = static_cast<int>(std::floor(begin)) + 1; c < end; ++c) {
                            go(from, corner(c % 4));
                            from = corner(c % 4);
                        }
                        go(from, point(r.end));
                    }
                for (const SquareArc& a : arcs)
                    if (a.piece == static_cast<int>(p))
                        for (const ArcSegment& segment : a.segments) {
                            const int steps = segment.curve ? 16 : 1;
                            for (int i = 0; i < steps; ++i)
                                go(segment.at(static_cast<double>(i) / steps), segment.at(static_cast<double>(i + 1) / steps));
                        }
                if (turn > std::numbers::pi)
                    owner = static_cast<int>(p);
            }
        }
        own(hole.arcs, owner);
        pieces[owner].area += hole.sum.area;
        pieces[owner].centroid += hole.sum.moment;
    }
    // Centroids from moments.
    for (SquarePiece& piece : pieces)
        piece.centroid = piece.area > 0 ? Vec<2>(piece.centroid / piece.area) : Vec<2>(0.5 * (low + high));
    std::erase_if(arcs, [](const SquareArc& a) { return a.piece < 0; });
}

void Square::cut(const Depth* depth)
{
    pieces.clear();
    links.clear();
    junctions.clear();
    find_open_stretches();
    find_arcs();
    if (depth && solids.size() > 1)
        keep_outer(*depth);
    for (std::size_t k = 0; k < corners.size(); ++k)
        divide(static_cast<int>(k));
    draw_lines();
    walk();
    close_loops();
    for (int e = 0; e < 4; ++e)
        for (std::size_t k = 0; k < stretches[e].size(); ++k)
            stretches[e][k].piece = ring_[ring_of_[e][k]].piece;
    find_links();
}

} // namespace gapflow
