// Runs of this program as processes of their own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gapflow {

/// The variables of this process's environment, NAME=value. To be taken before MPI starts, which adds its own: a process with those would
/// take itself for a part of this one.
std::vector<std::string> environment_variables();

/// Starts this program with other arguments, in a process group of its own, so that Ctrl-C at a terminal does not reach it; SIGTERM
/// reaches it when this process dies. Its output goes into the file `log`, which is replaced. Returns its id. Throws ComputationError.
int start_program(const std::vector<std::string>& arguments, const std::vector<std::string>& environment,
                  const std::filesystem::path& log);

} // namespace gapflow
