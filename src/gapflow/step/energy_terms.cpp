#include "gapflow/step/energy_terms.hpp"

#include "gapflow/core/sharing.hpp"
#include "gapflow/core/sort_unique.hpp"
#include "gapflow/grid/side_faces.hpp"
#include "gapflow/step/given_sides.hpp"
#include "gapflow/step/matching.hpp"
#include "gapflow/step/remainder.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gapflow {
namespace {

template <class T>
void gather_values(const Communicator& comm, std::vector<T>& values)
{
    if (comm.size() > 1)
        values = all_values(comm, values);
}

} // namespace

template <int D>
EnergyTerms<D>::EnergyTerms(const Placed<D>& of, const Placed<D>& near)
    : grid_(of.coupling.grid), density_(of.coupling.density), rotational_(of.rotational),
      cells_(grid_->cells().template cast<long>().prod()), known_(cells_ + near.coupling.system.nodes),
      value_of_node_(of.coupling.system.nodes, -1), seen_(of.coupling.seen_mass), gaps_(of.coupling.normal_inertia)
{
    const CoupledSystem<D>& system = of.coupling.system;
    const Communicator& comm = grid_->comm();
    add_values(of, near);
    add_faces(system, near.coupling.system);
    if (!rotational_)
        add_film(system);
    for (const auto& entry : of.coupling.cell_flux)
        fluxes_.push_back({value_of_cell(entry.row), entry.body, entry.flux});
    for (const auto& entry : of.coupling.node_flux)
        fluxes_.push_back({value_of_node_[entry.row], entry.body, entry.flux});
    add_sides(of, near);
    gather_values(comm, pairs_);
    gather_values(comm, fluxes_);
    gather_values(comm, sides_);
    gather_values(comm, gaps_);
    if (rotational_)
        add_edges(of);
    else
        add_links(system);
    add_rows();
    factorise();
    find_known();
}

/// Of the nodes and cells whose rows differ.
template <int D>
void EnergyTerms<D>::add_values(const Placed<D>& of, const Placed<D>& near)
{
    const Grid<D>& grid = *grid_;
    const Complex<D>& complex = of.complex;
    const std::vector<int>& node = of.node;
    const CoupledSystem<D>&system = of.coupling.system, &other = near.coupling.system;
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
    gather_values(grid.comm(), rows);
    for (const Row& row : rows) {
        const long local = known_ + static_cast<long>(local_.size());
        local_.push_back({row.start, 0, 0, {}, {}});
        if (row.node >= 0)
            value_of_node_[row.node] = local;
        else
            local_value_.emplace_back(row.cell, local);
    }
    std::sort(local_value_.begin(), local_value_.end());
}

template <int D>
typename EnergyTerms<D>::Differing EnergyTerms<D>::differing_cells(const Placed<D>& at, const Coupling<D>& other) const
{
    const Grid<D>& grid = *grid_;
    const Coupling<D>& of = at.coupling;
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
    sort_unique(cells);
    return cells;
}

template <int D>
long EnergyTerms<D>::value_of_cell(const Index<D>& c) const
{
    const long key = grid_->key(c);
    const auto found = std::lower_bound(local_value_.begin(), local_value_.end(), std::pair(key, -1L));
    return found != local_value_.end() && found->first == key ? found->second : key;
}

/// The domain has one face more than cells along an axis that is not periodic.
template <int D>
long EnergyTerms<D>::number_of_face(int axis, const Index<D>& f) const
{
    const Index<D> w = grid_->wrapped(f);
    long number = axis;
    for (int k = 0; k < D; ++k)
        number = number * (grid_->cells()[k] + 1) + w[k];
    return number;
}

/// Momentum of the remainder along a face's axis.
template <int D>
typename EnergyTerms<D>::Along EnergyTerms<D>::along_face(int axis, const Index<D>& f, double sign) const
{
    if (!rotational_)
        return {-1, 0};
    return {number_of_face(axis, f), sign * density_ * grid_->dx() * grid_->spread(axis, f[axis])};
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
                    pairs_.push_back(
                        {low >= 0 ? low : high, low >= 0 ? high : -1, conductance, along_face(axis, f, low >= 0 ? 1 : -1)});
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
                pairs_.push_back({value_of_node_[i], value_of_node_[j], -entry.value(), {-1, 0}});
        }
        if (rest != 0)
            pairs_.push_back({value_of_node_[i], -1, rest, {-1, 0}});
    }
}

template <int D>
void EnergyTerms<D>::add_links(const CoupledSystem<D>& system)
{
    for (const Link& link : system.links) {
        Sum sum{link.conductance, {}, {}};
        for (const auto& [i, weight] : link.nodes)
            sum.values.emplace_back(value_of_node_[i], weight);
        for (const auto& [key, weight] : link.cells)
            sum.values.emplace_back(value_of_cell(grid_->cell_of_key(key)), weight);
        sums_.push_back(std::move(sum));
    }
}

/// What nodes, links and mouths carry, with the remainder along them, and what the solids' twists do along edges and faces.
template <int D>
void EnergyTerms<D>::add_edges(const Placed<D>& of)
{
    struct Head {
        double conductance;
        int values, along;
    };
    std::vector<Head> heads;
    std::vector<std::pair<long, double>> values;
    std::vector<Along> along;
    std::vector<std::vector<Along>> along_edge(of.edges.edges.size());
    for (std::size_t e = 0; e < along_edge.size(); ++e) {
        const SparseEdge<D>& edge = of.edges.edges[e];
        for (const FaceAlong<D>& part : faces_along(of, edge))
            along_edge[e].push_back({number_of_face(part.axis, part.face), density_ * part.length});
        const auto rows = of.edges.rows_of(edge);
        if (edge.conductance == 0 || rows.empty())
            continue;
        for (const auto& row : rows)
            values.emplace_back(row.node >= 0 ? value_of_node_[row.node] : value_of_cell(grid_->wrapped(row.cell)), row.weight);
        along.insert(along.end(), along_edge[e].begin(), along_edge[e].end());
        heads.push_back({edge.conductance, static_cast<int>(rows.size()), static_cast<int>(along_edge[e].size())});
    }
    for (const CarriedFlux<D>& flux : of.edges.carried) {
        if (flux.axis >= 0)
            carried_.push_back({along_face(flux.axis, flux.face, 1), flux.solid, flux.flux});
        else
            for (const Along& part : along_edge[flux.edge])
                carried_.push_back({part, flux.solid, flux.flux});
    }
    for (const CarriedFlux<D>& flux : of.edges.covered)
        carried_.push_back({along_face(flux.axis, flux.face, 1), flux.solid, flux.flux});
    const Communicator& comm = grid_->comm();
    gather_values(comm, heads);
    gather_values(comm, values);
    gather_values(comm, along);
    gather_values(comm, carried_);
    auto next_value = values.begin();
    auto next_along = along.begin();
    for (const Head& head : heads) {
        Sum sum{head.conductance, {}, {next_along, next_along + head.along}};
        for (int k = 0; k < head.values; ++k, ++next_value) {
            const auto same = std::find_if(sum.values.begin(), sum.values.end(),
                                           [&](const auto& other) { return other.first == next_value->first; });
            if (same != sum.values.end())
                same->second += next_value->second;
            else
                sum.values.push_back(*next_value);
        }
        next_along += head.along;
        sums_.push_back(std::move(sum));
    }
}

/// What inflow and the pressure beyond a side have in rows beside it, where these change.
template <int D>
void EnergyTerms<D>::add_sides(const Placed<D>& of, const Placed<D>& near)
{
    const Grid<D>& grid = *grid_;
    for (int side = 0; side < 2 * D; ++side) {
        const int axis = side / 2, end = side % 2;
        if (const SideKind kind = grid.side(axis, end); kind != SideKind::inflow && !is_open(kind))
            continue;
        const auto add = [&](const SideRow<D>& row, long value, double sign) {
            if (row.area > 0)
                sides_.push_back({value, side, sign * row.area, sign * row.conductance,
                                  0.5 * density_ * grid.dx() * grid.spread(axis, row.face[axis]),
                                  along_face(axis, row.face, end ? 1 : -1)});
        };
        for_each_face_of_side(grid, axis, end, [&](const Index<D>& f) {
            const SideRow<D> is = row_of_face(of, side, f), was = row_of_face(near, side, f);
            const long value = value_of_cell(is.cell), before = grid.key(is.cell);
            if (value == before && is.area == was.area && is.conductance == was.conductance)
                return;
            add(is, value, 1);
            add(was, before, -1);
        });
        for (const SideRow<D>& row : nodes_of_side(of, side))
            add(row, value_of_node_[row.node], 1);
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
                if (pair.along.face >= 0)
                    row.along.push_back({pair.along.face, (own == pair.a ? 1 : -1) * pair.conductance * pair.along.length});
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
                for (const Along& part : sum.along)
                    row.along.push_back({part.face, sum.conductance * weight * part.length});
            }
}

template class EnergyTerms<2>;
template class EnergyTerms<3>;

} // namespace gapflow
