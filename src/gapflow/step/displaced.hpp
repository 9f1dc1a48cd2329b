// dT/dx by differences of the energy over a way, where the closed form (complex/energy_derivative) is not that of this way: of solids whose gaps end at sharp
// edges, since it does not know the lines and planes that divide the fluid there, and of those of whose motion a face opens or closes within the way.
#pragma once

#include "gapflow/step/energy_terms.hpp"

#include <vector>

namespace gapflow {

/// A solid a little to both sides of its place.
template <int D>
struct Displaced {
    int solid, component;
    bool mouth; ///< not for a steep face alone
    double way; ///< from one side to the other; a length or an angle
    EnergyTerms<D> low, high;
};

/// All components in which the bodies move that have mouths at their gaps, and of any body those that open or close a face of the grid within the way, to first order.
/// `at`: of the bodies where they are. Collective.
template <int D>
std::vector<Displaced<D>> displaced(const Model<D>& model, const std::vector<RigidBody<D>>& bodies, const Placed<D>& at);

/// Of each solid, whether a component of its force is left by replace_forces().
template <int D>
std::vector<char> not_replaced(const std::vector<Displaced<D>>& displaced, std::size_t solids);
/// Leaves those of steep faces alone: the forces at mouths are then the closed form's.
template <int D>
void leave_mouths(std::vector<Displaced<D>>& displaced)
{
    std::erase_if(displaced, [](const Displaced<D>& one) { return one.mouth; });
}
/// Replaces the forces of these solids. Collective.
template <int D>
void replace_forces(const std::vector<Displaced<D>>& displaced, const PotentialFlow<D>& flow, std::vector<Twist<D>>& force);

} // namespace gapflow
