// Reversal of films that alone stop their plates (method, "The time step"). Without losses (m + M) times the square of their
// speed stays, M ~ 1 / gap, so
//
//     gap = b (t - t_0)^2:
//
// they come to rest at gap 0 with a speed in the film that grows without bound, and then separate symmetrically in time. A film
// that is so thin that it does not limit the step is reversed within one step: its flow changes sign.
#pragma once

#include "gapflow/coupling/coupling.hpp"
#include "gapflow/film/film_momentum.hpp"

#include <functional>
#include <set>
#include <vector>

namespace gapflow {

/// In dx: thinner gaps limit the step no more than this one.
inline constexpr double smallest_limiting_gap = 1e-4;

/// Pairs whose flat film is thinner than that (but not in contact), has reversible mouths, and is about to stop the motion that
/// closes it, by the `twists` and `acceleration` of all solids.
template <int D>
std::set<FilmPair<D>>
reversing_films(const Coupling<D>& coupling, const std::vector<Twist<D>>& twists, const std::vector<Twist<D>>& acceleration,
                const std::function<GapSettings(int, int)>& settings, const std::function<MouthLaw(int, int)>& law);

/// Reverses the flow of these pairs' films relative to their walls.
template <int D>
void reverse_films(const FilmNetwork<D>& network, std::span<const Solid<D>> solids, const std::set<FilmPair<D>>& reversing,
                   const std::vector<Twist<D>>& twists, FilmFlow<D>& flow);

} // namespace gapflow
