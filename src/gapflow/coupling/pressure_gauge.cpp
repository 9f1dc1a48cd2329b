#include "gapflow/coupling/pressure_gauge.hpp"

#include "gapflow/core/threads.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace gapflow {

namespace {

// A body's own mass over what D takes from it, below which the gauge changes. Above it M is positive; the choice moves no result.
constexpr double heavy = 2;
constexpr double mass_round_off = 1e-13;

/// Of K and of Y. Rows: cells by their keys, nodes after them.
template <int D>
struct Entry {
    long row;
    int body;
    Twist<D> flux;
};

/// L, row by row.
template <int D>
class FluidRows {
public:
    explicit FluidRows(const Coupling<D>& coupling)
        : grid_(*coupling.grid), system_(coupling.system), cells_(grid_.cells().template cast<long>().prod())
    {
        for (std::size_t k = 0; k < system_.links.size(); ++k)
            for (const auto& [row, weight] : members(system_.links[k]))
                links_.emplace_back(row, k);
        std::sort(links_.begin(), links_.end());
        links_.erase(std::unique(links_.begin(), links_.end()), links_.end());
    }

    long row(const Index<D>& c) const { return grid_.key(c); }
    long row(int node) const { return cells_ + node; }
    bool is_cell(long row) const { return row < cells_; }
    Index<D> cell(long row) const { return grid_.cell_of_key(row); }
    int node(long row) const { return static_cast<int>(row - cells_); }

    /// Calls f(other, coefficient) for the entries of a row, several for one other row perhaps.
    template <class F>
    void for_each(long row, F&& f) const
    {
        if (is_cell(row))
            for_each_face(row, f);
        else
            for (Eigen::SparseMatrix<double>::InnerIterator entry(system_.film, node(row)); entry; ++entry)
                f(this->row(static_cast<int>(entry.row())), entry.value());
        for (auto k = std::lower_bound(links_.begin(), links_.end(), std::pair(row, std::size_t{0}));
             k != links_.end() && k->first == row; ++k) {
            const Link& link = system_.links[k->second];
            const auto all = members(link);
            double own = 0;
            for (const auto& [other, weight] : all)
                own += other == row ? weight : 0.0;
            for (const auto& [other, weight] : all)
                f(other, link.conductance * own * weight);
        }
    }

    double diagonal(long row) const
    {
        double sum = 0;
        for_each(row, [&](long other, double value) { sum += other == row ? value : 0.0; });
        return sum;
    }

private:
    template <class F>
    void for_each_face(long row, F&& f) const
    {
        const Index<D> c = cell(row);
        for (int axis = 0; axis < D; ++axis)
            for (int end = 0; end < 2; ++end) {
                const double g = system_.conductance(axis, end ? Index<D>(c + step<D>(axis)) : c);
                if (!(g > 0))
                    continue;
                f(row, g);
                const Index<D> beside = grid_.wrapped(end ? Index<D>(c + step<D>(axis)) : Index<D>(c - step<D>(axis)));
                if (grid_.in_domain(beside))
                    f(this->row(beside), -g);
            }
    }

    std::vector<std::pair<long, double>> members(const Link& link) const
    {
        std::vector<std::pair<long, double>> rows;
        for (const auto& [node, weight] : link.nodes)
            rows.emplace_back(row(node), weight);
        for (const auto& [key, weight] : link.cells)
            rows.emplace_back(row(grid_.cell_of_key(key)), weight);
        return rows;
    }

    const Grid<D>& grid_;
    const CoupledSystem<D>& system_;
    long cells_;
    std::vector<std::pair<long, std::size_t>> links_; ///< row, number of a link in it; by rows
};

/// One entry a row and body, in their order.
template <int D>
void merge(std::vector<Entry<D>>& entries)
{
    std::sort(entries.begin(), entries.end(),
              [](const Entry<D>& a, const Entry<D>& b) { return std::tie(a.row, a.body) < std::tie(b.row, b.body); });
    std::size_t count = 0;
    for (const Entry<D>& entry : entries)
        if (count > 0 && entries[count - 1].row == entry.row && entries[count - 1].body == entry.body)
            entries[count - 1].flux += entry.flux;
        else
            entries[count++] = entry;
    entries.resize(count);
}

/// A^T B of entries by row.
template <int D>
void add_product(const std::vector<Entry<D>>& A, const std::vector<Entry<D>>& B, std::vector<Eigen::Triplet<double>>& sum)
{
    constexpr int n = twist_size<D>;
    auto b = B.begin();
    for (const Entry<D>& a : A) {
        while (b != B.end() && b->row < a.row)
            ++b;
        for (auto other = b; other != B.end() && other->row == a.row; ++other)
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j)
                    if (const double value = a.flux[i] * other->flux[j]; value != 0)
                        sum.emplace_back(n * a.body + i, n * other->body + j, value);
    }
}

/// Y^T (2 diag(L) - L) Y of one solid, from its entries by row.
template <int D>
TwistMatrix<D> layer_inertia(const FluidRows<D>& L, std::vector<Entry<D>>& K)
{
    merge(K);
    std::vector<Entry<D>> Y;
    TwistMatrix<D> sum = TwistMatrix<D>::Zero();
    for (const Entry<D>& k : K)
        if (const double diagonal = L.diagonal(k.row); diagonal > 0) {
            Y.push_back({k.row, k.body, k.flux / diagonal});
            sum += 2 / diagonal * k.flux * k.flux.transpose();
        }
    for (const Entry<D>& y : Y)
        L.for_each(y.row, [&](long row, double value) {
            const auto other = std::lower_bound(Y.begin(), Y.end(), row, [](const Entry<D>& e, long r) { return e.row < r; });
            if (other != Y.end() && other->row == row)
                sum -= value * y.flux * other->flux.transpose();
        });
    return 0.5 * (sum + sum.transpose());
}

/// Least energy w^T A w of twists with w_d = 1. Spins of round solids, which move nothing but for round-off, do not count: lengths in `unit`.
template <int D>
double least_inertia(const TwistMatrix<D>& A, int d, double unit)
{
    if (!(A(d, d) > 0))
        return 0;
    std::vector<int> rows{d};
    for (int i = 0; i < twist_size<D>; ++i)
        if (i != d && A(i, i) > (i < D ? 0.0 : mass_round_off * unit * unit * A(d, d)))
            rows.push_back(i);
    const long n = static_cast<long>(rows.size());
    Eigen::MatrixXd scaled(n, n);
    for (long i = 0; i < n; ++i)
        for (long j = 0; j < n; ++j)
            scaled(i, j) = A(rows[i], rows[j]) / std::sqrt(A(rows[i], rows[i]) * A(rows[j], rows[j]));
    scaled.diagonal().array() += mass_round_off;
    return std::max(0.0, A(d, d) / scaled.inverse()(0, 0) - mass_round_off * A(d, d));
}

template <int D>
void change_gauge(Coupling<D>& coupling, const std::vector<char>& light)
{
    CoupledSystem<D>& system = coupling.system;
    const FluidRows<D> L(coupling);
    std::vector<Entry<D>> K, Y;
    for (const auto& entry : system.cell_flux)
        K.push_back({L.row(entry.row), entry.body, entry.flux});
    for (const auto& entry : system.node_flux)
        K.push_back({L.row(entry.row), entry.body, entry.flux});
    merge(K);
    for (const Entry<D>& entry : K)
        if (const double diagonal = light[entry.body] ? L.diagonal(entry.row) : 0.0; diagonal > 0)
            Y.push_back({entry.row, entry.body, entry.flux / diagonal});
    std::vector<Entry<D>> changed = K;
    for (const Entry<D>& y : Y)
        L.for_each(y.row, [&](long row, double value) { changed.push_back({row, y.body, -value * y.flux}); });
    merge(changed);

    std::vector<Eigen::Triplet<double>> added; // Y^T K + K'^T Y
    add_product(Y, K, added);
    add_product(changed, Y, added);
    Eigen::SparseMatrix<double> mass(system.mass.rows(), system.mass.cols());
    mass.setFromTriplets(added.begin(), added.end());
    system.mass += 0.5 * (mass + Eigen::SparseMatrix<double>(mass.transpose()));

    system.cell_flux.clear();
    system.node_flux.clear();
    for (const Entry<D>& entry : changed)
        if (L.is_cell(entry.row))
            system.cell_flux.push_back({L.cell(entry.row), entry.body, entry.flux});
        else
            system.node_flux.push_back({L.node(entry.row), entry.body, entry.flux});
    for (const Entry<D>& entry : Y)
        if (L.is_cell(entry.row))
            coupling.gauge_cells.push_back({L.cell(entry.row), entry.body, entry.flux});
        else
            coupling.gauge_nodes.push_back({L.node(entry.row), entry.body, entry.flux});
}

} // namespace

template <int D>
void limit_deficits(Coupling<D>& coupling)
{
    const bool any = std::any_of(coupling.normal_inertia.begin(), coupling.normal_inertia.end(),
                                 [](const NormalInertia<D>& inertia) { return inertia.mass < 0; });
    if (!any)
        return;
    const FluidRows<D> L(coupling);
    std::vector<std::vector<Entry<D>>> K(coupling.solids.size());
    for (const auto& entry : coupling.cell_flux)
        K[entry.body].push_back({L.row(entry.row), entry.body, entry.flux});
    for (const auto& entry : coupling.node_flux)
        K[entry.body].push_back({L.row(entry.row), entry.body, entry.flux});
    std::vector<std::vector<NormalInertia<D>*>> seen(coupling.solids.size());
    for (NormalInertia<D>& inertia : coupling.normal_inertia)
        seen[inertia.master].push_back(&inertia);
    for_each_job(static_cast<int>(seen.size()), [&](int s) {
        if (std::none_of(seen[s].begin(), seen[s].end(), [](const NormalInertia<D>* i) { return i->mass < 0; }))
            return;
        TwistMatrix<D> layer = layer_inertia(L, K[s]);
        for (const bool negative : {false, true})
            for (NormalInertia<D>* inertia : seen[s])
                if ((inertia->mass < 0) == negative) {
                    int d = 0;
                    inertia->row_master.cwiseAbs().maxCoeff(&d);
                    if (negative)
                        inertia->mass = std::max(inertia->mass, -least_inertia<D>(layer, d, coupling.grid->dx()));
                    layer(d, d) += inertia->mass;
                }
    });
}

template <int D>
void add_seen_mass(Coupling<D>& coupling)
{
    constexpr int n = twist_size<D>;
    CoupledSystem<D>& system = coupling.system;
    std::vector<char> light(system.bodies, 0);
    std::vector<Eigen::Triplet<double>> entries;
    bool any = false;
    for (const NormalInertia<D>& inertia : coupling.normal_inertia) {
        const int b = coupling.free_body[inertia.master];
        if (b < 0)
            continue;
        const Twist<D> row = coupling.solids[inertia.master].admissible * inertia.row_master;
        const double own = row.dot(system.mass.block(n * b, n * b, n, n) * row);
        light[b] = light[b] || own + heavy * inertia.mass * row.dot(row) * row.dot(row) < 0;
        any = any || light[b];
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j)
                if (row[i] * row[j] != 0)
                    entries.emplace_back(n * b + i, n * b + j, inertia.mass * row[i] * row[j]);
    }
    Eigen::SparseMatrix<double> seen(system.mass.rows(), system.mass.cols());
    seen.setFromTriplets(entries.begin(), entries.end());
    system.mass += seen;
    if (any)
        change_gauge(coupling, light);
    system.response = BodyResponse(system.mass, {}, {});
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
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template void limit_deficits<D>(Coupling<D>&);                                                                             \
    template void add_seen_mass<D>(Coupling<D>&);                                                                              \
    template void leave_gauge<D>(const Coupling<D>&, const std::vector<Twist<D>>&, UnknownVector<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
