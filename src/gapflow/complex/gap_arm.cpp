#include "gapflow/complex/gap_way.hpp"
#include "gapflow/complex/mouth_arm.hpp"

#include "gapflow/complex/parameters.hpp"
#include "gapflow/core/threads.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {
namespace {

/// A symmetric matrix without its negative part.
Mat<2> positive_part(const Mat<2>& A)
{
    const double mean = 0.5 * A.trace(), radius = std::hypot(0.5 * (A(0, 0) - A(1, 1)), A(0, 1));
    if (mean >= radius)
        return A;
    if (mean <= -radius)
        return Mat<2>::Zero();
    return (mean + radius) / (2 * radius) * (A - (mean - radius) * Mat<2>::Identity());
}

} // namespace

GapShape<2> shape_of_gap(const GapWalls<2>&, const Vec<2>&, const Vec<2>& n, const GapSection<2>&)
{
    return {Mat<2>::Zero(), Mat<2>::Identity() - n * n.transpose()};
}
GapShape<3> shape_of_gap(const GapWalls<3>& walls, const Vec<3>& x, const Vec<3>& n, const GapSection<3>& here)
{
    const Vec<3> u = n.unitOrthogonal(), v = n.cross(u);
    const double h = 0.5, t = here.thickness;
    // Second derivative along d; where a wall ends on one side of x from the slope there.
    const auto second = [&](const Vec<3>& d) {
        double sum = 0;
        int found = 0;
        for (const double s : {-h, h})
            if (const std::optional<GapSection<3>> section = walls.across(x + s * d, n)) {
                sum += section->thickness - t + s * here.slope.dot(d);
                ++found;
            }
        return found ? 2 * sum / (found * h * h) : 0.0;
    };
    const double r = std::sqrt(0.5);
    Mat<2> hess;
    hess(0, 0) = second(u);
    hess(1, 1) = second(v);
    hess(0, 1) = hess(1, 0) = 0.5 * (second(r * (u + v)) - second(r * (u - v)));
    const Vec<2> gradient(here.slope.dot(u), here.slope.dot(v));
    const double e = parameters.faint_curvature;
    const Mat<2> curvature = positive_part(hess);
    Mat<2> shares = curvature;
    shares += e / t * gradient * gradient.transpose() + e * e * t * Mat<2>::Identity();
    shares /= shares.trace();
    Eigen::Matrix<double, 3, 2> plane;
    plane << u, v;
    return {plane * curvature * plane.transpose(), plane * shares * plane.transpose()};
}

namespace {

/// A way along a gap, at its place in a face.
template <int D>
struct GapLine {
    Vec<D> place;
    double width;
    double thickness;
};

template <int D>
class GapFinder {
public:
    GapFinder(const Grid<D>& grid, std::span<const Solid<D>> solids, const Complex<D>& complex)
        : grid_(grid), planes_(grid), complex_(complex), moved_(moved_nodes(grid, complex))
    {
        images_ = images_at<D>(grid, planes_, complex.index, solids, grid.dx());
        first_.assign(solids.size() + 1, 0);
        for (const Image<D>& image : images_) {
            ++first_[image.solid + 1];
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
        find_beside();
    }

    std::optional<GapSite<D>> site_at(std::size_t number) const
    {
        const FacePiece<D>& piece = complex_.pieces[number];
        if (!piece.low.exists() || !piece.high.exists() || !(piece.area > 0))
            return {};
        const std::vector<std::int32_t> near = walls_beside(piece);
        if (near.size() < 2)
            return {};
        const std::optional<FacingWalls> facing = find_facing(piece.centroid, near);
        if (!facing)
            return {};
        const auto [a, b] = facing->image;
        const GapWalls<D> walls{{images_[a].shape, images_[b].shape}, {reference_[a], reference_[b]}, &planes_};
        const Vec<D> n = (facing->normal[0] - facing->normal[1]).normalized();
        const std::optional<GapSection<D>> here = walls.across(piece.centroid, n);
        if (!here || here->thickness > parameters.gap_end)
            return {};
        GapSite<D> site{static_cast<std::int32_t>(number),
                        {images_[a].solid, images_[b].solid},
                        {is_side(images_[a].solid), is_side(images_[b].solid)},
                        {centred_ball(a), centred_ball(b)},
                        walls,
                        n,
                        *here};
        find_way(piece, site);
        return site;
    }

    std::optional<GapArm<D>> arm_at(std::size_t number) const
    {
        const std::optional<GapSite<D>> site = site_at(number);
        if (!site)
            return {};
        GapArm<D> arm{static_cast<std::int32_t>(number), site->solid, 0, 0, {}, {}, {}};
        integrate(complex_.pieces[number], *site, arm);
        for (int side = 0; side < 2; ++side) // round-off of what moves no wall
            if (site->still[side])
                still(arm, side * twist_size<D>, twist_size<D>);
            else if (site->round[side])
                still(arm, side * twist_size<D> + D, spin_size<D>);
        return arm;
    }

private:
    /// No energy of some components of the twists.
    static void still(GapArm<D>& arm, int first, int count)
    {
        for (PairTwist<D>* row : {&arm.flux, &arm.motion})
            row->segment(first, count).setZero();
        arm.mass.middleRows(first, count).setZero();
        arm.mass.middleCols(first, count).setZero();
    }
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
                for (auto at = std::lower_bound(beside_.begin(), beside_.end(), std::pair(side.number(), 0));
                     at != beside_.end() && at->first == side.number(); ++at)
                    add(at->second);
        return near;
    }

    struct FacingWalls {
        std::array<int, 2> image;
        std::array<Vec<D>, 2> normal;
    };
    /// The image nearest to x, and the nearest one of those that face it.
    std::optional<FacingWalls> find_facing(const Vec<D>& x, const std::vector<std::int32_t>& near) const
    {
        FacingWalls found{{-1, -1}, {}};
        for (int side = 0; side < 2; ++side) {
            double least = parameters.gap_end * planes_.dx;
            for (const std::int32_t s : near)
                for (int k = first_[s]; k < first_[s + 1]; ++k) {
                    const int i = image_of_[k];
                    const Vec<D> world = planes_.in_world(x);
                    const Bounds<D>& bounds = images_[i].bounds;
                    const double outside = (bounds.low - world).cwiseMax(world - bounds.high).maxCoeff(); // or less far
                    if ((side == 1 && i == found.image[0]) || (outside > least && !images_[i].shape.shape().inside_out()))
                        continue;
                    const SurfacePoint<D> at = images_[i].shape.closest(world);
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

    /// A node is moved to another distance from the gap's end: by how much of the way that is. Faces along the end know nothing of it.
    static double share_of_way(const Vec<D>& way, const Vec<D>& moved)
    {
        const double share = way.dot(moved) / way.squaredNorm();
        if constexpr (D == 2)
            return share;
        const double cosine = way.dot(moved) / (way.norm() * std::max(moved.norm(), parameters.least_stretch)),
                     least = parameters.least_facing;
        return share / std::max(cosine * cosine, least * least);
    }

    /// The way from node to node, and the line across it.
    void find_way(const FacePiece<D>& piece, GapSite<D>& site) const
    {
        const Index<D> f = complex_.index.index(piece.face);
        site.delta = grid_.spread(piece.axis, f[piece.axis]);
        site.e = unit<D>(piece.axis) - site.n[piece.axis] * site.n;
        site.way = site.delta * site.e;
        Vec<D>& nodes = site.nodes;
        nodes = piece.centroid;
        for (int t = 0; t < D; ++t)
            if (t != piece.axis)
                nodes[t] = planes_.centre_of(t, f[t]);
        nodes[piece.axis] = planes_.centre_of(piece.axis, f[piece.axis]) - 0.5 * site.delta;
        site.middle = site.way.dot(nodes - piece.centroid) / site.way.squaredNorm();
        for (int side = 0; side < 2; ++side)
            if (const PartOrCell& at = side == 0 ? piece.low : piece.high; at.is_part())
                for (auto moved = std::lower_bound(moved_.begin(), moved_.end(), at.number(),
                                                   [](const auto&m, std::int32_t p) { return m.first < p; });
                     moved != moved_.end() && moved->first == at.number(); ++moved)
                    site.moved[side] += share_of_way(site.way, moved->second);
        // Parts one above the other at a mouth that runs through both may change their order: a quarter of the way stays.
        if (const double closer = site.moved[0] - site.moved[1]; closer > 0.75)
            for (double& moved : site.moved)
                moved *= 0.75 / closer;
        if (site.along_face())
            return;
        if constexpr (D == 3)
            find_line(piece, site);
    }

    void integrate(const FacePiece<D>& piece, const GapSite<D>& site, GapArm<D>& arm) const
    {
        const GapWalls<D>& walls = site.walls;
        const GapSection<D>& here = site.here;
        const Vec<D>&n = site.n, &e = site.e, &way = site.way;
        const double delta = site.delta, middle = site.middle, t0 = here.thickness, A = piece.area;
        const Vec<D> axis = unit<D>(piece.axis);

        const Eigen::Matrix<double, D, 2 * twist_size<D>> frame = mean_motion<D>(walls, here.normal, here.middle);
        arm.motion = frame.transpose() * axis;

        arm.flux.setZero();
        arm.mass.setZero();
        if (site.along_face()) {
            arm.resistance = delta / A;
            return;
        }
        const GapShape<D> shape = shape_of_gap(walls, piece.centroid, n, here);
        const double sigma = e.dot(shape.shares * way), bend = way.dot(shape.curvature * way);
        std::vector<GapLine<D>> lines = lines_of(piece, site);
        double sum = 0; // of the lines' areas
        for (const GapLine<D>& line : lines)
            sum += line.width * line.thickness;
        std::vector<std::vector<typename GapWay<D>::Point>> points;
        PairTwist<D> through = PairTwist<D>::Zero(); // the closing's flux at the face
        for (GapLine<D>& line : lines) {
            line.width *= A / sum;
            GapWay<D> along(walls, line.place, way, n, line.thickness, frame);
            points.push_back(along.points(middle - 0.5 + site.moved[0], middle + 0.5 + site.moved[1], sigma, bend));
            through += line.width * along.at_face();
        }
        for (std::size_t l = 0; l < lines.size(); ++l) {
            const double scale = lines[l].thickness / A;
            for (const auto& point : points[l]) {
                const double w = delta * point.weight * lines[l].width / point.thickness;
                const PairTwist<D> flux = point.flux - scale * through;
                arm.resistance += scale * scale * w;
                arm.flux += scale * w * flux;
                arm.mass += w * flux * flux.transpose();
            }
        }
        arm.share = share_up_to(t0, parameters.gap_start, parameters.gap_end);
        arm.resistance = arm.share * arm.resistance + (1 - arm.share) * delta / A;
        arm.flux *= arm.share;
        arm.mass *= arm.share;
    }

    /// The chord of a face through its piece's centroid, along the gap.
    void find_line(const FacePiece<D>& piece, GapSite<D>& site) const
    {
        const Vec<D>& n = site.n;
        const Vec<D> m = n.cross(unit<D>(piece.axis)).normalized();
        const Index<D> f = complex_.index.index(piece.face);
        Vec<D> centre = piece.centroid;
        int most = -1; // the face's direction nearest to m
        for (int t = 0; t < D; ++t)
            if (t != piece.axis) {
                centre[t] = planes_.centre_of(t, f[t]);
                most = most < 0 || std::abs(m[t]) > std::abs(m[most]) ? t : most;
            }
        const auto in_face = [&](double s) { // the gap, which may be bent
            const auto section = site.walls.across(piece.centroid + s * m, n);
            for (int t = 0; section && t < D; ++t)
                if (t != piece.axis && t != most &&
                    std::abs(section->middle[t] - centre[t]) > 0.5 * (1 + section->thickness * std::abs(n[t])))
                    return false;
            return section.has_value();
        };
        const auto end = [&](double s) {
            if (in_face(s))
                return s;
            double in = 0, out = s;
            for (int k = 0; k < 10; ++k)
                (in_face(0.5 * (in + out)) ? in : out) = 0.5 * (in + out);
            return in;
        };
        const double from = (centre[most] - piece.centroid[most] - 0.5) / m[most],
                     to = (centre[most] - piece.centroid[most] + 0.5) / m[most];
        site.line = m;
        site.from = end(from);
        site.to = end(to);
    }

    /// Across a piece: the nodes of a Gauss rule on its line.
    std::vector<GapLine<D>> lines_of(const FacePiece<D>& piece, const GapSite<D>& site) const
    {
        std::vector<GapLine<D>> lines;
        if constexpr (D == 3) {
            const double from = site.from, to = site.to;
            for (int k = 0; k < 3 && std::abs(to - from) > parameters.least_stretch; ++k) {
                const Vec<D> place = piece.centroid + (from + GapWay<D>::node[k] * (to - from)) * site.line;
                if (const auto section = site.walls.across(place, site.n))
                    lines.push_back({place, GapWay<D>::weight[k] * std::abs(to - from), section->thickness});
            }
        }
        if (lines.size() < 3)
            lines.assign(1, {piece.centroid, 1.0, site.here.thickness});
        return lines;
    }

    const Grid<D>& grid_;
    GridPlanes<D> planes_;
    const Complex<D>& complex_;
    const std::vector<std::pair<std::int32_t, Vec<D>>> moved_;
    std::vector<Image<D>> images_;
    std::vector<Vec<D>> reference_;
    std::vector<int> first_, image_of_; ///< of each solid
    std::vector<std::int32_t> sides_;
    std::vector<std::pair<std::int32_t, std::int32_t>> beside_; ///< part, solid
};

} // namespace

template <int D>
std::vector<GapArm<D>> find_gap_arms(const Grid<D>& grid, std::span<const Solid<D>> solids, const Complex<D>& complex)
{
    const GapFinder<D> finder(grid, solids, complex);
    return items_of<GapArm<D>>(static_cast<long>(complex.pieces.size()), [&](long k, std::vector<GapArm<D>>& arms) {
        if (auto arm = finder.arm_at(static_cast<std::size_t>(k)))
            arms.push_back(*arm);
    });
}

template <int D>
void for_each_gap(const Grid<D>& grid, std::span<const Solid<D>> solids, const Complex<D>& complex,
                  const std::function<void(const GapSite<D>&)>& visit)
{
    const GapFinder<D> finder(grid, solids, complex);
    for (std::size_t k = 0; k < complex.pieces.size(); ++k)
        if (const auto site = finder.site_at(k))
            visit(*site);
}

template std::vector<GapArm<2>> find_gap_arms(const Grid<2>&, std::span<const Solid<2>>, const Complex<2>&);
template std::vector<GapArm<3>> find_gap_arms(const Grid<3>&, std::span<const Solid<3>>, const Complex<3>&);
template void for_each_gap(const Grid<2>&, std::span<const Solid<2>>, const Complex<2>&,
                           const std::function<void(const GapSite<2>&)>&);
template void for_each_gap(const Grid<3>&, std::span<const Solid<3>>, const Complex<3>&,
                           const std::function<void(const GapSite<3>&)>&);

} // namespace gapflow
