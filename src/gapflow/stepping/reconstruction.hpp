// Velocities beyond the fluid (method, "The time step", stage 7): what the next step's traces read in solids and films, and where surfaces
// uncover faces.
#pragma once

#include "gapflow/film/film_motion.hpp"
#include "gapflow/stepping/state.hpp"

#include <cstdint>
#include <vector>

namespace gapflow {

/// Faces open by no more than this share hold little fluid, and what squeezes through them may be many times as fast as the flow
/// around. Where they differ from that, extrapolated, by more than its speed, traces and the step size see the flow around, and what the
/// faces have beyond that stays where it is: a jet would feed itself through its own traces. Where viscosity takes more of a face's
/// surplus in a step than its traces bring, all but the narrowest are like other faces. `dt`: length of the step.
template <int D>
double widest_sliver(const Model<D>& model, double dt);

/// A face that squeezes a jet.
template <int D>
struct Sliver {
    int axis;
    Index<D> at;
    double open, own, extrapolated, around; ///< the latter: the speed of the flow around
};

/// What the next step's traces read beside the bulk's extrapolated velocity. Follows from the state.
template <int D>
struct Reconstruction {
    FilmMemories<D> memories;
    std::vector<Sliver<D>> slivers;
    bool any_film_faces = false;
    FaceField<D> painted;                 ///< velocity with films painted in, extrapolated
    FaceField<D, std::int8_t> film_faces; ///< faces that take the painted velocity
};

/// Extrapolates state.velocity.grid into solids and films, and fills its ghosts; the rest of the state is read. `V`: twists of all
/// solids. Collective.
template <int D>
Reconstruction<D> reconstruct(const Model<D>& model, const Coupling<D>& here, State<D>& state, const std::vector<Twist<D>>& V);

/// Where a solid has uncovered more of a film's face, the fresh part starts with the solid's normal velocity:
///     a_new u* = a_old u_advected + (a_new - a_old) (u_advected + n n . (U_b - u)).
/// Else a surface that leaves a grid plane by round-off gives the whole face the speed of a jet that filled a sliver of it. `u`: before the
/// step, `old`: fractions then.
template <int D>
void share_uncovered_faces(const Coupling<D>& there, const FaceFractions<D>& old, const FaceField<D, std::int8_t>& film_faces,
                           const FaceField<D>& u, const std::vector<Twist<D>>& V, FaceField<D>& u_star);

} // namespace gapflow
