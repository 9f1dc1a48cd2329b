// The product against the assembled matrix, and the matrix' properties.
#include "gapflow/solver/assemble.hpp"
#include "unit/solver/synthetic_system.hpp"

#include <gtest/gtest.h>

namespace gapflow::test {
namespace {

template <int D>
Eigen::VectorXd packed(const TestSystem<D>& test, const UnknownVector<D>& v)
{
    const Numbering<D> numbering = number_unknowns(test.system);
    Eigen::VectorXd values(numbering.total);
    values.head(test.system.nodes) = v.nodes;
    for_each_index<D>(test.grid->low(), test.grid->high(), [&](const Index<D>& c) {
        if (numbering.cell(c) >= 0)
            values[numbering.cell(c)] = v.cells(c);
    });
    return values;
}

template <int D>
void compare_with_dense(const TestScene<D>& scene)
{
    if (Communicator().size() > 1)
        GTEST_SKIP();
    const auto test = build(scene);
    const Eigen::MatrixXd matrix = assemble_dense(test->system);
    const double largest = matrix.diagonal().maxCoeff();
    EXPECT_LE((matrix - matrix.transpose()).cwiseAbs().maxCoeff(), 1e-14 * largest);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(matrix, Eigen::EigenvaluesOnly);
    EXPECT_GE(eigen.eigenvalues()[0], -1e-13 * largest);
    const long null = test->system.null_space.cols();
    EXPECT_LE(null == 0 ? 0 : eigen.eigenvalues()[null - 1], 1e-13 * largest);
    EXPECT_GT(eigen.eigenvalues()[null], 1e-12 * largest) << "more null vectors than told";

    UnknownVector<D> p = sample(*test, 1.0), y = zeros(*test);
    apply(test->system, p, y);
    const Eigen::VectorXd expected = matrix * packed(*test, p);
    EXPECT_LE((packed(*test, y) - expected).norm(), 1e-14 * largest * packed(*test, p).norm());
}

TEST(Operator, EqualsTheDenseMatrix2D)
{
    for (SideKind kind : {SideKind::wall, SideKind::open, SideKind::periodic})
        for (double film : {1e-3, 1.0, 1e3})
            compare_with_dense(film_scene<2>(32, film, 1.0, 0.5, kind));
    compare_with_dense(chamber_scene<2>(24, 1.0, 1.0, 0.5));
}

TEST(Operator, EqualsTheDenseMatrix3D)
{
    for (SideKind kind : {SideKind::wall, SideKind::open, SideKind::periodic})
        compare_with_dense(two_bodies<3>(10, 0.5, kind));
    compare_with_dense(chamber_scene<3>(8, 1.0, 1.0, 0.5));
}

// Two cells beside each other between walls, one film node on a link, by hand.
TEST(Operator, HandValues)
{
    if (Communicator().size() > 1)
        GTEST_SKIP();
    const Grid<2> grid(Vec<2>::Zero(), 0.5, Index<2>(2, 1), {SideKind::wall, SideKind::open, SideKind::wall, SideKind::wall}, 1,
                       Communicator());
    CoupledSystem<2> system;
    system.grid = &grid;
    system.conductance = FaceField<2>(grid);
    system.conductance(0, Index<2>(1, 0)) = 3;
    system.conductance(0, Index<2>(2, 0)) = 2; // to the open side
    system.nodes = 1;
    system.film.resize(1, 1);
    system.links = {{5, {{0, 1.0}}, {{0, -0.75}, {1, -0.25}}}};
    system.bodies = 1;
    system.mass.resize(3, 3);
    for (int d = 0; d < 3; ++d)
        system.mass.insert(d, d) = 2;
    system.cell_flux = {{Index<2>(1, 0), 0, Twist<2>(0.5, 0, 0)}};
    system.node_flux = {{0, 0, Twist<2>(-0.5, 0, 0)}};
    system.components = {{true, 3}};
    system.component = CellField<2, int>(grid, 0);
    system.node_component = {0};
    system.null_space.resize(1, 0);
    UnknownVector<2> p{CellField<2>(grid), Eigen::VectorXd::Constant(1, 2.0)}, y = p;
    p.cells(Index<2>(0, 0)) = 1;
    p.cells(Index<2>(1, 0)) = 4;
    // Link: s = 2 - 0.75 - 1 = 0.25, flux 1.25. Wrench 0.5 (4 - 2) = 1, twist 0.5.
    apply(system, p, y);
    EXPECT_DOUBLE_EQ(y.cells(Index<2>(0, 0)), 3 * (1 - 4) - 0.75 * 1.25);
    EXPECT_DOUBLE_EQ(y.cells(Index<2>(1, 0)), 3 * (4 - 1) + 2 * 4 - 0.25 * 1.25 + 0.5 * 0.5);
    EXPECT_DOUBLE_EQ(y.nodes[0], 1.25 - 0.5 * 0.5);
    EXPECT_DOUBLE_EQ(wrenches(system, p)[0], 1.0);
    const CoupledSolver<2> solver(system, {});
    UnknownVector<2> solution{CellField<2>(grid), Eigen::VectorXd::Zero(1)};
    EXPECT_TRUE(solver.solve(solution, y).converged);
    EXPECT_NEAR(solution.cells(Index<2>(0, 0)), 1, 1e-6);
    EXPECT_NEAR(solution.nodes[0], 2, 1e-6);
}

} // namespace
} // namespace gapflow::test
