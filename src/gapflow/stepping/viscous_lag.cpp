#include "gapflow/stepping/viscous_lag.hpp"

#include "gapflow/stepping/short_text.hpp"

#include <algorithm>
#include <limits>

namespace gapflow {

namespace {

// Largest nu dt / dx^2 at which three random tanks of heavy and light bodies at Reynolds numbers of 0.01 to 0.1 gain no energy.
constexpr double largest_viscous_number = 40;
// A body that changes its velocity by this part of the largest one in a step is in unsteady motion.
constexpr double unsteady = 0.1;

// Time in which the bodies' accelerations change a velocity by as much as counts as unsteady.
template <int D>
double steady_time(const State<D>& state)
{
    double speed = 0, acceleration = 0;
    for (std::size_t b = 0; b < state.bodies.size(); ++b)
        if (state.bodies[b].motion == Motion::free) {
            speed = std::max(speed, state.bodies[b].twist.template head<D>().norm());
            acceleration = std::max(acceleration, state.acceleration[b].template head<D>().norm());
        }
    return acceleration > 0 ? unsteady * speed / acceleration : std::numeric_limits<double>::infinity();
}

} // namespace

template <int D>
double followed_step(const Model<D>& model)
{
    const double dx = model.grid.dx(), nu = model.scene.viscosity / model.scene.density;
    return nu > 0 ? largest_viscous_number * dx * dx / nu : std::numeric_limits<double>::infinity();
}

template <int D>
bool lags(const Model<D>& model, const State<D>& state)
{
    return state.dt > followed_step(model) && state.dt > steady_time(state);
}

template <int D>
double longest_viscous_step(const Model<D>& model, const State<D>& state)
{
    return std::max(followed_step(model), std::min(2 * state.dt, steady_time(state)));
}

template <int D>
std::string viscous_lag_note(const Model<D>& model)
{
    const double longest = model.scene.max_step, followed = followed_step(model);
    return "bodies change their velocities faster than the pressure of so viscous fluid follows in steps of time.max_step = " +
           short_text(longest) + " (nu dt / dx^2 up to " + short_text(largest_viscous_number * longest / followed) +
           "): while they do, steps are no longer than " + short_text(followed);
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template double followed_step<D>(const Model<D>&);                                                                         \
    template bool lags<D>(const Model<D>&, const State<D>&);                                                                   \
    template double longest_viscous_step<D>(const Model<D>&, const State<D>&);                                                 \
    template std::string viscous_lag_note<D>(const Model<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
