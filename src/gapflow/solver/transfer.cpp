// Restriction R = P^T, P the piecewise constant prolongation: a coarse cell receives the sum of its fine cells' residuals,
// so that the total flux is kept exactly and a compatible right-hand side stays compatible on every level.

#include "gapflow/solver/transfer.hpp"

#include <algorithm>

namespace gapflow {

namespace {

constexpr int chunk = 256; // cells at once, even

template <int D>
void residual_row(const Level<D>& level, const Index<D>& row, int begin, int n, float* r)
{
    const long o = level.block.offset(row) + begin;
    const float* b = level.b.data() + o;
    const float* inverse = level.inverse_diagonal.data() + o;
    const float* x = level.x.data() + o;
    const float* a0 = level.conductance[0].data() + o;
    const float* a1 = level.conductance[1].data() + o;
    const long s1 = level.block.stride[1];
    for (int i = 0; i < n; ++i) {
        float flux = a0[i] * (x[i] - x[i - 1]) + a0[i + 1] * (x[i] - x[i + 1]) + a1[i] * (x[i] - x[i - s1]) +
                     a1[i + s1] * (x[i] - x[i + s1]);
        if constexpr (D == 3) {
            const float* a2 = level.conductance[2].data() + o;
            const long s2 = level.block.stride[2];
            flux += a2[i] * (x[i] - x[i - s2]) + a2[i + s2] * (x[i] - x[i + s2]);
        }
        r[i] = inverse[i] > 0.0f ? b[i] - flux : 0.0f;
    }
}

} // namespace

template <int D>
void restrict_plane(const Level<D>& fine, Level<D>& coarse, int plane)
{
    const int n = fine.high[0] - fine.low[0];
    const int half = fine.halves(0) ? 2 : 1, m = (n + half - 1) / half;
    Index<D> low = fine.low, high = fine.high;
    low[D - 1] = plane;
    high[D - 1] = plane + 1;
    for_each_row<D>(low, high, [&](const Index<D>& row) {
        Index<D> parent = row;
        bool first = true; // of the coarse row's fine rows
        for (int axis = 0; axis < D; ++axis)
            if (fine.halves(axis)) {
                first = first && (axis == 0 || row[axis] % 2 == 0);
                parent[axis] /= 2;
            }
        float* to = coarse.b.data() + coarse.block.offset(parent);
        if (first)
            std::fill_n(to, m, 0.0f);
        float r[chunk + 1];
        for (int begin = 0; begin < n; begin += chunk) {
            const int count = std::min(chunk, n - begin);
            residual_row(fine, row, begin, count, r);
            r[count] = 0;
            if (half == 1)
                to[0] += r[0];
            else
                for (int i = 0; i < (count + 1) / 2; ++i)
                    to[begin / 2 + i] += r[2 * i] + r[2 * i + 1];
        }
    });
}

template <int D>
void prolong_plane(const Level<D>& coarse, Level<D>& fine, int plane)
{
    const int n = fine.high[0] - fine.low[0];
    Index<D> low = fine.low, high = fine.high;
    low[D - 1] = plane;
    high[D - 1] = plane + 1;
    for_each_row<D>(low, high, [&](const Index<D>& row) {
        Index<D> parent = row;
        for (int axis = 0; axis < D; ++axis)
            parent[axis] >>= fine.halves(axis) ? 1 : 0;
        const float* from = coarse.x.data() + coarse.block.offset(parent);
        const float* inverse = fine.inverse_diagonal.data() + fine.block.offset(row);
        float* to = fine.x.data() + fine.block.offset(row);
        if (fine.halves(0))
            for (int i = 0; i < n; ++i)
                to[i] += inverse[i] > 0.0f ? from[i >> 1] : 0.0f;
        else
            to[0] += inverse[0] > 0.0f ? from[0] : 0.0f;
    });
}

template void restrict_plane<2>(const Level<2>&, Level<2>&, int);
template void restrict_plane<3>(const Level<3>&, Level<3>&, int);
template void prolong_plane<2>(const Level<2>&, Level<2>&, int);
template void prolong_plane<3>(const Level<3>&, Level<3>&, int);

} // namespace gapflow
