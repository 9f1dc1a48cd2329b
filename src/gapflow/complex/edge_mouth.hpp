// Mouths in space: where a gap ends at a sharp edge in front of another wall (gap-energy, "Mouths in 3D").
//
// In the section normal to the edge they are those of the plane (mouth.hpp). An edge has one dividing plane: near another wall it leads there.
#pragma once

#include "gapflow/complex/mouth_walls.hpp"

#include <span>
#include <vector>

namespace gapflow {

class EdgeMouths {
public:
    /// Leads the dividing planes of edges near other walls to these, and finds through which cells.
    EdgeMouths(const GridPlanes<3>& planes, std::span<const Solid<3>> solids, std::vector<PlacedSolid<3>>& placed);

    /// The mouths of a complex's links and of its pieces in whose planes edges and ways lie. Of edges that share their mouth with another one, the links' own
    /// part.
    void add_to(Complex<3>& complex) const;
    /// What of the flow around an edge, s along it, is its own and not a mouth's.
    double own(int image, int edge, double s) const;

private:
    /// A place of an edge.
    struct Place {
        OtherWall<3> wall;
        Vec<3> at, direction; ///< direction: normal to the edge
        double distance = 0;  ///< along it
        double turned = 0, share = 0, own = 1;
        bool mouth = false;
        bool lost = false;    ///< to an edge across the gap
        bool crossed = false; ///< to one that lies further in
    };
    Place place(int image, int edge, double s) const;
    int edge_at(int image, const Vec<3>& x) const;
    int edge_across(int image, const Place& place, const Vec<3>& along) const;
    Vec<3> bisector(int image, int edge) const;
    static double beyond(const Vec<3>& bisector, double angle, const Vec<3>& way);
    /// Whether another solid covers a place.
    bool covered(int image, const Vec<3>& x) const;
    void find_way(int image, int edge);
    void add_crossings(int image, int edge, std::vector<double>& at, std::vector<Place>& places) const;
    void add_way(int image, int edge, const std::vector<double>& at, const std::vector<Place>& places);
    void add_cells(SharpSolid& sharp, const EdgeWay& way) const;
    GapMouth<3> section(int image, int edge, const Place& place) const;
    void add_pieces(int image, const EdgeWay& way, Complex<3>& complex) const;

    const GridPlanes<3>& planes_;
    std::vector<PlacedSolid<3>>& placed_;
    const MouthWalls<3> walls_;
    std::vector<bool> convex_; ///< of the placed solids
    struct Way {
        int image, edge;
    };
    std::vector<Way> ways_;
    Vec<3> low_, high_; ///< of the planes
    bool sides_;
};

} // namespace gapflow
