#include "gapflow/complex/mark_faces.hpp"

#include "gapflow/complex/face_helpers.hpp"
#include "gapflow/complex/parameters.hpp"
#include "gapflow/grid/field.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <variant>

namespace gapflow {
namespace {

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
    for (const EdgeCell& way : sharp.way_cells)
        mark_around(way.cell);
    for (const RimPiece& piece : sharp.pieces)
        mark_around(piece.cell);
}

/// The cells into which the dividing lines of a solid's corners lead, in one slab.
void mark_lines(const DenseIndex<2>& index, const PlacedSolid<2>& solid, int image, CutFaces<2>& cut, Slab<2>& slab)
{
    for (const LineInCell& line : solid.lines) {
        const Index<2>& c = line.cell;
        if (c[0] < index.low[0] || c[0] >= index.high()[0] || c[1] < slab.begin || c[1] >= slab.end)
            continue;
        std::int32_t& number = cut.face[0][index(c)];
        if (number == Complex<2>::solid)
            continue;
        if (number < 0) {
            number = static_cast<std::int32_t>(slab.faces.size());
            slab.faces.push_back({index(c), 0, CutFace<2>::State::simple, 15, image});
        }
        make_general(slab, slab.faces[number]);
        auto& images = slab.details[slab.faces[number].detail].images;
        if (std::find(images.begin(), images.end(), image) == images.end())
            images.push_back(image);
    }
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
        else
            mark_lines(index_, solid_, image_, cut_, slab_);
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
                // One cell more: the surface's bounds are not rounded; and the cells into which corners and edges divide.
                constexpr int margin = 3;
                if (solid_.low[axis] > p[to] + margin || solid_.high[axis] < p[from] - margin)
                    return {};
                low_[axis] = std::clamp(planes_.cell_of(axis, solid_.low[axis]) - margin, from, to - 1);
                high_[axis] = std::clamp(planes_.cell_of(axis, solid_.high[axis]) + margin + 1, low_[axis] + 1, to);
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
        else
            mark_lines(index_, solid_, image_, cut_, slab_);
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

} // namespace

template <int D>
void mark_faces(const GridPlanes<D>& planes, const DenseIndex<D>& index, const PlacedSolid<D>& solid, int image,
                CutFaces<D>& cut, Slab<D>& slab)
{
    std::visit(
        [&](const auto& kind) {
            using Kind = std::decay_t<decltype(kind)>;
            if constexpr (!std::is_same_v<Kind, FacetKind<D>>)
                Marking<D, Kind>(planes, index, solid, kind, image, cut, slab).mark();
            else
                slab.facets[image] = FacetMarking<D>(planes, index, solid, kind, image, cut, slab).mark();
        },
        solid.kind);
}

template void mark_faces(const GridPlanes<2>&, const DenseIndex<2>&, const PlacedSolid<2>&, int, CutFaces<2>&, Slab<2>&);
template void mark_faces(const GridPlanes<3>&, const DenseIndex<3>&, const PlacedSolid<3>&, int, CutFaces<3>&, Slab<3>&);

} // namespace gapflow
