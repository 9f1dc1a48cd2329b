// The films' matrix as edges, flux = conductance (p_i - p_j), and grounds, flux = conductance p_i.
#pragma once

#include "gapflow/coupling/system.hpp"

#include <cmath>
#include <vector>

namespace gapflow {

/// Calls f(i, j, conductance) for the edges, i < j.
template <class F>
void for_each_film_edge(const Eigen::SparseMatrix<double>& film, F&& f)
{
    for (int j = 0; j < film.outerSize(); ++j)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(film, j); entry && entry.row() < j; ++entry)
            f(static_cast<int>(entry.row()), j, -entry.value());
}

/// Every node's ground; exactly 0 where the sum of its row is round-off.
inline std::vector<double> film_grounds(const Eigen::SparseMatrix<double>& film)
{
    std::vector<double> ground(film.rows(), 0.0);
    for (int column = 0; column < film.outerSize(); ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(film, column); entry; ++entry)
            ground[entry.row()] += entry.value();
    for (int i = 0; i < film.rows(); ++i)
        if (std::abs(ground[i]) < 1e-12 * film.coeff(i, i))
            ground[i] = 0;
    return ground;
}

} // namespace gapflow
