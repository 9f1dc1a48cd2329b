// The polygons and polyhedra of parts: closed, and as large as what the solids leave.
#include "checks.hpp"

#include "gapflow/complex/part_borders.hpp"

#include <gmock/gmock.h>

#include <numbers>

namespace gapflow::testing {
namespace {

/// Volume of all fluid, from the parts' borders and the whole cells; each border closed.
template <int D>
double fluid_volume(const Grid<D>& grid, const Scene<D>& scene)
{
    PartBorders<D> borders;
    const Complex<D> complex = build_complex<D>(grid, scene.solids, nullptr, &borders);
    std::vector<Vec<D>> area(complex.parts(), Vec<D>::Zero());
    std::vector<double> volume(complex.parts(), 0);
    for (const PartFace<D>& face : borders) {
        area[face.part] += face.area();
        volume[face.part] += face.volume(Vec<D>(complex.cell_of_part(face.part).template cast<double>()));
    }
    double sum = 0;
    for (int p = 0; p < complex.parts(); ++p) {
        EXPECT_LE(area[p].norm(), 1e-8) << "part " << p << " of cell " << complex.cell_of_part(p).transpose();
        EXPECT_GE(volume[p], -1e-4) << "part " << p << " of cell " << complex.cell_of_part(p).transpose();
        EXPECT_LE(volume[p], 1 + 1e-9);
        sum += volume[p];
    }
    for (const std::int32_t cell : complex.cell)
        sum += cell == Complex<D>::open;
    return sum;
}

template <int D>
void expect_volume(const std::string& what, std::unique_ptr<Shape<D>> shape, const Pose<D>& at, SideKind sides,
                   double tolerance)
{
    const Grid<D> grid = unit_grid<D>(10, all_sides<D>(sides));
    Scene<D> scene(grid);
    const double volume = shape->mass_properties().volume;
    scene.add("solid", std::move(shape), at);
    EXPECT_NEAR(fluid_volume(grid, scene), std::pow(10, D) * (1 - volume), tolerance) << what;
}

TEST(PartBorders, FillWhatSolidsLeave)
{
    for (int k = 0; k < 20 && !HasFailure(); ++k) {
        std::mt19937 random(k);
        std::uniform_real_distribution<double> number(0, 1);
        const SideKind sides = k % 2 ? SideKind::periodic : SideKind::wall;
        const double low = k % 2 ? 0.0 : 0.4, width = k % 2 ? 1.0 : 0.2, angle = k % 4 < 2 ? 0.0 : 6 * number(random);
        const Pose<2> at = pose<2>(Vec<2>(low + width * number(random), low + width * number(random)), angle);
        expect_volume<2>("box", make_box<2>(Vec<2>(0.52, 0.31)), at, sides, 1e-9);
        expect_volume<2>("plate", make_box<2>(Vec<2>(0.52, 0.003)), at, sides, 1e-9);
        expect_volume<2>("disk", make_ball<2>(0.23), at, sides, 3e-2);
        expect_volume<2>("small disk", make_ball<2>(0.013), at, sides, 1e-3);
        const Pose<3> in_space =
            pose<3>(Vec<3>(low + width * number(random), low + width * number(random), low + width * number(random)), angle);
        // Where three dividing planes meet at a corner their line is taken through the mean of its ends on the hull.
        expect_volume<3>("box", make_box<3>(Vec<3>(0.52, 0.31, 0.23)), in_space, sides, 2);
        expect_volume<3>("plate", make_box<3>(Vec<3>(0.52, 0.31, 0.003)), in_space, sides, 2);
        expect_volume<3>("ball", make_ball<3>(0.23), in_space, sides, 1.5);
    }
}

TEST(PartBorders, OfSolidsThatMeetAreClosed)
{
    for (int k = 0; k < 20 && !HasFailure(); ++k) {
        std::mt19937 random(k);
        std::uniform_real_distribution<double> number(0, 1);
        const Grid<3> grid = unit_grid<3>(10);
        Scene<3> scene(grid);
        for (int n = 0; n < 3; ++n) {
            const Pose<3> at =
                pose<3>(Vec<3>(0.35 + 0.3 * number(random), 0.35 + 0.3 * number(random), 0.35 + 0.3 * number(random)),
                        6 * number(random));
            if (n < 2)
                scene.add("box", make_box<3>(Vec<3>(0.3, 0.2, 0.1)), at);
            else
                scene.add("cylinder", make_cylinder(0.1, 0.3), at);
        }
        EXPECT_GT(fluid_volume(grid, scene), 950);
    }
}

TEST(PartBorders, CutsLeadToHoles)
{
    const std::vector<Vec<2>> square{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, hole{{3, 3}, {3, 2}, {2, 2}, {2, 3}};
    const std::vector<Vec<2>> outline = with_holes<2>({square, hole});
    ASSERT_EQ(outline.size(), 10u);
    double area = 0;
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const Vec<2>&a = outline[k], &b = outline[(k + 1) % outline.size()];
        area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
    }
    EXPECT_DOUBLE_EQ(area, 15);
}

} // namespace
} // namespace gapflow::testing
