#include "checks.hpp"

#include <cstdint>
#include <numbers>
#include <sstream>

namespace gapflow::testing {

std::string obj_text(const SurfaceMesh<3>& mesh)
{
    std::ostringstream out;
    out.precision(17);
    out << "# test\no thing\n";
    for (const Vec<3>& x : mesh.vertices)
        out << "v " << x[0] << ' ' << x[1] << ' ' << x[2] << '\n';
    for (const auto& e : mesh.elements)
        out << "f " << e[0] + 1 << "/1/1 " << e[1] + 1 << "//2 " << e[2] + 1 << '\n';
    return out.str();
}

std::string ascii_stl_text(const SurfaceMesh<3>& mesh)
{
    std::ostringstream out;
    out.precision(9);
    out << "solid test\n";
    for (const auto& e : mesh.elements) {
        out << "  facet normal 0 0 0\n    outer loop\n";
        for (int v : e)
            out << "      vertex " << mesh.vertices[v].transpose() << '\n';
        out << "    endloop\n  endfacet\n";
    }
    out << "endsolid test\n";
    return out.str();
}

std::string binary_stl_text(const SurfaceMesh<3>& mesh)
{
    std::string out(80, ' ');
    out.replace(0, 5, "solid"); // as some programs write it
    const auto put = [&](auto value) { out.append(reinterpret_cast<const char*>(&value), sizeof value); };
    put(std::uint32_t(mesh.elements.size()));
    for (const auto& e : mesh.elements) {
        for (int i = 0; i < 3; ++i)
            put(0.f);
        for (int v : e)
            for (int i = 0; i < 3; ++i)
                put(float(mesh.vertices[v][i]));
        put(std::uint16_t(0));
    }
    return out;
}

SurfaceMesh<3> torus(double large, double small, int n, int m)
{
    SurfaceMesh<3> mesh;
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < m; ++k) {
            const double a = 2 * std::numbers::pi * i / n, b = 2 * std::numbers::pi * k / m, r = large + small * std::cos(b);
            mesh.vertices.emplace_back(r * std::cos(a), r * std::sin(a), small * std::sin(b));
            const int p = i * m + k, q = (i + 1) % n * m + k, s = (i + 1) % n * m + (k + 1) % m, t = i * m + (k + 1) % m;
            mesh.elements.push_back({p, q, s});
            mesh.elements.push_back({p, s, t});
        }
    return mesh;
}

} // namespace gapflow::testing
