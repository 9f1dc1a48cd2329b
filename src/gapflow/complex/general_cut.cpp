#include "gapflow/complex/general_cut.hpp"

#include "gapflow/complex/face_helpers.hpp"
#include "gapflow/complex/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <variant>

namespace gapflow {
namespace {

template <int D>
void fill_square_of_facets(const GridPlanes<D>& planes, const FacetCut<D>& facets, int d, const Index<D>& f, SquareSolid& solid)
{
    solid.section = nullptr;
    solid.inverse = solid.section_inside = false;
    solid.arcs.clear();
    const Vec<2> low(planes.place[u_axis<D>(d)][f[u_axis<D>(d)]], planes.place[v_axis<D>(d)][f[v_axis<D>(d)]]);
    for (int e = 0; e < 4; ++e) {
        solid.edges[e].clear();
        for (const EdgeCover& cover : facets.edge(edge_axis<D>(d, e), edge_start<D>(d, f, e)))
            solid.edges[e].push_back({low[e % 2] + cover.from, low[e % 2] + cover.to});
    }
    const FaceChains chains = facets.face(D == 3 ? d : 2, f);
    for (int k = 0; k < chains.size(); ++k) {
        const FacetChain chain = chains[k];
        SquareArc arc;
        const std::size_t n = chain.points.size();
        arc.from = low + chain.points[0];
        arc.to = low + chain.points[n - 1];
        if (!chain.closed()) {
            arc.start = {chain.first_edge, arc.from[chain.first_edge % 2]};
            arc.end = {chain.last_edge, arc.to[chain.last_edge % 2]};
        }
        for (std::size_t i = 0; i + 1 < n; ++i)
            arc.segments.push_back({low + chain.points[i], low + chain.points[i + 1], nullptr, chain.facets[i], false, false});
        solid.arcs.push_back(arc);
    }
}

/// Fills what a convex solid covers of a rectangle's edges, from the same numbers as Marking.
template <int D, class Kind>
void fill_square(const GridPlanes<D>& planes, const PlacedSolid<D>& placed, const Kind& kind, int d, const Index<D>& f,
                 const Section& section, SquareSolid& solid)
{
    std::array<bool, 4> covered;
    for (int c = 0; c < 4; ++c)
        covered[c] = kind.covers(place_of(planes, vertex_of_corner<D>(d, f, c)));
    bool any = covered[0] || covered[1] || covered[2] || covered[3];
    for (int e = 0; e < 4; ++e) {
        const int axis = edge_axis<D>(d, e);
        const Index<D> start = edge_start<D>(d, f, e);
        const double from = planes.place[axis][start[axis]], to = planes.place[axis][start[axis] + 1];
        const bool here = covered[e < 2 ? e : (e + 1) % 4], there = covered[e < 2 ? e + 1 : e]; // at its low and high end
        auto& list = solid.edges[e];
        list.clear();
        const Stretch line = kind.line(axis, place_of(planes, start));
        if (here && there) {
            if (!placed.inverse)
                list.push_back({from, to});
        } else if (here != there) {
            const double at = crossing(line, here, from, to);
            list.push_back(here != placed.inverse ? Stretch{from, at} : Stretch{at, to});
        } else if (crosses_twice(line, from, to)) {
            any = true;
            if (placed.inverse) {
                list.push_back({from, line.from});
                list.push_back({line.to, to});
            } else
                list.push_back(line);
        } else if (placed.inverse)
            list.push_back({from, to});
    }
    solid.inverse = placed.inverse;
    solid.section = &section;
    const Vec<2>& x = section.inside;
    solid.section_inside = !any && !section.empty() && section.closed && x[0] >= planes.place[u_axis<D>(d)][f[u_axis<D>(d)]] &&
                           x[0] <= planes.place[u_axis<D>(d)][f[u_axis<D>(d)] + 1] &&
                           x[1] >= planes.place[v_axis<D>(d)][f[v_axis<D>(d)]] &&
                           x[1] <= planes.place[v_axis<D>(d)][f[v_axis<D>(d)] + 1];
}

/// How the edges of each of a face's images divide a cell beside it.
std::vector<CellSectors> divided_cell(const Grid<3>& grid, const GridPlanes<3>& planes,
                                      const std::vector<PlacedSolid<3>>& solids, const std::vector<int>& images,
                                      const Index<3>& c)
{
    std::vector<CellSectors> sectors(images.size());
    if (!grid.in_domain(grid.wrapped(c)))
        return sectors;
    Vec<3> low, high;
    for (int axis = 0; axis < 3; ++axis) {
        low[axis] = planes.place_of(axis, c[axis]);
        high[axis] = planes.place_of(axis, c[axis] + 1);
    }
    for (std::size_t k = 0; k < images.size(); ++k)
        if (!solids[images[k]].sharp.empty())
            sectors[k] = cell_sectors(solids[images[k]].sharp, c, low, high);
    return sectors;
}

/// The corner of a section between two surfaces of its solid that lies next to x; x itself where there is none.
Vec<2> section_corner(const Section& section, int a, int b, const Vec<2>& x)
{
    Vec<2> nearest = x;
    double least = std::numeric_limits<double>::infinity();
    for (int m = 0; m < section.count; ++m) {
        const int s = section.curve[m].surface, t = section.curve[(m + section.count - 1) % section.count].surface;
        if (const double distance = (section.corner[m] - x).squaredNorm();
            ((s == a && t == b) || (t == a && s == b)) && distance < least) {
            least = distance;
            nearest = section.corner[m];
        }
    }
    return nearest;
}

/// The same of a mesh's border.
Vec<2> section_corner(const SquareSolid& solid, const SharpSolid& sharp, int a, int b, const Vec<2>& x)
{
    Vec<2> nearest = x;
    double least = std::numeric_limits<double>::infinity();
    const auto offer = [&](const ArcSegment& in, const ArcSegment& out) {
        const int s = sharp.facet_of[in.surface], t = sharp.facet_of[out.surface];
        if (const double distance = (in.to - x).squaredNorm(); ((s == a && t == b) || (t == a && s == b)) && distance < least) {
            least = distance;
            nearest = in.to;
        }
    };
    for (const SquareArc& arc : solid.arcs) {
        const std::size_t n = arc.segments.size();
        for (std::size_t k = 0; k + 1 < n; ++k)
            offer(arc.segments[k], arc.segments[k + 1]);
        if (arc.start.edge < 0)
            offer(arc.segments[n - 1], arc.segments[0]);
    }
    return nearest;
}

/// Moves x onto a border of the rectangle, to the last bit.
void put_on_border(const Square& square, const OnEdge& place, Vec<2>& x)
{
    if (place.edge < 0)
        return;
    x[place.edge % 2] = place.at;
    x[1 - place.edge % 2] =
        place.edge == 1 || place.edge == 2 ? square.high[1 - place.edge % 2] : square.low[1 - place.edge % 2];
}
OnEdge border_at(const Square& square, int edge, const Vec<2>& x)
{
    if (edge < 0)
        return {};
    return {edge, std::clamp(x[edge % 2], square.low[edge % 2], square.high[edge % 2])};
}

using DividedCells = std::array<std::vector<CellSectors>, 2>; ///< below and above a face, of each of its images

bool lies_on(const SquareLine& line, const SquareLine& other)
{
    const Vec<2> way = other.to - other.from;
    if (!((line.to - line.from).norm() > parameters.joint_distance))
        return false;
    const auto on = [&](const Vec<2>& x) {
        const double t = std::clamp((x - other.from).dot(way) / way.squaredNorm(), 0.0, 1.0);
        return (other.from + t * way - x).norm() < parameters.joint_distance;
    };
    return on(line.from) && on(line.to);
}

/// Onto the end within the rectangle of another line of the same solid, if there is one.
void move_to_end(const Square& square, int solid, Vec<2>& x)
{
    for (const SquareLine& line : square.lines)
        if (line.solid == solid)
            for (const auto& [end, border] : {std::pair{line.from, line.from_border}, {line.to, line.to_border}})
                if (border.edge < 0 && (end - x).norm() < parameters.joint_distance) {
                    x = end;
                    return;
                }
}

void add_edge_lines(const SharpSolid& sharp, const DividedCells& cells, int image, int k, const Section& section, int d,
                    double at, Square& square, std::vector<FaceLine>& face_lines)
{
    InlineVector<int, 4> in_cells; // edges that divide one of the cells or both
    for (const auto& cell : cells)
        for (const int e : cell[k].edges)
            if (std::find(in_cells.begin(), in_cells.end(), e) == in_cells.end())
                in_cells.push_back(e);
    std::sort(in_cells.begin(), in_cells.end());
    for (const int e : in_cells) {
        std::array<SectorLine, 2> line;
        for (int side = 0; side < 2; ++side) {
            const auto& edges = cells[side][k].edges;
            if (std::find(edges.begin(), edges.end(), e) != edges.end())
                line[side] = sector_line(sharp, cells[side][k], e, d, at, square.low, square.high);
        }
        if (line[0].empty() && line[1].empty())
            continue;
        // Its portions in one of the cells or in both.
        const SectorLine& any = line[0].empty() ? line[1] : line[0];
        InlineVector<double, 4> breaks;
        for (const SectorLine& l : line)
            if (!l.empty())
                for (const double t : {l.from, l.to})
                    if (std::find(breaks.begin(), breaks.end(), t) == breaks.end())
                        breaks.push_back(t);
        std::sort(breaks.begin(), breaks.end());
        const auto on_border = [&](int border, const Vec<2>& x) {
            const Vec<3> corner = in_space<3>(
                d, at, {border == 1 ? square.high[0] : square.low[0], border == 2 ? square.high[1] : square.low[1]});
            Vec<2> crossing = x;
            crossing[border % 2] = bisector_crossing(sharp, e, edge_axis<3>(d, border), corner);
            return border_at(square, border, crossing);
        };
        for (std::size_t j = 0; j + 1 < breaks.size(); ++j) {
            SquareLine portion{k, any.at(breaks[j]), any.at(breaks[j + 1]), {}, {}};
            int sides = 0;
            for (int side = 0; side < 2; ++side) {
                const SectorLine& l = line[side];
                if (l.empty() || l.from > breaks[j] || l.to < breaks[j + 1])
                    continue;
                sides |= 1 << side;
                if (l.from == breaks[j] && l.from_end == SectorLine::End::border)
                    portion.from_border = on_border(l.from_edge, portion.from);
                if (l.to == breaks[j + 1] && l.to_end == SectorLine::End::border)
                    portion.to_border = on_border(l.to_edge, portion.to);
                if (l.from == breaks[j] && l.from_end == SectorLine::End::corner)
                    portion.from =
                        sharp.facet_of.empty()
                            ? section_corner(section, sharp.edges[e].a, sharp.edges[e].b, portion.from)
                            : section_corner(square.solids[k], sharp, sharp.edges[e].a, sharp.edges[e].b, portion.from);
            }
            if (sides == 0)
                continue;
            put_on_border(square, portion.from_border, portion.from);
            put_on_border(square, portion.to_border, portion.to);
            for (const bool end : {false, true}) // planes of a mesh meet in one line to the rounding of its vertices only
                if ((end ? portion.to_border : portion.from_border).edge < 0)
                    move_to_end(square, k, end ? portion.to : portion.from);
            const auto same = std::find_if(square.lines.begin(), square.lines.end(), [&](const SquareLine& other) {
                return other.solid == k && (lies_on(portion, other) || lies_on(other, portion));
            });
            if (same == square.lines.end()) {
                square.lines.push_back(portion);
                face_lines.push_back({image, e, sides});
            } else // of two edges that meet in the face's plane, one in each cell
                face_lines[same - square.lines.begin()].sides |= sides;
        }
    }
}

/// Of edges near other walls: between the two.
void add_way_lines(const SharpSolid& sharp, const DividedCells& cells, int image, int k, const Section& section, int d,
                   double at, Square& square, std::vector<FaceLine>& face_lines)
{
    for (const EdgeWay& way : sharp.ways) {
        int sides = 0;
        for (int side = 0; side < 2; ++side) {
            const auto& ways = cells[side][k].ways;
            if (std::find(ways.begin(), ways.end(), way.edge) != ways.end())
                sides |= 1 << side;
        }
        if (sides == 0)
            continue;
        const SectorLine line = way_line(sharp, way, d, at, square.low, square.high);
        if (line.empty())
            continue;
        const SharpEdge& edge = sharp.edges[way.edge];
        SquareLine portion{k, line.at(line.from), line.at(line.to), {}, {}, true};
        for (const bool end : {false, true}) {
            Vec<2>& x = end ? portion.to : portion.from;
            const SectorLine::End kind = end ? line.to_end : line.from_end;
            OnEdge& border = end ? portion.to_border : portion.from_border;
            if (kind == SectorLine::End::border) {
                const int b = end ? line.to_edge : line.from_edge;
                Vec<2> crossing = x;
                crossing[b % 2] = bisector_crossing(
                    sharp, way.edge, edge_axis<3>(d, b),
                    in_space<3>(d, at, {b == 1 ? square.high[0] : square.low[0], b == 2 ? square.high[1] : square.low[1]}));
                border = border_at(square, b, crossing);
                put_on_border(square, border, x);
            } else if (kind == SectorLine::End::corner)
                x = sharp.facet_of.empty() ? section_corner(section, edge.a, edge.b, x)
                                           : section_corner(square.solids[k], sharp, edge.a, edge.b, x);
            if (border.edge < 0)
                move_to_end(square, k, x);
        }
        square.lines.push_back(portion);
        face_lines.push_back({image, way.edge, sides});
    }
}

void add_rim_lines(const SharpSolid& sharp, const DividedCells& cells, int image, int k, const Section& section, int d,
                   double at, Square& square, std::vector<FaceLine>& face_lines)
{
    constexpr int side_surface = 2;
    for (int r = 0; r < static_cast<int>(sharp.rims.size()); ++r) {
        int sides = 0;
        for (int side = 0; side < 2; ++side) {
            const auto& rims = cells[side][k].rims;
            if (std::find(rims.begin(), rims.end(), r) != rims.end())
                sides |= 1 << side;
        }
        if (sides == 0)
            continue;
        for (const RimLine& line : rim_lines(sharp.rims[r], d, at, square.low, square.high)) {
            SquareLine portion{k, line.from, line.to, border_at(square, line.from_edge, line.from),
                               border_at(square, line.to_edge, line.to)};
            if (line.from_edge < 0)
                portion.from = section_corner(section, r, side_surface, portion.from);
            put_on_border(square, portion.from_border, portion.from);
            put_on_border(square, portion.to_border, portion.to);
            square.lines.push_back(portion);
            face_lines.push_back({image, static_cast<int>(sharp.edges.size()) + r, sides});
        }
    }
}

void add_lines(const Grid<3>& grid, const GridPlanes<3>& planes, const std::vector<PlacedSolid<3>>& solids,
               const std::vector<int>& images, const std::vector<Section>& sections, int d, const Index<3>& f, Square& square,
               std::vector<FaceLine>& face_lines)
{
    if (std::all_of(images.begin(), images.end(), [&](int image) { return solids[image].sharp.empty(); }))
        return;
    const DividedCells cells{divided_cell(grid, planes, solids, images, f - step<3>(d)),
                             divided_cell(grid, planes, solids, images, f)};
    const double at = planes.place[d][f[d]];
    for (int k = 0; k < static_cast<int>(images.size()); ++k) {
        const SharpSolid& sharp = solids[images[k]].sharp;
        add_way_lines(sharp, cells, images[k], k, sections[k], d, at, square, face_lines);
        add_edge_lines(sharp, cells, images[k], k, sections[k], d, at, square, face_lines);
        add_rim_lines(sharp, cells, images[k], k, sections[k], d, at, square, face_lines);
    }
}

} // namespace

template <int D>
Square& GeneralCut<D>::cut(const CutFace<D>& face, const FaceDetail& detail,
                           const std::vector<std::optional<FacetCut<D>>>& facets)
{
    const Index<D> f = index_.index(face.id);
    const int d = face.axis, u = u_axis<D>(d), v = v_axis<D>(d);
    const double at = plane_of(planes_, d, f);
    square_.low = {planes_.place[u][f[u]], planes_.place[v][f[v]]};
    square_.high = {planes_.place[u][f[u] + 1], planes_.place[v][f[v] + 1]};
    square_.solids.resize(detail.images.size());
    sections_.resize(detail.images.size());
    for (std::size_t k = 0; k < detail.images.size(); ++k) {
        const PlacedSolid<D>& placed = solids_[detail.images[k]];
        std::visit(
            [&](const auto& kind) {
                if constexpr (!std::is_same_v<std::decay_t<decltype(kind)>, FacetKind<D>>) {
                    sections_[k] = kind.section(d, at);
                    fill_square<D>(planes_, placed, kind, d, f, sections_[k], square_.solids[k]);
                } else
                    fill_square_of_facets<D>(planes_, *facets[detail.images[k]], d, f, square_.solids[k]);
            },
            placed.kind);
    }
    square_.corners.clear();
    sharp_.clear();
    if constexpr (D == 2)
        for (std::size_t k = 0; k < detail.images.size(); ++k)
            for (const SharpCorner& corner : solids_[detail.images[k]].corners)
                if ((corner.at.array() > square_.low.array()).all() && (corner.at.array() < square_.high.array()).all() &&
                    corner.divides()) {
                    square_.corners.push_back({static_cast<int>(k), corner.at, corner.outward, corner.mouth >= 0});
                    sharp_.push_back(&corner);
                }
    square_.lines.clear();
    lines_.clear();
    if constexpr (D == 2)
        for (std::size_t k = 0; k < detail.images.size(); ++k)
            for (const LineInCell& line : solids_[detail.images[k]].lines)
                if (line.cell == f) {
                    square_.lines.push_back({static_cast<int>(k), line.from, line.to,
                                             border_at(square_, line.from_edge, line.from),
                                             border_at(square_, line.to_edge, line.to), true});
                    sharp_.push_back(&solids_[detail.images[k]].corners[line.corner]);
                }
    if constexpr (D == 3)
        add_lines(*faces_.grid, planes_, solids_, detail.images, sections_, d, f, square_, lines_);
    square_.cut();
    return square_;
}

template class GeneralCut<2>;
template class GeneralCut<3>;

} // namespace gapflow
