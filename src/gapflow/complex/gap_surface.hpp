// Surfaces half-way between the walls of gaps: what is drawn of the fluid between two solids.
#pragma once

#include "gapflow/complex/complex.hpp"
#include "gapflow/complex/gap_arm.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace gapflow {

/// The fluid between two solids where they are less than about a cell apart. Lengths in metres.
template <int D>
struct GapSurface {
    struct Element { ///< 2D: a segment; 3D: a triangle
        std::array<int, D> points;
        std::int32_t part; ///< of the complex
        Vec<D> normal;     ///< unit, from the first solid to the second
        double area;       ///< 2D: length
    };

    std::array<std::int32_t, 2> solid; ///< the first has the smaller number
    std::vector<Vec<D>> points;
    std::vector<double> thickness;                ///< at each point, along the normal
    std::vector<std::vector<std::int32_t>> parts; ///< that meet at each point
    std::vector<Element> elements;
};

/// Whether the fluid at an arm belongs to the gap: half of its energy or more is a gap's.
template <int D>
bool is_of_gap(const GapArm<D>& arm)
{
    return arm.share >= 0.5;
}

/// Of the parts at such arms, in the order of their pairs: where both walls face each other, up to their sharp edges. On a rank that of its own cells.
template <int D>
std::vector<GapSurface<D>> gap_surfaces(const Grid<D>& grid, std::span<const Solid<D>> solids, const Complex<D>& complex,
                                        std::span<const GapArm<D>> arms);

} // namespace gapflow
