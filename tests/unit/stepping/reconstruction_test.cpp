// What a film leaves behind in the grid when it ends.
#include "gapflow/stepping/reconstruction.hpp"

#include "gapflow/stepping/start.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gapflow {
namespace {

// A fixed box at x, its lowest point a gap above the floor.
Scene box_above_floor(double x, double gap, double angle)
{
    Scene scene;
    scene.size = {2, 2, 0};
    scene.cells = {20, 20, 1};
    BodyScene box;
    box.name = "box";
    box.shape = BodyScene::ShapeKind::box;
    box.motion = BodyScene::Motion::fixed;
    box.size = {0.6, 0.5, 0};
    box.angle = angle;
    box.position = {x, gap + 0.5 * (box.size[0] * std::sin(angle) + box.size[1] * std::cos(angle)), 0};
    scene.bodies = {box};
    return scene;
}

// A corner 1e-4 cells over the floor, and a film in the wedge beside it, all of one flux. The corner lies anywhere in its cell, so faces
// that the film leaves may be open a hundred times as wide as the film is thick. No face gets more than the film's flux.
TEST(Reconstruction, AFaceTakesNoMoreThanTheFlux)
{
    const double dx = 0.1, flux = 1e-3;
    int faces = 0;
    for (double angle : {5.0, 20.0, 30.0, 40.0, 45.0})
        for (int k = 0; k < 10; ++k) {
            const Model<2> model(box_above_floor(1 + 0.1 * k * dx, 1e-4 * dx, angle / 180 * std::numbers::pi), Communicator());
            State<2> state(model);
            StepReport report;
            StageTimers timers;
            const Start<2> at = start(model, state, report, timers);
            state.velocity.film.clear();
            for (const Film<2>& film : at.here.network.films)
                for (const FilmElement<2>& e : film.mesh.elements)
                    state.velocity.film.emplace_back(flux / (e.volume / e.measure) * Vec<2>(-e.normal[1], e.normal[0]));
            const Reconstruction<2> beyond = reconstruct(model, at.here, state, at.twists);
            for (int axis = 0; axis < 2; ++axis)
                for_each_index<2>(model.grid.low(), owned_faces_end(model.grid, axis), [&](const Index<2>& f) {
                    if (!beyond.film_faces(axis, f))
                        return;
                    ++faces;
                    EXPECT_LT(std::abs(beyond.painted(axis, f)) * at.here.fractions->open(axis, f) * dx, 1.01 * flux)
                        << "axis " << axis << ", face " << f.transpose() << ", angle " << angle << ", place " << k;
                });
        }
    EXPECT_GT(faces, 500);
}

// Fluid that leaves a film is no faster than in it. Behind a fast face beside a mouth, and beyond a slow one, linear extrapolation finds 2; in a pore of two
// cells between four balls the flow out of films fed itself so.
TEST(Reconstruction, WhatMouthsBringIsNoGradient)
{
    const double dx = 0.1;
    int faces = 0;
    for (double gap : {0.2, 0.6, 0.9})
        for (double place : {0.0, 0.3, 0.7}) {
            const Model<2> model(box_above_floor(1 + place * dx, gap * dx, 0), Communicator());
            const Grid<2>& grid = model.grid;
            State<2> state(model);
            StepReport report;
            StageTimers timers;
            const Start<2> at = start(model, state, report, timers);
            for (const Mouth<2>& mouth : at.here.network.rim.mouths)
                for (const auto& [key, weight] : mouth.cells)
                    for (const int end : {0, 1}) {
                        const Index<2> cell = grid.cell_of_key(key), closed = cell + end * step<2>(0),
                                       fast = cell + (1 - end) * step<2>(0);
                        if (at.here.open(0, closed) > 0 || at.here.open(0, fast) < 0.5)
                            continue;
                        state.velocity = {FaceField<2>(grid), std::vector<Vec<2>>(at.here.network.elements, Vec<2>::Zero()),
                                          std::vector<double>(at.here.network.elements, 0.0),
                                          std::vector<double>(at.here.network.rim.mouths.size(), 1e-3)};
                        state.velocity.grid(0, fast) = 1;
                        reconstruct(model, at.here, state, at.twists);
                        EXPECT_LT(std::abs(state.velocity.grid(0, closed)), 1 + 1e-12) << "face " << closed.transpose();
                        ++faces;
                    }
        }
    EXPECT_GT(faces, 10);
}

} // namespace
} // namespace gapflow
