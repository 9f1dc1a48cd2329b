// Transport of velocities to the new configuration: bulk, films and mouths together (method, "The time step", stages 2 and 4).
#pragma once

#include "gapflow/film/film_account.hpp"
#include "gapflow/stepping/reconstruction.hpp"
#include "gapflow/stepping/step.hpp"

#include <vector>

namespace gapflow {

/// Input of a projection.
template <int D>
struct Intermediate {
    FluidVelocity<D> velocity;        ///< u* of the bulk, films and mouths
    UnknownVector<D> outflow;         ///< of what u* carries elsewhere, between parts; empty: nothing
    std::vector<double> mouth_factor; ///< on the conductance of every mouth
    FilmAccount<D> film_account;
    std::vector<Twist<D>> twists; ///< V* of all solids
    std::vector<Twist<D>> forced; ///< after the forces of the step alone, where V* has more than these; else empty
};

/// u* in the configuration `there`, to which the state's bodies have moved; the twists are left empty. `state`: otherwise that
/// before the step; its bulk velocity is invalid afterwards. `beyond`, `past`: of the configuration before the step, `old`: its
/// fractions; `past` is extrapolated to the new one, or released where viscosity does not need it. Collective.
template <int D>
Intermediate<D> transport(const Model<D>& model, State<D>& state, Reconstruction<D> beyond, PastPressure<D>& past,
                          const Coupling<D>& there, const FaceFractions<D>& old, const Step& step);

/// Stage 2: bulk velocities u* of second order in time. `first_order`: faces (nonzero) without MacCormack's correction; null: none. `motion`: mean
/// of the step, of all solids, the first `bodies` of which are bodies: the last pressure goes with them, in `past` too. Collective.
template <int D>
FaceField<D> transport_bulk(const Model<D>& model, const FaceField<D>& velocity, PastPressure<D>& past,
                            const Coupling<D>& there, const FaceFractions<D>& old, const FaceField<D, std::int8_t>* first_order,
                            const std::vector<Twist<D>>& motion, std::size_t bodies, const Step& step);

} // namespace gapflow
