// Symmetry and positivity of the preconditioner's parts.
#include "gapflow/solver/null_space.hpp"
#include "gapflow/solver/preconditioner.hpp"
#include "unit/solver/synthetic_system.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace gapflow::test {
namespace {

template <int D>
void check(const TestScene<D>& scene, BodyMode bodies, double tolerance = 2e-6)
{
    const auto test = build(scene);
    const CoupledOperator<D> matrix(test->system);
    Preconditioner<D> preconditioner(matrix, bodies);
    const NullSpace<D> null_space(test->system);
    for (int seed = 0; seed < 4; ++seed) {
        UnknownVector<D> x = sample(*test, 1.0, seed), y = sample(*test, 0.5, seed + 10), bx = zeros(*test), by = zeros(*test);
        remove_null(*test, x);
        remove_null(*test, y);
        preconditioner.apply(x, bx, std::sqrt(inner(*test, x, x)));
        preconditioner.apply(y, by, std::sqrt(inner(*test, y, y)));
        const double xx = inner(*test, x, bx), yy = inner(*test, y, by);
        EXPECT_GT(xx, 0);
        EXPECT_GT(yy, 0);
        EXPECT_NEAR(inner(*test, x, by), inner(*test, y, bx), tolerance * std::sqrt(xx * yy));
        UnknownVector<D> z = bx;
        null_space.project(z);
        UnknownVector<D> expected = bx;
        remove_null(*test, expected);
        EXPECT_LT(distance(*test, z, expected), 1e-12);
    }
}

TEST(Preconditioner, SymmetricAndPositiveOnTheGrid)
{
    for (SideKind kind : {SideKind::wall, SideKind::open, SideKind::periodic}) {
        for (int n : {16, 33, 50}) {
            check(two_bodies<2>(n, 1.0, kind), BodyMode::never);
            check(two_bodies<3>(n / 2, 1.0, kind), BodyMode::never);
        }
        TestScene<3> odd(Index<3>(33, 9, 21), 1.0 / 33, kind);
        check(odd, BodyMode::never);
        TestScene<2> slender(Index<2>(129, 3), 0.1, kind);
        check(slender, BodyMode::never);
    }
}

// Where iterations converge at first and stall later, few seem to be left for ever.
TEST(Preconditioner, StalledIterationsAskForTheBodies)
{
    const auto test = build(two_bodies<2>(16, 1.0, SideKind::wall)); // six degrees of freedom
    const CoupledOperator<2> matrix(test->system);
    Preconditioner<2> preconditioner(matrix, BodyMode::automatic), never(matrix, BodyMode::never);
    ASSERT_FALSE(preconditioner.corrects_bodies());
    EXPECT_FALSE(preconditioner.wants_bodies(10, 2));
    EXPECT_TRUE(preconditioner.wants_bodies(10, 20));
    EXPECT_TRUE(preconditioner.wants_bodies(60, 2));
    EXPECT_FALSE(never.wants_bodies(60, 20));
    preconditioner.add_bodies();
    EXPECT_FALSE(preconditioner.wants_bodies(60, 20));
}

TEST(Preconditioner, SymmetricAndPositiveWithFilms)
{
    for (double film : {1e-4, 1.0, 1e4})
        for (BodyMode bodies : {BodyMode::never, BodyMode::always}) {
            check(film_scene<2>(32, film, 1.0, 1.0), bodies);
            check(film_scene<3>(16, film, 1.0, 1.0), bodies);
            check(film_scene<3>(16, film, 1.0, 1.0, SideKind::open), bodies);
            check(chamber_scene<2>(32, film, 1.0, 1.0), bodies);
        }
}

TEST(Preconditioner, SymmetricAndPositiveWithBodies)
{
    for (double density : {1e-3, 1.0, 1e3})
        for (BodyMode bodies : {BodyMode::never, BodyMode::always}) {
            check(two_bodies<2>(32, density), bodies);
            check(two_bodies<3>(16, density), bodies);
        }
}

// Corrected for a basis of all motions, one after the other, it is the one that corrects for all bodies.
TEST(Preconditioner, AllMotionsAreAllBodies)
{
    for (double density : {1e-3, 1.0}) {
        const auto test = build(two_bodies<3>(16, density));
        const CoupledOperator<3> matrix(test->system);
        const int dofs = matrix.dofs();
        Preconditioner<3> all(matrix, BodyMode::always), motions(matrix, BodyMode::automatic, false);
        const Eigen::MatrixXd basis = Eigen::MatrixXd::Identity(dofs, dofs) + Eigen::MatrixXd::Constant(dofs, dofs, 0.1);
        motions.add_motions(basis.leftCols(3));
        EXPECT_FALSE(motions.corrects_bodies());
        motions.add_motions(basis);
        UnknownVector<3> x = sample(*test, 1.0, 1), a = zeros(*test), b = zeros(*test);
        remove_null(*test, x);
        all.apply(x, a, std::sqrt(inner(*test, x, x)));
        motions.apply(x, b, std::sqrt(inner(*test, x, x)));
        EXPECT_LT(distance(*test, a, b), 1e-5) << density;
    }
}

// With some motions, also where a contact holds bodies: then a motion that the contact prevents must not be corrected for, or its eigenvalue of
// the preconditioned matrix is as small as it was large.
TEST(Preconditioner, MotionsThatContactsHold)
{
    const auto test = build(film_scene<3>(16, 1.0, 1.0, 1e-2));
    CoupledSystem<3>& system = test->system;
    const int dofs = static_cast<int>(system.mass.rows());
    const auto values = [&](const CoupledOperator<3>& matrix, Preconditioner<3>& preconditioner) {
        std::pair<double, double> range{1e300, 0}; // of p.Ap over p.B^-1 p, p = B r
        for (int seed = 0; seed < 6; ++seed) {
            UnknownVector<3> r = zeros(*test), p = zeros(*test), q = zeros(*test);
            matrix.add_flux(Eigen::VectorXd::Unit(dofs, 2 * seed), r);
            preconditioner.apply(r, p, std::sqrt(inner(*test, r, r)));
            const double product = inner(*test, p, r);
            EXPECT_GT(product, 0);
            const double value = matrix.apply(p, q) / product;
            range = {std::min(range.first, value), std::max(range.second, value)};
        }
        return range;
    };
    CoupledOperator<3> matrix(system);
    Preconditioner<3> preconditioner(matrix, BodyMode::automatic, false);
    const double before = values(matrix, preconditioner).second;
    preconditioner.add_motions(Eigen::MatrixXd::Identity(dofs, dofs));
    EXPECT_GT(before, 30);
    EXPECT_LT(values(matrix, preconditioner).second, 2);
    system.contact.resize(3, dofs);
    for (int row = 0; row < 3; ++row)
        system.contact.insert(row, row) = 1;
    system.contact_resistance = Eigen::VectorXd::Constant(3, std::numeric_limits<double>::infinity());
    matrix.update_bodies();
    preconditioner.update_bodies();
    EXPECT_GT(values(matrix, preconditioner).first, 0.3);
    EXPECT_LT(values(matrix, preconditioner).second, 2);
}

// Films of very viscous fluid have an added mass of 1e10 bodies. What presses bodies against a contact that holds them must not move them all
// the same: a contact that only resists, with 1e6 times what the bodies do, gives 50 to 300 times the exact energy here.
TEST(Preconditioner, ContactsHoldBodiesAgainstFilmsOfVeryViscousFluid)
{
    const auto test = build(film_scene<2>(32, 1e-10, 1e-12, 1e-2));
    CoupledSystem<2>& system = test->system;
    const long dofs = system.mass.rows();
    Eigen::MatrixXd contact = Eigen::MatrixXd::Zero(3, dofs); // two between the boxes, one of the first with a wall
    contact.row(0).head(6) << 0.2, 1, -0.1, -0.2, -1, 0.1;
    contact.row(1).head(6) << 0.2, 1, 0.12, -0.2, -1, -0.12;
    contact.row(2).head(3) << 0.9, 0.3, 0.1;
    system.contact = contact.sparseView();
    system.contact_resistance = Eigen::VectorXd::Constant(3, std::numeric_limits<double>::infinity());
    CoupledOperator<2> matrix(system);
    Preconditioner<2> all(matrix, BodyMode::always), motions(matrix, BodyMode::automatic, false);
    motions.add_motions(Eigen::MatrixXd::Identity(dofs, dofs));
    for (Preconditioner<2>* preconditioner : {&all, &motions})
        for (int seed = 0; seed < 20; ++seed) {
            UnknownVector<2> r = motion_outflow(*test, seed), z = zeros(*test), q = zeros(*test);
            remove_null(*test, r);
            preconditioner->apply(r, z, std::sqrt(inner(*test, r, r)));
            remove_null(*test, z);
            EXPECT_NEAR(inner(*test, r, z) / matrix.apply(z, q), 1, 1e-2) << seed;
        }
}

// A film's face counts for multigrid as far as the links of the cell beside it conduct.
TEST(Preconditioner, FilmFacesConductNoMoreThanLinks)
{
    const auto test = build(film_scene<2>(32, 1.0, 1.0, 1.0));
    CoupledSystem<2>& system = test->system;
    const Index<2> linked(5, 7), alone(9, 7);
    Link link{2.0, {{0, 1.0}}, {{test->grid->key(linked), -0.5}}};
    system.links = {link, link};
    const auto added = [&](const Index<2>& cell, double conductance, bool unknown) {
        system.film_faces = {{1, cell, conductance, {false, unknown}}};
        const auto with = shared_conductances(system, true), without = shared_conductances(system);
        const long row = finest_level<2>(system, without, 1.0).row_number(cell);
        return with[1].value(row, cell[0]) - without[1].value(row, cell[0]);
    };
    EXPECT_NEAR(added(linked, 0.25, true), 0.25, 1e-14);
    EXPECT_NEAR(added(linked, 7.0, true), 2 * 2.0 * 0.25, 1e-14);
    EXPECT_NEAR(added(alone, 7.0, true), 0.0, 1e-14);
    EXPECT_NEAR(added(alone, 7.0, false), 7.0, 1e-14);
}

} // namespace
} // namespace gapflow::test
