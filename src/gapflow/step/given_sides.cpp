#include "gapflow/step/given_sides.hpp"

#include "gapflow/coupling/grid_conductance.hpp"
#include "gapflow/grid/side_faces.hpp"
#include "gapflow/scene/time_table.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {
namespace {

/// Calls f(row) for this rank's rows beside a side.
template <int D, class F>
void for_each_row_of_side(const Placed<D>& at, int side, F&& f)
{
    for_each_face_of_side(*at.coupling.grid, side / 2, side % 2, [&](const Index<D>& face) {
        if (const SideRow<D> row = row_of_face(at, side, face); row.area > 0)
            f(row);
    });
    for (const SideRow<D>& row : nodes_of_side(at, side))
        f(row);
}

} // namespace

template <int D>
SideRow<D> row_of_face(const Placed<D>& at, int side, const Index<D>& face)
{
    const Coupling<D>& coupling = at.coupling;
    const int axis = side / 2;
    const Index<D> cell = side % 2 ? Index<D>(face - step<D>(axis)) : face;
    if (coupling.system.component(cell) < 0)
        return {-1, cell, face, 0, 0};
    return {-1, cell, face, coupling.grid->face_area() * coupling.open(axis, face), coupling.system.conductance(axis, face)};
}

template <int D>
std::vector<SideRow<D>> nodes_of_side(const Placed<D>& at, int side)
{
    const Coupling<D>& coupling = at.coupling;
    const Grid<D>& grid = *coupling.grid;
    const Complex<D>& complex = at.complex;
    const int axis = side / 2, end = side % 2;
    const double unit = std::pow(grid.dx(), D - 2) / coupling.density;
    std::vector<SideRow<D>> rows;
    for (const FacePiece<D>& piece : complex.pieces) {
        if (piece.axis != axis || (end ? piece.high : piece.low).exists() || complex.joins_main(piece) || !(piece.area > 0))
            continue;
        const PartOrCell& inner = end ? piece.low : piece.high;
        const Index<D> face = complex.index.index(piece.face);
        const int node = inner.is_part() ? at.node[inner.number()] : -1;
        if (node >= 0 && owns_face(grid, axis, face))
            rows.push_back({node, grid.wrapped(complex.index.index(complex.cell_of(inner))), face,
                            grid.face_area() * piece.area,
                            unit * piece.area / grid.spread(axis, face[axis]) * side_factor(grid, axis, face, end)});
    }
    return rows;
}

template <int D>
std::array<double, 2 * D> impulses_beyond(const Model<D>& model, double time)
{
    std::array<double, 2 * D> impulses{};
    const std::array<double, 2 * D> at_start = model.pressure_beyond(0);
    for (int s = 0; s < 2 * D; ++s)
        if (const SideScene& side = model.scene.sides[s]; side.kind == SideScene::Kind::pressure) {
            const double constant = at_start[s] - value_at(side.table, 0).at(0); // the level of the reduced pressure
            impulses[s] = integral_to(side.table, time).at(0) + constant * time;
        }
    return impulses;
}

template <int D>
GivenSides<D> given_sides(const Model<D>& model, double time)
{
    GivenSides<D> sides;
    const BoundaryVelocity<D> given = model.sides(time);
    for (int s = 0; s < 2 * D; ++s)
        if (model.scene.sides[s].kind == SideScene::Kind::inflow)
            sides.speed[s] = given.velocity[s][s / 2] - (model.viscous() ? 0.0 : model.scene.fluid_velocity[s / 2]);
    if (!model.viscous())
        sides.impulse = impulses_beyond(model, time);
    return sides;
}

template <int D>
UnknownVector<D> outflow_of_sides(const Placed<D>& at, const GivenSides<D>& sides)
{
    const Coupling<D>& coupling = at.coupling;
    UnknownVector<D> sum{CellField<D>(*coupling.grid), Eigen::VectorXd::Zero(coupling.system.nodes)};
    for (int s = 0; s < 2 * D; ++s) {
        if (sides.speed[s] == 0 && sides.impulse[s] == 0)
            continue;
        const double outwards = s % 2 ? sides.speed[s] : -sides.speed[s];
        for_each_row_of_side(at, s, [&](const SideRow<D>& row) {
            (row.node >= 0 ? sum.nodes[row.node] : sum.cells(row.cell)) +=
                row.area * outwards - row.conductance * sides.impulse[s];
        });
    }
    coupling.grid->comm().sum(std::span<double>(sum.nodes.data(), sum.nodes.size()));
    return sum;
}

template <int D>
void add_inflow(const Placed<D>& at, const GivenSides<D>& sides, FaceField<D>& flux)
{
    for (int s = 0; s < 2 * D; ++s)
        if (sides.speed[s] != 0)
            for_each_row_of_side(at, s, [&](const SideRow<D>& row) {
                flux(s / 2, row.face) += sides.speed[s] * row.area / at.coupling.grid->face_area();
            });
}

template <int D>
double energy_of_sides(const Placed<D>& at, const PotentialFlow<D>& flow)
{
    const Grid<D>& grid = *at.coupling.grid;
    double sum = 0;
    for (int s = 0; s < 2 * D; ++s) {
        const double speed = flow.sides.speed[s], impulse = flow.sides.impulse[s];
        if (speed == 0 && impulse == 0)
            continue;
        const double outwards = s % 2 ? speed : -speed;
        for_each_row_of_side(at, s, [&](const SideRow<D>& row) {
            const double p = row.node >= 0 ? flow.p.nodes[row.node] : flow.p.cells(row.cell),
                         half = 0.5 * grid.dx() * grid.spread(s / 2, row.face[s / 2]);
            sum += 0.5 * row.area * (at.coupling.density * half * speed * speed - p * outwards) -
                   0.5 * row.conductance * impulse * (p - impulse);
        });
    }
    return grid.comm().sum(sum);
}

// The energy -1/2 p . L p - p . K V + 1/2 V . B V of the closed form has no more of the sides than 1/2 g p^2. With o the inflow outwards, h half a cell, it lacks
// 1/2 a rho h o^2 - a o p + g (p - 1/2 pi) pi.
template <int D>
std::vector<Twist<D>> forces_of_sides(const Placed<D>& at, const PotentialFlow<D>& flow)
{
    const Coupling<D>& coupling = at.coupling;
    const Grid<D>& grid = *coupling.grid;
    std::vector<Twist<D>> force(flow.twists.size(), Twist<D>::Zero());
    if (!flow.sides.any() || force.empty())
        return force;
    for (std::size_t k = 0; k < at.complex.pieces.size(); ++k) {
        const FacePiece<D>& piece = at.complex.pieces[k];
        const Index<D> face = at.complex.index.index(piece.face);
        if ((piece.low.exists() && piece.high.exists()) || !owns_face(grid, piece.axis, face))
            continue;
        const int end = piece.low.exists(), side = 2 * piece.axis + end;
        const double impulse = flow.sides.impulse[side], out = end ? flow.sides.speed[side] : -flow.sides.speed[side];
        const PartOrCell& inner = end ? piece.low : piece.high;
        const int node = inner.is_part() ? at.node[inner.number()] : -1;
        if ((out == 0 && impulse == 0) || (node < 0 && !at.complex.is_main(inner)))
            continue;
        const double p = node >= 0 ? flow.p.nodes[node]
                                   : flow.p.cells(grid.wrapped(at.complex.index.index(at.complex.cell_of(inner)))),
                     width = grid.dx() * grid.spread(piece.axis, face[piece.axis]),
                     by_area =
                         0.25 * coupling.density * width * out * out - out * p +
                         side_factor(grid, piece.axis, face, end) / (coupling.density * width) * (p - 0.5 * impulse) * impulse;
        for (const PieceRate<D>& rate : at.derivatives.of(static_cast<std::int32_t>(k))) {
            Twist<D> change = grid.face_area() * by_area * rate.area;
            change.template head<D>() /= grid.dx();
            force[rate.solid] += change;
        }
    }
    grid.comm().sum(std::span<double>(force.data()->data(), force.size() * twist_size<D>));
    return force;
}

template <int D>
void add_side_velocities(const Placed<D>& at, const GivenSides<D>& sides, const Vec<D>& stream, FaceField<D>& u)
{
    const Coupling<D>& coupling = at.coupling;
    const Grid<D>& grid = *coupling.grid;
    for (int axis = 0; axis < D; ++axis)
        for (int end = 0; end < 2; ++end) {
            const double impulse = sides.impulse[2 * axis + end];
            const bool inflow = grid.side(axis, end) == SideKind::inflow;
            if (!inflow && impulse == 0)
                continue;
            for_each_face_of_side(grid, axis, end, [&](const Index<D>& f) {
                if (inflow && coupling.open(axis, f) > 0)
                    u(axis, f) = sides.speed[2 * axis + end] + stream[axis];
                else if (coupling.system.conductance(axis, f) > 0)
                    u(axis, f) += (end ? -2 : 2) * impulse / (coupling.density * grid.dx() * grid.spread(axis, f[axis]));
            });
        }
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template SideRow<D> row_of_face<D>(const Placed<D>&, int, const Index<D>&);                                                \
    template std::vector<SideRow<D>> nodes_of_side<D>(const Placed<D>&, int);                                                  \
    template std::array<double, 2 * D> impulses_beyond<D>(const Model<D>&, double);                                            \
    template GivenSides<D> given_sides<D>(const Model<D>&, double);                                                            \
    template UnknownVector<D> outflow_of_sides<D>(const Placed<D>&, const GivenSides<D>&);                                     \
    template void add_inflow<D>(const Placed<D>&, const GivenSides<D>&, FaceField<D>&);                                        \
    template double energy_of_sides<D>(const Placed<D>&, const PotentialFlow<D>&);                                             \
    template std::vector<Twist<D>> forces_of_sides<D>(const Placed<D>&, const PotentialFlow<D>&);                              \
    template void add_side_velocities<D>(const Placed<D>&, const GivenSides<D>&, const Vec<D>&, FaceField<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
