// Whole faces in space: between cells of the grid's width they share one element, and whole cells with six of them the rows along the components. What their traces are
// that closed sides or the compact lattice give are columns of their own.
#include "gapflow/viscous/form_builder.hpp"

#include <cmath>

namespace gapflow {

template <int D>
std::int32_t FormBuilder<D>::derive(Terms& row)
{
    merge(row);
    add(row, form_.derived);
    return first_derived + form_.derived.rows() - 1;
}

template <int D>
void FormBuilder<D>::add_moment(std::int32_t face, int axis, double factor, Terms& to) const
{
    const std::int32_t element = element_[face];
    if (element >= 0)
        to.push_back({first_moment + 2 * element + (axis - form_.faces[face].axis + D) % D - 1, factor});
    else if (element < -1) {
        const int row = D * (-2 - element) + axis;
        for (std::int64_t t = moment_.end[row]; t < moment_.end[row + 1]; ++t)
            to.push_back({moment_.column[t], factor * moment_.factor[t]});
    }
}

template <int D>
bool FormBuilder<D>::is_compact_edge(const Index<D>& edge, int component, int across) const
{
    const auto is_compact = [&](int id) {
        const std::int32_t face = whole_face_[component][id];
        return face >= 0 && compact_[face];
    };
    const int id = index_(edge);
    if (is_compact(id))
        return true;
    if (edge[across] > index_.low[across])
        return is_compact(id - index_.stride[across]);
    return index_.wraps[across] && is_compact(id + (index_.size[across] - 2) * index_.stride[across]);
}

template <>
std::int32_t FormBuilder<3>::new_vertex_column(std::int32_t vertex, int component)
{
    const Index<3> v = index_.index(vertex);
    if (!on_closed_side(v))
        return new_trace(component, vertex_place(v));
    Terms row;
    add_sides(v, component, 1, row);
    return derive(row);
}

template <>
std::int32_t FormBuilder<3>::new_edge_column(int axis, std::int32_t edge, int component)
{
    const Index<3> e = index_.index(edge);
    const int across = 3 - component - axis;
    Terms row;
    if (is_closed_side(across, e[across]))
        add_side(across, e[across], component, 1, row);
    else if (is_compact_edge(e, component, across))
        add_between(component, across, e, 1, row);
    else {
        Vec<3> middle = vertex_place(e);
        const double length = planes_.place[axis][e[axis] + 1] - planes_.place[axis][e[axis]];
        middle[axis] += 0.5 * length;
        return new_trace(component, middle, axis, length);
    }
    return derive(row);
}

/// Whether it shares the one element.
template <>
bool FormBuilder<3>::add_whole_face(std::int32_t number_of)
{
    constexpr double same = viscous_parameters.same_place;
    const FormFace<3>& face = form_.faces[number_of];
    if (!is_whole(number_of) || std::abs(face.length - 1) > same || std::abs(face.area - 1) > same)
        return false;
    const Index<3> f = index_.index(face.face);
    const int d = face.axis, u = (d + 1) % 3, v = (d + 2) % 3;
    const auto width = [&](int axis) { return width_[axis][f[axis] - index_.low[axis]]; };
    if (std::abs(width(u) - 1) > same || std::abs(width(v) - 1) > same)
        return false;
    const auto next = [&](int axis) {
        const bool last = index_.wraps[axis] && f[axis] == index_.high()[axis] - 1;
        return (last ? 2 - index_.size[axis] : 1) * index_.stride[axis];
    };
    const std::int32_t to_u = next(u), to_v = next(v), low = face.face;
    element_[number_of] = form_.whole.count();
    form_.whole.columns.push_back({vertex_column(low, d), vertex_column(low + to_u, d), vertex_column(low + to_u + to_v, d),
                                   vertex_column(low + to_v, d), edge_column(u, low, d), edge_column(v, low + to_u, d),
                                   edge_column(u, low + to_v, d), edge_column(v, low, d), number_of});
    return true;
}

/// Rows of a whole cell between such faces: with the linear functions of one component and of all.
template <>
bool FormBuilder<3>::add_whole_along(const UnevenCell& cell)
{
    std::array<std::array<std::int32_t, 2>, 3> element; // by axis and side
    for (int d = 0; d < 3; ++d) {
        for (int side = 0; side < 2; ++side) {
            element[d][side] = cell.face[d][side] < 0 ? -1 : element_[cell.face[d][side]];
            if (element[d][side] < 0)
                return false;
        }
        if (element[d][0] == element[d][1])
            return false;
    }
    constexpr double over_extent = 12;
    const auto moment = [&](int axis, int side, int turn) { return first_moment + 2 * element[axis][side] + turn - 1; };
    std::array<std::int32_t, 30> column;
    std::array<double, 30> factor;
    std::array<double, 12> weight;
    int terms = 0, rows = 0;
    std::int64_t end = form_.squares.end.back();
    const auto add = [&](std::int32_t low, std::int32_t high) {
        column[terms] = low;
        factor[terms++] = -1;
        column[terms] = high;
        factor[terms++] = 1;
    };
    const auto close = [&](double of) {
        weight[rows++] = of;
        form_.squares.end.push_back(end + terms);
    };
    for (int d = 0; d < 3; ++d) {
        add(cell.face[d][0], cell.face[d][1]);
        close(1);
        for (int turn = 1; turn < 3; ++turn) {
            add(moment(d, 0, turn), moment(d, 1, turn));
            close(over_extent);
        }
        const int u = (d + 1) % 3, v = (d + 2) % 3; // whose turns to d are 2 and 1
        add(moment(u, 0, 2), moment(u, 1, 2));
        add(moment(v, 0, 1), moment(v, 1, 1));
        close(over_extent);
    }
    form_.squares.column.insert(form_.squares.column.end(), column.begin(), column.end());
    form_.squares.factor.insert(form_.squares.factor.end(), factor.begin(), factor.end());
    form_.squares.weight.insert(form_.squares.weight.end(), weight.begin(), weight.end());
    return true;
}

template std::int32_t FormBuilder<2>::derive(Terms&);
template std::int32_t FormBuilder<3>::derive(Terms&);
template void FormBuilder<2>::add_moment(std::int32_t, int, double, Terms&) const;
template void FormBuilder<3>::add_moment(std::int32_t, int, double, Terms&) const;
template bool FormBuilder<2>::is_compact_edge(const Index<2>&, int, int) const;
template bool FormBuilder<3>::is_compact_edge(const Index<3>&, int, int) const;

} // namespace gapflow
