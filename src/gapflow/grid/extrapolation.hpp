// Extrapolation of face velocities from the fluid into solids and film cells.
#pragma once

#include "gapflow/grid/field.hpp"

#include <cstdint>

namespace gapflow {

/// Extrapolates u from its valid faces into the others, `layers` faces deep, component by component; faces out of reach get 0.
/// The first layer is linear where two valid faces lie in line beyond it (averaged over the directions that have them),
/// otherwise, and in further layers, the mean of the neighbours of earlier layers. Faces beyond the domain are not used.
///
/// Only owned entries of `valid` (nonzero: valid) and of u on valid faces are read. On return `valid` is 1 on faces that were
/// valid, 1 + k on those of layer k, 0 out of reach and beyond the domain; ghosts of u and valid that other ranks own are
/// filled. Needs ghost() >= 2 and layers <= 126. The same bits on any number of ranks. Collective.
template <int D>
void extrapolate(const Grid<D>& grid, FaceField<D>& u, FaceField<D, std::int8_t>& valid, int layers);

} // namespace gapflow
