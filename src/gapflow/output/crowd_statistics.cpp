#include "gapflow/output/crowd_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gapflow {

namespace {

constexpr int most_layers = 200;
constexpr int points_along = 8; // of a body's points, along each axis of its bounds

// Linear between the values in order, as numpy.percentile.
double percentile(const std::vector<double>& sorted, double share)
{
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto low = static_cast<std::size_t>(place);
    const std::size_t high = std::min(low + 1, sorted.size() - 1);
    return sorted[low] + (place - static_cast<double>(low)) * (sorted[high] - sorted[low]);
}

template <int D>
std::array<double, 3> percentiles(std::vector<double>& values)
{
    std::sort(values.begin(), values.end());
    std::array<double, 3> result{};
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = percentile(values, CrowdStatistics<D>::shares[i]);
    return result;
}

// Volume of a ball below the height h over its centre.
template <int D>
double ball_below(double radius, double h)
{
    h = std::clamp(h, -radius, radius);
    if constexpr (D == 2)
        return radius * radius * (std::asin(h / radius) + std::numbers::pi / 2) + h * std::sqrt(radius * radius - h * h);
    else
        return std::numbers::pi * (h * (radius * radius - h * h / 3) + 2 * radius * radius * radius / 3);
}

// Radius of a ball; 0 of other shapes.
template <int D>
double ball_radius(const Shape<D>& shape)
{
    return shape.inside_out() ? 0 : shape.sphere_radius().value_or(0);
}

// Points in a shape, evenly; its centre of volume if none is.
template <int D>
std::vector<Vec<D>> points_in(const Shape<D>& shape, const Vec<D>& centre)
{
    const Bounds<D> bounds = shape.bounds();
    std::vector<Vec<D>> points;
    int count = 1;
    for (int axis = 0; axis < D; ++axis)
        count *= points_along;
    for (int k = 0; k < count; ++k) {
        Vec<D> x;
        for (int axis = 0, rest = k; axis < D; ++axis, rest /= points_along)
            x[axis] = bounds.low[axis] + (rest % points_along + 0.5) / points_along * (bounds.high[axis] - bounds.low[axis]);
        if (shape.distance(x) <= 0)
            points.push_back(x);
    }
    if (points.empty())
        points.push_back(centre);
    return points;
}

} // namespace

int height_axis(const Scene& scene)
{
    int axis = scene.dimension - 1;
    for (int other = 0; other < scene.dimension; ++other)
        if (std::abs(scene.gravity[other]) > std::abs(scene.gravity[axis]))
            axis = other;
    return axis;
}

template <int D>
CrowdStatistics<D> crowd_statistics(std::span<const RigidBody<D>> bodies, std::span<const Twist<D>> wrenches, int height_axis)
{
    CrowdStatistics<D> result;
    result.number = static_cast<int>(bodies.size());
    if (bodies.empty())
        return result;
    const double share = 1.0 / result.number;
    std::vector<double> speeds, heights;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const Vec<D> velocity = bodies[b].twist.template head<D>(), centre = bodies[b].centre();
        result.position += share * centre;
        result.velocity += share * velocity;
        result.spin += share * bodies[b].twist.template tail<spin_size<D>>().squaredNorm();
        if (bodies[b].motion == Motion::free)
            result.energy += kinetic_energy(bodies[b]);
        result.force += share * wrenches[b].template head<D>();
        speeds.push_back(velocity.norm());
        heights.push_back(centre[height_axis]);
    }
    for (const RigidBody<D>& body : bodies)
        result.fluctuation += share * (body.twist.template head<D>() - result.velocity).cwiseAbs2();
    result.fluctuation = result.fluctuation.cwiseSqrt();
    result.spin = std::sqrt(result.spin);
    result.speed = percentiles<D>(speeds);
    result.largest_speed = speeds.back();
    result.height = percentiles<D>(heights);
    return result;
}

template <int D>
std::vector<CrowdLayer<D>> crowd_profile(const Scene& scene, std::span<const RigidBody<D>> bodies)
{
    const int axis = height_axis(scene);
    const double low = scene.origin[axis], extent = scene.size[axis];
    const bool periodic = scene.sides[2 * axis].kind == SideScene::Kind::periodic;
    double volume = 0;
    for (const RigidBody<D>& body : bodies)
        volume += body.volume / static_cast<double>(bodies.size());
    const double thickness = 2 * (D == 2 ? std::sqrt(volume / std::numbers::pi) : std::cbrt(0.75 * volume / std::numbers::pi));
    const int count =
        std::clamp(static_cast<int>(std::lround(std::min(extent / thickness, 1.0 * most_layers))), 1, most_layers);
    const double step = extent / count;
    double across = 1; // of a layer
    for (int other = 0; other < D; ++other)
        across *= other == axis ? step : scene.size[other];

    std::vector<CrowdLayer<D>> layers(static_cast<std::size_t>(count));
    std::vector<double> filled(layers.size());
    const auto add = [&](long layer, double part, const RigidBody<D>& body) {
        if (periodic)
            layer = ((layer % count) + count) % count;
        if (layer < 0 || layer >= count || part <= 0)
            return;
        const auto k = static_cast<std::size_t>(layer);
        filled[k] += part;
        layers[k].number += part / body.volume;
        layers[k].velocity += part * body.twist.template head<D>();
    };
    const auto layer_of = [&](double height) { return static_cast<long>(std::floor((height - low) / step)); };
    for (const RigidBody<D>& body : bodies) {
        const double radius = ball_radius(*body.shape);
        if (radius > 0) {
            const double centre = body.pose.position[axis];
            for (long k = layer_of(centre - radius); k <= layer_of(centre + radius); ++k) {
                const double floor = low + static_cast<double>(k) * step - centre;
                add(k, ball_below<D>(radius, floor + step) - ball_below<D>(radius, floor), body);
            }
        } else {
            const std::vector<Vec<D>> points = points_in(*body.shape, body.centre_of_volume);
            const Mat<D> rotation = body.pose.matrix();
            for (const Vec<D>& x : points)
                add(layer_of((body.pose.position + rotation * x)[axis]), body.volume / static_cast<double>(points.size()),
                    body);
        }
    }
    for (int k = 0; k < count; ++k) {
        CrowdLayer<D>& layer = layers[static_cast<std::size_t>(k)];
        const double solid = filled[static_cast<std::size_t>(k)];
        layer.height = low + (k + 0.5) * step;
        layer.volume_fraction = solid / across;
        layer.velocity =
            solid > 0 ? Vec<D>(layer.velocity / solid) : Vec<D>::Constant(std::numeric_limits<double>::quiet_NaN());
    }
    return layers;
}

std::vector<std::string> crowd_columns(int dimension)
{
    std::vector<std::string> names{"number"};
    const auto add = [&](const std::string& before, const std::string& after = "") {
        for (int axis = 0; axis < dimension; ++axis)
            names.push_back(before + "xyz"[axis] + after);
    };
    add("");
    add("v");
    add("v", "_rms");
    for (const char* name :
         {"spin_rms", "speed_p5", "speed_p50", "speed_p95", "speed_max", "height_p5", "height_p50", "height_p95", "energy"})
        names.emplace_back(name);
    add("f");
    return names;
}

std::vector<std::string> profile_columns(int dimension)
{
    std::vector<std::string> names{"height", "number", "volume_fraction", "vx", "vy"};
    if (dimension == 3)
        names.emplace_back("vz");
    return names;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template CrowdStatistics<D> crowd_statistics<D>(std::span<const RigidBody<D>>, std::span<const Twist<D>>, int);            \
    template std::vector<CrowdLayer<D>> crowd_profile<D>(const Scene&, std::span<const RigidBody<D>>);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
