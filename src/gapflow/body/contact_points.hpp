// Where two solids touch or are about to (method, "Contact"): local minima of the distance between their surfaces, and the
// ends of flat and straight contacts, so that resting bodies do not rock.
#pragma once

#include "gapflow/body/contact_features.hpp"
#include "gapflow/geometry/solid.hpp"

#include <functional>
#include <span>
#include <vector>

namespace gapflow {

template <int D>
struct ContactPoint {
    int a, b;        ///< solids, a < b
    Vec<D> shift;    ///< of b's image that a meets (periodic domain)
    Vec<D> x, y;     ///< nearest points, of a and of b's image, world
    Vec<D> normal;   ///< out of b, towards a; x - y = distance * normal
    double distance; ///< negative: overlap
};

/// Rows of the relative velocity of a against b along a direction: row_a . twist_a + row_b . twist_b. Both act at one point,
/// so that an impulse along them conserves angular momentum.
template <int D>
struct RelativeRow {
    Twist<D> a, b;
};
template <int D>
RelativeRow<D> relative_row(const ContactPoint<D>& contact, std::span<const Solid<D>> solids, const Vec<D>& direction);

/// Contact points closer than `reach(a, b)`, at most a few per contact patch: the deepest, then those furthest apart. Points
/// closer to each other than `merge` that face the same way are one. Ordered by solids. Periods as for images().
template <int D>
std::vector<ContactPoint<D>> find_contacts(std::span<const Solid<D>> solids, std::span<const ContactFeatures<D>> features,
                                           const Vec<D>& low, const Vec<D>& high, const Vec<D>& period,
                                           const std::function<double(int, int)>& reach, double largest_reach, double merge);

} // namespace gapflow
