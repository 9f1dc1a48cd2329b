// Bodies that leave the domain: notes for the user, and taking them out.
#pragma once

#include "gapflow/stepping/state.hpp"

#include <set>
#include <string>
#include <vector>

namespace gapflow {

/// The box that holds a body in the world: that of its bounds in its own frame, or with a tolerance of its surface so finely drawn.
template <int D>
Bounds<D> extent_of(const RigidBody<D>& body, double tolerance);

/// Position of a body relative to the domain.
struct Whereabouts {
    bool outside = false;     ///< wholly beyond a side that is not periodic; above a water level nothing is outside
    std::vector<int> crossed; ///< open and inflow sides beyond which a part of it lies: 2 * axis + end
    bool floats = false;      ///< a part of it lies above a water level
};

/// Of every body; fixed ones, containers and bodies without bounds count as inside.
template <int D>
std::vector<Whereabouts> whereabouts(const Model<D>& model, const std::vector<RigidBody<D>>& bodies);

/// What has been told of crowds: of all bodies of a crowd that do the same the first alone is named.
using ToldOfCrowds = std::set<std::string>;

/// What has happened in a step.
struct Departures {
    std::vector<std::string> notes;
    std::vector<int> starting, left; ///< bodies that came to be on their way out, and those that came to be wholly outside
};

/// Of bodies that were at `before` when a step began: one that moves out through an open or inflow side is on its way out once it reaches
/// through; one that is wholly outside and was not has left. `first`: of the first step, when bodies that reach through already count.
template <int D>
Departures departures(const Model<D>& model, const std::vector<RigidBody<D>>& bodies, const std::vector<Whereabouts>& before,
                      bool first, ToldOfCrowds& told);

/// Holds a body still and nothing acts on it from then on. For one that lies far outside the domain.
template <int D>
void take_out(RigidBody<D>& body);

/// Takes free bodies that are wholly outside out of the state: they are put far away, each to a place of its own, and held there. They have
/// no part in the flow any more, so that nothing else changes. Returns notes.
template <int D>
std::vector<std::string> remove_bodies(const Model<D>& model, const std::vector<int>& left, State<D>& state,
                                       ToldOfCrowds& told);

} // namespace gapflow
