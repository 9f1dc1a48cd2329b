// sweep.json: the runs of a sweep and the values that they have; sweep.csv: what came out of them.
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

/// What came out of a sweep's runs, a value a run; NaN where a run has none.
struct SweepResults {
    struct Quantity {
        std::string name; ///< as for --quantity
        std::vector<double> last, mean, low, high;
    };
    std::vector<std::pair<std::string, std::vector<std::string>>> keys; ///< that vary, and their values
    std::vector<Quantity> quantities;
};

/// Reads sweep.csv; without quantities where it is not there. Throws InputError where it is damaged or of another sweep than the record.
SweepResults read_sweep_results(const std::filesystem::path& folder, const SweepRecord& record);

} // namespace gapflow
