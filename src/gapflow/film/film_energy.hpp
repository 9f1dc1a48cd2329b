// What bounds the energy of films on their way through a time step: their transport and the heads of their mouths (method, "The time step").
#pragma once

#include "gapflow/film/film_motion.hpp"

#include <map>

namespace gapflow {

/// What a pair's films gave away: twice the energy over the density, and the part of their mean thickness that the step took from them.
struct GivenAwayOf {
    double energy = 0, closing = 0;
};
/// The same by the memory of the pair.
template <int D>
using GivenAway = std::map<const FilmMemory<D>*, GivenAwayOf>;

/// Transport adds next to no energy to the motion of a pair's film along its master, but what flows in through its mouths (no faster than
/// these let it in, and in the film with their flux) and what comes with elements where no film was: cuts the largest speeds of
/// `velocity` down to that. What else would add energy (traces extrapolated beyond the ends, flux over a thinner gap, a mesh that changes) grows several times a step in a throat
/// that is swept fast, and is fastest where it is wrong. `memory`: of each film's pair, or null;
/// `at_element`, `at_conduit`: what the old films carried there. Returns what the films gave away, inflow counted.
template <int D>
GivenAway<D>
limit_motion(const FilmNetwork<D>& network, std::span<const Solid<D>> solids, const std::vector<const FilmMemory<D>*>& memory,
             const std::vector<typename FilmMemory<D>::Transported>& at_element,
             const std::vector<typename FilmMemory<D>::Transported>& at_conduit, double dt, std::vector<Vec<D>>& velocity);

/// Adds the outflow's kinetic head, 1/2 rho u^2 for dt over rho R, to the mouths' fluxes. It hands on the energy that leaves the film
/// with the fluid, so the mouths of a pair's films get at most what the films gave away:
///
///     2 theta sum R / l q dq <= 3 r / (1 - (1 - r) (1 - r + r^2/2)^2) given_away,   0 <= theta <= 1,   q relative to the master,
///
/// r the part of their thickness that the step takes: at the rate of its start 3 r of the energy leave, transport takes the denominator. Else,
/// where a gap closes to nothing, the head makes a flood of the mouth's flux; and a fixed margin (1.3 in earlier versions) is an engine: it
/// turned a light body over another's corner faster and faster. `head`: dq of each mouth, 0 where it has none.
template <int D>
void add_heads(const FilmNetwork<D>& network, std::span<const Solid<D>> solids, const std::vector<const FilmMemory<D>*>& memory,
               const GivenAway<D>& given_away, const std::vector<double>& head, std::vector<double>& flux);

} // namespace gapflow
