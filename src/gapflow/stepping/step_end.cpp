#include "gapflow/stepping/step_end.hpp"

#include "gapflow/coupling/film_drag.hpp"
#include "gapflow/stepping/drive.hpp"
#include "gapflow/stepping/flooding.hpp"
#include "gapflow/stepping/force_parts.hpp"
#include "gapflow/stepping/motion.hpp"
#include "gapflow/stepping/side_pressure.hpp"

namespace gapflow {

namespace {

// Velocities of the end of the step: u* minus the pressure gradient, plus the flux that both walls of films and mouths drag
// along. `met`: there was an impact in the step, and the pressure's history is invalidated.
template <int D>
void take_velocities(const Model<D>& model, const Coupling<D>& there, Projected<D>& end, bool met, const Step& step,
                     State<D>& state)
{
    const std::vector<Twist<D>>& V = end.twists;
    FluidVelocity<D>& u = end.velocity;
    std::vector<Vec<D>> without_pressure;
    if (!model.viscous() && step.dt > 0)
        without_pressure = u.film;
    subtract_gradient(there, end.impulse, u);
    if (!met)
        remember_film_pressure(there, without_pressure, u.film, step, state.pressure);
    add_entrainment(there, V, 1, u);
    const VoidSet<D>& voids = state.voids;
    if (!(step.dt > 0 && voids.any()))
        return;
    for (std::size_t r = 0; r < u.mouth.size(); ++r)
        if (voids.shut()[r])
            u.mouth[r] += carried_flux<D>(there, there.network.rim.mouths[r], V) - entrained_flux(there, r, V);
    const std::vector<char> is_empty = voids.empty_elements(there.network);
    rest_in_voids<D>(there, is_empty, V, u.film);
    follow_front<D>(there, end.was_empty, is_empty, voids.is_void(), V, u);
}

// Force and torque of the fluid on every body, mean over the step: pressure, buoyancy, driving gradient, shear of films, viscous traction of the bulk.
template <int D>
std::vector<Twist<D>> wrenches(const Model<D>& model, const Coupling<D>& there, const Projected<D>& end,
                               const Diffusion<D>& diffusion, const Drive<D>& drive, const Step& step,
                               const std::vector<RigidBody<D>>& bodies)
{
    std::vector<Twist<D>> impulse = impulses(there, end.impulse);
    if (!there.element_drag.empty()) {
        const std::vector<Twist<D>> shear = drag_impulses(there, end.twists);
        for (std::size_t s = 0; s < impulse.size(); ++s)
            impulse[s] += shear[s];
    }
    const std::vector<Twist<D>> from_beyond = wrenches_from_beyond(model, there, step.end());
    std::vector<Twist<D>> result;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const RigidBody<D>& body = bodies[b];
        Twist<D> sum = buoyancy(model, body);
        if (step.dt > 0 && model.driven())
            sum += driving_wrench(body, drive);
        if (step.dt > 0)
            sum += impulse[b] / step.dt + from_beyond[b];
        if (!diffusion.impulses.empty())
            sum += diffusion.impulses[b] / step.dt;
        result.push_back(sum);
    }
    return result;
}

} // namespace

template <int D>
void take_up(const Model<D>& model, const Coupling<D>& there, Projected<D> end, const std::vector<TwistMatrix<D>>& mass,
             const std::vector<Twist<D>>& twists, LastPressure<D> past, const Diffusion<D>& diffusion, const Step& step,
             State<D>& state)
{
    state.dt = step.dt;
    state.time = step.landing;
    const bool met = step.dt > 0 && finish_bodies(model, end.twists, step, state);
    take_velocities(model, there, end, met, step, state);
    state.wrenches = wrenches(model, there, end, diffusion, state.drive, step, state.bodies);
    state.velocity = std::move(end.velocity);
    state.pressure.impulse = std::move(end.impulse);
    if (step.dt == 0)
        return;
    state.film_debts =
        settle_films(there.network, end.account, state.velocity.film, state.velocity.mouth, step.dt, state.film_increment);
    if (met)
        state.film_increment.clear();
    state.steps = step.number;
    state.conductance.clear();
    for (std::size_t r = 0; r < there.network.rim.mouths.size(); ++r)
        state.conductance.push_back(there.system.links[r].conductance);
    if (model.viscous() || met)
        state.pressure.bulk = std::move(past.bulk);
    if (model.viscous())
        state.pressure.force = std::move(past.force);
    state.pressure.lasts = !met;
    if (met)
        state.pressure.forget();
    else if (model.viscous())
        remember_viscous_pressure(model, there, mass, twists, diffusion.divergence, step, state);
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template void take_up<D>(const Model<D>&, const Coupling<D>&, Projected<D>, const std::vector<TwistMatrix<D>>&,            \
                             const std::vector<Twist<D>>&, LastPressure<D>, const Diffusion<D>&, const Step&, State<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
