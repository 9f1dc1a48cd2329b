// A scene with its films and rows built, without a simulation around it.
#pragma once

#include "gapflow/stepping/setup.hpp"

#include <vector>

namespace gapflow {

template <int D>
struct CoupledSceneOf {
    explicit CoupledSceneOf(const Scene& of)
        : scene(of), grid(make_grid<D>(scene, Communicator())), bodies(make_bodies<D>(scene)), walls(make_walls<D>(scene))
    {
        const auto solids = make_solids<D>(bodies, walls);
        const std::vector<TwistMatrix<D>> mass(solids.size(), TwistMatrix<D>::Identity());
        coupling =
            couple<D>(grid, solids, mass, {scene.density, FractionMode::cut_cell}, gap_settings<D>(scene, solids, true), {});
        rest.assign(solids.size(), Twist<D>::Zero());
    }
    const Film<D>& film() const { return coupling.network.films.front(); }

    Scene scene;
    Grid<D> grid;
    std::vector<RigidBody<D>> bodies;
    DomainWalls<D> walls;
    Coupling<D> coupling;
    std::vector<Twist<D>> rest; ///< of all solids
};
using CoupledScene = CoupledSceneOf<2>;

} // namespace gapflow
