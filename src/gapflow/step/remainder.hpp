// Circulation of the fluid on parts (theory of the step, "Circulation"): what its momentum m has beside the gradient of a potential. It is a 1-form: a value on
// each edge of the complex, which stays there as bodies move, turned by v x omega alone.
#pragma once

#include "gapflow/step/potential_flow.hpp"

#include <array>

namespace gapflow {

/// Of a velocity on all faces of the grid, in solids too: what lies within them is the circulation around them. `at`: with its edges. Collective.
template <int D>
Remainder<D> remainder_of(const Placed<D>& at, FaceField<D> velocity);

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

/// The same with that of the faces. Collective.
template <int D>
UnknownVector<D> outflow_of_remainder(const Placed<D>& at, const Remainder<D>& remainder);

/// The share of the solids' impulses dR/dV that the remainder has by the fluxes that faces and edges carry. Collective.
template <int D>
std::vector<Twist<D>> impulse_of_remainder(const Placed<D>& at, const Remainder<D>& remainder);

/// 1/2 sum w q over faces and edges, q the flux through each: with 1/2 V . dR/dV the kinetic energy. Collective.
template <int D>
double energy_of_remainder(const Placed<D>& at, const PotentialFlow<D>& flow);

/// Flux through the faces of the grid, of all parts and mouths there, over the area of a whole one. Collective.
template <int D>
FaceField<D> face_fluxes(const Placed<D>& at, const PotentialFlow<D>& flow);

/// Open areas of the faces of the grid over the area of a whole one, of all parts there. Collective.
template <int D>
FaceField<D> open_areas(const Placed<D>& at);

/// What carries the vorticity at each edge of the grid (2D: vertex): the fluid, where the four faces that meet there are open and it lies in no solid, else the
/// solid that covers it or is nearest. None at the sides of the domain.
template <int D>
class VorticityCarriers {
public:
    static constexpr int fluid = -1, nothing = -2;

    /// `open_areas`: of the fluxes, means over the step: a face that closes has less than it had. Collective.
    VorticityCarriers(const Placed<D>& at, FaceField<D> open_areas);

    /// `fluid`, `nothing`, or an image of FaceClipper::images(). `pair`: of the axes normal to the edge, in ascending order; v: the cell at whose low corner it is.
    int of(int pair, const Index<D>& v) const { return carrier_[pair](v); }
    const FaceField<D>& open() const { return open_; }
    const Placed<D>& at() const { return *at_; }

private:
    const Placed<D>* at_;
    FaceField<D> open_;
    std::array<CellField<D, int>, D*(D - 1) / 2> carrier_;
};

/// dt (v x omega) on the faces of the grid: on open ones with v of the flux, which does no work, on closed ones with that of the solid's twist. `remainder`: of
/// omega. Collective.
template <int D>
FaceField<D> vortex_impulse(const VorticityCarriers<D>& carriers, const FaceField<D>& flux, const std::vector<Twist<D>>& twists,
                            const FaceField<D>& remainder, double dt);

/// Smooths the vorticity within each solid by diffusion along closed faces: its sum remains, and the flow does. Collective.
template <int D>
void spread_in_solids(const VorticityCarriers<D>& carriers, FaceField<D>& velocity);

/// The same flow with a remainder whose fluxes have no divergence but in parts beside others of their cell: its potential is then that of the solids' motion
/// alone. Collective.
template <int D>
void renew_gauge(const Placed<D>& at, PotentialFlow<D>& flow, const SolverOptions& options);

} // namespace gapflow
