#include "gapflow/scene/check_keys.hpp"
#include "gapflow/scene/read_parts.hpp"

#include "gapflow/core/text.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {

namespace {

constexpr std::size_t most_points = 1'000'000; // of a probe

std::string point_text(const Triple& point, int dimension)
{
    std::vector<std::string> parts;
    for (int axis = 0; axis < dimension; ++axis)
        parts.push_back(number_text(point[axis]));
    return "[" + joined(parts) + "]";
}

/// Exactly one of the keys of a measure tells its place.
std::string kind_of(const Values& v, const std::vector<std::string>& kinds, const std::string& what)
{
    std::string found;
    for (const std::string& kind : kinds) {
        if (!v.given(kind))
            continue;
        if (!found.empty())
            v.refuse(kind, found + " is given, too", "leave one of the two to another [[" + what + "]]");
        found = kind;
    }
    if (found.empty())
        v.refuse_missing(kinds.front(), "a " + what + " needs it, or one of: " + joined(kinds));
    return found;
}

void check_name(const Values& v, const std::string& name, const auto& others, const std::string& what)
{
    check_body_name(v, name);
    for (const auto& other : others)
        if (other.name == name)
            v.refuse("name", "an earlier [[" + what + "]] has this name", "give every " + what + " a name of its own");
}

void needs(const Values& v, const std::string& table, std::initializer_list<const char*> keys)
{
    for (const char* key : keys)
        if (!v.given(table + "." + key))
            v.refuse_missing(table + "." + key, "a " + table + " needs it");
}

void check_in_domain(const Values& v, const std::string& key, const std::vector<Triple>& places, const Scene& scene)
{
    for (const Triple& place : places)
        for (int axis = 0; axis < scene.dimension; ++axis) {
            const double low = scene.origin[axis], high = low + scene.size[axis], round_off = 1e-9 * scene.size[axis];
            if (place[axis] >= low - round_off && place[axis] <= high + round_off)
                continue;
            v.refuse(key, "the point " + point_text(place, scene.dimension) + " lies outside the domain",
                     std::string("allowed: ") + "xyz"[axis] + " from " + number_text(low) + " to " + number_text(high));
        }
}

void read_places(const Values& v, const Scene& scene, ProbeScene& probe)
{
    const std::string kind = kind_of(v, {"point", "points", "line", "plane"}, "probe");
    if (kind == "point") {
        probe.points = {v.triple("point")};
    } else if (kind == "points") {
        for (const Node& point : v.given("points")->items)
            probe.points.push_back(to_triple(point));
    } else if (kind == "line") {
        needs(v, "line", {"from", "to", "count"});
        probe.kind = ProbeScene::Kind::line;
        probe.points = {v.triple("line.from"), v.triple("line.to")};
        probe.counts = {static_cast<int>(v.number("line.count")), 0};
    } else {
        needs(v, "plane", {"origin", "u", "v", "counts"});
        probe.kind = ProbeScene::Kind::plane;
        probe.points = {v.triple("plane.origin"), v.triple("plane.u"), v.triple("plane.v")};
        const Triple counts = to_triple(*v.given("plane.counts"));
        probe.counts = {static_cast<int>(counts[0]), static_cast<int>(counts[1])};
        if (counts[0] * counts[1] > most_points)
            v.refuse("plane.counts", number_text(counts[0] * counts[1]) + " points",
                     "allowed: up to " + std::to_string(most_points));
    }
    check_in_domain(v, kind, probe.places(), scene);
}

ProbeScene read_probe(const Values& v, const Scene& scene)
{
    ProbeScene probe;
    probe.name = v.text("name");
    check_name(v, probe.name, scene.probes, "probe");
    read_places(v, scene, probe);
    const std::vector<std::string> fields = v.texts("fields");
    const auto wants = [&](const char* field) { return std::find(fields.begin(), fields.end(), field) != fields.end(); };
    if (fields.empty())
        v.refuse("fields", "nothing to measure", "write some of \"pressure\", \"velocity\", \"vorticity\"");
    probe.pressure = wants("pressure");
    probe.velocity = wants("velocity");
    probe.vorticity = wants("vorticity");
    probe.every = v.number("every");
    check_count(v, "every", probe.every, scene.end, most_outputs, "rows");
    return probe;
}

/// An axis, or a vector brought to unit length.
Triple direction_of(const Node& given)
{
    Triple direction{};
    if (given.kind == Node::Kind::text)
        direction[given.text[0] - 'x'] = 1;
    else
        direction = to_triple(given);
    const double length = std::hypot(direction[0], direction[1], direction[2]);
    for (double& part : direction)
        part /= length;
    return direction;
}

void read_plane(const Values& v, const Scene& scene, FluxScene& flux)
{
    needs(v, "plane", {"point", "normal"});
    flux.point = v.triple("plane.point");
    flux.normal = direction_of(*v.given("plane.normal"));
    check_in_domain(v, "plane.point", {flux.point}, scene);
    if (!v.given("plane.low") && !v.given("plane.high"))
        return;
    needs(v, "plane", {"low", "high"});
    flux.low = v.triple("plane.low");
    flux.high = v.triple("plane.high");
    for (int axis = 0; axis < scene.dimension; ++axis)
        if (!((*flux.low)[axis] < (*flux.high)[axis]) && std::abs(flux.normal[axis]) < 1 - 1e-12)
            v.refuse("plane.high", std::string("not above plane.low along ") + "xyz"[axis], "give the box's high corner");
}

FluxScene read_flux(const Values& v, const Scene& scene)
{
    FluxScene flux;
    flux.name = v.text("name");
    check_name(v, flux.name, scene.fluxes, "flux");
    const std::string kind = kind_of(v, {"side", "plane", "gap"}, "flux");
    if (kind == "side") {
        flux.side = v.choice<int>("side");
        if (flux.side >= 2 * scene.dimension)
            v.refuse("side", "a 2D scene has no z sides", "name one of x_low, x_high, y_low, y_high");
        if (scene.sides[flux.side].kind == SideScene::Kind::periodic)
            v.refuse("side", "this side is periodic: what leaves there comes in again",
                     "write plane = { point = [...], normal = \"" + side_names[flux.side].substr(0, 1) + "\" } instead");
    } else if (kind == "plane") {
        flux.kind = FluxScene::Kind::plane;
        read_plane(v, scene, flux);
    } else {
        flux.kind = FluxScene::Kind::gap;
        check_partners(v, "gap", "a gap", scene);
        const std::vector<std::string> names = v.texts("gap");
        std::copy(names.begin(), names.end(), flux.bodies.begin());
        if (!scene.parts && !scene.gap_of(names[0], names[1]).film)
            v.refuse("gap", "this gap has no film: its model is \"none\"",
                     "measure through a plane instead, or let it be a film");
    }
    if (const Node* along = v.given("along")) {
        if (kind != "gap")
            v.refuse("along", "only a gap's flux has this key",
                     "leave it out: a " + kind + "'s flux is positive " +
                         (kind == "side" ? "out of the domain" : "along its normal"));
        flux.along = direction_of(*along);
    }
    flux.every = v.number("every");
    check_count(v, "every", flux.every, scene.end, most_outputs, "rows");
    return flux;
}

void for_each_table(const Node& document, const std::string& name, const auto& read)
{
    const Node* tables = document.find(name);
    for (std::size_t i = 0; tables && i < tables->items.size(); ++i)
        read(tables->items[i], shown_prefix(tables->items[i], name, static_cast<int>(i) + 1));
}

} // namespace

void read_measures(const Node& document, const std::vector<KeyInfo>& keys, Scene& scene)
{
    for_each_table(document, "probe", [&](const Node& table, const std::string& shown) {
        scene.probes.push_back(read_probe(Values(table, "probe.", shown, keys, scene.dimension), scene));
    });
    for_each_table(document, "flux", [&](const Node& table, const std::string& shown) {
        scene.fluxes.push_back(read_flux(Values(table, "flux.", shown, keys, scene.dimension), scene));
    });
}

} // namespace gapflow
