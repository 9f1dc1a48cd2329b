#include "gapflow/viscosity/following_faces.hpp"

#include "gapflow/core/threads.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace gapflow {

template <int D>
void FollowingFaces<D>::add(int axis)
{
    const Index<D> ones = Index<D>::Ones(), owned = owned_faces_end(grid_, axis);
    const int count = owned[0] - grid_.low()[0] + 2;
    std::vector<Index<D>> cut;
    for_each_row<D>(grid_.low() - ones, owned + ones, [&](const Index<D>& row) {
        if (!faces_.any_cut(axis, row, count))
            return;
        for (Index<D> f = row; f[0] < row[0] + count; ++f[0])
            if (fractions_.cut(axis, f) >= 0)
                cut.push_back(f);
    });
    const auto chunks = each_chunk(static_cast<long>(cut.size()), faces_a_chunk, [&](long begin, long end) {
        WallRays<D> rays = faces_.rays();
        std::vector<Followed> found;
        for (long i = begin; i < end; ++i)
            if (const std::optional<Followed> followed = follow(rays, axis, cut[i]))
                found.push_back(*followed);
        return found;
    });
    for (const std::vector<Followed>& chunk : chunks)
        for (const Followed& followed : chunk) {
            const FollowingFace<D>& face = followed.face;
            if (followed.leads) {
                gaps_.pass_on(axis, face.leader, followed.passed_on);
                ViscousTerm<D> term{axis, face.leader, 0, face.share, u_star_[axis].data()[face.at], face.solid, face.row};
                term.stiffness = face.mass * face.stiffness / (face.mass + face.stiffness);
                terms_.add(term);
            }
            if (followed.mine)
                system_.following.push_back(face);
        }
}

template <int D>
auto FollowingFaces<D>::follow(WallRays<D>& rays, int axis, const Index<D>& f) const -> std::optional<Followed>
{
    const LatticeFace<D> face = faces_.examine(rays, axis, f);
    if (face.role != FaceRole::following)
        return {};
    const Index<D> owned = owned_faces_end(grid_, axis);
    auto is_mine = [&](const Index<D>& g) {
        return (g.array() >= grid_.low().array()).all() && (g.array() < owned.array()).all();
    };
    Followed result{
        {axis, system_.active[axis].block().offset(f), -1, faces_.mass(axis, f), 0, 0, {-1, -1}, {}}, is_mine(f), false, 0};
    const Index<D> leader = leader_of(rays, axis, f, face, result.face);
    const bool led = result.face.leader >= 0;
    result.leads = led ? is_mine(leader) : result.mine;
    result.passed_on = led ? gaps_.stiffen(rays, axis, f, face, leader, result.face) : 0.0;
    return result;
}

// The neighbour that lies best in the direction of the open part; fills in how the face follows it.
template <int D>
Index<D> FollowingFaces<D>::leader_of(WallRays<D>& rays, int axis, const Index<D>& f, const LatticeFace<D>& face,
                                      FollowingFace<D>& following) const
{
    const Vec<D> x = face.centroid;
    const double area = coupling_.open(axis, f);
    std::array<std::pair<double, int>, 2 * D> choices;
    for (int side = 0; side < 2 * D; ++side)
        choices[side] = {(side % 2 ? -1.0 : 1.0) * face.shift[side / 2], side};
    std::sort(choices.begin(), choices.end());
    for (const auto& [along, side] : choices) {
        const Index<D> g = f + (side % 2 ? 1 : -1) * step<D>(side / 2);
        if (along >= -1e-6 * grid_.dx() || !system_.active[axis].block().contains(g) || !system_.active(axis, g))
            continue;
        const Vec<D> from = grid_.face_centre(axis, g), direction = (x - from).normalized();
        const double length = (x - from).norm();
        rays.around(from, 3 * grid_.dx());
        const WallHit<D> hit = rays.cast(from, direction, 3 * grid_.dx());
        if (hit.image < 0 || hit.distance < length)
            continue;
        const double rest = std::max(hit.distance - length, least_distance * grid_.dx());
        following.leader = system_.active[axis].block().offset(g);
        following.stiffness = system_.edge * area * grid_.dx() * (1 / rest + 1 / length);
        following.share = rest / (rest + length);
        following.solid[0] = faces_.image(hit.image).solid;
        following.row[0] = (1 - following.share) * faces_.row(hit.image, axis, from + (rest + length) * direction);
        return g;
    }
    follow_solids(rays, axis, x, area, following);
    return f;
}

// No neighbour: a gap narrower than the grid. Drag towards the velocity of a linear profile between its walls, with the stiffness that gives
// the face its share of Poiseuille flow.
template <int D>
void FollowingFaces<D>::follow_solids(WallRays<D>& rays, int axis, const Vec<D>& x, double area,
                                      FollowingFace<D>& following) const
{
    rays.around(x, ray_length * grid_.dx());
    int nearest = -1;
    const double phi = std::max(rays.distance(x, &nearest), least_distance * grid_.dx());
    if (nearest < 0) {
        following.stiffness = 0;
        return;
    }
    const SurfacePoint<D> wall = faces_.image(nearest).shape.closest(x);
    const WallHit<D> other = rays.cast(x, wall.normal, ray_length * grid_.dx());
    following.solid[0] = faces_.image(nearest).solid;
    following.row[0] = faces_.row(nearest, axis, wall.x);
    double mean = phi * phi / 3; // of y (h - y) / 2 over the face, h = 2 phi
    if (other.image >= 0) {
        const double h = phi + other.distance;
        const double spread =
            (1 - wall.normal[axis] * wall.normal[axis]) * (D == 2 ? area * area : area) / 12 * grid_.dx() * grid_.dx();
        mean = std::max(0.5 * phi * other.distance - 0.5 * spread, h * h / 24);
        const double near_share = other.distance / h;
        following.row[0] *= near_share;
        following.solid[1] = faces_.image(other.image).solid;
        following.row[1] = (1 - near_share) * faces_.row(other.image, axis, x + other.distance * wall.normal);
    }
    following.stiffness = system_.edge * area * grid_.dx() * grid_.dx() / mean;
}

template class FollowingFaces<2>;
template class FollowingFaces<3>;

} // namespace gapflow
