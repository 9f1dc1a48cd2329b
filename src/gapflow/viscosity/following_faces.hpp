// Cut faces that follow a neighbour or solids (method, "Viscosity").
#pragma once

#include "gapflow/viscosity/narrow_gaps.hpp"
#include "gapflow/viscosity/viscous_faces.hpp"
#include "gapflow/viscosity/viscous_terms.hpp"

namespace gapflow {

template <int D>
class FollowingFaces {
public:
    /// All must last. `system`: has its active faces; gets the following ones.
    FollowingFaces(const Coupling<D>& coupling, const FaceField<D>& u_star, ViscousFaces<D>& faces, NarrowGaps<D>& gaps,
                   ViscousTerms<D>& terms, ViscousSystem<D>& system)
        : coupling_(coupling), grid_(*coupling.grid), fractions_(*coupling.fractions), u_star_(u_star), faces_(faces),
          rays_(faces.rays()), gaps_(gaps), terms_(terms), system_(system)
    {
    }

    /// Cut faces whose centres lie in solids or next to them. This rank adds those whose leader it owns.
    void add(int axis);

private:
    Index<D> leader_of(int axis, const Index<D>& f, const LatticeFace<D>& face, FollowingFace<D>& following);
    void follow_solids(int axis, const Vec<D>& x, double area, FollowingFace<D>& following);

    const Coupling<D>& coupling_;
    const Grid<D>& grid_;
    const FaceFractions<D>& fractions_;
    const FaceField<D>& u_star_;
    ViscousFaces<D>& faces_;
    WallRays<D>& rays_;
    NarrowGaps<D>& gaps_;
    ViscousTerms<D>& terms_;
    ViscousSystem<D>& system_;
};

} // namespace gapflow
