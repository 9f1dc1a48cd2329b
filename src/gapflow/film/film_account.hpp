// Account of the energy that films gain in a step by transport and by the heads at their mouths (method, "Film transport").
#pragma once

#include "gapflow/film/mouths.hpp"

#include <map>
#include <set>
#include <vector>

namespace gapflow {

/// Energy over the density that a pair's films gained in transport and at their mouths against what was expected, by pair, positive; none:
/// 0. The next step takes it back.
template <int D>
using FilmDebts = std::map<FilmPair<D>, double>;

/// What transport and the heads at the mouths did to the films, for the account after the projection (settle_films). All relative to the pairs'
/// masters.
template <int D>
struct FilmAccount {
    std::vector<Vec<D>> reference; ///< of elements: u put in place, absolute, tangential; has no more energy than the old films
    std::vector<Vec<D>> master;    ///< of elements: the master's velocity, tangential
    std::vector<Vec<D>> transported;  ///< of elements: u*
    std::vector<double> gain;         ///< of mouths: a > 0 at outflow, dq = a (2 q_p - q); a < 0 at inflow, dq = a q
    std::vector<double> predicted;    ///< of mouths: q_p
    std::vector<double> carried;      ///< of mouths: the flux that goes with the master
    std::vector<double> kept;         ///< of mouths: the last step's flux relative to the master, with its energy
    FilmDebts<D> owed;                ///< debts of the last step
    FilmDebts<D> planned;             ///< energy that the pairs' films are expected to gain; mostly negative
    std::set<FilmPair<D>> rebounding; ///< pairs with contacts that rebound: what transport did to the films, contact has undone
    FilmDebts<D> before; ///< debts of the last step, less what the films are meant to lose and what the bulk brings in
};

/// Kinetic energy over the density of each pair's films, relative to its master.
template <int D>
FilmDebts<D> film_energy(const FilmNetwork<D>& network, const FilmAccount<D>& account, const std::vector<Vec<D>>& velocity,
                         const std::vector<double>& mouth);
/// The same of the fluid that was put in place.
template <int D>
FilmDebts<D> energy_in_place(const FilmNetwork<D>& network, const FilmAccount<D>& account);

/// Pairs whose films gained so much more than planned that their transport is to be taken back, and the projection to be repeated.
template <int D>
std::set<FilmPair<D>> mispredicted_films(const FilmNetwork<D>& network, const FilmAccount<D>& account,
                                         const std::vector<Vec<D>>& velocity, const std::vector<double>& mouth);

/// u* of these pairs' films becomes what was put in place, without transport and heads. `factor`: becomes what their mouths' conductances are
/// to be multiplied by, to be without heads.
template <int D>
void take_back_transport(const FilmNetwork<D>& network, const std::set<FilmPair<D>>& pairs, FilmAccount<D>& account,
                         std::vector<Vec<D>>& velocity, std::vector<double>& mouth, std::vector<double>& factor);

/// After the projection: the pairs' debts. `increment`: becomes the change of each element's velocity over what was put in place, over dt.
template <int D>
FilmDebts<D> settle_films(const FilmNetwork<D>& network, const FilmAccount<D>& account, const std::vector<Vec<D>>& velocity,
                          const std::vector<double>& mouth, double dt, std::vector<Vec<D>>& increment);

} // namespace gapflow
