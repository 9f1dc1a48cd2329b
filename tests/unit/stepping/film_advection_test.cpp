// Advection of the film's velocity on a curved film of varying thickness: a swirl in the narrow annulus between two circles, the
// inner one off centre. The film fills the gap; everything is at rest but its fluid.
#include "coupled_scene.hpp"

#include "gapflow/film/film_transport.hpp"
#include "gapflow/solver/solver.hpp"
#include "gapflow/stepping/setup.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace gapflow {
namespace {

constexpr double inner_radius = 0.98, mean_gap = 0.02, eccentricity = 0.01;

// Thickness h, from 0.01 to 0.03, at an angle about the inner circle's centre: the distance to the outer circle along its normal.
double thickness(double angle)
{
    const double outer = inner_radius + mean_gap;
    const Vec<2> x(eccentricity + inner_radius * std::cos(angle), inner_radius * std::sin(angle));
    return outer - x.norm();
}

struct Annulus : CoupledScene {
    explicit Annulus(int cells) : CoupledScene(make_scene(cells)), centre(coupling.solids[0].centre) {}
    static Scene make_scene(int cells)
    {
        Scene scene;
        scene.dimension = 2;
        scene.size = {2.24, 2.24, 0};
        scene.cells = {cells, cells, 1};
        scene.gap.threshold = 4.0;
        BodyScene inner, outer;
        inner.name = "inner";
        outer.name = "outer";
        inner.shape = outer.shape = BodyScene::ShapeKind::ball;
        inner.motion = outer.motion = BodyScene::Motion::fixed;
        inner.radius = inner_radius;
        inner.position = {1.13 + eccentricity, 1.11, 0};
        outer.radius = inner_radius + mean_gap;
        outer.position = {1.13, 1.11, 0};
        outer.inside_out = true;
        scene.bodies = {inner, outer};
        return scene;
    }
    double angle(const FilmElement<2>& e) const
    {
        const Vec<2> x = e.centroid_master - centre;
        return std::atan2(x[1], x[0]);
    }
    // Along the film, counterclockwise.
    Vec<2> along(const FilmElement<2>& e) const { return {-e.normal[1], e.normal[0]}; }
    std::vector<Vec<2>> film_velocity(const std::function<double(double)>& speed) const
    {
        std::vector<Vec<2>> u;
        for (const FilmElement<2>& e : film().mesh.elements)
            u.push_back(speed(angle(e)) * along(e));
        return u;
    }
    // One step of advection alone.
    FilmFlow<2> advected(const std::vector<Vec<2>>& u, double dt, const std::vector<Vec<2>>& acceleration = {},
                         const std::vector<Vec<2>>& increment = {}) const
    {
        const FilmHistories<2> histories =
            remember_films<2>(coupling.network, coupling.solids, rest, u, {}, grid.dx(), {}, acceleration, increment);
        return advect_films<2>(
            coupling.network, coupling.solids, histories,
            [](const std::vector<Vec<2>>& x) { return std::vector<Vec<2>>(x.size(), Vec<2>(Vec<2>::Zero())); },
            [](int, int) { return MouthLaw{}; }, {}, dt);
    }

    // The same by the finite volumes of second order, whatever energy they take or give.
    std::vector<Vec<2>> carried(const std::vector<Vec<2>>& u, double dt) const
    {
        const FilmHistories<2> histories = remember_films<2>(coupling.network, coupling.solids, rest, u, {}, grid.dx());
        const FilmHistory<2>& history = *histories.begin()->second;
        const PlacedShape<2>& master = coupling.solids[film().pair.master].shape;
        const std::vector<FluidInPlace<2>> start = put_in_place<2>(coupling.network, coupling.solids, {&history});
        std::vector<Vec<2>> flow;
        for (std::size_t i = 0; i < u.size(); ++i)
            flow.push_back(film().mesh.elements[i].volume * start[i].velocity);
        std::vector<Vec<2>> result = FilmTransport<2>(coupling.network, 0, master, start, flow, {}, dt).high().velocity;
        for (Vec<2>& v : result)
            v = master.rotation() * v;
        return result;
    }

    Vec<2> centre;
};

// Slope of log(error) over log(dx) between the first and the last; recorded for the table of the validation.
double order(const std::vector<double>& errors)
{
    std::string text;
    for (double e : errors) {
        char number[32];
        std::snprintf(number, sizeof number, "%s%.2e", text.empty() ? "" : ", ", e);
        text += number;
    }
    const double slope = std::log2(errors.front() / errors.back()) / static_cast<double>(errors.size() - 1);
    testing::Test::RecordProperty("series", text);
    testing::Test::RecordProperty("order", std::to_string(slope));
    return slope;
}

// Without pressure the speed is carried along the film: u_t + u u_s = 0, u(s, t) = u_0(s - u t), s the length along the gap's middle.
TEST(FilmAdvection, ConvectedSwirlIsFirstOrder)
{
    const auto start = [](double angle) { return mean_gap / thickness(angle); };
    const double end = 0.3;
    const auto exact = [&](double angle) {
        double u = start(angle);
        for (int i = 0; i < 200; ++i) { // a contraction: no shock before t = 1
            double foot = angle;        // back with the speed u along the middle of the gap
            constexpr int pieces = 20;
            for (int k = 0; k < pieces; ++k)
                foot -= u * end / pieces / (inner_radius + 0.5 * thickness(foot));
            u = start(foot);
        }
        return u;
    };
    std::vector<double> errors;
    for (int cells : {24, 48, 96}) {
        const Annulus annulus(cells);
        ASSERT_EQ(annulus.coupling.network.films.size(), 1u);
        ASSERT_TRUE(annulus.film().mesh.rim.empty());
        const int steps = cells / 2; // the speed is 2 at most: up to half a cell a step
        std::vector<Vec<2>> u = annulus.film_velocity(start);
        for (int step = 0; step < steps; ++step)
            u = annulus.carried(u, end / steps);
        double error = 0, length = 0;
        for (std::size_t i = 0; i < u.size(); ++i) {
            const FilmElement<2>& e = annulus.film().mesh.elements[i];
            error += e.measure * (u[i] - exact(annulus.angle(e)) * annulus.along(e)).norm();
            length += e.measure;
        }
        errors.push_back(error / length);
    }
    EXPECT_GE(order(errors), 0.9);
}

// Transport adds no energy, and what it has to take it takes from the fastest: the rest of the film stays as it is.
TEST(FilmAdvection, FastElementFeedsNothing)
{
    const Annulus annulus(48);
    const auto energy = [&](const std::vector<Vec<2>>& u) {
        double sum = 0;
        for (std::size_t i = 0; i < u.size(); ++i)
            sum += annulus.film().mesh.elements[i].volume * u[i].squaredNorm();
        return sum;
    };
    const std::vector<Vec<2>> start = annulus.film_velocity([](double angle) { return mean_gap / thickness(angle); });
    std::vector<Vec<2>> u = start;
    const std::size_t fast = 0;
    u[fast] *= 50;
    for (int step = 0; step < 20; ++step) {
        const double before = energy(u);
        u = annulus.advected(u, 1e-4).velocity;
        EXPECT_LE(energy(u), (1 + 1e-9) * before);
    }
    for (std::size_t i = 0; i < u.size(); ++i) {
        const FilmElement<2>&e = annulus.film().mesh.elements[i], &source = annulus.film().mesh.elements[fast];
        if ((e.centroid_master - source.centroid_master).norm() > 0.5) {
            EXPECT_NEAR(u[i].dot(annulus.along(e)) / start[i].norm(), 1.0, 0.02);
        }
    }
}

// Put in place, and carried by the step of first order with whatever fluxes: no energy is added, in steps of any length.
TEST(FilmAdvection, AddsNoEnergyWithAnyFluxes)
{
    const Annulus annulus(24);
    const std::vector<FilmElement<2>>& elements = annulus.film().mesh.elements;
    const PlacedShape<2>& master = annulus.coupling.solids[annulus.film().pair.master].shape;
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    for (double dt : {1e-4, 0.03, 1.0}) {
        std::vector<Vec<2>> u;
        double before = 0, in_place = 0, after = 0;
        for (const FilmElement<2>& e : elements) {
            u.push_back(normal(random) * std::pow(10, normal(random)) * annulus.along(e));
            before += e.volume * u.back().squaredNorm();
        }
        const FilmHistories<2> histories =
            remember_films<2>(annulus.coupling.network, annulus.coupling.solids, annulus.rest, u, {}, annulus.grid.dx());
        const std::vector<FluidInPlace<2>> start =
            put_in_place<2>(annulus.coupling.network, annulus.coupling.solids, {histories.begin()->second.get()});
        std::vector<Vec<2>> flow;
        for (std::size_t i = 0; i < u.size(); ++i) {
            in_place += elements[i].volume * start[i].reference.squaredNorm();
            flow.push_back(elements[i].volume * normal(random) * (master.rotation().transpose() * annulus.along(elements[i])));
        }
        EXPECT_LE(in_place, (1 + 1e-12) * before);
        EXPECT_NEAR(in_place, before, 1e-3 * before);
        const auto carried = FilmTransport<2>(annulus.coupling.network, 0, master, start, flow, {}, dt).low().velocity;
        for (std::size_t i = 0; i < u.size(); ++i)
            after += elements[i].volume * carried[i].squaredNorm();
        EXPECT_LE(after, (1 + 1e-6) * before) << dt;
        EXPECT_GT(after, 0) << dt;
    }
}

// Without the account, a film between other films gained 3500 times its energy in one step (random tank 131: its gap grew from 1e-13 to 1e-6).
TEST(FilmAdvection, AFilmWithoutMouthsHasAnAccount)
{
    const Annulus annulus(24);
    const FilmNetwork<2>& network = annulus.coupling.network;
    ASSERT_TRUE(network.rim.mouths.empty());
    const FilmPair<2>& pair = annulus.film().pair;
    const auto u = annulus.film_velocity([](double angle) { return 1 + 0.5 * std::cos(3 * angle); });
    const FilmFlow<2> flow = annulus.advected(u, 0.05);
    EXPECT_TRUE(flow.account.before.contains(pair));
    // Velocities after the projection along what transport changed: so much more than expected that transport gives energy.
    std::vector<Vec<2>> after;
    for (std::size_t i = 0; i < u.size(); ++i)
        after.push_back(flow.account.master[i] + 100 * (flow.account.transported[i] - flow.account.reference[i]));
    EXPECT_TRUE(mispredicted_films<2>(network, flow.account, after, {}).contains(pair));
    EXPECT_TRUE(mispredicted_films<2>(network, flow.account, flow.velocity, {}).empty());
}

// With pressure the swirl u = Q / h is steady, and the circulation around the inner circle stays: its loss is the error.
TEST(FilmAdvection, SteadySwirlKeepsItsCirculation)
{
    std::vector<double> errors;
    for (int cells : {24, 48, 96}) {
        const Annulus annulus(cells);
        const Coupling<2>& c = annulus.coupling;
        ASSERT_TRUE(c.network.rim.mouths.empty());
        SolverOptions options;
        options.tolerance = 1e-12;
        const CoupledSolver<2> solver(c.system, options);
        FluidVelocity<2> u;
        u.grid = FaceField<2>(annulus.grid);
        u.film_normal.assign(annulus.film().mesh.elements.size(), 0.0);
        const auto project = [&] {
            UnknownVector<2> rhs, p{CellField<2>(annulus.grid), Eigen::VectorXd::Zero(c.system.nodes)};
            outflow(c, u, annulus.rest, rhs);
            rhs.nodes *= -1;
            ASSERT_TRUE(solver.solve(p, rhs).converged);
            subtract_gradient(c, p, u);
        };
        const auto circulation = [&] {
            double sum = 0;
            for (std::size_t i = 0; i < u.film.size(); ++i)
                sum += annulus.film().mesh.elements[i].measure * u.film[i].dot(annulus.along(annulus.film().mesh.elements[i]));
            return sum;
        };
        u.film = annulus.film_velocity([](double angle) { return mean_gap / thickness(angle); });
        project();
        const double first = circulation(), end = 2 * std::numbers::pi; // about one turn
        const int steps = 10 * cells;
        std::vector<Vec<2>> acceleration, increment;
        for (int step = 0; step < steps; ++step) {
            const FilmFlow<2> flow = annulus.advected(u.film, end / steps, acceleration, increment);
            u.film = flow.velocity;
            project();
            settle_films<2>(annulus.coupling.network, flow.account, u.film, {}, end / steps, increment);
            acceleration = u.film;
            for (std::size_t i = 0; i < u.film.size(); ++i)
                acceleration[i] = (u.film[i] - flow.velocity[i]) / (end / steps);
        }
        errors.push_back(std::abs(circulation() / first - 1));
    }
    EXPECT_GE(order(errors), 1.8);
}

} // namespace
} // namespace gapflow
