// Closest point on a set of facets (3D: triangles, 2D: segments), facets near each other and along a ray, by a tree of boxes.
#pragma once

#include "gapflow/core/types.hpp"

#include <array>
#include <functional>
#include <vector>

namespace gapflow {

template <int D>
struct Facet {
    std::array<Vec<D>, D> corner;
    Vec<D> normal;
};

/// Closest point of a facet and the part on which it lies: the facet's interior (ridge and vertex -1), in 3D the inside of the edge
/// without local vertex `ridge`, or the local vertex `vertex`.
template <int D>
struct FacetPoint {
    Vec<D> x;
    double distance2;
    int ridge = -1;
    int vertex = -1;

    bool interior() const { return ridge < 0 && vertex < 0; }
};

/// Exact to round-off: inside, the distance is that to the facet's plane, so it is good relative to itself.
template <int D>
FacetPoint<D> closest_on(const Facet<D>& facet, const Vec<D>& q);

/// Bounding volume hierarchy over facets (halves along the longest side of the facets' centres).
template <int D>
class FacetTree {
public:
    struct Hit {
        int facet = -1; ///< index in the list given
        FacetPoint<D> point;
    };

    /// At least one facet. Facets with group[i] give the subset of closest(q, group).
    FacetTree(const std::vector<Facet<D>>& facets, const std::vector<int>& group);

    /// Closest facet and its point; of one group if group >= 0 (then facet -1 if that has no facets). Thread-safe.
    Hit closest(const Vec<D>& q, int group = -1) const;

    /// Calls visit(f, g) once for each pair of different facets whose boxes come within `margin` on every axis, in no order that
    /// matters, until it returns false.
    void for_near_pairs(double margin, const std::function<bool(int, int)>& visit) const;

    /// Facets that the ray from `start` leaves through (along their normals) less those it enters through: of a closed outward
    /// surface the winding number around `start`, unless the ray meets a ridge. No component of `direction` may be 0.
    int crossings(const Vec<D>& start, const Vec<D>& direction) const;

    /// How far it is along a ray to the first facet that it meets against its normal; infinity: none. `direction`: of unit length. Facets
    /// are wider by `tolerance` all around, so that no ray slips between two that meet. Thread-safe.
    double entry(const Vec<D>& start, const Vec<D>& direction, double tolerance) const;

private:
    struct Node {
        Vec<D> low, high;
        int first = 0; ///< leaf: first facet in tree order; else the right child (the left one follows the node)
        int count = 0; ///< leaf: number of facets; else 0
    };

    void build(std::vector<int>& order, const std::vector<Facet<D>>& facets, int begin, int end);
    bool near(int node, int other, double margin) const;

    std::vector<Node> nodes_;
    std::vector<Facet<D>> facets_;             ///< in tree order
    std::vector<std::array<Vec<D>, 2>> boxes_; ///< of the facets: low and high corner
    std::vector<int> id_, group_;
};

} // namespace gapflow
