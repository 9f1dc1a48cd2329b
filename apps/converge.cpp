// gapflow converge: a scene on several grids, with steps in proportion; errors and observed orders of chosen quantities.
#include "commands.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/core/logging.hpp"
#include "gapflow/core/text.hpp"
#include "gapflow/output/columns.hpp"
#include "gapflow/output/convergence.hpp"
#include "gapflow/output/file.hpp"
#include "gapflow/output/quantity.hpp"
#include "gapflow/scene/graded_widths.hpp"
#include "gapflow/stepping/setup.hpp"
#include "gapflow/stepping/thickness_check.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace gapflow {

namespace {

/// A quantity and the reference's column that it is compared with.
struct Compared {
    Quantity quantity;
    std::string reference; ///< empty: the finest run
};

/// Settings that give the scene n cells along x. A graded grid is refined as a whole: twice as many cells grow by the square root.
std::vector<std::pair<std::string, std::string>> refined(const Scene& scene, int n)
{
    const double ratio = static_cast<double>(core_cells(scene, 0)) / n;
    const auto text = [](double value) { return fmt::format("{:.17g}", value); };
    std::vector<std::pair<std::string, std::string>> settings;
    const auto list = [&](const Triple& values) {
        std::vector<std::string> numbers;
        for (int axis = 0; axis < scene.dimension; ++axis)
            numbers.push_back(text(values[axis]));
        return "[" + joined(numbers, ",") + "]";
    };
    if (scene.core) { // the core as it is taken: whole numbers of cells long on every grid
        settings = {{"domain.spacing", text(scene.core->spacing * ratio)},
                    {"domain.growth", text(std::min(std::pow(scene.core->growth, ratio), 1.5))},
                    {"domain.size", list(scene.size)},
                    {"domain.core.low", list(scene.core->low)},
                    {"domain.core.high", list(scene.core->high)}};
    } else {
        std::vector<std::string> cells;
        for (int axis = 0; axis < scene.dimension; ++axis)
            cells.push_back(std::to_string(static_cast<long>(n) * scene.cells[axis] / scene.cells[0]));
        settings = {{"domain.cells", "[" + joined(cells, ",") + "]"}};
    }
    settings.emplace_back("time.max_step", text(scene.max_step * ratio));
    settings.emplace_back("time.gap_cfl", text(scene.gap_cfl * ratio));
    return settings;
}

std::vector<int> grids_of(const std::string& list, const Scene& scene)
{
    std::vector<int> grids;
    for (const auto part : split(list, ',')) {
        const auto number = parse_number(part);
        const std::string at = "--cells " + list + ": ";
        if (!number || *number != std::floor(*number) || *number < 1 || *number > 1e6)
            throw InputError(at + "'" + std::string(part) + "' is not a number of cells; write for example --cells 32,64,128");
        const int n = static_cast<int>(*number);
        for (int axis = 1; axis < scene.dimension; ++axis)
            if (static_cast<long>(n) * core_cells(scene, axis) % core_cells(scene, 0) != 0)
                throw InputError(at + std::to_string(n) + " cells along x make no whole number of cells along " + "xyz"[axis] +
                                 "; choose numbers that keep the proportions of " +
                                 (scene.core ? "domain.core" : "domain.cells"));
        grids.push_back(n);
    }
    std::sort(grids.begin(), grids.end());
    if (grids.size() < 2 || std::adjacent_find(grids.begin(), grids.end()) != grids.end())
        throw InputError("--cells " + list +
                         ": an order takes two different grids or more; write for example --cells 32,64,128");
    return grids;
}

/// Positions and velocities of the free bodies.
std::vector<Compared> default_quantities(const Scene& scene)
{
    std::vector<Compared> all;
    const BodyColumns of_body = body_columns(scene.dimension);
    std::vector<std::string> columns = of_body.position;
    if (scene.dimension == 2)
        columns.insert(columns.end(), of_body.rotation.begin(), of_body.rotation.end());
    columns.insert(columns.end(), of_body.velocity.begin(), of_body.velocity.end());
    for (const BodyScene& body : scene.bodies)
        if (body.motion == BodyScene::Motion::free)
            for (const std::string& column : columns)
                all.push_back({quantity_of(body.name + "." + column, scene), ""});
    if (all.empty())
        throw InputError(scene.file + ": no body is free; choose what to compare with --quantity BODY.COLUMN");
    return all;
}

std::string time_column(const CsvTable& table)
{
    for (const char* name : {"time", "t"})
        if (std::find(table.names.begin(), table.names.end(), name) != table.names.end())
            return name;
    throw InputError(table.file + ": has no column 'time' (or 't'); its columns are: " + joined(table.names));
}

/// Quantities to compare, with the reference's columns: those of --column; else columns that have the quantities' names.
std::vector<Compared> choose_quantities(const Scene& scene, const ConvergeOptions& options, const CsvTable* reference)
{
    std::vector<Compared> chosen;
    for (const std::string& name : options.quantities)
        chosen.push_back({quantity_of(name, scene), ""});
    for (const std::string& mapping : options.columns) {
        const auto equals = mapping.find('=');
        if (equals == std::string::npos || equals == 0 || equals + 1 == mapping.size())
            throw InputError("--column " + mapping + ": not quantity=column; write for example --column upper.vy=speed");
        if (!reference)
            throw InputError("--column " + mapping + ": columns are those of a reference file; add --reference FILE.csv");
        const std::string name = mapping.substr(0, equals), column = mapping.substr(equals + 1);
        reference->column(column); // throws where there is none
        auto known = std::find_if(chosen.begin(), chosen.end(), [&](const Compared& q) { return q.quantity.name == name; });
        if (known == chosen.end())
            known = chosen.insert(chosen.end(), {quantity_of(name, scene), ""});
        known->reference = column;
    }
    const bool asked = !chosen.empty();
    if (!asked)
        chosen = default_quantities(scene);
    if (!reference)
        return chosen;
    std::vector<Compared> found;
    for (Compared& q : chosen) {
        const bool there =
            std::find(reference->names.begin(), reference->names.end(), q.quantity.name) != reference->names.end();
        if (q.reference.empty() && there)
            q.reference = q.quantity.name;
        if (!q.reference.empty())
            found.push_back(q);
        else if (asked)
            throw InputError(reference->file + ": has no column '" + q.quantity.name + "'; name one with --column " +
                             q.quantity.name + "=NAME; its columns are: " + joined(reference->names));
    }
    if (found.empty())
        throw InputError(reference->file + ": no column is named like a quantity of the scene (as " + chosen[0].quantity.name +
                         "); name one with --column " + chosen[0].quantity.name +
                         "=NAME; its columns are: " + joined(reference->names));
    return found;
}

struct GridRun {
    int cells = 0;
    double spacing = 0;
    long steps = 0;
    std::string folder;
    std::vector<Series> series; ///< of each quantity
};

Series series_of(const Quantity& q, const CsvTable& bodies, const CsvTable& gaps, const CsvTable& fluxes)
{
    if (q.flux)
        return read_series(fluxes, "time", q.column, {{"name", q.body}});
    if (q.other.empty())
        return read_series(bodies, "time", q.column, {{"body", q.body}});
    Series series = read_series(gaps, "time", q.column, {{"body_a", q.body}, {"body_b", q.other}});
    if (series.time.empty())
        series = read_series(gaps, "time", q.column, {{"body_a", q.other}, {"body_b", q.body}});
    return series;
}

void read_quantities(const std::vector<Compared>& quantities, GridRun& run)
{
    const CsvTable bodies = read_csv(run.folder + "/bodies.csv"), steps = read_csv(run.folder + "/steps.csv");
    run.steps = static_cast<long>(steps.rows.size()) - 1;
    const bool any_gap =
        std::any_of(quantities.begin(), quantities.end(), [](const Compared& q) { return !q.quantity.other.empty(); });
    const CsvTable gaps = any_gap ? read_csv(run.folder + "/gaps.csv") : CsvTable{};
    const bool any_flux = std::any_of(quantities.begin(), quantities.end(), [](const Compared& q) { return q.quantity.flux; });
    const CsvTable fluxes = any_flux ? read_csv(run.folder + "/fluxes.csv") : CsvTable{};
    for (const Compared& q : quantities)
        run.series.push_back(series_of(q.quantity, bodies, gaps, fluxes));
}

/// What a quantity's end, mean, smallest and largest value approach. Those that are the same number on every grid as one before, as the end of
/// a quantity that only grows, are told of once.
void add_limits(std::size_t number, const std::vector<GridRun>& runs, ConvergenceOf& result)
{
    std::vector<double> spacings;
    std::vector<std::pair<std::string, std::vector<double>>> all;
    for (const GridRun& run : runs) {
        result.grids.push_back(run.cells);
        spacings.push_back(run.spacing);
        const auto of_run = numbers_of(run.series[number], result.window);
        for (std::size_t k = 0; k < of_run.size(); ++k) {
            if (all.size() <= k)
                all.emplace_back(of_run[k].first, std::vector<double>());
            all[k].second.push_back(of_run[k].second);
        }
    }
    const double least = 1e-9 * result.range; // solver tolerance
    for (const auto& [of, values] : all) {
        const bool told =
            std::any_of(result.limits.begin(), result.limits.end(), [&](const Limit& l) { return l.values == values; });
        const auto [low, high] = std::minmax_element(values.begin(), values.end());
        if (told || *high - *low <= least)
            continue;
        result.limits.push_back(limit_of(spacings, values, least));
        result.limits.back().of = of;
    }
}

/// Errors of one quantity. An empty result: it does not change, so that there is nothing to divide by.
std::optional<ConvergenceOf> compare(std::size_t number, const Compared& q, const std::vector<GridRun>& runs,
                                     const CsvTable* reference_file, TimeWindow window)
{
    const bool finest = !reference_file;
    const Series reference =
        finest ? runs.back().series[number] : read_series(*reference_file, time_column(*reference_file), q.reference);
    std::vector<const Series*> all{&reference};
    for (const GridRun& run : runs)
        all.push_back(&run.series[number]);
    for (const Series* series : all) {
        if (!series->time.empty()) {
            window.from = std::max(window.from, series->time.front());
            window.to = std::min(window.to, series->time.back());
        }
        const auto inside = std::count_if(series->time.begin(), series->time.end(),
                                          [&](double t) { return t >= window.from && t <= window.to; });
        if (inside < 2 && series != &reference)
            throw InputError("quantity " + q.quantity.name + ": a run and its reference share no two times within " +
                             number_text(window.from) + " ... " + number_text(window.to) +
                             "; choose another quantity, or another --window FROM,TO");
    }
    ConvergenceOf result;
    result.quantity = q.quantity.name;
    result.reference =
        finest ? fmt::format("the run with {} cells", runs.back().cells) : reference_file->file + ", column " + q.reference;
    result.window = window;
    result.range = range_of(reference, window);
    // A quantity that changes by rounding and solver tolerance only has no order.
    double size = 0;
    for (double value : reference.value)
        size = std::max(size, std::abs(value));
    if (!(result.range > 1e-9 * size) || !(result.range > 1e-12))
        return std::nullopt;
    for (std::size_t r = 0; r < runs.size() - (finest ? 1 : 0); ++r) {
        SeriesError error = error_of(runs[r].series[number], reference, window);
        error.max /= result.range;
        error.l2 /= result.range;
        result.rows.push_back({runs[r].cells, runs[r].spacing, runs[r].steps, error, {}, {}});
    }
    find_orders(result, finest ? runs.back().spacing : 0.0);
    add_limits(number, runs, result);
    return result;
}

} // namespace

int converge_command(const SceneReader& read, const ConvergeOptions& options)
{
    const Communicator comm;
    const Logger log(comm, options.quiet);
    const Scene scene = read({});
    const std::vector<int> grids = grids_of(options.cells, scene);
    const TimeWindow window = options.window.empty() ? TimeWindow{0, scene.end} : window_of(options.window, scene.end);
    std::optional<CsvTable> reference;
    if (!options.reference.empty()) {
        reference = read_csv(options.reference);
        time_column(*reference);
    }
    const CsvTable* reference_file = reference ? &*reference : nullptr;
    const std::vector<Compared> quantities = choose_quantities(scene, options, reference_file);

    // All scenes first: a value out of range is reported before anything runs.
    std::vector<Scene> scenes;
    for (int n : grids) {
        scenes.push_back(read(refined(scene, n)));
        require_memory(scenes.back(), comm);
        require_thickness(scenes.back());
        scenes.back().bodies_table = Scene::BodiesTable::csv; // what is compared
        scenes.back().output_directory = scene.output_directory + "/cells_" + std::to_string(n);
    }
    std::vector<GridRun> runs;
    for (const Scene& each : scenes) {
        log.info(fmt::format("run {} of {}: {} cells along x, max_step {:.4g}, gap_cfl {:.4g}, into {}", runs.size() + 1,
                             grids.size(), core_cells(each, 0), each.max_step, each.gap_cfl, each.output_directory));
        if (const int status = run_command(each, {options.quiet, {}}))
            return status;
        runs.push_back({core_cells(each, 0), each.spacing(), 0, each.output_directory, {}});
    }
    on_root(comm, [&] {
        for (GridRun& run : runs)
            read_quantities(quantities, run);
        std::vector<ConvergenceOf> all;
        std::vector<std::string> still;
        for (std::size_t i = 0; i < quantities.size(); ++i) {
            auto result = compare(i, quantities[i], runs, reference_file, window);
            if (result)
                all.push_back(std::move(*result));
            else
                still.push_back(quantities[i].quantity.name);
        }
        if (!still.empty())
            log.info("left out, as the reference does not change: " + joined(still));
        if (all.empty())
            throw InputError("nothing to compare: none of the quantities changes within the window; choose others with "
                             "--quantity, or another --window FROM,TO");
        write_atomically(scene.output_directory + "/converge.csv", convergence_csv(all));
        write_atomically(scene.output_directory + "/converge_limits.csv", limits_csv(all));
        write_atomically(scene.output_directory + "/converge.json", convergence_json(all));
        std::fputs(convergence_text(all).c_str(), stdout);
        std::fflush(stdout); // before what goes to the log, where both go to one file
        log.info(fmt::format("files: {0}/converge.csv, {0}/converge_limits.csv, {0}/converge.json", scene.output_directory));
    });
    return 0;
}

} // namespace gapflow
