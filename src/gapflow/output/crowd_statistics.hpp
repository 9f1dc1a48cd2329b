// What a crowd does as a whole: means, fluctuations and percentiles over its bodies, and profiles over height.
#pragma once

#include "gapflow/body/rigid_body.hpp"
#include "gapflow/scene/scene.hpp"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace gapflow {

/// The axis that height is measured along: that of the largest component of gravity, without gravity the last one.
int height_axis(const Scene& scene);

/// Of the bodies of a crowd at one moment; all bodies count alike.
template <int D>
struct CrowdStatistics {
    static constexpr std::array<double, 3> shares{0.05, 0.5, 0.95}; ///< of the percentiles

    int number = 0;
    Vec<D> position = Vec<D>::Zero();    ///< mean of the centres of mass
    Vec<D> velocity = Vec<D>::Zero();    ///< mean
    Vec<D> fluctuation = Vec<D>::Zero(); ///< root mean square of the velocity less its mean, each component
    double spin = 0;                     ///< root mean square of the angular velocity's size
    std::array<double, 3> speed{};       ///< percentiles
    double largest_speed = 0;
    std::array<double, 3> height{}; ///< percentiles of the coordinate along the height's axis
    double energy = 0;              ///< kinetic, in sum
    Vec<D> force = Vec<D>::Zero();  ///< mean force of the fluid
};

/// `wrenches`: of the fluid, one of each body.
template <int D>
CrowdStatistics<D> crowd_statistics(std::span<const RigidBody<D>> bodies, std::span<const Twist<D>> wrenches, int height_axis);

/// A layer of the domain across the height's axis.
template <int D>
struct CrowdLayer {
    double height = 0;                ///< of its middle
    double number = 0;                ///< of bodies: each with the share of it that is in the layer
    double volume_fraction = 0;       ///< of the bodies
    Vec<D> velocity = Vec<D>::Zero(); ///< of the bodies, mean over their volume in the layer; NaN where there is none
};

/// Profiles over height: layers as thick as a mean body, 200 at most; what is beyond a periodic side comes in on the other. Balls are cut
/// exactly, other shapes by some 500 points in each.
template <int D>
std::vector<CrowdLayer<D>> crowd_profile(const Scene& scene, std::span<const RigidBody<D>> bodies);

/// Columns after step, time and crowd.
std::vector<std::string> crowd_columns(int dimension);
std::vector<std::string> profile_columns(int dimension);

} // namespace gapflow
