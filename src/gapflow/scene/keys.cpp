#include "gapflow/scene/keys.hpp"

#include "gapflow/core/text.hpp"

#include <algorithm>
#include <utility>

namespace gapflow {

namespace {

using T = KeyType;
constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr KeyRange any{};
constexpr KeyRange positive{0, infinity, true};
constexpr KeyRange non_negative{0, infinity};

// clang-format off: one key a row
std::vector<KeyInfo> gap_keys()
{
    return {
        {"gap.model",
         T::choice,
         "",
         "\"film\"",
         any,
         {"film", "none", "parts"},
         "thin gaps carry films, or are left to the grid; parts: bodies of any thickness, runs on one rank with viscosity"},
        {"gap.threshold",
         T::number_or_word,
         "cells",
         "\"auto\"",
         {0, 4, true},
         {"auto"},
         "thickness below which a gap is a film; auto: 2.25 between flat bodies, else by the radius of the pair, at most 1.5"},
        {"gap.contact",
         T::choice,
         "",
         "\"wet\"",
         any,
         {"wet", "dry"},
         "a closed gap keeps exchanging fluid (wet) or starts with a void (dry)"},
        {"gap.roughness",
         T::number_or_word,
         "m",
         "\"auto\"",
         non_negative,
         {"auto"},
         "a film is never thinner, and surfaces in contact stay this far apart; auto: 0.005 cells, for added mass 0"},
        {"gap.entrance_loss", T::number, "", "0.0", non_negative, {}, "loss coefficient of flow into a film"},
        {"gap.exit",
         T::choice,
         "",
         "\"auto\"",
         any,
         {"auto", "reversible", "jet"},
         "flow out of a film recovers its head (reversible) or loses it (jet); auto: jet with viscosity"},
    };
}

std::vector<KeyInfo> contact_keys()
{
    return {
        {"contact.restitution", T::number, "", "0.0", {0, 1}, {}, "relative speed after a collision over that before it"},
        {"contact.friction", T::number, "", "0.0", non_negative, {}, "Coulomb's coefficient"},
        {"contact.thickness", T::number, "m", "0.0", non_negative, {}, "surfaces are held this far apart"},
    };
}

std::vector<KeyInfo> body_keys()
{
    return {
        {"body.name", T::text, "", "", any, {}, "name in tables, pairs and --set", "always"},
        {"body.shape",
         T::choice,
         "",
         "",
         any,
         {"box", "ball", "capsule", "cylinder", "half-space", "mesh", "sheet"},
         "shape of the solid; a ball is a disk in 2D",
         "always"},
        {"body.size", T::vector, "m", "", positive, {}, "edge lengths of a box", "for a box"},
        {"body.radius", T::number, "m", "", positive, {}, "of a ball, capsule or cylinder", "for a ball, capsule or cylinder"},
        {"body.length",
         T::number,
         "m",
         "",
         positive,
         {},
         "along body x: of a cylinder, or between the centres of a capsule's caps",
         "for a capsule or cylinder"},
        {"body.normal", T::vector, "", "", any, {}, "of a half-space, out of the solid", "for a half-space"},
        {"body.file",
         T::text,
         "",
         "",
         any,
         {},
         "of a mesh: its surface (OBJ or STL; 2D: polygon); of a sheet: its middle surface (an open one; 2D: polyline); else "
         "the motion of a prescribed body",
         "for a mesh, and a sheet without points"},
        {"body.scale",
         T::number,
         "",
         "1.0",
         positive,
         {},
         "of a mesh or sheet: factor on the coordinates of its file or points"},
        {"body.points",
         T::vectors,
         "m",
         "",
         any,
         {},
         "of a sheet in 2D: its polyline; the last point may be the first one (a ring)"},
        {"body.thickness",
         T::number,
         "m",
         "",
         positive,
         {},
         "of a sheet: half of it lies on each side of the middle surface, whose ends are cut off at right angles",
         "for a sheet"},
        {"body.inside_out", T::flag, "", "false", any, {}, "the solid is everything outside the shape"},
        {"body.position", T::vector, "m", "0.0", any, {}, "of the shape's own origin"},
        {"body.rotation", T::rotation, "degrees", "", any, {}, "from body axes to world axes; none if not given"},
        {"body.density",
         T::number,
         "kg/m^3",
         "",
         positive,
         {},
         "of the solid, uniform",
         "for a free body, unless mass is given"},
        {"body.mass", T::number, "kg", "", positive, {}, "instead of density, with inertia", "with inertia"},
        {"body.inertia", T::inertia, "kg m^2", "", any, {}, "about the centre of mass, body axes", "with mass"},
        {"body.motion",
         T::choice,
         "",
         "\"free\"",
         any,
         {"free", "fixed", "prescribed"},
         "moved by fluid and forces, held, or moved with given velocities or as in a file"},
        {"body.motion_file",
         T::text,
         "",
         "",
         any,
         {},
         "motion of a prescribed body (for a mesh or sheet, whose file is its surface): rows of time,x,y,angle (radians; or "
         "angle_deg) "
         "or time,x,y,z,qw,qx,qy,qz; a first line of names tells another order, and may have the velocities vx,vy,omega or "
         "vx,vy,vz,wx,wy,wz too"},
        {"body.interpolation",
         T::choice,
         "",
         "\"cubic\"",
         any,
         {"linear", "cubic"},
         "of the file of motion between its rows: a smooth curve through them (cubic), or constant velocities, which jump at "
         "rows (linear)"},
        {"body.velocity", T::vector, "m/s", "0.0", any, {}, "of the centre of mass, at the start or prescribed"},
        {"body.angular_velocity", T::spin, "rad/s", "0.0", any, {}, "at the start or prescribed; 3D: world axes"},
        {"body.force", T::vector, "N", "0.0", any, {}, "constant external force at the centre of mass"},
        {"body.torque", T::spin, "N m", "0.0", any, {}, "constant external torque; 3D: world axes"},
        {"body.free",
         T::choices,
         "",
         "",
         any,
         {"x", "y", "z", "rx", "ry", "rz"},
         "of a free body: its free motions (2D: x, y, rz; world axes through the centre of mass); all if not given"},
        {"body.spring.anchor",
         T::vector,
         "m",
         "",
         any,
         {},
         "point that a spring pulls the position towards; of its images beyond periodic sides the nearest",
         "with a spring"},
        {"body.spring.stiffness", T::number, "N/m", "", non_negative, {}, "of the spring", "with a spring"},
        {"body.spring.damping", T::number, "N s/m", "0.0", non_negative, {}, "of the spring"},
        {"body.hinge.point",
         T::vector,
         "m",
         "",
         any,
         {},
         "the body only turns about this point; of its images beyond periodic sides the nearest",
         "with a hinge"},
        {"body.hinge.axis", T::direction, "", "", any, {}, "that it turns about, through the point", "with a hinge in 3D"},
    };
}

/// Those of a body that make sense for many, and the crowd's own.
std::vector<KeyInfo> crowd_keys()
{
    std::vector<KeyInfo> keys{
        {"crowd.name", T::text, "", "", any, {}, "its bodies are called NAME_0001, NAME_0002 ...", "always"},
        {"crowd.number", T::count, "", "", {1, 100000}, {}, "of bodies", "unless volume_fraction is given"},
        {"crowd.volume_fraction",
         T::number,
         "",
         "",
         {0, 1, true, true},
         {},
         "of the bodies in the region, instead of number",
         "unless number is given"},
        {"crowd.region.low", T::vector, "m", "", any, {}, "low corner of a box; that of the domain if not given"},
        {"crowd.region.high", T::vector, "m", "", any, {}, "high corner of a box; that of the domain if not given"},
        {"crowd.region.centre", T::vector, "m", "", any, {}, "of a ball (2D: a disk) instead of a box"},
        {"crowd.region.radius", T::number, "m", "", positive, {}, "of a ball or cylinder", "for a ball or cylinder"},
        {"crowd.region.from", T::vector, "m", "", any, {}, "one end of the axis of a cylinder (3D) instead of a box"},
        {"crowd.region.to", T::vector, "m", "", any, {}, "the other end", "for a cylinder"},
        {"crowd.sizes.distribution",
         T::choice,
         "",
         "\"fixed\"",
         any,
         {"fixed", "uniform", "normal", "log-normal"},
         "of a factor on all lengths of the shape, one for each body"},
        {"crowd.sizes.mean", T::number, "", "1.0", positive, {}, "of the factor; not of a uniform distribution"},
        {"crowd.sizes.deviation",
         T::number,
         "",
         "",
         positive,
         {},
         "standard deviation of the factor, before it is cut off",
         "for a normal or log-normal distribution"},
        {"crowd.sizes.low",
         T::number,
         "",
         "",
         positive,
         {},
         "smallest factor: smaller ones are drawn again; of a normal distribution a tenth of the mean if not given",
         "for a uniform distribution"},
        {"crowd.sizes.high",
         T::number,
         "",
         "",
         positive,
         {},
         "largest factor: larger ones are drawn again",
         "for a uniform distribution"},
        {"crowd.seed", T::count, "", "1", {0, 9007199254740992.0}, {}, "of the random numbers: another one, other places"},
        {"crowd.arrangement",
         T::choice,
         "",
         "\"random\"",
         any,
         {"random", "lattice"},
         "random places without overlap, or a square or cubic lattice that fills a box"},
        {"crowd.spacing",
         T::number_or_word,
         "m",
         "\"auto\"",
         non_negative,
         {"auto"},
         "smallest distance of its bodies from each other, from other bodies and from walls; auto: a hundredth of the diameter "
         "of the "
         "ball that holds the shape, at least contact.thickness and a given gap.roughness"},
        {"crowd.jitter",
         T::number,
         "",
         "0.0",
         {0, 0.5},
         {},
         "of a lattice: largest random shift along each axis, over the distance of sites"},
        {"crowd.rotation",
         T::rotation_or_word,
         "degrees",
         "",
         any,
         {"random"},
         "one of all bodies, or each at random; if not given: random, of a lattice none (balls are not turned)"},
    };
    for (KeyInfo key : body_keys()) {
        const std::string name = last_part(key.name);
        const bool own = key.name == "body." + name;
        if (!own || name == "name" || name == "normal" || name == "inside_out" || name == "position" || name == "rotation" ||
            name == "motion_file" || name == "interpolation")
            continue;
        key.name = "crowd." + name;
        if (name == "shape")
            std::erase(key.choices, "half-space");
        else if (name == "file")
            key.meaning = "of a mesh: its surface (OBJ or STL; 2D: polygon); of a sheet: its middle surface (2D: polyline)";
        else if (name == "mass" || name == "inertia")
            key.meaning += "; of a body of size factor 1";
        else if (name == "motion")
            key.meaning = "moved by fluid and forces, held, or moved with given velocities";
        keys.push_back(key);
    }
    return keys;
}

std::vector<KeyInfo> probe_keys()
{
    constexpr KeyRange points{2, 1e6};
    return {
        {"probe.name", T::text, "", "", any, {}, "name in probes.csv", "always"},
        {"probe.point", T::vector, "m", "", any, {}, "where the flow is measured: a point, or points, line or plane instead"},
        {"probe.points", T::vectors, "m", "", any, {}, "several points"},
        {"probe.line.from", T::vector, "m", "", any, {}, "first point of a line", "for a line"},
        {"probe.line.to", T::vector, "m", "", any, {}, "last point", "for a line"},
        {"probe.line.count", T::count, "", "", points, {}, "of points, evenly from the first to the last", "for a line"},
        {"probe.plane.origin", T::vector, "m", "", any, {}, "corner of a parallelogram", "for a plane"},
        {"probe.plane.u", T::vector, "m", "", any, {}, "its first edge, from the corner", "for a plane"},
        {"probe.plane.v", T::vector, "m", "", any, {}, "its second edge", "for a plane"},
        {"probe.plane.counts",
         T::two_counts,
         "",
         "",
         points,
         {},
         "of points along each edge, those along u first",
         "for a plane"},
        {"probe.fields",
         T::choices,
         "",
         "[\"pressure\", \"velocity\"]",
         any,
         {"pressure", "velocity", "vorticity"},
         "what is measured"},
        {"probe.every", T::number, "s", "0.0", non_negative, {}, "time between rows; 0: every step"},
    };
}

std::vector<KeyInfo> flux_keys()
{
    return {
        {"flux.name", T::text, "", "", any, {}, "name in fluxes.csv", "always"},
        {"flux.side",
         T::choice,
         "",
         "",
         any,
         {"x_low", "x_high", "y_low", "y_high", "z_low", "z_high"},
         "what the volume flux is measured through: a side of the domain (out of it), or plane or gap instead"},
        {"flux.plane.point", T::vector, "m", "", any, {}, "a point of a plane (2D: a line)", "for a plane"},
        {"flux.plane.normal",
         T::normal,
         "",
         "",
         any,
         {"x", "y", "z"},
         "of the plane: the flux along it counts as positive",
         "for a plane"},
        {"flux.plane.low", T::vector, "m", "", any, {}, "only the part of the plane in a box: its low corner"},
        {"flux.plane.high", T::vector, "m", "", any, {}, "its high corner"},
        {"flux.gap",
         T::names,
         "",
         "",
         any,
         {},
         "two bodies, or a body and a wall: through all mouths of the film in their gap"},
        {"flux.along",
         T::normal,
         "",
         "",
         any,
         {"x", "y", "z"},
         "of a gap: the flux along this direction counts as positive; without it half of what enters and leaves, whatever way"},
        {"flux.every", T::number, "s", "0.0", non_negative, {}, "time between rows; 0: every step"},
    };
}

void append(std::vector<KeyInfo>& keys, const std::vector<KeyInfo>& more)
{
    keys.insert(keys.end(), more.begin(), more.end());
}

} // namespace

// One long table.
std::vector<KeyInfo> scene_keys()
{
    std::vector<KeyInfo> keys{
        {"title", T::text, "", "\"\"", any, {}, "shown in reports"},
        {"gravity", T::vector, "m/s^2", "0.0", any, {}, "acceleration of free fall"},
        {"domain.size",
         T::vector,
         "m",
         "",
         positive,
         {},
         "edge lengths: two numbers make a 2D scene, three a 3D scene",
         "always"},
        {"domain.cells",
         T::counts,
         "",
         "",
         {1, 1e6},
         {},
         "cells along each axis, with the same spacing on all axes",
         "unless domain.spacing is given"},
        {"domain.spacing",
         T::number,
         "m",
         "",
         positive,
         {},
         "instead of cells: edge of a cell, outside a core at its boundary; a domain or core that is no whole number of cells "
         "long is taken "
         "as the nearest one"},
        {"domain.core.low", T::vector, "m", "", any, {}, "low corner of the box in which cells are as small as domain.spacing"},
        {"domain.core.high", T::vector, "m", "", any, {}, "high corner of that box", "with domain.core.low"},
        {"domain.growth",
         T::number,
         "",
         "1.1",
         {1, 1.5},
         {},
         "largest width of a cell outside the core over its inner neighbour's"},
        {"domain.largest", T::number, "m", "", positive, {}, "largest width of a cell outside the core; no limit if not given"},
        {"domain.origin", T::vector, "m", "0.0", any, {}, "low corner of the domain"},
        {"domain.follow",
         T::follow,
         "",
         "",
         any,
         {},
         "body whose centre of mass the grid moves with: the domain and its core, along the given axes or all"},
        {"domain.leaving",
         T::choice,
         "",
         "\"warn\"",
         any,
         {"warn", "stop", "remove"},
         "a body on its way out of an open side: the run goes on (warn), ends (stop), or goes on without a free body that is "
         "wholly outside "
         "(remove)"},
    };
    for (const std::string axis : {"x", "y", "z"})
        for (const std::string end : {"low", "high"})
            keys.push_back({"domain.sides." + axis + "_" + end,
                            T::side,
                            "m/s and Pa",
                            "\"wall\"",
                            any,
                            {"wall", "open", "periodic", "far", "surface"},
                            "boundary condition at the " + end + " end of " + axis});
    append(
        keys,
        {
            {"fluid.density", T::number, "kg/m^3", "1.0", positive, {}, "of the fluid"},
            {"fluid.viscosity", T::number, "Pa s", "0.0", non_negative, {}, "dynamic; 0: the fluid slips along walls"},
            {"fluid.reference_pressure",
             T::number,
             "Pa",
             "0.0",
             any,
             {},
             "absolute pressure at the highest point of open, far and surface sides"},
            {"fluid.vapour_pressure", T::number_or_word, "Pa", "\"none\"", any, {"none"}, "absolute: films cavitate there"},
            {"fluid.velocity",
             T::vector,
             "m/s",
             "0.0",
             any,
             {},
             "of the fluid at the start, and beyond open, far and surface sides"},
            {"fluid.pressure_gradient",
             T::vector,
             "Pa/m",
             "",
             any,
             {},
             "mean pressure gradient along periodic axes, without the fluid's weight: a negative one drives the flow forwards"},
            {"fluid.mean_velocity",
             T::vector,
             "m/s",
             "",
             any,
             {},
             "of fluid and bodies together, along periodic axes: kept by a pressure gradient, which steps.csv tells"},
            {"fluid.initial",
             T::choice,
             "",
             "\"rest\"",
             any,
             {"rest", "potential"},
             "start from fluid.velocity, or from the potential flow that the bodies' velocities drive"},
            {"grid.fractions", T::choice, "", "\"cut-cell\"", any, {"cut-cell", "voxel"}, "how bodies cut the grid's faces"},
            {"grid.advection",
             T::choice,
             "",
             "\"maccormack\"",
             any,
             {"maccormack", "semi-lagrangian"},
             "second or first order"},
            {"grid.thin",
             T::choice,
             "",
             "\"refuse\"",
             any,
             {"refuse", "allow"},
             "bodies thinner than a cell, which hardly affect the fluid, cause an error, or only a warning"},
        });
    append(keys, gap_keys());
    append(keys, contact_keys());
    keys.push_back({"pair.bodies", T::names, "", "", any, {}, "names of two bodies, or of a body and a wall", "always"});
    for (const auto& group : {gap_keys(), contact_keys()})
        for (KeyInfo key : group) {
            key.meaning += " (default: " + key.name + ")";
            key.name = "pair." + last_part(key.name);
            keys.push_back(key);
        }
    append(keys, body_keys());
    append(keys, crowd_keys());
    append(keys, probe_keys());
    append(keys, flux_keys());
    append(keys,
           {
               {"time.end", T::number, "s", "", positive, {}, "the run goes from 0 to here", "to run"},
               {"time.max_step", T::number, "s", "", positive, {}, "largest time step", "to run"},
               {"time.cfl", T::number, "", "1.0", {0, 10, true}, {}, "cells that the fluid may cross in a step"},
               {"time.gap_cfl",
                T::number,
                "",
                "0.25",
                {0, 1, true},
                {},
                "part of its thickness that a gap may change by in a step"},
               {"time.long_ways",
                T::flag,
                "",
                "true",
                any,
                {},
                "lets a gap change by any factor in a step where its films take a small share of the bodies' relative "
                "velocity: heavy "
                "particles that land"},
               {"time.until_steady",
                T::number,
                "",
                "",
                {0, 1, true},
                {},
                "the run ends before time.end once the flow will change by less than this part of itself, as its changes fade"},
               {"solver.tolerance", T::number, "", "1e-8", {1e-16, 1e-2, true}, {}, "relative residual"},
               {"solver.backend",
                T::choice,
                "",
                "\"multigrid\"",
                any,
                {"multigrid", "petsc"},
                "own solver, or a cross-check by PETSc"},
               {"output.directory", T::text, "", "\"out\"", any, {}, "folder of the run's files"},
               {"output.every", T::number, "s", "0.0", non_negative, {}, "time between fields; 0: the start and the end"},
               {"output.fields",
                T::choices,
                "",
                "[\"velocity\", \"pressure\"]",
                any,
                {"velocity", "pressure", "vorticity", "divergence", "q"},
                "fields to write; q (3D): positive in vortices"},
               {"output.precision",
                T::choice,
                "",
                "\"double\"",
                any,
                {"double", "single"},
                "of numbers in fields, bodies and films"},
               {"output.format",
                T::choice,
                "",
                "\"inline\"",
                any,
                {"inline", "appended"},
                "of these files: text all through (inline), or binary behind the text (appended), a quarter smaller"},
               {"output.forces",
                T::flag,
                "",
                "false",
                any,
                {},
                "a table forces.csv: each body's forces by pressure, shear, films, contact and buoyancy"},
               {"output.checkpoint_every",
                T::number,
                "s",
                "0.0",
                non_negative,
                {},
                "time between checkpoints; 0: only at the end and when interrupted"},
               {"output.bodies",
                T::choice,
                "",
                "\"auto\"",
                any,
                {"auto", "csv", "binary", "both"},
                "table of the bodies: bodies.csv, the binary bodies.npy of NumPy, or both; auto: bodies.csv, or bodies.npy of "
                "scenes with crowds and more than 50 bodies"},
           });
    return keys;
}
// clang-format on

bool KeyRange::contains(double value) const
{
    return (open_low ? value > low : value >= low) && (open_high ? value < high : value <= high);
}

bool is_list_table(const std::string& table)
{
    return table == "body" || table == "crowd" || table == "pair" || table == "probe" || table == "flux";
}

std::string last_part(const std::string& dotted)
{
    return dotted.substr(dotted.rfind('.') + 1);
}

namespace {

std::string range_text(const KeyRange& range)
{
    const std::string low = (range.open_low ? "> " : ">= ") + number_text(range.low);
    const std::string high = (range.open_high ? "< " : "<= ") + number_text(range.high);
    if (range.low == -infinity && range.high == infinity)
        return "";
    if (range.high == infinity)
        return " " + low;
    return range.low == -infinity ? " " + high : " " + low + " and " + high;
}

std::string choices_text(const std::vector<std::string>& choices)
{
    std::string text = "\"";
    text += joined(choices, "\", \"");
    return text += '"';
}

} // namespace

std::string allowed_values(const KeyInfo& key, int dimension)
{
    const std::string range = range_text(key.range);
    const std::string count = dimension == 0 ? "2 or 3" : std::to_string(dimension);
    switch (key.type) {
    case T::number:
        return "a number" + range;
    case T::number_or_word:
        return choices_text(key.choices) + " or a number" + range;
    case T::vector:
        return "a list of " + count + " numbers" + (range.empty() ? "" : ", each" + range);
    case T::count:
        return "a whole number" + range;
    case T::vectors:
        return "a list of points, each a list of " + count + " numbers";
    case T::counts:
        return "a list of " + count + " whole numbers" + (range.empty() ? "" : ", each" + range);
    case T::two_counts:
        return "a list of 2 whole numbers" + (range.empty() ? "" : ", each" + range);
    case T::spin:
        return dimension == 2 ? "a number (2D)" : dimension == 3 ? "a list of 3 numbers" : "a number in 2D, 3 numbers in 3D";
    case T::direction:
        return dimension == 2 ? "no axis: in 2D all turn in the plane; remove it" : "a list of 3 numbers, not all 0";
    case T::normal:
        return choices_text(key.choices) + " or a list of " + count + " numbers, not all 0";
    case T::rotation:
        return dimension == 2   ? "a number of degrees (2D)"
               : dimension == 3 ? "{ axis = [x, y, z], degrees = number } or a quaternion [w, x, y, z], neither of length 0"
                                : "degrees in 2D; { axis, degrees } or a quaternion [w, x, y, z] in 3D";
    case T::rotation_or_word: {
        KeyInfo plain = key;
        plain.type = T::rotation;
        return choices_text(key.choices) + " or " + allowed_values(plain, dimension);
    }
    case T::inertia:
        return dimension == 2   ? "a number > 0 (2D)"
               : dimension == 3 ? "3 principal moments > 0, or a symmetric positive definite matrix of 3 rows of 3 numbers"
                                : "a number > 0 in 2D; 3 principal moments or a matrix of 3 rows in 3D";
    case T::text:
        return "text in \"quotes\"";
    case T::choice:
        return "one of " + choices_text(key.choices);
    case T::choices:
        return "a list of some of " + choices_text(key.choices);
    case T::names:
        return "a list of two names in \"quotes\"";
    case T::flag:
        return "true or false";
    case T::follow:
        return "the name of a body in \"quotes\", or { body = \"name\", axes = [some of \"x\", \"y\"" +
               std::string(dimension == 2 ? "" : ", \"z\"") + "] }";
    case T::side:
        return "\"wall\", \"open\", \"periodic\", \"far\", \"surface\", { inflow = [" + count +
               " numbers] }, { inflow = \"file.csv\" }, { pressure = number }, { pressure = \"file.csv\" } or { wall = [" +
               count + " numbers] }";
    }
    return "";
}

// Words that other programs have for a key.
constexpr std::pair<const char*, const char*> other_words[] = {
    {"angle", "rotation"},  {"orientation", "rotation"}, {"speed", "velocity"}, {"centre", "position"},
    {"center", "position"}, {"resolution", "cells"},     {"count", "number"}};

std::string nearest_key(const std::string& name, const std::vector<KeyInfo>& keys)
{
    std::vector<std::string> names;
    for (const KeyInfo& key : keys)
        names.push_back(key.name);
    for (const std::string& key : std::vector<std::string>(names)) // tables too
        for (auto dot = key.find('.'); dot != std::string::npos; dot = key.find('.', dot + 1))
            if (std::find(names.begin(), names.end(), key.substr(0, dot)) == names.end())
                names.push_back(key.substr(0, dot));
    // In its own table first, then anywhere by its last part alone (a key in the wrong table), then as a whole.
    const auto dot = name.rfind('.');
    const std::string table = dot == std::string::npos ? "" : name.substr(0, dot + 1);
    std::vector<std::string> siblings, parts;
    for (const std::string& candidate : names) {
        parts.push_back(last_part(candidate));
        if (candidate.starts_with(table) && candidate.find('.', table.size()) == std::string::npos)
            siblings.push_back(candidate.substr(table.size()));
    }
    for (const auto& [word, meant] : other_words)
        if (last_part(name) == word && std::find(siblings.begin(), siblings.end(), meant) != siblings.end())
            return table + meant;
    const std::string sibling = nearest_name(last_part(name), siblings), elsewhere = nearest_name(last_part(name), parts);
    const auto distance = [&](const std::string& part) { return edit_distance(last_part(name), part); };
    if (!sibling.empty() && (elsewhere.empty() || distance(sibling) <= distance(elsewhere)))
        return table + sibling;
    if (!elsewhere.empty())
        return names[std::find(parts.begin(), parts.end(), elsewhere) - parts.begin()];
    return nearest_name(name, names);
}

} // namespace gapflow
