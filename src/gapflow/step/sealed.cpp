#include "gapflow/step/sealed.hpp"

#include "gapflow/core/sharing.hpp"
#include "gapflow/coupling/parts.hpp"

#include <set>
#include <utility>

namespace gapflow {
namespace {

template <int D>
Twist<D> in_cells(Twist<D> twist, double dx)
{
    twist.template tail<spin_size<D>>() *= dx;
    return twist;
}

/// Arms of gaps that touch and do not part.
template <int D>
std::vector<const GapArm<D>*> shut_arms(const Placed<D>& at, const TouchingGaps<D>& touching,
                                        const std::vector<Twist<D>>& twists)
{
    const double dx = at.coupling.grid->dx();
    std::vector<const GapArm<D>*> shut;
    for (const GapArm<D>& arm : at.arms) {
        PairTwist<D> pair;
        pair << in_cells<D>(twists[arm.solid[0]], dx), in_cells<D>(twists[arm.solid[1]], dx);
        if (arm.thickness * dx <= touching.thickest(arm.solid[0], arm.solid[1]) && !touching.part(arm.opening.dot(pair)))
            shut.push_back(&arm);
    }
    return shut;
}

/// The coupled system with nothing through these arms.
template <int D>
Coupling<D> without_arms(const Model<D>& model, const Placed<D>& at, const std::vector<const GapArm<D>*>& arms)
{
    Inertia<D> inertia = find_inertia<D>(model.grid, at.complex, at.arms);
    for (const GapArm<D>* arm : arms) {
        const FacePiece<D>& piece = at.complex.pieces[arm->piece];
        inertia.piece_weight[arm->piece] = 0;
        if (at.complex.joins_main(piece))
            inertia.main_weight[piece.axis][piece.face] = 0;
    }
    const std::vector<TwistMatrix<D>> mass(at.coupling.solids.size(), TwistMatrix<D>::Identity());
    return couple_parts<D>(model.grid, at.coupling.solids, mass, model.scene.density, at.complex, inertia);
}

/// The components of which all rows are beside these arms.
template <int D>
std::vector<char> within_gaps(const Coupling<D>& coupling, const Complex<D>& complex, const std::vector<const GapArm<D>*>& arms)
{
    const Grid<D>& grid = *coupling.grid;
    std::vector<char> beside(complex.parts(), 0);
    for (const GapArm<D>* arm : arms)
        for (const PartOrCell& side : {complex.pieces[arm->piece].low, complex.pieces[arm->piece].high})
            if (side.is_part())
                beside[side.number()] = 1;
    CellField<D, char> cell_beside(grid, 0);
    std::vector<char> node_beside(coupling.system.nodes, 0);
    for (std::int32_t part = 0; part < complex.parts(); ++part)
        if (beside[part] && coupling.part_node[part] >= 0)
            node_beside[coupling.part_node[part]] = 1;
        else if (beside[part] && complex.is_main(part) && grid.owns(complex.cell_of_part(part)))
            cell_beside(complex.cell_of_part(part)) = 1;
    std::vector<double> outside(coupling.system.components.size(), 0.0);
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
        if (const int k = coupling.system.component(c); k >= 0 && !cell_beside(c))
            outside[k] = 1;
    });
    for (int node = 0; node < coupling.system.nodes; ++node)
        if (coupling.system.owns(node) && !node_beside[node])
            outside[coupling.system.node_component[node]] = 1;
    grid.comm().max(outside);
    std::vector<char> within;
    for (const double any : outside)
        within.push_back(any == 0);
    return within;
}

/// The two solids of each arm, of all ranks.
template <int D>
std::set<std::pair<int, int>> pairs_of(const Grid<D>& grid, const std::vector<const GapArm<D>*>& arms)
{
    std::set<std::pair<int, int>> own;
    for (const GapArm<D>* arm : arms)
        own.insert(std::minmax<int>(arm->solid[0], arm->solid[1]));
    const auto all = all_values(grid.comm(), std::vector<std::pair<int, int>>(own.begin(), own.end()));
    return {all.begin(), all.end()};
}

} // namespace

template <int D>
std::string squeezed_on_parts(const Model<D>& model, const Placed<D>& at, const std::vector<Contact<D>>& contacts,
                              const std::vector<Twist<D>>& twists, const FluidVelocity<D>& u, GivesWay gives_way)
{
    if (at.voids.any() || !anything_prescribed(at.coupling, twists, gives_way)) // voids give way
        return {};
    const auto arms = shut_arms(at, TouchingGaps<D>(at.coupling, model.gaps, contacts, twists, u), twists);
    if (!model.grid.comm().any(!arms.empty()))
        return {};
    const Coupling<D> shut = without_arms(model, at, arms);
    return squeezed_pocket(shut, within_gaps(shut, at.complex, arms), pairs_of(model.grid, arms), contacts, twists, u,
                           gives_way);
}

template std::string squeezed_on_parts<2>(const Model<2>&, const Placed<2>&, const std::vector<Contact<2>>&,
                                          const std::vector<Twist<2>>&, const FluidVelocity<2>&, GivesWay);
template std::string squeezed_on_parts<3>(const Model<3>&, const Placed<3>&, const std::vector<Contact<3>>&,
                                          const std::vector<Twist<3>>&, const FluidVelocity<3>&, GivesWay);

} // namespace gapflow
