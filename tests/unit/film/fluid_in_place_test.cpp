// The old fluid at the places of new elements: nothing is lost where the film stays, and no energy is gained wherever it goes.
#include "gap_of_plates.hpp"

namespace gapflow::test {
namespace {

// Between two unit normals no more than a right angle apart.
template <int D>
void is_a_rotation()
{
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    const auto some = [&] {
        Vec<D> v;
        for (int axis = 0; axis < D; ++axis)
            v[axis] = normal(random);
        return v;
    };
    int tried = 0;
    while (tried < 100) {
        const Vec<D> from = some().normalized(), to = some().normalized();
        if (from.dot(to) < 0)
            continue;
        ++tried;
        const Vec<D> v = tangential<D>(some(), from), w = turned<D>(v, from, to);
        EXPECT_NEAR(w.norm(), v.norm(), 1e-12);
        EXPECT_NEAR(w.dot(to), 0, 1e-12);
        EXPECT_LT((turned<D>(w, to, from) - v).norm(), 1e-12);
        EXPECT_LE((w - v).norm(), (from - to).norm() * v.norm() + 1e-12); // the least rotation
        if constexpr (D == 3) {
            const Vec<3> axis = from.cross(to);
            EXPECT_LT((turned<3>(axis, from, to) - axis).norm(), 1e-12);
        }
    }
}

TEST(FluidInPlace, TurnedIsTheLeastRotation2D)
{
    is_a_rotation<2>();
}

TEST(FluidInPlace, TurnedIsTheLeastRotation3D)
{
    is_a_rotation<3>();
}

template <int D>
double volumes(const std::vector<FluidInPlace<D>>& fluid)
{
    double sum = 0;
    for (const FluidInPlace<D>& place : fluid)
        sum += place.volume;
    return sum;
}

double old_volume(const FilmHistory<3>& old)
{
    double sum = 0;
    for (int e = 0; e < old.elements(); ++e)
        sum += old.volume(e);
    return sum;
}

// The same film: the same fluid, element by element.
template <int D>
void same_film()
{
    std::mt19937 random(1);
    for (double tilt : {0.0, 0.03}) {
        PlateSetup<D> setup;
        setup.tilt = tilt;
        const GapOfPlates<D> gap(setup);
        const std::vector<Vec<D>> u = gap.random_velocities(random);
        const std::vector<FluidInPlace<D>> fluid = gap.put_in_place(gap.history(u));
        ASSERT_EQ(fluid.size(), u.size());
        for (std::size_t i = 0; i < u.size(); ++i) {
            EXPECT_NEAR(fluid[i].volume, gap.elements()[i].volume, 1e-12 * gap.elements()[i].volume);
            EXPECT_EQ(fluid[i].covered, 0);
            EXPECT_LT((fluid[i].reference - u[i]).norm(), 1e-9 * u[i].norm()) << i;
            EXPECT_LT((fluid[i].velocity - u[i]).norm(), 1e-9 * u[i].norm()) << i;
            EXPECT_LT((fluid[i].world - fluid[i].velocity).norm(), 1e-9 * u[i].norm()) << i;
        }
    }
}

TEST(FluidInPlace, SameFilmHasTheSameFluid2D)
{
    same_film<2>();
}

TEST(FluidInPlace, SameFilmHasTheSameFluid3D)
{
    same_film<3>();
}

// A film that gets thicker or thinner: the fluid keeps its volume and speed, the reference its energy.
template <int D>
void new_thickness()
{
    std::mt19937 random(2);
    const GapOfPlates<D> old({});
    const std::vector<Vec<D>> u = old.random_velocities(random);
    for (double factor : {0.5, 1.3}) {
        PlateSetup<D> setup;
        setup.thickness *= factor;
        const GapOfPlates<D> gap(setup);
        ASSERT_EQ(gap.elements().size(), u.size());
        const std::vector<FluidInPlace<D>> fluid = gap.put_in_place(old.history(u));
        for (std::size_t i = 0; i < u.size(); ++i) {
            EXPECT_NEAR(fluid[i].volume, old.elements()[i].volume, 1e-9);
            EXPECT_LT((fluid[i].velocity - u[i]).norm(), 1e-9 * u[i].norm());
            EXPECT_LT((fluid[i].reference - u[i] / std::sqrt(factor)).norm(), 1e-9 * u[i].norm());
        }
    }
}

TEST(FluidInPlace, NewThicknessKeepsVolumeAndEnergy2D)
{
    new_thickness<2>();
}

TEST(FluidInPlace, NewThicknessKeepsVolumeAndEnergy3D)
{
    new_thickness<3>();
}

// Another thickness, tilt, extent and mesh: the reference has no more energy than the old fluid, and no more fluid is there.
template <int D>
void no_energy()
{
    std::mt19937 random(3);
    PlateSetup<D> setup;
    setup.upper = 3;
    const GapOfPlates<D> old(setup);
    for (double aside : {0.0, 0.13, -0.6})
        for (double tilt : {0.0, 0.05})
            for (double largest : {0.5, 0.2}) {
                const std::vector<Vec<D>> u = old.random_velocities(random);
                PlateSetup<D> next = setup;
                next.thickness = 0.25;
                next.aside = aside;
                next.tilt = tilt;
                next.largest = largest;
                const GapOfPlates<D> gap(next);
                const std::vector<FluidInPlace<D>> fluid = gap.put_in_place(old.history(u));
                std::vector<Vec<D>> reference;
                for (const FluidInPlace<D>& place : fluid)
                    reference.push_back(place.reference);
                EXPECT_LE(gap.energy(reference), (1 + 1e-9) * old.energy(u));
                EXPECT_GT(gap.energy(reference), 0.1 * old.energy(u));
                EXPECT_LE(volumes(fluid), (1 + 1e-9) * volume(old.film().mesh));
            }
}

TEST(FluidInPlace, ReferenceHasNoMoreEnergyThanTheOldFluid2D)
{
    no_energy<2>();
}

TEST(FluidInPlace, ReferenceHasNoMoreEnergyThanTheOldFluid3D)
{
    no_energy<3>();
}

// In a wedge the flux h u is the same everywhere: it stays so on a mesh of other elements, where the fluid has its mean speed q / h.
template <int D>
void uniform_flux()
{
    PlateSetup<D> setup;
    setup.tilt = 0.03;
    const GapOfPlates<D> old(setup);
    const Vec<D> q = 0.3 * tangential<D>(unit<D>(0), old.elements()[0].normal);
    const auto with_flux = [&](const FilmElement<D>& e) { return Vec<D>(e.measure / e.volume * q); };
    const FilmHistory<D> history = old.history(old.at_elements(with_flux));
    for (double largest : {0.5, 0.3, 0.1})
        for (double upper : {6.0, 2.77}) {
            setup.largest = largest;
            setup.upper = upper;
            const GapOfPlates<D> gap(setup);
            const std::vector<FluidInPlace<D>> fluid = gap.put_in_place(history);
            for (std::size_t i = 0; i < fluid.size(); ++i) {
                const FilmElement<D>& e = gap.elements()[i];
                EXPECT_EQ(fluid[i].covered, 0);
                const double share = fluid[i].volume / e.volume;
                // An old element that the new film covers in part gives its mean thickness there.
                EXPECT_NEAR(share, 1, upper < 4 ? 0.02 : 1e-9) << i;
                EXPECT_LT((fluid[i].velocity - with_flux(e)).norm(), 1e-9 * with_flux(e).norm()) << i;
            }
        }
}

TEST(FluidInPlace, UniformFluxStaysUniformOnOtherMeshes2D)
{
    uniform_flux<2>();
}

TEST(FluidInPlace, UniformFluxStaysUniformOnOtherMeshes3D)
{
    uniform_flux<3>();
}

// The upper plate moves along the film: the film has fluid where it had some, and is covered where it had none.
TEST(FluidInPlace, NewEndsAreCovered)
{
    PlateSetup<2> setup;
    setup.upper = 2;
    const GapOfPlates<2> old(setup);
    setup.aside = 0.75;
    const GapOfPlates<2> gap(setup);
    const std::vector<FluidInPlace<2>> fluid =
        gap.put_in_place(old.history(old.at_elements([](const FilmElement<2>&) { return Vec<2>(2, 0); })));
    double covered = 0;
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        const FilmElement<2>& e = gap.elements()[i];
        covered += fluid[i].covered;
        const double x = gap.master().to_body(e.centroid_master)[0];
        if (x > 1 + 0.05 + e.measure) {
            EXPECT_NEAR(fluid[i].covered, e.volume, 1e-12);
            EXPECT_EQ(fluid[i].volume, 0);
            EXPECT_EQ(fluid[i].velocity.norm(), 0);
        } else if (x < 1 - e.measure) {
            EXPECT_NEAR(fluid[i].volume, e.volume, 1e-6 * e.volume);
            EXPECT_LT((fluid[i].velocity - Vec<2>(2, 0)).norm(), 1e-6);
        }
    }
    EXPECT_NEAR(covered, 0.75 * 0.2, 0.06 * 0.2); // a twentieth of a cell beside the film counts as in it
    EXPECT_NEAR(volumes(fluid), 1.25 * 0.2, 0.06 * 0.2);
}

// A plate that nearly touches with its edge, and moves on along that side by less than a twentieth of a cell: what lies beyond the edge was not in the film,
// which is far thinner there. (Random scene 93 of the contact cases: a corner touches a round end, and the film changes to the corner's other side. With the
// fluid of the old one's tip there, 1e4 times as fast as any other, the scene gained 236 times its energy.)
TEST(FluidInPlace, BeyondAPointOfContactIsNotOfTheFilm)
{
    PlateSetup<2> setup;
    setup.upper = 2;
    setup.tilt = 0.05;
    setup.thickness = std::sin(setup.tilt) + 1e-6;
    const GapOfPlates<2> old(setup);
    setup.aside = -0.03;
    const GapOfPlates<2> gap(setup);
    const std::vector<FluidInPlace<2>> fluid =
        gap.put_in_place(old.history(old.at_elements([](const FilmElement<2>&) { return Vec<2>(1, 0); })));
    double thinnest = 1;
    int beyond = 0;
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        const FilmElement<2>& e = gap.elements()[i];
        thinnest = std::min(thinnest, e.volume / e.measure);
        if (gap.master().to_body(e.centroid_master)[0] + 0.5 * e.measure > -std::cos(setup.tilt) - 1e-5)
            continue;
        ++beyond;
        EXPECT_NEAR(fluid[i].covered, e.volume, 1e-12 * e.volume) << i;
        EXPECT_EQ(fluid[i].volume, 0) << i;
    }
    EXPECT_GE(beyond, 3);
    EXPECT_LT(thinnest, 1e-4);
}

// Balls of radius 2 and 3 that approach: the film grows at its round end, and its mesh changes. All of its fluid stays in it.
TEST(FluidInPlace, FluidBetweenBallsStaysWhereTheFilmGrows)
{
    const auto small = make_ball<3>(2), large = make_ball<3>(3);
    const auto solids_at = [&](double gap) {
        Pose<3> below, above;
        above.position = (5 + gap) * unit<3>(2);
        return std::vector<Solid<3>>{{"small", {*small, below}, below.position}, {"large", {*large, above}, above.position}};
    };
    const auto moving = [](const FilmMesh<3>& mesh) {
        std::vector<Vec<3>> u;
        for (const FilmElement<3>& e : mesh.elements)
            u.push_back(tangential<3>(Vec<3>(0.3 + 0.2 * e.centroid_master[0], 0.2 * e.centroid_master[1], 0), e.normal));
        return u;
    };
    for (double threshold : {0.25, 0.5})
        for (int steps : {1, 4, 20}) {
            double lost = 0;
            std::vector<Solid<3>> solids = solids_at(0.1);
            FilmMesh<3> mesh = films_of<3>(solids[0].shape, solids[1].shape, options_with(threshold)).at(0);
            const double all = volume(mesh);
            for (int step = 1; step <= steps; ++step) {
                const Film<3> film{{0, 1, {}}, mesh, threshold};
                const std::vector<Vec<3>> u = moving(mesh);
                const FilmHistory<3> old(solids[0], Twist<3>::Zero(), {&film}, u, {}, {}, {}, 1.0);
                double before = 0, after = 0; // energies
                for (std::size_t i = 0; i < u.size(); ++i)
                    before += 0.5 * mesh.elements[i].volume * u[i].squaredNorm();
                lost += volume(mesh);
                solids = solids_at(0.1 - 0.05 * step / steps);
                mesh = films_of<3>(solids[0].shape, solids[1].shape, options_with(threshold)).at(0);
                FilmNetwork<3> network;
                network.films.push_back({{0, 1, {}}, mesh, threshold});
                number_films(network.films);
                network.elements = static_cast<int>(mesh.elements.size());
                const std::vector<FluidInPlace<3>> fluid = put_in_place<3>(network, solids, {&old});
                lost -= volumes(fluid);
                for (std::size_t i = 0; i < fluid.size(); ++i)
                    after += 0.5 * mesh.elements[i].volume * fluid[i].reference.squaredNorm();
                EXPECT_LE(volumes(fluid), (1 + 1e-9) * old_volume(old));
                EXPECT_LE(after, (1 + 1e-9) * before);
                EXPECT_GE(after, 0.985 * before);
            }
            EXPECT_LE(lost, 0.02 * all) << threshold << ", " << steps;
        }
}

// The surface of a ball of four cells lies 0.05 cells and more over elements of a cell: on a mesh that has not changed the fluid stays as it is, and
// on one that turns about the point of contact none is new.
TEST(FluidInPlace, RoundSurfacesOverLargeElementsAreOfTheFilm)
{
    const auto ball = make_ball<3>(4);
    const auto floor = make_half_space<3>(unit<3>(2));
    const FilmMeshOptions sizes = [] {
        FilmMeshOptions options = coupling_sizes<3>(false);
        options.threshold = 1.95;
        return options;
    }();
    for (double rings : {0.0, sizes.rings})
        for (double angle : {0.0, 0.1}) {
            FilmMeshOptions options = sizes;
            options.rings = rings;
            const auto at = [&](double turn) {
                Pose<3> pose;
                pose.position = 4.005 * unit<3>(2);
                pose.rotation = Rotation<3>(Eigen::AngleAxisd(turn, unit<3>(2)));
                return std::vector<Solid<3>>{{"ball", {*ball, pose}, pose.position}, {"floor", {*floor, {}}, Vec<3>::Zero()}};
            };
            const std::vector<Solid<3>> before = at(0), after = at(angle);
            const Film<3> film{{0, 1, {}}, films_of<3>(before[0].shape, before[1].shape, options).at(0), options.threshold};
            std::mt19937 random(5);
            std::uniform_real_distribution<double> uniform(-1, 1);
            std::vector<Vec<3>> u;
            for (const FilmElement<3>& e : film.mesh.elements)
                u.push_back(tangential<3>(Vec<3>::NullaryExpr([&] { return uniform(random); }), e.normal));
            const FilmHistory<3> old(before[0], Twist<3>::Zero(), {&film}, u, {}, {}, {}, 1.0);
            FilmNetwork<3> network;
            network.films.push_back(
                {{0, 1, {}}, films_of<3>(after[0].shape, after[1].shape, options).at(0), options.threshold});
            number_films(network.films);
            network.elements = static_cast<int>(network.films[0].mesh.elements.size());
            const std::vector<FluidInPlace<3>> fluid = put_in_place<3>(network, after, {&old});
            for (std::size_t i = 0; i < fluid.size(); ++i) {
                EXPECT_EQ(fluid[i].covered, 0) << i;
                if (angle == 0) {
                    EXPECT_LT((fluid[i].reference - u[i]).norm(), 1e-4) << i;
                }
            }
        }
}

// Between a ball that spins and a floor, on a mesh that stays: the fluid keeps its velocity. (The elements' planes lie inside of the ball: with the master's
// velocity taken off there and added again on its surface, films gained up to one per cent of their energy a step, however short it was.)
TEST(FluidInPlace, FluidNextToASpinningBallKeepsItsVelocity)
{
    const auto ball = make_ball<3>(2);
    const auto floor = make_half_space<3>(unit<3>(2));
    Pose<3> pose;
    pose.position = 2.1 * unit<3>(2);
    const std::vector<Solid<3>> solids{{"ball", {*ball, pose}, pose.position}, {"floor", {*floor, {}}, Vec<3>::Zero()}};
    FilmNetwork<3> network;
    network.films.push_back({{0, 1, {}}, films_of<3>(solids[0].shape, solids[1].shape, options_with(0.9)).at(0), 0.9});
    number_films(network.films);
    const std::vector<FilmElement<3>>& elements = network.films[0].mesh.elements;
    network.elements = static_cast<int>(elements.size());
    std::vector<Vec<3>> w;
    for (const FilmElement<3>& e : elements)
        w.push_back(tangential<3>(Vec<3>(0.3, 0.1, 0), e.normal));
    Twist<3> twist = Twist<3>::Zero();
    twist.tail<3>() = Vec<3>(0, 10, 0);
    const FilmHistory<3> old(solids[0], twist, {&network.films[0]}, w, {}, {}, {}, 1.0);
    const std::vector<FluidInPlace<3>> fluid = put_in_place<3>(network, solids, {&old});
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        const Vec<3> now = fluid[i].reference + tangential<3>(fluid[i].master, elements[i].normal);
        EXPECT_LT((now - w[i]).norm(), 1e-3) << i;
    }
}

TEST(FluidInPlace, NothingWithoutHistory)
{
    const GapOfPlates<2> gap({});
    for (const FluidInPlace<2>& place : put_in_place<2>(gap.network, gap.solids, {nullptr})) {
        EXPECT_EQ(place.volume, 0);
        EXPECT_EQ(place.covered, 0);
        EXPECT_EQ(place.reference.norm(), 0);
    }
}

// Accelerations of the last step come with the fluid, turned with the master.
TEST(FluidInPlace, AccelerationsTurnWithTheMaster)
{
    PlateSetup<3> setup;
    setup.pose.rotation = Rotation<3>(Eigen::AngleAxisd(0.4, Vec<3>(1, 2, 2) / 3));
    const GapOfPlates<3> old(setup);
    const std::vector<Vec<3>> rest(old.elements().size(), Vec<3>::Zero());
    const Vec<3> push(0.3, -0.2, 0), increment(0.1, 0.5, 0); // master's axes
    const Mat<3> R = old.master().rotation();
    const FilmHistory<3> history(old.solids[0], Twist<3>::Zero(), {&old.film()}, rest,
                                 std::vector<Vec<3>>(rest.size(), R * push), std::vector<Vec<3>>(rest.size(), R * increment),
                                 {}, 1.0);
    setup.pose.rotation = Rotation<3>(Eigen::AngleAxisd(1.1, Vec<3>(2, -1, 2) / 3));
    setup.largest = 0.3;
    for (const FluidInPlace<3>& place : GapOfPlates<3>(setup).put_in_place(history)) {
        EXPECT_LT((place.acceleration - push).norm(), 1e-9);
        EXPECT_LT((place.increment - increment).norm(), 1e-9);
    }
}

// Everything turns: in the master's axes velocities stay as they are, and what the walls do not see is centrifugal and Coriolis.
TEST(FluidInPlace, TurningMasterAddsCentrifugalAndCoriolis3D)
{
    PlateSetup<3> setup;
    setup.pose.position = Vec<3>(1, 2, 3);
    setup.pose.rotation = Rotation<3>(Eigen::AngleAxisd(0.7, Vec<3>(2, 2, 1) / 3));
    const GapOfPlates<3> old(setup);
    const Mat<3> R = old.master().rotation();
    const Vec<3> spin(0.3, -0.4, 1.2), u(0.5, 0.8, 0); // master's axes
    Twist<3> twist;
    twist << Vec<3>(3, -2, 1), R * spin;
    const FilmHistory<3> history = old.history(old.at_elements([&](const FilmElement<3>& e) {
        return Vec<3>(velocity_at<3>(twist, Vec<3>(e.centroid_master - old.solids[0].centre)) + R * u);
    }),
                                               twist);
    setup.pose.rotation = Rotation<3>(Eigen::AngleAxisd(0.2, R * spin.normalized())) * setup.pose.rotation;
    setup.pose.position += Vec<3>(0.3, -0.2, 0.1);
    const GapOfPlates<3> gap(setup);
    const std::vector<FluidInPlace<3>> fluid = gap.put_in_place(history);
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        const Vec<3> x = gap.master().to_body(gap.elements()[i].centroid_master) - history.centre();
        const double along = spin.dot(x);
        Vec<3> expected = spin.squaredNorm() * x - along * spin;    // away from the axis
        expected += 2 * Vec<3>(u[1] * spin[2], -u[0] * spin[2], 0); // to the right of u where the spin is to the left
        expected[2] = 0;
        EXPECT_LT((fluid[i].velocity - u).norm(), 1e-9);
        EXPECT_LT((fluid[i].reference - u).norm(), 1e-9);
        EXPECT_LT((fluid[i].inertial - expected).norm(), 1e-9 * expected.norm()) << i;
        EXPECT_LT((fluid[i].world - velocity_at<3>(twist, Vec<3>(R * x)) - R * u).norm(), 1e-9);
    }
}

TEST(FluidInPlace, TurningMasterAddsCentrifugal2D)
{
    const GapOfPlates<2> gap({});
    const Twist<2> twist(1, -2, 1.5);
    const FilmHistory<2> history = gap.history(gap.at_elements([&](const FilmElement<2>& e) {
        return Vec<2>(velocity_at<2>(twist, Vec<2>(e.centroid_master - gap.solids[0].centre)) + Vec<2>(0.4, 0));
    }),
                                               twist);
    const std::vector<FluidInPlace<2>> fluid = gap.put_in_place(history);
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        const double x = gap.elements()[i].centroid_master[0] - gap.solids[0].centre[0];
        EXPECT_LT((fluid[i].inertial - Vec<2>(1.5 * 1.5 * x, 0)).norm(), 1e-9);
    }
}

} // namespace
} // namespace gapflow::test
