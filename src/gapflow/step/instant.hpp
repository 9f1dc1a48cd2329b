// An instant of a run: the bodies in the fluid, the potential flow that belongs to their velocities, and the generalised forces of its energy.
#pragma once

#include "gapflow/step/displaced.hpp"
#include "gapflow/stepping/following.hpp"

#include <memory>
#include <vector>

namespace gapflow {

/// Mean forces of friction on all solids in a step.
template <int D>
struct Friction {
    std::vector<Twist<D>> bulk, gaps; ///< gaps: of those in closed form; empty without viscosity
};

template <int D>
struct Instant {
    std::unique_ptr<Placed<D>> placed;
    std::vector<Displaced<D>> displaced; ///< for the forces of solids with mouths
    Vec<D> stream = Vec<D>::
        Zero(); ///< uniform velocity of the fluid (fluid.velocity, and what drives it): all that follows is of the motion relative to it
    PotentialFlow<D> flow;
    std::vector<Twist<D>> impulse; ///< dT/dV of the fluid's energy T, of every solid
    /// Rate of that impulse at constant impulses of the bodies themselves: dT/dx at fixed twists and, in 3D, omega x the angular impulse (the axes of
    /// twists do not turn with the body).
    std::vector<Twist<D>> force;
    double energy = 0;          ///< T
    FaceField<D> flux{};        ///< of volume through the faces of the grid (face_fluxes()), with circulation; else empty
    FollowedBody<D> followed{}; ///< its force is that of T as a function of its place and, with it, the grid's
    Vec<D> of_sides = Vec<D>::
        Zero(); ///< its share by which the fluid's motion is not that of its place alone: by what sides bear, with circulation
    PartVoids kept{};                ///< voids with which the next step starts
    Friction<D> friction{};          ///< in the step that ended here
    UnknownVector<D> left_outflow{}; ///< net outflow of the rows in a step with voids; else empty
};

/// The fluid's uniform velocity, as a twist.
template <int D>
Twist<D> stream_twist(const Vec<D>& stream)
{
    Twist<D> twist = Twist<D>::Zero();
    twist.template head<D>() = stream;
    return twist;
}

/// All twists with another one added.
template <int D>
std::vector<Twist<D>> moved_by(std::vector<Twist<D>> twists, const Twist<D>& by)
{
    for (Twist<D>& twist : twists)
        twist += by;
    return twists;
}

/// Of bodies and their flow, relative to a stream. Collective.
template <int D>
Instant<D> instant_of(const Model<D>& model, const std::vector<RigidBody<D>>& bodies, std::unique_ptr<Placed<D>> placed,
                      PotentialFlow<D> flow, const Vec<D>& stream = Vec<D>::Zero());
/// Impulse, force and energy after the flow has changed. Collective.
template <int D>
void find_forces(Instant<D>& instant);

/// Velocities of the fluid on the faces of the grid, with the stream. Collective.
template <int D>
FluidVelocity<D> face_velocities(const Instant<D>& instant);

/// Net outflow of every unknown's volume: what the solver's tolerance leaves. Collective.
template <int D>
UnknownVector<D> net_outflow(const Instant<D>& instant, const FluidVelocity<D>& velocity);

/// Largest net outflow over the volume of a cell, 1/time. Collective.
template <int D>
double largest_divergence(const Instant<D>& instant, const FluidVelocity<D>& velocity);

} // namespace gapflow
