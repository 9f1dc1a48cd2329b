// Faces in space: polygons, with traces on the open stretches of their edges and at their vertices.
#include "gapflow/core/sort_unique.hpp"
#include "gapflow/viscous/form_builder.hpp"
#include "gapflow/viscous/plane_element.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace gapflow {
namespace {

using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Area, positive where the polygon runs counterclockwise seen from the plane's high side, and centroid in the plane's axes.
struct Flat {
    double area = 0;
    Vec<2> centroid = Vec<2>::Zero();
};

Vec<2> flat(int axis, const Vec<3>& x)
{
    return {x[(axis + 1) % 3], x[(axis + 2) % 3]};
}

Flat flat_of(int axis, const std::vector<Vec<3>>& points)
{
    Flat result;
    const Vec<2> about = flat(axis, points[0]);
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Vec<2> a = flat(axis, points[k]) - about, b = flat(axis, points[(k + 1) % points.size()]) - about;
        const double part = 0.5 * (a[0] * b[1] - a[1] * b[0]);
        result.area += part;
        result.centroid += part / 3 * (a + b);
    }
    result.centroid = result.area != 0 ? Vec<2>(about + result.centroid / result.area) : about;
    return result;
}

} // namespace

/// The polygon of a face piece in the borders of a part beside it: the nearest in that plane.
template <>
const PartFace<3>* FormBuilder<3>::polygon_of(const FacePiece<3>& piece) const
{
    for (const PartOrCell& side : {piece.high, piece.low}) {
        if (!side.is_part())
            continue;
        const Index<3> c = complex_.cell_of_part(side.number());
        const PartFace<3>* best = nullptr;
        double least = std::numeric_limits<double>::infinity();
        for (int k = first_border_[side.number()]; k < first_border_[side.number() + 1]; ++k) {
            const PartFace<3>& face = borders_[k];
            if (face.sides.empty())
                continue;
            const bool at_low = side.code == piece.high.code;
            const double plane = planes_.place[piece.axis][c[piece.axis] + !at_low];
            if (std::any_of(face.points.begin(), face.points.end(), [&](const Vec<3>& x) { return x[piece.axis] != plane; }))
                continue;
            const Flat of = flat_of(piece.axis, face.points);
            const double far =
                (of.centroid - flat(piece.axis, piece.centroid)).norm() + std::abs(std::abs(of.area) - piece.area);
            if (far < least) {
                least = far;
                best = &face;
            }
        }
        if (best)
            return best;
    }
    return nullptr;
}

/// Pieces that a dividing plane alone parts are one face.
template <>
void FormBuilder<3>::merge_pieces()
{
    first_border_.assign(complex_.parts() + 1, 0);
    for (const PartFace<3>& face : borders_)
        ++first_border_[face.part + 1];
    std::partial_sum(first_border_.begin(), first_border_.end(), first_border_.begin());
    std::vector<FormFace<3>>& faces = form_.faces;
    std::vector<FormFace<3>> merged;
    polygons_.clear();
    std::map<std::tuple<int, std::int32_t, std::int32_t, std::int32_t>, std::int32_t> divided;
    std::vector<int> pieces;
    for (std::size_t k = 0; k < complex_.pieces.size(); ++k) {
        std::int32_t& number = face_of_piece_[k];
        if (number < 0)
            continue;
        const FormFace<3>& face = faces[number];
        const PartFace<3>* polygon = polygon_of(complex_.pieces[k]);
        const bool is_divided = polygon && std::ranges::find(polygon->sides, PartFace<3>::dividing) != polygon->sides.end();
        std::int32_t at = static_cast<std::int32_t>(merged.size());
        if (is_divided)
            at = divided.emplace(std::make_tuple(int(face.axis), face.face, face.low, face.high), at).first->second;
        if (at == static_cast<std::int32_t>(merged.size())) {
            merged.push_back(face);
            polygons_.push_back({});
            pieces.push_back(0);
        } else {
            FormFace<3>& whole = merged[at];
            whole.centroid = (whole.area * whole.centroid + face.area * face.centroid) / (whole.area + face.area);
            whole.area += face.area;
        }
        if (polygon)
            polygons_[at].push_back(polygon);
        ++pieces[at];
        number = at;
    }
    for (std::int32_t& number : face_of_piece_)
        if (number >= 0 && pieces[number] > 1)
            number = -1;
    faces = std::move(merged);
}

template <>
std::int32_t FormBuilder<3>::stretch_of(int axis, const Index<3>& edge, double from, double to)
{
    std::vector<std::int32_t>& list = stretches_at_[{axis, number(edge)}];
    for (const std::int32_t k : list)
        if (std::abs(stretches_[k].from - from) + std::abs(stretches_[k].to - to) < viscous_parameters.same_place)
            return k;
    list.push_back(static_cast<std::int32_t>(stretches_.size()));
    stretches_.push_back({static_cast<std::int8_t>(axis), number(edge), from, to});
    return list.back();
}

/// An open side of a polygon: on which edge, and what its ends are.
template <>
BorderSegment<3> FormBuilder<3>::open_segment(const FormFace<3>& face, const Vec<3>& from, const Vec<3>& to)
{
    const Index<3> f = index_.index(face.face);
    const int u = (face.axis + 1) % 3, v = (face.axis + 2) % 3,
              along = std::abs(to[u] - from[u]) > std::abs(to[v] - from[v]) ? u : v, across = u + v - along;
    Index<3> edge = f;
    edge[across] += std::abs(from[across] - planes_.place[across][f[across]]) >
                    std::abs(from[across] - planes_.place[across][f[across] + 1]);
    BorderSegment<3> segment;
    segment.from.at = from;
    segment.to.at = to;
    for (BorderPoint<3>* point : {&segment.from, &segment.to})
        for (int end = 0; end < 2; ++end)
            if (std::abs(point->at[along] - planes_.place[along][f[along] + end]) < viscous_parameters.same_place)
                point->vertex = number(Index<3>(edge + end * step<3>(along)));
    segment.stretch = stretch_of(along, edge, std::min(from[along], to[along]), std::max(from[along], to[along]));
    return segment;
}

/// Segments of a whole face.
template <>
std::vector<BorderSegment<3>> FormBuilder<3>::square_of(const FormFace<3>& face)
{
    const Index<3> f = index_.index(face.face);
    const int u = (face.axis + 1) % 3, v = (face.axis + 2) % 3;
    std::array<Vec<3>, 4> corner;
    for (int k = 0; k < 4; ++k)
        corner[k] = vertex_place(Index<3>(f + (k == 1 || k == 2) * step<3>(u) + (k >= 2) * step<3>(v)));
    std::vector<BorderSegment<3>> segments;
    for (int k = 0; k < 4; ++k)
        segments.push_back(open_segment(face, corner[k], corner[(k + 1) % 4]));
    return segments;
}

template <>
void FormBuilder<3>::find_borders()
{
    const auto same = [](const Vec<3>& a, const Vec<3>& b) {
        return (a - b).cwiseAbs().maxCoeff() < viscous_parameters.same_place;
    };
    first_segment_.assign(form_.faces.size() + 1, 0);
    polygons_.resize(form_.faces.size());
    for (std::size_t k = 0; k < form_.faces.size(); ++k) {
        const FormFace<3>& face = form_.faces[k];
        const std::size_t begin = segments_.size();
        for (const PartFace<3>* polygon : polygons_[k]) {
            const bool reversed = flat_of(face.axis, polygon->points).area < 0;
            const std::size_t n = polygon->points.size();
            for (std::size_t p = 0; p < n; ++p) {
                const std::int32_t solid = polygon->sides[p];
                Vec<3> from = polygon->points[p], to = polygon->points[(p + 1) % n];
                if (reversed)
                    std::swap(from, to);
                if (solid == PartFace<3>::dividing || from == to)
                    continue;
                if (solid == PartFace<3>::open)
                    segments_.push_back(open_segment(face, from, to));
                else {
                    const Vec<3> middle = on_curve(from, to, solid, face.axis);
                    segments_.push_back({{from, -1, solid}, {middle, -1, solid}, -1});
                    segments_.push_back({{middle, -1, solid}, {to, -1, solid}, -1});
                }
            }
        }
        join_stretches(begin, face);
        for (std::size_t a = begin; a < segments_.size(); ++a) // where a wall ends its velocity is known
            if (segments_[a].stretch >= 0)
                for (std::size_t b = begin; b < segments_.size(); ++b)
                    if (segments_[b].stretch < 0)
                        for (BorderPoint<3>* point : {&segments_[a].from, &segments_[a].to})
                            for (const BorderPoint<3>* wall : {&segments_[b].from, &segments_[b].to})
                                if (same(point->at, wall->at))
                                    point->solid = wall->solid;
        first_segment_[k + 1] = static_cast<std::int32_t>(segments_.size());
    }
}

/// Open segments of an edge that a dividing plane alone parts.
template <>
void FormBuilder<3>::join_stretches(std::size_t begin, const FormFace<3>& face)
{
    if (polygons_[&face - form_.faces.data()].size() < 2)
        return;
    for (std::size_t a = begin; a < segments_.size(); ++a)
        for (std::size_t b = begin; b < segments_.size(); ++b)
            if (a != b && segments_[a].stretch >= 0 && segments_[b].stretch >= 0 && segments_[a].to.vertex < 0 &&
                (segments_[a].to.at - segments_[b].from.at).cwiseAbs().maxCoeff() < viscous_parameters.same_place &&
                (segments_[a].to.at - segments_[a].from.at).normalized().dot(segments_[b].to.at - segments_[b].from.at) > 0) {
                segments_[a] = open_segment(face, segments_[a].from.at, segments_[b].to.at);
                segments_.erase(segments_.begin() + static_cast<std::ptrdiff_t>(b));
                return join_stretches(begin, face);
            }
}

template <>
Row FormBuilder<3>::of_vertex(std::int32_t vertex, int component)
{
    const Index<3> v = index_.index(vertex);
    if (on_closed_side(v))
        return of_sides(v, component);
    Row row;
    row.add(vertex_column(vertex, component), 1);
    return row;
}

template <>
Row FormBuilder<3>::of_stretch(std::int32_t number, int component)
{
    const EdgeStretch stretch = stretches_[number];
    const Index<3> e = index_.index(stretch.edge);
    const PlanePlaces& places = planes_.place[stretch.axis];
    Row row;
    if (std::abs(stretch.from - places[e[stretch.axis]]) + std::abs(stretch.to - places[e[stretch.axis] + 1]) <
        viscous_parameters.same_place) {
        const std::int32_t column = edge_column(stretch.axis, stretch.edge, component);
        if (column >= first_derived)
            return derived_[column - first_derived];
        row.add(column, 1);
        return row;
    }
    const int across = 3 - component - stretch.axis;
    if (is_closed_side(across, e[across]))
        return of_side(across, e[across], component);
    if (is_compact_edge(e, component, across))
        return between(component, across, e);
    const auto [at, is_new] = stretch_trace_.emplace(std::make_pair(number, component), 0);
    if (is_new) {
        Vec<3> middle = vertex_place(e);
        middle[stretch.axis] = 0.5 * (stretch.from + stretch.to);
        at->second = new_trace(component, middle, stretch.axis, stretch.to - stretch.from);
    }
    row.add(at->second, 1);
    return row;
}

template <>
void FormBuilder<3>::add_face(std::int32_t number)
{
    if (add_whole_face(number))
        return;
    const FormFace<3>& face = form_.faces[number];
    const std::vector<BorderSegment<3>> segments =
        face.whole ? square_of(face)
                   : std::vector<BorderSegment<3>>(segments_.begin() + first_segment_[number],
                                                   segments_.begin() + first_segment_[number + 1]);
    if (segments.empty())
        return;
    std::vector<ElementSide> sides;
    std::vector<Row> values;
    for (const BorderSegment<3>& segment : segments) {
        sides.push_back({flat(face.axis, segment.from.at), flat(face.axis, segment.to.at)});
        const Row from = of_point(segment.from, face.axis), to = of_point(segment.to, face.axis);
        Row middle;
        if (segment.stretch < 0)
            middle = of_solid(segment.from.solid, 0.5 * (segment.from.at + segment.to.at), face.axis);
        else {
            middle.add(of_stretch(segment.stretch, face.axis), 1.5);
            middle.add(from, -0.25);
            middle.add(to, -0.25);
        }
        values.push_back(from);
        values.push_back(middle);
        values.push_back(to);
    }
    values.push_back(velocity(number));
    std::vector<std::int32_t> columns;
    for (const Row& value : values)
        for (const Term& term : value.terms())
            columns.push_back(term.column);
    sort_unique(columns);
    for (const std::int32_t column : columns)
        if (column >= form_.velocities())
            trace_face_.emplace_back(column, number);
    RowMatrix by_columns = RowMatrix::Zero(static_cast<Eigen::Index>(values.size()), static_cast<Eigen::Index>(columns.size()));
    for (std::size_t k = 0; k < values.size(); ++k)
        for (const Term& term : values[k].terms())
            by_columns(static_cast<Eigen::Index>(k),
                       std::lower_bound(columns.begin(), columns.end(), term.column) - columns.begin()) += term.factor;
    const PlaneElement element = plane_element(sides);
    const RowMatrix rows = element.rows * by_columns, moments = element.moment * by_columns;
    const auto row_of = [&](const RowMatrix& matrix, Eigen::Index k) {
        return std::span<const double>(matrix.row(k).data(), columns.size());
    };
    const std::int64_t first = form_.squares.rows();
    for (Eigen::Index k = 0; k < rows.rows(); ++k)
        form_.squares.add((1 - face.gap) * face.length * element.weight[k], columns, row_of(rows, k));
    form_.elements.push_back({number, first, form_.squares.rows()});
    for (int k = 0; k < 2; ++k) {
        Row moment;
        for (std::size_t c = 0; c < columns.size(); ++c)
            if (moments(k, static_cast<Eigen::Index>(c)) != 0)
                moment.add(columns[c], moments(k, static_cast<Eigen::Index>(c)));
        Row& of_face = moment_[number][(face.axis + 1 + k) % 3];
        if (!moment.empty())
            of_face.add(derive(std::move(moment)), 1); // both cells' rows are short by it
    }
    form_.faces[number].polygon_area = element.area;
    form_.faces[number].polygon_centroid = face.centroid;
    for (int k = 0; k < 2; ++k)
        form_.faces[number].polygon_centroid[(face.axis + 1 + k) % 3] = element.centroid[k];
}

} // namespace gapflow
