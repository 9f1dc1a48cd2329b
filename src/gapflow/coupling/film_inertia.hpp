// What the fluid between two bodies adds to their inertia: the films' part of K^T L^-1 K, with the bulk's pressure as it is. Films
// answer at once and strongly (flat faces a hundredth of their length apart resist ten times their bodies' mass); the bulk's answer
// is of the order of the fluid's own mass.
#pragma once

#include "gapflow/coupling/coupling.hpp"

#include <vector>

namespace gapflow {

template <int D>
using PairMatrix = Eigen::Matrix<double, 2 * twist_size<D>, 2 * twist_size<D>>;

/// A change of the twists of two solids costs the impulses -matrix (change of V_a, change of V_b): pressure, inertia across the film
/// and drag. Symmetric, positive semidefinite.
template <int D>
struct FilmInertia {
    int a, b; ///< solids
    PairMatrix<D> matrix;
};

/// The free bodies' inertia, nearly: mobilities of every solid by itself (0: does not yield) and the films between them.
template <int D>
struct NearInertia {
    std::vector<TwistMatrix<D>> mobility;
    std::vector<FilmInertia<D>> films; ///< at most one of a pair of solids
};

/// `mass` of every solid: its own with some of the bulk's. Void nodes do not count. Reads the system as it is without voids.
template <int D>
NearInertia<D> near_inertia(const Coupling<D>& coupling, const std::vector<TwistMatrix<D>>& mass,
                            const std::vector<char>& is_void);

} // namespace gapflow
