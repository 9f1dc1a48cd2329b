// Pieces of VTK's XML files.
#pragma once

#include <string>
#include <string_view>

namespace gapflow {

/// Text as it may stand in an attribute's value.
inline std::string escaped(std::string_view text)
{
    std::string result;
    for (const char c : text) {
        switch (c) {
        case '&':
            result += "&amp;";
            break;
        case '<':
            result += "&lt;";
            break;
        case '>':
            result += "&gt;";
            break;
        case '"':
            result += "&quot;";
            break;
        default:
            result += c;
        }
    }
    return result;
}

/// Inverse of escaped().
inline std::string unescaped(std::string_view text)
{
    static constexpr std::string_view names[4][2] = {{"&amp;", "&"}, {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}};
    std::string result;
    while (!text.empty()) {
        std::size_t length = 1;
        std::string_view meaning = text.substr(0, 1);
        for (const auto& name : names)
            if (text.starts_with(name[0])) {
                length = name[0].size();
                meaning = name[1];
            }
        result += meaning;
        text.remove_prefix(length);
    }
    return result;
}

/// Value of an attribute in the head of an element that escaped() made; empty if it is not there.
inline std::string attribute(std::string_view head, const std::string& name)
{
    const std::string opening = " " + name + "=\"";
    const auto at = head.find(opening);
    if (at == std::string_view::npos)
        return {};
    const auto from = at + opening.size();
    return unescaped(head.substr(from, head.find('"', from) - from));
}

} // namespace gapflow
