// All numbers of the complex that a person chose.
#pragma once

namespace gapflow {

/// Lengths in cells.
struct ComplexParameters {
    /// An open stretch of an edge of the grid shorter than this is closed: round-off of coordinates of up to 1e3 cells.
    double least_stretch = 1e-12;
    /// A part whose open faces are smaller is none (cells^(D-1)): round-off of areas.
    double least_area = 1e-13;
    /// Borders of solids that touch each other join within this distance: round-off of their sections.
    double joint_distance = 1e-9;
    /// Points along an arc at which two solids' overlap is looked for.
    int overlap_samples = 12;
    /// Planes of cells that a thread cuts at a time. An economy: no value depends on it.
    int slab = 8;
};

inline constexpr ComplexParameters parameters;

} // namespace gapflow
