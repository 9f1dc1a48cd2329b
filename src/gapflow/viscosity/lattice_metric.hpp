// Areas and lengths of the lattice of face centres on a graded grid (method, "Viscosity", "Graded spacing"): in multiples of those of the core.
//
// A lattice edge from the centre of face f to that of f + e_k stands for the fluid around it: as long as the way between the two, as wide as
// a cell along the other axes (along the faces' own axis: as the way between the centres of the cells beside the face). Its weight in
// int |grad u|^2 is width over length.
#pragma once

#include "gapflow/grid/grid.hpp"

#include <array>

namespace gapflow {

/// Length along axis k of the edge from the centre of face f, normal to `axis`, to that of f + e_k, over dx.
template <int D>
double edge_length(const Grid<D>& grid, int axis, const Index<D>& f, int k)
{
    return k == axis ? grid.width(k, f[k]) : grid.spread(k, f[k] + 1);
}

/// Cross-section of the fluid around the edges along k that end in the centre of face f, over dx^(D-1).
template <int D>
double edge_section(const Grid<D>& grid, int axis, const Index<D>& f, int k)
{
    double section = 1;
    for (int m = 0; m < D && grid.graded(); ++m)
        if (m != k)
            section *= m == axis ? grid.spread(m, f[m]) : grid.width(m, f[m]);
    return section;
}

/// Section over length of the edges that end in the faces of a row along the first axis.
template <int D>
class EdgeRow {
public:
    EdgeRow(const Grid<D>& grid, int axis, const Index<D>& row)
        : width_(axis == 0 ? grid.spreads(0, row[0]) : grid.widths(0, row[0])),
          length_(axis == 0 ? grid.widths(0, row[0]) : grid.spreads(0, row[0] + 1))
    {
        for (int k = 0; k < D; ++k) {
            double section = 1; // without the first axis
            for (int m = 1; m < D; ++m)
                if (m != k)
                    section *= m == axis ? grid.spread(m, row[m]) : grid.width(m, row[m]);
            before_[k] = k == 0 ? section : section / edge_length<D>(grid, axis, row - step<D>(k), k);
            after_[k] = k == 0 ? section : section / edge_length<D>(grid, axis, row, k);
        }
    }
    /// Of the edge from face i of the row to the one before (after) it along axis k.
    double before(int k, int i) const { return k == 0 ? before_[0] / length_[i - 1] : before_[k] * width_[i]; }
    double after(int k, int i) const { return k == 0 ? after_[0] / length_[i] : after_[k] * width_[i]; }

private:
    const double *width_, *length_;
    std::array<double, D> before_, after_;
};

} // namespace gapflow
