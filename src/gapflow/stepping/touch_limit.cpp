// Conservative advancement (B. Mirtich, "Impulse-based dynamic simulation of rigid body systems", 1996): from a distance d at time t the surfaces are
// apart up to the time at which a bound of their approach has used d up; there the distance is found anew.
//
// Between convex solids, n the direction of the shortest way between them at t, r the displacement of one's centre against the other's and theta their
// turns since then, the distance is no less than
//
//     d + n.r - sum_s sqrt(R_s^2 - r_s^2) theta_s,      R_s, r_s: radii of balls about the centre around and in the solid
//
// since a support function h of a body that turns changes by sqrt(R^2 - h^2) at most. The same holds of any solid and a wall. Of others it is no less
// than d - |r| - sum_s R_s theta_s.
#include "gapflow/stepping/touch_limit.hpp"

#include "gapflow/stepping/contact_rows.hpp"
#include "gapflow/stepping/motion.hpp"
#include "gapflow/stepping/short_text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gapflow {

namespace {

constexpr int samples = 8; // of a way: a body that is thrown up and falls back, or a motion from a table

// What bounds the motion of a solid's surface.
struct Extent {
    double outer = 0;   ///< radius of a ball around it, about the middle of its bounds
    double inner = 0;   ///< of one in it
    bool round = false; ///< turning about the middle does not move the surface
    bool moves = false;
};

template <int D>
class TouchSearch {
public:
    TouchSearch(const Model<D>& model, const State<D>& state, const std::vector<Solid<D>>& solids, double dt);
    double limited() const;

private:
    using Pair = NearPair<D>;
    Pose<D> pose(int solid, double t) const;
    double furthest(int solid) const;
    double least(const Pair& pair, const Separation<D>& from, double t, double later) const;
    std::optional<Separation<D>> apart(const Pair& pair, double t) const;
    double first_at(const Pair& pair, Separation<D> now, double level, double end) const;
    bool stops(const Pair& pair, double t) const;

    const Model<D>& model_;
    const State<D>& state_;
    const std::vector<Solid<D>>& solids_;
    double dt_, dx_;
    std::vector<std::vector<Pose<D>>> way_; ///< of every solid that moves, from 0 to dt
    std::vector<Vec<D>> middle_;            ///< of every solid's bounds, in the shape's frame
    std::vector<Extent> extent_;
    std::vector<double> reach_; ///< how far its surface goes at most
};

template <int D>
TouchSearch<D>::TouchSearch(const Model<D>& model, const State<D>& state, const std::vector<Solid<D>>& solids, double dt)
    : model_(model), state_(state), solids_(solids), dt_(dt), dx_(model.grid.dx()), way_(solids.size()),
      middle_(solids.size(), Vec<D>::Zero()), extent_(solids.size()), reach_(solids.size(), 0.0)
{
    for (std::size_t s = 0; s < state.bodies.size(); ++s) {
        if (solids[s].motion == Motion::fixed)
            continue;
        const Shape<D>& shape = solids[s].shape.shape();
        const Bounds<D> bounds = shape.bounds();
        Extent& extent = extent_[s];
        extent.moves = true;
        middle_[s] = 0.5 * (bounds.low + bounds.high);
        extent.outer = bounding_radius<D>(bounds);
        extent.inner = std::max(-shape.distance(middle_[s]), 0.0);
        extent.round = shape.sphere_radius().has_value();
        for (int k = 0; k <= samples; ++k)
            way_[s].push_back(k == 0 ? state.bodies[s].pose : pose(static_cast<int>(s), dt * k / samples));
        reach_[s] = furthest(static_cast<int>(s));
    }
}

// Of a solid in a step of length t.
template <int D>
Pose<D> TouchSearch<D>::pose(int solid, double t) const
{
    const std::vector<Pose<D>>& way = way_[solid];
    if (const auto k = static_cast<std::size_t>(std::lround(samples * t / dt_));
        k < way.size() && t == dt_ * static_cast<double>(k) / samples)
        return way[k];
    const RigidBody<D>& body = state_.bodies[solid];
    return moved(std::vector<RigidBody<D>>{body}, Step{state_.steps + 1, state_.time, t, state_.dt, 0}).front().pose;
}

template <int D>
double turn_between(const Pose<D>& from, const Pose<D>& to)
{
    return angle_between<D>(from.rotation, to.rotation).norm();
}

// How far a point of the surface goes at most.
template <int D>
double TouchSearch<D>::furthest(int solid) const
{
    const std::vector<Pose<D>>& way = way_[solid];
    const Extent& extent = extent_[solid];
    double most = 0;
    for (const Pose<D>& at : way) {
        const double shift =
            (at.position + at.matrix() * middle_[solid] - way[0].position - way[0].matrix() * middle_[solid]).norm();
        most = std::max(most, shift + (extent.round ? 0.0 : extent.outer * std::min(turn_between(way[0], at), 2.0)));
    }
    return most;
}

// The least distance that a pair can have at a later time.
template <int D>
double TouchSearch<D>::least(const Pair& pair, const Separation<D>& from, double t, double later) const
{
    Vec<D> shift = Vec<D>::Zero();
    double swing = 0, tilt = 0;
    for (const int s : {pair.a, pair.b}) {
        if (!extent_[s].moves)
            continue;
        const Pose<D> before = pose(s, t), after = pose(s, later);
        shift += (s == pair.a ? 1 : -1) *
                 (after.position + after.matrix() * middle_[s] - before.position - before.matrix() * middle_[s]);
        if (extent_[s].round)
            continue;
        const auto& [outer, inner, round, moves] = extent_[s];
        const double turn = turn_between(before, after);
        swing += outer * std::min(turn, 2.0);
        tilt += std::min(std::sqrt(outer * outer - inner * inner) * turn, outer - inner);
    }
    const Shape<D>&a = solids_[pair.a].shape.shape(), &b = solids_[pair.b].shape.shape();
    const bool support = (a.convex() && b.convex()) || (solids_[pair.b].wall && !a.inside_out());
    const double in_general = from.distance - shift.norm() - swing;
    return support ? std::max(in_general, from.distance + from.normal.dot(shift) - tilt) : in_general;
}

// Empty: further than they can go.
template <int D>
std::optional<Separation<D>> TouchSearch<D>::apart(const Pair& pair, double t) const
{
    const auto placed = [&](int s) {
        return extent_[s].moves ? PlacedShape<D>(solids_[s].shape.shape(), pose(s, t)) : solids_[s].shape;
    };
    const std::vector<ContactFeatures<D>>& features = state_.contacts.features();
    const double thickness = model_.scene.least_distance(solids_[pair.a].name, solids_[pair.b].name);
    return separation<D>(placed(pair.a), features[pair.a], placed(pair.b).shifted(pair.shift), features[pair.b],
                         thickness + reach_[pair.a] + reach_[pair.b]);
}

// When the distance first falls to a level; not before `end`: that.
template <int D>
double TouchSearch<D>::first_at(const Pair& pair, Separation<D> now, double level, double end) const
{
    double t = 0;
    while (now.distance > level + cushion * dx_) {
        double good = t, bad = end;
        for (int k = 1; k <= samples; ++k)
            if (const double next = std::min(dt_ * k / samples, end); next > good) {
                if (bad = next; least(pair, now, t, next) < level)
                    break;
                good = next;
            }
        if (good == end)
            return end;
        while (least(pair, now, t, good) > level + 0.5 * cushion * dx_) {
            const double middle = 0.5 * (good + bad);
            if (middle == good || middle == bad)
                break;
            (least(pair, now, t, middle) < level ? bad : good) = middle;
        }
        t = good;
        const auto found = apart(pair, t);
        if (!found)
            return end;
        now = *found;
    }
    return t;
}

// Whether the contact of a pair that has met can stop it.
template <int D>
bool TouchSearch<D>::stops(const Pair& pair, double t) const
{
    const auto found = apart(pair, t);
    if (!found)
        return true;
    const auto gives_way = [&](int s, const Vec<D>& shift) {
        return yields<D>(solids_[s], wrench<D>(found->normal, found->place - solids_[s].centre - shift));
    };
    return gives_way(pair.a, Vec<D>::Zero()) || gives_way(pair.b, pair.shift);
}

template <int D>
double TouchSearch<D>::limited() const
{
    if (reach_.empty())
        return dt_;
    const double fastest = *std::max_element(reach_.begin(), reach_.end());
    if (!(fastest > 0))
        return dt_;
    double thickest = std::max(model_.scene.contact.thickness, model_.scene.gap.roughness);
    for (const PairScene& pair : model_.scene.pairs)
        thickest = std::max({thickest, pair.contact.thickness, pair.gap.roughness});
    Vec<D> period = Vec<D>::Zero();
    for (int axis = 0; axis < D; ++axis)
        period[axis] = model_.grid.periodic(axis) ? model_.grid.size()[axis] : 0.0;
    const Vec<D> low = model_.grid.origin(), high = low + model_.grid.size();
    const double allowed = most_overlap * dx_;
    double end = dt_;
    for (const Pair& pair : near_pairs<D>(solids_, low, high, period, thickest + 2 * fastest)) {
        if (!(reach_[pair.a] + reach_[pair.b] > 0))
            continue;
        const std::optional<Separation<D>> now = apart(pair, 0);
        if (!now)
            continue;
        const Solid<D>&a = solids_[pair.a], &b = solids_[pair.b];
        const double met = model_.scene.least_distance(a.name, b.name), gap = now->distance - met;
        // Those that overlap from the start on count as one solid; others do not by what short steps add up to.
        const bool apart_at_start = gap > -allowed && !a.shape.shape().inside_out() && !b.shape.shape().inside_out();
        const double passed = first_at(pair, *now, met + std::min(gap, 0.0) - allowed, end),
                     driven = apart_at_start && gap < 0 ? first_at(pair, *now, met - allowed, end) : passed;
        if (apart_at_start && driven < end && !stops(pair, driven))
            throw driven_into_each_other(a.name, b.name, state_.time + driven);
        if (passed >= end || !stops(pair, passed))
            continue;
        end = first_at(pair, *now, met + std::min(gap - allowed, 0.0), passed);
    }
    return end;
}

} // namespace

ComputationError driven_into_each_other(const std::string& a, const std::string& b, double time)
{
    return ComputationError("prescribed motion drives '" + a + "' and '" + b + "' into each other at time " + short_text(time) +
                            "; let it stop before they touch, or let one of them be free");
}

template <int D>
double until_touch(const Model<D>& model, const State<D>& state, const std::vector<Solid<D>>& solids, double dt)
{
    return TouchSearch<D>(model, state, solids, dt).limited();
}

template double until_touch<2>(const Model<2>&, const State<2>&, const std::vector<Solid<2>>&, double);
template double until_touch<3>(const Model<3>&, const State<3>&, const std::vector<Solid<3>>&, double);

} // namespace gapflow
