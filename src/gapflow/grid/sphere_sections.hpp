// The discs in which the plane of a face cuts spheres, and what each solid has of them. Private to grid/.
#pragma once

#include "gapflow/grid/clip_disc.hpp"

#include <vector>

namespace gapflow {

/// Sections of the spheres among the solids that cut a face, with coordinates along the face's tangents from its corner. Overlaps of no more
/// than the tolerance, as solids in contact have: a hollow sphere keeps what lies in a ball too; two balls' discs are split along the
/// line through the points where their circles cross.
class SphereSections {
public:
    /// False, and there are none: a curved solid is no sphere, or one of the spheres overlaps another solid by more than the tolerance (or
    /// may do so: a hollow one and a flat solid).
    bool take(const Vec<3>& corner, const std::array<int, 2>& tangents, std::span<const Cutter<3>> cutters, double tolerance);
    void clear() { sections_.clear(); }
    bool empty() const { return sections_.empty(); }

    /// Of a cutter that is a sphere.
    struct Section {
        std::size_t cutter;
        Disc disc; ///< radius 0: the plane misses the sphere
        bool hollow;
    };
    const std::vector<Section>& sections() const { return sections_; }
    /// What a section's solid has of a convex polygon (counterclockwise).
    PartSum<3> part(const Section& section, std::span<const Eigen::Vector2d> polygon) const;

private:
    PartSum<3> part_of_ball(const Section& ball, std::span<const Eigen::Vector2d> polygon) const;

    std::vector<Section> sections_;
};

} // namespace gapflow
