// Faces of the form: whole faces of the grid, and pieces of others.
#include "gapflow/viscous/form_builder.hpp"

#include "gapflow/grid/field.hpp"
#include "gapflow/viscous/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gapflow {

template <int D>
bool FormBuilder<D>::is_closed_side(int axis, int plane) const
{
    return (plane == 0 && grid_.side(axis, 0) == SideKind::wall) ||
           (plane == grid_.cells()[axis] && grid_.side(axis, 1) == SideKind::wall);
}

template <int D>
bool FormBuilder<D>::on_closed_side(const Index<D>& vertex) const
{
    for (int axis = 0; axis < D; ++axis)
        if (is_closed_side(axis, vertex[axis]))
            return true;
    return false;
}

/// Closed sides among the solids are half-spaces with their wall in the side.
template <int D>
void FormBuilder<D>::find_sides()
{
    side_solid_.fill(-1);
    for (std::size_t s = 0; s < solids_.size(); ++s)
        for (int axis = 0; axis < D && solids_[s].wall; ++axis)
            for (int end = 0; end < 2; ++end) {
                const double place = planes_.place[axis][end * grid_.cells()[axis]];
                Vec<D> inside = reference_[s];
                inside[axis] += end ? -1 : 1;
                if (std::abs(reference_[s][axis] - place) < viscous_parameters.same_place &&
                    solids_[s].shape.distance(planes_.in_world(inside)) > 0.5 * planes_.dx)
                    side_solid_[2 * axis + end] = static_cast<std::int32_t>(s);
            }
}

template <int D>
void FormBuilder<D>::add_side(int axis, int plane, int component, double factor, Terms& to) const
{
    if (const std::int32_t solid = side_solid_[2 * axis + (plane > 0)]; solid >= 0)
        to.push_back({-1 - twist_size<D> * solid - component, factor});
}

template <int D>
void FormBuilder<D>::add_sides(const Index<D>& vertex, int component, double factor, Terms& to) const
{
    int sides = 0;
    for (int axis = 0; axis < D; ++axis)
        sides += is_closed_side(axis, vertex[axis]);
    for (int axis = 0; axis < D; ++axis)
        if (is_closed_side(axis, vertex[axis]))
            add_side(axis, vertex[axis], component, factor / sides, to);
}

template <int D>
double FormBuilder<D>::length_of(int axis, const Index<D>& f) const
{
    const bool first = f[axis] == 0 && !grid_.periodic(axis), last = f[axis] == grid_.cells()[axis] && !grid_.periodic(axis);
    const double place = planes_.place[axis][f[axis]];
    return (last ? place : planes_.centre_of(axis, f[axis])) - (first ? place : planes_.centre_of(axis, f[axis] - 1));
}

template <int D>
void FormBuilder<D>::add_pieces()
{
    face_of_piece_.assign(complex_.pieces.size(), -1);
    for (std::size_t k = 0; k < complex_.pieces.size(); ++k) {
        const FacePiece<D>& piece = complex_.pieces[k];
        const Index<D> f = index_.index(piece.face);
        if (!(piece.area > 0) || is_closed_side(piece.axis, f[piece.axis]))
            continue;
        FormFace<D> face{piece.axis,
                         false,
                         false,
                         piece.face,
                         form_.cells.of(piece.low),
                         form_.cells.of(piece.high),
                         piece.area,
                         length_of(piece.axis, f),
                         piece.centroid};
        if (face.low < 0 && face.high < 0)
            continue;
        face_of_piece_[k] = static_cast<std::int32_t>(form_.faces.size());
        form_.faces.push_back(face);
    }
}

/// Of faces that no solid cuts.
template <int D>
void FormBuilder<D>::add_whole_faces()
{
    constexpr std::int32_t is_cut = -2;
    std::vector<std::int32_t> main(index_.count, -1); // largest part of each of the grid's cells
    for_each_row<D>(index_.low, index_.high(), [&](const Index<D>& row) {
        const int first = index_(row), end = first + index_.size[0] - 1;
        for (int id = first; id < end; ++id)
            main[id] = form_.cells.of(complex_.main_of(id));
    });
    const auto layer = [&](std::int32_t cell) {
        return cell < 0 ? viscous_parameters.layers : int(form_.cells.layer[form_.cells.grid_cell[cell]]);
    };
    long most = 0; // faces
    for (int d = 0; d < D; ++d)
        most += (index_.faces_end(d) - index_.low).template cast<long>().prod();
    form_.faces.reserve(form_.faces.size() + most);
    for (int d = 0; d < D; ++d) {
        std::vector<std::int32_t>& number = whole_face_[d];
        number.assign(index_.count, -1);
        for (const FacePiece<D>& piece : complex_.pieces)
            if (piece.axis == d)
                number[piece.face] = is_cut;
        const Index<D> end = index_.faces_end(d);
        for_each_row<D>(index_.low, end, [&](const Index<D>& row) {
            Index<D> f = row;
            const Index<D> below = index_.wrapped(Index<D>(row - step<D>(d)));
            const std::int32_t first = index_.holds(below) ? main[index_(below)] : -1;
            const std::int32_t* low = d == 0 ? &main[index_(row)] - 1 : index_.holds(below) ? &main[index_(below)] : nullptr;
            for (int id = index_(row); f[0] < end[0]; ++f[0], ++id) {
                if (!(complex_.main_area[d][id] > 0) || number[id] == is_cut || is_closed_side(d, f[d]))
                    continue;
                const int i = f[0] - row[0];
                FormFace<D> face{static_cast<std::int8_t>(d),
                                 true,
                                 false,
                                 id,
                                 d == 0 && i == 0 ? first
                                 : low            ? low[i]
                                                  : -1,
                                 main[id],
                                 complex_.main_area[d][id],
                                 length_of(d, f),
                                 Vec<D>::Zero()};
                face.compact = std::min(layer(face.low), layer(face.high)) >= viscous_parameters.layers;
                for (int axis = 0; axis < D; ++axis)
                    face.centroid[axis] = axis == d ? planes_.place[axis][f[axis]] : centre_[axis][f[axis] - index_.low[axis]];
                face.polygon_area = face.area;
                face.polygon_centroid = face.centroid;
                number[id] = static_cast<std::int32_t>(form_.faces.size());
                form_.faces.push_back(face);
                compact_.push_back(face.compact);
            }
        });
        std::ranges::replace(number, is_cut, -1);
    }
}

template <int D>
void FormBuilder<D>::find_faces()
{
    add_pieces();
    merge_pieces();
    pieces_ = static_cast<std::int32_t>(form_.faces.size());
    for (FormFace<D>& face : form_.faces) {
        face.polygon_area = face.area;
        face.polygon_centroid = face.centroid;
    }
    // Those of each cell.
    const int cells = form_.cells.count();
    first_face_.assign(cells + 1, 0);
    for (const FormFace<D>& face : form_.faces)
        for (const std::int32_t cell : {face.low, face.high})
            if (cell >= 0)
                ++first_face_[cell + 1];
    std::partial_sum(first_face_.begin(), first_face_.end(), first_face_.begin());
    cell_faces_.resize(first_face_[cells]);
    std::vector<std::int32_t> next(first_face_.begin(), first_face_.end() - 1);
    for (std::int32_t k = 0; k < pieces_; ++k) {
        const FormFace<D>& face = form_.faces[k];
        if (face.low >= 0)
            cell_faces_[next[face.low]++] = {k, 1};
        if (face.high >= 0)
            cell_faces_[next[face.high]++] = {k, -1};
    }
    compact_.assign(pieces_, false);
    add_whole_faces();
}

template <int D>
auto FormBuilder<D>::faces_of(std::int32_t cell) const -> CellFaces
{
    CellFaces faces;
    for (std::int32_t k = first_face_[cell]; k < first_face_[cell + 1]; ++k)
        faces.push_back(cell_faces_[k]);
    const std::int32_t low = form_.cells.grid_cell[cell];
    const Index<D> c = index_.index(low);
    for (int axis = 0; axis < D; ++axis)
        for (int end = 0; end < 2; ++end) {
            const bool last = c[axis] == index_.high()[axis] - 1 && index_.wraps[axis];
            const std::int32_t id = low + (end == 0 ? 0
                                           : last   ? (2 - index_.size[axis])
                                                    : 1) *
                                              index_.stride[axis],
                               face = whole_face_[axis][id];
            if (face >= 0 && (end ? form_.faces[face].low : form_.faces[face].high) == cell)
                faces.push_back({face, end ? 1 : -1});
        }
    return faces;
}

/// A point between the ends of a chord of a wall in a plane of the grid, so far off the chord that the area of the two is that of the wall's curve: 4/3 of its
/// sagitta, from the turn of the normals. The chord's middle where the wall is straight.
template <>
Vec<3> FormBuilder<3>::on_curve(const Vec<3>& from, const Vec<3>& to, std::int32_t solid, int axis)
{
    constexpr double inset = 0.02; // off the ends, where other facets may begin
    const bool swap = std::lexicographical_compare(to.begin(), to.end(), from.begin(), from.end());
    const Vec<3>&a = swap ? to : from, &b = swap ? from : to;
    return curve_points_.of(a, b, 3 * solid + axis, [&] {
        const Vec<3> way = b - a;
        std::array<Vec<3>, 2> normal;
        for (int end = 0; end < 2; ++end) {
            const Vec<3> x = reference_[solid] + arm(solid, a + (end ? 1 - inset : inset) * way);
            normal[end] = solids_[solid].shape.closest(planes_.in_world(x)).normal;
            normal[end][axis] = 0;
            normal[end].normalize();
        }
        const Vec<3> middle = 0.5 * (a + b), out = (normal[0] + normal[1]).normalized();
        const double turn = (normal[1] - normal[0]).dot(way) / (1 - 2 * inset) / way.norm();
        return std::isfinite(turn) && std::abs(turn) < 0.5 ? Vec<3>(middle + way.norm() * turn / 6 * out) : middle;
    });
}

/// A part's face with such points between those of its walls.
template <>
void FormBuilder<3>::find_curved(const PartFace<3>& face, std::vector<Vec<3>>& points)
{
    points.clear();
    const std::size_t n = face.points.size();
    const Index<3> c = complex_.cell_of_part(face.part);
    for (std::size_t k = 0; k < n; ++k) {
        const Vec<3>&from = face.points[k], &to = face.points[k + 1 < n ? k + 1 : 0];
        points.push_back(from);
        const std::int32_t solid = face.sides.empty() ? face.solid : face.sides[k];
        for (int axis = 0; axis < 3 && solid >= 0; ++axis)
            if (from != to && from[axis] == to[axis] &&
                (from[axis] == planes_.place[axis][c[axis]] || from[axis] == planes_.place[axis][c[axis] + 1])) {
                points.push_back(on_curve(from, to, solid, axis));
                break;
            }
    }
}
template <>
void FormBuilder<2>::find_curved(const PartFace<2>& face, std::vector<Vec<2>>& points)
{
    points = face.points;
}

/// Walls of the cells that are cut, and their shapes.
template <int D>
void FormBuilder<D>::find_walls()
{
    const auto cells = static_cast<std::int32_t>(std::ranges::find(form_.cells.whole, 1) - form_.cells.whole.begin());
    shapes_.assign(cells, {});
    std::vector<Vec<D>> centre(cells);
    for (std::int32_t cell = 0; cell < cells; ++cell)
        centre[cell] = centre_of(cell);
    std::vector<WallPiece<D>> walls;
    std::vector<std::int32_t> cell_of;
    first_wall_.assign(cells + 1, 0);
    std::vector<Vec<D>> points;
    std::vector<std::array<Vec<D>, D>> simplices;
    for (const PartFace<D>& side : borders_) {
        if (side.solid == PartFace<D>::dividing)
            continue;
        const std::int32_t cell = form_.cells.of_part[side.part];
        find_curved(side, points);
        find_simplices<D>(points, simplices);
        for (const std::array<Vec<D>, D>& simplex : simplices) {
            shapes_[cell].add(simplex, centre[cell]);
            if (side.solid >= 0) {
                walls.push_back({simplex, side.solid});
                cell_of.push_back(cell);
                ++first_wall_[cell + 1];
            }
        }
    }
    for (std::int32_t cell = 0; cell < cells; ++cell)
        shapes_[cell].close(centre[cell]);
    std::partial_sum(first_wall_.begin(), first_wall_.end(), first_wall_.begin());
    walls_.resize(walls.size());
    std::vector<std::int32_t> next(first_wall_.begin(), first_wall_.end() - 1);
    for (std::size_t k = 0; k < walls.size(); ++k)
        walls_[next[cell_of[k]]++] = walls[k];
}

template <int D>
CellShape<D> FormBuilder<D>::shape_of(std::int32_t cell) const
{
    if (cell < cut_cells())
        return shapes_[cell];
    CellShape<D> shape;
    const Index<D> c = index_.index(form_.cells.grid_cell[cell]);
    shape.volume = 1;
    for (int axis = 0; axis < D; ++axis) {
        shape.centroid[axis] = centre_[axis][c[axis] - index_.low[axis]];
        shape.volume *= width_[axis][c[axis] - index_.low[axis]];
    }
    for (int axis = 0; axis < D; ++axis) {
        const double width = width_[axis][c[axis] - index_.low[axis]];
        shape.second(axis, axis) = shape.volume * width * width / 12;
    }
    return shape;
}

template <int D>
Vec<D> FormBuilder<D>::centre_of(std::int32_t cell) const
{
    const Index<D> c = index_.index(form_.cells.grid_cell[cell]);
    Vec<D> x;
    for (int axis = 0; axis < D; ++axis)
        x[axis] = planes_.centre_of(axis, c[axis]);
    return x;
}

template void FormBuilder<2>::find_faces();
template void FormBuilder<2>::find_walls();
template bool FormBuilder<2>::is_closed_side(int, int) const;
template bool FormBuilder<2>::on_closed_side(const Index<2>&) const;
template void FormBuilder<2>::find_sides();
template void FormBuilder<2>::add_side(int, int, int, double, Terms&) const;
template void FormBuilder<2>::add_sides(const Index<2>&, int, double, Terms&) const;
template Vec<2> FormBuilder<2>::centre_of(std::int32_t) const;
template FormBuilder<2>::CellFaces FormBuilder<2>::faces_of(std::int32_t) const;
template CellShape<2> FormBuilder<2>::shape_of(std::int32_t) const;
template void FormBuilder<3>::find_faces();
template void FormBuilder<3>::find_walls();
template bool FormBuilder<3>::is_closed_side(int, int) const;
template bool FormBuilder<3>::on_closed_side(const Index<3>&) const;
template void FormBuilder<3>::find_sides();
template void FormBuilder<3>::add_side(int, int, int, double, Terms&) const;
template void FormBuilder<3>::add_sides(const Index<3>&, int, double, Terms&) const;
template Vec<3> FormBuilder<3>::centre_of(std::int32_t) const;
template FormBuilder<3>::CellFaces FormBuilder<3>::faces_of(std::int32_t) const;
template CellShape<3> FormBuilder<3>::shape_of(std::int32_t) const;

} // namespace gapflow
