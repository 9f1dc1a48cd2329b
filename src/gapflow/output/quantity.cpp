#include "gapflow/output/quantity.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/core/text.hpp"
#include "gapflow/output/columns.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace gapflow {

namespace {

/// The columns of gaps.csv that are real numbers.
std::vector<std::string> real_gap_columns()
{
    std::vector<std::string> names;
    for (const Column<GapState>& column : gap_columns())
        if (std::holds_alternative<double GapState::*>(column.member))
            names.emplace_back(column.name);
    return names;
}

/// The numbers of fluxes.csv.
const std::vector<std::string> flux_columns{"flux", "inflow", "outflow", "film", "bodies"};

bool has(const std::vector<std::string>& list, const std::string& text)
{
    return std::find(list.begin(), list.end(), text) != list.end();
}

/// Bodies of the run's scene and how each moves; those of crowds are left out.
std::map<std::string, std::string> motions_of(const StoredRun& run)
{
    std::set<std::string> of_crowds;
    std::map<std::string, std::string> motions;
    const auto crowds = run.scene->find("crowd");
    if (crowds != run.scene->end())
        for (const auto& crowd : *crowds)
            of_crowds.insert(crowd.at("name").get<std::string>() + "_");
    for (const auto& body : run.scene->at("body")) {
        const auto name = body.at("name").get<std::string>();
        if (std::none_of(of_crowds.begin(), of_crowds.end(), [&](const std::string& crowd) { return name.starts_with(crowd); }))
            motions[name] = body.at("motion").get<std::string>();
    }
    return motions;
}

} // namespace

Quantity quantity_of(const std::string& name, const Scene& scene)
{
    std::vector<std::string> bodies;
    for (const BodyScene& body : scene.bodies)
        bodies.push_back(body.name);
    std::vector<std::string> solids = bodies;
    for (int side = 0; side < 2 * scene.dimension; ++side)
        solids.push_back("wall:" + side_names[side]);
    const auto dot = name.rfind('.');
    const std::string owner = name.substr(0, dot), column = dot == std::string::npos ? "" : name.substr(dot + 1);
    const auto check_column = [&](const std::vector<std::string>& columns) {
        if (has(columns, column))
            return;
        const std::string near = nearest_name(column, columns);
        throw InputError("quantity " + name + ": there is no '" + column + "'" +
                         (near.empty() ? "" : ", did you mean '" + near + "'?") + "; choose from " + joined(columns));
    };
    if (dot != std::string::npos && has(bodies, owner)) {
        check_column(body_columns(scene.dimension).all());
        return {name, column, owner, ""};
    }
    for (const std::string& a : solids)
        for (const std::string& b : solids)
            if (a != b && owner == a + "-" + b) {
                check_column(real_gap_columns());
                return {name, column, a, b};
            }
    std::vector<std::string> fluxes;
    for (const FluxScene& flux : scene.fluxes)
        fluxes.push_back(flux.name);
    if (dot != std::string::npos && has(fluxes, owner)) {
        check_column(flux_columns);
        return {name, column, owner, "", true};
    }
    std::vector<std::string> owners = bodies;
    owners.insert(owners.end(), fluxes.begin(), fluxes.end());
    const std::string near = nearest_name(owner, owners);
    throw InputError(
        "quantity " + name + ": no body and no gap is named '" + owner + "'" +
        (near.empty() ? "" : ", did you mean '" + near + "." + column + "'?") +
        "; write BODY.COLUMN, as upper.y, or BODY-BODY.COLUMN, as lower-upper.thickness; the bodies are: " + joined(bodies) +
        (fluxes.empty() ? "" : "; or FLUX.COLUMN, as " + fluxes[0] + ".flux; the fluxes are: " + joined(fluxes)));
}

std::vector<Quantity> key_quantities(const StoredRun& run, std::size_t most_gaps)
{
    const std::map<std::string, std::string> motions = motions_of(run);
    const BodyColumns columns = body_columns(run.dimension);
    std::vector<Quantity> all;
    const auto add = [&](const std::string& body, const std::vector<std::string>& names) {
        for (const std::string& column : names)
            all.push_back({body + "." + column, column, body, ""});
    };
    for (const auto& [name, motion] : motions) {
        if (motion != "fixed") {
            add(name, columns.position);
            if (run.dimension == 2)
                add(name, columns.rotation);
            add(name, columns.velocity);
        }
        add(name, columns.force);
    }
    const auto moves = [&](const std::string& name) {
        const auto body = motions.find(name);
        return body != motions.end() && body->second != "fixed";
    };
    const auto counts = [&](const std::string& name) { return name.starts_with("wall:") || motions.contains(name); };
    std::set<std::pair<std::string, std::string>> pairs;
    const std::vector<std::string>&a = run.gaps.text("body_a"), &b = run.gaps.text("body_b");
    for (std::size_t row = 0; row < a.size() && pairs.size() < most_gaps; ++row)
        if ((moves(a[row]) || moves(b[row])) && counts(a[row]) && counts(b[row]))
            pairs.emplace(a[row], b[row]);
    for (const auto& [first, second] : pairs)
        for (const char* column : {"thickness", "force", "contact_force"})
            all.push_back({first + "-" + second + "." + column, column, first, second});
    if (const auto fluxes = run.scene->find("flux"); fluxes != run.scene->end())
        for (const auto& flux : *fluxes)
            if (const auto name = flux.at("name").get<std::string>(); !motions.contains(name))
                all.push_back({name + ".flux", "flux", name, "", true});
    return all;
}

TimeWindow window_of(const std::string& text, double end)
{
    const auto parts = split(text, ',');
    const auto from = parse_number(parts[0]), to = parts.size() == 2 ? parse_number(parts[1]) : std::nullopt;
    if (!from || !to || !(*from >= 0 && *from < *to && *to <= end))
        throw InputError("--window " + text +
                         ": two times FROM,TO are needed, 0 <= FROM < TO <= time.end = " + number_text(end));
    return {*from, *to};
}

std::optional<Statistics> statistics_of(const StoredRun& run, const Quantity& quantity, const TimeWindow& window)
{
    const bool of_gap = !quantity.other.empty();
    const RunTable& table = quantity.flux ? run.fluxes : of_gap ? run.gaps : run.bodies;
    const std::vector<double>&values = table.number(quantity.column), &times = table.number("time"),
          &steps = table.number("step");
    const std::vector<std::string>&first = table.text(quantity.flux ? "name"
                                                      : of_gap      ? "body_a"
                                                                    : "body"),
          &second = table.text("body_b");
    const std::vector<double>&numbers = run.steps.number("step"), &lengths = run.steps.number("dt");
    if (values.size() != table.rows || times.size() != table.rows || first.size() != table.rows)
        return std::nullopt;
    Statistics result;
    double duration = 0, sum = 0;
    bool any = false;
    for (std::size_t row = 0; row < table.rows; ++row) {
        const bool wanted = of_gap ? (first[row] == quantity.body && second[row] == quantity.other) ||
                                         (first[row] == quantity.other && second[row] == quantity.body)
                                   : first[row] == quantity.body;
        const double value = values[row];
        if (!wanted || times[row] < window.from || times[row] > window.to || !std::isfinite(value))
            continue;
        result.last = value;
        result.low = any ? std::min(result.low, value) : value;
        result.high = any ? std::max(result.high, value) : value;
        any = true;
        const auto step = std::lower_bound(numbers.begin(), numbers.end(), steps[row]);
        const double length = step != numbers.end() && *step == steps[row] && steps[row] > 0
                                  ? lengths[static_cast<std::size_t>(step - numbers.begin())]
                                  : 0;
        sum += length * value;
        duration += length;
    }
    if (!any)
        return std::nullopt;
    result.mean = duration > 0 ? sum / duration : result.last;
    return result;
}

} // namespace gapflow
