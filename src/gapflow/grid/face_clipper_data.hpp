// Data of a FaceClipper. Private to grid/.
#pragma once

#include "gapflow/grid/clip_kernels.hpp"
#include "gapflow/grid/face_fractions.hpp"
#include "gapflow/grid/image_bins.hpp"

#include <array>

namespace gapflow {

template <int D>
struct FaceClipper<D>::Data {
    Data(const Grid<D>& grid_, std::span<const Solid<D>> solids, FractionMode mode_);

    Grid<D> grid;
    FractionMode mode;
    double tolerance; ///< points within it of a surface are on it
    std::vector<Image<D>> images;
    std::vector<Vec<D>> centres;               ///< of the images' solids
    std::vector<std::vector<Plane<D>>> planes; ///< of the images, in the world
    std::vector<int> rank;                     ///< of the images: order of the solids' names (ties)
    std::vector<char> wall;                    ///< is the image a wall?
    std::array<int, 2 * D> wall_of_side;       ///< image of the wall on each side, or -1
    ImageBins<D> bins;

    /// Image of the wall that owns this face (an index wrapped into the domain), or -1.
    int wall_at(int axis, const Index<D>& face) const
    {
        if (grid.periodic(axis) || (face[axis] != 0 && face[axis] != grid.cells()[axis]))
            return -1;
        return wall_of_side[2 * axis + (face[axis] != 0)];
    }
    std::span<const int> images_at(const Index<D>& cell) const { return bins.images_in(bins.bin_of(cell)); }

    /// Cuts a face; returns the image that holds all of it, else -1.
    int clip(int axis, const Index<D>& face, ClippedFace<D>& result) const;

private:
    int clip_cut_cell(int axis, const Index<D>& face, ClippedFace<D>& result) const;
    int clip_voxel(int axis, const Index<D>& face, ClippedFace<D>& result) const;
    int owner_of_cell(const Index<D>& cell) const;
    int crossed_between(int axis, const Index<D>& face) const;
    void add_part(int image, double fraction, const Vec<D>& centroid, ClippedFace<D>& result) const;
    bool nearer(double phi_a, int a, double phi_b, int b) const;
};

} // namespace gapflow
