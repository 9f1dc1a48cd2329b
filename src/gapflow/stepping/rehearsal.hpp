// What the first step expects (method, "The time step", stage 3). Each step extrapolates what the step before found, and the first one has none
// before it: so a step is made from a copy of the state at the start, and of its result only what the first step extrapolates is kept.
#pragma once

#include "gapflow/stepping/state.hpp"

#include <utility>
#include <vector>

namespace gapflow {

/// Whether the first step extrapolates anything: accelerations of bodies or films, or the pressure.
template <int D>
bool expects_anything(const Model<D>& model, const Coupling<D>& here);

/// What a step found that the next one extrapolates.
template <int D>
struct Expectations {
    std::vector<Twist<D>> acceleration;                     ///< of all solids
    std::vector<std::pair<Vec<D>, Spin<D>>> rates;          ///< of every body: acceleration, rate of its angular momentum
    PastPressure<D> pressure;                               ///< of the bulk, where the bodies start from; none after an impact
    std::vector<Twist<D>> force;                            ///< the same on every body, in viscous fluid
    std::vector<Vec<D>> film_increment;                     ///< of the elements of `films`
    std::vector<std::pair<FilmPair<D>, std::size_t>> films; ///< pair and number of elements of each film, in order
};

/// Those after a step, in the configuration `there` to which it led. `after` is invalid then. Collective.
template <int D>
Expectations<D> expectations(const Model<D>& model, State<D>& after, const Coupling<D>& there);

/// Puts them into another state, of the configuration `here`: the films' only where all films have the same elements.
template <int D>
void expect(Expectations<D> found, const Coupling<D>& here, State<D>& state);

} // namespace gapflow
