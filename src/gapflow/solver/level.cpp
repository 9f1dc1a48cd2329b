// Rediscretised coarse operators. On a level with cells of width w (in finest cells) the conductance of a face of area A is
// A / (distance between the pressures it joins), so from one level to the next
//
//     conductance(coarse face) = sum over its fine faces conductance * (fine distance) / (coarse distance).
//
// Away from the ends the ratio is 1/2: half the Galerkin operator of piecewise constant transfer, which over-corrects and
// restores the convergence that piecewise constants alone lose (Braess, Computing 55, 1995). Beyond open sides the distance
// is half a cell's true width on every level. An odd number of cells leaves a narrower last cell.

#include "gapflow/solver/level.hpp"

#include <algorithm>

namespace gapflow {

namespace {

// Below 1: where two neighbours have one colour, simultaneous relaxation converges in energy only if 2 D / weight > A.
constexpr float seam_weight = 0.8f;

} // namespace

template <int D>
double Level<D>::distance(int axis, int i) const
{
    const int n = cells[axis];
    if (i > 0 && i < n)
        return 0.5 * (width(axis, i - 1) + width(axis, i));
    if (periodic[axis])
        return 0.5 * (width(axis, 0) + width(axis, n - 1));
    return 0.5 * width(axis, i == 0 ? 0 : n - 1);
}

template <int D>
long Level<D>::bytes() const
{
    return static_cast<long>(sizeof(float)) * block.size * (D + 3);
}

template <int D>
void allocate(Level<D>& level, const Communicator& comm)
{
    level.block = Block<D>(level.low - Index<D>::Ones(), level.high + Index<D>::Ones());
    for (auto& values : level.conductance)
        values.assign(level.block.size, 0.0f);
    level.inverse_diagonal.assign(level.block.size, 0.0f);
    level.x.assign(level.block.size, 0.0f);
    level.b.assign(level.block.size, 0.0f);
    level.halo = Halo<D, float>(level.block, level.low, level.high, level.neighbours, comm);
}

template <int D>
void finish(Level<D>& level)
{
    const Block<D>& block = level.block;
    for (int axis = 0; axis < D; ++axis)
        if (level.periodic[axis] && level.cells[axis] == 1) // the cell is its own neighbour
            std::fill(level.conductance[axis].begin(), level.conductance[axis].end(), 0.0f);
    for_each_index<D>(level.low, level.high, [&](const Index<D>& c) {
        const long i = block.offset(c);
        double diagonal = 0;
        for (int axis = 0; axis < D; ++axis)
            diagonal += static_cast<double>(level.conductance[axis][i]) + level.conductance[axis][i + block.stride[axis]];
        level.inverse_diagonal[i] = diagonal > 1e-30 ? static_cast<float>(1.0 / diagonal) : 0.0f;
    });
    const int n = level.high[0] - level.low[0];
    for (int seam = 0; seam < 2; ++seam)
        for (int parity = 0; parity < 2; ++parity) {
            auto& weight = level.weight[seam][parity];
            weight.assign(n, 0.0f);
            for (int i = 0; i < n; ++i)
                if (((level.low[0] + i) & 1) == parity)
                    weight[i] = seam || level.on_seam(0, level.low[0] + i) ? seam_weight : 1.0f;
        }
}

template <int D>
Level<D> finest_level(const CoupledSystem<D>& system, double scale)
{
    const Grid<D>& grid = *system.grid;
    Level<D> level;
    level.cells = level.finest_cells = grid.cells();
    level.low = grid.low();
    level.high = grid.high();
    level.unit = Index<D>::Ones();
    for (int axis = 0; axis < D; ++axis) {
        level.periodic[axis] = grid.periodic(axis);
        for (int end = 0; end < 2; ++end)
            level.neighbours[2 * axis + end] = grid.neighbour(axis, end);
    }
    allocate(level, grid.comm());
    for (int axis = 0; axis < D; ++axis) {
        const int width = level.high[0] - level.low[0] + (axis == 0 ? 1 : 0);
        for_each_row<D>(level.low, level.high + step<D>(axis), [&](const Index<D>& row) {
            const double* from = &system.conductance(axis, row);
            float* to = &level.conductance[axis][level.block.offset(row)];
            for (int i = 0; i < width; ++i)
                to[i] = static_cast<float>(scale * from[i]);
        });
    }
    finish(level);
    return level;
}

template <int D>
bool can_halve(const Level<D>& level, const Grid<D>& grid)
{
    for (int axis = 0; axis < D; ++axis)
        for (std::size_t p = 0; p + 1 < grid.partition()[axis].size(); ++p) {
            const int start = grid.partition()[axis][p] / level.unit[axis];
            const int next = grid.partition()[axis][p + 1] / level.unit[axis];
            if (start % 2 || (grid.partition()[axis].size() > 2 && next - start < 4))
                return false;
        }
    return true;
}

template <int D>
Level<D> coarsened(const Level<D>& fine, const Communicator& comm)
{
    Level<D> coarse;
    coarse.finest_cells = fine.finest_cells;
    coarse.periodic = fine.periodic;
    coarse.neighbours = fine.neighbours;
    Index<D> factor;
    for (int axis = 0; axis < D; ++axis) {
        factor[axis] = fine.halves(axis) ? 2 : 1;
        coarse.unit[axis] = fine.unit[axis] * factor[axis];
        coarse.cells[axis] = (fine.cells[axis] + factor[axis] - 1) / factor[axis];
        coarse.low[axis] = fine.low[axis] / factor[axis];
        coarse.high[axis] = (fine.high[axis] + factor[axis] - 1) / factor[axis];
    }
    allocate(coarse, comm);
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(coarse.low, coarse.high + step<D>(axis), [&](const Index<D>& c) {
            Index<D> first, last;
            for (int k = 0; k < D; ++k) {
                first[k] = std::min(c[k] * factor[k], fine.high[k]);
                last[k] = k == axis ? first[k] + 1 : std::min(first[k] + factor[k], fine.high[k]);
            }
            double sum = 0;
            for_each_index<D>(first, last, [&](const Index<D>& f) { sum += fine.conductance[axis][fine.block.offset(f)]; });
            coarse.conductance[axis][coarse.block.offset(c)] =
                static_cast<float>(sum * fine.distance(axis, first[axis]) / coarse.distance(axis, c[axis]));
        });
    finish(coarse);
    return coarse;
}

template <int D>
Level<D> gathered(const Level<D>& part, const Communicator& comm)
{
    Level<D> whole;
    whole.cells = part.cells;
    whole.finest_cells = part.finest_cells;
    whole.unit = part.unit;
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
        for_each_index<D>(part.low, end, [&](const Index<D>& f) {
            values[whole.block.offset(f)] = part.conductance[axis][part.block.offset(f)];
        });
        comm.sum(values);
        std::copy(values.begin(), values.end(), whole.conductance[axis].begin());
    }
    finish(whole);
    return whole;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template struct Level<D>;                                                                                                  \
    template Level<D> finest_level<D>(const CoupledSystem<D>&, double);                                                        \
    template bool can_halve<D>(const Level<D>&, const Grid<D>&);                                                               \
    template Level<D> coarsened<D>(const Level<D>&, const Communicator&);                                                      \
    template void allocate<D>(Level<D>&, const Communicator&);                                                                 \
    template void finish<D>(Level<D>&);                                                                                        \
    template Level<D> gathered<D>(const Level<D>&, const Communicator&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
