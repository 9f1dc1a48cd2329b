#include "gapflow/grid/grid.hpp"

#include "gapflow/core/error.hpp"

#include <algorithm>
#include <string>

namespace gapflow {

namespace {

// Where `parts` ranks start along an axis of n cells: multiples of the largest power of two that leaves each rank some
// cells, so that multigrid can halve the blocks.
std::vector<int> starts(int n, int parts)
{
    int unit = 64;
    while (unit > 1 && n / unit < parts)
        unit /= 2;
    std::vector<int> start(parts + 1);
    const int units = n / unit;
    for (int p = 0; p < parts; ++p)
        start[p] = static_cast<int>(static_cast<long>(units) * p / parts) * unit;
    start[parts] = n;
    return start;
}

// Ranks along each axis: of all factorisations the one with the smallest surface between blocks.
template <int D>
Index<D> rank_layout(int ranks, const Index<D>& cells)
{
    Index<D> best = Index<D>::Ones();
    double best_surface = -1;
    auto consider = [&](const Index<D>& p) {
        if ((p.array() > cells.array()).any())
            return;
        double surface = 0;
        for (int axis = 0; axis < D; ++axis) {
            double area = p[axis] - 1;
            for (int other = 0; other < D; ++other)
                area *= other == axis ? 1.0 : cells[other];
            surface += area;
        }
        if (best_surface < 0 || surface < best_surface) {
            best_surface = surface;
            best = p;
        }
    };
    for (int last = 1; last <= ranks; ++last) { // prefer to cut the slowest axis
        if (ranks % last)
            continue;
        if constexpr (D == 2) {
            consider(Index<2>(ranks / last, last));
        } else {
            for (int middle = 1; middle <= ranks / last; ++middle)
                if ((ranks / last) % middle == 0)
                    consider(Index<3>(ranks / last / middle, middle, last));
        }
    }
    if (best_surface < 0)
        throw InputError("the grid has too few cells to be shared out over " + std::to_string(ranks) +
                         " ranks; use fewer ranks or more cells");
    return best;
}

} // namespace

template <int D>
Grid<D>::Grid(const Vec<D>& origin, double dx, const Index<D>& cells, const std::array<SideKind, 2 * D>& sides, int ghost,
              const Communicator& comm)
    : origin_(origin), dx_(dx), cells_(cells), sides_(sides), ghost_(ghost), comm_(comm)
{
    const Index<D> layout = rank_layout<D>(comm.size(), cells);
    std::array<std::vector<PetscInt>, D> counts;
    for (int axis = 0; axis < D; ++axis) {
        partition_[axis] = starts(cells[axis], layout[axis]);
        for (int p = 0; p < layout[axis]; ++p)
            counts[axis].push_back(partition_[axis][p + 1] - partition_[axis][p]);
        if (layout[axis] > 1 && *std::min_element(counts[axis].begin(), counts[axis].end()) < ghost)
            throw InputError("the grid has too few cells to be shared out over " + std::to_string(comm.size()) +
                             " ranks; use fewer ranks or more cells");
    }
    auto boundary = [&](int axis) { return periodic(axis) ? DM_BOUNDARY_PERIODIC : DM_BOUNDARY_NONE; };
    DM dm = nullptr;
    if constexpr (D == 2)
        DMDACreate2d(comm.mpi(), boundary(0), boundary(1), DMDA_STENCIL_BOX, cells[0], cells[1], layout[0], layout[1], 1, 1,
                     counts[0].data(), counts[1].data(), &dm);
    else
        DMDACreate3d(comm.mpi(), boundary(0), boundary(1), boundary(2), DMDA_STENCIL_BOX, cells[0], cells[1], cells[2],
                     layout[0], layout[1], layout[2], 1, 1, counts[0].data(), counts[1].data(), counts[2].data(), &dm);
    DMSetUp(dm);
    dm_ = std::shared_ptr<DM>(new DM(dm), [](DM* handle) {
        DMDestroy(handle);
        delete handle;
    });
    PetscInt start[3] = {0, 0, 0}, width[3] = {1, 1, 1};
    DMDAGetCorners(dm, &start[0], &start[1], &start[2], &width[0], &width[1], &width[2]);
    Index<D> place;
    for (int axis = 0; axis < D; ++axis) {
        low_[axis] = start[axis];
        high_[axis] = start[axis] + width[axis];
        place[axis] = static_cast<int>(std::find(partition_[axis].begin(), partition_[axis].end(), low_[axis]) -
                                       partition_[axis].begin());
    }
    for (int axis = 0; axis < D; ++axis)
        for (int end = 0; end < 2; ++end) {
            Index<D> other = place;
            other[axis] += end ? 1 : -1;
            int rank = -1;
            if (periodic(axis))
                other[axis] = (other[axis] + layout[axis]) % layout[axis];
            if (other[axis] >= 0 && other[axis] < layout[axis]) {
                rank = other[D - 1];
                for (int k = D - 2; k >= 0; --k)
                    rank = rank * layout[k] + other[k];
            }
            neighbours_[2 * axis + end] = rank;
        }
}

template class Grid<2>;
template class Grid<3>;

} // namespace gapflow
