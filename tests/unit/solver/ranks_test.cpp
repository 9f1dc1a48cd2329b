// The same problem on all ranks together and on one. Run by tests/CMakeLists.txt under mpirun too.
#include "unit/solver/synthetic_system.hpp"

#include <gtest/gtest.h>

namespace gapflow::test {
namespace {

template <int D>
void compare(const TestScene<D>& scene, SolverOptions options = {})
{
    options.tolerance = 1e-10;
    const auto together = build(scene);
    const auto alone = build(scene, Communicator(MPI_COMM_SELF));
    UnknownVector<D> p = zeros(*together), p_alone = zeros(*alone);
    const SolveReport report = CoupledSolver<D>(together->system, options).solve(p, motion_outflow(*together));
    SolverOptions reference;
    reference.tolerance = 1e-12;
    const SolveReport report_alone = CoupledSolver<D>(alone->system, reference).solve(p_alone, motion_outflow(*alone));
    EXPECT_TRUE(report.converged) << report.message;
    EXPECT_TRUE(report_alone.converged) << report_alone.message;
    if (std::getenv("GAPFLOW_VERBOSE") && together->grid->comm().root())
        std::printf("%d, alone %d iterations\n", report.iterations, report_alone.iterations);
    EXPECT_LE(report.iterations, 30);
    UnknownVector<D> same = zeros(*together);
    for_each_index<D>(together->grid->low(), together->grid->high(),
                      [&](const Index<D>& c) { same.cells(c) = p_alone.cells(c); });
    same.nodes = p_alone.nodes;
    EXPECT_LT(distance(*together, p, same), 1e-7);
    // Replicated values are the same bits everywhere.
    std::vector<double> nodes(p.nodes.data(), p.nodes.data() + p.nodes.size()), root = nodes;
    together->grid->comm().broadcast(root);
    EXPECT_EQ(nodes, root);
}

TEST(Ranks, SameAsOneRank2D)
{
    for (SideKind kind : {SideKind::wall, SideKind::open, SideKind::periodic}) {
        compare(two_bodies<2>(64, 1e-2, kind));
        compare(two_bodies<2>(53, 1.0, kind));
        compare(film_scene<2>(64, 0.1, 1.0, 1.0, kind));
    }
    compare(chamber_scene<2>(64, 0.1, 1.0, 1.0));
}

TEST(Ranks, SameAsOneRank3D)
{
    for (SideKind kind : {SideKind::wall, SideKind::open, SideKind::periodic}) {
        compare(two_bodies<3>(32, 1e-2, kind));
        compare(film_scene<3>(32, 0.1, 1.0, 1.0, kind));
    }
    TestScene<3> odd(Index<3>(33, 66, 70), 1.0 / 33);
    odd.bodies = {ball<3>(Vec<3>(0.5, 0.8, 1.0), 0.3, 1.0)};
    compare(odd);
    compare(chamber_scene<3>(16, 0.1, 1.0, 1.0));
}

TEST(Ranks, LibraryBackend)
{
    SolverOptions options;
    options.backend = Backend::petsc;
    for (SideKind kind : {SideKind::wall, SideKind::open, SideKind::periodic}) {
        compare(film_scene<2>(64, 0.1, 1.0, 0.1, kind), options);
        compare(film_scene<3>(16, 0.1, 1.0, 0.1, kind), options);
    }
    compare(chamber_scene<3>(16, 0.1, 1.0, 1.0), options);
}

} // namespace
} // namespace gapflow::test
