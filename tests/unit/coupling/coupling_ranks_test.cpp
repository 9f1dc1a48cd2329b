// The coupled system with rows shared out among ranks: each has the rows of its cells and of its films' nodes, as one rank has them. Run on several ranks
// (ctest -L mpi).
#include "world.hpp"

#include "gapflow/coupling/film_drag.hpp"
#include "gapflow/coupling/film_inertia.hpp"
#include "gapflow/solver/solver.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace gapflow {
namespace {

/// Balls and boxes close to each other everywhere, across the domain's sides too.
template <int D>
Scene crowd(SideScene::Kind sides)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> jitter(-0.2, 0.2);
    constexpr int bodies = D == 2 ? 4 : 3; // along an axis
    Scene scene;
    scene.dimension = D;
    scene.density = 1.3;
    for (int axis = 0; axis < D; ++axis) {
        scene.size[axis] = scene.cells[axis] = 5 * bodies;
        scene.sides[2 * axis].kind = scene.sides[2 * axis + 1].kind = sides;
    }
    int number = 0;
    for_each_index<D>(Index<D>::Zero(), Index<D>::Constant(bodies), [&](const Index<D>& i) {
        BodyScene body;
        body.name = "body" + std::to_string(100 + number++);
        for (int axis = 0; axis < D; ++axis)
            body.position[axis] = 5 * i[axis] + 2.3 + jitter(random);
        body.shape = number % 4 == 0 ? BodyScene::ShapeKind::ball : BodyScene::ShapeKind::box;
        body.radius = 2.3;
        body.size = {4.5, 4.5, 4.5};
        body.density = 2;
        scene.bodies.push_back(body);
    });
    return scene;
}

// Fluxes of a row, summed over the entries of a solid.
template <class Row, int D>
using Rows = std::map<std::pair<Row, int>, Twist<D>>;

template <int D, class Of>
auto rows_of(const auto& entries, Of&& number)
{
    Rows<long, D> rows;
    for (const auto& entry : entries)
        rows.try_emplace({number(entry.row), entry.body}, Twist<D>::Zero()).first->second += entry.flux;
    return rows;
}

template <int D>
double size_of(const Rows<long, D>& rows)
{
    double largest = 0;
    for (const auto& [place, flux] : rows)
        largest = std::max(largest, flux.norm());
    return largest;
}

// Every entry of `part` is one of `whole`; returns their number.
template <int D>
std::size_t expect_part(const Rows<long, D>& part, const Rows<long, D>& whole)
{
    const double largest = size_of<D>(whole);
    for (const auto& [place, flux] : part) {
        const auto found = whole.find(place);
        const Twist<D> expected = found == whole.end() ? Twist<D>(Twist<D>::Zero()) : found->second;
        EXPECT_LT((flux - expected).norm(), 1e-13 * largest) << "row " << place.first << ", solid " << place.second;
    }
    return part.size();
}

template <int D>
void check(SideScene::Kind sides, double viscosity_dt)
{
    const Scene scene = crowd<D>(sides);
    const Model<D> one(scene, Communicator(MPI_COMM_SELF), Task::motion),
        all(scene, Communicator(MPI_COMM_WORLD), Task::motion);
    const std::vector<TwistMatrix<D>> mass = one.masses(one.bodies, 0);
    Coupling<D> alone = one.coupled(one.bodies, mass, viscosity_dt), shared = all.coupled(all.bodies, mass, viscosity_dt);
    const Communicator& comm = all.grid.comm();
    ASSERT_GT(alone.network.rim.joints.size(), 0u);
    ASSERT_EQ(alone.system.nodes, shared.system.nodes);

    // K in cells and nodes.
    const auto key = [&](const Index<D>& c) { return one.grid.key(c); };
    const auto same = [](int node) { return static_cast<long>(node); };
    const Rows<long, D> cells = rows_of<D>(alone.cell_flux, key), nodes = rows_of<D>(alone.node_flux, same);
    const auto own_cells = expect_part<D>(rows_of<D>(shared.cell_flux, key), cells),
               own_nodes = expect_part<D>(rows_of<D>(shared.node_flux, same), nodes);
    EXPECT_EQ(comm.sum(static_cast<long>(own_cells)), static_cast<long>(cells.size()));
    EXPECT_EQ(comm.sum(static_cast<long>(own_nodes)), static_cast<long>(nodes.size()));

    // The films' matrix, columns of own nodes.
    for (int j = 0; j < shared.system.nodes; ++j) {
        const Eigen::VectorXd column = shared.system.film.col(j), expected = alone.system.film.col(j);
        EXPECT_EQ(column, shared.system.owns(j) ? expected : Eigen::VectorXd(Eigen::VectorXd::Zero(column.size())));
        EXPECT_EQ(comm.sum(static_cast<long>(shared.system.owns(j))), 1);
    }
    EXPECT_LT((Eigen::MatrixXd(shared.system.mass) - Eigen::MatrixXd(alone.system.mass)).norm(),
              1e-12 * Eigen::MatrixXd(alone.system.mass).norm());

    // What is summed over films: outflow, inertia near contacts, the solution.
    std::mt19937 random(3);
    std::uniform_real_distribution<double> number(-1, 1);
    std::vector<Twist<D>> V(alone.solids.size(), Twist<D>::Zero());
    for (std::size_t s = 0; s < scene.bodies.size(); ++s)
        V[s] = V[s].unaryExpr([&](double) { return number(random); });
    const auto solved = [&](Coupling<D>& coupling) {
        FluidVelocity<D> u{FaceField<D>(*coupling.grid), std::vector<Vec<D>>(coupling.network.elements, Vec<D>::Zero()),
                           std::vector<double>(coupling.network.elements, 0.5),
                           std::vector<double>(coupling.network.rim.mouths.size(), 0.1)};
        if (viscosity_dt > 0)
            start_drag(coupling, u);
        Eigen::VectorXd impulse;
        const std::vector<Twist<D>> start = intermediate_twists(coupling, mass, V, u.film_normal, impulse);
        UnknownVector<D> rhs, p{CellField<D>(*coupling.grid), Eigen::VectorXd::Zero(coupling.system.nodes)};
        double squares = 0;
        outflow(coupling, u, start, rhs, &squares);
        EXPECT_TRUE(CoupledSolver<D>(coupling.system, {}).solve(p, rhs, 1e-13 * std::sqrt(squares)).converged);
        return std::tuple(start, rhs.nodes, p.nodes, impulses(coupling, p));
    };
    const auto [start, rhs, p, impulse] = solved(alone);
    const auto [start_shared, rhs_shared, p_shared, impulse_shared] = solved(shared);
    for (std::size_t s = 0; s < V.size(); ++s) {
        EXPECT_LT((start[s] - start_shared[s]).norm(), 1e-11);
        EXPECT_LT((impulse[s] - impulse_shared[s]).norm(), 1e-6 * (1 + impulse[s].norm()));
    }
    EXPECT_LT((rhs - rhs_shared).norm(), 1e-11 * rhs.norm());
    EXPECT_LT((p - p_shared).norm(), 1e-6 * p.norm());
    const auto near = near_inertia(alone, mass, {}), near_shared = near_inertia(shared, mass, {});
    ASSERT_EQ(near.films.size(), near_shared.films.size());
    for (std::size_t k = 0; k < near.films.size(); ++k)
        EXPECT_LT((near.films[k].matrix - near_shared.films[k].matrix).norm(), 1e-9 * near.films[k].matrix.norm());
}

TEST(CouplingRanks, HaveTheRowsOfOneRank2D)
{
    check<2>(SideScene::Kind::open, 0);
}
TEST(CouplingRanks, HaveTheRowsOfOneRankInAPeriodicBoxOfViscousFluid2D)
{
    check<2>(SideScene::Kind::periodic, 0.01);
}
TEST(CouplingRanks, HaveTheRowsOfOneRank3D)
{
    check<3>(SideScene::Kind::wall, 0);
}
TEST(CouplingRanks, HaveTheRowsOfOneRankInAPeriodicBoxOfViscousFluid3D)
{
    check<3>(SideScene::Kind::periodic, 0.01);
}

} // namespace
} // namespace gapflow
