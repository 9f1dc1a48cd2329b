#include "gapflow/scene/check_keys.hpp"
#include "gapflow/scene/parse_scene.hpp"
#include "gapflow/scene/read_parts.hpp"

#include "gapflow/core/error.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace gapflow {

std::string resolved_path(const Scene& scene, const std::string& path)
{
    return (std::filesystem::path(scene.file).parent_path() / path).lexically_normal().string();
}

void check_count(const Values& v, const char* name, double every, double end, double most, const char* what)
{
    if (!(every > 0) || end / every <= most)
        return;
    char problem[96], remedy[96];
    std::snprintf(problem, sizeof problem, "%.3g %s until time.end = %.6g", end / every, what, end);
    std::snprintf(remedy, sizeof remedy, "allowed: up to %.3g, so at least %.3g here", most, end / most);
    v.refuse(name, problem, remedy);
}

namespace {

constexpr double most_steps = 1e9;

/// A vector along periodic axes.
std::optional<Triple> along_periodic_axes(const Values& v, const char* name, const Scene& scene)
{
    if (!v.given(name))
        return {};
    const Triple value = v.triple(name);
    for (int axis = 0; axis < scene.dimension; ++axis)
        if (const std::string letter(1, "xyz"[axis]);
            value[axis] != 0 && scene.sides[2 * axis].kind != SideScene::Kind::periodic)
            v.refuse(name, letter + " is not a periodic axis",
                     "write 0 there, or " + letter + "_low = \"periodic\" and " + letter +
                         "_high = \"periodic\" in [domain.sides]");
    return value;
}

void read_fluid(const Values& v, Scene& scene)
{
    scene.density = v.number("fluid.density");
    scene.viscosity = v.number("fluid.viscosity");
    scene.reference_pressure = v.number("fluid.reference_pressure");
    if (const Node* vapour = v.given("fluid.vapour_pressure"); vapour && vapour->numeric())
        scene.vapour_pressure = vapour->number;
    scene.fluid_velocity = v.triple("fluid.velocity");
    scene.pressure_gradient = along_periodic_axes(v, "fluid.pressure_gradient", scene);
    scene.mean_velocity = along_periodic_axes(v, "fluid.mean_velocity", scene);
    if (scene.pressure_gradient && scene.mean_velocity)
        v.refuse("fluid.mean_velocity", "a pressure gradient is given, too",
                 "leave out one of the two: each follows from the other");
    scene.initial = v.choice<Scene::Initial>("fluid.initial");
    scene.fractions = v.choice<Scene::Fractions>("grid.fractions");
    scene.advection = v.choice<Scene::Advection>("grid.advection");
    scene.thin = v.choice<Scene::Thin>("grid.thin");
}

void read_time(const Values& v, Purpose purpose, Scene& scene)
{
    for (const char* name : {"time.end", "time.max_step"})
        if (purpose == Purpose::run && !v.given(name))
            v.refuse_missing(name, "a run needs it");
    if (v.given("time.end"))
        scene.end = v.number("time.end");
    if (v.given("time.max_step"))
        scene.max_step = v.number("time.max_step");
    check_count(v, "time.max_step", scene.max_step, scene.end, most_steps, "steps");
    scene.cfl = v.number("time.cfl");
    scene.gap_cfl = v.number("time.gap_cfl");
    scene.long_ways = v.flag("time.long_ways");
    if (v.given("time.until_steady"))
        scene.until_steady = v.number("time.until_steady");
}

void read_output(const Values& v, Scene& scene)
{
    scene.output_directory = v.text("output.directory");
    scene.output_every = v.number("output.every");
    scene.fields = v.texts("output.fields");
    if (scene.dimension == 2 && std::find(scene.fields.begin(), scene.fields.end(), "q") != scene.fields.end())
        v.refuse("output.fields",
                 "a 2D scene has no q: without divergence it follows from the vorticity and the rate of strain of a plane",
                 "write \"vorticity\" instead");
    scene.precision = v.choice<Scene::Precision>("output.precision");
    scene.format = v.choice<Scene::Format>("output.format");
    scene.forces = v.flag("output.forces");
    scene.checkpoint_every = v.number("output.checkpoint_every");
    scene.bodies_table = v.choice<Scene::BodiesTable>("output.bodies");
    check_count(v, "output.every", scene.output_every, scene.end, most_outputs, "output times");
    check_count(v, "output.checkpoint_every", scene.checkpoint_every, scene.end, most_outputs, "checkpoints");
}

/// Fluid that flows in needs a way out. Volume swept by prescribed bodies, and sides with both in- and outflow, are checked in the run.
void check_way_out(const Values& v, const Scene& scene)
{
    for (const BodyScene& body : scene.bodies)
        if (body.motion == BodyScene::Motion::prescribed)
            return;
    std::string first; // side with inflow
    bool in = false, out = false;
    for (int side = 0; side < 2 * scene.dimension; ++side) {
        const SideScene& s = scene.sides[side];
        if (s.is_open() || (s.kind == SideScene::Kind::inflow && !s.table.time.empty()))
            return;
        const double inward = (side % 2 == 0 ? 1 : -1) * s.velocity[side / 2];
        if (s.kind != SideScene::Kind::inflow || inward == 0)
            continue;
        (inward > 0 ? in : out) = true;
        if (first.empty())
            first = "domain.sides." + side_names[side];
    }
    if (in != out)
        v.refuse(first, in ? "fluid flows in, and no side lets it out" : "fluid flows out, and no side lets it in",
                 "open a side, or let as much through another one");
}

/// The body that the grid follows is there and moves.
void check_follow(const Values& v, const Scene& scene)
{
    if (!scene.follow)
        return;
    const auto body = std::find_if(scene.bodies.begin(), scene.bodies.end(),
                                   [&](const BodyScene& other) { return other.name == scene.follow->body; });
    if (body == scene.bodies.end())
        v.refuse("domain.follow", "no body is called '" + scene.follow->body + "'", "name one of the bodies");
    if (body->motion == BodyScene::Motion::fixed)
        v.refuse("domain.follow", "the body '" + body->name + "' is fixed: it goes nowhere",
                 "name a body that moves, or leave domain.follow out");
}

/// [gap], and those of pairs.
std::vector<const GapScene*> gaps_of(const Scene& scene)
{
    std::vector<const GapScene*> gaps{&scene.gap};
    for (const PairScene& pair : scene.pairs)
        gaps.push_back(&pair.gap);
    return gaps;
}

/// A side has the velocity across it alone: that along it is the flow's own.
void check_inflow_of_parts(const Values& v, const Scene& scene, int side)
{
    const SideScene& inflow = scene.sides[side];
    const std::size_t across = side / 2, dimension = static_cast<std::size_t>(scene.dimension);
    std::vector<std::vector<double>> rows = inflow.table.rows;
    if (rows.empty())
        rows.emplace_back(inflow.velocity.begin(), inflow.velocity.begin() + scene.dimension);
    for (const std::vector<double>& row : rows)
        for (std::size_t axis = 0; axis < dimension; ++axis) {
            if (axis != across && row[axis] != scene.fluid_velocity[axis])
                v.refuse("domain.sides." + side_names[side],
                         std::string("fluid with gap.model = \"parts\" flows along a side as it will, and this inflow "
                                     "has its own velocity "
                                     "along ") +
                             "xyz"[axis],
                         "write there what fluid.velocity has, or gap.model = \"film\"");
            if (axis == across && scene.follow && scene.follow->axes[axis] && row[axis] != scene.fluid_velocity[axis])
                v.refuse("domain.follow",
                         "with gap.model = \"parts\" the fluid beyond sides that move is far away, and domain.sides." +
                             side_names[side] + " has another velocity than fluid.velocity",
                         "write the same there, or leave domain.follow out");
        }
}

/// Voids in gaps of parts (dry contact, cavitation) are in fluid that bodies alone set moving.
void check_voids_of_parts(const Values& v, const Scene& scene)
{
    const auto gaps = gaps_of(scene);
    if (!scene.vapour_pressure &&
        std::none_of(gaps.begin(), gaps.end(), [](const GapScene* gap) { return gap->contact == GapScene::Contact::dry; }))
        return;
    const auto refuse = [&](const std::string& key) {
        v.refuse(key,
                 "this version runs gap.model = \"parts\" with dry contact or cavitation in fluid that only bodies set moving",
                 "leave it out, or leave out gap.contact and fluid.vapour_pressure, or write gap.model = \"film\"");
    };
    if (scene.follow)
        refuse("domain.follow");
    if (scene.fluid_velocity != Triple{})
        refuse("fluid.velocity");
    if (scene.pressure_gradient || scene.mean_velocity)
        refuse(scene.pressure_gradient ? "fluid.pressure_gradient" : "fluid.mean_velocity");
    for (int side = 0; side < 2 * scene.dimension; ++side)
        if (const SideScene::Kind kind = scene.sides[side].kind;
            kind == SideScene::Kind::inflow || kind == SideScene::Kind::pressure)
            refuse("domain.sides." + side_names[side]);
}

/// What runs with parts do not have yet.
void check_parts(const Values& v, Purpose purpose, const Scene& scene)
{
    if (!scene.parts || !(purpose == Purpose::run || (purpose == Purpose::check && scene.end > 0)))
        return;
    const std::string remedy = "leave it out, or write gap.model = \"film\"";
    for (int side = 0; side < 2 * scene.dimension; ++side)
        if (scene.fluid_velocity[side / 2] != 0 && scene.sides[side].kind == SideScene::Kind::wall)
            v.refuse("fluid.velocity",
                     "this version runs gap.model = \"parts\" with a velocity along axes without walls, and domain.sides." +
                         side_names[side] + " is one",
                     "make both sides there periodic, far or open, or write gap.model = \"film\"");
    for (int side = 0; side < 2 * scene.dimension; ++side) {
        const SideScene::Kind kind = scene.sides[side].kind;
        if (kind == SideScene::Kind::surface)
            v.refuse("domain.sides." + side_names[side], "this version runs gap.model = \"parts\" without water levels",
                     "write \"open\", or gap.model = \"film\"");
        if (kind == SideScene::Kind::inflow)
            check_inflow_of_parts(v, scene, side);
    }
    for (const GapScene* gap : gaps_of(scene)) {
        if (gap->exit == GapScene::Exit::jet)
            v.refuse("gap.exit", "this version runs gap.model = \"parts\" with reversible exits", remedy);
        if (gap->entrance_loss > 0)
            v.refuse("gap.entrance_loss", "this version runs gap.model = \"parts\" without losses at entrances", remedy);
    }
    check_voids_of_parts(v, scene);
}

/// A side that moves has no place at which a flux could be measured.
void check_sides_of_fluxes(const Values& v, const Scene& scene)
{
    for (const FluxScene& flux : scene.fluxes)
        if (scene.follow && flux.kind == FluxScene::Kind::side && scene.follow->axes[static_cast<std::size_t>(flux.side) / 2])
            v.refuse("domain.follow", "the flux '" + flux.name + "' is measured through a side that moves",
                     "measure it through a plane, or follow the body along other axes");
}

Scene scene_of(Node document, const std::string& file, const Overrides& overrides, Purpose purpose)
{
    const std::vector<KeyInfo> keys = scene_keys();
    check_names(document, keys);
    apply_overrides(document, overrides, keys);
    Scene scene;
    scene.file = file;
    scene.dimension = dimension_of(document, keys);
    check_values(document, keys, scene.dimension);

    const Values values(document, "", "", keys, scene.dimension);
    scene.title = values.text("title");
    scene.gravity = values.triple("gravity");
    read_time(values, purpose, scene);
    read_domain(values, scene);
    read_fluid(values, scene);
    const bool moves = purpose == Purpose::run || (purpose == Purpose::check && scene.end > 0);
    read_gaps(values, purpose, scene);
    read_bodies(document, keys, moves, scene);
    read_crowds(document, keys, moves, scene);
    check_follow(values, scene);
    check_parts(values, purpose, scene);
    check_way_out(values, scene);
    read_pairs(values, keys, purpose, scene);
    read_measures(document, keys, scene);
    check_sides_of_fluxes(values, scene);
    scene.tolerance = values.number("solver.tolerance");
    scene.backend = values.choice<Scene::Backend>("solver.backend");
    read_output(values, scene);
    const auto fixed = [](const BodyScene& body) { return body.motion == BodyScene::Motion::fixed; };
    if (purpose == Purpose::added_mass && std::all_of(scene.bodies.begin(), scene.bodies.end(), fixed))
        throw InputError(file + ": no body moves, so there is no added mass; add a [[body]] whose motion is not \"fixed\"");
    return scene;
}

/// Messages quote what stands in the file: control characters become blanks, so that a message is one line.
template <class Read>
Scene with_plain_messages(Read read)
{
    try {
        return read();
    } catch (const InputError& error) {
        std::string message = error.what();
        std::replace_if(
            message.begin(), message.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
        throw InputError(message);
    }
}

} // namespace

Scene read_scene(const std::string& file, const Overrides& overrides, Purpose purpose)
{
    return with_plain_messages([&] { return scene_of(read_document(file), file, overrides, purpose); });
}

Scene parse_scene(std::string_view text, const std::string& file, const Overrides& overrides, Purpose purpose)
{
    return with_plain_messages([&] { return scene_of(parse_document(text, file), file, overrides, purpose); });
}

} // namespace gapflow
