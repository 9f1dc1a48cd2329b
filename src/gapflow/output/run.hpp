// A run: a simulation from its start, or from a checkpoint, through its output times, and its files.
#pragma once

#include "gapflow/output/run_files.hpp"
#include "gapflow/output/schedule.hpp"
#include "gapflow/step/simulation.hpp"

#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <string>

namespace gapflow {

/// Location of a run's files.
struct RunPlace {
    std::string folder; ///< for the files; empty: none are written
    std::string
        resume; ///< checkpoint to continue from; empty: from the scene's start. With a folder, its files are cut back to it.
    std::string version; ///< of the program, for the files
};

/// Driver of a run for the command and for Python: steps end at output times; tables, fields and checkpoints are written when they are due; the
/// files are valid however the run ends.
template <int D>
class Run {
public:
    /// Reads the checkpoint, computes the start, prepares the folder. `velocity`: of the fluid at the start, as Simulation's; not of a run that goes on from a
    /// checkpoint. Throws InputError, ComputationError. Collective.
    Run(const Scene& scene, const Communicator& comm, const RunPlace& place, const FaceField<D>* velocity = nullptr);

    /// Writes the start's rows and fields, where there are files and the run does not go on from a checkpoint. Collective.
    void write_start();
    /// One step that passes neither `until`, nor time.end while that is ahead, nor, with files, an output time; writes the files that are due.
    /// After an exception the files record that the run failed, and the simulation has no state. Collective.
    const StepReport& step(double until = std::numeric_limits<double>::infinity());
    /// A checkpoint of this moment into a file. Throws ComputationError. Collective.
    void write_checkpoint(const std::filesystem::path& path) const;
    /// A run without files of a simulation in the same state: it goes on with the same bits. Collective.
    std::unique_ptr<Run> copy() const;
    /// Goes on with values of another scene that the state does not hold: gravity, viscosity, sides, springs, laws of contact, lengths of steps.
    /// Throws InputError if the state is not one of such a scene; the run then is as before. Collective.
    void change(const Scene& scene);
    /// Ends the files before time.end: a checkpoint to continue from, fields of this moment, the record. Collective.
    void interrupt();
    /// Ends the files. Collective.
    void finish();
    /// Whether the run is over: at time.end, or before it because the flow is steady or a body leaves and the scene asks for that. Files and a
    /// checkpoint of the moment are written then.
    bool ended() const { return !ended_by_.empty() || simulation_->time() >= end_; }
    /// The scene's key that ended it: time.end, time.until_steady or domain.leaving.
    std::string ended_by() const { return ended_by_.empty() ? "time.end" : ended_by_; }

    Simulation<D>& simulation() { return *simulation_; }
    const Simulation<D>& simulation() const { return *simulation_; }
    /// The simulation, which may outlive the run: for owners of views of its memory.
    std::unique_ptr<Simulation<D>> release() { return std::move(simulation_); }
    /// Of the last step; at first of the start.
    const StepReport& report() const { return report_; }
    bool resumed() const { return resumed_; }
    /// Whether the last step ended at an output time, whose fields are written.
    bool shown() const { return shown_; }
    /// Smallest thickness so far, also before the checkpoint, of a gap that can change; infinite: there was none.
    double smallest_gap() const { return smallest_gap_; }
    /// Where and when that was: "between 'ball' and 'wall:bottom' at time 0.25"; empty: before the checkpoint.
    const std::string& smallest_gap_place() const { return smallest_gap_place_; }

private:
    struct Copy {}; ///< tag
    Run(Copy, const Run& from);

    void record_failure(const char* message);
    void note_smallest_gap();
    void end_if_asked();
    void demand_core();
    void write_last();

    std::unique_ptr<Simulation<D>> simulation_;
    std::optional<RunFiles<D>> files_;
    std::optional<Schedule> schedule_; ///< with files
    StepReport report_;
    std::string version_, smallest_gap_place_, ended_by_; ///< the last: a key; empty: time.end, or not yet
    std::set<std::string> moving_;                        ///< bodies that can
    double end_, smallest_gap_ = std::numeric_limits<double>::infinity();
    bool resumed_ = false, shown_ = false, stored_ = false; ///< the latter: a checkpoint of this moment is in the folder
};

} // namespace gapflow
