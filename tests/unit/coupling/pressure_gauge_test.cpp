// Light bodies in the complex: their mass in the gauge of the pressure, and that the system has one solution in every gauge.
#include "world.hpp"

#include "gapflow/coupling/pressure_gauge.hpp"
#include "gapflow/solver/assemble.hpp"
#include "gapflow/stepping/first_acceleration.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

namespace gapflow {
namespace {

Scene parts_scene(int dimension, int n, const std::vector<BodyScene>& bodies)
{
    Scene scene;
    scene.dimension = dimension;
    scene.parts = true;
    scene.density = 1;
    const double size = n;
    scene.size = {size, size, dimension == 2 ? 0.0 : size};
    scene.cells = {n, n, dimension == 2 ? 1 : n};
    scene.gravity = {0.3, -1, dimension == 2 ? 0.0 : 0.5};
    scene.bodies = bodies;
    return scene;
}

BodyScene ball(const std::string& name, double radius, const Triple& position, double density)
{
    BodyScene b;
    b.name = name;
    b.shape = BodyScene::ShapeKind::ball;
    b.radius = radius;
    b.position = position;
    b.density = density;
    return b;
}

BodyScene box(const std::string& name, const Triple& size, const Triple& position, double density)
{
    BodyScene b = ball(name, 0, position, density);
    b.shape = BodyScene::ShapeKind::box;
    b.size = size;
    return b;
}

/// The system's matrices, dense. Rows of K and of pressures: nodes, then cells, as assemble_dense() has them.
template <int D>
struct Dense {
    explicit Dense(const Coupling<D>& coupling)
    {
        constexpr int n = twist_size<D>;
        CoupledSystem<D> still = coupling.system;
        still.bodies = 0;
        still.cell_flux.clear();
        still.node_flux.clear();
        still.mass.resize(0, 0);
        still.response = {};
        fluid = assemble_dense(still);
        number = number_unknowns(still);
        mass = coupling.system.mass;
        gauged = K = Eigen::MatrixXd::Zero(fluid.rows(), mass.rows());
        const auto add = [&](Eigen::MatrixXd& to, long row, int body, const Twist<D>& flux) {
            to.row(row).template segment<n>(n * body) += flux.transpose();
        };
        for (const auto& e : coupling.cell_flux)
            if (const int b = coupling.free_body[e.body]; b >= 0)
                add(K, number.cell(e.row), b, e.flux);
        for (const auto& e : coupling.node_flux)
            if (const int b = coupling.free_body[e.body]; b >= 0)
                add(K, e.row, b, e.flux);
        for (const auto& e : coupling.system.cell_flux)
            add(gauged, number.cell(e.row), e.body, e.flux);
        for (const auto& e : coupling.system.node_flux)
            add(gauged, e.row, e.body, e.flux);
        own = Eigen::MatrixXd::Zero(mass.rows(), mass.cols());
        for (std::size_t s = 0; s < coupling.solids.size(); ++s)
            if (const int b = coupling.free_body[s]; b >= 0)
                own.block<n, n>(n * b, n * b) += coupling.seen_mass[s];
        for (const NormalInertia<D>& gap : coupling.normal_inertia)
            for (const auto& [i, row_i] : {std::pair(gap.master, gap.row_master), std::pair(gap.other, gap.row_other)})
                for (const auto& [j, row_j] : {std::pair(gap.master, gap.row_master), std::pair(gap.other, gap.row_other)})
                    if (const int a = coupling.free_body[i], b = coupling.free_body[j]; a >= 0 && b >= 0)
                        own.block<n, n>(n * a, n * b) += gap.mass * row_i * row_j.transpose();
    }
    Eigen::MatrixXd solve(const Eigen::MatrixXd& A, const Eigen::MatrixXd& b) const // a closed box: constants aside
    {
        return (A + Eigen::MatrixXd::Ones(A.rows(), A.cols())).llt().solve(b);
    }

    Numbering<D> number;
    Eigen::MatrixXd fluid, mass, K, gauged;
    Eigen::MatrixXd own; ///< D, and with the bodies' own mass M
};

double least(const Eigen::MatrixXd& m)
{
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(m).eigenvalues()[0];
}

template <int D>
void expect_one_solution(const Scene& scene)
{
    constexpr int n = twist_size<D>;
    const World<D> world(scene);
    const Coupling<D>& coupling = world.coupling;
    Dense<D> dense(coupling);
    for (std::size_t s = 0; s < world.bodies.size(); ++s)
        dense.own.template block<n, n>(n * coupling.free_body[s], n * coupling.free_body[s]) += world.mass[s];
    ASSERT_FALSE(coupling.gauge_cells.empty());
    EXPECT_GT(least(dense.mass), 0.0);
    if (world.bodies.size() == 1) {
        EXPECT_GE(least(dense.mass - Eigen::MatrixXd(world.mass[0])), -1e-13 * world.coupling.seen_mass[0].norm());
    }

    const Eigen::VectorXd force = Eigen::VectorXd::LinSpaced(dense.mass.rows(), 1.0, 2.0);
    const Eigen::MatrixXd N = dense.own + dense.K.transpose() * dense.solve(dense.fluid, dense.K);
    const Eigen::VectorXd a = N.llt().solve(force);
    const Eigen::MatrixXd compliance = dense.mass.inverse();
    const Eigen::VectorXd q =
        dense.solve(dense.fluid + dense.gauged * compliance * dense.gauged.transpose(), -dense.gauged * (compliance * force));
    const Eigen::VectorXd found = compliance * (force + dense.gauged.transpose() * q);
    EXPECT_LT((found - a).norm(), 1e-9 * a.norm());

    // L p + K a = 0 of the pressure itself.
    UnknownVector<D> p{CellField<D>(world.grid), q.head(coupling.system.nodes)};
    for_each_index<D>(world.grid.low(), world.grid.high(), [&](const Index<D>& c) {
        if (dense.number.cell(c) >= 0)
            p.cells(c) = q[dense.number.cell(c)];
    });
    std::vector<Twist<D>> twists(coupling.solids.size(), Twist<D>::Zero());
    for (std::size_t s = 0; s < world.bodies.size(); ++s)
        twists[s] = found.segment<n>(n * coupling.free_body[s]);
    leave_gauge(coupling, twists, p);
    Eigen::VectorXd all(q.size());
    all.head(coupling.system.nodes) = p.nodes;
    for_each_index<D>(world.grid.low(), world.grid.high(), [&](const Index<D>& c) {
        if (dense.number.cell(c) >= 0)
            all[dense.number.cell(c)] = p.cells(c);
    });
    EXPECT_LT((dense.fluid * all + dense.K * found).norm(), 1e-9 * (dense.K * found).norm());
}

TEST(PressureGauge, LightDisksHaveOneSolution)
{
    expect_one_solution<2>(parts_scene(2, 16, {ball("a", 2.0, {5.0, 8.0, 0}, 1e-3), ball("b", 2.5, {11.1, 7.7, 0}, 5.0)}));
}

TEST(PressureGauge, ALightPlateBetweenTwoPlanesHasOneSolution)
{
    expect_one_solution<2>(parts_scene(2, 16, {box("a", {8.0, 0.1, 0}, {8.2, 8.4, 0}, 1e-3)}));
}

TEST(PressureGauge, LightBallsHaveOneSolution)
{
    expect_one_solution<3>(parts_scene(3, 9, {ball("a", 1.5, {4.5, 4.5, 4.5}, 0.01)}));
}

TEST(PressureGauge, ALimitedBodyHasOneSolution)
{
    // No plane normal to y sees it, and no cell feels its motion along y.
    const Scene scene = parts_scene(2, 16, {ball("a", 0.49, {8.45, 8.5, 0}, 1e-3)});
    const World<2> world(scene);
    EXPECT_LT(world.coupling.seen_mass[0](0, 0), 0);
    EXPECT_NEAR(world.coupling.seen_mass[0](1, 1), 0, 1e-12);
    expect_one_solution<2>(scene);
}

TEST(PressureGauge, LightPlatesInAStackHaveOneSolution)
{
    // Each lies between two planes of the grid, others in the gaps: their layers are the same fluid.
    std::vector<BodyScene> plates;
    for (int k = 0; k < 4; ++k)
        plates.push_back(box(std::string(1, static_cast<char>('a' + k)), {8.0, 0.9, 0}, {8.0, 6.5 + k, 0}, 1e-2));
    expect_one_solution<2>(parts_scene(2, 16, plates));
}

TEST(PressureGauge, WallsBesideAPlaneInTheirGapConverge)
{
    const Communicator comm;
    for (const double gap : {0.1, 1e-3, 1e-5, 1e-7}) {
        const Scene scene = parts_scene(
            2, 32,
            {box("a", {16.0, 4.0, 0}, {16.0, 14 - gap / 2, 0}, 1e-2), box("b", {16.0, 4.0, 0}, {16.0, 18 + gap / 2, 0}, 2.0)});
        EXPECT_LE(first_accelerations(scene, comm).iterations, 12) << gap;
    }
}

TEST(PressureGauge, HeavyBodiesNeedNone)
{
    const World<2> world(parts_scene(2, 16, {ball("a", 2.5, {8.1, 7.7, 0}, 5.0)}));
    EXPECT_TRUE(world.coupling.gauge_cells.empty());
    EXPECT_NEAR(world.coupling.system.mass.coeff(0, 0), world.mass[0](0, 0) + world.coupling.seen_mass[0](0, 0), 1e-12);
}

TEST(PressureGauge, FirstAccelerationsAtAnyDensity)
{
    const Communicator comm;
    for (const double density : {1e-3, 0.01, 1.0, 1e3}) {
        const Scene scene = parts_scene(2, 24, {ball("a", 2.0, {12.0, 12.0, 0}, density)});
        const World<2> world(scene);
        const FirstAccelerations found = first_accelerations(scene, comm);
        ASSERT_EQ(found.bodies, std::vector<std::string>{"a"});
        // The disk's added mass in the middle of the box is isotropic: the acceleration is along gravity.
        const Eigen::VectorXd& a = found.acceleration[0];
        EXPECT_NEAR(a[0], -0.3 * a[1], 1e-6 * a.norm() + 1e-12) << density;
        EXPECT_LE(found.iterations, 20) << density;
        if (density == 1.0) {
            EXPECT_LT(a.norm(), 1e-9);
        }
        if (density == 1e-3) {
            EXPECT_GT(a[1], 0.7);
        }
    }
}

} // namespace
} // namespace gapflow
