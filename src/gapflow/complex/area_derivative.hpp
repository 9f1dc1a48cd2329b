// How the open pieces of the grid's faces change as solids move: derivatives of their areas and first moments, in closed form.
//
// Where a solid moves with the rigid velocity w, its border on a face moves in the face's plane with the normal speed w . n/|n_plane|
// (n out of the solid, n_plane its part in the plane), and the fluid loses what the solid gains:
//
//     dA/dt = - int w . n/|n_plane| ds,     dm/dt = - int (x - centre) w . n/|n_plane| ds     over the solid's arcs,
//
// n/|n_plane| = nu + slope e_d with nu the normal of the arc. The integrals over nu follow from the arc's ends and its bulge alone,
// whatever it is made of; those over the slope n_d/|n_plane| by Slope: where it is constant (facets: straight, balls: circles) from the
// arc's length, where it is linear in nu (sides of cylinders and capsules: n is perpendicular to the axis) from ends and bulge again.
// Ends of arcs, where a solid meets another one or the face's border, contribute nothing. In 2D the ends of open stretches move along
// their edge with w . n/n_edge.
//
// A is not continuous where a facet or a rim passes a plane that it is parallel to: a facet that lies in a face's plane adds nothing. Where
// a straight side of a cylinder touches a plane that it is parallel to, A is the root of the depth: the derivative grows without bound.
#pragma once

#include "gapflow/complex/cut_faces.hpp"

#include <array>
#include <span>

namespace gapflow {

/// Derivatives by the twist of one solid (cells, radians; rotation about its reference point).
template <int D>
struct PieceRate {
    std::int32_t solid;
    Vec<D> reference = Vec<D>::Zero(); ///< of its twist: of the image of the solid that bounds the piece
    Twist<D> area = Twist<D>::Zero();  ///< of the open area, in cells^(D-1) a cell
    /// Of the integral of x - centre of the face over the open piece; along the face's normal zero.
    Eigen::Matrix<double, D, twist_size<D>> moment = Eigen::Matrix<double, D, twist_size<D>>::Zero();
};

/// Of the area vector and moment of a wall (Complex::patches), by the twist of a solid, as far as they follow from the motion of the curve in which it meets another
/// wall. All other changes follow from the pieces' by closure: -sum (dA o, (dm + dA (x_f - reference)) x o) over the part's faces, for a solid's own twist.
template <int D>
struct PatchRate {
    std::int32_t patch, solid;
    TwistMatrix<D> flux; ///< [area vector and moment][twist]
};

/// Of a link's conductance (Complex::links).
template <int D>
struct LinkRate {
    std::int32_t link, solid;
    Twist<D> conductance;
};

/// Sum of a solid's sections within the domain with the planes normal to an axis, spaced as in the grid's core, those at the sides by half; of one
/// that is inside out that of its cavity.
template <int D>
struct SeenVolume {
    double volume = 0;
    Vec<D> moment = Vec<D>::Zero(); ///< about the solid's reference point; along the axis 0

    SeenVolume operator-() const { return {-volume, -moment}; }
};

/// Its derivative by the solid's twist.
template <int D>
struct SeenVolumeRate {
    Twist<D> volume = Twist<D>::Zero();
    Eigen::Matrix<double, D, twist_size<D>> moment = Eigen::Matrix<double, D, twist_size<D>>::Zero();
};

/// By angular velocities.
template <int D>
using SpinMatrix = Eigen::Matrix<double, spin_size<D>, spin_size<D>>;

/// What D of a solid is made of (seen_volume.hpp).
template <int D>
struct SeenSolid {
    std::array<SeenVolume<D>, D> along;
    double volume = 0;                              ///< its own, within the domain
    Vec<D> centroid = Vec<D>::Zero();               ///< its own, from the reference point
    SpinMatrix<D> rotation = SpinMatrix<D>::Zero(); ///< see seen_rotation.hpp
    double sign = 1;                                ///< -1: the solid is inside out
    /// Of the solid within the domain that is not within another solid: the volume that the planes see through the walls of the complex, over that
    /// of the sections, `all`.
    double share = 1, all = 0;
    Vec<D> counts = Vec<D>::Zero(); ///< 0: of an axis along which the walls of two images are not told apart
};

/// Derivatives of Complex::seen_mass by the solid's own twist; of the share also by the area vectors S of its walls as
/// sum share_by_walls . (x - reference) dS, x the middle of the wall's cell.
template <int D>
struct SeenRate {
    SeenSolid<D> seen;
    std::array<SeenVolumeRate<D>, D> along;
    // Of the volume, and of the centroid beside that it turns: as the solid leaves the domain.
    Twist<D> volume = Twist<D>::Zero();
    Eigen::Matrix<double, D, twist_size<D>> centroid = Eigen::Matrix<double, D, twist_size<D>>::Zero();
    std::array<SpinMatrix<D>, twist_size<D>> rotation;
    Twist<D> share = Twist<D>::Zero();
    Vec<D> share_by_walls = Vec<D>::Zero(), reference = Vec<D>::Zero();
};

/// Of each of Complex::pieces, in their order; all other faces are wholly open or wholly covered.
template <int D>
struct FaceDerivatives {
    std::vector<std::int32_t> first{0}; ///< of each piece in `rates`, and the end
    std::vector<PieceRate<D>> rates;    ///< one for each solid (of a periodic domain: image) that bounds the piece
    std::vector<PatchRate<D>> patches;  ///< of walls that meet others
    std::vector<LinkRate<D>> links;
    std::vector<SeenRate<D>> seen; ///< of each solid

    std::span<const PieceRate<D>> of(std::size_t piece) const
    {
        return {rates.data() + first[piece], static_cast<std::size_t>(first[piece + 1] - first[piece])};
    }
};

/// Where a piece of Complex::pieces comes from.
struct PieceSource {
    std::int32_t slab = -1, face = -1; ///< -1: a face that nothing cuts
    std::int32_t piece = 0;            ///< 3D: of its slab
    std::int32_t edge = 0;             ///< 2D: of the rectangle `face`
    double from = 0, to = 0;           ///< 2D: along the edge
    // 2D: the rectangle on the edge's other side. A line that divides one of the two ends the stretch.
    std::int32_t other_slab = -1, other_face = -1, other_edge = 0;
};

/// Fills the pieces' rates. `sources`: of Complex::pieces; `cut` with its facets kept. build_complex calls it.
template <int D>
void face_derivatives(const GridPlanes<D>& planes, const DenseIndex<D>& index, const std::vector<PlacedSolid<D>>& solids,
                      const CutFaces<D>& cut, std::span<const PieceSource> sources, FaceDerivatives<D>& result);

/// A face of a 3D grid.
struct FacePlane {
    int d;         ///< its normal
    double at;     ///< its place along d
    Vec<2> centre; ///< (u, v)
};

/// Adds what a segment of a solid's border contributes; `slope` with the normal out of the solid, `reference` of its twist.
void add_segment(const FacePlane& face, const Vec<3>& reference, const ArcSegment& segment, const Slope& slope,
                 PieceRate<3>& rate);

/// Adds what the end of an open stretch at x of a 2D grid's edge along `axis` contributes: `sign` 1 at its high end, -1 at its low one;
/// `normal` of the solid there, of either sign.
void add_end(int axis, double sign, const Vec<2>& x, double centre, const Vec<2>& reference, const Vec<2>& normal,
             PieceRate<2>& rate);

} // namespace gapflow
