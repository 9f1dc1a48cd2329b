// Fluid enclosed by surfaces in contact (method, "The coupled system"): the flux through a film at its floor is negligible, so
// a prescribed change of the volume of such a pocket would need unphysically large pressures.
#pragma once

#include "gapflow/coupling/coupling.hpp"
#include "gapflow/stepping/contact_set.hpp"

#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace gapflow {

/// Which bodies can give way to the fluid's pressure.
enum class GivesWay {
    nothing,  ///< all bodies are held to their twists
    bodies,   ///< free bodies, in any direction
    unblocked ///< free bodies, but not against the contacts that hold
};

/// Where surfaces touch and do not part.
template <int D>
class TouchingGaps {
public:
    /// `twists`: of all solids; `u`: for the inflow. Collective.
    TouchingGaps(const Coupling<D>& coupling, std::function<GapSettings(int, int)> gaps,
                 const std::vector<Contact<D>>& contacts, const std::vector<Twist<D>>& twists, const FluidVelocity<D>& u);
    /// At which the gap of two solids counts as shut; negative: at none.
    double thickest(int a, int b) const;
    /// Whether walls part that open at this speed.
    bool part(double speed) const;

private:
    std::function<GapSettings(int, int)> gaps_;
    std::map<std::pair<int, int>, double> held_; ///< largest distance at which a pair's contacts hold
    double fastest_, dx_;
};

/// Whether something prescribed moves, or the inflow is, that may change a volume.
template <int D>
bool anything_prescribed(const Coupling<D>& coupling, const std::vector<Twist<D>>& twists, GivesWay gives_way);

/// Message that names the prescribed motion or inflow that changes the volume of a pocket whose only way out is between
/// surfaces that touch and that no body can relieve; empty if there is none. Films of a roughness of a hundredth of a cell or
/// more are a way
/// out. `twists`: of all solids, those of free bodies compatible with the contacts; `u`: for the inflow. Collective.
template <int D>
std::string squeezed_pocket(const Coupling<D>& coupling, const std::function<GapSettings(int, int)>& gaps,
                            const std::vector<Contact<D>>& contacts, const std::vector<Twist<D>>& twists,
                            const FluidVelocity<D>& u, GivesWay gives_way);

/// The same in a system in which shut gaps connect nothing. `within`: the components in such gaps; `pairs`: of solids that touch. Collective.
template <int D>
std::string squeezed_pocket(const Coupling<D>& coupling, const std::vector<char>& within,
                            const std::set<std::pair<int, int>>& pairs, const std::vector<Contact<D>>& contacts,
                            const std::vector<Twist<D>>& twists, const FluidVelocity<D>& u, GivesWay gives_way);

} // namespace gapflow
