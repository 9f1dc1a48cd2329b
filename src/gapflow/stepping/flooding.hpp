// Fluid that enters voids in films (method, "Voids: dry contact and cavitation"): elements without any wet node rest on their master, the mouth's kinetic
// head is taken semi-implicitly, a void that overfills within a step passes the surplus on, and elements that the front has
// reached take the velocity behind it.
#pragma once

#include "gapflow/coupling/coupling.hpp"
#include "gapflow/film/film_momentum.hpp"
#include "gapflow/stepping/void_set.hpp"

#include <functional>
#include <vector>

namespace gapflow {

/// Flux out of the film through a mouth due to the master's motion.
template <int D>
double carried_flux(const Coupling<D>& coupling, const Mouth<D>& mouth, const std::vector<Twist<D>>& twists);

/// u of the elements marked in `empty` becomes their master's velocity, along the film.
template <int D>
void rest_in_voids(const Coupling<D>& coupling, const std::vector<char>& empty, const std::vector<Twist<D>>& twists,
                   std::vector<Vec<D>>& u);

/// Inflow at sharp mouths of dry films and into voids: with w the flux into the film per length, seen from the master,
///     rho R (w - w^n) / dt + rho k w |w| / (2 h^2) = p_bulk - p_film,      k = 1 + zeta,
/// solved for w with the pressures of the last step (`bulk_pressure`: reduced, one a mouth) gives the speed of the semi-implicit
/// head: gamma = 1 / (1 + dt k w / (2 R h^2)), q* = gamma q^n + (1 - gamma) l h nu . U_m. Changes flow.mouth and its scale.
template <int D>
void limit_inflow(const Coupling<D>& coupling, const VoidSet<D>& voids, const FilmHistories<D>& histories,
                  const std::function<MouthLaw(int, int)>& law, const std::vector<double>& bulk_pressure, double dt,
                  FilmFlow<D>& flow);

/// Void nodes that the flow would overfill in dt pass nearly all of the surplus on, through empty elements, in the direction of
/// the inflow. `twists`: of the solids; changes flow.velocity.
template <int D>
void pass_on(const Coupling<D>& coupling, const VoidSet<D>& voids, const std::vector<Twist<D>>& twists, double dt,
             FilmFlow<D>& flow);

/// u* of the elements marked in `empty` is set against the void's own pressure: the gradient of the least pressure leaves them the velocity that they
/// have. So no fluid flows in them for their void's sake, whatever nodes become wet in the step: the conditions of voids are those of one linear
/// problem.
template <int D>
void oppose_void_pressure(const Coupling<D>& coupling, const VoidSet<D>& voids, const std::vector<char>& empty, double dt,
                          std::vector<Vec<D>>& u);

/// After a step: elements that were empty and are not any longer take the velocity of those behind, or of the mouth.
template <int D>
void follow_front(const Coupling<D>& coupling, const std::vector<char>& was_empty, const std::vector<char>& is_empty,
                  const std::vector<char>& is_void, const std::vector<Twist<D>>& twists, FluidVelocity<D>& u);

} // namespace gapflow
