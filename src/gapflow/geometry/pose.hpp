// Position and orientation of a body, and shapes placed in the world.
#pragma once

#include "gapflow/core/types.hpp"
#include "gapflow/geometry/shape.hpp"

namespace gapflow {

/// Rotation of a body: an angle in 2D, a unit quaternion in 3D.
template <int D>
using Rotation = std::conditional_t<D == 2, Eigen::Rotation2D<double>, Eigen::Quaternion<double>>;

/// x_world = position + R x_body.
template <int D>
struct Pose {
    Vec<D> position = Vec<D>::Zero();
    Rotation<D> rotation = Rotation<D>::Identity();

    Mat<D> matrix() const { return rotation.toRotationMatrix(); }
};

/// A shape at a pose: the shape's queries with points and vectors of the world. Does not own the shape.
template <int D>
class PlacedShape {
public:
    PlacedShape(const Shape<D>& shape, const Pose<D>& pose) : shape_(&shape), position_(pose.position), rotation_(pose.matrix())
    {
    }

    const Shape<D>& shape() const { return *shape_; }
    Vec<D> to_body(const Vec<D>& x_world) const { return rotation_.transpose() * (x_world - position_); }
    Vec<D> to_world(const Vec<D>& x_body) const { return position_ + rotation_ * x_body; }
    const Mat<D>& rotation() const { return rotation_; }
    /// The same shape moved by `shift` (an image in a periodic domain).
    PlacedShape shifted(const Vec<D>& shift) const
    {
        PlacedShape image = *this;
        image.position_ += shift;
        return image;
    }

    double distance(const Vec<D>& x_world) const { return shape_->distance(to_body(x_world)); }
    SurfacePoint<D> closest(const Vec<D>& x_world) const
    {
        SurfacePoint<D> p = shape_->closest(to_body(x_world));
        p.x = to_world(p.x);
        p.normal = rotation_ * p.normal;
        return p;
    }
    std::optional<double> entry(const Vec<D>& x_world, const Vec<D>& u_world) const
    {
        return shape_->entry(to_body(x_world), rotation_.transpose() * u_world);
    }
    Vec<D> onto(const Vec<D>& x_world, int patch) const { return to_world(shape_->onto(to_body(x_world), patch)); }
    Vec<D> patch_normal(const Vec<D>& x_world, int patch) const
    {
        return rotation_ * shape_->patch_normal(to_body(x_world), patch);
    }

private:
    const Shape<D>* shape_;
    Vec<D> position_;
    Mat<D> rotation_;
};

} // namespace gapflow
