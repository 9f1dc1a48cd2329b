// Shapes and poses of a scene's bodies.
#pragma once

#include "gapflow/geometry/pose.hpp"
#include "gapflow/scene/scene.hpp"

#include <memory>

namespace gapflow {

/// The first D numbers of a scene's vector.
template <int D>
Vec<D> to_vec(const Triple& t)
{
    return Eigen::Map<const Vec<D>>(t.data());
}

/// The body's shape, turned inside out where the scene says so. Throws InputError for mesh files that cannot be read or are not
/// closed, SheetError for sheets of which no solid can be made.
template <int D>
std::unique_ptr<Shape<D>> make_shape(const BodyScene& body);

/// Where the scene puts the body; a motion from a file is not looked at.
template <int D>
Pose<D> scene_pose(const BodyScene& body);

/// The pose at time 0: of a motion from a file, else the scene's.
template <int D>
Pose<D> start_pose(const BodyScene& body);

} // namespace gapflow
