// Fluid that surfaces in contact shut in (method, "The coupled system"): a film at its floor lets next to nothing through, so what changes
// the volume of such a pocket has no solution but pressures beyond all sense.
#pragma once

#include "gapflow/coupling/coupling.hpp"
#include "gapflow/stepping/contact_set.hpp"

#include <functional>
#include <string>
#include <vector>

namespace gapflow {

/// Who can give way to the fluid's pressure.
enum class GivesWay {
    nothing,  ///< all bodies are held to their twists
    bodies,   ///< free bodies, wherever they go
    unblocked ///< free bodies, but not against the contacts that hold
};

/// Says which prescribed motion or inflow changes the volume of which pocket, if one has no way out but between surfaces that
/// touch, and no body can give way; empty if there is none. Films of a roughness of a hundredth of a cell or more are a way
/// out. `twists`: of all solids, those of free bodies such as contacts allow; `u`: the inflow counts. Collective.
template <int D>
std::string squeezed_pocket(const Coupling<D>& coupling, const std::function<GapSettings(int, int)>& gaps,
                            const std::vector<Contact<D>>& contacts, const std::vector<Twist<D>>& twists,
                            const FluidVelocity<D>& u, GivesWay gives_way);

} // namespace gapflow
