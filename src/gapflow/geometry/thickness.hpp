// Thickness of a solid on the scale of a grid: balls inside it that touch its surface.
#pragma once

#include "gapflow/geometry/pose.hpp"

#include <functional>

namespace gapflow {

/// Where a solid is thinnest.
template <int D>
struct Thickness {
    double value; ///< a length, at most the given limit
    Vec<D> at;    ///< in the solid, half-way between the surfaces
};

/// The smallest thickness of a solid that holds over a patch three cells wide, or over all of it if that is smaller; `most`
/// where it is no thinner. At a point of the surface it is the diameter of the largest ball inside that touches the surface
/// there; it counts where the ball also touches a surface that faces the other way. Edges, corners, wedges of more than a small
/// angle, and parts smaller than the patch (ridges, short fins) do not count. Solids without bounds or inside out have no
/// thickness: `most`. `beyond(x, n)`, if given: how far other solids continue this one from its surface point x along the
/// normal n. `within`: where it matters, in the world; only there it is sought on solids that are wider than that.
template <int D>
Thickness<D> sheet_thickness(const PlacedShape<D>& solid, double cell, double most,
                             const std::function<double(const Vec<D>&, const Vec<D>&)>& beyond = {},
                             const Bounds<D>& within = {});

} // namespace gapflow
