// Objects of a computation built from a scene: grid, bodies, domain walls, gap settings.
#pragma once

#include "gapflow/body/rigid_body.hpp"
#include "gapflow/core/machine_memory.hpp"
#include "gapflow/coupling/coupling.hpp"
#include "gapflow/film/film_momentum.hpp"
#include "gapflow/scene/body_shape.hpp"
#include "gapflow/scene/scene.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace gapflow {

/// Throws InputError where the scene's grid needs more memory than the machines of the ranks have: before anything is allocated,
/// with the number. `available`: bytes on this rank's machine. Collective.
void require_memory(const Scene& scene, const Communicator& comm, double available = machine_memory());

/// Throws InputError as require_memory().
template <int D>
Grid<D> make_grid(const Scene& scene, const Communicator& comm);

/// Throws InputError for mesh files that cannot be read or are not closed.
template <int D>
std::vector<RigidBody<D>> make_bodies(const Scene& scene);

/// Closed sides of the domain as half-spaces, with the shapes that they point to.
template <int D>
struct DomainWalls {
    std::vector<std::unique_ptr<Shape<D>>> shapes;
    std::vector<Solid<D>> solids;
    std::vector<Twist<D>> twists; ///< of sliding walls
};
template <int D>
DomainWalls<D> make_walls(const Scene& scene);

/// Bodies first, walls after them. The shapes belong to `bodies` and `walls`.
template <int D>
std::vector<Solid<D>> make_solids(const std::vector<RigidBody<D>>& bodies, const DomainWalls<D>& walls);

/// Gap settings of every pair, by solid numbers. `moving`: for time steps (viscosity widens films between curved bodies; dry pairs
/// have a skin, so that they are impermeable in contact; added mass does not account for voids).
template <int D>
std::function<GapSettings(int, int)> gap_settings(const Scene& scene, const std::vector<Solid<D>>& solids, bool moving);

template <int D>
std::function<MouthLaw(int, int)> mouth_laws(const Scene& scene, const std::vector<Solid<D>>& solids);

FractionMode fraction_mode(const Scene& scene);

} // namespace gapflow
