// Gaps as the faces of the grid cut them: the walls, the thickness between them, and the way along a gap from node to node.
#pragma once

#include "gapflow/complex/gap_arm.hpp"
#include "gapflow/complex/parameters.hpp"
#include "gapflow/complex/placed.hpp"

#include <algorithm>
#include <functional>
#include <optional>

namespace gapflow {

/// n . v of a solid's twist at x.
template <int D>
Twist<D> speed_along(const Vec<D>& n, const Vec<D>& x, const Vec<D>& reference)
{
    Twist<D> row;
    const Vec<D> r = x - reference;
    if constexpr (D == 2)
        row << n, r[0] * n[1] - r[1] * n[0];
    else
        row << n, r.cross(n);
    return row;
}

/// A gap along the line through x along n.
template <int D>
struct GapSection {
    double thickness;
    Vec<D> middle;
    std::array<Vec<D>, 2> normal; ///< out of the walls
    PairTwist<D> opening;         ///< rate of the thickness
    Vec<D> slope;                 ///< rate of the thickness where both walls move with the velocity U: slope . U
};

/// Two walls that face each other. Places in cells.
template <int D>
class GapWalls {
public:
    std::array<PlacedShape<D>, 2> shape;
    std::array<Vec<D>, 2> reference;
    const GridPlanes<D>* planes;

    /// Nothing where a wall ends, or where the walls overlap.
    std::optional<GapSection<D>> across(Vec<D> x, const Vec<D>& n) const
    {
        GapSection<D> section;
        for (int pass = 0; pass < 2; ++pass) { // the second one from the middle
            std::array<double, 2> way, cosine;
            for (int side = 0; side < 2; ++side) {
                const SurfacePoint<D> at = shape[side].closest(planes->in_world(x));
                cosine[side] = (side == 0 ? 1 : -1) * n.dot(at.normal);
                if (at.feature != Feature::face || cosine[side] < parameters.least_facing)
                    return {};
                way[side] = at.distance / planes->dx / cosine[side];
                section.normal[side] = at.normal;
                section.opening.template segment<twist_size<D>>(side * twist_size<D>) =
                    speed_along<D>(-at.normal / cosine[side], planes->in_cells(at.x), reference[side]);
            }
            section.thickness = way[0] + way[1];
            if (!(section.thickness > 0))
                return {};
            x += 0.5 * (way[1] - way[0]) * n;
            section.slope = -section.normal[0] / cosine[0] - section.normal[1] / cosine[1];
        }
        section.middle = x;
        return section;
    }
};

/// Of the closing of a gap.
template <int D>
struct ClosingFlow {
    Mat<D> shares;        ///< that flow in each direction of the gap's plane, of trace 1
    double curvature = 0; ///< trace of the thickness' Hessian

    /// Flux at a place, over the rate at which the thickness t grows: -grad t / tr Hess t. A quadratic thickness that is positive everywhere has
    /// at least the curvature |grad t|^2 / 2t: that of a wedge, whose flux goes with t. `thickness`: of the gap; without slope there is no flux.
    Vec<D> flux(const GapSection<D>& at, const Vec<D>& n, double thickness) const
    {
        const Vec<D> slope = at.slope - n.dot(at.slope) * n;
        const double faint = parameters.faint_curvature * thickness;
        return at.thickness / (std::max(curvature * at.thickness, 0.5 * slope.squaredNorm()) + 2 * faint * faint) * slope;
    }
};

ClosingFlow<2> closing_flow(const GapWalls<2>& walls, const Vec<2>& x, const Vec<2>& n, double thickness);
ClosingFlow<3> closing_flow(const GapWalls<3>& walls, const Vec<3>& x, const Vec<3>& n, double thickness);

/// Gauss points of 0 .. 1, and the weights of integrals from 0 to each of them.
struct ThreePoints {
    static constexpr double root = 3.872983346207417; // of 15
    static constexpr std::array<double, 3> node{0.5 - root / 10, 0.5, 0.5 + root / 10}, weight{5.0 / 18, 4.0 / 9, 5.0 / 18};
    static constexpr std::array<std::array<double, 3>, 3> collocation{{{5.0 / 36, 2.0 / 9 - root / 15, 5.0 / 36 - root / 30},
                                                                       {5.0 / 36 + root / 24, 2.0 / 9, 5.0 / 36 - root / 24},
                                                                       {5.0 / 36 + root / 30, 2.0 / 9 + root / 15, 5.0 / 36}}};
};

/// A piece of a face in a gap.
template <int D>
struct GapSite {
    std::int32_t piece;
    std::array<std::int32_t, 2> solid;
    std::array<bool, 2> still; ///< closed sides of the domain: they never move
    GapWalls<D> walls;
    Vec<D> n;           ///< from the first wall to the second one
    GapSection<D> here; ///< at the piece's centroid
    // The way from node to node is centroid + s way, middle - 1/2 <= s <= middle + 1/2.
    double delta = 1; ///< distance of the nodes along the face's axis
    Vec<D> e = Vec<D>::Zero(), way = Vec<D>::Zero();
    double middle = 0;
    // 3D: the piece lies around centroid + s line, from <= s <= to or the other way round.
    Vec<D> line = Vec<D>::Zero();
    double from = 0, to = 0;

    bool along_face() const { return !(way.norm() > parameters.parallel); }
};

/// Of all pieces of the complex that lie in gaps, in their order.
template <int D>
void for_each_gap(const Grid<D>& grid, std::span<const Solid<D>> solids, const Complex<D>& complex,
                  const std::function<void(const GapSite<D>&)>& visit);

} // namespace gapflow
