// The step's limit by the gaps (method, "The time step", stage 1). A gap changes by a part of its thickness at most, `time.gap_cfl`; or by any
// factor, where its films take only a small share of the bodies' relative velocity on the way (coupling/film_way).
#pragma once

#include "gapflow/coupling/film_way.hpp"
#include "gapflow/stepping/state.hpp"

#include <limits>
#include <map>
#include <vector>

namespace gapflow {

template <int D>
class GapLimit {
public:
    /// Before a step from `state` with the coupled system `here`; V, A: twists and accelerations of all solids; `flow_speed`: the flow's largest
    /// speed. All but that must outlive this object. Throws ComputationError where prescribed bodies have met and continue to approach.
    GapLimit(const Model<D>& model, const State<D>& state, const Coupling<D>& here, const std::vector<Twist<D>>& V,
             const std::vector<Twist<D>>& A, double flow_speed);

    /// The step size dt, or a smaller one that the gaps ask for.
    double limited(double dt) const;
    /// How gaps change in a step of length dt, for their films' drag.
    GapWays<D> ways(double dt) const;

private:
    struct Pair {
        std::vector<int> films;                                   ///< their numbers
        double by_part = std::numeric_limits<double>::infinity(); ///< step in which the gap changes by the allowed part
        bool has_mean = true;                                     ///< whether its drag may have a mean over the way
        bool here = true;                                         ///< Film::here of its films
        bool any_factor = true;                                   ///< whether it may change by more
    };
    /// What a pair is expected to do in a step.
    struct Way {
        bool passes = false;       ///< the surfaces pass each other too far
        bool elastic = false;      ///< they rebound where they meet
        bool rebound = false;      ///< they meet, or will soon, and rebound
        std::array<Twist<D>, 2> W; ///< mean twists of master and other on the way
        WayAhead<D> films;
    };
    /// What films take of their bodies' velocities.
    struct Taken {
        double share;                   ///< of the relative velocity: |F|^2 / (W.F), in the metric of the bodies' mobility
        std::array<Twist<D>, 2> change; ///< of the twists of master and other
    };
    void add(int number, const Film<D>& film);
    Way way_ahead(const FilmPair<D>& pair, const Pair& films, double dt) const;
    Taken taken(const FilmPair<D>& pair, const Way& way, const std::array<Twist<D>, 2>& impulses, double dt) const;
    double largest_change(const Pair& films, const std::array<Twist<D>, 2>& change) const;
    bool admits(const FilmPair<D>& pair, const Pair& films, double dt) const;
    double limited_by(const FilmPair<D>& pair, const Pair& films, double dt) const;

    const Model<D>& model_;
    const State<D>& state_;
    const Coupling<D>& here_;
    const std::vector<Twist<D>>&V_, &A_;
    double flow_speed_;
    std::vector<std::vector<int>> links_; ///< of each film
    std::map<FilmPair<D>, Pair> pairs_;
};

/// Of the films and mouths of the state's gap ways, once its bodies have moved: how much the gap has opened over the step.
template <int D>
GapChanges gap_changes(const Model<D>& model, const Coupling<D>& there, const State<D>& state);

} // namespace gapflow
