// Films of all pairs (film/film_set.hpp): which of two bodies is the master.
#include "gapflow/film/film_set.hpp"

#include "unit/film/film_scene.hpp"

#include <gtest/gtest.h>

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

} // namespace
} // namespace gapflow::test
