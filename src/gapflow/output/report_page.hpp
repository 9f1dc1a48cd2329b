// One HTML page of a run: plots, an animated view, the scene, machine and timings. The file is self-contained.
#pragma once

#include "gapflow/output/progress.hpp"
#include "gapflow/output/stored_run.hpp"

#include <cstddef>
#include <filesystem>

namespace gapflow {

/// Limits of a page's size. Frames and steps beyond are thinned evenly, first and last stay; the page says so.
struct PageLimits {
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

} // namespace gapflow
