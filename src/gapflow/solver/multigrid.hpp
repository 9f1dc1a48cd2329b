// Geometric multigrid on the grid block of the coupled system.
#pragma once

#include "gapflow/solver/level.hpp"

#include <Eigen/Dense>

#include <vector>

namespace gapflow {

/// One symmetric V(2,2) cycle as an approximate inverse of the grid's Laplacian (faces only: no films, no bodies).
template <int D>
class Multigrid {
public:
    /// `conductance`: the system's, as shared_conductances gives it.
    Multigrid(const CoupledSystem<D>& system, const std::array<SharedRows<double>, D>& conductance);

    /// The finest level. Before cycle(): its b holds the right-hand side. After: its x, ghosts included, times scale() is
    /// the approximate solution.
    Level<D>& finest() { return levels_.front(); }
    const Level<D>& finest() const { return levels_.front(); }
    double scale() const { return scale_; }
    void cycle();
    int level_count() const { return static_cast<int>(levels_.size()); }
    long bytes() const;

private:
    void cycle(std::size_t number);
    void gather_right_hand_side();
    void solve_coarsest();

    Communicator comm_;
    double scale_ = 1;
    std::vector<Level<D>> levels_;
    std::size_t first_gathered_ = 0; ///< levels from here on hold all cells on every rank
    std::vector<float> send_, take_;
    std::vector<int> counts_, starts_;
    std::vector<Block<D>> parts_; ///< cells of every rank on the first gathered level
    std::vector<long> coarsest_cells_;
    Eigen::MatrixXd coarsest_inverse_;
    Eigen::VectorXd coarsest_b_, coarsest_x_;
};

} // namespace gapflow
