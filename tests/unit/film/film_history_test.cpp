// What films remember: it gives back what was stored, carries it along the film, and moves with the master.
#include "film_mesh_checks.hpp"
#include "film_scene.hpp"

#include "gapflow/film/film_history.hpp"

#include <cmath>
#include <limits>
#include <set>

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
    // A linear field everywhere in the film, from any element on; and on beyond its end.
    for (double aside : {3.0, 3.4, 4.9, 5.123, 6.7, 7.0, 7.04})
        for (int start : {-1, 0, history.elements() - 1}) {
            Vec<D> x = at<D>(4.3, plates.height());
            x[0] = aside;
            int hint = start;
            EXPECT_LT((history.at(plates.body(x), hint).velocity() - stretching<D>(x)).norm(), 1e-6)
                << aside << " from " << start;
            ASSERT_TRUE(hint >= 0 && hint < history.elements());
            EXPECT_LT(std::abs(plates.film().mesh.elements[hint].centroid_master[0] - aside), 0.5);
            EXPECT_NEAR(history.speed_about(hint), 1 + 0.2 * aside, 0.12); // at a vertex of an element of half a cell
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

FilmHistory<2>::Sample only(const FilmHistory<2>& history, const Vec<2>& x_body)
{
    int hint = -1;
    std::vector<FilmHistory<2>::Sample> all;
    history.for_each_sample(x_body, hint, [&](const FilmHistory<2>::Sample& sample) { all.push_back(sample); });
    EXPECT_EQ(all.size(), 1u);
    return all.at(0);
}

// A sample is the flux h u, linear in the element with the same mean, and tells whether the point is the film's.
TEST(FilmHistory, SamplesTheFlux)
{
    const Plates<2> plates(3, 7, 12);
    const FilmHistory<2> history = plates.history(stretching<2>);
    for (double aside : {4.1, 5.37, 6.05}) {
        const Vec<2> x(aside, plates.height());
        const auto sample = only(history, plates.body(x));
        EXPECT_TRUE(sample.belongs);
        EXPECT_NEAR(sample.h, 0.2, 1e-9);
        EXPECT_LT((sample.flux - 0.2 * stretching<2>(x)).norm(), 1e-7) << aside;
    }
    for (double beyond : {0.04, 0.06, 2.1})
        EXPECT_EQ(only(history, plates.body({7 + beyond, plates.height()})).belongs, beyond < 0.05);
}

// On a node or an edge a point lies in all elements there, whatever the round-off of its place.
template <int D>
void shares_places_on_facets()
{
    const Plates<D> plates(3, 7, 12);
    const FilmHistory<D> history = plates.history(stretching<D>);
    const FilmMesh<D>& mesh = plates.film().mesh;
    std::vector<int> around(mesh.x.size(), 0);
    for (const FilmElement<D>& e : mesh.elements)
        for (int node : e.nodes)
            ++around[node];
    for (std::size_t i = 0; i < mesh.x.size(); ++i)
        for (double off : {-1e-12, 0.0, 1e-12}) {
            Vec<D> x = mesh.x[i];
            x[0] += off;
            int hint = 0;
            std::set<int> elements;
            double sum = 0;
            history.for_each_sample(plates.body(x), hint, [&](const auto& sample) {
                elements.insert(sample.element);
                sum += sample.share;
                EXPECT_NEAR(sample.share, 1.0 / around[i], 1e-12);
                EXPECT_TRUE(sample.belongs);
            });
            EXPECT_EQ(static_cast<int>(elements.size()), around[i]);
            EXPECT_NEAR(sum, 1, 1e-12);
        }
}

TEST(FilmHistory, PlacesOnFacetsLieInAllElementsThere2D)
{
    shares_places_on_facets<2>();
}

TEST(FilmHistory, PlacesOnFacetsLieInAllElementsThere3D)
{
    shares_places_on_facets<3>();
}

// Fluid that moves as the master does has the master's velocity at every place.
template <int D>
void moves_with_master()
{
    const Plates<D> plates(3, 7, 10);
    Twist<D> twist = Twist<D>::Constant(0.3);
    twist[0] = -1.2;
    const auto rigid = [&](const Vec<D>& x) { return velocity_at<D>(twist, Vec<D>(x - plates.master().centre)); };
    const FilmHistory<D> history = plates.history(rigid, twist);
    const Vec<D> x = at<D>(4.37, plates.height());
    int hint = -1;
    EXPECT_LT((history.master_velocity(plates.body(x)) - rigid(x)).norm(), 1e-12);
    EXPECT_LT((history.at(plates.body(x), hint).velocity() - rigid(x)).norm(), 1e-6);
    EXPECT_LT(history.along(hint).norm(), 1e-10);
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
            (is_turned ? turned : straight)[i] = history.at({i - 0.3, 1.5}, hint).velocity();
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
        const Vec<3> a = history.at(plates.body(x), from_none).velocity(), b = history.at(plates.body(x), from_far).velocity();
        EXPECT_LT((a - stretching<3>(x)).norm(), 1e-6);
        EXPECT_LT((a - b).norm(), 1e-9);
    }
    int hint = -1;
    history.for_each_sample(plates.body({40, 5, plates.height()}), hint, [](const auto& sample) {
        EXPECT_FALSE(sample.belongs); // nowhere near: still an answer
    });
}

// Idle elements have no acceleration to extrapolate.
TEST(FilmHistory, IdleFluidIsNotPushed)
{
    const Plates<2> plates(3, 7, 10);
    const VectorField<2> even = [](const Vec<2>&) { return Vec<2>(1, 0); };
    const auto count = plates.film().mesh.elements.size();
    for (const bool idle : {false, true}) {
        const FilmHistory<2> history = plates.history(even, Twist<2>::Zero(), std::vector<Vec<2>>(count, 0.4 * unit<2>(0)),
                                                      std::vector<char>(count, idle));
        EXPECT_EQ(history.acceleration(0)[0], idle ? 0 : 0.4);
        EXPECT_EQ(history.increment(0).norm(), 0);
    }
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
        history.mouths.push_back({{x, 0},
                                  x == 3 ? Vec<2>(-1, 0) : Vec<2>(1, 0),
                                  x == 3 ? Vec<2>(-0.2, 0) : Vec<2>(0.2, 0),
                                  1.0,
                                  x,
                                  {0, 0},
                                  MouthKind::edge_edge});
    EXPECT_EQ(history.nearest_mouth({6.9, 0}, {1, 0}), &history.mouths[2]);
    EXPECT_EQ(history.nearest_mouth({6.2, 0}, {0.8, 0.6}), &history.mouths[1]);
    EXPECT_EQ(history.nearest_mouth({3.5, 0}, {1, 0}), nullptr); // the near one leads out to the other side
    EXPECT_EQ(history.nearest_mouth({4.9, 0}, {-1, 0}), &history.mouths[0]);
    EXPECT_EQ(history.nearest_mouth({5.1, 0}, {-1, 0}), nullptr); // two cells
    EXPECT_EQ(history.nearest_mouth({7, 0}, {0, 1}), nullptr);
}

} // namespace
} // namespace gapflow::test
