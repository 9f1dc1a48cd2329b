// Solids in the units of the complex.
#pragma once

#include "gapflow/complex/convex.hpp"
#include "gapflow/complex/corner.hpp"
#include "gapflow/geometry/solid.hpp"
#include "gapflow/grid/grid.hpp"

#include <algorithm>
#include <memory>
#include <utility>
#include <variant>

namespace gapflow {

/// Places of the planes normal to an axis, by their numbers: those of the domain, and those beyond that the rank's block has (DenseIndex).
class PlanePlaces {
public:
    PlanePlaces() = default;
    /// `cells` of the domain; the first of the places is that of the plane `first`.
    PlanePlaces(int cells, int first, std::vector<double> places) : cells_(cells), first_(first), place_(std::move(places)) {}

    const double& operator[](int plane) const { return place_[plane - first_]; }
    int cells() const { return cells_; }
    int first() const { return first_; }
    int last() const { return first_ + static_cast<int>(place_.size()) - 1; }
    /// Of the domain's sides.
    double front() const { return (*this)[0]; }
    double back() const { return (*this)[cells_]; }
    double period() const { return back() - front(); }
    /// The last plane that is not above x, one before the first where there is none; and the last one below it.
    int at_or_below(double x) const
    {
        return first_ - 1 + static_cast<int>(std::ranges::upper_bound(place_, x) - place_.begin());
    }
    int below(double x) const { return first_ - 1 + static_cast<int>(std::ranges::lower_bound(place_, x) - place_.begin()); }

private:
    int cells_ = 0, first_ = 0;
    std::vector<double> place_;
};

/// Places of the grid's planes, in cells.
template <int D>
struct GridPlanes {
    std::array<PlanePlaces, D> place;
    Vec<D> anchor;
    double dx;

    explicit GridPlanes(const Grid<D>& grid);
    /// Cell along an axis that holds x; one before the first or the last plane beyond them.
    int cell_of(int axis, double x) const { return place[axis].at_or_below(x); }
    /// Of a plane, in a periodic domain also of one beyond those that are stored.
    double place_of(int axis, int plane) const
    {
        const PlanePlaces& p = place[axis];
        return plane < p.first()  ? p[plane + p.cells()] - p.period()
               : plane > p.last() ? p[plane - p.cells()] + p.period()
                                  : p[plane];
    }
    double centre_of(int axis, int cell) const { return 0.5 * (place_of(axis, cell) + place_of(axis, cell + 1)); }
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
    std::vector<LineInCell> lines;    ///< 2D: where their lines go on in the cells beside their own
    SharpSolid sharp;                 ///< 3D: the same
};

/// Images of the solids that meet the box low .. high (in cells), but walls.
template <int D>
std::vector<PlacedSolid<D>> place_solids(const Grid<D>& grid, const GridPlanes<D>& planes, std::span<const Solid<D>> solids,
                                         const Vec<D>& low, const Vec<D>& high);

} // namespace gapflow
