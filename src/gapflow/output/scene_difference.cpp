#include "gapflow/output/scene_difference.hpp"

#include "gapflow/core/text.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

namespace gapflow {

namespace {

using Json = nlohmann::ordered_json;

// The part that counts.
Json essence(const std::string& scene, const std::vector<std::string>& free)
{
    Json json = Json::parse(scene);
    for (const std::string& key : free)
        if (const auto dot = key.find('.'); dot == std::string::npos)
            json.erase(key);
        else if (json.contains(key.substr(0, dot)))
            json[key.substr(0, dot)].erase(key.substr(dot + 1));
    const auto bare = [](Json& object, const char* key) {
        if (object.is_object() && object.contains(key) && object[key].is_string())
            object[key] = std::filesystem::path(object[key].get<std::string>()).filename().string();
    };
    for (Json& body : json["body"]) {
        bare(body, "file");
        bare(body, "motion_file");
    }
    for (Json& side : json["domain"]["sides"]) {
        bare(side, "inflow");
        bare(side, "pressure");
    }
    return json;
}

// Dotted path of the first difference and both values; empty: none.
std::string difference(const Json& then, const Json& now, const std::string& path)
{
    if (then == now)
        return {};
    const auto below = [&](const std::string& key) { return path.empty() ? key : path + "." + key; };
    if (then.is_object() && now.is_object()) {
        for (const auto& [key, value] : then.items())
            if (const std::string found = difference(value, now.value(key, Json()), below(key)); !found.empty())
                return found;
        for (const auto& [key, value] : now.items())
            if (!then.contains(key))
                return difference(Json(), value, below(key));
    }
    if (then.is_array() && now.is_array() && !then.empty() && then[0].is_object()) {
        if (then.size() != now.size())
            return "number of [[" + path + "]]: was " + std::to_string(then.size()) + ", is " + std::to_string(now.size());
        for (std::size_t i = 0; i < then.size(); ++i) {
            const std::string name = then[i].contains("name") ? then[i]["name"].get<std::string>() : std::to_string(i + 1);
            if (const std::string found = difference(then[i], now[i], below(name)); !found.empty())
                return found;
        }
    }
    const auto text = [](const Json& value) { return value.is_null() ? std::string("not given") : value.dump(); };
    return path + ": was " + text(then) + ", is " + text(now);
}

std::string value_text(const Json& value)
{
    return value.is_string()         ? value.get<std::string>()
           : value.is_number_float() ? number_text(value.get<double>())
                                     : value.dump();
}

// Values by dotted key; elements of lists of tables by name, or by number.
void flatten(const Json& value, const std::string& path, std::map<std::string, std::string>& values)
{
    const auto below = [&](const std::string& key) { return path.empty() ? key : path + "." + key; };
    if (value.is_object()) {
        for (const auto& [key, entry] : value.items())
            flatten(entry, below(key), values);
    } else if (value.is_array() && !value.empty() && value[0].is_object()) {
        for (std::size_t i = 0; i < value.size(); ++i)
            flatten(value[i], below(value[i].contains("name") ? value[i]["name"].get<std::string>() : std::to_string(i + 1)),
                    values);
    } else {
        values[path] = value_text(value);
    }
}

} // namespace

std::string scene_difference(const std::string& then, const std::string& now, const std::vector<std::string>& free)
{
    return difference(essence(then, free), essence(now, free), "");
}

std::map<std::string, std::vector<std::string>> differing_values(const std::vector<std::string>& scenes)
{
    std::map<std::string, std::vector<std::string>> all;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        std::map<std::string, std::string> values;
        flatten(essence(scenes[i], {"title", "output", "solver"}), "", values);
        for (const auto& [key, text] : values)
            all.try_emplace(key, scenes.size(), "-").first->second[i] = text;
    }
    std::erase_if(all, [](const auto& entry) {
        return std::all_of(entry.second.begin(), entry.second.end(),
                           [&](const std::string& text) { return text == entry.second[0]; });
    });
    return all;
}

} // namespace gapflow
