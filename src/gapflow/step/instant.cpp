#include "gapflow/step/instant.hpp"

#include "gapflow/step/covered.hpp"
#include "gapflow/step/given_sides.hpp"
#include "gapflow/step/inner_faces.hpp"
#include "gapflow/step/own_edges.hpp"
#include "gapflow/step/remainder.hpp"
#include "gapflow/step/vorticity.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

namespace gapflow {
namespace {

/// The remainder as the complex takes it.
template <int D>
Circulation<D> in_cells(const Placed<D>& at, const Remainder<D>& remainder)
{
    const Grid<D>& grid = *at.coupling.grid;
    const Complex<D>& complex = at.complex;
    const double dx = grid.dx();
    Circulation<D> result;
    for (int axis = 0; axis < D; ++axis) { // those of other ranks too, to which this one's lend
        result.face[axis].assign(complex.index.count, 0.0);
        const Index<D> known = grid.high() + Index<D>::Constant(grid.ghost());
        for_each_index<D>(complex.index.low, complex.index.faces_end(axis).cwiseMin(known),
                          [&](const Index<D>& f) { result.face[axis][complex.index(f)] = remainder.faces(axis, f) / dx; });
    }
    const auto is_open_face = [&](const FacePiece<D>& piece) {
        const bool inner = piece.low.exists() && piece.high.exists();
        return piece.area > 0 && (inner || is_open(grid.side(piece.axis, piece.low.exists())));
    };
    for (std::size_t k = 0; k < complex.pieces.size(); ++k) {
        const FacePiece<D>& piece = complex.pieces[k];
        const Index<D> f = complex.index.index(piece.face);
        if (const std::int32_t edge = at.edges.edge_of_piece[k]; edge >= 0)
            result.piece.push_back(remainder.edges[edge] / (dx * face_length(grid, piece.axis, f)));
        else if (complex.joins_main(piece) || (!owns_face(grid, piece.axis, f) && is_open_face(piece)))
            result.piece.push_back(result.face[piece.axis][complex.index(complex.index.wrapped(f))]);
        else
            result.piece.push_back(0.0);
    }
    for (const std::int32_t edge : at.edges.edge_of_link)
        result.link.push_back(edge >= 0 ? remainder.edges[edge] / (dx * dx) : 0.0);
    return result;
}

template <int D>
bool is_inflow(const Grid<D>& grid, int axis, const Index<D>& face)
{
    const int place = face[axis];
    return (place == 0 && grid.side(axis, 0) == SideKind::inflow) ||
           (place == grid.cells()[axis] && grid.side(axis, 1) == SideKind::inflow);
}

/// On open faces, those of inflow too.
template <int D>
void add_stream(const Instant<D>& instant, double factor, FaceField<D>& u)
{
    const Grid<D>& grid = *instant.placed->coupling.grid;
    for (int axis = 0; axis < D; ++axis)
        if (const double speed = factor * instant.stream[axis]; speed != 0)
            for_each_index<D>(grid.low(), grid.high() + step<D>(axis), [&](const Index<D>& f) {
                if (instant.placed->coupling.system.conductance(axis, f) > 0 || is_inflow(grid, axis, f))
                    u(axis, f) += speed;
            });
}

/// Of -w . W V, W V the solids' flux through what they cover: as their centres move, about which they turn.
template <int D>
void add_arms(const Placed<D>& at, const FaceField<D>& w, const std::vector<Twist<D>>& twists, std::vector<Twist<D>>& force)
{
    const Grid<D>& grid = *at.coupling.grid;
    std::vector<Twist<D>> sum(force.size(), Twist<D>::Zero());
    for (const CarriedFlux<D>& of : at.edges.covered) {
        const double momentum = at.coupling.density * face_length(grid, of.axis, of.face) * w(of.axis, of.face);
        const Spin<D> spin = twists[of.solid].template tail<spin_size<D>>();
        sum[of.solid].template head<D>() -= momentum * of.flux[of.axis] * spin_velocity<D>(spin, unit<D>(of.axis));
    }
    if (!sum.empty())
        grid.comm().sum(std::span<double>(sum.data()->data(), sum.size() * twist_size<D>));
    for (std::size_t s = 0; s < force.size(); ++s)
        force[s] += sum[s];
}

/// Arms, and the plain faces that lead to voids as arms without energy: nothing there is differentiated.
template <int D>
std::vector<GapArm<D>> arms_and_empty_faces(const Placed<D>& at)
{
    const Complex<D>& complex = at.complex;
    std::vector<GapArm<D>> arms = at.arms;
    std::vector<char> is_arm(complex.pieces.size(), 0);
    for (const GapArm<D>& arm : arms)
        is_arm[arm.piece] = 1;
    for (std::size_t k = 0; k < complex.pieces.size(); ++k)
        for (const PartOrCell& side : {complex.pieces[k].low, complex.pieces[k].high})
            if (!is_arm[k] && side.exists() && at.voids.is_void(site_of(complex, side))) {
                GapArm<D> empty{};
                empty.piece = static_cast<std::int32_t>(k);
                empty.share = 1;
                empty.resistance = std::numeric_limits<double>::infinity();
                empty.flux.setZero();
                empty.motion.setZero();
                empty.mass.setZero();
                arms.push_back(empty);
                is_arm[k] = 1;
            }
    std::sort(arms.begin(), arms.end(), [](const GapArm<D>& x, const GapArm<D>& y) { return x.piece < y.piece; });
    return arms;
}

/// A grid that goes with a body: where this and the grid are displaced, T changes as where all other solids and vorticity are displaced the other way.
template <int D>
void take_grid_along(Instant<D>& instant)
{
    const auto& [body, axes] = instant.followed;
    for (int axis = 0; axis < D && body >= 0; ++axis) {
        const auto of_both = [&](const Displaced<D>& one) { return one.solid == body && one.component == axis; };
        if (!axes[axis])
            continue;
        double& force = instant.force[body][axis];
        if (std::none_of(instant.displaced.begin(), instant.displaced.end(), of_both)) {
            double others = 0;
            for (int s = 0; s < static_cast<int>(instant.force.size()); ++s)
                others += s == body ? 0.0 : instant.force[s][axis];
            force = -others;
        }
        if (instant.flow.remainder.empty())
            continue;
        const ForceOfGrid<D> more = force_of_grid(instant.placed->coupling, instant.flux, instant.flow.remainder.faces, axis);
        force += more.of_remainder + more.of_sides;
        instant.of_sides[axis] = more.of_sides;
    }
}

/// The velocity of a grid that goes with its body.
template <int D>
Vec<D> velocity_of_grid(const Instant<D>& instant)
{
    Vec<D> velocity = Vec<D>::Zero();
    for (int axis = 0; axis < D && instant.followed.body >= 0; ++axis)
        if (instant.followed.axes[axis])
            velocity[axis] = instant.flow.twists[instant.followed.body][axis] + instant.stream[axis];
    return velocity;
}

/// What edges have beside their faces, `own`, stays with them where the grid moves: dR/dx has no part that is linear in it and in a uniform motion with the grid. That part,
/// to be taken out.
template <int D>
void take_own_along(const Instant<D>& instant, const GapDerivatives<D>* gaps, const std::vector<double>& own,
                    std::vector<Twist<D>>& force)
{
    const Placed<D>& at = *instant.placed;
    const Grid<D>& grid = *at.coupling.grid;
    const Vec<D> velocity = velocity_of_grid(instant);
    if (own.empty() || velocity.isZero(0))
        return;
    const std::vector<Twist<D>> V(force.size(), stream_twist<D>(velocity));
    const UnknownVector<D> rest{CellField<D>(grid), Eigen::VectorXd::Zero(at.coupling.system.nodes)};
    FaceField<D> uniform(grid);
    for (int axis = 0; axis < D; ++axis)
        uniform[axis].fill(velocity[axis]);
    for (const double sign : {-1.0, 1.0}) {
        Remainder<D> remainder = remainder_of(at, uniform);
        for (std::size_t e = 0; e < own.size(); ++e)
            remainder.edges[e] += sign * own[e];
        Circulation<D> circulation = in_cells(at, remainder);
        circulation.covered.assign(force.size(), stream_twist<D>(Vec<D>(velocity / grid.dx())));
        const std::vector<Twist<D>> of_both =
            energy_derivative<D>(at.coupling, at.complex, at.derivatives, rest, V, gaps, at.pairs, {}, &circulation);
        for (std::size_t s = 0; s < force.size(); ++s)
            force[s] -= 0.5 * sign * of_both[s];
    }
}

} // namespace

template <int D>
void find_forces(Instant<D>& instant)
{
    const Placed<D>& at = *instant.placed;
    const std::vector<Twist<D>>& V = instant.flow.twists;
    instant.impulse = fluid_impulse(at, instant.flow);
    const bool rotational = !instant.flow.remainder.empty();
    Circulation<D> circulation;
    std::vector<Twist<D>> moving;
    if (rotational) {
        circulation = in_cells(at, instant.flow.remainder);
        for (std::size_t s = 0; s < V.size(); ++s) {
            moving.push_back(moving_walls(at.coupling.solids[s], V[s]));
            circulation.covered.push_back(moving.back());
            circulation.covered.back().template head<D>() /= at.coupling.grid->dx();
        }
    }
    std::vector<GapArm<D>> arms; // with voids
    std::optional<GapDerivatives<D>> with_voids;
    const GapDerivatives<D>* gaps = at.gaps.get();
    if (at.voids.any()) {
        arms = arms_and_empty_faces(at);
        gaps = &with_voids.emplace(*at.coupling.grid, at.coupling.solids, at.complex, arms);
    }
    instant.force =
        energy_derivative<D>(at.coupling, at.complex, at.derivatives, instant.flow.p, V, gaps, at.pairs,
                             instant.followed.body >= 0 ? std::vector<char>{} : not_replaced(instant.displaced, V.size()),
                             rotational ? &circulation : nullptr);
    if (rotational) {
        instant.flux = face_fluxes(at, instant.flow);
        add_arms(at, instant.flow.remainder.faces, moving, instant.force);
        take_own_along(instant, gaps, own_along_edges(at, instant.flow.remainder), instant.force);
    }
    const std::vector<Twist<D>> of_sides = forces_of_sides(at, instant.flow);
    for (std::size_t s = 0; s < V.size(); ++s)
        instant.force[s] += of_sides[s];
    replace_forces(instant.displaced, instant.flow, instant.force);
    take_grid_along(instant);
    instant.energy = (rotational ? 0.5 * work_of_fluxes(at.coupling, instant.flux, instant.flow.remainder.faces) : 0) +
                     energy_of_sides(at, instant.flow);
    if (const std::vector<double> own = own_along_edges(at, instant.flow.remainder); !own.empty()) {
        const std::vector<double> through = edge_fluxes(at, instant.flow).edge;
        for (std::size_t e = 0; e < own.size(); ++e)
            instant.energy += 0.5 * at.coupling.density * own[e] * through[e];
    }
    if (at.voids.any() || (rotational && !at.voids.parts.empty())) { // L p + K V is what flows into voids, or did
        const UnknownVector<D> out = net_outflow(instant, face_velocities(instant));
        const Grid<D>& grid = *at.coupling.grid;
        double sum = 0;
        for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) { sum += instant.flow.p.cells(c) * out.cells(c); });
        instant.energy += 0.5 * (sum + instant.flow.p.nodes.dot(out.nodes));
    }
    for (std::size_t s = 0; s < V.size(); ++s) {
        instant.energy += 0.5 * V[s].dot(instant.impulse[s]);
        if constexpr (D == 3) {
            const gapflow::Vec<3> omega = V[s].template tail<3>(), L = instant.impulse[s].template tail<3>();
            instant.force[s].template tail<3>() += omega.cross(L);
        }
    }
}

template <int D>
Instant<D> instant_of(const Model<D>& model, const std::vector<RigidBody<D>>& bodies, std::unique_ptr<Placed<D>> placed,
                      PotentialFlow<D> flow, const Vec<D>& stream)
{
    std::vector<Displaced<D>> aside;
    if (!placed->voids.any()) // else their energies would not know them
        aside = displaced(model, bodies, *placed);
    Instant<D> instant{std::move(placed), std::move(aside), stream, std::move(flow), {}, {}};
    instant.followed = followed_body(model);
    find_forces(instant);
    return instant;
}

template <int D>
FluidVelocity<D> face_velocities(const Instant<D>& instant)
{
    FluidVelocity<D> u;
    u.grid = instant.flow.remainder.empty() ? FaceField<D>(*instant.placed->coupling.grid) : instant.flow.remainder.faces;
    UnknownVector<D> p = instant.flow.p;
    subtract_gradient(instant.placed->coupling, p, u);
    add_stream(instant, 1, u.grid);
    add_side_velocities(*instant.placed, instant.flow.sides, instant.stream, u.grid);
    return u;
}

template <int D>
UnknownVector<D> net_outflow(const Instant<D>& instant, const FluidVelocity<D>& velocity)
{
    const Coupling<D>& coupling = instant.placed->coupling;
    const Grid<D>& grid = *coupling.grid;
    const UnknownVector<D>& p = instant.flow.p;
    UnknownVector<D> rest;
    FluidVelocity<D> relative{velocity.grid, {}, {}, {}};
    add_stream(instant, -1, relative.grid);
    outflow(coupling, relative, instant.flow.twists, rest);
    if (instant.flow.sides.any())
        rest.nodes += outflow_of_sides(*instant.placed, instant.flow.sides).nodes;
    if (!instant.flow.remainder.empty())
        add_to(rest, outflow_of_edges(*instant.placed, instant.flow.remainder));
    Eigen::VectorXd nodes = Eigen::VectorXd::Zero(coupling.system.nodes);
    for (int i = 0; i < coupling.system.nodes; ++i)
        if (coupling.system.owns(i))
            for (Eigen::SparseMatrix<double>::InnerIterator entry(coupling.system.film, i); entry; ++entry)
                nodes[i] += entry.value() * p.nodes[entry.row()];
    std::vector<double> drop(coupling.system.links.size(), 0.0);
    for (std::size_t k = 0; k < drop.size(); ++k)
        for (const auto& [key, weight] : coupling.system.links[k].cells)
            if (const Index<D> c = grid.cell_of_key(key); grid.owns(c))
                drop[k] += weight * p.cells(c);
    grid.comm().sum(drop);
    grid.comm().sum(std::span<double>(nodes.data(), nodes.size()));
    rest.nodes += nodes;
    for (std::size_t k = 0; k < drop.size(); ++k) {
        const Link& link = coupling.system.links[k];
        for (const auto& [node, weight] : link.nodes)
            drop[k] += weight * p.nodes[node];
        for (const auto& [node, weight] : link.nodes)
            rest.nodes[node] += link.conductance * weight * drop[k];
        for (const auto& [key, weight] : link.cells)
            if (const Index<D> c = grid.cell_of_key(key); grid.owns(c))
                rest.cells(c) += link.conductance * weight * drop[k];
    }
    return rest;
}

template <int D>
double largest_divergence(const Instant<D>& instant, const FluidVelocity<D>& velocity)
{
    const Grid<D>& grid = *instant.placed->coupling.grid;
    const UnknownVector<D> rest = instant.left_outflow.cells.size() > 0 ? instant.left_outflow : net_outflow(instant, velocity);
    double worst = rest.nodes.size() ? rest.nodes.cwiseAbs().maxCoeff() : 0.0;
    for_each_index<D>(grid.low(), grid.high(),
                      [&](const Index<D>& c) { worst = std::max(worst, std::abs(rest.cells(c)) / grid.relative_volume(c)); });
    return grid.comm().max(worst) / std::pow(grid.dx(), D);
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template void find_forces<D>(Instant<D>&);                                                                                 \
    template Instant<D> instant_of<D>(const Model<D>&, const std::vector<RigidBody<D>>&, std::unique_ptr<Placed<D>>,           \
                                      PotentialFlow<D>, const Vec<D>&);                                                        \
    template FluidVelocity<D> face_velocities<D>(const Instant<D>&);                                                           \
    template double largest_divergence<D>(const Instant<D>&, const FluidVelocity<D>&);                                         \
    template UnknownVector<D> net_outflow<D>(const Instant<D>&, const FluidVelocity<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
