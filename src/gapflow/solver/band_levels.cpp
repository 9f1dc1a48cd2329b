#include "gapflow/solver/band_levels.hpp"

#include "gapflow/core/sharing.hpp"
#include "gapflow/core/threads.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {

namespace {

constexpr double negligible_part = 1e-8; // of a level, in its extension: films pass on their neighbours' levels, less and less

} // namespace

template <int D>
BandLevels<D>::BandLevels(const CoupledOperator<D>& matrix, const FilmBand<D>& band, const CellField<D, int>& part,
                          const std::vector<int>& node_part, int count)
    : matrix_(matrix), band_(band), count_(count), has_nodes_(count, 0)
{
    const CoupledSystem<D>& system = matrix.system();
    const Grid<D>& grid = *system.grid;
    const auto counted = [&](int column) { return column < count ? column : -1; };
    std::vector<double> told(band.size(), 0.0); // of this rank's band cells: the column, from 1 on
    for (const auto& entry : band.owned())
        told[entry.row] = counted(part(entry.cell)) + 1;
    grid.comm().sum(told);
    for (int row = 0; row < band.size(); ++row)
        column_.push_back(static_cast<int>(std::lround(told[row])) - 1);
    for (int i = 0; i < system.nodes; ++i)
        if (const int k = counted(node_part[i]); k >= 0) {
            column_[i] = k;
            has_nodes_[k] = 1;
        }
    band.for_each_face_beside([&](int row, const Index<D>& cell, double conductance) {
        faces_.push_back({row, conductance, counted(part(cell))});
    });
    faces_ = all_values(grid.comm(), faces_);
    for (std::size_t r = 0; r < system.links.size(); ++r)
        for (const auto& [key, weight] : system.links[r].cells)
            if (const Index<D> c = grid.cell_of_key(key); grid.owns(c) && band.row_of(key) < 0)
                linked_.push_back({static_cast<int>(r), weight, counted(part(c))});
    linked_ = all_values(grid.comm(), linked_);
    std::stable_sort(linked_.begin(), linked_.end(), [](const auto& a, const auto& b) { return a.link < b.link; });
}

template <int D>
typename BandLevels<D>::Row BandLevels<D>::unit(int block, int column) const
{
    Row row = Row::Zero();
    if (const int k = column - width * block; column >= 0 && k >= 0 && k < width)
        row[k] = 1;
    return row;
}

template <int D>
typename BandLevels<D>::Rows BandLevels<D>::constants(int block) const
{
    Rows z(band_.size(), width);
    for (int row = 0; row < band_.size(); ++row)
        z.row(row) = unit(block, column_[row]);
    return z;
}

// Differences keep the product with a constant exactly 0 (CoupledOperator).
template <int D>
template <class Beside>
typename BandLevels<D>::Rows BandLevels<D>::product(int block, const Rows& z, Beside&& beside) const
{
    Rows y = Rows::Zero(band_.size(), width);
    band_.for_each_edge([&](int i, int j, double conductance) {
        const Row flux = conductance * (z.row(i) - z.row(j));
        y.row(i) += flux;
        y.row(j) -= flux;
    });
    band_.for_each_ground([&](int i, double conductance) { y.row(i) += conductance * z.row(i); });
    for (const Face& face : faces_) {
        const Row flux = face.conductance * (z.row(face.row) - unit(block, face.column));
        y.row(face.row) += flux;
        beside(face.column, Row(-flux));
    }
    const std::vector<Link>& links = matrix_.system().links;
    auto outside = linked_.begin();
    for (std::size_t r = 0; r < links.size(); ++r) {
        const auto first = outside;
        Row sum = Row::Zero();
        for (const auto& [row, weight] : band_.link_rows(static_cast<long>(r)))
            sum += weight * z.row(row);
        for (; outside != linked_.end() && outside->link == static_cast<int>(r); ++outside)
            sum += outside->weight * unit(block, outside->column);
        const Row flux = links[r].conductance * sum;
        for (const auto& [row, weight] : band_.link_rows(static_cast<long>(r)))
            y.row(row) += weight * flux;
        for (auto cell = first; cell != outside; ++cell)
            beside(cell->column, Row(cell->weight * flux));
    }
    return y;
}

template <int D>
Eigen::SparseMatrix<double> BandLevels<D>::extension() const
{
    using Entry = Eigen::Triplet<double>;
    std::vector<std::vector<Entry>> found(blocks());
    for_each_job(blocks(), [&](int block) {
        const Rows z = constants(block);
        Rows more = Rows::Zero(band_.size(), width);
        for (int pass = 0; pass < 2; ++pass) // refined once: the factor carries a small shift
            more -= band_.solve_columns(product(block, z + more, [](int, const Row&) {}));
        for (int row = 0; row < band_.size(); ++row)
            for (int k = 0; k < std::min(width, count_ - width * block); ++k)
                if (const int column = width * block + k; !has_nodes_[column] && std::abs(more(row, k)) > negligible_part)
                    found[block].emplace_back(column, row, more(row, k));
    });
    std::vector<Entry> entries;
    for (const std::vector<Entry>& of_block : found)
        entries.insert(entries.end(), of_block.begin(), of_block.end());
    Eigen::SparseMatrix<double> extension(count_, band_.size());
    extension.setFromTriplets(entries.begin(), entries.end());
    return extension;
}

template <int D>
Eigen::MatrixXd BandLevels<D>::energy(const Eigen::SparseMatrix<double>& extension) const
{
    Eigen::MatrixXd energy = Eigen::MatrixXd::Zero(count_, width * blocks());
    for_each_job(blocks(), [&](int block) {
        auto columns = energy.middleCols(width * block, width);
        Rows z = constants(block);
        for (int row = 0; row < band_.size(); ++row)
            for (Eigen::SparseMatrix<double>::InnerIterator entry(extension, row); entry; ++entry)
                z.row(row) += entry.value() * unit(block, static_cast<int>(entry.row()));
        const Rows y = product(block, z, [&](int column, const Row& flux) {
            if (column >= 0)
                columns.row(column) += flux;
        });
        for (int row = 0; row < band_.size(); ++row) {
            if (column_[row] >= 0)
                columns.row(column_[row]) += y.row(row);
            for (Eigen::SparseMatrix<double>::InnerIterator entry(extension, row); entry; ++entry)
                columns.row(entry.row()) += entry.value() * y.row(row);
        }
    });
    const Eigen::MatrixXd square = energy.leftCols(count_);
    return 0.5 * (square + square.transpose());
}

template class BandLevels<2>;
template class BandLevels<3>;

} // namespace gapflow
