#include "gapflow/stepping/following.hpp"

#include <algorithm>

namespace gapflow {

template <int D>
FollowedBody<D> followed_body(const Model<D>& model)
{
    FollowedBody<D> followed;
    if (!model.scene.follow)
        return followed;
    const auto found = std::find_if(model.bodies.begin(), model.bodies.end(),
                                    [&](const RigidBody<D>& body) { return body.name == model.scene.follow->body; });
    followed.body = static_cast<int>(found - model.bodies.begin());
    std::copy_n(model.scene.follow->axes.begin(), D, followed.axes.begin());
    return followed;
}

namespace {

// The components along the axes that the grid follows.
template <int D>
Vec<D> along_axes(const Model<D>& model, Vec<D> way)
{
    for (int axis = 0; axis < D; ++axis)
        way[axis] = model.scene.follow->axes[axis] ? way[axis] : 0.0;
    return way;
}

} // namespace

template <int D>
Vec<D> expected_grid_velocity(const Model<D>& model, const std::vector<RigidBody<D>>& bodies)
{
    if (!model.scene.follow)
        return Vec<D>::Zero();
    const RigidBody<D>& body = bodies[followed_body(model).body];
    return body.motion == Motion::fixed ? Vec<D>(Vec<D>::Zero()) : along_axes<D>(model, body.twist.template head<D>());
}

template <int D>
void follow(Model<D>& model, State<D>& state, const Step& step)
{
    if (!model.scene.follow)
        return;
    const int b = followed_body(model).body;
    const Vec<D> by = along_axes<D>(model, state.bodies[b].pose.position - model.bodies[b].pose.position);
    place_grid<D>(model, by, (by - state.grid_shift) / step.dt, state);
}

template <int D>
void place_grid(Model<D>& model, const Vec<D>& by, const Vec<D>& velocity, State<D>& state)
{
    model.grid.shift_to(by);
    model.grid_velocity = velocity;
    state.grid_shift = by;
    state.grid_velocity = velocity;
    state.contacts.move_domain(model.grid);
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template FollowedBody<D> followed_body<D>(const Model<D>&);                                                                \
    template Vec<D> expected_grid_velocity<D>(const Model<D>&, const std::vector<RigidBody<D>>&);                              \
    template void follow<D>(Model<D>&, State<D>&, const Step&);                                                                \
    template void place_grid<D>(Model<D>&, const Vec<D>&, const Vec<D>&, State<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
