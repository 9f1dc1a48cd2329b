// Shapes that know where a ray enters them are asked for that. Past others rays are traced with exact distances, sphere by sphere, then by the Illinois
// variant of regula falsi inside the last step.
#include "gapflow/viscosity/wall_rays.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gapflow {

namespace {

constexpr double smallest_stride = 0.05; // in dx: solids thinner than that are missed by grazing rays only
constexpr double accuracy = 1e-10;       // in dx
constexpr int most_bisections = 60;
constexpr double first_radius = 3.4; // in dx: solids within it are found first, and anew where a ray leaves them
constexpr double slack = 1e-9;       // in dx, for round-off

// No more than the signed distance. That of a mesh is dear, and its rays are asked for where it is small only: the distance to its bounds.
template <int D>
double at_least(const Image<D>& image, const Vec<D>& x)
{
    const Shape<D>& shape = image.shape.shape();
    if (shape.convex() || shape.inside_out())
        return image.shape.distance(x);
    const double outside = distance_to_bounds(image, x);
    return outside > 0 ? outside : -std::numeric_limits<double>::infinity();
}

} // namespace

template <int D>
void WallRays<D>::around(const Vec<D>& x, double reach)
{
    wanted_ = 2 * reach;
    const double radius = std::min(wanted_, first_radius * dx_);
    if (complete_ < radius || complete_ > wanted_ || x != centre_)
        find(x, radius);
}

template <int D>
void WallRays<D>::find(const Vec<D>& x, double radius)
{
    centre_ = x;
    complete_ = radius;
    clipper_.near(x, radius, found_);
    near_.clear();
    nearest_ = 0;
    for (int i : found_.images) {
        near_.push_back({i, at_least(image(i), x)});
        if (near_.back().phi < near_[nearest_].phi)
            nearest_ = near_.size() - 1;
    }
}

// A signed distance is 1-Lipschitz: at x it is no less than at the centre less the way between them. Of solids at the same distance the first.
template <int D>
double WallRays<D>::distance(const Vec<D>& x, int* image)
{
    for (;;) {
        const double way = (x - centre_).norm() + slack * dx_;
        double least = std::numeric_limits<double>::infinity();
        int which = -1;
        const auto look = [&](const Near& near) {
            const double phi = this->image(near.image).shape.distance(x);
            if (phi < least || (phi == least && near.image < which)) {
                least = phi;
                which = near.image;
            }
        };
        if (!near_.empty())
            look(near_[nearest_]);
        for (std::size_t k = 0; k < near_.size(); ++k)
            if (k != nearest_ && near_[k].phi - way <= least)
                look(near_[k]);
        if (complete_ < wanted_ && least > complete_ - way) {
            if (way < 0.5 * dx_)
                find(centre_, std::min(wanted_, 2 * complete_));
            else
                find(x, std::min(wanted_, first_radius * dx_));
            continue;
        }
        if (image && which >= 0)
            *image = which;
        return least;
    }
}

// A solid that the ray enters within the list's radius is listed. Beyond, the list is made anew where the ray leaves that.
template <int D>
std::optional<WallHit<D>> WallRays<D>::nearest_entry(const Vec<D>& x, const Vec<D>& direction, double longest)
{
    for (;;) {
        const Vec<D> from_centre = x - centre_;
        const double way = from_centre.norm() + slack * dx_;
        WallHit<D> hit{std::numeric_limits<double>::infinity(), -1};
        for (const Near& near : near_) {
            if (near.phi - way > std::min(hit.distance, longest))
                continue;
            const std::optional<double> t = image(near.image).shape.entry(x, direction);
            if (!t)
                return {};
            if (*t < hit.distance || (*t == hit.distance && near.image < hit.image))
                hit = {*t, near.image};
        }
        const double along = from_centre.dot(direction), radius = complete_ - slack * dx_,
                     square = radius * radius - from_centre.squaredNorm() + along * along;
        const double known = complete_ >= wanted_ ? longest : square > 0 ? -along + std::sqrt(square) : 0.0;
        if (hit.distance <= std::min(known, longest))
            return hit;
        if (known >= longest)
            return WallHit<D>{};
        find(x + std::max(known, 0.0) * direction, std::min(wanted_, first_radius * dx_));
    }
}

template <int D>
WallHit<D> WallRays<D>::cast(const Vec<D>& x, const Vec<D>& direction, double longest)
{
    WallHit<D> start;
    const double phi = distance(x, &start.image);
    if (phi <= 0)
        return start;
    if (const std::optional<WallHit<D>> entry = nearest_entry(x, direction, longest))
        return *entry;
    return trace(x, direction, longest, start, phi);
}

template <int D>
WallHit<D> WallRays<D>::trace(const Vec<D>& x, const Vec<D>& direction, double longest, const WallHit<D>& start,
                              double phi_start)
{
    WallHit<D> hit = start;
    double before = 0, phi_before = phi_start;
    double t = 0, phi = phi_before;
    while (phi > accuracy * dx_) {
        if (t >= longest)
            return {};
        before = t;
        phi_before = phi;
        t = std::min(t + std::max(phi, smallest_stride * dx_), longest);
        phi = distance(x + t * direction, &hit.image);
    }
    int side = 0;
    for (int i = 0; i < most_bisections && phi < -accuracy * dx_; ++i) {
        const double middle = (before * phi - t * phi_before) / (phi - phi_before);
        int image = hit.image;
        const double value = distance(x + middle * direction, &image);
        if (value > 0) {
            before = middle;
            phi_before = value;
            if (side == 1)
                phi *= 0.5;
            side = 1;
            if (value <= accuracy * dx_ || t - before <= accuracy * dx_)
                break;
        } else {
            t = middle;
            phi = value;
            hit.image = image;
            if (side == -1)
                phi_before *= 0.5;
            side = -1;
        }
    }
    hit.distance = phi < -accuracy * dx_ ? before : t;
    return hit;
}

template class WallRays<2>;
template class WallRays<3>;

} // namespace gapflow
