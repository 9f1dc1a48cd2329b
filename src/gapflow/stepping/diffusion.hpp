// Viscosity of the bulk in a time step (method, "Viscosity"): an incremental splitting. The viscous step starts from velocities
// and twists that include the effect of the last step's pressure (for bodies of the whole last projection: films, contacts),
//
//     u~ = u* - dt grad p^n / rho,   V~ = V* + dt M^-1 F^n,     (u**, V**) = viscous step of (u~, V~),
//     (u*, V*) += (u**, V**) - (u~, V~),
//
// and the projection that follows computes the whole pressure, not an increment. A steady state does not depend on dt. In the
// next step p^n is
// the projection's pressure minus mu div u** (the rotational form; Timmermans, Minev & van de Vosse, Int. J. Numer. Meth.
// Fluids
// 22, 1996), with which transients stay short for any nu dt / dx^2.
#pragma once

#include "gapflow/stepping/pressure_history.hpp"
#include "gapflow/stepping/transport.hpp"

namespace gapflow {

template <int D>
struct Diffusion {
    std::vector<Twist<D>> impulses; ///< of the viscous traction on every solid, this step
    CellField<D> divergence;        ///< outflow of the cells that the grid's own faces drain, after the viscous step
};

/// Changes velocity and twists of `star`. The bodies' velocities that drag the fluid are those that `contacts` leave. Throws ComputationError where the viscous solve does not converge. Collective.
template <int D>
Diffusion<D> diffuse(const Model<D>& model, const std::vector<RigidBody<D>>& bodies, const ContactSet<D>& contacts,
                     const std::vector<TwistMatrix<D>>& mass, const LastPressure<D>& past, const Coupling<D>& there,
                     const Step& step, Intermediate<D>& star, StepReport& report);

} // namespace gapflow
