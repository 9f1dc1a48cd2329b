// Constant data of a scene: grid, shapes, walls and laws (method, "The time step"). Runs, added mass, checks, benchmarks and
// tests all build the coupled system from it.
#pragma once

#include "gapflow/core/timer.hpp"
#include "gapflow/stepping/setup.hpp"
#include "gapflow/stepping/velocity_ghosts.hpp"

#include <functional>
#include <optional>
#include <set>
#include <vector>

namespace gapflow {

/// What a model serves: in time steps viscosity widens films, and films last (gap_settings()).
enum class Task { motion, added_mass };

template <int D>
struct Model {
    /// Throws InputError for a scene that cannot be computed: mesh files, memory. Collective.
    Model(const Scene& scene, const Communicator& comm, Task task = Task::motion);
    Model(const Model&) = delete; // laws and solids hold references to its members
    Model& operator=(const Model&) = delete;

    const Scene scene;
    Grid<D> grid;                           ///< moves with a body (domain.follow), else as the scene places it
    Vec<D> grid_velocity = Vec<D>::Zero();  ///< displacement of the grid in the last step over its length
    const std::vector<RigidBody<D>> bodies; ///< as the scene places them
    const DomainWalls<D> walls;
    const std::function<GapSettings(int, int)> gaps;
    const std::function<MouthLaw(int, int)> mouths;

    bool viscous() const { return scene.viscosity > 0; }
    Vec<D> gravity() const { return to_vec<D>(scene.gravity); }
    /// Mean velocity of fluid and solids that is kept along a periodic axis: fluid.mean_velocity, or that of the start where bodies are
    /// heavier or lighter than the fluid along gravity, as in a tall tank. None: it follows from the forces.
    std::optional<double> kept_velocity(int axis) const;
    /// Whether a mean pressure gradient drives the fluid along some axis.
    bool driven() const;
    /// Bodies first, walls after them. Refers to the shapes of both.
    std::vector<Solid<D>> solids(const std::vector<RigidBody<D>>& at) const { return make_solids<D>(at, walls); }
    /// Twists of all solids.
    std::vector<Twist<D>> twists(const std::vector<RigidBody<D>>& of) const;
    /// Generalised masses of all solids in a step of length dt; springs and floats' buoyancy act as inertia too.
    std::vector<TwistMatrix<D>> masses(const std::vector<RigidBody<D>>& of, double dt) const;
    /// Velocities of walls and inflow at a time, and of the grid.
    BoundaryVelocity<D> sides(double time) const;
    /// rho g . (x - x0), full minus reduced pressure; x0 is the highest point of the open, far and surface sides, where the reference pressure
    /// acts, or without any that of the first pressure side, where its pressure at time 0 acts.
    double hydrostatic(const Vec<D>& x) const;
    /// Reduced pressure beyond every side at a time: 0 but for pressure sides.
    std::array<double, 2 * D> pressure_beyond(double time) const;

    /// The coupled system of bodies at a place. `mass`: as masses() gives it, none: unit masses; the others as in couple(). Collective.
    Coupling<D> coupled(const std::vector<RigidBody<D>>& at, std::vector<TwistMatrix<D>> mass = {}, double viscosity_dt = 0,
                        const std::set<FilmPair<D>>& alive = {}, const std::function<DragTerms(const Coupling<D>&)>& drag = {},
                        StageTimers* timers = nullptr, const FaceFractions<D>* before = nullptr) const;

private:
    double height(int side) const;
};

} // namespace gapflow
