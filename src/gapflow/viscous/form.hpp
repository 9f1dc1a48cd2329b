// The dissipation of the fluid as one quadratic form on the complex of parts (theory, "Viscosity on parts").
//
//     E = 1/2 sum_f l_f E_f(u, w, v) + 1/2 sum_P sum_d E_{P,d},      E_f ~ int |grad u_d|^2 in the face,  E_{P,d} ~ int_P (d_d u_d)^2
//
// of |grad u|^2 per unit of viscosity. u is the mean normal velocity of each face piece, the only unknown with flux. Its traces are the means w of the same component
// on the open stretches of the face's edges (3D) and its values v at their ends; on walls they are those of the solids' twists. Lengths are in cells, angular
// velocities in radians, so that a twist's velocities are those of the fluid.
#pragma once

#include "gapflow/complex/gap_drag.hpp"
#include "gapflow/complex/part_borders.hpp"
#include "gapflow/viscous/fluid_cells.hpp"
#include "gapflow/viscous/squares.hpp"
#include "gapflow/viscous/whole_faces.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace gapflow {

/// A face between two cells of the form, or between one and an open side of the domain.
template <int D>
struct FormFace {
    std::int8_t axis;
    bool whole;             ///< all of the grid's face, between whole cells
    bool compact = false;   ///< of the compact lattice
    std::int32_t face;      ///< number of the cell on its high side in Complex::index
    std::int32_t low, high; ///< FluidCells; -1: beyond the domain
    double area, length;    ///< length: l_f, between the centres of the grid's cells
    Vec<D> centroid;
    double gap = 0; ///< share of its dissipation that is that of a gap
    // Of the polygon that stands for it, with chords for curves.
    double polygon_area = 0;
    Vec<D> polygon_centroid = Vec<D>::Zero();
};

/// The mean of a component on an open stretch of an edge of the grid, or (length 0) its value at a vertex.
template <int D>
struct FormTrace {
    std::int8_t component, axis; ///< axis: of the edge
    Vec<D> at;                   ///< the middle
    double length = 0;
};

/// Linear functions of the columns, one after the other.
struct RowList {
    std::vector<std::int64_t> end{0};
    std::vector<std::int32_t> column;
    std::vector<double> factor;

    int rows() const { return static_cast<int>(end.size()) - 1; }
    void add(Row row);
    double value(int row, std::span<const double> x) const;
};

/// Faces of the compact lattice, one after the other in the first axis, all in unit cells: each resists to its difference from each of 2 D faces around it.
template <int D>
struct LatticeRun {
    std::int32_t first, length;
    std::array<std::int32_t, 2 * D> beside; ///< those of the first one
};

template <int D>
struct Lattice {
    std::vector<LatticeRun<D>> runs;
    std::vector<std::array<std::int32_t, 2>> links; ///< of another face to one in a run

    /// y += A x.
    void add_product(std::span<const double> x, std::span<double> y) const;
    /// f(a, b) of all pairs.
    template <class F>
    void for_each_pair(const F& f) const;
};

template <int D>
template <class F>
void Lattice<D>::for_each_pair(const F& f) const
{
    std::vector<char> outside; // faces in no run that one has beside it
    for (const auto& [face, other] : links) {
        outside.resize(std::max(outside.size(), static_cast<std::size_t>(face) + 1));
        outside[face] = true;
        f(face, other);
    }
    for (const LatticeRun<D>& run : runs)
        for (const std::int32_t first : run.beside)
            for (std::int32_t i = 0; i < run.length; ++i)
                if (const std::int32_t a = run.first + i, b = first + i;
                    a < b && (static_cast<std::size_t>(b) >= outside.size() || !outside[b]))
                    f(a, b);
}

/// The squares of a face with an element of its own, from one to before another.
struct FormElement {
    std::int32_t face;
    std::int64_t first, last;
};

/// Columns: the velocity of each face, then the traces, then the twists of the solids. After them are those that `squares` and `whole` have besides, each a function
/// of the others: `derived`, then the moments of the whole faces.
template <int D>
struct ViscousForm {
    FluidCells<D> cells;
    std::vector<FormFace<D>> faces;
    std::vector<FormTrace<D>> traces;
    int solids = 0;
    Lattice<D> lattice;
    SquareSum squares; ///< what else there is; no weight is negative
    std::array<std::int64_t, 2>
        gap_rows{}; ///< those of gaps in closed form, without derived columns: the first one, and the first one after them
    std::vector<std::int32_t> row_face, turning_face; ///< face of each row of `squares`, and of `rotation`; -1: none alone
    RowList derived;                                  ///< of columns
    WholeFaces whole;
    std::vector<FormElement> elements; ///< of the other faces with traces, 3D
    RowList beside;  ///< of each trace: the velocities of the faces that have it, by equal shares; for preconditioners
    RowList outflow; ///< of each cell: what the faces and the walls' motion take out of it
    /// What the squares lack of 2 |e|^2, e the rate of strain: a form of the solids' twists, of either sign. With it a rotation of all dissipates nothing.
    SquareSum rotation;

    int velocities() const { return static_cast<int>(faces.size()); }
    int unknowns() const { return velocities() + static_cast<int>(traces.size()); }
    int columns() const { return unknowns() + twist_size<D> * solids; }
    int all_columns() const { return columns() + derived.rows() + 2 * whole.count(); }
    int twist_column(int solid, int component) const { return unknowns() + twist_size<D> * solid + component; }

    /// y = A x of all columns: the entries of the solids' twists are the wrenches with which the fluid resists them, but for its pressure.
    void product(std::span<const double> x, std::span<double> y) const;
    /// E of all columns.
    double energy(std::span<const double> x) const;
    /// All of it but the rotation, in `columns()` alone.
    SquareSum plain_squares() const;
    /// The same where fluid fills a share of each face, of streams as thick as the gap: the weight of its rows. Velocities are those of the fluid.
    ViscousForm filled(const std::vector<double>& share) const;
    /// Of its matrix, nearly: where a row has two derived columns of one column, the sum of their squares.
    std::vector<double> diagonal() const;
    /// The same of velocities that traces follow as `beside` says.
    std::vector<double> followed_diagonal(const std::vector<double>& diagonal) const;

private:
    void find_derived(std::span<const double> x, std::vector<double>& all) const;
};

/// Of a whole domain on one rank. `borders`: those of the complex's parts, see build_complex; `gaps`: the dissipation of what is narrower than a cell, which
/// takes the elements' place to its share.
template <int D>
ViscousForm<D> build_viscous_form(const Grid<D>& grid, std::span<const Solid<D>> solids, const Complex<D>& complex,
                                  const PartBorders<D>& borders, const GapDrags<D>& gaps = {});

} // namespace gapflow
