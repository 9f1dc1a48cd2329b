// sweep.json: the runs of a sweep and the values that they have.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gapflow {

struct SweepRecord {
    struct Run {
        std::string folder;                                      ///< in the sweep's
        std::vector<std::pair<std::string, std::string>> values; ///< by the keys that vary
    };
    std::string scene; ///< file
    std::vector<Run> runs;
};

/// Throws ComputationError.
void write_sweep_record(const std::filesystem::path& folder, const SweepRecord& record);

/// None if the folder has no sweep.json. Throws InputError where it cannot be understood.
std::optional<SweepRecord> read_sweep_record(const std::filesystem::path& folder);

} // namespace gapflow
