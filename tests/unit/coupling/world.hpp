// A scene's configuration, coupled, without a simulation around it.
#pragma once

#include "gapflow/stepping/setup.hpp"

#include <vector>

namespace gapflow {

template <int D>
struct World {
    /// `moving`: films as in time steps, else as for added mass.
    explicit World(const Scene& s, bool moving = false)
        : scene(s), grid(make_grid<D>(scene, Communicator())), bodies(make_bodies<D>(scene)), walls(make_walls<D>(scene))
    {
        const auto solids = make_solids<D>(bodies, walls);
        for (const RigidBody<D>& b : bodies)
            mass.push_back(mass_matrix(b));
        mass.resize(solids.size(), TwistMatrix<D>::Identity());
        coupling =
            couple<D>(grid, solids, mass, {scene.density, FractionMode::cut_cell}, gap_settings<D>(scene, solids, moving), {});
    }
    Scene scene;
    Grid<D> grid;
    std::vector<RigidBody<D>> bodies;
    DomainWalls<D> walls;
    std::vector<TwistMatrix<D>> mass;
    Coupling<D> coupling;
};

} // namespace gapflow
