#include "gapflow/stepping/first_acceleration.hpp"

#include "gapflow/body/forces.hpp"
#include "gapflow/core/error.hpp"
#include "gapflow/solver/solver.hpp"
#include "gapflow/stepping/core_requirement.hpp"
#include "gapflow/stepping/model.hpp"
#include "gapflow/stepping/thickness_check.hpp"
#include "gapflow/stepping/weight_check.hpp"

#include <algorithm>

namespace gapflow {

namespace {

template <int D>
FirstAccelerations first_accelerations_in(const Scene& scene, const Communicator& comm)
{
    constexpr int n = twist_size<D>;
    const Model<D> model(scene, comm, Task::added_mass);
    thickness_warnings<D>(scene, model.bodies, model.walls, scene.thin);
    require_weight(scene, model.bodies);
    const Coupling<D> coupling = model.coupled(model.bodies, model.masses(model.bodies, 0.0));
    require_core(model, coupling, model.bodies);
    const CoupledSystem<D>& system = coupling.system;
    const Grid<D>& grid = *coupling.grid;

    Eigen::VectorXd force = Eigen::VectorXd::Zero(n * system.bodies);
    for (std::size_t s = 0; s < model.bodies.size(); ++s)
        if (const int b = coupling.free_body[s]; b >= 0) {
            RigidBody<D> still = model.bodies[s];
            still.twist.setZero();
            force.segment<n>(n * b) = coupling.solids[s].admissible *
                                      (explicit_wrench<D>(still, model.gravity(), scene.density) + spring_wrench(still));
        }
    FirstAccelerations result;
    Eigen::VectorXd a;
    if (system.bodies > 0) {
        a = system.response(force);
        UnknownVector<D> rhs{CellField<D>(grid), Eigen::VectorXd::Zero(system.nodes)};
        UnknownVector<D> q{CellField<D>(grid), Eigen::VectorXd::Zero(system.nodes)};
        for (const auto& entry : system.cell_flux)
            rhs.cells(entry.row) -= entry.flux.dot(a.segment<n>(n * entry.body));
        for (const auto& entry : system.node_flux)
            rhs.nodes[entry.row] -= entry.flux.dot(a.segment<n>(n * entry.body));
        comm.sum(std::span<double>(rhs.nodes.data(), rhs.nodes.size()));
        SolverOptions options;
        options.tolerance = std::min(scene.tolerance, 1e-8);
        options.backend = scene.backend == Scene::Backend::petsc ? Backend::petsc : Backend::multigrid;
        const SolveReport solve = CoupledSolver<D>(system, options).solve(q, rhs);
        if (!solve.converged)
            throw ComputationError("the pressure solve for the first accelerations did not converge: " + solve.message + " (" +
                                   std::to_string(solve.iterations) + " iterations)");
        a += system.response(wrenches(system, q));
        result.iterations = solve.iterations;
    }
    for (std::size_t s = 0; s < model.bodies.size(); ++s)
        if (const int b = coupling.free_body[s]; b >= 0) {
            result.bodies.push_back(coupling.solids[s].name);
            result.acceleration.push_back(a.segment<n>(n * b));
        }
    return result;
}

} // namespace

FirstAccelerations first_accelerations(const Scene& scene, const Communicator& comm)
{
    return scene.dimension == 2 ? first_accelerations_in<2>(scene, comm) : first_accelerations_in<3>(scene, comm);
}

} // namespace gapflow
