#include "gapflow/viscosity/viscous_terms.hpp"

#include <algorithm>

namespace gapflow {

namespace {

// Appends the entries of a block of bodies a and b.
template <int D>
void append(int a, int b, const TwistMatrix<D>& block, std::vector<Eigen::Triplet<double>>& entries)
{
    constexpr int n = twist_size<D>;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            if (block(i, j) != 0)
                entries.emplace_back(n * a + i, n * b + j, block(i, j));
}

} // namespace

// Less the known motion of solids that are not free.
template <int D>
double ViscousTerms<D>::target_of(const ViscousTerm<D>& term) const
{
    double target = term.target;
    for (int k = 0; k < 2; ++k)
        if (const int s = term.solid[k]; s >= 0 && coupling_.free_body[s] < 0)
            target -= term.row[k].dot(bodies_.twists[s]);
    return target;
}

template <int D>
double ViscousTerms<D>::add_to_lattice(const ViscousTerm<D>& term) const
{
    const double target = target_of(term);
    if (term.at >= 0) {
        system_.diagonal[term.axis].data()[term.at] += term.stiffness * term.weight * term.weight;
        system_.rhs[term.axis].data()[term.at] += term.stiffness * term.weight * target;
    }
    return term.stiffness * target * target;
}

template <int D>
void ViscousTerms<D>::add_to_bodies(const ViscousTerm<D>& term)
{
    const double target = target_of(term);
    if (std::any_of(term.solid.begin(), term.solid.end(), [&](int s) { return s >= 0 && !coupling_.solids[s].wall; }))
        system_.terms.push_back(term);
    for (int i = 0; i < 2; ++i) {
        const int a = term.solid[i] < 0 ? -1 : coupling_.free_body[term.solid[i]];
        if (a < 0)
            continue;
        const Twist<D> row_a = coupling_.solids[term.solid[i]].admissible * term.row[i];
        body_rhs_.segment<n>(n * a) += term.stiffness * target * row_a;
        for (int j = 0; j < 2; ++j) {
            const int b = term.solid[j] < 0 ? -1 : coupling_.free_body[term.solid[j]];
            if (b >= 0)
                add_block(a, b,
                          term.stiffness * row_a * (coupling_.solids[term.solid[j]].admissible * term.row[j]).transpose());
        }
    }
}

template <int D>
void ViscousTerms<D>::add_block(int a, int b, const TwistMatrix<D>& block)
{
    if (a == b) {
        own_blocks_[a] += block;
        return;
    }
    auto [at, is_new] = blocks_.try_emplace({a, b}, block);
    if (!is_new)
        at->second += block;
}

template <int D>
void ViscousTerms<D>::share_turning()
{
    constexpr int size = spin_size<D> * spin_size<D>;
    std::vector<double> sums;
    for (const Spins& matrix : system_.turning)
        sums.insert(sums.end(), matrix.data(), matrix.data() + size);
    grid_.comm().sum(sums);
    for (std::size_t s = 0; s < system_.turning.size(); ++s) {
        const Spins sum = Eigen::Map<const Spins>(&sums[size * s]);
        system_.turning[s] = 0.5 * (sum + sum.transpose());
    }
}

template <int D>
void ViscousTerms<D>::finish()
{
    share_turning();
    const int dofs = n * coupling_.system.bodies;
    if (dofs == 0)
        return;
    // Every rank adds up the same blocks in the same order.
    std::vector<double> sums(static_cast<std::size_t>(dofs) * n + dofs, 0.0);
    std::vector<Eigen::Triplet<double>> entries;
    for (int b = 0; b < coupling_.system.bodies; ++b)
        std::copy_n(own_blocks_[b].data(), n * n, sums.data() + static_cast<std::size_t>(b) * n * n);
    Eigen::Map<Eigen::VectorXd>(&sums[static_cast<std::size_t>(dofs) * n], dofs) = body_rhs_;
    grid_.comm().sum(sums);
    body_rhs_ = Eigen::Map<Eigen::VectorXd>(&sums[static_cast<std::size_t>(dofs) * n], dofs);
    system_.admissible.resize(coupling_.system.bodies);
    for (std::size_t s = 0; s < coupling_.solids.size(); ++s) {
        const int b = coupling_.free_body[s];
        if (b < 0)
            continue;
        const TwistMatrix<D>& P = coupling_.solids[s].admissible;
        const TwistMatrix<D>& M = bodies_.mass[s];
        TwistMatrix<D> turning = TwistMatrix<D>::Zero();
        turning.template bottomRightCorner<spin_size<D>, spin_size<D>>() = system_.turning[s];
        TwistMatrix<D> block = Eigen::Map<TwistMatrix<D>>(&sums[static_cast<std::size_t>(b) * n * n]);
        block += admissible_mass<D>(P, M + turning, M(0, 0));
        append<D>(b, b, block, entries);
        body_rhs_.segment<n>(n * b) += P * (M * bodies_.twists[s]);
        system_.admissible[b] = P;
    }
    add_blocks_between_bodies(entries);
    system_.body_matrix.resize(dofs, dofs);
    system_.body_matrix.setFromTriplets(entries.begin(), entries.end());
    system_.body_rhs = body_rhs_;
}

// Blocks of two different bodies (gaps that neither grid nor film resolves): few, gathered from all ranks.
template <int D>
void ViscousTerms<D>::add_blocks_between_bodies(std::vector<Eigen::Triplet<double>>& entries)
{
    const int bodies = coupling_.system.bodies;
    std::vector<double> mine;
    for (const auto& [place, block] : blocks_) {
        mine.push_back(place.first);
        mine.push_back(place.second);
        mine.insert(mine.end(), block.data(), block.data() + n * n);
    }
    std::vector<double> counts(grid_.comm().size(), 0.0);
    counts[grid_.comm().rank()] = static_cast<double>(mine.size());
    grid_.comm().sum(counts);
    long total = 0, before = 0;
    for (int r = 0; r < grid_.comm().size(); ++r) {
        before += r < grid_.comm().rank() ? static_cast<long>(counts[r]) : 0;
        total += static_cast<long>(counts[r]);
    }
    if (total == 0 || bodies < 2)
        return;
    std::vector<double> all(total, 0.0);
    std::copy(mine.begin(), mine.end(), all.begin() + before);
    grid_.comm().sum(all);
    for (long at = 0; at < total; at += 2 + n * n)
        append<D>(static_cast<int>(all[at]), static_cast<int>(all[at + 1]), Eigen::Map<TwistMatrix<D>>(&all[at + 2]), entries);
}

template class ViscousTerms<2>;
template class ViscousTerms<3>;

} // namespace gapflow
