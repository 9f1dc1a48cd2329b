// Velocities of the fluid along gaps of the complex, from the fluxes through the faces of their parts.
#pragma once

#include "gapflow/step/instant.hpp"

#include <map>
#include <tuple>
#include <vector>

namespace gapflow {

/// A part of the complex, or a whole cell, in the unknowns.
template <int D>
double value_of(const Placed<D>& at, const UnknownVector<D>& p, const PartOrCell& side)
{
    const Complex<D>& complex = at.complex;
    if (side.is_part() && at.node[side.number()] >= 0)
        return p.nodes[at.node[side.number()]];
    return p.cells(complex.index.index(complex.cell_of(side)));
}

/// What flows through a part's faces in a gap: its velocity along the gap is the one that is nearest to that through all of them, by their areas.
template <int D>
struct Through {
    Mat<D> square = Mat<D>::Zero();
    Vec<D> sum = Vec<D>::Zero();
    Vec<D> normal = Vec<D>::Zero(); ///< of the gap; not of unit length, either sign

    Vec<D> along(const Vec<D>& n) const
    {
        const Mat<D> across = Mat<D>::Identity() - n * n.transpose();
        const Mat<D> of_plane = across * square * across;
        return across * of_plane.completeOrthogonalDecomposition().solve(across * sum);
    }
};

/// The potentials with those in the layer around this rank's block. Collective.
template <int D>
UnknownVector<D> potentials_around(const Instant<D>& instant);

/// Flux along the axis of an arm's face over its area, relative to the stream. `p`: as above.
template <int D>
double velocity_through(const Instant<D>& instant, const UnknownVector<D>& p, const GapArm<D>& arm);

/// Of this rank's parts in gaps, by the two solids (the first has the smaller number) and the part. With the stream. Collective.
template <int D>
std::map<std::tuple<int, int, std::int32_t>, Through<D>> flow_through_gaps(const Instant<D>& instant);

/// Square of the speed along the gap in each part of the complex, seen from a frame; negative: the part is not in a gap, or another rank's. Collective.
template <int D>
std::vector<double> squares_in_gaps(const Instant<D>& instant, const Vec<D>& frame);

} // namespace gapflow
