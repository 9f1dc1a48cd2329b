// Capsule (2D: stadium): points within a radius of a segment along x. Distance to the segment less the radius; smooth
// everywhere. Patches: 0 and 1 the low and high cap, 2 the side (2D: 2 the side at y < 0, 3 that at y > 0).
#include "gapflow/geometry/requirement.hpp"
#include "gapflow/geometry/revolve.hpp"
#include "gapflow/geometry/shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gapflow {
namespace {

template <int D>
class Capsule final : public Shape<D> {
public:
    Capsule(double radius, double length) : radius_(radius), half_(0.5 * length) {}

    SurfacePoint<D> closest(const Vec<D>& x) const override
    {
        const Vec<D> foot = std::clamp(x[0], -half_, half_) * unit<D>(0);
        const double r = (x - foot).norm();
        const Vec<D> n = r > 0 ? Vec<D>((x - foot) / r) : unit<D>(1);
        int patch = 2;
        if (x[0] < -half_)
            patch = 0;
        else if (x[0] > half_)
            patch = 1;
        else if (D == 2)
            patch = n[1] < 0 ? 2 : 3;
        return {foot + radius_ * n, n, r - radius_, Feature::face, patch};
    }

    double distance(const Vec<D>& x) const override
    {
        return (x - std::clamp(x[0], -half_, half_) * unit<D>(0)).norm() - radius_;
    }

    /// On a cap radially from its centre, on the side radially from the axis (2D: along y).
    Vec<D> onto(const Vec<D>& x, int patch) const override { return centre(x, patch) + radius_ * patch_normal(x, patch); }

    Vec<D> patch_normal(const Vec<D>& x, int patch) const override
    {
        if (D == 2 && patch >= 2)
            return (patch == 2 ? -1 : 1) * unit<D>(1);
        const Vec<D> r = x - centre(x, patch);
        const double length = r.norm();
        return length > 0 ? Vec<D>(r / length) : unit<D>(1);
    }

    double curvature(int patch) const override { return D == 2 && patch >= 2 ? 0 : 1 / radius_; }
    double curvature_along(int patch, const Vec<D>& a, const Vec<D>& b) const override
    {
        const double square = (b - a).squaredNorm();
        if (D == 2 || square == 0)
            return curvature(patch);
        return (closest(b).normal - closest(a).normal).dot(b - a) / square;
    }
    std::optional<RoundBar> round_bar() const override { return RoundBar{radius_, half_, false}; }
    std::vector<Core<D>> cores() const override { return {{-half_ * unit<D>(0), half_ * unit<D>(0), radius_}}; }

    SurfaceMesh<D> surface_mesh() const override
    {
        const double width = 2 * std::numbers::pi * radius_ / 16;
        return mesh(16, 2 * std::max(1, int(std::lround(half_ / width))));
    }
    SurfaceMesh<D> display_mesh(double tolerance) const override
    {
        return mesh(chords_around(radius_, tolerance / (D - 1)), 1); // a cap's triangles have the sagitta of both directions
    }

    MassProperties<D> mass_properties() const override
    {
        // A block or cylinder, and two halves of a ball whose centres of volume are at half_ + offset.
        constexpr double pi = std::numbers::pi;
        const double r = radius_, l = 2 * half_;
        MassProperties<D> mass{0, Vec<D>::Zero(), {}};
        mass.inertia.setZero();
        const double offset = D == 2 ? 4 * r / (3 * pi) : 3 * r / 8;
        const double lever2 = (half_ + offset) * (half_ + offset) - offset * offset;
        if constexpr (D == 2) {
            const double side = l * 2 * r, caps = pi * r * r;
            mass.volume = side + caps;
            mass.inertia(0, 0) = side * (l * l + 4 * r * r) / 12 + caps * (r * r / 2 + lever2);
        } else {
            const double side = pi * r * r * l, caps = 4. / 3 * pi * r * r * r;
            mass.volume = side + caps;
            const double across = side * (r * r / 4 + l * l / 12) + caps * (2. / 5 * r * r + lever2);
            mass.inertia.diagonal() << side * r * r / 2 + caps * 2. / 5 * r * r, across, across;
        }
        return mass;
    }

    Bounds<D> bounds() const override
    {
        const Vec<D> high = Vec<D>::Constant(radius_) + half_ * unit<D>(0);
        return {-high, high};
    }

private:
    /// Point of the axis next to x from which the patch is projected.
    Vec<D> centre(const Vec<D>& x, int patch) const { return (patch == 0 ? -half_ : patch == 1 ? half_ : x[0]) * unit<D>(0); }

    SurfaceMesh<D> mesh(int around, int along) const
    {
        const int quarter = around / 4;
        if constexpr (D == 2) {
            SurfaceMesh<2> chain;
            const auto cap = [&](int patch, int first, double x) {
                for (int k = 0; k <= 2 * quarter; ++k) {
                    chain.vertices.push_back(radius_ * circle_point((first + k) % around, around) + x * unit<2>(0));
                    chain.patch.push_back(patch);
                }
                chain.patch.back() = patch == 1 ? 3 : 2; // the last one starts the side
            };
            cap(1, 3 * quarter, half_);
            cap(0, quarter, -half_);
            const int n = int(chain.vertices.size());
            for (int i = 0; i < n; ++i)
                chain.elements.push_back({i, (i + 1) % n});
            return chain;
        } else {
            std::vector<Ring> rings;
            for (int k = 0; k < quarter; ++k) {
                const Vec<2> e = circle_point(k, around);
                rings.push_back({-half_ - radius_ * e[0], radius_ * e[1], 0});
            }
            for (int k = 0; k <= along; ++k)
                rings.push_back({half_ * (2 * k - along) / along, radius_, k == along ? 1 : 2});
            for (int k = quarter - 1; k >= 0; --k) {
                const Vec<2> e = circle_point(k, around);
                rings.push_back({half_ + radius_ * e[0], radius_ * e[1], 1});
            }
            return revolve(rings, around);
        }
    }

    double radius_, half_;
};

} // namespace

template <int D>
std::unique_ptr<Shape<D>> make_capsule(double radius, double length)
{
    require_positive("capsule", "radius", radius);
    require_positive("capsule", "length", length);
    return std::make_unique<Capsule<D>>(radius, length);
}

template std::unique_ptr<Shape<2>> make_capsule<2>(double, double);
template std::unique_ptr<Shape<3>> make_capsule<3>(double, double);

} // namespace gapflow
