// Masses in the axes in which the fluid that a solid displaces has the mass one.
#pragma once

#include "gapflow/geometry/solid.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace gapflow {

/// Inertia of the fluid that a solid displaces.
template <int D>
TwistMatrix<D> displaced_mass(const Solid<D>& solid, double density);

/// A symmetric matrix in the axes in which G = R R^T is the identity.
template <int D>
struct ScaledModes {
    Eigen::LLT<TwistMatrix<D>> root;
    Eigen::SelfAdjointEigenSolver<TwistMatrix<D>> modes;

    ScaledModes(const TwistMatrix<D>& A, const TwistMatrix<D>& G);
    /// A without its negative part.
    TwistMatrix<D> positive_part(const TwistMatrix<D>& A) const;
    /// Derivative of the positive part by the matrix: divided differences of max(0, x).
    double slope(int i, int j) const;
};

} // namespace gapflow
