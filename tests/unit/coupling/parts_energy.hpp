// The energy of parts by a direct solve, and random scenes of every kind of shape.
#pragma once

#include "../grid/scenes.hpp"

#include "gapflow/coupling/parts.hpp"

#include <Eigen/SparseCholesky>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>

namespace gapflow::testing {

/// Complex, coupled system and impulses of solids that set fluid at rest moving with given twists.
template <int D>
struct PartsEnergy {
    FaceDerivatives<D> derivatives;
    Complex<D> complex; // fills the derivatives
    std::vector<GapArm<D>> arms;
    Inertia<D> inertia;
    Coupling<D> coupling;
    std::vector<Twist<D>> twists;
    UnknownVector<D> p;
    double energy = 0;
    bool crushed = false; ///< a pocket changes its volume: no energy

    PartsEnergy(const Grid<D>& grid, const std::vector<Solid<D>>& solids, const std::vector<Twist<D>>& twists_,
                bool with_derivatives, const Standoffs<D>& standoffs = {})
        : complex(build_complex<D>(grid, solids, with_derivatives ? &derivatives : nullptr, nullptr, false)),
          arms(find_gap_arms<D>(grid, solids, complex, standoffs)), inertia(find_inertia<D>(grid, complex, arms)),
          coupling(couple_parts<D>(grid, solids, {}, 1.3, complex, inertia)),
          twists(twists_), p{CellField<D>(grid), Eigen::VectorXd::Zero(coupling.system.nodes)}
    {
        solve(grid);
    }

    /// Whether D of a solid is less negative than the complex has it.
    bool limited(std::size_t s) const
    {
        const double change = coupling.seen_mass[s].template topLeftCorner<D, D>().trace() /
                                  (coupling.density * std::pow(coupling.grid->dx(), D)) -
                              complex.seen_mass[s].template topLeftCorner<D, D>().trace();
        return change > 1e-9 * complex.seen_mass[s].norm();
    }
    std::vector<Twist<D>> derivative() const
    {
        const GapDerivatives<D> gaps(*coupling.grid, coupling.solids, complex, arms);
        return energy_derivative<D>(coupling, complex, derivatives, p, twists, &gaps, inertia.pairs);
    }

private:
    void solve(const Grid<D>& grid)
    {
        const CoupledSystem<D>& system = coupling.system;
        const int cells = static_cast<int>(complex.index.count), n = cells + system.nodes;
        std::vector<Eigen::Triplet<double>> entries;
        const auto add = [&](int i, int j, double value) { entries.emplace_back(i, j, value); };
        const auto unknown = [&](const Index<D>& c) { return complex.cell[complex.index(c)] != Complex<D>::solid; };
        std::vector<int> component(n, -1);
        for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
            const int i = complex.index(c);
            if (!unknown(c))
                return;
            component[i] = system.component(c);
            for (int axis = 0; axis < D; ++axis)
                for (int side = 0; side < 2; ++side) {
                    const double g = system.conductance(axis, Index<D>(c + side * step<D>(axis)));
                    const Index<D> other = grid.wrapped(Index<D>(c + (2 * side - 1) * step<D>(axis)));
                    if (!grid.in_domain(other))
                        add(i, i, g);
                    else if (unknown(other)) {
                        add(i, i, g);
                        add(i, complex.index(other), -g);
                    }
                }
        });
        for (int i = 0; i < system.nodes; ++i) {
            component[cells + i] = system.node_component[i];
            for (Eigen::SparseMatrix<double>::InnerIterator at(system.film, i); at; ++at)
                add(cells + i, cells + static_cast<int>(at.row()), at.value());
        }
        for (const Link& link : system.links) {
            std::vector<std::pair<int, double>> ends;
            for (const auto& [node, weight] : link.nodes)
                ends.push_back({cells + node, weight});
            for (const auto& [key, weight] : link.cells)
                ends.push_back({complex.index(grid.cell_of_key(key)), weight});
            for (const auto& [i, wi] : ends)
                for (const auto& [j, wj] : ends)
                    add(i, j, link.conductance * wi * wj);
        }
        Eigen::VectorXd flux = Eigen::VectorXd::Zero(n);
        for (const auto& entry : coupling.cell_flux)
            flux[complex.index(entry.row)] += entry.flux.dot(twists[entry.body]);
        for (const auto& entry : coupling.node_flux)
            flux[cells + entry.row] += entry.flux.dot(twists[entry.body]);
        // One level of each component that nothing else fixes.
        std::vector<double> sum(system.components.size(), 0);
        std::vector<char> fixed(system.components.size(), 0);
        for (int i = 0; i < n; ++i) {
            if (component[i] < 0) {
                add(i, i, 1);
                flux[i] = 0;
                continue;
            }
            sum[component[i]] += flux[i];
            if (!system.components[component[i]].grounded && !std::exchange(fixed[component[i]], 1))
                add(i, i, 1);
        }
        for (std::size_t c = 0; c < sum.size(); ++c)
            crushed = crushed || (!system.components[c].grounded && std::abs(sum[c]) > 1e-9 * flux.lpNorm<1>());
        Eigen::SparseMatrix<double> matrix(n, n);
        matrix.setFromTriplets(entries.begin(), entries.end());
        const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(matrix);
        Eigen::VectorXd x = factors.solve(flux);
        x += factors.solve(Eigen::VectorXd(flux - matrix * x));
        energy = 0.5 * x.dot(flux);
        for (std::size_t s = 0; s < twists.size(); ++s)
            energy += 0.5 * twists[s].dot(coupling.seen_mass[s] * twists[s]);
        for (const NormalInertia<D>& gap : coupling.normal_inertia) {
            const double speed = gap.row_master.dot(twists[gap.master]) + gap.row_other.dot(twists[gap.other]);
            energy += 0.5 * gap.mass * speed * speed;
        }
        for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) { p.cells(c) = -x[complex.index(c)]; });
        p.nodes = -x.tail(system.nodes);
    }
};

/// What a pose's derivative is, against differences.
struct PoseError {
    double error = 0; ///< largest of a component, over the largest derivative
    double jump = 0;  ///< of T between the two sides of the worst component's difference, over T
    int solid = -1, component = -1;
    bool crushed = false;
    bool limited = false; ///< D of a solid is
};

/// All components of all solids but walls. `standoffs`: of solids at their places.
template <int D>
PoseError compare(
    const Grid<D>& grid, const std::vector<Solid<D>>& solids, const std::vector<Twist<D>>& twists,
    const std::function<Standoffs<D>(const std::vector<Solid<D>>&)>& standoffs = [](const auto&) { return Standoffs<D>(); })
{
    const PartsEnergy<D> here(grid, solids, twists, true, standoffs(solids));
    PoseError result;
    result.crushed = here.crushed;
    if (here.crushed)
        return result;
    for (std::size_t s = 0; s < solids.size(); ++s)
        result.limited = result.limited || here.limited(s);
    const std::vector<Twist<D>> derivative = here.derivative();
    // In cells and radians; a flow whose T does not depend on the place has none to compare with.
    double largest = 1e-2 * here.energy;
    for (std::size_t s = 0; s < solids.size(); ++s)
        for (int c = 0; c < twist_size<D>; ++c)
            largest = std::max(largest, std::abs(derivative[s][c] * (c < D ? grid.dx() : 1.0)));
    for (std::size_t s = 0; s < solids.size(); ++s) {
        if (solids[s].wall)
            continue;
        for (int c = 0; c < twist_size<D>; ++c) {
            const double own = derivative[s][c] * (c < D ? grid.dx() : 1.0);
            double least = std::numeric_limits<double>::infinity(), jump = 0;
            // Places are rounded to 2^-36 of a cell: a translation's step is a multiple of it, a rotation's is larger. T is known to some 1e-12 beside rims:
            // where the small step does not do, a larger one decides.
            for (const double step : {c < D ? 0x1p-20 : 0x1p-17, 0x1p-14}) {
                if (least <= 1e-6)
                    continue;
                const auto difference = [&](double length) { // of T, over twice its length
                    std::array<double, 2> T;
                    for (int side = 0; side < 2; ++side) {
                        std::vector<Solid<D>> at = solids;
                        at[s] = moved(solids[s], c, side ? length : -length, grid.dx());
                        T[side] = PartsEnergy<D>(grid, at, twists, false, standoffs(at)).energy;
                    }
                    return (T[1] - T[0]) / (2 * length);
                };
                const double once = difference(step), twice = difference(2 * step); // of fourth order: gaps are short
                if (const double error = std::abs((4 * once - twice) / 3 - own) / largest; error < least) {
                    least = error;
                    jump = std::abs(once * 2 * step) / here.energy;
                }
            }
            if (least >= result.error) {
                result.error = least;
                result.jump = jump;
                result.solid = static_cast<int>(s);
                result.component = c;
            }
        }
    }
    return result;
}

} // namespace gapflow::testing
