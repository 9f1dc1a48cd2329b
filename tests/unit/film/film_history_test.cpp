// What films remember: it gives back what was stored, carries it along the film, and moves with the master.
#include "film_mesh_checks.hpp"
#include "film_scene.hpp"

#include "gapflow/film/film_history.hpp"

#include <cmath>
#include <limits>

namespace gapflow::test {
namespace {

template <int D>
using VectorField = std::function<Vec<D>(const Vec<D>&)>;

/// The film of two plates, and the history of velocities in it.
template <int D>
struct Plates {
    Plates(double low, double high, int cells) : scene(plates<D>(low, high, cells)), films(scene->films()) {}
    const Film<D>& film() const { return films.front(); }
    const Solid<D>& master() const { return scene->solids()[film().pair.master]; }
    Vec<D> body(const Vec<D>& x) const { return master().shape.to_body(x); }
    std::vector<Vec<D>> at_elements(const VectorField<D>& field) const
    {
        std::vector<Vec<D>> values;
        for (const FilmElement<D>& e : film().mesh.elements)
            values.push_back(field(e.centroid_master));
        return values;
    }
    FilmHistory<D> history(const VectorField<D>& velocity, const Twist<D>& twist = Twist<D>::Zero(),
                           const std::vector<Vec<D>>& push = {}, const std::vector<char>& idle = {}) const
    {
        return {master(), twist, {&film()}, at_elements(velocity), push, {}, idle, scene->grid().dx()};
    }
    /// On the master's face: its height.
    double height() const { return film().mesh.x[0][D - 1]; }

    std::unique_ptr<FilmScene<D>> scene;
    std::vector<Film<D>> films;
};

// Along the first axis, 1 + 0.2 x.
template <int D>
Vec<D> stretching(const Vec<D>& x)
{
    return (1 + 0.2 * x[0]) * unit<D>(0);
}

template <int D>
void gives_back()
{
    const Plates<D> plates(3, 7, 10);
    ASSERT_EQ(plates.films.size(), 1u);
    const FilmHistory<D> history = plates.history(stretching<D>);
    EXPECT_EQ(history.elements(), static_cast<int>(plates.film().mesh.elements.size()));
    const double area = std::pow(4, D - 1);
    EXPECT_NEAR(history.area(), area, 1e-10);
    EXPECT_NEAR(history.volume(), 0.2 * area, 1e-10);
    double motion = 0;
    for (const FilmElement<D>& e : plates.film().mesh.elements)
        motion += e.volume * stretching<D>(e.centroid_master).squaredNorm();
    EXPECT_NEAR(history.motion(), motion, 1e-10);
    EXPECT_FALSE(history.second_order());
    // A linear field everywhere in the film, from any element on; and on beyond its end.
    for (double aside : {3.0, 3.4, 4.9, 5.123, 6.7, 7.0, 7.04})
        for (int start : {-1, 0, history.elements() - 1}) {
            Vec<D> x = at<D>(4.3, plates.height());
            x[0] = aside;
            int hint = start;
            const auto found = history.at(plates.body(x), hint);
            EXPECT_LT((found.velocity - stretching<D>(x)).norm(), 1e-6) << aside << " from " << start;
            EXPECT_LT((found.normal - plates.film().mesh.elements[hint].normal).norm(), 1e-12);
            EXPECT_TRUE(found.near);
            EXPECT_FALSE(found.beyond);
            ASSERT_TRUE(hint >= 0 && hint < history.elements());
            EXPECT_LT(std::abs(plates.film().mesh.elements[hint].centroid_master[0] - aside), 0.5);
            EXPECT_NEAR(found.fastest, 1 + 0.2 * aside, 0.12); // at a vertex of an element of half a cell
            EXPECT_EQ(found.fastest, history.speed_about(hint));
        }
}

TEST(FilmHistory, GivesBackWhatWasStored2D)
{
    gives_back<2>();
}

TEST(FilmHistory, GivesBackWhatWasStored3D)
{
    gives_back<3>();
}

// Beyond the film's end by a twentieth of a cell a point is beyond; by two cells no past at all.
TEST(FilmHistory, TellsHowFarTheFilmIs)
{
    const Plates<2> plates(3, 7, 12);
    const FilmHistory<2> history = plates.history(stretching<2>);
    for (double beyond : {0.04, 0.06, 1.9, 2.1}) {
        int hint = -1;
        const auto found = history.at(plates.body({7 + beyond, plates.height()}), hint);
        EXPECT_EQ(found.beyond, beyond > 0.05) << beyond;
        EXPECT_EQ(found.near, beyond < 2) << beyond;
    }
}

// Carried along a steady flow of the speed 1 + 0.2 x for dt, what arrives had this speed times exp(-0.2 dt); the same speed everywhere stays.
template <int D>
void transports()
{
    const Plates<D> plates(3, 9, 12);
    const FilmHistory<D> history = plates.history(stretching<D>),
                         even = plates.history([](const Vec<D>&) { return Vec<D>(0.7 * unit<D>(0)); });
    double last = 0;
    for (double dt : {0.4, 0.2, 0.1}) {
        Vec<D> x = at<D>(6.03, plates.height());
        x[0] = 7.41;
        int hint = -1;
        const Vec<D> found = history.transport(plates.body(x), dt, hint).velocity;
        const double error = std::abs(found[0] - (1 + 0.2 * x[0]) * std::exp(-0.2 * dt));
        EXPECT_LT(error, 0.5 * std::pow(0.2 * dt, 3)); // the midpoint rule's: a sixth of it, times the speed
        if (last > 0) {
            EXPECT_NEAR(last / error, 8, 0.3);
        }
        last = error;
        EXPECT_LT(Vec<D>(found - found[0] * unit<D>(0)).norm(), 1e-7);
        EXPECT_LT((even.transport(plates.body(x), dt, hint).velocity - 0.7 * unit<D>(0)).norm(), 1e-7);
    }
}

TEST(FilmHistory, CarriesAlongTheFilm2D)
{
    transports<2>();
}

TEST(FilmHistory, CarriesAlongTheFilm3D)
{
    transports<3>();
}

// Fluid that moves as the master does stays where it is, seen from it: every place has the master's velocity there, after any time.
template <int D>
void moves_with_master()
{
    const Plates<D> plates(3, 7, 10);
    Twist<D> twist = Twist<D>::Constant(0.3);
    twist[0] = -1.2;
    const auto rigid = [&](const Vec<D>& x) { return velocity_at<D>(twist, Vec<D>(x - plates.master().centre)); };
    const FilmHistory<D> history = plates.history(rigid, twist);
    EXPECT_NEAR(history.motion(), 0, 1e-20);
    for (double dt : {0.0, 0.3, 5.0}) {
        const Vec<D> x = at<D>(4.37, plates.height());
        int hint = -1;
        EXPECT_LT((history.master_velocity(plates.body(x)) - rigid(x)).norm(), 1e-12);
        EXPECT_LT((history.transport(plates.body(x), dt, hint).velocity - rigid(x)).norm(), 1e-6);
    }
}

TEST(FilmHistory, RigidMotionStaysWithTheMaster2D)
{
    moves_with_master<2>();
}

TEST(FilmHistory, RigidMotionStaysWithTheMaster3D)
{
    moves_with_master<3>();
}

// Everything turned: places in the master's frame are the same, velocities are turned.
TEST(FilmHistory, TurnsWithTheScene)
{
    const auto box = make_box<2>({5, 3});
    const double turn = 0.7;
    Vec<2> straight[2], turned[2];
    for (const bool is_turned : {false, true}) {
        const Rotation<2> rotation(is_turned ? turn : 0.0);
        const Vec<2> centre = is_turned ? Vec<2>(3, -8) : Vec<2>(0, 0);
        const Solid<2> master{"master", place<2>(box, centre, rotation), centre};
        Film<2> film{
            {0, 1, {0, 0}},
            films_of<2>(master.shape, place<2>(box, centre + rotation * Vec<2>(0, 3.1), rotation), options_with(0.5)).front(),
            0.5};
        std::vector<Vec<2>> w;
        for (const FilmElement<2>& e : film.mesh.elements)
            w.push_back(rotation * Vec<2>(1 + 0.1 * master.shape.to_body(e.centroid_master)[0], 0));
        const FilmHistory<2> history(master, Twist<2>::Zero(), {&film}, w, {}, {}, {}, 1.0);
        for (int i = 0; i < 2; ++i) {
            int hint = -1;
            (is_turned ? turned : straight)[i] = history.transport({i - 0.3, 1.5}, 0.2 * i, hint).velocity;
        }
    }
    for (int i = 0; i < 2; ++i)
        EXPECT_LT((Rotation<2>(turn) * straight[i] - turned[i]).norm(), 1e-9);
}

// A film of more elements than are searched one by one: the same from a hint and from none, and that is the nearest.
TEST(FilmHistory, FindsElementsOfLargeFilms)
{
    const Plates<3> plates(3, 13, 16);
    const FilmHistory<3> history = plates.history(stretching<3>);
    ASSERT_GT(history.elements(), 256);
    for (int i = 0; i < 40; ++i) {
        const Vec<3> x(3 + 0.25 * i, 3.7 + 0.21 * i, plates.height());
        int from_none = -1, from_far = 0;
        const Vec<3> a = history.at(plates.body(x), from_none).velocity, b = history.at(plates.body(x), from_far).velocity;
        EXPECT_LT((a - stretching<3>(x)).norm(), 1e-6);
        EXPECT_LT((a - b).norm(), 1e-9);
    }
    int hint = -1;
    EXPECT_FALSE(history.at(plates.body({40, 5, plates.height()}), hint).near); // nowhere near: still an answer
}

// Half of the step's push, no more than half of the speed around; at the end of the step what differs between foot and arrival.
TEST(FilmHistory, PushedByThePressure)
{
    const Plates<2> plates(3, 7, 10);
    const VectorField<2> even = [](const Vec<2>&) { return Vec<2>(1, 0); };
    const auto element_count = plates.film().mesh.elements.size();
    const Vec<2> x = plates.body({5.03, plates.height()});
    for (const double push : {0.4, 40.0}) {
        const FilmHistory<2> history =
            plates.history(even, Twist<2>::Zero(), std::vector<Vec<2>>(element_count, push * unit<2>(0)));
        EXPECT_TRUE(history.second_order());
        int hint = -1;
        const Vec<2> half = history.half_way(x, 0.5, hint);
        EXPECT_NEAR(half[0], push == 0.4 ? 1.1 : 1.5, 1e-6);
        EXPECT_NEAR(history.transport(x, 0.5, hint).velocity[0], 1, 1e-6); // the same push everywhere
    }
    // An idle film pushes nothing and has no bound.
    const FilmHistory<2> idle = plates.history(even, Twist<2>::Zero(), std::vector<Vec<2>>(element_count, unit<2>(0)),
                                               std::vector<char>(element_count, 1));
    int hint = -1;
    EXPECT_NEAR(idle.half_way(x, 0.5, hint)[0], 1, 1e-6);
    EXPECT_EQ(idle.at(x, hint).fastest, std::numeric_limits<double>::infinity());
}

TEST(FilmHistory, FieldsAtVertices)
{
    const Plates<2> plates(3, 7, 10);
    const FilmHistory<2> history = plates.history(stretching<2>);
    std::vector<double> field;
    for (const Vec<2>& x : plates.film().mesh.x)
        field.push_back(3 - 0.5 * x[0]);
    int hint = -1;
    for (double aside : {3.0, 4.44, 6.9, 7.0})
        EXPECT_NEAR(history.at_vertices(field, plates.body({aside, plates.height()}), hint), 3 - 0.5 * aside, 1e-9);
    EXPECT_EQ(history.at_vertices(field, plates.body({7.1, plates.height()}), hint), 0); // no film was there
}

// A mouth goes on as the nearest of those that lead out the same way.
TEST(FilmHistory, MouthsGoOn)
{
    const Plates<2> plates(3, 7, 10);
    FilmHistory<2> history = plates.history(stretching<2>);
    for (double x : {3.0, 6.0, 7.0})
        history.mouths.push_back({{x, 0}, x == 3 ? Vec<2>(-1, 0) : Vec<2>(1, 0), 0.2, 1.0, x, {0, 0}, MouthKind::edge_edge});
    EXPECT_EQ(history.nearest_mouth({6.9, 0}, {1, 0}), &history.mouths[2]);
    EXPECT_EQ(history.nearest_mouth({6.2, 0}, {0.8, 0.6}), &history.mouths[1]);
    EXPECT_EQ(history.nearest_mouth({3.5, 0}, {1, 0}), nullptr); // the near one leads out to the other side
    EXPECT_EQ(history.nearest_mouth({4.9, 0}, {-1, 0}), &history.mouths[0]);
    EXPECT_EQ(history.nearest_mouth({5.1, 0}, {-1, 0}), nullptr); // two cells
    EXPECT_EQ(history.nearest_mouth({7, 0}, {0, 1}), nullptr);
}

} // namespace
} // namespace gapflow::test
