#include "gapflow/complex/placed.hpp"

#include "gapflow/complex/complex.hpp"
#include "gapflow/complex/facet_area.hpp"
#include "gapflow/complex/facet_cut.hpp"
#include "gapflow/complex/parameters.hpp"
#include "gapflow/complex/plane_poses.hpp"
#include "gapflow/complex/sharp_features.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {

double rounded(double x)
{
    return place_unit * std::nearbyint(x / place_unit);
}

template <int D>
GridPlanes<D>::GridPlanes(const Grid<D>& grid) : anchor(grid.anchor()), dx(grid.dx())
{
    const DenseIndex<D> block(grid);
    for (int axis = 0; axis < D; ++axis) {
        const int cells = grid.cells()[axis], first = std::min(0, block.low[axis]), last = std::max(cells, block.high()[axis]);
        std::vector<double> places;
        for (int i = first; i <= last; ++i) // beyond the domain, where it is periodic: the core is all of it
            places.push_back(i < 0 || i > cells || (i >= grid.core_low()[axis] && i <= grid.core_high()[axis])
                                 ? i
                                 : rounded((grid.face_place(axis, i) - anchor[axis]) / dx));
        place[axis] = PlanePlaces(cells, first, std::move(places));
    }
}

namespace {

/// The sides that put_into_planes() has in planes of the grid, to the last bit: else a side would lie on either side of its plane, and its corners
/// and mouths in it.
template <int D>
void put_sides_into_planes(const GridPlanes<D>& planes, PlanesKind<D>& kind)
{
    for (int k = 0; k < kind.planes; ++k) {
        Vec<D>& normal = kind.normal[k];
        int along = 0;
        normal.cwiseAbs().maxCoeff(&along);
        bool parallel = true;
        for (int axis = 0; axis < D; ++axis)
            if (std::abs(normal[axis]) * kind.reach < in_plane)
                normal[axis] = 0;
            else
                parallel = parallel && axis == along;
        if (!parallel)
            continue;
        normal[along] = normal[along] > 0 ? 1 : -1;
        const double at = kind.centre[along] + normal[along] * kind.offset[k];
        if (const auto plane = plane_beside<D>(planes, along, at))
            kind.offset[k] = normal[along] * (*plane - kind.centre[along]); // exact
    }
}

/// The same of flat ends.
template <int D>
void put_ends_into_planes(const GridPlanes<D>& planes, RoundKind<D>& kind)
{
    const int along = axis_of<D>(kind.axis, std::hypot(kind.half, kind.radius));
    if (along < 0)
        return;
    kind.axis = (kind.axis[along] > 0 ? 1 : -1) * unit<D>(along);
    const double at = kind.centre[along];
    const auto low = plane_beside<D>(planes, along, at - kind.half), high = plane_beside<D>(planes, along, at + kind.half);
    if (low && high)
        kind.centre[along] = rounded(0.5 * (*low + *high));
    if (high)
        kind.half = *high - kind.centre[along];
    else if (low)
        kind.half = kind.centre[along] - *low;
}

/// Where a facet lies in a plane of the grid, the solid covers it, as sides of boxes do: FacetCut sees a plane infinitesimally above its place, so facets with the solid
/// below them go up by one unit. Otherwise a layer of no thickness would be fluid that belongs to the gaps beside it.
template <int D>
void cover_planes(const GridPlanes<D>& planes, bool inverse, FacetKind<D>& kind)
{
    const std::vector<Vec<D>> at = kind.vertices;
    for (const std::array<int, D>& facet : kind.surface->elements)
        for (int axis = 0; axis < D; ++axis) {
            const double place = at[facet[0]][axis];
            if (std::any_of(facet.begin(), facet.end(), [&](int v) { return at[v][axis] != place; }) ||
                plane_beside<D>(planes, axis, place) != place)
                continue;
            const bool enclosed_below = facet_area<D>(at, facet)[axis] > 0;
            if (enclosed_below != inverse)
                for (const int vertex : facet)
                    kind.vertices[vertex][axis] = place + place_unit;
        }
}

} // namespace

template <int D>
std::vector<PlacedSolid<D>> place_solids(const Grid<D>& grid, const GridPlanes<D>& planes, std::span<const Solid<D>> solids,
                                         const Vec<D>& low, const Vec<D>& high)
{
    Vec<D> period = Vec<D>::Zero();
    for (int axis = 0; axis < D; ++axis)
        if (grid.periodic(axis))
            period[axis] = grid.size()[axis];
    const Vec<D> margin = Vec<D>::Constant(2 * in_plane); // the solid is where its place is rounded to
    std::vector<PlacedSolid<D>> result;
    for (const Image<D>& image : images(solids, planes.in_world(low), planes.in_world(high), period, grid.dx())) {
        const Solid<D>& solid = solids[image.solid];
        if (solid.wall)
            continue;
        // The image's shift in whole cells, everything else from the solid itself: images are the same to the last bit.
        Vec<D> shift;
        for (int axis = 0; axis < D; ++axis)
            shift[axis] = std::nearbyint(image.shift[axis] / grid.dx());
        const auto at = [&](const Vec<D>& x) {
            const Vec<D> y = planes.in_cells(x);
            Vec<D> r;
            for (int axis = 0; axis < D; ++axis)
                r[axis] = rounded(y[axis]) + shift[axis];
            return r;
        };
        const Shape<D>& shape = solid.shape.shape();
        const Vec<D> centre = at(solid.shape.to_world(Vec<D>::Zero()));
        PlacedSolid<D> placed{FacetKind<D>{},
                              image.solid,
                              shape.inside_out(),
                              at(solid.centre),
                              planes.in_cells(image.bounds.low) - margin,
                              planes.in_cells(image.bounds.high) + margin,
                              image.shape,
                              {},
                              {},
                              {}};
        if (const auto radius = shape.sphere_radius())
            placed.kind = BallKind<D>{centre, *radius / grid.dx()};
        else if (const auto bar = shape.round_bar()) {
            RoundKind<D> kind{centre, Vec<D>(solid.shape.rotation().col(0)), bar->radius / grid.dx(), bar->half / grid.dx(),
                              bar->flat};
            if (bar->flat)
                put_ends_into_planes(planes, kind);
            placed.kind = kind;
            if constexpr (D == 3)
                if (bar->flat && !placed.inverse)
                    placed.sharp = sharp_solid(kind, planes);
        } else if (const auto faces = shape.planes(); !faces.empty()) {
            PlanesKind<D> kind;
            kind.planes = static_cast<int>(faces.size());
            for (int k = 0; k < kind.planes; ++k) {
                kind.normal[k] = solid.shape.rotation() * faces[k].normal;
                kind.offset[k] = faces[k].offset / grid.dx();
            }
            kind.centre = centre;
            kind.reach = kind.planes > 1 ? bounding_radius(shape.bounds()) / grid.dx() : 0;
            if (kind.reach > 0)
                put_sides_into_planes(planes, kind);
            placed.kind = kind;
            if (kind.planes > 1 && !placed.inverse) {
                if constexpr (D == 2)
                    placed.corners = corners_of(kind.section(0, 0));
                else
                    placed.sharp = sharp_solid(kind, planes);
            }
        } else {
            // Images of one solid share the surface; they come one after the other.
            FacetKind<D> kind;
            const auto* before = !result.empty() && result.back().solid == image.solid
                                     ? std::get_if<FacetKind<D>>(&result.back().kind)
                                     : nullptr;
            if (before) {
                kind.surface = before->surface;
                kind.links = before->links;
            } else {
                kind.surface = std::make_shared<SurfaceMesh<D>>(shape.display_mesh(0));
                kind.links = std::make_shared<std::vector<std::array<int, D>>>(
                    facet_links<D>(static_cast<int>(kind.surface->vertices.size()), kind.surface->elements));
            }
            for (const Vec<D>& x : kind.surface->vertices)
                kind.vertices.push_back(at(solid.shape.to_world(x)));
            if constexpr (D == 2)
                placed.corners = corners_of(kind.vertices, kind.surface->elements, *kind.links);
            else
                placed.sharp = sharp_solid(kind, planes);
            cover_planes(planes, placed.inverse, kind);
            placed.kind = std::move(kind);
        }
        result.push_back(std::move(placed));
    }
    return result;
}

template struct GridPlanes<2>;
template struct GridPlanes<3>;
template std::vector<PlacedSolid<2>> place_solids(const Grid<2>&, const GridPlanes<2>&, std::span<const Solid<2>>,
                                                  const Vec<2>&, const Vec<2>&);
template std::vector<PlacedSolid<3>> place_solids(const Grid<3>&, const GridPlanes<3>&, std::span<const Solid<3>>,
                                                  const Vec<3>&, const Vec<3>&);

} // namespace gapflow
