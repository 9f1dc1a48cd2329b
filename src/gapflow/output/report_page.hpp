// One HTML page of a run: plots, an animated view, the scene, machine and timings. The file is self-contained.
#pragma once

#include "gapflow/output/progress.hpp"
#include "gapflow/output/stored_run.hpp"
#include "gapflow/output/sweep_record.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace gapflow {

/// Limits of a page's size. Frames and steps beyond are thinned evenly, first and last stay; the page says so.
struct PageLimits {
    long volume_cells = 1 << 16;          ///< 3D: of one field in the whole domain, for slices that move: coarser means beyond
    long plane_cells = 1 << 17;           ///< of one field on one plane: coarser means beyond
    std::size_t frame_bytes = 48 << 20;   ///< of all frames, before compression to a half or less
    std::size_t steps = 10'000;           ///< rows of a plot
    std::size_t table_values = 4'000'000; ///< numbers of all tables
};

struct PageSummary {
    std::size_t frames = 0, frames_of_run = 0, steps = 0, steps_of_run = 0, bytes = 0;
};

/// Writes the page. Throws InputError for damaged files of the run and ComputationError if it cannot write.
/// `watch` is called for every output time that is read.
PageSummary write_report_page(const StoredRun& run, const std::filesystem::path& page, const PageLimits& limits = {},
                              const CountWatcher& watch = {});

/// A run and what it is called among others.
struct LabelledRun {
    StoredRun run;
    std::string label;
};

/// Writes one page of several runs: plots with a curve a run, views beside each other with one slider. The limits hold for all together. Throws as
/// above, and InputError for runs in 2D and 3D. With `sweep` also a plot of each of its quantities over the keys that vary.
PageSummary write_comparison_page(const std::vector<LabelledRun>& runs, const std::filesystem::path& page,
                                  const SweepResults* sweep = nullptr, const PageLimits& limits = {},
                                  const CountWatcher& watch = {});

/// Labels of runs among each other: by the keys that their scenes differ in ("body.ball.density = 2"), else, and where these are more than three,
/// by their folders.
std::vector<std::string> labels_of(const std::vector<StoredRun>& runs);

/// Labels with their decimals cut to five digits, as 0.718877777777778 to 0.71888, where they still differ; else as they are.
std::vector<std::string> short_labels(const std::vector<std::string>& labels);

} // namespace gapflow
