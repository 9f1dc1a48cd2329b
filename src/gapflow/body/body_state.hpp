// State of a rigid body from step to step.
#pragma once

#include "gapflow/body/rigid_body.hpp"
#include "gapflow/core/state_archive.hpp"

namespace gapflow {

template <int D>
void list_pose(StateArchive& archive, Pose<D>& pose)
{
    archive("position", pose.position);
    if constexpr (D == 2)
        archive("angle", pose.rotation.angle());
    else
        archive("quaternion", pose.rotation.coeffs());
}

/// Mass and volume come from the scene and must be what they were.
template <int D>
void list_state(StateArchive& archive, RigidBody<D>& body)
{
    archive.expect("mass", body.mass);
    archive.expect("volume", body.volume);
    list_pose(archive, body.pose);
    archive("twist", body.twist);
    archive("angular_momentum", body.angular_momentum);
    archive("acceleration", body.acceleration);
    archive("angular_momentum_rate", body.angular_momentum_rate);
    archive("force", body.force);
    archive("torque", body.torque);
    bool steered = body.steered.has_value();
    archive("steered", steered);
    if (!steered)
        return;
    archive.group("steered_motion", [&] {
        SteeredMotion<D> motion = body.steered.value_or(SteeredMotion<D>{});
        archive("since", motion.since);
        list_pose(archive, motion.start);
        archive("velocity", motion.velocity);
        archive("angular_velocity", motion.angular_velocity);
        if (archive.restoring())
            steer<D>(body, motion);
    });
}

} // namespace gapflow
