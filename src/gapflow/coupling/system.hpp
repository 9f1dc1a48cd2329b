// The coupled linear system of one projection (method, "The coupled system"), as data:
//
//     (L + K M^-1 K^T) p = rhs
//
// p: pressure impulses of grid cells (dense, on their owners) and of film nodes (few, replicated on every rank).
// L: grid faces (conductance a_f |f| / (rho dx)), film elements, and links (mouths, joints): rank-one terms
//    g w w^T over film nodes and cells. K: flux out of each unknown's volume per unit twist of each free body.
// M: mass matrix of the free bodies' twists, with the films' blocks that couple two bodies.
#pragma once

#include "gapflow/core/types.hpp"
#include "gapflow/coupling/body_response.hpp"
#include "gapflow/grid/field.hpp"

#include <Eigen/Sparse>

#include <array>
#include <string>
#include <vector>

namespace gapflow {

/// A value for every unknown. Cells without an unknown hold 0. Node values are the same bits on all ranks.
template <int D>
struct UnknownVector {
    CellField<D> cells;
    Eigen::VectorXd nodes;
};

/// Flux q = conductance * sum_i weight_i p_i between film nodes and cells; enters row i with weight_i.
struct Link {
    double conductance;
    std::vector<std::pair<int, double>> nodes;  ///< film node, weight
    std::vector<std::pair<long, double>> cells; ///< Grid::key of the cell, weight
};

/// Entry of K in a row of the grid or of the film.
template <int D, class Row>
struct BodyFlux {
    Row row;  ///< Index<D> of an owned cell, or film node
    int body; ///< number among the bodies of this system
    Twist<D> flux;
};

/// A face that a film closes to the grid.
template <int D>
struct FilmFace {
    int axis;
    Index<D> face;
    double conductance;          ///< that its open part would have on the grid
    std::array<bool, 2> unknown; ///< whether the cells below and above hold one
};

/// A connected part of the fluid: unknowns joined by faces, film elements or links.
struct Component {
    bool grounded = false; ///< touches an open side: its pressure level is fixed
    long unknowns = 0;
    int grid_parts = -1;     ///< parts of it that the grid's faces alone connect; -1: not counted
    bool open_faces = false; ///< faces of the grid lead to an open side
};

template <int D>
struct CoupledSystem {
    const Grid<D>* grid = nullptr;
    /// Conductance of every face, 0 where closed. On open sides of the domain: to the pressure 0 beyond the face (distance
    /// dx/2, so twice the inner value); on far sides to the pressure 0 at infinity (far_distance()). Valid on all faces of owned cells (both sides of the block).
    FaceField<D> conductance;
    /// Faces on this rank's block (its ends included) whose flow is part of a film. Not part of the system: multigrid uses them to
    /// connect the cells that the films join.
    std::vector<FilmFace<D>> film_faces;
    int nodes = 0;
    /// Nodes whose rows this rank has: each is one rank's. Empty: every rank has all rows.
    std::vector<char> own_node;
    Eigen::SparseMatrix<double> film;             ///< nodes x nodes, symmetric, positive semidefinite; the columns of own nodes
    std::vector<Link> links;                      ///< the same list on all ranks
    int bodies = 0;                               ///< free bodies; dof = twist_size<D> * body + component
    std::vector<BodyFlux<D, Index<D>>> cell_flux; ///< K in this rank's cells
    std::vector<BodyFlux<D, int>> node_flux;      ///< K in own film nodes
    Eigen::SparseMatrix<double> mass;             ///< dofs x dofs, symmetric positive definite; the same on all ranks
    /// Contacts that hold the bodies: C, rows x dofs, and the resistance of each. M^-1 in this system stands for
    /// BodyResponse(mass, contact, contact_resistance).
    Eigen::SparseMatrix<double> contact;
    Eigen::VectorXd contact_resistance; ///< impulse over speed; infinite: rigid
    BodyResponse response;              ///< that one; without it the solver makes its own

    std::vector<Component> components;
    CellField<D, int> component; ///< of each cell, -1: no unknown; valid on owned cells
    std::vector<int> node_component;
    /// Null vectors of L + K M^-1 K^T: combinations of the components' constants, orthonormal coefficients
    /// (components x null vectors), found by coupling (kernel of K^T on the floating components).
    Eigen::MatrixXd null_space;

    bool owns(int node) const { return own_node.empty() || own_node[node]; }
};

} // namespace gapflow
