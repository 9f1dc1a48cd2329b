// Symmetric V(2,2) cycle: x <- smooth(x); x += P cycle(R (b - A x)); x <- smooth^T(x). On fewer than 64 cells the
// pseudo-inverse: the null space and the deflation of constants treat the constants of floating parts.
//
// Several ranks: every rank coarsens its own block as long as all blocks start at even cells (on graded grids: have some cells); then the right-hand side is
// gathered on every rank and the coarser levels are computed redundantly, with the same bits.

#include "gapflow/solver/multigrid.hpp"

#include "gapflow/core/decompositions.hpp"
#include "gapflow/solver/wavefront.hpp"

#include <algorithm>

namespace gapflow {

namespace {

constexpr long coarsest_cells = 64;
constexpr long gathered_cells = 20000; // smaller levels are gathered: halo exchanges would cost more than the cells

} // namespace

template <int D>
Multigrid<D>::Multigrid(const CoupledSystem<D>& system, const std::array<SharedRows<double>, D>& conductance)
    : comm_(system.grid->comm())
{
    const Grid<D>& grid = *system.grid;
    double largest = 0;
    for (const SharedRows<double>& values : conductance)
        largest = std::max(largest, values.largest());
    largest = comm_.max(largest);
    scale_ = largest > 0 ? 1 / largest : 1;
    levels_.push_back(finest_level<D>(system, conductance, scale_));
    const bool parallel = comm_.size() > 1;
    auto total = [](const Level<D>& level) { return level.cells.template cast<long>().prod(); };
    first_gathered_ = parallel ? ~std::size_t{0} : 0;
    while (total(levels_.back()) > coarsest_cells || (parallel && first_gathered_ > levels_.size())) {
        Level<D>& last = levels_.back();
        const bool gathered_already = first_gathered_ < levels_.size();
        if (gathered_already) {
            levels_.push_back(coarsened(last, grid));
            continue;
        }
        // The first gathered level is the coarsened last one, or its copy where blocks cannot be coarsened.
        const bool coarsen = can_coarsen(last);
        Level<D> next = coarsen ? coarsened(last, grid) : last;
        if (!coarsen || total(next) <= gathered_cells || !can_coarsen(next)) {
            first_gathered_ = levels_.size();
            for (int rank = 0, offset = 0; rank < comm_.size(); ++rank) {
                Index<D> low, high;
                int rest = rank;
                for (int axis = 0; axis < D; ++axis) {
                    const std::vector<int>& starts = next.partition[axis];
                    const int parts = static_cast<int>(starts.size()) - 1, place = rest % parts;
                    rest /= parts;
                    low[axis] = starts[place];
                    high[axis] = starts[place + 1];
                }
                parts_.push_back(Block<D>(low, high));
                counts_.push_back(static_cast<int>(parts_.back().size));
                starts_.push_back(offset);
                offset += counts_.back();
            }
            send_.resize(counts_[comm_.rank()]);
            take_.resize(starts_.back() + counts_.back());
            next = gathered(next, comm_);
        }
        levels_.push_back(std::move(next));
    }

    const Level<D>& coarsest = levels_.back();
    std::vector<int> number(coarsest.block.size, -1);
    for_each_index<D>(coarsest.low, coarsest.high, [&](const Index<D>& c) {
        const long i = coarsest.block.offset(c);
        if (coarsest.inverse(c) > 0) {
            number[i] = static_cast<int>(coarsest_cells_.size());
            coarsest_cells_.push_back(i);
        }
    });
    const int n = static_cast<int>(coarsest_cells_.size());
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
    for_each_index<D>(coarsest.low, coarsest.high, [&](const Index<D>& c) {
        const int row = number[coarsest.block.offset(c)];
        if (row < 0)
            return;
        for (int side = 0; side < 2 * D; ++side) {
            const int axis = side / 2;
            const Index<D> face = side % 2 ? Index<D>(c + step<D>(axis)) : c;
            const double a = coarsest.face(axis, face);
            matrix(row, row) += a;
            Index<D> other = side % 2 ? Index<D>(c + step<D>(axis)) : Index<D>(c - step<D>(axis));
            if (coarsest.periodic[axis])
                other[axis] = (other[axis] + coarsest.cells[axis]) % coarsest.cells[axis];
            if (other[axis] < 0 || other[axis] >= coarsest.cells[axis])
                continue;
            const int column = number[coarsest.block.offset(other)];
            if (column >= 0)
                matrix(row, column) -= a;
        }
    });
    coarsest_inverse_ = n > 0 ? positive_pseudo_inverse(matrix, 1e-9) : matrix;
    coarsest_b_.resize(n);
    coarsest_x_.resize(n);
}

template <int D>
void Multigrid<D>::cycle()
{
    cycle(0);
}

template <int D>
void Multigrid<D>::cycle(std::size_t number)
{
    Level<D>& level = levels_[number];
    if (number + 1 == levels_.size()) {
        solve_coarsest();
        return;
    }
    Level<D>& coarse = levels_[number + 1];
    if (coarse.cells == level.cells) { // only gathered, not coarser: nothing to smooth here
        for_each_row<D>(level.low, level.high, [&](const Index<D>& row) {
            std::copy_n(&level.b[level.block.offset(row)], level.high[0] - level.low[0], &coarse.b[coarse.block.offset(row)]);
        });
        gather_right_hand_side();
        cycle(number + 1);
        for_each_row<D>(level.low, level.high, [&](const Index<D>& row) {
            std::copy_n(&coarse.x[coarse.block.offset(row)], level.high[0] - level.low[0], &level.x[level.block.offset(row)]);
        });
        level.halo.exchange(level.x.data());
        return;
    }
    descend(level, coarse);
    if (comm_.size() > 1 && number + 1 == first_gathered_)
        gather_right_hand_side();
    cycle(number + 1);
    ascend(coarse, level);
}

template <int D>
void Multigrid<D>::gather_right_hand_side()
{
    Level<D>& level = levels_[first_gathered_];
    const Block<D>& mine = parts_[comm_.rank()];
    float* to = send_.data();
    for_each_row<D>(mine.low, mine.high, [&](const Index<D>& row) {
        to = std::copy_n(&level.b[level.block.offset(row)], mine.high[0] - mine.low[0], to);
    });
    MPI_Allgatherv(send_.data(), counts_[comm_.rank()], MPI_FLOAT, take_.data(), counts_.data(), starts_.data(), MPI_FLOAT,
                   comm_.mpi());
    const float* from = take_.data();
    for (const Block<D>& part : parts_)
        for_each_row<D>(part.low, part.high, [&](const Index<D>& row) {
            const int width = part.high[0] - part.low[0];
            std::copy_n(from, width, &level.b[level.block.offset(row)]);
            from += width;
        });
}

template <int D>
void Multigrid<D>::solve_coarsest()
{
    Level<D>& level = levels_.back();
    for (std::size_t i = 0; i < coarsest_cells_.size(); ++i)
        coarsest_b_[i] = level.b[coarsest_cells_[i]];
    coarsest_x_.noalias() = coarsest_inverse_ * coarsest_b_;
    for (std::size_t i = 0; i < coarsest_cells_.size(); ++i)
        level.x[coarsest_cells_[i]] = static_cast<float>(coarsest_x_[i]);
    level.halo.exchange(level.x.data());
}

template <int D>
long Multigrid<D>::bytes() const
{
    long sum = 0;
    for (const Level<D>& level : levels_)
        sum += level.bytes();
    return sum;
}

template class Multigrid<2>;
template class Multigrid<3>;

} // namespace gapflow
