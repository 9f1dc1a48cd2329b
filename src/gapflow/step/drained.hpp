// The viscous form beside voids.
#pragma once

#include "gapflow/step/placed.hpp"
#include "gapflow/viscous/form.hpp"

#include <map>
#include <vector>

namespace gapflow {

/// The form where streams fill a share of each face, and where walls that part or close drive no fluid through the faces of gaps beside voids: the rows of these have the
/// walls' velocities along the gap alone. `given`: rows of the system that are voids, as in FluidRows.
template <int D>
ViscousForm<D> drained_form(const Placed<D>& at, const ViscousForm<D>& form, const std::vector<double>& filled,
                            const std::map<long, double>& given);

} // namespace gapflow
