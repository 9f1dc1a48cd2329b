// Circular cylinder along x with flat ends: in the half-plane (x, radius) a rectangle, so distances are those of a box.
// Patches: 0 and 1 the low and high end, 2 the side; both rims are sharp edges.
#include "gapflow/geometry/requirement.hpp"
#include "gapflow/geometry/revolve.hpp"
#include "gapflow/geometry/shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gapflow {
namespace {

class Cylinder final : public Shape<3> {
public:
    Cylinder(double radius, double length)
        : radius_(radius), half_(0.5 * length), tolerance_(1e-12 * std::max(2 * radius, length))
    {
    }

    SurfacePoint<3> closest(const Vec<3>& x) const override
    {
        const double rho = std::hypot(x[1], x[2]), side = x[0] < 0 ? -1 : 1;
        const Vec<3> radial = outward(x, rho), axial = side * unit<3>(0);
        const double past_end = std::abs(x[0]) - half_, past_side = rho - radius_;
        const bool end = past_end > past_side;
        SurfacePoint<3> p{x, end ? axial : radial, std::max(past_end, past_side), Feature::face, end ? (side > 0) : 2};
        const Vec<3> on_side = radius_ * radial; // at x = 0
        if (past_end > 0 && past_side > 0) {
            p.x = on_side + half_ * axial;
            p.distance = std::hypot(past_end, past_side);
            if (std::min(past_end, past_side) > tolerance_) {
                p.normal = (past_end * axial + past_side * radial) / p.distance;
                p.feature = Feature::edge;
            }
        } else if (end)
            p.x[0] = side * half_;
        else
            p.x.tail<2>() = on_side.tail<2>();
        return p;
    }

    double distance(const Vec<3>& x) const override
    {
        const double past_end = std::abs(x[0]) - half_, past_side = std::hypot(x[1], x[2]) - radius_;
        return past_end > 0 && past_side > 0 ? std::hypot(past_end, past_side) : std::max(past_end, past_side);
    }

    /// On the side radially from the axis, x kept; on the ends along x, radius kept. The two commute: a point near the rim
    /// projected on both is on the rim.
    Vec<3> onto(const Vec<3>& x, int patch) const override
    {
        Vec<3> y = x;
        if (patch == 2)
            y.tail<2>() = radius_ * outward(x, std::hypot(x[1], x[2])).tail<2>();
        else
            y[0] = patch == 1 ? half_ : -half_;
        return y;
    }

    Vec<3> patch_normal(const Vec<3>& x, int patch) const override
    {
        return patch == 2 ? outward(x, std::hypot(x[1], x[2])) : Vec<3>((patch == 1 ? 1 : -1) * unit<3>(0));
    }
    double curvature(int patch) const override { return patch == 2 ? 1 / radius_ : 0; }
    double curvature_along(int patch, const Vec<3>& a, const Vec<3>& b) const override
    {
        const double square = (b - a).squaredNorm();
        if (square == 0)
            return curvature(patch);
        return (patch_normal(b, patch) - patch_normal(a, patch)).dot(b - a) / square;
    }
    std::optional<RoundBar> round_bar() const override { return RoundBar{radius_, half_, true}; }
    std::vector<Core<3>> cores() const override { return {{-half_ * unit<3>(0), half_ * unit<3>(0), radius_}}; }

    SurfaceMesh<3> surface_mesh() const override
    {
        constexpr int around = 16;
        const double width = 2 * std::numbers::pi * radius_ / around;
        return mesh(around, 2 * std::max(1, int(std::lround(half_ / width))));
    }
    SurfaceMesh<3> display_mesh(double tolerance) const override { return mesh(chords_around(radius_, tolerance), 1); }

    MassProperties<3> mass_properties() const override
    {
        const double r2 = radius_ * radius_;
        MassProperties<3> mass{2 * std::numbers::pi * r2 * half_, Vec<3>::Zero(), Mat<3>::Zero()};
        const double across = mass.volume * (r2 / 4 + half_ * half_ / 3);
        mass.inertia.diagonal() << mass.volume * r2 / 2, across, across;
        return mass;
    }

    Bounds<3> bounds() const override
    {
        const Vec<3> high(half_, radius_, radius_);
        return {-high, high};
    }

private:
    static Vec<3> outward(const Vec<3>& x, double rho) { return rho > 0 ? Vec<3>(0, x[1] / rho, x[2] / rho) : unit<3>(1); }

    SurfaceMesh<3> mesh(int around, int along) const
    {
        std::vector<Ring> rings{{-half_, 0, 0}};
        for (int k = 0; k <= along; ++k)
            rings.push_back({half_ * (2 * k - along) / along, radius_, k == along ? 1 : 2});
        rings.push_back({half_, 0, 1});
        return revolve(rings, around);
    }

    double radius_, half_, tolerance_;
};

} // namespace

std::unique_ptr<Shape<3>> make_cylinder(double radius, double length)
{
    require_positive("cylinder", "radius", radius);
    require_positive("cylinder", "length", length);
    return std::make_unique<Cylinder>(radius, length);
}

} // namespace gapflow
