// Random scenes of solids near each other, of every kind of shape and down to less than a cell: their added mass is positive.
#include "../complex/near_scenes.hpp"
#include "direct_mass.hpp"

#include "gapflow/coupling/displaced_mass.hpp"
#include "gapflow/coupling/parts.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <cstdlib>

namespace gapflow::testing {
namespace {

/// Least eigenvalue of the added mass, in the axes in which its diagonal and that of the displaced fluid's mass are one together, over what cancels in the diagonal.
template <int D>
double least_mass(int seed, bool small)
{
    const bool walls = seed % 2;
    NearScenes<D> near(seed, small ? 0.3 : 1.0);
    const Grid<D> grid = near.grid(walls);
    Scene<D> scene(grid);
    near.fill(scene);
    std::vector<TwistMatrix<D>> mass(scene.solids.size(), TwistMatrix<D>::Identity());
    for (Solid<D>& solid : scene.solids)
        if (!solid.wall)
            solid.motion = Motion::free;
    const Complex<D> complex = build_complex<D>(grid, scene.solids);
    const Inertia<D> inertia = find_inertia<D>(grid, complex, find_gap_arms<D>(grid, scene.solids, complex),
                                               find_mouth_arms<D>(grid, scene.solids, complex));
    const Coupling<D> coupling = couple_parts<D>(grid, scene.solids, mass, 1.0, complex, inertia);
    double cancelled = 1;
    const Eigen::MatrixXd M = direct_added_mass(coupling, &cancelled);
    EXPECT_TRUE(M.allFinite());
    Eigen::VectorXd scale = M.diagonal();
    long row = 0;
    for (const Solid<D>& solid : coupling.solids)
        if (!solid.wall) {
            scale.segment<twist_size<D>>(row) += displaced_mass(solid, coupling.density).diagonal();
            row += twist_size<D>;
        }
    scale = scale.cwiseSqrt().cwiseInverse();
    const Eigen::MatrixXd scaled = scale.asDiagonal() * M * scale.asDiagonal();
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled).eigenvalues()[0] / cancelled;
}

template <int D>
void check_masses(bool small)
{
    const char* asked = std::getenv("GAPFLOW_SCENES");
    const int scenes = asked ? std::atoi(asked) : D == 2 ? 200 : 40;
    double worst = 0;
    int negative = 0;
    for (int seed = 0; seed < scenes; ++seed) {
        const double found = least_mass<D>(seed, small);
        EXPECT_GT(found, -1e-10) << "scene " << seed;
        worst = std::min(worst, found);
        negative += !(found > -1e-10);
        if (::testing::Test::HasFailure() && !asked)
            FAIL() << "scene " << seed;
    }
    char text[80];
    std::snprintf(text, sizeof text, "%d of %d negative, least %.1e", negative, scenes, worst);
    ::testing::Test::RecordProperty("masses", text);
}

TEST(NearMasses, ArePositive2D)
{
    check_masses<2>(false);
}
TEST(NearMasses, ArePositive3D)
{
    check_masses<3>(false);
}
TEST(NearMasses, OfSmallBodiesArePositive2D)
{
    check_masses<2>(true);
}
TEST(NearMasses, OfSmallBodiesArePositive3D)
{
    check_masses<3>(true);
}

} // namespace
} // namespace gapflow::testing
