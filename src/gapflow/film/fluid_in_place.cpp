#include "gapflow/film/fluid_in_place.hpp"

#include "gapflow/core/sharing.hpp"
#include "gapflow/core/threads.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace gapflow {

namespace {

// A piece of a new element's volume that was in an old element.
struct Deposit {
    int element, old;
    double old_volume, new_volume, weight;
};

// Of an element on the master, whose surface does not change from step to step.
template <int D>
double measure_on_master(const FilmMesh<D>& mesh, int element)
{
    const std::array<int, D>& nodes = mesh.elements[element].nodes;
    if constexpr (D == 2)
        return (mesh.x[nodes[1]] - mesh.x[nodes[0]]).norm();
    else
        return 0.5 * (mesh.x[nodes[1]] - mesh.x[nodes[0]]).cross(mesh.x[nodes[2]] - mesh.x[nodes[0]]).norm();
}

// The old fluid that stays in the film, after one element has given to another what new elements take from the wrong one of the two.
template <int D>
struct Remains {
    double volume = 0;
    Vec<D> along = Vec<D>::Zero(); // mean velocity along the film
    Vec<D> given = Vec<D>::Zero(); // momentum beyond the element's own velocity times its volume
};

// New elements' points sample the old ones: of some they find more measure than these have, of others, next to them, less, down to none. The
// latter's fluid is in the former's new elements. What no element around has room for has left the film.
template <int D>
std::vector<Remains<D>> remaining(const FilmHistory<D>& old, const std::vector<double>& covered)
{
    const std::size_t n = covered.size();
    std::vector<double> room(n), lack(n), asked(n, 0.0); // measure
    std::vector<Remains<D>> result(n);
    std::vector<Vec<D>> momentum(n);
    for (std::size_t e = 0; e < n; ++e) {
        const int i = static_cast<int>(e);
        const double measure = old.measure_on_master(i);
        room[e] = std::max(covered[e] - measure, 0.0);
        lack[e] = std::max(measure - covered[e], 0.0);
        result[e].volume = old.volume(i) * std::min(1.0, covered[e] / measure);
        momentum[e] = result[e].volume * old.along(i);
    }
    struct Gift {
        int from, to;
        double measure;
    };
    std::vector<Gift> gifts;
    for (std::size_t e = 0; e < n; ++e) {
        if (lack[e] <= 0)
            continue;
        const std::vector<int> around = old.around(static_cast<int>(e));
        double open = 0;
        for (int to : around)
            open += room[to];
        for (int to : around)
            if (room[to] > 0) {
                gifts.push_back({static_cast<int>(e), to, lack[e] * room[to] / open});
                asked[to] += gifts.back().measure;
            }
    }
    for (const auto& [from, to, measure] : gifts) {
        const double share = measure * std::min(1.0, room[to] / asked[to]) / old.measure_on_master(from);
        result[to].volume += share * old.volume(from);
        momentum[to] += share * old.volume(from) * tangential<D>(old.along(from), old.normal(to));
    }
    for (std::size_t e = 0; e < n; ++e) {
        const Vec<D> own = old.along(static_cast<int>(e));
        result[e].along = result[e].volume > 0 ? Vec<D>(momentum[e] / result[e].volume) : own;
        result[e].given = momentum[e] - result[e].volume * own;
    }
    return result;
}

// Of the films of one pair, one after the other.
template <int D>
std::vector<FluidInPlace<D>> put_pair_in_place(const FilmNetwork<D>& network, const PlacedShape<D>& master,
                                               const FilmHistory<D>& old, const std::vector<int>& films)
{
    std::vector<FluidInPlace<D>> result;
    std::vector<double> taken(old.elements(), 0.0), covered(old.elements(), 0.0); // of each old element: volume, measure
    std::vector<std::pair<Deposit, Vec<D>>> deposits;                             // and its flux times its area
    for (int k : films) {
        const FilmMesh<D>& mesh = network.films[k].mesh;
        const int first = static_cast<int>(result.size());
        result.resize(result.size() + mesh.elements.size());
        std::vector<double> sum(mesh.elements.size(), 0.0);
        for (const FilmPoint<D>& q : mesh.points)
            sum[q.element] += q.weight * q.h;
        std::vector<double> on_master;
        for (std::size_t i = 0; i < mesh.elements.size(); ++i)
            on_master.push_back(measure_on_master(mesh, static_cast<int>(i)) / mesh.elements[i].measure);
        int hint = -1;
        for (const FilmPoint<D>& q : mesh.points) {
            const int e = first + q.element;
            const double scale = mesh.elements[q.element].volume / sum[q.element];
            const Vec<D> x = master.to_body(q.x);
            const double across = scale / mesh.elements[q.element].cosine();
            old.for_each_sample(x, hint, [&](const typename FilmHistory<D>::Sample& sample) {
                const double weight = sample.share * q.weight, new_volume = scale * weight * q.h;
                if (!sample.belongs) {
                    result[e].covered += new_volume;
                    return;
                }
                const double old_volume = across * weight * sample.h;
                taken[sample.element] += old_volume;
                covered[sample.element] += weight * on_master[q.element];
                deposits.push_back({{e, sample.element, old_volume, new_volume, across * weight}, sample.flux});
            });
        }
    }
    std::vector<Vec<D>> normal(result.size(), Vec<D>::Zero()); // of the old film at the new elements
    const std::vector<Remains<D>> remains = remaining(old, covered);
    for (const auto& [d, flux] : deposits) {
        const Remains<D>& from = remains[d.old];
        const double share = from.volume / taken[d.old];
        FluidInPlace<D>& place = result[d.element];
        place.volume += share * d.old_volume;
        const Vec<D> given = d.old_volume / taken[d.old] * from.given;
        place.world += share * d.weight * flux + given;
        place.velocity += share * d.weight * tangential<D>(flux, old.normal(d.old)) + given;
        place.reference += std::sqrt(share * d.old_volume * d.new_volume) * from.along;
        place.acceleration += d.new_volume * old.acceleration(d.old);
        place.increment += d.new_volume * old.increment(d.old);
        normal[d.element] += d.new_volume * old.normal(d.old);
    }
    const Spin<D> spin = old.spin();
    std::size_t at = 0;
    for (int k : films)
        for (const FilmElement<D>& e : network.films[k].mesh.elements) {
            FluidInPlace<D>& place = result[at];
            const double length = normal[at].norm();
            const Vec<D> n = master.rotation().transpose() * e.normal;
            const Vec<D> before = length > 0 ? Vec<D>(old.rotation().transpose() * normal[at] / length) : n;
            ++at;
            const Vec<D> U = place.master = old.master_velocity(master.to_body(e.centroid_master));
            if (place.volume <= 0)
                continue;
            auto in_place = [&](const Vec<D>& v) { return turned<D>(old.rotation().transpose() * v, before, n); };
            place.world = U + place.world / place.volume;
            place.velocity /= place.volume;
            const Vec<D> turning = spin_velocity<D>(spin, U - old.master_velocity(old.centre()) + 2 * place.velocity);
            place.inertial = -tangential<D>(old.rotation().transpose() * turning, n);
            place.velocity = in_place(place.velocity);
            place.reference = in_place(place.reference / e.volume);
            place.acceleration = in_place(place.acceleration / (e.volume - place.covered));
            place.increment = in_place(place.increment / (e.volume - place.covered));
        }
    return result;
}

} // namespace

template <int D>
std::vector<FluidInPlace<D>> put_in_place(const FilmNetwork<D>& network, std::span<const Solid<D>> solids,
                                          const std::vector<const FilmHistory<D>*>& history)
{
    std::map<const FilmHistory<D>*, std::size_t> number; // of each pair's history
    std::vector<std::vector<int>> pairs;                 // their films
    for (std::size_t k = 0; k < history.size(); ++k)
        if (history[k]) {
            const auto [pair, is_new] = number.try_emplace(history[k], pairs.size());
            if (is_new)
                pairs.emplace_back();
            pairs[pair->second].push_back(static_cast<int>(k));
        }
    std::vector<std::vector<FluidInPlace<D>>> places(pairs.size());
    const auto is_here = [&](std::size_t pair) { return network.films[pairs[pair][0]].here; };
    for_each_job(static_cast<int>(pairs.size()), [&](int pair) {
        const int k = pairs[pair][0];
        if (is_here(pair))
            places[pair] = put_pair_in_place(network, solids[network.films[k].pair.master].shape, *history[k], pairs[pair]);
    });
    exchange_items(
        network.ranks, pairs.size(), is_here, [&](ByteWriter& out, std::size_t pair) { out(places[pair]); },
        [&](ByteReader& in, std::size_t pair) { in(places[pair]); });
    std::vector<FluidInPlace<D>> result(network.elements);
    for (std::size_t pair = 0; pair < pairs.size(); ++pair) {
        auto next = places[pair].begin();
        for (int k : pairs[pair]) {
            const auto end = next + static_cast<long>(network.films[k].mesh.elements.size());
            std::copy(next, end, result.begin() + network.films[k].first_element);
            next = end;
        }
    }
    return result;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template std::vector<FluidInPlace<D>> put_in_place<D>(const FilmNetwork<D>&, std::span<const Solid<D>>,                    \
                                                          const std::vector<const FilmHistory<D>*>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
