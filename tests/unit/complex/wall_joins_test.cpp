// Ducts thinner than a cell: what leads through a wall, however it lies in the grid, and what does not.
#include "checks.hpp"

#include "gapflow/core/disjoint_sets.hpp"

#include <numbers>

namespace gapflow::testing {
namespace {

/// Number of connected bodies of fluid.
int count_fluids(const Grid<3>& grid, const Complex<3>& complex)
{
    const int cells = static_cast<int>(complex.index.count);
    std::vector<int> up(cells + complex.parts());
    for (int k = 0; k < static_cast<int>(up.size()); ++k)
        up[k] = k;
    const auto root = [&](int k) {
        while (up[k] != k)
            k = up[k] = up[up[k]];
        return k;
    };
    const auto number = [&](const PartOrCell& side) { return side.is_part() ? cells + side.number() : side.number(); };
    const auto join = [&](const PartOrCell& a, const PartOrCell& b) {
        if (a.exists() && b.exists())
            up[root(number(a))] = root(number(b));
    };
    for (const FacePiece<3>& piece : complex.pieces)
        join(piece.low, piece.high);
    for (const CornerLink<3>& link : complex.links)
        join(PartOrCell::part(link.a), PartOrCell::part(link.b));
    for (int d = 0; d < 3; ++d)
        for_each_index<3>(complex.index.low, owned_faces_end(grid, d), [&](const Index<3>& f) {
            const Index<3> below = f - step<3>(d);
            if (grid.in_domain(below) && grid.in_domain(f) && complex.main_area[d][complex.index(f)] > 0)
                join(complex.main_of(complex.index(below)), complex.main_of(complex.index(f)));
        });
    int count = 0;
    for (int c = 0; c < cells; ++c)
        count += complex.cell[c] == Complex<3>::open && root(c) == c;
    for (int p = 0; p < complex.parts(); ++p)
        count += root(cells + p) == cells + p;
    return count;
}

/// A square plate of edges 2 and this thickness, normal z, with a round hole of n corners, or none.
std::unique_ptr<Shape<3>> plate(double thickness, double radius, int n)
{
    SurfaceMesh<3> mesh;
    for (const auto& [outer, height] : {std::pair{true, 0.5}, {false, 0.5}, {false, -0.5}, {true, -0.5}})
        for (int k = 0; k < n; ++k) {
            const double a = 2 * std::numbers::pi * k / n, c = std::cos(a), s = std::sin(a);
            const double r = outer ? 1 / std::max(std::abs(c), std::abs(s)) : radius;
            mesh.vertices.push_back(Vec<3>(r * c, r * s, height * thickness));
        }
    for (int ring = 0; ring < 4; ++ring)
        for (int k = 0; k < n; ++k) {
            const int a = ring * n + k, b = ring * n + (k + 1) % n, c = (ring + 1) % 4 * n + k,
                      d = (ring + 1) % 4 * n + (k + 1) % n;
            mesh.elements.push_back({a, b, d});
            mesh.elements.push_back({a, d, c});
        }
    return make_mesh<3>(std::move(mesh), "plate");
}

void expect_fluids(const Grid<3>& grid, const Scene<3>& scene, int count, const std::string& what)
{
    const Complex<3> complex = build_complex<3>(grid, scene.solids);
    EXPECT_EQ(count_fluids(grid, complex), count) << what;
    EXPECT_LE(sums_of(grid, complex, scene.solids).closure, 1e-12) << what;
}

class Ducts : public ::testing::TestWithParam<int> {
protected:
    std::mt19937 random{static_cast<unsigned>(GetParam())};
    double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }
    Vec<3> place() { return Vec<3>(number(0.4, 0.6), number(0.4, 0.6), number(0.4, 0.6)); }
};

TEST_P(Ducts, HoleOfAMesh)
{
    const Grid<3> grid = unit_grid<3>(8);
    for (const double cells : {0.1, 0.6, 1.7, 3.0})
        for (const double radius : {0.02, 0.2, 0.45}) {
            const Vec<3> x = place();
            const double angle = GetParam() % 3 ? number(0, 6.28) : 0;
            Scene<3> open(grid), closed(grid);
            open.add("plate", plate(cells / 8, radius / 8, 12), pose<3>(x, angle));
            closed.add("plate", make_box<3>(Vec<3>(2, 2, cells / 8)), pose<3>(x, angle));
            const std::string what = "thickness " + std::to_string(cells) + " radius " + std::to_string(radius);
            expect_fluids(grid, open, 1, what);
            expect_fluids(grid, closed, 2, what);
        }
}

TEST_P(Ducts, PipeKeepsItsInsideApart)
{
    // A long tube of a mesh: the same rings, the hole's axis long and the plate small.
    const Grid<3> grid = unit_grid<3>(8);
    Scene<3> scene(grid);
    SurfaceMesh<3> mesh = plate(3, 0.2 / 8, 12)->display_mesh(0);
    for (Vec<3>& x : mesh.vertices)
        if (std::hypot(x[0], x[1]) > 0.5)
            x.head<2>() *= 0.3 / 8 / std::hypot(x[0], x[1]);
    scene.add("tube", make_mesh<3>(std::move(mesh), "tube"), pose<3>(place(), number(0, 6.28)));
    expect_fluids(grid, scene, 2, "tube");
}

TEST_P(Ducts, ContainerThinnerThanACell)
{
    const Grid<3> grid = unit_grid<3>(8);
    for (const double radius : {0.05, 0.2, 0.4}) {
        Scene<3> round(grid), square(grid);
        round.add("pipe", make_inside_out<3>(make_cylinder(radius / 8, 0.5)), pose<3>(place(), number(0, 6.28)));
        expect_fluids(grid, round, 1, "round pipe of " + std::to_string(radius));
        square.add("pipe", make_inside_out<3>(make_box<3>(Vec<3>(0.5, radius / 8, 2 * radius / 8))),
                   pose<3>(place(), number(0, 6.28)));
        expect_fluids(grid, square, 1, "square pipe of " + std::to_string(radius));
    }
}

TEST_P(Ducts, FrameOfBoxes)
{
    // Four boxes leave a duct of 0.2 x 0.3 cells open.
    const Grid<3> grid = unit_grid<3>(8);
    for (const double cells : {1.5, 2.5}) {
        const Vec<3> x(number(0.4, 0.6), number(0.4, 0.6), 0.5 + number(-0.05, 0.05));
        Scene<3> scene(grid);
        for (const int side : {-1, 1}) {
            scene.add("wide", make_box<3>(Vec<3>(2, 3, cells / 8)), pose<3>(x + side * Vec<3>(1 + 0.1 / 8, 0, 0)));
            scene.add("short", make_box<3>(Vec<3>(0.1, 2, 0.9 * cells / 8)), pose<3>(x + side * Vec<3>(0, 1 + 0.15 / 8, 0)));
        }
        expect_fluids(grid, scene, 1, "frame of " + std::to_string(cells));
    }
}

INSTANTIATE_TEST_SUITE_P(Places, Ducts, ::testing::Range(0, 12));

} // namespace
} // namespace gapflow::testing
