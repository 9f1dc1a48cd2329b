// Notes for the user about films and enclosed fluid.
#pragma once

#include "gapflow/coupling/coupling.hpp"
#include "gapflow/scene/scene.hpp"

#include <set>
#include <string>
#include <vector>

namespace gapflow {

/// "(0.5, 1.25)"
std::string place_text(const std::vector<double>& x);
template <int D>
std::string place_text(const Vec<D>& x)
{
    return place_text(std::vector<double>(x.data(), x.data() + D));
}

/// Description of enclosed fluid: its place, the bodies around it, the consequence.
std::string sealed_text(const SealedPocket& pocket);

/// Pairs whose films have blind ends, with a place and a remedy, one text per pair for the first five. Pairs in `told` are left out, the
/// others added to it.
template <int D>
std::vector<std::string> blind_end_notes(const Coupling<D>& coupling, std::set<FilmPair<D>>& told);

/// Pairs that are apart, but by less than the roughness that they have by default: their films count as thicker than they are. One text a pair,
/// with the remedy, for the three closest; one more counts the others.
template <int D>
std::vector<std::string> rough_gap_notes(const Scene& scene, const Coupling<D>& coupling);

/// Pairs that stand still and come closer than the roughness: they are one solid there, and nothing leaks through, which in a closed valve is
/// seldom meant. One text a pair, with the remedy.
template <int D>
std::vector<std::string> closed_gap_notes(const Scene& scene, const Coupling<D>& coupling);

/// After a step in viscous fluid, where half of all differences of pressure or more falls across one gap: pairs whose film there is shorter than
/// three of its thicknesses, between sharp edges or from one on, and the pair whose gap is narrower than a cell but has no film. What flows through
/// such gaps is not known well. The same text a pair for all steps of a scene, for at most three pairs. `pressure` to any scale. Collective.
template <int D>
std::vector<std::string> short_film_notes(const Scene& scene, const Coupling<D>& coupling, const UnknownVector<D>& pressure);

} // namespace gapflow
