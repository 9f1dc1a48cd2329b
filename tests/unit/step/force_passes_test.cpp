// Passes of a step's forces that answer each other.
#include "gapflow/step/force_passes.hpp"

#include <gtest/gtest.h>

namespace gapflow {
namespace {

TEST(ForcePasses, FewDirectionsCostFewPasses)
{
    std::vector<RigidBody<2>> bodies(3);
    for (RigidBody<2>& body : bodies)
        body.volume = 0.5;
    bodies[1].mass = 1e-3;
    bodies[2].motion = Motion::fixed;
    const std::vector<Twist<2>> none(3, Twist<2>::Zero());
    const StepForces<2> settled{{Twist<2>(1, 2, 3), Twist<2>(-1, 0.5, 0.1), none[2]}, {Twist<2>(0, 0.2, 0), none[1], none[2]}};
    const auto answer = [&](const StepForces<2>& given) { // moves apart in one direction, and creeps in another
        StepForces<2> found = settled;
        for (int b = 0; b < 2; ++b) {
            const Twist<2> off = given.mean[b] + given.missing[b] - settled.mean[b] - settled.missing[b];
            found.mean[b] -= 1.7 * Twist<2>(off[0], 0, 0);
            found.missing[b] += 0.8 * Twist<2>(0, off[1], off[2]);
        }
        return found;
    };
    ForcePasses<2> passes(bodies, 1.0);
    StepForces<2> forces{none, none};
    for (int pass = 1; pass <= 4; ++pass)
        forces = passes.next(forces, answer(forces));
    for (int b = 0; b < 3; ++b) {
        EXPECT_LT((forces.mean[b] - settled.mean[b]).norm(), 1e-9) << b;
        EXPECT_LT((forces.missing[b] - settled.missing[b]).norm(), 1e-9) << b;
    }
}

} // namespace
} // namespace gapflow
