// Mass properties of a closed mesh.
#pragma once

#include "gapflow/geometry/shape.hpp"

namespace gapflow {

/// Volume (signed: positive if oriented outward), centre and inertia at density 1 of the solid in a closed mesh; exact.
template <int D>
MassProperties<D> mass_properties_of(const SurfaceMesh<D>& mesh);

} // namespace gapflow
