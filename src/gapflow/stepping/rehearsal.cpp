#include "gapflow/stepping/rehearsal.hpp"

#include <algorithm>

namespace gapflow {

template <int D>
bool rehearses(const Model<D>& model, const Coupling<D>& here)
{
    return model.viscous() || !here.network.films.empty() ||
           std::any_of(model.bodies.begin(), model.bodies.end(), [](const RigidBody<D>& body) { return body.motion == Motion::free; });
}

template <int D>
std::vector<std::pair<FilmPair<D>, std::size_t>> elements_of_films(const Coupling<D>& coupling)
{
    std::vector<std::pair<FilmPair<D>, std::size_t>> counts;
    for (const Film<D>& film : coupling.network.films)
        counts.emplace_back(film.pair, film.mesh.elements.size());
    return counts;
}

template <int D>
void expect(State<D>& start, State<D>&& after, bool same_films)
{
    start.acceleration = std::move(after.acceleration);
    for (std::size_t b = 0; b < start.bodies.size(); ++b) {
        start.bodies[b].acceleration = after.bodies[b].acceleration;
        start.bodies[b].angular_momentum_rate = after.bodies[b].angular_momentum_rate;
    }
    start.pressure.bulk = std::move(after.pressure.bulk);
    start.pressure.force = std::move(after.pressure.force);
    if (same_films)
        start.film_increment = std::move(after.film_increment);
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template bool rehearses<D>(const Model<D>&, const Coupling<D>&);                                                           \
    template std::vector<std::pair<FilmPair<D>, std::size_t>> elements_of_films<D>(const Coupling<D>&);                        \
    template void expect<D>(State<D>&, State<D>&&, bool);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
