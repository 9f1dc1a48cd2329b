// checkpoint.h5: the state of a run between two steps, from which it can be continued.
#pragma once

#include "gapflow/core/communicator.hpp"
#include "gapflow/core/state_archive.hpp"
#include "gapflow/scene/scene.hpp"

#include <filesystem>
#include <string>

namespace gapflow {

/// Position of a run in its output files.
struct RunPosition {
    long step = 0;           ///< last one in the tables
    int frames = 0;          ///< output times whose fields are written
    double smallest_gap = 0; ///< so far; infinite: there was none
};

struct Checkpoint {
    std::string version; ///< of the program that wrote it
    std::string scene;   ///< resolved, as in run.json
    RunPosition position;
    StoredState state;
};

/// Writes the file, replacing an earlier one in one go. Throws ComputationError on every rank. Collective.
void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint, const Communicator& comm);

/// Throws InputError, with file and remedy, if the file cannot be read, is no checkpoint, is damaged, or has another format.
/// Collective.
Checkpoint read_checkpoint(const std::filesystem::path& path, const Communicator& comm);

/// Throws InputError, naming the first key that differs, if a run of `scene` cannot continue from a checkpoint of another scene:
/// all but title, time, solver, output, probe, flux and domain.leaving must be the same. Names of folders of the scene's files are not compared.
void require_same_scene(const std::filesystem::path& path, const Checkpoint& checkpoint, const Scene& scene);

/// Whether two resolved scenes agree in all that must be the same for a run to continue.
bool same_scene(const std::string& one, const std::string& other);

/// The InputError for a state that Simulation rejected.
[[noreturn]] void throw_checkpoint_error(const std::filesystem::path& path, const std::string& problem);

} // namespace gapflow
