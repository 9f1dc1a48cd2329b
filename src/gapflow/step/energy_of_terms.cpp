#include "gapflow/step/energy_terms.hpp"

#include "gapflow/core/disjoint_sets.hpp"
#include "gapflow/core/error.hpp"
#include "gapflow/core/sort_unique.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gapflow {
namespace {

constexpr double sealed = 1e-9; // conductance over the diagonal that leads out of no row

/// Speed of what a side gives, out of the domain.
template <int D>
double outwards(const GivenSides<D>& given, int side)
{
    return side % 2 ? given.speed[side] : -given.speed[side];
}

} // namespace

template <int D>
void EnergyTerms<D>::find_known()
{
    if (grid_->comm().size() == 1)
        return;
    const auto add = [&](long number) {
        if (number >= 0 && number < cells_)
            shared_cells_.push_back(number);
    };
    const auto add_face = [&](const Along& along) {
        if (along.face >= 0)
            shared_faces_.push_back(along.face);
    };
    for (const Pair& pair : pairs_) {
        add(pair.a);
        add(pair.b);
        add_face(pair.along);
    }
    for (const Sum& sum : sums_) {
        for (const auto& [number, weight] : sum.values)
            add(number);
        for (const Along& along : sum.along)
            add_face(along);
    }
    for (const Flux& entry : fluxes_)
        add(entry.value);
    for (const Carried& entry : carried_)
        add_face(entry.along);
    for (const SideTerm& term : sides_) {
        add(term.value);
        add_face(term.along);
    }
    for (const Local& row : local_)
        add(row.start);
    sort_unique(shared_cells_);
    sort_unique(shared_faces_);
}

template <int D>
double EnergyTerms<D>::on_face(long number, const PotentialFlow<D>& flow) const
{
    Index<D> f;
    for (int k = D - 1; k >= 0; --k) {
        f[k] = static_cast<int>(number % (grid_->cells()[k] + 1));
        number /= grid_->cells()[k] + 1;
    }
    const int axis = static_cast<int>(number);
    return owns_face(*grid_, axis, f) ? flow.remainder.faces(axis, f) : 0.0;
}

template <int D>
typename EnergyTerms<D>::Known EnergyTerms<D>::known_values(const PotentialFlow<D>& flow) const
{
    Known known{flow, {}, {}};
    for (const long key : shared_cells_)
        known.cells.push_back(grid_->owns(grid_->cell_of_key(key)) ? flow.p.cells(grid_->cell_of_key(key)) : 0.0);
    grid_->comm().sum(known.cells);
    for (const long face : shared_faces_)
        known.faces.push_back(on_face(face, flow));
    if (rotational_)
        grid_->comm().sum(known.faces);
    return known;
}

/// Of the remainder.
template <int D>
double EnergyTerms<D>::momentum(const Along& along, const Known& known) const
{
    if (along.face < 0)
        return 0;
    const double velocity =
        known.faces.empty()
            ? on_face(along.face, known.flow)
            : known.faces[std::lower_bound(shared_faces_.begin(), shared_faces_.end(), along.face) - shared_faces_.begin()];
    return along.length * velocity;
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
        for (const Along& along : local_[k].along)
            rest[k] -= momentum(along, known);
    }
    for (const Flux& entry : fluxes_)
        if (entry.value >= known_ && local_[entry.value - known_].diagonal > 0)
            rest[entry.value - known_] -= entry.flux.dot(known.flow.twists[entry.solid]);
    const GivenSides<D>& given = known.flow.sides;
    for (const SideTerm& term : sides_)
        if (term.value >= known_ && local_[term.value - known_].diagonal > 0)
            rest[term.value - known_] -= term.area * outwards(given, term.side) - term.conductance * given.impulse[term.side];
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
        const double drop = at(pair.a) - (pair.b >= 0 ? at(pair.b) : 0.0) + momentum(pair.along, known);
        energy -= 0.5 * pair.conductance * drop * drop;
    }
    for (const Sum& sum : sums_) {
        double drop = 0;
        for (const auto& [number, weight] : sum.values)
            drop += weight * at(number);
        for (const Along& along : sum.along)
            drop += momentum(along, known);
        energy -= 0.5 * sum.conductance * drop * drop;
    }
    for (const Flux& entry : fluxes_)
        energy -= at(entry.value) * entry.flux.dot(flow.twists[entry.solid]);
    for (const Carried& entry : carried_)
        energy -= momentum(entry.along, known) * entry.flux.dot(flow.twists[entry.solid]);
    for (const SideTerm& term : sides_) {
        const double out = outwards(flow.sides, term.side), impulse = flow.sides.impulse[term.side], p = at(term.value);
        energy += term.area * (0.5 * term.half * out * out - p * out) +
                  term.conductance * impulse * (p + momentum(term.along, known) - 0.5 * impulse);
    }
    for (std::size_t s = 0; s < seen_.size(); ++s)
        energy += 0.5 * flow.twists[s].dot(seen_[s] * flow.twists[s]);
    for (const NormalInertia<D>& gap : gaps_) {
        const double speed = gap.row_master.dot(flow.twists[gap.master]) + gap.row_other.dot(flow.twists[gap.other]);
        energy += 0.5 * gap.mass * speed * speed;
    }
    return energy;
}

// Of the members in energy_terms.cpp: there.
template void EnergyTerms<2>::find_known();
template void EnergyTerms<3>::find_known();
template void EnergyTerms<2>::factorise();
template void EnergyTerms<3>::factorise();
template double EnergyTerms<2>::energy(const PotentialFlow<2>& flow) const;
template double EnergyTerms<3>::energy(const PotentialFlow<3>& flow) const;

} // namespace gapflow
