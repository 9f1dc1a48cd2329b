// Constraints of a body as one thing: the subspace of twists that it can have at its present pose.
//
//     free components   B = columns of the identity
//     hinge at p        B = (a x (c - p), a) / norm,   a the axis
//
// With M the mass matrix, an impulse i changes the twist by B (B^T M B)^-1 B^T i; reactions do no work, they lie in the
// complement of B.
#pragma once

#include "gapflow/body/rigid_body.hpp"

namespace gapflow {

/// Orthonormal columns, as many as the body has admissible directions.
template <int D>
using TwistBasis = Eigen::Matrix<double, twist_size<D>, Eigen::Dynamic>;

/// Whether some twist is not admissible.
template <int D>
bool constrained(const RigidBody<D>& body);

/// Basis of the admissible twists about the centre of mass, world axes, at the present pose.
template <int D>
TwistBasis<D> admissible_twists(const RigidBody<D>& body);

/// B B^T; the identity for a body without constraint.
template <int D>
TwistMatrix<D> admissible_projector(const RigidBody<D>& body);

/// B (B^T M B)^-1 B^T impulse.
template <int D>
Twist<D> admissible_response(const TwistBasis<D>& basis, const TwistMatrix<D>& mass, const Twist<D>& impulse);

} // namespace gapflow
