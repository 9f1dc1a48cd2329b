#include "gapflow/viscous/form.hpp"

#include "gapflow/viscous/form_builder.hpp"

#include "gapflow/grid/field.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {

void RowList::add(Row row)
{
    row.merge();
    for (const Term& term : row.terms()) {
        column.push_back(term.column);
        factor.push_back(term.factor);
    }
    end.push_back(static_cast<std::int64_t>(column.size()));
}

double RowList::value(int row, std::span<const double> x) const
{
    double sum = 0;
    for (std::int64_t t = end[row]; t < end[row + 1]; ++t)
        sum += factor[t] * x[column[t]];
    return sum;
}

template <int D>
void ViscousForm<D>::product(std::span<const double> x, std::span<double> y) const
{
    std::fill(y.begin(), y.end(), 0.0);
    squares.add_product(x, y);
    rotation.add_product(x, y);
}

template <int D>
double ViscousForm<D>::energy(std::span<const double> x) const
{
    return 0.5 * (squares.twice(x) + rotation.twice(x));
}

template <int D>
FormBuilder<D>::FormBuilder(const Grid<D>& grid, std::span<const Solid<D>> solids, const Complex<D>& complex,
                            const PartBorders<D>& borders, const GapDrags<D>& gaps)
    : grid_(grid), solids_(solids), complex_(complex), index_(complex.index), borders_(borders), gaps_(gaps), planes_(grid)
{
    for (const Solid<D>& solid : solids)
        reference_.push_back(planes_.in_cells(solid.centre));
    for (int axis = 0; axis < D; ++axis)
        periodic_ = periodic_ || grid.periodic(axis);
    form_.solids = static_cast<int>(solids.size());
    find_sides();
    for (int axis = 0; axis < D; ++axis)
        vertex_trace_[axis].assign(index_.count, -1);
}

template <int D>
ViscousForm<D> FormBuilder<D>::build()
{
    form_.cells = find_fluid_cells(grid_, complex_);
    find_walls();
    find_faces();
    for (FormFace<D>& face : form_.faces) {
        face.polygon_area = face.area;
        face.polygon_centroid = face.centroid;
    }
    find_borders();
    find_gaps();
    moment_.resize(form_.faces.size());
    for (std::size_t face = 0; face < form_.faces.size(); ++face)
        if (form_.faces[face].compact)
            add_compact(static_cast<std::int32_t>(face));
        else
            add_face(static_cast<std::int32_t>(face));
    for (int cell = 0; cell < form_.cells.count(); ++cell)
        add_along(cell);
    form_.gap_rows[0] = form_.squares.rows();
    add_gaps();
    form_.gap_rows[1] = form_.squares.rows();
    add_outflow();
    add_rotation();
    drop_unused_traces();
    close_columns();
    return std::move(form_);
}

template <int D>
Vec<D> FormBuilder<D>::vertex_place(const Index<D>& v) const
{
    Vec<D> x;
    for (int axis = 0; axis < D; ++axis)
        x[axis] = planes_.place[axis][v[axis]];
    return x;
}

/// From a solid's reference point, or from that of the image that lies nearest, to a point of its wall.
template <int D>
Vec<D> FormBuilder<D>::arm(std::int32_t solid, const Vec<D>& x) const
{
    const Vec<D> r = x - reference_[solid];
    if (!periodic_)
        return r;
    Vec<D> nearest = r, best = r;
    for (int axis = 0; axis < D; ++axis)
        if (grid_.periodic(axis))
            nearest[axis] -= grid_.cells()[axis] * std::round(r[axis] / grid_.cells()[axis]);
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < (D == 2 ? 9 : 27); ++k) { // the first is the nearest itself
        Vec<D> y = nearest;
        bool other = true;
        for (int axis = 0, rest = k; axis < D; ++axis, rest /= 3) {
            const int shift = rest % 3 == 2 ? -1 : rest % 3;
            other = other && (shift == 0 || grid_.periodic(axis));
            y[axis] += shift * grid_.cells()[axis];
        }
        if (!other)
            continue;
        const double far = std::abs(solids_[solid].shape.distance(planes_.in_world(reference_[solid] + y))) / planes_.dx;
        if (far < least - 1e-6) {
            least = far;
            best = y;
        }
        if (least < 0.1)
            break;
    }
    return best;
}

template <int D>
Row FormBuilder<D>::velocity(std::int32_t face) const
{
    Row row;
    row.add(face, 1);
    return row;
}

/// Columns of twists are numbered from -1 down until all traces are known.
template <int D>
Row FormBuilder<D>::of_solid(std::int32_t solid, const Vec<D>& x, int component) const
{
    Row row;
    const std::int32_t first = -1 - twist_size<D> * solid;
    row.add(first - component, 1);
    const Vec<D> r = arm(solid, x);
    if constexpr (D == 2)
        row.add(first - 2, component == 0 ? -r[1] : r[0]);
    else {
        const int e = (component + 1) % 3, f = (component + 2) % 3;
        row.add(first - 3 - e, r[f]);
        row.add(first - 3 - f, -r[e]);
    }
    return row;
}

template <int D>
Row FormBuilder<D>::of_point(const BorderPoint<D>& point, int component)
{
    if (point.solid >= 0)
        return of_solid(point.solid, point.at, component);
    if (point.vertex >= 0)
        return of_vertex(point.vertex, component);
    Row row;
    row.add(new_trace(component, point.at), 1);
    return row;
}

template <int D>
void FormBuilder<D>::add_compact(std::int32_t number)
{
    const FormFace<D>& face = form_.faces[number];
    const Index<D> f = index_.index(face.face);
    for (int a = 0; a < D; ++a)
        for (int end = 0; end < 2 && a != face.axis; ++end) {
            const double width = planes_.place[a][f[a] + 1] - planes_.place[a][f[a]], across = face.area / width;
            Row row = velocity(number);
            if (is_closed_side(a, f[a] + end)) {
                row.add(of_side(a, f[a] + end, face.axis), -1);
                form_.squares.add(face.length * across / (0.5 * width), row);
                continue;
            }
            const Index<D> g = index_.wrapped(Index<D>(f + (end ? 1 : -1) * step<D>(a)));
            const std::int32_t other =
                index_.holds(g - std::max(0, g[face.axis] - index_.high()[face.axis] + 1) * step<D>(face.axis))
                    ? whole_face_[face.axis][index_(g)]
                    : -1;
            if (other < 0)
                continue;
            row.add(other, -1);
            // Half of it is that of the face beyond, by its link or by its element.
            form_.squares.add(face.length * across / (width + planes_.place[a][g[a] + 1] - planes_.place[a][g[a]]), row);
        }
}

template <int D>
Row FormBuilder<D>::between(int component, int across, const Index<D>& high) const
{
    std::array<std::int32_t, 4> face;
    std::array<double, 4> width;
    for (int k = 0; k < 4; ++k) {
        const Index<D> g = index_.wrapped(Index<D>(high + (k - 2) * step<D>(across)));
        Index<D> cell = g;
        cell[component] = std::min(g[component], index_.high()[component] - 1);
        face[k] = index_.holds(cell) ? whole_face_[component][index_(g)] : -1;
        width[k] = face[k] < 0 ? 0 : planes_.place[across][g[across] + 1] - planes_.place[across][g[across]];
    }
    const bool uniform = std::abs(width[0] - width[1]) + std::abs(width[3] - width[2]) + std::abs(width[2] - width[1]) < 1e-9;
    Row row;
    if (uniform) // half way between mean and cubic interpolation: the dissipation of a linear shear stress is exact
        for (int k = 0; k < 4; ++k)
            row.add(face[k], k == 1 || k == 2 ? 13.0 / 24 : -1.0 / 24);
    else {
        row.add(face[1], width[2] / (width[1] + width[2]));
        row.add(face[2], width[1] / (width[1] + width[2]));
    }
    return row;
}

template <int D>
void FormBuilder<D>::add_outflow()
{
    std::vector<Row> rows(form_.cells.count());
    for (std::size_t k = 0; k < form_.faces.size(); ++k) {
        const FormFace<D>& face = form_.faces[k];
        if (face.low >= 0)
            rows[face.low].add(static_cast<std::int32_t>(k), face.area);
        if (face.high >= 0)
            rows[face.high].add(static_cast<std::int32_t>(k), -face.area);
    }
    for (int part = 0; part < complex_.parts(); ++part)
        for (const WallPatch<D>& patch : complex_.patches_of(part)) {
            Row& row = rows[form_.cells.of_part[part]];
            const std::int32_t first = -1 - twist_size<D> * patch.solid;
            for (int k = 0; k < D; ++k)
                row.add(first - k, patch.area[k]);
            for (int k = 0; k < spin_size<D>; ++k)
                row.add(first - D - k, patch.moment[k]);
        }
    for (Row& row : rows)
        form_.outflow.add(std::move(row));
}

/// 2 |e|^2 - |grad u|^2 is the divergence of u . grad u - u div u, which on walls follows from their rotation: |omega|^2 of the solid's volume for each component normal
/// to the axis. Of each component the form has the volume that the planes normal to it see.
template <int D>
void FormBuilder<D>::add_rotation()
{
    std::vector<Spin<D>> seen(solids_.size(), Spin<D>::Zero());
    for (int part = 0; part < complex_.parts(); ++part)
        for (const WallPatch<D>& patch : complex_.patches_of(part)) {
            const Vec<D> r = arm(patch.solid, centre_of(form_.cells.of_part[part]));
            for (int d = 0; d < D; ++d)
                for (int k = 0; k < spin_size<D>; ++k)
                    if (D == 2 || k != d)
                        seen[patch.solid][k] -= patch.area[d] * r[d];
        }
    for (std::size_t solid = 0; solid < seen.size(); ++solid)
        for (int k = 0; k < spin_size<D>; ++k) {
            Row row;
            row.add(-1 - twist_size<D> * static_cast<std::int32_t>(solid) - D - k, 1);
            form_.rotation.add(seen[solid][k], row);
        }
}

/// Those that no square has, as within gaps.
template <int D>
void FormBuilder<D>::drop_unused_traces()
{
    const std::int32_t first = form_.velocities();
    std::vector<std::int32_t> number(form_.traces.size(), -1);
    for (const std::int32_t column : form_.squares.column)
        if (column >= first)
            number[column - first] = 0;
    std::int32_t n = 0;
    for (std::size_t k = 0; k < number.size(); ++k)
        if (number[k] == 0) {
            form_.traces[n] = form_.traces[k];
            number[k] = n++;
        }
    form_.traces.resize(n);
    for (std::int32_t& column : form_.squares.column)
        if (column >= first)
            column = first + number[column - first];
}

template <int D>
void FormBuilder<D>::close_columns()
{
    for (std::vector<std::int32_t>* columns : {&form_.squares.column, &form_.rotation.column, &form_.outflow.column})
        for (std::int32_t& column : *columns)
            if (column < 0)
                column = form_.unknowns() - 1 - column;
}

template <int D>
ViscousForm<D> build_viscous_form(const Grid<D>& grid, std::span<const Solid<D>> solids, const Complex<D>& complex,
                                  const PartBorders<D>& borders, const GapDrags<D>& gaps)
{
    return FormBuilder<D>(grid, solids, complex, borders, gaps).build();
}

template struct ViscousForm<2>;
template struct ViscousForm<3>;
template class FormBuilder<2>;
template class FormBuilder<3>;
template ViscousForm<2> build_viscous_form(const Grid<2>&, std::span<const Solid<2>>, const Complex<2>&, const PartBorders<2>&,
                                           const GapDrags<2>&);
template ViscousForm<3> build_viscous_form(const Grid<3>&, std::span<const Solid<3>>, const Complex<3>&, const PartBorders<3>&,
                                           const GapDrags<3>&);

} // namespace gapflow
