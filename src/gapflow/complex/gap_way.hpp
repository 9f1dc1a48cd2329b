// Gaps as the faces of the grid cut them: the walls, the thickness between them, and the way along a gap from node to node.
#pragma once

#include "gapflow/complex/facet_cut.hpp"
#include "gapflow/complex/gap_arm.hpp"
#include "gapflow/complex/lever.hpp"
#include "gapflow/complex/parameters.hpp"
#include "gapflow/complex/placed.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

namespace gapflow {

/// n . v of a solid's twist at x.
template <int D>
Twist<D> speed_along(const Vec<D>& n, const Vec<D>& x, const Vec<D>& reference)
{
    return lever<D>(n, x - reference);
}

inline Vec<2> left_of(const Vec<2>& x)
{
    return {-x[1], x[0]};
}

/// 1 up to `start`, 0 from `end` on.
inline double share_up_to(double thickness, double start, double end)
{
    const double x = std::clamp((end - thickness) / (end - start), 0.0, 1.0);
    return x * x * (3 - 2 * x);
}

/// Images of the solids that come within `margin` of a complex's block.
template <int D>
std::vector<Image<D>> images_at(const Grid<D>& grid, const GridPlanes<D>& planes, const DenseIndex<D>& index,
                                std::span<const Solid<D>> solids, double margin)
{
    Vec<D> period = Vec<D>::Zero(), low, high;
    for (int axis = 0; axis < D; ++axis) {
        if (grid.periodic(axis))
            period[axis] = grid.size()[axis];
        low[axis] = planes.place[axis][index.low[axis]];
        high[axis] = planes.place[axis][index.high()[axis]];
    }
    return images(solids, planes.in_world(low), planes.in_world(high), period, margin);
}

/// A gap along the line through x along n.
template <int D>
struct GapSection {
    double thickness;
    Vec<D> middle;
    std::array<Vec<D>, 2> normal; ///< out of the walls
    PairTwist<D> opening;         ///< rate of the thickness
    Vec<D> slope; ///< rate of the thickness where both walls move with the velocity U: slope . U; minus its gradient
};

/// Two walls that face each other. Places in cells.
template <int D>
class GapWalls {
public:
    std::array<PlacedShape<D>, 2> shape;
    std::array<Vec<D>, 2> reference;
    const GridPlanes<D>* planes;

    /// Nothing where a wall ends, or where the walls overlap. They are at least as far apart as places are told from each other.
    std::optional<GapSection<D>> across(Vec<D> x, const Vec<D>& n) const
    {
        GapSection<D> section;
        for (int pass = 0; pass < 2; ++pass) { // the second one from the middle
            std::array<double, 2> way, cosine;
            for (int side = 0; side < 2; ++side) {
                const SurfacePoint<D> at = shape[side].closest(planes->in_world(x));
                cosine[side] = (side == 0 ? 1 : -1) * n.dot(at.normal);
                if (at.feature != Feature::face || cosine[side] < parameters.least_facing)
                    return {};
                way[side] = at.distance / planes->dx / cosine[side];
                section.normal[side] = at.normal;
                section.opening.template segment<twist_size<D>>(side * twist_size<D>) =
                    speed_along<D>(-at.normal / cosine[side], planes->in_cells(at.x), reference[side]);
            }
            if (!(way[0] + way[1] > 0))
                return {};
            section.thickness = std::max(way[0] + way[1], place_unit);
            x += 0.5 * (way[1] - way[0]) * n;
            section.slope = -section.normal[0] / cosine[0] - section.normal[1] / cosine[1];
        }
        section.middle = x;
        return section;
    }
};

/// Mean motion of the walls at x, by their twists: their translation, and what of their rotation moves them along their normals.
template <int D>
Eigen::Matrix<double, D, 2 * twist_size<D>> mean_motion(const GapWalls<D>& walls, const std::array<Vec<D>, 2>& normal,
                                                        const Vec<D>& x)
{
    Eigen::Matrix<double, D, 2 * twist_size<D>> frame;
    for (int side = 0; side < 2; ++side) {
        const Vec<D>& m = normal[side];
        const Twist<D> turning = speed_along<D>(m, x, walls.reference[side]);
        auto columns = frame.template middleCols<twist_size<D>>(side * twist_size<D>);
        columns.template leftCols<D>() = 0.5 * Mat<D>::Identity();
        columns.template rightCols<spin_size<D>>() = 0.5 * m * turning.template tail<spin_size<D>>().transpose();
    }
    return frame;
}

/// In the plane of a gap.
template <int D>
struct GapShape {
    Mat<D> curvature; ///< the Hessian of the thickness, without its negative part
    Mat<D> shares;    ///< of the closing that flow in each direction, of trace 1
};

GapShape<2> shape_of_gap(const GapWalls<2>& walls, const Vec<2>& x, const Vec<2>& n, const GapSection<2>& here);
GapShape<3> shape_of_gap(const GapWalls<3>& walls, const Vec<3>& x, const Vec<3>& n, const GapSection<3>& here);

/// Gauss points of 0 .. 1, and the weights of integrals from 0 to each of them.
struct ThreePoints {
    static constexpr double root = 3.872983346207417; // of 15
    static constexpr std::array<double, 3> node{0.5 - root / 10, 0.5, 0.5 + root / 10}, weight{5.0 / 18, 4.0 / 9, 5.0 / 18};
    static constexpr std::array<std::array<double, 3>, 3> collocation{{{5.0 / 36, 2.0 / 9 - root / 15, 5.0 / 36 - root / 30},
                                                                       {5.0 / 36 + root / 24, 2.0 / 9, 5.0 / 36 - root / 24},
                                                                       {5.0 / 36 + root / 30, 2.0 / 9 + root / 15, 5.0 / 36}}};
};

/// Rows and thickness along a gap, and their integrals over pieces of it.
template <int D>
class GapWay : public ThreePoints {
public:
    struct Point {
        double weight, thickness;
        PairTwist<D> flux; ///< D
    };

    GapWay(const GapWalls<D>& walls, const Vec<D>& start, const Vec<D>& way, const Vec<D>& n, double thickness,
           const Eigen::Matrix<double, D, 2 * twist_size<D>>& frame)
        : walls_(walls), start_(start), way_(way), n_(n), thickness_(thickness), frame_(frame)
    {
    }

    /// Quadrature of the stretch from .. to of the way. D is 0 where the gap is thinnest along the way: of a quadratic thickness there is no flux
    /// across the line on which it does not change along the way. `bend`: second derivative of the thickness along the way. `from_start`: D is 0 at
    /// the start, as in 2D.
    std::vector<Point> points(double from, double to, double sigma, double bend, bool from_start = D == 2)
    {
        std::array<double, 3> ends{from, 0.0, to}; // in any order
        std::sort(ends.begin(), ends.end());
        const auto [thinnest, beyond] = from_start ? std::pair(0.0, 0.0) : find_thinnest(ends[0], ends[2], bend);
        breaks_.assign(1, ends[0]);
        for (const double end : ends)
            if (end > breaks_.back())
                refine(breaks_.back(), thickness_at(breaks_.back()), end, thickness_at(end), halvings);
        if (const auto after = std::lower_bound(breaks_.begin(), breaks_.end(), thinnest); *after != thinnest)
            breaks_.insert(after, thinnest);
        std::vector<Point> result;
        PairTwist<D> here = PairTwist<D>::Zero(), zero = here;
        const auto pass = [&](double s) {
            if (s == 0)
                at_face_ = here;
            if (s == thinnest)
                zero = here - sigma * beyond * at(s).first;
        };
        for (std::size_t k = 0; k + 1 < breaks_.size(); ++k) {
            const double length = breaks_[k + 1] - breaks_[k];
            std::array<PairTwist<D>, 3> rate;
            std::array<double, 3> t;
            for (int g = 0; g < 3; ++g)
                std::tie(rate[g], t[g]) = at(breaks_[k] + node[g] * length);
            pass(breaks_[k]);
            if (breaks_[k] >= from && breaks_[k] < to)
                for (int g = 0; g < 3; ++g) {
                    Point point{weight[g] * length, t[g], here};
                    for (int h = 0; h < 3; ++h)
                        point.flux -= sigma * length * collocation[g][h] * rate[h];
                    result.push_back(point);
                }
            for (int h = 0; h < 3; ++h)
                here -= sigma * length * weight[h] * rate[h];
        }
        pass(breaks_.back());
        for (Point& point : result)
            point.flux -= zero;
        at_face_ -= zero;
        return result;
    }
    /// D at the face, after points().
    const PairTwist<D>& at_face() const { return at_face_; }

private:
    static constexpr int halvings = 30; ///< to the digits of a double

    std::optional<GapSection<D>> section(double s) const { return walls_.across(start_ + s * way_, n_); }
    double thickness_at(double s) const
    {
        const auto found = section(s);
        return found ? found->thickness : thickness_;
    }
    /// Opening in the frame of the walls' mean motion, and thickness; where a wall has ended as at the face, at rest.
    std::pair<PairTwist<D>, double> at(double s) const
    {
        const auto found = section(s);
        if (!found)
            return {PairTwist<D>::Zero(), thickness_};
        return {found->opening - frame_.transpose() * found->slope, found->thickness};
    }
    /// The place between low and high, and how far beyond it the gap is thinnest.
    std::pair<double, double> find_thinnest(double low, double high, double bend) const
    {
        double end[2] = {low, high}, growth[2];
        for (int k = 0; k < 2; ++k) {
            auto found = section(end[k]);
            if (!found) {
                end[k] = 0; // the face
                found = section(0);
            }
            growth[k] = -found->slope.dot(way_);
            if (k == 0 ? growth[0] >= 0 : growth[1] <= 0) {
                const double curvature = std::max(bend, 0.5 * growth[k] * growth[k] / found->thickness);
                return {end[k], growth[k] != 0 ? -growth[k] / std::max(curvature, std::abs(growth[k])) : 0.0};
            }
        }
        for (int k = 0; k < halvings && end[1] - end[0] > parameters.least_stretch; ++k) {
            const double share = k % 3 == 2 ? 0.5 : growth[0] / (growth[0] - growth[1]),
                         middle = end[0] + share * (end[1] - end[0]);
            const auto found = section(middle);
            if (!found)
                break;
            const double here = -found->slope.dot(way_);
            if (here == 0)
                return {middle, 0.0};
            const int side = here < 0 ? 0 : 1;
            end[side] = middle;
            growth[side] = here;
        }
        return {-growth[0] < growth[1] ? end[0] : end[1], 0.0};
    }
    void refine(double from, double t_from, double to, double t_to, int depth)
    {
        const double middle = 0.5 * (from + to), t_middle = thickness_at(middle);
        const auto [least, most] = std::minmax({t_from, t_middle, t_to});
        if (depth > 0 && most > parameters.widening * least && breaks_.size() < parameters.most_intervals) {
            refine(from, t_from, middle, t_middle, depth - 1);
            refine(middle, t_middle, to, t_to, depth - 1);
        } else
            breaks_.push_back(to);
    }

    const GapWalls<D>& walls_;
    const Vec<D>&start_, &way_, &n_;
    double thickness_;
    const Eigen::Matrix<double, D, 2 * twist_size<D>>& frame_;
    std::vector<double> breaks_;
    PairTwist<D> at_face_;
};

/// A piece of a face in a gap.
template <int D>
struct GapSite {
    std::int32_t piece;
    std::array<std::int32_t, 2> solid;
    std::array<bool, 2> still; ///< closed sides of the domain: they never move
    std::array<bool, 2> round; ///< balls that turn about their centres: that moves nothing
    GapWalls<D> walls;
    Vec<D> n;           ///< from the first wall to the second one
    GapSection<D> here; ///< at the piece's centroid
    // The way from node to node is centroid + s way, middle - 1/2 <= s <= middle + 1/2.
    double delta = 1; ///< distance of the nodes along the face's axis
    Vec<D> e = Vec<D>::Zero(), way = Vec<D>::Zero();
    double middle = 0;
    Vec<D> nodes = Vec<D>::Zero(); ///< the middle between the two
    std::array<double, 2> moved{}; ///< of its two ends: nodes that mouths move
    // 3D: the piece lies around centroid + s line, from <= s <= to or the other way round.
    Vec<D> line = Vec<D>::Zero();
    double from = 0, to = 0;

    bool along_face() const { return !(way.norm() > parameters.parallel); }
};

/// Of all pieces of the complex that lie in gaps, in their order.
template <int D>
void for_each_gap(const Grid<D>& grid, std::span<const Solid<D>> solids, const Complex<D>& complex,
                  const std::function<void(const GapSite<D>&)>& visit);

} // namespace gapflow
