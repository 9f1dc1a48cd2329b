#include "gapflow/output/sweep_record.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/output/file.hpp"

#include <nlohmann/json.hpp>

#include <fstream>

namespace gapflow {

using Json = nlohmann::ordered_json;

void write_sweep_record(const std::filesystem::path& folder, const SweepRecord& record)
{
    Json json{{"scene", record.scene}, {"runs", Json::array()}};
    for (const SweepRecord::Run& run : record.runs) {
        Json values = Json::object();
        for (const auto& [key, value] : run.values)
            values[key] = value;
        json["runs"].push_back({{"folder", run.folder}, {"values", values}});
    }
    write_atomically(folder / "sweep.json", json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::optional<SweepRecord> read_sweep_record(const std::filesystem::path& folder)
{
    std::ifstream in(folder / "sweep.json");
    if (!in)
        return std::nullopt;
    try {
        const Json json = Json::parse(in);
        SweepRecord record{json.at("scene").get<std::string>(), {}};
        for (const Json& entry : json.at("runs")) {
            SweepRecord::Run run{entry.at("folder").get<std::string>(), {}};
            for (const auto& [key, value] : entry.at("values").items())
                run.values.emplace_back(key, value.get<std::string>());
            record.runs.push_back(std::move(run));
        }
        return record;
    } catch (const Json::exception& error) {
        throw InputError((folder / "sweep.json").string() + ": not the record of a sweep (" + error.what() +
                         "); start `gapflow sweep` into this folder again");
    }
}

} // namespace gapflow
