// Closure, sums and exact areas of the complex.
#include "checks.hpp"

#include "gapflow/complex/inertia.hpp"

#include <gmock/gmock.h>

#include <numbers>

namespace gapflow::testing {
namespace {

template <int D>
ComplexSums<D> check(const Grid<D>& grid, const Scene<D>& scene, double spin_tolerance = 1e-10)
{
    const Complex<D> complex = build_complex<D>(grid, scene.solids);
    double place[3] = {};
    const ComplexSums<D> sums = sums_of(grid, complex, scene.solids, place);
    EXPECT_LE(sums.closure, 1e-12) << "cell " << place[0] << " " << place[1] << " " << place[2];
    EXPECT_LE(sums.spin_closure, spin_tolerance);
    return sums;
}

TEST(Complex, BallIsClosed3D)
{
    const Grid<3> grid = unit_grid<3>(12);
    Scene<3> scene(grid);
    scene.add("ball", make_ball<3>(0.3), pose<3>(Vec<3>(0.51, 0.48, 0.53)));
    const auto sums = check<3>(grid, scene);
    EXPECT_LE(sums.flux.back().norm(), 1e-11);
    const Complex<3> complex = build_complex<3>(grid, scene.solids);
    EXPECT_GT(complex.cut_cells(), 100);
    // The planes see the ball's volume within their own error, and each is exact.
    double covered = 0, exact = 0;
    for (int i = 0; i <= 12; ++i) {
        const double h = i - 0.51 * 12, r2 = 0.09 * 144 - h * h;
        exact += r2 > 0 ? std::numbers::pi * r2 : 0;
    }
    covered = 13 * 144 - sums.area[0];
    EXPECT_NEAR(covered, exact, 1e-9);
}

/// Edges of a mesh that lie in a plane of the grid belong to what lies below it, and what lies above is seen too.
TEST(Complex, SeenVolumeOfAMeshWithEdgesInAPlane)
{
    const Grid<3> grid = unit_grid<3>(12);
    const auto seen = [&](double shift) {
        Scene<3> scene(grid);
        Pose<3> at = pose<3>(Vec<3>(0.5, 0.5, 0.5 + shift));
        at.rotation = Rotation<3>(Eigen::AngleAxisd(std::numbers::pi / 4, Vec<3>::UnitX()));
        scene.add("mesh", make_mesh<3>(make_box<3>(Vec<3>(0.5, 0.5, 0.5))->display_mesh(0), "box"), at);
        return build_complex<3>(grid, scene.solids).seen_mass[0];
    };
    // Two edges lie in the plane through the middle, where the section is largest.
    EXPECT_LE((seen(0) - seen(1e-7)).norm(), 1e-3);
}

TEST(Complex, CapsuleAlongTheGrid3D)
{
    const Grid<3> grid = unit_grid<3>(16);
    Scene<3> scene(grid);
    const double radius = 0.15, half = 0.2; // no turn at all: planes normal to the axis cut its round ends
    scene.add("capsule", make_capsule<3>(radius, 2 * half), pose<3>(Vec<3>(0.51, 0.48, 0.53)));
    const auto sums = check<3>(grid, scene);
    double exact = 0;
    for (int i = 0; i <= 16; ++i) {
        const double h = std::max(std::abs(i / 16.0 - 0.51) - half, 0.0), r2 = radius * radius - h * h;
        exact += r2 > 0 ? std::numbers::pi * r2 * 256 : 0;
    }
    EXPECT_NEAR(17 * 256 - sums.area[0], exact, 1e-9);
}

TEST(Complex, DiskIsClosed2D)
{
    const Grid<2> grid = unit_grid<2>(12);
    Scene<2> scene(grid);
    scene.add("disk", make_ball<2>(0.3), pose<2>(Vec<2>(0.51, 0.48)));
    const auto sums = check<2>(grid, scene);
    EXPECT_LE(sums.flux.back().norm(), 1e-11);
    const Complex<2> complex = build_complex<2>(grid, scene.solids);
    double area = 0;
    for (int p = 0; p < complex.parts(); ++p)
        area += complex.part_area[p];
    for (const auto c : complex.cell)
        area += c == Complex<2>::open;
    EXPECT_NEAR(area, 144 * (1 - std::numbers::pi * 0.09), 1e-9);
}

template <int D>
std::unique_ptr<Shape<D>> random_shape(std::mt19937& random, double size)
{
    std::uniform_real_distribution<double> number(0, 1);
    switch (static_cast<int>(number(random) * (D == 3 ? 5 : 4))) {
    case 3: // facets
        if constexpr (D == 3)
            return make_mesh<3>(
                (number(random) < 0.5 ? make_ball<3>(size) : make_cylinder(size, 0.1 * size))->display_mesh(0.05 * size),
                "facets");
        else
            return make_mesh<2>(make_ball<2>(size)->display_mesh(0.05 * size), "facets");
    case 0:
        return make_ball<D>(size);
    case 1: {
        Vec<D> edges;
        for (int axis = 0; axis < D; ++axis)
            edges[axis] = size * (number(random) < 0.3 ? 0.02 : 0.3 + 2 * number(random));
        return make_box<D>(edges);
    }
    case 2:
        return make_capsule<D>(0.5 * size * number(random), size * (0.1 + 2 * number(random)));
    default:
        if constexpr (D == 3)
            return make_cylinder(0.7 * size * number(random) + 0.003, size * (0.05 + 2 * number(random)));
        else
            return make_ball<D>(size);
    }
}

/// In a fluid that moves uniformly along d the pressure is linear, and K^T x_d + D e_d = -V w_d(c): the impulse of what the solid displaces acts at its
/// centroid, whatever its pose and reference point.
template <int D>
void check_uniform_motion(int seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(-0.1, 0.1);
    const int n = D == 2 ? 24 : 12;
    const Grid<D> grid = unit_grid<D>(n);
    Scene<D> scene(grid);
    Vec<D> place = Vec<D>::Constant(0.5);
    if (seed % 3)
        for (int axis = 0; axis < D; ++axis)
            place[axis] += number(random);
    const int k = scene.add("solid", random_shape<D>(random, 0.11), pose<D>(place, 10 * number(random)));
    Solid<D>& solid = scene.solids[k];
    for (int axis = 0; axis < D; ++axis)
        solid.centre[axis] += seed % 2 * number(random);
    const Complex<D> complex = build_complex<D>(grid, scene.solids);
    const Inertia<D> inertia = find_inertia<D>(grid, complex);
    const MassProperties<D> own = solid.shape.shape().mass_properties();
    const double volume = own.volume * std::pow(n, D);
    const Vec<D> centroid = n * (solid.shape.to_world(own.centre) - solid.centre);
    for (int d = 0; d < D; ++d) {
        Twist<D> impulse = complex.seen_mass[k].col(d) + volume * wrench<D>(unit<D>(d), centroid);
        double size = volume;
        const auto add = [&](const Index<D>& cell, const Twist<D>& flux) {
            impulse += (cell[d] - 0.5 * n) * flux;
            size += flux.norm();
        };
        for (int p = 0; p < complex.parts(); ++p)
            for (int patch = complex.first_patch[p]; patch < complex.first_patch[p + 1]; ++patch)
                add(complex.cell_of_part(p), inertia.patch_flux[patch]);
        for (const LentFlux<D>& lent : inertia.flux)
            add(complex.index.index(complex.cell_of(lent.row)), lent.flux);
        EXPECT_LE(impulse.norm(), 1e-11 * size) << "seed " << seed << ", axis " << d;
    }
    EXPECT_LE((complex.seen_mass[k] - complex.seen_mass[k].transpose()).norm(), 1e-14 * volume);
}

TEST(Complex, UniformMotionHasTheImpulseOfWhatIsDisplaced)
{
    for (int seed = 0; seed < 200; ++seed) {
        check_uniform_motion<2>(seed);
        check_uniform_motion<3>(seed);
    }
}

template <int D>
void check_random(int seed, bool apart)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(0, 1);
    auto sides = all_sides<D>(SideKind::wall);
    if (seed % 4 == 1)
        sides = all_sides<D>(SideKind::periodic);
    const Grid<D> grid = unit_grid<D>(D == 2 ? 16 : 10, sides);
    Scene<D> scene(grid);
    const int count = apart ? seed % 5 != 0 : 1 + static_cast<int>(4 * number(random));
    for (int k = 0; k < count; ++k) {
        Vec<D> x;
        for (int axis = 0; axis < D; ++axis) {
            x[axis] = 0.25 + 0.5 * number(random);
            if (number(random) < 0.3) // on planes of the grid or half way between
                x[axis] = std::round(x[axis] * 2 * grid.cells()[0]) / (2 * grid.cells()[0]);
        }
        const double angle =
            number(random) < 0.3 ? std::numbers::pi / 4 * static_cast<int>(8 * number(random)) : 6.28 * number(random);
        Pose<D> at = pose<D>(x, angle);
        if constexpr (D == 3)
            if (number(random) < 0.3)
                at.rotation = Rotation<3>(Eigen::AngleAxisd(angle, Vec<3>::Unit(static_cast<int>(3 * number(random)))));
        scene.add("s" + std::to_string(k), random_shape<D>(random, 0.05 + 0.2 * number(random)), at);
    }
    if (seed % 5 == 0)
        scene.add("container", make_inside_out<D>(seed % 2 ? make_ball<D>(0.45) : make_box<D>(Vec<D>::Constant(0.7))),
                  pose<D>(Vec<D>::Constant(0.5), seed));
    const ComplexSums<D> sums = check<D>(grid, scene, apart && seed % 4 != 1 ? 1e-10 : 1e9);
    for (std::size_t k = 0; k < scene.solids.size(); ++k) {
        const Bounds<D> bounds = world_bounds(scene.solids[k].shape);
        const bool inside = !scene.solids[k].wall && bounds.low.minCoeff() > 0 && bounds.high.maxCoeff() < 1;
        EXPECT_LE(apart && inside ? sums.flux[k].norm() : 0.0, 1e-9) << scene.solids[k].name;
    }
    if (::testing::Test::HasFailure())
        ADD_FAILURE() << "seed " << seed;
}

TEST(Complex, RandomSolids2D)
{
    for (int seed = 0; seed < 1000 && !HasFailure(); ++seed)
        check_random<2>(seed, true);
}

TEST(Complex, RandomSolids3D)
{
    for (int seed = 0; seed < 1000 && !HasFailure(); ++seed)
        check_random<3>(seed, true);
}

TEST(Complex, RandomScenes2D)
{
    for (int seed = 0; seed < 1000 && !HasFailure(); ++seed)
        check_random<2>(seed, false);
}

TEST(Complex, RandomScenes3D)
{
    for (int seed = 0; seed < 1000 && !HasFailure(); ++seed)
        check_random<3>(seed, false);
}

TEST(Complex, AreasAreThoseOfTheFractions)
{
    for (int seed = 0; seed < 20; ++seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> number(0, 1);
        const Grid<3> grid = unit_grid<3>(10);
        Scene<3> scene(grid);
        std::unique_ptr<Shape<3>> shape;
        if (seed % 2)
            shape = make_ball<3>(0.2 + 0.1 * number(random));
        else
            shape = make_box<3>(Vec<3>(0.3, 0.25, 0.35));
        scene.add("solid", std::move(shape), pose<3>(Vec<3>(0.5 + 0.1 * number(random), 0.5, 0.45), seed));
        const FaceClipper<3> clipper(grid, scene.solids, FractionMode::cut_cell);
        const Complex<3> complex = build_complex<3>(grid, scene.solids);
        for_each_domain_face<3>(grid, [&](int axis, const Index<3>& f) {
            if (f[axis] == 0 || f[axis] == grid.cells()[axis])
                return;
            double area = complex.main_area[axis][complex.index(f)];
            for (const FacePiece<3>& piece : complex.pieces)
                if (piece.axis == axis && piece.face == complex.index(f) && !complex.joins_main(piece))
                    area += piece.area;
            EXPECT_NEAR(area, clipped(clipper, axis, f).open, 2e-6) << seed << " axis " << axis << " face " << f.transpose();
        });
    }
}

} // namespace
} // namespace gapflow::testing
