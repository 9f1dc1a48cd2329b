#include "gapflow/stepping/transport.hpp"

#include "gapflow/film/film_vorticity.hpp"
#include "gapflow/grid/cell_marks.hpp"
#include "gapflow/grid/interpolation.hpp"
#include "gapflow/stepping/advection.hpp"
#include "gapflow/stepping/extrapolation_share.hpp"
#include "gapflow/stepping/film_reversal.hpp"
#include "gapflow/stepping/flooding.hpp"
#include "gapflow/stepping/motion.hpp"
#include "gapflow/stepping/side_pressure.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace gapflow {

namespace {

// Extrapolated bulk velocity at points anywhere. Collective: every rank asks for the same points.
template <int D>
std::vector<Vec<D>> sample(const Grid<D>& grid, const FaceField<D>& velocity, const std::vector<Vec<D>>& points)
{
    std::vector<Vec<D>> u(points.size(), Vec<D>::Zero());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Index<D> c = grid.wrapped(grid.cell_of(points[i]));
        const Index<D> inside = c.cwiseMax(0).cwiseMin(grid.cells() - Index<D>::Ones());
        if (!grid.owns(inside))
            continue;
        const Vec<D> place = points[i] + grid.dx() * (inside - grid.cell_of(points[i])).template cast<double>();
        for (int axis = 0; axis < D; ++axis)
            u[i][axis] = interpolate_face(grid, velocity[axis], axis, place);
    }
    if (!u.empty())
        grid.comm().sum(std::span<double>(u.front().data(), D * u.size()));
    return u;
}

// Fluid entering voids: the inflow through the mouths, and the position of its front in this step.
template <int D>
void flood(const Model<D>& model, const State<D>& state, const FilmHistories<D>& histories, const Coupling<D>& there,
           const Step& step, FilmFlow<D>& flow)
{
    const Grid<D>& grid = model.grid;
    const VoidSet<D>& voids = state.voids;
    const std::vector<Twist<D>> V = model.twists(state.bodies);
    const std::vector<Mouth<D>>& mouths = there.network.rim.mouths;
    std::vector<double> pressure(mouths.size(), 0.0); // of the last step's bulk, where the mouths are now, or beyond the side
    for (std::size_t r = 0; r < mouths.size() && step.last_dt > 0; ++r)
        for (const auto& [key, weight] : mouths[r].cells)
            if (const Index<D> c = grid.cell_of_key(key); grid.owns(c))
                pressure[r] += weight * state.pressure.impulse.cells(c) / step.last_dt;
    grid.comm().sum(pressure);
    const std::vector<double> beyond = pressure_beyond_mouths(model, mouths, step.end());
    for (std::size_t r = 0; r < mouths.size(); ++r)
        pressure[r] += beyond[r];
    const std::vector<char> empty = voids.empty_elements(there.network);
    rest_in_voids<D>(there, empty, V, flow.velocity);
    limit_inflow<D>(there, voids, histories, model.mouths, pressure, step.dt, flow);
    pass_on<D>(there, voids, V, step.dt, flow);
    oppose_void_pressure<D>(there, voids, empty, step.dt, flow.velocity);
}

// Faces near the mouths of films with an outflow: the jets there are thinner than a cell, and MacCormack's correction, clamped
// or not, amplifies them until the flow through a valve's seat grows without bound. Where a film only has inflow, the
// correction is used.
// `flux`: out of each mouth, absolute.
template <int D>
std::optional<FaceField<D, std::int8_t>> faces_near_jets(const Coupling<D>& there, const std::vector<double>& flux,
                                                         const std::vector<Twist<D>>& V)
{
    constexpr int reach = 2; // cells
    const Grid<D>& grid = *there.grid;
    constexpr double least_weight = 1e-3; // round-off must not decide which faces are chosen
    const std::vector<Mouth<D>>& mouths = there.network.rim.mouths;
    std::vector<double> carried;
    double largest = 0;
    for (std::size_t r = 0; r < mouths.size(); ++r) {
        carried.push_back(carried_flux(there, mouths[r], V));
        largest = std::max(largest, std::abs(flux[r]) + std::abs(carried.back()));
    }
    std::vector<char> flows_out(there.network.films.size(), 0);
    for (std::size_t r = 0; r < mouths.size(); ++r)
        if (flux[r] - carried[r] > negligible_flux * largest)
            flows_out[mouths[r].film] = 1;
    if (std::none_of(flows_out.begin(), flows_out.end(), [](char out) { return out; }))
        return {};
    // Faces of the cells that mouths with an outflow lead to, and of those up to `reach` from one.
    std::vector<Index<D>> jets;
    Index<D> low = grid.high(), high = grid.low(); // of all near them
    for (const Mouth<D>& mouth : mouths)
        if (flows_out[mouth.film])
            for (const auto& [key, weight] : mouth.cells)
                if (std::abs(weight) >= least_weight) {
                    jets.push_back(grid.cell_of_key(key));
                    low = low.cwiseMin(jets.back() - Index<D>::Constant(reach));
                    high = high.cwiseMax(jets.back() + Index<D>::Constant(reach + 1));
                }
    for (int axis = 0; axis < D; ++axis)
        if (grid.periodic(axis) && (low[axis] < 0 || high[axis] >= grid.cells()[axis])) {
            low[axis] = grid.low()[axis];
            high[axis] = grid.high()[axis];
        }
    low = low.cwiseMax(grid.low());
    high = high.cwiseMin(grid.high());
    FaceField<D, std::int8_t> near(grid);
    if (!(low.array() < high.array()).all())
        return near;
    const Index<D> around = Index<D>::Constant(reach + 1);
    CellMarks<D> cells(low - around, high + around);
    for (const Index<D>& cell : jets)
        cells.set_images(grid, cell);
    for (int axis = 0; axis < D; ++axis)
        cells.spread(axis, reach);
    for (int axis = 0; axis < D; ++axis) {
        const Index<D> end = (high + gapflow::step<D>(axis)).cwiseMin(owned_faces_end(grid, axis));
        for_each_row_on_threads<D>(low, end, [&](const Index<D>& row) {
            std::int8_t* mark = &near(axis, row);
            const char *above = cells.row(row), *below = cells.row(row - gapflow::step<D>(axis));
            for (int i = 0; i < end[0] - low[0]; ++i)
                mark[i] = static_cast<std::int8_t>(above[i] | below[i]);
        });
    }
    return near;
}

} // namespace

template <int D>
Intermediate<D> transport(const Model<D>& model, State<D>& state, Reconstruction<D> beyond, PastPressure<D>& past,
                          const Coupling<D>& there, const FaceFractions<D>& old, const Step& step)
{
    const Grid<D>& grid = model.grid;
    FaceField<D>& u = state.velocity.grid;
    const std::vector<Twist<D>> V = model.twists(state.bodies), predicted = predicted_twists(model, state.bodies, step);
    Grid<D> before = grid; // where the velocities of the last step lie
    const Vec<D>& grid_velocity = model.grid_velocity;
    if (model.scene.follow)
        before.shift_to(state.grid_shift - step.dt * grid_velocity);
    Intermediate<D> result;
    FluidVelocity<D>& u_star = result.velocity;
    FilmFlow<D> flow = advect_films<D>(
        there.network, there.solids, beyond.histories,
        [&](const std::vector<Vec<D>>& points) { return sample(before, u, points); }, model.mouths, state.film_debts, step.dt,
        extrapolation_share(step.last_dt, step.dt));
    damp_vorticity(there.network, grid.dx(), flow.velocity);
    flow.account.transported = flow.velocity;
    reverse_films<D>(there.network, there.solids, state.turned, predicted, flow);
    if (state.voids.any())
        flood(model, state, beyond.histories, there, step, flow);
    const BoundaryVelocity<D> sides = model.sides(step.start);
    const std::optional<FaceField<D, std::int8_t>> near_jets = faces_near_jets(there, flow.mouth, V);
    const bool any_slivers = grid.comm().any(!beyond.slivers.empty());
    for (const Sliver<D>& face : beyond.slivers)
        u(face.axis, face.at) = face.extrapolated;
    if (any_slivers)
        fill_velocity_ghosts(grid, u, sides);
    std::vector<Twist<D>> motion = V;
    for (std::size_t s = 0; s < motion.size(); ++s)
        motion[s] = 0.5 * (V[s] + predicted[s]);
    u_star.grid =
        transport_bulk(model, u, past, there, old, near_jets ? &*near_jets : nullptr, motion, state.bodies.size(), step);
    for (const Sliver<D>& face : beyond.slivers) {
        u(face.axis, face.at) = face.own;
        const double open = std::max(there.open(face.axis, face.at), face.open);
        const double stays = std::max(0.0, 1 - step.dt * std::abs(face.own - grid_velocity[face.axis]) / grid.dx());
        u_star.grid(face.axis, face.at) += stays * face.open / open * (face.own - face.extrapolated);
    }
    if (any_slivers)
        fill_velocity_ghosts(grid, u, sides);
    if (beyond.any_film_faces) {
        const auto& cells = there.network.cells.cells;
        auto beside_film = [&](int axis, const Index<D>& f) {
            return cells.contains(grid.key(grid.wrapped(f))) ||
                   cells.contains(grid.key(grid.wrapped(Index<D>(f - gapflow::step<D>(axis)))));
        };
        for (int axis = 0; axis < D; ++axis)
            for_each_marked<D>(beyond.film_faces[axis], grid.low(), owned_faces_end(grid, axis), 1, [&](const Index<D>& f) {
                // Where a film still exists, its flow is the mouths' flux: the bulk's own velocity is used there.
                if (beside_film(axis, f))
                    beyond.film_faces(axis, f) = 0;
            });
        advect_marked_faces(grid, u_star.grid, beyond.painted, beyond.film_faces, step.dt, grid_velocity);
        share_uncovered_faces(there, old, beyond.film_faces, u, V, u_star.grid);
    }
    fill_velocity_ghosts(grid, u_star.grid, model.sides(step.end()));

    u_star.film = std::move(flow.velocity);
    u_star.film_normal = std::move(flow.normal);
    u_star.mouth = std::move(flow.mouth);
    result.mouth_factor = std::move(flow.mouth_scale);
    result.film_account = std::move(flow.account);
    return result;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template Intermediate<D> transport<D>(const Model<D>&, State<D>&, Reconstruction<D>, PastPressure<D>&, const Coupling<D>&, \
                                          const FaceFractions<D>&, const Step&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
