// u_t + (u . grad) u = 0 along characteristics (method, section 5, stage 2).
//
// Trace (midpoint, second order):  x_m = x - dt/2 u(x),  x_d = x - dt u(x_m), u linear in every axis between faces.
// Semi-Lagrangian (first order):   A(phi)(x) = phi(x_d)
// MacCormack (second order; Selle, Fedkiw, Kim, Liu & Rossignac, J. Sci. Comput. 35, 2008):
//     phi_hat = A(phi),  phi_back = A^R(phi_hat) with the flow reversed,
//     result  = phi_hat + (phi - phi_back) / 2,  clamped to the values of phi at the corners around x_d.
//
// Points are kept as displacements from their face, in cells: the same bits on any number of ranks, and a constant field
// is reproduced exactly.
#include "gapflow/stepping/advection.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

namespace gapflow {

namespace {

// Ghosts of the component normal to `axis`, side after side over the block's whole width, so that corners are filled too.
template <int D>
void fill_component_ghosts(const Grid<D>& grid, int axis, CellField<D>& u, const BoundaryVelocity<D>& sides)
{
    exchange(grid, u);
    const Block<D>& block = u.block();
    for (int normal = 0; normal < D; ++normal)
        for (int end = 0; end < 2; ++end) {
            const SideKind kind = grid.side(normal, end);
            const int last = grid.cells()[normal] - (axis == normal ? 0 : 1); // index of the last value along `normal`
            const bool mine = end == 0 ? grid.low()[normal] == 0 : grid.high()[normal] == grid.cells()[normal];
            if (kind == SideKind::periodic || !mine)
                continue;
            const double given = sides.velocity[2 * normal + end][axis];
            const bool set_boundary = axis == normal && kind != SideKind::open;
            Index<D> low = block.low, high = block.high;
            (end == 0 ? high[normal] : low[normal]) = end == 0 ? (set_boundary ? 1 : 0) : last + (set_boundary ? 0 : 1);
            for_each_index<D>(low, high, [&](const Index<D>& ghost) {
                const int beyond = end == 0 ? -ghost[normal] : ghost[normal] - last; // 0 on the boundary face, else >= 1
                Index<D> inside = ghost;
                if (kind == SideKind::inflow || (set_boundary && beyond == 0)) {
                    u(ghost) = given;
                    return;
                }
                const int mirrored = kind == SideKind::open ? 0 : axis == normal ? beyond : beyond - 1;
                inside[normal] = end == 0 ? std::min(mirrored, last) : std::max(last - mirrored, 0);
                u(ghost) = kind == SideKind::wall && axis == normal ? 2 * given - u(inside) : u(inside);
            });
        }
}

template <int D>
using Point = std::array<double, D>;

// Where a displacement d from a value of a field lies: the lowest corner of its cell of values, and the weights in it.
template <int D>
struct Cell {
    const double* corner;
    Point<D> weight;
};

template <int D>
inline Cell<D> cell_at(const double* value, const std::array<long, D>& stride, const Point<D>& d)
{
    Cell<D> cell{value, {}};
    for (int k = 0; k < D; ++k) {
        const double whole = std::floor(d[k]);
        cell.weight[k] = d[k] - whole;
        cell.corner += static_cast<int>(whole) * stride[k];
    }
    return cell;
}

// Linear in every axis between the corners; exact for constants.
template <int D>
inline double interpolate(const Cell<D>& cell, const std::array<long, D>& stride)
{
    auto line = [&](const double* p) { return p[0] + cell.weight[0] * (p[1] - p[0]); };
    auto plane = [&](const double* p) {
        const double a = line(p);
        return a + cell.weight[1] * (line(p + stride[1]) - a);
    };
    if constexpr (D == 2) {
        return plane(cell.corner);
    } else {
        const double a = plane(cell.corner);
        return a + cell.weight[2] * (plane(cell.corner + stride[2]) - a);
    }
}

template <int D>
inline std::pair<double, double> corner_range(const Cell<D>& cell, const std::array<long, D>& stride)
{
    double low = cell.corner[0], high = low;
    for (long z = 0; z <= (D == 3 ? stride[D - 1] : 0); z += stride[D - 1])
        for (long y = 0; y <= stride[1]; y += stride[1])
            for (long x = 0; x <= 1; ++x) {
                low = std::min(low, cell.corner[x + y + z]);
                high = std::max(high, cell.corner[x + y + z]);
            }
    return {low, high};
}

// Traces from faces normal to Axis. All fields of a grid share one block, so one offset serves all of them.
template <int D, int Axis>
struct Tracer {
    std::array<const double*, D> u;
    std::array<long, D> stride;
    Point<D> low, high; // bounds of feet, in cells from the domain's origin

    Tracer(const Grid<D>& grid, const FaceField<D>& velocity)
    {
        const Block<D>& block = velocity[0].block();
        for (int k = 0; k < D; ++k) {
            u[k] = velocity[k].data();
            stride[k] = block.stride[k];
            const int n = grid.cells()[k];
            const bool low_wall = grid.low()[k] == 0 && grid.side(k, 0) == SideKind::wall;
            const bool high_wall = grid.high()[k] == n && grid.side(k, 1) == SideKind::wall;
            low[k] = low_wall ? 0.0 : block.low[k] + 0.5;
            high[k] = high_wall ? n : block.high[k] - 1.5;
        }
    }

    // u at d from the face at `offset`. Component b sits half a cell down along b and half a cell up along Axis from there.
    Point<D> velocity(long offset, const Point<D>& d) const
    {
        Point<D> w;
        for (int b = 0; b < D; ++b) {
            Point<D> from_b = d;
            from_b[b] += 0.5;
            from_b[Axis] -= 0.5;
            w[b] = interpolate<D>(cell_at<D>(u[b] + offset, stride, from_b), stride);
        }
        return w;
    }

    // The same at d = 0.
    Point<D> velocity(long offset) const
    {
        Point<D> w;
        for (int b = 0; b < D; ++b) {
            const double* p = u[b] + offset;
            const long up = stride[b], back = stride[Axis];
            w[b] = b == Axis ? p[0] : 0.25 * (p[0] + p[up] + p[-back] + p[up - back]);
        }
        return w;
    }

    // Displacement of the point that reaches `arrival` (both from face centre x) after courant * dx / dt; w = u there.
    Point<D> foot(long offset, const Point<D>& x, const Point<D>& arrival, const Point<D>& w, double courant) const
    {
        return clamped(x, arrival, velocity(offset, clamped(x, arrival, w, 0.5 * courant)), courant);
    }

private:
    static Point<D> displaced(const Point<D>& arrival, const Point<D>& w, double courant)
    {
        Point<D> d;
        for (int k = 0; k < D; ++k)
            d[k] = arrival[k] - courant * w[k];
        return d;
    }
    // Written so that a NaN ends up inside, too.
    Point<D> clamped(const Point<D>& x, const Point<D>& arrival, const Point<D>& w, double courant) const
    {
        Point<D> d = displaced(arrival, w, courant);
        for (int k = 0; k < D; ++k) {
            d[k] = d[k] > low[k] - x[k] ? d[k] : low[k] - x[k];
            d[k] = d[k] < high[k] - x[k] ? d[k] : high[k] - x[k];
        }
        return d;
    }
};

// Calls f(offset of the face in its field, position of its centre in cells) for all owned faces normal to Axis.
template <int D, int Axis, class F>
void for_owned_faces(const Grid<D>& grid, const Block<D>& block, F&& f)
{
    const Index<D> low = grid.low(), end = owned_faces_end(grid, Axis);
    Index<D> row_end = end;
    row_end[0] = low[0] + 1;
    for_each_index<D>(low, row_end, [&](const Index<D>& row) {
        const long offset = block.offset(row);
        Point<D> x;
        for (int k = 0; k < D; ++k)
            x[k] = row[k] + (k == Axis ? 0.0 : 0.5);
        const double x0 = x[0];
        const int n = end[0] - low[0];
        for (int i = 0; i < n; ++i) {
            x[0] = x0 + i;
            f(offset + i, x);
        }
    });
}

template <int D, int Axis>
void advect_component(const Grid<D>& grid, CellField<D>& result, const FaceField<D>& u, const CellField<D>& carried, double dt,
                      AdvectionScheme scheme, const BoundaryVelocity<D>& sides, const FaceFractions<D>* fractions,
                      const CellField<D, std::int8_t>* plain)
{
    const Tracer<D, Axis> tracer(grid, u);
    const auto& stride = tracer.stride;
    const Block<D>& block = carried.block();
    const double* phi = carried.data();
    double* out = result.data();
    const double courant = dt / grid.dx();
    const bool corrected = scheme == AdvectionScheme::maccormack;
    const Point<D> centre{};
    auto value = [&](const double* field, long offset, const Point<D>& d) {
        return interpolate<D>(cell_at<D>(field + offset, stride, d), stride);
    };

    CellField<D> hat_field;
    if (!corrected) {
        for_owned_faces<D, Axis>(grid, block, [&](long f, const Point<D>& x) {
            out[f] = value(phi, f, tracer.foot(f, x, centre, tracer.velocity(f), courant));
        });
    } else {
        hat_field = CellField<D>(grid);
        double* hat = hat_field.data();
        std::vector<std::pair<double, double>> range(block.size);
        for_owned_faces<D, Axis>(grid, block, [&](long f, const Point<D>& x) {
            const Point<D> d = tracer.foot(f, x, centre, tracer.velocity(f), courant);
            const Cell<D> cell = cell_at<D>(phi + f, stride, d);
            hat[f] = interpolate<D>(cell, stride);
            range[f] = corner_range<D>(cell, stride);
        });
        fill_component_ghosts(grid, Axis, hat_field, sides);
        const std::int8_t* uncorrected = plain ? plain->data() : nullptr;
        for_owned_faces<D, Axis>(grid, block, [&](long f, const Point<D>& x) {
            if (uncorrected && uncorrected[f]) {
                out[f] = hat[f];
                return;
            }
            const double back = value(hat, f, tracer.foot(f, x, centre, tracer.velocity(f), -courant));
            out[f] = std::clamp(hat[f] + 0.5 * (phi[f] - back), range[f].first, range[f].second);
        });
    }
    if (!fractions)
        return;
    // Cut faces again, now arriving at their open parts; phi_hat stays the field on face centres.
    const int* cut = fractions->cut[Axis].data();
    for_owned_faces<D, Axis>(grid, block, [&](long f, const Point<D>& x) {
        if (cut[f] < 0 || fractions->faces[cut[f]].open == 0)
            return;
        Point<D> arrival;
        for (int k = 0; k < D; ++k)
            arrival[k] = (fractions->faces[cut[f]].open_centroid[k] - grid.origin()[k]) / grid.dx() - x[k];
        const Point<D> w = tracer.velocity(f, arrival);
        const Cell<D> cell = cell_at<D>(phi + f, stride, tracer.foot(f, x, arrival, w, courant));
        out[f] = interpolate<D>(cell, stride);
        if (corrected && !(plain && plain->data()[f])) {
            const double back = value(hat_field.data(), f, tracer.foot(f, x, arrival, w, -courant));
            const auto [low, high] = corner_range<D>(cell, stride);
            out[f] = std::clamp(out[f] + 0.5 * (value(phi, f, arrival) - back), low, high);
        }
    });
}

} // namespace

template <int D>
void fill_velocity_ghosts(const Grid<D>& grid, FaceField<D>& u, const BoundaryVelocity<D>& sides)
{
    for (int axis = 0; axis < D; ++axis)
        fill_component_ghosts(grid, axis, u[axis], sides);
}

template <int D>
void advect(const Grid<D>& grid, FaceField<D>& result, const FaceField<D>& u, const FaceField<D>& carried, double dt,
            AdvectionScheme scheme, const BoundaryVelocity<D>& sides, const FaceFractions<D>* fractions,
            const FaceField<D, std::int8_t>* plain)
{
    assert(grid.ghost() >= 2 && &result != &u && &result != &carried);
    auto component = [&]<int Axis>(std::integral_constant<int, Axis>) {
        advect_component<D, Axis>(grid, result[Axis], u, carried[Axis], dt, scheme, sides, fractions,
                                  plain ? &(*plain)[Axis] : nullptr);
    };
    component(std::integral_constant<int, 0>{});
    component(std::integral_constant<int, 1>{});
    if constexpr (D == 3)
        component(std::integral_constant<int, 2>{});
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template void fill_velocity_ghosts<D>(const Grid<D>&, FaceField<D>&, const BoundaryVelocity<D>&);                          \
    template void advect<D>(const Grid<D>&, FaceField<D>&, const FaceField<D>&, const FaceField<D>&, double, AdvectionScheme,  \
                            const BoundaryVelocity<D>&, const FaceFractions<D>*, const FaceField<D, std::int8_t>*);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
