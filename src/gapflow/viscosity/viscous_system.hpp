// The implicit viscous step of the bulk (method, "Viscosity"): velocities u of the open faces and twists V of the free
// bodies minimise
//
//     sum_f 1/2 rho a_f dx^D (u_f - u*_f)^2  +  1/2 |V - V*|^2_M  +  1/2 mu dt int |grad u|^2,
//
// one component at a time on the lattice of its face centres. int |grad u|^2 goes over the fluid and, as rigid motion, over the
// bodies: for flow without divergence that is the dissipation 2 mu int D:D (the two differ by a null Lagrangian, a sum of
// boundary terms that walls and rigid bodies turn into 2 mu volume |omega|^2 a body), so the true traction acts on the bodies.
// Between two points of the fluid a lattice edge has (u_i - u_j)^2 / dx, an edge cut by a surface at the distance theta dx has
// (u_i - U(x_G))^2 / (theta dx) with the solid's velocity U where it is cut (Gibou, Fedkiw, Cheng & Kang, J. Comput. Phys. 176,
// 2002; symmetric, second order). The bodies' twists are unknowns as in Batty & Bridson (SCA 2008) and Takahashi & Batty (CGF 38,
// 2019).
//
// u_f is the mean over the open part of its face. On a cut face that differs from the lattice's value w at the face centre: on the
// line through the centre and the open part's centroid, which meets the surface at x*, u_f = s w + (1 - s) U(x*). Where the centre
// lies in the solid or next to it, u_f follows its neighbour w_j instead, u_f ~ r w_j + (1 - r) U(x*) on their common line, tied
// with the stiffness of that stretch of fluid. All of it is exact for linear flow along a surface at any angle.
//
// In the variables (w, V) the matrix is symmetric positive definite.
#pragma once

#include "gapflow/coupling/coupling.hpp"

#include <array>
#include <vector>

namespace gapflow {

/// Energy 1/2 k (weight w_f + sum row_b . V_b - target)^2 of one lattice value (none: at < 0) and the twists of up to two solids.
template <int D>
struct ViscousTerm {
    int axis = 0;
    long at = -1; ///< offset in the component's field
    double stiffness = 0, weight = 0, target = 0;
    std::array<int, 2> solid{-1, -1};
    std::array<Twist<D>, 2> row;
};

/// A cut face of this rank whose velocity is u = share w + row . V of the solid.
template <int D>
struct ViscousCutFace {
    int axis;
    long at;
    double share;
    int solid; ///< -1: none
    Twist<D> row;
};

/// A face of this rank that follows a neighbour: u = (mass u* + stiffness (share w + row . V)) / (mass + stiffness).
template <int D>
struct FollowingFace {
    int axis;
    long at, leader; ///< leader < 0: follows solids alone
    double mass, stiffness, share;
    std::array<int, 2> solid{-1, -1};
    std::array<Twist<D>, 2> row;
};

/// A face beside a wall of the domain, and the part of its mass that moves with the wall.
struct HeldMass {
    int axis;
    long at;
    double mass;
};

template <int D>
struct ViscousSystem {
    const Grid<D>* grid = nullptr;
    double edge = 0; ///< mu dt dx^(D-2): of an edge between two points of the fluid in the core; outside times EdgeRow's ratio
    double cell_mass = 0; ///< rho dx^D
    /// Of every solid: times its angular velocity, the torque's impulse that |grad u|^2 lacks. 2 mu dt volume, as the lattice
    /// measures the volume: fluid that turns with a body exerts no torque.
    std::vector<Eigen::Matrix<double, spin_size<D>, spin_size<D>>> turning;
    FaceField<D, std::int8_t> active; ///< 1: the lattice has a value here; with one layer of ghosts
    FaceField<D> diagonal;            ///< of the matrix, 0 where not active
    FaceField<D> rhs;
    double constant = 0;               ///< this rank's share of twice the energy at (w, V) = 0
    std::vector<ViscousTerm<D>> terms; ///< those with a solid
    std::vector<ViscousCutFace<D>> cut;
    std::vector<FollowingFace<D>> following;
    std::vector<HeldMass> beside_walls;
    std::vector<int> free_body;             ///< number of each solid among the free bodies, -1: none
    std::vector<TwistMatrix<D>> admissible; ///< of the free bodies
    Eigen::SparseMatrix<double>
        body_matrix; ///< of the twists: masses, and contributions of the terms and of rotation; the same on all ranks
    Eigen::VectorXd body_rhs;
};

/// The bodies' part of the step.
template <int D>
struct ViscousBodies {
    std::vector<TwistMatrix<D>> mass; ///< of each solid; counts for free ones
    std::vector<Twist<D>> twists;     ///< V* of free bodies; of others as given
};

/// `u_star`: on open faces, ghosts filled (boundary faces of walls and inflow hold their velocity, ghosts beyond an inflow side
/// that side's). `outside`: of the fluid beyond far sides. Collective.
template <int D>
ViscousSystem<D> viscous_system(const Coupling<D>& coupling, double viscosity, double dt, const FaceField<D>& u_star,
                                const ViscousBodies<D>& bodies, const Vec<D>& outside = Vec<D>::Zero());

} // namespace gapflow
