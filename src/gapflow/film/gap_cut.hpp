// The refined surface cut at the gap's end. Private to film/.
#pragma once

#include "gapflow/film/gap_surface.hpp"

namespace gapflow {

template <int D>
struct GapCut {
    struct Node {
        Vec<D> x;
        SurfacePoint<D> p;         ///< closest point of the other
        std::optional<RimEnd> end; ///< why the gap ends there, if it does
    };
    std::vector<Node> nodes; ///< also some that no element uses
    std::vector<typename FilmSurface<D>::Element> elements;
    EdgeTable creases; ///< edges on sharp edges of the master (3D)
};

/// The part of the refined surface that lies in the gap. Conforming; ends at points where edges leave the gap.
template <int D>
GapCut<D> cut_at_end(FilmSurface<D>& surface);

} // namespace gapflow
