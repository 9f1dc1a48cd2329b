#include "gapflow/stepping/step_size.hpp"

#include "gapflow/body/forces.hpp"
#include "gapflow/core/error.hpp"
#include "gapflow/core/threads.hpp"
#include "gapflow/stepping/closing_limit.hpp"
#include "gapflow/stepping/film_reversal.hpp"
#include "gapflow/stepping/following.hpp"
#include "gapflow/stepping/gap_limit.hpp"
#include "gapflow/stepping/reconstruction.hpp"
#include "gapflow/stepping/short_text.hpp"
#include "gapflow/stepping/touch_limit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

namespace gapflow {

namespace {

// Films between curved surfaces: dt <= this * sqrt(2 R h) / |u - P U_m|, the length at least so many dx: in the throat of a
// contact the flux is negligible and its speed unbounded (in 3D it is singular), and the films' transport is stable without
// resolving it. Bodies that rebound keep what speed the film leaves them: there more of it is resolved (steel spheres at St 152 rebound with 0.845
// instead of 0.834 of their speed otherwise).
constexpr double curved_film_cfl = 0.1;
template <int D>
constexpr double least_film_length = D == 2 ? 1.0 : 10.0;
template <int D>
constexpr double least_film_length_of_rebound = D == 2 ? 1.0 : 5.0;
// A swing or an oscillation on a spring gets this many steps a period.
constexpr double steps_a_period = 20;
// An oscillation on a spring or in a water level of a smaller amplitude, in dx, does not limit the step, which is implicit.
constexpr double invisible_amplitude = 1e-3;
// Steps below this times time.max_step indicate unbounded growth.
constexpr double smallest_step = 1e-9;

constexpr double tiny = std::numeric_limits<double>::min();

// Largest speed on this rank's faces that are open by more than a share; where cells are wider than dx, so much smaller.
template <int D>
double largest_speed(const Grid<D>& grid, const FaceField<D>& open_share, const FaceField<D>& velocity, double share,
                     const Vec<D>& grid_velocity)
{
    double speed = 0;
    for (int axis = 0; axis < D; ++axis) {
        const Index<D> low = grid.low(), end = owned_faces_end(grid, axis);
        const double frame = grid_velocity[axis];
        speed = std::max(speed, max_over_planes(low[D - 1], end[D - 1], [&](int plane) {
                             double largest = 0;
                             for_each_row_of_plane<D>(low, end, plane, [&](const Index<D>& row) {
                                 const double *open = &open_share(axis, row), *u = &velocity(axis, row);
                                 for (int i = 0; i < end[0] - low[0] && grid.graded(); ++i) {
                                     const int place = row[axis] + (axis == 0 ? i : 0);
                                     const double width = std::min(grid.width(axis, place - 1), grid.width(axis, place));
                                     largest = std::max(largest,
                                                        open[i] > share ? std::abs(u[i] - grid_velocity[axis]) / width : 0.0);
                                 }
                                 if (grid.graded())
                                     return;
#pragma omp simd reduction(max : largest)
                                 for (int i = 0; i < end[0] - low[0]; ++i)
                                     largest = std::max(largest, open[i] > share ? std::abs(u[i] - frame) : 0.0);
                             });
                             return largest;
                         }));
    }
    return speed;
}

// Bound of the angular frequency at which a float's section with the water's level holds it, without added mass: now, or where it is expected in dt.
template <int D>
double floating_frequency(const RigidBody<D>& body, const Twist<D>& V, const Twist<D>& A, double dt)
{
    if (!body.water)
        return 0;
    const auto square = [](const RigidBody<D>& there) {
        const TwistMatrix<D> section = displacement(there).stiffness;
        double sum = 0;
        for (int k = 0; k < twist_size<D> && !section.isZero(0); ++k)
            sum += impulse_response<D>(there, section.col(k), 0)[k];
        return sum;
    };
    RigidBody<D> ahead = body;
    const Twist<D> way = dt * V + 0.5 * dt * dt * A;
    displace<D>(ahead, way.template head<D>(), way.template tail<spin_size<D>>());
    return std::sqrt(std::max(square(body), square(ahead)));
}

// Mass of the other free bodies, with the fluid that they displace, that contacts hold to a body: what oscillates with it.
template <int D>
double held_mass(const State<D>& state, std::size_t body, double fluid_density)
{
    const auto is_free = [&](int s) {
        return s < static_cast<int>(state.bodies.size()) && state.bodies[s].motion == Motion::free;
    };
    std::set<int> reached{static_cast<int>(body)};
    for (std::size_t before = 0; before < reached.size();) {
        before = reached.size();
        for (const Contact<D>& c : state.contacts.contacts())
            for (const auto& [from, to] : {std::pair(c.point.a, c.point.b), std::pair(c.point.b, c.point.a)})
                if (c.closed && reached.contains(from) && is_free(to))
                    reached.insert(to);
    }
    double mass = 0;
    for (const int b : reached)
        if (b != static_cast<int>(body))
            mass += state.bodies[b].mass + fluid_density * std::abs(state.bodies[b].volume);
    return mass;
}

// A free body's swing about its hinge or its centre of volume, and its oscillation on a spring or in a water level unless that is invisible. `held`: mass
// that contacts hold to it, with which the same velocity leads further. `dt`: by other limits.
template <int D>
double limit_of_oscillation(const RigidBody<D>& body, const Twist<D>& V, const Twist<D>& A, double held, const Scene& scene,
                            double dx, double dt)
{
    double frequency = swing_frequency<D>(body, to_vec<D>(scene.gravity), scene.density);
    if (const double spring = spring_frequency(body); spring > 0) {
        const Vec<D> arm = body.pose.position - body.centre();
        const double slowest = spring / std::sqrt(1 + held * spring * spring / body.spring->stiffness);
        const double amplitude =
            std::hypot(velocity_at<D>(V, arm).norm() / slowest, velocity_at<D>(A, arm).norm() / (slowest * slowest));
        if (amplitude > invisible_amplitude * dx)
            frequency = std::hypot(frequency, spring);
    }
    if (const double floating = floating_frequency(body, V, A, dt); floating > 0) {
        const double amplitude =
            std::hypot(V.template head<D>().norm() / floating, A.template head<D>().norm() / (floating * floating));
        if (amplitude > invisible_amplitude * dx)
            frequency = std::hypot(frequency, floating);
    }
    return 2 * std::numbers::pi / (steps_a_period * std::max(frequency, tiny));
}

// How far the flow of a curved film may go in a step. `least_length`: that of the film counts as no less. `first`: of its elements in its pair's memory.
template <int D>
double limit_of_film_flow(const FilmMesh<D>& mesh, const Solid<D>& master, const FilmHistory<D>& memory, int first, double dx,
                          double least_length)
{
    const double curvature = std::abs(master.shape.shape().curvature(0));
    double dt = std::numeric_limits<double>::infinity();
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        const FilmElement<D>& element = mesh.elements[e];
        const double h = element.volume / element.measure;
        if (element.coarse || !(curvature > 0 && h > smallest_limiting_gap * dx)) // thinner, its fluid is negligible
            continue;
        const double relative = memory.speed_about(first + static_cast<int>(e));
        dt = std::min(dt, curved_film_cfl * std::max(std::sqrt(2 * h / curvature), least_length) / std::max(relative, tiny));
    }
    return dt;
}

} // namespace

template <int D>
Step choose_step(const Model<D>& model, const State<D>& state, const Coupling<D>& here, const FilmHistories<D>& histories,
                 double next_output, GapWays<D>& ways, std::span<const GapArm<D>> arms, double in_gaps)
{
    const Scene& scene = model.scene;
    const Grid<D>& grid = model.grid;
    const std::vector<RigidBody<D>>& bodies = state.bodies;
    const double dx = grid.dx();
    const double speed = grid.comm().max(largest_speed(grid, here.open, state.velocity.grid, widest_sliver(model, state.dt),
                                                       expected_grid_velocity(model, state.bodies)));
    double dt = std::min(scene.max_step, scene.cfl * dx / std::max({speed, in_gaps, tiny}));

    // The first step has no pressure of a step before: nu dt is at most dx^2 in it, and twice as much in each following step.
    if (scene.viscosity > 0)
        dt = std::min(dt, std::ldexp(dx * dx * scene.density / scene.viscosity, static_cast<int>(std::min(state.steps, 60L))));

    if (state.viscous_step > 0)
        dt = std::min(dt, state.viscous_step);

    const std::vector<Twist<D>> V = model.twists(bodies);
    std::vector<Twist<D>> A = state.acceleration;
    if (state.steps ==
        0) // before the first solve: the accelerations by the explicit forces alone (added mass only reduces them)
        for (std::size_t b = 0; b < bodies.size(); ++b)
            if (bodies[b].motion == Motion::free)
                A[b] = twist_after<D>(bodies[b], explicit_wrench<D>(bodies[b], model.gravity(), scene.density) +
                                                     spring_wrench(bodies[b])) -
                       bodies[b].twist;
    for (std::size_t b = 0; b < bodies.size(); ++b)
        if (bodies[b].motion == Motion::free)
            dt = std::min(dt, limit_of_oscillation(bodies[b], V[b], A[b],
                                                   scene.parts && bodies[b].spring ? held_mass(state, b, scene.density) : 0.0,
                                                   scene, dx, dt));
    const std::vector<Solid<D>>& solids = here.solids;
    std::map<FilmPair<D>, int> counted; // elements of each pair's films so far, as its memory has them
    std::optional<GapLimit<D>> gaps;    // of films
    if (!scene.parts)
        gaps.emplace(model, state, here, V, A, speed);
    for (const Film<D>& film : here.network.films) {
        const FilmMesh<D>& mesh = film.mesh;
        const int first = counted[film.pair];
        counted[film.pair] += static_cast<int>(mesh.elements.size());
        if (mesh.flat)
            continue;
        const Solid<D>&master = solids[mesh.master], &other = solids[mesh.other];
        const bool elastic = scene.contact_of(master.name, other.name).restitution > 0;
        dt = std::min(dt, limit_of_film_flow(mesh, master, *histories.at(film.pair), first, dx,
                                             (elastic ? least_film_length_of_rebound<D> : least_film_length<D>)*dx));
    }
    dt = gaps ? gaps->limited(dt) : limit_of_closing(model, state, solids, V, A, arms, dt);
    const double left = next_output - state.time, furthest = std::min(dt, left);
    if (const double touch = until_touch(model, state, solids, furthest); touch < furthest)
        dt = touch;
    if (!(dt > smallest_step * scene.max_step))
        throw ComputationError(
            "the time step fell to " + short_text(dt) + " at time " + short_text(state.time) +
            ": the flow does not stay bounded, or something is driven into what cannot give way; use a finer "
            "grid, a smaller time.max_step or time.cfl, or look at the last output");
    // Steps end at output times, without a very short step before them.
    if (left <= dt * (1 + 1e-9))
        dt = left;
    else if (left < 2 * dt)
        dt = 0.5 * left;
    ways = gaps ? gaps->ways(dt) : GapWays<D>();
    const double end = state.time + dt;
    return {state.steps + 1, state.time, dt, state.dt, next_output - end < 1e-12 * next_output ? next_output : end};
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template Step choose_step<D>(const Model<D>&, const State<D>&, const Coupling<D>&, const FilmHistories<D>&, double,        \
                                 GapWays<D>&, std::span<const GapArm<D>>, double);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
