#include "gapflow/step/vorticity.hpp"

#include "gapflow/step/exits.hpp"
#include "gapflow/step/inner_faces.hpp"
#include "gapflow/step/own_edges.hpp"
#include "gapflow/step/remainder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace gapflow {
namespace {

/// Edges of the grid (2D: vertices) in a row along the first axis, normal to the axes a < b, at the low corners of cells. Four faces meet at each inside the domain.
template <int D>
struct EdgeRow {
    int a, b;
    Index<D> first;
    int n;

    /// f(i) for those that do not lie in sides of the domain.
    template <class F>
    void for_each_inner(const Grid<D>& grid, const F& f) const
    {
        for (const int axis : {a, b})
            if (axis > 0 && !grid.periodic(axis) && !(first[axis] > 0 && first[axis] < grid.cells()[axis]))
                return;
        const bool ends = a == 0 && !grid.periodic(0);
        const int begin = ends ? std::max(0, 1 - first[0]) : 0, end = ends ? std::min(n, grid.cells()[0] - first[0]) : n;
#pragma omp simd
        for (int i = begin; i < end; ++i)
            f(i);
    }
    /// Over that in the core; 1 in 2D.
    double length(const Grid<D>& grid, int i) const
    {
        double length = 1;
        for (int axis = 0; axis < D && grid.graded(); ++axis)
            length *= axis == a || axis == b ? 1.0 : grid.width(axis, first[axis] + (axis == 0 ? i : 0));
        return length;
    }
    /// A component's values at the two faces that meet at each edge: those below it along the other axis, and those beside it.
    std::array<const double*, 2> values(const FaceField<D>& field, int component) const
    {
        const double* at = &field(component, first);
        return {at - field[component].block().stride[component == a ? b : a], at};
    }
};

/// A factor of each edge in a plane of the last index; 0 in sides of the domain.
template <int D>
class EdgePlane {
public:
    EdgePlane(const Grid<D>& grid, int a, int b) : grid_(&grid), a_(a), b_(b)
    {
        for (int axis = 0, stride = 1; axis < D - 1; stride *= grid.high()[axis] - grid.low()[axis] + 1, ++axis)
            stride_[axis] = stride;
        values_.resize((grid.high() - grid.low() + Index<D>::Ones()).template head<D - 1>().prod());
    }
    bool is_within() const { return b_ < D - 1; } ///< whether planes of faces have all their edges in one
    /// omega(row) is a function of the number of an edge in the row.
    template <class F>
    void find(int plane, const F& omega)
    {
        std::fill(values_.begin(), values_.end(), 0.0);
        const Index<D> end = grid_->high() + step<D>(a_) + step<D>(b_);
        for_each_row_of_plane<D>(grid_->low(), end, plane, [&](const Index<D>& first) {
            const EdgeRow<D> row{a_, b_, first, end[0] - first[0]};
            double* values = values_.data() + offset(first);
            const auto at = omega(row);
            if (grid_->graded())
                row.for_each_inner(*grid_, [&](int i) { values[i] = 0.25 * at(i) / row.length(*grid_, i); });
            else
                row.for_each_inner(*grid_, [&](int i) { values[i] = 0.25 * at(i); });
        });
    }
    const double* row(const Index<D>& first) const { return values_.data() + offset(first); }

private:
    long offset(const Index<D>& first) const { return (first - grid_->low()).template head<D - 1>().dot(stride_); }

    const Grid<D>* grid_;
    int a_, b_;
    Eigen::Matrix<int, D - 1, 1> stride_;
    LargeVector<double> values_;
};

/// v x omega on a row of faces normal to `axis`, of the edges at their low and high sides along another axis. Half of each face's flux passes an edge, to either side of it.
template <int D>
void add_turned(const Grid<D>& grid, const Index<D>& first, int axis, int along, const double* low, const double* high,
                const FaceField<D>& flux, FaceField<D>& result)
{
    const int n = grid.high()[0] - first[0];
    const double sign = axis < along ? 1 : -1;
    const Index<D>& stride = flux[along].block().stride;
    const double *near = &flux(along, first), *below = near - stride[axis], *far = near + stride[along],
                 *far_below = far - stride[axis];
    double* to = &result(axis, first);
    const auto add = [&](const auto& spread) {
#pragma omp simd
        for (int i = 0; i < n; ++i) {
            const double l = sign * low[i] / spread(i), h = sign * high[i] / spread(i);
            double sum = to[i];
            sum += l * below[i];
            sum += l * near[i];
            sum += h * far_below[i];
            sum += h * far[i];
            to[i] = sum;
        }
    };
    if (!grid.graded())
        return add([](int) { return 1.0; });
    const SpreadRow<D> spread(grid, axis, first);
    add([&](int i) { return spread[i]; });
}

/// v x omega of omega(row)(i) at each edge.
template <int D, class F>
FaceField<D> turned(const Grid<D>& grid, const FaceField<D>& flux, const F& omega)
{
    constexpr int last = D - 1;
    FaceField<D> result(grid);
    std::vector<EdgePlane<D>> here, next; // of each pair of axes
    for (int a = 0; a < D; ++a)
        for (int b = a + 1; b < D; ++b) {
            here.emplace_back(grid, a, b);
            next.emplace_back(grid, a, b);
        }
    const int begin = grid.low()[last], end = grid.high()[last];
    for (EdgePlane<D>& plane : here)
        plane.find(begin, omega);
    for (int plane = begin; plane < end; ++plane) {
        for (EdgePlane<D>& edges : next)
            if (plane + 1 < end || !edges.is_within())
                edges.find(plane + 1, omega);
        for_each_row_of_plane<D>(grid.low(), grid.high(), plane, [&](const Index<D>& first) {
            for (int axis = 0; axis < D; ++axis)
                for (int along = 0; along < D; ++along) {
                    if (along == axis)
                        continue;
                    const int pair = D == 2 ? 0 : axis + along - 1;
                    const double* high = along == 0      ? here[pair].row(first) + 1
                                         : along == last ? next[pair].row(first)
                                                         : here[pair].row(first + step<D>(along));
                    add_turned(grid, first, axis, along, here[pair].row(first), high, flux, result);
                }
        });
        std::swap(here, next);
    }
    return result;
}

template <int D>
FaceField<D> flux_of_velocity(const Grid<D>& grid, const Vec<D>& velocity)
{
    FaceField<D> flux(grid);
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(grid.low(), owned_faces_end(grid, axis),
                          [&](const Index<D>& f) { flux(axis, f) = velocity[axis] * grid.relative_area(axis, f); });
    exchange(grid, flux);
    return flux;
}

template <int D>
FaceField<D> velocity_of_flux(const Grid<D>& grid, FaceField<D> flux)
{
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(grid.low(), owned_faces_end(grid, axis),
                          [&](const Index<D>& f) { flux(axis, f) /= grid.relative_area(axis, f); });
    exchange(grid, flux);
    return flux;
}

} // namespace

// e x omega of the remainder is what it changes by where the grid goes along -e, but for a gradient; Q has no divergence. The derivative of the Routhian by w is -Q. Around a
// fluid without bodies the force of all is that on the sides, and omega is the curl of Q: so with this curl the sum is what sides bear, wherever the fluid's is the same.
template <int D>
ForceOfGrid<D> force_of_grid(const Coupling<D>& coupling, const FaceField<D>& flux, const FaceField<D>& remainder, int axis)
{
    const Grid<D>& grid = *coupling.grid;
    const FaceField<D> along = flux_of_velocity<D>(grid, unit<D>(axis));
    return {work_of_fluxes(coupling, flux, vortex_impulse(grid, along, remainder, 1.0)),
            -work_of_fluxes(coupling, flux, vortex_impulse(grid, along, velocity_of_flux(grid, flux), 1.0))};
}

template <int D>
FaceField<D> vortex_impulse(const Grid<D>& grid, const FaceField<D>& flux, const FaceField<D>& remainder, double dt)
{
    return turned(grid, flux, [&](const EdgeRow<D>& row) {
        const std::array<const double*, 2> u = row.values(remainder, row.a), v = row.values(remainder, row.b);
        const SpreadRow<D> across_a(grid, row.a, row.first), across_b(grid, row.b, row.first);
        return [=, dx = grid.dx()](int i) {
            return dt * ((u[0][i] - u[1][i]) / (dx * across_b[i]) + (v[1][i] - v[0][i]) / (dx * across_a[i]));
        };
    });
}

template <int D>
TurnedRemainder<D>::TurnedRemainder(const Instant<D>& old, const Placed<D>& there, const SolverOptions& options,
                                    const Vec<D>& beyond, const Vec<D>& grid_velocity, double dt)
    : old_(old), there_(there), options_(options), beyond_(beyond - grid_velocity), grid_velocity_(grid_velocity), dt_(dt)
{
    if (grid_moves())
        grid_flux_ = flux_of_velocity<D>(grid(), grid_velocity_);
}

template <int D>
Remainder<D> TurnedRemainder<D>::find(const Instant<D>* end)
{
    if (old_.flow.remainder.empty())
        return {};
    find_heads(end);
    int steps = static_cast<int>(std::ceil(courant(flux_at(end, 0.5))));
    if (steps <= 1) {
        curve_ = {};
        FaceField<D> w = sub_steps(end, 1).second;
        if (end)
            take_work(*end, w);
        return at_end(std::move(w));
    }
    steps += steps % 2;
    find_curve(sub_steps(end, steps));
    FaceField<D> w = sub_steps(end, steps).second;
    if (end)
        take_work(*end, w);
    return at_end(std::move(w));
}

template <int D>
Remainder<D> TurnedRemainder<D>::at_end(FaceField<D> w) const
{
    if (heads_[0].size() > 0)
        add(w, 1, heads_);
    Remainder<D> remainder = remainder_of(there_, std::move(w));
    if (there_.viscous)
        add_own(remainder.edges, carried_along_edges(*old_.placed, own_along_edges(*old_.placed, old_.flow.remainder), there_));
    return remainder;
}

template <int D>
FaceField<D> TurnedRemainder<D>::turning(const FaceField<D>& flux, const FaceField<D>& remainder, double dt) const
{
    FaceField<D> impulse = vortex_impulse(grid(), flux, remainder, dt);
    if (has_exits())
        turn_in_exits(grid(), flux, grid_velocity_, dt, impulse);
    return impulse;
}

/// Over the step, by Simpson's rule. They do work, by the flux alone.
template <int D>
void TurnedRemainder<D>::find_heads(const Instant<D>* end)
{
    bool open = false;
    for (int side = 0; side < 2 * D; ++side)
        open = open || is_open(grid().side(side / 2, side % 2));
    if (!has_exits() || !open)
        return;
    heads_ = FaceField<D>(grid());
    for (const auto& [share, weight] : {std::pair(0.0, 1.0 / 6), std::pair(0.5, 2.0 / 3), std::pair(1.0, 1.0 / 6)})
        add_heads(grid(), flux_at(end, share), beyond_, grid_velocity_, weight * dt_, heads_);
}

/// Classical Runge-Kutta. Half-way, and at the end.
template <int D>
std::pair<FaceField<D>, FaceField<D>> TurnedRemainder<D>::sub_steps(const Instant<D>* end, int steps)
{
    FaceField<D> w = old_.flow.remainder.faces, half;
    const double dt = dt_ / steps;
    if (grid_moves())
        exits_ = FaceField<D>(grid());
    double share = 0;
    FaceField<D> flux = flux_at(end, share), at, rate;
    for (int k = 0; k < steps; ++k) {
        if (2 * k == steps)
            half = w;
        const FaceField<D> start = w;
        for (const auto& [way, weight] :
             {std::pair(0.0, 1.0 / 6), std::pair(0.5, 1.0 / 3), std::pair(0.5, 1.0 / 3), std::pair(1.0, 1.0 / 6)}) {
            at = start;
            if (way > 0)
                add(at, way, rate);
            if (const double now = (k + way) / steps; now != share && (end || curve_[0].size() > 0))
                flux = flux_at(end, share = now);
            rate = turning(flux, at, dt);
            add(w, weight, rate);
            if (grid_moves())
                turn_in_exits(grid(), flux, grid_velocity_, weight * dt, exits_);
        }
    }
    return {std::move(half), std::move(w)};
}

/// The flux of what the remainder half-way has beside the mean of both ends.
template <int D>
void TurnedRemainder<D>::find_curve(std::pair<FaceField<D>, FaceField<D>> half_and_end)
{
    auto& [half, end] = half_and_end;
    add(half, -0.5, end);
    add(half, -0.5, old_.flow.remainder.faces);
    const std::vector<Twist<D>> rest(old_.flow.twists.size(), Twist<D>::Zero());
    curve_ = face_fluxes(there_, flow_of_twists(there_, rest, options_, remainder_of(there_, std::move(half))));
}

/// The flux that changes does some work against the mean one. Of the turning by its change, as much less in proportion to what it does at each edge: the least
/// change of the vorticity's part in it.
template <int D>
void TurnedRemainder<D>::take_work(const Instant<D>& end, FaceField<D>& w) const
{
    const FaceField<D> mean = mean_flux(end);
    FaceField<D> difference = w, by(grid()), change = end.flux;
    add(difference, -1, old_.flow.remainder.faces);
    add(change, -1, old_.flux);
    for (const FaceField<D>* part : {&std::as_const(change), &std::as_const(curve_)})
        if ((*part)[0].size() > 0)
            add(by, 1, turned(grid(), *part, [&](const EdgeRow<D>& row) {
                    const std::array<const double*, 2> mean_a = row.values(mean, row.a), mean_b = row.values(mean, row.b),
                                                       part_a = row.values(*part, row.a), part_b = row.values(*part, row.b);
                    return [=, &row, &grid = grid()](int i) {
                        double sum = 0;
                        for (int a = 0; a < 2; ++a)
                            for (int b = 0; b < 2; ++b)
                                sum += mean_a[a][i] * part_b[b][i] - mean_b[b][i] * part_a[a][i];
                        return sum / row.length(grid, i);
                    };
                }));
    const double all = work_of_fluxes(there_.coupling, mean, by);
    if (all > 0)
        add(w, -work_of_fluxes(there_.coupling, mean, difference) / all, by);
}

template <int D>
double TurnedRemainder<D>::work(const Instant<D>& end) const
{
    if (old_.flow.remainder.empty())
        return 0;
    FaceField<D> difference = end.flow.remainder.faces;
    add(difference, -1, old_.flow.remainder.faces);
    if (heads_[0].size() > 0)
        add(difference, -1, heads_);
    return work_of_fluxes(there_.coupling, mean_flux(end), difference);
}

template <int D>
double TurnedRemainder<D>::work_of_grid(const Instant<D>& end) const
{
    if (!grid_moves() || old_.flow.remainder.empty())
        return 0;
    FaceField<D> gain = end.flow.remainder.faces;
    for (const FaceField<D>* without : {&old_.flow.remainder.faces, &heads_, &exits_})
        add(gain, -1, *without);
    return -work_of_fluxes(there_.coupling, grid_flux_, gain);
}

template <int D>
FaceField<D> TurnedRemainder<D>::flux_at(const Instant<D>* end, double share) const
{
    FaceField<D> flux = old_.flux;
    if (end)
        for (int axis = 0; axis < D; ++axis)
            for (long i = 0; i < flux[axis].size(); ++i)
                flux[axis].data()[i] = (1 - share) * flux[axis].data()[i] + share * end->flux[axis].data()[i];
    if (curve_[0].size() > 0)
        add(flux, 4 * share * (1 - share), curve_);
    if (grid_moves())
        add(flux, -1, grid_flux_);
    return flux;
}

template <int D>
FaceField<D> TurnedRemainder<D>::mean_flux(const Instant<D>& end) const
{
    FaceField<D> flux = old_.flux;
    for (int axis = 0; axis < D; ++axis)
        for (long i = 0; i < flux[axis].size(); ++i)
            flux[axis].data()[i] = 0.5 * (flux[axis].data()[i] + end.flux[axis].data()[i]);
    if (grid_moves())
        add(flux, -1, grid_flux_);
    return flux;
}

/// Cells that the fluid passes in the step, the sum over the axes of the most along each.
template <int D>
double TurnedRemainder<D>::courant(const FaceField<D>& flux) const
{
    double sum = 0;
    for (int axis = 0; axis < D; ++axis) {
        double most = 0;
        const Index<D> low = grid().low(), end = owned_faces_end(grid(), axis);
        for_each_row<D>(low, end, [&](const Index<D>& first) {
            const double* values = &flux(axis, first);
            Index<D> f = first;
            for (int i = 0; i < end[0] - low[0]; ++i, ++f[0])
                most = std::max(most, grid().graded()
                                          ? std::abs(values[i]) / (grid().relative_area(axis, f) * grid().spread(axis, f[axis]))
                                          : std::abs(values[i]));
        });
        sum += grid().comm().max(most);
    }
    return sum * dt_ / grid().dx();
}

template <int D>
void TurnedRemainder<D>::add(FaceField<D>& to, double factor, const FaceField<D>& change) const
{
    for (int axis = 0; axis < D; ++axis)
        for (long i = 0; i < change[axis].size(); ++i)
            to[axis].data()[i] += factor * change[axis].data()[i];
    exchange(grid(), to);
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template FaceField<D> vortex_impulse<D>(const Grid<D>&, const FaceField<D>&, const FaceField<D>&, double);                 \
    template ForceOfGrid<D> force_of_grid<D>(const Coupling<D>&, const FaceField<D>&, const FaceField<D>&, int);               \
    template class TurnedRemainder<D>;
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
