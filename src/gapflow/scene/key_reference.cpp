#include "gapflow/scene/key_reference.hpp"

#include "gapflow/core/text.hpp"

#include <algorithm>
#include <functional>

namespace gapflow {

namespace {

std::string table_of(const KeyInfo& key)
{
    const auto dot = key.name.find('.');
    if (dot == std::string::npos)
        return "";
    return key.name.starts_with("domain.sides.") ? "domain.sides" : key.name.substr(0, dot);
}

/// The key's name within its table.
std::string name_in_table(const KeyInfo& key)
{
    const std::string table = table_of(key);
    return table.empty() ? key.name : key.name.substr(table.size() + 1);
}

std::string header_of(const std::string& table)
{
    return is_list_table(table) ? "[[" + table + "]]" : "[" + table + "]";
}

std::string meaning_of_table(const std::string& table)
{
    if (table.empty())
        return "At the top of the file, before the first table.";
    if (table == "domain")
        return "The box that the fluid fills, and its grid.";
    if (table == "domain.sides")
        return "Boundary conditions at the domain's sides.";
    if (table == "fluid")
        return "Its density, pressures and start.";
    if (table == "grid")
        return "Numerical choices; the defaults are the best known.";
    if (table == "gap")
        return "Thin gaps: settings of all pairs that no [[pair]] changes.";
    if (table == "contact")
        return "Contact of solids: settings of all pairs that no [[pair]] changes.";
    if (table == "pair")
        return "Any key of [gap] and [contact] for one pair, as often as needed. Walls are named wall:x_low to wall:z_high.";
    if (table == "body")
        return "A solid, as often as needed. In 2D, masses and forces are per unit depth.";
    if (table == "crowd")
        return "Many bodies of one shape, as often as needed; they become bodies NAME_0001, NAME_0002 ... behind all of "
               "[[body]]. They "
               "lie wholly in the region, in the same places on every machine.";
    if (table == "probe")
        return "Values of the flow at points, in probes.csv: point, points, line or plane.";
    if (table == "flux")
        return "Volume flux through a side, a plane or a gap, in fluxes.csv.";
    if (table == "time")
        return "Needed by `gapflow run` and `gapflow converge` only.";
    if (table == "solver")
        return "Of the pressures.";
    return "Files of a run.";
}

/// What may stand there: range or choices, and the unit.
std::string value_of(const KeyInfo& key)
{
    return allowed_values(key, 0) + (key.unit.empty() ? "" : ", in " + key.unit);
}

/// Default, or when it is needed.
std::string default_of(const KeyInfo& key)
{
    if (key.needed == "always")
        return "needed";
    if (!key.needed.empty())
        return "needed " + key.needed;
    if (table_of(key) == "pair")
        return "that of " +
               (key.meaning.substr(key.meaning.find("(default: ") + 10, 3) == "gap" ? std::string("[gap]") : "[contact]");
    if (key.type == KeyType::vector && key.default_value == "0.0")
        return "0 on every axis";
    return key.default_value.empty() ? "none" : key.default_value;
}

std::string meaning_of(const KeyInfo& key)
{
    return key.meaning.substr(0, key.meaning.find(" (default: "));
}

/// Calls `table` before the first key of every table and `key` for every key.
void for_each_key(const std::function<void(const std::string&)>& table, const std::function<void(const KeyInfo&)>& key)
{
    std::string open = "none";
    for (const KeyInfo& info : scene_keys()) {
        if (table_of(info) != open)
            table(open = table_of(info));
        key(info);
    }
}

/// A cell of a Markdown table.
std::string cell(const std::string& text)
{
    std::string out;
    for (const char c : text) {
        if (c == '|' || c == '<' || c == '[' || c == ']')
            out += '\\';
        out += c;
    }
    return out;
}

/// Text of a man page: no line starts a request, no backslash starts an escape.
std::string man_text(const std::string& text)
{
    std::string out;
    for (const char c : text) {
        if (c == '-')
            out += "\\-";
        else if (c == '\\')
            out += "\\e";
        else
            out += c;
    }
    return out.starts_with('.') || out.starts_with('\'') ? "\\&" + out : out;
}

} // namespace

std::string key_list(const std::string& within)
{
    std::string out;
    for (const KeyInfo& key : scene_keys())
        if (within.empty() || key.name == within || key.name.starts_with(within + "."))
            out += key.name + "\n    " + meaning_of(key) + "\n    " + value_of(key) + "; default: " + default_of(key) + "\n";
    return out;
}

std::string key_names()
{
    std::string out;
    for (const KeyInfo& key : scene_keys()) {
        if (key.name.starts_with("pair."))
            continue;
        const std::string table = table_of(key);
        out += is_list_table(table) ? table + ".NAME." + key.name.substr(table.size() + 1) : key.name;
        out += '\n';
    }
    return out;
}

std::string key_page()
{
    std::string out =
        "# Scene keys\n\n"
        "All keys of a scene file, from the table that the reader checks scenes with (`gapflow keys` prints it; this "
        "page is what\n`gapflow generate scene-markdown` writes). Units are those of SI; any consistent units do. A file "
        "named in a scene is looked for\nin the scene's folder. `--set` takes the dotted names, bodies by name: "
        "`--set gap.model=none`, `--set body.upper.density=2`.\n";
    for_each_key(
        [&](const std::string& table) {
            out += "\n## " + (table.empty() ? "Without a table" : "`" + header_of(table) + "`") + "\n\n" +
                   cell(meaning_of_table(table)) + "\n\n| key | value | default | meaning |\n|---|---|---|---|\n";
        },
        [&](const KeyInfo& key) {
            out += "| `" + name_in_table(key) + "` | " + cell(value_of(key)) + " | " + cell(default_of(key)) + " | " +
                   cell(meaning_of(key)) + " |\n";
        });
    return out;
}

std::string key_manual(const std::string& version)
{
    std::string out =
        ".TH GAPFLOW\\-SCENE 5 \"\" \"gapflow " + version +
        "\" \"Gapflow\"\n.SH NAME\ngapflow\\-scene \\- scene files of gapflow\n.SH DESCRIPTION\n"
        "A scene is a TOML file. Units are those of SI; any consistent units do. A file named in a scene is looked for "
        "in the scene's folder.\n";
    for_each_key(
        [&](const std::string& table) {
            out += ".SH " + (table.empty() ? "WITHOUT A TABLE" : man_text(header_of(table))) + "\n" +
                   man_text(meaning_of_table(table)) + "\n";
        },
        [&](const KeyInfo& key) {
            out += ".TP\n.B " + man_text(name_in_table(key)) + "\n" + man_text(meaning_of(key)) +
                   ".\n.br\nValue: " + man_text(value_of(key)) + ". Default: " + man_text(default_of(key)) + ".\n";
        });
    return out + ".SH SEE ALSO\n.BR gapflow (1)\n";
}

} // namespace gapflow
