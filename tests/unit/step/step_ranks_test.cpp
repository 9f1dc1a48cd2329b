// The step of ideal fluid on parts on several ranks: that of one. Run on several ranks (ctest -L mpi).
#include "gapflow/scene/parse_scene.hpp"
#include "gapflow/step/energy_change.hpp"
#include "gapflow/step/simulation.hpp"
#include "gapflow/stepping/closing_limit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <optional>
#include <random>

namespace gapflow {
namespace {

std::string sides(int dimension, const std::string& kind)
{
    std::string text = "[domain.sides]\n";
    for (int axis = 0; axis < dimension; ++axis)
        for (const char* end : {"low", "high"})
            text += std::string(1, "xyz"[axis]) + "_" + end + " = \"" + kind + "\"\n";
    return text;
}

Scene scene_of(const std::string& domain, const std::string& bodies)
{
    return parse_scene(
        domain + "[gap]\nmodel = \"parts\"\nroughness = 1e-4\n[solver]\ntolerance = 1e-12\n[time]\nend = 100\nmax_step = 1\n" +
            bodies,
        "scene.toml", {}, Purpose::run);
}

const std::string plane = "gravity = [0.3, -1]\n[domain]\nsize = [1, 1]\ncells = [32, 32]\n";
const std::string still_plane = "[domain]\nsize = [1, 1]\ncells = [32, 32]\n";
const std::string space = "gravity = [0.3, -1, 0.1]\n[domain]\nsize = [1, 1, 1]\ncells = [16, 16, 16]\n";

// Gaps, and mouths at their ends, beside x = 1/2 and y = 1/2, where ranks meet. Not along the grid: places are rounded to 2^-36 of a cell, and where walls
// nearly along a plane of the grid cross it follows from differences of these.
const std::string plates = R"(
[[body]]
name = "upper"
shape = "box"
size = [0.4, 0.1]
position = [0.488, 0.541]
rotation = 0.42
density = 2
velocity = [0, 1]
[[body]]
name = "lower"
shape = "box"
size = [0.42, 0.1]
position = [0.546, 0.445]
rotation = 0.4
density = 0.5
)";

// A thin plate, a light ball near another one, a corner that comes near a wall, a capsule across a side.
const std::string mixture = R"(
[[body]]
name = "plate"
shape = "box"
size = [0.62, 0.0107]
position = [0.513, 0.482]
rotation = 0.41
density = 2
[[body]]
name = "ball"
shape = "ball"
radius = 0.11
position = [0.497, 0.741]
density = 0.01
[[body]]
name = "near_ball"
shape = "ball"
radius = 0.07
position = [0.497, 0.9261]
density = 0.5
[[body]]
name = "box"
shape = "box"
size = [0.2, 0.13]
position = [0.8, 0.16]
rotation = 0.7
density = 3
velocity = [0, -0.5]
[[body]]
name = "capsule"
shape = "capsule"
radius = 0.06
length = 0.15
position = [0.12, 0.52]
rotation = 1.1
density = 100
angular_velocity = 3
)";

// A box that lands, balls with a gap and one in contact with the floor.
const std::string landing = R"(
[[body]]
name = "box"
shape = "box"
size = [0.3, 0.2]
position = [0.48, 0.15]
rotation = 0.3
density = 3
velocity = [0, -1]
[[body]]
name = "a"
shape = "ball"
radius = 0.09
position = [0.51, 0.37]
density = 2
velocity = [0.1, -0.5]
[[body]]
name = "b"
shape = "ball"
radius = 0.1
position = [0.51, 0.5601]
density = 2
[[body]]
name = "c"
shape = "ball"
radius = 0.08
position = [0.85, 0.0801]
density = 5
)";

const std::string space_bodies = R"(
[[body]]
name = "box"
shape = "box"
size = [0.3, 0.2, 0.25]
position = [0.47, 0.12, 0.475]
rotation = [0.999, 0.03, 0.01, 0.02]
density = 3
velocity = [0, -1, 0]
[[body]]
name = "plate"
shape = "box"
size = [0.4, 0.09, 0.3]
position = [0.5, 0.72, 0.52]
rotation = [0.9, 0.2, -0.3, 0.1]
density = 0.3
angular_velocity = [1, 2, -1]
[[body]]
name = "ball"
shape = "ball"
radius = 0.12
position = [0.51, 0.35, 0.49]
density = 0.5
[[body]]
name = "near_ball"
shape = "ball"
radius = 0.1
position = [0.2, 0.35001, 0.8]
density = 2
velocity = [1, 0, -1]
)";

// Without mouths: balls with a gap, one close to the floor, a capsule and a thin plate in cells of all ranks.
const std::string space_balls = R"(
[[body]]
name = "plate"
shape = "box"
size = [0.4, 0.02, 0.3]
position = [0.5, 0.72, 0.52]
rotation = [0.9, 0.2, -0.3, 0.1]
density = 0.3
angular_velocity = [1, 2, -1]
[[body]]
name = "low"
shape = "ball"
radius = 0.12
position = [0.51, 0.122, 0.49]
density = 2
[[body]]
name = "ball"
shape = "ball"
radius = 0.1
position = [0.51, 0.344, 0.49]
density = 0.5
[[body]]
name = "capsule"
shape = "capsule"
radius = 0.1
length = 0.3
position = [0.2, 0.35001, 0.53]
rotation = [0.9, 0.1, 0.6, 0.1]
density = 2
velocity = [1, 0, -1]
)";

template <int D>
std::vector<Twist<D>> random_twists(std::size_t count)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> number(-1, 1);
    std::vector<Twist<D>> twists(count);
    for (Twist<D>& twist : twists)
        for (int k = 0; k < twist_size<D>; ++k)
            twist[k] = number(random);
    return twists;
}

/// What follows from places and twists before and after a small motion.
template <int D>
struct Found {
    std::vector<Twist<D>> impulse, force, closed_form;
    double energy;
    std::vector<std::pair<int, int>> displaced;
    EnergyChange change;
    std::vector<double> nodes;
    double limit, divergence;
};

template <int D>
Found<D> find(const Scene& scene, const Communicator& comm)
{
    const Model<D> model(scene, comm, Task::motion);
    std::vector<Twist<D>> V = random_twists<D>(model.bodies.size());
    std::vector<RigidBody<D>> moved = model.bodies;
    for (std::size_t b = 0; b < moved.size(); ++b) {
        const Twist<D> way = 0.02 * scene.spacing() * V[b];
        displace<D>(moved[b], way.template head<D>(), way.template tail<spin_size<D>>());
    }
    V.resize(model.bodies.size() + model.walls.solids.size(), Twist<D>::Zero());
    std::vector<Twist<D>> next = V;
    for (Twist<D>& twist : next)
        twist *= 1.1;
    SolverOptions options;
    options.tolerance = 1e-13;
    auto before = placed(model, model.bodies, model.masses(model.bodies, 0.0)),
         after = placed(model, moved, model.masses(moved, 0.0));
    PotentialFlow<D> flow = flow_of_twists(*before, V, options), flow_after = flow_of_twists(*after, next, options);
    Found<D> found;
    found.change = energy_change(*before, flow, *after, flow_after);
    State<D> state(model);
    found.limit = limit_of_closing<D>(model, state, before->coupling.solids, V, V, own_arms(*before), 0.02);
    found.nodes.assign(flow.p.nodes.begin(), flow.p.nodes.end());
    Instant<D> instant = instant_of<D>(model, model.bodies, std::move(before), std::move(flow));
    found.impulse = instant.impulse;
    found.force = instant.force;
    found.energy = instant.energy;
    for (const Displaced<D>& one : instant.displaced)
        found.displaced.emplace_back(one.solid, one.component);
    found.divergence = largest_divergence(instant, face_velocities(instant));
    instant.displaced.clear();
    find_forces(instant);
    found.closed_form = instant.force;
    return found;
}

template <int D>
void expect_one_instant(const Scene& scene)
{
    const Found<D> here = find<D>(scene, Communicator()), alone = find<D>(scene, Communicator(MPI_COMM_SELF));
    const auto expect_near = [&](const std::vector<Twist<D>>& a, const std::vector<Twist<D>>& b, double accuracy,
                                 const char* what) {
        ASSERT_EQ(a.size(), b.size());
        double scale = 0;
        for (const Twist<D>& twist : b)
            scale = std::max(scale, twist.norm());
        for (std::size_t s = 0; s < a.size(); ++s)
            EXPECT_LT((a[s] - b[s]).norm(), accuracy * scale)
                << what << " " << s << ": " << a[s].transpose() << ", " << b[s].transpose();
    };
    expect_near(here.impulse, alone.impulse, 1e-9, "impulse");
    expect_near(here.closed_form, alone.closed_form, 1e-9, "force");
    expect_near(here.force, alone.force, 1e-5, "force"); // of displaced bodies
    EXPECT_NEAR(here.energy, alone.energy, 1e-10 * alone.energy);
    EXPECT_EQ(here.displaced, alone.displaced);
    EXPECT_EQ(here.change.group, alone.change.group);
    ASSERT_EQ(here.change.work.size(), alone.change.work.size());
    for (std::size_t k = 0; k < here.change.work.size(); ++k)
        EXPECT_NEAR(here.change.work[k], alone.change.work[k], 1e-10 * alone.energy) << k;
    EXPECT_NEAR(here.limit, alone.limit, 1e-12 * alone.limit);
    EXPECT_NEAR(here.divergence, alone.divergence, 1e-6 * alone.divergence + 1e-8);
    ASSERT_EQ(here.nodes.size(), alone.nodes.size()); // in the same order
    double largest = 0;
    for (const double p : alone.nodes)
        largest = std::max(largest, std::abs(p));
    for (std::size_t k = 0; k < here.nodes.size(); ++k)
        EXPECT_NEAR(here.nodes[k], alone.nodes[k], 1e-8 * largest) << k;
}

TEST(StepRanks, AnInstantOfTwoPlates)
{
    expect_one_instant<2>(scene_of(plane, plates));
}

TEST(StepRanks, AnInstantOfAPlane)
{
    expect_one_instant<2>(scene_of(plane, mixture));
    expect_one_instant<2>(scene_of(plane + sides(2, "open"), mixture));
    expect_one_instant<2>(scene_of(plane + sides(2, "far"), mixture));
}

TEST(StepRanks, AnInstantOfAPeriodicPlane)
{
    expect_one_instant<2>(scene_of(plane + sides(2, "periodic"), mixture));
    std::string few = plane;
    few.replace(few.find("[32, 32]"), 8, "[14, 14]"); // a rank of half the domain has some cells twice
    expect_one_instant<2>(scene_of(few + sides(2, "periodic"), landing));
}

TEST(StepRanks, AnInstantOfABox)
{
    expect_one_instant<3>(scene_of(space, space_bodies));
}

TEST(StepRanks, AnInstantOfAPeriodicBox)
{
    expect_one_instant<3>(scene_of(space + sides(3, "periodic"), space_bodies));
}

/// Of a mesh: area, and the sums over it of thickness and speed.
template <int D>
std::array<double, 3> sums_of(const GapMeshes<D>& mesh)
{
    std::array<double, 3> sums{};
    for (std::size_t k = 0; k < mesh.elements.size(); ++k) {
        sums[0] += mesh.area[k];
        sums[1] += mesh.area[k] * mesh.velocity[k].norm();
        for (const int node : mesh.elements[k])
            sums[2] += mesh.area[k] * mesh.thickness[node];
    }
    return sums;
}

TEST(StepRanks, GapsAreThoseOfOneRank)
{
    const Scene scene =
        scene_of(space, space_balls); // with mouths pressures are as far apart as the forces found by differences
    Simulation<3> here(scene, Communicator()), alone(scene, Communicator(MPI_COMM_SELF));
    here.step(100);
    alone.step(100);
    const GapMeshes<3> a = here.gap_meshes(), b = alone.gap_meshes();
    EXPECT_EQ(a.solids, b.solids);
    EXPECT_EQ(a.elements.size(), b.elements.size());
    const auto sums = sums_of(a), expected = sums_of(b);
    for (std::size_t k = 0; k < sums.size(); ++k)
        EXPECT_NEAR(sums[k], expected[k], 1e-6 * std::abs(expected[k])) << k;
    const std::vector<GapState> gaps = here.gaps(), others = alone.gaps();
    ASSERT_EQ(gaps.size(), others.size());
    ASSERT_GT(gaps.size(), 1u);
    for (std::size_t k = 0; k < gaps.size(); ++k) {
        EXPECT_EQ(gaps[k].body_b, others[k].body_b);
        EXPECT_EQ(gaps[k].film_nodes, others[k].film_nodes);
        EXPECT_NEAR(gaps[k].film_area, others[k].film_area, 1e-10 * others[k].film_area);
        EXPECT_NEAR(gaps[k].thickness, others[k].thickness, 1e-8 * scene.spacing());
        EXPECT_NEAR(gaps[k].force, others[k].force, 1e-5 * std::abs(others[k].force) + 1e-9);
    }
}

template <int D>
void expect_same(const Simulation<D>& a, const Simulation<D>& b, double dt, double accuracy)
{
    EXPECT_NEAR(a.time(), b.time(), accuracy * b.time());
    EXPECT_EQ(a.steps(), b.steps());
    double speed = 0, force = 0, momentum = 0;
    for (std::size_t k = 0; k < b.bodies().size(); ++k) {
        speed = std::max(speed, b.bodies()[k].twist.norm());
        force = std::max(force, b.fluid_wrenches()[k].norm());
        momentum = std::max(momentum, gapflow::momentum(b.bodies()[k]).norm());
    }
    for (std::size_t k = 0; k < b.bodies().size(); ++k) {
        EXPECT_LT((a.bodies()[k].centre() - b.bodies()[k].centre()).norm(), accuracy) << k;
        EXPECT_LT((a.bodies()[k].twist - b.bodies()[k].twist).norm(), accuracy * speed) << k;
        EXPECT_LT(dt * (a.fluid_wrenches()[k] - b.fluid_wrenches()[k]).norm(), accuracy * (momentum + dt * force)) << k;
    }
}

void expect_same(const StepReport& a, const StepReport& b, double accuracy)
{
    const double energy = b.energy_fluid + b.energy_bodies;
    EXPECT_NEAR(a.dt, b.dt, accuracy * b.dt);
    EXPECT_NEAR(a.energy_fluid, b.energy_fluid, accuracy * energy);
    EXPECT_NEAR(a.energy_bodies, b.energy_bodies, accuracy * energy);
    EXPECT_NEAR(a.corrected_energy, b.corrected_energy, accuracy * energy);
    EXPECT_EQ(a.solves, b.solves);
    EXPECT_EQ(a.cells, b.cells);
    EXPECT_EQ(a.notes, b.notes);
    EXPECT_LT(a.divergence_max, 1e-6);
}

template <int D>
using Velocity = std::function<Vec<D>(const Vec<D>&)>;

/// `velocity`: of the fluid; null: the scene's.
template <int D>
std::unique_ptr<Simulation<D>> start_of(const Scene& scene, const Communicator& comm, const Velocity<D>& velocity)
{
    return velocity ? std::make_unique<Simulation<D>>(scene, comm, velocity) : std::make_unique<Simulation<D>>(scene, comm);
}

/// Also on all ranks from the state of one, and the other way around.
template <int D>
void expect_one_run(const Scene& scene, int steps, double accuracy = 1e-8, const Velocity<D>& velocity = {})
{
    const Communicator one(MPI_COMM_SELF), all;
    const auto ours_from_start = start_of<D>(scene, all, velocity), theirs_from_start = start_of<D>(scene, one, velocity);
    Simulation<D>&here = *ours_from_start, &alone = *theirs_from_start;
    expect_same(here.initial_report(), alone.initial_report(), accuracy);
    for (int k = 0; k < steps && !all.any(testing::Test::HasFailure()); ++k) {
        SCOPED_TRACE("step " + std::to_string(k + 1));
        const StepReport ours = here.step(100), theirs = alone.step(100);
        expect_same(ours, theirs, accuracy);
        expect_same(here, alone, theirs.dt, accuracy);
    }
    Simulation<D> on(scene, all, alone.state());
    const StoredState stored = here.state();
    std::optional<Simulation<D>> back; // fields of a state are on the root
    if (all.root())
        back.emplace(scene, one, stored);
    for (int k = 0; k < 2 && !all.any(testing::Test::HasFailure()); ++k) {
        SCOPED_TRACE("after a restart, step " + std::to_string(k + 1));
        const double dt = alone.step(100).dt;
        on.step(100);
        expect_same(on, alone, dt, accuracy);
        if (back) {
            back->step(100);
            expect_same(*back, alone, dt, accuracy);
        }
    }
}

// Differences between displaced places enlarge those in the last bits of the places, and the plates start to spin.
TEST(StepRanks, TwoPlates)
{
    expect_one_run<2>(scene_of(plane, plates), 1, 1e-5);
}

TEST(StepRanks, BodiesInAPlane)
{
    expect_one_run<2>(scene_of(plane, mixture), 4);
}

TEST(StepRanks, ABoxLands)
{
    expect_one_run<2>(scene_of(plane, landing), 8);
}

TEST(StepRanks, BodiesInAPeriodicPlane)
{
    expect_one_run<2>(scene_of(still_plane + sides(2, "periodic"), mixture), 4);
}

// Wider cells outside the middle of the domain, of which a rank has half.
const std::string graded = "gravity = [0.3, -1]\n[domain]\nsize = [2, 2]\norigin = [-0.5, -0.5]\nspacing = 0.03125\n"
                           "core.low = [0, 0]\ncore.high = [1, 1]\n";
const std::string middle = R"(
[[body]]
name = "a"
shape = "ball"
radius = 0.11
position = [0.45, 0.51]
density = 2
velocity = [0.5, 0.2]
[[body]]
name = "b"
shape = "ball"
radius = 0.1
position = [0.665, 0.52]
density = 0.1
[[body]]
name = "plate"
shape = "box"
size = [0.4, 0.02]
position = [0.5, 0.75]
rotation = 0.3
density = 2
angular_velocity = 1
)";

TEST(StepRanks, BodiesInAGradedPlane)
{
    expect_one_instant<2>(scene_of(graded, middle));
    expect_one_run<2>(scene_of(graded, middle), 3);
    expect_one_run<2>(scene_of(graded + sides(2, "far"), middle), 3);
}

const std::string inflow = "[domain.sides]\nx_low = { inflow = [0.4, 0] }\nx_high = \"open\"\n";
const std::string pressures = "[domain.sides]\nx_low = { pressure = 0.7 }\nx_high = { pressure = 0.1 }\n";
// Through both sides, with gaps there.
const std::string in_sides =
    "[[body]]\nname = \"a\"\nshape = \"ball\"\nradius = 0.11\nposition = [0.03, 0.41]\ndensity = 2\nvelocity = [0.5, 0.2]\n"
    "[[body]]\nname = \"b\"\nshape = \"ball\"\nradius = 0.1\nposition = [0.04, 0.628]\ndensity = 0.5\n"
    "[[body]]\nname = \"plate\"\nshape = \"box\"\nsize = [0.4, 0.02]\nposition = [0.9, 0.511]\nrotation = 0.3\n"
    "density = 2\nangular_velocity = 1\n";

TEST(StepRanks, BodiesInAChannel)
{
    for (const std::string& ends : {inflow, pressures}) {
        expect_one_run<2>(scene_of(plane + ends, mixture), 2);
        expect_one_run<2>(scene_of(still_plane + ends, in_sides), 3);
    }
}

TEST(StepRanks, BodiesFallAlongPeriodicAxes)
{
    expect_one_run<2>(scene_of(plane + sides(2, "periodic"), mixture), 3);
}

TEST(StepRanks, AGridThatFollows)
{
    expect_one_run<2>(scene_of(still_plane + "follow = \"plate\"\n" + sides(2, "far"), mixture), 1);
    expect_one_run<2>(scene_of(graded + "follow = \"plate\"\n" + sides(2, "far"), middle), 3);
}

// A box and a disk with a gap, and the disk with one to the floor, across x = 1/2 and y = 1/2 in a vortex.
const std::string in_vortex = R"(
[[body]]
name = "box"
shape = "box"
size = [0.3, 0.12]
position = [0.52, 0.505]
rotation = 0.2
density = 2
[[body]]
name = "disk"
shape = "ball"
radius = 0.11
position = [0.497, 0.318]
density = 0.5
[[body]]
name = "low"
shape = "ball"
radius = 0.1
position = [0.497, 0.1004]
density = 2
)";

Vec<2> vortex(const Vec<2>& x)
{
    const double pi = std::numbers::pi;
    return {std::sin(pi * x[0]) * std::cos(pi * x[1]), -std::cos(pi * x[0]) * std::sin(pi * x[1])};
}

Vec<2> vortices(const Vec<2>& x)
{
    return Vec<2>(0.5, 0.3) + vortex(2 * x);
}

Vec<3> vortex_in_space(const Vec<3>& x)
{
    const Vec<2> u = vortex(x.head<2>());
    return {u[0] * x[2], u[1] * x[2], 0};
}

TEST(StepRanks, BodiesInAVortex)
{
    expect_one_run<2>(scene_of(plane, in_vortex), 4, 1e-8, vortex);
    expect_one_run<2>(scene_of(graded, middle), 2, 1e-8, vortex); // with a velocity through its walls
    expect_one_run<2>(scene_of(still_plane + sides(2, "far"), mixture), 2, 1e-8, vortex);
    expect_one_run<2>(scene_of(plane, plates), 1, 1e-5, vortex); // with mouths
}

TEST(StepRanks, BodiesInPeriodicVortices)
{
    expect_one_run<2>(scene_of(still_plane + sides(2, "periodic"), in_vortex), 4, 1e-8, vortices);
}

// Which leave through its sides.
TEST(StepRanks, AGridThatFollowsInVortices)
{
    for (const char* kind : {"far", "open"})
        expect_one_run<2>(scene_of(still_plane + "follow = \"disk\"\n" + sides(2, kind), in_vortex), 3, 1e-8, vortices);
}

TEST(StepRanks, BodiesInAVortexInSpace)
{
    expect_one_run<3>(scene_of(space, space_balls), 1, 1e-8, vortex_in_space);
}

// On the same number of ranks to the last bit.
template <int D>
void expect_same_bits(const Scene& scene, const Velocity<D>& velocity = {})
{
    const Communicator all;
    const auto from_start = start_of<D>(scene, all, velocity);
    Simulation<D>& whole = *from_start;
    for (int k = 0; k < 2; ++k)
        whole.step(100);
    Simulation<D> on(scene, all, whole.state());
    for (int k = 0; k < 2; ++k) {
        whole.step(100);
        on.step(100);
    }
    const StoredState a = whole.state(), b = on.state();
    EXPECT_EQ(a.numbers, b.numbers);
    EXPECT_EQ(a.integers, b.integers);
    EXPECT_EQ(a.fields, b.fields);
}

TEST(StepRanks, GoOnBitForBit)
{
    expect_same_bits<2>(scene_of(plane, landing));
    expect_same_bits<2>(scene_of(still_plane + "[domain.sides]\nx_low = \"periodic\"\nx_high = \"periodic\"\n", landing));
    expect_same_bits<2>(scene_of(graded + sides(2, "far"), middle));
    expect_same_bits<2>(scene_of(plane + inflow, landing));
    expect_same_bits<2>(scene_of(plane, in_vortex), vortex);
    expect_same_bits<2>(scene_of(graded + "follow = \"b\"\n" + sides(2, "far"), middle));
    expect_same_bits<3>(scene_of(space + sides(3, "open"), space_balls));
}

TEST(StepRanks, BodiesInABox)
{
    expect_one_run<3>(scene_of(space, space_balls), 2);
}

} // namespace
} // namespace gapflow
