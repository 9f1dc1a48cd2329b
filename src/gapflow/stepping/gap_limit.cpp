#include "gapflow/stepping/gap_limit.hpp"

#include "gapflow/body/forces.hpp"
#include "gapflow/core/error.hpp"
#include "gapflow/core/sharing.hpp"
#include "gapflow/core/threads.hpp"
#include "gapflow/stepping/contact_rows.hpp"
#include "gapflow/stepping/film_reversal.hpp"
#include "gapflow/stepping/touch_limit.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {

namespace {

// A film that takes at most this share of its bodies' relative velocity in a step by its inertia does not limit the step by its gap: what the
// implicit step misses of the exact impulse is half of this share's square.
constexpr double small_share = 0.05;
// The same by drag as well, which misses little where it alone acts (steepened()), between bodies that do not rebound: what speed they have when they
// meet is lost. (Of steel spheres that bounce at St 27 it is 8 % of what is left.)
constexpr double small_share_of_drag = 0.3;
// More, up to most_share, where the relative velocity that the step misses by it is at most this part of the flow's largest speed: in a bed a thousand
// pairs lie on each other and roll and part slowly. Steps of 1000 balls that gather to a bed are half as long otherwise.
constexpr double slight_speed = 0.005;
constexpr double most_share = 1;
// The same of both where they meet on the way and rebound, with the speed from before it.
constexpr double small_share_of_rebound = 0.005;
// Where a gap changes by less than this part of itself in a step, drag's value at the end is as good as any.
constexpr double slight_change = 0.0025;
// The search for a step stops within this factor.
constexpr double closeness = 1.1;
// Bodies that cannot give way and have met: with steps below this times time.max_step the run would not end.
constexpr double driven_step = 1e-3;
constexpr double tiny = std::numeric_limits<double>::min();
constexpr double infinite = std::numeric_limits<double>::infinity();

// Velocity of a point of the master against the one of the other solid that it faces, at the given twists (or accelerations).
template <int D>
Vec<D> relative_velocity(const Coupling<D>& here, const FilmMesh<D>& mesh, const Twist<D>& master, const Twist<D>& other,
                         const Vec<D>& on_master, const Vec<D>& on_other)
{
    return velocity_at<D>(master, on_master - here.solids[mesh.master].centre) -
           velocity_at<D>(other, on_other - here.solids[mesh.other].centre - mesh.shift);
}

// Opening rate of two points that face each other at the given twists (or accelerations) of the solids.
template <int D>
double opening(const Coupling<D>& here, const FilmMesh<D>& mesh, const std::vector<Twist<D>>& twist, const Vec<D>& out_of_other,
               const Vec<D>& on_master, const Vec<D>& on_other)
{
    return out_of_other.dot(relative_velocity(here, mesh, twist[mesh.master], twist[mesh.other], on_master, on_other));
}

// When a distance that opens with rate v and acceleration a has fallen by `left`.
double time_of_closing(double left, double v, double a)
{
    const double root = v * v - 2 * a * left;
    if (left <= 0)
        return v < 0 || (v == 0 && a < 0) ? 0.0 : infinite;
    if (root < 0)
        return infinite;
    const double t = 2 * left / (-v + std::sqrt(root)); // the first root of left + v t + a t^2 / 2
    return -v + std::sqrt(root) > 0 ? t : infinite;
}

} // namespace

template <int D>
GapLimit<D>::GapLimit(const Model<D>& model, const State<D>& state, const Coupling<D>& here, const std::vector<Twist<D>>& V,
                      const std::vector<Twist<D>>& A, double flow_speed)
    : model_(model), state_(state), here_(here), V_(V), A_(A), flow_speed_(flow_speed), links_(links_of_films(here))
{
    for (std::size_t f = 0; f < here.network.films.size(); ++f)
        add(static_cast<int>(f), here.network.films[f]);
}

template <int D>
void GapLimit<D>::add(int number, const Film<D>& film)
{
    const Scene& scene = model_.scene;
    const double dx = model_.grid.dx(), floor = model_.gaps(film.pair.master, film.pair.other).floor;
    const FilmMesh<D>& mesh = film.mesh;
    const Solid<D>&master = here_.solids[mesh.master], &other = here_.solids[mesh.other];
    const double thickness = scene.contact_of(master.name, other.name).thickness;
    const double least = std::max({thickness, floor, smallest_limiting_gap * dx});
    // Neither can give way: they have met where the film is still rough.
    const double met = std::max(scene.least_distance(master.name, other.name), smallest_limiting_gap * dx);
    const bool unstoppable = master.motion != Motion::free && other.motion != Motion::free;
    double dt = infinite;
    for (const FilmPoint<D>& q : mesh.points) {
        auto rate = [&](const std::vector<Twist<D>>& twist) {
            return std::abs(opening(here_, mesh, twist, q.other_normal, q.x, q.y));
        };
        const double distance = q.h + mesh.skin, h = std::max(distance, least);
        if (unstoppable && q.other_normal.dot(q.x - q.y) < met &&
            scene.gap_cfl * met < driven_step * scene.max_step * -opening(here_, mesh, V_, q.other_normal, q.x, q.y))
            throw driven_into_each_other(master.name, other.name, state_.time);
        // The distance remaining to the contact thickness limits the step too.
        const double left = thickness > 0 ? std::max(distance - thickness, smallest_limiting_gap * dx) : h;
        dt = std::min(dt, scene.gap_cfl * std::min(h, left) / std::max(rate(V_), tiny));
        dt = std::min(dt, std::sqrt(2 * scene.gap_cfl * h / std::max(rate(A_), tiny)));
    }
    Pair& pair = pairs_[film.pair];
    pair.here = film.here;
    pair.films.push_back(number);
    pair.by_part = std::min(pair.by_part, dt);
    // Not with dry gaps; nor with bodies whose motion is given: there the film's force is what is asked for; nor without a floor, where the
    // inertia of a film that opens from contact begins without bound (random scene 112 of the contact cases).
    pair.has_mean = pair.has_mean && mesh.skin == 0 && !state_.voids.any() && mesh.master != mesh.other && !unstoppable &&
                    floor >= smallest_limiting_gap * dx;
    pair.any_factor = scene.long_ways && pair.has_mean;
}

template <int D>
typename GapLimit<D>::Way GapLimit<D>::way_ahead(const FilmPair<D>& pair, const Pair& films, double dt) const
{
    const double dx = model_.grid.dx(), floor = model_.gaps(pair.master, pair.other).floor;
    const std::string &a = here_.solids[pair.master].name, &b = here_.solids[pair.other].name;
    const double hold = std::max(floor, model_.scene.held_distance(a, b));
    Way way;
    double meeting = infinite;
    for (const int f : films.films) {
        const FilmMesh<D>& mesh = here_.network.films[f].mesh;
        for (const FilmPoint<D>& q : mesh.points) {
            const double v = opening(here_, mesh, V_, q.other_normal, q.x, q.y);
            const double speeding = opening(here_, mesh, A_, q.other_normal, q.x, q.y);
            if (q.h + dt * (v + 0.5 * dt * speeding) < hold - most_overlap * dx) { // not moved apart in one pass
                way.passes = true;
                return way;
            }
            meeting = std::min(meeting, time_of_closing(q.h - hold, v, speeding));
        }
    }
    // A contact may hold its bodies from the step before they meet on. Those that rebound then do not go the rest of the way.
    way.elastic = model_.scene.contact_of(a, b).restitution > 0;
    way.rebound = way.elastic && meeting < 2 * dt;
    const double moving = way.rebound ? meeting : std::min(dt, meeting);
    way.W = {V_[pair.master] + 0.5 * moving * A_[pair.master], V_[pair.other] + 0.5 * moving * A_[pair.other]};
    way.films = {{}, model_.scene.viscosity * moving, floor};
    for (const int f : films.films) {
        const FilmMesh<D>& mesh = here_.network.films[f].mesh;
        std::vector<double>& opened = way.films.opened.emplace_back();
        for (const FilmElement<D>& e : mesh.elements) {
            const auto rate = [&](const std::vector<Twist<D>>& twist) {
                return opening<D>(here_, mesh, twist, -e.into_other, e.centroid_master, e.place_on_other);
            };
            opened.push_back(moving * (rate(V_) + 0.5 * moving * rate(A_)));
        }
    }
    return way;
}

// What films take of their bodies' velocities on the way W by the impulses F.
template <int D>
typename GapLimit<D>::Taken GapLimit<D>::taken(const FilmPair<D>& pair, const Way& way, const std::array<Twist<D>, 2>& impulses,
                                               double dt) const
{
    double power = 0, square = 0;
    std::array<Twist<D>, 2> change{Twist<D>::Zero(), Twist<D>::Zero()};
    for (const int side : {0, 1}) {
        const int solid = side == 0 ? pair.master : pair.other;
        const Twist<D>& impulse = impulses[side];
        power += way.W[side].dot(impulse);
        if (here_.free_body[solid] < 0)
            continue;
        change[side] = impulse_response(state_.bodies[solid], impulse, dt);
        square += impulse.dot(change[side]);
    }
    return {square <= 0 ? 0.0 : power > 0 ? square / power : infinite, change};
}

// The largest change of the velocity between two surface points that face each other.
template <int D>
double GapLimit<D>::largest_change(const Pair& films, const std::array<Twist<D>, 2>& change) const
{
    double largest = 0;
    for (const int f : films.films) {
        const FilmMesh<D>& mesh = here_.network.films[f].mesh;
        for (const FilmPoint<D>& q : mesh.points)
            largest = std::max(largest, relative_velocity(here_, mesh, change[0], change[1], q.x, q.y).norm());
    }
    return largest;
}

// Whether the films of a pair take a small share of the relative velocity in a step, and the surfaces do not pass each other too far.
template <int D>
bool GapLimit<D>::admits(const FilmPair<D>& pair, const Pair& films, double dt) const
{
    const Way way = way_ahead(pair, films, dt);
    if (way.passes)
        return false;
    const auto impulses = impulses_on_way<D>(here_, films.films, links_, way.films, way.W);
    if (!impulses)
        return false;
    const Taken all = taken(pair, way, impulses->all, dt);
    if (way.rebound)
        return all.share <= small_share_of_rebound;
    if (taken(pair, way, impulses->inertia, dt).share > small_share)
        return false;
    if (all.share <= (way.elastic ? small_share : small_share_of_drag))
        return true;
    return !way.elastic && all.share <= most_share &&
           0.5 * all.share * largest_change(films, all.change) <= slight_speed * flow_speed_;
}

// The largest step up to dt that is admitted, by bisection.
template <int D>
double GapLimit<D>::limited_by(const FilmPair<D>& pair, const Pair& films, double dt) const
{
    double good = films.by_part, bad = dt;
    if (admits(pair, films, dt))
        return dt;
    while (bad > closeness * good) {
        const double middle = std::sqrt(good * bad);
        (admits(pair, films, middle) ? good : bad) = middle;
    }
    return good;
}

// Pairs that ask for the smallest steps come first: their limit spares the others the search.
template <int D>
double GapLimit<D>::limited(double dt) const
{
    std::vector<const std::pair<const FilmPair<D>, Pair>*> limiting;
    for (const auto& entry : pairs_)
        if (entry.second.by_part < dt)
            limiting.push_back(&entry);
    std::stable_sort(limiting.begin(), limiting.end(),
                     [](const auto* a, const auto* b) { return a->second.by_part < b->second.by_part; });
    for (const auto* entry : limiting) {
        const auto& [pair, films] = *entry;
        if (films.by_part >= dt)
            break;
        if (!films.any_factor) {
            dt = films.by_part;
            continue;
        }
        dt = model_.grid.comm().min(films.here ? limited_by(pair, films, dt) : dt);
    }
    return dt;
}

// The share of drag is that of all films of the two bodies: F M^-1 (sum of F) / (W.F).
template <int D>
GapWays<D> GapLimit<D>::ways(double dt) const
{
    GapWays<D> ways;
    if (!model_.viscous())
        return ways;
    struct Drag {
        const std::pair<const FilmPair<D>, Pair>* of;
        std::array<Twist<D>, 2> W{Twist<D>::Zero(), Twist<D>::Zero()}, impulse = W;
    };
    std::vector<Drag> drags;
    for (const auto& entry : pairs_) {
        const double change = dt / entry.second.by_part;
        if (!entry.second.has_mean || change * model_.scene.gap_cfl < slight_change)
            continue;
        ways.pairs[entry.first].change = change;
        drags.push_back({&entry});
    }
    for_each_job(static_cast<int>(drags.size()), [&](int k) {
        const auto& [pair, films] = *drags[k].of;
        if (!films.here)
            return;
        const Way way = way_ahead(pair, films, dt);
        if (way.passes) // and has turned round by the end of a longer step: the mean alone
            return;
        drags[k].W = way.W;
        if (const auto found = impulses_on_way<D>(here_, films.films, links_, way.films, way.W))
            drags[k].impulse = {found->all[0] - found->inertia[0], found->all[1] - found->inertia[1]};
    });
    exchange_items(
        model_.grid.comm(), drags.size(), [&](std::size_t k) { return drags[k].of->second.here; },
        [&](ByteWriter& out, std::size_t k) { out(drags[k].W, drags[k].impulse); },
        [&](ByteReader& in, std::size_t k) { in(drags[k].W, drags[k].impulse); });
    std::vector<Twist<D>> change(state_.bodies.size(), Twist<D>::Zero());
    const auto each_body = [&](const Drag& drag, auto&& take) {
        for (const int side : {0, 1})
            if (const int solid = side == 0 ? drag.of->first.master : drag.of->first.other; here_.free_body[solid] >= 0)
                take(solid, drag.impulse[side]);
    };
    for (const Drag& drag : drags)
        each_body(drag, [&](int b, const Twist<D>& impulse) { change[b] += impulse_response(state_.bodies[b], impulse, dt); });
    for (const Drag& drag : drags) {
        const double power = drag.W[0].dot(drag.impulse[0]) + drag.W[1].dot(drag.impulse[1]);
        double square = 0;
        each_body(drag, [&](int b, const Twist<D>& impulse) { square += impulse.dot(change[b]); });
        if (power > 0)
            ways.pairs[drag.of->first].share = square / power;
    }
    if (!ways.pairs.empty())
        for (const RigidBody<D>& body : state_.bodies)
            ways.from.push_back(body.pose);
    return ways;
}

template <int D>
GapChanges gap_changes(const Model<D>& model, const Coupling<D>& there, const State<D>& state)
{
    const GapWays<D>& ways = state.gap_ways;
    if (ways.pairs.empty())
        return {};
    const auto shift_of = [&](int solid, const Vec<D>& x) {
        if (solid >= static_cast<int>(ways.from.size()))
            return Vec<D>(Vec<D>::Zero());
        const Pose<D>& from = ways.from[solid];
        return Vec<D>(x - from.position - from.matrix() * there.solids[solid].shape.to_body(x));
    };
    GapChanges changes{
        std::vector<double>(there.network.elements, 0.0), std::vector<double>(there.network.rim.mouths.size(), 0.0), {}};
    for (const Film<D>& film : there.network.films) {
        const auto way = ways.pairs.find(film.pair);
        DragParts& parts = changes.drag.emplace_back();
        if (way == ways.pairs.end())
            continue;
        const FilmMesh<D>& mesh = film.mesh;
        const double floor = model.gaps(mesh.master, mesh.other).floor;
        double least = infinite, least_opened = 0; // of the film
        for (std::size_t k = 0; k < mesh.elements.size(); ++k) {
            const FilmElement<D>& e = mesh.elements[k];
            double thinnest = infinite;
            for (const int node : e.nodes)
                thinnest = std::min(thinnest, mesh.h[node]);
            const double opened = -e.into_other.dot(shift_of(mesh.master, e.centroid_master) -
                                                    shift_of(mesh.other, Vec<D>(e.place_on_other - mesh.shift)));
            double& change = changes.elements[film.first_element + k];
            change = std::min(opened, std::max(thinnest - floor, 0.0));
            if (thinnest < least) {
                least = thinnest;
                least_opened = change;
            }
        }
        parts = drag_parts(way->second.share, way->second.change, least, least_opened);
    }
    for (std::size_t r = 0; r < changes.mouths.size(); ++r) {
        const Mouth<D>& mouth = there.network.rim.mouths[r];
        changes.mouths[r] = changes.elements[there.network.films[mouth.film].first_element + mouth.element];
    }
    return changes;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template class GapLimit<D>;                                                                                                \
    template GapChanges gap_changes<D>(const Model<D>&, const Coupling<D>&, const State<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
