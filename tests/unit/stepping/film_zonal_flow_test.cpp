// Zonal flow in the gap between two spheres, the inner one off centre along the axis: steady, whatever its profile. The film fills the gap;
// everything is at rest but its fluid.
#include "coupled_scene.hpp"

#include "gapflow/solver/solver.hpp"
#include "gapflow/stepping/setup.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gapflow {
namespace {

constexpr double inner_radius = 0.97, outer_radius = 1.0, off_centre = 0.015;

struct Shells : CoupledSceneOf<3> {
    explicit Shells(int cells) : CoupledSceneOf<3>(make_scene(cells)), centre(coupling.solids[0].centre) {}
    static Scene make_scene(int cells)
    {
        Scene scene;
        scene.dimension = 3;
        scene.size = {2.24, 2.24, 2.24};
        scene.cells = {cells, cells, cells};
        scene.gap.threshold = 4.0;
        BodyScene inner, outer;
        inner.name = "inner";
        outer.name = "outer";
        inner.shape = outer.shape = BodyScene::ShapeKind::ball;
        inner.motion = outer.motion = BodyScene::Motion::fixed;
        inner.radius = inner_radius;
        inner.position = {1.13, 1.11, 1.12 + off_centre};
        outer.radius = outer_radius;
        outer.position = {1.13, 1.11, 1.12};
        outer.inside_out = true;
        scene.bodies = {inner, outer};
        return scene;
    }
    const std::vector<FilmElement<3>>& elements() const { return film().mesh.elements; }
    // Angular momentum about the axis, over the density.
    double spin(const std::vector<Vec<3>>& u) const
    {
        double sum = 0;
        for (std::size_t i = 0; i < u.size(); ++i)
            sum += elements()[i].volume * (elements()[i].centroid - centre).cross(u[i])[2];
        return sum;
    }
    double energy(const std::vector<Vec<3>>& u) const
    {
        double sum = 0;
        for (std::size_t i = 0; i < u.size(); ++i)
            sum += 0.5 * elements()[i].volume * u[i].squaredNorm();
        return sum;
    }
    Vec<3> centre;
};

TEST(FilmZonalFlow, KeepsItsSpinBetweenSpheres)
{
    std::vector<double> lost;
    std::string series;
    for (int cells : {12, 24}) {
        const Shells shells(cells);
        const Coupling<3>& c = shells.coupling;
        ASSERT_EQ(c.network.films.size(), 1u);
        ASSERT_TRUE(c.network.rim.mouths.empty());
        SolverOptions options;
        options.tolerance = 1e-10;
        const CoupledSolver<3> solver(c.system, options);
        FluidVelocity<3> u;
        u.grid = FaceField<3>(shells.grid);
        u.film_normal.assign(shells.elements().size(), 0.0);
        const auto project = [&] {
            UnknownVector<3> rhs, p{CellField<3>(shells.grid), Eigen::VectorXd::Zero(c.system.nodes)};
            outflow(c, u, shells.rest, rhs);
            rhs.nodes *= -1;
            ASSERT_TRUE(solver.solve(p, rhs).converged);
            subtract_gradient(c, p, u);
        };
        for (const FilmElement<3>& e : shells.elements()) {
            const Vec<3> x = e.centroid - shells.centre;
            const double sine = std::hypot(x[0], x[1]) / x.norm();
            const Vec<3> w = (1.5 - sine * sine) * unit<3>(2).cross(x); // faster near the poles
            u.film.push_back(w - w.dot(e.normal) * e.normal);
        }
        project();
        const double first = shells.spin(u.film), start = shells.energy(u.film);
        double before = start;
        const int steps = 5 * cells;
        const double dt = 2 * std::numbers::pi / steps; // about one turn in all
        std::vector<Vec<3>> acceleration, increment;
        FilmDebts<3> debts;
        for (int step = 0; step < steps; ++step) {
            const FilmHistories<3> histories =
                remember_films<3>(c.network, c.solids, shells.rest, u.film, {}, shells.grid.dx(), {}, acceleration, increment);
            const FilmFlow<3> flow = advect_films<3>(
                c.network, c.solids, histories,
                [](const std::vector<Vec<3>>& x) { return std::vector<Vec<3>>(x.size(), Vec<3>(Vec<3>::Zero())); },
                [](int, int) { return MouthLaw{}; }, debts, dt);
            u.film = flow.velocity;
            project();
            debts = settle_films<3>(c.network, flow.account, u.film, {}, dt, increment);
            acceleration = u.film;
            for (std::size_t i = 0; i < u.film.size(); ++i)
                acceleration[i] = (u.film[i] - flow.velocity[i]) / dt;
            before = shells.energy(u.film);
            EXPECT_LE(before, 1.0005 * start);
        }
        lost.push_back(1 - shells.spin(u.film) / first);
        char text[64];
        std::snprintf(text, sizeof text, "%s%d^3: %.2e (energy %.2e)", series.empty() ? "" : ", ", cells, lost.back(),
                      1 - before / start);
        series += text;
    }
    RecordProperty("series", series);
    EXPECT_LE(std::abs(lost[1]), 0.01) << series;
    EXPECT_LE(std::abs(lost[1]), 0.6 * std::abs(lost[0])) << series;
}

} // namespace
} // namespace gapflow
