// Traces from faces of the MAC grid back along the flow (method, "The time step", stage 2), face by face and for pieces of rows at once.
//
// Points are displacements from their face, in cells: a constant field is reproduced exactly, and results depend on the number of ranks only
// by round-off. Outside the core of a graded grid cells differ in width: a displacement then goes so many spacings of the lattice of its own
// component; other components are read at the same place in cells (second order where widths change smoothly).
#pragma once

#include "gapflow/grid/field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace gapflow {

namespace traces {

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
    Point<D> frame;     // velocity of the grid
    bool graded;
    std::array<std::vector<double>, D>
        inverse_spacing; // over 1 / dx, between the component's values i and i + 1; graded grids only
    Index<D> first;      // i of its first entry

    Tracer(const Grid<D>& grid, const FaceField<D>& velocity, const Vec<D>& grid_velocity) : graded(grid.graded())
    {
        for (int k = 0; k < D; ++k)
            frame[k] = grid_velocity[k];
        const Block<D>& block = velocity[0].block();
        first = block.low - Index<D>::Ones();
        for (int k = 0; k < D && graded; ++k)
            for (int i = first[k]; i <= block.high[k]; ++i)
                inverse_spacing[k].push_back(1 / (k == Axis ? grid.width(k, i) : grid.spread(k, i + 1)));
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

    // Displacement, from face centre x, of the point that reaches x after courant * dx / dt; w = u at x.
    Point<D> foot(long offset, const Point<D>& x, const Point<D>& w, double courant) const
    {
        return clamped(x, velocity(offset, clamped(x, w, 0.5 * courant)), courant);
    }

    /// Of the spacing above the component's value at x[k] along axis k.
    const double* spacings_at(int k, double x) const
    {
        return &inverse_spacing[k][static_cast<std::size_t>(static_cast<int>(x - (k == Axis ? 0.0 : 0.5)) - first[k])];
    }

private:
    // A displacement in dx from the component's value at x along axis k, in spacings.
    double in_spacings(int k, double x, double way) const
    {
        const double* inverse = spacings_at(k, x) - (way < 0 ? 1 : 0);
        const double* const begin = inverse_spacing[k].data();
        const double* const end = begin + inverse_spacing[k].size();
        const int sign = way < 0 ? -1 : 1;
        double left = std::abs(way), d = 0;
        for (; left * *inverse > 1; inverse += sign) {
            left -= 1 / *inverse;
            d += 1;
            if (inverse + sign < begin || inverse + sign >= end)
                break;
        }
        return sign * (d + left * *inverse);
    }

    // Written so that a NaN ends up inside, too.
    Point<D> clamped(const Point<D>& x, const Point<D>& w, double courant) const
    {
        Point<D> d;
        for (int k = 0; k < D; ++k) {
            const double relative = frame[k] == 0 ? w[k] : w[k] - frame[k];
            d[k] = graded ? in_spacings(k, x[k], -courant * relative) : -courant * relative;
            d[k] = d[k] > low[k] - x[k] ? d[k] : low[k] - x[k];
            d[k] = d[k] < high[k] - x[k] ? d[k] : high[k] - x[k];
        }
        return d;
    }
};

// Up to `lanes` faces of a row at once. Within half a cell of a face every interpolation reads fixed neighbours, or one of
// two by the displacement's sign: all faces then do the same, which vectorises. Faces with longer traces are computed one by
// one.
constexpr int lanes = 64;

template <int D>
using Lanes = std::array<std::array<double, lanes>, D>;

/// Which neighbours an interpolation reads along an axis: before or after by the sign of d (|d| <= 1), or, for components
/// half a cell off, always those on one side (|d| <= 1/2).
enum class Reach { by_sign, after, before };

template <Reach reach>
inline double along(double before, double here, double after, double d)
{
    if constexpr (reach == Reach::by_sign) {
        const double far = d < 0 ? before : after;
        return here + std::abs(d) * (far - here);
    } else if constexpr (reach == Reach::after) {
        return here + (d + 0.5) * (after - here);
    } else {
        return before + (d + 0.5) * (here - before);
    }
}

// Loops over lanes vectorise only if all of their body is inlined.
#define GAPFLOW_INLINE __attribute__((always_inline))

template <int D, Reach reach0, Reach reach1, Reach reach2>
GAPFLOW_INLINE inline double interpolate_near(const double* p, const std::array<long, D>& stride, double d0, double d1,
                                              double d2)
{
    auto line = [&](const double* c) GAPFLOW_INLINE { return along<reach0>(c[-1], c[0], c[1], d0); };
    auto plane = [&](const double* c)
                     GAPFLOW_INLINE { return along<reach1>(line(c - stride[1]), line(c), line(c + stride[1]), d1); };
    if constexpr (D == 2)
        return plane(p);
    else
        return along<reach2>(plane(p - stride[2]), plane(p), plane(p + stride[2]), d2);
}

/// Least (largest) of the values that interpolate_near with Reach::by_sign reads.
template <int D, class Pick>
GAPFLOW_INLINE inline double extreme_near(const double* p, const std::array<long, D>& stride, double d0, double d1, double d2,
                                          Pick&& pick)
{
    auto either = [&](double before, double here, double after, double d) GAPFLOW_INLINE {
        const double far = d < 0 ? before : after;
        return pick(here, far);
    };
    auto line = [&](const double* c) GAPFLOW_INLINE { return either(c[-1], c[0], c[1], d0); };
    auto plane = [&](const double* c) GAPFLOW_INLINE { return either(line(c - stride[1]), line(c), line(c + stride[1]), d1); };
    if constexpr (D == 2)
        return plane(p);
    else
        return either(plane(p - stride[2]), plane(p), plane(p + stride[2]), d2);
}

template <int D, int Axis>
constexpr Reach reach_of(int component, int axis)
{
    if (component == Axis || (axis != component && axis != Axis))
        return Reach::by_sign;
    return axis == component ? Reach::after : Reach::before;
}

template <int D, int Axis>
class RowTracer {
public:
    explicit RowTracer(const Tracer<D, Axis>& tracer) : tracer_(tracer) {}

    // Velocities at n face centres from `offset` on.
    void start(long offset, const Point<D>& x, int n)
    {
        offset_ = offset;
        x_ = x;
        n_ = n;
        for (int b = 0; b < D; ++b) {
            const double* p = tracer_.u[b] + offset;
            const long up = tracer_.stride[b], back = tracer_.stride[Axis];
            double* w = w_[b].data();
            if (b == Axis)
                std::copy_n(p, n, w);
            else
                for (int i = 0; i < n; ++i)
                    w[i] = 0.25 * (p[i] + p[i + up] + p[i - back] + p[i + up - back]);
        }
    }

    // Displacements of the feet for all faces; false if one lies too far for this way.
    bool trace(double courant, Lanes<D>& d) const
    {
        Lanes<D> half, w;
        if (!(displace(w_, 0.5 * courant, half) <= 0.5))
            return false;
        component_at<0>(half, w[0]);
        component_at<1>(half, w[1]);
        if constexpr (D == 3)
            component_at<2>(half, w[2]);
        return displace(w, courant, d) <= 1;
    }

private:
    // d = -courant w, clamped as Tracer does; returns the largest component.
    double displace(const Lanes<D>& w, double courant, Lanes<D>& d) const
    {
        double largest = 0;
        for (int k = 0; k < D; ++k) {
            const double low = tracer_.low[k] - x_[k], high = tracer_.high[k] - x_[k], shift = k == 0 ? 1.0 : 0.0;
            const double* from = w[k].data();
            std::array<double, lanes> relative;
            if (tracer_.frame[k] != 0) {
                for (int i = 0; i < n_; ++i)
                    relative[i] = from[i] - tracer_.frame[k];
                from = relative.data();
            }
            double* to = d[k].data();
            if (tracer_.graded) {
                largest = std::max(largest, displace_graded(k, from, courant, low, high, shift, to));
                continue;
            }
#pragma omp simd reduction(max : largest)
            for (int i = 0; i < n_; ++i) {
                double v = -courant * from[i];
                v = v > low - shift * i ? v : low - shift * i;
                v = v < high - shift * i ? v : high - shift * i;
                to[i] = v;
                largest = std::max(largest, std::abs(v));
            }
        }
        return largest;
    }

    // The same along axis k where spacings differ: right as far as the largest component is at most 1.
    double displace_graded(int k, const double* from, double courant, double low, double high, double shift, double* to) const
    {
        double largest = 0;
        const double* above = tracer_.spacings_at(k, x_[k]);
        const auto set = [&](int i, double before, double after) {
            double v = -courant * from[i];
            v *= v < 0 ? before : after;
            v = v > low - shift * i ? v : low - shift * i;
            v = v < high - shift * i ? v : high - shift * i;
            to[i] = v;
            largest = std::max(largest, std::abs(v));
        };
        if (k == 0)
            for (int i = 0; i < n_; ++i)
                set(i, above[i - 1], above[i]);
        else
            for (int i = 0; i < n_; ++i)
                set(i, above[-1], above[0]);
        return largest;
    }

    template <int B>
    void component_at(const Lanes<D>& d, std::array<double, lanes>& result) const
    {
        constexpr Reach r0 = reach_of<D, Axis>(B, 0), r1 = reach_of<D, Axis>(B, 1), r2 = reach_of<D, Axis>(B, 2);
        const double* p = tracer_.u[B] + offset_;
        const std::array<long, D> stride = tracer_.stride;
        double* to = result.data();
#pragma omp simd
        for (int i = 0; i < n_; ++i)
            to[i] = interpolate_near<D, r0, r1, r2>(p + i, stride, d[0][i], d[1][i], d[D - 1][i]);
    }

    const Tracer<D, Axis>& tracer_;
    long offset_ = 0;
    Point<D> x_{};
    int n_ = 0;
    Lanes<D> w_;
};

template <int D>
void values_near(const double* field, const std::array<long, D>& stride, const Lanes<D>& d, int n, double* result)
{
    constexpr Reach r = Reach::by_sign;
#pragma omp simd
    for (int i = 0; i < n; ++i)
        result[i] = interpolate_near<D, r, r, r>(field + i, stride, d[0][i], d[1][i], d[D - 1][i]);
}

// The octants in which feet lie, seen from their faces: bit k for d_k < 0. The correction needs no more of the first trace.
constexpr std::int8_t far_away = 64; // of a piece's first face: the feet were traced one by one

template <int D>
void store_octants(const Lanes<D>& d, int n, std::int8_t* octant)
{
    for (int i = 0; i < n; ++i) {
        int bits = 0;
        for (int k = 0; k < D; ++k)
            bits |= (d[k][i] < 0) << k;
        octant[i] = static_cast<std::int8_t>(bits);
    }
}

// Least and largest value at the corners of the cells in which feet lie.
template <int D>
void ranges_near(const double* field, const std::array<long, D>& stride, const std::int8_t* octant, int n, double* low,
                 double* high)
{
    Lanes<D> side;
    for (int k = 0; k < D; ++k)
        for (int i = 0; i < n; ++i)
            side[k][i] = octant[i] >> k & 1 ? -1.0 : 1.0;
#pragma omp simd
    for (int i = 0; i < n; ++i) {
        const double* p = field + i;
        low[i] = extreme_near<D>(p, stride, side[0][i], side[1][i], side[D - 1][i],
                                 [](double a, double b) { return a < b ? a : b; });
        high[i] = extreme_near<D>(p, stride, side[0][i], side[1][i], side[D - 1][i],
                                  [](double a, double b) { return a > b ? a : b; });
    }
}

#undef GAPFLOW_INLINE

} // namespace traces

} // namespace gapflow
