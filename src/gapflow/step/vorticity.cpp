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

/// Four faces meet at an edge of the grid (2D: a vertex) normal to the axes a and b: those around the low corner of cell v.
template <int D>
struct AroundEdge {
    std::array<Index<D>, 2> of_a, of_b;
    AroundEdge(int a, int b, const Index<D>& v) : of_a{Index<D>(v - step<D>(b)), v}, of_b{Index<D>(v - step<D>(a)), v} {}

    double curl(const Grid<D>& grid, int a, int b, const FaceField<D>& w) const
    {
        return (w(a, of_a[0]) - w(a, of_a[1])) / face_length(grid, b, of_b[1]) +
               (w(b, of_b[1]) - w(b, of_b[0])) / face_length(grid, a, of_a[1]);
    }
};

/// f(around, a, b, v) for the edges of the grid beside this rank's cells, but those in sides of the domain.
template <int D, class F>
void for_each_edge(const Grid<D>& grid, const F& f)
{
    for (int a = 0; a < D; ++a)
        for (int b = a + 1; b < D; ++b)
            for_each_index<D>(grid.low(), grid.high() + step<D>(a) + step<D>(b), [&](const Index<D>& v) {
                const auto within = [&](int axis) {
                    return grid.periodic(axis) || (v[axis] > 0 && v[axis] < grid.cells()[axis]);
                };
                if (within(a) && within(b))
                    f(AroundEdge<D>(a, b, v), a, b, v);
            });
}

/// Length of an edge over that in the core; 1 in 2D.
template <int D>
double edge_length(const Grid<D>& grid, int a, int b, const Index<D>& v)
{
    double length = 1;
    for (int axis = 0; axis < D; ++axis)
        length *= axis == a || axis == b ? 1.0 : grid.width(axis, v[axis]);
    return length;
}

/// v x omega of omega(around, a, b, v) at each edge. Half of each face's flux passes an edge, to either side of it.
template <int D, class F>
FaceField<D> turned(const Grid<D>& grid, const FaceField<D>& flux, const F& omega)
{
    FaceField<D> result(grid);
    for_each_edge(grid, [&](const AroundEdge<D>& around, int a, int b, const Index<D>& v) {
        const double factor = 0.25 * omega(around, a, b, v) / edge_length(grid, a, b, v);
        for (const Index<D>& fa : around.of_a)
            for (const Index<D>& fb : around.of_b) {
                result(a, fa) += factor / grid.spread(a, fa[a]) * flux(b, fb);
                result(b, fb) -= factor / grid.spread(b, fb[b]) * flux(a, fa);
            }
    });
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
    return turned(grid, flux, [&](const AroundEdge<D>& around, int a, int b, const Index<D>&) {
        return dt * around.curl(grid, a, b, remainder);
    });
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
    if (!has_exits())
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
    for (int k = 0; k < steps; ++k) {
        if (2 * k == steps)
            half = w;
        const FaceField<D> start = w;
        FaceField<D> rate;
        for (const auto& [way, weight] :
             {std::pair(0.0, 1.0 / 6), std::pair(0.5, 1.0 / 3), std::pair(0.5, 1.0 / 3), std::pair(1.0, 1.0 / 6)}) {
            FaceField<D> at = start;
            if (way > 0)
                add(at, way, rate);
            const FaceField<D> flux = flux_at(end, (k + way) / steps);
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
            add(by, 1, turned(grid(), *part, [&](const AroundEdge<D>& around, int a, int b, const Index<D>& v) {
                    double sum = 0;
                    for (const Index<D>& fa : around.of_a)
                        for (const Index<D>& fb : around.of_b)
                            sum += mean(a, fa) * (*part)(b, fb) - mean(b, fb) * (*part)(a, fa);
                    return sum / edge_length(grid(), a, b, v);
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
    return -work_of_fluxes(there_.coupling, flux_of_velocity<D>(grid(), grid_velocity_), gain);
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
        add(flux, -1, flux_of_velocity<D>(grid(), grid_velocity_));
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
        add(flux, -1, flux_of_velocity<D>(grid(), grid_velocity_));
    return flux;
}

/// Cells that the fluid passes in the step, the sum over the axes of the most along each.
template <int D>
double TurnedRemainder<D>::courant(const FaceField<D>& flux) const
{
    double sum = 0;
    for (int axis = 0; axis < D; ++axis) {
        double most = 0;
        for_each_index<D>(grid().low(), owned_faces_end(grid(), axis), [&](const Index<D>& f) {
            most = std::max(most, std::abs(flux(axis, f)) / (grid().relative_area(axis, f) * grid().spread(axis, f[axis])));
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
