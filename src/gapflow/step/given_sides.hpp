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

/// Of the scene's sides at a time. Collective.
template <int D>
GivenSides<D> given_sides(const Model<D>& model, double time);

/// What leaves every row through the sides at potentials of 0. Collective.
template <int D>
UnknownVector<D> outflow_of_sides(const Placed<D>& at, const GivenSides<D>& sides);

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
