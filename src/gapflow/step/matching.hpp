// Parts of the fluid at one place of the bodies, and those at another place that they become.
#pragma once

#include "gapflow/complex/complex.hpp"
#include "gapflow/grid/grid.hpp"

#include <cstdint>
#include <vector>

namespace gapflow {

/// What a part is at another place of the bodies.
struct MatchedPart {
    enum class Kind : std::int8_t { none, main, other };
    Kind kind = Kind::none; ///< main: the largest part of its cell; other: the part `part`
    std::int32_t part = -1;
};

/// For each part of `own` the nearest one of the same cell of `other`, by the middle of its open faces, each once.
template <int D>
std::vector<MatchedPart> matched_parts(const Grid<D>& grid, const Complex<D>& own, const Complex<D>& other);

} // namespace gapflow
