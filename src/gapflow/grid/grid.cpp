#include "gapflow/grid/grid.hpp"

#include "gapflow/core/error.hpp"

#include <algorithm>
#include <limits>
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
              const Communicator& comm, const Grading<D>& grading)
    : origin_(origin), anchor_(origin), dx_(dx), graded_(!grading.empty()), margin_(ghost + 2), cells_(cells), sides_(sides),
      ghost_(ghost), comm_(comm)
{
    set_axes(grading);
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

template <int D>
void Grid<D>::set_axes(const Grading<D>& grading)
{
    auto axes = std::make_shared<Axes>();
    for (int axis = 0; axis < D; ++axis) {
        const std::vector<double>&below = grading.below[axis], &above = grading.above[axis];
        const int n = cells_[axis], low = static_cast<int>(below.size()), high = n - static_cast<int>(above.size());
        core_low_[axis] = graded_ ? low : std::numeric_limits<int>::min();
        core_high_[axis] = graded_ ? high : std::numeric_limits<int>::max();
        std::vector<double>&width = axes->width[axis], &spread = axes->spread[axis], &place = axes->place[axis];
        width.assign(n + 2 * margin_ + 1, 1.0);
        spread = place = width;
        for (int i = -margin_; i <= n + margin_; ++i) {
            const int inside = std::clamp(i, 0, n - 1);
            width[i + margin_] = inside < low ? below[low - 1 - inside] : inside >= high ? above[inside - high] : 1.0;
        }
        for (std::size_t i = 1; i < width.size(); ++i)
            spread[i] = 0.5 * (width[i - 1] + width[i]);
        spread[0] = width[0];
        for (int i = 0; i < low; ++i)
            anchor_[axis] += dx_ * (width[i + margin_] - 1);
        const auto core_place = [&](int i) { return anchor_[axis] + dx_ * i; };
        for (int i = low; i <= high; ++i)
            place[i + margin_] = core_place(i);
        for (int i = low - 1; i >= -margin_; --i)
            place[i + margin_] = place[i + 1 + margin_] - dx_ * width[i + margin_];
        for (int i = high + 1; i <= n + margin_; ++i)
            place[i + margin_] = place[i - 1 + margin_] + dx_ * width[i - 1 + margin_];
        size_[axis] = place[n + margin_] - place[margin_];
    }
    for (const std::vector<double>& width : axes->width)
        largest_width_ = std::max(largest_width_, *std::max_element(width.begin(), width.end()));
    axes_ = unshifted_ = std::move(axes);
    unshifted_origin_ = origin_;
    unshifted_anchor_ = anchor_;
}

template <int D>
void Grid<D>::shift_to(const Vec<D>& by)
{
    origin_ = unshifted_origin_ + by;
    anchor_ = unshifted_anchor_ + by;
    auto axes = std::make_shared<Axes>(*unshifted_);
    for (int axis = 0; axis < D; ++axis)
        for (double& place : axes->place[axis])
            place += by[axis];
    axes_ = std::move(axes);
}

template <int D>
double Grid<D>::outer_place(int axis, int i) const
{
    const std::vector<double>& place = axes_->place[axis];
    const int n = cells_[axis];
    if (i < -margin_)
        return place.front() + dx_ * width(axis, 0) * (i + margin_);
    if (i > n + margin_)
        return place.back() + dx_ * width(axis, n - 1) * (i - n - margin_);
    return place[i + margin_];
}

template <int D>
int Grid<D>::outer_cell(int axis, double x) const
{
    const std::vector<double>& place = axes_->place[axis];
    const int n = cells_[axis];
    if (x < place[margin_])
        return static_cast<int>(std::floor((x - place[margin_]) / (dx_ * width(axis, 0))));
    if (x >= place[n + margin_])
        return n + static_cast<int>(std::floor((x - place[n + margin_]) / (dx_ * width(axis, n - 1))));
    const auto begin = place.begin() + margin_;
    return static_cast<int>(std::upper_bound(begin, begin + n + 1, x) - begin) - 1;
}

template <int D>
Vec<D> Grid<D>::lattice_place(unsigned faces, const Vec<D>& x) const
{
    const Index<D> c = cell_of(x);
    Vec<D> at;
    for (int k = 0; k < D; ++k) {
        const auto place = [&](int i) { return faces >> k & 1 ? face_place(k, i) : centre_place(k, i); };
        const int i = x[k] < place(c[k]) ? c[k] - 1 : c[k];
        at[k] = i + (x[k] - place(i)) / (place(i + 1) - place(i));
    }
    return at;
}

template <int D>
double Grid<D>::largest_aspect() const
{
    double widest = 0,
           narrowest = std::numeric_limits<double>::infinity(); // of different axes: the core has cells along all of them
    for (const std::vector<double>& width : axes_->width) {
        widest = std::max(widest, *std::max_element(width.begin(), width.end()));
        narrowest = std::min(narrowest, *std::min_element(width.begin(), width.end()));
    }
    return widest / narrowest;
}

template class Grid<2>;
template class Grid<3>;

} // namespace gapflow
