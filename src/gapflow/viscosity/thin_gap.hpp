// Fluid in a gap of a few cells, between two surfaces that a lattice line meets: what the lattice's own shear lacks.
//
// The second difference next to a wall is too weak: a gap of one cell lets three times too much through, of n cells 1 + 2 / n^2
// times. The point next to the wall gets a drag on top,
//
//     1/2 c D (w - U_lin)^2,       U_lin: linear between the two surfaces' velocities,   c: stiffness of a lattice edge,
//
// with D such that plane Poiseuille flow under a pressure gradient keeps its exact flux through every face, wherever the surfaces
// cut the line. Shear flow and common motion do not see it, one cell has the film's law 12 mu u / h^2, and D goes like 1/n.
#pragma once

namespace gapflow {

/// D for a lattice point at the distances `near` and `far` from the surfaces on its line (in cells), whose face is open by the
/// part of the line within half a cell of it and has the mean velocity `share` times that of its centre. `next`: the point beyond,
/// towards the far surface, is one of the lattice too. Not negative.
double thin_gap_drag(double near, double far, double share, bool next);

} // namespace gapflow
