// Sheets: the solid around a middle surface, and middle surfaces of which none can be made.
#include "checks.hpp"

#include "gapflow/geometry/mesh_check.hpp"
#include "gapflow/geometry/sheet.hpp"

#include <numbers>

namespace gapflow::testing {
namespace {

using ::testing::HasSubstr;

MassProperties<2> mass_of(const std::vector<Vec<2>>& points, double thickness)
{
    return make_mesh<2>(sheet_surface(polyline(points), thickness), "sheet")->mass_properties();
}

/// n x m squares of two triangles each, bent by `place`.
template <class Place>
SurfaceMesh<3> grid_of_triangles(int n, int m, Place&& place)
{
    SurfaceMesh<3> mesh;
    for (int j = 0; j <= m; ++j)
        for (int i = 0; i <= n; ++i)
            mesh.vertices.push_back(place(double(i) / n, double(j) / m));
    for (int j = 0; j < m; ++j)
        for (int i = 0; i < n; ++i) {
            const int a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
            mesh.elements.push_back({a, b, d});
            mesh.elements.push_back((i + j) % 2 ? std::array{a, d, c} : std::array{c, d, a}); // oriented in any way
        }
    return mesh;
}

TEST(Sheet, StraightPolylineIsABox)
{
    const double t = 0.01;
    const MassProperties<2> mass = mass_of({{0, 0}, {0.7, 0}, {2, 0}}, t), box = make_box<2>(Vec<2>(2, t))->mass_properties();
    EXPECT_NEAR(mass.volume, box.volume, 1e-15);
    EXPECT_LT((mass.centre - Vec<2>(1, 0)).norm(), 1e-14);
    EXPECT_NEAR(mass.inertia(0, 0), box.inertia(0, 0), 1e-14);
}

TEST(Sheet, CornersAreMitredAndEndsFlat)
{
    // Of a right angle the outer border is longer by t, the inner one shorter.
    const double t = 0.2;
    EXPECT_NEAR(mass_of({{0, 0}, {1, 0}, {1, 2}}, t).volume, 3 * t, 1e-15);
    const SurfaceMesh<2> surface = sheet_surface(polyline({{0, 0}, {1, 0}, {1, 2}}), t);
    const auto has = [&](double x, double y) {
        return std::any_of(surface.vertices.begin(), surface.vertices.end(),
                           [&](const Vec<2>& v) { return (v - Vec<2>(x, y)).norm() < 1e-14; });
    };
    EXPECT_EQ(surface.vertices.size(), 6u);
    EXPECT_TRUE(has(0, 0.1) && has(0, -0.1) && has(1.1, -0.1) && has(0.9, 0.1) && has(1.1, 2) && has(0.9, 2));
}

TEST(Sheet, ClosedPolylineIsARing)
{
    std::vector<Vec<2>> points;
    for (int k = 0; k <= 4; ++k)
        points.push_back(Vec<2>(k % 4 == 1 || k % 4 == 2, k % 4 >= 2));
    const double t = 0.1;
    EXPECT_NEAR(mass_of(points, t).volume, (1 + t) * (1 + t) - (1 - t) * (1 - t), 1e-14);
}

TEST(Sheet, OpenMesh)
{
    // Flat, bent by a right angle along a line, and a part of a sphere.
    const double t = 0.02;
    const auto volume = [&](const SurfaceMesh<3>& mesh) {
        return make_mesh<3>(sheet_surface(mesh, t), "sheet")->mass_properties().volume;
    };
    EXPECT_NEAR(volume(grid_of_triangles(3, 2, [](double u, double v) { return Vec<3>(u, 2 * v, 0.5); })), 2 * t, 1e-15);
    EXPECT_NEAR(volume(grid_of_triangles(
                    4, 3, [](double u, double v) { return u < 0.6 ? Vec<3>(2 * u, v, 0) : Vec<3>(1, v, 4 * u - 2); })),
                3 * t, 1e-14);
    const SurfaceMesh<3> cap =
        grid_of_triangles(40, 40, [](double u, double v) { return Vec<3>(u - 0.5, v - 0.5, 0.7).normalized(); });
    double area = 0;
    for (const auto& e : cap.elements)
        area += 0.5 * (cap.vertices[e[1]] - cap.vertices[e[0]]).cross(cap.vertices[e[2]] - cap.vertices[e[0]]).norm();
    EXPECT_NEAR(volume(cap) / (t * area), 1, 2e-4); // t^2 / 12, and the mitres
}

TEST(Sheet, ShellOfAClosedMesh)
{
    const double t = 0.1;
    const SurfaceMesh<3> box = make_box<3>(Vec<3>(1, 1, 1))->display_mesh(1);
    const auto mass = make_mesh<3>(sheet_surface(box, t), "shell")->mass_properties();
    EXPECT_NEAR(mass.volume, std::pow(1 + t, 3) - std::pow(1 - t, 3), 1e-12);
}

template <int D>
std::string refused(const SurfaceMesh<D>& middle, double thickness, bool of_thickness)
{
    try {
        sheet_surface(middle, thickness);
    } catch (const SheetError& error) {
        EXPECT_EQ(error.of_thickness, of_thickness) << error.what();
        return error.what();
    }
    return "accepted";
}

TEST(Sheet, RefusesWhatIsNoSolid)
{
    const std::vector<Vec<2>> bend{{0, 0}, {1, 0}, {1, 0.1}, {2, 0.1}};
    EXPECT_THAT(refused<2>(polyline(bend), 0, true), HasSubstr("give a length > 0"));
    EXPECT_THAT(refused<2>(polyline({{1, 1}, {1, 1}}), 0.1, false), HasSubstr("no extent"));
    EXPECT_THAT(refused<2>(polyline({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, -1}}), 0.1, false),
                HasSubstr("segments 0 and 3 cross at (1 0)"));
    EXPECT_THAT(refused<2>(polyline({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 0}}), 0.1, false),
                HasSubstr("branches or touches itself"));
    EXPECT_THAT(refused<2>(polyline({{0, 0}, {1, 0}, {1, 0.1}, {0, 0.1}}), 0.11, true),
                HasSubstr("give a thickness below 0.1"));
    EXPECT_THAT(refused<2>(polyline({{0, 0}, {1, 0}, {1.3, 0.3}, {1, 0.6}, {0, 0.05}}), 0.1, true),
                HasSubstr("closer to each other than its thickness"));
    EXPECT_THAT(refused<2>(polyline({{0, 0}, {1, 0}}), 1e-6, true), HasSubstr("give at least 4e-06"));
    const auto flat = [](double u, double v) { return Vec<3>(u, v, 0); };
    SurfaceMesh<3> fins = grid_of_triangles(1, 1, flat);
    fins.vertices.push_back(Vec<3>(0.3, 0.6, 1));
    fins.elements.push_back({0, 3, 4});
    EXPECT_THAT(refused<3>(fins, 0.1, false), HasSubstr("belongs to 3 triangles"));
    SurfaceMesh<3> band = grid_of_triangles(12, 1, [](double u, double v) {
        const double a = 2 * std::numbers::pi * u, r = 1 + (v - 0.5) * std::cos(0.5 * a);
        return Vec<3>(r * std::cos(a), r * std::sin(a), (v - 0.5) * std::sin(0.5 * a));
    });
    EXPECT_THAT(refused<3>(band, 0.01, false), HasSubstr("one-sided"));
    SurfaceMesh<3> touching{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}, {}};
    EXPECT_THAT(refused<3>(touching, 0.1, false), HasSubstr("in the point (0 0 0) only"));
}

TEST(Sheet, AsThinAsAMillionthOfItsSize)
{
    for (const double t : {6e-6, 1e-4, 1e-2}) {
        EXPECT_NEAR(mass_of({{0, 0}, {0.5, 0.3}, {0.9, 0.1}}, t).volume / t, std::hypot(0.5, 0.3) + std::hypot(0.4, 0.2), 1e-9);
        const auto mesh =
            grid_of_triangles(8, 8, [](double u, double v) { return Vec<3>(u, v, 0.2 * std::sin(3 * u) * v).eval(); });
        EXPECT_NO_THROW(make_mesh<3>(sheet_surface(mesh, t), "sheet"));
    }
}

} // namespace
} // namespace gapflow::testing
