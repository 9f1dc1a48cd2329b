// Gaps of a few cells: the drag that the lattice lacks there (method, "Viscosity").
#pragma once

#include "gapflow/viscosity/viscous_faces.hpp"
#include "gapflow/viscosity/viscous_terms.hpp"

#include <map>
#include <optional>
#include <utility>

namespace gapflow {

/// The narrow gap around a lattice point. Lengths in dx.
template <int D>
struct NarrowGap {
    std::array<int, 2> image; ///< near and far
    std::array<Vec<D>, 2> foot;
    Vec<D> x, normal;   ///< of the point; unit, from the near surface to the far one
    double near, width; ///< distance to the near surface; of the gap
    double value;       ///< of plane Poiseuille flow y (h - y) / 2 at the point
    double lacking;     ///< force that the lattice lacks there, of the unit pressure gradient's
};

template <int D>
class NarrowGaps {
public:
    /// All must last; of `system`: active faces and the edges' stiffness.
    NarrowGaps(const Coupling<D>& coupling, const ViscousFaces<D>& faces, const ViscousSystem<D>& system)
        : coupling_(coupling), grid_(*coupling.grid), fractions_(*coupling.fractions), faces_(faces), system_(system)
    {
    }

    /// Gaps of a few cells: a point next to a surface, whose second difference is too weak there. Moves the rays.
    std::optional<NarrowGap<D>> find(WallRays<D>& rays, int axis, const Index<D>& f, double share) const;
    /// Remembers the gap around a lattice point.
    void keep(int axis, long at, const NarrowGap<D>& gap) { gaps_.try_emplace({axis, at}, gap); }
    /// A face that follows a point of a narrow gap: sets its stiffness according to its own share of that flow. Returns the part of the
    /// pressure's force that it passes on to its leader. Moves the rays.
    double stiffen(WallRays<D>& rays, int axis, const Index<D>& f, const LatticeFace<D>& face, const Index<D>& leader,
                   FollowingFace<D>& following) const;
    /// Adds the force that a face passes on to its leader, if the leader lies in a gap.
    void pass_on(int axis, long leader, double force);
    /// Adds the drag of all gaps kept.
    void add_drag(ViscousTerms<D>& terms);

private:
    std::optional<NarrowGap<D>> narrow_gap(WallRays<D>& rays, const Vec<D>& x) const;
    double face_mean(const NarrowGap<D>& gap, int axis, const Vec<D>& centroid, double open) const;
    double lattice_value(WallRays<D>& rays, const NarrowGap<D>& gap, int axis, const Index<D>& f) const;
    void add_drag(int axis, long at, const NarrowGap<D>& gap, ViscousTerms<D>& terms);

    const Coupling<D>& coupling_;
    const Grid<D>& grid_;
    const FaceFractions<D>& fractions_;
    const ViscousFaces<D>& faces_;
    const ViscousSystem<D>& system_;
    std::map<std::pair<int, long>, NarrowGap<D>> gaps_; ///< of lattice points, by axis and offset
};

} // namespace gapflow
