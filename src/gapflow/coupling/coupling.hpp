// Grid, films and bodies of one configuration joined into the coupled system (method, "Rows of the film", "The coupled system"), and the discrete
// operators of a projection: outflow D u*, body flux K V, gradient.
#pragma once

#include "gapflow/core/timer.hpp"
#include "gapflow/coupling/system.hpp"
#include "gapflow/film/mouth_cells.hpp"
#include "gapflow/film/mouths.hpp"
#include "gapflow/grid/face_fractions.hpp"

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace gapflow {

/// Velocities of the fluid at the places where they are defined.
template <int D>
struct FluidVelocity {
    FaceField<D> grid; ///< normal component, mean over the open part of a face; traces use it as the value at the face centre
    std::vector<Vec<D>> film;        ///< tangential velocity of every film element, absolute, world axes
    std::vector<double> film_normal; ///< normal speed of the fluid of every film element (method: w_n*)
    std::vector<double> mouth;       ///< flux out of the film through every mouth, absolute
};

/// The film's fluid moves with the mean of its two walls normal to the gap: a mass (rho S) on the rows of their twists that
/// normal_rows gives.
template <int D>
struct NormalInertia {
    int master, other; ///< solids
    Twist<D> row_master, row_other;
    double mass;
};

/// Viscous drag on a film's element or mouth over a step (method, "Films of viscous fluid"): u = kappa (u* - grad p / rho) + theta U_w, with the
/// mean U_w of the two walls' velocities along the film; kappa + theta = 1.
struct Drag {
    double kappa = 1, theta = 0;
    double wet = 1; ///< share of the gap that contains fluid; the rest is a void
};

/// Share of the gap's thickness that contains fluid, of every film element and mouth; empty: all of it.
struct WetShares {
    std::vector<double> elements, mouths;
};

/// What makes up drag over a step in which the gap changes: its mean over the way, times the first, and its value at the end, times the
/// second (film_way.hpp).
struct DragParts {
    double mean = 0, end = 1;
};

/// How much the gap at every film element and mouth has opened over the step (negative: closed), where drag asks for it; 0 elsewhere, empty:
/// nowhere.
struct GapChanges {
    std::vector<double> elements, mouths;
    std::vector<DragParts> drag; ///< of each film
};

/// What the films' drag depends on beside their meshes.
struct DragTerms {
    WetShares wet;
    GapChanges changes;
};

/// Contribution of drag to the bodies' mass: 1/2 mass (row_master . V + row_other . V - speed)^2.
template <int D>
struct DragInertia {
    NormalInertia<D> inertia;
    int element = -1, mouth = -1; ///< whose u* gives the speed; neither: 0
    Vec<D> direction = Vec<D>::Zero();
    double speed = 0;
};

/// Bounds what the mass of the gaps between two solids takes from each.
template <int D>
struct GapDeficit {
    int a, b;
    TwistMatrix<D> of_a, of_b;
};

/// Enclosed fluid without a way out.
struct SealedPocket {
    long cells = 0;                  ///< of the grid
    long nodes = 0;                  ///< of films
    std::vector<std::string> bodies; ///< that bound it; of a pocket of films alone also walls
    std::vector<double> at;          ///< a point of it
};

template <int D>
struct Coupling {
    const Grid<D>* grid = nullptr;
    double density = 1;
    std::vector<Solid<D>> solids;
    FaceField<D> open;              ///< open fraction of every face on the grid, after films closed theirs
    CellField<D, std::int8_t> kind; ///< CellKind
    FilmNetwork<D> network;
    std::shared_ptr<const FaceFractions<D>> fractions; ///< before closing
    std::shared_ptr<const FaceClipper<D>> clipper;     ///< finds the solids near a point

    CoupledSystem<D> system;    ///< the free bodies' part, with rows K_b P_b and masses P M P + m (1 - P) (Solid::admissible)
    std::vector<int> free_body; ///< number of each solid among the free bodies, -1: none
    /// K of all solids but walls, in this rank's cells and own nodes; `body` is the solid. The system contains the free bodies' share of it.
    std::vector<BodyFlux<D, Index<D>>> cell_flux;
    std::vector<BodyFlux<D, int>> node_flux;
    /// Y of the gauge in which system.cell_flux, node_flux and mass stand (pressure_gauge.hpp); `body` as in the system. Empty: p is the pressure.
    std::vector<BodyFlux<D, Index<D>>> gauge_cells;
    std::vector<BodyFlux<D, int>> gauge_nodes;
    std::vector<int> part_node;                   ///< of each part of the complex: its node, -1 if it has none; films: none
    std::vector<NormalInertia<D>> normal_inertia; ///< one for each element of this rank's films, in their order
    std::vector<TwistMatrix<D>> seen_mass;        ///< D of each solid (pressure_gauge.hpp); films: none
    std::vector<TwistMatrix<D>>
        gap_deficit; ///< bounds, for each solid, what the masses of its gaps with others take from it; films: none
    std::vector<GapDeficit<D>> gap_deficits;    ///< the same, of each two solids
    std::vector<Drag> element_drag, mouth_drag; ///< one for each film element or mouth; empty without viscosity
    std::vector<std::vector<CarriedCell>>
        cells_behind; ///< of each mouth: the cells that the walls' flux enters; empty: those of its pressure
    std::vector<DragInertia<D>> drag_inertia; ///< of this rank's films
    Eigen::VectorXd held_speed;               ///< of the contacts in system.contact, less the share of solids that are not free
    Eigen::VectorXd held_impulse;             ///< expected of them
    std::vector<SealedPocket> sealed;         ///< components that touch no open side, but the first (largest) one
};

struct CouplingOptions {
    double density = 1;
    FractionMode fractions = FractionMode::cut_cell;
    StageTimers* timers = nullptr; ///< receives the time of the stages, if not null
    double viscosity_dt = 0;       ///< dynamic viscosity times the step's length
};

/// Builds everything for one configuration. `mass` holds the generalised mass of each solid (used for free ones). `drag` is called
/// once, after the films are built and before assembly. `before`: fractions of the configuration before (face_fractions()). Collective.
template <int D>
Coupling<D> couple(const Grid<D>& grid, std::vector<Solid<D>> solids, const std::vector<TwistMatrix<D>>& mass,
                   const CouplingOptions& options, const std::function<GapSettings(int, int)>& gap,
                   const std::set<FilmPair<D>>& alive, const std::function<DragTerms(const Coupling<D>&)>& drag = {},
                   const FaceFractions<D>* before = nullptr);

/// out = D u + K V of every unknown: the outflow from its volume when the fluid moves with u and the solids with their
/// twists. `sum_of_squares` (if not null) receives the sum over rows of the squares of the terms' magnitudes. Collective.
template <int D>
void outflow(const Coupling<D>& coupling, const FluidVelocity<D>& u, const std::vector<Twist<D>>& twists, UnknownVector<D>& out,
             double* sum_of_squares = nullptr);

/// u -= grad p / rho on open faces, films and mouths.
template <int D>
void subtract_gradient(const Coupling<D>& coupling, UnknownVector<D>& p, FluidVelocity<D>& u);

/// The same of films and mouths alone. Collective.
template <int D>
void subtract_film_gradient(const Coupling<D>& coupling, const UnknownVector<D>& p, std::vector<Vec<D>>& film_velocity,
                            std::vector<double>& mouth_flux);

/// K^T p of all solids but walls: the fluid's impulse on each, about its centre, before constraints. Collective.
template <int D>
std::vector<Twist<D>> impulses(const Coupling<D>& coupling, const UnknownVector<D>& p);

/// Sum of K over all unknowns, one column for each solid but walls: zero for every body wholly inside the domain. Collective.
template <int D>
std::vector<Twist<D>> closure(const Coupling<D>& coupling);

/// Largest component of the force part of closure() over dx^(D-1), over bodies wholly inside the domain. Collective.
template <int D>
double closure_defect(const Coupling<D>& coupling);

/// A contact that holds: row_a . V_a + row_b . V_b = speed.
template <int D>
struct HeldContact {
    int a, b; ///< solids
    Twist<D> row_a, row_b;
    double speed;
    double resistance = std::numeric_limits<double>::infinity(); ///< impulse over the remaining speed
    double impulse = 0; ///< expected: redundant contacts share theirs as close to it as can be
};

/// Replaces the contacts that hold the free bodies; `twists`: those of the other solids. From then on M^-1 is
/// BodyResponse(mass, contact, resistance) everywhere.
template <int D>
void hold_contacts(Coupling<D>& coupling, const std::vector<HeldContact<D>>& contacts, const std::vector<Twist<D>>& twists);

/// Twists of the free bodies before the solve: V* = M^-1 (M_body V_body + sum rho S N^T (w_n* - N V_prescribed)), admissible
/// and with held contacts at their speeds; others as given. `contact_impulse` becomes that of the held contacts. Collective.
template <int D>
std::vector<Twist<D>> intermediate_twists(const Coupling<D>& coupling, const std::vector<TwistMatrix<D>>& mass,
                                          const std::vector<Twist<D>>& twists, const std::vector<double>& film_normal,
                                          Eigen::VectorXd& contact_impulse);

/// Adds the response V of the free bodies, twist by twist in the system's order, to the twists of all solids.
template <int D>
void add_response(const Coupling<D>& coupling, Eigen::VectorXd V, std::vector<Twist<D>>& twists);

/// Adds M^-1 K^T p to the twists of the free bodies, and its contribution to the held contacts' impulses. Collective.
template <int D>
void add_pressure_impulse(const Coupling<D>& coupling, const UnknownVector<D>& p, std::vector<Twist<D>>& twists,
                          Eigen::VectorXd& contact_impulse);

/// Connected components of the unknowns, their null space and the sealed pockets; fills coupling.system and
/// coupling.sealed. Collective.
template <int D>
void find_components(Coupling<D>& coupling);

/// The null space of the components as they are: grounded or not. Fills coupling.system.null_space. Collective.
template <int D>
void find_null_space(Coupling<D>& coupling);

} // namespace gapflow
