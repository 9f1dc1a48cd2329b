#include "gapflow/scene/check_keys.hpp"
#include "gapflow/scene/read_parts.hpp"

#include "gapflow/core/text.hpp"

#include <algorithm>

namespace gapflow {

namespace {

/// What gap.roughness = "auto" stands for.
double roughness_of_auto(Purpose purpose, const Scene& scene)
{
    const bool at_rest = purpose == Purpose::added_mass || (purpose == Purpose::check && scene.end == 0);
    if (at_rest)
        return 0;
    return scene.core ? automatic_roughness * scene.core->spacing : automatic_roughness * scene.size[0] / scene.cells[0];
}

/// [gap] and [contact] have defaults; a pair keeps the values that it does not give. `automatic`: the roughness for "auto".
void read_settings(const Values& v, const std::string& gap_table, const std::string& contact_table, bool defaults,
                   double automatic, GapScene& gap, ContactScene& contact)
{
    const auto wanted = [&](const std::string& name) { return defaults || v.given(name); };
    const std::string& g = gap_table;
    if (wanted(g + "model")) {
        gap.film = v.text(g + "model") == "film";
        if (!defaults && v.text(g + "model") == "parts")
            v.refuse(g + "model", "parts are a model of the whole scene, not of a pair", "write model = \"parts\" in [gap]");
    }
    if (const Node* threshold = v.given(g + "threshold"))
        gap.threshold = threshold->numeric() ? std::optional(threshold->number) : std::nullopt;
    if (wanted(g + "contact"))
        gap.contact = v.choice<GapScene::Contact>(g + "contact");
    if (wanted(g + "roughness")) {
        const Node* roughness = v.given(g + "roughness");
        gap.automatic_roughness = !roughness || !roughness->numeric();
        if (!gap.automatic_roughness)
            gap.roughness = roughness->number;
    }
    if (wanted(g + "entrance_loss"))
        gap.entrance_loss = v.number(g + "entrance_loss");
    if (wanted(g + "exit"))
        gap.exit = v.choice<GapScene::Exit>(g + "exit");

    const std::string& c = contact_table;
    if (wanted(c + "restitution"))
        contact.restitution = v.number(c + "restitution");
    if (wanted(c + "friction"))
        contact.friction = v.number(c + "friction");
    if (wanted(c + "thickness"))
        contact.thickness = v.number(c + "thickness");
    if (gap.automatic_roughness) // a given contact thickness below it allows surfaces to come closer
        gap.roughness = contact.thickness > 0 ? std::min(automatic, contact.thickness) : automatic;
}

/// Dry contact and cavitation need the absolute pressure; `name`: the key that requests them.
void check_level(const Values& v, const std::string& name, const Scene& scene)
{
    const auto open = [](const SideScene& side) { return side.is_open(); };
    if (std::none_of(scene.sides.begin(), scene.sides.begin() + 2 * scene.dimension, open))
        v.refuse(name, "a dry or cavitating pair in a closed box has no pressure level",
                 "open a side of the domain, where the pressure is fluid.reference_pressure");
}

void check_dry(const Values& v, const std::string& gap_table, const GapScene& gap, const Scene& scene)
{
    if (gap.contact != GapScene::Contact::dry)
        return;
    const std::string name = gap_table + (v.given(gap_table + "contact") ? "contact" : "model");
    check_level(v, name, scene);
    if (!gap.film && !scene.parts)
        v.refuse(name, "dry contact needs the gap's film", "leave model = \"none\" and contact = \"dry\" to different pairs");
}

/// The names allowed in a pair: bodies and closed sides. `told`: for a message, of a crowd only the first and the last.
std::vector<std::string> partners(const Scene& scene, bool told = false)
{
    std::vector<std::string> names;
    const std::size_t alone = scene.crowds.empty() ? scene.bodies.size() : static_cast<std::size_t>(scene.crowds[0].first);
    for (std::size_t i = 0; i < (told ? alone : scene.bodies.size()); ++i)
        names.push_back(scene.bodies[i].name);
    for (const CrowdScene& crowd : scene.crowds)
        if (told)
            names.push_back(names_text(scene, crowd));
    for (int side = 0; side < 2 * scene.dimension; ++side)
        if (scene.sides[side].kind == SideScene::Kind::wall)
            names.push_back("wall:" + side_names[side]);
    return names;
}

void read_pair(const Values& v, double automatic, Scene& scene)
{
    PairScene pair;
    check_partners(v, "bodies", "a pair", scene);
    const std::vector<std::string> names = v.texts("bodies");
    std::copy(names.begin(), names.end(), pair.bodies.begin());
    for (const PairScene& other : scene.pairs)
        if (std::is_permutation(pair.bodies.begin(), pair.bodies.end(), other.bodies.begin()))
            v.refuse("bodies", "an earlier [[pair]] has the same two names", "put the keys of both into one [[pair]]");
    pair.gap = scene.gap;
    pair.contact = scene.contact;
    read_settings(v, "", "", false, automatic, pair.gap, pair.contact);
    if (v.given("contact") || v.given("model"))
        check_dry(v, "", pair.gap, scene);
    scene.pairs.push_back(pair);
}

} // namespace

void read_gaps(const Values& v, Purpose purpose, Scene& scene)
{
    read_settings(v, "gap.", "contact.", true, roughness_of_auto(purpose, scene), scene.gap, scene.contact);
    scene.parts = v.text("gap.model") == "parts";
    check_dry(v, "gap.", scene.gap, scene);
    if (scene.vapour_pressure)
        check_level(v, "fluid.vapour_pressure", scene);
}

void check_partners(const Values& v, const std::string& key, const std::string& what, const Scene& scene)
{
    const std::vector<std::string> names = v.texts(key), known = partners(scene);
    for (const std::string& name : names) {
        if (std::find(known.begin(), known.end(), name) != known.end())
            continue;
        for (const CrowdScene& crowd : scene.crowds)
            if (crowd.name == name)
                v.refuse(key, "'" + name + "' is a crowd, and " + what + " names single bodies",
                         "name one of " + names_text(scene, crowd) +
                             (key == "bodies" ? ", or set [gap] and [contact] for all pairs" : ""));
        const std::string near = nearest_name(name, known);
        const bool side =
            name.starts_with("wall:") && std::find(side_names.begin(), side_names.end(), name.substr(5)) != side_names.end();
        v.refuse(key,
                 side ? "'" + name + "': this side of the domain is not a wall"
                      : "no body or wall is named '" + name + "'" + (near.empty() ? "" : ", did you mean '" + near + "'?"),
                 "allowed: " + joined(partners(scene, true)));
    }
    if (names[0].starts_with("wall:") && names[1].starts_with("wall:"))
        v.refuse(key, "two walls have no gap between them", "name at least one body");
}

void read_pairs(const Values& v, const std::vector<KeyInfo>& keys, Purpose purpose, Scene& scene)
{
    const double automatic = roughness_of_auto(purpose, scene);
    const Node* pairs = v.given("pair");
    for (std::size_t i = 0; pairs && i < pairs->items.size(); ++i)
        read_pair(Values(pairs->items[i], "pair.", shown_prefix(pairs->items[i], "pair", static_cast<int>(i) + 1), keys,
                         scene.dimension),
                  automatic, scene);
}

} // namespace gapflow
