// Files that ParaView and VTK read: image data (.vti), rectilinear grids (.vtr), surfaces (.vtp) and polygons or polyhedra (.vtu) as XML.
//
// Arrays are little endian with 64-bit lengths: inline base64, which every reader of VTK's files reads, or raw bytes behind the XML ("appended"),
// a quarter smaller and faster to write and read. In 2D
// everything lies in the plane z = 0, and an array of two components is a vector: it gets a third one, 0.
#pragma once

#include "gapflow/core/types.hpp"
#include "gapflow/grid/field.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gapflow {

enum class VtkPrecision { float64, float32 };

struct VtkOptions {
    VtkPrecision precision = VtkPrecision::float64; ///< of data arrays; points are always 64 bits
    std::optional<double> time;                     ///< written as VTK's "TimeValue"
    bool appended = false;                          ///< raw bytes behind the XML
};

/// A named array: `components` values a point or cell, those of one point or cell together.
struct VtkArray {
    std::string name;
    int components = 1;
    std::vector<double> values;
};

/// Array of this rank's cells, first axis fastest: value(cell, component).
template <int D, class F>
VtkArray cell_array(const Grid<D>& grid, std::string name, int components, F&& value)
{
    VtkArray array{std::move(name), components, {}};
    array.values.reserve(static_cast<std::size_t>(grid.owned_cells() * components));
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
        for (int component = 0; component < components; ++component)
            array.values.push_back(value(c, component));
    });
    return array;
}

/// Values of all cells of the grid, first axis fastest, from those of every rank's own cells; empty except on the root.
/// Collective.
template <int D>
std::vector<double> gather_cells(const Grid<D>& grid, std::span<const double> owned, int components);

/// Extension of the file for a grid's cells: "vti", of a graded grid "vtr".
template <int D>
std::string cells_extension(const Grid<D>& grid)
{
    return grid.graded() ? "vtr" : "vti";
}

/// Writes cell data of the whole grid as one file, image data or, of a graded grid, a rectilinear grid; each array holds this rank's cells
/// (cell_array). The folder must exist. Throws ComputationError on every rank. Collective.
template <int D>
void write_cells(const std::filesystem::path& path, const Grid<D>& grid, std::span<const VtkArray> cell_data,
                 const VtkOptions& options = {});

/// Lines (2D) or triangles (3D) with data.
template <int D>
struct VtkSurface {
    std::vector<Vec<D>> points;
    std::vector<std::array<int, D>> elements;
    std::vector<VtkArray> point_data, cell_data; ///< a tuple a point; a tuple an element
};

/// Writes a surface. The folder must exist. Throws ComputationError. Not collective: call it on the root (on_root).
template <int D>
void write_vtp(const std::filesystem::path& path, const VtkSurface<D>& surface, const VtkOptions& options = {});

/// Polygons (2D) or polyhedra (3D) with data.
template <int D>
struct VtkCells {
    std::vector<Vec<D>> points;
    /// Of each cell its faces as lists of points; of a polygon the only one is its outline.
    std::vector<std::vector<std::vector<std::int64_t>>> cells;
    std::vector<VtkArray> cell_data; ///< a tuple a cell
};

/// Writes an unstructured grid. The folder must exist. Throws ComputationError. Not collective: call it on the root (on_root).
template <int D>
void write_vtu(const std::filesystem::path& path, const VtkCells<D>& cells, const VtkOptions& options = {});

} // namespace gapflow
