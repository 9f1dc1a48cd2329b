// Triangle meshes and polygons: against the exact shapes, and broken ones.
#include "checks.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/geometry/mesh_check.hpp"

#include <chrono>
#include <numbers>
#include <set>

namespace gapflow::testing {
namespace {

constexpr double pi = std::numbers::pi;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::unique_ptr<Shape<3>> mesh_of(const SurfaceMesh<3>& mesh)
{
    const TemporaryFile file("mesh.obj", obj_text(mesh));
    return make_mesh<3>(file.path(), 1);
}

/// Each triangle into four.
SurfaceMesh<3> refined(const SurfaceMesh<3>& mesh)
{
    SurfaceMesh<3> fine{mesh.vertices, {}, {}};
    std::map<std::pair<int, int>, int> known;
    const auto middle = [&](int a, int b) {
        const auto [entry, added] = known.try_emplace(std::minmax(a, b), int(fine.vertices.size()));
        if (added)
            fine.vertices.push_back(0.5 * (mesh.vertices[a] + mesh.vertices[b]));
        return entry->second;
    };
    for (const auto& e : mesh.elements) {
        const int a = middle(e[1], e[2]), b = middle(e[2], e[0]), c = middle(e[0], e[1]);
        fine.elements.insert(fine.elements.end(), {{e[0], c, b}, {c, e[1], a}, {b, a, e[2]}, {a, b, c}});
    }
    return fine;
}

void expect_same(const Shape<3>& mesh, const Shape<3>& exact, const Vec<3>& x)
{
    SCOPED_TRACE(::testing::Message() << "x = " << x.transpose());
    const auto p = mesh.closest(x), q = exact.closest(x);
    ASSERT_NEAR(p.distance, q.distance, 1e-14);
    ASSERT_EQ(p.feature, q.feature);
    ASSERT_LT((x - p.x - p.distance * p.normal).norm(), 1e-14);
    if (q.distance > 0) { // inside, two faces may be as near
        ASSERT_LT((p.x - q.x).norm(), 1e-14);
        if (q.distance > 1e-9) {
            ASSERT_LT((p.normal - q.normal).norm() * q.distance, 1e-15);
        }
    }
}

// Rays that run exactly through vertices and edges: none slips between two facets.
TEST(Mesh, RaysMeetVerticesAndEdges)
{
    const SurfaceMesh<3> surface = make_ball<3>(0.7)->display_mesh(1e-3);
    const auto mesh = make_mesh<3>(surface, "ball");
    const auto expect_met = [&](const Vec<3>& at) {
        for (const Vec<3>& from : {Vec<3>(3 * at), Vec<3>(3 * at + Vec<3>(0.5, -0.3, 0.2))}) {
            const std::optional<double> t = mesh->entry(from, (at - from).normalized());
            ASSERT_TRUE(t.has_value());
            ASSERT_NEAR(*t, (at - from).norm(), 1e-11);
        }
    };
    for (const Vec<3>& x : surface.vertices)
        expect_met(x);
    for (const auto& e : surface.elements)
        expect_met(0.5 * (surface.vertices[e[0]] + surface.vertices[e[1]]));
}

TEST(Mesh, CubeEqualsTheBox)
{
    const auto box = make_box<3>({1, 0.5, 0.75});
    SurfaceMesh<3> surface = box->surface_mesh();
    for (int level = 0; level < 3; ++level, surface = refined(surface)) {
        const auto mesh = mesh_of(surface);
        std::mt19937 random(3);
        for (int k = 0; k < 2000; ++k)
            expect_same(*mesh, *box, random_point<3>(random, 1));
        // On planes, edges and corners of the faces, and next to them.
        for (double x : {0.2, 0.5, 0.5 + 1e-14, 0.5 - 1e-9, 0.5 + 1e-9, 0.8})
            for (double y : {0., 0.25, 0.25 - 1e-9, 0.25 + 1e-7, 0.6})
                for (double z : {0.1, 0.375, 0.375 + 1e-9, 0.375 + 1e-7, 0.7})
                    for (double sign : {-1., 1.})
                        expect_same(*mesh, *box, {sign * x, y, sign * z});
        check_distances(*mesh, 1, 300);
        check_mesh(*mesh, mesh->surface_mesh(), 1);
        std::set<int> patches;
        for (int patch : mesh->surface_mesh().patch) {
            patches.insert(patch);
            EXPECT_EQ(mesh->curvature(patch), 0);
        }
        EXPECT_EQ(patches.size(), 6u);
        EXPECT_NEAR(mesh->mass_properties().volume, 0.375, 1e-15);
        EXPECT_LT((mesh->mass_properties().inertia - box->mass_properties().inertia).norm(), 1e-15);
        EXPECT_EQ(mesh->bounds().high, box->bounds().high);
    }
}

TEST(Mesh, TinyDistancesAreExact)
{
    const auto mesh = mesh_of(refined(make_box<3>({1, 1, 1})->surface_mesh()));
    for (double d : {1e-7, 1e-9, 1e-12}) {
        EXPECT_EQ(mesh->distance({0.5 + d, 0.1, 0.2}), (0.5 + d) - 0.5);
        EXPECT_EQ(mesh->distance({0.01, 0.5 - d, 0.2}), (0.5 - d) - 0.5);
    }
}

TEST(Mesh, SphereAgainstTheExactOne)
{
    const auto ball = make_ball<3>(1);
    const auto mesh = mesh_of(ball->display_mesh(1e-3));
    check_distances(*mesh, 2, 500, true);
    check_mesh(*mesh, mesh->surface_mesh(), 1);
    std::mt19937 random(3);
    for (int k = 0; k < 1000; ++k) {
        const Vec<3> x = random_point<3>(random, 2);
        const auto p = mesh->closest(x);
        ASSERT_NEAR(p.distance, ball->distance(x), 1e-3);
        ASSERT_EQ(p.feature, Feature::face);
        ASSERT_EQ(p.patch, 0);
        ASSERT_GT(p.normal.dot(x.normalized()), 0.98);
    }
    EXPECT_NEAR(mesh->curvature(0), 1, 0.1);
    EXPECT_NEAR(mesh->mass_properties().volume, 4 * pi / 3, 0.01);
}

TEST(Mesh, CylinderHasItsPatchesRimAndCurvature)
{
    const auto exact = make_cylinder(0.5, 2);
    const SurfaceMesh<3> coarse = exact->display_mesh(1e-3);
    for (const auto& [surface, tolerance] : {std::pair(coarse, 0.01), std::pair(refined(coarse), 0.5)}) {
        const auto mesh = mesh_of(surface);
        EXPECT_EQ(mesh->closest({1.5, 0.75, 0}).feature, Feature::edge);
        EXPECT_EQ(mesh->closest({1.5, 0.8 * std::cos(0.3), 0.8 * std::sin(0.3)}).feature, Feature::edge);
        EXPECT_EQ(mesh->closest({0.3, 0.8, 0}).feature, Feature::face);
        const int side = mesh->closest({0.3, 0.8, 0}).patch, end = mesh->closest({1.3, 0.2, 0}).patch;
        EXPECT_NEAR(mesh->curvature(side), 2, tolerance);
        EXPECT_EQ(mesh->curvature(end), 0);
        EXPECT_EQ(mesh->patch_normal({1, 0.5, 0}, end), Vec<3>(1, 0, 0));
        EXPECT_LT((mesh->patch_normal({1, 0.5, 0}, side) - Vec<3>(0, 1, 0)).norm(), 0.1);
    }
    const auto hollow = make_inside_out<3>(mesh_of(exact->display_mesh(1e-3)));
    EXPECT_LT(hollow->curvature(hollow->closest({0.3, 0.4, 0}).patch), 0);
    EXPECT_GT(hollow->distance({0.3, 0.4, 0}), 0);
}

TEST(Mesh, ConeTipIsACorner)
{
    SurfaceMesh<3> cone;
    const int n = 64;
    cone.vertices = {{0.5, 0, 0}, {0, 0, 0}};
    for (int i = 0; i < n; ++i) {
        const int a = 2 + i, b = 2 + (i + 1) % n;
        cone.vertices.emplace_back(0, std::cos(2 * pi * i / n), std::sin(2 * pi * i / n));
        cone.elements.push_back({0, a, b});
        cone.elements.push_back({1, b, a});
    }
    const auto mesh = mesh_of(cone);
    EXPECT_EQ(mesh->closest({2, 0, 0}).feature, Feature::face);
    for (auto& x : cone.vertices)
        x[0] *= 4;
    EXPECT_EQ(mesh_of(cone)->closest({3, 0.01, 0}).feature, Feature::corner);
}

TEST(Mesh, TorusInsideAndOutside)
{
    const auto mesh = mesh_of(torus(1, 0.3, 64, 32));
    std::mt19937 random(5);
    for (int k = 0; k < 2000; ++k) {
        const Vec<3> x = random_point<3>(random, 1.5);
        ASSERT_NEAR(mesh->distance(x), std::hypot(std::hypot(x[0], x[1]) - 1, x[2]) - 0.3, 5e-3);
        ASSERT_EQ(mesh->distance(x) < 0, winding_number(mesh->surface_mesh(), x) > 0.5);
    }
    EXPECT_NEAR(mesh->mass_properties().volume, 2 * pi * pi * 0.09, 0.02);
    EXPECT_NEAR(mesh->curvature(0), 1 / 0.3, 0.05);
    EXPECT_LT(mesh->mass_properties().centre.norm(), 1e-14);
}

TEST(Mesh, AllFormatsReadTheSame)
{
    const SurfaceMesh<3> surface = torus(1, 0.25, 24, 12);
    const TemporaryFile obj("t.obj", obj_text(surface)), ascii("a.stl", ascii_stl_text(surface)),
        binary("b.STL", binary_stl_text(surface));
    const auto reference = make_mesh<3>(obj.path(), 2);
    for (const std::string& path : {ascii.path(), binary.path()}) {
        const auto mesh = make_mesh<3>(path, 2);
        EXPECT_EQ(mesh->surface_mesh().vertices.size(), surface.vertices.size());
        EXPECT_EQ(mesh->surface_mesh().elements.size(), surface.elements.size());
        EXPECT_NEAR(mesh->mass_properties().volume, reference->mass_properties().volume, 1e-6);
        EXPECT_NEAR(mesh->distance({3, 1, 0.2}), reference->distance({3, 1, 0.2}), 1e-6);
    }
}

TEST(Mesh, VerticesApartByRoundingAreWelded)
{
    SurfaceMesh<3> loose;
    std::mt19937 random(1);
    for (const SurfaceMesh<3> box = make_box<3>({1, 1, 1})->surface_mesh(); const auto& e : box.elements) {
        const int n = int(loose.vertices.size());
        for (int v : e)
            loose.vertices.push_back(box.vertices[v] + random_point<3>(random, 2e-7));
        loose.elements.push_back({n, n + 1, n + 2});
    }
    EXPECT_EQ(mesh_of(loose)->surface_mesh().vertices.size(), 14u);
}

TEST(Mesh, ObjPolygonsAndNegativeIndices)
{
    const TemporaryFile file("cube.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                                         "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf -5 -8 -4 -1\n");
    EXPECT_DOUBLE_EQ(make_mesh<3>(file.path(), 1)->mass_properties().volume, 1);
}

TEST(Mesh, WhollyInsideOutIsTurned)
{
    SurfaceMesh<3> surface = make_box<3>({1, 1, 1})->surface_mesh();
    for (auto& e : surface.elements)
        std::swap(e[0], e[1]);
    const auto mesh = mesh_of(surface);
    EXPECT_EQ(mesh->distance({1, 0, 0}), 0.5);
    check_mesh(*mesh, mesh->surface_mesh(), 1);
    check_distances(*mesh, 1, 100);
}

SurfaceMesh<3> joined(SurfaceMesh<3> a, const SurfaceMesh<3>& b, const Vec<3>& shift, bool turn)
{
    const int n = int(a.vertices.size());
    for (const Vec<3>& x : b.vertices)
        a.vertices.push_back(x + shift);
    for (auto e : b.elements) {
        if (turn)
            std::swap(e[0], e[1]);
        a.elements.push_back({e[0] + n, e[1] + n, e[2] + n});
    }
    return a;
}

TEST(Mesh, CavitiesMustFaceInward)
{
    const auto outer = make_box<3>({2, 2, 2})->surface_mesh(), inner = make_box<3>({1, 1, 1})->surface_mesh();
    const auto hollow = mesh_of(joined(outer, inner, Vec<3>::Zero(), true));
    EXPECT_NEAR(hollow->mass_properties().volume, 7, 1e-13);
    EXPECT_DOUBLE_EQ(hollow->distance({0.1, 0, 0}), 0.4);
    EXPECT_THAT(error_of([&] { mesh_of(joined(outer, inner, Vec<3>::Zero(), false)); }), HasSubstr("oriented as a solid"));
    EXPECT_THAT(error_of([&] { mesh_of(joined(outer, inner, {3, 0, 0}, true)); }), HasSubstr("oriented as a cavity"));
    // Two boxes that touch in one vertex of the file.
    const auto pair = joined(outer, inner, {1.5, 1.5, 1.5}, false);
    const TemporaryFile touching("touch.stl", ascii_stl_text(pair));
    const auto both = make_mesh<3>(touching.path(), 1);
    EXPECT_EQ(both->surface_mesh().vertices.size(), 27u);
    std::mt19937 random(9);
    for (int k = 0; k < 500; ++k) {
        const Vec<3> x = Vec<3>(1, 1, 1) + random_point<3>(random, 0.5);
        ASSERT_EQ(both->distance(x) < 0, winding_number(pair, x) > 0.5);
    }
}

TEST(Mesh, BrokenSurfacesAreRefused)
{
    const SurfaceMesh<3> box = make_box<3>({1, 1, 1})->surface_mesh();
    SurfaceMesh<3> hole = box, flipped = box, fin = box;
    hole.elements.erase(hole.elements.begin() + 5);
    std::swap(flipped.elements[7][0], flipped.elements[7][1]);
    fin.vertices.emplace_back(2, 2, 2);
    fin.elements.push_back({0, 1, 14});

    const std::string hole_error = error_of([&] { mesh_of(hole); });
    EXPECT_THAT(hole_error, HasSubstr("mesh.obj: edge (0.5 0.5 -0.5) - (0.5 0 0) belongs to one triangle only"));
    EXPECT_THAT(error_of([&] { mesh_of(flipped); }), HasSubstr("face opposite sides"));
    EXPECT_THAT(error_of([&] { mesh_of(fin); }), HasSubstr("belongs to 3 triangles"));
    EXPECT_THROW(mesh_of(hole), InputError);
    const SurfaceMesh<3> flat{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}, {}};
    EXPECT_THAT(error_of([&] { mesh_of(flat); }), HasSubstr("encloses no volume"));
}

TEST(Mesh, BadFilesAreRefused)
{
    EXPECT_THAT(error_of([] { make_mesh<3>("none.obj", 1); }), StartsWith("none.obj: cannot be opened"));
    const auto error = [](const std::string& name, const std::string& text) {
        const TemporaryFile file(name, text);
        return error_of([&] { make_mesh<3>(file.path(), 1); });
    };
    EXPECT_THAT(error("x.obj", "v 0 0 0\nv 1 a 0\n"), HasSubstr("x.obj:2: \"a\" is not a finite number"));
    EXPECT_THAT(error("x.obj", "v 0 0 0\nv 1 1e999 0\n"), HasSubstr("not a finite number"));
    EXPECT_THAT(error("x.obj", "v 0 0 0\nf 1 1 2\n"), HasSubstr("x.obj:2: face corner \"2\" names no vertex"));
    EXPECT_THAT(error("x.obj", "v 0 0 0\nf 1 1\n"), HasSubstr("at least 3 corners"));
    EXPECT_THAT(error("x.obj", "# nothing\n"), HasSubstr("holds no facets"));
    EXPECT_THAT(error("x.ply", "ply"), HasSubstr("use .obj or .stl"));
    EXPECT_THAT(error("x.stl", binary_stl_text(torus(1, 0.2, 4, 3)).substr(0, 300).replace(0, 5, "xxxxx")),
                HasSubstr("cut off"));
    EXPECT_THAT(error("x.stl", "solid\nfacet normal 0 0 1\nvertex 0 0 0\n"), HasSubstr("ends inside a facet"));
    EXPECT_THAT(error("x.stl", "solid\nvertex 0 0 0\nendfacet\n"), HasSubstr("a facet has 1 vertices"));
}

TEST(Mesh, SliversDoNotHarm)
{
    // A box whose top has a collinear triangle along an edge that was split on one side only.
    SurfaceMesh<3> box{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {0.5, 0, 1}},
                       {{0, 3, 2},
                        {0, 2, 1},
                        {4, 6, 7},
                        {4, 5, 6},
                        {4, 8, 5},
                        {0, 1, 8},
                        {1, 5, 8},
                        {0, 8, 4},
                        {1, 2, 6},
                        {1, 6, 5},
                        {2, 3, 7},
                        {2, 7, 6},
                        {3, 0, 4},
                        {3, 4, 7}},
                       {}};
    const auto mesh = mesh_of(box);
    const auto exact = make_box<3>({1, 1, 1});
    std::mt19937 random(3);
    for (int k = 0; k < 1000; ++k) {
        const Vec<3> x = random_point<3>(random, 1), shift = Vec<3>::Constant(0.5);
        const auto p = mesh->closest(x + shift), q = exact->closest(x);
        ASSERT_NEAR(p.distance, q.distance, 1e-14);
        ASSERT_EQ(p.feature, q.feature);
    }
}

TEST(Mesh, QueriesAreFast)
{
    const auto mesh = mesh_of(make_ball<3>(1)->display_mesh(3e-4));
    ASSERT_EQ(mesh->surface_mesh().elements.size(), 20480u);
    std::mt19937 random(3);
    std::vector<Vec<3>> points;
    for (int k = 0; k < 20000; ++k)
        points.push_back(random_point<3>(random, 1).normalized() * 1.03);
    const auto start = std::chrono::steady_clock::now();
    double sum = 0;
    for (const auto& x : points)
        sum += mesh->distance(x);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    EXPECT_NEAR(sum / double(points.size()), 0.03, 1e-3);
    RecordProperty("ns_per_query", int(1e9 * seconds.count() / double(points.size())));
    EXPECT_LT(seconds.count() / double(points.size()), 100e-6); // some 2e-6 on an idle core
}

std::unique_ptr<Shape<2>> polygon(const std::string& text)
{
    const TemporaryFile file("polygon.txt", text);
    return make_mesh<2>(file.path(), 1);
}

TEST(Polygon, SquareEqualsTheBox)
{
    // Clockwise (turned over), an extra vertex on one side, closed by repeating the first.
    const auto mesh = polygon("# square\n-1 -1\n-1 1\n0 1 # middle\n\t1 1\n# still the same loop\n1 -1\n-1 -1\n");
    const auto box = make_box<2>({2, 2});
    EXPECT_EQ(mesh->surface_mesh().elements.size(), 5u);
    std::mt19937 random(3);
    for (int k = 0; k < 2000; ++k) {
        const Vec<2> x = random_point<2>(random, 2);
        const auto p = mesh->closest(x), q = box->closest(x);
        ASSERT_NEAR(p.distance, q.distance, 1e-14);
        ASSERT_EQ(p.feature, q.feature);
        if (q.distance > 0) {
            ASSERT_LT((p.x - q.x).norm(), 1e-14);
        }
    }
    EXPECT_EQ(mesh->closest({1, 1.5}).feature, Feature::face);
    EXPECT_EQ(mesh->closest({0, 1 + 1e-12}).distance, (1 + 1e-12) - 1);
    check_distances(*mesh, 2);
    check_mesh(*mesh, mesh->surface_mesh(), 2);
    EXPECT_DOUBLE_EQ(mesh->mass_properties().volume, 4);
    EXPECT_DOUBLE_EQ(mesh->mass_properties().inertia(0, 0), 4 * 8. / 12);
}

TEST(Polygon, CircleIsSmoothAndCurved)
{
    std::string text;
    for (int i = 0; i < 100; ++i)
        text +=
            std::to_string(3 + 2 * std::cos(2 * pi * i / 100)) + " " + std::to_string(2 * std::sin(2 * pi * i / 100)) + "\n";
    const auto mesh = polygon(text);
    EXPECT_NEAR(mesh->curvature(0), 0.5, 2e-3);
    EXPECT_EQ(mesh->closest({6, 0.01}).feature, Feature::face);
    EXPECT_NEAR(mesh->distance({6, 0}), 1, 1e-5);
    EXPECT_NEAR(mesh->mass_properties().centre[0], 3, 1e-6);
    check_distances(*mesh, 5, 300, true);
}

TEST(Polygon, HolesAndErrors)
{
    const auto ring = polygon("0 0\n4 0\n4 4\n0 4\n\n1 1\n1 3\n3 3\n3 1\n");
    EXPECT_EQ(ring->mass_properties().volume, 12);
    EXPECT_EQ(ring->distance({2, 2.5}), 0.5);
    EXPECT_EQ(ring->distance({2, 3.25}), -0.25);
    EXPECT_THAT(error_of([] { polygon("0 0\n4 0\n4 4\n0 4\n\n1 1\n3 1\n3 3\n1 3\n"); }), HasSubstr("oriented as a solid"));
    EXPECT_THAT(error_of([] { polygon("0 0\n1 0\n\n"); }), HasSubstr("polygon.txt:3: a loop has 2 vertices"));
    EXPECT_THAT(error_of([] { polygon("0 0\n1 0 3\n"); }), HasSubstr("polygon.txt:2: expected \"x y\""));
}

} // namespace
} // namespace gapflow::testing
