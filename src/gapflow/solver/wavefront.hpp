// The two legs of a V-cycle on one level, all their sweeps in one pass over memory where the level is not shared out.
#pragma once

#include "gapflow/solver/level.hpp"

namespace gapflow {

/// fine.x = two red-black sweeps from 0; coarse.b = the restricted residual. Ghosts of fine.x are up to date on return.
template <int D>
void descend(Level<D>& fine, Level<D>& coarse);

/// fine.x += coarse.x, then two black-red sweeps: the transpose of descend's. Ghosts of fine.x are up to date on return.
template <int D>
void ascend(const Level<D>& coarse, Level<D>& fine);

} // namespace gapflow
