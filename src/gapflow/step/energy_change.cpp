#include "gapflow/step/energy_change.hpp"

#include "gapflow/core/disjoint_sets.hpp"
#include "gapflow/core/sharing.hpp"
#include "gapflow/coupling/fluid_rows.hpp"
#include "gapflow/grid/side_faces.hpp"
#include "gapflow/step/given_sides.hpp"
#include "gapflow/step/inner_faces.hpp"
#include "gapflow/step/matching.hpp"
#include "gapflow/step/own_edges.hpp"
#include "gapflow/step/remainder.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

namespace gapflow {
namespace {

/// Values by keys of cells, most of them of this rank.
class ValuesOfCells {
public:
    /// Keys from `first` to before `end` are in an array.
    ValuesOfCells(long first, long end) : first_(first), value_(end - first, 0.0), known_(end - first, 0) {}

    void add(long key, double value)
    {
        if (const long k = key - first_; k >= 0 && k < static_cast<long>(value_.size())) {
            value_[k] += value;
            known_[k] = 1;
        } else
            others_[key] += value;
    }
    /// In the order of the keys.
    template <class F>
    void for_each(F&& f) const
    {
        const auto above = others_.lower_bound(first_);
        for (auto other = others_.begin(); other != above; ++other)
            f(other->first, other->second);
        for (std::size_t k = 0; k < value_.size(); ++k)
            if (known_[k])
                f(first_ + static_cast<long>(k), value_[k]);
        for (auto other = above; other != others_.end(); ++other)
            f(other->first, other->second);
    }

private:
    long first_;
    std::vector<double> value_;
    std::vector<char> known_;
    std::map<long, double> others_;
};

/// Squares of the speeds of the solids that have walls in a cell, at one of the two places, by their walls' areas.
using Shares = std::vector<std::pair<int, double>>;
void add_share(Shares& shares, int solid, double value)
{
    for (auto& [s, sum] : shares)
        if (s == solid) {
            sum += value;
            return;
        }
    shares.emplace_back(solid, value);
}

template <int D>
class ChangeOfEnergy {
public:
    ChangeOfEnergy(const Placed<D>& before, const PotentialFlow<D>& flow_before, const Placed<D>& after,
                   const PotentialFlow<D>& flow_after, const Twist<D>& stream)
        : grid_(*before.coupling.grid), V_{&flow_before.twists, &flow_after.twists}, place_{&before, &after},
          cells_{{{flow_before.p.cells, flow_before.p.cells}, {flow_after.p.cells, flow_after.p.cells}}},
          sides_{flow_before.sides, flow_after.sides},
          change_(grid_.key(grid_.low()), grid_.key(grid_.high() - Index<D>::Ones()) + 1),
          together_(static_cast<int>(V_[0]->size()))
    {
        for (int solid = 0; solid < static_cast<int>(V_[0]->size()); ++solid) {
            double square = 0;
            const double radius = bounding_radius(world_bounds(before.coupling.solids[solid].shape));
            for (const auto* V : V_) {
                const Twist<D> whole = (*V)[solid] + stream;
                const auto spin = whole.template tail<spin_size<D>>();
                square +=
                    whole.template head<D>().squaredNorm() + (spin.isZero(0) ? 0.0 : radius * radius * spin.squaredNorm());
            }
            weight_.push_back(before.coupling.solids[solid].wall ? 0.0 : square);
        }
        for (int place = 0; place < 2; ++place)
            fill(place, {&flow_before.p, &flow_after.p});
        if (!flow_after.remainder.empty())
            fill(flow_before, flow_after);
    }

    EnergyChange find()
    {
        result_.assign(V_[0]->size(), 0.0);
        add_faces();
        add_sides();
        for (int place = 0; place < 2; ++place)
            add_lists(place);
        share_out();
        add_masses();
        grid_.comm().sum(result_);
        join_of_ranks();
        EnergyChange change;
        int count = 0;
        change.group = together_.numbers(count);
        change.work.assign(count, 0.0);
        for (std::size_t s = 0; s < result_.size(); ++s) {
            change.work[change.group[s]] += result_[s];
            if (!(weight_[s] > 0))
                change.group[s] = -1;
        }
        return change;
    }

private:
    /// Values of both fields in the rows of a place. What only one place has, has its own value twice: B of the other place does not depend on it.
    void fill(int place, const std::array<const UnknownVector<D>*, 2>& p)
    {
        const int from = 1 - place; // the other field belongs to the other place
        const Placed<D>&own = *place_[place], &other = *place_[from];
        const Complex<D>& complex = own.complex;
        const std::vector<MatchedPart> there = matched_parts(grid_, complex, other.complex);
        for_each_index<D>(grid_.low(), grid_.high(), [&](const Index<D>& c) {
            if (other.coupling.system.component(c) >= 0)
                cells_[place][from](c) = p[from]->cells(c);
        });
        nodes_[place][place] = nodes_[place][from] = p[place]->nodes;
        cell_of_node_[place].assign(own.coupling.system.nodes, -1);
        for (int part = 0; part < complex.parts(); ++part) {
            const Index<D> c = grid_.wrapped(complex.cell_of_part(part));
            const int node = own.node[part];
            if (node >= 0)
                cell_of_node_[place][node] = grid_.key(c);
            if (!grid_.owns(c) || (node < 0 && !complex.is_main(part)))
                continue;
            double& value = node >= 0 ? nodes_[place][from][node] : cells_[place][from](c);
            const MatchedPart& match = there[part];
            if (match.kind == MatchedPart::Kind::other && other.node[match.part] >= 0)
                value = p[from]->nodes[other.node[match.part]];
            else if (match.kind == MatchedPart::Kind::main && other.coupling.system.component(c) >= 0)
                value = p[from]->cells(c);
            else
                value = node >= 0 ? p[place]->nodes[node] : p[place]->cells(c);
        }
        take_from_owners(own.coupling.system, nodes_[place][from]);
    }

    /// The same of the remainders, which belong to the grid.
    void fill(const PotentialFlow<D>& before, const PotentialFlow<D>& after)
    {
        faces_ = {&before.remainder.faces, &after.remainder.faces};
        edges_[0] = {before.remainder.edges, along_edges(*place_[0], *faces_[1])};
        edges_[1] = {along_edges(*place_[1], *faces_[0]), after.remainder.edges};
        for (int place = 0; place < 2 && place_[0]->viscous; ++place) {
            const Placed<D>& other = *place_[1 - place];
            const Remainder<D>& of_other = place ? before.remainder : after.remainder;
            add_own(edges_[place][1 - place], carried_along_edges(other, own_along_edges(other, of_other), *place_[place]));
        }
    }

    void put(long cell, double value)
    {
        if (value != 0)
            change_.add(cell, value);
    }

    /// Faces of the grid.
    void add_faces()
    {
        for (auto& fields : cells_)
            for (CellField<D>& field : fields)
                exchange(grid_, field);
        for (int axis = 0; axis < D; ++axis)
            for_each_index<D>(grid_.low(), owned_faces_end(grid_, axis), [&](const Index<D>& f) {
                const Index<D> below = f - step<D>(axis);
                const bool low = grid_.in_domain(grid_.wrapped(below)), high = grid_.in_domain(grid_.wrapped(f));
                std::array<std::array<double, 3>, 2> of; // conductance and both fields' differences, at both places
                for (int place = 0; place < 2; ++place) {
                    const auto drop = [&](int field) {
                        const CellField<D>& p = cells_[place][field];
                        const double difference = (high ? p(f) : 0.0) - (low ? p(below) : 0.0);
                        return rotational() ? difference - momentum(field, axis, f) : difference;
                    };
                    of[place] = {place_[place]->coupling.system.conductance(axis, f), drop(0), drop(1)};
                }
                if (of[0] == of[1]) // else fused products would leave round-off everywhere
                    return;
                const double value = -0.5 * (of[1][0] * of[1][1] * of[1][2] - of[0][0] * of[0][1] * of[0][2]);
                if (low)
                    put(grid_.key(grid_.wrapped(below)), high ? 0.5 * value : value);
                if (high)
                    put(grid_.key(grid_.wrapped(f)), low ? 0.5 * value : value);
            });
    }

    /// Inflow, and what is beyond pressure sides.
    void add_sides()
    {
        for (int side = 0; side < 2 * D; ++side) {
            const std::array<double, 2> speed{sides_[0].speed[side], sides_[1].speed[side]},
                impulse{sides_[0].impulse[side], sides_[1].impulse[side]};
            if (speed == std::array{0.0, 0.0} && impulse == std::array{0.0, 0.0})
                continue;
            const double outwards = side % 2 ? 1 : -1, density = place_[0]->coupling.density;
            const auto energy = [&](const SideRow<D>& row, double a, double b) {
                const double half = 0.5 * grid_.dx() * grid_.spread(side / 2, row.face[side / 2]);
                return 0.5 * row.area * (density * half * speed[0] * speed[1] - outwards * (a * speed[1] + b * speed[0])) +
                       0.5 * row.conductance * (a * impulse[1] + b * impulse[0] - impulse[0] * impulse[1]);
            };
            for_each_face_of_side(grid_, side / 2, side % 2, [&](const Index<D>& f) {
                const SideRow<D> was = row_of_face(*place_[0], side, f), is = row_of_face(*place_[1], side, f);
                const std::array<const CellField<D>*, 4> p{&cells_[0][0], &cells_[0][1], &cells_[1][0], &cells_[1][1]};
                if (was.area == is.area && was.conductance == is.conductance && (*p[0])(is.cell) == (*p[2])(is.cell) &&
                    (*p[1])(is.cell) == (*p[3])(is.cell))
                    return;
                put(grid_.key(is.cell),
                    energy(is, (*p[2])(is.cell), (*p[3])(is.cell)) - energy(was, (*p[0])(is.cell), (*p[1])(is.cell)));
            });
            for (int place = 0; place < 2; ++place)
                for (const SideRow<D>& row : nodes_of_side(*place_[place], side))
                    put(grid_.key(row.cell),
                        (place ? 1 : -1) * energy(row, nodes_[place][0][row.node], nodes_[place][1][row.node]));
        }
    }

    /// Nodes, links and walls of one place.
    void add_lists(int place)
    {
        const double sign = place == 0 ? -1 : 1;
        const Coupling<D>& coupling = place_[place]->coupling;
        const CoupledSystem<D>& system = coupling.system;
        const Eigen::VectorXd &a = nodes_[place][0], &b = nodes_[place][1];
        if (rotational())
            add_edges(place);
        for (int i = 0; i < system.nodes && !rotational(); ++i) {
            if (!system.owns(i))
                continue;
            double rest = 0;
            for (Eigen::SparseMatrix<double>::InnerIterator entry(system.film, i); entry; ++entry) {
                rest += entry.value();
                if (const int j = static_cast<int>(entry.row()); j > i) {
                    const double value = 0.5 * sign * entry.value() * (a[i] - a[j]) * (b[i] - b[j]);
                    put(cell_of_node_[place][i], 0.5 * value);
                    put(cell_of_node_[place][j], 0.5 * value);
                }
            }
            put(cell_of_node_[place][i], -0.5 * sign * rest * a[i] * b[i]);
        }
        const std::vector<double> linked_a = values_in_links(system, cells_[place][0]),
                                  linked_b = values_in_links(system, cells_[place][1]);
        std::size_t cell = 0;
        for (const Link& link : rotational() ? std::vector<Link>{} : system.links) {
            double sum_a = 0, sum_b = 0;
            for (const auto& [node, weight] : link.nodes) {
                sum_a += weight * a[node];
                sum_b += weight * b[node];
            }
            for (const auto& [key, weight] : link.cells) {
                sum_a += weight * linked_a[cell];
                sum_b += weight * linked_b[cell++];
            }
            const double value = -0.5 * sign * link.conductance * sum_a * sum_b;
            if (link.nodes.empty()) {
                if (const long key = link.cells.front().first; grid_.owns(grid_.cell_of_key(key)))
                    put(key, value);
            } else if (const int node = link.nodes.front().first; system.owns(node))
                put(cell_of_node_[place][node], value);
        }
        for (const auto& entry : coupling.cell_flux)
            put(grid_.key(entry.row), -0.5 * sign *
                                          (cells_[place][0](entry.row) * entry.flux.dot((*V_[1])[entry.body]) +
                                           cells_[place][1](entry.row) * entry.flux.dot((*V_[0])[entry.body])));
        for (const auto& entry : coupling.node_flux)
            put(cell_of_node_[place][entry.row], -0.5 * sign *
                                                     (a[entry.row] * entry.flux.dot((*V_[1])[entry.body]) +
                                                      b[entry.row] * entry.flux.dot((*V_[0])[entry.body])));
    }

    bool rotational() const { return faces_[0] != nullptr; }
    /// Of a field's remainder along a face.
    double momentum(int field, int axis, const Index<D>& f) const
    {
        return place_[0]->coupling.density * face_length(grid_, axis, f) * (*faces_[field])(axis, f);
    }

    /// What nodes, links and gaps carry, with circulation.
    void add_edges(int place)
    {
        const double sign = place == 0 ? -1 : 1;
        const EdgesOfParts<D>& list = place_[place]->edges;
        const double density = place_[place]->coupling.density;
        for (std::size_t e = 0; e < list.edges.size(); ++e) {
            double product = list.edges[e].conductance;
            for (int field = 0; field < 2; ++field) {
                double sum = density * edges_[place][field][e];
                for (const auto& row : list.rows_of(list.edges[e]))
                    sum += row.weight * (row.node >= 0 ? nodes_[place][field][row.node] : cells_[place][field](row.cell));
                product *= sum;
            }
            put(grid_.key(grid_.wrapped(list.rows_of(list.edges[e])[0].cell)), -0.5 * sign * product);
        }
        for (const CarriedFlux<D>& flux : list.carried) {
            double sum = 0;
            for (int field = 0; field < 2; ++field)
                sum += (flux.axis >= 0 ? momentum(field, flux.axis, flux.face) : density * edges_[place][field][flux.edge]) *
                       flux.flux.dot((*V_[1 - field])[flux.solid]);
            const Index<D> cell = flux.axis >= 0 ? flux.face : list.rows_of(list.edges[flux.edge])[0].cell;
            put(grid_.key(grid_.wrapped(cell)), -0.5 * sign * sum);
        }
        for (const CarriedFlux<D>& flux : list.covered) // of one solid alone
            for (int field = 0; field < 2; ++field)
                result_[flux.solid] -=
                    0.5 * sign * momentum(field, flux.axis, flux.face) * flux.flux.dot((*V_[1 - field])[flux.solid]);
    }

    /// Of the cells of all links, one after the other, whichever rank has them.
    std::vector<double> values_in_links(const CoupledSystem<D>& system, const CellField<D>& field) const
    {
        std::vector<double> values;
        for (const Link& link : system.links)
            for (const auto& [key, weight] : link.cells)
                values.push_back(grid_.owns(grid_.cell_of_key(key)) ? field(grid_.cell_of_key(key)) : 0.0);
        grid_.comm().sum(values);
        return values;
    }

    /// D of the solids, and what gaps add to their masses.
    void add_masses()
    {
        for (int place = 0; place < 2; ++place) {
            const double sign = place == 0 ? -1 : 1;
            const Coupling<D>& coupling = place_[place]->coupling;
            if (grid_.comm().root())
                for (std::size_t s = 0; s < result_.size(); ++s)
                    result_[s] += 0.5 * sign * (*V_[0])[s].dot(coupling.seen_mass[s] * (*V_[1])[s]);
            for (const NormalInertia<D>& gap : coupling.normal_inertia) {
                std::array<double, 2> speed;
                for (int k = 0; k < 2; ++k)
                    speed[k] = gap.row_master.dot((*V_[k])[gap.master]) + gap.row_other.dot((*V_[k])[gap.other]);
                const double value = 0.5 * sign * gap.mass * speed[0] * speed[1],
                             all = weight_[gap.master] + weight_[gap.other];
                if (!(all > 0))
                    continue;
                result_[gap.master] += value * weight_[gap.master] / all;
                result_[gap.other] += value * weight_[gap.other] / all;
                if (weight_[gap.master] > 0 && weight_[gap.other] > 0)
                    together_.join(gap.master, gap.other);
            }
        }
    }

    void share_out()
    {
        std::unordered_map<long, Shares> beside;
        for (const Placed<D>* at : place_) {
            std::unordered_map<long, int> cut_cell; // of a periodic domain with few cells a rank may have two images of one
            for (int p = 0; p < at->complex.parts(); ++p) {
                const Index<D> c = grid_.wrapped(at->complex.cell_of_part(p));
                const int number = at->complex.part_cell[p];
                if (!grid_.in_domain(c) || cut_cell.try_emplace(grid_.key(c), number).first->second != number)
                    continue;
                for (const WallPatch<D>& patch : at->complex.patches_of(p))
                    if (const double share = weight_[patch.solid] * patch.area.norm(); share > 0)
                        add_share(beside[grid_.key(c)], patch.solid, share);
            }
        }
        Shares everywhere;
        for (std::size_t s = 0; s < weight_.size(); ++s)
            if (weight_[s] > 0)
                everywhere.emplace_back(static_cast<int>(s), weight_[s]);
        Shares near;
        change_.for_each([&](long key, double value) {
            near.clear();
            for (int reach = 0; reach <= farthest && near.empty(); ++reach) {
                const Index<D> c = grid_.cell_of_key(key);
                for_each_index<D>(c - Index<D>::Constant(reach), c + Index<D>::Constant(reach + 1), [&](const Index<D>& n) {
                    const Index<D> w = grid_.wrapped(n);
                    if (!grid_.in_domain(w))
                        return;
                    if (const auto found = beside.find(grid_.key(w)); found != beside.end())
                        for (const auto& [solid, share] : found->second)
                            add_share(near, solid, share);
                });
            }
            const Shares& shares = near.empty() ? everywhere : near;
            for (const auto& [solid, share] : shares)
                together_.join(shares.front().first, solid);
            double all = 0;
            for (const auto& [solid, share] : shares)
                all += share;
            for (const auto& [solid, share] : shares)
                result_[solid] += value * share / all;
        });
    }

    /// Solids that have changes in common on any rank.
    void join_of_ranks()
    {
        if (grid_.comm().size() == 1)
            return;
        int count = 0;
        for (const std::vector<int>& set : values_by_rank(grid_.comm(), together_.numbers(count))) {
            std::vector<int> first(set.size(), -1);
            for (int s = 0; s < static_cast<int>(set.size()); ++s)
                if (int& other = first[set[s]]; other >= 0)
                    together_.join(other, s);
                else
                    other = s;
        }
    }

    static constexpr int farthest = 3; ///< cells from a wall in which its motion changes weights and fluxes

    const Grid<D>& grid_;
    std::array<const std::vector<Twist<D>>*, 2> V_;
    std::array<const Placed<D>*, 2> place_;
    std::array<std::array<CellField<D>, 2>, 2> cells_;        ///< of each place and field
    std::array<std::array<Eigen::VectorXd, 2>, 2> nodes_;     ///< of each place and field
    std::array<const FaceField<D>*, 2> faces_{};              ///< of each field: the remainder; null: none
    std::array<std::array<std::vector<double>, 2>, 2> edges_; ///< of each place and field: the same
    std::array<std::vector<long>, 2> cell_of_node_;           ///< of each place: keys
    std::array<GivenSides<D>, 2> sides_;                      ///< of each field
    std::vector<double> weight_;                              ///< of each solid: square of its speed
    ValuesOfCells change_;                                    ///< of each cell
    std::vector<double> result_;
    DisjointSets together_; ///< solids that have changes in common
};

} // namespace

template <int D>
EnergyChange energy_change(const Placed<D>& before, const PotentialFlow<D>& flow_before, const Placed<D>& after,
                           const PotentialFlow<D>& flow_after, const Twist<D>& stream)
{
    return ChangeOfEnergy<D>(before, flow_before, after, flow_after, stream).find();
}

template EnergyChange energy_change<2>(const Placed<2>&, const PotentialFlow<2>&, const Placed<2>&, const PotentialFlow<2>&,
                                       const Twist<2>&);
template EnergyChange energy_change<3>(const Placed<3>&, const PotentialFlow<3>&, const Placed<3>&, const PotentialFlow<3>&,
                                       const Twist<3>&);

} // namespace gapflow
