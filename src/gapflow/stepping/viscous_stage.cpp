// Viscosity of the bulk in a time step (method, "Viscosity"): an incremental splitting. The viscous step starts from
// velocities and twists that the last step's pressure (and whatever else the projection did to the bodies: films, contacts) has
// already acted on,
//
//     u~ = u* - dt grad p^n / rho,   V~ = V* + dt M^-1 F^n,     (u**, V**) = viscous step of (u~, V~),
//     (u*, V*) += (u**, V**) - (u~, V~),
//
// and the projection that follows finds the whole pressure anew. A steady state does not depend on dt. In the next step p^n is
// the projection's pressure less mu div u** (the rotational form; Timmermans, Minev & van de Vosse, Int. J. Numer. Meth. Fluids
// 22, 1996), with which transients stay short for any nu dt / dx^2.
#include "gapflow/stepping/simulation.hpp"

#include "gapflow/body/forces.hpp"
#include "gapflow/core/error.hpp"
#include "gapflow/core/threads.hpp"
#include "gapflow/viscosity/viscous_solver.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {

template <int D>
void Simulation<D>::add_viscosity(FluidVelocity<D>& u_star, std::vector<Twist<D>>& V_star, double dt, StepReport& report)
{
    const auto timer = stages_.measure("viscosity");
    const Coupling<D>& c = *coupling_;
    ViscousBodies<D> bodies{masses(), V_star};
    for (std::size_t b = 0; b < bodies_.size(); ++b)
        if (bodies_[b].motion == Motion::free)
            bodies.twists[b] += impulse_response(bodies_[b], Twist<D>(dt * viscous_.force[b]), dt);
    FluidVelocity<D> u = u_star;
    subtract_known_gradient(c, past_, dt, u.grid);
    fill_velocity_ghosts(grid_, u.grid, side_velocities(time_ + dt));

    const ViscousSystem<D> system = viscous_system(c, scene_.viscosity, dt, u.grid, bodies);
    const FaceField<D> before = u.grid;
    const ViscousStep<D> step = solve_viscous_system(system, u.grid, bodies, scene_.tolerance);
    if (!step.report.converged)
        throw ComputationError("the viscous solve of step " + std::to_string(steps_ + 1) + " did not converge (" +
                               std::to_string(step.report.iterations) + " iterations, relative residual " +
                               std::to_string(step.report.residual) + ")");
    report.viscous_iterations = step.report.iterations;
    viscous_.impulse = step.impulses;

    double changed = 0; // sum of open fraction times (change of u)^2
    for (int axis = 0; axis < D; ++axis) {
        const Index<D> low = grid_.low(), end = owned_faces_end(grid_, axis);
        changed += sum_over_planes(low[D - 1], end[D - 1], [&](int plane) {
            double of_plane = 0;
            for_each_row_of_plane<D>(low, end, plane, [&](const Index<D>& row) {
                const double *after = &u.grid(axis, row), *from = &before(axis, row), *open = &c.open(axis, row);
                double* to = &u_star.grid(axis, row);
                for (int i = 0; i < end[0] - low[0]; ++i) {
                    const int place = row[axis] + (axis == 0 ? i : 0);
                    const bool on_side = !grid_.periodic(axis) && (place == 0 || place == grid_.cells()[axis]);
                    const double change = after[i] - from[i];
                    to[i] += change;
                    of_plane += (on_side ? 0.5 : 1.0) * open[i] * change * change;
                }
            });
            return of_plane;
        });
    }
    fill_velocity_ghosts(grid_, u_star.grid, side_velocities(time_ + dt));
    double held = 0;
    for (const HeldMass& face : system.beside_walls) {
        const double change = u.grid[face.axis].data()[face.at] - before[face.axis].data()[face.at];
        held += face.mass * change * change;
    }
    double lost = step.energy - grid_.comm().sum(system.cell_mass * changed - held);
    for (std::size_t b = 0; b < bodies_.size(); ++b)
        if (bodies_[b].motion == Motion::free) {
            const Twist<D> change = step.twists[b] - bodies.twists[b];
            V_star[b] += change;
            lost -= change.dot(bodies.mass[b] * change);
        }
    report.dissipation_grid = lost / dt;

    // div u** of the cells that the grid's own faces drain.
    fill_velocity_ghosts(grid_, u.grid, side_velocities(time_ + dt));
    UnknownVector<D> outflow_of_cells;
    outflow(c, u, step.twists, outflow_of_cells);
    viscous_.divergence = std::move(outflow_of_cells.cells);
    for (const Conduit<D>& conduit : c.network.mouths.conduits)
        for (const auto& [key, weight] : conduit.cells)
            if (const Index<D> cell = grid_.cell_of_key(key); grid_.owns(cell))
                viscous_.divergence(cell) = 0;
}

// After the projection: what the next viscous step starts from, and the viscous traction's share of the wrenches.
template <int D>
void Simulation<D>::remember_projection(const std::vector<Twist<D>>& V_star, double dt)
{
    const std::vector<TwistMatrix<D>> mass = masses();
    bool impact = false;
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        wrenches_[b] += viscous_.impulse[b] / dt;
        impact = impact || contacts_.impact_on(static_cast<int>(b));
        viscous_.force[b] = bodies_[b].motion == Motion::free ? Twist<D>(mass[b] * (bodies_[b].twist - V_star[b]) / dt)
                                                              : Twist<D>(Twist<D>::Zero());
    }
    const double share = scene_.viscosity / std::pow(grid_.dx(), D);
    for_each_index<D>(grid_.low(), grid_.high(), [&](const Index<D>& c) {
        const bool has_pressure = !impact && coupling_->system.component(c) >= 0;
        past_.known(c) = has_pressure;
        past_.pressure(c) = has_pressure ? impulse_.cells(c) / dt - share * viscous_.divergence(c) : 0.0;
    });
    if (impact) { // what stopped the bodies does not go on
        std::fill(viscous_.force.begin(), viscous_.force.end(), Twist<D>(Twist<D>::Zero()));
        return;
    }
    // Bodies feel the pressure that the fluid starts from.
    UnknownVector<D> rotational{CellField<D>(grid_), Eigen::VectorXd::Zero(coupling_->system.nodes)};
    for_each_index<D>(grid_.low(), grid_.high(), [&](const Index<D>& c) {
        rotational.cells(c) = past_.known(c) > 0 ? -share * viscous_.divergence(c) : 0.0;
    });
    const std::vector<Twist<D>> on_bodies = impulses(*coupling_, rotational);
    for (std::size_t b = 0; b < bodies_.size(); ++b)
        if (bodies_[b].motion == Motion::free)
            viscous_.force[b] += on_bodies[b];
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template void Simulation<D>::add_viscosity(FluidVelocity<D>&, std::vector<Twist<D>>&, double, StepReport&);                \
    template void Simulation<D>::remember_projection(const std::vector<Twist<D>>&, double);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
