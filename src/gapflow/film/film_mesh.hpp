// The mid-gap mesh of a film (method, "Mesh"): the part of the master's surface that faces another body across a gap
// thinner than h_c, refined to the gap's scales, cut at the film's end and moved to mid-gap.
//
// A surface point x of the master A is in the gap of B if B is the nearest of all other bodies, h(x) = distance to B < h_c,
// n_A . n_B < -1/2, and the closest features of both are faces. One FilmMesh is one connected piece on which A's normal is
// continuous (within 30 degrees from element to element) and B's closest point stays on one patch.
#pragma once

#include "gapflow/geometry/pose.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

namespace gapflow {

/// Cosine that the normals of facing surfaces must not exceed.
inline constexpr double facing_cosine = -0.5;

/// Why a film ends at an edge of its rim (2D: at an end point).
enum class RimEnd {
    master_edge, ///< the master's surface ends there at a sharp edge
    other_edge,  ///< the other's closest feature becomes a sharp edge or corner
    thickness,   ///< h reaches h_c
    normals,     ///< the surfaces no longer face each other
    third_body,  ///< another body (or image) is nearer beyond
    touching,    ///< the surfaces touch and are at rest: one solid from there on
    patch        ///< the closest point jumps to another patch of the other body
};

/// Least cosine that counts between an element's normal and the other's. Films end where the surfaces' normals differ by 60 degrees, and the element's lies
/// between; only an element that is no plane in its gap exceeds that, and has a volume still.
inline constexpr double least_cosine = 0.5;

template <int D>
struct FilmElement {
    std::array<int, D> nodes;
    std::array<Vec<D>, D> gradient; ///< of the linear shape functions, tangential to the mid-gap element
    Vec<D> normal;                  ///< of the mid-gap element, from the master to the other
    Vec<D> centroid;                ///< at mid-gap
    Vec<D> centroid_master;         ///< on the master
    Vec<D> centroid_other;          ///< on the other
    Vec<D> into_other;              ///< unit normal into the other, mean over the element's points
    Vec<D> place_on_other;          ///< the points' mean position on the other
    double measure;                 ///< area (2D: length) at mid-gap
    double volume;  ///< S = int h n.d of its part of the gap, d the unit vector to the other along which h is measured
    Vec<D> lean;    ///< tangential part of int h d: S times the tangent of the angle between d and the normal
    double inverse; ///< I = int 1/(h n.d), exact for h linear over each quadrature point's piece
    double lateral; ///< over which the gap doubles: sqrt(2 h R), least h of its nodes; infinite between flat surfaces
    bool coarse;    ///< larger than the gap's lateral scale requires: uses the harmonic conductance

    /// Of the angle between d and the normal.
    double cosine() const { return 1 / std::sqrt(1 + lean.squaredNorm() / (volume * volume)); }
    /// Conductance at density 1 times the gradients' product: S, on coarse elements the harmonic mean's (measure)^2 / I.
    double conductance() const { return coarse ? measure * measure / inverse : volume; }
};

/// Boundary edge of the mesh (2D: end point).
template <int D>
struct RimEdge {
    std::array<int, D - 1> nodes;
    int element;
    RimEnd end;
    Vec<D> outward; ///< unit conormal: in the element's plane, out of the film, normal to the edge
    double length;  ///< 2D: 1
};

/// A share of the other's surface, as an area vector that points into the other (out of the fluid).
template <int D>
struct WallShare {
    Vec<D> area, centroid;
};

/// How a quadrature point says its share of the other's surface (wall_share()).
template <int D>
struct PointShare {
    double fraction; ///< of the flat simplex of its element's y_0..y_{D-1}
};
template <>
struct PointShare<2> {
    WallShare<2> share; ///< curved walls have other shares than their chord
};

/// Quadrature point: a piece of an element, cut so that the closest points y lie in one grid cell.
template <int D>
struct FilmPoint : PointShare<D> {
    int element;
    std::array<double, D> shape; ///< shape functions (barycentric coordinates) at the piece's centroid
    double weight;               ///< measure of the piece at mid-gap
    double h;                    ///< thickness there, not less than the floor
    Vec<D> x, y;                 ///< on the master and on the other
    Vec<D> other_normal;         ///< unit, out of the other
};

template <int D>
struct FilmMesh {
    int master = -1, other = -1;   ///< solids
    Vec<D> shift = Vec<D>::Zero(); ///< of the other's image that faces the master's (periodic domains)
    int other_patch = 0;           ///< of the other; where several join smoothly, the lowest of them
    std::vector<Vec<D>> x, y, mid; ///< nodes: on the master, closest point on the other, mid-gap
    std::vector<double> h;         ///< at the nodes, not less than the floor; less `skin` where that is not 0
    double skin = 0;               ///< subtracted from h everywhere: the part of the gap without flow
    std::vector<FilmElement<D>> elements;
    std::vector<RimEdge<D>> rim;
    std::vector<FilmPoint<D>> points;
    bool viscous = false; ///< FilmMeshOptions::viscous
    bool flat = false;    ///< both surfaces flat here
    bool capped = false;  ///< the limit on nodes keeps elements coarser than required

    /// Calls f with all of its fields.
    template <class F>
    void each_field(F&& f)
    {
        f(master, other, shift, other_patch, x, y, mid, h, skin, elements, rim, points, viscous, flat, capped);
    }
};

/// Of a point of the mesh, on the flat simplex of its element's y_0..y_{D-1}: an element's shares sum to the simplex.
template <int D>
WallShare<D> wall_share(const FilmMesh<D>& mesh, const FilmPoint<D>& point);

struct FilmMeshOptions {
    double dx = 1;                  ///< grid spacing
    double threshold = 0.5;         ///< h_c, a length
    double floor = 1e-9;            ///< h_floor, a length
    std::optional<double> touching; ///< no gap where the distance is no more than this, a length
    double largest = 0.5;           ///< element size, in dx
    double largest_curved = 0.5;    ///< the same where a surface is curved
    double curved = 0.2;            ///< element size in sqrt(2 R h), where a surface is curved
    double smallest = 0.0;          ///< element size, in dx, never refined below; 0: default (2D 1e-4, 3D 1/32)
    double straddle = 0.125;        ///< size of elements cut by the film's end, in dx
    double straddle_open = 0.125;   ///< the same where the bulk's fluid is beyond: at the other's edges, or where h reaches h_c
    double straddle_smooth = 0.125; ///< the same where the film ends between smooth curved surfaces (at no edge and no patch)
    double kink = 0.03;             ///< of a cut's length: how far the film's end may lie from a straight line (3D)
    double rings = 0;     ///< between a ball and a convex body: rings about the nearest point, in sqrt(2 R h) (3D); 0: none
    double spacing = 0.0; ///< of quadrature points, in dx; 0: default (1/8 in 2D; 3D: 1/4, where both are flat 1/2)
    double ratio = 1.5;   ///< largest change of h over an element
    bool viscous =
        false; ///< S = int h and no lean: what drag does in wedges is measured along h (method, "Films of viscous fluid")
    bool inverse = true; ///< int 1/h of all elements to the accuracy of int h; else of coarse ones alone (3D)
    int node_cap = 100000;
    Vec<3> origin = Vec<3>::Zero(); ///< of the grid, to cut points at its planes
};

/// Sizes for the coupled system. In 3D coarser than the defaults where surfaces are curved: in twelve cases of ball on ball and
/// ball on wall added masses stay within 0.15 % of those with elements of a quarter of the size. Inertia depends on the smallest thickness
/// by its logarithm only; in `viscous` fluid nearly all of the pressure is there, and elements get as small as sqrt(2 R h) requires.
template <int D>
FilmMeshOptions coupling_sizes(bool viscous);

/// All films of `other` on `master` (empty if none). `third(x, n)` is the distance to the nearest
/// solid that is neither and competes with the other for the surface point x with normal n.
/// Geometry only: the result does not depend on the order of bodies, moves with the pair, and is the same on all ranks.
/// `base`: the master's surface_mesh(), for callers that have it already.
template <int D>
std::vector<FilmMesh<D>> film_meshes(const PlacedShape<D>& master, const PlacedShape<D>& other,
                                     const std::function<double(const Vec<D>&, const Vec<D>&)>& third,
                                     const FilmMeshOptions& options, const SurfaceMesh<D>* base = nullptr);

/// Subtracts the skin, which is less than the mesh's floor, from its thickness.
template <int D>
void take_skin_off(FilmMesh<D>& mesh, double skin);

/// Does the fluid point x lie in the gap between two solids: phi_A + phi_B < threshold, opposing normals, face features.
template <int D>
bool in_gap(const PlacedShape<D>& a, const PlacedShape<D>& b, const Vec<D>& x, double threshold);

} // namespace gapflow
