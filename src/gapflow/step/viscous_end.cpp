#include "gapflow/step/viscous_end.hpp"

#include "gapflow/body/forces.hpp"
#include "gapflow/step/given_sides.hpp"
#include "gapflow/step/viscosity.hpp"
#include "gapflow/stepping/side_pressure.hpp"

namespace gapflow {

template <int D>
std::vector<Twist<D>> take_loads(const Model<D>& model, const std::vector<RigidBody<D>>& bodies,
                                 const std::vector<TwistMatrix<D>>& mass, const Coupling<D>& there, const Step& step,
                                 std::vector<Twist<D>>& forced)
{
    std::vector<Twist<D>> loads(forced.size(), Twist<D>::Zero());
    const std::vector<Twist<D>> beyond = wrenches_from_beyond(model, there, step.start + 0.5 * step.dt);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        loads[b] = step.dt * beyond[b];
        if (bodies[b].motion != Motion::free || bodies[b].spring || bodies[b].water)
            continue; // of a spring the present twist is a part
        RigidBody<D> coasting = bodies[b];
        coasting.force.setZero();
        coasting.torque.setZero();
        const Twist<D> without = forced_twist<D>(coasting, Vec<D>::Zero(), model.scene.density, step.dt);
        loads[b] += mass[b] * (forced[b] - without);
        forced[b] = without;
    }
    return loads;
}

template <int D>
void with_viscosity(const Model<D>& model, const std::vector<TwistMatrix<D>>& mass, const std::vector<Twist<D>>& loads,
                    const Step& step, State<D>& state, StepReport& report, Instant<D>& now, ViscousVoids<D>* voids)
{
    ViscousLoads<D> acting{loads};
    if (model.scene.pressure_gradient)
        acting.gradient = to_vec<D>(*model.scene.pressure_gradient);
    for (int axis = 0; axis < D; ++axis)
        acting.mean_velocity[axis] = model.kept_velocity(axis);
    const std::array<double, 2 *D> before = impulses_beyond(model, step.start), after = impulses_beyond(model, step.landing);
    for (int side = 0; side < 2 * D; ++side)
        acting.sides[side] = after[side] - before[side];
    const ViscousStep<D> viscous =
        add_viscosity(*now.placed, mass, acting, model.scene.viscosity, step.dt, model.scene.tolerance, now.flow, voids);
    state.drive.gradient = viscous.gradient;
    for (std::size_t b = 0; b < state.bodies.size(); ++b)
        state.wrenches[b] += viscous.impulse[b] / step.dt;
    now.friction = viscous.friction;
    for (std::vector<Twist<D>>* parts : {&now.friction.bulk, &now.friction.gaps})
        for (Twist<D>& one : *parts)
            one /= step.dt;
    report.viscous_iterations = viscous.iterations;
    report.dissipation_grid = viscous.dissipated / step.dt;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template std::vector<Twist<D>> take_loads<D>(const Model<D>&, const std::vector<RigidBody<D>>&,                            \
                                                 const std::vector<TwistMatrix<D>>&, const Coupling<D>&, const Step&,          \
                                                 std::vector<Twist<D>>&);                                                      \
    template void with_viscosity<D>(const Model<D>&, const std::vector<TwistMatrix<D>>&, const std::vector<Twist<D>>&,         \
                                    const Step&, State<D>&, StepReport&, Instant<D>&, ViscousVoids<D>*);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
