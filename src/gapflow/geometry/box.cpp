// Box centred at the origin, edges along the axes: distance from the clamped point (exact to round-off, and relative to
// the distance itself wherever one face is nearest: |x_i| - half_i has no rounding near the face).
#include "gapflow/geometry/requirement.hpp"
#include "gapflow/geometry/shape.hpp"

#include <algorithm>

namespace gapflow {
namespace {

template <int D>
class Box final : public Shape<D> {
public:
    explicit Box(const Vec<D>& size) : half_(0.5 * size), tolerance_(1e-12 * size.maxCoeff()) {}

    SurfacePoint<D> closest(const Vec<D>& x) const override
    {
        const Vec<D> beyond = x.cwiseAbs() - half_;
        int axis;
        const double largest = beyond.maxCoeff(&axis);
        const double side = x[axis] < 0 ? -1 : 1;
        SurfacePoint<D> p{x, side * unit<D>(axis), largest, Feature::face, patch_of(axis, side)};
        if (largest <= 0) {
            p.x[axis] = side * half_[axis];
            return p;
        }
        p.x = x.cwiseMax(-half_).cwiseMin(half_);
        p.distance = beyond.cwiseMax(0).norm();
        const auto axes_beyond = (beyond.array() > tolerance_).count();
        if (axes_beyond > 1) {
            p.normal = (x - p.x) / p.distance;
            p.feature = axes_beyond == D ? Feature::corner : Feature::edge;
        }
        return p;
    }

    double distance(const Vec<D>& x) const override
    {
        const Vec<D> beyond = x.cwiseAbs() - half_;
        const double largest = beyond.maxCoeff();
        return largest <= 0 ? largest : beyond.cwiseMax(0).norm();
    }

    std::optional<double> entry(const Vec<D>& x, const Vec<D>& u) const override
    {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        double in = 0, out = infinity;
        for (int i = 0; i < D; ++i) {
            const double outside = std::abs(x[i]) - half_[i], away = x[i] < 0 ? -u[i] : u[i]; // from the middle, along the axis
            if (outside > 0)
                in = std::max(in, away < 0 ? outside / -away : infinity);
            if (away != 0)
                out = std::min(out, away < 0 ? (std::abs(x[i]) + half_[i]) / -away : -outside / away);
        }
        return in <= out ? in : infinity;
    }

    Vec<D> onto(const Vec<D>& x, int patch) const override
    {
        Vec<D> y = x;
        y[patch / 2] = side_of(patch) * half_[patch / 2];
        return y;
    }

    Vec<D> patch_normal(const Vec<D>&, int patch) const override { return side_of(patch) * unit<D>(patch / 2); }
    double curvature(int) const override { return 0; }

    SurfaceMesh<D> surface_mesh() const override
    {
        SurfaceMesh<D> mesh;
        for (int corner = 0; corner < 1 << D; ++corner) { // bit i: high along axis i
            Vec<D> x;
            for (int i = 0; i < D; ++i)
                x[i] = corner >> i & 1 ? half_[i] : -half_[i];
            mesh.vertices.push_back(x);
        }
        for (int patch = 0; patch < 2 * D; ++patch) {
            const int axis = patch / 2, b = (axis + 1) % D, base = patch % 2 << axis;
            // Counterclockwise seen from outside on the high sides; the low sides run the other way.
            if constexpr (D == 2) {
                std::array<int, 2> ends{base, base | 1 << b};
                if ((axis == 0) != (patch % 2 == 1))
                    std::swap(ends[0], ends[1]);
                mesh.elements.push_back(ends);
                mesh.patch.push_back(patch);
            } else {
                const int c = (axis + 2) % D;
                const std::array<int, 4> ring{base, base | 1 << b, base | 1 << b | 1 << c, base | 1 << c};
                const int centre = int(mesh.vertices.size());
                mesh.vertices.push_back(side_of(patch) * half_[axis] * unit<D>(axis));
                for (int k = 0; k < 4; ++k) {
                    std::array<int, 3> triangle{ring[k], ring[(k + 1) % 4], centre};
                    if (patch % 2 == 0)
                        std::swap(triangle[0], triangle[1]);
                    mesh.elements.push_back(triangle);
                    mesh.patch.push_back(patch);
                }
            }
        }
        return mesh;
    }

    SurfaceMesh<D> display_mesh(double) const override { return surface_mesh(); }

    MassProperties<D> mass_properties() const override
    {
        const Vec<D> size = 2 * half_;
        MassProperties<D> mass{size.prod(), Vec<D>::Zero(), {}};
        const Vec<D> second = mass.volume / 12 * size.cwiseAbs2(); // integral of x_i^2
        mass.inertia.setZero();
        if constexpr (D == 2)
            mass.inertia(0, 0) = second.sum();
        else
            mass.inertia.diagonal() = Vec<3>::Constant(second.sum()) - second;
        return mass;
    }

    Bounds<D> bounds() const override { return {-half_, half_}; }

    std::vector<Plane<D>> planes() const override
    {
        std::vector<Plane<D>> all;
        for (int patch = 0; patch < 2 * D; ++patch)
            all.push_back({side_of(patch) * unit<D>(patch / 2), half_[patch / 2]});
        return all;
    }

private:
    static int patch_of(int axis, double side) { return 2 * axis + (side > 0); }
    static double side_of(int patch) { return patch % 2 ? 1 : -1; }

    Vec<D> half_;
    double tolerance_; ///< a point beyond an edge by less counts as over the face
};

} // namespace

template <int D>
std::unique_ptr<Shape<D>> make_box(const Vec<D>& size)
{
    for (int i = 0; i < D; ++i)
        require_positive("box", std::string("size along ") + "xyz"[i], size[i]);
    return std::make_unique<Box<D>>(size);
}

template std::unique_ptr<Shape<2>> make_box<2>(const Vec<2>&);
template std::unique_ptr<Shape<3>> make_box<3>(const Vec<3>&);

} // namespace gapflow
