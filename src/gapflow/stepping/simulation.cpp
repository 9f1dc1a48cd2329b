#include "gapflow/stepping/simulation.hpp"

#include "gapflow/body/forces.hpp"
#include "gapflow/body/move.hpp"
#include "gapflow/core/error.hpp"
#include "gapflow/core/machine_memory.hpp"
#include "gapflow/coupling/film_drag.hpp"
#include "gapflow/grid/interpolation.hpp"
#include "gapflow/stepping/carried_on.hpp"
#include "gapflow/stepping/film_turn.hpp"
#include "gapflow/stepping/flooding.hpp"
#include "gapflow/stepping/gap_notes.hpp"
#include "gapflow/stepping/leaving.hpp"
#include "gapflow/stepping/placement.hpp"
#include "gapflow/stepping/projection.hpp"
#include "gapflow/stepping/start_flow.hpp"
#include "gapflow/stepping/thickness_check.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace gapflow {

namespace {

constexpr int most_pushes = 10; // that take out the overlaps of a step
// Of the fluid that a body displaces: what it adds to its inertia where contacts are forecast. In a crowd; found by trial.
constexpr double bulk_share = 2;
constexpr std::size_t many_points = 1000000; // of films: what they leave behind in small pieces is worth collecting
constexpr int few_iterations = 12; // of a solve without a correction for bodies: the next one asks no more for their lightness
// Masses in the initial projection, which holds the bodies to their velocities.
constexpr double held_mass_factor = 1e12;

// Whether there are cells to compute, or else films between surfaces that are apart.
template <int D>
bool any_fluid(const Coupling<D>& coupling, const std::function<GapSettings(int, int)>& gaps)
{
    long cells = -coupling.network.nodes;
    for (const Component& component : coupling.system.components)
        cells += component.unknowns;
    if (cells > 0)
        return true;
    return std::any_of(coupling.network.films.begin(), coupling.network.films.end(), [&](const Film<D>& film) {
        const double touching = 1.001 * gaps(film.mesh.master, film.mesh.other).floor;
        return std::any_of(film.mesh.points.begin(), film.mesh.points.end(),
                           [&](const FilmPoint<D>& point) { return point.h + film.mesh.skin > touching; });
    });
}

double now()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace

template <int D>
Simulation<D>::Simulation(Unprepared, const Scene& scene, const Communicator& comm)
    : scene_(scene), grid_(make_grid<D>(scene, comm)), bodies_(make_bodies<D>(scene)), walls_(make_walls<D>(scene))
{
    initial_report_.notes = thickness_warnings<D>(scene_, bodies_, walls_, scene_.thin);
    const std::vector<Solid<D>> solids = make_solids<D>(bodies_, walls_);
    gaps_ = gap_settings<D>(scene_, solids, true);
    mouth_laws_ = mouth_laws<D>(scene_, solids);
    contacts_ = ContactSet<D>(scene_, grid_, solids);
    voids_ = VoidSet<D>(scene_, grid_, solids, [this](const Vec<D>& x) { return hydrostatic(x); });
    acceleration_.assign(solids.size(), Twist<D>::Zero());
    wrenches_.assign(bodies_.size(), Twist<D>::Zero());
    velocity_.grid = FaceField<D>(grid_);
    film_faces_ = FaceField<D, std::int8_t>(grid_);
    impulse_.cells = CellField<D>(grid_);
    if (scene_.viscosity > 0) {
        past_.pressure = past_.known = CellField<D>(grid_);
        viscous_.force.assign(bodies_.size(), Twist<D>::Zero());
    }
}

template <int D>
Simulation<D>::Simulation(const Scene& scene, const Communicator& comm) : Simulation(Unprepared{}, scene, comm)
{
    // The flow at rest that the bodies' velocities drive: one projection of the initial velocity, bodies held to theirs.
    const double start = now();
    for (std::string& warning : placement_warnings<D>(scene_, bodies_, walls_))
        initial_report_.notes.push_back(std::move(warning));
    const std::vector<std::string> moved = take_out_overlaps<D>(scene_, grid_, bodies_, walls_);
    initial_report_.notes.insert(initial_report_.notes.end(), moved.begin(), moved.end());
    holding_ = true;
    rebuild();
    if (!any_fluid(*coupling_, gaps_))
        throw InputError(scene_.file +
                         ": the bodies fill the whole domain and no fluid is left; make them smaller, or move them");
    if (moved.empty()) // what was pushed apart touches nearly
        for (std::string& note : rough_gap_notes(scene_, *coupling_))
            initial_report_.notes.push_back(std::move(note));
    const Vec<D> u0 = to_vec<D>(scene_.fluid_velocity);
    FluidVelocity<D> u_star = velocity_;
    for (int axis = 0; axis < D; ++axis)
        u_star.grid[axis].fill(u0[axis]);
    fill_velocity_ghosts(grid_, u_star.grid, side_velocities(0));
    start_twists_ = start_twists<D>(*coupling_, bodies_, gaps_, twists());
    if (!squeezed_pocket<D>(*coupling_, gaps_, {}, start_twists_, u_star, GivesWay::nothing).empty()) {
        check_sealing(u_star, start_twists_, GivesWay::bodies);
        giving_way_ = true;
        coupling_.reset();
        rebuild();
    }
    for (const Film<D>& film : coupling_->network.films)
        for (const FilmElement<D>& e : film.mesh.elements)
            u_star.film.push_back(u0 - u0.dot(e.normal) * e.normal);
    u_star.film_normal = wall_normal_speed<D>(coupling_->network, coupling_->solids, twists());
    for (const Conduit<D>& conduit : coupling_->network.mouths.conduits)
        u_star.conduit.push_back(conduit.length * conduit.h * conduit.outward.dot(u0));
    project(std::move(u_star), twists(), 0, initial_report_);
    voids_.finish(*coupling_, impulse_.nodes, impulse_.nodes, 0);
    holding_ = false;
    continue_velocities();
    finish_report(initial_report_, 0);
    start_twists_.clear();
    initial_report_.seconds = now() - start;
}

template <int D>
Simulation<D>::~Simulation() = default;

template <int D>
StepReport Simulation<D>::step(double next_output)
{
    const double start = now();
    StepReport report;
    last_dt_ = dt_;
    const double dt = dt_ = choose_step(next_output);
    recall_pressure();
    const std::vector<Whereabouts> places = whereabouts(scene_, bodies_);
    turning_ = scene_.viscosity == 0 ? turning_films<D>(*coupling_, twists(), acceleration_, gaps_, mouth_laws_)
                                     : std::set<FilmPair<D>>();
    move_bodies(dt);
    find_contacts(dt);
    rebuild();
    if (voids_.lost() > 0)
        report.notes.push_back("a gap with a void in it opened beyond its film (gap.threshold): the void is gone at once");
    std::vector<double> conduit_scale;
    FaceField<D> change;
    FluidVelocity<D> u_star = advect_all(dt, conduit_scale, change);
    for (std::size_t r = 0; r < conduit_scale.size(); ++r)
        coupling_->system.links[r].conductance *= conduit_scale[r];
    std::vector<Twist<D>> V_star = forced_twists(dt, change);
    change = {};
    if (scene_.viscosity > 0)
        add_viscosity(u_star, V_star, dt, report);
    start_drag(*coupling_, u_star);
    project(std::move(u_star), V_star, dt, report);
    if (scene_.viscosity > 0)
        remember_projection(V_star, dt);
    time_ = next_output - (time_ + dt) < 1e-12 * next_output ? next_output : time_ + dt;
    continue_velocities();
    for (std::string& note : leaving_notes(scene_, bodies_, places, steps_ == 0))
        report.notes.push_back(std::move(note));
    ++steps_;
    finish_report(report, dt);
    report.seconds = now() - start;
    return report;
}

// Stage 3: V^n + 1/2 dt (V^n - V^{n-1}) / dt^{n-1}. What a much shorter step says of the acceleration is not to be carried that far.
template <int D>
void Simulation<D>::move_bodies(double dt)
{
    const auto timer = stages_.measure("bodies");
    const double share = carried_on(last_dt_, dt);
    for (RigidBody<D>& body : bodies_) {
        body.acceleration *= share;
        body.angular_momentum_rate *= share;
        if (body.motion == Motion::prescribed)
            body.twist = predicted_twist(body, time_, dt);
        move(body, time_, dt);
    }
}

// Contacts of the new configuration. Overlaps that the motion left are taken out first: again where pushed bodies meet others, or turn
// so far that what was found of their contacts no longer holds.
template <int D>
void Simulation<D>::find_contacts(double dt)
{
    const auto timer = stages_.measure("contact");
    contacts_.find(make_solids<D>(bodies_, walls_), twists(), dt);
    for (int pass = 0; pass < most_pushes && contacts_.push_apart(bodies_); ++pass)
        contacts_.find(make_solids<D>(bodies_, walls_), twists(), dt);
}

// Stage 4: fractions, films, the coupled system.
template <int D>
void Simulation<D>::rebuild()
{
    if (coupling_) {
        old_fractions_ = coupling_->fractions;
        alive_.clear();
        std::size_t points = 0;
        for (const Film<D>& film : coupling_->network.films) {
            alive_.insert(film.pair);
            points += film.mesh.points.size();
        }
        coupling_.reset(); // two at a time would be the most of a step's memory
        if (points > many_points)
            return_freed_memory();
    }
    build_coupling([this](const Coupling<D>& films) {
        voids_.find(films, holding_ ? nullptr : &memories_);
        if (scene_.viscosity > 0)
            voids_.find_wet_shares(films, twists());
        return voids_.wet_shares();
    });
}

template <int D>
void Simulation<D>::build_coupling(const std::function<WetShares(const Coupling<D>&)>& wet)
{
    coupling_ = std::make_unique<Coupling<D>>(
        couple<D>(grid_, make_solids<D>(bodies_, walls_), masses(),
                  {scene_.density, fraction_mode(scene_), &stages_, scene_.viscosity * dt_}, gaps_, alive_, wet));
}

// Twists of the end of the step, and what goes on of their change.
template <int D>
void Simulation<D>::finish_bodies(const std::vector<Twist<D>>& V, double dt)
{
    std::vector<char> met(bodies_.size());
    for (std::size_t b = 0; b < bodies_.size(); ++b)
        met[b] = met_something(static_cast<int>(b));
    const bool any_met = std::find(met.begin(), met.end(), 1) != met.end();
    const Vec<D> gravity = to_vec<D>(scene_.gravity);
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        RigidBody<D>& body = bodies_[b];
        const Twist<D> change = (V[b] - body.twist) / dt;
        double lasting = met[b] ? 0.0 : 1.0;
        if (any_met && !met[b] && body.motion == Motion::free) {
            const Twist<D> forced = (forced_twist<D>(body, gravity, scene_.density, dt) - body.twist) / dt;
            lasting = lasting_part(body, change, acceleration_[b], std::max(gravity.norm(), forced.template head<D>().norm()));
        }
        acceleration_[b] = lasting * change;
        if (body.motion == Motion::free)
            finish_step(body, V[b], dt, lasting);
    }
    if (any_met) {
        film_push_.clear();
        last_push_.clear();
    }
}

// Twists of the end of the step if the accelerations of the last one go on.
template <int D>
std::vector<Twist<D>> Simulation<D>::predicted_twists(double dt) const
{
    std::vector<Twist<D>> V = twists();
    for (std::size_t b = 0; b < bodies_.size(); ++b)
        V[b] = predicted_twist(bodies_[b], time_, dt);
    return V;
}

// Stage 6: (L + K M^-1 K^T) p = -(D u* + K V*), contacts among the bodies included, then velocities and twists of the end of
// the step. In the initial projection (dt = 0) bodies are held to their velocities.
template <int D>
void Simulation<D>::project(FluidVelocity<D> u_star, const std::vector<Twist<D>>& forced, double dt, StepReport& report)
{
    const double start = now();
    const bool contacts = dt > 0 && !contacts_.empty(), voids = dt > 0 && voids_.any();
    const std::vector<TwistMatrix<D>> mass = masses();
    NearInertia<D> inertia;
    if (contacts) {
        contacts_.prepare(twists(), forced, dt, last_dt_);
        std::vector<TwistMatrix<D>> loaded = mass;
        for (std::size_t b = 0; b < bodies_.size(); ++b)
            loaded[b] *= 1 + bulk_share * scene_.density * std::abs(bodies_[b].volume) / bodies_[b].mass;
        inertia = near_inertia(*coupling_, loaded, voids_.is_void());
    }
    const std::vector<char> was_empty = voids ? voids_.empty_elements(coupling_->network) : std::vector<char>();
    SolverOptions options;
    options.tolerance = scene_.tolerance;
    options.backend = scene_.backend == Scene::Backend::petsc ? Backend::petsc : Backend::multigrid;
    options.ask_lightness = light_bodies_;
    Projection<D> projection(
        {*coupling_, bodies_, mass, forced, contacts ? &contacts_ : nullptr, voids ? &voids_ : nullptr, dt, steps_ + 1}, u_star,
        impulse_, options, stages_);
    Rounds rounds(contacts, voids, !voids && !(contacts && contacts_.likely_to_change(predicted_twists(dt))));
    ContactChange change;
    bool new_voids;
    do {
        if (rounds.changed())
            projection.assemble(rounds.voids_changed());
        const double tolerance = rounds.tolerance(options.tolerance, projection.holds());
        const SolveReport solve = projection.solve(tolerance);
        report.iterations += solve.iterations;
        report.residual = solve.residual;
        light_bodies_ = projection.corrects_bodies() || solve.iterations > few_iterations;
        if (!solve.converged && dt > 0 && !voids)
            check_sealing(u_star, projection.without_pressure(), GivesWay::unblocked);
        if (!solve.converged)
            throw ComputationError("the pressure solve of step " + std::to_string(steps_ + 1) +
                                   " did not converge: " + solve.message + " (" + std::to_string(solve.iterations) +
                                   " iterations, relative residual " + std::to_string(solve.residual) + ")");
        change = projection.update_contacts(inertia, tolerance, rounds);
        new_voids = projection.update_voids(tolerance, rounds, change != ContactChange::none);
        if (new_voids)
            contacts_.forget_rounds();
    } while (rounds.go_on(change, new_voids));
    if (rounds.unsettled())
        report.notes.push_back(std::string(voids ? "contacts and voids" : "contacts") + " did not settle within " +
                               std::to_string(Rounds::most_rounds) + " rounds of a step");
    const std::vector<Twist<D>>& V = projection.twists();
    if (dt > 0 && !voids)
        check_sealing(u_star, projection.without_pressure(), GivesWay::unblocked);
    if (contacts)
        check_crushing(V, dt, report);
    projection.finish_voids();
    node_outflow_ = projection.node_outflow();
    take_velocities(std::move(u_star), V, was_empty, dt);
    if (dt > 0)
        finish_bodies(V, dt);
    find_wrenches(V, dt);
    stages_.add("projection", now() - start - projection.solver_seconds());
}

// Contacts that cannot hold what is driven into them.
template <int D>
void Simulation<D>::check_crushing(const std::vector<Twist<D>>& V, double dt, StepReport& report) const
{
    const Contact<D>* c = contacts_.crushed(V, dt);
    if (!c)
        return;
    const std::string pair = "'" + coupling_->solids[c->point.a].name + "' and '" + coupling_->solids[c->point.b].name + "'";
    if (contacts_.driven(*c, coupling_->solids, V))
        throw ComputationError("prescribed motion drives " + pair + " into each other in step " + std::to_string(steps_ + 1) +
                               ", and neither can give way; let it stop before they touch");
    report.notes.push_back("contacts ask for more than the bodies can do: " + pair +
                           " overlap, and are pushed apart again"); // nothing drives them
}

// Velocities of the end of the step: what the pressure leaves of u*, and what both walls of films and mouths carry along. `was_empty`: elements
// without fluid before the step; empty where there are no voids.
template <int D>
void Simulation<D>::take_velocities(FluidVelocity<D> u_star, const std::vector<Twist<D>>& V, const std::vector<char>& was_empty,
                                    double dt)
{
    std::vector<Vec<D>> without_push;
    if (D == 2 && scene_.viscosity == 0 && dt > 0)
        without_push = u_star.film;
    velocity_ = std::move(u_star);
    subtract_gradient(*coupling_, impulse_, velocity_);
    remember_push(without_push, dt);
    add_entrainment(*coupling_, V, 1, velocity_);
    if (!(dt > 0 && voids_.any()))
        return;
    for (std::size_t r = 0; r < velocity_.conduit.size(); ++r)
        if (voids_.shut()[r])
            velocity_.conduit[r] +=
                carried_flux<D>(*coupling_, coupling_->network.mouths.conduits[r], V) - entrained_flux(*coupling_, r, V);
    const std::vector<char> is_empty = voids_.empty_elements(coupling_->network);
    rest_in_voids<D>(*coupling_, is_empty, V, velocity_.film);
    follow_front<D>(*coupling_, was_empty, is_empty, voids_.is_void(), V, velocity_);
}

// Force and torque of the fluid on every body, mean over the step: pressure, buoyancy, shear of films.
template <int D>
void Simulation<D>::find_wrenches(const std::vector<Twist<D>>& V, double dt)
{
    std::vector<Twist<D>> impulse = impulses(*coupling_, impulse_);
    if (!coupling_->drag_inertia.empty()) {
        const std::vector<Twist<D>> shear = drag_impulses(*coupling_, V);
        for (std::size_t s = 0; s < impulse.size(); ++s)
            impulse[s] += shear[s];
    }
    const Vec<D> g = to_vec<D>(scene_.gravity);
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const RigidBody<D>& body = bodies_[b];
        const Vec<D> arm = body.pose.matrix() * (body.centre_of_volume - body.centre_of_mass);
        wrenches_[b] = wrench<D>(-scene_.density * body.volume * g, arm);
        if (dt > 0)
            wrenches_[b] += impulse[b] / dt;
    }
}

// Nor has one that is shut by surfaces that touch.
template <int D>
void Simulation<D>::check_sealing(const FluidVelocity<D>& u, const std::vector<Twist<D>>& V, GivesWay gives_way) const
{
    const std::string squeezed = squeezed_pocket<D>(*coupling_, gaps_, contacts_.contacts(), V, u, gives_way);
    if (!squeezed.empty())
        throw ComputationError("step " + std::to_string(steps_ + 1) + ": " + squeezed);
}

template <int D>
std::vector<Twist<D>> Simulation<D>::twists() const
{
    if (!start_twists_.empty())
        return start_twists_;
    std::vector<Twist<D>> V;
    for (const RigidBody<D>& body : bodies_)
        V.push_back(body.motion == Motion::fixed ? Twist<D>(Twist<D>::Zero()) : body.twist);
    V.insert(V.end(), walls_.twists.begin(), walls_.twists.end());
    return V;
}

// Masses of the step's solve; springs act as inertia too.
template <int D>
std::vector<TwistMatrix<D>> Simulation<D>::masses() const
{
    std::vector<TwistMatrix<D>> mass;
    for (const RigidBody<D>& body : bodies_)
        mass.push_back(mass_matrix(body) + spring_inertia(body, dt_));
    if (holding_ &&
        !giving_way_) // heavy beyond any added mass; as prescribed bodies they could choose other masters for their films
        for (TwistMatrix<D>& m : mass)
            m *= held_mass_factor;
    mass.resize(bodies_.size() + walls_.solids.size(), TwistMatrix<D>::Identity());
    return mass;
}

template <int D>
BoundaryVelocity<D> Simulation<D>::side_velocities(double time) const
{
    BoundaryVelocity<D> sides;
    sides.no_slip = scene_.viscosity > 0;
    for (int s = 0; s < 2 * D; ++s) {
        const SideScene& side = scene_.sides[s];
        sides.velocity[s] = to_vec<D>(side.velocity);
        if (side.kind == SideScene::Kind::inflow && !side.table.time.empty()) {
            const std::vector<double> u = value_at(side.table, time);
            sides.velocity[s] = Eigen::Map<const Vec<D>>(u.data());
        }
    }
    return sides;
}

// Continued bulk velocity at points anywhere. Collective: every rank asks for the same points.
template <int D>
std::vector<Vec<D>> Simulation<D>::sample(const std::vector<Vec<D>>& points) const
{
    std::vector<Vec<D>> u(points.size(), Vec<D>::Zero());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Index<D> c = grid_.wrapped(grid_.cell_of(points[i]));
        const Index<D> inside = c.cwiseMax(0).cwiseMin(grid_.cells() - Index<D>::Ones());
        if (!grid_.owns(inside))
            continue;
        const Vec<D> place = points[i] + grid_.dx() * (inside - grid_.cell_of(points[i])).template cast<double>();
        for (int axis = 0; axis < D; ++axis)
            u[i][axis] = interpolate_face(grid_, velocity_.grid[axis], axis, place);
    }
    if (!u.empty())
        grid_.comm().sum(std::span<double>(u.front().data(), D * u.size()));
    return u;
}

template class Simulation<2>;
template class Simulation<3>;

} // namespace gapflow
