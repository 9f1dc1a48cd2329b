#include "gapflow/step/displaced.hpp"

#include "gapflow/complex/facet_cut.hpp"
#include "gapflow/complex/gap_arm.hpp"
#include "gapflow/complex/mouth_arm.hpp"
#include "gapflow/core/disjoint_sets.hpp"
#include "gapflow/core/error.hpp"
#include "gapflow/core/sharing.hpp"
#include "gapflow/step/matching.hpp"
#include "gapflow/stepping/following.hpp"
#include "gapflow/stepping/standoff.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gapflow {
namespace {

// To each side, over the width of a gap or a cell: of a gap's energy, which goes as its inverse, the difference misses the square of this. Less far, a wall
// that is nearly parallel to a plane of the grid and passes it is a spike.
constexpr double small_way = 0.05;
constexpr double sealed = 1e-9; // conductance over the diagonal that leads out of no row

template <class T>
void gather_values(const Communicator& comm, std::vector<T>& values)
{
    if (comm.size() > 1)
        values = all_values(comm, values);
}

} // namespace

template <int D>
EnergyTerms<D>::EnergyTerms(const Coupling<D>& of, const Complex<D>& complex, const std::vector<int>& node,
                            const Placed<D>& near)
    : grid_(of.grid), cells_(grid_->cells().template cast<long>().prod()), known_(cells_ + near.coupling.system.nodes),
      value_of_node_(of.system.nodes, -1), seen_(of.seen_mass), gaps_(of.normal_inertia)
{
    const Grid<D>& grid = *grid_;
    const CoupledSystem<D>&system = of.system, &other = near.coupling.system;
    const std::vector<MatchedPart> there = matched_parts(grid, complex, near.complex);
    const Differing differing = differing_cells(of, near.coupling);
    struct Row {
        long cell;
        int node; ///< -1: the cell's
        long start;
    };
    std::vector<Row> rows;
    const auto add = [&](const Index<D>& c, int own_node, long start) { rows.push_back({grid.key(c), own_node, start}); };
    std::vector<char> done(cells_, 0);
    for (int part = 0; part < complex.parts(); ++part) {
        const Index<D> c = grid.wrapped(complex.cell_of_part(part));
        if (!grid.owns(c) || (node[part] < 0 && (!complex.is_main(part) || system.component(c) < 0)))
            continue;
        const MatchedPart& match = there[part];
        const long key = grid.key(c);
        const bool to_main = match.kind == MatchedPart::Kind::main && other.component(c) >= 0,
                   to_node = match.kind == MatchedPart::Kind::other && near.node[match.part] >= 0;
        if (node[part] < 0) {
            if (to_main && !std::binary_search(differing.begin(), differing.end(), key))
                continue;
            done[key] = 1;
        }
        add(c, node[part], to_main ? key : to_node ? cells_ + near.node[match.part] : -1);
    }
    for (const long key : differing)
        if (const Index<D> c = grid.cell_of_key(key); grid.owns(c) && !done[key] && system.component(c) >= 0)
            add(c, -1, other.component(c) >= 0 ? key : -1);
    const Communicator& comm = grid.comm();
    gather_values(comm, rows);
    for (const Row& row : rows) {
        const long local = known_ + static_cast<long>(local_.size());
        local_.push_back({row.start, 0, 0, {}});
        if (row.node >= 0)
            value_of_node_[row.node] = local;
        else
            local_value_.emplace_back(row.cell, local);
    }
    std::sort(local_value_.begin(), local_value_.end());
    add_faces(system, other);
    add_film(system);
    for (const auto& entry : of.cell_flux)
        fluxes_.push_back({value_of_cell(entry.row), entry.body, entry.flux});
    for (const auto& entry : of.node_flux)
        fluxes_.push_back({value_of_node_[entry.row], entry.body, entry.flux});
    gather_values(comm, pairs_);
    gather_values(comm, fluxes_);
    gather_values(comm, gaps_);
    add_links(system);
    add_rows();
    factorise();
    find_known_cells();
}

template <int D>
typename EnergyTerms<D>::Differing EnergyTerms<D>::differing_cells(const Coupling<D>& of, const Coupling<D>& other) const
{
    const Grid<D>& grid = *grid_;
    Differing cells;
    const auto offer = [&](const Index<D>& c) {
        if (const Index<D> w = grid.wrapped(c); grid.in_domain(w))
            cells.push_back(grid.key(w));
    };
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(grid.low(), owned_faces_end(grid, axis), [&](const Index<D>& f) {
            if (of.system.conductance(axis, f) != other.system.conductance(axis, f)) {
                offer(f);
                offer(f - step<D>(axis));
            }
        });
    using Entry = std::pair<std::pair<long, int>, Twist<D>>;
    const auto entries = [&](const Coupling<D>& coupling) {
        std::vector<Entry> list;
        for (const auto& entry : coupling.cell_flux)
            list.push_back({{grid.key(entry.row), entry.body}, entry.flux});
        std::sort(list.begin(), list.end(), [](const Entry& a, const Entry& b) { return a.first < b.first; });
        return list;
    };
    const std::vector<Entry> own = entries(of), others = entries(other);
    for (auto a = own.begin(), b = others.begin(); a != own.end() || b != others.end();) {
        const bool first = b == others.end() || (a != own.end() && a->first <= b->first),
                   second = a == own.end() || (b != others.end() && b->first <= a->first);
        if (!(first && second && a->second == b->second))
            cells.push_back(first ? a->first.first : b->first.first);
        a += first;
        b += second;
    }
    for (const Link& link : of.system.links)
        for (const auto& [key, weight] : link.cells)
            cells.push_back(key);
    gather_values(grid.comm(), cells);
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    return cells;
}

template <int D>
long EnergyTerms<D>::value_of_cell(const Index<D>& c) const
{
    const long key = grid_->key(c);
    const auto found = std::lower_bound(local_value_.begin(), local_value_.end(), std::pair(key, -1L));
    return found != local_value_.end() && found->first == key ? found->second : key;
}

/// What changes; the other place's own terms are taken off.
template <int D>
void EnergyTerms<D>::add_faces(const CoupledSystem<D>& system, const CoupledSystem<D>& other)
{
    const Grid<D>& grid = *grid_;
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(grid.low(), owned_faces_end(grid, axis), [&](const Index<D>& f) {
            const double g = system.conductance(axis, f), before = other.conductance(axis, f);
            const Index<D> below = grid.wrapped(Index<D>(f - step<D>(axis))), above = grid.wrapped(f);
            long a = grid.in_domain(below) ? value_of_cell(below) : -1, b = grid.in_domain(above) ? value_of_cell(above) : -1;
            const bool same = a == (a >= 0 ? grid.key(below) : -1) && b == (b >= 0 ? grid.key(above) : -1);
            if (same && g == before)
                return;
            const auto add = [&](long low, long high, double conductance) {
                if (conductance != 0)
                    pairs_.push_back({low >= 0 ? low : high, low >= 0 ? high : -1, conductance});
            };
            if (same) {
                add(a, b, g - before);
                return;
            }
            add(a, b, g);
            add(a >= 0 ? grid.key(below) : -1, b >= 0 ? grid.key(above) : -1, -before);
        });
}

template <int D>
void EnergyTerms<D>::add_film(const CoupledSystem<D>& system)
{
    for (int i = 0; i < system.nodes; ++i) {
        double rest = 0;
        for (Eigen::SparseMatrix<double>::InnerIterator entry(system.film, i); entry; ++entry) {
            rest += entry.value();
            if (const int j = static_cast<int>(entry.row()); j > i)
                pairs_.push_back({value_of_node_[i], value_of_node_[j], -entry.value()});
        }
        if (rest != 0)
            pairs_.push_back({value_of_node_[i], -1, rest});
    }
}

template <int D>
void EnergyTerms<D>::add_links(const CoupledSystem<D>& system)
{
    for (const Link& link : system.links) {
        Sum sum{link.conductance, {}};
        for (const auto& [i, weight] : link.nodes)
            sum.values.emplace_back(value_of_node_[i], weight);
        for (const auto& [key, weight] : link.cells)
            sum.values.emplace_back(value_of_cell(grid_->cell_of_key(key)), weight);
        sums_.push_back(std::move(sum));
    }
}

template <int D>
void EnergyTerms<D>::add_rows()
{
    for (const Pair& pair : pairs_)
        for (const auto& [own, other] : {std::pair(pair.a, pair.b), std::pair(pair.b, pair.a)})
            if (own >= known_) {
                Local& row = local_[own - known_];
                row.diagonal += pair.conductance;
                if (other >= 0)
                    row.others.emplace_back(other, pair.conductance);
                else
                    row.to_side += pair.conductance;
            }
    for (const Sum& sum : sums_)
        for (const auto& [own, weight] : sum.values)
            if (own >= known_) {
                Local& row = local_[own - known_];
                row.diagonal += sum.conductance * weight * weight;
                for (const auto& [other, factor] : sum.values)
                    if (other != own)
                        row.others.emplace_back(other, -sum.conductance * weight * factor);
            }
}

template <int D>
void EnergyTerms<D>::find_known_cells()
{
    if (grid_->comm().size() == 1)
        return;
    const auto add = [&](long number) {
        if (number >= 0 && number < cells_)
            shared_cells_.push_back(number);
    };
    for (const Pair& pair : pairs_) {
        add(pair.a);
        add(pair.b);
    }
    for (const Sum& sum : sums_)
        for (const auto& [number, weight] : sum.values)
            add(number);
    for (const Flux& entry : fluxes_)
        add(entry.value);
    for (const Local& row : local_)
        add(row.start);
    std::sort(shared_cells_.begin(), shared_cells_.end());
    shared_cells_.erase(std::unique(shared_cells_.begin(), shared_cells_.end()), shared_cells_.end());
}

template <int D>
typename EnergyTerms<D>::Known EnergyTerms<D>::known_values(const PotentialFlow<D>& flow) const
{
    Known known{flow, {}};
    for (const long key : shared_cells_)
        known.cells.push_back(grid_->owns(grid_->cell_of_key(key)) ? flow.p.cells(grid_->cell_of_key(key)) : 0.0);
    grid_->comm().sum(known.cells);
    return known;
}

template <int D>
double EnergyTerms<D>::value(long number, const Known& known, const std::vector<double>& local) const
{
    if (number >= known_)
        return local[number - known_];
    if (number >= cells_)
        return known.flow.p.nodes[number - cells_];
    return known.cells.empty()
               ? known.flow.p.cells(grid_->cell_of_key(number))
               : known.cells[std::lower_bound(shared_cells_.begin(), shared_cells_.end(), number) - shared_cells_.begin()];
}

/// The local values are the solution of a system of their own, of one size with the surface of the displaced solid: slivers are joined with the rest by
/// conductances many orders below those of other rows, with which iterations over all rows end too early or never.
template <int D>
void EnergyTerms<D>::factorise()
{
    const int count = static_cast<int>(local_.size());
    std::vector<Eigen::Triplet<double>> entries;
    DisjointSets sets(count);
    std::vector<double> out(count, 0.0);
    for (int k = 0; k < count; ++k) {
        const Local& row = local_[k];
        entries.emplace_back(k, k, row.diagonal > 0 ? row.diagonal : 1.0);
        for (const auto& [number, conductance] : row.others)
            if (const int other = static_cast<int>(number - known_); other < 0)
                out[k] += std::abs(conductance);
            else {
                entries.emplace_back(k, other, -conductance);
                if (std::abs(conductance) > sealed * std::min(row.diagonal, local_[other].diagonal))
                    sets.join(k, other);
            }
        out[k] += row.to_side;
    }
    int numbers = 0;
    const std::vector<int> set = sets.numbers(numbers);
    std::vector<double> leads(numbers, 0.0);
    std::vector<Sealed> all(numbers);
    for (int k = 0; k < count; ++k) {
        all[set[k]].values.push_back(k);
        all[set[k]].diagonal += local_[k].diagonal;
        leads[set[k]] += out[k];
    }
    for (int n = 0; n < numbers; ++n)
        if (all[n].diagonal > 0 && leads[n] <= sealed * all[n].diagonal) {
            const int first = all[n].values.front();
            entries.emplace_back(first, first, local_[first].diagonal);
            sealed_.push_back(std::move(all[n]));
        }
    Eigen::SparseMatrix<double> L(count, count);
    L.setFromTriplets(entries.begin(), entries.end());
    if (!factor_.compute(L))
        throw ComputationError("the potentials around a displaced body have no solution");
}

template <int D>
std::vector<double> EnergyTerms<D>::local_values(const Known& known) const
{
    const std::size_t count = local_.size();
    std::vector<double> local(count, 0.0);
    Eigen::VectorXd rest = Eigen::VectorXd::Zero(static_cast<long>(count));
    for (std::size_t k = 0; k < count; ++k)
        if (local_[k].start >= 0)
            local[k] = value(local_[k].start, known, local);
    for (std::size_t k = 0; k < count; ++k) {
        if (!(local_[k].diagonal > 0))
            continue;
        rest[k] -= local_[k].diagonal * local[k];
        for (const auto& [number, conductance] : local_[k].others)
            rest[k] += conductance * value(number, known, local);
    }
    for (const Flux& entry : fluxes_)
        if (entry.value >= known_ && local_[entry.value - known_].diagonal > 0)
            rest[entry.value - known_] -= entry.flux.dot(known.flow.twists[entry.solid]);
    // What their fluxes lack has no way out; their mean stays.
    for (const Sealed& set : sealed_) {
        double sum = 0;
        for (const int k : set.values)
            sum += rest[k];
        for (const int k : set.values)
            rest[k] -= sum / set.diagonal * local_[k].diagonal;
    }
    Eigen::VectorXd change = factor_.solve(rest);
    for (const Sealed& set : sealed_) {
        double sum = 0;
        for (const int k : set.values)
            sum += local_[k].diagonal * change[k];
        for (const int k : set.values)
            change[k] -= sum / set.diagonal;
    }
    for (std::size_t k = 0; k < count; ++k)
        local[k] += change[k];
    return local;
}

template <int D>
double EnergyTerms<D>::energy(const PotentialFlow<D>& flow) const
{
    const Known known = known_values(flow);
    const std::vector<double> local = local_values(known);
    const auto at = [&](long number) { return value(number, known, local); };
    double energy = 0;
    for (const Pair& pair : pairs_) {
        const double drop = at(pair.a) - (pair.b >= 0 ? at(pair.b) : 0.0);
        energy -= 0.5 * pair.conductance * drop * drop;
    }
    for (const Sum& sum : sums_) {
        double drop = 0;
        for (const auto& [number, weight] : sum.values)
            drop += weight * at(number);
        energy -= 0.5 * sum.conductance * drop * drop;
    }
    for (const Flux& entry : fluxes_)
        energy -= at(entry.value) * entry.flux.dot(flow.twists[entry.solid]);
    for (std::size_t s = 0; s < seen_.size(); ++s)
        energy += 0.5 * flow.twists[s].dot(seen_[s] * flow.twists[s]);
    for (const NormalInertia<D>& gap : gaps_) {
        const double speed = gap.row_master.dot(flow.twists[gap.master]) + gap.row_other.dot(flow.twists[gap.other]);
        energy += 0.5 * gap.mass * speed * speed;
    }
    return energy;
}

template <int D>
std::vector<Displaced<D>> displaced(const Model<D>& model, const std::vector<RigidBody<D>>& bodies, const Placed<D>& at)
{
    const double dx = model.grid.dx();
    std::vector<double> has_mouth(bodies.size(), 0.0), less_width(bodies.size(), -1.0); // minus that of the gaps, or of a cell
    for (const auto& mouth : at.complex.mouths)
        if (model.grid.owns(model.grid.nearest_cell(model.grid.anchor() + dx * mouth.at)))
            for (const int solid : mouth.solid)
                if (solid >= 0 && solid < static_cast<int>(bodies.size()) && bodies[solid].motion == Motion::free)
                    has_mouth[solid] = 1;
    for (const GapArm<D>& arm : own_arms(at))
        for (const int solid : arm.solid)
            if (solid < static_cast<int>(bodies.size()))
                less_width[solid] = std::max(less_width[solid], -arm.thickness);
    model.grid.comm().max(has_mouth);
    model.grid.comm().max(less_width);
    const FollowedBody<D> followed = followed_body(model);
    const auto is_free = [&](int solid) {
        return solid < static_cast<int>(bodies.size()) && bodies[solid].motion == Motion::free;
    };
    const bool given_mouth =
        model.grid.comm().any(std::any_of(at.complex.mouths.begin(), at.complex.mouths.end(), [&](const auto& mouth) {
            return std::any_of(mouth.solid.begin(), mouth.solid.end(),
                               [&](int solid) { return solid >= 0 && !is_free(solid); });
        }));
    // A body with which the grid goes along the axis, displaced with it: all others are the other way. Where their forces are known, it has the reactions.
    const auto with_grid = [&](int solid, int component) {
        return solid == followed.body && component < D && followed.axes[component];
    };
    const auto terms = [&](int solid, int component, double way) {
        std::vector<RigidBody<D>> there = bodies;
        RigidBody<D>& body = there[solid];
        const Vec<D> centre = body.centre();
        if (with_grid(solid, component)) {
            for (int b = 0; b < static_cast<int>(there.size()); ++b)
                there[b].pose.position[component] -= b == solid ? 0.0 : way;
        } else if (component < D)
            body.pose.position[component] += way;
        else {
            Spin<D> angle = Spin<D>::Zero();
            angle[component - D] = way;
            place<D>(body, centre, rotation_of<D>(angle) * body.pose.rotation);
        }
        const auto [moved, standoffs] = rough_solids<D>(model.scene, model.grid, model.solids(there));
        const Complex<D> complex = build_complex<D>(model.grid, moved);
        const Inertia<D> inertia = find_inertia<D>(model.grid, complex, find_gap_arms<D>(model.grid, moved, complex, standoffs),
                                                   find_mouth_arms<D>(model.grid, moved, complex, standoffs));
        const std::vector<TwistMatrix<D>> mass(moved.size(), TwistMatrix<D>::Identity());
        const Coupling<D> coupling = couple_parts<D>(model.grid, moved, mass, model.scene.density, complex, inertia);
        return EnergyTerms<D>(coupling, complex, coupling.part_node, at);
    };
    std::vector<Displaced<D>> result;
    for (int solid = 0; solid < static_cast<int>(bodies.size()); ++solid) {
        if (!(has_mouth[solid] > 0) && !(given_mouth && solid == followed.body && is_free(solid)))
            continue;
        const double radius = std::max(bounding_radius(world_bounds(at.coupling.solids[solid].shape)), dx);
        for (int component = 0; component < twist_size<D>; ++component)
            if (at.coupling.solids[solid].admissible.col(component).norm() > 0 &&
                (with_grid(solid, component) ? given_mouth : has_mouth[solid] > 0)) {
                const double less =
                    with_grid(solid, component) ? *std::max_element(less_width.begin(), less_width.end()) : less_width[solid];
                // In places of the complex: else their rounding would be a part of the difference.
                const double units = std::max(1.0, std::round(small_way * -less / place_unit)),
                             length = units * place_unit * dx, way = component < D ? length : length / radius;
                result.push_back({solid, component, 2 * way, terms(solid, component, -way), terms(solid, component, way)});
            }
    }
    return result;
}

template <int D>
std::vector<char> not_replaced(const std::vector<Displaced<D>>& displaced, std::size_t solids)
{
    std::vector<int> left(solids, twist_size<D>);
    for (const Displaced<D>& one : displaced)
        --left[one.solid];
    std::vector<char> any(solids);
    for (std::size_t s = 0; s < solids; ++s)
        any[s] = left[s] > 0;
    return any;
}

template <int D>
void replace_forces(const std::vector<Displaced<D>>& displaced, const PotentialFlow<D>& flow, std::vector<Twist<D>>& force)
{
    for (const Displaced<D>& one : displaced)
        force[one.solid][one.component] = (one.high.energy(flow) - one.low.energy(flow)) / one.way;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template class EnergyTerms<D>;                                                                                             \
    template std::vector<Displaced<D>> displaced<D>(const Model<D>&, const std::vector<RigidBody<D>>&, const Placed<D>&);      \
    template std::vector<char> not_replaced<D>(const std::vector<Displaced<D>>&, std::size_t);                                 \
    template void replace_forces<D>(const std::vector<Displaced<D>>&, const PotentialFlow<D>&, std::vector<Twist<D>>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
