// One measurement a call, as one line of JSON:
//
//     gapflow_bench step SCENE.toml     whole time steps
//     gapflow_bench solve SCENE.toml    the first pressure solve alone: set-up and solve
//     gapflow_bench bandwidth           the machine's copy bandwidth
//
// Every call measures the copy bandwidth too, with the threads and ranks of the run, so that fractions of it compare like with
// like. Times are wall-clock, of the slowest rank.
#include "gapflow/core/threads.hpp"
#include "gapflow/output/run_record.hpp"
#include "gapflow/scene/scene.hpp"
#include "gapflow/solver/solver.hpp"
#include "gapflow/step/simulation.hpp"
#include "gapflow/stepping/model.hpp"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>

namespace gapflow {

namespace {

using Json = nlohmann::ordered_json;

struct Arguments {
    std::string scene, backend = "multigrid", bodies = "automatic";
    int steps = 3, repeat = 2;
    double bandwidth_megabytes = 512;
};

/// Bytes read and written a second by y = x, all ranks and threads together. The arrays are larger than caches.
double copy_bandwidth(const Communicator& comm, double megabytes)
{
    const long n = std::max(1L, std::lround(megabytes * 1e6 / 16 / comm.size()));
    const std::unique_ptr<double[]> x(new double[n]), y(new double[n]);
    for_each_part(n, [&](long begin, long end) {
        std::fill(&x[begin], &x[end], 1.0);
        std::fill(&y[begin], &y[end], 0.0);
    });
    double best = 1e300;
    for (int round = 0; round < 4; ++round) {
        MPI_Barrier(comm.mpi());
        const double start = MPI_Wtime();
        for_each_part(n, [&](long begin, long end) {
            const double* from = x.get();
            double* to = y.get();
            for (long i = begin; i < end; ++i)
                to[i] = 1.0000001 * from[i]; // not a copy that the library would do with other instructions
        });
        best = std::min(best, comm.max(MPI_Wtime() - start));
    }
    return 16.0 * static_cast<double>(n) * comm.size() / best;
}

/// Bytes that one iteration must move from or to memory for each cell: the count behind "fraction of the bandwidth limit".
/// Conjugate gradients in double precision with a fused residual: p and q = A p (read z, p; write p, q), x and r (read x, r,
/// p, q; write x, r), the products z.r, z.q (read z, r, q), the cycle on the finest level in single precision (read r, write
/// b; read b, write x; read b, x, write x), an eighth (2D: a quarter) of the latter again for all coarser levels.
template <int D>
double bytes_per_iteration()
{
    const double vectors = 4 + 3 * 8 + 6 * 8 + (4 + 8 + 8), cycle = 4 + 8 + 12;
    return vectors + cycle / (1 - std::pow(0.5, D));
}

template <int D>
Json describe(const Simulation<D>& simulation)
{
    Json out;
    const Communicator& comm = simulation.grid().comm();
    const long cells = simulation.grid().cells().template cast<long>().prod();
    out["dimension"] = D;
    out["cells"] = cells;
    out["unknown_cells"] = simulation.initial_report().cells;
    out["film_nodes"] = simulation.initial_report().film_nodes;
    out["bodies"] = simulation.bodies().size();
    out["ranks"] = comm.size();
    out["threads"] = thread_count();
    return out;
}

template <int D>
Json measure_steps(const Scene& scene, const Arguments& arguments)
{
    const Communicator comm;
    Simulation<D> simulation(scene, comm);
    Json out = describe(simulation);
    simulation.step(scene.end); // the first one allocates
    const std::map<std::string, StageTimers::Stage> before = simulation.stages().stages();
    std::vector<double> seconds;
    std::vector<int> iterations;
    for (int k = 0; k < arguments.steps; ++k) {
        const StepReport report = simulation.step(scene.end);
        seconds.push_back(comm.max(report.seconds));
        iterations.push_back(report.iterations);
    }
    std::vector<double> sorted = seconds;
    std::sort(sorted.begin(), sorted.end());
    const double median = sorted[sorted.size() / 2];
    out["step_seconds"] = median;
    out["all_step_seconds"] = seconds;
    out["iterations"] = iterations;
    out["cells_per_second"] = out["cells"].get<double>() / median;
    Json& stages = out["stage_seconds"] = Json::object(); // mean of a step
    for (const auto& [name, stage] : simulation.stages().stages()) {
        const auto old = before.find(name);
        stages[name] = (stage.seconds - (old == before.end() ? 0.0 : old->second.seconds)) / arguments.steps;
    }
    return out;
}

template <int D>
Json measure_solve(const Scene& scene, const Arguments& arguments)
{
    const Communicator comm;
    const Model<D> model(scene, comm);
    const Grid<D>& grid = model.grid;
    std::vector<TwistMatrix<D>> mass;
    std::vector<Twist<D>> twists; // that forces give the bodies in a time step of 1
    for (const RigidBody<D>& body : model.bodies) {
        mass.push_back(mass_matrix(body));
        twists.push_back(mass.back().inverse() * explicit_wrench<D>(body, model.gravity(), scene.density));
    }
    mass.resize(mass.size() + model.walls.solids.size(), TwistMatrix<D>::Identity());
    twists.resize(mass.size(), Twist<D>::Zero());
    const Coupling<D> coupling = model.coupled(model.bodies, mass);
    FluidVelocity<D> still{FaceField<D>(grid), std::vector<Vec<D>>(coupling.network.elements, Vec<D>::Zero()),
                           std::vector<double>(coupling.network.elements, 0.0),
                           std::vector<double>(coupling.network.rim.mouths.size(), 0.0)};
    UnknownVector<D> rhs;
    outflow(coupling, still, twists, rhs);
    for (long i = 0; i < rhs.cells.size(); ++i)
        rhs.cells.data()[i] *= -1;
    rhs.nodes *= -1;

    SolverOptions options;
    options.tolerance = 1e-8;
    options.backend = arguments.backend == "petsc" ? Backend::petsc : Backend::multigrid;
    options.bodies = arguments.bodies == "always"  ? BodyMode::always
                     : arguments.bodies == "never" ? BodyMode::never
                                                   : BodyMode::automatic;
    double setup = 1e300, solve = 1e300, bytes = 0;
    SolveReport report;
    for (int k = 0; k < arguments.repeat; ++k) {
        const CoupledSolver<D> solver(coupling.system, options);
        UnknownVector<D> p{CellField<D>(grid), Eigen::VectorXd::Zero(coupling.system.nodes)};
        report = solver.solve(p, rhs);
        setup = std::min(setup, comm.max(solver.setup_seconds()));
        solve = std::min(solve, comm.max(report.seconds));
        bytes = solver.bytes_per_cell();
    }
    Json out;
    const double cells = static_cast<double>(grid.cells().template cast<long>().prod());
    out["dimension"] = D;
    out["cells"] = static_cast<long>(cells);
    out["film_nodes"] = coupling.network.nodes;
    out["bodies"] = model.bodies.size();
    out["ranks"] = comm.size();
    out["threads"] = thread_count();
    out["backend"] = arguments.backend;
    out["converged"] = report.converged;
    out["residual"] = report.residual;
    out["iterations"] = report.iterations;
    out["setup_seconds"] = setup;
    out["solve_seconds"] = solve;
    out["cells_per_second"] = cells / (setup + solve);
    out["solver_bytes_per_cell"] = bytes;
    out["bytes_per_cell_and_iteration"] = bytes_per_iteration<D>();
    return out;
}

int bench(int argc, char** argv)
{
    CLI::App app("Measures Gapflow; see bench/run", "gapflow_bench");
    app.require_subcommand(1);
    Arguments arguments;
    CLI::App* step = app.add_subcommand("step", "Whole time steps");
    CLI::App* solve = app.add_subcommand("solve", "The first pressure solve");
    app.add_subcommand("bandwidth", "Copy bandwidth");
    for (CLI::App* command : {step, solve})
        command->add_option("scene", arguments.scene, "Scene file")->required();
    step->add_option("--steps", arguments.steps, "Steps to measure, after one that is not")->check(CLI::PositiveNumber);
    solve->add_option("--backend", arguments.backend, "multigrid or petsc")->check(CLI::IsMember({"multigrid", "petsc"}));
    solve->add_option("--bodies", arguments.bodies, "Correction for bodies")
        ->check(CLI::IsMember({"automatic", "always", "never"}));
    solve->add_option("--repeat", arguments.repeat, "Solves; the fastest counts")->check(CLI::PositiveNumber);
    app.add_option("--bandwidth-megabytes", arguments.bandwidth_megabytes, "Size of the two arrays that are copied")
        ->check(CLI::PositiveNumber);
    CLI11_PARSE(app, argc, argv);

    const Environment environment;
    const Communicator comm;
    Json out;
    if (*step || *solve) {
        const Scene scene = read_scene(arguments.scene, {}, Purpose::run);
        if (*step)
            out = scene.dimension == 2 ? measure_steps<2>(scene, arguments) : measure_steps<3>(scene, arguments);
        else
            out = scene.dimension == 2 ? measure_solve<2>(scene, arguments) : measure_solve<3>(scene, arguments);
        out["peak_bytes_per_cell"] = peak_memory(comm).sum / out["cells"].get<double>(); // before the arrays that are copied
    }
    const double bandwidth = copy_bandwidth(comm, arguments.bandwidth_megabytes);
    out["copy_bandwidth"] = bandwidth;
    if (*solve && arguments.backend == "multigrid") {
        // Seconds that the iterations' bytes take at the measured bandwidth, over seconds taken.
        const double limit = out["iterations"].get<double>() * out["cells"].get<double>() *
                             out["bytes_per_cell_and_iteration"].get<double>() / bandwidth;
        out["fraction_of_bandwidth_limit"] = limit / out["solve_seconds"].get<double>();
    }
    if (comm.root())
        std::cout << out.dump() << std::endl;
    return 0;
}

} // namespace

} // namespace gapflow

int main(int argc, char** argv)
{
    try {
        return gapflow::bench(argc, argv);
    } catch (const std::exception& e) {
        std::cerr << "gapflow_bench: error: " << e.what() << '\n';
        return 1;
    }
}
