#include "gapflow/complex/seen_volume.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace gapflow {
namespace {

/// Volume of a solid between the planes of the grid, as the planes normal to d see it: the sum of its sections.
template <int D>
double seen_volume(const BallKind<D>& kind, int d)
{
    double sum = 0;
    for (double at = std::ceil(kind.centre[d] - kind.radius); at <= kind.centre[d] + kind.radius; ++at) {
        const double r2 = kind.radius * kind.radius - (at - kind.centre[d]) * (at - kind.centre[d]);
        sum += r2 > 0 ? (D == 2 ? 2 * std::sqrt(r2) : std::numbers::pi * r2) : 0.0;
    }
    return sum;
}

template <int D, class Kind>
double seen_volume_of_sections(const Kind& kind, const Vec<D>& low, const Vec<D>& high, int d)
{
    double sum = 0;
    for (double at = std::ceil(low[d]); at <= high[d]; ++at)
        if constexpr (D == 2) {
            const Stretch s = kind.line(1 - d, at * unit<2>(d));
            sum += s.empty() ? 0.0 : s.to - s.from;
        } else if (const Section section = kind.section(d, at); !section.empty())
            sum -= section.whole().area; // clockwise
    return sum;
}

template <int D>
double seen_volume(const FacetKind<D>& kind, int d)
{
    // The border of each section, facet by facet: 1/2 x cross dx; in 2D its ends.
    double sum = 0;
    for (const auto& element : kind.surface->elements) {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const int i : element) {
            low = std::min(low, kind.vertices[i][d]);
            high = std::max(high, kind.vertices[i][d]);
        }
        for (double at = std::ceil(low); at < high; ++at) { // a vertex in the plane lies below it
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

} // namespace

template <int D>
double seen_volume(const PlacedSolid<D>& solid, int d)
{
    return std::visit(
        [&](const auto& kind) -> double {
            using Kind = std::decay_t<decltype(kind)>;
            if constexpr (std::is_same_v<Kind, BallKind<D>>)
                return seen_volume(kind, d);
            else if constexpr (std::is_same_v<Kind, FacetKind<D>>)
                return std::abs(seen_volume(kind, d));
            else
                return seen_volume_of_sections<D>(kind, solid.low, solid.high, d);
        },
        solid.kind);
}

template double seen_volume(const PlacedSolid<2>&, int);
template double seen_volume(const PlacedSolid<3>&, int);

} // namespace gapflow
