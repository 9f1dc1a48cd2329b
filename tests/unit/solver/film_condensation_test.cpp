// Films condensed to their rims (solver/film_condensation.hpp): the same pressures and the same motion of the bodies as of the whole system.
#include "gapflow/solver/film_condensation.hpp"

#include "unit/solver/synthetic_system.hpp"

#include <gtest/gtest.h>

namespace gapflow::test {
namespace {

// Residual of the whole system at p, over |rhs|.
template <int D>
double residual(const TestSystem<D>& test, UnknownVector<D>& p, const UnknownVector<D>& rhs)
{
    UnknownVector<D> y = zeros(test);
    apply(test.system, p, y);
    const Grid<D>& grid = *test.grid;
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) { y.cells(c) -= rhs.cells(c); });
    y.nodes -= rhs.nodes;
    return std::sqrt(inner(test, y, y) / inner(test, rhs, rhs));
}

// Contacts between the boxes: the third twice, with different shares of its impulse, and one that resists.
template <int D>
void hold(CoupledSystem<D>& system)
{
    constexpr int n = twist_size<D>;
    std::vector<Eigen::Triplet<double>> entries;
    const auto row = [&](int r, const Vec<D>& normal, double place) {
        const Twist<D> a = wrench<D>(normal, Vec<D>(place * unit<D>(0) + 0.1 * unit<D>(D - 1)));
        const Twist<D> b = wrench<D>(Vec<D>(-normal), Vec<D>(place * unit<D>(0) - 0.1 * unit<D>(D - 1)));
        for (int k = 0; k < n; ++k) {
            entries.emplace_back(r, k, a[k]);
            entries.emplace_back(r, n + k, b[k]);
        }
    };
    row(0, unit<D>(0), 0.02);
    row(1, unit<D>(D - 1), 0.1);
    row(2, unit<D>(0), 0.02);
    system.contact.resize(3, n * system.bodies);
    system.contact.setFromTriplets(entries.begin(), entries.end());
    system.contact_resistance = Eigen::Vector3d(INFINITY, system.mass.coeff(0, 0), INFINITY);
    system.response = BodyResponse(system.mass, system.contact, system.contact_resistance);
}

template <int D>
void expect_the_same(double film, double density, SideKind sides, bool contacts)
{
    SCOPED_TRACE(testing::Message() << D << "D, film " << film << ", density " << density << ", contacts " << contacts);
    const auto test = build(film_scene<D>(D == 2 ? 64 : 24, film, 1.0, density, sides));
    CoupledSystem<D>& system = test->system;
    const FilmCondensation<D> condensation(system);
    ASSERT_FALSE(condensation.empty());
    EXPECT_LT(condensation.reduced().nodes, system.nodes / 2);
    SolverOptions options;
    options.tolerance = 1e-11;
    CoupledSolver<D> solver(system, options);
    if (contacts) { // after it was made
        hold(system);
        solver.update_bodies();
    }
    UnknownVector<D> rhs = motion_outflow(*test), p = zeros(*test);
    ASSERT_TRUE(solver.solve(p, rhs).converged);
    remove_null(*test, rhs);
    EXPECT_LT(residual(*test, p, rhs), 1e-10); // in 3D with heavy bodies round-off is 4e-11
    ASSERT_TRUE(solver.motion());
    const BodyResponse response(system.mass, system.contact, system.contact_resistance);
    Eigen::VectorXd impulse;
    const Eigen::VectorXd twist = response(wrenches(system, p), &impulse);
    EXPECT_LT((solver.motion()->twist - twist).norm(), 1e-10 * twist.norm());
    EXPECT_LE((solver.motion()->contact_impulse - impulse).norm(), 1e-9 * impulse.norm());
    if (contacts) {
        EXPECT_GT(impulse.norm(), 0.0);
        UnknownVector<D> again = p; // a first guess that is right
        const SolveReport report = solver.solve(again, motion_outflow(*test));
        EXPECT_LE(report.iterations, 1);
        EXPECT_LT(distance(*test, again, p), 1e-9);
    }
}

auto film_between_fixed_bodies()
{
    TestScene<2> scene = film_scene<2>(64, 1.0, 1.0, 1.0);
    for (BodyShape<2>& body : scene.bodies)
        body.fixed = true;
    return build(scene);
}

TEST(FilmCondensation, SameAsTheWholeSystem)
{
    for (bool contacts : {false, true})
        for (double density : {0.1, 1.0, 100.0}) {
            expect_the_same<2>(1.0, density, SideKind::wall, contacts);
            expect_the_same<2>(1.0, density, SideKind::open, contacts);
            expect_the_same<3>(1.0, density, SideKind::wall, contacts);
        }
    expect_the_same<3>(1e3, 1.0, SideKind::open, true);
}

// A right-hand side that changes the volume of enclosed fluid is made compatible as that of the whole system is: the pseudo-inverse is symmetric.
TEST(FilmCondensation, IncompatibleRightHandSides)
{
    const auto test = film_between_fixed_bodies();
    ASSERT_FALSE(FilmCondensation<2>(test->system).empty());
    ASSERT_EQ(test->system.null_space.cols(), 1);
    UnknownVector<2> a = sample(*test, 0.5, 1), b = sample(*test, 0.5, 2), p = zeros(*test), q = zeros(*test);
    a.nodes.array() += 1; // in the film alone
    SolverOptions options;
    options.tolerance = 1e-10;
    const CoupledSolver<2> solver(test->system, options);
    ASSERT_TRUE(solver.solve(p, a).converged);
    ASSERT_TRUE(solver.solve(q, b).converged);
    EXPECT_NEAR(inner(*test, b, p), inner(*test, a, q), 1e-8 * std::abs(inner(*test, a, p)));
}

// Against a film that weighs a million times its bodies their own mass would be lost to round-off.
TEST(FilmCondensation, HeavyFilmsStayWhole)
{
    EXPECT_FALSE(FilmCondensation<2>(build(film_scene<2>(64, 1.0, 1.0, 1.0))->system).empty());
    EXPECT_TRUE(FilmCondensation<2>(build(film_scene<2>(64, 1e-7, 1.0, 1.0))->system).empty());
    EXPECT_TRUE(FilmCondensation<2>(build(film_scene<2>(64, 1.0, 1.0, 1e-7))->system).empty());
}

// Inner nodes that hang on the others by 1e-13 of what joins them to each other: their pressure over the rim's is lost to round-off. (Between bodies that move such a
// film is heavy, too.)
TEST(FilmCondensation, FilmsNearlyCutInTwoStayWhole)
{
    const auto test = film_between_fixed_bodies();
    EXPECT_FALSE(FilmCondensation<2>(test->system).empty());
    Eigen::SparseMatrix<double>& film = test->system.film;
    for (int node : {8, 20}) { // edges to the next node
        const double change = film.coeff(node, node + 1) * (1 - 1e-13);
        film.coeffRef(node, node) += change;
        film.coeffRef(node + 1, node + 1) += change;
        film.coeffRef(node, node + 1) -= change;
        film.coeffRef(node + 1, node) -= change;
    }
    EXPECT_TRUE(FilmCondensation<2>(test->system).empty());
}

// A node taken out as a void ties its neighbours to its pressure: such a film has no level of its own.
TEST(FilmCondensation, FilmsWithVoidsStayWhole)
{
    const auto test = build(film_scene<2>(64, 1.0, 1.0, 1.0));
    test->system.film.coeffRef(5, 5) += 0.5;
    EXPECT_TRUE(FilmCondensation<2>(test->system).empty());
}

} // namespace
} // namespace gapflow::test
