#include "gapflow/stepping/motion.hpp"

#include "gapflow/body/forces.hpp"
#include "gapflow/body/move.hpp"
#include "gapflow/stepping/drive.hpp"
#include "gapflow/stepping/extrapolation_share.hpp"

#include <algorithm>

namespace gapflow {

namespace {

constexpr int most_separations = 10; // to remove the overlaps of a step

// Of a free body after all forces but the fluid's answer to its motion.
template <int D>
Twist<D> forced(const Model<D>& model, const RigidBody<D>& body, const Drive<D>& drive, const Step& step)
{
    Twist<D> V = forced_twist<D>(body, model.gravity(), model.scene.density, step.dt);
    if (model.driven())
        V += impulse_response(body, Twist<D>(step.dt * driving_wrench(body, drive)), step.dt);
    return V;
}

// The part of body b's acceleration in a step with impacts that is extrapolated: nothing of one that they have changed. `met`: whether the body
// had one, `impact`: their impulse on it. A heavy body that a light one strikes goes on as it was.
template <int D>
double lasting_after_impacts(const Model<D>& model, const State<D>& state, std::size_t b, bool met, const Twist<D>& impact,
                             const Twist<D>& acceleration, const Step& step)
{
    const RigidBody<D>& body = state.bodies[b];
    if (body.motion != Motion::free)
        return met ? 0.0 : 1.0;
    const Twist<D> by_forces = (forced(model, body, state.drive, step) - body.twist) / step.dt;
    if (met) {
        const Twist<D> by_impact = impulse_response(body, impact, step.dt) / step.dt;
        const TwistMatrix<D> mass = mass_matrix(body);
        const auto square = [&](const Twist<D>& change) { return change.dot(mass * change); };
        if (was_reversed(state, static_cast<int>(b)) || square(by_impact) >= slight_impact * slight_impact * square(by_forces))
            return 0;
    }
    return lasting_part(body, acceleration, state.acceleration[b],
                        std::max(model.gravity().norm(), by_forces.template head<D>().norm()));
}

} // namespace

// An acceleration found in a much shorter step is not extrapolated over the whole step.
template <int D>
std::vector<RigidBody<D>> moved(std::vector<RigidBody<D>> bodies, const Step& step)
{
    const double share = extrapolation_share(step.last_dt, step.dt);
    for (RigidBody<D>& body : bodies) {
        body.acceleration *= share;
        body.angular_momentum_rate *= share;
        if (body.motion == Motion::prescribed)
            body.twist = predicted_twist(body, step.start, step.dt);
        move(body, step.start, step.dt);
    }
    return bodies;
}

// Overlaps are removed repeatedly where displaced bodies overlap others, or turn so far that their contact points change.
template <int D>
void find_contacts(const Model<D>& model, State<D>& state, const Step& step)
{
    auto find = [&] { state.contacts.find(model.solids(state.bodies), model.twists(state.bodies), step.dt); };
    const ContactSet<D> before = model.scene.parts ? state.contacts : ContactSet<D>();
    find();
    for (int pass = 0; pass < most_separations && state.contacts.separate(state.bodies); ++pass) {
        if (model.scene.parts)
            state.contacts = before; // by whose rows the rates before the step are known
        find();
    }
}

template <int D>
std::vector<Twist<D>> predicted_twists(const Model<D>& model, const std::vector<RigidBody<D>>& bodies, const Step& step)
{
    std::vector<Twist<D>> V = model.twists(bodies);
    for (std::size_t b = 0; b < bodies.size(); ++b)
        V[b] = predicted_twist(bodies[b], step.start, step.dt);
    return V;
}

template <int D>
std::vector<Twist<D>> forced_twists(const Model<D>& model, const std::vector<RigidBody<D>>& bodies, const Drive<D>& drive,
                                    const Step& step)
{
    std::vector<Twist<D>> V = model.twists(bodies);
    for (std::size_t b = 0; b < bodies.size(); ++b)
        if (bodies[b].motion == Motion::free)
            V[b] = forced(model, bodies[b], drive, step);
    return V;
}

template <int D>
bool finish_bodies(const Model<D>& model, const std::vector<Twist<D>>& V, const Step& step, State<D>& state)
{
    std::vector<char> met(state.bodies.size());
    for (std::size_t b = 0; b < met.size(); ++b)
        met[b] = met_something(state, static_cast<int>(b));
    const bool any_met = std::find(met.begin(), met.end(), 1) != met.end();
    std::vector<Twist<D>> impacts;
    if (any_met)
        impacts = state.contacts.impact_impulses(V.size());
    for (std::size_t b = 0; b < state.bodies.size(); ++b) {
        RigidBody<D>& body = state.bodies[b];
        const Twist<D> change = (V[b] - body.twist) / step.dt;
        const double lasting = any_met ? lasting_after_impacts(model, state, b, met[b], impacts[b], change, step) : 1.0;
        state.acceleration[b] = lasting * change;
        if (body.motion == Motion::free)
            finish_step(body, V[b], step.dt, lasting);
    }
    return any_met;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template std::vector<RigidBody<D>> moved<D>(std::vector<RigidBody<D>>, const Step&);                                       \
    template void find_contacts<D>(const Model<D>&, State<D>&, const Step&);                                                   \
    template std::vector<Twist<D>> predicted_twists<D>(const Model<D>&, const std::vector<RigidBody<D>>&, const Step&);        \
    template std::vector<Twist<D>> forced_twists<D>(const Model<D>&, const std::vector<RigidBody<D>>&, const Drive<D>&,        \
                                                    const Step&);                                                              \
    template bool finish_bodies<D>(const Model<D>&, const std::vector<Twist<D>>&, const Step&, State<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
