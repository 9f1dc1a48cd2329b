// Energy bounds of the films in a time step: of their transport and of the heads at their mouths (method, "The time step").
#pragma once

#include "gapflow/film/film_motion.hpp"

#include <map>

namespace gapflow {

/// Energy that a pair's films lose in their transport, times two over the density, and the relative decrease of their mean thickness in the step.
struct GivenAwayOf {
    double energy = 0, closing = 0;
};
/// The same for each pair, by the pair's history.
template <int D>
using GivenAway = std::map<const FilmHistory<D>*, GivenAwayOf>;

/// Caps the kinetic energy of a pair's films, relative to their master, at its old value plus the inflow through the mouths (at most at the
/// speed of the mouths' own fluxes) and the share of elements where there was no film, by clipping the largest speeds of `velocity`.
/// Spurious sources (traces extrapolated beyond the ends, flux in a thinner gap, a mesh that changes) show as peak speeds; without the cap
/// they grow severalfold per step in a throat with fast flow. `history`: of each film's pair, or null;
/// `at_element`, `at_mouth`: the old films' velocities there. Returns the energy that the films lose, inflow included.
template <int D>
GivenAway<D>
limit_motion(const FilmNetwork<D>& network, std::span<const Solid<D>> solids, const std::vector<const FilmHistory<D>*>& history,
             const std::vector<typename FilmHistory<D>::Transported>& at_element,
             const std::vector<typename FilmHistory<D>::Transported>& at_mouth, double dt, std::vector<Vec<D>>& velocity);

/// Adds the outflow's kinetic head, 1/2 rho u^2 for dt over rho R, to the mouths' fluxes. The head transfers to the mouths the energy that
/// leaves the film with the fluid, so the mouths of a pair's films get at most the energy that the films lost in their transport:
///
///     2 theta sum R / l q dq <= 3 r / (1 - (1 - r) (1 - r + r^2/2)^2) given_away,   0 <= theta <= 1,   q relative to the master,
///
/// r the relative decrease of their thickness in the step: at the rate of its start 3 r of the energy leave, the denominator is the loss in
/// transport. Without the bound the mouth's flux becomes very large where a gap closes completely; a fixed factor of 1.3 injects energy
/// where a light body rolls over another's corner. `head`: dq of each mouth, 0 where it has none.
template <int D>
void add_heads(const FilmNetwork<D>& network, std::span<const Solid<D>> solids,
               const std::vector<const FilmHistory<D>*>& history, const GivenAway<D>& given_away,
               const std::vector<double>& head, std::vector<double>& flux);

} // namespace gapflow
