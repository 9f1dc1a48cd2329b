// gapflow run: a scene from its start to its end, with files, checkpoints, progress and a clean stop on a signal.
#include "commands.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/core/logging.hpp"
#include "gapflow/core/threads.hpp"
#include "gapflow/output/progress.hpp"
#include "gapflow/output/run.hpp"
#include "gapflow/output/run_folder.hpp"
#include "gapflow/step/simulation.hpp"
#include "gapflow/stepping/gap_notes.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <map>
#include <string>

namespace gapflow {

namespace {

constexpr std::size_t most_bodies_told = 5; // in the summary
constexpr std::size_t most_pockets_told = 3;

volatile std::sig_atomic_t stop_signal = 0;

// The first signal requests an end after the step, a second one ends the process immediately.
void note_signal(int signal)
{
    stop_signal = signal;
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
}

template <int D>
Vec<D> start_position(const RigidBody<D>& body, const BodyScene& scene)
{
    return body.prescribed ? (*body.prescribed)(0.0).position : to_vec<D>(scene.position);
}

template <int D>
void summarise(const Run<D>& run, const Logger& log, const std::string& folder, const std::map<std::string, long>& notes)
{
    const Simulation<D>& simulation = run.simulation();
    const double smallest_gap = run.smallest_gap();
    const double dx = simulation.grid().dx();
    log.info(fmt::format("done: {} steps to time {:.6g}", simulation.steps(), simulation.time()));
    struct Way {
        std::size_t body;
        double length;
    };
    std::vector<Way> ways;
    for (std::size_t b = 0; b < simulation.bodies().size(); ++b)
        if (const RigidBody<D>& body = simulation.bodies()[b];
            body.motion != Motion::fixed && !simulation.removed(static_cast<int>(b)))
            ways.push_back({b, (body.pose.position - start_position(body, simulation.scene().bodies[b])).norm()});
    if (ways.size() > most_bodies_told) {
        log.info(fmt::format("{} bodies moved, the furthest {}:", ways.size(), most_bodies_told));
        std::stable_sort(ways.begin(), ways.end(), [](const Way& a, const Way& b) { return a.length > b.length; });
        ways.resize(most_bodies_told);
    }
    for (const auto& [b, way] : ways) {
        const RigidBody<D>& body = simulation.bodies()[b];
        log.info(fmt::format("{} is {:.4g} ({:.3g} cells) from its start, at speed {:.4g}", body.name, way, way / dx,
                             body.twist.template head<D>().norm()));
    }
    const std::vector<int> outside = simulation.outside();
    for (const CrowdScene& crowd : simulation.scene().crowds)
        if (const auto count = std::count_if(outside.begin(), outside.end(),
                                             [&](int body) { return simulation.scene().crowd_of(body) == &crowd; }))
            log.info(fmt::format("{} of the {} bodies of crowd '{}' have left the domain", count, crowd.number, crowd.name));
    if (std::isfinite(smallest_gap))
        log.info(fmt::format("smallest gap: {:.4g} ({:.3g} cells){}{}; roughness {}", smallest_gap, smallest_gap / dx,
                             run.smallest_gap_place().empty() ? "" : " ", run.smallest_gap_place(),
                             roughness_text(simulation.scene())));
    if (simulation.scene().parts)
        log.info(fmt::format(
            "forces: the correction of their work added {:.2g} % of the largest energy, its magnitudes sum up to {:.2g} %",
            100 * simulation.correction().sum, 100 * simulation.correction().magnitude));
    for (const auto& [note, steps] : notes)
        if (steps > 1)
            log.info(fmt::format("in {} steps: {}", steps, note));
    std::string stages;
    for (const auto& [name, stage] : simulation.stages().stages())
        stages += fmt::format("{}{} {:.2f} s", stages.empty() ? "" : ", ", name, stage.seconds);
    log.info("time: " + stages);
    const Scene& scene = simulation.scene();
    log.info(fmt::format("files: {0}/{1}, gaps.csv, steps.csv{2}{3}{4}{5}; open {0}/gapflow.pvd in ParaView", folder,
                         scene.writes_csv() ? "bodies.csv" : "bodies.npy",
                         scene.crowds.empty() ? "" : ", crowds.csv, crowd_profiles.csv",
                         scene.probes.empty() ? "" : ", probes.csv", scene.fluxes.empty() ? "" : ", fluxes.csv",
                         scene.forces ? ", forces.csv" : ""));
    log.info(fmt::format("look at it: gapflow report {0} writes {0}/report.html for a browser", folder));
}

template <int D>
int drive(const Scene& scene, const RunOptions& options)
{
    const Communicator comm;
    Logger log(comm, options.quiet);
    claim_folder(scene.output_directory, scene, {options.force, !options.resume.empty()}, comm);
    Run<D> run(scene, comm, {scene.output_directory, options.resume, GAPFLOW_VERSION});
    const Simulation<D>& simulation = run.simulation();
    log.info(fmt::format("{}: {} cells, {} film nodes, {} rank(s) of {} thread(s)",
                         scene.title.empty() ? scene.file : scene.title, simulation.initial_report().cells,
                         simulation.initial_report().film_nodes, comm.size(), thread_count()));
    const auto& sealed = simulation.coupling().sealed;
    for (std::size_t i = 0; i < std::min(sealed.size(), most_pockets_told); ++i)
        log.info("sealed in: " + sealed_text(sealed[i]));
    if (sealed.size() > most_pockets_told)
        log.info(fmt::format("and {} more pockets of fluid are sealed in", sealed.size() - most_pockets_told));
    for (const std::string& note : simulation.initial_report().notes)
        log.warn_once(note);
    if (run.resumed())
        log.info(fmt::format("goes on from step {} at time {:.6g}", simulation.steps(), simulation.time()));
    std::signal(SIGINT, note_signal);
    std::signal(SIGTERM, note_signal);

    std::map<std::string, long> notes; // and in how many steps
    Progress progress(choose_progress_style(comm, options.quiet), simulation.time(), scene.end);
    try {
        run.write_start();
        while (!run.ended()) {
            const StepReport& report = run.step();
            for (const std::string& note : report.notes) {
                log.warn_once(note);
                ++notes[note];
            }
            const ProgressState state{report.time, report.dt, report.step, report.iterations,
                                      scene.until_steady ? std::optional(report.unsteadiness) : std::nullopt};
            progress.step(state);
            if (run.shown())
                progress.output(state);
            if (comm.any(stop_signal != 0) && !run.ended()) {
                const int signal = static_cast<int>(comm.max(static_cast<long>(stop_signal)));
                progress.clear();
                run.interrupt();
                log.warning(
                    fmt::format("interrupted at time {0:.6g}; files are complete up to there; to go on: gapflow run {1} "
                                "--resume {2}/checkpoint.h5 -o {2}, with the same --set",
                                simulation.time(), scene.file, scene.output_directory));
                return 128 + signal;
            }
        }
    } catch (const ComputationError&) {
        progress.clear();
        throw;
    }
    progress.clear();
    run.finish();
    if (run.ended_by() == "time.until_steady" && run.report().unsteadiness == 0)
        log.info("nothing flows or moves any more");
    else if (run.ended_by() == "time.until_steady")
        log.info(fmt::format("the flow is steady: it changes by less than {:.3g} of itself from here on", *scene.until_steady));
    else if (run.ended_by() == "domain.leaving")
        log.warning(fmt::format(
            "ended because a body is on its way out (domain.leaving = \"stop\"); to go on: gapflow run {0} --resume "
            "{1}/checkpoint.h5 -o {1}, with the same --set",
            scene.file, scene.output_directory));
    summarise(run, log, scene.output_directory, notes);
    return 0;
}

} // namespace

int run_command(const Scene& scene, const RunOptions& options)
{
    return scene.dimension == 2 ? drive<2>(scene, options) : drive<3>(scene, options);
}

} // namespace gapflow
