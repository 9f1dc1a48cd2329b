// Borders of the parts of cut cells as polygons, for pictures.
#pragma once

#include "gapflow/complex/complex.hpp"
#include "gapflow/complex/cut_faces.hpp"

#include <vector>

namespace gapflow {

/// A side of a part's polygon (2D: a straight line, the part at its left), or a face of its polyhedron (3D: counterclockwise from outside).
/// In cells. Chords stand for curves. In 3D a solid's wall inside the cell is a polygon from its border on the cell's faces, or triangles from there to
/// the point of the solid next to the polygon's middle; where walls meet, or end at a dividing plane, each has its part of that border and the
/// mean of the points between.
template <int D>
struct PartFace {
    static constexpr std::int32_t open = -1,
                                  dividing = -2; ///< on a plane of the grid; on the line or plane from a sharp corner or edge
    std::int32_t part;
    std::int32_t solid; ///< whose wall it is, or open, or dividing
    std::int32_t wall;  ///< which of the part's connected walls it belongs to; -1: none
    std::vector<Vec<D>> points;
    /// 3D, of a face on a plane of the grid: whose wall the side from each point to the next is; open on an edge of the grid, dividing also on a cut to a hole.
    std::vector<std::int32_t> sides = {};

    /// Area vector out of the part (2D: of the line).
    Vec<D> area() const;
    /// 1/D of the integral of x . n about a point: sums up to the part's volume.
    double volume(const Vec<D>& about) const;
};

/// Part by part; in 2D side by side along the outline, then along that of each hole.
template <int D>
using PartBorders = std::vector<PartFace<D>>;

/// One loop of the first one, which goes around, and holes: straight cuts lead to and fro between nearest points.
template <int D>
std::vector<Vec<D>> with_holes(const std::vector<std::vector<Vec<D>>>& loops);

/// `cut` with its facets kept; `parts_beside` of each piece of each slab: parts below and above it (2D: the first is the piece's part). build_complex calls it.
template <int D>
PartBorders<D> part_borders(const Grid<D>& grid, const GridPlanes<D>& planes, const Complex<D>& complex,
                            const std::vector<PlacedSolid<D>>& solids, const CutFaces<D>& cut,
                            const std::vector<std::vector<std::array<PartOrCell, 2>>>& parts_beside);

} // namespace gapflow
