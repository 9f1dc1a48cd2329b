// run.json: the scene, the machine and the times of a run.
#pragma once

#include "gapflow/core/communicator.hpp"
#include "gapflow/core/timer.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
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
    std::string scene_file;            ///< absolute; empty: the scene is in no file
    std::string scene;                 ///< the resolved scene, as text
    std::vector<int> cells;            ///< of the grid along each axis
    std::string status = "running";    ///< then "done", "failed" or "interrupted"
    std::string message;               ///< reason, if failed
    std::string ended_by;              ///< the key that ended a run that is done
    std::vector<std::string> warnings; ///< given to the user, once each
    Machine machine;
    double time = 0; ///< reached, in the scene's unit
    long steps = 0;
    double seconds = 0; ///< wall clock
    std::map<std::string, StageTimers::Stage> stages;
    PeakMemory memory;
};

/// Writes the record, of a run that is running with this process, replacing an earlier one in one go. Throws ComputationError. Not collective: call it on the root.
void write_run_record(const std::filesystem::path& path, const RunRecord& record);

/// A process that runs, or ran: another one with the same id has started at another time.
struct ProcessMark {
    long id = 0;
    std::string host;
    std::int64_t started = 0;   ///< clock ticks since the host's start; 0: not known
    std::int64_t heartbeat = 0; ///< when the record was written, in seconds since 1970
};

/// This process, now.
ProcessMark current_process();

enum class RunState { running, killed, done, failed, interrupted, unknown };

/// What a record says of its run. A run that is recorded as running has been killed if its process is gone; on another host, if the record has
/// not been renewed for ten minutes.
struct RecordedRun {
    RunState state = RunState::unknown;
    bool here = false; ///< the process is or was on this host
    ProcessMark process;
    std::string title, scene_file, scene;
    double time = 0;
    long steps = 0;
};

/// Of the record at a path; none if there is none or it cannot be read.
std::optional<RecordedRun> read_recorded_run(const std::filesystem::path& path);

/// The warnings in the record of an earlier part of the run; none if it cannot be read.
std::vector<std::string> warnings_of_record(const std::filesystem::path& path);

} // namespace gapflow
