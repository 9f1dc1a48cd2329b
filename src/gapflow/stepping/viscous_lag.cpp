#include "gapflow/stepping/viscous_lag.hpp"

#include "gapflow/stepping/short_text.hpp"

#include <algorithm>

namespace gapflow {

namespace {

// Largest nu dt / dx^2 at which three random tanks of heavy and light bodies at Reynolds numbers of 0.01 to 0.1 gain no energy.
constexpr double largest_viscous_number = 40;
// A body that changes its velocity by this part of the largest one in a step is in unsteady motion.
constexpr double unsteady = 0.1;

} // namespace

template <int D>
std::optional<std::string> viscous_lag_note(const Model<D>& model, const State<D>& state)
{
    const Scene& scene = model.scene;
    const double dx = model.grid.dx(), rate = scene.viscosity / (scene.density * dx * dx); // nu / dx^2
    if (!(rate * state.dt > largest_viscous_number))
        return {};
    double largest = 0, change = 0;
    for (std::size_t b = 0; b < state.bodies.size(); ++b)
        if (state.bodies[b].motion == Motion::free) {
            largest = std::max(largest, state.bodies[b].twist.template head<D>().norm());
            change = std::max(change, state.dt * state.acceleration[b].template head<D>().norm());
        }
    if (!(change > unsteady * largest))
        return {};
    return "bodies change their velocities faster than the pressure of so viscous fluid follows in steps of time.max_step = " +
           short_text(scene.max_step) + " (nu dt / dx^2 up to " + short_text(scene.max_step * rate) +
           "): their forces lag behind, and they may gain energy; use a time.max_step of " +
           short_text(largest_viscous_number / rate) + " or less";
}

#define GAPFLOW_INSTANTIATE(D) template std::optional<std::string> viscous_lag_note<D>(const Model<D>&, const State<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
