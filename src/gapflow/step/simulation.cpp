#include "gapflow/step/simulation.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/core/text.hpp"
#include "gapflow/step/advance.hpp"
#include "gapflow/step/gap_flow.hpp"
#include "gapflow/step/mean_flow.hpp"
#include "gapflow/step/part_flux.hpp"
#include "gapflow/step/start.hpp"
#include "gapflow/step/viscosity.hpp"
#include "gapflow/step/void_solve.hpp"
#include "gapflow/stepping/configuration.hpp"
#include "gapflow/stepping/drive.hpp"
#include "gapflow/stepping/film_reversal.hpp"
#include "gapflow/stepping/following.hpp"
#include "gapflow/stepping/gap_notes.hpp"
#include "gapflow/stepping/leaving.hpp"
#include "gapflow/stepping/motion.hpp"
#include "gapflow/stepping/rehearsal.hpp"
#include "gapflow/stepping/side_pressure.hpp"
#include "gapflow/stepping/start.hpp"
#include "gapflow/stepping/steadiness.hpp"
#include "gapflow/stepping/steering.hpp"
#include "gapflow/stepping/step_end.hpp"
#include "gapflow/stepping/step_size.hpp"
#include "gapflow/stepping/thickness_check.hpp"
#include "gapflow/stepping/viscous_lag.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace gapflow {

namespace {

void list_state(StateArchive& archive, PartVoids& voids)
{
    archive.optional("part_voids", !voids.volume.empty(), [&] {
        archive("volume", voids.volume);
        archive("drop", voids.drop);
        archive("beyond", voids.beyond);
        archive("lost", voids.lost);
    });
}

// The result of f(), its time counted as that of a stage.
template <class F>
auto timed(StageTimers& timers, const char* stage, F&& f)
{
    const auto timer = timers.measure(stage);
    return f();
}

// Throws InputError where the fluid cannot have a velocity of its own at the start.
template <int D>
void require_given_velocity(const Model<D>& model)
{
    const Scene& scene = model.scene;
    if (!scene.parts)
        throw InputError(scene.file + ": gap.model: a velocity of the fluid at the start needs \"parts\"; write that");
    if (model.driven())
        throw InputError(
            scene.file +
            ": fluid: a velocity of the fluid at the start needs a box in which nothing drives the mean flow; leave out "
            "fluid.pressure_gradient, fluid.mean_velocity and gravity along periodic axes");
    for (int side = 0; side < 2 * D && !model.viscous(); ++side)
        if (scene.sides[side].kind == SideScene::Kind::inflow || scene.sides[side].kind == SideScene::Kind::pressure)
            throw InputError(
                scene.file + ": domain.sides." + side_names[side] +
                ": a velocity of the fluid at the start needs sides that are walls, open, far or periodic; write one of these");
}

} // namespace

template <int D>
Simulation<D>::Simulation(const Scene& scene, const Communicator& comm) : model_(scene, comm), state_(model_)
{
    begin(nullptr);
}

template <int D>
Simulation<D>::Simulation(const Scene& scene, const Communicator& comm,
                          const std::function<gapflow::Vec<D>(const gapflow::Vec<D>&)>& velocity)
    : model_(scene, comm), state_(model_)
{
    require_given_velocity(model_);
    const Grid<D>& grid = model_.grid;
    FaceField<D> faces(grid);
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(grid.low(), owned_faces_end(grid, axis),
                          [&](const Index<D>& f) { faces(axis, f) = velocity(grid.face_centre(axis, f))[axis]; });
    begin(&faces);
}

template <int D>
Simulation<D>::Simulation(const Scene& scene, const Communicator& comm, const FaceField<D>& velocity)
    : model_(scene, comm), state_(model_)
{
    require_given_velocity(model_);
    begin(&velocity);
}

template <int D>
void Simulation<D>::begin(const FaceField<D>* velocity)
{
    const Scene& scene = model_.scene;
    const Stopwatch watch;
    initial_report_.notes = thickness_warnings<D>(model_.scene, model_.bodies, model_.walls, scene.thin);
    std::vector<Twist<D>> V = model_.twists(state_.bodies);
    if (scene.parts) {
        instant_ = start_on_parts(model_, state_, initial_report_, stages_, velocity);
        part_voids_ = instant_->kept;
    } else {
        Start<D> begin = start(model_, state_, initial_report_, stages_);
        here_ = std::move(begin.here);
        V = std::move(begin.twists);
    }
    if (scene.forces) {
        force_parts_.resize(state_.bodies.size());
        for (std::size_t b = 0; b < force_parts_.size(); ++b)
            force_parts_[b].buoyancy = buoyancy(model_, state_.bodies[b]);
    }
    beyond_ = timed(stages_, "continuation", [&] { return reconstruct(model_, coupling(), state_, V); });
    report(V, initial_report_);
    initial_report_.seconds = watch.seconds();
}

template <int D>
Simulation<D>::Simulation(const Scene& scene, const Communicator& comm, const StoredState& stored)
    : model_(scene, comm), state_(model_)
{
    initial_report_.notes = thickness_warnings<D>(model_.scene, model_.bodies, model_.walls, scene.thin);
    StateArchive archive(stored);
    list_state(archive, model_, state_);
    list_state(archive, part_voids_);
    archive.finish();
    restore_configuration();
    const std::vector<Twist<D>> V = model_.twists(state_.bodies);
    beyond_ = reconstruct(model_, coupling(), state_, V);
    report(V, initial_report_);
}

template <int D>
Simulation<D>::~Simulation() = default;

template <int D>
StoredState Simulation<D>::state() const
{
    StoredState stored;
    StateArchive archive(stored);
    list_state(archive, model_,
               const_cast<State<D>&>(state_)); // one list for storing and restoring; storing does not change the object
    list_state(archive, const_cast<PartVoids&>(part_voids_));
    return stored;
}

// What follows from a state that is not the last step's.
template <int D>
void Simulation<D>::restore_configuration()
{
    if (model_.scene.follow)
        place_grid<D>(model_, Vec<D>(state_.grid_shift), Vec<D>(state_.grid_velocity), state_);
    if (model_.scene.parts)
        instant_ = restored(model_, state_, part_voids_);
    else
        here_ = configure_stored(model_, state_, stages_);
    fill_velocity_ghosts(model_.grid, state_.velocity.grid, model_.sides(state_.time));
    exchange(model_.grid, state_.pressure.impulse.cells);
}

template <int D>
StepReport Simulation<D>::step(double next_output)
{
    const Stopwatch watch;
    if (!(next_output > state_.time))
        throw InputError("a step until " + number_text(next_output) + " goes back: the time is " + number_text(state_.time) +
                         " already; give a later one");
    StepReport report;
    if (state_.steps == 0 && expects_anything(model_, coupling()))
        rehearse(next_output);
    const std::vector<Whereabouts> places = whereabouts(model_, state_.bodies);
    std::optional<EarlierFlow<D>> earlier;
    if (model_.scene.until_steady)
        earlier.emplace(model_, state_);
    advance_followed(next_output, report);
    if (earlier)
        report.unsteadiness = unsteadiness(model_, coupling(), *earlier, state_);
    follow_departures(places, report);
    this->report(model_.twists(state_.bodies), report);
    report.seconds = watch.seconds();
    return report;
}

template <int D>
void Simulation<D>::put_back(const State<D>& start)
{
    here_.reset();
    instant_.reset();
    state_ = start; // copied: who keeps a reference to a body has the same one afterwards
    restore_configuration();
}

// A step that turns out too long for its viscosity is made again, shorter: the energy that it gains would stay.
template <int D>
void Simulation<D>::advance_followed(double next_output, StepReport& report)
{
    if (model_.scene.parts) {
        advance_on_parts(next_output, report);
        return;
    }
    std::optional<State<D>> start;
    if (model_.scene.max_step > followed_step(model_))
        start = state_;
    advance(next_output, BulkViscosity::acts, report);
    if (start && lags(model_, state_)) {
        start->viscous_step = followed_step(model_);
        put_back(*start);
        beyond_ = reconstruct(model_, *here_, state_, model_.twists(state_.bodies));
        report = {};
        advance(next_output, BulkViscosity::acts, report);
        report.notes.push_back(viscous_lag_note(model_));
    }
    if (state_.viscous_step > 0)
        state_.viscous_step = longest_viscous_step(model_, state_);
}

// The viscous step starts from the pressure of the step before: without one a light body drags the fluid with the velocity that it would have
// without added mass, ten and more times too fast. So that pressure comes from a step in which the bulk's viscosity does not act; one in which it
// does follows, because with much viscosity accelerations over a step are far smaller.
template <int D>
void Simulation<D>::rehearse(double next_output)
{
    std::vector<BulkViscosity> steps{BulkViscosity::is_left_out};
    if (model_.viscous() && !model_.scene.parts)
        steps.push_back(BulkViscosity::acts);
    for (BulkViscosity viscosity : steps) {
        const State<D> start = state_;
        const PartVoids voids = part_voids_;
        StepReport unused;
        if (model_.scene.parts)
            advance_on_parts(next_output, unused);
        else
            advance(next_output, viscosity, unused);
        Expectations<D> found = expectations(model_, state_, coupling());
        part_voids_ = voids;
        put_back(start);
        expect(std::move(found), coupling(), state_);
        beyond_ = reconstruct(model_, coupling(), state_, model_.twists(state_.bodies));
    }
}

template <int D>
void Simulation<D>::advance_on_parts(double next_output, StepReport& report)
{
    GapWays<D> ways; // of films
    const Step step = choose_step<D>(model_, state_, coupling(), beyond_.histories, next_output, ways,
                                     own_arms(*instant_->placed), speed_beside_voids(*instant_));
    instant_ = gapflow::advance(model_, *instant_, step, state_, report, stages_);
    part_voids_ = instant_->kept;
    if (model_.scene.forces)
        force_parts_ = split_forces(model_, *instant_, state_);
    beyond_ =
        timed(stages_, "continuation", [&] { return reconstruct(model_, coupling(), state_, model_.twists(state_.bodies)); });
}

// A time step to the new state and configuration.
template <int D>
void Simulation<D>::advance(double next_output, BulkViscosity viscosity, StepReport& report)
{
    GapWays<D> ways;
    const Step step = choose_step(model_, state_, *here_, beyond_.histories, next_output, ways);
    state_.gap_ways = std::move(ways);
    state_.drive = next_drive(model_, *here_, state_, step);
    LastPressure<D> past = recall_pressure(model_, *here_, step, state_);
    state_.turned = model_.viscous() ? std::set<FilmPair<D>>()
                                     : reversing_films<D>(*here_, model_.twists(state_.bodies), state_.acceleration,
                                                          model_.gaps, model_.mouths);
    state_.bodies = timed(stages_, "bodies", [&] { return moved(std::move(state_.bodies), step); });
    follow(model_, state_, step);
    timed(stages_, "contact", [&] { find_contacts(model_, state_, step); });
    const std::vector<TwistMatrix<D>> mass = model_.masses(state_.bodies, step.dt);
    LeftBehind<D> left = leave(here_);
    state_.films_before = std::move(left.films);
    Coupling<D> there = configure(model_, state_, mass, beyond_.histories, *left.fractions, step, report, stages_);
    Intermediate<D> star = timed(stages_, "advection", [&] {
        return transport(model_, state_, std::move(beyond_), past.bulk, there, *left.fractions, step);
    });
    if (!model_.viscous() && state_.contacts.empty() && state_.turned.empty())
        past.bulk = {};     // memory: read again after an impact only
    left.fractions.reset(); // large
    drive_fluid(model_, there, state_.drive, step, star);
    star.twists = forced_twists(model_, state_.bodies, state_.drive, step);
    Diffusion<D> diffusion;
    if (model_.viscous() && viscosity == BulkViscosity::acts)
        diffusion = timed(stages_, "viscosity", [&] {
            return diffuse(model_, state_.bodies, state_.contacts, mass, past, there, step, star, report);
        });
    else if (model_.viscous())
        diffusion.divergence = CellField<D>(model_.grid);
    const std::vector<Twist<D>> V_star = star.twists;
    push_from_beyond(model_, state_.bodies, there, step, star);
    Projected<D> end = project(model_, there, std::move(star), mass, step, state_, report, stages_);
    if (model_.scene.forces)
        force_parts_ = gapflow::force_parts(model_, there, end, diffusion, step, state_);
    take_up(model_, there, std::move(end), mass, V_star, std::move(past), diffusion, step, state_);
    here_ = std::move(there);
    beyond_ = timed(stages_, "continuation", [&] { return reconstruct(model_, *here_, state_, model_.twists(state_.bodies)); });
}

template <int D>
void Simulation<D>::follow_departures(const std::vector<Whereabouts>& before, StepReport& report)
{
    Departures departed = departures(model_, state_.bodies, before, state_.steps == 1, crowds_told_);
    report.leaving = !departed.starting.empty();
    std::vector<std::string> notes = std::move(departed.notes);
    if (model_.scene.leaving == Scene::Leaving::remove)
        for (std::string& note : remove_bodies(model_, departed.left, state_, crowds_told_))
            notes.push_back(std::move(note));
    for (std::string& note : notes)
        report.notes.push_back(std::move(note));
}

// The state's sums; notes on films with blind ends, and on short ones.
template <int D>
void Simulation<D>::report(const std::vector<Twist<D>>& V, StepReport& report)
{
    report_state(model_, coupling(), state_, V, report);
    if (instant_) {
        report.film_nodes = count_gap_parts(*instant_->placed);
        report.cells -= report.film_nodes;
        report.energy_fluid = instant_->energy + energy_of_stream(model_, *instant_, state_.bodies);
        for (const RigidBody<D>& body : state_.bodies) // of the motion relative to the stream
            if (body.motion == Motion::free && !instant_->stream.isZero(0) && !model_.driven()) {
                RigidBody<D> relative = body;
                relative.twist -= stream_twist<D>(instant_->stream);
                report.energy_bodies += kinetic_energy(relative) - kinetic_energy(body);
            }
        if (model_.driven()) {
            const Vec<D> flow =
                model_.viscous() ? mean_flux(model_.grid, instant_->flux) : mean_velocity(model_, *instant_, state_.bodies);
            double* const flows[] = {&report.mean_velocity_x, &report.mean_velocity_y, &report.mean_velocity_z};
            for (int axis = 0; axis < D; ++axis)
                *flows[axis] = flow[axis];
        }
        report.divergence_max = largest_divergence(*instant_, state_.velocity);
        corrected_.sum += report.corrected_energy;
        corrected_.magnitude += std::abs(report.corrected_energy);
        largest_energy_ = std::max(largest_energy_, report.energy_fluid + report.energy_bodies);
    }
    for (std::string& note : blind_end_notes(coupling(), blind_told_))
        report.notes.push_back(std::move(note));
    if (model_.viscous() && here_ && state_.steps > 0)
        for (std::string& note : short_film_notes(model_.scene, *here_, state_.pressure.impulse))
            report.notes.push_back(std::move(note));
}

template <int D>
std::vector<int> Simulation<D>::outside() const
{
    const std::vector<Whereabouts> places = whereabouts(model_, state_.bodies);
    std::vector<int> bodies;
    for (int b = 0; b < static_cast<int>(places.size()); ++b)
        if (places[b].outside || removed(b))
            bodies.push_back(b);
    return bodies;
}

template <int D>
UnknownVector<D> Simulation<D>::reduced_pressure() const
{
    return gapflow::reduced_pressure(state_);
}

template <int D>
double Simulation<D>::hydrostatic(const Vec<D>& x) const
{
    return model_.hydrostatic(x);
}

template <int D>
std::vector<PointValues<D>> Simulation<D>::sample(std::span<const Vec<D>> points) const
{
    return sample_points(model_, coupling(), state_, model_.twists(state_.bodies), points);
}

template <int D>
VolumeFlux Simulation<D>::volume_flux(const FluxScene& through) const
{
    if (instant_)
        return flux_on_parts(model_, *instant_, state_, through);
    return gapflow::volume_flux(model_, coupling(), state_, model_.twists(state_.bodies), through);
}

template <int D>
bool Simulation<D>::settled() const
{
    return has_settled(model_.scene, state_.steady, state_.time);
}

template <int D>
bool Simulation<D>::driven() const
{
    return model_.driven();
}

template <int D>
std::vector<GapState> Simulation<D>::gaps() const
{
    std::vector<GapState> states = gap_states(model_, coupling(), state_);
    if (instant_) {
        add_gap_parts(model_, *instant_->placed, state_, states);
        add_void_states(model_, *instant_->placed, state_, part_voids_, states);
    }
    return states;
}

template <int D>
GapMeshes<D> Simulation<D>::gap_meshes() const
{
    return instant_ ? gapflow::gap_meshes(model_, *instant_, state_) : film_meshes(model_, *here_, state_);
}

template <int D>
CellField<D> Simulation<D>::outflow() const
{
    return instant_ ? net_outflow(*instant_, state_.velocity).cells
                    : net_outflow(*here_, state_, model_.twists(state_.bodies)).cells;
}

template <int D>
Budget<D> Simulation<D>::budget() const
{
    Budget<D> sums = gapflow::budget(model_, coupling(), state_, model_.twists(state_.bodies));
    if (instant_)
        sums.energy_grid = instant_->energy + energy_of_stream(model_, *instant_, state_.bodies);
    return sums;
}

template <int D>
void Simulation<D>::set_force(int body, const Vec<D>& force, const Spin<D>& torque)
{
    gapflow::set_force(state_, body, force, torque);
}

template <int D>
void Simulation<D>::set_velocity(int body, const Vec<D>& velocity, const Spin<D>& angular_velocity)
{
    gapflow::set_velocity(state_, body, velocity, angular_velocity);
}

template class Simulation<2>;
template class Simulation<3>;

} // namespace gapflow
