#include "gapflow/stepping/contact_equations.hpp"
#include "gapflow/core/decompositions.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {

namespace {

constexpr double nothing = 1e-9;   // of the largest impulse, of the largest speed
constexpr double redundant = 1e-9; // pivots below it, of rows scaled to 1

enum class Mode { open, sticks, slides };

template <int D>
class Equations {
public:
    Equations(const std::vector<Contact<D>>& contacts, const std::vector<ContactImpulse<D>>& given,
              const std::vector<Twist<D>>& twists, const NearInertia<D>& inertia, const std::vector<ContactImpulse<D>>& guess)
        : contacts_(contacts), twists_(twists), place_(twists.size(), -1), lambda_(static_cast<long>(D * contacts.size())),
          state_(contacts.size(), Mode::open), friction_direction_(contacts.size(), Vec<D - 1>::Zero())
    {
        for (std::size_t s = 0; s < twists.size(); ++s)
            if (!inertia.mobility[s].isZero(0))
                place_[s] = n * count_++;
        // G = H (1 + H F H)^-1 H with H^2 the mobility: response of all twists to an impulse.
        const long dofs = n * count_;
        Eigen::MatrixXd H = Eigen::MatrixXd::Zero(dofs, dofs), F = H;
        for (std::size_t s = 0; s < twists.size(); ++s)
            if (place_[s] >= 0) {
                const SymmetricEigen<n> eigen = symmetric_eigen<n>(inertia.mobility[s]);
                H.template block<n, n>(place_[s], place_[s]) =
                    eigen.vectors * eigen.values.cwiseMax(0).cwiseSqrt().asDiagonal() * eigen.vectors.transpose();
            }
        for (const FilmInertia<D>& film : inertia.films) {
            const int solids[] = {film.a, film.b};
            for (int i = 0; i < 2; ++i)
                for (int j = 0; j < 2; ++j)
                    if (place_[solids[i]] >= 0 && place_[solids[j]] >= 0)
                        F.template block<n, n>(place_[solids[i]], place_[solids[j]]) +=
                            film.matrix.template block<n, n>(n * i, n * j);
        }
        rows_ = Eigen::MatrixXd::Zero(lambda_.size(), dofs);
        V_ = Eigen::VectorXd::Zero(dofs);
        for (std::size_t s = 0; s < twists.size(); ++s)
            if (place_[s] >= 0)
                V_.template segment<n>(place_[s]) = twists[s];
        held_ = Eigen::VectorXd::Zero(lambda_.size()); // speeds that prescribed solids make
        Eigen::VectorXd before(lambda_.size());
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            const Contact<D>& c = contacts[i];
            for (int k = 0; k < D; ++k) {
                const RelativeRow<D>& row = k == 0 ? c.normal : c.tangents[k - 1];
                const long r = D * static_cast<long>(i) + k;
                add(row.a, c.point.a, r);
                add(row.b, c.point.b, r);
                lambda_[r] = k == 0 ? guess[i].normal : guess[i].tangential[k - 1];
                before[r] = k == 0 ? given[i].normal : given[i].tangential[k - 1];
            }
            if (guess[i].normal > 0)
                state_[i] = c.friction > 0 && !guess[i].slides ? Mode::sticks : Mode::slides;
            if (const double size = guess[i].tangential.norm(); size > 0)
                friction_direction_[i] = guess[i].tangential / size;
        }
        const std::optional<Eigen::MatrixXd> inner =
            positive_definite_solution(Eigen::MatrixXd::Identity(dofs, dofs) + H * F * H, H * rows_.transpose());
        sound_ = inner.has_value();
        if (!sound_)
            return;
        response_ = H * *inner;
        V_ -= response_ * before;
    }

    bool sound() const { return sound_; }

    /// With the states as they are: impulses and twists.
    bool solve()
    {
        std::vector<long> unknown;
        for (std::size_t i = 0; i < contacts_.size(); ++i) {
            const long r = D * static_cast<long>(i);
            if (state_[i] != Mode::open)
                unknown.push_back(r);
            for (int k = 1; k < D && state_[i] == Mode::sticks; ++k)
                unknown.push_back(r + k);
        }
        const long size = static_cast<long>(unknown.size());
        Eigen::MatrixXd columns(V_.size(), size), W(size, size); // twists, speeds per impulse
        Eigen::VectorXd lack(size), now(size), scale(size);
        for (long j = 0; j < size; ++j) {
            const long r = unknown[j], i = r / D;
            columns.col(j) = response_.col(r);
            if (r % D == 0 && state_[i] == Mode::slides)
                for (int k = 1; k < D; ++k)
                    columns.col(j) += contacts_[i].friction * friction_direction_[i][k - 1] * response_.col(r + k);
            now[j] = lambda_[r];
            lack[j] = (r % D == 0 ? contacts_[i].target : 0.0) - held_[r] - rows_.row(r).dot(V_);
        }
        for (long j = 0; j < size; ++j)
            W.row(j) = rows_.row(unknown[j]) * columns;
        for (long j = 0; j < size; ++j)
            scale[j] = 1 / std::sqrt(std::max(rows_.row(unknown[j]).dot(response_.col(unknown[j])), 1e-300));
        const Eigen::MatrixXd scaled = scale.asDiagonal() * W * scale.asDiagonal();
        const LeastNormSolver solver(scaled, redundant);
        Eigen::VectorXd x = now;
        for (int pass = 0; pass < 3; ++pass) // the nearest to what there is, then round-off
            x += scale.cwiseProduct(solver.solve(scale.cwiseProduct(lack - W * x)));
        twists_found_ = V_ + columns * x;
        speeds_ = held_ + rows_ * twists_found_;
        lambda_.setZero();
        for (long j = 0; j < size; ++j) {
            lambda_[unknown[j]] = x[j];
            if (const long i = unknown[j] / D; unknown[j] % D == 0 && state_[i] == Mode::slides)
                for (int k = 1; k < D; ++k)
                    lambda_[D * i + k] = contacts_[i].friction * x[j] * friction_direction_[i][k - 1];
        }
        fastest_ = std::max(speeds_.cwiseAbs().maxCoeff(), (held_ + rows_ * V_).cwiseAbs().maxCoeff());
        return x.allFinite();
    }

    /// Changes the state of the contact that violates the laws most. False if none does.
    bool correct(double accuracy)
    {
        const double speed = std::max(accuracy, nothing * fastest_),
                     impulse = std::max(nothing * lambda_.cwiseAbs().maxCoeff(), 1e-300);
        double worst = 1;
        std::size_t which = contacts_.size();
        Mode next = Mode::open;
        Vec<D - 1> friction_direction = Vec<D - 1>::Zero();
        auto look = [&](double excess, std::size_t i, Mode state, const Vec<D - 1>& direction) {
            if (!(excess <= worst)) {
                worst = excess;
                which = i;
                next = state;
                friction_direction = direction;
            }
        };
        for (std::size_t i = 0; i < contacts_.size(); ++i) {
            const Contact<D>& c = contacts_[i];
            const long r = D * static_cast<long>(i);
            const Vec<D - 1> tangential = lambda_.template segment<D - 1>(r + 1), slip = speeds_.template segment<D - 1>(r + 1);
            const Mode pressing = c.friction > 0 ? Mode::sticks : Mode::slides;
            if (state_[i] == Mode::open) {
                look((c.least - speeds_[r]) / speed, i, pressing, friction_direction_[i]);
                continue;
            }
            look(-lambda_[r] / impulse, i, Mode::open, friction_direction_[i]);
            obeyed_ = obeyed_ && std::abs(speeds_[r] - c.target) <= speed;
            if (state_[i] == Mode::sticks) {
                look((tangential.norm() - c.friction * lambda_[r]) / impulse, i, Mode::slides,
                     tangential / std::max(tangential.norm(), 1e-300));
                obeyed_ = obeyed_ && slip.norm() <= speed;
            } else if (c.friction > 0) {
                if (slip.dot(friction_direction_[i]) > speed)
                    look(slip.dot(friction_direction_[i]) / speed, i, Mode::sticks, friction_direction_[i]);
                else if (D == 3 && slip.norm() > speed)
                    look((slip + slip.norm() * friction_direction_[i]).norm() / speed, i, Mode::slides, -slip / slip.norm());
            }
        }
        if (which == contacts_.size())
            return false;
        state_[which] = next;
        friction_direction_[which] = friction_direction;
        obeyed_ = true;
        return true;
    }

    /// Whether the equations of the last solve hold: redundant ones may contradict each other.
    bool obeyed() const { return obeyed_; }

    ContactForecast<D> result() const
    {
        ContactForecast<D> found{std::vector<ContactImpulse<D>>(contacts_.size()), twists_};
        for (std::size_t i = 0; i < contacts_.size(); ++i) {
            const long r = D * static_cast<long>(i);
            found.impulses[i] = {std::max(lambda_[r], 0.0), lambda_.template segment<D - 1>(r + 1),
                                 contacts_[i].friction > 0 && state_[i] != Mode::sticks};
        }
        for (std::size_t s = 0; s < twists_.size(); ++s)
            if (place_[s] >= 0)
                found.twists[s] = twists_found_.template segment<n>(place_[s]);
        return found;
    }

private:
    static constexpr int n = twist_size<D>;

    void add(const Twist<D>& part, int solid, long r)
    {
        if (place_[solid] >= 0)
            rows_.row(r).template segment<n>(place_[solid]) += part.transpose();
        else
            held_[r] += part.dot(twists_[solid]);
    }

    const std::vector<Contact<D>>& contacts_;
    const std::vector<Twist<D>>& twists_;
    std::vector<int> place_; ///< of every solid's twist, -1: cannot move
    int count_ = 0;
    Eigen::VectorXd lambda_; ///< of every contact: normal, tangential
    std::vector<Mode> state_;
    std::vector<Vec<D - 1>> friction_direction_; ///< direction of friction where it slides
    Eigen::MatrixXd rows_, response_;            ///< C, G C^T
    Eigen::VectorXd V_, held_;                   ///< twists without contacts; speeds of what does not yield
    Eigen::VectorXd twists_found_, speeds_;
    double fastest_ = 0;
    bool sound_ = false, obeyed_ = true;
};

} // namespace

template <int D>
std::optional<ContactForecast<D>> solve_contacts(const std::vector<Contact<D>>& contacts,
                                                 const std::vector<ContactImpulse<D>>& given,
                                                 const std::vector<Twist<D>>& twists, const NearInertia<D>& inertia,
                                                 const std::vector<ContactImpulse<D>>& guess, double accuracy)
{
    if (contacts.empty())
        return {};
    Equations<D> equations(contacts, given, twists, inertia, guess);
    for (std::size_t pass = 0; equations.sound() && pass < 10 + 4 * contacts.size(); ++pass) {
        if (!equations.solve())
            return {};
        if (!equations.correct(accuracy))
            return equations.obeyed() ? std::optional(equations.result()) : std::nullopt;
    }
    return {};
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template std::optional<ContactForecast<D>> solve_contacts<D>(                                                              \
        const std::vector<Contact<D>>&, const std::vector<ContactImpulse<D>>&, const std::vector<Twist<D>>&,                   \
        const NearInertia<D>&, const std::vector<ContactImpulse<D>>&, double);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
