// The coupled system without the film nodes that hold voids.
#include "gapflow/coupling/wet_system.hpp"
#include "world.hpp"

#include "gapflow/solver/solver.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gapflow {
namespace {

// A block of mass 1 a hundredth above the floor of a tank with an open top, all of its contacts dry.
Scene dry_block()
{
    Scene scene;
    scene.dimension = 3;
    scene.size = {3, 3, 1.5};
    scene.cells = {16, 16, 8};
    scene.sides[5].kind = SideScene::Kind::open;
    scene.reference_pressure = 10;
    scene.gap.contact = GapScene::Contact::dry;
    scene.contact.thickness = 1e-4;
    BodyScene body;
    body.name = "block";
    body.shape = BodyScene::ShapeKind::box;
    body.size = {1, 1, 0.5};
    body.position = {1.513, 1.49, 0.26};
    body.mass = 1;
    body.inertia = {0.1, 0.1, 0.1};
    scene.bodies = {body};
    return scene;
}

// The reduced system gives the solution of the whole one with the voids' pressures: every other row balances, and the voids' own rows are those of
// the whole system. (Without flow between nodes that are all voids a node's condition would depend on which of its neighbours are.)
TEST(WetSystem, BalancesEveryRowButTheVoids)
{
    World<3> world(dry_block(), true);
    Coupling<3>& coupling = world.coupling;
    const Grid<3>& grid = world.grid;
    const std::vector<TwistMatrix<3>>& mass = world.mass;
    const int nodes = coupling.system.nodes;
    const std::size_t entries = coupling.system.node_flux.size();
    std::vector<char> is_void(nodes, 0);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(nodes), filling = Eigen::VectorXd::Zero(nodes);
    for (int i = 0; i < nodes; ++i)
        if (coupling.network.films[0].mesh.mid[i][0] < 1.5) {
            is_void[i] = 1;
            b[i] = -0.3 - 0.1 * coupling.network.films[0].mesh.mid[i][1];
        } else {
            filling[i] = 1e-4;
        }
    std::vector<Twist<3>> V(coupling.solids.size(), Twist<3>::Zero());
    V[0] << 0.1, 0, 0.3, 0, 0.2, 0;
    FluidVelocity<3> u{FaceField<3>(grid), std::vector<Vec<3>>(coupling.network.elements, Vec<3>::Zero()),
                       std::vector<double>(coupling.network.elements, 0.0),
                       std::vector<double>(coupling.network.rim.mouths.size(), 0.0)};
    UnknownVector<3> p{CellField<3>(grid), Eigen::VectorXd::Zero(nodes)};
    Eigen::VectorXd impulse, film_outflow;
    {
        WetSystem<3> wet(coupling);
        wet.take_out(is_void, b, std::vector<char>(u.mouth.size(), 0));
        hold_contacts<3>(coupling, {}, V);
        V = intermediate_twists<3>(coupling, mass, V, u.film_normal, impulse);
        wet.add_void_impulse(V, impulse);
        UnknownVector<3> rhs;
        outflow(coupling, u, V, rhs);
        for_each_index<3>(grid.low(), grid.high(), [&](const Index<3>& c) { rhs.cells(c) *= -1; });
        rhs.nodes *= -1;
        wet.reduce(V, filling, rhs);
        SolverOptions options;
        options.tolerance = 1e-11;
        ASSERT_TRUE(CoupledSolver<3>(coupling.system, options).solve(p, rhs).converged);
        add_pressure_impulse(coupling, p, V, impulse);
        film_outflow = wet.outcome(p, V).outflow;
        p.nodes += wet.given();
    }
    EXPECT_EQ(coupling.system.node_flux.size(), entries); // the whole system again
    subtract_gradient(coupling, p, u);
    UnknownVector<3> rest;
    outflow(coupling, u, V, rest);
    double worst = 0, worst_void = 0, largest = 0;
    for_each_index<3>(grid.low(), grid.high(), [&](const Index<3>& c) { worst = std::max(worst, std::abs(rest.cells(c))); });
    for (int i = 0; i < nodes; ++i) {
        if (!is_void[i])
            worst = std::max(worst, std::abs(film_outflow[i] + filling[i]));
        else
            largest = std::max(largest, std::abs(film_outflow[i]));
        worst_void = std::max(worst_void, std::abs(film_outflow[i] - rest.nodes[i]));
        if (is_void[i]) {
            EXPECT_DOUBLE_EQ(p.nodes[i], b[i]);
        }
    }
    EXPECT_GT(largest, 1e-4);
    EXPECT_LT(worst, 1e-8 * largest);
    EXPECT_LT(worst_void, 1e-8 * largest);
}

} // namespace
} // namespace gapflow
