#include "gapflow/step/mean_flow.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {

template <int D>
Vec<D> mean_velocity(const Model<D>& model, const Instant<D>& now, const std::vector<RigidBody<D>>& bodies)
{
    Vec<D> momentum = Vec<D>::Zero();
    for (std::size_t s = 0; s < now.impulse.size(); ++s) {
        momentum += now.impulse[s].template head<D>();
        if (s < bodies.size()) {
            const Displacement<D> displaced = displacement(bodies[s]);
            momentum += model.scene.density * displaced.volume * velocity_at<D>(now.flow.twists[s], displaced.arm);
        }
    }
    return now.stream + momentum / (model.scene.density * model.grid.size().prod());
}

template <int D>
double energy_of_stream(const Model<D>& model, const Instant<D>& now, const std::vector<RigidBody<D>>& bodies)
{
    if (!model.driven())
        return 0;
    double volume = model.grid.size().prod(), sum = 0;
    for (const RigidBody<D>& body : bodies)
        volume -= body.volume;
    for (const Twist<D>& impulse : now.impulse)
        sum += now.stream.dot(impulse.template head<D>());
    return sum + 0.5 * model.scene.density * volume * now.stream.squaredNorm();
}

template <int D>
MeanFlow<D>::MeanFlow(const Model<D>& model, const Instant<D>& old, double dt) : model_(model), start_(old.stream), dt_(dt)
{
    for (int axis = 0; axis < D; ++axis) {
        kept_[axis] = model.kept_velocity(axis);
        keeps_ = keeps_ || kept_[axis];
    }
}

template <int D>
Drive<D> MeanFlow<D>::drive(const Drive<D>& last)
{
    Drive<D> drive;
    const double density = model_.scene.density;
    if (model_.scene.pressure_gradient)
        drive.gradient = to_vec<D>(*model_.scene.pressure_gradient);
    if (pass_ == 0)
        next_ = start_ - dt_ / density * last.gradient;
    for (int axis = 0; axis < D; ++axis)
        if (kept_[axis])
            drive.gradient[axis] = density / dt_ * (start_[axis] - next_[axis]);
    drive.flow = start_ - dt_ / density * drive.gradient;
    return drive;
}

// The next pass's stream follows from those of the last two: the mean depends on it almost linearly.
template <int D>
bool MeanFlow<D>::found(const Instant<D>& now, const std::vector<RigidBody<D>>& bodies)
{
    if (!keeps_)
        return true;
    const Vec<D> mean = mean_velocity(model_, now, bodies);
    double error = 0, speed = now.stream.norm();
    for (int axis = 0; axis < D; ++axis) {
        if (!kept_[axis])
            continue;
        const double change = now.stream[axis] - last_stream_[axis], answer = mean[axis] - last_mean_[axis],
                     missing = *kept_[axis] - mean[axis];
        next_[axis] = now.stream[axis] + (pass_ > 0 && change * answer > 0 ? missing * change / answer : missing);
        error = std::max(error, std::abs(missing));
    }
    for (std::size_t b = 0; b < bodies.size(); ++b)
        speed = std::max(speed, now.flow.twists[b].template head<D>().norm());
    last_stream_ = now.stream;
    last_mean_ = mean;
    ++pass_;
    return error <= model_.scene.tolerance * speed;
}

template Vec<2> mean_velocity<2>(const Model<2>&, const Instant<2>&, const std::vector<RigidBody<2>>&);
template Vec<3> mean_velocity<3>(const Model<3>&, const Instant<3>&, const std::vector<RigidBody<3>>&);
template double energy_of_stream<2>(const Model<2>&, const Instant<2>&, const std::vector<RigidBody<2>>&);
template double energy_of_stream<3>(const Model<3>&, const Instant<3>&, const std::vector<RigidBody<3>>&);
template class MeanFlow<2>;
template class MeanFlow<3>;

} // namespace gapflow
