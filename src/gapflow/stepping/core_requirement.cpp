#include "gapflow/stepping/core_requirement.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/stepping/core_check.hpp"

namespace gapflow {

template <int D>
void require_core(const Model<D>& model, const Coupling<D>& here, const std::vector<RigidBody<D>>& bodies)
{
    if (const auto outside = outside_core(model, here, bodies))
        throw InputError(model.scene.file + ": domain.core: " + *outside +
                         "; bodies that move, and gaps, stay in the core: choose a larger one, or another place");
}

template void require_core<2>(const Model<2>&, const Coupling<2>&, const std::vector<RigidBody<2>>&);
template void require_core<3>(const Model<3>&, const Coupling<3>&, const std::vector<RigidBody<3>>&);

} // namespace gapflow
