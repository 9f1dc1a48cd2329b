// Where two solids touch or are about to (method, "Contact"): local minima of the distance between their surfaces, and the
// ends of flat and straight contacts, so that resting bodies do not rock.
#pragma once

#include "gapflow/body/contact_features.hpp"
#include "gapflow/geometry/solid.hpp"

#include <functional>
#include <optional>
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

/// Two different solids, a < b, and the displacement of b's image that is near a.
template <int D>
struct NearPair {
    int a, b;
    Vec<D> shift;
};
/// Pairs whose surfaces may come within `reach`, each once. Periods as for images().
template <int D>
std::vector<NearPair<D>> near_pairs(std::span<const Solid<D>> solids, const Vec<D>& low, const Vec<D>& high,
                                    const Vec<D>& period, double reach);

/// How far two surfaces are apart where they are nearest.
template <int D>
struct Separation {
    Vec<D> place;    ///< between the nearest points
    Vec<D> normal;   ///< out of b, towards a
    double distance; ///< negative: overlap
};
/// Of a and b if they are nearer than `reach`.
template <int D>
std::optional<Separation<D>> separation(const PlacedShape<D>& a, const ContactFeatures<D>& of_a, const PlacedShape<D>& b,
                                        const ContactFeatures<D>& of_b, double reach);

/// Contact points closer than `reach(a, b)`, at most a few per contact patch: the deepest, then those furthest apart. Points
/// closer to each other than `merge` that face the same way are one. Ordered by solids. Periods as for images().
template <int D>
std::vector<ContactPoint<D>> find_contacts(std::span<const Solid<D>> solids, std::span<const ContactFeatures<D>> features,
                                           const Vec<D>& low, const Vec<D>& high, const Vec<D>& period,
                                           const std::function<double(int, int)>& reach, double largest_reach, double merge);

} // namespace gapflow
