#include "session.hpp"

#include "runtime.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/core/text.hpp"
#include "gapflow/output/columns.hpp"
#include "gapflow/output/run.hpp"
#include "gapflow/stepping/setup.hpp"

#include <pybind11/stl.h>

#include <limits>
#include <optional>

namespace py = pybind11;

namespace gapflow {

namespace {

using Numbers = py::array_t<double>;

template <class T, int N, class F>
py::array_t<T> table(std::size_t rows, F&& row)
{
    py::array_t<T> out({static_cast<py::ssize_t>(rows), static_cast<py::ssize_t>(N)});
    auto values = out.template mutable_unchecked<2>();
    for (std::size_t i = 0; i < rows; ++i) {
        const auto& from = row(i);
        for (int k = 0; k < N; ++k)
            values(i, k) = from[k];
    }
    return out;
}

template <class F>
Numbers column(std::size_t rows, F&& value)
{
    Numbers out(static_cast<py::ssize_t>(rows));
    auto values = out.mutable_unchecked<1>();
    for (std::size_t i = 0; i < rows; ++i)
        values(i) = value(i);
    return out;
}

// Angular velocities and torques: one number a row in 2D, three in 3D.
template <int D, class F>
Numbers spins(std::size_t rows, F&& spin)
{
    if constexpr (D == 2)
        return column(rows, [&](std::size_t i) { return spin(i)[0]; });
    else
        return table<double, 3>(rows, spin);
}

template <int D>
Numbers vector_array(const Eigen::Matrix<double, D, 1>& v)
{
    return Numbers(v.size(), v.data());
}

template <int D>
std::vector<int> indices(const Index<D>& i)
{
    return {i.data(), i.data() + D};
}

template <class Row>
py::object cell(const Row& row, const Column<Row>& column)
{
    return std::visit([&](auto member) { return py::cast(row.*member); }, column.member);
}

py::dict report_dict(const StepReport& report, int dimension, bool driven)
{
    py::dict out;
    for (const Column<StepReport>& column : step_columns(dimension, driven))
        out[column.name] = cell(report, column);
    out["notes"] = report.notes;
    return out;
}

/// What a simulation cannot change although a scene can have it: which sides are walls, open or inflow, and whether there is viscosity.
void require_changeable(const Scene& from, const Scene& to)
{
    for (int side = 0; side < 2 * from.dimension; ++side)
        if (from.sides[side].kind != to.sides[side].kind)
            throw InputError(
                "domain.sides." + side_names[side] +
                ": a side stays a wall, open, periodic or inflow during a run; give another velocity of the same kind");
    if ((from.viscosity > 0) != (to.viscosity > 0))
        throw InputError("fluid.viscosity = " + number_text(to.viscosity) + ": cannot be " +
                         (to.viscosity > 0 ? "switched on" : "0") + " during a run " +
                         (to.viscosity > 0 ? "that started without; start with a small one"
                                           : "that started with it; "
                                             "give a small one"));
}

template <int D>
py::dict grid_dict(const Grid<D>& g)
{
    using namespace py::literals;
    std::vector<bool> periodic;
    for (int axis = 0; axis < D; ++axis)
        periodic.push_back(g.periodic(axis));
    py::object places = py::none();
    if (g.graded()) {
        py::list of_axes;
        for (int axis = 0; axis < D; ++axis) {
            py::array_t<double> x(g.cells()[axis] + 1);
            for (int i = 0; i <= g.cells()[axis]; ++i)
                x.mutable_at(i) = g.face_place(axis, i);
            of_axes.append(std::move(x));
        }
        places = py::tuple(of_axes);
    }
    return py::dict("origin"_a = vector_array<D>(g.origin()), "spacing"_a = g.dx(), "places"_a = places,
                    "cells"_a = py::tuple(py::cast(indices<D>(g.cells()))), "low"_a = py::tuple(py::cast(indices<D>(g.low()))),
                    "high"_a = py::tuple(py::cast(indices<D>(g.high()))), "periodic"_a = py::tuple(py::cast(periodic)));
}

template <int D>
py::dict start_grid_dict(const Scene& scene)
{
    std::optional<Grid<D>> grid;
    {
        const Computing computing;
        grid = make_grid<D>(scene, Communicator());
    }
    return grid_dict(*grid);
}

/// Reads arrays only: needs no GIL.
template <int D>
FaceField<D> face_field(const Grid<D>& grid, const Session::FaceArrays& arrays)
{
    FaceField<D> field(grid);
    for (int axis = 0; axis < D; ++axis) {
        const auto values = arrays.at(axis).template unchecked<D>();
        const Index<D> end = owned_faces_end(grid, axis);
        for (int k = 0; k < D; ++k)
            if (values.shape(k) != end[k] - grid.low()[k])
                throw InputError("velocity: the arrays have other shapes than the grid's faces");
        for_each_index<D>(grid.low(), end, [&](const Index<D>& f) {
            const Index<D> i = f - grid.low();
            if constexpr (D == 2)
                field(axis, f) = values(i[0], i[1]);
            else
                field(axis, f) = values(i[0], i[1], i[2]);
        });
    }
    return field;
}

template <int D>
class SessionOf : public Session {
public:
    SessionOf(const Scene& scene, const std::string& folder, const std::string& resume, const FaceArrays& velocity)
        : scene_(scene)
    {
        const Computing computing;
        std::optional<FaceField<D>> faces;
        if (!velocity.empty())
            faces = face_field(make_grid<D>(scene_, Communicator()), velocity);
        run_ = std::make_unique<Run<D>>(scene_, Communicator(), RunPlace{folder, resume, GAPFLOW_VERSION},
                                        faces ? &*faces : nullptr);
        run_->write_start();
    }

    SessionOf(const Scene& scene, std::unique_ptr<Run<D>> run) : scene_(scene), run_(std::move(run)) {}

    ~SessionOf() override { end_or_print(); }

    int dimension() const override { return D; }
    double time() const override { return any_state().time(); }
    long steps() const override { return any_state().steps(); }
    std::string ended_by() const override { return any_run().ended() ? any_run().ended_by() : ""; }
    const Scene& scene() const override { return scene_; }
    py::dict report() const override { return report_dict(any_run().report(), D, any_state().driven()); }

    py::dict step(double until) override
    {
        state();
        demand_no_views("a step would change what they show");
        if (!(until > state().time()))
            throw InputError("until = " + std::to_string(until) + ": the time is " + std::to_string(state().time()) +
                             " already; give a later one");
        try {
            const Busy busy(busy_);
            const Computing computing;
            run_->step(until);
        } catch (const std::exception& error) { // after any error the step is incomplete and the state invalid
            failure_ = error.what();
            throw;
        }
        handle_signals();
        return report_dict(run_->report(), D, state().driven());
    }

    void set_force(const std::string& body, const std::vector<double>& force, const std::vector<double>& torque) override
    {
        const int b = number_of(body);
        run_->simulation().set_force(b, vec("force", force), spin("torque", torque));
    }

    void set_velocity(const std::string& body, const std::vector<double>& velocity,
                      const std::vector<double>& angular_velocity) override
    {
        const int b = number_of(body);
        run_->simulation().set_velocity(b, vec("velocity", velocity), spin("angular_velocity", angular_velocity));
    }

    std::shared_ptr<Session> copy() const override
    {
        state();
        const Busy busy(busy_);
        std::unique_ptr<Run<D>> run;
        {
            const Computing computing;
            run = run_->copy();
        }
        return std::make_shared<SessionOf>(scene_, std::move(run));
    }

    void change(const Scene& scene) override
    {
        state();
        demand_no_views("a change would free what they show");
        try {
            const Busy busy(busy_);
            const Computing computing;
            run_->change(scene);
        } catch (const StateError& error) {
            throw InputError(std::string("cannot change that during a run: ") + error.what() +
                             "; start another simulation with the new scene");
        }
        scene_ = scene;
    }

    void demand_changeable(const Scene& scene) const override { require_changeable(scene_, scene); }

    py::dict grid() const override { return grid_dict(state().grid()); }

    py::dict bodies() const override
    {
        using namespace py::literals;
        const std::vector<RigidBody<D>>& b = state().bodies();
        const std::vector<Twist<D>>& fluid = state().fluid_wrenches();
        const std::size_t n = b.size();
        const auto linear = [](const Twist<D>& twist) { return Vec<D>(twist.template head<D>()); };
        const auto angular = [](const Twist<D>& twist) { return Spin<D>(twist.template tail<spin_size<D>>()); };
        py::dict out("centre"_a = table<double, D>(n, [&](std::size_t i) { return b[i].centre(); }),
                     "position"_a = table<double, D>(n, [&](std::size_t i) { return b[i].pose.position; }),
                     "velocity"_a = table<double, D>(n, [&](std::size_t i) { return linear(b[i].twist); }),
                     "angular_velocity"_a = spins<D>(n, [&](std::size_t i) { return angular(b[i].twist); }),
                     "fluid_force"_a = table<double, D>(n, [&](std::size_t i) { return linear(fluid[i]); }),
                     "fluid_torque"_a = spins<D>(n, [&](std::size_t i) { return angular(fluid[i]); }),
                     "force"_a = table<double, D>(n, [&](std::size_t i) { return b[i].force; }),
                     "torque"_a = spins<D>(n, [&](std::size_t i) { return b[i].torque; }),
                     "mass"_a = column(n, [&](std::size_t i) { return b[i].mass; }),
                     "volume"_a = column(n, [&](std::size_t i) { return b[i].volume; }));
        if constexpr (D == 2) {
            out["angle"] = column(n, [&](std::size_t i) { return b[i].pose.rotation.angle(); });
            out["inertia"] = column(n, [&](std::size_t i) { return b[i].inertia(0, 0); });
        } else {
            out["quaternion"] = table<double, 4>(n, [&](std::size_t i) {
                const Rotation<3>& q = b[i].pose.rotation;
                return Eigen::Vector4d(q.w(), q.x(), q.y(), q.z());
            });
            out["inertia"] = table<double, 9>(n, [&](std::size_t i) {
                                 return Eigen::Map<const Eigen::Matrix<double, 9, 1>>(b[i].inertia.data()).eval();
                             }).reshape({static_cast<py::ssize_t>(n), py::ssize_t{3}, py::ssize_t{3}});
        }
        return out;
    }

    py::array velocity() const override
    {
        const FaceField<D>& u = state().velocity().grid;
        return cells<double>(D, [&](const Index<D>& c, double* out) {
            for (int axis = 0; axis < D; ++axis)
                out[axis] = 0.5 * (u(axis, c) + u(axis, c + gapflow::step<D>(axis)));
        });
    }

    // Means of central differences over the cell: velocities at the centres of neighbours, which beyond sides are the ghosts'.
    py::array vorticity() const override
    {
        const FaceField<D>& u = state().velocity().grid;
        const Grid<D>& grid = state().grid();
        const auto slope = [&](const Index<D>& c, int of, int along) { // d u_of / d x_along
            const double between = grid.spread(along, c[along]) + grid.spread(along, c[along] + 1);
            const auto centre = [&](const Index<D>& at) { return 0.5 * (u(of, at) + u(of, at + gapflow::step<D>(of))); };
            return (centre(c + gapflow::step<D>(along)) - centre(c - gapflow::step<D>(along))) / (between * grid.dx());
        };
        return cells<double>(D == 2 ? 0 : 3, [&](const Index<D>& c, double* out) {
            if constexpr (D == 2)
                *out = slope(c, 1, 0) - slope(c, 0, 1);
            else
                for (int axis = 0; axis < 3; ++axis)
                    out[axis] = slope(c, (axis + 2) % 3, (axis + 1) % 3) - slope(c, (axis + 1) % 3, (axis + 2) % 3);
        });
    }

    py::array pressure() const override
    {
        const UnknownVector<D> p = state().reduced_pressure();
        const CellField<D, int>& component = state().coupling().system.component;
        return cells<double>(0, [&](const Index<D>& c, double* out) {
            *out = component(c) < 0 ? std::numeric_limits<double>::quiet_NaN()
                                    : p.cells(c) + state().hydrostatic(state().grid().cell_centre(c));
        });
    }

    py::array kind() const override
    {
        const auto& kind = state().coupling().kind;
        return cells<std::int8_t>(0, [&](const Index<D>& c, std::int8_t* out) { *out = static_cast<std::int8_t>(kind(c)); });
    }

    py::dict films() const override
    {
        using namespace py::literals;
        const GapMeshes<D> gaps = state().gap_meshes();
        const std::vector<Solid<D>>& solids = state().coupling().solids;
        py::list pairs;
        for (const auto& [a, b] : gaps.solids)
            pairs.append(py::make_tuple(solids[a].name, solids[b].name));
        const auto numbers = [](const std::vector<double>& v) { return Numbers(static_cast<py::ssize_t>(v.size()), v.data()); };
        const auto integers = [](const std::vector<int>& v) {
            return py::array_t<int>(static_cast<py::ssize_t>(v.size()), v.data());
        };
        const auto vectors = [](const std::vector<Vec<D>>& v) {
            return table<double, D>(v.size(), [&](std::size_t i) -> const Vec<D>& { return v[i]; });
        };
        return py::dict("bodies"_a = pairs, "nodes"_a = vectors(gaps.nodes), "node_film"_a = integers(gaps.node_gap),
                        "thickness"_a = numbers(gaps.thickness), "pressure"_a = numbers(gaps.pressure),
                        "void_depth"_a = numbers(gaps.void_depth),
                        "elements"_a = table<int, D>(
                            gaps.elements.size(), [&](std::size_t i) -> const auto& { return gaps.elements[i]; }),
                        "element_film"_a = integers(gaps.element_gap), "velocity"_a = vectors(gaps.velocity),
                        "normal"_a = vectors(gaps.normal), "area"_a = numbers(gaps.area));
    }

    py::list gaps() const override
    {
        py::list rows;
        for (const GapState& gap : state().gaps()) {
            py::list row;
            for (const Column<GapState>& column : gap_columns())
                row.append(cell(gap, column));
            rows.append(py::tuple(row));
        }
        return rows;
    }

    py::dict budget() const override
    {
        using namespace py::literals;
        const Budget<D> b = state().budget();
        return py::dict("momentum"_a = vector_array<D>(b.momentum),
                        "angular_momentum"_a = vector_array<spin_size<D>>(b.angular_momentum), "energy_grid"_a = b.energy_grid,
                        "energy_film"_a = b.energy_film, "energy_bodies"_a = b.energy_bodies);
    }

    py::dict stages() const override
    {
        py::dict out;
        for (const auto& [name, stage] : state().stages().stages())
            out[py::str(name)] = stage.seconds;
        return out;
    }

    py::tuple surface(const std::string& body, double tolerance) const override
    {
        const RigidBody<D>& b = state().bodies()[number_of(body)];
        const SurfaceMesh<D> mesh = b.shape->display_mesh(tolerance);
        const Mat<D> rotation = b.pose.matrix();
        return py::make_tuple(
            table<double, D>(mesh.vertices.size(),
                             [&](std::size_t i) { return Vec<D>(b.pose.position + rotation * mesh.vertices[i]); }),
            table<int, D>(
                mesh.elements.size(), [&](std::size_t i) -> const auto& { return mesh.elements[i]; }));
    }

    py::array face_velocity(int axis) override { return face_view(state().velocity().grid, axis); }
    py::array face_fraction(int axis) override { return face_view(state().coupling().open, axis); }

    void end() override
    {
        if (!run_)
            return;
        const Computing computing;
        const std::unique_ptr<Run<D>> run = std::move(run_);
        if (failure_.empty()) {
            if (run->simulation().time() < scene_.end)
                run->interrupt();
            else
                run->finish();
        }
        if (views_ > 0)
            (void)run->release().release(); // Python is ending: the memory goes with the process
    }

    void write_checkpoint(const std::string& file) override
    {
        state();
        const Busy busy(busy_);
        const Computing computing;
        run_->write_checkpoint(file);
    }

private:
    struct Busy {
        explicit Busy(bool& busy_) : busy(busy_) { busy = true; }
        ~Busy() { busy = false; }
        bool& busy;
    };

    const Run<D>& any_run() const
    {
        if (busy_)
            throw std::runtime_error("another thread is stepping this simulation; wait until it is done");
        if (!run_)
            throw std::runtime_error("the simulation is closed");
        return *run_;
    }
    const Simulation<D>& any_state() const { return any_run().simulation(); }

    const Simulation<D>& state() const
    {
        any_state();
        if (!failure_.empty())
            throw ComputationError("the simulation has failed and has no state to read: " + failure_);
        return run_->simulation();
    }

    void demand_no_views(const char* why) const
    {
        if (views_ > 0)
            throw py::buffer_error(std::to_string(views_) + " view(s) of faces are alive, and " + why +
                                   "; delete them first, or keep copies (numpy.array(view))");
    }

    void handle_signals() const
    {
        const bool raised = PyErr_CheckSignals() != 0;
        bool any = raised;
        if (const Communicator comm; comm.size() > 1)
            any = comm.any(raised);
        if (any && !raised)
            PyErr_SetNone(PyExc_KeyboardInterrupt);
        if (any)
            throw py::error_already_set();
    }

    int number_of(const std::string& name) const
    {
        const std::vector<RigidBody<D>>& b = state().bodies();
        for (std::size_t i = 0; i < b.size(); ++i)
            if (b[i].name == name)
                return static_cast<int>(i);
        throw py::key_error("no body is named '" + name + "'");
    }

    static Vec<D> vec(const char* what, const std::vector<double>& values) { return sized<D>(what, values); }
    static Spin<D> spin(const char* what, const std::vector<double>& values) { return sized<spin_size<D>>(what, values); }
    template <int N>
    static Eigen::Matrix<double, N, 1> sized(const char* what, const std::vector<double>& values)
    {
        if (values.size() != N)
            throw InputError(std::string(what) + ": has " + std::to_string(values.size()) + " number(s); give " +
                             std::to_string(N));
        return Eigen::Map<const Eigen::Matrix<double, N, 1>>(values.data());
    }

    /// An array [x, y(, z)], with one more axis if there are `components`, of this rank's cells.
    template <class T, class F>
    py::array cells(int components, F&& value) const
    {
        const Grid<D>& g = state().grid();
        std::vector<py::ssize_t> shape;
        for (int axis = 0; axis < D; ++axis)
            shape.push_back(g.high()[axis] - g.low()[axis]);
        if (components > 0)
            shape.push_back(components);
        py::array_t<T> out(shape);
        T* data = out.mutable_data();
        for_each_index<D>(g.low(), g.high(), [&](const Index<D>& c) {
            long place = 0;
            for (int axis = 0; axis < D; ++axis)
                place = place * (g.high()[axis] - g.low()[axis]) + c[axis] - g.low()[axis];
            value(c, data + place * std::max(components, 1));
        });
        return out;
    }

    py::array face_view(const FaceField<D>& field, int axis)
    {
        if (axis < 0 || axis >= D)
            throw py::index_error("axis " + std::to_string(axis) + " of " + std::to_string(D));
        const Grid<D>& g = state().grid();
        const Index<D> extent = owned_faces_end(g, axis) - g.low();
        std::vector<py::ssize_t> shape, strides;
        for (int k = 0; k < D; ++k) {
            shape.push_back(extent[k]);
            strides.push_back(static_cast<py::ssize_t>(sizeof(double)) * field[axis].block().stride[k]);
        }
        const py::capsule keeper(new SessionView(shared_from_this()),
                                 [](void* view) { delete static_cast<SessionView*>(view); });
        py::array view(py::dtype::of<double>(), shape, strides, &field(axis, g.low()), keeper);
        view.attr("flags").attr("writeable") = false;
        return view;
    }

    Scene scene_;
    std::unique_ptr<Run<D>> run_;
    mutable bool busy_ = false; ///< a thread computes; changed and read with the GIL held
    std::string failure_;
};

} // namespace

Session::Session()
{
    runtime().enter(this);
}

Session::~Session()
{
    runtime().leave(this);
}

void Session::end_or_print()
{
    try {
        end();
    } catch (const std::exception& error) {
        PySys_FormatStderr("gapflow: %s\n", error.what());
    }
}

std::vector<std::pair<std::string, std::string>> gap_column_types()
{
    std::vector<std::pair<std::string, std::string>> types;
    for (const Column<GapState>& column : gap_columns()) {
        const bool text = std::holds_alternative<std::string GapState::*>(column.member);
        const bool real = std::holds_alternative<double GapState::*>(column.member);
        types.emplace_back(column.name, text ? "U" : real ? "f8" : "i8");
    }
    return types;
}

std::shared_ptr<Session> Session::make(const Scene& scene, const std::string& folder, const std::string& resume,
                                       const FaceArrays& velocity)
{
    runtime().start();
    if (scene.dimension == 2)
        return std::make_shared<SessionOf<2>>(scene, folder, resume, velocity);
    return std::make_shared<SessionOf<3>>(scene, folder, resume, velocity);
}

py::dict Session::start_grid(const Scene& scene)
{
    runtime().start();
    return scene.dimension == 2 ? start_grid_dict<2>(scene) : start_grid_dict<3>(scene);
}

} // namespace gapflow
