// Which faces of a slab a solid covers or cuts.
#pragma once

#include "gapflow/complex/cut_faces.hpp"

namespace gapflow {

/// Marks them, and cuts those at once that this solid alone cuts in the common way. `image`: number of the solid. Of a mesh that meets the slab its facets are kept
/// in Slab::facets.
template <int D>
void mark_faces(const GridPlanes<D>& planes, const DenseIndex<D>& index, const PlacedSolid<D>& solid, int image,
                CutFaces<D>& cut, Slab<D>& slab);

} // namespace gapflow
