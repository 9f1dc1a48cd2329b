// The flow beside voids at a scene's start, and the pairs' states.
#include "gapflow/step/given_sides.hpp"
#include "gapflow/step/remainder.hpp"
#include "gapflow/step/void_solve.hpp"

#include <algorithm>
#include <limits>
#include <map>

namespace gapflow {

template <int D>
PotentialFlow<D> flow_beside_voids(const Placed<D>& at, std::vector<Twist<D>> twists, const SolverOptions& options,
                                   Remainder<D> remainder, const GivenSides<D>& sides)
{
    Coupling<D> coupling = *at.voids.all;
    UnknownVector<D> outflow{CellField<D>(*coupling.grid), Eigen::VectorXd::Zero(coupling.system.nodes)};
    std::map<long, double> given;
    for (const VoidPart<D>& part : at.voids.parts)
        if (at.voids.is_void(part.part))
            given[part.row] = 0;
    take_rows_out(coupling, given, &outflow);
    if (!remainder.empty())
        add_to(outflow, outflow_of_remainder(at, remainder));
    if (sides.any())
        add_to(outflow, outflow_of_sides(at, sides));
    PotentialFlow<D> flow =
        flow_with_outflow<D>(at.complex, std::move(coupling), std::move(twists), std::move(outflow), options, nullptr);
    flow.remainder = std::move(remainder);
    flow.sides = sides;
    return flow;
}

template <int D>
void add_void_states(const Model<D>& model, const Placed<D>& at, const State<D>& state, const PartVoids& voids,
                     std::vector<GapState>& gaps)
{
    const Grid<D>& grid = model.grid;
    const long cells = grid.cells().template cast<long>().prod();
    std::map<std::pair<int, int>, GapState> states;
    for (const VoidPart<D>& part : at.voids.parts) {
        const auto [found, is_new] = states.try_emplace(std::minmax(part.a, part.b));
        GapState& gap = found->second;
        const double impulse = part.row < cells ? state.pressure.impulse.cells(grid.cell_of_key(part.row))
                                                : state.pressure.impulse.nodes[part.row - cells],
                     pressure = (state.dt > 0 ? impulse / state.dt : 0.0) + model.hydrostatic(part.place);
        if (is_new) {
            gap.body_a = at.coupling.solids[found->first.first].name;
            gap.body_b = at.coupling.solids[found->first.second].name;
            gap.thickness = std::numeric_limits<double>::infinity();
            gap.pressure_min = gap.pressure_max = pressure;
        }
        gap.thickness = std::min(gap.thickness, part.thickness);
        gap.film_area += part.area;
        gap.force += pressure * part.area;
        gap.pressure_min = std::min(gap.pressure_min, pressure);
        gap.pressure_max = std::max(gap.pressure_max, pressure);
        gap.void_volume += voids.is_void(part.part) ? voids.volume[part.part] : 0.0;
    }
    for (const GapArm<D>& arm : own_arms(at)) { // the rate where the gap is thinnest
        const auto found = states.find(std::minmax(arm.solid[0], arm.solid[1]));
        if (found == states.end() || grid.dx() * arm.thickness > found->second.thickness * (1 + 1e-9))
            continue;
        PairTwist<D> twist;
        const std::vector<Twist<D>> V = model.twists(state.bodies);
        for (int side = 0; side < 2; ++side) {
            Twist<D> own = V[arm.solid[side]];
            own.template head<D>() /= grid.dx();
            twist.template segment<twist_size<D>>(side * twist_size<D>) = own;
        }
        found->second.opening_rate = grid.dx() * arm.opening.dot(twist);
    }
    for (auto& [pair, gap] : states) {
        const auto same = std::find_if(gaps.begin(), gaps.end(), [&](const GapState& other) {
            return other.body_a == gap.body_a && other.body_b == gap.body_b;
        });
        if (same == gaps.end()) {
            gaps.push_back(gap);
            continue;
        }
        gap.thickness = same->thickness; // of contacts: exact
        gap.opening_rate = same->opening_rate;
        gap.contact_force = same->contact_force;
        gap.contact_impulse = same->contact_impulse;
        *same = gap;
    }
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template PotentialFlow<D> flow_beside_voids<D>(const Placed<D>&, std::vector<Twist<D>>, const SolverOptions&,           \
                                                   Remainder<D>, const GivenSides<D>&);                                        \
    template void add_void_states<D>(const Model<D>&, const Placed<D>&, const State<D>&, const PartVoids&,                     \
                                     std::vector<GapState>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
