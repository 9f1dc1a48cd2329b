// Added masses of a coupled system of parts by a direct solve.
#pragma once

#include "gapflow/coupling/coupling.hpp"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>

#include <algorithm>

namespace gapflow {

/// K^T L^-1 K + D and the mass of the gaps, of all solids but walls by their twists. In fluid without a way out the level is free, and a motion that changes its
/// volume has a large mass. `cancelled`: largest share of the fluid in an entry of the diagonal over that entry, which stiff links make large: round-off is taken
/// times that.
template <int D>
Eigen::MatrixXd direct_added_mass(const Coupling<D>& coupling, double* cancelled = nullptr)
{
    constexpr int T = twist_size<D>;
    const CoupledSystem<D>& system = coupling.system;
    const Grid<D>& grid = *coupling.grid;
    std::vector<int> place(coupling.solids.size(), -1);
    int solids = 0;
    for (std::size_t s = 0; s < coupling.solids.size(); ++s)
        if (!coupling.solids[s].wall)
            place[s] = solids++;
    CellField<D, int> number(grid, -1);
    std::vector<int> component(system.node_component);
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
        if (system.component(c) >= 0) {
            number(c) = static_cast<int>(component.size());
            component.push_back(system.component(c));
        }
    });
    const int n = static_cast<int>(component.size());
    std::vector<Eigen::Triplet<double>> entries;
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
        const int i = number(c);
        for (int axis = 0; axis < D && i >= 0; ++axis)
            for (int side = 0; side < 2; ++side) {
                const double g = system.conductance(axis, Index<D>(c + side * step<D>(axis)));
                const Index<D> other = grid.wrapped(Index<D>(c + (2 * side - 1) * step<D>(axis)));
                if (!(g > 0))
                    continue;
                entries.emplace_back(i, i, g);
                if (grid.in_domain(other))
                    entries.emplace_back(i, number(other), -g);
            }
    });
    for (int i = 0; i < system.nodes; ++i)
        for (Eigen::SparseMatrix<double>::InnerIterator at(system.film, i); at; ++at)
            entries.emplace_back(i, static_cast<int>(at.row()), at.value());
    for (const Link& link : system.links) {
        std::vector<std::pair<int, double>> ends(link.nodes.begin(), link.nodes.end());
        for (const auto& [key, weight] : link.cells)
            ends.emplace_back(number(grid.cell_of_key(key)), weight);
        for (const auto& [i, wi] : ends)
            for (const auto& [j, wj] : ends)
                entries.emplace_back(i, j, link.conductance * wi * wj);
    }
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, T * solids), mass = Eigen::MatrixXd::Zero(T * solids, T * solids);
    for (const auto& e : coupling.cell_flux)
        K.row(number(e.row)).template segment<T>(T * place[e.body]) += e.flux.transpose();
    for (const auto& e : coupling.node_flux)
        K.row(e.row).template segment<T>(T * place[e.body]) += e.flux.transpose();
    for (const NormalInertia<D>& i : coupling.normal_inertia) {
        Eigen::VectorXd row = Eigen::VectorXd::Zero(T * solids);
        if (place[i.master] >= 0)
            row.segment<T>(T * place[i.master]) += i.row_master;
        if (place[i.other] >= 0)
            row.segment<T>(T * place[i.other]) += i.row_other;
        mass += i.mass * row * row.transpose();
    }
    for (std::size_t s = 0; s < coupling.solids.size(); ++s)
        if (place[s] >= 0 && !coupling.seen_mass.empty())
            mass.block<T, T>(T * place[s], T * place[s]) += coupling.seen_mass[s];
    // One level of each closed component, and what changes its volume.
    const int components = static_cast<int>(system.components.size());
    Eigen::MatrixXd closed = Eigen::MatrixXd::Zero(components, T * solids);
    std::vector<int> first(components, -1), size(components, 0);
    for (int i = 0; i < n; ++i) {
        const int k = component[i];
        ++size[k];
        if (system.components[k].grounded)
            continue;
        if (first[k] < 0) {
            first[k] = i;
            entries.emplace_back(i, i, 1.0);
        }
        closed.row(k) += K.row(i);
    }
    for (int i = 0; i < n; ++i)
        K.row(i) -= closed.row(component[i]) / size[component[i]];
    using Real = long double;
    using RealMatrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
    Eigen::SparseMatrix<Real> L(n, n);
    L.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<Real>> factors(L);
    const RealMatrix flux = K.cast<Real>();
    RealMatrix p = factors.solve(flux);
    p += factors.solve(RealMatrix(flux - L * p));
    const RealMatrix product = flux.transpose() * p;
    const Eigen::MatrixXd fluid = (Real(0.5) * (product + product.transpose())).cast<double>();
    mass += fluid;
    if (cancelled) {
        *cancelled = 1;
        for (int i = 0; i < mass.rows(); ++i)
            if (mass(i, i) > 1e-12 * mass.diagonal().maxCoeff())
                *cancelled = std::max(*cancelled, fluid(i, i) / mass(i, i));
    }
    const double heavy = 1e3;
    return mass + heavy * closed.transpose() * closed;
}

} // namespace gapflow
