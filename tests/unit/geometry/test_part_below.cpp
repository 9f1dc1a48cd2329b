// Part of a solid below a plane: closed forms, and against integrals over slices and the derivative of the volume.
#include "checks.hpp"

#include "gapflow/geometry/part_below.hpp"
#include "gapflow/geometry/pose.hpp"

#include <numbers>
#include <vector>

namespace gapflow::testing {
namespace {

constexpr double pi = std::numbers::pi;

TEST(PartBelow, BoxUprightAndOnItsCorner)
{
    const auto box = make_box<3>({2, 4, 6});
    const PartBelow<3> part = part_below<3>(*box, {Vec<3>(0, 0, 1), -1});
    EXPECT_NEAR(part.volume, 16, 1e-13);
    EXPECT_NEAR((part.moment - Vec<3>(0, 0, -32)).norm(), 0, 1e-12);
    EXPECT_NEAR(part.section, 8, 1e-13);
    EXPECT_NEAR((part.section_moment - Vec<3>(0, 0, -8)).norm(), 0, 1e-12);
    EXPECT_NEAR((part.section_square - Mat<3>(Vec<3>(8. / 3, 32. / 3, 8).asDiagonal())).norm(), 0, 1e-12);

    const auto cube = make_box<3>({2, 2, 2}); // a tetrahedron with edges 1 at a corner
    const PartBelow<3> corner = part_below<3>(*cube, {Vec<3>::Constant(1 / std::sqrt(3.)), -2 / std::sqrt(3.)});
    EXPECT_NEAR(corner.volume, 1. / 6, 1e-14);
    EXPECT_NEAR((corner.moment / corner.volume - Vec<3>::Constant(-0.75)).norm(), 0, 1e-13);
    EXPECT_NEAR(corner.section, std::sqrt(3.) / 2, 1e-14);

    const auto square = make_box<2>({2, 2}); // a triangle
    const PartBelow<2> triangle = part_below<2>(*square, {Vec<2>::Constant(std::sqrt(0.5)), -std::sqrt(0.5)});
    EXPECT_NEAR(triangle.volume, 0.5, 1e-14);
    EXPECT_NEAR((triangle.moment / triangle.volume - Vec<2>::Constant(-2. / 3)).norm(), 0, 1e-14);
    EXPECT_NEAR(triangle.section, std::sqrt(2.), 1e-14);
}

TEST(PartBelow, BallAndDisk)
{
    for (const double d : {-0.999, -0.7, 0.0, 0.4, 1.9}) {
        const double r = 2, h = r + d;
        const Vec<3> n = Vec<3>(1, -2, 0.5).normalized();
        const PartBelow<3> part = part_below<3>(*make_ball<3>(r), {n, d});
        EXPECT_NEAR(part.volume, pi * h * h * (3 * r - h) / 3, 1e-12);
        EXPECT_NEAR((part.moment + pi / 4 * std::pow(r * r - d * d, 2) * n).norm(), 0, 1e-12);
        EXPECT_NEAR(part.section, pi * (r * r - d * d), 1e-12);
        EXPECT_NEAR(part.section_square.trace(), pi / 2 * std::pow(r * r - d * d, 2) + d * d * part.section, 1e-12);

        const Vec<2> m = Vec<2>(-3, 1).normalized();
        const PartBelow<2> segment = part_below<2>(*make_ball<2>(r), {m, d});
        EXPECT_NEAR(segment.volume, r * r * std::acos(-d / r) + d * std::sqrt(r * r - d * d), 1e-12);
        EXPECT_NEAR((segment.moment + 2. / 3 * std::pow(r * r - d * d, 1.5) * m).norm(), 0, 1e-12);
        EXPECT_NEAR(segment.section, 2 * std::sqrt(r * r - d * d), 1e-12);
    }
    const PartBelow<3> cavity = part_below<3>(*make_inside_out<3>(make_ball<3>(2)), {Vec<3>(0, 0, 1), 0});
    EXPECT_NEAR(cavity.volume, -16 * pi / 3, 1e-12);
    EXPECT_NEAR(cavity.section, -4 * pi, 1e-12);
}

// Upright, on the side, and Archimedes' hoof: 2/3 r^2 l below the plane from the middle of an end to the rim of the other one.
TEST(PartBelow, CylinderAndCapsuleInClosedForm)
{
    const double r = 0.7, l = 2;
    const auto cylinder = make_cylinder(r, l);
    const auto capsule = make_capsule<3>(r, l);
    EXPECT_NEAR(part_below<3>(*cylinder, {Vec<3>(1, 0, 0), 0.3}).volume, pi * r * r * 1.3, 1e-13);
    EXPECT_NEAR(part_below<3>(*capsule, {Vec<3>(1, 0, 0), 0.3}).volume, pi * r * r * (1.3 + 2 * r / 3), 1e-13);
    const double d = 0.2, segment = r * r * std::acos(-d / r) + d * std::sqrt(r * r - d * d), h = r + d;
    EXPECT_NEAR(part_below<3>(*cylinder, {Vec<3>(0, 1, 0), d}).volume, l * segment, 1e-13);
    EXPECT_NEAR(part_below<3>(*capsule, {Vec<3>(0, 1, 0), d}).volume, l * segment + pi * h * h * (3 * r - h) / 3, 1e-13);
    const Vec<3> n(-r, l, 0);
    const PartBelow<3> hoof = part_below<3>(*cylinder, {n.normalized(), -0.5 * r * l / n.norm()});
    EXPECT_NEAR(hoof.volume, 2. / 3 * r * r * l, 1e-13);
    // Half of everything, however it is tilted.
    for (const double tilt : {1e-9, 1e-5, 0.01, 0.3, 1.0, 1.57, 0.5 * pi - 1e-7}) {
        const Vec<3> m(std::sin(tilt), 0.6 * std::cos(tilt), -0.8 * std::cos(tilt));
        EXPECT_NEAR(part_below<3>(*cylinder, {m, 0}).volume, 0.5 * pi * r * r * l, 1e-12) << tilt;
        EXPECT_NEAR(part_below<3>(*capsule, {m, 0}).volume, 0.5 * pi * r * r * (l + 4 * r / 3), 1e-12) << tilt;
    }
}

// Integrals over sections with parallel planes: of volume and moment. Also for planes that touch edges and rims.
template <int D>
void expect_sections_to_be_derivatives(const Shape<D>& shape, const Vec<D>& n, double tolerance)
{
    const Vec<D> half = 0.5 * (shape.bounds().high - shape.bounds().low),
                 middle = 0.5 * (shape.bounds().high + shape.bounds().low);
    const double reach = n.cwiseAbs().dot(half), step = 1e-3 * reach;
    for (double share = -0.95; share < 1; share += 0.19) {
        const double d = n.dot(middle) + share * reach;
        const PartBelow<D> at = part_below<D>(shape, {n, d}), lower = part_below<D>(shape, {n, d - step}),
                           upper = part_below<D>(shape, {n, d + step});
        const double scale = std::pow(reach, D - 1);
        EXPECT_NEAR((upper.volume - lower.volume) / (2 * step), at.section, tolerance * scale) << share;
        EXPECT_NEAR(((upper.moment - lower.moment) / (2 * step) - at.section_moment).norm(), 0, tolerance * scale * reach)
            << share;
        // What is above is the part below the plane turned over.
        const PartBelow<D> above = part_below<D>(shape, {-n, -d});
        const MassProperties<D> mass = shape.mass_properties();
        EXPECT_NEAR(at.volume + above.volume, mass.volume, 1e-10 * mass.volume) << share;
        EXPECT_NEAR((at.moment + above.moment - mass.volume * mass.centre).norm(), 0, 1e-10 * mass.volume * reach) << share;
        EXPECT_NEAR(at.section, above.section, 1e-10 * scale) << share;
        EXPECT_NEAR((at.section_moment - above.section_moment).norm(), 0, 1e-10 * scale * reach) << share;
        EXPECT_NEAR((at.section_square - above.section_square).norm(), 0, 1e-10 * scale * reach * reach) << share;
        EXPECT_NEAR((at.section_square * n - d * at.section_moment).norm(), 0, 1e-10 * scale * reach * reach) << share;
    }
}

TEST(PartBelow, SectionsAreDerivativesAndPartsAddUp)
{
    for (const double tilt : {0.0, 1e-6, 0.02, 0.4, 0.7, 1.2, 1.56, 0.5 * pi}) {
        const double c = std::cos(tilt), s = std::sin(tilt);
        const Vec<3> n(s, 0.28 * c, -0.96 * c);
        expect_sections_to_be_derivatives<3>(*make_capsule<3>(0.5, 1.5), n, 1e-3);
        expect_sections_to_be_derivatives<3>(*make_cylinder(0.5, 1.5), n, 1e-2);
        expect_sections_to_be_derivatives<3>(*make_box<3>({1, 0.4, 2}), n, 1e-2);
        expect_sections_to_be_derivatives<2>(*make_capsule<2>(0.5, 1.5), Vec<2>(s, -c), 1e-2);
        expect_sections_to_be_derivatives<2>(*make_box<2>({1, 0.4}), Vec<2>(-s, c), 2e-2);
    }
    SurfaceMesh<2> polygon; // not convex
    polygon.vertices = {Vec<2>(0, 0), Vec<2>(2, 0), Vec<2>(2, 1.5), Vec<2>(1, 0.4), Vec<2>(0.2, 1.2)};
    for (int k = 0; k < 5; ++k) {
        polygon.elements.push_back({k, (k + 1) % 5});
        polygon.patch.push_back(k);
    }
    expect_sections_to_be_derivatives<2>(*make_mesh<2>(polygon, "polygon"), Vec<2>(0.6, 0.8), 1e-2);
}

} // namespace
} // namespace gapflow::testing
