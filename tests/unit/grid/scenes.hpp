// Small scenes for the tests of face fractions.
#pragma once

#include "gapflow/grid/body_flux.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace gapflow::testing {

template <int D>
std::array<SideKind, 2 * D> all_sides(SideKind kind)
{
    std::array<SideKind, 2 * D> sides;
    sides.fill(kind);
    return sides;
}

/// Cells per side over [0, 1]^D, on this process alone.
template <int D>
Grid<D> unit_grid(int cells, const std::array<SideKind, 2 * D>& sides = all_sides<D>(SideKind::wall))
{
    return Grid<D>(Vec<D>::Zero(), 1.0 / cells, Index<D>::Constant(cells), sides, 2, Communicator(MPI_COMM_SELF));
}

template <int D>
Pose<D> pose(const Vec<D>& position, double angle = 0)
{
    Pose<D> p;
    p.position = position;
    if constexpr (D == 2)
        p.rotation = Rotation<2>(angle);
    else
        p.rotation = Rotation<3>(Eigen::AngleAxisd(angle, Vec<3>(1, 2, -1).normalized()));
    return p;
}

inline std::string numbered(std::string name, int number)
{
    return name.append(std::to_string(number));
}

/// Owns shapes, lists solids; the walls of the grid's closed sides come with it.
template <int D>
class Scene {
public:
    explicit Scene(const Grid<D>& grid)
    {
        for (int side = 0; side < 2 * D; ++side) {
            const int axis = side / 2, end = side % 2;
            if (grid.side(axis, end) != SideKind::wall)
                continue;
            Vec<D> on = grid.origin() + 0.5 * grid.size();
            on[axis] = grid.origin()[axis] + end * grid.size()[axis];
            add(numbered("wall", side), make_half_space<D>((end ? -1 : 1) * unit<D>(axis)), pose<D>(on), true);
        }
    }
    /// Index of the new solid.
    int add(const std::string& name, std::unique_ptr<Shape<D>> shape, const Pose<D>& at, bool wall = false)
    {
        shapes_.push_back(std::move(shape));
        solids.push_back({name, PlacedShape<D>(*shapes_.back(), at), at.position, Motion::fixed, wall});
        return static_cast<int>(solids.size()) - 1;
    }

    std::vector<Solid<D>> solids;

private:
    std::vector<std::unique_ptr<Shape<D>>> shapes_;
};

/// A shape that counts how often it is asked about places.
template <int D>
class Counting final : public Shape<D> {
public:
    Counting(std::unique_ptr<Shape<D>> shape, long& count) : shape_(std::move(shape)), count_(count) {}
    SurfacePoint<D> closest(const Vec<D>& x) const override { return ++count_, shape_->closest(x); }
    double distance(const Vec<D>& x) const override { return ++count_, shape_->distance(x); }
    Vec<D> onto(const Vec<D>& x, int patch) const override { return ++count_, shape_->onto(x, patch); }
    Vec<D> patch_normal(const Vec<D>& x, int patch) const override { return ++count_, shape_->patch_normal(x, patch); }
    double curvature(int patch) const override { return shape_->curvature(patch); }
    SurfaceMesh<D> surface_mesh() const override { return shape_->surface_mesh(); }
    SurfaceMesh<D> display_mesh(double tolerance) const override { return shape_->display_mesh(tolerance); }
    MassProperties<D> mass_properties() const override { return shape_->mass_properties(); }
    Bounds<D> bounds() const override { return shape_->bounds(); }
    bool convex() const override { return shape_->convex(); }

private:
    std::unique_ptr<Shape<D>> shape_;
    long& count_;
};

/// Fraction of a face in one solid, all its images together.
template <int D>
double fraction_in(const ClippedFace<D>& face, int solid)
{
    double sum = 0;
    for (const SolidPart<D>& part : face.solid)
        if (part.solid == solid)
            sum += part.fraction;
    return sum;
}

template <int D>
ClippedFace<D> clipped(const FaceClipper<D>& clipper, int axis, const Index<D>& face)
{
    ClippedFace<D> result;
    clipper.clip(axis, face, result);
    return result;
}

/// Calls f(axis, face) for all faces of the domain.
template <int D, class F>
void for_each_domain_face(const Grid<D>& grid, F&& f)
{
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(grid.low(), owned_faces_end(grid, axis), [&](const Index<D>& face) { f(axis, face); });
}

/// Volume of a solid inside the domain: the divergence theorem for the field x_axis e_axis over the hulls of all cells, which is
/// the sum over the faces normal to the axis of s |f| dx.
template <int D>
double volume_of(const Grid<D>& grid, const FaceClipper<D>& clipper, int solid, int axis)
{
    double sum = 0;
    for_each_index<D>(grid.low(), owned_faces_end(grid, axis),
                      [&](const Index<D>& face) { sum += fraction_in(clipped(clipper, axis, face), solid); });
    return sum * std::pow(grid.dx(), D);
}

/// Everything that must hold for any scene: sums of parts, agreement of clip() and face_fractions(), closed hulls, no net flux
/// of solids that lie inside the domain.
template <int D>
void check_identities(const Grid<D>& grid, const Scene<D>& scene, FractionMode mode, const std::vector<int>& interior,
                      double tolerance = 1e-12)
{
    const FaceClipper<D> clipper(grid, scene.solids, mode);
    const FaceFractions<D> fractions = face_fractions(grid, clipper);
    const double half = 0.5 * grid.dx() * (1 + 1e-9);

    for_each_domain_face<D>(grid, [&](int axis, const Index<D>& face) {
        const ClippedFace<D> parts = clipped(clipper, axis, face);
        double sum = parts.open;
        const Vec<D> centre = grid.face_centre(axis, face);
        Vec<D> moment = parts.open * (parts.open_centroid - centre);
        for (const SolidPart<D>& part : parts.solid) {
            ASSERT_GT(part.fraction, 0);
            ASSERT_LE((part.centroid - centre).cwiseAbs().maxCoeff(), half);
            sum += part.fraction;
            moment += part.fraction * (part.centroid - centre);
        }
        ASSERT_NEAR(sum, 1, 1e-13) << "axis " << axis << " face " << face.transpose();
        ASSERT_LE(moment.norm(), 1e-12 * grid.dx()) << "axis " << axis << " face " << face.transpose();
        ASSERT_LE((parts.open_centroid - centre).cwiseAbs().maxCoeff(), half);

        ASSERT_EQ(fractions.open(axis, face), parts.open) << "axis " << axis << " face " << face.transpose();
        const int cut = fractions.cut(axis, face);
        if (cut < 0) {
            ASSERT_TRUE(parts.open == 1 || (parts.open == 0 && parts.solid.size() == 1));
            return;
        }
        const ClippedFace<D>& entry = fractions.faces[cut];
        ASSERT_EQ(entry.solid.size(), parts.solid.size());
        ASSERT_EQ(entry.open_centroid, parts.open_centroid);
        for (std::size_t i = 0; i < parts.solid.size(); ++i) {
            ASSERT_EQ(entry.solid[i].solid, parts.solid[i].solid);
            ASSERT_EQ(entry.solid[i].fraction, parts.solid[i].fraction);
            ASSERT_EQ(entry.solid[i].arm, parts.solid[i].arm);
        }
    });

    std::mt19937 random(3);
    std::uniform_real_distribution<double> number(-1, 1);
    Twist<D> common; // of all solids, about the origin
    for (int i = 0; i < twist_size<D>; ++i)
        common[i] = number(random);
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
        double flux = 0, scale = 0;
        bool periodic_image = false;
        for_each_body_flux(grid, fractions, c, [&](int solid, const Twist<D>& row) {
            Twist<D> own = common; // about the centre of the solid
            own.template head<D>() = velocity_at<D>(common, scene.solids[solid].centre);
            flux += row.dot(own);
            scale += row.norm();
        });
        for (int side = 0; side < 2 * D; ++side) {
            const Index<D> face = c + (side % 2) * step<D>(side / 2);
            const int cut = fractions.cut(side / 2, face);
            const double open = fractions.open(side / 2, face);
            if (cut >= 0)
                for (const SolidPart<D>& part : fractions.faces[cut].solid)
                    periodic_image |= (part.centroid - part.arm - scene.solids[part.solid].centre).norm() > 0.01 * grid.dx();
            const Vec<D> x = cut >= 0 ? fractions.faces[cut].open_centroid : grid.face_centre(side / 2, face);
            flux += open * grid.face_area() * (2 * (side % 2) - 1) * velocity_at<D>(common, x)[side / 2];
        }
        if (!periodic_image) {
            ASSERT_NEAR(flux / grid.face_area(), 0, tolerance) << "cell " << c.transpose();
        }
    });

    const auto sums = sum_of_body_flux(grid, fractions, static_cast<int>(scene.solids.size()));
    for (int solid : interior)
        EXPECT_LE(sums[solid].norm() / grid.face_area(), 1e-11) << scene.solids[solid].name;
}

/// The solid moved by a small twist about its reference point (lengths in cells).
template <int D>
Solid<D> moved(Solid<D> solid, int component, double step, double dx)
{
    const Mat<D> rotation = solid.shape.rotation();
    Vec<D> position = solid.shape.to_world(Vec<D>::Zero());
    Rotation<D> turn = Rotation<D>::Identity();
    if (component < D) {
        position[component] += step * dx;
        solid.centre[component] += step * dx;
    } else {
        if constexpr (D == 2)
            turn = Rotation<2>(step);
        else
            turn = Rotation<3>(Eigen::AngleAxisd(step, unit<3>(component - 3)));
        position = solid.centre + turn * (position - solid.centre);
    }
    Pose<D> pose;
    pose.position = position;
    if constexpr (D == 2)
        pose.rotation = turn * Rotation<2>(std::atan2(rotation(1, 0), rotation(0, 0)));
    else
        pose.rotation = turn * Rotation<3>(rotation);
    solid.shape = PlacedShape<D>(solid.shape.shape(), pose);
    return solid;
}

} // namespace gapflow::testing
