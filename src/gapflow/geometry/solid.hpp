// Solids in the fluid: shapes at their poses, domain walls included, and their images in a periodic domain.
#pragma once

#include "gapflow/geometry/pose.hpp"

#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace gapflow {

enum class Motion { free, prescribed, fixed };

/// A rigid body or a closed side of the domain.
template <int D>
struct Solid {
    std::string name;
    PlacedShape<D> shape;
    Vec<D> centre = Vec<D>::Zero(); ///< reference point of its twist and wrench: the centre of mass
    Motion motion = Motion::fixed;
    bool wall = false; ///< a closed side of the domain: a half-space that owns the whole side's faces
    /// Of a free body: the orthogonal projector onto the twists that its constraints admit.
    TwistMatrix<D> admissible = TwistMatrix<D>::Identity();
};

/// P M P + m (1 - P), the mass of the twists that a body can have; its mass m keeps it definite. Its inverse leaves an admissible twist
/// admissible.
template <int D>
TwistMatrix<D> admissible_mass(const TwistMatrix<D>& P, const TwistMatrix<D>& M, double m)
{
    return P * M * P + m * (TwistMatrix<D>::Identity() - P);
}

/// A solid displaced by whole periods.
template <int D>
struct Image {
    int solid; ///< index into the list of solids
    Vec<D> shift;
    PlacedShape<D> shape;
    Bounds<D> bounds; ///< of the surface, in the world
};

/// Lower bound of the distance of x from an image: from its bounds; 0 within them and of images turned inside out.
template <int D>
double distance_to_bounds(const Image<D>& image, const Vec<D>& x)
{
    const double outside = (image.bounds.low - x).cwiseMax(x - image.bounds.high).cwiseMax(0).norm();
    return outside > 0 && image.shape.shape().inside_out() ? 0.0 : outside;
}

/// World bounds of a placed shape's surface (from the corners of its body-frame bounds).
template <int D>
Bounds<D> world_bounds(const PlacedShape<D>& shape);

/// All images of the solids whose surface comes within `margin` of the box low..high; the solids themselves first among
/// theirs. Axes with period 0 are not periodic. Unbounded solids have no images but themselves. Solids that are inside out
/// (whose solid part is unbounded) are kept whether or not their surface comes near.
template <int D>
std::vector<Image<D>> images(std::span<const Solid<D>> solids, const Vec<D>& low, const Vec<D>& high, const Vec<D>& period,
                             double margin);

/// Half the diagonal; infinite for unbounded solids.
template <int D>
double bounding_radius(const Bounds<D>& bounds);

/// Pairs of images, of different solids or of one, not both walls, whose surfaces may come within `reach`. Sweep along the first axis.
template <int D>
std::vector<std::pair<int, int>> close_images(const std::vector<Image<D>>& images, std::span<const Solid<D>> solids,
                                              double reach);

} // namespace gapflow
