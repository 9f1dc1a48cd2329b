// Pieces of faces in gaps.
#pragma once

#include "gapflow/complex/gap_way.hpp"

#include <functional>

namespace gapflow {

/// Place of a piece of a face in a gap.
template <int D, class Walls>
struct GapPlace {
    using S = typename Walls::Scalar;
    using Place = PlaceOf<D, S>;

    FacingWalls<D, Walls> walls;
    Place n;                   ///< from the first wall to the second one
    GapProfile<D, Walls> here; ///< at the piece's centroid
    S facing;                  ///< cosine of the angle between the walls there
    // The way from node to node is centroid + s way, end[0] <= s <= end[1].
    double delta = 1; ///< distance of the nodes along the face's axis
    Place e = Place::Constant(S(0.0)), way = Place::Constant(S(0.0));
    S middle = S(0.0);                     ///< of the way that ends where n leads to the nodes
    std::array<S, 2> end{};                ///< with `moved`
    Place nodes = Place::Constant(S(0.0)); ///< the middle between the two
    std::array<S, 2> moved{};              ///< of its two ends: nodes that mouths move
    // 3D: the piece lies around centroid + s line, from <= s <= to or the other way round.
    Place line = Place::Constant(S(0.0));
    S from = S(0.0), to = S(0.0);

    bool along_face() const { return !(value_of(S(way.squaredNorm())) > parameters.parallel * parameters.parallel); }
};

/// A piece of a face in a gap.
template <int D>
struct GapSite : GapPlace<D, StillWalls<D>> {
    std::int32_t piece;
    std::array<std::int32_t, 2> solid;
    std::array<bool, 2> still; ///< closed sides of the domain: they never move
    std::array<bool, 2> round; ///< balls that turn about their centres: that moves nothing
    Standoff<D> standoff;
};

/// Of all pieces of the complex that lie in gaps, in their order.
template <int D>
void for_each_gap(const Grid<D>& grid, std::span<const Solid<D>> solids, const Complex<D>& complex,
                  const Standoffs<D>& standoffs, const std::function<void(const GapSite<D>&)>& visit);

} // namespace gapflow
