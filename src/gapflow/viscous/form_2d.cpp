// Faces of the plane: lines, with a trace at each end.
//
//     E_f = int (du_d/dt)^2 dt,   u_d quadratic with the values v at the ends and the mean u:   [(v_1 - v_0)^2 + 12 (u - (v_0 + v_1)/2)^2]/L.
#include "gapflow/viscous/form_builder.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gapflow {
/// Pieces that a dividing line alone parts are one face.
template <>
void FormBuilder<2>::merge_pieces()
{
    std::vector<FormFace<2>>& faces = form_.faces;
    const auto from = [](const FormFace<2>& face) { return face.centroid[1 - face.axis] - 0.5 * face.area; };
    const auto key = [](const FormFace<2>& face) { return std::make_tuple(face.axis, face.face, face.low, face.high); };
    std::vector<std::int32_t> order(faces.size()), place(faces.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
        return std::make_pair(key(faces[a]), from(faces[a])) < std::make_pair(key(faces[b]), from(faces[b]));
    });
    std::vector<FormFace<2>> merged;
    std::vector<int> pieces; // of each
    for (const std::int32_t k : order) {
        const FormFace<2>& face = faces[k];
        if (!merged.empty() && key(merged.back()) == key(face) &&
            from(face) - from(merged.back()) < merged.back().area + viscous_parameters.same_place) {
            FormFace<2>& last = merged.back();
            const double begin = from(last), end = from(face) + face.area;
            last.area = end - begin;
            last.centroid[1 - last.axis] = 0.5 * (begin + end);
            ++pieces.back();
        } else {
            merged.push_back(face);
            pieces.push_back(1);
        }
        place[k] = static_cast<std::int32_t>(merged.size()) - 1;
    }
    for (std::int32_t& face : face_of_piece_)
        if (face >= 0)
            face = pieces[place[face]] == 1 ? place[face] : -1;
    faces = std::move(merged);
}

template <>
void FormBuilder<2>::find_borders()
{
    first_segment_.assign(form_.faces.size() + 1, 0);
    for (std::size_t k = 0; k < form_.faces.size(); ++k) {
        const FormFace<2>& face = form_.faces[k];
        const int along = 1 - face.axis;
        const Index<2> f = index_.index(face.face);
        BorderSegment<2> segment;
        for (int end = 0; end < 2; ++end) {
            BorderPoint<2>& point = end ? segment.to : segment.from;
            point.at = face.centroid;
            point.at[along] += (end - 0.5) * face.area;
            if (!face.whole)
                for (const std::int32_t cell : {face.low, face.high}) {
                    if (cell < 0)
                        continue;
                    Vec<2> x = point.at;
                    x[face.axis] = centroid_in({static_cast<std::int32_t>(k), cell == face.low ? 1 : -1}, cell)[face.axis];
                    for (const WallPiece<2>& wall : walls_of(cell))
                        for (const Vec<2>& y : wall.points)
                            if ((x - y).cwiseAbs().maxCoeff() < viscous_parameters.same_place) {
                                point.solid = wall.solid;
                                point.at = x;
                            }
                }
            if (point.solid >= 0)
                continue;
            for (int side = 0; side < 2; ++side) {
                const Index<2> v = f + side * step<2>(along);
                if (std::abs(planes_.place[along][v[along]] - point.at[along]) < viscous_parameters.same_place)
                    point.vertex = number(v);
            }
        }
        segments_.push_back(segment);
        first_segment_[k + 1] = static_cast<std::int32_t>(segments_.size());
    }
}

template <>
void FormBuilder<2>::add_vertex(std::int32_t vertex, int component, double factor, Terms& to)
{
    const Index<2> v = index_.index(vertex);
    if (on_closed_side(v))
        return add_sides(v, component, factor, to);
    const int across = 1 - component;
    if (is_compact_edge(v, component, across))
        return add_between(component, across, v, factor, to);
    std::int32_t& trace = vertex_trace_[component][vertex];
    if (trace < 0)
        trace = new_trace(component, vertex_place(v));
    to.push_back({trace, factor});
}

template <>
void FormBuilder<2>::add_face(std::int32_t number)
{
    const FormFace<2> face = form_.faces[number];
    const BorderSegment<2>& segment = segments_[first_segment_[number]];
    Terms low, difference, rest{{number, 1}};
    add_point(segment.from, face.axis, 1, low);
    add_point(segment.to, face.axis, 1, difference);
    for (const Terms* half : {&low, &difference})
        for (const Term& term : *half)
            rest.push_back({term.column, -0.5 * term.factor});
    for (const Term& term : low)
        difference.push_back({term.column, -term.factor});
    const double stiffness = (1 - face.gap) * face.length / face.area;
    add_row(stiffness, difference);
    add_row(12 * stiffness, rest);
    element_[number] = -2 - moment_.rows() / 2;
    for (int axis = 0; axis < 2; ++axis) {
        terms_.clear();
        for (const Term& term : difference)
            if (axis != face.axis)
                terms_.push_back({term.column, face.area * face.area / 12 * term.factor});
        add(terms_, moment_);
    }
}

} // namespace gapflow
