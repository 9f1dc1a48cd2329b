// Cut faces that follow a neighbour or solids (method, "Viscosity").
#pragma once

#include "gapflow/viscosity/narrow_gaps.hpp"
#include "gapflow/viscosity/viscous_faces.hpp"
#include "gapflow/viscosity/viscous_terms.hpp"

#include <optional>

namespace gapflow {

template <int D>
class FollowingFaces {
public:
    /// All must last. `system`: has its active faces; gets the following ones.
    FollowingFaces(const Coupling<D>& coupling, const FaceField<D>& u_star, const ViscousFaces<D>& faces, NarrowGaps<D>& gaps,
                   ViscousTerms<D>& terms, ViscousSystem<D>& system)
        : coupling_(coupling), grid_(*coupling.grid), fractions_(*coupling.fractions), u_star_(u_star), faces_(faces),
          gaps_(gaps), terms_(terms), system_(system)
    {
    }

    /// Cut faces whose centres lie in solids or next to them. This rank adds those whose leader it owns.
    void add(int axis);

private:
    /// A following face, and what this rank adds of it.
    struct Followed {
        FollowingFace<D> face;
        bool mine, leads;
        double passed_on; ///< to the leader
    };

    std::optional<Followed> follow(WallRays<D>& rays, int axis, const Index<D>& f) const;
    Index<D> leader_of(WallRays<D>& rays, int axis, const Index<D>& f, const LatticeFace<D>& face,
                       FollowingFace<D>& following) const;
    void follow_solids(WallRays<D>& rays, int axis, const Vec<D>& x, double area, FollowingFace<D>& following) const;

    const Coupling<D>& coupling_;
    const Grid<D>& grid_;
    const FaceFractions<D>& fractions_;
    const FaceField<D>& u_star_;
    const ViscousFaces<D>& faces_;
    NarrowGaps<D>& gaps_;
    ViscousTerms<D>& terms_;
    ViscousSystem<D>& system_;
};

} // namespace gapflow
