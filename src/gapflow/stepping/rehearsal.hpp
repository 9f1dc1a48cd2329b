// The first step's expectations (method, "The time step"). A step extrapolates what the step before found; the first one has none before it.
// So it is made beforehand, from a copy of the state: what that finds is what the first step expects.
#pragma once

#include "gapflow/stepping/state.hpp"

#include <utility>
#include <vector>

namespace gapflow {

/// Whether the first step expects anything: accelerations of bodies or films, or the pressure of viscous fluid.
template <int D>
bool rehearses(const Model<D>& model, const Coupling<D>& here);

/// Elements of each film, in order: films whose elements correspond have the same list.
template <int D>
std::vector<std::pair<FilmPair<D>, std::size_t>> elements_of_films(const Coupling<D>& coupling);

/// The state `start` expects the accelerations and, in viscous fluid, the pressure and its forces that a step from it to `after` found.
/// `same_films`: their films' elements correspond.
template <int D>
void expect(State<D>& start, State<D>&& after, bool same_films);

} // namespace gapflow
