#include "gapflow/scene/values.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/core/text.hpp"
#include "gapflow/scene/check_keys.hpp"

#include <algorithm>
#include <cassert>

namespace gapflow {

Values::Values(const Node& table, std::string prefix, std::string shown, const std::vector<KeyInfo>& keys, int dimension)
    : table_(table), prefix_(std::move(prefix)), shown_(std::move(shown)), keys_(keys), dimension_(dimension)
{
}

const KeyInfo& Values::info(const std::string& name) const
{
    const KeyInfo* key = find_key(keys_, prefix_ + name);
    assert(key);
    return *key;
}

bool Values::known(const std::string& name) const
{
    return find_key(keys_, prefix_ + name) != nullptr;
}

const Node* Values::given(const std::string& name) const
{
    const Node* node = &table_;
    for (const auto part : split(name, '.'))
        node = node ? node->find(part) : nullptr;
    return node;
}

bool Values::has(const std::string& name) const
{
    return given(name) || !info(name).default_value.empty();
}

Node Values::value(const std::string& name) const
{
    if (const Node* node = given(name))
        return *node;
    assert(has(name));
    return parse_value(info(name).default_value, "default");
}

double Values::number(const std::string& name) const
{
    return value(name).number;
}

bool Values::flag(const std::string& name) const
{
    return value(name).flag;
}

std::string Values::text(const std::string& name) const
{
    return value(name).text;
}

std::vector<std::string> Values::texts(const std::string& name) const
{
    std::vector<std::string> list;
    for (const Node& item : value(name).items)
        list.push_back(item.text);
    return list;
}

Triple Values::triple(const std::string& name) const
{
    const Node node = value(name);
    if (node.kind == Node::Kind::array || info(name).type == KeyType::spin)
        return to_triple(node);
    Triple all{}; // a default of one number stands for every axis
    std::fill_n(all.begin(), dimension_, node.number);
    return all;
}

int Values::choice_number(const std::string& name) const
{
    const auto& choices = info(name).choices;
    return static_cast<int>(std::find(choices.begin(), choices.end(), text(name)) - choices.begin());
}

void Values::refuse(const std::string& name, const std::string& problem, const std::string& remedy) const
{
    gapflow::refuse(*given(name), shown(name), problem, remedy);
}

void Values::refuse_missing(const std::string& name, const std::string& why) const
{
    const auto dot = name.rfind('.');
    const Node* holder = dot == std::string::npos ? &table_ : given(name.substr(0, dot));
    throw InputError((holder ? *holder : table_).where + ": " + shown(name) + " is missing: " + why + "; give " +
                     allowed_values(info(name), dimension_) + " (" + info(name).meaning + ")");
}

Triple to_triple(const Node& node)
{
    if (node.numeric())
        return {node.number, 0, 0};
    Triple triple{};
    for (std::size_t i = 0; i < std::min<std::size_t>(node.items.size(), 3); ++i)
        triple[i] = node.items[i].number;
    return triple;
}

} // namespace gapflow
