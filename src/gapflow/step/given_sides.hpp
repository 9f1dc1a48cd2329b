// Sides of the domain with a flux or a pressure of their own (theory of the step, "Sides").
#pragma once

#include "gapflow/step/potential_flow.hpp"

namespace gapflow {

/// Open area of a side of the domain, and its conductance, in a row.
template <int D>
struct SideRow {
    int node; ///< -1: a cell's
    Index<D> cell, face;
    double area, conductance;
};
/// That of a face for the largest part of its cell; the area is 0 where this is shut.
template <int D>
SideRow<D> row_of_face(const Placed<D>& at, int side, const Index<D>& face);
/// Those of all other parts, of this rank's faces.
template <int D>
std::vector<SideRow<D>> nodes_of_side(const Placed<D>& at, int side);

/// Integrals of the reduced pressures beyond pressure sides from the start until a time.
template <int D>
std::array<double, 2 * D> impulses_beyond(const Model<D>& model, double time);

/// Of the scene's sides at a time. Viscous fluid has the impulses beyond pressure sides in its remainder, and the whole speed of the inflow. Collective.
template <int D>
GivenSides<D> given_sides(const Model<D>& model, double time);

/// What leaves every row through the sides at potentials of 0. Collective.
template <int D>
UnknownVector<D> outflow_of_sides(const Placed<D>& at, const GivenSides<D>& sides);

/// Adds the inflow's flux over the area of a whole face.
template <int D>
void add_inflow(const Placed<D>& at, const GivenSides<D>& sides, FaceField<D>& flux);

/// What the fluid's kinetic energy has beside 1/2 V . dT/dV. Collective.
template <int D>
double energy_of_sides(const Placed<D>& at, const PotentialFlow<D>& flow);

/// What dT/dx at fixed twists and givens has by the sides' open areas, of every solid. Collective.
template <int D>
std::vector<Twist<D>> forces_of_sides(const Placed<D>& at, const PotentialFlow<D>& flow);

/// Velocities in the sides: those of inflow, and what the impulses beyond pressure sides add. `stream`: of the whole motion.
template <int D>
void add_side_velocities(const Placed<D>& at, const GivenSides<D>& sides, const Vec<D>& stream, FaceField<D>& u);

} // namespace gapflow
