#include "gapflow/stepping/placement.hpp"

#include <algorithm>
#include <cstdio>

namespace gapflow
{

namespace
{

template <int D>
bool bounded(const RigidBody<D>& body)
{
    const Bounds<D> bounds = body.shape->bounds();
    return bounds.low.allFinite() && bounds.high.allFinite() && !(bounds.low.array() > bounds.high.array()).any();
}

/// Vertices of a body's surface and its centre in the world, and the box that holds them.
template <int D>
struct Surface {
    std::vector<Vec<D>> points; ///< none of a shape without bounds
    Vec<D> low, high;
    bool solid_inside = true;
};

template <int D>
Surface<D> surface_of(const RigidBody<D>& body, double tolerance)
{
    Surface<D> surface;
    surface.solid_inside = !body.shape->complement();
    if (!bounded(body))
        return surface;
    const Mat<D> rotation = body.pose.matrix();
    for (const Vec<D>& x : body.shape->display_mesh(tolerance).vertices)
        surface.points.push_back(body.pose.position + rotation * x);
    if (body.shape->distance(body.centre_of_mass) < 0) // finds bodies of one shape at one place
        surface.points.push_back(body.centre());
    surface.low = surface.high = surface.points.front();
    for (const Vec<D>& x : surface.points) {
        surface.low = surface.low.cwiseMin(x);
        surface.high = surface.high.cwiseMax(x);
    }
    return surface;
}

/// Of solids with bounds: whether their boxes have nothing in common.
template <int D>
bool apart(const Surface<D>& a, const Surface<D>& b)
{
    if (a.points.empty() || b.points.empty() || !a.solid_inside || !b.solid_inside)
        return false;
    return (a.low.array() > b.high.array()).any() || (b.low.array() > a.high.array()).any();
}

/// Beyond a side of the domain; what is beyond a periodic one comes in on the other.
template <int D>
bool outside(const Surface<D>& surface, const Scene& scene)
{
    if (surface.points.empty() || !surface.solid_inside)
        return false;
    for (int axis = 0; axis < D; ++axis) {
        const double low = scene.origin[axis], high = low + scene.size[axis];
        if (scene.sides[2 * axis].kind != SideScene::Kind::periodic && (surface.low[axis] > high || surface.high[axis] < low))
            return true;
    }
    return false;
}

/// How deep a solid holds the deepest point of a surface; 0 if it holds none.
template <int D>
double depth_in(const Solid<D>& solid, const Surface<D>& surface)
{
    double deepest = 0;
    for (const Vec<D>& x : surface.points)
        deepest = std::max(deepest, -solid.shape.closest(x).distance);
    return deepest;
}

} // namespace

template <int D>
std::vector<std::string> placement_warnings(const Scene& scene, const std::vector<RigidBody<D>>& bodies,
                                            const DomainWalls<D>& walls)
{
    const double dx = scene.size[0] / scene.cells[0];
    const std::vector<Solid<D>> solids = make_solids<D>(bodies, walls);
    std::vector<Surface<D>> surfaces;
    for (const RigidBody<D>& body : bodies)
        surfaces.push_back(surface_of(body, 0.1 * dx));

    std::vector<std::string> warnings;
    for (std::size_t a = 0; a < bodies.size(); ++a) {
        if (outside(surfaces[a], scene) && bodies[a].motion != Motion::prescribed)
            warnings.push_back("body '" + bodies[a].name +
                               "' lies outside the domain, where there is no fluid; put it inside, or remove it");
        for (std::size_t b = a + 1; b < solids.size(); ++b) {
            const bool is_body = b < bodies.size();
            const bool free = bodies[a].motion == Motion::free || (is_body && bodies[b].motion == Motion::free);
            if ((!is_body && !free) || (is_body && apart(surfaces[a], surfaces[b])))
                continue;
            double depth = depth_in(solids[b], surfaces[a]);
            if (is_body)
                depth = std::max(depth, depth_in(solids[a], surfaces[b]));
            if (!(depth > dx))
                continue;
            char text[64];
            std::snprintf(text, sizeof text, "overlap by %.3g (%.3g cells) at the start; ", depth, depth / dx);
            warnings.push_back("'" + bodies[a].name + "' and '" + solids[b].name + "' " + text +
                               (free ? "contact will push them apart: better move them" : "they count as one solid there"));
        }
    }
    return warnings;
}

template std::vector<std::string> placement_warnings<2>(const Scene&, const std::vector<RigidBody<2>>&, const DomainWalls<2>&);
template std::vector<std::string> placement_warnings<3>(const Scene&, const std::vector<RigidBody<3>>&, const DomainWalls<3>&);

} // namespace gapflow
