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
#include <numeric>

namespace gapflow {

template <int D>
CoupledOperator<D>::CoupledOperator(const CoupledSystem<D>& system)
    : system_(system), dofs_(twist_size<D> * system.bodies), conductance_(shared_conductances(system)),
      ground_(film_grounds(system.film))
{
    const Grid<D>& grid = *system.grid;
    const Block<D>& block = system.component.block();
    for (const Link& link : system.links) {
        for (const auto& [key, weight] : link.cells)
            if (const Index<D> c = grid.cell_of_key(key); grid.owns(c))
                link_cells_.add(block.offset(c), weight);
        link_cells_.end_list();
        for (const auto& [node, weight] : link.nodes)
            link_nodes_.add(node, weight);
        link_nodes_.end_list();
    }
    std::vector<int> place(system.links.empty() ? 0 : system.component.size(), -1); // of a cell among the linked ones
    for (const auto& entry : link_cells_.entries())
        place[entry.number] = 0;
    for (std::size_t cell = 0; cell < place.size(); ++cell)
        if (place[cell] == 0) {
            place[cell] = static_cast<int>(linked_cells_.size());
            linked_cells_.push_back(static_cast<long>(cell));
        }
    cell_links_ = link_cells_.transposed(static_cast<long>(linked_cells_.size()), [&](long cell) { return place[cell]; });
    node_links_ = link_nodes_.transposed(system.nodes, [](int node) { return node; });
    cell_flux_runs_ = RowRuns(static_cast<long>(system.cell_flux.size()), system.component.size(),
                              [&](long i) { return block.offset(system.cell_flux[i].row); });
    node_flux_runs_ =
        RowRuns(static_cast<long>(system.node_flux.size()), system.nodes, [&](long i) { return system.node_flux[i].row; });
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

namespace {

constexpr long rows_a_piece = 2048; // links or nodes of a thread's piece of work

// wrench += sum of value(row) flux. Long lists are summed in a few parts of a length that does not depend on the number of threads.
template <int D, class Entries, class Value>
void add_wrenches(const Entries& entries, Value&& value, Eigen::Ref<Eigen::VectorXd> wrench)
{
    constexpr long shortest = 8192, most = 16; // entries of a part, parts
    const long n = static_cast<long>(entries.size()), size = std::max(shortest, (n + most - 1) / most);
    const auto add = [&](long begin, long end, auto&& sum) {
        for (long i = begin; i < end; ++i)
            sum.template segment<twist_size<D>>(twist_size<D> * entries[i].body) += value(entries[i].row) * entries[i].flux;
    };
    if (n <= size)
        return add(0, n, wrench);
    for (const Eigen::VectorXd& part : each_chunk(n, size, [&](long begin, long end) {
             Eigen::VectorXd sum = Eigen::VectorXd::Zero(wrench.size());
             add(begin, end, sum);
             return sum;
         }))
        wrench += part;
}

double sum_of(const std::vector<double>& parts)
{
    return std::accumulate(parts.begin(), parts.end(), 0.0);
}

} // namespace

// Adds the nodes to the links' sums over cells and takes them times the conductance. Returns p . y of the links.
template <int D>
double CoupledOperator<D>::sum_links(const UnknownVector<D>& p) const
{
    return sum_of(each_chunk(static_cast<long>(system_.links.size()), rows_a_piece, [&](long begin, long end) {
        double total = 0;
        for (long r = begin; r < end; ++r) {
            double sum = 0;
            for (const auto& [node, weight] : link_nodes_[r])
                sum += weight * p.nodes[node];
            sum += partial_[r];
            partial_[r] = system_.links[r].conductance * sum;
            total += partial_[r] * sum;
        }
        return total;
    }));
}

// y of the nodes, from the film's elements and the links. Returns p . y of the elements.
template <int D>
double CoupledOperator<D>::multiply_nodes(const UnknownVector<D>& p, UnknownVector<D>& y) const
{
    return sum_of(each_chunk(system_.nodes, rows_a_piece, [&](long begin, long end) {
        double total = 0;
        for (long i = begin; i < end; ++i) {
            const double here = p.nodes[i];
            double sum = 0;
            for (Eigen::SparseMatrix<double>::InnerIterator entry(system_.film, i); entry; ++entry) {
                const double difference = p.nodes[entry.row()] - here, flux = entry.value() * difference; // of the diagonal 0
                sum += flux;
                total -= 0.5 * flux * difference; // twice an edge
            }
            sum += ground_[i] * here;
            total += ground_[i] * here * here;
            for (const auto& [link, weight] : node_links_[i])
                sum += weight * partial_[link];
            y.nodes[i] = sum;
        }
        return total;
    }));
}

template <int D>
double CoupledOperator<D>::finish_product(const UnknownVector<D>& p, UnknownVector<D>& y, double grid_energy,
                                          bool with_bodies) const
{
    const Grid<D>& grid = *system_.grid;
    const long links = static_cast<long>(system_.links.size());
    partial_.setZero();
    const double* in_cells = p.cells.data();
    for_each_part(links, [&](long begin, long end) {
        for (long r = begin; r < end; ++r)
            for (const auto& [cell, weight] : link_cells_[r])
                partial_[r] += weight * in_cells[cell];
    });
    auto wrench = partial_.segment(links, dofs_);
    if (with_bodies)
        add_wrenches<D>(
            system_.cell_flux, [&](const Index<D>& c) { return p.cells(c); }, wrench);
    partial_[links + dofs_] = grid_energy;
    grid.comm().sum(std::span<double>(partial_.data(), partial_.size()));

    double total = partial_[links + dofs_];
    total += sum_links(p);
    total += multiply_nodes(p, y);
    double* out_cells = y.cells.data();
    for_each_part(static_cast<long>(linked_cells_.size()), [&](long begin, long end) {
        for (long c = begin; c < end; ++c)
            for (const auto& [link, weight] : cell_links_[c])
                out_cells[linked_cells_[c]] += weight * partial_[link];
    });
    if (with_bodies && dofs_ > 0) {
        add_wrenches<D>(
            system_.node_flux, [&](int node) { return p.nodes[node]; }, wrench);
        const Eigen::VectorXd twist = response_(wrench);
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
    for_each_film_edge([&](int i, int j, double conductance) {
        const double term = std::abs(conductance) * (std::abs(p.nodes[i]) + std::abs(p.nodes[j]));
        terms.nodes[i] += term;
        terms.nodes[j] += term;
    });
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(static_cast<long>(system_.links.size()) + dofs_);
    const long links = static_cast<long>(system_.links.size());
    for (long r = 0; r < links; ++r)
        for (const auto& [cell, weight] : link_cells_[r])
            sums[r] += std::abs(weight * p.cells.data()[cell]);
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
    for (long r = 0; r < links; ++r)
        for (const auto& [cell, weight] : link_cells_[r])
            terms.cells.data()[cell] += system_.links[r].conductance * std::abs(weight) * sums[r];
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
    add_wrenches<D>(
        system_.cell_flux, [&](const Index<D>& c) { return p.cells(c); }, wrench);
    system_.grid->comm().sum(std::span<double>(wrench.data(), wrench.size()));
    add_wrenches<D>(
        system_.node_flux, [&](int node) { return p.nodes[node]; }, wrench);
    return wrench;
}

template <int D>
void CoupledOperator<D>::add_flux(const Eigen::VectorXd& u, UnknownVector<D>& y) const
{
    const auto dot = [&](const auto& entry) {
        return entry.flux.dot(u.template segment<twist_size<D>>(twist_size<D> * entry.body));
    };
    const auto cell = [&](long i) -> const Index<D>& { return system_.cell_flux[i].row; };
    const auto node = [&](long i) { return system_.node_flux[i].row; };
    cell_flux_runs_.for_each(cell, [&](long i) { y.cells(cell(i)) += dot(system_.cell_flux[i]); });
    node_flux_runs_.for_each(node, [&](long i) { y.nodes[node(i)] += dot(system_.node_flux[i]); });
}

template <int D>
Eigen::VectorXd CoupledOperator<D>::inverse_mass(const Eigen::VectorXd& w, Eigen::VectorXd* held) const
{
    return response_(w, held);
}

template <int D>
long CoupledOperator<D>::bytes() const
{
    long sum = link_cells_.bytes() + cell_links_.bytes() + link_nodes_.bytes() + node_links_.bytes();
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
    Eigen::VectorXd wrench = Eigen::VectorXd::Zero(twist_size<D> * system.bodies);
    add_wrenches<D>(
        system.cell_flux, [&](const Index<D>& c) { return p.cells(c); }, wrench);
    if (!system.own_node.empty() || system.grid->comm().root()) // each rank has its nodes' rows, or every rank has all
        add_wrenches<D>(
            system.node_flux, [&](int node) { return p.nodes[node]; }, wrench);
    system.grid->comm().sum(std::span<double>(wrench.data(), wrench.size()));
    return wrench;
}

template class CoupledOperator<2>;
template class CoupledOperator<3>;
template void apply<2>(const CoupledSystem<2>&, UnknownVector<2>&, UnknownVector<2>&);
template void apply<3>(const CoupledSystem<3>&, UnknownVector<3>&, UnknownVector<3>&);
template Eigen::VectorXd wrenches<2>(const CoupledSystem<2>&, const UnknownVector<2>&);
template Eigen::VectorXd wrenches<3>(const CoupledSystem<3>&, const UnknownVector<3>&);

} // namespace gapflow
