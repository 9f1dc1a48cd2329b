#include "gapflow/output/run_files.hpp"

#include "gapflow/output/columns.hpp"
#include "gapflow/output/crowd_statistics.hpp"
#include "gapflow/output/field_arrays.hpp"
#include "gapflow/output/file.hpp"
#include "gapflow/output/run_folder.hpp"
#include "gapflow/output/vtk.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <limits>

namespace gapflow {

namespace {

template <int D>
auto rotation_numbers(const Rotation<D>& rotation)
{
    if constexpr (D == 2)
        return Eigen::Matrix<double, 1, 1>(rotation.angle());
    else
        return Eigen::Vector4d(rotation.w(), rotation.x(), rotation.y(), rotation.z());
}

// Folders of the run's folder with one file for each output time.
constexpr const char* parts[] = {"fields", "bodies", "films"};

// Removes incomplete files of a killed run, and files of output times from `frames` on.
void remove_leftovers(const std::filesystem::path& folder, int frames)
{
    const auto clean = [&](const std::filesystem::path& place, bool has_frames) {
        for (const auto& entry : std::filesystem::directory_iterator(place)) {
            const std::filesystem::path& file = entry.path();
            const std::string type = file.extension().string();
            const bool field = has_frames && (type == ".vti" || type == ".vtr" || type == ".vtp");
            if (type == partial_extension || (field && frame_number(file).value_or(0) >= frames))
                std::filesystem::remove(file);
        }
    };
    clean(folder, false);
    for (const char* part : parts)
        clean(folder / part, true);
}

std::vector<NpyColumn> binary_columns(const Scene& scene, const std::vector<std::string>& names)
{
    std::size_t longest = 1;
    for (const BodyScene& body : scene.bodies)
        longest = std::max(longest, count_characters(body.name));
    std::vector<NpyColumn> columns;
    for (const std::string& name : names)
        columns.push_back({name,
                           name == "step"   ? NpyColumn::Type::integer
                           : name == "body" ? NpyColumn::Type::text
                                            : NpyColumn::Type::real,
                           name == "body" ? longest : 0});
    return columns;
}

std::string frame_name(const std::string& name, int frame, const std::string& extension)
{
    char number[16];
    std::snprintf(number, sizeof number, "_%05d.", frame);
    return name + number + extension;
}

// Meshes half-way between the surfaces of gaps, with thickness, full pressure and velocity; and the depth of voids, where a scene can have some.
template <int D>
VtkSurface<D> film_surface(GapMeshes<D> gaps, bool voids)
{
    VtkSurface<D> surface{std::move(gaps.nodes), std::move(gaps.elements), {}, {}};
    VtkArray velocity{"velocity", D, {}};
    for (const Vec<D>& u : gaps.velocity)
        velocity.values.insert(velocity.values.end(), u.data(), u.data() + D);
    surface.point_data = {{"thickness", 1, std::move(gaps.thickness)}, {"pressure", 1, std::move(gaps.pressure)}};
    if (voids)
        surface.point_data.push_back({"void_depth", 1, std::move(gaps.void_depth)});
    surface.cell_data = {std::move(velocity)};
    return surface;
}

template <int D>
VtkSurface<D> body_surface(const RigidBody<D>& body, double tolerance)
{
    const SurfaceMesh<D> mesh = body.shape->display_mesh(tolerance);
    VtkSurface<D> surface;
    VtkArray velocity{"velocity", D, {}};
    for (const Vec<D>& x : mesh.vertices) {
        surface.points.push_back(body.pose.position + body.pose.matrix() * x);
        const Vec<D> u = velocity_at<D>(body.twist, surface.points.back() - body.centre());
        velocity.values.insert(velocity.values.end(), u.data(), u.data() + D);
    }
    surface.elements = mesh.elements;
    surface.point_data = {velocity};
    return surface;
}

// The bodies of a crowd that are still there, and the fluid's wrenches on them.
template <int D>
struct CrowdMembers {
    std::vector<RigidBody<D>> bodies;
    std::vector<Twist<D>> wrenches;
};

template <int D>
CrowdMembers<D> members_of(const Simulation<D>& simulation, const CrowdScene& crowd)
{
    CrowdMembers<D> members;
    for (int b = crowd.first; b < crowd.first + crowd.number; ++b)
        if (!simulation.removed(b)) {
            members.bodies.push_back(simulation.bodies()[b]);
            members.wrenches.push_back(simulation.fluid_wrenches()[b]);
        }
    return members;
}

// The last name in a table's first line; none if there is no table.
std::optional<std::string> last_column(const std::filesystem::path& path)
{
    std::ifstream in(path);
    std::string line;
    if (!std::getline(in, line))
        return {};
    return line.substr(line.rfind(',') + 1);
}

constexpr std::chrono::seconds renewal{30}; // of the record of a run that is running

} // namespace

template <int D>
RunFiles<D>::RunFiles(const std::filesystem::path& folder, const Simulation<D>& simulation, const std::string& version,
                      const RunPosition* from)
    : folder_(folder), collection_(folder / "gapflow.pvd"), measures_(simulation)
{
    const Communicator& comm = simulation.grid().comm();
    record_.version = version;
    record_.scene_file = path_of_scene(simulation.scene());
    record_.scene = scene_as_json(simulation.scene());
    record_.cells.assign(simulation.scene().cells.begin(), simulation.scene().cells.begin() + D);
    record_.machine = describe_machine(comm);
    record_.warnings = simulation.scene().warnings;
    on_root(comm, [&] {
        if (from)
            keep_notes(warnings_of_record(folder_ / "run.json"));
        for (const char* part : parts)
            prepare_folder(folder_ / part);
        if (from)
            collection_ = PvdCollection::resume(folder_ / "gapflow.pvd", from->frames);
        else
            clear_run(folder_);
        remove_leftovers(folder_, from ? from->frames : std::numeric_limits<int>::max());
        open_tables(simulation, from);
        if (from)
            collection_.write();
        keep_notes(simulation.initial_report().notes);
    });
    frame_ = from ? from->frames : 0;
    write_record(simulation);
}

template <int D>
void RunFiles<D>::keep_notes(const std::vector<std::string>& notes)
{
    for (const std::string& note : notes)
        if (std::find(record_.warnings.begin(), record_.warnings.end(), note) == record_.warnings.end())
            record_.warnings.push_back(note);
}

template <int D>
void RunFiles<D>::open_tables(const Simulation<D>& simulation, const RunPosition* from)
{
    const Scene& scene = simulation.scene();
    const auto open = [&](std::optional<Table>& table, const char* name, const std::vector<std::string>& columns) {
        if (from)
            table.emplace(Table::resume(folder_ / name, columns, from->step));
        else
            table.emplace(folder_ / name, columns);
    };
    std::vector<std::string> body{"step", "time", "body"};
    for (std::string& name : body_columns(D).all())
        body.push_back(std::move(name));
    // A run that goes on writes the tables that are there; a new one removes those of earlier runs that it does not write.
    const auto wanted = [&](const char* name, const char* other, bool by_scene) {
        const bool there = std::filesystem::exists(folder_ / name), other_there = std::filesystem::exists(folder_ / other);
        const bool write = from && (there || other_there) ? there : by_scene;
        if (!write)
            std::filesystem::remove(folder_ / name);
        return write;
    };
    const bool csv = wanted("bodies.csv", "bodies.npy", scene.writes_csv());
    const bool binary = wanted("bodies.npy", "bodies.csv", scene.writes_binary());
    if (csv)
        open(bodies_, "bodies.csv", body);
    if (binary) {
        const std::vector<NpyColumn> columns = binary_columns(scene, body);
        if (from)
            binary_bodies_.emplace(NpyTable::resume(folder_ / "bodies.npy", columns, from->step));
        else
            binary_bodies_.emplace(folder_ / "bodies.npy", columns);
    }
    const auto of_crowds = [&](std::optional<Table>& table, const char* name, const std::vector<std::string>& own) {
        if (scene.crowds.empty()) {
            std::filesystem::remove(folder_ / name);
            return;
        }
        std::vector<std::string> columns{"step", "time", "crowd"};
        columns.insert(columns.end(), own.begin(), own.end());
        open(table, name, columns);
    };
    of_crowds(crowds_, "crowds.csv", crowd_columns(D));
    of_crowds(profiles_, "crowd_profiles.csv", profile_columns(D));
    open(gaps_, "gaps.csv", names_of(gap_columns(), {"step", "time"}));
    measures_.open(folder_, scene, from);
    const bool driven = simulation.driven();
    const auto last = from ? last_column(folder_ / "steps.csv") : std::nullopt; // a run that goes on keeps the table's columns
    step_columns_ = step_columns(D, driven, last ? *last == unsteadiness_column : scene.until_steady.has_value(), scene.parts);
    open(steps_, "steps.csv", names_of<StepReport>(step_columns_));
}

template <int D>
void RunFiles<D>::write_step(const Simulation<D>& simulation, const StepReport& report)
{
    const Communicator& comm = simulation.grid().comm();
    keep_notes(report.notes);
    measures_.write_step(simulation, report);
    const std::vector<GapState> gaps = simulation.gaps();
    on_root(comm, [&] {
        for (std::size_t b = 0; b < simulation.bodies().size(); ++b) {
            if (simulation.removed(static_cast<int>(b)))
                continue;
            const RigidBody<D>& body = simulation.bodies()[b];
            const auto write = [&](auto& table) {
                if (table)
                    table->row(report.step, report.time, body.name, body.centre(), rotation_numbers<D>(body.pose.rotation),
                               body.twist, simulation.fluid_wrenches()[b]);
            };
            write(bodies_);
            write(binary_bodies_);
        }
        write_crowds(simulation, report);
        for (const GapState& gap : gaps)
            gaps_->row(report.step, report.time, Cells<GapState>{gap_columns(), gap});
        steps_->row(Cells<StepReport>{step_columns_, report});
        if (bodies_)
            bodies_->flush();
        if (binary_bodies_)
            binary_bodies_->flush();
        gaps_->flush();
        steps_->flush();
    });
    if (comm.any(comm.root() && std::chrono::steady_clock::now() - recorded_ > renewal))
        write_record(simulation);
}

template <int D>
void RunFiles<D>::write_crowds(const Simulation<D>& simulation, const StepReport& report)
{
    const Scene& scene = simulation.scene();
    for (const CrowdScene& crowd : scene.crowds) {
        const CrowdMembers<D> members = members_of(simulation, crowd);
        const CrowdStatistics<D> s = crowd_statistics<D>(members.bodies, members.wrenches, height_axis(scene));
        crowds_->row(report.step, report.time, crowd.name, s.number, s.position, s.velocity, s.fluctuation, s.spin,
                     Eigen::Vector3d(s.speed.data()), s.largest_speed, Eigen::Vector3d(s.height.data()), s.energy, s.force);
    }
    if (crowds_)
        crowds_->flush();
}

template <int D>
void RunFiles<D>::write_profiles(const Simulation<D>& simulation)
{
    for (const CrowdScene& crowd : simulation.scene().crowds)
        for (const CrowdLayer<D>& layer : crowd_profile<D>(simulation.scene(), members_of(simulation, crowd).bodies))
            profiles_->row(simulation.steps(), simulation.time(), crowd.name, layer.height, layer.number, layer.volume_fraction,
                           layer.velocity);
    if (profiles_)
        profiles_->flush();
}

template <int D>
void RunFiles<D>::write_fields(const Simulation<D>& simulation)
{
    const Scene& scene = simulation.scene();
    const VtkOptions options{scene.precision == Scene::Precision::single ? VtkPrecision::float32 : VtkPrecision::float64,
                             simulation.time(), scene.format == Scene::Format::appended};
    std::vector<VtkArray> arrays;
    for (const std::string& field : scene.fields)
        arrays.push_back(field_array(simulation, field));
    arrays.push_back(field_array(simulation, "kind"));
    const std::string fields = "fields/" + frame_name("fields", frame_, cells_extension(simulation.grid()));
    write_cells<D>(folder_ / fields, simulation.grid(), arrays, options);
    const VtkSurface<D> gaps = film_surface(simulation.gap_meshes(), simulation.voids_are_possible());
    on_root(simulation.grid().comm(), [&] {
        collection_.add(simulation.time(), "fields", fields);
        for (const RigidBody<D>& body : simulation.bodies()) {
            if (simulation.removed(static_cast<int>(&body - simulation.bodies().data())))
                continue;
            const VtkSurface<D> surface = body_surface(body, 0.05 * simulation.grid().dx());
            if (surface.elements.empty()) // half-spaces have no end
                continue;
            const std::string file = "bodies/" + frame_name(body.name, frame_, "vtp");
            write_vtp<D>(folder_ / file, surface, options);
            collection_.add(simulation.time(), body.name, file);
        }
        write_profiles(simulation);
        const std::string films = "films/" + frame_name("films", frame_, "vtp");
        write_vtp<D>(folder_ / films, gaps, options);
        collection_.add(simulation.time(), "films", films);
        collection_.write();
    });
    ++frame_;
    write_record(simulation);
}

template <int D>
void RunFiles<D>::write_checkpoint(const Simulation<D>& simulation, double smallest_gap)
{
    const RunPosition position{simulation.steps(), frame_, smallest_gap};
    gapflow::write_checkpoint(folder_ / "checkpoint.h5", {record_.version, record_.scene, position, simulation.state()},
                              simulation.grid().comm());
}

template <int D>
void RunFiles<D>::finish(const Simulation<D>& simulation, const std::string& status, const std::string& message,
                         const std::string& ended_by)
{
    record_.status = status;
    record_.message = message;
    record_.ended_by = ended_by;
    write_record(simulation);
}

template <int D>
void RunFiles<D>::write_record(const Simulation<D>& simulation)
{
    record_.time = simulation.time();
    record_.steps = simulation.steps();
    record_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    record_.stages = simulation.stages().stages();
    record_.memory = peak_memory(simulation.grid().comm());
    recorded_ = std::chrono::steady_clock::now();
    on_root(simulation.grid().comm(), [&] { write_run_record(folder_ / "run.json", record_); });
}

template class RunFiles<2>;
template class RunFiles<3>;

} // namespace gapflow
