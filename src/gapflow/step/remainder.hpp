// Circulation of the fluid on parts (theory of the step, "Circulation"): what its momentum m has beside the gradient of a potential. It is a 1-form: a value on
// each edge of the complex, which stays there as bodies move, turned by v x omega alone (vorticity.hpp).
#pragma once

#include "gapflow/step/potential_flow.hpp"

#include <vector>

namespace gapflow {

/// Of a velocity on all faces of the grid, in solids too: what lies within them is the circulation around them. `at`: with its edges. Collective.
template <int D>
Remainder<D> remainder_of(const Placed<D>& at, FaceField<D> velocity);

/// Its line integrals along this rank's edges. `velocity`: with other ranks' faces.
template <int D>
std::vector<double> along_edges(const Placed<D>& at, const FaceField<D>& velocity);
/// A face of the grid on the way along an edge of the complex.
template <int D>
struct FaceAlong {
    int axis;
    Index<D> face;
    double length; ///< with the weight of the way
};
/// The line integral of the remainder along an edge is the sum of length times velocity.
template <int D>
std::vector<FaceAlong<D>> faces_along(const Placed<D>& at, const SparseEdge<D>& edge);

/// D g w of the edges, that of the faces left out. Collective.
template <int D>
UnknownVector<D> outflow_of_edges(const Placed<D>& at, const Remainder<D>& remainder);

/// The same of the faces alone. Collective.
template <int D>
UnknownVector<D> outflow_of_faces(const Placed<D>& at, const Remainder<D>& remainder);

/// Of both. Collective.
template <int D>
UnknownVector<D> outflow_of_remainder(const Placed<D>& at, const Remainder<D>& remainder);

/// The share of the solids' impulses dR/dV that the remainder has by the fluxes that faces and edges carry, and by what solids cover of faces. Collective.
template <int D>
std::vector<Twist<D>> impulse_of_remainder(const Placed<D>& at, const Remainder<D>& remainder);

/// Of the fluid alone: through the faces of the grid between the largest parts of two cells, over the area of a whole face, and through each of the other edges.
/// Potentials in the layer around a rank's block are filled in. Collective.
template <int D>
struct EdgeFluxes {
    FaceField<D> face;
    std::vector<double> edge;
};
template <int D>
EdgeFluxes<D> edge_fluxes(const Placed<D>& at, const PotentialFlow<D>& flow);

/// The fluxes of edges added to those of the faces on their way.
template <int D>
FaceField<D> on_faces(const Placed<D>& at, EdgeFluxes<D> fluxes);

/// Flux of volume through the faces of the grid, of all parts and mouths there and of what solids cover, over the area of a whole one. It has no divergence in
/// whole cells. Collective.
template <int D>
FaceField<D> face_fluxes(const Placed<D>& at, const PotentialFlow<D>& flow);

/// Sum of flux times momentum over the faces, the momentum of a velocity there. Half of it for the remainder's is, with 1/2 V . dR/dV, the kinetic energy.
/// Collective.
template <int D>
double work_of_fluxes(const Coupling<D>& coupling, const FaceField<D>& flux, const FaceField<D>& velocity);

} // namespace gapflow
