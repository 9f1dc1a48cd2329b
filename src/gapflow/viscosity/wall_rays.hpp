// How far it is from a point of the fluid to the next solid along a straight line.
#pragma once

#include "gapflow/grid/face_fractions.hpp"

#include <optional>
#include <vector>

namespace gapflow {

/// Where a ray first meets a solid.
template <int D>
struct WallHit {
    double distance = 0;
    int image = -1; ///< index into FaceClipper::images(), -1: nothing within reach
};

/// Rays near one place of the grid: finds the solids around it once, those farther away only if a ray comes so far.
template <int D>
class WallRays {
public:
    WallRays(const FaceClipper<D>& clipper, double dx) : clipper_(clipper), dx_(dx) {}
    /// From now on rays start within `reach` of x and are no longer than that.
    void around(const Vec<D>& x, double reach);
    /// Signed distance to the nearest solid; `image` receives it. Infinite where none is near.
    double distance(const Vec<D>& x, int* image = nullptr);
    /// `direction`: of unit length. A start inside a solid hits it at distance 0.
    WallHit<D> cast(const Vec<D>& x, const Vec<D>& direction, double longest);
    const Image<D>& image(int i) const { return clipper_.images()[i]; }

private:
    struct Near {
        int image;
        double phi; ///< at the centre; of meshes a lower bound
    };

    void find(const Vec<D>& x, double radius);
    /// The least entry of the solids that the ray from x may reach; empty if one of them has no closed form.
    std::optional<WallHit<D>> nearest_entry(const Vec<D>& x, const Vec<D>& direction, double longest);
    WallHit<D> trace(const Vec<D>& x, const Vec<D>& direction, double longest, const WallHit<D>& start, double phi_start);

    const FaceClipper<D>& clipper_;
    double dx_;
    Vec<D> centre_;
    double wanted_ = 0;   ///< solids beyond this count nowhere
    double complete_ = 0; ///< those within this of the centre are listed; 0: no list yet
    std::vector<Near> near_;
    std::size_t nearest_ = 0; ///< to the centre
    typename FaceClipper<D>::Nearby found_;
};

} // namespace gapflow
