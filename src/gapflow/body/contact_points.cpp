// Every feature of each body against the other's surface: with a core of radius r about p, distance = |p - closest(p)| - r.
// Straight edges against each other: n = +- e_a x e_b where n lies between the normals of the faces that meet in each edge.
#include "gapflow/body/contact_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

namespace gapflow {

namespace {

// Relative to the bodies' sizes: round-off in the position of a surface point.
constexpr double round_off = 1e-9;
// Most points per pair: a contact patch needs its corners.
template <int D>
constexpr int most_points = D == 2 ? 4 : 8;
constexpr double nearly_beyond = 0.02;  // of a body's size
constexpr int parts_against_hollow = 4; // of a long feature, against shapes with several nearest places

/// A touches B's surface; collects points as (x on A, y on B, normal out of B, distance).
template <int D>
class Search {
public:
    struct Found {
        Vec<D> x, y, normal;
        double distance;
    };

    Search(const PlacedShape<D>& a, const ContactFeatures<D>& of_a, const PlacedShape<D>& b, const ContactFeatures<D>& of_b,
           const Bounds<D>& bounds_b, double reach, bool swapped, std::vector<Found>& found)
        : a_(a), of_a_(of_a), b_(b), of_b_(of_b), bounds_b_(bounds_b), reach_(reach), swapped_(swapped), found_(found)
    {
    }

    void run()
    {
        for (const Core<D>& core : of_a_.cores)
            add_segment(a_.to_world(core.from), a_.to_world(core.to), core.radius);
        for (std::size_t v = 0; v < of_a_.vertices.size(); ++v)
            add_point(a_.to_world(of_a_.vertices[v]), 0, static_cast<int>(v));
        if constexpr (D == 3)
            for (const ContactEdge& edge : of_a_.edges)
                if (!edge.straight)
                    add_rim(edge);
    }

private:
    bool out_of_reach(const Vec<D>& p, double radius) const
    {
        const double margin = reach_ + radius;
        return (p.array() < bounds_b_.low.array() - margin).any() || (p.array() > bounds_b_.high.array() + margin).any();
    }

    void add(const Vec<D>& p, double radius, const Vec<D>& y, const Vec<D>& normal, double distance)
    {
        if (distance > reach_ || !normal.allFinite())
            return;
        const Vec<D> x = p - radius * normal;
        // The side of a cylinder ends somewhere.
        if (radius > 0 && std::abs(a_.distance(x)) > 1e-6 * radius)
            return;
        if (swapped_)
            found_.push_back({y, x, Vec<D>(-normal), distance});
        else
            found_.push_back({x, y, normal, distance});
    }

    /// A ball of the given radius about p (0: a vertex, with its number among A's features if it is one) against B.
    void add_point(const Vec<D>& p, double radius, int vertex = -1)
    {
        if (!b_.shape().inside_out() && out_of_reach(p, radius))
            return;
        const bool each_patch = !b_.shape().convex() && (radius > 0 || b_.shape().inside_out());
        if (!each_patch) {
            const SurfacePoint<D> q = b_.closest(p);
            const double size = std::max(p.cwiseAbs().maxCoeff(), q.x.cwiseAbs().maxCoeff());
            const bool no_direction = q.feature != Feature::face && std::abs(q.distance) < round_off * size;
            if (radius == 0 && q.distance < round_off * size && a_.shape().convex() && b_.shape().convex() &&
                (no_direction || !lies_beyond(p, q.normal, -q.distance))) {
                add_vertex_inside(p, size, [&](const Vec<D>& n, double depth) { return lies_beyond(p, n, depth); });
                return;
            }
            // A mesh may reach around B: only its material at the vertex tells. In a corner the nearest face may be one that it never passed.
            const auto into_material = [&](const Vec<D>& n) {
                double sum = 0;
                for (const Vec<D>& arm : of_a_.beside[vertex])
                    sum += n.dot(a_.rotation() * arm);
                return sum;
            };
            if (q.distance < -round_off * size && vertex >= 0 && !a_.shape().convex() && !a_.shape().inside_out() &&
                b_.shape().convex() && into_material(q.normal) < 0 &&
                add_vertex_inside(p, size, [&](const Vec<D>& n, double) { return into_material(n) > 0; }))
                return;
            if (no_direction)
                return; // the bodies' faces and edges find this place too
            // Where two corners touch, the nearest face may be one that ends there, with A on both sides of its plane.
            if (vertex >= 0 && std::abs(q.distance) < round_off * size && !in_front(vertex, q.normal)) {
                add_vertex_inside(p, size, [&](const Vec<D>& n, double) { return in_front(vertex, n); });
                return;
            }
            add(p, radius, q.x, q.normal, q.distance - radius);
            return;
        }
        if (b_.distance(p) - radius > reach_)
            return;
        for (int patch = 0; patch < of_b_.patches; ++patch) {
            const Vec<D> y = b_.onto(p, patch);
            const double size = std::max(p.cwiseAbs().maxCoeff(), y.cwiseAbs().maxCoeff());
            if (std::abs(b_.distance(y)) > round_off * size)
                continue; // past the patch's border
            Vec<D> normal = b_.patch_normal(y, patch);
            const double along = normal.dot(p - y);
            if (radius > 0) {
                const double length = (p - y).norm();
                if (along <= 0 || along < 0.5 * length) // behind the surface, or beside the patch
                    continue;
                normal = (p - y) / length;
                add(p, radius, y, normal, length - radius);
            } else if ((p - y - along * normal).norm() <= round_off * size) {
                add(p, 0, y, normal, along);
            }
        }
    }

    /// Whether A's surface at its vertex lies on the outer side of a face of B with this normal, or nearly.
    bool in_front(int vertex, const Vec<D>& normal) const
    {
        const std::vector<Vec<D>>& beside = of_a_.beside[vertex];
        return std::all_of(beside.begin(), beside.end(),
                           [&](const Vec<D>& arm) { return normal.dot(a_.rotation() * arm) >= -nearly_beyond; });
    }

    /// Whether A lies on the outer side of a face of B with this normal that its vertex p is so deep behind, or nearly.
    bool lies_beyond(const Vec<D>& p, const Vec<D>& normal, double depth) const
    {
        double lowest = 0, extent = 0;
        for (const Vec<D>& vertex : of_a_.vertices) {
            const Vec<D> arm = a_.to_world(vertex) - p;
            lowest = std::min(lowest, normal.dot(arm));
            extent = std::max(extent, arm.norm());
        }
        return lowest >= -2 * depth - nearly_beyond * extent;
    }

    /// A vertex of A in a convex B or on its edge, if A's material is not on the outer side of the nearest face (as with overlapping flush
    /// boxes): the nearest face for which it is. False if there is none.
    template <class IsBeyond>
    bool add_vertex_inside(const Vec<D>& p, double size, IsBeyond&& is_beyond)
    {
        Vec<D> place = p, normal = p;
        double depth = std::numeric_limits<double>::infinity();
        for (int patch = 0; patch < of_b_.patches; ++patch) {
            const Vec<D> y = b_.onto(p, patch);
            if (std::abs(b_.distance(y)) > round_off * size)
                continue; // past the patch's border
            const Vec<D> n = b_.patch_normal(y, patch);
            const double d = n.dot(y - p);
            if (d > -round_off * size && d < depth && (y - p - d * n).norm() <= round_off * size && is_beyond(n, d)) {
                place = y;
                normal = n;
                depth = d;
            }
        }
        if (std::isfinite(depth))
            add(p, 0, place, normal, -depth);
        return std::isfinite(depth);
    }

    void add_segment(const Vec<D>& from, const Vec<D>& to, double radius)
    {
        add_point(from, radius);
        if (from == to)
            return;
        add_point(to, radius);
        const int parts = b_.shape().convex() ? 1 : parts_against_hollow;
        const Vec<D> direction = to - from;
        // Bisection on the slope n . direction of the distance along the segment.
        auto slope = [&](double t) { return b_.closest(from + t * direction).normal.dot(direction); };
        const double flat = 1e-12 * direction.norm();
        for (int k = 0; k < parts; ++k) {
            double low = static_cast<double>(k) / parts, high = static_cast<double>(k + 1) / parts;
            if (!(slope(low) < -flat && slope(high) > flat))
                continue;
            for (int i = 0; i < 60 && high - low > 1e-14; ++i) {
                const double middle = 0.5 * (low + high);
                (slope(middle) < 0 ? low : high) = middle;
            }
            add_point(from + 0.5 * (low + high) * direction, radius);
        }
    }

    /// Lowest point between the ends of a chord of a curved rim (the ends are vertices).
    void add_rim(const ContactEdge& edge)
    {
        auto at = [&](double t) {
            const Vec<D> chord = edge.from + t * (edge.to - edge.from);
            return a_.to_world(a_.shape().onto(a_.shape().onto(chord, edge.patch_a), edge.patch_b));
        };
        if (out_of_reach(at(0.5), (edge.to - edge.from).norm()))
            return;
        auto height = [&](double t) { return b_.distance(at(t)); };
        double low = 0, high = 1;
        constexpr double nudge = 1e-4, golden = 0.6180339887498949;
        if (height(nudge) >= height(0) || height(1 - nudge) >= height(1))
            return;
        double left = high - golden * (high - low), right = low + golden * (high - low);
        double at_left = height(left), at_right = height(right);
        for (int i = 0; i < 36; ++i)
            if (at_left < at_right) {
                high = right;
                right = left;
                at_right = at_left;
                left = high - golden * (high - low);
                at_left = height(left);
            } else {
                low = left;
                left = right;
                at_left = at_right;
                right = low + golden * (high - low);
                at_right = height(right);
            }
        add_point(at(0.5 * (low + high)), 0);
    }

    const PlacedShape<D>& a_;
    const ContactFeatures<D>& of_a_;
    const PlacedShape<D>& b_;
    const ContactFeatures<D>& of_b_;
    const Bounds<D>& bounds_b_;
    double reach_;
    bool swapped_;
    std::vector<Found>& found_;
};

// n lies between the normals of two faces that meet in an edge (all perpendicular to it).
bool between(const Vec<3>& n, const Vec<3>& normal_a, const Vec<3>& normal_b, const Vec<3>& along)
{
    const double turn = normal_a.cross(normal_b).dot(along);
    constexpr double slack = 1e-9;
    return turn * normal_a.cross(n).dot(along) >= -slack && turn * n.cross(normal_b).dot(along) >= -slack &&
           n.dot(normal_a + normal_b) > 0;
}

void add_edge_pairs(const PlacedShape<3>& a, const ContactFeatures<3>& of_a, const PlacedShape<3>& b,
                    const ContactFeatures<3>& of_b, const Bounds<3>& bounds_b, double reach,
                    std::vector<Search<3>::Found>& found)
{
    struct Placed {
        Vec<3> from, along, normal_a, normal_b;
    };
    auto placed = [](const PlacedShape<3>& shape, const ContactEdge& edge) {
        const Vec<3> from = shape.to_world(edge.from);
        return Placed{from, shape.to_world(edge.to) - from, shape.rotation() * edge.normal_a, shape.rotation() * edge.normal_b};
    };
    std::vector<Placed> edges_b;
    for (const ContactEdge& edge : of_b.edges)
        if (edge.straight)
            edges_b.push_back(placed(b, edge));
    if (edges_b.empty())
        return;
    for (const ContactEdge& edge : of_a.edges) {
        if (!edge.straight)
            continue;
        const Placed p = placed(a, edge);
        const Vec<3> end = p.from + p.along, low = p.from.cwiseMin(end), high = p.from.cwiseMax(end);
        if ((high.array() < bounds_b.low.array() - reach).any() || (low.array() > bounds_b.high.array() + reach).any())
            continue;
        for (const Placed& q : edges_b) {
            const Vec<3> across = p.along.cross(q.along);
            const double size = p.along.norm() * q.along.norm();
            if (across.norm() < 1e-6 * size)
                continue; // parallel: the test of their ends finds the contact
            // p.from + s p.along and q.from + t q.along, nearest points of the two lines.
            const Vec<3> d = q.from - p.from;
            const double s = d.cross(q.along).dot(across) / across.squaredNorm();
            const double t = d.cross(p.along).dot(across) / across.squaredNorm();
            if (s < 0 || s > 1 || t < 0 || t > 1)
                continue;
            const Vec<3> x = p.from + s * p.along, y = q.from + t * q.along;
            Vec<3> n = across.normalized();
            if (n.dot(q.normal_a + q.normal_b) < 0)
                n = -n;
            const double distance = n.dot(x - y);
            if (std::abs(distance) > reach || !between(n, q.normal_a, q.normal_b, q.along) ||
                !between(-n, p.normal_a, p.normal_b, p.along))
                continue;
            found.push_back({x, y, n, distance});
        }
    }
}

// Deepest first, then the one furthest from those chosen.
template <int D>
std::vector<typename Search<D>::Found> chosen_of(std::vector<typename Search<D>::Found> found, double merge)
{
    using Found = typename Search<D>::Found;
    std::stable_sort(found.begin(), found.end(), [](const Found& p, const Found& q) { return p.distance < q.distance; });
    std::vector<Found> chosen;
    std::vector<double> apart(found.size(), std::numeric_limits<double>::infinity());
    auto separation = [&](const Found& p, const Found& q) { // points that face different ways are far apart
        return p.normal.dot(q.normal) > 0.99 ? (p.x - q.x).norm() : std::numeric_limits<double>::infinity();
    };
    while (static_cast<int>(chosen.size()) < most_points<D> && chosen.size() < found.size()) {
        std::size_t best = 0;
        for (std::size_t i = 1; i < found.size(); ++i)
            if (apart[i] > apart[best])
                best = i;
        if (apart[best] <= merge)
            break;
        chosen.push_back(found[best]);
        for (std::size_t i = 0; i < found.size(); ++i)
            apart[i] = std::min(apart[i], i == best ? 0.0 : separation(found[i], found[best]));
    }
    return chosen;
}

// All places of two solids where one's feature comes within reach of the other's surface.
template <int D>
std::vector<typename Search<D>::Found> found_between(const PlacedShape<D>& a, const ContactFeatures<D>& of_a,
                                                     const PlacedShape<D>& b, const ContactFeatures<D>& of_b, double reach)
{
    const Bounds<D> bounds_a = world_bounds(a), bounds_b = world_bounds(b);
    std::vector<typename Search<D>::Found> found;
    Search<D>(a, of_a, b, of_b, bounds_b, reach, false, found).run();
    Search<D>(b, of_b, a, of_a, bounds_a, reach, true, found).run();
    if constexpr (D == 3)
        add_edge_pairs(a, of_a, b, of_b, bounds_b, reach, found);
    return found;
}

} // namespace

template <int D>
RelativeRow<D> relative_row(const ContactPoint<D>& contact, std::span<const Solid<D>> solids, const Vec<D>& direction)
{
    const Vec<D> at = 0.5 * (contact.x + contact.y);
    return {wrench<D>(direction, at - solids[contact.a].centre),
            Twist<D>(-wrench<D>(direction, at - solids[contact.b].centre - contact.shift))};
}

template <int D>
std::vector<NearPair<D>> near_pairs(std::span<const Solid<D>> solids, const Vec<D>& low, const Vec<D>& high,
                                    const Vec<D>& period, double reach)
{
    const std::vector<Image<D>> placed = images<D>(solids, low, high, period, reach);
    std::vector<NearPair<D>> pairs;
    std::set<std::tuple<int, int, std::array<int, D>>> seen; // the same pair may be near in several periods
    for (auto [i, j] : close_images<D>(placed, solids, reach)) {
        if (placed[i].solid > placed[j].solid)
            std::swap(i, j);
        const int a = placed[i].solid, b = placed[j].solid;
        if (a == b)
            continue;
        Vec<D> shift = placed[j].shift - placed[i].shift;
        if (!placed[i].bounds.low.allFinite() || !placed[j].bounds.low.allFinite())
            shift.setZero();
        std::array<int, D> periods{};
        for (int axis = 0; axis < D; ++axis)
            periods[axis] = period[axis] > 0 ? static_cast<int>(std::lround(shift[axis] / period[axis])) : 0;
        if (seen.insert({a, b, periods}).second)
            pairs.push_back({a, b, shift});
    }
    return pairs;
}

template <int D>
std::vector<ContactPoint<D>> find_contacts(std::span<const Solid<D>> solids, std::span<const ContactFeatures<D>> features,
                                           const Vec<D>& low, const Vec<D>& high, const Vec<D>& period,
                                           const std::function<double(int, int)>& reach, double largest_reach, double merge)
{
    std::vector<ContactPoint<D>> contacts;
    for (const auto& [a, b, shift] : near_pairs<D>(solids, low, high, period, largest_reach)) {
        if (solids[a].motion != Motion::free && solids[b].motion != Motion::free)
            continue;
        auto found = found_between(solids[a].shape, features[a], solids[b].shape.shifted(shift), features[b], reach(a, b));
        for (const auto& f : chosen_of<D>(std::move(found), merge))
            contacts.push_back({a, b, shift, f.x, f.y, f.normal, f.distance});
    }
    std::stable_sort(contacts.begin(), contacts.end(),
                     [](const auto& p, const auto& q) { return std::pair(p.a, p.b) < std::pair(q.a, q.b); });
    return contacts;
}

template <int D>
std::optional<Separation<D>> separation(const PlacedShape<D>& a, const ContactFeatures<D>& of_a, const PlacedShape<D>& b,
                                        const ContactFeatures<D>& of_b, double reach)
{
    std::optional<Separation<D>> least;
    for (const auto& f : found_between(a, of_a, b, of_b, reach))
        if (!least || f.distance < least->distance)
            least = {0.5 * (f.x + f.y), f.normal, f.distance};
    return least;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template RelativeRow<D> relative_row<D>(const ContactPoint<D>&, std::span<const Solid<D>>, const Vec<D>&);                 \
    template std::vector<NearPair<D>> near_pairs<D>(std::span<const Solid<D>>, const Vec<D>&, const Vec<D>&, const Vec<D>&,    \
                                                    double);                                                                   \
    template std::vector<ContactPoint<D>> find_contacts<D>(std::span<const Solid<D>>, std::span<const ContactFeatures<D>>,     \
                                                           const Vec<D>&, const Vec<D>&, const Vec<D>&,                        \
                                                           const std::function<double(int, int)>&, double, double);            \
    template std::optional<Separation<D>> separation<D>(const PlacedShape<D>&, const ContactFeatures<D>&,                      \
                                                        const PlacedShape<D>&, const ContactFeatures<D>&, double);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
