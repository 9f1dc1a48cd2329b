// The flow at a step's end with voids in gaps (theory of the step, "Voids"). Of each part that can hold one, with the void's volume v and the outflow
// r = L p + K V of the part,
//
//     0 <= p - b  |  v / dt + r >= 0,      b = p_before + dt (least pressure + rho/2 u^2),      v' = v + dt r.
//
// Parts at b are data: the others' system is solved until both conditions hold everywhere. Fluid runs into the gap of a void as through an orifice: of the potential's
// drop along an edge into it dt rho/2 u^2 is lost.
#pragma once

#include "gapflow/step/instant.hpp"
#include "gapflow/step/matching.hpp"
#include "gapflow/step/viscosity.hpp"
#include "gapflow/stepping/observation.hpp"
#include "gapflow/stepping/unilateral.hpp"

#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace gapflow {

template <int D>
class VoidSolve {
public:
    /// `there`: at the step's end. Keeps references.
    VoidSolve(const Model<D>& model, const Instant<D>& old, Placed<D>& there, double dt);

    /// Solves for twists and potential with a system and with what voids add to the outflow of its rows and to the impulses of the solids; no rows: nothing.
    using Solve = std::function<Projected<D>(Coupling<D>&, const UnknownVector<D>&, const std::vector<Twist<D>>&)>;
    /// Becomes `flow`. `last`: the flow of the pass before; null: none.
    Projected<D> find(const Solve& solve, const PotentialFlow<D>* last, PotentialFlow<D>& flow);
    /// With viscosity find() leaves the voids' pressures to this: from the ideal flow, and in rounds from `beside()` what viscosity asks for, `take()` what it gives, where
    /// bodies meet `meet()`, and `turn()`: whether other parts are voids at the end.
    void begin_viscosity(const PotentialFlow<D>& ideal);
    ViscousVoids<D> beside() const;
    void take(const ViscousVoids<D>& voids) { momentum_ = voids.momentum; }
    Projected<D> meet(const Solve& solve, Instant<D>& now);
    bool turn(const PotentialFlow<D>& flow, int round);
    /// Whether there is a void at the step's start or end.
    bool any() const;
    /// Whether the conditions held within the most rounds of the last find().
    bool settled() const { return settled_; }
    /// Net outflow of all rows but what their voids and the edges of these take: what the solver's tolerance leaves.
    UnknownVector<D> left_outflow(const Instant<D>& now) const;
    /// Pressure impulses of the parts that can be voids.
    void give_pressure(const PotentialFlow<D>& flow, UnknownVector<D>& impulse) const;
    /// Volumes of the step's end, and the potentials with which the next step goes on. `now`: with the flow that was found, `there` its places.
    void finish(const std::vector<RigidBody<D>>& bodies, const std::vector<TwistMatrix<D>>& mass, Instant<D>& now);

private:
    struct System {
        Coupling<D> coupling;
        UnknownVector<D> outflow;
        std::vector<Twist<D>> impulse;
    };
    System reduced() const;
    void find_offsets(const std::vector<std::int32_t>& was);
    void find_bounds(const PotentialFlow<D>* last);
    void find_heads(const UnknownVector<D>& p);
    bool ways_turn(const UnknownVector<D>& p);
    double content(std::size_t edge) const;
    bool leads_to_fluid(std::size_t edge) const;
    bool update(const PotentialFlow<D>& flow, bool at_once);
    /// Of the voids. `over_the_step`: of those that were voids before over the walls' way; else at the step's end.
    std::vector<double> outflows(const PotentialFlow<D>& flow, bool over_the_step) const;
    struct Drop {
        double sum;
        bool from_fluid; ///< not between voids alone
    };
    Drop drop(std::size_t edge, const UnknownVector<D>& p, bool at_bounds) const;
    double flux(std::size_t edge, const UnknownVector<D>& p) const;
    std::vector<double> drops(const UnknownVector<D>& p) const;
    double value(const UnknownVector<D>& p, long row) const;
    void put(UnknownVector<D>& p) const;
    int number(long row) const;
    void find_streams(const std::vector<double>& momentum);
    UnknownVector<D> rest_of(const PotentialFlow<D>& flow) const;
    bool passes_on(int part) const;
    void pass_on(std::vector<double>& volume, std::vector<double>& out, std::vector<double>& flux, double& lost) const;
    double weight_in(std::size_t edge, std::size_t part) const;
    double least_volume(std::size_t part) const;

    const Model<D>& model_;
    const Instant<D>& old_;
    Placed<D>& there_;
    double dt_;
    bool settled_ = true;
    long cells_;
    UnknownVector<D> past_all_;                 ///< the potential before the step at the rows of its end
    std::vector<double> past_, square_, bound_; ///< of each part: potential and square of the velocity before, b
    std::vector<double> fluid_;                 ///< of each part: volume of fluid in it, where it was a void
    std::vector<char> known_, was_void_, given_;
    std::vector<int> turns_;     ///< of each edge in the pass
    std::vector<double> offset_; ///< of each edge: what its drop is more than that of the potentials before the step
    std::vector<double> head_;   ///< of each edge: the share of its conductance that is left
    std::vector<double> spent_;  ///< of each edge: the flux that is left of fluid in its voids where they give more, else 0
    std::vector<double> start_, momentum_; ///< of each edge as viscosity begins, and at the step's end; empty without
    std::vector<double> ideal_;            ///< of each part: potential as viscosity begins
    std::vector<std::pair<long, int>> at_; ///< rows and numbers of the parts, by rows
    std::vector<std::vector<std::pair<int, Twist<D>>>> walls_; ///< K of each part
    std::vector<std::vector<std::size_t>> edges_of_;           ///< of each part
};

/// Other voids at the end of a step: their volumes, and the potential flow with the fluxes `flux` of the edges that there were and what the rows of those that are
/// gone take up, `filled`: nearest in energy to the flow there, whose potentials differ where it comes from several sides. Collective.
template <int D>
void change_voids(const Model<D>& model, const std::vector<RigidBody<D>>& bodies, const std::vector<TwistMatrix<D>>& mass,
                  std::vector<double> volume, const std::vector<double>& flux, const std::map<long, double>& filled,
                  Instant<D>& now);

/// The same in viscous fluid, with the momenta of the edges that there were: each edge keeps its own, in voids or in the remainder.
template <int D>
void change_viscous_voids(const Model<D>& model, const std::vector<RigidBody<D>>& bodies,
                          const std::vector<TwistMatrix<D>>& mass, std::vector<double> volume,
                          const std::vector<double>& momentum, Instant<D>& now);

/// Voids whose place is gone when the bodies have moved, by their sites: filled before. Collective.
template <int D>
void fill_lost(const Model<D>& model, const std::vector<RigidBody<D>>& bodies, const std::vector<TwistMatrix<D>>& mass,
               const std::vector<std::int32_t>& lost, Instant<D>& old);

/// Mean over the axes' faces of the square of the velocity in each part. `drop`: of the potential along the edges of voids.
template <int D>
std::vector<double> squares_of_speed(const Placed<D>& at, const PotentialFlow<D>& flow, const std::vector<double>& drop);

/// The largest speed of fluid in the gaps that can hold voids; 0 where there is none.
template <int D>
double speed_beside_voids(const Instant<D>& now);

/// The flow of given twists and a given outflow in a system. `levels`: potentials whose means stay where nothing gives a level; null: any level.
/// Throws ComputationError.
template <int D>
PotentialFlow<D> flow_with_outflow(const Complex<D>& complex, Coupling<D> coupling, std::vector<Twist<D>> twists,
                                   UnknownVector<D> outflow, const SolverOptions& options, const UnknownVector<D>* levels);

/// The flow of given twists beside the voids of a placed complex, at whose rows p is 0. Collective.
template <int D>
PotentialFlow<D> flow_beside_voids(const Placed<D>& at, std::vector<Twist<D>> twists, const SolverOptions& options,
                                   Remainder<D> remainder = {}, const GivenSides<D>& sides = {});

/// Adds the parts of gaps to the pairs' states: voids, and the least and largest pressures of the last step.
template <int D>
void add_void_states(const Model<D>& model, const Placed<D>& at, const State<D>& state, const PartVoids& voids,
                     std::vector<GapState>& gaps);

} // namespace gapflow
