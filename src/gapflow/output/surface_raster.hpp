// Triangles in perspective with a depth buffer (3D pictures).
#pragma once

#include "gapflow/output/picture.hpp"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace gapflow {

/// A camera that looks at a box from the front, right and above; z points up.
class Camera {
public:
    Camera(const Eigen::Vector3d& box_low, const Eigen::Vector3d& box_size, int width, int height);

    /// x, y in pixels, z the distance along the line of sight.
    Eigen::Vector3d project(const Eigen::Vector3d& x) const;
    const Eigen::Vector3d& eye() const { return eye_; }

private:
    Eigen::Vector3d eye_, right_, up_, forward_;
    double pixels_ = 1; ///< per slope
    double width_, height_;
};

/// Colour and depth of the foremost surface, pixel by pixel.
class SurfaceRaster {
public:
    SurfaceRaster(const Camera& camera, int width, int height);

    /// colour(weights of the corners) of a pixel inside; not drawn where `visible` is false, nor behind pixels already
    /// drawn.
    using Shade = std::function<std::pair<Colour, bool>(const Eigen::Vector3d& weights)>;
    void triangle(const std::array<Eigen::Vector3d, 3>& corners, const Shade& shade);
    /// The same, mixed by `share` over what is in front of it.
    void triangle_through(const std::array<Eigen::Vector3d, 3>& corners, const Shade& shade, double share);
    void line(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double thickness, Colour colour);

    /// Draws the raster into a picture, `factor` raster pixels a pixel each way.
    void draw(Picture& picture, int left, int top, int factor) const;
    void clear(Colour colour);

private:
    template <class Pixel>
    void cover(const std::array<Eigen::Vector3d, 3>& corners, Pixel&& pixel) const;

    Camera camera_;
    int width_, height_;
    std::vector<Colour> colours_;
    std::vector<float> depth_;
};

/// Unit normals of the three corners of every triangle: means of those of neighbours that meet at less than 35 degrees.
std::vector<Eigen::Vector3d> corner_normals(const std::vector<Eigen::Vector3d>& points, const std::vector<int>& triangles);

} // namespace gapflow
