// Viscosity in films and mouths (method, "Films of viscous fluid"): an element's one velocity u and the twists of its two walls minimise
//
//     1/2 rho S |u - u*|^2 + 1/2 rho S beta |u - U_w|^2 + 1/2 mu dt I |[U]_t|^2,   S = int h, I = int 1/h, beta = 12 nu dt I / S,
//
// with U_w the film's velocity under drag by the walls alone (the mean of both along it, and terms of second order in the slope of the walls
// against each other, see wall_rows), and [U]_t their difference, both at mid-gap
// (in 3D, where elements are coarser: beta = 12 nu dt S int 1/h^3 / area^2, for one flux through the element rather than
// one velocity; the same where the thickness is constant).
// So u = kappa (u* - grad p / rho) + theta U_w, kappa = 1/(1 + beta), theta = beta kappa; the bodies' mass gains
// rho S theta P_w^T P_w + mu dt I [P]^T [P], its right-hand side rho S theta P_w^T u*. Exact without inertia (Reynolds) and
// without viscosity (Euler). Where the film is slanted against the line along which h is measured, by an angle a (half of that
// between the walls), beta is larger by cos^-5.8 a: exact flow in a wedge of the angle 2 a to second order.
// Where a part of the gap is a void (its share 1 - s), s times as much fluid is dragged along: U_m + s (U_w - U_m) replaces U_w, U_m being
// the master's velocity, and s S and s I replace S and I in the forces on the bodies.
// Mouths: the same with rho R h^2 length for rho S, and beta = 12 nu dt / h^2 where the gap goes on, 16 nu dt / (pi h^2 R) at a
// sharp edge (half of the pressure drop of Stokes flow out of a slit, 32 mu q / (pi h^2)).
#pragma once

#include "gapflow/coupling/coupling.hpp"

namespace gapflow {

/// Fills the coupling's element_drag, mouth_drag and drag_inertia, for viscosity_dt = mu dt > 0; `mass`: of the solids, as for couple(). Before assemble_films().
template <int D>
void find_drag(Coupling<D>& coupling, double viscosity_dt, const std::vector<TwistMatrix<D>>& mass,
               const DragTerms& terms = {});

/// beta of a film's elements, without the bound of impermeable films. `viscosity_dt`: mu dt.
template <int D>
std::vector<double> element_betas(const FilmMesh<D>& mesh, double viscosity_dt, double density);

/// Times grad p / rho . grad N: flux of an element's pressure. `e`: number in its film.
template <int D>
double film_conductance(const Coupling<D>& coupling, const Film<D>& film, std::size_t e);

/// Rows of t . U_w in the twists of a film's two walls, for t along the element: such that the flux that a wall drags along is exact to
/// second order in the angle between the walls, and to first order in the gap's curvature; the same motion of both gives t . U. For the
/// share 1 - `wet` of the gap, a void, the master's.
template <int D>
struct WallRows {
    Twist<D> master, other;
};
template <int D>
WallRows<D> wall_rows(const Coupling<D>& coupling, const FilmMesh<D>& mesh, const FilmElement<D>& e, const Vec<D>& t,
                      double wet);

/// Takes the speeds of drag_inertia from u*, then replaces u* by kappa u*, the argument of outflow().
template <int D>
void start_drag(Coupling<D>& coupling, FluidVelocity<D>& u_star);

/// theta length h nu . U_w of a mouth: the flux that both walls drag out of the film there; 0 without viscosity.
template <int D>
double entrained_flux(const Coupling<D>& coupling, std::size_t mouth, const std::vector<Twist<D>>& twists);

/// u += theta U_w in films and mouths (share 1), or subtracts it (share -1).
template <int D>
void add_entrainment(const Coupling<D>& coupling, const std::vector<Twist<D>>& twists, double share, FluidVelocity<D>& u);

/// Energy that drag and shear dissipate in films and mouths over the step, at the velocities of its end. Collective.
template <int D>
double film_loss(const Coupling<D>& coupling, const std::vector<Twist<D>>& twists, const FluidVelocity<D>& u);

/// Impulse of the films' shear on every solid about its centre; the pressure's entrainment is in impulses(). Collective.
template <int D>
std::vector<Twist<D>> drag_impulses(const Coupling<D>& coupling, const std::vector<Twist<D>>& twists);

} // namespace gapflow
