// The mean flow along periodic axes (theory of the step, "Driven periodic boxes").
#pragma once

#include "gapflow/step/instant.hpp"

#include <array>
#include <optional>
#include <vector>

namespace gapflow {

/// Mean velocity of fluid and solids over the domain. Collective.
template <int D>
Vec<D> mean_velocity(const Model<D>& model, const Instant<D>& now, const std::vector<RigidBody<D>>& bodies);

/// What the fluid's kinetic energy has more than that of the motion relative to the stream, in a driven box. Collective.
template <int D>
double energy_of_stream(const Model<D>& model, const Instant<D>& now, const std::vector<RigidBody<D>>& bodies);

/// The stream of a step's passes; Drive::flow of a state on parts. The potential's jump over a period is the stream's times the period, and only the mean
/// gradient G of the pressure changes it: dU/dt = -G/rho. Where the mean velocity of fluid and solids is kept, G is what keeps it.
template <int D>
class MeanFlow {
public:
    MeanFlow(const Model<D>& model, const Instant<D>& old, double dt);

    /// Of the next pass. `last`: of the step before, or the pass.
    Drive<D> drive(const Drive<D>& last);
    /// After a pass: whether the mean velocity is kept. Collective.
    bool found(const Instant<D>& now, const std::vector<RigidBody<D>>& bodies);

private:
    const Model<D>& model_;
    Vec<D> start_, next_ = Vec<D>::Zero(), last_stream_ = Vec<D>::Zero(), last_mean_ = Vec<D>::Zero();
    double dt_;
    std::array<std::optional<double>, D> kept_;
    bool keeps_ = false;
    int pass_ = 0;
};

} // namespace gapflow
