// Added inertia of two bodies by the film between them: the films' part of K^T L^-1 K, with the bulk's pressure fixed. This part is
// large (for flat faces a hundredth of their length apart ten times the bodies' mass); the bulk's part is of the order of the mass
// of the displaced fluid.
#pragma once

#include "gapflow/coupling/coupling.hpp"

#include <vector>

namespace gapflow {

template <int D>
using PairMatrix = Eigen::Matrix<double, 2 * twist_size<D>, 2 * twist_size<D>>;

/// A change of the twists of two solids causes the impulses -matrix (change of V_a, change of V_b): pressure, inertia across the film
/// and drag. Symmetric, positive semidefinite.
template <int D>
struct FilmInertia {
    int a, b; ///< solids
    PairMatrix<D> matrix;
};

/// The free bodies' approximate inertia: mobilities of every solid by itself (0: cannot move) and the films between them.
template <int D>
struct NearInertia {
    std::vector<TwistMatrix<D>> mobility;
    std::vector<FilmInertia<D>> films; ///< at most one for each pair of solids
};

/// `mass` of every solid: its own with a part of the bulk's added mass. Void nodes do not count. Collective. Reads the system as it is without voids.
template <int D>
NearInertia<D> near_inertia(const Coupling<D>& coupling, const std::vector<TwistMatrix<D>>& mass,
                            const std::vector<char>& is_void);

} // namespace gapflow
