#include "gapflow/stepping/diffusion.hpp"

#include "gapflow/body/forces.hpp"
#include "gapflow/core/error.hpp"
#include "gapflow/core/threads.hpp"
#include "gapflow/stepping/contact_stop.hpp"
#include "gapflow/stepping/extrapolation_share.hpp"
#include "gapflow/viscosity/viscous_solver.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {

template <int D>
Diffusion<D> diffuse(const Model<D>& model, const std::vector<RigidBody<D>>& bodies, const ContactSet<D>& contacts,
                     const std::vector<TwistMatrix<D>>& mass, const LastPressure<D>& past, const Coupling<D>& there,
                     const Step& step, Intermediate<D>& star, StepReport& report)
{
    const Grid<D>& grid = model.grid;
    FluidVelocity<D>& u_star = star.velocity;
    ViscousBodies<D> moving{mass, star.twists};
    for (std::size_t b = 0; b < bodies.size(); ++b)
        if (bodies[b].motion == Motion::free)
            moving.twists[b] += impulse_response(bodies[b], Twist<D>(step.dt * past.force[b]), step.dt);
    if (!contacts.empty())
        moving.twists = stopped_by_contacts(contacts, bodies, moving.twists, step.dt);
    FluidVelocity<D> u = u_star;
    SidePressures<D> beyond = model.pressure_beyond(step.start);
    for (double& pressure : beyond) // as recall_pressure() does with the bulk's
        pressure *= std::min(1.0, extrapolation_share(step.last_dt, step.dt));
    subtract_known_gradient(there, past.bulk, step.dt, u.grid, beyond);
    fill_velocity_ghosts(grid, u.grid, model.sides(step.end()));

    const ViscousSystem<D> system =
        viscous_system(there, model.scene.viscosity, step.dt, u.grid, moving, to_vec<D>(model.scene.fluid_velocity));
    const FaceField<D> before = u.grid;
    ViscousSolution<D> solved = solve_viscous_system(system, u.grid, moving, model.scene.tolerance);
    if (!solved.report.converged)
        throw ComputationError("the viscous solve of step " + std::to_string(step.number) + " did not converge (" +
                               std::to_string(solved.report.iterations) + " iterations, relative residual " +
                               std::to_string(solved.report.residual) + ")");
    report.viscous_iterations = solved.report.iterations;

    double changed = 0; // sum of open fraction times (change of u)^2
    for (int axis = 0; axis < D; ++axis) {
        const Index<D> low = grid.low(), end = owned_faces_end(grid, axis);
        changed += sum_over_planes(low[D - 1], end[D - 1], [&](int plane) {
            double of_plane = 0;
            for_each_row_of_plane<D>(low, end, plane, [&](const Index<D>& row) {
                const double *after = &u.grid(axis, row), *from = &before(axis, row), *open = &there.open(axis, row);
                double* to = &u_star.grid(axis, row);
                const SpreadRow<D> spread(grid, axis, row);
                for (int i = 0; i < end[0] - low[0]; ++i) {
                    const int place = row[axis] + (axis == 0 ? i : 0);
                    const bool on_side = !grid.periodic(axis) && (place == 0 || place == grid.cells()[axis]);
                    const double change = after[i] - from[i];
                    to[i] += change;
                    of_plane += (on_side ? 0.5 : 1.0) * spread[i] * open[i] * change * change;
                }
            });
            return of_plane;
        });
    }
    fill_velocity_ghosts(grid, u_star.grid, model.sides(step.end()));
    double held = 0;
    for (const HeldMass& face : system.beside_walls) {
        const double change = u.grid[face.axis].data()[face.at] - before[face.axis].data()[face.at];
        held += face.mass * change * change;
    }
    double lost = solved.energy - grid.comm().sum(system.cell_mass * changed - held);
    for (std::size_t b = 0; b < bodies.size(); ++b)
        if (bodies[b].motion == Motion::free) {
            const Twist<D> change = solved.twists[b] - moving.twists[b];
            star.twists[b] += change;
            lost -= change.dot(moving.mass[b] * change);
        }
    report.dissipation_grid = lost / step.dt;

    // div u** of the cells with open faces on the grid.
    fill_velocity_ghosts(grid, u.grid, model.sides(step.end()));
    UnknownVector<D> outflow_of_cells;
    outflow(there, u, solved.twists, outflow_of_cells);
    CellField<D> divergence = std::move(outflow_of_cells.cells);
    for (const Mouth<D>& mouth : there.network.rim.mouths)
        for (const auto& [key, weight] : mouth.cells)
            if (const Index<D> cell = grid.cell_of_key(key); grid.owns(cell))
                divergence(cell) = 0;
    return {std::move(solved.impulses), std::move(divergence)};
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template Diffusion<D> diffuse<D>(const Model<D>&, const std::vector<RigidBody<D>>&, const ContactSet<D>&,                  \
                                     const std::vector<TwistMatrix<D>>&, const LastPressure<D>&, const Coupling<D>&,           \
                                     const Step&, Intermediate<D>&, StepReport&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
