#include "gapflow/stepping/added_mass.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/solver/solver.hpp"
#include "gapflow/stepping/core_requirement.hpp"
#include "gapflow/stepping/gap_notes.hpp"
#include "gapflow/stepping/model.hpp"
#include "gapflow/stepping/thickness_check.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {

namespace {

// The master of a film is chosen by how its bodies move in the scene; with all twists given no body is an unknown.
template <int D>
Coupling<D> coupling_of_given_twists(const Model<D>& model)
{
    Coupling<D> c = model.coupled(model.bodies);
    c.system.bodies = 0;
    std::fill(c.free_body.begin(), c.free_body.end(), -1);
    c.system.cell_flux.clear();
    c.system.node_flux.clear();
    c.system.mass.resize(0, 0);
    find_components(c);
    return c;
}

template <int D>
struct Response {
    std::vector<Twist<D>> impulse; // that accelerates the fluid from rest, of every solid
    SolveReport solve;
};

// Impulses that give the solids these twists.
template <int D>
Response<D> response(const Coupling<D>& coupling, const CoupledSolver<D>& solver, const std::vector<Twist<D>>& twists)
{
    const Grid<D>& grid = *coupling.grid;
    const FluidVelocity<D> still{FaceField<D>(grid), std::vector<Vec<D>>(coupling.network.elements, Vec<D>::Zero()),
                                 std::vector<double>(coupling.network.elements, 0.0),
                                 std::vector<double>(coupling.network.rim.mouths.size(), 0.0)};
    UnknownVector<D> rhs;
    double squares = 0;
    outflow(coupling, still, twists, rhs, &squares);
    for (long i = 0; i < rhs.cells.size(); ++i)
        rhs.cells.data()[i] *= -1;
    rhs.nodes *= -1;
    UnknownVector<D> p{CellField<D>(grid), Eigen::VectorXd::Zero(coupling.system.nodes)};
    const SolveReport solve = solver.solve(p, rhs, 1e-13 * std::sqrt(squares));
    std::vector<Twist<D>> impulse = impulses(coupling, p);
    for (Twist<D>& one : impulse)
        one = -one;
    if (!grid.comm().root()) // each rank adds its films' part
        std::fill(impulse.begin(), impulse.end(), Twist<D>::Zero());
    for (const NormalInertia<D>& inertia : coupling.normal_inertia) {
        const double speed = inertia.row_master.dot(twists[inertia.master]) + inertia.row_other.dot(twists[inertia.other]);
        if (speed == 0)
            continue;
        impulse[inertia.master] += inertia.mass * speed * inertia.row_master;
        impulse[inertia.other] += inertia.mass * speed * inertia.row_other;
    }
    for (std::size_t s = 0; s < coupling.seen_mass.size() && grid.comm().root(); ++s)
        impulse[s] += coupling.seen_mass[s] * twists[s];
    grid.comm().sum(std::span<double>(impulse.data()->data(), impulse.size() * twist_size<D>));
    return {std::move(impulse), solve};
}

template <int D>
AddedMass added_mass_in(const Scene& scene, const Communicator& comm)
{
    constexpr int n = twist_size<D>;
    const Stopwatch watch;
    const Model<D> model(scene, comm, Task::added_mass);
    AddedMass result;
    result.warnings = thickness_warnings<D>(scene, model.bodies, model.walls, scene.thin);
    const Coupling<D> coupling = coupling_of_given_twists(model);
    require_core(model, coupling, model.bodies);
    const std::vector<Solid<D>>& solids = coupling.solids;
    std::vector<int> moving;
    for (std::size_t s = 0; s < model.bodies.size(); ++s)
        if (solids[s].motion != Motion::fixed)
            moving.push_back(static_cast<int>(s));

    SolverOptions options;
    options.tolerance = std::min(scene.tolerance, 1e-8);
    options.backend = scene.backend == Scene::Backend::petsc ? Backend::petsc : Backend::multigrid;
    const CoupledSolver<D> solver(coupling.system, options);

    static const std::array<const char*, 3> names2{"vx", "vy", "omega"};
    static const std::array<const char*, 6> names3{"vx", "vy", "vz", "wx", "wy", "wz"};
    const int dofs = n * static_cast<int>(moving.size());
    result.matrix = Eigen::MatrixXd::Zero(dofs, dofs);
    for (int j = 0; j < dofs; ++j) {
        const int solid = moving[j / n];
        std::vector<Twist<D>> twists(solids.size(), Twist<D>::Zero());
        twists[solid][j % n] = 1;
        const auto [impulse, solve] = response(coupling, solver, twists);
        if (!solve.converged)
            throw ComputationError("the pressure solve for the added mass of " + solids[solid].name + " (" +
                                   (D == 2 ? names2[j % n] : names3[j % n]) + ") did not converge: " + solve.message + " (" +
                                   std::to_string(solve.iterations) + " iterations)");
        result.iterations.push_back(solve.iterations);
        for (int i = 0; i < dofs; ++i)
            result.matrix(i, j) = impulse[moving[i / n]][i % n];
    }
    for (int body : moving) {
        result.bodies.push_back(solids[body].name);
        for (int i = 0; i < n; ++i)
            result.labels.push_back(solids[body].name + "." + (D == 2 ? names2[i] : names3[i]));
    }
    result.cells = model.grid.cells().template cast<long>().prod();
    result.film_nodes = coupling.network.nodes;
    result.sealed = coupling.sealed;
    std::set<FilmPair<D>> told;
    for (std::string& note : blind_end_notes(coupling, told))
        result.warnings.push_back(std::move(note));
    result.blind_length = coupling.network.rim.blind_length;
    result.closure = closure_defect(coupling);
    result.seconds = watch.seconds();
    return result;
}

} // namespace

AddedMass added_mass(const Scene& scene, const Communicator& comm)
{
    return scene.dimension == 2 ? added_mass_in<2>(scene, comm) : added_mass_in<3>(scene, comm);
}

} // namespace gapflow
