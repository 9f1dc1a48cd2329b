// Where a surface cuts itself.
//
// Two facets are convex, so the shortest shift that parts them is along a normal of a face of their Minkowski difference: in 3D
// the normals of both and the cross products of their edges, in 2D the normals of both (separating axes; Gottschalk, Lin &
// Manocha 1996). It is 0 where they only touch or share a vertex or an edge and leave it to different sides, it does not depend on the
// frame, and it changes by no more than twice what vertices move by: rounding cannot make a crossing of facets that are apart or
// touch. Axes of edges parallel to 1e-8 are left out: the faces they stand for are narrower than that, so the depth is good to
// 1e-8 of the facets' size. Facets of one plane have no depth across it; they overlap if the same test within the plane tells so.
#include "gapflow/geometry/mesh_crossings.hpp"

#include "gapflow/geometry/facet_tree.hpp"
#include "gapflow/geometry/mesh_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace gapflow {
namespace {

constexpr double parallel = 1e-8; ///< sine of the angle below which a direction is not taken from two edges
constexpr double infinity = std::numeric_limits<double>::infinity();

/// A facet with what the test of pairs needs.
template <int D>
struct Plate {
    std::array<Vec<D>, D> corner;
    std::array<Vec<D>, D> edge; ///< unit vectors from corner i to the next; 0 if it has no length (2D: both along the segment)
    Vec<D> normal;              ///< unit vector; 0 if the facet is a needle
    double height;              ///< 3D: the least height of the triangle; 2D: the length
    double length;              ///< of the longest edge
};

template <int D>
Plate<D> plate_of(const SurfaceMesh<D>& mesh, int facet)
{
    Plate<D> plate;
    plate.length = 0;
    for (int i = 0; i < D; ++i)
        plate.corner[i] = mesh.vertices[mesh.elements[facet][i]];
    for (int i = 0; i < D; ++i) {
        const Vec<D> along = plate.corner[(i + 1) % D] - plate.corner[i];
        const double length = along.norm();
        plate.edge[i] = length > 0 ? Vec<D>(along / length) : Vec<D>(Vec<D>::Zero());
        plate.length = std::max(plate.length, length);
    }
    plate.normal.setZero();
    if constexpr (D == 2) {
        plate.normal = {plate.edge[0][1], -plate.edge[0][0]};
        plate.height = plate.length;
    } else {
        plate.height = infinity;
        for (int i = 0; i < 3; ++i) { // height over edge i; the normal from the two edges that are least parallel
            const Vec<3> normal = plate.edge[i].cross(plate.edge[(i + 1) % 3]);
            if (normal.squaredNorm() > plate.normal.squaredNorm())
                plate.normal = normal;
            const double side = (plate.corner[(i + 2) % 3] - plate.corner[(i + 1) % 3]).norm();
            plate.height = std::min(plate.height, side * normal.norm());
        }
        const double sine = plate.normal.norm();
        plate.normal = sine > parallel ? Vec<3>(plate.normal / sine) : Vec<3>(Vec<3>::Zero());
    }
    return plate;
}

/// The shortest shift along the unit vector that parts the two; negative: they are apart by so much.
template <int D>
double overlap(const Plate<D>& a, const Plate<D>& b, const Vec<D>& axis)
{
    double a_low = 0, a_high = 0, b_low = infinity, b_high = -infinity;
    for (int i = 0; i < D; ++i) {
        const double s = i == 0 ? 0 : axis.dot(a.corner[i] - a.corner[0]), t = axis.dot(b.corner[i] - a.corner[0]);
        a_low = std::min(a_low, s);
        a_high = std::max(a_high, s);
        b_low = std::min(b_low, t);
        b_high = std::max(b_high, t);
    }
    return std::min(a_high - b_low, b_high - a_low);
}

/// Depth of the two, or a depth of less than `enough` as soon as that is known.
template <int D>
double depth(const Plate<D>& a, const Plate<D>& b, double enough)
{
    double least = infinity;
    const auto seen = [&](const Vec<D>& axis) {
        least = std::min(least, overlap(a, b, axis));
        return least < enough;
    };
    for (const Plate<D>* plate : {&a, &b})
        if (plate->normal != Vec<D>::Zero() && seen(plate->normal))
            return least;
    if constexpr (D == 3)
        for (const Vec<3>& e : a.edge)
            for (const Vec<3>& f : b.edge) {
                const Vec<3> axis = e.cross(f);
                if (const double sine = axis.norm(); sine > parallel && seen(axis / sine))
                    return least;
            }
    return least;
}

/// Depth within the plane (2D: along the line) that both lie in, or a depth of no more than the tolerance as soon as that is known;
/// -infinity if they lie in none, to round-off.
template <int D>
double depth_in_plane(const Plate<D>& a, const Plate<D>& b, double tolerance, double largest_coordinate)
{
    const Plate<D>&flat = a.height > b.height ? a : b, &other = a.height > b.height ? b : a;
    if (!(other.height > tolerance) || flat.normal == Vec<D>::Zero())
        return -infinity;
    // Coordinates rounded a few times, seen from the plane of the larger facet over a distance of the longer edge.
    const double round_off = 8 * std::numeric_limits<double>::epsilon() * largest_coordinate *
                             (1 + std::max(flat.length, other.length) / flat.height);
    for (const Vec<D>& x : other.corner)
        if (!(std::abs(flat.normal.dot(x - flat.corner[0])) <= round_off))
            return -infinity;
    double least = infinity;
    if constexpr (D == 2)
        least = overlap(a, b, flat.edge[0]);
    else
        for (const Plate<3>* plate : {&a, &b})
            for (const Vec<3>& e : plate->edge) {
                if (const Vec<3> axis = flat.normal.cross(e); axis.norm() > 0.5)
                    least = std::min(least, overlap(a, b, Vec<3>(axis.normalized())));
                if (least <= tolerance)
                    return least;
            }
    return least;
}

/// Middle of what the edges of each have in common with the other; where none passes through, a point between those nearest to
/// their middles.
template <int D>
Vec<D> common_point(const Plate<D>& a, const Plate<D>& b, double tolerance)
{
    const Facet<D> facet_a{a.corner, a.normal}, facet_b{b.corner, b.normal};
    Vec<D> sum = Vec<D>::Zero();
    int count = 0;
    const auto add = [&](const Plate<D>& edges, const Facet<D>& facet) {
        for (int i = 0; i < (D == 2 ? 1 : 3); ++i) {
            const Vec<D>&x = edges.corner[i], &y = edges.corner[(i + 1) % D];
            const double s = facet.normal.dot(x - facet.corner[0]), t = facet.normal.dot(y - facet.corner[0]);
            if ((s > 0) == (t > 0))
                continue;
            const Vec<D> through = x + s / (s - t) * (y - x);
            if (closest_on(facet, through).distance2 <= tolerance * tolerance) {
                sum += through;
                ++count;
            }
        }
    };
    add(a, facet_b);
    add(b, facet_a);
    if (count > 0)
        return sum / count;
    Vec<D> middle_a = Vec<D>::Zero(), middle_b = middle_a;
    for (int i = 0; i < D; ++i) {
        middle_a += a.corner[i] / D;
        middle_b += b.corner[i] / D;
    }
    // Alternating projections on convex sets end in both; from the middles of both they end at two places of what they share.
    for (Vec<D>* x : {&middle_a, &middle_b})
        for (int k = 0; k < 100; ++k)
            *x = closest_on(facet_b, closest_on(facet_a, *x).x).x;
    return (middle_a + middle_b) / 2;
}

template <int D>
bool share_a_vertex(const std::array<int, D>& f, const std::array<int, D>& g)
{
    return std::find_first_of(f.begin(), f.end(), g.begin(), g.end()) != f.end();
}

template <int D>
std::vector<Plate<D>> plates_of(const SurfaceMesh<D>& mesh)
{
    std::vector<Plate<D>> plates;
    plates.reserve(mesh.elements.size());
    for (int f = 0; f < int(mesh.elements.size()); ++f)
        plates.push_back(plate_of(mesh, f));
    return plates;
}

template <int D>
FacetTree<D> tree_of(const std::vector<Plate<D>>& plates)
{
    std::vector<Facet<D>> facets;
    facets.reserve(plates.size());
    for (const Plate<D>& plate : plates)
        facets.push_back({plate.corner, plate.normal});
    return {facets, std::vector<int>(facets.size(), 0)};
}

template <int D>
void sort(std::vector<Crossing<D>>& crossings)
{
    std::sort(crossings.begin(), crossings.end(),
              [](const auto& s, const auto& t) { return std::tie(s.first, s.second) < std::tie(t.first, t.second); });
}

} // namespace

template <int D>
Crossings<D> find_crossings(const SurfaceMesh<D>& mesh, double tolerance)
{
    Crossings<D> found;
    if (mesh.elements.empty()) // all have collapsed
        return found;
    const std::vector<Plate<D>> plates = plates_of(mesh);
    double largest_coordinate = 0;
    for (const Vec<D>& x : mesh.vertices)
        largest_coordinate = std::max(largest_coordinate, x.cwiseAbs().maxCoeff());
    tree_of(plates).for_near_pairs(tolerance, [&](int f, int g) {
        const Plate<D>&a = plates[std::min(f, g)], &b = plates[std::max(f, g)];
        std::vector<Crossing<D>>* list = nullptr;
        if (depth(a, b, tolerance) > tolerance)
            list = &found.through;
        else if (depth_in_plane(a, b, tolerance, largest_coordinate) > tolerance)
            list = &found.flat;
        if (list)
            list->push_back({std::min(f, g), std::max(f, g), common_point(a, b, tolerance)});
        found.more = int(found.through.size() + found.flat.size()) >= Crossings<D>::largest_count;
        return !found.more;
    });
    sort(found.through);
    sort(found.flat);
    return found;
}

template <int D>
std::vector<Crossing<D>> find_crossings_along_ridges(const SurfaceMesh<D>& mesh, double tolerance)
{
    if (mesh.elements.empty())
        return {};
    const std::vector<Plate<D>> plates = plates_of(mesh);
    const FacetTree<D> tree = tree_of(plates);
    Vec<D> ray, weight; // of no direction and at no place that a mesh prefers
    for (int i = 0; i < D; ++i) {
        ray[i] = std::sqrt(2. + i) - 0.7;
        weight[i] = 1 + 0.3 * std::sqrt(3. + 2 * i);
    }
    weight /= weight.sum();
    enum class State : char { unknown, good, within };
    std::vector<State> states(plates.size(), State::unknown);
    const auto within = [&](int f) {
        if (states[f] != State::unknown)
            return states[f] == State::within;
        states[f] = State::good;
        if (plates[f].normal == Vec<D>::Zero())
            return false;
        Vec<D> x = Vec<D>::Zero();
        for (int i = 0; i < D; ++i)
            x += weight[i] * plates[f].corner[i];
        const Vec<D> arm = 2 * tolerance * plates[f].normal;
        const int out = tree.crossings(x + arm, ray), in = tree.crossings(x - arm, ray);
        if (out != 0 && in == out + 1 && std::abs(winding_number<D>(mesh, x + arm) - out) < 0.25 &&
            std::abs(winding_number<D>(mesh, x - arm) - in) < 0.25)
            states[f] = State::within;
        return states[f] == State::within;
    };
    std::vector<Crossing<D>> found;
    tree.for_near_pairs(tolerance, [&](int f, int g) {
        const Plate<D>&a = plates[std::min(f, g)], &b = plates[std::max(f, g)];
        if (!share_a_vertex<D>(mesh.elements[f], mesh.elements[g]) && depth(a, b, -tolerance) >= -tolerance &&
            (within(f) || within(g)))
            found.push_back({std::min(f, g), std::max(f, g), common_point(a, b, 2 * tolerance)});
        return int(found.size()) < Crossings<D>::largest_count;
    });
    sort(found);
    return found;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template Crossings<D> find_crossings<D>(const SurfaceMesh<D>&, double);                                                    \
    template std::vector<Crossing<D>> find_crossings_along_ridges<D>(const SurfaceMesh<D>&, double);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
