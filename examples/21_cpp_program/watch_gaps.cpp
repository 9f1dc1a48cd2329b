// Steps a 2D scene to its end and prints the thickness and force of every film.
#include <gapflow/core/error.hpp>
#include <gapflow/step/simulation.hpp>

#include <cstdio>

int main(int argc, char** argv)
{
    const gapflow::Environment environment; // MPI, PETSc, threads
    if (argc != 2) {
        std::fprintf(stderr, "usage: watch_gaps SCENE.toml\n");
        return 2;
    }
    try {
        const gapflow::Scene scene = gapflow::read_scene(argv[1], {}, gapflow::Purpose::run);
        gapflow::Simulation<2> simulation(scene, gapflow::Communicator());
        while (simulation.time() < scene.end) {
            const gapflow::StepReport report = simulation.step(scene.end);
            for (const gapflow::GapState& gap : simulation.gaps())
                std::printf("t = %.4f  %s - %s: thickness %.5f, force %.4f\n", report.time, gap.body_a.c_str(),
                            gap.body_b.c_str(), gap.thickness, gap.force);
        }
    } catch (const std::exception& error) { // InputError, ComputationError: the message names place and remedy
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
