#include "gapflow/complex/cut_faces.hpp"

#include "gapflow/complex/parameters.hpp"
#include "gapflow/complex/surface_rate.hpp"
#include "gapflow/core/threads.hpp"
#include "gapflow/grid/field.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace gapflow {
namespace {

template <int D>
Index<D> vertex_of_corner(int d, Index<D> f, int c)
{
    if (c == 1 || c == 2)
        ++f[u_axis<D>(d)];
    if (c >= 2)
        ++f[v_axis<D>(d)];
    return f;
}

template <int D>
Vec<D> place_of(const GridPlanes<D>& planes, const Index<D>& vertex)
{
    Vec<D> x;
    for (int axis = 0; axis < D; ++axis)
        x[axis] = planes.place[axis][vertex[axis]];
    return x;
}

/// Where a convex solid's surface crosses an edge from a vertex that it covers (or not) to one that it does not (or does).
double crossing(const Stretch& line, bool low_covered, double from, double to)
{
    if (line.empty())
        return low_covered ? from : to;
    return std::clamp(low_covered ? line.to : line.from, from, to);
}

/// Whether a line enters and leaves a convex solid between two vertices that it does not cover.
bool crosses_twice(const Stretch& line, double from, double to)
{
    return !line.empty() && line.from >= from && line.to <= to;
}

/// Position of an in-plane point in space.
template <int D>
Vec<D> in_space(int d, double at, const Vec<2>& x)
{
    Vec<D> y;
    y[u_axis<D>(d)] = x[0];
    y[v_axis<D>(d)] = x[1];
    if constexpr (D == 3)
        y[d] = at;
    return y;
}

template <int D>
Vec<2> in_plane(int d, const Vec<D>& x)
{
    return {x[u_axis<D>(d)], x[v_axis<D>(d)]};
}

template <int D>
BorderArc<D> border_arc(int image, int piece, int d, double at, const Vec<D>& reference, const Vec<2>& A, const Vec<2>& B,
                        const Bulge& bulge)
{
    BorderArc<D> arc;
    arc.image = image;
    arc.piece = piece;
    if constexpr (D == 3) {
        const ArcIntegrals sums = arc_integrals(A, B, bulge, in_plane<3>(d, reference), at - reference[d]);
        const int u = u_axis<3>(d), v = v_axis<3>(d);
        arc.area[u] = sums.area[0];
        arc.area[v] = sums.area[1];
        arc.area[d] = sums.area[2];
        arc.moment[u] = sums.moment[0];
        arc.moment[v] = sums.moment[1];
        arc.moment[d] = 0;
    } else {
        const Vec<2> a = A - reference, b = B - reference;
        arc.area = Vec<2>(b[1] - a[1], a[0] - b[0]);
        arc.moment[0] = 0.5 * (a.squaredNorm() - b.squaredNorm());
    }
    return arc;
}

/// A face's plane.
template <int D>
double plane_of(const GridPlanes<D>& planes, int d, const Index<D>& f)
{
    return D == 3 ? planes.place[d][f[d]] : 0.0;
}

/// A face that needs Square; what was found for one solid alone lies idle.
template <int D>
void make_general(Slab<D>& slab, CutFace<D>& face)
{
    if (face.state == CutFace<D>::State::general)
        return;
    face.state = CutFace<D>::State::general;
    face.detail = static_cast<std::int32_t>(slab.details.size());
    slab.details.push_back({{face.image}, {}, 0, 0, 0, 0});
    face.pieces = face.arcs = 0;
}

/// The faces of the cells through which a solid's sharp edges and rims pass, in one slab.
void mark_sharp(const DenseIndex<3>& index, const SharpSolid& sharp, int image, CutFaces<3>& cut, Slab<3>& slab)
{
    const auto mark_around = [&](const Index<3>& cell) {
        if (!cut.grid->in_domain(cut.grid->wrapped(cell)))
            return;
        for (int d = 0; d < 3; ++d)
            for (int side = 0; side < 2; ++side) {
                Index<3> f = cell;
                f[d] += side;
                bool own = true;
                for (int axis = 0; axis < 3; ++axis) {
                    const int from = axis == 2 ? slab.begin : index.low[axis],
                              to = axis == 2 ? slab.end : index.low[axis] + index.size[axis] - 1;
                    const bool last = axis == d && to == index.high()[axis] && !index.wraps[axis];
                    own = own && f[axis] >= from && f[axis] < to + last;
                }
                if (!own)
                    continue;
                const int id = index(f);
                std::int32_t& number = cut.face[d][id];
                if (number == Complex<3>::solid)
                    continue;
                if (number < 0) {
                    number = static_cast<std::int32_t>(slab.faces.size());
                    slab.faces.push_back({id, static_cast<std::int8_t>(d), CutFace<3>::State::simple, 15, image});
                }
                make_general(slab, slab.faces[number]);
                auto& images = slab.details[slab.faces[number].detail].images;
                if (std::find(images.begin(), images.end(), image) == images.end())
                    images.push_back(image);
            }
    };
    for (const EdgeCell& edge : sharp.edge_cells)
        mark_around(edge.cell);
    for (const RimPiece& piece : sharp.pieces)
        mark_around(piece.cell);
}

/// Which faces one solid covers or cuts in a slab.
template <int D, class Kind>
class Marking {
public:
    Marking(const GridPlanes<D>& planes, const DenseIndex<D>& index, const PlacedSolid<D>& solid, const Kind& kind, int image,
            CutFaces<D>& cut, Slab<D>& slab)
        : planes_(planes), index_(index), solid_(solid), kind_(kind), image_(image), cut_(cut), slab_(slab)
    {
    }

    void mark()
    {
        mark_cut();
        if constexpr (D == 3)
            mark_sharp(index_, solid_.sharp, image_, cut_, slab_);
    }

private:
    void mark_cut()
    {
        for (int axis = 0; axis < D; ++axis) {
            const auto& p = planes_.place[axis];
            const int from = axis == D - 1 ? slab_.begin : index_.low[axis],
                      to = axis == D - 1 ? slab_.end : index_.low[axis] + index_.size[axis] - 1;
            low_[axis] = solid_.low[axis] > p[from] ? std::min(planes_.cell_of(axis, solid_.low[axis]), to) : from;
            high_[axis] = solid_.high[axis] < p[to] ? std::max(planes_.cell_of(axis, solid_.high[axis]) + 1, from) : to;
            low_[axis] = std::clamp(low_[axis], from, to);
            high_[axis] = std::clamp(high_[axis], from, to);
            if (solid_.inverse) { // it covers all that lies outside
                low_[axis] = from;
                high_[axis] = to;
            } else if (solid_.low[axis] > p[to] || solid_.high[axis] < p[from])
                return;
        }
        find_covered();
        for (int axis = 0; axis < D; ++axis)
            find_crossings(axis);
        for (int d = 0; d < face_kinds<D>; ++d)
            mark_faces(d);
    }

    long offset(const Index<D>& vertex) const { return (vertex - low_).dot(stride_); }

    void find_covered()
    {
        long size = 1;
        for (int axis = 0; axis < D; ++axis) {
            stride_[axis] = static_cast<int>(size);
            size *= high_[axis] - low_[axis] + 1;
        }
        covered_.resize(size);
        twice_.assign(size, 0);
        char* to = covered_.data();
        for_each_row<D>(low_, Index<D>(high_ + Index<D>::Ones()), [&](const Index<D>& row) {
            Vec<D> x = place_of(planes_, row);
            const double* along = &planes_.place[0][low_[0]];
            for (int i = 0; i <= high_[0] - low_[0]; ++i) {
                x[0] = along[i];
                *to++ = kind_.covers(x);
            }
        });
    }

    void find_crossings(int axis)
    {
        crossing_[axis].resize(covered_.size());
        Index<D> end = high_ + Index<D>::Ones();
        end[axis] = low_[axis] + 1;
        const int stride = stride_[axis], n = high_[axis] - low_[axis];
        const double* p = &planes_.place[axis][low_[axis]];
        for_each_index<D>(low_, end, [&](const Index<D>& start) {
            const Stretch line = kind_.line(axis, place_of(planes_, start));
            const long first = offset(start);
            const char* covered = &covered_[first];
            for (int i = 0; i < n; ++i) {
                const bool here = covered[i * stride], there = covered[(i + 1) * stride];
                if (here != there)
                    crossing_[axis][first + i * stride] = crossing(line, here, p[i], p[i + 1]);
                else if (!here && crosses_twice(line, p[i], p[i + 1]))
                    twice_[first + i * stride] |= static_cast<char>(1 << axis);
            }
        });
    }

    void mark_faces(int d)
    {
        const int u = u_axis<D>(d), v = v_axis<D>(d);
        Index<D> low = low_, high = high_;
        if constexpr (D == 3) {
            const bool own_last = slab_.end == index_.low[2] + index_.size[2] - 1;
            if (d == 2)
                high[2] = std::min(high_[2], slab_.end - 1 + own_last);
            if (index_.wraps[d])
                high[d] = std::min(high[d], index_.high()[d] - 1);
            if (high[d] < low[d])
                return;
            ++high[d];
        }
        const int n = D == 3 ? high[d] - low[d] : 1;
        std::vector<Section> sections(n);
        std::vector<char> known(n, 0);
        const auto section = [&](const Index<D>& f) -> const Section& {
            const int k = D == 3 ? f[d] - low[d] : 0;
            if (!known[k]) {
                known[k] = 1;
                sections[k] = kind_.section(d, plane_of(planes_, d, f));
            }
            return sections[k];
        };
        const long su = stride_[u], sv = stride_[v];
        // A section that lies within one face crosses no edge.
        std::vector<long> within(n, -1);
        if (solid_.low.allFinite())
            for (int k = 0; k < n; ++k) {
                Index<D> f = low;
                if constexpr (D == 3) {
                    f[d] = low[d] + k;
                    const double at = plane_of(planes_, d, f);
                    if (at < solid_.low[d] || at > solid_.high[d])
                        continue;
                }
                const Section& s = section(f);
                if (s.empty() || !s.closed)
                    continue;
                f[u] = planes_.cell_of(u, s.inside[0]);
                f[v] = planes_.cell_of(v, s.inside[1]);
                if (f[u] < low[u] || f[v] < low[v] || f[u] >= high_[u] || f[v] >= high_[v])
                    continue;
                const long at = offset(f);
                if (!covered_[at] && !covered_[at + su] && !covered_[at + sv] && !covered_[at + su + sv] &&
                    !crossed_twice(at, u, v))
                    within[k] = at;
            }
        high[u] = high_[u];
        high[v] = high_[v];
        find_corners();
        auto& face = cut_.face[D == 3 ? d : 0];
        for_each_index<D>(low, high, [&](const Index<D>& f) {
            const long at = offset(f);
            const unsigned covered =
                covered_[at] | covered_[at + su] << 1 | covered_[at + su + sv] << 2 | covered_[at + sv] << 3;
            const unsigned open = solid_.inverse ? covered : ~covered & 15U;
            const bool twice = crossed_twice(at, u, v), holds = within[D == 3 ? f[d] - low[d] : 0] == at;
            if (open == 15 && !twice && !holds)
                return;
            const int id = index_(f);
            std::int32_t& number = face[id];
            if (number == Complex<D>::solid)
                return;
            if (open == 0 && !twice && !holds) {
                if (number >= 0)
                    slab_.faces[number].state = CutFace<D>::State::dead;
                number = Complex<D>::solid;
                return;
            }
            const bool divided = std::find(with_corner_.begin(), with_corner_.end(), at) != with_corner_.end();
            const bool simple = !twice && !holds && !divided && open != 5 && open != 10 && open != 0 && open != 15;
            if (number >= 0) {
                make_general(slab_, slab_.faces[number]);
                slab_.details[slab_.faces[number].detail].images.push_back(image_);
                return;
            }
            number = static_cast<std::int32_t>(slab_.faces.size());
            slab_.faces.push_back(
                {id, static_cast<std::int8_t>(d), CutFace<D>::State::simple, static_cast<std::uint8_t>(open), image_});
            if (simple)
                add_simple(d, f, at, open, section(f));
            else
                make_general(slab_, slab_.faces.back());
        });
    }

    /// Cells of the corners that divide.
    void find_corners()
    {
        with_corner_.clear();
        if constexpr (D == 2)
            for (const SharpCorner& corner : solid_.corners) {
                const Index<2> c(planes_.cell_of(0, corner.at[0]), planes_.cell_of(1, corner.at[1]));
                if ((c.array() >= low_.array()).all() && (c.array() < high_.array()).all())
                    with_corner_.push_back(offset(c));
            }
    }

    bool crossed_twice(long at, int u, int v) const
    {
        return (twice_[at] >> u & 1) || (twice_[at + stride_[u]] >> v & 1) || (twice_[at + stride_[v]] >> u & 1) ||
               (twice_[at] >> v & 1);
    }

    /// One solid, one open stretch of the border, one arc.
    void add_simple(int d, const Index<D>& f, long at, unsigned open, const Section& section)
    {
        const int u = u_axis<D>(d), v = v_axis<D>(d);
        const double u0 = planes_.place[u][f[u]], u1 = planes_.place[u][f[u] + 1], v0 = planes_.place[v][f[v]],
                     v1 = planes_.place[v][f[v] + 1];
        const auto corner = [&](int c) { return Vec<2>(c == 1 || c == 2 ? u1 : u0, c >= 2 ? v1 : v0); };
        const auto on_edge = [&](int e) {
            switch (e) {
            case 0:
                return Vec<2>(crossing_[u][at], v0);
            case 1:
                return Vec<2>(u1, crossing_[v][at + stride_[u]]);
            case 2:
                return Vec<2>(crossing_[u][at + stride_[v]], v1);
            default:
                return Vec<2>(u0, crossing_[v][at]);
            }
        };
        int first = 0; // the first open corner
        while (!(open >> first & 1) || (open >> ((first + 3) & 3) & 1))
            ++first;
        const Vec<2> B = on_edge((first + 3) & 3);
        Vec<2> here = corner(first);
        int c = first;
        double twice_area = 0;
        Vec<2> moment = Vec<2>::Zero();
        const auto to = [&](const Vec<2>& x) { // triangle B, here, x
            const Vec<2> p = here - B, q = x - B;
            const double w = p[0] * q[1] - p[1] * q[0];
            twice_area += w;
            moment += w * (here + x + B);
            here = x;
        };
        while (open >> ((c + 1) & 3) & 1) {
            ++c;
            to(corner(c & 3));
        }
        const Vec<2> A = on_edge(c & 3);
        to(A);
        const Bulge bulge = solid_.inverse ? -section.piece(B, A, false) : section.piece(A, B, false);
        const double area = 0.5 * twice_area + bulge.area;
        CutFace<D>& face = slab_.faces.back();
        face.piece = static_cast<std::int32_t>(slab_.pieces.size());
        face.arc = static_cast<std::int32_t>(slab_.arcs.size());
        face.pieces = face.arcs = 1;
        if constexpr (D == 2) {
            face.crossing = static_cast<std::int32_t>(slab_.crossings.size() / 2);
            face.crossing_edge = {static_cast<std::int8_t>((first + 3) & 3), static_cast<std::int8_t>(c & 3)};
            for (const int e : face.crossing_edge)
                slab_.crossings.push_back(e % 2 == 0 ? on_edge(e)[0] : on_edge(e)[1]);
        }
        slab_.pieces.push_back(
            {std::max(area, 0.0), area > 0 ? Vec<2>((moment / 6 + bulge.moment) / area) : Vec<2>(0.5 * (A + B))});
        slab_.arcs.push_back(border_arc<D>(image_, 0, d, plane_of(planes_, d, f), solid_.reference, A, B, bulge));
    }

    const GridPlanes<D>& planes_;
    const DenseIndex<D>& index_;
    const PlacedSolid<D>& solid_;
    const Kind& kind_;
    int image_;
    CutFaces<D>& cut_;
    Slab<D>& slab_;
    Index<D> low_, high_, stride_; ///< vertices low .. high
    std::vector<char> covered_, twice_;
    std::array<std::vector<double>, D> crossing_;
    std::vector<long> with_corner_;
};

/// Where a mesh covers or cuts faces in a slab.
template <int D>
class FacetMarking {
public:
    FacetMarking(const GridPlanes<D>& planes, const DenseIndex<D>& index, const PlacedSolid<D>& solid, const FacetKind<D>& kind,
                 int image, CutFaces<D>& cut, Slab<D>& slab)
        : planes_(planes), index_(index), solid_(solid), kind_(kind), image_(image), cut_(cut), slab_(slab)
    {
    }

    /// Empty: the mesh does not meet the slab.
    std::optional<FacetCut<D>> mark()
    {
        std::array<std::vector<double>, D> places;
        for (int axis = 0; axis < D; ++axis) {
            const auto& p = planes_.place[axis];
            const int from = axis == D - 1 ? slab_.begin : index_.low[axis],
                      to = axis == D - 1 ? slab_.end : index_.low[axis] + index_.size[axis] - 1;
            low_[axis] = from;
            high_[axis] = to;
            if (!solid_.inverse) {
                if (solid_.low[axis] > p[to] + 1 || solid_.high[axis] < p[from] - 1)
                    return {};
                // One cell more: the surface's bounds are not rounded.
                low_[axis] = std::clamp(planes_.cell_of(axis, solid_.low[axis]) - 1, from, to - 1);
                high_[axis] = std::clamp(planes_.cell_of(axis, solid_.high[axis]) + 2, low_[axis] + 1, to);
            }
            for (int i = low_[axis]; i <= high_[axis]; ++i)
                places[axis].push_back(p[i]);
        }
        std::optional<FacetCut<D>> facets(std::in_place, kind_.vertices, kind_.surface->elements, *kind_.links, places, low_);
        for (int d = 0; d < face_kinds<D>; ++d) {
            Index<D> end = high_;
            if constexpr (D == 3) {
                end[d] = high_[d] + 1;
                const bool own_last = slab_.end == index_.low[2] + index_.size[2] - 1;
                if (d == 2)
                    end[2] = std::min(end[2], slab_.end + own_last);
                if (index_.wraps[d])
                    end[d] = std::min(end[d], index_.high()[d]);
            }
            auto& face = cut_.face[d];
            DenseIndex<D> local(low_, end);
            std::vector<char> chained(local.count, 0);
            for (const ChainedFace<D>& f : facets->chained_faces()) {
                if ((D == 3 && f.axis != d) || (f.face.array() >= end.array()).any())
                    continue;
                chained[local(f.face)] = 1;
                std::int32_t& number = face[index_(f.face)];
                if (number == Complex<D>::solid)
                    continue;
                if (number < 0) {
                    number = static_cast<std::int32_t>(slab_.faces.size());
                    slab_.faces.push_back({index_(f.face), static_cast<std::int8_t>(d), CutFace<D>::State::simple, 0, image_});
                    make_general(slab_, slab_.faces.back());
                } else {
                    make_general(slab_, slab_.faces[number]);
                    slab_.details[slab_.faces[number].detail].images.push_back(image_);
                }
            }
            for_each_index<D>(low_, end, [&](const Index<D>& f) {
                if (chained[local(f)] || !facets->covered(f))
                    return;
                std::int32_t& number = face[index_(f)];
                if (number >= 0)
                    slab_.faces[number].state = CutFace<D>::State::dead;
                number = Complex<D>::solid;
            });
        }
        if constexpr (D == 3)
            mark_sharp(index_, solid_.sharp, image_, cut_, slab_);
        return facets;
    }

private:
    const GridPlanes<D>& planes_;
    const DenseIndex<D>& index_;
    const PlacedSolid<D>& solid_;
    const FacetKind<D>& kind_;
    int image_;
    CutFaces<D>& cut_;
    Slab<D>& slab_;
    Index<D> low_, high_;
};

template <int D>
void fill_square_of_facets(const GridPlanes<D>& planes, const FacetCut<D>& facets, int d, const Index<D>& f, SquareSolid& solid)
{
    solid.section = nullptr;
    solid.inverse = solid.section_inside = false;
    solid.arcs.clear();
    const Vec<2> low(planes.place[u_axis<D>(d)][f[u_axis<D>(d)]], planes.place[v_axis<D>(d)][f[v_axis<D>(d)]]);
    for (int e = 0; e < 4; ++e) {
        solid.edges[e].clear();
        for (const EdgeCover& cover : facets.edge(edge_axis<D>(d, e), edge_start<D>(d, f, e)))
            solid.edges[e].push_back({low[e % 2] + cover.from, low[e % 2] + cover.to});
    }
    const FaceChains chains = facets.face(D == 3 ? d : 2, f);
    for (int k = 0; k < chains.size(); ++k) {
        const FacetChain chain = chains[k];
        SquareArc arc;
        const std::size_t n = chain.points.size();
        arc.from = low + chain.points[0];
        arc.to = low + chain.points[n - 1];
        if (!chain.closed()) {
            arc.start = {chain.first_edge, arc.from[chain.first_edge % 2]};
            arc.end = {chain.last_edge, arc.to[chain.last_edge % 2]};
        }
        for (std::size_t i = 0; i + 1 < n; ++i)
            arc.segments.push_back({low + chain.points[i], low + chain.points[i + 1], nullptr, chain.facets[i], false, false});
        solid.arcs.push_back(arc);
    }
}

/// Fills what a convex solid covers of a rectangle's edges, from the same numbers as Marking.
template <int D, class Kind>
void fill_square(const GridPlanes<D>& planes, const PlacedSolid<D>& placed, const Kind& kind, int d, const Index<D>& f,
                 const Section& section, SquareSolid& solid)
{
    std::array<bool, 4> covered;
    for (int c = 0; c < 4; ++c)
        covered[c] = kind.covers(place_of(planes, vertex_of_corner<D>(d, f, c)));
    bool any = covered[0] || covered[1] || covered[2] || covered[3];
    for (int e = 0; e < 4; ++e) {
        const int axis = edge_axis<D>(d, e);
        const Index<D> start = edge_start<D>(d, f, e);
        const double from = planes.place[axis][start[axis]], to = planes.place[axis][start[axis] + 1];
        const bool here = covered[e < 2 ? e : (e + 1) % 4], there = covered[e < 2 ? e + 1 : e]; // at its low and high end
        auto& list = solid.edges[e];
        list.clear();
        const Stretch line = kind.line(axis, place_of(planes, start));
        if (here && there) {
            if (!placed.inverse)
                list.push_back({from, to});
        } else if (here != there) {
            const double at = crossing(line, here, from, to);
            list.push_back(here != placed.inverse ? Stretch{from, at} : Stretch{at, to});
        } else if (crosses_twice(line, from, to)) {
            any = true;
            if (placed.inverse) {
                list.push_back({from, line.from});
                list.push_back({line.to, to});
            } else
                list.push_back(line);
        } else if (placed.inverse)
            list.push_back({from, to});
    }
    solid.inverse = placed.inverse;
    solid.section = &section;
    const Vec<2>& x = section.inside;
    solid.section_inside = !any && !section.empty() && section.closed && x[0] >= planes.place[u_axis<D>(d)][f[u_axis<D>(d)]] &&
                           x[0] <= planes.place[u_axis<D>(d)][f[u_axis<D>(d)] + 1] &&
                           x[1] >= planes.place[v_axis<D>(d)][f[v_axis<D>(d)]] &&
                           x[1] <= planes.place[v_axis<D>(d)][f[v_axis<D>(d)] + 1];
}

/// How the edges of each of a face's images divide a cell beside it.
std::vector<CellSectors> divided_cell(const Grid<3>& grid, const GridPlanes<3>& planes,
                                      const std::vector<PlacedSolid<3>>& solids, const std::vector<int>& images,
                                      const Index<3>& c)
{
    std::vector<CellSectors> sectors(images.size());
    if (!grid.in_domain(grid.wrapped(c)))
        return sectors;
    Vec<3> low, high;
    for (int axis = 0; axis < 3; ++axis) {
        low[axis] = planes.place_of(axis, c[axis]);
        high[axis] = planes.place_of(axis, c[axis] + 1);
    }
    for (std::size_t k = 0; k < images.size(); ++k)
        if (!solids[images[k]].sharp.empty())
            sectors[k] = cell_sectors(solids[images[k]].sharp, c, low, high);
    return sectors;
}

/// The corner of a section between two surfaces of its solid that lies next to x; x itself where there is none.
Vec<2> section_corner(const Section& section, int a, int b, const Vec<2>& x)
{
    Vec<2> nearest = x;
    double least = std::numeric_limits<double>::infinity();
    for (int m = 0; m < section.count; ++m) {
        const int s = section.curve[m].surface, t = section.curve[(m + section.count - 1) % section.count].surface;
        if (const double distance = (section.corner[m] - x).squaredNorm();
            ((s == a && t == b) || (t == a && s == b)) && distance < least) {
            least = distance;
            nearest = section.corner[m];
        }
    }
    return nearest;
}

/// The same of a mesh's border.
Vec<2> section_corner(const SquareSolid& solid, const SharpSolid& sharp, int a, int b, const Vec<2>& x)
{
    Vec<2> nearest = x;
    double least = std::numeric_limits<double>::infinity();
    const auto offer = [&](const ArcSegment& in, const ArcSegment& out) {
        const int s = sharp.facet_of[in.surface], t = sharp.facet_of[out.surface];
        if (const double distance = (in.to - x).squaredNorm(); ((s == a && t == b) || (t == a && s == b)) && distance < least) {
            least = distance;
            nearest = in.to;
        }
    };
    for (const SquareArc& arc : solid.arcs) {
        const std::size_t n = arc.segments.size();
        for (std::size_t k = 0; k + 1 < n; ++k)
            offer(arc.segments[k], arc.segments[k + 1]);
        if (arc.start.edge < 0)
            offer(arc.segments[n - 1], arc.segments[0]);
    }
    return nearest;
}

/// Moves x onto a border of the rectangle, to the last bit.
void put_on_border(const Square& square, const OnEdge& place, Vec<2>& x)
{
    if (place.edge < 0)
        return;
    x[place.edge % 2] = place.at;
    x[1 - place.edge % 2] =
        place.edge == 1 || place.edge == 2 ? square.high[1 - place.edge % 2] : square.low[1 - place.edge % 2];
}
OnEdge border_at(const Square& square, int edge, const Vec<2>& x)
{
    if (edge < 0)
        return {};
    return {edge, std::clamp(x[edge % 2], square.low[edge % 2], square.high[edge % 2])};
}

using DividedCells = std::array<std::vector<CellSectors>, 2>; ///< below and above a face, of each of its images

bool lies_on(const SquareLine& line, const SquareLine& other)
{
    const Vec<2> way = other.to - other.from;
    if (!((line.to - line.from).norm() > parameters.joint_distance))
        return false;
    const auto on = [&](const Vec<2>& x) {
        const double t = std::clamp((x - other.from).dot(way) / way.squaredNorm(), 0.0, 1.0);
        return (other.from + t * way - x).norm() < parameters.joint_distance;
    };
    return on(line.from) && on(line.to);
}

/// Onto the end within the rectangle of another line of the same solid, if there is one.
void move_to_end(const Square& square, int solid, Vec<2>& x)
{
    for (const SquareLine& line : square.lines)
        if (line.solid == solid)
            for (const auto& [end, border] : {std::pair{line.from, line.from_border}, {line.to, line.to_border}})
                if (border.edge < 0 && (end - x).norm() < parameters.joint_distance) {
                    x = end;
                    return;
                }
}

void add_edge_lines(const SharpSolid& sharp, const DividedCells& cells, int image, int k, const Section& section, int d,
                    double at, Square& square, std::vector<FaceLine>& face_lines)
{
    InlineVector<int, 4> in_cells; // edges that divide one of the cells or both
    for (const auto& cell : cells)
        for (const int e : cell[k].edges)
            if (std::find(in_cells.begin(), in_cells.end(), e) == in_cells.end())
                in_cells.push_back(e);
    std::sort(in_cells.begin(), in_cells.end());
    for (const int e : in_cells) {
        std::array<SectorLine, 2> line;
        for (int side = 0; side < 2; ++side) {
            const auto& edges = cells[side][k].edges;
            if (std::find(edges.begin(), edges.end(), e) != edges.end())
                line[side] = sector_line(sharp, cells[side][k], e, d, at, square.low, square.high);
        }
        if (line[0].empty() && line[1].empty())
            continue;
        // Its portions in one of the cells or in both.
        const SectorLine& any = line[0].empty() ? line[1] : line[0];
        InlineVector<double, 4> breaks;
        for (const SectorLine& l : line)
            if (!l.empty())
                for (const double t : {l.from, l.to})
                    if (std::find(breaks.begin(), breaks.end(), t) == breaks.end())
                        breaks.push_back(t);
        std::sort(breaks.begin(), breaks.end());
        const auto on_border = [&](int border, const Vec<2>& x) {
            const Vec<3> corner = in_space<3>(
                d, at, {border == 1 ? square.high[0] : square.low[0], border == 2 ? square.high[1] : square.low[1]});
            Vec<2> crossing = x;
            crossing[border % 2] = bisector_crossing(sharp, e, edge_axis<3>(d, border), corner);
            return border_at(square, border, crossing);
        };
        for (std::size_t j = 0; j + 1 < breaks.size(); ++j) {
            SquareLine portion{k, any.at(breaks[j]), any.at(breaks[j + 1]), {}, {}};
            int sides = 0;
            for (int side = 0; side < 2; ++side) {
                const SectorLine& l = line[side];
                if (l.empty() || l.from > breaks[j] || l.to < breaks[j + 1])
                    continue;
                sides |= 1 << side;
                if (l.from == breaks[j] && l.from_end == SectorLine::End::border)
                    portion.from_border = on_border(l.from_edge, portion.from);
                if (l.to == breaks[j + 1] && l.to_end == SectorLine::End::border)
                    portion.to_border = on_border(l.to_edge, portion.to);
                if (l.from == breaks[j] && l.from_end == SectorLine::End::corner)
                    portion.from =
                        sharp.facet_of.empty()
                            ? section_corner(section, sharp.edges[e].a, sharp.edges[e].b, portion.from)
                            : section_corner(square.solids[k], sharp, sharp.edges[e].a, sharp.edges[e].b, portion.from);
            }
            if (sides == 0)
                continue;
            put_on_border(square, portion.from_border, portion.from);
            put_on_border(square, portion.to_border, portion.to);
            for (const bool end : {false, true}) // planes of a mesh meet in one line to the rounding of its vertices only
                if ((end ? portion.to_border : portion.from_border).edge < 0)
                    move_to_end(square, k, end ? portion.to : portion.from);
            const auto same = std::find_if(square.lines.begin(), square.lines.end(), [&](const SquareLine& other) {
                return other.solid == k && (lies_on(portion, other) || lies_on(other, portion));
            });
            if (same == square.lines.end()) {
                square.lines.push_back(portion);
                face_lines.push_back({image, e, sides});
            } else // of two edges that meet in the face's plane, one in each cell
                face_lines[same - square.lines.begin()].sides |= sides;
        }
    }
}

void add_rim_lines(const SharpSolid& sharp, const DividedCells& cells, int image, int k, const Section& section, int d,
                   double at, Square& square, std::vector<FaceLine>& face_lines)
{
    constexpr int side_surface = 2;
    for (int r = 0; r < static_cast<int>(sharp.rims.size()); ++r) {
        int sides = 0;
        for (int side = 0; side < 2; ++side) {
            const auto& rims = cells[side][k].rims;
            if (std::find(rims.begin(), rims.end(), r) != rims.end())
                sides |= 1 << side;
        }
        if (sides == 0)
            continue;
        for (const RimLine& line : rim_lines(sharp.rims[r], d, at, square.low, square.high)) {
            SquareLine portion{k, line.from, line.to, border_at(square, line.from_edge, line.from),
                               border_at(square, line.to_edge, line.to)};
            if (line.from_edge < 0)
                portion.from = section_corner(section, r, side_surface, portion.from);
            put_on_border(square, portion.from_border, portion.from);
            put_on_border(square, portion.to_border, portion.to);
            square.lines.push_back(portion);
            face_lines.push_back({image, static_cast<int>(sharp.edges.size()) + r, sides});
        }
    }
}

void add_lines(const Grid<3>& grid, const GridPlanes<3>& planes, const std::vector<PlacedSolid<3>>& solids,
               const std::vector<int>& images, const std::vector<Section>& sections, int d, const Index<3>& f, Square& square,
               std::vector<FaceLine>& face_lines)
{
    if (std::all_of(images.begin(), images.end(), [&](int image) { return solids[image].sharp.empty(); }))
        return;
    const DividedCells cells{divided_cell(grid, planes, solids, images, f - step<3>(d)),
                             divided_cell(grid, planes, solids, images, f)};
    const double at = planes.place[d][f[d]];
    for (int k = 0; k < static_cast<int>(images.size()); ++k) {
        const SharpSolid& sharp = solids[images[k]].sharp;
        add_edge_lines(sharp, cells, images[k], k, sections[k], d, at, square, face_lines);
        add_rim_lines(sharp, cells, images[k], k, sections[k], d, at, square, face_lines);
    }
}

} // namespace

/// Cuts faces that more than one solid, or one in an uncommon way, cuts.
template <int D>
class GeneralCut {
public:
    /// `faces`: with its grid.
    GeneralCut(const CutFaces<D>& faces, const GridPlanes<D>& planes, const DenseIndex<D>& index,
               const std::vector<PlacedSolid<D>>& solids, bool with_chords = false)
        : faces_(faces), planes_(planes), index_(index), solids_(solids)
    {
        square_.with_chords = with_chords;
    }

    /// `facets`: of the face's slab. Valid until the next call.
    Square& cut(const CutFace<D>& face, const FaceDetail& detail, const std::vector<std::optional<FacetCut<D>>>& facets)
    {
        const Index<D> f = index_.index(face.id);
        const int d = face.axis, u = u_axis<D>(d), v = v_axis<D>(d);
        const double at = plane_of(planes_, d, f);
        square_.low = {planes_.place[u][f[u]], planes_.place[v][f[v]]};
        square_.high = {planes_.place[u][f[u] + 1], planes_.place[v][f[v] + 1]};
        square_.solids.resize(detail.images.size());
        sections_.resize(detail.images.size());
        for (std::size_t k = 0; k < detail.images.size(); ++k) {
            const PlacedSolid<D>& placed = solids_[detail.images[k]];
            std::visit(
                [&](const auto& kind) {
                    if constexpr (!std::is_same_v<std::decay_t<decltype(kind)>, FacetKind<D>>) {
                        sections_[k] = kind.section(d, at);
                        fill_square<D>(planes_, placed, kind, d, f, sections_[k], square_.solids[k]);
                    } else
                        fill_square_of_facets<D>(planes_, *facets[detail.images[k]], d, f, square_.solids[k]);
                },
                placed.kind);
        }
        square_.corners.clear();
        sharp_.clear();
        if constexpr (D == 2)
            for (std::size_t k = 0; k < detail.images.size(); ++k)
                for (const SharpCorner& corner : solids_[detail.images[k]].corners)
                    if ((corner.at.array() > square_.low.array()).all() && (corner.at.array() < square_.high.array()).all()) {
                        square_.corners.push_back({static_cast<int>(k), corner.at, corner.outward});
                        sharp_.push_back(&corner);
                    }
        square_.lines.clear();
        lines_.clear();
        if constexpr (D == 3)
            add_lines(*faces_.grid, planes_, solids_, detail.images, sections_, d, f, square_, lines_);
        square_.cut();
        return square_;
    }
    /// Of the last face: the corners of Square::corners, and the lines of Square::lines.
    const SharpCorner& corner(int k) const { return *sharp_[k]; }
    const FaceLine& line(int k) const { return lines_[k]; }

private:
    const CutFaces<D>& faces_;
    const GridPlanes<D>& planes_;
    const DenseIndex<D>& index_;
    const std::vector<PlacedSolid<D>>& solids_;
    Square square_;
    std::vector<Section> sections_;
    std::vector<const SharpCorner*> sharp_;
    std::vector<FaceLine> lines_;
};

namespace {

void add_facets(std::vector<ArcFacet>& facets, std::int32_t number, const SquareArc& arc)
{
    std::int32_t last = -1;
    for (const ArcSegment& segment : arc.segments)
        if (segment.fin < 0 && segment.surface >= 0 && segment.surface != last)
            facets.push_back({number, last = segment.surface});
}

/// From the corner back along its line to the rectangle's border: how far, and across which axis.
std::pair<double, int> covered_way(const SharpCorner& corner, const Square& square)
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
    return {covered, across};
}

/// From the corner along its line to the rectangle's border, likewise.
std::pair<double, int> way_out(const SharpCorner& corner, const Square& square)
{
    double reach = std::numeric_limits<double>::infinity();
    int across = 0;
    for (int axis = 0; axis < 2; ++axis)
        if (const double slope = corner.outward[axis]; slope != 0)
            if (const double way = ((slope > 0 ? square.high : square.low)[axis] - corner.at[axis]) / slope; way < reach) {
                reach = way;
                across = axis;
            }
    return {reach, across};
}

/// Conductance of a corner's link, and its derivatives. A line that ends at a solid at a short way d of its reach r to the rectangle's border leads
/// through a mouth: beyond it the flow spreads over a sector of a right angle, whose resistance is (2/pi) ln r/d; with c = r it comes after
/// that of the line to the border.
struct CornerConductance {
    double value, by_open, by_reach = 0;
};
CornerConductance link_conductance(double angle, const SquareLink& link, double covered)
{
    if (link.reach == 0)
        return {corner_conductance(angle, link.open, covered), corner_conductance(angle, 1, covered)};
    const double share = 2 / std::numbers::pi * corner_conductance(angle, 1, 1),
                 sum = 1 + share * std::log(link.reach / link.open),
                 value = corner_conductance(angle, link.reach, covered) / sum;
    return {value, value * share / (sum * link.open), value / link.reach * (1 - share / sum)};
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
        const SharpCorner& corner = general_.corner(link.fin);
        const int image = images_[square_.corners[link.fin].solid];
        const auto [covered, axis] = covered_way(corner, square_);
        if (!(covered > parameters.least_covered))
            return;
        const CornerConductance g = link_conductance(corner.angle, link, covered);
        add_open(link, g.by_open);
        // Back from the corner, to the rectangle's border.
        const Vec<2> n = corner.outward, x = corner.at - covered * n, normal(-n[1], n[0]), arm = solids_[image].reference;
        const MovingLine<2> own{normal, wrench<2>(normal, x - arm), image};
        for (const PointRate<2>& r : meeting_rates<2>(d_, own, {unit<2>(axis), Twist<2>::Zero(), -1}))
            add_rate(image, g.value / covered * (r.rate.transpose() * n - wrench<2>(n, corner.at - arm)));
        if (link.reach == 0)
            return;
        const auto [reach, side] = way_out(corner, square_); // and on to it
        const Vec<2> y = corner.at + reach * n;
        for (const PointRate<2>& r :
             meeting_rates<2>(d_, {normal, wrench<2>(normal, y - arm), image}, {unit<2>(side), Twist<2>::Zero(), -1}))
            add_rate(image, g.by_reach * (r.rate.transpose() * n - wrench<2>(n, corner.at - arm)));
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
                continue;
            }
            const SharpCorner& corner = general.corner(link.fin);
            const double covered = covered_way(corner, square).first;
            slab.divisions.push_back({detail.images[square.corners[link.fin].solid], link.a, link.b,
                                      link_conductance(corner.angle, link, covered).value, link.open, covered,
                                      in_space<D>(d, at, corner.at)});
        }
    }
}

} // namespace

template <int D>
FaceArcs<D>::FaceArcs(const CutFaces<D>& cut, const GridPlanes<D>& planes, const DenseIndex<D>& index,
                      const std::vector<PlacedSolid<D>>& solids, bool with_chords)
    : planes_(planes), index_(index), solids_(solids),
      general_(std::make_unique<GeneralCut<D>>(cut, planes, index, solids, with_chords)), arcs_(1), with_chords_(with_chords)
{
}

template <int D>
const FaceLine& FaceArcs<D>::line(int fin) const
{
    return general_->line(fin);
}

template <int D>
FaceArcs<D>::~FaceArcs() = default;

template <int D>
std::span<const SquareArc> FaceArcs<D>::of(const Slab<D>& slab, const CutFace<D>& face)
{
    if (face.state == CutFace<D>::State::general) {
        const FaceDetail& detail = slab.details[face.detail];
        Square& square = general_->cut(face, detail, slab.facets);
        std::vector<SquareArc>& arcs = square.arcs;
        chords_.assign(square.chords.begin(), square.chords.end());
        for (BorderChord& chord : chords_)
            if (chord.solid >= 0)
                chord.solid = detail.images[chord.solid];
        for (SquareArc& arc : arcs) {
            arc.solid = detail.images[arc.solid];
            if constexpr (D == 3)
                for (ArcSegment& segment : arc.segments)
                    if (segment.fin >= 0)
                        segment.surface = surface_of_fin(general_->line(segment.fin).edge);
        }
        return arcs;
    }
    const PlacedSolid<D>& placed = solids_[face.image];
    std::visit(
        [&](const auto& kind) {
            if constexpr (!std::is_same_v<std::decay_t<decltype(kind)>, FacetKind<D>>)
                find_simple(placed, kind, face);
        },
        placed.kind);
    return arcs_;
}

template <int D>
template <class Kind>
void FaceArcs<D>::find_simple(const PlacedSolid<D>& placed, const Kind& kind, const CutFace<D>& face)
{
    const Index<D> f = index_.index(face.id);
    const int d = face.axis;
    if (face.image != image_ || d != axis_) {
        image_ = face.image;
        axis_ = d;
        sections_.clear();
        sections_.resize(D == 3 ? index_.size[d] : 1);
    }
    std::unique_ptr<Section>& section = sections_[D == 3 ? f[d] - index_.low[d] : 0];
    if (!section)
        section = std::make_unique<Section>(kind.section(d, plane_of(planes_, d, f)));
    const auto on_edge = [&](int e) {
        const int axis = edge_axis<D>(d, e);
        const Index<D> start = edge_start<D>(d, f, e);
        const Vec<D> x = place_of(planes_, start);
        const int low_corner = e < 2 ? e : (e + 1) % 4;
        const bool covered = (face.open >> low_corner & 1) == placed.inverse;
        Vec<2> at = in_plane<D>(d, x);
        at[e % 2] = crossing(kind.line(axis, x), covered, x[axis], planes_.place[axis][start[axis] + 1]);
        return at;
    };
    int first = 0; // the first open corner
    while (!(face.open >> first & 1) || (face.open >> ((first + 3) & 3) & 1))
        ++first;
    int last = first;
    while (face.open >> ((last + 1) & 3) & 1)
        ++last;
    SquareArc& arc = arcs_[0];
    arc.solid = face.image;
    arc.piece = 0;
    arc.from = on_edge(last & 3);
    arc.to = on_edge((first + 3) & 3);
    arc.segments.clear();
    if (section->empty())
        arc.segments.push_back({arc.from, arc.to, nullptr, -1, false, false});
    else if (placed.inverse)
        add_walk(arc, *section, arc.to, arc.from, false, true);
    else
        add_walk(arc, *section, arc.from, arc.to, false, false);
    if (!with_chords_)
        return;
    chords_.clear();
    Vec<2> here = arc.to;
    const auto add = [&](const Vec<2>& to, int solid) {
        chords_.push_back({0, here, to, solid, -1});
        here = to;
    };
    for (int c = first; c <= last; ++c)
        add(in_plane<D>(d, place_of(planes_, vertex_of_corner<D>(d, f, c & 3))), -1);
    add(arc.from, -1);
    for (const ArcSegment& segment : arc.segments)
        for (int k = 1, n = segment.chords(); k <= n; ++k)
            add(k < n ? segment.at(static_cast<double>(k) / n) : segment.to, face.image);
}

template class FaceArcs<2>;
template class FaceArcs<3>;

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
            std::visit(
                [&](const auto& kind) {
                    using Kind = std::decay_t<decltype(kind)>;
                    if constexpr (!std::is_same_v<Kind, FacetKind<D>>)
                        Marking<D, Kind>(planes, index, solids[k], kind, static_cast<int>(k), cut, slab).mark();
                    else
                        slab.facets[k] = FacetMarking<D>(planes, index, solids[k], kind, static_cast<int>(k), cut, slab).mark();
                },
                solids[k].kind);
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
