// Random scenes of solids near each other: every kind of shape, gaps of 1e-7 to 1 cells, some that touch or overlap slightly.
#pragma once

#include "../grid/scenes.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

namespace gapflow::testing {

/// Points of which, with a radius around them, a solid is the hull: centres of balls, points of axes and rims, vertices.
template <int D>
struct HullPoints {
    std::vector<Vec<D>> points;
    double radius = 0;
};

template <int D>
class NearScenes {
public:
    static constexpr int cells = 10;

    /// `size`: of the solids, relative to some tenths of the domain.
    explicit NearScenes(int seed, double size = 1) : engine_(static_cast<unsigned>(seed)), size_(size) {}

    /// `walls`: also closed sides of the domain.
    Grid<D> grid(bool walls)
    {
        std::array<SideKind, 2 * D> sides;
        constexpr std::array kinds{SideKind::open, SideKind::far, SideKind::wall};
        for (int axis = 0; axis < D; ++axis) {
            for (int end = 0; end < 2; ++end)
                sides[2 * axis + end] = kinds[below(walls ? 3 : 2)];
            if (chance(0.3))
                sides[2 * axis] = sides[2 * axis + 1] = SideKind::periodic;
        }
        return unit_grid<D>(cells, sides);
    }

    /// Two to five solids, each beside one before it.
    void fill(Scene<D>& scene)
    {
        std::vector<HullPoints<D>> hulls(scene.solids.size());
        for (int k = 0, n = 2 + below(4); k < n; ++k) {
            HullPoints<D> hull;
            std::unique_ptr<Shape<D>> shape = random_shape(hull);
            Pose<D> at = random_pose();
            if (k > 0 || !scene.solids.empty()) {
                const auto to = static_cast<std::size_t>(below(static_cast<int>(scene.solids.size())));
                move_beside(scene.solids[to].shape, hulls[to], *shape, hull, random_gap() / cells, at);
            }
            scene.add(numbered("solid", k), std::move(shape), at);
            for (Vec<D>& x : hull.points)
                x = at.position + at.rotation * x;
            hulls.push_back(hull);
        }
    }

private:
    double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
    int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(engine_); }
    bool chance(double share) { return between(0, 1) < share; }

    double random_gap()
    {
        const double gap = std::pow(10, between(-7, 0));
        return chance(0.1) ? 0.0 : chance(0.1) ? -0.01 * gap : gap;
    }

    std::unique_ptr<Shape<D>> random_shape(HullPoints<D>& hull)
    {
        const double size = size_ * between(0.08, 0.25), other = size * between(0.3, 1.5);
        const auto of_mesh = [&](const SurfaceMesh<D>& mesh) { hull.points = mesh.vertices; };
        const auto along = [&](double half) {
            for (int k = 0; k <= 64; ++k)
                hull.points.push_back(half * (k / 32.0 - 1) * Vec<D>::UnitX());
        };
        switch (below(D == 3 ? 6 : 5)) {
        case 0:
            hull = {{Vec<D>::Zero()}, size};
            return make_ball<D>(size);
        case 1:
            along(other);
            hull.radius = 0.6 * size;
            return make_capsule<D>(0.6 * size, 2 * other);
        case 2: {
            Vec<D> edges;
            for (int axis = 0; axis < D; ++axis)
                edges[axis] = size * between(0.3, 1.5);
            auto box = make_box<D>(edges);
            of_mesh(box->display_mesh(0));
            return box;
        }
        case 3: { // facets larger than a cell, and smaller ones
            const SurfaceMesh<D> mesh = make_ball<D>(size)->display_mesh(size * std::pow(10, between(-3, -1)));
            of_mesh(mesh);
            return make_mesh<D>(mesh, "ball");
        }
        case 4: {
            const SurfaceMesh<D> mesh = make_box<D>(Vec<D>::Constant(size))->display_mesh(0);
            of_mesh(mesh);
            return make_mesh<D>(mesh, "box");
        }
        default:
            if constexpr (D == 3) {
                for (int k = 0; k < 256; ++k)
                    for (const double x : {-other, other})
                        hull.points.push_back(Vec<3>(x, size * std::cos(std::numbers::pi * k / 128),
                                                     size * std::sin(std::numbers::pi * k / 128)));
                return make_cylinder(size, 2 * other);
            }
            return nullptr;
        }
    }

    Pose<D> random_pose()
    {
        Vec<D> x;
        for (int axis = 0; axis < D; ++axis)
            x[axis] = chance(0.3) ? below(2 * cells + 1) / (2.0 * cells) : between(0.1, 0.9);
        const double angle = chance(0.4) ? std::numbers::pi / 4 * below(8) : between(0, 2 * std::numbers::pi);
        Pose<D> at = pose<D>(x, angle);
        if constexpr (D == 3)
            if (chance(0.4))
                at.rotation = Rotation<3>(Eigen::AngleAxisd(angle, Vec<3>::Unit(below(3))));
        return at;
    }

    static double distance(const PlacedShape<D>& a, const HullPoints<D>& hull_a, const PlacedShape<D>& b,
                           const HullPoints<D>& hull_b, const Pose<D>& at)
    {
        double least = std::numeric_limits<double>::infinity();
        for (const Vec<D>& x : hull_a.points)
            least = std::min(least, b.distance(x) - hull_a.radius);
        for (const Vec<D>& x : hull_b.points)
            least = std::min(least, a.distance(at.position + at.rotation * x) - hull_b.radius);
        return least;
    }

    /// Moves b along a random way until it is as far from a as asked.
    void move_beside(const PlacedShape<D>& a, const HullPoints<D>& hull_a, const Shape<D>& b, const HullPoints<D>& hull_b,
                     double gap, Pose<D>& at)
    {
        const Vec<D> start = at.position;
        Vec<D> way;
        for (int axis = 0; axis < D; ++axis)
            way[axis] = chance(0.3) ? 0.0 : between(-1, 1);
        way.normalize();
        if (!(way.norm() > 0.5))
            way = Vec<D>::Unit(below(D));
        double low = -1, high = 1; // from where it is deeper to where it is farther
        const auto past = [&](double s) {
            at.position = start + s * way;
            return distance(a, hull_a, PlacedShape<D>(b, at), hull_b, at) - gap;
        };
        double least = past(low);
        for (int k = -19; k <= 20; ++k)
            if (const double here = past(0.05 * k); here < least)
                low = 0.05 * k, least = here;
        while (past(high) < 0 && high < 4)
            high *= 2;
        for (int k = 0; k < 60; ++k)
            (past(0.5 * (low + high)) < 0 ? low : high) = 0.5 * (low + high);
        at.position = start + high * way;
    }

    std::mt19937 engine_;
    double size_;
};

} // namespace gapflow::testing
