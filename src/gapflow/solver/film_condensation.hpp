// Films condensed to their rims: what no link joins to cells or to other films is eliminated film by film, exactly.
#pragma once

#include "gapflow/coupling/system.hpp"

#include <Eigen/Dense>

#include <vector>

namespace gapflow {

/// The coupled system in the unknowns that are left, and the way to it and back. Eliminated nodes add to the masses of the bodies beside their film. Films stay
/// whole where they are large, where voids lie in them, where their mouths conduct next to nothing, or where they weigh much more than the bodies beside them.
/// Each rank eliminates its own nodes. In the reduced system every rank has all rows.
template <int D>
class FilmCondensation {
public:
    /// Keeps a reference. Collective, as reduce() and expand() are.
    explicit FilmCondensation(const CoupledSystem<D>& system);
    FilmCondensation(const FilmCondensation&) = delete;

    /// Whether nothing is eliminated: the system itself is to be solved.
    bool empty() const { return !reduces_; }
    /// The reduced system.
    const CoupledSystem<D>& reduced() const { return reduced_; }
    /// Takes the system's masses and contacts anew.
    void update_bodies();

    /// Values of the nodes that are left.
    Eigen::VectorXd kept(const Eigen::VectorXd& nodes) const;
    struct Reduced {
        Eigen::VectorXd nodes;  ///< right-hand side of the nodes that are left, if the bodies do not move
        Eigen::VectorXd wrench; ///< on the bodies, of the eliminated nodes under their own right-hand side
    };
    /// Of the nodes' right-hand side.
    Reduced reduce(const Eigen::VectorXd& rhs) const;
    /// Pressures of all nodes, from those of the nodes that are left and the bodies' response M^-1 K^T p.
    Eigen::VectorXd expand(const Eigen::VectorXd& rhs, const Eigen::VectorXd& nodes, const Eigen::VectorXd& twist) const;

    long bytes() const;

private:
    struct Film {
        std::vector<int> inner, rim;        ///< nodes of the system: eliminated, left
        std::vector<int> bodies;            ///< beside it, those of the system
        Eigen::LLT<Eigen::MatrixXd> factor; ///< of L_ii
        Eigen::MatrixXd to_rim;             ///< L_ir
        Eigen::MatrixXd levels;             ///< -L_ii^-1 L_ir: inner pressures over those of the rim
        Eigen::MatrixXd flux;               ///< K_i, columns of the bodies' twists
    };
    using Entry = Eigen::Triplet<double, int>;
    /// What is left of a film, condensed or whole.
    struct Remainder {
        bool condensed = false;
        std::vector<int> nodes; ///< of the system
        std::vector<Entry> fluid;
        std::vector<BodyFlux<D, int>> flux;
        std::vector<Entry> mass; ///< added to the bodies'

        template <class F>
        void each_field(F&& f)
        {
            f(condensed, nodes, fluid, flux, mass);
        }
    };
    std::vector<Film> connected_nodes() const;
    /// False where the film is to stay whole.
    bool condense(Film& film, const std::vector<long>& fluxes, Remainder& left) const;
    Remainder whole(const Film& film, const std::vector<long>& fluxes) const;
    std::vector<Remainder> of_all_ranks(std::vector<Remainder> left) const;
    void assemble(const std::vector<Remainder>& films);
    /// The twists of a film's bodies, in a row.
    Eigen::VectorXd of_bodies(const Film& film, const Eigen::VectorXd& twists) const;

    const CoupledSystem<D>& system_;
    CoupledSystem<D> reduced_;
    bool reduces_ = false;
    std::vector<Film> films_;           ///< of this rank that are condensed
    std::vector<int> number_;           ///< of each node among those left, -1: eliminated
    Eigen::SparseMatrix<double> added_; ///< to the masses
};

} // namespace gapflow
