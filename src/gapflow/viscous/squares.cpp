#include "gapflow/viscous/squares.hpp"

#include "gapflow/viscous/merge_terms.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gapflow {

void merge(std::vector<Term>& terms)
{
    std::sort(terms.begin(), terms.end(), [](const Term& a, const Term& b) { return a.column < b.column; });
    std::size_t n = 0;
    for (const Term& term : terms)
        if (n > 0 && terms[n - 1].column == term.column)
            terms[n - 1].factor += term.factor;
        else
            terms[n++] = term;
    terms.resize(n);
}

void Row::merge()
{
    gapflow::merge(terms_);
}

void SquareSum::add(double row_weight, Row row)
{
    row.merge();
    if (row_weight == 0 || row.empty())
        return;
    for (const Term& term : row.terms()) {
        column.push_back(term.column);
        factor.push_back(term.factor);
    }
    weight.push_back(row_weight);
    end.push_back(static_cast<std::int64_t>(column.size()));
}

void SquareSum::add(double row_weight, std::initializer_list<Term> terms)
{
    for (const Term& term : terms) {
        column.push_back(term.column);
        factor.push_back(term.factor);
    }
    weight.push_back(row_weight);
    end.push_back(static_cast<std::int64_t>(column.size()));
}

void SquareSum::add(double row_weight, std::span<const std::int32_t> columns, std::span<const double> factors)
{
    if (row_weight == 0)
        return;
    const std::size_t before = column.size();
    for (std::size_t k = 0; k < columns.size(); ++k)
        if (factors[k] != 0) {
            column.push_back(columns[k]);
            factor.push_back(factors[k]);
        }
    if (column.size() == before)
        return;
    weight.push_back(row_weight);
    end.push_back(static_cast<std::int64_t>(column.size()));
}

void SquareSum::add_product(std::span<const double> x, std::span<double> y, std::int64_t first, std::int64_t last) const
{
    for (std::int64_t k = first; k < last; ++k) {
        double value = 0;
        for (std::int64_t t = end[k]; t < end[k + 1]; ++t)
            value += factor[t] * x[column[t]];
        value *= weight[k];
        for (std::int64_t t = end[k]; t < end[k + 1]; ++t)
            y[column[t]] += factor[t] * value;
    }
}

double SquareSum::twice(std::span<const double> x) const
{
    double sum = 0;
    for (std::int64_t k = 0; k < rows(); ++k) {
        double value = 0;
        for (std::int64_t t = end[k]; t < end[k + 1]; ++t)
            value += factor[t] * x[column[t]];
        sum += weight[k] * value * value;
    }
    return sum;
}

Eigen::SparseMatrix<double> SquareSum::assembled(int columns) const
{
    // B^T W B by Eigen's product: rows of B scaled by the roots of their weights.
    Eigen::SparseMatrix<double, Eigen::RowMajor> B(static_cast<int>(rows()), columns);
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(column.size());
    for (std::int64_t k = 0; k < rows(); ++k)
        for (std::int64_t t = end[k]; t < end[k + 1]; ++t)
            entries.emplace_back(static_cast<int>(k), column[t], std::sqrt(weight[k]) * factor[t]);
    B.setFromTriplets(entries.begin(), entries.end());
    return Eigen::SparseMatrix<double>(B.transpose()) * Eigen::SparseMatrix<double>(B);
}

} // namespace gapflow
