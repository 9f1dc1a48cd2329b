// The same surface with the solid on its other side: distances, normals, curvatures and the order of vertices change sign.
#include "gapflow/geometry/shape.hpp"

#include <utility>

namespace gapflow {
namespace {

template <int D>
SurfaceMesh<D> turned(SurfaceMesh<D> mesh)
{
    for (auto& element : mesh.elements)
        std::swap(element[0], element[1]);
    return mesh;
}

template <int D>
class InsideOut final : public Shape<D> {
public:
    explicit InsideOut(std::unique_ptr<Shape<D>> inner) : inner_(std::move(inner)) {}

    SurfacePoint<D> closest(const Vec<D>& x) const override
    {
        SurfacePoint<D> p = inner_->closest(x);
        p.normal = -p.normal;
        p.distance = -p.distance;
        return p;
    }
    double distance(const Vec<D>& x) const override { return -inner_->distance(x); }
    Vec<D> onto(const Vec<D>& x, int patch) const override { return inner_->onto(x, patch); }
    Vec<D> patch_normal(const Vec<D>& x, int patch) const override { return -inner_->patch_normal(x, patch); }
    double curvature(int patch) const override { return -inner_->curvature(patch); }
    double curvature_along(int patch, const Vec<D>& a, const Vec<D>& b) const override
    {
        return -inner_->curvature_along(patch, a, b);
    }
    SurfaceMesh<D> surface_mesh() const override { return turned(inner_->surface_mesh()); }
    SurfaceMesh<D> display_mesh(double tolerance) const override { return turned(inner_->display_mesh(tolerance)); }
    MassProperties<D> mass_properties() const override { return inner_->mass_properties(); }
    Bounds<D> bounds() const override { return inner_->bounds(); }
    std::vector<Plane<D>> planes() const override { return inner_->planes(); }
    bool complement() const override { return !inner_->complement(); }
    std::optional<double> sphere_radius() const override { return inner_->sphere_radius(); }
    std::optional<RoundBar> round_bar() const override { return inner_->round_bar(); }
    bool inside_out() const override { return !inner_->inside_out(); }
    bool convex() const override { return false; }

private:
    std::unique_ptr<Shape<D>> inner_;
};

} // namespace

template <int D>
std::unique_ptr<Shape<D>> make_inside_out(std::unique_ptr<Shape<D>> shape)
{
    return std::make_unique<InsideOut<D>>(std::move(shape));
}

template std::unique_ptr<Shape<2>> make_inside_out<2>(std::unique_ptr<Shape<2>>);
template std::unique_ptr<Shape<3>> make_inside_out<3>(std::unique_ptr<Shape<3>>);

} // namespace gapflow
