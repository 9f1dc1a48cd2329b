// Voids in viscous fluid (theory, "Viscosity on parts", Voids). The ideal part of the step goes on with the voids of its start, whose pressure does nothing there; with viscosity
// act loads and pressures of voids, and the conditions for both hold at the end.
#include "gapflow/coupling/pressure_gauge.hpp"
#include "gapflow/step/given_sides.hpp"
#include "gapflow/step/inner_faces.hpp"
#include "gapflow/step/own_edges.hpp"
#include "gapflow/step/remainder.hpp"
#include "gapflow/step/void_solve.hpp"

#include <algorithm>
#include <map>
#include <tuple>

namespace gapflow {
namespace {

using WayKey = std::tuple<std::int32_t, std::int32_t, long>;

template <int D>
WayKey way_of(const VoidEdge<D>& edge)
{
    return {edge.piece, edge.mouth, edge.face};
}

/// Momenta and fluxes along edges, and the faces of the grid that these are.
template <int D>
class Ways {
public:
    Ways(const Placed<D>& at, PotentialFlow<D>& flow) : at_(at), grid_(*at.coupling.grid), flow_(flow) {}

    /// -1: none, an edge of Placed::edges.
    int axis(const VoidEdge<D>& edge) const
    {
        if (edge.face >= 0)
            return static_cast<int>(edge.face % D);
        const bool main = edge.mouth < 0 && at_.edges.edge_of_piece[edge.piece] < 0;
        return main ? at_.complex.pieces[edge.piece].axis : -1;
    }
    Index<D> face(const VoidEdge<D>& edge) const
    {
        return edge.face >= 0 ? grid_.cell_of_key(edge.face / D)
                              : grid_.wrapped(at_.complex.index.index(at_.complex.pieces[edge.piece].face));
    }
    double& potential(long row) const
    {
        const long cells = grid_.cells().template cast<long>().prod();
        return row < cells ? flow_.p.cells(grid_.cell_of_key(row)) : flow_.p.nodes[row - cells];
    }
    double drop(const VoidEdge<D>& edge) const
    {
        double sum = 0;
        for (const auto& [row, weight] : edge.rows)
            sum += weight * potential(row);
        return sum;
    }
    double drop(const SparseEdge<D>& edge) const
    {
        double sum = 0;
        for (const auto& row : at_.edges.rows_of(edge))
            sum += row.weight * (row.node >= 0 ? flow_.p.nodes[row.node] : flow_.p.cells(grid_.wrapped(row.cell)));
        return sum;
    }
    /// Density times the remainder's integral.
    double rest(const VoidEdge<D>& edge) const
    {
        const int a = axis(edge);
        const Index<D> f = a >= 0 ? face(edge) : Index<D>(Index<D>::Zero());
        return at_.coupling.density *
               (a >= 0 ? face_length(grid_, a, f) * flow_.remainder.faces(a, f) : flow_.remainder.edges[edge.edge]);
    }
    /// Gives an edge that is none of a void a momentum.
    void set(const VoidEdge<D>& edge, double momentum)
    {
        const double w = (momentum - drop(edge)) / at_.coupling.density;
        if (const int a = axis(edge); a >= 0) {
            const Index<D> f = face(edge);
            flow_.remainder.faces(a, f) = w / face_length(grid_, a, f);
        } else
            flow_.remainder.edges[edge.edge] = w;
    }
    double conductance(const VoidEdge<D>& edge) const
    {
        const int a = axis(edge);
        return a >= 0 ? at_.coupling.system.conductance(a, face(edge)) : at_.edges.edges[edge.edge].conductance;
    }
    /// What the solids carry along it.
    double carried(const VoidEdge<D>& edge) const
    {
        double sum = 0;
        if (axis(edge) < 0)
            for (const CarriedFlux<D>& of : at_.edges.carried)
                if (of.axis < 0 && of.edge == edge.edge)
                    sum += of.flux.dot(flow_.twists[of.solid]);
        return sum;
    }

private:
    const Placed<D>& at_;
    const Grid<D>& grid_;
    PotentialFlow<D>& flow_;
};

constexpr double least_stream = 1e-6;   // share of a way without fluid: an edge has a momentum
constexpr int most_viscous_rounds = 40; // half of them all parts at once
constexpr int most_levels = 4;          // sweeps over rows that are filled beside each other: any potential is a gauge

/// Potentials of rows that are filled, such that the remainder along the edges that were voids' has no divergence there.
template <int D>
void level_filled(const std::vector<std::pair<VoidEdge<D>, double>>& joined, const std::vector<long>& filled, Ways<D>& ways)
{
    for (int sweep = 0; sweep < most_levels; ++sweep)
        for (const long row : filled) {
            double sum = 0, conductance = 0;
            for (const auto& [edge, momentum] : joined)
                for (const auto& [other, weight] : edge.rows)
                    if (other == row) {
                        const double g = ways.conductance(edge);
                        sum += g * weight * (momentum - ways.drop(edge) + weight * ways.potential(row));
                        conductance += g * weight * weight;
                    }
            if (conductance > 0)
                ways.potential(row) = sum / conductance;
        }
}

} // namespace

template <int D>
void change_viscous_voids(const Model<D>& model, const std::vector<RigidBody<D>>& bodies,
                          const std::vector<TwistMatrix<D>>& mass, std::vector<double> volume,
                          const std::vector<double>& momentum, Instant<D>& now)
{
    Placed<D>& at = *now.placed;
    PotentialFlow<D>& flow = now.flow;
    const std::vector<VoidEdge<D>> before = at.voids.edges;
    std::map<WayKey, std::size_t> known;
    for (std::size_t e = 0; e < before.size(); ++e)
        known[way_of(before[e])] = e;
    std::vector<double> own = own_along_edges(at, flow.remainder);
    for (const VoidEdge<D>& edge : before)
        own[edge.edge] = 0;
    std::vector<long> filled;
    bool changed = false;
    for (const VoidPart<D>& part : at.voids.parts) {
        const bool is = volume[part.part] > 0;
        changed = changed || at.voids.is_void(part.part) != is;
        if (at.voids.is_void(part.part) && !is)
            filled.push_back(part.row);
    }
    now.kept.volume = volume;
    if (!changed) {
        at.voids.volume = std::move(volume);
        now.kept.drop = momentum;
        add_own(flow.remainder.edges = along_edges(at, flow.remainder.faces), own);
    } else {
        const std::vector<double> fluxes = edge_fluxes(at, flow).edge;
        std::vector<char> shut; // edges of voids through sides of the domain
        for (const SparseEdge<D>& edge : at.edges.edges)
            shut.push_back(edge.piece >= 0 && !(edge.conductance > 0));
        for (const VoidEdge<D>& edge : before)
            shut[edge.edge] = 0;
        put_voids(model, bodies, mass, std::move(volume), at);
        Ways<D> ways(at, flow);
        now.kept.drop.clear();
        std::map<WayKey, char> left;
        for (const VoidEdge<D>& edge : at.voids.edges) {
            left[way_of(edge)] = 1;
            const auto found = known.find(way_of(edge));
            now.kept.drop.push_back(found != known.end()   ? momentum[found->second]
                                    : ways.axis(edge) >= 0 ? ways.drop(edge) + ways.rest(edge)
                                                           : fluxes[edge.edge] / edge.conductance);
        }
        for (const VoidEdge<D>& edge : at.voids.edges)
            if (edge.edge < static_cast<std::int32_t>(own.size()))
                own[edge.edge] = 0;
        for (const VoidPart<D>& part : at.voids.parts)
            if (at.voids.is_void(part.part))
                ways.potential(part.row) = 0;
        flow.remainder.edges = along_edges(at, flow.remainder.faces);
        own.resize(flow.remainder.edges.size(), 0.0); // beyond the first ones are faces of the grid that lead to voids
        add_own(flow.remainder.edges, own);
        std::vector<std::pair<VoidEdge<D>, double>> joined;
        for (std::size_t e = 0; e < before.size(); ++e)
            if (const VoidEdge<D>& edge = before[e]; !left.contains(way_of(edge)) && ways.conductance(edge) > 0)
                joined.emplace_back(edge, (edge.open() * momentum[e] - ways.carried(edge)) / ways.conductance(edge));
        level_filled(joined, filled, ways);
        for (const auto& [edge, value] : joined)
            ways.set(edge, value);
        const long cells = model.grid.cells().template cast<long>().prod();
        for (const long row : filled) // fluid in sides of the domain has not moved
            for (int axis = 0; axis < D && row < cells; ++axis)
                for (int end = 0; end < 2; ++end)
                    if (const Index<D> f = model.grid.cell_of_key(row) + end * step<D>(axis);
                        !is_inner(model.grid, axis, f) && at.coupling.system.conductance(axis, f) > 0)
                        flow.remainder.faces(axis, f) =
                            (end ? -1 : 1) * ways.potential(row) / (at.coupling.density * face_length(model.grid, axis, f));
        for (std::size_t e = 0; e < std::min(shut.size(), at.edges.edges.size()); ++e)
            if (shut[e] && at.edges.edges[e].conductance > 0)
                flow.remainder.edges[e] = -ways.drop(at.edges.edges[e]) / at.coupling.density;
        exchange(model.grid, flow.remainder.faces);
    }
    now.kept.beyond = beyond_gaps(at.voids);
    for (const VoidPart<D>& part : at.voids.parts) // as without viscosity
        if (at.voids.is_void(part.part))
            Ways<D>(at, flow).potential(part.row) = 0;
}

/// Streams of fluid fill of the way along an edge what the void has of fluid from which its momentum leads.
template <int D>
void VoidSolve<D>::find_streams(const std::vector<double>& momentum)
{
    const Voids<D>& voids = there_.voids;
    if (voids.edges.empty())
        return;
    const auto filled = [&](std::int32_t site) {
        const VoidPart<D>* part = voids.is_void(site) ? voids.find(site) : nullptr;
        return part ? std::clamp(1 - voids.volume[site] / part->room, 0.0, 1.0) : 1.0;
    };
    for (std::size_t e = 0; e < voids.edges.size(); ++e) {
        VoidEdge<D>& edge = there_.voids.edges[e];
        double share = 1, any = 0;
        for (std::size_t r = 0; r < edge.rows.size(); ++r) {
            any = std::max(any, filled(edge.sites[r]));
            if (momentum[e] * edge.rows[r].second > 0)
                share = std::min(share, filled(edge.sites[r]));
        }
        edge.fluid = std::max(momentum[e] != 0 ? share : any, least_stream);
    }
    std::vector<Link>& links = there_.voids.all->system.links;
    const std::size_t first = links.size() - voids.edges.size();
    for (std::size_t e = 0; e < voids.edges.size(); ++e)
        links[first + e].conductance = voids.edges[e].open();
}

template <int D>
void VoidSolve<D>::begin_viscosity(const PotentialFlow<D>& ideal)
{
    start_ = drops(ideal.p);
    momentum_ = start_;
    given_ = was_void_;
    ideal_.clear();
    const std::vector<double> now = squares_of_speed(there_, ideal, start_);
    bound_.clear();
    for (std::size_t k = 0; k < past_.size(); ++k) {
        const VoidPart<D>& part = there_.voids.parts[k];
        ideal_.push_back(value(ideal.p, part.row));
        const double head = was_void_[k] ? 0.0 : 0.25 * there_.coupling.density * (square_[k] + now[part.part]);
        bound_.push_back(past_[k] + dt_ * (part.least_pressure + head));
    }
}

template <int D>
ViscousVoids<D> VoidSolve<D>::beside() const
{
    ViscousVoids<D> result{{}, {}, start_, 0};
    for (std::size_t k = 0; k < given_.size(); ++k) {
        const VoidPart<D>& part = there_.voids.parts[k];
        if (given_[k])
            result.given[part.row] = bound_[k] - ideal_[k];
        else
            result.outflow[part.row] = was_void_[k] ? -there_.voids.volume[part.part] / dt_ : 0.0;
    }
    return result;
}

template <int D>
bool VoidSolve<D>::turn(const PotentialFlow<D>& flow, int round)
{
    settled_ = round < most_viscous_rounds;
    return settled_ && update(flow, round < most_viscous_rounds / 2);
}

/// Contacts change velocities at the end: voids keep their pressures, and the fluid of their edges starts.
template <int D>
Projected<D> VoidSolve<D>::meet(const Solve& solve, Instant<D>& now)
{
    PotentialFlow<D>& flow = now.flow;
    const Voids<D>& voids = there_.voids;
    System system{*voids.all,
                  {CellField<D>(model_.grid), Eigen::VectorXd::Zero(there_.coupling.system.nodes)},
                  std::vector<Twist<D>>(there_.coupling.solids.size(), Twist<D>::Zero())};
    const auto at = [&](UnknownVector<D>& p, long row) -> double& {
        return row < cells_ ? p.cells(model_.grid.cell_of_key(row)) : p.nodes[row - cells_];
    };
    std::map<long, double> given;
    for (std::size_t k = 0; k < given_.size(); ++k)
        if (const long row = voids.parts[k].row; given_[k]) {
            given[row] = value(flow.p, row);
            for (const auto& [solid, flux] : walls_[k])
                system.impulse[solid] += given[row] * flux;
        } else if (was_void_[k])
            at(system.outflow, row) += voids.volume[voids.parts[k].part] / dt_;
    const auto drop_of = [&](std::size_t e) {
        double sum = 0;
        for (const auto& [row, weight] : voids.edges[e].rows)
            sum += weight * value(flow.p, row);
        return sum;
    };
    for (std::size_t e = 0; e < voids.edges.size(); ++e) {
        momentum_[e] -= drop_of(e);
        for (const auto& [row, weight] : voids.edges[e].rows)
            at(system.outflow, row) += weight * voids.edges[e].open() * momentum_[e];
    }
    take_rows_out(system.coupling, given, &system.outflow);
    const UnknownVector<D> rest = rest_of(flow);
    for (const auto& [row, pressure] : given)
        at(system.outflow, row) = -value(rest, row);
    add_seen_mass(system.coupling);
    Projected<D> end = solve(system.coupling, system.outflow, system.impulse);
    flow.twists = end.twists;
    flow.p = end.impulse;
    leave_gauge(system.coupling, flow.twists, flow.p);
    for (const auto& [row, pressure] : given)
        at(flow.p, row) = pressure;
    add_to(system.outflow, rest);
    settle_weak_rows(there_.complex, system.coupling, system.outflow, flow);
    for (std::size_t e = 0; e < voids.edges.size(); ++e)
        momentum_[e] += drop_of(e);
    return end;
}

/// What leaves rows by the remainder and through sides.
template <int D>
UnknownVector<D> VoidSolve<D>::rest_of(const PotentialFlow<D>& flow) const
{
    UnknownVector<D> rest{CellField<D>(model_.grid), Eigen::VectorXd::Zero(there_.coupling.system.nodes)};
    if (!flow.remainder.empty())
        add_to(rest, outflow_of_remainder(there_, flow.remainder));
    if (flow.sides.any())
        add_to(rest, outflow_of_sides(there_, flow.sides));
    return rest;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template void change_viscous_voids<D>(const Model<D>&, const std::vector<RigidBody<D>>&,                                   \
                                          const std::vector<TwistMatrix<D>>&, std::vector<double>, const std::vector<double>&, \
                                          Instant<D>&);                                                                        \
    template void VoidSolve<D>::find_streams(const std::vector<double>&);                                                      \
    template void VoidSolve<D>::begin_viscosity(const PotentialFlow<D>&);                                                      \
    template ViscousVoids<D> VoidSolve<D>::beside() const;                                                                     \
    template bool VoidSolve<D>::turn(const PotentialFlow<D>&, int);                                                            \
    template Projected<D> VoidSolve<D>::meet(const Solve&, Instant<D>&);                                                       \
    template UnknownVector<D> VoidSolve<D>::rest_of(const PotentialFlow<D>&) const;
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
