#include "gapflow/stepping/steering.hpp"

#include "gapflow/body/forces.hpp"
#include "gapflow/core/error.hpp"

namespace gapflow {

namespace {

void demand_finite(bool finite, const std::string& body, const char* what)
{
    if (!finite)
        throw InputError(std::string(what) + " on body '" + body + "': is not finite; give finite numbers");
}

} // namespace

template <int D>
void set_force(State<D>& state, int body, const Vec<D>& force, const Spin<D>& torque)
{
    RigidBody<D>& b = state.bodies.at(body);
    if (b.motion != Motion::free)
        throw InputError("force on body '" + b.name + "': its motion is not \"free\", so no force moves it; set body." +
                         b.name + ".motion = \"free\"");
    demand_finite(force.allFinite() && torque.allFinite(), b.name, "force or torque");
    Twist<D> change;
    change << force - b.force, torque - b.torque;
    state.acceleration[body] += impulse_response<D>(b, change, 0);
    b.force = force;
    b.torque = torque;
}

template <int D>
void set_velocity(State<D>& state, int body, const Vec<D>& velocity, const Spin<D>& angular_velocity)
{
    RigidBody<D>& b = state.bodies.at(body);
    if (b.motion != Motion::prescribed)
        throw InputError("velocity of body '" + b.name +
                         "': its motion is not \"prescribed\", so it cannot be told how to move; " + "set body." + b.name +
                         ".motion = \"prescribed\", or push it with a force");
    demand_finite(velocity.allFinite() && angular_velocity.allFinite(), b.name, "velocity");
    steer<D>(b, {state.time, b.pose, velocity, angular_velocity});
    b.twist << velocity, angular_velocity;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template void set_force<D>(State<D>&, int, const Vec<D>&, const Spin<D>&);                                                 \
    template void set_velocity<D>(State<D>&, int, const Vec<D>&, const Spin<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
