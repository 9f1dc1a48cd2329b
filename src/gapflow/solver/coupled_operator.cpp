// y = L p + K M^-1 K^T p with
//
//     (L p)_c = sum over faces a_f (p_c - p_n) + sum over links g_r w_rc s_r,     s_r = sum_i w_ri p_i
//     (L p)_i = sum over film edges a_ij (p_i - p_j) + sum over links g_r w_ri s_r
//
// (method, "The coupled system"). Cells are distributed, film nodes are replicated: the cells' parts of all s_r and of K^T p are summed
// over the ranks in one reduction, everything else about nodes is computed on every rank, with the same bits.

#include "gapflow/solver/coupled_operator.hpp"

#include "gapflow/solver/solver.hpp"

#include <cmath>

namespace gapflow {

template <int D>
CoupledOperator<D>::CoupledOperator(const CoupledSystem<D>& system)
    : system_(system), dofs_(twist_size<D> * system.bodies), conductance_(shared_conductances(system)),
      ground_(system.nodes, 0.0)
{
    const Grid<D>& grid = *system.grid;
    link_nodes_begin_.push_back(0);
    for (std::size_t r = 0; r < system.links.size(); ++r) {
        for (const auto& [key, weight] : system.links[r].cells) {
            const Index<D> c = grid.cell_of_key(key);
            if (grid.owns(c))
                link_cells_.push_back({static_cast<int>(r), system.component.block().offset(c), weight});
        }
        for (const auto& [node, weight] : system.links[r].nodes)
            link_nodes_.push_back({node, weight});
        link_nodes_begin_.push_back(static_cast<int>(link_nodes_.size()));
    }
    for (int column = 0; column < system.film.outerSize(); ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(system.film, column); entry; ++entry) {
            ground_[entry.row()] += entry.value();
            if (entry.row() < column)
                edges_.push_back({static_cast<int>(entry.row()), column, -entry.value()});
        }
    for (int i = 0; i < system.nodes; ++i)
        if (std::abs(ground_[i]) < 1e-12 * system.film.coeff(i, i))
            ground_[i] = 0; // round-off
    update_bodies();
    halo_ = halo_of<D, double>(grid, system.conductance[0].block());
    partial_.resize(static_cast<long>(system.links.size()) + dofs_ + 1);
}

template <int D>
void CoupledOperator<D>::update_bodies()
{
    if (dofs_ > 0)
        response_ = system_.response.ready() ? system_.response
                                             : BodyResponse(system_.mass, system_.contact, system_.contact_resistance);
}

template <int D>
double CoupledOperator<D>::product_plane(const CellField<D>& p, CellField<D>& y, int plane) const
{
    constexpr int chunk = SharedRows<double>::chunk;
    const Grid<D>& grid = *system_.grid;
    const int n = grid.high()[0] - grid.low()[0];
    const Index<D> stride = p.block().stride;
    const long rows = D == 3 ? grid.high()[1] - grid.low()[1] + 2 : 0; // of the conductances, in a plane
    Index<D> low = grid.low(), high = grid.high();
    low[D - 1] = plane;
    high[D - 1] = plane + 1;
    long row = (plane - grid.low()[D - 1] + 1) * (D == 3 ? rows : 1) + (D == 3 ? 1 : 0); // Level::row_number
    double total = 0;
    for_each_row<D>(low, high, [&](const Index<D>& first) {
        for (int c = 0, begin = 0; begin < n; ++c, begin += chunk) {
            const double* x = &p(first) + begin;
            double* __restrict to = &y(first) + begin;
            const double* a0 = conductance_[0](row, c);
            const double *a1 = conductance_[1](row, c), *b1 = conductance_[1](row + 1, c);
            const long s1 = stride[1];
            const int count = std::min(chunk, n - begin);
            double energy = 0;
            if constexpr (D == 2) {
#pragma omp simd reduction(+ : energy)
                for (int i = 0; i < count; ++i) {
                    to[i] = a0[i] * (x[i] - x[i - 1]) + a0[i + 1] * (x[i] - x[i + 1]) + a1[i] * (x[i] - x[i - s1]) +
                            b1[i] * (x[i] - x[i + s1]);
                    energy += x[i] * to[i];
                }
            } else {
                const double *a2 = conductance_[2](row, c), *b2 = conductance_[2](row + rows, c);
                const long s2 = stride[2];
#pragma omp simd reduction(+ : energy)
                for (int i = 0; i < count; ++i) {
                    to[i] = a0[i] * (x[i] - x[i - 1]) + a0[i + 1] * (x[i] - x[i + 1]) + a1[i] * (x[i] - x[i - s1]) +
                            b1[i] * (x[i] - x[i + s1]) + a2[i] * (x[i] - x[i - s2]) + b2[i] * (x[i] - x[i + s2]);
                    energy += x[i] * to[i];
                }
            }
            total += energy;
        }
        ++row;
    });
    return total;
}

template <int D>
void CoupledOperator<D>::begin_product(UnknownVector<D>& p) const
{
    const Grid<D>& grid = *system_.grid;
    for (int axis = 0; axis < D; ++axis)
        for (int end = 0; end < 2; ++end) {
            if (grid.neighbour(axis, end) >= 0)
                continue;
            Index<D> low = grid.low(), high = grid.high();
            low[axis] = end ? high[axis] : low[axis] - 1;
            high[axis] = low[axis] + 1;
            for_each_index<D>(low, high, [&](const Index<D>& c) { p.cells(c) = 0; });
        }
}

template <int D>
double CoupledOperator<D>::apply(UnknownVector<D>& p, UnknownVector<D>& y, bool with_bodies) const
{
    const Grid<D>& grid = *system_.grid;
    begin_product(p);
    exchange(p);
    const double grid_energy = sum_over_planes(grid.low()[D - 1], grid.high()[D - 1],
                                               [&](int plane) { return product_plane(p.cells, y.cells, plane); });
    return finish_product(p, y, grid_energy, with_bodies);
}

template <int D>
double CoupledOperator<D>::finish_product(const UnknownVector<D>& p, UnknownVector<D>& y, double grid_energy,
                                          bool with_bodies) const
{
    const Grid<D>& grid = *system_.grid;
    const long links = static_cast<long>(system_.links.size());
    partial_.setZero();
    const double* in_cells = p.cells.data();
    for (const LinkCell& entry : link_cells_)
        partial_[entry.link] += entry.weight * in_cells[entry.cell];
    if (with_bodies)
        for (const auto& entry : system_.cell_flux)
            partial_.template segment<twist_size<D>>(links + twist_size<D> * entry.body) += p.cells(entry.row) * entry.flux;
    partial_[links + dofs_] = grid_energy;
    grid.comm().sum(std::span<double>(partial_.data(), partial_.size()));

    double total = partial_[links + dofs_];
    y.nodes.setZero();
    for (const FilmEdge& edge : edges_) {
        const double difference = p.nodes[edge.i] - p.nodes[edge.j], flux = edge.conductance * difference;
        y.nodes[edge.i] += flux;
        y.nodes[edge.j] -= flux;
        total += flux * difference;
    }
    for (int i = 0; i < system_.nodes; ++i)
        if (ground_[i] != 0) {
            y.nodes[i] += ground_[i] * p.nodes[i];
            total += ground_[i] * p.nodes[i] * p.nodes[i];
        }
    for (long r = 0; r < links; ++r) {
        const double conductance = system_.links[r].conductance;
        const std::span<const LinkNode> nodes(link_nodes_.data() + link_nodes_begin_[r],
                                              link_nodes_.data() + link_nodes_begin_[r + 1]);
        double in_nodes = 0;
        for (const auto& [node, weight] : nodes)
            in_nodes += weight * p.nodes[node];
        const double sum = partial_[r] + in_nodes;
        total += conductance * sum * sum;
        partial_[r] = conductance * sum;
        for (const auto& [node, weight] : nodes)
            y.nodes[node] += weight * partial_[r];
    }
    double* out_cells = y.cells.data();
    for (const LinkCell& entry : link_cells_)
        out_cells[entry.cell] += entry.weight * partial_[entry.link];
    if (with_bodies && dofs_ > 0) {
        for (const auto& entry : system_.node_flux)
            partial_.template segment<twist_size<D>>(links + twist_size<D> * entry.body) += p.nodes[entry.row] * entry.flux;
        const Eigen::VectorXd wrench = partial_.segment(links, dofs_), twist = response_(wrench);
        total += wrench.dot(twist);
        add_flux(twist, y);
    }
    return total;
}

template <int D>
double CoupledOperator<D>::apply(UnknownVector<D>& p, UnknownVector<D>& y) const
{
    return apply(p, y, true);
}

template <int D>
double CoupledOperator<D>::apply_fluid(UnknownVector<D>& p, UnknownVector<D>& y) const
{
    return apply(p, y, false);
}

template <int D>
double CoupledOperator<D>::round_off(const UnknownVector<D>& p) const
{
    const Grid<D>& grid = *system_.grid;
    UnknownVector<D> terms = zero_vector(system_);
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
        for (int axis = 0; axis < D; ++axis)
            terms.cells(c) +=
                2 * std::abs(p.cells(c)) * (system_.conductance(axis, c) + system_.conductance(axis, c + step<D>(axis)));
    });
    for (const FilmEdge& edge : edges_) {
        const double term = std::abs(edge.conductance) * (std::abs(p.nodes[edge.i]) + std::abs(p.nodes[edge.j]));
        terms.nodes[edge.i] += term;
        terms.nodes[edge.j] += term;
    }
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(static_cast<long>(system_.links.size()) + dofs_);
    const long links = static_cast<long>(system_.links.size());
    for (const LinkCell& entry : link_cells_)
        sums[entry.link] += std::abs(entry.weight * p.cells.data()[entry.cell]);
    auto add_wrench = [&](int body, double value, const Twist<D>& flux) {
        sums.template segment<twist_size<D>>(links + twist_size<D> * body) += std::abs(value) * flux.cwiseAbs();
    };
    for (const auto& entry : system_.cell_flux)
        add_wrench(entry.body, p.cells(entry.row), entry.flux);
    grid.comm().sum(std::span<double>(sums.data(), sums.size()));
    for (const auto& entry : system_.node_flux)
        add_wrench(entry.body, p.nodes[entry.row], entry.flux);
    for (long r = 0; r < links; ++r) {
        const Link& link = system_.links[r];
        for (const auto& [node, weight] : link.nodes)
            sums[r] += std::abs(weight * p.nodes[node]);
        for (const auto& [node, weight] : link.nodes)
            terms.nodes[node] += link.conductance * std::abs(weight) * sums[r];
    }
    for (const LinkCell& entry : link_cells_)
        terms.cells.data()[entry.cell] += system_.links[entry.link].conductance * std::abs(entry.weight) * sums[entry.link];
    auto twist = [&](int body, const Twist<D>& flux) {
        double sum = 0;
        for (int d = 0; d < twist_size<D>; ++d)
            sum += std::abs(flux[d]) * sums[links + twist_size<D> * body + d] /
                   system_.mass.coeff(twist_size<D> * body + d, twist_size<D> * body + d);
        return sum;
    };
    for (const auto& entry : system_.cell_flux)
        terms.cells(entry.row) += twist(entry.body, entry.flux);
    for (const auto& entry : system_.node_flux)
        terms.nodes[entry.row] += twist(entry.body, entry.flux);
    return 3e-15 * std::sqrt(dot(grid, terms, terms));
}

template <int D>
Eigen::VectorXd CoupledOperator<D>::transpose_flux(const UnknownVector<D>& p) const
{
    Eigen::VectorXd wrench = Eigen::VectorXd::Zero(dofs_);
    for (const auto& entry : system_.cell_flux)
        wrench.template segment<twist_size<D>>(twist_size<D> * entry.body) += p.cells(entry.row) * entry.flux;
    system_.grid->comm().sum(std::span<double>(wrench.data(), wrench.size()));
    for (const auto& entry : system_.node_flux)
        wrench.template segment<twist_size<D>>(twist_size<D> * entry.body) += p.nodes[entry.row] * entry.flux;
    return wrench;
}

template <int D>
void CoupledOperator<D>::add_flux(const Eigen::VectorXd& u, UnknownVector<D>& y) const
{
    for (const auto& entry : system_.cell_flux)
        y.cells(entry.row) += entry.flux.dot(u.template segment<twist_size<D>>(twist_size<D> * entry.body));
    for (const auto& entry : system_.node_flux)
        y.nodes[entry.row] += entry.flux.dot(u.template segment<twist_size<D>>(twist_size<D> * entry.body));
}

template <int D>
Eigen::VectorXd CoupledOperator<D>::inverse_mass(const Eigen::VectorXd& w) const
{
    return response_(w);
}

template <int D>
long CoupledOperator<D>::bytes() const
{
    long sum = static_cast<long>(link_cells_.size() * sizeof(LinkCell) + link_nodes_.size() * sizeof(LinkNode) +
                                 edges_.size() * sizeof(FilmEdge));
    for (const SharedRows<double>& values : conductance_)
        sum += values.bytes();
    return sum;
}

template <int D>
void apply(const CoupledSystem<D>& system, UnknownVector<D>& p, UnknownVector<D>& y)
{
    CoupledOperator<D>(system).apply(p, y);
}

template <int D>
Eigen::VectorXd wrenches(const CoupledSystem<D>& system, const UnknownVector<D>& p)
{
    return CoupledOperator<D>(system).transpose_flux(p);
}

template class CoupledOperator<2>;
template class CoupledOperator<3>;
template void apply<2>(const CoupledSystem<2>&, UnknownVector<2>&, UnknownVector<2>&);
template void apply<3>(const CoupledSystem<3>&, UnknownVector<3>&, UnknownVector<3>&);
template Eigen::VectorXd wrenches<2>(const CoupledSystem<2>&, const UnknownVector<2>&);
template Eigen::VectorXd wrenches<3>(const CoupledSystem<3>&, const UnknownVector<3>&);

} // namespace gapflow
