// What the pressure of the last step does on the way through the next one: with it the bulk's advection and the bodies' motion are of second
// order in time (method, "The time step"). With g = -dt grad p^n / rho, what the pressure does to the fluid in a step,
//
//     v = A_{dt/2}(u) + g / 2,     u* = A_v(u) + 1/2 (A_v(g) - g):
//
// traces follow the velocity v of the middle of the step, and half of the pressure's change counts where the fluid comes from; the rest
// of the trapezoidal rule is a gradient and left to the projection. So it is with bodies: half of the pressure pushes them where they
// come from,
//
//     M V* += 1/2 (F(S^n) - F(S^{n+1})),     F(S) = integral over the body within S of rho g,
//
// the same pressure on the surfaces before and after the step. Without the one steady flow loses energy as if it were dt |u|^2 / 2 more
// viscous along its streamlines; without the other a body that coasts through ideal fluid loses speed with the rate of dt.
#pragma once

#include "gapflow/coupling/coupling.hpp"

#include <cstdint>
#include <vector>

namespace gapflow {

/// The bulk's pressure after a step.
template <int D>
struct PastPressure {
    CellField<D> pressure; ///< reduced pressure, per time
    CellField<D> known;    ///< 1 where there is one
};

/// Continues the pressure into cells of this configuration that had none: the mean of the neighbours that had one, two layers deep. Fills
/// ghosts. Collective.
template <int D>
void continue_pressure(const Coupling<D>& coupling, PastPressure<D>& past);

/// u -= dt grad p / rho on open faces between cells whose pressure is known; `changed` gets 1 there. Beyond an open side the pressure
/// is 0, half a cell away.
template <int D>
void subtract_known_gradient(const Coupling<D>& coupling, const PastPressure<D>& past, double dt, FaceField<D>& u,
                             FaceField<D, std::int8_t>* changed = nullptr);

/// g on open faces, continued into solids. Collective.
template <int D>
FaceField<D> velocity_change(const Coupling<D>& coupling, const PastPressure<D>& past, double dt);

/// Limits the length of g to twice what the flow changes by along its way, |dt u . grad u|, as u and `half_way`, u half a step on, tell: at a
/// face the larger of the two cells'. (What viscosity balances of the pressure's gradient accelerates nothing; what a film's birth leaves
/// does not go on.) Then half_way += g / 2. Collective.
template <int D>
void limit_to_inertia(const Grid<D>& grid, const FaceField<D>& u, FaceField<D>& half_way, FaceField<D>& g);

/// 1/2 (F(S^n) - F(S^{n+1})) of the first `bodies` solids, impulses. (Torques are left as they are: a ball in ideal flow must not turn, to
/// round-off, and the bulk's share of a body's pressure alone does not say so.) Collective.
template <int D>
std::vector<Vec<D>> swept_impulses(const Grid<D>& grid, double density, const FaceField<D>& change,
                                   const FaceFractions<D>& before, const FaceFractions<D>& after, std::size_t bodies);

} // namespace gapflow
