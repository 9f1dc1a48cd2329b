// Gaps between two balls, or a ball and a flat wall that stands still, along a line in the plane of the gap: in closed form. With the heights z of the
// place over the balls' centres along the gap's normal n, and p what of the ways from them is left,
//
//     distance along n: (L - r) L/z,  L^2 = p^2 + z^2,      n/cosine: n + p/z,
//
// which is what FacingWalls finds (gap_walls.hpp). Balls turn about their centres: only the difference of the two velocities moves the walls in their
// mean frame.
#pragma once

#include "gapflow/complex/gap_walls.hpp"

namespace gapflow {

/// Places along a line, a few at a time.
constexpr int round_places = 8;
using RoundNumbers = Eigen::Array<double, round_places, 1>;

template <int D>
class RoundLine {
public:
    /// Of one side; of a flat wall z, p and the inverse heights are 0.
    struct Side {
        double sign; ///< of n against the wall's normal
        bool ball;
        double radius = 0, z = 0, facing = 1;       ///< facing: of the cosine, -1: fluid in the ball
        Vec<D> p = Vec<D>::Zero();                  ///< at the line's start
        double square = 0, along = 0;               ///< of p; p . way
        double cosine = 1, distance = 0, slope = 0; ///< of a flat wall: at the start, and along the way
        Vec<D> normal = Vec<D>::Zero();
        Vec<D> force = Vec<D>::Zero(); ///< -normal/cosine, of a ball without what is along p
    };

    RoundLine(const GapWalls<D>& walls, const Vec<D>& start, const Vec<D>& way, const Vec<D>& n)
        : way_(way), square_(way.squaredNorm()), standoff_(walls.standoff())
    {
        for (int i = 0; i < 2; ++i) {
            const GapWall<D>& wall = walls.wall(i);
            Side& side = side_[i];
            side.sign = i == 0 ? 1 : -1;
            side.ball = wall.radius() > 0;
            if (side.ball) {
                const Vec<D> from = start - wall.point();
                side.radius = wall.radius();
                side.facing = wall.sign();
                side.z = n.dot(from);
                side.p = from - side.z * n;
                side.square = side.p.squaredNorm();
                side.along = side.p.dot(way);
                side.force = -side.sign * n;
            } else {
                side.normal = wall.normal();
                side.cosine = side.sign * n.dot(side.normal);
                side.distance = wall.normal().dot(start - wall.point());
                side.slope = wall.normal().dot(way);
                side.force = -wall.normal() / side.cosine;
            }
        }
    }

    const Side& side(int i) const { return side_[i]; }

    /// Of several places.
    struct Places {
        RoundNumbers s, thickness;
        Eigen::Array<bool, round_places, 1> face; ///< whether the walls face each other
        std::array<RoundNumbers, 2> first_length, length, height, inverse,
            square; ///< L of both passes, z of the second one, sign/z, p^2
        std::array<RoundNumbers, 2> first_way;
    };
    void find(const RoundNumbers& s, Places& at) const
    {
        at.s = s;
        RoundNumbers least = RoundNumbers::Constant(1); // of the cosines
        for (int i = 0; i < 2; ++i) {
            const Side& side = side_[i];
            if (!side.ball) {
                least = least.min(side.cosine);
                at.first_way[i] = (side.distance + side.slope * s) / side.cosine;
                continue;
            }
            at.square[i] = side.square + s * (2 * side.along + s * square_);
            at.first_length[i] = (at.square[i] + side.z * side.z).sqrt();
            at.first_way[i] = (at.first_length[i] - side.radius) * at.first_length[i] * (side.sign / side.z);
            least = least.min(side.facing * side.sign * side.z / at.first_length[i]);
        }
        const RoundNumbers up = 0.5 * (at.first_way[1] - at.first_way[0]);
        at.thickness.setConstant(standoff_);
        for (int i = 0; i < 2; ++i) {
            const Side& side = side_[i];
            if (!side.ball) {
                at.thickness += at.first_way[i] + side.sign * up;
                at.inverse[i].setZero();
                continue;
            }
            at.height[i] = side.z + up;
            at.length[i] = (at.square[i] + at.height[i].square()).sqrt();
            at.inverse[i] = side.sign / at.height[i];
            at.thickness += (at.length[i] - side.radius) * at.length[i] * at.inverse[i];
            least = least.min(side.facing * side.sign * at.height[i] / at.length[i]);
        }
        at.face = least >= parameters.least_facing && at.thickness > 0;
        at.thickness = at.thickness.max(place_unit);
        if (!at.face.all()) // numbers that may be multiplied by 0
            for (int k = 0; k < round_places; ++k)
                if (!at.face[k])
                    for (int i = 0; i < 2; ++i) {
                        at.height[i][k] = at.length[i][k] = at.first_length[i][k] = 1;
                        at.first_way[i][k] = at.inverse[i][k] = at.square[i][k] = 0;
                    }
    }

    /// Of one place: thickness, and how it grows along the line.
    struct Growing {
        double thickness, growth;
    };
    std::optional<Growing> at(double s, GapStop* stop = nullptr) const
    {
        std::array<double, 2> first, square{};
        for (int i = 0; i < 2; ++i) {
            const Side& side = side_[i];
            double cosine = side.cosine;
            first[i] = (side.distance + side.slope * s) / side.cosine;
            if (side.ball) {
                square[i] = side.square + s * (2 * side.along + s * square_);
                const double length = std::sqrt(square[i] + side.z * side.z);
                cosine = side.facing * side.sign * side.z / length;
                first[i] = (length - side.radius) * length * (side.sign / side.z);
            }
            if (!(cosine >= parameters.least_facing))
                return stopped(stop, 0, i);
        }
        const double up = 0.5 * (first[1] - first[0]);
        Growing result{standoff_, 0};
        for (int i = 0; i < 2; ++i) {
            const Side& side = side_[i];
            if (!side.ball) {
                result.thickness += first[i] + side.sign * up;
                result.growth += side.slope / side.cosine;
                continue;
            }
            const double height = side.z + up, length = std::sqrt(square[i] + height * height), inverse = side.sign / height;
            if (!(side.facing * side.sign * height / length >= parameters.least_facing))
                return stopped(stop, 1, i);
            result.thickness += (length - side.radius) * length * inverse;
            result.growth += (side.along + s * square_) * inverse;
        }
        if (!(result.thickness > 0))
            return stopped(stop, 1, 2);
        result.thickness = std::max(result.thickness, place_unit);
        return result;
    }

    /// Rate of the thickness in the walls' mean frame at a place, by the first wall's velocity less the second one's.
    Vec<D> opening(const Places& at, int k) const
    {
        const double a = at.inverse[0][k], b = at.inverse[1][k];
        return 0.5 * (side_[0].force - side_[1].force - a * side_[0].p + b * side_[1].p - (at.s[k] * (a - b)) * way_);
    }

private:
    static std::nullopt_t stopped(GapStop* stop, int pass, int side)
    {
        if (stop)
            *stop = {pass, side, false};
        return std::nullopt;
    }

    std::array<Side, 2> side_;
    Vec<D> way_;
    double square_, standoff_;
};

} // namespace gapflow
