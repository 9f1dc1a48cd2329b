// gapflow sweep: a scene with many values of some keys, a process a run, and one table of what came out.
//
// The folder of a run is its record: a sweep that is started again keeps those that are done, goes on from checkpoints and starts the others.
#include "child_process.hpp"
#include "commands.hpp"
#include "variation.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/core/logging.hpp"
#include "gapflow/core/machine_memory.hpp"
#include "gapflow/core/text.hpp"
#include "gapflow/output/file.hpp"
#include "gapflow/output/quantity.hpp"
#include "gapflow/output/scene_difference.hpp"
#include "gapflow/output/sweep_record.hpp"
#include "gapflow/output/table.hpp"
#include "gapflow/stepping/memory_forecast.hpp"
#include "gapflow/stepping/setup.hpp"
#include "gapflow/stepping/thickness_check.hpp"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <fstream>
#include <map>
#include <thread>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

namespace gapflow {

namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

volatile std::sig_atomic_t signal_to_pass = 0, signal_count = 0;

void count_signal(int signal)
{
    signal_to_pass = signal;
    signal_count = signal_count + 1;
}

struct SweepRun {
    std::string folder, full_folder; ///< within the sweep's folder; the path
    std::vector<std::pair<std::string, std::string>> values;
    std::string scene; ///< resolved
    double end = 0;
    enum class Status { waiting, running, done, failed, interrupted } status = Status::waiting;
    bool resumes = false;
    int process = 0;
    std::string message;
    long steps = 0, warnings = 0;
    double time = 0, seconds = 0;
    std::vector<std::pair<std::string, Statistics>> results;
};

const char* word(SweepRun::Status status)
{
    return std::array{"waiting", "running", "done", "failed", "interrupted"}[static_cast<int>(status)];
}

std::string values_text(const SweepRun& run)
{
    std::vector<std::string> parts;
    for (const auto& [key, value] : run.values)
        parts.push_back(key + " = " + value);
    return joined(parts);
}

/// Holds a folder for one sweep at a time, until the process ends.
class FolderLock {
public:
    explicit FolderLock(const fs::path& folder)
        : descriptor_(::open((folder / "sweep.lock").c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666))
    {
        if (descriptor_ < 0)
            throw_file_error(folder / "sweep.lock", "cannot open", errno);
        if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0)
            throw InputError(folder.string() +
                             ": another sweep is running here; wait until it has ended, or choose another folder (-o DIR)");
    }
    ~FolderLock() { ::close(descriptor_); }
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

private:
    int descriptor_;
};

/// run.json, or null where there is none that can be read.
Json record_of(const SweepRun& run)
{
    std::ifstream in(fs::path(run.full_folder) / "run.json");
    Json record = in ? Json::parse(in, nullptr, false) : Json();
    return record.is_object() && record.contains("scene") && record["scene"].is_string() ? record : Json();
}

/// What the folder of a run holds already. Throws InputError where that is a run of another scene.
void look_up(SweepRun& run)
{
    const Json record = record_of(run);
    if (record.is_null())
        return;
    const std::string other = scene_difference(record["scene"].get<std::string>(), run.scene, {"title", "output"});
    if (!other.empty())
        throw InputError(run.full_folder + ": holds a run of another scene (" + other +
                         "); choose another folder (-o DIR), or remove that one");
    if (record.value("status", "") == "done") {
        run.status = SweepRun::Status::done;
        return;
    }
    std::error_code error;
    run.resumes = fs::exists(fs::path(run.full_folder) / "checkpoint.h5", error);
}

/// The last error that a process printed.
std::string error_in(const fs::path& log)
{
    std::ifstream in(log);
    const std::string mark = "gapflow: error: ";
    std::string line, message;
    while (std::getline(in, line))
        if (line.starts_with(mark))
            message = line.substr(mark.size());
        else if (!trimmed(line).empty() && message.empty())
            message = line;
    return message;
}

/// Reads what a run that has ended left: record and quantities.
void read_results(SweepRun& run, const std::vector<Quantity>& asked, const std::optional<TimeWindow>& window)
{
    const Json record = record_of(run);
    if (record.is_null())
        return;
    run.steps = record.value("steps", 0L);
    run.time = record.value("time", 0.0);
    run.warnings = record.contains("warnings") ? static_cast<long>(record["warnings"].size()) : 0;
    if (record.contains("timings"))
        run.seconds = record["timings"].value("total_seconds", 0.0);
    run.results.clear();
    const StoredRun stored = read_run(run.full_folder);
    for (const Quantity& quantity : asked.empty() ? key_quantities(stored) : asked)
        if (const auto statistics = statistics_of(stored, quantity, window.value_or(TimeWindow{0, run.end})))
            run.results.emplace_back(quantity.name, *statistics);
}

std::string csv_of(const std::vector<SweepRun>& runs)
{
    std::vector<std::string> names; // of quantities, in the order in which runs have them
    for (const SweepRun& run : runs)
        for (const auto& [name, statistics] : run.results)
            if (std::find(names.begin(), names.end(), name) == names.end())
                names.push_back(name);
    std::vector<std::string> header{"run", "folder"};
    for (const auto& [key, value] : runs[0].values)
        header.push_back(key);
    for (const char* column : {"status", "message", "warnings", "steps", "time", "seconds"})
        header.emplace_back(column);
    for (const std::string& name : names)
        for (const char* of : {".last", ".mean", ".min", ".max"})
            header.push_back(name + of);
    const auto line = [](const std::vector<std::string>& cells) {
        std::vector<std::string> quoted;
        for (const std::string& cell : cells)
            quoted.push_back(csv_cell(cell));
        return joined(quoted, ",") + "\n";
    };
    std::string csv = line(header);
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const SweepRun& run = runs[i];
        std::vector<std::string> cells{std::to_string(i + 1), run.folder};
        for (const auto& [key, value] : run.values)
            cells.push_back(value);
        for (const std::string& cell : {std::string(word(run.status)), run.message, std::to_string(run.warnings),
                                        std::to_string(run.steps), number_text(run.time), number_text(run.seconds)})
            cells.push_back(cell);
        for (const std::string& name : names) {
            const auto found =
                std::find_if(run.results.begin(), run.results.end(), [&](const auto& r) { return r.first == name; });
            if (found == run.results.end())
                cells.insert(cells.end(), 4, "");
            else
                for (const double value : {found->second.last, found->second.mean, found->second.low, found->second.high})
                    cells.push_back(number_text(value));
        }
        csv += line(cells);
    }
    return csv;
}

/// The table that a user reads: values, status, and the quantities asked for.
std::string text_of(const std::vector<SweepRun>& runs, const std::vector<Quantity>& asked)
{
    std::vector<std::vector<std::string>> table(1, {"folder"});
    for (const auto& [key, value] : runs[0].values)
        table[0].push_back(key);
    for (const char* column : {"status", "steps", "time", "seconds"})
        table[0].emplace_back(column);
    for (const Quantity& quantity : asked)
        table[0].insert(table[0].end(), {quantity.name + " last", "mean"});
    for (const SweepRun& run : runs) {
        std::vector<std::string>& row = table.emplace_back(1, run.folder);
        for (const auto& [key, value] : run.values)
            row.push_back(value);
        row.insert(row.end(), {word(run.status), std::to_string(run.steps), fmt::format("{:.4g}", run.time),
                               fmt::format("{:.1f}", run.seconds)});
        for (const Quantity& quantity : asked) {
            const auto found =
                std::find_if(run.results.begin(), run.results.end(), [&](const auto& r) { return r.first == quantity.name; });
            for (const bool last : {true, false})
                row.push_back(
                    found == run.results.end() ? "-" : fmt::format("{:.6g}", last ? found->second.last : found->second.mean));
        }
    }
    std::vector<std::size_t> widths(table[0].size(), 0);
    for (const auto& row : table)
        for (std::size_t c = 0; c < row.size(); ++c)
            widths[c] = std::max(widths[c], row[c].size());
    std::string text;
    for (const auto& row : table) {
        std::string line;
        for (std::size_t c = 0; c < row.size(); ++c)
            line += fmt::format("{}{:>{}}", c > 0 ? "  " : "", row[c], widths[c]);
        text += line + "\n";
    }
    return text;
}

/// Processes at once: as many as asked for, else as many as the machine has cores and memory for.
int jobs_for(const std::vector<Scene>& scenes, std::size_t waiting, int asked, const Logger& log)
{
    const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    int jobs = asked > 0 ? asked : cores;
    if (asked == 0) {
        double largest = 0;
        for (const Scene& scene : scenes)
            largest = std::max(largest, forecast_memory(scene, 0, 0));
        const double fit = std::floor(machine_memory() / largest);
        if (fit < jobs) {
            jobs = std::max(1, static_cast<int>(fit));
            log.warning(
                fmt::format("{} run(s) at once: a run needs about {:.3g} GiB, and there is memory for no more; --jobs N "
                            "chooses another number",
                            jobs, largest / 1073741824.0));
        }
    }
    return std::min(jobs, static_cast<int>(std::max<std::size_t>(waiting, 1)));
}

/// The environment of a run: this one's, with its share of the cores.
std::vector<std::string> environment_of(const std::vector<std::string>& own, int jobs)
{
    std::vector<std::string> variables = own;
    if (std::none_of(own.begin(), own.end(), [](const std::string& v) { return v.starts_with("OMP_NUM_THREADS="); }))
        variables.push_back("OMP_NUM_THREADS=" +
                            std::to_string(std::max(1, static_cast<int>(std::thread::hardware_concurrency()) / jobs)));
    return variables;
}

class Sweep {
public:
    Sweep(std::vector<SweepRun> runs, const SweepOptions& options, std::string folder, std::vector<Quantity> asked,
          std::optional<TimeWindow> window, const Logger& log)
        : runs_(std::move(runs)), options_(options), folder_(std::move(folder)), asked_(std::move(asked)), window_(window),
          log_(log)
    {
    }

    const std::vector<SweepRun>& runs() const { return runs_; }

    /// Runs all that are not done; after a signal those that run end and no more start.
    void operator()(int jobs)
    {
        for (SweepRun& run : runs_)
            if (run.status == SweepRun::Status::done)
                read_results(run, asked_, window_);
        write();
        const std::vector<std::string> environment = environment_of(options_.environment, jobs);
        int running = 0, passed_on = 0;
        auto next = runs_.begin();
        while (true) {
            for (; next != runs_.end() && running < jobs && signal_count == 0; ++next)
                if (next->status == SweepRun::Status::waiting) {
                    start(*next, environment);
                    ++running;
                }
            if (running == 0)
                return;
            for (; passed_on < signal_count; ++passed_on)
                for (const SweepRun& run : runs_)
                    if (run.status == SweepRun::Status::running)
                        ::kill(run.process, signal_to_pass);
            int status = 0;
            const pid_t ended = ::waitpid(-1, &status, WNOHANG);
            if (ended <= 0) {
                std::this_thread::sleep_for(std::chrono::milliseconds(20));
                continue;
            }
            const auto run = std::find_if(runs_.begin(), runs_.end(), [&](const SweepRun& r) {
                return r.process == ended && r.status == SweepRun::Status::running;
            });
            if (run == runs_.end())
                continue; // of something else
            --running;
            take_up(*run, status);
        }
    }

private:
    std::string log_of(const SweepRun& run) const { return run.full_folder + ".log"; }

    void start(SweepRun& run, const std::vector<std::string>& environment)
    {
        std::vector<std::string> words{"run", options_.scene, "-o", run.full_folder, "--quiet"};
        for (const std::string& set : options_.sets)
            words.insert(words.end(), {"--set", set});
        for (const auto& [key, value] : run.values)
            words.insert(words.end(), {"--set", key + "=" + value});
        if (run.resumes)
            words.insert(words.end(), {"--resume", run.full_folder + "/checkpoint.h5"});
        else if (!record_of(run).is_null())
            fs::remove_all(run.full_folder); // of a run that stopped before its first checkpoint
        run.process = start_program(words, environment, log_of(run));
        run.status = SweepRun::Status::running;
    }

    void take_up(SweepRun& run, int status)
    {
        const bool ended = WIFEXITED(status);
        const int code = ended ? WEXITSTATUS(status) : 0;
        if (ended && code == 0) {
            run.status = SweepRun::Status::done;
        } else if (signal_count > 0 && (!ended || code > 128)) {
            run.status = SweepRun::Status::interrupted;
        } else {
            run.status = SweepRun::Status::failed;
            run.message = ended ? error_in(log_of(run)) : fmt::format("ended by signal {}", WTERMSIG(status));
        }
        try {
            read_results(run, asked_, window_);
        } catch (const InputError& error) { // a damaged table must not end the others
            run.status = SweepRun::Status::failed;
            run.message = error.what();
        }
        write();
        const std::string text = fmt::format("{} {} ({}): {} steps to time {:.6g}, {:.1f} s", run.folder, word(run.status),
                                             values_text(run), run.steps, run.time, run.seconds);
        if (run.status == SweepRun::Status::failed)
            log_.warning(text + "; " + run.message);
        else
            log_.info(text);
    }

    void write() const { write_atomically(fs::path(folder_) / "sweep.csv", csv_of(runs_)); }

    std::vector<SweepRun> runs_;
    const SweepOptions& options_;
    const std::string folder_;
    const std::vector<Quantity> asked_;
    const std::optional<TimeWindow> window_;
    const Logger& log_;
};

void demand_no_mpirun(const SweepOptions& options)
{
    const bool under_mpirun = std::any_of(options.environment.begin(), options.environment.end(),
                                          [](const std::string& v) { return v.starts_with("OMPI_COMM_WORLD_SIZE="); });
    if (under_mpirun || Communicator().size() > 1)
        throw InputError(
            "sweep: starts its runs itself, as processes of one rank each; call it without mpirun, and choose with --jobs "
            "how many run at once");
}

} // namespace

int sweep_command(const SceneReader& read, const SweepOptions& options)
{
    demand_no_mpirun(options);
    const Communicator comm;
    const Logger log(comm, options.quiet);
    std::vector<Variation> variations;
    for (const std::string& text : options.vary)
        variations.push_back(read_variation(text));
    const auto values = combinations(variations, options.zip);

    // All scenes first: a value out of range is reported before anything runs.
    std::vector<Scene> scenes;
    for (const auto& of_run : values) {
        scenes.push_back(read(of_run));
        require_memory(scenes.back(), comm);
        require_thickness(scenes.back());
    }
    std::vector<Quantity> asked;
    for (const std::string& name : options.quantities)
        asked.push_back(quantity_of(name, scenes[0]));
    double shortest_end = scenes[0].end;
    for (const Scene& scene : scenes)
        shortest_end = std::min(shortest_end, scene.end);
    std::optional<TimeWindow> window;
    if (!options.window.empty())
        window = window_of(options.window, shortest_end);
    const std::string folder = scenes[0].output_directory;
    const auto digits = std::max<std::size_t>(3, std::to_string(values.size()).size());
    std::vector<SweepRun> runs;
    for (std::size_t i = 0; i < values.size(); ++i) {
        SweepRun run;
        run.folder = fmt::format("run_{:0{}}", i + 1, digits);
        run.full_folder = folder + "/" + run.folder;
        run.values = values[i];
        run.scene = scene_as_json(scenes[i]);
        run.end = scenes[i].end;
        runs.push_back(std::move(run));
    }
    prepare_folder(folder);
    const FolderLock lock(folder);
    for (SweepRun& run : runs)
        look_up(run);
    SweepRecord record{options.scene, {}};
    for (const SweepRun& run : runs)
        record.runs.push_back({run.folder, run.values});
    write_sweep_record(folder, record);

    const auto count = [](const std::vector<SweepRun>& all, SweepRun::Status status) {
        return static_cast<std::size_t>(
            std::count_if(all.begin(), all.end(), [&](const SweepRun& r) { return r.status == status; }));
    };
    const std::size_t kept = count(runs, SweepRun::Status::done);
    const int jobs = jobs_for(scenes, runs.size() - kept, options.jobs, log);
    const auto resumed = std::count_if(runs.begin(), runs.end(), [](const SweepRun& r) { return r.resumes; });
    log.info(fmt::format("{} runs into {}{}{}, {} at once", runs.size(), folder,
                         kept > 0 ? fmt::format(", {} of them done before", kept) : "",
                         resumed > 0 ? fmt::format(", {} go on from checkpoints", resumed) : "", jobs));
    std::signal(SIGINT, count_signal);
    std::signal(SIGTERM, count_signal);
    Sweep sweep(std::move(runs), options, folder, asked, window, log);
    sweep(jobs);

    std::fputs(text_of(sweep.runs(), asked).c_str(), stdout);
    std::fflush(stdout); // before what goes to the log, where both go to one file
    log.info(fmt::format("files: {0}/sweep.csv; beside each other in one page: gapflow report {0}", folder));
    std::size_t failed = count(sweep.runs(), SweepRun::Status::failed);
    for (const SweepRun& run : sweep.runs())
        if (run.status == SweepRun::Status::failed)
            log.error(fmt::format("{} failed: {}; what it printed: {}.log", run.full_folder, run.message, run.full_folder));
    if (count(sweep.runs(), SweepRun::Status::done) + failed < sweep.runs().size()) {
        log.warning(fmt::format("interrupted: {} of {} runs are done; the same command goes on with the others",
                                count(sweep.runs(), SweepRun::Status::done), sweep.runs().size()));
        return 128 + signal_to_pass;
    }
    return failed > 0 ? 1 : 0;
}

} // namespace gapflow
