// Active set around the coupled solve: the bodies' laws of contact, with the fluid's answer as it was, forecast which contacts hold,
// stick and slide; all change at once while that settles, the worst alone once they would go round in circles.
#include "gapflow/stepping/contact_set.hpp"

#include "gapflow/body/move.hpp"
#include "gapflow/stepping/contact_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace gapflow {

namespace {

// In dx. Contacts this close are looked at even without approach; nearer together than `merge` they are one; overlaps below
// `round_off` are left; no contact is pushed open further at a time.
constexpr double cushion = 0.02;
constexpr double merge = 0.01;
constexpr double round_off = 1e-6, start_round_off = 1e-9;
constexpr double longest_push = 0.1, longest_start_push = 0.5;
// Of the overlaps of all that hang together: pushing them apart takes no body further, else masses are left out of it. (A light ball pinched
// by half a cell between two boxes, turned by 5 degrees, slips out sideways by nearly six cells before boxes of a thousand times its mass move.)
constexpr double too_far = 2;
constexpr double wedge_compliance = 1e-2; // of the bodies' own mobility
// A contact keeps its state if it was within this of its place, in dx.
constexpr double same_place = 0.5;
// Approach below this times what the step's forces add is resting, not impact.
constexpr double resting = 2.0;
// A contact whose opening rate changes by less than this times what the forces add leaves its bodies' motion smooth.
constexpr double smooth = 0.05;
// Rounds after which contacts change one at a time; or as soon as they would be again what they were in an exact solve before.
constexpr int rounds_at_once = 15;
constexpr double friction_accuracy = 1e-3; // of the largest bound of friction on the body
constexpr double least_relaxation = 0.3;   // of sliding pulls
constexpr double forecast_accuracy = 1e-2; // of what is asked of the speeds
constexpr double crushing = 1e-2;          // of the largest speed about: held contacts that close faster cannot be held

template <int D>
std::array<Vec<D>, D - 1> tangents_of(const Vec<D>& n)
{
    if constexpr (D == 2) {
        return {Vec<2>(-n[1], n[0])};
    } else {
        int least = 0;
        n.cwiseAbs().minCoeff(&least);
        const Vec<3> t = n.cross(unit<3>(least)).normalized();
        return {t, Vec<3>(n.cross(t))};
    }
}

template <int D>
bool is_free(const std::vector<RigidBody<D>>& bodies, int solid)
{
    return solid < static_cast<int>(bodies.size()) && bodies[solid].motion == Motion::free;
}

// Whether a push along the row can move the solid: constraints may let it go only across.
template <int D>
bool yields(const Solid<D>& solid, const Twist<D>& row)
{
    return solid.motion == Motion::free && (solid.admissible * row).norm() > 1e-12 * row.norm();
}

template <int D>
double rate(const RelativeRow<D>& row, const Contact<D>& contact, const std::vector<Twist<D>>& twists)
{
    return row.a.dot(twists[contact.point.a]) + row.b.dot(twists[contact.point.b]);
}

// Sliding friction turns with the slip: -bound (slip / |slip|). To first order that is a given pull against the slip of the round
// before, and across it the resistance bound / |slip|, part of the solve: explicit it would grow without bound where bodies
// barely slide.
template <int D>
bool resists_turning(const Contact<D>& c)
{
    return D == 3 && c.closed && c.slides && c.pull.squaredNorm() > 0;
}

// Open, sticks, slides.
template <int D>
char state_of(const Contact<D>& c)
{
    return static_cast<char>(c.closed + (c.closed && c.slides));
}

template <int D>
Vec<D - 1> across_pull(const Contact<D>& c)
{
    if constexpr (D == 3)
        return Vec<2>(-c.pull[1], c.pull[0]).normalized();
    else
        return Vec<1>::Zero();
}

template <int D>
RelativeRow<D> row_along(const Contact<D>& c, const Vec<D - 1>& direction)
{
    RelativeRow<D> row{Twist<D>::Zero(), Twist<D>::Zero()};
    for (int k = 0; k < D - 1; ++k) {
        row.a += direction[k] * c.tangents[k].a;
        row.b += direction[k] * c.tangents[k].b;
    }
    return row;
}

} // namespace

template <int D>
ContactSet<D>::ContactSet(const Scene& scene, const Grid<D>& grid, const std::vector<Solid<D>>& solids)
    : scene_(&scene), dx_(grid.dx()), low_(grid.origin()), high_(grid.origin() + grid.size()), period_(Vec<D>::Zero())
{
    for (int axis = 0; axis < D; ++axis)
        if (grid.periodic(axis))
            period_[axis] = grid.size()[axis];
    for (const Solid<D>& solid : solids) {
        names_.push_back(solid.name);
        features_.push_back(contact_features(solid.shape.shape()));
    }
}

template <int D>
typename ContactSet<D>::PairLaw ContactSet<D>::law(int a, int b) const
{
    const ContactScene& contact = scene_->contact_of(names_[a], names_[b]);
    return {scene_->held_distance(names_[a], names_[b]), scene_->least_distance(names_[a], names_[b]), contact.restitution, contact.friction};
}

template <int D>
void ContactSet<D>::find(const std::vector<Solid<D>>& solids, const std::vector<Twist<D>>& twists, double dt)
{
    // No surface moves faster than this.
    std::vector<double> speed(solids.size());
    double fastest = 0;
    for (std::size_t s = 0; s < solids.size(); ++s) {
        const double radius = bounding_radius<D>(world_bounds(solids[s].shape));
        const double spin = twists[s].template tail<spin_size<D>>().norm();
        speed[s] = twists[s].template head<D>().norm() + (spin > 0 ? spin * std::min(2 * radius, (high_ - low_).norm()) : 0.0);
        fastest = std::max(fastest, speed[s]);
    }
    double thickest = std::max(scene_->contact.thickness, scene_->gap.roughness);
    for (const PairScene& pair : scene_->pairs)
        thickest = std::max({thickest, pair.contact.thickness, pair.gap.roughness});
    auto reach = [&](int a, int b) { return law(a, b).hold + cushion * dx_ + 2 * dt * (speed[a] + speed[b]); };
    const double largest = thickest + cushion * dx_ + 4 * dt * fastest;

    const std::vector<Contact<D>> old = std::move(contacts_);
    contacts_.clear();
    for (ContactPoint<D>& point : find_contacts<D>(solids, features_, low_, high_, period_, reach, largest, merge * dx_)) {
        Contact<D> contact;
        const PairLaw pair = law(point.a, point.b);
        contact.hold = pair.hold;
        contact.least_distance = pair.least_distance;
        contact.restitution = pair.restitution;
        contact.friction = pair.friction;
        contact.normal = relative_row<D>(point, solids, point.normal);
        if (!yields(solids[point.a], contact.normal.a) && !yields(solids[point.b], contact.normal.b))
            continue;
        const auto directions = tangents_of<D>(point.normal);
        for (int k = 0; k < D - 1; ++k)
            contact.tangents[k] = relative_row<D>(point, solids, directions[k]);
        contact.mark = solids[point.a].shape.to_body(point.x);
        const Contact<D>* known = nullptr;
        double nearest = same_place * dx_;
        for (const Contact<D>& other : old)
            if (other.point.a == point.a && other.point.b == point.b && other.point.normal.dot(point.normal) > 0.9)
                if (const double d = (other.mark - contact.mark).norm(); d < nearest) {
                    nearest = d;
                    known = &other;
                }
        if (known) {
            contact.closed = contact.was_closed = known->closed;
            contact.slides = known->slides;
            contact.pull = known->slides ? known->tangential : Vec<D - 1>::Zero();
            contact.tangential = contact.pull; // found again after bodies were pushed apart, it is still known
            contact.slip = known->slip;
        }
        contact.point = std::move(point);
        contacts_.push_back(std::move(contact));
    }
}

// Smallest displacements that leave no overlap, by projected Gauss-Seidel: in the metric of mass, or `evenly`, in one that knows no
// masses. There a push meets a little compliance too, so that bodies wedged in share what overlaps instead of chasing a place where they fit.
template <int D>
std::vector<Twist<D>> ContactSet<D>::displacements(const std::vector<RigidBody<D>>& bodies, bool evenly, double longest, double accuracy) const
{
    std::vector<Twist<D>> moved(bodies.size(), Twist<D>::Zero());
    auto response = [&](int s, const Twist<D>& row) -> Twist<D> {
        if (!is_free(bodies, s))
            return Twist<D>::Zero();
        const Twist<D> answer = twist_after(bodies[s], row) - twist_after(bodies[s], Twist<D>(Twist<D>::Zero()));
        return evenly ? Twist<D>(bodies[s].mass * answer) : answer;
    };
    struct Row {
        Twist<D> response_a, response_b;
        double mobility, push = 0;
    };
    std::vector<Row> rows;
    for (const Contact<D>& c : contacts_) {
        Row row{response(c.point.a, c.normal.a), response(c.point.b, c.normal.b), 0};
        row.mobility = row.response_a.dot(c.normal.a) + row.response_b.dot(c.normal.b);
        rows.push_back(row);
    }
    for (int sweep = 0; sweep < (evenly ? 1000 : 100); ++sweep) {
        double largest = 0;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const Contact<D>& c = contacts_[i];
            Row& row = rows[i];
            if (row.mobility <= 0)
                continue;
            double distance = c.point.distance;
            if (is_free(bodies, c.point.a))
                distance += c.normal.a.dot(moved[c.point.a]);
            if (is_free(bodies, c.point.b))
                distance += c.normal.b.dot(moved[c.point.b]);
            const double compliance = evenly ? wedge_compliance * row.mobility : 0.0;
            const double lack = std::min(c.least_distance, c.point.distance + longest) - distance - compliance * row.push;
            const double push = std::max(row.push + lack / (row.mobility + compliance), 0.0);
            const double change = push - row.push;
            row.push = push;
            if (is_free(bodies, c.point.a))
                moved[c.point.a] += change * row.response_a;
            if (is_free(bodies, c.point.b))
                moved[c.point.b] += change * row.response_b;
            largest = std::max(largest, std::abs(change) * row.mobility);
        }
        if (largest < 0.1 * accuracy)
            break;
    }
    return moved;
}

// Whether some body would go further, at its centre or a contact, than the overlaps of all that it hangs together with ask for.
template <int D>
bool ContactSet<D>::goes_too_far(const std::vector<RigidBody<D>>& bodies, const std::vector<Twist<D>>& moved, double longest) const
{
    std::vector<int> parent(bodies.size());
    std::iota(parent.begin(), parent.end(), 0);
    auto root = [&](int b) {
        while (parent[b] != b)
            b = parent[b] = parent[parent[b]];
        return b;
    };
    for (const Contact<D>& c : contacts_)
        if (is_free(bodies, c.point.a) && is_free(bodies, c.point.b))
            parent[root(c.point.a)] = root(c.point.b);
    std::vector<double> asked(bodies.size(), 0.0), furthest(bodies.size(), 0.0);
    for (const Contact<D>& c : contacts_) {
        const int member = root(is_free(bodies, c.point.a) ? c.point.a : c.point.b);
        asked[member] += std::clamp(c.least_distance - c.point.distance, 0.0, longest);
        const Vec<D> at = 0.5 * (c.point.x + c.point.y);
        auto look = [&](int s, const Vec<D>& x) {
            if (is_free(bodies, s))
                furthest[member] = std::max({furthest[member], moved[s].template head<D>().norm(),
                                             velocity_at<D>(moved[s], x - bodies[s].centre()).norm()});
        };
        look(c.point.a, at);
        look(c.point.b, at - c.point.shift);
    }
    for (std::size_t b = 0; b < bodies.size(); ++b)
        if (furthest[b] > too_far * asked[b])
            return true;
    return false;
}

template <int D>
bool ContactSet<D>::push_apart(std::vector<RigidBody<D>>& bodies, bool at_start) const
{
    const double accuracy = (at_start ? start_round_off : round_off) * dx_, longest = (at_start ? longest_start_push : longest_push) * dx_;
    double deepest = 0;
    for (const Contact<D>& c : contacts_)
        deepest = std::max(deepest, c.least_distance - c.point.distance);
    if (deepest <= accuracy)
        return false;
    std::vector<Twist<D>> moved = displacements(bodies, at_start, longest, accuracy);
    if (!at_start && goes_too_far(bodies, moved, longest))
        moved = displacements(bodies, true, longest, accuracy);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (moved[b].isZero(0))
            continue;
        displace<D>(bodies[b], moved[b].template head<D>(), moved[b].template tail<spin_size<D>>());
    }
    return true;
}

template <int D>
void ContactSet<D>::prepare(const std::vector<Twist<D>>& before, const std::vector<Twist<D>>& forced, double dt, double last_dt)
{
    relaxation_ = 1;
    seen_.clear();
    seen_exact_ = one_at_a_time_ = false;
    for (Contact<D>& c : contacts_) {
        if (last_dt > 0)
            c.pull *= dt / last_dt;
        c.approach = rate(c.normal, c, before);
        c.gained = std::abs(rate(c.normal, c, forced) - c.approach);
        c.least = -std::max(c.point.distance - c.hold, 0.0) / dt;
        const bool impact = c.restitution > 0 && c.approach < -resting * c.gained && c.approach < 0;
        c.target = impact ? -c.restitution * c.approach : c.least;
        // What rests near its place may drift within it: only what closes in this step is held.
        if (c.closed && c.point.distance - c.hold > cushion * dx_)
            c.closed = c.slides = false;
    }
}

template <int D>
bool ContactSet<D>::likely_to_change(const std::vector<Twist<D>>& expected) const
{
    return std::any_of(contacts_.begin(), contacts_.end(), [&](const Contact<D>& c) {
        return c.closed ? !c.was_closed || c.target > c.least : rate(c.normal, c, expected) < c.least;
    });
}

template <int D>
std::vector<HeldContact<D>> ContactSet<D>::held() const
{
    constexpr double rigid = std::numeric_limits<double>::infinity();
    std::vector<HeldContact<D>> rows;
    for (const Contact<D>& c : contacts_) {
        if (!c.closed)
            continue;
        rows.push_back({c.point.a, c.point.b, c.normal.a, c.normal.b, c.target});
        if (c.friction > 0 && !c.slides)
            for (const RelativeRow<D>& t : c.tangents)
                rows.push_back({c.point.a, c.point.b, t.a, t.b, 0.0});
        if (resists_turning(c)) {
            const RelativeRow<D> across = row_along(c, across_pull(c));
            rows.push_back({c.point.a, c.point.b, across.a, across.b, 0.0, c.slip > 0 ? c.pull.norm() / c.slip : rigid});
        }
    }
    return rows;
}

template <int D>
std::vector<Twist<D>> ContactSet<D>::sliding_impulses(std::size_t solids) const
{
    std::vector<Twist<D>> impulses(solids, Twist<D>::Zero());
    for (const Contact<D>& c : contacts_)
        if (c.closed && c.slides)
            for (int k = 0; k < D - 1; ++k) {
                impulses[c.point.a] += c.pull[k] * c.tangents[k].a;
                impulses[c.point.b] += c.pull[k] * c.tangents[k].b;
            }
    return impulses;
}

template <int D>
void ContactSet<D>::take_impulses(const Eigen::VectorXd& impulses)
{
    int row = 0;
    for (Contact<D>& c : contacts_) {
        c.impulse = 0;
        c.tangential.setZero();
        if (!c.closed)
            continue;
        c.solved = true;
        c.impulse = impulses[row++];
        if (c.friction > 0 && !c.slides)
            for (int k = 0; k < D - 1; ++k)
                c.tangential[k] = impulses[row++];
        if (c.slides)
            c.tangential = c.pull;
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
ContactChange ContactSet<D>::update(const std::vector<Twist<D>>& twists, const Eigen::VectorXd& impulses,
                                    const NearInertia<D>& inertia, double accuracy, bool exact, int round)
{
    take_impulses(impulses);
    const std::vector<TwistMatrix<D>>& mobility = inertia.mobility;
    std::vector<ContactImpulse<D>> given;
    double largest_speed = 0, largest_impulse = 0;
    for (const Contact<D>& c : contacts_) {
        given.push_back({c.impulse, c.tangential});
        largest_speed = std::max({largest_speed, std::abs(c.approach), std::abs(c.target), std::abs(rate(c.normal, c, twists))});
        largest_impulse = std::max(largest_impulse, std::abs(c.impulse));
    }
    const double speed = accuracy * largest_speed, impulse = accuracy * largest_impulse; // that count as nothing
    const ContactForecast<D> forecast = forecast_contacts<D>(contacts_, given, twists, inertia, forecast_accuracy * speed);

    // Wrong is a contact that closes too fast, and one at which the forecast's impulses move the bodies. (Impulses alone do not
    // tell: redundant contacts may share theirs in many ways.) In units of what is allowed.
    auto change = [&](std::size_t i, const RelativeRow<D>& row) {
        return std::abs(rate(row, contacts_[i], forecast.twists) - rate(row, contacts_[i], twists));
    };
    auto yield_of = [&](std::size_t i, const RelativeRow<D>& row) {
        return row.a.dot(mobility[contacts_[i].point.a] * row.a) + row.b.dot(mobility[contacts_[i].point.b] * row.b);
    };
    // Friction is right to a part of what friction may do to the body, not of what it may do at the contact: the least of many.
    std::vector<double> friction(mobility.size(), 0.0);
    for (std::size_t i = 0; i < contacts_.size(); ++i)
        for (int solid : {contacts_[i].point.a, contacts_[i].point.b})
            friction[solid] = std::max(friction[solid], friction_accuracy * contacts_[i].friction * forecast.impulses[i].normal);
    auto friction_at = [&](const Contact<D>& c) {
        const int a = c.point.a, b = c.point.b;
        return mobility[a].isZero(0) ? friction[b] : mobility[b].isZero(0) ? friction[a] : std::min(friction[a], friction[b]);
    };
    auto wrong = [&](std::size_t i) {
        const Contact<D>& c = contacts_[i];
        if (!c.closed)
            return (c.least - rate(c.normal, c, twists)) / speed;
        double most = change(i, c.normal) / (speed + impulse * yield_of(i, c.normal));
        if (c.friction > 0)
            for (const RelativeRow<D>& t : c.tangents)
                most = std::max(most, change(i, t) / ((impulse + friction_at(c)) * yield_of(i, t)));
        return most;
    };
    std::size_t worst = 0;
    double most = 0;
    for (std::size_t i = 0; i < contacts_.size(); ++i)
        if (const double w = wrong(i); w > most) {
            most = w;
            worst = i;
        }
    if (!(most > 1)) {
        // Where contacts share a force in many ways, as floor and ceiling of a body wedged in between do, the solve's may have pulling
        // ones among them: the forecast's push, and move nothing.
        if (std::any_of(given.begin(), given.end(), [&](const ContactImpulse<D>& g) { return g.normal < -impulse; }))
            for (std::size_t i = 0; i < contacts_.size(); ++i) {
                contacts_[i].impulse = forecast.impulses[i].normal;
                contacts_[i].tangential = forecast.impulses[i].tangential;
            }
        return ContactChange::none;
    }
    bool at_once = round < rounds_at_once && !one_at_a_time_;
    ContactChange changed = ContactChange::pulls;
    States next_states;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        const Contact<D>& c = contacts_[i];
        const ContactImpulse<D>& next = forecast.impulses[i];
        const bool closed = next.normal > 0, slides = c.solved && closed && c.friction > 0 && next.slides;
        if (c.closed != closed || c.slides != slides)
            changed = ContactChange::states;
        next_states.push_back(at_once || i == worst ? static_cast<char>(closed + slides) : state_of(c));
    }
    if (changed == ContactChange::states && repeats(next_states, exact)) {
        changed = ContactChange::repeats;
        one_at_a_time_ = one_at_a_time_ || exact;
    }
    at_once = round < rounds_at_once && (!one_at_a_time_ || changed == ContactChange::pulls);
    // The forecast knows the bulk's answer only nearly, and pulls can swing about their values for long: dynamic relaxation (Irons & Tuck,
    // Int. J. Numer. Methods Eng. 1, 1969).
    double turn = 0, square = 0;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        Contact<D>& c = contacts_[i];
        const Vec<D - 1> lack = forecast.impulses[i].tangential - c.pull;
        if (changed != ContactChange::pulls || !at_once || !c.closed || !c.slides) {
            c.lack.setZero();
            continue;
        }
        if (!c.lack.isZero(0)) {
            const double scale = 1 / (impulse + friction_at(c));
            turn += scale * scale * c.lack.dot(lack - c.lack);
            square += scale * scale * (lack - c.lack).squaredNorm();
        }
        c.lack = lack;
    }
    relaxation_ = square > 0 ? std::clamp(-relaxation_ * turn / square, least_relaxation, 1.0) : 1.0;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        if (!at_once && i != worst)
            continue;
        Contact<D>& c = contacts_[i];
        const ContactImpulse<D>& next = forecast.impulses[i];
        c.closed = next.normal > 0;
        c.slides = c.solved && c.closed && c.friction > 0 && next.slides;
        if (changed == ContactChange::pulls && c.slides)
            c.pull += relaxation_ * (next.tangential - c.pull);
        else
            c.pull = c.slides ? next.tangential : Vec<D - 1>(Vec<D - 1>::Zero());
        c.slip = 0;
        for (const RelativeRow<D>& t : c.tangents)
            c.slip = std::hypot(c.slip, rate(t, c, forecast.twists));
    }
    return changed;
}

// A hinged leaflet at rest on its seat has no speed but round-off: what closes by less than the overlaps that are left is nothing.
template <int D>
const Contact<D>* ContactSet<D>::crushed(const std::vector<Twist<D>>& twists, double dt) const
{
    double largest = 0;
    for (const Contact<D>& c : contacts_)
        largest = std::max({largest, std::abs(c.approach), c.gained, twists[c.point.a].template head<D>().norm(),
                            twists[c.point.b].template head<D>().norm()}); // not the rates alone: what slides in contact has none but round-off
    const double most = std::max(crushing * largest, round_off * dx_ / dt);
    const auto found = std::find_if(contacts_.begin(), contacts_.end(),
                                    [&](const Contact<D>& c) { return c.closed && rate(c.normal, c, twists) < c.least - most; });
    return found == contacts_.end() ? nullptr : &*found;
}

template <int D>
bool ContactSet<D>::driven(const Contact<D>& contact, const std::vector<Solid<D>>& solids, const std::vector<Twist<D>>& twists) const
{
    std::set<int> reached{contact.point.a, contact.point.b};
    for (std::size_t before = 0; before < reached.size();) {
        before = reached.size();
        for (const Contact<D>& c : contacts_)
            for (const auto& [from, to] : {std::pair(c.point.a, c.point.b), std::pair(c.point.b, c.point.a)})
                if (c.closed && reached.contains(from) && solids[from].motion == Motion::free)
                    reached.insert(to);
    }
    return std::any_of(reached.begin(), reached.end(), [&](int s) { return solids[s].motion == Motion::prescribed && !twists[s].isZero(0); });
}

template <int D>
bool ContactSet<D>::impact_on(int solid) const
{
    return std::any_of(contacts_.begin(), contacts_.end(), [&](const Contact<D>& c) {
        return (c.point.a == solid || c.point.b == solid) &&
               (c.closed != c.was_closed || (c.closed && std::abs(c.target - c.approach) > smooth * c.gained));
    });
}

template <int D>
void ContactSet<D>::list_state(StateArchive& archive)
{
    archive.each("contacts", contacts_, [](StateArchive& list, Contact<D>& c) {
        list("a", c.point.a);
        list("b", c.point.b);
        list("shift", c.point.shift);
        list("x", c.point.x);
        list("y", c.point.y);
        list("unit_normal", c.point.normal);
        list("distance", c.point.distance);
        list("hold", c.hold);
        list("restitution", c.restitution);
        list("friction", c.friction);
        list("normal_a", c.normal.a);
        list("normal_b", c.normal.b);
        for (RelativeRow<D>& tangent : c.tangents) {
            list("tangent_a", tangent.a);
            list("tangent_b", tangent.b);
        }
        list("approach", c.approach);
        list("gained", c.gained);
        list("least", c.least);
        list("target", c.target);
        list("closed", c.closed);
        list("was_closed", c.was_closed);
        list("slides", c.slides);
        list("slip", c.slip);
        list("pull", c.pull);
        list("impulse", c.impulse);
        list("tangential", c.tangential);
        list("mark", c.mark);
    });
    for (const Contact<D>& c : contacts_)
        if (std::min(c.point.a, c.point.b) < 0 || std::max(c.point.a, c.point.b) >= static_cast<int>(names_.size()))
            throw StateError("it has a contact of a body that the scene does not have");
}

template class ContactSet<2>;
template class ContactSet<3>;

} // namespace gapflow
