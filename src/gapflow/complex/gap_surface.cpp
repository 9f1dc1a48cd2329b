#include "gapflow/complex/gap_surface.hpp"

#include "gapflow/complex/gap_finder.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace gapflow {
namespace {

constexpr int root_steps = 40;  // of a place on an edge, by false position: 8 where walls are smooth
constexpr double close = 1e-12; // in cells: the root is found
constexpr int clip_steps = 30;  // halves, to where a wall ends

/// Corners and edges of a cell, by 2^D corners; the squares of its faces (2D: the cell itself), their corners one after the other.
template <int D>
struct CellSquares;
template <>
struct CellSquares<2> {
    static constexpr std::array<std::array<int, 4>, 1> square{{{0, 1, 3, 2}}};
};
template <>
struct CellSquares<3> {
    static constexpr std::array<std::array<int, 4>, 6> square{
        {{0, 2, 6, 4}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 5, 7, 6}}};
};

/// The surface of one pair of solids.
template <int D>
class SurfaceOfPair {
public:
    SurfaceOfPair(const Grid<D>& grid, const GridPlanes<D>& planes, std::array<std::int32_t, 2> solid)
        : grid_(grid), planes_(planes)
    {
        surface_.solid = solid;
    }

    /// The part of a cell that lies between walls as at a piece of its faces.
    void add(const Index<D>& cell, std::int32_t part, const GapSite<D>& site, const Vec<D>& piece)
    {
        walls_.emplace(site.walls);
        if (site.solid[0] != surface_.solid[0])
            walls_->swap();
        walls_->keep_faces(std::array<int, 2>{-1, -1});
        walls_->extend(false);
        part_ = part;
        cell_ = cell;
        set_image(piece);
        constexpr int corners = 1 << D;
        std::array<double, corners> f;
        for (int k = 0; k < corners; ++k)
            f[k] = difference(place(corner(k)));
        std::vector<std::pair<Edge, Edge>> segments;
        for (const auto& square : CellSquares<D>::square)
            add_segments(square, f, segments);
        if constexpr (D == 2)
            for (const auto& [from, to] : segments)
                add_element({point_on(from, f), point_on(to, f)});
        else
            for (const std::vector<Edge>& loop : loops_of(std::move(segments))) {
                std::vector<int> points;
                for (const Edge& edge : loop)
                    points.push_back(point_on(edge, f));
                for (std::size_t k = 2; k < points.size(); ++k)
                    add_element({points[0], points[k - 1], points[k]});
            }
    }

    GapSurface<D> take()
    {
        // Points that no element has are left out.
        GapSurface<D> result{surface_.solid, {}, {}, {}, {}};
        std::vector<int> number(surface_.points.size(), -1);
        for (typename GapSurface<D>::Element& element : surface_.elements) {
            for (int& k : element.points) {
                if (number[k] < 0) {
                    number[k] = static_cast<int>(result.points.size());
                    result.points.push_back(surface_.points[k]);
                    result.thickness.push_back(surface_.thickness[k]);
                    result.parts.push_back(std::move(surface_.parts[k]));
                }
                k = number[k];
            }
            result.elements.push_back(element);
        }
        return result;
    }

private:
    using Edge = std::pair<int, int>; ///< corners of the cell, the smaller one first

    Index<D> corner(int k) const
    {
        Index<D> at = cell_;
        for (int axis = 0; axis < D; ++axis)
            at[axis] += k >> axis & 1;
        return at;
    }
    /// Places of the cell are those at which the walls of the site lie: by whole periods beside its own.
    void set_image(const Vec<D>& piece)
    {
        shift_.setZero();
        for (int axis = 0; axis < D; ++axis)
            if (grid_.periodic(axis)) {
                const double period = planes_.place[axis].period(), centre = planes_.centre_of(axis, cell_[axis]);
                shift_[axis] = period * std::round((piece[axis] - centre) / period);
            }
    }
    Vec<D> place(const Index<D>& corner) const
    {
        Vec<D> x;
        for (int axis = 0; axis < D; ++axis)
            x[axis] = planes_.place_of(axis, corner[axis]) + shift_[axis];
        return x;
    }
    /// Of the distances from the two walls: 0 half-way between them.
    double difference(const Vec<D>& x) const
    {
        return walls_->wall(0).nearest(x).distance - walls_->wall(1).nearest(x).distance;
    }

    /// In a square the lines between the edges on which the difference changes its sign; of two pairs of them by the sign in the middle.
    void add_segments(const std::array<int, 4>& square, const std::array<double, 1 << D>& f,
                      std::vector<std::pair<Edge, Edge>>& segments) const
    {
        std::vector<Edge> edges;
        for (int k = 0; k < 4; ++k)
            if (const int a = square[k], b = square[(k + 1) % 4]; (f[a] >= 0) != (f[b] >= 0))
                edges.push_back(std::minmax(a, b));
        if (edges.size() == 2)
            segments.emplace_back(edges[0], edges[1]);
        else if (edges.size() == 4) {
            const double middle = difference(0.5 * (place(corner(square[0])) + place(corner(square[2]))));
            const bool first = (middle >= 0) == (f[square[0]] >= 0); // the first and third corner are on one side
            segments.emplace_back(edges[0], edges[first ? 1 : 3]);
            segments.emplace_back(edges[2], edges[first ? 3 : 1]);
        }
    }
    /// Closed lines of segments; each edge has two.
    static std::vector<std::vector<Edge>> loops_of(std::vector<std::pair<Edge, Edge>> segments)
    {
        std::vector<std::vector<Edge>> loops;
        while (!segments.empty()) {
            std::vector<Edge> loop{segments.back().first};
            Edge next = segments.back().second;
            segments.pop_back();
            while (next != loop.front()) {
                loop.push_back(next);
                const auto found = std::find_if(segments.begin(), segments.end(),
                                                [&](const auto& s) { return s.first == next || s.second == next; });
                if (found == segments.end())
                    break;
                next = found->first == next ? found->second : found->first;
                segments.erase(found);
            }
            loops.push_back(std::move(loop));
        }
        return loops;
    }

    /// Number of the point on an edge of the cell.
    int point_on(const Edge& edge, const std::array<double, 1 << D>& f)
    {
        const auto [found, is_new] = on_edge_.try_emplace(key_of(edge), static_cast<int>(surface_.points.size()));
        if (is_new) {
            const Vec<D> a = place(corner(edge.first)), b = place(corner(edge.second));
            double end[2] = {0, 1}, value[2] = {f[edge.first], f[edge.second]}, s = 0;
            for (int k = 0, last = -1; k < root_steps; ++k) { // neither end stands
                s = end[0] + value[0] / (value[0] - value[1]) * (end[1] - end[0]);
                const double here = difference(a + s * (b - a));
                if (std::abs(here) < close)
                    break;
                const int side = (here >= 0) == (f[edge.first] >= 0) ? 0 : 1;
                end[side] = s;
                value[side] = here;
                if (side == last)
                    value[1 - side] *= 0.5;
                last = side;
            }
            add_point(a + s * (b - a));
        }
        return found->second;
    }
    using Key = std::array<int, 2 * D>; ///< of an edge of the grid
    Key key_of(const Edge& edge) const
    {
        Key key;
        for (int axis = 0; axis < D; ++axis) {
            key[axis] = corner(edge.first)[axis];
            key[D + axis] = corner(edge.second)[axis];
        }
        return key;
    }

    /// Thickness of the gap at x along its normal, in cells; nothing where the walls do not face each other.
    std::optional<double> thickness_at(const Vec<D>& x) const
    {
        const WallPoint<D, double> a = walls_->wall(0).nearest(x), b = walls_->wall(1).nearest(x);
        if (!(a.normal.dot(b.normal) < -parameters.least_facing))
            return {};
        const auto found = walls_->profile(x, (a.normal - b.normal).normalized());
        return found ? std::optional(found->thickness) : std::nullopt;
    }
    int add_point(const Vec<D>& x)
    {
        const std::optional<double> thickness = thickness_at(x);
        surface_.points.push_back(planes_.in_world(x - shift_));
        surface_.thickness.push_back(thickness ? grid_.dx() * *thickness : 0);
        surface_.parts.emplace_back();
        faces_.push_back(thickness.has_value());
        return static_cast<int>(faces_.size()) - 1;
    }

    /// As much of an element as lies in the gap.
    void add_element(const std::array<int, D>& points)
    {
        std::vector<int> inside;
        for (int k = 0; k < D; ++k) {
            const int from = points[k], to = points[(k + 1) % D];
            if (faces_[from])
                inside.push_back(from);
            if (faces_[from] != faces_[to] && (D == 3 || k == 0))
                inside.push_back(clipped(faces_[from] ? from : to, faces_[from] ? to : from));
        }
        if constexpr (D == 2) {
            if (inside.size() == 2)
                put({inside[0], inside[1]});
        } else
            for (std::size_t k = 2; k < inside.size(); ++k)
                put({inside[0], inside[k - 1], inside[k]});
    }
    /// Half-way between the walls where they face each other, from a place near by.
    Vec<D> half_way(Vec<D> x) const
    {
        for (int pass = 0; pass < 2; ++pass) {
            const WallPoint<D, double> a = walls_->wall(0).nearest(x), b = walls_->wall(1).nearest(x);
            x += 0.5 * (b.distance - a.distance) * (a.normal - b.normal).normalized();
        }
        return x;
    }
    /// Where a wall ends between a point in the gap and one beyond.
    int clipped(int in, int out)
    {
        const auto [found, is_new] = at_end_.try_emplace(std::pair(in, out), 0);
        if (is_new) {
            Vec<D> a = planes_.in_cells(surface_.points[in]) + shift_, b = planes_.in_cells(surface_.points[out]) + shift_;
            for (int k = 0; k < clip_steps; ++k) { // along the surface
                const Vec<D> middle = half_way(0.5 * (a + b));
                (thickness_at(middle) ? a : b) = middle;
            }
            found->second = add_point(a);
        }
        return found->second;
    }
    void put(const std::array<int, D>& points)
    {
        typename GapSurface<D>::Element element{points, part_, Vec<D>::Zero(), 0};
        const Vec<D>&a = surface_.points[points[0]], &b = surface_.points[points[1]];
        Vec<D> normal;
        if constexpr (D == 2)
            normal = Vec<2>(a[1] - b[1], b[0] - a[0]);
        else
            normal = 0.5 * (b - a).cross(surface_.points[points[2]] - a);
        element.area = normal.norm();
        if (!(element.area > 0))
            return;
        Vec<D> middle = Vec<D>::Zero();
        for (const int k : points)
            middle += surface_.points[k] / D;
        const Vec<D> out = walls_->wall(0).nearest(planes_.in_cells(middle) + shift_).normal;
        element.normal = (normal.dot(out) < 0 ? -1 : 1) / element.area * normal;
        for (const int k : points)
            if (auto& parts = surface_.parts[k]; std::find(parts.begin(), parts.end(), part_) == parts.end())
                parts.push_back(part_);
        surface_.elements.push_back(element);
    }

    const Grid<D>& grid_;
    const GridPlanes<D>& planes_;
    GapSurface<D> surface_;
    std::vector<char> faces_; ///< whether the walls face each other at each point
    std::map<Key, int> on_edge_;
    std::map<std::pair<int, int>, int> at_end_;
    // Of the part that is added.
    std::optional<GapWalls<D>> walls_;
    std::int32_t part_ = 0;
    Index<D> cell_ = Index<D>::Zero();
    Vec<D> shift_ = Vec<D>::Zero();
};

} // namespace

template <int D>
std::vector<GapSurface<D>> gap_surfaces(const Grid<D>& grid, std::span<const Solid<D>> solids, const Complex<D>& complex,
                                        std::span<const GapArm<D>> arms)
{
    const GridPlanes<D> planes(grid);
    const GapFinder<D> finder(grid, solids, complex, Standoffs<D>{}, true);
    using Pair = std::pair<std::int32_t, std::int32_t>;
    std::map<Pair, std::map<std::int32_t, const GapArm<D>*>> parts; // of each pair, with the arm that has most of the gap
    for (const GapArm<D>& arm : arms) {
        const FacePiece<D>& piece = complex.pieces[arm.piece];
        if (!is_of_gap(arm))
            continue;
        for (const PartOrCell& side : {piece.low, piece.high})
            if (side.is_part() && grid.owns(complex.cell_of_part(side.number()))) {
                const GapArm<D>*& best = parts[std::minmax(arm.solid[0], arm.solid[1])][side.number()];
                if (!best || complex.pieces[best->piece].area < piece.area)
                    best = &arm;
            }
    }
    std::vector<GapSurface<D>> surfaces;
    for (const auto& [pair, of_pair] : parts) {
        SurfaceOfPair<D> surface(grid, planes, {pair.first, pair.second});
        for (const auto& [part, arm] : of_pair)
            if (const auto site = finder.site_at(arm->piece, arm))
                surface.add(complex.cell_of_part(part), part, *site, complex.pieces[arm->piece].centroid);
        if (GapSurface<D> found = surface.take(); !found.elements.empty())
            surfaces.push_back(std::move(found));
    }
    return surfaces;
}

template std::vector<GapSurface<2>> gap_surfaces(const Grid<2>&, std::span<const Solid<2>>, const Complex<2>&,
                                                 std::span<const GapArm<2>>);
template std::vector<GapSurface<3>> gap_surfaces(const Grid<3>&, std::span<const Solid<3>>, const Complex<3>&,
                                                 std::span<const GapArm<3>>);

} // namespace gapflow
