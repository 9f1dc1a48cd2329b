// Red-black Gauss-Seidel for sum_f a_f (x_c - x_n) = b_c:
//
//     x_c <- x_c + w_c ((b_c + sum_f a_f x_n) / sum_f a_f - x_c),   w = 1 on the colour, 0 elsewhere,
//
// first order, symmetric as a pair (red, black) before and (black, red) after the coarse correction. Rows are relaxed as a
// whole with the weights as a mask: neighbours in the row have the other colour, so that all new values may be computed
// before any is stored, which vectorises.
// Around a periodic axis with an odd number of cells the first and last cell have one colour: both are relaxed from the old
// values with w = 0.8, which keeps the smoother convergent in the energy norm (2 D / w > A by diagonal dominance).

#include "gapflow/solver/smoother.hpp"

#include <algorithm>

namespace gapflow {

namespace {

constexpr int chunk = 256; // cells relaxed at once, a multiple of the vector width

template <int D>
const float* weights(const Level<D>& level, const Index<D>& row, int colour)
{
    bool seam = false;
    int sum = colour;
    for (int axis = 1; axis < D; ++axis) {
        sum += row[axis];
        seam = seam || level.on_seam(axis, row[axis]);
    }
    return level.weight[seam][sum & 1].data();
}

template <int D>
void relax_row(Level<D>& level, const Index<D>& row, int colour)
{
    const long o = level.block.offset(row);
    const int n = level.high[0] - level.low[0];
    const float* w = weights(level, row, colour);
    const float* b = level.b.data() + o;
    const float* inverse = level.inverse_diagonal.data() + o;
    const float* a0 = level.conductance[0].data() + o;
    const long s1 = level.block.stride[1];
    const float* a1 = level.conductance[1].data() + o;
    float* x = level.x.data() + o;
    float gs[chunk];
    for (int begin = 0; begin < n; begin += chunk) {
        const int end = std::min(n, begin + chunk);
        for (int i = begin; i < end; ++i) {
            float sum = b[i] + a0[i] * x[i - 1] + a0[i + 1] * x[i + 1] + a1[i] * x[i - s1] + a1[i + s1] * x[i + s1];
            if constexpr (D == 3) {
                const float* a2 = level.conductance[2].data() + o;
                const long s2 = level.block.stride[2];
                sum += a2[i] * x[i - s2] + a2[i + s2] * x[i + s2];
            }
            gs[i - begin] = sum * inverse[i];
        }
        for (int i = begin; i < end; ++i)
            x[i] += w[i] * (gs[i - begin] - x[i]);
    }
}

} // namespace

template <int D>
void relax_plane(Level<D>& level, int colour, int plane)
{
    Index<D> low = level.low, high = level.high;
    low[D - 1] = plane;
    high[D - 1] = plane + 1;
    for_each_row<D>(low, high, [&](const Index<D>& row) { relax_row(level, row, colour); });
}

template <int D>
void relax_plane_from_zero(Level<D>& level, int colour, int plane)
{
    Index<D> low = level.low, high = level.high;
    low[D - 1] = plane;
    high[D - 1] = plane + 1;
    const int n = high[0] - low[0];
    for_each_row<D>(low, high, [&](const Index<D>& row) {
        const long o = level.block.offset(row);
        const float* w = weights(level, row, colour);
        for (int i = 0; i < n; ++i)
            level.x[o + i] = w[i] * (level.b[o + i] * level.inverse_diagonal[o + i]);
    });
}

template void relax_plane<2>(Level<2>&, int, int);
template void relax_plane<3>(Level<3>&, int, int);
template void relax_plane_from_zero<2>(Level<2>&, int, int);
template void relax_plane_from_zero<3>(Level<3>&, int, int);

} // namespace gapflow
