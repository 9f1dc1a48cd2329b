// Numbers in messages of a run.
#pragma once

#include <cstdio>
#include <string>

namespace gapflow {

/// A number in six digits.
inline std::string short_text(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

} // namespace gapflow
