// The end of a step with voids: their volumes, fluxes into them, and the flow in what they leave.
#include "gapflow/core/error.hpp"
#include "gapflow/solver/solver.hpp"
#include "gapflow/step/void_solve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace gapflow {
namespace {

/// Flux of a gap's arm that its walls carry along, in the world's units.
template <int D, class Arm>
double carried(double dx, const Arm& arm, const PairTwist<D>& flux, const std::vector<Twist<D>>& twists)
{
    double sum = 0;
    for (int side = 0; side < 2; ++side) {
        Twist<D> own = twists[arm.solid[side]];
        own.template tail<spin_size<D>>() *= dx;
        sum += flux.template segment<twist_size<D>>(side * twist_size<D>).dot(own);
    }
    return std::pow(dx, D - 1) * sum;
}

/// Flux along an edge that leads to no void.
template <int D>
double flux_of_walls(const Placed<D>& at, const VoidEdge<D>& edge, const std::vector<Twist<D>>& twists)
{
    const double dx = at.coupling.grid->dx();
    if (edge.mouth >= 0) {
        const MouthArm<D>& mouth = at.voids.mouths[edge.mouth];
        return carried<D>(dx, mouth, PairTwist<D>(-mouth.flux / mouth.resistance), twists);
    }
    const auto arm = std::lower_bound(at.voids.arms.begin(), at.voids.arms.end(), edge.piece,
                                      [](const GapArm<D>& a, std::int32_t piece) { return a.piece < piece; });
    if (arm == at.voids.arms.end() || arm->piece != edge.piece)
        return 0;
    const FacePiece<D>& piece = at.complex.pieces[edge.piece];
    const double change =
        at.coupling.grid->spread(piece.axis, at.complex.index.index(piece.face)[piece.axis]) / arm->resistance - piece.area;
    return carried<D>(dx, *arm, PairTwist<D>(-arm->flux / arm->resistance - change * arm->motion), twists);
}

/// Of potentials that are those of another flow in components whose level nothing gives: the mean stays.
template <int D>
void keep_levels(const Coupling<D>& coupling, const UnknownVector<D>& before, UnknownVector<D>& p)
{
    const CoupledSystem<D>& system = coupling.system;
    std::vector<double> shift(system.components.size(), 0.0), count(system.components.size(), 0.0);
    const auto each = [&](auto&& f) {
        for_each_index<D>(coupling.grid->low(), coupling.grid->high(), [&](const Index<D>& c) {
            if (const int k = system.component(c); k >= 0 && !system.components[k].grounded)
                f(k, before.cells(c), p.cells(c));
        });
        for (int node = 0; node < system.nodes; ++node)
            if (const int k = system.node_component[node]; k >= 0 && !system.components[k].grounded)
                f(k, before.nodes[node], p.nodes[node]);
    };
    each([&](int k, double was, double is) {
        shift[k] += was - is;
        ++count[k];
    });
    each([&](int k, double, double& value) { value += shift[k] / count[k]; });
}

/// The potentials of rows.
template <int D>
class RowsOf {
public:
    RowsOf(const Grid<D>& grid) : grid_(grid), cells_(grid.cells().template cast<long>().prod()) {}
    double& at(UnknownVector<D>& p, long row) const
    {
        return row < cells_ ? p.cells(grid_.cell_of_key(row)) : p.nodes[row - cells_];
    }
    double at(const UnknownVector<D>& p, long row) const
    {
        return row < cells_ ? p.cells(grid_.cell_of_key(row)) : p.nodes[row - cells_];
    }

private:
    const Grid<D>& grid_;
    long cells_;
};

using EdgeKey = std::tuple<std::int32_t, std::int32_t, long>;

template <int D>
EdgeKey key_of(const VoidEdge<D>& edge)
{
    return {edge.piece, edge.mouth, edge.face};
}

/// Fluxes along the edges of the voids that there are now, over their open conductances. `known`: of those that there were.
template <int D>
std::vector<double> drops_at_end(const Placed<D>& at, const std::map<EdgeKey, double>& known, const PotentialFlow<D>& flow)
{
    const RowsOf<D> rows(*at.coupling.grid);
    std::vector<double> drop;
    for (const VoidEdge<D>& edge : at.voids.edges) {
        if (const auto found = known.find(key_of(edge)); found != known.end()) {
            drop.push_back(found->second / edge.open());
            continue;
        }
        double sum = flux_of_walls(at, edge, flow.twists) / edge.conductance; // of fluid in the step
        for (const auto& [row, weight] : edge.rows)
            sum += weight * rows.at(flow.p, row);
        drop.push_back(sum);
    }
    return drop;
}

/// The potential flow with fluxes that are given along the edges of voids and into rows that were voids.
template <int D>
void join(const Model<D>& model, const Placed<D>& there, const std::vector<double>& drop, const std::map<long, double>& filled,
          PotentialFlow<D>& flow)
{
    const Voids<D>& voids = there.voids;
    const RowsOf<D> rows(model.grid);
    Coupling<D> coupling = *voids.all;
    UnknownVector<D> out{CellField<D>(model.grid), Eigen::VectorXd::Zero(coupling.system.nodes)}; // that is not of the pressure
    coupling.system.links.resize(coupling.system.links.size() - voids.edges.size());
    std::map<long, double> empty;
    for (const VoidPart<D>& part : voids.parts)
        if (voids.is_void(part.part))
            empty[part.row] = 0;
    take_rows_out(coupling, empty, &out);
    const auto add = [&](long row, double value) {
        if (!empty.contains(row))
            rows.at(out, row) += value;
    };
    for (std::size_t e = 0; e < voids.edges.size(); ++e)
        for (const auto& [row, weight] : voids.edges[e].rows)
            add(row, weight * voids.edges[e].open() * drop[e]);
    for (const auto& [row, flux] : filled)
        add(row, -flux);
    const std::vector<Twist<D>> twists = flow.twists;
    flow.p =
        flow_with_outflow(there.complex, std::move(coupling), twists, std::move(out), solver_options(model.scene), &flow.p).p;
}

} // namespace

template <int D>
void change_voids(const Model<D>& model, const std::vector<RigidBody<D>>& bodies, const std::vector<TwistMatrix<D>>& mass,
                  std::vector<double> volume, const std::vector<double>& flux, const std::map<long, double>& filled,
                  Instant<D>& now)
{
    Placed<D>& at = *now.placed;
    std::map<EdgeKey, double> known;
    for (std::size_t e = 0; e < flux.size(); ++e)
        known[key_of(at.voids.edges[e])] = flux[e];
    bool changed = false;
    for (const VoidPart<D>& part : at.voids.parts)
        changed = changed || at.voids.is_void(part.part) != (volume[part.part] > 0);
    now.kept.volume = volume;
    if (changed)
        put_voids(model, bodies, mass, std::move(volume), at);
    now.kept.drop = drops_at_end(at, known, now.flow);
    now.kept.beyond = beyond_gaps(at.voids);
    if (!filled.empty())
        join(model, at, now.kept.drop, filled, now.flow);
    // The potential of a void is 0: it has no momentum, and its walls get none where they pass from one part to another.
    for (const VoidPart<D>& part : at.voids.parts)
        if (at.voids.is_void(part.part))
            RowsOf<D>(model.grid).at(now.flow.p, part.row) = 0;
}

template <int D>
void fill_lost(const Model<D>& model, const std::vector<RigidBody<D>>& bodies, const std::vector<TwistMatrix<D>>& mass,
               const std::vector<std::int32_t>& lost, Instant<D>& old)
{
    const Voids<D>& voids = old.placed->voids;
    std::vector<double> volume = old.kept.volume, flux;
    std::map<long, double> filled;
    for (const std::int32_t site : lost) {
        old.kept.lost += volume[site];
        volume[site] = 0;
        filled[voids.find(site)->row] = 0;
    }
    if (model.viscous()) {
        change_viscous_voids(model, bodies, mass, std::move(volume), std::vector<double>(old.kept.drop), old);
        find_forces(old);
        return;
    }
    for (std::size_t e = 0; e < voids.edges.size(); ++e) {
        flux.push_back(voids.edges[e].open() * old.kept.drop[e]);
        for (const auto& [row, weight] : voids.edges[e].rows)
            if (const auto found = filled.find(row); found != filled.end())
                found->second += weight * flux.back();
    }
    const Coupling<D>& coupling = old.placed->coupling;
    const long cells = model.grid.cells().template cast<long>().prod();
    const auto add_wall = [&](long row, int solid, const Twist<D>& of) {
        if (const auto found = filled.find(row); found != filled.end())
            found->second += of.dot(old.flow.twists[solid]);
    };
    for (const auto& entry : coupling.cell_flux)
        add_wall(model.grid.key(entry.row), entry.body, entry.flux);
    for (const auto& entry : coupling.node_flux)
        add_wall(cells + entry.row, entry.body, entry.flux);
    change_voids(model, bodies, mass, std::move(volume), flux, filled, old);
    find_forces(old);
}

template <int D>
UnknownVector<D> VoidSolve<D>::left_outflow(const Instant<D>& now) const
{
    UnknownVector<D> out = net_outflow(now, face_velocities(now));
    const auto at = [&](long row) -> double& {
        return row < cells_ ? out.cells(model_.grid.cell_of_key(row)) : out.nodes[row - cells_];
    };
    for (std::size_t e = 0; e < head_.size(); ++e)
        for (const auto& [row, weight] : there_.voids.edges[e].rows)
            at(row) += weight * flux(e, now.flow.p);
    for (std::size_t k = 0; k < given_.size(); ++k)
        if (const VoidPart<D>& part = there_.voids.parts[k]; given_[k])
            at(part.row) = 0;
        else if (was_void_[k])
            at(part.row) += there_.voids.volume[part.part] / dt_;
    return out;
}

template <int D>
void VoidSolve<D>::give_pressure(const PotentialFlow<D>& flow, UnknownVector<D>& impulse) const
{
    const std::vector<double> now = squares_of_speed(there_, flow, drops(flow.p));
    for (std::size_t k = 0; k < given_.size(); ++k) {
        const VoidPart<D>& part = there_.voids.parts[k];
        const double head = // as in the bound
            was_void_[k] ? 0.0 : 0.25 * dt_ * there_.coupling.density * (square_[k] + now[part.part]);
        double& value = part.row < cells_ ? impulse.cells(model_.grid.cell_of_key(part.row)) : impulse.nodes[part.row - cells_];
        if (given_[k])
            value = dt_ * part.least_pressure;
        else if (known_[k])
            value = this->value(flow.p, part.row) - past_[k] - head;
    }
}

template <int D>
double VoidSolve<D>::weight_in(std::size_t e, std::size_t part) const
{
    for (const auto& [row, weight] : there_.voids.edges[e].rows)
        if (row == there_.voids.parts[part].row)
            return weight;
    return 0;
}

/// What runs into a void that is full goes on into those beside it, no faster than it came, and so does what overfills it.
template <int D>
void VoidSolve<D>::pass_on(std::vector<double>& volume, std::vector<double>& out, std::vector<double>& flux, double& lost) const
{
    const auto is_full = [&](std::size_t k) { return given_[k] && was_void_[k] && volume[k] <= least_volume(k); };
    std::vector<char> full(volume.size(), 0);
    for (bool again = true; again;) {
        again = false;
        for (std::size_t k = 0; k < volume.size(); ++k) {
            if (full[k] || !is_full(k))
                continue;
            full[k] = 1;
            double ways = 0, ways_in = 0;
            std::vector<std::pair<int, std::size_t>> next;
            for (const std::size_t e : edges_of_[k]) {
                const VoidEdge<D>& edge = there_.voids.edges[e];
                ways_in += weight_in(e, k) * flux[e] < 0 ? edge.permeable * edge.area : 0.0;
                for (const auto& [row, weight] : edge.rows)
                    if (const int other = number(row);
                        other >= 0 && other != static_cast<int>(k) && was_void_[other] && given_[other] && !full[other]) {
                        next.emplace_back(other, e);
                        ways += edge.permeable * edge.area;
                    }
            }
            const double surplus = std::exchange(volume[k], 0.0), inflow = std::max(-out[k], 0.0);
            if (!(ways > 0)) {
                lost += surplus;
                continue;
            }
            for (const auto& [other, e] : next) {
                const double share = there_.voids.edges[e].permeable * there_.voids.edges[e].area / ways;
                const double on = share * inflow * (ways_in > 0 ? std::min(1.0, ways / ways_in) : 0.0);
                volume[other] += share * surplus;
                flux[e] += on / weight_in(e, k);
                out[k] += on;
                out[other] -= on;
                again = again || is_full(other);
            }
        }
    }
}

/// Below which a void is none.
template <int D>
double VoidSolve<D>::least_volume(std::size_t k) const
{
    return 1e-14 * model_.grid.dx() * there_.voids.parts[k].area;
}

template <int D>
void VoidSolve<D>::finish(const std::vector<RigidBody<D>>& bodies, const std::vector<TwistMatrix<D>>& mass, Instant<D>& now)
{
    const std::vector<VoidPart<D>> parts = there_.voids.parts;
    const std::vector<double> growth = outflows(now.flow, true);
    std::vector<double> volume(parts.size(), 0.0), out = outflows(now.flow, false), flux;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const double before = was_void_[k] ? there_.voids.volume[parts[k].part] : 0.0;
        if (given_[k])
            volume[k] = before + dt_ * growth[k];
        else
            out[k] = -before / dt_;
    }
    for (std::size_t e = 0; e < head_.size(); ++e)
        flux.push_back(this->flux(e, now.flow.p));
    const std::vector<double> own = flux;
    pass_on(volume, out, flux, now.kept.lost);
    std::map<long, double> filled; // and their outflow
    std::vector<double> kept(count_sites(there_.complex), 0.0);
    for (std::size_t k = 0; k < parts.size(); ++k)
        if (volume[k] > least_volume(k))
            kept[parts[k].part] = volume[k];
        else if (was_void_[k])
            filled[parts[k].row] = out[k];
    if (model_.viscous()) {
        for (std::size_t e = 0; e < flux.size(); ++e)
            momentum_[e] +=
                (flux[e] - own[e]) / (there_.voids.edges[e].permeable * there_.voids.edges[e].conductance); // a front
        change_viscous_voids(model_, bodies, mass, std::move(kept), momentum_, now);
    } else
        change_voids(model_, bodies, mass, std::move(kept), flux, filled, now);
}

template <int D>
double speed_beside_voids(const Instant<D>& now)
{
    const Voids<D>& voids = now.placed->voids;
    if (!voids.any())
        return 0;
    const std::vector<double> square = squares_of_speed(*now.placed, now.flow, now.kept.drop);
    double largest = 0;
    for (const VoidPart<D>& part : voids.parts)
        largest = std::max(largest, square[part.part]);
    return std::sqrt(largest);
}

template <int D>
PotentialFlow<D> flow_with_outflow(const Complex<D>& complex, Coupling<D> coupling, std::vector<Twist<D>> twists,
                                   UnknownVector<D> outflow, const SolverOptions& options, const UnknownVector<D>* levels)
{
    coupling.system.bodies = 0; // as with_given_twists(), but the voids ground the fluid beside them
    std::fill(coupling.free_body.begin(), coupling.free_body.end(), -1);
    coupling.system.cell_flux.clear();
    coupling.system.node_flux.clear();
    coupling.system.mass.resize(0, 0);
    find_null_space(coupling);
    UnknownVector<D> rhs{CellField<D>(*coupling.grid), Eigen::VectorXd::Zero(coupling.system.nodes)};
    for (long i = 0; i < rhs.cells.size(); ++i)
        rhs.cells.data()[i] = -outflow.cells.data()[i];
    rhs.nodes = -outflow.nodes;
    for (const auto& entry : coupling.cell_flux)
        rhs.cells(entry.row) -= entry.flux.dot(twists[entry.body]);
    for (const auto& entry : coupling.node_flux)
        rhs.nodes[entry.row] -= entry.flux.dot(twists[entry.body]);
    PotentialFlow<D> flow{
        std::move(twists), {CellField<D>(*coupling.grid), Eigen::VectorXd::Zero(coupling.system.nodes)}, 0, {}};
    const SolveReport solve = CoupledSolver<D>(coupling.system, options).solve(flow.p, rhs);
    if (!solve.converged)
        throw ComputationError("the pressure solve did not converge: " + solve.message);
    flow.iterations = solve.iterations;
    if (levels) {
        settle_weak_rows(complex, coupling, outflow, flow);
        keep_levels(coupling, *levels, flow.p);
    }
    return flow;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template void change_voids<D>(const Model<D>&, const std::vector<RigidBody<D>>&, const std::vector<TwistMatrix<D>>&,       \
                                  std::vector<double>, const std::vector<double>&, const std::map<long, double>&,              \
                                  Instant<D>&);                                                                                \
    template void fill_lost<D>(const Model<D>&, const std::vector<RigidBody<D>>&, const std::vector<TwistMatrix<D>>&,          \
                               const std::vector<std::int32_t>&, Instant<D>&);                                                 \
    template PotentialFlow<D> flow_with_outflow<D>(const Complex<D>&, Coupling<D>, std::vector<Twist<D>>, UnknownVector<D>,    \
                                                   const SolverOptions&, const UnknownVector<D>*);                             \
    template double speed_beside_voids<D>(const Instant<D>&);                                                                  \
    template UnknownVector<D> VoidSolve<D>::left_outflow(const Instant<D>&) const;                                             \
    template void VoidSolve<D>::give_pressure(const PotentialFlow<D>&, UnknownVector<D>&) const;                               \
    template void VoidSolve<D>::finish(const std::vector<RigidBody<D>>&, const std::vector<TwistMatrix<D>>&, Instant<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
