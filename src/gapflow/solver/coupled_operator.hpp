// The matrix-free product with L + K M^-1 K^T.
#pragma once

#include "gapflow/coupling/body_response.hpp"
#include "gapflow/solver/vectors.hpp"

#include <vector>

namespace gapflow {

/// The film's matrix as edges, flux = conductance (p_i - p_j), and grounds, flux = conductance p_i: differences keep the
/// constants' product exactly zero where a film of conductance 1e7 hangs on conduits of 1e-7.
struct FilmEdge {
    int i, j;
    double conductance;
};

/// Flattened view of a system, for products. Keeps a reference to it.
template <int D>
class CoupledOperator {
public:
    explicit CoupledOperator(const CoupledSystem<D>& system);
    /// Takes the system's masses and contacts anew.
    void update_bodies();

    const CoupledSystem<D>& system() const { return system_; }
    int dofs() const { return dofs_; }

    /// y = (L + K M^-1 K^T) p; returns p . y. Ghosts of p are filled. Cells without unknown get 0. Collective.
    double apply(UnknownVector<D>& p, UnknownVector<D>& y) const;
    /// y = L p; returns p . y.
    double apply_fluid(UnknownVector<D>& p, UnknownVector<D>& y) const;
    /// Bound of the round-off in a residual at p: 3e-15 times the norm of the sums of the terms' magnitudes. Collective.
    double round_off(const UnknownVector<D>& p) const;
    /// K^T p. Collective.
    Eigen::VectorXd transpose_flux(const UnknownVector<D>& p) const;
    /// y += K u.
    void add_flux(const Eigen::VectorXd& u, UnknownVector<D>& y) const;
    /// M^-1 w, contacts held.
    Eigen::VectorXd inverse_mass(const Eigen::VectorXd& w) const;

    const std::vector<FilmEdge>& film_edges() const { return edges_; }
    const std::vector<double>& film_ground() const { return ground_; }
    /// Weighted sum of x over a link's nodes.
    double node_sum(const Link& link, const Eigen::VectorXd& x) const;
    long bytes() const;

private:
    struct LinkCell {
        int link;
        Index<D> cell;
        double weight;
    };
    double apply(UnknownVector<D>& p, UnknownVector<D>& y, bool with_bodies) const;
    double grid_product(const CellField<D>& p, CellField<D>& y) const;
    void clear_outside(CellField<D>& p) const;

    const CoupledSystem<D>& system_;
    int dofs_;
    std::vector<LinkCell> link_cells_; ///< those of this rank
    std::vector<FilmEdge> edges_;
    std::vector<double> ground_;
    BodyResponse response_;
    mutable Halo<D, double> halo_;
    mutable Eigen::VectorXd partial_; ///< sums over cells: a number a link, the bodies' wrenches, p . L p of the grid
};

} // namespace gapflow
