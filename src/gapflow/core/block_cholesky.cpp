// Row by row (up-looking; Davis, Direct Methods for Sparse Linear Systems, 2006, chapter 4) on the graph of the blocks, in an order of approximate
// minimum degree. Row k of L has the blocks i on the elimination tree's paths from the columns of A's row k to k:
//
//     L_ki = (A_ki - sum over j < i of L_kj L_ij^T) L_ii^-T,     L_kk L_kk^T = A_kk - sum over i of L_ki L_ki^T
#include "gapflow/core/block_cholesky.hpp"

#include <Eigen/Dense>
#include <Eigen/OrderingMethods>

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace gapflow {

namespace {

template <int B>
class Factor final : public BlockCholesky {
    using Block = Eigen::Matrix<double, B, B>;

public:
    explicit Factor(const Eigen::SparseMatrix<double>& matrix) : count_(static_cast<int>(matrix.rows() / B))
    {
        number(matrix);
        read_lower(matrix);
        analyse();
    }

    bool factorise()
    {
        std::vector<int> filled(begin_.begin(), begin_.end() - 1);
        std::vector<Block> row(count_, Block::Zero()); // of L, times what is still to come
        std::vector<int> pattern, mark(count_, -1);
        for (int k = 0; k < count_; ++k) {
            Block diagonal = diagonal_[k];
            reach(k, mark, pattern);
            for (int n = row_begin_[k]; n < row_begin_[k + 1]; ++n)
                row[column_[n]] = entry_[n];
            for (const int i : pattern) {
                const Block L = row[i] * inverse_[i].transpose();
                row[i].setZero();
                for (int n = begin_[i]; n < filled[i]; ++n)
                    row[rows_[n]].noalias() -= L * lower_[n].transpose();
                diagonal.noalias() -= L * L.transpose();
                rows_[filled[i]] = k;
                lower_[filled[i]++] = L;
            }
            const Eigen::LLT<Block> factor(diagonal);
            if (factor.info() != Eigen::Success || !(factor.matrixLLT().diagonal().minCoeff() > 0))
                return false;
            inverse_[k].setIdentity();
            factor.matrixL().solveInPlace(inverse_[k]);
        }
        entry_ = {};
        diagonal_ = {};
        return true;
    }

    Eigen::VectorXd solve(const Eigen::VectorXd& b) const override
    {
        Eigen::VectorXd x(b.size());
        solve<1>(b, x);
        return x;
    }

    Eigen::MatrixXd solve_columns(const Eigen::MatrixXd& b) const override
    {
        Eigen::MatrixXd x(b.rows(), b.cols());
        for (long k = 0; k < b.cols(); k += wide) {
            const long columns = std::min<long>(wide, b.cols() - k);
            solve<wide>(b.middleCols(k, columns), x.middleCols(k, columns));
        }
        return x;
    }

private:
    static constexpr int wide = 8; ///< columns at a time: a row of them is one operation of the processor, or a few

    /// At most W columns.
    template <int W, class From, class To>
    void solve(const From& b, To&& result) const
    {
        using Parts = Eigen::Matrix<double, B, W, W == 1 ? Eigen::ColMajor : Eigen::RowMajor>;
        std::vector<Parts> x(count_, Parts::Zero());
        for (int i = 0; i < count_; ++i)
            x[place_[i]].leftCols(b.cols()) = b.template middleRows<B>(B * i);
        for (int k = 0; k < count_; ++k) {
            x[k] = (inverse_[k].template triangularView<Eigen::Lower>() * x[k]).eval();
            for (int n = begin_[k]; n < begin_[k + 1]; ++n)
                x[rows_[n]].noalias() -= lower_[n] * x[k];
        }
        for (int k = count_ - 1; k >= 0; --k) {
            Parts sum = x[k];
            for (int n = begin_[k]; n < begin_[k + 1]; ++n)
                sum.noalias() -= lower_[n].transpose() * x[rows_[n]];
            x[k] = inverse_[k].transpose().template triangularView<Eigen::Upper>() * sum;
        }
        for (int i = 0; i < count_; ++i)
            result.template middleRows<B>(B * i) = x[place_[i]].leftCols(b.cols());
    }

    // Places of the blocks in the order of elimination.
    void number(const Eigen::SparseMatrix<double>& matrix)
    {
        std::vector<Eigen::Triplet<double>> joined;
        std::vector<int> last(count_, -1); // column in which a row's block was met last
        for (int j = 0; j < count_; ++j)
            for (int c = B * j; c < B * (j + 1); ++c)
                for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, c); entry; ++entry)
                    if (int& met = last[entry.row() / B]; met != j) {
                        met = j;
                        joined.emplace_back(static_cast<int>(entry.row() / B), j, 1.0);
                    }
        Eigen::SparseMatrix<double> graph(count_, count_);
        graph.setFromTriplets(joined.begin(), joined.end());
        Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
        Eigen::AMDOrdering<int>()(graph.selfadjointView<Eigen::Lower>(), order);
        place_.resize(count_);
        for (int k = 0; k < count_; ++k)
            place_[order.indices()[k]] = k;
    }

    // The blocks below the diagonal, by rows, and those on it.
    void read_lower(const Eigen::SparseMatrix<double>& matrix)
    {
        diagonal_.assign(count_, Block::Zero());
        std::vector<std::vector<int>> of_row(count_); // block columns
        const auto for_each_entry = [&](auto&& f) {
            for (int c = 0; c < matrix.outerSize(); ++c)
                for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, c); entry; ++entry)
                    f(place_[entry.row() / B], place_[c / B], static_cast<int>(entry.row() % B), c % B, entry.value());
        };
        for_each_entry([&](int i, int j, int, int, double) {
            if (i > j && (of_row[i].empty() || of_row[i].back() != j))
                of_row[i].push_back(j);
        });
        row_begin_.assign(1, 0);
        for (std::vector<int>& columns : of_row) {
            std::sort(columns.begin(), columns.end());
            columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
            column_.insert(column_.end(), columns.begin(), columns.end());
            row_begin_.push_back(static_cast<int>(column_.size()));
        }
        entry_.assign(column_.size(), Block::Zero());
        for_each_entry([&](int i, int j, int r, int c, double value) {
            if (i == j)
                diagonal_[i](r, c) = value;
            else if (i > j)
                entry_[std::lower_bound(column_.begin() + row_begin_[i], column_.begin() + row_begin_[i + 1], j) -
                       column_.begin()](r, c) = value;
        });
    }

    // The elimination tree, and room for the columns of L.
    void analyse()
    {
        parent_.assign(count_, -1);
        std::vector<int> ancestor(count_, -1);
        for (int k = 0; k < count_; ++k)
            for (int n = row_begin_[k]; n < row_begin_[k + 1]; ++n)
                for (int i = column_[n]; i >= 0 && i < k;) {
                    const int next = ancestor[i];
                    ancestor[i] = k;
                    if (next < 0)
                        parent_[i] = k;
                    i = next;
                }
        std::vector<int> mark(count_, -1), pattern, size(count_, 0);
        for (int k = 0; k < count_; ++k) {
            reach(k, mark, pattern);
            for (const int i : pattern)
                ++size[i];
        }
        begin_.assign(1, 0);
        for (const int n : size)
            begin_.push_back(begin_.back() + n);
        rows_.resize(begin_.back());
        lower_.resize(begin_.back());
        inverse_.resize(count_);
    }

    // Columns of the blocks in row k of L, each after those that it depends on: their numbers rise towards the root. `mark`: of rows before.
    void reach(int k, std::vector<int>& mark, std::vector<int>& pattern) const
    {
        pattern.clear();
        mark[k] = k;
        for (int n = row_begin_[k]; n < row_begin_[k + 1]; ++n)
            for (int i = column_[n]; mark[i] != k; i = parent_[i]) {
                mark[i] = k;
                pattern.push_back(i);
            }
        std::sort(pattern.begin(), pattern.end());
    }

    int count_;
    std::vector<int> place_, parent_;
    std::vector<int> row_begin_, column_; ///< the blocks of A below the diagonal, row by row
    std::vector<Block> entry_, diagonal_;
    std::vector<int> begin_, rows_;      ///< the blocks of L below the diagonal, column by column
    std::vector<Block> lower_, inverse_; ///< those, and L_kk^-1
};

template <int B>
std::unique_ptr<const BlockCholesky> factor_of(const Eigen::SparseMatrix<double>& matrix)
{
    auto factor = std::make_unique<Factor<B>>(matrix);
    if (!factor->factorise())
        return nullptr;
    return factor;
}

} // namespace

std::unique_ptr<const BlockCholesky> BlockCholesky::of(const Eigen::SparseMatrix<double>& matrix, int block)
{
    if (matrix.rows() % block != 0)
        throw std::logic_error("the matrix has no whole number of blocks");
    return block == 6 ? factor_of<6>(matrix) : block == 3 ? factor_of<3>(matrix) : factor_of<1>(matrix);
}

} // namespace gapflow
