#include "gapflow/geometry/thickness.hpp"

#include "gapflow/geometry/solid.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

namespace gapflow {

namespace {

constexpr double patch_radius = 1.5;              // in cells
constexpr double sample_spacing = 0.5;            // in cells, and ...
constexpr double samples_across = 12;             // ... of a small body's size
constexpr double facing = 0.866;                  // cosine of the angle between a normal and the opposite one, turned round
constexpr double steady = 1.2;                    // a patch's thickness rises by no more than that: else it is a wedge
constexpr double thick_part = 0.1;                // of a patch that may be thicker than asked for
constexpr double low_part = 0.1, high_part = 0.9; // quantiles of a patch's thickness

template <int D>
struct Sample {
    Vec<D> x, middle;
    Vec<D> place() const { return faces ? middle : x; } ///< its position in patches: of a sheet the same for both sides
    double thickness;                                   ///< most: not thinner
    bool faces;                                         ///< an opposite surface
};

/// Whether all corners of a facet lie beyond one side of the box.
template <int D>
bool beyond_a_side(const PlacedShape<D>& solid, const std::array<Vec<D>, D>& corners, const Bounds<D>& box)
{
    Vec<D> low = solid.to_world(corners[0]), high = low;
    for (int i = 1; i < D; ++i) {
        const Vec<D> x = solid.to_world(corners[i]);
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
    }
    return (low.array() > box.high.array()).any() || (high.array() < box.low.array()).any();
}

/// Points spread over the solid's surface, no more than some in a box of this size; if `within` is given, only inside it.
template <int D>
std::vector<Vec<D>> points_on(const PlacedShape<D>& solid, double spacing, const std::optional<Bounds<D>>& within)
{
    const SurfaceMesh<D> mesh = solid.shape().display_mesh(0.1 * spacing);
    std::set<std::array<int, D + 1>> taken;
    std::vector<Vec<D>> points;
    const auto add = [&](const Vec<D>& x, const Vec<D>& normal) {
        std::array<int, D + 1> key{};
        for (int axis = 0; axis < D; ++axis) {
            key[axis] = static_cast<int>(std::floor(x[axis] / spacing));
            key[D] = 2 * key[D] + (normal[axis] > 0);
        }
        if (taken.insert(key).second)
            points.push_back(solid.to_world(x));
    };
    for (const auto& element : mesh.elements) {
        std::vector<std::array<Vec<D>, D>> parts(1);
        for (int i = 0; i < D; ++i)
            parts[0][i] = mesh.vertices[element[i]];
        Vec<D> normal;
        if constexpr (D == 2)
            normal = Vec<2>(parts[0][1][1] - parts[0][0][1], parts[0][0][0] - parts[0][1][0]);
        else
            normal = (parts[0][1] - parts[0][0]).cross(parts[0][2] - parts[0][0]);
        while (!parts.empty()) {
            const std::array<Vec<D>, D> part = parts.back();
            parts.pop_back();
            if (within && beyond_a_side<D>(solid, part, *within))
                continue;
            int from = 0, to = 1;
            for (int i = 0; i < D; ++i)
                for (int k = i + 1; k < D; ++k)
                    if ((part[i] - part[k]).squaredNorm() > (part[from] - part[to]).squaredNorm())
                        from = i, to = k;
            if ((part[from] - part[to]).norm() > spacing) {
                const Vec<D> half = 0.5 * (part[from] + part[to]);
                for (int end : {from, to}) {
                    parts.push_back(part);
                    parts.back()[end] = half;
                }
                continue;
            }
            Vec<D> sum = Vec<D>::Zero();
            for (const Vec<D>& x : part)
                sum += x;
            add(sum / D, normal);
        }
    }
    return points;
}

/// The largest ball inside the solid that touches its surface at x, by balls that shrink from the diameter `most` until nothing
/// of the surface is within (Ma, Bae and Choi, Vis. Comput. 28, 2012).
template <int D>
Sample<D> inscribed(const PlacedShape<D>& solid, const Vec<D>& near, double most,
                    const std::function<double(const Vec<D>&, const Vec<D>&)>& beyond)
{
    const SurfacePoint<D> start = solid.closest(near);
    Sample<D> sample{start.x, start.x, most, false};
    double radius = 0.5 * most;
    Vec<D> opposite = start.x, normal = start.normal;
    for (int tries = 0; tries < 60; ++tries) {
        const SurfacePoint<D> p = solid.closest(start.x - radius * start.normal);
        if (std::abs(p.distance) >= (1 - 1e-6) * radius)
            break;
        const Vec<D> across = start.x - p.x;
        const double along = start.normal.dot(across), smaller = along > 0 ? across.squaredNorm() / (2 * along) : 0.0;
        if (!(smaller > 0) || smaller >= radius) // the point itself, to round-off
            break;
        radius = smaller;
        opposite = p.x;
        normal = p.normal;
    }
    sample.middle = start.x - radius * start.normal;
    sample.thickness = 2 * radius;
    if (sample.thickness >= (1 - 1e-6) * most)
        sample.thickness = most;
    else if (beyond)
        sample.thickness = std::min(most, sample.thickness + beyond(start.x, start.normal) + beyond(opposite, normal));
    sample.faces = normal.dot(start.normal) < -facing;
    return sample;
}

/// Samples by the boxes of a patch's size that they lie in.
template <int D>
class Patches {
public:
    Patches(const std::vector<Sample<D>>& samples, double radius) : samples_(samples), radius_(radius)
    {
        for (std::size_t i = 0; i < samples.size(); ++i)
            boxes_[box(samples[i].place())].push_back(static_cast<int>(i));
    }

    /// The thickness of the patch around a sample; `most` if it is none.
    double thickness(const Sample<D>& centre, double most) const
    {
        int count = 0, thick = 0;
        std::vector<double> found;
        const std::array<int, D> middle = box(centre.place());
        for (int k = 0; k < (D == 2 ? 9 : 27); ++k) {
            std::array<int, D> key = middle;
            for (int axis = 0, rest = k; axis < D; ++axis, rest /= 3)
                key[axis] += rest % 3 - 1;
            const auto in_box = boxes_.find(key);
            if (in_box == boxes_.end())
                continue;
            for (int i : in_box->second) {
                const Sample<D>& sample = samples_[i];
                if ((sample.place() - centre.place()).norm() > radius_)
                    continue;
                ++count;
                if (sample.thickness >= most)
                    ++thick;
                if (sample.faces || sample.thickness >= most)
                    found.push_back(sample.thickness);
            }
        }
        if (thick > thick_part * count || 2 * found.size() < static_cast<std::size_t>(count))
            return most;
        const auto quantile = [&](double part) {
            const auto at = found.begin() + std::lround(part * static_cast<double>(found.size() - 1));
            std::nth_element(found.begin(), at, found.end());
            return *at;
        };
        const double high = quantile(high_part);
        return high <= steady * quantile(low_part) ? high : most;
    }

private:
    std::array<int, D> box(const Vec<D>& x) const
    {
        std::array<int, D> key;
        for (int axis = 0; axis < D; ++axis)
            key[axis] = static_cast<int>(std::floor(x[axis] / radius_));
        return key;
    }

    const std::vector<Sample<D>>& samples_;
    double radius_;
    std::map<std::array<int, D>, std::vector<int>> boxes_;
};

} // namespace

template <int D>
Thickness<D> sheet_thickness(const PlacedShape<D>& solid, double cell, double most,
                             const std::function<double(const Vec<D>&, const Vec<D>&)>& beyond, const Bounds<D>& within)
{
    const Shape<D>& shape = solid.shape();
    const Bounds<D> bounds = shape.bounds();
    Thickness<D> result{most, Vec<D>::Zero()};
    if (shape.inside_out() || !bounds.low.allFinite() || !bounds.high.allFinite())
        return result;
    const Vec<D> size = bounds.high - bounds.low;
    const bool exact = !shape.planes().empty() || !shape.cores().empty(); // as thick as its bounds are narrow
    if (exact && size.minCoeff() >= (1 - 1e-6) * most)
        return result;

    std::optional<Bounds<D>> part; // of the surface, with the patches that reach into it
    const Bounds<D> all = world_bounds(solid);
    if (((all.high - all.low).array() > (within.high - within.low).array()).any())
        part = Bounds<D>{within.low.array() - patch_radius * cell, within.high.array() + patch_radius * cell};
    std::vector<Sample<D>> samples;
    for (const Vec<D>& x : points_on(solid, std::min(sample_spacing * cell, size.norm() / samples_across), part))
        samples.push_back(inscribed(solid, x, most, beyond));
    if (samples.empty())
        return result;
    if (!part) {
        const auto thickest = std::max_element(
            samples.begin(), samples.end(), [](const Sample<D>& a, const Sample<D>& b) { return a.thickness < b.thickness; });
        result = {thickest->thickness, thickest->middle};
    }
    if (result.value < most) { // the middle of a star touches its surface at inner corners only
        constexpr int lattice = D == 2 ? 24 : 12;
        for (int k = 0; k < static_cast<int>(std::pow(lattice, D) + 0.5); ++k) {
            Vec<D> x = bounds.low;
            for (int axis = 0, rest = k; axis < D; ++axis, rest /= lattice)
                x[axis] += (rest % lattice + 0.5) / lattice * size[axis];
            if (const double inside = -2 * shape.distance(x); inside > result.value)
                result = {std::min(most, inside), solid.to_world(x)};
        }
    }
    const Patches<D> patches(samples, patch_radius * cell);
    for (const Sample<D>& sample : samples) {
        if (!sample.faces || sample.thickness >= result.value)
            continue;
        const double value = patches.thickness(sample, most);
        if (value < (1 - 1e-6) * result.value)
            result = {value, sample.middle};
    }
    return result;
}

template Thickness<2> sheet_thickness<2>(const PlacedShape<2>&, double, double,
                                         const std::function<double(const Vec<2>&, const Vec<2>&)>&, const Bounds<2>&);
template Thickness<3> sheet_thickness<3>(const PlacedShape<3>&, double, double,
                                         const std::function<double(const Vec<3>&, const Vec<3>&)>&, const Bounds<3>&);

} // namespace gapflow
