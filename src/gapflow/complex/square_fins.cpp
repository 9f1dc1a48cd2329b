// Lines by which sharp corners and edges divide a rectangle: fins of no thickness along which the border is led (theory of the complex, "Corners").
#include "gapflow/complex/parameters.hpp"
#include "gapflow/complex/square_helpers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace gapflow {

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
        // At a fin's end the two are one direction but for round-off; a segment of no length has none.
        const bool tip = in.fin >= 0 && in.fin == out.fin && (in.to - in.from).dot(out.to - out.from) < 0;
        const double all = tip || w == Vec<2>::Zero() || v == Vec<2>::Zero() ? 2 * std::numbers::pi : angle(v);
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

/// `to_corners`: a segment that ends beside the ray counts, one that ends at its start does not, if it belongs to the solid `from` (-1: to any).
Square::Hit Square::nearest_hit(const Vec<2>& start, const Vec<2>& direction, double least, bool to_corners, int from) const
{
    Hit hit;
    hit.way = std::numeric_limits<double>::infinity();
    const double touching = parameters.joint_distance, near = to_corners ? touching : parameters.least_stretch;
    for (std::size_t a = 0; a < arcs.size(); ++a)
        for (std::size_t k = 0; k < arcs[a].segments.size(); ++k) {
            const ArcSegment& segment = arcs[a].segments[k];
            if (to_corners && (from < 0 || arcs[a].solid == from) &&
                ((segment.from - start).norm() < touching || (segment.to - start).norm() < touching))
                continue;
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
    const int n = static_cast<int>(arc.segments.size());
    for (int k = 0; k < n; ++k) {
        const ArcSegment& s = arc.segments[k];
        ArcSegment end = s; // of no length: an end of a dividing line's side stays one
        end.from = end.to = x;
        if (k < segment || (k == segment && t > 0)) {
            head.push_back(k < segment ? s : s.part(0, t));
            if (k == segment)
                head[head.size() - 1].to = x;
        } else if (k == segment && s.fin >= 0 && k == 0)
            head.push_back(end);
        if (k > segment || (k == segment && t < 1)) {
            rest.segments.push_back(k > segment ? s : s.part(t, 1));
            if (k == segment)
                rest.segments[rest.segments.size() - 1].from = x;
        } else if (k == segment && s.fin >= 0 && k + 1 == n)
            rest.segments.push_back(end);
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

/// The nearest arc that ends or starts at a place of the border, as a hit. Of several, as of the two sides of a line that ends there, one at whose
/// fluid's side a direction leads from there.
Square::Hit Square::arc_end(const OnEdge& place, const Vec<2>& direction) const
{
    const Vec<2> x = point(place);
    Hit hit;
    double least = parameters.joint_distance * parameters.joint_distance;
    bool in_front = false;
    const auto offer = [&](const Vec<2>& end, const Vec<2>& way, const Hit& at) {
        const double distance = (end - x).squaredNorm();
        const bool front = cross(way, direction) > 0;
        if (!(distance < parameters.joint_distance * parameters.joint_distance) || (in_front && !front) ||
            (in_front == front && !(distance < least)))
            return;
        least = distance;
        in_front = front;
        hit = at;
    };
    for (int a = 0; a < static_cast<int>(arcs.size()); ++a) {
        const SquareArc& arc = arcs[a];
        const int n = static_cast<int>(arc.segments.size());
        if (n == 0)
            continue;
        const ArcSegment &first = arc.segments[0], &last = arc.segments[n - 1];
        if (arc.start.edge >= 0)
            offer(arc.from, first.at(parameters.tangent_share) - first.from, {0, a, 0, 0});
        if (arc.end.edge >= 0)
            offer(arc.to, last.to - last.at(1 - parameters.tangent_share), {0, a, n - 1, 1});
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

/// At a place of the rectangle's border from which a line leads in a direction; nothing where it is covered.
std::optional<Square::End> Square::open_border(const OnEdge& place, const Vec<2>& direction, int solid)
{
    if (const int ring = ring_at(place); ring >= 0) {
        split_ring(ring, place, solid);
        End end;
        end.place = place;
        return end;
    }
    if (const Hit hit = arc_end(place, direction); hit.arc >= 0)
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
    const auto [way, exit] = exit_of(corner.to_wall ? corner.at : p, corner.outward);
    const Hit hit = nearest_hit(p, corner.outward, -parameters.joint_distance, corner.to_wall);
    const bool border = hit.way > way;
    if (border && ring_at(exit) < 0 && arc_end(exit, -corner.outward).arc < 0)
        return;
    const End from = open_at(joint, p);
    if (border) {
        const auto to = open_border(exit, -corner.outward, corner.solid);
        add_fin(p, from, point(exit), *to, corner.solid, number);
    } else {
        const Hit again =
            nearest_hit(p, corner.outward, -parameters.joint_distance, corner.to_wall); // the joint's arc was split
        const Vec<2> q = arcs[again.arc].segments[again.segment].at(again.t);
        const End to = open_at(again, q);
        add_fin(p, from, q, to, corner.solid, number);
    }
}

/// The place x of a dividing line's side as a hit on the line's other side.
Square::Hit Square::other_side(int arc, int segment, const Vec<2>& x) const
{
    const ArcSegment& side = arcs[arc].segments[segment];
    for (int a = 0; a < static_cast<int>(arcs.size()); ++a)
        for (int k = 0; k < static_cast<int>(arcs[a].segments.size()); ++k) {
            const ArcSegment& s = arcs[a].segments[k];
            if (s.fin != side.fin || !((s.to - s.from).dot(side.to - side.from) < 0))
                continue;
            const double t = s.nearest(x);
            if ((s.at(t) - x).norm() < parameters.joint_distance)
                return {0, a, k, t};
        }
    return {0, -1, 0, 0};
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
        from = open_border(start, direction, line.solid);
    else if (const Hit joint = joint_at(line.solid, p, direction); joint.arc >= 0)
        from = open_at(joint, p);
    if (!from)
        return false;
    const double touching = parameters.joint_distance;
    // Through the lines of other solids, which end at a solid. One in the rectangle's border to round-off leaves nothing open behind it.
    Vec<2> here = p;
    bool at_border = line.to_wall && from->place.edge >= 0;
    for (;;) {
        const Hit hit = at_border ? nearest_hit(here, direction, -touching, true, line.solid)
                                  : nearest_hit(here, direction, touching, line.to_wall);
        at_border = false;
        if (!(hit.way < (q - here).norm() - touching))
            break;
        const Vec<2> x = arcs[hit.arc].segments[hit.segment].at(hit.t);
        const bool through = arcs[hit.arc].solid != line.solid && arcs[hit.arc].segments[hit.segment].fin >= 0;
        const Hit behind = through ? other_side(hit.arc, hit.segment, x) : Hit{};
        const End to = open_at(hit, x);
        add_fin(here, *from, x, to, line.solid, fin);
        if (behind.arc < 0)
            return true;
        from = open_at(behind, x);
        here = x;
    }
    End to;
    if (end.edge >= 0) {
        if (const auto opened = open_border(end, -direction, line.solid))
            to = *opened;
    } else if (const Hit joint = joint_at(line.solid, q, -direction); joint.arc >= 0)
        to = open_at(joint, q);
    add_fin(here, *from, q, to, line.solid, fin);
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

/// The line of which an arc is a side.
int Square::fin_of(int arc) const
{
    return arc >= 0 && !arcs[arc].segments.empty() ? arcs[arc].segments[0].fin : -1;
}

} // namespace gapflow
