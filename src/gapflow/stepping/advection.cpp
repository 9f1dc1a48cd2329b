// u_t + (u . grad) u = 0 along characteristics (method, "The time step", stage 2).
//
// Trace (midpoint, second order):  x_m = x - dt/2 u(x),  x_d = x - dt u(x_m), u linear in every axis between faces.
// Semi-Lagrangian (first order):   A(phi)(x) = phi(x_d)
// MacCormack (second order; Selle, Fedkiw, Kim, Liu & Rossignac, J. Sci. Comput. 35, 2008):
//     phi_hat = A(phi),  phi_back = A^R(phi_hat) with the flow reversed,
//     result  = phi_hat + (phi - phi_back) / 2,  clamped to the values of phi at the corners around x_d.
#include "gapflow/stepping/advection.hpp"

#include "gapflow/core/threads.hpp"
#include "gapflow/stepping/traces.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <tuple>

namespace gapflow {

namespace {

using namespace traces;

// Calls f(offset of the first face in its field, position of its centre in cells, number of faces) for pieces of rows, of up
// to `lanes` owned faces normal to Axis, that make up all of them; planes are shared out over threads.
template <int D, int Axis, class F>
void for_owned_pieces(const Grid<D>& grid, const Block<D>& block, F&& f)
{
    const Index<D> low = grid.low(), end = owned_faces_end(grid, Axis);
    for_each_part(end[D - 1] - low[D - 1], [&](long first_plane, long end_plane) {
        Index<D> from = low, to = end;
        from[D - 1] = low[D - 1] + static_cast<int>(first_plane);
        to[D - 1] = low[D - 1] + static_cast<int>(end_plane);
        to[0] = low[0] + 1;
        for_each_index<D>(from, to, [&](const Index<D>& row) {
            const long offset = block.offset(row);
            Point<D> x;
            for (int k = 0; k < D; ++k)
                x[k] = row[k] + (k == Axis ? 0.0 : 0.5);
            const double x0 = x[0];
            const int width = end[0] - low[0];
            for (int i = 0; i < width; i += lanes) {
                x[0] = x0 + i;
                f(offset + i, static_cast<const Point<D>&>(x), std::min(lanes, width - i));
            }
        });
    });
}

// Input and output of the transport of one component. All fields share a block.
template <int D, int Axis>
struct Transport {
    const Grid<D>& grid;
    const Tracer<D, Axis>& tracer;
    double courant;       // dt / dx
    const double* phi;    // what is carried
    const double* change; // null: none
    double* out;
    double* hat;         // the semi-Lagrangian value; `out` where nothing corrects it
    std::int8_t* octant; // with a correction

    double value(const double* field, long offset, const Point<D>& d) const
    {
        return interpolate<D>(cell_at<D>(field + offset, tracer.stride, d), tracer.stride);
    }
};

// hat = A(phi). The contribution of the change is stored in `out` until the correction, unless `hat` is the same field.
template <int D, int Axis>
void carry(const Transport<D, Axis>& t, const Block<D>& block)
{
    const double* const g = t.change;
    auto add_change = [&](long f, double brought) { t.out[f] = (t.octant ? 0.0 : t.out[f]) + 0.5 * (brought - g[f]); };
    for_owned_pieces<D, Axis>(t.grid, block, [&](long first, Point<D> x, int n) {
        RowTracer<D, Axis> rows(t.tracer);
        Lanes<D> d;
        rows.start(first, x, n);
        if (rows.trace(t.courant, d)) {
            values_near<D>(t.phi + first, t.tracer.stride, d, n, t.hat + first);
            if (t.octant)
                store_octants<D>(d, n, t.octant + first);
            if (g) {
                std::array<double, lanes> brought;
                values_near<D>(g + first, t.tracer.stride, d, n, brought.data());
                for (int i = 0; i < n; ++i)
                    add_change(first + i, brought[i]);
            }
            return;
        }
        if (t.octant)
            t.octant[first] = far_away;
        for (long f = first; f < first + n; ++f, ++x[0]) {
            const Point<D> foot = t.tracer.foot(f, x, t.tracer.velocity(f), t.courant);
            t.hat[f] = t.value(t.phi, f, foot);
            if (g)
                add_change(f, t.value(g, f, foot));
        }
    });
}

// out = hat + (phi - A^R(hat)) / 2 within the values around the foot, hat where `first_order` says so; the change is added.
template <int D, int Axis>
void correct(const Transport<D, Axis>& t, const Block<D>& block, const std::int8_t* first_order)
{
    const auto& stride = t.tracer.stride;
    const double *phi = t.phi, *hat = t.hat;
    for_owned_pieces<D, Axis>(t.grid, block, [&](long first, Point<D> x, int n) {
        RowTracer<D, Axis> rows(t.tracer);
        Lanes<D> back_d;
        rows.start(first, x, n);
        std::array<double, lanes> back, low, high;
        if (t.octant[first] != far_away && rows.trace(-t.courant, back_d)) {
            values_near<D>(hat + first, stride, back_d, n, back.data());
            ranges_near<D>(phi + first, stride, t.octant + first, n, low.data(), high.data());
        } else {
            for (int i = 0; i < n; ++i, ++x[0]) {
                const long f = first + i;
                const Point<D> w = t.tracer.velocity(f);
                std::tie(low[i], high[i]) =
                    corner_range<D>(cell_at<D>(phi + f, stride, t.tracer.foot(f, x, w, t.courant)), stride);
                back[i] = t.value(hat, f, t.tracer.foot(f, x, w, -t.courant));
            }
        }
#pragma omp simd
        for (int i = 0; i < n; ++i) {
            const long f = first + i;
            const double v = hat[f] + 0.5 * (phi[f] - back[i]), least = v < low[i] ? low[i] : v;
            back[i] = least > high[i] ? high[i] : least;
        }
        if (first_order)
            for (int i = 0; i < n; ++i)
                if (first_order[first + i])
                    back[i] = hat[first + i];
        for (int i = 0; i < n; ++i)
            t.out[first + i] = t.change ? t.out[first + i] + back[i] : back[i];
    });
}

// Semi-Lagrangian values of marked faces.
template <int D, int Axis>
void advect_marked(const Grid<D>& grid, CellField<D>& result, const FaceField<D>& u, const CellField<D, std::int8_t>& marked,
                   double dt, const Vec<D>& grid_velocity)
{
    const Tracer<D, Axis> tracer(grid, u, grid_velocity);
    const double* phi = u[Axis].data();
    for_owned_pieces<D, Axis>(grid, result.block(), [&](long first, Point<D> x, int n) {
        const std::int8_t* mark = marked.data() + first;
        int any = 0;
        for (int i = 0; i < n; ++i)
            any |= mark[i];
        if (any == 0)
            return;
        for (long f = first; f < first + n; ++f, ++x[0]) {
            if (!marked.data()[f])
                continue;
            const Point<D> d = tracer.foot(f, x, tracer.velocity(f), dt / grid.dx());
            result.data()[f] = interpolate<D>(cell_at<D>(phi + f, tracer.stride, d), tracer.stride);
        }
    });
}

template <int D, class F>
void for_each_axis(F&& f)
{
    f(std::integral_constant<int, 0>{});
    f(std::integral_constant<int, 1>{});
    if constexpr (D == 3)
        f(std::integral_constant<int, 2>{});
}

} // namespace

template <int D>
void advect(const Grid<D>& grid, FaceField<D>& result, const FaceField<D>& u, const FaceField<D>& carried, double dt,
            AdvectionScheme scheme, const BoundaryVelocity<D>& sides, const FaceField<D, std::int8_t>* first_order,
            const FaceField<D>* change, const Vec<D>& grid_velocity)
{
    assert(grid.ghost() >= 2 && &result != &u && &result != &carried);
    const bool corrected = scheme == AdvectionScheme::maccormack;
    CellField<D> hat;
    CellField<D, std::int8_t> octants;
    if (corrected) {
        hat = CellField<D>(grid);
        octants = CellField<D, std::int8_t>(grid);
    }
    for_each_axis<D>([&]<int Axis>(std::integral_constant<int, Axis>) {
        const Tracer<D, Axis> tracer(grid, u, grid_velocity);
        double* const out = result[Axis].data();
        const Transport<D, Axis> transport{grid,
                                           tracer,
                                           dt / grid.dx(),
                                           carried[Axis].data(),
                                           change ? (*change)[Axis].data() : nullptr,
                                           out,
                                           corrected ? hat.data() : out,
                                           corrected ? octants.data() : nullptr};
        carry(transport, carried[Axis].block());
        if (!corrected)
            return;
        fill_velocity_ghosts(grid, Axis, hat, sides);
        correct(transport, carried[Axis].block(), first_order ? (*first_order)[Axis].data() : nullptr);
    });
}

template <int D>
void advect_marked_faces(const Grid<D>& grid, FaceField<D>& result, const FaceField<D>& u,
                         const FaceField<D, std::int8_t>& marked, double dt, const Vec<D>& grid_velocity)
{
    assert(&result != &u);
    for_each_axis<D>([&]<int Axis>(std::integral_constant<int, Axis>) {
        advect_marked<D, Axis>(grid, result[Axis], u, marked[Axis], dt, grid_velocity);
    });
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template void advect<D>(const Grid<D>&, FaceField<D>&, const FaceField<D>&, const FaceField<D>&, double, AdvectionScheme,  \
                            const BoundaryVelocity<D>&, const FaceField<D, std::int8_t>*, const FaceField<D>*, const Vec<D>&); \
    template void advect_marked_faces<D>(const Grid<D>&, FaceField<D>&, const FaceField<D>&, const FaceField<D, std::int8_t>&, \
                                         double, const Vec<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
