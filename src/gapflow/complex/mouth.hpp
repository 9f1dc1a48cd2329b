// Mouths: where a gap ends at a sharp corner in front of another wall (gap-energy, "Mouths in 2D").
//
// A corner closer than a cell to another wall divides the fluid along the shortest line to that wall. Behind the line the fluid is that of a gap;
// before it the flow spreads.
#pragma once

#include "gapflow/complex/complex.hpp"
#include "gapflow/complex/placed.hpp"

#include <span>
#include <vector>

namespace gapflow {

/// Leads the dividing lines of corners near other walls to these, and finds where they go. Numbers of the mouths go to SharpCorner::mouth.
std::vector<GapMouth<2>> find_mouths(const GridPlanes<2>& planes, std::span<const Solid<2>> solids,
                                     std::vector<PlacedSolid<2>>& placed);

/// Resistance (2D, density 1, lengths in cells) from the end of a channel of width h to a source spread evenly over the sector of the given radius beyond it. The
/// channel's walls turn away there by `turns`, in 0 .. 2 pi. Exact for h << radius where one wall goes on, and where both turn alike; else
/// between these.
double outlet_resistance(double h, const std::array<double, 2>& turns, double radius);

} // namespace gapflow
