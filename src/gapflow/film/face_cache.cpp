#include "gapflow/film/face_cache.hpp"

#include <algorithm>
#include <utility>

namespace gapflow {

namespace {

// A solid of at least this many cells in every direction does not divide the open part of a face.
constexpr double thick = 2;

} // namespace

template <int D>
long FaceCache<D>::key(int axis, const Index<D>& f) const
{
    const Index<D> s = grid_->wrapped(f);
    long k = 0;
    for (int a = D - 1; a >= 0; --a)
        k = k * (grid_->cells()[a] + 1) + s[a];
    return k * D + axis;
}

template <int D>
bool FaceCache<D>::mine(int axis, const Index<D>& stored) const
{
    return (stored.array() >= grid_->low().array()).all() && (stored.array() < (grid_->high() + step<D>(axis)).array()).all();
}

template <int D>
const ClippedFace<D>& FaceCache<D>::clipped(int axis, const Index<D>& stored) const
{
    const long k = key(axis, stored);
    {
        const std::lock_guard lock(mutex_);
        if (const int* number = numbers_.find(k))
            return faces_[*number];
    }
    ClippedFace<D> face;
    clipper_->clip(axis, stored, face);
    const std::lock_guard lock(mutex_);
    const auto [number, is_new] = numbers_.insert(k, static_cast<int>(faces_.size()));
    if (is_new)
        faces_.push_back(std::move(face));
    return faces_[number];
}

template <int D>
double FaceCache<D>::open(int axis, const Index<D>& f) const
{
    const Index<D> s = grid_->wrapped(f);
    return mine(axis, s) ? fractions_->open(axis, s) : clipped(axis, s).open;
}

template <int D>
std::span<const SolidPart<D>> FaceCache<D>::parts(int axis, const Index<D>& f) const
{
    const Index<D> s = grid_->wrapped(f);
    const ClippedFace<D>* face;
    if (mine(axis, s)) {
        const int cut = fractions_->cut(axis, s);
        if (cut < 0)
            return {};
        face = &fractions_->faces[cut];
    } else {
        face = &clipped(axis, s);
    }
    return {face->solid.begin(), face->solid.size()};
}

template <int D>
Vec<D> FaceCache<D>::displacement(const Index<D>& f) const
{
    return grid_->dx() * (f - grid_->wrapped(f)).template cast<double>();
}

template <int D>
Vec<D> FaceCache<D>::open_centroid(int axis, const Index<D>& f) const
{
    const Index<D> s = grid_->wrapped(f);
    if (mine(axis, s)) {
        const int cut = fractions_->cut(axis, s);
        return (cut < 0 ? grid_->face_centre(axis, s) : fractions_->faces[cut].open_centroid) + displacement(f);
    }
    return clipped(axis, s).open_centroid + displacement(f);
}

template <int D>
bool FaceCache<D>::centroid_stands(std::span<const SolidPart<D>> parts, const Vec<D>& centroid) const
{
    return std::all_of(parts.begin(), parts.end(), [&](const SolidPart<D>& part) {
        const Solid<D>& solid = solids_[part.solid];
        const Bounds<D> bounds = solid.shape.shape().bounds();
        const Vec<D> image = part.centroid - part.arm - solid.centre;
        return (bounds.high - bounds.low).minCoeff() >= thick * grid_->dx() &&
               solid.shape.shifted(image).distance(centroid) > clipper_->tolerance();
    });
}

template <int D>
Vec<D> FaceCache<D>::open_point(int axis, const Index<D>& f) const
{
    const Index<D> s = grid_->wrapped(f);
    const std::span<const SolidPart<D>> parts = this->parts(axis, s);
    if (const Vec<D> centroid = open_centroid(axis, s); centroid_stands(parts, centroid))
        return centroid + displacement(f);
    const long k = key(axis, s);
    {
        const std::lock_guard lock(mutex_);
        if (const Vec<D>* point = open_points_.find(k))
            return *point + displacement(f);
    }
    const Vec<D> point = clipper_->deepest_open_centroid(axis, s);
    const std::lock_guard lock(mutex_);
    open_points_.insert(k, point);
    return point + displacement(f);
}

template class FaceCache<2>;
template class FaceCache<3>;

} // namespace gapflow
