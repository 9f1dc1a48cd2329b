// Effect of the last step's pressure during the next one: it makes the bulk's advection second order in
// time (method, "The time step"). With g = -dt grad p^n / rho, the change of the fluid's velocity by the pressure in a step,
//
//     v = A_{dt/2}(u) + g / 2,     u* = A_v(u) + 1/2 (A_v(g) - g):
//
// traces follow the velocity v at the middle of the step, and half of the pressure acts at the trace's foot; the rest of the
// trapezoidal rule is a gradient, which the projection accounts for. Without it steady flow loses energy as if it had dt
// |u|^2 / 2 more viscosity along its streamlines. Around bodies that move, the g that is taken off has gone with them
// (stepping/carried_pressure): its force on a body is the same at both ends of the step.
#pragma once

#include "gapflow/coupling/coupling.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace gapflow {

/// The bulk's pressure after a step.
template <int D>
struct PastPressure {
    CellField<D> pressure; ///< reduced pressure, per time
    CellField<D> known;    ///< 1 where there is one
};

/// Reduced pressure beyond every side of the domain, at 2 * axis + end.
template <int D>
using SidePressures = std::array<double, 2 * D>;

/// Extrapolates the pressure into cells of this configuration that had none: the mean of the neighbours that had one, two
/// layers deep. Fills
/// ghosts. Collective.
template <int D>
void extrapolate_pressure(const Coupling<D>& coupling, PastPressure<D>& past);

/// u -= dt grad p / rho on open faces between cells whose pressure is known; `changed` gets 1 there. Beyond open sides the pressure
/// is `beyond`, half a cell away; beyond far sides it is 0, at infinity.
template <int D>
void subtract_known_gradient(const Coupling<D>& coupling, const PastPressure<D>& past, double dt, FaceField<D>& u,
                             const SidePressures<D>& beyond = {}, FaceField<D, std::int8_t>* changed = nullptr);

/// g on open faces, extrapolated into solids. Collective.
template <int D>
FaceField<D> velocity_change(const Coupling<D>& coupling, const PastPressure<D>& past, double dt,
                             const SidePressures<D>& beyond = {});

/// Limits the length of g to twice the change of the flow along its path, |dt u . grad u|, computed from u and `half_way`, u
/// half a step later: at a face the larger of the two cells' values. (The part of the pressure gradient that viscosity balances
/// accelerates nothing; the impulse from the creation of a film must not be extrapolated.) Then half_way += g / 2. Collective.
template <int D>
void limit_to_inertia(const Grid<D>& grid, const FaceField<D>& u, FaceField<D>& half_way, FaceField<D>& g);

} // namespace gapflow
