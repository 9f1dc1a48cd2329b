// Motion normal to the gap of a film between a box and a ball beside one of its corners.
#include "coupled_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace gapflow {
namespace {

constexpr double ball_radius = 0.3;

struct BoxAndBall : CoupledScene {
    /// The ball's centre lies at `angle` (radians) about the box's corner (1, 1), 0.01 more than its radius away.
    explicit BoxAndBall(double angle) : CoupledScene(make_scene(angle)) {}
    static Scene make_scene(double angle)
    {
        Scene scene;
        scene.dimension = 2;
        scene.size = {2, 2, 0};
        scene.cells = {40, 40, 1};
        scene.gap.threshold = 1.0;
        BodyScene box, ball;
        box.name = "box";
        ball.name = "ball";
        box.shape = BodyScene::ShapeKind::box;
        ball.shape = BodyScene::ShapeKind::ball;
        box.size = {0.5, 0.5, 0};
        box.position = {0.75, 0.75, 0};
        ball.radius = ball_radius;
        const double far = ball_radius + 0.01;
        ball.position = {1 + far * std::cos(angle), 1 + far * std::sin(angle), 0};
        scene.bodies = {box, ball};
        return scene;
    }
    bool ball_is_other() const { return coupling.solids[film().pair.other].name == "ball"; }
};

TEST(FilmNormal, CommonMotionIsThatOfTheMiddleAndABallThatTurnsGivesNone)
{
    const BoxAndBall scene(1.4);
    ASSERT_EQ(scene.coupling.network.films.size(), 1u);
    ASSERT_TRUE(scene.ball_is_other());
    const FilmMesh<2>& mesh = scene.film().mesh;
    const std::vector<Solid<2>>& solids = scene.coupling.solids;
    const Vec<2> velocity(0.3, -0.7);
    const double spin = 0.9;
    double widest = 0;
    for (const FilmElement<2>& e : mesh.elements) {
        const NormalRows<2> rows = normal_rows<2>(mesh, e, solids);
        const auto rigid = [&](int solid) { // spins about the origin, seen from the solid's centre
            const Vec<2>& c = solids[solid].centre;
            return Twist<2>(velocity[0] - spin * c[1], velocity[1] + spin * c[0], spin);
        };
        const Vec<2> U = velocity + spin * Vec<2>(-e.centroid[1], e.centroid[0]);
        EXPECT_NEAR(rows.master.dot(rigid(mesh.master)) + rows.other.dot(rigid(mesh.other)), e.normal.dot(U), 1e-12);
        EXPECT_NEAR(rows.other[2], 0, 1e-9 * ball_radius);
        EXPECT_NEAR(rows.other.head<2>().dot(e.normal), 0.5, 0.1); // the middle leans a little towards the box
        widest = std::max(widest, std::acos(e.normal.dot(e.into_other)));
    }
    EXPECT_GT(widest, 0.05); // there is a wedge
}

// From one step to the next the ball goes over from one side of the box's corner to the other, and its film with it: what rushed along the
// old film's tip must not strike the walls of the new one with all of its speed.
TEST(FilmNormal, FlowRoundACornerGainsNoEnergy)
{
    const BoxAndBall before(1.45), after(0.12);
    ASSERT_EQ(before.film().pair.master, after.film().pair.master);
    const std::vector<FilmElement<2>>& old = before.film().mesh.elements;
    std::vector<Vec<2>> u;
    double energy = 0;
    for (const FilmElement<2>& e : old) {
        const double speed = e.centroid[0] > 0.95 ? 100.0 : 1.0; // at the corner
        u.push_back(speed * Vec<2>(-e.normal[1], e.normal[0]));
        energy += e.volume * speed * speed;
    }
    const FilmHistories<2> histories =
        remember_films<2>(before.coupling.network, before.coupling.solids, before.rest, u, {}, before.grid.dx());
    const FilmFlow<2> flow = advect_films<2>(
        after.coupling.network, after.coupling.solids, histories,
        [](const std::vector<Vec<2>>& x) { return std::vector<Vec<2>>(x.size(), Vec<2>(Vec<2>::Zero())); },
        [](int, int) { return MouthLaw{}; }, {}, 1e-6);
    double along = 0, across = 0;
    for (std::size_t i = 0; i < flow.velocity.size(); ++i) {
        along += after.film().mesh.elements[i].volume * flow.velocity[i].squaredNorm();
        across += after.film().mesh.elements[i].volume * flow.normal[i] * flow.normal[i];
    }
    EXPECT_GT(along, 0);
    EXPECT_LE(along, 1.0001 * energy);
    EXPECT_LE(across, 1.0001 * energy);
}

} // namespace
} // namespace gapflow
