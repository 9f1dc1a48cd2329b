#include "gapflow/stepping/projection.hpp"

#include "gapflow/body/forces.hpp"
#include "gapflow/core/error.hpp"
#include "gapflow/coupling/film_drag.hpp"
#include "gapflow/coupling/fluid_parts.hpp"
#include "gapflow/coupling/pressure_gauge.hpp"
#include "gapflow/solver/vectors.hpp"
#include "gapflow/stepping/flooding.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace gapflow {

namespace {

constexpr double round_off = 1e-13; // of a sum, of the largest of what cancels in it

// A pocket squeezed by a prescribed body has no solution: the error names it. `magnitude`: of the right-hand side's parts.
template <int D>
void check_compatibility(const Coupling<D>& coupling, const UnknownVector<D>& rhs, double magnitude, long step)
{
    const CoupledSystem<D>& system = coupling.system;
    const Grid<D>& grid = *coupling.grid;
    const int count = static_cast<int>(system.components.size());
    std::vector<double> sums(count, 0.0);
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
        if (system.component(c) >= 0)
            sums[system.component(c)] += rhs.cells(c);
    });
    grid.comm().sum(sums);
    for (int node = 0; node < system.nodes; ++node)
        sums[system.node_component[node]] += rhs.nodes[node];
    for (long j = 0; j < system.null_space.cols(); ++j) {
        double defect = 0;
        for (int k = 0; k < count; ++k)
            defect += system.null_space(k, j) * sums[k];
        if (std::abs(defect) <= 1e-6 * magnitude)
            continue;
        std::string where = "the fluid of the closed domain";
        for (const SealedPocket& pocket : coupling.sealed) {
            where = "fluid sealed in between";
            for (const std::string& name : pocket.bodies)
                where += " " + name;
            where += " (" + std::to_string(pocket.cells) + " cells)";
        }
        throw ComputationError("step " + std::to_string(step) + ": prescribed motion or inflow changes the volume of " + where +
                               ", and incompressible fluid has no way out; open a side or correct the motion");
    }
}

// Contacts may leave enclosed fluid no motion of the bodies that changes its volume (two gears that touch between two walls): the system has no solution then, and
// the fluid decides which of them hold. They give way there, with the bodies' own resistance, 1 / (c M^-1 c^T), about what is expected of them: from round to round
// that comes to what they can bear.
template <int D>
void hold(Coupling<D>& coupling, const ContactSet<D>& contacts, const std::vector<TwistMatrix<D>>& masses,
          const std::vector<Twist<D>>& forced)
{
    std::vector<HeldContact<D>> held = contacts.held();
    hold_contacts(coupling, held, forced);
    if (held.empty() || coupling.system.components.size() < 2 || !contacts_lock_fluid(coupling))
        return;
    for (HeldContact<D>& contact : held) {
        double mobility = 0;
        for (const auto& [solid, along] : {std::pair(contact.a, contact.row_a), std::pair(contact.b, contact.row_b)})
            if (coupling.free_body[solid] >= 0)
                mobility +=
                    (coupling.solids[solid].admissible * along).cwiseAbs2().dot(masses[solid].diagonal().cwiseInverse());
        if (mobility > 0)
            contact.resistance = std::min(contact.resistance, 1 / mobility);
    }
    hold_contacts(coupling, held, forced);
}

/// Sum of the squares of what the walls' motion by a - b drives out of each row. Collective.
template <int D>
double squares_of_flux(const Coupling<D>& coupling, const std::vector<Twist<D>>& a, const std::vector<Twist<D>>& b)
{
    double sum = 0;
    const auto add = [&](const auto& entry) {
        const double flux = entry.flux.dot(a[entry.body] - b[entry.body]);
        sum += flux * flux;
    };
    for (const auto& entry : coupling.cell_flux)
        if (coupling.grid->owns(entry.row))
            add(entry);
    for (const auto& entry : coupling.node_flux)
        if (coupling.system.owns(entry.row))
            add(entry);
    return coupling.grid->comm().sum(sum);
}

} // namespace

template <int D>
Projection<D>::Projection(const ProjectionStart<D>& start, FluidVelocity<D>& velocity, UnknownVector<D>& impulse,
                          const SolverOptions& options, StageTimers& stages)
    : start_(start), velocity_(velocity), impulse_(impulse), options_(options), stages_(stages), open_flux_(velocity.mouth)
{
    impulse_.cells.fill(
        0); // an initial guess would carry solver errors from step to step: symmetric scenes would lose their symmetry
    impulse_.nodes.setZero(start_.coupling.system.nodes);
    if (start_.voids)
        wet_.emplace(start_.coupling);
}

template <int D>
void Projection<D>::assemble(bool voids_changed, bool links_changed)
{
    Coupling<D>& coupling = start_.coupling;
    std::vector<Twist<D>> with_friction = start_.forced;
    if (start_.contacts) {
        hold(coupling, *start_.contacts, start_.masses, start_.forced);
        const std::vector<Twist<D>> sliding = start_.contacts->sliding_impulses(coupling.solids.size());
        for (std::size_t b = 0; b < start_.bodies.size(); ++b)
            if (start_.bodies[b].motion == Motion::free)
                with_friction[b] += impulse_response(start_.bodies[b], sliding[b], start_.dt);
    }
    without_pressure_ = intermediate_twists(coupling, start_.masses, with_friction, velocity_.film_normal, held_impulse_);
    if (voids_changed) {
        hold_voids();
        solver_.reset();
    }
    if (links_changed)
        solver_.reset();
    if (wet_)
        wet_->add_void_impulse(without_pressure_, held_impulse_);
    outflow(coupling, velocity_, without_pressure_, rhs_, &squares_);
    if (const UnknownVector<D>& beside = start_.beside; beside.cells.size() > 0) {
        for (long i = 0; i < rhs_.cells.size(); ++i)
            rhs_.cells.data()[i] += beside.cells.data()[i];
        rhs_.nodes += beside.nodes;
        squares_ += dot(*coupling.grid, beside, beside);
    }
    held_squares_ = start_.contacts ? squares_of_flux<D>(coupling, start_.forced, without_pressure_) : 0.0;
    enter_gauge(coupling, without_pressure_, rhs_);
    for (long i = 0; i < rhs_.cells.size(); ++i)
        rhs_.cells.data()[i] *= -1;
    rhs_.nodes *= -1;
    if (wet_)
        wet_->reduce(without_pressure_, start_.voids->filling(start_.dt), rhs_);
    check_compatibility(coupling, rhs_, std::sqrt(squares_), start_.step);
    if (solver_) {
        solver_->update_bodies();
        return;
    }
    solver_.emplace(coupling.system, options_);
    stages_.add("solver set-up", solver_->setup_seconds());
    solver_seconds_ += solver_->setup_seconds();
}

template <int D>
SolveReport Projection<D>::solve(double tolerance)
{
    // Of what contacts have taken away, round-off is left, which need not be solved for.
    const double least = round_off * std::max(std::sqrt(squares_), std::sqrt(held_squares_) / tolerance);
    SolveReport report = solver_->solve(impulse_, rhs_, least, tolerance);
    stages_.add("solve", report.seconds);
    solver_seconds_ += report.seconds;
    if (!report.converged)
        return report;
    twists_ = without_pressure_;
    contact_impulse_ = held_impulse_;
    const std::optional<BodyMotion>& motion = solver_->motion();
    if (!motion) {
        add_pressure_impulse(start_.coupling, impulse_, twists_, contact_impulse_);
    } else if (start_.coupling.system.bodies > 0) {
        add_response(start_.coupling, motion->twist, twists_);
        contact_impulse_ += motion->contact_impulse;
    }
    return report;
}

template <int D>
ContactChange Projection<D>::update_contacts(const NearInertia<D>& inertia, double tolerance, const Rounds& rounds)
{
    return start_.contacts ? start_.contacts->update(twists_, contact_impulse_, inertia, rounds.accuracy(tolerance),
                                                     rounds.exact(), rounds.number())
                           : ContactChange::none;
}

// Removes the voids of the active set and shut mouths from the system: the flux of shut mouths, also with their masters, is 0.
template <int D>
void Projection<D>::hold_voids()
{
    const VoidSet<D>& voids = *start_.voids;
    wet_->take_out(voids.is_void(), voids.impulses(start_.dt), voids.shut());
    for (std::size_t r = 0; r < open_flux_.size(); ++r)
        velocity_.mouth[r] = voids.shut()[r] ? 0.0 : open_flux_[r];
    for (int node = 0; node < start_.coupling.network.nodes; ++node)
        if (voids.is_void()[node])
            impulse_.nodes[node] = 0;
}

template <int D>
bool Projection<D>::update_voids(double tolerance, const Rounds& rounds, bool contacts_changed)
{
    if (!start_.voids)
        return false;
    VoidSet<D>& voids = *start_.voids;
    const double accuracy = Rounds::accuracy_over_tolerance * tolerance;
    auto [outflow, drop] = wet_->outcome(impulse_, twists_);
    node_outflow_ = outflow;
    const bool at_once = rounds.voids_at_once();
    if (rounds.last() || (contacts_changed && !at_once))
        return false;
    const bool nodes = voids.update(impulse_.nodes + wet_->given(), outflow, start_.dt, accuracy, at_once);
    if (nodes && !at_once)
        return true;
    const std::vector<Mouth<D>>& mouths = start_.coupling.network.rim.mouths;
    std::vector<double> flux; // seen from the masters
    for (std::size_t r = 0; r < mouths.size(); ++r)
        flux.push_back(velocity_.mouth[r] + wet_->conductance(r) * drop[r] +
                       (voids.shut()[r] ? 0.0
                                        : entrained_flux(start_.coupling, r, twists_) -
                                              carried_flux<D>(start_.coupling, mouths[r], twists_)));
    for (std::size_t r = 0; r < mouths.size(); ++r)
        drop[r] -= start_.dt * start_.beyond_mouths[r];
    return voids.update_mouths(mouths, flux, drop, accuracy, at_once) || nodes;
}

template <int D>
void Projection<D>::finish_voids()
{
    if (!wet_)
        return;
    impulse_.nodes += wet_->given();
    wet_.reset();
    start_.voids->finish(start_.coupling, impulse_.nodes, node_outflow_, start_.dt);
}

template class Projection<2>;
template class Projection<3>;

} // namespace gapflow
