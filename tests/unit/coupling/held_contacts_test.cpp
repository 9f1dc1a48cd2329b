// Contacts that hold bodies: how redundant ones share what they carry.
#include "world.hpp"

#include <gtest/gtest.h>

namespace gapflow {
namespace {

// A block in the middle of a tank, and the solid that stands for its walls.
Scene block()
{
    Scene scene;
    scene.dimension = 2;
    scene.size = {2, 2, 0};
    scene.cells = {16, 16, 1};
    BodyScene body;
    body.name = "block";
    body.shape = BodyScene::ShapeKind::box;
    body.size = {0.5, 0.5, 0};
    body.position = {1, 1, 0};
    body.density = 4;
    scene.bodies = {body};
    return scene;
}

// Four supports in a row stop a block that falls at 1. Of all shares that do, theirs are the nearest to those expected.
TEST(HeldContacts, RedundantOnesShareAsExpected)
{
    World<2> world(block());
    Coupling<2>& coupling = world.coupling;
    const int wall = static_cast<int>(coupling.solids.size()) - 1;
    ASSERT_LT(coupling.free_body[wall], 0);
    const Eigen::Vector4d arm(-0.3, -0.1, 0.1, 0.3), expected(0.1, 0.7, 0.4, 0.2); // they sum to 1.4 and turn
    std::vector<HeldContact<2>> contacts;
    for (int i = 0; i < 4; ++i) {
        HeldContact<2> c{0, wall, Twist<2>(0, 1, arm[i]), Twist<2>::Zero(), 0.0};
        c.impulse = expected[i];
        contacts.push_back(c);
    }
    std::vector<Twist<2>> falling(coupling.solids.size(), Twist<2>::Zero());
    falling[0][1] = -1;
    const std::vector<double> film_normal(coupling.network.elements, 0.0);
    Eigen::VectorXd shares;
    hold_contacts<2>(coupling, contacts, falling);
    const std::vector<Twist<2>> V = intermediate_twists<2>(coupling, world.mass, falling, film_normal, shares);
    EXPECT_LT(V[0].norm(), 1e-12);
    ASSERT_EQ(shares.size(), 4);
    EXPECT_NEAR(shares.sum(), world.mass[0](0, 0), 1e-12);
    EXPECT_NEAR(shares.dot(arm), 0, 1e-12);
    // What is added is the least, counted by what each moves: over its mobility it is a force and a moment, spread over the supports.
    const Eigen::Vector4d mobility = Eigen::Vector4d::Constant(1 / world.mass[0](0, 0)) + arm.cwiseAbs2() / world.mass[0](2, 2);
    const Eigen::Vector4d moved = (shares - expected).cwiseProduct(mobility);
    const Eigen::Vector4d even = Eigen::Vector4d::Constant(moved.mean()) + moved.dot(arm) / arm.squaredNorm() * arm;
    EXPECT_LT((moved - even).norm(), 1e-8);
    EXPECT_GT((shares - expected).norm(), 0.1);
}

} // namespace
} // namespace gapflow
