// Velocities carried to the new configuration: bulk, films and mouths together (method, "The time step", stages 2 and 4).
#include "gapflow/stepping/simulation.hpp"

#include "gapflow/film/film_vorticity.hpp"
#include "gapflow/stepping/advection.hpp"
#include "gapflow/stepping/film_turn.hpp"
#include "gapflow/stepping/flooding.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {

// Stages 2 and 4: the fluid's velocities carried to the new configuration.
template <int D>
FluidVelocity<D> Simulation<D>::advect_all(double dt, std::vector<double>& conduit_scale, FaceField<D>& change)
{
    const auto timer = stages_.measure("advection");
    FluidVelocity<D> u_star;
    u_star.grid = FaceField<D>(grid_);
    FilmFlow<D> flow = advect_films<D>(
        coupling_->network, coupling_->solids, memories_, predicted_twists(dt),
        [&](const std::vector<Vec<D>>& points) { return sample(points); }, mouth_laws_, dt);
    damp_vorticity(coupling_->network, grid_.dx(), flow.velocity);
    turn_films<D>(coupling_->network, coupling_->solids, memories_, turning_, predicted_twists(dt), flow);
    if (voids_.any())
        flood(flow, dt);
    const BoundaryVelocity<D> sides = side_velocities(time_);
    const FaceField<D, std::int8_t>* plain = faces_near_jets(flow.conduit);
    const bool any_slivers = grid_.comm().any(!slivers_.empty());
    for (const Sliver& face : slivers_)
        velocity_.grid(face.axis, face.at) = face.continued;
    if (any_slivers)
        fill_velocity_ghosts(grid_, velocity_.grid, sides);
    change = advect_bulk(u_star.grid, dt, plain);
    for (const Sliver& face : slivers_) {
        velocity_.grid(face.axis, face.at) = face.own;
        const double open = std::max(coupling_->open(face.axis, face.at), face.open);
        const double stays = std::max(0.0, 1 - dt * std::abs(face.own) / grid_.dx());
        u_star.grid(face.axis, face.at) += stays * face.open / open * (face.own - face.continued);
    }
    if (any_slivers)
        fill_velocity_ghosts(grid_, velocity_.grid, sides);
    if (any_film_faces_) {
        const auto& cells = coupling_->network.cells.cells;
        auto beside_film = [&](int axis, const Index<D>& f) {
            return cells.contains(grid_.key(grid_.wrapped(f))) ||
                   cells.contains(grid_.key(grid_.wrapped(Index<D>(f - gapflow::step<D>(axis)))));
        };
        for (int axis = 0; axis < D; ++axis)
            for_each_marked<D>(film_faces_[axis], grid_.low(), owned_faces_end(grid_, axis), 1, [&](const Index<D>& f) {
                // Where a film still passes, its conduits carry its flow: there the bulk's own velocity counts.
                if (beside_film(axis, f))
                    film_faces_(axis, f) = 0;
            });
        advect_marked_faces(grid_, u_star.grid, painted_, film_faces_, dt);
        share_uncovered_faces(u_star.grid);
    }
    fill_velocity_ghosts(grid_, u_star.grid, side_velocities(time_ + dt));

    u_star.film = std::move(flow.velocity);
    u_star.film_normal = std::move(flow.normal);
    u_star.conduit = std::move(flow.conduit);
    conduit_scale = std::move(flow.conduit_scale);
    return u_star;
}

// Fluid entering voids: what the mouths let in, and how far it gets in this step.
template <int D>
void Simulation<D>::flood(FilmFlow<D>& flow, double dt)
{
    const std::vector<Conduit<D>>& conduits = coupling_->network.mouths.conduits;
    std::vector<double> pressure(conduits.size(), 0.0); // of the last step's bulk, where the conduits are now
    for (std::size_t r = 0; r < conduits.size() && last_dt_ > 0; ++r)
        for (const auto& [key, weight] : conduits[r].cells)
            if (const Index<D> c = grid_.cell_of_key(key); grid_.owns(c))
                pressure[r] += weight * impulse_.cells(c) / last_dt_;
    grid_.comm().sum(pressure);
    rest_in_voids<D>(*coupling_, voids_.empty_elements(coupling_->network), twists(), flow.velocity);
    limit_inflow<D>(*coupling_, voids_, memories_, mouth_laws_, pressure, dt, flow);
    pass_on<D>(*coupling_, voids_, twists(), dt, flow);
}

// Faces near the mouths of films that flow out somewhere: the jets there are thinner than a cell, and MacCormack's correction,
// clamped or not, feeds on them until the flow through a valve's seat grows without bound. Where a film only fills, it stays.
// `flux`: out of each conduit, absolute.
template <int D>
const FaceField<D, std::int8_t>* Simulation<D>::faces_near_jets(const std::vector<double>& flux)
{
    constexpr int reach = 2;              // cells
    constexpr double least_weight = 1e-3; // round-off must not choose faces
    const std::vector<Conduit<D>>& conduits = coupling_->network.mouths.conduits;
    const std::vector<Twist<D>> V = twists();
    std::vector<char> flows_out(coupling_->network.films.size(), 0);
    for (std::size_t r = 0; r < conduits.size(); ++r) {
        const Conduit<D>& conduit = conduits[r];
        const int master = coupling_->network.films[conduit.film].mesh.master;
        const Vec<D> U = velocity_at<D>(V[master], conduit.x - coupling_->solids[master].centre);
        if (flux[r] > conduit.length * conduit.h * conduit.outward.dot(U))
            flows_out[conduit.film] = 1;
    }
    if (std::none_of(flows_out.begin(), flows_out.end(), [](char out) { return out; }))
        return nullptr;
    if (near_jets_[0].size() == 0)
        near_jets_ = FaceField<D, std::int8_t>(grid_);
    for (int axis = 0; axis < D; ++axis)
        near_jets_[axis].fill(0);
    for (const Conduit<D>& conduit : conduits) {
        if (!flows_out[conduit.film])
            continue;
        for (const auto& [key, weight] : conduit.cells) {
            if (std::abs(weight) < least_weight)
                continue;
            const Index<D> c = grid_.cell_of_key(key);
            for (int axis = 0; axis < D; ++axis)
                for_each_index<D>(c - Index<D>::Constant(reach), c + Index<D>::Constant(reach + 1) + gapflow::step<D>(axis),
                                  [&](const Index<D>& f) {
                                      if (near_jets_[axis].block().contains(f))
                                          near_jets_(axis, f) = 1;
                                  });
        }
    }
    return &near_jets_;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template FluidVelocity<D> Simulation<D>::advect_all(double, std::vector<double>&, FaceField<D>&);                          \
    template void Simulation<D>::flood(FilmFlow<D>&, double);                                                                  \
    template const FaceField<D, std::int8_t>* Simulation<D>::faces_near_jets(const std::vector<double>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
