// Films of all pairs (film/film_set.hpp): which of two bodies is the master.
#include "gapflow/film/film_set.hpp"

#include "unit/film/film_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace gapflow::test {
namespace {

template <int D>
int master_of(double radius_a, double radius_b, const Vec<D>& place)
{
    FilmScene<D> scene(12);
    scene.add_ball("b", radius_b, place);
    Vec<D> beside = place;
    beside[0] += radius_a + radius_b + 0.2;
    scene.add_ball("a", radius_a, beside);
    scene.clip();
    const std::vector<Film<D>> films = scene.films();
    return films.empty() ? -1 : films.front().pair.master;
}

TEST(FilmSet, OfEqualBodiesTheNameSaysWhoIsMasterWhereverTheyAre) // their bounds in the world differ by round-off
{
    for (int k = 0; k < 40; ++k) {
        const double shift = 0.07391 * k;
        EXPECT_EQ(master_of<2>(1.7, 1.7, {2.5 + shift, 3.1 + 0.5 * shift}), 1) << k;
    }
    EXPECT_EQ(master_of<3>(1.7, 1.7, {2.5, 3.1, 3.3}), 1);
    EXPECT_EQ(master_of<3>(1.7, 1.7, {2.537, 3.17, 3.3}), 1);
}

TEST(FilmSet, TheSmallerBodyIsMaster)
{
    EXPECT_EQ(master_of<2>(1.7, 1.6, {2.5, 3.1}), 0);
    EXPECT_EQ(master_of<2>(1.6, 1.7, {2.5, 3.1}), 1);
}

/// Waves of the sea bed, `count` x `count` squares of two triangles over a square of the given width, closed below.
SurfaceMesh<3> bed(int count, double width)
{
    SurfaceMesh<3> mesh;
    const auto at = [&](int i, int k, int layer) { return (layer * (count + 1) + k) * (count + 1) + i; };
    for (int layer = 0; layer < 2; ++layer)
        for (int k = 0; k <= count; ++k)
            for (int i = 0; i <= count; ++i) {
                const double x = width * (double(i) / count - 0.5), y = width * (double(k) / count - 0.5);
                mesh.vertices.emplace_back(x, y, layer == 0 ? -0.25 * width : 0.05 * std::sin(3 * x) * std::cos(2 * y));
            }
    const auto square = [&](int a, int b, int c, int d) { mesh.elements.insert(mesh.elements.end(), {{a, b, c}, {a, c, d}}); };
    for (int k = 0; k < count; ++k)
        for (int i = 0; i < count; ++i) {
            square(at(i, k, 1), at(i + 1, k, 1), at(i + 1, k + 1, 1), at(i, k + 1, 1));
            square(at(i, k, 0), at(i, k + 1, 0), at(i + 1, k + 1, 0), at(i + 1, k, 0));
        }
    for (int i = 0; i < count; ++i) {
        square(at(i, 0, 0), at(i + 1, 0, 0), at(i + 1, 0, 1), at(i, 0, 1));
        square(at(count, i, 0), at(count, i + 1, 0), at(count, i + 1, 1), at(count, i, 1));
        square(at(i + 1, count, 0), at(i, count, 0), at(i, count, 1), at(i + 1, count, 1));
        square(at(0, i + 1, 0), at(0, i, 0), at(0, i, 1), at(0, i + 1, 1));
    }
    return mesh;
}

// Where the bed runs through the walls it is not refined all along them, beyond the domain.
TEST(FilmSet, OfABedFarWiderThanTheDomain)
{
    namespace t = gapflow::testing;
    const Grid<3> grid = t::unit_grid<3>(12);
    t::Scene<3> scene(grid);
    long asked = 0;
    scene.add("bed", std::make_unique<t::Counting<3>>(make_mesh<3>(bed(40, 20), "bed"), asked), t::pose<3>({0.5, 0.5, 0.25}));
    scene.add("ball", make_ball<3>(0.2), t::pose<3>({0.4, 0.5, 0.5}));
    const FaceClipper<3> clipper(grid, scene.solids, FractionMode::cut_cell);
    const auto settings = [&](int a, int b) {
        GapSettings gap;
        gap.threshold = 1.5 * grid.dx();
        gap.floor = 1e-9;
        if (scene.solids[a].wall || scene.solids[b].wall)
            gap.touching = 1e-6 * grid.dx();
        return gap;
    };
    asked = 0;
    const std::vector<Film<3>> films = find_films<3>(grid, scene.solids, clipper, settings, {});
    EXPECT_FALSE(films.empty());
    EXPECT_LT(asked, 20000);
}

} // namespace
} // namespace gapflow::test
