#include "gapflow/step/void_solve.hpp"

#include "gapflow/coupling/fluid_rows.hpp"
#include "gapflow/coupling/pressure_gauge.hpp"
#include "gapflow/step/matching.hpp"
#include "gapflow/step/own_edges.hpp"
#include "gapflow/step/remainder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace gapflow {
namespace {

constexpr int most_rounds = 60, rounds_at_once = 40; // then one part at a time
constexpr int most_turns = 2;                        // of an edge in a pass
constexpr double accuracy_over_tolerance = 10;       // of the conditions, over that of the solve
constexpr double shut = 1e-6;                        // share of an edge's conductance then: what it encloses has a pressure
constexpr double closed = 1e-6;                      // share of a gap below which no void is passed on through it

} // namespace

template <int D>
VoidSolve<D>::VoidSolve(const Model<D>& model, const Instant<D>& old, Placed<D>& there, double dt)
    : model_(model), old_(old), there_(there), dt_(dt),
      cells_(model.grid.cells().template cast<long>().prod()), past_all_{CellField<D>(model.grid),
                                                                         Eigen::VectorXd::Zero(there.coupling.system.nodes)}
{
    const Placed<D>& before = *old.placed;
    const Voids<D>& voids = there.voids;
    const std::vector<MatchedPart> was = matched_parts(model.grid, there.complex, before.complex);
    const std::vector<std::int32_t> site = sites_before(model.grid, there.complex, before.complex);
    const std::vector<double> square = squares_of_speed(before, old.flow, old.kept.drop);
    past_all_.cells = old.flow.p.cells;
    std::vector<char> matched(there.complex.parts(), 0);
    for (int part = 0; part < there.complex.parts(); ++part) {
        const MatchedPart& match = was[part];
        const Index<D> c = model.grid.wrapped(there.complex.cell_of_part(part));
        const int node = there.node[part], other = match.kind == MatchedPart::Kind::other ? before.node[match.part] : -1;
        matched[part] = other >= 0 || match.kind == MatchedPart::Kind::main;
        const double p = other >= 0 ? old.flow.p.nodes[other] : old.flow.p.cells(c);
        if (node >= 0)
            past_all_.nodes[node] = matched[part] ? p : old.flow.p.cells(c);
        else if (there.complex.is_main(part) && matched[part])
            past_all_.cells(c) = p;
    }
    for (std::size_t k = 0; k < voids.parts.size(); ++k) {
        const VoidPart<D>& part = voids.parts[k];
        at_.emplace_back(part.row, static_cast<int>(k));
        if (voids.is_void(part.part))
            (part.row < cells_ ? past_all_.cells(model.grid.cell_of_key(part.row)) : past_all_.nodes[part.row - cells_]) = 0;
        past_.push_back(value(past_all_, part.row));
        const std::int32_t from = part.part < there.complex.parts() ? site[part.part] : -1;
        square_.push_back(from >= 0 ? square[from] : 0.0);
        const VoidPart<D>* here_before = from >= 0 ? before.voids.find(from) : nullptr; // what opens in the step is no fluid
        const double room = here_before ? std::min(part.room, here_before->room) : part.room;
        fluid_.push_back(voids.is_void(part.part) ? std::max(0.0, room - voids.volume[part.part]) : 0.0);
        was_void_.push_back(voids.is_void(part.part));
        known_.push_back(part.part >= there.complex.parts() || matched[part.part] || was_void_.back());
    }
    std::sort(at_.begin(), at_.end());
    given_ = was_void_;
    head_.assign(voids.edges.size(), 1.0);
    spent_.assign(voids.edges.size(), 0.0);
    walls_.resize(voids.parts.size());
    edges_of_.resize(voids.parts.size());
    const auto add_wall = [&](long row, int solid, const Twist<D>& flux) {
        if (const int k = number(row); k >= 0)
            walls_[k].emplace_back(solid, flux);
    };
    for (const auto& entry : there.coupling.cell_flux)
        add_wall(model.grid.key(entry.row), entry.body, entry.flux);
    for (const auto& entry : there.coupling.node_flux)
        add_wall(cells_ + entry.row, entry.body, entry.flux);
    for (std::size_t e = 0; e < voids.edges.size(); ++e)
        for (const auto& [row, weight] : voids.edges[e].rows)
            if (const int k = number(row); k >= 0)
                edges_of_[k].push_back(e);
    find_offsets(site);
}

/// What is to be added to each edge's drop of the potentials before the step for that with which its fluid moved.
template <int D>
void VoidSolve<D>::find_offsets(const std::vector<std::int32_t>& was)
{
    const Placed<D>& before = *old_.placed;
    const DenseIndex<D>& index = before.complex.index;
    using Key = std::vector<std::pair<long, bool>>; // rows before the step, and whether the flux leaves them
    struct Known {
        double drop = 0, conductance = 0;
    };
    std::map<Key, Known> known; // edges between the same rows count together
    for (std::size_t e = 0; e < before.voids.edges.size(); ++e) {
        const VoidEdge<D>& edge = before.voids.edges[e];
        Key key;
        for (const auto& [row, weight] : edge.rows)
            key.emplace_back(row, weight > 0);
        std::sort(key.begin(), key.end());
        Known& of = known[key];
        of.drop += edge.conductance * old_.kept.drop[e];
        of.conductance += edge.conductance;
    }
    const auto site_before = [&](std::int32_t site) {
        if (site < there_.complex.parts())
            return was[site];
        const PartOrCell side = before.complex.main_of(site - there_.complex.parts());
        return side.exists() ? site_of(before.complex, side) : -1;
    };
    const auto row_before = [&](std::int32_t site) {
        const PartOrCell side = side_of(before.complex, site);
        const int node = side.is_part() ? before.node[side.number()] : -1;
        return node >= 0 ? cells_ + node : model_.grid.key(model_.grid.wrapped(index.index(before.complex.cell_of(side))));
    };
    Remainder<D> rest; // of the start, here
    if (!old_.flow.remainder.empty() && !there_.voids.edges.empty()) {
        rest = remainder_of(there_, old_.flow.remainder.faces);
        add_own(rest.edges, carried_along_edges(before, own_along_edges(before, old_.flow.remainder), there_));
    }
    std::vector<double> momentum;
    for (const VoidEdge<D>& edge : there_.voids.edges) {
        Key key;
        bool from_void = false, is_known = true;
        double past = 0;
        for (std::size_t r = 0; r < edge.rows.size(); ++r) {
            const auto& [row, weight] = edge.rows[r];
            past += weight * value(past_all_, row);
            const std::int32_t site = site_before(edge.sites[r]);
            is_known = is_known && site >= 0;
            if (site < 0)
                continue;
            from_void = from_void || before.voids.is_void(site);
            key.emplace_back(row_before(site), weight > 0);
        }
        std::sort(key.begin(), key.end());
        const auto found = is_known ? known.find(key) : known.end();
        const double with_rest = past + (rest.empty() ? 0.0 : there_.coupling.density * rest.edges[edge.edge]),
                     drop = found != known.end()     ? found->second.drop / found->second.conductance
                            : is_known && !from_void ? with_rest
                                                     : 0.0;
        momentum.push_back(drop);
        offset_.push_back(drop - past);
    }
    if (model_.viscous())
        find_streams(momentum);
}

/// Of an edge with `p`, voids at their bounds.
template <int D>
typename VoidSolve<D>::Drop VoidSolve<D>::drop(std::size_t e, const UnknownVector<D>& p, bool at_bounds) const
{
    Drop of{0, false};
    double among_voids = 0;
    for (const auto& [row, weight] : there_.voids.edges[e].rows) {
        const int k = number(row);
        const bool is_void = k >= 0 && was_void_[k];
        of.sum += weight * (is_void && (at_bounds || given_[k]) ? bound_[k] : value(p, row));
        among_voids += k >= 0 ? weight * bound_[k] : 0.0;
        of.from_fluid = of.from_fluid || !is_void;
    }
    of.sum += of.from_fluid ? offset_[e] : -among_voids;
    return of;
}

template <int D>
int VoidSolve<D>::number(long row) const
{
    const auto found = std::lower_bound(at_.begin(), at_.end(), std::pair(row, 0));
    return found != at_.end() && found->first == row ? found->second : -1;
}

template <int D>
double VoidSolve<D>::value(const UnknownVector<D>& p, long row) const
{
    return row < cells_ ? p.cells(model_.grid.cell_of_key(row)) : p.nodes[row - cells_];
}

template <int D>
void VoidSolve<D>::put(UnknownVector<D>& p) const
{
    for (std::size_t k = 0; k < given_.size(); ++k)
        if (const long row = there_.voids.parts[k].row; given_[k])
            (row < cells_ ? p.cells(model_.grid.cell_of_key(row)) : p.nodes[row - cells_]) = bound_[k];
}

template <int D>
void VoidSolve<D>::find_bounds(const PotentialFlow<D>* last)
{
    const std::vector<double> now = last ? squares_of_speed(there_, *last, drops(last->p)) : std::vector<double>();
    bound_.clear();
    for (std::size_t k = 0; k < past_.size(); ++k) {
        const VoidPart<D>& part = there_.voids.parts[k];
        const double square = last ? 0.5 * (square_[k] + now[part.part]) : square_[k];
        if (model_.viscous() && was_void_[k])
            bound_.push_back(0); // its pressure acts with viscosity
        else
            bound_.push_back(past_[k] +
                             dt_ * (part.least_pressure + (was_void_[k] ? 0.0 : 0.5 * there_.coupling.density * square)));
    }
}

// Of the drop of an edge into a void 1/(g) q and dt rho/2 u^2, at the drop of p.
template <int D>
void VoidSolve<D>::find_heads(const UnknownVector<D>& p)
{
    for (std::size_t e = 0; e < head_.size(); ++e) {
        const VoidEdge<D>& edge = there_.voids.edges[e];
        const auto [drop, from_fluid] = this->drop(e, p, true);
        double into = 0;
        for (const auto& [row, weight] : edge.rows)
            if (const int k = number(row); k >= 0 && was_void_[k])
                into -= weight;
        head_[e] = 1;
        spent_[e] = 0;
        if (!from_fluid)
            continue;
        if (!(into * drop > 0)) {
            if (model_.viscous())
                continue; // streams
            const double most = content(e) / dt_;
            if (edge.open() * std::abs(into * drop) > most) {
                head_[e] = shut;
                spent_[e] = drop > 0 ? most : -most;
            }
            continue;
        }
        const double R = 1 / edge.open(), way = edge.fluid * edge.permeable * edge.area,
                     a = 0.5 * dt_ * there_.coupling.density / (way * way), size = std::abs(drop);
        head_[e] = 2 / (1 + std::sqrt(1 + 4 * a * size / (R * R)));
    }
}

/// Fluid in the voids of an edge that could flow out along it: that of each void is shared by its ways out to the fluid.
template <int D>
double VoidSolve<D>::content(std::size_t e) const
{
    const auto way = [&](std::size_t edge) { return there_.voids.edges[edge].permeable * there_.voids.edges[edge].area; };
    double sum = 0;
    for (const auto& [row, weight] : there_.voids.edges[e].rows)
        if (const int k = number(row); k >= 0 && was_void_[k]) {
            double ways = 0;
            for (const std::size_t other : edges_of_[k])
                ways += leads_to_fluid(other) ? way(other) : 0.0;
            sum += ways > 0 ? fluid_[k] * way(e) / ways : 0.0;
        }
    return sum;
}

template <int D>
bool VoidSolve<D>::leads_to_fluid(std::size_t e) const
{
    return std::any_of(there_.voids.edges[e].rows.begin(), there_.voids.edges[e].rows.end(), [&](const auto& of) {
        const int k = number(of.first);
        return k < 0 || !was_void_[k];
    });
}

template <int D>
double VoidSolve<D>::flux(std::size_t e, const UnknownVector<D>& p) const
{
    if (!momentum_.empty())
        return there_.voids.edges[e].open() * momentum_[e];
    return head_[e] * there_.voids.edges[e].open() * drop(e, p, false).sum + spent_[e];
}

/// Of all edges: what their fluxes ask for.
template <int D>
std::vector<double> VoidSolve<D>::drops(const UnknownVector<D>& p) const
{
    std::vector<double> all;
    for (std::size_t e = 0; e < head_.size(); ++e)
        all.push_back(flux(e, p) / there_.voids.edges[e].open());
    return all;
}

template <int D>
typename VoidSolve<D>::System VoidSolve<D>::reduced() const
{
    const Voids<D>& voids = there_.voids;
    System system{*voids.all,
                  {CellField<D>(model_.grid), Eigen::VectorXd::Zero(there_.coupling.system.nodes)},
                  std::vector<Twist<D>>(there_.coupling.solids.size(), Twist<D>::Zero())};
    std::map<long, double> given;
    const auto add_outflow = [&](long row, double flux) {
        (row < cells_ ? system.outflow.cells(model_.grid.cell_of_key(row)) : system.outflow.nodes[row - cells_]) += flux;
    };
    for (std::size_t k = 0; k < given_.size(); ++k)
        if (given_[k]) {
            given[voids.parts[k].row] = bound_[k];
            for (const auto& [solid, flux] : walls_[k])
                system.impulse[solid] += bound_[k] * flux;
        } else if (was_void_[k])
            add_outflow(voids.parts[k].row, voids.volume[voids.parts[k].part] / dt_);
    std::vector<Link>& links = system.coupling.system.links;
    const std::size_t first = links.size() - voids.edges.size();
    UnknownVector<D> none{CellField<D>(model_.grid), Eigen::VectorXd::Zero(there_.coupling.system.nodes)};
    for (std::size_t e = 0; e < voids.edges.size(); ++e) {
        links[first + e].conductance *= head_[e];
        double without = flux(e, none); // with all potentials 0
        for (const auto& [row, weight] : voids.edges[e].rows)
            if (const int k = number(row); k >= 0 && was_void_[k] && given_[k])
                without -= head_[e] * voids.edges[e].open() * weight * bound_[k];
        for (const auto& [row, weight] : voids.edges[e].rows)
            add_outflow(row, weight * without);
    }
    take_rows_out(system.coupling, given, &system.outflow);
    for (const auto& [row, value] : given)
        (row < cells_ ? system.outflow.cells(model_.grid.cell_of_key(row)) : system.outflow.nodes[row - cells_]) = 0;
    add_seen_mass(system.coupling);
    return system;
}

template <int D>
Projected<D> VoidSolve<D>::find(const Solve& solve, const PotentialFlow<D>* last, PotentialFlow<D>& flow)
{
    find_bounds(last);
    UnknownVector<D> p = last ? last->p : past_all_;
    if (model_.viscous())
        given_ = was_void_;
    find_heads(p);
    turns_.assign(head_.size(), 0);
    const UnknownVector<D> rest = rest_of(flow);
    for (int round = 0;; ++round) {
        const bool plain = !any();
        System system;
        if (!plain) {
            system = reduced();
            for (std::size_t k = 0; k < given_.size(); ++k)
                if (const long row = there_.voids.parts[k].row; given_[k])
                    (row < cells_ ? system.outflow.cells(model_.grid.cell_of_key(row)) : system.outflow.nodes[row - cells_]) =
                        -value(rest, row);
        }
        Coupling<D>& coupling = plain ? there_.coupling : system.coupling;
        Projected<D> end = solve(coupling, system.outflow, system.impulse);
        flow.twists = end.twists;
        flow.p = end.impulse;
        leave_gauge(coupling, flow.twists, flow.p);
        if (plain)
            settle_weak_rows(there_, flow);
        else {
            put(flow.p);
            add_to(system.outflow, rest);
            settle_weak_rows(there_.complex, coupling, system.outflow, flow);
        }
        settled_ = round < most_rounds;
        if (settled_ && update(flow, round < rounds_at_once))
            continue;
        for (std::size_t k = 0; k < given_.size(); ++k) // of the pressure of a void alone, which is no momentum of the fluid
            if (const long row = there_.voids.parts[k].row; given_[k] && was_void_[k])
                (row < cells_ ? flow.p.cells(model_.grid.cell_of_key(row)) : flow.p.nodes[row - cells_]) = 0;
        return end;
    }
}

template <int D>
std::vector<double> VoidSolve<D>::outflows(const PotentialFlow<D>& flow, bool over_the_step) const
{
    const FluidRows<D> L(there_.coupling);
    const UnknownVector<D> rest = rest_of(flow);
    std::vector<double> out;
    for (std::size_t k = 0; k < given_.size(); ++k) {
        const long row = there_.voids.parts[k].row;
        double sum = given_[k] ? value(rest, row) : 0.0;
        if (given_[k]) {
            L.for_each(row, [&](long other, double entry) { sum += entry * value(flow.p, other); });
            for (const auto& [solid, flux] : walls_[k]) // over the walls' way: given twists are those of the step
                sum += over_the_step && was_void_[k] && there_.coupling.solids[solid].motion == Motion::free
                           ? 0.5 * flux.dot(old_.flow.twists[solid] + flow.twists[solid])
                           : flux.dot(flow.twists[solid]);
        }
        out.push_back(sum);
    }
    for (std::size_t e = 0; e < head_.size(); ++e) {
        const double q = flux(e, flow.p);
        for (const auto& [row, weight] : there_.voids.edges[e].rows)
            if (const int k = number(row); k >= 0 && given_[k])
                out[k] += weight * q;
    }
    return out;
}

/// Whether what overfills a void goes on into the next one.
template <int D>
bool VoidSolve<D>::passes_on(int part) const
{
    for (const std::size_t e : edges_of_[part])
        for (const auto& [row, weight] : there_.voids.edges[e].rows)
            if (const int k = number(row);
                k >= 0 && k != part && was_void_[k] && given_[k] && there_.voids.edges[e].permeable > closed)
                return was_void_[part];
    return false;
}

/// Shuts edges through which more would flow out of a void than there is, and opens those into which fluid would flow; each twice at most.
template <int D>
bool VoidSolve<D>::ways_turn(const UnknownVector<D>& p)
{
    bool turned = false;
    const std::vector<double> last = head_, last_spent = spent_;
    find_heads(p);
    for (std::size_t e = 0; e < head_.size(); ++e) {
        const bool turns = (head_[e] == shut) != (last[e] == shut) && turns_[e] < most_turns;
        turns_[e] += turns;
        turned = turned || turns;
        if (!turns) {
            head_[e] = last[e];
            spent_[e] = last_spent[e];
        }
    }
    return turned;
}

template <int D>
bool VoidSolve<D>::update(const PotentialFlow<D>& flow, bool at_once)
{
    if (at_once && momentum_.empty() && ways_turn(flow.p))
        return true;
    const std::vector<double> out = outflows(flow, false);
    double largest_excess = 0, largest_room = 0;
    const auto room = [&](std::size_t k) {
        return (was_void_[k] ? there_.voids.volume[there_.voids.parts[k].part] / dt_ : 0.0) + out[k];
    };
    for (std::size_t k = 0; k < given_.size(); ++k) {
        largest_excess = std::max(largest_excess, std::abs(value(flow.p, there_.voids.parts[k].row) - bound_[k]));
        if (given_[k])
            largest_room = std::max({largest_room, std::abs(room(k)), std::abs(out[k])});
    }
    const double accuracy = accuracy_over_tolerance * model_.scene.tolerance;
    int last = -1;
    for (std::size_t k = 0; k < given_.size(); ++k) {
        if (was_void_[k] && model_.viscous() && momentum_.empty())
            continue; // it may be filled with viscosity
        const bool wrong = given_[k]
                               ? room(k) < -accuracy * largest_room && !passes_on(static_cast<int>(k))
                               : known_[k] && value(flow.p, there_.voids.parts[k].row) - bound_[k] < -accuracy * largest_excess;
        if (!wrong)
            continue;
        last = static_cast<int>(k);
        if (at_once)
            given_[k] = !given_[k];
    }
    if (last >= 0 && !at_once)
        given_[last] = !given_[last];
    return last >= 0;
}

template <int D>
bool VoidSolve<D>::any() const
{
    return !there_.voids.edges.empty() || std::any_of(given_.begin(), given_.end(), [](char c) { return c; }) ||
           std::any_of(was_void_.begin(), was_void_.end(), [](char c) { return c; });
}

template class VoidSolve<2>;
template class VoidSolve<3>;

} // namespace gapflow
