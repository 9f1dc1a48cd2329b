#include "gapflow/geometry/sheet.hpp"
#include "gapflow/scene/body_shape.hpp"
#include "gapflow/scene/check_keys.hpp"
#include "gapflow/scene/read_parts.hpp"
#include "gapflow/scene/time_table.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/core/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

namespace gapflow {

namespace {

using ShapeKind = BodyScene::ShapeKind;
using Motion = BodyScene::Motion;

bool contains(const std::vector<std::string>& list, const std::string& word)
{
    return std::find(list.begin(), list.end(), word) != list.end();
}

void read_name(const Values& v, const Scene& scene, BodyScene& body)
{
    body.name = v.text("name");
    check_body_name(v, body.name);
    for (const BodyScene& other : scene.bodies)
        if (other.name == body.name)
            v.refuse("name", "an earlier [[body]] has this name", "give every body a name of its own");
}

/// The shape's own keys: all of them are needed but mesh scale; keys of other shapes are refused.
void check_shape_keys(const Values& v, const std::string& shape, ShapeKind kind)
{
    static const std::vector<std::vector<std::string>> keys_of{{"size"},
                                                               {"radius"},
                                                               {"radius", "length"},
                                                               {"radius", "length"},
                                                               {"normal"},
                                                               {"file", "scale"},
                                                               {"thickness", "points", "file", "scale"}};
    static const std::vector<std::string> optional{"scale", "points"};
    const auto& own = keys_of[static_cast<std::size_t>(kind)];
    for (const char* name : {"size", "radius", "length", "normal", "scale", "points", "thickness"})
        if (v.given(name) && !contains(own, name))
            v.refuse(name, "a " + shape + " has no " + name, "remove it; the keys of this shape are: " + joined(own));
    for (const std::string& name : own)
        if (!contains(optional, name) && !v.given(name) && !(name == "file" && v.given("points")))
            v.refuse_missing(name, "a " + shape + " needs it" +
                                       (kind == ShapeKind::sheet && name == "file" && v.dimension() == 2 ? ", or points" : ""));
}

ShapeKind shape_named(const std::string& word)
{
    static const std::vector<std::string> words{"box", "ball", "capsule", "cylinder", "half-space", "mesh", "sheet"};
    return static_cast<ShapeKind>(std::find(words.begin(), words.end(), word) - words.begin());
}

void read_surface_path(const Values& v, const Scene& scene, BodyScene& body)
{
    body.mesh_file = resolved_path(scene, v.text("file"));
    std::error_code error;
    if (!std::filesystem::is_regular_file(body.mesh_file, error) || !std::ifstream(body.mesh_file))
        v.refuse("file", "cannot read the " + v.text("shape") + " " + body.mesh_file,
                 "paths are relative to the scene's folder; check that the file is there");
}

/// Its solid is made once here, so that what is wrong with it is said of the scene's key.
void read_sheet(const Values& v, const Scene& scene, BodyScene& body)
{
    const char* surface = v.given("points") ? "points" : "file";
    if (v.given("points") && v.given("file"))
        v.refuse("file", "given together with points", "keep one of them; a motion's file is motion_file");
    if (v.given("points") && scene.dimension == 3)
        v.refuse("points", "a polyline is a sheet in 2D only", "give file, an open mesh");
    if (body.inside_out)
        v.refuse("inside_out", "a sheet has no inside", "remove it; a closed polyline or mesh encloses fluid as it is");
    body.thickness = v.number("thickness");
    if (v.given("file"))
        read_surface_path(v, scene, body);
    else
        for (const Node& x : v.given("points")->items)
            body.points.push_back(to_triple(x));
    try {
        if (scene.dimension == 2)
            make_shape<2>(body);
        else
            make_shape<3>(body);
    } catch (const SheetError& error) {
        v.refuse(error.of_thickness ? "thickness" : surface, error.problem, error.remedy);
    }
}

void read_shape(const Values& v, const Scene& scene, BodyScene& body)
{
    body.shape = shape_named(v.text("shape"));
    if (body.shape == ShapeKind::cylinder && scene.dimension == 2)
        v.refuse("shape", "a cylinder needs three dimensions", "use a ball (a disk) or a capsule in a 2D scene");
    check_shape_keys(v, v.text("shape"), body.shape);
    if (body.shape == ShapeKind::box)
        body.size = v.triple("size");
    if (v.given("radius"))
        body.radius = v.number("radius");
    if (v.given("length"))
        body.length = v.number("length");
    if (body.shape == ShapeKind::half_space) {
        body.normal = v.triple("normal");
        if (body.normal == Triple{})
            v.refuse("normal", "a normal of length 0", "give the direction out of the solid");
    }
    body.inside_out = v.known("inside_out") && v.flag("inside_out");
    if (body.shape == ShapeKind::mesh || body.shape == ShapeKind::sheet)
        body.mesh_scale = v.number("scale");
    if (body.shape == ShapeKind::mesh)
        read_surface_path(v, scene, body);
    if (body.shape == ShapeKind::sheet)
        read_sheet(v, scene, body);
}

void read_rotation(const Values& v, BodyScene& body)
{
    const Node* rotation = v.given("rotation");
    if (!rotation || rotation->kind == Node::Kind::text) // of a crowd: "random"
        return;
    constexpr double radians = std::numbers::pi / 180;
    if (rotation->numeric()) {
        body.angle = rotation->number * radians;
        return;
    }
    if (rotation->kind == Node::Kind::array) {
        for (int i = 0; i < 4; ++i)
            body.quaternion[i] = rotation->items[i].number;
    } else {
        const Triple axis = to_triple(*rotation->find("axis"));
        const double half = 0.5 * radians * rotation->find("degrees")->number;
        const double length = std::hypot(axis[0], axis[1], axis[2]);
        body.quaternion[0] = std::cos(half);
        for (int i = 0; i < 3; ++i)
            body.quaternion[i + 1] = std::sin(half) * axis[i] / length;
    }
    auto& q = body.quaternion;
    const double norm = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
    for (double& part : q)
        part /= norm;
}

/// Rows of a matrix one after the other, or the numbers as they stand.
std::vector<double> flat_numbers(const Node& node)
{
    if (node.numeric())
        return {node.number};
    std::vector<double> numbers;
    for (const Node& item : node.items)
        for (double number : flat_numbers(item))
            numbers.push_back(number);
    return numbers;
}

void read_mass(const Values& v, bool moves, BodyScene& body)
{
    if (v.given("density") && v.given("mass"))
        v.refuse("mass", "given together with density", "keep density alone, or mass and inertia");
    if (v.given("density") && v.given("inertia"))
        v.refuse("inertia", "given together with density", "keep density alone, or mass and inertia");
    if (v.given("mass") && !v.given("inertia"))
        v.refuse("mass", "given without inertia", "add inertia (about the centre of mass, body axes), or give density instead");
    if (v.given("inertia") && !v.given("mass"))
        v.refuse("inertia", "given without mass", "add mass, or give density instead");
    if (v.given("density"))
        body.density = v.number("density");
    if (v.given("mass")) {
        body.mass = v.number("mass");
        body.inertia = flat_numbers(*v.given("inertia"));
    }
    if (body.motion != Motion::free)
        return;
    if (body.shape == ShapeKind::half_space)
        v.refuse("shape", "a half-space has no bounds and cannot be free", "add motion = \"fixed\" or motion = \"prescribed\"");
    if (body.inside_out && !body.mass)
        v.refuse("inside_out", "the mass of a free body whose solid has no bounds does not follow from a density",
                 "give mass and inertia, or motion = \"fixed\" or \"prescribed\"");
    if (moves && !body.density && !body.mass)
        v.refuse_missing("density", "a free body needs density, or mass and inertia");
}

/// The key that names the motion's file, or null: motion_file, or file unless that is the mesh or sheet.
const char* motion_key(const Values& v, const BodyScene& body)
{
    const bool file = v.given("file") && body.shape != ShapeKind::mesh && body.shape != ShapeKind::sheet;
    if (file && v.given("motion_file"))
        v.refuse("motion_file", "given together with file", "keep one of them");
    return v.given("motion_file") ? "motion_file" : file ? "file" : nullptr;
}

/// Warns of a place that the scene gives and the table does not start from.
void report_overridden(const Values& v, const BodyScene& body, Scene& scene)
{
    const std::vector<double> row = value_at(body.motion_table, 0);
    const auto differs = [&](const double* given, int count, int first, double size) {
        for (int i = 0; i < count; ++i)
            if (std::abs(given[i] - row[first + i]) > 1e-6 * size)
                return true;
        return false;
    };
    const auto ignore = [&](const char* name, bool other) {
        if (const Node* node = v.given(name); node && other)
            scene.warnings.push_back(place_of(*node, v.shown(name)) + " is ignored: the body moves as in " +
                                     body.motion_table.file);
    };
    const int dimension = scene.dimension;
    ignore("position", differs(body.position.data(), dimension, 0, scene.spacing()));
    if (dimension == 2)
        return ignore("rotation", differs(&body.angle, 1, 2, 1));
    double product = 0, square = 0; // of unit quaternions q and -q alike
    for (int i = 0; i < 4; ++i) {
        product += body.quaternion[i] * row[3 + i];
        square += row[3 + i] * row[3 + i];
    }
    ignore("rotation", std::abs(product) < (1 - 1e-12) * std::sqrt(square));
}

/// Between rows, and what has no effect with it.
void read_interpolation(const Values& v, const char* key, BodyScene& body, Scene& scene)
{
    TimeTable& table = body.motion_table;
    const Node* given = v.given("interpolation");
    table.interpolation = v.choice<TimeTable::Interpolation>("interpolation");
    if (table.interpolation == TimeTable::Interpolation::cubic)
        return;
    if (table.time.size() > 2)
        scene.warnings.push_back(place_of(*given, v.shown("interpolation")) + ": the velocity jumps at every row of " +
                                 table.file + " where the motion bends, and each jump is an impulse of the fluid on the body");
    if (table.rows[0].size() > (scene.dimension == 2 ? 3U : 7U))
        scene.warnings.push_back(place_of(*v.given(key), v.shown(key)) + ": the velocities in " + table.file +
                                 " are ignored: interpolation is \"linear\"");
}

void read_motion_table(const Values& v, const char* key, Scene& scene, BodyScene& body)
{
    const bool flat = scene.dimension == 2;
    const std::vector<std::string> columns = flat ? std::vector<std::string>{"time", "x", "y", "angle"}
                                                  : std::vector<std::string>{"time", "x", "y", "z", "qw", "qx", "qy", "qz"};
    const std::vector<std::string> velocities =
        flat ? std::vector<std::string>{"vx", "vy", "omega"} : std::vector<std::string>{"vx", "vy", "vz", "wx", "wy", "wz"};
    const std::string remedy = "a motion file has rows of " + joined(columns, ",");
    try {
        body.motion_table = read_time_table(resolved_path(scene, v.text(key)), columns, velocities);
    } catch (const InputError& e) {
        v.refuse(key, e.what(), remedy);
    }
    for (std::size_t k = 0; !flat && k < body.motion_table.rows.size(); ++k) {
        const auto& row = body.motion_table.rows[k];
        if (std::all_of(row.begin() + 3, row.begin() + 7, [](double part) { return part == 0; }))
            v.refuse(key,
                     body.motion_table.file + ": a quaternion of length 0 at time " + number_text(body.motion_table.time[k]),
                     remedy);
    }
    read_interpolation(v, key, body, scene);
    report_overridden(v, body, scene);
}

void read_motion(const Values& v, Scene& scene, BodyScene& body)
{
    body.motion = v.choice<Motion>("motion");
    if (v.known("position"))
        body.position = v.triple("position");
    read_rotation(v, body);
    body.velocity = v.triple("velocity");
    body.angular_velocity = v.triple("angular_velocity");
    body.force = v.triple("force");
    body.torque = v.triple("torque");

    const char* file = motion_key(v, body);
    if (body.motion != Motion::prescribed && file)
        v.refuse(file, "a file of motion is only for prescribed bodies", "add motion = \"prescribed\", or remove it");
    if (body.motion == Motion::prescribed) {
        if (file)
            read_motion_table(v, file, scene, body);
        for (const char* name : {"velocity", "angular_velocity"})
            if (file && v.given(name))
                v.refuse(name, "given together with a file of motion", "keep one of them");
        if (!file && !v.given("velocity") && !v.given("angular_velocity"))
            v.refuse("motion", "nothing tells how the body moves",
                     "give velocity, angular_velocity or a file of motion, or write motion = \"fixed\"");
    }
    if (const Node* node = v.known("interpolation") ? v.given("interpolation") : nullptr; node && !file)
        scene.warnings.push_back(place_of(*node, v.shown("interpolation")) + " is ignored: no file gives the body's motion");
    const auto ignore = [&](const char* name) {
        if (const Node* node = v.given(name); node && to_triple(*node) != Triple{})
            scene.warnings.push_back(place_of(*node, v.shown(name)) + " is ignored: the body's motion is \"" +
                                     v.text("motion") + "\"");
    };
    if (body.motion == Motion::fixed)
        for (const char* name : {"velocity", "angular_velocity"})
            ignore(name);
    if (body.motion != Motion::free)
        for (const char* name : {"force", "torque"})
            ignore(name);
    if (body.motion == Motion::fixed) // so that no user of the scene treats it as moving
        body.velocity = body.angular_velocity = {};
}

const std::array<std::string, 6> directions{"x", "y", "z", "rx", "ry", "rz"};

/// Component of a velocity that belongs to a direction; 2D: z and turns about x and y do not exist.
double start_velocity(const BodyScene& body, int dimension, int direction)
{
    return direction < 3 ? body.velocity[direction] : body.angular_velocity[dimension == 2 ? 0 : direction - 3];
}

void read_free(const Values& v, BodyScene& body)
{
    const std::vector<std::string> list = v.texts("free");
    for (int k = 0; k < 6; ++k) {
        body.free[k] = contains(list, directions[k]);
        const bool exists = v.dimension() == 3 || k < 2 || k == 5;
        if (body.free[k] && !exists)
            v.refuse("free", directions[k] + " does not exist in a 2D scene", "choose from x, y and rz");
        if (exists && !body.free[k] && start_velocity(body, v.dimension(), k) != 0)
            v.refuse("free", "leaves out " + directions[k] + ", along which the body starts to move",
                     "add it to the list, or take that component out of velocity or angular_velocity");
    }
    if (list.empty()) { // as if held
        body.motion = Motion::fixed;
        body.free.fill(true);
    }
}

/// A point that holds the body; of its images beyond periodic sides the one nearest to the body, and says so.
Triple point_of_body(const Values& v, const char* name, const BodyScene& body, Scene& scene)
{
    Triple point = v.triple(name);
    bool moved = false;
    std::vector<std::string> numbers;
    for (int axis = 0; axis < scene.dimension; ++axis) {
        const double periods = std::rint((point[axis] - body.position[axis]) / scene.size[axis]);
        if (scene.sides[2 * axis].kind == SideScene::Kind::periodic && periods != 0) {
            point[axis] -= periods * scene.size[axis];
            moved = true;
        }
        numbers.push_back(number_text(point[axis]));
    }
    if (moved)
        scene.warnings.push_back(place_of(*v.given(name), v.shown(name)) + " is taken as [" + joined(numbers) +
                                 "], its image beyond the periodic sides that is nearest to the body");
    return point;
}

void read_hinge(const Values& v, BodyScene& body, Scene& scene)
{
    if (v.given("free"))
        v.refuse("hinge", "given together with free", "keep one of them: a hinged body does nothing but turn about its hinge");
    if (v.given("velocity"))
        v.refuse("velocity", "given together with hinge", "remove it: it follows from angular_velocity and the hinge's place");
    HingeScene& hinge = body.hinge.emplace();
    if (!v.given("hinge.point"))
        v.refuse_missing("hinge.point", "a hinge needs it");
    hinge.point = point_of_body(v, "hinge.point", body, scene);
    if (v.dimension() == 2)
        return;
    if (!v.given("hinge.axis"))
        v.refuse_missing("hinge.axis", "a hinge in 3D needs it");
    Triple axis = v.triple("hinge.axis");
    const double length = std::hypot(axis[0], axis[1], axis[2]);
    for (double& part : axis)
        part /= length;
    hinge.axis = axis;
    const Triple& w = body.angular_velocity;
    const double along = w[0] * axis[0] + w[1] * axis[1] + w[2] * axis[2];
    if (std::hypot(w[0] - along * axis[0], w[1] - along * axis[1], w[2] - along * axis[2]) > 1e-9 * std::abs(along))
        v.refuse("angular_velocity", "is not along the hinge's axis", "give a multiple of hinge.axis");
}

void read_spring(const Values& v, BodyScene& body, Scene& scene)
{
    for (const char* name : {"spring.anchor", "spring.stiffness"})
        if (!v.given(name))
            v.refuse_missing(name, "a spring needs it");
    body.spring =
        SpringScene{point_of_body(v, "spring.anchor", body, scene), v.number("spring.stiffness"), v.number("spring.damping")};
}

/// Constraints of a free body.
void read_constraints(const Values& v, Scene& scene, BodyScene& body)
{
    if (body.motion != Motion::free) {
        for (const char* name : {"free", "spring", "hinge"})
            if (const Node* node = v.given(name))
                scene.warnings.push_back(place_of(*node, v.shown(name)) + " is ignored: the body's motion is \"" +
                                         v.text("motion") + "\"");
        return;
    }
    if (v.given("hinge"))
        read_hinge(v, body, scene);
    if (v.given("spring"))
        read_spring(v, body, scene);
    if (v.given("free"))
        read_free(v, body);
}

BodyScene read_body(const Values& v, bool moves, Scene& scene)
{
    BodyScene body;
    read_name(v, scene, body);
    read_shape(v, scene, body);
    read_motion(v, scene, body);
    read_constraints(v, scene, body);
    read_mass(v, moves, body);
    return body;
}

} // namespace

void check_body_name(const Values& v, const std::string& name)
{
    if (name.starts_with("wall:"))
        v.refuse("name", "names that start with wall: belong to the sides of the domain", "choose another name");
    const bool control = std::any_of(name.begin(), name.end(), [](unsigned char c) { return c < 0x20; });
    if (control || name.find_first_of(",\"/\\") != std::string::npos || trimmed(name) != name)
        v.refuse("name", "a name stands in tables and file names",
                 "leave out commas, quotes, slashes, line breaks and blanks at its ends");
}

BodyScene read_crowd_body(const Values& v, bool moves, Scene& scene)
{
    BodyScene body;
    read_shape(v, scene, body);
    read_motion(v, scene, body);
    read_constraints(v, scene, body);
    read_mass(v, moves, body);
    return body;
}

void read_bodies(const Node& document, const std::vector<KeyInfo>& keys, bool moves, Scene& scene)
{
    const Node* bodies = document.find("body");
    for (std::size_t i = 0; bodies && i < bodies->items.size(); ++i) {
        const Node& table = bodies->items[i];
        scene.bodies.push_back(read_body(
            Values(table, "body.", shown_prefix(table, "body", static_cast<int>(i) + 1), keys, scene.dimension), moves, scene));
    }
}

} // namespace gapflow
