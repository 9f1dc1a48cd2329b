// Arms of gaps in random scenes of solids near each other: finite, their energies sums of squares, uniform motion of everything exact.
#include "near_scenes.hpp"

#include "gapflow/complex/inertia.hpp"

#include <Eigen/Eigenvalues>

#include <gtest/gtest.h>

#include <cstdlib>

namespace gapflow::testing {
namespace {

/// Largest outflow from a part or cell when the solids and the fluid move as one: no closed side is near an arm.
template <int D>
double outflow_of_uniform_motion(const Grid<D>& grid, const Complex<D>& complex, const Inertia<D>& inertia)
{
    std::vector<Vec<D>> part(complex.parts(), Vec<D>::Zero()), cell(complex.index.count, Vec<D>::Zero());
    const auto add = [&](const PartOrCell& side, int axis, double flux) {
        if (side.is_part())
            part[side.number()][axis] += flux;
        else if (side.is_cell())
            cell[side.number()][axis] += flux;
    };
    std::array<std::vector<double>, D> rest = inertia.main_weight; // without the faces that have pieces
    for (std::size_t k = 0; k < complex.pieces.size(); ++k) {
        const FacePiece<D>& piece = complex.pieces[k];
        add(piece.low, piece.axis, inertia.piece_weight[k]);
        add(piece.high, piece.axis, -inertia.piece_weight[k]);
        if (complex.joins_main(piece))
            rest[piece.axis][piece.face] -= inertia.piece_weight[k];
    }
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(complex.index.low, owned_faces_end(grid, axis), [&](const Index<D>& f) {
            const double weight = rest[axis][complex.index(f)];
            for (int side = 0; side < 2; ++side)
                if (const Index<D> c = grid.wrapped(Index<D>(f - (1 - side) * step<D>(axis))); grid.in_domain(c))
                    add(complex.main_of(complex.index(c)), axis, side ? -weight : weight);
        });
    for (int p = 0; p < complex.parts(); ++p)
        for (int k = complex.first_patch[p]; k < complex.first_patch[p + 1]; ++k)
            part[p] += inertia.patch_flux[k].template head<D>();
    for (const LentFlux<D>& lent : inertia.flux)
        (lent.row.is_part() ? part[lent.row.number()] : cell[lent.row.number()]) += lent.flux.template head<D>();
    for (const RowsLink<D>& link : inertia.mouths) { // p = - x
        Vec<D> flux = Vec<D>::Zero(), first = Vec<D>::Zero();
        for (const auto& [row, weight] : link.rows) {
            const Index<D> c = complex.index.index(complex.cell_of(row));
            for (int axis = 0; axis < D; ++axis) {
                double x = (grid.centre_place(axis, c[axis]) - grid.anchor()[axis]) / grid.dx();
                if (&weight == &link.rows[0].second)
                    first[axis] = x;
                if (grid.periodic(axis))
                    x -= grid.cells()[axis] * std::round((x - first[axis]) / grid.cells()[axis]);
                flux[axis] -= link.conductance * weight * x;
            }
        }
        for (const auto& [row, weight] : link.rows)
            (row.is_part() ? part[row.number()] : cell[row.number()]) += weight * flux;
    }
    double worst = 0;
    for (const Vec<D>& sum : part)
        worst = std::max(worst, sum.norm());
    for (const Vec<D>& sum : cell)
        worst = std::max(worst, sum.norm());
    return worst;
}

template <int D>
void check_arms(const std::vector<GapArm<D>>& arms)
{
    for (const GapArm<D>& arm : arms) {
        EXPECT_TRUE(std::isfinite(arm.resistance) && arm.resistance > 0) << arm.resistance;
        EXPECT_TRUE(arm.flux.allFinite() && arm.motion.allFinite() && arm.mass.allFinite());
        const PairMass<D> rest = arm.mass - arm.flux * arm.flux.transpose() / arm.resistance;
        EXPECT_GE(Eigen::SelfAdjointEigenSolver<PairMass<D>>(rest).eigenvalues()[0], -1e-12 * (1e-3 + arm.mass.norm()));
    }
}

template <int D>
void check_scenes()
{
    const char* asked = std::getenv("GAPFLOW_SCENES");
    const int scenes = asked ? std::atoi(asked) : 200;
    double worst = 0;
    std::size_t arms = 0;
    for (int seed = 0; seed < scenes; ++seed) {
        const bool walls = seed % 2;
        NearScenes<D> near(seed);
        const Grid<D> grid = near.grid(walls);
        Scene<D> scene(grid);
        near.fill(scene);
        const Complex<D> complex = build_complex<D>(grid, scene.solids);
        const std::vector<GapArm<D>> found = find_gap_arms<D>(grid, scene.solids, complex);
        check_arms<D>(found);
        arms += found.size();
        const std::vector<MouthArm<D>> mouths = find_mouth_arms<D>(grid, scene.solids, complex);
        for (const MouthArm<D>& mouth : mouths)
            EXPECT_TRUE(mouth.resistance > 0 && std::isfinite(mouth.resistance) && mouth.flux.allFinite() &&
                        mouth.mass.allFinite())
                << "scene " << seed;
        if (!walls) {
            const double out = outflow_of_uniform_motion<D>(grid, complex, find_inertia<D>(grid, complex, found, mouths));
            double stiffest = 1; // round-off of what uniform motion gives is taken times that
            for (const MouthArm<D>& mouth : mouths)
                stiffest = std::max(stiffest, 1e-4 / mouth.resistance);
            EXPECT_LE(out, 1e-10 * stiffest) << "scene " << seed;
            worst = std::max(worst, out);
        }
        if (::testing::Test::HasFailure() && !asked)
            FAIL() << "scene " << seed;
    }
    EXPECT_GT(arms, 4 * static_cast<std::size_t>(scenes));
    ::testing::Test::RecordProperty("scenes", scenes);
    ::testing::Test::RecordProperty("arms", static_cast<int>(arms));
    char text[20];
    std::snprintf(text, sizeof text, "%.1e", worst);
    ::testing::Test::RecordProperty("outflow", text);
}

TEST(NearScenes, ArmsAreFinite2D)
{
    check_scenes<2>();
}

TEST(NearScenes, ArmsAreFinite3D)
{
    check_scenes<3>();
}

} // namespace
} // namespace gapflow::testing
