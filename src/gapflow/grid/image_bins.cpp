#include "gapflow/grid/image_bins.hpp"

#include <algorithm>

namespace gapflow {

template <int D>
ImageBins<D>::ImageBins(const Grid<D>& grid, const std::vector<Image<D>>& images)
{
    if (grid.cells().template cast<double>().prod() > 3e7)
        width_ = 8;
    padding_ = (margin + width_ - 1) / width_ * width_; // whole bins
    const Index<D> cells = grid.cells() + Index<D>::Constant(padding_ + margin + width_ - 1);
    bins_ = Block<D>(Index<D>::Zero(), cells / width_);
    spans_.resize(bins_.size);
    std::vector<int> candidates(images.size());
    for (std::size_t i = 0; i < images.size(); ++i)
        candidates[i] = static_cast<int>(i);
    fill(grid, images, bins_.low, bins_.high, candidates, 0);
}

// Lists the candidates from `begin` on in the bins low..high. Leaves `candidates` as it was.
template <int D>
void ImageBins<D>::fill(const Grid<D>& grid, const std::vector<Image<D>>& images, const Index<D>& low, const Index<D>& high,
                        std::vector<int>& candidates, std::size_t begin)
{
    const double tolerance = 1e-6 * grid.dx();
    const Vec<D> low_corner = grid.corner(first_cell(low));
    const Vec<D> high_corner = grid.corner(first_cell(high));
    const Vec<D> centre = 0.5 * (low_corner + high_corner);
    const double radius = 0.5 * (high_corner - low_corner).norm() + tolerance;
    const std::size_t end = candidates.size();
    for (std::size_t k = begin; k < end; ++k) {
        const Image<D>& image = images[candidates[k]];
        const bool outside = ((image.bounds.low.array() > high_corner.array() + tolerance) ||
                              (image.bounds.high.array() < low_corner.array() - tolerance))
                                 .any();
        if (outside && !image.shape.shape().inside_out() && image.bounds.low.allFinite())
            continue;
        if (image.shape.distance(centre) <= radius)
            candidates.push_back(candidates[k]);
    }
    const Index<D> extent = high - low;
    if (candidates.size() > end && (extent.array() == 1).all()) {
        spans_[bins_.offset(low)] = {static_cast<int>(items_.size()), static_cast<int>(candidates.size() - end)};
        items_.insert(items_.end(), candidates.begin() + static_cast<long>(end), candidates.end());
    } else if (candidates.size() > end) {
        const Index<D> middle = low + (extent + Index<D>::Ones()) / 2;
        for (int part = 0; part < 1 << D; ++part) {
            Index<D> from, to;
            for (int axis = 0; axis < D; ++axis) {
                const bool upper = part >> axis & 1;
                from[axis] = upper ? middle[axis] : low[axis];
                to[axis] = upper ? high[axis] : middle[axis];
            }
            if ((from.array() < to.array()).all())
                fill(grid, images, from, to, candidates, end);
        }
    }
    candidates.resize(end);
}

template class ImageBins<2>;
template class ImageBins<3>;

} // namespace gapflow
