// The films' velocities from step to step, and their advection on the moving surface mesh (method, "The time step").
//
// An element's velocity is w = u + V_n n in world axes (u tangential, V_n the normal speed of the mid-gap surface).
// Semi-Lagrangian on the master: trace back by dt (u - P U_m) along the old mesh in the master's frame, transport w as a world
// vector, and turn it into the new tangent plane:
//     w* = w^(x*) + theta (w_e - w^(x_e)),    w^ = U_m + (h (w - U_m))^ / h^, theta = 1 where the
//                                             new element is the old element e, 0 where the mesh has changed,
// (.)^: from vertex values (local least squares in the tangent plane, weighted by S). The flux h (w - U_m) varies slowly where the
// gap does not: interpolation of w itself, which varies as 1/h, overestimates it on both sides of a throat and drives fluid through it.
//     w_new = w* + lambda n_bar,      n_bar parallel to n_old + n_new,   lambda such that w_new . n_new is the new normal speed.
// A trace that leaves the old film uses w^ extrapolated linearly beyond its end, never the grid's velocity.
#pragma once

#include "gapflow/film/film_history.hpp"
#include "gapflow/film/mouths.hpp"

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <vector>

namespace gapflow {

/// The films' velocities after the last step, by pair.
template <int D>
using FilmHistories = std::map<FilmPair<D>, std::shared_ptr<const FilmHistory<D>>>;

/// Energy over the density that a pair's films gained in transport and at their mouths against what was expected, by pair; none: 0. The next
/// step takes it back, or gives it back where it is negative.
template <int D>
using FilmDebts = std::map<FilmPair<D>, double>;

/// What transport and the heads at the mouths did to the films, for the account after the projection (settle_films). All relative to the pairs'
/// masters.
template <int D>
struct FilmAccount {
    std::vector<Vec<D>> reference; ///< of elements: u put in place, absolute, tangential; has no more energy than the old films
    std::vector<Vec<D>> master;    ///< of elements: the master's velocity, tangential
    std::vector<Vec<D>> transported; ///< of elements: u*
    std::vector<double> gain;        ///< of mouths: a > 0 at outflow, dq = a (2 q_p - q); a < 0 at inflow, dq = a q
    std::vector<double> predicted;   ///< of mouths: q_p
    std::vector<double> carried;     ///< of mouths: the flux that goes with the master
    std::vector<double> kept;        ///< of mouths: the last step's flux relative to the master, with its energy
    FilmDebts<D> owed;               ///< debts of the last step
    FilmDebts<D> planned;            ///< energy that the pairs' films are expected to gain; mostly negative
    FilmDebts<D> before; ///< debts of the last step, less what the films are meant to lose and what the bulk brings in
};

/// Velocities with which films enter the next projection.
template <int D>
struct FilmFlow {
    std::vector<Vec<D>> velocity;    ///< u*, tangential, one for each element
    std::vector<double> normal;      ///< w_n*, one for each element
    std::vector<double> mouth;       ///< q*, absolute, one for each mouth
    std::vector<double> mouth_scale; ///< factor on the mouth's 1/R
    FilmAccount<D> account;
};

/// Velocities at a list of points.
template <int D>
using VelocitySampler = std::function<std::vector<Vec<D>>(const std::vector<Vec<D>>&)>;

struct MouthLaw {
    double entrance_loss = 0; ///< zeta
    bool jet = false;         ///< outflow leaves as a jet: its kinetic head is lost
};

/// Advects the old films' velocities onto the new ones. `grid_velocity` samples the bulk's extrapolated
/// velocity at a list of points (elements and mouths without an old film near them), once.
template <int D>
FilmFlow<D> advect_films(const FilmNetwork<D>& network, std::span<const Solid<D>> solids, const FilmHistories<D>& histories,
                         const VelocitySampler<D>& grid_velocity, const std::function<MouthLaw(int, int)>& law,
                         const FilmDebts<D>& debts, double dx, double dt, double share = 1);

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
