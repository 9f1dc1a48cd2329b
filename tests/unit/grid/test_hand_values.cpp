// Face fractions of single bodies against values worked out by hand or by an independent polygon clipping.
#include "scenes.hpp"

namespace gapflow::testing {
namespace {

using Polygon = std::vector<Vec<2>>;

// Part of the segment from p along `axis` of length `length` inside a convex polygon (counterclockwise): begin and end in 0..1.
std::pair<double, double> inside_polygon(const Polygon& polygon, const Vec<2>& p, int axis, double length)
{
    double begin = 0, end = 1;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec<2> a = polygon[i], e = polygon[(i + 1) % polygon.size()] - a;
        auto side = [&](const Vec<2>& x) { return e[0] * (x[1] - a[1]) - e[1] * (x[0] - a[0]); }; // >= 0 inside
        const double s0 = side(p), s1 = side(p + length * unit<2>(axis));
        const double t = s0 / (s0 - s1);
        if (s0 < 0 && s1 < 0)
            return {0, 0};
        if (s0 < 0)
            begin = std::max(begin, t);
        else if (s1 < 0)
            end = std::min(end, t);
    }
    return {begin, std::max(begin, end)};
}

TEST(HandValues, BoxAlignedCutsFaces2D)
{
    const auto grid = unit_grid<2>(8); // dx = 1/8
    Scene<2> scene(grid);
    // x in [0.30, 0.70], y in [0.25, 0.55]: its low y side lies on a grid line.
    const int box = scene.add("box", make_box<2>({0.4, 0.3}), pose<2>({0.5, 0.4}));
    const FaceClipper<2> clipper(grid, scene.solids, FractionMode::cut_cell);

    // Face normal to x at x = 4/8 between y = 4/8 and 5/8: solid up to 0.55.
    auto face = clipped<2>(clipper, 0, {4, 4});
    EXPECT_NEAR(fraction_in(face, box), 0.4, 1e-14);
    EXPECT_NEAR(face.open, 0.6, 1e-14);
    ASSERT_EQ(face.solid.size(), 1u);
    EXPECT_NEAR(face.solid[0].centroid[1], 0.525, 1e-14);
    EXPECT_NEAR(face.solid[0].centroid[0], 0.5, 1e-14);
    EXPECT_NEAR(face.solid[0].arm[1], 0.125, 1e-14);
    EXPECT_NEAR(face.open_centroid[1], (0.55 + 0.625) / 2, 1e-14);
    // The face below the box at x = 4/8 only touches it.
    EXPECT_EQ(clipped<2>(clipper, 0, {4, 1}).open, 1);
    // On the box's low side: solid where the box lies on it. x = 2/8 .. 3/8: from 0.30 on.
    face = clipped<2>(clipper, 1, {2, 2});
    EXPECT_NEAR(fraction_in(face, box), 0.6, 1e-13);
    EXPECT_NEAR(face.solid[0].centroid[0], (0.30 + 0.375) / 2, 1e-14);
    face = clipped<2>(clipper, 1, {4, 2});
    EXPECT_EQ(fraction_in(face, box), 1);
    EXPECT_EQ(face.open, 0);
    EXPECT_EQ(face.open_centroid, grid.face_centre(1, {4, 2}));
    // Deep inside.
    EXPECT_EQ(fraction_in(clipped<2>(clipper, 1, {4, 3}), box), 1);
}

TEST(HandValues, TurnedBoxIsExact2D)
{
    const auto grid = unit_grid<2>(16);
    Scene<2> scene(grid);
    const double angle = 25 * M_PI / 180;
    const Vec<2> centre(0.47, 0.52), half(0.26, 0.11);
    const int box = scene.add("box", make_box<2>(2 * half), pose<2>(centre, angle));
    const FaceClipper<2> clipper(grid, scene.solids, FractionMode::cut_cell);
    Polygon polygon;
    for (const auto& [a, b] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
        polygon.push_back(centre + Rotation<2>(angle) * Vec<2>(a * half[0], b * half[1]));
    for_each_domain_face<2>(grid, [&](int axis, const Index<2>& f) {
        if (f[axis] == 0 || f[axis] == 16)
            return;
        const Vec<2> low = grid.face_centre(axis, f) - 0.5 * grid.dx() * unit<2>(1 - axis);
        const auto [begin, end] = inside_polygon(polygon, low, 1 - axis, grid.dx());
        const auto face = clipped<2>(clipper, axis, f);
        ASSERT_NEAR(fraction_in(face, box), end - begin, 1e-12) << axis << " " << f.transpose();
        if (end - begin > 0) {
            ASSERT_NEAR(face.solid[0].centroid[1 - axis], low[1 - axis] + grid.dx() * (begin + end) / 2, 1e-12);
        }
    });
}

TEST(HandValues, DiskIsExact2D)
{
    const auto grid = unit_grid<2>(16);
    Scene<2> scene(grid);
    const Vec<2> centre(0.51, 0.48);
    const double radius = 0.3;
    const int disk = scene.add("disk", make_ball<2>(radius), pose<2>(centre));
    const FaceClipper<2> clipper(grid, scene.solids, FractionMode::cut_cell);
    for (int i = 1; i < 16; ++i) {
        double chord = 0;
        for (int j = 0; j < 16; ++j)
            chord += fraction_in(clipped<2>(clipper, 0, {i, j}), disk) * grid.dx();
        const double x = i * grid.dx() - centre[0];
        const double exact = std::abs(x) < radius ? 2 * std::sqrt(radius * radius - x * x) : 0;
        EXPECT_NEAR(chord, exact, 4e-6 * grid.dx()); // crossings are found to the clipper's 1e-6 dx
    }
}

TEST(HandValues, DiskTouchingFacesHoldsNoPart)
{
    // Tangent to the grid lines at the middles of faces.
    const auto grid = unit_grid<2>(8);
    Scene<2> scene(grid);
    const double dx = grid.dx();
    const int disk = scene.add("disk", make_ball<2>(1.5 * dx), pose<2>({3.5 * dx, 3.5 * dx}));
    const FaceClipper<2> clipper(grid, scene.solids, FractionMode::cut_cell);
    for (int axis = 0; axis < 2; ++axis)
        for (int end : {2, 5}) {
            Index<2> f(3, 3);
            f[axis] = end;
            EXPECT_EQ(fraction_in(clipped<2>(clipper, axis, f), disk), 0);
            EXPECT_EQ(clipped<2>(clipper, axis, f).open, 1);
        }
    check_identities(grid, scene, FractionMode::cut_cell, {disk});
}

TEST(HandValues, BoxAligned3D)
{
    const auto grid = unit_grid<3>(8);
    Scene<3> scene(grid);
    // x in [0.3, 0.7], y in [0.25, 0.55], z in [0.25, 0.75]
    const int box = scene.add("box", make_box<3>({0.4, 0.3, 0.5}), pose<3>({0.5, 0.4, 0.5}));
    const FaceClipper<3> clipper(grid, scene.solids, FractionMode::cut_cell);
    // Normal to z at z = 4/8, cell (2, 4): x from 0.30 to 0.375 (0.6), y from 0.5 to 0.55 (0.4).
    auto face = clipped<3>(clipper, 2, {2, 4, 4});
    EXPECT_NEAR(fraction_in(face, box), 0.24, 1e-13);
    EXPECT_NEAR(face.open, 0.76, 1e-13);
    ASSERT_EQ(face.solid.size(), 1u);
    EXPECT_LE((face.solid[0].centroid - Vec<3>(0.3375, 0.525, 0.5)).norm(), 1e-13);
    EXPECT_LE((face.solid[0].arm - Vec<3>(-0.1625, 0.125, 0)).norm(), 1e-13);
    const Vec<3> open = (Vec<3>(0.3125, 0.5625, 0.5) - 0.24 * face.solid[0].centroid) / 0.76;
    EXPECT_LE((face.open_centroid - open).norm(), 0.25 * 0.5);
    // The same on the box's low z side, which is a grid plane.
    EXPECT_NEAR(fraction_in(clipped<3>(clipper, 2, {2, 4, 2}), box), 0.24, 1e-12);
    EXPECT_EQ(fraction_in(clipped<3>(clipper, 2, {4, 3, 2}), box), 1);
    EXPECT_EQ(fraction_in(clipped<3>(clipper, 2, {4, 3, 6}), box), 1);
    EXPECT_EQ(clipped<3>(clipper, 0, {4, 3, 1}).open, 1);
    EXPECT_EQ(clipped<3>(clipper, 2, {4, 3, 1}).open, 1);
}

TEST(HandValues, TurnedBoxVolumeIsExactInSections3D)
{
    // Turned about z by 25 degrees: each section normal to z has the area of the rectangle.
    const auto grid = unit_grid<3>(12);
    Scene<3> scene(grid);
    Pose<3> p;
    p.position = {0.5, 0.47, 0.5};
    p.rotation = Rotation<3>(Eigen::AngleAxisd(25 * M_PI / 180, Vec<3>::UnitZ()));
    const int box = scene.add("box", make_box<3>({0.45, 0.2, 0.33}), p);
    const FaceClipper<3> clipper(grid, scene.solids, FractionMode::cut_cell);
    for (int k = 1; k < 12; ++k) {
        double area = 0;
        Vec<3> moment = Vec<3>::Zero();
        for_each_index<3>({0, 0, k}, {12, 12, k + 1}, [&](const Index<3>& f) {
            for (const auto& part : clipped<3>(clipper, 2, f).solid) {
                area += part.fraction * grid.face_area();
                moment += part.fraction * grid.face_area() * part.centroid;
            }
        });
        const bool inside = std::abs(k / 12.0 - 0.5) < 0.165;
        EXPECT_NEAR(area, inside ? 0.09 : 0, 1e-14) << k;
        if (inside) {
            EXPECT_LE((moment / area - Vec<3>(0.5, 0.47, k / 12.0)).norm(), 1e-13);
        }
    }
    check_identities(grid, scene, FractionMode::cut_cell, {box});
}

// A ball's parts of the faces normal to an axis against the sections pi (r^2 - h^2), and their centroids; but for parts and openings below
// 1e-6 of a face, which are none.
TEST(HandValues, BallIsExact3D)
{
    const auto grid = unit_grid<3>(12);
    const double dx = grid.dx();
    std::mt19937 random(2);
    std::uniform_real_distribution<double> number(0, 1);
    for (const double radius : {0.3, 2.0, 4.0}) {
        Scene<3> scene(grid);
        const double r = radius * dx;
        const Vec<3> x = Vec<3>::Constant(0.5) + dx * Vec<3>(number(random), number(random), number(random));
        const int ball = scene.add("ball", make_ball<3>(r), pose<3>(x, 1));
        const FaceClipper<3> clipper(grid, scene.solids, FractionMode::cut_cell);
        for (int axis = 0; axis < 3; ++axis)
            for (int k = 1; k < 12; ++k) {
                double area = 0;
                Vec<3> moment = Vec<3>::Zero();
                Index<3> from = Index<3>::Zero(), to = Index<3>::Constant(12);
                from[axis] = k;
                to[axis] = k + 1;
                for_each_index<3>(from, to, [&](const Index<3>& f) {
                    for (const auto& part : clipped<3>(clipper, axis, f).solid)
                        if (part.solid == ball) {
                            area += part.fraction;
                            moment += part.fraction * part.arm;
                        }
                });
                const double h = k - x[axis] / dx;
                EXPECT_NEAR(area, M_PI * std::max(0.0, radius * radius - h * h), 2e-6);
                moment[axis] = 0;
                EXPECT_LE(moment.norm(), 2e-6 * radius * dx);
            }
        check_identities(grid, scene, FractionMode::cut_cell, {ball});
    }
}

// A ball that touches a grid plane, but for round-off of its place, has no part of its faces.
TEST(HandValues, BallTouchingFacesHoldsNoPart)
{
    const auto grid = unit_grid<3>(12);
    const double dx = grid.dx();
    for (const double past : {-1e-12, 0.0, 1e-12, 1e-8}) {
        Scene<3> scene(grid);
        const int ball = scene.add("ball", make_ball<3>(3 * dx), pose<3>({(6 + past) * dx, 5.7 * dx, 6.4 * dx}));
        const FaceClipper<3> clipper(grid, scene.solids, FractionMode::cut_cell);
        const auto face = clipped<3>(clipper, 0, {9, 5, 6});
        EXPECT_EQ(fraction_in(face, ball), 0) << past;
        EXPECT_EQ(face.open, 1) << past;
    }
}

// A ball that spins moves no fluid: the flux of its surface out of any cell is zero (but for parts and openings below 1e-6 of a face).
TEST(HandValues, SpinningBallHasNoFlux)
{
    const auto grid = unit_grid<3>(12);
    Scene<3> scene(grid);
    const int ball = scene.add("ball", make_ball<3>(0.3), pose<3>({0.51, 0.47, 0.502}));
    const int shell = scene.add("shell", make_inside_out<3>(make_ball<3>(0.41)), pose<3>({0.49, 0.5, 0.505}));
    const FaceFractions<3> fractions = face_fractions(grid, FaceClipper<3>(grid, scene.solids, FractionMode::cut_cell));
    int cells = 0;
    const Index<3> one = Index<3>::Ones(); // faces on the walls belong to them, also where the shell lies over them
    for_each_index<3>(grid.low() + one, grid.high() - one, [&](const Index<3>& c) {
        for_each_body_flux(grid, fractions, c, [&](int solid, const Twist<3>& row) {
            if (solid == ball || solid == shell) {
                EXPECT_LE(row.tail<3>().norm(), 2e-6 * grid.face_area() * 0.4) << c.transpose();
                ++cells;
            }
        });
    });
    EXPECT_GT(cells, 500);
}

// Solids that touch, or overlap by as little as a contact does, have the parts of solids that just do not: balls, a ball and a box, a ball
// and the hollow sphere around it, with the axis of the contact in a grid plane.
TEST(HandValues, PartsOfBallsInContactAreContinuous)
{
    const auto grid = unit_grid<3>(12);
    const double dx = grid.dx(), r = 2.3 * dx;
    const Vec<3> at = dx * Vec<3>(4.4, 6, 6), along = Vec<3>(3, 4, 0) / 5;
    for (int kind = 0; kind < 3; ++kind) {
        const auto scene_of = [&](double gap) {
            Scene<3> scene(grid);
            if (kind < 2)
                scene.add("ball", make_ball<3>(r), pose<3>(at));
            if (kind == 0)
                scene.add("other", make_ball<3>(1.7 * dx), pose<3>(at + (r + 1.7 * dx + gap) * along));
            if (kind == 1)
                scene.add("box", make_box<3>(dx * Vec<3>(2, 5, 4)), pose<3>(at + (r + dx + gap) * unit<3>(0)));
            if (kind == 2) {
                scene.add("ball", make_ball<3>(r), pose<3>(Vec<3>::Constant(0.5) + (1.6 * dx - gap) * along));
                scene.add("shell", make_inside_out<3>(make_ball<3>(r + 1.6 * dx)), pose<3>(Vec<3>::Constant(0.5)));
            }
            return scene;
        };
        const Scene<3> apart = scene_of(1e-9 * dx), over = scene_of(-1e-9 * dx);
        const FaceClipper<3> one(grid, apart.solids, FractionMode::cut_cell), two(grid, over.solids, FractionMode::cut_cell);
        for_each_domain_face<3>(grid, [&](int axis, const Index<3>& f) {
            const auto a = clipped<3>(one, axis, f), b = clipped<3>(two, axis, f);
            EXPECT_NEAR(a.open, b.open, 1e-8) << kind;
            for (int solid = 0; solid < static_cast<int>(apart.solids.size()); ++solid)
                EXPECT_NEAR(fraction_in(a, solid), fraction_in(b, solid), 1e-8) << kind;
        });
        const int bodies = static_cast<int>(over.solids.size());
        std::vector<int> interior{bodies - 2};
        if (kind < 2)
            interior.push_back(bodies - 1);
        check_identities(grid, over, FractionMode::cut_cell, interior);
    }
}

// Relative error of the volume of a capsule along x from the divergence theorem over its clipped faces, sum_f s_f |f| dx, against the same
// sum over the exact sections normal to x: the error of the clipping alone. Mean over places.
double capsule_volume_error(double radius)
{
    const auto grid = unit_grid<3>(12);
    const double dx = grid.dx(), r = radius * dx, half = 1.3 * dx;
    std::mt19937 random(2);
    std::uniform_real_distribution<double> number(0, 1);
    double clipped_volume = 0, exact = 0;
    for (int k = 0; k < 8; ++k) {
        Scene<3> scene(grid);
        const Vec<3> x = Vec<3>::Constant(0.5) + 0.5 * dx * Vec<3>(number(random), number(random), number(random));
        const int capsule = scene.add("capsule", make_capsule<3>(r, 2 * half), pose<3>(x));
        const FaceClipper<3> clipper(grid, scene.solids, FractionMode::cut_cell);
        clipped_volume += volume_of(grid, clipper, capsule, 0);
        for (int i = 0; i <= 12; ++i)
            exact += dx * M_PI * std::max(0.0, r * r - std::pow(std::max(std::abs(i * dx - x[0]) - half, 0.0), 2));
    }
    return std::abs(clipped_volume / exact - 1);
}

TEST(HandValues, CapsuleVolumeIsSecondOrder3D)
{
    const double coarse = capsule_volume_error(2), fine = capsule_volume_error(4);
    EXPECT_LT(fine, 1.5e-3);
    EXPECT_GT(std::log2(coarse / fine), 1.8);
}

TEST(HandValues, Voxels2D)
{
    const auto grid = unit_grid<2>(8);
    Scene<2> scene(grid);
    const double dx = grid.dx();
    // Cells (2..3, 2..4) hold a, cells (4..5, 2..4) hold b.
    const int a = scene.add("a", make_box<2>({2 * dx, 3 * dx}), pose<2>({3 * dx, 3.5 * dx}));
    const int b = scene.add("b", make_box<2>({2 * dx, 3 * dx}), pose<2>({5 * dx, 3.5 * dx}));
    // A thin plate between the centres of cells (6, 1) and (7, 1).
    const int plate = scene.add("plate", make_box<2>({0.1 * dx, 1.2 * dx}), pose<2>({7 * dx, 1.5 * dx}));
    const FaceClipper<2> clipper(grid, scene.solids, FractionMode::voxel);
    EXPECT_EQ(fraction_in(clipped<2>(clipper, 0, {2, 3}), a), 1);
    EXPECT_EQ(fraction_in(clipped<2>(clipper, 0, {3, 3}), a), 1);
    auto pair = clipped<2>(clipper, 0, {4, 3});
    EXPECT_EQ(fraction_in(pair, a), 0.5);
    EXPECT_EQ(fraction_in(pair, b), 0.5);
    EXPECT_EQ(pair.solid[0].centroid, grid.face_centre(0, {4, 3}));
    EXPECT_EQ(fraction_in(clipped<2>(clipper, 0, {6, 3}), b), 1);
    EXPECT_EQ(clipped<2>(clipper, 0, {7, 3}).open, 1);
    EXPECT_EQ(clipped<2>(clipper, 1, {2, 1}).open, 1);
    EXPECT_EQ(fraction_in(clipped<2>(clipper, 1, {2, 2}), a), 1);
    EXPECT_EQ(fraction_in(clipped<2>(clipper, 0, {7, 1}), plate), 1);
    EXPECT_EQ(clipped<2>(clipper, 1, {7, 1}).open, 1);
    EXPECT_EQ(clipped<2>(clipper, 0, {0, 1}).solid[0].solid, 0);
    check_identities(grid, scene, FractionMode::voxel, {a, b, plate});
}

TEST(HandValues, WallsOwnTheirSides)
{
    auto sides = all_sides<2>(SideKind::wall);
    sides[1] = SideKind::open;
    const auto grid = unit_grid<2>(8, sides);
    Scene<2> scene(grid);
    const int box =
        scene.add("box", make_box<2>({2, 0.3}), pose<2>({0.5, 0.15})); // sticks out on both sides and lies on the floor
    const FaceClipper<2> clipper(grid, scene.solids, FractionMode::cut_cell);
    EXPECT_EQ(clipped<2>(clipper, 0, {0, 1}).solid[0].solid, 0);    // left: wall
    EXPECT_EQ(fraction_in(clipped<2>(clipper, 0, {8, 1}), box), 1); // right: open side, section of the box
    EXPECT_NEAR(fraction_in(clipped<2>(clipper, 0, {8, 2}), box), 0.4, 1e-13);
    EXPECT_EQ(clipped<2>(clipper, 0, {8, 3}).open, 1);
    EXPECT_EQ(fraction_in(clipped<2>(clipper, 1, {3, 0}), box), 0); // floor: wall
    EXPECT_EQ(clipped<2>(clipper, 1, {3, 0}).open, 0);
    check_identities(grid, scene, FractionMode::cut_cell, {});
    scene.solids.erase(scene.solids.begin());
    EXPECT_THROW(FaceClipper<2>(grid, scene.solids, FractionMode::cut_cell), std::logic_error);
}

TEST(HandValues, DeepestOpeningOfSplitFace)
{
    const auto grid = unit_grid<2>(8);
    const double dx = grid.dx();
    Scene<2> scene(grid);
    // A bar across the faces normal to x in row 3 from 0.2 to 0.4 of their height: two openings, the upper one deeper.
    scene.add("bar", make_box<2>({4 * dx, 0.2 * dx}), pose<2>({4 * dx, 3.3 * dx}));
    const FaceClipper<2> clipper(grid, scene.solids, FractionMode::cut_cell);
    EXPECT_NEAR(clipped<2>(clipper, 0, {4, 3}).open, 0.8, 1e-13);
    EXPECT_NEAR(clipper.deepest_open_centroid(0, {4, 3})[1], 3.7 * dx, 0.02 * dx);
    EXPECT_EQ(clipper.deepest_open_centroid(0, {4, 6}), grid.face_centre(0, {4, 6}));
}

} // namespace
} // namespace gapflow::testing
