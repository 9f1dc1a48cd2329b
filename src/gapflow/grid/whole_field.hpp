// Fields of the whole grid on the root: gathered from the ranks and shared out again.
#pragma once

#include "gapflow/core/state_archive.hpp"
#include "gapflow/grid/field.hpp"

#include <span>
#include <string>
#include <vector>

namespace gapflow {

/// Values of the box `all`, first axis fastest, from every rank's values of its own part low <= i < high of it (`components`
/// values an index); empty except on the root. Collective.
template <int D>
std::vector<double> gather(const Grid<D>& grid, const Block<D>& all, const Index<D>& low, const Index<D>& high,
                           std::span<const double> own, int components = 1);

/// The reverse: this rank's values from those that the root has of all. Collective.
template <int D>
std::vector<double> scatter(const Grid<D>& grid, const Block<D>& all, const Index<D>& low, const Index<D>& high,
                            std::span<const double> values);

/// Stores or restores the owned values; ghosts stay as they are. Throws StateError where the stored field is of another grid.
/// Collective.
template <int D>
void list_field(StateArchive& archive, const std::string& name, const Grid<D>& grid, CellField<D>& field);
template <int D>
void list_field(StateArchive& archive, const std::string& name, const Grid<D>& grid, FaceField<D>& field);

} // namespace gapflow
