#include "gapflow/step/exits.hpp"

#include "gapflow/grid/side_faces.hpp"
#include "gapflow/step/inner_faces.hpp"

namespace gapflow {
namespace {

template <int D>
double speed_through(const Grid<D>& grid, const FaceField<D>& flux, int axis, const Index<D>& f)
{
    return flux(axis, f) / grid.relative_area(axis, f);
}

/// Whether fluid that leaves keeps its vorticity.
template <int D>
bool is_exit(const Grid<D>& grid, int axis, int end, const Vec<D>& grid_velocity)
{
    return grid.side(axis, end) == SideKind::open ||
           (is_open(grid.side(axis, end)) && (end ? -1 : 1) * grid_velocity[axis] > 0);
}

} // namespace

// As around any edge of the grid (vorticity.cpp), with the one face along the side that there is: the velocity along it has no gradient across the side.
template <int D>
void turn_in_exits(const Grid<D>& grid, const FaceField<D>& flux, const Vec<D>& grid_velocity, double dt, FaceField<D>& impulse)
{
    for (int side = 0; side < 2 * D; ++side) {
        const int a = side / 2, end = side % 2;
        const int place = end * grid.cells()[a];
        if (!is_exit(grid, a, end, grid_velocity) || (end ? grid.high()[a] : grid.low()[a]) != place)
            continue;
        for (int b = 0; b < D; ++b) {
            if (b == a)
                continue;
            Index<D> first = grid.low(), last = grid.high() + step<D>(b); // the edges beside this rank's faces
            first[a] = place;
            last[a] = place + 1;
            for_each_index<D>(first, last, [&](const Index<D>& high) {
                if (!grid.periodic(b) && (high[b] == 0 || high[b] == grid.cells()[b]))
                    return;
                const Index<D> low = high - step<D>(b), along = end ? Index<D>(high - step<D>(a)) : high;
                const double u = speed_through(grid, flux, a, high), v = speed_through(grid, flux, a, low);
                if (!((end ? 1 : -1) * (u + v) > 0))
                    return;
                double length = 1; // of the edge over that in the core
                for (int axis = 0; axis < D; ++axis)
                    length *= axis == a || axis == b ? 1.0 : grid.width(axis, high[axis]);
                const double factor = 0.25 * dt * (v - u) / face_length(grid, b, along) / length;
                for (const Index<D>& across : {low, high}) {
                    impulse(a, across) += factor * grid.dx() / face_length(grid, a, across) * flux(b, along);
                    impulse(b, along) -= factor / grid.spread(b, along[b]) * flux(a, across);
                }
            });
        }
    }
}

template <int D>
void add_heads(const Grid<D>& grid, const FaceField<D>& flux, const Vec<D>& beyond, const Vec<D>& grid_velocity, double dt,
               FaceField<D>& impulse)
{
    for (int side = 0; side < 2 * D; ++side) {
        const int axis = side / 2, end = side % 2;
        if (!is_open(grid.side(axis, end)))
            continue;
        for_each_face_of_side(grid, axis, end, [&](const Index<D>& f) {
            const double u = speed_through(grid, flux, axis, f), outwards = end ? u : -u;
            const bool leaves = outwards > 0 && is_exit(grid, axis, end, grid_velocity);
            const double square = beyond.squaredNorm() - grid_velocity.squaredNorm() + // of fluid at rest none
                                  (leaves ? u * u - beyond[axis] * beyond[axis] : 0.0);
            impulse(axis, f) -= (end ? 0.5 : -0.5) * dt * square / face_length(grid, axis, f);
        });
    }
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template void turn_in_exits<D>(const Grid<D>&, const FaceField<D>&, const Vec<D>&, double, FaceField<D>&);                 \
    template void add_heads<D>(const Grid<D>&, const FaceField<D>&, const Vec<D>&, const Vec<D>&, double, FaceField<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
