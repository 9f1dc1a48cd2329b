// Films whose mouths conduct far less than they do within.
#pragma once

#include "gapflow/coupling/system.hpp"

#include <vector>

namespace gapflow {

/// Number of every film node's weak film, counted from 0 in the order of their first nodes; -1: its film is not weak. The level of such a film is nearly free.
template <int D>
std::vector<int> weak_films(const CoupledSystem<D>& system, int& count);

} // namespace gapflow
