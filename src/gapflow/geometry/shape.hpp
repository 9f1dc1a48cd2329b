// Shapes in their own frame: exact signed distance, closest point with its feature, surface mesh, mass properties.
//
// The solid is where distance <= 0; normals point out of the solid, into the fluid.
#pragma once

#include "gapflow/core/types.hpp"

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gapflow {

/// Part of the surface on which the closest point lies. Smooth edges of a mesh (normals within 30 degrees) count as face.
enum class Feature { face, edge, corner };

template <int D>
struct SurfacePoint {
    Vec<D> x;        ///< closest point of the surface
    Vec<D> normal;   ///< out of the solid: of the face (mesh: of the smooth surface, angle-weighted pseudonormal at its
                     ///< smooth edges and vertices); on a sharp edge or corner, the direction from x to the query
                     ///< (from the query to x if that is inside)
    double distance; ///< signed, negative inside; |distance| = |query - x|
    Feature feature; ///< face, or sharp edge / corner (inside a convex solid always face). A query over a face's border
                     ///< within 1e-12 of the shape's size counts as over the face. 2D: corners only, no edges
    int patch;       ///< smooth patch (0 .. patches-1) of the closest face
};

/// A conforming triangulation (2D: chain of segments) of the whole surface, as coarse as the shape allows: vertices are
/// shared inside a patch and between patches; vertex order makes the normal point out of the solid
/// (2D: (x1 - x0) turned by -90 degrees).
template <int D>
struct SurfaceMesh {
    std::vector<Vec<D>> vertices;
    std::vector<std::array<int, D>> elements;
    std::vector<int> patch; ///< one for each element
};

template <int D>
struct MassProperties {
    double volume; ///< 2D: area. Of the shape itself, also where it is turned inside out
    Vec<D> centre; ///< centre of volume in the shape's frame
    Eigen::Matrix<double, spin_size<D>, spin_size<D>> inertia; ///< about the centre, at density 1
};

/// Half-space normal . x <= offset.
template <int D>
struct Plane {
    Vec<D> normal;
    double offset;
};

/// Points and segments whose surroundings within a radius belong to the solid and generate its round surface:
/// the centre of a ball, the axis of a capsule or cylinder.
template <int D>
struct Core {
    Vec<D> from, to; ///< equal: a point
    double radius;
};

/// Points within a radius of the stretch -half .. half of the x axis: a capsule; with flat ends a cylinder.
struct RoundBar {
    double radius, half;
    bool flat;
};

template <int D>
struct Bounds {
    Vec<D> low = Vec<D>::Constant(-std::numeric_limits<double>::infinity());
    Vec<D> high = Vec<D>::Constant(std::numeric_limits<double>::infinity());
};

/// A solid in its own frame. Immutable; all queries are thread-safe.
template <int D>
class Shape {
public:
    virtual ~Shape() = default;

    virtual SurfacePoint<D> closest(const Vec<D>& x) const = 0;
    /// Signed distance alone (cheaper).
    virtual double distance(const Vec<D>& x) const { return closest(x).distance; }
    /// How far it is along a ray from x, outside the solid, in the direction of the unit vector u to where it first enters the solid; infinity: nowhere.
    /// Empty: there is no closed form.
    virtual std::optional<double> entry(const Vec<D>& x, const Vec<D>& u) const
    {
        (void)x, (void)u;
        return {};
    }
    /// Point of the given patch next to x, a point near it: where a new vertex of a refined surface mesh goes. Flat patches:
    /// of its plane (identity on it). Curved patches: radially from centre or axis, coordinates along the axis kept; the
    /// patch's continuation past its border, where x is past it. Meshes: the closest point of the patch's facets.
    /// A new vertex on an edge between two patches goes onto both, in either order: that leaves it on their common border
    /// (the rim of a cylinder).
    virtual Vec<D> onto(const Vec<D>& x, int patch) const = 0;
    /// Normal of the given patch at x, a point of it; on the patch's border still that of this patch, never of the edge.
    virtual Vec<D> patch_normal(const Vec<D>& x, int patch) const = 0;
    /// Largest principal curvature of a patch in magnitude, positive where the solid is convex; 0: flat. Meshes: 0 if planar
    /// within 1e-6 of the patch's size, else estimated from the turn of the facets' normals (upper quartile over the bent
    /// part, good to some 20 %).
    virtual double curvature(int patch) const = 0;
    /// Normal curvature of a patch in the direction from its point a to its point b, with the sign of curvature(): the turn of the
    /// normal over that distance. Meshes, and points that coincide: the largest.
    virtual double curvature_along(int patch, const Vec<D>& a, const Vec<D>& b) const
    {
        (void)a, (void)b; // as much in all directions
        return curvature(patch);
    }
    /// Base mesh for films. Curved patches: elements of at most 45 degrees. Unbounded shapes (half-space): empty.
    virtual SurfaceMesh<D> surface_mesh() const = 0;
    /// For display: the surface within `tolerance` of the exact one (as far as 4096 segments around, 3D balls 327680
    /// triangles, allow). Meshes: their own facets. Unbounded shapes: empty.
    virtual SurfaceMesh<D> display_mesh(double tolerance) const = 0;
    /// Exact. Unbounded shapes: infinite volume and inertia about the origin.
    virtual MassProperties<D> mass_properties() const = 0;
    /// Bounds of the surface (not of the solid, where it is inside out).
    virtual Bounds<D> bounds() const = 0;
    /// Planes whose intersection is the solid (box, half-space); empty for all other shapes. If complement() the solid is
    /// everything outside that intersection.
    virtual std::vector<Plane<D>> planes() const { return {}; }
    virtual bool complement() const { return false; }
    /// Radius of the surface, if it is a sphere (2D: a circle) about the frame's origin; empty for all other shapes.
    virtual std::optional<double> sphere_radius() const { return {}; }
    /// What the surface is, if a capsule's or a cylinder's; empty for all other shapes.
    virtual std::optional<RoundBar> round_bar() const { return {}; }
    /// The solid is the outside of its surface (every shape turned inside out).
    virtual bool inside_out() const { return false; }
    /// The solid is convex: the nearest point on it is unique for every point of the fluid.
    virtual bool convex() const { return true; }
    /// The cores of the shape's curved parts, if they are round; empty for all other shapes and shapes turned inside out.
    virtual std::vector<Core<D>> cores() const { return {}; }
};

// All lengths are in the scene's unit; lengths that are not positive and finite throw InputError.

/// Box centred at the origin. Patches: 2 axis + (0 low, 1 high).
template <int D>
std::unique_ptr<Shape<D>> make_box(const Vec<D>& size);
/// Ball (2D: disk) about the origin; one patch.
template <int D>
std::unique_ptr<Shape<D>> make_ball(double radius);
/// Points within `radius` of a segment of the given length along x, centred at the origin. Patches: 0 the cap at low x, 1 at
/// high x, 2 the side (2D: 2 the side at low y, 3 at high y).
template <int D>
std::unique_ptr<Shape<D>> make_capsule(double radius, double length);
/// Circular cylinder along x with flat ends, centred at the origin. Patches: 0 the end at low x, 1 at high x, 2 the side.
std::unique_ptr<Shape<3>> make_cylinder(double radius, double length);
/// Everything behind the plane through the origin with this outward normal (of any length).
template <int D>
std::unique_ptr<Shape<D>> make_half_space(const Vec<D>& normal);
/// Closed triangle mesh, OBJ or STL (3D), or polygon file (2D: one "x y" per line, closed on itself, blank line between loops,
/// '#' comments; holes run the other way round). Coordinates times `scale`; the frame is the file's, the centre of volume
/// anywhere. Vertices that the file repeats are welded (3D). Checks that it is watertight and consistently oriented (turns
/// it if wholly inside out; a part inside another must be a cavity) and does not cut itself. Throws InputError naming the
/// file and the first bad edge or pair of facets.
template <int D>
std::unique_ptr<Shape<D>> make_mesh(const std::string& file, double scale);
/// The same of a surface in memory; `name` is its name in messages.
template <int D>
std::unique_ptr<Shape<D>> make_mesh(SurfaceMesh<D> surface, const std::string& name);
/// The same surface with the solid on its other side (containers).
template <int D>
std::unique_ptr<Shape<D>> make_inside_out(std::unique_ptr<Shape<D>> shape);

} // namespace gapflow
