// Which pieces of a cell's hull belong together because one wall inside the cell joins them (theory, "Cells, faces, parts").
#pragma once

#include "gapflow/complex/cut_faces.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace gapflow {

/// Facets of meshes with a vertex in a cell; sorted by cells.
class FacetsInCells {
public:
    struct Entry {
        std::int32_t cell; ///< in DenseIndex
        std::int32_t image, facet;
        std::uint8_t corners; ///< which of the facet's vertices lie in the cell
    };

    FacetsInCells(const GridPlanes<3>& planes, const DenseIndex<3>& index, const std::vector<PlacedSolid<3>>& solids);
    std::span<const Entry> of(std::int32_t cell) const;

private:
    std::vector<Entry> entries_;
};

/// A facet on a piece's border.
struct BorderFacet {
    std::int32_t image, facet, piece;
};

/// Two pieces that belong together.
struct PiecePair {
    int a, b;
};

/// Finds the pieces that border on one connected wall of a mesh in the cell. A facet's part in a cell is convex. Two facets meet there if they follow each other on a
/// face's border, or if they share an edge with an end in the cell: an edge without one leaves through two faces.
class FacetJoins {
public:
    /// @param borders  facets of all arcs of the hull
    /// @param inside   FacetsInCells::of the cell
    const std::vector<PiecePair>& find(const std::vector<PlacedSolid<3>>& solids, std::span<const BorderFacet> borders,
                                       std::span<const FacetsInCells::Entry> inside);

private:
    struct Node {
        std::int32_t solid, facet;
        auto operator<=>(const Node&) const = default;
    };
    int node(const Node& key) const;
    int root(int k);

    std::vector<Node> nodes_;
    std::vector<int> up_, piece_;
    std::vector<PiecePair> pairs_;
};

/// A hole whose sharp rim lies inside a cell.
struct HoleInCell {
    double area;
    double margin;          ///< how far the rim is from the nearest side of the cell
    Vec<3> nearest, inward; ///< its point there, and the side's normal into the cell
    int image = -1;

    double radius() const; ///< of a circle of the same area
    /// That of a circular hole in a thin wall, 2 radii, less the resistance that the grid's own network has between the nodes on both sides of the
    /// wall and infinity (their cells: a node and its image at each side). Infinite where the rim reaches a side: there the hole joins pieces of the hull.
    double conductance() const;
};

/// The narrowest closed rim of sharp edges in a cell.
std::optional<HoleInCell> sharp_hole(const SharpSolid& solid, const Index<3>& cell, const Vec<3>& low, const Vec<3>& high);

/// Whether the straight way from a to b, both in the fluid, is free of these solids.
bool in_sight(const GridPlanes<3>& planes, const std::vector<PlacedSolid<3>>& solids, std::span<const int> images,
              const Vec<3>& a, const Vec<3>& b);

} // namespace gapflow
