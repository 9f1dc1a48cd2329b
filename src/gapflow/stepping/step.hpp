// Data of one time step for all stages, and its report.
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace gapflow {

struct Step {
    long number = 1;    ///< from 1
    double start = 0;   ///< time
    double dt = 0;      ///< 0: the initial projection
    double last_dt = 0; ///< of the step before; 0: there was none
    double landing = 0; ///< time after it: an output time exactly, where it ends next to one

    double end() const { return start + dt; }
};

/// Result of a step, and the state's sums after it.
struct StepReport {
    long step = 0;
    double time = 0, dt = 0;
    long cells = 0; ///< unknowns of the grid
    int film_nodes = 0, iterations = 0;
    int solves = 0;                                    ///< of the pressure: more than one where contacts or voids change
    int viscous_iterations = 0;                        ///< of the bulk's viscous solve
    double residual = 0, divergence_max = 0;           ///< divergence: net outflow of a cell over its volume, 1/time
    double energy_fluid = 0, energy_bodies = 0;        ///< as in Budget
    double dissipation_grid = 0, dissipation_film = 0; ///< power that viscosity dissipates, in the bulk and in films
    double pressure_gradient_x = 0, pressure_gradient_y = 0, pressure_gradient_z = 0; ///< mean, that drives a periodic box
    double mean_velocity_x = 0, mean_velocity_y = 0, mean_velocity_z = 0;             ///< of fluid and solids of such a box
    double unsteadiness =
        std::numeric_limits<double>::quiet_NaN(); ///< where time.until_steady asks for it (stepping/steadiness)
    double corrected_energy = 0; ///< of runs on parts: energy that the correction of the forces' work adds in the step
    bool leaving = false;        ///< a body came to be on its way out of the domain in this step
    double seconds = 0;
    std::vector<std::string> notes; ///< for the user, once each: thin bodies, contacts that do not converge, blind film ends
};

} // namespace gapflow
