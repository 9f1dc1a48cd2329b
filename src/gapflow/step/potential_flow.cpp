#include "gapflow/step/potential_flow.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/core/sharing.hpp"
#include "gapflow/coupling/fluid_rows.hpp"
#include "gapflow/coupling/pressure_gauge.hpp"
#include "gapflow/step/given_sides.hpp"
#include "gapflow/step/remainder.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gapflow {
namespace {

constexpr double weak_row = 1e-2; // conductance over that of a face of the grid, below which a row is settled by itself
constexpr int weak_sweeps = 4;    // slivers that are joined with each other hardly are: their faces are as small as they

template <int D>
UnknownVector<D> zero(const Coupling<D>& coupling)
{
    return {CellField<D>(*coupling.grid), Eigen::VectorXd::Zero(coupling.system.nodes)};
}

/// sum += K V of the solids that `counts`.
template <int D, class Counts>
void add_flux(const Coupling<D>& coupling, const std::vector<Twist<D>>& twists, const Counts& counts, UnknownVector<D>& sum)
{
    for (const auto& entry : coupling.cell_flux)
        if (counts(entry.body))
            sum.cells(entry.row) += entry.flux.dot(twists[entry.body]);
    for (const auto& entry : coupling.node_flux)
        if (counts(entry.body))
            sum.nodes[entry.row] += entry.flux.dot(twists[entry.body]);
}

template <int D>
void require(const SolveReport& solve)
{
    if (!solve.converged)
        throw ComputationError("the pressure solve did not converge: " + solve.message + " (" +
                               std::to_string(solve.iterations) + " iterations)");
}

template <int D>
void scale(UnknownVector<D>& v, double factor)
{
    for (long i = 0; i < v.cells.size(); ++i)
        v.cells.data()[i] *= factor;
    v.nodes *= factor;
}

struct WeakRow {
    long row;
    double diagonal, flux;
    long entries; ///< of L in it
};

/// Potentials of the rows in a list of entries, whichever rank has them.
template <int D>
class KnownRows {
public:
    /// Collective.
    KnownRows(const FluidRows<D>& L, const UnknownVector<D>& p, const std::vector<std::pair<long, double>>& entries)
    {
        for (const auto& [row, value] : entries)
            rows_.push_back(row);
        std::sort(rows_.begin(), rows_.end());
        rows_.erase(std::unique(rows_.begin(), rows_.end()), rows_.end());
        for (const long row : rows_)
            values_.push_back(!L.owns(row) ? 0.0 : L.is_cell(row) ? p.cells(L.cell(row)) : p.nodes[L.node(row)]);
        L.grid().comm().sum(values_);
    }
    double& operator()(long row) { return values_[std::lower_bound(rows_.begin(), rows_.end(), row) - rows_.begin()]; }

private:
    std::vector<long> rows_;
    std::vector<double> values_;
};

/// impulse -= Y^T flux of the free bodies, the rows of this rank.
template <int D>
void subtract_in_gauge(const Coupling<D>& coupling, const UnknownVector<D>& flux, std::vector<Twist<D>>& impulse)
{
    std::vector<int> solid(coupling.system.bodies);
    for (std::size_t s = 0; s < impulse.size(); ++s)
        if (coupling.free_body[s] >= 0)
            solid[coupling.free_body[s]] = static_cast<int>(s);
    for (const auto& entry : coupling.gauge_cells)
        impulse[solid[entry.body]] -= flux.cells(entry.row) * entry.flux;
    for (const auto& entry : coupling.gauge_nodes)
        impulse[solid[entry.body]] -= flux.nodes[entry.row] * entry.flux;
}

} // namespace

SolverOptions solver_options(const Scene& scene)
{
    SolverOptions options;
    options.tolerance = scene.tolerance;
    options.backend = scene.backend == Scene::Backend::petsc ? Backend::petsc : Backend::multigrid;
    return options;
}

template <int D>
PotentialFlow<D> flow_of_twists(const Placed<D>& at, std::vector<Twist<D>> twists, const SolverOptions& options,
                                Remainder<D> remainder, const GivenSides<D>& sides)
{
    const Coupling<D> given = with_given_twists(at.coupling);
    UnknownVector<D> rhs = remainder.empty() ? zero(given) : outflow_of_remainder(at, remainder);
    if (!given.grid->comm().root())
        rhs.nodes.setZero(); // of all ranks: it counts once in the sum below
    add_flux(
        given, twists, [](int) { return true; }, rhs);
    given.grid->comm().sum(std::span<double>(rhs.nodes.data(), rhs.nodes.size()));
    if (sides.any())
        add_to(rhs, outflow_of_sides(at, sides));
    scale(rhs, -1);
    PotentialFlow<D> flow{std::move(twists), zero(given), 0, std::move(remainder), sides};
    const SolveReport solve = CoupledSolver<D>(given.system, options).solve(flow.p, rhs);
    require<D>(solve);
    flow.iterations = solve.iterations;
    settle_weak_rows(at, flow);
    return flow;
}

template <int D>
UnknownVector<D> flux_of_twists(const Coupling<D>& coupling, const std::vector<Twist<D>>& twists)
{
    UnknownVector<D> flux = zero(coupling);
    add_flux(
        coupling, twists, [](int) { return true; }, flux);
    coupling.grid->comm().sum(std::span<double>(flux.nodes.data(), flux.nodes.size()));
    return flux;
}

template <int D>
void settle_weak_rows(const Placed<D>& at, PotentialFlow<D>& flow)
{
    UnknownVector<D> outflow;
    if (!flow.remainder.empty())
        add_to(outflow, outflow_of_remainder(at, flow.remainder));
    if (flow.sides.any())
        add_to(outflow, outflow_of_sides(at, flow.sides));
    settle_weak_rows(at.complex, at.coupling, outflow, flow);
}

template <int D>
void settle_weak_rows(const Complex<D>& complex, const Coupling<D>& coupling, const UnknownVector<D>& outflow,
                      PotentialFlow<D>& flow)
{
    const FluidRows<D> L(coupling);
    const double weak = weak_row * std::pow(coupling.grid->dx(), D - 2) / coupling.density;
    std::vector<WeakRow> rows;
    const auto offer = [&](long row) {
        if (const double diagonal = L.diagonal(row); diagonal > 0 && diagonal < weak)
            rows.push_back({row, diagonal, 0, 0});
    };
    for (int c = 0; c < complex.cut_cells(); ++c)
        if (const Index<D> cell = complex.index.index(complex.cut_cell[c]); coupling.grid->owns(cell))
            offer(L.row(cell));
    std::sort(rows.begin(), rows.end(), [](const WeakRow& a, const WeakRow& b) { return a.row < b.row; });
    for (int node = 0; node < coupling.system.nodes; ++node)
        if (coupling.system.owns(node))
            offer(L.row(node));
    const Communicator& comm = coupling.grid->comm();
    if (!comm.any(!rows.empty()))
        return;
    const auto add = [&](long row, double flux) {
        const auto found = std::lower_bound(rows.begin(), rows.end(), row, [](const WeakRow& r, long n) { return r.row < n; });
        if (found != rows.end() && found->row == row)
            found->flux += flux;
    };
    for (const auto& entry : coupling.cell_flux)
        add(L.row(entry.row), entry.flux.dot(flow.twists[entry.body]));
    for (const auto& entry : coupling.node_flux)
        add(L.row(entry.row), entry.flux.dot(flow.twists[entry.body]));
    if (outflow.cells.size() > 0)
        for (WeakRow& row : rows)
            row.flux += L.is_cell(row.row) ? outflow.cells(L.cell(row.row)) : outflow.nodes[L.node(row.row)];
    std::vector<std::pair<long, double>> entries; // row by row
    for (WeakRow& row : rows) {
        const std::size_t before = entries.size();
        L.for_each(row.row, [&](long other, double value) { entries.emplace_back(other, value); });
        row.entries = static_cast<long>(entries.size() - before);
    }
    if (comm.size() > 1) {
        rows = all_values(comm, rows);
        entries = all_values(comm, entries);
    }
    std::vector<std::size_t> first{0}, order;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        first.push_back(first.back() + rows[k].entries);
        order.push_back(k);
    }
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return rows[a].row < rows[b].row; });
    KnownRows<D> p(L, flow.p, entries);
    for (int sweep = 0; sweep < weak_sweeps; ++sweep)
        for (const std::size_t k : order) {
            double sum = -rows[k].flux;
            for (std::size_t e = first[k]; e < first[k + 1]; ++e) {
                const auto& [other, value] = entries[e];
                sum -= other == rows[k].row ? 0.0 : value * p(other);
            }
            p(rows[k].row) = sum / rows[k].diagonal;
        }
    for (const WeakRow& row : rows)
        if (!L.is_cell(row.row))
            flow.p.nodes[L.node(row.row)] = p(row.row);
        else if (L.owns(row.row))
            flow.p.cells(L.cell(row.row)) = p(row.row);
}

template <int D>
std::vector<Twist<D>> impulses_of_given(const Coupling<D>& coupling, const std::vector<Twist<D>>& twists)
{
    const Communicator& comm = coupling.grid->comm();
    std::vector<Twist<D>> impulse(twists.size(), Twist<D>::Zero());
    const auto given = [&](int solid) { return coupling.free_body[solid] < 0; };
    for (const NormalInertia<D>& gap : coupling.normal_inertia) {
        const std::array<int, 2> solid{gap.master, gap.other};
        const std::array<const Twist<D>*, 2> row{&gap.row_master, &gap.row_other};
        double speed = 0;
        for (int k = 0; k < 2; ++k)
            if (given(solid[k]))
                speed += row[k]->dot(twists[solid[k]]);
        for (int k = 0; k < 2 && speed != 0; ++k)
            if (!given(solid[k]))
                impulse[solid[k]] -= gap.mass * speed * *row[k];
    }
    if (!coupling.gauge_cells.empty() || !coupling.gauge_nodes.empty()) {
        UnknownVector<D> flux = zero(coupling);
        add_flux(coupling, twists, given, flux);
        subtract_in_gauge(coupling, flux, impulse);
    }
    if (!impulse.empty())
        comm.sum(std::span<double>(impulse.data()->data(), impulse.size() * twist_size<D>));
    return impulse;
}

template <int D>
std::vector<Twist<D>> impulses_of_outflow(const Coupling<D>& coupling, const UnknownVector<D>& outflow)
{
    std::vector<Twist<D>> impulse(coupling.solids.size(), Twist<D>::Zero());
    subtract_in_gauge(coupling, outflow, impulse);
    if (!impulse.empty())
        coupling.grid->comm().sum(std::span<double>(impulse.data()->data(), impulse.size() * twist_size<D>));
    return impulse;
}

template <int D>
std::vector<Twist<D>> fluid_impulse(const Placed<D>& at, const PotentialFlow<D>& flow)
{
    const Coupling<D>& coupling = at.coupling;
    std::vector<Twist<D>> impulse = impulses(coupling, flow.p);
    for (std::size_t s = 0; s < impulse.size(); ++s)
        impulse[s] = coupling.seen_mass[s] * flow.twists[s] - impulse[s];
    std::vector<Twist<D>> gaps(impulse.size(), Twist<D>::Zero());
    for (const NormalInertia<D>& gap : coupling.normal_inertia) {
        const double speed = gap.row_master.dot(flow.twists[gap.master]) + gap.row_other.dot(flow.twists[gap.other]);
        gaps[gap.master] += gap.mass * speed * gap.row_master;
        gaps[gap.other] += gap.mass * speed * gap.row_other;
    }
    if (!gaps.empty())
        coupling.grid->comm().sum(std::span<double>(gaps.data()->data(), gaps.size() * twist_size<D>));
    for (std::size_t s = 0; s < impulse.size(); ++s)
        impulse[s] += gaps[s];
    if (!flow.remainder.empty()) {
        const std::vector<Twist<D>> rest = impulse_of_remainder(at, flow.remainder);
        for (std::size_t s = 0; s < impulse.size(); ++s)
            impulse[s] += rest[s];
    }
    return impulse;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template PotentialFlow<D> flow_of_twists<D>(const Placed<D>&, std::vector<Twist<D>>, const SolverOptions&, Remainder<D>,   \
                                                const GivenSides<D>&);                                                         \
    template UnknownVector<D> flux_of_twists<D>(const Coupling<D>&, const std::vector<Twist<D>>&);                             \
    template void settle_weak_rows<D>(const Placed<D>&, PotentialFlow<D>&);                                                    \
    template void settle_weak_rows<D>(const Complex<D>&, const Coupling<D>&, const UnknownVector<D>&, PotentialFlow<D>&);      \
    template std::vector<Twist<D>> impulses_of_given<D>(const Coupling<D>&, const std::vector<Twist<D>>&);                     \
    template std::vector<Twist<D>> impulses_of_outflow<D>(const Coupling<D>&, const UnknownVector<D>&);                        \
    template std::vector<Twist<D>> fluid_impulse<D>(const Placed<D>&, const PotentialFlow<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
