// Projected Gauss-Seidel over the contacts, in alternating order, a contact's normal before its tangents (J. J. Moreau, M.
// Jean, "Numerical treatment of contact and friction: the contact dynamics method", 1996). Bodies' twists are kept, so a sweep costs the number of
// contacts. Where forces have several ways to go, or heavy films and bodies lie on light ones, the sweeps converge slowly; all contacts are then
// solved for together: directly (contact_equations), or by the method of multipliers if they are many (contact_cones).
#include "gapflow/stepping/contact_law.hpp"

#include "gapflow/stepping/contact_cones.hpp"
#include "gapflow/stepping/contact_equations.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace gapflow {

namespace {

constexpr int most_sweeps = 10000;
constexpr double round_off = 1e-14; // of the largest change of a speed
constexpr std::size_t most_equations = 50;
// After so many sweeps all contacts are solved for together.
constexpr std::array<int, 3> together = {200, 2000, 5000};

template <int D>
using PairTwist = Eigen::Matrix<double, 2 * twist_size<D>, 1>;

// Relaxation of the bound of friction towards its contact's force per sweep: without relaxation most cases converge fast, but
// bound and force can cycle.
double relaxation_in(int sweep)
{
    return sweep < 50 ? 1.0 : sweep < 500 ? 0.3 : 0.1;
}

// A film in the sweeps. Without contacts the response of its two bodies to an impulse w is V = R w, R = (1 + M^-1 F)^-1 M^-1.
template <int D>
struct FilmBlock {
    int a, b;
    PairMatrix<D> inertia;  // F
    PairMatrix<D> mobility; // M^-1 of the two
    PairMatrix<D> response; // R
    PairMatrix<D> relax;    // (1 + F M^-1)^-1
    PairTwist<D> impulse = PairTwist<D>::Zero();
};

// One row of C with the response to an impulse along it of its two bodies and of the film between them.
template <int D>
struct Row {
    const RelativeRow<D>* row;
    Twist<D> response_a, response_b;
    double mobility;
    PairTwist<D> answer = PairTwist<D>::Zero(); // the responses in the film's order of bodies
    PairTwist<D> film = PairTwist<D>::Zero();   // impulse of the film
};

template <int D>
class Sweeps {
public:
    Sweeps(const std::vector<Contact<D>>& contacts, const NearInertia<D>& inertia, ContactForecast<D>& result)
        : contacts_(contacts), mobility_(inertia.mobility), result_(result), start_(result.twists)
    {
        constexpr int n = twist_size<D>;
        std::map<std::pair<int, int>, int> block_of;
        films_.reserve(inertia.films.size());
        for (const FilmInertia<D>& film : inertia.films) {
            FilmBlock<D> block{film.a, film.b, film.matrix, PairMatrix<D>::Zero(), {}, {}};
            block.mobility.template topLeftCorner<n, n>() = mobility_[film.a];
            block.mobility.template bottomRightCorner<n, n>() = mobility_[film.b];
            block.relax = (PairMatrix<D>::Identity() + block.inertia * block.mobility).inverse();
            block.response = block.mobility * block.relax;
            block_of[{film.a, film.b}] = static_cast<int>(films_.size());
            films_.push_back(block);
        }
        for (const Contact<D>& c : contacts) {
            const auto found = block_of.find(std::minmax(c.point.a, c.point.b));
            film_of_.push_back(found == block_of.end() ? -1 : found->second);
            normal_.push_back(make_row(c, c.normal, film_of_.back()));
            if (c.friction > 0)
                for (const RelativeRow<D>& t : c.tangents)
                    tangent_.push_back(make_row(c, t, film_of_.back()));
            else
                tangent_.resize(tangent_.size() + D - 1);
            rebounds_.push_back(c.closed && c.target > c.least);
            bound_.push_back(std::max(result_.impulses[bound_.size()].normal, 0.0));
        }
    }

    int films() const { return static_cast<int>(films_.size()); }

    /// Updates one film's impulse to its bodies' twists. Returns the largest change of a speed.
    double settle_film(int f)
    {
        constexpr int n = twist_size<D>;
        FilmBlock<D>& film = films_[f];
        const PairTwist<D> more = -film.relax * imbalance(film), moved = film.mobility * more;
        film.impulse += more;
        result_.twists[film.a] += moved.template head<n>();
        result_.twists[film.b] += moved.template tail<n>();
        return std::max(moved.template head<D>().norm(), moved.template segment<D>(n).norm());
    }

    /// Solves the law of one contact with the others fixed. Returns the largest change of a speed.
    double settle(int i, double relaxation)
    {
        const Contact<D>& c = contacts_[i];
        ContactImpulse<D>& impulse = result_.impulses[i];
        const Row<D>& n = normal_[i];
        if (n.mobility <= 0)
            return 0;
        const double bound = rebounds_[i] ? c.target : c.least;
        const PairTwist<D> left = film_of_[i] >= 0 ? imbalance(films_[film_of_[i]]) : PairTwist<D>(PairTwist<D>::Zero());
        const double normal = std::max(0.0, impulse.normal + (bound - speed(c, n, left)) / n.mobility);
        double largest = apply_impulse(i, n, normal - impulse.normal);
        impulse.normal = normal;
        if (normal == 0)
            rebounds_[i] = false;
        else if (c.target > c.least && !rebounds_[i])
            rebounds_[i] = true; // what closes in an impact leaves with its rebound
        if (c.friction <= 0)
            return largest;
        const Row<D>* t = &tangent_[(D - 1) * i];
        double mobility = 0; // no less than the tangents' together
        for (int k = 0; k < D - 1; ++k)
            mobility += t[k].mobility;
        if (mobility <= 0)
            return largest;
        const double lag = normal - bound_[i];
        bound_[i] += relaxation * lag;
        largest = std::max(largest, (1 - relaxation) * c.friction * std::abs(lag) * mobility);
        Vec<D - 1> trial = impulse.tangential;
        for (int k = 0; k < D - 1; ++k)
            trial[k] -= speed(c, t[k], left) / mobility;
        const double most = c.friction * bound_[i];
        impulse.slides = trial.norm() > most;
        if (impulse.slides)
            trial *= most / trial.norm();
        for (int k = 0; k < D - 1; ++k)
            largest = std::max(largest, apply_impulse(i, t[k], trial[k] - impulse.tangential[k]));
        impulse.tangential = trial;
        return largest;
    }

private:
    Row<D> make_row(const Contact<D>& c, const RelativeRow<D>& row, int f) const
    {
        constexpr int n = twist_size<D>;
        Row<D> made{&row, mobility_[c.point.a] * row.a, mobility_[c.point.b] * row.b, 0};
        if (f >= 0) {
            const bool in_order = c.point.a == films_[f].a;
            PairTwist<D> load;
            load << (in_order ? row.a : row.b), (in_order ? row.b : row.a);
            made.answer = films_[f].response * load;
            made.response_a = in_order ? made.answer.template head<n>() : made.answer.template tail<n>();
            made.response_b = in_order ? made.answer.template tail<n>() : made.answer.template head<n>();
            made.film = -films_[f].inertia * made.answer;
        }
        made.mobility = row.a.dot(made.response_a) + row.b.dot(made.response_b);
        return made;
    }

    // What a film's impulse lacks to be -F times the change of its bodies' twists, after other impulses have moved them. An impulse of a contact between
    // its bodies leaves it as it is.
    PairTwist<D> imbalance(const FilmBlock<D>& film) const
    {
        PairTwist<D> change;
        change << result_.twists[film.a] - start_[film.a], result_.twists[film.b] - start_[film.b];
        return film.impulse + film.inertia * change;
    }

    // The speed that the film between the bodies will leave, `left` its imbalance: with the speed of the moment, which other contacts made, the contact would
    // push against the film's whole inertia, and the sweeps diverge (a light body in a corner: random scene 257).
    double speed(const Contact<D>& c, const Row<D>& r, const PairTwist<D>& left) const
    {
        return r.row->a.dot(result_.twists[c.point.a]) + r.row->b.dot(result_.twists[c.point.b]) - r.answer.dot(left);
    }

    double apply_impulse(int i, const Row<D>& r, double impulse)
    {
        if (impulse == 0)
            return 0;
        const Contact<D>& c = contacts_[i];
        if (film_of_[i] >= 0)
            films_[film_of_[i]].impulse += impulse * r.film;
        result_.twists[c.point.a] += impulse * r.response_a;
        result_.twists[c.point.b] += impulse * r.response_b;
        return std::abs(impulse) * r.mobility;
    }

    const std::vector<Contact<D>>& contacts_;
    const std::vector<TwistMatrix<D>>& mobility_;
    ContactForecast<D>& result_;
    const std::vector<Twist<D>> start_;
    std::vector<FilmBlock<D>> films_;
    std::vector<int> film_of_; ///< of every contact, -1: none
    std::vector<Row<D>> normal_, tangent_;
    std::vector<double> bound_; ///< normal impulse that a contact's friction goes by
    std::vector<char> rebounds_;
};

} // namespace

template <int D>
ContactForecast<D> forecast_contacts(const std::vector<Contact<D>>& contacts, const std::vector<ContactImpulse<D>>& given,
                                     const std::vector<Twist<D>>& twists, const NearInertia<D>& inertia, double accuracy,
                                     const ContactSecants& secants)
{
    ContactForecast<D> result{given, twists};
    if (!secants.empty())
        if (auto solved = solve_cones<D>(contacts, given, twists, inertia, given, accuracy, secants))
            return *std::move(solved);
    Sweeps<D> sweeps(contacts, inertia, result);
    const int n = static_cast<int>(contacts.size());
    double fastest = 0;
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
        double largest = 0;
        const double relaxation = relaxation_in(sweep);
        for (int i = 0; i < n; ++i)
            largest = std::max(largest, sweeps.settle(sweep % 2 == 0 ? i : n - 1 - i, relaxation));
        for (int f = 0; f < sweeps.films() && largest > 0; ++f)
            largest = std::max(largest, sweeps.settle_film(sweep % 2 == 0 ? f : sweeps.films() - 1 - f));
        if (largest < std::max(accuracy, round_off * fastest))
            break;
        fastest = std::max(fastest, largest);
        if (std::find(together.begin(), together.end(), sweep) != together.end()) {
            auto solved = contacts.size() <= most_equations
                              ? solve_contacts<D>(contacts, given, twists, inertia, result.impulses, accuracy)
                              : solve_cones<D>(contacts, given, twists, inertia, result.impulses, accuracy);
            if (solved)
                return *std::move(solved);
        }
    }
    return result;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template ContactForecast<D> forecast_contacts<D>(const std::vector<Contact<D>>&, const std::vector<ContactImpulse<D>>&,    \
                                                     const std::vector<Twist<D>>&, const NearInertia<D>&, double,              \
                                                     const ContactSecants&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
