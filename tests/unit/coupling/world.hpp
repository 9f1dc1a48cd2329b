// A scene's configuration, coupled, without a simulation around it.
#pragma once

#include "gapflow/stepping/model.hpp"

#include <vector>

namespace gapflow {

template <int D>
struct World {
    /// `moving`: films as in time steps, else as for added mass.
    explicit World(const Scene& s, bool moving = false)
        : model(s, Communicator(), moving ? Task::motion : Task::added_mass), mass(model.masses(model.bodies, 0)),
          coupling(model.coupled(model.bodies, mass))
    {
    }
    Model<D> model;
    const Scene& scene = model.scene;
    const Grid<D>& grid = model.grid;
    const std::vector<RigidBody<D>>& bodies = model.bodies;
    const DomainWalls<D>& walls = model.walls;
    std::vector<TwistMatrix<D>> mass;
    Coupling<D> coupling;
};

} // namespace gapflow
