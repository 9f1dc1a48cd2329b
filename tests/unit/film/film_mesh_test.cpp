// Film meshes of flat bodies: areas, thickness, rims and their kinds are exact.
#include "film_mesh_checks.hpp"

namespace gapflow::test {
namespace {

constexpr double gap = 0.005;

template <int D>
Vec<D> up(double height, double aside = 0)
{
    Vec<D> x = Vec<D>::Constant(0.3);
    x[0] += aside;
    x[D - 1] = height;
    return x;
}

template <int D>
std::unique_ptr<Shape<D>> plate(double width)
{
    Vec<D> size = Vec<D>::Constant(width);
    size[D - 1] = 3;
    return make_box<D>(size);
}

template <int D>
void facing_plates()
{
    const FilmMeshOptions options = options_with(1);
    const auto box = plate<D>(7.3);
    const auto films = films_of<D>(place<D>(box, up<D>(0)), place<D>(box, up<D>(3 + gap)), options);
    ASSERT_EQ(films.size(), 1u);
    const FilmMesh<D>& film = films[0];
    check_film(film, options);
    const double exact = std::pow(7.3, D - 1);
    EXPECT_NEAR(area(film), exact, 1e-12 * exact);
    EXPECT_NEAR(volume(film), exact * gap, 1e-11 * exact * gap);
    EXPECT_LT((other_area(film) - exact * unit<D>(D - 1)).norm(), 1e-11 * exact);
    EXPECT_TRUE(film.flat);
    EXPECT_FALSE(film.capped);
    const auto rim = rim_lengths(film);
    ASSERT_EQ(rim.size(), 1u);
    EXPECT_NEAR(rim.at(RimEnd::master_edge), D == 2 ? 2 : 4 * 7.3, 1e-11);
    for (double h : film.h)
        EXPECT_NEAR(h, gap, 1e-14);
    for (const auto& e : film.elements) {
        EXPECT_NEAR(e.inverse, e.measure / gap, 1e-10 * e.inverse);
        EXPECT_NEAR(e.normal[D - 1], 1, 1e-14);
        EXPECT_FALSE(e.coarse);
    }
}

// The edge of a tilted box rests on a plate, and the wedge beside it ends where they touch: along that line elements are no finer than across the wedge's other end.
TEST(FilmMesh, TheTipOfAWedgeIsNoFinerThanOtherEnds)
{
    FilmMeshOptions options = coupling_sizes<3>(true);
    options.floor = options.touching.emplace(0.0005);
    const Rotation<3> tilt(Eigen::AngleAxisd(0.5, Vec<3>::UnitY()));
    const auto box = make_box<3>({7.3, 7.3, 3}), floor = make_box<3>({20, 20, 3});
    const double rest = 1.5 + 0.5 * (7.3 * std::sin(0.5) + 3 * std::cos(0.5));
    const auto films = films_of<3>(place<3>(box, up<3>(rest), tilt), place<3>(floor, up<3>(0)), options);
    ASSERT_EQ(films.size(), 1u);
    check_film(films[0], options);
    EXPECT_NEAR(rim_lengths(films[0]).at(RimEnd::touching), 7.3, 1e-6);
    EXPECT_LT(films[0].h.size(), 600u); // 14 000 as fine as the gap is thin
    options.straddle = 0.02;
    const auto finer = films_of<3>(place<3>(box, up<3>(rest), tilt), place<3>(floor, up<3>(0)), options);
    EXPECT_GT(finer.at(0).h.size(), 4 * films[0].h.size());
    EXPECT_NEAR(volume(films[0]), volume(finer[0]), 1e-9 * volume(finer[0]));
}

TEST(FilmMesh, PlatesThatFaceEachOther2D)
{
    facing_plates<2>();
}
TEST(FilmMesh, PlatesThatFaceEachOther3D)
{
    facing_plates<3>();
}

TEST(FilmMesh, PointsStayInOneCell)
{
    FilmMeshOptions options = options_with(1);
    options.origin = {0.11, -0.37, 0.2};
    const auto box = plate<3>(4);
    for (const auto& film : films_of<3>(place<3>(box, up<3>(0)), place<3>(box, up<3>(3 + gap)), options))
        for (int axis = 0; axis < 2; ++axis) {
            double length = 0; // of the film in the first full cell, by points
            for (const auto& p : film.points)
                if (const double x = p.y[axis] - options.origin[axis]; x > 0 && x < 1)
                    length += p.weight / 4;
            EXPECT_NEAR(length, 1, 1e-12);
        }
}

TEST(FilmMesh, PlatesThatOverlapInPart2D)
{
    const FilmMeshOptions options = options_with(1);
    const auto box = plate<2>(7.3);
    const auto films = films_of<2>(place<2>(box, up<2>(0)), place<2>(box, up<2>(3 + gap, 2.123)), options);
    ASSERT_EQ(films.size(), 1u);
    check_film(films[0], options);
    EXPECT_NEAR(area(films[0]), 7.3 - 2.123, 1e-11);
    const auto rim = rim_lengths(films[0]);
    EXPECT_EQ(rim.at(RimEnd::master_edge), 1);
    EXPECT_EQ(rim.at(RimEnd::other_edge), 1);
}

TEST(FilmMesh, PlatesThatOverlapInPart3D)
{
    const FilmMeshOptions options = options_with(1);
    const auto box = plate<3>(15.3);
    for (double turn : {0.0, 0.7}) {
        const Rotation<3> rotation(Eigen::AngleAxisd(turn, Vec<3>(1, 2, 3).normalized()));
        const Vec<3> aside(2.123, -3.21, 3 + gap);
        const auto films = films_of<3>(place<3>(box, Vec<3>(5, 6, 7), rotation),
                                       place<3>(box, Vec<3>(5, 6, 7) + rotation * aside, rotation), options);
        ASSERT_EQ(films.size(), 1u);
        check_film(films[0], options);
        const double a = 15.3 - 2.123, b = 15.3 - 3.21;
        EXPECT_NEAR(area(films[0]), a * b, 1e-6 * a * b);
        const auto rim = rim_lengths(films[0]);
        EXPECT_NEAR(rim.at(RimEnd::master_edge), a + b, 1e-9);
        EXPECT_NEAR(rim.at(RimEnd::other_edge), a + b, 0.02);
    }
}

TEST(FilmMesh, BoxOnWallHasItsOwnEdgesAsRim)
{
    const FilmMeshOptions options = options_with(1);
    const auto box = plate<3>(4), wall = make_half_space<3>(unit<3>(2));
    const auto films = films_of<3>(place<3>(box, up<3>(1.5 + gap)), place<3>(wall, Vec<3>::Zero()), options);
    ASSERT_EQ(films.size(), 1u);
    check_film(films[0], options);
    EXPECT_NEAR(area(films[0]), 16, 1e-12);
    EXPECT_NEAR(rim_lengths(films[0]).at(RimEnd::master_edge), 16, 1e-11);
    EXPECT_LT((films[0].elements[0].normal + unit<3>(2)).norm(), 1e-14);
}

TEST(FilmMesh, BoxInRoomHasOneFilmAWall)
{
    const FilmMeshOptions options = options_with(1);
    const auto box = plate<2>(4), room = make_inside_out<2>(make_box<2>({12, 12}));
    const auto films = films_of<2>(place<2>(box, Vec<2>(4 - gap, 0)), place<2>(room, Vec<2>::Zero()), options);
    ASSERT_EQ(films.size(), 1u); // h = 4.5 above and below
    const auto thin = make_inside_out<2>(make_box<2>({12, 4}));
    const auto three = films_of<2>(place<2>(box, Vec<2>(4 - gap, 0)), place<2>(thin, Vec<2>::Zero()), options);
    ASSERT_EQ(three.size(), 3u);
    double total = 0;
    for (const auto& film : three) {
        check_film(film, options);
        total += area(film);
    }
    // upper and lower film end where the wall at the side becomes nearer
    EXPECT_NEAR(total, 3 + 2 * (4 - (0.5 - gap)), 1e-10);
}

TEST(FilmMesh, WedgeEndsWhereThicknessIsReached)
{
    const double slope = 25 * std::numbers::pi / 180, lowest = 1e-3;
    const FilmMeshOptions options = options_with(1);
    const auto box2 = make_box<2>({8, 4});
    const auto wall2 = make_half_space<2>(unit<2>(1));
    const double height = 4 * std::sin(slope) + 2 * std::cos(slope) + lowest;
    const auto films2 =
        films_of<2>(place<2>(box2, Vec<2>(0, height), Rotation<2>(slope)), place<2>(wall2, Vec<2>::Zero()), options);
    ASSERT_EQ(films2.size(), 1u);
    check_film(films2[0], options);
    double length = 0, inverse = 0, volume2 = volume(films2[0]);
    for (const auto& e : films2[0].elements) {
        length += (films2[0].x[e.nodes[0]] - films2[0].x[e.nodes[1]]).norm();
        inverse += e.inverse;
        EXPECT_LT(std::abs(std::log(films2[0].h[e.nodes[0]] / films2[0].h[e.nodes[1]])), std::log(1.5) + 1e-6);
    }
    EXPECT_NEAR(length, (1 - lowest) / std::sin(slope), 1e-11);
    const double mid = area(films2[0]) / length;
    const double across = std::cos(std::atan(0.5 * std::tan(slope))); // between the middle's normal and the wall's
    EXPECT_NEAR(inverse, std::log(1 / lowest) / std::sin(slope) * mid / across, 1e-9);
    EXPECT_NEAR(volume2, 0.5 * length * (1 + lowest) * std::cos(slope), 1e-11);

    const auto box3 = make_box<3>({8, 6, 4});
    const auto wall3 = make_half_space<3>(unit<3>(2));
    const auto films3 = films_of<3>(place<3>(box3, Vec<3>(0, 0, height), Rotation<3>(Eigen::AngleAxisd(-slope, unit<3>(1)))),
                                    place<3>(wall3, Vec<3>::Zero()), options);
    ASSERT_EQ(films3.size(), 1u);
    check_film(films3[0], options);
    EXPECT_NEAR(area(films3[0]), 6 * length * mid, 1e-9);
    EXPECT_NEAR(volume(films3[0]), 6 * volume2, 1e-9);
    EXPECT_NEAR(rim_lengths(films3[0]).at(RimEnd::thickness), 6, 1e-9);
}

TEST(FilmMesh, CapOnNodesCoarsens)
{
    FilmMeshOptions options = options_with(1);
    options.node_cap = 150;
    const auto box = plate<3>(12);
    const auto films = films_of<3>(place<3>(box, up<3>(0)), place<3>(box, up<3>(3 + gap)), options);
    ASSERT_EQ(films.size(), 1u);
    EXPECT_TRUE(films[0].capped);
    EXPECT_LE(films[0].x.size(), 150u);
    EXPECT_NEAR(area(films[0]), 144, 1e-10);
}

TEST(FilmMesh, OverlapUsesTheFloor)
{
    const FilmMeshOptions options = options_with(1);
    const auto box = plate<3>(3), wall = make_half_space<3>(unit<3>(2));
    for (double depth : {0.0, 1e-12, 1e-3}) {
        const auto films = films_of<3>(place<3>(box, up<3>(1.5 - depth)), place<3>(wall, Vec<3>::Zero()), options);
        ASSERT_EQ(films.size(), 1u);
        check_film(films[0], options);
        EXPECT_NEAR(area(films[0]), 9, 1e-12);
        for (double h : films[0].h)
            EXPECT_EQ(h, options.floor);
    }
}

TEST(FilmMesh, FarOrUnboundedMastersHaveNone)
{
    const FilmMeshOptions options = options_with(1);
    const auto box = plate<3>(3), wall = make_half_space<3>(unit<3>(2));
    EXPECT_TRUE(films_of<3>(place<3>(box, up<3>(2.6)), place<3>(wall, Vec<3>::Zero()), options).empty());
    EXPECT_TRUE(films_of<3>(place<3>(wall, Vec<3>::Zero()), place<3>(box, up<3>(1.6)), options).empty());
}

TEST(InGap, NeedsThicknessFacingNormalsAndFaces)
{
    const auto box = plate<2>(4);
    const auto lower = place<2>(box, Vec<2>(0, 0)), upper = place<2>(box, Vec<2>(1, 3.2));
    EXPECT_TRUE(in_gap<2>(lower, upper, {0.5, 1.6}, 0.3));
    EXPECT_FALSE(in_gap<2>(lower, upper, {0.5, 1.6}, 0.1));
    EXPECT_FALSE(in_gap<2>(lower, upper, {-1.2, 1.6}, 1.0));
    EXPECT_FALSE(in_gap<2>(lower, upper, {2.2, 1.6}, 1.0));
}

// A skin leaves the mesh where it is and takes the same off every thickness: volume less skin times area.
TEST(FilmMesh, ASkinIsTakenOffTheThickness)
{
    const auto box = plate<2>(7.3);
    auto films = films_of<2>(place<2>(box, up<2>(0)), place<2>(box, up<2>(3 + gap)), options_with(1));
    ASSERT_EQ(films.size(), 1u);
    FilmMesh<2>& film = films[0];
    const FilmMesh<2> before = film;
    take_skin_off(film, 0.8 * gap);
    EXPECT_EQ(film.skin, 0.8 * gap);
    EXPECT_NEAR(area(film), 7.3, 1e-12 * 7.3);
    EXPECT_NEAR(volume(film), 7.3 * 0.2 * gap, 1e-11 * gap);
    for (std::size_t i = 0; i < film.h.size(); ++i) {
        EXPECT_NEAR(film.h[i], 0.2 * gap, 1e-13);
        EXPECT_EQ(film.mid[i], before.mid[i]);
    }
    for (const FilmElement<2>& e : film.elements)
        EXPECT_NEAR(e.inverse, e.measure / (0.2 * gap), 1e-8 * e.inverse);
}

} // namespace
} // namespace gapflow::test
