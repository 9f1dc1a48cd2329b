#include "gapflow/complex/seen_volume.hpp"

#include "gapflow/complex/lever.hpp"
#include "gapflow/complex/seen_rotation.hpp"
#include "gapflow/complex/seen_sections.hpp"
#include "gapflow/complex/surface_rate.hpp"
#include "gapflow/geometry/part_below.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gapflow {
namespace {

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

/// The planes of the domain that a solid meets.
template <int D>
Planes planes_within(const PlacedSolid<D>& solid, int d, const Window<D>& window)
{
    return {std::max(std::ceil(solid.low[d]) - 1, std::ceil(window.low[d])), window.high[d]};
}

/// Calls f(planes, weight) for the planes of the domain that a solid meets, and for those at the sides, which count by half.
template <int D, class F>
void for_planes_within(const PlacedSolid<D>& solid, int d, const Window<D>& window, F&& f)
{
    f(planes_within(solid, d, window), 1.0);
    for (int end = 0; end < 2; ++end)
        if (const double side = window.side(d, end); side == std::floor(side) && side >= solid.low[d] && side <= solid.high[d])
            f(Planes{side, side}, -0.5);
}

/// What of a solid lies beyond the sides of the domain: its volume, its first moment, and the rates of both, that of the moment at a fixed angle.
template <int D>
struct Beyond {
    double volume = 0;
    Vec<D> moment = Vec<D>::Zero();
    Twist<D> volume_rate = Twist<D>::Zero();
    Eigen::Matrix<double, D, twist_size<D>> moment_rate = Eigen::Matrix<double, D, twist_size<D>>::Zero();
};

/// `arm`: from its reference point to the origin of its shape. What lies beyond two sides counts twice.
template <int D>
Beyond<D> beyond_sides(const PlacedSolid<D>& solid, const Solid<D>& of, const GridPlanes<D>& planes, const Window<D>& window,
                       const Vec<D>& arm)
{
    Beyond<D> sum;
    const Mat<D>& turn = of.shape.rotation();
    for (int d = 0; d < D; ++d)
        for (int end = 0; end < 2; ++end) {
            const double side = window.side(d, end), out = end ? 1 : -1;
            if (!std::isfinite(side) || !(end ? solid.high[d] > side : solid.low[d] < side))
                continue;
            const Vec<D> inward = -out * turn.transpose() * unit<D>(d); // the part lies below it
            PartBelow<D> part = part_below(of.shape.shape(), {inward, -out * planes.dx * (side - solid.reference[d] - arm[d])});
            // In cells, from the reference point.
            const double sign = solid.inverse ? -1 : 1, volume = sign * part.volume / std::pow(planes.dx, D),
                         area = sign * part.section / std::pow(planes.dx, D - 1);
            sum.volume += volume;
            sum.moment += sign / std::pow(planes.dx, D + 1) * (turn * part.moment) + volume * arm;
            const Vec<D> first = sign / std::pow(planes.dx, D) * (turn * part.section_moment);
            const Mat<D> second = sign / std::pow(planes.dx, D + 1) * (turn * part.section_square * turn.transpose()) +
                                  first * arm.transpose() + arm * first.transpose() + area * arm * arm.transpose();
            const Vec<D> about = first + area * arm;
            // The section moves outwards with the speed of its points, by_turn . x of a turn.
            sum.volume_rate[d] += out * area;
            sum.moment_rate.col(d) += out * about;
            for (int k = 0; k < spin_size<D>; ++k) {
                Spin<D> spin = Spin<D>::Zero();
                spin[k] = 1;
                Vec<D> by_turn;
                for (int axis = 0; axis < D; ++axis)
                    by_turn[axis] = spin_velocity<D>(spin, unit<D>(axis))[d];
                sum.volume_rate[D + k] += out * by_turn.dot(about);
                sum.moment_rate.col(D + k) += out * second * by_turn;
            }
        }
    return sum;
}

/// What the planes see of a solid within the domain, and the share of it that they see through its walls. `rate`: of the volume and centroid; null: not wanted.
template <int D>
SeenSolid<D> seen_of(const PlacedSolid<D>& solid, const Solid<D>& of, const Grid<D>& grid, const GridPlanes<D>& planes,
                     const Window<D>& window, const WallSums<D>& walls, SeenRate<D>* rate)
{
    const MassProperties<D> own = of.shape.shape().mass_properties();
    SeenSolid<D> seen;
    seen.sign = solid.inverse ? -1 : 1;
    seen.volume = own.volume / std::pow(planes.dx, D);
    const Vec<D> origin = planes.in_cells(of.shape.to_world(Vec<D>::Zero())), reference = planes.in_cells(of.centre);
    seen.centroid = of.shape.rotation() * own.centre / planes.dx;
    Vec<D> arm;
    for (int d = 0; d < D; ++d)
        arm[d] = rounded(origin[d]) - rounded(reference[d]);
    seen.centroid += arm;
    if (!window.holds(solid)) {
        const Beyond<D> beyond = beyond_sides(solid, of, planes, window, arm);
        const double left = std::max(seen.volume - beyond.volume, 0.0);
        const bool ball =
            std::holds_alternative<BallKind<D>>(solid.kind); // moves fluid as its centre moves, wherever it is cut
        if (left > 0 && !ball)
            seen.centroid = (seen.volume * seen.centroid - beyond.moment) / left;
        seen.volume = left;
        if (left > 0 && rate) {
            rate->volume = -beyond.volume_rate;
            if (!ball)
                rate->centroid = (seen.centroid * beyond.volume_rate.transpose() - beyond.moment_rate) / left;
        }
    }
    seen.rotation = seen_rotation<D>(solid, solid.reference + seen.centroid, &window);
    double within = 0;
    for (int d = 0; d < D; ++d) {
        for_planes_within(solid, d, window, [&](const Planes& of_axis, double weight) {
            const SeenVolume<D> sum = sum_of_sections(solid, d, of_axis, window);
            seen.along[d].volume += weight * sum.volume;
            seen.along[d].moment += weight * sum.moment;
        });
        if (const auto* ball = std::get_if<BallKind<D>>(&solid.kind))
            seen.along[d].moment =
                seen.along[d].volume * (ball->centre - solid.reference - (ball->centre - solid.reference)[d] * unit<D>(d));
        const double reach = std::max(solid.high[d] - solid.reference[d], solid.reference[d] - solid.low[d]) + 1;
        if (grid.periodic(d) && 2 * reach > period_of(grid, planes, d))
            continue;
        seen.counts[d] = 1;
        seen.all += seen.along[d].volume;
        within -= seen.sign * walls.moment[d];
        for (int end = 0; end < 2 && !grid.periodic(d); ++end) { // the solid's sections with the sides
            const double side = window.side(d, end);
            within += (end ? 1 : -1) * (side - solid.reference[d]) * sum_of_sections(solid, d, {side, side}, window).volume;
        }
    }
    seen.share = seen.all > 0 ? std::clamp(within / seen.all, 0.0, 1.0) : 1.0;
    return seen;
}

/// By the solid's twist; the share at fixed area vectors of its walls. Completes `result`, which has the rates of what is within the domain.
template <int D>
void find_rate(const PlacedSolid<D>& solid, const SeenSolid<D>& seen, const Grid<D>& grid, const Window<D>& window,
               const WallSums<D>& walls, SeenRate<D>& result)
{
    result.seen = seen;
    result.reference = solid.reference;
    result.rotation = seen_rotation_rate<D>(solid, solid.reference + seen.centroid, &window, result.centroid);
    Twist<D> within = Twist<D>::Zero(), all = Twist<D>::Zero();
    for (int d = 0; d < D; ++d) {
        SeenVolumeRate<D>& along = result.along[d];
        for_planes_within(solid, d, window, [&](const Planes& of_axis, double weight) {
            const SeenVolumeRate<D> rate = rate_of_sections(solid, d, of_axis, window);
            along.volume += weight * rate.volume;
            along.moment += weight * rate.moment;
        });
        if (const auto* ball = std::get_if<BallKind<D>>(&solid.kind))
            along.moment = (ball->centre - solid.reference) * along.volume.transpose() +
                           seen.along[d].volume * rigid_rate<D>(ball->centre, solid.reference);
        if (seen.counts[d] > 0) {
            all += along.volume;
            within[d] += seen.sign * walls.area[d];
            for (int end = 0; end < 2 && !grid.periodic(d); ++end) {
                const double side = window.side(d, end), out = end ? 1 : -1;
                within[d] -= out * sum_of_sections(solid, d, {side, side}, window).volume;
                within += out * (side - solid.reference[d]) * rate_of_sections(solid, d, {side, side}, window).volume;
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
    result.by_place -= 0.5 * speed.squaredNorm() * rate.volume + seen.volume * (rate.centroid.transpose() * by_centroid);
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
    const Window<D> window(grid, planes);
    const std::vector<char> own = held_first(grid.comm(), first);
    std::vector<TwistMatrix<D>> masses(solids.size(), TwistMatrix<D>::Zero());
    if (derivatives)
        derivatives->seen.resize(solids.size());
    for (std::size_t s = 0; s < solids.size(); ++s) {
        if (!own[s] || !std::isfinite(solids[s].shape.shape().mass_properties().volume))
            continue;
        SeenRate<D>* rate = derivatives ? &derivatives->seen[s] : nullptr;
        const SeenSolid<D> seen = seen_of(*first[s], solids[s], grid, planes, window, walls[s], rate);
        masses[s] = seen_mass(seen);
        if (rate)
            find_rate(*first[s], seen, grid, window, walls[s], *rate);
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
