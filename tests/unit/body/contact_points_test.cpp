// Contact points against hand values.
#include "gapflow/body/contact_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace gapflow {
namespace {

template <int D>
struct Scenery {
    std::vector<std::shared_ptr<const Shape<D>>> shapes;
    std::vector<Solid<D>> solids;
    std::vector<ContactFeatures<D>> features;
    Vec<D> period = Vec<D>::Zero();

    void add(std::unique_ptr<Shape<D>> shape, const Vec<D>& position, const Rotation<D>& rotation = Rotation<D>::Identity())
    {
        shapes.push_back(std::move(shape));
        Pose<D> pose;
        pose.position = position;
        pose.rotation = rotation;
        solids.push_back(
            {"s" + std::to_string(solids.size()), PlacedShape<D>(*shapes.back(), pose), position, Motion::free, false});
        features.push_back(contact_features(*shapes.back()));
    }
    void add_floor()
    {
        add(make_half_space<D>(unit<D>(D - 1)), Vec<D>::Zero());
        solids.back().motion = Motion::fixed;
    }
    std::vector<ContactPoint<D>> contacts(double reach) const
    {
        const auto all = find_contacts<D>(
            solids, features, Vec<D>::Constant(-10), Vec<D>::Constant(10), period, [&](int, int) { return reach; }, reach,
            1e-3);
        for (const auto& c : all) {
            EXPECT_LT(c.a, c.b);
            EXPECT_NEAR(c.normal.norm(), 1, 1e-12);
            EXPECT_LT((c.x - c.y - c.distance * c.normal).norm(), 1e-9);
            EXPECT_NEAR(solids[c.a].shape.distance(c.x), 0, 1e-9);
            EXPECT_NEAR(solids[c.b].shape.shifted(c.shift).distance(c.y), 0, 1e-9);
        }
        return all;
    }
};

Rotation<3> turn(double degrees, const Vec<3>& axis)
{
    return Rotation<3>(Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis));
}

TEST(ContactPoints, BallsAndFloor)
{
    Scenery<3> s;
    s.add(make_ball<3>(0.5), {0, 0, 0.5 + 1e-7});
    s.add(make_ball<3>(0.25), {0.6, 0, 0.5 + 0.45});
    s.add_floor();
    const auto contacts = s.contacts(0.01);
    ASSERT_EQ(contacts.size(), 2u);
    EXPECT_EQ(contacts[0].b, 1);
    EXPECT_NEAR(contacts[0].distance, std::hypot(0.6, 0.45 - 1e-7) - 0.75, 1e-12);
    EXPECT_EQ(contacts[1].b, 2);
    EXPECT_NEAR(contacts[1].distance, 1e-7, 1e-15);
    EXPECT_NEAR(contacts[1].normal[2], 1, 1e-15);
}

TEST(ContactPoints, BoxOnFloorTouchesWithItsCorners)
{
    Scenery<3> s;
    s.add(make_box<3>({1, 0.5, 0.25}), {0, 0, 0.125});
    s.add_floor();
    const auto contacts = s.contacts(0.01);
    ASSERT_EQ(contacts.size(), 4u);
    for (const auto& c : contacts) {
        EXPECT_NEAR(std::abs(c.x[0]), 0.5, 1e-12);
        EXPECT_NEAR(std::abs(c.x[1]), 0.25, 1e-12);
        EXPECT_NEAR(c.distance, 0, 1e-15);
    }
}

TEST(ContactPoints, BoxOnBoxTouchesWithTheCornersOfBoth)
{
    Scenery<2> s;
    s.add(make_box<2>({1, 0.5}), {0, 0.25});
    s.add(make_box<2>({1, 0.5}), {0.3, 0.75 + 1e-6});
    const auto contacts = s.contacts(0.01);
    ASSERT_EQ(contacts.size(), 2u);
    double left = 1, right = -1;
    for (const auto& c : contacts) {
        left = std::min(left, c.x[0]);
        right = std::max(right, c.x[0]);
        EXPECT_NEAR(c.normal[1], -1, 1e-12);
        EXPECT_NEAR(c.distance, 1e-6, 1e-15);
    }
    EXPECT_NEAR(left, -0.2, 1e-12);
    EXPECT_NEAR(right, 0.5, 1e-12);
}

TEST(ContactPoints, CrossedEdges)
{
    const double half = std::sqrt(0.5);
    for (double gap : {1e-3, 0.0, -1e-6}) {
        Scenery<3> s;
        s.add(make_box<3>({1, 1, 1}), {0, 0, 0}, turn(45, unit<3>(0)));                   // an edge along x on top
        s.add(make_box<3>({1, 1, 1}), {0.1, 0.05, 2 * half + gap}, turn(45, unit<3>(1))); // one along y below
        const auto contacts = s.contacts(0.01);
        ASSERT_EQ(contacts.size(), 1u) << gap;
        EXPECT_NEAR(contacts[0].distance, gap, 1e-12);
        EXPECT_NEAR(contacts[0].normal[2], -1, 1e-12);
        EXPECT_NEAR(contacts[0].x[0], 0.1, 1e-12);
        EXPECT_NEAR(contacts[0].x[1], 0, 1e-12);
    }
}

TEST(ContactPoints, CylinderLyingStandingAndTilted)
{
    Scenery<3> lying;
    lying.add(make_cylinder(0.3, 1), {0, 0, 0.3});
    lying.add_floor();
    auto contacts = lying.contacts(0.01);
    double low = 1, high = -1;
    for (const auto& c : contacts) {
        EXPECT_NEAR(c.distance, 0, 1e-9);
        low = std::min(low, c.x[0]);
        high = std::max(high, c.x[0]);
    }
    EXPECT_NEAR(low, -0.5, 1e-9);
    EXPECT_NEAR(high, 0.5, 1e-9);

    Scenery<3> standing;
    standing.add(make_cylinder(0.3, 1), {0, 0, 0.5}, turn(90, unit<3>(1)));
    standing.add_floor();
    EXPECT_GE(standing.contacts(0.01).size(), 4u);

    Scenery<3> tilted; // by an angle that puts the lowest point between the mesh's vertices
    const double angle = 30 * std::numbers::pi / 180;
    const double lowest = 0.5 * std::sin(angle) + 0.3 * std::cos(angle);
    tilted.add(make_cylinder(0.3, 1), {0, 0, lowest + 1e-5}, turn(30, unit<3>(1)) * turn(7, unit<3>(0)));
    tilted.add_floor();
    contacts = tilted.contacts(1e-3);
    ASSERT_EQ(contacts.size(), 1u);
    EXPECT_NEAR(contacts[0].distance, 1e-5, 1e-9);
}

// A wedge's tip in the corner between a floor and a box on it is nearer to the box's bottom, behind which it has never been, than to its side.
TEST(ContactPoints, TipOfAMeshInACorner)
{
    SurfaceMesh<2> wedge;
    wedge.vertices = {{-0.035, 0.2}, {0, -0.2}, {0.035, 0.2}};
    for (int i = 0; i < 3; ++i)
        wedge.elements.push_back({i, (i + 1) % 3});
    const double degrees = 19.3 * std::numbers::pi / 180;
    Scenery<2> s;
    s.add(make_box<2>({0.4, 0.3}), {0.8, 0.15});
    s.solids.back().motion = Motion::fixed;
    const Rotation<2> lean(degrees);
    s.add(make_mesh<2>(std::move(wedge), "wedge"), Vec<2>(0.603, 1e-4) - lean * Vec<2>(0, -0.2), lean);
    const auto contacts = s.contacts(1e-3);
    ASSERT_EQ(contacts.size(), 1u);
    EXPECT_NEAR(std::abs(contacts[0].normal[0]), 1, 1e-12);
    EXPECT_NEAR(contacts[0].distance, -0.003, 1e-9);
}

// A box's corner and an outline's at one place, to round-off: the outline is beside the box, on both sides of the plane of its top.
TEST(ContactPoints, CornerOfAMeshAtTheCornerOfABox)
{
    for (int k = 0; k < 24; ++k) {
        SurfaceMesh<2> outline;
        outline.vertices = {{0, 0}, {0.07, -0.8}, {0.8, -0.5}, {0.8, 0.65}};
        for (int i = 0; i < 4; ++i)
            outline.elements.push_back({i, (i + 1) % 4});
        Scenery<2> s;
        const Rotation<2> lean((k % 3 - 1) * std::numbers::pi / 180), direction(k * std::numbers::pi / 12);
        s.add(make_box<2>({0.4, 1.0}), Vec<2>(0.61, 0.37) - lean * Vec<2>(0.2, 0.5), lean);
        s.add(make_mesh<2>(std::move(outline), "outline"), Vec<2>(0.61, 0.37) + 1e-11 * (direction * unit<2>(0)));
        const auto contacts = s.contacts(1e-6);
        ASSERT_FALSE(contacts.empty()) << k;
        for (const auto& contact : contacts)
            EXPECT_GT(std::abs(contact.normal[0]), 0.99) << k;
    }
}

TEST(ContactPoints, CapsuleOnFloorAndAcross)
{
    Scenery<3> s;
    s.add(make_capsule<3>(0.2, 1), {0, 0, 0.2});
    s.add(make_capsule<3>(0.2, 1), {0.1, 0, 0.6 + 1e-5}, turn(90, unit<3>(2)));
    s.add_floor();
    const auto contacts = s.contacts(0.01);
    ASSERT_EQ(contacts.size(), 3u);
    EXPECT_EQ(contacts[0].b, 1);
    EXPECT_NEAR(contacts[0].distance, 1e-5, 1e-12);
    EXPECT_NEAR(contacts[0].x[0], 0.1, 1e-9);
    EXPECT_NEAR(std::abs(contacts[1].x[0]), 0.5, 1e-12);
    EXPECT_NEAR(contacts[1].x[0] + contacts[2].x[0], 0, 1e-12);
}

TEST(ContactPoints, BallInACornerTouchesThreeSides)
{
    Scenery<3> s;
    s.add(make_ball<3>(0.25), {0.75 - 1e-4, 0.75 - 2e-4, 0.75 - 3e-4});
    s.add(make_inside_out<3>(make_box<3>({2, 2, 2})), Vec<3>::Zero());
    auto contacts = s.contacts(0.01);
    ASSERT_EQ(contacts.size(), 3u);
    std::sort(contacts.begin(), contacts.end(), [](const auto& p, const auto& q) { return p.distance < q.distance; });
    for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(contacts[k].distance, (k + 1) * 1e-4, 1e-12);
        EXPECT_NEAR(contacts[k].normal[k], -1, 1e-12);
    }
}

// A blunt ridge of a container's wall, between facets of one smooth patch, touches the face of a box.
TEST(ContactPoints, ARidgeOfAContainerTouchesAFace)
{
    Scenery<2> s;
    s.add(make_box<2>({1, 0.5}), {0, 0.3499});
    const SurfaceMesh<2> hollow{
        {{-1, 0}, {0, 0.1}, {1, 0}, {1, 1}, {-1, 1}}, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 0}}, {0, 0, 1, 2, 3}};
    s.add(make_inside_out<2>(make_mesh<2>(hollow, "hollow")), Vec<2>::Zero());
    const auto contacts = s.contacts(0.01);
    ASSERT_EQ(contacts.size(), 1u);
    EXPECT_NEAR(contacts[0].distance, -1e-4, 1e-12);
    EXPECT_NEAR(contacts[0].normal[1], 1, 1e-12);
}

TEST(ContactPoints, AcrossAPeriodicSide)
{
    Scenery<2> s;
    s.period = {20, 0};
    s.add(make_ball<2>(0.5), {9.75, 0});
    s.add(make_ball<2>(0.5), {-9.2, 0});
    const auto contacts = s.contacts(0.1);
    ASSERT_EQ(contacts.size(), 1u);
    EXPECT_NEAR(contacts[0].distance, 0.05, 1e-12);
    EXPECT_NEAR(contacts[0].normal[0], -1, 1e-12);
    EXPECT_NEAR(contacts[0].shift[0], 20, 1e-12);
}

} // namespace
} // namespace gapflow
