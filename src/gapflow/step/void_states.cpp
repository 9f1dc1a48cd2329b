// The flow beside voids at a scene's start, and the pairs' states.
#include "gapflow/step/given_sides.hpp"
#include "gapflow/step/inner_faces.hpp"
#include "gapflow/step/remainder.hpp"
#include "gapflow/step/void_solve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
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
std::vector<double> squares_of_speed(const Placed<D>& at, const PotentialFlow<D>& flow, const std::vector<double>& drop)
{
    const UnknownVector<D>& p = flow.p;
    const Grid<D>& grid = *at.coupling.grid;
    const Complex<D>& complex = at.complex;
    const auto value = [&](const PartOrCell& side) {
        const int node = side.is_part() ? at.node[side.number()] : -1;
        return node >= 0 ? p.nodes[node] : p.cells(grid.wrapped(complex.index.index(complex.cell_of(side))));
    };
    std::map<std::int32_t, double> along; // by pieces
    for (std::size_t e = 0; e < drop.size(); ++e)
        if (const VoidEdge<D>& edge = at.voids.edges[e]; edge.piece >= 0)
            along[edge.piece] = edge.conductance * drop[e] / edge.area;
    std::vector<double> narrowed(complex.pieces.size(), 1.0); // flux over that of a duct with the face's area
    for (const GapArm<D>& arm : at.voids.arms)
        if (const FacePiece<D>& piece = complex.pieces[arm.piece]; piece.area > 0)
            narrowed[arm.piece] = std::min(1.0, grid.spread(piece.axis, complex.index.index(piece.face)[piece.axis]) /
                                                    (arm.resistance * piece.area));
    const auto is_void = [&](const PartOrCell& side) { return side.exists() && at.voids.is_void(site_of(complex, side)); };
    std::vector<std::array<double, D>> sum(complex.parts(), std::array<double, D>{});
    std::vector<std::array<int, D>> count(complex.parts(), std::array<int, D>{});
    for (std::size_t k = 0; k < complex.pieces.size(); ++k) {
        const FacePiece<D>& piece = complex.pieces[k];
        if (!(piece.area > 0) || !piece.low.exists() || !piece.high.exists())
            continue;
        const auto edge = along.find(static_cast<std::int32_t>(k));
        if (edge == along.end() && (is_void(piece.low) || is_void(piece.high)))
            continue;
        const Index<D> f = complex.index.index(piece.face);
        const double way = grid.dx() * grid.spread(piece.axis, f[piece.axis]);
        double momentum = value(piece.low) - value(piece.high);
        if (!flow.remainder.empty())
            momentum += at.coupling.density * (at.edges.edge_of_piece[k] >= 0
                                                   ? flow.remainder.edges[at.edges.edge_of_piece[k]]
                                                   : face_length(grid, piece.axis, f) * flow.remainder.faces(piece.axis, f));
        const double u = edge != along.end() ? edge->second : narrowed[k] * momentum / (way * at.coupling.density);
        for (const PartOrCell& side : {piece.low, piece.high})
            if (side.is_part()) {
                sum[side.number()][piece.axis] += u * u;
                ++count[side.number()][piece.axis];
            }
    }
    std::vector<double> square(count_sites(complex), 0.0);
    for (int part = 0; part < complex.parts(); ++part)
        for (int axis = 0; axis < D; ++axis)
            if (count[part][axis] > 0)
                square[part] += sum[part][axis] / count[part][axis];
    return square;
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

template std::vector<double> squares_of_speed<2>(const Placed<2>&, const PotentialFlow<2>&, const std::vector<double>&);
template std::vector<double> squares_of_speed<3>(const Placed<3>&, const PotentialFlow<3>&, const std::vector<double>&);
#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template PotentialFlow<D> flow_beside_voids<D>(const Placed<D>&, std::vector<Twist<D>>, const SolverOptions&,              \
                                                   Remainder<D>, const GivenSides<D>&);                                        \
    template void add_void_states<D>(const Model<D>&, const Placed<D>&, const State<D>&, const PartVoids&,                     \
                                     std::vector<GapState>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
