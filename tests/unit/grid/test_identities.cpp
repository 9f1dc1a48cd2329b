// Sums, closed hulls and independence of order for random scenes, touching and overlapping bodies, and periodic images.
#include "scenes.hpp"

#include <algorithm>

namespace gapflow::testing {
namespace {

/// Bodies at random places, some inside one another. Every tenth scene has a container around them.
template <int D>
Scene<D> random_scene(const Grid<D>& grid, int seed, std::vector<int>& interior)
{
    Scene<D> scene(grid);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(0, 1);
    interior.clear();
    const int count = 2 + static_cast<int>(4 * number(random));
    for (int i = 0; i < count; ++i) {
        Vec<D> x;
        for (int axis = 0; axis < D; ++axis)
            x[axis] = 0.32 + 0.36 * number(random);
        const double size = 0.05 + 0.12 * number(random);
        std::unique_ptr<Shape<D>> shape;
        const int kind = static_cast<int>(3 * number(random));
        if (kind == 0) {
            Vec<D> edges;
            for (int axis = 0; axis < D; ++axis)
                edges[axis] = 0.03 + 0.25 * number(random);
            shape = make_box<D>(edges);
        } else if (kind == 1) {
            shape = make_ball<D>(size);
        } else {
            shape = make_capsule<D>(0.5 * size, 1.5 * size);
        }
        interior.push_back(scene.add(std::string(1, static_cast<char>('a' + (i * 7 + seed) % 26)), std::move(shape),
                                     pose<D>(x, 6 * number(random))));
    }
    if (seed % 3 == 0)
        scene.add("container", make_inside_out<D>(make_ball<D>(0.37)), pose<D>(Vec<D>::Constant(0.5)));
    if (seed % 3 == 1)
        scene.add("container", make_inside_out<D>(make_box<D>(Vec<D>::Constant(0.7))), pose<D>(Vec<D>::Constant(0.5), 0.3));
    return scene;
}

template <int D>
void check_random_scenes(int cells, int scenes, FractionMode mode)
{
    const auto grid = unit_grid<D>(cells);
    std::vector<int> interior;
    for (int seed = 0; seed < scenes; ++seed) {
        SCOPED_TRACE(::testing::Message() << "seed " << seed);
        const Scene<D> scene = random_scene<D>(grid, seed, interior);
        check_identities(grid, scene, mode, interior);
        if (::testing::Test::HasFatalFailure())
            return;
    }
}

TEST(Identities, RandomScenes2D)
{
    check_random_scenes<2>(21, 60, FractionMode::cut_cell);
}
TEST(Identities, RandomScenes3D)
{
    check_random_scenes<3>(13, 24, FractionMode::cut_cell);
}
TEST(Identities, RandomVoxels)
{
    check_random_scenes<2>(21, 20, FractionMode::voxel);
    check_random_scenes<3>(10, 6, FractionMode::voxel);
}

// Two boxes with a common side on a grid plane, a third that overlaps both, and a ball that touches.
template <int D>
Scene<D> touching_scene(const Grid<D>& grid, bool reverse, std::vector<int>& interior)
{
    Scene<D> scene(grid);
    const double dx = grid.dx();
    Vec<D> size = Vec<D>::Constant(4 * dx), left = Vec<D>::Constant(5 * dx), right = left, over = left, ball = left;
    right[0] += 4 * dx;
    over[0] += 2 * dx;
    over[1] += 2.3 * dx;
    ball[1] -= 3.5 * dx;
    auto add = [&](int k) {
        if (k == 0)
            scene.add("left", make_box<D>(size), pose<D>(left));
        else if (k == 1)
            scene.add("right", make_box<D>(size), pose<D>(right));
        else if (k == 2)
            scene.add("over", make_box<D>(0.5 * size), pose<D>(over, 0.2));
        else
            scene.add("ball", make_ball<D>(1.5 * dx), pose<D>(ball));
    };
    interior.clear();
    for (int k = 0; k < 4; ++k) {
        interior.push_back(static_cast<int>(scene.solids.size()));
        add(reverse ? 3 - k : k);
    }
    return scene;
}

template <int D>
void check_touching()
{
    const auto grid = unit_grid<D>(14);
    std::vector<int> interior;
    for (FractionMode mode : {FractionMode::cut_cell, FractionMode::voxel}) {
        const Scene<D> scene = touching_scene<D>(grid, false, interior), turned = touching_scene<D>(grid, true, interior);
        check_identities(grid, scene, mode, interior);
        const FaceClipper<D> one(grid, scene.solids, mode), other(grid, turned.solids, mode);
        for_each_domain_face<D>(grid, [&](int axis, const Index<D>& f) {
            const auto a = clipped(one, axis, f), b = clipped(other, axis, f);
            ASSERT_EQ(a.open, b.open);
            ASSERT_EQ(a.solid.size(), b.solid.size());
            for (std::size_t i = 0; i < a.solid.size(); ++i) {
                ASSERT_EQ(scene.solids[a.solid[i].solid].name, turned.solids[b.solid[i].solid].name);
                ASSERT_EQ(a.solid[i].fraction, b.solid[i].fraction);
                ASSERT_EQ(a.solid[i].centroid, b.solid[i].centroid);
            }
        });
        // The common side of the boxes, on the grid plane x = 7 dx.
        const auto contact = clipped(one, 0, Index<D>(Index<D>::Constant(4) + 3 * step<D>(0)));
        EXPECT_EQ(contact.open, 0);
        ASSERT_EQ(contact.solid.size(), mode == FractionMode::voxel ? 2u : 1u);
        EXPECT_EQ(scene.solids[contact.solid[0].solid].name, "left");
    }
}

TEST(Identities, TouchingAndOverlapping2D)
{
    check_touching<2>();
}
TEST(Identities, TouchingAndOverlapping3D)
{
    check_touching<3>();
}

TEST(Identities, CylinderAndBox3D)
{
    const auto grid = unit_grid<3>(12);
    Scene<3> scene(grid);
    const int cylinder = scene.add("cylinder", make_cylinder(0.15, 0.4), pose<3>({0.5, 0.5, 0.55}, 0.7));
    const int box = scene.add("box", make_box<3>({0.5, 0.2, 0.1}), pose<3>({0.5, 0.5, 0.35}, 0.1));
    check_identities(grid, scene, FractionMode::cut_cell, {cylinder, box});
}

TEST(Identities, OverlapOfBoxesGoesToTheDeeper)
{
    // Two aligned boxes overlap by 0.4 dx around x = 6.2 dx: each keeps what is on its side of the middle.
    const auto grid = unit_grid<3>(12);
    const double dx = grid.dx();
    Scene<3> scene(grid);
    const int a = scene.add("a", make_box<3>(Vec<3>::Constant(4 * dx)), pose<3>({4.4 * dx, 6 * dx, 6 * dx}));
    const int b = scene.add("b", make_box<3>(Vec<3>::Constant(4 * dx)), pose<3>({8 * dx, 6 * dx, 6 * dx}));
    const FaceClipper<3> clipper(grid, scene.solids, FractionMode::cut_cell);
    const auto face = clipped<3>(clipper, 2, {6, 5, 6});
    EXPECT_NEAR(fraction_in(face, a), 0.2, 1e-12);
    EXPECT_NEAR(fraction_in(face, b), 0.8, 1e-12);
    EXPECT_EQ(face.open, 0);
    check_identities(grid, scene, FractionMode::cut_cell, {a, b});
}

template <int D>
void check_periodic()
{
    // A body across the low x side: the same parts as the body moved by a whole number of cells into the middle.
    auto sides = all_sides<D>(SideKind::wall);
    sides[0] = sides[1] = SideKind::periodic;
    const auto grid = unit_grid<D>(12, sides);
    const double dx = grid.dx();
    Scene<D> across(grid), middle(grid);
    const int move = 6;
    for (Scene<D>* scene : {&across, &middle}) {
        const double shift = scene == &middle ? move * dx : 0;
        Vec<D> x = Vec<D>::Constant(0.5), y = Vec<D>::Constant(0.45);
        x[0] = 0.3 * dx + shift;
        y[0] = shift - 1.1 * dx;
        y[1] = 0.8;
        scene->add("ball", make_ball<D>(2.7 * dx), pose<D>(x));
        scene->add("box", make_box<D>(Vec<D>::Constant(2.5 * dx)), pose<D>(y, 0.4));
    }
    for (FractionMode mode : {FractionMode::cut_cell, FractionMode::voxel}) {
        const FaceClipper<D> one(grid, across.solids, mode), other(grid, middle.solids, mode);
        for_each_domain_face<D>(grid, [&](int axis, const Index<D>& f) {
            const auto a = clipped(one, axis, f), b = clipped(other, axis, Index<D>(f + move * step<D>(0)));
            ASSERT_NEAR(a.open, b.open, 1e-12);
            ASSERT_LE((a.open_centroid + move * dx * unit<D>(0) - b.open_centroid).norm(), 1e-9);
            ASSERT_EQ(a.solid.size(), b.solid.size());
            for (std::size_t i = 0; i < a.solid.size(); ++i) {
                ASSERT_EQ(a.solid[i].solid, b.solid[i].solid);
                if (across.solids[a.solid[i].solid].wall)
                    continue;
                ASSERT_NEAR(a.solid[i].fraction, b.solid[i].fraction, 1e-12);
                ASSERT_LE((a.solid[i].arm - b.solid[i].arm).norm(), 1e-11 / std::max(1e-6, a.solid[i].fraction));
            }
        });
        const int bodies = static_cast<int>(across.solids.size());
        check_identities(grid, across, mode, {bodies - 2, bodies - 1});
        // Ghost faces hold the same as the faces they stand for.
        const FaceFractions<D> fractions = face_fractions(grid, one);
        Index<D> c = Index<D>::Constant(5);
        for (c[0] = -1; c[0] <= 0; ++c[0]) {
            const Index<D> inside = grid.wrapped(c);
            for (int axis = 0; axis < D; ++axis)
                EXPECT_EQ(fractions.open(axis, c), fractions.open(axis, inside));
        }
    }
}

TEST(Identities, Periodic2D)
{
    check_periodic<2>();
}
TEST(Identities, Periodic3D)
{
    check_periodic<3>();
}

TEST(Identities, NearIsConservative)
{
    auto sides = all_sides<3>(SideKind::wall);
    sides[2] = sides[3] = SideKind::periodic;
    const auto grid = unit_grid<3>(16, sides);
    Scene<3> scene(grid);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(0, 1);
    for (int i = 0; i < 40; ++i)
        scene.add(numbered("ball", i), make_ball<3>(0.02 + 0.1 * number(random)),
                  pose<3>({number(random), number(random), number(random)}));
    scene.add("container", make_inside_out<3>(make_ball<3>(0.45)), pose<3>({0.5, 0.5, 0.5}));
    const FaceClipper<3> clipper(grid, scene.solids, FractionMode::cut_cell);
    std::vector<int> near;
    FaceClipper<3>::Nearby nearby;
    int kept = 0;
    Vec<3> x;
    for (int i = 0; i < 500; ++i) {
        if (i % 2 == 0)
            x = Vec<3>(number(random), number(random), number(random));
        else
            x[i % 3] += 0.01 * number(random);
        const double reach = 0.15 * number(random);
        clipper.near(x, reach, near);
        const Index<3> low = nearby.low, high = nearby.high;
        clipper.near(x, reach, nearby);
        ASSERT_EQ(nearby.images, near);
        kept += i > 0 && nearby.binned && low == nearby.low && high == nearby.high;
        for (int image = 0; image < static_cast<int>(clipper.images().size()); ++image)
            if (clipper.images()[image].shape.distance(x) <= reach) {
                ASSERT_TRUE(std::find(near.begin(), near.end(), image) != near.end());
            }
    }
    EXPECT_GT(kept, 50) << "calls that find the bins of the call before";
}

} // namespace
} // namespace gapflow::testing
