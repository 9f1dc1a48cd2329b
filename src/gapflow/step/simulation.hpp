// A scene in time (method, "The time step"): Simulation<D>::step() is one time step, a list of the method's stages.
#pragma once

#include "gapflow/core/communicator.hpp"
#include "gapflow/core/timer.hpp"
#include "gapflow/step/instant.hpp"
#include "gapflow/stepping/core_check.hpp"
#include "gapflow/stepping/force_parts.hpp"
#include "gapflow/stepping/gap_meshes.hpp"
#include "gapflow/stepping/leaving.hpp"
#include "gapflow/stepping/observation.hpp"
#include "gapflow/stepping/reconstruction.hpp"
#include "gapflow/stepping/sampling.hpp"
#include "gapflow/stepping/volume_flux.hpp"

#include <functional>
#include <optional>
#include <set>
#include <span>
#include <vector>

namespace gapflow {

template <int D>
class Simulation {
public:
    /// Builds the state at time 0 and projects the fluid's initial velocity. Throws InputError, ComputationError. Collective.
    Simulation(const Scene& scene, const Communicator& comm);
    /// The same of a run on parts whose fluid has a velocity of its own at the start, given at points of the domain: what of it has no divergence between
    /// the bodies, in place of the scene's fluid.velocity. Throws also InputError if the scene is not one of parts. Collective.
    Simulation(const Scene& scene, const Communicator& comm, const std::function<Vec<D>(const Vec<D>&)>& velocity);
    /// The same with the velocity along each face's axis, on this rank's faces of the scene's grid, make_grid().
    Simulation(const Scene& scene, const Communicator& comm, const FaceField<D>& velocity);
    /// Continues from a state that state() returned, on any number of ranks: with the same bits on the same number of ranks and
    /// threads. Throws also StateError if the state is not of this scene's grid and bodies. Collective.
    Simulation(const Scene& scene, const Communicator& comm, const StoredState& state);
    ~Simulation(); // in the library: programs may be compiled for another processor, with which Eigen aligns otherwise

    /// Advances by one time step that does not pass `next_output`. Throws InputError if that is not later than the time, with the state as it
    /// was; after another exception there is no state. Collective.
    StepReport step(double next_output);

    /// As gapflow::set_force() and gapflow::set_velocity(), from the next step on.
    void set_force(int body, const Vec<D>& force, const Spin<D>& torque);
    void set_velocity(int body, const Vec<D>& velocity, const Spin<D>& angular_velocity);

    double time() const { return state_.time; }
    long steps() const { return state_.steps; }
    const Scene& scene() const { return model_.scene; }
    const Grid<D>& grid() const { return model_.grid; }
    const std::vector<RigidBody<D>>& bodies() const { return state_.bodies; }
    /// Of the last step; none after a step that threw.
    const Coupling<D>& coupling() const { return instant_ ? instant_->placed->coupling : *here_; }
    /// Fluid velocity: divergence-free on open faces, extrapolated into solids.
    const FluidVelocity<D>& velocity() const { return state_.velocity; }
    /// Reduced pressure (p - rho g.x), averaged over the last step: bulk and mixed cells, film nodes.
    UnknownVector<D> reduced_pressure() const;
    /// Full pressure minus reduced pressure at x.
    double hydrostatic(const Vec<D>& x) const;
    /// Fluid force and torque on every body about its centre of mass, averaged over the step, buoyancy included.
    const std::vector<Twist<D>>& fluid_wrenches() const { return state_.wrenches; }
    /// Parts of the forces in the last step, contact too; empty unless the scene asks for them (output.forces), and after restoring a state.
    const std::vector<ForceParts<D>>& force_parts() const { return force_parts_; }
    /// Whether a body has left the domain and was taken out (domain.leaving).
    bool removed(int body) const { return state_.removed.contains(body); }
    /// Bodies that lie wholly outside the domain, those that were taken out as well.
    std::vector<int> outside() const;
    /// Values at points of the domain, as sample_points(). Collective.
    std::vector<PointValues<D>> sample(std::span<const Vec<D>> points) const;
    /// As gapflow::volume_flux(). Collective.
    VolumeFlux volume_flux(const FluxScene& through) const;
    /// See gapflow::outside_core.
    std::optional<std::string> outside_core() const { return gapflow::outside_core(model_, coupling(), state_.bodies); }
    /// Whether the flow has settled as time.until_steady asks.
    bool settled() const;
    /// Whether a mean pressure gradient drives the fluid along periodic axes.
    bool driven() const;
    /// Pairs with a gap or a contact. Collective.
    std::vector<GapState> gaps() const;
    /// Films, or the gaps of the complex of parts. Collective.
    GapMeshes<D> gap_meshes() const;
    /// Voids in the films.
    const VoidSet<D>& voids() const { return state_.voids; }
    /// Whether gaps of the scene can have voids.
    bool voids_are_possible() const { return instant_ ? gapflow::voids_are_possible(model_.scene) : state_.voids.possible(); }
    /// Net outflow of this rank's cells, as gapflow::net_outflow(). Collective.
    CellField<D> outflow() const;
    Budget<D> budget() const;
    /// Report of the state at the start (step 0, or the stored state from which the simulation continues).
    const StepReport& initial_report() const { return initial_report_; }
    /// Everything on which the next step depends, apart from the scene. Collective.
    StoredState state() const;
    /// Of runs on parts, over the steps of this object: energy that the correction of the forces' work added, and the sum of its magnitudes, over the
    /// largest energy.
    struct Correction {
        double sum = 0, magnitude = 0;
    };
    Correction correction() const
    {
        return largest_energy_ > 0 ? Correction{corrected_.sum / largest_energy_, corrected_.magnitude / largest_energy_}
                                   : Correction{};
    }
    /// Time spent in each stage so far.
    const StageTimers& stages() const { return stages_; }

private:
    void begin(const FaceField<D>* velocity);
    enum class BulkViscosity { acts, is_left_out };
    void restore_configuration();
    void put_back(const State<D>& start);
    void rehearse(double next_output);
    void advance_followed(double next_output, StepReport& report);
    void advance(double next_output, BulkViscosity viscosity, StepReport& report);
    void advance_on_parts(double next_output, StepReport& report);
    void report(const std::vector<Twist<D>>& V, StepReport& report);
    void follow_departures(const std::vector<Whereabouts>& before, StepReport& report);

    Model<D> model_;
    State<D> state_;
    std::optional<Coupling<D>> here_;   ///< follows from the state, as `beyond_` does; of runs with films
    std::optional<Instant<D>> instant_; ///< the same of runs on parts
    PartVoids part_voids_;              ///< of the same: part of the state
    Reconstruction<D> beyond_;
    std::set<FilmPair<D>> blind_told_; ///< pairs whose films' blind ends have been reported
    ToldOfCrowds crowds_told_;
    std::vector<ForceParts<D>> force_parts_;
    StepReport initial_report_;
    StageTimers stages_;
    Correction corrected_; ///< not over the energy
    double largest_energy_ = 0;
};

} // namespace gapflow
