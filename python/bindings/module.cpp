// gapflow._core: the extension module of the Python package. Users use the classes of python/gapflow, which document it.
#include "runtime.hpp"
#include "session.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/core/text.hpp"
#include "gapflow/output/checkpoint.hpp"
#include "gapflow/scene/parse_scene.hpp"
#include "gapflow/stepping/added_mass.hpp"
#include "gapflow/stepping/first_acceleration.hpp"

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

namespace py = pybind11;

namespace gapflow {

namespace {

Purpose purpose_of(const std::string& name)
{
    return name == "run" ? Purpose::run : name == "added_mass" ? Purpose::added_mass : Purpose::check;
}

py::dict added_mass_dict(const Scene& scene)
{
    using namespace py::literals;
    runtime().start();
    AddedMass result;
    {
        const Computing computing;
        result = added_mass(scene, Communicator());
    }
    py::array_t<double> matrix({result.matrix.rows(), result.matrix.cols()});
    for (long i = 0; i < result.matrix.rows(); ++i)
        for (long j = 0; j < result.matrix.cols(); ++j)
            matrix.mutable_at(i, j) = result.matrix(i, j);
    py::list sealed;
    for (const SealedPocket& pocket : result.sealed)
        sealed.append(
            py::dict("cells"_a = pocket.cells, "film_nodes"_a = pocket.nodes, "bodies"_a = pocket.bodies, "at"_a = pocket.at));
    return py::dict("bodies"_a = result.bodies, "labels"_a = result.labels, "matrix"_a = matrix, "cells"_a = result.cells,
                    "film_nodes"_a = result.film_nodes, "iterations"_a = result.iterations, "sealed"_a = sealed,
                    "warnings"_a = result.warnings, "seconds"_a = result.seconds);
}

py::dict first_accelerations_dict(const Scene& scene)
{
    runtime().start();
    FirstAccelerations result;
    {
        const Computing computing;
        result = first_accelerations(scene, Communicator());
    }
    py::dict accelerations;
    for (std::size_t b = 0; b < result.bodies.size(); ++b)
        accelerations[py::str(result.bodies[b])] = py::cast(result.acceleration[b]);
    return accelerations;
}

// Names of the bodies and how each moves.
std::vector<std::pair<std::string, std::string>> bodies(const Scene& scene)
{
    std::vector<std::pair<std::string, std::string>> result;
    for (const BodyScene& body : scene.bodies)
        result.emplace_back(body.name, body.motion == BodyScene::Motion::free    ? "free"
                                       : body.motion == BodyScene::Motion::fixed ? "fixed"
                                                                                 : "prescribed");
    return result;
}

// A body's quaternion as a checkpoint has it: read again it would be normalised again, which changes its last bits. Others stay.
void put_back_quaternion(Scene& scene, std::size_t body, const std::array<double, 4>& quaternion)
{
    double apart = 0;
    for (std::size_t k = 0; k < 4; ++k)
        apart = std::max(apart, std::abs(quaternion[k] - scene.bodies.at(body).quaternion[k]));
    if (apart < 1e-12)
        scene.bodies[body].quaternion = quaternion;
}

void close_session(Session& session)
{
    if (session.views() > 0)
        throw py::buffer_error(std::to_string(session.views()) + " view(s) of faces are alive; delete them first");
    session.end();
}

} // namespace

} // namespace gapflow

PYBIND11_MODULE(_core, m)
{
    using namespace gapflow;
    m.attr("__version__") = GAPFLOW_VERSION;
    py::register_exception<InputError>(m, "InputError", PyExc_ValueError).attr("__module__") = "gapflow";
    py::register_exception<ComputationError>(m, "ComputationError", PyExc_RuntimeError).attr("__module__") = "gapflow";

    py::class_<Scene>(m, "Scene")
        .def_readonly("dimension", &Scene::dimension)
        .def_readonly("end", &Scene::end)
        .def_readonly("output_directory", &Scene::output_directory)
        .def_readonly("warnings", &Scene::warnings)
        .def_property_readonly("bodies", &bodies)
        .def("put_back_quaternion", &put_back_quaternion)
        .def("json", &scene_as_json);
    m.def("parse_scene", [](const std::string& text, const std::string& name, const Overrides& overrides,
                            const std::string& purpose) { return parse_scene(text, name, overrides, purpose_of(purpose)); });
    m.def("read_scene", [](const std::string& file, const Overrides& overrides, const std::string& purpose) {
        return read_scene(file, overrides, purpose_of(purpose));
    });
    m.def("gap_columns", &gap_column_types);
    m.def("nearest_name", &nearest_name);
    m.def("checkpoint_scene", [](const std::string& file) {
        runtime().start();
        const Computing computing;
        return read_checkpoint(file, Communicator()).scene;
    });
    m.def("added_mass", &added_mass_dict);
    m.def("first_accelerations", &first_accelerations_dict);

    py::class_<Session, std::shared_ptr<Session>>(m, "Session")
        .def(py::init(&Session::make))
        .def_static("start_grid", &Session::start_grid)
        .def_property_readonly("dimension", &Session::dimension)
        .def_property_readonly("time", &Session::time)
        .def_property_readonly("steps", &Session::steps)
        .def_property_readonly("ended_by", &Session::ended_by)
        .def("report", &Session::report)
        .def("step", &Session::step)
        .def("set_force", &Session::set_force)
        .def("set_velocity", &Session::set_velocity)
        .def("copy", &Session::copy)
        .def("change", &Session::change)
        .def("demand_changeable", &Session::demand_changeable)
        .def("grid", &Session::grid)
        .def("bodies", &Session::bodies)
        .def("velocity", &Session::velocity)
        .def("vorticity", &Session::vorticity)
        .def("pressure", &Session::pressure)
        .def("kind", &Session::kind)
        .def("films", &Session::films)
        .def("gaps", &Session::gaps)
        .def("write_checkpoint", &Session::write_checkpoint)
        .def("budget", &Session::budget)
        .def("stages", &Session::stages)
        .def("surface", &Session::surface)
        .def("face_velocity", &Session::face_velocity)
        .def("face_fraction", &Session::face_fraction)
        .def("close", &close_session);
    m.def("shutdown", [] { runtime().shutdown(); });
    m.def("rank", [] {
        runtime().start();
        const Communicator comm;
        return py::make_tuple(comm.rank(), comm.size());
    });
}
