// What the singular flow around a convex corner adds to the conductance of the faces beside it (theory of the complex, "Corners").
//
// A face that begins at a corner carries the flux Delta psi, and its cells differ by Delta phi of the singular field r^nu: their ratio is 1 + delta, whatever the
// face's direction. The flux relative to the solid is multiplied by it, so that uniform motion stays exact:
//
//     E_f = -1/2 h/Delta (p_high - p_low - Delta U)^2,
//
// U the velocity, along the face's axis, of the solid's motion continued around the corner. Of a corner anywhere, h is delta times the square of a weight that is
// one where the corner lies on a vertex of the grid: that of a bilinear interpolation between planes and rows.
#pragma once

#include "gapflow/complex/edge_mouth.hpp"
#include "gapflow/complex/lever.hpp"
#include "gapflow/complex/open_areas.hpp"
#include "gapflow/complex/placed.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gapflow {

/// What of conductance a face that begins at a corner has more than its area, of a solid's angle there.
double corner_gain(double angle);

/// What of an open piece of a face lies on the ray from the corner.
template <int D>
struct CornerPiece {
    std::int32_t piece; ///< -1: a whole face
    PartOrCell low, high;
    double open = 1;
    double by_area = 0, by_centroid = 0; ///< of `open` by the piece's area, and by its centroid across
    Twist<D> by_pose = Twist<D>::Zero(); ///< of `open` by the solid's place and angle, with the piece as it is
};

/// A face beside a corner. Lengths in cells.
template <int D>
struct CornerFace {
    std::int8_t axis, across;    ///< across: that along which the face begins at the corner
    std::int32_t face;           ///< number in Complex::index
    double distance;             ///< of the centres of its cells
    double added;                ///< h; a piece has `open` over the sum of all of it
    Twist<D> motion;             ///< U by the solid's twist
    double area = 0;             ///< of all pieces
    double centroid = 0;         ///< of all pieces, across
    double by_area, by_centroid; ///< of h by the two
    Twist<D> by_pose;            ///< of h by the solid's place and angle, with the pieces as they are
    double all_open = 0;         ///< of all pieces
    InlineVector<CornerPiece<D>, 4> pieces;
};

/// The corners of placed solids near the block of a complex; 3D: places of their edges and rims, some half a cell apart. `mouths`: 3D, of the gaps
/// that end at edges; null: none.
template <int D>
std::vector<typename Complex<D>::Corner> corners_near(const GridPlanes<D>& planes, const std::vector<PlacedSolid<D>>& placed,
                                                      const EdgeMouths* mouths);

template <int D>
class CornerFaces {
public:
    using Corner = typename Complex<D>::Corner;

    CornerFaces(const Grid<D>& grid, const Complex<D>& complex, const OpenAreas<D>& areas)
        : planes_(grid), grid_(grid), complex_(complex), areas_(areas)
    {
    }

    /// Calls f(CornerFace) for all faces of the block beside a corner.
    template <class F>
    void for_each(const Corner& corner, F&& f) const
    {
        if constexpr (D == 2)
            in_section(corner, 2, 0, {1, 0}, Spin<D>::Zero(), f);
        else
            for (int a = 0; a < 3; ++a) {
                const double share = corner.along[a] * corner.along[a];
                if (share < round_off)
                    continue;
                const Spin<D> turn = 2 / corner.along[a] * corner.along.cross(unit<3>(a));
                const int cell = planes_.cell_of(a, corner.at[a]);
                for (int k = cell - 1; k <= cell + 1; ++k)
                    if (const Weight row = between_centres(a, k, corner.at[a]); row.value > 0)
                        in_section(corner, a, k, {share * row.value, share * row.slope}, turn, f);
            }
    }

private:
    static constexpr double round_off = 1e-24; ///< of a square of a unit vector's component
    /// With its derivative.
    struct Weight {
        double value, slope;
    };
    /// What a ray from the corner has of a row of cells: between two places, with their derivatives by the corner's.
    struct Stretch {
        double from, to, from_slope, to_slope;
    };
    /// A ray from the corner along an axis of the grid: a share of it, which falls where it comes near a wall, and its relative change as the solid turns.
    struct Ray {
        double share;
        Spin<D> turn;
    };

    static Weight smooth(double x) { return x >= 1 ? Weight{1, 0} : Weight{x * x * (3 - 2 * x), 6 * x * (1 - x)}; }

    /// One at a place, falling to 0 at those beside it.
    static Weight between(double below, double at, double above, double x)
    {
        const double length = x < at ? at - below : above - at;
        return {1 - std::abs(x - at) / length, (x < at ? 1 : -1) / length};
    }
    Weight of_plane(int axis, int plane, double x) const
    {
        return between(planes_.place_of(axis, plane - 1), planes_.place_of(axis, plane), planes_.place_of(axis, plane + 1), x);
    }
    Weight between_centres(int axis, int row, double x) const
    {
        return between(planes_.centre_of(axis, row - 1), planes_.centre_of(axis, row), planes_.centre_of(axis, row + 1), x);
    }
    /// The ray is as long as the corner's cell: it has the rest of this one, and as much of the next one as the corner is past the cell's near side.
    Stretch stretch(int axis, int sign, bool next, double x) const
    {
        const int cell = planes_.cell_of(axis, x);
        const double low = planes_.place_of(axis, cell), high = planes_.place_of(axis, cell + 1), length = high - low;
        if (!next)
            return sign > 0 ? Stretch{x, high, 1, 0} : Stretch{low, x, 0, 1};
        if (sign > 0) {
            const double ratio = (planes_.place_of(axis, cell + 2) - high) / length;
            return {high, high + ratio * (x - low), 0, ratio};
        }
        const double ratio = (low - planes_.place_of(axis, cell - 1)) / length;
        return {low - ratio * (high - x), low, ratio, 0};
    }
    Ray ray(const Corner& corner, int axis, int sign) const
    {
        const Vec<D> way = sign * unit<D>(axis);
        Vec<D> normal = way;
        Spin<D> turn;
        double angle;
        if constexpr (D == 2) {
            angle = std::atan2(corner.outward[0] * way[1] - corner.outward[1] * way[0], corner.outward.dot(way));
            turn[0] = 1;
        } else {
            normal -= corner.along.dot(way) * corner.along;
            const double length = normal.norm();
            if (length * length < round_off)
                return {0, Spin<D>::Zero()};
            normal /= length;
            angle = std::atan2(corner.along.dot(corner.outward.cross(normal)), corner.outward.dot(normal));
            turn = way.cross(corner.along.cross(normal)) / length;
        }
        const double from_wall = corner.half - std::abs(angle);
        if (!(from_wall > 0))
            return {0, Spin<D>::Zero()};
        const Weight share = smooth(2 * from_wall / std::numbers::pi);
        return {share.value, (angle < 0 ? -1 : 1) * 2 / std::numbers::pi * share.slope / share.value * turn};
    }

    /// In the section normal to an axis a, of the row `row` along it. `along`: the weight of this row; `turn`: its relative change as the solid turns.
    template <class F>
    void in_section(const Corner& corner, int a, int row, const Weight& along, const Spin<D>& turn, F&& f) const
    {
        for (int d = 0; d < D; ++d) {
            if (d == a)
                continue;
            const int t = (D == 2 ? 1 : 3 - a) - d, plane = planes_.cell_of(d, corner.at[d]),
                      cell = planes_.cell_of(t, corner.at[t]);
            for (const int sign : {-1, 1}) {
                Ray r = ray(corner, t, sign);
                if constexpr (D == 3) {
                    const double across = 1 - corner.along[d] * corner.along[d];
                    if (!(across > round_off))
                        continue;
                    r.share *= across * across;
                    r.turn -= 4 * corner.along[d] / across * corner.along.cross(unit<3>(d));
                }
                if (!(r.share > 0))
                    continue;
                r.turn += turn;
                for (int X = plane; X <= plane + 1; ++X)
                    for (const bool next : {false, true}) {
                        Index<D> at;
                        at[d] = X;
                        at[t] = cell + (next ? sign : 0);
                        if constexpr (D == 3)
                            at[a] = row;
                        on_face(corner, at, d, t, a, along, r, of_plane(d, X, corner.at[d]),
                                stretch(t, sign, next, corner.at[t]), f);
                    }
            }
        }
    }

    template <class F>
    void on_face(const Corner& corner, const Index<D>& at, int d, int t, int a, const Weight& along, const Ray& r,
                 const Weight& w, const Stretch& on, F&& f) const
    {
        const DenseIndex<D>& index = complex_.index;
        for (int axis = 0; axis < D; ++axis)
            if (at[axis] < index.low[axis] || at[axis] >= (axis == d ? index.faces_end(d) : index.high())[axis])
                return;
        const double length = on.to - on.from, width = planes_.place_of(t, at[t] + 1) - planes_.place_of(t, at[t]);
        if (!(w.value > 0) || !(length > 0))
            return;
        CornerFace<D> face;
        face.axis = static_cast<std::int8_t>(d);
        face.across = static_cast<std::int8_t>(t);
        face.face = index(at);
        find_pieces(at, face);
        if (face.pieces.empty())
            return;
        double full = 1; // along the edge
        if constexpr (D == 3)
            full = planes_.place_of(a, at[a] + 1) - planes_.place_of(a, at[a]);
        // What is open of the ray, as if all that is open were one stretch.
        const double low = face.centroid - 0.5 * face.area / full, high = face.centroid + 0.5 * face.area / full,
                     open = std::min(high, on.to) - std::max(low, on.from);
        if (!(open > 0))
            return;
        const bool own_low = on.from<low, own_high = on.to> high;
        for (CornerPiece<D>& of : face.pieces) {
            if (of.piece >= 0)
                find_open(corner, on, full, t, of);
            face.all_open += of.open;
        }
        if (!(face.all_open > 0))
            return;
        face.distance = grid_.spread(d, at[d]);
        Vec<D> arm = corner.at - corner.reference;
        arm[t] += corner.at[t] - planes_.centre_of(t, at[t]); // the wall's motion goes on as that at the mirror image
        face.motion = lever<D>(unit<D>(d), arm);
        const Weight s = smooth(open / length);
        const double part = length / width * s.value, factor = corner.strength * width * r.share,
                     by_part = 2 * factor * along.value * w.value * w.value * part, by_open = by_part * s.slope / width;
        face.added = 0.5 * by_part * part;
        face.by_area = 0.5 * by_open * (own_low + own_high) / full;
        face.by_centroid = by_open * (static_cast<double>(own_high) - own_low);
        Vec<D> by_place = Vec<D>::Zero();
        by_place[d] = 2 * factor * along.value * w.value * w.slope * part * part;
        by_place[t] = by_part * (s.value - open / length * s.slope) / width * (on.to_slope - on.from_slope) +
                      by_open * ((own_high ? 0.0 : on.to_slope) - (own_low ? 0.0 : on.from_slope));
        if constexpr (D == 3)
            by_place[a] = factor * along.slope * w.value * w.value * part * part;
        face.by_pose = lever<D>(by_place, corner.at - corner.reference);
        face.by_pose.template tail<spin_size<D>>() += face.added * r.turn;
        f(static_cast<const CornerFace<D>&>(face));
    }

    void find_open(const Corner& corner, const Stretch& on, double full, int t, CornerPiece<D>& of) const
    {
        const FacePiece<D>& piece = complex_.pieces[of.piece];
        const double low = piece.centroid[t] - 0.5 * piece.area / full, high = piece.centroid[t] + 0.5 * piece.area / full;
        of.open = std::max(0.0, std::min(high, on.to) - std::max(low, on.from));
        if (of.open == 0)
            return;
        const bool own_low = on.from<low, own_high = on.to> high;
        of.by_area = 0.5 * (own_low + own_high) / full;
        of.by_centroid = static_cast<double>(own_high) - own_low;
        of.by_pose = lever<D>(((own_high ? 0.0 : on.to_slope) - (own_low ? 0.0 : on.from_slope)) * unit<D>(t),
                              corner.at - corner.reference);
    }

    void find_pieces(const Index<D>& at, CornerFace<D>& face) const
    {
        const int d = face.axis;
        if (const std::int32_t first = areas_.first(d, face.face); first >= 0) {
            double moment = 0;
            for (std::int32_t k = first; k >= 0; k = areas_.next(k)) {
                const FacePiece<D>& piece = complex_.pieces[k];
                if (!piece.low.exists() || !piece.high.exists() || !(piece.area > 0))
                    continue;
                face.pieces.push_back({k, piece.low, piece.high});
                face.area += piece.area;
                moment += piece.area * piece.centroid[face.across];
            }
            face.centroid = moment / face.area;
            return;
        }
        const Index<D> below = complex_.index.wrapped(at - step<D>(d)), above = complex_.index.wrapped(at);
        face.area = complex_.main_area[d][face.face];
        face.centroid = planes_.centre_of(face.across, at[face.across]);
        if (!(face.area > 0) || !complex_.index.holds(below) || !complex_.index.holds(above))
            return;
        const PartOrCell low = complex_.main_of(complex_.index(below)), high = complex_.main_of(complex_.index(above));
        if (low.exists() && high.exists())
            face.pieces.push_back({-1, low, high});
    }

    const GridPlanes<D> planes_;
    const Grid<D>& grid_;
    const Complex<D>& complex_;
    const OpenAreas<D>& areas_;
};

/// -h Delta U U^T of each solid, of this rank's faces: what D has of it.
template <int D>
std::vector<TwistMatrix<D>> corner_masses(const Grid<D>& grid, const Complex<D>& complex);

} // namespace gapflow
