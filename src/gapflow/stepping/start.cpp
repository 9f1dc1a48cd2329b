#include "gapflow/stepping/start.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/stepping/configuration.hpp"
#include "gapflow/stepping/core_requirement.hpp"
#include "gapflow/stepping/gap_notes.hpp"
#include "gapflow/stepping/placement.hpp"
#include "gapflow/stepping/sealing.hpp"
#include "gapflow/stepping/start_flow.hpp"
#include "gapflow/stepping/step_end.hpp"
#include "gapflow/stepping/weight_check.hpp"

#include <algorithm>

namespace gapflow {

namespace {

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

// Fluid that moves everywhere with the scene's initial velocity.
template <int D>
FluidVelocity<D> uniform_velocity(const Model<D>& model)
{
    const Vec<D> u0 = to_vec<D>(model.scene.fluid_velocity);
    FluidVelocity<D> u;
    u.grid = FaceField<D>(model.grid);
    for (int axis = 0; axis < D; ++axis)
        u.grid[axis].fill(u0[axis]);
    fill_velocity_ghosts(model.grid, u.grid, model.sides(0));
    return u;
}

template <int D>
void fill_films(const Coupling<D>& here, const Vec<D>& u0, const std::vector<Twist<D>>& V, FluidVelocity<D>& u)
{
    for (const Film<D>& film : here.network.films)
        for (const FilmElement<D>& e : film.mesh.elements)
            u.film.push_back(u0 - u0.dot(e.normal) * e.normal);
    u.film_normal = wall_normal_speed<D>(here.network, here.solids, V);
    for (const Mouth<D>& mouth : here.network.rim.mouths)
        u.mouth.push_back(mouth.length * mouth.section.dot(u0));
}

// Bodies that lie flat on what they fall onto, and would rebound, start without that velocity: their film would keep it (method, "Contact").
template <int D>
void stop_flat_falls(const Model<D>& model, const Coupling<D>& here, const std::function<bool(int, int)>& rebound,
                     const std::vector<Twist<D>>& without, State<D>& state, StepReport& report)
{
    const auto pair = falls_flat<D>(here, model.gaps, model.twists(state.bodies), rebound);
    if (!pair)
        return;
    for (std::size_t b = 0; b < state.bodies.size(); ++b)
        if (state.bodies[b].motion == Motion::free)
            set_initial_twist<D>(state.bodies[b], without[b]);
    report.notes.push_back("'" + here.solids[(*pair)[0]].name + "' and '" + here.solids[(*pair)[1]].name +
                           "' lie flat on each other and approach at the start: the fluid between them stops that, and they do "
                           "not rebound; place them apart");
}

} // namespace

template <int D>
void require_fluid(const Model<D>& model, const Coupling<D>& coupling)
{
    if (!any_fluid(coupling, model.gaps))
        throw InputError(model.scene.file +
                         ": the bodies fill the whole domain and no fluid is left; make them smaller, or move them");
}

template <int D>
std::vector<TwistMatrix<D>> held_masses(const Model<D>& model, const std::vector<RigidBody<D>>& bodies)
{
    std::vector<TwistMatrix<D>> mass = model.masses(bodies, 0);
    for (std::size_t b = 0; b < bodies.size(); ++b)
        mass[b] *= held_mass_factor;
    return mass;
}

template <int D>
Start<D> start(const Model<D>& model, State<D>& state, StepReport& report, StageTimers& timers)
{
    require_weight(model.scene, state.bodies);
    for (std::string& warning : placement_warnings<D>(model.scene, state.bodies, model.walls))
        report.notes.push_back(std::move(warning));
    const std::vector<std::string> moved = take_out_overlaps<D>(model.scene, model.grid, state.bodies, model.walls);
    report.notes.insert(report.notes.end(), moved.begin(), moved.end());

    std::vector<TwistMatrix<D>> mass = held_masses(model, state.bodies);
    std::optional<Coupling<D>> here = configure<D>(model, state, mass, nullptr, model.twists(state.bodies), 0, timers);
    require_fluid(model, *here);
    require_core(model, *here, state.bodies);
    if (moved.empty()) // what was pushed apart touches nearly
        for (std::string& note : rough_gap_notes(model.scene, *here))
            report.notes.push_back(std::move(note));

    Intermediate<D> star;
    star.velocity = uniform_velocity(model);
    const auto rebound = [&](int a, int b) {
        return model.scene.contact_of(here->solids[a].name, here->solids[b].name).restitution > 0;
    };
    std::vector<Twist<D>> V = start_twists<D>(*here, state.bodies, model.gaps, model.twists(state.bodies));
    const auto squeezed = [&](GivesWay gives_way) {
        return squeezed_pocket<D>(*here, model.gaps, {}, V, star.velocity, gives_way);
    };
    if (!squeezed(GivesWay::nothing).empty()) { // prescribed motion or inflow drives fluid that only moving bodies let out
        if (const std::string pocket = squeezed(GivesWay::bodies); !pocket.empty())
            throw ComputationError("step 1: " + pocket);
        mass = model.masses(state.bodies, 0);
        here.reset();
        here = configure<D>(model, state, mass, nullptr, V, 0, timers);
    } else {
        stop_flat_falls<D>(model, *here, rebound, V, state, report);
        V = start_twists<D>(*here, state.bodies, model.gaps, model.twists(state.bodies), rebound);
    }
    fill_films(*here, to_vec<D>(model.scene.fluid_velocity), V, star.velocity);
    star.twists = V;
    const Step none;
    Projected<D> end = project(model, *here, std::move(star), mass, none, state, report, timers);
    take_up(model, *here, std::move(end), mass, V, {}, {}, none, state);
    state.voids.finish(*here, state.pressure.impulse.nodes, state.pressure.impulse.nodes, 0);
    return {std::move(*here), V};
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template void require_fluid<D>(const Model<D>&, const Coupling<D>&);                                                       \
    template Start<D> start<D>(const Model<D>&, State<D>&, StepReport&, StageTimers&);                                         \
    template std::vector<TwistMatrix<D>> held_masses<D>(const Model<D>&, const std::vector<RigidBody<D>>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
