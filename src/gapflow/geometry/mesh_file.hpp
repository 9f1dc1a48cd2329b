// Readers of surface files.
#pragma once

#include "gapflow/geometry/shape.hpp"

#include <string>
#include <vector>

namespace gapflow {

/// Facets as the file has them, coordinates times scale; `patch` empty. 3D: OBJ (v and f lines; polygons become fans) or STL
/// (ASCII or binary; every triangle with its own vertices, weld them). 2D: loops of "x y" lines, or if `open` polylines
/// (one that ends at its first point is a loop). Throws InputError naming
/// the file and, for text, the line. If `lines`, it gets the line on which each facet starts (from 1; empty for binary files).
template <int D>
SurfaceMesh<D> read_surface_file(const std::string& file, double scale, std::vector<int>* lines = nullptr, bool open = false);

/// The same of a file's content; `file` is its name in messages, and its extension determines the format.
template <int D>
SurfaceMesh<D> parse_surface(const std::string& text, const std::string& file, double scale, std::vector<int>* lines = nullptr,
                             bool open = false);

} // namespace gapflow
