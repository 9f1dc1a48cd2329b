// Where films exchange fluid: mouths to the grid, joints between films (method, "Mouths and joints").
#pragma once

#include "gapflow/film/film_cells.hpp"

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace gapflow {

enum class MouthKind {
    edge_edge, ///< sharp edges of both bodies: a slot between two right angles
    edge_face, ///< a sharp edge of one, the other continues: half of that slot by symmetry
    smooth,    ///< h reaches h_c between smooth surfaces
    open_side, ///< the film ends on an open side of the domain, or so close to it that its mouth lies beyond
    inflow     ///< the film ends on an inflow side
};

/// A point of a film's rim that joins the film to the grid's pressure:
/// rho R dq/dt = length * (p_film - p_bulk), q the flux out of the film.
template <int D>
struct Mouth {
    int film;
    MouthKind kind;
    std::array<int, D - 1> nodes;               ///< numbers among all film nodes
    int element;                                ///< of its film, at whose edge it lies
    std::array<double, D - 1> shape;            ///< shape functions of these nodes at x
    Vec<D> x, outward;                          ///< at mid-gap; unit, in the film's tangent plane
    Vec<D> section;                             ///< area vector of the gap at x over the length, out of the film
    double length, h, resistance;               ///< share of the rim (2D: 1), thickness, R
    std::vector<std::pair<long, double>> cells; ///< Grid::key, weight; sum 1. Empty on open and inflow sides
    int side = -1;                              ///< of the domain (2 axis + end) that an open or inflow mouth leads through

    /// Calls f with all of its fields.
    template <class F>
    void each_field(F&& f)
    {
        f(film, kind, nodes, element, shape, x, outward, section, length, h, resistance, cells, side);
    }
};

/// Ties the pressures of two films where they meet.
template <int D>
struct Joint {
    std::array<int, D - 1> nodes_a, nodes_b;
    std::array<double, D - 1> shape_a, shape_b;
    double conductance; ///< at fluid density 1
};

/// A part of a film's rim with neither mouth nor joint.
template <int D>
struct BlindEnd {
    int film;
    Vec<D> x;      ///< a point of it
    double length; ///< of rim (2D: number of ends)
};

template <int D>
struct RimLinks {
    std::vector<Mouth<D>> mouths; ///< in the order of their films
    std::vector<Joint<D>> joints;
    double closed_length = 0;       ///< of rim that ends against a wall or a third body (2D: number of ends)
    double blind_length = 0;        ///< of rim with neither mouth nor joint
    std::vector<BlindEnd<D>> blind; ///< one for each film that has some
};

/// Resistance R of a mouth of thickness h.
double mouth_resistance(MouthKind kind, double h, double dx);

/// Films with their cells, closed faces and mouths: everything that the coupling needs of them.
template <int D>
struct FilmNetwork {
    std::vector<Film<D>> films;
    FilmCells<D> cells;
    RimLinks<D> rim;
    std::shared_ptr<const FaceCache<D>> faces;
    int nodes = 0, elements = 0;
    Communicator ranks = Communicator(MPI_COMM_SELF); ///< that know it; each film is `here` on one of them
};

/// Finds films, classifies cells, closes faces, finds mouths, absorbs pockets, until nothing changes. A film without any film
/// cell is dropped (it would only duplicate the open faces beside it). Collective: each rank does what lies in its block, and all ranks get all.
template <int D>
FilmNetwork<D> build_film_network(const Grid<D>& grid, std::span<const Solid<D>> solids, const FaceClipper<D>& clipper,
                                  const FaceFractions<D>& fractions, const std::function<GapSettings(int, int)>& settings,
                                  const std::set<FilmPair<D>>& alive);

} // namespace gapflow
