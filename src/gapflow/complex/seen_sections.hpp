// Sums of a solid's sections with planes of the grid, of what lies within the domain.
#pragma once

#include "gapflow/complex/area_derivative.hpp"
#include "gapflow/complex/window.hpp"

#include <cmath>

namespace gapflow {

/// Planes a cell apart.
struct Planes {
    double first, last;
    /// The first that is not below x.
    double from(double x) const { return x > first ? first + std::ceil(x - first) : first; }
};

/// Sum of a surface's sections with planes normal to d: what they enclose within the window.
template <int D>
SeenVolume<D> sum_of_sections(const PlacedSolid<D>& solid, int d, const Planes& planes, const Window<D>& window);

/// Its derivative by the solid's twist.
template <int D>
SeenVolumeRate<D> rate_of_sections(const PlacedSolid<D>& solid, int d, const Planes& planes, const Window<D>& window);

} // namespace gapflow
