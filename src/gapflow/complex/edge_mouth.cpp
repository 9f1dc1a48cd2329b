#include "gapflow/complex/edge_mouth.hpp"

#include "gapflow/complex/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace gapflow {
namespace {

constexpr double spacing_along = 0.5; // cells between the places of an edge at which it looks for other walls
// In cells: edges that lie in front of each other's faces by less are one above the other. Which of two has the mouth would change within the ways over which
// forces on plates parallel to round-off are found (Step.DisplacedBodiesHaveTheEnergyOfTheirFlow: by 3 % of the energy).
constexpr double one_above_the_other = 2e-5;

/// Of a mesh: in one piece, and no two facets face each other across an edge.
bool convex(const FacetKind<3>& kind)
{
    const auto& elements = kind.surface->elements;
    const auto at = [&](int facet, int k) -> const Vec<3>& { return kind.vertices[elements[facet][k % 3]]; };
    const auto normal = [&](int f) { return (at(f, 1) - at(f, 0)).cross(at(f, 2) - at(f, 0)).normalized(); };
    std::vector<bool> found(elements.size());
    std::vector<int> stack(1, 0);
    std::size_t count = 1;
    found[0] = true;
    while (!stack.empty()) {
        const int f = stack.back();
        stack.pop_back();
        for (int k = 0; k < 3; ++k) {
            const int g = (*kind.links)[f][k];
            if (normal(f).cross(normal(g)).dot((at(f, k + 1) - at(f, k)).normalized()) < -parameters.parallel)
                return false;
            if (!found[g]) {
                found[g] = true;
                ++count;
                stack.push_back(g);
            }
        }
    }
    return count == elements.size();
}

/// Else the way from an edge to another wall might lead through the solid itself.
bool convex(const PlacedSolid<3>& solid)
{
    const auto* facets = std::get_if<FacetKind<3>>(&solid.kind);
    return solid.shape.shape().convex() || (facets && !solid.inverse && !solid.sharp.edges.empty() && convex(*facets));
}

/// Of a rim of facets: a cylinder's has the corner's law alone, too.
bool of_rim(const PlacedSolid<3>& solid, const SharpEdge& edge)
{
    return std::holds_alternative<FacetKind<3>>(solid.kind) && (edge.to - edge.from).norm() < spacing_along;
}

} // namespace

EdgeMouths::EdgeMouths(const GridPlanes<3>& planes, std::span<const Solid<3>> solids, std::vector<PlacedSolid<3>>& placed)
    : planes_(planes), placed_(placed), walls_(planes, solids, placed),
      sides_(std::any_of(solids.begin(), solids.end(), [](const Solid<3>& s) { return s.wall; }))
{
    for (int axis = 0; axis < 3; ++axis) {
        low_[axis] = planes.place[axis][planes.place[axis].first()] - 2;
        high_[axis] = planes.place[axis][planes.place[axis].last()] + 2;
    }
    for (const PlacedSolid<3>& solid : placed)
        convex_.push_back(convex(solid));
    for (int i = 0; i < static_cast<int>(placed.size()); ++i)
        for (int e = 0; e < static_cast<int>(placed[i].sharp.edges.size()); ++e)
            find_way(i, e);
    for (PlacedSolid<3>& solid : placed) {
        for (const EdgeWay& way : solid.sharp.ways)
            if (solid.sharp.edges[way.edge].leads() && way.axis < 0)
                add_cells(solid.sharp, way);
        solid.sharp.sort_by_cell();
    }
}

Vec<3> EdgeMouths::bisector(int image, int edge) const
{
    const SharpSolid& sharp = placed_[image].sharp;
    return (sharp.facets[sharp.edges[edge].a].normal + sharp.facets[sharp.edges[edge].b].normal).normalized();
}

/// The edge of a solid at a place, -1: none.
int EdgeMouths::edge_at(int image, const Vec<3>& x) const
{
    if (image < 0)
        return -1;
    const auto& edges = placed_[image].sharp.edges;
    for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
        const Vec<3> way = edges[e].to - edges[e].from;
        const double t = std::clamp(way.dot(x - edges[e].from) / way.squaredNorm(), 0.0, 1.0);
        if ((edges[e].from + t * way - x).norm() < parameters.joint_distance)
            return e;
    }
    return -1;
}

/// The edge of the other wall whose way back to this solid crosses the way to the foot, -1: none. Both lie in front of a face of the other solid, beside its edge.
int EdgeMouths::edge_across(int image, const Place& place, const Vec<3>& along) const
{
    if (place.wall.image < 0)
        return -1;
    const Vec<3> foot = planes_.in_cells(place.wall.nearest.x);
    const auto& edges = placed_[place.wall.image].sharp.edges;
    for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
        const Vec<3> way = edges[e].to - edges[e].from;
        const Vec<3> x = edges[e].from + std::clamp(way.dot(foot - edges[e].from) / way.squaredNorm(), 0.0, 1.0) * way;
        const Vec<3> out = x - foot, across = out - out.dot(along) * along;
        if (!(out.norm() < place.distance && across.norm() > std::abs(out.dot(along))))
            continue;
        const SurfacePoint<3> back = closest_point<3>(placed_[image].shape, planes_.in_world(x));
        const Vec<3> inside = place.at - planes_.in_cells(back.x);
        if (back.feature == Feature::face && inside.norm() < place.distance &&
            inside.dot(across) > one_above_the_other * across.norm())
            return e;
    }
    return -1;
}

/// How far an edge lies beyond the end of the wall that faces it from a place at its side: 0 where it is in front of one of the two facets that meet there.
double EdgeMouths::beyond(const Vec<3>& bisector, double angle, const Vec<3>& way)
{
    const double away = std::acos(std::clamp(bisector.dot(way) / way.norm(), -1.0, 1.0));
    return way.norm() * std::sin(std::clamp(0.5 * (std::numbers::pi - angle) - away, 0.0, 0.5 * std::numbers::pi));
}

EdgeMouths::Place EdgeMouths::place(int image, int number, double s) const
{
    const SharpEdge& edge = placed_[image].sharp.edges[number];
    const Vec<3> along = edge.along();
    Place place;
    place.at = edge.from + s * along;
    place.wall = walls_.nearest(image, place.at);
    if (!(place.wall.distance < MouthWalls<3>::turning_end))
        return place;
    const Vec<3> foot = planes_.in_cells(place.wall.nearest.x), way = foot - place.at, across = way - way.dot(along) * along;
    const double cosine = across.norm() / way.norm();
    if (!(cosine > parameters.parallel))
        return place;
    place.direction = across.normalized();
    place.distance = way.norm() / cosine;
    // Half a cell on along the edge the wall is farther by this.
    const double facing =
        share_up_to(0.5 * std::sqrt(std::max(0.0, 1 - cosine * cosine)) / cosine, parameters.gap_start, parameters.gap_end);
    place.share = facing * share_up_to(place.distance, parameters.mouth_start, parameters.gap_end);
    if (const int other = edge_at(place.wall.image, foot); other >= 0) { // two edges: one mouth
        const SurfacePoint<3> back = closest_point<3>(placed_[image].shape, place.wall.nearest.x);
        // Each other's, though not from the same place: between edges that are inclined to each other the way back is another one.
        const bool mutual = edge_at(image, planes_.in_cells(back.x)) == number;
        if (!mutual || std::pair(image, number) > std::pair(place.wall.image, other)) {
            place.own = 1 - place.share;
            place.lost = true;
            place.crossed = !mutual;
            if (!mutual) {
                const SharpEdge& across_edge = placed_[place.wall.image].sharp.edges[other];
                const double away = std::min(1.0, beyond(bisector(place.wall.image, other), across_edge.angle, -way));
                place.own = std::max(place.own, away * away * (3 - 2 * away));
            }
            return place;
        }
    } else if (const int across_way = edge_across(image, place, along);
               across_way >= 0 && std::pair(image, number) > std::pair(place.wall.image, across_way)) {
        place.own = 1 - place.share;
        place.lost = true;
        return place;
    }
    if (!(std::acos(std::clamp(place.direction.dot(bisector(image, number)), -1.0, 1.0)) <
          std::numbers::pi - 0.5 * edge.angle)) { // through the solid itself
        place.share = 0;
        return place;
    }
    place.turned = facing * share_up_to(place.distance, parameters.gap_end, MouthWalls<3>::turning_end);
    place.mouth = place.share > 0;
    place.own = 1 - place.share;
    return place;
}

bool EdgeMouths::covered(int image, const Vec<3>& x) const
{
    for (int i = 0; i < static_cast<int>(placed_.size()); ++i) {
        const PlacedSolid<3>& other = placed_[i];
        if (i != image &&
            (other.inverse || ((x.array() >= other.low.array()).all() && (x.array() <= other.high.array()).all())) &&
            !(closest_point<3>(other.shape, planes_.in_world(x)).distance > 0))
            return true;
    }
    return false;
}

double EdgeMouths::own(int image, int edge, double s) const
{
    return convex_[image] && !of_rim(placed_[image], placed_[image].sharp.edges[edge]) ? place(image, edge, s).own : 1.0;
}

void EdgeMouths::find_way(int image, int number)
{
    const SharpEdge& edge = placed_[image].sharp.edges[number];
    if (!convex_[image] || of_rim(placed_[image], edge))
        return;
    const double reach = MouthWalls<3>::turning_end;
    const Vec<3> low = edge.from.cwiseMin(edge.to).array() - reach, high = edge.from.cwiseMax(edge.to).array() + reach;
    bool near = sides_;
    for (int i = 0; i < static_cast<int>(placed_.size()) && !near; ++i)
        near = i != image && (placed_[i].inverse || ((placed_[i].low.array() <= high.array()).all() &&
                                                     (placed_[i].high.array() >= low.array()).all()));
    if (!near)
        return;
    const double length = (edge.to - edge.from).norm();
    const Vec<3> along = edge.along();
    double from = 0, to = length; // within the planes
    for (int axis = 0; axis < 3; ++axis)
        if (along[axis] != 0) {
            const double a = (low_[axis] - edge.from[axis]) / along[axis], b = (high_[axis] - edge.from[axis]) / along[axis];
            from = std::max(from, std::min(a, b));
            to = std::min(to, std::max(a, b));
        } else if (edge.from[axis] < low_[axis] || edge.from[axis] > high_[axis])
            return;
    // The same places whatever part of the edge is looked at.
    const int all = std::max(1, static_cast<int>(std::ceil(length / spacing_along))),
              first = std::max(0, static_cast<int>(std::floor(from / length * all))),
              last = std::min(all, static_cast<int>(std::ceil(to / length * all)));
    std::vector<double> at;
    std::vector<Place> places;
    for (int k = first; k <= last; ++k) {
        at.push_back(k * (length / all));
        if (covered(image, edge.from + at.back() * along))
            return; // solids that overlap have no gap there
        places.push_back(place(image, number, at.back()));
    }
    if (at.size() > 1) {
        add_crossings(image, number, at, places);
        add_way(image, number, at, places);
    }
}

/// Where an edge and that across the gap cross each other the mouth goes over from one to the other: a place more on each side of the crossing, so that their
/// planes end in one line across the gap.
void EdgeMouths::add_crossings(int image, int number, std::vector<double>& at, std::vector<Place>& places) const
{
    for (std::size_t k = 1; k < at.size(); ++k) {
        const bool first = places[k - 1].mouth && places[k].crossed, second = places[k].mouth && places[k - 1].crossed;
        if (!first && !second)
            continue;
        double in = first ? at[k - 1] : at[k], out = first ? at[k] : at[k - 1];
        Place inside = first ? places[k - 1] : places[k], outside = first ? places[k] : places[k - 1];
        while (std::abs(out - in) > parameters.joint_distance) {
            const double middle = 0.5 * (in + out);
            const Place there = place(image, number, middle);
            if (!there.mouth && !there.lost)
                break; // another law between the two
            (there.mouth ? in : out) = middle;
            (there.mouth ? inside : outside) = there;
        }
        if (std::abs(out - (first ? at[k] : at[k - 1])) < 2 * parameters.joint_distance)
            continue; // a corner
        const std::ptrdiff_t before = static_cast<std::ptrdiff_t>(k);
        at.insert(at.begin() + before, {first ? in : out, first ? out : in});
        places.insert(places.begin() + before, {first ? inside : outside, first ? outside : inside});
        k += 2;
    }
}

void EdgeMouths::add_way(int image, int number, const std::vector<double>& at, const std::vector<Place>& places)
{
    SharpSolid& sharp = placed_[image].sharp;
    SharpEdge& edge = sharp.edges[number];
    double turned = 0, own = 0;
    Vec<3> direction = Vec<3>::Zero();
    int first = -1, last = -1;
    for (int k = 0; k < static_cast<int>(places.size()); ++k) {
        turned = std::max(turned, places[k].turned);
        own = std::max(own, places[k].own);
        if (places[k].turned > 0)
            direction += places[k].turned * places[k].direction;
        if (places[k].mouth) {
            first = first < 0 ? k : first;
            last = k;
        }
    }
    EdgeWay way{number, static_cast<int>(ways_.size()), {}, {}, 10 * parameters.joint_distance};
    if (turned > 0 && direction.norm() > 0) {
        edge.outward = (1 - turned) * bisector(image, number) + turned * direction.normalized();
        for (double& x : edge.outward)
            x = std::abs(x) < parameters.joint_distance ? 0.0 : x; // round-off
        edge.outward.normalize();
    }
    if (first < 0) {
        if (std::all_of(places.begin(), places.end(), [](const Place& p) { return p.own == 1; }))
            return;
        edge.outward.setZero(); // another edge has the mouth
        edge.divides = own > 0;
    } else {
        for (int k = std::max(0, first - 1); k <= std::min<int>(last + 1, static_cast<int>(places.size()) - 1); ++k) {
            const double cosine = places[k].distance > 0 ? places[k].direction.dot(edge.outward) : 0.0;
            way.at.push_back(at[k]);
            way.length.push_back(std::min(places[k].distance > 0
                                              ? places[k].distance / std::max(cosine, parameters.least_facing)
                                              : MouthWalls<3>::turning_end,
                                          MouthWalls<3>::turning_end));
        }
        double bend = 0;
        for (std::size_t k = 1; k + 1 < way.at.size(); ++k)
            bend = std::max(bend, std::abs(way.length[k - 1] - 2 * way.length[k] + way.length[k + 1]));
        way.beyond += bend;
        for (int axis = 0; axis < 3; ++axis)
            if (const int plane = planes_.cell_of(axis, edge.from[axis]); edge.from[axis] == planes_.place_of(axis, plane) &&
                                                                          edge.to[axis] == edge.from[axis] &&
                                                                          edge.outward[axis] == 0) {
                way.axis = axis;
                way.plane = plane;
            }
    }
    edge.way = static_cast<int>(sharp.ways.size());
    sharp.ways.push_back(way);
    ways_.push_back({image, number});
}

void EdgeMouths::add_cells(SharpSolid& sharp, const EdgeWay& way) const
{
    const SharpEdge& edge = sharp.edges[way.edge];
    const Vec<3> along = edge.along();
    std::vector<EdgeCell> cells;
    for (std::size_t k = 0; k + 1 < way.at.size(); ++k) {
        EdgeWay piece = way;
        piece.at = {way.at[k], way.at[k + 1]};
        piece.length = {way.length[k], way.length[k + 1]};
        Vec<3> low = edge.from + way.at[k] * along, high = low;
        for (const int end : {0, 1})
            for (const double t : {0.0, piece.length[end]}) {
                const Vec<3> x = edge.from + piece.at[end] * along + t * edge.outward;
                low = low.cwiseMin(x);
                high = high.cwiseMax(x);
            }
        Index<3> from, to, c;
        for (int axis = 0; axis < 3; ++axis) {
            from[axis] = std::max(planes_.cell_of(axis, low[axis]), planes_.place[axis].first() - 1);
            to[axis] = std::min(planes_.cell_of(axis, high[axis]), planes_.place[axis].last());
        }
        for (c[2] = from[2]; c[2] <= to[2]; ++c[2])
            for (c[1] = from[1]; c[1] <= to[1]; ++c[1])
                for (c[0] = from[0]; c[0] <= to[0]; ++c[0]) {
                    Vec<3> a, b;
                    for (int axis = 0; axis < 3; ++axis) {
                        a[axis] = planes_.place_of(axis, c[axis]);
                        b[axis] = planes_.place_of(axis, c[axis] + 1);
                    }
                    if (way_in_cell(sharp, piece, a, b).area > parameters.least_area)
                        cells.push_back({c, way.edge});
                }
    }
    const auto key = [](const EdgeCell& e) { return std::tuple(e.cell[0], e.cell[1], e.cell[2]); };
    std::sort(cells.begin(), cells.end(), [&](const EdgeCell& x, const EdgeCell& y) { return key(x) < key(y); });
    cells.erase(std::unique(cells.begin(), cells.end(), [&](const EdgeCell& x, const EdgeCell& y) { return key(x) == key(y); }),
                cells.end());
    sharp.way_cells.insert(sharp.way_cells.end(), cells.begin(), cells.end());
}

GapMouth<3> EdgeMouths::section(int image, int number, const Place& place) const
{
    const SharpSolid& sharp = placed_[image].sharp;
    const SharpEdge& edge = sharp.edges[number];
    const double h = place.distance / std::max(place.direction.dot(edge.outward), parameters.least_facing);
    GapMouth<3> mouth{
        {placed_[image].solid, walls_.solid_of(place.wall)}, place.at, place.at + h * edge.outward, h, place.share, 1, 1, {}};
    mouth.across = sharp.across(number).normalized();
    walls_.find_room(image, place.wall, mouth);
    for (int side = 0; side < 2; ++side) {
        const Vec<3> along = (side == 0 ? 1 : -1) * mouth.across;
        mouth.sides[side] = walls_.side(image, place.wall, mouth.at, mouth.end, along, mouth.radius);
        for (const int wall : {0, 1}) {
            const PlacedShape<3>& shape = wall == 0 ? placed_[image].shape : walls_.shape_of(place.wall);
            const SurfacePoint<3> point = closest_point<3>(shape, planes_.in_world(0.5 * (mouth.at + mouth.end + along)));
            mouth.walls[side][wall] = {planes_.in_cells(point.x), point.normal};
        }
    }
    return mouth;
}

void EdgeMouths::add_to(Complex<3>& complex) const
{
    for (CornerLink<3>& link : complex.links) {
        if (link.mouth < 0)
            continue;
        const auto [image, number] = ways_[link.mouth];
        const SharpSolid& sharp = placed_[image].sharp;
        const SharpEdge& edge = sharp.edges[number];
        const Place here = place(image, number, edge.along().dot(link.at - edge.from));
        link.mouth = -1;
        if (link.covered > 0) // as stiff as the edge, or as any link is
            link.conductance = std::max(link.conductance, 1 / std::max(parameters.least_covered, here.own / link.conductance));
        if (!edge.leads())
            continue;
        if (!here.mouth) {
            if (!(link.covered > 0))
                link.conductance = link.open / parameters.least_covered;
            continue;
        }
        GapMouth<3> mouth = section(image, number, here);
        mouth.area = link.open;
        link.mouth = static_cast<int>(complex.mouths.size());
        complex.mouths.push_back(mouth);
    }
    for (int i = 0; i < static_cast<int>(placed_.size()); ++i)
        for (const EdgeWay& way : placed_[i].sharp.ways)
            if (way.axis >= 0 && placed_[i].sharp.edges[way.edge].leads())
                add_pieces(i, way, complex);
}

void EdgeMouths::add_pieces(int image, const EdgeWay& way, Complex<3>& complex) const
{
    const SharpSolid& sharp = placed_[image].sharp;
    const SharpEdge& edge = sharp.edges[way.edge];
    struct Candidate {
        std::int32_t face, piece;
        WayInCell in;
        double off; ///< of its centroid from the way
    };
    std::vector<Candidate> best; // one of each face
    for (std::size_t k = 0; k < complex.pieces.size(); ++k) {
        const FacePiece<3>& piece = complex.pieces[k];
        if (piece.axis != way.axis || !piece.low.exists() || !piece.high.exists() || !(piece.area > 0))
            continue;
        const Index<3> f = complex.index.index(piece.face);
        if (f[way.axis] != way.plane)
            continue;
        Vec<3> low, high;
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = planes_.place[axis][f[axis]];
            high[axis] = axis == way.axis ? low[axis] : planes_.place[axis][f[axis] + 1];
        }
        const WayInCell in = way_in_cell(sharp, way, low, high);
        if (!(in.area > parameters.least_area))
            continue;
        const double t = edge.outward.dot(piece.centroid - edge.from), length = way.length_at(in.at),
                     off = std::max({0.0, -t, t - length});
        const auto known = std::find_if(best.begin(), best.end(), [&](const Candidate& c) { return c.face == piece.face; });
        if (known == best.end())
            best.push_back({piece.face, static_cast<std::int32_t>(k), in, off});
        else if (off < known->off)
            *known = {piece.face, static_cast<std::int32_t>(k), in, off};
    }
    for (const Candidate& c : best) {
        const Place here = place(image, way.edge, c.in.at);
        if (!here.mouth)
            continue;
        GapMouth<3> mouth = section(image, way.edge, here);
        mouth.area = c.in.area;
        mouth.piece = c.piece;
        mouth.axis = way.axis;
        mouth.plane = way.plane;
        complex.mouths.push_back(mouth);
    }
}

} // namespace gapflow
