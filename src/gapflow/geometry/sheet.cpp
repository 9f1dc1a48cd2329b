// A sheet is made of its middle surface: vertex i moves to x_i +- t/2 v_i, with n_k . v_i = 1 for the normals n_k of the facets around it. The least squares
// solution of least length of these equations is exact for up to D different planes, and on a smooth surface the mean normal to second order of the turn
// from facet to facet.
#include "gapflow/geometry/sheet.hpp"

#include "gapflow/geometry/mesh_check.hpp"
#include "gapflow/geometry/mesh_crossings.hpp"
#include "gapflow/geometry/mesh_features.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>

namespace gapflow {
namespace {

constexpr double weld_distance =
    1e-6; // of the size; the least thickness is four times as much: its sides are no touching facets

template <int D>
constexpr const char* facet_name = D == 2 ? "segment" : "triangle";

template <int D>
std::string text_of(const Vec<D>& x)
{
    std::ostringstream text;
    text << '(' << x.transpose().format(Eigen::IOFormat(6, Eigen::DontAlignCols, " ", " ")) << ')';
    return text.str();
}

std::string number(double x)
{
    std::ostringstream text;
    text.precision(3);
    text << x;
    return text.str();
}

[[noreturn]] void refuse_surface(const std::string& problem, const std::string& remedy)
{
    throw SheetError(false, problem, remedy);
}

[[noreturn]] void refuse_thickness(const std::string& problem, const std::string& remedy)
{
    throw SheetError(true, problem, remedy);
}

/// A facet's side: in 3D the edge from vertex k to the next one, in 2D vertex k.
struct Side {
    std::array<int, 2> key; ///< sorted vertices; 2D: the vertex twice
    int facet, k;
    bool operator<(const Side& other) const { return key != other.key ? key < other.key : facet < other.facet; }
};

template <int D>
std::vector<Side> sides_of(const SurfaceMesh<D>& mesh)
{
    std::vector<Side> sides;
    for (int f = 0; f < static_cast<int>(mesh.elements.size()); ++f)
        for (int k = 0; k < D; ++k) {
            const int a = mesh.elements[f][k], b = D == 2 ? a : mesh.elements[f][(k + 1) % D];
            sides.push_back({{std::min(a, b), std::max(a, b)}, f, k});
        }
    std::sort(sides.begin(), sides.end());
    return sides;
}

/// Whether a facet runs along its side from the lower to the higher vertex; 2D: whether it begins there.
template <int D>
bool forward(const SurfaceMesh<D>& mesh, const Side& side)
{
    return D == 2 ? side.k == 0 : mesh.elements[side.facet][side.k] == side.key[0];
}

/// Neighbours across each side, -1 at the rim; facets are turned so that those of each connected part face the same side.
template <int D>
std::vector<std::array<int, D>> oriented(SurfaceMesh<D>& mesh)
{
    constexpr const char* where = D == 2 ? "the point " : "the edge at ";
    std::vector<std::array<int, D>> neighbour(mesh.elements.size());
    for (auto& list : neighbour)
        list.fill(-1);
    std::vector<char> turned(mesh.elements.size(), 0), seen(mesh.elements.size(), 0), against(D * mesh.elements.size(), 0);
    const std::vector<Side> sides = sides_of(mesh);
    for (std::size_t i = 0, end; i < sides.size(); i = end) {
        for (end = i; end < sides.size() && sides[end].key == sides[i].key;)
            ++end;
        if (end - i == 1)
            continue;
        if (end - i > 2)
            refuse_surface(where + text_of<D>(mesh.vertices[sides[i].key[0]]) + " belongs to " + std::to_string(end - i) + " " +
                               facet_name<D> + "s: the sheet branches or touches itself",
                           "make it of several bodies, or a mesh with a thickness");
        const Side &s = sides[i], &t = sides[i + 1];
        neighbour[s.facet][s.k] = t.facet;
        neighbour[t.facet][t.k] = s.facet;
        against[D * s.facet + s.k] = against[D * t.facet + t.k] = forward(mesh, s) == forward(mesh, t);
    }
    std::vector<int> stack;
    for (int seed = 0; seed < static_cast<int>(neighbour.size()); ++seed) {
        if (seen[seed])
            continue;
        seen[seed] = 1;
        stack.push_back(seed);
        while (!stack.empty()) {
            const int f = stack.back();
            stack.pop_back();
            for (int k = 0; k < D; ++k) {
                const int g = neighbour[f][k];
                if (g < 0)
                    continue;
                const char turn = turned[f] != against[D * f + k];
                if (!seen[g]) {
                    seen[g] = 1;
                    turned[g] = turn;
                    stack.push_back(g);
                } else if (turned[g] != turn)
                    refuse_surface("the sheet is one-sided (a Moebius band) at " +
                                       text_of<D>(mesh.vertices[mesh.elements[f][k]]),
                                   "cut it open there");
            }
        }
    }
    for (std::size_t f = 0; f < neighbour.size(); ++f)
        if (turned[f]) {
            std::swap(mesh.elements[f][0], mesh.elements[f][1]);
            if constexpr (D == 2)
                std::swap(neighbour[f][0], neighbour[f][1]);
            else
                std::swap(neighbour[f][1], neighbour[f][2]); // edges (1, 2) and (2, 0) are now (0, 2) and (2, 1)
        }
    return neighbour;
}

/// In 3D facets around a vertex that are not joined by edges would meet in a point.
template <int D>
void require_fans(const SurfaceMesh<D>& mesh, const std::vector<std::array<int, D>>& neighbour)
{
    if constexpr (D == 3) {
        // A fan has one facet more than inner edges at the vertex, or as many where it goes around.
        std::vector<int> facets(mesh.vertices.size(), 0), inner(mesh.vertices.size(), 0), rims(mesh.vertices.size(), 0);
        for (std::size_t f = 0; f < neighbour.size(); ++f)
            for (int k = 0; k < 3; ++k) {
                ++facets[mesh.elements[f][k]];
                for (const int v : {mesh.elements[f][k], mesh.elements[f][(k + 1) % 3]})
                    ++(neighbour[f][k] < 0 ? rims : inner)[v];
            }
        for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
            if (rims[v] > 2 || (rims[v] > 0 && facets[v] - inner[v] / 2 != 1))
                refuse_surface("parts of the sheet meet in the point " + text_of<D>(mesh.vertices[v]) + " only",
                               "give each part vertices of its own, apart from each other");
    }
}

template <int D>
Vec<D> area_vector(const std::array<Vec<D>, D>& x)
{
    if constexpr (D == 2)
        return Vec<2>(x[1][1] - x[0][1], x[0][0] - x[1][0]);
    else
        return 0.5 * (x[1] - x[0]).cross(x[2] - x[0]);
}

template <int D>
std::array<Vec<D>, D> corners(const SurfaceMesh<D>& mesh, std::size_t f)
{
    std::array<Vec<D>, D> x;
    for (int k = 0; k < D; ++k)
        x[k] = mesh.vertices[mesh.elements[f][k]];
    return x;
}

template <int D>
std::vector<Vec<D>> offsets(const SurfaceMesh<D>& mesh, const std::vector<Vec<D>>& normal)
{
    std::vector<Mat<D>> square(mesh.vertices.size(), Mat<D>::Zero());
    std::vector<Vec<D>> right(mesh.vertices.size(), Vec<D>::Zero());
    for (int f = 0; f < static_cast<int>(mesh.elements.size()); ++f)
        for (int k = 0; k < D; ++k) {
            const double weight = facet_angle(mesh, f, k);
            square[mesh.elements[f][k]] += weight * normal[f] * normal[f].transpose();
            right[mesh.elements[f][k]] += weight * normal[f];
        }
    std::vector<Vec<D>> result;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        const Eigen::SelfAdjointEigenSolver<Mat<D>> solver(square[v]);
        Vec<D> sum = Vec<D>::Zero();
        for (int k = 0; k < D; ++k) // directions in which no normal points, to round-off, stay out
            if (const double value = solver.eigenvalues()[k]; value > 1e-12 * solver.eigenvalues()[D - 1])
                sum += solver.eigenvectors().col(k).dot(right[v]) / value * solver.eigenvectors().col(k);
        result.push_back(sum);
    }
    return result;
}

/// The distance of the two sides at which a facet of one of them turns over.
template <int D>
double most_thickness(const SurfaceMesh<D>& mesh, std::size_t f, const Vec<D>& normal, const std::vector<Vec<D>>& offset)
{
    // Its area times its direction is a polynomial in the shift s: c + b s + a s^2, c > 0.
    const std::array<Vec<D>, D> x = corners(mesh, f);
    std::array<Vec<D>, D> v;
    for (int k = 0; k < D; ++k)
        v[k] = offset[mesh.elements[f][k]];
    const auto area = [&](double s) {
        std::array<Vec<D>, D> y;
        for (int k = 0; k < D; ++k)
            y[k] = x[k] + s * v[k];
        return area_vector<D>(y).dot(normal);
    };
    const double unit = std::sqrt(area_vector<D>(x).norm()); // 3D: of the length of its edges
    const double c = area(0), up = area(unit), down = area(-unit), a = 0.5 * (up + down) - c, b = 0.5 * (up - down);
    const double infinite = std::numeric_limits<double>::infinity();
    double least = infinite;
    if (std::abs(a) < 1e-14 * c)
        least = std::abs(b) > 0 ? c / std::abs(b) : infinite;
    else if (const double root2 = b * b - 4 * a * c; root2 >= 0) {
        const double q = -0.5 * (b + std::copysign(std::sqrt(root2), b));
        for (const double s : {q / a, c / q})
            least = std::min(least, std::abs(s));
    }
    return 2 * least * unit;
}

/// As facets are named in messages.
class FacetNames {
public:
    FacetNames(const std::vector<int>& source, const std::vector<int>& lines) : source_(source), lines_(lines) {}
    std::string operator()(int f) const
    {
        const int number = source_[static_cast<std::size_t>(f)];
        return lines_.empty() ? std::to_string(number) : "of line " + std::to_string(lines_[static_cast<std::size_t>(number)]);
    }

private:
    const std::vector<int>&source_, &lines_;
};

template <int D>
void require_apart(const SurfaceMesh<D>& middle, const FacetNames& name)
{
    const Crossings<D> crossings = find_crossings(middle, weld_distance * extent(middle));
    for (const auto* list : {&crossings.through, &crossings.flat})
        if (!list->empty()) {
            const Crossing<D>& first = list->front();
            refuse_surface(std::string("the sheet cuts itself: ") + facet_name<D> + "s " + name(first.first) + " and " +
                               name(first.second) + " cross at " + text_of<D>(first.place),
                           "make it of several bodies that do not cross");
        }
}

template <int D>
void require_thin(const SurfaceMesh<D>& middle, const std::vector<Vec<D>>& normal, const std::vector<Vec<D>>& offset,
                  double thickness, const FacetNames& name)
{
    double most = std::numeric_limits<double>::infinity();
    std::size_t worst = 0;
    for (std::size_t f = 0; f < middle.elements.size(); ++f)
        if (const double value = most_thickness(middle, f, normal[f], offset); value < most) {
            most = value;
            worst = f;
        }
    if (!(thickness < (1 - 1e-9) * most))
        refuse_thickness("the sheet is too thick for its bend at " + text_of<D>(corners(middle, worst)[0]) + " (" +
                             facet_name<D> + " " + name(static_cast<int>(worst)) + ")",
                         "give a thickness below " + number(most) + ", or longer " + facet_name<D> + "s there");
}

template <int D>
SurfaceMesh<D> moved_apart(const SurfaceMesh<D>& middle, const std::vector<std::array<int, D>>& neighbour,
                           const std::vector<Vec<D>>& offset, double thickness)
{
    SurfaceMesh<D> surface;
    for (std::size_t v = 0; v < offset.size(); ++v) // 2v on the side of the normals, 2v + 1 on the other one
        for (const double side : {0.5, -0.5})
            surface.vertices.push_back(middle.vertices[v] + side * thickness * offset[v]);
    for (const auto& facet : middle.elements) {
        std::array<int, D> up, down;
        for (int k = 0; k < D; ++k) {
            up[k] = 2 * facet[k];
            down[k] = 2 * facet[D - 1 - k] + 1;
        }
        surface.elements.push_back(up);
        surface.elements.push_back(down);
    }
    for (std::size_t f = 0; f < middle.elements.size(); ++f)
        for (int k = 0; k < D; ++k) {
            if (neighbour[f][k] >= 0)
                continue;
            const int a = 2 * middle.elements[f][k], b = 2 * middle.elements[f][(k + 1) % D];
            if constexpr (D == 2)
                surface.elements.push_back(k == 0 ? std::array{a + 1, a} : std::array{a, a + 1});
            else {
                surface.elements.push_back({b, a, a + 1});
                surface.elements.push_back({b, a + 1, b + 1});
            }
        }
    return surface;
}

} // namespace

SurfaceMesh<2> polyline(const std::vector<Vec<2>>& points)
{
    SurfaceMesh<2> mesh{points, {}, {}};
    for (int k = 0; k + 1 < static_cast<int>(points.size()); ++k)
        mesh.elements.push_back({k, k + 1});
    return mesh;
}

template <int D>
SurfaceMesh<D> sheet_surface(SurfaceMesh<D> middle, double thickness, const std::vector<int>& lines)
{
    if (!(thickness > 0) || !std::isfinite(thickness))
        refuse_thickness("a sheet needs a thickness", "give a length > 0");
    const double size = middle.vertices.empty() ? 0 : extent(middle);
    std::vector<int> source(middle.elements.size());
    std::iota(source.begin(), source.end(), 0);
    if (size > 0)
        middle = welded(middle, weld_distance * size, source);
    if (middle.elements.empty() || size == 0)
        refuse_surface("the sheet has no extent", D == 2 ? "give two points or more" : "give facets");
    if (thickness < 4 * weld_distance * size)
        refuse_thickness("the thickness is less than 4e-6 of the sheet's size",
                         "give at least " + number(4 * weld_distance * size));
    const FacetNames name(source, lines);
    const std::vector<std::array<int, D>> neighbour = oriented(middle);
    require_fans<D>(middle, neighbour);
    require_apart(middle, name);
    std::vector<Vec<D>> normal;
    for (std::size_t f = 0; f < middle.elements.size(); ++f) {
        const Vec<D> area = area_vector<D>(corners(middle, f));
        if (!(area.norm() > std::pow(weld_distance * size, D - 1)))
            refuse_surface(std::string(facet_name<D>) + " " + name(static_cast<int>(f)) + " has no area", "remove it");
        normal.push_back(area.normalized());
    }
    const std::vector<Vec<D>> offset = offsets(middle, normal);
    require_thin(middle, normal, offset, thickness, name);
    SurfaceMesh<D> surface = moved_apart<D>(middle, neighbour, offset, thickness);
    const Crossings<D> crossings = find_crossings(surface, weld_distance * size);
    if (!crossings.through.empty())
        refuse_thickness("parts of the sheet come closer to each other than its thickness at " +
                             text_of<D>(crossings.through.front().place),
                         "give a smaller thickness, or bodies of their own that are apart");
    return surface;
}

template SurfaceMesh<2> sheet_surface<2>(SurfaceMesh<2>, double, const std::vector<int>&);
template SurfaceMesh<3> sheet_surface<3>(SurfaceMesh<3>, double, const std::vector<int>&);

} // namespace gapflow
