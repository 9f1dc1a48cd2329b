// Added masses and first accelerations by the complex of fluid parts, and by films, on several ranks: those of one. Run on several ranks (ctest -L mpi).
#include "gapflow/scene/parse_scene.hpp"
#include "gapflow/stepping/added_mass.hpp"
#include "gapflow/stepping/first_acceleration.hpp"

#include <gtest/gtest.h>

namespace gapflow {
namespace {

std::string scene_of(const std::string& domain, const std::string& bodies)
{
    return domain + "[gap]\nmodel = \"parts\"\n[solver]\ntolerance = 1e-12\n" + bodies;
}

std::string sides(int dimension, const std::string& kind)
{
    std::string text = "[domain.sides]\n";
    for (int axis = 0; axis < dimension; ++axis)
        for (const char* end : {"low", "high"})
            text += std::string(1, "xyz"[axis]) + "_" + end + " = \"" + kind + "\"\n";
    return text;
}

// A thin plate over the whole domain, balls with a gap, bodies that touch cells of all ranks, a sheet, one of a thousandth of the fluid's density.
const std::string plane_domain = "gravity = [0.3, -9.81]\n[domain]\nsize = [1, 1]\ncells = [32, 32]\n";
const std::string plane_bodies = R"(
[[body]]
name = "plate"
shape = "box"
size = [0.62, 0.0007]
position = [0.513, 0.482]
rotation = 0.41
density = 2
[[body]]
name = "ball"
shape = "ball"
radius = 0.11
position = [0.497, 0.741]
density = 0.001
[[body]]
name = "box"
shape = "box"
size = [0.2, 0.13]
position = [0.94, 0.06]
rotation = 0.2
density = 0.5
[[body]]
name = "capsule"
shape = "capsule"
radius = 0.06
length = 0.15
position = [0.05, 0.52]
rotation = 1.1
density = 100
[[body]]
name = "near_ball"
shape = "ball"
radius = 0.08
position = [0.497, 0.93101]
density = 0.001
)";

// The first box has edges in planes of the grid, the cylinder rims in cells of several ranks; two balls with a gap.
const std::string space_domain = "gravity = [0.3, -9.81, 1]\n[domain]\nsize = [1, 1, 1]\ncells = [20, 20, 20]\n";
const std::string space_bodies = R"(
[[body]]
name = "box"
shape = "box"
size = [0.3, 0.2, 0.25]
position = [0.4, 0.5, 0.375]
density = 0.001
[[body]]
name = "plate"
shape = "box"
size = [0.4, 0.001, 0.3]
position = [0.5, 0.72, 0.52]
rotation = [0.9, 0.2, -0.3, 0.1]
density = 3
[[body]]
name = "cylinder"
shape = "cylinder"
radius = 0.13
length = 0.2
position = [0.93, 0.2, 0.96]
rotation = [0.8, -0.5, 0.3, 0.1]
density = 2
[[body]]
name = "ball"
shape = "ball"
radius = 0.12
position = [0.2, 0.1, 0.8]
density = 0.5
[[body]]
name = "near_ball"
shape = "ball"
radius = 0.13
position = [0.2, 0.35001, 0.8]
density = 0.001
[[body]]
name = "capsule"
shape = "capsule"
radius = 0.1
length = 0.3
position = [0.63, 0.44, 0.74]
rotation = [0.9, 0.1, 0.4, 0.0]
density = 2
)";

void expect_one_result(const std::string& text)
{
    const Scene scene = parse_scene(text, "scene.toml", {}, Purpose::added_mass);
    const Communicator one(MPI_COMM_SELF), all;
    const AddedMass mass = added_mass(scene, all), alone = added_mass(scene, one);
    ASSERT_EQ(mass.matrix.rows(), alone.matrix.rows());
    EXPECT_LT((mass.matrix - alone.matrix).cwiseAbs().maxCoeff(), 1e-8 * alone.matrix.cwiseAbs().maxCoeff());
    EXPECT_LT(mass.closure, 1e-12);
    EXPECT_EQ(mass.sealed.size(), alone.sealed.size());
    const FirstAccelerations first = first_accelerations(scene, all), expected = first_accelerations(scene, one);
    ASSERT_EQ(first.acceleration.size(), expected.acceleration.size());
    for (std::size_t s = 0; s < first.acceleration.size(); ++s)
        for (long i = 0; i < first.acceleration[s].size(); ++i)
            EXPECT_NEAR(first.acceleration[s][i], expected.acceleration[s][i], 1e-6 * (1 + expected.acceleration[s].norm()))
                << first.bodies[s] << " " << i;
}

TEST(PartsRanks, WallsOfAPlane)
{
    expect_one_result(scene_of(plane_domain, plane_bodies));
}

TEST(PartsRanks, OpenPlane)
{
    expect_one_result(scene_of(plane_domain + sides(2, "open"), plane_bodies));
}

TEST(PartsRanks, PeriodicPlane)
{
    expect_one_result(scene_of(plane_domain + sides(2, "periodic"), plane_bodies));
}

TEST(PartsRanks, WallsOfABox)
{
    expect_one_result(scene_of(space_domain, space_bodies));
}

TEST(PartsRanks, PeriodicBox)
{
    expect_one_result(scene_of(space_domain + sides(3, "periodic"), space_bodies));
}

TEST(PartsRanks, LightBodiesCloseToEachOther)
{
    for (const auto& [radius, y] : {std::pair{"0.06", "0.57001"}, {"0.15", "0.663"}}) // D takes mass from one of the two only
        expect_one_result(scene_of(
            plane_domain, "[[body]]\nname = \"a\"\nshape = \"ball\"\nradius = 0.11\nposition = [0.497, 0.4]\ndensity = 0.001\n"
                          "[[body]]\nname = \"b\"\nshape = \"ball\"\ndensity = 0.001\nradius = " +
                              std::string(radius) + "\nposition = [0.497, " + y + "]\n"));
}

TEST(PartsRanks, MouthsAtSidesOfRanks)
{
    // Gaps whose ends lie beside x = 1/2 and y = 1/2, where ranks meet, and across a periodic side.
    const std::string bodies = R"(
[[body]]
name = "upper"
shape = "box"
size = [0.4, 0.2]
position = [0.359, 0.61]
density = 2
[[body]]
name = "lower"
shape = "box"
size = [0.42, 0.2]
position = [0.375, 0.4]
density = 0.5
[[body]]
name = "post"
shape = "box"
size = [0.2, 0.3]
position = [0.963, 0.33]
rotation = 0.3
density = 1
[[body]]
name = "plank"
shape = "box"
size = [0.3, 0.05]
position = [0.99, 0.515]
rotation = 0.3
density = 2
)";
    expect_one_result(scene_of(plane_domain, bodies));
    expect_one_result(scene_of(plane_domain + sides(2, "periodic"), bodies));
}

TEST(PartsRanks, Films)
{
    expect_one_result(R"(
gravity = [0, -9.81]
[domain]
size = [1, 1]
cells = [32, 32]
[solver]
tolerance = 1e-12
[[body]]
name = "upper"
shape = "box"
size = [0.3, 0.2]
position = [0.5, 0.5]
density = 2
[[body]]
name = "lower"
shape = "box"
size = [0.3, 0.2]
position = [0.5, 0.29]
density = 3
)");
}

} // namespace
} // namespace gapflow
