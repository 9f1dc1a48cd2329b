// The time step's second order (method, section 5): the bulk's pressure of the last step on the way through this one, for the fluid and for
// bodies, and what it does in films.
#include "gapflow/stepping/simulation.hpp"

#include "gapflow/body/forces.hpp"
#include "gapflow/stepping/carried_on.hpp"
#include "gapflow/stepping/past_pressure.hpp"

#include <algorithm>

namespace gapflow {

// Whether a contact or a film that turned changed the body's motion in the last step at once: then the change is no acceleration that goes on.
template <int D>
bool Simulation<D>::met_something(int body) const
{
    return contacts_.impact_on(body) ||
           std::any_of(turning_.begin(), turning_.end(), [&](const FilmPair<D>& pair) { return pair.master == body || pair.other == body; });
}

// The bulk's pressure at the end of the last step; none where bodies met: what stopped them does not go on. With viscosity the
// projection before has left it (remember_projection), with its forces on bodies; of what a much shorter step found only a
// share goes on, as with bodies' accelerations.
template <int D>
void Simulation<D>::recall_pressure()
{
    if (scene_.viscosity > 0) {
        const double share = carried_on(last_dt_, dt_);
        if (share < 1) {
            for (long i = 0; i < past_.pressure.size(); ++i)
                past_.pressure.data()[i] *= share;
            for (Twist<D>& force : viscous_.force)
                force *= share;
        }
        return;
    }
    past_.pressure = past_.known = CellField<D>(grid_);
    bool impact = last_dt_ == 0;
    for (std::size_t b = 0; b < bodies_.size(); ++b)
        impact = impact || met_something(static_cast<int>(b));
    if (impact)
        return;
    for_each_index<D>(grid_.low(), grid_.high(), [&](const Index<D>& c) {
        if (coupling_->system.component(c) >= 0) {
            past_.known(c) = 1;
            past_.pressure(c) = impulse_.cells(c) / last_dt_;
        }
    });
}

// Stage 2: the bulk's velocities at the step's end without pressure. Returns what the last pressure adds to velocities in the step.
template <int D>
FaceField<D> Simulation<D>::advect_bulk(FaceField<D>& u_star, double dt, const FaceField<D, std::int8_t>* plain)
{
    const BoundaryVelocity<D> sides = side_velocities(time_);
    const AdvectionScheme scheme = scene_.advection == Scene::Advection::maccormack ? AdvectionScheme::maccormack
                                                                                    : AdvectionScheme::semi_lagrangian;
    continue_pressure(*coupling_, past_);
    FaceField<D> change = velocity_change(*coupling_, past_, dt);
    if (scene_.viscosity == 0)
        past_ = {};
    FaceField<D> middle(grid_);
    advect<D>(grid_, middle, velocity_.grid, velocity_.grid, 0.5 * dt, AdvectionScheme::semi_lagrangian, sides);
    fill_velocity_ghosts(grid_, middle, sides);
    limit_to_inertia(grid_, velocity_.grid, middle, change);
    fill_velocity_ghosts(grid_, change, {});
    fill_velocity_ghosts(grid_, middle, sides);
    advect<D>(grid_, u_star, middle, velocity_.grid, dt, scheme, sides, nullptr, plain, &change);
    return change;
}

// Stage 5: twists of free bodies after all forces but the fluid's, and what the last pressure does on their way; of others as given.
// `change`: what it does to the fluid's velocity. (A hinged body's pressure turns it about its hinge: left out.)
template <int D>
std::vector<Twist<D>> Simulation<D>::forced_twists(double dt, const FaceField<D>& change) const
{
    const std::vector<Vec<D>> swept =
        swept_impulses(grid_, scene_.density, change, *old_fractions_, *coupling_->fractions, bodies_.size());
    std::vector<Twist<D>> V = twists();
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        if (bodies_[b].motion != Motion::free)
            continue;
        V[b] = forced_twist<D>(bodies_[b], to_vec<D>(scene_.gravity), scene_.density, dt);
        if (!bodies_[b].hinge)
            V[b] += impulse_response(bodies_[b], wrench<D>(swept[b], Vec<D>(Vec<D>::Zero())), dt);
    }
    return V;
}

// What the pressure accelerates the elements of flat films by at the end of the step (curved ones would grow about points of
// contact). The step itself tells of its middle, and, where the flat films' meshes stay, so did the step before.
template <int D>
void Simulation<D>::remember_push(const std::vector<Vec<D>>& without, double dt)
{
    std::vector<Vec<D>> push;
    std::vector<std::size_t> place;
    for (const Film<D>& film : coupling_->network.films) {
        if (without.empty() || !film.mesh.flat)
            continue;
        for (std::size_t i = 0; i < film.mesh.elements.size(); ++i) {
            place.push_back(film.first_element + i);
            push.push_back((velocity_.film[place.back()] - without[place.back()]) / dt);
        }
    }
    film_push_.assign(push.empty() ? 0 : without.size(), Vec<D>::Zero());
    const bool same = push.size() == last_push_.size();
    for (std::size_t i = 0; i < push.size(); ++i)
        film_push_[place[i]] = same ? Vec<D>(push[i] + dt / (dt + last_dt_) * (push[i] - last_push_[i])) : push[i];
    last_push_ = std::move(push);
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template bool Simulation<D>::met_something(int) const;                                                                     \
    template void Simulation<D>::recall_pressure();                                                                            \
    template FaceField<D> Simulation<D>::advect_bulk(FaceField<D>&, double, const FaceField<D, std::int8_t>*);                 \
    template std::vector<Twist<D>> Simulation<D>::forced_twists(double, const FaceField<D>&) const;                            \
    template void Simulation<D>::remember_push(const std::vector<Vec<D>>&, double);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
