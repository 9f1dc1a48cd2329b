// Fluid enclosed by surfaces in contact (method, "The coupled system"): the flux through a film at its floor is negligible, so
// a prescribed change of the volume of such a pocket would need unphysically large pressures.
#pragma once

#include "gapflow/coupling/coupling.hpp"
#include "gapflow/stepping/contact_set.hpp"

#include <functional>
#include <string>
#include <vector>

namespace gapflow {

/// Which bodies can give way to the fluid's pressure.
enum class GivesWay {
    nothing,  ///< all bodies are held to their twists
    bodies,   ///< free bodies, in any direction
    unblocked ///< free bodies, but not against the contacts that hold
};

/// Message that names the prescribed motion or inflow that changes the volume of a pocket whose only way out is between
/// surfaces that touch and that no body can relieve; empty if there is none. Films of a roughness of a hundredth of a cell or
/// more are a way
/// out. `twists`: of all solids, those of free bodies compatible with the contacts; `u`: for the inflow. Collective.
template <int D>
std::string squeezed_pocket(const Coupling<D>& coupling, const std::function<GapSettings(int, int)>& gaps,
                            const std::vector<Contact<D>>& contacts, const std::vector<Twist<D>>& twists,
                            const FluidVelocity<D>& u, GivesWay gives_way);

} // namespace gapflow
