#include "gapflow/stepping/steadiness.hpp"

#include "gapflow/core/threads.hpp"
#include "gapflow/stepping/force_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gapflow {

namespace {

// Of an oscillation with at least twenty steps a period, half: it cannot be at its turning points all the time.
constexpr long calm_steps_needed = 10;

// Integrals over the fluid of the grid, in cells: 1, u^2, (change of u)^2.
template <int D>
std::array<double, 3> squares(const Grid<D>& grid, const Coupling<D>& here, const FaceField<D>& now, const FaceField<D>& before)
{
    std::vector<double> sums(3, 0.0);
    for (int axis = 0; axis < D; ++axis) {
        const Index<D> low = grid.low(), end = owned_faces_end(grid, axis);
        const int n = end[0] - low[0];
        auto of_plane = [&](int plane) {
            std::array<double, 3> sum{};
            for_each_row_of_plane<D>(low, end, plane, [&](const Index<D>& row) {
                const double *open = &here.open(axis, row), *u = &now(axis, row), *old = &before(axis, row);
                double size = 0, square = 0, change = 0;
                const SpreadRow<D> spread(grid, axis, row);
                for (int i = 0; i < n && grid.graded(); ++i) {
                    const double d = u[i] - old[i], volume = open[i] * spread[i];
                    size += volume;
                    square += volume * u[i] * u[i];
                    change += volume * d * d;
                }
                const int plain = grid.graded() ? 0 : n;
#pragma omp simd reduction(+ : size, square, change)
                for (int i = 0; i < plain; ++i) {
                    const double d = u[i] - old[i];
                    size += open[i];
                    square += open[i] * u[i] * u[i];
                    change += open[i] * d * d;
                }
                sum[0] += size / D;
                sum[1] += square;
                sum[2] += change;
            });
            return sum;
        };
        for (const std::array<double, 3>& sum : each_plane(low[D - 1], end[D - 1], of_plane))
            for (int i = 0; i < 3; ++i)
                sums[i] += sum[i];
    }
    grid.comm().sum(sums);
    return {sums[0], sums[1], sums[2]};
}

// Whether nothing that moves at this speed, and gathers speed at this rate, comes further in the time of the run than the solver's tolerance, in
// cells.
bool stays(const Scene& scene, double dx, double time, double speed, double rate)
{
    const double whole = std::max(scene.end, time);
    return (speed + rate * whole) * whole < scene.tolerance * dx;
}

// For how long changes at this rate go on, as they fade; `lasting`: where they do not. Takes the rate into its lagging mean.
double time_of_fading(SteadyWatch& watch, double rate, double time, double dt, double lasting)
{
    if (!std::isfinite(rate))
        return lasting;
    const double lag = 0.1 * time;
    watch.lagging_rate -= std::expm1(-dt / lag) * (rate - watch.lagging_rate);
    return rate < watch.lagging_rate ? std::min(lasting, lag / (1 - rate / watch.lagging_rate)) : lasting;
}

// Half of a body's extent; 0 of one without bounds.
template <int D>
double radius_of(const RigidBody<D>& body)
{
    const double radius = bounding_radius(body.shape->bounds());
    return std::isfinite(radius) ? radius : 0.0;
}

} // namespace

template <int D>
double unsteadiness(const Model<D>& model, const Coupling<D>& here, const EarlierFlow<D>& before, State<D>& state)
{
    SteadyWatch& watch = state.steady;
    const double tolerance = model.scene.until_steady.value_or(0.0);
    const auto [size, square, change] = squares(model.grid, here, state.velocity.grid, before.velocity);
    const double own_speed = size > 0 ? std::sqrt(square / size) : 0.0;
    watch.largest_speed = std::max(watch.largest_speed, own_speed);
    const double speed = std::max(own_speed, tolerance * watch.largest_speed);

    double of_flow = size > 0 ? std::sqrt(change / size) : 0.0, of_forces = 0, of_motion = 0, force = 0, largest = 0,
           fastest = own_speed;
    const std::vector<Twist<D>> twists = model.twists(state.bodies);
    // A torque counts as a force at the body's extent; one without bounds has none.
    const auto magnitude = [](const Twist<D>& w, double lever) {
        const double turning = w.template tail<spin_size<D>>().norm();
        return std::hypot(w.template head<D>().norm(), lever > 0 ? turning * lever : 0.0);
    };
    for (std::size_t b = 0; b < state.bodies.size(); ++b) {
        const double radius = radius_of(state.bodies[b]), lever = radius > 0 ? 1 / radius : 0.0;
        largest = std::max(largest, 2 * radius);
        force = std::max(force, magnitude(state.wrenches[b] - buoyancy(model, state.bodies[b]), lever));
        of_forces = std::max(of_forces, magnitude(state.wrenches[b] - before.wrenches[b], lever));
        of_motion = std::max(of_motion, magnitude(twists[b] - before.twists[b], radius));
        fastest = std::max(fastest, magnitude(twists[b], radius));
    }
    force = std::max(force, model.scene.density * speed * speed * std::pow(largest, D - 1));
    const auto ratio = [](double changed, double whole) {
        return changed == 0 ? 0.0 : whole > 0 ? changed / whole : std::numeric_limits<double>::infinity();
    };
    const double relative = std::max({ratio(of_flow, speed), ratio(of_forces, force), ratio(of_motion, speed)});
    const Grid<D>& grid = model.grid;
    const double length = grid.graded() ? grid.dx() * (grid.core_high() - grid.core_low()).maxCoeff() : grid.size().maxCoeff();
    const double viscosity = model.scene.viscosity / model.scene.density;
    const double crossing = speed > 0 ? length / speed : std::numeric_limits<double>::infinity();
    const double own_time = viscosity > 0 ? std::min(crossing, length * length / viscosity) : crossing;
    const double lasting = std::max(time_of_fading(watch, relative / state.dt, state.time, state.dt, own_time), state.dt);
    const bool rests = stays(model.scene, model.grid.dx(), state.time, fastest, std::max(of_flow, of_motion) / state.dt);
    const double r = relative == 0 || rests ? 0.0 : relative * (lasting / state.dt);
    watch.calm_steps = r < tolerance ? watch.calm_steps + 1 : 0;
    watch.calm_time = r < tolerance ? watch.calm_time + state.dt : 0.0;
    return r;
}

bool has_settled(const Scene& scene, const SteadyWatch& watch, double time)
{
    if (!scene.until_steady || watch.calm_steps < calm_steps_needed || watch.calm_time < 0.05 * time)
        return false;
    const auto goes_on = [&](const TimeTable& table) { return !table.time.empty() && table.time.back() > time; };
    return std::none_of(scene.sides.begin(), scene.sides.end(), [&](const SideScene& side) { return goes_on(side.table); }) &&
           std::none_of(scene.bodies.begin(), scene.bodies.end(),
                        [&](const BodyScene& body) { return goes_on(body.motion_table); });
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template double unsteadiness<D>(const Model<D>&, const Coupling<D>&, const EarlierFlow<D>&, State<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
