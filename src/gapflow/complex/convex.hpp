// Convex solids on the grid: which points they cover, where grid lines enter and leave them, their sections with grid planes.
//
// Lengths in cells, axes of the world. A kernel is compiled for each kind: there is no virtual call a point. `covers` is the one
// predicate that decides on which side a grid vertex lies; `line` and `section` only place what follows from it.
#pragma once

#include "gapflow/complex/section.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace gapflow {

/// The stretch of a grid line inside a solid, in coordinates along it.
struct Stretch {
    double from = std::numeric_limits<double>::infinity(), to = -std::numeric_limits<double>::infinity();

    bool empty() const { return !(from < to); }
    void unite(const Stretch& other)
    {
        from = std::min(from, other.from);
        to = std::max(to, other.to);
    }
    void cut(const Stretch& other)
    {
        from = std::max(from, other.from);
        to = std::min(to, other.to);
    }
};

template <int D>
struct BallKind {
    Vec<D> centre;
    double radius;

    bool covers(const Vec<D>& x) const { return (x - centre).squaredNorm() <= radius * radius; }
    /// Along `axis` through x, whose own coordinate along it does not count.
    Stretch line(int axis, Vec<D> x) const
    {
        x[axis] = centre[axis];
        const double h2 = radius * radius - (x - centre).squaredNorm();
        if (!(h2 > 0))
            return {};
        const double h = std::sqrt(h2);
        return {centre[axis] - h, centre[axis] + h};
    }
    /// With the plane x[d] = at (2D: the solid's outline).
    Section section(int d, double at) const;
    /// Out of the solid, at a point of the surface.
    Vec<D> normal_at(const Vec<D>& x) const { return (x - centre).normalized(); }
    /// Of its surface along the section, near the point x of it.
    Slope slope(int d, double at, int surface, const Vec<2>& x) const requires(D == 3);
};

/// Intersection of half-spaces normal . x <= offset: boxes and half-spaces.
template <int D>
struct PlanesKind {
    std::array<Vec<D>, 2 * D> normal; ///< out of the solid
    std::array<double, 2 * D> offset; ///< from `centre`
    int planes = 0;
    Vec<D> centre;
    double reach = 0; ///< no point of the solid is farther from the centre; 0: a half-space

    bool covers(const Vec<D>& x) const
    {
        bool in = true;
        for (int k = 0; k < planes; ++k)
            in = in && normal[k].dot(x - centre) <= offset[k];
        return in;
    }
    Stretch line(int axis, Vec<D> x) const
    {
        x[axis] = centre[axis];
        Stretch s{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
        for (int k = 0; k < planes; ++k) {
            const double room = offset[k] - normal[k].dot(x - centre), slope = normal[k][axis];
            if (slope > 0)
                s.to = std::min(s.to, centre[axis] + room / slope);
            else if (slope < 0)
                s.from = std::max(s.from, centre[axis] + room / slope);
            else if (room < 0)
                return {};
        }
        return s;
    }
    Section section(int d, double at) const;
    Vec<D> normal_at(const Vec<D>& x) const
    {
        int nearest = 0;
        double most = -std::numeric_limits<double>::infinity();
        for (int k = 0; k < planes; ++k)
            if (const double past = normal[k].dot(x - centre) - offset[k]; past > most) {
                most = past;
                nearest = k;
            }
        return normal[nearest];
    }
    Slope slope(int d, double at, int surface, const Vec<2>& x) const requires(D == 3);
};

/// Points within a radius of an axis of length 2 half: with flat ends (a cylinder, 3D) or round ones (a capsule).
template <int D>
struct RoundKind {
    Vec<D> centre, axis; ///< axis of unit length
    double radius, half;
    bool flat;

    bool covers(const Vec<D>& x) const
    {
        const Vec<D> r = x - centre;
        const double s = r.dot(axis);
        if (flat)
            return std::abs(s) <= half && (r - s * axis).squaredNorm() <= radius * radius;
        return (r - std::clamp(s, -half, half) * axis).squaredNorm() <= radius * radius;
    }
    Stretch line(int along, Vec<D> x) const
    {
        x[along] = centre[along];
        const Vec<D> r = x - centre;
        Stretch s = side(along, r);
        if (flat)
            return s;
        for (const int end : {-1, 1}) // the union of three convex solids is convex
            s.unite(BallKind<D>{centre + end * half * axis, radius}.line(along, x));
        return s;
    }
    Section section(int d, double at) const;
    Vec<D> normal_at(const Vec<D>& x) const
    {
        const Vec<D> r = x - centre;
        const double s = r.dot(axis);
        if (!flat)
            return (r - std::clamp(s, -half, half) * axis).normalized();
        const Vec<D> across = r - s * axis;
        const double distance = across.norm();
        return std::abs(s) - half > distance - radius ? Vec<D>(s > 0 ? axis : -axis) : Vec<D>(across / distance);
    }
    Slope slope(int d, double at, int surface, const Vec<2>& x) const requires(D == 3);

private:
    /// Of the part between the two ends: r from the centre, perpendicular to `along`.
    Stretch side(int along, const Vec<D>& r) const
    {
        // |r + t e - (s + t a) axis|^2 <= radius^2 and |s + t a| <= half
        const double s = r.dot(axis), a = axis[along];
        const Vec<D> q = r - s * axis, e = Vec<D>::Unit(along) - a * axis;
        const double A = e.squaredNorm(), B = q.dot(e), C = q.squaredNorm() - radius * radius;
        Stretch stretch{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
        if (A > 1e-30) {
            const double root2 = B * B - A * C;
            if (!(root2 > 0))
                return {};
            const double root = std::sqrt(root2), far = B > 0 ? -B - root : -B + root, t1 = far / A,
                         t2 = far != 0 ? C / far : 0; // no difference of equals
            stretch = {std::min(t1, t2), std::max(t1, t2)};
        } else if (C > 0)
            return {};
        if (a != 0) {
            const double t1 = (-half - s) / a, t2 = (half - s) / a;
            stretch.cut({std::min(t1, t2), std::max(t1, t2)});
        } else if (std::abs(s) > half)
            return {};
        if (stretch.empty())
            return {};
        return {centre[along] + stretch.from, centre[along] + stretch.to};
    }
};

extern template struct BallKind<2>;
extern template struct BallKind<3>;
extern template struct PlanesKind<2>;
extern template struct PlanesKind<3>;
extern template struct RoundKind<2>;
extern template struct RoundKind<3>;

} // namespace gapflow
