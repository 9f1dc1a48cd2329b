#include "gapflow/complex/area_derivative.hpp"
#include "gapflow/complex/complex.hpp"
#include "gapflow/complex/cut_faces.hpp"
#include "gapflow/complex/parameters.hpp"
#include "gapflow/complex/part_borders.hpp"
#include "gapflow/complex/seen_volume.hpp"
#include "gapflow/complex/surface_rate.hpp"
#include "gapflow/complex/wall_joins.hpp"
#include "gapflow/core/threads.hpp"
#include "gapflow/grid/field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

namespace gapflow {
namespace {

/// Parts below and above each piece of a slab's faces (2D: the first of each piece of a cell), numbers as in the slab of the part's cell; -1: none.
using PartsBeside = std::vector<std::array<std::int32_t, 2>>;

/// What the cells of one slab are made of; numbers of parts and cut cells count from 0 in each slab.
template <int D>
struct CellSlab {
    std::vector<std::int32_t> cut_cell, parts_of_cell, part_cell, patches_of_part;
    std::vector<double> part_area;
    std::vector<WallPatch<D>> patches;
    std::vector<CornerLink<D>> links; ///< 3D
    // Where derivatives are wanted.
    std::vector<PatchRate<D>> patch_rates;
    std::vector<LinkRate<D>> link_rates; ///< 3D
    /// Wholly open faces that lead to another part than their cell's largest.
    struct Astray {
        std::int8_t axis, side; ///< 1: the part lies on the face's high side
        std::int32_t face, part;
    };
    std::vector<Astray> astray;
};

/// Returns its number.
template <int D>
int add_patch(std::vector<WallPatch<D>>& patches, std::size_t begin, int solid, const Vec<D>& area, const Spin<D>& moment)
{
    for (std::size_t k = begin; k < patches.size(); ++k)
        if (patches[k].solid == solid) {
            patches[k].area += area;
            patches[k].moment += moment;
            return static_cast<int>(k);
        }
    patches.push_back({solid, area, moment});
    return static_cast<int>(patches.size()) - 1;
}

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
                                         -conductance / hole.margin * wrench<3>(hole.inward, hole.nearest - solid.reference)});
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
                if (a > b)
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
            const EdgeInCell edge = edge_in_cell(solids_[image].sharp, sectors, pair.edge, c, low, high);
            double all = 0;
            for (const Pair& other : pairs)
                if (other.edge == pair.edge && solids_[other.image].solid == solids_[pair.image].solid)
                    all += other.open;
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
                                    edge.at});
        }
    }
    static bool divided_by(const SharpSolid& sharp, const CellSectors& sectors, int edge)
    {
        const int edges = static_cast<int>(sharp.edges.size());
        return edge < edges ? std::find(sectors.edges.begin(), sectors.edges.end(), edge) != sectors.edges.end()
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

/// Whether a piece of a cell in 2D is a part: it has an open face, or is too large to be round-off.
bool is_part(const Slab<2>& slab, const CutFace<2>& face, int p)
{
    if (slab.pieces[face.piece + p].area > parameters.least_area)
        return true;
    if (face.detail < 0)
        return true; // one corner of it is open
    const FaceDetail& detail = slab.details[face.detail];
    return std::any_of(slab.stretches.begin() + detail.stretch[0], slab.stretches.begin() + detail.stretch[4],
                       [&](const OpenStretch& stretch) { return stretch.piece == p; });
}

/// 2D: a wall's area vector and moment follow from the ends of its arcs; those where solids meet move.
template <class IsIn>
void add_junction_rates(const Slab<2>& slab, const FaceDetail& detail, IsIn&& is_in, const std::vector<PlacedSolid<2>>& solids,
                        std::size_t begin, CellSlab<2>& result)
{
    for (int k = detail.junction; k < detail.junction + detail.junctions; ++k) {
        const Junction<2>& j = slab.junctions[k];
        if (!is_in(j.piece))
            continue;
        for (const auto& [image, turn] : {std::pair{j.from, 1.0}, {j.to, -1.0}}) {
            const int patch = add_patch<2>(result.patches, begin, solids[image].solid, Vec<2>::Zero(), Spin<2>::Zero());
            for (const PointRate<2>& r : slab.junction_rates[k]) {
                PatchRate<2> rate{patch, solids[r.solid].solid, TwistMatrix<2>::Zero()};
                rate.flux.row(0) = turn * r.rate.row(1);
                rate.flux.row(1) = -turn * r.rate.row(0);
                rate.flux.row(2) = -turn * (j.at - solids[image].reference).transpose() * r.rate;
                result.patch_rates.push_back(rate);
            }
        }
    }
}

/// Cells of a slab in 2D: the pieces of their rectangles are the parts.
CellSlab<2> build_cells2(const CutFaces<2>& cut, const DenseIndex<2>& index, const std::vector<PlacedSolid<2>>& solids,
                         int slab_number, PartsBeside& beside, std::vector<std::int32_t>& cell)
{
    CellSlab<2> result;
    const Slab<2>& slab = cut.slabs[slab_number];
    Index<2> low = index.low, high = index.low + index.size - Index<2>::Ones();
    low[1] = slab.begin;
    high[1] = slab.end;
    for_each_index<2>(low, high, [&](const Index<2>& c) {
        const int number = index(c);
        cell[number] = std::min(cut.face[0][number], 0);
        if (cut.face[0][number] < 0)
            return;
        const CutFace<2>& face = slab.faces[cut.face[0][number]];
        InlineVector<int, 4> label;
        int count = 0, largest = -1;
        for (int p = 0; p < face.pieces; ++p) {
            label.push_back(is_part(slab, face, p) ? -1 : -2);
            if (label[p] == -1 && (largest < 0 || slab.pieces[face.piece + p].area > slab.pieces[face.piece + largest].area))
                largest = p;
        }
        cell[number] = Complex<2>::solid;
        if (largest < 0)
            return;
        const int part = static_cast<int>(result.part_cell.size());
        cell[number] = static_cast<std::int32_t>(result.cut_cell.size());
        label[largest] = count++;
        for (int p = 0; p < face.pieces; ++p)
            if (label[p] == -1)
                label[p] = count++;
        for (int l = 0; l < count; ++l) {
            const std::size_t begin = result.patches.size();
            for (int p = 0; p < face.pieces; ++p)
                if (label[p] == l)
                    result.part_area.push_back(slab.pieces[face.piece + p].area);
            for (int k = 0; k < face.arcs; ++k) {
                const BorderArc<2>& arc = slab.arcs[face.arc + k];
                if (label[arc.piece] == l)
                    add_patch<2>(result.patches, begin, solids[arc.image].solid, arc.area, arc.moment);
            }
            if (!slab.junction_rates.empty() && face.detail >= 0)
                add_junction_rates(
                    slab, slab.details[face.detail], [&](int piece) { return label[piece] == l; }, solids, begin, result);
            result.part_cell.push_back(static_cast<std::int32_t>(result.cut_cell.size()));
            result.patches_of_part.push_back(static_cast<std::int32_t>(result.patches.size() - begin));
        }
        for (int p = 0; p < face.pieces; ++p)
            beside[face.piece + p][0] = label[p] < 0 ? -1 : part + label[p];
        result.cut_cell.push_back(number);
        result.parts_of_cell.push_back(count);
    });
    return result;
}

/// What is common to both dimensions: one numbering of the slabs' cells and parts.
template <int D>
class Joining {
public:
    Joining(const Grid<D>& grid, const GridPlanes<D>& planes, const std::vector<PlacedSolid<D>>& solids, const CutFaces<D>& cut,
            const std::vector<CellSlab<D>>& slabs, const std::vector<PartsBeside>& beside, Complex<D>& complex,
            FaceDerivatives<D>* derivatives)
        : grid_(grid), planes_(planes), solids_(solids), cut_(cut), slabs_(slabs), beside_(beside), complex_(complex),
          index_(complex.index), derivatives_(derivatives)
    {
        for (const CellSlab<D>& slab : slabs) {
            part_offset_.push_back(part_offset_.back() + static_cast<int>(slab.part_cell.size()));
            cell_offset_.push_back(cell_offset_.back() + static_cast<int>(slab.cut_cell.size()));
            patch_offset_.push_back(patch_offset_.back() + static_cast<int>(slab.patches.size()));
        }
        complex.cut_cell.resize(cell_offset_.back());
        complex.first_part.resize(cell_offset_.back() + 1);
        complex.part_cell.resize(part_offset_.back());
        complex.part_area.resize(part_offset_.back());
        complex.first_patch.resize(part_offset_.back() + 1);
        complex.patches.resize(patch_offset_.back());
        for_each_job(static_cast<int>(slabs.size()), [&](int s) { copy_slab(s); });
        for (std::size_t s = 0; s < slabs.size(); ++s) {
            if (derivatives) {
                for (PatchRate<D> rate : slabs[s].patch_rates) {
                    rate.patch += patch_offset_[s];
                    derivatives->patches.push_back(rate);
                }
                for (LinkRate<D> rate : slabs[s].link_rates) {
                    rate.link += static_cast<int>(complex.links.size());
                    derivatives->links.push_back(rate);
                }
            }
            for (CornerLink<D> link : slabs[s].links) {
                link.a += part_offset_[s];
                link.b += part_offset_[s];
                complex.links.push_back(link);
            }
        }
        for_each_job(D, [&](int d) { complex.main_area[d].assign(index_.count, 0); });
    }

    /// The largest part of a cell, or the cell where it is whole.
    PartOrCell main_of(const Index<D>& c) const
    {
        const Index<D> w = index_.wrapped(c);
        return index_.holds(w) ? complex_.main_of(index_(w)) : PartOrCell{};
    }

    /// Pieces of one slab.
    struct Pieces {
        std::vector<FacePiece<D>> pieces;
        std::vector<PieceSource> sources;
    };

    void add_piece(int d, const Index<D>& f, PartOrCell low, PartOrCell high, double area, const Vec<D>& centroid,
                   const PieceSource& source, Pieces& to)
    {
        const auto lies = [&](const PartOrCell& side, const Index<D>& c) {
            return side.exists() || !index_.holds(index_.wrapped(c));
        };
        if (!lies(low, f - step<D>(d)) || !lies(high, f) || (!low.exists() && !high.exists()))
            return; // a part too small to be one
        const std::int32_t id = index_(f);
        to.pieces.push_back({static_cast<std::int8_t>(d), id, low, high, area, centroid});
        if (sources)
            to.sources.push_back(source);
        if (complex_.joins_main(to.pieces.back()))
            complex_.main_area[d][id] += area;
    }

    /// Of all slabs, in their order.
    void add_all(const std::vector<Pieces>& lists)
    {
        std::vector<std::size_t> offset{0};
        for (const Pieces& list : lists)
            offset.push_back(offset.back() + list.pieces.size());
        complex_.pieces.resize(offset.back());
        if (sources)
            sources->resize(offset.back());
        for_each_job(static_cast<int>(lists.size()), [&](int s) {
            std::copy(lists[s].pieces.begin(), lists[s].pieces.end(), complex_.pieces.begin() + offset[s]);
            if (sources)
                std::copy(lists[s].sources.begin(), lists[s].sources.end(), sources->begin() + offset[s]);
        });
    }

    /// Part on a side of a piece of a slab's faces, where a cell of slab `of_cell` lies there.
    PartOrCell part_at(std::size_t slab, int piece, int side, std::size_t of_cell) const
    {
        const std::int32_t part = beside_[slab][piece][side];
        return part >= 0 ? PartOrCell::part(part + part_offset_[of_cell]) : PartOrCell{};
    }

    /// Parts below and above each piece of each slab; in 2D the first is the piece's own.
    std::vector<std::vector<std::array<PartOrCell, 2>>> parts_beside() const
    {
        std::vector<std::vector<std::array<PartOrCell, 2>>> result(slabs_.size());
        for (std::size_t s = 0; s < slabs_.size(); ++s) {
            result[s].resize(cut_.slabs[s].pieces.size());
            for (const CutFace<D>& face : cut_.slabs[s].faces) {
                const int plane = grid_.wrapped(index_.index(face.id) - step<D>(face.axis))[D - 1] - index_.low[D - 1];
                const std::size_t below = D == 2 || plane < 0 ? s : static_cast<std::size_t>(cut_.slab_of[plane]);
                for (int p = face.piece; face.state != CutFace<D>::State::dead && p < face.piece + face.pieces; ++p)
                    result[s][p] = {part_at(s, p, 0, below), part_at(s, p, 1, s)};
            }
        }
        return result;
    }

    Vec<D> face_centre(int d, const Index<D>& f) const
    {
        Vec<D> centre;
        for (int axis = 0; axis < D; ++axis)
            centre[axis] = axis == d ? planes_.place[axis][f[axis]]
                                     : 0.5 * (planes_.place[axis][f[axis]] + planes_.place[axis][f[axis] + 1]);
        return centre;
    }
    double face_area(int d, const Index<D>& f) const
    {
        double area = 1;
        for (int axis = 0; axis < D; ++axis)
            if (axis != d)
                area *= planes_.place[axis][f[axis] + 1] - planes_.place[axis][f[axis]];
        return area;
    }

    void join_faces() requires(D == 3);
    void join_faces() requires(D == 2);

    std::vector<PieceSource>* sources = nullptr; ///< of the complex's pieces, where they are wanted

private:
    void copy_slab(int s)
    {
        const CellSlab<D>& slab = slabs_[s];
        const int cell = cell_offset_[s], part = part_offset_[s], patch = patch_offset_[s];
        const auto sums = [](const std::vector<std::int32_t>& counts, int sum, auto to) { // ends of counted ranges
            for (const std::int32_t n : counts)
                *to++ = sum += n;
        };
        for (std::size_t k = 0; k < slab.cut_cell.size(); ++k) {
            complex_.cut_cell[cell + k] = slab.cut_cell[k];
            complex_.cell[slab.cut_cell[k]] += cell;
        }
        sums(slab.parts_of_cell, part, complex_.first_part.begin() + cell + 1);
        for (std::size_t k = 0; k < slab.part_cell.size(); ++k)
            complex_.part_cell[part + k] = slab.part_cell[k] + cell;
        std::copy(slab.part_area.begin(), slab.part_area.end(), complex_.part_area.begin() + part);
        sums(slab.patches_of_part, patch, complex_.first_patch.begin() + part + 1);
        std::copy(slab.patches.begin(), slab.patches.end(), complex_.patches.begin() + patch);
    }

    const Grid<D>& grid_;
    const GridPlanes<D>& planes_;
    const std::vector<PlacedSolid<D>>& solids_;
    const CutFaces<D>& cut_;
    const std::vector<CellSlab<D>>& slabs_;
    const std::vector<PartsBeside>& beside_;
    Complex<D>& complex_;
    const DenseIndex<D>& index_;
    std::vector<int> cell_offset_{0}, part_offset_{0}, patch_offset_{0}; ///< first one of each slab
    FaceDerivatives<D>* derivatives_;                                    ///< null: not wanted
};

template <int D>
void Joining<D>::join_faces() requires(D == 3)
{
    // Wholly open faces; a side that is none lies beyond the domain, or is a part too small to be one.
    for (int d = 0; d < 3; ++d)
        for_each_row_on_threads<3>(index_.low, index_.faces_end(d), [&](const Index<3>& row) {
            const int end = index_.faces_end(d)[0] - row[0], first = index_(row), last_cell = index_.high()[0] - row[0] - 1;
            const Index<3> below = index_.wrapped(row - step<3>(d));
            const bool side = below[d]<index_.low[d], beyond = d> 0 && row[d] == index_.high()[d];
            const int back = side ? 0 : index_(below) - first;
            for (int i = 0; i < end; ++i) {
                const int at = first + i;
                if (cut_.face[d][at] != Complex<3>::open)
                    continue;
                const bool last = beyond || i > last_cell;
                // Along the rows themselves only the first face has another cell before it.
                const int other = d == 0 && i > 0 ? at - 1 : at + back;
                const bool high = !last && complex_.cell[at] != Complex<3>::solid;
                const bool low = (!side || (d == 0 && i > 0)) && complex_.cell[other] != Complex<3>::solid;
                if (high || low)
                    complex_.main_area[d][at] = grid_.graded() ? face_area(d, index_.index(at)) : 1.0;
            }
        });
    std::vector<typename CellSlab<3>::Astray> astray;
    for (std::size_t s = 0; s < slabs_.size(); ++s)
        for (auto a : slabs_[s].astray) {
            a.part += part_offset_[s];
            astray.push_back(a);
        }
    std::sort(astray.begin(), astray.end(),
              [](const auto& a, const auto& b) { return std::tie(a.axis, a.face, a.side) < std::tie(b.axis, b.face, b.side); });
    std::vector<Pieces> lists(slabs_.size() + 1); // those astray before the slabs'
    for (std::size_t k = 0; k < astray.size();) {
        const int d = astray[k].axis, id = astray[k].face;
        const Index<3> f = index_.index(id);
        std::array<PartOrCell, 2> side{main_of(f - step<3>(d)), main_of(f)};
        for (; k < astray.size() && astray[k].axis == d && astray[k].face == id; ++k)
            side[astray[k].side] = PartOrCell::part(astray[k].part);
        const double area = std::exchange(complex_.main_area[d][id], 0.0);
        add_piece(d, f, side[0], side[1], area, face_centre(d, f), {}, lists[0]);
    }
    for_each_job(static_cast<int>(slabs_.size()), [&](int s) {
        const Slab<3>& slab = cut_.slabs[s];
        for (const CutFace<3>& face : slab.faces) {
            if (face.state == CutFace<3>::State::dead)
                continue;
            const Index<3> f = index_.index(face.id);
            const int d = face.axis, u = u_axis<3>(d), v = v_axis<3>(d);
            const int plane = index_.wrapped(f - step<3>(d))[2] - index_.low[2]; // of the cell below
            const int below = plane < 0 ? s : cut_.slab_of[plane];
            for (int p = 0; p < face.pieces; ++p) {
                const int number = face.piece + p;
                const SquarePiece& piece = slab.pieces[number];
                Vec<3> centroid;
                centroid[d] = planes_.place[d][f[d]];
                centroid[u] = piece.centroid[0];
                centroid[v] = piece.centroid[1];
                add_piece(d, f, part_at(s, number, 0, below), part_at(s, number, 1, s), piece.area, centroid,
                          {s, static_cast<std::int32_t>(&face - slab.faces.data()), number, 0, 0, 0}, lists[s + 1]);
            }
        }
    });
    add_all(lists);
}

template <int D>
void Joining<D>::join_faces() requires(D == 2)
{
    // An edge's open stretches and what lies behind them, as one of the rectangles beside it has them; a line that divides the rectangle
    // divides the edge on that side alone.
    struct Behind {
        double from, to;
        PartOrCell part;
    };
    using Behinds = InlineVector<Behind, 4>;
    const auto is_cut = [&](const Index<2>& w) { return index_.holds(w) && cut_.face[0][index_(w)] >= 0; };
    const auto stretches_of = [&](const Index<2>& c, int e, double from, double to, Behinds& list) {
        const Index<2> w = index_.wrapped(c);
        list.clear();
        if (!is_cut(w)) {
            const PartOrCell main = main_of(c);
            if (main.exists() || !index_.holds(w))
                list.push_back({from, to, main});
            return;
        }
        const std::size_t number = static_cast<std::size_t>(cut_.slab_of[w[1] - index_.low[1]]);
        const Slab<2>& slab = cut_.slabs[number];
        const CutFace<2>& face = slab.faces[cut_.face[0][index_(w)]];
        const auto part_of = [&](int piece) { return part_at(number, face.piece + piece, 0, number); };
        if (face.detail >= 0) {
            const FaceDetail& detail = slab.details[face.detail];
            for (int k = detail.stretch[e]; k < detail.stretch[e + 1]; ++k)
                list.push_back({slab.stretches[k].from, slab.stretches[k].to, part_of(slab.stretches[k].piece)});
            return;
        }
        const bool a = face.open >> e & 1, b = face.open >> ((e + 1) & 3) & 1;
        if (!a && !b)
            return;
        Behind stretch{from, to, part_of(0)};
        if (!(a && b)) {
            const bool at_low = e < 2 ? a : b; // the open end along the axis
            (at_low ? stretch.to : stretch.from) = slab.crossings[2 * face.crossing + (face.crossing_edge[0] == e ? 0 : 1)];
        }
        list.push_back(stretch);
    };
    std::vector<Pieces> pieces(1);
    Behinds low, high;
    for (int d = 0; d < 2; ++d)
        for_each_index<2>(index_.low, index_.faces_end(d), [&](const Index<2>& f) {
            const int along = 1 - d, e_low = d == 0 ? 1 : 2, e_high = d == 0 ? 3 : 0; // as edges of the cells below and above
            const Index<2> below = f - step<2>(d);
            const double from = planes_.place[along][f[along]], to = planes_.place[along][f[along] + 1];
            stretches_of(below, e_low, from, to, low);
            stretches_of(f, e_high, from, to, high);
            if (!is_cut(index_.wrapped(below)) && !is_cut(index_.wrapped(f))) {
                if (!low.empty() && !high.empty() && (low[0].part.exists() || high[0].part.exists()))
                    complex_.main_area[d][index_(f)] = to - from;
                return;
            }
            for (std::size_t i = 0, j = 0; i < low.size() && j < high.size();) {
                const double begin = std::max(low[i].from, high[j].from), end = std::min(low[i].to, high[j].to);
                if (end > begin) {
                    Vec<2> centroid;
                    centroid[d] = planes_.place[d][f[d]];
                    centroid[along] = 0.5 * (begin + end);
                    PieceSource source;
                    source.from = begin;
                    source.to = end;
                    for (const auto& [c, e] : {std::pair{below, e_low}, {f, e_high}})
                        if (const Index<2> w = index_.wrapped(c); is_cut(w)) {
                            const bool first = source.slab < 0;
                            (first ? source.slab : source.other_slab) = cut_.slab_of[w[1] - index_.low[1]];
                            (first ? source.face : source.other_face) = cut_.face[0][index_(w)];
                            (first ? source.edge : source.other_edge) = e;
                        }
                    add_piece(d, f, low[i].part, high[j].part, end - begin, centroid, source, pieces[0]);
                }
                const bool next_low = low[i].to <= high[j].to, next_high = high[j].to <= low[i].to;
                i += next_low;
                j += next_high;
            }
        });
    add_all(pieces);
    for (std::size_t s = 0; s < slabs_.size(); ++s)
        for (const CutFace<2>& face : cut_.slabs[s].faces) {
            if (face.state == CutFace<2>::State::dead || face.detail < 0)
                continue;
            const FaceDetail& detail = cut_.slabs[s].details[face.detail];
            for (int k = detail.division; k < detail.division + detail.divisions; ++k) {
                const CornerDivision<2>& division = cut_.slabs[s].divisions[k];
                const PartOrCell a = part_at(s, face.piece + division.a, 0, s), b = part_at(s, face.piece + division.b, 0, s);
                if (!a.exists() || !b.exists())
                    continue;
                if (derivatives_)
                    for (const DivisionRate<2>& rate : cut_.slabs[s].rates_of_division(k))
                        derivatives_->links.push_back(
                            {static_cast<std::int32_t>(complex_.links.size()), solids_[rate.image].solid, rate.rate});
                complex_.links.push_back({a.number(), b.number(), solids_[division.image].solid, division.conductance,
                                          division.open, division.covered, division.at});
            }
        }
}

} // namespace

template <int D>
DenseIndex<D>::DenseIndex(const Grid<D>& grid)
{
    Index<D> from = grid.low(), to = grid.high();
    std::array<bool, D> around{};
    for (int axis = 0; axis < D; ++axis) {
        const int cells = grid.cells()[axis];
        around[axis] = grid.periodic(axis) && to[axis] - from[axis] == cells;
        const bool on = grid.periodic(axis) && !around[axis];
        from[axis] = on ? from[axis] - shared_layers : std::max(0, from[axis] - shared_layers);
        to[axis] = on ? to[axis] + shared_layers : std::min(cells, to[axis] + shared_layers);
    }
    *this = DenseIndex(from, to);
    wraps = around;
}

template <int D>
Complex<D> build_complex(const Grid<D>& grid, std::span<const Solid<D>> solids, FaceDerivatives<D>* derivatives,
                         std::vector<PartFace<D>>* borders)
{
    Complex<D> complex;
    if (derivatives)
        *derivatives = {};
    complex.index = DenseIndex<D>(grid);
    const GridPlanes<D> planes(grid);
    Vec<D> low, high;
    for (int axis = 0; axis < D; ++axis) {
        low[axis] = planes.place[axis][complex.index.low[axis]];
        high[axis] = planes.place[axis][complex.index.high()[axis]];
    }
    if constexpr (D == 3) { // edges divide faces of the cells beside theirs
        low -= Vec<D>::Ones();
        high += Vec<D>::Ones();
    }
    const std::vector<PlacedSolid<D>> placed = place_solids<D>(grid, planes, solids, low, high);
    const CutFaces<D> cut = cut_faces<D>(grid, planes, complex.index, placed, derivatives || borders);
    complex.cell.assign(complex.index.count, Complex<D>::solid);
    std::vector<CellSlab<D>> slabs(cut.slabs.size());
    std::vector<PartsBeside> beside(cut.slabs.size());
    for_each_job(static_cast<int>(slabs.size()), [&](int s) { beside[s].assign(cut.slabs[s].pieces.size(), {-1, -1}); });
    std::optional<FacetsInCells> facets;
    if constexpr (D == 3)
        facets.emplace(planes, complex.index, placed);
    for_each_job(static_cast<int>(slabs.size()), [&](int s) {
        if constexpr (D == 3)
            slabs[s] = CellBuilder3(grid, planes, complex.index, placed, cut, *facets, beside, complex.cell)
                           .build(cut.slabs[s].begin, cut.slabs[s].end);
        else
            slabs[s] = build_cells2(cut, complex.index, placed, s, beside[s], complex.cell);
    });
    Joining<D> joining(grid, planes, placed, cut, slabs, beside, complex, derivatives);
    std::vector<PieceSource> sources;
    joining.sources = derivatives ? &sources : nullptr;
    joining.join_faces();
    if (derivatives) {
        face_derivatives<D>(planes, complex.index, placed, cut, sources, *derivatives);
    }
    if (borders)
        *borders = part_borders<D>(grid, planes, complex, placed, cut, joining.parts_beside());
    complex.seen_mass = seen_masses<D>(grid, planes, solids, placed, complex, derivatives);
    return complex;
}

template Complex<2> build_complex(const Grid<2>&, std::span<const Solid<2>>, FaceDerivatives<2>*, std::vector<PartFace<2>>*);
template Complex<3> build_complex(const Grid<3>&, std::span<const Solid<3>>, FaceDerivatives<3>*, std::vector<PartFace<3>>*);

template <int D>
long Complex<D>::bytes() const
{
    const auto of = [](const auto& v) { return static_cast<long>(v.capacity() * sizeof(v[0])); };
    long areas = 0;
    for (const std::vector<double>& area : main_area)
        areas += of(area);
    return areas + of(cell) + of(cut_cell) + of(first_part) + of(part_cell) + of(part_area) + of(first_patch) + of(patches) +
           of(pieces) + of(links);
}

template DenseIndex<2>::DenseIndex(const Grid<2>&);
template DenseIndex<3>::DenseIndex(const Grid<3>&);
template struct Complex<2>;
template struct Complex<3>;

} // namespace gapflow
