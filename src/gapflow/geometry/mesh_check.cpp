// Welding, closedness, crossings and orientation of surfaces.
#include "gapflow/geometry/mesh_check.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/geometry/mesh_crossings.hpp"
#include "gapflow/geometry/mesh_mass.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <sstream>
#include <unordered_map>

namespace gapflow {
template <int D>
double extent(const SurfaceMesh<D>& mesh)
{
    Vec<D> low = mesh.vertices.front(), high = low;
    for (const Vec<D>& x : mesh.vertices) {
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
    }
    return (high - low).norm();
}

namespace {

template <int D>
struct Cell {
    Eigen::Matrix<std::int64_t, D, 1> index;
    bool operator==(const Cell& other) const { return index == other.index; }
};

template <int D>
struct CellHash {
    std::size_t operator()(const Cell<D>& cell) const
    {
        std::uint64_t h = 0;
        for (int i = 0; i < D; ++i)
            h = (h ^ std::uint64_t(cell.index[i])) * 0x9E3779B97F4A7C15u + (h >> 29);
        return h;
    }
};

/// The same facets without the vertices that none of them uses.
template <int D>
SurfaceMesh<D> compacted(const std::vector<Vec<D>>& vertices, std::vector<std::array<int, D>> facets)
{
    SurfaceMesh<D> result;
    std::unordered_map<int, int> target;
    for (auto& facet : facets)
        for (int& v : facet) {
            const auto [entry, added] = target.try_emplace(v, int(result.vertices.size()));
            if (added)
                result.vertices.push_back(vertices[v]);
            v = entry->second;
        }
    result.elements = std::move(facets);
    return result;
}

template <int D>
struct RidgeSide {
    std::array<int, 2> key; ///< sorted vertices (2D: twice the vertex)
    int facet;
    int local;
    bool forward; ///< 3D: runs from the lower to the higher vertex; 2D: is the end of the segment
};

template <int D>
std::vector<RidgeSide<D>> ridge_sides(const SurfaceMesh<D>& mesh)
{
    std::vector<RidgeSide<D>> sides;
    sides.reserve(D * mesh.elements.size());
    for (int f = 0; f < int(mesh.elements.size()); ++f)
        for (int i = 0; i < D; ++i) {
            const int a = mesh.elements[f][(i + 1) % D], b = mesh.elements[f][D == 2 ? 1 - i : (i + 2) % D];
            sides.push_back({{std::min(a, b), std::max(a, b)}, f, i, D == 2 ? i == 0 : a < b});
        }
    std::sort(sides.begin(), sides.end(),
              [](const auto& s, const auto& t) { return s.key != t.key ? s.key < t.key : s.facet < t.facet; });
    return sides;
}

template <int D>
std::string describe(const SurfaceMesh<D>& mesh, const std::array<int, 2>& key)
{
    const Eigen::IOFormat row(9, Eigen::DontAlignCols, " ", " ");
    std::ostringstream text;
    text << (D == 2 ? "vertex (" : "edge (") << mesh.vertices[key[0]].transpose().format(row) << ")";
    if (D == 3)
        text << " - (" << mesh.vertices[key[1]].transpose().format(row) << ")";
    return text.str();
}

/// Fills `neighbours`; returns what is wrong at the first bad ridge (that of the lowest facet), empty if nothing is.
template <int D>
std::string connect(const SurfaceMesh<D>& mesh, Neighbours<D>& neighbours)
{
    const char* facet = D == 2 ? "segment" : "triangle";
    neighbours.assign(mesh.elements.size(), {});
    const auto sides = ridge_sides(mesh);
    std::string defect;
    int worst = int(mesh.elements.size());
    for (std::size_t begin = 0, end; begin < sides.size(); begin = end) {
        for (end = begin; end < sides.size() && sides[end].key == sides[begin].key;)
            ++end;
        const auto &s = sides[begin], &t = sides[end - 1];
        if (end - begin == 2 && s.forward != t.forward) {
            neighbours[s.facet][s.local] = t.facet;
            neighbours[t.facet][t.local] = s.facet;
        } else if (s.facet < worst) {
            worst = s.facet;
            std::ostringstream text;
            text << describe(mesh, s.key);
            if (end - begin == 1)
                text << " belongs to one " << facet << " only: the surface has a hole; close it";
            else if (end - begin > 2)
                text << " belongs to " << end - begin << " " << facet << "s: the surface is not a manifold; separate its parts";
            else
                text << ": its two " << facet << "s face opposite sides; turn one of them over";
            defect = text.str();
        }
    }
    return defect;
}

/// Number of the connected part of each facet.
template <int D>
std::vector<int> parts_of(const Neighbours<D>& neighbours, int& count)
{
    std::vector<int> part(neighbours.size(), -1), stack;
    count = 0;
    for (int seed = 0; seed < int(part.size()); ++seed) {
        if (part[seed] >= 0)
            continue;
        part[seed] = count;
        stack.push_back(seed);
        while (!stack.empty()) {
            const int f = stack.back();
            stack.pop_back();
            for (int g : neighbours[f])
                if (part[g] < 0) {
                    part[g] = count;
                    stack.push_back(g);
                }
        }
        ++count;
    }
    return part;
}

template <int D>
void turn_over(ClosedSurface<D>& surface)
{
    for (auto& facet : surface.mesh.elements)
        std::swap(facet[0], facet[1]);
    for (auto& across : surface.neighbours)
        std::swap(across[0], across[1]);
}

/// Names of facets in messages: `source` is the number of each in the file, `lines` the file's line of each of those.
struct FacetNames {
    const std::vector<int>& source;
    const std::vector<int>& lines;
};

template <int D>
[[noreturn]] void refuse(const std::vector<Crossing<D>>& crossings, bool more, const char* how, const FacetNames& names,
                         const std::string& name)
{
    const Crossing<D>& worst = crossings.front();
    const int f = names.source[worst.first], g = names.source[worst.second];
    const bool by_line = !names.lines.empty();
    std::ostringstream text;
    text << name << ": the surface cuts itself: " << (D == 2 ? "segments" : "triangles");
    if (by_line)
        text << " of lines " << names.lines[f] << " and " << names.lines[g];
    else
        text << ' ' << f << " and " << g << " (from 0)";
    const Eigen::IOFormat row(6, Eigen::DontAlignCols, " ", " ");
    text << ' ' << how << " at (" << worst.place.transpose().format(row) << ')';
    if (const std::size_t others = crossings.size() - 1; others > 0)
        text << ", and " << (more ? "at least " : "") << others << " more pair" << (others > 1 ? "s" : "");
    if (D == 3 && by_line && names.lines[f] == names.lines[g])
        text << "; export faces of more than three corners as triangles";
    else if (D == 3)
        text << "; unite parts that overlap (Boolean union), and repair folds, in the program that made the mesh";
    else
        text << "; put the vertices in the order of the boundary, and make one loop of loops that overlap";
    throw InputError(text.str());
}

/// Parts inside an odd number of others must be cavities, the rest solids.
template <int D>
void check_nesting(const ClosedSurface<D>& surface, const std::string& name)
{
    int count;
    const std::vector<int> part = parts_of<D>(surface.neighbours, count);
    if (count == 1)
        return;
    std::vector<std::vector<std::array<int, D>>> facets(count);
    for (std::size_t f = 0; f < part.size(); ++f)
        facets[part[f]].push_back(surface.mesh.elements[f]);
    std::vector<SurfaceMesh<D>> parts;
    for (int p = 0; p < count; ++p)
        parts.push_back(compacted<D>(surface.mesh.vertices, std::move(facets[p])));
    for (int p = 0; p < count; ++p) {
        const Vec<D>& x = parts[p].vertices.front();
        int depth = 0;
        for (int q = 0; q < count; ++q)
            depth += q != p && std::abs(winding_number(parts[q], x)) > 0.5;
        const double volume = mass_properties_of(parts[p]).volume;
        if ((volume > 0) == (depth % 2 == 0))
            continue;
        std::ostringstream text;
        text << name << ": the part at " << describe(parts[p], {0, 1}) << " lies inside " << depth
             << " others but is oriented as a " << (volume > 0 ? "solid" : "cavity") << "; turn its facets over or remove it";
        throw InputError(text.str());
    }
}

} // namespace

template <int D>
SurfaceMesh<D> welded(const SurfaceMesh<D>& mesh, double tolerance, std::vector<int>& source)
{
    SurfaceMesh<D> result;
    std::size_t kept = 0;
    const double width = std::max(3 * tolerance, 1e-12 * extent(mesh)), reach = 1.001 * tolerance;
    std::unordered_map<Cell<D>, std::vector<int>, CellHash<D>> cells;
    const Vec<D> origin = mesh.vertices.front(); // a small mesh far away keeps small numbers of cells
    const auto cell_of = [&](const Vec<D>& x) {
        return Cell<D>{((x - origin) / width).array().floor().matrix().template cast<std::int64_t>()};
    };
    const auto merged = [&](const Vec<D>& x) {
        for (int corner = 0; corner < (tolerance > 0 ? 1 << D : 1); ++corner) { // cells that a cube of size 2 reach touches
            Vec<D> probe = x;
            for (int i = 0; i < D; ++i)
                probe[i] += corner >> i & 1 ? reach : -reach;
            if (const auto found = cells.find(cell_of(probe)); found != cells.end())
                for (int v : found->second)
                    if ((result.vertices[v] - x).norm() <= tolerance)
                        return v;
        }
        result.vertices.push_back(x);
        cells[cell_of(x)].push_back(int(result.vertices.size()) - 1);
        return int(result.vertices.size()) - 1;
    };
    std::vector<int> target(mesh.vertices.size(), -1);
    for (std::size_t f = 0; f < mesh.elements.size(); ++f) {
        std::array<int, D> facet = mesh.elements[f];
        for (int& v : facet) {
            if (target[v] < 0)
                target[v] = merged(mesh.vertices[v]);
            v = target[v];
        }
        if (facet[0] != facet[1] && (D == 2 || (facet[1] != facet[D - 1] && facet[D - 1] != facet[0]))) {
            result.elements.push_back(facet);
            source[kept++] = source[f];
        }
    }
    source.resize(kept);
    return result;
}

template <int D>
double winding_number(const SurfaceMesh<D>& mesh, const Vec<D>& x)
{
    double sum = 0;
    for (const auto& facet : mesh.elements) {
        const Vec<D> a = mesh.vertices[facet[0]] - x, b = mesh.vertices[facet[1]] - x;
        if constexpr (D == 2)
            sum += std::atan2(a[0] * b[1] - a[1] * b[0], a.dot(b));
        else {
            const Vec<3> c = mesh.vertices[facet[2]] - x;
            const double la = a.norm(), lb = b.norm(), lc = c.norm();
            sum += 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
        }
    }
    return sum / ((D == 2 ? 2 : 4) * std::numbers::pi);
}

template <int D>
ClosedSurface<D> closed_surface(SurfaceMesh<D> mesh, const std::string& name, const std::vector<int>& lines)
{
    ClosedSurface<D> surface{compacted<D>(mesh.vertices, std::move(mesh.elements)), {}};
    std::string defect;
    const double size = extent(surface.mesh), tolerance = 1e-6 * size;
    if (size == 0)
        throw InputError(name + ": the surface encloses no volume: all of its vertices are at one place; check its scale");
    std::vector<int> source(surface.mesh.elements.size()); // number of each facet in the file
    std::iota(source.begin(), source.end(), 0);
    // Apart by -1: only vertices shared by index. Polygons close themselves and are never welded.
    for (double apart : {-1., 0., tolerance}) {
        if (apart >= 0)
            surface.mesh = welded(surface.mesh, apart, source);
        defect = connect<D>(surface.mesh, surface.neighbours);
        if (defect.empty() || D == 2)
            break;
    }
    if (!defect.empty())
        throw InputError(name + ": " + defect);
    const FacetNames names{source, lines};
    const Crossings<D> crossings = find_crossings(surface.mesh, tolerance);
    if (!crossings.through.empty())
        refuse(crossings.through, crossings.more, "cross", names, name);
    const double volume = mass_properties_of(surface.mesh).volume;
    if (!(std::abs(volume) > 1e-14 * std::pow(size, D)))
        throw InputError(name + ": the surface encloses no volume; give the part a thickness, and a polygon no crossings");
    if (!crossings.flat.empty())
        refuse(crossings.flat, crossings.more, "lie on each other", names, name);
    if (volume < 0)
        turn_over(surface);
    if (const auto along = find_crossings_along_ridges(surface.mesh, tolerance); !along.empty())
        refuse(along, false, "meet where parts overlap,", names, name);
    check_nesting(surface, name);
    return surface;
}

template ClosedSurface<2> closed_surface<2>(SurfaceMesh<2>, const std::string&, const std::vector<int>&);
template ClosedSurface<3> closed_surface<3>(SurfaceMesh<3>, const std::string&, const std::vector<int>&);
template SurfaceMesh<2> welded(const SurfaceMesh<2>&, double, std::vector<int>&);
template SurfaceMesh<3> welded(const SurfaceMesh<3>&, double, std::vector<int>&);
template double extent(const SurfaceMesh<2>&);
template double extent(const SurfaceMesh<3>&);
template double winding_number<2>(const SurfaceMesh<2>&, const Vec<2>&);
template double winding_number<3>(const SurfaceMesh<3>&, const Vec<3>&);

} // namespace gapflow
