// The folder of a run's files: whether it holds another run, and clearing it.
#pragma once

#include "gapflow/core/communicator.hpp"
#include "gapflow/scene/scene.hpp"

#include <filesystem>
#include <string>

namespace gapflow {

/// How a run takes its folder.
struct FolderClaim {
    bool force = false;   ///< a run of another scene there is replaced
    bool resumes = false; ///< the run there is continued
};

/// Throws InputError where a run must not write into a folder: one that is running writes there, or it holds the run of another scene and neither
/// `force` nor `resumes` allows it. The same scene file (edited since, or with other values of --set) is the same scene, as is a scene that could
/// continue that run. Folders without a run are free. Changes nothing. Collective.
void claim_folder(const std::filesystem::path& folder, const Scene& scene, const FolderClaim& claim, const Communicator& comm);

/// Removes the files that the run in a folder wrote, and nothing else; nothing where there is no run. Not collective: call it on the root.
void clear_run(const std::filesystem::path& folder);

/// The absolute path of a scene's file; empty where there is no such file.
std::string path_of_scene(const Scene& scene);

} // namespace gapflow
