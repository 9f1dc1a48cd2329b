#include "gapflow/stepping/force_parts.hpp"

#include "gapflow/coupling/film_drag.hpp"
#include "gapflow/stepping/drive.hpp"
#include "gapflow/stepping/side_pressure.hpp"

namespace gapflow {

template <int D>
Twist<D> buoyancy(const Model<D>& model, const RigidBody<D>& body)
{
    const Displacement<D> displaced = displacement(body);
    return wrench<D>(-model.scene.density * displaced.volume * model.gravity(), displaced.arm);
}

template <int D>
void add_contact_forces(const State<D>& state, double dt, std::vector<ForceParts<D>>& forces)
{
    const auto add = [&](int solid, const Twist<D>& impulse) {
        if (static_cast<std::size_t>(solid) < forces.size()) // walls come after the bodies
            forces[solid].contact += impulse / dt;
    };
    for (const Contact<D>& contact : state.contacts.contacts()) {
        if (!contact.closed)
            continue;
        const auto add_row = [&](const RelativeRow<D>& row, double impulse) {
            add(contact.point.a, impulse * row.a);
            add(contact.point.b, impulse * row.b);
        };
        add_row(contact.normal, contact.impulse);
        for (int k = 0; k < D - 1; ++k)
            add_row(contact.tangents[k], contact.tangential[k]);
    }
}

template <int D>
std::vector<ForceParts<D>> force_parts(const Model<D>& model, const Coupling<D>& there, const Projected<D>& end,
                                       const Diffusion<D>& diffusion, const Step& step, const State<D>& state)
{
    std::vector<ForceParts<D>> parts(state.bodies.size());
    for (std::size_t b = 0; b < parts.size(); ++b)
        parts[b].buoyancy = buoyancy(model, state.bodies[b]);
    if (step.dt == 0)
        return parts;
    const std::vector<Twist<D>> of_cells =
        impulses(there, UnknownVector<D>{end.impulse.cells, Eigen::VectorXd::Zero(end.impulse.nodes.size())});
    const std::vector<Twist<D>> from_beyond = wrenches_from_beyond(model, there, step.end());
    const auto add = [&](int solid, Twist<D> ForceParts<D>::*part, const Twist<D>& impulse) {
        if (static_cast<std::size_t>(solid) < parts.size()) // walls come after the bodies
            parts[solid].*part += impulse / step.dt;
    };
    for (std::size_t b = 0; b < parts.size(); ++b) {
        const int solid = static_cast<int>(b);
        add(solid, &ForceParts<D>::pressure, of_cells[b]);
        parts[b].pressure += from_beyond[b];
        if (model.driven())
            parts[b].pressure += driving_wrench(state.bodies[b], state.drive);
        if (!diffusion.impulses.empty())
            add(solid, &ForceParts<D>::shear, diffusion.impulses[b]);
    }
    std::vector<Twist<D>> of_nodes(parts.size(), Twist<D>::Zero());
    for (const BodyFlux<D, int>& entry : there.node_flux)
        if (static_cast<std::size_t>(entry.body) < parts.size())
            of_nodes[entry.body] += end.impulse.nodes[entry.row] * entry.flux / step.dt;
    model.grid.comm().sum(std::span<double>(of_nodes.data()->data(), of_nodes.size() * twist_size<D>));
    for (std::size_t b = 0; b < parts.size(); ++b)
        parts[b].film = of_nodes[b];
    if (!there.element_drag.empty()) {
        const std::vector<Twist<D>> shear = drag_impulses(there, end.twists);
        for (std::size_t b = 0; b < parts.size(); ++b)
            add(static_cast<int>(b), &ForceParts<D>::film, shear[b]);
    }
    add_contact_forces(state, step.dt, parts);
    return parts;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template void add_contact_forces<D>(const State<D>&, double, std::vector<ForceParts<D>>&);                                 \
    template Twist<D> buoyancy<D>(const Model<D>&, const RigidBody<D>&);                                                       \
    template std::vector<ForceParts<D>> force_parts<D>(const Model<D>&, const Coupling<D>&, const Projected<D>&,               \
                                                       const Diffusion<D>&, const Step&, const State<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
