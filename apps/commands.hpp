// The command's subcommands. Each returns the exit status and throws InputError or ComputationError.
#pragma once

#include "gapflow/core/communicator.hpp"
#include "gapflow/scene/scene.hpp"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace gapflow {

struct RunOptions {
    bool quiet = false; ///< no progress, only warnings and errors
    std::string resume; ///< checkpoint to continue from; empty: from the start
    bool force = false; ///< another run's files in the folder are replaced
};

/// Runs the scene to its end and writes the files of a run. Collective.
int run_command(const Scene& scene, const RunOptions& options);

struct ConvergeOptions {
    std::string cells;                   ///< along the first axis, as "32,64,128"
    std::string reference;               ///< CSV file; empty: the finest run
    std::vector<std::string> quantities; ///< "body.column", "a-b.column" of a gap; empty: positions and velocities
    std::vector<std::string> columns;    ///< "quantity=column" of the reference file
    std::string window;                  ///< "from,to"; empty: the whole run
    bool quiet = false;
};

/// Reads the user's scene with more overrides after the user's own.
using SceneReader = std::function<Scene(const std::vector<std::pair<std::string, std::string>>& overrides)>;

/// Runs the scene on several grids, with max_step and gap_cfl in proportion to the spacing, into folders cells_N of the output
/// folder; prints errors and observed orders and writes converge.csv and converge.json there. Collective.
int converge_command(const SceneReader& read, const ConvergeOptions& options);

struct SweepOptions {
    std::string scene;                   ///< file
    std::vector<std::string> sets;       ///< "key=value" for all runs
    std::vector<std::string> vary;       ///< "key=VALUES" (variation.hpp)
    bool zip = false;                    ///< the first values of all keys together, then the second ones ...
    int jobs = 0;                        ///< processes at once; 0: the machine's cores
    std::vector<std::string> quantities; ///< as ConvergeOptions; empty: key_quantities()
    std::string window;                  ///< "from,to" of means and extremes; empty: the whole run
    bool quiet = false;
    std::vector<std::string> environment; ///< of the runs' processes, "NAME=value"
};

/// Runs the scene with every combination of values, each in a process and a folder run_NNN of the output folder; writes sweep.csv there and
/// prints a summary. Runs that are done there already are kept. Not on several ranks.
int sweep_command(const SceneReader& read, const SweepOptions& options);

/// Prints a summary of a valid scene and its cost; writes a picture of the fluid's parts where a file for it (.vtu) is named. Collective.
int check_command(const Scene& scene, const std::string& parts_file);

/// Prints the added-mass matrix, as a table or as JSON. Collective.
int added_mass_command(const Scene& scene, bool json, bool accelerations);

struct ReportOptions {
    std::vector<std::string> folders; ///< of runs, or of a sweep
    std::string page; ///< empty: report.html in the run's or the sweep's folder, comparison.html here for several runs
    bool png = false; ///< key frames as PNG in the run's folder frames/ instead of a page
    bool quiet = false;
};

/// Writes a page or pictures of a run, or a page of several runs, from their files. Only the root works. Collective.
int report_command(const ReportOptions& options);

} // namespace gapflow
