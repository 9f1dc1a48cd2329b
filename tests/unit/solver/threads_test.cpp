// Results do not depend on the number of threads but for round-off: the order of sweeps and sums is the same, but how a sum is
// vectorised follows from where its values lie in memory, on one thread too.
#include "gapflow/core/threads.hpp"
#include "gapflow/solver/row_runs.hpp"
#include "unit/solver/synthetic_system.hpp"

#include <gtest/gtest.h>

namespace gapflow::test {
namespace {

#ifdef _OPENMP

template <int D>
UnknownVector<D> solved(const TestSystem<D>& test, int threads)
{
    const int before = thread_count();
    omp_set_num_threads(threads);
    UnknownVector<D> p = zeros(test);
    const SolveReport report = CoupledSolver<D>(test.system, {}).solve(p, motion_outflow(test));
    omp_set_num_threads(before);
    EXPECT_TRUE(report.converged) << report.message;
    return p;
}

template <int D>
void compare(const TestScene<D>& scene)
{
    const auto test = build(scene);
    const UnknownVector<D> one = solved(*test, 1);
    for (int threads : {2, 3, 5}) {
        const UnknownVector<D> several = solved(*test, threads);
        EXPECT_LT(distance(*test, several, one), 1e-11)
            << threads; // a thousandth of the tolerance: iterations pass round-off on
    }
}

TEST(Threads, SameResult)
{
    for (SideKind kind : {SideKind::wall, SideKind::periodic}) {
        compare(two_bodies<3>(48, 1.0, kind));
        compare(film_scene<2>(192, 0.1, 1.0, 1.0, kind));
    }
}

// Rows that come again are added to in the order of the list, whatever thread has them.
TEST(Threads, RowsThatComeAgain)
{
    const std::vector<int> rows{3, 3, 1, 2, 2, 3, 0, 1, 1, 1, 1, 1, 1, 1, 4, 0};
    const auto row = [&](long i) { return rows[i]; };
    const RowRuns runs(static_cast<long>(rows.size()), 5, row);
    std::vector<std::vector<long>> expected(5);
    for (long i = 0; i < static_cast<long>(rows.size()); ++i)
        expected[rows[i]].push_back(i);
    const int before = thread_count();
    for (int threads : {1, 2, 3, 16}) {
        omp_set_num_threads(threads);
        std::vector<std::vector<long>> found(5);
        runs.for_each(row, [&](long i) { found[rows[i]].push_back(i); });
        EXPECT_EQ(found, expected) << threads;
        RowRuns().for_each(row, [&](long) { ADD_FAILURE(); });
    }
    omp_set_num_threads(before);
}

#endif

} // namespace
} // namespace gapflow::test
