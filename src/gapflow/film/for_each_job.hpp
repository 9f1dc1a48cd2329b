// Independent pieces of work on all threads of a rank. Private to film/.
#pragma once

namespace gapflow {

/// Calls f(0) .. f(n - 1), in any order, on as many threads as OpenMP provides (without OpenMP: one).
template <class F>
void for_each_job(int n, F&& f)
{
#ifdef _OPENMP
#pragma omp parallel for schedule(dynamic)
#endif
    for (int i = 0; i < n; ++i)
        f(i);
}

} // namespace gapflow
