// The files of a run: tables every step, fields at output times, run.json, checkpoint.h5.
#pragma once

#include "gapflow/output/checkpoint.hpp"
#include "gapflow/output/measure_tables.hpp"
#include "gapflow/output/npy_table.hpp"
#include "gapflow/output/pvd.hpp"
#include "gapflow/output/run_record.hpp"
#include "gapflow/output/table.hpp"
#include "gapflow/step/simulation.hpp"

#include <filesystem>
#include <optional>

namespace gapflow {

/// Writes a simulation's state into a folder. All files are complete after each call.
template <int D>
class RunFiles {
public:
    /// Prepares the folder, the tables and the record; an earlier run's files are removed (clear_run()). With `from`, the files of the run that wrote that
    /// checkpoint are cut back to it and continued. Throws InputError if the folder cannot be written. Collective.
    RunFiles(const std::filesystem::path& folder, const Simulation<D>& simulation, const std::string& version,
             const RunPosition* from = nullptr);

    /// A row in every table; the report's notes, once each, among the record's warnings. The record is renewed every half minute. Collective.
    void write_step(const Simulation<D>& simulation, const StepReport& report);
    /// Fields, bodies and films of this moment, and run.json so far. Collective.
    void write_fields(const Simulation<D>& simulation);
    /// checkpoint.h5 of this moment: a run that goes on from it keeps the fields written until now. Collective.
    void write_checkpoint(const Simulation<D>& simulation, double smallest_gap);
    /// run.json with the run's end. Collective.
    void finish(const Simulation<D>& simulation, const std::string& status, const std::string& message = "",
                const std::string& ended_by = "");

    /// Output times whose fields are written.
    int frames() const { return frame_; }

private:
    void open_tables(const Simulation<D>& simulation, const RunPosition* from);
    void write_crowds(const Simulation<D>& simulation, const StepReport& report);
    void write_profiles(const Simulation<D>& simulation);
    void keep_notes(const std::vector<std::string>& notes);
    void write_record(const Simulation<D>& simulation);

    std::filesystem::path folder_;
    PvdCollection collection_;
    std::optional<Table> bodies_, gaps_, steps_; ///< on the root
    std::vector<Column<StepReport>> step_columns_;
    std::optional<NpyTable> binary_bodies_;  ///< on the root, besides or instead of bodies_
    std::optional<Table> crowds_, profiles_; ///< on the root, of scenes with crowds
    MeasureTables<D> measures_;
    RunRecord record_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now(),
                                          recorded_ = start_; ///< the latter: run.json
    int frame_ = 0;
};

} // namespace gapflow
