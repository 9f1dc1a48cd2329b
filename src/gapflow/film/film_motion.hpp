// The films' velocities from step to step (method, "Film transport").
//
// An element's velocity is w = u + V_n n in world axes (u tangential, V_n the normal speed of the mid-gap surface).
#pragma once

#include "gapflow/film/film_history.hpp"
#include "gapflow/film/mouths.hpp"

#include <map>
#include <memory>
#include <vector>

namespace gapflow {

/// The films' velocities after the last step, by pair.
template <int D>
using FilmHistories = std::map<FilmPair<D>, std::shared_ptr<const FilmHistory<D>>>;

/// Stores the films' velocities after a step. `u`: tangential velocities of elements; `mouth`: fluxes; `twists`: V^{n+1}; `idle`, `acceleration`: as in
/// FilmHistory.
template <int D>
FilmHistories<D> remember_films(const FilmNetwork<D>& network, std::span<const Solid<D>> solids,
                                const std::vector<Twist<D>>& twists, const std::vector<Vec<D>>& u,
                                const std::vector<double>& mouth, double dx, const std::vector<char>& idle = {},
                                const std::vector<Vec<D>>& acceleration = {}, const std::vector<Vec<D>>& increment = {});

/// Speed normal to the gap of an element's fluid: row . twist, master's and other's together. Between parallel walls it is the mean of
/// their velocities at mid-gap, n . 1/2 (U_A + U_B). Else the other contributes its speed along its own normal, over twice the cosine between
/// that and n (a ball that turns about its centre contributes 0), and the master the remainder, such that a common motion gives n . U.
template <int D>
struct NormalRows {
    Twist<D> master, other;
};
template <int D>
NormalRows<D> normal_rows(const FilmMesh<D>& mesh, const FilmElement<D>& element, std::span<const Solid<D>> solids);

/// That speed, one for each element.
template <int D>
std::vector<double> wall_normal_speed(const FilmNetwork<D>& network, std::span<const Solid<D>> solids,
                                      const std::vector<Twist<D>>& twists);

} // namespace gapflow
