// D of solids that reach out of the domain.
#include "../grid/scenes.hpp"

#include "gapflow/complex/complex.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace gapflow::testing {
namespace {

/// D of a solid with the reference point `centre`.
template <int D>
TwistMatrix<D> seen(std::unique_ptr<Shape<D>> shape, const Pose<D>& at, const Vec<D>& centre)
{
    const Grid<D> grid = unit_grid<D>(12, all_sides<D>(SideKind::open));
    Scene<D> scene(grid);
    scene.add("solid", std::move(shape), at);
    scene.solids[0].centre = centre;
    return build_complex<D>(grid, scene.solids).seen_mass[0];
}

/// A shape along its first axis and a longer one that is the same within the domain: `make` of a length, `at` the place of the shorter one.
template <int D, class Make>
void longer_is_the_same(const char* name, const Make& make, const Pose<D>& at)
{
    const double length = 0.5, more = 0.21;
    Pose<D> longer = at;
    longer.position += 0.5 * more * (at.rotation * unit<D>(0));
    const TwistMatrix<D> D1 = seen<D>(make(length), at, at.position), D2 = seen<D>(make(length + more), longer, at.position);
    EXPECT_GT(D1.norm(), 1e-3) << name;
    // In space edges count by places half a cell apart.
    EXPECT_LE((D2 - D1).norm(), (D == 2 ? 1e-8 : 2e-3) * (1 + D1.norm())) << name;
}

TEST(SeenVolume, WhatLiesBeyondASideDoesNotCount2D)
{
    // Through a side along x, and through one along y.
    for (const Pose<2>& at : {pose<2>(Vec<2>(0.91, 0.53), 0.23), pose<2>(Vec<2>(0.48, 0.08), -0.5 * std::numbers::pi + 0.17)}) {
        longer_is_the_same<2>(
            "box", [](double l) { return make_box<2>(Vec<2>(l, 0.27)); }, at);
        longer_is_the_same<2>(
            "capsule", [](double l) { return make_capsule<2>(0.11, l - 0.1); }, at);
        longer_is_the_same<2>(
            "polygon", [](double l) { return make_mesh<2>(make_box<2>(Vec<2>(l, 0.27))->display_mesh(0), "box"); }, at);
        longer_is_the_same<2>(
            "cavity", [](double l) { return make_inside_out<2>(make_box<2>(Vec<2>(l, 0.27))); }, at);
    }
}

TEST(SeenVolume, WhatLiesBeyondASideDoesNotCount3D)
{
    Pose<3> aslant = pose<3>(Vec<3>(0.91, 0.53, 0.47)), down = pose<3>(Vec<3>(0.48, 0.52, 0.08));
    aslant.rotation = Rotation<3>(Eigen::AngleAxisd(0.23, Vec<3>(0.6, 0.0, 0.8)));
    down.rotation = Rotation<3>(Eigen::AngleAxisd(0.5 * std::numbers::pi + 0.12, Vec<3>(0.1, 1, 0.05).normalized()));
    for (const Pose<3>& at : {aslant, down}) {
        longer_is_the_same<3>(
            "box", [](double l) { return make_box<3>(Vec<3>(l, 0.27, 0.22)); }, at);
        longer_is_the_same<3>(
            "capsule", [](double l) { return make_capsule<3>(0.11, l - 0.1); }, at);
        longer_is_the_same<3>(
            "cylinder", [](double l) { return make_cylinder(0.12, l); }, at);
        longer_is_the_same<3>(
            "mesh", [](double l) { return make_mesh<3>(make_box<3>(Vec<3>(l, 0.27, 0.22))->display_mesh(0), "box"); }, at);
    }
}

/// Of a ball beyond a side, and of a capsule with the same end there. A ball that turns about its centre moves nothing.
template <int D>
void half_a_ball(const Vec<D>& at)
{
    const TwistMatrix<D> ball = seen<D>(make_ball<D>(0.2), pose<D>(at), at),
                         capsule = seen<D>(make_capsule<D>(0.2, 0.2), pose<D>(Vec<D>(at + 0.1 * unit<D>(0))), at);
    EXPECT_LE((TwistMatrix<D>(ball - capsule).template topLeftCorner<D, D>().norm()), 1e-8);
    EXPECT_GT(ball.norm(), 1e-3);
    EXPECT_LE(ball.template rightCols<spin_size<D>>().norm(), 1e-9);
}

TEST(SeenVolume, OfABallThatIsHalfBeyondASideIsThatOfACapsule)
{
    half_a_ball<2>({1.03, 0.52});
    half_a_ball<3>({1.03, 0.52, 0.49});
}

} // namespace
} // namespace gapflow::testing
