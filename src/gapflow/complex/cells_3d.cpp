#include "gapflow/complex/cells.hpp"
#include "gapflow/complex/lever.hpp"
#include "gapflow/complex/parameters.hpp"
#include "gapflow/complex/surface_rate.hpp"
#include "gapflow/grid/field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace gapflow {
namespace {

/// Straight piece of a border from P to Q in the terms of BorderArc, about a reference point.
std::pair<Vec<3>, Vec<3>> chord(const Vec<3>& P, const Vec<3>& Q, const Vec<3>& reference)
{
    const Vec<3> p = P - reference, q = Q - reference;
    return {0.5 * p.cross(q), -0.5 * (p.squaredNorm() + p.dot(q) + q.squaredNorm()) / 3 * (Q - P)};
}

/// How what a straight way from P to Q contributes to area vector and moment changes as its ends move with the given velocities. The sum over ways that close a solid's curve
/// with its arcs, whose ends at P move as well.
std::pair<Vec<3>, Vec<3>> swept(const Vec<3>& P, const Vec<3>& Q, const Vec<3>& speed_P, const Vec<3>& speed_Q,
                                const Vec<3>& reference)
{
    const Vec<3> x = P - reference, way = Q - P, y = speed_P.cross(way), more = (speed_Q - speed_P).cross(way);
    return {y + 0.5 * more, x.cross(y) + 0.5 * (x.cross(more) + way.cross(y)) + way.cross(more) / 3};
}

/// One cell's side: its face, or what is known without one.
struct HullFace {
    int state = Complex<3>::open; ///< open or solid; 0: cut
    const Slab<3>* slab = nullptr;
    const CutFace<3>* face = nullptr;
    int slab_number = 0;
    double shift = 0; ///< from where the face is known to where the cell has it, along its axis: a period or nothing

    int pieces() const { return state == Complex<3>::solid ? 0 : face ? face->pieces : 1; }
    int stretches(int e) const
    {
        if (!face)
            return state == Complex<3>::solid ? 0 : 1;
        if (face->detail >= 0) {
            const FaceDetail& detail = slab->details[face->detail];
            return detail.stretch[e + 1] - detail.stretch[e];
        }
        return (face->open >> e & 1) || (face->open >> ((e + 1) & 3) & 1) ? 1 : 0;
    }
    /// One of them; all that is open of the edge, where one solid cuts the face in the common way or none does.
    OpenStretch stretch(int e, int k) const
    {
        if (face && face->detail >= 0)
            return slab->stretches[slab->details[face->detail].stretch[e] + k];
        return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), 0};
    }
    std::span<const CornerDivision<3>> divisions() const
    {
        if (!face || face->detail < 0)
            return {};
        const FaceDetail& detail = slab->details[face->detail];
        return {slab->divisions.data() + detail.division, static_cast<std::size_t>(detail.divisions)};
    }
    std::span<const DivisionRate<3>> rates_of_division(std::size_t k) const
    {
        return slab->rates_of_division(slab->details[face->detail].division + static_cast<int>(k));
    }
    double area(int piece, double whole) const { return face ? slab->pieces[face->piece + piece].area : whole; }
};

/// Whether edges of a cube join all corners of a set. Corners 0 to 3 and 4 to 7: around the lower and the upper face.
constexpr bool are_connected(unsigned corners)
{
    unsigned reached = corners & ~(corners - 1);
    for (int k = 0; k < 8; ++k)
        for (int i = 0; i < 8; ++i)
            if (reached >> i & 1)
                reached |= corners & (1U << (i ^ 4) | 1U << ((i & 4) + ((i + 1) & 3)) | 1U << ((i & 4) + ((i + 3) & 3)));
    return corners != 0 && reached == corners;
}
constexpr auto connected_corners = [] {
    std::array<bool, 256> connected{};
    for (unsigned corners = 0; corners < 256; ++corners)
        connected[corners] = are_connected(corners);
    return connected;
}();

/// Two pieces of a hull that a hole inside the cell joins.
struct HoleJoin {
    int a, b;
    HoleInCell hole;
};

class CellBuilder3 {
public:
    CellBuilder3(const Grid<3>& grid, const GridPlanes<3>& planes, const DenseIndex<3>& index,
                 const std::vector<PlacedSolid<3>>& solids, const CutFaces<3>& cut, const FacetsInCells& facets,
                 std::vector<PartsBeside>& beside, std::vector<std::int32_t>& cell)
        : grid_(grid), planes_(planes), index_(index), solids_(solids), cut_(cut), facets_(facets), beside_(beside), cell_(cell)
    {
    }

    CellSlab<3> build(int begin, int end) const
    {
        CellSlab<3> result;
        Index<3> low = index_.low, high = index_.low + index_.size - Index<3>::Ones();
        low[2] = begin;
        high[2] = end;
        for_each_row<3>(low, high, [&](const Index<3>& row) {
            const int n = high[0] - low[0], first = index_(row);
            // The six faces of each cell of the row: the last cell of a periodic axis looks at the first face.
            std::array<const std::int32_t*, 6> faces;
            for (int q = 0; q < 6; ++q) {
                Index<3> f = row;
                if (q % 2 && q / 2 > 0)
                    f[q / 2] = next(q / 2, row[q / 2]);
                faces[q] = &cut_.face[q / 2][index_(f)];
            }
            for (int i = 0; i < n; ++i) {
                const int beyond = next(0, row[0] + i) - row[0];
                const std::array<std::int32_t, 6> f{faces[0][i], faces[0][beyond], faces[2][i],
                                                    faces[3][i], faces[4][i],      faces[5][i]};
                std::int32_t& cell = cell_[first + i];
                if ((f[0] & f[1] & f[2] & f[3] & f[4] & f[5]) == Complex<3>::open) {
                    cell = Complex<3>::open;
                    continue;
                }
                cell = Complex<3>::solid;
                bool cut = false, open = false, closed = false;
                for (int q = 0; q < 6; ++q) {
                    cut = cut || f[q] >= 0;
                    open = open || f[q] == Complex<3>::open;
                    closed = closed || f[q] == Complex<3>::solid;
                }
                if (!cut && !open)
                    continue;
                Index<3> c = row;
                c[0] += i;
                add_cell(c, first + i, f, result);
            }
        });
        return result;
    }

private:
    int next(int axis, int i) const { return index_.wraps[axis] && i + 1 == index_.high()[axis] ? index_.low[axis] : i + 1; }

    void add_cell(const Index<3>& c, int number, const std::array<std::int32_t, 6>& numbers, CellSlab<3>& result) const
    {
        std::array<HullFace, 6> hull;
        std::array<int, 7> first{};
        for (int q = 0; q < 6; ++q) {
            HullFace& h = hull[q];
            h.state = std::min(numbers[q], 0);
            if (q % 2)
                h.shift = planes_.place[q / 2][c[q / 2] + 1] - planes_.place[q / 2][next(q / 2, c[q / 2])];
            if (numbers[q] >= 0) {
                const int plane = q == 5 ? next(2, c[2]) : c[2];
                h.slab_number = cut_.slab_of[plane - index_.low[2]];
                h.slab = &cut_.slabs[h.slab_number];
                h.face = &h.slab->faces[numbers[q]];
                if (h.face->pieces == 0)
                    h.state = Complex<3>::solid;
            }
            first[q + 1] = first[q] + h.pieces();
        }
        const int n = first[6];
        if (n == 0 || add_whole_cell(c, number, hull, result))
            return;
        // Pieces that meet along an edge of the cell are joined.
        InlineVector<int, 32> up;
        for (int x = 0; x < n; ++x)
            up.push_back(x);
        const auto find = [&](int x) {
            while (up[x] != x)
                x = up[x] = up[up[x]];
            return x;
        };
        for (int a = 0; a < 3; ++a) {
            const int b = (a + 1) % 3, g = (a + 2) % 3;
            for (int sb = 0; sb < 2; ++sb)
                for (int sg = 0; sg < 2; ++sg) {
                    // Of a face normal to b the edge along a is that at u = g; of one normal to g that at v = b.
                    const int qb = 2 * b + sb, qg = 2 * g + sg, eb = sg ? 1 : 3, eg = sb ? 2 : 0;
                    for (int i = 0, j = 0; i < hull[qb].stretches(eb) && j < hull[qg].stretches(eg);) {
                        const OpenStretch s = hull[qb].stretch(eb, i), t = hull[qg].stretch(eg, j);
                        if (std::min(s.to, t.to) - std::max(s.from, t.from) > parameters.least_stretch)
                            up[find(first[qb] + s.piece)] = find(first[qg] + t.piece);
                        i += s.to <= t.to;
                        j += t.to <= s.to;
                    }
                }
        }
        // What a line divides in the cell on the face's other side alone is one here.
        for (int q = 0; q < 6; ++q)
            for (const auto& division : hull[q].divisions())
                if (!(division.sides & (q % 2 ? 1 : 2)))
                    up[find(first[q] + division.a)] = find(first[q] + division.b);
        std::vector<HoleJoin> holes;
        join_by_walls(c, number, hull, first, up, holes);
        InlineVector<double, 32> total;
        InlineVector<int, 32> label;
        for (int x = 0; x < n; ++x) {
            total.push_back(0);
            label.push_back(-1);
        }
        std::array<double, 3> whole;
        for (int axis = 0; axis < 3; ++axis)
            whole[axis] = grid_.relative_area(axis, c);
        for (int q = 0; q < 6; ++q)
            for (int p = 0; p < first[q + 1] - first[q]; ++p)
                total[find(first[q] + p)] += hull[q].area(p, whole[q / 2]);
        int largest = -1, count = 0;
        for (int x = 0; x < n; ++x)
            if (find(x) == x && total[x] > parameters.least_area && (largest < 0 || total[x] > total[largest]))
                largest = x;
        if (largest < 0)
            return;
        cell_[number] = static_cast<std::int32_t>(result.cut_cell.size());
        const int part = static_cast<int>(result.part_cell.size());
        label[largest] = count++;
        result.part_area.push_back(total[largest]);
        for (int x = 0; x < n; ++x)
            if (find(x) == x && label[x] < 0 && total[x] > parameters.least_area) {
                label[x] = count++;
                result.part_area.push_back(total[x]);
            }
        const Meetings meetings = meetings_of(hull, first, find, label);
        for (int p = 0; p < count; ++p) {
            result.part_cell.push_back(static_cast<std::int32_t>(result.cut_cell.size()));
            add_walls(hull, first, find, label, meetings, p, result);
        }
        for (int q = 0; q < 6; ++q)
            if (hull[q].state == Complex<3>::open && label[find(first[q])] > 0) {
                Index<3> f = c;
                if (q % 2)
                    f[q / 2] = next(q / 2, c[q / 2]);
                result.astray.push_back({static_cast<std::int8_t>(q / 2), static_cast<std::int8_t>(1 - q % 2), index_(f),
                                         part + label[find(first[q])]});
            }
        for (int q = 0; q < 6; ++q)
            if (hull[q].face)
                for (int p = 0; p < hull[q].face->pieces; ++p) {
                    const int l = label[find(first[q] + p)];
                    beside_[hull[q].slab_number][hull[q].face->piece + p][1 - q % 2] = l < 0 ? -1 : part + l;
                }
        add_links(c, hull, first, find, label, part, result);
        for (const HoleJoin& hole : holes)
            add_hole(hole, label[find(hole.a)], label[find(hole.b)], part, result);
        result.cut_cell.push_back(number);
        result.parts_of_cell.push_back(count);
    }

    /// Pieces that one wall inside the cell joins: what leads through a mesh, through a container, or through what several solids leave open. What
    /// the lines of corners part counts as one. Solids that are convex and apart from each other leave no such way: a closed curve on the hull in
    /// one of them bounds a disc of it in the cell.
    void join_by_walls(const Index<3>& c, int number, const std::array<HullFace, 6>& hull, const std::array<int, 7>& first,
                       InlineVector<int, 32>& up, std::vector<HoleJoin>& holes) const
    {
        const auto root = [](InlineVector<int, 32>& list, int x) {
            while (list[x] != x)
                x = list[x] = list[list[x]];
            return x;
        };
        InlineVector<int, 32> joined = up;
        for (int q = 0; q < 6; ++q)
            for (const auto& division : hull[q].divisions())
                joined[root(joined, first[q] + division.a)] = root(joined, first[q] + division.b);
        const auto join = [&](int a, int b) {
            if (root(joined, a) == root(joined, b))
                return;
            joined[root(joined, a)] = root(joined, b);
            up[root(up, a)] = root(up, b);
        };
        const auto one = [&] {
            for (int x = 1; x < first[6]; ++x)
                if (root(joined, x) != root(joined, 0))
                    return false;
            return true;
        };
        if (one())
            return;
        InlineVector<int, 8> met; // solids that meet another one on the hull
        bool meshes = false, others = false;
        for (int q = 0; q < 6; ++q)
            for (int k = 0; hull[q].face && k < hull[q].face->arcs; ++k) {
                const PlacedSolid<3>& solid = solids_[hull[q].slab->arcs[hull[q].face->arc + k].image];
                meshes = meshes || std::holds_alternative<FacetKind<3>>(solid.kind);
                others = others || solid.inverse;
            }
        for_each_junction(hull, [&](int, const Junction<3>& j, const PointRates<3>&) {
            if (j.edge >= 0)
                return;
            met.push_back(solids_[j.from].solid);
            met.push_back(solids_[j.to].solid);
            others = true;
        });
        if (meshes) {
            std::vector<BorderFacet> borders;
            for (int q = 0; q < 6; ++q)
                for (int k = 0; hull[q].face && k < hull[q].face->arcs; ++k) {
                    const std::int32_t arc = hull[q].face->arc + k;
                    const BorderArc<3>& border = hull[q].slab->arcs[arc];
                    if (std::find(met.begin(), met.end(), solids_[border.image].solid) != met.end())
                        continue; // the other one may close the way
                    const auto& facets = hull[q].slab->arc_facets;
                    auto facet = std::lower_bound(facets.begin(), facets.end(), arc,
                                                  [](const ArcFacet& f, std::int32_t a) { return f.arc < a; });
                    for (; facet != facets.end() && facet->arc == arc; ++facet)
                        borders.push_back({border.image, facet->facet, first[q] + border.piece});
                }
            FacetJoins joins;
            std::optional<HoleInCell> hole;
            bool looked = false;
            for (const PiecePair& pair : joins.find(solids_, borders, facets_.of(number))) {
                if (root(joined, pair.a) == root(joined, pair.b))
                    continue;
                if (!std::exchange(looked, true))
                    hole = hole_in(c);
                if (hole) {
                    joined[root(joined, pair.a)] = root(joined, pair.b);
                    holes.push_back({pair.a, pair.b, *hole});
                } else
                    join(pair.a, pair.b);
            }
        }
        if (others && !one())
            join_in_sight(c, hull, first, join, [&](int q) {
                for (int x = first[q]; x < first[q + 1]; ++x)
                    if (root(joined, x) != root(joined, first[q]))
                        return false;
                return true;
            });
    }

    /// The narrowest hole of a mesh with a sharp rim in a cell.
    std::optional<HoleInCell> hole_in(const Index<3>& c) const
    {
        const auto [low, high] = box_of(c);
        std::optional<HoleInCell> narrowest;
        for (int image = 0; image < static_cast<int>(solids_.size()); ++image)
            if (std::holds_alternative<FacetKind<3>>(solids_[image].kind))
                if (const auto hole = sharp_hole(solids_[image].sharp, c, low, high);
                    hole && (!narrowest || hole->area < narrowest->area)) {
                    narrowest = hole;
                    narrowest->image = image;
                }
        return narrowest;
    }

    void add_hole(const HoleJoin& join, int a, int b, int part, CellSlab<3>& result) const
    {
        if (a < 0 || b < 0 || a == b)
            return;
        const HoleInCell& hole = join.hole;
        const PlacedSolid<3>& solid = solids_[hole.image];
        const double conductance = hole.conductance();
        if (cut_.for_derivatives && hole.margin < hole.radius())
            result.link_rates.push_back({static_cast<std::int32_t>(result.links.size()), solid.solid,
                                         -conductance / hole.margin * lever<3>(hole.inward, hole.nearest - solid.reference)});
        result.links.push_back(
            {part + std::min(a, b), part + std::max(a, b), solid.solid, conductance, hole.area, hole.margin, hole.nearest});
    }

    /// The box low .. high of a cell.
    std::pair<Vec<3>, Vec<3>> box_of(const Index<3>& c) const
    {
        Vec<3> low, high;
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = planes_.place[axis][c[axis]];
            high[axis] = planes_.place[axis][c[axis] + 1];
        }
        return {low, high};
    }

    /// Mean direction, into the cell, of the curves in which solids meet that bound a face's pieces; 0: there is none.
    Vec<3> crease(const std::array<HullFace, 6>& hull, int face) const
    {
        const int d = face / 2, inward = face % 2 ? -1 : 1;
        Vec<3> sum = Vec<3>::Zero();
        for_each_junction(hull, [&](int q, const Junction<3>& j, const PointRates<3>&) {
            if (q != face || j.edge >= 0)
                return;
            Vec<3> x = j.at;
            x[d] -= hull[q].shift;
            const auto normal = [&](int image) { return solids_[image].shape.closest(planes_.in_world(x)).normal; };
            const Vec<3> way = normal(j.from).cross(normal(j.to));
            sum += (way[d] * inward > 0 ? 1 : -1) * way;
        });
        return sum;
    }

    /// Pieces that see each other: from the centroid of a face's only piece, which lies in it if no solid covers it, to another such, and along the
    /// curves in which the solids around it meet. `one(q)`: whether the pieces of a face are joined.
    template <class Join, class One>
    void join_in_sight(const Index<3>& c, const std::array<HullFace, 6>& hull, const std::array<int, 7>& first, Join&& join,
                       One&& one) const
    {
        const auto [low, high] = box_of(c);
        std::vector<int> images;
        for (int k = 0; k < static_cast<int>(solids_.size()); ++k)
            if (solids_[k].inverse ||
                ((solids_[k].low.array() <= high.array()).all() && (solids_[k].high.array() >= low.array()).all()))
                images.push_back(k);
        struct Place {
            int q;
            Vec<3> x;
        };
        InlineVector<Place, 6> places;
        for (int q = 0; q < 6; ++q) {
            if (hull[q].pieces() != 1)
                continue;
            const int d = q / 2;
            Vec<3> x = 0.5 * (low + high);
            if (hull[q].face) {
                const Vec<2>& centroid = hull[q].slab->pieces[hull[q].face->piece].centroid;
                x[u_axis<3>(d)] = centroid[0];
                x[v_axis<3>(d)] = centroid[1];
            }
            x[d] = (q % 2 ? high : low)[d];
            places.push_back({q, x});
        }
        for (const Place& from : places) {
            for (const Place& to : places)
                if (to.q < from.q && in_sight(planes_, solids_, images, from.x, to.x))
                    join(first[from.q], first[to.q]);
            const Vec<3> way = crease(hull, from.q);
            double length = std::numeric_limits<double>::infinity();
            int exit = from.q;
            for (int d = 0; d < 3; ++d)
                if (const double t = ((way[d] > 0 ? high : low)[d] - from.x[d]) / way[d];
                    d != from.q / 2 ? way[d] != 0 && t < length : way[d] != 0 && t > 0 && t < length) {
                    length = t;
                    exit = 2 * d + (way[d] > 0);
                }
            if (exit != from.q && hull[exit].pieces() > 0 && one(exit) &&
                in_sight(planes_, solids_, images, from.x, from.x + length * way))
                join(first[from.q], first[exit]);
        }
    }

    /// A cell of one part: one solid cuts its faces in the common way, and a way along open edges leads from any open corner to any other. Else
    /// false.
    bool add_whole_cell(const Index<3>& c, int number, const std::array<HullFace, 6>& hull, CellSlab<3>& result) const
    {
        unsigned corners = 0; // of the face below along the last axis, counterclockwise, then of that above
        double total = 0;
        for (int q = 0; q < 6; ++q) {
            const HullFace& h = hull[q];
            if (h.face && h.face->detail >= 0)
                return false;
            if (q >= 4)
                corners |= (h.face ? h.face->open : h.state == Complex<3>::open ? 15U : 0U) << 4 * (q - 4);
            for (int p = 0; p < h.pieces(); ++p)
                total += h.area(p, grid_.relative_area(q / 2, c));
        }
        if (!connected_corners[corners] || !(total > parameters.least_area))
            return false;
        cell_[number] = static_cast<std::int32_t>(result.cut_cell.size());
        const auto part = static_cast<std::int32_t>(result.part_cell.size());
        const std::size_t begin = result.patches.size();
        for (int q = 0; q < 6; ++q)
            if (const CutFace<3>* face = hull[q].face) {
                const BorderArc<3>& arc = hull[q].slab->arcs[face->arc];
                const double sign = q % 2 ? -1 : 1;
                add_patch<3>(result.patches, begin, solids_[arc.image].solid, sign * arc.area, sign * arc.moment);
                beside_[hull[q].slab_number][face->piece][1 - q % 2] = part;
            }
        result.part_cell.push_back(cell_[number]);
        result.part_area.push_back(total);
        result.patches_of_part.push_back(static_cast<std::int32_t>(result.patches.size() - begin));
        result.cut_cell.push_back(number);
        result.parts_of_cell.push_back(1);
        return true;
    }

    /// Of the edges that divide the cell, as far as they part two parts.
    template <class Find, class Label>
    void add_links(const Index<3>& c, const std::array<HullFace, 6>& hull, const std::array<int, 7>& first, Find&& find,
                   const Label& label, int part, CellSlab<3>& result) const
    {
        struct Pair {
            int image, edge, a, b;
            double open;
            std::vector<DivisionRate<3>> rates; ///< of the open length
        };
        InlineVector<Pair, 4> pairs;
        for (int q = 0; q < 6; ++q)
            for (std::size_t k = 0; k < hull[q].divisions().size(); ++k) {
                const CornerDivision<3>& division = hull[q].divisions()[k];
                if (!(division.sides & (q % 2 ? 1 : 2)))
                    continue;
                int a = label[find(first[q] + division.a)], b = label[find(first[q] + division.b)];
                if (a == b || a < 0 || b < 0)
                    continue;
                if (a > b && !leads(solids_[division.image].sharp, division.edge))
                    std::swap(a, b);
                // Of a periodic domain's last cell the faces on its far side see another image.
                auto known = std::find_if(pairs.begin(), pairs.end(), [&](const Pair& p) {
                    return solids_[p.image].solid == solids_[division.image].solid && p.edge == division.edge && p.a == a &&
                           p.b == b;
                });
                if (known == pairs.end()) {
                    pairs.push_back({division.image, division.edge, a, b, 0, {}});
                    known = pairs.end() - 1;
                }
                known->open += division.open;
                if (cut_.for_derivatives)
                    for (const DivisionRate<3>& rate : hull[q].rates_of_division(k))
                        known->rates.push_back(rate);
            }
        Vec<3> low, high;
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = planes_.place[axis][c[axis]];
            high[axis] = planes_.place[axis][c[axis] + 1];
        }
        for (const Pair& pair : pairs) {
            // The image whose edge passes through the cell itself.
            int image = -1;
            CellSectors sectors;
            for (int k = 0; k < static_cast<int>(solids_.size()) && image < 0; ++k)
                if (solids_[k].solid == solids_[pair.image].solid) {
                    sectors = cell_sectors(solids_[k].sharp, c, low, high);
                    if (divided_by(solids_[k].sharp, sectors, pair.edge))
                        image = k;
                }
            if (image < 0)
                continue;
            double all = 0;
            for (const Pair& other : pairs)
                if (other.edge == pair.edge && solids_[other.image].solid == solids_[pair.image].solid)
                    all += other.open;
            if (leads(solids_[image].sharp, pair.edge)) {
                result.links.push_back(way_link(image, sectors, pair.edge, c, low, high, pair.open / all));
                result.links.back().a = part + pair.a;
                result.links.back().b = part + pair.b;
                continue;
            }
            const EdgeInCell edge = edge_in_cell(solids_[image].sharp, sectors, pair.edge, c, low, high);
            const double open = pair.open / all * edge.open;
            if (cut_.for_derivatives && edge.covered / edge.length > parameters.least_covered) {
                const double conductance = corner_conductance(edge.angle, open, edge.covered / edge.length);
                const auto add = [&](int solid, const Twist<3>& rate) {
                    result.link_rates.push_back({static_cast<std::int32_t>(result.links.size()), solid, conductance * rate});
                };
                const EdgeRates rates =
                    edge_rates(solids_[image].sharp, sectors, pair.edge, c, low, high, solids_[image].reference);
                add(solids_[image].solid, rates.open / edge.open - rates.covered / edge.covered + rates.length / edge.length);
                for (const Pair& other : pairs) // the share of the open area
                    if (other.edge == pair.edge && solids_[other.image].solid == solids_[pair.image].solid && pair.open < all)
                        for (const DivisionRate<3>& rate : other.rates)
                            add(solids_[rate.image].solid,
                                (&other == &pair ? 1 / pair.open : 0.0) * rate.rate - rate.rate / all);
            }
            result.links.push_back({part + pair.a, part + pair.b, solids_[image].solid,
                                    corner_conductance(edge.angle, open, edge.covered / edge.length), open, edge.covered,
                                    edge.at, mouth_of(solids_[image].sharp, pair.edge)});
        }
    }
    /// Whether an edge, not a rim, divides up to another wall.
    static bool leads(const SharpSolid& sharp, int edge)
    {
        return edge < static_cast<int>(sharp.edges.size()) && sharp.edges[edge].leads();
    }
    static int mouth_of(const SharpSolid& sharp, int edge)
    {
        const bool has = edge < static_cast<int>(sharp.edges.size()) && sharp.edges[edge].way >= 0;
        return has ? sharp.ways[sharp.edges[edge].way].number : -1;
    }
    /// A share of the way from an edge to another wall, with the law of the corner in the edge's own cell. The parts are unset.
    CornerLink<3> way_link(int image, const CellSectors& sectors, int number, const Index<3>& c, const Vec<3>& low,
                           const Vec<3>& high, double share) const
    {
        const SharpSolid& sharp = solids_[image].sharp;
        const SharpEdge& edge = sharp.edges[number];
        const WayInCell way = way_in_cell(sharp, sharp.ways[edge.way], low, high);
        const double open = share * way.area;
        CornerLink<3> link{
            -1, -1, solids_[image].solid, open, open, 0, edge.from + way.at * edge.along(), mouth_of(sharp, number)};
        if (passes(edge, low, high)) {
            const EdgeInCell own = edge_in_cell(sharp, sectors, number, c, low, high);
            link.covered = own.covered;
            link.conductance = corner_conductance(own.angle, open, own.covered / own.length);
        }
        return link;
    }
    static bool divided_by(const SharpSolid& sharp, const CellSectors& sectors, int edge)
    {
        const int edges = static_cast<int>(sharp.edges.size());
        return edge < edges ? std::find(sectors.edges.begin(), sectors.edges.end(), edge) != sectors.edges.end() ||
                                  std::find(sectors.ways.begin(), sectors.ways.end(), edge) != sectors.ways.end()
                            : std::find(sectors.rims.begin(), sectors.rims.end(), edge - edges) != sectors.rims.end();
    }

    /// Where solids meet in a part the curve leads by straight ways over a middle. Where the plane by which an edge divides the cell meets
    /// another solid it is the same for the parts on both sides: that of the plane's own ends on the hull if in each part they close their
    /// curve, or else, where planes meet each other in the cell or solids do, one for all of the cell.
    struct Meetings {
        struct Plane {
            int solid, edge, count;
            Vec<3> middle;
            PointRates<3> rates;
        };
        InlineVector<Plane, 2> planes;
        int count = 0;
        bool apart = true, crossed = false; ///< crossed: planes of two solids meet
        Vec<3> middle = Vec<3>::Zero();
        PointRates<3> rates; ///< of the middle

        const Plane* find(const Junction<3>& j) const
        {
            return std::find_if(planes.begin(), planes.end(),
                                [&](const Plane& p) { return p.solid == j.solid && p.edge == j.edge; });
        }
    };

    template <class Visit>
    static void for_each_junction(const std::array<HullFace, 6>& hull, Visit&& visit)
    {
        for (int q = 0; q < 6; ++q) {
            const CutFace<3>* face = hull[q].face;
            if (!face || face->detail < 0)
                continue;
            const FaceDetail& detail = hull[q].slab->details[face->detail];
            for (int k = 0; k < detail.junctions; ++k) {
                Junction<3> junction = hull[q].slab->junctions[detail.junction + k];
                junction.at[q / 2] += hull[q].shift;
                if (hull[q].slab->junction_rates.empty())
                    visit(q, junction, PointRates<3>{});
                else
                    visit(q, junction, hull[q].slab->junction_rates[detail.junction + k]);
            }
        }
    }
    static bool divides(const Junction<3>& j, int q) { return j.sides & (q % 2 ? 1 : 2); }

    template <class Find, class Label>
    Meetings meetings_of(const std::array<HullFace, 6>& hull, const std::array<int, 7>& first, Find&& find,
                         const Label& label) const
    {
        struct Balance { // of the ends of a plane at another solid
            int plane, part, other, sum;
        };
        InlineVector<Balance, 4> balances;
        Meetings meetings;
        bool plain = false;
        for_each_junction(hull, [&](int q, const Junction<3>& j, const PointRates<3>& rates) {
            const int part = label[find(first[q] + j.piece)];
            if (part < 0 || !divides(j, q))
                return;
            meetings.middle += j.at;
            add_rates(meetings.rates, rates, 1);
            ++meetings.count;
            if (j.lines != 1) {
                plain = true;
                meetings.crossed = meetings.crossed || j.lines > 1;
                return;
            }
            const auto* known = meetings.find(j);
            const int plane = static_cast<int>(known - meetings.planes.begin());
            if (known == meetings.planes.end())
                meetings.planes.push_back({j.solid, j.edge, 0, Vec<3>::Zero(), {}});
            ++meetings.planes[plane].count;
            meetings.planes[plane].middle += j.at;
            add_rates(meetings.planes[plane].rates, rates, 1);
            const bool leaves = solids_[j.from].solid == j.solid;
            const int other = solids_[leaves ? j.to : j.from].solid;
            auto balance = std::find_if(balances.begin(), balances.end(), [&](const Balance& b) {
                return b.plane == plane && b.part == part && b.other == other;
            });
            if (balance == balances.end()) {
                balances.push_back({plane, part, other, 0});
                balance = balances.end() - 1;
            }
            balance->sum += (q % 2 ? -1 : 1) * (leaves ? 1 : -1);
        });
        for (auto& plane : meetings.planes) {
            plane.middle /= plane.count;
            scale_rates(plane.rates, 1.0 / plane.count);
        }
        if (meetings.count) {
            meetings.middle /= meetings.count;
            scale_rates(meetings.rates, 1.0 / meetings.count);
        }
        meetings.apart = !plain;
        for (const Balance& balance : balances)
            meetings.apart = meetings.apart && balance.sum == 0;
        return meetings;
    }

    /// By Stokes, from the borders of the pieces of part p: S = - sum of +-a.
    template <class Find, class Label>
    void add_walls(const std::array<HullFace, 6>& hull, const std::array<int, 7>& first, Find&& find, const Label& label,
                   const Meetings& meetings, int p, CellSlab<3>& result) const
    {
        const std::size_t begin = result.patches.size();
        for (int q = 0; q < 6; ++q) {
            const CutFace<3>* face = hull[q].face;
            if (!face)
                continue;
            const double sign = q % 2 ? -1 : 1;
            for (int k = 0; k < face->arcs; ++k) {
                const BorderArc<3>& arc = hull[q].slab->arcs[face->arc + k];
                if (label[find(first[q] + arc.piece)] == p)
                    add_patch<3>(result.patches, begin, solids_[arc.image].solid, sign * arc.area, sign * arc.moment);
            }
        }
        Meetings own; // of this part alone
        for_each_junction(hull, [&](int q, const Junction<3>& j, const PointRates<3>& rates) {
            if (label[find(first[q] + j.piece)] == p) {
                own.middle += j.at;
                add_rates(own.rates, rates, 1);
                ++own.count;
            }
        });
        if (own.count) {
            own.middle /= own.count;
            scale_rates(own.rates, 1.0 / own.count);
        }
        for_each_junction(hull, [&](int q, const Junction<3>& j, const PointRates<3>& rates) {
            if (label[find(first[q] + j.piece)] != p || !divides(j, q))
                return; // of a line that divides the cell on the face's other side both sides belong to the part
            const bool alone = meetings.planes.empty() && !meetings.crossed;
            const auto* plane = !alone && meetings.apart ? meetings.find(j) : nullptr;
            const Meetings& all = alone ? own : meetings;
            const Vec<3>& over = plane ? plane->middle : all.middle;
            const PointRates<3>& over_rates = plane ? plane->rates : all.rates;
            const double sign = q % 2 ? -1 : 1;
            for (const auto& [image, turn] : {std::pair{j.from, 1.0}, {j.to, -1.0}}) {
                Vec<3> reference = solids_[image].reference;
                reference[q / 2] += hull[q].shift;
                const auto [area, moment] = chord(j.at, over, reference);
                const int patch =
                    add_patch<3>(result.patches, begin, solids_[image].solid, sign * turn * area, sign * turn * moment);
                add_patch_rates(patch, sign * turn, j.at, over, rates, over_rates, reference, result);
            }
        });
        result.patches_of_part.push_back(static_cast<std::int32_t>(result.patches.size() - begin));
    }

    /// Of the way from a junction over the middle, which both move.
    void add_patch_rates(int patch, double factor, const Vec<3>& at, const Vec<3>& over, const PointRates<3>& at_rates,
                         const PointRates<3>& over_rates, const Vec<3>& reference, CellSlab<3>& result) const
    {
        for (const bool end : {false, true})
            for (const PointRate<3>& r : end ? over_rates : at_rates) {
                PatchRate<3> rate{patch, solids_[r.solid].solid, TwistMatrix<3>::Zero()};
                for (int k = 0; k < 6; ++k) {
                    const Vec<3> speed = r.rate.col(k), still = Vec<3>::Zero();
                    const auto [area, moment] = swept(at, over, end ? still : speed, end ? speed : still, reference);
                    rate.flux.col(k) << factor * area, factor * moment;
                }
                result.patch_rates.push_back(rate);
            }
    }

    const Grid<3>& grid_;
    const GridPlanes<3>& planes_;
    const DenseIndex<3>& index_;
    const std::vector<PlacedSolid<3>>& solids_;
    const CutFaces<3>& cut_;
    const FacetsInCells& facets_;
    std::vector<PartsBeside>& beside_;
    std::vector<std::int32_t>& cell_;
};

} // namespace

CellSlab<3> build_cells(const Grid<3>& grid, const GridPlanes<3>& planes, const DenseIndex<3>& index,
                        const std::vector<PlacedSolid<3>>& solids, const CutFaces<3>& cut, const FacetsInCells& facets,
                        int slab_number, std::vector<PartsBeside>& beside, std::vector<std::int32_t>& cell)
{
    const Slab<3>& slab = cut.slabs[slab_number];
    return CellBuilder3(grid, planes, index, solids, cut, facets, beside, cell).build(slab.begin, slab.end);
}

} // namespace gapflow
