// The thickness that a grid with cells of size 1 sees.
#include "gapflow/geometry/thickness.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gapflow {
namespace {

using std::numbers::pi;
constexpr double most = 2;

template <int D>
Thickness<D> seen(const Shape<D>& shape, double angle = 0.3)
{
    Pose<D> pose;
    pose.position[0] = 20.1;
    if constexpr (D == 2)
        pose.rotation = Rotation<2>(angle);
    else
        pose.rotation = Eigen::AngleAxisd(angle, Vec<3>(1, 2, 3).normalized());
    return sheet_thickness<D>(PlacedShape<D>(shape, pose), 1, most);
}

/// Through the points, counter-clockwise.
std::unique_ptr<Shape<2>> polygon(const std::vector<Vec<2>>& points)
{
    SurfaceMesh<2> mesh;
    mesh.vertices = points;
    for (int i = 0; i < static_cast<int>(points.size()); ++i)
        mesh.elements.push_back({i, (i + 1) % static_cast<int>(points.size())});
    return make_mesh<2>(std::move(mesh), "polygon");
}

/// A blade along x, twisted about it: columns of four corners.
std::unique_ptr<Shape<3>> blade(double length, double width, double thickness, double twist, int pieces)
{
    SurfaceMesh<3> mesh;
    for (int i = 0; i <= pieces; ++i) {
        const double x = length * i / pieces, angle = twist * i / pieces;
        for (const auto& [y, z] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}) {
            const Eigen::Rotation2D<double> turn(angle);
            const Vec<2> at = turn * Vec<2>(y * width, z * thickness);
            mesh.vertices.emplace_back(x, at[0], at[1]);
        }
    }
    const auto quad = [&](int a, int b, int c, int d) {
        mesh.elements.push_back({a, b, c});
        mesh.elements.push_back({a, c, d});
    };
    for (int i = 0; i < pieces; ++i)
        for (int k = 0; k < 4; ++k)
            quad(4 * i + k, 4 * i + (k + 1) % 4, 4 * i + 4 + (k + 1) % 4, 4 * i + 4 + k);
    quad(3, 2, 1, 0);
    quad(4 * pieces, 4 * pieces + 1, 4 * pieces + 2, 4 * pieces + 3);
    return make_mesh<3>(std::move(mesh), "blade");
}

/// Half thickness of a NACA four-digit section with a closed trailing edge.
double naca(double x, double t)
{
    return 5 * t * (0.2969 * std::sqrt(x) - 0.126 * x - 0.3516 * x * x + 0.2843 * x * x * x - 0.1036 * x * x * x * x);
}

std::unique_ptr<Shape<2>> section(double chord, double t)
{
    std::vector<Vec<2>> points;
    constexpr int n = 100;
    for (int i = 0; i < 2 * n; ++i) {
        const double x = 0.5 * (1 + std::cos(pi * i / n));
        points.emplace_back(chord * x, (i < n ? 1 : -1) * chord * (i % n ? naca(x, t) : 0.0));
    }
    return polygon(points);
}

TEST(Thickness, OfExactShapes)
{
    EXPECT_NEAR(seen<2>(*make_box<2>({10, 0.5})).value, 0.5, 1e-6);
    EXPECT_NEAR(seen<3>(*make_box<3>({8, 6, 0.75})).value, 0.75, 1e-6);
    EXPECT_NEAR(seen<3>(*make_box<3>({8, 1.9, 9})).value, 1.9, 1e-5);
    EXPECT_NEAR(seen<2>(*make_ball<2>(0.25)).value, 0.5, 1e-6);
    EXPECT_NEAR(seen<3>(*make_ball<3>(0.9)).value, 1.8, 1e-6);
    EXPECT_NEAR(seen<3>(*make_capsule<3>(0.3, 9)).value, 0.6, 1e-6);
    EXPECT_NEAR(seen<3>(*make_cylinder(5, 0.5)).value, 0.5, 1e-6);
    EXPECT_NEAR(seen<3>(*make_cylinder(0.4, 12)).value, 0.8, 1e-6);
    for (const double size : {2.0, 2.5, 20.0}) { // corners and edges are not thin
        EXPECT_EQ(seen<2>(*make_box<2>({size, size})).value, most) << size;
        EXPECT_EQ(seen<3>(*make_box<3>({size, size, size})).value, most) << size;
        EXPECT_EQ(seen<3>(*make_ball<3>(0.5 * size)).value, most) << size;
    }
    EXPECT_EQ(seen<2>(*make_half_space<2>({0, 1})).value, most);
    EXPECT_EQ(seen<2>(*make_inside_out<2>(make_box<2>({10, 0.5}))).value, most); // a container of half a cell
}

TEST(Thickness, OfATwistedBladeThatItsBoundsHide)
{
    for (const int pieces : {12, 60}) {
        const auto shape = blade(24, 8, 0.75, pi / 2, pieces);
        EXPECT_GT((shape->bounds().high - shape->bounds().low).minCoeff(), 5);
        EXPECT_NEAR(seen<3>(*shape).value, 0.75, pieces == 60 ? 0.05 : 0.25)
            << pieces; // few: its two sides are bent along other diagonals
    }
    EXPECT_EQ(seen<3>(*blade(24, 8, 2.2, pi / 2, 60)).value, most);
}

TEST(Thickness, OfAFinOnAThickBodyButNotOfARidge)
{
    const auto finned = [](double fin) {
        return polygon({{0, 0}, {10, 0}, {10, 10}, {5.5, 10}, {5.5, 10 + fin}, {5, 10 + fin}, {5, 10}, {0, 10}});
    };
    const Thickness<2> fin = seen<2>(*finned(8), 0);
    EXPECT_NEAR(fin.value, 0.5, 1e-6);
    EXPECT_NEAR(fin.at[0], 20.1 + 5.25, 1e-6); // in the fin
    EXPECT_GT(fin.at[1], 11);
    EXPECT_EQ(seen<2>(*finned(1.5)).value, most);
    // A tube's wall.
    SurfaceMesh<2> tube;
    for (int k = 0; k < 2; ++k)
        for (int i = 0; i < 64; ++i) {
            const double angle = (k ? -2 : 2) * pi * i / 64, radius = 10 - 0.6 * k;
            tube.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
            tube.elements.push_back({64 * k + i, 64 * k + (i + 1) % 64});
        }
    EXPECT_NEAR(seen<2>(*make_mesh<2>(tube, "tube")).value, 0.6, 0.02);
}

TEST(Thickness, NotOfWedgesAndSpikes)
{
    const auto wedge = [](double degrees) {
        const double half = 20 * std::tan(degrees * pi / 360);
        return polygon({{0, 0}, {20, -half}, {20, half}});
    };
    for (const double degrees : {20.0, 30.0, 45.0, 60.0})
        EXPECT_EQ(seen<2>(*wedge(degrees)).value, most) << degrees;
    std::vector<Vec<2>> star;
    for (int i = 0; i < 24; ++i)
        star.push_back((i % 2 ? 5 : 12) * Vec<2>(std::cos(pi * i / 12), std::sin(pi * i / 12)));
    EXPECT_EQ(seen<2>(*polygon(star)).value, most);
    for (Vec<2>& x : star)
        x *= 0.25; // its middle is 2.2 cells wide
    EXPECT_EQ(seen<2>(*polygon(star)).value, most);
    EXPECT_EQ(seen<2>(*section(60, 0.12)).value, most);                      // an aerofoil
    EXPECT_NEAR(seen<2>(*section(10, 0.05)).value, 0.5, 0.1);                // one that is thin all over
    EXPECT_LT(seen<2>(*polygon({{0, 0}, {0.8, 0}, {0.4, 0.7}})).value, 0.6); // small all over, and no two sides face each other
}

TEST(Thickness, CountsWhatGoesOnBeyond)
{
    const auto plate = make_box<2>({10, 0.5});
    const auto thickness = [&](double below) {
        return sheet_thickness<2>(PlacedShape<2>(*plate, Pose<2>()), 1, most,
                                  [&](const Vec<2>&, const Vec<2>& n) { return n[1] < -0.5 ? below : 0.0; })
            .value;
    };
    EXPECT_NEAR(thickness(0), 0.5, 1e-6);
    EXPECT_NEAR(thickness(0.7), 1.2, 1e-6);
    EXPECT_EQ(thickness(2), most);
}

// Of a sheet a thousand cells wide only the part that matters is looked at: all of it has eight million samples.
TEST(Thickness, OfAPartOfAWideSolid)
{
    const auto sheet = make_mesh<3>(make_box<3>({1000, 1000, 0.5})->surface_mesh(), "sheet");
    const PlacedShape<3> placed(*sheet, Pose<3>());
    const Bounds<3> domain{Vec<3>(-5, -5, -5), Vec<3>(5, 5, 5)};
    const Thickness<3> found = sheet_thickness<3>(placed, 1, most, {}, domain);
    EXPECT_NEAR(found.value, 0.5, 1e-6);
    EXPECT_LT(found.at.cwiseAbs().maxCoeff(), 7);
    const Bounds<3> above{Vec<3>(-5, -5, 5), Vec<3>(5, 5, 15)};
    EXPECT_EQ(sheet_thickness<3>(placed, 1, most, {}, above).value, most);
    // of the tip of a thick wedge it is not the thickness of all
    const auto wedge = polygon({{0, 0}, {1000, -600}, {1000, 600}});
    EXPECT_EQ(sheet_thickness<2>(PlacedShape<2>(*wedge, Pose<2>()), 1, most, {}, {Vec<2>(-5, -5), Vec<2>(1, 5)}).value, most);
}

} // namespace
} // namespace gapflow
