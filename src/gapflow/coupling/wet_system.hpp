// The coupled system without the film nodes that are voids (method, "Voids: dry contact and cavitation"): there the pressure impulse is given, b, and
// with p = b + p', b = 0 outside the voids and p' = 0 in them,
//
//     (L + K M^-1 K^T) p' = -(D u* + K V*) - f - (L + K M^-1 K^T) b       on all other unknowns,
//
// f the inflow that fills the void that a node had before it became wet.
// Every row is the same function of p whatever nodes are voids: elements between voids are part of L.
#pragma once

#include "gapflow/coupling/coupling.hpp"

#include <array>
#include <vector>

namespace gapflow {

/// Removes void nodes from coupling.system during its lifetime; its destructor restores the system.
template <int D>
class WetSystem {
public:
    explicit WetSystem(Coupling<D>& coupling);
    ~WetSystem();
    WetSystem(const WetSystem&) = delete;
    WetSystem& operator=(const WetSystem&) = delete;

    /// From now on these nodes are the voids, with pressure impulses b (0 elsewhere): their rows in coupling.system stand alone;
    /// and the mouths marked in `shut` have a negligible conductance and are not part of K (the master's flux through them is 0),
    /// also after destruction. Collective.
    void take_out(const std::vector<char>& is_void, const Eigen::VectorXd& b, const std::vector<char>& shut);
    const Eigen::VectorXd& given() const { return b_.nodes; }
    double conductance(std::size_t link) const { return links_[link].conductance; }
    /// Adds M^-1 K^T b to V*, and its contribution to the held contacts' impulses. Collective.
    void add_void_impulse(std::vector<Twist<D>>& twists, Eigen::VectorXd& contact_impulse) const;
    /// Turns `rhs` = -(D u* + K V), with b in V, into that of p'. `filling`: f of every film node. Collective.
    void reduce(const std::vector<Twist<D>>& twists, const Eigen::VectorXd& filling, UnknownVector<D>& rhs);
    struct Outcome {
        Eigen::VectorXd outflow;  ///< L p + K V + D u* of all film nodes
        std::vector<double> drop; ///< pressure impulse of the film minus that of the bulk, one for each mouth
    };
    /// After the solve for p' gave V. Collective.
    Outcome outcome(const UnknownVector<D>& p, const std::vector<Twist<D>>& twists) const;

private:
    void close(const std::vector<char>& shut);
    UnknownVector<D> film_outflow(const UnknownVector<D>& p, std::vector<double>* drop = nullptr) const;

    Coupling<D>& coupling_;
    std::vector<char> is_void_;
    UnknownVector<D> b_;
    Eigen::VectorXd star_outflow_; ///< D u* + K V* of the film nodes
    std::vector<Twist<D>> star_twists_;
    Eigen::SparseMatrix<double> film_;
    std::vector<Link> links_;
    std::vector<double> open_conductance_;    ///< of the links
    std::vector<BodyFlux<D, int>> node_flux_; ///< of the system, voids included
    std::array<std::size_t, 4> entries_; ///< of K with all mouths open: in cells and nodes, of all solids and of the system
    std::vector<Component> components_;
    Eigen::MatrixXd null_space_;
};

} // namespace gapflow
