#include "gapflow/stepping/leaving.hpp"

#include "gapflow/stepping/short_text.hpp"

#include <algorithm>
#include <limits>

namespace gapflow {

template <int D>
Bounds<D> extent_of(const RigidBody<D>& body, double tolerance)
{
    const Bounds<D> own = body.shape->bounds();
    Bounds<D> result;
    const Mat<D> rotation = body.pose.matrix();
    result.low.setConstant(std::numeric_limits<double>::infinity());
    result.high = -result.low;
    auto add = [&](const Vec<D>& x) {
        const Vec<D> place = body.pose.position + rotation * x;
        result.low = result.low.cwiseMin(place);
        result.high = result.high.cwiseMax(place);
    };
    if (tolerance > 0) {
        for (const Vec<D>& x : body.shape->display_mesh(tolerance).vertices)
            add(x);
        return result;
    }
    for (int corner = 0; corner < 1 << D; ++corner) {
        Vec<D> x;
        for (int axis = 0; axis < D; ++axis)
            x[axis] = corner >> axis & 1 ? own.high[axis] : own.low[axis];
        add(x);
    }
    return result;
}

namespace {

template <int D>
Whereabouts find(const Model<D>& model, const Bounds<D>& extent)
{
    const Scene& scene = model.scene;
    Whereabouts place;
    for (int side = 0; side < 2 * D; ++side) {
        const SideScene::Kind kind = scene.sides[side].kind;
        if (kind == SideScene::Kind::periodic)
            continue;
        const int axis = side / 2;
        const double low = model.grid.origin()[axis], high = low + scene.size[axis];
        const bool upper = side % 2;
        const bool through = upper ? extent.high[axis] > high : extent.low[axis] < low;
        if (kind == SideScene::Kind::surface) {
            place.floats = through;
            continue;
        }
        place.outside = place.outside || (upper ? extent.low[axis] > high : extent.high[axis] < low);
        if (kind != SideScene::Kind::wall && through)
            place.crossed.push_back(side);
    }
    return place;
}

// What a body needs that is to float at a side: only where the side could be a water level.
std::string remedy_of_float(const Scene& scene, int side)
{
    if (!scene.sides[side].is_open())
        return "";
    for (int axis = 0; axis < scene.dimension; ++axis)
        if (axis == side / 2 ? !(scene.gravity[axis] * (side % 2 ? 1 : -1) < 0) : scene.gravity[axis] != 0)
            return "";
    return "; a float has the buoyancy of its whole volume there, too: for a water level with air above write domain.sides." +
           side_names[side] + " = \"surface\"";
}

// A note that a body does something; of a crowd's bodies that do it the first alone has one.
void tell(const Scene& scene, int body, const std::string& does, const std::string& how, ToldOfCrowds& told,
          std::vector<std::string>& notes)
{
    const CrowdScene* crowd = scene.crowd_of(body);
    if (crowd && !told.insert(crowd->name + " " + does).second)
        return;
    notes.push_back("body '" + scene.bodies[static_cast<std::size_t>(body)].name + "' " + does + how +
                    (crowd ? " (the first of crowd '" + crowd->name + "'; its others are not named)" : ""));
}

} // namespace

template <int D>
std::vector<Whereabouts> whereabouts(const Model<D>& model, const std::vector<RigidBody<D>>& bodies)
{
    const double dx = model.scene.spacing();
    std::vector<Whereabouts> places(bodies.size());
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const RigidBody<D>& body = bodies[b];
        if (body.motion == Motion::fixed || body.shape->inside_out())
            continue;
        const Bounds<D> own = body.shape->bounds();
        if (!own.low.allFinite() || !own.high.allFinite())
            continue;
        places[b] = find<D>(model, extent_of(body, 0));
        if (places[b].outside || places[b].floats ||
            !places[b].crossed.empty()) // a body near a side is measured by its vertices
            places[b] = find<D>(model, extent_of(body, 0.1 * dx));
    }
    return places;
}

template <int D>
Departures departures(const Model<D>& model, const std::vector<RigidBody<D>>& bodies, const std::vector<Whereabouts>& before,
                      bool first, ToldOfCrowds& told)
{
    Departures result;
    const Scene& scene = model.scene;
    const std::vector<Whereabouts> now = whereabouts(model, bodies);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const int body = static_cast<int>(b);
        if (now[b].outside) {
            if (before[b].outside)
                continue;
            result.left.push_back(body);
            const bool goes = scene.leaving == Scene::Leaving::remove && bodies[b].motion == Motion::free;
            if (!goes)
                tell(scene, body, "has left the domain",
                     ": no flow acts on it there, only gravity and the pressure of fluid at rest", told, result.notes);
            continue;
        }
        for (int side : now[b].crossed) {
            const bool known = std::count(before[b].crossed.begin(), before[b].crossed.end(), side) > 0;
            const double outwards = (side % 2 ? 1 : -1) * bodies[b].twist[side / 2];
            if ((first || !known) && outwards > 0) {
                result.starting.push_back(body);
                tell(scene, body, std::string("is on its way out of the domain through the side ") + side_names[side],
                     ": beyond it no flow acts on it" + remedy_of_float(scene, side), told, result.notes);
            }
        }
    }
    return result;
}

template <int D>
void take_out(RigidBody<D>& body)
{
    body.motion = Motion::fixed;
    body.twist.setZero();
    body.angular_momentum.setZero();
    body.acceleration.setZero();
    body.angular_momentum_rate.setZero();
    body.force.setZero();
    body.torque.setZero();
    body.spring.reset();
    body.hinge.reset();
    body.water.reset();
}

template <int D>
std::vector<std::string> remove_bodies(const Model<D>& model, const std::vector<int>& left, State<D>& state, ToldOfCrowds& told)
{
    constexpr double far = 1e3; // in sizes of the domain: no gap and no contact reaches there
    std::vector<std::string> notes;
    const Vec<D> middle = model.grid.origin() + 0.5 * model.grid.size();
    const double size = model.grid.size().maxCoeff();
    for (const int b : left) {
        RigidBody<D>& body = state.bodies[b];
        if (body.motion != Motion::free)
            continue;
        take_out(body);
        Vec<D> away = body.pose.position - middle; // along axes that are not periodic
        for (int axis = 0; axis < D; ++axis)
            away[axis] = model.grid.periodic(axis) ? 0.0 : away[axis];
        body.pose.position += far * (b + 1) * size * away.normalized();
        state.acceleration[b].setZero();
        state.wrenches[b].setZero();
        if (model.viscous())
            state.pressure.force[b].setZero();
        state.removed.insert(b);
        tell(model.scene, b, "has left the domain", " at time " + short_text(state.time) + " and is taken out of the scene",
             told, notes);
    }
    return notes;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template Bounds<D> extent_of<D>(const RigidBody<D>&, double);                                                              \
    template std::vector<Whereabouts> whereabouts<D>(const Model<D>&, const std::vector<RigidBody<D>>&);                       \
    template Departures departures<D>(const Model<D>&, const std::vector<RigidBody<D>>&, const std::vector<Whereabouts>&,      \
                                      bool, ToldOfCrowds&);                                                                    \
    template void take_out<D>(RigidBody<D>&);                                                                                  \
    template std::vector<std::string> remove_bodies<D>(const Model<D>&, const std::vector<int>&, State<D>&, ToldOfCrowds&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
