#include "gapflow/viscosity/viscous_faces.hpp"

#include "gapflow/core/threads.hpp"

#include <cmath>
#include <mutex>
#include <utility>

namespace gapflow {

namespace {

// A cut face whose mean velocity (relative to the solid) is this many times that at its centre follows a neighbour instead.
constexpr double largest_share = 2.0;
// Open fraction from which a face counts as whole.
constexpr double whole = 1 - 1e-9;

} // namespace

// The walls' solids by side.
template <int D>
void ViscousFaces<D>::find_walls()
{
    wall_.fill(-1);
    for (int axis = 0; axis < D; ++axis)
        for (int end = 0; end < 2; ++end) {
            if (grid_.side(axis, end) != SideKind::wall)
                continue;
            Vec<D> x = grid_.origin() + 0.5 * grid_.size();
            x[axis] = grid_.origin()[axis] + end * grid_.size()[axis];
            for (std::size_t s = 0; s < coupling_.solids.size(); ++s) {
                if (!coupling_.solids[s].wall)
                    continue;
                const SurfacePoint<D> p = coupling_.solids[s].shape.closest(x);
                if (std::abs(p.distance) < 1e-6 * grid_.dx() && p.normal[axis] * (end ? -1 : 1) > 0.5)
                    wall_[2 * axis + end] = static_cast<int>(s);
            }
        }
}

template <int D>
void ViscousFaces<D>::mark_surfaces()
{
    surface_ = CellField<D, std::int8_t>(grid_);
    for (const Index<D>& c : fractions_.surface_cells)
        surface_(c) = 1;
    exchange(grid_, surface_, 1);
}

// Is the face one of the grid's, and does the pressure drive it?
template <int D>
bool ViscousFaces<D>::is_open(int axis, const Index<D>& f) const
{
    for (int k = 0; k < D; ++k)
        if (!grid_.periodic(k) && (f[k] < 0 || f[k] >= grid_.cells()[k] + (k == axis)))
            return false;
    if (!(coupling_.open(axis, f) > 1e-12))
        return false;
    if (grid_.periodic(axis) || (f[axis] > 0 && f[axis] < grid_.cells()[axis]))
        return true;
    const Index<D> inner = f[axis] > 0 ? Index<D>(f - step<D>(axis)) : f;
    return gapflow::is_open(grid_.side(axis, f[axis] > 0)) && static_cast<CellKind>(coupling_.kind(inner)) != CellKind::film;
}

template <int D>
double ViscousFaces<D>::share_beside_walls(int axis, const Index<D>& f) const
{
    double share = 1;
    for (int k = 0; k < D; ++k) {
        if (k == axis || grid_.periodic(k))
            continue;
        int walls = 0;
        for (int end = 0; end < 2; ++end)
            walls += f[k] == end * (grid_.cells()[k] - 1) && grid_.side(k, end) == SideKind::wall;
        share *= 1 - walls / 3.0;
    }
    return share;
}

template <int D>
LatticeFace<D> ViscousFaces<D>::examine(WallRays<D>& rays, int axis, const Index<D>& f) const
{
    LatticeFace<D> face;
    if (!is_open(axis, f))
        return face;
    face.role = FaceRole::active;
    const int cut = fractions_.cut(axis, f);
    if (cut < 0 || fractions_.faces[cut].open >= whole * grid_.relative_area(axis, f))
        return face;
    const Vec<D> x = grid_.face_centre(axis, f);
    face.centroid = fractions_.faces[cut].open_centroid;
    face.shift = face.centroid - x;
    rays.around(x, reach(f));
    if (rays.distance(x) <= least_distance * grid_.dx()) {
        face.role = FaceRole::following;
        return face;
    }
    const double length = face.shift.norm();
    if (length < 1e-6 * grid_.dx())
        return face;
    const WallHit<D> hit = rays.cast(x, -face.shift / length, reach(f));
    if (hit.image < 0)
        return face;
    face.share = 1 + length / std::max(hit.distance, least_distance * grid_.dx());
    face.image = hit.image;
    face.foot = x - hit.distance / length * face.shift;
    if (face.share > largest_share)
        face.role = FaceRole::following;
    return face;
}

// Calls f(first face of a row, number of faces) for this rank's rows of faces, planes shared out over threads.
template <int D>
template <class F>
void ViscousFaces<D>::for_owned_rows(int axis, F&& f) const
{
    const Index<D> low = grid_.low(), end = owned_faces_end(grid_, axis);
    for_each_plane(low[D - 1], end[D - 1], [&](int plane) {
        Index<D> from = low, to = end;
        from[D - 1] = plane;
        to[D - 1] = plane + 1;
        for_each_row<D>(from, to, [&](const Index<D>& row) { f(row, end[0] - low[0]); });
    });
}

template <int D>
void ViscousFaces<D>::classify(FaceField<D, std::int8_t>& active)
{
    std::vector<std::pair<int, Index<D>>> others;
    std::mutex mutex;
    for (int axis = 0; axis < D; ++axis)
        for_owned_rows(axis, [&](const Index<D>& row, int count) {
            const double* open = &coupling_.open(axis, row);
            std::int8_t* to = &active(axis, row);
            for (int i = 0; i < count; ++i)
                to[i] = open[i] > 1e-12;
            Index<D> last = row;
            last[0] += count - 1;
            const bool cut = any_cut(axis, row, count), side = on_side(axis, row), last_on_side = on_side(axis, last);
            if (!cut && !side && !last_on_side)
                return;
            const std::lock_guard lock(mutex);
            for (Index<D> f = row; f[0] <= last[0]; ++f[0])
                if (to[f[0] - row[0]] && (fractions_.cut(axis, f) >= 0 || on_side(axis, f)))
                    others.emplace_back(axis, f);
        });
    for_each_part(static_cast<long>(others.size()), [&](long begin, long end) {
        WallRays<D> rays = this->rays();
        for (long i = begin; i < end; ++i)
            active(others[i].first, others[i].second) =
                examine(rays, others[i].first, others[i].second).role == FaceRole::active;
    });
    exchange(grid_, active, 1);
}

template class ViscousFaces<2>;
template class ViscousFaces<3>;

} // namespace gapflow
