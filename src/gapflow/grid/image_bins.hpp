// Which images of solids may touch each block of a few cells. Private to grid/.
#pragma once

#include "gapflow/geometry/solid.hpp"
#include "gapflow/grid/field.hpp"

#include <span>
#include <vector>

namespace gapflow {

/// Bins of cells over the domain and a margin around it. A bin lists, in ascending order, every image whose solid meets it
/// (perhaps others close by): found by halving the domain and dropping an image where |phi| is 1-Lipschitz and so cannot
/// reach 0, which costs little for thousands of small solids as for a few large ones.
template <int D>
class ImageBins {
public:
    /// Cells around the domain: as far as most rays of the viscous step look from a face on its sides.
    static constexpr int margin = 12;

    ImageBins() = default;
    ImageBins(const Grid<D>& grid, const std::vector<Image<D>>& images);

    int width() const { return width_; }
    /// Bin of a cell within the margin.
    Index<D> bin_of(const Index<D>& cell) const
    {
        Index<D> bin;
        for (int axis = 0; axis < D; ++axis)
            bin[axis] = (cell[axis] + padding_) / width_;
        return bin;
    }
    /// First cell of a bin.
    Index<D> first_cell(const Index<D>& bin) const { return width_ * bin - Index<D>::Constant(padding_); }
    const Block<D>& bins() const { return bins_; }
    std::span<const int> images_in(const Index<D>& bin) const
    {
        const Span& span = spans_[bins_.offset(bin)];
        return {items_.data() + span.first, static_cast<std::size_t>(span.count)};
    }

private:
    struct Span {
        int first = 0, count = 0;
    };

    void fill(const Grid<D>& grid, const std::vector<Image<D>>& images, const Index<D>& low, const Index<D>& high,
              std::vector<int>& candidates, std::size_t begin);

    int width_ = 4, padding_ = 4;
    Block<D> bins_;
    std::vector<Span> spans_;
    std::vector<int> items_;
};

} // namespace gapflow
