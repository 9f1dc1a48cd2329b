// Body flux (method, "Face fractions"): volume flux out of a cell's fluid through a solid's surface per unit twist of the solid,
//
//     J_{c,b} = sum_f s_{f,b} |f| wrench(o_f, x_{f,b} - x_b),      o_f = outward normal of c on its face f.
//
// Each face enters two cells with opposite signs, so sum_c J_{c,b} = 0 for a body inside the domain; and the closed hull of a
// cell gives sum_b J_{c,b} U + sum_f a_f |f| o_f . U(x_f) = 0 for any rigid field U.
#pragma once

#include "gapflow/grid/face_fractions.hpp"

#include <utility>
#include <vector>

namespace gapflow {

/// Calls f(solid, J) with the Twist<D> row J_{c,b} of every solid that touches the cell, walls too, in no particular order.
/// Cells wholly inside one solid have none. The cell is this rank's, or a ghost all of whose faces lie in the fields' block.
template <int D, class F>
void for_each_body_flux(const Grid<D>& grid, const FaceFractions<D>& fractions, const Index<D>& cell, F&& f)
{
    std::array<int, 2 * D> cut;
    bool any = false, closed = true, hull = true;
    for (int side = 0; side < 2 * D; ++side) {
        const Index<D> face = cell + (side % 2) * step<D>(side / 2);
        cut[side] = fractions.cut(side / 2, face);
        any |= cut[side] >= 0;
        const bool has_open = fractions.open(side / 2, face) > 0;
        closed &= !has_open;
        hull &= cut[side] >= 0 || has_open;
    }
    if (!any || !hull) // the wholly solid faces of a cell in one solid need not all have entries
        return;

    InlineVector<std::pair<int, Twist<D>>, 4> flux;
    bool one_solid = closed;
    const SolidPart<D>& first = fractions.faces[cut[0] >= 0 ? cut[0] : 0].solid[0];
    for (int side = 0; side < 2 * D; ++side) {
        if (cut[side] < 0)
            continue;
        const Vec<D> area = (2 * (side % 2) - 1) * grid.face_area() * unit<D>(side / 2);
        for (const SolidPart<D>& part : fractions.faces[cut[side]].solid) {
            one_solid = one_solid && part.solid == first.solid &&
                        (part.centroid - part.arm - first.centroid + first.arm).norm() < 1e-6 * grid.dx();
            const Twist<D> row = wrench<D>(part.fraction * area, part.arm);
            auto known = flux.begin();
            while (known != flux.end() && known->first != part.solid)
                ++known;
            if (known != flux.end())
                known->second += row;
            else
                flux.push_back({part.solid, row});
        }
    }
    if (one_solid)
        return;
    for (const auto& [solid, row] : flux)
        f(solid, row);
}

/// Sum over all cells of the domain of J_{c,b} for each of the solids: 0 to round-off for a body inside the domain.
/// Collective.
template <int D>
std::vector<Twist<D>> sum_of_body_flux(const Grid<D>& grid, const FaceFractions<D>& fractions, int solids)
{
    std::vector<double> sums(static_cast<std::size_t>(solids) * twist_size<D>, 0.0);
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
        for_each_body_flux(grid, fractions, c, [&](int solid, const Twist<D>& flux) {
            Eigen::Map<Twist<D>>(&sums[static_cast<std::size_t>(solid) * twist_size<D>]) += flux;
        });
    });
    grid.comm().sum(sums);
    std::vector<Twist<D>> result;
    for (int b = 0; b < solids; ++b)
        result.push_back(Eigen::Map<const Twist<D>>(&sums[static_cast<std::size_t>(b) * twist_size<D>]));
    return result;
}

} // namespace gapflow
