#include "gapflow/output/run_view.hpp"

#include "gapflow/output/vtk_reader.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace gapflow {

namespace {

constexpr float none = std::numeric_limits<float>::quiet_NaN();
constexpr int solid = 0, bulk = 1, mixed = 3; // of the array "kind" (run_files.cpp)

Eigen::Vector3d triple_of(const nlohmann::ordered_json& list)
{
    Eigen::Vector3d triple = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < std::min<std::size_t>(3, list.size()); ++i)
        triple[static_cast<int>(i)] = list[i].get<double>();
    return triple;
}

// Gives cells without a value the mean of their neighbours with one, `layers` times: a body's edge runs through cells, and a
// viewer interpolates there.
void fill_next_to_values(std::vector<float>& values, const std::array<int, 2>& cells, int layers)
{
    for (int layer = 0; layer < layers; ++layer) {
        const std::vector<float> before = values;
        for (int j = 0; j < cells[1]; ++j)
            for (int i = 0; i < cells[0]; ++i) {
                if (!std::isnan(before[i + cells[0] * j]))
                    continue;
                float sum = 0;
                int count = 0;
                for (int b = std::max(j - 1, 0); b <= std::min(j + 1, cells[1] - 1); ++b)
                    for (int a = std::max(i - 1, 0); a <= std::min(i + 1, cells[0] - 1); ++a)
                        if (const float value = before[a + cells[0] * b]; !std::isnan(value)) {
                            sum += value;
                            ++count;
                        }
                if (count > 0)
                    values[i + cells[0] * j] = sum / static_cast<float>(count);
            }
    }
}

std::vector<float> coarsened(const std::vector<float>& fine, const std::array<int, 2>& cells, int factor,
                             const std::array<int, 2>& coarse)
{
    std::vector<float> result(static_cast<std::size_t>(fine.empty() ? 0 : coarse[0] * coarse[1]));
    for (int j = 0; j < coarse[1] && !fine.empty(); ++j)
        for (int i = 0; i < coarse[0]; ++i) {
            float sum = 0;
            int count = 0;
            for (int b = factor * j; b < std::min(factor * (j + 1), cells[1]); ++b)
                for (int a = factor * i; a < std::min(factor * (i + 1), cells[0]); ++a)
                    if (const float value = fine[a + cells[0] * b]; !std::isnan(value)) {
                        sum += value;
                        ++count;
                    }
            result[i + coarse[0] * j] = count > 0 ? sum / static_cast<float>(count) : none;
        }
    return result;
}

void coarsen(FieldPlane& plane, long most_cells)
{
    int factor = 1;
    const auto shrunk = [&](int n) { return (n + factor - 1) / factor; };
    while (static_cast<long>(shrunk(plane.cells[0])) * shrunk(plane.cells[1]) > most_cells)
        ++factor;
    if (factor == 1)
        return;
    const std::array<int, 2> coarse{shrunk(plane.cells[0]), shrunk(plane.cells[1])};
    for (std::vector<float>* values : {&plane.pressure, &plane.speed, &plane.u, &plane.v, &plane.fluid})
        *values = coarsened(*values, plane.cells, factor, coarse);
    plane.cells = coarse;
    plane.spacing *= factor;
}

FieldPlane plane_of(const VtkContent& image, int axis, double position)
{
    FieldPlane plane;
    plane.axis = axis;
    plane.in_plane = axis == 0 ? std::array{1, 2} : axis == 1 ? std::array{0, 2} : std::array{0, 1};
    plane.spacing = image.spacing[0];
    for (int side = 0; side < 2; ++side) {
        plane.cells[side] = image.cells[plane.in_plane[side]];
        plane.low[side] = image.origin[plane.in_plane[side]];
    }
    const int layers = std::max(image.cells[axis], 1);
    const int layer = std::clamp(static_cast<int>(std::floor((position - image.origin[axis]) / plane.spacing)), 0, layers - 1);
    plane.position = layers == 1 ? position : image.origin[axis] + (layer + 0.5) * plane.spacing;
    const VtkArray* kind = image.cell_array("kind");
    const VtkArray* pressure = image.cell_array("pressure");
    const VtkArray* velocity = image.cell_array("velocity");
    for (int j = 0; j < plane.cells[1]; ++j)
        for (int i = 0; i < plane.cells[0]; ++i) {
            Eigen::Vector3i c = Eigen::Vector3i::Zero();
            c[plane.in_plane[0]] = i;
            c[plane.in_plane[1]] = j;
            c[axis] = layer;
            const auto at = static_cast<std::size_t>(c[0] + image.cells[0] * (c[1] + static_cast<long>(image.cells[1]) * c[2]));
            const int of = kind ? static_cast<int>(kind->values[at]) : bulk;
            const bool valued = of == bulk || of == mixed;
            plane.fluid.push_back(of == solid ? 0 : 1);
            if (pressure)
                plane.pressure.push_back(valued ? static_cast<float>(pressure->values[at]) : none);
            if (velocity) {
                const Eigen::Map<const Eigen::Vector3d> u(velocity->values.data() + 3 * at);
                plane.u.push_back(valued ? static_cast<float>(u[plane.in_plane[0]]) : none);
                plane.v.push_back(valued ? static_cast<float>(u[plane.in_plane[1]]) : none);
                plane.speed.push_back(valued ? static_cast<float>(u.norm()) : none);
            }
        }
    // Interpolation needs one layer. In 2D bodies and films are drawn over further layers, which avoid gaps in narrow corners; in
    // 3D they would stick out of a container.
    for (std::vector<float>* values : {&plane.pressure, &plane.speed, &plane.u, &plane.v})
        if (!values->empty())
            fill_next_to_values(*values, plane.cells, image.cells[2] == 0 ? 3 : 1);
    return plane;
}

FieldVolume volume_of(const VtkContent& image, long most_cells)
{
    FieldVolume volume;
    int factor = 1;
    const auto shrunk = [&](int axis) { return (image.cells[axis] + factor - 1) / factor; };
    while (static_cast<long>(shrunk(0)) * shrunk(1) * shrunk(2) > most_cells)
        ++factor;
    volume.spacing = factor * image.spacing[0];
    for (int axis = 0; axis < 3; ++axis) {
        volume.cells[axis] = shrunk(axis);
        volume.low[axis] = image.origin[axis];
    }
    const VtkArray* kind = image.cell_array("kind");
    const auto means = [&](const VtkArray* array, bool size) {
        std::vector<double> sum(static_cast<std::size_t>(shrunk(0)) * shrunk(1) * shrunk(2), 0);
        std::vector<int> count(sum.size(), 0);
        for (int k = 0; k < image.cells[2]; ++k)
            for (int j = 0; j < image.cells[1]; ++j)
                for (int i = 0; i < image.cells[0]; ++i) {
                    const auto at = static_cast<std::size_t>(i + image.cells[0] * (j + static_cast<long>(image.cells[1]) * k));
                    const int of = kind ? static_cast<int>(kind->values[at]) : bulk;
                    if (of != bulk && of != mixed)
                        continue;
                    const double value = size ? Eigen::Map<const Eigen::Vector3d>(array->values.data() + 3 * at).norm()
                                              : static_cast<double>(array->values[at]);
                    if (!std::isfinite(value))
                        continue;
                    const auto to = static_cast<std::size_t>(
                        i / factor + volume.cells[0] * (j / factor + static_cast<long>(volume.cells[1]) * (k / factor)));
                    sum[to] += value;
                    ++count[to];
                }
        std::vector<float> mean(sum.size(), none);
        for (std::size_t c = 0; c < sum.size(); ++c)
            if (count[c] > 0)
                mean[c] = static_cast<float>(sum[c] / count[c]);
        return mean;
    };
    if (const VtkArray* pressure = image.cell_array("pressure"))
        volume.pressure = means(pressure, false);
    if (const VtkArray* velocity = image.cell_array("velocity"))
        volume.speed = means(velocity, true);
    return volume;
}

FilmView film_of(const VtkContent& surface, int dimension)
{
    FilmView film;
    film.points = surface.points;
    film.elements = surface.elements;
    for (const auto& [name, to] : {std::pair{"thickness", &film.thickness}, std::pair{"pressure", &film.pressure}}) {
        const VtkArray* array = surface.point_array(name);
        for (std::size_t i = 0; i < film.points.size(); ++i)
            to->push_back(array ? static_cast<float>(array->values[i]) : none);
    }
    if (dimension == 2)
        film.chains = chains_of(film.elements);
    return film;
}

// Centre of mass and rotation of a body at a time, from bodies.csv.
struct Moment {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
};

Moment state_at(const StoredRun& run, const BodyView& body, double time)
{
    Moment state;
    if (body.rows.empty())
        return state;
    const std::vector<double>& times = run.bodies.number("time");
    auto after = std::lower_bound(body.rows.begin(), body.rows.end(), time,
                                  [&](std::size_t row, double wanted) { return times[row] < wanted; });
    if (after == body.rows.end() || (after != body.rows.begin() && times[*after] - time > time - times[*(after - 1)]))
        --after;
    const auto value = [&](const char* column) {
        const std::vector<double>& values = run.bodies.number(column);
        return values.empty() ? 0.0 : values[*after];
    };
    state.centre = {value("x"), value("y"), value("z")};
    if (run.dimension == 2)
        state.rotation = Eigen::AngleAxisd(value("angle"), Eigen::Vector3d::UnitZ()).matrix();
    else
        state.rotation = Eigen::Quaterniond(value("qw"), value("qx"), value("qy"), value("qz")).normalized().matrix();
    return state;
}

// 2D: a half-space as a large square behind its plane; a container with a rim around the domain.
void add_outlines(BodyView& body, const RunView& view, const nlohmann::ordered_json& scene)
{
    const double far = 4 * view.size.norm();
    const auto add_loop = [&](const std::array<Eigen::Vector3d, 4>& corners) {
        const int first = static_cast<int>(body.points.size());
        for (int i = 0; i < 4; ++i) {
            body.points.push_back(corners[i]);
            body.elements.insert(body.elements.end(), {first + i, first + (i + 1) % 4});
        }
    };
    if (body.shape == "half-space") {
        const double angle = scene.at("rotation").get<double>() * std::acos(-1.0) / 180;
        const Eigen::Vector3d normal =
            Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()) * triple_of(scene.at("normal")).normalized();
        const Eigen::Vector3d along(-normal[1], normal[0], 0), at = triple_of(scene.at("position"));
        add_loop({at - far * along, at + far * along, at + far * (along - normal), at - far * (along + normal)});
    }
    if (body.inside_out) {
        const Eigen::Vector3d middle = view.origin + 0.5 * view.size;
        add_loop({middle + far * Eigen::Vector3d(-1, -1, 0), middle + far * Eigen::Vector3d(1, -1, 0),
                  middle + far * Eigen::Vector3d(1, 1, 0), middle + far * Eigen::Vector3d(-1, 1, 0)});
    }
    body.outlines = chains_of(body.elements);
}

// The first frame's file of a body; else its place at the start.
double time_of_view(const StoredRun& run, const BodyView& body)
{
    for (const RunFrame& frame : run.frames)
        if (frame.bodies.contains(body.name))
            return frame.time;
    return 0;
}

Eigen::Vector3d slices_of(const StoredRun& run, const RunView& view)
{
    for (const RunFrame& frame : run.frames) {
        if (frame.films.empty())
            continue;
        const VtkContent film = read_vtk(run.folder / frame.films);
        if (film.points.empty())
            continue;
        Eigen::Vector3d mean = Eigen::Vector3d::Zero();
        for (const Eigen::Vector3d& x : film.points)
            mean += x / static_cast<double>(film.points.size());
        return mean;
    }
    for (const BodyView& body : view.bodies)
        if (body.motion == "free" && !body.rows.empty())
            return state_at(run, body, 0).centre;
    return view.origin + 0.5 * view.size;
}

} // namespace

namespace {

// The domain, or a window around the core of a graded grid: half as wide again on every side, a whole number of the core's cells.
void set_window(RunView& view, const nlohmann::ordered_json& domain)
{
    view.origin = triple_of(domain.at("origin"));
    view.size = triple_of(domain.at("size"));
    if (domain.contains("cells")) {
        view.spacing = view.size[0] / domain.at("cells").at(0).get<double>();
        return;
    }
    view.spacing = domain.at("spacing").get<double>();
    const Eigen::Vector3d low = triple_of(domain.at("core").at("low")), high = triple_of(domain.at("core").at("high"));
    for (int axis = 0; axis < view.dimension; ++axis) {
        const double end = view.origin[axis] + view.size[axis], around = 0.5 * (high[axis] - low[axis]);
        const double below = std::floor(std::min(around, low[axis] - view.origin[axis]) / view.spacing + 1e-6);
        const double above = std::floor(std::min(around, end - high[axis]) / view.spacing + 1e-6);
        view.origin[axis] = low[axis] - below * view.spacing;
        view.size[axis] = high[axis] + above * view.spacing - view.origin[axis];
    }
}

// How far the grid of a frame has moved since the start.
Eigen::Vector3d shift_of(const StoredRun& run, const VtkContent& grid)
{
    Eigen::Vector3d shift = -triple_of(run.scene->at("domain").at("origin"));
    for (int axis = 0; axis < 3; ++axis)
        shift[axis] += grid.coordinates[axis].front();
    return shift;
}

// How far the followed body has gone at a time, along the axes that the grid goes with it.
Eigen::Vector3d way_of_grid(const StoredRun& run, const RunView& view, double time)
{
    Eigen::Vector3d way = Eigen::Vector3d::Zero();
    const nlohmann::ordered_json& domain = run.scene->at("domain");
    if (!domain.contains("follow"))
        return way;
    const nlohmann::ordered_json& follow = domain.at("follow");
    for (const BodyView& body : view.bodies)
        if (body.name == follow.at("body").get<std::string>() && !body.rows.empty())
            for (const auto& name : follow.at("axes")) {
                const int axis = static_cast<int>(std::string("xyz").find(name.get<std::string>()));
                way[axis] = state_at(run, body, time).centre[axis] - state_at(run, body, 0).centre[axis];
            }
    return way;
}

} // namespace

RunView view_run(const StoredRun& run)
{
    const nlohmann::ordered_json& scene = *run.scene;
    RunView view;
    view.dimension = run.dimension;
    set_window(view, scene.at("domain"));
    for (const auto& entry : scene.at("body")) {
        BodyView body;
        body.name = entry.at("name").get<std::string>();
        body.motion = entry.at("motion").get<std::string>();
        body.shape = entry.at("shape").get<std::string>();
        body.inside_out = entry.value("inside_out", false);
        for (const RunFrame& frame : run.frames)
            if (const auto file = frame.bodies.find(body.name); file != frame.bodies.end()) {
                const VtkContent surface = read_vtk(run.folder / file->second);
                body.points = surface.points;
                body.elements = surface.elements;
                break;
            }
        if (run.dimension == 2)
            add_outlines(body, view, entry);
        view.bodies.push_back(std::move(body));
    }
    const std::vector<std::string>& names = run.bodies.text("body");
    std::map<std::string, BodyView*> by_name;
    for (BodyView& body : view.bodies)
        by_name[body.name] = &body;
    for (std::size_t row = 0; row < names.size(); ++row)
        if (const auto body = by_name.find(names[row]); body != by_name.end())
            body->second->rows.push_back(row);
    if (run.dimension == 3)
        view.slices = slices_of(run, view);
    return view;
}

FrameView view_frame(const StoredRun& run, const RunView& view, const RunFrame& frame, long most_cells, long most_volume_cells)
{
    FrameView result;
    result.number = frame.number;
    result.time = frame.time;
    result.shift = way_of_grid(run, view, frame.time);
    if (!frame.fields.empty()) {
        VtkContent image = read_vtk(run.folder / frame.fields);
        if (!image.coordinates[0].empty()) {
            const Eigen::Vector3i cells = (view.size / view.spacing).array().round().cast<int>();
            image = as_image(image, view.origin + shift_of(run, image), view.spacing, cells);
        }
        if (view.dimension == 2)
            result.planes.push_back(plane_of(image, 2, 0));
        for (int axis = 0; axis < 3 && view.dimension == 3; ++axis)
            result.planes.push_back(plane_of(image, axis, view.slices[axis] + result.shift[axis]));
        for (FieldPlane& plane : result.planes)
            coarsen(plane, most_cells);
        if (view.dimension == 3 && most_volume_cells > 0)
            result.volume = volume_of(image, most_volume_cells);
    }
    if (!frame.films.empty())
        result.film = film_of(read_vtk(run.folder / frame.films), view.dimension);
    for (const BodyView& body : view.bodies) {
        const Moment from = state_at(run, body, time_of_view(run, body)), to = state_at(run, body, frame.time);
        Placement placement;
        placement.rotation = to.rotation * from.rotation.transpose();
        placement.shift = to.centre - placement.rotation * from.centre;
        result.placements.push_back(placement);
    }
    return result;
}

std::vector<std::vector<int>> chains_of(const std::vector<int>& pairs)
{
    if (pairs.empty())
        return {};
    // Elements at every point; a chain starts at a point that has other than two, what remains are closed ones.
    std::vector<std::vector<int>> at(static_cast<std::size_t>(*std::max_element(pairs.begin(), pairs.end())) + 1);
    const int count = static_cast<int>(pairs.size() / 2);
    for (int e = 0; e < count; ++e)
        for (int end = 0; end < 2; ++end)
            at[pairs[2 * e + end]].push_back(e);
    std::vector<char> used(static_cast<std::size_t>(count));
    std::vector<std::vector<int>> chains;
    const auto follow = [&](int element, int from) {
        std::vector<int> chain{from};
        while (element >= 0) {
            used[element] = 1;
            const int to = pairs[2 * element] == chain.back() ? pairs[2 * element + 1] : pairs[2 * element];
            chain.push_back(to);
            element = -1;
            if (at[to].size() == 2)
                for (const int next : at[to])
                    if (!used[next])
                        element = next;
        }
        chains.push_back(std::move(chain));
    };
    for (const bool ends : {true, false})
        for (int e = 0; e < count; ++e)
            for (int end = 0; end < 2; ++end)
                if (!used[e] && (!ends || at[pairs[2 * e + end]].size() != 2))
                    follow(e, pairs[2 * e + end]);
    return chains;
}

std::array<float, 2> range_between(std::vector<float> values, double low_share, double high_share)
{
    std::erase_if(values, [](float value) { return !std::isfinite(value); });
    if (values.empty())
        return {0, 0};
    const auto at = [&](double share) {
        const auto middle = values.begin() + static_cast<long>(share * static_cast<double>(values.size() - 1) + 0.5);
        std::nth_element(values.begin(), middle, values.end());
        return *middle;
    };
    const float low = at(low_share);
    return {low, at(high_share)};
}

} // namespace gapflow
