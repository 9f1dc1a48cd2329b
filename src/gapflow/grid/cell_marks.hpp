// Marks on the cells of a box, for what lies near some of them.
#pragma once

#include "gapflow/grid/field.hpp"

#include <vector>

namespace gapflow {

/// Marks on the cells of a box.
template <int D>
class CellMarks {
public:
    CellMarks(const Index<D>& low, const Index<D>& high) : block_(low, high), marks_(block_.size, 0) {}

    bool operator()(const Index<D>& cell) const { return marks_[block_.offset(cell)]; }
    /// The marks from a cell on, along the first axis.
    const char* row(const Index<D>& cell) const { return &marks_[block_.offset(cell)]; }
    /// Marks a cell of the domain and its periodic images, as far as they lie in the box.
    void set_images(const Grid<D>& grid, const Index<D>& cell)
    {
        Index<D> first = Index<D>::Zero(), last = Index<D>::Zero(); // periods
        for (int axis = 0; axis < D; ++axis)
            if (grid.periodic(axis)) {
                const int n = grid.cells()[axis];
                first[axis] = -((cell[axis] - block_.low[axis]) / n);
                last[axis] = (block_.high[axis] - 1 - cell[axis]) / n;
            }
        for_each_index<D>(first, last + Index<D>::Ones(), [&](const Index<D>& periods) {
            if (const Index<D> image = cell + periods.cwiseProduct(grid.cells()); block_.contains(image))
                marks_[block_.offset(image)] = 1;
        });
    }
    /// Marks the cells up to so many away along an axis, too.
    void spread(int axis, int distance)
    {
        const std::vector<char> before = marks_;
        const long stride = block_.stride[axis], slab = stride * (block_.high[axis] - block_.low[axis]);
        for (long from = 0; from < block_.size; from += slab) // planes across the axis follow each other in a slab
            for (long d = stride; d <= distance * stride && d < slab; d += stride)
                for (long i = from; i < from + slab - d; ++i) {
                    marks_[i] |= before[i + d];
                    marks_[i + d] |= before[i];
                }
    }

private:
    Block<D> block_;
    std::vector<char> marks_;
};

} // namespace gapflow
