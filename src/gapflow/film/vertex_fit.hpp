// Vertex values of a field that is known by its means over the elements of a surface mesh.
#pragma once

#include "gapflow/core/types.hpp"

#include <array>
#include <span>
#include <vector>

namespace gapflow {

/// Elements around each vertex: those of vertex i are element[first[i]] ... element[first[i + 1] - 1].
struct VertexRings {
    std::vector<int> first, element;
};
template <int D>
VertexRings vertex_rings(std::size_t vertices, std::span<const std::array<int, D>> elements);

/// A vertex's value is the sum of share times value over some elements.
struct VertexFit {
    std::vector<int> first, element;
    std::vector<double> share;

    template <class Value>
    Value at(int vertex, const std::vector<Value>& of_elements, Value sum) const
    {
        for (int k = first[vertex]; k < first[vertex + 1]; ++k)
            sum += share[k] * of_elements[element[k]];
        return sum;
    }
};

/// Linear least-squares fit a + b . t to the elements around each vertex (two rings where one is too few), t from the vertex in
/// the tangent plane; exact for linear fields on flat meshes. `weight`: of elements in the fit; vertices around which all are 0 have an empty
/// list. `normal`: unit.
template <int D>
VertexFit vertex_fit(std::span<const Vec<D>> vertices, std::span<const std::array<int, D>> elements,
                     std::span<const Vec<D>> centroid, std::span<const Vec<D>> normal, std::span<const double> weight);

} // namespace gapflow
