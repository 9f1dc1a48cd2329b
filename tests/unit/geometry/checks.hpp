// Properties that every shape must have, and meshes to read.
#pragma once

#include "gapflow/geometry/mesh_mass.hpp"
#include "gapflow/geometry/shape.hpp"

#include "temporary.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <random>
#include <string>

namespace gapflow::testing {

template <int D>
Vec<D> random_point(std::mt19937& random, double reach)
{
    std::uniform_real_distribution<double> coordinate(-reach, reach);
    Vec<D> x;
    for (int i = 0; i < D; ++i)
        x[i] = coordinate(random);
    return x;
}

/// At random points: the closest point is on the surface and at the distance told, the normal points from it to the query
/// (unless `facets`: normals of a mesh's smooth edges do so roughly), distance() agrees and its gradient is the normal.
template <int D>
void check_distances(const Shape<D>& shape, double reach, int points = 1000, bool facets = false)
{
    std::mt19937 random(7);
    const double tolerance = 1e-14 * reach, step = 1e-6 * reach;
    for (int k = 0; k < points; ++k) {
        const Vec<D> x = random_point<D>(random, reach);
        const SurfacePoint<D> p = shape.closest(x);
        SCOPED_TRACE(::testing::Message() << "x = " << x.transpose());
        ASSERT_NEAR(std::abs(p.distance), (x - p.x).norm(), tolerance);
        ASSERT_NEAR(shape.distance(x), p.distance, tolerance);
        ASSERT_NEAR(shape.distance(p.x), 0, 2 * tolerance);
        ASSERT_NEAR(p.normal.norm(), 1, 1e-14);
        if (facets) {
            ASSERT_GT(p.normal.dot(x - p.x) * p.distance, 0.8 * p.distance * p.distance);
        } else {
            ASSERT_LT((x - p.x - p.distance * p.normal).norm(), tolerance);
        }
        if (p.feature == Feature::face) {
            ASSERT_LT((shape.onto(p.x, p.patch) - p.x).norm(), tolerance);
            if (!facets) {
                ASSERT_LT((shape.patch_normal(p.x, p.patch) - p.normal).norm(), 1e-12);
            }
        }
        if (std::abs(p.distance) < 0.05 * reach)
            continue; // the medial axis or the surface could lie between the points of the difference
        Vec<D> gradient;
        for (int i = 0; i < D; ++i)
            gradient[i] = (shape.distance(x + step * unit<D>(i)) - shape.distance(x - step * unit<D>(i))) / (2 * step);
        if (p.distance > 0) {
            ASSERT_LT((gradient - (x - p.x) / p.distance).norm(), 1e-4);
        }
    }
}

/// A closed, consistently oriented mesh with its vertices on the surface and volume positive (negative inside out).
template <int D>
void check_mesh(const Shape<D>& shape, const SurfaceMesh<D>& mesh, double size)
{
    ASSERT_EQ(mesh.elements.size(), mesh.patch.size());
    std::map<std::pair<int, int>, int> sides;
    for (const auto& element : mesh.elements)
        for (int i = 0; i < D; ++i)
            if (D == 2)
                sides[{element[i], -1}] += i == 0 ? 1 : 100;
            else
                sides[{element[i], element[(i + 1) % D]}] += 1;
    for (const auto& [side, count] : sides)
        if (D == 2) {
            ASSERT_EQ(count, 101);
        } else {
            ASSERT_EQ(count, 1);
            ASSERT_EQ(sides.count({side.second, side.first}), 1u);
        }
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        ASSERT_NEAR(shape.distance(mesh.vertices[v]), 0, 1e-14 * size);
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        Vec<D> centre = Vec<D>::Zero();
        for (int v : mesh.elements[e])
            centre += mesh.vertices[v] / D;
        const Vec<D> a = mesh.vertices[mesh.elements[e][1]] - mesh.vertices[mesh.elements[e][0]];
        Vec<D> normal;
        if constexpr (D == 2)
            normal = {a[1], -a[0]};
        else
            normal = a.cross(mesh.vertices[mesh.elements[e][2]] - mesh.vertices[mesh.elements[e][0]]);
        const Vec<D> x = shape.onto(centre, mesh.patch[e]);
        ASSERT_NEAR(shape.distance(x), 0, 1e-14 * size);
        ASSERT_GT(normal.normalized().dot(shape.patch_normal(x, mesh.patch[e])), 0.9);
    }
    ASSERT_GT(mass_properties_of(mesh).volume * (shape.complement() ? -1 : 1), 0);
}

/// The integral over a mesh that approaches the surface as its tolerance gives the same mass properties.
template <int D>
void check_mass(const Shape<D>& shape, double tolerance, double bound)
{
    const MassProperties<D> exact = shape.mass_properties(), fine = mass_properties_of(shape.display_mesh(tolerance));
    EXPECT_NEAR(fine.volume, exact.volume, bound * exact.volume);
    EXPECT_LT((fine.centre - exact.centre).norm(), 1e-12);
    EXPECT_LT((fine.inertia - exact.inertia).norm(), 2 * bound * exact.inertia.norm());
}

using test::TemporaryFile;

std::string obj_text(const SurfaceMesh<3>& mesh);
std::string ascii_stl_text(const SurfaceMesh<3>& mesh);
std::string binary_stl_text(const SurfaceMesh<3>& mesh);
/// Torus about z, n around the hole and m around the tube.
SurfaceMesh<3> torus(double large, double small, int n, int m);

template <class Call>
std::string error_of(Call call)
{
    try {
        call();
    } catch (const std::exception& error) {
        return error.what();
    }
    return "no error";
}

} // namespace gapflow::testing
