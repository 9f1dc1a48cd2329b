// Reports of the state: pressure, gaps, momentum and energy. Reads the state, never changes it.
#pragma once

#include "gapflow/stepping/state.hpp"
#include "gapflow/stepping/step.hpp"

#include <string>
#include <vector>

namespace gapflow {

/// State of one pair of solids with a film.
struct GapState {
    std::string body_a, body_b; ///< in the scene's order, walls last
    double thickness = 0;       ///< smallest distance; negative: overlap
    double opening_rate = 0;    ///< at that place
    int film_nodes = 0;
    double film_area = 0, pressure_min = 0, pressure_max = 0;
    double force = 0; ///< on body_a, along the normal that pushes it away from body_b
    double contact_force = 0, contact_impulse = 0;
    double void_volume = 0;
};

/// Momentum and energy of fluid, films and bodies.
template <int D>
struct Budget {
    Vec<D> momentum = Vec<D>::Zero();           ///< fluid, films, mouths and free bodies
    Spin<D> angular_momentum = Spin<D>::Zero(); ///< the same, about the domain's origin
    double energy_grid = 0, energy_film = 0;
    double energy_bodies = 0; ///< kinetic energy of the free bodies and energy of their springs
};

/// Reduced pressure (p - rho g.x), averaged over the last step: bulk and mixed cells, film nodes.
template <int D>
UnknownVector<D> reduced_pressure(const State<D>& state);

template <int D>
std::vector<GapState> gap_states(const Model<D>& model, const Coupling<D>& here, const State<D>& state);

/// `V`: twists of all solids that the flow belongs to. Collective.
template <int D>
Budget<D> budget(const Model<D>& model, const Coupling<D>& here, const State<D>& state, const std::vector<Twist<D>>& V);

/// Net outflow of every unknown's volume at the end of the step, growth of voids taken off: what the solver's tolerance leaves. Collective.
template <int D>
UnknownVector<D> net_outflow(const Coupling<D>& here, const State<D>& state, const std::vector<Twist<D>>& V);

/// Fills in the report's data about the state: time, sizes, energies, divergence. Collective.
template <int D>
void report_state(const Model<D>& model, const Coupling<D>& here, const State<D>& state, const std::vector<Twist<D>>& V,
                  StepReport& report);

} // namespace gapflow
