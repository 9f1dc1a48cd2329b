#include "gapflow/step/advance.hpp"

#include "gapflow/body/forces.hpp"
#include "gapflow/core/error.hpp"
#include "gapflow/coupling/pressure_gauge.hpp"
#include "gapflow/step/energy_change.hpp"
#include "gapflow/step/force_passes.hpp"
#include "gapflow/step/gauge.hpp"
#include "gapflow/step/given_sides.hpp"
#include "gapflow/step/mean_flow.hpp"
#include "gapflow/step/pressure.hpp"
#include "gapflow/step/remainder.hpp"
#include "gapflow/step/sealed.hpp"
#include "gapflow/step/viscosity.hpp"
#include "gapflow/step/viscous_end.hpp"
#include "gapflow/step/void_solve.hpp"
#include "gapflow/step/vorticity.hpp"
#include "gapflow/stepping/drive.hpp"
#include "gapflow/stepping/following.hpp"
#include "gapflow/stepping/force_parts.hpp"
#include "gapflow/stepping/motion.hpp"
#include "gapflow/stepping/side_pressure.hpp"
#include "gapflow/stepping/unilateral.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

namespace gapflow {
namespace {

// Of the energy, by which a step may miss the work that is done: then its forces are found once more.
constexpr double energy_accuracy = 1e-5;
// What may be left after the last pass; with more the forces are those of a place at which the energy jumps.
constexpr double most_missed = 1e-2;
constexpr int most_passes = 6;
constexpr int passes_of_work = 3;
// Of a body's energy at its mean velocity, that at the velocity with which it went: half as fast.
constexpr double starting = 0.25;

template <int D>
std::vector<Twist<D>> trapezium(const std::vector<Twist<D>>& a, const std::vector<Twist<D>>& b, double dt)
{
    std::vector<Twist<D>> mean;
    for (std::size_t s = 0; s < a.size(); ++s)
        mean.push_back(0.5 * dt * (a[s] + b[s]));
    return mean;
}

/// Mean twist with which a body went from one place to another one.
template <int D>
Twist<D> twist_of_way(const RigidBody<D>& from, const RigidBody<D>& to, double dt)
{
    Twist<D> way;
    way.template head<D>() = to.centre() - from.centre();
    const Rotation<D> turn(to.pose.rotation * from.pose.rotation.inverse());
    if constexpr (D == 2)
        way[2] = std::remainder(turn.angle(), 2 * std::numbers::pi);
    else {
        const Eigen::AngleAxisd about(turn);
        way.template tail<3>() = std::remainder(about.angle(), 2 * std::numbers::pi) * about.axis();
    }
    return way / dt;
}

/// Of the fluid and of free bodies.
template <int D>
double energy_of(const Instant<D>& at, const std::vector<RigidBody<D>>& bodies)
{
    double energy = at.energy;
    for (const RigidBody<D>& body : bodies)
        energy += body.motion == Motion::free ? kinetic_energy(body) : 0.0;
    return energy;
}

/// Its components along the axes that the grid follows.
template <int D>
Twist<D> along_grid(const FollowedBody<D>& followed, const Twist<D>& twist)
{
    Twist<D> along = Twist<D>::Zero();
    for (int axis = 0; axis < D && followed.body >= 0; ++axis)
        along[axis] = followed.axes[axis] ? twist[axis] : 0.0;
    return along;
}

/// Impulses of the free bodies that do the work which the trapezium of the forces, `mean`, misses of 1/2 V (N' - N) V': in each group of bodies in proportion to their own
/// momenta M V_m, V_m the mean twist. Where bodies turn back within the step, so that their energy at V_m is small, no larger than at half their speeds.
/// Where the grid goes with a body, `grid` its velocity, V_m is that over the grid, and this body takes the reactions and does `work_of_grid`, the work of the
/// vorticity under the grid. What goes with `negligible` energy is let alone: a body that contacts hold has round-off for a direction, and an impulse
/// that does work along it has no bound. `impacts`: of contacts that change velocities, none if empty: they give back what the
/// forces err in their directions, so that what is missing is told from their own work only where it is more than that.
template <int D>
std::vector<Twist<D>> missing_impulses(const std::vector<RigidBody<D>>& bodies_before, const Instant<D>& before,
                                       const std::vector<RigidBody<D>>& bodies, const Instant<D>& after,
                                       const std::vector<Twist<D>>& mean, const std::vector<Twist<D>>& impacts,
                                       const Twist<D>& grid, double work_of_grid, double negligible, double dt)
{
    const Twist<D> stream = stream_twist<D>(before.stream), end_stream = stream_twist<D>(after.stream);
    EnergyChange change = energy_change(*before.placed, before.flow, *after.placed, after.flow,
                                        Twist<D>(stream - grid)); // bodies move over the grid with their whole velocities
    std::vector<double> square(change.work.size(), 0.0), of_impacts = square;
    std::vector<Twist<D>> impulse(mean.size(), Twist<D>::Zero());
    const FollowedBody<D>& followed = before.followed;
    Twist<D> lead = Twist<D>::Zero(), mean_of_all = Twist<D>::Zero();
    if (followed.body >= 0) {
        const int b = followed.body;
        lead = along_grid(followed,
                          Twist<D>(0.5 * (before.flow.twists[b] + after.flow.twists[b]) + stream)); // which does not change
        for (const Twist<D>& one : mean)
            mean_of_all += one;
    }
    const bool takes_reactions = followed.body >= 0 && bodies[followed.body].motion == Motion::free;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const int group = change.group[b];
        if (group < 0)
            continue;
        const bool leads = static_cast<int>(b) == followed.body;
        const Twist<D> V = before.flow.twists[b] + stream, next = after.flow.twists[b] + end_stream;
        const Twist<D> of_grid = leads ? along_grid(followed, V) : lead,
                       next_of_grid = leads ? along_grid(followed, next) : lead;
        const Twist<D> start = V - of_grid, end = next - next_of_grid, middle = 0.5 * (V + next) - lead;
        const TwistMatrix<D> mass = mass_matrix(bodies[b]);
        // A body that starts has not gone the way that its mean velocity asks for, and N has not changed: it would be held back.
        const Twist<D> went = twist_of_way(bodies_before[b], bodies[b], dt) - grid;
        const bool starts = went.dot(mass * went) < starting * middle.dot(mass * middle);
        change.work[group] -= (starts ? went : middle).dot(mean[b]);
        if (!impacts.empty())
            of_impacts[group] += middle.dot(impacts[b]);
        if (leads)
            change.work[group] +=
                work_of_grid + 0.5 * dt * lead.template head<D>().dot(before.of_sides + after.of_sides) - lead.dot(mean_of_all);
        if (bodies[b].motion == Motion::free) {
            change.work[group] += 0.5 * V.dot((mass - mass_matrix(bodies_before[b])) * next);
            impulse[b] = mass * middle;
            square[group] += std::max(middle.dot(impulse[b]), 0.125 * (start.dot(mass * start) + end.dot(mass * end)));
        } else if (takes_reactions) {
            const Twist<D> along = along_grid(followed, middle);
            impulse[b] = along_grid(followed, Twist<D>(mass_matrix(bodies[followed.body]) * along));
            square[group] += along.dot(impulse[b]);
        }
    }
    for (std::size_t group = 0; group < change.work.size(); ++group) {
        double& work = change.work[group];
        work = std::copysign(std::max(0.0, std::abs(work) - std::abs(of_impacts[group])), work);
    }
    for (std::size_t b = 0; b < bodies.size(); ++b)
        if (const int group = change.group[b]; group >= 0 && square[group] > 0)
            impulse[b] *= square[group] > negligible ? change.work[group] / square[group] : 0.0;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (takes_reactions && static_cast<int>(b) != followed.body)
            impulse[followed.body] -= along_grid(followed, impulse[b]);
        if (bodies[b].motion != Motion::free)
            impulse[b].setZero();
    }
    return impulse;
}

/// Twists before the fluid acts, with all impulses but its pressure's.
template <int D>
Intermediate<D> intermediate(const Model<D>& model, const Instant<D>& old, const Placed<D>& there, const Coupling<D>& system,
                             const Vec<D>& end_stream, const Remainder<D>& remainder, const GivenSides<D>& sides,
                             const std::vector<Twist<D>>& forced, const StepForces<D>& forces, const State<D>& state, double dt)
{
    Intermediate<D> star;
    star.velocity.grid = remainder.empty() ? FaceField<D>(model.grid) : remainder.faces;
    star.twists = star.forced = forced;
    std::vector<Twist<D>> given = impulses_of_given(system, forced);
    const auto add = [&](const std::vector<Twist<D>>& impulse, double factor) {
        for (std::size_t b = 0; b < given.size(); ++b)
            given[b] += factor * impulse[b];
    };
    if (!end_stream.isZero(0)) { // the system is that of the whole motion, the flow that of what is relative to the stream
        const Twist<D> stream = stream_twist<D>(end_stream);
        const std::vector<Twist<D>> rest(given.size(), Twist<D>::Zero());
        star.outflow = flux_of_twists(system, moved_by<D>(rest, -stream));
        add(impulses_of_outflow(system, star.outflow), 1);
        const UnknownVector<D> none{CellField<D>(model.grid), Eigen::VectorXd::Zero(there.coupling.system.nodes)};
        add(fluid_impulse(there, PotentialFlow<D>{moved_by<D>(rest, stream), none, 0, {}}), 1);
    }
    if (!remainder.empty()) {
        UnknownVector<D> outflow = outflow_of_edges(there, remainder);
        add_to(star.outflow, outflow);
        add_to(outflow, outflow_of_faces(there, remainder));
        add(impulses_of_outflow(system, outflow), 1);
        add(impulse_of_remainder(there, remainder), -1);
    }
    if (sides.any()) {
        const UnknownVector<D> outflow = outflow_of_sides(there, sides);
        add(impulses_of_outflow(system, outflow), 1);
        add_to(star.outflow, outflow);
    }
    if (sides.any() && !model.viscous()) {
        const std::vector<Twist<D>> beyond = wrenches_from_beyond(model, there.coupling, state.time + 0.5 * dt);
        for (std::size_t b = 0; b < beyond.size(); ++b)
            given[b] += dt * beyond[b];
    }
    for (std::size_t b = 0; b < state.bodies.size(); ++b)
        if (state.bodies[b].motion == Motion::free)
            star.twists[b] +=
                impulse_response(state.bodies[b], Twist<D>(old.impulse[b] + forces.mean[b] + forces.missing[b] + given[b]), dt);
    return star;
}

/// Adds what leaves rows without pressure, and impulses on the solids.
template <int D>
void add_outflow(const Coupling<D>& system, const UnknownVector<D>& outflow, const std::vector<Twist<D>>& impulse, double dt,
                 const std::vector<RigidBody<D>>& bodies, Intermediate<D>& star)
{
    if (impulse.empty())
        return;
    const std::vector<Twist<D>> of_outflow = impulses_of_outflow(system, outflow);
    for (std::size_t b = 0; b < bodies.size(); ++b)
        if (bodies[b].motion == Motion::free)
            star.twists[b] += impulse_response(bodies[b], Twist<D>(impulse[b] + of_outflow[b]), dt);
    add_to(star.outflow, outflow);
}

/// The forces that follow from the flow at the step's end.
template <int D>
StepForces<D> forces_of(const Instant<D>& old, const std::vector<RigidBody<D>>& before, const Instant<D>& now,
                        const std::vector<RigidBody<D>>& bodies, const std::vector<Twist<D>>& impacts, const Twist<D>& grid,
                        double work_of_grid, double negligible, double dt)
{
    StepForces<D> forces{trapezium<D>(old.force, now.force, dt), {}};
    forces.missing = missing_impulses(before, old, bodies, now, forces.mean, impacts, grid, work_of_grid, negligible, dt);
    return forces;
}

/// Work of impulses on the free bodies' mean twists, and the sum of its magnitudes.
struct Work {
    double sum = 0, magnitude = 0;
};
template <int D, class Impulse>
Work work_of(const Impulse& impulse, const std::vector<RigidBody<D>>& bodies, const Instant<D>& old, const Instant<D>& now)
{
    Work work;
    for (std::size_t b = 0; b < bodies.size(); ++b)
        if (bodies[b].motion == Motion::free) {
            const double own = 0.5 * (old.flow.twists[b] + now.flow.twists[b]).dot(impulse(b));
            work.sum += own;
            work.magnitude += std::abs(own);
        }
    return work;
}

/// Mean of the fluid's force on every body: what the bodies' own momenta get.
template <int D>
std::vector<Twist<D>> fluid_wrenches(const Model<D>& model, const Instant<D>& old, const Instant<D>& now,
                                     const StepForces<D>& forces, const std::vector<RigidBody<D>>& bodies,
                                     const Drive<D>& drive, double time, double dt)
{
    std::vector<Twist<D>> wrenches = wrenches_from_beyond(model, now.placed->coupling, time);
    for (std::size_t b = 0; b < bodies.size(); ++b)
        wrenches[b] += buoyancy(model, bodies[b]) + driving_wrench(bodies[b], drive) +
                       (forces.mean[b] + forces.missing[b] - (now.impulse[b] - old.impulse[b])) / dt;
    return wrenches;
}

/// The instant of the step's end, its flow not known yet.
template <int D>
Instant<D> at_new_places(const Model<D>& model, const std::vector<RigidBody<D>>& before, Instant<D>& old,
                         const std::vector<RigidBody<D>>& bodies, const std::vector<TwistMatrix<D>>& mass, const Step& step,
                         StepReport& report, StageTimers& timers)
{
    Instant<D> now;
    now.followed = old.followed;
    now.flow.sides = given_sides(model, step.landing);
    const bool rotational = !old.flow.remainder.empty();
    {
        const auto timer = timers.measure("complex");
        const VoidsBefore<D> voids{old.kept, old.placed->complex, old.placed->voids};
        now.placed = placed(model, bodies, mass, rotational, &voids);
    }
    if (const std::vector<std::int32_t>& lost = now.placed->voids.lost; !lost.empty()) {
        const auto timer = timers.measure("voids");
        fill_lost(model, before, model.masses(before, step.dt), lost, old);
        report.notes.push_back("the place of a void is gone: it is filled at once");
    }
    now.kept.lost = old.kept.lost;
    const auto timer = timers.measure("forces");
    if (!now.placed->voids.any()) // else their energies would not know them
        now.displaced = displaced(model, bodies, *now.placed);
    return now;
}

/// The flow of the step's end, with the voids in gaps.
template <int D>
void find_flow(const typename VoidSolve<D>::Solve& solve, VoidSolve<D>& voids, int pass, Instant<D>& now)
{
    if (!now.placed->voids.parts.empty()) {
        const std::optional<PotentialFlow<D>> last = pass > 1 ? std::optional(now.flow) : std::nullopt;
        voids.find(solve, last ? &*last : nullptr, now.flow);
        if (voids.any())
            now.displaced.clear(); // they do not know voids
        return;
    }
    Projected<D> end = solve(now.placed->coupling, {}, {});
    now.flow.twists = std::move(end.twists);
    now.flow.p = std::move(end.impulse);
    leave_gauge(now.placed->coupling, now.flow.twists, now.flow.p);
    now.flow.twists = moved_by<D>(std::move(now.flow.twists), -stream_twist<D>(now.stream));
    settle_weak_rows(*now.placed, now.flow);
}

/// Contacts again, after loads and viscosity have acted on the bodies.
template <int D>
void meet_again(const Model<D>& model, const ContactSet<D>& contacts, const std::vector<TwistMatrix<D>>& mass, const Step& step,
                VoidSolve<D>& voids, State<D>& state, StepReport& report, StageTimers& timers, Instant<D>& now)
{
    Instant<D> start;
    start.impulse = fluid_impulse(*now.placed, now.flow);
    const std::vector<Twist<D>> none(start.impulse.size(), Twist<D>::Zero());
    Coupling<D>& system = now.placed->coupling;
    const ContactSet<D> first = std::exchange(state.contacts, contacts);
    state.pressure.impulse = {CellField<D>(model.grid), {}};
    const std::vector<Twist<D>> forced = now.flow.twists;
    const auto solve = [&](Coupling<D>& beside, const UnknownVector<D>& outflow, const std::vector<Twist<D>>& impulse) {
        Intermediate<D> star = intermediate(model, start, *now.placed, beside, now.stream, now.flow.remainder, now.flow.sides,
                                            forced, StepForces<D>{none, none}, state, step.dt);
        add_outflow(beside, outflow, impulse, step.dt, state.bodies, star);
        return project(model, beside, std::move(star), mass, step, state, report, timers);
    };
    if (voids.any())
        voids.meet(solve, now);
    else {
        Projected<D> end = solve(system, {}, {});
        now.flow.twists = std::move(end.twists);
        now.flow.p = std::move(end.impulse);
        leave_gauge(system, now.flow.twists, now.flow.p);
        settle_weak_rows(*now.placed, now.flow);
    }
    state.contacts.add_impulses(first);
    const std::vector<Twist<D>> impulse = fluid_impulse(*now.placed, now.flow);
    for (std::size_t b = 0; b < state.bodies.size(); ++b)
        state.wrenches[b] -= (impulse[b] - start.impulse[b]) / step.dt;
}

/// Loads, viscosity and contacts, with the voids that hold at the end.
template <int D>
void end_with_viscosity(const Model<D>& model, const ContactSet<D>& contacts, const std::vector<TwistMatrix<D>>& mass,
                        const std::vector<Twist<D>>& loads, const Step& step, VoidSolve<D>& voids, State<D>& state,
                        StepReport& report, StageTimers& timers, Instant<D>& now)
{
    const bool possible = !now.placed->voids.parts.empty();
    const PotentialFlow<D> ideal = now.flow;
    const ContactSet<D> met = state.contacts;
    const std::vector<Twist<D>> wrenches = state.wrenches;
    if (possible)
        voids.begin_viscosity(ideal);
    for (int round = 0;; ++round) {
        {
            const auto timer = timers.measure("viscosity");
            ViscousVoids<D> beside = possible ? voids.beside() : ViscousVoids<D>{};
            with_viscosity(model, mass, loads, step, state, report, now, possible ? &beside : nullptr);
            voids.take(beside);
        }
        if (!contacts.empty())
            meet_again(model, contacts, mass, step, voids, state, report, timers, now);
        if (!possible || !voids.turn(now.flow, round))
            break;
        now.flow = ideal;
        state.contacts = met;
        state.wrenches = wrenches;
    }
    if (voids.any())
        now.displaced.clear(); // they do not know voids
}

/// Kinetic energy that loads give in a step to bodies at rest that nothing holds, with the fluid that they displace.
template <int D>
double energy_of_loads(const Model<D>& model, const std::vector<RigidBody<D>>& bodies, double dt)
{
    double energy = 0;
    for (const RigidBody<D>& body : bodies)
        if (body.motion == Motion::free) {
            const Twist<D> load = dt * explicit_wrench(body, to_vec<D>(model.scene.gravity), model.scene.density);
            const double with_fluid = 1 + model.scene.density * std::abs(body.volume) / body.mass;
            energy += 0.5 * load.dot(impulse_response(body, load, dt)) / with_fluid;
        }
    return energy;
}

/// Throws ComputationError where enclosed fluid has no way out but between surfaces that touch.
template <int D>
void require_ways_out(const Model<D>& model, const Instant<D>& now, const FluidVelocity<D>& velocity,
                      const std::vector<Contact<D>>& contacts, const Step& step)
{
    const std::vector<Twist<D>> twists = moved_by<D>(now.flow.twists, stream_twist<D>(now.stream));
    if (const std::string squeezed = squeezed_on_parts(model, *now.placed, contacts, twists, velocity, GivesWay::unblocked);
        !squeezed.empty())
        throw ComputationError("step " + std::to_string(step.number) + ": " + squeezed);
}

/// Share of the energy that the work of a pass may miss.
double may_miss(int pass)
{
    return pass == most_passes ? most_missed : pass > 1 ? energy_accuracy : 0.0;
}

} // namespace

template <int D>
Instant<D> advance(Model<D>& model, Instant<D>& old, const Step& step, State<D>& state, StepReport& report, StageTimers& timers)
{
    const auto timed = [&](const char* stage, auto&& f) {
        const auto timer = timers.measure(stage);
        return f();
    };
    const std::vector<RigidBody<D>> before = state.bodies;
    state.bodies = timed("bodies", [&] { return moved(std::move(state.bodies), step); });
    follow(model, state, step);
    timed("contact", [&] { find_contacts(model, state, step); });
    const std::vector<TwistMatrix<D>> mass = model.masses(state.bodies, step.dt);
    Instant<D> now = at_new_places(model, before, old, state.bodies, mass, step, report, timers);
    VoidSolve<D> voids(model, old, *now.placed, step.dt);
    MeanFlow<D> mean_flow(model, old, step.dt);
    const std::vector<Twist<D>> none(old.force.size(), Twist<D>::Zero());
    StepForces<D> forces{trapezium<D>(old.force, old.force, step.dt), none};
    TurnedRemainder<D> turned(old, *now.placed, solver_options(model.scene), to_vec<D>(model.scene.fluid_velocity),
                              model.grid_velocity, step.dt);
    const ContactSet<D> contacts = state.contacts;
    const Twist<D> grid = stream_twist<D>(model.grid_velocity);
    const double of_loads = energy_of_loads(model, before, step.dt), energy_before = energy_of(old, before);
    ForcePasses<D> passes(before, model.scene.density);
    double last = std::numeric_limits<double>::infinity();
    state.forces_settle = true;
    int left = passes_of_work; // of a step whose forces do not settle
    std::vector<Twist<D>> loads;
    for (int pass = 1;; ++pass) {
        state.contacts = contacts;
        state.pressure.impulse = {CellField<D>(model.grid), {}};
        now.flow.remainder = timed("vorticity", [&] { return turned.find(pass > 1 ? &now : nullptr); });
        state.drive = model.viscous() ? Drive<D>{} : mean_flow.drive(state.drive); // with viscosity it drives while this acts
        now.stream = state.drive.flow;
        std::vector<Twist<D>> forced = forced_twists(model, state.bodies, state.drive, step);
        if (model.viscous())
            loads = take_loads(model, state.bodies, mass, now.placed->coupling, step, forced);
        const auto solve = [&](Coupling<D>& system, const UnknownVector<D>& outflow, const std::vector<Twist<D>>& impulse) {
            Intermediate<D> star = intermediate(model, old, *now.placed, system, now.stream, now.flow.remainder, now.flow.sides,
                                                forced, forces, state, step.dt);
            add_outflow(system, outflow, impulse, step.dt, state.bodies, star);
            state.contacts = contacts;
            state.pressure.impulse = {CellField<D>(model.grid), {}};
            return project(model, system, std::move(star), mass, step, state, report, timers);
        };
        find_flow<D>(solve, voids, pass, now);
        timed("forces", [&] { find_forces(now); });
        const double negligible = model.scene.tolerance * (of_loads + std::max(energy_before, now.energy));
        const bool is_kept = model.viscous() || mean_flow.found(now, state.bodies);
        if (!state.forces_settle) {
            if (--left == 0)
                break;
            forces.missing = timed("forces", [&] {
                return missing_impulses(before, old, state.bodies, now, none, {}, grid, turned.work_of_grid(now), negligible,
                                        step.dt);
            });
            continue;
        }
        StepForces<D> next = timed("forces", [&] {
            return forces_of(old, before, now, state.bodies, state.contacts.impact_impulses(old.force.size()), grid,
                             turned.work_of_grid(now), negligible, step.dt);
        });
        const auto change = [&](std::size_t b) {
            return Twist<D>(next.mean[b] + next.missing[b] - forces.mean[b] - forces.missing[b]);
        };
        const double energy = energy_of(now, before), missed = work_of(change, state.bodies, old, now).magnitude +
                                                               timed("vorticity", [&] { return std::abs(turned.work(now)); });
        if ((pass > 1 || now.flow.remainder.empty()) && (is_kept || pass == most_passes) &&
            missed <= may_miss(pass) * energy + negligible)
            break;
        state.forces_settle = pass < most_passes && !(pass > 1 && missed > std::max(last, energy));
        if (!state.forces_settle) {
            leave_mouths(now.displaced); // which do not settle
            next = {none, none};
            report.notes.push_back("the fluid's forces did not settle in step " + std::to_string(step.number) +
                                   ": only the work that they do acts");
        }
        last = missed;
        forces = state.forces_settle ? passes.next(forces, std::move(next)) : std::move(next);
    }
    report.corrected_energy = work_of([&](std::size_t b) { return forces.missing[b]; }, state.bodies, old, now).sum;
    state.dt = step.dt;
    state.time = step.landing;
    state.steps = step.number;
    state.wrenches = fluid_wrenches(model, old, now, forces, state.bodies, state.drive, step.start + 0.5 * step.dt, step.dt);
    if (model.viscous())
        end_with_viscosity(model, contacts, mass, loads, step, voids, state, report, timers, now);
    finish_bodies(model, moved_by<D>(now.flow.twists, stream_twist<D>(now.stream)), step, state);
    FluidVelocity<D> velocity = face_velocities(now);
    require_ways_out(model, now, velocity, state.contacts.contacts(), step);
    state.pressure.impulse = pressure_impulse(old, state.velocity.grid, now, velocity.grid, model.grid_velocity, step.dt);
    state.velocity = std::move(velocity);
    voids.give_pressure(now.flow, state.pressure.impulse);
    if (!voids.settled())
        report.notes.push_back("voids in gaps did not settle within the rounds of a step");
    if (voids.any()) {
        now.left_outflow = voids.left_outflow(now);
        timed("voids", [&] { voids.finish(state.bodies, mass, now); });
        timed("forces", [&] { find_forces(now); });
    } else if (!old.kept.volume.empty())
        now.kept.volume.assign(count_sites(now.placed->complex), 0.0);
    if (!now.flow.remainder.empty()) {
        if (model.viscous()) {
            take_gauge_of_velocity(*now.placed, now.flow);
            fill_covered(*now.placed, now.flow.remainder.faces);
        }
        timed("vorticity", [&] { renew_gauge(*now.placed, now.flow, solver_options(model.scene)); });
        timed("forces", [&] { find_forces(now); });
    }
    state.potential = now.flow.p;
    state.remainder = now.flow.remainder;
    return now;
}

template <int D>
Instant<D> restored(const Model<D>& model, const State<D>& state, const PartVoids& kept)
{
    auto at = placed(model, state.bodies, model.masses(state.bodies, state.dt), !state.remainder.empty());
    if (!kept.volume.empty()) {
        add_beyond(model, at->coupling.solids, at->complex, kept.beyond, at->voids);
        put_voids(model, state.bodies, model.masses(state.bodies, state.dt), kept.volume, *at);
    }
    const Vec<D> stream = model.driven()            ? state.drive.flow
                          : state.remainder.empty() ? to_vec<D>(model.scene.fluid_velocity)
                                                    : Vec<D>(Vec<D>::Zero());
    PotentialFlow<D> flow{moved_by<D>(model.twists(state.bodies), stream_twist<D>(-stream)),
                          state.potential,
                          0,
                          {},
                          given_sides(model, state.time)};
    if (!state.remainder.empty())
        flow.remainder = remainder_of(*at, state.remainder.faces);
    if (model.viscous())
        flow.remainder.edges = state.remainder.edges;
    Instant<D> instant = instant_of<D>(model, state.bodies, std::move(at), std::move(flow), stream);
    instant.kept = kept;
    if (!state.forces_settle) {
        leave_mouths(instant.displaced);
        find_forces(instant);
    }
    return instant;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template Instant<D> advance<D>(Model<D>&, Instant<D>&, const Step&, State<D>&, StepReport&, StageTimers&);                 \
    template Instant<D> restored<D>(const Model<D>&, const State<D>&, const PartVoids&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
