#include "gapflow/complex/plane_poses.hpp"

#include "gapflow/complex/facet_area.hpp"
#include "gapflow/complex/parameters.hpp"

#include <cmath>

namespace gapflow {
namespace {

Mat<2> turned_to(const Vec<2>& from, const Vec<2>& to)
{
    Mat<2> turn;
    turn << from.dot(to), from[1] * to[0] - from[0] * to[1], from[0] * to[1] - from[1] * to[0], from.dot(to);
    return turn;
}
Mat<3> turned_to(const Vec<3>& from, const Vec<3>& to)
{
    return Rotation<3>::FromTwoVectors(from, to).toRotationMatrix();
}

Rotation<2> rotation_from(const Mat<2>& matrix)
{
    return Rotation<2>(matrix);
}
Rotation<3> rotation_from(const Mat<3>& matrix)
{
    return Rotation<3>(matrix).normalized();
}

/// The planes of flat sides and ends, or of all facets.
template <int D>
std::vector<Plane<D>> sides_of(const Shape<D>& shape)
{
    if (const auto bar = shape.round_bar())
        return bar->flat ? std::vector<Plane<D>>{{-unit<D>(0), bar->half}, {unit<D>(0), bar->half}} : std::vector<Plane<D>>{};
    std::vector<Plane<D>> sides = shape.planes();
    if (!sides.empty() || shape.sphere_radius())
        return sides;
    const SurfaceMesh<D> mesh = shape.display_mesh(0);
    for (const std::array<int, D>& facet : mesh.elements) {
        const Vec<D> normal = facet_area<D>(mesh.vertices, facet);
        if (const double length = normal.norm(); length > 0)
            sides.push_back({normal / length, normal.dot(mesh.vertices[facet[0]]) / length});
    }
    return sides;
}

/// Turns the sides that are nearly parallel to planes.
template <int D>
void turn(const std::vector<Plane<D>>& sides, double reach, PlacedShape<D>& shape)
{
    Mat<D> rotation = shape.rotation();
    bool turned = false;
    for (const Plane<D>& side : sides) {
        const Vec<D> normal = rotation * side.normal;
        const int along = axis_of<D>(normal, reach);
        if (along < 0 || std::abs(normal[along]) == normal.template lpNorm<1>())
            continue;
        rotation = turned_to(normal, Vec<D>((normal[along] > 0 ? 1 : -1) * unit<D>(along))) * rotation;
        turned = true;
    }
    if (turned)
        shape = PlacedShape<D>(shape.shape(), {shape.to_world(Vec<D>::Zero()), rotation_from(rotation)});
}

/// By what the sides that are nearest to planes lie beside them.
template <int D>
Vec<D> way_into_planes(const std::vector<Plane<D>>& sides, double reach, const GridPlanes<D>& planes,
                       const PlacedShape<D>& shape)
{
    Vec<D> way = Vec<D>::Zero(), nearest = Vec<D>::Constant(in_plane);
    for (const Plane<D>& side : sides) {
        const int along = axis_of<D>(shape.rotation() * side.normal, reach);
        if (along < 0)
            continue;
        const double at = planes.in_cells(shape.to_world(side.offset * side.normal))[along];
        if (const auto plane = plane_beside<D>(planes, along, at); plane && std::abs(*plane - at) < nearest[along]) {
            nearest[along] = std::abs(*plane - at);
            way[along] = *plane - at;
        }
    }
    return planes.dx * way;
}

} // namespace

template <int D>
int axis_of(const Vec<D>& normal, double reach)
{
    int along = 0;
    normal.cwiseAbs().maxCoeff(&along);
    for (int axis = 0; axis < D; ++axis)
        if (axis != along && !(std::abs(normal[axis]) * reach < in_plane))
            return -1;
    return along;
}

template <int D>
std::optional<double> plane_beside(const GridPlanes<D>& planes, int axis, double at)
{
    const PlanePlaces& places = planes.place[axis];
    const bool beyond = at < places[places.first()] || at > places[places.last()];
    const double shift = beyond ? places.period() * std::floor((at - places.front()) / places.period()) : 0.0;
    const int cell = places.at_or_below(at - shift);
    for (const int plane : {cell, cell + 1})
        if (plane >= places.first() && plane <= places.last() && std::abs(places[plane] + shift - at) < in_plane)
            return places[plane] + shift;
    return {};
}

template <int D>
void put_into_planes(const Grid<D>& grid, std::vector<Solid<D>>& solids)
{
    const GridPlanes<D> planes(grid);
    for (Solid<D>& solid : solids) {
        if (solid.wall)
            continue;
        const std::vector<Plane<D>> sides = sides_of(solid.shape.shape());
        if (sides.size() < 2)
            continue;
        const double reach = bounding_radius(solid.shape.shape().bounds()) / planes.dx;
        turn<D>(sides, reach, solid.shape);
        if (const Vec<D> way = way_into_planes<D>(sides, reach, planes, solid.shape); !way.isZero(0)) {
            solid.shape = solid.shape.shifted(way);
            solid.centre += way;
        }
    }
}

template int axis_of<2>(const Vec<2>&, double);
template int axis_of<3>(const Vec<3>&, double);
template std::optional<double> plane_beside(const GridPlanes<2>&, int, double);
template std::optional<double> plane_beside(const GridPlanes<3>&, int, double);
template void put_into_planes<2>(const Grid<2>&, std::vector<Solid<2>>&);
template void put_into_planes<3>(const Grid<3>&, std::vector<Solid<3>>&);

} // namespace gapflow
