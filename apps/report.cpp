// gapflow report: a page or pictures of a run, or a page of several runs, from their files.
#include "commands.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/core/logging.hpp"
#include "gapflow/output/file.hpp"
#include "gapflow/output/frame_pictures.hpp"
#include "gapflow/output/progress.hpp"
#include "gapflow/output/report_page.hpp"
#include "gapflow/output/run_record.hpp"
#include "gapflow/output/sweep_record.hpp"

#include <fmt/core.h>

#include <cstdio>

namespace gapflow {

namespace {

namespace fs = std::filesystem;

void print_summary(const fs::path& page, const PageSummary& summary, std::size_t runs, const ReportOptions& options)
{
    if (!options.quiet)
        std::puts(fmt::format("{}: {:.1f} MB, {}{} of {} output times, {} of {} steps; open it in a browser", page.string(),
                              static_cast<double>(summary.bytes) / 1e6, runs > 1 ? fmt::format("{} runs, ", runs) : "",
                              summary.frames, summary.frames_of_run, summary.steps, summary.steps_of_run)
                      .c_str());
}

void write_page(const StoredRun& run, const ReportOptions& options, const CountWatcher& watch)
{
    const fs::path page = options.page.empty() ? run.folder / "report.html" : fs::path(options.page);
    print_summary(page, write_report_page(run, page, {}, watch), 1, options);
}

void write_pictures(const StoredRun& run, const ReportOptions& options, const CountWatcher& watch)
{
    for (const fs::path& picture : write_frame_pictures(run, run.folder / "frames", watch))
        if (!options.quiet)
            std::puts(picture.c_str());
}

/// The runs of a sweep that have begun, called by their values.
std::vector<LabelledRun> runs_of_sweep(const fs::path& folder, const SweepRecord& sweep)
{
    std::vector<LabelledRun> runs;
    std::vector<std::string> labels;
    for (const SweepRecord::Run& run : sweep.runs) {
        std::error_code error;
        if (!fs::exists(folder / run.folder / "run.json", error))
            continue;
        std::string label;
        for (const auto& [key, value] : run.values)
            label += (label.empty() ? "" : ", ") + key + " = " + value;
        runs.push_back({read_run(folder / run.folder), label});
        labels.push_back(label);
    }
    if (runs.empty())
        throw InputError(folder.string() + ": a sweep of which no run has begun");
    labels = short_labels(labels);
    for (std::size_t i = 0; i < runs.size(); ++i)
        runs[i].label = labels[i];
    return runs;
}

void write_comparison(const ReportOptions& options, const CountWatcher& watch)
{
    std::vector<StoredRun> stored;
    for (const std::string& folder : options.folders)
        stored.push_back(read_run(folder));
    const std::vector<std::string> labels = labels_of(stored);
    std::vector<LabelledRun> runs;
    for (std::size_t i = 0; i < stored.size(); ++i)
        runs.push_back({std::move(stored[i]), labels[i]});
    const fs::path page = options.page.empty() ? fs::path("comparison.html") : fs::path(options.page);
    print_summary(page, write_comparison_page(runs, page, nullptr, {}, watch), runs.size(), options);
}

} // namespace

int report_command(const ReportOptions& options)
{
    const Communicator comm;
    on_root(comm, [&] {
        CountProgress progress(choose_progress_style(comm, options.quiet), options.png ? "pictures" : "output times");
        const CountWatcher watch = [&](std::size_t done, std::size_t of) { progress(done, of); };
        const fs::path folder = options.folders.at(0);
        std::error_code error;
        const bool is_run = fs::exists(folder / "run.json", error);
        const auto sweep = options.folders.size() == 1 && !is_run ? read_sweep_record(folder) : std::nullopt;
        if (options.png && (sweep || options.folders.size() > 1))
            throw InputError("--png: pictures are of one run; give its folder alone");
        if (sweep) {
            const std::vector<LabelledRun> runs = runs_of_sweep(folder, *sweep);
            const fs::path page = options.page.empty() ? folder / "report.html" : fs::path(options.page);
            const SweepResults results = read_sweep_results(folder, *sweep);
            print_summary(page, write_comparison_page(runs, page, &results, {}, watch), runs.size(), options);
        } else if (options.folders.size() > 1) {
            write_comparison(options, watch);
        } else {
            const StoredRun run = read_run(folder);
            const auto recorded = read_recorded_run(run.folder / "run.json");
            if (recorded && recorded->state == RunState::killed)
                Logger(comm, options.quiet)
                    .warning(fmt::format("{}: the run was killed; its tables end with its last step, the fields with output "
                                         "times until time {:.6g}",
                                         folder.string(), recorded->time));
            options.png ? write_pictures(run, options, watch) : write_page(run, options, watch);
        }
    });
    return 0;
}

} // namespace gapflow
