// Cells of the complex, slab by slab: their parts, walls and links.
#pragma once

#include "gapflow/complex/area_derivative.hpp"
#include "gapflow/complex/complex.hpp"
#include "gapflow/complex/cut_faces.hpp"
#include "gapflow/complex/wall_joins.hpp"

#include <array>
#include <vector>

namespace gapflow {

/// Parts below and above each piece of a slab's faces (2D: the first of each piece of a cell), numbers as in the slab of the part's cell; -1: none.
using PartsBeside = std::vector<std::array<std::int32_t, 2>>;

/// What the cells of one slab are made of; numbers of parts and cut cells count from 0 in each slab.
template <int D>
struct CellSlab {
    std::vector<std::int32_t> cut_cell, parts_of_cell, part_cell, patches_of_part;
    std::vector<double> part_area;
    std::vector<Vec<D>> part_centroid; ///< 2D
    std::vector<WallPatch<D>> patches;
    std::vector<CornerLink<D>> links; ///< 3D
    // Where derivatives are wanted.
    std::vector<PatchRate<D>> patch_rates;
    std::vector<LinkRate<D>> link_rates; ///< 3D
    /// Wholly open faces that lead to another part than their cell's largest.
    struct Astray {
        std::int8_t axis, side; ///< 1: the part lies on the face's high side
        std::int32_t face, part;
    };
    std::vector<Astray> astray;
};
/// Returns its number.
template <int D>
int add_patch(std::vector<WallPatch<D>>& patches, std::size_t begin, int solid, const Vec<D>& area, const Spin<D>& moment)
{
    for (std::size_t k = begin; k < patches.size(); ++k)
        if (patches[k].solid == solid) {
            patches[k].area += area;
            patches[k].moment += moment;
            return static_cast<int>(k);
        }
    patches.push_back({solid, area, moment});
    return static_cast<int>(patches.size()) - 1;
}
/// Cells of a slab in 3D: the pieces of their faces that hang together are the parts. Fills the parts beside pieces, also of the slab above, and the cells' numbers.
CellSlab<3> build_cells(const Grid<3>& grid, const GridPlanes<3>& planes, const DenseIndex<3>& index,
                        const std::vector<PlacedSolid<3>>& solids, const CutFaces<3>& cut, const FacetsInCells& facets,
                        int slab_number, std::vector<PartsBeside>& beside, std::vector<std::int32_t>& cell);

/// Cells of a slab in 2D: the pieces of their rectangles are the parts. The same of one slab.
CellSlab<2> build_cells(const CutFaces<2>& cut, const DenseIndex<2>& index, const std::vector<PlacedSolid<2>>& solids,
                        int slab_number, PartsBeside& beside, std::vector<std::int32_t>& cell);

} // namespace gapflow
