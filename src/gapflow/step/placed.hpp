// What follows from the places of the bodies: the complex of fluid parts, its derivatives, and the coupled system. Const once
// built, but for the contacts that hold the bodies in a step.
#pragma once

#include "gapflow/coupling/parts.hpp"
#include "gapflow/stepping/model.hpp"

#include <memory>
#include <vector>

namespace gapflow {

template <int D>
struct Placed {
    Complex<D> complex;
    FaceDerivatives<D> derivatives;
    std::vector<GapArm<D>> arms;
    std::vector<PairInertia<D>> pairs; ///< what gaps add to the masses of two solids
    std::vector<int> node;             ///< of each part, -1: none
    Coupling<D> coupling;              ///< with the masses of the bodies at these places
};

/// `mass`: of all solids. `observed`: also the fractions of the grid's faces, for measures and files. Collective.
template <int D>
std::unique_ptr<Placed<D>> placed(const Model<D>& model, const std::vector<RigidBody<D>>& bodies,
                                  const std::vector<TwistMatrix<D>>& mass, bool observed = true);

/// The same system where the twists of all solids are given: it has no bodies.
template <int D>
Coupling<D> with_given_twists(Coupling<D> coupling);

} // namespace gapflow
