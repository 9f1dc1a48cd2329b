#include "gapflow/coupling/pressure_gauge.hpp"

#include "gapflow/coupling/close_bodies.hpp"
#include "gapflow/coupling/displaced_mass.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gapflow {

namespace {

// A body's own mass over what D takes from it, below which the gauge changes. Above it M is positive; the choice moves no result.
constexpr double heavy = 2;

/// A^T B of entries by row.
template <int D>
void add_product(const std::vector<RowEntry<D>>& A, const std::vector<RowEntry<D>>& B, std::vector<Eigen::Triplet<double>>& sum)
{
    constexpr int n = twist_size<D>;
    auto b = B.begin();
    for (const RowEntry<D>& a : A) {
        while (b != B.end() && b->row < a.row)
            ++b;
        for (auto other = b; other != B.end() && other->row == a.row; ++other)
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j)
                    if (const double value = a.flux[i] * other->flux[j]; value != 0)
                        sum.emplace_back(n * a.body + i, n * other->body + j, value);
    }
}

/// Y of every solid, for the inertia of the layers of fluid beside them.
template <int D>
class Layers {
public:
    /// Collective, as inertias() is.
    explicit Layers(const Coupling<D>& coupling)
        : coupling_(coupling), L_(coupling), Y_(L_, coupling.cell_flux, coupling.node_flux), places_(coupling.solids.size())
    {
        const Grid<D>& grid = L_.grid();
        const auto add_row = [&](long row, long local, const Index<D>& cell) {
            const auto entries = Y_.of(local);
            if (entries.empty())
                return;
            const double bound = L_.bound(row), diagonal = L_.diagonal(row);
            for (auto& entry : entries) {
                entry.flux *= bound > 0 ? 1 / bound : 0.0;
                places_[entry.body].push_back({row, cell, 2 * bound - diagonal, entry.flux});
                if (grid.comm().size() > 1 && L_.seen_from_below(row))
                    seen_.push_back({row, entry.body, entry.flux});
            }
        };
        long local = 0;
        for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) { add_row(L_.row(c), local++, c); });
        for (int node = 0; node < coupling.system.nodes; ++node)
            if (coupling.system.owns(node))
                add_row(L_.row(node), L_.local(node), {});
        if (grid.comm().size() > 1) {
            seen_ = all_values(grid.comm(), seen_);
            std::sort(seen_.begin(), seen_.end(), comes_before<D>);
        }
    }

    /// Y^T (2 Lambda - L) Y: its diagonal in the rows, and the conductance between every two of them.
    std::vector<TwistMatrix<D>> inertias() const
    {
        std::vector<TwistMatrix<D>> sums(places_.size(), TwistMatrix<D>::Zero());
        for_each_job(static_cast<int>(places_.size()), [&](int s) {
            TwistMatrix<D> sum = TwistMatrix<D>::Zero(); // half of it, but for its transpose
            for (const Place& place : places_[s]) {
                sum.noalias() += Twist<D>(0.5 * place.diagonal * place.flux) * place.flux.transpose();
                add_behind(s, place, sum);
            }
            sums[s] = sum + sum.transpose();
        });
        if (!sums.empty())
            L_.grid().comm().sum(std::span<double>(sums.data()->data(), sums.size() * sums.data()->size()));
        return sums;
    }

private:
    struct Place {
        long row;
        Index<D> cell;   ///< of a cell's row
        double diagonal; ///< of 2 Lambda - L
        Twist<D> flux;   ///< Y
    };

    const Twist<D>* find(int solid, long local) const
    {
        for (const auto& entry : Y_.of(local))
            if (entry.body == solid)
                return &entry.flux;
        return nullptr;
    }
    const Twist<D>* find_row(int solid, long row) const
    {
        if (L_.owns(row))
            return find(solid, L_.local(row));
        const auto other = std::lower_bound(seen_.begin(), seen_.end(), RowEntry<D>{row, solid, {}}, comes_before<D>);
        return other != seen_.end() && other->row == row && other->body == solid ? &other->flux : nullptr;
    }

    /// g Y_P Y_Q^T with the rows Q behind P: every pair once.
    void add_behind(int s, const Place& place, TwistMatrix<D>& sum) const
    {
        const CoupledSystem<D>& system = coupling_.system;
        const auto add = [&](const Twist<D>* other, double conductance) {
            if (other)
                sum.noalias() += Twist<D>(conductance * place.flux) * other->transpose();
        };
        if (L_.is_cell(place.row)) {
            const Grid<D>& grid = L_.grid();
            const long local = L_.local(place.cell);
            for (int axis = 0; axis < D; ++axis) {
                const Index<D> next = place.cell + step<D>(axis);
                const double g = system.conductance(axis, next);
                if (next[axis] < grid.high()[axis])
                    add(g > 0 ? find(s, local + L_.stride(axis)) : nullptr, g);
                else if (const Index<D> beside = grid.wrapped(next); g > 0 && grid.in_domain(beside))
                    add(find_row(s, L_.row(beside)), g);
            }
        } else {
            const int node = L_.node(place.row);
            for (Eigen::SparseMatrix<double>::InnerIterator entry(system.film, node); entry; ++entry)
                if (entry.row() > node)
                    add(find_row(s, L_.row(static_cast<int>(entry.row()))), -entry.value());
        }
        L_.for_each_link(place.row, [&](const Link& link, const auto& all) {
            double own = 0;
            for (const auto& [row, weight] : all) {
                if (own != 0)
                    add(find_row(s, row), -link.conductance * own * weight);
                own = row == place.row ? weight : own;
            }
        });
    }

    const Coupling<D>& coupling_;
    FluidRows<D> L_;
    BodyRows<D> Y_;
    std::vector<std::vector<Place>> places_;
    std::vector<RowEntry<D>> seen_; ///< by other ranks
};

/// K of one solid.
template <int D>
std::vector<RowEntry<D>> fluxes_of(const Coupling<D>& coupling, const FluidRows<D>& L, int solid)
{
    std::vector<RowEntry<D>> K;
    for (const auto& entry : coupling.cell_flux)
        if (entry.body == solid)
            K.push_back({L.row(entry.row), solid, entry.flux});
    for (const auto& entry : coupling.node_flux)
        if (entry.body == solid)
            K.push_back({L.row(entry.row), solid, entry.flux});
    return K;
}

/// The same bits on all ranks.
Eigen::SparseMatrix<double> sum_of_ranks(const Communicator& comm, const Eigen::SparseMatrix<double>& own)
{
    std::vector<Eigen::Triplet<double>> entries;
    for (int column = 0; column < own.outerSize(); ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(own, column); entry; ++entry)
            entries.emplace_back(static_cast<int>(entry.row()), column, entry.value());
    entries = all_values(comm, entries);
    Eigen::SparseMatrix<double> sum(own.rows(), own.cols());
    sum.setFromTriplets(entries.begin(), entries.end());
    return sum;
}

template <int D>
void change_gauge(Coupling<D>& coupling)
{
    CoupledSystem<D>& system = coupling.system;
    const BodyLayers<D> layers(coupling);
    const FluidRows<D>& L = layers.rows();
    std::vector<RowEntry<D>> K, Y;
    for (const auto& entry : system.cell_flux)
        K.push_back({L.row(entry.row), entry.body, entry.flux});
    for (const auto& entry : system.node_flux)
        K.push_back({L.row(entry.row), entry.body, entry.flux});
    merge_entries(K);
    for (const RowEntry<D>& entry : K)
        if (const double bound = layers.bound(entry.row); bound > 0)
            Y.push_back({entry.row, entry.body, entry.flux / bound});
    std::vector<RowEntry<D>> changed = K, others;
    for (const RowEntry<D>& y : Y)
        L.for_each(y.row, [&](long row, double value) {
            (L.owns(row) ? changed : others).push_back({row, y.body, -value * y.flux});
        });
    if (L.grid().comm().size() > 1)
        for (const RowEntry<D>& entry : all_values(L.grid().comm(), others))
            if (L.owns(entry.row))
                changed.push_back(entry);
    merge_entries(changed);

    std::vector<Eigen::Triplet<double>> added; // Y^T K + K'^T Y
    add_product(Y, K, added);
    add_product(changed, Y, added);
    Eigen::SparseMatrix<double> mass(system.mass.rows(), system.mass.cols());
    mass.setFromTriplets(added.begin(), added.end());
    if (L.grid().comm().size() > 1)
        mass = sum_of_ranks(L.grid().comm(), mass);
    system.mass += 0.5 * (mass + Eigen::SparseMatrix<double>(mass.transpose()));

    system.cell_flux.clear();
    system.node_flux.clear();
    for (const RowEntry<D>& entry : changed)
        if (L.is_cell(entry.row))
            system.cell_flux.push_back({L.cell(entry.row), entry.body, entry.flux});
        else
            system.node_flux.push_back({L.node(entry.row), entry.body, entry.flux});
    for (const RowEntry<D>& entry : Y)
        if (L.is_cell(entry.row))
            coupling.gauge_cells.push_back({L.cell(entry.row), entry.body, entry.flux});
        else
            coupling.gauge_nodes.push_back({L.node(entry.row), entry.body, entry.flux});
}

} // namespace

template <int D>
std::vector<TwistMatrix<D>> layer_inertias(const Coupling<D>& coupling)
{
    return Layers<D>(coupling).inertias();
}

template <int D>
void limit_deficits(Coupling<D>& coupling)
{
    const std::vector<TwistMatrix<D>> layers = layer_inertias(coupling);
    for_each_job(static_cast<int>(layers.size()), [&](int s) {
        TwistMatrix<D>& seen = coupling.seen_mass[s];
        if (seen.isZero(0) && coupling.gap_deficit[s].isZero(0))
            return;
        const TwistMatrix<D> rest = layers[s] - coupling.gap_deficit[s], sum = seen + rest;
        seen = ScaledModes<D>(sum, displaced_mass(coupling.solids[s], coupling.density)).positive_part(sum) - rest;
    });
    limit_close_deficits(coupling);
}

template <int D>
LimitRate<D> limit_rate(const Solid<D>& solid, double density, const TwistMatrix<D>& seen, const TwistMatrix<D>& layer,
                        const Twist<D>& V)
{
    constexpr int n = twist_size<D>;
    const TwistMatrix<D> sum = seen + layer;
    const ScaledModes<D> scaled(sum, displaced_mass(solid, density));
    const TwistMatrix<D>& Q = scaled.modes.eigenvectors();
    const Twist<D> own = scaled.root.matrixU() * V, a = Q.transpose() * own;
    TwistMatrix<D> by_sum; // V . d(sum)_+ V = by_sum : d(sum)
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            by_sum(i, j) = scaled.slope(i, j) * a[i] * a[j];
    by_sum = Q * by_sum * Q.transpose();
    LimitRate<D> rate;
    const auto add_modes = [&](const TwistMatrix<D>& of, std::vector<WeightedTwist<D>>& to) {
        const Eigen::SelfAdjointEigenSolver<TwistMatrix<D>> modes(of);
        const double least = std::numeric_limits<double>::epsilon() * modes.eigenvalues().cwiseAbs().maxCoeff();
        for (int k = 0; k < n; ++k)
            if (std::abs(modes.eigenvalues()[k]) > least)
                to.push_back({modes.eigenvalues()[k], scaled.root.matrixU().solve(modes.eigenvectors().col(k))});
    };
    add_modes(by_sum, rate.seen);
    add_modes(by_sum - own * own.transpose(), rate.layer);
    const TwistMatrix<D> in_world = scaled.root.matrixU().solve(scaled.root.matrixU().solve(by_sum).transpose()), // symmetric
        turned = in_world * sum;
    const Twist<D> impulse = scaled.positive_part(sum) * V;
    for (int k = 0; k < spin_size<D>; ++k) {
        TwistMatrix<D> turn = TwistMatrix<D>::Zero(); // of a twist's components
        for (int axis = 0; axis < D; ++axis) {
            turn.template topLeftCorner<D, D>().col(axis) = spin_velocity<D>(Spin<D>::Unit(k), unit<D>(axis));
            if constexpr (D == 3)
                turn.template bottomRightCorner<D, D>().col(axis) = spin_velocity<D>(Spin<D>::Unit(k), unit<D>(axis));
        }
        rate.turn[k] = (turn * turned).trace() + V.dot(turn * impulse);
    }
    return rate;
}

template <int D>
JacobiSteps<D> jacobi_steps(const Coupling<D>& coupling, int solid, const Twist<D>& z)
{
    const FluidRows<D> L(coupling);
    std::vector<RowEntry<D>> K = fluxes_of(coupling, L, solid);
    merge_entries(K);
    const UnknownVector<D> none{CellField<D>(*coupling.grid), Eigen::VectorXd::Zero(coupling.system.nodes)};
    JacobiSteps<D> steps{none, none};
    const auto at = [&](UnknownVector<D>& v, long row) -> double& {
        return L.is_cell(row) ? v.cells(L.cell(row)) : v.nodes[L.node(row)];
    };
    std::vector<std::pair<long, double>> rest, others; // of own rows, and of other ranks'
    for (const RowEntry<D>& k : K)
        if (const double bound = L.bound(k.row); bound > 0) {
            const double flux = k.flux.dot(z), y = flux / bound;
            at(steps.first, k.row) = y;
            rest.emplace_back(k.row, flux);
            L.for_each(k.row, [&](long row, double value) { (L.owns(row) ? rest : others).emplace_back(row, -value * y); });
        }
    if (L.grid().comm().size() > 1)
        for (const auto& [row, flux] : all_values(L.grid().comm(), others))
            if (L.owns(row))
                rest.emplace_back(row, flux);
    for (const auto& [row, flux] : rest)
        at(steps.next, row) += flux / L.bound(row);
    take_from_owners(coupling.system, steps.first.nodes);
    take_from_owners(coupling.system, steps.next.nodes);
    return steps;
}

template <int D>
void add_seen_mass(Coupling<D>& coupling)
{
    constexpr int n = twist_size<D>;
    CoupledSystem<D>& system = coupling.system;
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](int a, int b, const TwistMatrix<D>& mass) {
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j)
                if (mass(i, j) != 0)
                    entries.emplace_back(n * a + i, n * b + j, mass(i, j));
    };
    bool light = false; // any of them
    for (std::size_t s = 0; s < coupling.solids.size(); ++s)
        if (const int b = coupling.free_body[s]; b >= 0) {
            const TwistMatrix<D>& P = coupling.solids[s].admissible;
            const TwistMatrix<D> seen = P * coupling.seen_mass[s] * P, own = system.mass.block(n * b, n * b, n, n);
            add(b, b, seen);
            light = light ||
                    Eigen::LLT<TwistMatrix<D>>(own + heavy * (seen - P * coupling.gap_deficit[s] * P)).info() != Eigen::Success;
        }
    const Communicator& comm = coupling.grid->comm();
    for (const NormalInertia<D>& gap : comm.size() == 1 ? coupling.normal_inertia : all_values(comm, coupling.normal_inertia)) {
        const std::array<int, 2> body{coupling.free_body[gap.master], coupling.free_body[gap.other]};
        const std::array<Twist<D>, 2> row{coupling.solids[gap.master].admissible * gap.row_master,
                                          coupling.solids[gap.other].admissible * gap.row_other};
        for (int i = 0; i < 2; ++i)
            for (int j = 0; j < 2; ++j)
                if (body[i] >= 0 && body[j] >= 0)
                    add(body[i], body[j], gap.mass * row[i] * row[j].transpose());
    }
    Eigen::SparseMatrix<double> seen(system.mass.rows(), system.mass.cols());
    seen.setFromTriplets(entries.begin(), entries.end());
    system.mass += seen;
    if (light) // the gauge of all: beside a body without it the rows that both have would leave products of K and Y, and no squares
        change_gauge(coupling);
    system.response = BodyResponse(system.mass, {}, {});
}

template <int D>
void enter_gauge(const Coupling<D>& coupling, const std::vector<Twist<D>>& twists, UnknownVector<D>& outflow)
{
    const Communicator& comm = coupling.grid->comm();
    if (!comm.any(!coupling.gauge_cells.empty() || !coupling.gauge_nodes.empty()))
        return;
    const CoupledSystem<D>& system = coupling.system;
    Eigen::VectorXd nodes = Eigen::VectorXd::Zero(system.nodes);
    std::vector<Twist<D>> free(system.bodies);
    for (std::size_t s = 0; s < twists.size(); ++s)
        if (const int b = coupling.free_body[s]; b >= 0)
            free[b] = twists[s];
    for (const auto& entry : system.cell_flux)
        outflow.cells(entry.row) += entry.flux.dot(free[entry.body]);
    for (const auto& entry : system.node_flux)
        nodes[entry.row] += entry.flux.dot(free[entry.body]);
    for (const auto& entry : coupling.cell_flux)
        if (coupling.free_body[entry.body] >= 0)
            outflow.cells(entry.row) -= entry.flux.dot(twists[entry.body]);
    for (const auto& entry : coupling.node_flux)
        if (coupling.free_body[entry.body] >= 0)
            nodes[entry.row] -= entry.flux.dot(twists[entry.body]);
    comm.sum(std::span<double>(nodes.data(), nodes.size()));
    outflow.nodes += nodes;
}

template <int D>
void leave_gauge(const Coupling<D>& coupling, const std::vector<Twist<D>>& twists, UnknownVector<D>& p)
{
    std::vector<int> solid(coupling.system.bodies);
    for (std::size_t s = 0; s < coupling.solids.size(); ++s)
        if (coupling.free_body[s] >= 0)
            solid[coupling.free_body[s]] = static_cast<int>(s);
    for (const auto& entry : coupling.gauge_cells)
        p.cells(entry.row) -= entry.flux.dot(twists[solid[entry.body]]);
    for (const auto& entry : coupling.gauge_nodes)
        p.nodes[entry.row] -= entry.flux.dot(twists[solid[entry.body]]);
    take_from_owners(coupling.system, p.nodes);
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template void limit_deficits<D>(Coupling<D>&);                                                                             \
    template std::vector<TwistMatrix<D>> layer_inertias<D>(const Coupling<D>&);                                                \
    template LimitRate<D> limit_rate<D>(const Solid<D>&, double, const TwistMatrix<D>&, const TwistMatrix<D>&,                 \
                                        const Twist<D>&);                                                                      \
    template JacobiSteps<D> jacobi_steps<D>(const Coupling<D>&, int, const Twist<D>&);                                         \
    template void add_seen_mass<D>(Coupling<D>&);                                                                              \
    template void enter_gauge<D>(const Coupling<D>&, const std::vector<Twist<D>>&, UnknownVector<D>&);                         \
    template void leave_gauge<D>(const Coupling<D>&, const std::vector<Twist<D>>&, UnknownVector<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
