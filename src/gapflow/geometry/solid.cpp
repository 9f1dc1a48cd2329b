#include "gapflow/geometry/solid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gapflow {

template <int D>
Bounds<D> world_bounds(const PlacedShape<D>& shape)
{
    const Bounds<D> body = shape.shape().bounds();
    Bounds<D> world;
    if (!body.low.allFinite() || !body.high.allFinite())
        return world;
    const Vec<D> centre = shape.to_world(0.5 * (body.low + body.high));
    const Vec<D> half = shape.rotation().cwiseAbs() * (0.5 * (body.high - body.low));
    world.low = centre - half;
    world.high = centre + half;
    return world;
}

template <int D>
std::vector<Image<D>> images(std::span<const Solid<D>> solids, const Vec<D>& low, const Vec<D>& high, const Vec<D>& period,
                             double margin)
{
    std::vector<Image<D>> result;
    for (int s = 0; s < static_cast<int>(solids.size()); ++s) {
        const Bounds<D> bounds = world_bounds(solids[s].shape);
        if (!bounds.low.allFinite()) {
            result.push_back({s, Vec<D>::Zero(), solids[s].shape, bounds});
            continue;
        }
        // Shifts k * period for which [bounds + shift] meets [low - margin, high + margin].
        Index<D> first = Index<D>::Zero(), last = Index<D>::Zero();
        for (int axis = 0; axis < D; ++axis)
            if (period[axis] > 0) {
                first[axis] = static_cast<int>(std::ceil((low[axis] - margin - bounds.high[axis]) / period[axis]));
                last[axis] = static_cast<int>(std::floor((high[axis] + margin - bounds.low[axis]) / period[axis]));
            }
        const std::size_t begin = result.size();
        auto add = [&](const Index<D>& k) {
            const Vec<D> shift = k.template cast<double>().cwiseProduct(period);
            const Bounds<D> moved{bounds.low + shift, bounds.high + shift};
            const bool meets =
                (moved.high.array() >= low.array() - margin).all() && (moved.low.array() <= high.array() + margin).all();
            if (!meets && !solids[s].shape.shape().inside_out())
                return;
            Image<D> image{s, shift, solids[s].shape.shifted(shift), moved};
            if (shift.isZero(0) && result.size() > begin)
                result.insert(result.begin() + static_cast<long>(begin), image);
            else
                result.push_back(image);
        };
        Index<D> k;
        for (k[0] = first[0]; k[0] <= last[0]; ++k[0])
            for (k[1] = first[1]; k[1] <= last[1]; ++k[1]) {
                if constexpr (D == 3) {
                    for (k[2] = first[2]; k[2] <= last[2]; ++k[2])
                        add(k);
                } else {
                    add(k);
                }
            }
    }
    return result;
}

template <int D>
double bounding_radius(const Bounds<D>& bounds)
{
    return bounds.low.allFinite() ? 0.5 * (bounds.high - bounds.low).norm() : std::numeric_limits<double>::infinity();
}

template <int D>
std::vector<std::pair<int, int>> close_images(const std::vector<Image<D>>& images, std::span<const Solid<D>> solids,
                                              double reach)
{
    std::vector<int> bounded, unbounded;
    for (int i = 0; i < static_cast<int>(images.size()); ++i)
        (images[i].bounds.low.allFinite() ? bounded : unbounded).push_back(i);
    std::sort(bounded.begin(), bounded.end(), [&](int a, int b) { return images[a].bounds.low[0] < images[b].bounds.low[0]; });
    std::vector<std::pair<int, int>> pairs;
    auto near = [&](int a, int b) { // the smaller one's bounding ball against the other's distance
        if (solids[images[a].solid].wall && solids[images[b].solid].wall)
            return;
        auto apart = [&](const Image<D>& ball, const Image<D>& other) {
            const double radius = bounding_radius<D>(ball.bounds);
            return std::isfinite(radius) && other.shape.distance(0.5 * (ball.bounds.low + ball.bounds.high)) > radius + reach;
        };
        if (!apart(images[a], images[b]) && !apart(images[b], images[a]))
            pairs.emplace_back(a, b);
    };
    for (std::size_t i = 0; i < bounded.size(); ++i) {
        const Bounds<D>& a = images[bounded[i]].bounds;
        for (std::size_t j = i + 1; j < bounded.size(); ++j) {
            const Bounds<D>& b = images[bounded[j]].bounds;
            if (b.low[0] > a.high[0] + reach)
                break;
            if (((a.high.array() + reach) >= b.low.array()).all() && ((b.high.array() + reach) >= a.low.array()).all())
                near(bounded[i], bounded[j]);
        }
        for (int u : unbounded)
            near(bounded[i], u);
    }
    return pairs;
}

template Bounds<2> world_bounds<2>(const PlacedShape<2>&);
template Bounds<3> world_bounds<3>(const PlacedShape<3>&);
template std::vector<Image<2>> images<2>(std::span<const Solid<2>>, const Vec<2>&, const Vec<2>&, const Vec<2>&, double);
template std::vector<Image<3>> images<3>(std::span<const Solid<3>>, const Vec<3>&, const Vec<3>&, const Vec<3>&, double);

template double bounding_radius<2>(const Bounds<2>&);
template double bounding_radius<3>(const Bounds<3>&);
template std::vector<std::pair<int, int>> close_images<2>(const std::vector<Image<2>>&, std::span<const Solid<2>>, double);
template std::vector<std::pair<int, int>> close_images<3>(const std::vector<Image<3>>&, std::span<const Solid<3>>, double);

} // namespace gapflow
