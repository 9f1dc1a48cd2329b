// Faces in space: polygons, with traces on the open stretches of their edges and at their vertices.
#include "gapflow/viscous/form_builder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace gapflow {
namespace {

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
    std::vector<std::int32_t>& first = first_stretch_[axis];
    if (first.empty())
        first.assign(index_.count, -1);
    std::int32_t* at = &first[number(edge)];
    while (*at >= 0) {
        EdgeStretch& other = stretches_[*at];
        if (std::abs(other.from - from) + std::abs(other.to - to) < viscous_parameters.same_place)
            return *at;
        at = &other.next;
    }
    *at = static_cast<std::int32_t>(stretches_.size());
    stretches_.push_back({static_cast<std::int8_t>(axis), number(edge), from, to, -1});
    return static_cast<std::int32_t>(stretches_.size()) - 1;
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
    first_segment_.assign(pieces_ + 1, 0);
    for (std::int32_t k = 0; k < pieces_; ++k) {
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
void FormBuilder<3>::add_vertex(std::int32_t vertex, int component, double factor, Terms& to)
{
    const Index<3> v = index_.index(vertex);
    if (on_closed_side(v))
        add_sides(v, component, factor, to);
    else
        to.push_back({vertex_column(vertex, component), factor});
}

template <>
void FormBuilder<3>::add_stretch(std::int32_t number, int component, double factor, Terms& to)
{
    EdgeStretch& stretch = stretches_[number];
    const Index<3> e = index_.index(stretch.edge);
    const PlanePlaces& places = planes_.place[stretch.axis];
    if (std::abs(stretch.from - places[e[stretch.axis]]) + std::abs(stretch.to - places[e[stretch.axis] + 1]) <
        viscous_parameters.same_place) {
        const std::int32_t column = edge_column(stretch.axis, stretch.edge, component);
        if (column < first_derived)
            return to.push_back({column, factor});
        const RowList& derived = form_.derived;
        for (std::int64_t t = derived.end[column - first_derived]; t < derived.end[column - first_derived + 1]; ++t)
            to.push_back({derived.column[t], factor * derived.factor[t]});
        return;
    }
    const int across = 3 - component - stretch.axis;
    if (is_closed_side(across, e[across]))
        return add_side(across, e[across], component, factor, to);
    if (is_compact_edge(e, component, across))
        return add_between(component, across, e, factor, to);
    std::int32_t& trace = stretch.trace[component];
    if (trace < 0) {
        Vec<3> middle = vertex_place(e);
        middle[stretch.axis] = 0.5 * (stretch.from + stretch.to);
        trace = new_trace(component, middle, stretch.axis, stretch.to - stretch.from);
    }
    to.push_back({trace, factor});
}

template <>
void FormBuilder<3>::add_face(std::int32_t number)
{
    if (add_whole_face(number))
        return;
    const FormFace<3> face = form_.faces[number];
    const std::vector<BorderSegment<3>> square = face.whole ? square_of(face) : std::vector<BorderSegment<3>>();
    std::span<const BorderSegment<3>> segments = square;
    if (!face.whole)
        segments = std::span(segments_).subspan(first_segment_[number], first_segment_[number + 1] - first_segment_[number]);
    if (segments.empty())
        return;
    sides_.clear();
    columns_.clear();
    sparse_.clear();
    sparse_end_.assign(1, 0);
    const auto put = [&] { // a value's terms
        for (const Term& term : terms_)
            sparse_.emplace_back(slot_of(term.column), term.factor);
        sparse_end_.push_back(static_cast<std::int32_t>(sparse_.size()));
        terms_.clear();
    };
    terms_.clear();
    Terms middle, to;
    for (const BorderSegment<3>& segment : segments) {
        sides_.push_back({flat(face.axis, segment.from.at), flat(face.axis, segment.to.at)});
        add_point(segment.from, face.axis, 1, terms_);
        middle.clear();
        const auto take_quarter = [&] {
            for (const Term& term : terms_)
                middle.push_back({term.column, -0.25 * term.factor});
        };
        take_quarter();
        put();
        add_point(segment.to, face.axis, 1, terms_);
        take_quarter();
        std::swap(to, terms_);
        if (segment.stretch < 0) {
            middle.clear();
            add_solid(segment.from.solid, 0.5 * (segment.from.at + segment.to.at), face.axis, 1, middle);
        } else
            add_stretch(segment.stretch, face.axis, 1.5, middle);
        std::swap(middle, terms_);
        put();
        std::swap(to, terms_);
        put();
    }
    terms_.push_back({number, 1});
    put();
    for (const std::int32_t column : columns_)
        if (column >= form_.velocities())
            trace_face_.emplace_back(column, number);
    add_element(number);
}

/// Of the values that are gathered: three for each side, and the mean.
template <>
void FormBuilder<3>::add_element(std::int32_t number)
{
    FormFace<3>& face = form_.faces[number];
    PlaneProjection& of = projection_;
    of.find(sides_);
    const std::size_t n = columns_.size();
    const auto values_of = [&](std::size_t value) {
        return std::span(sparse_).subspan(sparse_end_[value], sparse_end_[value + 1] - sparse_end_[value]);
    };
    const double share = (1 - face.gap) * face.length;
    const std::int64_t first = form_.squares.rows();
    dense_.assign(7 * n, 0.0); // the projection's factors of the six monomials, and a row
    for (std::size_t value = 0; value < of.project.size(); ++value)
        for (const auto& [slot, factor] : values_of(value))
            for (int r = 0; r < 6; ++r)
                dense_[r * n + slot] += factor * of.project[value][r];
    const std::span<double> row = std::span(dense_).subspan(6 * n);
    if (!of.empty() && share != 0) {
        for (int r = 1; r < 6; ++r)
            add_row(share * of.energy[r], columns_, std::span(dense_).subspan(r * n, n));
        for (std::size_t side = 0; side < of.sides.size(); ++side)
            for (int mode = 0; mode < 3; ++mode) {
                const std::array<double, 3>& points = of.sides[side].row[mode];
                PlaneProjection::Monomials at{};
                for (int p = 0; p < 3; ++p)
                    for (int r = 0; r < 6; ++r)
                        at[r] += points[p] * of.at[3 * side + p][r];
                for (std::size_t c = 0; c < n; ++c)
                    row[c] = -(at[0] * dense_[c] + at[1] * dense_[n + c] + at[2] * dense_[2 * n + c] +
                               at[3] * dense_[3 * n + c] + at[4] * dense_[4 * n + c] + at[5] * dense_[5 * n + c]);
                for (int p = 0; p < 3; ++p)
                    for (const auto& [slot, factor] : values_of(3 * side + p))
                        row[slot] += points[p] * factor;
                add_row(share * of.sides[side].weight[mode], columns_, row);
            }
    }
    form_.elements.push_back({number, first, form_.squares.rows()});
    element_[number] = -2 - moment_.rows() / 3;
    std::array<std::int32_t, 3> moment{-1, -1, -1}; // both cells' rows are short by it
    for (int k = 0; k < 2 && !of.empty(); ++k) {
        terms_.clear();
        for (std::size_t c = 0; c < n; ++c) {
            double sum = 0;
            for (int r = 0; r < 6; ++r)
                sum += of.moment(k, r) * dense_[r * n + c];
            if (sum != 0)
                terms_.push_back({columns_[c], sum});
        }
        if (!terms_.empty())
            moment[(face.axis + 1 + k) % 3] = derive(terms_);
    }
    for (const std::int32_t column : moment) {
        const Term term{column, 1};
        add(std::span(&term, column >= 0 ? 1 : 0), moment_);
    }
    face.polygon_area = of.area;
    face.polygon_centroid = face.centroid;
    for (int k = 0; k < 2; ++k)
        face.polygon_centroid[(face.axis + 1 + k) % 3] = of.centroid[k];
}

} // namespace gapflow
