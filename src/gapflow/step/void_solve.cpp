#include "gapflow/step/void_solve.hpp"

#include "gapflow/coupling/fluid_rows.hpp"
#include "gapflow/coupling/pressure_gauge.hpp"
#include "gapflow/step/matching.hpp"

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
constexpr double drained = 0.5;                      // share of a gap from which a void has no fluid left that could flow out
constexpr double closed = 1e-6;                      // share of a gap below which no void is passed on through it

/// Mean over the axes' faces of the square of the velocity in each part.
template <int D>
std::vector<double> squares_of_speed(const Placed<D>& at, const UnknownVector<D>& p)
{
    const Grid<D>& grid = *at.coupling.grid;
    const Complex<D>& complex = at.complex;
    const auto value = [&](const PartOrCell& side) {
        const int node = side.is_part() ? at.node[side.number()] : -1;
        return node >= 0 ? p.nodes[node] : p.cells(grid.wrapped(complex.index.index(complex.cell_of(side))));
    };
    std::vector<long> fronts; // rows of voids with fluid beside: others' potentials are not those of a flow
    const auto is_void_row = [&](long row) {
        return std::any_of(at.voids.parts.begin(), at.voids.parts.end(),
                           [&](const VoidPart<D>& part) { return part.row == row && at.voids.is_void(part.part); });
    };
    for (const VoidEdge<D>& edge : at.voids.edges)
        if (!std::all_of(edge.rows.begin(), edge.rows.end(), [&](const auto& row) { return is_void_row(row.first); }))
            for (const auto& [row, weight] : edge.rows)
                fronts.push_back(row);
    const auto has_none = [&](const PartOrCell& side) {
        return side.is_part() && at.voids.is_void(side.number()) &&
               std::find(fronts.begin(), fronts.end(), at.voids.find(side.number())->row) == fronts.end();
    };
    std::vector<std::array<double, D>> sum(complex.parts(), std::array<double, D>{});
    std::vector<std::array<int, D>> count(complex.parts(), std::array<int, D>{});
    for (const FacePiece<D>& piece : complex.pieces) {
        if (!(piece.area > 0) || !piece.low.exists() || !piece.high.exists() || has_none(piece.low) || has_none(piece.high))
            continue;
        const double way = grid.dx() * grid.spread(piece.axis, complex.index.index(piece.face)[piece.axis]),
                     u = (value(piece.low) - value(piece.high)) / (way * at.coupling.density);
        for (const PartOrCell& side : {piece.low, piece.high})
            if (side.is_part()) {
                sum[side.number()][piece.axis] += u * u;
                ++count[side.number()][piece.axis];
            }
    }
    std::vector<double> square(complex.parts(), 0.0);
    for (int part = 0; part < complex.parts(); ++part)
        for (int axis = 0; axis < D; ++axis)
            if (count[part][axis] > 0)
                square[part] += sum[part][axis] / count[part][axis];
    return square;
}

} // namespace

template <int D>
struct VoidSolve<D>::System {
    Coupling<D> coupling;
    UnknownVector<D> outflow;
    std::vector<Twist<D>> impulse;
};

template <int D>
VoidSolve<D>::VoidSolve(const Model<D>& model, const Instant<D>& old, Placed<D>& there, double dt)
    : model_(model), old_(old), there_(there), dt_(dt),
      cells_(model.grid.cells().template cast<long>().prod()), past_all_{CellField<D>(model.grid),
                                                                         Eigen::VectorXd::Zero(there.coupling.system.nodes)}
{
    const Placed<D>& before = *old.placed;
    const Voids<D>& voids = there.voids;
    const std::vector<MatchedPart> was = matched_parts(model.grid, there.complex, before.complex);
    const std::vector<double> square = squares_of_speed(before, old.flow.p);
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
        past_.push_back(value(past_all_, part.row));
        const std::int32_t from = was[part.part].part;
        square_.push_back(from >= 0 ? square[from] : 0.0);
        was_void_.push_back(voids.is_void(part.part));
        known_.push_back(matched[part.part] || was_void_.back());
    }
    std::sort(at_.begin(), at_.end());
    given_ = was_void_;
    head_.assign(voids.edges.size(), 1.0);
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
    const std::vector<double> now = last ? squares_of_speed(there_, last->p) : std::vector<double>();
    bound_.clear();
    for (std::size_t k = 0; k < past_.size(); ++k) {
        const VoidPart<D>& part = there_.voids.parts[k];
        const double square = last ? 0.5 * (square_[k] + now[part.part]) : square_[k];
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
        double drop = 0, into = 0;
        bool from_fluid = false;
        for (const auto& [row, weight] : edge.rows) {
            const int k = number(row);
            const bool is_void = k >= 0 && was_void_[k];
            drop += weight * (is_void ? bound_[k] : value(p, row));
            into -= is_void ? weight : 0.0;
            from_fluid = from_fluid || !is_void;
        }
        head_[e] = 1;
        if (!from_fluid)
            continue;
        if (!(into * drop > 0)) {
            head_[e] = into * drop < 0 && is_drained(e) ? shut : 1.0;
            continue;
        }
        const double R = 1 / (edge.permeable * edge.conductance), way = edge.permeable * edge.area,
                     a = 0.5 * dt_ * there_.coupling.density / (way * way), size = std::abs(drop);
        head_[e] = 2 / (1 + std::sqrt(1 + 4 * a * size / (R * R)));
    }
}

/// Whether there is no fluid that could flow out of the voids of an edge.
template <int D>
bool VoidSolve<D>::is_drained(std::size_t e) const
{
    for (const auto& [row, weight] : there_.voids.edges[e].rows)
        if (const int k = number(row); k >= 0 && was_void_[k]) {
            const VoidPart<D>& part = there_.voids.parts[k];
            if (there_.voids.volume[part.part] < drained * part.thickness * part.area)
                return false;
        }
    return true;
}

template <int D>
double VoidSolve<D>::flux(std::size_t e, const UnknownVector<D>& p) const
{
    const VoidEdge<D>& edge = there_.voids.edges[e];
    double drop = 0, among_voids = 0;
    bool from_fluid = false;
    for (const auto& [row, weight] : edge.rows) {
        const int k = number(row);
        drop += weight * value(p, row);
        among_voids += k >= 0 ? weight * bound_[k] : 0.0;
        from_fluid = from_fluid || k < 0 || !was_void_[k];
    }
    return head_[e] * edge.permeable * edge.conductance * (from_fluid ? drop : drop - among_voids);
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
        const double among_voids = flux(e, none); // what is no flow where the voids' potentials differ
        for (const auto& [row, weight] : voids.edges[e].rows)
            add_outflow(row, weight * among_voids);
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
    find_heads(p);
    turns_.assign(head_.size(), 0);
    for (int round = 0;; ++round) {
        const bool plain = !any();
        System system;
        if (!plain)
            system = reduced();
        Coupling<D>& coupling = plain ? there_.coupling : system.coupling;
        Projected<D> end = solve(coupling, system.outflow, system.impulse);
        flow.twists = end.twists;
        flow.p = end.impulse;
        leave_gauge(coupling, flow.twists, flow.p);
        if (plain)
            settle_weak_rows(there_, flow);
        else {
            put(flow.p);
            settle_weak_rows(there_.complex, coupling, system.outflow, flow);
        }
        if (round == most_rounds || !update(flow, round < rounds_at_once))
            return end;
    }
}

template <int D>
std::vector<double> VoidSolve<D>::outflows(const PotentialFlow<D>& flow, bool over_the_step) const
{
    const FluidRows<D> L(there_.coupling);
    std::vector<double> out;
    for (std::size_t k = 0; k < given_.size(); ++k) {
        const long row = there_.voids.parts[k].row;
        double sum = 0;
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

/// Shuts edges through which a drained void would flow out, and opens those into which fluid would flow; each twice at most.
template <int D>
bool VoidSolve<D>::ways_turn(const UnknownVector<D>& p)
{
    bool turned = false;
    const std::vector<double> last = head_;
    find_heads(p);
    for (std::size_t e = 0; e < head_.size(); ++e) {
        const bool turns = (head_[e] == shut) != (last[e] == shut) && turns_[e] < most_turns;
        turns_[e] += turns;
        turned = turned || turns;
        if (!turns)
            head_[e] = last[e];
    }
    return turned;
}

template <int D>
bool VoidSolve<D>::update(const PotentialFlow<D>& flow, bool at_once)
{
    if (at_once && ways_turn(flow.p))
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
    const std::vector<double> now = squares_of_speed(there_, flow.p);
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

/// Whether an edge of a void leads to fluid.
template <int D>
bool VoidSolve<D>::fluid_beside(int part) const
{
    for (const std::size_t e : edges_of_[part])
        for (const auto& [row, weight] : there_.voids.edges[e].rows)
            if (const int k = number(row); k < 0 || !was_void_[k])
                return true;
    return false;
}

/// The potential of the fluid's front in a void: that of the fluid beside less what its inertia takes along the edge. Without fluid beside that before the step.
template <int D>
double VoidSolve<D>::true_potential(int part, const UnknownVector<D>& p) const
{
    double sum = 0, weights = 0;
    for (const std::size_t e : edges_of_[part]) {
        const VoidEdge<D>& edge = there_.voids.edges[e];
        double fluid = 0, own = 0;
        bool from_fluid = false;
        for (const auto& [row, weight] : edge.rows)
            if (const int k = number(row); k >= 0 && was_void_[k])
                own += weight;
            else {
                fluid += weight * value(p, row);
                from_fluid = true;
            }
        if (!from_fluid || own == 0)
            continue;
        const double q = flux(e, p), size = std::max(std::abs(q), std::numeric_limits<double>::min());
        sum += size * (q / (edge.permeable * edge.conductance) - fluid) / own;
        weights += size;
    }
    return weights > 0 ? sum / weights : past_[part];
}

/// What overfills a void goes on into those beside it, at its own speed.
template <int D>
void VoidSolve<D>::pass_on(std::vector<double>& volume, std::vector<double>& potential, std::vector<double>& speed,
                           std::vector<char>& front, double& lost) const
{
    for (bool again = true; again;) {
        again = false;
        for (std::size_t k = 0; k < volume.size(); ++k) {
            if (!(volume[k] < 0))
                continue;
            double ways = 0;
            std::vector<std::pair<int, std::size_t>> next;
            for (const std::size_t e : edges_of_[k]) {
                const VoidEdge<D>& edge = there_.voids.edges[e];
                for (const auto& [row, weight] : edge.rows)
                    if (const int other = number(row);
                        other >= 0 && other != static_cast<int>(k) && was_void_[other] && given_[other] && volume[other] > 0) {
                        next.emplace_back(other, e);
                        ways += edge.permeable * edge.area;
                    }
            }
            const double surplus = volume[k];
            volume[k] = 0;
            if (!(ways > 0)) {
                lost += surplus;
                continue;
            }
            for (const auto& [other, e] : next) {
                const VoidEdge<D>& edge = there_.voids.edges[e];
                volume[other] += surplus * edge.permeable * edge.area / ways;
                if (!front[other]) {
                    potential[other] = potential[k] - speed[k] * edge.area / edge.conductance;
                    speed[other] = speed[k];
                    front[other] = 1;
                }
                again = again || volume[other] < 0;
            }
        }
    }
}

template <int D>
bool VoidSolve<D>::finish(PotentialFlow<D>& flow, PartVoids& voids)
{
    const std::vector<VoidPart<D>>& parts = there_.voids.parts;
    const std::vector<double> out = outflows(flow, true);
    std::vector<double> volume(parts.size(), 0.0), potential(parts.size(), 0.0);
    std::vector<double> speed(parts.size(), 0.0); // of the fluid that runs in
    std::vector<char> front(parts.size(), 0);
    for (std::size_t k = 0; k < parts.size(); ++k) {
        if (!given_[k])
            continue;
        volume[k] = (was_void_[k] ? there_.voids.volume[parts[k].part] : 0.0) + dt_ * out[k];
        potential[k] = was_void_[k] ? true_potential(static_cast<int>(k), flow.p) : bound_[k];
        front[k] = !was_void_[k] || fluid_beside(static_cast<int>(k));
        double inflow = 0, ways = 0;
        for (const std::size_t e : edges_of_[k]) {
            const double in = -weight_in(e, k) * flux(e, flow.p);
            inflow += std::max(in, 0.0);
            ways += in > 0 ? there_.voids.edges[e].permeable * there_.voids.edges[e].area : 0.0;
        }
        speed[k] = ways > 0 ? inflow / ways : 0.0;
    }
    pass_on(volume, potential, speed, front, voids.lost);
    const double least = 1e-14 * model_.grid.dx();
    bool changed = false;
    voids.volume.assign(there_.complex.parts(), 0.0);
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const bool is_void = volume[k] > least * parts[k].area;
        if (is_void)
            voids.volume[parts[k].part] = volume[k];
        if (given_[k])
            (parts[k].row < cells_ ? flow.p.cells(model_.grid.cell_of_key(parts[k].row))
                                   : flow.p.nodes[parts[k].row - cells_]) = potential[k];
        changed = changed || is_void != static_cast<bool>(was_void_[k]);
    }
    return changed;
}

template class VoidSolve<2>;
template class VoidSolve<3>;

} // namespace gapflow
