// Active set around the coupled solve (method, "Contact"): the bodies' laws of contact, with the fluid's answer as it was, forecast which
// contacts hold, stick and slide; all change at once while that settles, the worst alone once they would go round in circles.
#include "gapflow/stepping/contact_law.hpp"
#include "gapflow/stepping/contact_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace gapflow {

namespace {

// Rounds after which contacts change one at a time; or as soon as their states have been about to repeat those of an earlier exact solve so often.
// What goes round mostly counts for so little that the accuracy, which grows with each exact solve, ends it; changes one at a time may lead away from
// it (examples/11_pile at t = 0.266: two states in turn, wrong by 1e-6 of the speeds, then eleven rounds to 6e-4).
constexpr int rounds_at_once = 15;
constexpr int most_repetitions = 5;
constexpr double least_relaxation = 0.3;   // of sliding pulls
constexpr double forecast_accuracy = 1e-2; // of the accuracy required of the speeds
// Rounds that gain less than so much of what is wrong have reached what the forecast can do: two contacts in turn, each wrong as long as the other is right
// (examples/11_pile at t = 0.404: eight exact solves for nothing). They end if no more is wrong than this, and friction is right.
constexpr double least_gain = 0.5;
constexpr double bearable = 1e-4; // of speeds and impulses

// The forecast of the laws of contact after a solve, and the distance of the solve from it.
template <int D>
class ContactCheck {
public:
    ContactCheck(const std::vector<Contact<D>>& contacts, const std::vector<Twist<D>>& twists, const NearInertia<D>& inertia,
                 const ContactAccuracy& accuracy, const ContactSecants& secants)
        : contacts_(contacts), twists_(twists), mobility_(inertia.mobility), accuracy_(accuracy)
    {
        for (const Contact<D>& c : contacts) {
            given_.push_back({c.impulse, c.tangential});
            speed_ = std::max({speed_, std::abs(c.approach), std::abs(c.target), std::abs(rate(c.normal, c, twists))});
            impulse_ = std::max(impulse_, std::abs(c.impulse));
        }
        forecast_ =
            forecast_contacts<D>(contacts, given_, twists, inertia, forecast_accuracy * accuracy.contact * speed_, secants);
        friction_.assign(mobility_.size(), 0.0);
        for (std::size_t i = 0; i < contacts.size(); ++i)
            for (int solid : {contacts[i].point.a, contacts[i].point.b})
                friction_[solid] = std::max(friction_[solid], contacts[i].friction * forecast_.impulses[i].normal);
    }

    const ContactForecast<D>& forecast() const { return forecast_; }

    /// Accuracy of friction relative to the largest bound of friction on the body, not to the contact's own bound, which may be
    /// very small.
    double nothing_along(const Contact<D>& c) const { return nothing_along(c, accuracy_); }

    /// The contact with the largest violation of the laws, and that: by closing too fast, or by the velocity change due to the forecast's
    /// impulses, in units of the accuracy. (Impulses alone are no criterion: redundant contacts may share theirs in many ways.)
    std::pair<std::size_t, double> worst(const ContactAccuracy& accuracy) const
    {
        std::pair<std::size_t, double> worst{0, 0.0};
        for (std::size_t i = 0; i < contacts_.size(); ++i)
            if (const double w = wrong(i, accuracy); w > worst.second)
                worst = {i, w};
        return worst;
    }
    std::pair<std::size_t, double> worst() const { return worst(accuracy_); }

    /// Do some of the solve's impulses pull?
    bool any_pulls() const
    {
        return std::any_of(given_.begin(), given_.end(),
                           [&](const ContactImpulse<D>& g) { return g.normal < -accuracy_.contact * impulse_; });
    }

private:
    double nothing_along(const Contact<D>& c, const ContactAccuracy& accuracy) const
    {
        const int a = c.point.a, b = c.point.b;
        const double friction = mobility_[a].isZero(0)   ? friction_[b]
                                : mobility_[b].isZero(0) ? friction_[a]
                                                         : std::min(friction_[a], friction_[b]);
        return accuracy.contact * impulse_ + accuracy.friction * friction;
    }
    double wrong(std::size_t i, const ContactAccuracy& accuracy) const
    {
        const Contact<D>& c = contacts_[i];
        if (!c.closed)
            return (c.least - rate(c.normal, c, twists_)) / (accuracy.contact * speed_);
        double most = change(c, c.normal) / (accuracy.contact * (speed_ + impulse_ * yield_of(c, c.normal)));
        if (c.friction > 0)
            for (const RelativeRow<D>& t : c.tangents)
                most = std::max(most, change(c, t) / (nothing_along(c, accuracy) * yield_of(c, t)));
        return most;
    }
    double change(const Contact<D>& c, const RelativeRow<D>& row) const
    {
        return std::abs(rate(row, c, forecast_.twists) - rate(row, c, twists_));
    }
    double yield_of(const Contact<D>& c, const RelativeRow<D>& row) const
    {
        return row.a.dot(mobility_[c.point.a] * row.a) + row.b.dot(mobility_[c.point.b] * row.b);
    }

    const std::vector<Contact<D>>& contacts_;
    const std::vector<Twist<D>>& twists_;
    const std::vector<TwistMatrix<D>>& mobility_;
    ContactAccuracy accuracy_;
    std::vector<ContactImpulse<D>> given_;
    double speed_ = 0, impulse_ = 0; ///< the largest
    ContactForecast<D> forecast_;
    std::vector<double> friction_; ///< of each solid: the largest bound of friction
};

template <int D>
bool slides_next(const Contact<D>& c, const ContactImpulse<D>& next)
{
    return next.normal > 0 && c.friction > 0 && next.slides;
}

// Of all contacts, or of `only` this one and the others as they are. `changed` receives whether the forecast has other states anywhere.
template <int D>
std::vector<char> next_states(const std::vector<Contact<D>>& contacts, const ContactForecast<D>& forecast,
                              std::optional<std::size_t> only, bool& changed)
{
    changed = false;
    std::vector<char> states;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const Contact<D>& c = contacts[i];
        const bool closed = forecast.impulses[i].normal > 0, slides = slides_next(c, forecast.impulses[i]);
        changed = changed || c.closed != closed || c.slides != slides;
        states.push_back(!only || i == *only ? static_cast<char>(closed + slides) : state_of(c));
    }
    return states;
}

// The forecast has the bulk's response only approximately, and sliding friction can oscillate about its value for many rounds:
// dynamic relaxation (Irons & Tuck,
// Int. J. Numer. Methods Eng. 1, 1969). Takes the round's lacks; `friction_alone`: only these are to change, all at once; `last`: of the round before.
template <int D>
double relaxation_of_friction(std::vector<Contact<D>>& contacts, const ContactCheck<D>& check, bool friction_alone, double last)
{
    double turn = 0, square = 0;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        Contact<D>& c = contacts[i];
        const Vec<D - 1> lack = check.forecast().impulses[i].tangential - c.sliding_impulse;
        if (!friction_alone || !c.closed || !c.slides) {
            c.lack.setZero();
            continue;
        }
        if (!c.lack.isZero(0)) {
            const double scale = 1 / check.nothing_along(c);
            turn += scale * scale * c.lack.dot(lack - c.lack);
            square += scale * scale * (lack - c.lack).squaredNorm();
        }
        c.lack = lack;
    }
    return square > 0 ? std::clamp(-last * turn / square, least_relaxation, 1.0) : 1.0;
}

// Gives a contact the forecast's state; `relaxation`: factor on the change of its sliding friction, if it slides in both.
template <int D>
void take_state(Contact<D>& c, const ContactImpulse<D>& next, const std::vector<Twist<D>>& twists,
                std::optional<double> relaxation)
{
    c.slides = slides_next(c, next);
    c.closed = next.normal > 0;
    c.expected = next;
    if (relaxation && c.slides)
        c.sliding_impulse += *relaxation * (next.tangential - c.sliding_impulse);
    else
        c.sliding_impulse = c.slides ? next.tangential : Vec<D - 1>(Vec<D - 1>::Zero());
    c.slip = 0;
    for (const RelativeRow<D>& t : c.tangents)
        c.slip = std::hypot(c.slip, rate(t, c, twists));
}

} // namespace

template <int D>
void ContactSet<D>::take_impulses(const Eigen::VectorXd& impulses)
{
    int row = 0;
    for (Contact<D>& c : contacts_) {
        c.impulse = 0;
        c.tangential.setZero();
        if (!c.closed)
            continue;
        c.impulse = impulses[row++];
        if (c.friction > 0 && !c.slides)
            for (int k = 0; k < D - 1; ++k)
                c.tangential[k] = impulses[row++];
        if (c.slides)
            c.tangential = c.sliding_impulse;
        if (resists_turning(c))
            c.tangential += impulses[row++] * across_pull(c);
    }
}

// Remembers the states of the solve just made, and tells whether an earlier one was made with those that are to be next.
template <int D>
bool ContactSet<D>::repeats(const States& next, bool exact)
{
    if (exact != seen_exact_)
        seen_.clear();
    seen_exact_ = exact;
    States now;
    for (const Contact<D>& c : contacts_)
        now.push_back(state_of(c));
    seen_.insert(std::move(now));
    return seen_.contains(next);
}

template <int D>
void ContactSet<D>::forget_rounds()
{
    seen_.clear();
    secants_.forget();
    left_ = std::numeric_limits<double>::infinity();
}

// Another exact solve, for what pairs of them tell of the inertia.
template <int D>
void ContactSet<D>::remember(const std::vector<Twist<D>>& twists)
{
    constexpr int n = twist_size<D>;
    std::vector<Twist<D>> impulses(twists.size(), Twist<D>::Zero());
    for (const Contact<D>& c : contacts_)
        add_impulse(c, impulses);
    const auto stacked = [](const std::vector<Twist<D>>& all) {
        Eigen::VectorXd column(n * static_cast<long>(all.size()));
        for (std::size_t s = 0; s < all.size(); ++s)
            column.template segment<n>(n * static_cast<long>(s)) = all[s];
        return column;
    };
    secants_.add(stacked(twists), stacked(impulses));
}

// While none of the contacts that are to rebound is closed, the twists are those without an impact, from which a rebound of more speed would take more energy than it
// found: impulses times the mean of the speeds without and with them.
template <int D>
void ContactSet<D>::limit_rebounds(const std::vector<Twist<D>>& twists)
{
    const auto rebounds = [](const Contact<D>& c) { return c.target > c.least; };
    if (std::any_of(contacts_.begin(), contacts_.end(), [&](const Contact<D>& c) { return c.closed && rebounds(c); }))
        return;
    for (Contact<D>& c : contacts_)
        if (rebounds(c))
            c.target = std::max(c.least, std::min(c.target, -c.restitution * rate(c.normal, c, twists)));
}

template <int D>
ContactChange ContactSet<D>::update(const std::vector<Twist<D>>& twists, const Eigen::VectorXd& impulses,
                                    const NearInertia<D>& inertia, const ContactAccuracy& accuracy, bool exact, int round)
{
    take_impulses(impulses);
    limit_rebounds(twists);
    if (exact)
        remember(twists);
    const ContactCheck<D> check(contacts_, twists, inertia, accuracy, secants_.secants());
    const ContactForecast<D>& forecast = check.forecast();
    const auto [worst, violation] = check.worst();
    const double left = check.worst({bearable, accuracy.friction}).second,
                 last_left = std::exchange(left_, exact ? left : std::numeric_limits<double>::infinity());
    if (violation <= accuracy.noticed || (left <= 1 && left > least_gain * last_left)) {
        // Where redundant contacts share a force, as floor and ceiling of a wedged body do, the solve's impulses may include
        // negative ones: the forecast's are positive and move no body.
        if (check.any_pulls())
            for (std::size_t i = 0; i < contacts_.size(); ++i) {
                contacts_[i].impulse = forecast.impulses[i].normal;
                contacts_[i].tangential = forecast.impulses[i].tangential;
            }
        return ContactChange::none;
    }
    bool at_once = round < rounds_at_once && !one_at_a_time_, other_states = false;
    const States next = next_states<D>(contacts_, forecast, at_once ? std::nullopt : std::optional(worst), other_states);
    ContactChange changed = violation <= 1 ? ContactChange::slight
                            : other_states ? ContactChange::states
                                           : ContactChange::friction;
    if (changed == ContactChange::states && repeats(next, exact)) {
        changed = ContactChange::repeats;
        repetitions_ += exact;
        one_at_a_time_ = repetitions_ > most_repetitions;
    }
    const bool friction_alone = changed == ContactChange::friction;
    at_once = round < rounds_at_once && (!one_at_a_time_ || friction_alone);
    relaxation_ = relaxation_of_friction<D>(contacts_, check, friction_alone && at_once, relaxation_);
    for (std::size_t i = 0; i < contacts_.size(); ++i)
        if (at_once || i == worst)
            take_state<D>(contacts_[i], forecast.impulses[i], forecast.twists,
                          friction_alone ? std::optional(relaxation_) : std::nullopt);
    return changed;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template void ContactSet<D>::forget_rounds();                                                                              \
    template void ContactSet<D>::remember(const std::vector<Twist<D>>&);                                                       \
    template void ContactSet<D>::take_impulses(const Eigen::VectorXd&);                                                        \
    template void ContactSet<D>::limit_rebounds(const std::vector<Twist<D>>&);                                                 \
    template bool ContactSet<D>::repeats(const States&, bool);                                                                 \
    template ContactChange ContactSet<D>::update(const std::vector<Twist<D>>&, const Eigen::VectorXd&, const NearInertia<D>&,  \
                                                 const ContactAccuracy&, bool, int);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
