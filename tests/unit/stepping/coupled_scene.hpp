// A 2D scene with its films and rows built, without a simulation around it.
#pragma once

#include "gapflow/stepping/setup.hpp"

#include <vector>

namespace gapflow {

struct CoupledScene {
    explicit CoupledScene(const Scene& of)
        : scene(of), grid(make_grid<2>(scene, Communicator())), bodies(make_bodies<2>(scene)), walls(make_walls<2>(scene))
    {
        const auto solids = make_solids<2>(bodies, walls);
        const std::vector<TwistMatrix<2>> mass(solids.size(), TwistMatrix<2>::Identity());
        coupling =
            couple<2>(grid, solids, mass, {scene.density, FractionMode::cut_cell}, gap_settings<2>(scene, solids, true), {});
        rest.assign(solids.size(), Twist<2>::Zero());
    }
    const Film<2>& film() const { return coupling.network.films.front(); }

    Scene scene;
    Grid<2> grid;
    std::vector<RigidBody<2>> bodies;
    DomainWalls<2> walls;
    Coupling<2> coupling;
    std::vector<Twist<2>> rest; ///< of all solids
};

} // namespace gapflow
