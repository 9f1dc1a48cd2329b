// Poses of boxes whose sides lie in planes of the grid to round-off (theory of the complex, "Cells, faces, parts").
#pragma once

#include "gapflow/complex/placed.hpp"
#include "gapflow/geometry/solid.hpp"
#include "gapflow/grid/grid.hpp"

#include <optional>
#include <vector>

namespace gapflow {

/// In cells. More than ComplexParameters::joint_distance, since of slivers that thick some joints are found and some are not: two plates turned by
/// 1e-8 degrees have added masses that differ by 2e-3 from those at 0 and at 1e-7.
inline constexpr double in_plane = 4e-9;

/// The axis along which a direction points, as far as `reach` tells within in_plane; -1: none.
template <int D>
int axis_of(const Vec<D>& normal, double reach);

/// The plane of the grid within in_plane of a place, in cells; also of those beyond the domain by whole lengths of it.
template <int D>
std::optional<double> plane_beside(const GridPlanes<D>& planes, int axis, double at);

/// Boxes, polygons, meshes and cylinders with sides nearer to planes of the grid than in_plane, parallel to them as far, are turned and shifted into these, with their reference points.
/// So all that asks for a solid's surface finds it where the complex has it (placed.hpp), and what lies in a plane has no corner on either side of it.
template <int D>
void put_into_planes(const Grid<D>& grid, std::vector<Solid<D>>& solids);

} // namespace gapflow
