// A scene in time (method, "The time step"): Simulation<D>::step() is one time step, a list of the method's stages.
#pragma once

#include "gapflow/core/communicator.hpp"
#include "gapflow/core/state_archive.hpp"
#include "gapflow/core/timer.hpp"
#include "gapflow/coupling/coupling.hpp"
#include "gapflow/coupling/wet_system.hpp"
#include "gapflow/film/film_motion.hpp"
#include "gapflow/scene/scene.hpp"
#include "gapflow/solver/solver.hpp"
#include "gapflow/stepping/advection.hpp"
#include "gapflow/stepping/contact_set.hpp"
#include "gapflow/stepping/past_pressure.hpp"
#include "gapflow/stepping/sealing.hpp"
#include "gapflow/stepping/setup.hpp"
#include "gapflow/stepping/void_set.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gapflow {

/// What a step did, and the state's sums after it.
struct StepReport {
    long step = 0;
    double time = 0, dt = 0;
    long cells = 0; ///< unknowns of the grid
    int film_nodes = 0, iterations = 0;
    int viscous_iterations = 0;                        ///< of the bulk's viscous solve
    double residual = 0, divergence_max = 0;           ///< divergence: net outflow of a cell over its volume, 1/time
    double energy_fluid = 0, energy_bodies = 0;        ///< as in Budget
    double dissipation_grid = 0, dissipation_film = 0; ///< power that viscosity takes, in the bulk and in films
    double seconds = 0;
    std::vector<std::string> notes; ///< for the user, once each: thin bodies, contacts that do not settle, blind film ends
};

/// State of one pair of solids with a film.
struct GapState {
    std::string body_a, body_b; ///< in the scene's order, walls last
    double thickness = 0;       ///< smallest distance; negative: overlap
    double opening_rate = 0;    ///< at that place
    int film_nodes = 0;
    double film_area = 0, pressure_min = 0, pressure_max = 0;
    double force = 0; ///< on body_a, along the normal that pushes it away from body_b
    double contact_force = 0, contact_impulse = 0;
    double void_volume = 0;
};

/// Momentum and energy of fluid, films and bodies.
template <int D>
struct Budget {
    Vec<D> momentum = Vec<D>::Zero();           ///< fluid, films, conduits and free bodies
    Spin<D> angular_momentum = Spin<D>::Zero(); ///< the same, about the domain's origin
    double energy_grid = 0, energy_film = 0;
    double energy_bodies = 0; ///< kinetic energy of the free bodies and what their springs store
};

/// What the bulk's viscous step takes from the projection before it; unused without viscosity.
template <int D>
struct ViscousMemory {
    std::vector<Twist<D>> force;   ///< of the projection on every body: pressure, films, contacts
    std::vector<Twist<D>> impulse; ///< of the viscous traction on every solid, this step
    CellField<D> divergence;       ///< outflow of the cells after the viscous step
};

template <int D>
class Simulation {
public:
    /// Builds the state at time 0 and projects the fluid's initial velocity. Throws InputError, ComputationError. Collective.
    Simulation(const Scene& scene, const Communicator& comm);
    /// Goes on from what state() gave, on any number of ranks: bit for bit on the same number of ranks and threads. Throws also
    /// StateError if the state is not of this scene's grid and bodies. Collective.
    Simulation(const Scene& scene, const Communicator& comm, const StoredState& state);
    ~Simulation();

    /// Advances by one time step that does not pass `next_output`. Collective.
    StepReport step(double next_output);

    /// External force at the centre of mass and torque about it on a free body, world axes, from the next step on; in place of
    /// those of the scene. Throws InputError if the body is not free or a number not finite.
    void set_force(int body, const Vec<D>& force, const Spin<D>& torque);
    /// From now on a body of prescribed motion, from where it is, moves with this velocity of the centre of mass and turns with
    /// this angular velocity, world axes. Throws InputError as above.
    void set_velocity(int body, const Vec<D>& velocity, const Spin<D>& angular_velocity);

    double time() const { return time_; }
    long steps() const { return steps_; }
    const Scene& scene() const { return scene_; }
    const Grid<D>& grid() const { return grid_; }
    const std::vector<RigidBody<D>>& bodies() const { return bodies_; }
    /// Of the last step; none after a step that threw.
    const Coupling<D>& coupling() const { return *coupling_; }
    /// Fluid velocity: divergence-free on open faces, continued into solids.
    const FluidVelocity<D>& velocity() const { return velocity_; }
    /// Reduced pressure (p - rho g.x), averaged over the last step: bulk and mixed cells, film nodes.
    UnknownVector<D> reduced_pressure() const;
    /// What to add to the reduced pressure at x for the full pressure.
    double hydrostatic(const Vec<D>& x) const;
    /// Fluid force and torque on every body about its centre of mass, averaged over the step, buoyancy included.
    const std::vector<Twist<D>>& fluid_wrenches() const { return wrenches_; }
    std::vector<GapState> gaps() const;
    /// Voids in the films.
    const VoidSet<D>& voids() const { return voids_; }
    Budget<D> budget() const;
    /// Report of the state at the start (step 0; of a simulation that goes on from a stored state: of that one).
    const StepReport& initial_report() const { return initial_report_; }
    /// All that the next step depends on beside the scene. Collective.
    StoredState state() const;
    /// Time spent in each stage so far.
    const StageTimers& stages() const { return stages_; }

private:
    struct Unprepared {}; ///< tag: grid, bodies and walls only
    Simulation(Unprepared, const Scene& scene, const Communicator& comm);

    void list_state(StateArchive& archive);
    double choose_step(double next_output) const;
    void move_bodies(double dt);
    void find_contacts(double dt);
    void rebuild();
    void build_coupling(const std::function<WetShares(const Coupling<D>&)>& wet);
    void recall_pressure();
    bool met_something(int body) const;
    FaceField<D> advect_bulk(FaceField<D>& u_star, double dt, const FaceField<D, std::int8_t>* plain);
    FluidVelocity<D> advect_all(double dt, std::vector<double>& conduit_scale, FaceField<D>& change);
    void flood(FilmFlow<D>& flow, double dt);
    const FaceField<D, std::int8_t>* faces_near_jets(const std::vector<double>& flux);
    std::vector<Twist<D>> forced_twists(double dt, const FaceField<D>& change) const;
    void finish_bodies(const std::vector<Twist<D>>& V, double dt);
    std::vector<Twist<D>> predicted_twists(double dt) const;
    void add_viscosity(FluidVelocity<D>& u_star, std::vector<Twist<D>>& V_star, double dt, StepReport& report);
    void remember_projection(const std::vector<Twist<D>>& V_star, double dt);
    void project(FluidVelocity<D> u_star, const std::vector<Twist<D>>& forced, double dt, StepReport& report);
    void check_crushing(const std::vector<Twist<D>>& V, double dt, StepReport& report) const;
    void take_velocities(FluidVelocity<D> u_star, const std::vector<Twist<D>>& V, const std::vector<char>& was_empty,
                         double dt);
    void find_wrenches(const std::vector<Twist<D>>& V, double dt);
    void remember_push(const std::vector<Vec<D>>& without, double dt);
    void continue_velocities();
    void paint_films(FaceField<D, std::int8_t>& valid);
    void share_uncovered_faces(FaceField<D>& u_star) const;
    double normal_surplus(const FaceField<D>& u, int axis, const Index<D>& f, const std::vector<Twist<D>>& V,
                          std::vector<int>& near) const;
    void follow_solids(FaceField<D>& u, const FaceField<D, std::int8_t>& valid) const;
    void finish_report(StepReport& report, double dt);
    std::vector<Twist<D>> twists() const;
    std::vector<TwistMatrix<D>> masses() const;
    void check_sealing(const FluidVelocity<D>& u, const std::vector<Twist<D>>& V, GivesWay gives_way) const;
    BoundaryVelocity<D> side_velocities(double time) const;
    std::vector<Vec<D>> sample(const std::vector<Vec<D>>& points) const;

    Scene scene_;
    Grid<D> grid_;
    std::vector<RigidBody<D>> bodies_;
    DomainWalls<D> walls_;
    std::function<GapSettings(int, int)> gaps_;
    std::function<MouthLaw(int, int)> mouth_laws_;

    double time_ = 0;
    double dt_ = 0;      ///< of the step under way, else of the last one
    double last_dt_ = 0; ///< of the step before it: what `impulse_` is of until the next projection
    long steps_ = 0;
    bool holding_ = false;    ///< in the initial projection
    bool giving_way_ = false; ///< there, where prescribed motion or inflow drives fluid that only moving bodies let out
    std::unique_ptr<Coupling<D>> coupling_;
    std::shared_ptr<const FaceFractions<D>> old_fractions_; ///< of the step before
    FluidVelocity<D> velocity_;
    /// Faces open by no more than this share hold little fluid, and what squeezes through them may be many times as fast as the flow
    /// around. Where they differ from that, continued, by more than its speed, traces and the step size see the flow around, and what the
    /// faces have beyond that stays where it is: a jet would feed itself through its own traces. Where viscosity takes more of a face's
    /// surplus in a step than its traces bring, all but the narrowest are like other faces.
    double sliver() const
    {
        constexpr double share = 0.25, least = 0.02,
                         rate = 8; // of a face's surplus, in nu dt / dx^2: four neighbours, two walls close by
        return std::max(least, share / (1 + rate * scene_.viscosity * dt_ / (scene_.density * grid_.dx() * grid_.dx())));
    }
    struct Sliver {
        int axis;
        Index<D> at;
        double open, own, continued, around; ///< the latter: the speed of the flow around
    };
    std::vector<Sliver> slivers_;
    FaceField<D> painted_;                 ///< velocity with films painted in, continued
    FaceField<D, std::int8_t> film_faces_; ///< faces that take the painted velocity
    bool any_film_faces_ = false;
    FaceField<D, std::int8_t> near_jets_;
    UnknownVector<D> impulse_; ///< p
    bool light_bodies_ = true; ///< the next solver asks whether bodies are so light that they need correction
    ContactSet<D> contacts_;   ///< of the last step
    VoidSet<D> voids_;
    PastPressure<D> past_; ///< without viscosity only from a step's start to its advection
    ViscousMemory<D> viscous_;
    Eigen::VectorXd node_outflow_; ///< L p + K V + D u* of the film nodes, where voids had to be found; else empty
    std::vector<Vec<D>>
        film_push_; ///< acceleration of the films' elements by the pressure, flat ones in 2D without viscosity; none after impacts
    std::vector<Vec<D>> last_push_; ///< its mean over the last step
    FilmMemories<D> memories_;
    std::set<FilmPair<D>> turning_;      ///< pairs whose films turn in this step, or turned in the last one
    std::set<FilmPair<D>> alive_;        ///< pairs with films before the coupling was built
    std::set<FilmPair<D>> blind_told_;   ///< pairs whose films' blind ends were told of
    std::vector<Twist<D>> acceleration_; ///< of all solids, over the last step, as far as it goes on
    std::vector<Twist<D>> wrenches_;
    StepReport initial_report_;
    StageTimers stages_;
    std::vector<Twist<D>> start_twists_; ///< that the fluid sees in the initial projection; empty: the bodies' own
};

} // namespace gapflow
