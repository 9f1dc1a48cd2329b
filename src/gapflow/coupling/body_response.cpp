// Method of multipliers: with F = M + C^T k C,
//
//     V = F^-1 (w + C^T (k s + lambda)),     lambda += k (s - C V)
//
// a few times: each pass reduces C V - s by the factor k C M^-1 C^T. Redundant rows are allowed: they share their impulse evenly. For a row
// with resistance k the first V is exact, and lambda = k (s - C V) is not part of the iteration.
#include "gapflow/coupling/body_response.hpp"

#include "gapflow/core/error.hpp"

namespace gapflow {

namespace {

// Stiffness of a contact relative to the bodies' own, 1 / (c M^-1 c^T): the factorisation loses as many digits as the stiffness has.
constexpr double relative_stiffness = 1e4;
// Passes end where all contacts keep their speeds to round-off, of the speeds of the bodies' points there. That takes three or four, and more where rows nearly
// depend on each other: after four passes such contacts of examples/11_pile still moved by 1e-5 of the speeds.
constexpr int most_passes = 12;
constexpr double round_off = 4e-15;

} // namespace

BodyResponse::BodyResponse(const Eigen::SparseMatrix<double>& mass, const Eigen::SparseMatrix<double>& contact,
                           const Eigen::VectorXd& resistance)
    : contact_(contact), contact_size_(contact.cwiseAbs()), stiffness_(contact.rows()),
      rigid_(Eigen::VectorXd::Ones(contact.rows()))
{
    if (mass.rows() == 0)
        return;
    const Eigen::VectorXd inverse_mass = mass.diagonal().cwiseInverse();
    const Eigen::VectorXd mobility = contact.cwiseAbs2() * inverse_mass;
    for (long r = 0; r < mobility.size(); ++r) // 0: neither body can yield
        stiffness_[r] = mobility[r] > 0 ? relative_stiffness / mobility[r] : 0.0;
    for (long r = 0; r < mobility.size(); ++r)
        if (resistance[r] < stiffness_[r]) {
            stiffness_[r] = resistance[r];
            rigid_[r] = 0;
        }
    factorise(mass);
}

BodyResponse BodyResponse::of_mass(const Eigen::SparseMatrix<double>& mass) const
{
    BodyResponse result = *this;
    result.factorise(mass);
    return result;
}

void BodyResponse::factorise(const Eigen::SparseMatrix<double>& mass)
{
    const auto factor = std::make_shared<SparseCholesky>();
    factor_ = factor;
    if (!factor->compute(contact_.rows() == 0
                             ? mass
                             : mass + Eigen::SparseMatrix<double>(contact_.transpose() * stiffness_.asDiagonal() * contact_)))
        throw ComputationError("the mass matrix of the free bodies is not positive definite");
}

Eigen::VectorXd BodyResponse::operator()(const Eigen::VectorXd& w, Eigen::VectorXd* lambda) const
{
    return (*this)(w, Eigen::VectorXd::Zero(contact_.rows()), lambda);
}

Eigen::MatrixXd BodyResponse::of_columns(const Eigen::MatrixXd& w) const
{
    if (contact_.rows() == 0)
        return factor_->solve_columns(w);
    Eigen::MatrixXd impulse = Eigen::MatrixXd::Zero(contact_.rows(), w.cols()), V;
    for (int pass = 0; pass < most_passes; ++pass) {
        V = factor_->solve_columns(w + contact_.transpose() * impulse);
        const Eigen::MatrixXd difference = contact_ * V, size = contact_size_ * V.cwiseAbs();
        impulse -= rigid_.cwiseProduct(stiffness_).asDiagonal() * difference;
        const auto left = (rigid_.asDiagonal() * difference).cwiseAbs().colwise().maxCoeff();
        if ((left.array() <= round_off * size.colwise().maxCoeff().array()).all())
            break;
    }
    return V;
}

Eigen::VectorXd BodyResponse::operator()(const Eigen::VectorXd& w, const Eigen::VectorXd& speed, Eigen::VectorXd* lambda) const
{
    if (contact_.rows() == 0) {
        if (lambda)
            lambda->resize(0);
        return factor_->solve(w);
    }
    Eigen::VectorXd impulse = Eigen::VectorXd::Zero(contact_.rows()), V;
    for (int pass = 0; pass < most_passes; ++pass) {
        V = factor_->solve(w + contact_.transpose() * (stiffness_.cwiseProduct(speed) + impulse));
        const Eigen::VectorXd difference = speed - contact_ * V, more = stiffness_.cwiseProduct(difference);
        if (lambda)
            *lambda = impulse + more;
        impulse += rigid_.cwiseProduct(more);
        const Eigen::VectorXd size = speed.cwiseAbs() + contact_size_ * V.cwiseAbs();
        if (rigid_.cwiseProduct(difference).lpNorm<Eigen::Infinity>() <= round_off * size.lpNorm<Eigen::Infinity>())
            break;
    }
    return V;
}

} // namespace gapflow
