// The folder of a run on the disk: record, tables and the list of output frames. Also of a run in progress or
// stopped early.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace gapflow {

/// A table of a run, column by column. A last line without its end (the run is writing it) is left out.
struct RunTable {
    std::size_t rows = 0;
    std::map<std::string, std::vector<double>> numbers;
    std::map<std::string, std::vector<std::string>> texts; ///< body, body_a, body_b, crowd

    /// Empty if there is no such column.
    const std::vector<double>& number(const std::string& column) const;
    const std::vector<std::string>& text(const std::string& column) const;
};

/// Files of an output time, relative to the folder; empty where there is none.
struct RunFrame {
    int number = 0;
    double time = 0;
    std::string fields, films;
    std::map<std::string, std::string> bodies; ///< by name
};

struct StoredRun {
    std::filesystem::path folder;
    std::shared_ptr<const nlohmann::ordered_json> record; ///< run.json without the scene
    std::shared_ptr<const nlohmann::ordered_json> scene;  ///< the resolved scene
    int dimension = 2;
    RunTable bodies; ///< of bodies.csv, or of bodies.npy where there is no bodies.csv
    RunTable gaps, steps;
    RunTable fluxes;              ///< without rows where the scene has none
    RunTable crowds, profiles;    ///< without rows where the scene has no crowds
    std::vector<RunFrame> frames; ///< those whose field or body files are there
};

/// A table of a run or of a sweep by itself; without rows where there is no such file. `texts`: its columns of text beside the usual ones.
/// Throws InputError where a line has more or fewer columns than the first.
RunTable read_table(const std::filesystem::path& file, const std::vector<std::string>& texts = {});

/// Throws InputError if the folder holds no run or a file of it is damaged.
StoredRun read_run(const std::filesystem::path& folder);

} // namespace gapflow
