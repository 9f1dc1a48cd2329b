// gapflow added-mass: the added-mass matrix of all bodies that are not fixed, and first accelerations.
#include "commands.hpp"

#include "gapflow/core/communicator.hpp"
#include "gapflow/core/logging.hpp"
#include "gapflow/stepping/added_mass.hpp"
#include "gapflow/stepping/first_acceleration.hpp"
#include "gapflow/stepping/gap_notes.hpp"

#include <nlohmann/json.hpp>

#include <cstdio>

namespace gapflow {

int added_mass_command(const Scene& scene, bool json, bool accelerations)
{
    const Communicator comm;
    const Logger log(comm, false);
    const AddedMass result = added_mass(scene, comm);
    const FirstAccelerations first = accelerations ? first_accelerations(scene, comm) : FirstAccelerations{};
    for (const std::string& warning : result.warnings)
        log.warning(warning);
    if (!comm.root())
        return 0;
    if (json) {
        nlohmann::ordered_json out;
        out["bodies"] = result.bodies;
        out["matrix"] = nlohmann::json::array();
        for (long i = 0; i < result.matrix.rows(); ++i) {
            nlohmann::ordered_json row = nlohmann::ordered_json::array();
            for (long j = 0; j < result.matrix.cols(); ++j)
                row.push_back(result.matrix(i, j));
            out["matrix"].push_back(row);
        }
        out["labels"] = result.labels;
        out["cells"] = result.cells;
        out["film_nodes"] = result.film_nodes;
        out["iterations"] = result.iterations;
        out["sealed"] = nlohmann::json::array();
        for (const SealedPocket& pocket : result.sealed)
            out["sealed"].push_back(
                {{"cells", pocket.cells}, {"film_nodes", pocket.nodes}, {"bodies", pocket.bodies}, {"at", pocket.at}});
        out["blind_film_ends"] = result.blind_length;
        out["warnings"] = result.warnings;
        if (accelerations) {
            out["accelerations"] = nlohmann::ordered_json::object();
            for (std::size_t b = 0; b < first.bodies.size(); ++b)
                out["accelerations"][first.bodies[b]] =
                    std::vector<double>(first.acceleration[b].begin(), first.acceleration[b].end());
            out["acceleration_iterations"] = first.iterations;
        }
        out["seconds"] = result.seconds;
        std::puts(out.dump(2).c_str());
        return 0;
    }
    std::printf("added mass (twists about the centres of mass, world axes), %ld cells, %d film nodes\n", result.cells,
                result.film_nodes);
    std::printf("%-16s", "");
    for (const std::string& label : result.labels)
        std::printf(" %13s", label.c_str());
    std::printf("\n");
    for (long i = 0; i < result.matrix.rows(); ++i) {
        std::printf("%-16s", result.labels[i].c_str());
        for (long j = 0; j < result.matrix.cols(); ++j)
            std::printf(" %13.6g", result.matrix(i, j));
        std::printf("\n");
    }
    for (std::size_t b = 0; b < first.bodies.size(); ++b) {
        std::printf("first acceleration of %s:", first.bodies[b].c_str());
        for (const double component : first.acceleration[b])
            std::printf(" %.6g", component);
        std::printf("\n");
    }
    for (const SealedPocket& pocket : result.sealed)
        std::printf("sealed: %s\n", sealed_text(pocket).c_str());
    return 0;
}

} // namespace gapflow
