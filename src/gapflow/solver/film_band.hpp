// The films' half of the Schwarz pair: a direct solve of all film nodes together with a band of cells around their mouths.
#pragma once

#include "gapflow/core/sparse_cholesky.hpp"
#include "gapflow/film/key_map.hpp"
#include "gapflow/solver/coupled_operator.hpp"
#include "gapflow/solver/level.hpp"

#include <span>
#include <vector>

namespace gapflow {

/// The principal submatrix of L on film nodes [0, nodes) and the band's cells [nodes, size). Its rows are the same on all ranks; each rank factorises those
/// that it has.
template <int D>
class FilmBand {
public:
    /// Finds the band; factorise() is to follow. Collective.
    explicit FilmBand(const CoupledOperator<D>& matrix);
    /// Of this rank's rows; share() is to follow. Not collective.
    void factorise();
    /// What all ranks must know of the factors. Collective.
    void share();

    bool empty() const { return size_ == 0; }
    int size() const { return size_; }
    /// Whether the level of the row's block is undetermined, without a connection to the outside of the band.
    bool floating(int row) const { return floating_[row]; }

    /// A band cell that this rank owns.
    struct OwnedCell {
        int row; ///< in the band
        Index<D> cell;
        long level_offset; ///< in the finest level's block
    };
    const std::vector<OwnedCell>& owned() const { return owned_; }

    /// Values on the band of a vector. Collective.
    Eigen::VectorXd gather(const UnknownVector<D>& v) const;
    /// The inverse of the submatrix of each rank's rows; on floating blocks, without connections to the outside, the pseudo-inverse. Collective.
    Eigen::VectorXd solve(const Eigen::VectorXd& r) const;
    /// The inverse of the whole submatrix. Collective.
    Eigen::VectorXd solve_together(const Eigen::VectorXd& r) const;

    /// First half: correction = solve(r on the band); turns `level.b`, which holds scale * r, into scale * (r - L correction). Collective.
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
    struct LinkRow { ///< row of the band that a link enters
        int row;
        double weight;
    };
    std::span<const LinkRow> rows_of(int link) const
    {
        return {link_rows_.data() + link_rows_begin_[link], link_rows_.data() + link_rows_begin_[link + 1]};
    }
    /// A term of L whose rows several ranks have: a link, or a face between two cells. In each one's submatrix it counts by itself, times the number
    /// of these ranks, which bounds the term.
    struct CrossLink {
        int link;
        int ranks;
    };
    struct CrossFace {
        int row, other;
        double conductance;
    };
    /// The weighted sum of a link over the band's nodes and cells.
    double sum_over_band(int link, const Eigen::VectorXd& values) const;
    /// The same over the rows of one rank.
    double sum_over_part(int link, int rank, const Eigen::VectorXd& values) const;
    void find_cells();
    void find_cross_terms();
    /// Adds (submatrices - whole submatrix) v in the band's rows that `accepts`: what v = solve(r) leaves of r in cross terms.
    template <class Accepts>
    void add_cross_residual(const Eigen::VectorXd& v, Accepts&& accepts, Eigen::VectorXd& r) const;
    /// The whole submatrix times v. Collective.
    Eigen::VectorXd multiply(const Eigen::VectorXd& v) const;
    /// Of this rank's rows: what is not a floating block's constant.
    Eigen::VectorXd without_block_constants(Eigen::VectorXd v) const;
    /// The floating blocks' constants in r, in all rows of the band; empty where no block floats. Collective.
    Eigen::VectorXd block_constants(const Eigen::VectorXd& r) const;
    /// This rank's rows of a vector on the band, and back; the others are 0.
    Eigen::VectorXd own(const Eigen::VectorXd& v) const;
    Eigen::VectorXd all(const Eigen::VectorXd& own) const;
    int row_of(long key) const; ///< of a cell; -1 outside the band
    /// Calls f(i, j, value) for the terms that make up the lower triangle of the submatrix of this rank's rows (`whole`: of all rows), and join(i, j) for rows
    /// that one of them ties, numbers among these rows; `fixed` becomes 1 in rows that something outside fixes.
    template <class F, class Join>
    void for_each_term(bool whole, F&& f, Join&& join, std::vector<char>& fixed) const;
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
    std::vector<LinkRow> link_rows_;               ///< by links: nodes, then cells that are in the band
    std::vector<int> link_rows_begin_;             ///< first of each link's, and the end
    std::vector<std::array<double, 2 * D>> faces_; ///< conductances around every band cell
    std::vector<int> rank_;                        ///< that has a row
    std::vector<int> rows_of_rank_;                ///< this rank's rows
    std::vector<int> place_;                       ///< of a row among them, -1: another rank's
    std::vector<CrossLink> cross_links_;
    std::vector<CrossFace> cross_faces_; ///< each once
    std::vector<int> block_;             ///< number of the floating block of this rank's rows, -1: fixed from outside
    std::vector<long> block_size_;
    std::vector<char> floating_; ///< rows of blocks that float
    bool any_floating_ = false;  ///< on any rank
    SparseCholesky factor_;
    Eigen::VectorXd correction_;
};

} // namespace gapflow
