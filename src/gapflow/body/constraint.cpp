#include "gapflow/body/constraint.hpp"

#include "gapflow/core/decompositions.hpp"

#include <algorithm>

namespace gapflow {

template <int D>
bool constrained(const RigidBody<D>& body)
{
    return body.hinge || std::find(body.can_move.begin(), body.can_move.end(), false) != body.can_move.end();
}

template <int D>
TwistBasis<D> admissible_twists(const RigidBody<D>& body)
{
    if (body.hinge)
        return hinged_twist(body, 1.0).normalized();
    TwistBasis<D> basis(twist_size<D>, std::count(body.can_move.begin(), body.can_move.end(), true));
    for (int k = 0, column = 0; k < twist_size<D>; ++k)
        if (body.can_move[k])
            basis.col(column++) = Twist<D>::Unit(k);
    return basis;
}

template <int D>
TwistMatrix<D> admissible_projector(const RigidBody<D>& body)
{
    const TwistBasis<D> basis = admissible_twists(body);
    return basis * basis.transpose();
}

template <int D>
Twist<D> admissible_response(const TwistBasis<D>& basis, const TwistMatrix<D>& mass, const Twist<D>& impulse)
{
    const Eigen::MatrixXd inner = basis.transpose() * mass * basis;
    const Eigen::VectorXd along = basis.transpose() * impulse;
    return basis * semidefinite_solution(inner, along);
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template bool constrained<D>(const RigidBody<D>&);                                                                         \
    template TwistBasis<D> admissible_twists<D>(const RigidBody<D>&);                                                          \
    template TwistMatrix<D> admissible_projector<D>(const RigidBody<D>&);                                                      \
    template Twist<D> admissible_response<D>(const TwistBasis<D>&, const TwistMatrix<D>&, const Twist<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
