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
          own_blocks_(coupling.system.bodies, TwistMatrix<D>::Zero()),
          body_rhs_(Eigen::VectorXd::Zero(n * coupling.system.bodies))
    {
    }

    void add(const ViscousTerm<D>& term)
    {
        system_.constant += add_to_lattice(term);
        add_to_bodies(term);
    }
    /// The two parts of add(). The first adds to the lattice's value alone, so that threads may call it for different ones, and returns twice the
    /// term's energy at (w, V) = 0, for ViscousSystem::constant. The second does nothing for a term without solids.
    double add_to_lattice(const ViscousTerm<D>& term) const;
    void add_to_bodies(const ViscousTerm<D>& term);
    /// The bodies' matrix and right-hand side, once all terms are there. Collective.
    void finish();

private:
    static constexpr int n = twist_size<D>;
    using Spins = Eigen::Matrix<double, spin_size<D>, spin_size<D>>;

    double target_of(const ViscousTerm<D>& term) const;
    void add_block(int a, int b, const TwistMatrix<D>& block);
    void share_turning();
    void add_blocks_between_bodies(std::vector<Eigen::Triplet<double>>& entries);

    const Coupling<D>& coupling_;
    const Grid<D>& grid_;
    const ViscousBodies<D>& bodies_;
    ViscousSystem<D>& system_;
    std::vector<TwistMatrix<D>> own_blocks_;               ///< of the free bodies
    std::map<std::pair<int, int>, TwistMatrix<D>> blocks_; ///< of pairs of two
    Eigen::VectorXd body_rhs_;
};

} // namespace gapflow
