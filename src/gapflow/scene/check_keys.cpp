#include "gapflow/scene/check_keys.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/core/text.hpp"
#include "gapflow/scene/check_value.hpp"

#include <algorithm>
#include <functional>

namespace gapflow {

const KeyInfo* find_key(const std::vector<KeyInfo>& keys, const std::string& name)
{
    const auto key = std::find_if(keys.begin(), keys.end(), [&](const KeyInfo& k) { return k.name == name; });
    return key == keys.end() ? nullptr : &*key;
}

bool is_table(const std::vector<KeyInfo>& keys, const std::string& name)
{
    return std::any_of(keys.begin(), keys.end(), [&](const KeyInfo& k) { return k.name.starts_with(name + "."); });
}

namespace {

/// Keys and tables directly in a table ("" or "gap.").
std::vector<std::string> keys_in(const std::string& table, const std::vector<KeyInfo>& keys)
{
    std::vector<std::string> names;
    for (const KeyInfo& key : keys)
        if (key.name.starts_with(table)) {
            const std::string name = key.name.substr(table.size(), key.name.find('.', table.size()) - table.size());
            if (names.empty() || names.back() != name)
                names.push_back(name);
        }
    return names;
}

} // namespace

std::string shown_prefix(const Node& element, const std::string& table, int number)
{
    const Node* name = element.find("name");
    if (table != "pair" && name && name->kind == Node::Kind::text && !name->text.empty())
        return table + "." + name->text + ".";
    return table + "[" + std::to_string(number) + "].";
}

void refuse_unknown(const std::string& where, const std::string& name, const std::string& shown,
                    const std::vector<KeyInfo>& keys)
{
    const std::string place = where == "--set " + shown ? where : where + ": " + shown;
    const std::string near = nearest_key(name, keys);
    const auto dot = name.rfind('.');
    const std::string table = dot == std::string::npos ? "" : name.substr(0, dot + 1);
    const std::string list = joined(keys_in(table, keys));
    const std::string known =
        list.empty() ? "" : (table.empty() ? "the scene's own keys and tables are: " : "keys of this table: ") + list;
    if (near.empty())
        throw InputError(place + ": unknown key" + (known.empty() ? "" : "; " + known));
    std::string meant = near;
    if (near.starts_with(table) && shown.ends_with(last_part(name)))
        meant = shown.substr(0, shown.size() - last_part(name).size()) + near.substr(table.size());
    throw InputError(place + ": unknown key; did you mean '" + meant + "'?" + (known.empty() ? "" : " (" + known + ")"));
}

namespace {

using Visit = std::function<void(const Node& value, const KeyInfo& key, const std::string& shown)>;

/// Calls `visit` for every key of a table and of the tables in it, in the file's order.
void walk(const Node& table, const std::string& prefix, const std::string& shown, const std::vector<KeyInfo>& keys,
          const Visit& visit)
{
    for (const Node& item : table.items) {
        const std::string name = prefix + item.key;
        if (const KeyInfo* key = find_key(keys, name)) {
            visit(item, *key, shown + item.key);
        } else if (!is_table(keys, name)) {
            refuse_unknown(item.key_where, name, shown + item.key, keys);
        } else if (!is_list_table(name)) {
            if (item.kind != Node::Kind::table)
                refuse(item, shown + item.key, "is a table", "write [" + name + "] on a line of its own and its keys below it");
            walk(item, name + ".", shown + item.key + ".", keys, visit);
        } else {
            const auto good = [](const Node& element) { return element.kind == Node::Kind::table; };
            if (item.kind != Node::Kind::array || !std::all_of(item.items.begin(), item.items.end(), good))
                refuse(item, item.key, "is a list of tables",
                       "write [[" + name + "]] with two brackets before each one's keys");
            for (std::size_t i = 0; i < item.items.size(); ++i)
                walk(item.items[i], name + ".", shown_prefix(item.items[i], name, static_cast<int>(i) + 1), keys, visit);
        }
    }
}

const Node* find_path(const Node& document, const std::string& name)
{
    const Node* node = &document;
    for (const auto part : split(name, '.'))
        node = node ? node->find(part) : nullptr;
    return node;
}

void refuse_missing(const std::string& where, const std::string& shown, const KeyInfo& key, int dimension)
{
    throw InputError(where + ": " + shown + " is missing: " + key.meaning + "; give " + allowed_values(key, dimension));
}

void check_needed(const Node& document, const std::vector<KeyInfo>& keys, int dimension)
{
    for (const KeyInfo& key : keys) {
        if (key.needed != "always")
            continue;
        const std::string table = key.name.substr(0, key.name.find('.')), name = last_part(key.name);
        const Node* node = document.find(table);
        if (!is_list_table(table)) {
            if (!find_path(document, key.name))
                refuse_missing(node ? node->where : document.where, key.name, key, dimension);
        } else if (node) {
            for (std::size_t i = 0; i < node->items.size(); ++i)
                if (!node->items[i].find(name))
                    refuse_missing(node->items[i].where, shown_prefix(node->items[i], table, static_cast<int>(i) + 1) + name,
                                   key, dimension);
        }
    }
}

} // namespace

void check_names(const Node& document, const std::vector<KeyInfo>& keys)
{
    walk(document, "", "", keys, [](const Node&, const KeyInfo&, const std::string&) {});
}

int dimension_of(const Node& document, const std::vector<KeyInfo>& keys)
{
    const KeyInfo& key = *find_key(keys, "domain.size");
    const Node* domain = document.find("domain");
    const Node* size = domain ? domain->find("size") : nullptr;
    if (!size)
        refuse_missing(domain ? domain->where : document.where, key.name, key, 0);
    if (size->kind != Node::Kind::array || (size->items.size() != 2 && size->items.size() != 3))
        refuse(*size, key.name, "must be " + allowed_values(key, 0), "write two numbers for a 2D scene, three for a 3D scene");
    return static_cast<int>(size->items.size());
}

void check_values(const Node& document, const std::vector<KeyInfo>& keys, int dimension)
{
    walk(document, "", "", keys, [&](const Node& value, const KeyInfo& key, const std::string& shown) {
        if (dimension == 2 && key.name.starts_with("domain.sides.z"))
            refuse(value, shown, "a 2D scene has no z sides", "remove the key, or give domain.size three numbers");
        check_value(value, key, shown, dimension);
    });
    check_needed(document, keys, dimension);
}

} // namespace gapflow
