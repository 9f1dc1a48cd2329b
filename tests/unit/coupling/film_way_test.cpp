// A film whose gap changes by a large factor in one step, against the exact integrals over the way.
#include "gapflow/coupling/film_way.hpp"
#include "world.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace gapflow {
namespace {

TEST(FilmWay, MeansOverTheWay)
{
    FilmMesh<2> mesh;
    mesh.h = {0.2, 0.2};
    FilmElement<2> e;
    e.nodes = {0, 1};
    // From 0.5 to 0.2: mean of (0.2 / h)^3 = 0.2 * 0.7 / (2 * 0.25), of (0.2 / h)^2 = 0.4, of 0.2 / h = 0.2 ln 2.5 / 0.3.
    EXPECT_NEAR(cubic_mean<2>(mesh, e, -0.3), 0.28, 1e-14);
    EXPECT_NEAR(square_mean(0.2, -0.3), 0.4, 1e-14);
    EXPECT_NEAR(linear_mean<2>(mesh, e, -0.3), 0.2 * std::log(2.5) / 0.3, 1e-14);
    EXPECT_NEAR(linear_mean<2>(mesh, e, -1e-9), 1 - 2.5e-9, 1e-14);
    // The mean over the way back is the same, over the value at its other end.
    mesh.h = {0.5, 0.5};
    EXPECT_NEAR(cubic_mean<2>(mesh, e, 0.3) / std::pow(0.5, 3), 0.28 / std::pow(0.2, 3), 1e-12);
}

TEST(FilmWay, ImplicitStepsLeaveWhatExactOnesLeave)
{
    EXPECT_EQ(steepened(0), 1);
    for (double share : {1e-9, 0.05, 0.3, 2.0})
        EXPECT_NEAR(1 / (1 + share * steepened(share)), std::exp(-share), 1e-15);
}

// Drag that takes little of the speed counts with its mean over the way, drag that balances a force with its value at the end; where the gap hardly
// changes, with what it is.
TEST(FilmWay, PartsOfDrag)
{
    const DragParts little = drag_parts(0, 1, 0.2, -0.1);
    EXPECT_EQ(little.mean, 1);
    EXPECT_EQ(little.end, 0);
    const DragParts some = drag_parts(0.2, 1, 0.2, -0.8); // nothing of it at the start: e^-0.2 is left
    EXPECT_NEAR(some.mean, std::expm1(0.2) / 0.2, 0.02);
    EXPECT_NEAR(some.end, 0, 1e-3);
    for (const double much : {1e3, 1e6}) {
        const DragParts balanced = drag_parts(much, 1, 0.2, -0.05);
        EXPECT_NEAR(balanced.mean, 0, 2 / much);
        EXPECT_NEAR(balanced.end, 1, 2 / much);
    }
    const DragParts pushed = drag_parts(-1.5, 1, 0.2, -0.05); // by other films
    EXPECT_GT(pushed.mean, 0);
    EXPECT_LT(pushed.mean, 1);
    EXPECT_EQ(pushed.end, 0);
    for (const double much :
         {1.0, 37.0, 1e3}) { // it closes to a third (a box above a floor in examples/11_pile): of 1 at the end
        const DragParts closes = drag_parts(much, 0.9, 0.2, -0.4);
        const double mean = 2.0 / 9, drag = closes.mean * mean + closes.end;
        EXPECT_GT(drag, mean);
        EXPECT_LT(drag, 1.2);
    }
    const DragParts from_afar = drag_parts(1e3, 1, 0.2, -0.2e8);
    EXPECT_TRUE(std::isfinite(from_afar.mean) && std::isfinite(from_afar.end));
    const DragParts still = drag_parts(0.5, 1e-6, 0.2, -1e-9);
    EXPECT_NEAR(still.mean + still.end, 1, 1e-6);
}

// A strip of length L that closes from h0 to h1 with unit speed meets mu t L^3 (h0 + h1) / (2 h0^2 h1^2) by viscosity and
// rho L^3 / 12 (1 / h1 - 1 / h0) by the growth of its inertia.
TEST(FilmWay, ImpulsesOfAStrip)
{
    const double L = 0.6, h0 = 0.003, h1 = 0.0005;
    Scene scene;
    scene.dimension = 2;
    scene.size = {2, 1, 0};
    scene.cells = {32, 16, 1};
    scene.sides[3].kind = SideScene::Kind::open;
    BodyScene box;
    box.name = "box";
    box.shape = BodyScene::ShapeKind::box;
    box.size = {L, 0.3, 0};
    box.position = {0.97, 0.15 + h0, 0};
    box.density = 2;
    scene.bodies = {box};
    const World<2> world(scene, true);
    const Coupling<2>& coupling = world.coupling;
    ASSERT_EQ(coupling.network.films.size(), 1u);
    const FilmMesh<2>& mesh = coupling.network.films[0].mesh;
    const auto impulse = [&](double viscosity_dt, double opened) {
        const std::vector<int> films{0};
        std::array<Twist<2>, 2> V{Twist<2>::Zero(), Twist<2>::Zero()};
        V[mesh.master == 0 ? 0 : 1][1] = opened < 0 ? -1 : 1;
        const WayAhead<2> way{{std::vector<double>(mesh.elements.size(), opened)}, viscosity_dt, 1e-6};
        const auto found = impulses_on_way<2>(coupling, films, links_of_films(coupling), way, V);
        EXPECT_TRUE(found.has_value());
        return std::array<double, 2>{found->inertia[mesh.master == 0 ? 0 : 1][1], found->all[mesh.master == 0 ? 0 : 1][1]};
    };
    const double inertia = std::pow(L, 3) / 12 * (1 / h1 - 1 / h0);
    EXPECT_NEAR(impulse(0, h1 - h0)[0], -inertia, 0.05 * inertia);
    EXPECT_EQ(impulse(0, h1 - h0)[0], impulse(0, h1 - h0)[1]);
    const double viscosity_dt = 1e-5, viscous = viscosity_dt * std::pow(L, 3) * (h0 + h1) / (2 * h0 * h0 * h1 * h1);
    const auto [by_inertia, by_all] = impulse(viscosity_dt, h1 - h0);
    EXPECT_EQ(by_inertia, impulse(0, h1 - h0)[0]);
    EXPECT_NEAR(by_all - by_inertia, -viscous, 0.05 * viscous);
    EXPECT_NEAR(impulse(viscosity_dt, 0)[1], viscosity_dt * std::pow(L / h0, 3), 0.05 * viscosity_dt * std::pow(L / h0, 3));
}

} // namespace
} // namespace gapflow
