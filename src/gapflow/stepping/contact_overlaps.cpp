// Removes overlaps of bodies (method, "Contact") by the smallest displacements.
#include "gapflow/body/move.hpp"
#include "gapflow/stepping/contact_rows.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gapflow {

namespace {

// In dx. Overlaps below this are left at the start; no contact is opened further in one pass.
constexpr double start_overlap_left = 1e-9;
constexpr double longest_start_displacement = 0.5; // most_overlap in steps
// Limit of a displacement, in multiples of the sum of overlaps in a connected group of bodies; beyond it the metric without
// masses is used. (A light ball squeezed
// by half a cell between two boxes, turned by 5 degrees, slips out sideways by nearly six cells before boxes of a thousand times its mass move.)
constexpr double too_far = 2;
constexpr double wedge_compliance = 1e-2; // of the bodies' own mobility

template <int D>
bool is_free(const std::vector<RigidBody<D>>& bodies, int solid)
{
    return solid < static_cast<int>(bodies.size()) && bodies[solid].motion == Motion::free;
}

} // namespace

// Smallest displacements that leave no overlap, by projected Gauss-Seidel: in the metric of mass, or `evenly`, in one without
// masses. The latter has a small compliance, so that wedged bodies share the overlap instead of cycling.
template <int D>
std::vector<Twist<D>> ContactSet<D>::displacements(const std::vector<RigidBody<D>>& bodies, bool evenly, double longest,
                                                   double accuracy) const
{
    std::vector<Twist<D>> moved(bodies.size(), Twist<D>::Zero());
    auto response = [&](int s, const Twist<D>& row) -> Twist<D> {
        if (!is_free(bodies, s))
            return Twist<D>::Zero();
        const Twist<D> answer = twist_after(bodies[s], row) - twist_after(bodies[s], Twist<D>(Twist<D>::Zero()));
        return evenly ? Twist<D>(bodies[s].mass * answer) : answer;
    };
    struct Row {
        Twist<D> response_a, response_b;
        double mobility, multiplier = 0;
    };
    std::vector<Row> rows;
    for (const Contact<D>& c : contacts_) {
        Row row{response(c.point.a, c.normal.a), response(c.point.b, c.normal.b), 0};
        row.mobility = row.response_a.dot(c.normal.a) + row.response_b.dot(c.normal.b);
        rows.push_back(row);
    }
    for (int sweep = 0; sweep < (evenly ? 1000 : 100); ++sweep) {
        double largest = 0;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const Contact<D>& c = contacts_[i];
            Row& row = rows[i];
            if (row.mobility <= 0)
                continue;
            double distance = c.point.distance;
            if (is_free(bodies, c.point.a))
                distance += c.normal.a.dot(moved[c.point.a]);
            if (is_free(bodies, c.point.b))
                distance += c.normal.b.dot(moved[c.point.b]);
            const double compliance = evenly ? wedge_compliance * row.mobility : 0.0;
            const double lack = std::min(c.least_distance, c.point.distance + longest) - distance - compliance * row.multiplier;
            const double multiplier = std::max(row.multiplier + lack / (row.mobility + compliance), 0.0);
            const double change = multiplier - row.multiplier;
            row.multiplier = multiplier;
            if (is_free(bodies, c.point.a))
                moved[c.point.a] += change * row.response_a;
            if (is_free(bodies, c.point.b))
                moved[c.point.b] += change * row.response_b;
            largest = std::max(largest, std::abs(change) * row.mobility);
        }
        if (largest < 0.1 * accuracy)
            break;
    }
    return moved;
}

// Whether some body would move further, at its centre or a contact, than the limit given by the overlaps of its connected
// group.
template <int D>
bool ContactSet<D>::goes_too_far(const std::vector<RigidBody<D>>& bodies, const std::vector<Twist<D>>& moved,
                                 double longest) const
{
    std::vector<int> parent(bodies.size());
    std::iota(parent.begin(), parent.end(), 0);
    auto root = [&](int b) {
        while (parent[b] != b)
            b = parent[b] = parent[parent[b]];
        return b;
    };
    for (const Contact<D>& c : contacts_)
        if (is_free(bodies, c.point.a) && is_free(bodies, c.point.b))
            parent[root(c.point.a)] = root(c.point.b);
    std::vector<double> asked(bodies.size(), 0.0), furthest(bodies.size(), 0.0);
    for (const Contact<D>& c : contacts_) {
        const int member = root(is_free(bodies, c.point.a) ? c.point.a : c.point.b);
        asked[member] += std::clamp(c.least_distance - c.point.distance, 0.0, longest);
        const Vec<D> at = 0.5 * (c.point.x + c.point.y);
        auto look = [&](int s, const Vec<D>& x) {
            if (is_free(bodies, s))
                furthest[member] = std::max({furthest[member], moved[s].template head<D>().norm(),
                                             velocity_at<D>(moved[s], x - bodies[s].centre()).norm()});
        };
        look(c.point.a, at);
        look(c.point.b, at - c.point.shift);
    }
    for (std::size_t b = 0; b < bodies.size(); ++b)
        if (furthest[b] > too_far * asked[b])
            return true;
    return false;
}

template <int D>
bool ContactSet<D>::separate(std::vector<RigidBody<D>>& bodies, bool at_start) const
{
    const double accuracy = (at_start ? start_overlap_left : overlap_left) * dx_,
                 longest = (at_start ? longest_start_displacement : most_overlap) * dx_;
    double deepest = 0;
    for (const Contact<D>& c : contacts_)
        deepest = std::max(deepest, c.least_distance - c.point.distance);
    if (deepest <= accuracy)
        return false;
    std::vector<Twist<D>> moved = displacements(bodies, at_start, longest, accuracy);
    if (!at_start && goes_too_far(bodies, moved, longest))
        moved = displacements(bodies, true, longest, accuracy);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (moved[b].isZero(0))
            continue;
        displace<D>(bodies[b], moved[b].template head<D>(), moved[b].template tail<spin_size<D>>());
    }
    return true;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template std::vector<Twist<D>> ContactSet<D>::displacements(const std::vector<RigidBody<D>>&, bool, double, double) const; \
    template bool ContactSet<D>::goes_too_far(const std::vector<RigidBody<D>>&, const std::vector<Twist<D>>&, double) const;   \
    template bool ContactSet<D>::separate(std::vector<RigidBody<D>>&, bool) const;
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
