// Forces on the bodies in a step, split by what exerts them.
#pragma once

#include "gapflow/stepping/diffusion.hpp"
#include "gapflow/stepping/unilateral.hpp"

#include <vector>

namespace gapflow {

/// Force and torque on a body about its centre of mass, means over a step. The sum without `contact` is the fluid's wrench.
template <int D>
struct ForceParts {
    Twist<D> pressure =
        Twist<D>::Zero(); ///< of the grid's cells, without the hydrostatic part; and of a driven box's mean gradient
    Twist<D> shear = Twist<D>::Zero();   ///< viscous traction of the bulk
    Twist<D> film = Twist<D>::Zero();    ///< pressure and shear of films
    Twist<D> contact = Twist<D>::Zero(); ///< with friction
    Twist<D> buoyancy = Twist<D>::Zero();

    Twist<D> fluid() const { return pressure + shear + film + buoyancy; }
};

/// Of every body, from the result of a projection before take_up() takes it. `bodies`: at the step's end. Collective.
template <int D>
std::vector<ForceParts<D>> force_parts(const Model<D>& model, const Coupling<D>& there, const Projected<D>& end,
                                       const Diffusion<D>& diffusion, const Step& step, const State<D>& state);

/// Adds what contacts do, means over a step of length dt.
template <int D>
void add_contact_forces(const State<D>& state, double dt, std::vector<ForceParts<D>>& forces);

/// Buoyancy of a body: the force that fluid at rest exerts on it.
template <int D>
Twist<D> buoyancy(const Model<D>& model, const RigidBody<D>& body);

} // namespace gapflow
