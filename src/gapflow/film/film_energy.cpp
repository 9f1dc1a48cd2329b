#include "gapflow/film/film_energy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gapflow {

namespace {

// Largest relative energy increase in transport, since the flux deviates slightly from the volume balance: the first value for each element
// that the flow crosses, the second in all. (With a bound per step alone, noise would grow in the small steps near a point of contact.)
constexpr double growth_on_the_way = 0.25, most_growth = 0.05;
constexpr double most_opening = 1.5; // of a mouth in a step
constexpr double behind = 2;         // part of the film behind a mouth, in shares of the film by its length of the rim
constexpr double discretised = 1.01; // discretisation error of a film's elements
constexpr double thrown_margin =
    10; // of the energy of the heads' own fluxes over that: plates that meet need up to this factor

// Ratio of the energy of the mouths' heads to the films' loss in transport, in a step that reduces their thickness by the part r. Second order:
// heads of the step's middle take 3 r (1 + r/2) of the flow's energy (plates stopped by the film alone), and transport, with feet 1 - r of the
// way to the mouth and half of the pressure at the foot, takes less of it. Else: 3 r, at the rate of the step's start, and feet by the midpoint rule.
double head_margin(double r, bool second_order)
{
    if (!(r > 1e-6))
        return 1;
    const double carried = second_order ? 1 - r - 0.5 * r * r : 1 - r + 0.5 * r * r;
    return (second_order ? discretised * 3 * r * (1 + 0.5 * r) : 3 * r) / (1 - (1 - r) * carried * carried);
}

// The speed c with sum volume min(speed, c)^2 = most, of (speed squared, volume) whose sum is larger.
double fastest_within(std::vector<std::pair<double, double>>& parts, double most)
{
    std::sort(parts.begin(), parts.end());
    double slow = 0, fast_volume = 0;
    for (const auto& [square, volume] : parts)
        fast_volume += volume;
    for (const auto& [square, volume] : parts) {
        if (slow + fast_volume * square >= most)
            break;
        slow += square * volume;
        fast_volume -= volume;
    }
    return std::sqrt(std::max(most - slow, 0.0) / fast_volume);
}

} // namespace

template <int D>
GivenAway<D>
limit_motion(const FilmNetwork<D>& network, std::span<const Solid<D>> solids, const std::vector<const FilmHistory<D>*>& history,
             const std::vector<typename FilmHistory<D>::Transported>& at_element,
             const std::vector<typename FilmHistory<D>::Transported>& at_mouth, double dt, std::vector<Vec<D>>& velocity)
{
    struct Sum {
        double area = 0, volume = 0, motion = 0, inflow = 0, beyond = 0; // beyond: volume of elements where there was no film
        double slowness = 0;                                             // sum of area / thickness
        std::vector<std::pair<double, double>> parts;                    // speed squared and volume of each element
        double fastest = std::numeric_limits<double>::infinity();
    };
    std::map<const FilmHistory<D>*, Sum> sums;
    auto for_each_carried = [&](auto&& f) {
        for (std::size_t k = 0; k < network.films.size(); ++k) {
            const Film<D>& film = network.films[k];
            for (std::size_t i = 0; history[k] && i < film.mesh.elements.size(); ++i) {
                const FilmElement<D>& e = film.mesh.elements[i];
                const std::size_t at = film.first_element + i;
                if (!at_element[at].near)
                    continue;
                const Vec<D> U = history[k]->master_velocity(solids[film.pair.master].shape.to_body(e.centroid_master));
                f(history[k], e, at_element[at].beyond, velocity[at], Vec<D>(U - U.dot(e.normal) * e.normal));
            }
        }
    };
    for_each_carried(
        [&](const FilmHistory<D>* old, const FilmElement<D>& e, bool beyond, const Vec<D>& u, const Vec<D>& along) {
            Sum& sum = sums[old];
            sum.area += e.measure;
            sum.volume += e.volume;
            sum.slowness += e.measure * e.measure / e.volume;
            sum.beyond += beyond ? e.volume : 0.0;
            sum.motion += e.volume * (u - along).squaredNorm();
            sum.parts.emplace_back((u - along).squaredNorm(), e.volume);
        });
    const std::vector<Mouth<D>>& mouths = network.rim.mouths;
    std::map<const FilmHistory<D>*, double> rim; // length of all mouths
    for (const Mouth<D>& c : mouths)
        rim[history[c.film]] += c.length;
    for (std::size_t r = 0; r < mouths.size(); ++r) {
        const FilmHistory<D>* old = history[mouths[r].film];
        if (!old || !at_mouth[r].near)
            continue;
        const PlacedShape<D>& master = solids[network.films[mouths[r].film].pair.master].shape;
        const Vec<D> place = master.to_body(mouths[r].x), U = old->master_velocity(place);
        double u = std::min(mouths[r].outward.dot(at_mouth[r].velocity - U), 0.0);
        // At most the speed of the mouth's own flux: small elements cut by the film's end may have ten times that speed, and a mouth that opens
        // where a corner touched any speed.
        if (const auto* old_mouth = old->nearest_mouth(place, mouths[r].outward)) {
            const double h = std::max(old_mouth->h, mouths[r].h / most_opening);
            u = std::max(
                u, std::min((old_mouth->flux - old_mouth->h * old_mouth->outward.dot(old_mouth->master_velocity)) / h, 0.0));
        }
        const double volume = mouths[r].length * mouths[r].h * -u * dt;
        // Fluid beyond the film's volume has passed through it; and the flux is continuous into the film, not the speed.
        const double flux = u * mouths[r].h, share = std::min(1.0, behind * mouths[r].length / rim[old]);
        sums[old].inflow += std::min(std::min(volume, old->volume()) * u * u, flux * flux * share * sums[old].slowness);
    }
    for (auto& [old, sum] : sums) {
        const double size = std::pow(sum.area / static_cast<double>(sum.parts.size()), 1.0 / (D - 1));
        const double ways = dt * std::sqrt(old->motion() / old->volume()) / size;
        const double most =
            sum.inflow + old->motion() * (1 + std::min(most_growth, growth_on_the_way * ways) + sum.beyond / old->volume());
        if (sum.motion > most)
            sum.fastest = fastest_within(sum.parts, most);
    }
    for_each_carried([&](const FilmHistory<D>* old, const FilmElement<D>&, bool, Vec<D>& u, const Vec<D>& along) {
        if (const double speed = (u - along).norm(), fastest = sums[old].fastest; speed > fastest)
            u = along + fastest / speed * (u - along);
    });
    GivenAway<D> given_away;
    for (const auto& [old, sum] : sums)
        given_away[old] = {std::max(old->motion() + sum.inflow - sum.motion, 0.0),
                           std::max(1 - sum.volume / sum.area / (old->volume() / old->area()), 0.0)};
    return given_away;
}

template <int D>
void add_heads(const FilmNetwork<D>& network, std::span<const Solid<D>> solids,
               const std::vector<const FilmHistory<D>*>& history, const GivenAway<D>& given_away,
               const std::vector<double>& head, std::vector<double>& flux)
{
    std::map<const FilmHistory<D>*, double> asked,
        thrown; // twice the work of the whole heads over the density, and the energy of their own fluxes
    const std::vector<Mouth<D>>& mouths = network.rim.mouths;
    std::map<const FilmHistory<D>*, double> section; // of all mouths
    for (const Mouth<D>& c : mouths)
        section[history[c.film]] += c.length * c.h;
    for (std::size_t r = 0; r < mouths.size(); ++r) {
        if (head[r] == 0)
            continue;
        const Mouth<D>& c = mouths[r];
        const FilmHistory<D>* old = history[c.film];
        const Vec<D> U = old->master_velocity(solids[network.films[c.film].pair.master].shape.to_body(c.x));
        const double q = flux[r] - c.length * c.h * c.outward.dot(U);
        asked[old] += c.resistance / c.length * 2 * q * head[r];
        const double film = old->area() / (3 * section[old]); // inertance of the film behind, its length over 3 h
        thrown[old] += c.resistance / c.length * head[r] * head[r] * c.resistance / (c.resistance + film);
    }
    for (std::size_t r = 0; r < mouths.size(); ++r) {
        if (head[r] == 0)
            continue;
        const FilmHistory<D>* old = history[mouths[r].film];
        const auto known = given_away.find(old);
        const double most =
            known != given_away.end() ? head_margin(known->second.closing, old->second_order()) * known->second.energy : 0.0;
        double share = asked[old] > most ? most / asked[old] : 1.0;
        if (share * share * thrown[old] > thrown_margin * most)
            share = std::sqrt(thrown_margin * most / thrown[old]);
        flux[r] += share * head[r];
    }
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template GivenAway<D> limit_motion<D>(const FilmNetwork<D>&, std::span<const Solid<D>>,                                    \
                                          const std::vector<const FilmHistory<D>*>&,                                           \
                                          const std::vector<FilmHistory<D>::Transported>&,                                     \
                                          const std::vector<FilmHistory<D>::Transported>&, double, std::vector<Vec<D>>&);      \
    template void add_heads<D>(const FilmNetwork<D>&, std::span<const Solid<D>>, const std::vector<const FilmHistory<D>*>&,    \
                               const GivenAway<D>&, const std::vector<double>&, std::vector<double>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
