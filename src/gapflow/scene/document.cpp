#include "gapflow/scene/document.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/core/text.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace gapflow {

namespace {

std::string place(const std::string& file, const toml::source_region& source)
{
    if (source.begin.line == 0)
        return file;
    return file + ":" + std::to_string(source.begin.line) + ":" + std::to_string(source.begin.column);
}

Node translate(const toml::node& from, const std::string& file);

void translate_table(const toml::table& table, const std::string& file, Node& node)
{
    std::vector<std::pair<toml::source_position, Node>> entries; // the library sorts by name, messages need the file's order
    for (const auto& [key, value] : table) {
        Node item = translate(value, file);
        item.key = key.str();
        item.key_where = place(file, key.source());
        if (value.source().begin.line == 0) // a table that is there only by the tables in it
            item.where = item.key_where;
        entries.emplace_back(key.source().begin, std::move(item));
    }
    std::stable_sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (auto& entry : entries)
        node.items.push_back(std::move(entry.second));
}

Node translate(const toml::node& from, const std::string& file)
{
    Node node;
    node.where = place(file, from.source());
    if (const auto* table = from.as_table()) {
        node.kind = Node::Kind::table;
        translate_table(*table, file, node);
    } else if (const auto* array = from.as_array()) {
        node.kind = Node::Kind::array;
        for (const toml::node& item : *array)
            node.items.push_back(translate(item, file));
    } else if (const auto* text = from.as_string()) {
        node.kind = Node::Kind::text;
        node.text = text->get();
    } else if (const auto* integer = from.as_integer()) {
        node.kind = Node::Kind::integer;
        node.number = static_cast<double>(integer->get());
    } else if (const auto* number = from.as_floating_point()) {
        node.kind = Node::Kind::number;
        node.number = number->get();
    } else if (const auto* flag = from.as_boolean()) {
        node.kind = Node::Kind::flag;
        node.flag = flag->get();
    } else {
        node.kind = Node::Kind::date;
        std::ostringstream out;
        from.visit([&](const auto& value) {
            if constexpr (toml::is_chronological<decltype(value)>)
                out << value.get();
        });
        node.text = out.str();
    }
    return node;
}

std::string quoted(const std::string& text)
{
    std::string out = "\"";
    for (char c : text) {
        if (c == '"' || c == '\\')
            out += '\\';
        out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    return out + '"';
}

std::string full_text(const Node& node)
{
    switch (node.kind) {
    case Node::Kind::text:
        return quoted(node.text);
    case Node::Kind::integer:
    case Node::Kind::number:
        return number_text(node.number);
    case Node::Kind::flag:
        return node.flag ? "true" : "false";
    case Node::Kind::date:
        return node.text;
    case Node::Kind::array:
    case Node::Kind::table:
        break;
    }
    std::vector<std::string> parts;
    for (const Node& item : node.items)
        parts.push_back(item.key.empty() ? full_text(item) : item.key + " = " + full_text(item));
    const bool array = node.kind == Node::Kind::array;
    return array ? "[" + joined(parts) + "]" : "{ " + joined(parts) + " }";
}

} // namespace

const Node* Node::find(std::string_view name) const
{
    if (kind != Kind::table)
        return nullptr;
    const auto entry = std::find_if(items.begin(), items.end(), [&](const Node& item) { return item.key == name; });
    return entry == items.end() ? nullptr : &*entry;
}

Node* Node::find(std::string_view name)
{
    return const_cast<Node*>(std::as_const(*this).find(name));
}

Node read_document(const std::string& file)
{
    std::error_code error;
    if (std::filesystem::is_directory(file, error))
        throw InputError(file + ": is a folder, not a scene; name the TOML file in it");
    std::ifstream in(file, std::ios::binary);
    const std::string content{std::istreambuf_iterator<char>(in), {}};
    if (!in)
        throw InputError(file + ": cannot be read; check the path of the scene and its permissions");
    return parse_document(content, file);
}

Node parse_document(std::string_view content, const std::string& file)
{
    try {
        Node node = translate(toml::parse(content, std::string_view(file)), file);
        node.where = file;
        return node;
    } catch (const toml::parse_error& e) {
        throw InputError(place(file, e.source()) + ": not valid TOML: " + std::string(e.description()) +
                         "; a line reads key = value, text stands in \"quotes\", lists in [ ], tables in { }");
    }
}

Node parse_value(const std::string& text, const std::string& where)
{
    try {
        const toml::table table = toml::parse("v = " + text);
        if (table.size() == 1) {
            Node node = translate(*table.get("v"), where);
            std::vector<Node*> open{&node}; // the place is the same for all parts
            while (!open.empty()) {
                Node* part = open.back();
                open.pop_back();
                part->where = where;
                for (Node& item : part->items)
                    open.push_back(&item);
            }
            return node;
        }
    } catch (const toml::parse_error&) {
    }
    const std::string word(trimmed(text));
    if (word.empty())
        throw InputError(where + ": has no value; write key=value");
    if (word.find_first_of("[{\"'\n") != std::string::npos)
        throw InputError(where + " = " + word + ": not a TOML value; write numbers as 1.5, lists as [1, 2], text as \"text\"");
    Node node;
    node.kind = Node::Kind::text;
    node.where = where;
    node.text = word;
    return node;
}

std::string value_text(const Node& node)
{
    constexpr std::size_t longest = 100;
    const std::string text = full_text(node);
    return text.size() <= longest ? text : text.substr(0, longest) + " ...";
}

std::string place_of(const Node& node, const std::string& key)
{
    return node.where == "--set " + key ? node.where : node.where + ": " + key;
}

void refuse(const Node& node, const std::string& key, const std::string& problem, const std::string& remedy)
{
    throw InputError(place_of(node, key) + " = " + value_text(node) + ": " + problem + "; " + remedy);
}

} // namespace gapflow
