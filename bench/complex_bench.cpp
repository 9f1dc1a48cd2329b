// Times of the complex of fluid parts: complex_bench balls CELLS NUMBER RADIUS, or complex_bench mesh CELLS TOLERANCE. Geometry and parts; arms
// of gaps; the energy's weights; K and L of the coupled system: the best of seven, of the slowest rank, and the bytes of each a cell of a rank.
// Balls: at random places apart by 0.1 cells or more, radius in cells. Mesh: a ball of 0.3 of the domain's width.
#include "gapflow/complex/inertia.hpp"
#include "gapflow/core/timer.hpp"
#include "gapflow/coupling/parts.hpp"

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <random>
#include <string>

namespace gapflow {
namespace {

int bench(int argc, char** argv)
{
    if (argc < 4) {
        std::fprintf(stderr, "usage: complex_bench balls CELLS NUMBER RADIUS | mesh CELLS TOLERANCE\n");
        return 2;
    }
    const int n = std::atoi(argv[2]);
    const Communicator comm;
    std::array<SideKind, 6> sides;
    sides.fill(SideKind::wall);
    const Grid<3> grid(Vec<3>::Zero(), 1.0 / n, Index<3>::Constant(n), sides, 2, comm);
    std::vector<std::unique_ptr<Shape<3>>> shapes;
    std::vector<Solid<3>> solids;
    if (std::string(argv[1]) == "balls") {
        const double r = std::atof(argv[4]) / n;
        shapes.push_back(make_ball<3>(r));
        std::mt19937 random(1);
        std::uniform_real_distribution<double> place(r + 0.1 / n, 1 - r - 0.1 / n);
        std::vector<Vec<3>> at;
        for (long tries = 0; static_cast<int>(at.size()) < std::atoi(argv[3]) && tries < 20000000; ++tries) {
            const Vec<3> x(place(random), place(random), place(random));
            bool free = true;
            for (const Vec<3>& y : at)
                free = free && (x - y).norm() > 2 * r + 0.1 / n;
            if (free)
                at.push_back(x);
        }
        for (const Vec<3>& x : at) {
            Pose<3> pose;
            pose.position = x;
            solids.push_back({"ball", PlacedShape<3>(*shapes[0], pose), x});
        }
    } else {
        shapes.push_back(make_mesh<3>(make_ball<3>(0.3)->display_mesh(std::atof(argv[3]) / n), "ball"));
        Pose<3> pose;
        pose.position = Vec<3>(0.501, 0.497, 0.503);
        solids.push_back({"ball", PlacedShape<3>(*shapes[0], pose), pose.position});
        std::printf("%zu facets\n", shapes[0]->display_mesh(0).elements.size());
    }
    const std::vector<TwistMatrix<3>> mass(solids.size(), TwistMatrix<3>::Identity());
    std::array<double, 4> best;
    best.fill(std::numeric_limits<double>::infinity());
    for (int k = 0; k < 7; ++k) {
        MPI_Barrier(comm.mpi());
        const Stopwatch watch;
        const Complex<3> complex = build_complex<3>(grid, solids);
        const double built = comm.max(watch.seconds());
        const std::vector<GapArm<3>> arms = find_gap_arms<3>(grid, solids, complex);
        const double found = comm.max(watch.seconds());
        const Inertia<3> inertia = find_inertia<3>(grid, complex, arms);
        const double weighed = comm.max(watch.seconds());
        const Coupling<3> coupling = couple_parts<3>(grid, solids, mass, 1, complex, inertia);
        const double coupled = comm.max(watch.seconds());
        best = {std::min(best[0], built), std::min(best[1], found - built), std::min(best[2], weighed - found),
                std::min(best[3], coupled - weighed)};
        if (k < 6 || !comm.root())
            continue;
        const double cells = static_cast<double>(grid.owned_cells());
        std::printf(
            "%zu solids, %d cut cells, %d parts, %zu pieces, %zu arms, %zu rows lent on this rank; %d ranks of %d threads\n",
            solids.size(), complex.cut_cells(), complex.parts(), complex.pieces.size(), arms.size(), inertia.flux.size(),
            comm.size(), thread_count());
        std::printf("ms: complex %.1f, arms %.1f, weights %.1f, K and L %.1f, all %.1f\n", 1e3 * best[0], 1e3 * best[1],
                    1e3 * best[2], 1e3 * best[3], 1e3 * (best[0] + best[1] + best[2] + best[3]));
        std::printf("bytes a cell: complex %.0f, weights %.0f\n", double(complex.bytes()) / cells,
                    double(inertia.bytes()) / cells);
    }
    return 0;
}

} // namespace
} // namespace gapflow

int main(int argc, char** argv)
{
    gapflow::Environment environment;
    return gapflow::bench(argc, argv);
}
