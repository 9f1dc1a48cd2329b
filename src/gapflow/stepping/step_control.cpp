// How long a step may be (method, "The time step", stage 1).
#include "gapflow/stepping/simulation.hpp"

#include "gapflow/body/forces.hpp"
#include "gapflow/core/error.hpp"
#include "gapflow/core/threads.hpp"
#include "gapflow/stepping/film_turn.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

namespace gapflow {

namespace {

// Films between curved surfaces: dt <= this * sqrt(2 R h) / |u - P U_m|, the length not less than so many dx: next to nothing flows in the
// throat of a contact, at a speed without bound (in 3D it is singular there), and films' transport is stable without following it.
constexpr double curved_film_cfl = 0.1;
template <int D>
constexpr double least_film_length = D == 2 ? 1.0 : 5.0;
// A swing or an oscillation on a spring gets this many steps a period.
constexpr double steps_a_period = 20;
// A spring's oscillation of a smaller amplitude, in dx, is left to the implicit step.
constexpr double invisible_amplitude = 1e-3;
// Steps below this times time.max_step mean that something grows without bound.
constexpr double smallest_step = 1e-9;
// Bodies that cannot give way and have met: steps below this times time.max_step would crawl on for ever.
constexpr double driven_step = 1e-3;

std::string short_text(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

} // namespace

// Stage 1.
template <int D>
double Simulation<D>::choose_step(double next_output) const
{
    const double dx = grid_.dx(), tiny = std::numeric_limits<double>::min();
    double dt = scene_.max_step;
    double speed = 0;
    const double narrow = sliver();
    for (int axis = 0; axis < D; ++axis) {
        const Index<D> low = grid_.low(), end = owned_faces_end(grid_, axis);
        speed = std::max(speed, max_over_planes(low[D - 1], end[D - 1], [&](int plane) {
            double largest = 0;
            for_each_row_of_plane<D>(low, end, plane, [&](const Index<D>& row) {
                const double *open = &coupling_->open(axis, row), *u = &velocity_.grid(axis, row);
#pragma omp simd reduction(max : largest)
                for (int i = 0; i < end[0] - low[0]; ++i)
                    largest = std::max(largest, open[i] > narrow ? std::abs(u[i]) : 0.0);
            });
            return largest;
        }));
    }
    dt = std::min(dt, scene_.cfl * dx / std::max(grid_.comm().max(speed), tiny));

    // The first step knows no pressure: viscosity crosses a cell in it, and twice as much in each one after it.
    if (scene_.viscosity > 0)
        dt = std::min(dt, std::ldexp(dx * dx * scene_.density / scene_.viscosity, static_cast<int>(std::min(steps_, 60L))));

    const std::vector<Twist<D>> V = twists();
    std::vector<Twist<D>> A = acceleration_;
    if (steps_ == 0) // before the first solve: what the explicit forces alone would do (added mass only slows it)
        for (std::size_t b = 0; b < bodies_.size(); ++b)
            if (bodies_[b].motion == Motion::free)
                A[b] = twist_after<D>(bodies_[b], explicit_wrench<D>(bodies_[b], to_vec<D>(scene_.gravity), scene_.density) +
                                                      spring_wrench(bodies_[b])) -
                       bodies_[b].twist;
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const RigidBody<D>& body = bodies_[b];
        if (body.motion != Motion::free)
            continue;
        double frequency = swing_frequency<D>(body, to_vec<D>(scene_.gravity), scene_.density);
        if (const double spring = spring_frequency(body); spring > 0) {
            const Vec<D> arm = body.pose.position - body.centre();
            const double amplitude = std::hypot(velocity_at<D>(V[b], arm).norm() / spring,
                                                velocity_at<D>(A[b], arm).norm() / (spring * spring));
            if (amplitude > invisible_amplitude * dx)
                frequency = std::hypot(frequency, spring);
        }
        dt = std::min(dt, 2 * std::numbers::pi / (steps_a_period * std::max(frequency, tiny)));
    }
    const std::vector<Solid<D>>& solids = coupling_->solids;
    std::map<FilmPair<D>, int> counted; // elements of each pair's films so far, as its memory has them
    for (const Film<D>& film : coupling_->network.films) {
        const FilmMesh<D>& mesh = film.mesh;
        const int first = counted[film.pair];
        counted[film.pair] += static_cast<int>(mesh.elements.size());
        const double thickness = scene_.contact_of(solids[mesh.master].name, solids[mesh.other].name).thickness;
        const double least = std::max({thickness, gaps_(mesh.master, mesh.other).floor, smallest_limiting_gap * dx});
        // Neither can give way: they have met where the film is still rough.
        const double met = std::max(scene_.least_distance(solids[mesh.master].name, solids[mesh.other].name), smallest_limiting_gap * dx);
        const auto moves_freely = [&](int solid) { return solids[solid].motion == Motion::free; };
        const bool unstoppable = !moves_freely(mesh.master) && !moves_freely(mesh.other);
        for (const FilmPoint<D>& q : mesh.points) {
            const Vec<D> arm_a = q.x - solids[mesh.master].centre, arm_b = q.y - solids[mesh.other].centre - mesh.shift;
            auto opening = [&](const std::vector<Twist<D>>& twist) {
                return q.other_normal.dot(velocity_at<D>(twist[mesh.master], arm_a) - velocity_at<D>(twist[mesh.other], arm_b));
            };
            auto rate = [&](const std::vector<Twist<D>>& twist) { return std::abs(opening(twist)); };
            const double distance = q.h + mesh.skin, h = std::max(distance, least);
            if (unstoppable && q.other_normal.dot(q.x - q.y) < met && scene_.gap_cfl * met < driven_step * scene_.max_step * -opening(V))
                throw ComputationError("prescribed motion drives '" + solids[mesh.master].name + "' and '" +
                                       solids[mesh.other].name + "' into each other at time " + short_text(time_) +
                                       "; let it stop before they touch, or let one of them be free");
            // What is left to the contact thickness limits the step too.
            const double left = thickness > 0 ? std::max(distance - thickness, smallest_limiting_gap * dx) : h;
            dt = std::min(dt, scene_.gap_cfl * std::min(h, left) / std::max(rate(V), tiny));
            dt = std::min(dt, std::sqrt(2 * scene_.gap_cfl * h / std::max(rate(A), tiny)));
        }
        if (mesh.flat)
            continue;
        const double curvature = std::abs(solids[mesh.master].shape.shape().curvature(0));
        const FilmMemory<D>& memory = *memories_.at(film.pair);
        for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
            const FilmElement<D>& element = mesh.elements[e];
            if (element.coarse)
                continue;
            const double h = element.volume / element.measure;
            const double relative = memory.speed_about(first + static_cast<int>(e));
            if (curvature > 0 && h > smallest_limiting_gap * dx) // thinner, it holds next to nothing
                dt = std::min(dt, curved_film_cfl * std::max(std::sqrt(2 * h / curvature), least_film_length<D> * dx) /
                                      std::max(relative, tiny));
        }
    }
    if (!(dt > smallest_step * scene_.max_step))
        throw ComputationError("the time step fell to " + short_text(dt) + " at time " + short_text(time_) +
                               ": the flow does not stay bounded, or something is driven into what cannot give way; use a finer "
                               "grid, a smaller time.max_step or time.cfl, or look at the last output");
    // Land on output times without a sliver of a step before them.
    const double left = next_output - time_;
    if (left <= dt * (1 + 1e-9))
        return left;
    return left < 2 * dt ? 0.5 * left : dt;
}

#define GAPFLOW_INSTANTIATE(D) \
    template double Simulation<D>::choose_step(double) const;
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
