// The sum of the viscous step's terms: the lattice's diagonal and right-hand side, and the blocks of the free bodies (method, "Viscosity").
#pragma once

#include "gapflow/viscosity/viscous_system.hpp"

#include <map>
#include <utility>
#include <vector>

namespace gapflow {

template <int D>
class ViscousTerms {
public:
    /// Adds to `system`, which must last.
    ViscousTerms(const Coupling<D>& coupling, const ViscousBodies<D>& bodies, ViscousSystem<D>& system)
        : coupling_(coupling), grid_(*coupling.grid), bodies_(bodies), system_(system),
          body_rhs_(Eigen::VectorXd::Zero(n * coupling.system.bodies))
    {
    }

    void add(const ViscousTerm<D>& term);
    /// The bodies' matrix and right-hand side, once all terms are there. Collective.
    void finish();

private:
    static constexpr int n = twist_size<D>;
    using Spins = Eigen::Matrix<double, spin_size<D>, spin_size<D>>;

    void add_block(int a, int b, const TwistMatrix<D>& block);
    void share_turning();
    void add_blocks_between_bodies(std::vector<Eigen::Triplet<double>>& entries);

    const Coupling<D>& coupling_;
    const Grid<D>& grid_;
    const ViscousBodies<D>& bodies_;
    ViscousSystem<D>& system_;
    std::map<std::pair<int, int>, TwistMatrix<D>> blocks_; ///< of pairs of free bodies
    Eigen::VectorXd body_rhs_;
};

} // namespace gapflow
