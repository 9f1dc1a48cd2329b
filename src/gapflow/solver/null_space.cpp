// P = I - Z (Z^T Z)^-1 Z^T with Z = (1_1 ... 1_n) C, C = null_space: with the components' sizes S = diag(|1_k|^2),
// Z^T Z = C^T S C, a small matrix.

#include "gapflow/solver/null_space.hpp"
#include "gapflow/core/error.hpp"

namespace gapflow {

template <int D>
NullSpace<D>::NullSpace(const CoupledSystem<D>& system) : system_(system)
{
    if (empty())
        return;
    vectors_ = system.null_space.sparseView(1.0, 1e-14);
    // The sizes are counted here: film nodes and cells alike.
    const Grid<D>& grid = *system.grid;
    Eigen::VectorXd sizes = Eigen::VectorXd::Zero(system.components.size());
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
        if (const int k = system.component(c); k >= 0)
            sizes[k] += 1;
    });
    grid.comm().sum(std::span<double>(sizes.data(), sizes.size()));
    for (int k : system.node_component)
        sizes[k] += 1;
    size_ = sizes.sum();
    const Eigen::SparseMatrix<double> gram = vectors_.transpose() * sizes.asDiagonal() * vectors_;
    if (!gram_.compute(gram))
        throw ComputationError("the null vectors of the coupled system are linearly dependent");
}

template <int D>
const Eigen::VectorXd& NullSpace<D>::shifts(const UnknownVector<D>& v) const
{
    const Grid<D>& grid = *system_.grid;
    const int components = static_cast<int>(system_.components.size());
    sums_.setZero(components + 1); // entry 0: cells without unknown
    if (components == 1)
        sums_[1] = sum_over_pieces<1>(grid, [&](const Index<D>& first, int n) {
            return std::array<double, 1>{Eigen::Map<const Eigen::VectorXd>(&v.cells(first), n).sum()};
        })[0];
    else
        for_each_field_row(
            grid,
            [&](int n, const double* row, const int* component) {
                for (int i = 0; i < n; ++i)
                    sums_[component[i] + 1] += row[i];
            },
            v.cells, system_.component);
    grid.comm().sum(std::span<double>(sums_.data() + 1, components));
    for (int i = 0; i < system_.nodes; ++i)
        sums_[system_.node_component[i] + 1] += v.nodes[i];
    const Eigen::VectorXd coefficients = gram_.solve(vectors_.transpose() * sums_.tail(components));
    sums_.tail(components) = vectors_ * coefficients;
    sums_[0] = 0;
    return sums_;
}

template <int D>
const Eigen::VectorXd& NullSpace<D>::shifts(double sum) const
{
    sums_.setZero(2);
    sums_[1] = sum / size_;
    return sums_;
}

template <int D>
void NullSpace<D>::project(UnknownVector<D>& v) const
{
    if (empty())
        return;
    const Eigen::VectorXd& shift = shifts(v);
    for_each_piece(*system_.grid, [&](const Index<D>& first, int n) {
        double* row = &v.cells(first);
        const int* component = &system_.component(first);
        for (int i = 0; i < n; ++i)
            row[i] -= shift[component[i] + 1];
    });
    for (int i = 0; i < system_.nodes; ++i)
        v.nodes[i] -= shift[system_.node_component[i] + 1];
}

template class NullSpace<2>;
template class NullSpace<3>;

} // namespace gapflow
