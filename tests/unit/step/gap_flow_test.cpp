// Meshes half-way between the walls of gaps on parts, and the states of pairs.
#include "unit/step/scenes.hpp"

#include "gapflow/scene/parse_scene.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace gapflow {
namespace {

double sum_of(const std::vector<double>& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0);
}

/// A plate of 0.4 by 0.1 at a height over the floor of a closed box, which rises.
template <int D>
Scene plate_over_a_floor(double gap, double speed)
{
    Scene scene = box_of_fluid(D, 20, SideScene::Kind::wall);
    BodyScene plate = body("plate", BodyScene::ShapeKind::box, {0.513, 0.487, 0.5});
    plate.size = {0.4, 0.4, 0.1};
    plate.size[D - 1] = 0.1;
    plate.position[D - 1] = gap + 0.05;
    plate.velocity = {};
    plate.velocity[D - 1] = speed;
    scene.bodies = {plate};
    scene.max_step = 1e-5;
    return scene;
}

TEST(GapFlow, AFlatGapHasItsThicknessAreaAndVelocity)
{
    const double gap = 0.013, speed = 0.7;
    Simulation<2> simulation(plate_over_a_floor<2>(gap, speed), Communicator());
    simulation.step(100);
    const GapMeshes<2> mesh = simulation.gap_meshes();
    ASSERT_EQ(mesh.solids.size(), 1u);
    EXPECT_NEAR(sum_of(mesh.area), 0.4, 1e-8);
    const double h = simulation.bodies()[0].centre()[1] - 0.05;
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        EXPECT_NEAR(mesh.thickness[i], h, 1e-9);
        EXPECT_NEAR(mesh.nodes[i][1], 0.5 * h, 1e-9);
    }
    const double now = simulation.bodies()[0].twist[1];
    for (std::size_t k = 0; k < mesh.elements.size(); ++k) {
        EXPECT_NEAR(std::abs(mesh.normal[k][1]), 1, 1e-9);
        EXPECT_NEAR(mesh.velocity[k][1], 0, 1e-9);
        const double x = 0.5 * (mesh.nodes[mesh.elements[k][0]][0] + mesh.nodes[mesh.elements[k][1]][0]) - 0.513;
        if (mesh.area[k] > 0.999 / 20) { // whole cells: continuity, but for what goes around the plate
            EXPECT_NEAR(mesh.velocity[k][0], -now * x / h, 0.02 * now * 0.2 / h) << x;
        }
    }
}

TEST(GapFlow, AFlatGapInSpaceHasItsThicknessAndArea)
{
    Simulation<3> simulation(plate_over_a_floor<3>(0.013, 0.7), Communicator());
    simulation.step(100);
    const GapMeshes<3> mesh = simulation.gap_meshes();
    EXPECT_NEAR(sum_of(mesh.area), 0.16, 0.0016); // the plate's corners are cut off
    const double h = simulation.bodies()[0].centre()[2] - 0.05, now = simulation.bodies()[0].twist[2];
    double inward = 0;
    for (std::size_t k = 0; k < mesh.elements.size(); ++k) {
        Vec<3> x = Vec<3>::Zero();
        for (const int node : mesh.elements[k]) {
            EXPECT_NEAR(mesh.thickness[node], h, 1e-9);
            x += mesh.nodes[node] / 3;
        }
        x -= Vec<3>(0.513, 0.487, x[2]);
        inward -= mesh.velocity[k].dot(x) * mesh.area[k];
    }
    // u = grad f with lap f = -k, f = 0 at the border: int u . x = -2 int f, for a square of side a -2 x 0.03514 k a^4 (Prandtl's torsion function).
    const double expected = 2 * 0.03514 * now / h * std::pow(0.4, 4);
    EXPECT_NEAR(inward, expected, 0.03 * expected);
}

TEST(GapFlow, PairsHaveWhatTheirMeshHas)
{
    Scene scene = plate_over_a_floor<2>(0.013, 0.7);
    scene.forces = true;
    scene.gravity = {0, -2, 0};
    Simulation<2> simulation(scene, Communicator());
    simulation.step(100);
    const GapMeshes<2> mesh = simulation.gap_meshes();
    const std::vector<GapState> gaps = simulation.gaps();
    ASSERT_EQ(gaps.size(), 1u);
    EXPECT_EQ(gaps[0].body_a, "plate");
    EXPECT_NEAR(gaps[0].thickness, simulation.bodies()[0].centre()[1] - 0.05, 1e-9);
    EXPECT_NEAR(gaps[0].opening_rate, simulation.bodies()[0].twist[1], 1e-4); // it turns a little
    EXPECT_NEAR(gaps[0].film_area, 0.4, 0.05);                                // parts beside the mouths have walls beyond them
    EXPECT_GE(gaps[0].film_nodes, 8);
    const ForceParts<2>& forces = simulation.force_parts()[0];
    EXPECT_NEAR(forces.buoyancy[1], 2 * 0.04, 1e-12);
    EXPECT_NEAR((forces.fluid() - simulation.fluid_wrenches()[0]).norm(), 0, 1e-12 * simulation.fluid_wrenches()[0].norm());
    double lift = 0; // of the pressure in the mesh, without the hydrostatic part
    for (std::size_t k = 0; k < mesh.elements.size(); ++k)
        for (const int node : mesh.elements[k])
            lift += 0.5 * mesh.area[k] * (mesh.pressure[node] - simulation.hydrostatic(mesh.nodes[node]));
    EXPECT_NEAR(forces.film[1], lift, 0.25 * std::abs(lift)); // pressures in the parts at the gap's ends are of first order
    EXPECT_LE(gaps[0].pressure_min, *std::min_element(mesh.pressure.begin(), mesh.pressure.end()));
    EXPECT_GE(gaps[0].pressure_max, *std::max_element(mesh.pressure.begin(), mesh.pressure.end()));
}

FluxScene whole_plane(double x)
{
    FluxScene flux;
    flux.name = "whole";
    flux.kind = FluxScene::Kind::plane;
    flux.point = {x, 0.5, 0.5};
    flux.normal = {1, 0, 0};
    return flux;
}

TEST(GapFlow, WhatPassesASectionOfAClosedTankIsNothing)
{
    Scene scene = box_of_fluid(2, 24, SideScene::Kind::wall);
    BodyScene lid = body("lid", BodyScene::ShapeKind::box, {0.45, 0.06, 0}, {0.3, 0.1, 0}),
              disk = body("disk", BodyScene::ShapeKind::ball, {0.47, 0.245, 0}, {0, -0.1, 0});
    lid.size = {0.4, 0.1, 0};
    lid.angle = 0.03;
    lid.angular_velocity = {0.5, 0, 0};
    disk.radius = 0.12;
    scene.bodies = {lid, disk};
    scene.tolerance = 1e-12;
    for (const bool with_scene : {false, true}) { // whose fluxes the complex is built for
        scene.fluxes.assign(with_scene ? 1 : 0, whole_plane(0.455));
        Simulation<2> simulation(scene, Communicator());
        simulation.step(100);
        for (const double x : {0.3, 0.455, 0.61}) {
            const VolumeFlux flux = simulation.volume_flux(whole_plane(x));
            EXPECT_GT(flux.inflow, 1e-3);
            EXPECT_NEAR(flux.flux + flux.bodies, 0, 1e-8 * flux.inflow) << x;
        }
    }
}

TEST(GapFlow, AGapTakesInWhatItsWallsOpen)
{
    Scene scene = plate_over_a_floor<2>(0.013, 0.7);
    FluxScene flux;
    flux.kind = FluxScene::Kind::gap;
    flux.bodies = {"plate", "wall:y_low"};
    Simulation<2> simulation(scene, Communicator());
    simulation.step(100);
    const double opening = 0.4 * simulation.bodies()[0].twist[1];
    const VolumeFlux both = simulation.volume_flux(flux);
    EXPECT_NEAR(both.inflow, opening, 0.03 * opening); // to the mouths, and what rounds the edges
    EXPECT_NEAR(both.outflow, 0, 1e-9);
    flux.along = Triple{1, 0, 0};
    EXPECT_NEAR(simulation.volume_flux(flux).flux, 0, 0.05 * opening); // from both sides alike
    flux.bodies = {"plate", "wall:x_low"};
    EXPECT_TRUE(std::isnan(simulation.volume_flux(flux).flux));
}

/// Each edge inside of a mesh has two triangles; those at its end lie where the gap ends, at a thickness of more than `least`.
void expect_closed(const GapMeshes<3>& mesh, double least)
{
    std::map<std::pair<int, int>, int> edges;
    for (const auto& element : mesh.elements)
        for (int k = 0; k < 3; ++k)
            ++edges[std::minmax(element[k], element[(k + 1) % 3])];
    int ends = 0;
    for (const auto& [edge, count] : edges) {
        EXPECT_LE(count, 2);
        if (count == 1) {
            ++ends;
            EXPECT_GT(std::max(mesh.thickness[edge.first], mesh.thickness[edge.second]), least);
        }
    }
    EXPECT_GT(ends, 8);
}

Scene ball_over_a_floor(const Triple& position)
{
    Scene scene = box_of_fluid(3, 16, SideScene::Kind::wall);
    for (int side = 0; side < 4; ++side)
        scene.sides[side].kind = SideScene::Kind::periodic;
    BodyScene ball = body("ball", BodyScene::ShapeKind::ball, position, {0.3, 0, -0.1});
    ball.radius = 0.31;
    scene.bodies = {ball};
    scene.max_step = 1e-3;
    return scene;
}

TEST(GapFlow, ABallOverAFloorHasAClosedMeshOfTheExactThickness)
{
    Simulation<3> simulation(ball_over_a_floor({0.52, 0.49, 0.318}), Communicator());
    const GapMeshes<3> mesh = simulation.gap_meshes();
    ASSERT_GT(mesh.elements.size(), 50u);
    expect_closed(mesh, 0.5 / 16);
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        const Vec<3> from = mesh.nodes[i] - Vec<3>(0.52, 0.49, 0.318);
        const double up = mesh.nodes[i][2], distance = from.norm() - 0.31;
        EXPECT_NEAR(up, distance, 1e-9); // half-way
        const Vec<3> n = (Vec<3>(0, 0, 1) - from.normalized()).normalized();
        const double b = n.dot(from), to_ball = -b - std::sqrt(b * b - from.squaredNorm() + 0.31 * 0.31);
        EXPECT_NEAR(mesh.thickness[i], to_ball + up / n[2], 0.02 * mesh.thickness[i]);
    }
}

TEST(GapFlow, AMeshAcrossAPeriodicSideIsThatInside)
{
    Simulation<3> inside(ball_over_a_floor({0.52, 0.49, 0.318}), Communicator()),
        across(ball_over_a_floor({0.52 - 8.0 / 16, 0.49 + 8.0 / 16, 0.318}), Communicator());
    const GapMeshes<3> a = inside.gap_meshes(), b = across.gap_meshes();
    EXPECT_EQ(a.elements.size(), b.elements.size());
    EXPECT_NEAR(sum_of(a.area), sum_of(b.area), 1e-9 * sum_of(a.area));
    double speed = 0, other = 0;
    for (std::size_t k = 0; k < std::min(a.elements.size(), b.elements.size()); ++k) {
        speed += a.velocity[k].norm() * a.area[k];
        other += b.velocity[k].norm() * b.area[k];
    }
    EXPECT_GT(speed, 0);
    EXPECT_NEAR(speed, other, 1e-6 * speed);
}

} // namespace
} // namespace gapflow
