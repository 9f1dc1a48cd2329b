// Sphere tracing with exact distances, then the Illinois variant of regula falsi inside the last step.
#include "gapflow/viscosity/wall_rays.hpp"

#include <algorithm>
#include <limits>

namespace gapflow {

namespace {

constexpr double smallest_stride = 0.05; // in dx: solids thinner than that are missed by grazing rays only
constexpr double accuracy = 1e-10;       // in dx
constexpr int most_bisections = 60;

} // namespace

template <int D>
double WallRays<D>::distance(const Vec<D>& x, int* image) const
{
    double least = std::numeric_limits<double>::infinity();
    for (int i : near_) {
        const double phi = clipper_.images()[i].shape.distance(x);
        if (phi < least) {
            least = phi;
            if (image)
                *image = i;
        }
    }
    return least;
}

template <int D>
WallHit<D> WallRays<D>::cast(const Vec<D>& x, const Vec<D>& direction, double longest) const
{
    WallHit<D> hit;
    if (near_.empty())
        return hit;
    double before = 0, phi_before = distance(x, &hit.image);
    if (phi_before <= 0)
        return hit;
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
