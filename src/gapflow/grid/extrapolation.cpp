// Layer by layer, each from the state before it (Jacobi), so that the order of faces does not matter:
//
//     layer 1:   u_f = mean over directions d with f + d, f + 2d valid of  2 u_{f+d} - u_{f+2d},
//                if there is none: mean of the valid neighbours;
//     layer k:   u_f = mean of the neighbours in layers < k.
//
// First order, second order in layer 1 (method, "The time step": the first extrapolated layer linear, further ones means).
// After one sweep over the grid only the front of the extrapolation is visited.
#include "gapflow/grid/extrapolation.hpp"

#include "gapflow/core/threads.hpp"

#include <algorithm>
#include <cassert>
#include <vector>

namespace gapflow {

namespace {

template <int D>
struct Extrapolation {
    const Grid<D>& grid;
    CellField<D>& u;
    CellField<D, std::int8_t>& valid;
    Index<D> low, end;                        // owned faces
    std::vector<std::vector<Index<D>>> holes; // owned faces that are not valid, by plane
    std::vector<Index<D>> candidates;         // owned, reached by no layer yet, beside one that is
    std::vector<double> values;

    bool owned(const Index<D>& f) const { return (f.array() >= low.array()).all() && (f.array() < end.array()).all(); }

    static constexpr std::int8_t queued = -1;

    void queue(const Index<D>& f)
    {
        if (valid(f) == 0) {
            valid(f) = queued;
            candidates.push_back(f);
        }
    }
    void queue_neighbours(const Index<D>& f)
    {
        for (int axis = 0; axis < D; ++axis)
            for (int sign = -1; sign <= 1; sign += 2)
                if (const Index<D> other = f + sign * step<D>(axis); owned(other))
                    queue(other);
    }

    // Zero beyond the domain: those faces take no part, nor are they handed to other ranks.
    void clear_outside()
    {
        const Block<D>& block = valid.block();
        for (int axis = 0; axis < D; ++axis) {
            if (grid.periodic(axis))
                continue;
            Index<D> below = block.high, above = block.low;
            below[axis] = std::min(0, block.high[axis]);
            above[axis] = std::max(low[axis], end[axis]);
            const bool first = low[axis] == 0, last = grid.high()[axis] == grid.cells()[axis];
            auto clear = [&](const Index<D>& f) { valid(f) = 0; };
            if (first)
                for_each_index<D>(block.low, below, clear);
            if (last)
                for_each_index<D>(above, block.high, clear);
        }
    }

    // Normalises `valid` and zeroes u elsewhere.
    void clear_holes()
    {
        const int n = end[0] - low[0];
        holes = each_plane(low[D - 1], end[D - 1], [&](int plane) {
            std::vector<Index<D>> of_plane;
            for_each_row_of_plane<D>(low, end, plane, [&](const Index<D>& row) {
                std::int8_t* mark = &valid(row);
                int count = 0;
                for (int i = 0; i < n; ++i) {
                    mark[i] = mark[i] != 0;
                    count += 1 - mark[i];
                }
                if (count == 0)
                    return;
                Index<D> f = row;
                for (int i = 0; i < n; ++i, ++f[0])
                    if (mark[i] == 0) {
                        u(f) = 0;
                        of_plane.push_back(f);
                    }
            });
            return of_plane;
        });
    }

    // Once the ghosts are known, too.
    void queue_first_layer()
    {
        for (const std::vector<Index<D>>& of_plane : holes)
            for (const Index<D>& f : of_plane)
                for (int axis = 0; axis < D; ++axis)
                    if (valid(f - step<D>(axis)) > 0 || valid(f + step<D>(axis)) > 0)
                        queue(f);
        holes.clear();
    }

    // Queues the owned neighbours of ghosts that another rank filled in this layer.
    void queue_beside_ghosts(int layer)
    {
        const std::int8_t filled = static_cast<std::int8_t>(layer + 1);
        for (int axis = 0; axis < D; ++axis)
            for (int side = 0; side < 2; ++side) {
                Index<D> slab_low = low, slab_high = end;
                slab_low[axis] = side == 0 ? low[axis] - 1 : end[axis];
                slab_high[axis] = slab_low[axis] + 1;
                for_each_index<D>(slab_low, slab_high, [&](const Index<D>& f) {
                    if (valid(f) == filled)
                        queue_neighbours(f);
                });
            }
    }

    double linear_or_mean(const Index<D>& f, bool linear) const
    {
        double sum = 0, line_sum = 0;
        int count = 0, lines = 0;
        for (int axis = 0; axis < D; ++axis)
            for (int sign = -1; sign <= 1; sign += 2) {
                const Index<D> d = sign * step<D>(axis);
                if (valid(f + d) <= 0)
                    continue;
                sum += u(f + d);
                ++count;
                if (linear && valid(f + 2 * d) > 0) {
                    line_sum += 2 * u(f + d) - u(f + 2 * d);
                    ++lines;
                }
            }
        return lines > 0 ? line_sum / lines : sum / count;
    }

    void fill_layer(int layer)
    {
        values.resize(candidates.size());
        for_each_part(static_cast<long>(candidates.size()), [&](long begin, long past) {
            for (long i = begin; i < past; ++i)
                values[i] = linear_or_mean(candidates[i], layer == 1);
        });
        for_each_part(static_cast<long>(candidates.size()), [&](long begin, long past) {
            for (long i = begin; i < past; ++i) {
                u(candidates[i]) = values[i];
                valid(candidates[i]) = static_cast<std::int8_t>(layer + 1);
            }
        });
    }

    void queue_next_layer(int layer)
    {
        std::vector<Index<D>> filled;
        filled.swap(candidates);
        for (const Index<D>& f : filled)
            queue_neighbours(f);
        queue_beside_ghosts(layer);
    }
};

} // namespace

template <int D>
void extrapolate(const Grid<D>& grid, FaceField<D>& u, FaceField<D, std::int8_t>& valid, int layers)
{
    assert(grid.ghost() >= 2 && layers <= 126);
    std::vector<Extrapolation<D>> fields; // of the axes, whose lists are made side by side
    for (int axis = 0; axis < D; ++axis)
        fields.push_back({grid, u[axis], valid[axis], grid.low(), owned_faces_end(grid, axis), {}, {}, {}});
    for (Extrapolation<D>& field : fields) {
        field.clear_outside();
        field.clear_holes();
        exchange(grid, field.valid, 2);
        exchange(grid, field.u, 2);
    }
    for_each_job(D, [&](int axis) { fields[axis].queue_first_layer(); });
    const auto any = [&] {
        return grid.comm().any(
            std::any_of(fields.begin(), fields.end(), [](const auto& field) { return !field.candidates.empty(); }));
    };
    for (int layer = 1; layer <= layers && any(); ++layer) {
        for (Extrapolation<D>& field : fields) {
            field.fill_layer(layer);
            exchange(grid, field.valid, 1);
            exchange(grid, field.u, 1);
        }
        for_each_job(D, [&](int axis) { fields[axis].queue_next_layer(layer); });
    }
    for (Extrapolation<D>& field : fields)
        for (const Index<D>& f : field.candidates)
            field.valid(f) = 0;
    exchange(grid, u);
    exchange(grid, valid);
}

template void extrapolate<2>(const Grid<2>&, FaceField<2>&, FaceField<2, std::int8_t>&, int);
template void extrapolate<3>(const Grid<3>&, FaceField<3>&, FaceField<3, std::int8_t>&, int);

} // namespace gapflow
