#include "gapflow/stepping/unilateral.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/coupling/film_drag.hpp"
#include "gapflow/stepping/motion.hpp"
#include "gapflow/stepping/projection.hpp"
#include "gapflow/stepping/sealing.hpp"
#include "gapflow/stepping/side_pressure.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace gapflow {

namespace {

// Added mass of a body in the forecast of contacts, over the mass of the displaced fluid. Fitted, for crowds of bodies.
constexpr double bulk_share = 2;
constexpr int few_iterations =
    12; // of a solve without a correction for bodies: below, the next one does not estimate their lightness

// Approximate inertia for the forecast of contacts: bodies with added mass of the bulk, and the films near contacts.
template <int D>
NearInertia<D> inertia_of_contacts(const Model<D>& model, const Coupling<D>& there, const State<D>& state,
                                   std::vector<TwistMatrix<D>> mass)
{
    for (std::size_t b = 0; b < state.bodies.size(); ++b)
        mass[b] *= 1 + bulk_share * model.scene.density * std::abs(state.bodies[b].volume) / state.bodies[b].mass;
    return near_inertia(there, mass, state.voids.is_void());
}

// Fluid enclosed by surfaces in contact whose volume would change.
template <int D>
void check_pockets(const Model<D>& model, const Coupling<D>& there, const State<D>& state, const FluidVelocity<D>& u,
                   const std::vector<Twist<D>>& V, const Step& step)
{
    const std::string squeezed = squeezed_pocket<D>(there, model.gaps, state.contacts.contacts(), V, u, GivesWay::unblocked);
    if (!squeezed.empty())
        throw ComputationError("step " + std::to_string(step.number) + ": " + squeezed);
}

// Contacts between bodies that are driven into each other and cannot give way.
template <int D>
void check_crushing(const Coupling<D>& there, const ContactSet<D>& contacts, const std::vector<Twist<D>>& V, const Step& step,
                    StepReport& report)
{
    const Contact<D>* c = contacts.crushed(V, step.dt);
    if (!c)
        return;
    const std::string pair = "'" + there.solids[c->point.a].name + "' and '" + there.solids[c->point.b].name + "'";
    if (contacts.driven(*c, there.solids, V))
        throw ComputationError("prescribed motion drives " + pair + " into each other in step " + std::to_string(step.number) +
                               ", and neither can give way; let it stop before they touch");
    report.notes.push_back("contacts ask for more than the bodies can do: " + pair +
                           " overlap, and are pushed apart again"); // nothing drives them
}

// Pairs with films that rebound in the step.
template <int D>
std::set<FilmPair<D>> rebounding_pairs(const Coupling<D>& there, const ContactSet<D>& contacts)
{
    std::set<FilmPair<D>> pairs;
    for (const Film<D>& film : there.network.films)
        if (contacts.rebounds(film.pair.master, film.pair.other))
            pairs.insert(film.pair);
    return pairs;
}

// Rebounds that would ask more energy of the films than they and the two bodies had are held back: a box that falls flat keeps its film's inertia, which
// grows without bound in one step (contact_cases, random scene 79). False if there are none.
template <int D>
bool hold_back(const Model<D>& model, const Coupling<D>& there, const std::vector<RigidBody<D>>& bodies,
               const Projected<D>& end, ContactSet<D>& contacts)
{
    const std::set<FilmPair<D>> pairs = rebounding_pairs(there, contacts);
    if (pairs.empty() || end.account.reference.empty())
        return false;
    std::vector<Vec<D>> velocity = end.velocity.film;
    std::vector<double> mouth = end.velocity.mouth;
    subtract_film_gradient(there, end.impulse, velocity, mouth);
    FilmDebts<D> before = energy_in_place(there.network, end.account),
                 after = film_energy(there.network, end.account, velocity, mouth);
    const auto moving = [&](int solid) {
        const bool body = solid < static_cast<int>(bodies.size());
        return body && bodies[solid].motion == Motion::free ? kinetic_energy(bodies[solid]) : 0.0;
    };
    bool any = false;
    for (const FilmPair<D>& pair : pairs)
        if (model.scene.density * (after[pair] - before[pair]) > moving(pair.master) + moving(pair.other)) {
            contacts.hold_back(pair.master, pair.other);
            any = true;
        }
    return any;
}

// u* of films without transport where that gives them energy: where their velocities turn out so different from those expected, and where their bodies rebound.
// These carry the fluid on in the first part of the step and back in the second, and heads that act against the flow of the step's end would be inertia that
// the rebound does work on. `film`, `mouth`: u* before drag and without the pressure beyond mouths. False if there are none.
template <int D>
bool take_back(const Model<D>& model, Coupling<D>& there, std::vector<Vec<D>> film, std::vector<double> mouth,
               const std::vector<double>& beyond_mouths, double dt, Projected<D>& end)
{
    if (end.account.planned.empty())
        return false;
    std::set<FilmPair<D>> pairs;
    if (!model.viscous()) {
        std::vector<Vec<D>> velocity = end.velocity.film;
        std::vector<double> flux = end.velocity.mouth;
        subtract_film_gradient(there, end.impulse, velocity, flux);
        pairs = mispredicted_films(there.network, end.account, velocity, flux);
    }
    for (const FilmPair<D>& pair : end.account.rebounding)
        if (end.account.planned.contains(pair))
            pairs.insert(pair);
    if (pairs.empty())
        return false;
    std::vector<double> factor;
    take_back_transport(there.network, pairs, end.account, film, mouth, factor);
    end.velocity.film = std::move(film);
    end.velocity.mouth = std::move(mouth);
    start_drag(there, end.velocity);
    for (std::size_t r = 0; r < factor.size(); ++r) {
        there.system.links[r].conductance *= factor[r];
        end.velocity.mouth[r] -= there.system.links[r].conductance * dt * beyond_mouths[r];
    }
    return true;
}

SolverOptions solver_options(const Scene& scene, bool ask_lightness)
{
    SolverOptions options;
    options.tolerance = scene.tolerance;
    options.backend = scene.backend == Scene::Backend::petsc ? Backend::petsc : Backend::multigrid;
    options.ask_lightness = ask_lightness;
    return options;
}

} // namespace

template <int D>
Projected<D> project(const Model<D>& model, Coupling<D>& there, Intermediate<D> star, const std::vector<TwistMatrix<D>>& mass,
                     const Step& step, State<D>& state, StepReport& report, StageTimers& timers)
{
    const Stopwatch watch;
    for (std::size_t r = 0; r < star.mouth_factor.size(); ++r)
        there.system.links[r].conductance *= star.mouth_factor[r];
    const std::vector<Vec<D>> film_star = star.velocity.film;
    const std::vector<double> mouth_star = star.velocity.mouth;
    if (step.dt > 0)
        start_drag(there, star.velocity);
    const std::vector<double> beyond_mouths = pressure_beyond_mouths(model, there.network.rim.mouths, step.end());
    for (std::size_t r = 0; r < beyond_mouths.size(); ++r)
        star.velocity.mouth[r] -= there.system.links[r].conductance * step.dt * beyond_mouths[r];
    Projected<D> end{std::move(star.velocity), std::move(state.pressure.impulse), {}, std::move(star.film_account), {}};
    ContactSet<D>* contacts = step.dt > 0 && !state.contacts.empty() ? &state.contacts : nullptr;
    VoidSet<D>* voids = step.dt > 0 && state.voids.any() ? &state.voids : nullptr;
    NearInertia<D> inertia;
    const std::vector<Twist<D>> expected = predicted_twists(model, state.bodies, step);
    if (contacts) {
        contacts->prepare(model.twists(state.bodies), star.forced.empty() ? star.twists : star.forced, expected, step.dt,
                          step.last_dt);
        inertia = inertia_of_contacts(model, there, state, mass);
    }
    if (voids)
        end.was_empty = voids->empty_elements(there.network);
    const SolverOptions options = solver_options(model.scene, state.light_bodies);
    Projection<D> projection(
        {there, state.bodies, mass, star.twists, contacts, voids, beyond_mouths, star.outflow, step.dt, step.number},
        end.velocity, end.impulse, options, timers);
    bool links_changed = false;
    std::optional<Rounds> all_rounds;
    const auto settle = [&] {
        state.contacts.forget_rounds();
        Rounds& rounds = all_rounds.emplace(contacts, voids, !voids && !(contacts && contacts->likely_to_change(expected)));
        ContactChange change;
        bool new_voids;
        do {
            if (rounds.changed())
                projection.assemble(rounds.voids_changed(), std::exchange(links_changed, false));
            const double tolerance = rounds.tolerance(options.tolerance, projection.holds());
            const SolveReport solve = projection.solve(tolerance);
            report.iterations += solve.iterations;
            ++report.solves;
            report.residual = solve.residual;
            state.light_bodies = projection.corrects_bodies() || solve.iterations > few_iterations;
            if (!solve.converged && step.dt > 0 && !voids && !model.scene.parts)
                check_pockets(model, there, state, end.velocity, projection.without_pressure(), step);
            if (!solve.converged)
                throw ComputationError("the pressure solve of step " + std::to_string(step.number) +
                                       " did not converge: " + solve.message + " (" + std::to_string(solve.iterations) +
                                       " iterations, relative residual " + std::to_string(solve.residual) + ")");
            change = projection.update_contacts(inertia, tolerance, rounds);
            new_voids = projection.update_voids(tolerance, rounds, change != ContactChange::none);
            if (new_voids)
                state.contacts.forget_rounds();
        } while (rounds.go_on(change, new_voids));
    };
    settle();
    if (contacts && hold_back(model, there, state.bodies, end, *contacts))
        settle();
    if (contacts)
        end.account.rebounding = rebounding_pairs(there, *contacts);
    if (step.dt > 0 && !voids && take_back(model, there, film_star, mouth_star, beyond_mouths, step.dt, end)) {
        links_changed = true;
        settle();
    }
    if (all_rounds->unsettled())
        report.notes.push_back(std::string(voids ? "contacts and voids" : "contacts") + " did not settle within " +
                               std::to_string(Rounds::most_rounds) + " rounds of a step");
    end.twists = projection.twists();
    if (step.dt > 0 && !voids && !model.scene.parts)
        check_pockets(model, there, state, end.velocity, projection.without_pressure(), step);
    if (contacts)
        check_crushing(there, *contacts, end.twists, step, report);
    projection.finish_voids();
    state.node_outflow = projection.node_outflow();
    timers.add("projection", watch.seconds() - projection.solver_seconds());
    return end;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template Projected<D> project<D>(const Model<D>&, Coupling<D>&, Intermediate<D>, const std::vector<TwistMatrix<D>>&,       \
                                     const Step&, State<D>&, StepReport&, StageTimers&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
