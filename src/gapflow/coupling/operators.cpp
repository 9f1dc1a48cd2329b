// The discrete operators of a projection: outflow D u + K V, gradient, impulses K^T p (method, "Rows of the film", "The coupled system").
#include "gapflow/core/threads.hpp"
#include "gapflow/coupling/coupling.hpp"
#include "gapflow/coupling/film_drag.hpp"
#include "gapflow/grid/far_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace gapflow {

namespace {

// A turning body of revolution has no flux. Fluxes that remain are round-off, measured against the flux of its speed through a face.
template <int D>
double squares_of_round_off(const Coupling<D>& coupling, const std::vector<Twist<D>>& twists)
{
    constexpr double share = 1e-6; // of that flux
    double fastest = 0;
    for (std::size_t s = 0; s < coupling.solids.size(); ++s) {
        const double radius = bounding_radius(world_bounds(coupling.solids[s].shape));
        fastest =
            std::max(fastest, twists[s].template head<D>().norm() +
                                  (std::isfinite(radius) ? radius * twists[s].template tail<spin_size<D>>().norm() : 0.0));
    }
    const double flux = share * coupling.grid->face_area() * fastest;
    return (coupling.system.nodes + 1) * flux * flux;
}

// Of every entry: its solid's flux.
template <int D, class Row>
std::vector<double> flux_of(const std::vector<BodyFlux<D, Row>>& entries, const std::vector<Twist<D>>& twists)
{
    std::vector<double> flux(entries.size());
    for_each_part(static_cast<long>(entries.size()), [&](long begin, long end) {
        for (long k = begin; k < end; ++k)
            flux[k] = entries[k].flux.dot(twists[entries[k].body]);
    });
    return flux;
}

} // namespace

template <int D>
void outflow(const Coupling<D>& coupling, const FluidVelocity<D>& u, const std::vector<Twist<D>>& twists, UnknownVector<D>& out,
             double* sum_of_squares)
{
    const Grid<D>& grid = *coupling.grid;
    if (out.cells.size() == 0)
        out.cells = CellField<D>(grid);
    out.nodes = Eigen::VectorXd::Zero(coupling.system.nodes);
    const double area = grid.face_area();
    double squares = sum_over_planes(grid.low()[D - 1], grid.high()[D - 1], [&](int plane) {
        double sum_of_plane = 0;
        for_each_row_of_plane<D>(grid.low(), grid.high(), plane, [&](const Index<D>& row) {
            std::array<const double*, D> a, v;
            std::array<long, D> next;
            for (int axis = 0; axis < D; ++axis) {
                a[axis] = &coupling.open(axis, row);
                v[axis] = &u.grid(axis, row);
                next[axis] = out.cells.block().stride[axis];
            }
            const int* component = &coupling.system.component(row);
            double* to = &out.cells(row);
            double row_sum = 0;
#pragma omp simd reduction(+ : row_sum)
            for (int i = 0; i < grid.high()[0] - grid.low()[0]; ++i) {
                double sum = 0, size = 0;
                for (int axis = 0; axis < D; ++axis) {
                    const double in = a[axis][i] * v[axis][i];
                    const double go = a[axis][i + next[axis]] * v[axis][i + next[axis]];
                    sum += go - in;
                    size += std::abs(go) + std::abs(in);
                }
                const bool unknown = component[i] >= 0;
                to[i] = unknown ? area * sum : 0.0;
                row_sum += unknown ? area * size * area * size : 0.0;
            }
            sum_of_plane += row_sum;
        });
        return sum_of_plane;
    });
    const auto add = [](double& to, double value, double& sum) {
        to += value;
        sum += value * value;
    };
    const std::vector<double> into_cells = flux_of(coupling.cell_flux, twists),
                              into_nodes = flux_of(coupling.node_flux, twists);
    for (std::size_t k = 0; k < into_cells.size(); ++k)
        add(out.cells(coupling.cell_flux[k].row), into_cells[k], squares);
    for (std::size_t k = 0; k < into_nodes.size(); ++k)
        add(out.nodes[coupling.node_flux[k].row], into_nodes[k], squares);
    const std::vector<Film<D>>& films = coupling.network.films;
    std::vector<double> squares_of(films.size(), 0.0);
    for_each_job(static_cast<int>(films.size()), [&](int k) {
        const Film<D>& film = films[k];
        for (std::size_t e = 0; film.here && e < film.mesh.elements.size(); ++e) {
            const FilmElement<D>& element = film.mesh.elements[e];
            for (int i = 0; i < D; ++i)
                add(out.nodes[film.first_node + element.nodes[i]],
                    -element.volume * element.gradient[i].dot(u.film[film.first_element + e]), squares_of[k]);
        }
    });
    squares = std::accumulate(squares_of.begin(), squares_of.end(), squares);
    const std::vector<Mouth<D>>& mouths = coupling.network.rim.mouths;
    for (std::size_t r = 0; r < mouths.size(); ++r) {
        for (int i = 0; i < D - 1 && films[mouths[r].film].here; ++i)
            add(out.nodes[mouths[r].nodes[i]], mouths[r].shape[i] * u.mouth[r], squares);
        for (const auto& [key, weight] : mouths[r].cells)
            if (const Index<D> c = grid.cell_of_key(key); grid.owns(c))
                out.cells(c) -= weight * u.mouth[r];
    }
    grid.comm().sum(std::span<double>(out.nodes.data(), out.nodes.size()));
    if (sum_of_squares)
        *sum_of_squares = grid.comm().sum(squares) + squares_of_round_off(coupling, twists);
}

template <int D>
void subtract_gradient(const Coupling<D>& coupling, UnknownVector<D>& p, FluidVelocity<D>& u)
{
    const Grid<D>& grid = *coupling.grid;
    const CoupledSystem<D>& system = coupling.system;
    exchange(grid, p.cells, 1);
    const double scale = 1 / (coupling.density * grid.dx());
    const FarField<D> far = far_field(grid);
    for (int axis = 0; axis < D; ++axis) {
        const long back = p.cells.block().stride[axis];
        // The pressure beyond an open side is 0, half a cell away: twice the drop.
        for_each_face_row<D>(grid, axis, grid.high() + step<D>(axis),
                             [&](const Index<D>& first, int n, double above, double below) {
                                 const double *a = &system.conductance(axis, first), *from = &p.cells(first);
                                 double* to = &u.grid(axis, first);
                                 const double up = above * (2 - below), down = below * (2 - above);
                                 if (grid.graded()) {
                                     const SpreadRow<D> spread(grid, axis, first);
                                     for (int i = 0; i < n; ++i)
                                         to[i] -= a[i] > 0 ? scale / spread[i] * (up * from[i] - down * from[i - back]) : 0.0;
                                     return;
                                 }
                                 for (int i = 0; i < n; ++i)
                                     to[i] -= a[i] > 0 ? scale * (up * from[i] - down * from[i - back]) : 0.0;
                             });
        for_each_far_face(grid, axis, [&](const Index<D>& f, int end) { // the pressure 0 is further away
            const double much = 2 * scale / grid.spread(axis, f[axis]) * (1 - 1 / far_distance(grid, far, axis, f));
            if (system.conductance(axis, f) > 0)
                u.grid(axis, f) += end ? -much * p.cells(f - step<D>(axis)) : much * p.cells(f);
        });
    }
    subtract_film_gradient(coupling, p, u.film, u.mouth);
}

template <int D>
void subtract_film_gradient(const Coupling<D>& coupling, const UnknownVector<D>& p, std::vector<Vec<D>>& film_velocity,
                            std::vector<double>& mouth_flux)
{
    const Grid<D>& grid = *coupling.grid;
    const CoupledSystem<D>& system = coupling.system;
    for (const Film<D>& film : coupling.network.films)
        for (std::size_t e = 0; e < film.mesh.elements.size(); ++e) {
            const FilmElement<D>& element = film.mesh.elements[e];
            Vec<D> gradient = Vec<D>::Zero();
            for (int i = 0; i < D; ++i)
                gradient += p.nodes[film.first_node + element.nodes[i]] * element.gradient[i];
            film_velocity[film.first_element + e] -=
                film_conductance(coupling, film, e) / element.volume * gradient / coupling.density;
        }
    const std::vector<Mouth<D>>& mouths = coupling.network.rim.mouths;
    std::vector<double> drop(mouths.size(), 0.0);
    for (std::size_t r = 0; r < mouths.size(); ++r)
        for (const auto& [key, weight] : mouths[r].cells)
            if (const Index<D> c = grid.cell_of_key(key); grid.owns(c))
                drop[r] -= weight * p.cells(c);
    grid.comm().sum(drop);
    for (std::size_t r = 0; r < mouths.size(); ++r) {
        for (int i = 0; i < D - 1; ++i)
            drop[r] += mouths[r].shape[i] * p.nodes[mouths[r].nodes[i]];
        mouth_flux[r] += system.links[r].conductance * drop[r];
    }
}

template <int D>
std::vector<Twist<D>> impulses(const Coupling<D>& coupling, const UnknownVector<D>& p)
{
    constexpr int n = twist_size<D>;
    std::vector<double> sums(n * coupling.solids.size(), 0.0);
    auto add = [&](int solid, const Twist<D>& value) {
        for (int i = 0; i < n; ++i)
            sums[n * solid + i] += value[i];
    };
    for (const auto& entry : coupling.cell_flux)
        add(entry.body, p.cells(entry.row) * entry.flux);
    for (const auto& entry : coupling.node_flux)
        add(entry.body, p.nodes[entry.row] * entry.flux);
    coupling.grid->comm().sum(sums);
    std::vector<Twist<D>> result(coupling.solids.size());
    for (std::size_t s = 0; s < result.size(); ++s)
        result[s] = Eigen::Map<const Twist<D>>(&sums[n * s]);
    return result;
}

template <int D>
std::vector<Twist<D>> closure(const Coupling<D>& coupling)
{
    UnknownVector<D> ones{CellField<D>(*coupling.grid, 1.0), Eigen::VectorXd::Ones(coupling.system.nodes)};
    return impulses(coupling, ones);
}

template <int D>
double closure_defect(const Coupling<D>& coupling)
{
    const Grid<D>& grid = *coupling.grid;
    const std::vector<Twist<D>> sums = closure(coupling);
    double worst = 0;
    for (std::size_t s = 0; s < sums.size(); ++s) {
        const Bounds<D> bounds = world_bounds(coupling.solids[s].shape);
        bool inside = !coupling.solids[s].wall && bounds.low.allFinite();
        for (int axis = 0; axis < D && inside; ++axis)
            inside = grid.periodic(axis) ||
                     (bounds.low[axis] >= grid.origin()[axis] && bounds.high[axis] <= grid.origin()[axis] + grid.size()[axis]);
        if (inside)
            worst = std::max(worst, sums[s].template head<D>().cwiseAbs().maxCoeff() / grid.face_area());
    }
    return worst;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template void outflow<D>(const Coupling<D>&, const FluidVelocity<D>&, const std::vector<Twist<D>>&, UnknownVector<D>&,     \
                             double*);                                                                                         \
    template void subtract_gradient<D>(const Coupling<D>&, UnknownVector<D>&, FluidVelocity<D>&);                              \
    template void subtract_film_gradient<D>(const Coupling<D>&, const UnknownVector<D>&, std::vector<Vec<D>>&,                 \
                                            std::vector<double>&);                                                             \
    template std::vector<Twist<D>> impulses<D>(const Coupling<D>&, const UnknownVector<D>&);                                   \
    template double closure_defect<D>(const Coupling<D>&);                                                                     \
    template std::vector<Twist<D>> closure<D>(const Coupling<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
