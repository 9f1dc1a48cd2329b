// What a run carries from step to step, exactly what a checkpoint stores. All else follows from it: fractions, films, the coupled system
// (Model::coupled), velocities extrapolated into solids and films, what films remember (reconstruction).
#pragma once

#include "gapflow/core/state_archive.hpp"
#include "gapflow/stepping/contact_set.hpp"
#include "gapflow/stepping/model.hpp"
#include "gapflow/stepping/past_pressure.hpp"
#include "gapflow/stepping/void_set.hpp"

#include <set>
#include <vector>

namespace gapflow {

/// What the last pressure did to fluid, films and bodies, as far as the next step counts with it.
template <int D>
struct PressureHistory {
    UnknownVector<D> impulse;    ///< p of the last projection: bulk and mixed cells, film nodes
    bool lasts = false;          ///< whether it goes on: not before the first step, nor after one in which something met
    PastPressure<D> bulk;        ///< viscous: what the next viscous step starts from. Else unused: `impulse` tells
    std::vector<Twist<D>> force; ///< viscous: of the projection on every body: pressure, films, contacts
    /// Acceleration of the films' elements, flat ones in 2D without viscosity, at the end of the last step; none: empty.
    std::vector<Vec<D>> film;
    std::vector<Vec<D>> film_mean; ///< its mean over the last step, of the flat films' elements

    /// After an impact: the pressure that stopped the bodies does not go on. `impulse` stays, for reports.
    void forget();
};

template <int D>
struct State {
    double time = 0;
    double dt = 0; ///< length of the last step; 0 at the start
    long steps = 0;
    std::vector<RigidBody<D>> bodies;
    std::vector<Twist<D>> acceleration; ///< of all solids, over the last step, as far as it goes on
    std::vector<Twist<D>> wrenches;     ///< fluid force and torque on every body, mean over the last step
    FluidVelocity<D> velocity;          ///< divergence-free on open faces, extrapolated into solids
    PressureHistory<D> pressure;
    ContactSet<D> contacts; ///< of the last step
    VoidSet<D> voids;
    Eigen::VectorXd node_outflow;       ///< L p + K V + D u* of the film nodes, where voids had to be found; else empty
    std::set<FilmPair<D>> films_before; ///< pairs that had films before the last step
    std::set<FilmPair<D>> turned;       ///< pairs whose films turned in the last step
    bool light_bodies = true;           ///< whether the next solver asks if bodies are so light that they need correction

    /// At the scene's start, fluid at rest.
    explicit State(const Model<D>& model);
};

/// Whether a contact or a film that turned changed the solid's motion in the last step at once: then the change is no acceleration that goes on.
template <int D>
bool met_something(const State<D>& state, int solid);

/// One list for storing and restoring. Throws StateError as StateArchive does. Collective.
template <int D>
void list_state(StateArchive& archive, const Model<D>& model, State<D>& state);

} // namespace gapflow
