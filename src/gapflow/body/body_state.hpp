// What a rigid body carries from step to step.
#pragma once

#include "gapflow/body/rigid_body.hpp"
#include "gapflow/core/state_archive.hpp"

namespace gapflow {

/// Mass and volume come from the scene and must be what they were.
template <int D>
void list_state(StateArchive& archive, RigidBody<D>& body)
{
    archive.expect("mass", body.mass);
    archive.expect("volume", body.volume);
    archive("position", body.pose.position);
    if constexpr (D == 2)
        archive("angle", body.pose.rotation.angle());
    else
        archive("quaternion", body.pose.rotation.coeffs());
    archive("twist", body.twist);
    archive("angular_momentum", body.angular_momentum);
    archive("acceleration", body.acceleration);
    archive("angular_momentum_rate", body.angular_momentum_rate);
}

} // namespace gapflow
