// Solids in the units of the complex.
#pragma once

#include "gapflow/complex/convex.hpp"
#include "gapflow/complex/corner.hpp"
#include "gapflow/geometry/solid.hpp"
#include "gapflow/grid/grid.hpp"

#include <memory>
#include <variant>

namespace gapflow {

/// Places of the grid's planes, in cells.
template <int D>
struct GridPlanes {
    std::array<std::vector<double>, D> place; ///< of planes 0 .. cells
    Vec<D> anchor;
    double dx;

    explicit GridPlanes(const Grid<D>& grid);
    /// Cell along an axis that holds x; not clipped to the domain where the grid is uniform.
    int cell_of(int axis, double x) const;
    /// Of a plane, in a periodic domain also of one beyond its sides (a cell beyond at most).
    double place_of(int axis, int plane) const
    {
        const auto& p = place[axis];
        const int n = static_cast<int>(p.size()) - 1;
        return plane < 0 ? p[n + plane] - p[n] + p[0] : plane > n ? p[plane - n] - p[0] + p[n] : p[plane];
    }
    Vec<D> in_cells(const Vec<D>& x) const { return (x - anchor) / dx; }
    Vec<D> in_world(const Vec<D>& x) const { return anchor + dx * x; }
};

/// Rounded to a multiple of 2^-36: sums with whole numbers below 2^16 are exact.
double rounded(double x);

/// A closed surface of facets: meshes and polygons.
template <int D>
struct FacetKind {
    std::vector<Vec<D>> vertices; ///< in cells, rounded
    std::shared_ptr<const SurfaceMesh<D>> surface;
    std::shared_ptr<const std::vector<std::array<int, D>>> links; ///< facet_links
};

template <int D>
struct PlacedSolid {
    std::variant<BallKind<D>, PlanesKind<D>, RoundKind<D>, FacetKind<D>> kind;
    int solid;
    bool inverse;     ///< the solid is what lies outside
    Vec<D> reference; ///< point of its twist
    Vec<D> low, high; ///< a box around its surface
    PlacedShape<D> shape;
    std::vector<SharpCorner> corners; ///< 2D: those that divide the fluid
    SharpSolid sharp;                 ///< 3D: the same
};

/// Images of the solids that meet the box low .. high (in cells), but walls.
template <int D>
std::vector<PlacedSolid<D>> place_solids(const Grid<D>& grid, const GridPlanes<D>& planes, std::span<const Solid<D>> solids,
                                         const Vec<D>& low, const Vec<D>& high);

} // namespace gapflow
