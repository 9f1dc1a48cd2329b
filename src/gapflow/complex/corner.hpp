// Sharp corners of solids, which divide the part of the fluid in which they lie.
//
// A grid that does not see a corner moves it by up to half a cell: the flow around it passes through the cell's one node. The part is
// therefore divided along the corner's bisector, and a link joins the two sides (see ComplexParameters::corner_link).
#pragma once

#include "gapflow/core/types.hpp"

namespace gapflow {

/// A convex corner of a solid in the plane; lengths in cells.
struct SharpCorner {
    Vec<2> at;
    Vec<2> outward; ///< along the bisector, of unit length
    double angle;   ///< of the solid, 0 .. pi
};

/// Conductance (over 1/density, per length of edge) of the link across a dividing line of which a length `open` lies in the fluid
/// of the corner's cell; `covered`: from the corner back along the bisector to the cell's border.
double corner_conductance(double angle, double open, double covered);

} // namespace gapflow
