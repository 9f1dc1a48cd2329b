#include "gapflow/complex/seen_volume.hpp"

#include "gapflow/complex/lever.hpp"
#include "gapflow/complex/seen_rotation.hpp"
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
SeenVolume<D> sum_of_sections(const BallKind<D>& kind, const PlacedSolid<D>& solid, int d, const Planes& planes)
{
    SeenVolume<D> sum;
    const double end = std::min(planes.last, kind.centre[d] + kind.radius);
    for (double at = planes.from(kind.centre[d] - kind.radius); at <= end; ++at) {
        const double r2 = kind.radius * kind.radius - (at - kind.centre[d]) * (at - kind.centre[d]);
        sum.volume += r2 > 0 ? (D == 2 ? 2 * std::sqrt(r2) : std::numbers::pi * r2) : 0.0;
    }
    sum.moment = sum.volume * (kind.centre - solid.reference);
    sum.moment[d] = 0;
    return sum;
}

template <int D, class Kind>
SeenVolume<D> sum_of_sections(const Kind& kind, const PlacedSolid<D>& solid, int d, const Planes& planes)
{
    SeenVolume<D> sum;
    const double end = std::min(planes.last, solid.high[d]);
    for (double at = planes.from(solid.low[d]); at <= end; ++at)
        if constexpr (D == 2) {
            const int axis = 1 - d;
            const Stretch s = kind.line(axis, at * unit<2>(d));
            if (s.empty())
                continue;
            sum.volume += s.to - s.from;
            sum.moment[axis] += (s.to - s.from) * (0.5 * (s.to + s.from) - solid.reference[axis]);
        } else if (const Section section = kind.section(d, at); !section.empty()) {
            const Bulge whole = section.whole(); // clockwise
            sum.volume -= whole.area;
            for (const auto& [k, axis] : {std::pair{0, u_axis<3>(d)}, {1, v_axis<3>(d)}})
                sum.moment[axis] -= whole.moment[k] - solid.reference[axis] * whole.area;
        }
    return sum;
}

template <int D>
SeenVolume<D> sum_of_sections(const FacetKind<D>& kind, const PlacedSolid<D>& solid, int d, const Planes& planes)
{
    // The border of each section, facet by facet: 1/2 x cross dx and 1/3 x of it; in 2D its ends.
    SeenVolume<D> sum;
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
                const Vec<D> x = a + t * (b - a) - solid.reference;
                if constexpr (D == 2) {
                    // The solid lies on the left of the segment from a to b: upwards along x its interior has smaller y.
                    const double sign = (d == 0 ? 1 : -1) * (above_b ? -1 : 1);
                    sum.volume += sign * x[1 - d];
                    sum.moment[1 - d] += 0.5 * sign * x[1 - d] * x[1 - d];
                    break;
                } else
                    up_down[above_b ? 0 : 1] = x;
            }
            if constexpr (D == 3) {
                const int u = u_axis<3>(d), v = v_axis<3>(d);
                const double area = 0.5 * (up_down[1][u] * up_down[0][v] - up_down[1][v] * up_down[0][u]);
                sum.volume += area;
                for (const int axis : {u, v})
                    sum.moment[axis] += area / 3 * (up_down[0][axis] + up_down[1][axis]);
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
void add_rates_of_convex(const Kind& kind, const PlacedSolid<2>& solid, int d, const Planes& planes, PieceRate<2>& rate)
{
    for_each_plane(solid.low[d], solid.high[d], planes, [&](double at) {
        const int axis = 1 - d;
        Vec<2> x = at * unit<2>(d);
        const Stretch s = kind.line(axis, x);
        if (s.empty())
            return;
        for (const auto& [place, sign] : {std::pair{s.from, 1.0}, {s.to, -1.0}}) {
            x[axis] = place;
            add_end(axis, sign, x, solid.reference[axis], solid.reference, kind.normal_at(x), rate);
        }
    });
}

/// The reference point in the plane.
Vec<2> reference_in(const PlacedSolid<3>& solid, int d)
{
    return {solid.reference[u_axis<3>(d)], solid.reference[v_axis<3>(d)]};
}

template <class Kind>
void add_rates_of_convex(const Kind& kind, const PlacedSolid<3>& solid, int d, const Planes& planes, PieceRate<3>& rate)
{
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
            add_segment({d, at, reference_in(solid, d)}, solid.reference, segment,
                        kind.slope(d, at, segment.surface, Vec<2>(0.5 * (segment.from + segment.to))), rate);
        }
    });
}

/// By the facets' normals, out of what is enclosed.
template <int D>
void add_rates_of_facets(const FacetKind<D>& kind, const PlacedSolid<D>& solid, int d, const Planes& planes, PieceRate<D>& rate)
{
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
                add_end(1 - d, normal[1 - d] > 0 ? -1 : 1, cut[0], solid.reference[1 - d], solid.reference, normal, rate);
            else {
                const int u = u_axis<3>(d), v = v_axis<3>(d);
                Vec<2> from(cut[0][u], cut[0][v]), to(cut[1][u], cut[1][v]);
                if ((to - from)[0] * normal[v] < (to - from)[1] * normal[u])
                    std::swap(from, to);
                add_segment({d, at, reference_in(solid, d)}, solid.reference, {from, to}, flat_slope(normal, d), rate);
            }
        });
    }
}

/// Sum of a surface's sections: what they enclose.
template <int D>
SeenVolume<D> sum_of_sections(const PlacedSolid<D>& solid, int d, const Planes& planes)
{
    const SeenVolume<D> sum = std::visit([&](const auto& kind) { return sum_of_sections(kind, solid, d, planes); }, solid.kind);
    return sum.volume < 0 ? -sum : sum; // facets of a surface that is inside out
}

/// Its derivative by the solid's twist.
template <int D>
SeenVolumeRate<D> rate_of_sections(const PlacedSolid<D>& solid, int d, const Planes& planes)
{
    return std::visit(
        [&](const auto& kind) -> SeenVolumeRate<D> {
            PieceRate<D> open{solid.solid}; // of what is open
            if constexpr (std::is_same_v<std::decay_t<decltype(kind)>, FacetKind<D>>) {
                add_rates_of_facets(kind, solid, d, planes, open);
                if (sum_of_sections(kind, solid, d, planes).volume < 0)
                    return {open.area, open.moment};
            } else
                add_rates_of_convex(kind, solid, d, planes, open);
            return {-open.area, -open.moment};
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

constexpr double everywhere = std::numeric_limits<double>::infinity();

/// The planes that a solid meets.
template <int D>
Planes all_planes(const PlacedSolid<D>& solid, int d)
{
    return {std::ceil(solid.low[d]) - 1, everywhere};
}

/// What the planes see of all of a solid, and the share of it that they see through its walls.
template <int D>
SeenSolid<D> seen_of(const PlacedSolid<D>& solid, const Solid<D>& of, const Grid<D>& grid, const GridPlanes<D>& planes,
                     const WallSums<D>& walls)
{
    const MassProperties<D> own = of.shape.shape().mass_properties();
    SeenSolid<D> seen;
    seen.sign = solid.inverse ? -1 : 1;
    seen.volume = own.volume / std::pow(planes.dx, D);
    const Vec<D> origin = planes.in_cells(of.shape.to_world(Vec<D>::Zero())), reference = planes.in_cells(of.centre);
    seen.centroid = of.shape.rotation() * own.centre / planes.dx;
    for (int d = 0; d < D; ++d)
        seen.centroid[d] += rounded(origin[d]) - rounded(reference[d]);
    seen.rotation = seen_rotation<D>(solid, solid.reference + seen.centroid);
    double within = 0;
    for (int d = 0; d < D; ++d) {
        seen.along[d] = sum_of_sections(solid, d, all_planes(solid, d));
        const double reach = std::max(solid.high[d] - solid.reference[d], solid.reference[d] - solid.low[d]) + 1;
        if (grid.periodic(d) && 2 * reach > period_of(grid, planes, d))
            continue;
        seen.counts[d] = 1;
        seen.all += seen.along[d].volume;
        within -= seen.sign * walls.moment[d];
        for (int end = 0; end < 2 && !grid.periodic(d); ++end) { // the solid's sections with the sides
            const double side = end ? planes.place[d].back() : planes.place[d].front();
            within += (end ? 1 : -1) * (side - solid.reference[d]) * sum_of_sections(solid, d, {side, side}).volume;
        }
    }
    seen.share = seen.all > 0 ? std::clamp(within / seen.all, 0.0, 1.0) : 1.0;
    return seen;
}

/// By the solid's twist; the share at fixed area vectors of its walls.
template <int D>
SeenRate<D> rate_of(const PlacedSolid<D>& solid, const SeenSolid<D>& seen, const Grid<D>& grid, const GridPlanes<D>& planes,
                    const WallSums<D>& walls)
{
    SeenRate<D> result;
    result.seen = seen;
    result.reference = solid.reference;
    result.rotation = seen_rotation_rate<D>(solid, solid.reference + seen.centroid);
    Twist<D> within = Twist<D>::Zero(), all = Twist<D>::Zero();
    for (int d = 0; d < D; ++d) {
        SeenVolumeRate<D>& along = result.along[d];
        along = rate_of_sections(solid, d, all_planes(solid, d));
        if (seen.counts[d] > 0) {
            all += along.volume;
            within[d] += seen.sign * walls.area[d];
            for (int end = 0; end < 2 && !grid.periodic(d); ++end) {
                const double side = end ? planes.place[d].back() : planes.place[d].front(), out = end ? 1 : -1;
                within[d] -= out * sum_of_sections(solid, d, {side, side}).volume;
                within += out * (side - solid.reference[d]) * rate_of_sections(solid, d, {side, side}).volume;
            }
        }
        for (int axis = 0; axis < D; ++axis) // about the reference point, which moves
            if (axis != d)
                along.moment(axis, axis) -= seen.along[d].volume;
    }
    if (seen.share > 0 && seen.share < 1) {
        result.share = (within - seen.share * all) / seen.all;
        result.share_by_walls = -seen.sign / seen.all * seen.counts;
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
TwistMatrix<D> seen_mass(const SeenSolid<D>& seen)
{
    TwistMatrix<D> sum = TwistMatrix<D>::Zero();
    for (int d = 0; d < D; ++d) {
        const Twist<D> own = lever<D>(unit<D>(d), seen.centroid);
        sum -= seen.volume * own * own.transpose();
        if (const double volume = seen.along[d].volume; volume > 0) {
            const Twist<D> flux = lever<D>(volume * unit<D>(d), seen.along[d].moment / volume);
            sum += 1 / volume * flux * flux.transpose();
        }
    }
    sum.template bottomRightCorner<spin_size<D>, spin_size<D>>() += seen.rotation;
    return seen.sign * seen.share * sum;
}

template <int D>
SeenEnergyRate<D> half_square_rate(const SeenRate<D>& rate, const Twist<D>& V)
{
    const SeenSolid<D>& seen = rate.seen;
    const Spin<D> omega = V.template tail<spin_size<D>>();
    const Vec<D> speed = velocity_at<D>(V, seen.centroid);
    // omega x (turn x centroid) . speed
    const Vec<D> by_centroid = -spin_velocity<D>(omega, speed);
    double sum = 0.5 * (omega.dot(seen.rotation * omega) - seen.volume * speed.squaredNorm());
    SeenEnergyRate<D> result;
    result.by_place.template tail<spin_size<D>>() = -seen.volume * moment<D>(seen.centroid, by_centroid);
    for (int k = 0; k < twist_size<D>; ++k)
        result.by_place[k] += 0.5 * omega.dot(rate.rotation[k] * omega);
    for (int d = 0; d < D; ++d) {
        const double volume = seen.along[d].volume;
        if (!(volume > 0))
            continue;
        const double mean = velocity_at<D>(V, seen.along[d].moment / volume)[d];
        sum += 0.5 * volume * mean * mean;
        result.by_place += mean * (V[d] - 0.5 * mean) * rate.along[d].volume -
                           mean * (rate.along[d].moment.transpose() * spin_velocity<D>(omega, unit<D>(d)));
    }
    result.by_place = seen.sign * (seen.share * result.by_place + sum * rate.share);
    result.by_walls = seen.sign * sum * rate.share_by_walls;
    return result;
}

template <int D>
std::vector<TwistMatrix<D>> seen_masses(const Grid<D>& grid, const GridPlanes<D>& planes, std::span<const Solid<D>> solids,
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
    std::vector<TwistMatrix<D>> masses(solids.size(), TwistMatrix<D>::Zero());
    if (derivatives)
        derivatives->seen.resize(solids.size());
    for (std::size_t s = 0; s < solids.size(); ++s) {
        if (!own[s] || !std::isfinite(solids[s].shape.shape().mass_properties().volume))
            continue;
        const SeenSolid<D> seen = seen_of(*first[s], solids[s], grid, planes, walls[s]);
        masses[s] = seen_mass(seen);
        if (derivatives)
            derivatives->seen[s] = rate_of(*first[s], seen, grid, planes, walls[s]);
    }
    if (!masses.empty())
        grid.comm().sum(std::span<double>(masses.data()->data(), masses.size() * masses.data()->size()));
    return masses;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template Vec<D> way_from(const Grid<D>&, const GridPlanes<D>&, const Vec<D>&, const Index<D>&);                            \
    template TwistMatrix<D> seen_mass(const SeenSolid<D>&);                                                                    \
    template SeenEnergyRate<D> half_square_rate(const SeenRate<D>&, const Twist<D>&);                                          \
    template std::vector<TwistMatrix<D>> seen_masses(const Grid<D>&, const GridPlanes<D>&, std::span<const Solid<D>>,          \
                                                     const std::vector<PlacedSolid<D>>&, const Complex<D>&,                    \
                                                     FaceDerivatives<D>*);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
