// Numbers of the columns once all are known, and what is found by them.
#include "gapflow/viscous/form_builder.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace gapflow {

/// Those that no square has, as within gaps.
template <int D>
void FormBuilder<D>::drop_unused_traces()
{
    const std::int32_t first = form_.velocities();
    std::vector<std::int32_t> number(form_.traces.size(), -1);
    const auto for_each_column = [&](const auto& f) { for_each_open_column(f); };
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

/// Of squares, derived columns and whole faces, but for the columns that are velocities alone.
template <int D>
template <class F>
void FormBuilder<D>::for_each_open_column(const F& f)
{
    std::for_each(form_.squares.column.begin(), form_.squares.column.begin() + first_flat_, f);
    std::for_each(form_.derived.column.begin(), form_.derived.column.end(), f);
    for (auto& columns : form_.whole.columns)
        std::for_each(columns.begin(), columns.begin() + UnitFace::traces, f);
}

template <int D>
void FormBuilder<D>::close_columns()
{
    const std::int32_t derived = form_.columns() - first_derived,
                       moments = form_.columns() + form_.derived.rows() - first_moment, twists = form_.unknowns() - 1;
    const auto close = [&](std::int32_t& column) {
        if (column >= first_moment)
            column += moments;
        else if (column >= first_derived)
            column += derived;
        else if (column < 0)
            column = twists - column;
    };
    for_each_open_column(close);
    for (std::vector<std::int32_t>* columns : {&form_.rotation.column, &form_.outflow.column})
        std::for_each(columns->begin(), columns->end(), close);
}

/// Faces by traces, as a linear function has them: in a strip along a wall a trace goes with the strip's face.
template <int D>
void FormBuilder<D>::find_beside()
{
    const std::int32_t first = form_.velocities(), last = form_.unknowns();
    std::vector<std::int64_t>& begin = form_.beside.end;
    begin.assign(form_.traces.size() + 1, 0);
    for (const auto& columns : form_.whole.columns)
        for (int k = 0; k < UnitFace::traces; ++k)
            if (columns[k] < last)
                ++begin[columns[k] - first + 1];
    for (const auto& [trace, face] : trace_face_)
        if (trace >= first)
            ++begin[trace - first + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    form_.beside.column.resize(begin.back());
    form_.beside.factor.resize(begin.back());
    std::vector<std::int64_t> next(begin.begin(), begin.end() - 1);
    const auto add = [&](std::int32_t trace, std::int32_t face, double share) {
        form_.beside.column[next[trace]] = face;
        form_.beside.factor[next[trace]++] = share;
    };
    for (const auto& columns : form_.whole.columns) // unit squares
        for (int k = 0; k < UnitFace::traces; ++k)
            if (columns[k] < last)
                add(columns[k] - first, columns[UnitFace::traces], k < 4 ? std::numbers::sqrt2 : 2);
    for (const auto& [trace, face] : trace_face_) {
        if (trace < first)
            continue;
        Vec<D> way = form_.faces[face].centroid - form_.traces[trace - first].at;
        way[form_.faces[face].axis] = 0;
        for (int axis = 0; axis < D; ++axis)
            if (grid_.periodic(axis))
                way[axis] -= grid_.cells()[axis] * std::round(way[axis] / grid_.cells()[axis]);
        add(trace - first, face, 1 / std::max(way.norm(), viscous_parameters.same_place));
    }
    for (std::size_t trace = 0; trace + 1 < begin.size(); ++trace) {
        const std::span<double> share = std::span(form_.beside.factor).subspan(begin[trace], begin[trace + 1] - begin[trace]);
        const double sum = std::accumulate(share.begin(), share.end(), 0.0);
        for (double& one : share)
            one /= sum;
    }
}

template void FormBuilder<2>::drop_unused_traces();
template void FormBuilder<3>::drop_unused_traces();
template void FormBuilder<2>::close_columns();
template void FormBuilder<3>::close_columns();
template void FormBuilder<2>::find_beside();
template void FormBuilder<3>::find_beside();

} // namespace gapflow
