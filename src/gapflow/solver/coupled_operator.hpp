// The matrix-free product with L + K M^-1 K^T.
#pragma once

#include "gapflow/coupling/body_response.hpp"
#include "gapflow/solver/film_edges.hpp"
#include "gapflow/solver/level.hpp"
#include "gapflow/solver/row_runs.hpp"
#include "gapflow/solver/vectors.hpp"
#include "gapflow/solver/weighted_lists.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace gapflow {

/// Flattened view of a system, for products. Keeps a reference to it. The film's matrix is applied as edges, flux = conductance (p_i - p_j), and
/// grounds, flux = conductance p_i: differences keep the constants' product exactly zero where a film of conductance 1e7 has mouths of 1e-7.
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
    /// M^-1 w, contacts held; `held`, if given, receives their impulses.
    Eigen::VectorXd inverse_mass(const Eigen::VectorXd& w, Eigen::VectorXd* held = nullptr) const;
    /// The same of every column.
    Eigen::MatrixXd inverse_mass_of_columns(const Eigen::MatrixXd& w) const { return response_.of_columns(w); }

    /// The parts of apply(), for callers that pass over memory once for several things: first begin_product (once as long as
    /// p is not written beyond the domain), then product_plane of every plane normal to the last axis, once p is known on the
    /// planes beside it and ghosts are filled, then finish_product with the sum of what product_plane returned.
    void begin_product(UnknownVector<D>& p) const;
    double product_plane(const CellField<D>& p, CellField<D>& y, int plane) const;
    double finish_product(const UnknownVector<D>& p, UnknownVector<D>& y, double grid_energy, bool with_bodies = true) const;
    /// K^T p of the last product with the bodies.
    auto last_wrench() const { return partial_.segment(static_cast<long>(system_.links.size()), dofs_); }
    /// Ghosts of p that other ranks, or the far side of a periodic axis, own. Collective.
    void exchange(UnknownVector<D>& p) const { halo_.exchange(p.cells.data()); }
    /// Whether ghosts are exchanged along the last axis at most.
    bool halo_only_last_axis() const { return halo_.only_last_axis(); }
    const std::array<SharedRows<double>, D>& conductance() const { return conductance_; }

    /// Calls f(i, j, conductance) for the film's edges, i < j.
    template <class F>
    void for_each_film_edge(F&& f) const
    {
        gapflow::for_each_film_edge(system_.film, f);
    }
    const std::vector<double>& film_ground() const { return ground_; }
    long bytes() const;

private:
    double apply(UnknownVector<D>& p, UnknownVector<D>& y, bool with_bodies) const;
    double sum_links(const UnknownVector<D>& p) const;
    double multiply_nodes(const UnknownVector<D>& p, UnknownVector<D>& y) const;

    const CoupledSystem<D>& system_;
    int dofs_;
    std::array<SharedRows<double>, D> conductance_;
    WeightedLists<long> link_cells_; ///< by link, this rank's cells (places in a field)
    WeightedLists<int> link_nodes_;
    std::vector<long> linked_cells_; ///< sorted
    WeightedLists<int> cell_links_;  ///< by linked cell
    WeightedLists<int> node_links_;
    RowRuns cell_flux_runs_, node_flux_runs_;
    std::vector<double> ground_;
    BodyResponse response_;
    mutable Halo<D, double> halo_;
    mutable Eigen::VectorXd partial_; ///< sums over cells: a number a link, the bodies' wrenches, p . L p of the grid
};

} // namespace gapflow
