// Points along the films' rims, each with its share of the rim (method, "Mouths and joints").
#pragma once

#include "gapflow/film/film_set.hpp"

#include <array>
#include <span>
#include <vector>

namespace gapflow {

template <int D>
struct RimPoint {
    int film;
    const RimEdge<D>* edge;          ///< of the film's mesh, which must last
    std::array<double, D - 1> shape; ///< shape functions of the edge's nodes at x
    Vec<D> x;                        ///< at mid-gap
    double length, h;                ///< share of the rim (2D: 1), thickness
};

/// Numbers of a film's nodes among all films' nodes.
template <int D>
std::array<int, D - 1> global_nodes(const Film<D>& film, const std::array<int, D - 1>& nodes)
{
    std::array<int, D - 1> result = nodes;
    for (int& n : result)
        n += film.first_node;
    return result;
}

/// 2D: the films' ends.
template <int D>
std::vector<RimPoint<D>> rim_points(std::span<const Film<D>> films, double dx);

} // namespace gapflow
