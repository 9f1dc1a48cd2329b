#include "gapflow/step/start.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/grid/side_faces.hpp"
#include "gapflow/step/gauge.hpp"
#include "gapflow/step/given_sides.hpp"
#include "gapflow/step/remainder.hpp"
#include "gapflow/step/sealed.hpp"
#include "gapflow/step/start_impact.hpp"
#include "gapflow/step/void_solve.hpp"
#include "gapflow/stepping/core_requirement.hpp"
#include "gapflow/stepping/force_parts.hpp"
#include "gapflow/stepping/placement.hpp"
#include "gapflow/stepping/start.hpp"
#include "gapflow/stepping/weight_check.hpp"

#include <utility>

namespace gapflow {
namespace {

/// The same, with nothing through walls of the domain and where inflow is given.
template <int D>
FaceField<D> within_walls(const Grid<D>& grid, FaceField<D> velocity)
{
    for (int side = 0; side < 2 * D; ++side)
        if (const SideKind kind = grid.side(side / 2, side % 2); kind == SideKind::wall || kind == SideKind::inflow)
            for_each_face_of_side(grid, side / 2, side % 2, [&](const Index<D>& f) { velocity(side / 2, f) = 0; });
    return velocity;
}

/// Of viscous fluid that bodies and the stream alone set moving: it has a remainder from the start.
template <int D>
FaceField<D> viscous_start(const Model<D>& model)
{
    FaceField<D> velocity(model.grid);
    for (int axis = 0; axis < D; ++axis)
        velocity[axis].fill(model.scene.fluid_velocity[axis]);
    return velocity;
}

/// Throws InputError.
template <int D>
void require_for_viscosity(const Model<D>& model)
{
    if (model.grid.comm().size() > 1)
        throw InputError(model.scene.file +
                         ": fluid.viscosity: this version runs gap.model = \"parts\" with viscosity on one rank; "
                         "start it on one, or write gap.model = \"film\"");
}

template <int D>
Instant<D> start_with(const Model<D>& model, State<D>& state, StepReport& report, StageTimers& timers,
                      const FaceField<D>* initial)
{
    require_weight(model.scene, state.bodies);
    for (std::string& warning : placement_warnings<D>(model.scene, state.bodies, model.walls))
        report.notes.push_back(std::move(warning));
    for (std::string& note : take_out_overlaps<D>(model.scene, model.grid, state.bodies, model.walls))
        report.notes.push_back(std::move(note));
    for (std::string& note : stop_flat_closing(model, state))
        report.notes.push_back(std::move(note));
    std::unique_ptr<Placed<D>> at;
    {
        const auto timer = timers.measure("complex");
        at = placed(model, state.bodies, model.masses(state.bodies, 0), initial);
    }
    PartVoids kept;
    if (voids_are_possible(model.scene)) {
        require_for_voids(model, initial);
        kept = starting_voids(model.grid, at->complex, at->voids);
        put_voids(model, state.bodies, model.masses(state.bodies, 0), kept.volume, *at);
        kept.drop.assign(at->voids.edges.size(), 0.0);
    }
    require_fluid(model, at->coupling);
    require_core(model, at->coupling, state.bodies);
    const auto timer = timers.measure("solve");
    state.drive.flow = initial ? Vec<D>(Vec<D>::Zero()) : to_vec<D>(model.scene.fluid_velocity);
    const std::vector<Twist<D>> twists = moved_by<D>(model.twists(state.bodies), stream_twist<D>(-state.drive.flow));
    const auto flow_of = at->voids.any() ? flow_beside_voids<D> : flow_of_twists<D>;
    PotentialFlow<D> flow =
        flow_of(*at, twists, solver_options(model.scene),
                initial ? remainder_of(*at, within_walls(model.grid, *initial)) : Remainder<D>{}, given_sides(model, 0.0));
    report.iterations = flow.iterations;
    report.solves = 1;
    if (initial) {
        renew_gauge(*at, flow, solver_options(model.scene));
        ++report.solves;
    }
    Instant<D> instant = instant_of<D>(model, state.bodies, std::move(at), std::move(flow), state.drive.flow);
    instant.kept = std::move(kept);
    state.velocity = face_velocities(instant);
    if (const std::string squeezed = squeezed_on_parts(model, *instant.placed, std::vector<Contact<D>>{},
                                                       model.twists(state.bodies), state.velocity, GivesWay::bodies);
        !squeezed.empty())
        throw ComputationError("step 1: " + squeezed);
    state.potential = instant.flow.p;
    state.remainder = instant.flow.remainder;
    state.pressure.impulse = {CellField<D>(model.grid), Eigen::VectorXd::Zero(instant.flow.p.nodes.size())};
    for (std::size_t b = 0; b < state.bodies.size(); ++b)
        state.wrenches[b] = buoyancy(model, state.bodies[b]);
    return instant;
}

} // namespace

template <int D>
Instant<D> start_on_parts(const Model<D>& model, State<D>& state, StepReport& report, StageTimers& timers,
                          const FaceField<D>* initial)
{
    if (!model.viscous())
        return start_with(model, state, report, timers, initial);
    require_for_viscosity(model);
    const FaceField<D> velocity = initial ? FaceField<D>() : viscous_start(model);
    return start_with(model, state, report, timers, initial ? initial : &velocity);
}

template Instant<2> start_on_parts<2>(const Model<2>&, State<2>&, StepReport&, StageTimers&, const FaceField<2>*);
template Instant<3> start_on_parts<3>(const Model<3>&, State<3>&, StepReport&, StageTimers&, const FaceField<3>*);

} // namespace gapflow
