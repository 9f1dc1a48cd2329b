// Union-find on each rank's cells; then every local part takes the lowest label among its neighbours on other ranks until
// nothing changes.

#include "gapflow/solver/grid_parts.hpp"

#include <algorithm>
#include <numeric>

namespace gapflow {

namespace {

int root(std::vector<int>& parent, int i)
{
    while (parent[i] != i)
        i = parent[i] = parent[parent[i]];
    return i;
}

/// Everything of every rank, in order of the ranks.
std::vector<long> gathered(const std::vector<long>& mine, const Communicator& comm)
{
    int count = static_cast<int>(mine.size());
    std::vector<int> counts(comm.size()), starts(comm.size(), 0);
    MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, comm.mpi());
    std::partial_sum(counts.begin(), counts.end() - 1, starts.begin() + 1);
    std::vector<long> all(starts.back() + counts.back());
    MPI_Allgatherv(mine.data(), count, MPI_LONG, all.data(), counts.data(), starts.data(), MPI_LONG, comm.mpi());
    return all;
}

} // namespace

template <int D>
GridParts<D> find_grid_parts(const CoupledSystem<D>& system)
{
    const Grid<D>& grid = *system.grid;
    const Block<D> block(grid.low(), grid.high());
    std::vector<int> parent(block.size);
    std::iota(parent.begin(), parent.end(), 0);
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
        const int i = static_cast<int>(block.offset(c));
        for (int axis = 0; axis < D; ++axis)
            if (c[axis] > grid.low()[axis] && system.conductance(axis, c) > 0)
                parent[root(parent, i)] = root(parent, i - block.stride[axis]);
    });

    // Label of a part: the lowest key of its cells.
    std::vector<long> label(block.size, -1);
    CellField<D, double> seen(grid, -1.0); // a double holds every key
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
        if (system.component(c) < 0)
            return;
        long& l = label[root(parent, static_cast<int>(block.offset(c)))];
        const long key = grid.key(c);
        l = l < 0 ? key : std::min(l, key);
    });
    for (bool changed = true; changed;) {
        for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
            seen(c) = static_cast<double>(label[root(parent, static_cast<int>(block.offset(c)))]);
        });
        exchange(grid, seen, 1);
        changed = false;
        for (int side = 0; side < 2 * D; ++side) {
            const int axis = side / 2;
            if (grid.neighbour(axis, side % 2) < 0)
                continue;
            Index<D> low = grid.low(), high = grid.high();
            (side % 2 ? low : high)[axis] = side % 2 ? high[axis] - 1 : low[axis] + 1;
            for_each_index<D>(low, high, [&](const Index<D>& c) {
                const Index<D> face = side % 2 ? Index<D>(c + step<D>(axis)) : c;
                const Index<D> other = side % 2 ? face : Index<D>(c - step<D>(axis));
                long& mine = label[root(parent, static_cast<int>(block.offset(c)))];
                const long theirs = static_cast<long>(seen(other));
                if (system.conductance(axis, face) > 0 && theirs >= 0 && theirs < mine) {
                    mine = theirs;
                    changed = true;
                }
            });
        }
        changed = grid.comm().any(changed);
    }

    // Distinct labels of this rank with size and ground, then of all.
    std::vector<long> mine;
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
        const int i = static_cast<int>(block.offset(c));
        if (parent[i] == i && system.component(c) >= 0)
            mine.push_back(label[i]);
    });
    auto sort_unique = [](std::vector<long>& v) {
        std::sort(v.begin(), v.end());
        v.erase(std::unique(v.begin(), v.end()), v.end());
    };
    sort_unique(mine);
    std::vector<long> labels = gathered(mine, grid.comm());
    sort_unique(labels);
    auto number = [&](long l) { return std::lower_bound(labels.begin(), labels.end(), l) - labels.begin(); };
    std::vector<double> told(2 * labels.size(), 0.0); // size, ground
    GridParts<D> parts{CellField<D, int>(grid, -1), {}, {}};
    std::vector<int> number_of_root(block.size, -1);
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
        if (system.component(c) < 0)
            return;
        const int r = root(parent, static_cast<int>(block.offset(c)));
        if (number_of_root[r] < 0)
            number_of_root[r] = static_cast<int>(number(label[r]));
        const int k = parts.part(c) = number_of_root[r];
        told[2 * k] += 1;
        for (int axis = 0; axis < D; ++axis) {
            if (grid.periodic(axis))
                continue;
            if (c[axis] == 0 && system.conductance(axis, c) > 0)
                told[2 * k + 1] = 1;
            if (c[axis] == grid.cells()[axis] - 1 && system.conductance(axis, c + step<D>(axis)) > 0)
                told[2 * k + 1] = 1;
        }
    });
    grid.comm().sum(told);

    std::vector<int> order(labels.size()), place(labels.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int i, int j) { return told[2 * i] > told[2 * j]; });
    for (std::size_t i = 0; i < order.size(); ++i) {
        place[order[i]] = static_cast<int>(i);
        parts.size.push_back(static_cast<long>(told[2 * order[i]]));
        parts.grounded.push_back(told[2 * order[i] + 1] > 0);
    }
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
        if (int& k = parts.part(c); k >= 0)
            k = place[k];
    });
    return parts;
}

template GridParts<2> find_grid_parts<2>(const CoupledSystem<2>&);
template GridParts<3> find_grid_parts<3>(const CoupledSystem<3>&);

} // namespace gapflow
