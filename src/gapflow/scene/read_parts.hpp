// Parts of read_scene(): each fills its part of the scene from checked values and rejects inconsistent ones.
#pragma once

#include "gapflow/scene/scene.hpp"
#include "gapflow/scene/values.hpp"

namespace gapflow {

/// Size, cells, origin, sides; needs time.cfl already read.
void read_domain(const Values& values, Scene& scene);

/// All [[body]]. A mass is demanded of free bodies if `moves` (a scene that will run).
void read_bodies(const Node& document, const std::vector<KeyInfo>& keys, bool moves, Scene& scene);

/// A body of a [[crowd]], without name and place: its rotation is that given for all, none where it is random.
BodyScene read_crowd_body(const Values& values, bool moves, Scene& scene);

/// Throws InputError for names that tables and files cannot have.
void check_body_name(const Values& values, const std::string& name);

/// All [[crowd]], as bodies behind those read before; needs sides, [gap] and [contact] already read.
void read_crowds(const Node& document, const std::vector<KeyInfo>& keys, bool moves, Scene& scene);

/// [gap] and [contact]; needs sides already read.
void read_gaps(const Values& values, Purpose purpose, Scene& scene);

/// All [[pair]]; needs [gap], [contact] and all bodies already read.
void read_pairs(const Values& values, const std::vector<KeyInfo>& keys, Purpose purpose, Scene& scene);

/// Throws InputError if a name in a list of two is not that of a body or a closed side; `what`: who names them, for the message.
void check_partners(const Values& values, const std::string& key, const std::string& what, const Scene& scene);

/// All [[probe]] and [[flux]]; needs domain, all bodies and time.end already read.
void read_measures(const Node& document, const std::vector<KeyInfo>& keys, Scene& scene);

/// Throws InputError where a time interval is so short that a run would consist of too many of them.
void check_count(const Values& values, const char* name, double every, double end, double most, const char* what);
inline constexpr double most_outputs = 1e6; ///< of files or rows at intervals

/// A path from the scene, relative to the scene's folder.
std::string resolved_path(const Scene& scene, const std::string& path);

} // namespace gapflow
