// How far it is from a point of the fluid to the next solid along a straight line.
#pragma once

#include "gapflow/grid/face_fractions.hpp"

#include <vector>

namespace gapflow {

/// Where a ray first meets a solid.
template <int D>
struct WallHit {
    double distance = 0;
    int image = -1; ///< index into FaceClipper::images(), -1: nothing within reach
};

/// Rays near one place of the grid: finds the solids around it once.
template <int D>
class WallRays {
public:
    WallRays(const FaceClipper<D>& clipper, double dx) : clipper_(clipper), dx_(dx) {}
    /// From now on rays start within `reach` of x and are no longer than that.
    void around(const Vec<D>& x, double reach) { clipper_.near(x, 2 * reach, near_); }
    /// Signed distance to the nearest solid; `image` receives it. Infinite where none is near.
    double distance(const Vec<D>& x, int* image = nullptr) const;
    /// `direction`: of unit length. A start inside a solid hits it at distance 0.
    WallHit<D> cast(const Vec<D>& x, const Vec<D>& direction, double longest) const;
    /// The image that is near, if there is only one; else -1.
    int lone_image() const { return near_.size() == 1 ? near_.front() : -1; }
    const Image<D>& image(int i) const { return clipper_.images()[i]; }

private:
    const FaceClipper<D>& clipper_;
    double dx_;
    std::vector<int> near_;
};

} // namespace gapflow
