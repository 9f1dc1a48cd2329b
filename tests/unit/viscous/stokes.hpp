// Steady Stokes flow of a viscous form, for tests: a direct solver of the velocities, conjugate gradients of the pressures.
#pragma once

#include "gapflow/viscous/form.hpp"

#include <Eigen/CholmodSupport>

#include <cmath>
#include <vector>

namespace gapflow::testing {

template <int D>
class Stokes {
public:
    using Vector = Eigen::VectorXd;
    using Sparse = Eigen::SparseMatrix<double>;

    /// `known`: unknown columns that are data; none of the rows of their equations is used.
    explicit Stokes(const ViscousForm<D>& form, const std::vector<char>& known = {})
        : form_(form), n_(form.unknowns()), columns_(form.columns())
    {
        const SquareSum plain = form.plain_squares();
        SquareSum sum = plain;
        cells_ = form.outflow.rows();
        std::vector<Eigen::Triplet<double>> out;
        for (int c = 0; c < cells_; ++c) {
            Row row;
            for (std::int64_t t = form.outflow.end[c]; t < form.outflow.end[c + 1]; ++t) {
                row.add(form.outflow.column[t], form.outflow.factor[t]);
                out.emplace_back(c, form.outflow.column[t], form.outflow.factor[t]);
            }
            sum.add(penalty, row);
        }
        outflow_.resize(cells_, columns_);
        outflow_.setFromTriplets(out.begin(), out.end());
        all_ = plain.assembled(columns_);
        const Sparse augmented = sum.assembled(columns_);
        for (int k = 0; k < columns_; ++k)
            if (k < n_ && (known.empty() || !known[k]) && augmented.coeff(k, k) > 0)
                free_.push_back(k);
        Sparse choose(columns_, static_cast<int>(free_.size()));
        for (std::size_t k = 0; k < free_.size(); ++k)
            choose.insert(free_[k], static_cast<int>(k)) = 1;
        choose_ = choose;
        const Sparse block = choose_.transpose() * augmented * choose_;
        factor_.setMode(Eigen::CholmodSupernodalLLt);
        factor_.compute(block);
        ok = factor_.info() == Eigen::Success;
        free_outflow_ = outflow_ * choose_;
    }

    /// Least energy less load x, with the data in x0 (twists, known columns). On return `pressure` has the cells' multipliers.
    Vector solve(Vector x, const Vector& load)
    {
        pressure = Vector::Zero(cells_);
        for (const int k : free_)
            x[k] = 0;
        const auto continuity = [&] { return Vector(outflow_ * x); };
        Vector r = continuity();
        const Vector right = choose_.transpose() * (load - all_ * x - penalty * (outflow_.transpose() * r));
        x += choose_ * Vector(factor_.solve(right));
        r = continuity();
        Vector p = r;
        double rr = r.squaredNorm();
        const double scale = (outflow_.cwiseAbs() * x.cwiseAbs()).squaredNorm();
        for (iterations = 0; iterations < 200 && rr > 1e-26 * scale; ++iterations) {
            const Vector y = factor_.solve(free_outflow_.transpose() * p);
            const Vector q = free_outflow_ * y;
            const double step = rr / p.dot(q);
            pressure += step * p;
            x -= choose_ * (step * y);
            r -= step * q;
            const double next = r.squaredNorm();
            p = r + next / rr * p;
            rr = next;
        }
        // The penalty is part of the pressure.
        pressure += penalty * continuity();
        return x;
    }
    /// Derivatives of the least energy by all columns.
    Vector reaction(const Vector& x) const { return all_ * x + outflow_.transpose() * pressure; }
    Vector with_rotation(const Vector& x) const
    {
        Vector y(columns_);
        form_.product({x.data(), static_cast<std::size_t>(columns_)}, {y.data(), static_cast<std::size_t>(columns_)});
        return y + outflow_.transpose() * pressure;
    }

    bool ok = false;
    int iterations = 0;
    Vector pressure;

private:
    static constexpr double penalty = 1e4;
    const ViscousForm<D>& form_;
    int n_, columns_, cells_;
    std::vector<int> free_;
    Sparse all_, outflow_, choose_, free_outflow_;
    Eigen::CholmodDecomposition<Sparse> factor_;
};

/// A uniform pressure gradient of -1 along an axis as load.
template <int D>
Eigen::VectorXd uniform_load(const ViscousForm<D>& form, const Vec<D>& gradient)
{
    Eigen::VectorXd load = Eigen::VectorXd::Zero(form.columns());
    for (int k = 0; k < form.velocities(); ++k)
        load[k] = form.faces[k].area * form.faces[k].length * gradient[form.faces[k].axis];
    return load;
}

} // namespace gapflow::testing
