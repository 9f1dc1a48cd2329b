// The films' half of the Schwarz pair: a direct solve of all film nodes together with a band of cells around their mouths.
#pragma once

#include "gapflow/core/sparse_cholesky.hpp"
#include "gapflow/film/key_map.hpp"
#include "gapflow/solver/coupled_operator.hpp"
#include "gapflow/solver/level.hpp"
#include "gapflow/solver/weighted_lists.hpp"

#include <vector>

namespace gapflow {

/// The principal submatrix of L on film nodes [0, nodes) and the band's cells [nodes, size). Replicated on every rank.
template <int D>
class FilmBand {
public:
    /// Finds the band; factorise() is to follow. Collective.
    explicit FilmBand(const CoupledOperator<D>& matrix);
    /// This rank's alone.
    void factorise();

    bool empty() const { return size_ == 0; }
    int size() const { return size_; }
    /// Whether the level of the row's block is undetermined, without a connection to the outside of the band.
    bool floating(int row) const { return block_[row] >= 0; }

    /// A band cell that this rank owns.
    struct OwnedCell {
        int row; ///< in the band
        Index<D> cell;
        long level_offset; ///< in the finest level's block
    };
    const std::vector<OwnedCell>& owned() const { return owned_; }

    /// Values on the band of a vector. Collective.
    Eigen::VectorXd gather(const UnknownVector<D>& v) const;
    /// The submatrix' inverse; on floating blocks, without connections to the outside, the pseudo-inverse.
    Eigen::VectorXd solve(const Eigen::VectorXd& r) const;

    /// The same of every column, on this thread alone.
    Eigen::MatrixXd solve_columns(const Eigen::MatrixXd& r) const;

    /// The submatrix as differences. Calls f(i, j, conductance) for the film's edges and the faces between two of the band's cells.
    template <class F>
    void for_each_edge(F&& f) const
    {
        matrix_.for_each_film_edge(f);
        for (std::size_t i = 0; i < keys_.size(); ++i)
            for (int axis = 0; axis < D; ++axis)
                if (const int row = system_.nodes + static_cast<int>(i), other = beside_[i][2 * axis + 1];
                    other >= 0 && other != row && faces_[i][2 * axis + 1] > 0)
                    f(row, other, faces_[i][2 * axis + 1]);
    }
    /// Calls f(row, conductance) for what leads to the pressure 0: the film's grounds, and faces on open sides of the domain.
    template <class F>
    void for_each_ground(F&& f) const
    {
        for (int i = 0; i < system_.nodes; ++i)
            if (matrix_.film_ground()[i] != 0)
                f(i, matrix_.film_ground()[i]);
        for_each_side([&](int row, const Index<D>& cell, double conductance) {
            if (!system_.grid->in_domain(cell))
                f(row, conductance);
        });
    }
    /// Calls f(row, cell, conductance) for the faces between the band's cells and this rank's other ones.
    template <class F>
    void for_each_face_beside(F&& f) const
    {
        for_each_side([&](int row, const Index<D>& cell, double conductance) {
            if (system_.grid->in_domain(cell) && system_.grid->owns(cell))
                f(row, cell, conductance);
        });
    }
    /// Rows of a link's nodes and cells in the band, with their weights.
    auto link_rows(long link) const { return link_rows_[link]; }
    /// Row of a cell; -1 outside the band.
    int row_of(long key) const;

    /// First half: correction = solve(r on the band); turns `level.b`, which holds scale * r, into scale * (r - L correction).
    void first(const UnknownVector<D>& r, double scale, Level<D>& level);
    /// Second half: correction += solve(-L x) with x = scale * level.x in the cells; ghosts of level.x are up to date.
    /// Collective.
    void second(double scale, const Level<D>& level);
    /// The correction of the film nodes; empty without films.
    Eigen::VectorXd node_correction() const { return correction_.head(system_.nodes); }
    /// Calls f(cell, correction) for this rank's band cells of a plane normal to the last axis.
    template <class F>
    void for_each_correction(int plane, F&& f) const
    {
        if (empty())
            return;
        const int k = plane - system_.grid->low()[D - 1];
        for (int i = plane_begin_[k]; i < plane_begin_[k + 1]; ++i)
            f(owned_[i].cell, correction_[owned_[i].row]);
    }

    long bytes() const;

private:
    struct Neighbour { ///< cell outside the band, beside a band cell
        long level_offset;
        int row;
        double conductance;
    };
    struct LinkCell {
        int link;
        long level_offset;
        double weight;
    };
    /// The weighted sum of a link over the band's nodes and cells.
    double sum_over_band(int link, const Eigen::VectorXd& values) const;
    void find_cells();
    /// solve(x), with the means over the floating blocks taken off before and after.
    template <class Columns, class Solve>
    Columns between_means(Columns x, Solve&& solve) const;
    /// Calls f(row, cell, conductance) for the open faces from the band's cells to cells that are not in the band.
    template <class F>
    void for_each_side(F&& f) const
    {
        for (std::size_t i = 0; i < keys_.size(); ++i)
            for (int side = 0; side < 2 * D; ++side)
                if (beside_[i][side] < 0 && faces_[i][side] > 0) {
                    Index<D> cell = system_.grid->cell_of_key(keys_[i]);
                    cell[side / 2] += side % 2 ? 1 : -1;
                    f(system_.nodes + static_cast<int>(i), system_.grid->wrapped(cell), faces_[i][side]);
                }
    }
    /// Calls f(i, j, value) for the terms that make up the submatrix' lower triangle, and join(i, j) for rows that one of them
    /// ties; `fixed` becomes 1 in rows that something outside the band fixes.
    template <class F, class Join>
    void for_each_term(F&& f, Join&& join, std::vector<char>& fixed) const;
    Eigen::SparseMatrix<double> assemble();

    const CoupledOperator<D>& matrix_;
    const CoupledSystem<D>& system_;
    int size_ = 0;
    std::vector<long> keys_;                       ///< of the band's cells, sorted
    KeyMap<int> rows_;                             ///< of these cells
    std::vector<OwnedCell> owned_;                 ///< in the order of keys_: by planes normal to the last axis
    std::vector<int> plane_begin_;                 ///< first of owned_ in every plane of the rank's block; and the end
    std::vector<Neighbour> outside_;               ///< this rank's
    std::vector<LinkCell> link_cells_;             ///< this rank's
    std::vector<LinkCell> outside_links_;          ///< those of them whose cells are not in the band, by links
    WeightedLists<int> link_rows_;                 ///< by link, rows of the band that it enters: nodes, then cells
    std::vector<std::array<double, 2 * D>> faces_; ///< conductances around every band cell
    std::vector<std::array<int, 2 * D>> beside_;   ///< rows of the cells beyond these faces, -1: not in the band
    std::vector<int> block_;                       ///< number of the floating block of a row, -1: fixed from outside
    std::vector<long> block_size_;
    SparseCholesky factor_;
    Eigen::VectorXd correction_;
};

} // namespace gapflow
