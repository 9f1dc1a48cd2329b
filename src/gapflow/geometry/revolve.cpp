// Meshes of circles and of surfaces of revolution.
#include "gapflow/geometry/revolve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gapflow {

Vec<2> circle_point(int i, int n)
{
    const double angle = 2 * std::numbers::pi * (i % (n / 4)) / n;
    const double c = std::cos(angle), s = std::sin(angle);
    switch (i / (n / 4)) {
    case 0:
        return {c, s};
    case 1:
        return {-s, c};
    case 2:
        return {-c, -s};
    default:
        return {s, -c};
    }
}

int chords_around(double radius, double tolerance)
{
    // Sagitta of a chord over the angle 2 pi / n: r (1 - cos(pi / n)).
    const double ratio = std::clamp(tolerance / radius, 1e-12, 1.);
    const double n = std::numbers::pi / std::acos(1 - ratio);
    return 4 * int(std::ceil(std::clamp(n, 16., 4096.) / 4));
}

SurfaceMesh<3> revolve(const std::vector<Ring>& rings, int n)
{
    SurfaceMesh<3> mesh;
    std::vector<int> first; // vertex 0 of each ring
    for (const Ring& ring : rings) {
        first.push_back(int(mesh.vertices.size()));
        for (int i = 0; i < (ring.radius > 0 ? n : 1); ++i) {
            const Vec<2> e = circle_point(i, n);
            mesh.vertices.emplace_back(ring.x, ring.radius * e[0], ring.radius * e[1]);
        }
    }
    const auto vertex = [&](std::size_t k, int i) { return first[k] + (rings[k].radius > 0 ? i % n : 0); };
    for (std::size_t k = 0; k + 1 < rings.size(); ++k)
        for (int i = 0; i < n; ++i) {
            const int a = vertex(k, i), b = vertex(k, i + 1), c = vertex(k + 1, i + 1), d = vertex(k + 1, i);
            if (a == b)
                mesh.elements.push_back({a, c, d});
            else if (c == d)
                mesh.elements.push_back({a, b, c});
            else if ((i + k) % 2 == 0)
                mesh.elements.insert(mesh.elements.end(), {{a, b, c}, {a, c, d}});
            else
                mesh.elements.insert(mesh.elements.end(), {{a, b, d}, {b, c, d}});
            mesh.patch.resize(mesh.elements.size(), rings[k].patch);
        }
    return mesh;
}

} // namespace gapflow
