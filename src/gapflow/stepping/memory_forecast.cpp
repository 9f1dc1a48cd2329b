#include "gapflow/stepping/memory_forecast.hpp"

namespace gapflow {

double forecast_memory(const Scene& scene, long film_nodes, long mouths)
{
    double cells = 1;
    for (int axis = 0; axis < scene.dimension; ++axis)
        cells *= scene.cells[axis];
    const bool flat = scene.dimension == 2, viscous = scene.viscosity > 0;
    const double a_cell = !viscous ? 0 : flat ? 238 : 288; // beyond what expected_memory() counts
    const double a_node = flat ? 3200 : viscous ? 6200 : 3660, a_mouth = flat ? 0 : 7270;
    return expected_memory(scene.dimension, cells) + a_cell * cells + a_node * static_cast<double>(film_nodes) +
           a_mouth * static_cast<double>(mouths);
}

} // namespace gapflow
