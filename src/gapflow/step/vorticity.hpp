// The flow carries its vorticity (theory of the step, "Circulation"): dw/dt = v x omega of the remainder w.
#pragma once

#include "gapflow/step/instant.hpp"

#include <utility>

namespace gapflow {

/// dt (v x omega) on the inner faces of the grid, v of the flux, which does no work. Where this has no divergence, vorticity that is uniform stays so (2D).
/// `remainder`: of omega. Collective.
template <int D>
FaceField<D> vortex_impulse(const Grid<D>& grid, const FaceField<D>& flux, const FaceField<D>& remainder, double dt);

/// Where the grid goes along an axis with a body, and all of the fluid's motion and all other bodies stay where they are in the world, the remainder changes at the
/// places of the grid. Of the force on this body (theory of the step, "A step", grids that follow):
template <int D>
struct ForceOfGrid {
    double of_remainder; ///< by the vorticity of the remainder
    double of_sides;     ///< by that of the flux, less: what sides bear
};
template <int D>
ForceOfGrid<D> force_of_grid(const Coupling<D>& coupling, const FaceField<D>& flux, const FaceField<D>& remainder, int axis);

/// The remainder at the end of a step, turned by the vorticity that the flow carries along.
template <int D>
class TurnedRemainder {
public:
    /// `old` and `there`, the places at the end, must outlive it. `beyond`: velocity of the fluid beyond open sides; `grid_velocity`: of the grid. Collective.
    TurnedRemainder(const Instant<D>& old, const Placed<D>& there, const SolverOptions& options, const Vec<D>& beyond,
                    const Vec<D>& grid_velocity, double dt);

    /// `end`: the step's end as found so far; null: the flux stays that of the start. Goes on in sub-steps of one cell with the flux at their times: linear between the
    /// ends, and with several of them a parabola, for which the flux that the vorticity has half-way is found by a solve. The mean flux of both ends over the grid does no
    /// work. Collective.
    Remainder<D> find(const Instant<D>* end);

    /// Work of the turning by the mean flux of both ends over the grid, none where `end` has the flux by which it was found. Collective.
    double work(const Instant<D>& end) const;
    /// Work by the grid's velocity that the turning asks of the body that it follows: less the gain of the remainder's momentum. Collective.
    double work_of_grid(const Instant<D>& end) const;

private:
    const Grid<D>& grid() const { return *there_.coupling.grid; }
    bool grid_moves() const { return !grid_velocity_.isZero(0); }
    bool has_exits() const { return there_.viscous || old_.followed.body >= 0; }
    /// `share` of the way from the flux at the start to that at the end, over the grid.
    FaceField<D> flux_at(const Instant<D>* end, double share) const;
    FaceField<D> mean_flux(const Instant<D>& end) const; ///< over the grid
    double courant(const FaceField<D>& flux) const;
    std::pair<FaceField<D>, FaceField<D>> sub_steps(const Instant<D>* end, int steps);
    Remainder<D> at_end(FaceField<D> w) const;
    FaceField<D> turning(const FaceField<D>& flux, const FaceField<D>& remainder, double dt) const;
    void find_heads(const Instant<D>* end);
    void find_curve(std::pair<FaceField<D>, FaceField<D>> half_and_end);
    void add(FaceField<D>& to, double factor, const FaceField<D>& change) const;
    void take_work(const Instant<D>& end, FaceField<D>& w) const;

    const Instant<D>& old_;
    const Placed<D>& there_;
    SolverOptions options_;
    Vec<D> beyond_; ///< over the grid
    Vec<D> grid_velocity_;
    double dt_;
    FaceField<D> grid_flux_; ///< of its velocity; empty: none
    FaceField<D> heads_;     ///< what heads in open sides add; empty: nothing
    FaceField<D> exits_;     ///< the same by vorticity that leaves there, of a grid that moves; empty: not known
    FaceField<D> curve_;     ///< of the flux half-way, over the mean of both ends; empty: none
};

} // namespace gapflow
