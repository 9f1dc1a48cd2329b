// Values given to --set, put in their places in the document.
#include "gapflow/core/error.hpp"
#include "gapflow/core/text.hpp"
#include "gapflow/scene/check_keys.hpp"

namespace gapflow {

namespace {

/// The body, or the element of another list of tables, that a dotted name starts with, the longest name first (names may hold dots);
/// `rest` becomes what follows it.
Node& addressed(const std::string& kind, Node& document, const std::string& where, std::string& rest)
{
    Node none;
    Node* bodies = document.find(kind);
    Node* best = nullptr;
    std::size_t length = 0;
    std::vector<std::string> names;
    for (Node& body : (bodies ? *bodies : none).items) {
        const Node* name = body.find("name");
        if (!name || name->kind != Node::Kind::text)
            continue;
        names.push_back(name->text);
        if (rest.starts_with(name->text + ".") && name->text.size() >= length) {
            best = &body;
            length = name->text.size();
        }
    }
    if (!best) {
        const std::string given = rest.substr(0, rest.find('.'));
        const std::string near = nearest_name(given, names);
        throw InputError(where + ": no " + kind + " is named '" + given + "'" +
                         (near.empty() ? "" : ", did you mean '" + near + "'?") + "; write " + kind +
                         ".NAME.key=value with one of the names: " + joined(names));
    }
    rest = rest.substr(length + 1);
    return *best;
}

/// The entry of a table by dotted name; tables on the way are made.
Node& make_entry(Node& table, const std::string& name, const std::string& where)
{
    Node* node = &table;
    for (const auto part : split(name, '.')) {
        if (!node->find(part)) {
            Node entry;
            entry.key = part;
            entry.where = where;
            node->items.push_back(entry);
        }
        node = node->find(part);
    }
    return *node;
}

void apply(Node& document, const std::string& dotted, const std::string& text, const std::vector<KeyInfo>& keys)
{
    const std::string where = "--set " + dotted;
    if (dotted == "pair" || dotted.starts_with("pair."))
        throw InputError(where + ": pairs have no names and cannot be set here; edit [[pair]] in the scene file");
    Node* table = &document;
    std::string name = dotted, rest = dotted;
    for (const std::string kind : {"body", "crowd", "probe", "flux"})
        if (dotted.starts_with(kind + ".")) {
            rest = dotted.substr(kind.size() + 1);
            table = &addressed(kind, document, where, rest);
            name = kind + "." + rest;
        }
    const KeyInfo* key = find_key(keys, name);
    if (!key && is_table(keys, name))
        throw InputError(where + ": is a table; set its keys one by one, as " +
                         (name == "body"                      ? "body.NAME.position=..."
                          : name == "crowd"                   ? "crowd.NAME.number=..."
                          : name == "probe" || name == "flux" ? name + ".NAME.every=..."
                                                              : dotted + ".key=value"));
    if (!key)
        refuse_unknown(where, name, dotted, keys);
    Node value = parse_value(text, where);
    const bool scalar = value.kind != Node::Kind::array && value.kind != Node::Kind::table;
    if (key->type == KeyType::text && scalar && value.kind != Node::Kind::text) { // a title of digits needs no quotes
        value.kind = Node::Kind::text;
        value.text = trimmed(text);
    }
    Node& entry = make_entry(*table, rest, where);
    value.key = entry.key;
    entry = std::move(value);
}

} // namespace

void apply_overrides(Node& document, const std::vector<std::pair<std::string, std::string>>& overrides,
                     const std::vector<KeyInfo>& keys)
{
    for (const auto& [key, value] : overrides)
        apply(document, key, value, keys);
}

} // namespace gapflow
