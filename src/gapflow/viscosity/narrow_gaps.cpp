#include "gapflow/viscosity/narrow_gaps.hpp"

#include <algorithm>

namespace gapflow {

namespace {

// Gaps of up to this many cells get the drag that the lattice lacks.
constexpr double thin_gap = 8;
// Surfaces of a gap face each other: cosine of their normals at most.
constexpr double opposed = -0.5;

} // namespace

template <int D>
std::optional<NarrowGap<D>> NarrowGaps<D>::narrow_gap(WallRays<D>& rays, const Vec<D>& x) const
{
    rays.around(x, thin_gap * grid_.dx());
    NarrowGap<D> gap;
    int image = -1;
    const double phi = rays.distance(x, &image);
    if (image < 0 || phi <= least_distance * grid_.dx() || phi > ray_length * grid_.dx())
        return {};
    const SurfacePoint<D> wall = faces_.image(image).shape.closest(x);
    const WallHit<D> far = rays.cast(x, wall.normal, thin_gap * grid_.dx() - phi);
    if (far.image < 0)
        return {};
    const Vec<D> beyond = x + far.distance * wall.normal;
    if (wall.normal.dot(faces_.image(far.image).shape.closest(beyond).normal) > opposed)
        return {};
    gap.image = {image, far.image};
    gap.foot = {wall.x, beyond};
    gap.x = x;
    gap.normal = wall.normal;
    gap.near = phi / grid_.dx();
    gap.width = gap.near + far.distance / grid_.dx();
    gap.value = gap.lacking = 0;
    return gap;
}

// Mean of y (h - y) / 2 over the part `open` of a face around its centroid: the value there minus a term for the profile's curvature.
template <int D>
double NarrowGaps<D>::face_mean(const NarrowGap<D>& gap, int axis, const Vec<D>& centroid, double open) const
{
    const double y = gap.near + gap.normal.dot(centroid - gap.x) / grid_.dx();
    const double spread = (1 - gap.normal[axis] * gap.normal[axis]) * (D == 2 ? open * open : open) / 12;
    return 0.5 * y * (gap.width - y) - 0.5 * spread;
}

// The lattice's value in the same flow at a face of the gap.
template <int D>
double NarrowGaps<D>::lattice_value(WallRays<D>& rays, const NarrowGap<D>& gap, int axis, const Index<D>& f) const
{
    const int cut = fractions_.cut(axis, f);
    if (cut < 0)
        return face_mean(gap, axis, grid_.face_centre(axis, f), 1.0);
    const LatticeFace<D> face = faces_.examine(rays, axis, f);
    const ClippedFace<D>& part = fractions_.faces[cut];
    return face_mean(gap, axis, part.open_centroid, part.open) / face.share;
}

template <int D>
std::optional<NarrowGap<D>> NarrowGaps<D>::find(WallRays<D>& rays, int axis, const Index<D>& f, double share) const
{
    std::optional<NarrowGap<D>> gap = narrow_gap(rays, grid_.face_centre(axis, f));
    if (!gap)
        return {};
    gap->value = lattice_value(rays, *gap, axis, f);
    if (!(gap->value > 0))
        return {};
    gap->lacking = share * coupling_.open(axis, f);
    for (int k = 0; k < D; ++k)
        for (int end = 0; end < 2; ++end) {
            const int sign = 2 * end - 1;
            const Index<D> g = f + sign * step<D>(k);
            if (system_.active(axis, g)) {
                gap->lacking -= gap->value - lattice_value(rays, *gap, axis, g);
                continue;
            }
            rays.around(gap->x, ray_length * grid_.dx());
            const WallHit<D> hit = rays.cast(gap->x, sign * unit<D>(k), ray_length * grid_.dx());
            if (hit.image >= 0)
                gap->lacking -= gap->value / std::max(hit.distance / grid_.dx(), least_distance);
        }
    return gap;
}

template <int D>
void NarrowGaps<D>::pass_on(int axis, long leader, double force)
{
    if (const auto gap = gaps_.find({axis, leader}); gap != gaps_.end())
        gap->second.lacking += force;
}

template <int D>
void NarrowGaps<D>::add_drag(int axis, long at, const NarrowGap<D>& gap, ViscousTerms<D>& terms)
{
    if (gap.lacking <= 0)
        return;
    ViscousTerm<D> term{axis, at, system_.edge * gap.lacking / gap.value, 1, 0, {-1, -1}, {}};
    const double part = gap.near / gap.width;
    for (int k = 0; k < 2; ++k) {
        term.solid[k] = faces_.image(gap.image[k]).solid;
        term.row[k] = -(k == 0 ? 1 - part : part) * faces_.row(gap.image[k], axis, gap.foot[k]);
    }
    terms.add(term);
}

template <int D>
void NarrowGaps<D>::add_drag(ViscousTerms<D>& terms)
{
    for (const auto& [place, gap] : gaps_)
        add_drag(place.first, place.second, gap, terms);
}

template <int D>
double NarrowGaps<D>::stiffen(WallRays<D>& rays, int axis, const Index<D>& f, const LatticeFace<D>& face,
                              const Index<D>& leader, FollowingFace<D>& following) const
{
    const std::optional<NarrowGap<D>> gap = narrow_gap(rays, grid_.face_centre(axis, leader));
    const double open = coupling_.open(axis, f);
    if (!gap)
        return 0;
    const double led = following.share * lattice_value(rays, *gap, axis, leader),
                 own = face_mean(*gap, axis, face.centroid, open);
    if (own > led * (1 + 1e-6))
        following.stiffness = std::max(following.stiffness, system_.edge * open / (own - led));
    return following.share * open;
}

template class NarrowGaps<2>;
template class NarrowGaps<3>;

} // namespace gapflow
