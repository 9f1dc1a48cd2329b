// The command `gapflow`: reads the command line, maps errors to exit statuses (0 done, 1 failed, 2 bad usage or scene).
#include "child_process.hpp"
#include "commands.hpp"
#include "describe.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/core/text.hpp"
#include "gapflow/output/file.hpp"
#include "gapflow/scene/key_reference.hpp"

#include <CLI/CLI.hpp>

#include <csignal>
#include <exception>
#include <functional>
#include <iostream>

namespace gapflow {

namespace {

constexpr int failed = 1, bad_input = 2;

struct Arguments {
    std::string scene, directory, resume, table, kind, parts_file;
    std::vector<std::string> sets;
    ConvergeOptions converge;
    SweepOptions sweep;
    ReportOptions report;
    bool quiet = false, json = false, names = false, force = false, accelerations = false;
};

using Overrides = std::vector<std::pair<std::string, std::string>>;

Overrides overrides_of(const std::vector<std::string>& sets)
{
    Overrides overrides;
    for (const std::string& set : sets) {
        const auto equals = set.find('=');
        if (equals == std::string::npos || equals == 0)
            throw InputError("--set " + set + ": not key=value; write for example --set domain.cells=[64,64]");
        overrides.emplace_back(set.substr(0, equals), set.substr(equals + 1));
    }
    return overrides;
}

Scene scene_of(const Arguments& arguments, Purpose purpose, const Overrides& more = {})
{
    Overrides overrides = overrides_of(arguments.sets);
    overrides.insert(overrides.end(), more.begin(), more.end());
    Scene scene = read_scene(arguments.scene, overrides, purpose);
    if (!arguments.directory.empty())
        scene.output_directory = arguments.directory;
    if (Communicator().root() && more.empty())
        for (const std::string& warning : scene.warnings)
            std::cerr << "gapflow: warning: " << warning << '\n';
    return scene;
}

int run(const Arguments& arguments)
{
    return run_command(scene_of(arguments, Purpose::run), {arguments.quiet, arguments.resume, arguments.force});
}

int converge(Arguments& arguments)
{
    arguments.converge.quiet = arguments.quiet;
    return converge_command([&](const Overrides& more) { return scene_of(arguments, Purpose::run, more); }, arguments.converge);
}

int sweep(Arguments& arguments)
{
    SweepOptions& options = arguments.sweep;
    options.scene = arguments.scene;
    options.sets = arguments.sets;
    options.quiet = arguments.quiet;
    return sweep_command([&](const Overrides& more) { return scene_of(arguments, Purpose::run, more); }, options);
}

int keys(const Arguments& arguments)
{
    const std::string text = arguments.names ? key_names() : key_list(arguments.table);
    if (text.empty()) {
        const std::string near = nearest_key(arguments.table, scene_keys());
        throw InputError("'" + arguments.table + "' is neither a key nor a table of scenes" +
                         (near.empty() ? "" : "; did you mean '" + near + "'?"));
    }
    if (Communicator().root())
        std::cout << text;
    return 0;
}

/// The command line under construction; `action` becomes the chosen subcommand.
struct CommandLine {
    CLI::App& app;
    Arguments& arguments;
    std::function<int()>& action;

    CLI::App* add(const std::string& name, const std::string& what, std::function<int()> does) const
    {
        CLI::App* command = app.add_subcommand(name, what);
        command->callback([&chosen = action, does] { chosen = does; });
        return command;
    }
    CLI::App* add_of_scene(const std::string& name, const std::string& what, std::function<int()> does) const
    {
        CLI::App* command = add(name, what, std::move(does));
        command->add_option("scene", arguments.scene, "Scene file (TOML)")->required()->type_name("SCENE.toml");
        command->add_option("--set", arguments.sets, "Replace a value of the scene, as domain.cells=[64,64]; may be repeated")
            ->allow_extra_args(false)
            ->type_name("key=value");
        return command;
    }
};

void add_run(const CommandLine& line)
{
    Arguments& arguments = line.arguments;
    CLI::App* run_app = line.add_of_scene("run", "Run a scene to its end", [&arguments] { return run(arguments); });
    run_app->add_option("-o,--output", arguments.directory, "Folder for the run's files, instead of output.directory")
        ->type_name("DIR");
    run_app
        ->add_option("--resume", arguments.resume,
                     "Continue from a checkpoint.h5; tables and fields in the output folder are cut back to it first")
        ->type_name("FILE");
    run_app->add_flag("--force", arguments.force, "Replace the files of another scene's run in the output folder");
    run_app->add_flag("-q,--quiet", arguments.quiet, "Only warnings and errors");
    run_app->footer(
        "Writes checkpoint.h5 at the end, every output.checkpoint_every of simulated time, and when interrupted: Ctrl-C "
        "and SIGTERM end the run after the current step (a second one at once). With --resume only title, time, "
        "solver, output, probe, flux and domain.leaving may differ from the scene that the checkpoint is of. A folder that "
        "holds the run of another "
        "scene is refused without --force; a run of the same scene file there is replaced.");
}

void add_check_and_added_mass(const CommandLine& line)
{
    Arguments& arguments = line.arguments;
    CLI::App* check = line.add_of_scene("check", "Validate a scene; print cells, unknowns and expected memory", [&arguments] {
        return check_command(scene_of(arguments, Purpose::check), arguments.parts_file);
    });
    check
        ->add_option(
            "--parts", arguments.parts_file,
            "With gap.model = \"parts\": write the fluid's parts as polygons (3D: polyhedra, of cut cells alone) with data")
        ->type_name("FILE.vtu");
    check->footer("Data of --parts: kind 0 whole cell, 1 cut, 2 thin: walls that face each other are less than a cell apart; "
                  "part, its number "
                  "in the cell, 0 the largest; parts of the cell; open, the part's share of the cell; thickness of a thin "
                  "part, its volume over "
                  "the area with which walls face each other, half of sum |S| - |sum S|, S the area vector of each connected "
                  "wall; walls, how many solids bound "
                  "it; first_wall and second_wall, the solids with the largest walls: bodies as in the scene from 0 on, then "
                  "closed sides.");

    CLI::App* mass = line.add_of_scene(
        "added-mass", "Added-mass matrix of all bodies that are not fixed, at the scene's poses", [&arguments] {
            return added_mass_command(scene_of(arguments, Purpose::added_mass), arguments.json, arguments.accelerations);
        });
    mass->add_flag("--json", arguments.json, "Print JSON");
    mass->add_flag(
        "--accelerations", arguments.accelerations,
        "Also the free bodies' first accelerations when everything starts from rest, by gravity, forces and springs");
}

void add_converge(const CommandLine& line)
{
    Arguments& arguments = line.arguments;
    CLI::App* converge_app =
        line.add_of_scene("converge", "Run a scene on several grids; errors and observed orders of its motion",
                          [&arguments] { return converge(arguments); });
    ConvergeOptions& options = arguments.converge;
    converge_app->add_option("--cells", options.cells, "Cells along x of each run, as 32,64,128; others in proportion")
        ->required()
        ->type_name("LIST");
    converge_app
        ->add_option("--reference", options.reference,
                     "Table to compare with: a line of column names, one of them time; without it, the finest run")
        ->type_name("FILE.csv");
    converge_app
        ->add_option("--quantity", options.quantities,
                     "What to compare: BODY.COLUMN of bodies.csv, as upper.y, FLUX.COLUMN of fluxes.csv, as port.flux, or "
                     "BODY-BODY.COLUMN of gaps.csv, as "
                     "lower-upper.thickness; may be repeated; without it, positions and velocities of all free bodies")
        ->allow_extra_args(false)
        ->type_name("NAME");
    converge_app
        ->add_option("--column", options.columns, "Column of the reference for a quantity, as upper.vy=speed; may be repeated")
        ->allow_extra_args(false)
        ->type_name("QUANTITY=NAME");
    converge_app->add_option("--window", options.window, "Times to compare over, as 0,0.5")->type_name("FROM,TO");
    converge_app
        ->add_option("-o,--output", arguments.directory, "Folder for the runs and the table, instead of output.directory")
        ->type_name("DIR");
    converge_app->add_flag("-q,--quiet", arguments.quiet, "No progress, only the table");
    converge_app->footer(
        "Runs with domain.cells in proportion, time.max_step and time.gap_cfl scaled with the spacing, into "
        "folders cells_N; writes converge.csv and converge.json. Errors are divided by the reference's range.");
}

void add_sweep(const CommandLine& line)
{
    Arguments& arguments = line.arguments;
    CLI::App* sweep_app =
        line.add_of_scene("sweep", "Run a scene with many values of some keys, several runs at once, into one table",
                          [&arguments] { return sweep(arguments); });
    SweepOptions& options = arguments.sweep;
    sweep_app
        ->add_option(
            "--vary", options.vary,
            "Values of a key: FROM:TO:COUNT evenly spaced, FROM:TO:COUNT:log in equal ratios, or a list, as "
            "body.ball.density=1:10:5, fluid.viscosity=1e-3:1:4:log, gap.model=film,none; may be repeated: every combination")
        ->required()
        ->allow_extra_args(false)
        ->type_name("key=VALUES");
    sweep_app->add_flag("--zip", options.zip,
                        "The first values of all keys in one run, the second ones in the next, and so on");
    sweep_app->add_option("-j,--jobs", options.jobs, "Runs at once, instead of as many as the machine has cores and memory for")
        ->check(CLI::Range(1, 4096))
        ->type_name("N");
    sweep_app
        ->add_option("--quantity", options.quantities,
                     "What the table holds: BODY.COLUMN of bodies.csv, as ball.y, FLUX.COLUMN of fluxes.csv, as port.flux, or "
                     "BODY-BODY.COLUMN of gaps.csv, as "
                     "ball-wall:y_low.force; may be repeated; without it motion of and forces on bodies, thickness of and "
                     "forces in gaps, fluxes")
        ->allow_extra_args(false)
        ->type_name("NAME");
    sweep_app
        ->add_option("--window", options.window,
                     "Times of last, mean, smallest and largest values, as 0.5,1; the whole run without it")
        ->type_name("FROM,TO");
    sweep_app->add_option("-o,--output", arguments.directory, "Folder for the runs and the table, instead of output.directory")
        ->type_name("DIR");
    sweep_app->add_flag("-q,--quiet", arguments.quiet, "No progress, only the table, warnings and errors");
    sweep_app->footer(
        "Each run is a process, with its files in run_001, run_002, ... and what it prints in run_001.log, ...; sweep.csv has "
        "a "
        "row a run. Ctrl-C ends the runs after their current step. The same command again goes on: runs that are done "
        "are kept, others continue from their checkpoints. Exit status 1 if a run failed; the others are done all the same.");
}

void add_keys_and_generate(const CommandLine& line)
{
    Arguments& arguments = line.arguments;
    CLI::App* keys_app = line.add("keys", "List the keys of scene files: meaning, allowed values, default",
                                  [&arguments] { return keys(arguments); });
    keys_app->add_option("table", arguments.table, "Only this table or key, as gap or body.spring")->type_name("TABLE");
    keys_app->add_flag("--names", arguments.names, "Names alone, as --set takes them");

    CLI::App* generate =
        line.add("generate", "Print a man page, a reference page or a shell's completion, made from this command's own tables",
                 [&arguments, &app = line.app] {
                     on_root(Communicator(), [&] {
                         const std::string text = describe(app, arguments.kind, GAPFLOW_VERSION);
                         if (arguments.directory.empty())
                             std::cout << text;
                         else
                             write_atomically(arguments.directory, text);
                     });
                     return 0;
                 });
    generate->group(""); // for the build and the docs, not in --help
    generate->add_option("-o,--output", arguments.directory);
    generate->add_option("kind", arguments.kind)
        ->required()
        ->check(CLI::IsMember(std::vector<std::string>(std::begin(description_kinds), std::end(description_kinds))));
}

void add_report(const CommandLine& line)
{
    Arguments& arguments = line.arguments;
    CLI::App* report = line.add(
        "report", "One HTML page of a run, or of several beside each other, with plots and a view to play; or pictures",
        [&arguments] { return report_command(arguments.report); });
    report
        ->add_option("directory", arguments.report.folders,
                     "Folder of a run or of a sweep; several runs: one page to compare them")
        ->required()
        ->type_name("DIR");
    CLI::Option* page = report
                            ->add_option("-o,--output", arguments.report.page,
                                         "The page, instead of DIR/report.html, or comparison.html of several runs")
                            ->type_name("FILE.html");
    report->add_flag("-q,--quiet", arguments.report.quiet, "Only warnings and errors");
    report->add_flag("--png", arguments.report.png, "Key frames as pictures DIR/frames/*.png instead of a page")
        ->excludes(page);
    report->footer("Reads the files written so far, also of a run that is in progress or was stopped. The page needs no "
                   "network.");
}

int report_error(const std::string& message, int status)
{
    if (Communicator().root())
        std::cerr << "gapflow: error: " << message << std::endl;
    return status;
}

/// Message about an invalid command line; CLI11 alone would not name a misspelt command.
std::string usage_problem(const CLI::App& app, const CLI::ParseError& error)
{
    if (!app.get_subcommands().empty() || app.remaining().empty())
        return error.what();
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(command->get_name());
    const std::string near = nearest_name(app.remaining().front(), names);
    return "unknown command '" + app.remaining().front() + "'" + (near.empty() ? "" : ", did you mean '" + near + "'?");
}

int command(int argc, char** argv, std::vector<std::string> environment)
{
    CLI::App app("Gapflow: rigid bodies in incompressible flow, two-way coupled through thin gaps", "gapflow");
    app.set_version_flag("--version", "gapflow " GAPFLOW_VERSION);
    app.require_subcommand(1);
    app.footer("Exit status: 0 done, 1 the computation failed, 2 bad usage or bad scene, 130 or 143 interrupted.");
    Arguments arguments;
    arguments.sweep.environment = std::move(environment);
    std::function<int()> action;
    const CommandLine line{app, arguments, action};
    add_run(line);
    add_check_and_added_mass(line);
    add_converge(line);
    add_sweep(line);
    add_keys_and_generate(line);
    add_report(line);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& e) { // --help, --version
        return Communicator().root() ? app.exit(e) : 0;
    } catch (const CLI::ParseError& e) {
        return report_error(usage_problem(app, e) + "; `gapflow --help` and `gapflow COMMAND --help` tell the usage",
                            bad_input);
    }
    return action();
}

} // namespace

} // namespace gapflow

int main(int argc, char** argv)
{
    using namespace gapflow;
    let_threads_sleep(argv);
    std::signal(SIGXFSZ, SIG_IGN);                                // a file beyond its size limit is an error of the write
    std::vector<std::string> variables = environment_variables(); // before MPI adds to them
    const Environment environment;
    try {
        return command(argc, argv, std::move(variables));
    } catch (const InputError& e) {
        return report_error(e.what(), bad_input);
    } catch (const ComputationError& e) {
        return report_error(e.what(), failed);
    } catch (const std::exception& e) {
        return report_error(std::string("internal error: ") + e.what() + "; please report this with the scene", failed);
    }
}
