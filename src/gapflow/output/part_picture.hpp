// The parts of the fluid (complex/) as polygons and polyhedra with data, for ParaView.
#pragma once

#include "gapflow/complex/part_borders.hpp"
#include "gapflow/output/vtk.hpp"

#include <filesystem>
#include <span>

namespace gapflow {

/// What the picture says of a part. Lengths in cells.
struct PartFigures {
    enum class Kind { whole, cut, thin };
    Kind kind = Kind::whole;
    double volume = 0;
    /// Of a thin part: its volume over sum |S_w| - |sum S_w|, halved, S_w the area vectors of its connected walls: the area with which walls face each
    /// other. The distance of parallel walls. Kind::thin where it is below one.
    double thickness = 0;
    int walls = 0;               ///< solids that bound it
    int first = -1, second = -1; ///< those with the largest walls; -1: none
};

/// `faces`: of one part. Closed sides of the domain are walls.
template <int D>
PartFigures part_figures(const Grid<D>& grid, std::span<const Solid<D>> solids, std::span<const PartFace<D>> faces);

struct PartCounts {
    long parts = 0, thin = 0;
};

/// Writes a VTK file (.vtu) of all parts, in 2D of the whole cells as well. The folder must exist. Throws ComputationError. One rank.
template <int D>
PartCounts write_parts(const std::filesystem::path& path, const Grid<D>& grid, std::span<const Solid<D>> solids,
                       const Complex<D>& complex, const PartBorders<D>& borders);

} // namespace gapflow
