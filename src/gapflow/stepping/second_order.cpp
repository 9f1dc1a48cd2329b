// The time step's second order (method, "The time step"): the bulk's pressure of the last step on the way through this one, for the fluid and for
// bodies, and what it does in films.
#include "gapflow/stepping/simulation.hpp"

#include "gapflow/body/forces.hpp"
#include "gapflow/stepping/carried_on.hpp"
#include "gapflow/stepping/leaving.hpp"
#include "gapflow/stepping/past_pressure.hpp"

#include <algorithm>

namespace gapflow {

namespace {

// Marks (nonzero) the faces beside places where a single closed face separates open ones: what is continued there is the mean of the flows
// on the two sides of a body of one to two cells, and MacCormack's correction takes the difference for a gradient. `open`: of the flow;
// faces open by no more than `widest` count as closed. Returns whether there are any. Collective.
template <int D>
bool mark_across_thin_bodies(const Grid<D>& grid, const FaceField<D>& open, double widest, FaceField<D, std::int8_t>& marks)
{
    FaceField<D, std::int8_t> between(grid);
    bool any = false;
    for (int axis = 0; axis < D; ++axis) {
        const CellField<D>& a = open[axis];
        const Index<D> end = owned_faces_end(grid, axis);
        for_each_row<D>(grid.low(), end, [&](const Index<D>& row) {
            const double* value = &a(row);
            std::int8_t* to = &between(axis, row);
            for (int i = 0; i < end[0] - grid.low()[0]; ++i)
                for (int k = 0; k < D && value[i] <= widest; ++k) {
                    const long stride = a.block().stride[k];
                    if (value[i + stride] > widest && value[i - stride] > widest) {
                        to[i] = 1;
                        any = true;
                    }
                }
        });
    }
    if (!grid.comm().any(any))
        return false;
    exchange(grid, between);
    const Index<D> one = Index<D>::Ones();
    for (int axis = 0; axis < D; ++axis) {
        const Block<D>& block = between[axis].block();
        for_each_index<D>(grid.low() - one, owned_faces_end(grid, axis) + one, [&](const Index<D>& f) {
            if (!between(axis, f))
                return;
            for (int other = 0; other < D; ++other)
                for_each_index<D>((f - one).cwiseMax(block.low), (f + 2 * one).cwiseMin(block.high),
                                  [&](const Index<D>& g) { marks(other, g) = 1; });
        });
    }
    return true;
}

// Fluid that comes in through an open side comes from a reservoir that moves with `outside`, the fluid's initial velocity: with w its speed
// across the side, p = rho (w_outside^2 - w^2) / 2 there, where it comes in faster than that. With p = 0 it would bring the energy of any
// speed along, and beside a body that leaves, where ideal flow is singular, it comes in ever faster.
template <int D>
void add_inflow_head(const Grid<D>& grid, const Vec<D>& outside, double dt, FaceField<D>& u)
{
    for (int axis = 0; axis < D; ++axis)
        for (int end = 0; end < 2; ++end) {
            const int place = end * grid.cells()[axis];
            Index<D> from = grid.low(), to = owned_faces_end(grid, axis);
            if (grid.side(axis, end) != SideKind::open || from[axis] > place || to[axis] <= place)
                continue;
            from[axis] = place;
            to[axis] = place + 1;
            const double free = outside[axis] * outside[axis];
            for_each_index<D>(from, to, [&](const Index<D>& f) {
                const double w = end == 0 ? u(axis, f) : -u(axis, f);
                if (w > 0 && w * w > free)
                    u(axis, f) /= 1 + dt * (w - free / w) / grid.dx();
            });
        }
}

} // namespace

// Whether a contact or a film that turned changed the body's motion in the last step at once: then the change is no acceleration that goes on.
template <int D>
bool Simulation<D>::met_something(int body) const
{
    return contacts_.impact_on(body) || std::any_of(turning_.begin(), turning_.end(), [&](const FilmPair<D>& pair) {
               return pair.master == body || pair.other == body;
           });
}

// The bulk's pressure at the end of the last step; none where bodies met: what stopped them does not go on. Nor where a body crosses an open
// side: about the line where its surface leaves the fluid ideal flow is singular, and the pressure of one step says nothing of the next.
// With viscosity the projection before has left it (remember_projection), with its forces on bodies; of what a much shorter step found only a
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
    for (const Whereabouts& place : whereabouts(scene_, bodies_))
        impact = impact || !place.crossed.empty();
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
    const AdvectionScheme scheme =
        scene_.advection == Scene::Advection::maccormack ? AdvectionScheme::maccormack : AdvectionScheme::semi_lagrangian;
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
    FaceField<D, std::int8_t> uncorrected;
    if (scheme == AdvectionScheme::maccormack) {
        uncorrected = plain ? *plain : FaceField<D, std::int8_t>(grid_);
        if (mark_across_thin_bodies(grid_, old_fractions_->open, sliver(), uncorrected))
            plain = &uncorrected;
    }
    advect<D>(grid_, u_star, middle, velocity_.grid, dt, scheme, sides, plain, &change);
    add_inflow_head(grid_, to_vec<D>(scene_.fluid_velocity), dt, u_star);
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
