// Changes by a controller between two steps: forces and prescribed motion.
#pragma once

#include "gapflow/stepping/state.hpp"

namespace gapflow {

/// External force at the centre of mass and torque about it on a free body, world axes, in place of those of the scene. The
/// last step's acceleration, which enters the next step's length, changes with the force as if there were no fluid: added mass
/// only reduces the change. Throws InputError if the body is not free or a number not finite.
template <int D>
void set_force(State<D>& state, int body, const Vec<D>& force, const Spin<D>& torque);

/// From now on a body of prescribed motion, from where it is, moves with this velocity of the centre of mass and turns with
/// this angular velocity, world axes. Throws InputError as above.
template <int D>
void set_velocity(State<D>& state, int body, const Vec<D>& velocity, const Spin<D>& angular_velocity);

} // namespace gapflow
