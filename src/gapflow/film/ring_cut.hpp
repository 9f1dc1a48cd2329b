// The gap between a ball and another convex body, in rings about the point where they are nearest (method, "Mesh"). Private to film/.
#pragma once

#include "gapflow/film/gap_cut.hpp"

namespace gapflow {

/// The part of the master's surface in the gap with a few tens of nodes: rings as far from each other as `rings` sqrt(2 R h), the last of them the
/// gap's end, found along rays from the point of the master that is nearest to the other. Nothing where this does not describe the gap (the
/// master is no ball, the other not convex, the gap not in one piece about that point, or it ends at an edge): then it takes a refined surface (FilmSurface).
std::optional<GapCut<3>> ring_cut(const GapTest<3>& test);

} // namespace gapflow
