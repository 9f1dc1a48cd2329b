#include "gapflow/step/start_impact.hpp"

#include "gapflow/body/forces.hpp"
#include "gapflow/complex/parameters.hpp"
#include "gapflow/stepping/contact_rows.hpp"
#include "gapflow/stepping/start_flow.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace gapflow {
namespace {

constexpr double accuracy = 1e-12; // of it, of a rate
constexpr int most_sweeps = 10000;

/// Whether the surfaces at a contact touch in an area: further contacts of the two solids with its normal span one (2D: a length).
template <int D>
bool lies_flat(const Contact<D>& at, const std::vector<const Contact<D>*>& touching, double dx)
{
    std::vector<Vec<D>> ways;
    for (const Contact<D>* other : touching)
        if (other->point.a == at.point.a && other->point.b == at.point.b && other->point.shift == at.point.shift &&
            (other->point.normal - at.point.normal).norm() < parameters.parallel)
            ways.push_back(other->point.x - at.point.x);
    if constexpr (D == 2)
        return std::any_of(ways.begin(), ways.end(), [&](const Vec<2>& way) { return way.norm() > flat::patch * dx; });
    else {
        for (const Vec<3>& one : ways)
            for (const Vec<3>& other : ways)
                if (one.cross(other).norm() > 2 * flat::patch * flat::patch * dx * dx)
                    return true;
        return false;
    }
}

} // namespace

template <int D>
std::vector<std::string> stop_flat_closing(const Model<D>& model, State<D>& state)
{
    std::vector<Twist<D>> V = model.twists(state.bodies);
    double fastest = 0;
    for (const Twist<D>& twist : V)
        fastest = std::max(fastest, twist.norm());
    if (fastest == 0)
        return {};
    const std::vector<Solid<D>> solids = model.solids(state.bodies);
    const double dx = model.grid.dx();
    ContactSet<D> near = state.contacts;
    near.find(solids, V, 0);
    std::vector<const Contact<D>*> touching, flat;
    for (const Contact<D>& c : near.contacts())
        if (c.point.distance <= c.hold + std::max(1e-3 * c.hold, flat::flush * dx))
            touching.push_back(&c);
    std::copy_if(touching.begin(), touching.end(), std::back_inserter(flat),
                 [&](const Contact<D>* c) { return lies_flat(*c, touching, dx); });

    std::vector<std::string> notes;
    for (const Contact<D>* c : flat)
        if (c->restitution > 0 && rate(c->normal, *c, V) < -flat::same * fastest) {
            notes.push_back(
                "'" + solids[c->point.a].name + "' and '" + solids[c->point.b].name +
                "' lie flat on each other and approach at the start: the fluid between them stops that, and they do "
                "not rebound; place them apart");
            break;
        }
    // Projected Gauss-Seidel: impulses that push.
    struct Push {
        std::array<Twist<D>, 2> response;
        double mobility = 0, impulse = 0;
    };
    std::vector<Push> pushes;
    const auto is_free = [&](int s) {
        return s < static_cast<int>(state.bodies.size()) && state.bodies[s].motion == Motion::free;
    };
    for (const Contact<D>* c : flat) {
        Push& push = pushes.emplace_back();
        const auto response = [&](int s, const Twist<D>& row) {
            return is_free(s) ? impulse_response(state.bodies[s], row, 0.0) : Twist<D>(Twist<D>::Zero());
        };
        push.response = {response(c->point.a, c->normal.a), response(c->point.b, c->normal.b)};
        push.mobility = c->normal.a.dot(push.response[0]) + c->normal.b.dot(push.response[1]);
    }
    bool any = false;
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
        double largest = 0;
        for (std::size_t k = 0; k < flat.size(); ++k) {
            const Contact<D>& c = *flat[k];
            Push& push = pushes[k];
            if (!(push.mobility > 0))
                continue;
            const double impulse = std::max(push.impulse - rate(c.normal, c, V) / push.mobility, 0.0),
                         change = impulse - push.impulse;
            push.impulse = impulse;
            V[c.point.a] += change * push.response[0];
            V[c.point.b] += change * push.response[1];
            largest = std::max(largest, std::abs(change) * push.mobility);
        }
        any = any || largest > flat::same * fastest;
        if (largest <= accuracy * fastest)
            break;
    }
    if (!any)
        return {};
    for (std::size_t b = 0; b < state.bodies.size(); ++b)
        if (state.bodies[b].motion == Motion::free)
            set_initial_twist<D>(state.bodies[b], V[b].norm() < flat::same * fastest ? Twist<D>(Twist<D>::Zero()) : V[b]);
    return notes;
}

template std::vector<std::string> stop_flat_closing<2>(const Model<2>&, State<2>&);
template std::vector<std::string> stop_flat_closing<3>(const Model<3>&, State<3>&);

} // namespace gapflow
