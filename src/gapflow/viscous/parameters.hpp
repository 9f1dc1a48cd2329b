// All numbers of the viscous form that a person chose.
#pragma once

namespace gapflow {

/// Lengths in cells.
struct ViscousParameters {
    /// Layers of cells around solids and closed sides with elements of second order; beyond them the lattice is compact. Four values beside a border, all of whole
    /// faces, need three. With one layer the border is not consistent even for shear: cut faces' centroids lie elsewhere.
    int layers = 3;
    /// In space: least thicknesses of two solids' gap between which all of it goes over to elements. A ball of 3 cells a radius that approaches a wall errs by
    /// -25 % at 0.03 cells with elements alone and by -2.7 % with the closed form, at 0.09 cells by -4.3 and (with these) -3.8 %; one of 4 cells at 0.18 cells by -2.1 and -4.9 %.
    double pair_start = 0.05, pair_end = 0.2;
    /// A cell of less volume has no dissipation along the component, and one none in directions in which its mean square extent is less: round-off.
    double least_volume = 1e-12, least_extent = 1e-9;
    /// Area that a cell's border may lack, in space: more has no dissipation along the component. Round-off of areas is far below, what corners of solids make above.
    double open_border = 1e-7;
    /// Of what an element's projection leaves, the derivative along its sides. A third and three times of it change drags of cubic arrays of 8 cells a side by
    /// -0.27 and 0.53 %; with this value they err by -0.3 %, and less on finer grids.
    double side_stiffness = 0.33;
    /// Round-off of positions, as ComplexParameters::joint_distance.
    double same_place = 1e-9;
};

inline constexpr ViscousParameters viscous_parameters;

} // namespace gapflow
