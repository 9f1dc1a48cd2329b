// This program as a process: its environment, and runs of it as processes of their own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gapflow {

/// The variables of this process's environment, NAME=value. To be taken before MPI starts, which adds its own: a process with those would
/// take itself for a part of this one.
std::vector<std::string> environment_variables();

/// Lets threads that wait for each other sleep after a thousand looks, some microseconds; the OpenMP library's own 300 000 take the core that the
/// awaited thread needs as soon as anything else runs on the machine: two runs on two cores then take eight times as long each. The
/// library reads the variable before main(), so this starts the program anew, in the same process. Does nothing where the variables that say how
/// to wait are set, or threads are none.
void let_threads_sleep(char** argv);

/// Starts this program with other arguments, in a process group of its own, so that Ctrl-C at a terminal does not reach it; SIGTERM
/// reaches it when this process dies. Its output goes into the file `log`, which is replaced. Returns its id. Throws ComputationError.
int start_program(const std::vector<std::string>& arguments, const std::vector<std::string>& environment,
                  const std::filesystem::path& log);

} // namespace gapflow
