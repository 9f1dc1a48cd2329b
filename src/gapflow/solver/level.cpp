// Rediscretised coarse operators. On a level with cells of width w (in finest cells) the conductance of a face of area A is
// A / (distance between the pressures it joins), so from one level to the next
//
//     conductance(coarse face) = sum over its fine faces conductance * (fine distance) / (coarse distance).
//
// Away from the ends the ratio is 1/2: half the Galerkin operator of piecewise constant transfer, which over-corrects and
// restores the convergence that piecewise constants alone lose (Braess, Computing 55, 1995). Beyond open sides the distance
// is half a cell's true width on every level, beyond far sides the length over which the pressure fades is added. An odd number of
// cells leaves a narrower last cell.

#include "gapflow/solver/level.hpp"

#include "gapflow/grid/far_field.hpp"
#include "gapflow/solver/merging.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace gapflow {

namespace {

// Below 1: where two neighbours have one colour, simultaneous relaxation converges in energy only if 2 D / weight > A.
constexpr float seam_weight = 0.8f;

} // namespace

template <int D>
double Level<D>::distance(int axis, int i) const
{
    const int n = cells[axis];
    const std::vector<double>& w = width[axis];
    if (i > 0 && i < n)
        return 0.5 * (w[i - 1] + w[i]);
    if (periodic[axis])
        return 0.5 * (w[0] + w[n - 1]);
    return 0.5 * w[i == 0 ? 0 : n - 1];
}

template <int D>
bool Level<D>::in_pairs(int axis) const
{
    const int first = parent[axis][low[axis]];
    for (int i = low[axis]; i < high[axis]; ++i)
        if (parent[axis][i] - first != (i - low[axis]) / 2)
            return false;
    return true;
}

template <int D>
long Level<D>::bytes() const
{
    long sum = static_cast<long>(sizeof(float)) * block.size * 2 + inverse_diagonal.bytes();
    for (const auto& values : conductance)
        sum += values.bytes();
    return sum;
}

namespace {

template <int D>
long rows_of(const Block<D>& block)
{
    return block.size / block.stride[1];
}

} // namespace

template <int D>
void allocate(Level<D>& level, const Communicator& comm)
{
    level.block = block_of_level<D>(level.low, level.high);
    const int n = level.high[0] - level.low[0];
    for (int axis = 0; axis < D; ++axis)
        level.conductance[axis] = SharedRows<float>(rows_of(level.block), n + (axis == 0 ? 1 : 0));
    level.x.assign(level.block.size, 0.0f);
    level.b.assign(level.block.size, 0.0f);
    level.halo = Halo<D, float>(level.block, level.low, level.high, level.neighbours, comm);
}

template <int D>
void finish(Level<D>& level)
{
    const int n = level.high[0] - level.low[0];
    for (int axis = 0; axis < D; ++axis)
        if (level.periodic[axis] && level.cells[axis] == 1) // the cell is its own neighbour
            level.conductance[axis] = SharedRows<float>(rows_of(level.block), n + (axis == 0 ? 1 : 0));
    level.inverse_diagonal = SharedRows<float>(rows_of(level.block), n);
    std::vector<float> inverse(n);
    // Whether all faces of a row are those of another row.
    auto same_faces = [&](long row, long other) {
        bool same = level.conductance[0].equal(row, other);
        for (int axis = 1; axis < D && same; ++axis)
            for (long next : {0L, level.row_stride(axis)})
                same = same && level.conductance[axis].equal(row + next, other + next);
        return same;
    };
    const long back = level.row_stride(D - 1);
    for_each_row<D>(level.low, level.high, [&](const Index<D>& first) {
        const long row = level.row_number(first), before = row - 1;
        const long below = first[D - 1] > level.low[D - 1] ? row - back : -1;
        if (before >= 0 && same_faces(row, before))
            return level.inverse_diagonal.share(row, before);
        if (below >= 0 && same_faces(row, below))
            return level.inverse_diagonal.share(row, below);
        for (int c = 0; c < level.inverse_diagonal.chunks(); ++c) {
            const int begin = c * SharedRows<float>::chunk, count = std::min(SharedRows<float>::chunk, n - begin);
            const Stencil<D> s(level, row, c);
            for (int i = 0; i < count; ++i) {
                double diagonal = static_cast<double>(s.a0[i]) + s.a0[i + 1];
                for (int axis = 1; axis < D; ++axis)
                    diagonal += static_cast<double>(s.below[axis - 1][i]) + s.above[axis - 1][i];
                inverse[begin + i] = diagonal > 1e-30 ? static_cast<float>(1.0 / diagonal) : 0.0f;
            }
        }
        level.inverse_diagonal.set(row, inverse.data(), before, below);
    });
    for (int seam = 0; seam < 2; ++seam)
        for (int parity = 0; parity < 2; ++parity) {
            auto& weight = level.weight[seam][parity];
            weight.assign(n, 0.0f);
            for (int i = 0; i < n; ++i)
                if (((level.low[0] + i) & 1) == parity)
                    weight[i] = seam || level.on_seam(0, level.low[0] + i) ? seam_weight : 1.0f;
        }
}

namespace {

/// Cells that links end in, sorted, with the sum of the links' conductances.
template <int D>
std::vector<std::pair<long, double>> link_conductances(const CoupledSystem<D>& system)
{
    std::vector<std::pair<long, double>> cells;
    for (const Link& link : system.links)
        for (const auto& [key, weight] : link.cells)
            cells.emplace_back(key, link.conductance * weight * weight);
    std::sort(cells.begin(), cells.end());
    std::size_t n = 0;
    for (const auto& [key, conductance] : cells)
        if (n > 0 && cells[n - 1].first == key)
            cells[n - 1].second += conductance;
        else
            cells[n++] = {key, conductance};
    cells.resize(n);
    return cells;
}

/// Conductance in multigrid of a face that a film closes. Cells and films are connected by links only: the sum of a cell's links bounds it.
/// Otherwise a pore with weak connections to the rest would appear open to all films beside it.
template <int D>
double bounded_conductance(const Grid<D>& grid, const FilmFace<D>& face, const std::vector<std::pair<long, double>>& linked)
{
    double conductance = face.conductance;
    for (int side = 0; side < 2; ++side) {
        const Index<D> c = grid.wrapped(side ? face.face : Index<D>(face.face - step<D>(face.axis)));
        if (!face.unknown[side])
            continue;
        const auto found = std::lower_bound(linked.begin(), linked.end(), std::pair<long, double>(grid.key(c), 0.0));
        const bool links = found != linked.end() && found->first == grid.key(c);
        conductance = std::min(conductance, links ? found->second : 0.0);
    }
    return conductance;
}

} // namespace

template <int D>
std::array<SharedRows<double>, D> shared_conductances(const CoupledSystem<D>& system, bool with_films)
{
    const Grid<D>& grid = *system.grid;
    Level<D> level; // for its numbering alone
    level.low = grid.low();
    level.high = grid.high();
    level.block = block_of_level<D>(level.low, level.high);
    const long back = level.row_stride(D - 1);
    std::array<SharedRows<double>, D> result;
    std::array<std::vector<std::tuple<long, int, double>>, D> added; // row, place in it, conductance
    if (with_films) {
        const std::vector<std::pair<long, double>> linked = link_conductances(system);
        for (const FilmFace<D>& face : system.film_faces)
            added[face.axis].emplace_back(level.row_number(face.face), face.face[0] - level.low[0],
                                          bounded_conductance(grid, face, linked));
    }
    std::vector<double> values;
    for (int axis = 0; axis < D; ++axis) {
        const int width = level.high[0] - level.low[0] + (axis == 0 ? 1 : 0);
        result[axis] = SharedRows<double>(rows_of(level.block), width);
        std::sort(added[axis].begin(), added[axis].end());
        auto next = added[axis].begin();
        for_each_row<D>(level.low, level.high + step<D>(axis), [&](const Index<D>& first) {
            const long row = level.row_number(first);
            const double* from = &system.conductance(axis, first);
            if (next != added[axis].end() && std::get<0>(*next) == row) {
                values.assign(from, from + width);
                for (; next != added[axis].end() && std::get<0>(*next) == row; ++next)
                    values[std::get<1>(*next)] += std::get<2>(*next);
                from = values.data();
            }
            result[axis].set(row, from, row - 1, first[D - 1] > level.low[D - 1] ? row - back : -1);
        });
    }
    return result;
}

template <int D>
Level<D> finest_level(const CoupledSystem<D>& system, const std::array<SharedRows<double>, D>& conductance, double scale)
{
    const Grid<D>& grid = *system.grid;
    Level<D> level;
    level.cells = grid.cells();
    level.graded = grid.graded();
    level.partition = grid.partition();
    level.low = grid.low();
    level.high = grid.high();
    for (int axis = 0; axis < D; ++axis) {
        const int n = grid.cells()[axis];
        level.width[axis].assign(grid.widths(axis, 0), grid.widths(axis, 0) + n);
        level.finest[axis].resize(n + 1);
        std::iota(level.finest[axis].begin(), level.finest[axis].end(), 0);
        level.periodic[axis] = grid.periodic(axis);
        for (int end = 0; end < 2; ++end)
            level.neighbours[2 * axis + end] = grid.neighbour(axis, end);
    }
    allocate(level, grid.comm());
    for (int axis = 0; axis < D; ++axis)
        level.conductance[axis] =
            conductance[axis].template mapped<float>([&](double a) { return static_cast<float>(scale * a); });
    finish(level);
    return level;
}

template <int D>
bool can_coarsen(const Level<D>& level)
{
    for (int axis = 0; axis < D; ++axis) {
        const std::vector<int>& start = level.partition[axis];
        for (std::size_t p = 0; p + 1 < start.size(); ++p)
            if ((!level.graded && start[p] % 2) || (start.size() > 2 && start[p + 1] - start[p] < 4))
                return false;
    }
    return true;
}

namespace {

// Where the cells of the next level start along every axis, in cells of this level; one more entry: their number.
template <int D>
std::array<std::vector<int>, D> starts_of_next(const Level<D>& level, double target)
{
    std::array<std::vector<int>, D> starts;
    for (int axis = 0; axis < D; ++axis) {
        const std::vector<int>& blocks = level.partition[axis];
        for (std::size_t p = 0; p + 1 < blocks.size(); ++p) {
            if (level.graded) { // never across ranks
                const std::vector<int> own = merged(level.width[axis], blocks[p], blocks[p + 1], widest_merged * target);
                starts[axis].insert(starts[axis].end(), own.begin(), own.end());
            } else {
                for (int i = blocks[p]; i < blocks[p + 1]; i += 2)
                    starts[axis].push_back(i);
            }
        }
        starts[axis].push_back(level.cells[axis]);
    }
    return starts;
}

// Cells, widths and blocks of the next level; sets fine.parent.
template <int D>
std::array<std::vector<int>, D> shape_next(Level<D>& fine, Level<D>& coarse)
{
    coarse.graded = fine.graded;
    coarse.target = fine.target;
    std::array<std::vector<int>, D> starts;
    bool fewer = false;
    while (!fewer) {
        coarse.target *= 2;
        starts = starts_of_next(fine, coarse.target);
        for (int axis = 0; axis < D; ++axis)
            fewer = fewer || static_cast<int>(starts[axis].size()) - 1 < fine.cells[axis];
    }
    for (int axis = 0; axis < D; ++axis) {
        const std::vector<int>& start = starts[axis];
        coarse.cells[axis] = static_cast<int>(start.size()) - 1;
        fine.parent[axis].resize(fine.cells[axis]);
        coarse.width[axis].assign(coarse.cells[axis], 0.0);
        coarse.finest[axis].clear();
        for (int c = 0; c < coarse.cells[axis]; ++c) {
            coarse.finest[axis].push_back(fine.finest[axis][start[c]]);
            for (int i = start[c]; i < start[c + 1]; ++i) {
                fine.parent[axis][i] = c;
                coarse.width[axis][c] += fine.width[axis][i];
            }
        }
        coarse.finest[axis].push_back(fine.finest[axis].back());
        coarse.partition[axis].clear();
        for (const int block : fine.partition[axis])
            coarse.partition[axis].push_back(block < fine.cells[axis] ? fine.parent[axis][block] : coarse.cells[axis]);
        coarse.low[axis] = fine.parent[axis][fine.low[axis]];
        coarse.high[axis] = fine.parent[axis][fine.high[axis] - 1] + 1;
    }
    return starts;
}

// How much further than to a face of a level it is to the pressure 0 beyond it, over dx: on far sides, else 0.
template <int D>
double way_beyond(const Grid<D>& grid, const FarField<D>& far, const Level<D>& level, int axis, const Index<D>& face)
{
    const bool end = face[axis] == level.cells[axis];
    if ((face[axis] != 0 && !end) || grid.side(axis, end) != SideKind::far)
        return 0;
    Vec<D> x;
    for (int k = 0; k < D; ++k) {
        const int i = std::min(face[k], level.cells[k] - 1), first = level.finest[k][i], next = level.finest[k][i + 1];
        if (grid.graded())
            x[k] = k == axis ? grid.face_place(k, end * grid.cells()[k])
                             : 0.5 * (grid.face_place(k, first) + grid.face_place(k, next));
        else
            x[k] = k == axis ? end * grid.cells()[k] : 0.5 * (first + next);
    }
    return far.pressure_length(axis, grid.graded() ? x : Vec<D>(grid.origin() + grid.dx() * x)) / grid.dx();
}

} // namespace

template <int D>
Level<D> coarsened(Level<D>& fine, const Grid<D>& grid)
{
    const FarField<D> far = far_field(grid);
    Level<D> coarse;
    const std::array<std::vector<int>, D> start = shape_next(fine, coarse);
    coarse.periodic = fine.periodic;
    coarse.neighbours = fine.neighbours;
    allocate(coarse, grid.comm());
    const long back = coarse.row_stride(D - 1);
    const int width = coarse.high[0] - coarse.low[0], fine_width = fine.high[0] - fine.low[0];
    std::vector<double> fine_sum(fine_width + 1);
    std::vector<float> row_values(width + 1);
    for (int axis = 0; axis < D; ++axis) {
        const SharedRows<float>& from = fine.conductance[axis];
        const int values = fine_width + (axis == 0 ? 1 : 0);
        for_each_row<D>(coarse.low, coarse.high + step<D>(axis), [&](const Index<D>& first) {
            Index<D> begin = first, end = first + Index<D>::Ones(); // its fine rows
            for (int k = 1; k < D; ++k) {
                begin[k] = start[k][first[k]];
                end[k] = k == axis ? begin[k] + 1 : start[k][first[k] + 1];
            }
            std::fill(fine_sum.begin(), fine_sum.end(), 0.0);
            begin[0] = fine.low[0];
            end[0] = begin[0] + 1;
            for_each_index<D>(begin, end, [&](const Index<D>& f) {
                const long row = fine.row_number(f);
                for (int c = 0; c < from.chunks(); ++c) {
                    const float* a = from(row, c);
                    double* to = &fine_sum[c * SharedRows<float>::chunk];
                    const int count = std::min(SharedRows<float>::chunk, values - c * SharedRows<float>::chunk);
                    for (int i = 0; i < count; ++i)
                        to[i] += a[i];
                }
            });
            auto ratio = [&](int fine_face, const Index<D>& coarse_face) {
                const double more = way_beyond(grid, far, coarse, axis, coarse_face);
                return (fine.distance(axis, fine_face) + more) / (coarse.distance(axis, coarse_face[axis]) + more);
            };
            Index<D> face = first;
            if (axis == 0)
                for (int i = 0; i <= width; ++i, ++face[0]) {
                    const int f = start[0][coarse.low[0] + i] - fine.low[0];
                    row_values[i] = static_cast<float>(fine_sum[f] * ratio(fine.low[0] + f, face));
                }
            else {
                const double of_row = ratio(begin[axis], first);
                const bool varies = way_beyond(grid, far, coarse, axis, first) > 0;
                for (int i = 0; i < width; ++i, ++face[0]) {
                    const int f = start[0][coarse.low[0] + i] - fine.low[0];
                    const bool pair = start[0][coarse.low[0] + i + 1] - fine.low[0] > f + 1;
                    const double sum = fine_sum[f] + (pair ? fine_sum[f + 1] : 0.0);
                    row_values[i] = static_cast<float>(sum * (varies ? ratio(begin[axis], face) : of_row));
                }
            }
            const long row = coarse.row_number(first);
            coarse.conductance[axis].set(row, row_values.data(), row - 1, first[D - 1] > coarse.low[D - 1] ? row - back : -1);
        });
    }
    finish(coarse);
    return coarse;
}

template <int D>
Level<D> gathered(const Level<D>& part, const Communicator& comm)
{
    Level<D> whole;
    whole.cells = part.cells;
    whole.graded = part.graded;
    whole.target = part.target;
    whole.width = part.width;
    whole.finest = part.finest;
    for (int axis = 0; axis < D; ++axis)
        whole.partition[axis] = {0, part.cells[axis]};
    whole.periodic = part.periodic;
    whole.low = Index<D>::Zero();
    whole.high = part.cells;
    for (int side = 0; side < 2 * D; ++side)
        whole.neighbours[side] = part.periodic[side / 2] ? comm.rank() : -1;
    allocate(whole, comm);
    std::vector<double> values(whole.block.size);
    for (int axis = 0; axis < D; ++axis) {
        std::fill(values.begin(), values.end(), 0.0);
        Index<D> end = part.high;
        if (part.high[axis] == part.cells[axis])
            ++end[axis]; // the domain's last faces
        for_each_index<D>(part.low, end, [&](const Index<D>& f) { values[whole.block.offset(f)] = part.face(axis, f); });
        comm.sum(values);
        std::vector<float> row_values(whole.conductance[axis].width());
        Index<D> rows_end = whole.high + step<D>(axis);
        for_each_row<D>(whole.low, rows_end, [&](const Index<D>& first) {
            const double* from = &values[whole.block.offset(first)];
            std::copy_n(from, row_values.size(), row_values.begin());
            whole.conductance[axis].set(whole.row_number(first), row_values.data(), whole.row_number(first) - 1, -1);
        });
    }
    finish(whole);
    return whole;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template struct Level<D>;                                                                                                  \
    template std::array<SharedRows<double>, D> shared_conductances<D>(const CoupledSystem<D>&, bool);                          \
    template Level<D> finest_level<D>(const CoupledSystem<D>&, const std::array<SharedRows<double>, D>&, double);              \
    template bool can_coarsen<D>(const Level<D>&);                                                                             \
    template Level<D> coarsened<D>(Level<D>&, const Grid<D>&);                                                                 \
    template void allocate<D>(Level<D>&, const Communicator&);                                                                 \
    template void finish<D>(Level<D>&);                                                                                        \
    template Level<D> gathered<D>(const Level<D>&, const Communicator&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
