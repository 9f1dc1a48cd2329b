#include "gapflow/stepping/configuration.hpp"

#include "gapflow/core/machine_memory.hpp"
#include "gapflow/coupling/wet_system.hpp"
#include "gapflow/stepping/gap_limit.hpp"
#include "gapflow/stepping/start.hpp"

namespace gapflow {

namespace {

constexpr std::size_t many_points =
    1000000; // of films: above, the small blocks of memory that they free are returned to the system

} // namespace

template <int D>
LeftBehind<D> leave(std::optional<Coupling<D>>& here)
{
    LeftBehind<D> left{here->fractions, {}};
    std::size_t points = 0;
    for (const Film<D>& film : here->network.films) {
        left.films.insert(film.pair);
        points += film.mesh.points.size();
    }
    here.reset();
    if (points > many_points)
        return_freed_memory();
    return left;
}

template <int D>
Coupling<D> configure(const Model<D>& model, State<D>& state, const std::vector<TwistMatrix<D>>& mass,
                      const FilmHistories<D>* histories, const std::vector<Twist<D>>& twists, double dt, StageTimers& timers,
                      const FaceFractions<D>* before)
{
    const auto drag_terms = [&](const Coupling<D>& films) {
        state.voids.find(films, histories);
        if (model.viscous())
            state.voids.find_wet_shares(films, twists);
        return DragTerms{state.voids.wet_shares(), gap_changes(model, films, state)};
    };
    return model.coupled(state.bodies, mass, model.scene.viscosity * dt, state.films_before, drag_terms, &timers, before);
}

template <int D>
Coupling<D> configure(const Model<D>& model, State<D>& state, const std::vector<TwistMatrix<D>>& mass,
                      const FilmHistories<D>& histories, const FaceFractions<D>& before, const Step& step, StepReport& report,
                      StageTimers& timers)
{
    Coupling<D> there = configure(model, state, mass, &histories, model.twists(state.bodies), step.dt, timers, &before);
    if (state.voids.lost() > 0)
        report.notes.push_back("a gap with a void in it opened beyond its film (gap.threshold): the void is gone at once");
    return there;
}

template <int D>
Coupling<D> configure_stored(const Model<D>& model, const State<D>& state, StageTimers& timers)
{
    const std::vector<TwistMatrix<D>> mass =
        state.steps == 0 ? held_masses(model, state.bodies) : model.masses(state.bodies, state.dt);
    Coupling<D> here = model.coupled(
        state.bodies, mass, model.scene.viscosity * state.dt, state.films_before,
        [&](const Coupling<D>& films) {
            return DragTerms{state.voids.wet_shares(), gap_changes(model, films, state)};
        },
        &timers);
    const FilmNetwork<D>& network = here.network;
    const FluidVelocity<D>& u = state.velocity;
    const std::size_t mouths = network.rim.mouths.size();
    if (static_cast<int>(u.film.size()) != network.elements || u.film_normal.size() != u.film.size() ||
        state.pressure.impulse.nodes.size() != network.nodes || u.mouth.size() != mouths ||
        (!state.conductance.empty() && state.conductance.size() != mouths) ||
        static_cast<int>(state.voids.volume().size()) != network.nodes || state.voids.shut().size() != mouths ||
        (state.node_outflow.size() != 0 && state.node_outflow.size() != network.nodes))
        throw StateError("its films are not those that its bodies' positions give");
    for (std::size_t r = 0; r < state.conductance.size(); ++r) // limits the next step (GapLimit)
        here.system.links[r].conductance = state.conductance[r];
    if (state.voids.any())
        WetSystem<D>(here).take_out(state.voids.is_void(), state.voids.impulses(state.dt), state.voids.shut());
    return here;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template LeftBehind<D> leave<D>(std::optional<Coupling<D>>&);                                                              \
    template Coupling<D> configure<D>(const Model<D>&, State<D>&, const std::vector<TwistMatrix<D>>&, const FilmHistories<D>*, \
                                      const std::vector<Twist<D>>&, double, StageTimers&, const FaceFractions<D>*);            \
    template Coupling<D> configure<D>(const Model<D>&, State<D>&, const std::vector<TwistMatrix<D>>&, const FilmHistories<D>&, \
                                      const FaceFractions<D>&, const Step&, StepReport&, StageTimers&);                        \
    template Coupling<D> configure_stored<D>(const Model<D>&, const State<D>&, StageTimers&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
