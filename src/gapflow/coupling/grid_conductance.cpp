#include "gapflow/coupling/grid_conductance.hpp"

#include "gapflow/core/sharing.hpp"
#include "gapflow/core/threads.hpp"
#include "gapflow/grid/far_field.hpp"

#include <cmath>
#include <map>

namespace gapflow {

namespace {

template <int D>
double side_factor(const Grid<D>& grid, const FarField<D>& far_fluid, int axis, const Index<D>& f, int end)
{
    if (!is_open(grid.side(axis, end)))
        return 0.0;
    return grid.side(axis, end) == SideKind::far ? 2 / far_distance(grid, far_fluid, axis, f) : 2.0;
}

} // namespace

template <int D>
double side_factor(const Grid<D>& grid, int axis, const Index<D>& f, int end)
{
    return side_factor(grid, far_field(grid), axis, f, end);
}

template <int D>
void fill_conductance(Coupling<D>& coupling)
{
    const Grid<D>& grid = *coupling.grid;
    const Index<D> low = grid.low(), high = grid.high();
    const auto is_film = static_cast<std::int8_t>(CellKind::film);
    const double unit_conductance = std::pow(grid.dx(), D - 2) / coupling.density;
    CoupledSystem<D>& system = coupling.system;
    system.conductance = FaceField<D>(grid, 0.0);
    const FarField<D> far_fluid = far_field(grid);
    for (int axis = 0; axis < D; ++axis) {
        const Index<D> end = high + step<D>(axis);
        for_each_row_on_threads<D>(low, end, [&](const Index<D>& row) {
            const double* a = &coupling.open(axis, row);
            double* to = &system.conductance(axis, row);
            for (int i = 0; i < end[0] - low[0]; ++i)
                to[i] = a[i] > 1e-12 ? a[i] * unit_conductance : 0.0;
            if (grid.graded()) {
                const SpreadRow<D> spread(grid, axis, row);
                for (int i = 0; i < end[0] - low[0]; ++i)
                    to[i] /= spread[i];
            }
        });
        for (int side = 0; side < 2;
             ++side) { // the domain's sides: to the pressure beyond an open one, half a cell away, or further
            const int place = side * grid.cells()[axis];
            if (grid.periodic(axis) || (side == 0 ? low[axis] : high[axis]) != place)
                continue;
            Index<D> first = low, last = high;
            first[axis] = place;
            last[axis] = place + 1;
            for_each_index<D>(first, last, [&](const Index<D>& f) {
                const Index<D> inner = side ? Index<D>(f - step<D>(axis)) : f;
                system.conductance(axis, f) *=
                    coupling.kind(inner) != is_film ? side_factor(grid, far_fluid, axis, f, side) : 0.0;
            });
        }
    }
}

// Mass of the free bodies and the films' blocks that couple two of them: P M P + m (1 - P) with the projectors P onto the
// admissible twists. Its inverse leaves an admissible twist admissible; m keeps it definite.
template <int D>
void fill_mass(Coupling<D>& coupling, const std::vector<TwistMatrix<D>>& mass)
{
    constexpr int n = twist_size<D>;
    std::vector<Eigen::Triplet<double>> entries;
    auto add_block = [&](int a, int b, const TwistMatrix<D>& block) {
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j)
                if (block(i, j) != 0)
                    entries.emplace_back(n * a + i, n * b + j, block(i, j));
    };
    for (std::size_t s = 0; s < coupling.solids.size(); ++s)
        if (coupling.free_body[s] >= 0) {
            add_block(coupling.free_body[s], coupling.free_body[s],
                      admissible_mass<D>(coupling.solids[s].admissible, mass[s], mass[s](0, 0)));
        }
    std::map<std::pair<int, int>, TwistMatrix<D>> blocks; // of this rank's films
    std::pair<int, int> last[4];                          // elements of a film come one after the other
    TwistMatrix<D>* last_block[4] = {};
    auto add_inertia = [&](const NormalInertia<D>& inertia) {
        const int a = coupling.free_body[inertia.master], b = coupling.free_body[inertia.other];
        const Twist<D> row_a = coupling.solids[inertia.master].admissible * inertia.row_master;
        const Twist<D> row_b = coupling.solids[inertia.other].admissible * inertia.row_other;
        auto add = [&](int k, int i, const Twist<D>& row_i, int j, const Twist<D>& row_j) {
            if (i < 0 || j < 0)
                return;
            if (!last_block[k] || last[k] != std::pair(i, j)) {
                last[k] = {i, j};
                last_block[k] = &blocks.try_emplace({i, j}, TwistMatrix<D>::Zero()).first->second;
            }
            *last_block[k] += inertia.mass * row_i * row_j.transpose();
        };
        add(0, a, row_a, a, row_a);
        add(1, a, row_a, b, row_b);
        add(2, b, row_b, a, row_a);
        add(3, b, row_b, b, row_b);
    };
    for (const NormalInertia<D>& inertia : coupling.normal_inertia)
        add_inertia(inertia);
    for (const DragInertia<D>& drag : coupling.drag_inertia)
        add_inertia(drag.inertia);
    using Block = std::pair<std::array<int, 2>, TwistMatrix<D>>;
    std::vector<Block> own;
    for (const auto& [place, block] : blocks)
        own.push_back({{place.first, place.second}, block});
    for (const auto& [place, block] : all_values(coupling.grid->comm(), own))
        add_block(place[0], place[1], block);
    const int dofs = n * coupling.system.bodies;
    coupling.system.mass.resize(dofs, dofs);
    coupling.system.mass.setFromTriplets(entries.begin(), entries.end());
}

template double side_factor<2>(const Grid<2>&, int, const Index<2>&, int);
template double side_factor<3>(const Grid<3>&, int, const Index<3>&, int);
template void fill_conductance<2>(Coupling<2>&);
template void fill_conductance<3>(Coupling<3>&);
template void fill_mass<2>(Coupling<2>&, const std::vector<TwistMatrix<2>>&);
template void fill_mass<3>(Coupling<3>&, const std::vector<TwistMatrix<3>>&);

} // namespace gapflow
