// A grid that moves with a body (method, "A grid that follows a body").
#pragma once

#include "gapflow/stepping/state.hpp"
#include "gapflow/stepping/step.hpp"

#include <array>

namespace gapflow {

/// The body with which the grid goes.
template <int D>
struct FollowedBody {
    int body = -1;              ///< -1: none, the grid stays
    std::array<bool, D> axes{}; ///< along which it goes
};
template <int D>
FollowedBody<D> followed_body(const Model<D>& model);

/// Velocity of the grid if it went with its body as that moves now; 0 of a grid that stays.
template <int D>
Vec<D> expected_grid_velocity(const Model<D>& model, const std::vector<RigidBody<D>>& bodies);

/// Moves the grid so that its body lies in it as at the scene's start. Nothing happens to a grid that stays.
template <int D>
void follow(Model<D>& model, State<D>& state, const Step& step);

/// Puts the grid where `by` from its place at the scene's start; `velocity`: with which it came there in the last step.
template <int D>
void place_grid(Model<D>& model, const Vec<D>& by, const Vec<D>& velocity, State<D>& state);

} // namespace gapflow
