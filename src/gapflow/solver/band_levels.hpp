// Levels on parts of the grid and on films, extended harmonically over the films' band (Deflation): many at once, from the band's own rows and what lies
// beside them.
#pragma once

#include "gapflow/solver/film_band.hpp"

#include <Eigen/Sparse>

#include <vector>

namespace gapflow {

/// With z_k = 1 on all cells of part k and on the nodes of film k, 0 elsewhere. Built by all ranks together; its methods are this rank's alone, with the same
/// results on all.
template <int D>
class BandLevels {
public:
    /// `part`: column of each of this rank's cells, `node_part`: of each node, -1: none; the first `count` columns count. Collective.
    BandLevels(const CoupledOperator<D>& matrix, const FilmBand<D>& band, const CellField<D, int>& part,
               const std::vector<int>& node_part, int count);

    /// What is to be added to z_k on the band such that L z_k is 0 there: count x band unknowns, without what is negligible. Nothing where a column has nodes.
    Eigen::SparseMatrix<double> extension() const;
    /// Z^T L Z with the extension added.
    Eigen::MatrixXd energy(const Eigen::SparseMatrix<double>& extension) const;

private:
    static constexpr int width = 8; ///< columns at a time
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, width, Eigen::RowMajor>;
    using Row = Eigen::Matrix<double, 1, width>;
    struct Face { ///< from a band cell to a cell outside
        int row;
        double conductance;
        int column; ///< of that cell, -1: none
    };
    struct LinkCell { ///< outside the band
        int link;
        double weight;
        int column;
    };

    int blocks() const { return (count_ + width - 1) / width; }
    Row unit(int block, int column) const;
    /// z of a block's columns on the band.
    Rows constants(int block) const;
    /// L z on the band's rows. `beside(column, y)`: called with what cells outside the band of this column get from the band.
    template <class Beside>
    Rows product(int block, const Rows& z, Beside&& beside) const;

    const CoupledOperator<D>& matrix_;
    const FilmBand<D>& band_;
    int count_;
    std::vector<int> column_;      ///< of every band row, -1: none
    std::vector<char> has_nodes_;  ///< of every column
    std::vector<Face> faces_;      ///< of all ranks
    std::vector<LinkCell> linked_; ///< of all ranks, by links
};

} // namespace gapflow
