#include "gapflow/stepping/velocity_ghosts.hpp"

#include <algorithm>

namespace gapflow {

namespace {

// u = constant + factor * (u `shift` values on) where index `normal` is `place`, for low <= others < high.
template <int D>
void set_layer(CellField<D>& u, Index<D> low, Index<D> high, int normal, int place, double constant, double factor, long shift)
{
    const Block<D>& block = u.block();
    low[normal] = place;
    high[normal] = place + 1;
    const int inner = normal == 0 ? 1 : 0, outer = D == 3 ? (normal == 2 ? 1 : 2) : inner; // of the layer's axes
    const long stride = block.stride[inner];
    double* const begin = u.data() + block.offset(low);
    for (int k = 0; k < (D == 3 ? high[outer] - low[outer] : 1); ++k) {
        double* to = begin + k * static_cast<long>(block.stride[outer]);
        const int n = high[inner] - low[inner];
        if (factor == 0)
            for (int i = 0; i < n; ++i)
                to[i * stride] = constant;
        else
            for (int i = 0; i < n; ++i)
                to[i * stride] = constant + factor * to[i * stride + shift];
    }
}

} // namespace

// Ghosts of the component normal to `axis`, side after side over the block's whole width, so that corners are filled too.
template <int D>
void fill_velocity_ghosts(const Grid<D>& grid, int axis, CellField<D>& u, const BoundaryVelocity<D>& sides)
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
            const bool set_boundary = axis == normal && !is_open(kind);
            Index<D> low = block.low, high = block.high;
            (end == 0 ? high[normal] : low[normal]) = end == 0 ? (set_boundary ? 1 : 0) : last + (set_boundary ? 0 : 1);
            // Layer by layer: values = constant + factor * those of another layer.
            for (int place = low[normal]; place < high[normal]; ++place) {
                const int beyond = end == 0 ? -place : place - last; // 0 on the boundary face, else >= 1
                const bool fixed = kind == SideKind::inflow || (set_boundary && beyond == 0);
                const bool opposite = !fixed && kind == SideKind::wall && (axis == normal || sides.no_slip);
                const double constant = fixed ? given : opposite ? 2 * given : 0.0, factor = opposite ? -1.0 : 1.0;
                const int mirrored = is_open(kind) ? 0 : axis == normal ? beyond : beyond - 1;
                const int source = end == 0 ? std::min(mirrored, last) : std::max(last - mirrored, 0);
                const long shift = fixed ? 0 : static_cast<long>(source - place) * block.stride[normal];
                set_layer(u, low, high, normal, place, constant, fixed ? 0.0 : factor, shift);
            }
        }
}

namespace {

// Fluid that comes in from far has no vorticity: d u_t / d n = d u_n / d t at the side, for the component t of u beyond the side normal
// to n. All layers beyond have one value.
template <int D>
void bring_in_without_vorticity(const Grid<D>& grid, int n, int end, int t, double grid_velocity, FaceField<D>& u)
{
    const CellField<D>& across = u[n];
    CellField<D>& along = u[t];
    const Block<D>& block = along.block();
    const int inner = end ? grid.cells()[n] - 1 : 0, outwards = end ? 1 : -1;
    Index<D> low = block.low, high = block.high;
    low[n] = inner;
    high[n] = inner + 1;
    ++low[t];
    for_each_index<D>(low, high, [&](const Index<D>& f) {
        Index<D> side = f;
        side[n] = end * grid.cells()[n];
        const double after = across(side), before = across(side - step<D>(t));
        if (outwards * (0.5 * (after + before) - grid_velocity) >= 0)
            return;
        const double value = along(f) + outwards * (after - before) * (grid.spread(n, side[n]) / grid.spread(t, f[t]));
        Index<D> ghost = f;
        for (ghost[n] += outwards; ghost[n] >= block.low[n] && ghost[n] < block.high[n]; ghost[n] += outwards)
            along(ghost) = value;
    });
}

} // namespace

template <int D>
void fill_velocity_ghosts(const Grid<D>& grid, FaceField<D>& u, const BoundaryVelocity<D>& sides)
{
    for (int axis = 0; axis < D; ++axis)
        fill_velocity_ghosts(grid, axis, u[axis], sides);
    for (int n = 0; n < D; ++n)
        for (int end = 0; end < 2; ++end) {
            const bool mine = end == 0 ? grid.low()[n] == 0 : grid.high()[n] == grid.cells()[n];
            for (int t = 0; t < D && mine && grid.side(n, end) == SideKind::far; ++t)
                if (t != n)
                    bring_in_without_vorticity(grid, n, end, t, sides.grid[n], u);
        }
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template void fill_velocity_ghosts<D>(const Grid<D>&, int, CellField<D>&, const BoundaryVelocity<D>&);                     \
    template void fill_velocity_ghosts<D>(const Grid<D>&, FaceField<D>&, const BoundaryVelocity<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
