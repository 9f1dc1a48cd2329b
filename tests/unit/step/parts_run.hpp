// A run of start_on_parts() and advance(), from a velocity of the fluid.
#pragma once

#include "gapflow/step/advance.hpp"
#include "gapflow/step/start.hpp"
#include "gapflow/stepping/motion.hpp"

#include <functional>

namespace gapflow {

template <int D>
using Velocity = std::function<Vec<D>(const Vec<D>&)>;

template <int D>
FaceField<D> on_faces(const Grid<D>& grid, const Velocity<D>& velocity)
{
    FaceField<D> u(grid);
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(grid.low(), owned_faces_end(grid, axis),
                          [&](const Index<D>& f) { u(axis, f) = velocity(grid.face_centre(axis, f))[axis]; });
    return u;
}

template <int D>
struct PartsRun {
    Model<D> model;
    State<D> state;
    StageTimers timers;
    StepReport report;
    Instant<D> now;

    explicit PartsRun(const Scene& scene, const Velocity<D>& velocity = nullptr)
        : model(scene, Communicator(), Task::motion), state(model)
    {
        const FaceField<D> start = velocity ? on_faces<D>(model.grid, velocity) : FaceField<D>();
        now = start_on_parts(model, state, report, timers, velocity ? &start : nullptr);
    }
    void step(double dt)
    {
        now = advance(model, now, Step{state.steps + 1, state.time, dt, state.dt, state.time + dt}, state, report, timers);
    }
    double energy() const
    {
        double sum = now.energy;
        for (const RigidBody<D>& body : state.bodies)
            sum += kinetic_energy(body);
        return sum;
    }
};

} // namespace gapflow
