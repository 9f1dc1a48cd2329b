// Values on cells and faces of this rank's block, with ghosts.
#pragma once

#include "gapflow/core/large_memory.hpp"
#include "gapflow/core/threads.hpp"
#include "gapflow/grid/grid.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace gapflow {

/// The box of indices low <= i < high that a field stores, first axis fastest.
template <int D>
struct Block {
    Index<D> low, high;
    Index<D> stride;
    long size = 0;

    Block() = default;
    Block(const Index<D>& low_, const Index<D>& high_) : low(low_), high(high_)
    {
        size = 1;
        for (int axis = 0; axis < D; ++axis) {
            stride[axis] = static_cast<int>(size);
            size *= high[axis] - low[axis];
        }
    }
    long offset(const Index<D>& i) const { return (i - low).dot(stride); }
    bool contains(const Index<D>& i) const { return (i.array() >= low.array()).all() && (i.array() < high.array()).all(); }
};

/// Calls f(index) for every index of the box low <= i < high, first axis fastest.
template <int D, class F>
void for_each_index(const Index<D>& low, const Index<D>& high, F&& f)
{
    Index<D> i;
    if constexpr (D == 3) {
        for (i[2] = low[2]; i[2] < high[2]; ++i[2])
            for (i[1] = low[1]; i[1] < high[1]; ++i[1])
                for (i[0] = low[0]; i[0] < high[0]; ++i[0])
                    f(static_cast<const Index<D>&>(i));
    } else {
        for (i[1] = low[1]; i[1] < high[1]; ++i[1])
            for (i[0] = low[0]; i[0] < high[0]; ++i[0])
                f(static_cast<const Index<D>&>(i));
    }
}

/// Calls f(index of the row's first cell) for every row along the first axis of the box low <= i < high.
template <int D, class F>
void for_each_row(const Index<D>& low, const Index<D>& high, F&& f)
{
    Index<D> end = high;
    end[0] = low[0] + 1;
    for_each_index<D>(low, end, f);
}

/// The same for the rows whose last index is `plane`.
template <int D, class F>
void for_each_row_of_plane(Index<D> low, Index<D> high, int plane, F&& f)
{
    low[D - 1] = plane;
    high[D - 1] = plane + 1;
    for_each_row<D>(low, high, f);
}

/// The same for all rows, planes of the last index shared out over threads.
template <int D, class F>
void for_each_row_on_threads(const Index<D>& low, const Index<D>& high, F&& f)
{
    for_each_plane(low[D - 1], high[D - 1], [&](int plane) { for_each_row_of_plane<D>(low, high, plane, f); });
}

/// One value for each cell, on owned cells and `ghost` layers around them.
template <int D, class T = double>
class CellField {
public:
    CellField() = default;
    explicit CellField(const Grid<D>& grid, T value = T{})
        : block_(grid.low() - Index<D>::Constant(grid.ghost()), grid.high() + Index<D>::Constant(grid.ghost())),
          values_(block_.size, value)
    {
    }
    const Block<D>& block() const { return block_; }
    T& operator()(const Index<D>& c) { return values_[block_.offset(c)]; }
    const T& operator()(const Index<D>& c) const { return values_[block_.offset(c)]; }
    T* data() { return values_.data(); }
    const T* data() const { return values_.data(); }
    long size() const { return block_.size; }
    void fill(T value) { std::fill(values_.begin(), values_.end(), value); }

private:
    Block<D> block_;
    LargeVector<T> values_;
};

/// One value for each face: one CellField per axis; entry c of axis `a` is the face of cell c on its low side along a.
/// A rank owns the faces c of its cells c, and the last rank of a non-periodic axis the faces on the high side of the domain.
template <int D, class T = double>
class FaceField {
public:
    FaceField() = default;
    explicit FaceField(const Grid<D>& grid, T value = T{})
    {
        for (auto& component : components_)
            component = CellField<D, T>(grid, value);
    }
    CellField<D, T>& operator[](int axis) { return components_[axis]; }
    const CellField<D, T>& operator[](int axis) const { return components_[axis]; }
    T& operator()(int axis, const Index<D>& face) { return components_[axis](face); }
    const T& operator()(int axis, const Index<D>& face) const { return components_[axis](face); }

private:
    std::array<CellField<D, T>, D> components_;
};

/// Calls f(index) for every entry of the box low <= i < high that is at least `least`, first axis fastest; rows without one cost
/// a pass over their bytes.
template <int D, class F>
void for_each_marked(const CellField<D, std::int8_t>& field, const Index<D>& low, const Index<D>& high, std::int8_t least,
                     F&& f)
{
    const int n = high[0] - low[0];
    for_each_row<D>(low, high, [&](const Index<D>& row) {
        const std::int8_t* value = &field(row);
        std::int8_t largest = std::numeric_limits<std::int8_t>::min();
        for (int i = 0; i < n; ++i)
            largest = std::max(largest, value[i]);
        if (largest < least)
            return;
        Index<D> at = row;
        for (int i = 0; i < n; ++i, ++at[0])
            if (value[i] >= least)
                f(static_cast<const Index<D>&>(at));
    });
}

/// Fills the ghosts that other ranks own (also across periodic sides), to the depth of `layers` (default: all). Ghosts
/// beyond walls, open and inflow sides stay unchanged. Collective. For face fields the domain's last faces are included.
template <int D, class T>
void exchange(const Grid<D>& grid, CellField<D, T>& field, int layers = -1);
template <int D, class T>
void exchange(const Grid<D>& grid, FaceField<D, T>& field, int layers = -1);

/// Index after the last owned face normal to `axis`: high(), and one more along the axis on the last rank of an axis that is
/// not periodic.
template <int D>
Index<D> owned_faces_end(const Grid<D>& grid, int axis)
{
    Index<D> end = grid.high();
    if (!grid.periodic(axis) && end[axis] == grid.cells()[axis])
        ++end[axis];
    return end;
}

/// Whether a face normal to `axis` is this rank's.
template <int D>
bool owns_face(const Grid<D>& grid, int axis, const Index<D>& face)
{
    return (face.array() >= grid.low().array()).all() && (face.array() < owned_faces_end(grid, axis).array()).all();
}

/// Calls f(first, n, above, below) for rows of n faces normal to `axis`, from the face grid.low() to before `end` (owned_faces_end() or one plane
/// more), rows inside the domain on threads. above, below: 1 where a cell lies on that side of the faces, 0 beyond a side of the domain.
template <int D, class F>
void for_each_face_row(const Grid<D>& grid, int axis, const Index<D>& end, F&& f)
{
    Index<D> low = grid.low(), high = end;
    for (int side = 0; side < 2; ++side) {
        const int place = side * grid.cells()[axis];
        if (grid.periodic(axis) || (side ? end[axis] - 1 : grid.low()[axis]) != place)
            continue;
        Index<D> first = grid.low(), last = end;
        first[axis] = place;
        last[axis] = place + 1;
        for_each_row<D>(first, last, [&](const Index<D>& row) { f(row, last[0] - first[0], 1 - side, side); });
        (side ? high : low)[axis] += side ? -1 : 1;
    }
    for_each_row_on_threads<D>(low, high, [&](const Index<D>& row) { f(row, high[0] - low[0], 1, 1); });
}

} // namespace gapflow
