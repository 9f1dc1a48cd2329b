#include "gapflow/complex/seen_volume.hpp"

#include "gapflow/complex/surface_rate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace gapflow {
namespace {

/// Planes a cell apart.
struct Planes {
    double first, last;
    /// The first that is not below x.
    double from(double x) const { return x > first ? first + std::ceil(x - first) : first; }
};

template <int D>
double sum_of_sections(const BallKind<D>& kind, int d, const Planes& planes)
{
    double sum = 0;
    const double end = std::min(planes.last, kind.centre[d] + kind.radius);
    for (double at = planes.from(kind.centre[d] - kind.radius); at <= end; ++at) {
        const double r2 = kind.radius * kind.radius - (at - kind.centre[d]) * (at - kind.centre[d]);
        sum += r2 > 0 ? (D == 2 ? 2 * std::sqrt(r2) : std::numbers::pi * r2) : 0.0;
    }
    return sum;
}

template <int D, class Kind>
double sum_of_sections(const Kind& kind, const Vec<D>& low, const Vec<D>& high, int d, const Planes& planes)
{
    double sum = 0;
    const double end = std::min(planes.last, high[d]);
    for (double at = planes.from(low[d]); at <= end; ++at)
        if constexpr (D == 2) {
            const Stretch s = kind.line(1 - d, at * unit<2>(d));
            sum += s.empty() ? 0.0 : s.to - s.from;
        } else if (const Section section = kind.section(d, at); !section.empty())
            sum -= section.whole().area; // clockwise
    return sum;
}

template <int D>
double sum_of_sections(const FacetKind<D>& kind, int d, const Planes& planes)
{
    // The border of each section, facet by facet: 1/2 x cross dx; in 2D its ends.
    double sum = 0;
    for (const auto& element : kind.surface->elements) {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const int i : element) {
            low = std::min(low, kind.vertices[i][d]);
            high = std::max(high, kind.vertices[i][d]);
        }
        for (double at = planes.from(low); at < high && at <= planes.last; ++at) { // a vertex in the plane lies below it
            std::array<Vec<D>, 2> up_down; // where the facet's border goes up through the plane and where down
            for (int k = 0; k < D; ++k) {
                const Vec<D>&a = kind.vertices[element[k]], &b = kind.vertices[element[(k + 1) % D]];
                const bool above_a = a[d] > at, above_b = b[d] > at;
                if (above_a == above_b)
                    continue;
                const double t = (at - a[d]) / (b[d] - a[d]);
                const Vec<D> x = a + t * (b - a);
                if constexpr (D == 2) {
                    // The solid lies on the left of the segment from a to b: upwards along x its interior has smaller y.
                    sum += (d == 0 ? 1 : -1) * (above_b ? -1 : 1) * x[1 - d];
                    break;
                } else
                    up_down[above_b ? 0 : 1] = x;
            }
            if constexpr (D == 3) {
                const int u = (d + 1) % 3, v = (d + 2) % 3;
                sum += 0.5 * (up_down[1][u] * up_down[0][v] - up_down[1][v] * up_down[0][u]);
            }
        }
    }
    return sum;
}

/// Calls f(at) for the planes between two places.
template <class F>
void for_each_plane(double low, double high, const Planes& planes, F&& f)
{
    const double end = std::min(planes.last, high);
    for (double at = planes.from(low); at <= end; ++at)
        f(at);
}

template <class Kind>
Twist<2> rate_of_sections(const Kind& kind, const PlacedSolid<2>& solid, int d, const Planes& planes)
{
    PieceRate<2> rate{solid.solid};
    for_each_plane(solid.low[d], solid.high[d], planes, [&](double at) {
        const int axis = 1 - d;
        Vec<2> x = at * unit<2>(d);
        const Stretch s = kind.line(axis, x);
        if (s.empty())
            return;
        for (const auto& [place, sign] : {std::pair{s.from, -1.0}, {s.to, 1.0}}) {
            x[axis] = place;
            add_end(axis, sign, x, 0, solid.reference, kind.normal_at(x), rate);
        }
    });
    return rate.area;
}

template <class Kind>
Twist<3> rate_of_sections(const Kind& kind, const PlacedSolid<3>& solid, int d, const Planes& planes)
{
    PieceRate<3> rate{solid.solid};
    for_each_plane(solid.low[d], solid.high[d], planes, [&](double at) {
        const Section section = kind.section(d, at);
        if (section.empty())
            return;
        for (int k = 0; k < section.count; ++k) {
            const Curve& c = section.curve[k];
            ArcSegment segment{section.corner[k], section.corner[(k + 1) % section.count],
                               c.kind == Curve::Kind::ellipse ? &c : nullptr, c.surface};
            if (section.single()) {
                segment.from = segment.to = c.centre + c.semi1 * c.e1;
                segment.whole = true;
            }
            add_segment({d, at, section.inside}, solid.reference, segment,
                        kind.slope(d, at, segment.surface, Vec<2>(0.5 * (segment.from + segment.to))), rate);
        }
    });
    return -rate.area;
}

/// By the facets' normals, out of what is enclosed.
template <int D>
Twist<D> rate_of_facets(const FacetKind<D>& kind, const PlacedSolid<D>& solid, int d, const Planes& planes)
{
    PieceRate<D> rate{solid.solid};
    for (std::size_t facet = 0; facet < kind.surface->elements.size(); ++facet) {
        const auto& element = kind.surface->elements[facet];
        std::array<double, D> place;
        for (int k = 0; k < D; ++k)
            place[k] = kind.vertices[element[k]][d];
        const auto [low, high] = std::minmax_element(place.begin(), place.end());
        const Vec<D> normal = facet_normal(kind, static_cast<int>(facet));
        for_each_plane(*low, *high, planes, [&](double at) {
            if (*low > at || *high <= at) // a vertex in the plane lies below it
                return;
            InlineVector<Vec<D>, 2> cut;
            for (int k = 0; k < (D == 2 ? 1 : D); ++k) {
                const Vec<D>&a = kind.vertices[element[k]], &b = kind.vertices[element[(k + 1) % D]];
                if ((a[d] > at) != (b[d] > at))
                    cut.push_back(a + (at - a[d]) / (b[d] - a[d]) * (b - a));
            }
            if constexpr (D == 2)
                add_end(1 - d, normal[1 - d] > 0 ? 1 : -1, cut[0], 0, solid.reference, normal, rate);
            else {
                const int u = (d + 1) % 3, v = (d + 2) % 3;
                Vec<2> from(cut[0][u], cut[0][v]), to(cut[1][u], cut[1][v]);
                if ((to - from)[0] * normal[v] < (to - from)[1] * normal[u])
                    std::swap(from, to);
                add_segment({d, at, from}, solid.reference, {from, to}, flat_slope(normal, d), rate);
            }
        });
    }
    return D == 2 ? rate.area : Twist<D>(-rate.area);
}

/// Sum of the areas of a surface's sections.
template <int D>
double sum_of_sections(const PlacedSolid<D>& solid, int d, const Planes& planes)
{
    return std::visit(
        [&](const auto& kind) -> double {
            using Kind = std::decay_t<decltype(kind)>;
            if constexpr (std::is_same_v<Kind, BallKind<D>>)
                return sum_of_sections(kind, d, planes);
            else if constexpr (std::is_same_v<Kind, FacetKind<D>>)
                return std::abs(sum_of_sections(kind, d, planes));
            else
                return sum_of_sections<D>(kind, solid.low, solid.high, d, planes);
        },
        solid.kind);
}

/// Its derivative by the solid's twist.
template <int D>
Twist<D> rate_of_sections(const PlacedSolid<D>& solid, int d, const Planes& planes)
{
    return std::visit(
        [&](const auto& kind) -> Twist<D> {
            if constexpr (std::is_same_v<std::decay_t<decltype(kind)>, FacetKind<D>>)
                return (sum_of_sections(kind, d, planes) < 0 ? -1 : 1) * rate_of_facets(kind, solid, d, planes);
            else
                return rate_of_sections(kind, solid, d, planes);
        },
        solid.kind);
}

template <int D>
double period_of(const Grid<D>& grid, const GridPlanes<D>& planes, int d)
{
    return grid.periodic(d) ? planes.place[d].back() - planes.place[d].front() : 0.0;
}

/// Of a solid's walls: sum of the area vectors, and of these times the way to them from its reference point, by components.
template <int D>
struct WallSums {
    Vec<D> area = Vec<D>::Zero(), moment = Vec<D>::Zero();
};

template <int D>
std::vector<WallSums<D>> wall_sums(const Grid<D>& grid, const GridPlanes<D>& planes, const std::vector<Vec<D>>& reference,
                                   const Complex<D>& complex)
{
    std::vector<WallSums<D>> sums(reference.size());
    for (int p = 0; p < complex.parts(); ++p)
        for (const WallPatch<D>& patch : complex.patches_of(p)) {
            if (!grid.owns(complex.cell_of_part(p)))
                break;
            sums[patch.solid].area += patch.area;
            sums[patch.solid].moment +=
                patch.area.cwiseProduct(way_from<D>(grid, planes, reference[patch.solid], complex.cell_of_part(p)));
        }
    if (!sums.empty())
        grid.comm().sum(std::span<double>(sums.data()->area.data(), 2 * D * sums.size()));
    return sums;
}

/// What the planes see of a solid: of all of it, and through its walls.
template <int D>
struct Seen {
    Vec<D> volume = Vec<D>::Zero();
    Vec<D> counts = Vec<D>::Zero(); ///< 0: of an axis along which the walls of two images are not told apart
    double within = 0, all = 0;     ///< sums of the axes that count

    double share() const { return all > 0 ? std::clamp(within / all, 0.0, 1.0) : 1.0; }
};

constexpr double everywhere = std::numeric_limits<double>::infinity();

template <int D>
Seen<D> seen_of(const PlacedSolid<D>& solid, const Grid<D>& grid, const GridPlanes<D>& planes, const WallSums<D>& walls)
{
    Seen<D> seen;
    for (int d = 0; d < D; ++d) {
        seen.volume[d] = seen_volume(solid, d);
        const double reach = std::max(solid.high[d] - solid.reference[d], solid.reference[d] - solid.low[d]) + 1;
        if (grid.periodic(d) && 2 * reach > period_of(grid, planes, d))
            continue;
        seen.counts[d] = 1;
        seen.all += seen.volume[d];
        seen.within += (solid.inverse ? 1 : -1) * walls.moment[d];
        for (int end = 0; end < 2 && !grid.periodic(d); ++end) { // the solid's sections with the sides
            const double side = end ? planes.place[d].back() : planes.place[d].front();
            seen.within += (end ? 1 : -1) * (side - solid.reference[d]) * sum_of_sections(solid, d, {side, side});
        }
    }
    return seen;
}

/// By the solid's twist at fixed area vectors of its walls: what it sees of itself, and through the walls.
template <int D>
SeenRate<D> rate_of(const PlacedSolid<D>& solid, const Seen<D>& seen, double volume, const Grid<D>& grid,
                    const GridPlanes<D>& planes, const WallSums<D>& walls)
{
    SeenRate<D> result;
    result.reference = solid.reference;
    Twist<D> within = Twist<D>::Zero(), all = Twist<D>::Zero();
    const double sign = solid.inverse ? -1 : 1;
    for (int d = 0; d < D; ++d) {
        const Twist<D> own = rate_of_sections(solid, d, {std::ceil(solid.low[d]) - 1, everywhere});
        result.rate.row(d) = sign * seen.share() * own.transpose();
        if (!(seen.counts[d] > 0))
            continue;
        all += own;
        within[d] += sign * walls.area[d];
        for (int end = 0; end < 2 && !grid.periodic(d); ++end) {
            const double side = end ? planes.place[d].back() : planes.place[d].front(), out = end ? 1 : -1;
            within[d] -= out * sum_of_sections(solid, d, {side, side});
            within += out * (side - solid.reference[d]) * rate_of_sections(solid, d, {side, side});
        }
    }
    if (seen.within > 0 && seen.within < seen.all) {
        const Vec<D> excess = sign * (seen.volume - Vec<D>::Constant(volume));
        result.rate += excess * ((within - seen.share() * all) / seen.all).transpose();
        result.by_walls = -sign / seen.all * excess;
        result.counts = seen.counts;
    }
    return result;
}

/// Which of the items that are not null on this rank are null on all lower ones.
template <class T>
std::vector<char> held_first(const Communicator& comm, const std::vector<const T*>& items)
{
    std::vector<double> rank;
    for (const T* item : items)
        rank.push_back(item ? -comm.rank() : -comm.size());
    comm.max(rank);
    std::vector<char> own;
    for (std::size_t i = 0; i < items.size(); ++i)
        own.push_back(items[i] && rank[i] == -comm.rank());
    return own;
}

} // namespace

template <int D>
Vec<D> way_from(const Grid<D>& grid, const GridPlanes<D>& planes, const Vec<D>& reference, const Index<D>& cell)
{
    Vec<D> way;
    for (int d = 0; d < D; ++d) {
        way[d] = 0.5 * (planes.place[d][cell[d]] + planes.place[d][cell[d] + 1]) - reference[d];
        if (const double period = period_of(grid, planes, d); period > 0)
            way[d] -= period * std::round(way[d] / period);
    }
    return way;
}

template <int D>
double seen_volume(const PlacedSolid<D>& solid, int d)
{
    return sum_of_sections(solid, d, {std::ceil(solid.low[d]) - 1, everywhere});
}

template <int D>
std::vector<Vec<D>> seen_excess(const Grid<D>& grid, const GridPlanes<D>& planes, std::span<const Solid<D>> solids,
                                const std::vector<PlacedSolid<D>>& placed, const Complex<D>& complex,
                                FaceDerivatives<D>* derivatives)
{
    std::vector<const PlacedSolid<D>*> first(solids.size(), nullptr); // of each solid's images: all see the same
    std::vector<Vec<D>> reference(solids.size(), Vec<D>::Zero());
    for (const PlacedSolid<D>& image : placed)
        if (!first[image.solid]) {
            first[image.solid] = &image;
            reference[image.solid] = image.reference;
        }
    const std::vector<WallSums<D>> walls = wall_sums<D>(grid, planes, reference, complex);
    const std::vector<char> own = held_first(grid.comm(), first);
    std::vector<Vec<D>> excess(solids.size(), Vec<D>::Zero());
    if (derivatives)
        derivatives->seen.resize(solids.size());
    for (std::size_t s = 0; s < solids.size(); ++s) {
        const double volume = solids[s].shape.shape().mass_properties().volume / std::pow(planes.dx, D);
        if (!own[s] || !std::isfinite(volume))
            continue;
        const Seen<D> seen = seen_of(*first[s], grid, planes, walls[s]);
        excess[s] = (first[s]->inverse ? -1 : 1) * seen.share() * (seen.volume - Vec<D>::Constant(volume));
        if (derivatives)
            derivatives->seen[s] = rate_of(*first[s], seen, volume, grid, planes, walls[s]);
    }
    if (!excess.empty())
        grid.comm().sum(std::span<double>(excess.data()->data(), D * excess.size()));
    return excess;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template double seen_volume(const PlacedSolid<D>&, int);                                                                   \
    template Vec<D> way_from(const Grid<D>&, const GridPlanes<D>&, const Vec<D>&, const Index<D>&);                            \
    template std::vector<Vec<D>> seen_excess(const Grid<D>&, const GridPlanes<D>&, std::span<const Solid<D>>,                  \
                                             const std::vector<PlacedSolid<D>>&, const Complex<D>&, FaceDerivatives<D>*);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
