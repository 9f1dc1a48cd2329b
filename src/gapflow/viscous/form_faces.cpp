// Faces of the form: whole faces of the grid, and pieces of others.
#include "gapflow/viscous/form_builder.hpp"

#include "gapflow/grid/field.hpp"
#include "gapflow/viscous/parameters.hpp"

#include <algorithm>
#include <cmath>

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
Row FormBuilder<D>::of_side(int axis, int plane, int component) const
{
    Row row;
    if (const std::int32_t solid = side_solid_[2 * axis + (plane > 0)]; solid >= 0)
        row.add(-1 - twist_size<D> * solid - component, 1);
    return row;
}

template <int D>
Row FormBuilder<D>::of_sides(const Index<D>& vertex, int component) const
{
    Row row;
    int sides = 0;
    for (int axis = 0; axis < D; ++axis)
        sides += is_closed_side(axis, vertex[axis]);
    for (int axis = 0; axis < D; ++axis)
        if (is_closed_side(axis, vertex[axis]))
            row.add(of_side(axis, vertex[axis], component), 1.0 / sides);
    return row;
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
    std::array<std::vector<double>, D> rest = complex_.main_area;
    for (const FacePiece<D>& piece : complex_.pieces)
        rest[piece.axis][piece.face] = 0;
    for (int d = 0; d < D; ++d) {
        whole_face_[d].assign(index_.count, -1);
        for_each_index<D>(index_.low, index_.faces_end(d), [&](const Index<D>& f) {
            const int id = index_(f);
            if (!(rest[d][id] > 0) || is_closed_side(d, f[d]))
                return;
            const auto main = [&](const Index<D>& c) {
                const Index<D> w = index_.wrapped(c);
                return index_.holds(w) ? complex_.main_of(index_(w)) : PartOrCell{};
            };
            FormFace<D> face{static_cast<std::int8_t>(d),
                             true,
                             false,
                             id,
                             form_.cells.of(main(f - step<D>(d))),
                             form_.cells.of(main(f)),
                             rest[d][id],
                             length_of(d, f),
                             Vec<D>::Zero()};
            int layer = viscous_parameters.layers;
            for (const std::int32_t cell : {face.low, face.high})
                if (cell >= 0)
                    layer = std::min<int>(layer, form_.cells.layer[form_.cells.grid_cell[cell]]);
            face.compact = layer >= viscous_parameters.layers;
            for (int axis = 0; axis < D; ++axis)
                face.centroid[axis] = axis == d ? planes_.place[axis][f[axis]] : planes_.centre_of(axis, f[axis]);
            whole_face_[d][id] = static_cast<std::int32_t>(form_.faces.size());
            form_.faces.push_back(face);
        });
    }
}

template <int D>
void FormBuilder<D>::find_faces()
{
    add_pieces();
    merge_pieces();
    add_whole_faces();
    // Those of each cell.
    const int cells = form_.cells.count();
    first_face_.assign(cells + 1, 0);
    for (const FormFace<D>& face : form_.faces)
        for (const std::int32_t cell : {face.low, face.high})
            if (cell >= 0)
                ++first_face_[cell + 1];
    for (int c = 0; c < cells; ++c)
        first_face_[c + 1] += first_face_[c];
    cell_faces_.resize(first_face_[cells]);
    std::vector<std::int32_t> next(first_face_.begin(), first_face_.end() - 1);
    for (std::size_t k = 0; k < form_.faces.size(); ++k) {
        const FormFace<D>& face = form_.faces[k];
        if (face.low >= 0)
            cell_faces_[next[face.low]++] = {static_cast<std::int32_t>(k), 1};
        if (face.high >= 0)
            cell_faces_[next[face.high]++] = {static_cast<std::int32_t>(k), -1};
    }
}

/// A point between the ends of a chord of a wall in a plane of the grid, so far off the chord that the area of the two is that of the wall's curve: 4/3 of its
/// sagitta, from the turn of the normals. The chord's middle where the wall is straight.
template <>
Vec<3> FormBuilder<3>::on_curve(const Vec<3>& from, const Vec<3>& to, std::int32_t solid, int axis) const
{
    constexpr double inset = 0.02; // off the ends, where other facets may begin
    const bool swap = std::lexicographical_compare(to.begin(), to.end(), from.begin(), from.end());
    const Vec<3>&a = swap ? to : from, &b = swap ? from : to, way = b - a;
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
}

/// A part's face with such points between those of its walls.
template <>
std::vector<Vec<3>> FormBuilder<3>::curved(const PartFace<3>& face) const
{
    std::vector<Vec<3>> points;
    const std::size_t n = face.points.size();
    const Index<3> c = complex_.cell_of_part(face.part);
    for (std::size_t k = 0; k < n; ++k) {
        const Vec<3>&from = face.points[k], &to = face.points[(k + 1) % n];
        points.push_back(from);
        const std::int32_t solid = face.sides.empty() ? face.solid : face.sides[k];
        for (int axis = 0; axis < 3 && solid >= 0; ++axis)
            if (from != to && from[axis] == to[axis] &&
                (from[axis] == planes_.place[axis][c[axis]] || from[axis] == planes_.place[axis][c[axis] + 1])) {
                points.push_back(on_curve(from, to, solid, axis));
                break;
            }
    }
    return points;
}
template <>
std::vector<Vec<2>> FormBuilder<2>::curved(const PartFace<2>& face) const
{
    return face.points;
}

/// Walls of the cells, and the shapes of those that are cut.
template <int D>
void FormBuilder<D>::find_walls()
{
    const int cells = form_.cells.count();
    shapes_.assign(cells, {});
    std::vector<std::vector<WallPiece<D>>> of(cells);
    for (const PartFace<D>& side : borders_) {
        if (side.solid == PartFace<D>::dividing)
            continue;
        const std::int32_t cell = form_.cells.of_part[side.part];
        for (const std::array<Vec<D>, D>& simplex : simplices<D>(curved(side))) {
            shapes_[cell].add(simplex, centre_of(cell));
            if (side.solid >= 0)
                of[cell].push_back({simplex, side.solid});
        }
    }
    first_wall_.assign(1, 0);
    for (int cell = 0; cell < cells; ++cell) {
        shapes_[cell].close(centre_of(cell));
        walls_.insert(walls_.end(), of[cell].begin(), of[cell].end());
        first_wall_.push_back(static_cast<std::int32_t>(walls_.size()));
        if (!form_.cells.whole[cell])
            continue;
        CellShape<D>& shape = shapes_[cell];
        const Index<D> c = index_.index(form_.cells.grid_cell[cell]);
        shape.volume = 1;
        shape.centroid = centre_of(cell);
        for (int axis = 0; axis < D; ++axis)
            shape.volume *= planes_.place[axis][c[axis] + 1] - planes_.place[axis][c[axis]];
        for (int axis = 0; axis < D; ++axis) {
            const double width = planes_.place[axis][c[axis] + 1] - planes_.place[axis][c[axis]];
            shape.second(axis, axis) = shape.volume * width * width / 12;
        }
    }
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
template Row FormBuilder<2>::of_side(int, int, int) const;
template Row FormBuilder<2>::of_sides(const Index<2>&, int) const;
template Vec<2> FormBuilder<2>::centre_of(std::int32_t) const;
template void FormBuilder<3>::find_faces();
template void FormBuilder<3>::find_walls();
template bool FormBuilder<3>::is_closed_side(int, int) const;
template bool FormBuilder<3>::on_closed_side(const Index<3>&) const;
template void FormBuilder<3>::find_sides();
template Row FormBuilder<3>::of_side(int, int, int) const;
template Row FormBuilder<3>::of_sides(const Index<3>&, int) const;
template Vec<3> FormBuilder<3>::centre_of(std::int32_t) const;

} // namespace gapflow
