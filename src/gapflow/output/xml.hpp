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
        case '&': result += "&amp;"; break;
        case '<': result += "&lt;"; break;
        case '>': result += "&gt;"; break;
        case '"': result += "&quot;"; break;
        default: result += c;
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

} // namespace gapflow
