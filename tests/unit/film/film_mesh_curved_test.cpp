// Film meshes of curved bodies: extent, size of elements, films that close on themselves or switch patches, invariance.
#include "film_mesh_checks.hpp"

#include "gapflow/film/film_set.hpp"
#include "gapflow/film/rim_points.hpp"

#include <Eigen/Sparse>

#include <random>

namespace gapflow::test {
namespace {

constexpr double pi = std::numbers::pi;

/// Half the width of the film of a ball over a plane.
double half_width(double radius, double gap, double threshold)
{
    return std::sqrt(radius * radius - std::pow(radius + gap - threshold, 2));
}

TEST(CurvedFilm, DiskOverWall)
{
    const auto disk = make_ball<2>(5), wall = make_half_space<2>(unit<2>(1));
    for (double gap : {0.1, 1e-3, 1e-7}) {
        FilmMeshOptions options = options_with(0.5);
        options.smallest = 1e-6;
        double exact = 0;
        for (double refine : {0.0625, 2.0, 1.0, 0.5, 0.25}) { // the first: the reference
            options.largest = 0.5 * refine;
            options.curved = 0.2 * refine;
            options.spacing = 0.25 * refine;
            options.ratio = std::pow(1.5, refine);
            const auto films = films_of<2>(place<2>(disk, Vec<2>(0.1, 5 + gap)), place<2>(wall, Vec<2>::Zero()), options);
            ASSERT_EQ(films.size(), 1u);
            check_film(films[0], options);
            ASSERT_EQ(films[0].rim.size(), 2u);
            for (const auto& r : films[0].rim) {
                EXPECT_EQ(r.end, RimEnd::thickness);
                EXPECT_NEAR(films[0].h[r.nodes[0]], 0.5, 1e-11);
                EXPECT_NEAR(std::abs(films[0].x[r.nodes[0]][0] - 0.1), half_width(5, gap, 0.5), 1e-10);
            }
            for (const auto& e : films[0].elements)
                EXPECT_FALSE(e.coarse);
            if (refine < 0.2)
                exact = volume(films[0]);
            else
                EXPECT_LT(std::abs(volume(films[0]) / exact - 1), 2e-3 * refine * refine); // second order
        }
    }
}

TEST(CurvedFilm, BallOverWall)
{
    const auto ball = make_ball<3>(5), wall = make_half_space<3>(unit<3>(2));
    for (double gap : {0.1, 1e-3, 1e-6}) {
        const FilmMeshOptions options = options_with(0.5);
        const auto films = films_of<3>(place<3>(ball, Vec<3>(0.1, 0.2, 5 + gap)), place<3>(wall, Vec<3>::Zero()), options);
        ASSERT_EQ(films.size(), 1u);
        const FilmMesh<3>& film = films[0];
        check_film(film, options);
        EXPECT_LT(film.x.size(), 4000u);
        const double a = half_width(5, gap, 0.5);
        EXPECT_NEAR(-other_area(film)[2], pi * a * a, 2e-3 * pi * a * a);
        for (const auto& r : film.rim) {
            EXPECT_EQ(r.end, RimEnd::thickness);
            for (int n : r.nodes)
                EXPECT_NEAR(film.h[n], 0.5, 1e-10);
        }
        for (const auto& e : film.elements)
            for (int k = 0; k < 3; ++k) {
                const int i = e.nodes[k], j = e.nodes[(k + 1) % 3];
                const double size = 0.2 * std::sqrt(2 * 5 * std::min(film.h[i], film.h[j]));
                EXPECT_LT((film.x[i] - film.x[j]).norm(), 1.2 * std::max(size, 1. / 32));
            }
        // the gap's volume, by rings
        double exact = 0;
        const int n = 20000;
        const double angle = std::asin(a / 5);
        const auto r = [&](double t) { return 5 * std::sin(t); };
        const auto h = [&](double t) { return gap + 5 * (1 - std::cos(t)); };
        for (int i = 0; i < n; ++i) {
            const double t0 = angle * i / n, t1 = angle * (i + 1) / n;
            exact += pi * (r(t1) * r(t1) - r(t0) * r(t0)) * 0.5 * (h(t0) + h(t1));
        }
        EXPECT_NEAR(volume(film), exact, 3e-3 * exact);
    }
}

TEST(CurvedFilm, ConcentricRingsClose)
{
    const FilmMeshOptions options = options_with(0.5);
    const auto disk = make_ball<2>(4), hole = make_inside_out<2>(make_ball<2>(4.3));
    const auto ring = films_of<2>(place<2>(disk, Vec<2>(0.1, 0)), place<2>(hole, Vec<2>::Zero()), options);
    ASSERT_EQ(ring.size(), 1u);
    check_film(ring[0], options);
    EXPECT_TRUE(ring[0].rim.empty());
    EXPECT_EQ(ring[0].x.size(), ring[0].elements.size());
    EXPECT_NEAR(volume(ring[0]), pi * (4.3 * 4.3 - 16), 4e-3 * 8);
    EXPECT_LT(other_area(ring[0]).norm(), 1e-13);

    const auto ball = make_ball<3>(2), shell = make_inside_out<3>(make_ball<3>(2.3));
    const auto closed = films_of<3>(place<3>(ball, Vec<3>(0.1, 0, 0)), place<3>(shell, Vec<3>::Zero()), options);
    ASSERT_EQ(closed.size(), 1u);
    check_film(closed[0], options);
    EXPECT_TRUE(closed[0].rim.empty());
    EXPECT_LT(other_area(closed[0]).norm(), 1e-12);
    const auto n = closed[0].elements.size();
    EXPECT_EQ(closed[0].x.size(), n / 2 + 2); // Euler: a sphere
}

// A wall that slides along itself sweeps nothing into any node, also where elements' sizes jump and where planes of the grid cut them: what
// their chords would sweep is many times what a thin film between surfaces that conform carries.
TEST(CurvedFilm, WallThatSlidesAlongItselfSweepsNothing)
{
    for (const auto& [clearance, eccentricity] : {std::pair(0.01, 0.999), std::pair(0.003, 0.9)}) {
        FilmMeshOptions options = options_with(1.5);
        const double radius = 25, outer = radius * (1 + clearance);
        const auto disk = make_ball<2>(radius), hole = make_inside_out<2>(make_ball<2>(outer));
        const auto films =
            films_of<2>(place<2>(disk, Vec<2>(eccentricity * clearance * radius, 0)), place<2>(hole, Vec<2>::Zero()), options);
        ASSERT_EQ(films.size(), 1u);
        const FilmMesh<2>& film = films[0];
        check_film(film, options);
        std::vector<double> swept(film.h.size(), 0);
        for (const auto& p : film.points)
            for (int i = 0; i < 2; ++i) // of a turn about the other's centre
                swept[film.elements[p.element].nodes[i]] += p.shape[i] * moment<2>(p.share.centroid, p.share.area)[0];
        for (std::size_t i = 0; i < film.h.size(); ++i)
            EXPECT_LT(std::abs(swept[i]), 0.05 * film.h[i] * outer)
                << "node " << i << " of " << film.h.size() << ", h = " << film.h[i];
    }
}

FilmMeshOptions rings_with(double threshold)
{
    FilmMeshOptions options = coupling_sizes<3>(false);
    options.threshold = threshold;
    return options;
}

/// What a mesh in rings keeps: its rim lies outside the gap as far as the area of the polygon needs.
FilmMeshOptions limits_of(FilmMeshOptions options)
{
    options.threshold *= 1.12;
    options.largest = 1.5;
    return options;
}

TEST(RingFilm, BallOverWallHasTheGapsExtentWithFewNodes)
{
    const auto ball = make_ball<3>(5), wall = make_half_space<3>(unit<3>(2));
    FilmMeshOptions options = rings_with(1.5), fine = options;
    fine.rings = 0;
    fine.largest_curved = fine.straddle_smooth = 0.25;
    fine.curved = 0.1;
    for (double gap : {0.5, 0.1, 1e-3, 1e-6}) {
        const auto place_ball = place<3>(ball, Vec<3>(0.1, 0.2, 5 + gap));
        const auto films = films_of<3>(place_ball, place<3>(wall, Vec<3>::Zero()), options);
        ASSERT_EQ(films.size(), 1u);
        const FilmMesh<3>& film = films[0];
        check_film(film, limits_of(options));
        EXPECT_LT(film.x.size(), 150u);
        const double a = half_width(5, gap, 1.5);
        EXPECT_NEAR(-other_area(film)[2], pi * a * a, 3e-3 * pi * a * a);
        EXPECT_EQ(rim_lengths(film).size(), 1u);
        EXPECT_GT(rim_lengths(film).at(RimEnd::thickness), 2 * pi * a);
        const auto exact = films_of<3>(place_ball, place<3>(wall, Vec<3>::Zero()), fine);
        EXPECT_NEAR(volume(film), volume(exact[0]), 0.02 * volume(exact[0]));
    }
}

TEST(RingFilm, IsAsSymmetricAsThePairAndTurnsWithIt)
{
    const auto ball = make_ball<3>(4);
    const FilmMeshOptions options = rings_with(1.5);
    const Vec<3> apart(0, 0, 8.05);
    const auto films = films_of<3>(place<3>(ball, Vec<3>::Zero()), place<3>(ball, apart), options);
    ASSERT_EQ(films.size(), 1u);
    check_film(films[0], limits_of(options));
    for (int axis = 0; axis < 2; ++axis) // every node has its mirror image
        for (const Vec<3>& x : films[0].mid) {
            Vec<3> image = x;
            image[axis] = -x[axis];
            double nearest = 1e30;
            for (const Vec<3>& y : films[0].mid)
                nearest = std::min(nearest, (y - image).norm());
            EXPECT_LT(nearest, 1e-9);
        }
    const Rotation<3> turn = Eigen::Quaterniond(0.3, -0.2, 0.8, 0.4).normalized();
    const auto turned = films_of<3>(place<3>(ball, Vec<3>::Zero(), turn), place<3>(ball, turn * apart, turn), options);
    ASSERT_EQ(turned.size(), 1u);
    ASSERT_EQ(turned[0].x.size(), films[0].x.size());
    for (std::size_t i = 0; i < films[0].x.size(); ++i)
        EXPECT_LT((turned[0].x[i] - turn * films[0].x[i]).norm(), 1e-9);
}

TEST(RingFilm, EndsHalfwayToAThirdBody)
{
    const auto ball = make_ball<3>(2);
    const FilmMeshOptions options = rings_with(1.5);
    const double between = 4.1; // three balls that nearly touch each other
    const auto a = place<3>(ball, Vec<3>::Zero()), b = place<3>(ball, Vec<3>(between, 0, 0)),
               c = place<3>(ball, Vec<3>(0.5 * between, std::sqrt(0.75) * between, 0));
    const auto films = films_of<3>(a, b, options, [&](const Vec<3>& x, const Vec<3>&) { return c.distance(x); });
    ASSERT_EQ(films.size(), 1u);
    check_film(films[0], limits_of(options));
    EXPECT_LT(films[0].x.size(), 150u);
    for (const auto& r : films[0].rim)
        if (r.end == RimEnd::third_body) {
            for (int n : r.nodes)
                EXPECT_LT(b.distance(films[0].x[n]), c.distance(films[0].x[n]) + 1e-9);
        }
    const auto alone = films_of<3>(a, b, options);
    EXPECT_LE(area(films[0]), area(alone[0]) * (1 + 1e-12));
}

// Whether balls that touch overlap or not is their places' round-off.
TEST(RingFilm, BallsThatTouchHaveTheSameRings)
{
    const auto ball = make_ball<3>(2);
    const Vec<3> way = Vec<3>(1, 2, -1).normalized();
    std::vector<std::size_t> nodes;
    for (double gap : {1e-12, 0.0, -1e-12, -1e-9}) {
        const auto films =
            films_of<3>(place<3>(ball, Vec<3>::Zero()), place<3>(ball, Vec<3>((4 + gap) * way)), rings_with(1.5));
        ASSERT_EQ(films.size(), 1u);
        nodes.push_back(films[0].x.size());
    }
    EXPECT_EQ(nodes, std::vector<std::size_t>(nodes.size(), nodes[0]));
}

// One mouth an edge of the rim, half as many as edges of half a cell would have: films of crowds have most of their cost in mouths.
TEST(RingFilm, HasAPointOnEachEdgeOfItsRim)
{
    const auto ball = make_ball<3>(4), wall = make_half_space<3>(unit<3>(2));
    for (double gap : {1.0, 0.5, 0.1, 1e-3}) {
        std::vector<Film<3>> films;
        for (FilmMesh<3>& mesh :
             films_of<3>(place<3>(ball, Vec<3>(0.1, 0.2, 4 + gap)), place<3>(wall, Vec<3>::Zero()), rings_with(1.5)))
            films.push_back({{0, 1, {}}, std::move(mesh), 1.5});
        ASSERT_EQ(films.size(), 1u);
        const std::vector<RimPoint<3>> points = rim_points<3>(films, 1.0);
        EXPECT_EQ(points.size(), films[0].mesh.rim.size());
        double length = 0;
        for (const RimPoint<3>& point : points)
            length += point.length;
        EXPECT_NEAR(length, rim_lengths(films[0].mesh).at(RimEnd::thickness), 1e-12 * length);
    }
}

// Without viscosity int 1/h is the conductance of coarse elements alone: what no one reads takes no points. Nothing else changes.
TEST(RingFilm, FindsTheInverseOfCoarseElementsAlone)
{
    const auto ball = make_ball<3>(4), wall = make_half_space<3>(unit<3>(2));
    FilmMeshOptions options = rings_with(1.5), all = options;
    options.smallest = all.smallest = 0.25; // some elements are coarse
    EXPECT_FALSE(options.inverse);
    EXPECT_TRUE(coupling_sizes<3>(true).inverse);
    all.inverse = true;
    const auto at = place<3>(ball, Vec<3>(0.1, 0.2, 4 + 1e-4)), below = place<3>(wall, Vec<3>::Zero());
    const FilmMesh<3> film = films_of<3>(at, below, options).at(0), exact = films_of<3>(at, below, all).at(0);
    ASSERT_EQ(film.points.size(), exact.points.size());
    ASSERT_EQ(film.elements.size(), exact.elements.size());
    int coarse = 0, rough = 0;
    for (std::size_t e = 0; e < film.elements.size(); ++e) {
        EXPECT_EQ(film.elements[e].volume, exact.elements[e].volume);
        EXPECT_EQ(film.elements[e].conductance(), exact.elements[e].conductance());
        coarse += film.elements[e].coarse;
        rough += film.elements[e].inverse != exact.elements[e].inverse;
    }
    EXPECT_GT(coarse, 0);
    EXPECT_GT(rough, 0);
}

// Where the gap ends at an edge of the other, it takes the refined surface.
TEST(RingFilm, IsNotForGapsThatEndAtEdges)
{
    const auto ball = make_ball<3>(5), narrow = make_box<3>({3, 3, 2}), wide = make_box<3>({20, 20, 2});
    FilmMeshOptions options = rings_with(1.5), refined = options;
    refined.rings = 0;
    const auto above = place<3>(ball, Vec<3>(0.1, 0.2, 6.1));
    const auto nodes = [&](const auto& box, const FilmMeshOptions& o) {
        return films_of<3>(above, place<3>(box, Vec<3>::Zero()), o).at(0).x.size();
    };
    EXPECT_EQ(nodes(narrow, options), nodes(narrow, refined));
    EXPECT_LT(2 * nodes(wide, options), nodes(wide, refined));
    const auto shell = make_inside_out<3>(make_ball<3>(5.3)); // not convex: all around
    EXPECT_TRUE(films_of<3>(above, place<3>(shell, Vec<3>(0.1, 0.2, 6.1)), options).at(0).rim.empty());
}

// Surfaces that touch and stand still are one solid: the film of a wedge ends where they come as near as that.
TEST(CurvedFilm, EndsWhereSurfacesTouch)
{
    const auto disk = make_ball<2>(5), wall = make_half_space<2>(unit<2>(1));
    for (double gap : {0.0, -0.1}) {
        FilmMeshOptions options = options_with(0.5);
        options.touching = 1e-2;
        options.floor = 1e-2;
        const auto films = films_of<2>(place<2>(disk, Vec<2>(0.1, 5 + gap)), place<2>(wall, Vec<2>::Zero()), options);
        ASSERT_EQ(films.size(), 2u);
        for (const auto& film : films) {
            check_film(film, options);
            const auto rim = rim_lengths(film);
            EXPECT_EQ(rim.at(RimEnd::touching), 1);
            EXPECT_EQ(rim.at(RimEnd::thickness), 1);
            for (const auto& r : film.rim)
                EXPECT_NEAR(std::abs(film.x[r.nodes[0]][0] - 0.1), half_width(5, gap, r.end == RimEnd::touching ? 1e-2 : 0.5),
                            1e-9);
        }
    }
    const auto box = make_box<3>(Vec<3>(4, 4, 4));
    const auto floor = make_half_space<3>(unit<3>(2));
    FilmMeshOptions options = options_with(0.5);
    options.touching = 1e-6;
    EXPECT_TRUE(films_of<3>(place<3>(box, Vec<3>(0.1, 0.2, 2)), place<3>(floor, Vec<3>::Zero()), options).empty());
    options.touching.reset();
    EXPECT_EQ(films_of<3>(place<3>(box, Vec<3>(0.1, 0.2, 2)), place<3>(floor, Vec<3>::Zero()), options).size(), 1u);
}

TEST(CurvedFilm, ThirdBodyEndsIt)
{
    const FilmMeshOptions options = options_with(0.5);
    const auto disk = make_ball<2>(0.8), floor = make_half_space<2>(unit<2>(1)), side = make_half_space<2>(unit<2>(0));
    const auto placed = place<2>(disk, Vec<2>(0.8 + 1e-3, 0.8 + 1e-3));
    const auto below = place<2>(floor, Vec<2>::Zero()), beside = place<2>(side, Vec<2>::Zero());
    for (int k = 0; k < 2; ++k) {
        const auto& other = k == 0 ? below : beside;
        const auto& third = k == 0 ? beside : below;
        const auto films =
            films_of<2>(placed, other, options, [&](const Vec<2>& x, const Vec<2>&) { return third.distance(x); });
        ASSERT_EQ(films.size(), 1u);
        check_film(films[0], options);
        const auto rim = rim_lengths(films[0]);
        EXPECT_EQ(rim.at(RimEnd::third_body), 1);
        EXPECT_EQ(rim.at(RimEnd::normals) + 0, 1);
        for (const auto& r : films[0].rim)
            if (r.end == RimEnd::third_body) {
                EXPECT_NEAR(films[0].x[r.nodes[0]][0], films[0].x[r.nodes[0]][1], 1e-9);
            }
    }
}

TEST(CurvedFilm, RoomCornerSwitchesPatches)
{
    const FilmMeshOptions options = options_with(0.5);
    const auto ball = make_ball<3>(0.8), room = make_inside_out<3>(make_box<3>({8, 8, 8}));
    const double c = 4 - 0.8 - 1e-3;
    const auto films = films_of<3>(place<3>(ball, Vec<3>(c, c, c)), place<3>(room, Vec<3>::Zero()), options);
    ASSERT_EQ(films.size(), 3u);
    for (const auto& film : films) {
        check_film(film, options);
        EXPECT_NEAR(area(film), area(films[0]), 1e-3 * area(film));
        EXPECT_GT(rim_lengths(film).at(RimEnd::patch), 0.5);
        for (const auto& y : film.y)
            EXPECT_NEAR(y[film.other_patch / 2], 4, 1e-12);
    }
}

TEST(CurvedFilm, TwoBallsAndCapsule)
{
    const FilmMeshOptions options = options_with(0.5);
    const auto small = make_ball<3>(2), large = make_ball<3>(6);
    const auto balls = films_of<3>(place<3>(small, Vec<3>::Zero()), place<3>(large, Vec<3>(0, 8.001, 0)), options);
    ASSERT_EQ(balls.size(), 1u);
    check_film(balls[0], options);
    const auto swapped = films_of<3>(place<3>(large, Vec<3>(0, 8.001, 0)), place<3>(small, Vec<3>::Zero()), options);
    ASSERT_EQ(swapped.size(), 1u);
    EXPECT_NEAR(volume(swapped[0]) / volume(balls[0]), 1, 0.06); // h is measured from the other side

    const auto capsule = make_capsule<3>(2, 5);
    const auto wall = make_half_space<3>(unit<3>(2));
    for (bool lower : {true, false}) {
        const auto a = place<3>(capsule, Vec<3>(0, 0, 2.1));
        const auto b = lower ? place<3>(wall, Vec<3>::Zero()) : place<3>(large, Vec<3>(1.7, 0, -6));
        const auto films = films_of<3>(a, b, options);
        ASSERT_EQ(films.size(), 1u) << "side and caps join smoothly";
        check_film(films[0], options);
        if (lower) {
            const double w = half_width(2, 0.1, 0.5);
            EXPECT_NEAR(-other_area(films[0])[2], pi * w * w + 2 * w * 5, 5e-3 * w * 5);
        }
    }
    // the capsule as the other: its patches count as one
    const auto plate = make_box<3>({9, 3, 2});
    const auto over = films_of<3>(place<3>(plate, Vec<3>(0, 0, 5.1)), place<3>(capsule, Vec<3>(0, 0, 2)), options);
    ASSERT_EQ(over.size(), 1u);
    check_film(over[0], options);
}

TEST(CurvedFilm, LyingAndStandingCylinder)
{
    const FilmMeshOptions options = options_with(0.5);
    const auto cylinder = make_cylinder(2, 6);
    const auto wall = make_half_space<3>(unit<3>(2));
    const auto lying = films_of<3>(place<3>(cylinder, Vec<3>(0, 0, 2.01)), place<3>(wall, Vec<3>::Zero()), options);
    ASSERT_EQ(lying.size(), 1u);
    check_film(lying[0], options);
    const double w = half_width(2, 0.01, 0.5);
    EXPECT_NEAR(-other_area(lying[0])[2], 2 * w * 6, 1e-9);
    EXPECT_NEAR(rim_lengths(lying[0]).at(RimEnd::thickness), 12, 1e-6);

    const Rotation<3> upright(Eigen::AngleAxisd(pi / 2, unit<3>(1)));
    const auto standing = films_of<3>(place<3>(cylinder, Vec<3>(0, 0, 3.01), upright), place<3>(wall, Vec<3>::Zero()), options);
    ASSERT_EQ(standing.size(), 1u);
    check_film(standing[0], options);
    EXPECT_NEAR(area(standing[0]), 4 * pi, 1e-3 * 4 * pi);
    EXPECT_EQ(rim_lengths(standing[0]).size(), 1u);
    EXPECT_NEAR(rim_lengths(standing[0]).at(RimEnd::master_edge), 4 * pi, 1e-3 * 4 * pi);
}

/// Force on the other of a film at density 1 that it squeezes with unit acceleration along the last axis, without viscosity; the pressure is 0 where the gap
/// gets wide.
template <int D>
double squeeze_force(const FilmMesh<D>& film)
{
    const int n = static_cast<int>(film.x.size());
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<char> open(n, 0);
    for (const RimEdge<D>& rim : film.rim)
        for (int node : rim.nodes)
            open[node] |= rim.end == RimEnd::thickness;
    Eigen::VectorXd swept = Eigen::VectorXd::Zero(n);
    for (const FilmPoint<D>& p : film.points)
        for (int k = 0; k < D; ++k)
            swept[film.elements[p.element].nodes[k]] -= p.shape[k] * wall_share(film, p).area[D - 1];
    for (const FilmElement<D>& e : film.elements)
        for (int i = 0; i < D; ++i)
            for (int j = 0; j < D; ++j)
                if (!open[e.nodes[i]] && !open[e.nodes[j]])
                    entries.emplace_back(e.nodes[i], e.nodes[j], e.conductance() * e.gradient[i].dot(e.gradient[j]));
    for (int i = 0; i < n; ++i)
        if (open[i]) {
            entries.emplace_back(i, i, 1);
            swept[i] = 0;
        }
    Eigen::SparseMatrix<double> K(n, n);
    K.setFromTriplets(entries.begin(), entries.end());
    return swept.dot(Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(K).solve(swept));
}

// Elements along a line of contact are long, those across it as small as the gap asks for: few nodes, and the force of the two-dimensional film.
TEST(CurvedFilm, LinesOfContactHaveFewNodes)
{
    const double radius = 2, length = 6, threshold = 0.8;
    const auto cylinder = make_cylinder(radius, length);
    const auto wall = make_half_space<3>(unit<3>(2));
    const auto disk = make_ball<2>(radius);
    const auto line = make_half_space<2>(unit<2>(1));
    for (const bool viscous : {false, true})
        for (double gap : {0.1, 1e-2, 1e-3}) {
            FilmMeshOptions solid = coupling_sizes<3>(viscous), flat = coupling_sizes<2>(viscous);
            solid.threshold = flat.threshold = threshold;
            flat.curved = 0.02;
            const auto films =
                films_of<3>(place<3>(cylinder, Vec<3>(0, 0, radius + gap)), place<3>(wall, Vec<3>::Zero()), solid);
            const auto fine = films_of<2>(place<2>(disk, Vec<2>(0, radius + gap)), place<2>(line, Vec<2>::Zero()), flat);
            ASSERT_EQ(films.size(), 1u);
            ASSERT_EQ(fine.size(), 1u);
            // With elements as long as wide: 0.34 to 0.47 % less than the fine film, 591, 1803, 3213 nodes (viscous: 5923).
            EXPECT_NEAR(squeeze_force(films[0]) / squeeze_force(fine[0]) / length, 1, 0.0065) << gap;
            EXPECT_LT(films[0].x.size(), gap > 0.05 ? 360u : gap > 5e-3 ? 1000u : viscous ? 2200u : 1150u) << gap;
        }
}

TEST(CurvedFilm, MovesWithThePair)
{
    const FilmMeshOptions options = options_with(0.5);
    const auto ball = make_ball<3>(3), box = make_box<3>({6, 5, 4});
    const Vec<3> a(0.2, 0.1, 5.02), b(0, 0, 0);
    const auto reference = films_of<3>(place<3>(ball, a), place<3>(box, b), options);
    ASSERT_EQ(reference.size(), 1u);
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 3; ++i) {
        const Rotation<3> r = Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random)).normalized();
        const Vec<3> t(10 * normal(random), 10 * normal(random), 10 * normal(random));
        const auto moved = films_of<3>(place<3>(ball, t + r * a, r), place<3>(box, t + r * b, r), options);
        ASSERT_EQ(moved.size(), 1u);
        EXPECT_EQ(moved[0].x.size(), reference[0].x.size());
        EXPECT_EQ(moved[0].elements.size(), reference[0].elements.size());
        EXPECT_EQ(moved[0].rim.size(), reference[0].rim.size());
        EXPECT_NEAR(area(moved[0]), area(reference[0]), 1e-9);
        EXPECT_LT((other_area(moved[0]) - r * other_area(reference[0])).norm(), 1e-9);
    }
}

template <int D>
void random_poses(const std::vector<std::unique_ptr<Shape<D>>>& shapes, int count, const FilmMeshOptions& options,
                  const FilmMeshOptions& limits)
{
    std::mt19937 random(11);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform;
    int found = 0;
    for (int i = 0; i < count; ++i) {
        const auto turn = [&] {
            if constexpr (D == 2)
                return Rotation<2>(6.3 * uniform(random));
            else
                return Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random)).normalized();
        };
        const auto a = place<D>(shapes[i % shapes.size()], Vec<D>::Zero(), turn());
        auto b = place<D>(shapes[i / shapes.size() % shapes.size()], Vec<D>::Zero(), turn());
        // bring it close along a random direction: by its distance to points of a's surface
        Vec<D> direction = Vec<D>::NullaryExpr([&] { return normal(random); }).normalized();
        b = b.shifted(9 * direction);
        const auto surface = a.shape().display_mesh(0.05).vertices;
        for (int k = 0; k < 8; ++k) {
            double distance = 1e30;
            for (const auto& x : surface)
                distance = std::min(distance, b.distance(a.to_world(x)));
            b = b.shifted(-(distance - (i % 4 - 1) * 0.1) * direction);
        }
        for (const auto& film : films_of<D>(a, b, options)) {
            ++found;
            ASSERT_NO_FATAL_FAILURE(check_film(film, limits)) << "pose " << i;
        }
    }
    EXPECT_GT(found, count / 4);
}

TEST(CurvedFilm, RandomPoses2D)
{
    std::vector<std::unique_ptr<Shape<2>>> shapes;
    shapes.push_back(make_box<2>({5, 2}));
    shapes.push_back(make_ball<2>(2));
    shapes.push_back(make_capsule<2>(1, 4));
    random_poses<2>(shapes, 300, options_with(0.7), options_with(0.7));
}

TEST(CurvedFilm, RandomPoses3D)
{
    std::vector<std::unique_ptr<Shape<3>>> shapes;
    shapes.push_back(make_box<3>({4, 3, 2}));
    shapes.push_back(make_ball<3>(2));
    shapes.push_back(make_capsule<3>(1, 3));
    shapes.push_back(make_cylinder(1.5, 2.5));
    random_poses<3>(shapes, 64, options_with(0.7), options_with(0.7));
    random_poses<3>(shapes, 64, rings_with(0.7), limits_of(rings_with(0.7)));
}

} // namespace
} // namespace gapflow::test
