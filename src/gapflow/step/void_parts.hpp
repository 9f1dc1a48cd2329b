// Parts of gaps that can hold a void (theory of the step, "Voids").
//
// A part all of whose open faces are those of a gap, between two solids whose pair is dry or cavitates, is one in which the pressure may fall to the least
// one. A part that is a void at a step's start has no energy: what leads to it, its edges, is no part of L, and its walls displace no fluid.
#pragma once

#include "gapflow/complex/inertia.hpp"
#include "gapflow/coupling/coupling.hpp"
#include "gapflow/stepping/model.hpp"
#include "gapflow/stepping/void_set.hpp"

#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace gapflow {

// A void that a gap had before it became too thick to be one stays where it is, in parts and whole cells. All these are sites: numbers of the complex's parts,
// and after them of its cells.

template <int D>
std::int32_t site_of(const Complex<D>& complex, const PartOrCell& side)
{
    return side.is_part() ? side.number() : complex.parts() + side.number();
}
template <int D>
PartOrCell side_of(const Complex<D>& complex, std::int32_t site)
{
    return site < complex.parts() ? PartOrCell::part(site) : PartOrCell::cell(site - complex.parts());
}
template <int D>
std::size_t count_sites(const Complex<D>& complex)
{
    return complex.parts() + complex.index.count;
}

/// Voids at the end of a step.
struct PartVoids {
    std::vector<double> volume; ///< of each site of the complex; empty: none is possible
    std::vector<double> drop;   ///< of the potential along each edge of these voids: its flux over its conductance
    std::vector<double> beyond; ///< site and two solids of each of them that is no part of a gap
    double lost = 0;            ///< volume of those whose place is gone, over the run

    bool is_void(int site) const { return !volume.empty() && volume[site] > 0; }
};

template <int D>
struct VoidPart {
    std::int32_t part;     ///< site
    int a, b;              ///< solids
    double thickness;      ///< of the gap
    double held;           ///< distance at which a dry pair is held; else 0, and beyond gaps
    double area;           ///< of the walls across the gap
    double room;           ///< volume without fluid
    bool in_gap;           ///< else beyond gaps
    double least_pressure; ///< reduced
    Vec<D> place;
    long row = -1; ///< as in FluidRows
};

/// A face, link or mouth that leads to a void: its flux is conductance times the sum of w p, of which w leaves each row.
template <int D>
struct VoidEdge {
    double conductance; ///< of a full gap
    double permeable;   ///< the share of the gap's thickness in which fluid flows
    double area;        ///< of the full gap
    std::vector<std::pair<long, double>> rows;
    std::vector<std::int32_t> sites; ///< of each row
    std::int32_t piece, mouth;       ///< of the complex, and number in Voids::mouths; -1: none
    long face = -1;                  ///< of the grid where it is neither: its key times D, and its axis
    std::int32_t edge = -1;          ///< of Placed::edges, where there is circulation: without conductance there
    double fluid = 1;                ///< share of the way that streams fill, with viscosity

    double open() const { return fluid * permeable * conductance; }
};

template <int D>
struct Voids {
    std::vector<VoidPart<D>> parts;   ///< by their parts
    std::vector<double> volume;       ///< at the step's start, of all sites of the complex; empty: none
    std::vector<VoidEdge<D>> edges;   ///< of the voids at the step's start
    std::vector<std::int32_t> lost;   ///< voids whose place is gone: their sites in the complex before
    std::vector<GapArm<D>> arms;      ///< as without voids
    std::vector<MouthArm<D>> mouths;  ///< as without voids
    std::unique_ptr<Coupling<D>> all; ///< the system with the bodies' own masses; the edges are its last links

    /// Of a site of the complex; null: it can hold none.
    const VoidPart<D>* find(std::int32_t site) const;
    bool is_void(std::int32_t site) const { return !volume.empty() && volume[site] > 0; }
    bool any() const;
};

/// Voids that bodies take along to another place.
template <int D>
struct VoidsBefore {
    const PartVoids& voids;
    const Complex<D>& complex;
    const Voids<D>& at; ///< places of the parts there
};

/// Whether fluid can pass a piece of a face.
template <int D>
bool is_way_out(const Grid<D>& grid, const FacePiece<D>& piece)
{
    return piece.area > 0 &&
           ((piece.low.exists() && piece.high.exists()) || is_open(grid.side(piece.axis, piece.low.exists())));
}

/// Whether some pair of the scene can have voids.
bool voids_are_possible(const Scene& scene);

/// Throws InputError on several ranks, and for a fluid with a velocity of its own.
template <int D>
void require_for_voids(const Model<D>& model, bool circulation);

/// Of a complex with these arms and mouths, which they keep. With what is taken along from `before`, if not null.
template <int D>
Voids<D> find_voids(const Model<D>& model, const std::vector<Solid<D>>& solids, const Complex<D>& complex,
                    std::vector<GapArm<D>> arms, std::vector<MouthArm<D>> mouths, const VoidsBefore<D>* before);

/// Middle of the open faces of each part, in the world.
template <int D>
std::vector<Vec<D>> places_of_parts(const Grid<D>& grid, const Complex<D>& complex);

/// Site that each part of the complex was at another place of the bodies; -1: none.
template <int D>
std::vector<std::int32_t> sites_before(const Grid<D>& grid, const Complex<D>& complex, const Complex<D>& before);

/// Takes voids along: fills volumes and what is lost, and adds their sites beyond gaps.
template <int D>
void take_along(const Model<D>& model, const std::vector<Solid<D>>& solids, const Complex<D>& complex,
                const VoidsBefore<D>& before, Voids<D>& voids);

/// Adds sites beyond gaps, as in PartVoids::beyond.
template <int D>
void add_beyond(const Model<D>& model, const std::vector<Solid<D>>& solids, const Complex<D>& complex,
                const std::vector<double>& beyond, Voids<D>& voids);
/// What PartVoids::beyond is.
template <int D>
std::vector<double> beyond_gaps(const Voids<D>& voids);

/// Those that a scene starts with: where a dry pair is no further apart than it is held.
template <int D>
PartVoids starting_voids(const Grid<D>& grid, const Complex<D>& complex, const Voids<D>& voids);

/// Arms and mouths of voids carry nothing that walls displace.
template <int D>
void leave_empty(const Complex<D>& complex, const Voids<D>& voids, std::vector<GapArm<D>>& arms,
                 std::vector<MouthArm<D>>& mouths);
/// After their inertia is known: the arms have no energy.
template <int D>
void shut_empty(const Complex<D>& complex, const Voids<D>& voids, std::vector<GapArm<D>>& arms);

/// Takes the voids' edges out of the system of all parts, which has the bodies' own masses: fills `voids.edges`, the parts' rows and `voids.all`.
template <int D>
void separate(const Complex<D>& complex, const Inertia<D>& inertia, Voids<D>& voids, Coupling<D>& coupling);

/// Rows at given values. Their edges are grounds of the rows beside, and the flux that the values drive out of these rows is added to `outflow`;
/// without it their edges are gone. K loses the rows where `outflow` is given.
template <int D>
void take_rows_out(Coupling<D>& coupling, const std::map<long, double>& given, UnknownVector<D>* outflow);

} // namespace gapflow
