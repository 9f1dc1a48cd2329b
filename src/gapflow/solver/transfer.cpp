// Restriction R = P^T, P the piecewise constant prolongation: a coarse cell receives the sum of its fine cells' residuals,
// so that the total flux is kept exactly and a compatible right-hand side stays compatible on every level.

#include "gapflow/solver/transfer.hpp"

#include <algorithm>

namespace gapflow {

namespace {

constexpr int chunk = SharedRows<float>::chunk; // even

template <int D, bool full>
inline void residual_chunk(const Stencil<D>& s, const float* b, const float* x, const std::array<long, D>& stride, int n,
                           float* r)
{
    if (full)
        n = chunk;
    for (int i = 0; i < n; ++i) {
        float flux = s.a0[i] * (x[i] - x[i - 1]) + s.a0[i + 1] * (x[i] - x[i + 1]) + s.below[0][i] * (x[i] - x[i - stride[1]]) +
                     s.above[0][i] * (x[i] - x[i + stride[1]]);
        if constexpr (D == 3)
            flux += s.below[1][i] * (x[i] - x[i - stride[2]]) + s.above[1][i] * (x[i] - x[i + stride[2]]);
        r[i] = s.inverse[i] > 0.0f ? b[i] - flux : 0.0f;
    }
}

} // namespace

template <int D>
void restrict_plane(const Level<D>& fine, Level<D>& coarse, int plane)
{
    const int n = fine.high[0] - fine.low[0];
    const std::vector<int>& parents = fine.parent[0]; // along the first axis
    const int first_parent = parents[fine.low[0]], m = parents[fine.high[0] - 1] + 1 - first_parent;
    const bool in_pairs = fine.in_pairs(0);
    Index<D> low = fine.low, high = fine.high;
    low[D - 1] = plane;
    high[D - 1] = plane + 1;
    std::array<long, D> stride;
    for (int axis = 0; axis < D; ++axis)
        stride[axis] = fine.block.stride[axis];
    for_each_row<D>(low, high, [&](const Index<D>& row) {
        Index<D> parent;
        bool first = true; // of the coarse row's fine rows
        for (int axis = 0; axis < D; ++axis) {
            parent[axis] = fine.parent[axis][row[axis]];
            first = first && (axis == 0 || row[axis] == fine.low[axis] || fine.parent[axis][row[axis] - 1] != parent[axis]);
        }
        float* to = coarse.b.data() + coarse.block.offset(parent);
        if (first)
            std::fill_n(to, m, 0.0f);
        const long o = fine.block.offset(row), number = fine.row_number(row);
        float r[chunk + 1];
        for (int c = 0, begin = 0; begin < n; ++c, begin += chunk) {
            const int count = std::min(chunk, n - begin);
            const Stencil<D> s(fine, number, c);
            const float *b = fine.b.data() + o + begin, *x = fine.x.data() + o + begin;
            if (count == chunk)
                residual_chunk<D, true>(s, b, x, stride, count, r);
            else
                residual_chunk<D, false>(s, b, x, stride, count, r);
            r[count] = 0;
            if (in_pairs)
                for (int i = 0; i < (count + 1) / 2; ++i)
                    to[begin / 2 + i] += r[2 * i] + r[2 * i + 1];
            else
                for (int i = 0; i < count; ++i)
                    to[parents[fine.low[0] + begin + i] - first_parent] += r[i];
        }
    });
}

template <int D>
void prolong_plane(const Level<D>& coarse, Level<D>& fine, int plane)
{
    const int n = fine.high[0] - fine.low[0];
    const std::vector<int>& parents = fine.parent[0]; // along the first axis
    const int first_parent = parents[fine.low[0]];
    const bool in_pairs = fine.in_pairs(0);
    Index<D> low = fine.low, high = fine.high;
    low[D - 1] = plane;
    high[D - 1] = plane + 1;
    for_each_row<D>(low, high, [&](const Index<D>& row) {
        Index<D> parent;
        for (int axis = 0; axis < D; ++axis)
            parent[axis] = fine.parent[axis][row[axis]];
        const float* from = coarse.x.data() + coarse.block.offset(parent);
        const long number = fine.row_number(row);
        float* to = fine.x.data() + fine.block.offset(row);
        for (int c = 0, begin = 0; begin < n; ++c, begin += chunk) {
            const float* inverse = fine.inverse_diagonal(number, c);
            const int count = std::min(chunk, n - begin);
            float doubled[chunk + 1]; // interleaved first: the sum itself then vectorises
            if (in_pairs)
                for (int i = 0; i < (count + 1) / 2; ++i)
                    doubled[2 * i] = doubled[2 * i + 1] = from[begin / 2 + i];
            else
                for (int i = 0; i < count; ++i)
                    doubled[i] = from[parents[fine.low[0] + begin + i] - first_parent];
            for (int i = 0; i < count; ++i)
                to[begin + i] += inverse[i] > 0.0f ? doubled[i] : 0.0f;
        }
    });
}

template void restrict_plane<2>(const Level<2>&, Level<2>&, int);
template void restrict_plane<3>(const Level<3>&, Level<3>&, int);
template void prolong_plane<2>(const Level<2>&, Level<2>&, int);
template void prolong_plane<3>(const Level<3>&, Level<3>&, int);

} // namespace gapflow
