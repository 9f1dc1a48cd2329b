#include "gapflow/step/gap_speed.hpp"

#include "gapflow/complex/gap_surface.hpp"

#include <algorithm>

namespace gapflow {
namespace {

/// From the first wall to the second one, by the rates of its opening; sides of the domain have none.
template <int D>
Vec<D> normal_of(const GapArm<D>& arm)
{
    return arm.opening.template segment<D>(twist_size<D>) - arm.opening.template head<D>();
}

} // namespace

template <int D>
UnknownVector<D> potentials_around(const Instant<D>& instant)
{
    UnknownVector<D> p = instant.flow.p;
    exchange(*instant.placed->coupling.grid, p.cells, 1);
    return p;
}

template <int D>
double velocity_through(const Instant<D>& instant, const UnknownVector<D>& p, const GapArm<D>& arm)
{
    const Placed<D>& at = *instant.placed;
    const Grid<D>& grid = *at.coupling.grid;
    const double dx = grid.dx(), density = at.coupling.density;
    const FacePiece<D>& piece = at.complex.pieces[arm.piece];
    const Index<D> face = at.complex.index.index(piece.face);
    const double delta = grid.spread(piece.axis, face[piece.axis]);
    PairTwist<D> V;
    for (int side = 0; side < 2; ++side) {
        Twist<D> twist = instant.flow.twists[arm.solid[side]];
        twist.template head<D>() /= dx;
        V.template segment<twist_size<D>>(side * twist_size<D>) = twist;
    }
    double drop = (value_of(at, p, piece.low) - value_of(at, p, piece.high)) / (density * dx * dx);
    if (const Remainder<D>& w = instant.flow.remainder; !w.empty()) {
        const std::int32_t edge = at.edges.edge_of_piece[arm.piece];
        drop += edge >= 0 ? w.edges[edge] / (dx * dx) : w.faces(piece.axis, face) / dx * delta;
    }
    const double U = arm.motion.dot(V);
    return dx * ((drop - arm.flux.dot(V) - delta * U) / (arm.resistance * piece.area) + U);
}

template <int D>
std::map<std::tuple<int, int, std::int32_t>, Through<D>> flow_through_gaps(const Instant<D>& instant)
{
    const Placed<D>& at = *instant.placed;
    const Grid<D>& grid = *at.coupling.grid;
    std::map<std::tuple<int, int, std::int32_t>, Through<D>> through;
    const UnknownVector<D> p = potentials_around(instant);
    for (const GapArm<D>& arm : at.arms) {
        if (!is_of_gap(arm))
            continue;
        const bool swapped = arm.solid[1] < arm.solid[0];
        const FacePiece<D>& piece = at.complex.pieces[arm.piece];
        for (const PartOrCell& side : {piece.low, piece.high})
            if (side.is_part() && grid.owns(at.complex.cell_of_part(side.number()))) {
                Through<D>& sum = through[{arm.solid[swapped], arm.solid[!swapped], side.number()}];
                sum.square(piece.axis, piece.axis) += piece.area;
                sum.sum[piece.axis] += piece.area * (velocity_through(instant, p, arm) + instant.stream[piece.axis]);
                sum.normal += piece.area * (swapped ? -1 : 1) * normal_of(arm);
            }
    }
    return through;
}

template <int D>
std::vector<double> squares_in_gaps(const Instant<D>& instant, const Vec<D>& frame)
{
    std::vector<double> squares(instant.placed->complex.parts(), -1.0);
    for (const auto& [key, through] : flow_through_gaps(instant))
        if (const double size = through.normal.norm(); size > 0)
            squares[std::get<2>(key)] = (through.along(through.normal / size) - frame).squaredNorm();
    return squares;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template UnknownVector<D> potentials_around<D>(const Instant<D>&);                                                         \
    template double velocity_through<D>(const Instant<D>&, const UnknownVector<D>&, const GapArm<D>&);                         \
    template std::map<std::tuple<int, int, std::int32_t>, Through<D>> flow_through_gaps<D>(const Instant<D>&);                 \
    template std::vector<double> squares_in_gaps<D>(const Instant<D>&, const Vec<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
