// Open stretches of a rectangle's border, arcs of convex solids, and the walk around the pieces.
#include "gapflow/complex/parameters.hpp"
#include "gapflow/complex/square_helpers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace gapflow {

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
        // The section of a face that lies in the plane ends anywhere.
        for (ArcSegment& segment : arc.segments)
            if (!segment.curve) {
                segment.from = segment.from.cwiseMax(low).cwiseMin(high);
                segment.to = segment.to.cwiseMax(low).cwiseMin(high);
            }
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

void Square::add_border(int ring)
{
    const RingStretch& r = ring_[ring];
    const auto to = [&](const Vec<2>& x) {
        sum_ += triangle(start_, here_, x);
        add_chord(x, -1, -1);
        here_ = x;
    };
    const double from = along_ring(r.start), end = from + ring_length(r);
    for (int c = static_cast<int>(std::floor(from)) + 1; c < end; ++c)
        to(corner(c % 4));
    to(point(r.end));
}

void Square::add_chord(const Vec<2>& to, int solid, int fin)
{
    if (with_chords)
        chords.push_back({piece_, here_, to, solid, fin});
}

void Square::add_arc(int arc)
{
    const SquareArc& a = arcs[arc];
    if (with_chords) {
        const Vec<2> here = here_;
        for (const ArcSegment& segment : a.segments)
            for (int k = 1, n = segment.chords(); k <= n; ++k) {
                const Vec<2> to = k < n ? segment.at(static_cast<double>(k) / n) : segment.to;
                add_chord(to, a.solid, segment.fin);
                here_ = to;
            }
        here_ = here;
    }
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

void Square::lead(const Vec<2>& x, SquareArc& arc)
{
    if (x == arc.from)
        return;
    InlineVector<ArcSegment, 3> segments;
    segments.push_back({x, arc.from, nullptr, -1, false, false}); // equal to round-off
    for (const ArcSegment& segment : arc.segments)
        segments.push_back(segment);
    arc.segments = segments;
    arc.from = x;
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

void Square::walk()
{
    const auto arc_at = [&](const OnEdge& place, int solid) { // of another solid, where the own one's overlaps with it
        int other = -1;
        for (std::size_t a = 0; a < arcs.size(); ++a)
            if (arcs[a].piece < 0 && arcs[a].start.edge >= 0 && arcs[a].start == place) {
                other = static_cast<int>(a);
                if (arcs[a].solid == solid)
                    break;
            }
        return other;
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
        piece_ = piece;
        sum_ = {};
        if (ring_[first].after < 0) { // all of the border
            const Vec<2> size = high - low;
            sum_ = {size.prod(), size.prod() * 0.5 * (low + high)};
            ring_[first].piece = piece;
            here_ = corner(0);
            for (int c = 1; c <= 4; ++c) {
                add_chord(corner(c % 4), -1, -1);
                here_ = corner(c % 4);
            }
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
                if (arc >= 0 && arcs[arc].solid != from)
                    lead(here_, arcs[arc]);
                ring = -1;
                while (arc >= 0) {
                    SquareArc& a = arcs[arc];
                    if (a.piece >= 0)
                        break;
                    a.piece = piece;
                    if (a.solid != from)
                        junctions.push_back({piece, from, a.solid, a.from, {fin_of(last), fin_of(arc)}});
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
                    if (ring >= 0 && ring_[ring].before >= 0 && ring_[ring].before != a.solid)
                        junctions.push_back({piece, a.solid, ring_[ring].before, a.to, {fin_of(arc), -1}});
                    add_arc(arc);
                    break;
                }
            }
            if (last >= 0 && here_ != start_) { // solids that overlap in a way that was not resolved: straight back
                arcs[last].segments.push_back({here_, start_, nullptr, -1, false, false});
                arcs[last].to = start_;
                add_chord(start_, arcs[last].solid, -1);
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
        std::size_t chords, chords_end;
    };
    std::vector<Loop> holes;
    const auto own = [&](const Loop& loop, int piece) {
        for (std::size_t k = loop.chords; k < loop.chords_end; ++k)
            chords[k].piece = piece;
        for (const int k : loop.arcs) {
            arcs[k].piece = piece;
            if (const int next = arcs[k].joins; next >= 0 && arcs[next].solid != arcs[k].solid)
                junctions.push_back({piece, arcs[k].solid, arcs[next].solid, arcs[k].to, {fin_of(k), fin_of(next)}});
        }
    };
    for (std::size_t first = 0; first < arcs.size(); ++first) {
        if (arcs[first].piece != -1 || arcs[first].start.edge >= 0)
            continue;
        Loop loop{{}, {}, chords.size(), 0};
        start_ = here_ = arcs[first].from;
        sum_ = {};
        int a = static_cast<int>(first);
        bool closed = false;
        while (a >= 0 && arcs[a].piece == -1 && arcs[a].start.edge < 0) {
            arcs[a].piece = -2; // of a loop
            loop.arcs.push_back(a);
            if (arcs[a].joins >= 0)
                join(arcs[a], arcs[arcs[a].joins]);
            add_arc(a);
            closed = arcs[a].joins == static_cast<int>(first) || (arcs[a].joins < 0 && arcs[a].end.edge < 0);
            a = arcs[a].joins;
        }
        if (!closed) {
            for (const int k : loop.arcs)
                arcs[k].start.edge = 4; // belongs to nothing
            chords.resize(loop.chords);
            continue;
        }
        loop.chords_end = chords.size();
        sum_ += triangle(start_, here_, start_);
        loop.sum = sum_;
        if (sum_.area > 0) {
            own(loop, static_cast<int>(pieces.size()));
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
        own(hole, owner);
        pieces[owner].area += hole.sum.area;
        pieces[owner].centroid += hole.sum.moment;
    }
    // Centroids from moments.
    for (SquarePiece& piece : pieces)
        piece.centroid = piece.area > 0 ? Vec<2>(piece.centroid / piece.area) : Vec<2>(0.5 * (low + high));
    std::erase_if(arcs, [](const SquareArc& a) { return a.piece < 0; });
}

void Square::cut()
{
    pieces.clear();
    links.clear();
    junctions.clear();
    chords.clear();
    find_open_stretches();
    find_arcs();
    if (solids.size() > 1)
        keep_outer();
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
