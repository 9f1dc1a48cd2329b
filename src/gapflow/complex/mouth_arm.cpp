#include "gapflow/complex/mouth_arm.hpp"

#include "gapflow/complex/gap_way.hpp"
#include "gapflow/complex/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gapflow {
namespace {

Vec<2> cell_centre(const GridPlanes<2>& planes, const Index<2>& c)
{
    return {planes.centre_of(0, c[0]), planes.centre_of(1, c[1])};
}

/// What of a piece lies in a mouth in its plane. The rest, if any, leads to a wall that lies in the plane to round-off.
double open_in(const GapMouth<2>& mouth, const FacePiece<2>& piece)
{
    const int along = 1 - piece.axis;
    const double from = std::min(mouth.at[along], mouth.end[along]), to = std::max(mouth.at[along], mouth.end[along]);
    return std::min(to, piece.centroid[along] + 0.5 * piece.area) - std::max(from, piece.centroid[along] - 0.5 * piece.area);
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

/// Pieces of faces beside the parts, and those in mouths. Of a complex with mouths; else empty.
class PiecesOfParts {
public:
    explicit PiecesOfParts(const Complex<2>& complex)
    {
        if (complex.mouths.empty())
            return;
        in_mouths_ = pieces_in_mouths(complex);
        first_.assign(complex.parts() + 1, 0);
        for (const bool count : {true, false}) {
            std::vector<int> next = first_;
            for (std::size_t k = 0; k < complex.pieces.size(); ++k)
                for (const PartOrCell& side : {complex.pieces[k].low, complex.pieces[k].high})
                    if (side.is_part() && complex.pieces[k].area > 0) {
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

/// How far a node of a part behind a mouth is moved.
struct MovedNode {
    std::int32_t part;
    Vec<2> way;   ///< from the cell's centre
    double share; ///< of it in the nodes of the gap's faces
};

/// Places of a gap's nodes are free, but none may lie beyond the gap's end: where the cell's centre is nearer to a mouth than the part's centroid, the node
/// lies there. Parts further behind a mouth keep theirs.
class MovedNodes {
public:
    MovedNodes(const Grid<2>& grid, const Complex<2>& complex, const PiecesOfParts& pieces) : planes_(grid), complex_(complex)
    {
        const auto behind = [&](const GapMouth<2>& mouth, int side, const PartOrCell& first) {
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
        for (const CornerLink<2>& link : complex.links)
            if (link.mouth >= 0) {
                behind(complex.mouths[link.mouth], 0, PartOrCell::part(link.a));
                behind(complex.mouths[link.mouth], 1, PartOrCell::part(link.b));
            }
        for (const auto& [piece, m] : pieces.in_mouths())
            for (const int side : {0, 1})
                behind(complex.mouths[m], side, sides_of(complex.mouths[m], complex.pieces[piece])[side]);
        std::sort(nodes_.begin(), nodes_.end(), [](const MovedNode& a, const MovedNode& b) {
            return a.part < b.part || (a.part == b.part && a.way.norm() * a.share > b.way.norm() * b.share);
        });
        nodes_.erase(
            std::unique(nodes_.begin(), nodes_.end(), [](const MovedNode& a, const MovedNode& b) { return a.part == b.part; }),
            nodes_.end());
    }

    const std::vector<MovedNode>& nodes() const { return nodes_; }
    Vec<2> way(const PartOrCell& part) const
    {
        const auto at = std::lower_bound(nodes_.begin(), nodes_.end(), part.code,
                                         [](const MovedNode& m, std::int32_t p) { return m.part < p; });
        return at != nodes_.end() && at->part == part.code ? at->way : Vec<2>(Vec<2>::Zero());
    }

private:
    /// Whether the part lies beside the mouth.
    bool add(const GapMouth<2>& mouth, int side, std::int32_t part)
    {
        const Vec<2> inward = (side == 0 ? 1 : -1) * left_of(mouth.end - mouth.at).normalized(),
                     &centroid = complex_.part_centroid[part];
        const double distance = inward.dot(centroid - 0.5 * (mouth.at + mouth.end)), x = 2 - distance / half_diagonal;
        if (!(distance > -half_diagonal && x > 0))
            return false;
        const double near = x < 1 ? x * x * (3 - 2 * x) : 1,
                     way = inward.dot(centroid - cell_centre(planes_, complex_.cell_of_part(part)));
        if (way > 0)
            nodes_.push_back({part, near * way * inward, mouth.share * mouth.sides[side].gap});
        return true;
    }

    static constexpr double half_diagonal = 0.5 * std::numbers::sqrt2; // a centroid is no further from the cell's centre

    const GridPlanes<2> planes_;
    const Complex<2>& complex_;
    std::vector<MovedNode> nodes_;
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

double area_in_circle(const Vec<2>& low, const Vec<2>& high, const Vec<2>& centre, double radius)
{
    const std::array<Vec<2>, 4> corner{low - centre, Vec<2>(high[0], low[1]) - centre, high - centre,
                                       Vec<2>(low[0], high[1]) - centre};
    double sum = 0;
    for (int k = 0; k < 4; ++k)
        sum += area_in_circle(corner[k], corner[(k + 1) % 4], radius);
    return std::max(sum, 0.0);
}

class MouthArms {
public:
    MouthArms(const Grid<2>& grid, std::span<const Solid<2>> solids, const Complex<2>& complex)
        : grid_(grid), planes_(grid), solids_(solids), complex_(complex), pieces_(complex), moved_(grid, complex, pieces_)
    {
        if (!complex.mouths.empty())
            images_ = images_at<2>(grid, planes_, complex.index, solids, 2 * grid.dx());
    }

    std::vector<MouthArm<2>> find()
    {
        std::vector<MouthArm<2>> arms;
        for (std::size_t k = 0; k < complex_.links.size(); ++k)
            if (const CornerLink<2>& link = complex_.links[k]; link.mouth >= 0) {
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
    static constexpr int T = twist_size<2>;

    int image_at(std::int32_t solid, const Vec<2>& x) const
    {
        int nearest = -1;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < images_.size(); ++k)
            if (images_[k].solid == solid)
                if (const double distance = std::abs(images_[k].shape.closest(planes_.in_world(x)).distance);
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

    MouthArm<2> through_piece(std::int32_t number, const GapMouth<2>& mouth)
    {
        const FacePiece<2>& piece = complex_.pieces[number];
        const double plain =
            (1 - mouth.share) * grid_.spread(piece.axis, complex_.index.index(piece.face)[piece.axis]) / piece.area;
        MouthArm<2> arm = through(mouth, sides_of(mouth, piece), open_in(mouth, piece), plain);
        arm.piece = number;
        add_motion(mouth, piece, arm);
        return arm;
    }

    /// A face that moves with the corner's solid: of a link the dividing line is part of the wall.
    void add_motion(const GapMouth<2>& mouth, const FacePiece<2>& piece, MouthArm<2>& arm) const
    {
        const int k = image_at(mouth.solid[0], 0.5 * (mouth.at + mouth.end));
        const Vec<2> reference = planes_.in_cells(solids_[images_[k].solid].centre + images_[k].shift);
        arm.carried.head<T>() = piece.area * speed_along<2>(unit<2>(piece.axis), piece.centroid, reference);
        const double delta = grid_.spread(piece.axis, complex_.index.index(piece.face)[piece.axis]);
        const PairMass<2> mass = delta / piece.area * arm.carried * arm.carried.transpose();
        arm.mass += mass;
        arm.motion += mass;
    }

    /// From one of two parts to the other; `rest`: resistance of the link or face without the mouth.
    MouthArm<2> through(const GapMouth<2>& mouth, const std::array<PartOrCell, 2>& parts, double open, double rest)
    {
        MouthArm<2> arm{
            -1, -1, mouth.solid, 0, PairTwist<2>::Zero(), PairMass<2>::Zero(), PairMass<2>::Zero(), PairTwist<2>::Zero(), {}};
        const double h = (mouth.end - mouth.at).norm(), part = mouth.length / open, radius = mouth.radius;
        const Vec<2> n = (mouth.end - mouth.at) / h, out = -left_of(n), middle = 0.5 * (mouth.at + mouth.end);
        const int first = image_at(mouth.solid[0], middle), second = image_at(mouth.solid[1], middle);
        if (first < 0 || second < 0)
            return arm;
        const auto reference = [&](int k) { return planes_.in_cells(solids_[images_[k].solid].centre + images_[k].shift); };
        const GapWalls<2> walls{{GapWall<2>(images_[first].shape, planes_), GapWall<2>(images_[second].shape, planes_)},
                                {reference(first), reference(second)}};
        const Eigen::Matrix<double, 2, 2 * T> frame = mean_motion<2>(walls, {n, -n}, middle);
        // The flux in the frame of the walls less that relative to the corner's solid.
        PairTwist<2> carried = -h * frame.transpose() * out;
        carried.head<T>() += h * speed_along<2>(out, middle, walls.reference[0]);
        for (int side = 0; side < 2; ++side) {
            const double share = mouth.share * mouth.sides[side].gap, sign = side == 0 ? 1 : -1;
            if (share > 0) {
                const Vec<2> at =
                    cell_centre(planes_, complex_.index.index(complex_.cell_of(parts[side]))) + moved_.way(parts[side]);
                const double way = std::max(0.0, -sign * out.dot(at - middle));
                GapWay<2> along(walls, middle, out, n, h, frame);
                for (const auto& point : along.points(side == 0 ? -way : 0.0, side == 0 ? 0.0 : way, 1.0, 0.0)) {
                    const double w = share * part * point.weight / point.thickness;
                    const PairTwist<2> flux = (carried + point.flux) / part;
                    arm.resistance += w;
                    arm.flux += w * flux;
                    arm.mass += w * flux * flux.transpose();
                }
                add_row(arm, parts[side], sign * share);
            }
            if (const double spread = mouth.share * (1 - mouth.sides[side].gap); spread > 0)
                spread_out(parts[side], middle, radius, sign * spread, mouth.sides[side].outlet, mouth.share, part, arm);
            if (mouth.share < 1)
                add_row(arm, parts[side], sign * (1 - mouth.share));
        }
        arm.resistance = std::max(arm.resistance, parameters.least_covered);
        arm.resistance += rest;
        Vec<2> way = Vec<2>::Zero();
        for (const auto& [row, weight] : arm.rows) {
            Vec<2> place = cell_centre(planes_, complex_.index.index(complex_.cell_of(row)));
            for (int axis = 0; axis < 2; ++axis)
                if (grid_.periodic(axis))
                    place[axis] -=
                        planes_.place[axis].period() * std::round((place[axis] - middle[axis]) / planes_.place[axis].period());
            way -= weight * place;
        }
        const PairTwist<2> own = arm.flux, uniform = frame.transpose() * way;
        arm.flux += uniform;
        const double g = 1 / arm.resistance;
        arm.motion = -g * (own * uniform.transpose() + uniform * own.transpose() + uniform * uniform.transpose());
        arm.mass -= g * arm.flux * arm.flux.transpose();
        for (int side = 0; side < 2; ++side) { // round-off of what moves no wall
            const PlacedShape<2>& shape = walls.wall(side).shape();
            if (solids_[mouth.solid[side]].wall)
                still(arm, side * T, T);
            else if (shape.shape().sphere_radius() &&
                     (planes_.in_cells(shape.to_world(Vec<2>::Zero())) - walls.reference[side]).norm() < place_unit)
                still(arm, side * T + 2, 1);
        }
        return arm;
    }

    /// No energy of some components of the twists.
    static void still(MouthArm<2>& arm, int first, int count)
    {
        arm.flux.segment(first, count).setZero();
        for (PairMass<2>* mass : {&arm.mass, &arm.motion}) {
            mass->middleRows(first, count).setZero();
            mass->middleCols(first, count).setZero();
        }
    }

    static void add_row(MouthArm<2>& arm, const PartOrCell& row, double weight)
    {
        for (auto& [other, sum] : arm.rows)
            if (other.code == row.code) {
                sum += weight;
                return;
            }
        arm.rows.emplace_back(row, weight);
    }

    /// Over what of the circle about the mouth is joined with a part within the circle. Where the mouth has a share only, the rest of the flux leaves into
    /// the part itself: of the energy of both together the product of the two is missing in the sum of their resistances, about the outlet's.
    void spread_out(const PartOrCell& from, const Vec<2>& centre, double radius, double weight, double outlet, double share,
                    double part, MouthArm<2>& arm)
    {
        struct Target {
            PartOrCell at;
            double fraction, size; ///< of the cell that is the part's; what of it lies in the circle
        };
        std::vector<Target> targets;
        const auto offer = [&](const PartOrCell& at) {
            if (!at.exists() ||
                std::any_of(targets.begin(), targets.end(), [&](const Target& t) { return t.at.code == at.code; }))
                return;
            const Index<2> c = complex_.index.index(complex_.cell_of(at));
            const Vec<2> low(planes_.place[0][c[0]], planes_.place[1][c[1]]),
                high(planes_.place[0][c[0] + 1], planes_.place[1][c[1] + 1]);
            Vec<2> nearest = centre; // of its images
            for (int axis = 0; axis < 2; ++axis)
                if (grid_.periodic(axis))
                    nearest[axis] += planes_.place[axis].period() *
                                     std::round((0.5 * (low + high)[axis] - centre[axis]) / planes_.place[axis].period());
            const double inside = area_in_circle(low, high, nearest, radius);
            if (inside > parameters.least_area || targets.empty()) {
                const double fraction = at.is_part() ? complex_.part_area[at.number()] / (high - low).prod() : 1.0;
                targets.push_back({at, fraction, inside * fraction});
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
                    const FacePiece<2>& piece = complex_.pieces[number];
                    offer(piece.low);
                    offer(piece.high);
                }
            if (complex_.is_main(at))
                for (int axis = 0; axis < 2; ++axis) {
                    const Index<2> c = complex_.index.index(complex_.cell_of(at));
                    for (const int end : {0, 1}) {
                        const Index<2> f = complex_.index.wrapped(Index<2>(c + end * step<2>(axis))),
                                       other = complex_.index.wrapped(Index<2>(c + (2 * end - 1) * step<2>(axis)));
                        if (complex_.index.holds(other) && complex_.main_area[axis][complex_.index(f)] > 0 &&
                            !face_in_mouth(axis, complex_.index(f)))
                            offer(complex_.main_of(complex_.index(other)));
                    }
                }
        }
        if (!(sum > 0)) {
            add_row(arm, from, weight);
            arm.resistance += std::abs(weight) * part * outlet;
            return;
        }
        double lattice = 0;
        for (const Target& target : targets)
            if (target.size > 0) {
                const double w = target.size / sum;
                add_row(arm, target.at, weight * w);
                lattice += w * w / target.fraction;
            }
        arm.resistance += std::abs(weight) * part * (std::max(0.0, outlet - node_excess * lattice) + (1 - share) * outlet);
    }

    /// Resistance of a cell's node in the grid's network over that of a source spread evenly over the cell: of the network (euler + 3/2 ln 2) / 2 pi, less
    /// the mean of ln 1/r between two points of a square.
    static constexpr double node_excess = (std::numbers::egamma + 1.5 * std::numbers::ln2 - 0.8050866) / (2 * std::numbers::pi);

    const Grid<2>& grid_;
    const GridPlanes<2> planes_;
    std::span<const Solid<2>> solids_;
    const Complex<2>& complex_;
    const PiecesOfParts pieces_;
    const MovedNodes moved_;
    std::vector<Image<2>> images_;
};

} // namespace

template <>
std::vector<MouthArm<2>> find_mouth_arms(const Grid<2>& grid, std::span<const Solid<2>> solids, const Complex<2>& complex)
{
    return MouthArms(grid, solids, complex).find();
}
template <>
std::vector<MouthArm<3>> find_mouth_arms(const Grid<3>&, std::span<const Solid<3>>, const Complex<3>&)
{
    return {};
}

template <>
std::vector<std::pair<std::int32_t, Vec<2>>> moved_nodes(const Grid<2>& grid, const Complex<2>& complex)
{
    std::vector<std::pair<std::int32_t, Vec<2>>> nodes;
    const MovedNodes moved(grid, complex, PiecesOfParts(complex));
    for (const MovedNode& m : moved.nodes())
        nodes.emplace_back(m.part, m.share * m.way);
    return nodes;
}
template <>
std::vector<std::pair<std::int32_t, Vec<3>>> moved_nodes(const Grid<3>&, const Complex<3>&)
{
    return {};
}

} // namespace gapflow
