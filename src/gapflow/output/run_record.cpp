#include "gapflow/output/run_record.hpp"

#include "gapflow/core/threads.hpp"
#include "gapflow/output/file.hpp"

#include <nlohmann/json.hpp>

#include <chrono>
#include <ctime>
#include <fstream>
#include <iterator>
#include <sstream>
#include <thread>

#include <sys/resource.h>
#include <unistd.h>

namespace gapflow {

namespace {

std::string cpu_name()
{
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);) {
        const auto colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos)
            return line.substr(colon + 2);
    }
    return "unknown";
}

std::string host_name()
{
    char name[256] = "";
    gethostname(name, sizeof name - 1);
    return name;
}

// When a process of this host started, in clock ticks since the host's start (proc(5), field 22 of stat); 0: it is gone. What has ended but still
// waits for its parent is gone.
std::int64_t start_of_process(long id)
{
    std::ifstream in("/proc/" + std::to_string(id) + "/stat");
    std::string text{std::istreambuf_iterator<char>(in), {}};
    const auto name_end = text.rfind(')'); // the name may hold blanks
    if (name_end == std::string::npos)
        return 0;
    std::istringstream fields(text.substr(name_end + 1));
    std::string state, skipped;
    fields >> state;
    for (int field = 4; field < 22; ++field)
        fields >> skipped;
    std::int64_t start = 0;
    fields >> start;
    return state == "Z" || state == "X" ? 0 : start;
}

std::int64_t seconds_now()
{
    return std::chrono::duration_cast<std::chrono::seconds>(std::chrono::system_clock::now().time_since_epoch()).count();
}

std::string utc_text(std::int64_t seconds)
{
    const std::time_t time = static_cast<std::time_t>(seconds);
    std::tm parts{};
    gmtime_r(&time, &parts);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
    return text;
}

constexpr std::int64_t silent_seconds = 600; // without a sign of life from another host

RunState state_of(const std::string& status, const ProcessMark& process, bool here)
{
    if (status == "done")
        return RunState::done;
    if (status == "failed")
        return RunState::failed;
    if (status == "interrupted")
        return RunState::interrupted;
    if (status != "running")
        return RunState::unknown;
    if (process.id == 0) // of a version that did not record it
        return RunState::killed;
    const bool alive = here ? start_of_process(process.id) == process.started && process.started != 0
                            : seconds_now() - process.heartbeat < silent_seconds;
    return alive ? RunState::running : RunState::killed;
}

} // namespace

ProcessMark current_process()
{
    const long id = getpid();
    return {id, host_name(), start_of_process(id), seconds_now()};
}

std::optional<RecordedRun> read_recorded_run(const std::filesystem::path& path)
{
    std::ifstream in(path);
    const nlohmann::json json = nlohmann::json::parse(in, nullptr, false);
    if (!json.is_object())
        return {};
    RecordedRun run;
    try {
        run.scene = json.value("scene", "");
        run.scene_file = json.value("scene_file", "");
        run.time = json.value("time", 0.0);
        run.steps = json.value("steps", 0L);
        if (const auto process = json.find("process"); process != json.end()) {
            run.process.id = process->value("id", 0L);
            run.process.host = process->value("host", "");
            run.process.started = process->value("started", std::int64_t{0});
            run.process.heartbeat = process->value("heartbeat", std::int64_t{0});
        }
        run.here = run.process.host == host_name();
        run.state = state_of(json.value("status", ""), run.process, run.here);
        const nlohmann::json scene = nlohmann::json::parse(run.scene, nullptr, false);
        run.title = scene.is_object() ? scene.value("title", "") : "";
    } catch (const nlohmann::json::exception&) {
        return {};
    }
    return run;
}

Machine describe_machine(const Communicator& comm)
{
    return {cpu_name(), static_cast<int>(std::thread::hardware_concurrency()), comm.size(), thread_count()};
}

PeakMemory peak_memory(const Communicator& comm)
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const double bytes = 1024.0 * static_cast<double>(usage.ru_maxrss);
    return {comm.max(bytes), comm.sum(bytes)};
}

void write_run_record(const std::filesystem::path& path, const RunRecord& record)
{
    nlohmann::ordered_json json;
    json["version"] = record.version;
    json["status"] = record.status;
    if (!record.message.empty())
        json["message"] = record.message;
    if (!record.ended_by.empty())
        json["ended_by"] = record.ended_by;
    if (record.status == "running") {
        const ProcessMark process = current_process();
        json["process"] = {{"id", process.id},
                           {"host", process.host},
                           {"started", process.started},
                           {"heartbeat", process.heartbeat},
                           {"heartbeat_utc", utc_text(process.heartbeat)}};
    }
    json["warnings"] = record.warnings;
    json["time"] = record.time;
    json["steps"] = record.steps;
    json["machine"] = {{"cpu", record.machine.cpu},
                       {"cores", record.machine.cores},
                       {"ranks", record.machine.ranks},
                       {"threads", record.machine.threads}};
    json["timings"]["total_seconds"] = record.seconds;
    json["timings"]["stages"] = nlohmann::ordered_json::object();
    for (const auto& [name, stage] : record.stages)
        json["timings"]["stages"][name] = {{"seconds", stage.seconds}, {"count", stage.count}};
    json["peak_memory_bytes"] = {{"largest_rank", record.memory.largest_rank}, {"sum", record.memory.sum}};
    json["cells"] = record.cells;
    json["scene_file"] = record.scene_file;
    json["scene"] = record.scene;
    // Text that is not UTF-8 (a file name in the scene) must not prevent the record.
    write_atomically(path, json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

std::vector<std::string> warnings_of_record(const std::filesystem::path& path)
{
    std::ifstream in(path);
    const nlohmann::json json = nlohmann::json::parse(in, nullptr, false);
    const auto warnings = json.is_object() ? json.find("warnings") : json.end();
    if (!json.is_object() || warnings == json.end() || !warnings->is_array())
        return {};
    std::vector<std::string> texts;
    for (const nlohmann::json& warning : *warnings)
        if (warning.is_string())
            texts.push_back(warning.get<std::string>());
    return texts;
}

} // namespace gapflow
