// Scenes of the tests of the step on parts, and the comparison of stored states.
#pragma once

#include "gapflow/scene/scene.hpp"
#include "gapflow/step/simulation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>
#include <string>

namespace gapflow {

/// The unit square or cube of fluid, all sides of one kind.
inline Scene box_of_fluid(int dimension, int cells, SideScene::Kind sides)
{
    Scene scene;
    scene.dimension = dimension;
    scene.size = {1, 1, dimension == 2 ? 0.0 : 1.0};
    scene.cells = {cells, cells, dimension == 2 ? 1 : cells};
    for (int side = 0; side < 2 * dimension; ++side)
        scene.sides[side].kind = sides;
    scene.parts = true;
    scene.end = 100;
    scene.max_step = 1;
    return scene;
}

/// A neutral body.
inline BodyScene body(const std::string& name, BodyScene::ShapeKind shape, const Triple& position, const Triple& velocity = {})
{
    BodyScene b;
    b.name = name;
    b.shape = shape;
    b.position = position;
    b.density = 1;
    b.radius = 0.1;
    b.velocity = velocity;
    return b;
}

/// Two plates; from (x, y) the middle of their gap, in cells.
inline Scene two_plates(double x, double y, double gap, double degrees)
{
    Scene scene = box_of_fluid(2, 32, SideScene::Kind::wall);
    scene.gap.roughness = 0;
    const double dx = scene.spacing(), a = degrees * std::numbers::pi / 180;
    for (const double side : {-1.0, 1.0}) {
        const double up = side * (1.5 + 0.5 * gap);
        BodyScene plate = body(side < 0 ? "lower" : "upper", BodyScene::ShapeKind::box,
                               {dx * (x - up * std::sin(a)), dx * (y + up * std::cos(a)), 0});
        plate.size = {12 * dx, 3 * dx, 0};
        plate.angle = a;
        scene.bodies.push_back(plate);
    }
    return scene;
}

/// Three steps, then three more from there and from the state stored there: the same bits.
template <int D>
void expect_to_go_on(const Scene& scene)
{
    Simulation<D> all(scene, Communicator());
    for (int k = 0; k < 3; ++k)
        all.step(100);
    const StoredState stored = all.state();
    Simulation<D> on(scene, Communicator(), stored);
    for (int k = 0; k < 3; ++k) {
        all.step(100);
        on.step(100);
    }
    const StoredState a = all.state(), b = on.state();
    ASSERT_EQ(a.numbers.size(), b.numbers.size());
    for (const auto& [name, values] : a.numbers) {
        const auto& other = b.numbers.at(name);
        ASSERT_EQ(values.size(), other.size()) << name;
        EXPECT_EQ(std::memcmp(values.data(), other.data(), values.size() * sizeof values[0]), 0) << name;
    }
}

} // namespace gapflow
