// A block on a dry floor, for tests of voids.
#pragma once

#include "scenes.hpp"

#include "gapflow/stepping/observation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace gapflow {

inline constexpr double ambient = 10, thickness = 1e-4;

/// A block of mass 1 and facing area 1 on the dry floor of a tank with an open top under pressure 10, pulled up.
inline Scene dry_block(int dimension, double pull)
{
    Scene scene = box_of_fluid(dimension, 16, SideScene::Kind::wall);
    scene.size = dimension == 2 ? Triple{4, 2, 0} : Triple{3, 3, 1.5};
    scene.cells = dimension == 2 ? std::array<int, 3>{32, 16, 1} : std::array<int, 3>{16, 16, 8};
    scene.sides[2 * dimension - 1].kind = SideScene::Kind::open;
    scene.reference_pressure = ambient;
    scene.gap.contact = GapScene::Contact::dry;
    scene.contact.thickness = thickness;
    scene.max_step = 2e-3;
    BodyScene box = body("block", BodyScene::ShapeKind::box,
                         dimension == 2 ? Triple{2.013, 0.25 + thickness, 0} : Triple{1.513, 1.49, 0.25 + thickness});
    box.size = dimension == 2 ? Triple{1, 0.5, 0} : Triple{1, 1, 0.5};
    box.density.reset();
    box.mass = 1;
    box.inertia = dimension == 2 ? std::vector<double>{0.1} : std::vector<double>{0.1, 0.1, 0.1};
    box.force[dimension - 1] = pull;
    scene.bodies = {box};
    return scene;
}

inline GapState gap_of(const std::vector<GapState>& gaps)
{
    EXPECT_EQ(gaps.size(), 1u);
    return gaps.empty() ? GapState{} : gaps[0];
}

/// Of a scene whose first body is pulled up: by how much its kinetic energy, less the work of the pull and of the ambient pressure on the voids, exceeds that of the
/// start at most until a time, over the largest energy.
inline double largest_gain(const Scene& scene, double until)
{
    Simulation<2> simulation(scene, Communicator());
    const double pull = scene.bodies[0].force[1], start = simulation.bodies()[0].pose.position[1],
                 void_at_start = gap_of(simulation.gaps()).void_volume;
    double largest = 0, excess = 0;
    while (simulation.time() < until) {
        const StepReport report = simulation.step(1);
        const double work = pull * (simulation.bodies()[0].pose.position[1] - start) -
                            ambient * (gap_of(simulation.gaps()).void_volume - void_at_start),
                     energy = report.energy_fluid + report.energy_bodies;
        largest = std::max(largest, energy);
        excess = std::max(excess, energy - work);
    }
    return excess / largest;
}

} // namespace gapflow
