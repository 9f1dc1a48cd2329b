// Base64 of whole byte strings (RFC 4648). Streams of numbers are encoded where they are written (vtk.cpp).
#pragma once

#include <string>
#include <string_view>

namespace gapflow {

inline std::string base64(std::string_view bytes)
{
    static constexpr char alphabet[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned word = 0;
        for (std::size_t k = 0; k < 3; ++k)
            word = word << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k < bytes.size() + 1 ? alphabet[word >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

} // namespace gapflow
