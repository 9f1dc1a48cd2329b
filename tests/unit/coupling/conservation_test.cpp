// What a projection conserves and leaves alone, whatever the configuration: sums of K, a common rigid motion, momentum.
#include "world.hpp"

#include "gapflow/solver/solver.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace gapflow {
namespace {

BodyScene body(const std::string& name, BodyScene::ShapeKind shape, const Triple& position)
{
    BodyScene b;
    b.name = name;
    b.shape = shape;
    b.position = position;
    b.density = 2.0;
    return b;
}

// A ball in a free spherical (2D: circular) container, off its centre by all but `gap`: nothing else bounds the fluid.
Scene ball_in_container(int dimension, double gap)
{
    Scene scene;
    scene.dimension = dimension;
    const int n = dimension == 2 ? 40 : 22;
    scene.size = {2.24, 2.24, dimension == 2 ? 0.0 : 2.24};
    scene.cells = {n, n, dimension == 2 ? 1 : n};
    const double c = 1.12, e = 0.5 - gap, z = dimension == 2 ? 0 : 1.13;
    BodyScene outer = body("outer", BodyScene::ShapeKind::ball, {c, c + 0.01, z});
    outer.radius = 1.0;
    outer.inside_out = true;
    outer.density.reset();
    outer.mass = 3.0;
    outer.inertia = dimension == 2 ? std::vector<double>{1.5} : std::vector<double>{1.5, 1.5, 1.5};
    BodyScene inner = body("inner", BodyScene::ShapeKind::ball, {c + e * std::cos(0.4), c + 0.01 + e * std::sin(0.4), z});
    inner.radius = 0.5;
    scene.bodies = {outer, inner};
    return scene;
}

// Two boxes, turned, with a gap of half a cell's tenth between them, in a closed box.
Scene turned_plates(int dimension, double gap)
{
    Scene scene;
    scene.dimension = dimension;
    const int n = dimension == 2 ? 48 : 24;
    scene.size = {3, 3, dimension == 2 ? 0.0 : 3.0};
    scene.cells = {n, n, dimension == 2 ? 1 : n};
    const double angle = 25 * std::numbers::pi / 180, shift = 0.5 * (gap + 0.3);
    for (int side : {1, -1}) {
        BodyScene plate =
            body(side > 0 ? "upper" : "lower", BodyScene::ShapeKind::box,
                 {1.51 - side * shift * std::sin(angle), 1.47 + side * shift * std::cos(angle), dimension == 2 ? 0 : 1.5});
        plate.size = {1.0, 0.3, dimension == 2 ? 0.0 : 0.9};
        plate.angle = angle;
        plate.quaternion = {std::cos(angle / 2), 0, 0, std::sin(angle / 2)};
        scene.bodies.push_back(plate);
    }
    return scene;
}

// Turned plates and a ball above them (2D: a disk), gaps of 1e-3, across the borders of a periodic box.
Scene periodic_box(int dimension)
{
    Scene scene = turned_plates(dimension, 1e-3);
    const double angle = 25 * std::numbers::pi / 180, height = 0.5 * 1e-3 + 0.3 + 1e-3 + 0.4;
    BodyScene ball = body("ball", BodyScene::ShapeKind::ball,
                          {1.51 - height * std::sin(angle), 1.47 + height * std::cos(angle), dimension == 2 ? 0 : 1.5});
    ball.radius = 0.4;
    scene.bodies.push_back(ball);
    for (BodyScene& b : scene.bodies)
        b.position = {b.position[0] + 1.3, b.position[1] + 0.7, b.position[2]};
    for (SideScene& side : scene.sides)
        side.kind = SideScene::Kind::periodic;
    return scene;
}

// Calls f(velocity slot along `axis`, place, mass) for every open face.
template <int D, class F>
void for_each_open_face(const Coupling<D>& c, F&& f)
{
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(c.grid->low(), owned_faces_end(*c.grid, axis), [&](const Index<D>& face) {
            if (c.system.conductance(axis, face) <= 0)
                return;
            const int cut = c.fractions->cut(axis, face);
            f(axis, face, cut >= 0 ? c.fractions->faces[cut].open_centroid : c.grid->face_centre(axis, face),
              c.density * c.open(axis, face) * std::pow(c.grid->dx(), D));
        });
}

template <int D>
Twist<D> momentum(const World<D>& world, const FluidVelocity<D>& u, const std::vector<Twist<D>>& twists,
                  const std::vector<double>& film_normal)
{
    const Coupling<D>& c = world.coupling;
    Twist<D> sum = Twist<D>::Zero(); // linear, and angular about the origin
    for_each_open_face(c, [&](int axis, const Index<D>& face, const Vec<D>& x, double mass) {
        sum += wrench<D>(mass * u.grid(axis, face) * unit<D>(axis), x);
    });
    for (const Film<D>& film : c.network.films)
        for (std::size_t e = 0; e < film.mesh.elements.size(); ++e) {
            const FilmElement<D>& element = film.mesh.elements[e];
            const std::size_t i = film.first_element + e;
            sum += wrench<D>(c.density * element.volume * (u.film[i] + film_normal[i] * element.normal), element.centroid);
        }
    for (std::size_t r = 0; r < u.mouth.size(); ++r) {
        const Mouth<D>& mouth = c.network.rim.mouths[r];
        sum += wrench<D>(c.density * mouth.resistance * u.mouth[r] * mouth.section, mouth.x);
    }
    for (std::size_t b = 0; b < world.bodies.size(); ++b) {
        const Twist<D> m = world.mass[b] * twists[b];
        const Vec<D> p = m.template head<D>();
        sum.template head<D>() += p;
        sum.template tail<spin_size<D>>() += m.template tail<spin_size<D>>() + moment<D>(c.solids[b].centre, p);
    }
    return sum;
}

template <int D>
FluidVelocity<D> velocity_of(const World<D>& world, const std::function<Vec<D>(const Vec<D>&)>& field)
{
    const Coupling<D>& c = world.coupling;
    FluidVelocity<D> u;
    u.grid = FaceField<D>(world.grid);
    for_each_open_face(c,
                       [&](int axis, const Index<D>& face, const Vec<D>& x, double) { u.grid(axis, face) = field(x)[axis]; });
    for (const Film<D>& film : c.network.films)
        for (const FilmElement<D>& e : film.mesh.elements) {
            const Vec<D> v = field(e.centroid);
            u.film.push_back(v - v.dot(e.normal) * e.normal);
            u.film_normal.push_back(v.dot(e.normal));
        }
    for (const Mouth<D>& mouth : c.network.rim.mouths)
        u.mouth.push_back(mouth.length * mouth.section.dot(field(mouth.x)));
    return u;
}

template <int D>
void expect_identities(const Scene& scene, bool walls_move)
{
    const World<D> world(scene);
    const Coupling<D>& c = world.coupling;
    ASSERT_GT(c.network.nodes, 0);
    for (const Twist<D>& sum : closure(c))
        EXPECT_LT(sum.cwiseAbs().maxCoeff(), 1e-12 * 10);
    // One rigid motion of everything; domain walls cannot follow it, so only rows away from them count.
    Twist<D> common = Twist<D>::Constant(0.7);
    common[0] = -0.4;
    std::vector<Twist<D>> twists(c.solids.size());
    for (std::size_t s = 0; s < twists.size(); ++s) {
        twists[s].template head<D>() = velocity_at<D>(common, c.solids[s].centre);
        twists[s].template tail<spin_size<D>>() = common.template tail<spin_size<D>>();
    }
    const FluidVelocity<D> u = velocity_of<D>(world, [&](const Vec<D>& x) { return velocity_at<D>(common, x); });
    UnknownVector<D> rest;
    outflow(c, u, twists, rest);
    double worst = rest.nodes.cwiseAbs().maxCoeff();
    for_each_index<D>(world.grid.low(), world.grid.high(), [&](const Index<D>& i) {
        const bool at_wall = (i.array() == 0).any() || (i.array() == world.grid.cells().array() - 1).any();
        if (walls_move || !at_wall)
            worst = std::max(worst, std::abs(rest.cells(i)));
    });
    EXPECT_LT(worst, 1e-12);
}

// In a periodic box only linear momentum is conserved: the force between a body and another's image has no common arm.
// With a constrained body the momentum changes by its reaction alone, which does no work on admissible twists: nothing of it
// is left after the projection.
template <int D>
void expect_momentum(const Scene& scene, int components, int constrained = -1)
{
    const World<D> world(scene);
    const Coupling<D>& c = world.coupling;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(-1, 1);
    FluidVelocity<D> u =
        velocity_of<D>(world, [&](const Vec<D>&) { return Vec<D>(Vec<D>::NullaryExpr([&] { return uniform(random); })); });
    std::vector<Twist<D>> twists(c.solids.size(), Twist<D>::Zero());
    for (std::size_t b = 0; b < world.bodies.size(); ++b)
        twists[b] = c.solids[b].admissible * Twist<D>(Twist<D>::NullaryExpr([&] { return uniform(random); }));
    const Twist<D> before = momentum(world, u, twists, u.film_normal);
    double change = 0;

    Eigen::VectorXd no_contact;
    std::vector<Twist<D>> V = intermediate_twists(c, world.mass, twists, u.film_normal, no_contact);
    UnknownVector<D> rhs, p{CellField<D>(world.grid), Eigen::VectorXd::Zero(c.system.nodes)};
    outflow(c, u, V, rhs);
    for (long i = 0; i < rhs.cells.size(); ++i)
        rhs.cells.data()[i] *= -1;
    rhs.nodes *= -1;
    for (Backend backend : {Backend::multigrid, Backend::petsc}) {
        SolverOptions options;
        options.tolerance = 1e-13;
        options.backend = backend;
        const SolveReport report = CoupledSolver<D>(c.system, options).solve(p, rhs);
        EXPECT_TRUE(report.converged) << report.message;
        std::vector<Twist<D>> V_next = V;
        add_pressure_impulse(c, p, V_next, no_contact);
        FluidVelocity<D> u_next = u;
        subtract_gradient(c, p, u_next);
        const Twist<D> after = momentum(world, u_next, V_next, wall_normal_speed<D>(c.network, c.solids, V_next));
        Twist<D> difference = after - before;
        if (constrained >= 0) {
            const TwistMatrix<D>& P = c.solids[constrained].admissible;
            const Twist<D> V_after = V_next[constrained];
            EXPECT_LT((V_after - P * V_after).norm(), 1e-14 * V_after.norm());
            EXPECT_GT(difference.norm(), 1e-3); // there is a reaction
            difference.template tail<spin_size<D>>() -=
                moment<D>(c.solids[constrained].centre, Vec<D>(difference.template head<D>()));
            difference = P * difference;
        }
        change = std::max(change, difference.head(components).cwiseAbs().maxCoeff() / (1 + before.cwiseAbs().maxCoeff()));
    }
    EXPECT_LT(change, 1e-10);
    char number[16];
    std::snprintf(number, sizeof number, "%.1e", change);
    testing::Test::RecordProperty("change", number);
}

TEST(Identities, BallInContainer2D)
{
    expect_identities<2>(ball_in_container(2, 1e-3), true);
}
TEST(Identities, BallInContainer3D)
{
    expect_identities<3>(ball_in_container(3, 1e-3), true);
}
TEST(Identities, TurnedPlates2D)
{
    expect_identities<2>(turned_plates(2, 1e-3), false);
}
TEST(Identities, TurnedPlates3D)
{
    expect_identities<3>(turned_plates(3, 1e-3), false);
}
TEST(Momentum, BallInContainer2D)
{
    expect_momentum<2>(ball_in_container(2, 1e-3), twist_size<2>);
}
TEST(Momentum, BallInContainer3D)
{
    expect_momentum<3>(ball_in_container(3, 1e-3), twist_size<3>);
}
TEST(Momentum, PeriodicBox2D)
{
    expect_momentum<2>(periodic_box(2), 2);
}
TEST(Momentum, PeriodicBox3D)
{
    expect_momentum<3>(periodic_box(3), 3);
}

// Two disks or balls less than a cell apart, off the grid's axes, a film between them.
Scene two_balls(int dimension)
{
    Scene scene;
    scene.dimension = dimension;
    const int n = dimension == 2 ? 64 : 32;
    const double size = dimension == 2 ? 4.0 : 2.0, gap = 0.05, half = 0.4 + 0.5 * gap, angle = 0.107;
    scene.size = {size, size, dimension == 2 ? 0.0 : size};
    scene.cells = {n, n, dimension == 2 ? 1 : n};
    for (int side : {-1, 1}) {
        BodyScene ball = body(side < 0 ? "left" : "right", BodyScene::ShapeKind::ball,
                              {0.5 * size + 0.003 + side * half * std::cos(angle),
                               0.5 * size + 0.011 + side * half * std::sin(angle), dimension == 2 ? 0 : 0.5 * size + 0.02});
        ball.radius = 0.4;
        scene.bodies.push_back(ball);
    }
    scene.gap.threshold = 1.5;
    return scene;
}

// A ball that turns about its centre moves no fluid: next to no flux into the film's nodes, whether it bears the film or not, and in 2D no moment of a
// pressure that is linear in space.
template <int D>
void expect_no_flux_of_spin(double flux_allowed, double moment_allowed)
{
    const World<D> world(two_balls(D), true);
    const Coupling<D>& c = world.coupling;
    ASSERT_EQ(c.network.films.size(), 1u);
    const FilmMesh<D>& mesh = c.network.films[0].mesh;
    for (int b : {0, 1}) {
        const Vec<D>& centre = c.solids[b].centre;
        const auto spin = [](const Twist<D>& flux) { return flux.template tail<spin_size<D>>().norm(); };
        std::vector<Twist<D>> of_node(c.network.nodes, Twist<D>::Zero());
        for (const auto& entry : c.node_flux)
            if (entry.body == b)
                of_node[entry.row] += entry.flux;
        double into_nodes = 0, section = 0;
        for (const Twist<D>& flux : of_node)
            into_nodes += spin(flux);
        for (const Mouth<D>& mouth : c.network.rim.mouths)
            section += mouth.length * spin(wrench<D>(mouth.section, mouth.x - centre));
        EXPECT_LT(into_nodes, flux_allowed * section) << "body " << b;
        for (int axis = 0; axis < D; ++axis) {
            Twist<D> sum = Twist<D>::Zero();
            for (const auto& entry : c.cell_flux)
                if (entry.body == b)
                    sum += (world.grid.cell_centre(entry.row)[axis] - centre[axis]) * entry.flux;
            for (int i = 0; i < c.network.nodes; ++i)
                sum += (mesh.mid[i][axis] - centre[axis]) * of_node[i];
            EXPECT_LT(spin(sum), moment_allowed) << "body " << b << " axis " << axis;
        }
    }
}

// With a volume of the film of int h, without the part of the flux that leans, 0.24 and 3e-3.
TEST(Identities, ABallThatTurnsMovesNoFluid2D)
{
    expect_no_flux_of_spin<2>(0.1, 3e-4);
}
TEST(Identities, ABallThatTurnsMovesNoFluid3D)
{
    expect_no_flux_of_spin<3>(0.05, 2e-3);
}

Scene constrained(Scene scene, const std::array<bool, 6>& free)
{
    scene.bodies[1].free = free;
    return scene;
}

Scene hinged(Scene scene, const Triple& point, const Triple& axis)
{
    scene.bodies[1].hinge = HingeScene{point, axis};
    return scene;
}

TEST(Momentum, OfAllButAReactionWithDirectionsHeld2D)
{
    expect_momentum<2>(constrained(ball_in_container(2, 1e-3), {false, true, false, false, false, false}), twist_size<2>, 1);
    // (The fluid does not turn a ball: no reaction.)
    expect_momentum<2>(constrained(periodic_box(2), {true, true, false, false, false, false}), 2, 1);
}
TEST(Momentum, OfAllButAReactionWithDirectionsHeld3D)
{
    expect_momentum<3>(constrained(ball_in_container(3, 1e-3), {true, false, true, false, true, false}), twist_size<3>, 1);
}
TEST(Momentum, OfAllButAReactionWithAHinge2D)
{
    expect_momentum<2>(hinged(ball_in_container(2, 1e-3), {0.7, 1.2, 0}, {1, 0, 0}), twist_size<2>, 1);
}
TEST(Momentum, OfAllButAReactionWithAHinge3D)
{
    expect_momentum<3>(hinged(ball_in_container(3, 1e-3), {0.7, 1.2, 0.9}, {2.0 / 3, -1.0 / 3, 2.0 / 3}), twist_size<3>, 1);
}

} // namespace
} // namespace gapflow
