#include "gapflow/complex/gap_way.hpp"
#include "gapflow/complex/mouth_arm.hpp"

#include "gapflow/complex/parameters.hpp"

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

ClosingFlow<2> closing_flow(const GapWalls<2>&, const Vec<2>&, const Vec<2>& n, double)
{
    return {Mat<2>::Identity() - n * n.transpose()};
}
ClosingFlow<3> closing_flow(const GapWalls<3>& walls, const Vec<3>& x, const Vec<3>& n, double thickness)
{
    const Vec<3> u = n.unitOrthogonal(), v = n.cross(u);
    double t[3][3];
    const double h = 0.5;
    for (int i = -1; i <= 1; ++i)
        for (int j = -1; j <= 1; ++j) {
            const std::optional<GapSection<3>> section = walls.across(x + h * (i * u + j * v), n);
            if (!section)
                return {0.5 * (Mat<3>::Identity() - n * n.transpose())};
            t[i + 1][j + 1] = section->thickness;
        }
    Mat<2> hess;
    hess(0, 0) = (t[2][1] - 2 * t[1][1] + t[0][1]) / (h * h);
    hess(1, 1) = (t[1][2] - 2 * t[1][1] + t[1][0]) / (h * h);
    hess(0, 1) = hess(1, 0) = (t[2][2] - t[2][0] - t[0][2] + t[0][0]) / (4 * h * h);
    const Vec<2> gradient((t[2][1] - t[0][1]) / (2 * h), (t[1][2] - t[1][0]) / (2 * h));
    const double e = parameters.faint_curvature;
    Mat<2> shares = positive_part(hess);
    const double curvature = shares.trace();
    shares += e / thickness * gradient * gradient.transpose() + e * e * thickness * Mat<2>::Identity();
    shares /= shares.trace();
    Eigen::Matrix<double, 3, 2> plane;
    plane << u, v;
    return {plane * shares * plane.transpose(), curvature};
}

namespace {

/// A way along a gap, at its place in a face.
template <int D>
struct GapLine {
    Vec<D> place;
    double width;
    GapSection<D> section;
    PairTwist<D> flux; ///< of the closing, through a width of one
};

template <int D>
class GapFinder {
public:
    GapFinder(const Grid<D>& grid, std::span<const Solid<D>> solids, const Complex<D>& complex)
        : grid_(grid), planes_(grid), complex_(complex), moved_(moved_nodes(grid, complex))
    {
        Vec<D> period = Vec<D>::Zero(), low, high;
        for (int axis = 0; axis < D; ++axis) {
            if (grid.periodic(axis))
                period[axis] = grid.size()[axis];
            low[axis] = planes_.place[axis][complex.index.low[axis]];
            high[axis] = planes_.place[axis][complex.index.high()[axis]];
        }
        images_ = images(solids, planes_.in_world(low), planes_.in_world(high), period, grid.dx());
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

    std::optional<GapSite<D>> site_at(std::size_t number)
    {
        const FacePiece<D>& piece = complex_.pieces[number];
        if (!piece.low.exists() || !piece.high.exists() || !(piece.area > 0))
            return {};
        find_walls(piece);
        if (near_.size() < 2)
            return {};
        const auto [a, b] = facing(piece.centroid);
        if (b < 0)
            return {};
        const GapWalls<D> walls{{images_[a].shape, images_[b].shape}, {reference_[a], reference_[b]}, &planes_};
        const Vec<D> n = (normal_[0] - normal_[1]).normalized();
        const std::optional<GapSection<D>> here = walls.across(piece.centroid, n);
        if (!here || here->thickness > parameters.gap_end)
            return {};
        GapSite<D> site{static_cast<std::int32_t>(number),
                        {images_[a].solid, images_[b].solid},
                        {is_side(images_[a].solid), is_side(images_[b].solid)},
                        walls,
                        n,
                        *here};
        find_way(piece, site);
        return site;
    }

    std::optional<GapArm<D>> arm_at(std::size_t number)
    {
        const std::optional<GapSite<D>> site = site_at(number);
        if (!site)
            return {};
        GapArm<D> arm{static_cast<std::int32_t>(number), site->solid, 0, 0, {}, {}, {}};
        integrate(complex_.pieces[number], *site, arm);
        for (int side = 0; side < 2; ++side)
            if (site->still[side]) {
                constexpr int T = twist_size<D>;
                for (PairTwist<D>* row : {&arm.flux, &arm.motion})
                    row->template segment<T>(side * T).setZero();
                arm.mass.template middleRows<T>(side * T).setZero();
                arm.mass.template middleCols<T>(side * T).setZero();
            }
        return arm;
    }

private:
    bool is_side(std::int32_t solid) const { return std::find(sides_.begin(), sides_.end(), solid) != sides_.end(); }

    void add_near(std::int32_t solid)
    {
        if (std::find(near_.begin(), near_.end(), solid) == near_.end())
            near_.push_back(solid);
    }

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
    void find_walls(const FacePiece<D>& piece)
    {
        near_ = sides_;
        for (const PartOrCell& side : {piece.low, piece.high})
            if (side.is_part())
                for (const WallPatch<D>& patch : complex_.patches_of(side.number()))
                    add_near(patch.solid);
        for (const PartOrCell& side : {piece.low, piece.high}) // walls across a plane of the grid that runs along the gap
            if (side.is_part())
                for (auto at = std::lower_bound(beside_.begin(), beside_.end(), std::pair(side.number(), 0));
                     at != beside_.end() && at->first == side.number(); ++at)
                    add_near(at->second);
    }

    /// The image nearest to x, and the nearest one of those that face it; -1: none.
    std::pair<int, int> facing(const Vec<D>& x)
    {
        std::pair<int, int> found{-1, -1};
        for (int side = 0; side < 2; ++side) {
            double least = parameters.gap_end * planes_.dx;
            for (const std::int32_t s : near_)
                for (int k = first_[s]; k < first_[s + 1]; ++k) {
                    const int i = image_of_[k];
                    if (side == 1 && i == found.first)
                        continue;
                    const SurfacePoint<D> at = images_[i].shape.closest(planes_.in_world(x));
                    if (!(at.distance < least) || (side == 1 && at.normal.dot(normal_[0]) > -parameters.least_facing))
                        continue;
                    least = at.distance;
                    (side == 0 ? found.first : found.second) = i;
                    normal_[side] = at.normal;
                }
            if (found.first < 0)
                break;
        }
        return found;
    }

    /// The way from node to node, and the line across it.
    void find_way(const FacePiece<D>& piece, GapSite<D>& site) const
    {
        const Index<D> f = complex_.index.index(piece.face);
        site.delta = grid_.spread(piece.axis, f[piece.axis]);
        site.e = unit<D>(piece.axis) - site.n[piece.axis] * site.n;
        site.way = site.delta * site.e;
        Vec<D> nodes = piece.centroid; // their middle
        for (int t = 0; t < D; ++t)
            if (t != piece.axis)
                nodes[t] = (grid_.centre_place(t, f[t]) - grid_.anchor()[t]) / grid_.dx();
        nodes[piece.axis] =
            (grid_.centre_place(piece.axis, f[piece.axis]) - grid_.anchor()[piece.axis]) / grid_.dx() - 0.5 * site.delta;
        site.middle = site.way.dot(nodes - piece.centroid) / site.way.squaredNorm();
        for (int side = 0; side < 2; ++side)
            if (const PartOrCell& at = side == 0 ? piece.low : piece.high; at.is_part())
                if (const auto moved = std::lower_bound(moved_.begin(), moved_.end(), at.number(),
                                                        [](const auto& m, std::int32_t p) { return m.first < p; });
                    moved != moved_.end() && moved->first == at.number())
                    site.moved[side] = site.way.dot(moved->second) / site.way.squaredNorm();
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

        // The walls' mean motion: their translation, and what of their rotation moves them along their normals.
        Eigen::Matrix<double, D, 2 * twist_size<D>> frame;
        for (int side = 0; side < 2; ++side) {
            const Vec<D>& m = here.normal[side];
            const Twist<D> turning = speed_along<D>(m, here.middle, walls.reference[side]);
            auto columns = frame.template middleCols<twist_size<D>>(side * twist_size<D>);
            columns.template leftCols<D>() = 0.5 * Mat<D>::Identity();
            columns.template rightCols<spin_size<D>>() = 0.5 * m * turning.template tail<spin_size<D>>().transpose();
        }
        arm.motion = frame.transpose() * axis;

        arm.flux.setZero();
        arm.mass.setZero();
        if (site.along_face()) {
            arm.resistance = delta / A;
            return;
        }
        const ClosingFlow<D> closing = closing_flow(walls, piece.centroid, n, t0);
        const double sigma = e.dot(closing.shares * way);
        std::vector<GapLine<D>> lines = lines_of(piece, site);
        double sum = 0; // of the lines' areas
        for (const GapLine<D>& line : lines)
            sum += line.width * line.section.thickness;
        PairTwist<D> through = PairTwist<D>::Zero(); // the closing's flux at the face
        for (GapLine<D>& line : lines) {
            line.width *= A / sum;
            line.flux = closing.flux(line.section, n, t0).dot(e) * (here.opening - frame.transpose() * here.slope);
            through += line.width * line.flux;
        }
        for (const GapLine<D>& line : lines) {
            GapWay<D> along(walls, line.place, way, n, line.section.thickness, frame);
            const PairTwist<D> at_face = line.flux - line.section.thickness / A * through;
            for (const auto& point : along.points(middle - 0.5 + site.moved[0], middle + 0.5 + site.moved[1], sigma)) {
                const double w = delta * point.weight * line.width / point.thickness, scale = line.section.thickness / A;
                const PairTwist<D> flux = at_face + point.flux;
                arm.resistance += scale * scale * w;
                arm.flux += scale * w * flux;
                arm.mass += w * flux * flux.transpose();
            }
        }
        const double x = std::clamp((parameters.gap_end - t0) / (parameters.gap_end - parameters.gap_start), 0.0, 1.0);
        arm.share = x * x * (3 - 2 * x);
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
                centre[t] = (grid_.centre_place(t, f[t]) - grid_.anchor()[t]) / grid_.dx();
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
                    lines.push_back({place, GapWay<D>::weight[k] * std::abs(to - from), *section, PairTwist<D>::Zero()});
            }
        }
        if (lines.size() < 3)
            lines.assign(1, {piece.centroid, 1.0, site.here, PairTwist<D>::Zero()});
        return lines;
    }

    const Grid<D>& grid_;
    GridPlanes<D> planes_;
    const Complex<D>& complex_;
    const std::vector<std::pair<std::int32_t, Vec<D>>> moved_;
    std::vector<Image<D>> images_;
    std::vector<Vec<D>> reference_;
    std::vector<int> first_, image_of_; ///< of each solid
    std::vector<std::int32_t> sides_, near_;
    std::vector<std::pair<std::int32_t, std::int32_t>> beside_; ///< part, solid
    std::array<Vec<D>, 2> normal_;
};

} // namespace

template <int D>
std::vector<GapArm<D>> find_gap_arms(const Grid<D>& grid, std::span<const Solid<D>> solids, const Complex<D>& complex)
{
    GapFinder<D> finder(grid, solids, complex);
    std::vector<GapArm<D>> arms;
    for (std::size_t k = 0; k < complex.pieces.size(); ++k)
        if (auto arm = finder.arm_at(k))
            arms.push_back(*arm);
    return arms;
}

template <int D>
void for_each_gap(const Grid<D>& grid, std::span<const Solid<D>> solids, const Complex<D>& complex,
                  const std::function<void(const GapSite<D>&)>& visit)
{
    GapFinder<D> finder(grid, solids, complex);
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
