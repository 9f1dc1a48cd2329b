// Viscosity of the bulk in a time step (method, section 7): an incremental splitting. The viscous step starts from
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
#include "gapflow/grid/extrapolation.hpp"
#include "gapflow/viscosity/viscous_solver.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {

namespace {

// So many times dt |u . grad u| of the pressure's change count in advection.
constexpr double inertial_share = 2;
// Velocities' changes are continued so many faces into solids.
constexpr int carried_layers = 4;

// Pressure in cells that the fluid has just uncovered: the mean of the neighbours that had one, layer by layer.
template <int D>
void continue_pressure(const Coupling<D>& coupling, CellField<D>& pressure, CellField<D>& known)
{
    const Grid<D>& grid = *coupling.grid;
    for (int layer = 0; layer < 2; ++layer) {
        exchange(grid, pressure, 1);
        exchange(grid, known, 1);
        std::vector<std::pair<Index<D>, double>> found;
        for (const Index<D>& c : coupling.fractions->surface_cells) {
            if (coupling.system.component(c) < 0 || known(c) > 0)
                continue;
            double sum = 0;
            int count = 0;
            for (int side = 0; side < 2 * D; ++side) {
                const Index<D> g = c + (2 * (side % 2) - 1) * step<D>(side / 2);
                if (known(g) > 0) {
                    sum += pressure(g);
                    ++count;
                }
            }
            if (count > 0)
                found.emplace_back(c, sum / count);
        }
        for (const auto& [c, value] : found) {
            pressure(c) = value;
            known(c) = 1;
        }
    }
    exchange(grid, pressure, 1);
    exchange(grid, known, 1);
}

// u -= dt grad p / rho on open faces between cells whose pressure is known; `changed` gets 1 there. Beyond an open side the pressure
// is 0, half a cell away.
template <int D>
void subtract_known_gradient(const Coupling<D>& coupling, const CellField<D>& pressure, const CellField<D>& known, double dt,
                             FaceField<D>& u, FaceField<D, std::int8_t>* changed = nullptr)
{
    const Grid<D>& grid = *coupling.grid;
    const double scale = dt / (coupling.density * grid.dx());
    for (int axis = 0; axis < D; ++axis) {
        const long back = pressure.block().stride[axis];
        // n faces of a row from `first` on, with cells of the domain above and below them (`above`, `below`: 1, or 0 on a side).
        auto subtract = [&](const Index<D>& first, int n, double above, double below) {
            const double *a = &coupling.system.conductance(axis, first), *p = &pressure(first), *k = &known(first);
            double* to = &u(axis, first);
            const double up = scale * above * (2 - below), down = scale * below * (2 - above);
            for (int i = 0; i < n; ++i) {
                const double counts = a[i] > 0 ? 1.0 : 0.0, above_known = 1 + above * (k[i] - 1), below_known = 1 + below * (k[i - back] - 1);
                to[i] -= counts * above_known * below_known * (up * p[i] - down * p[i - back]);
            }
            if (!changed)
                return;
            std::int8_t* marks = &(*changed)(axis, first);
            for (int i = 0; i < n; ++i)
                marks[i] = a[i] > 0 && (above == 0 || k[i] > 0) && (below == 0 || k[i - back] > 0);
        };
        Index<D> low = grid.low(), end = owned_faces_end(grid, axis);
        for (int side = 0; side < 2; ++side) {
            Index<D> first = low, last = end;
            const int place = side * grid.cells()[axis];
            if (grid.periodic(axis) || (side ? end[axis] - 1 : low[axis]) != place)
                continue;
            first[axis] = place;
            last[axis] = place + 1;
            for_each_row<D>(first, last, [&](const Index<D>& row) { subtract(row, last[0] - first[0], 1 - side, side); });
            (side ? end : low)[axis] += side ? -1 : 1;
        }
        for_each_row_on_threads<D>(low, end, [&](const Index<D>& row) { subtract(row, end[0] - low[0], 1, 1); });
    }
}

// Limits the length of g to inertial_share times what the flow changes by along its way, |dt u . grad u|, as u and u half a step on
// tell: at a face the larger of the two cells'. Then half_way += g / 2.
template <int D>
void limit_to_inertia(const Grid<D>& grid, const FaceField<D>& u, FaceField<D>& half_way, FaceField<D>& g)
{
    CellField<D> most(grid);
    const int width = grid.high()[0] - grid.low()[0];
    for_each_row_on_threads<D>(grid.low(), grid.high(), [&](const Index<D>& row) {
        double* to = &most(row);
        for (int axis = 0; axis < D; ++axis) {
            const double *a = &half_way(axis, row), *b = &u(axis, row);
            const long up = most.block().stride[axis];
            for (int i = 0; i < width; ++i) {
                const double below = a[i] - b[i], above = a[i + up] - b[i + up];
                to[i] += below * below + above * above;
            }
        }
        for (int i = 0; i < width; ++i)
            to[i] = inertial_share * std::sqrt(2 * to[i]);
    });
    exchange(grid, most, 1);
    for (int axis = 0; axis < D; ++axis) {
        const Index<D> end = owned_faces_end(grid, axis);
        const long back = most.block().stride[axis];
        for_each_row_on_threads<D>(grid.low(), end, [&](const Index<D>& row) {
            const double* m = &most(row);
            double *change = &g(axis, row), *middle = &half_way(axis, row);
            for (int i = 0; i < end[0] - grid.low()[0]; ++i) {
                const double largest = std::max(m[i], m[i - back]);
                change[i] = std::clamp(change[i], -largest, largest);
                middle[i] += 0.5 * change[i];
            }
        });
    }
}

} // namespace

// The bulk's advection of second order in time. With g = -dt grad p^n / rho, what the pressure does to the fluid in a step,
//
//     v = A_{dt/2}(u) + g / 2,     u* = A_v(u) + 1/2 (A_v(g) - g),
//
// traces follow the velocity v of the middle of the step, and half of the pressure's change counts where the fluid comes from. Without the
// latter steady flow loses energy as if it were dt |u|^2 / 2 more viscous along its streamlines. What viscosity balances of the pressure
// gradient accelerates nothing: no more of g counts than twice dt |u . grad u|.
template <int D>
void Simulation<D>::advect_with_pressure(FaceField<D>& u_star, double dt, AdvectionScheme scheme, const FaceField<D, std::int8_t>* plain)
{
    const Coupling<D>& c = *coupling_;
    const BoundaryVelocity<D> sides = side_velocities(time_);
    continue_pressure(c, viscous_.pressure, viscous_.known);
    FaceField<D> change(grid_), middle(grid_);
    FaceField<D, std::int8_t> valid(grid_);
    subtract_known_gradient(c, viscous_.pressure, viscous_.known, dt, change, &valid);
    extrapolate(grid_, change, valid, carried_layers);
    advect<D>(grid_, middle, velocity_.grid, velocity_.grid, 0.5 * dt, AdvectionScheme::semi_lagrangian, sides);
    fill_velocity_ghosts(grid_, middle, sides);
    limit_to_inertia(grid_, velocity_.grid, middle, change);
    fill_velocity_ghosts(grid_, change, {});
    fill_velocity_ghosts(grid_, middle, sides);
    advect<D>(grid_, u_star, middle, velocity_.grid, dt, scheme, sides, nullptr, plain, &change);
}

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
    subtract_known_gradient(c, viscous_.pressure, viscous_.known, dt, u.grid);
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
        viscous_.known(c) = has_pressure;
        viscous_.pressure(c) = has_pressure ? impulse_.cells(c) / dt - share * viscous_.divergence(c) : 0.0;
    });
    if (impact) // what stopped the bodies does not go on
        std::fill(viscous_.force.begin(), viscous_.force.end(), Twist<D>(Twist<D>::Zero()));
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template void Simulation<D>::advect_with_pressure(FaceField<D>&, double, AdvectionScheme, const FaceField<D, std::int8_t>*); \
    template void Simulation<D>::add_viscosity(FluidVelocity<D>&, std::vector<Twist<D>>&, double, StepReport&);                \
    template void Simulation<D>::remember_projection(const std::vector<Twist<D>>&, double);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
