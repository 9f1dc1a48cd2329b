#include "gapflow/complex/seen_volume.hpp"

#include <algorithm>
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
            if (low >= at)
                continue;
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

/// Sum of the walls' area vectors of each solid, times the way to them from its reference point, by components.
template <int D>
std::vector<Vec<D>> wall_moments(const GridPlanes<D>& planes, const std::vector<Vec<D>>& centre, const Vec<D>& period,
                                 const Complex<D>& complex)
{
    std::vector<Vec<D>> moments(centre.size(), Vec<D>::Zero());
    for (int p = 0; p < complex.parts(); ++p) {
        const Index<D> c = complex.cell_of_part(p);
        Vec<D> x;
        for (int d = 0; d < D; ++d)
            x[d] = 0.5 * (planes.place[d][c[d]] + planes.place[d][c[d] + 1]);
        for (const WallPatch<D>& patch : complex.patches_of(p))
            for (int d = 0; d < D; ++d) {
                double way = x[d] - centre[patch.solid][d];
                if (period[d] > 0)
                    way -= period[d] * std::round(way / period[d]);
                moments[patch.solid][d] += patch.area[d] * way;
            }
    }
    return moments;
}

/// The share of a solid that is in the fluid: what the planes see of it through its walls, over what they see of all of it.
template <int D>
double wetted_share(const PlacedSolid<D>& solid, const GridPlanes<D>& planes, const Vec<D>& period, const Vec<D>& seen,
                    const Vec<D>& moment)
{
    double within = 0, all = 0;
    for (int d = 0; d < D; ++d) {
        const double reach = std::max(solid.high[d] - solid.reference[d], solid.reference[d] - solid.low[d]) + 1;
        if (period[d] > 0 && 2 * reach > period[d])
            continue; // the walls of two images are not told apart
        all += seen[d];
        within += (solid.inverse ? 1 : -1) * moment[d];
        for (int end = 0; end < 2 && period[d] == 0; ++end) { // the solid's sections with the sides
            const double side = end ? planes.place[d].back() : planes.place[d].front();
            within += (end ? 1 : -1) * (side - solid.reference[d]) * sum_of_sections(solid, d, {side, side});
        }
    }
    return all > 0 ? std::clamp(within / all, 0.0, 1.0) : 1.0;
}

} // namespace

template <int D>
double seen_volume(const PlacedSolid<D>& solid, int d)
{
    constexpr double all = std::numeric_limits<double>::infinity();
    return sum_of_sections(solid, d, {std::ceil(solid.low[d]) - 1, all});
}

template <int D>
std::vector<Vec<D>> seen_excess(const Grid<D>& grid, const GridPlanes<D>& planes, std::span<const Solid<D>> solids,
                                const std::vector<PlacedSolid<D>>& placed, const Complex<D>& complex)
{
    std::vector<const PlacedSolid<D>*> first(solids.size(), nullptr); // of each solid's images: all see the same
    std::vector<Vec<D>> centre(solids.size(), Vec<D>::Zero());
    for (const PlacedSolid<D>& image : placed)
        if (!first[image.solid]) {
            first[image.solid] = &image;
            centre[image.solid] = image.reference;
        }
    Vec<D> period = Vec<D>::Zero();
    for (int d = 0; d < D; ++d)
        if (grid.periodic(d))
            period[d] = planes.place[d].back() - planes.place[d].front();
    const std::vector<Vec<D>> moments = wall_moments<D>(planes, centre, period, complex);
    std::vector<Vec<D>> excess(solids.size(), Vec<D>::Zero());
    for (std::size_t s = 0; s < solids.size(); ++s) {
        const double volume = solids[s].shape.shape().mass_properties().volume / std::pow(planes.dx, D);
        if (!first[s] || !std::isfinite(volume))
            continue;
        Vec<D> seen;
        for (int d = 0; d < D; ++d)
            seen[d] = seen_volume(*first[s], d);
        const double share = wetted_share<D>(*first[s], planes, period, seen, moments[s]);
        excess[s] = (first[s]->inverse ? -share : share) * (seen - Vec<D>::Constant(volume));
    }
    return excess;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template double seen_volume(const PlacedSolid<D>&, int);                                                                   \
    template std::vector<Vec<D>> seen_excess(const Grid<D>&, const GridPlanes<D>&, std::span<const Solid<D>>,                  \
                                             const std::vector<PlacedSolid<D>>&, const Complex<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
