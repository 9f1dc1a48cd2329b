#include "gapflow/coupling/pressure_gauge.hpp"

#include "gapflow/core/threads.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace gapflow {

namespace {

// A body's own mass over what D takes from it, below which the gauge changes. Above it M is positive; the choice moves no result.
constexpr double heavy = 2;

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

/// Inertia of the fluid that a solid displaces.
template <int D>
TwistMatrix<D> displaced_mass(const Solid<D>& solid, double density)
{
    const MassProperties<D> own = solid.shape.shape().mass_properties();
    const Vec<D> arm = solid.shape.to_world(own.centre) - solid.centre;
    TwistMatrix<D> mass = TwistMatrix<D>::Zero();
    auto spins = mass.template bottomRightCorner<spin_size<D>, spin_size<D>>();
    if constexpr (D == 2)
        spins = density * own.inertia;
    else
        spins = density * solid.shape.rotation() * own.inertia * solid.shape.rotation().transpose();
    for (int d = 0; d < D; ++d) {
        const Twist<D> row = wrench<D>(unit<D>(d), arm);
        mass += density * own.volume * row * row.transpose();
    }
    return mass;
}

/// A without its negative part, in the axes in which G is the identity.
template <int D>
TwistMatrix<D> positive_part(const TwistMatrix<D>& A, const TwistMatrix<D>& G)
{
    const Eigen::LLT<TwistMatrix<D>> root(G);
    const TwistMatrix<D> scaled = root.matrixL().solve(root.matrixL().solve(A).transpose());
    const Eigen::SelfAdjointEigenSolver<TwistMatrix<D>> modes(0.5 * (scaled + scaled.transpose()));
    TwistMatrix<D> positive = A;
    for (int k = 0; k < twist_size<D>; ++k)
        if (const double value = modes.eigenvalues()[k]; value < 0) {
            const Twist<D> mode = root.matrixL() * modes.eigenvectors().col(k);
            positive -= value * mode * mode.transpose();
        }
    return positive;
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
    const FluidRows<D> L(coupling);
    std::vector<std::vector<Entry<D>>> K(coupling.solids.size());
    for (const auto& entry : coupling.cell_flux)
        K[entry.body].push_back({L.row(entry.row), entry.body, entry.flux});
    for (const auto& entry : coupling.node_flux)
        K[entry.body].push_back({L.row(entry.row), entry.body, entry.flux});
    for_each_job(static_cast<int>(K.size()), [&](int s) {
        TwistMatrix<D>& seen = coupling.seen_mass[s];
        if (seen.isZero(0))
            return;
        const TwistMatrix<D> layer = layer_inertia(L, K[s]);
        seen = positive_part<D>(seen + layer, displaced_mass(coupling.solids[s], coupling.density)) - layer;
    });
}

template <int D>
void add_seen_mass(Coupling<D>& coupling)
{
    constexpr int n = twist_size<D>;
    CoupledSystem<D>& system = coupling.system;
    std::vector<char> light(system.bodies, 0);
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](int a, int b, const TwistMatrix<D>& mass) {
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j)
                if (mass(i, j) != 0)
                    entries.emplace_back(n * a + i, n * b + j, mass(i, j));
    };
    bool any = false;
    for (std::size_t s = 0; s < coupling.solids.size(); ++s)
        if (const int b = coupling.free_body[s]; b >= 0) {
            const TwistMatrix<D>& P = coupling.solids[s].admissible;
            const TwistMatrix<D> seen = P * coupling.seen_mass[s] * P, own = system.mass.block(n * b, n * b, n, n);
            add(b, b, seen);
            light[b] = Eigen::LLT<TwistMatrix<D>>(own + heavy * seen).info() != Eigen::Success;
            any = any || light[b];
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
