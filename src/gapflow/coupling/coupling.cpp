#include "gapflow/coupling/coupling.hpp"

#include "gapflow/core/threads.hpp"
#include "gapflow/coupling/film_drag.hpp"
#include "gapflow/coupling/film_rows.hpp"
#include "gapflow/coupling/grid_conductance.hpp"
#include "gapflow/grid/body_flux.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

namespace gapflow {

namespace {

// Relative size below which a contact's row, after constraints, cannot move its body.
constexpr double idle_row = 1e-12;

// Kinds of this rank's cells and their ghosts, the faces open on the grid, and their conductance a |f| / (rho dx).
template <int D>
void fill_grid(Coupling<D>& coupling)
{
    const Grid<D>& grid = *coupling.grid;
    const FilmNetwork<D>& network = coupling.network;
    coupling.open = coupling.fractions->open;
    coupling.kind = CellField<D, std::int8_t>(grid, static_cast<std::int8_t>(CellKind::solid));
    const Index<D> low = grid.low(), high = grid.high();
    const int n = high[0] - low[0];
    for_each_row_on_threads<D>(low, high, [&](const Index<D>& row) {
        std::int8_t* kind = &coupling.kind(row);
        for (int axis = 0; axis < D; ++axis) {
            const double* a = &coupling.open(axis, row);
            const long next = coupling.open[axis].block().stride[axis];
            for (int i = 0; i < n; ++i)
                if (a[i] > 1e-12 || a[i + next] > 1e-12)
                    kind[i] = static_cast<std::int8_t>(CellKind::bulk);
        }
    });
    for (const auto& [key, cell] : network.cells.cells) {
        const Index<D> c = grid.cell_of_key(key);
        if (grid.owns(c) && (cell.kind == CellKind::film || coupling.kind(c) != static_cast<std::int8_t>(CellKind::solid)))
            coupling.kind(c) = static_cast<std::int8_t>(cell.kind);
    }
    exchange(grid, coupling.kind, 1);

    const double unit_conductance = std::pow(grid.dx(), D - 2) / coupling.density;
    auto has_unknown = [&](const Index<D>& c) {
        const auto kind = static_cast<CellKind>(coupling.kind(c));
        return kind == CellKind::bulk || kind == CellKind::mixed;
    };
    if (!network.cells.closed.empty()) {
        Index<D> most = Index<D>::Zero(); // periods
        for (int axis = 0; axis < D; ++axis)
            most[axis] = grid.periodic(axis);
        const auto closed =
            items_of<CellSide<D>>(static_cast<long>(network.cells.cells.size()), [&](long i, std::vector<CellSide<D>>& sides) {
                const Index<D> cell = grid.cell_of_key(network.cells.cells.item(static_cast<int>(i)).first);
                for (const CellSide<D>& side : sides_of(grid, cell))
                    if (side.inside && network.cells.closed.contains(network.faces->key(side.axis, side.face)))
                        sides.push_back(side);
            });
        for (const CellSide<D>& side : closed) {
            // Every place where this rank stores the face (periodic: the same face on both sides).
            for_each_index<D>(-most, most + Index<D>::Ones(), [&](const Index<D>& periods) {
                const Index<D> f = grid.wrapped(side.face) + periods.cwiseProduct(grid.cells());
                if (!coupling.open[side.axis].block().contains(f))
                    return;
                double& open = coupling.open(side.axis, f);
                const bool mine = (f.array() >= low.array()).all() && (f.array() < (high + step<D>(side.axis)).array()).all();
                if (mine && open > 1e-12)
                    coupling.system.film_faces.push_back({side.axis,
                                                          f,
                                                          open * unit_conductance / grid.spread(side.axis, f[side.axis]),
                                                          {has_unknown(f - step<D>(side.axis)), has_unknown(f)}});
                open = 0;
            });
        }
    }
    coupling.system.grid = coupling.grid;
    fill_conductance(coupling);
}

// K in the rows of the grid: J of every body (without walls: they have no flux), then the films' contributions (with walls: sliding
// walls drag fluid).
template <int D>
void fill_flux(Coupling<D>& coupling, const FluxRows<D>& rows)
{
    const Grid<D>& grid = *coupling.grid;
    CoupledSystem<D>& system = coupling.system;
    append_entries<D, Index<D>>(
        static_cast<long>(coupling.fractions->surface_cells.size()),
        [&](long i, FluxEntries<D, Index<D>>& entries) {
            const Index<D>& c = coupling.fractions->surface_cells[i];
            const auto kind = static_cast<CellKind>(coupling.kind(c));
            if (kind == CellKind::bulk || kind == CellKind::mixed)
                for_each_body_flux(grid, *coupling.fractions, c, [&](int solid, const Twist<D>& flux) {
                    if (!coupling.solids[solid].wall)
                        entries.add(coupling, c, solid, flux);
                });
        },
        coupling.cell_flux, system.cell_flux);
    append_rows(coupling, rows, system.node_flux);
    coupling.cell_flux.shrink_to_fit(); // large
    system.cell_flux.shrink_to_fit();
}

// Projects impulses on, or twists of, the free bodies onto those that constraints admit.
template <int D>
void project(const Coupling<D>& coupling, Eigen::VectorXd& all)
{
    constexpr int n = twist_size<D>;
    for (std::size_t s = 0; s < coupling.solids.size(); ++s)
        if (const int b = coupling.free_body[s]; b >= 0)
            all.segment<n>(n * b) = coupling.solids[s].admissible * all.segment<n>(n * b).eval();
}

} // namespace

template <int D>
void add_response(const Coupling<D>& coupling, Eigen::VectorXd V, std::vector<Twist<D>>& twists)
{
    constexpr int n = twist_size<D>;
    project(coupling, V);
    for (std::size_t s = 0; s < twists.size(); ++s)
        if (const int b = coupling.free_body[s]; b >= 0)
            twists[s] += V.segment<n>(n * b);
}

template <int D>
Coupling<D> couple(const Grid<D>& grid, std::vector<Solid<D>> solids, const std::vector<TwistMatrix<D>>& mass,
                   const CouplingOptions& options, const std::function<GapSettings(int, int)>& gap,
                   const std::set<FilmPair<D>>& alive, const std::function<DragTerms(const Coupling<D>&)>& drag,
                   const FaceFractions<D>* before)
{
    Coupling<D> coupling;
    coupling.grid = &grid;
    coupling.density = options.density;
    coupling.solids = std::move(solids);
    StageTimers unused;
    StageTimers& timers = options.timers ? *options.timers : unused;
    {
        const auto timer = timers.measure("fractions");
        coupling.clipper = std::make_shared<FaceClipper<D>>(grid, coupling.solids, options.fractions);
        coupling.fractions = std::make_shared<FaceFractions<D>>(face_fractions(grid, *coupling.clipper, before));
    }
    std::optional<StageTimers::Scope> timer;
    timer.emplace(timers.stage("films"));
    coupling.network = build_film_network<D>(grid, coupling.solids, *coupling.clipper, *coupling.fractions, gap, alive);
    for (const Solid<D>& solid : coupling.solids)
        coupling.free_body.push_back(solid.motion == Motion::free ? coupling.system.bodies++ : -1);
    coupling.system.nodes = coupling.network.nodes;
    if (grid.comm().size() > 1) {
        coupling.system.own_node.assign(coupling.network.nodes, 0);
        for (const Film<D>& film : coupling.network.films)
            std::fill_n(coupling.system.own_node.begin() + film.first_node, film.mesh.h.size(), film.here);
    }

    timer.emplace(timers.stage("system"));
    fill_grid(coupling);
    timer.emplace(timers.stage("films"));
    const DragTerms terms = drag ? drag(coupling) : DragTerms{};
    if (options.viscosity_dt > 0)
        find_drag(coupling, options.viscosity_dt, mass, terms);
    {
        FluxRows<D> rows(coupling.system); // large
        assemble_films(coupling, rows);
        timer.emplace(timers.stage("system"));
        fill_flux(coupling, rows);
    }
    fill_mass(coupling, mass);
    coupling.system.response = BodyResponse(coupling.system.mass, {}, {});
    find_components(coupling);
    coupling.network.faces.reset(); // a cache for this function only
#ifndef NDEBUG
    // Detects cells that the assembly left out. Where bodies overlap, the hidden parts of their surfaces are left out on purpose.
    bool apart = options.fractions == FractionMode::cut_cell && !coupling.network.films.empty();
    for (const Film<D>& film : coupling.network.films)
        for (double h : film.mesh.h)
            apart = apart && h + film.mesh.skin > 1e-8 * grid.dx();
    assert(!apart || closure_defect(coupling) < 1e-9);
#endif
    return coupling;
}

template <int D>
void hold_contacts(Coupling<D>& coupling, const std::vector<HeldContact<D>>& contacts, const std::vector<Twist<D>>& twists)
{
    constexpr int n = twist_size<D>;
    std::vector<Eigen::Triplet<double>> entries;
    const int rows = static_cast<int>(contacts.size());
    const bool held_before = coupling.system.contact.rows() > 0;
    coupling.held_speed.resize(rows);
    coupling.held_impulse.resize(rows);
    coupling.system.contact_resistance.resize(rows);
    for (int r = 0; r < rows; ++r) {
        const HeldContact<D>& contact = contacts[r];
        coupling.held_speed[r] = contact.speed;
        coupling.held_impulse[r] = contact.impulse;
        coupling.system.contact_resistance[r] = contact.resistance;
        auto add = [&](int solid, const Twist<D>& row) {
            const int b = coupling.free_body[solid];
            if (b < 0) {
                coupling.held_speed[r] -= row.dot(twists[solid]);
                return;
            }
            const Twist<D> admissible = coupling.solids[solid].admissible * row;
            if (admissible.norm() > idle_row * row.norm())
                for (int k = 0; k < n; ++k)
                    entries.emplace_back(r, n * b + k, admissible[k]);
        };
        add(contact.a, contact.row_a);
        add(contact.b, contact.row_b);
    }
    coupling.system.contact.resize(rows, n * coupling.system.bodies);
    coupling.system.contact.setFromTriplets(entries.begin(), entries.end());
    if (rows > 0 || held_before)
        coupling.system.response =
            BodyResponse(coupling.system.mass, coupling.system.contact, coupling.system.contact_resistance);
}

template <int D>
std::vector<Twist<D>> intermediate_twists(const Coupling<D>& coupling, const std::vector<TwistMatrix<D>>& mass,
                                          const std::vector<Twist<D>>& twists, const std::vector<double>& film_normal,
                                          Eigen::VectorXd& contact_impulse)
{
    constexpr int n = twist_size<D>;
    std::vector<Twist<D>> result = twists;
    const int dofs = n * coupling.system.bodies;
    if (dofs == 0)
        return result;
    const Communicator& comm = coupling.grid->comm();
    Eigen::VectorXd momentum = Eigen::VectorXd::Zero(dofs); // of each rank's films; on one of them of the bodies too
    for (std::size_t s = 0; s < twists.size(); ++s)
        if (const int b = coupling.free_body[s]; b >= 0 && comm.root())
            momentum.segment<n>(n * b) += mass[s] * twists[s];
    auto add = [&](const NormalInertia<D>& inertia, double speed) {
        const int a = coupling.free_body[inertia.master], b = coupling.free_body[inertia.other];
        if (a < 0)
            speed -= inertia.row_master.dot(twists[inertia.master]);
        if (b < 0)
            speed -= inertia.row_other.dot(twists[inertia.other]);
        if (a >= 0)
            momentum.segment<n>(n * a) += inertia.mass * speed * inertia.row_master;
        if (b >= 0)
            momentum.segment<n>(n * b) += inertia.mass * speed * inertia.row_other;
    };
    auto inertia = coupling.normal_inertia.begin();
    for (const Film<D>& film : coupling.network.films)
        for (std::size_t e = 0; film.here && e < film.mesh.elements.size(); ++e)
            add(*inertia++, film_normal[film.first_element + e]);
    for (const DragInertia<D>& drag : coupling.drag_inertia)
        add(drag.inertia, drag.speed);
    comm.sum(std::span<double>(momentum.data(), momentum.size()));
    for (std::size_t s = 0; s < twists.size(); ++s)
        if (coupling.free_body[s] >= 0)
            result[s].setZero();
    project(coupling, momentum);
    const bool held = coupling.held_impulse.size() > 0;
    if (held)
        momentum += coupling.system.contact.transpose() * coupling.held_impulse;
    add_response(coupling, coupling.system.response(momentum, coupling.held_speed, &contact_impulse), result);
    if (held)
        contact_impulse += coupling.held_impulse;
    return result;
}

template <int D>
void add_pressure_impulse(const Coupling<D>& coupling, const UnknownVector<D>& p, std::vector<Twist<D>>& twists,
                          Eigen::VectorXd& contact_impulse)
{
    constexpr int n = twist_size<D>;
    const int dofs = n * coupling.system.bodies;
    if (dofs == 0)
        return;
    Eigen::VectorXd all = Eigen::VectorXd::Zero(dofs);
    const Communicator& comm = coupling.grid->comm();
    if (comm.any(!coupling.gauge_cells.empty() || !coupling.gauge_nodes.empty())) {
        for (const auto& entry : coupling.system.cell_flux)
            all.segment<n>(n * entry.body) += p.cells(entry.row) * entry.flux;
        for (const auto& entry : coupling.system.node_flux)
            all.segment<n>(n * entry.body) += p.nodes[entry.row] * entry.flux;
        comm.sum(std::span<double>(all.data(), all.size()));
    } else {
        const std::vector<Twist<D>> impulse = impulses(coupling, p);
        for (std::size_t s = 0; s < twists.size(); ++s)
            if (const int b = coupling.free_body[s]; b >= 0)
                all.segment<n>(n * b) = impulse[s];
    }
    project(coupling, all);
    Eigen::VectorXd held;
    add_response(coupling, coupling.system.response(all, &held), twists);
    contact_impulse += held;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template Coupling<D> couple<D>(const Grid<D>&, std::vector<Solid<D>>, const std::vector<TwistMatrix<D>>&,                  \
                                   const CouplingOptions&, const std::function<GapSettings(int, int)>&,                        \
                                   const std::set<FilmPair<D>>&, const std::function<DragTerms(const Coupling<D>&)>&,          \
                                   const FaceFractions<D>*);                                                                   \
    template void hold_contacts<D>(Coupling<D>&, const std::vector<HeldContact<D>>&, const std::vector<Twist<D>>&);            \
    template std::vector<Twist<D>> intermediate_twists<D>(const Coupling<D>&, const std::vector<TwistMatrix<D>>&,              \
                                                          const std::vector<Twist<D>>&, const std::vector<double>&,            \
                                                          Eigen::VectorXd&);                                                   \
    template void add_response<D>(const Coupling<D>&, Eigen::VectorXd, std::vector<Twist<D>>&);                                \
    template void add_pressure_impulse<D>(const Coupling<D>&, const UnknownVector<D>&, std::vector<Twist<D>>&,                 \
                                          Eigen::VectorXd&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
