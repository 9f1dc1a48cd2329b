// What the command's subcommands do with a scene. Each returns the exit status and throws InputError or ComputationError.
#pragma once

#include "gapflow/core/communicator.hpp"
#include "gapflow/scene/scene.hpp"

namespace gapflow {

struct RunOptions {
    bool quiet = false; ///< no progress, only warnings and errors
};

/// Runs the scene to its end and writes the files of a run. Collective.
int run_command(const Scene& scene, const RunOptions& options);

/// Prints what a valid scene asks for. Collective.
int check_command(const Scene& scene);

/// Prints the added-mass matrix, as a table or as JSON. Collective.
int added_mass_command(const Scene& scene, bool json);

} // namespace gapflow
