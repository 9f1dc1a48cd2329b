#include "gapflow/stepping/rehearsal.hpp"

#include "gapflow/stepping/carried_pressure.hpp"
#include "gapflow/stepping/pressure_history.hpp"

#include <algorithm>
#include <tuple>

namespace gapflow {

namespace {

template <int D>
std::vector<std::pair<FilmPair<D>, std::size_t>> elements_of_films(const Coupling<D>& coupling)
{
    std::vector<std::pair<FilmPair<D>, std::size_t>> films;
    for (const Film<D>& film : coupling.network.films)
        films.emplace_back(film.pair, film.mesh.elements.size());
    return films;
}

} // namespace

template <int D>
bool expects_anything(const Model<D>& model, const Coupling<D>& here)
{
    return model.viscous() || !here.network.films.empty() ||
           std::any_of(model.bodies.begin(), model.bodies.end(),
                       [](const RigidBody<D>& body) { return body.motion == Motion::free; });
}

template <int D>
Expectations<D> expectations(const Model<D>& model, State<D>& after, const Coupling<D>& there)
{
    Expectations<D> found;
    found.pressure = std::move(after.pressure.bulk);
    if (!model.viscous() && after.pressure.lasts)
        found.pressure = bulk_pressure(there, after);
    if (found.pressure.pressure.size() > 0)
        if (const auto W = carrying_velocity(there, model.twists(after.bodies), after.bodies.size(), model.grid_velocity))
            carry(model.grid, *W, -after.dt, found.pressure);
    found.acceleration = std::move(after.acceleration);
    for (const RigidBody<D>& body : after.bodies)
        found.rates.emplace_back(body.acceleration, body.angular_momentum_rate);
    found.force = std::move(after.pressure.force);
    found.film_increment = std::move(after.film_increment);
    found.films = elements_of_films(there);
    return found;
}

template <int D>
void expect(Expectations<D> found, const Coupling<D>& here, State<D>& state)
{
    state.acceleration = std::move(found.acceleration);
    for (std::size_t b = 0; b < state.bodies.size(); ++b)
        std::tie(state.bodies[b].acceleration, state.bodies[b].angular_momentum_rate) = found.rates[b];
    state.pressure.bulk = std::move(found.pressure);
    state.pressure.force = std::move(found.force);
    if (found.films == elements_of_films(here))
        state.film_increment = std::move(found.film_increment);
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template bool expects_anything<D>(const Model<D>&, const Coupling<D>&);                                                    \
    template Expectations<D> expectations<D>(const Model<D>&, State<D>&, const Coupling<D>&);                                  \
    template void expect<D>(Expectations<D>, const Coupling<D>&, State<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
