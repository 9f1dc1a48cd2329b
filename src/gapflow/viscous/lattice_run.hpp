// Products of runs of the compact lattice.
#pragma once

#include <array>
#include <cstdint>

namespace gapflow {

/// y += weight A x of a run: each place resists to its difference from each of 2 D beside it.
template <int D, class Run>
void add_run(const Run& run, double weight, const double* x, double* y)
{
    const double* here = x + run.first;
    double* by = y + run.first;
    std::array<const double*, 2 * D> beside;
    for (int k = 0; k < 2 * D; ++k)
        beside[k] = x + run.beside[k];
    for (std::int32_t i = 0; i < run.length; ++i) {
        double sum = 2 * D * here[i];
        for (int k = 0; k < 2 * D; ++k)
            sum -= beside[k][i];
        by[i] += weight * sum;
    }
}

} // namespace gapflow
