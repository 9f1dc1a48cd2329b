// Fields of a simulation at cell centres, for files.
#pragma once

#include "gapflow/output/vtk.hpp"
#include "gapflow/step/simulation.hpp"

#include <string>

namespace gapflow {

/// One of output.fields, or "kind" (0 solid, 1 bulk, 2 film, 3 mixed), of this rank's cells. All but velocity and kind are 0 in cells without a
/// pressure of their own. Collective.
///
///     velocity    mean of the two faces
///     pressure    full
///     vorticity   2D: one number
///     divergence  what leaves a cell over its volume, through faces, surfaces and mouths: what the solver's tolerance leaves
///     q           1/2 (|W|^2 - |S|^2), W and S the skew and the symmetric part of grad u: positive in vortices
template <int D>
VtkArray field_array(const Simulation<D>& simulation, const std::string& name);

} // namespace gapflow
