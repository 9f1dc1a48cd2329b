#include "gapflow/complex/mouth_arm.hpp"

#include "gapflow/complex/corner.hpp"
#include "gapflow/complex/gap_way.hpp"
#include "gapflow/complex/mouth_walls.hpp"
#include "gapflow/complex/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace gapflow {
namespace {

template <int D>
Vec<D> cell_centre(const GridPlanes<D>& planes, const Index<D>& c)
{
    Vec<D> centre;
    for (int axis = 0; axis < D; ++axis)
        centre[axis] = planes.centre_of(axis, c[axis]);
    return centre;
}

/// To the left of the way n from the corner of a mouth.
Vec<2> left_of_mouth(const GapMouth<2>&, const Vec<2>& n)
{
    return left_of(n);
}
Vec<3> left_of_mouth(const GapMouth<3>& mouth, const Vec<3>&)
{
    return mouth.across;
}

/// What of a piece lies in a mouth in its plane. The rest, if any, leads to a wall that lies in the plane to round-off. Where the mouth's ends lie on a plane
/// across it to round-off, what opens beyond that is the mouth's as well: it leads around it.
double open_in(const GapMouth<2>& mouth, const FacePiece<2>& piece)
{
    const int along = 1 - piece.axis;
    const double from = std::min(mouth.at[along], mouth.end[along]), to = std::max(mouth.at[along], mouth.end[along]),
                 open = std::min(to, piece.centroid[along] + 0.5 * piece.area) -
                        std::max(from, piece.centroid[along] - 0.5 * piece.area);
    return piece.area < parameters.joint_distance && open > -parameters.joint_distance ? piece.area : open;
}

double open_in(const GapMouth<3>& mouth, const FacePiece<3>&)
{
    return mouth.area;
}

/// Pieces of faces in whose plane a mouth lies, and their mouths; sorted.
std::vector<std::pair<std::int32_t, int>> pieces_in_mouths(const Complex<2>& complex)
{
    std::vector<std::pair<std::int32_t, int>> pieces;
    std::vector<int> mouths;
    for (std::size_t m = 0; m < complex.mouths.size(); ++m)
        if (complex.mouths[m].axis >= 0)
            mouths.push_back(static_cast<int>(m));
    for (std::size_t k = 0; k < complex.pieces.size() && !mouths.empty(); ++k) {
        const FacePiece<2>& piece = complex.pieces[k];
        if (!piece.low.exists() || !piece.high.exists() || !(piece.area > 0))
            continue;
        const int plane = complex.index.index(piece.face)[piece.axis];
        for (const int m : mouths) {
            const GapMouth<2>& mouth = complex.mouths[m];
            if (mouth.axis == piece.axis && mouth.plane == plane && open_in(mouth, piece) > parameters.least_stretch) {
                pieces.emplace_back(static_cast<std::int32_t>(k), m);
                break;
            }
        }
    }
    return pieces;
}

std::vector<std::pair<std::int32_t, int>> pieces_in_mouths(const Complex<3>& complex)
{
    std::vector<std::pair<std::int32_t, int>> pieces;
    for (std::size_t m = 0; m < complex.mouths.size(); ++m)
        if (complex.mouths[m].piece >= 0)
            pieces.emplace_back(complex.mouths[m].piece, static_cast<int>(m));
    std::sort(pieces.begin(), pieces.end());
    pieces.erase(std::unique(pieces.begin(), pieces.end(), [](const auto& a, const auto& b) { return a.first == b.first; }),
                 pieces.end());
    return pieces;
}

/// Pieces of faces beside the parts, and those in mouths; none that only round-off leaves where lines cross in a face. Of a complex with mouths; else empty.
template <int D>
class PiecesOfParts {
public:
    explicit PiecesOfParts(const Complex<D>& complex)
    {
        if (complex.mouths.empty())
            return;
        in_mouths_ = pieces_in_mouths(complex);
        first_.assign(complex.parts() + 1, 0);
        for (const bool count : {true, false}) {
            std::vector<int> next = first_;
            for (std::size_t k = 0; k < complex.pieces.size(); ++k)
                for (const PartOrCell& side : {complex.pieces[k].low, complex.pieces[k].high})
                    if (side.is_part() && complex.pieces[k].area > parameters.least_stretch) {
                        if (count)
                            ++first_[side.number() + 1];
                        else
                            piece_[next[side.number()]++] = static_cast<std::int32_t>(k);
                    }
            if (count) {
                for (int p = 0; p < complex.parts(); ++p)
                    first_[p + 1] += first_[p];
                piece_.resize(first_.back());
            }
        }
    }
    std::span<const std::int32_t> of(int part) const
    {
        return {piece_.data() + first_[part], static_cast<std::size_t>(first_[part + 1] - first_[part])};
    }

    const std::vector<std::pair<std::int32_t, int>>& in_mouths() const { return in_mouths_; }
    bool in_mouth(std::int32_t piece) const
    {
        const auto at = std::lower_bound(in_mouths_.begin(), in_mouths_.end(), std::pair(piece, 0));
        return at != in_mouths_.end() && at->first == piece;
    }

private:
    std::vector<int> first_;
    std::vector<std::int32_t> piece_;
    std::vector<std::pair<std::int32_t, int>> in_mouths_;
};

/// What lies at the left and right of the way from the corner of a mouth in a plane.
std::array<PartOrCell, 2> sides_of(const GapMouth<2>& mouth, const FacePiece<2>& piece)
{
    const bool upward = mouth.end[1 - piece.axis] > mouth.at[1 - piece.axis], low_is_left = (piece.axis == 0) == upward;
    return low_is_left ? std::array<PartOrCell, 2>{piece.low, piece.high} : std::array<PartOrCell, 2>{piece.high, piece.low};
}

std::array<PartOrCell, 2> sides_of(const GapMouth<3>& mouth, const FacePiece<3>& piece)
{
    return mouth.across[piece.axis] < 0 ? std::array<PartOrCell, 2>{piece.low, piece.high}
                                        : std::array<PartOrCell, 2>{piece.high, piece.low};
}

/// How far a node of a part behind a mouth is moved.
template <int D>
struct MovedNode {
    std::int32_t part;
    Vec<D> way;   ///< from the cell's centre
    double share; ///< of it in the nodes of the gap's faces
};

/// Convex polygons of a convex body's surface, in any direction of turning.
using Facets = std::vector<std::vector<Vec<3>>>;

Facets box_facets(const Vec<3>& low, const Vec<3>& high)
{
    Facets facets;
    for (int axis = 0; axis < 3; ++axis)
        for (const Vec<3>& end : {low, high}) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            std::vector<Vec<3>> facet(4, end);
            for (int k = 0; k < 4; ++k) {
                facet[k][u] = k == 1 || k == 2 ? high[u] : low[u];
                facet[k][v] = k >= 2 ? high[v] : low[v];
            }
            facets.push_back(facet);
        }
    return facets;
}

/// What of a convex body lies where n . (x - at) >= 0.
void keep_in_front(Facets& facets, const Vec<3>& n, const Vec<3>& at)
{
    Facets kept;
    std::vector<Vec<3>> cut; // in the plane
    for (const std::vector<Vec<3>>& facet : facets) {
        std::vector<Vec<3>> polygon;
        for (std::size_t k = 0; k < facet.size(); ++k) {
            const Vec<3>&p = facet[k], &q = facet[(k + 1) % facet.size()];
            const double a = n.dot(p - at), b = n.dot(q - at);
            if (a >= 0)
                polygon.push_back(p);
            if ((a >= 0) != (b >= 0)) {
                polygon.push_back(p + a / (a - b) * (q - p));
                cut.push_back(polygon.back());
            }
        }
        if (polygon.size() > 2)
            kept.push_back(polygon);
    }
    if (cut.size() > 2) {
        Vec<3> middle = Vec<3>::Zero();
        for (const Vec<3>& x : cut)
            middle += x / static_cast<double>(cut.size());
        const Vec<3> u = n.unitOrthogonal(), v = n.cross(u);
        std::sort(cut.begin(), cut.end(), [&](const Vec<3>& x, const Vec<3>& y) {
            return std::atan2(v.dot(x - middle), u.dot(x - middle)) < std::atan2(v.dot(y - middle), u.dot(y - middle));
        });
        kept.push_back(cut);
    }
    facets = kept;
}

/// Volume and centroid of a convex body.
std::pair<double, Vec<3>> volume_of(const Facets& facets)
{
    Vec<3> inside = Vec<3>::Zero(), moment = inside;
    double volume = 0, count = 0;
    for (const auto& facet : facets)
        for (const Vec<3>& x : facet) {
            inside += x;
            ++count;
        }
    inside /= std::max(count, 1.0);
    for (const auto& facet : facets)
        for (std::size_t k = 1; k + 1 < facet.size(); ++k) {
            const double v = std::abs((facet[0] - inside).dot((facet[k] - inside).cross(facet[k + 1] - inside))) / 6;
            volume += v;
            moment += 0.25 * v * (inside + facet[0] + facet[k] + facet[k + 1]);
        }
    return {volume, volume > 0 ? Vec<3>(moment / volume) : inside};
}

/// Centroid of what lies of a part's cell in the gap on one side of a mouth; nothing where it lies on the other one.
std::optional<Vec<2>> centroid_in_gap(const Complex<2>& complex, const GridPlanes<2>&, const GapMouth<2>&, int,
                                      std::int32_t part)
{
    return complex.part_centroid[part];
}
std::optional<Vec<3>> centroid_in_gap(const Complex<3>& complex, const GridPlanes<3>& planes, const GapMouth<3>& mouth,
                                      int side, std::int32_t part)
{
    const Index<3> c = complex.cell_of_part(part);
    Vec<3> low, high, shift = Vec<3>::Zero();
    const Vec<3> middle = 0.5 * (mouth.at + mouth.end), along = mouth.across.cross(mouth.end - mouth.at).normalized();
    for (int axis = 0; axis < 3; ++axis) {
        low[axis] = planes.place[axis][c[axis]];
        high[axis] = planes.place[axis][c[axis] + 1];
        if (complex.index.wraps[axis])
            shift[axis] = planes.place[axis].period() *
                          std::round((middle[axis] - 0.5 * (low[axis] + high[axis])) / planes.place[axis].period());
    }
    if (std::abs(along.dot(0.5 * (low + high) + shift - middle)) > 1.5)
        return {}; // other mouths of the edge are nearer
    Facets body = box_facets(low + shift, high + shift);
    keep_in_front(body, (side == 0 ? 1 : -1) * mouth.across, middle);
    for (const auto& wall : mouth.walls[side])
        keep_in_front(body, wall.normal, wall.at);
    const auto [volume, centroid] = volume_of(body);
    if (!(volume > parameters.least_area))
        return {};
    return Vec<3>(centroid - shift);
}

/// Places of a gap's nodes are free, but none may lie beyond the gap's end: where the cell's centre is nearer to a mouth than the part's centroid, the node
/// lies there. Parts further behind a mouth keep theirs.
template <int D>
class MovedNodes {
public:
    MovedNodes(const Grid<D>& grid, const Complex<D>& complex, const PiecesOfParts<D>& pieces)
        : planes_(grid), complex_(complex)
    {
        const auto behind = [&](const GapMouth<D>& mouth, int side, const PartOrCell& first) {
            if (first.is_part())
                add_joint(mouth, side, first.number());
            if (!(mouth.share * mouth.sides[side].gap > 0) || !first.is_part())
                return;
            std::vector<std::int32_t> parts{first.number()};
            for (std::size_t k = 0; k < parts.size(); ++k) {
                if (!add(mouth, side, parts[k]))
                    continue;
                for (const std::int32_t piece : pieces.of(parts[k]))
                    for (const PartOrCell& next : {complex.pieces[piece].low, complex.pieces[piece].high})
                        if (next.is_part() && !pieces.in_mouth(piece) &&
                            std::find(parts.begin(), parts.end(), next.number()) == parts.end())
                            parts.push_back(next.number());
            }
        };
        for (const CornerLink<D>& link : complex.links)
            if (link.mouth >= 0) {
                behind(complex.mouths[link.mouth], 0, PartOrCell::part(link.a));
                behind(complex.mouths[link.mouth], 1, PartOrCell::part(link.b));
            }
        for (const auto& [piece, m] : pieces.in_mouths())
            for (const int side : {0, 1})
                behind(complex.mouths[m], side, sides_of(complex.mouths[m], complex.pieces[piece])[side]);
        std::sort(nodes_.begin(), nodes_.end(), [](const MovedNode<D>& a, const MovedNode<D>& b) {
            return a.part < b.part || (a.part == b.part && a.way.norm() * a.share > b.way.norm() * b.share);
        });
        keep_farthest();
    }

    const std::vector<MovedNode<D>>& nodes() const { return nodes_; }
    Vec<D> way(const PartOrCell& part) const
    {
        Vec<D> way = Vec<D>::Zero();
        for (auto at = std::lower_bound(nodes_.begin(), nodes_.end(), part.code,
                                        [](const MovedNode<D>&m, std::int32_t p) { return m.part < p; });
             at != nodes_.end() && at->part == part.code; ++at)
            way += at->way;
        return way;
    }

private:
    /// One of each part: the first one. In 3D, where a part lies behind the mouths of two edges that meet, also what of another one leads across it.
    void keep_farthest()
    {
        std::vector<MovedNode<D>> kept;
        for (std::size_t k = 0; k < nodes_.size();) {
            const MovedNode<D>& first = nodes_[k];
            const Vec<D> direction = first.way.normalized();
            MovedNode<D> across{first.part, Vec<D>::Zero(), 0};
            std::size_t last = k;
            for (; last < nodes_.size() && nodes_[last].part == first.part; ++last)
                if (const Vec<D> way = nodes_[last].way - nodes_[last].way.dot(direction) * direction;
                    D == 3 && nodes_[last].share * way.norm() > across.share * across.way.norm() + parameters.least_stretch)
                    across = {first.part, way, nodes_[last].share};
            kept.push_back(first);
            if (across.share > 0)
                kept.push_back(across);
            k = last;
        }
        nodes_ = kept;
    }

    /// A gap that ends in front of a third wall leads into another one, along the corner's other side: its node lies where they meet.
    void add_joint(const GapMouth<D>& mouth, int side, std::int32_t part)
    {
        const GapMouthSide& sector = mouth.sides[side];
        const double share = mouth.share * (1 - sector.gap) * share_up_to(mouth.room, parameters.gap_start, parameters.gap_end);
        if (!(share > 0))
            return;
        Vec<D> way = 0.5 * (mouth.at + mouth.end) - cell_centre(planes_, complex_.cell_of_part(part));
        for (int axis = 0; axis < D; ++axis)
            if (complex_.index.wraps[axis])
                way[axis] -= planes_.place[axis].period() * std::round(way[axis] / planes_.place[axis].period());
        const Vec<D> n = (mouth.end - mouth.at).normalized(), out = (side == 0 ? 1 : -1) * left_of_mouth(mouth, n).normalized();
        const double turn = sector.apex * sector.angle;
        const Vec<D> along = std::cos(turn) * out - std::sin(turn) * n;
        nodes_.push_back({part, along.dot(way) * along, share});
    }

    /// Whether the part lies beside the mouth.
    bool add(const GapMouth<D>& mouth, int side, std::int32_t part)
    {
        const std::optional<Vec<D>> in_gap = centroid_in_gap(complex_, planes_, mouth, side, part);
        if (!in_gap)
            return false;
        const Vec<D> inward = (side == 0 ? 1 : -1) * left_of_mouth(mouth, mouth.end - mouth.at).normalized(),
                     &centroid = *in_gap;
        const double distance = inward.dot(centroid - 0.5 * (mouth.at + mouth.end)), x = 2 - distance / half_diagonal;
        if (!(distance > -half_diagonal && x > 0))
            return false;
        const double near = x < 1 ? x * x * (3 - 2 * x) : 1,
                     way = inward.dot(centroid - cell_centre(planes_, complex_.cell_of_part(part)));
        if (way > 0)
            nodes_.push_back({part, near * way * inward, mouth.share * mouth.sides[side].gap});
        return true;
    }

    /// A centroid is no further from the cell's centre.
    static constexpr double half_diagonal = 0.5 * (D == 2 ? std::numbers::sqrt2 : std::numbers::sqrt3);

    const GridPlanes<D> planes_;
    const Complex<D>& complex_;
    std::vector<MovedNode<D>> nodes_;
};

/// Area of the triangle 0, a, b within a circle about 0, positive counterclockwise.
double area_in_circle(const Vec<2>& a, const Vec<2>& b, double radius)
{
    const auto cross = [](const Vec<2>& x, const Vec<2>& y) { return x[0] * y[1] - x[1] * y[0]; };
    const auto sector = [&](const Vec<2>& x, const Vec<2>& y) {
        return 0.5 * radius * radius * std::atan2(cross(x, y), x.dot(y));
    };
    const Vec<2> way = b - a;
    const double A = way.squaredNorm(), B = a.dot(way), C = a.squaredNorm() - radius * radius, root2 = B * B - A * C;
    if (!(A > 0))
        return 0;
    if (!(root2 > 0))
        return sector(a, b);
    const double root = std::sqrt(root2), from = std::clamp((-B - root) / A, 0.0, 1.0),
                 to = std::clamp((-B + root) / A, 0.0, 1.0);
    if (!(to > from))
        return sector(a, b);
    const Vec<2> p = a + from * way, q = a + to * way;
    return (from > 0 ? sector(a, p) : 0.0) + 0.5 * cross(p, q) + (to < 1 ? sector(q, b) : 0.0);
}

/// What of a cell lies in circles about a mouth: areas in the plane of the flow. In 3D the mean of sections over the width of the mouth along its edge.
template <int D>
class CellInCircle {
public:
    /// `reach`: of the cell from the centre. `width`: of the mouth.
    CellInCircle(const GapMouth<D>& mouth, const Vec<D>& low, const Vec<D>& high, const Vec<D>& centre, double reach,
                 double width)
    {
        if constexpr (D == 2)
            sections_.push_back(
                {low - centre, Vec<2>(high[0], low[1]) - centre, high - centre, Vec<2>(low[0], high[1]) - centre});
        else {
            const Vec<3> n = (mouth.end - mouth.at).normalized(), along = mouth.across.cross(n);
            for (int k = 0; k < 3; ++k) {
                const Vec<3> at = centre + (ThreePoints::node[k] - 0.5) * width * along;
                std::vector<Vec<2>> polygon{{-reach, -reach}, {reach, -reach}, {reach, reach}, {-reach, reach}};
                for (int axis = 0; axis < 3; ++axis) {
                    const Vec<2> slope(mouth.across[axis], n[axis]);
                    clip(polygon, slope, at[axis] - low[axis]);
                    clip(polygon, -slope, high[axis] - at[axis]);
                }
                sections_.push_back(std::move(polygon));
            }
        }
    }
    double area(double radius) const
    {
        double sum = 0;
        for (std::size_t k = 0; k < sections_.size(); ++k) {
            const std::vector<Vec<2>>& polygon = sections_[k];
            double section = 0;
            for (std::size_t i = 0; i < polygon.size(); ++i)
                section += area_in_circle(polygon[i], polygon[(i + 1) % polygon.size()], radius);
            sum += (D == 2 ? 1.0 : ThreePoints::weight[k]) * std::max(section, 0.0);
        }
        return sum;
    }

private:
    std::vector<std::vector<Vec<2>>> sections_;
};

template <int D>
class MouthArms {
public:
    MouthArms(const Grid<D>& grid, std::span<const Solid<D>> solids, const Complex<D>& complex, const Standoffs<D>& standoffs)
        : grid_(grid), planes_(grid), solids_(solids), complex_(complex), standoffs_(standoffs), pieces_(complex),
          moved_(grid, complex, pieces_)
    {
        if (!complex.mouths.empty())
            images_ = images_at<D>(grid, planes_, complex.index, solids, 2 * grid.dx());
    }

    std::vector<MouthArm<D>> find()
    {
        std::vector<MouthArm<D>> arms;
        for (std::size_t k = 0; k < complex_.links.size(); ++k)
            if (const CornerLink<D>& link = complex_.links[k]; link.mouth >= 0) {
                arms.push_back(through(complex_.mouths[link.mouth], {PartOrCell::part(link.a), PartOrCell::part(link.b)},
                                       link.open,
                                       link.covered > 0 ? 1 / link.conductance : 0.0)); // the corner's share is in it
                arms.back().link = static_cast<std::int32_t>(k);
            }
        for (const auto& [piece, mouth] : pieces_.in_mouths())
            arms.push_back(through_piece(piece, complex_.mouths[mouth]));
        return arms;
    }

private:
    static constexpr int T = twist_size<D>;

    int image_at(std::int32_t solid, const Vec<D>& x) const
    {
        int nearest = -1;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < images_.size(); ++k)
            if (images_[k].solid == solid)
                if (const double distance = std::abs(closest_point<D>(images_[k].shape, planes_.in_world(x)).distance);
                    distance < least) {
                    least = distance;
                    nearest = static_cast<int>(k);
                }
        return nearest;
    }

    bool face_in_mouth(int axis, int face) const
    {
        return std::any_of(pieces_.in_mouths().begin(), pieces_.in_mouths().end(), [&](const auto& in) {
            return complex_.pieces[in.first].axis == axis && complex_.pieces[in.first].face == face;
        });
    }

    MouthArm<D> through_piece(std::int32_t number, const GapMouth<D>& mouth)
    {
        const FacePiece<D>& piece = complex_.pieces[number];
        const double plain =
            (1 - mouth.share) * grid_.spread(piece.axis, complex_.index.index(piece.face)[piece.axis]) / piece.area;
        MouthArm<D> arm = through(mouth, sides_of(mouth, piece), open_in(mouth, piece), plain);
        arm.piece = number;
        add_motion(mouth, piece, arm);
        return arm;
    }

    /// A face that moves as the line does: of a link the dividing line is part of the wall. With the walls' mean motion U and that of the line, U_l, the terms of the
    /// face's energy without the relative flux are A delta (U U_l - 1/2 U^2), as of the link and the gap's face beside it.
    void add_motion(const GapMouth<D>& mouth, const FacePiece<D>& piece, MouthArm<D>& arm) const
    {
        const auto walls = walls_at(mouth);
        if (!walls)
            return;
        const Vec<D> n = (mouth.end - mouth.at).normalized(), e = unit<D>(piece.axis);
        const PairTwist<D> mean = piece.area * mean_motion<D>(*walls, {n, -n}, 0.5 * (mouth.at + mouth.end)).transpose() * e;
        arm.carried = piece.area * line_motion(mouth, *walls, e, piece.centroid);
        const double delta = grid_.spread(piece.axis, complex_.index.index(piece.face)[piece.axis]);
        const PairMass<D> product = mean * arm.carried.transpose(),
                          mass = delta / piece.area * (product + product.transpose() - mean * mean.transpose());
        arm.mass += mass;
        arm.motion += mass;
        keep_still(mouth, *walls, arm);
    }

    /// Of the corner's solid and of the one across.
    std::optional<GapWalls<D>> walls_at(const GapMouth<D>& mouth) const
    {
        const Vec<D> middle = 0.5 * (mouth.at + mouth.end);
        const int first = image_at(mouth.solid[0], middle), second = image_at(mouth.solid[1], middle);
        if (first < 0 || second < 0)
            return {};
        const auto reference = [&](int k) { return planes_.in_cells(solids_[images_[k].solid].centre + images_[k].shift); };
        return GapWalls<D>{{GapWall<D>(images_[first].shape, planes_), GapWall<D>(images_[second].shape, planes_)},
                           {reference(first), reference(second)},
                           standoffs_.of(mouth.solid[0], mouth.solid[1]).distance};
    }

    /// Speed along e, at x, of the line that divides the fluid: where one wall goes on, that of the corner's solid; between two corners the mean of both; else what lies
    /// between, as the share of the corner's wall in the sector. The flux through the mouth is relative to it.
    static PairTwist<D> line_motion(const GapMouth<D>& mouth, const GapWalls<D>& walls, const Vec<D>& e, const Vec<D>& x)
    {
        double sum = 0, share = 0;
        for (const GapMouthSide& side : mouth.sides) {
            sum += 1 - side.gap;
            share += (1 - side.gap) * side.apex;
        }
        share = sum > 0 ? share / sum : 1;
        PairTwist<D> motion;
        motion << share * speed_along<D>(e, x, walls.reference[0]), (1 - share) * speed_along<D>(e, x, walls.reference[1]);
        return motion;
    }

    /// From one of two parts to the other; `rest`: resistance of the link or face without the mouth.
    MouthArm<D> through(const GapMouth<D>& mouth, const std::array<PartOrCell, 2>& parts, double open, double rest)
    {
        MouthArm<D> arm{
            -1, -1, mouth.solid, 0, PairTwist<D>::Zero(), PairMass<D>::Zero(), PairMass<D>::Zero(), PairTwist<D>::Zero(), {}};
        const double h = (mouth.end - mouth.at).norm(), part = mouth.length / open;
        const Vec<D> n = (mouth.end - mouth.at) / h, out = -left_of_mouth(mouth, n), middle = 0.5 * (mouth.at + mouth.end);
        const std::optional<GapWalls<D>> both = walls_at(mouth);
        if (!both)
            return arm;
        const GapWalls<D>& walls = *both;
        const Eigen::Matrix<double, D, 2 * T> frame = mean_motion<D>(walls, {n, -n}, middle);
        // The flux in the frame of the walls less that relative to the line.
        const PairTwist<D> line = line_motion(mouth, walls, out, middle), carried = h * (line - frame.transpose() * out);
        arm.carried = h / part * line;
        arm.carried.template head<T>() -= h / part * speed_along<D>(out, middle, walls.reference[0]);
        for (int side = 0; side < 2; ++side) {
            const double share = mouth.share * mouth.sides[side].gap, sign = side == 0 ? 1 : -1;
            if (share > 0) {
                const Vec<D> at =
                    cell_centre(planes_, complex_.index.index(complex_.cell_of(parts[side]))) + moved_.way(parts[side]);
                const double way = std::max(0.0, -sign * out.dot(at - middle));
                const double wedge = wedge_of(walls, middle, n, -sign * way * out);
                GapWay<D> along(walls, middle, out, n, h + walls.standoff(), frame);
                for (const auto& point : along.points(side == 0 ? -way : 0.0, side == 0 ? 0.0 : way, 1.0, 0.0, true)) {
                    const double w = share * part * wedge * point.weight / point.thickness;
                    const PairTwist<D> flux = (carried + point.flux) / part;
                    arm.resistance += w;
                    arm.flux += w * flux;
                    arm.mass += w * flux * flux.transpose();
                }
                add_row(arm, parts[side], sign * share);
            }
            if (const double spread = mouth.share * (1 - mouth.sides[side].gap); spread > 0)
                spread_out(mouth, side, parts[side], sign * spread, part, outlet_of(mouth.sides[side], h, walls.standoff()),
                           arm);
            if (mouth.share < 1)
                add_row(arm, parts[side], sign * (1 - mouth.share));
        }
        arm.resistance = std::max(arm.resistance, parameters.least_covered);
        arm.resistance += rest;
        const auto place_of = [&](const PartOrCell& row) {
            Vec<D> place = cell_centre(planes_, complex_.index.index(complex_.cell_of(row)));
            for (int axis = 0; axis < D; ++axis)
                if (grid_.periodic(axis))
                    place[axis] -=
                        planes_.place[axis].period() * std::round((place[axis] - middle[axis]) / planes_.place[axis].period());
            return place;
        };
        Vec<D> way = Vec<D>::Zero();
        for (const auto& [row, weight] : arm.rows)
            way -= weight * place_of(row);
        if (const double ratio = arm.resistance / (least_of_way * way.squaredNorm()); ratio < 1) {
            // Another mouth's line shuts the sector off: what has no resistance leads from part to part, not to parts of no size in several cells.
            const double rest = 1 - ratio * ratio * (3 - 2 * ratio);
            for (auto& [row, weight] : arm.rows)
                weight *= 1 - rest;
            add_row(arm, parts[0], rest);
            add_row(arm, parts[1], -rest);
            way += rest * (place_of(parts[1]) - place_of(parts[0]) - way);
        }
        const PairTwist<D> own = arm.flux, uniform = frame.transpose() * way;
        arm.flux += uniform;
        const double g = 1 / arm.resistance;
        arm.motion = -g * (own * uniform.transpose() + uniform * own.transpose() + uniform * uniform.transpose());
        arm.mass -= g * arm.flux * arm.flux.transpose();
        keep_still(mouth, walls, arm);
        return arm;
    }

    /// Resistance on one side: with a thickness larger by `standoff` the logarithm of h in it changes.
    static double outlet_of(const GapMouthSide& side, double h, double standoff)
    {
        return standoff > 0 && side.angle > 0 ? side.outlet - std::log1p(standoff / h) / side.angle : side.outlet;
    }

    /// Resistance of a wedge over that of the mean velocity along the lines across it: these are those of the mouth and not normal to its middle. The walls
    /// half the way behind the mouth.
    static double wedge_of(const GapWalls<D>& walls, const Vec<D>& middle, const Vec<D>& n, const Vec<D>& way)
    {
        const auto half = walls.profile(middle + 0.5 * way, n);
        if (!half || !(way.norm() > parameters.least_stretch))
            return 1;
        const Vec<D> along = way.normalized();
        std::array<double, 2> slope;
        for (int side = 0; side < 2; ++side)
            slope[side] = half->normal[side].dot(along) / ((side == 0 ? 1 : -1) * n.dot(half->normal[side]));
        const double angle = std::atan(slope[0]) + std::atan(slope[1]);
        return std::abs(angle) > parameters.parallel ? (slope[0] + slope[1]) / angle : 1 + slope[0] * slope[0];
    }

    /// No energy of what moves no wall: sides of the domain, and the spin of a ball, which has some of round-off.
    void keep_still(const GapMouth<D>& mouth, const GapWalls<D>& walls, MouthArm<D>& arm) const
    {
        for (int side = 0; side < 2; ++side) {
            const PlacedShape<D>& shape = walls.wall(side).shape();
            if (solids_[mouth.solid[side]].wall)
                still(arm, side * T, T);
            else if (shape.shape().sphere_radius() &&
                     (planes_.in_cells(shape.to_world(Vec<D>::Zero())) - walls.reference[side]).norm() < place_unit)
                still(arm, side * T + D, spin_size<D>);
        }
    }

    /// No energy of some components of the twists.
    static void still(MouthArm<D>& arm, int first, int count)
    {
        arm.flux.segment(first, count).setZero();
        arm.carried.segment(first, count).setZero();
        for (PairMass<D>* mass : {&arm.mass, &arm.motion}) {
            mass->middleRows(first, count).setZero();
            mass->middleCols(first, count).setZero();
        }
    }

    static void add_row(MouthArm<D>& arm, const PartOrCell& row, double weight)
    {
        for (auto& [other, sum] : arm.rows)
            if (other.code == row.code) {
                sum += weight;
                return;
            }
        arm.rows.emplace_back(row, weight);
    }

    /// Area of a part (3D: volume); exact between flat walls, of which those of the mouth's own solid meet at `edge`.
    double size_of(std::int32_t part, const Vec<D>& edge) const
    {
        if constexpr (D == 2)
            return complex_.part_area[part];
        else {
            const int number = complex_.cut_cell[complex_.part_cell[part]];
            const Index<3> c = complex_.index.index(number);
            const Vec<3> centre = cell_centre(planes_, c);
            Vec<3> apex = edge;
            for (int axis = 0; axis < 3; ++axis)
                if (grid_.periodic(axis))
                    apex[axis] +=
                        planes_.place[axis].period() * std::round((centre[axis] - edge[axis]) / planes_.place[axis].period());
            double size = 0;
            std::array<bool, 6> known{};
            const auto add_face = [&](int axis, int end, double area) {
                size += (end == 0 ? -1 : 1) * area * (planes_.place[axis][c[axis] + end] - apex[axis]) / 3;
            };
            for (const std::int32_t k : pieces_.of(part)) {
                const FacePiece<3>& piece = complex_.pieces[k];
                const int end = piece.low.code == part && piece.face != number ? 1 : 0;
                known[2 * piece.axis + end] = true;
                add_face(piece.axis, end, piece.area);
            }
            if (complex_.is_main(part))
                for (int q = 0; q < 6; ++q) {
                    const Index<3> f = complex_.index.wrapped(Index<3>(c + q % 2 * step<3>(q / 2)));
                    if (const double area = complex_.main_area[q / 2][complex_.index(f)]; area > 0 && !known[q])
                        add_face(q / 2, q % 2, area);
                }
            for (const WallPatch<3>& patch : complex_.patches_of(part))
                if (const int k = image_at(patch.solid, centre); k >= 0) {
                    const Vec<3> x = planes_.in_cells(closest_point<D>(images_[k].shape, planes_.in_world(centre)).x);
                    const bool own = std::abs(closest_point<D>(images_[k].shape, planes_.in_world(apex)).distance) <
                                     parameters.joint_distance * planes_.dx;
                    if (!own)
                        size += patch.area.dot(x - apex) / 3;
                }
            return std::clamp(size, 0.0, 1.0);
        }
    }

    /// Over what of the circle about the mouth is joined with a part within the circle. Of the flux the share 1 - F passes the distance r in the sector, where
    /// F leaves the source within r: the resistance is int (1 - F^2) dr / (angle r), and F = r^2/a^2 for the source that is even over the sector. Where
    /// the mouth has a share only, the rest of the flux leaves into the part itself: in the sum of the two laws the product of share and rest with
    /// the resistance of the difference of their sources is missing.
    void spread_out(const GapMouth<D>& mouth, int side, const PartOrCell& from, double weight, double part, double outlet,
                    MouthArm<D>& arm)
    {
        const Vec<D> centre = mouth.at + mouth.sides[side].apex * (mouth.end - mouth.at);
        struct Target {
            PartOrCell at;
            double fraction, size; ///< of the cell that is the part's; what of it lies in the circle
            CellInCircle<D> cell;
        };
        std::vector<Target> targets;
        const double reach = mouth.radius + std::sqrt(static_cast<double>(D)); // of cells within the circle
        const auto offer = [&](const PartOrCell& at) {
            if (!at.exists() ||
                std::any_of(targets.begin(), targets.end(), [&](const Target& t) { return t.at.code == at.code; }))
                return;
            const Index<D> c = complex_.index.index(complex_.cell_of(at));
            Vec<D> low, high;
            for (int axis = 0; axis < D; ++axis) {
                low[axis] = planes_.place[axis][c[axis]];
                high[axis] = planes_.place[axis][c[axis] + 1];
            }
            Vec<D> nearest = centre; // of its images
            for (int axis = 0; axis < D; ++axis)
                if (grid_.periodic(axis))
                    nearest[axis] += planes_.place[axis].period() *
                                     std::round((0.5 * (low + high)[axis] - centre[axis]) / planes_.place[axis].period());
            const CellInCircle<D> cell(mouth, low, high, nearest, reach, 1 / part);
            const double inside = cell.area(mouth.radius);
            if (inside > parameters.least_area || targets.empty()) {
                const double fraction = at.is_part() ? size_of(at.number(), mouth.at) / (high - low).prod() : 1.0;
                targets.push_back({at, fraction, inside * fraction, cell});
            }
        };
        offer(from);
        double sum = 0;
        for (std::size_t k = 0; k < targets.size(); ++k) {
            const PartOrCell at = targets[k].at;
            sum += targets[k].size;
            if (at.is_part())
                for (const std::int32_t number : pieces_.of(at.number())) {
                    if (pieces_.in_mouth(number))
                        continue;
                    const FacePiece<D>& piece = complex_.pieces[number];
                    offer(piece.low);
                    offer(piece.high);
                }
            if (complex_.is_main(at))
                for (int axis = 0; axis < D; ++axis) {
                    const Index<D> c = complex_.index.index(complex_.cell_of(at));
                    for (const int end : {0, 1}) {
                        const Index<D> f = complex_.index.wrapped(Index<D>(c + end * step<D>(axis))),
                                       other = complex_.index.wrapped(Index<D>(c + (2 * end - 1) * step<D>(axis)));
                        if (complex_.index.holds(other) && complex_.main_area[axis][complex_.index(f)] > 0 &&
                            !face_in_mouth(axis, complex_.index(f)))
                            offer(complex_.main_of(complex_.index(other)));
                    }
                }
        }
        if (!(sum > 0)) {
            add_row(arm, from, weight);
            arm.resistance += std::abs(weight) * part * std::max(0.0, outlet);
            return;
        }
        double lattice = 0, other = 0; // of the source, and of its difference from one in the first cell alone
        for (std::size_t k = 0; k < targets.size(); ++k)
            if (const Target& target = targets[k]; target.size > 0 || k == 0) {
                const double w = target.size / sum;
                add_row(arm, target.at, weight * w);
                lattice += w * w / target.fraction;
                other += k == 0 ? (1 - w) * (1 - w) : w * w; // as of whole cells: slivers would take no flux
            }
        double within = 0, apart = 0; // int F^2 dr / r of the same two
        for (const auto& [start, end] : {std::pair(0.0, mouth.radius), std::pair(mouth.radius, mouth.room)})
            for (int g = 0; g < FivePoints::points && end > start; ++g) {
                const double r = start + rule.node[g] * (end - start), dr = rule.weight[g] * (end - start);
                const auto share_of = [&](const Target& target) { return target.cell.area(r) / target.cell.area(2 * reach); };
                double share = 0;
                for (const Target& target : targets)
                    if (target.size > 0)
                        share += target.size / sum * share_of(target);
                const double difference = share - share_of(targets.front());
                within += dr * share * share / r;
                apart += dr * difference * difference / r;
            }
        const GapMouthSide& sector = mouth.sides[side];
        if (!(sector.angle > 0) || !(mouth.radius > 0))
            return;
        const double whole = outlet + (std::log(mouth.room / mouth.radius) + 0.25 - within) / sector.angle,
                     product = apart / sector.angle + node_excess * other;
        arm.resistance +=
            std::abs(weight) * part * (std::max(0.0, whole - node_excess * lattice) + (1 - mouth.share) * product);
    }

    static constexpr FivePoints rule{};

    /// A mouth's resistance over the square of the way between the places that it joins, in cells, below which it has none: example 01 on parts, two corners 1e-8
    /// cells beside each other.
    static constexpr double least_of_way = 0.1;

    /// Resistance of a cell's node in the grid's network over that of a source spread evenly over the cell: of the network (euler + 3/2 ln 2) / 2 pi, less
    /// the mean of ln 1/r between two points of a square.
    static constexpr double node_excess = (std::numbers::egamma + 1.5 * std::numbers::ln2 - 0.8050866) / (2 * std::numbers::pi);

    const Grid<D>& grid_;
    const GridPlanes<D> planes_;
    std::span<const Solid<D>> solids_;
    const Complex<D>& complex_;
    const Standoffs<D>& standoffs_;
    const PiecesOfParts<D> pieces_;
    const MovedNodes<D> moved_;
    std::vector<Image<D>> images_;
};

} // namespace

template <>
std::vector<MouthArm<2>> find_mouth_arms(const Grid<2>& grid, std::span<const Solid<2>> solids, const Complex<2>& complex,
                                         const Standoffs<2>& standoffs)
{
    return MouthArms<2>(grid, solids, complex, standoffs).find();
}
template <>
std::vector<MouthArm<3>> find_mouth_arms(const Grid<3>& grid, std::span<const Solid<3>> solids, const Complex<3>& complex,
                                         const Standoffs<3>& standoffs)
{
    return MouthArms<3>(grid, solids, complex, standoffs).find();
}

template <int D>
std::vector<std::pair<std::int32_t, Vec<D>>> moved_nodes(const Grid<D>& grid, const Complex<D>& complex)
{
    std::vector<std::pair<std::int32_t, Vec<D>>> nodes;
    const MovedNodes<D> moved(grid, complex, PiecesOfParts<D>(complex));
    for (const MovedNode<D>& m : moved.nodes())
        nodes.emplace_back(m.part, m.share * m.way);
    return nodes;
}
template std::vector<std::pair<std::int32_t, Vec<2>>> moved_nodes(const Grid<2>&, const Complex<2>&);
template std::vector<std::pair<std::int32_t, Vec<3>>> moved_nodes(const Grid<3>&, const Complex<3>&);

} // namespace gapflow
