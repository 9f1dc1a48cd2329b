#include "gapflow/stepping/past_pressure.hpp"

#include "gapflow/core/threads.hpp"
#include "gapflow/grid/extrapolation.hpp"
#include "gapflow/grid/far_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gapflow {

namespace {

// Limit of the pressure's change, in multiples of dt |u . grad u|.
constexpr double inertial_share = 2;
// Number of layers of faces in solids to which velocity changes are extrapolated.
constexpr int carried_layers = 4;

} // namespace

template <int D>
void extrapolate_pressure(const Coupling<D>& coupling, PastPressure<D>& past)
{
    CellField<D>&pressure = past.pressure, &known = past.known;
    const Grid<D>& grid = *coupling.grid;
    const int width = grid.high()[0] - grid.low()[0];
    for (int layer = 0; layer < 2; ++layer) {
        exchange(grid, pressure, 1);
        exchange(grid, known, 1);
        std::vector<std::pair<Index<D>, double>> found;
        for_each_row<D>(grid.low(), grid.high(), [&](const Index<D>& row) { // a film may have left cells that no solid touches
            const auto* component = &coupling.system.component(row);
            const double* is_known = &known(row);
            for (int i = 0; i < width; ++i) {
                if (component[i] < 0 || is_known[i] > 0)
                    continue;
                const Index<D> c = row + i * step<D>(0);
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
        });
        for (const auto& [c, value] : found) {
            pressure(c) = value;
            known(c) = 1;
        }
    }
    exchange(grid, pressure, 1);
    exchange(grid, known, 1);
}

template <int D>
void subtract_known_gradient(const Coupling<D>& coupling, const PastPressure<D>& past, double dt, FaceField<D>& u,
                             const SidePressures<D>& beyond, FaceField<D, std::int8_t>* changed)
{
    const CellField<D>&pressure = past.pressure, &known = past.known;
    const Grid<D>& grid = *coupling.grid;
    const double scale = dt / (coupling.density * grid.dx());
    const FarField<D> far = far_field(grid);
    for (int axis = 0; axis < D; ++axis) {
        const long back = pressure.block().stride[axis];
        for_each_face_row<D>(
            grid, axis, owned_faces_end(grid, axis), [&](const Index<D>& first, int n, double above, double below) {
                const double *a = &coupling.system.conductance(axis, first), *p = &pressure(first), *k = &known(first);
                double* to = &u(axis, first);
                const double up = scale * above * (2 - below), down = scale * below * (2 - above);
                const SpreadRow<D> spread(grid, axis, first);
                for (int i = 0; i < n && grid.graded(); ++i) {
                    const double counts = a[i] > 0 ? 1.0 : 0.0, above_known = 1 + above * (k[i] - 1),
                                 below_known = 1 + below * (k[i - back] - 1);
                    to[i] -= counts * above_known * below_known / spread[i] * (up * p[i] - down * p[i - back]);
                }
                const int plain = grid.graded() ? 0 : n;
                for (int i = 0; i < plain; ++i) {
                    const double counts = a[i] > 0 ? 1.0 : 0.0, above_known = 1 + above * (k[i] - 1),
                                 below_known = 1 + below * (k[i - back] - 1);
                    to[i] -= counts * above_known * below_known * (up * p[i] - down * p[i - back]);
                }
                if (!changed)
                    return;
                std::int8_t* marks = &(*changed)(axis, first);
                for (int i = 0; i < n; ++i)
                    marks[i] = a[i] > 0 && (above == 0 || k[i] > 0) && (below == 0 || k[i - back] > 0);
            });
        for_each_far_face(grid, axis, [&](const Index<D>& f, int end) { // the pressure 0 is further away
            const Index<D> inner = end ? Index<D>(f - step<D>(axis)) : f;
            const double much = 2 * scale / grid.spread(axis, f[axis]) * (1 - 1 / far_distance(grid, far, axis, f));
            if (coupling.system.conductance(axis, f) > 0 && known(inner) > 0)
                u(axis, f) += (end ? -much : much) * pressure(inner);
        });
        for (int end = 0; end < 2; ++end)
            if (const double pressure_there = beyond[2 * axis + end]; pressure_there != 0)
                for_each_face_of_side<D>(grid, axis, end, [&](const Index<D>& f) {
                    const Index<D> inner = end ? Index<D>(f - step<D>(axis)) : f;
                    if (coupling.system.conductance(axis, f) > 0 && known(inner) > 0)
                        u(axis, f) += (end ? -2 : 2) * scale / grid.spread(axis, f[axis]) * pressure_there;
                });
    }
}

template <int D>
FaceField<D> velocity_change(const Coupling<D>& coupling, const PastPressure<D>& past, double dt,
                             const SidePressures<D>& beyond)
{
    FaceField<D> change(*coupling.grid);
    FaceField<D, std::int8_t> valid(*coupling.grid);
    subtract_known_gradient(coupling, past, dt, change, beyond, &valid);
    extrapolate(*coupling.grid, change, valid, carried_layers);
    return change;
}

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

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template void extrapolate_pressure<D>(const Coupling<D>&, PastPressure<D>&);                                               \
    template void subtract_known_gradient<D>(const Coupling<D>&, const PastPressure<D>&, double, FaceField<D>&,                \
                                             const SidePressures<D>&, FaceField<D, std::int8_t>*);                             \
    template FaceField<D> velocity_change<D>(const Coupling<D>&, const PastPressure<D>&, double, const SidePressures<D>&);     \
    template void limit_to_inertia<D>(const Grid<D>&, const FaceField<D>&, FaceField<D>&, FaceField<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
