#include "gapflow/viscosity/following_faces.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace gapflow {

template <int D>
void FollowingFaces<D>::add(int axis)
{
    const Index<D> ones = Index<D>::Ones();
    const Index<D> owned = owned_faces_end(grid_, axis);
    auto is_mine = [&](const Index<D>& f) {
        return (f.array() >= grid_.low().array()).all() && (f.array() < owned.array()).all();
    };
    auto add_face = [&](const Index<D>& f) {
        if (fractions_.cut(axis, f) < 0)
            return;
        const LatticeFace<D> face = faces_.examine(axis, f);
        if (face.role != FaceRole::following)
            return;
        FollowingFace<D> following{axis, system_.active[axis].block().offset(f), -1, faces_.mass(axis, f), 0, 0, {-1, -1}, {}};
        const Index<D> leader = leader_of(axis, f, face, following);
        const bool mine = is_mine(f), leads = following.leader >= 0 ? is_mine(leader) : mine;
        const double passed_on = following.leader >= 0 ? gaps_.stiffen(axis, f, face, leader, following) : 0.0;
        if (leads) {
            gaps_.pass_on(axis, following.leader, passed_on);
            ViscousTerm<D> term{axis, following.leader, 0, following.share, u_star_(axis, f), following.solid, following.row};
            term.stiffness = following.mass * following.stiffness / (following.mass + following.stiffness);
            terms_.add(term);
        }
        if (mine)
            system_.following.push_back(following);
    };
    const int count = owned[0] - grid_.low()[0] + 2;
    for_each_row<D>(grid_.low() - ones, owned + ones, [&](const Index<D>& row) {
        if (!faces_.any_cut(axis, row, count))
            return;
        for (Index<D> f = row; f[0] < row[0] + count; ++f[0])
            add_face(f);
    });
}

// The neighbour that lies best in the direction of the open part; fills in how the face follows it.
template <int D>
Index<D> FollowingFaces<D>::leader_of(int axis, const Index<D>& f, const LatticeFace<D>& face, FollowingFace<D>& following)
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
        rays_.around(from, 3 * grid_.dx());
        const WallHit<D> hit = rays_.cast(from, direction, 3 * grid_.dx());
        if (hit.image < 0 || hit.distance < length)
            continue;
        const double rest = std::max(hit.distance - length, least_distance * grid_.dx());
        following.leader = system_.active[axis].block().offset(g);
        following.stiffness = system_.edge * area * grid_.dx() * (1 / rest + 1 / length);
        following.share = rest / (rest + length);
        following.solid[0] = rays_.image(hit.image).solid;
        following.row[0] = (1 - following.share) * faces_.row(hit.image, axis, from + (rest + length) * direction);
        return g;
    }
    follow_solids(axis, x, area, following);
    return f;
}

// No neighbour: a gap narrower than the grid. Drag towards the velocity of a linear profile between its walls, with the stiffness that gives
// the face its share of Poiseuille flow.
template <int D>
void FollowingFaces<D>::follow_solids(int axis, const Vec<D>& x, double area, FollowingFace<D>& following)
{
    rays_.around(x, ray_length * grid_.dx());
    int nearest = -1;
    const double phi = std::max(rays_.distance(x, &nearest), least_distance * grid_.dx());
    if (nearest < 0) {
        following.stiffness = 0;
        return;
    }
    const SurfacePoint<D> wall = rays_.image(nearest).shape.closest(x);
    const WallHit<D> other = rays_.cast(x, wall.normal, ray_length * grid_.dx());
    following.solid[0] = rays_.image(nearest).solid;
    following.row[0] = faces_.row(nearest, axis, wall.x);
    double mean = phi * phi / 3; // of y (h - y) / 2 over the face, h = 2 phi
    if (other.image >= 0) {
        const double h = phi + other.distance;
        const double spread =
            (1 - wall.normal[axis] * wall.normal[axis]) * (D == 2 ? area * area : area) / 12 * grid_.dx() * grid_.dx();
        mean = std::max(0.5 * phi * other.distance - 0.5 * spread, h * h / 24);
        const double near_share = other.distance / h;
        following.row[0] *= near_share;
        following.solid[1] = rays_.image(other.image).solid;
        following.row[1] = (1 - near_share) * faces_.row(other.image, axis, x + other.distance * wall.normal);
    }
    following.stiffness = system_.edge * area * grid_.dx() * grid_.dx() / mean;
}

template class FollowingFaces<2>;
template class FollowingFaces<3>;

} // namespace gapflow
