// Ball (2D: disk) about the origin: distance |x| - r, exact to the rounding of |x|. One patch.
#include "gapflow/geometry/requirement.hpp"
#include "gapflow/geometry/revolve.hpp"
#include "gapflow/geometry/shape.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace gapflow {
namespace {

/// Icosahedron in the unit sphere, symmetric under reflection in the three coordinate planes.
SurfaceMesh<3> icosahedron()
{
    const double g = std::numbers::phi, length = std::sqrt(1 + g * g), a = 1 / length, b = g / length;
    return {{{-a, b, 0},
             {a, b, 0},
             {-a, -b, 0},
             {a, -b, 0},
             {0, -a, b},
             {0, a, b},
             {0, -a, -b},
             {0, a, -b},
             {b, 0, -a},
             {b, 0, a},
             {-b, 0, -a},
             {-b, 0, a}},
            {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
             {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
             {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}},
            std::vector<int>(20, 0)};
}

/// Each triangle into four, new vertices on the unit sphere.
SurfaceMesh<3> subdivided(const SurfaceMesh<3>& coarse)
{
    SurfaceMesh<3> fine{coarse.vertices, {}, {}};
    std::map<std::pair<int, int>, int> middle_of;
    const auto middle = [&](int i, int j) {
        const auto [entry, added] = middle_of.try_emplace(std::minmax(i, j), int(fine.vertices.size()));
        if (added)
            fine.vertices.push_back((coarse.vertices[i] + coarse.vertices[j]).normalized());
        return entry->second;
    };
    for (const auto& [i, j, k] : coarse.elements) {
        const int a = middle(j, k), b = middle(k, i), c = middle(i, j);
        fine.elements.insert(fine.elements.end(), {{i, c, b}, {c, j, a}, {b, a, k}, {a, b, c}});
    }
    fine.patch.assign(fine.elements.size(), 0);
    return fine;
}

template <int D>
class Ball final : public Shape<D> {
public:
    explicit Ball(double radius) : radius_(radius) {}

    SurfacePoint<D> closest(const Vec<D>& x) const override
    {
        const double r = x.norm();
        const Vec<D> n = r > 0 ? Vec<D>(x / r) : unit<D>(0);
        return {radius_ * n, n, r - radius_, Feature::face, 0};
    }
    double distance(const Vec<D>& x) const override { return x.norm() - radius_; }
    std::optional<double> entry(const Vec<D>& x, const Vec<D>& u) const override
    {
        const double towards = -x.dot(u), reach = (x + towards * u).squaredNorm(), r2 = radius_ * radius_;
        if (towards <= 0 || reach >= r2)
            return std::numeric_limits<double>::infinity();
        const double r = x.norm(); // the nearer root, without the difference of nearly equal numbers
        return std::max((r - radius_) * (r + radius_), 0.0) / (towards + std::sqrt(r2 - reach));
    }
    Vec<D> onto(const Vec<D>& x, int) const override { return closest(x).x; }
    Vec<D> patch_normal(const Vec<D>& x, int) const override { return closest(x).normal; }
    double curvature(int) const override { return 1 / radius_; }
    std::optional<double> sphere_radius() const override { return radius_; }
    std::vector<Core<D>> cores() const override { return {{Vec<D>::Zero(), Vec<D>::Zero(), radius_}}; }

    SurfaceMesh<D> surface_mesh() const override
    {
        if constexpr (D == 2)
            return circle(16);
        else // 80 triangles, edges of 32 and 36 degrees
            return scaled(subdivided(icosahedron()));
    }

    SurfaceMesh<D> display_mesh(double tolerance) const override
    {
        if constexpr (D == 2)
            return circle(chords_around(radius_, tolerance));
        else {
            // The circumradius of the largest triangle is 0.365 radians at level 1 and halves with each level.
            SurfaceMesh<3> mesh = subdivided(icosahedron());
            double angle = 0.37;
            for (int level = 1; level < 7 && radius_ * (1 - std::cos(angle)) > tolerance; ++level, angle /= 2)
                mesh = subdivided(mesh);
            return scaled(std::move(mesh));
        }
    }

    MassProperties<D> mass_properties() const override
    {
        constexpr double pi = std::numbers::pi;
        const double r2 = radius_ * radius_;
        MassProperties<D> mass{D == 2 ? pi * r2 : 4. / 3 * pi * r2 * radius_, Vec<D>::Zero(), {}};
        mass.inertia.setIdentity();
        mass.inertia *= mass.volume * r2 * (D == 2 ? 1. / 2 : 2. / 5);
        return mass;
    }

    Bounds<D> bounds() const override { return {Vec<D>::Constant(-radius_), Vec<D>::Constant(radius_)}; }

private:
    SurfaceMesh<D> scaled(SurfaceMesh<D> mesh) const
    {
        for (Vec<D>& x : mesh.vertices)
            x *= radius_;
        return mesh;
    }

    SurfaceMesh<2> circle(int n) const
    {
        SurfaceMesh<2> mesh;
        for (int i = 0; i < n; ++i) {
            mesh.vertices.push_back(radius_ * circle_point(i, n));
            mesh.elements.push_back({i, (i + 1) % n});
        }
        mesh.patch.assign(n, 0);
        return mesh;
    }

    double radius_;
};

} // namespace

template <int D>
std::unique_ptr<Shape<D>> make_ball(double radius)
{
    require_positive(D == 2 ? "disk" : "ball", "radius", radius);
    return std::make_unique<Ball<D>>(radius);
}

template std::unique_ptr<Shape<2>> make_ball<2>(double);
template std::unique_ptr<Shape<3>> make_ball<3>(double);

} // namespace gapflow
