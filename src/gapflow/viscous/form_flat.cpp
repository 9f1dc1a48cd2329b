// Rows of the compact lattice, most of a large form: differences of two velocities, found line by line of the grid.
#include "gapflow/viscous/form_builder.hpp"

#include "gapflow/grid/field.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace gapflow {

void FlatRows::put()
{
    std::int64_t last = squares_.end.back();
    squares_.weight.insert(squares_.weight.end(), weight_.begin(), weight_.begin() + n_);
    squares_.column.insert(squares_.column.end(), column_.begin(), column_.begin() + 2 * n_);
    squares_.factor.insert(squares_.factor.end(), factor_.begin(), factor_.begin() + 2 * n_);
    row_face_.insert(row_face_.end(), face_.begin(), face_.begin() + n_);
    for (int k = 0; k < n_; ++k)
        squares_.end.push_back(last += 2);
    n_ = 0;
}

/// Of faces in a row that are in no run, with those beside them. Across a closed side there are other rows.
template <int D>
void FormBuilder<D>::add_compact(int axis, const Index<D>& row, FlatRows& rows) const
{
    const Index<D> end = index_.faces_end(axis);
    const std::int32_t* here = &whole_face_[axis][index_(row)];
    std::array<std::array<const std::int32_t*, 2>, D> beside{}; // rows; nothing along the first axis
    for (int a = 1; a < D; ++a)
        for (int side = 0; side < 2 && a != axis; ++side) {
            const Index<D> g = index_.wrapped(Index<D>(row + (side ? 1 : -1) * step<D>(a)));
            if (g[a] >= index_.low[a] && g[a] < end[a])
                beside[a][side] = &whole_face_[axis][index_(g)];
        }
    const int n = end[0] - row[0];
    Index<D> f = row;
    for (int i = 0; i < n; ++i, ++f[0]) {
        const std::int32_t number = here[i];
        if (number < 0 || !compact_[number] || regular_[number])
            continue;
        const double length = spread_[axis][f[axis] - index_.low[axis]];
        for (int a = 0; a < D; ++a) {
            if (a == axis || cells_to_side(form_.faces[number], a).first < 2)
                continue;
            double across = length;
            for (int other = 0; other < D; ++other)
                across *= other == axis || other == a ? 1.0 : width_[other][f[other] - index_.low[other]];
            for (int side = 0; side < 2; ++side) {
                std::int32_t other = -1;
                if (a > 0)
                    other = beside[a][side] ? beside[a][side][i] : -1;
                else if (side ? i + 1 < n : i > 0)
                    other = here[side ? i + 1 : i - 1];
                else if (index_.wraps[0])
                    other = here[side ? 0 : n - 1];
                // Half of it is that of the face beyond, by its row or by its element.
                if (other >= 0 && !regular_[other])
                    rows.add(number, across * between_[a][f[a] - index_.low[a] + side], {number, 1}, {other, -1});
            }
        }
    }
}

/// f(cell, its place, its faces by axis and side, whether one is compact, whether there are all) for the whole cells in a row.
template <int D>
template <class F>
void FormBuilder<D>::for_each_whole_cell(const Index<D>& row, const F& f) const
{
    const int first = index_(row), n = index_.size[0] - 1;
    std::array<const std::int32_t*, D> low, high;
    for (int d = 0; d < D; ++d) {
        low[d] = &whole_face_[d][first];
        high[d] = d == 0 ? low[d] + 1 : &whole_face_[d][index_(index_.wrapped(Index<D>(row + step<D>(d))))];
    }
    Index<D> c = row;
    for (int i = 0; i < n; ++i, ++c[0]) {
        const std::int32_t cell = form_.cells.of_whole[first + i];
        if (cell < 0)
            continue;
        std::array<std::array<std::int32_t, 2>, D> face;
        bool compact = false, all = true;
        for (int d = 0; d < D; ++d)
            for (int side = 0; side < 2; ++side) {
                const bool around = d == 0 && side && i + 1 == n && index_.wraps[0];
                const std::int32_t of = face[d][side] = around ? low[0][0] : (side ? high : low)[d][i];
                all = all && of >= 0;
                compact = compact || (of >= 0 && compact_[of]);
            }
        f(cell, static_cast<const Index<D>&>(c), face, compact, all);
    }
}

/// Whole cells with rows of their own; rows of those beside the compact lattice that lack a whole face.
template <int D>
void FormBuilder<D>::find_uneven_cells()
{
    for_each_row<D>(index_.low, index_.high(), [&](const Index<D>& row) {
        for_each_whole_cell(row, [&](std::int32_t cell, const Index<D>&, const auto& face, bool compact, bool all) {
            if (!compact)
                uneven_cells_.push_back({cell, face});
            else if (!all)
                add_plain_along(cell, faces_of(cell));
        });
    });
    form_.row_face.resize(form_.squares.rows(), -1);
}

/// V (mean of d_d u_d)^2 of whole cells in a row, of those beside the compact lattice.
template <int D>
void FormBuilder<D>::add_plain(const Index<D>& row, FlatRows& rows) const
{
    for_each_whole_cell(row, [&](std::int32_t, const Index<D>& c, const auto& face, bool compact, bool all) {
        if (!compact || !all)
            return;
        double volume = 1;
        std::array<double, D> width;
        for (int d = 0; d < D; ++d)
            volume *= width[d] = width_[d][c[d] - index_.low[d]];
        for (int d = 0; d < D; ++d)
            if (!regular_[face[d][0]] && !regular_[face[d][1]])
                rows.add(-1, 1 / volume, {face[d][0], -volume / width[d]}, {face[d][1], volume / width[d]});
    });
}

template <int D>
void FormBuilder<D>::find_widths()
{
    for (int axis = 0; axis < D; ++axis) {
        const int low = index_.low[axis], high = index_.high()[axis];
        for (int i = low; i < high; ++i) {
            width_[axis].push_back(planes_.place[axis][i + 1] - planes_.place[axis][i]);
            centre_[axis].push_back(planes_.centre_of(axis, i));
        }
        const std::vector<double>& width = width_[axis];
        for (std::size_t i = 0; i <= width.size(); ++i) {
            between_[axis].push_back(1 / (width[i > 0 ? i - 1 : width.size() - 1] + width[i < width.size() ? i : 0]));
            Index<D> f = index_.low;
            f[axis] += static_cast<int>(i);
            spread_[axis].push_back(length_of(axis, f));
        }
    }
}

/// All rows of two velocities in the compact lattice.
template <int D>
void FormBuilder<D>::add_flat_rows()
{
    const std::int64_t faces = std::ranges::count(compact_, 1) - std::ranges::count(regular_, 1),
                       cells = form_.cells.count() - cut_cells() - std::ssize(uneven_cells_),
                       more = std::min(2 * (D - 1) * faces + D * cells, 3 * D * faces);
    SquareSum& squares = form_.squares;
    squares.weight.reserve(squares.weight.size() + more);
    squares.end.reserve(squares.end.size() + more);
    squares.column.reserve(squares.column.size() + 2 * more);
    squares.factor.reserve(squares.factor.size() + 2 * more);
    form_.row_face.reserve(form_.row_face.size() + more);
    first_flat_ = static_cast<std::int64_t>(squares.column.size());
    FlatRows rows(squares, form_.row_face);
    for (int axis = 0; axis < D; ++axis)
        for_each_row<D>(index_.low, index_.faces_end(axis), [&](const Index<D>& row) { add_compact(axis, row, rows); });
    for_each_row<D>(index_.low, index_.high(), [&](const Index<D>& row) { add_plain(row, rows); });
}

/// Of whole cells, those between others than whole faces by add(cell).
template <int D>
void FormBuilder<D>::add_flat_outflow(const std::function<void(std::int32_t)>& add)
{
    RowList& rows = form_.outflow;
    for_each_row<D>(index_.low, index_.high(), [&](const Index<D>& row) {
        for_each_whole_cell(row, [&](std::int32_t cell, const Index<D>& c, const auto& face, bool, bool all) {
            for (int d = 0; d < D; ++d)
                all = all && face[d][0] != face[d][1];
            if (!all)
                return add(cell);
            std::array<std::int32_t, 2 * D> column;
            std::array<double, 2 * D> factor;
            for (int d = 0; d < D; ++d) {
                double area = 1;
                for (int k = 0; k < D; ++k)
                    area *= k == d ? 1.0 : width_[k][c[k] - index_.low[k]];
                column[2 * d] = face[d][0];
                column[2 * d + 1] = face[d][1];
                factor[2 * d] = -area;
                factor[2 * d + 1] = area;
            }
            rows.column.insert(rows.column.end(), column.begin(), column.end());
            rows.factor.insert(rows.factor.end(), factor.begin(), factor.end());
            rows.end.push_back(rows.end.back() + 2 * D);
        });
    });
}

/// V (mean of d_d u_d)^2 of any cell.
template <int D>
void FormBuilder<D>::add_plain_along(std::int32_t cell, const CellFaces& faces)
{
    const double volume = shape_of(cell).volume;
    for (int d = 0; d < D; ++d) {
        Row row;
        for (const CellFace& of : faces)
            if (form_.faces[of.face].axis == d)
                row.add(of.face, of.sign * form_.faces[of.face].area);
        form_.squares.add(1 / volume, std::move(row));
    }
}

template void FormBuilder<2>::find_widths();
template void FormBuilder<3>::find_widths();
template void FormBuilder<2>::find_uneven_cells();
template void FormBuilder<3>::find_uneven_cells();
template void FormBuilder<2>::add_flat_outflow(const std::function<void(std::int32_t)>&);
template void FormBuilder<3>::add_flat_outflow(const std::function<void(std::int32_t)>&);
template void FormBuilder<2>::add_flat_rows();
template void FormBuilder<3>::add_flat_rows();

} // namespace gapflow
