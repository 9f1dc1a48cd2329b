// Plates that nothing but their film stops (method, "The time step"). Without losses (m + M) times the square of their speed stays, M ~ 1 / gap, so
//
//     gap = b (t - t_0)^2:
//
// they come to rest at gap 0 with a speed in the film that grows without bound, and part again as they came. A film that has become so thin
// that it limits the step no more passes what is left of that at once: its flow is turned round.
#pragma once

#include "gapflow/coupling/coupling.hpp"
#include "gapflow/film/film_motion.hpp"

#include <functional>
#include <set>
#include <vector>

namespace gapflow {

/// In dx: thinner gaps limit the step no more than this one.
inline constexpr double smallest_limiting_gap = 1e-4;

/// Pairs whose flat film is thinner than that (but not in contact), gives back at its mouths what it takes up, and is about to stop what closes
/// it, as `twists` and the `acceleration` of all solids tell.
template <int D>
std::set<FilmPair<D>>
turning_films(const Coupling<D>& coupling, const std::vector<Twist<D>>& twists, const std::vector<Twist<D>>& acceleration,
              const std::function<GapSettings(int, int)>& settings, const std::function<MouthLaw(int, int)>& law);

/// Turns the flow of these pairs' films round, as seen from their walls.
template <int D>
void turn_films(const FilmNetwork<D>& network, std::span<const Solid<D>> solids, const FilmMemories<D>& memories,
                const std::set<FilmPair<D>>& turning, const std::vector<Twist<D>>& twists, FilmFlow<D>& flow);

} // namespace gapflow
