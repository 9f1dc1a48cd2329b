// Transport of the films' momentum onto the new films, and the heads at their mouths (method, "Film transport").
#pragma once

#include "gapflow/film/film_account.hpp"
#include "gapflow/film/film_motion.hpp"

#include <functional>
#include <vector>

namespace gapflow {

/// Fluxes of mouths below this part of the largest are none: round-off does not decide whether fluid leaves.
inline constexpr double negligible_flux = 1e-9;

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
/// velocity at a list of points (elements and mouths without an old film near them), once. Collective.
template <int D>
FilmFlow<D> advect_films(const FilmNetwork<D>& network, std::span<const Solid<D>> solids, const FilmHistories<D>& histories,
                         const VelocitySampler<D>& grid_velocity, const std::function<MouthLaw(int, int)>& law,
                         const FilmDebts<D>& debts, double dt, double share = 1);

} // namespace gapflow
