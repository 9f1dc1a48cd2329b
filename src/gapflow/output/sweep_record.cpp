#include "gapflow/output/sweep_record.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/output/file.hpp"
#include "gapflow/output/stored_run.hpp"

#include <nlohmann/json.hpp>

#include <fstream>
#include <limits>

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

SweepResults read_sweep_results(const std::filesystem::path& folder, const SweepRecord& record)
{
    SweepResults results;
    for (const SweepRecord::Run& run : record.runs)
        for (std::size_t k = 0; k < run.values.size(); ++k) {
            if (results.keys.size() <= k)
                results.keys.emplace_back(run.values[k].first, std::vector<std::string>());
            results.keys[k].second.push_back(run.values[k].second);
        }
    const RunTable table = read_table(folder / "sweep.csv", {"folder"});
    const std::vector<std::string>& folders = table.text("folder");
    for (std::size_t i = 0; i < folders.size(); ++i)
        if (i >= record.runs.size() || folders[i] != record.runs[i].folder)
            throw InputError((folder / "sweep.csv").string() +
                             ": has other runs than sweep.json; start `gapflow sweep` into this folder again");
    const auto column = [&](const std::string& name) {
        std::vector<double> values = table.number(name);
        values.resize(record.runs.size(), std::numeric_limits<double>::quiet_NaN());
        return values;
    };
    const std::string ending = ".last";
    for (const auto& [name, values] : table.numbers)
        if (name.ends_with(ending)) {
            const std::string of = name.substr(0, name.size() - ending.size());
            results.quantities.push_back({of, column(name), column(of + ".mean"), column(of + ".min"), column(of + ".max")});
        }
    return results;
}

} // namespace gapflow
