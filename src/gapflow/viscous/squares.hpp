// A quadratic form as a sum of weighted squares of rows, E(x) = 1/2 sum_k w_k (r_k x)^2, never assembled: positive semidefinite where no weight is negative.
#pragma once

#include <Eigen/Sparse>

#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

namespace gapflow {

struct Term {
    std::int32_t column;
    double factor;
};

/// A linear function of the columns. One column may come more than once.
class Row {
public:
    std::span<const Term> terms() const { return terms_; }
    bool empty() const { return terms_.empty(); }
    void add(std::int32_t column, double factor) { terms_.push_back({column, factor}); }
    void add(const Row& row, double factor)
    {
        for (const Term& term : row.terms_)
            terms_.push_back({term.column, factor * term.factor});
    }
    /// Columns ascending, each once.
    void merge();

private:
    std::vector<Term> terms_;
};

/// The rows, one after the other, in flat arrays.
struct SquareSum {
    std::vector<double> weight;
    std::vector<std::int64_t> end{0}; ///< of each row's terms, after a 0
    std::vector<std::int32_t> column;
    std::vector<double> factor;

    std::int64_t rows() const { return static_cast<std::int64_t>(weight.size()); }
    /// Rows of weight 0 or without terms are left out.
    void add(double weight, Row row);
    /// A row of columns that differ.
    void add(double weight, std::initializer_list<Term> terms);
    /// The same of columns with their factors, those of 0 left out.
    void add(double weight, std::span<const std::int32_t> columns, std::span<const double> factors);
    /// y += sum w r^T (r x), the gradient of E.
    void add_product(std::span<const double> x, std::span<double> y) const { add_product(x, y, 0, rows()); }
    /// The same of the rows from `first` until `last`.
    void add_product(std::span<const double> x, std::span<double> y, std::int64_t first, std::int64_t last) const;
    /// 2 E.
    double twice(std::span<const double> x) const;
    /// Its matrix, for solvers and preconditioners; no weight is negative.
    Eigen::SparseMatrix<double> assembled(int columns) const;
};

} // namespace gapflow
