// Circulation of the fluid on parts (theory of the step, "Circulation"): what its momentum m has beside the gradient of a potential. It is a 1-form: a value on
// each edge of the complex, which stays there as bodies move, turned by v x omega alone.
#pragma once

#include "gapflow/step/potential_flow.hpp"

namespace gapflow {

/// Throws InputError on several ranks: circulation needs one.
template <int D>
void require_one_rank(const Model<D>& model);

/// Of a given velocity on the faces of the grid. `at`: with its edges. Collective.
template <int D>
Remainder<D> remainder_of(const Placed<D>& at, FaceField<D> velocity);

/// The remainder of a place at another one. Edges that were not there before take the mean velocity of the faces beside them along the same axis. Collective.
template <int D>
Remainder<D> carried(const Placed<D>& before, const Remainder<D>& remainder, const Placed<D>& after);

/// D g w of the edges, that of the faces left out. Collective.
template <int D>
UnknownVector<D> outflow_of_edges(const Placed<D>& at, const Remainder<D>& remainder);

/// The same with that of the faces. Collective.
template <int D>
UnknownVector<D> outflow_of_remainder(const Placed<D>& at, const Remainder<D>& remainder);

/// The share of the solids' impulses dR/dV that the remainder has by the fluxes that faces and edges carry. Collective.
template <int D>
std::vector<Twist<D>> impulse_of_remainder(const Placed<D>& at, const Remainder<D>& remainder);

/// 1/2 sum w q over faces and edges, q the flux through each: with 1/2 V . dR/dV the kinetic energy. Collective.
template <int D>
double energy_of_remainder(const Placed<D>& at, const PotentialFlow<D>& flow);

/// Flux through the faces of the grid over the area of a whole one. Collective.
template <int D>
FaceField<D> face_fluxes(const Placed<D>& at, const PotentialFlow<D>& flow);

/// Open areas of the faces of the grid over the area of a whole one. Collective.
template <int D>
FaceField<D> open_areas(const Placed<D>& at);

/// dt (q x omega) on the faces of the grid: no work is done by the flux q. `open`: areas of the flux, means over the step: a face that closes has less than it
/// had. `remainder`: of omega. Collective.
template <int D>
FaceField<D> vortex_impulse(const Placed<D>& at, const FaceField<D>& open, const FaceField<D>& flux,
                            const FaceField<D>& remainder, double dt);

/// The same flow with a remainder whose fluxes have no divergence: its potential is then that of the solids' motion alone. Collective.
template <int D>
void renew_gauge(const Placed<D>& at, PotentialFlow<D>& flow, const SolverOptions& options);

} // namespace gapflow
