#include "gapflow/step/force_passes.hpp"

#include <Eigen/QR>

#include <cmath>

namespace gapflow {
namespace {

/// a + factor (b - c).
template <int D>
void add_difference(std::vector<Twist<D>>& a, double factor, const std::vector<Twist<D>>& b, const std::vector<Twist<D>>& c)
{
    for (std::size_t s = 0; s < a.size(); ++s)
        a[s] += factor * (b[s] - c[s]);
}

} // namespace

template <int D>
ForcePasses<D>::ForcePasses(const std::vector<RigidBody<D>>& bodies, double density)
{
    for (const RigidBody<D>& body : bodies) {
        root_.push_back(TwistMatrix<D>::Zero());
        if (body.motion == Motion::free) {
            const double fluid = density * std::abs(body.volume);
            const TwistMatrix<D> mass = (1 + fluid / body.mass) * mass_matrix(body);
            root_.back() = Eigen::LLT<TwistMatrix<D>>(mass).matrixL().solve(TwistMatrix<D>::Identity());
        }
    }
}

template <int D>
Eigen::VectorXd ForcePasses<D>::scaled(const StepForces<D>& forces) const
{
    Eigen::VectorXd all(root_.size() * twist_size<D>);
    for (std::size_t b = 0; b < root_.size(); ++b)
        all.segment<twist_size<D>>(b * twist_size<D>) = root_[b] * (forces.mean[b] + forces.missing[b]);
    return all;
}

template <int D>
StepForces<D> ForcePasses<D>::next(const StepForces<D>& given, StepForces<D> answer)
{
    const Eigen::VectorXd error = scaled(answer) - scaled(given);
    const int count = static_cast<int>(answers_.size());
    StepForces<D> combined = answer;
    if (count > 1) { // most steps need no more
        Eigen::MatrixXd change(error.size(), count);
        for (int k = 0; k < count; ++k)
            change.col(k) = error - errors_[k];
        const Eigen::VectorXd share = change.completeOrthogonalDecomposition().solve(error);
        for (int k = 0; k < count; ++k) {
            add_difference<D>(combined.mean, -share[k], answer.mean, answers_[k].mean);
            add_difference<D>(combined.missing, -share[k], answer.missing, answers_[k].missing);
        }
    }
    answers_.push_back(std::move(answer));
    errors_.push_back(error);
    return combined;
}

template class ForcePasses<2>;
template class ForcePasses<3>;

} // namespace gapflow
