// Whole faces in space: between cells of the grid's width they share one element, and whole cells with six of them the rows along the components. What their traces are
// that closed sides or the compact lattice give are columns of their own.
#include "gapflow/viscous/form_builder.hpp"

#include <cmath>

namespace gapflow {

template <int D>
std::int32_t FormBuilder<D>::derive(Row row)
{
    derived_.push_back(std::move(row));
    return first_derived + static_cast<std::int32_t>(derived_.size()) - 1;
}

template <int D>
Row FormBuilder<D>::moment_of(std::int32_t face, int axis) const
{
    if (whole_element_[face] < 0)
        return moment_[face][axis];
    Row row;
    row.add(first_moment + 2 * whole_element_[face] + (axis - form_.faces[face].axis + D) % D - 1, 1);
    return row;
}

template <int D>
bool FormBuilder<D>::is_compact_edge(const Index<D>& edge, int component, int across) const
{
    for (int side = 0; side < 2; ++side) {
        const Index<D> f = index_.wrapped(Index<D>(edge - side * step<D>(across)));
        Index<D> cell = f;
        cell[component] = std::min(f[component], index_.high()[component] - 1);
        const std::int32_t face = index_.holds(cell) ? whole_face_[component][index_(f)] : -1;
        if (face >= 0 && form_.faces[face].compact)
            return true;
    }
    return false;
}

template <>
std::int32_t FormBuilder<3>::vertex_column(std::int32_t vertex, int component)
{
    std::int32_t& column = vertex_trace_[component][vertex];
    if (column < 0) {
        const Index<3> v = index_.index(vertex);
        column = on_closed_side(v) ? derive(of_sides(v, component)) : new_trace(component, vertex_place(v));
    }
    return column;
}

template <>
std::int32_t FormBuilder<3>::edge_column(int axis, std::int32_t edge, int component)
{
    std::vector<std::int32_t>& columns = edge_column_[component][axis];
    if (columns.empty())
        columns.assign(index_.count, -1);
    std::int32_t& column = columns[edge];
    if (column >= 0)
        return column;
    const Index<3> e = index_.index(edge);
    const int across = 3 - component - axis;
    if (is_closed_side(across, e[across]))
        column = derive(of_side(across, e[across], component));
    else if (is_compact_edge(e, component, across))
        column = derive(between(component, across, e));
    else {
        Vec<3> middle = vertex_place(e);
        const double length = planes_.place[axis][e[axis] + 1] - planes_.place[axis][e[axis]];
        middle[axis] += 0.5 * length;
        column = new_trace(component, middle, axis, length);
    }
    return column;
}

/// Whether it shares the one element.
template <>
bool FormBuilder<3>::add_whole_face(std::int32_t number_of)
{
    constexpr double same = viscous_parameters.same_place;
    const FormFace<3>& face = form_.faces[number_of];
    const Index<3> f = index_.index(face.face);
    const int d = face.axis, u = (d + 1) % 3, v = (d + 2) % 3;
    const auto width = [&](int axis) { return planes_.place[axis][f[axis] + 1] - planes_.place[axis][f[axis]]; };
    if (!face.whole || std::abs(face.length - 1) > same || std::abs(face.area - 1) > same || std::abs(width(u) - 1) > same ||
        std::abs(width(v) - 1) > same)
        return false;
    const Index<3> at_u = f + step<3>(u), at_v = f + step<3>(v);
    const std::int32_t low = number(f), by_u = number(at_u), by_v = number(at_v), far = number(Index<3>(at_u + step<3>(v)));
    whole_element_[number_of] = form_.whole.count();
    form_.whole.columns.push_back({vertex_column(low, d), vertex_column(by_u, d), vertex_column(far, d), vertex_column(by_v, d),
                                   edge_column(u, low, d), edge_column(v, by_u, d), edge_column(u, by_v, d),
                                   edge_column(v, low, d), number_of});
    return true;
}

/// Rows of a whole cell between such faces: with the linear functions of one component and of all.
template <>
bool FormBuilder<3>::add_whole_along(std::int32_t cell)
{
    const std::span<const CellFace> faces = faces_of(cell);
    if (!form_.cells.whole[cell] || faces.size() != 6 || std::abs(shapes_[cell].volume - 1) > viscous_parameters.same_place)
        return false;
    std::array<std::array<std::int32_t, 2>, 3> at; // by axis and side
    for (auto& pair : at)
        pair.fill(-1);
    for (const CellFace& of : faces) {
        if (whole_element_[of.face] < 0)
            return false;
        at[form_.faces[of.face].axis][of.sign > 0] = of.face;
    }
    for (const auto& [low, high] : at)
        if (low < 0 || high < 0 || low == high)
            return false;
    constexpr double over_extent = 12;
    const auto moment = [&](int axis, int side, int turn) {
        return first_moment + 2 * whole_element_[at[axis][side]] + turn - 1;
    };
    for (int d = 0; d < 3; ++d) {
        form_.squares.add(1, {{at[d][0], -1}, {at[d][1], 1}});
        for (int turn = 1; turn < 3; ++turn)
            form_.squares.add(over_extent, {{moment(d, 0, turn), -1}, {moment(d, 1, turn), 1}});
        const int u = (d + 1) % 3, v = (d + 2) % 3; // whose turns to d are 2 and 1
        form_.squares.add(over_extent,
                          {{moment(u, 0, 2), -1}, {moment(u, 1, 2), 1}, {moment(v, 0, 1), -1}, {moment(v, 1, 1), 1}});
    }
    return true;
}

template std::int32_t FormBuilder<2>::derive(Row);
template std::int32_t FormBuilder<3>::derive(Row);
template Row FormBuilder<2>::moment_of(std::int32_t, int) const;
template Row FormBuilder<3>::moment_of(std::int32_t, int) const;
template bool FormBuilder<2>::is_compact_edge(const Index<2>&, int, int) const;
template bool FormBuilder<3>::is_compact_edge(const Index<3>&, int, int) const;

} // namespace gapflow
