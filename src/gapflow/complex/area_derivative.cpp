#include "gapflow/complex/area_derivative.hpp"

#include "gapflow/complex/lever.hpp"
#include "gapflow/complex/surface_rate.hpp"
#include "gapflow/core/threads.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gapflow {
namespace {

/// Integrals along a segment, x from the face's centre.
struct SegmentIntegrals {
    Vec<2> normal;       ///< int nu ds
    Mat<2> first_normal; ///< int x_j nu_k ds
    Vec<2> turning;      ///< int x_j x . dx
    double half_square;  ///< int x . dx
    double slope;        ///< int slope ds
    Vec<2> first_slope;  ///< int x_j slope ds
    Mat<2> second_slope; ///< int x_j x_k slope ds
};

SegmentIntegrals integrate(const ArcSegment& segment, const Vec<2>& origin, const Slope& slope)
{
    // int x_j dx_l = mean_j (B - A)_l, and the bulge; the squares likewise (see curve.hpp).
    const Vec<2> A = segment.from - origin, B = segment.to - origin, way = segment.to - segment.from, mean = 0.5 * (A + B);
    Bulge bulge = segment.bulge();
    bulge.moment -= bulge.area * origin;
    Mat<2> first = mean * way.transpose(); // [j][l]
    first(0, 1) += bulge.area;
    first(1, 0) -= bulge.area;
    const auto square = [&](int j) { return (A[j] * A[j] + A[j] * B[j] + B[j] * B[j]) / 3; };
    const double uu_u = square(0) * way[0], vv_v = square(1) * way[1], uu_v = square(0) * way[1] + 2 * bulge.moment[0],
                 vv_u = square(1) * way[0] - 2 * bulge.moment[1], uv_u = 0.5 * (B[0] * B[0] * B[1] - A[0] * A[0] * A[1] - uu_v),
                 uv_v = 0.5 * (B[0] * B[1] * B[1] - A[0] * A[1] * A[1] - vv_u);

    SegmentIntegrals sum;
    sum.normal = {-way[1], way[0]}; // the fluid lies at the left
    sum.first_normal.col(0) = -first.col(1);
    sum.first_normal.col(1) = first.col(0);
    sum.turning = {uu_u + uv_v, uv_u + vv_v};
    sum.half_square = mean.dot(way);

    // slope = along . nu
    const Vec<2>& a = slope.along;
    sum.slope = a.dot(sum.normal);
    sum.first_slope = sum.first_normal * a;
    sum.second_slope(0, 0) = -a[0] * uu_v + a[1] * uu_u;
    sum.second_slope(0, 1) = sum.second_slope(1, 0) = -a[0] * uv_v + a[1] * uv_u;
    sum.second_slope(1, 1) = -a[0] * vv_v + a[1] * vv_u;
    if (slope.constant == 0)
        return sum;
    const double k = slope.constant;
    if (segment.curve && segment.curve->semi1 == segment.curve->semi2) { // x - c = +-radius nu
        const Vec<2> c = segment.curve->centre - origin;
        const double length = segment.length(), out = (segment.backwards ? -1 : 1) * segment.curve->semi1;
        const Mat<2> second = out * (sum.first_normal + sum.normal * c.transpose()) + length * c * c.transpose();
        sum.slope += k * length;
        sum.first_slope += k * (length * c + out * sum.normal);
        sum.second_slope += 0.5 * k * (second + second.transpose());
    } else { // straight, or of an ellipse so long that it is
        const double length = way.norm();
        sum.slope += k * length;
        sum.first_slope += k * length * mean;
        sum.second_slope += k * length * (mean * mean.transpose() + way * way.transpose() / 12);
    }
    return sum;
}

/// A chord of a rim's cone moves with its two ends.
void add_rim_chord(const FacePlane& face, const ArcSegment& segment, const RimSpeeds& speeds, PieceRate<3>& rate)
{
    const double length = (segment.to - segment.from).norm();
    const auto& [a, b] = speeds;
    const Vec<2> A = segment.from - face.centre, B = segment.to - face.centre;
    rate.area -= 0.5 * length * (a + b);
    for (const auto& [j, row] : {std::pair{0, u_axis<3>(face.d)}, {1, v_axis<3>(face.d)}})
        rate.moment.row(row) -= length / 6 * ((2 * A[j] + B[j]) * a + (A[j] + 2 * B[j]) * b).transpose();
}

template <int D>
PieceRate<D>& rate_of(std::vector<PieceRate<D>>& rates, std::size_t begin, const PlacedSolid<D>& image)
{
    for (std::size_t k = begin; k < rates.size(); ++k)
        if (rates[k].solid == image.solid && rates[k].reference == image.reference)
            return rates[k];
    rates.push_back({image.solid, image.reference});
    return rates.back();
}

/// Rates of all pieces of a slab's faces.
struct SlabRates {
    std::vector<std::int32_t> begin, end; ///< of each piece
    std::vector<PieceRate<3>> rates;
};

SlabRates slab_rates(const CutFaces<3>& cut, const GridPlanes<3>& planes, const DenseIndex<3>& index,
                     const std::vector<PlacedSolid<3>>& solids, const Slab<3>& slab)
{
    SlabRates result;
    result.begin.assign(slab.pieces.size(), 0);
    result.end = result.begin;
    FaceArcs<3> retrace(cut, planes, index, solids);
    for (const CutFace<3>& face : slab.faces) {
        if (face.state == CutFace<3>::State::dead || face.pieces == 0)
            continue;
        const Index<3> f = index.index(face.id);
        const int d = face.axis, u = u_axis<3>(d), v = v_axis<3>(d);
        const FacePlane plane{d,
                              planes.place[d][f[d]],
                              {0.5 * (planes.place[u][f[u]] + planes.place[u][f[u] + 1]),
                               0.5 * (planes.place[v][f[v]] + planes.place[v][f[v] + 1])}};
        const std::span<const SquareArc> arcs = retrace.of(slab, face);
        for (int p = 0; p < face.pieces; ++p) {
            const std::size_t begin = result.rates.size();
            for (const SquareArc& arc : arcs) {
                if (arc.piece != p)
                    continue;
                const PlacedSolid<3>& solid = solids[arc.solid];
                PieceRate<3>& rate = rate_of(result.rates, begin, solid);
                const int edges = static_cast<int>(solid.sharp.edges.size());
                for (const ArcSegment& segment : arc.segments)
                    if (const int edge = surface_of_fin(segment.surface); segment.surface < -1 && edge >= edges)
                        add_rim_chord(plane, segment,
                                      rim_speeds(solid.sharp.rims[edge - edges], solid.reference, d, plane.at,
                                                 {planes.place[u][f[u]], planes.place[v][f[v]]},
                                                 {planes.place[u][f[u] + 1], planes.place[v][f[v] + 1]}, segment),
                                      rate);
                    else
                        add_segment(plane, solid.reference, segment, slope_of(solid, d, plane.at, segment), rate);
            }
            result.begin[face.piece + p] = static_cast<std::int32_t>(begin);
            result.end[face.piece + p] = static_cast<std::int32_t>(result.rates.size());
        }
    }
    return result;
}

/// The solid that ends an open stretch of an edge of a 2D grid.
struct StretchEnd {
    double at;    ///< along the edge
    double least; ///< how far off the nearest solid's crossing lies
    const PlacedSolid<2>* solid = nullptr;
    Vec<2> place, moves, normal; ///< in the axes of its rectangle; it moves as the point `moves` of the border with this normal
};

/// Looks among the solids of one rectangle.
void find_end(const GridPlanes<2>& planes, const DenseIndex<2>& index, const std::vector<PlacedSolid<2>>& solids,
              const Slab<2>& slab, int number, int edge, StretchEnd& end)
{
    const CutFace<2>& face = slab.faces[number];
    const int axis = edge_axis<2>(0, edge);
    const Index<2> start = edge_start<2>(0, index.index(face.id), edge);
    const double low = planes.place[axis][start[axis]];
    Vec<2> x(planes.place[0][start[0]], planes.place[1][start[1]]);
    x[axis] = end.at;
    const std::span<const int> images =
        face.detail >= 0 ? std::span<const int>(slab.details[face.detail].images) : std::span<const int>(&face.image, 1);
    for (const int image : images) {
        const auto offer_at = [&](double place, auto&& there) { // there(): a point of the border and its normal
            if (std::abs(end.at - place) < end.least) {
                const auto [moves, normal] = there();
                end = {end.at, std::abs(end.at - place), &solids[image], x, moves, normal};
            }
        };
        const auto offer = [&](double place, auto&& normal_there) {
            offer_at(place, [&] { return std::pair<Vec<2>, Vec<2>>(x, normal_there()); });
        };
        // A line by which a corner divides the rectangle ends there, too.
        for (const SharpCorner& corner : solids[image].corners)
            if (const double rise = corner.outward[1 - axis]; rise != 0)
                offer(corner.at[axis] + (x[1 - axis] - corner.at[1 - axis]) / rise * corner.outward[axis],
                      [&] { return Vec<2>(corner.outward[1], -corner.outward[0]); });
        std::visit(
            [&](const auto& kind) {
                if constexpr (std::is_same_v<std::decay_t<decltype(kind)>, FacetKind<2>>) {
                    const FaceChains chains = slab.facets[image]->face(2, index.index(face.id));
                    for (int k = 0; k < chains.size(); ++k) {
                        const FacetChain chain = chains[k];
                        if (chain.first_edge == edge)
                            offer(low + chain.points.front()[axis], [&] { return facet_normal(kind, chain.facets.front()); });
                        if (chain.last_edge == edge)
                            offer(low + chain.points.back()[axis], [&] { return facet_normal(kind, chain.facets.back()); });
                    }
                } else {
                    const Stretch line = kind.line(axis, x);
                    for (const bool last : {false, true})
                        offer_at(last ? line.to : line.from, [&] { return end_of_rates(kind, axis, x, last); });
                }
            },
            solids[image].kind);
    }
}

/// Of an open stretch of an edge: from the solids that bound it.
void add_stretch(const GridPlanes<2>& planes, const DenseIndex<2>& index, const std::vector<PlacedSolid<2>>& solids,
                 const std::vector<Slab<2>>& slabs, const PieceSource& source, std::vector<PieceRate<2>>& rates)
{
    const std::size_t begin = rates.size();
    const int axis = edge_axis<2>(0, source.edge);
    const int cell = index.index(slabs[source.slab].faces[source.face].id)[axis];
    const double low = planes.place[axis][cell], high = planes.place[axis][cell + 1];
    for (const auto& [at, sign] : {std::pair{source.from, -1.0}, {source.to, 1.0}}) {
        if (at <= low || at >= high)
            continue;
        StretchEnd end{at, std::numeric_limits<double>::infinity(), nullptr, Vec<2>::Zero(), Vec<2>::Zero(), Vec<2>::Zero()};
        find_end(planes, index, solids, slabs[source.slab], source.face, source.edge, end);
        if (source.other_slab >= 0)
            find_end(planes, index, solids, slabs[source.other_slab], source.other_face, source.other_edge, end);
        if (end.solid)
            add_end(axis, sign, end.place, 0.5 * (low + high), end.solid->reference - (end.moves - end.place), end.normal,
                    rate_of(rates, begin, *end.solid));
    }
}

} // namespace

void add_segment(const FacePlane& face, const Vec<3>& reference, const ArcSegment& segment, const Slope& slope,
                 PieceRate<3>& rate)
{
    const int d = face.d, u = u_axis<3>(d), v = v_axis<3>(d);
    const SegmentIntegrals sum = integrate(segment, face.centre, slope);
    // From the reference point: x + arm in the plane, h along d. r x (nu + slope e_d) in (u, v, d):
    // (r_v slope - h nu_v, h nu_u - r_u slope, r_u nu_v - r_v nu_u), the last one ds = r . dx.
    const Vec<2> arm(face.centre[0] - reference[u], face.centre[1] - reference[v]);
    const double h = face.at - reference[d];
    rate.area[u] -= sum.normal[0];
    rate.area[v] -= sum.normal[1];
    rate.area[d] -= sum.slope;
    rate.area[3 + u] -= sum.first_slope[1] + arm[1] * sum.slope - h * sum.normal[1];
    rate.area[3 + v] -= h * sum.normal[0] - sum.first_slope[0] - arm[0] * sum.slope;
    rate.area[3 + d] -= sum.half_square + arm[0] * sum.normal[1] - arm[1] * sum.normal[0];
    for (const auto& [j, row] : {std::pair{0, u}, {1, v}}) {
        rate.moment(row, u) -= sum.first_normal(j, 0);
        rate.moment(row, v) -= sum.first_normal(j, 1);
        rate.moment(row, d) -= sum.first_slope[j];
        rate.moment(row, 3 + u) -= sum.second_slope(j, 1) + arm[1] * sum.first_slope[j] - h * sum.first_normal(j, 1);
        rate.moment(row, 3 + v) -= h * sum.first_normal(j, 0) - sum.second_slope(j, 0) - arm[0] * sum.first_slope[j];
        rate.moment(row, 3 + d) -= sum.turning[j] + arm[0] * sum.first_normal(j, 1) - arm[1] * sum.first_normal(j, 0);
    }
}

void add_end(int axis, double sign, const Vec<2>& x, double centre, const Vec<2>& reference, const Vec<2>& normal,
             PieceRate<2>& rate)
{
    if (normal[axis] == 0)
        return;
    const Twist<2> speed = sign * lever<2>(normal / normal[axis], x - reference);
    rate.area += speed;
    rate.moment.row(axis) += (x[axis] - centre) * speed.transpose();
}

template <int D>
void face_derivatives(const GridPlanes<D>& planes, const DenseIndex<D>& index, const std::vector<PlacedSolid<D>>& solids,
                      const CutFaces<D>& cut, std::span<const PieceSource> sources, FaceDerivatives<D>& result)
{
    result.first.reserve(sources.size() + 1);
    if constexpr (D == 3) {
        std::vector<SlabRates> slabs(cut.slabs.size());
        for_each_job(static_cast<int>(slabs.size()),
                     [&](int s) { slabs[s] = slab_rates(cut, planes, index, solids, cut.slabs[s]); });
        for (const PieceSource& source : sources) {
            if (source.slab >= 0) {
                const SlabRates& slab = slabs[source.slab];
                result.rates.insert(result.rates.end(), slab.rates.begin() + slab.begin[source.piece],
                                    slab.rates.begin() + slab.end[source.piece]);
            }
            result.first.push_back(static_cast<std::int32_t>(result.rates.size()));
        }
    } else
        for (const PieceSource& source : sources) {
            if (source.slab >= 0)
                add_stretch(planes, index, solids, cut.slabs, source, result.rates);
            result.first.push_back(static_cast<std::int32_t>(result.rates.size()));
        }
}

template void face_derivatives(const GridPlanes<2>&, const DenseIndex<2>&, const std::vector<PlacedSolid<2>>&,
                               const CutFaces<2>&, std::span<const PieceSource>, FaceDerivatives<2>&);
template void face_derivatives(const GridPlanes<3>&, const DenseIndex<3>&, const std::vector<PlacedSolid<3>>&,
                               const CutFaces<3>&, std::span<const PieceSource>, FaceDerivatives<3>&);

} // namespace gapflow
