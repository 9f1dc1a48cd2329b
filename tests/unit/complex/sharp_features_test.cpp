// Sharp corners and edges of polygons, cylinders and meshes: where they divide cells, closure, and the same figures as of boxes.
#include "checks.hpp"

#include <map>
#include <numbers>

namespace gapflow::testing {
namespace {

std::unique_ptr<Shape<2>> polygon(const std::vector<Vec<2>>& corners)
{
    SurfaceMesh<2> mesh;
    mesh.vertices = corners;
    for (int k = 0; k < static_cast<int>(corners.size()); ++k)
        mesh.elements.push_back({k, (k + 1) % static_cast<int>(corners.size())});
    mesh.patch.assign(corners.size(), 0);
    return make_mesh<2>(mesh, "polygon");
}

std::vector<Vec<2>> star(int points, double outer, double inner)
{
    std::vector<Vec<2>> corners;
    for (int k = 0; k < 2 * points; ++k) {
        const double angle = std::numbers::pi * k / points;
        corners.push_back((k % 2 ? inner : outer) * Vec<2>(std::cos(angle), std::sin(angle)));
    }
    return corners;
}

TEST(Polygons, ABoxIsDividedAsABox)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> number(0, 1);
    const Grid<2> grid = unit_grid<2>(16);
    for (int k = 0; k < 50; ++k) {
        const Vec<2> size((0.3 + 4 * number(random)) / 16, std::pow(10, -2 * number(random)) / 4), half = 0.5 * size;
        const Pose<2> at = pose<2>(Vec<2>(0.5 + 0.1 * number(random), 0.5 + 0.1 * number(random)), 6.3 * number(random));
        std::array<std::vector<double>, 2> found;
        for (const bool mesh : {false, true}) {
            Scene<2> scene(grid);
            if (mesh)
                scene.add("box", polygon({-half, {half[0], -half[1]}, half, {-half[0], half[1]}}), at);
            else
                scene.add("box", make_box<2>(size), at);
            const Complex<2> complex = build_complex<2>(grid, scene.solids);
            EXPECT_LE(sums_of(grid, complex, scene.solids).closure, 1e-12);
            for (const CornerLink<2>& link : complex.links) {
                found[mesh].push_back(link.open);
                found[mesh].push_back(link.covered);
            }
            std::sort(found[mesh].begin(), found[mesh].end());
        }
        ASSERT_EQ(found[0].size(), found[1].size()) << k;
        EXPECT_GE(found[0].size(), 8U);
        for (std::size_t i = 0; i < found[0].size(); ++i)
            EXPECT_NEAR(found[0][i], found[1][i], 1e-8) << k;
    }
}

TEST(Polygons, SharpConvexCornersDivide)
{
    const Grid<2> grid = unit_grid<2>(24);
    const auto links = [&](const std::vector<Vec<2>>& corners, bool inside_out = false) {
        Scene<2> scene(grid);
        auto shape = polygon(corners);
        if (inside_out)
            shape = make_inside_out<2>(std::move(shape));
        scene.add("polygon", std::move(shape), pose<2>(Vec<2>(0.507, 0.493), 0.1));
        const Complex<2> complex = build_complex<2>(grid, scene.solids);
        EXPECT_LE(sums_of(grid, complex, scene.solids).closure, 1e-12);
        return complex.links.size();
    };
    EXPECT_EQ(links(star(5, 0.35, 0.17)), 5U);
    EXPECT_EQ(links(star(5, 0.35, 0.17), true), 5U); // the inner ones, seen from inside
    EXPECT_EQ(links(star(3, 0.35, 0.175)), 3U);
    EXPECT_EQ(links(star(24, 0.35, 0.35)), 0U); // a circle
    // A half disk: two corners beside an arc.
    std::vector<Vec<2>> half;
    for (int k = 0; k <= 40; ++k)
        half.push_back(0.3 * Vec<2>(std::cos(std::numbers::pi * k / 40), std::sin(std::numbers::pi * k / 40)));
    EXPECT_EQ(links(half), 2U);
}

TEST(Polygons, RandomOnesAreClosed)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<double> number(0, 1);
    for (int k = 0; k < 100 && !HasFailure(); ++k) {
        const bool periodic = k % 3 == 0;
        const Grid<2> grid = unit_grid<2>(12, all_sides<2>(periodic ? SideKind::periodic : SideKind::wall));
        Scene<2> scene(grid);
        const int points = 2 + static_cast<int>(4 * number(random));
        const double outer = 0.12 + 0.08 * number(random), inner = outer * (0.1 + 0.8 * number(random));
        for (const int side : {0, 1}) {
            Vec<2> x(0.27 + 0.46 * side, 0.5);
            for (int axis = 0; axis < 2; ++axis)
                x[axis] = k % 4 ? x[axis] + 0.06 * (number(random) - 0.5) : std::round(24 * x[axis]) / 24;
            scene.add("star", polygon(star(points, outer, inner)), pose<2>(x, k % 2 ? 6.3 * number(random) : 0));
        }
        const Complex<2> complex = build_complex<2>(grid, scene.solids);
        const ComplexSums<2> sums = sums_of(grid, complex, scene.solids);
        EXPECT_LE(sums.closure, 1e-12) << k;
        for (const auto& flux : sums.flux)
            EXPECT_LE(std::min(flux.head<2>().norm(), std::abs(flux.head<2>().norm() - 12)), 1e-9) << k;
    }
}

Rotation<3> turned(double angle, const Vec<3>& axis)
{
    return Rotation<3>(Eigen::AngleAxisd(angle, axis.normalized()));
}

Pose<3> pose3(const Vec<3>& x, const Rotation<3>& turn)
{
    Pose<3> at = pose<3>(x);
    at.rotation = turn;
    return at;
}

TEST(Rims, CellsOfAnAlignedCylinder)
{
    const Grid<3> grid = unit_grid<3>(12);
    Scene<3> scene(grid);
    scene.add("cylinder", make_cylinder(3.0 / 12, 2.6 / 12),
              pose3(Vec<3>(6.1, 6.2, 5.9) / 12, turned(std::numbers::pi / 2, {0, 1, 0})));
    const Complex<3> complex = build_complex<3>(grid, scene.solids);
    EXPECT_LE(sums_of(grid, complex, scene.solids).closure, 1e-12);
    double length = 0;
    std::map<int, int> links;
    for (const CornerLink<3>& link : complex.links) {
        ++links[complex.cut_cell[complex.part_cell[link.a]]];
        EXPECT_NEAR(std::min(std::abs(link.at[2] - 7.2), std::abs(link.at[2] - 4.6)), 0, 1e-9);
        EXPECT_LE(std::abs((link.at - Vec<3>(6.1, 6.2, 5.9)).head<2>().norm() - 3), 0.1);
        length += 1;
    }
    // Every cell through which a rim passes, but for touches of a corner.
    EXPECT_GE(links.size(), 2 * 20U);
    EXPECT_EQ(links.size(), complex.links.size());
}

TEST(Rims, RandomPosesAreClosed)
{
    std::mt19937 random(11);
    std::uniform_real_distribution<double> number(0, 1);
    double open = 0;
    for (int k = 0; k < 120 && !HasFailure(); ++k) {
        const bool periodic = k % 3 == 0;
        const Grid<3> grid = unit_grid<3>(10, all_sides<3>(periodic ? SideKind::periodic : SideKind::wall));
        Scene<3> scene(grid);
        const Rotation<3> turn = k % 4 ? turned(6.28 * number(random), Vec<3>(number(random), number(random), number(random)))
                                       : turned(std::numbers::pi / 2 * (k % 3), Vec<3>::Unit(k % 2));
        Vec<3> x(number(random), number(random), number(random));
        x = periodic ? Vec<3>(10 * x) : Vec<3>(x + Vec<3>::Constant(4.5));
        if (k % 8 == 0)
            x = (2 * x).array().round() / 2;
        scene.add("cylinder", make_cylinder((1.2 + 2 * number(random)) / 10, std::pow(10, 0.5 - 2 * number(random)) / 10),
                  pose3(x / 10, turn));
        const Complex<3> complex = build_complex<3>(grid, scene.solids);
        Vec<3> place = Vec<3>::Zero();
        const ComplexSums<3> sums = sums_of(grid, complex, scene.solids, place.data());
        EXPECT_LE(sums.closure, 1e-12) << k << " cell " << place.transpose();
        EXPECT_LE(sums.flux.back().norm(), 1e-9) << k;
        EXPECT_TRUE(k % 4 == 0 || complex.links.size() > 10) << k << " " << complex.links.size();
        open += static_cast<double>(complex.links.size());
    }
    std::printf("links of cylinders: %g\n", open);
}

TEST(Edges, OfTwoBoxesInOneCellBothDivide)
{
    // Two plates end to end, their ends half a cell apart.
    const Grid<3> grid = unit_grid<3>(12);
    Scene<3> scene(grid);
    scene.add("a", make_box<3>(Vec<3>(3, 3, 0.2) / 12), pose3(Vec<3>(4.7, 6.2, 6.45) / 12, turned(0, {0, 0, 1})));
    scene.add("b", make_box<3>(Vec<3>(3, 3, 0.2) / 12), pose3(Vec<3>(8.2, 6.2, 6.55) / 12, turned(0, {0, 0, 1})));
    const Complex<3> complex = build_complex<3>(grid, scene.solids);
    EXPECT_LE(sums_of(grid, complex, scene.solids).closure, 1e-12);
    std::map<int, int> solids; // in the cell between them, far from their corners
    for (const CornerLink<3>& link : complex.links)
        if (complex.cell_of_part(link.a) == Index<3>(6, 6, 6))
            ++solids[link.solid];
    EXPECT_EQ(solids.size(), 2U);
}

/// A polygon swept along z from -half to half.
SurfaceMesh<3> prism(const std::vector<Vec<2>>& corners, double half)
{
    SurfaceMesh<3> mesh;
    const int n = static_cast<int>(corners.size());
    for (const double z : {-half, half})
        for (const Vec<2>& x : corners)
            mesh.vertices.push_back({x[0], x[1], z});
    for (const double z : {-half, half})
        mesh.vertices.push_back({0, 0, z}); // the polygon is a star seen from there
    for (int k = 0; k < n; ++k) {
        const int next = (k + 1) % n;
        mesh.elements.insert(mesh.elements.end(),
                             {{k, next, n + next}, {k, n + next, n + k}, {2 * n, next, k}, {2 * n + 1, n + k, n + next}});
    }
    mesh.patch.assign(mesh.elements.size(), 0);
    return mesh;
}

TEST(Edges, OfABoxAsAMeshAreThoseOfTheBox)
{
    std::mt19937 random(21);
    std::uniform_real_distribution<double> number(0, 1);
    for (int k = 0; k < 60 && !HasFailure(); ++k) {
        const bool periodic = k % 3 == 0;
        const Grid<3> grid = unit_grid<3>(10, all_sides<3>(periodic ? SideKind::periodic : SideKind::wall));
        const Vec<3> size(0.3 + 4 * number(random), 0.3 + 4 * number(random), std::pow(10, 0.5 - 2 * number(random)));
        const Vec<2> half = Vec<2>(size[0], size[1]) / 20;
        const Pose<3> at =
            pose3(Vec<3>(0.45 + 0.1 * number(random), 0.45 + 0.1 * number(random), periodic ? number(random) : 0.48),
                  turned(6.28 * number(random), Vec<3>(number(random), number(random), number(random))));
        std::array<std::vector<CornerLink<3>>, 2> links;
        for (const bool mesh : {false, true}) {
            Scene<3> scene(grid);
            if (mesh)
                scene.add("box",
                          make_mesh<3>(prism({-half, {half[0], -half[1]}, half, {-half[0], half[1]}}, size[2] / 20), "box"),
                          at);
            else
                scene.add("box", make_box<3>(Vec<3>(size / 10)), at);
            const Complex<3> complex = build_complex<3>(grid, scene.solids);
            EXPECT_LE(sums_of(grid, complex, scene.solids).closure, 1e-12);
            links[mesh] = complex.links;
            std::sort(links[mesh].begin(), links[mesh].end(), [](const auto& a, const auto& b) { return a.open < b.open; });
        }
        ASSERT_EQ(links[0].size(), links[1].size()) << k;
        EXPECT_GE(links[0].size(), 12U);
        for (std::size_t i = 0; i < links[0].size(); ++i) {
            EXPECT_NEAR(links[0][i].open, links[1][i].open, 1e-8) << k;
            EXPECT_NEAR(links[0][i].covered, links[1][i].covered, 1e-8) << k;
        }
    }
}

TEST(Edges, OfMeshesThatAreNotConvexAreClosed)
{
    std::mt19937 random(22);
    std::uniform_real_distribution<double> number(0, 1);
    double links = 0;
    for (int k = 0; k < 120 && !HasFailure(); ++k) {
        const bool periodic = k % 3 == 0;
        const Grid<3> grid = unit_grid<3>(10, all_sides<3>(periodic ? SideKind::periodic : SideKind::wall));
        Scene<3> scene(grid);
        const int points = 2 + static_cast<int>(4 * number(random));
        const double outer = 0.1 + 0.1 * number(random), inner = outer * (0.1 + 0.8 * number(random)),
                     thickness = std::pow(10, -0.5 - 2 * number(random));
        Vec<3> x = Vec<3>::Constant(0.45) + 0.1 * Vec<3>(number(random), number(random), number(random));
        if (k % 4 == 0) // on planes of the grid and between them
            x = (20 * x).array().round() / 20;
        const Rotation<3> turn = k % 4 ? turned(6.28 * number(random), Vec<3>(number(random), number(random), number(random)))
                                       : turned(std::numbers::pi / 2 * (k % 3), Vec<3>::Unit(k % 2));
        scene.add("star", make_mesh<3>(prism(star(points, outer, inner), k % 2 ? thickness / 2 : 0.1), "star"), pose3(x, turn));
        if (k % 2) // beside another one
            scene.add("other", make_mesh<3>(prism(star(points + 1, outer, inner), 0.05), "star"),
                      pose3(x + turn * Vec<3>(0, 0, 0.5 * thickness + 0.05 + std::pow(10, -1.5 - 2 * number(random))),
                            turn * turned(k, {0, 0, 1})));
        const Complex<3> complex = build_complex<3>(grid, scene.solids);
        Vec<3> place = Vec<3>::Zero();
        const ComplexSums<3> sums = sums_of(grid, complex, scene.solids, place.data());
        EXPECT_LE(sums.closure, 1e-12) << k << " cell " << place.transpose();
        for (std::size_t s = scene.solids.size() - 1 - k % 2; s < scene.solids.size(); ++s)
            EXPECT_LE(sums.flux[s].head<3>().norm(), 1e-9) << k;
        links += static_cast<double>(complex.links.size());
    }
    std::printf("links of stars: %g\n", links);
    EXPECT_GE(links, 120 * 20);
}

/// A square plate with a round hole in its middle.
SurfaceMesh<3> plate_with_hole(double half, double radius, double thickness, int corners)
{
    SurfaceMesh<3> mesh;
    for (const double z : {-0.5 * thickness, 0.5 * thickness})
        for (const bool outer : {false, true})
            for (int k = 0; k < corners; ++k) {
                const double a = 2 * std::numbers::pi * (k + 0.5) / corners,
                             r = outer ? half / std::max(std::abs(std::cos(a)), std::abs(std::sin(a))) : radius;
                mesh.vertices.push_back({r * std::cos(a), r * std::sin(a), z});
            }
    const auto quad = [&](int a, int b, int c, int d) { mesh.elements.insert(mesh.elements.end(), {{a, b, c}, {a, c, d}}); };
    for (int k = 0; k < corners; ++k) {
        const int n = corners, l = (k + 1) % n;
        quad(2 * n + k, 3 * n + k, 3 * n + l, 2 * n + l); // above
        quad(k, l, n + l, n + k);
        quad(n + k, n + l, 3 * n + l, 3 * n + k);
        quad(l, k, 2 * n + k, 2 * n + l);
    }
    mesh.patch.assign(mesh.elements.size(), 0);
    return mesh;
}

TEST(Holes, InsideACellHaveALink)
{
    const Grid<3> grid = unit_grid<3>(8);
    const auto complex_at = [&](const Vec<3>& x, double radius, const Rotation<3>& turn) {
        Scene<3> scene(grid);
        scene.add("plate", make_mesh<3>(plate_with_hole(2.7 / 8, radius / 8, 0.02 / 8, 24), "plate"), pose3(x / 8, turn));
        const Complex<3> complex = build_complex<3>(grid, scene.solids);
        EXPECT_LE(sums_of(grid, complex, scene.solids).closure, 1e-12);
        return complex;
    };
    const auto in_hole = [](const Complex<3>& complex, const Index<3>& cell) {
        std::vector<CornerLink<3>> links;
        for (const CornerLink<3>& link : complex.links)
            if (complex.cell_of_part(link.a) == cell)
                links.push_back(link);
        return links;
    };
    for (const Rotation<3>& turn : {turned(0, {0, 0, 1}), turned(0.3, {1, 2, 0})}) {
        const auto links = in_hole(complex_at({4.5, 4.45, 4.5}, 0.15, turn), Index<3>(4, 4, 4));
        ASSERT_EQ(links.size(), 1U);
        const double radius = 0.15 * std::sqrt(std::sin(2 * std::numbers::pi / 24) / (2 * std::numbers::pi / 24));
        EXPECT_NEAR(links[0].open, std::numbers::pi * radius * radius, 1e-9);
        EXPECT_NEAR(links[0].conductance, 1 / (0.5 / radius - 0.6776), 1e-3);
    }
    // As the rim comes to the cell's side the two parts become one.
    const auto near = in_hole(complex_at({4.5, 4.15 + 1e-6, 4.5}, 0.15, turned(0, {0, 0, 1})), Index<3>(4, 4, 4));
    ASSERT_EQ(near.size(), 1U);
    EXPECT_GE(near[0].conductance, 10);
}

TEST(Edges, OfMeshesThatTurnLittleDivideNothing)
{
    const Grid<3> grid = unit_grid<3>(16);
    const auto links = [&](int points) {
        Scene<3> scene(grid);
        scene.add("prism", make_mesh<3>(prism(star(points, 0.2, 0.2), 0.15), "prism"),
                  pose3(Vec<3>(0.507, 0.493, 0.51), turned(0.1, {1, 2, 3})));
        const Complex<3> complex = build_complex<3>(grid, scene.solids);
        int along = 0;
        for (const CornerLink<3>& link : complex.links) // in the middle of the prism's length only its own edges pass
            along += std::abs((turned(-0.1, {1, 2, 3}) * (link.at / 16 - Vec<3>(0.507, 0.493, 0.51)))[2]) < 0.01;
        return std::pair{complex.links.size(), along};
    };
    EXPECT_GT(links(2).second, 0); // of a square prism the middles of its four edges
    EXPECT_EQ(links(24).second, 0);
    EXPECT_GE(links(24).first, 2 * 3.14 * 0.2 * 16 * 2); // both rims
}

TEST(Edges, OfBoxesAndCylindersNearEachOtherAreClosed)
{
    std::mt19937 random(13);
    std::uniform_real_distribution<double> number(0, 1);
    for (int k = 0; k < 120 && !HasFailure(); ++k) {
        const bool periodic = k % 3 == 0;
        const Grid<3> grid = unit_grid<3>(10, all_sides<3>(periodic ? SideKind::periodic : SideKind::wall));
        Scene<3> scene(grid);
        Vec<3> x(number(random), number(random), number(random));
        x = periodic ? Vec<3>(10 * x) : Vec<3>(x + Vec<3>::Constant(4.5));
        const double gap = std::pow(10, -2.5 * number(random)), a = 1 + number(random), b = 1 + number(random);
        for (const int side : {-1, 1}) { // end to end, turned about their common axis
            const double half = side < 0 ? a : b;
            const Rotation<3> turn = turned(k % 4 ? 1.3 : 0, {1, 2, 3}) * turned(6.28 * number(random), {1, 0, 0});
            const Vec<3> centre = x + side * (half + 0.5 * gap) * (turn * Vec<3>::UnitX());
            if (k % 2 && side > 0)
                scene.add("b", make_cylinder((0.6 + number(random)) / 10, 2 * half / 10), pose3(centre / 10, turn));
            else
                scene.add("a", make_box<3>(Vec<3>(2 * half, 0.1 + 2 * number(random), 0.1 + 2 * number(random)) / 10),
                          pose3(centre / 10, turn));
        }
        const Complex<3> complex = build_complex<3>(grid, scene.solids);
        Vec<3> place = Vec<3>::Zero();
        const ComplexSums<3> sums = sums_of(grid, complex, scene.solids, place.data());
        EXPECT_LE(sums.closure, 1e-12) << k << " cell " << place.transpose() << " gap " << gap;
        for (std::size_t s = scene.solids.size() - 2; s < scene.solids.size(); ++s)
            EXPECT_LE(sums.flux[s].head<3>().norm(), 1e-9) << k << " gap " << gap;
    }
}

} // namespace
} // namespace gapflow::testing
