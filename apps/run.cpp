// gapflow run: a scene from its start to its end, with files, progress and a clean stop on a signal.
#include "commands.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/core/logging.hpp"
#include "gapflow/core/threads.hpp"
#include "gapflow/output/progress.hpp"
#include "gapflow/output/run_files.hpp"
#include "gapflow/stepping/simulation.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <csignal>

namespace gapflow {

namespace {

volatile std::sig_atomic_t stop_signal = 0;

void note_signal(int signal)
{
    stop_signal = signal;
}

template <int D>
void summarise(const Simulation<D>& simulation, const Logger& log, double smallest_gap, const std::string& folder)
{
    log.info(fmt::format("done: {} steps to time {:.6g}", simulation.steps(), simulation.time()));
    if (smallest_gap < 1e300)
        log.info(fmt::format("smallest gap: {:.4g} ({:.3g} cells)", smallest_gap, smallest_gap / simulation.grid().dx()));
    std::string stages;
    for (const auto& [name, stage] : simulation.stages().stages())
        stages += fmt::format("{}{} {:.2f} s", stages.empty() ? "" : ", ", name, stage.seconds);
    log.info("time: " + stages);
    log.info(fmt::format("files: {0}/bodies.csv, gaps.csv, steps.csv; open {0}/gapflow.pvd in ParaView", folder));
    log.info(fmt::format("look at it: gapflow report {0} writes {0}/report.html for a browser", folder));
}

template <int D>
int run(const Scene& scene, const RunOptions& options)
{
    const Communicator comm;
    Logger log(comm, options.quiet);
    for (const std::string& warning : scene.warnings)
        log.warn_once(warning);
    Simulation<D> simulation(scene, comm);
    RunFiles<D> files(scene.output_directory, simulation, GAPFLOW_VERSION);
    log.info(fmt::format("{}: {} cells, {} film nodes, {} rank(s) of {} thread(s)", scene.title.empty() ? scene.file : scene.title,
                         simulation.initial_report().cells, simulation.initial_report().film_nodes, comm.size(), thread_count()));
    if (const auto& sealed = simulation.coupling().sealed; !sealed.empty())
        log.info(fmt::format("{} pocket(s) of fluid are sealed in", sealed.size()));
    files.write_step(simulation, simulation.initial_report());
    files.write_fields(simulation);
    std::signal(SIGINT, note_signal);
    std::signal(SIGTERM, note_signal);

    Progress progress(choose_progress_style(comm, options.quiet), 0, scene.end);
    double smallest_gap = 1e300;
    long output = 1;
    try {
        while (simulation.time() < scene.end) {
            double next = scene.output_every > 0 ? std::min(scene.end, output * scene.output_every) : scene.end;
            if (scene.end - next < 1e-9 * scene.end)
                next = scene.end;
            const StepReport report = simulation.step(next);
            for (const std::string& note : report.notes)
                log.warn_once(note);
            for (const GapState& gap : simulation.gaps())
                smallest_gap = std::min(smallest_gap, gap.thickness);
            files.write_step(simulation, report);
            const ProgressState state{report.time, report.dt, report.step, report.iterations};
            progress.step(state);
            const bool stop = comm.any(stop_signal != 0);
            if (simulation.time() >= next || stop) {
                files.write_fields(simulation);
                progress.output(state);
                ++output;
            }
            if (stop) {
                const int signal = static_cast<int>(comm.max(static_cast<long>(stop_signal)));
                progress.clear();
                files.finish(simulation, "interrupted");
                log.warning(fmt::format("interrupted at time {:.6g}; files are complete up to there", simulation.time()));
                return 128 + signal;
            }
        }
    } catch (const ComputationError& error) {
        progress.clear();
        files.finish(simulation, "failed", error.what());
        throw;
    }
    progress.clear();
    files.finish(simulation, "done");
    summarise(simulation, log, smallest_gap, scene.output_directory);
    return 0;
}

} // namespace

int run_command(const Scene& scene, const RunOptions& options)
{
    return scene.dimension == 2 ? run<2>(scene, options) : run<3>(scene, options);
}

} // namespace gapflow
