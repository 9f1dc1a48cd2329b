// Box, ball, capsule, cylinder, half-space and their inside-out versions.
#include "checks.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/geometry/pose.hpp"

#include <numbers>

namespace gapflow::testing {
namespace {

constexpr double pi = std::numbers::pi;

TEST(Box, HandValues)
{
    const auto box = make_box<3>({2, 4, 6});
    const auto above = box->closest({0.25, 0.5, 3.5});
    EXPECT_EQ(above.distance, 0.5);
    EXPECT_EQ(above.x, Vec<3>(0.25, 0.5, 3));
    EXPECT_EQ(above.normal, Vec<3>(0, 0, 1));
    EXPECT_EQ(above.feature, Feature::face);
    EXPECT_EQ(above.patch, 5);

    const auto edge = box->closest({4, 6, 0});
    EXPECT_EQ(edge.distance, 5);
    EXPECT_EQ(edge.x, Vec<3>(1, 2, 0));
    EXPECT_LT((edge.normal - Vec<3>(0.6, 0.8, 0)).norm(), 1e-15);
    EXPECT_EQ(edge.feature, Feature::edge);

    const auto corner = box->closest({-3, -3, -5});
    EXPECT_EQ(corner.distance, 3);
    EXPECT_EQ(corner.x, Vec<3>(-1, -2, -3));
    EXPECT_EQ(corner.feature, Feature::corner);

    const auto inside = box->closest({-0.75, 1, 0});
    EXPECT_EQ(inside.distance, -0.25);
    EXPECT_EQ(inside.x, Vec<3>(-1, 1, 0));
    EXPECT_EQ(inside.normal, Vec<3>(-1, 0, 0));
    EXPECT_EQ(inside.feature, Feature::face);

    const auto square = make_box<2>({2, 2});
    EXPECT_EQ(square->closest({2, 2}).feature, Feature::corner);
    EXPECT_EQ(square->closest({2, 1}).feature, Feature::face);
}

TEST(Box, TheBorderOfAFaceIsFace)
{
    const auto box = make_box<3>({1, 1, 1});
    for (double over : {0., 1e-14, 4e-13}) {
        const auto p = box->closest({0.5 + over, 0.1, 0.7});
        EXPECT_EQ(p.feature, Feature::face);
        EXPECT_EQ(p.normal, Vec<3>(0, 0, 1));
    }
    EXPECT_EQ(box->closest({0.5 + 1e-11, 0.1, 0.7}).feature, Feature::edge);
    EXPECT_EQ(box->closest({0.5, 0.5, 0.5}).feature, Feature::face);
}

TEST(Box, TinyDistancesAreExact)
{
    const auto box = make_box<3>({1, 0.5, 0.3});
    const auto placed = PlacedShape<3>(*box, Pose<3>{});
    for (double d : {1e-3, 1e-7, 1e-9, 1e-12}) {
        const double x = 0.5 + d; // rounded: x - 0.5 is exact
        EXPECT_EQ(box->distance({x, 0.1, 0.1}), x - 0.5);
        EXPECT_EQ(placed.closest({x, 0.1, 0.1}).distance, x - 0.5);
        EXPECT_EQ(box->distance({0.1, 0.25 - d, 0.01}), (0.25 - d) - 0.25);
    }
}

TEST(Ball, HandValues)
{
    const auto ball = make_ball<3>(2);
    const auto p = ball->closest({0, 3, 4});
    EXPECT_EQ(p.distance, 3);
    EXPECT_LT((p.x - Vec<3>(0, 1.2, 1.6)).norm(), 1e-15);
    EXPECT_EQ(ball->closest({0, 0, 0}).distance, -2);
    EXPECT_EQ(ball->curvature(0), 0.5);
    for (double d : {1e-7, 1e-9, 1e-12})
        EXPECT_EQ(ball->distance({0, 2 + d, 0}), (2 + d) - 2);
}

TEST(Capsule, HandValues)
{
    const auto capsule = make_capsule<3>(0.5, 2);
    EXPECT_EQ(capsule->distance({0.3, 3, 4}), 4.5);
    EXPECT_EQ(capsule->closest({0.3, 3, 4}).patch, 2);
    EXPECT_EQ(capsule->closest({4, 4, 0}).distance, 4.5);
    EXPECT_EQ(capsule->closest({4, 4, 0}).patch, 1);
    EXPECT_EQ(capsule->closest({-4, 0, 0}).patch, 0);
    const auto stadium = make_capsule<2>(0.5, 2);
    EXPECT_EQ(stadium->closest({0.3, -1}).patch, 2);
    EXPECT_EQ(stadium->closest({0.3, 1}).patch, 3);
    EXPECT_EQ(stadium->curvature(3), 0);
    EXPECT_EQ(stadium->curvature(0), 2);
    EXPECT_EQ(stadium->distance({0.3, 0.5 + 1e-12}), (0.5 + 1e-12) - 0.5);
    EXPECT_DOUBLE_EQ(stadium->mass_properties().volume, 2 + pi / 4);
    EXPECT_DOUBLE_EQ(capsule->mass_properties().volume, pi / 2 + pi / 6);
}

TEST(Cylinder, HandValues)
{
    const auto cylinder = make_cylinder(1, 4);
    EXPECT_EQ(cylinder->closest({1, 3, 4}).distance, 4);
    EXPECT_EQ(cylinder->closest({1, 3, 4}).patch, 2);
    EXPECT_EQ(cylinder->closest({-3, 0.5, 0}).patch, 0);
    EXPECT_EQ(cylinder->closest({-3, 0.5, 0}).x, Vec<3>(-2, 0.5, 0));
    const auto rim = cylinder->closest({5, 0, 5});
    EXPECT_EQ(rim.distance, 5);
    EXPECT_EQ(rim.feature, Feature::edge);
    EXPECT_LT((rim.normal - Vec<3>(0.6, 0, 0.8)).norm(), 1e-15);
    EXPECT_EQ(cylinder->closest({3, 0, 1}).feature, Feature::face);
    EXPECT_EQ(cylinder->closest({1.75, 0, 0.5}).distance, -0.25);
    EXPECT_EQ(cylinder->curvature(2), 1);
    EXPECT_EQ(cylinder->curvature(0), 0);
    EXPECT_DOUBLE_EQ(cylinder->mass_properties().inertia(0, 0), 2 * pi);
    EXPECT_DOUBLE_EQ(cylinder->mass_properties().inertia(1, 1), 4 * pi * (1. / 4 + 16. / 12));
}

TEST(Cylinder, MiddleOfTwoRimVerticesGoesToTheRim)
{
    const auto cylinder = make_cylinder(0.7, 3);
    const Vec<3> middle = 0.5 * (Vec<3>(1.5, 0.7, 0) + Vec<3>(1.5, 0, 0.7));
    const Vec<3> rim = cylinder->onto(middle, 2);
    EXPECT_EQ(rim[0], 1.5);
    EXPECT_NEAR(rim.tail<2>().norm(), 0.7, 2e-16);
    EXPECT_EQ(cylinder->onto(rim, 1), rim);
    EXPECT_LT((cylinder->onto(cylinder->onto(middle, 1), 2) - rim).norm(), 1e-15);
}

TEST(HalfSpace, HandValues)
{
    const auto wall = make_half_space<3>({0, 0, 2});
    EXPECT_EQ(wall->distance({5, 6, 1e-12}), 1e-12);
    EXPECT_EQ(wall->closest({5, 6, -2}).x, Vec<3>(5, 6, 0));
    EXPECT_EQ(wall->bounds().high[2], 0);
    EXPECT_TRUE(std::isinf(wall->bounds().high[0]));
    EXPECT_EQ(wall->planes().size(), 1u);
    EXPECT_TRUE(wall->surface_mesh().elements.empty());
    const auto slope = make_half_space<2>({3, 4});
    EXPECT_DOUBLE_EQ(slope->distance({3, 4}), 5);
}

TEST(InsideOut, TurnsEverything)
{
    const auto box = make_inside_out<3>(make_box<3>({2, 4, 6}));
    const auto p = box->closest({0.9, 1.5, 0});
    EXPECT_DOUBLE_EQ(p.distance, 0.1);
    EXPECT_EQ(p.normal, Vec<3>(-1, 0, 0));
    EXPECT_EQ(p.feature, Feature::face);
    EXPECT_EQ(box->distance({2, 0, 0}), -1);
    EXPECT_TRUE(box->complement());
    EXPECT_TRUE(box->inside_out());
    EXPECT_EQ(box->planes().size(), 6u);
    EXPECT_EQ(box->mass_properties().volume, 48);
    EXPECT_EQ(make_inside_out<2>(make_ball<2>(2))->curvature(0), -0.5);
}

TEST(Shapes, BadParametersAreRefused)
{
    EXPECT_EQ(error_of([] { make_box<2>({1, -1}); }), "box: size along y = -1 is not allowed; give a length > 0");
    EXPECT_THAT(error_of([] { make_ball<3>(0); }), ::testing::StartsWith("ball: radius = 0"));
    EXPECT_THROW(make_capsule<3>(1, NAN), InputError);
    EXPECT_THROW(make_cylinder(1, INFINITY), InputError);
    EXPECT_THROW(make_half_space<3>({0, 0, 0}), InputError);
}

// Rays from outside enter where the distance falls to 0 first, and nowhere else: near, far, along faces.
template <int D>
void check_entries(const Shape<D>& shape, double reach, int rays = 4000)
{
    std::mt19937 random(11);
    int hits = 0, misses = 0;
    for (int k = 0; k < rays; ++k) {
        const Vec<D> x = random_point<D>(random, reach);
        Vec<D> u = random_point<D>(random, 1).normalized();
        if (k % 4 == 0) // along an axis
            u = (k % 8 ? 1 : -1) * unit<D>(k / 8 % D);
        if (shape.distance(x) <= 0)
            continue;
        const std::optional<double> t = shape.entry(x, u);
        ASSERT_TRUE(t.has_value());
        const double end = std::isfinite(*t) ? *t : 4 * reach;
        double least = std::numeric_limits<double>::infinity();
        for (int i = 0; i < 200; ++i)
            least = std::min(least, shape.distance(x + i / 200.0 * end * u));
        EXPECT_GT(least, -1e-14 * reach);
        if (std::isfinite(*t)) {
            EXPECT_NEAR(shape.distance(x + *t * u), 0, 1e-14 * reach);
        }
        ++(std::isfinite(*t) ? hits : misses);
    }
    EXPECT_GT(hits, rays / 40);
    EXPECT_GT(misses, rays / 40);
}
TEST(Shapes, RaysEnterWhereTheDistanceVanishes)
{
    check_entries<2>(*make_ball<2>(0.7), 2);
    check_entries<3>(*make_ball<3>(0.7), 2);
    check_entries<2>(*make_box<2>({1.5, 0.4}), 2);
    check_entries<3>(*make_box<3>({1.5, 0.4, 1.0}), 2);
    check_entries<2>(*make_half_space<2>({1.0, 2.0}), 2);
    check_entries<3>(*make_half_space<3>({0.0, 0.0, 1.0}), 2);
    check_entries<3>(*make_mesh<3>(make_box<3>({1.5, 0.4, 1.0})->surface_mesh(), "box"), 2, 400);
    check_entries<3>(*make_mesh<3>(make_ball<3>(0.7)->display_mesh(1e-2), "ball"), 2, 400);
    const double hollow[6][2] = {{-0.7, -0.7}, {0.7, -0.7}, {0.7, -0.5}, {-0.4, -0.5}, {-0.4, 0.7}, {-0.7, 0.7}};
    SurfaceMesh<2> angle;
    for (int i = 0; i < 6; ++i) {
        angle.vertices.emplace_back(hollow[i][0], hollow[i][1]);
        angle.elements.push_back({i, (i + 1) % 6});
    }
    check_entries<2>(*make_mesh<2>(angle, "angle"), 2, 400);
    EXPECT_FALSE(make_capsule<3>(0.5, 1.0)->entry({2, 0, 0}, {-1, 0, 0}));
}

TEST(PlacedShape, QueriesInTheWorld)
{
    const auto box = make_box<3>({2, 4, 6});
    Pose<3> pose;
    pose.position = {10, 0, 0};
    pose.rotation = Eigen::AngleAxisd(pi / 2, Vec<3>::UnitZ()); // body x along world y
    const PlacedShape<3> placed(*box, pose);
    const auto p = placed.closest({10.5, 1.5, 1});
    EXPECT_NEAR(p.distance, 0.5, 1e-15);
    EXPECT_LT((p.x - Vec<3>(10.5, 1, 1)).norm(), 1e-14);
    EXPECT_LT((p.normal - Vec<3>(0, 1, 0)).norm(), 1e-15);
    EXPECT_LT((placed.patch_normal(p.x, p.patch) - p.normal).norm(), 1e-15);
    EXPECT_LT((placed.onto({10.5, 1.5, 1}, p.patch) - p.x).norm(), 1e-14);
    EXPECT_NEAR(placed.shifted({0, 5, 0}).distance({10.5, 6.5, 1}), 0.5, 1e-14);
    const auto square = make_box<2>({2, 4});
    const PlacedShape<2> turned(*square, {Vec<2>(1, 1), Rotation<2>(pi / 2)});
    EXPECT_NEAR(turned.distance({1, 3}), 1, 1e-15);
}

template <int D>
std::vector<std::unique_ptr<Shape<D>>> bounded_shapes()
{
    std::vector<std::unique_ptr<Shape<D>>> shapes;
    Vec<D> size = Vec<D>::Constant(0.6);
    size[0] = 2;
    shapes.push_back(make_box<D>(size));
    shapes.push_back(make_ball<D>(0.8));
    shapes.push_back(make_capsule<D>(0.4, 1.1));
    shapes.push_back(make_capsule<D>(0.7, 0.1));
    if constexpr (D == 3) {
        shapes.push_back(make_cylinder(0.5, 2));
        shapes.push_back(make_cylinder(1, 0.1));
    }
    return shapes;
}

template <int D>
void check_all()
{
    for (auto& shape : bounded_shapes<D>()) {
        check_distances(*shape, 2);
        check_mesh(*shape, shape->surface_mesh(), 2);
        check_mesh(*shape, shape->display_mesh(1e-3), 2);
        check_mass(*shape, 1e-3, 0.02);
        const Bounds<D> bounds = shape->bounds();
        const auto turned = make_inside_out<D>(std::move(shape));
        check_distances(*turned, 2);
        check_mesh(*turned, turned->surface_mesh(), 2);
        Vec<D> high = Vec<D>::Zero();
        for (const Vec<D>& x : turned->surface_mesh().vertices)
            high = high.cwiseMax(x);
        EXPECT_TRUE((high.array() <= bounds.high.array() + 1e-15).all());
        EXPECT_EQ(bounds.low, -bounds.high);
    }
}

TEST(Shapes, DistancesMeshesAndMassIn2D)
{
    check_all<2>();
}
TEST(Shapes, DistancesMeshesAndMassIn3D)
{
    check_all<3>();
}

TEST(Shapes, DisplayMeshesKeepTheirTolerance)
{
    for (const auto& shape : bounded_shapes<3>())
        for (double tolerance : {1e-2, 1e-3}) {
            const SurfaceMesh<3> mesh = shape->display_mesh(tolerance);
            for (const auto& e : mesh.elements)
                ASSERT_LT(std::abs(shape->distance((mesh.vertices[e[0]] + mesh.vertices[e[1]] + mesh.vertices[e[2]]) / 3)),
                          tolerance);
        }
}

TEST(Shapes, MassConvergesWithSecondOrder)
{
    for (const auto& shape : {make_capsule<3>(0.4, 1.1), make_cylinder(0.5, 2), make_ball<3>(1)}) {
        const auto error = [&](double tolerance) {
            return (mass_properties_of(shape->display_mesh(tolerance)).inertia - shape->mass_properties().inertia).norm();
        };
        EXPECT_GT(error(4e-3) / error(2.5e-4), 9); // sagitta: error ~ tolerance, levels are discrete
    }
}

} // namespace
} // namespace gapflow::testing
