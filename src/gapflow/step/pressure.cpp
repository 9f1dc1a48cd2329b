#include "gapflow/step/pressure.hpp"

#include "gapflow/step/gap_speed.hpp"
#include "gapflow/step/matching.hpp"

namespace gapflow {
namespace {

/// Mean square of the velocity in a cell, seen from a frame: of the means over the two faces along each axis, those that are open.
template <int D>
double square_of_speed(const CoupledSystem<D>& system, const FaceField<D>& u, const Index<D>& c, const Vec<D>& frame)
{
    double sum = 0;
    for (int axis = 0; axis < D; ++axis) {
        double squares = 0;
        int open = 0;
        for (int end = 0; end < 2; ++end)
            if (const Index<D> f = c + end * step<D>(axis); system.conductance(axis, f) > 0) {
                squares += (u(axis, f) - frame[axis]) * (u(axis, f) - frame[axis]);
                ++open;
            }
        if (open > 0)
            sum += squares / open;
    }
    return sum;
}

} // namespace

template <int D>
UnknownVector<D> pressure_impulse(const Instant<D>& before, const FaceField<D>& velocity_before, const Instant<D>& after,
                                  const FaceField<D>& velocity_after, const Vec<D>& grid_velocity, double dt)
{
    const Coupling<D>&old = before.placed->coupling, &here = after.placed->coupling;
    const Grid<D>& grid = *here.grid;
    UnknownVector<D> impulse{CellField<D>(grid), Eigen::VectorXd::Zero(here.system.nodes)};
    CellField<D, std::int8_t> known(grid, std::int8_t(0));
    const Complex<D>& complex = after.placed->complex;
    const std::vector<double> was_square = squares_in_gaps(before, grid_velocity),
                              is_square = squares_in_gaps(after, grid_velocity);
    const double of_stream =
        0.5 * ((before.stream - grid_velocity).squaredNorm() + (after.stream - grid_velocity).squaredNorm());
    /// In a cell, of its largest part where this lies in a gap.
    const auto square_at = [&](const Instant<D>& at, const std::vector<double>& in_gaps, const FaceField<D>& u,
                               const Index<D>& c) {
        const PartOrCell main = at.placed->complex.main_of(at.placed->complex.index(c));
        const double square = main.is_part() ? in_gaps[main.number()] : -1.0;
        return square >= 0 ? square : square_of_speed(at.placed->coupling.system, u, c, grid_velocity);
    };
    const auto has = [](const Coupling<D>& c, const Index<D>& cell) { return c.system.component(cell) >= 0; };
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
        if (!has(here, c) || !has(old, c))
            return;
        const double square =
            0.5 * (square_at(before, was_square, velocity_before, c) + square_at(after, is_square, velocity_after, c)) -
            of_stream;
        impulse.cells(c) = after.flow.p.cells(c) - before.flow.p.cells(c) - 0.5 * dt * here.density * square;
        known(c) = 1;
    });
    exchange(grid, impulse.cells, 1);
    exchange(grid, known, 1);
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
        if (!has(here, c) || known(c))
            return;
        double sum = 0;
        int count = 0;
        for (int axis = 0; axis < D; ++axis)
            for (int side = 0; side < 2; ++side)
                if (const Index<D> next = c + (2 * side - 1) * step<D>(axis);
                    here.system.conductance(axis, Index<D>(c + side * step<D>(axis))) > 0 &&
                    grid.in_domain(grid.wrapped(next)) && known(next)) {
                    sum += impulse.cells(next);
                    ++count;
                }
        impulse.cells(c) = count > 0 ? sum / count : 0.0;
    });
    const std::vector<MatchedPart> was = matched_parts(grid, complex, before.placed->complex);
    for (int p = 0; p < complex.parts(); ++p) {
        const int node = after.placed->node[p];
        if (node < 0 || !here.system.owns(node))
            continue;
        const Index<D> c = complex.cell_of_part(p);
        double square = is_square[p] - of_stream; // of a gap; of other small parts not known
        if (was[p].kind == MatchedPart::Kind::other && before.placed->node[was[p].part] >= 0) {
            impulse.nodes[node] = after.flow.p.nodes[node] - before.flow.p.nodes[before.placed->node[was[p].part]];
            if (was_square[was[p].part] >= 0)
                square = 0.5 * (is_square[p] + was_square[was[p].part]) - of_stream;
        } else if (was[p].kind == MatchedPart::Kind::main && has(old, c))
            impulse.nodes[node] = after.flow.p.nodes[node] - before.flow.p.cells(c);
        else {
            if (has(here, c))
                impulse.nodes[node] = impulse.cells(c);
            continue;
        }
        if (is_square[p] >= 0)
            impulse.nodes[node] -= 0.5 * dt * here.density * square;
    }
    grid.comm().sum(std::span<double>(impulse.nodes.data(), impulse.nodes.size()));
    return impulse;
}

template UnknownVector<2> pressure_impulse<2>(const Instant<2>&, const FaceField<2>&, const Instant<2>&, const FaceField<2>&,
                                              const Vec<2>&, double);
template UnknownVector<3> pressure_impulse<3>(const Instant<3>&, const FaceField<3>&, const Instant<3>&, const FaceField<3>&,
                                              const Vec<3>&, double);

} // namespace gapflow
