// Steady potential flow through the throat of two bodies that nearly touch: what the films' transport alone makes of it. In 2D a swirl around a cylinder
// that nearly touches the ring around it. In 3D the flow past a ball's nearest point: the fluxes through the film's mouths and the flow around it stay as
// they are.
#include "coupled_scene.hpp"

#include "gapflow/film/film_account.hpp"
#include "gapflow/film/film_momentum.hpp"
#include "gapflow/film/film_vorticity.hpp"

#include <Eigen/Sparse>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace gapflow {
namespace {

constexpr double radius = 0.5, dx = 0.125, clearance = 0.02;
enum class Beside { floor, ball, ring };

/// A ball and what it nearly touches, the gap's least thickness in cells.
template <int D>
class Throat : public CoupledSceneOf<D> {
public:
    Throat(Beside beside, double gap) : CoupledSceneOf<D>(make_scene(beside, gap)), beside_(beside), gap_(gap * dx)
    {
        const double curvature = beside == Beside::floor  ? 1 / radius
                                 : beside == Beside::ball ? 2 / radius
                                                          : 1 / radius - 1 / (radius + clearance);
        lateral_ = std::sqrt(2 * gap_ / curvature);
    }
    bool has_one_film() const
    {
        return this->coupling.network.films.size() == 1 && mouths().empty() == (beside_ == Beside::ring);
    }
    double lateral() const { return lateral_; }

    struct Result {
        double highest = 0, left = 0; ///< energy over the first
    };
    /// `length`: on which a step crosses a tenth, 20 times in all.
    Result crossed(double length)
    {
        start();
        const double first = energy(u_);
        double fastest = 0;
        for (const Vec<D>& u : u_)
            fastest = std::max(fastest, u.norm());
        const double dt = 0.1 * length / fastest;
        Result result{1, 1};
        std::vector<Vec<D>> acceleration, increment;
        FilmDebts<D> debts;
        for (int step = 0; step < 400; ++step) {
            const FilmHistories<D> histories = remember_films<D>(this->coupling.network, this->coupling.solids, this->rest, u_,
                                                                 flux_, dx, {}, acceleration, increment);
            FilmFlow<D> flow = advect_films<D>(
                this->coupling.network, this->coupling.solids, histories,
                [&](const std::vector<Vec<D>>& x) { return around(x); }, [](int, int) { return MouthLaw{}; }, debts, dt);
            damp_vorticity(this->coupling.network, dx, flow.velocity);
            u_ = flow.account.transported = flow.velocity;
            project();
            debts = settle_films<D>(this->coupling.network, flow.account, u_, flux_, dt, increment);
            acceleration = u_;
            for (std::size_t i = 0; i < u_.size(); ++i)
                acceleration[i] = (u_[i] - flow.velocity[i]) / dt;
            result.left = energy(u_) / first;
            result.highest = std::max(result.highest, result.left);
        }
        return result;
    }

private:
    static Scene make_scene(Beside beside, double gap)
    {
        Scene scene;
        scene.dimension = D;
        scene.size = {3, 3, D == 3 ? 3.0 : 0.0};
        scene.cells = {24, 24, D == 3 ? 24 : 1};
        scene.gap.threshold = 1.5;
        scene.gap.roughness = 0;
        BodyScene ball;
        ball.name = "ball";
        ball.shape = BodyScene::ShapeKind::ball;
        ball.motion = BodyScene::Motion::fixed;
        ball.radius = radius;
        ball.position = {1.47, 1.52, 1.49};
        if (beside == Beside::ring) {
            BodyScene ring = ball;
            ring.name = "ring";
            ring.inside_out = true;
            ring.radius += clearance;
            ball.position[0] += clearance - gap * dx;
            scene.gap.threshold = 4;
            scene.bodies = {ball, ring};
            return scene;
        }
        if (beside == Beside::floor) {
            ball.position[D - 1] = radius + gap * dx;
            scene.bodies = {ball};
            return scene;
        }
        BodyScene other = ball;
        other.name = "other";
        ball.position[D - 1] -= radius + 0.5 * gap * dx;
        other.position[D - 1] += radius + 0.5 * gap * dx;
        scene.bodies = {ball, other};
        return scene;
    }
    const FilmMesh<D>& mesh() const { return this->film().mesh; }
    const std::vector<Mouth<D>>& mouths() const { return this->coupling.network.rim.mouths; }
    double energy(const std::vector<Vec<D>>& u) const
    {
        double sum = 0;
        for (std::size_t i = 0; i < u.size(); ++i)
            sum += 0.5 * mesh().elements[i].volume * u[i].squaredNorm();
        return sum;
    }
    // The flow with the fluxes of a uniform flow along the first axis through the film's rim.
    void start()
    {
        factorise();
        double sum = 0, section = 0;
        flux_.clear();
        for (const Mouth<D>& mouth : mouths()) {
            flux_.push_back(mouth.length * mouth.h * mouth.outward[0]);
            sum += flux_.back();
            section += mouth.length * mouth.h;
        }
        for (std::size_t r = 0; r < flux_.size(); ++r)
            flux_[r] -= sum / section * mouths()[r].length * mouths()[r].h;
        u_.assign(mesh().elements.size(), Vec<D>::Zero());
        for (std::size_t k = 0; k < u_.size() && beside_ == Beside::ring; ++k) {
            const FilmElement<D>& e = mesh().elements[k];
            u_[k].template head<2>() = e.measure / e.volume * Vec<2>(-e.normal[1], e.normal[0]);
        }
        project();
        steady_ = u_;
    }
    // Nearest element's velocity in the steady flow.
    std::vector<Vec<D>> around(const std::vector<Vec<D>>& places) const
    {
        std::vector<Vec<D>> result;
        for (const Vec<D>& x : places) {
            std::size_t best = 0;
            for (std::size_t i = 1; i < steady_.size(); ++i)
                if ((mesh().elements[i].centroid - x).squaredNorm() < (mesh().elements[best].centroid - x).squaredNorm())
                    best = i;
            result.push_back(steady_[best]);
        }
        return result;
    }
    void factorise()
    {
        const int n = static_cast<int>(mesh().x.size());
        std::vector<Eigen::Triplet<double>> entries;
        double scale = 0;
        for (const FilmElement<D>& e : mesh().elements)
            for (int i = 0; i < D; ++i)
                for (int j = 0; j < D; ++j) {
                    entries.emplace_back(e.nodes[i], e.nodes[j], e.conductance() * e.gradient[i].dot(e.gradient[j]));
                    scale = std::max(scale, entries.back().value());
                }
        entries.emplace_back(0, 0, scale); // fixes the level
        Eigen::SparseMatrix<double> matrix(n, n);
        matrix.setFromTriplets(entries.begin(), entries.end());
        factor_.compute(matrix);
    }
    // The film's own, with its mouths' fluxes given.
    void project()
    {
        Eigen::VectorXd needs = Eigen::VectorXd::Zero(static_cast<long>(mesh().x.size()));
        for (std::size_t k = 0; k < u_.size(); ++k) {
            const FilmElement<D>& e = mesh().elements[k];
            for (int i = 0; i < D; ++i)
                needs[e.nodes[i]] += e.volume * e.gradient[i].dot(u_[k]);
        }
        for (std::size_t r = 0; r < flux_.size(); ++r)
            for (int i = 0; i < D - 1; ++i)
                needs[mouths()[r].nodes[i] - this->film().first_node] -= mouths()[r].shape[i] * flux_[r];
        const Eigen::VectorXd p = factor_.solve(needs);
        for (std::size_t k = 0; k < u_.size(); ++k) {
            const FilmElement<D>& e = mesh().elements[k];
            for (int i = 0; i < D; ++i)
                u_[k] -= e.conductance() / e.volume * p[e.nodes[i]] * e.gradient[i];
        }
    }

    Beside beside_;
    double gap_, lateral_;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
    std::vector<Vec<D>> u_, steady_;
    std::vector<double> flux_;
};

// `most`: of the highest energy over the first. Potential flow is the one of least energy with its fluxes: what is above it is vorticity, the error of
// the transport.
template <int D>
void keeps_energy(Beside beside, double most)
{
    std::string resolved, as_runs;
    double highest = 1, least = 1;
    for (double gap : {0.1, 1e-2, 1e-3, 1e-4}) {
        Throat<D> throat(beside, gap);
        ASSERT_TRUE(throat.has_one_film());
        for (bool fine : {true, false}) {
            const auto result = throat.crossed(fine ? throat.lateral() : std::max(throat.lateral(), (D == 2 ? 1 : 10) * dx));
            char text[80];
            std::string& series = fine ? resolved : as_runs;
            std::snprintf(text, sizeof text, "%s%+.3f, %+.2f %%", series.empty() ? "" : "; ", 100 * (result.highest - 1),
                          100 * (result.left - 1));
            series += text;
            highest = std::max(highest, result.highest);
            if (fine) // steps over many throats' widths are stable, but lose flow
                least = std::min(least, result.left);
        }
    }
    testing::Test::RecordProperty("resolved", resolved);
    testing::Test::RecordProperty("as_runs", as_runs);
    testing::Test::RecordProperty("highest", std::to_string(highest));
    testing::Test::RecordProperty("least", std::to_string(least));
    EXPECT_LE(highest, most) << resolved << " | " << as_runs;
    EXPECT_GE(least, 0.95) << resolved << " | " << as_runs;
}

TEST(FilmThroat, CylinderInARingKeepsItsFlow)
{
    keeps_energy<2>(Beside::ring, 1.001);
}

// Without the damping of vorticity 1.30, over a floor 1.25, at the thinnest gap with steps as in runs.
TEST(FilmThroat, BallsKeepTheirFlow)
{
    keeps_energy<3>(Beside::ball, 1.03);
}

TEST(FilmThroat, BallOverAFloorKeepsItsFlow)
{
    keeps_energy<3>(Beside::floor, 1.03);
}

} // namespace
} // namespace gapflow
