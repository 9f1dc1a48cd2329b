#include "gapflow/viscous/form.hpp"

#include "gapflow/viscous/form_builder.hpp"

#include "gapflow/grid/field.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

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
void ViscousForm<D>::find_derived(std::span<const double> x, std::vector<double>& all) const
{
    all.resize(all_columns());
    std::copy(x.begin(), x.end(), all.begin());
    for (int row = 0; row < derived.rows(); ++row)
        all[columns() + row] = derived.value(row, x);
    whole.find_moments(all, std::span(all).subspan(columns() + derived.rows()));
}

template <int D>
void ViscousForm<D>::product(std::span<const double> x, std::span<double> y) const
{
    Room room;
    product(x, y, room);
}

template <int D>
void ViscousForm<D>::product(std::span<const double> x, std::span<double> y, Room& room) const
{
    find_derived(x, room.all);
    std::vector<double>& by = room.by;
    by.assign(room.all.size(), 0.0);
    lattice.add_product(room.all, by);
    squares.add_product(room.all, by);
    whole.add_product(room.all, std::span<const double>(by).subspan(columns() + derived.rows()), by);
    for (int row = 0; row < derived.rows(); ++row)
        for (std::int64_t t = derived.end[row]; t < derived.end[row + 1]; ++t)
            by[derived.column[t]] += derived.factor[t] * by[columns() + row];
    std::copy(by.begin(), by.begin() + columns(), y.begin());
    rotation.add_product(x, y);
}

template <int D>
double ViscousForm<D>::energy(std::span<const double> x) const
{
    std::vector<double> y(x.size());
    product(x, y);
    return 0.5 * std::inner_product(x.begin(), x.end(), y.begin(), 0.0);
}

template <int D>
SquareSum ViscousForm<D>::plain_squares() const
{
    SquareSum sum;
    const int first_moment_column = columns() + derived.rows();
    const std::function<void(Row&, std::int32_t, double)> add = [&](Row& row, std::int32_t column, double factor) {
        if (column < columns())
            row.add(column, factor);
        else if (column < first_moment_column) {
            const int k = column - columns();
            for (std::int64_t t = derived.end[k]; t < derived.end[k + 1]; ++t)
                row.add(derived.column[t], factor * derived.factor[t]);
        } else
            for (int k = 0; k < UnitFace::size; ++k)
                add(row, whole.columns[(column - first_moment_column) / 2][k],
                    factor * unit_face().moment((column - first_moment_column) % 2, k));
    };
    for (std::int64_t k = 0; k < squares.rows(); ++k) {
        Row row;
        for (std::int64_t t = squares.end[k]; t < squares.end[k + 1]; ++t)
            add(row, squares.column[t], squares.factor[t]);
        sum.add(squares.weight[k], std::move(row));
    }
    lattice.for_each_pair([&](std::int32_t a, std::int32_t b) { sum.add(1, {{a, 1}, {b, -1}}); });
    if (whole.count() == 0)
        return sum;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(unit_face().stiffness);
    for (const auto& face : whole.columns)
        for (int m = 1; m < UnitFace::size; ++m) { // without the constant
            Row row;
            for (int k = 0; k < UnitFace::size; ++k)
                add(row, face[k], modes.eigenvectors()(k, m));
            sum.add(modes.eigenvalues()[m], std::move(row));
        }
    return sum;
}

template <int D>
std::vector<double> ViscousForm<D>::diagonal() const
{
    std::vector<double> by(all_columns(), 0.0);
    lattice.for_each_pair([&](std::int32_t a, std::int32_t b) {
        ++by[a];
        ++by[b];
    });
    for (std::int64_t k = 0; k < squares.rows(); ++k)
        for (std::int64_t t = squares.end[k]; t < squares.end[k + 1]; ++t)
            by[squares.column[t]] += squares.weight[k] * squares.factor[t] * squares.factor[t];
    const std::size_t first = columns() + derived.rows();
    for (std::size_t f = 0; f < whole.columns.size(); ++f)
        for (int k = 0; k < UnitFace::size; ++k) {
            double& sum = by[whole.columns[f][k]] += unit_face().stiffness(k, k);
            for (int m = 0; m < 2; ++m)
                sum += by[first + 2 * f + m] * unit_face().moment(m, k) * unit_face().moment(m, k);
        }
    for (int row = 0; row < derived.rows(); ++row)
        for (std::int64_t t = derived.end[row]; t < derived.end[row + 1]; ++t)
            by[derived.column[t]] += derived.factor[t] * derived.factor[t] * by[columns() + row];
    by.resize(columns());
    return by;
}

template <int D>
std::vector<double> ViscousForm<D>::followed_diagonal(const std::vector<double>& diagonal) const
{
    std::vector<double> result(diagonal.begin(), diagonal.begin() + velocities());
    std::vector<char> own(velocities(), false);
    for (const FormElement& element : elements) {
        own[element.face] = true;
        result[element.face] = 0;
    }
    for (const auto& face : whole.columns)
        result[face[UnitFace::traces]] = unit_face().followed;
    for (const auto& [face, other] : lattice.links)
        result[face] += own[face];
    std::vector<double> sum(velocities(), 0.0);
    std::vector<std::int32_t> used;
    const auto add = [&](std::int32_t face, double value) {
        if (own[face]) {
            sum[face] += value;
            used.push_back(face);
        }
    };
    for (std::int64_t k = 0; k < squares.rows(); ++k) {
        for (std::int64_t t = squares.end[k]; t < squares.end[k + 1]; ++t)
            if (const std::int32_t column = squares.column[t]; column < velocities())
                add(column, squares.factor[t]);
            else if (column < unknowns()) {
                const std::int32_t trace = column - velocities();
                for (std::int64_t b = beside.end[trace]; b < beside.end[trace + 1]; ++b)
                    add(beside.column[b], squares.factor[t] * beside.factor[b]);
            }
        for (const std::int32_t face : used) {
            result[face] += squares.weight[k] * sum[face] * sum[face];
            sum[face] = 0;
        }
        used.clear();
    }
    for (const auto& face : whole.columns)
        for (int slot = 0; slot < UnitFace::traces; ++slot)
            if (face[slot] < unknowns()) {
                const std::int32_t trace = face[slot] - velocities();
                for (std::int64_t b = beside.end[trace]; b < beside.end[trace + 1]; ++b)
                    if (own[beside.column[b]])
                        result[beside.column[b]] += beside.factor[b] * beside.factor[b] * unit_face().stiffness(slot, slot);
            }
    return result;
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
    whole_element_.assign(form_.faces.size(), -1);
    find_lattice();
    for (std::size_t face = 0; face < form_.faces.size(); ++face) {
        if (form_.faces[face].compact)
            add_compact(static_cast<std::int32_t>(face));
        else
            add_face(static_cast<std::int32_t>(face));
        form_.row_face.resize(form_.squares.rows(), static_cast<std::int32_t>(face));
    }
    for (int cell = 0; cell < form_.cells.count(); ++cell)
        add_along(cell);
    const std::int64_t first_of_gaps = form_.squares.rows();
    form_.row_face.resize(first_of_gaps, -1);
    add_gaps();
    form_.gap_rows = {first_of_gaps, form_.squares.rows()};
    add_outflow();
    add_rotation();
    drop_unused_traces();
    close_columns();
    find_beside();
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
    add_twist(row, solid, wrench<D>(unit<D>(component), arm(solid, x)));
    return row;
}

template <int D>
void FormBuilder<D>::add_twist(Row& row, std::int32_t solid, const Twist<D>& factor)
{
    for (int k = 0; k < twist_size<D>; ++k)
        if (factor[k] != 0)
            row.add(-1 - twist_size<D> * solid - k, factor[k]);
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
    std::vector<Row> walls(form_.cells.count());
    for (int part = 0; part < complex_.parts(); ++part)
        for (const WallPatch<D>& patch : complex_.patches_of(part)) {
            Row& row = walls[form_.cells.of_part[part]];
            const std::int32_t first = -1 - twist_size<D> * patch.solid;
            for (int k = 0; k < D; ++k)
                row.add(first - k, patch.area[k]);
            for (int k = 0; k < spin_size<D>; ++k)
                row.add(first - D - k, patch.moment[k]);
        }
    for (int cell = 0; cell < form_.cells.count(); ++cell) {
        Row& row = walls[cell];
        for (const CellFace& of : faces_of(cell))
            row.add(of.face, of.sign * form_.faces[of.face].area);
        form_.outflow.add(std::move(row));
    }
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
    for (Row& row : derived_)
        form_.derived.add(std::move(row));
    const auto for_each_column = [&](const auto& f) {
        for (std::vector<std::int32_t>* columns : {&form_.squares.column, &form_.derived.column})
            for (std::int32_t& column : *columns)
                f(column);
        for (auto& columns : form_.whole.columns)
            for (std::int32_t& column : columns)
                f(column);
    };
    for_each_column([&](std::int32_t column) {
        if (column >= first && column < first_derived)
            number[column - first] = 0;
    });
    std::int32_t n = 0;
    for (std::size_t k = 0; k < number.size(); ++k)
        if (number[k] == 0) {
            form_.traces[n] = form_.traces[k];
            number[k] = n++;
        }
    form_.traces.resize(n);
    const auto renumber = [&](std::int32_t& column) {
        if (column >= first && column < first_derived)
            column = first + number[column - first];
    };
    for_each_column(renumber);
    for (auto& [trace, face] : trace_face_)
        renumber(trace);
}

template <int D>
void FormBuilder<D>::close_columns()
{
    const auto close = [&](std::int32_t& column) {
        if (column >= first_moment)
            column += form_.columns() + form_.derived.rows() - first_moment;
        else if (column >= first_derived)
            column += form_.columns() - first_derived;
        else if (column < 0)
            column = form_.unknowns() - 1 - column;
    };
    for (std::vector<std::int32_t>* columns :
         {&form_.squares.column, &form_.rotation.column, &form_.outflow.column, &form_.derived.column})
        std::for_each(columns->begin(), columns->end(), close);
    for (auto& columns : form_.whole.columns)
        std::for_each(columns.begin(), columns.end(), close);
}

/// Faces by traces, as a linear function has them: in a strip along a wall a trace goes with the strip's face.
template <int D>
void FormBuilder<D>::find_beside()
{
    const std::int32_t first = form_.velocities(), last = form_.unknowns();
    std::sort(trace_face_.begin(), trace_face_.end());
    trace_face_.erase(std::unique(trace_face_.begin(), trace_face_.end()), trace_face_.end());
    std::vector<std::int64_t> begin(form_.traces.size() + 1, 0);
    const auto for_each_pair = [&](const auto& f) {
        for (const auto& columns : form_.whole.columns)
            for (int k = 0; k < UnitFace::traces; ++k)
                if (columns[k] < last)
                    f(columns[k] - first, columns[UnitFace::traces]);
        for (const auto& [trace, face] : trace_face_)
            if (trace >= first)
                f(trace - first, face);
    };
    for_each_pair([&](std::int32_t trace, std::int32_t) { ++begin[trace + 1]; });
    for (std::size_t k = 1; k < begin.size(); ++k)
        begin[k] += begin[k - 1];
    form_.beside.end = begin;
    form_.beside.column.resize(begin.back());
    form_.beside.factor.resize(begin.back());
    std::vector<std::int64_t> next(begin.begin(), begin.end() - 1);
    for_each_pair([&](std::int32_t trace, std::int32_t face) {
        Vec<D> way = form_.faces[face].centroid - form_.traces[trace].at;
        way[form_.faces[face].axis] = 0;
        for (int axis = 0; axis < D; ++axis)
            if (grid_.periodic(axis))
                way[axis] -= grid_.cells()[axis] * std::round(way[axis] / grid_.cells()[axis]);
        form_.beside.column[next[trace]] = face;
        form_.beside.factor[next[trace]++] = 1 / std::max(way.norm(), viscous_parameters.same_place);
    });
    for (std::size_t trace = 0; trace + 1 < begin.size(); ++trace) {
        const std::span<double> share = std::span(form_.beside.factor).subspan(begin[trace], begin[trace + 1] - begin[trace]);
        const double sum = std::accumulate(share.begin(), share.end(), 0.0);
        for (double& one : share)
            one /= sum;
    }
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
