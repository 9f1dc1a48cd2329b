// Parts of read_scene(): each fills its part of the scene from checked values and rejects inconsistent ones.
#pragma once

#include "gapflow/scene/scene.hpp"
#include "gapflow/scene/values.hpp"

namespace gapflow {

/// Size, cells, origin, sides; needs time.cfl already read.
void read_domain(const Values& values, Scene& scene);

/// All [[body]]. A mass is demanded of free bodies if `moves` (a scene that will run).
void read_bodies(const Node& document, const std::vector<KeyInfo>& keys, bool moves, Scene& scene);

/// [gap], [contact] and all [[pair]]; needs sides and bodies already read.
void read_gaps(const Values& values, const std::vector<KeyInfo>& keys, Purpose purpose, Scene& scene);

/// A path from the scene, relative to the scene's folder.
std::string resolved_path(const Scene& scene, const std::string& path);

} // namespace gapflow
