// The lists of list_state() contain the whole state between steps. A class with state between steps has its own list_state(),
// called here.
#include "gapflow/stepping/state.hpp"

#include "gapflow/body/body_state.hpp"
#include "gapflow/film/film_pair_state.hpp"
#include "gapflow/grid/whole_field.hpp"
#include "gapflow/stepping/leaving.hpp"

#include <algorithm>

namespace gapflow {

namespace {

template <int D>
void list_pairs(StateArchive& archive, const std::string& name, std::set<FilmPair<D>>& pairs)
{
    std::vector<FilmPair<D>> list(pairs.begin(), pairs.end());
    archive.each(name, list, [](StateArchive& items, FilmPair<D>& pair) { gapflow::list_state(items, pair); });
    pairs = {list.begin(), list.end()};
}

// `list_value`: lists what is kept of a pair.
template <int D, class T, class ListValue>
void list_pairs(StateArchive& archive, const std::string& name, std::map<FilmPair<D>, T>& pairs, ListValue&& list_value)
{
    std::vector<std::pair<FilmPair<D>, T>> list(pairs.begin(), pairs.end());
    archive.each(name, list, [&](StateArchive& items, std::pair<FilmPair<D>, T>& item) {
        gapflow::list_state(items, item.first);
        list_value(items, item.second);
    });
    pairs = {list.begin(), list.end()};
}

} // namespace

template <int D>
void PressureHistory<D>::forget()
{
    lasts = false;
    film.clear();
    film_mean.clear();
}

template <int D>
State<D>::State(const Model<D>& model) : bodies(model.bodies)
{
    const std::vector<Solid<D>> solids = model.solids(bodies);
    contacts = ContactSet<D>(model.scene, model.grid, solids);
    voids = VoidSet<D>(model.scene, model.grid, solids, [&model](const Vec<D>& x) { return model.hydrostatic(x); });
    acceleration.assign(solids.size(), Twist<D>::Zero());
    wrenches.assign(bodies.size(), Twist<D>::Zero());
    velocity.grid = FaceField<D>(model.grid);
    pressure.impulse.cells = CellField<D>(model.grid);
    if (model.scene.parts)
        potential.cells = CellField<D>(model.grid);
    if (model.viscous()) {
        pressure.bulk.pressure = pressure.bulk.known = CellField<D>(model.grid);
        pressure.force.assign(bodies.size(), Twist<D>::Zero());
    }
}

template <int D>
bool was_reversed(const State<D>& state, int solid)
{
    return std::any_of(state.turned.begin(), state.turned.end(),
                       [&](const FilmPair<D>& pair) { return pair.master == solid || pair.other == solid; });
}

template <int D>
bool met_something(const State<D>& state, int solid)
{
    return state.contacts.impact_on(solid) || was_reversed(state, solid);
}

template <int D>
void list_state(StateArchive& archive, const Model<D>& model, State<D>& state)
{
    const Grid<D>& grid = model.grid;
    archive("step", state.steps);
    archive("time", state.time);
    archive("last_step_length", state.dt);
    std::size_t bodies = state.bodies.size();
    archive("body_count", bodies);
    if (bodies != state.bodies.size())
        throw StateError("it has " + std::to_string(bodies) + " bodies, the scene " + std::to_string(state.bodies.size()));
    archive.group("bodies", [&] {
        for (RigidBody<D>& body : state.bodies)
            gapflow::list_state(archive, body);
        for (Twist<D>& wrench : state.wrenches)
            archive("fluid_wrench", wrench);
    });
    archive.optional("removed", !state.removed.empty(), [&] {
        std::vector<int> list(state.removed.begin(), state.removed.end());
        archive("bodies", list);
        state.removed = {list.begin(), list.end()};
    });
    archive.optional("steady", state.steady.largest_speed > 0, [&] {
        archive("largest_speed", state.steady.largest_speed);
        archive("lagging_rate", state.steady.lagging_rate);
        archive("calm_steps", state.steady.calm_steps);
        archive("calm_time", state.steady.calm_time);
    });
    if (model.scene.follow)
        archive.group("follow", [&] {
            archive("grid_shift", state.grid_shift);
            archive("grid_velocity", state.grid_velocity);
        });
    archive("acceleration", state.acceleration);
    archive("light_bodies", state.light_bodies);
    archive.optional("viscous_lag", state.viscous_step > 0, [&] { archive("longest_step", state.viscous_step); });
    state.contacts.list_state(archive);
    state.voids.list_state(archive);
    list_pairs(archive, "films_before", state.films_before);
    list_pairs(archive, "films_turned", state.turned);
    archive.optional("gap_ways", !state.gap_ways.pairs.empty(), [&] {
        GapWays<D>& ways = state.gap_ways;
        list_pairs(archive, "pairs", ways.pairs, [](StateArchive& items, GapChange& way) {
            items("share", way.share);
            items("change", way.change);
        });
        ways.from.resize(state.bodies.size());
        archive.each("from", ways.from, [](StateArchive& items, Pose<D>& pose) { list_pose(items, pose); });
    });
    list_field(archive, "velocity", grid, state.velocity.grid);
    if (model.scene.parts)
        archive.group("potential", [&] {
            list_field(archive, "cells", grid, state.potential.cells);
            archive("nodes", state.potential.nodes);
            archive("forces_settle", state.forces_settle);
        });
    if (model.scene.parts)
        archive.optional("circulation", !state.remainder.empty(), [&] {
            bool goes_on = true; // what every rank finds: fields are on the root alone
            archive("goes_on", goes_on);
            if (state.remainder.empty())
                state.remainder.faces = FaceField<D>(grid);
            list_field(archive, "velocity", grid, state.remainder.faces);
            if (model.viscous())
                archive("edges", state.remainder.edges);
        });
    PressureHistory<D>& pressure = state.pressure;
    list_field(archive, "pressure_impulse", grid, pressure.impulse.cells);
    archive.group("films", [&] {
        archive("pressure_impulse", pressure.impulse.nodes);
        archive("outflow", state.node_outflow);
        archive("velocity", state.velocity.film);
        archive("normal_speed", state.velocity.film_normal);
        archive("push", pressure.film);
        archive("last_push", pressure.film_mean);
        archive("increment", state.film_increment);
        list_pairs(archive, "debts", state.film_debts, [](StateArchive& items, double& energy) { items("energy", energy); });
    });
    archive("conduit_flux", state.velocity.mouth);
    archive.optional("conduits", !state.conductance.empty(), [&] { archive("conductance", state.conductance); });
    if (model.driven())
        archive.group("drive", [&] {
            archive("gradient", state.drive.gradient);
            archive("mean_velocity", state.drive.flow);
        });
    const auto list_bulk_pressure = [&] {
        list_field(archive, "pressure", grid, pressure.bulk.pressure);
        list_field(archive, "known", grid, pressure.bulk.known);
    };
    if (model.viscous())
        archive.group("viscosity", [&] {
            list_bulk_pressure();
            archive("force", pressure.force);
        });
    else
        archive.optional("before_impact", !pressure.lasts && pressure.bulk.pressure.size() > 0, [&] {
            bool goes_on = true; // what every rank finds: fields are on the root alone
            archive("goes_on", goes_on);
            if (archive.restoring())
                pressure.bulk.pressure = pressure.bulk.known = CellField<D>(grid);
            list_bulk_pressure();
        });
    if (!archive.restoring())
        return;
    for (const int body : state.removed)
        take_out(state.bodies.at(static_cast<std::size_t>(body)));
    pressure.lasts = state.steps > 0;
    for (std::size_t b = 0; b < state.bodies.size(); ++b)
        pressure.lasts = pressure.lasts && !met_something(state, static_cast<int>(b));
    if (state.acceleration.size() != model.walls.solids.size() + state.bodies.size())
        throw StateError("it has other walls than the scene");
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template struct PressureHistory<D>;                                                                                        \
    template struct State<D>;                                                                                                  \
    template bool was_reversed<D>(const State<D>&, int);                                                                       \
    template bool met_something<D>(const State<D>&, int);                                                                      \
    template void list_state<D>(StateArchive&, const Model<D>&, State<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
