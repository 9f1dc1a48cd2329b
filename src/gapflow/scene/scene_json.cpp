// The resolved scene under the scene file's key names.
#include "gapflow/scene/scene.hpp"

#include <nlohmann/json.hpp>

#include <numbers>

namespace gapflow {

namespace {

using Json = nlohmann::ordered_json;

template <std::size_t N>
std::string word(const char* const (&words)[N], auto value)
{
    return words[static_cast<std::size_t>(value)];
}

/// Vectors and spins with as many numbers as the dimension has.
struct Lists {
    int dimension;

    Json vector(const auto& triple) const { return std::vector(triple.begin(), triple.begin() + dimension); }
    Json spin(const Triple& triple) const { return dimension == 2 ? Json(triple[0]) : Json(triple); }
};

Json side_json(const SideScene& side, const Lists& list)
{
    if (side.kind == SideScene::Kind::inflow)
        return {{"inflow", side.table.time.empty() ? list.vector(side.velocity) : Json(side.table.file)}};
    if (side.kind == SideScene::Kind::pressure)
        return {{"pressure", side.table.file.empty() ? Json(side.table.rows.at(0).at(0)) : Json(side.table.file)}};
    if (side.kind == SideScene::Kind::far)
        return "far";
    if (side.kind == SideScene::Kind::surface)
        return "surface";
    return word({"wall", "open", "periodic"}, side.kind);
}

Json gap_json(const GapScene& gap, bool parts = false)
{
    return {{"model", parts ? "parts" : gap.film ? "film" : "none"},
            {"threshold", gap.threshold ? Json(*gap.threshold) : Json("auto")},
            {"contact", word({"wet", "dry"}, gap.contact)},
            {"roughness", gap.roughness},
            {"automatic_roughness", gap.automatic_roughness},
            {"entrance_loss", gap.entrance_loss},
            {"exit", word({"auto", "reversible", "jet"}, gap.exit)}};
}

Json contact_json(const ContactScene& contact)
{
    return {{"restitution", contact.restitution}, {"friction", contact.friction}, {"thickness", contact.thickness}};
}

void add_shape(Json& json, const BodyScene& body, const Lists& list)
{
    using Kind = BodyScene::ShapeKind;
    json["shape"] = word({"box", "ball", "capsule", "cylinder", "half-space", "mesh", "sheet"}, body.shape);
    if (body.shape == Kind::box)
        json["size"] = list.vector(body.size);
    if (body.shape == Kind::ball || body.shape == Kind::capsule || body.shape == Kind::cylinder)
        json["radius"] = body.radius;
    if (body.shape == Kind::capsule || body.shape == Kind::cylinder)
        json["length"] = body.length;
    if (body.shape == Kind::half_space)
        json["normal"] = list.vector(body.normal);
    if (body.shape == Kind::mesh || body.shape == Kind::sheet) {
        if (body.points.empty())
            json["file"] = body.mesh_file;
        json["scale"] = body.mesh_scale;
    }
    if (body.shape == Kind::sheet) {
        for (const Triple& x : body.points)
            json["points"].push_back(list.vector(x));
        json["thickness"] = body.thickness;
    }
    json["inside_out"] = body.inside_out;
}

Json inertia_json(const std::vector<double>& inertia)
{
    if (inertia.size() == 1)
        return inertia[0];
    if (inertia.size() == 3)
        return inertia;
    Json rows;
    for (int i = 0; i < 3; ++i)
        rows.push_back(std::vector(inertia.begin() + 3 * i, inertia.begin() + 3 * i + 3));
    return rows;
}

Json free_json(const BodyScene& body, int dimension)
{
    Json list = Json::array();
    for (int k = 0; k < 6; ++k)
        if (body.free[k] && (dimension == 3 || k < 2 || k == 5))
            list.push_back(std::array{"x", "y", "z", "rx", "ry", "rz"}[k]);
    return list;
}

Json body_json(const BodyScene& body, const Lists& list)
{
    Json json;
    json["name"] = body.name;
    add_shape(json, body, list);
    json["position"] = list.vector(body.position);
    json["rotation"] = list.dimension == 2 ? Json(body.angle * 180 / std::numbers::pi) : Json(body.quaternion);
    if (body.density)
        json["density"] = *body.density;
    if (body.mass) {
        json["mass"] = *body.mass;
        json["inertia"] = inertia_json(body.inertia);
    }
    json["motion"] = word({"free", "fixed", "prescribed"}, body.motion);
    if (!body.motion_table.time.empty()) {
        json["motion_file"] = body.motion_table.file;
        json["interpolation"] = word({"linear", "cubic"}, body.motion_table.interpolation);
    } else {
        json["velocity"] = list.vector(body.velocity);
        json["angular_velocity"] = list.spin(body.angular_velocity);
    }
    json["force"] = list.vector(body.force);
    json["torque"] = list.spin(body.torque);
    if (body.hinge) {
        json["hinge"]["point"] = list.vector(body.hinge->point);
        if (list.dimension == 3)
            json["hinge"]["axis"] = body.hinge->axis;
    }
    if (body.spring)
        json["spring"] = {{"anchor", list.vector(body.spring->anchor)},
                          {"stiffness", body.spring->stiffness},
                          {"damping", body.spring->damping}};
    if (const Json free = free_json(body, list.dimension); free.size() < (list.dimension == 2 ? 3U : 6U))
        json["free"] = free;
    return json;
}

Json probe_json(const ProbeScene& probe, const Lists& list)
{
    Json json;
    json["name"] = probe.name;
    if (probe.kind == ProbeScene::Kind::line) {
        json["line"] = {
            {"from", list.vector(probe.points[0])}, {"to", list.vector(probe.points[1])}, {"count", probe.counts[0]}};
    } else if (probe.kind == ProbeScene::Kind::plane) {
        json["plane"] = {{"origin", list.vector(probe.points[0])},
                         {"u", list.vector(probe.points[1])},
                         {"v", list.vector(probe.points[2])},
                         {"counts", probe.counts}};
    } else {
        json["points"] = Json::array();
        for (const Triple& point : probe.points)
            json["points"].push_back(list.vector(point));
    }
    json["fields"] = Json::array();
    if (probe.pressure)
        json["fields"].push_back("pressure");
    if (probe.velocity)
        json["fields"].push_back("velocity");
    if (probe.vorticity)
        json["fields"].push_back("vorticity");
    json["every"] = probe.every;
    return json;
}

Json flux_json(const FluxScene& flux, const Lists& list)
{
    Json json;
    json["name"] = flux.name;
    if (flux.kind == FluxScene::Kind::side) {
        json["side"] = side_names[flux.side];
    } else if (flux.kind == FluxScene::Kind::gap) {
        json["gap"] = flux.bodies;
        if (flux.along)
            json["along"] = list.vector(*flux.along);
    } else {
        json["plane"] = {{"point", list.vector(flux.point)}, {"normal", list.vector(flux.normal)}};
        if (flux.low && flux.high) {
            json["plane"]["low"] = list.vector(*flux.low);
            json["plane"]["high"] = list.vector(*flux.high);
        }
    }
    json["every"] = flux.every;
    return json;
}

} // namespace

std::string scene_as_json(const Scene& scene)
{
    const Lists list{scene.dimension};
    Json json;
    json["title"] = scene.title;
    json["gravity"] = list.vector(scene.gravity);
    json["domain"]["size"] = list.vector(scene.size);
    if (!scene.core)
        json["domain"]["cells"] = list.vector(scene.cells);
    json["domain"]["origin"] = list.vector(scene.origin);
    if (scene.core) {
        json["domain"]["spacing"] = scene.core->spacing;
        json["domain"]["core"] = {{"low", list.vector(scene.core->low)}, {"high", list.vector(scene.core->high)}};
        json["domain"]["growth"] = scene.core->growth;
        if (scene.core->largest)
            json["domain"]["largest"] = *scene.core->largest;
    }
    if (scene.follow) {
        Json axes = Json::array();
        for (int axis = 0; axis < scene.dimension; ++axis)
            if (scene.follow->axes[axis])
                axes.push_back(std::string(1, "xyz"[axis]));
        json["domain"]["follow"] = {{"body", scene.follow->body}, {"axes", axes}};
    }
    for (int side = 0; side < 2 * scene.dimension; ++side)
        json["domain"]["sides"][side_names[side]] = side_json(scene.sides[side], list);
    json["domain"]["leaving"] = word({"warn", "stop", "remove"}, scene.leaving);
    json["fluid"] = {{"density", scene.density},
                     {"viscosity", scene.viscosity},
                     {"reference_pressure", scene.reference_pressure},
                     {"vapour_pressure", scene.vapour_pressure ? Json(*scene.vapour_pressure) : Json("none")},
                     {"velocity", list.vector(scene.fluid_velocity)},
                     {"initial", word({"rest", "potential"}, scene.initial)}};
    if (scene.pressure_gradient)
        json["fluid"]["pressure_gradient"] = list.vector(*scene.pressure_gradient);
    if (scene.mean_velocity)
        json["fluid"]["mean_velocity"] = list.vector(*scene.mean_velocity);
    json["grid"] = {{"fractions", word({"cut-cell", "voxel"}, scene.fractions)},
                    {"advection", word({"maccormack", "semi-lagrangian"}, scene.advection)},
                    {"thin", word({"refuse", "allow"}, scene.thin)}};
    json["gap"] = gap_json(scene.gap, scene.parts);
    json["contact"] = contact_json(scene.contact);
    json["pair"] = Json::array();
    for (const PairScene& pair : scene.pairs) {
        Json entry = {{"bodies", pair.bodies}};
        entry.update(gap_json(pair.gap));
        entry.update(contact_json(pair.contact));
        json["pair"].push_back(entry);
    }
    json["body"] = Json::array();
    for (const BodyScene& body : scene.bodies)
        json["body"].push_back(body_json(body, list));
    for (const CrowdScene& crowd : scene.crowds)
        json["crowd"].push_back({{"name", crowd.name},
                                 {"number", crowd.number},
                                 {"first", crowd.first},
                                 {"arrangement", word({"random", "lattice"}, crowd.arrangement)},
                                 {"seed", crowd.seed},
                                 {"spacing", crowd.spacing},
                                 {"region_volume", crowd.region_volume},
                                 {"volume_fraction", crowd.volume_fraction},
                                 {"sizes", {crowd.smallest, crowd.largest}}});
    for (const ProbeScene& probe : scene.probes)
        json["probe"].push_back(probe_json(probe, list));
    for (const FluxScene& flux : scene.fluxes)
        json["flux"].push_back(flux_json(flux, list));
    json["time"] = Json::object();
    if (scene.end > 0)
        json["time"]["end"] = scene.end;
    if (scene.max_step > 0)
        json["time"]["max_step"] = scene.max_step;
    json["time"]["cfl"] = scene.cfl;
    json["time"]["gap_cfl"] = scene.gap_cfl;
    if (!scene.long_ways)
        json["time"]["long_ways"] = false;
    if (scene.until_steady)
        json["time"]["until_steady"] = *scene.until_steady;
    json["solver"] = {{"tolerance", scene.tolerance}, {"backend", word({"multigrid", "petsc"}, scene.backend)}};
    json["output"] = {{"directory", scene.output_directory},
                      {"every", scene.output_every},
                      {"fields", scene.fields},
                      {"checkpoint_every", scene.checkpoint_every},
                      {"bodies", word({"auto", "csv", "binary", "both"}, scene.bodies_table)},
                      {"precision", word({"double", "single"}, scene.precision)},
                      {"format", word({"inline", "appended"}, scene.format)},
                      {"forces", scene.forces}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

} // namespace gapflow
