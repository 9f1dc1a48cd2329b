// What the fluid between two bodies adds to their inertia.
#include "gapflow/coupling/film_inertia.hpp"
#include "world.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace gapflow {
namespace {

// Between flat faces of length L, h apart, ideal flow weighs rho L^3 / (12 h) against squeezing and rho L^5 / (720 h) against turning.
TEST(NearInertia, OfAFlatFilm)
{
    const double L = 0.6, h = 0.003;
    Scene scene;
    scene.dimension = 2;
    scene.size = {2, 1, 0};
    scene.cells = {32, 16, 1};
    scene.sides[3].kind = SideScene::Kind::open;
    BodyScene box;
    box.name = "box";
    box.shape = BodyScene::ShapeKind::box;
    box.size = {L, 0.3, 0};
    box.position = {0.97, 0.15 + h, 0};
    box.density = 2;
    scene.bodies = {box};
    const World<2> world(scene, true);
    const Coupling<2>& coupling = world.coupling;
    const std::vector<TwistMatrix<2>> mass(coupling.solids.size(), TwistMatrix<2>::Identity());
    const NearInertia<2> inertia = near_inertia(coupling, mass, {});
    ASSERT_EQ(inertia.films.size(), 1u);
    EXPECT_EQ(inertia.films[0].a, 0);
    const PairMatrix<2>& film = inertia.films[0].matrix;
    EXPECT_NEAR(film(1, 1), L * L * L / (12 * h), 0.1 * film(1, 1)); // the ways out weigh too
    EXPECT_NEAR(film(2, 2), std::pow(L, 5) / (720 * h), 0.1 * film(2, 2));
    EXPECT_LT((film - film.transpose()).norm(), 1e-9 * film.norm());
    EXPECT_NEAR(inertia.mobility[0](1, 1), 1, 1e-12);
    // Voids carry nothing: without its nodes the film weighs what its fluid does.
    const NearInertia<2> dry = near_inertia(coupling, mass, std::vector<char>(coupling.system.nodes, 1));
    EXPECT_LT(dry.films[0].matrix(1, 1), L * h);
}

} // namespace
} // namespace gapflow
