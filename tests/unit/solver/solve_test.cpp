// The solver as a whole: manufactured pressures recovered, iterations bounded, over resolutions, sides, bodies, films.
#include "unit/solver/synthetic_system.hpp"

#include <gtest/gtest.h>

#include <cstdio>

namespace gapflow::test {
namespace {

struct Outcome {
    SolveReport report;
    double error = 0;
};

template <int D>
Outcome recover(const TestScene<D>& scene, SolverOptions options = {}, const char* name = nullptr)
{
    const auto test = build(scene);
    UnknownVector<D> exact = sample(*test, 0.1), rhs = zeros(*test), p = zeros(*test);
    remove_null(*test, exact);
    apply(test->system, exact, rhs);
    const CoupledSolver<D> solver(test->system, options);
    Outcome outcome;
    outcome.report = solver.solve(p, rhs);
    outcome.error = distance(*test, p, exact);
    if (name && std::getenv("GAPFLOW_VERBOSE"))
        std::printf("%-40s %3d iterations, error %.1e, set-up %.3f s, solve %.3f s, %.0f bytes a cell\n", name,
                    outcome.report.iterations, outcome.error, solver.setup_seconds(), outcome.report.seconds,
                    solver.bytes_per_cell());
    EXPECT_TRUE(outcome.report.converged) << outcome.report.message;
    return outcome;
}

template <int D>
std::string label(const char* what, double value)
{
    char text[80];
    std::snprintf(text, sizeof text, "%dD %s %g", D, what, value);
    return text;
}

TEST(Solve, IterationsDoNotGrowWithResolution)
{
    for (int n : {64, 128, 256}) {
        const Outcome o = recover(two_bodies<2>(n, 1.0), {}, label<2>("closed", n).c_str());
        EXPECT_LE(o.report.iterations, 13);
        EXPECT_LT(o.error, 1e-5);
    }
    for (int n : {32, 48, 64, 96}) {
        const Outcome o = recover(two_bodies<3>(n, 1.0), {}, label<3>("closed", n).c_str());
        EXPECT_LE(o.report.iterations, 13);
        EXPECT_LT(o.error, 1e-5);
    }
}

TEST(Solve, OpenAndPeriodicSides)
{
    for (SideKind kind : {SideKind::open, SideKind::periodic, SideKind::inflow}) {
        EXPECT_LE(recover(two_bodies<2>(64, 1.0, kind), {}, label<2>("side", int(kind)).c_str()).report.iterations, 12);
        EXPECT_LE(recover(two_bodies<3>(32, 1.0, kind), {}, label<3>("side", int(kind)).c_str()).report.iterations, 12);
    }
    TestScene<2> mixed = two_bodies<2>(63, 1.0, SideKind::periodic);
    mixed.sides[2] = SideKind::open;
    mixed.sides[3] = SideKind::wall;
    EXPECT_LE(recover(mixed, {}, "2D mixed 63").report.iterations, 13);
}

TEST(Solve, OddAndAnisotropicCells)
{
    for (SideKind kind : {SideKind::wall, SideKind::open, SideKind::periodic}) {
        TestScene<3> odd(Index<3>(33, 66, 70), 1.0 / 33, kind);
        odd.bodies = {ball<3>(Vec<3>(0.5, 0.8, 1.0), 0.3, 1.0)};
        EXPECT_LE(recover(odd, {}, "33x66x70").report.iterations, 12);
        TestScene<3> slender(Index<3>(200, 7, 3), 0.1, kind);
        slender.bodies = {ball<3>(Vec<3>(8, 0.35, 0.1), 0.17, 1.0)};
        EXPECT_LE(recover(slender, {}, "200x7x3").report.iterations, 14);
        TestScene<2> prime(Index<2>(101, 37), 0.01, kind);
        prime.bodies = {ball<2>(Vec<2>(0.5, 0.2), 0.1, 1.0)};
        EXPECT_LE(recover(prime, {}, "101x37").report.iterations, 12);
        TestScene<3> flat(Index<3>(64, 64, 1), 0.1, kind);
        flat.bodies = {ball<3>(Vec<3>(3, 3, 0.05), 1, 1.0)};
        recover(flat, {}, "64x64x1");
    }
}

TEST(Solve, DensityRatios)
{
    for (double density : {1e-7, 1e-4, 1e-3, 1e-2, 0.1, 1.0, 1e3}) {
        EXPECT_LE(recover(two_bodies<2>(64, density), {}, label<2>("density", density).c_str()).report.iterations, 14);
        EXPECT_LE(recover(two_bodies<3>(32, density), {}, label<3>("density", density).c_str()).report.iterations, 14);
    }
}

TEST(Solve, EightLightBodies)
{
    for (double density : {1e-3, 1e-1, 1.0}) {
        TestScene<3> scene(Index<3>::Constant(48), 1.0 / 48);
        for (int k = 0; k < 8; ++k)
            scene.bodies.push_back(
                ball<3>(Vec<3>(0.27 + 0.46 * (k & 1), 0.27 + 0.46 * ((k >> 1) & 1), 0.27 + 0.46 * (k >> 2)), 0.2, density));
        EXPECT_LE(recover(scene, {}, label<3>("eight", density).c_str()).report.iterations, 25);
    }
}

// The first solve of a step finds the bodies' motions that slow it down; the next ones do not have to.
TEST(Solve, SecondSolveKnowsTheSlowMotions)
{
    TestScene<3> scene(Index<3>::Constant(32), 1.0 / 32);
    for (int k = 0; k < 27; ++k) {
        const double density = k % 7 == 3 ? 0.01 * (1 + k / 7) : 10.0;
        scene.bodies.push_back(
            ball<3>(Vec<3>(0.2 + 0.3 * (k % 3), 0.2 + 0.3 * (k / 3 % 3), 0.2 + 0.3 * (k / 9)), 0.13, density));
    }
    const auto test = build(scene);
    UnknownVector<3> p = zeros(*test), other = zeros(*test), again = zeros(*test), rhs = zeros(*test),
                     exact = sample(*test, 0.1);
    const CoupledSolver<3> solver(test->system, {}), fresh(test->system, {});
    remove_null(*test, exact);
    apply(test->system, exact, rhs);
    const int first = solver.solve(p, motion_outflow(*test)).iterations, alone = fresh.solve(other, rhs).iterations;
    const SolveReport report = solver.solve(again, rhs);
    EXPECT_TRUE(report.converged) << report.message;
    EXPECT_LT(report.iterations, 0.6 * alone) << first;
    EXPECT_LT(distance(*test, again, exact), 1e-6);
    EXPECT_FALSE(solver.corrects_bodies());
}

// Moving bodies as right-hand side; the wrenches against those of a solution a thousand times as sharp.
template <int D>
int moved(const TestScene<D>& scene, const std::string& name, double accuracy = 1e-5)
{
    const auto test = build(scene);
    const UnknownVector<D> rhs = motion_outflow(*test);
    UnknownVector<D> p = zeros(*test), sharp = zeros(*test);
    const CoupledSolver<D> solver(test->system, {});
    const SolveReport report = solver.solve(p, rhs);
    EXPECT_TRUE(report.converged) << name << ": " << report.message << ", residual " << report.residual;
    SolverOptions options;
    options.tolerance = 1e-11;
    CoupledSolver<D>(test->system, options).solve(sharp, rhs);
    const Eigen::VectorXd w = wrenches(test->system, p), w_sharp = wrenches(test->system, sharp);
    const double error = (w - w_sharp).norm() / w_sharp.norm();
    EXPECT_LT(error, accuracy) << name;
    if (std::getenv("GAPFLOW_VERBOSE"))
        std::printf("%-40s %3d iterations, residual %.1e, error of the wrenches %.1e\n", name.c_str(), report.iterations,
                    report.residual, error);
    return report.iterations;
}

TEST(Solve, FilmsOverDecades)
{
    char name[80];
    for (double film : {1e-7, 1e-4, 1e-2, 1.0, 1e2, 1e4, 1e7})
        for (double mouth : {1e-7, 1e-2, 1.0, 1e2, 1e7}) {
            std::snprintf(name, sizeof name, "2D film %g conduit %g", film, mouth);
            EXPECT_LE(moved(film_scene<2>(64, film, mouth, 1.0), name), 25) << name;
            if (mouth == 1.0 || film == 1.0) {
                std::snprintf(name, sizeof name, "3D film %g conduit %g", film, mouth);
                EXPECT_LE(moved(film_scene<3>(32, film, mouth, 1.0), name), 25) << name;
            }
        }
    for (double density : {1e-3, 1e3})
        for (double film : {1e-7, 1.0, 1e7}) {
            std::snprintf(name, sizeof name, "2D film %g density %g", film, density);
            EXPECT_LE(moved(film_scene<2>(64, film, 1.0, density), name), 25) << name;
            std::snprintf(name, sizeof name, "2D open film %g density %g", film, density);
            EXPECT_LE(moved(film_scene<2>(64, film, 1.0, density, SideKind::open), name), 25) << name;
        }
}

// Only the film fixes the chambers' levels against each other.
TEST(Solve, ChambersJoinedByAFilm)
{
    char name[80];
    for (double film : {1e-7, 1e-3, 1.0, 1e7})
        for (double density : {1e-3, 1.0, 1e3}) {
            std::snprintf(name, sizeof name, "2D chambers film %g density %g", film, density);
            EXPECT_LE(moved(chamber_scene<2>(64, film, 1.0, density), name), 25) << name;
            std::snprintf(name, sizeof name, "3D chambers film %g density %g", film, density);
            EXPECT_LE(moved(chamber_scene<3>(16, film, 1.0, density), name), 25) << name;
        }
}

// A pocket between a fixed shell and a free ball in its wall: L is singular there, the system is not.
TEST(Solve, SealedPocketAgainstAFreeBody)
{
    char name[80];
    for (double density : {1e-6, 1e-3, 1.0, 1e3}) {
        TestScene<2> scene(Index<2>(64, 64), 1.0 / 64);
        const Vec<2> middle(0.5, 0.5);
        const BodyShape<2> shell{[=](const Vec<2>& x) { return std::abs((x - middle).norm() - 0.25) - 0.06; }, middle, 1, 1,
                                 true};
        scene.bodies = {shell, ball<2>(Vec<2>(0.75, 0.5), 0.11, density)};
        std::snprintf(name, sizeof name, "2D pocket density %g", density);
        EXPECT_LE(moved(scene, name), 16) << name;
        EXPECT_LE(recover(scene, {}, name).report.iterations, 16) << name;
    }
    // A piston from wall to wall: two pockets, their difference is fixed by the body, their sum by nothing.
    for (double density : {1e-6, 1.0, 1e6}) {
        TestScene<3> scene(Index<3>(32, 16, 16), 1.0 / 16);
        scene.bodies = {box<3>(Vec<3>(0.8, 0.5, 0.5), Vec<3>(0.3, 1, 1), density)};
        std::snprintf(name, sizeof name, "3D piston density %g", density);
        EXPECT_LE(recover(scene, {}, name).report.iterations, 16) << name;
    }
}

TEST(Solve, TellsWhenItFails)
{
    const auto test = build(two_bodies<2>(64, 1.0));
    UnknownVector<2> rhs = motion_outflow(*test), p = zeros(*test);
    SolverOptions options;
    options.max_iterations = 3;
    const CoupledSolver<2> solver(test->system, options);
    SolveReport report = solver.solve(p, rhs);
    EXPECT_FALSE(report.converged);
    EXPECT_GT(report.residual, options.tolerance);
    EXPECT_EQ(report.message, "not converged after 3 iterations");
    // From where it stopped.
    for (int k = 0; k < 8 && !report.converged; ++k)
        report = solver.solve(p, rhs);
    EXPECT_TRUE(report.converged);
    EXPECT_TRUE(report.message.empty());

    rhs.cells(test->grid->low()) = std::numeric_limits<double>::quiet_NaN();
    report = solver.solve(p, rhs);
    EXPECT_FALSE(report.converged);
    EXPECT_EQ(report.message, "the right-hand side is not finite");
}

TEST(Solve, StopsAtRoundOff)
{
    const auto test = build(two_bodies<2>(64, 1.0));
    UnknownVector<2> rhs = motion_outflow(*test), p = zeros(*test);
    const CoupledSolver<2> solver(test->system, {});
    const SolveReport report = solver.solve(p, rhs, 1e12); // right-hand side far below what counts
    EXPECT_TRUE(report.converged);
    EXPECT_EQ(report.iterations, 0);
    const UnknownVector<2> nothing = zeros(*test);
    EXPECT_TRUE(solver.solve(p, nothing).converged);
    EXPECT_EQ(inner(*test, p, p), 0);
}

} // namespace
} // namespace gapflow::test
