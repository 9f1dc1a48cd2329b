#include "gapflow/output/surface_raster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gapflow {

Camera::Camera(const Eigen::Vector3d& box_low, const Eigen::Vector3d& box_size, int width, int height)
    : width_(width), height_(height)
{
    const Eigen::Vector3d middle = box_low + 0.5 * box_size;
    const Eigen::Vector3d direction = Eigen::Vector3d(0.62, -1.35, 0.62).normalized();
    eye_ = middle + 2.2 * box_size.norm() * direction;
    forward_ = -direction;
    right_ = forward_.cross(Eigen::Vector3d::UnitZ()).normalized();
    up_ = right_.cross(forward_);
    double widest = 0; // slopes of the box's corners against the picture's half sides
    for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3d x =
            box_low + box_size.cwiseProduct(Eigen::Vector3d(corner & 1, corner >> 1 & 1, corner >> 2)) - eye_;
        const double depth = x.dot(forward_);
        widest = std::max(
            {widest, std::abs(x.dot(right_)) / depth / (0.5 * width_), std::abs(x.dot(up_)) / depth / (0.5 * height_)});
    }
    pixels_ = 0.96 / widest;
}

Eigen::Vector3d Camera::project(const Eigen::Vector3d& x) const
{
    const Eigen::Vector3d r = x - eye_;
    const double depth = std::max(r.dot(forward_), 1e-9);
    return {0.5 * width_ + pixels_ * r.dot(right_) / depth, 0.5 * height_ - pixels_ * r.dot(up_) / depth, depth};
}

SurfaceRaster::SurfaceRaster(const Camera& camera, int width, int height)
    : camera_(camera), width_(width), height_(height), colours_(static_cast<std::size_t>(width) * height),
      depth_(colours_.size(), std::numeric_limits<float>::infinity())
{
}

// pixel(index, weights, depth) for every pixel whose centre a triangle covers; weights are those in space: linear in 1 / depth
// on the picture.
template <class Pixel>
void SurfaceRaster::cover(const std::array<Eigen::Vector3d, 3>& corners, Pixel&& pixel) const
{
    std::array<Eigen::Vector3d, 3> p;
    for (int i = 0; i < 3; ++i)
        p[i] = camera_.project(corners[i]);
    const auto side = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b, double x, double y) {
        return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
    };
    const double area = side(p[0], p[1], p[2][0], p[2][1]);
    if (std::abs(area) < 1e-12)
        return;
    const auto [x0, x1] = std::minmax({p[0][0], p[1][0], p[2][0]});
    const auto [y0, y1] = std::minmax({p[0][1], p[1][1], p[2][1]});
    for (int y = std::max(0, static_cast<int>(y0)); y < std::min<double>(height_, y1 + 1); ++y)
        for (int x = std::max(0, static_cast<int>(x0)); x < std::min<double>(width_, x1 + 1); ++x) {
            Eigen::Vector3d weights;
            for (int i = 0; i < 3; ++i)
                weights[i] = side(p[(i + 1) % 3], p[(i + 2) % 3], x + 0.5, y + 0.5) / area;
            if (weights.minCoeff() < 0)
                continue;
            for (int i = 0; i < 3; ++i)
                weights[i] /= p[i][2];
            const double depth = 1 / weights.sum();
            pixel(static_cast<std::size_t>(y) * width_ + x, Eigen::Vector3d(depth * weights), static_cast<float>(depth));
        }
}

void SurfaceRaster::triangle(const std::array<Eigen::Vector3d, 3>& corners, const Shade& shade)
{
    cover(corners, [&](std::size_t index, const Eigen::Vector3d& weights, float depth) {
        if (depth >= depth_[index])
            return;
        if (const auto [colour, visible] = shade(weights); visible) {
            colours_[index] = colour;
            depth_[index] = depth;
        }
    });
}

void SurfaceRaster::triangle_through(const std::array<Eigen::Vector3d, 3>& corners, const Shade& shade, double share)
{
    cover(corners, [&](std::size_t index, const Eigen::Vector3d& weights, float depth) {
        const auto [colour, visible] = shade(weights);
        if (!visible)
            return;
        const double s = depth <= depth_[index] ? 1 : share;
        const auto mix = [&](std::uint8_t a, std::uint8_t b) {
            return static_cast<std::uint8_t>(std::lround(a + s * (b - a)));
        };
        Colour& old = colours_[index];
        old = {mix(old.red, colour.red), mix(old.green, colour.green), mix(old.blue, colour.blue)};
    });
}

void SurfaceRaster::line(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double thickness, Colour colour)
{
    const Eigen::Vector3d a = camera_.project(from), b = camera_.project(to);
    const int steps = static_cast<int>(2 * (b - a).head<2>().norm()) + 1;
    for (int k = 0; k <= steps; ++k) {
        const double s = static_cast<double>(k) / steps;
        const Eigen::Vector3d p = a + s * (b - a);
        const double depth = 1 / ((1 - s) / a[2] + s / b[2]);
        const int reach = static_cast<int>(std::ceil(0.5 * thickness));
        for (int y = static_cast<int>(p[1]) - reach; y <= static_cast<int>(p[1]) + reach; ++y)
            for (int x = static_cast<int>(p[0]) - reach; x <= static_cast<int>(p[0]) + reach; ++x) {
                if (x < 0 || y < 0 || x >= width_ || y >= height_ ||
                    std::hypot(x + 0.5 - p[0], y + 0.5 - p[1]) > 0.5 * thickness)
                    continue;
                const std::size_t index = static_cast<std::size_t>(y) * width_ + x;
                if (depth < depth_[index] * 1.001)
                    colours_[index] = colour;
            }
    }
}

void SurfaceRaster::clear(Colour colour)
{
    std::fill(colours_.begin(), colours_.end(), colour);
    std::fill(depth_.begin(), depth_.end(), std::numeric_limits<float>::infinity());
}

void SurfaceRaster::draw(Picture& picture, int left, int top, int factor) const
{
    for (int y = 0; y < height_ / factor; ++y)
        for (int x = 0; x < width_ / factor; ++x) {
            int sum[3] = {0, 0, 0};
            for (int b = 0; b < factor; ++b)
                for (int a = 0; a < factor; ++a) {
                    const Colour c = colours_[static_cast<std::size_t>(factor * y + b) * width_ + factor * x + a];
                    sum[0] += c.red;
                    sum[1] += c.green;
                    sum[2] += c.blue;
                }
            const int n = factor * factor;
            picture.blend(left + x, top + y,
                          {static_cast<std::uint8_t>(sum[0] / n), static_cast<std::uint8_t>(sum[1] / n),
                           static_cast<std::uint8_t>(sum[2] / n)});
        }
}

std::vector<Eigen::Vector3d> corner_normals(const std::vector<Eigen::Vector3d>& points, const std::vector<int>& triangles)
{
    const double crease = std::cos(35 * std::acos(-1.0) / 180);
    const std::size_t count = triangles.size() / 3;
    std::vector<Eigen::Vector3d> flat(count); // length: twice the area
    std::vector<std::vector<std::size_t>> at(points.size());
    for (std::size_t t = 0; t < count; ++t) {
        const int* corner = triangles.data() + 3 * t;
        flat[t] = (points[corner[1]] - points[corner[0]]).cross(points[corner[2]] - points[corner[0]]);
        for (int i = 0; i < 3; ++i)
            at[corner[i]].push_back(t);
    }
    std::vector<Eigen::Vector3d> normals;
    for (std::size_t t = 0; t < count; ++t)
        for (int i = 0; i < 3; ++i) {
            Eigen::Vector3d sum = Eigen::Vector3d::Zero();
            for (const std::size_t other : at[triangles[3 * t + i]])
                if (flat[other].dot(flat[t]) >= crease * flat[other].norm() * flat[t].norm())
                    sum += flat[other];
            normals.push_back(sum.stableNormalized());
        }
    return normals;
}

} // namespace gapflow
