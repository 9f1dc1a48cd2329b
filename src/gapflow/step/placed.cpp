#include "gapflow/step/placed.hpp"

#include "gapflow/complex/gap_arm.hpp"
#include "gapflow/complex/mouth_arm.hpp"
#include "gapflow/coupling/pressure_gauge.hpp"
#include "gapflow/stepping/standoff.hpp"

#include <algorithm>
#include <utility>

namespace gapflow {

template <int D>
std::unique_ptr<Placed<D>> placed(const Model<D>& model, const std::vector<RigidBody<D>>& bodies,
                                  const std::vector<TwistMatrix<D>>& mass, bool observed)
{
    auto result = std::make_unique<Placed<D>>();
    const auto [solids, standoffs] = rough_solids<D>(model.scene, model.grid, model.solids(bodies));
    result->complex = build_complex<D>(model.grid, solids, &result->derivatives);
    const Complex<D>& complex = result->complex;
    result->arms = find_gap_arms<D>(model.grid, solids, complex, standoffs);
    const Inertia<D> inertia =
        find_inertia<D>(model.grid, complex, result->arms, find_mouth_arms<D>(model.grid, solids, complex, standoffs));
    result->pairs = inertia.pairs;
    result->coupling = couple_parts<D>(model.grid, solids, mass, model.scene.density, complex, inertia);
    add_seen_mass(result->coupling);
    if (observed) {
        result->coupling.clipper =
            std::make_shared<FaceClipper<D>>(model.grid, result->coupling.solids, FractionMode::cut_cell);
        result->coupling.fractions = std::make_shared<FaceFractions<D>>(face_fractions(model.grid, *result->coupling.clipper));
    }
    result->node = result->coupling.part_node;
    return result;
}

template <int D>
Coupling<D> with_given_twists(Coupling<D> coupling)
{
    coupling.system.bodies = 0;
    std::fill(coupling.free_body.begin(), coupling.free_body.end(), -1);
    coupling.system.cell_flux.clear();
    coupling.system.node_flux.clear();
    coupling.system.mass.resize(0, 0);
    coupling.gauge_cells.clear();
    coupling.gauge_nodes.clear();
    find_components(coupling);
    return coupling;
}

template std::unique_ptr<Placed<2>> placed<2>(const Model<2>&, const std::vector<RigidBody<2>>&,
                                              const std::vector<TwistMatrix<2>>&, bool);
template std::unique_ptr<Placed<3>> placed<3>(const Model<3>&, const std::vector<RigidBody<3>>&,
                                              const std::vector<TwistMatrix<3>>&, bool);
template Coupling<2> with_given_twists<2>(Coupling<2>);
template Coupling<3> with_given_twists<3>(Coupling<3>);

} // namespace gapflow
