#include "gapflow/output/run_record.hpp"

#include "gapflow/core/threads.hpp"
#include "gapflow/output/file.hpp"

#include <nlohmann/json.hpp>

#include <fstream>
#include <thread>

#include <sys/resource.h>

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

} // namespace

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
