// Where gaps lie: the two walls of a piece of a face, the way from node to node and the lines across it (gap-energy, "Arms").
#pragma once

#include "gapflow/complex/gap_place.hpp"
#include "gapflow/complex/mouth_arm.hpp"
#include "gapflow/complex/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace gapflow {

/// A way along a gap, at its place in a face.
template <int D, class S>
struct GapLine {
    PlaceOf<D, S> place;
    S width;
    S thickness;
};

template <int D>
class GapFinder {
public:
    /// `known`: only sites whose arms are known will be asked for.
    GapFinder(const Grid<D>& grid, std::span<const Solid<D>> solids, const Complex<D>& complex, const Standoffs<D>& standoffs,
              bool known = false)
        : grid_(grid), planes_(grid), complex_(complex), standoffs_(standoffs), moved_(moved_nodes(grid, complex))
    {
        images_ = images_at<D>(grid, planes_, complex.index, solids, grid.dx());
        first_.assign(solids.size() + 1, 0);
        for (const Image<D>& image : images_) {
            ++first_[image.solid + 1];
            wall_.emplace_back(image.shape, planes_);
            reference_.push_back(planes_.in_cells(solids[image.solid].centre + image.shift));
        }
        for (std::size_t s = 0; s < solids.size(); ++s) {
            first_[s + 1] += first_[s];
            if (solids[s].wall)
                sides_.push_back(static_cast<std::int32_t>(s));
        }
        image_of_.resize(images_.size());
        std::vector<int> next = first_;
        for (std::size_t i = 0; i < images_.size(); ++i)
            image_of_[next[images_[i].solid]++] = static_cast<int>(i);
        if (!known)
            find_beside();
    }

    /// `known`: its arm.
    std::optional<GapSite<D>> site_at(std::size_t number, const GapArm<D>* known = nullptr) const
    {
        const FacePiece<D>& piece = complex_.pieces[number];
        if (!piece.low.exists() || !piece.high.exists() || !(piece.area > 0))
            return {};
        const std::vector<std::int32_t> near =
            known ? std::vector<std::int32_t>(known->solid.begin(), known->solid.end()) : walls_beside(piece);
        if (near.size() < 2)
            return {};
        const std::optional<Facing> facing = find_facing(piece.centroid, near);
        if (!facing)
            return {};
        const auto [a, b] = facing->image;
        const Standoff<D> standoff = known ? known->standoff : standoffs_.of(images_[a].solid, images_[b].solid);
        GapWalls<D> walls{{wall_[a], wall_[b]}, {reference_[a], reference_[b]}, standoff.distance};
        const auto still_side = [&](int image) { return wall_[image].flat() && is_side(images_[image].solid); };
        const std::array<bool, 2> round{centred_ball(a), centred_ball(b)};
        walls.set_round((round[0] && (round[1] || still_side(b))) || (round[1] && still_side(a)));
        const auto place = place_at(piece, walls, piece.centroid);
        if (!place)
            return {};
        return GapSite<D>{*place,
                          static_cast<std::int32_t>(number),
                          {images_[a].solid, images_[b].solid},
                          {is_side(images_[a].solid), is_side(images_[b].solid)},
                          round,
                          standoff};
    }

    /// Nothing where the walls are a cell apart or do not face each other.
    template <class Walls>
    std::optional<GapPlace<D, Walls>> place_at(const FacePiece<D>& piece, FacingWalls<D, Walls> walls,
                                               const PlaceOf<D, typename Walls::Scalar>& centroid) const
    {
        using Place = PlaceOf<D, typename Walls::Scalar>;
        const std::array<int, 2> ends = faces_of_ends(piece, walls);
        const std::array<Place, 2> normal{walls.nearest(0, centroid, ends[0]).normal,
                                          walls.nearest(1, centroid, ends[1]).normal};
        const Place n = (normal[0] - normal[1]).normalized();
        walls.keep_faces(ends);
        walls.extend(true);
        const auto here = profile_at<D>(walls, centroid, n);
        if (!here || here->thickness > parameters.gap_end)
            return {};
        walls.extend(false);
        if (!still_of(walls).round())
            walls.keep_faces(values_of<D>(here->middle));
        std::array<int, 2> faces = walls.faces();
        for (int side = 0; side < 2; ++side)
            if (ends[side] >= 0)
                faces[side] = ends[side];
        walls.keep_faces(faces);
        GapPlace<D, Walls> place{walls, n, *here, -normal[0].dot(normal[1])};
        find_way(piece, centroid, place);
        return place;
    }

    /// Of the gap's energy in that of the face.
    template <class Walls>
    static typename Walls::Scalar share_of(const GapPlace<D, Walls>& place)
    {
        using S = typename Walls::Scalar;
        return share_up_to(place.here.thickness, parameters.gap_start, parameters.gap_end) * share_of_facing<S>(place.facing);
    }
    /// Across a piece: the nodes of a Gauss rule on its line.
    template <class Walls>
    std::vector<GapLine<D, typename Walls::Scalar>> lines_of(const PlaceOf<D, typename Walls::Scalar>& centroid,
                                                             const GapPlace<D, Walls>& place) const
    {
        using S = typename Walls::Scalar;
        using std::abs;
        std::vector<GapLine<D, S>> lines;
        if constexpr (D == 3) {
            const S &from = place.from, length = place.to - from;
            for (int k = 0; k < 3 && abs(length) > parameters.least_stretch; ++k) {
                const PlaceOf<D, S> at = step_along<D, S>(centroid, S(from + ThreePoints::node[k] * length), place.line);
                if (const auto thickness = thickness_at<D>(place.walls, at, place.n))
                    lines.push_back({at, ThreePoints::weight[k] * abs(length), *thickness});
            }
        }
        if (lines.size() < 3)
            lines.assign(1, {centroid, S(1.0), place.here.thickness});
        return lines;
    }
    const Complex<D>& complex() const { return complex_; }

private:
    /// A ball that turns about its centre moves nothing.
    bool centred_ball(int image) const
    {
        return images_[image].shape.shape().sphere_radius() &&
               (planes_.in_cells(images_[image].shape.to_world(Vec<D>::Zero())) - reference_[image]).norm() < place_unit;
    }
    bool is_side(std::int32_t solid) const { return std::find(sides_.begin(), sides_.end(), solid) != sides_.end(); }

    /// Solids at the parts next to each part that it does not touch itself.
    void find_beside()
    {
        const auto add = [&](const PartOrCell& to, const PartOrCell& from) {
            if (!to.is_part() || !from.is_part())
                return;
            const auto own = complex_.patches_of(to.number());
            for (const WallPatch<D>& patch : complex_.patches_of(from.number()))
                if (std::none_of(own.begin(), own.end(), [&](const WallPatch<D>& of) { return of.solid == patch.solid; }))
                    beside_.emplace_back(to.number(), patch.solid);
        };
        for (const FacePiece<D>& piece : complex_.pieces)
            if (piece.area > 0) {
                add(piece.low, piece.high);
                add(piece.high, piece.low);
            }
        for (const std::int32_t cell : complex_.cut_cell) {
            const Index<D> c = complex_.index.index(cell);
            for (int axis = 0; axis < D; ++axis) {
                const Index<D> below = complex_.index.wrapped(c - step<D>(axis));
                if (complex_.main_area[axis][cell] > 0 && (below.array() >= complex_.index.low.array()).all()) {
                    const PartOrCell low = complex_.main_of(complex_.index(below)), high = complex_.main_of(cell);
                    add(low, high);
                    add(high, low);
                }
            }
        }
        std::sort(beside_.begin(), beside_.end());
        beside_.erase(std::unique(beside_.begin(), beside_.end()), beside_.end());
        first_beside_.assign(complex_.parts() + 1, 0);
        for (const auto& [part, solid] : beside_)
            ++first_beside_[part + 1];
        for (int part = 0; part < complex_.parts(); ++part)
            first_beside_[part + 1] += first_beside_[part];
    }

    /// Solids beside a piece: of its parts' walls, and closed sides of the domain.
    std::vector<std::int32_t> walls_beside(const FacePiece<D>& piece) const
    {
        std::vector<std::int32_t> near = sides_;
        const auto add = [&](std::int32_t solid) {
            if (std::find(near.begin(), near.end(), solid) == near.end())
                near.push_back(solid);
        };
        for (const PartOrCell& side : {piece.low, piece.high})
            if (side.is_part())
                for (const WallPatch<D>& patch : complex_.patches_of(side.number()))
                    add(patch.solid);
        for (const PartOrCell& side : {piece.low, piece.high}) // walls across a plane of the grid that runs along the gap
            if (side.is_part())
                for (int k = first_beside_[side.number()]; k < first_beside_[side.number() + 1]; ++k)
                    add(beside_[k].second);
        return near;
    }

    struct Facing {
        std::array<int, 2> image;
        std::array<Vec<D>, 2> normal;
    };
    /// The image nearest to x, and the nearest one of those that face it.
    std::optional<Facing> find_facing(const Vec<D>& x, const std::vector<std::int32_t>& near) const
    {
        Facing found{{-1, -1}, {}};
        const Vec<D> world = planes_.in_world(x);
        const double dx = planes_.dx;
        for (int side = 0; side < 2; ++side) {
            double least = parameters.gap_end;
            for (const std::int32_t s : near)
                for (int k = first_[s]; k < first_[s + 1]; ++k) {
                    const int i = image_of_[k];
                    const Bounds<D>& bounds = images_[i].bounds;
                    const double outside = (bounds.low - world).cwiseMax(world - bounds.high).maxCoeff(); // or less far
                    if ((side == 1 && i == found.image[0]) || (outside > least * dx && !images_[i].shape.shape().inside_out()))
                        continue;
                    const WallPoint<D, double> at = wall_[i].nearest(x);
                    if (!(at.distance < least) || (side == 1 && at.normal.dot(found.normal[0]) > -parameters.least_facing))
                        continue;
                    least = at.distance;
                    found.image[side] = i;
                    found.normal[side] = at.normal;
                }
            if (found.image[side] < 0)
                return {};
        }
        return found;
    }

    /// Square of the cosine of a way with the direction across the gap's end from which it counts as leading across. With 0.09 a gap that is closed behind an edge
    /// askew to the grid lets fluid along the edge (a wedge in a slot of 20 degrees: -17 % in its mass), with 0.5 square plates turned by 30 degrees err by 2.4 %.
    static constexpr double least_across = 0.35;
    /// A node is moved to another distance from the gap's end: by how much of the way that is. For flow across the end the way is shorter by all that it passes of
    /// this distance, for flow along the end by none of it.
    template <class Place>
    static typename Place::Scalar share_of_way(const Place& way, const Vec<D>& moved)
    {
        using S = typename Place::Scalar;
        const S share = way.dot(moved.template cast<S>()) / way.squaredNorm();
        if constexpr (D == 2)
            return share;
        const Vec<D> still = values_of<D>(way);
        const double cosine = still.dot(moved) / (still.norm() * std::max(moved.norm(), parameters.least_stretch));
        return share / std::max(cosine * cosine, least_across);
    }

    /// In 2D, where a corner is nearest to a piece: the faces on which the piece ends; of one that ends on a mouth's line the face on its side of that; else
    /// -1. The wall of a gap that widens lies beside its end.
    template <class Walls>
    std::array<int, 2> faces_of_ends(const FacePiece<D>& piece, const FacingWalls<D, Walls>& walls) const
    {
        std::array<int, 2> faces{-1, -1};
        if constexpr (D == 2)
            for (int side = 0; side < 2; ++side) {
                const GapWall<2>& wall = walls.wall(side);
                const WallPoint<2, double> nearest = wall.nearest(piece.centroid);
                if (nearest.on_face)
                    continue;
                const Vec<2> half = 0.5 * piece.area * unit<2>(1 - piece.axis);
                const std::array<WallPoint<2, double>, 2> end{wall.nearest(piece.centroid - half),
                                                              wall.nearest(piece.centroid + half)};
                const WallPoint<2, double>& own = end[std::abs(end[1].distance) < std::abs(end[0].distance) ? 1 : 0];
                faces[side] = own.on_face ? own.face : face_behind_mouth(piece.centroid, wall, nearest.x);
            }
        return faces;
    }

    /// The face of a wall that meets a mouth at its corner, on the side on which x lies in a gap.
    int face_behind_mouth(const Vec<2>& x, const GapWall<2>& wall, const Vec<2>& corner) const requires(D == 2)
    {
        for (const GapMouth<2>& mouth : complex_.mouths) {
            if (std::min((mouth.at - corner).norm(), (mouth.end - corner).norm()) > parameters.joint_distance)
                continue;
            const Vec<2> left = left_of(mouth.end - mouth.at).normalized();
            const double beside = left.dot(x - corner); // none on the mouth's line, in a plane of the grid: the side of the gap
            const bool on_line = std::abs(beside) < parameters.joint_distance;
            const int side = on_line ? mouth.sides[1].gap > mouth.sides[0].gap : beside <= 0;
            if (!(mouth.sides[side].gap > 0))
                continue;
            const WallPoint<2, double> there = wall.nearest(corner + (side == 0 ? 1 : -1) * parameters.tangent_share * left);
            if (there.on_face)
                return there.face;
        }
        return -1;
    }

    /// Conductance of a face whose way moved nodes make shorter, over that of an open one, at most; the least share of its way. What it has more than a plain
    /// face, Q takes from the mass of light bodies, and one Jacobi step between two stiff nodes does not give it back: from 12 on a ball of 4.8 cells a radius
    /// over a corner below a plane of the grid is too heavy, at a hundredth of the way by 80 %.
    static constexpr double stiffest = 4, least_way = 0.01;
    /// Each leaves of the error half a cell over twice the radius.
    static constexpr int passes_to_feet = 2;

    /// The way from node to node, and the line across it.
    template <class Walls>
    void find_way(const FacePiece<D>& piece, const PlaceOf<D, typename Walls::Scalar>& centroid,
                  GapPlace<D, Walls>& place) const
    {
        using S = typename Walls::Scalar;
        const Index<D> f = complex_.index.index(piece.face);
        place.delta = grid_.spread(piece.axis, f[piece.axis]);
        place.e = unit<D>(piece.axis).template cast<S>() - place.n[piece.axis] * place.n;
        place.way = place.delta * place.e;
        auto& nodes = place.nodes;
        nodes = centroid;
        for (int t = 0; t < D; ++t)
            if (t != piece.axis)
                nodes[t] = planes_.centre_of(t, f[t]);
        nodes[piece.axis] = planes_.centre_of(piece.axis, f[piece.axis]) - 0.5 * place.delta;
        place.middle = place.way.dot(nodes - centroid) / place.way.squaredNorm();
        for (int side = 0; side < 2; ++side)
            if (const PartOrCell& at = side == 0 ? piece.low : piece.high; at.is_part())
                for (auto moved = std::lower_bound(moved_.begin(), moved_.end(), at.number(),
                                                   [](const auto&m, std::int32_t p) { return m.first < p; });
                     moved != moved_.end() && moved->first == at.number(); ++moved)
                    place.moved[side] += share_of_way(place.way, moved->second);
        // Parts one above the other at a mouth that runs through both may change their order: some of the way stays.
        const double most = 1 - std::max(least_way, piece.area / stiffest);
        S closer = place.moved[0] - place.moved[1];
        if (closer > most) {
            for (S& moved : place.moved)
                moved *= most / closer;
            closer = most;
        }
        std::array<S, 2> foot{S(0.0), S(0.0)}; // of the node, from where n leads to it
        if (!place.along_face()) {
            for (int side = 0; side < 2; ++side)
                foot[side] = foot_of(side, piece, centroid, place);
            if (const S by_feet = foot[0] - foot[1]; closer + by_feet > most) // beside a body smaller than a cell
                for (S& of : foot)
                    of *= (most - closer) / by_feet;
        }
        for (int side = 0; side < 2; ++side)
            place.end[side] = (side == 0 ? place.middle - 0.5 : place.middle + 0.5) + place.moved[side] + foot[side];
        if (place.along_face())
            return;
        if constexpr (D == 3)
            find_line(piece, centroid, place);
    }

    /// Where the gap's own normal leads from its middle to a node, from where the normal at the face does, as a part of the way. In flat gaps 0; where a wall is round
    /// both ways that meet at a node end at one place with it.
    template <class Walls>
    typename Walls::Scalar foot_of(int side, const FacePiece<D>& piece, const PlaceOf<D, typename Walls::Scalar>& centroid,
                                   const GapPlace<D, Walls>& place) const
    {
        using S = typename Walls::Scalar;
        using Place = PlaceOf<D, S>;
        const std::array<int, 2> faces = place.walls.faces();
        const S start = place.middle + (side - 0.5);
        Place node = place.nodes, x = step_along<D, S>(centroid, start, place.way);
        node[piece.axis] += (side - 0.5) * place.delta;
        // Faces along the gap know nothing of it: their way is next to none.
        S foot = 0.0, share = 1.0 - share_up_to(S(place.e[piece.axis]), 0.0, parameters.least_facing);
        for (int pass = 0; pass < passes_to_feet; ++pass) {
            const WallPoint<D, S> from = place.walls.nearest(0, x, faces[0]), to = place.walls.nearest(1, x, faces[1]);
            share *= share_of_facing(S(-from.normal.dot(to.normal)));
            if (!(share > 0.0))
                return S(0.0);
            const Place n = (from.normal - to.normal).normalized();
            if (values_of<D>(n) == values_of<D>(place.n))
                return foot;
            x = step_along<D, S>(node, S(n.dot(x - node) + 0.5 * (to.distance - from.distance)), n);
            foot = share * (place.way.dot(x - centroid) / place.way.squaredNorm() - start);
        }
        return foot;
    }
    /// Of walls with normals at an angle of this cosine.
    template <class S>
    static S share_of_facing(const S& facing)
    {
        return share_up_to(S(-facing), -2 * parameters.least_facing, -parameters.least_facing);
    }

    /// The chord of a face through its piece's centroid, along the gap.
    template <class Walls>
    void find_line(const FacePiece<D>& piece, const PlaceOf<D, typename Walls::Scalar>& centroid,
                   GapPlace<D, Walls>& place) const
    {
        using S = typename Walls::Scalar;
        using std::abs;
        using Place = PlaceOf<D, S>;
        const auto& walls = place.walls;
        const Place &n = place.n, m = n.cross(unit<D>(piece.axis).template cast<S>()).normalized();
        const Index<D> f = complex_.index.index(piece.face);
        Vec<D> centre = piece.centroid;
        int most = -1; // the face's direction nearest to m
        for (int t = 0; t < D; ++t)
            if (t != piece.axis) {
                centre[t] = planes_.centre_of(t, f[t]);
                most = most < 0 || abs(m[t]) > abs(m[most]) ? t : most;
            }
        const int other = 3 - piece.axis - most;
        // The face ends where the gap's middle, which may be bent, leaves it.
        const GapWalls<D>& still = still_of(walls);
        const Vec<D> start = values_of<D>(centroid), way = values_of<D>(m), normal = values_of<D>(n);
        const auto end = [&](const S& s) { // `s`, or where the line leaves the face or a wall ends before it
            GapStop stop;
            bool found = false;
            double off = 0; // how far beyond the face
            const auto in_face = [&](double x) {
                const auto section = still.profile(step_along<D>(start, x, way), normal, &stop);
                found = section.has_value();
                off = found ? beyond_face<D>(*section, normal, other, centre[other]) : 0.0;
                return found && !(off > 0);
            };
            double in = 0, out = value_of(s);
            if (in_face(out))
                return s;
            bool leaves = found; // not: a wall ends
            double above = off, below = in_face(in) ? off : 0.0, last = out;
            // Halves; where the line leaves the face a false position that lets neither end stand.
            for (int k = 0, side = 0;; ++k) {
                const bool straight = leaves && below < 0 && k < most_steps;
                const double middle = straight ? in + below / (below - above) * (out - in) : 0.5 * (in + out);
                if (middle == in || middle == out)
                    break;
                const bool inside = in_face(middle);
                if (straight && found && (off == 0 || std::abs(middle - last) < 4 * std::numeric_limits<double>::epsilon())) {
                    in = middle;
                    break;
                }
                (inside ? in : out) = last = middle;
                (inside ? below : above) = off;
                leaves = inside ? leaves : found;
                if (const int before = std::exchange(side, inside ? -1 : 1); before == side)
                    (inside ? above : below) *= 0.5;
            }
            if constexpr (std::is_same_v<S, double>)
                return in;
            else {
                const Place x = step_along<D, S>(centroid, S::along(in), m);
                const auto off_face = leaves ? beyond_face<D>(walls, x, n, other, centre[other]) : std::optional<S>();
                return S::root(in, off_face ? *off_face : walls.margin(x, n, stop));
            }
        };
        place.line = m;
        place.from = end((centre[most] - centroid[most] - 0.5) / m[most]);
        place.to = end((centre[most] - centroid[most] + 0.5) / m[most]);
    }

    static const GapWalls<D>& still_of(const GapWalls<D>& walls) { return walls; }
    template <class Moving>
    static const GapWalls<D>& still_of(const FacingWalls<D, Moving>& walls)
    {
        return walls.still();
    }

    static constexpr int most_steps = 30; ///< of a root's search

    const Grid<D>& grid_;
    GridPlanes<D> planes_;
    const Complex<D>& complex_;
    const Standoffs<D> standoffs_;
    const std::vector<std::pair<std::int32_t, Vec<D>>> moved_;
    std::vector<Image<D>> images_;
    std::vector<GapWall<D>> wall_; ///< of each image
    std::vector<Vec<D>> reference_;
    std::vector<int> first_, image_of_; ///< of each solid
    std::vector<std::int32_t> sides_;
    std::vector<std::pair<std::int32_t, std::int32_t>> beside_; ///< part, solid
    std::vector<int> first_beside_;                             ///< of each part
};

} // namespace gapflow
