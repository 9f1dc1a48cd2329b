// Films whose gap changes in a step (method, "Drag over a step"). On its way from h0 to h1 at constant speed the film resists with the mean
// over the way of the resistance's power of h,
//
//     mean h^-3 = (h0 + h1) / (2 h0^2 h1^2),     mean h^-2 = 1 / (h0 h1),     mean h^-1 = ln(h0 / h1) / (h0 - h1).
//
// For a body of mass m that the film alone slows down, m dv = -k(h) v dt = -k(h) dh: the impulse depends on the way alone, whatever the factor.
#pragma once

#include "gapflow/coupling/coupling.hpp"

#include <span>
#include <vector>

namespace gapflow {

/// Means over an element's way to its present thickness, over the value there: of h^-3 (a flux's resistance) and of h^-1 (shear). `opened`:
/// how much the gap has opened on the way; negative: closed.
template <int D>
double cubic_mean(const FilmMesh<D>& mesh, const FilmElement<D>& e, double opened);
template <int D>
double linear_mean(const FilmMesh<D>& mesh, const FilmElement<D>& e, double opened);
/// The same of h^-2, of a mouth.
double square_mean(double h, double opened);

/// By how much drag on a long way must be larger for an implicit step to take what it takes in truth: (e^X - 1) / X, so that 1 / (1 + X) becomes e^-X.
/// `share`: X.
double steepened(double share);

/// What drag a film has in a step in which it takes the share X of its bodies' relative velocity. `h`, `opened`: of the film's thinnest place;
/// `change`: of the gap, over the one that counts as large.
DragParts drag_parts(double share, double change, double h, double opened);

/// How a pair's gap changes on the way ahead.
template <int D>
struct WayAhead {
    std::vector<std::vector<double>> opened; ///< of each film of the pair, of each of its elements
    double viscosity_dt = 0;                 ///< viscosity times the time that the way takes
    double floor = 0;                        ///< least thickness
};

/// Of each film the links, by number, that its nodes have a part in.
template <int D>
std::vector<std::vector<int>> links_of_films(const Coupling<D>& coupling);

/// Impulses on master and other by which the films of a pair change a motion on a way.
template <int D>
struct WayImpulses {
    std::array<Twist<D>, 2> inertia{Twist<D>::Zero(),
                                    Twist<D>::Zero()}; ///< by the change of their inertia, which counts with its magnitude
    std::array<Twist<D>, 2> all = inertia;             ///< by viscosity as well
};

/// Of the motion V. The grid's pressure is taken as fixed. `films`: numbers in the network, all of one pair; `links`: links_of_films(); `way`: one
/// element list for each film of the pair. Empty where a film has no way out.
template <int D>
std::optional<WayImpulses<D>> impulses_on_way(const Coupling<D>& coupling, std::span<const int> films,
                                              std::span<const std::vector<int>> links, const WayAhead<D>& way,
                                              const std::array<Twist<D>, 2>& V);

} // namespace gapflow
