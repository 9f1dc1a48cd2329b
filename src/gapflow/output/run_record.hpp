// run.json: the scene, the machine and the times of a run.
#pragma once

#include "gapflow/core/communicator.hpp"
#include "gapflow/core/timer.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace gapflow {

struct Machine {
    std::string cpu; ///< name of the root's processor ("unknown" where the system does not tell)
    int cores = 0;   ///< that the root's machine has
    int ranks = 1;
    int threads = 1; ///< of the root
};

/// The system's data about this machine.
Machine describe_machine(const Communicator& comm);

/// Largest resident memory so far, in bytes.
struct PeakMemory {
    double largest_rank = 0, sum = 0;
};
/// From getrusage. Collective.
PeakMemory peak_memory(const Communicator& comm);

struct RunRecord {
    std::string version;
    std::string scene;                 ///< the resolved scene, as text
    std::string status = "running";    ///< then "done", "failed" or "interrupted"
    std::string message;               ///< reason, if failed
    std::vector<std::string> warnings; ///< given to the user, once each
    Machine machine;
    double time = 0; ///< reached, in the scene's unit
    long steps = 0;
    double seconds = 0; ///< wall clock
    std::map<std::string, StageTimers::Stage> stages;
    PeakMemory memory;
};

/// Writes the record, replacing an earlier one in one go. Throws ComputationError. Not collective: call it on the root.
void write_run_record(const std::filesystem::path& path, const RunRecord& record);

/// The warnings in the record of an earlier part of the run; none if it cannot be read.
std::vector<std::string> warnings_of_record(const std::filesystem::path& path);

} // namespace gapflow
