// The state between two steps, stored and restored. The lists of list_state() are all that goes from step to step; what follows
// from it (fractions, films, the coupled system, velocities continued into solids and films, what films remember) is built
// again by the same code that built it.
#include "gapflow/stepping/simulation.hpp"

#include "gapflow/body/body_state.hpp"
#include "gapflow/film/film_state.hpp"
#include "gapflow/grid/whole_field.hpp"

namespace gapflow {

namespace {

template <int D>
void list_pairs(StateArchive& archive, const std::string& name, std::set<FilmPair<D>>& pairs)
{
    std::vector<FilmPair<D>> list(pairs.begin(), pairs.end());
    archive.each(name, list, [](StateArchive& items, FilmPair<D>& pair) { gapflow::list_state(items, pair); });
    pairs = {list.begin(), list.end()};
}

} // namespace

// A class that carries something between steps adds its own list_state() here.
template <int D>
void Simulation<D>::list_state(StateArchive& archive)
{
    archive("step", steps_);
    archive("time", time_);
    archive("last_step_length", dt_);
    std::size_t bodies = bodies_.size();
    archive("body_count", bodies);
    if (bodies != bodies_.size())
        throw StateError("it has " + std::to_string(bodies) + " bodies, the scene " + std::to_string(bodies_.size()));
    archive.group("bodies", [&] {
        for (RigidBody<D>& body : bodies_)
            gapflow::list_state(archive, body);
        for (Twist<D>& wrench : wrenches_)
            archive("fluid_wrench", wrench);
    });
    archive("acceleration", acceleration_);
    archive("light_bodies", light_bodies_);
    contacts_.list_state(archive);
    voids_.list_state(archive);
    list_pairs(archive, "films_before", alive_);
    list_pairs(archive, "films_turned", turning_);
    list_field(archive, "velocity", grid_, velocity_.grid);
    list_field(archive, "pressure_impulse", grid_, impulse_.cells);
    archive.group("films", [&] {
        archive("pressure_impulse", impulse_.nodes);
        archive("outflow", node_outflow_);
        archive("velocity", velocity_.film);
        archive("normal_speed", velocity_.film_normal);
        archive("push", film_push_);
        archive("last_push", last_push_);
    });
    archive("conduit_flux", velocity_.conduit);
    if (scene_.viscosity > 0)
        archive.group("viscosity", [&] {
            list_field(archive, "pressure", grid_, past_.pressure);
            list_field(archive, "known", grid_, past_.known);
            archive("force", viscous_.force);
        });
}

template <int D>
StoredState Simulation<D>::state() const
{
    StoredState state;
    StateArchive archive(state);
    const_cast<Simulation*>(this)->list_state(archive); // one list for both ways; storing changes nothing
    return state;
}

template <int D>
Simulation<D>::Simulation(const Scene& scene, const Communicator& comm, const StoredState& state)
    : Simulation(Unprepared{}, scene, comm)
{
    StateArchive archive(state);
    list_state(archive);
    archive.finish();
    if (acceleration_.size() != walls_.solids.size() + bodies_.size())
        throw StateError("it has other walls than the scene");
    holding_ = steps_ == 0;
    build_coupling([this](const Coupling<D>&) { return voids_.wet_shares(); });
    holding_ = false;
    const FilmNetwork<D>& network = coupling_->network;
    if (static_cast<int>(velocity_.film.size()) != network.elements || velocity_.film_normal.size() != velocity_.film.size() ||
        impulse_.nodes.size() != network.nodes || velocity_.conduit.size() != network.mouths.conduits.size() ||
        static_cast<int>(voids_.volume().size()) != network.nodes || voids_.shut().size() != velocity_.conduit.size() ||
        (node_outflow_.size() != 0 && node_outflow_.size() != network.nodes))
        throw StateError("its films are not those that its bodies' positions give");
    if (voids_.any()) // mouths that the last step shut
        WetSystem<D>(*coupling_).take_out(voids_.is_void(), voids_.impulses(dt_), voids_.shut());
    fill_velocity_ghosts(grid_, velocity_.grid, side_velocities(time_));
    exchange(grid_, impulse_.cells);
    continue_velocities();
    finish_report(initial_report_, dt_);
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template void Simulation<D>::list_state(StateArchive&);                                                                    \
    template StoredState Simulation<D>::state() const;                                                                         \
    template Simulation<D>::Simulation(const Scene&, const Communicator&, const StoredState&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
