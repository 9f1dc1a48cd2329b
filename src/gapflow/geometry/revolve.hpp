// Meshes of circles and of surfaces of revolution about x.
#pragma once

#include "gapflow/geometry/shape.hpp"

namespace gapflow {

/// Point i of n on the unit circle, i in [0, n), n a multiple of 4: exact on the axes, exactly symmetric under quarter
/// turns.
Vec<2> circle_point(int i, int n);

/// Number of chords, a multiple of 4 in [16, 4096], that stay within `tolerance` of a circle.
int chords_around(double radius, double tolerance);

/// A circle about x; `patch` is that of the band up to the next ring.
struct Ring {
    double x;
    double radius;
    int patch;
};

/// Closed surface through the rings in the order of x, n (even) around. The first and last ring have radius 0 (one vertex
/// each: the pole). Diagonals alternate, so the mesh has the mirror symmetries of the n-gon, and with an even number of
/// bands that along x.
SurfaceMesh<3> revolve(const std::vector<Ring>& rings, int n);

} // namespace gapflow
