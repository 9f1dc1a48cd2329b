// Constraints and springs of a single body without fluid, against exact motions.
#include "gapflow/body/constraint.hpp"
#include "gapflow/body/forces.hpp"
#include "gapflow/body/move.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace gapflow {
namespace {

constexpr double pi = std::numbers::pi;

template <int D>
void step(RigidBody<D>& body, double dt, const Vec<D>& gravity = Vec<D>::Zero())
{
    move(body, 0, dt);
    finish_step(body, forced_twist<D>(body, gravity, 0, dt), dt);
}

// Time between the first and the last of `crossings` upward zero crossings of f over the steps of a body, per crossing.
template <int D>
double period(RigidBody<D>& body, double dt, const Vec<D>& gravity, int crossings, const std::function<double()>& f)
{
    double time = 0, first = 0, last = 0;
    int count = 0;
    for (double before = f(); count <= crossings && time < 1e4; time += dt) {
        step(body, dt, gravity);
        const double now = f();
        if (before < 0 && now >= 0) {
            last = time + dt * before / (before - now);
            first = count++ == 0 ? last : first;
        }
        before = now;
    }
    return (last - first) / crossings;
}

// A box that hangs from a hinge beside it.
RigidBody<2> pendulum_2d()
{
    RigidBody<2> body;
    body.shape = make_box<2>(Vec<2>(0.4, 1.0));
    set_density(body, 3.0);
    place<2>(body, Vec<2>(0.3, -0.7), Rotation<2>(0.2));
    attach_hinge<2>(body, Vec<2>(0.1, 0.2), Spin<2>(1.0));
    return body;
}

RigidBody<3> pendulum_3d(const Vec<3>& axis)
{
    RigidBody<3> body;
    body.name = "pendulum";
    body.shape = make_box<3>(Vec<3>(0.4, 1.0, 0.3));
    set_density(body, 3.0);
    place<3>(body, Vec<3>(0.3, -0.7, 0.4), Rotation<3>(0.9, 0.1, -0.3, 0.2).normalized());
    attach_hinge<3>(body, Vec<3>(0.1, 0.2, -0.1), axis.normalized());
    return body;
}

TEST(Constraint, BasisAndProjector)
{
    RigidBody<2> body = pendulum_2d();
    const TwistBasis<2> B = admissible_twists(body);
    ASSERT_EQ(B.cols(), 1);
    EXPECT_NEAR(B.norm(), 1, 1e-15);
    const Vec<2> at_hinge = velocity_at<2>(Twist<2>(B), body.hinge->point - body.centre());
    EXPECT_NEAR(at_hinge.norm(), 0, 1e-15);
    EXPECT_NEAR((admissible_projector(body) * admissible_projector(body) - admissible_projector(body)).norm(), 0, 1e-15);

    body.hinge.reset();
    EXPECT_FALSE(constrained(body));
    EXPECT_EQ(admissible_projector(body), (TwistMatrix<2>(TwistMatrix<2>::Identity())));
    body.can_move = {false, true, false};
    EXPECT_EQ(admissible_projector(body), (TwistMatrix<2>(Twist<2>(0, 1, 0).asDiagonal())));
    body.can_move = {false, false, false};
    EXPECT_EQ(admissible_twists(body).cols(), 0);
    EXPECT_EQ(twist_after(body, Twist<2>(1, 2, 3)), (Twist<2>(Twist<2>::Zero())));
}

TEST(Constraint, ReactionsDoNoWork)
{
    const RigidBody<3> body = pendulum_3d(Vec<3>(1, 2, -0.5));
    Twist<3> impulse;
    impulse << 1, 2, 3, 4, 5, 6;
    const Twist<3> V = twist_after<3>(body, impulse);
    const Twist<3> reaction = mass_matrix(body) * V - impulse;
    EXPECT_NEAR(reaction.dot(V), 0, 1e-12 * impulse.dot(V));
    // The momentum about the axis is the impulse's.
    const Twist<3> turn = hinged_twist(body, 1.0);
    EXPECT_NEAR(V[3] / turn[3], turn.dot(impulse) / turn.dot(mass_matrix(body) * turn), 1e-14);
}

TEST(Hinge, TurnsFreelyWithoutDriftOver10000Steps)
{
    RigidBody<3> body = pendulum_3d(Vec<3>(1, 2, -0.5));
    const Vec<3> axis = body.hinge->axis, arm = body.hinge->arm;
    set_initial_twist(body, hinged_twist(body, 1.3));
    const double energy = kinetic_energy(body);
    const Vec<3> axis_body = body.pose.matrix().transpose() * axis;
    for (int i = 0; i < 10000; ++i)
        step(body, 0.03);
    EXPECT_LT((body.centre() - body.pose.matrix() * arm - body.hinge->point).norm(), 1e-13);
    EXPECT_LT((body.pose.matrix() * axis_body - axis).norm(), 1e-11);
    EXPECT_NEAR(kinetic_energy(body) / energy, 1, 1e-11);
    // Turned by 1.3 * 300 radians.
    const Rotation<3> expected =
        rotation_of<3>(std::remainder(1.3 * 300, 2 * pi) * axis) * Rotation<3>(0.9, 0.1, -0.3, 0.2).normalized();
    EXPECT_LT(body.pose.rotation.angularDistance(expected), 1e-9);
}

TEST(Hinge, FlatBodyTurnsFreely)
{
    RigidBody<2> body = pendulum_2d();
    set_initial_twist(body, hinged_twist(body, -0.7));
    for (int i = 0; i < 10000; ++i)
        step(body, 0.03);
    EXPECT_LT((body.centre() - body.pose.matrix() * body.hinge->arm - body.hinge->point).norm(), 1e-13);
    EXPECT_NEAR(body.pose.rotation.angle(), 0.2 - 0.7 * 300, 1e-9);
    EXPECT_NEAR(body.twist[2], -0.7, 1e-12);
}

// Physical pendulum of large amplitude: T = 4 K(sin(a/2)) / w0 by the arithmetic-geometric mean; energy without drift.
double pendulum_period(double small_frequency, double amplitude)
{
    double a = 1, g = std::cos(0.5 * amplitude);
    for (int i = 0; i < 8; ++i) {
        const double mean = 0.5 * (a + g);
        g = std::sqrt(a * g);
        a = mean;
    }
    return 2 * pi / (small_frequency * a);
}

TEST(Hinge, PendulumHasItsPeriodAndKeepsItsEnergy)
{
    const Vec<2> g(0, -9.81);
    RigidBody<2> body = pendulum_2d();
    const Vec<2> arm = body.centre() - body.hinge->point;
    const double length = arm.norm(), amplitude = std::atan2(arm[0], -arm[1]);
    const double I = body.inertia(0, 0) + body.mass * length * length, w0 = std::sqrt(body.mass * 9.81 * length / I);
    const double T = pendulum_period(w0, amplitude);
    auto angle = [&] { return -(body.centre() - body.hinge->point)[0]; };
    std::vector<double> errors;
    for (int steps : {40, 80}) {
        body = pendulum_2d();
        const double level = -body.mass * g.dot(body.centre());
        double low = 1e300, high = -1e300;
        errors.push_back(period<2>(body, T / steps, g, 100, angle) / T - 1);
        for (int i = 0; i < steps; ++i) {
            step(body, T / steps, g);
            const double energy = kinetic_energy(body) - body.mass * g.dot(body.centre()) - level;
            low = std::min(low, energy);
            high = std::max(high, energy);
        }
        const double scale = body.mass * 9.81 * length * (1 - std::cos(amplitude));
        EXPECT_LT(std::max(high, -low), 40.0 / steps * 0.2 * scale);
    }
    EXPECT_LT(std::abs(errors[1]), 1e-3);
    EXPECT_GT(errors[0] / errors[1], 3.5); // second order
}

TEST(Hinge, PendulumAboutASkewAxis)
{
    const Vec<3> g(0, 0, -9.81), axis = Vec<3>(1, 2, -0.5).normalized();
    RigidBody<3> body = pendulum_3d(axis);
    const double I = hinged_twist(body, 1.0).dot(mass_matrix(body) * hinged_twist(body, 1.0));
    const Vec<3> across = g - g.dot(axis) * axis;
    const Vec<3> r = body.centre() - body.hinge->point, r_across = r - r.dot(axis) * axis;
    const double amplitude = std::acos(r_across.dot(across) / (r_across.norm() * across.norm()));
    const double T = pendulum_period(std::sqrt(body.mass * across.norm() * r_across.norm() / I), amplitude);
    auto angle = [&] { return axis.dot(across.cross(body.centre() - body.hinge->point)); };
    EXPECT_NEAR(period<3>(body, T / 100, g, 50, angle) / T, 1, 1e-3);
    EXPECT_LT((body.centre() - body.pose.matrix() * body.hinge->arm - body.hinge->point).norm(), 1e-14);
}

template <int D>
RigidBody<D> sprung(double stiffness, double damping)
{
    RigidBody<D> body;
    body.name = "sprung";
    body.shape = make_ball<D>(0.5);
    set_density(body, 2.0);
    body.spring = Spring<D>{Vec<D>::Constant(0.25), stiffness, damping};
    place<D>(body, Vec<D>(body.spring->anchor - 0.1 * unit<D>(0)), body.pose.rotation);
    return body;
}

TEST(Spring, Frequency)
{
    auto error = [](int steps) {
        RigidBody<3> body = sprung<3>(40, 0);
        const double T = 2 * pi * std::sqrt(body.mass / 40);
        EXPECT_NEAR(spring_frequency(body) * T, 2 * pi, 1e-13);
        const double found = period<3>(body, T / steps, Vec<3>::Zero(), 50, [&] { return body.centre()[0] - 0.25; });
        EXPECT_NEAR(body.centre()[1], 0.25, 1e-15);
        return found / T - 1;
    };
    const double coarse = error(20), fine = error(40);
    EXPECT_LT(std::abs(coarse), 0.01); // what step control asks for
    EXPECT_NEAR(coarse / fine, 4, 0.2);
}

TEST(Spring, KeepsItsEnergy)
{
    RigidBody<2> body = sprung<2>(40, 0);
    const double T = 2 * pi * std::sqrt(body.mass / 40);
    for (int i = 0; i < 100 * 40; ++i)
        step(body, T / 40);
    double largest = 0;
    for (int i = 0; i < 40; ++i) {
        step(body, T / 40);
        largest = std::max(largest, std::abs(body.centre()[0] - 0.25));
    }
    EXPECT_NEAR(largest, 0.1, 0.002);
}

TEST(Spring, Damping)
{
    const double damping = 1.5;
    auto error = [&](int steps) {
        RigidBody<2> body = sprung<2>(40, damping);
        const double rate = 0.5 * damping / body.mass, w = std::sqrt(40 / body.mass - rate * rate), T = 2 * pi / w;
        double worst = 0;
        for (int i = 1; i <= 3 * steps; ++i) {
            step(body, T / steps);
            const double t = i * T / steps;
            // The pose lags by dt/2 of the velocity's last change.
            const double lag = 0.5 * T / steps * T / steps * body.acceleration[0];
            const double exact = -0.1 * std::exp(-rate * t) * (std::cos(w * t) + rate / w * std::sin(w * t));
            worst = std::max(worst, std::abs(body.centre()[0] + lag - 0.25 - exact));
        }
        return worst;
    };
    const double coarse = error(40), fine = error(80);
    EXPECT_LT(coarse, 0.1 * 0.02);
    EXPECT_NEAR(coarse / fine, 4, 0.4);
}

TEST(Spring, IsStableAtAnyStiffnessAndDamping)
{
    for (double stiffness : {0.0, 1e-3, 1.0, 1e3, 1e6, 1e12})
        for (double damping : {0.0, 1.0, 1e6}) {
            RigidBody<2> body = sprung<2>(stiffness, damping);
            for (int i = 0; i < 500; ++i)
                step(body, 0.1);
            EXPECT_LE((body.centre() - body.spring->anchor).norm(), 0.1001) << stiffness << " " << damping;
            EXPECT_LE(body.twist.norm() * std::sqrt(body.mass), 0.1001 * std::sqrt(stiffness)) << stiffness << " " << damping;
        }
}

// Off the centre of mass the spring turns the body: small oscillations about the hinge have I w^2 = k b^2.
TEST(Spring, ActsAtTheShapesOriginOnItsLever)
{
    for (double offset : {0.0, 0.3}) {
        RigidBody<2> body;
        body.shape = make_box<2>(Vec<2>(1.0, 0.2));
        set_density(body, 2.0);
        body.centre_of_mass = Vec<2>(offset, 0);
        place<2>(body, Vec<2>(1.0 + offset, 0), Rotation<2>(0.0));
        attach_hinge<2>(body, Vec<2>(0, 0), Spin<2>(1.0));
        body.spring = Spring<2>{Vec<2>(1.0, 0), 25, 0};
        const double I = body.inertia(0, 0) + body.mass * (1 + offset) * (1 + offset), T = 2 * pi * std::sqrt(I / 25);
        EXPECT_NEAR(spring_frequency(body) * T, 2 * pi, 1e-12);
        set_initial_twist(body, hinged_twist(body, -0.01));
        EXPECT_NEAR(period<2>(body, T / 100, Vec<2>::Zero(), 20, [&] { return body.pose.rotation.angle(); }) / T, 1, 1e-3);
    }
    // Without a hinge: a force off the centre of mass, with its moment.
    RigidBody<2> body;
    body.shape = make_ball<2>(0.5);
    set_mass<2>(body, 2, SpinMatrix<2>(0.1));
    body.centre_of_mass = Vec<2>(0.2, 0);
    place<2>(body, Vec<2>(0.2, 0), Rotation<2>(0.0));
    body.spring = Spring<2>{Vec<2>(0, 3), 5, 2};
    set_initial_twist<2>(body, Twist<2>(0, 0.5, 1)); // the origin's velocity: 0.5 - 0.2
    EXPECT_NEAR((spring_wrench(body) - Twist<2>(0, 15 - 0.6, -0.2 * (15 - 0.6))).norm(), 0, 1e-14);
    EXPECT_NEAR(spring_energy(body), 22.5, 1e-14);
}

// A hinged body whose spring is far away swings like a pendulum: the pull's direction changes little.
TEST(Spring, FarAnchorPullsAHingedBodyLikeGravity)
{
    RigidBody<2> body = pendulum_2d();
    const Vec<2> arm = body.centre() - body.hinge->point;
    const double pull = 30, far = 1e5;
    body.spring = Spring<2>{Vec<2>(body.centre()[0], -far), pull / far, 0};
    const double amplitude = std::atan2(arm[0], -arm[1]);
    const double I = body.inertia(0, 0) + body.mass * arm.squaredNorm();
    const double T = pendulum_period(std::sqrt(pull * arm.norm() / I), amplitude);
    EXPECT_GE(swing_frequency<2>(body, Vec<2>::Zero(), 0) * 1.0001, std::sqrt(pull * arm.norm() / I));
    EXPECT_NEAR(period<2>(body, T / 100, Vec<2>::Zero(), 50, [&] { return -(body.centre() - body.hinge->point)[0]; }) / T, 1,
                1e-3);
}

} // namespace
} // namespace gapflow
