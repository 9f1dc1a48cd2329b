// gapflow report: a page or pictures of a run, from its files.
#include "commands.hpp"

#include "gapflow/core/logging.hpp"
#include "gapflow/output/file.hpp"
#include "gapflow/output/frame_pictures.hpp"
#include "gapflow/output/progress.hpp"
#include "gapflow/output/report_page.hpp"
#include "gapflow/output/run_record.hpp"

#include <fmt/core.h>

#include <cstdio>

namespace gapflow {

namespace {

void write_page(const StoredRun& run, const ReportOptions& options, const CountWatcher& watch)
{
    const std::filesystem::path page = options.page.empty() ? run.folder / "report.html" : std::filesystem::path(options.page);
    const PageSummary summary = write_report_page(run, page, {}, watch);
    if (!options.quiet)
        std::puts(fmt::format("{}: {:.1f} MB, {} of {} output times, {} of {} steps; open it in a browser", page.string(),
                              static_cast<double>(summary.bytes) / 1e6, summary.frames, summary.frames_of_run, summary.steps,
                              summary.steps_of_run)
                      .c_str());
}

void write_pictures(const StoredRun& run, const ReportOptions& options, const CountWatcher& watch)
{
    for (const std::filesystem::path& picture : write_frame_pictures(run, run.folder / "frames", watch))
        if (!options.quiet)
            std::puts(picture.c_str());
}

} // namespace

int report_command(const ReportOptions& options)
{
    const Communicator comm;
    on_root(comm, [&] {
        const StoredRun run = read_run(options.directory);
        const auto recorded = read_recorded_run(run.folder / "run.json");
        if (recorded && recorded->state == RunState::killed)
            Logger(comm, options.quiet)
                .warning(fmt::format(
                    "{}: the run was killed; its tables end with its last step, the fields with output times until time {:.6g}",
                    options.directory, recorded->time));
        CountProgress progress(choose_progress_style(comm, options.quiet), options.png ? "pictures" : "output times");
        const CountWatcher watch = [&](std::size_t done, std::size_t of) { progress(done, of); };
        options.png ? write_pictures(run, options, watch) : write_page(run, options, watch);
    });
    return 0;
}

} // namespace gapflow
