// Compiled without contraction of products and sums, so that balls lie in the same places on every machine.
#include "gapflow/scene/crowd_placing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace gapflow {

namespace {

constexpr int most_tries = 2000;  // of one body
constexpr int most_passes = 4000; // that push balls apart
constexpr int shuffles = 400;     // sweeps of single moves afterwards
constexpr int jitter_tries = 100; // of one body of a lattice
constexpr double slack = 1e-3;    // over the mean radius: balls are pushed further apart than asked for, so that pushing ends

template <int D>
Rotation<D> random_rotation(RandomNumbers& random)
{
    if constexpr (D == 2) {
        return Rotation<2>(random.uniform(-std::numbers::pi, std::numbers::pi));
    } else {
        const std::array<double, 4> q = random.quaternion();
        return Rotation<3>(q[0], q[1], q[2], q[3]);
    }
}

// A ball needs no turn.
template <int D>
Rotation<D> rotation_for(const CrowdPlan<D>& plan, RandomNumbers& random)
{
    if (plan.rotation)
        return *plan.rotation;
    return plan.hull.ball() ? Rotation<D>::Identity() : random_rotation<D>(random);
}

// Uniform in the box around the part of the region that centres of balls of a radius can be in.
template <int D>
Vec<D> random_place(const Region<D>& region, double radius, RandomNumbers& random)
{
    Vec<D> at;
    for (int axis = 0; axis < D; ++axis) {
        const double margin = region.endless[axis] ? 0 : std::min(radius, 0.5 * (region.high[axis] - region.low[axis]));
        at[axis] = random.uniform(region.low[axis] + margin, region.high[axis] - margin);
    }
    return at;
}

// Pushes the room's bodies from `first` on apart, all balls; returns whether all keep their distances.
template <int D>
bool push_apart(const CrowdPlan<D>& plan, CrowdRoom<D>& room, int first)
{
    double mean = 0;
    for (int i = first; i < room.count(); ++i)
        mean += room.hull(i).radius / (room.count() - first);
    const double extra = slack * mean, wanted = plan.spacing + extra;
    std::vector<int> others;
    for (int pass = 0; pass < most_passes; ++pass) {
        double deepest = 0;
        for (int i = first; i < room.count(); ++i) {
            const double radius = room.hull(i).radius;
            Vec<D> at = room.place(i);
            others.clear();
            room.near(at, [&](int j) {
                if (j > i || j < first)
                    others.push_back(j);
            });
            for (const int j : others) {
                const Vec<D> shift = room.shift_from(j, radius, wanted, at);
                const double depth = shift.norm();
                if (!(depth > 0))
                    continue;
                deepest = std::max(deepest, depth);
                const double share = j < first ? 1 : 0.5;
                at += share * shift;
                if (j >= first)
                    room.move(j, room.wrapped(room.place(j) - share * shift));
            }
            deepest = std::max(deepest, room.push_out(radius, wanted, at));
            const Vec<D> inside = plan.region.inside(radius, at);
            deepest = std::max(deepest, (inside - at).norm());
            room.move(i, room.wrapped(inside));
        }
        if (deepest > 0.5 * extra)
            continue;
        bool good = true;
        for (int i = first; good && i < room.count(); ++i)
            good = plan.region.holds(room.hull(i), room.place(i)) && room.free(room.hull(i), room.place(i), i);
        if (good)
            return true;
    }
    return false;
}

template <int D>
void shuffle(const CrowdPlan<D>& plan, CrowdRoom<D>& room, int first, RandomNumbers& random)
{
    double length = 0.02 * plan.hull.radius; // found so that two moves in five are free
    for (int sweep = 0; sweep < shuffles; ++sweep) {
        int moved = 0;
        for (int i = first; i < room.count(); ++i) {
            Vec<D> to = room.place(i);
            for (int axis = 0; axis < D; ++axis)
                to[axis] += random.uniform(-length, length);
            to = room.wrapped(to);
            if (plan.region.holds(room.hull(i), to) && room.free(room.hull(i), to, i)) {
                room.move(i, to);
                ++moved;
            }
        }
        length *= 5 * moved > 2 * (room.count() - first) ? 1.1 : 0.9;
    }
}

template <int D>
bool place_dense_balls(const CrowdPlan<D>& plan, CrowdRoom<D>& room, int first, const std::vector<int>& order,
                       RandomNumbers& random)
{
    const Mat<D> unturned = Mat<D>::Identity();
    for (std::size_t k = static_cast<std::size_t>(room.count() - first); k < order.size(); ++k) {
        const Hull<D> hull = plan.hull.turned(unturned, plan.factors[static_cast<std::size_t>(order[k])]);
        const Vec<D> at = plan.region.inside(hull.radius, random_place(plan.region, hull.radius, random));
        room.add(hull, room.wrapped(at));
    }
    if (!push_apart(plan, room, first))
        return false;
    shuffle(plan, room, first, random);
    return true;
}

} // namespace

template <int D>
CrowdPlaces<D> place_at_random(const CrowdPlan<D>& plan, CrowdRoom<D>& room, RandomNumbers& random)
{
    const int first = room.count(), number = static_cast<int>(plan.factors.size());
    const auto factor = [&](int i) { return plan.factors[static_cast<std::size_t>(i)]; };
    std::vector<int> order(plan.factors.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return factor(a) > factor(b); });

    CrowdPlaces<D> result;
    result.places.resize(plan.factors.size());
    const auto place_of = [&](int i) -> CrowdPlace<D>& { return result.places[static_cast<std::size_t>(i)]; };
    for (; result.found < number; ++result.found) {
        const int i = order[static_cast<std::size_t>(result.found)];
        bool placed = false;
        for (int tries = 0; tries < most_tries && !placed; ++tries) {
            const Rotation<D> rotation = rotation_for(plan, random);
            Hull<D> hull = plan.hull.turned(rotation.toRotationMatrix(), factor(i));
            const Vec<D> at = room.wrapped(random_place(plan.region, hull.radius, random));
            placed = plan.region.holds(hull, at) && room.free(hull, at);
            if (placed) {
                place_of(i) = {at, rotation};
                room.add(std::move(hull), at);
            }
        }
        if (!placed)
            break;
    }
    if (result.found == number || result.found == 0 || !plan.hull.ball())
        return result;
    const int inserted = result.found;
    for (int k = inserted; k < number; ++k)
        place_of(order[static_cast<std::size_t>(k)]).rotation = rotation_for(plan, random);
    if (!place_dense_balls(plan, room, first, order, random))
        return result;
    for (int k = 0; k < number; ++k)
        place_of(order[static_cast<std::size_t>(k)]).centre = room.place(first + k);
    result.found = number;
    return result;
}

template <int D>
CrowdPlaces<D> place_on_lattice(const CrowdPlan<D>& plan, CrowdRoom<D>& room, RandomNumbers& random)
{
    const int first = room.count();
    const auto number = static_cast<long>(plan.factors.size());
    const Vec<D> size = plan.region.high - plan.region.low;
    Index<D> along = Index<D>::Ones();
    const auto sites = [&] {
        long product = 1;
        for (int axis = 0; axis < D; ++axis)
            product *= along[axis];
        return product;
    };
    const auto pitch = [&](int axis) { return size[axis] / along[axis]; };
    while (sites() < number) {
        int widest = 0;
        for (int axis = 1; axis < D; ++axis)
            if (pitch(axis) > pitch(widest))
                widest = axis;
        ++along[widest];
    }
    const long all = sites();
    CrowdPlaces<D> result;
    for (long site = 0; site < all; ++site) {
        if ((site + 1) * number / all == site * number / all)
            continue;
        Vec<D> at;
        long rest = site;
        for (int axis = 0; axis < D; ++axis) {
            at[axis] = plan.region.low[axis] + (static_cast<double>(rest % along[axis]) + 0.5) * pitch(axis);
            rest /= along[axis];
        }
        const Rotation<D> rotation = rotation_for(plan, random);
        Hull<D> hull = plan.hull.turned(rotation.toRotationMatrix(), plan.factors[result.places.size()]);
        result.places.push_back({at, rotation});
        if (!plan.region.holds(hull, at) || !room.free(hull, at))
            continue;
        ++result.found;
        room.add(std::move(hull), at);
    }
    if (result.found < number || plan.jitter == 0)
        return result;
    for (int i = first; i < room.count(); ++i) {
        CrowdPlace<D>& place = result.places[static_cast<std::size_t>(i - first)];
        const Vec<D> site = place.centre;
        for (int tries = 0; tries < jitter_tries; ++tries) {
            Vec<D> to;
            for (int axis = 0; axis < D; ++axis)
                to[axis] = site[axis] + plan.jitter * pitch(axis) * random.uniform(-1, 1);
            to = room.wrapped(to);
            if (!plan.region.holds(room.hull(i), to) || !room.free(room.hull(i), to, i))
                continue;
            room.move(i, to);
            place.centre = to;
            break;
        }
    }
    return result;
}

template CrowdPlaces<2> place_at_random<2>(const CrowdPlan<2>&, CrowdRoom<2>&, RandomNumbers&);
template CrowdPlaces<3> place_at_random<3>(const CrowdPlan<3>&, CrowdRoom<3>&, RandomNumbers&);
template CrowdPlaces<2> place_on_lattice<2>(const CrowdPlan<2>&, CrowdRoom<2>&, RandomNumbers&);
template CrowdPlaces<3> place_on_lattice<3>(const CrowdPlan<3>&, CrowdRoom<3>&, RandomNumbers&);

} // namespace gapflow
