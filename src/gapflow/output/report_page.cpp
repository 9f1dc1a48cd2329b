// Numbers of the page lie in one stream of bytes, compressed (zlib) and in base64. In the page's JSON an array is
// [type, offset, count] or, for fields, ["q16", offset, count, low, high]: 16-bit codes, 0 for no value, else
// low + (code - 1) / 65534 (high - low), so that the error is below 1e-5 of the array's range. Codes are stored as differences
// to the one before (modulo 2^16), all high bytes, then all low bytes: smooth fields then compress well.
#include "gapflow/output/report_page.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/core/text.hpp"
#include "gapflow/output/assets.hpp"
#include "gapflow/output/base64.hpp"
#include "gapflow/output/colour_map.hpp"
#include "gapflow/output/file.hpp"
#include "gapflow/output/run_record.hpp"
#include "gapflow/output/run_view.hpp"
#include "gapflow/output/scene_difference.hpp"
#include "gapflow/output/xml.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
#include <map>
#include <regex>
#include <set>

namespace gapflow {

namespace {

using Json = nlohmann::ordered_json;

// Bytes of arrays and what refers to them.
class Numbers {
public:
    template <class T, class From>
    Json add(const char* type, const std::vector<From>& values)
    {
        const std::size_t offset = aligned();
        for (const From& value : values)
            put(static_cast<T>(value));
        return {type, offset, values.size()};
    }
    Json floats(const auto& values) { return add<float>("f32", values); }
    Json doubles(const std::vector<double>& values) { return add<double>("f64", values); }
    Json integers(const std::vector<int>& values) { return add<std::int32_t>("i32", values); }
    Json bytes(const std::vector<std::uint8_t>& values) { return add<std::uint8_t>("u8", values); }
    Json points(const std::vector<Eigen::Vector3d>& points, int dimension)
    {
        std::vector<float> values;
        for (const Eigen::Vector3d& x : points)
            for (int axis = 0; axis < dimension; ++axis)
                values.push_back(static_cast<float>(x[axis]));
        return floats(values);
    }
    Json field(const std::vector<float>& values)
    {
        const auto [low, high] = range_between(values, 0, 1);
        const double scale = high > low ? 65534.0 / (static_cast<double>(high) - low) : 0;
        std::string high_bytes, low_bytes;
        std::uint16_t before = 0;
        for (const float value : values) {
            const auto code = std::isfinite(value)
                                  ? static_cast<std::uint16_t>(1 + std::lround((static_cast<double>(value) - low) * scale))
                                  : std::uint16_t{0};
            const auto change = static_cast<std::uint16_t>(code - before);
            before = code;
            high_bytes += static_cast<char>(change >> 8);
            low_bytes += static_cast<char>(change & 255);
        }
        const std::size_t offset = aligned();
        bytes_ += high_bytes + low_bytes;
        return {"q16", offset, values.size(), low, high};
    }

    std::size_t aligned()
    {
        bytes_.resize((bytes_.size() + 7) / 8 * 8);
        return bytes_.size();
    }
    const std::string& content() const { return bytes_; }
    void append(const Numbers& other)
    {
        aligned();
        bytes_ += other.bytes_;
    }

private:
    template <class T>
    void put(T value)
    {
        char bytes[sizeof(T)];
        std::memcpy(bytes, &value, sizeof(T));
        bytes_.append(bytes, sizeof(T));
    }

    std::string bytes_;
};

std::string compressed(const std::string& bytes)
{
    uLongf size = compressBound(bytes.size());
    std::string result(size, '\0');
    if (compress2(reinterpret_cast<Bytef*>(result.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(),
                  6) != Z_OK)
        throw ComputationError("the page's data cannot be compressed: out of memory");
    result.resize(size);
    return result;
}

// Inside <script type="application/json">: no character that could end it or start a comment.
std::string json_for_script(const Json& json)
{
    std::string result;
    for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace))
        if (c == '<')
            result += "\\u003c";
        else
            result += c;
    return result;
}

// A bundle inside <script> or <style>: </script and <!-- occur in texts of it only, where a backslash changes nothing.
std::string code_for_page(std::string_view code)
{
    std::string result;
    for (std::size_t i = 0; i < code.size(); ++i) {
        const std::string_view rest = code.substr(i);
        if (rest.starts_with("</s") || rest.starts_with("</S")) {
            result += "<\\/";
            ++i;
        } else if (rest.starts_with("<!--")) {
            result += "<\\!";
            ++i;
        } else {
            result += code[i];
        }
    }
    return result;
}

// The template with {{name}} replaced, in one pass: inserted text is not searched.
std::string filled(std::string_view page, const std::vector<std::pair<std::string, std::string>>& values)
{
    std::string result;
    while (!page.empty()) {
        const auto open = page.find("{{"), close = page.find("}}", open);
        if (open == std::string_view::npos || close == std::string_view::npos)
            break;
        result += page.substr(0, open);
        const std::string_view name = page.substr(open + 2, close - open - 2);
        for (const auto& [key, value] : values)
            if (key == name)
                result += value;
        page.remove_prefix(close + 2);
    }
    return result.append(page);
}

// ---- tables

// Numbers of the steps that are shown: every `stride`-th and the last.
std::vector<std::size_t> shown_steps(std::size_t count, std::size_t stride)
{
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < count; i += stride)
        shown.push_back(i);
    if (count > 0 && shown.back() != count - 1)
        shown.push_back(count - 1);
    return shown;
}

// Columns of some rows of a table at the shown steps; steps without a row get NaN.
Json columns_at(const RunTable& table, const std::vector<std::size_t>& rows, const std::vector<double>& steps, Numbers& numbers)
{
    Json columns = Json::object();
    const std::vector<double>& step_of = table.number("step");
    for (const auto& [name, values] : table.numbers) {
        if (name == "step" || name == "time")
            continue;
        std::vector<double> shown(steps.size(), std::numeric_limits<double>::quiet_NaN());
        auto row = rows.begin();
        for (std::size_t i = 0; i < steps.size(); ++i) {
            row = std::find_if(row, rows.end(), [&](std::size_t r) { return step_of[r] >= steps[i]; });
            if (row != rows.end() && step_of[*row] == steps[i])
                shown[i] = values[*row];
        }
        columns[name] = numbers.floats(shown);
    }
    return columns;
}

Json tables_json(const StoredRun& run, const RunView& view, const PageLimits& limits, Numbers& numbers, PageSummary& summary)
{
    summary.steps_of_run = run.steps.rows;
    const std::size_t values = run.bodies.rows * run.bodies.numbers.size() + run.gaps.rows * run.gaps.numbers.size() +
                               run.steps.rows * run.steps.numbers.size();
    const std::size_t stride = std::max({std::size_t{1}, (run.steps.rows + limits.steps - 1) / limits.steps,
                                         (values + limits.table_values - 1) / limits.table_values});
    const std::vector<std::size_t> shown = shown_steps(run.steps.rows, stride);
    summary.steps = shown.size();
    std::vector<double> steps, times;
    for (const std::size_t row : shown) {
        steps.push_back(run.steps.number("step")[row]);
        times.push_back(run.steps.number("time")[row]);
    }
    Json json;
    json["of"] = run.steps.rows;
    json["time"] = numbers.doubles(times);
    json["steps"] = columns_at(run.steps, shown, steps, numbers);
    json["bodies"] = Json::array();
    for (const BodyView& body : view.bodies)
        json["bodies"].push_back(
            {{"name", body.name}, {"motion", body.motion}, {"columns", columns_at(run.bodies, body.rows, steps, numbers)}});
    std::map<std::pair<std::string, std::string>, std::vector<std::size_t>> pairs;
    const std::vector<std::string>&a = run.gaps.text("body_a"), &b = run.gaps.text("body_b");
    for (std::size_t row = 0; row < run.gaps.rows; ++row)
        pairs[{a[row], b[row]}].push_back(row);
    json["gaps"] = Json::array();
    for (const auto& [pair, rows] : pairs)
        json["gaps"].push_back(
            {{"a", pair.first}, {"b", pair.second}, {"columns", columns_at(run.gaps, rows, steps, numbers)}});
    return json;
}

// Rows of a table by a text in them, in the order in which these first come.
std::vector<std::pair<std::string, std::vector<std::size_t>>> rows_by(const RunTable& table, const std::string& column)
{
    std::vector<std::pair<std::string, std::vector<std::size_t>>> groups;
    std::map<std::string, std::size_t> number;
    const std::vector<std::string>& texts = table.text(column);
    for (std::size_t row = 0; row < texts.size(); ++row) {
        const auto [found, added] = number.try_emplace(texts[row], groups.size());
        if (added)
            groups.emplace_back(texts[row], std::vector<std::size_t>());
        groups[found->second].second.push_back(row);
    }
    return groups;
}

// Time and columns of some rows of a table that has times of its own; evenly thinned to the limit of rows.
Json measured_json(const std::string& name, const RunTable& table, const std::vector<std::size_t>& rows, std::size_t limit,
                   Numbers& numbers)
{
    const std::vector<std::size_t> shown =
        shown_steps(rows.size(), std::max<std::size_t>(1, (rows.size() + limit - 1) / limit));
    const auto at_shown = [&](const std::vector<double>& values) {
        std::vector<double> result;
        for (const std::size_t i : shown)
            result.push_back(values[rows[i]]);
        return result;
    };
    Json columns = Json::object();
    for (const auto& [column, values] : table.numbers)
        if (column != "step" && column != "time" && column != "point" && column != "x" && column != "y" && column != "z")
            columns[column] = numbers.floats(at_shown(values));
    return {{"name", name}, {"time", numbers.doubles(at_shown(table.number("time")))}, {"columns", columns}};
}

// Points of a probe that the page shows: all of a few, else some evenly spread ones with the first and the last.
std::vector<double> shown_points(double count)
{
    constexpr int most = 6;
    std::vector<double> points;
    for (int i = 0; i < std::min<double>(most, count); ++i)
        points.push_back(count <= most ? i + 1 : 1 + std::round(i * (count - 1) / (most - 1)));
    return points;
}

// What a scene asks to be measured: fluxes, points of probes, parts of the forces on bodies.
void add_measures(Json& json, const StoredRun& run, const PageLimits& limits, Numbers& numbers)
{
    const RunTable probes = read_table(run.folder / "probes.csv"), forces = read_table(run.folder / "forces.csv");
    const auto limit_of = [&](std::size_t series, const RunTable& table) {
        const std::size_t values = std::max<std::size_t>(1, series * table.numbers.size());
        return std::max<std::size_t>(2, std::min(limits.steps, limits.table_values / values));
    };
    json["fluxes"] = Json::array();
    const auto fluxes = rows_by(run.fluxes, "name");
    for (const auto& [name, rows] : fluxes)
        json["fluxes"].push_back(measured_json(name, run.fluxes, rows, limit_of(fluxes.size(), run.fluxes), numbers));
    json["forces"] = Json::array();
    const auto bodies = rows_by(forces, "body");
    for (const auto& [name, rows] : bodies)
        json["forces"].push_back(measured_json(name, forces, rows, limit_of(bodies.size(), forces), numbers));
    json["probes"] = Json::array();
    const std::vector<double>& point_of = probes.number("point");
    const auto named = rows_by(probes, "name");
    for (const auto& [name, rows] : named) {
        double count = 0;
        for (const std::size_t row : rows)
            count = std::max(count, point_of[row]);
        for (const double point : shown_points(count)) {
            std::vector<std::size_t> own;
            std::copy_if(rows.begin(), rows.end(), std::back_inserter(own),
                         [&](std::size_t row) { return point_of[row] == point; });
            Json entry = measured_json(name, probes, own, limit_of(6 * named.size(), probes), numbers);
            std::vector<double> place;
            for (const char* axis : {"x", "y", "z"})
                if (const std::vector<double>& along = probes.number(axis); !along.empty() && !own.empty())
                    place.push_back(along[own[0]]);
            entry["place"] = place;
            entry["points"] = count;
            json["probes"].push_back(std::move(entry));
        }
    }
}

// ---- frames

struct EncodedFrame {
    Json json;
    Numbers numbers;
};

Json chains_json(const std::vector<std::vector<int>>& chains, Numbers& numbers)
{
    std::vector<int> nodes, ends;
    for (const std::vector<int>& chain : chains) {
        nodes.insert(nodes.end(), chain.begin(), chain.end());
        ends.push_back(static_cast<int>(nodes.size()));
    }
    return {{"nodes", numbers.integers(nodes)}, {"ends", numbers.integers(ends)}};
}

EncodedFrame encode(const FrameView& frame, int dimension)
{
    EncodedFrame result;
    Numbers& numbers = result.numbers;
    Json& json = result.json;
    json["number"] = frame.number;
    json["time"] = frame.time;
    if (!frame.shift.isZero(0))
        json["shift"] = std::vector(frame.shift.begin(), frame.shift.end());
    json["planes"] = Json::array();
    for (const FieldPlane& plane : frame.planes) {
        Json entry = {{"axis", plane.axis},   {"position", plane.position}, {"in_plane", plane.in_plane},
                      {"cells", plane.cells}, {"low", plane.low},           {"spacing", plane.spacing}};
        entry["fluid"] = numbers.bytes({plane.fluid.begin(), plane.fluid.end()});
        if (!plane.pressure.empty())
            entry["pressure"] = numbers.field(plane.pressure);
        if (!plane.speed.empty() && dimension == 2) {
            entry["u"] = numbers.field(plane.u);
            entry["v"] = numbers.field(plane.v);
        } else if (!plane.speed.empty()) {
            entry["speed"] = numbers.field(plane.speed);
        }
        json["planes"].push_back(std::move(entry));
    }
    if (const FieldVolume& volume = frame.volume; volume.cells[0] > 0) {
        json["volume"] = {{"cells", volume.cells}, {"low", volume.low}, {"spacing", volume.spacing}};
        if (!volume.pressure.empty())
            json["volume"]["pressure"] = numbers.field(volume.pressure);
        if (!volume.speed.empty())
            json["volume"]["speed"] = numbers.field(volume.speed);
    }
    const FilmView& film = frame.film;
    json["film"] = {{"points", numbers.points(film.points, dimension)},
                    {"thickness", numbers.floats(film.thickness)},
                    {"pressure", numbers.floats(film.pressure)}};
    if (dimension == 2)
        json["film"]["chains"] = chains_json(film.chains, numbers);
    else
        json["film"]["elements"] = numbers.integers(film.elements);
    std::vector<double> placements; // by rows: rotation, shift
    for (const Placement& placement : frame.placements) {
        for (int i = 0; i < 9; ++i)
            placements.push_back(placement.rotation(i / 3, i % 3));
        placements.insert(placements.end(), placement.shift.begin(), placement.shift.end());
    }
    json["placements"] = numbers.doubles(placements);
    return result;
}

// Every stride-th frame and the last one, with the smallest stride (a power of two) that keeps within the limit.
std::vector<EncodedFrame> encode_frames(const StoredRun& run, const RunView& view, const PageLimits& limits,
                                        RangeSampler& sampler, const CountWatcher& watch)
{
    std::vector<EncodedFrame> kept;
    std::size_t stride = 1, bytes = 0;
    const auto add = [&](std::size_t index) {
        const FrameView frame = view_frame(run, view, run.frames[index], limits.plane_cells, limits.volume_cells);
        sampler.add(frame);
        kept.push_back(encode(frame, view.dimension));
        bytes += kept.back().numbers.content().size();
        if (watch)
            watch(index + 1, run.frames.size());
    };
    std::size_t last = 0;
    for (std::size_t index = 0; index < run.frames.size(); index += stride) {
        add(index);
        last = index;
        while (bytes > limits.frame_bytes && kept.size() > 2) {
            stride *= 2;
            std::vector<EncodedFrame> every_second;
            for (std::size_t i = 0; i < kept.size(); i += 2)
                every_second.push_back(std::move(kept[i]));
            kept = std::move(every_second);
            bytes = 0;
            for (const EncodedFrame& frame : kept)
                bytes += frame.numbers.content().size();
            last = (kept.size() - 1) * stride;
            index = last;
        }
    }
    if (!run.frames.empty() && last != run.frames.size() - 1)
        add(run.frames.size() - 1);
    return kept;
}

// ---- page

Json bodies_json(const RunView& view, Numbers& numbers)
{
    Json bodies = Json::array();
    for (const BodyView& body : view.bodies) {
        Json entry = {{"name", body.name}, {"motion", body.motion}, {"shape", body.shape}, {"inside_out", body.inside_out}};
        entry["points"] = numbers.points(body.points, view.dimension);
        if (view.dimension == 2)
            entry["outlines"] = chains_json(body.outlines, numbers);
        else
            entry["elements"] = numbers.integers(body.elements);
        bodies.push_back(std::move(entry));
    }
    return bodies;
}

Json colours_json(const ColourRanges& ranges, Numbers& numbers)
{
    Json colours;
    for (const auto& [name, map, range] :
         {std::tuple{"pressure", ColourMap::pressure, ranges.pressure}, std::tuple{"speed", ColourMap::speed, ranges.speed},
          std::tuple{"film", ColourMap::film, ranges.film}}) {
        std::vector<std::uint8_t> table;
        for (int i = 0; i < 256; ++i) {
            const Colour colour = colour_at(map, i / 255.0);
            table.insert(table.end(), {colour.red, colour.green, colour.blue});
        }
        colours[name] = {{"table", numbers.bytes(table)}, {"low", range.low}, {"high", range.high}};
    }
    return colours;
}

std::string title_of(const StoredRun& run)
{
    const std::string title = run.scene->value("title", "");
    if (!title.empty())
        return title;
    const std::filesystem::path folder = std::filesystem::absolute(run.folder).lexically_normal();
    return (folder.has_filename() ? folder : folder.parent_path()).filename().string();
}

/// The run's warnings as a list; empty without warnings.
std::string warnings_html(const Json& record)
{
    std::string items;
    if (const auto warnings = record.find("warnings"); warnings != record.end() && warnings->is_array())
        for (const Json& warning : *warnings)
            if (warning.is_string())
                items += "<li>" + escaped(warning.get<std::string>()) + "</li>";
    return items.empty() ? ""
                         : "<section aria-labelledby=\"warnings-title\"><h2 id=\"warnings-title\">Warnings</h2><ul "
                           "id=\"warnings\" class=\"card\">" +
                               items + "</ul></section>";
}

bool all_differ(const std::vector<std::string>& texts)
{
    return std::set<std::string>(texts.begin(), texts.end()).size() == texts.size();
}

/// A run as a page holds it, but for colours: its numbers go to the others.
Json run_json(const StoredRun& run, const PageLimits& limits, const CountWatcher& watch, RangeSampler& sampler,
              Numbers& numbers, PageSummary& summary)
{
    const RunView view = view_run(run);
    Json json;
    json["dimension"] = view.dimension;
    json["title"] = title_of(run);
    json["record"] = *run.record;
    if (const auto recorded = read_recorded_run(run.folder / "run.json"); recorded && recorded->state == RunState::killed)
        json["record"]["status"] = "killed";
    json["scene"] = *run.scene;
    json["domain"] = {{"origin", std::vector(view.origin.begin(), view.origin.end())},
                      {"size", std::vector(view.size.begin(), view.size.end())},
                      {"spacing", view.spacing}};
    json["bodies"] = bodies_json(view, numbers);
    json["tables"] = tables_json(run, view, limits, numbers, summary);
    add_measures(json["tables"], run, limits, numbers);
    std::vector<EncodedFrame> frames = encode_frames(run, view, limits, sampler, watch);
    json["frames_of_run"] = run.frames.size();
    json["frames"] = Json::array();
    for (EncodedFrame& frame : frames) {
        frame.json["base"] = numbers.aligned();
        numbers.append(frame.numbers);
        json["frames"].push_back(std::move(frame.json));
    }
    summary.frames = frames.size();
    summary.frames_of_run = run.frames.size();
    return json;
}

/// Values and quantities of a sweep's runs.
Json sweep_json(const SweepResults& sweep, Numbers& numbers)
{
    Json json{{"keys", Json::array()}, {"quantities", Json::array()}};
    for (const auto& [key, values] : sweep.keys)
        json["keys"].push_back({{"name", key}, {"values", values}});
    for (const SweepResults::Quantity& quantity : sweep.quantities)
        json["quantities"].push_back({{"name", quantity.name},
                                      {"last", numbers.doubles(quantity.last)},
                                      {"mean", numbers.doubles(quantity.mean)},
                                      {"min", numbers.doubles(quantity.low)},
                                      {"max", numbers.doubles(quantity.high)}});
    return json;
}

/// Fills the template and writes it; returns its size.
std::size_t write_page(const std::filesystem::path& page, const std::string& title, const std::string& warnings, int dimension,
                       const Json& json, const Numbers& numbers)
{
    const std::string packed = compressed(numbers.content());
    const std::string content = filled(
        assets::page_html(), {{"title", escaped(title)},
                              {"warnings", warnings},
                              {"style", code_for_page(assets::page_style())},
                              {"data", json_for_script(json)},
                              {"numbers", base64(packed)},
                              {"script", code_for_page(dimension == 2 ? assets::page_script_2d() : assets::page_script_3d())}});
    write_atomically(page, content);
    return content.size();
}

double reference_pressure(const StoredRun& run)
{
    return run.scene->at("fluid").value("reference_pressure", 0.0);
}

} // namespace

PageSummary write_report_page(const StoredRun& run, const std::filesystem::path& page, const PageLimits& limits,
                              const CountWatcher& watch)
{
    PageSummary summary;
    Numbers numbers;
    RangeSampler sampler;
    Json json = run_json(run, limits, watch, sampler, numbers, summary);
    json["colours"] = colours_json(sampler.ranges(reference_pressure(run)), numbers);
    summary.bytes = write_page(page, title_of(run), warnings_html(*run.record), run.dimension, json, numbers);
    return summary;
}

PageSummary write_comparison_page(const std::vector<LabelledRun>& runs, const std::filesystem::path& page,
                                  const SweepResults* sweep, const PageLimits& limits, const CountWatcher& watch)
{
    const int dimension = runs.at(0).run.dimension;
    PageLimits each = limits;
    each.frame_bytes /= runs.size();
    each.table_values /= runs.size();
    std::size_t frames = 0, before = 0;
    for (const LabelledRun& labelled : runs) {
        if (labelled.run.dimension != dimension)
            throw InputError(labelled.run.folder.string() + ": a run in " + std::to_string(labelled.run.dimension) +
                             "D beside one in " + std::to_string(dimension) + "D (" + runs[0].run.folder.string() +
                             "); compare runs of the same dimension");
        frames += labelled.run.frames.size();
    }
    PageSummary summary;
    Numbers numbers;
    RangeSampler sampler;
    Json json;
    json["dimension"] = dimension;
    json["title"] = title_of(runs[0].run);
    json["runs"] = Json::array();
    for (const LabelledRun& labelled : runs) {
        PageSummary of_run;
        const CountWatcher watch_all =
            watch ? CountWatcher([&](std::size_t done, std::size_t) { watch(before + done, frames); }) : CountWatcher();
        Json run = run_json(labelled.run, each, watch_all, sampler, numbers, of_run);
        run["label"] = labelled.label;
        run["folder"] = labelled.run.folder.string();
        json["runs"].push_back(std::move(run));
        before += labelled.run.frames.size();
        summary.frames += of_run.frames;
        summary.frames_of_run += of_run.frames_of_run;
        summary.steps += of_run.steps;
        summary.steps_of_run += of_run.steps_of_run;
    }
    if (sweep)
        json["sweep"] = sweep_json(*sweep, numbers);
    json["colours"] = colours_json(sampler.ranges(reference_pressure(runs[0].run)), numbers);
    summary.bytes = write_page(page, title_of(runs[0].run), "", dimension, json, numbers);
    return summary;
}

std::vector<std::string> labels_of(const std::vector<StoredRun>& runs)
{
    std::vector<std::string> scenes, labels(runs.size());
    for (const StoredRun& run : runs)
        scenes.push_back(run.scene->dump());
    const auto differing = differing_values(scenes);
    for (std::size_t i = 0; i < runs.size() && differing.size() <= 3; ++i) {
        std::vector<std::string> parts;
        for (const auto& [key, values] : differing)
            parts.push_back(key + " = " + values[i]);
        labels[i] = joined(parts);
    }
    if (all_differ(labels))
        return short_labels(labels);
    for (std::size_t i = 0; i < runs.size(); ++i)
        labels[i] = runs[i].folder.lexically_normal().string();
    return labels;
}

std::vector<std::string> short_labels(const std::vector<std::string>& labels)
{
    static const std::regex decimal(R"((^|[\s,\[])([-+]?[0-9]*\.[0-9]+(?:[eE][-+]?[0-9]+)?)(?=$|[\s,\]]))");
    std::vector<std::string> all;
    for (const std::string& label : labels) {
        std::string text;
        auto rest = label.begin();
        for (std::sregex_iterator match(label.begin(), label.end(), decimal), end; match != end; ++match) {
            text.append(rest, (*match)[2].first);
            const auto value = parse_number((*match)[2].str());
            text += value ? fmt::format("{:.5g}", *value) : (*match)[2].str();
            rest = (*match)[2].second;
        }
        all.push_back(text.append(rest, label.end()));
    }
    return all_differ(all) ? all : labels;
}

} // namespace gapflow
