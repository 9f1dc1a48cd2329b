// The state between two steps, exactly the content of a checkpoint. Everything else follows from it: fractions, films, the
// coupled system (Model::coupled), extrapolated velocities and the films' history (reconstruction).
#pragma once

#include "gapflow/core/state_archive.hpp"
#include "gapflow/film/film_account.hpp"
#include "gapflow/stepping/contact_set.hpp"
#include "gapflow/stepping/model.hpp"
#include "gapflow/stepping/past_pressure.hpp"
#include "gapflow/stepping/void_set.hpp"

#include <map>
#include <set>
#include <vector>

namespace gapflow {

/// Effect of the last pressure on fluid, films and bodies, as used in the next step.
template <int D>
struct PressureHistory {
    UnknownVector<D> impulse; ///< p of the last projection: bulk and mixed cells, film nodes
    bool lasts = false;       ///< whether it is extrapolated: not before the first step, nor after a step with an impact
    /// Viscous: pressure from which the next viscous step starts. Without viscosity: after an impact that of the last step without one,
    /// else unused: the pressure follows from `impulse`.
    PastPressure<D> bulk;
    std::vector<Twist<D>> force; ///< viscous: of the projection on every body: pressure, films, contacts
    /// Acceleration of the films' elements, flat ones in 2D without viscosity, at the end of the last step; none: empty.
    std::vector<Vec<D>> film;
    std::vector<Vec<D>> film_mean; ///< its mean over the last step, of the flat films' elements

    /// After an impact: the pressure that stopped the bodies is not extrapolated, but `bulk`, the one from before it. `impulse` stays, for reports.
    void forget();
};

/// Mean pressure gradient of a driven periodic box (method, "Driven periodic boxes").
template <int D>
struct Drive {
    Vec<D> gradient = Vec<D>::Zero(); ///< of the reduced pressure, in the last step
    Vec<D> flow = Vec<D>::Zero();     ///< mean velocity of fluid and solids before that step
};

/// How the gap of a pair changes in a step.
struct GapChange {
    double share = 0;  ///< of the bodies' relative velocity that drag takes
    double change = 0; ///< of the gap, over the part that time.gap_cfl allows
};

/// The same of all pairs for whose drag it matters (stepping/gap_limit).
template <int D>
struct GapWays {
    std::map<FilmPair<D>, GapChange> pairs;
    std::vector<Pose<D>> from; ///< of the bodies, before the step; empty without such pairs
};

/// What a run remembers to tell that its flow has settled (stepping/steadiness).
struct SteadyWatch {
    double largest_speed = 0; ///< root mean square of the fluid's velocity, the largest so far
    double lagging_rate = 0;  ///< relative rate of change of the flow, mean over about the last tenth of the time so far
    long calm_steps = 0;      ///< in a row, the last ones, whose unsteadiness was below time.until_steady
    double calm_time = 0;     ///< that they took
};

/// What the momentum of the fluid on parts has beside the gradient of a potential (step theory, "Circulation"). Empty: nothing, the flow has no circulation.
template <int D>
struct Remainder {
    FaceField<D> faces; ///< velocity along their axes, of all faces of the grid, in solids too
    std::vector<double>
        edges; ///< of Placed::edges, from `faces`: its integral along each, from the rows with positive weights to the others

    bool empty() const { return faces[0].size() == 0; }
};

template <int D>
struct State {
    double time = 0;
    double dt = 0; ///< length of the last step; 0 at the start
    long steps = 0;
    std::vector<RigidBody<D>> bodies;
    std::vector<Twist<D>> acceleration; ///< of all solids, over the last step: the part to extrapolate
    std::vector<Twist<D>> wrenches;     ///< fluid force and torque on every body, mean over the last step
    FluidVelocity<D> velocity;          ///< divergence-free on open faces, extrapolated into solids
    PressureHistory<D> pressure;
    ContactSet<D> contacts; ///< of the last step
    VoidSet<D> voids;
    Eigen::VectorXd node_outflow;       ///< L p + K V + D u* of the film nodes, where voids had to be found; else empty
    std::set<FilmPair<D>> films_before; ///< pairs that had films before the last step
    std::set<FilmPair<D>> turned;       ///< pairs whose films were reversed in the last step
    GapWays<D> gap_ways;                ///< of the last step
    std::vector<double> conductance;    ///< of the films' mouths in the last step, heads included; empty: their own
    FilmDebts<D> film_debts;            ///< energy that films gained in the last step: the next one takes it back
    std::vector<Vec<D>> film_increment; ///< acceleration of the films' elements in the last step, pressure and transport
    UnknownVector<D> potential;         ///< times density, of the flow on parts (step/); films: none
    Remainder<D> remainder;             ///< of the same
    Drive<D> drive;
    SteadyWatch steady;
    Vec<D> grid_shift = Vec<D>::Zero();    ///< of a grid that follows a body, from its place at the scene's start
    Vec<D> grid_velocity = Vec<D>::Zero(); ///< of the same, in the last step
    std::set<int> removed;                 ///< bodies that left the domain and were taken out: held far outside
    bool forces_settle = true;             ///< on parts: whether the last step found those of its end (step/advance)
    bool light_bodies = true; ///< whether the next solver estimates if bodies are light enough to need a correction
    double viscous_step = 0;  ///< longest next step, once one was too long for its viscosity (stepping/viscous_lag); 0: any

    /// At the scene's start, fluid at rest.
    explicit State(const Model<D>& model);
};

/// Whether a film of the solid was reversed in the last step.
template <int D>
bool was_reversed(const State<D>& state, int solid);

/// Whether a contact or the reversal of a film changed the solid's velocity in the last step abruptly: then the change is not
/// an acceleration to extrapolate.
template <int D>
bool met_something(const State<D>& state, int solid);

/// One list for storing and restoring. Throws StateError as StateArchive does. Collective.
template <int D>
void list_state(StateArchive& archive, const Model<D>& model, State<D>& state);

} // namespace gapflow
