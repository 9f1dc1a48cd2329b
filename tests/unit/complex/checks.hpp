// What holds for every complex.
#pragma once

#include "../grid/scenes.hpp"

#include "gapflow/complex/complex.hpp"

namespace gapflow::testing {

/// Sums of a complex that are zero or known.
template <int D>
struct ComplexSums {
    double closure = 0;           ///< largest outflow of a rigid motion of everything from a part or an open cell, translation
    double spin_closure = 0;      ///< the same of a rotation
    std::vector<Twist<D>> flux;   ///< of each solid, over all parts
    std::array<double, D> area{}; ///< open, of all faces normal to an axis
};

template <int D>
ComplexSums<D> sums_of(const Grid<D>& grid, const Complex<D>& complex, const std::vector<Solid<D>>& solids,
                       double* worst_place = nullptr)
{
    ComplexSums<D> sums;
    sums.flux.assign(solids.size(), Twist<D>::Zero());
    const int cells = static_cast<int>(complex.index.count);
    std::vector<Twist<D>> out(complex.parts(), Twist<D>::Zero()),
        out_cell(cells, Twist<D>::Zero()); // per unit twist about the origin (in cells)
    const auto row = [](int axis, double area, const Vec<D>& x) { return wrench<D>(area * unit<D>(axis), x); };
    const auto add = [&](const PartOrCell& side, const Twist<D>& w) {
        if (side.is_part())
            out[side.number()] += w;
        else if (side.is_cell())
            out_cell[side.number()] += w;
    };
    std::array<std::vector<double>, D> rest = complex.main_area;
    const auto shifted = [&](Vec<D> x, int axis, std::int32_t face, const PartOrCell&,
                             bool low) { // the low side of a periodic domain's first face lies at its end
        if (low && grid.periodic(axis) && complex.index.index(face)[axis] == 0)
            x[axis] += grid.cells()[axis];
        return x;
    };
    for (const FacePiece<D>& piece : complex.pieces) {
        add(piece.low, row(piece.axis, piece.area, shifted(piece.centroid, piece.axis, piece.face, piece.low, true)));
        add(piece.high, row(piece.axis, -piece.area, piece.centroid));
        sums.area[piece.axis] += piece.area;
        if (complex.joins_main(piece))
            rest[piece.axis][piece.face] -= piece.area;
    }
    for (int d = 0; d < D; ++d)
        for_each_index<D>(complex.index.low, owned_faces_end(grid, d), [&](const Index<D>& f) {
            const double area = rest[d][complex.index(f)];
            if (!(area > 1e-12))
                return;
            sums.area[d] += area;
            Vec<D> x = (grid.face_centre(d, f) - grid.anchor()) / grid.dx();
            for (int side = 0; side < 2; ++side) {
                const Index<D> c = f - (1 - side) * step<D>(d), w = grid.wrapped(c);
                if (!grid.in_domain(w))
                    continue;
                Vec<D> y = x;
                y[d] += w[d] - c[d];
                const int number = complex.cell[complex.index(w)];
                add(number >= 0 ? PartOrCell::part(complex.first_part[number]) : PartOrCell::cell(complex.index(w)),
                    row(d, side ? -area : area, y));
            }
        });
    for (int c = 0; c < cells; ++c)
        if (complex.cell[c] == Complex<D>::open)
            sums.closure = std::max(sums.closure, out_cell[c].template head<D>().norm());
    for (int p = 0; p < complex.parts(); ++p) {
        for (const WallPatch<D>& patch : complex.patches_of(p)) {
            Twist<D> w;
            w << patch.area, patch.moment;
            sums.flux[patch.solid] += w;
            const Vec<D> reference = (solids[patch.solid].centre - grid.anchor()) / grid.dx();
            w.template tail<spin_size<D>>() += moment<D>(reference, patch.area);
            out[p] += w;
        }
        const double translation = out[p].template head<D>().norm();
        if (worst_place && translation > sums.closure)
            for (int axis = 0; axis < D; ++axis)
                worst_place[axis] = complex.cell_of_part(p)[axis];
        sums.closure = std::max(sums.closure, translation);
        sums.spin_closure = std::max(sums.spin_closure, out[p].template tail<spin_size<D>>().norm());
    }
    return sums;
}

} // namespace gapflow::testing
