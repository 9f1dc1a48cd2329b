// What is told of the fluid in gaps of the complex: meshes, and the pairs' states. Reads the instant, never changes it.
#pragma once

#include "gapflow/step/instant.hpp"
#include "gapflow/stepping/force_parts.hpp"
#include "gapflow/stepping/gap_meshes.hpp"
#include "gapflow/stepping/observation.hpp"

#include <vector>

namespace gapflow {

/// Parts in gaps: those at an arm whose energy is half or more that of a gap, of all ranks. Collective.
template <int D>
int count_gap_parts(const Placed<D>& at);

/// Half-way between the walls of gaps thinner than about a cell. Velocities follow from the fluxes through the faces of each part, pressures at nodes are the mean
/// of the parts that meet there, void depths likewise. The same on every rank. Collective.
template <int D>
GapMeshes<D> gap_meshes(const Model<D>& model, const Instant<D>& at, const State<D>& state);

/// Parts of the forces on every body, means over the step: `film` is the reduced pressure in gaps and the friction of those in closed form, `shear` that of all
/// other fluid, `pressure` what else the fluid does, without buoyancy. Collective.
template <int D>
std::vector<ForceParts<D>> split_forces(const Model<D>& model, const Instant<D>& now, const State<D>& state);

/// Adds gaps' parts to the states of pairs: their number, the area of the walls across them, the pressures and their force. Pairs come in the order of their
/// solids. Collective.
template <int D>
void add_gap_parts(const Model<D>& model, const Placed<D>& at, const State<D>& state, std::vector<GapState>& gaps);

} // namespace gapflow
