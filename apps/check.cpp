#include "commands.hpp"

#include "gapflow/complex/part_borders.hpp"
#include "gapflow/core/text.hpp"
#include "gapflow/output/part_picture.hpp"
#include "gapflow/scene/graded_widths.hpp"
#include "gapflow/stepping/core_requirement.hpp"
#include "gapflow/stepping/gap_notes.hpp"
#include "gapflow/stepping/memory_forecast.hpp"
#include "gapflow/stepping/model.hpp"
#include "gapflow/stepping/placement.hpp"
#include "gapflow/stepping/start.hpp"
#include "gapflow/stepping/thickness_check.hpp"
#include "gapflow/stepping/weight_check.hpp"

#include <algorithm>
#include <cstdio>
#include <map>

namespace gapflow {

namespace {

std::string count_text(const Scene& scene)
{
    std::vector<std::string> counts;
    for (int axis = 0; axis < scene.dimension; ++axis)
        counts.push_back(std::to_string(scene.cells[axis]));
    return joined(counts, " x ");
}

// What a graded grid comes to: its core, its widest cells and the longest ones.
template <int D>
void print_grading(const Scene& scene, const Grid<D>& grid)
{
    std::vector<std::string> counts;
    for (int axis = 0; axis < D; ++axis)
        counts.push_back(std::to_string(core_cells(scene, axis)));
    std::printf("core      %s cells; outside it cells grow by up to %.3g to a width of %.6g, aspect up to %.3g\n",
                joined(counts, " x ").c_str(), scene.core->growth, grid.largest_width() * grid.dx(), grid.largest_aspect());
}

template <int D>
void write_picture(const Scene& scene, const std::string& file, const Coupling<D>& coupling)
{
    const Model<D> alone(scene, Communicator(MPI_COMM_SELF), Task::added_mass);
    PartBorders<D> borders;
    const Complex<D> complex = build_complex<D>(alone.grid, coupling.solids, nullptr, &borders);
    const PartCounts counts = write_parts<D>(file, alone.grid, coupling.solids, complex, borders);
    std::printf("parts     %ld in %d cut cells, %ld of them thin: %s\n", counts.parts, complex.cut_cells(), counts.thin,
                file.c_str());
}

// The gap model at the scene's start: films with their pairs, enclosed fluid, bodies too thin for the grid. Writes a picture of parts.
template <int D>
void print_gaps(const Scene& scene, const Communicator& comm, const std::string& parts_file)
{
    const Model<D> model(scene, comm, scene.end > 0 ? Task::motion : Task::added_mass);
    const Grid<D>& grid = model.grid;
    std::vector<RigidBody<D>> bodies = model.bodies;
    if (scene.end > 0)
        require_weight(scene, bodies);
    std::vector<std::string> warnings = thickness_warnings<D>(scene, bodies, model.walls, Scene::Thin::allow);
    for (std::string& warning : placement_warnings<D>(scene, bodies, model.walls))
        warnings.push_back(std::move(warning));
    const std::vector<std::string> moved =
        scene.end > 0 ? take_out_overlaps<D>(scene, grid, bodies, model.walls) : std::vector<std::string>();
    warnings.insert(warnings.end(), moved.begin(), moved.end());
    const Coupling<D> coupling = model.coupled(bodies);
    require_fluid(model, coupling);
    require_core(model, coupling, bodies);
    const std::vector<Solid<D>>& solids = coupling.solids;
    if (!comm.root())
        return;
    if (scene.core)
        print_grading(scene, grid);
    for (const std::string& warning : warnings)
        std::printf("warning   %s\n", warning.c_str());
    struct Sum {
        double thinnest = std::numeric_limits<double>::infinity(), threshold = 0;
        std::size_t nodes = 0;
    };
    std::map<std::pair<int, int>, Sum> pairs;
    for (const Film<D>& film : coupling.network.films) {
        Sum& sum = pairs[{film.pair.master, film.pair.other}];
        sum.thinnest = std::min(sum.thinnest, *std::min_element(film.mesh.h.begin(), film.mesh.h.end()) + film.mesh.skin);
        sum.threshold = film.threshold;
        sum.nodes += film.mesh.h.size();
    }
    long unknowns = coupling.network.nodes;
    for (const Component& component : coupling.system.components)
        unknowns += component.unknowns;
    std::printf("memory    about %.3g MiB\n",
                forecast_memory(scene, coupling.network.nodes, static_cast<long>(coupling.network.rim.mouths.size())) /
                    1048576.0);
    if (scene.parts)
        std::printf("unknowns  %ld pressures, %d of them second parts of cells\n", unknowns, coupling.system.nodes);
    else
        std::printf("unknowns  %ld pressures, %d of them in films\n", unknowns - coupling.network.nodes,
                    coupling.network.nodes);
    for (const auto& [pair, sum] : pairs)
        std::printf("film      %s - %s: thinnest %.4g (%.4g cells), where thinner than %.4g cells, %zu nodes\n",
                    solids[pair.first].name.c_str(), solids[pair.second].name.c_str(), sum.thinnest, sum.thinnest / grid.dx(),
                    sum.threshold / grid.dx(), sum.nodes);
    std::set<FilmPair<D>> told;
    if (moved.empty()) // bodies that were separated almost touch
        for (const std::string& note : rough_gap_notes(scene, coupling))
            std::printf("warning   %s\n", note.c_str());
    for (const std::string& note : blind_end_notes(coupling, told))
        std::printf("warning   %s\n", note.c_str());
    for (const std::string& note : closed_gap_notes(scene, coupling))
        std::printf("closed    %s\n", note.c_str());
    for (const SealedPocket& pocket : coupling.sealed)
        std::printf("sealed    %s\n", sealed_text(pocket).c_str());
    if (!parts_file.empty())
        write_picture(scene, parts_file, coupling);
}

} // namespace

int check_command(const Scene& scene, const std::string& parts_file)
{
    const Communicator comm;
    if (!parts_file.empty()) {
        if (!scene.parts)
            throw InputError("--parts " + parts_file + ": the scene's gap.model is not \"parts\"; add --set gap.model=parts");
        if (!parts_file.ends_with(".vtu"))
            throw InputError("--parts " + parts_file +
                             ": not the name of a VTK file of polygons; write for example --parts parts.vtu");
    }
    double cells = 1;
    for (int axis = 0; axis < scene.dimension; ++axis)
        cells *= scene.cells[axis];
    const auto moving = std::count_if(scene.bodies.begin(), scene.bodies.end(),
                                      [](const BodyScene& body) { return body.motion != BodyScene::Motion::fixed; });
    if (comm.root()) {
        std::printf("scene     %s%s%s\n", scene.file.c_str(), scene.title.empty() ? "" : ": ", scene.title.c_str());
        std::printf("cells     %s = %.0f, spacing %.6g\n", count_text(scene).c_str(), cells, scene.spacing());
        std::printf("bodies    %zu, of which %td move\n", scene.bodies.size(), moving);
        for (const CrowdScene& crowd : scene.crowds)
            std::printf("crowd     %s: %d bodies, %s\n", crowd.name.c_str(), crowd.number, names_text(scene, crowd).c_str());
        std::printf("gaps      model %s, threshold %s, roughness %s\n",
                    scene.parts      ? "parts"
                    : scene.gap.film ? "film"
                                     : "none",
                    scene.gap.threshold ? (number_text(*scene.gap.threshold) + " cells").c_str() : "auto",
                    roughness_text(scene).c_str());
        if (scene.end <= 0 || scene.max_step <= 0)
            std::printf("time      time.end or time.max_step is missing: 'gapflow run' needs both\n");
    }
    if (scene.dimension == 2)
        print_gaps<2>(scene, comm, parts_file);
    else
        print_gaps<3>(scene, comm, parts_file);
    require_thickness(scene); // reported before all else, an error after it
    return 0;
}

} // namespace gapflow
