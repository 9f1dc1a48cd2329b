#include "gapflow/solver/assemble.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/coupling/body_response.hpp"

#include <algorithm>

namespace gapflow {

namespace {

/// Calls f(row, column, value) for the entries of L in this rank's rows (rank 0: film nodes), values to be summed. Links
/// enter on the rank that owns the row: `number_of(key)` gives the columns of other ranks' cells.
template <int D, class NumberOf, class F>
void for_each_fluid_entry(const CoupledSystem<D>& system, const Numbering<D>& numbering, NumberOf&& number_of, F&& f)
{
    const Grid<D>& grid = *system.grid;
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
        const int row = numbering.cell(c);
        if (row < 0)
            return;
        f(row, row, 0.0);
        for (int side = 0; side < 2 * D; ++side) {
            const int axis = side / 2;
            const Index<D> up = c + step<D>(axis), down = c - step<D>(axis);
            const double a = system.conductance(axis, side % 2 ? up : c);
            if (a == 0)
                continue;
            f(row, row, a);
            const Index<D>& other = side % 2 ? up : down;
            if (const int column = numbering.cell(other); column >= 0)
                f(row, column, -a);
        }
    });
    if (grid.comm().root())
        for (int column = 0; column < system.film.outerSize(); ++column)
            for (Eigen::SparseMatrix<double>::InnerIterator entry(system.film, column); entry; ++entry)
                f(static_cast<int>(entry.row()), column, entry.value());
    if (grid.comm().root())
        for (int i = 0; i < system.nodes; ++i)
            f(i, i, 0.0);
    for (const Link& link : system.links) {
        std::vector<std::pair<int, double>> terms(link.nodes.begin(), link.nodes.end());
        for (const auto& [key, weight] : link.cells)
            if (const int number = number_of(key); number >= 0)
                terms.emplace_back(number, weight);
        for (const auto& [i, wi] : terms)
            if (i >= numbering.first && i < numbering.first + numbering.owned)
                for (const auto& [j, wj] : terms)
                    f(i, j, link.conductance * wi * wj);
    }
}

/// Numbers of the cells of all links, known on every rank.
template <int D>
std::vector<std::pair<long, int>> link_cell_numbers(const CoupledSystem<D>& system, const Numbering<D>& numbering)
{
    std::vector<std::pair<long, int>> numbers;
    for (const Link& link : system.links)
        for (const auto& entry : link.cells)
            numbers.emplace_back(entry.first, -1);
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    std::vector<double> told(numbers.size(), -1.0);
    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (const Index<D> c = system.grid->cell_of_key(numbers[i].first); system.grid->owns(c))
            told[i] = numbering.cell(c);
    system.grid->comm().max(told);
    for (std::size_t i = 0; i < numbers.size(); ++i)
        numbers[i].second = static_cast<int>(told[i]);
    return numbers;
}

auto finder(const std::vector<std::pair<long, int>>& numbers)
{
    return [&numbers](long key) {
        const auto found = std::lower_bound(numbers.begin(), numbers.end(), std::pair<long, int>(key, -1));
        return found != numbers.end() && found->first == key ? found->second : -1;
    };
}

} // namespace

template <int D>
Numbering<D> number_unknowns(const CoupledSystem<D>& system)
{
    const Grid<D>& grid = *system.grid;
    Numbering<D> numbering;
    numbering.cell = CellField<D, int>(grid, -1);
    long cells = 0;
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) { cells += system.component(c) >= 0; });
    long before = 0;
    MPI_Exscan(&cells, &before, 1, MPI_LONG, MPI_SUM, grid.comm().mpi());
    if (grid.comm().root())
        before = 0;
    numbering.first_cell = system.nodes + static_cast<int>(before);
    numbering.first = grid.comm().root() ? 0 : numbering.first_cell;
    numbering.owned = static_cast<int>(cells) + (grid.comm().root() ? system.nodes : 0);
    numbering.total = static_cast<int>(grid.comm().sum(static_cast<long>(numbering.owned)));
    int next = numbering.first_cell;
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
        if (system.component(c) >= 0)
            numbering.cell(c) = next++;
    });
    exchange(grid, numbering.cell, 1);
    return numbering;
}

template <int D>
Eigen::MatrixXd assemble_dense(const CoupledSystem<D>& system)
{
    if (system.grid->comm().size() > 1)
        throw ComputationError("assemble_dense works on one rank only");
    const Numbering<D> numbering = number_unknowns(system);
    const auto numbers = link_cell_numbers(system, numbering);
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(numbering.total, numbering.total);
    for_each_fluid_entry(system, numbering, finder(numbers), [&](int i, int j, double value) { matrix(i, j) += value; });
    const int dofs = twist_size<D> * system.bodies;
    if (dofs > 0) {
        Eigen::MatrixXd flux = Eigen::MatrixXd::Zero(numbering.total, dofs);
        for (const auto& entry : system.cell_flux)
            flux.row(numbering.cell(entry.row)).segment(twist_size<D> * entry.body, twist_size<D>) += entry.flux.transpose();
        for (const auto& entry : system.node_flux)
            flux.row(entry.row).segment(twist_size<D> * entry.body, twist_size<D>) += entry.flux.transpose();
        const BodyResponse response(system.mass, system.contact, system.contact_resistance);
        for (long j = 0; j < matrix.cols(); ++j)
            matrix.col(j) += flux * response(flux.row(j).transpose());
    }
    return matrix;
}

template <int D>
PetscMatrix assemble_fluid(const CoupledSystem<D>& system, const Numbering<D>& numbering)
{
    const auto numbers = link_cell_numbers(system, numbering);
    // Count first: MatSetValues into an unprepared matrix is quadratic.
    std::vector<PetscInt> inside(numbering.owned, 0), outside(numbering.owned, 0);
    const int end = numbering.first + numbering.owned;
    auto for_each = [&](auto&& f) { for_each_fluid_entry(system, numbering, finder(numbers), f); };
    for_each([&](int i, int j, double) { ++(j >= numbering.first && j < end ? inside : outside)[i - numbering.first]; });
    for (int i = 0; i < numbering.owned; ++i) { // entries that are summed were counted more than once
        inside[i] = std::min<PetscInt>(inside[i], numbering.owned);
        outside[i] = std::min<PetscInt>(outside[i], numbering.total - numbering.owned);
    }
    PetscMatrix matrix;
    check_petsc(MatCreateAIJ(system.grid->comm().mpi(), numbering.owned, numbering.owned, numbering.total, numbering.total, 0,
                             inside.data(), 0, outside.data(), matrix.out()),
                "MatCreateAIJ");
    for_each([&](int i, int j, double value) {
        const PetscInt row = i, column = j;
        MatSetValues(matrix.get(), 1, &row, 1, &column, &value, ADD_VALUES);
    });
    check_petsc(MatAssemblyBegin(matrix.get(), MAT_FINAL_ASSEMBLY), "MatAssemblyBegin");
    check_petsc(MatAssemblyEnd(matrix.get(), MAT_FINAL_ASSEMBLY), "MatAssemblyEnd");
    return matrix;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template Numbering<D> number_unknowns<D>(const CoupledSystem<D>&);                                                         \
    template Eigen::MatrixXd assemble_dense<D>(const CoupledSystem<D>&);                                                       \
    template PetscMatrix assemble_fluid<D>(const CoupledSystem<D>&, const Numbering<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
