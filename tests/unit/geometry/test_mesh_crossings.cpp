// Surfaces that cut themselves are refused wherever they are and however they are turned, others are not.
#include "checks.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/geometry/facet_tree.hpp"
#include "gapflow/geometry/mesh_check.hpp"
#include "gapflow/geometry/mesh_crossings.hpp"
#include "gapflow/geometry/mesh_file.hpp"

#include <Eigen/Geometry>

#include <chrono>
#include <numbers>
#include <set>

namespace gapflow::testing {
namespace {

constexpr double pi = std::numbers::pi;
using ::testing::HasSubstr;

double size_of(const SurfaceMesh<3>& mesh)
{
    Vec<3> low = mesh.vertices.front(), high = low;
    for (const Vec<3>& x : mesh.vertices) {
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
    }
    return (high - low).norm();
}

SurfaceMesh<3> moved(SurfaceMesh<3> mesh, const Eigen::Matrix3d& turn, double scale, const Vec<3>& shift)
{
    for (Vec<3>& x : mesh.vertices)
        x = scale * (turn * x) + shift;
    return mesh;
}

Eigen::Matrix3d random_turn(std::mt19937& random)
{
    std::normal_distribution<double> normal;
    Eigen::Quaterniond q;
    q.coeffs() = Eigen::Vector4d(normal(random), normal(random), normal(random), normal(random)).normalized();
    return q.toRotationMatrix();
}

SurfaceMesh<3> joined(SurfaceMesh<3> a, const SurfaceMesh<3>& b, const Vec<3>& shift)
{
    const int n = int(a.vertices.size());
    for (const Vec<3>& x : b.vertices)
        a.vertices.push_back(x + shift);
    for (const auto& e : b.elements)
        a.elements.push_back({e[0] + n, e[1] + n, e[2] + n});
    return a;
}

/// Cube of side 1 around the origin, its sides n x n squares of two triangles.
SurfaceMesh<3> cube(int n)
{
    SurfaceMesh<3> mesh;
    std::map<std::array<int, 3>, int> known;
    const auto vertex = [&](const std::array<int, 3>& at) {
        const auto [entry, added] = known.try_emplace(at, int(mesh.vertices.size()));
        if (added)
            mesh.vertices.push_back(Vec<3>(at[0], at[1], at[2]) / n - Vec<3>::Constant(0.5));
        return entry->second;
    };
    for (int axis = 0; axis < 3; ++axis)
        for (int high = 0; high < 2; ++high)
            for (int i = 0; i < n; ++i)
                for (int k = 0; k < n; ++k) {
                    const auto at = [&](int a, int b) {
                        std::array<int, 3> x{};
                        x[axis] = high * n;
                        x[(axis + (high ? 1 : 2)) % 3] = i + a;
                        x[(axis + (high ? 2 : 1)) % 3] = k + b;
                        return vertex(x);
                    };
                    mesh.elements.push_back({at(0, 0), at(1, 0), at(1, 1)});
                    mesh.elements.push_back({at(0, 0), at(1, 1), at(0, 1)});
                }
    return mesh;
}

std::string verdict(const SurfaceMesh<3>& mesh)
{
    return error_of([&] { closed_surface(mesh, "m"); });
}

using Pairs = std::set<std::pair<int, int>>;

Pairs pairs_through(const SurfaceMesh<3>& mesh)
{
    Pairs pairs;
    for (const auto& crossing : find_crossings(mesh, 1e-6 * size_of(mesh)).through)
        pairs.insert({crossing.first, crossing.second});
    return pairs;
}

/// Pairs that cross by another way: an edge of one goes through the inside of the other, by more than `margin` on all sides.
Pairs pairs_pierced(const SurfaceMesh<3>& mesh, double margin)
{
    Pairs pairs;
    const auto pierces = [&](int f, int g) {
        const auto at = [&](int facet, int i) { return mesh.vertices[mesh.elements[facet][i % 3]]; };
        const Vec<3> normal = (at(g, 1) - at(g, 0)).cross(at(g, 2) - at(g, 0)).normalized();
        for (int i = 0; i < 3; ++i) {
            const double s = normal.dot(at(f, i) - at(g, 0)), t = normal.dot(at(f, i + 1) - at(g, 0));
            if (!(std::abs(s) > margin && std::abs(t) > margin && (s > 0) != (t > 0)))
                continue;
            const Vec<3> x = at(f, i) + s / (s - t) * (at(f, i + 1) - at(f, i));
            bool inside = true;
            for (int k = 0; k < 3; ++k)
                inside = inside && normal.cross((at(g, k + 1) - at(g, k)).normalized()).dot(x - at(g, k)) > margin;
            if (inside)
                return true;
        }
        return false;
    };
    for (int f = 0; f < int(mesh.elements.size()); ++f)
        for (int g = f + 1; g < int(mesh.elements.size()); ++g)
            if (pierces(f, g) || pierces(g, f))
                pairs.insert({f, g});
    return pairs;
}

TEST(FacetTree, NearPairsAreThoseOfAllPairs)
{
    std::mt19937 random(4);
    std::vector<Facet<3>> facets;
    for (int k = 0; k < 200; ++k) {
        const Vec<3> x = random_point<3>(random, 1);
        facets.push_back({{x, x + random_point<3>(random, 0.2), x + random_point<3>(random, 0.2)}, Vec<3>::UnitX()});
    }
    const double margin = 0.05;
    std::multiset<std::pair<int, int>> expected, found;
    for (int f = 0; f < 200; ++f)
        for (int g = f + 1; g < 200; ++g) {
            bool near = true;
            for (int i = 0; i < 3; ++i) {
                const auto range = [&](int facet) {
                    const auto& c = facets[facet].corner;
                    return std::minmax({c[0][i], c[1][i], c[2][i]});
                };
                near = near && range(f).first - range(g).second <= margin && range(g).first - range(f).second <= margin;
            }
            if (near)
                expected.insert({f, g});
        }
    FacetTree<3>(facets, std::vector<int>(200, 0)).for_near_pairs(margin, [&](int f, int g) {
        found.insert(std::minmax(f, g));
        return true;
    });
    EXPECT_GT(expected.size(), 100u);
    EXPECT_EQ(found, expected);
}

TEST(FacetTree, CrossingsOfARayAreTheWindingNumber)
{
    const SurfaceMesh<3> mesh = joined(torus(1, 0.3, 48, 24), cube(3), Vec<3>::Zero());
    std::vector<Facet<3>> facets;
    for (const auto& e : mesh.elements) {
        const Vec<3>&a = mesh.vertices[e[0]], &b = mesh.vertices[e[1]], &c = mesh.vertices[e[2]];
        facets.push_back({{a, b, c}, (b - a).cross(c - a).normalized()});
    }
    const FacetTree<3> tree(facets, std::vector<int>(facets.size(), 0));
    std::mt19937 random(8);
    std::set<int> seen;
    for (int k = 0; k < 500; ++k) {
        const Vec<3> x = random_point<3>(random, 1.4);
        const int crossings = tree.crossings(x, random_point<3>(random, 1));
        ASSERT_NEAR(crossings, winding_number(mesh, x), 1e-9) << x.transpose();
        seen.insert(crossings);
    }
    EXPECT_EQ(seen.size(), 2u);
}

TEST(Crossings, TurnedAndMovedTheSamePairsCross)
{
    // Two tori through each other's tubes, a third apart from them.
    SurfaceMesh<3> mesh = joined(
        torus(1, 0.3, 24, 12),
        moved(torus(1, 0.3, 20, 10), Eigen::AngleAxisd(1.1, Vec<3>(1, 2, 3).normalized()).toRotationMatrix(), 1, {0.2, 0.1, 0}),
        Vec<3>::Zero());
    mesh = joined(mesh, torus(1, 0.3, 16, 8), {0, 0, 3});
    const Pairs expected = pairs_pierced(mesh, 1e-9);
    EXPECT_GT(expected.size(), 50u);
    EXPECT_EQ(pairs_through(mesh), expected);
    EXPECT_THAT(verdict(mesh), HasSubstr("the surface cuts itself: triangles "));
    std::mt19937 random(2);
    for (int k = 0; k < 100; ++k) {
        const double scale = std::pow(10, -4 + 0.08 * k);
        const SurfaceMesh<3> other = moved(mesh, random_turn(random), scale, scale * random_point<3>(random, k % 2 ? 1e5 : 1));
        ASSERT_EQ(pairs_through(other), expected) << k;
    }
}

TEST(Crossings, AllAreFoundInRandomTriangles)
{
    std::mt19937 random(6);
    for (int round = 0; round < 20; ++round) {
        SurfaceMesh<3> soup;
        for (int f = 0; f < 60; ++f) {
            for (int i = 0; i < 3; ++i)
                soup.vertices.push_back(random_point<3>(random, 1));
            soup.elements.push_back({3 * f, 3 * f + 1, 3 * f + 2});
            if (f % 3 == 1) // shares a vertex with the one before
                soup.elements.back()[0] = soup.elements[f - 1][2];
        }
        const double size = size_of(soup);
        const Pairs found = pairs_through(soup), deep = pairs_pierced(soup, 4e-6 * size), any = pairs_pierced(soup, 0);
        ASSERT_GT(found.size(), 100u);
        ASSERT_TRUE(std::includes(found.begin(), found.end(), deep.begin(), deep.end()));
        ASSERT_TRUE(std::includes(any.begin(), any.end(), found.begin(), found.end()));
        for (const auto& crossing : find_crossings(soup, 1e-6 * size).through)
            for (int f : {crossing.first, crossing.second}) {
                Facet<3> facet;
                for (int i = 0; i < 3; ++i)
                    facet.corner[i] = soup.vertices[soup.elements[f][i]];
                facet.normal = (facet.corner[1] - facet.corner[0]).cross(facet.corner[2] - facet.corner[0]).normalized();
                ASSERT_LT(closest_on(facet, crossing.place).distance2, 1e-20); // the place is in both
            }
    }
}

TEST(Crossings, DepthDecides)
{
    const SurfaceMesh<3> box = make_box<3>({1, 1, 1})->surface_mesh();
    std::mt19937 random(12);
    for (const Vec<3>& way : {Vec<3>(1, 0.21, 0.17), Vec<3>(1, 0, 0), Vec<3>(1, 1, 0.3), Vec<3>(1, 1, 1)})
        for (int k = 0; k < 20; ++k) {
            const Eigen::Matrix3d turn = k == 0 ? Eigen::Matrix3d(Eigen::Matrix3d::Identity()) : random_turn(random);
            const auto pair_of = [&](double gap) {
                Vec<3> shift = way;
                for (double& s : shift)
                    s *= s == 1 ? 1 + gap : 1;
                return moved(joined(box, box, shift), turn, 1, Vec<3>::Zero());
            };
            for (double gap : {1e-3, 1e-7, 1e-9, 1e-13})
                ASSERT_EQ(verdict(pair_of(gap)), "no error") << "gap " << gap << " of boxes at " << way.transpose();
            for (double cut : {0.3, 1e-2, 1e-4})
                ASSERT_THAT(verdict(pair_of(-cut)), HasSubstr("the surface cuts itself")) << cut << " " << way.transpose();
        }
}

TEST(Crossings, AlongEdgesOfBoth)
{
    // All that the two surfaces have in common runs along edges of both: no facet passes through another.
    std::mt19937 random(3);
    const SurfaceMesh<3> both = joined(cube(4), cube(4), {0.5, 0.5, 0.5}), beside = joined(cube(4), cube(4), {1, 1, 0.5});
    EXPECT_TRUE(find_crossings(both, 1e-6).through.empty());
    for (int k = 0; k < 20; ++k) {
        const Eigen::Matrix3d turn = k == 0 ? Eigen::Matrix3d(Eigen::Matrix3d::Identity()) : random_turn(random);
        ASSERT_THAT(verdict(moved(both, turn, 1, Vec<3>::Zero())), HasSubstr("cuts itself"));
        ASSERT_EQ(verdict(moved(beside, turn, 1, Vec<3>::Zero())), "no error");
    }
}

TEST(Crossings, FoldsOverASharedEdge)
{
    // A tetrahedron whose base has a flap: out over the edge and back on the same plane.
    const auto folded = [](double open) {
        SurfaceMesh<3> mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.4, 0.3, -open}}, {}, {}};
        mesh.elements = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 2, 4}, {2, 1, 4}, {1, 0, 4}};
        return mesh;
    };
    EXPECT_EQ(verdict(folded(0)), "no error"); // flat base of three
    EXPECT_EQ(verdict(folded(0.2)), "no error");
    SurfaceMesh<3> over = folded(0);
    over.vertices[4] = {0.3, -0.2, 0}; // the base's third vertex beyond its border: two triangles lie over another
    std::mt19937 random(5);
    for (int k = 0; k < 50; ++k) {
        const SurfaceMesh<3> turned = moved(over, k == 0 ? Eigen::Matrix3d(Eigen::Matrix3d::Identity()) : random_turn(random),
                                            1 + k, random_point<3>(random, 100));
        ASSERT_THAT(verdict(turned), HasSubstr("the surface cuts itself: triangles 3 and 5 (from 0) lie on each other at"));
    }
    over.vertices[4] = {0.3, 0.4, 1.4}; // through two sides
    EXPECT_THAT(verdict(over), HasSubstr("cross at"));
}

TEST(Crossings, OfNothingAreNone)
{
    const TemporaryFile needle("x.stl", "solid\nvertex 1 0 0\nvertex 0 0 0\nvertex 0 0 0\nendfacet\n");
    EXPECT_THAT(error_of([&] { make_mesh<3>(needle.path(), 1); }), HasSubstr("encloses no volume"));
    EXPECT_TRUE(find_crossings_along_ridges(SurfaceMesh<3>{}, 1e-6).empty());
}

TEST(Crossings, ValidMeshesAreAccepted)
{
    std::vector<SurfaceMesh<3>> meshes{torus(1, 0.3, 64, 32),
                                       torus(1, 0.999, 64, 32),
                                       cube(7),
                                       make_ball<3>(1)->display_mesh(3e-3),
                                       make_cylinder(0.5, 2)->display_mesh(1e-3),
                                       make_cylinder(0.5, 0.001)->display_mesh(1e-3),
                                       make_capsule<3>(0.2, 1)->display_mesh(1e-3),
                                       read_surface_file<3>(GAPFLOW_TEST_DATA "/../../examples/05_mesh_bodies/torus.obj", 1),
                                       read_surface_file<3>(GAPFLOW_TEST_DATA "/../../examples/05_mesh_bodies/slab.stl", 1)};
    SurfaceMesh<3> sheets = cube(12); // thin plates next to each other
    for (Vec<3>& x : sheets.vertices)
        x[2] *= 1e-4;
    meshes.push_back(joined(sheets, sheets, {0.03, 0.07, 1e-4 + 1e-9}));
    SurfaceMesh<3> blade = cube(20); // ends in a knife's edge
    for (Vec<3>& x : blade.vertices)
        x[2] *= 1e-3 + 0.1 * (0.5 - x[0]);
    meshes.push_back(blade);
    // A collinear triangle along an edge that is split on one side only.
    meshes.push_back({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {0.5, 0, 1}},
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
                      {}});
    std::mt19937 random(11);
    for (std::size_t m = 0; m < meshes.size(); ++m)
        for (int k = 0; k < 10; ++k) {
            const double scale = k == 0 ? 1 : std::pow(10, -6 + 1.2 * k);
            const SurfaceMesh<3> mesh =
                moved(meshes[m], k == 0 ? Eigen::Matrix3d(Eigen::Matrix3d::Identity()) : random_turn(random), scale,
                      scale * random_point<3>(random, k % 3 == 1 ? 1e4 : 1));
            ASSERT_EQ(verdict(mesh), "no error") << "mesh " << m << ", turn " << k;
            if (k % 3 == 1 || m == 9) // plates 1e-9 apart are not in single precision, nor is much of small meshes far away
                continue;
            SurfaceMesh<3> rounded = mesh; // as in a binary STL
            for (Vec<3>& x : rounded.vertices)
                x = x.cast<float>().cast<double>();
            ASSERT_EQ(verdict(rounded), "no error") << "mesh " << m << " in single precision, turn " << k;
        }
}

TEST(Crossings, TheErrorNamesLinesPlaceAndCount)
{
    const SurfaceMesh<3> both =
        joined(make_box<3>({1, 1, 1})->surface_mesh(), make_box<3>({1, 1, 1})->surface_mesh(), {0.7, 0.1, 0.05});
    const TemporaryFile obj("two.obj", obj_text(both)), ascii("two_a.stl", ascii_stl_text(both)),
        binary("two_b.stl", binary_stl_text(both));
    const auto error = [](const TemporaryFile& file) { return error_of([&] { make_mesh<3>(file.path(), 1); }); };
    const auto found = find_crossings(both, 1e-6).through;
    ASSERT_GT(found.size(), 3u);
    const int f = found.front().first, g = found.front().second;
    const std::string more = " and " + std::to_string(found.size() - 1) + " more pairs; unite parts that overlap";
    const auto pair = [](int a, int b) { return std::to_string(a) + " and " + std::to_string(b); };
    EXPECT_THAT(error(obj),
                HasSubstr("two.obj: the surface cuts itself: triangles of lines " + pair(31 + f, 31 + g) + " cross at ("));
    EXPECT_THAT(error(ascii), HasSubstr("triangles of lines " + pair(2 + 7 * f, 2 + 7 * g) + " cross at ("));
    EXPECT_THAT(error(binary), HasSubstr("triangles " + pair(f, g) + " (from 0) cross at ("));
    for (const TemporaryFile* file : {&obj, &ascii, &binary})
        EXPECT_THAT(error(*file), HasSubstr(more));
    const TemporaryFile face("l.obj", "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0.3 0.2 1\n"
                                      "f 5 4 3 2 1 6\nf 1 2 7\nf 2 3 7\nf 3 4 7\nf 4 5 7\nf 5 6 7\nf 6 1 7\n");
    EXPECT_THAT(error(face), HasSubstr("triangles of lines 8 and 8 lie on each other"));
    EXPECT_THAT(error(face), HasSubstr("export faces of more than three corners as triangles"));
}

TEST(Crossings, AHundredThousandTrianglesTakeASecond)
{
    const SurfaceMesh<3> mesh = torus(1, 0.3, 320, 160);
    ASSERT_EQ(mesh.elements.size(), 102400u);
    const auto start = std::chrono::steady_clock::now();
    EXPECT_TRUE(find_crossings(mesh, 1e-6 * size_of(mesh)).through.empty());
    EXPECT_TRUE(find_crossings_along_ridges(mesh, 1e-6 * size_of(mesh)).empty());
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    RecordProperty("ms", int(1e3 * seconds.count()));
    EXPECT_LT(seconds.count(), 10); // some 0.4 on an idle core
}

std::string polygon_error(const std::string& text)
{
    const TemporaryFile file("polygon.txt", text);
    return error_of([&] { make_mesh<2>(file.path(), 1); });
}

TEST(PolygonCrossings, AreNamed)
{
    EXPECT_THAT(polygon_error("# bow\n0 0\n2 2\n2 0\n0 2\n"),
                HasSubstr("polygon.txt: the surface cuts itself: segments of lines 2 and 4 cross at (1 1); put the vertices"));
    EXPECT_THAT(polygon_error("0 0\n3 0\n3 3\n2 3\n2 -1\n1 -1\n1 3\n0 3\n"),
                HasSubstr("lines 1 and 4 cross at (2 0), and 1 more pair;"));
    // Two loops that overlap; the second is named by its own lines.
    EXPECT_THAT(polygon_error("0 0\n4 0\n4 4\n0 4\n\n3 1\n6 1\n6 2\n3 2\n"),
                HasSubstr("segments of lines 2 and 6 cross at (4 1)"));
    // Through vertices of both only.
    EXPECT_THAT(polygon_error("0 0\n4 0\n4 1\n4 2\n4 4\n0 4\n\n2 1\n4 1\n6 1\n6 2\n4 2\n2 2\n"),
                HasSubstr("meet where parts overlap"));
    // Back over its own side.
    EXPECT_THAT(polygon_error("0 0\n4 0\n2 0\n4 4\n0 4\n"), HasSubstr("lines 1 and 2 lie on each other"));
}

TEST(PolygonCrossings, ValidOnesAreAccepted)
{
    EXPECT_EQ(polygon_error("0 0\n4 0\n4 4\n0 4\n\n6 1\n5 3\n4 1\n"), "no error");           // touches in a vertex on a side
    EXPECT_EQ(polygon_error("0 0\n4 0\n4 4\n0 4\n\n1 1\n1 3\n3 3\n3 1\n"), "no error");      // a hole
    EXPECT_EQ(polygon_error("0 0\n4 0\n4 4\n0 4\n\n4.000000001 1\n6 1\n5 3\n"), "no error"); // nearly touches
    std::string star;
    for (int k = 0; k < 400; ++k) {
        const double r = k % 2 ? 0.01 : 1;
        star +=
            std::to_string(1000 + r * std::cos(2 * pi * k / 400)) + " " + std::to_string(r * std::sin(2 * pi * k / 400)) + "\n";
    }
    EXPECT_EQ(polygon_error(star), "no error");
}

} // namespace
} // namespace gapflow::testing
