// The set of contacts: finding them, their conditions in a step, and their contributions to the solve.
#include "gapflow/stepping/contact_set.hpp"
#include "gapflow/stepping/contact_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gapflow {

namespace {

constexpr double merge = 0.01; // in dx: contacts closer together are one
// A contact keeps its state if it was within this of its place, in dx.
constexpr double same_place = 0.5;
// An approach below this times the change by the step's forces is resting contact, not impact.
constexpr double resting = 2.0;
constexpr double crushing = 1e-2; // of the largest speed about: a held contact that closes faster is an error

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
    const auto hold = [&](int a, int b) { return law(a, b).hold; };
    for (const ContactPoint<D>& point :
         find_contacts<D>(solids, features_, low_, high_, period_, hold, thickest(), merge * dx_)) {
        double& distance = placed_.try_emplace({point.a, point.b}, point.distance).first->second;
        distance = std::min(distance, point.distance);
    }
}

template <int D>
double ContactSet<D>::thickest() const
{
    double thickest = std::max(scene_->contact.thickness, scene_->gap.roughness);
    for (const PairScene& pair : scene_->pairs)
        thickest = std::max({thickest, pair.contact.thickness, pair.gap.roughness});
    return thickest;
}

template <int D>
void ContactSet<D>::move_domain(const Grid<D>& grid)
{
    low_ = grid.origin();
    high_ = grid.origin() + grid.size();
}

template <int D>
typename ContactSet<D>::PairLaw ContactSet<D>::law(int a, int b) const
{
    const ContactScene& contact = scene_->contact_of(names_[a], names_[b]);
    const double hold = scene_->held_distance(names_[a], names_[b]);
    const auto placed = placed_.find({a, b});
    const double least =
        placed == placed_.end() ? hold : std::max(scene_->least_distance(names_[a], names_[b]), std::min(placed->second, hold));
    return {hold, least, contact.restitution, contact.friction};
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
    auto reach = [&](int a, int b) { return law(a, b).hold + cushion * dx_ + 2 * dt * (speed[a] + speed[b]); };
    const double largest = thickest() + cushion * dx_ + 4 * dt * fastest;

    Vec<D> low = low_, high = high_;
    for (int side = 0; side < 2 * D; ++side) // bodies are at home above a water level, too
        if (scene_->sides[side].kind == SideScene::Kind::surface)
            (side % 2 ? high : low)[side / 2] = (side % 2 ? 1 : -1) * std::numeric_limits<double>::infinity();
    const std::vector<Contact<D>> old = std::move(contacts_);
    contacts_.clear();
    for (ContactPoint<D>& point : find_contacts<D>(solids, features_, low, high, period_, reach, largest, merge * dx_)) {
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
            contact.sliding_impulse = known->slides ? known->tangential : Vec<D - 1>::Zero();
            contact.tangential = contact.sliding_impulse; // known from before if found again after bodies were separated
            contact.slip = known->slip;
            contact.approach = rate(known->normal, *known, twists);
        }
        contact.point = std::move(point);
        contacts_.push_back(std::move(contact));
    }
}

template <int D>
void ContactSet<D>::prepare(const std::vector<Twist<D>>& before, const std::vector<Twist<D>>& forced,
                            const std::vector<Twist<D>>& expected, double dt, double last_dt)
{
    relaxation_ = 1;
    seen_exact_ = one_at_a_time_ = false;
    repetitions_ = 0;
    forget_rounds();
    for (Contact<D>& c : contacts_) {
        if (last_dt > 0)
            c.sliding_impulse *= dt / last_dt;
        const double by_old_row = c.approach; // if it was known
        c.approach = rate(c.normal, c, before);
        c.gained = c.forced = std::abs(rate(c.normal, c, forced) - c.approach);
        for (const RelativeRow<D>& t : c.tangents)
            c.forced = std::hypot(c.forced, rate(t, c, forced) - rate(t, c, before));
        // Surfaces that slide on each other turn the normal: what that changes of the rate of a contact that holds is no impact.
        if (scene_->parts && c.closed)
            c.forced += std::abs(c.approach - by_old_row) / slight_impact;
        c.least = -std::max(c.point.distance - c.hold, 0.0) / dt;
        const bool impact = c.restitution > 0 && c.approach < -resting * c.gained && c.approach < 0;
        // Of the speed that fluid in the gap leaves until they meet.
        c.target = impact ? std::max(c.least, c.restitution * std::min(-c.approach, -rate(c.normal, c, expected))) : c.least;
        // A contact at rest may drift within the tolerance: only contacts that close in this step are held.
        // And what rebounds is open until a solve has told with what speed it would close.
        if (c.closed && (c.point.distance - c.hold > cushion * dx_ || c.target > c.least))
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
        rows.push_back({c.point.a, c.point.b, c.normal.a, c.normal.b, c.target, rigid, c.expected.normal});
        if (c.friction > 0 && !c.slides)
            for (int k = 0; k < D - 1; ++k) {
                const RelativeRow<D>& t = c.tangents[k];
                rows.push_back({c.point.a, c.point.b, t.a, t.b, 0.0, rigid, c.expected.tangential[k]});
            }
        if (resists_turning(c)) {
            const RelativeRow<D> across = row_along(c, across_pull(c));
            rows.push_back(
                {c.point.a, c.point.b, across.a, across.b, 0.0, c.slip > 0 ? c.sliding_impulse.norm() / c.slip : rigid});
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
                impulses[c.point.a] += c.sliding_impulse[k] * c.tangents[k].a;
                impulses[c.point.b] += c.sliding_impulse[k] * c.tangents[k].b;
            }
    return impulses;
}

// A hinged leaflet at rest on its seat has speeds of round-off only: closing by less than the tolerated overlap counts as zero.
template <int D>
const Contact<D>* ContactSet<D>::crushed(const std::vector<Twist<D>>& twists, double dt) const
{
    double largest = 0;
    for (const Contact<D>& c : contacts_)
        largest = std::max({largest, std::abs(c.approach), c.gained, twists[c.point.a].template head<D>().norm(),
                            twists[c.point.b]
                                .template head<D>()
                                .norm()}); // not the rates alone: sliding contacts have rates of round-off only
    const double most = std::max(crushing * largest, overlap_left * dx_ / dt);
    const auto found = std::find_if(contacts_.begin(), contacts_.end(), [&](const Contact<D>& c) {
        return c.closed && rate(c.normal, c, twists) < c.least - most;
    });
    return found == contacts_.end() ? nullptr : &*found;
}

template <int D>
bool ContactSet<D>::driven(const Contact<D>& contact, const std::vector<Solid<D>>& solids,
                           const std::vector<Twist<D>>& twists) const
{
    std::set<int> reached{contact.point.a, contact.point.b};
    for (std::size_t before = 0; before < reached.size();) {
        before = reached.size();
        for (const Contact<D>& c : contacts_)
            for (const auto& [from, to] : {std::pair(c.point.a, c.point.b), std::pair(c.point.b, c.point.a)})
                if (c.closed && reached.contains(from) && solids[from].motion == Motion::free)
                    reached.insert(to);
    }
    return std::any_of(reached.begin(), reached.end(),
                       [&](int s) { return solids[s].motion == Motion::prescribed && !twists[s].isZero(0); });
}

template <int D>
bool ContactSet<D>::rebounds(int a, int b) const
{
    return std::any_of(contacts_.begin(), contacts_.end(), [&](const Contact<D>& c) {
        return c.closed && c.target > c.least && std::minmax(c.point.a, c.point.b) == std::minmax(a, b);
    });
}

template <int D>
void ContactSet<D>::hold_back(int a, int b)
{
    for (Contact<D>& c : contacts_)
        if (std::minmax(c.point.a, c.point.b) == std::minmax(a, b))
            c.target = std::min(c.target, c.least);
}

namespace {

template <int D>
bool is_impact(const Contact<D>& c)
{
    return c.closed != c.was_closed || (c.closed && std::abs(c.target - c.approach) > slight_impact * c.forced);
}

} // namespace

template <int D>
void ContactSet<D>::add_impulses(const ContactSet& earlier)
{
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
        const Contact<D>& before = earlier.contacts_[k];
        if (!before.closed)
            continue;
        Contact<D>& c = contacts_[k];
        c.impulse = (c.closed ? c.impulse : 0) + before.impulse;
        c.tangential = (c.closed ? c.tangential : Vec<D - 1>(Vec<D - 1>::Zero())) + before.tangential;
        c.closed = true;
    }
}

template <int D>
bool ContactSet<D>::impact_on(int solid) const
{
    return std::any_of(contacts_.begin(), contacts_.end(),
                       [&](const Contact<D>& c) { return (c.point.a == solid || c.point.b == solid) && is_impact(c); });
}

template <int D>
std::vector<Twist<D>> ContactSet<D>::impact_impulses(std::size_t solids) const
{
    std::vector<Twist<D>> impulses(solids, Twist<D>::Zero());
    for (const Contact<D>& c : contacts_)
        if (c.closed && is_impact(c))
            add_impulse(c, impulses);
    return impulses;
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
        list("forced", c.forced);
        list("least", c.least);
        list("target", c.target);
        list("closed", c.closed);
        list("was_closed", c.was_closed);
        list("slides", c.slides);
        list("slip", c.slip);
        list("pull", c.sliding_impulse);
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
