// Into which cells a mouth's walls carry its fluid (method, "Films of viscous fluid").
#pragma once

#include "gapflow/film/conduits.hpp"

#include <span>
#include <vector>

namespace gapflow {

/// A face that a film closes, as a cell beside the film sees it.
template <int D>
struct ClosedArea {
    long key;    ///< of the cell
    Vec<D> x;    ///< centroid of its open part, in the film's frame
    Vec<D> area; ///< normal times open area, out of the cell
};

/// Of what the master carries out of a mouth the cell gets weight + lean, of what the other wall does weight - lean. Weights sum to 1, leans to 0.
struct CarriedCell {
    long key;
    double weight, lean;
};

/// The cells behind the faces that the film closes at a smooth mouth, each face by its area across the film and by the share that either wall has of
/// linear flow there. Empty where other films close most of the mouth. `places`: of all of the film's mouths, which share the faces out by distance.
template <int D>
std::vector<CarriedCell> cells_behind(const Conduit<D>& conduit, const Film<D>& film, std::span<const ClosedArea<D>> closed,
                                      std::span<const Vec<D>> places, double dx);

/// The cells of the mouth's pressure. What a wall carries out of a smooth mouth thicker than two cells falls linearly towards the other wall.
template <int D>
std::vector<CarriedCell> cells_around(const Grid<D>& grid, const Conduit<D>& conduit, const Film<D>& film);

} // namespace gapflow
