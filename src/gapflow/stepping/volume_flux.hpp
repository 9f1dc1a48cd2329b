// Volume flux through a side of the domain, a plane or the mouths of a gap. Reads the state, never changes it.
//
// A plane stands for the faces between cells whose centres lie on different sides of it: the nearest plane of the grid's faces, or a tilted
// plane's staircase. With psi = 1 in cells and film nodes beyond, 0 in the others, the flux through it is
//
//     Q = sum over all flows from a to b of q (psi_b - psi_a)
//
// over the grid's faces (a, b: cells), film elements (nodes), mouths and joints. A film's node counts to the side of the cell that holds it. Where
// no unknown's volume changes, the sum by parts gives the same Q for every plane between two others without a source.
#pragma once

#include "gapflow/stepping/state.hpp"

namespace gapflow {

struct VolumeFlux {
    double flux =
        0; ///< of fluid: out of the domain, along the plane's normal, or through a gap: half of what enters and leaves
    double film = 0;    ///< the part of it in films
    double bodies = 0;  ///< volume of bodies that passes the side or plane
    double inflow = 0;  ///< of fluid against that direction, or into a gap
    double outflow = 0; ///< along it, or out of a gap; of a side or plane `flux` is outflow - inflow
};

/// Through the faces of the grid, over the area dx^(D-1) of a whole one: of the fluid, of what of it flows in gaps, and of solids through those between two cells.
template <int D>
struct FaceFluxes {
    FaceField<D> fluid, gaps, bodies;
};

/// At the end of the last step. NaN for a gap that has no film. `V`: twists of all solids. `fluxes`: where they are known; null: those of the velocities
/// and of films. Collective.
template <int D>
VolumeFlux volume_flux(const Model<D>& model, const Coupling<D>& here, const State<D>& state, const std::vector<Twist<D>>& V,
                       const FluxScene& through, const FaceFluxes<D>* fluxes = nullptr);

/// The flow of films through all planes that are normal to an axis, one axis a component, summed up along it: the integral of their velocity over the volume that
/// they take of the grid's. `V` as above. Collective.
template <int D>
Vec<D> flow_of_films(const Model<D>& model, const Coupling<D>& here, const State<D>& state, const std::vector<Twist<D>>& V);

} // namespace gapflow
