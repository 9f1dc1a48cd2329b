// Curves in which solids cut a plane of the grid, and what a piece of such a curve encloses with its chord.
//
// Plane coordinates (u, v), with u, v, d right-handed and d the plane's normal; lengths in cells. Curves run with the fluid at their
// left: clockwise around a solid. All integrals along a curve from A to B follow from its ends and the area and first moment of its
// bulge, the region between curve and chord, by Stokes:
//
//     1/2 int (u dv - v du) = 1/2 A x B + area,     int |x|^2 du = chord's - 2 moment_v,     int |x|^2 dv = chord's + 2 moment_u.
#pragma once

#include "gapflow/core/types.hpp"

#include <array>
#include <cmath>

namespace gapflow {

/// Signed area and first moment (about the plane's origin) of a region; positive if the border runs counterclockwise.
struct Bulge {
    double area = 0;
    Vec<2> moment = Vec<2>::Zero();

    Bulge& operator+=(const Bulge& other)
    {
        area += other.area;
        moment += other.moment;
        return *this;
    }
    Bulge operator-() const { return {-area, -moment}; }
};

/// Of the triangle A, B, C.
inline Bulge triangle(const Vec<2>& A, const Vec<2>& B, const Vec<2>& C)
{
    const Vec<2> b = B - A, c = C - A;
    const double area = 0.5 * (b[0] * c[1] - b[1] * c[0]);
    return {area, area / 3 * (A + B + C)};
}

/// A straight line or an ellipse with semi-axes along e1 = (c, s) and e2 = (-s, c).
struct Curve {
    enum class Kind { line, ellipse };
    Kind kind = Kind::line;
    Vec<2> centre = Vec<2>::Zero(); ///< of the ellipse
    Vec<2> e1 = Vec<2>::UnitX();
    double semi1 = 0, semi2 = 0;
    int surface = 0; ///< of the solid: which of its faces it belongs to

    /// In the axes of the ellipse, over its semi-axes: on the unit circle.
    Vec<2> scaled(const Vec<2>& x) const { return axes(Vec<2>(x - centre)); }
    /// The same of a vector.
    Vec<2> axes(const Vec<2>& r) const
    {
        return {(r[0] * e1[0] + r[1] * e1[1]) / semi1, (r[1] * e1[0] - r[0] * e1[1]) / semi2};
    }
};

/// n_d / |n_plane| of a solid's normal n along a curve in which it cuts a plane normal to d: constant + along . nu, nu the curve's unit
/// normal out of the solid.
struct Slope {
    double constant = 0;
    Vec<2> along = Vec<2>::Zero();
};

/// Of a flat facet with unit normal n; 0 where it lies in the plane.
inline Slope flat_slope(const Vec<3>& n, int d)
{
    const double in_plane = std::hypot(n[(d + 1) % 3], n[(d + 2) % 3]);
    return {in_plane > 1e-12 ? n[d] / in_plane : 0.0, Vec<2>::Zero()};
}

/// Clockwise angle of the piece of the ellipse (on the unit circle, scaled) from A to B, 0 .. 2 pi; A == B: 0.
double ellipse_angle(const Curve& curve, const Vec<2>& A, const Vec<2>& B);

/// Bulge of the ellipse's piece that runs clockwise from A to B, less than once around; A == B: nothing.
Bulge ellipse_bulge(const Curve& curve, const Vec<2>& A, const Vec<2>& B);

/// Of the whole ellipse, clockwise.
Bulge whole_ellipse(const Curve& curve);

/// Integrals along a piece of a solid's section from A to B about the reference point of its twist, at height h below the plane.
struct ArcIntegrals {
    Vec<3> area;   ///< 1/2 int x cross dx, in (u, v, d)
    Vec<3> moment; ///< -1/2 int |x|^2 dx
};

/// Of a piece with the given bulge; A, B and the bulge's moment about the plane's origin, the reference point at `reference` in the
/// plane and h below it (towards -d).
ArcIntegrals arc_integrals(const Vec<2>& A, const Vec<2>& B, const Bulge& bulge, const Vec<2>& reference, double h);

} // namespace gapflow
