#include "gapflow/complex/cut_faces.hpp"

#include "gapflow/complex/area_derivative.hpp"
#include "gapflow/complex/face_helpers.hpp"
#include "gapflow/complex/general_cut.hpp"
#include "gapflow/complex/lever.hpp"
#include "gapflow/complex/mark_faces.hpp"
#include "gapflow/complex/parameters.hpp"
#include "gapflow/complex/surface_rate.hpp"
#include "gapflow/core/threads.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>
#include <utility>

namespace gapflow {
namespace {

void add_facets(std::vector<ArcFacet>& facets, std::int32_t number, const SquareArc& arc)
{
    std::int32_t last = -1;
    for (const ArcSegment& segment : arc.segments)
        if (segment.fin < 0 && segment.surface >= 0 && segment.surface != last)
            facets.push_back({number, last = segment.surface});
}

/// From the corner back along its line to the rectangle's border, or along one of its sides out of the domain if that is nearer: a side whose end is in reach is
/// all that the flow must go around.
struct CoveredWay {
    double length;
    int axis;    ///< across which it ends
    Vec<2> back; ///< of unit length
};
CoveredWay covered_way(const SharpCorner& corner, const Square& square)
{
    double covered = std::numeric_limits<double>::infinity();
    int across = 0;
    for (int axis = 0; axis < 2; ++axis)
        if (const double slope = corner.outward[axis]; slope != 0)
            if (const double way = (corner.at[axis] - (slope > 0 ? square.low[axis] : square.high[axis])) / slope;
                way < covered) {
                covered = way;
                across = axis;
            }
    if (corner.length_out > 0 && corner.length_out < covered)
        return {corner.length_out, corner.axis_out, corner.way_out};
    return {covered, across, -corner.outward};
}

/// Rates of what one face's solids and lines define.
template <int D>
class FaceRates {
public:
    FaceRates(const GeneralCut<D>& general, const Square& square, const std::vector<int>& images, int d, double at,
              const std::vector<PlacedSolid<D>>& solids, Slab<D>& slab)
        : general_(general), square_(square), images_(images), d_(d), at_(at), solids_(solids), slab_(slab)
    {
    }

    /// How the junctions move, and how long the dividing lines are; in 2D the conductances of its links. Before the face's own are added to the slab.
    void add()
    {
        for (const SquareJunction& j : square_.junctions)
            slab_.junction_rates.push_back(junction(j));
        for (std::size_t k = 0; k < square_.links.size(); ++k) {
            number_ = static_cast<int>(slab_.divisions.size() + k);
            if constexpr (D == 2)
                add_conductance(square_.links[k]);
            else
                add_open(square_.links[k], 1);
        }
    }

private:
    static bool close(const Vec<2>& x, const Vec<2>& y) { return (x - y).norm() < parameters.joint_distance; }
    /// Segments of no length, or that only join ends equal to round-off, have no direction.
    static bool has_direction(const ArcSegment& segment)
    {
        return (segment.surface != -1 || segment.fin >= 0) && (segment.whole || segment.from != segment.to);
    }

    MovingLine<D> line(const SquareArc& arc, ArcSegment segment, bool end) const
    {
        if constexpr (D == 3)
            if (segment.fin >= 0) {
                const int image = images_[arc.solid], edge = general_.line(segment.fin).edge;
                const PlacedSolid<3>& solid = solids_[image];
                segment.surface = surface_of_fin(edge);
                if (const int rim = edge - static_cast<int>(solid.sharp.edges.size()); rim >= 0) {
                    const RimSpeeds speeds =
                        rim_speeds(solid.sharp.rims[rim], solid.reference, d_, at_, square_.low, square_.high, segment);
                    const Vec<2> way = segment.to - segment.from;
                    return {Vec<2>(-way[1], way[0]).normalized(), end ? speeds.to : speeds.from, image};
                }
            }
        return moving_line<D>(solids_, images_[arc.solid], d_, at_, segment, end);
    }
    MovingLine<D> line_at_end(const SquareArc& arc) const
    {
        for (std::size_t k = arc.segments.size(); k-- > 0;)
            if (has_direction(arc.segments[k]))
                return line(arc, arc.segments[k], true);
        return {};
    }
    MovingLine<D> line_at_start(const SquareArc& arc) const
    {
        for (const ArcSegment& segment : arc.segments)
            if (has_direction(segment))
                return line(arc, segment, false);
        return {};
    }

    PointRates<D> junction(const SquareJunction& j) const
    {
        const auto find = [&](int solid, bool end) {
            return std::find_if(square_.arcs.begin(), square_.arcs.end(), [&](const SquareArc& arc) {
                return arc.piece == j.piece && arc.solid == solid && close(end ? arc.to : arc.from, j.at);
            });
        };
        const auto before = find(j.from, true), after = find(j.to, false);
        if (before == square_.arcs.end() || after == square_.arcs.end())
            return {};
        return meeting_rates<D>(d_, line_at_end(*before), line_at_start(*after));
    }

    void add_rate(int image, const Twist<D>& rate) { slab_.division_rates.push_back({number_, image, rate}); }

    /// Factor times the rate of the length over which a dividing line parts two pieces: its ends lie where it meets other lines.
    void add_open(const SquareLink& link, double factor)
    {
        for (const SquareArc& out : square_.arcs)
            for (const ArcSegment& a : out.segments) {
                if (a.fin != link.fin || out.piece != link.a)
                    continue;
                const Vec<2> direction = (a.to - a.from).normalized();
                for (const SquareArc& back : square_.arcs)
                    for (const ArcSegment& b : back.segments) {
                        if (b.fin != link.fin || back.piece != link.b || (b.to - b.from).dot(direction) > 0)
                            continue;
                        const bool later = (b.to - a.from).dot(direction) > 0, sooner = (b.from - a.to).dot(direction) < 0;
                        const Vec<2>&from = later ? b.to : a.from, &to = sooner ? b.from : a.to;
                        if (std::abs((to - from).dot(direction) - link.open) > parameters.joint_distance)
                            continue;
                        ArcSegment between = a; // a line that turns is faster at one end
                        between.from = from;
                        between.to = to;
                        add_end(line(out, between, true), to, direction, factor);
                        add_end(line(out, between, false), from, direction, -factor);
                        return;
                    }
            }
    }
    void add_end(const MovingLine<D>& own, const Vec<2>& x, const Vec<2>& direction, double factor)
    {
        MovingLine<D> across;
        double most = 0; // of what meets there, the one most across
        const auto offer = [&](const MovingLine<D>& other) {
            if (const double slant = std::abs(other.normal.dot(direction)); slant > most) {
                most = slant;
                across = other;
            }
        };
        for (const SquareArc& arc : square_.arcs)
            for (const ArcSegment& segment : arc.segments)
                if (has_direction(segment))
                    for (const bool end : {false, true})
                        if (close(end ? segment.to : segment.from, x))
                            offer(line(arc, segment, end));
        if (most < parameters.parallel) // on the rectangle's border
            for (int axis = 0; axis < 2; ++axis)
                if (std::min(std::abs(x[axis] - square_.low[axis]), std::abs(x[axis] - square_.high[axis])) <
                    parameters.joint_distance)
                    offer({unit<2>(axis), Twist<D>::Zero(), -1});
        Vec<D> way = Vec<D>::Zero();
        way[u_axis<D>(d_)] = direction[0];
        way[v_axis<D>(d_)] = direction[1];
        for (const PointRate<D>& r : meeting_rates<D>(d_, own, across))
            add_rate(r.solid, factor * r.rate.transpose() * way);
    }

    /// g = c open/covered.
    void add_conductance(const SquareLink& link) requires(D == 2)
    {
        if (link.fin >= static_cast<int>(square_.corners.size()))
            return;
        const SharpCorner& corner = general_.corner(link.fin);
        const int image = images_[square_.corners[link.fin].solid];
        const auto [covered, axis, back] = covered_way(corner, square_);
        if (!(covered > parameters.least_covered) || !(corner.own > 0))
            return;
        const double by_open = corner_conductance(corner.angle, 1, covered) / corner.own;
        add_open(link, by_open);
        // Back from the corner, to the rectangle's border.
        const Vec<2> n = -back, x = corner.at - covered * n, normal(-n[1], n[0]), arm = solids_[image].reference;
        const MovingLine<2> own{normal, lever<2>(normal, x - arm), image};
        for (const PointRate<2>& r : meeting_rates<2>(d_, own, {unit<2>(axis), Twist<2>::Zero(), -1}))
            add_rate(image, link.open * by_open / covered * (r.rate.transpose() * n - lever<2>(n, corner.at - arm)));
    }

    const GeneralCut<D>& general_;
    const Square& square_;
    const std::vector<int>& images_;
    int d_;
    double at_;
    const std::vector<PlacedSolid<D>>& solids_;
    Slab<D>& slab_;
    int number_ = 0; ///< of the division
};

template <int D>
void cut_general(const CutFaces<D>& cut, const GridPlanes<D>& planes, const DenseIndex<D>& index,
                 const std::vector<PlacedSolid<D>>& solids, Slab<D>& slab)
{
    GeneralCut<D> general(cut, planes, index, solids);
    for (CutFace<D>& face : slab.faces) {
        if (face.state != CutFace<D>::State::general)
            continue;
        FaceDetail& detail = slab.details[face.detail];
        const int d = face.axis;
        const double at = plane_of(planes, d, index.index(face.id));
        const Square& square = general.cut(face, detail, slab.facets);
        if (cut.for_derivatives)
            FaceRates<D>(general, square, detail.images, d, at, solids, slab).add();
        face.piece = static_cast<std::int32_t>(slab.pieces.size());
        face.arc = static_cast<std::int32_t>(slab.arcs.size());
        face.pieces = static_cast<std::int32_t>(square.pieces.size());
        face.arcs = static_cast<std::int32_t>(square.arcs.size());
        slab.pieces.insert(slab.pieces.end(), square.pieces.begin(), square.pieces.end());
        for (const SquareArc& arc : square.arcs) {
            const int image = detail.images[arc.solid];
            if (D == 3 && std::holds_alternative<FacetKind<D>>(solids[image].kind))
                add_facets(slab.arc_facets, static_cast<std::int32_t>(slab.arcs.size()), arc);
            slab.arcs.push_back(border_arc<D>(image, arc.piece, d, at, solids[image].reference, arc.from, arc.to, arc.bulge()));
        }
        for (int e = 0; e < 4; ++e) {
            detail.stretch[e] = static_cast<int>(slab.stretches.size());
            slab.stretches.insert(slab.stretches.end(), square.stretches[e].begin(), square.stretches[e].end());
        }
        detail.stretch[4] = static_cast<int>(slab.stretches.size());
        detail.junction = static_cast<int>(slab.junctions.size());
        detail.junctions = static_cast<int>(square.junctions.size());
        for (const SquareJunction& j : square.junctions) {
            Junction<D> junction{j.piece, detail.images[j.from], detail.images[j.to], in_space<D>(d, at, j.at)};
            if constexpr (D == 3)
                for (const int fin : j.fin)
                    if (fin >= 0) {
                        const FaceLine& line = general.line(fin);
                        junction.edge = line.edge;
                        junction.solid = solids[line.image].solid;
                        junction.sides &= line.sides;
                        ++junction.lines;
                    }
            slab.junctions.push_back(junction);
        }
        detail.division = static_cast<int>(slab.divisions.size());
        detail.divisions = static_cast<int>(square.links.size());
        for (const SquareLink& link : square.links) {
            if constexpr (D == 3) {
                const FaceLine& line = general.line(link.fin);
                slab.divisions.push_back({line.image, link.a, link.b, 0, link.open, 0, Vec<D>::Zero(), line.edge, line.sides});
            } else {
                const SharpCorner& corner = general.corner(link.fin);
                const bool own = link.fin < static_cast<int>(square.corners.size()); // the corner's cell
                const double covered = own ? covered_way(corner, square).length : 0,
                             alone = corner_conductance(corner.angle, link.open, covered),
                             // as stiff as the corner, or as any link is
                    conductance = own ? std::max(alone, 1 / std::max(parameters.least_covered, corner.own / alone)) : link.open;
                const int k = own ? square.corners[link.fin].solid : square.lines[link.fin - square.corners.size()].solid;
                slab.divisions.push_back(
                    {detail.images[k], link.a, link.b, conductance, link.open, covered, corner.at, -1, 0, corner.mouth});
            }
        }
    }
}

} // namespace

template <int D>
CutFaces<D> cut_faces(const Grid<D>& grid, const GridPlanes<D>& planes, const DenseIndex<D>& index,
                      const std::vector<PlacedSolid<D>>& solids, bool for_derivatives)
{
    CutFaces<D> cut;
    for (auto& face : cut.face)
        face.assign(index.count, Complex<D>::open);
    const int first = index.low[D - 1], n = index.size[D - 1] - 1;
    for (int k = 0; k < n; k += parameters.slab) {
        cut.slabs.push_back({});
        cut.slabs.back().begin = first + k;
        cut.slabs.back().end = first + std::min(n, k + parameters.slab);
        for (int i = k; i < std::min(n, k + parameters.slab); ++i)
            cut.slab_of.push_back(static_cast<int>(cut.slabs.size()) - 1);
    }
    cut.slab_of.push_back(static_cast<int>(cut.slabs.size()) - 1);
    cut.grid = &grid;
    cut.for_derivatives = for_derivatives;
    for_each_job(static_cast<int>(cut.slabs.size()), [&](int s) {
        Slab<D>& slab = cut.slabs[s];
        slab.facets.resize(solids.size());
        for (std::size_t k = 0; k < solids.size(); ++k)
            mark_faces<D>(planes, index, solids[k], static_cast<int>(k), cut, slab);
        cut_general(cut, planes, index, solids, slab);
        if (!for_derivatives)
            slab.facets = {};
    });
    return cut;
}

template CutFaces<2> cut_faces(const Grid<2>&, const GridPlanes<2>&, const DenseIndex<2>&, const std::vector<PlacedSolid<2>>&,
                               bool);
template CutFaces<3> cut_faces(const Grid<3>&, const GridPlanes<3>&, const DenseIndex<3>&, const std::vector<PlacedSolid<3>>&,
                               bool);

} // namespace gapflow
