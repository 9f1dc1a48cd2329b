// Places on faces of the grid.
#pragma once

#include "gapflow/complex/cut_faces.hpp"

#include <algorithm>

namespace gapflow {

template <int D>
Index<D> vertex_of_corner(int d, Index<D> f, int c)
{
    if (c == 1 || c == 2)
        ++f[u_axis<D>(d)];
    if (c >= 2)
        ++f[v_axis<D>(d)];
    return f;
}

template <int D>
Vec<D> place_of(const GridPlanes<D>& planes, const Index<D>& vertex)
{
    Vec<D> x;
    for (int axis = 0; axis < D; ++axis)
        x[axis] = planes.place[axis][vertex[axis]];
    return x;
}

/// Where a convex solid's surface crosses an edge from a vertex that it covers (or not) to one that it does not (or does).
inline double crossing(const Stretch& line, bool low_covered, double from, double to)
{
    if (line.empty())
        return low_covered ? from : to;
    return std::clamp(low_covered ? line.to : line.from, from, to);
}

/// Whether a line enters and leaves a convex solid between two vertices that it does not cover.
inline bool crosses_twice(const Stretch& line, double from, double to)
{
    return !line.empty() && line.from >= from && line.to <= to;
}

/// Position of an in-plane point in space.
template <int D>
Vec<D> in_space(int d, double at, const Vec<2>& x)
{
    Vec<D> y;
    y[u_axis<D>(d)] = x[0];
    y[v_axis<D>(d)] = x[1];
    if constexpr (D == 3)
        y[d] = at;
    return y;
}

template <int D>
Vec<2> in_plane(int d, const Vec<D>& x)
{
    return {x[u_axis<D>(d)], x[v_axis<D>(d)]};
}

template <int D>
BorderArc<D> border_arc(int image, int piece, int d, double at, const Vec<D>& reference, const Vec<2>& A, const Vec<2>& B,
                        const Bulge& bulge)
{
    BorderArc<D> arc;
    arc.image = image;
    arc.piece = piece;
    if constexpr (D == 3) {
        const ArcIntegrals sums = arc_integrals(A, B, bulge, in_plane<3>(d, reference), at - reference[d]);
        const int u = u_axis<3>(d), v = v_axis<3>(d);
        arc.area[u] = sums.area[0];
        arc.area[v] = sums.area[1];
        arc.area[d] = sums.area[2];
        arc.moment[u] = sums.moment[0];
        arc.moment[v] = sums.moment[1];
        arc.moment[d] = 0;
    } else {
        const Vec<2> a = A - reference, b = B - reference;
        arc.area = Vec<2>(b[1] - a[1], a[0] - b[0]);
        arc.moment[0] = 0.5 * (a.squaredNorm() - b.squaredNorm());
    }
    return arc;
}

/// A face's plane.
template <int D>
double plane_of(const GridPlanes<D>& planes, int d, const Index<D>& f)
{
    return D == 3 ? planes.place[d][f[d]] : 0.0;
}

/// A face that needs Square; what was found for one solid alone lies idle.
template <int D>
void make_general(Slab<D>& slab, CutFace<D>& face)
{
    if (face.state == CutFace<D>::State::general)
        return;
    face.state = CutFace<D>::State::general;
    face.detail = static_cast<std::int32_t>(slab.details.size());
    slab.details.push_back({{face.image}, {}, 0, 0, 0, 0});
    face.pieces = face.arcs = 0;
}

} // namespace gapflow
