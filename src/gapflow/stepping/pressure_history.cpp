#include "gapflow/stepping/pressure_history.hpp"

#include "gapflow/stepping/extrapolation_share.hpp"
#include "gapflow/stepping/leaving.hpp"

#include <cmath>

namespace gapflow {

template <int D>
PastPressure<D> bulk_pressure(const Coupling<D>& here, const State<D>& state)
{
    const Grid<D>& grid = *here.grid;
    PastPressure<D> bulk{CellField<D>(grid), CellField<D>(grid)};
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
        if (here.system.component(c) >= 0) {
            bulk.known(c) = 1;
            bulk.pressure(c) = state.pressure.impulse.cells(c) / state.dt;
        }
    });
    return bulk;
}

template <int D>
LastPressure<D> recall_pressure(const Model<D>& model, const Coupling<D>& here, const Step& step, State<D>& state)
{
    LastPressure<D> last;
    if (model.viscous()) {
        last.bulk = std::move(state.pressure.bulk);
        last.force = std::move(state.pressure.force);
        const double share = extrapolation_share(step.last_dt, step.dt);
        if (share < 1) {
            for (long i = 0; i < last.bulk.pressure.size(); ++i)
                last.bulk.pressure.data()[i] *= share;
            for (Twist<D>& force : last.force)
                force *= share;
        }
        return last;
    }
    bool goes_on = true;
    for (const Whereabouts& place : whereabouts(model, state.bodies))
        goes_on = goes_on && place.crossed.empty() && !place.floats;
    if (goes_on && !state.pressure.lasts && state.pressure.bulk.pressure.size() > 0) {
        last.bulk = std::move(state.pressure.bulk);
        return last;
    }
    if (goes_on && state.pressure.lasts)
        last.bulk = bulk_pressure(here, state);
    else
        last.bulk.pressure = last.bulk.known = CellField<D>(model.grid);
    return last;
}

template <int D>
void remember_film_pressure(const Coupling<D>& there, const std::vector<Vec<D>>& before, const std::vector<Vec<D>>& after,
                            const Step& step, PressureHistory<D>& history)
{
    // Flat films keep their mesh: from the middles of two steps to the end of the last one.
    std::vector<Vec<D>> mean;
    std::vector<std::size_t> place;
    history.film.assign(before.size(), Vec<D>::Zero());
    for (std::size_t i = 0; i < before.size(); ++i)
        history.film[i] = (after[i] - before[i]) / step.dt;
    for (const Film<D>& film : there.network.films)
        if (!before.empty() && film.mesh.flat)
            for (std::size_t i = 0; i < film.mesh.elements.size(); ++i) {
                place.push_back(film.first_element + i);
                mean.push_back(history.film[place.back()]);
            }
    if (mean.size() == history.film_mean.size())
        for (std::size_t i = 0; i < mean.size(); ++i)
            history.film[place[i]] += step.dt / (step.dt + step.last_dt) * (mean[i] - history.film_mean[i]);
    history.film_mean = std::move(mean);
}

template <int D>
void remember_viscous_pressure(const Model<D>& model, const Coupling<D>& there, const std::vector<TwistMatrix<D>>& mass,
                               const std::vector<Twist<D>>& V_star, const CellField<D>& divergence, const Step& step,
                               State<D>& state)
{
    const Grid<D>& grid = model.grid;
    PressureHistory<D>& history = state.pressure;
    const double share = model.scene.viscosity / std::pow(grid.dx(), D);
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
        const bool has_pressure = there.system.component(c) >= 0;
        history.bulk.known(c) = has_pressure;
        history.bulk.pressure(c) =
            has_pressure ? history.impulse.cells(c) / step.dt - share / grid.relative_volume(c) * divergence(c) : 0.0;
    });
    // The force on bodies belongs to the same pressure as that from which the fluid starts.
    UnknownVector<D> rotational{CellField<D>(grid), Eigen::VectorXd::Zero(there.system.nodes)};
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
        rotational.cells(c) = history.bulk.known(c) > 0 ? -share / grid.relative_volume(c) * divergence(c) : 0.0;
    });
    const std::vector<Twist<D>> on_bodies = impulses(there, rotational);
    for (std::size_t b = 0; b < state.bodies.size(); ++b)
        history.force[b] = state.bodies[b].motion == Motion::free
                               ? Twist<D>(Twist<D>(mass[b] * (state.bodies[b].twist - V_star[b]) / step.dt) + on_bodies[b])
                               : Twist<D>(Twist<D>::Zero());
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template PastPressure<D> bulk_pressure<D>(const Coupling<D>&, const State<D>&);                                            \
    template LastPressure<D> recall_pressure<D>(const Model<D>&, const Coupling<D>&, const Step&, State<D>&);                  \
    template void remember_film_pressure<D>(const Coupling<D>&, const std::vector<Vec<D>>&, const std::vector<Vec<D>>&,        \
                                            const Step&, PressureHistory<D>&);                                                 \
    template void remember_viscous_pressure<D>(const Model<D>&, const Coupling<D>&, const std::vector<TwistMatrix<D>>&,        \
                                               const std::vector<Twist<D>>&, const CellField<D>&, const Step&, State<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
