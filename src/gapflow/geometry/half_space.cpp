// Half-space behind a plane through the origin.
#include "gapflow/geometry/requirement.hpp"
#include "gapflow/geometry/shape.hpp"

#include <algorithm>

namespace gapflow {
namespace {

template <int D>
class HalfSpace final : public Shape<D> {
public:
    explicit HalfSpace(const Vec<D>& unit_normal) : normal_(unit_normal) {}

    SurfacePoint<D> closest(const Vec<D>& x) const override
    {
        const double d = normal_.dot(x);
        return {x - d * normal_, normal_, d, Feature::face, 0};
    }
    double distance(const Vec<D>& x) const override { return normal_.dot(x); }
    std::optional<double> entry(const Vec<D>& x, const Vec<D>& u) const override
    {
        const double closing = -normal_.dot(u);
        return closing > 0 ? std::max(normal_.dot(x), 0.0) / closing : std::numeric_limits<double>::infinity();
    }
    Vec<D> onto(const Vec<D>& x, int) const override { return x - normal_.dot(x) * normal_; }
    Vec<D> patch_normal(const Vec<D>&, int) const override { return normal_; }
    double curvature(int) const override { return 0; }
    SurfaceMesh<D> surface_mesh() const override { return {}; }
    SurfaceMesh<D> display_mesh(double) const override { return {}; }

    MassProperties<D> mass_properties() const override
    {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        MassProperties<D> mass{infinity, Vec<D>::Zero(), {}};
        mass.inertia.setZero();
        mass.inertia.diagonal().setConstant(infinity);
        return mass;
    }

    Bounds<D> bounds() const override
    {
        Bounds<D> b;
        for (int i = 0; i < D; ++i)
            if (std::abs(normal_[i]) == 1)
                b.low[i] = b.high[i] = 0;
        return b;
    }

    std::vector<Plane<D>> planes() const override { return {{normal_, 0.}}; }

private:
    Vec<D> normal_;
};

} // namespace

template <int D>
std::unique_ptr<Shape<D>> make_half_space(const Vec<D>& normal)
{
    require_positive("half-space", "length of the normal", normal.stableNorm());
    return std::make_unique<HalfSpace<D>>(normal.stableNormalized());
}

template std::unique_ptr<Shape<2>> make_half_space<2>(const Vec<2>&);
template std::unique_ptr<Shape<3>> make_half_space<3>(const Vec<3>&);

} // namespace gapflow
