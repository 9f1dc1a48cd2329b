// What of a solid's sections lies within the domain.
#pragma once

#include "gapflow/complex/placed.hpp"
#include "gapflow/complex/square.hpp"

#include <vector>

namespace gapflow {

/// The domain in cells; without end along periodic axes.
template <int D>
struct Window {
    Vec<D> low, high;

    Window(const Grid<D>& grid, const GridPlanes<D>& planes)
    {
        for (int d = 0; d < D; ++d) {
            const double none = std::numeric_limits<double>::infinity();
            low[d] = grid.periodic(d) ? -none : planes.place[d].front();
            high[d] = grid.periodic(d) ? none : planes.place[d].back();
        }
    }
    double side(int d, int end) const { return end ? high[d] : low[d]; }
    bool bounded(int d) const { return std::isfinite(low[d]); }
    bool holds(const Vec<D>& x) const { return (x.array() >= low.array()).all() && (x.array() <= high.array()).all(); }
    /// All of it.
    bool holds(const PlacedSolid<D>& solid) const { return holds(solid.low) && holds(solid.high); }
};

/// A piece of a border in a plane, inside the rectangle low .. high or beside it.
struct WindowPart {
    ArcSegment segment;
    bool inside;
    Vec<2> middle;
};

/// A border's segment, straight or clockwise, divided where it crosses the lines of a rectangle's sides.
std::vector<WindowPart> parts_in_window(const ArcSegment& segment, const Vec<2>& low, const Vec<2>& high);

/// What the segment contributes to area and first moment of what its border encloses within the rectangle, positive if that runs counterclockwise: by
/// Green's theorem with v, and u where it lies beside the rectangle replaced by that of the side.
Bulge enclosed_in_window(const ArcSegment& segment, const Vec<2>& low, const Vec<2>& high);

} // namespace gapflow
