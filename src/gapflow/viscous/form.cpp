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
    std::vector<double> all;
    find_derived(x, all);
    std::vector<double> by(all.size(), 0.0);
    lattice.add_product(all, by);
    squares.add_product(all, by);
    whole.add_product(all, std::span<const double>(by).subspan(columns() + derived.rows()), by);
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
    find_widths();
    for (int axis = 0; axis < D; ++axis)
        vertex_trace_[axis].assign(index_.count, -1);
}

template <int D>
ViscousForm<D> FormBuilder<D>::build()
{
    form_.cells = find_fluid_cells(grid_, complex_);
    find_walls();
    find_faces();
    find_borders();
    find_gaps();
    find_lattice();
    find_uneven_cells();
    element_.assign(form_.faces.size(), -1);
    const auto faces = static_cast<std::int32_t>(form_.faces.size());
    form_.traces.reserve(3 * (faces - std::ranges::count(compact_, 1))); // an estimate
    for (std::int32_t face = 0; face < faces; ++face)
        if (!compact_[face] || !regular_[face]) {
            if (compact_[face])
                add_at_sides(face);
            else
                add_face(face);
            form_.row_face.resize(form_.squares.rows(), face);
        }
    for (std::int32_t cell = 0; cell < cut_cells(); ++cell)
        add_along(cell);
    for (const UnevenCell& of : uneven_cells_) {
        if constexpr (D == 3)
            if (add_whole_along(of))
                continue;
        add_along(of.cell);
    }
    const std::int64_t first_of_gaps = form_.squares.rows();
    form_.row_face.resize(first_of_gaps, -1);
    add_gaps();
    form_.gap_rows = {first_of_gaps, form_.squares.rows()};
    add_flat_rows();
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

/// Columns of twists are numbered from -1 down until all traces are known.
template <int D>
Row FormBuilder<D>::of_solid(std::int32_t solid, const Vec<D>& x, int component) const
{
    Terms terms;
    add_solid(solid, x, component, 1, terms);
    Row row;
    for (const Term& term : terms)
        row.add(term.column, term.factor);
    return row;
}

template <int D>
void FormBuilder<D>::add_solid(std::int32_t solid, const Vec<D>& x, int component, double factor, Terms& to) const
{
    add_twist(solid, wrench<D>(unit<D>(component), arm(solid, x)), factor, to);
}

template <int D>
void FormBuilder<D>::add_twist(std::int32_t solid, const Twist<D>& twist, double factor, Terms& to)
{
    for (int k = 0; k < twist_size<D>; ++k)
        if (twist[k] != 0)
            to.push_back({-1 - twist_size<D> * solid - k, factor * twist[k]});
}

template <int D>
void FormBuilder<D>::add_point(const BorderPoint<D>& point, int component, double factor, Terms& to)
{
    if (point.solid >= 0)
        add_solid(point.solid, point.at, component, factor, to);
    else if (point.vertex >= 0)
        add_vertex(point.vertex, component, factor, to);
    else
        to.push_back({new_trace(component, point.at), factor});
}

void add(std::span<const Term> terms, RowList& to)
{
    for (const Term& term : terms) {
        to.column.push_back(term.column);
        to.factor.push_back(term.factor);
    }
    to.end.push_back(static_cast<std::int64_t>(to.column.size()));
}

template <int D>
void FormBuilder<D>::add_row(double weight, Terms& row)
{
    merge(row);
    add_terms(weight, row);
}

template <int D>
void FormBuilder<D>::add_terms(double weight, std::span<const Term> terms)
{
    SquareSum& to = form_.squares;
    if (weight == 0 || terms.empty())
        return;
    for (const Term& term : terms) {
        to.column.push_back(term.column);
        to.factor.push_back(term.factor);
    }
    to.weight.push_back(weight);
    to.end.push_back(static_cast<std::int64_t>(to.column.size()));
}

template <int D>
void FormBuilder<D>::add_row(double weight, std::span<const std::int32_t> columns, std::span<const double> factors)
{
    if (weight == 0)
        return;
    SquareSum& to = form_.squares;
    const bool zero = std::ranges::find(factors, 0.0) != factors.end();
    if (zero)
        return to.add(weight, columns, factors);
    to.column.insert(to.column.end(), columns.begin(), columns.end());
    to.factor.insert(to.factor.end(), factors.begin(), factors.end());
    to.weight.push_back(weight);
    to.end.push_back(static_cast<std::int64_t>(to.column.size()));
}

template <int D>
void FormBuilder<D>::add_between(int component, int across, const Index<D>& high, double factor, Terms& to) const
{
    std::array<std::int32_t, 4> face;
    std::array<double, 4> width;
    for (int k = 0; k < 4; ++k) {
        const Index<D> g = index_.wrapped(Index<D>(high + (k - 2) * step<D>(across)));
        face[k] = whole_face_at(component, g);
        width[k] = face[k] < 0 ? 0 : width_[across][g[across] - index_.low[across]];
    }
    const bool uniform = std::abs(width[0] - width[1]) + std::abs(width[3] - width[2]) + std::abs(width[2] - width[1]) < 1e-9;
    if (uniform) // half way between mean and cubic interpolation: the dissipation of a linear shear stress is exact
        for (int k = 0; k < 4; ++k)
            to.push_back({face[k], factor * (k == 1 || k == 2 ? 13.0 / 24 : -1.0 / 24)});
    else {
        to.push_back({face[1], factor * width[2] / (width[1] + width[2])});
        to.push_back({face[2], factor * width[1] / (width[1] + width[2])});
    }
}

template <int D>
void FormBuilder<D>::add_outflow()
{
    std::vector<Terms> walls(cut_cells());
    for (int part = 0; part < complex_.parts(); ++part)
        for (const WallPatch<D>& patch : complex_.patches_of(part)) {
            Terms& row = walls[form_.cells.of_part[part]];
            const std::int32_t first = -1 - twist_size<D> * patch.solid;
            for (int k = 0; k < D; ++k)
                row.push_back({first - k, patch.area[k]});
            for (int k = 0; k < spin_size<D>; ++k)
                row.push_back({first - D - k, patch.moment[k]});
        }
    RowList& rows = form_.outflow;
    const std::size_t about = 2 * D * static_cast<std::size_t>(form_.cells.count());
    rows.column.reserve(about);
    rows.factor.reserve(about);
    rows.end.reserve(form_.cells.count() + 1);
    const auto add = [&](std::int32_t cell) {
        terms_.clear();
        if (cell < cut_cells())
            terms_ = walls[cell];
        for (const CellFace& of : faces_of(cell))
            terms_.push_back({of.face, of.sign * form_.faces[of.face].area});
        merge(terms_);
        gapflow::add(terms_, rows);
    };
    for (std::int32_t cell = 0; cell < cut_cells(); ++cell)
        add(cell);
    add_flat_outflow(add);
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
