// Velocities beyond the fluid (method, "The time step", stage 7): the values that the next step's traces read in solids and
// films, and faces that surfaces uncover.
#pragma once

#include "gapflow/film/film_motion.hpp"
#include "gapflow/stepping/state.hpp"

#include <cstdint>
#include <vector>

namespace gapflow {

/// Faces open by at most this share (slivers) contain little fluid, and the flow through them may be many times as fast as the
/// surrounding flow. Where a sliver's velocity differs from the extrapolated one by more than the speed of the surrounding
/// flow, traces and the step size use the extrapolated velocity, and the difference is not advected: otherwise a jet would
/// amplify itself through its own traces. Where viscosity removes more of a face's excess in a step than its traces add, only
/// the narrowest faces count as slivers. `dt`: length of the step.
template <int D>
double widest_sliver(const Model<D>& model, double dt);

/// A sliver: a face with a small opening and a fast flow through it.
template <int D>
struct Sliver {
    int axis;
    Index<D> at;
    double open, own, extrapolated, around; ///< the last: the speed of the surrounding flow
};

/// Input of the next step's traces besides the bulk's extrapolated velocity. Follows from the state.
template <int D>
struct Reconstruction {
    FilmHistories<D> histories;
    std::vector<Sliver<D>> slivers;
    bool any_film_faces = false;
    FaceField<D> painted;                 ///< velocity including the films', extrapolated
    FaceField<D, std::int8_t> film_faces; ///< faces that take the painted velocity
};

/// Extrapolates state.velocity.grid into solids and films, and fills its ghosts; the rest of the state is read. `V`: twists of all
/// solids. Collective.
template <int D>
Reconstruction<D> reconstruct(const Model<D>& model, const Coupling<D>& here, State<D>& state, const std::vector<Twist<D>>& V);

/// Where a solid has uncovered more of a film's face, the fresh part starts with the solid's normal velocity:
///     a_new u* = a_old u_advected + (a_new - a_old) (u_advected + n n . (U_b - u)).
/// Otherwise, when a surface leaves a grid plane by round-off, the whole face would get the speed of a jet through a sliver of
/// it. `u`: before the
/// step, `old`: fractions then.
template <int D>
void share_uncovered_faces(const Coupling<D>& there, const FaceFractions<D>& old, const FaceField<D, std::int8_t>& film_faces,
                           const FaceField<D>& u, const std::vector<Twist<D>>& V, FaceField<D>& u_star);

} // namespace gapflow
