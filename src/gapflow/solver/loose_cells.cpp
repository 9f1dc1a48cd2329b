// Groups are joined by their faces in the order of conductances, the largest first (single linkage): a group behind narrow openings is one before
// any of these joins it to the rest.
#include "gapflow/solver/loose_cells.hpp"

#include "gapflow/core/disjoint_sets.hpp"
#include "gapflow/solver/sorted_cells.hpp"

#include <algorithm>
#include <numeric>

namespace gapflow {

namespace {

struct Face {
    int a, b; ///< cells
    double conductance;
};

// Faces between two of the cells, the best conducting first.
template <int D>
std::vector<Face> faces_between(const Grid<D>& grid, std::span<const CellTies<D>> cells)
{
    std::vector<long> keys;
    for (const CellTies<D>& cell : cells)
        keys.push_back(cell.key);
    NeighbourWalk<D> walk(grid, keys);
    std::vector<Face> faces;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const Index<D> c = grid.cell_of_key(keys[i]);
        for (int axis = 0; axis < D; ++axis)
            if (const double conductance = cells[i].faces[2 * axis + 1]; conductance > 0)
                if (const long other = walk(c, 2 * axis + 1); other >= 0)
                    faces.push_back({static_cast<int>(i), static_cast<int>(other), conductance});
    }
    std::stable_sort(faces.begin(), faces.end(), [](const Face& f, const Face& g) { return f.conductance > g.conductance; });
    return faces;
}

} // namespace

template <int D>
std::vector<char> loose_cells(const Grid<D>& grid, std::span<const CellTies<D>> cells, double least, std::size_t most)
{
    const int count = static_cast<int>(cells.size());
    DisjointSets sets(count);
    std::vector<double> diagonal(count),
        inside(count, 0.0);                       // of each group, by its root: sums over its cells, and over its own faces
    std::vector<int> next(count), size(count, 1); // the group's cells as a ring
    std::vector<char> loose(count, 0);
    std::iota(next.begin(), next.end(), 0);
    for (int i = 0; i < count; ++i)
        diagonal[i] = std::accumulate(cells[i].faces.begin(), cells[i].faces.end(), cells[i].others);
    const auto judge = [&](int root) {
        if (static_cast<std::size_t>(size[root]) > most || 2 * (diagonal[root] - 2 * inside[root]) >= least * diagonal[root])
            return;
        int i = root;
        do {
            loose[i] = 1;
            i = next[i];
        } while (i != root);
    };
    for (const Face& face : faces_between(grid, cells)) {
        const int a = sets.find(face.a), b = sets.find(face.b);
        if (a == b) {
            inside[a] += face.conductance;
            continue;
        }
        judge(a);
        judge(b);
        sets.join(a, b);
        const int root = sets.find(a), other = root == a ? b : a;
        diagonal[root] += diagonal[other];
        inside[root] += inside[other] + face.conductance;
        size[root] += size[other];
        std::swap(next[a], next[b]);
    }
    for (int i = 0; i < count; ++i)
        if (sets.find(i) == i)
            judge(i);
    return loose;
}

template std::vector<char> loose_cells(const Grid<2>&, std::span<const CellTies<2>>, double, std::size_t);
template std::vector<char> loose_cells(const Grid<3>&, std::span<const CellTies<3>>, double, std::size_t);

} // namespace gapflow
