// The coupled system of a moment (method, "The time step", stage 4): fractions, films with their voids, cell kinds, mouths.
#pragma once

#include "gapflow/film/film_motion.hpp"
#include "gapflow/stepping/state.hpp"
#include "gapflow/stepping/step.hpp"

#include <memory>
#include <optional>

namespace gapflow {

/// Data of the old configuration that a step needs after its release: two configurations at a time would determine the peak
/// memory of a step.
template <int D>
struct LeftBehind {
    std::shared_ptr<const FaceFractions<D>> fractions;
    std::set<FilmPair<D>> films; ///< pairs that had some
};
template <int D>
LeftBehind<D> leave(std::optional<Coupling<D>>& here);

/// Of the state's bodies, with masses `mass` and the state's `films_before`. Voids of the state are taken over to the new films
/// along `histories`, or the scene's initial ones (null). `dt`: length of the step. `before`: as in couple(). Collective.
template <int D>
Coupling<D> configure(const Model<D>& model, State<D>& state, const std::vector<TwistMatrix<D>>& mass,
                      const FilmHistories<D>* histories, const std::vector<Twist<D>>& twists, double dt, StageTimers& timers,
                      const FaceFractions<D>* before = nullptr);

/// The next step's, after its bodies have moved. `report`: gets a note where voids are lost.
template <int D>
Coupling<D> configure(const Model<D>& model, State<D>& state, const std::vector<TwistMatrix<D>>& mass,
                      const FilmHistories<D>& histories, const FaceFractions<D>& before, const Step& step, StepReport& report,
                      StageTimers& timers);

/// That of a state from a checkpoint: with its voids and the mouths that its last step shut. Throws StateError where the
/// state's films are others. Collective.
template <int D>
Coupling<D> configure_stored(const Model<D>& model, const State<D>& state, StageTimers& timers);

} // namespace gapflow
