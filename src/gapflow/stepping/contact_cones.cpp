// With K the cones |lambda_t| <= mu lambda_n of all contacts, K* their duals and u = C V - s, the laws are
//
//     A V = w + C^T lambda,     K ∋ lambda  |  u + mu |u_t| n ∈ K*
//
// (G. De Saxcé, Z.-Q. Feng, Math. Comput. Model. 28, 1998). For given mu |u_t| this is the minimum of V A V / 2 - w V under a convex constraint;
// |u_t| is that of the pass before (V. Acary, F. Cadoux, C. Lemaréchal, J. Malick, ZAMM 91, 2011). The minimum is found by the method of
// multipliers, lambda <- P(lambda + k (s - mu |u_t| n - C V)) with P the projection onto K, and a semismooth Newton step or two a pass for
//
//     A V - w - C^T P(lambda + k (s - mu |u_t| n - C V)) = 0.
#include "gapflow/stepping/contact_cones.hpp"
#include "gapflow/core/decompositions.hpp"
#include "gapflow/core/sparse_cholesky.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace gapflow {

namespace {

// k over that of the bodies, 1 / (c A^-1 c^T) of the row: with more the Newton steps are many, with less the passes.
constexpr double cone_stiffness = 50;
constexpr int most_cone_passes = 300; // the worst of a pile's still move by 1e-9 of the largest speed a pass then
constexpr int steps_a_pass = 3;
constexpr double step_part = 0.1;      // of a pass' first lack of balance: enough for the pass
constexpr double step_accuracy = 0.01; // of a Newton step, in what it leaves of the lack of balance
// Conjugate gradients with an old factor go on while each iteration halves what is left, and until they have taken as long as a new factor, about.
constexpr double slowest_correction = 0.5;
constexpr int factor_worth = 20;
constexpr double impulse_round_off = 1e-14; // of the impulses

// Inertia of a film over that of its bodies, at most: a film of no thickness has an infinite one, and how it shares an impulse with contacts that
// hold the same bodies has no accuracy then.
constexpr double heaviest_film = 1e4;
// And at least: one that says less of its bodies than the forecast misses of them by far would only fill the matrix.
constexpr double lightest_film = 0.02;

// What a body's mobility says: its inverse and the roots of both where it has one, and what the body can do. All 0 of one that cannot move.
template <int D>
struct OwnInertia {
    TwistMatrix<D> inertia = TwistMatrix<D>::Zero(); ///< positive definite: impulses elsewhere do nothing
    TwistMatrix<D> root = TwistMatrix<D>::Zero(), inverse_root = TwistMatrix<D>::Zero();
    TwistMatrix<D> admissible = TwistMatrix<D>::Zero();
};

template <int D>
OwnInertia<D> own_inertia(const TwistMatrix<D>& mobility)
{
    constexpr int n = twist_size<D>;
    const SymmetricEigen<n> eigen = symmetric_eigen<n>(mobility);
    const double most = eigen.values[n - 1];
    OwnInertia<D> own;
    for (int k = 0; k < n; ++k) {
        const TwistMatrix<D> part = eigen.vectors.col(k) * eigen.vectors.col(k).transpose();
        if (eigen.values[k] > 1e-12 * most) {
            own.inertia += part / eigen.values[k];
            own.root += std::sqrt(eigen.values[k]) * part;
            own.inverse_root += part / std::sqrt(eigen.values[k]);
            own.admissible += part;
        } else {
            own.inertia += part / most;
        }
    }
    return own;
}

// As if the film acted through a spring of `heaviest_film` times the bodies' inertia: in terms of that, f becomes f / (1 + f / heaviest_film). Nothing
// of a film lighter than `lightest_film`. `limited` becomes true where that changes much.
template <int D>
std::optional<PairMatrix<D>> limited_inertia(const FilmInertia<D>& film, const OwnInertia<D>& a, const OwnInertia<D>& b,
                                             bool& limited)
{
    constexpr int n = twist_size<D>;
    Eigen::MatrixXd root = Eigen::MatrixXd::Zero(2 * n, 2 * n), inverse = root;
    root.topLeftCorner(n, n) = a.root;
    root.bottomRightCorner(n, n) = b.root;
    inverse.topLeftCorner(n, n) = a.inverse_root;
    inverse.bottomRightCorner(n, n) = b.inverse_root;
    const SymmetricEigen<> eigen = symmetric_eigen<Eigen::Dynamic>(root * film.matrix * root);
    const double heaviest = eigen.values[2 * n - 1];
    if (!(heaviest > lightest_film))
        return {};
    limited = limited || heaviest > heaviest_film;
    const Eigen::VectorXd values =
        eigen.values.unaryExpr([](double f) { return std::max(f, 0.0) / (1 + std::max(f, 0.0) / heaviest_film); });
    const Eigen::MatrixXd vectors = inverse * eigen.vectors;
    return PairMatrix<D>(vectors * values.asDiagonal() * vectors.transpose());
}

// A V - w - C^T lambda and what it is made of, for many bodies.
template <int D>
class Cones {
public:
    Cones(const std::vector<Contact<D>>& contacts, const std::vector<Twist<D>>& twists, const NearInertia<D>& inertia)
        : contacts_(contacts), twists_(twists), place_(twists.size(), -1), own_(twists.size())
    {
        int count = 0;
        for (std::size_t s = 0; s < twists.size(); ++s)
            if (!inertia.mobility[s].isZero(0)) {
                place_[s] = n * count++;
                own_[s] = own_inertia<D>(inertia.mobility[s]);
            }
        std::vector<Eigen::Triplet<double>> entries;
        const auto put = [&](int row, int column, const auto& block) {
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j)
                    entries.emplace_back(row + i, column + j, block(i, j));
        };
        for (std::size_t s = 0; s < twists.size(); ++s)
            if (place_[s] >= 0)
                put(place_[s], place_[s], own_[s].inertia);
        for (const FilmInertia<D>& film : inertia.films) {
            const std::optional<PairMatrix<D>> matrix = limited_inertia<D>(film, own_[film.a], own_[film.b], any_limited_);
            if (!matrix)
                continue;
            for (const auto& [i, a] : {std::pair(0, film.a), std::pair(n, film.b)})
                for (const auto& [j, b] : {std::pair(0, film.a), std::pair(n, film.b)})
                    if (place_[a] >= 0 && place_[b] >= 0)
                        put(place_[a], place_[b], matrix->template block<n, n>(i, j));
        }
        A_.resize(n * count, n * count);
        A_.setFromTriplets(entries.begin(), entries.end());
        make_rows();
    }

    /// Changes A such that it gives the secants. False if they tell nothing: also where a film holds bodies as a contact does, from which it takes its impulse
    /// with no change of a speed (BlockSlidesBeyondTheAngleOfFriction: the impulse would be ascribed to the sliding).
    bool learn(const ContactSecants& secants)
    {
        if (any_limited_)
            return false;
        Eigen::MatrixXd S(A_.rows(), secants.twists.cols()), Y(A_.rows(), secants.twists.cols());
        for (std::size_t s = 0; s < twists_.size(); ++s)
            if (place_[s] >= 0) {
                S.middleRows(place_[s], n) = secants.twists.middleRows(n * static_cast<long>(s), n);
                Y.middleRows(place_[s], n) = own_[s].admissible * secants.impulses.middleRows(n * static_cast<long>(s), n);
            }
        change_ = secant_change(A_, S, Y);
        return change_.has_value();
    }

    /// V of the twists, C^T lambda of the impulses are those of a solve: w = A V - C^T lambda.
    void start(const std::vector<ContactImpulse<D>>& given, const std::vector<ContactImpulse<D>>& guess)
    {
        V_ = Eigen::VectorXd::Zero(A_.rows());
        for (std::size_t s = 0; s < twists_.size(); ++s)
            if (place_[s] >= 0)
                V_.template segment<n>(place_[s]) = twists_[s];
        lambda_ = stacked(given);
        w_ = inertia_times(V_) - transpose_ * lambda_;
        lambda_ = projected(stacked(guess));
        follow();
        for (std::size_t i = 0; i < contacts_.size(); ++i)
            in_pattern_.push_back(lambda_[D * static_cast<long>(i)] > 0);
        make_pattern();
    }

    /// One pass. Returns the largest change of a contact's speed, or nothing if the inertia is not positive definite.
    std::optional<double> pass()
    {
        const Eigen::VectorXd before = rows_ * V_;
        Eigen::VectorXd speeds = before, trial, impulse;
        Eigen::VectorXd lack = imbalance(V_, speeds, trial, impulse);
        const double enough =
            std::max(step_part * lack.norm(), impulse_round_off * (w_.norm() + (transpose_ * impulse).norm()));
        for (int k = 0; k < steps_a_pass && lack.norm() > enough; ++k) {
            const std::optional<Eigen::VectorXd> step = newton_step(trial, lack);
            if (!step)
                return {};
            const double length = search(*step, speeds, lack);
            V_ += length * *step;
            speeds = rows_ * V_;
            lack = imbalance(V_, speeds, trial, impulse);
        }
        lambda_ = impulse;
        follow();
        return (speeds - before).template lpNorm<Eigen::Infinity>();
    }

    ContactForecast<D> result() const
    {
        ContactForecast<D> found{std::vector<ContactImpulse<D>>(contacts_.size()), twists_};
        for (std::size_t i = 0; i < contacts_.size(); ++i) {
            const double normal = lambda_[D * static_cast<long>(i)];
            const Vec<D - 1> along = lambda_.template segment<D - 1>(D * static_cast<long>(i) + 1);
            found.impulses[i] = {normal, along,
                                 contacts_[i].friction > 0 && along.norm() >= (1 - 1e-9) * contacts_[i].friction * normal};
        }
        for (std::size_t s = 0; s < twists_.size(); ++s)
            if (place_[s] >= 0)
                found.twists[s] = V_.template segment<n>(place_[s]);
        return found;
    }

private:
    static constexpr int n = twist_size<D>;
    using Part = Eigen::Matrix<double, D, n>; ///< a contact's rows for one of its bodies

    void make_rows()
    {
        const long size = D * static_cast<long>(contacts_.size());
        given_speed_ = Eigen::VectorXd::Zero(size);
        stiffness_.resize(static_cast<long>(contacts_.size()));
        parts_.assign(contacts_.size(), {Part::Zero(), Part::Zero()});
        std::vector<Eigen::Triplet<double>> entries;
        const Eigen::VectorXd diagonal = A_.diagonal();
        for (std::size_t i = 0; i < contacts_.size(); ++i) {
            const Contact<D>& c = contacts_[i];
            Vec<D> mobility = Vec<D>::Zero();
            for (int k = 0; k < D; ++k) {
                const RelativeRow<D>& row = k == 0 ? c.normal : c.tangents[k - 1];
                const int r = D * static_cast<int>(i) + k;
                for (int e = 0; e < 2; ++e) {
                    const int solid = e == 0 ? c.point.a : c.point.b;
                    const Twist<D>& part = e == 0 ? row.a : row.b;
                    if (place_[solid] < 0) {
                        given_speed_[r] += part.dot(twists_[solid]);
                        continue;
                    }
                    const Twist<D> moved = own_[solid].admissible * part;
                    parts_[i][e].row(k) = moved.transpose();
                    for (int j = 0; j < n; ++j) {
                        entries.emplace_back(r, place_[solid] + j, moved[j]);
                        mobility[k] += moved[j] * moved[j] / diagonal[place_[solid] + j];
                    }
                }
            }
            const double most = mobility.maxCoeff();
            stiffness_[static_cast<long>(i)] = most > 0 ? cone_stiffness / most : 0.0;
        }
        rows_.resize(size, A_.rows());
        rows_.setFromTriplets(entries.begin(), entries.end());
        transpose_ = rows_.transpose();
    }

    // H = A + C^T S C: entries of A, and a block for each contact that has pressed so far. Most of a bed's do not.
    void make_pattern()
    {
        std::vector<Eigen::Triplet<double>> entries;
        for (int column = 0; column < A_.outerSize(); ++column)
            for (Eigen::SparseMatrix<double>::InnerIterator entry(A_, column); entry; ++entry)
                entries.emplace_back(entry.row(), entry.col(), entry.value());
        for (std::size_t k = 0; k < contacts_.size(); ++k)
            if (in_pattern_[k])
                for (int a : {contacts_[k].point.a, contacts_[k].point.b})
                    for (int b : {contacts_[k].point.a, contacts_[k].point.b})
                        if (place_[a] >= 0 && place_[b] >= 0)
                            for (int i = 0; i < n; ++i)
                                for (int j = 0; j < n; ++j)
                                    entries.emplace_back(place_[a] + i, place_[b] + j, 0.0);
        H_.resize(A_.rows(), A_.rows());
        H_.setFromTriplets(entries.begin(), entries.end());
        H_.makeCompressed();
        inertia_.assign(H_.valuePtr(), H_.valuePtr() + H_.nonZeros());
        is_analysed_ = false;
    }

    // First entry of a body's block in a column of H.
    double* block_column(int row, int column)
    {
        const int* begin = H_.innerIndexPtr() + H_.outerIndexPtr()[column];
        const int* end = H_.innerIndexPtr() + H_.outerIndexPtr()[column + 1];
        return H_.valuePtr() + (std::lower_bound(begin, end, row) - H_.innerIndexPtr());
    }

    Eigen::VectorXd stacked(const std::vector<ContactImpulse<D>>& impulses) const
    {
        Eigen::VectorXd all(D * static_cast<long>(impulses.size()));
        for (std::size_t i = 0; i < impulses.size(); ++i)
            all.template segment<D>(D * static_cast<long>(i)) << impulses[i].normal, impulses[i].tangential;
        return all;
    }

    // What the speeds are measured from, and whether contacts rebound, after the last impulses.
    void follow()
    {
        const Eigen::VectorXd speeds = rows_ * V_ + given_speed_;
        least_ = -given_speed_;
        for (std::size_t i = 0; i < contacts_.size(); ++i) {
            const Contact<D>& c = contacts_[i];
            const long r = D * static_cast<long>(i);
            const bool rebounds = c.target > c.least && lambda_[r] > 0; // what closes in an impact leaves with its rebound
            least_[r] += (rebounds ? c.target : c.least) - c.friction * speeds.template segment<D - 1>(r + 1).norm();
        }
    }

    // The nearest impulses in the cones.
    Eigen::VectorXd projected(const Eigen::VectorXd& trial) const
    {
        Eigen::VectorXd impulse = trial;
        for (std::size_t i = 0; i < contacts_.size(); ++i) {
            const long r = D * static_cast<long>(i);
            const double friction = contacts_[i].friction;
            auto along = impulse.template segment<D - 1>(r + 1);
            const double size = along.norm();
            if (friction > 0 && size <= friction * trial[r])
                continue;
            impulse[r] = std::max(0.0, (trial[r] + friction * size) / (1 + friction * friction));
            if (size > 0)
                along *= friction * impulse[r] / size;
        }
        return impulse;
    }

    Eigen::VectorXd imbalance(const Eigen::VectorXd& V, const Eigen::VectorXd& speeds, Eigen::VectorXd& trial,
                              Eigen::VectorXd& impulse) const
    {
        trial = lambda_;
        for (long i = 0; i < stiffness_.size(); ++i)
            trial.template segment<D>(D * i) +=
                stiffness_[i] * (least_.template segment<D>(D * i) - speeds.template segment<D>(D * i));
        impulse = projected(trial);
        return inertia_times(V) - w_ - transpose_ * impulse;
    }

    // Derivative of a contact's projection.
    Eigen::Matrix<double, D, D> slope(std::size_t i, const Eigen::VectorXd& trial) const
    {
        const long r = D * static_cast<long>(i);
        const double friction = contacts_[i].friction;
        const Vec<D - 1> along = trial.template segment<D - 1>(r + 1);
        const double size = along.norm(), normal = (trial[r] + friction * size) / (1 + friction * friction);
        Eigen::Matrix<double, D, D> J = Eigen::Matrix<double, D, D>::Zero();
        if (friction > 0 && size <= friction * trial[r])
            return Eigen::Matrix<double, D, D>::Identity();
        if (normal <= 0)
            return J;
        Vec<D> edge = Vec<D>::Zero();
        edge[0] = 1;
        if (size > 0)
            edge.template tail<D - 1>() = friction * along / size;
        J = edge * edge.transpose() / (1 + friction * friction);
        if (D == 3 && size > 0)
            J.template bottomRightCorner<D - 1, D - 1>() +=
                friction * normal / size *
                (Eigen::Matrix<double, D - 1, D - 1>::Identity() - along * along.transpose() / (size * size));
        return J;
    }

    // -H^-1 lack with the slopes at the trial impulses; empty if H is not positive definite.
    std::optional<Eigen::VectorXd> newton_step(const Eigen::VectorXd& trial, const Eigen::VectorXd& lack)
    {
        slopes_.clear();
        for (std::size_t i = 0; i < contacts_.size(); ++i)
            slopes_.push_back(stiffness_[static_cast<long>(i)] * slope(i, trial));
        if (is_factored_)
            if (auto step = step_with_last_factor(lack))
                return step;
        corrections_ = 0;
        is_factored_ = factorise();
        if (!is_factored_)
            return {};
        return Eigen::VectorXd(-solve(lack));
    }

    Eigen::VectorXd inertia_times(const Eigen::VectorXd& V) const
    {
        Eigen::VectorXd product = A_ * V;
        if (change_)
            product += change_->vectors * (change_->weights * (change_->vectors.transpose() * V));
        return product;
    }

    // With the last factor, and what secants change by Woodbury.
    Eigen::VectorXd solve(const Eigen::VectorXd& b) const
    {
        Eigen::VectorXd x = factor_.solve(b);
        if (change_)
            x -= solved_change_ * capacitance_.solve(change_->vectors.transpose() * x);
        return x;
    }

    // The same by conjugate gradients with the last factor, where few contacts have changed since; empty where a new factor is the shorter way.
    std::optional<Eigen::VectorXd> step_with_last_factor(const Eigen::VectorXd& lack)
    {
        const double enough = step_accuracy * lack.norm();
        double most = lack.norm();
        Eigen::VectorXd x = Eigen::VectorXd::Zero(lack.size()), r = -lack, z = solve(r), p = z;
        for (double rz = r.dot(z); corrections_ < factor_worth; ++corrections_) {
            const Eigen::VectorXd product = multiplied(p);
            const double length = rz / p.dot(product);
            if (!(length > 0))
                return {};
            x += length * p;
            r -= length * product;
            if (r.norm() <= enough)
                return x;
            most *= slowest_correction;
            if (r.norm() > most)
                return {};
            z = solve(r);
            const double next = r.dot(z);
            p = z + next / rz * p;
            rz = next;
        }
        return {};
    }

    // H x.
    Eigen::VectorXd multiplied(const Eigen::VectorXd& x) const
    {
        Eigen::VectorXd y = rows_ * x;
        for (std::size_t i = 0; i < contacts_.size(); ++i) {
            auto part = y.template segment<D>(D * static_cast<long>(i));
            part = (slopes_[i] * part).eval();
        }
        return inertia_times(x) + transpose_ * y;
    }

    bool factorise()
    {
        bool more = false;
        for (std::size_t i = 0; i < contacts_.size(); ++i)
            if (!in_pattern_[i] && !slopes_[i].isZero(0))
                in_pattern_[i] = more = true;
        if (more)
            make_pattern();
        std::copy(inertia_.begin(), inertia_.end(), H_.valuePtr());
        for (std::size_t i = 0; i < contacts_.size(); ++i) {
            const Contact<D>& c = contacts_[i];
            if (slopes_[i].isZero(0))
                continue;
            const std::array<Part, 2>& part = parts_[i];
            const int solid[] = {c.point.a, c.point.b};
            for (int e = 0; e < 2; ++e)
                for (int f = 0; f < 2; ++f)
                    if (place_[solid[e]] >= 0 && place_[solid[f]] >= 0) {
                        const TwistMatrix<D> block = part[e].transpose() * slopes_[i] * part[f];
                        for (int j = 0; j < n; ++j) {
                            double* to = block_column(place_[solid[e]], place_[solid[f]] + j);
                            for (int k = 0; k < n; ++k)
                                to[k] += block(k, j);
                        }
                    }
        }
        if (!std::exchange(is_analysed_, true))
            factor_.analyse(H_);
        if (!factor_.factorise(H_))
            return false;
        if (change_) {
            solved_change_.resize(change_->vectors.rows(), change_->vectors.cols());
            for (long k = 0; k < solved_change_.cols(); ++k)
                solved_change_.col(k) = factor_.solve(change_->vectors.col(k));
            capacitance_.compute(change_->inverse_weights + change_->vectors.transpose() * solved_change_);
        }
        return true;
    }

    // Length of a step: the slope of the minimised function along it grows with the length.
    double search(const Eigen::VectorXd& step, const Eigen::VectorXd& speeds, const Eigen::VectorXd& lack) const
    {
        constexpr double enough = 0.3;
        constexpr int most_tries = 20;
        const Eigen::VectorXd faster = rows_ * step;
        Eigen::VectorXd trial, impulse;
        const auto slope_at = [&](double t) { return imbalance(V_ + t * step, speeds + t * faster, trial, impulse).dot(step); };
        const double at_start = lack.dot(step);
        double t = 1, low = 0, at_low = at_start, high = 1, at_high = slope_at(1);
        for (int tries = 0; tries < most_tries && at_high > -enough * at_start; ++tries) {
            // By the secant and by halves in turn: the slope has a kink wherever a contact changes its state.
            t = tries % 2 == 0 ? low - at_low * (high - low) / (at_high - at_low) : 0.5 * (low + high);
            const double now = slope_at(t);
            if (std::abs(now) <= -enough * at_start)
                break;
            (now < 0 ? low : high) = t;
            (now < 0 ? at_low : at_high) = now;
        }
        return t;
    }

    const std::vector<Contact<D>>& contacts_;
    const std::vector<Twist<D>>& twists_;
    std::vector<int> place_;                               ///< of every solid's twist, -1: cannot move
    std::vector<OwnInertia<D>> own_;                       ///< of every solid
    bool any_limited_ = false;                             ///< whether a film is heavier than `heaviest_film`
    Eigen::SparseMatrix<double> A_, H_, rows_, transpose_; ///< A, A + C^T S C, C, C^T
    std::vector<std::array<Part, 2>> parts_;               ///< of C, by contact
    std::vector<double> inertia_;                          ///< values of A in the pattern of H
    std::vector<char> in_pattern_;                         ///< whether H has a contact's block
    std::vector<Eigen::Matrix<double, D, D>> slopes_;      ///< S
    std::optional<LowRankChange> change_;                  ///< of A, by secants
    Eigen::MatrixXd solved_change_;                        ///< H^-1 U without the change
    Eigen::PartialPivLU<Eigen::MatrixXd> capacitance_;     ///< W^-1 + U^T H^-1 U
    SparseCholesky factor_;                                ///< of H
    bool is_analysed_ = false, is_factored_ = false;
    int corrections_ = 0;                 ///< with this factor
    Eigen::VectorXd stiffness_;           ///< k of every contact
    Eigen::VectorXd given_speed_, least_; ///< of every row: speed that solids make which do not yield; s - mu |u_t| n less it
    Eigen::VectorXd V_, w_, lambda_;
};

} // namespace

template <int D>
std::optional<ContactForecast<D>> solve_cones(const std::vector<Contact<D>>& contacts,
                                              const std::vector<ContactImpulse<D>>& given, const std::vector<Twist<D>>& twists,
                                              const NearInertia<D>& inertia, const std::vector<ContactImpulse<D>>& guess,
                                              double accuracy, const ContactSecants& secants)
{
    if (contacts.empty())
        return {};
    Cones<D> cones(contacts, twists, inertia);
    if (!secants.empty() && !cones.learn(secants))
        return {};
    cones.start(given, guess);
    double before = 0;
    for (int pass = 0; pass < most_cone_passes; ++pass) {
        const std::optional<double> change = cones.pass();
        if (!change || !std::isfinite(*change))
            return {};
        // What is still to come, if changes go on to fall as they do.
        const double left = *change < before ? *change * *change / (before - *change) : *change;
        if (pass > 1 && left < accuracy)
            break;
        before = *change;
    }
    return cones.result();
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template std::optional<ContactForecast<D>> solve_cones<D>(                                                                 \
        const std::vector<Contact<D>>&, const std::vector<ContactImpulse<D>>&, const std::vector<Twist<D>>&,                   \
        const NearInertia<D>&, const std::vector<ContactImpulse<D>>&, double, const ContactSecants&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
