#include "gapflow/step/displaced.hpp"

#include "gapflow/complex/gap_arm.hpp"
#include "gapflow/complex/mouth_arm.hpp"
#include "gapflow/step/nodes.hpp"

#include <algorithm>
#include <set>

namespace gapflow {
namespace {

// Cells, and radians over the body's radius in cells, to each side: small against a cell, so that the difference is the derivative; large against the tilt at
// which a wall that is nearly parallel to a plane of the grid passes it, so that this is no spike.
constexpr double small_way = 1e-3;
constexpr int relaxations = 3; // of rows that the displaced place alone has: chains of them are short

} // namespace

template <int D>
EnergyTerms<D>::EnergyTerms(const Coupling<D>& of, const Complex<D>& complex, const std::vector<int>& node, const Placed<D>& near)
    : grid_(of.grid), cells_(grid_->cells().template cast<long>().prod()), node_there_(of.system.nodes, -1),
      seen_(of.seen_mass), gaps_(of.normal_inertia)
{
    const Grid<D>& grid = *grid_;
    const CoupledSystem<D>&system = of.system, &other = near.coupling.system;
    const NodeNumbers<D> numbers(near);
    for (int p = 0; p < complex.parts(); ++p)
        if (node[p] >= 0)
            node_there_[node[p]] = numbers.find(grid, complex, p);
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
        if (system.component(c) >= 0 && other.component(c) < 0)
            fresh_.push_back({grid.key(c), 0, {}});
    });
    std::sort(fresh_.begin(), fresh_.end(), [](const Fresh& a, const Fresh& b) { return a.row < b.row; });
    for (int i = 0; i < system.nodes; ++i)
        if (node_there_[i] < 0)
            fresh_.push_back({row_of_node(i), 0, {}});

    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(grid.low(), owned_faces_end(grid, axis), [&](const Index<D>& f) {
            const double g = system.conductance(axis, f), before = other.conductance(axis, f);
            if (g == before)
                return;
            const Index<D> below = grid.wrapped(Index<D>(f - step<D>(axis))), above = grid.wrapped(f);
            const long a = grid.in_domain(below) ? grid.key(below) : -1, b = grid.in_domain(above) ? grid.key(above) : -1;
            const bool missing = (a >= 0 && fresh(a)) || (b >= 0 && fresh(b));
            add_pair(a >= 0 ? a : b, a >= 0 ? b : -1, missing ? g : g - before);
        });
    for (int i = 0; i < system.nodes; ++i) {
        double rest = 0;
        for (Eigen::SparseMatrix<double>::InnerIterator entry(system.film, i); entry; ++entry) {
            rest += entry.value();
            if (const int j = static_cast<int>(entry.row()); j > i)
                add_pair(row_of_node(i), row_of_node(j), -entry.value());
        }
        if (rest != 0)
            add_pair(row_of_node(i), -1, rest);
    }
    for (const Link& link : system.links) {
        Sum sum{link.conductance, {}};
        for (const auto& [i, weight] : link.nodes)
            sum.rows.emplace_back(row_of_node(i), weight);
        sum.rows.insert(sum.rows.end(), link.cells.begin(), link.cells.end());
        if (sum.rows.size() == 2 && sum.rows[0].second == 1 && sum.rows[1].second == -1)
            add_pair(sum.rows[0].first, sum.rows[1].first, link.conductance);
        else
            sums_.push_back(std::move(sum));
    }
    for (const auto& entry : of.cell_flux)
        fluxes_.push_back({grid.key(entry.row), entry.body, entry.flux});
    for (const auto& entry : of.node_flux)
        fluxes_.push_back({row_of_node(entry.row), entry.body, entry.flux});
}

template <int D>
typename EnergyTerms<D>::Fresh* EnergyTerms<D>::fresh(long row)
{
    const auto found = std::lower_bound(fresh_.begin(), fresh_.end(), row, [](const Fresh& f, long r) { return f.row < r; });
    return found != fresh_.end() && found->row == row ? &*found : nullptr;
}

template <int D>
void EnergyTerms<D>::add_pair(long a, long b, double conductance)
{
    pairs_.push_back({a, b, conductance});
    for (const auto& [own, other] : {std::pair(a, b), std::pair(b, a)})
        if (Fresh* row = own >= 0 ? fresh(own) : nullptr) {
            row->diagonal += conductance;
            if (other >= 0)
                row->others.emplace_back(other, conductance);
        }
}

template <int D>
double EnergyTerms<D>::value(long row, const PotentialFlow<D>& flow, const std::vector<double>& fresh_value) const
{
    const auto found = std::lower_bound(fresh_.begin(), fresh_.end(), row, [](const Fresh& f, long r) { return f.row < r; });
    if (found != fresh_.end() && found->row == row)
        return fresh_value[found - fresh_.begin()];
    return row < cells_ ? flow.p.cells(grid_->cell_of_key(row)) : flow.p.nodes[node_there_[row - cells_]];
}

template <int D>
double EnergyTerms<D>::energy(const PotentialFlow<D>& flow) const
{
    std::vector<double> fresh_value(fresh_.size(), 0.0), inflow(fresh_.size(), 0.0);
    const auto at = [&](long row) { return value(row, flow, fresh_value); };
    for (const Flux& entry : fluxes_) {
        const auto found =
            std::lower_bound(fresh_.begin(), fresh_.end(), entry.row, [](const Fresh& f, long r) { return f.row < r; });
        if (found != fresh_.end() && found->row == entry.row)
            inflow[found - fresh_.begin()] -= entry.flux.dot(flow.twists[entry.solid]);
    }
    for (int sweep = 0; sweep < relaxations; ++sweep)
        for (std::size_t k = 0; k < fresh_.size(); ++k) {
            double sum = inflow[k];
            for (const auto& [row, conductance] : fresh_[k].others)
                sum += conductance * at(row);
            if (fresh_[k].diagonal > 0)
                fresh_value[k] = sum / fresh_[k].diagonal;
        }
    double energy = 0;
    for (const Pair& pair : pairs_) {
        const double drop = at(pair.a) - (pair.b >= 0 ? at(pair.b) : 0.0);
        energy -= 0.5 * pair.conductance * drop * drop;
    }
    for (const Sum& sum : sums_) {
        double drop = 0;
        for (const auto& [row, weight] : sum.rows)
            drop += weight * at(row);
        energy -= 0.5 * sum.conductance * drop * drop;
    }
    for (const Flux& entry : fluxes_)
        energy -= at(entry.row) * entry.flux.dot(flow.twists[entry.solid]);
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
    std::set<int> solids;
    for (const auto& mouth : at.complex.mouths)
        for (const int solid : mouth.solid)
            if (solid >= 0 && solid < static_cast<int>(bodies.size()) && bodies[solid].motion == Motion::free)
                solids.insert(solid);
    const double dx = model.grid.dx();
    const auto terms = [&](int solid, int component, double way) {
        std::vector<RigidBody<D>> there = bodies;
        RigidBody<D>& body = there[solid];
        const Vec<D> centre = body.centre();
        if (component < D)
            body.pose.position[component] += way;
        else {
            Spin<D> angle = Spin<D>::Zero();
            angle[component - D] = way;
            place<D>(body, centre, rotation_of<D>(angle) * body.pose.rotation);
        }
        const std::vector<Solid<D>> moved = model.solids(there);
        const Complex<D> complex = build_complex<D>(model.grid, moved);
        const Inertia<D> inertia = find_inertia<D>(model.grid, complex, find_gap_arms<D>(model.grid, moved, complex),
                                                   find_mouth_arms<D>(model.grid, moved, complex));
        const std::vector<TwistMatrix<D>> mass(moved.size(), TwistMatrix<D>::Identity());
        const Coupling<D> coupling = couple_parts<D>(model.grid, moved, mass, model.scene.density, complex, inertia);
        CoupledSystem<D> numbered;
        return EnergyTerms<D>(coupling, complex, nodes_of_parts<D>(model.grid, complex, numbered), at);
    };
    std::vector<Displaced<D>> result;
    for (const int solid : solids) {
        const double radius = std::max(bounding_radius(world_bounds(at.coupling.solids[solid].shape)), dx);
        for (int component = 0; component < twist_size<D>; ++component)
            if (at.coupling.solids[solid].admissible.col(component).norm() > 0) {
                const double way = component < D ? small_way * dx : small_way * dx / radius;
                result.push_back({solid, component, 2 * way, terms(solid, component, -way), terms(solid, component, way)});
            }
    }
    return result;
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
    template void replace_forces<D>(const std::vector<Displaced<D>>&, const PotentialFlow<D>&, std::vector<Twist<D>>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
