// Check of the parameters of shapes.
#pragma once

#include "gapflow/core/error.hpp"

#include <cmath>
#include <sstream>
#include <string>

namespace gapflow {

/// Throws InputError naming shape, parameter and value unless the value is positive and finite.
inline void require_positive(const std::string& shape, const std::string& parameter, double value)
{
    if (value > 0 && std::isfinite(value))
        return;
    std::ostringstream text;
    text << shape << ": " << parameter << " = " << value << " is not allowed; give a length > 0";
    throw InputError(text.str());
}

} // namespace gapflow
