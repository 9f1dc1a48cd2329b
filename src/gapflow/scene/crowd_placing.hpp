// Places for a crowd's bodies: at random, or on a lattice.
#pragma once

#include "gapflow/scene/crowd_room.hpp"
#include "gapflow/scene/random_numbers.hpp"

#include <optional>
#include <vector>

namespace gapflow {

template <int D>
struct CrowdPlan {
    Hull<D> hull;                ///< of a body of size factor 1
    std::vector<double> factors; ///< on the lengths of each body
    Region<D> region;
    double spacing = 0;
    std::optional<Rotation<D>> rotation; ///< of all; empty: of each at random
    double jitter = 0;                   ///< of a lattice: largest shift along an axis over the pitch
};

/// Of a body's hull.
template <int D>
struct CrowdPlace {
    Vec<D> centre;
    Rotation<D> rotation;
};

/// What was found: all places, or how many bodies went in.
template <int D>
struct CrowdPlaces {
    std::vector<CrowdPlace<D>> places;
    int found = 0;
};

/// Places without overlap, at least `spacing` apart and from what `room` holds, drawn from a uniform distribution one after the other,
/// the largest bodies first. Balls that find no more room that way, which is so from a volume fraction of about 0.38 on (disks: 0.54), are
/// pushed apart from places drawn without regard to overlap, and then shuffled by single moves that keep the distances (Metropolis et
/// al., J. Chem. Phys. 21, 1953), so that gaps are not all as thin as allowed. On return the room holds those found.
template <int D>
CrowdPlaces<D> place_at_random(const CrowdPlan<D>& plan, CrowdRoom<D>& room, RandomNumbers& random);

/// Places on a square or cubic lattice that fills a box, as evenly spaced as whole numbers of bodies along the axes allow; sites that
/// are more than bodies stay empty, evenly spread. With jitter each is then shifted at random, where the distances allow.
template <int D>
CrowdPlaces<D> place_on_lattice(const CrowdPlan<D>& plan, CrowdRoom<D>& room, RandomNumbers& random);

} // namespace gapflow
