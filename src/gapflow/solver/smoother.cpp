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

/// n cells of a chunk; `full`: n is the whole chunk, known to the compiler.
template <int D, bool full>
inline void relax_chunk(const Stencil<D>& s, const float* __restrict w, const float* b, float* __restrict x,
                        const std::array<long, D>& stride, int n)
{
    constexpr int chunk = SharedRows<float>::chunk;
    if (full)
        n = chunk;
    float gs[chunk];
    for (int i = 0; i < n; ++i) {
        float sum = b[i] + s.a0[i] * x[i - 1] + s.a0[i + 1] * x[i + 1] + s.below[0][i] * x[i - stride[1]] +
                    s.above[0][i] * x[i + stride[1]];
        if constexpr (D == 3)
            sum += s.below[1][i] * x[i - stride[2]] + s.above[1][i] * x[i + stride[2]];
        gs[i] = sum * s.inverse[i];
    }
    for (int i = 0; i < n; ++i)
        x[i] += w[i] * (gs[i] - x[i]);
}

template <int D>
void relax_row(Level<D>& level, const Index<D>& first, int colour)
{
    constexpr int chunk = SharedRows<float>::chunk;
    const long o = level.block.offset(first), row = level.row_number(first);
    const int n = level.high[0] - level.low[0];
    const float* w = weights(level, first, colour);
    std::array<long, D> stride;
    for (int axis = 0; axis < D; ++axis)
        stride[axis] = level.block.stride[axis];
    for (int c = 0, begin = 0; begin < n; ++c, begin += chunk) {
        const Stencil<D> s(level, row, c);
        const float* b = level.b.data() + o + begin;
        float* x = level.x.data() + o + begin;
        if (n - begin >= chunk)
            relax_chunk<D, true>(s, w + begin, b, x, stride, chunk);
        else
            relax_chunk<D, false>(s, w + begin, b, x, stride, n - begin);
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
    for_each_row<D>(low, high, [&](const Index<D>& first) {
        constexpr int chunk = SharedRows<float>::chunk;
        const long o = level.block.offset(first), row = level.row_number(first);
        const float* w = weights(level, first, colour);
        for (int c = 0, begin = 0; begin < n; ++c, begin += chunk) {
            const float* inverse = level.inverse_diagonal(row, c);
            const float* b = level.b.data() + o + begin;
            float* x = level.x.data() + o + begin;
            const int count = std::min(chunk, n - begin);
            for (int i = 0; i < count; ++i)
                x[i] = w[begin + i] * (b[i] * inverse[i]);
        }
    });
}

template void relax_plane<2>(Level<2>&, int, int);
template void relax_plane<3>(Level<3>&, int, int);
template void relax_plane_from_zero<2>(Level<2>&, int, int);
template void relax_plane_from_zero<3>(Level<3>&, int, int);

} // namespace gapflow
