#include "gapflow/output/stored_run.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/core/text.hpp"
#include "gapflow/output/npy_table.hpp"
#include "gapflow/output/pvd.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>

namespace gapflow {

namespace {

using Json = nlohmann::ordered_json;

std::string content_of(const std::filesystem::path& path)
{
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

// Cells of a line that Table wrote; a quoted one may hold commas and, doubled, quotes.
std::vector<std::string> cells_of(std::string_view line)
{
    std::vector<std::string> cells(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
            cells.back() += line[++i];
        else if (line[i] == '"')
            quoted = !quoted;
        else if (line[i] == ',' && !quoted)
            cells.emplace_back();
        else if (line[i] != '\r')
            cells.back() += line[i];
    }
    return cells;
}

// The next line, which may go on behind a line end inside quotes; empty at the end or where the last line is not complete.
std::string_view next_line(std::string_view& text)
{
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        quoted ^= text[i] == '"';
        if (text[i] == '\n' && !quoted) {
            const std::string_view line = text.substr(0, i);
            text.remove_prefix(i + 1);
            return line;
        }
    }
    text = {};
    return {};
}

// Frames in the order of gapflow.pvd; one whose time is there already joins that.
std::vector<RunFrame> read_frames(const std::filesystem::path& folder)
{
    std::vector<RunFrame> frames;
    const auto collection = PvdCollection::resume(folder / "gapflow.pvd");
    for (const PvdCollection::Entry& entry : collection.entries()) {
        std::error_code error;
        if (!std::filesystem::exists(folder / entry.file, error))
            continue;
        if (frames.empty() || frames.back().time != entry.time) {
            const int number = frame_number(entry.file).value_or(static_cast<int>(frames.size()));
            frames.push_back({number, entry.time, {}, {}, {}});
        }
        RunFrame& frame = frames.back();
        if (entry.file.starts_with("fields/"))
            frame.fields = entry.file;
        else if (entry.file.starts_with("films/"))
            frame.films = entry.file;
        else
            frame.bodies[entry.part] = entry.file;
    }
    return frames;
}

} // namespace

const std::vector<double>& RunTable::number(const std::string& column) const
{
    static const std::vector<double> none;
    const auto found = numbers.find(column);
    return found == numbers.end() ? none : found->second;
}

const std::vector<std::string>& RunTable::text(const std::string& column) const
{
    static const std::vector<std::string> none;
    const auto found = texts.find(column);
    return found == texts.end() ? none : found->second;
}

RunTable read_table(const std::filesystem::path& path, const std::vector<std::string>& texts)
{
    const std::string content = content_of(path);
    std::string_view text = content;
    RunTable table;
    const std::string_view header = next_line(text);
    if (header.empty())
        return table;
    const std::vector<std::string> names = cells_of(header);
    for (const std::string& name : names)
        if (name.starts_with("body") || name == "crowd" || name == "name" ||
            std::find(texts.begin(), texts.end(), name) != texts.end())
            table.texts[name];
        else
            table.numbers[name];
    for (long line = 2; !text.empty(); ++line) {
        const std::string_view row = next_line(text);
        if (row.empty())
            continue;
        const std::vector<std::string> cells = cells_of(row);
        if (cells.size() != names.size())
            throw InputError(path.string() + ":" + std::to_string(line) + ": has " + std::to_string(cells.size()) +
                             " columns, the first line names " + std::to_string(names.size()) + "; is it a table of a run?");
        for (std::size_t column = 0; column < cells.size(); ++column) {
            if (const auto found = table.texts.find(names[column]); found != table.texts.end())
                found->second.push_back(cells[column]);
            else
                table.numbers[names[column]].push_back(
                    parse_number(cells[column]).value_or(std::numeric_limits<double>::quiet_NaN()));
        }
        ++table.rows;
    }
    return table;
}

StoredRun read_run(const std::filesystem::path& folder)
{
    std::error_code error;
    if (!std::filesystem::is_directory(folder, error))
        throw InputError(folder.string() + ": no such folder; give the folder of a run, that of -o or output.directory");
    const std::filesystem::path record_file = folder / "run.json";
    if (!std::filesystem::exists(record_file, error))
        throw InputError(folder.string() +
                         ": not the folder of a run, it has no run.json; give that of -o or output.directory");
    StoredRun run;
    run.folder = folder;
    try {
        Json record = Json::parse(content_of(record_file));
        Json scene = Json::parse(record.at("scene").get<std::string>());
        run.dimension = static_cast<int>(scene.at("domain").at("size").size());
        record.erase("scene");
        run.record = std::make_shared<Json>(std::move(record));
        run.scene = std::make_shared<Json>(std::move(scene));
    } catch (const Json::exception& e) {
        throw InputError(record_file.string() + ": not the record of a Gapflow run (" + e.what() + ")");
    }
    if (run.dimension != 2 && run.dimension != 3)
        throw InputError(record_file.string() + ": a domain of " + std::to_string(run.dimension) + " dimensions");
    run.bodies = std::filesystem::exists(folder / "bodies.csv", error) ? read_table(folder / "bodies.csv")
                                                                       : read_npy(folder / "bodies.npy");
    run.crowds = read_table(folder / "crowds.csv");
    run.profiles = read_table(folder / "crowd_profiles.csv");
    run.gaps = read_table(folder / "gaps.csv");
    run.steps = read_table(folder / "steps.csv");
    run.fluxes = read_table(folder / "fluxes.csv");
    run.frames = read_frames(folder);
    return run;
}

} // namespace gapflow
