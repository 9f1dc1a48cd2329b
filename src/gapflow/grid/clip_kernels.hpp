// Clipping one face of unit size by a few solids: segments in 2D, squares in 3D. Private to grid/.
#pragma once

#include "gapflow/geometry/solid.hpp"

#include <span>
#include <vector>

namespace gapflow {

/// A solid that cuts a face: by its planes (in the world) if it has any, else by its distance; spheres in 3D by the disc in which the
/// face's plane cuts them, unless they overlap others.
template <int D>
struct Cutter {
    const PlacedShape<D>* shape;
    std::span<const Plane<D>> planes;
    bool complement; ///< the solid is outside the planes' intersection
};

/// Measure and first moment of one part of a face; in units of the face, if not said otherwise: coordinate i in [0, 1] runs along tangent i.
template <int D>
struct PartSum {
    using Local = Eigen::Matrix<double, D - 1, 1>;
    double measure = 0;
    Local moment = Local::Zero();

    void add(double m, const Local& centroid)
    {
        measure += m;
        moment += m * centroid;
    }
    PartSum& operator+=(const PartSum& other)
    {
        measure += other.measure;
        moment += other.moment;
        return *this;
    }
    PartSum& operator-=(const PartSum& other)
    {
        measure -= other.measure;
        moment -= other.moment;
        return *this;
    }
};

template <int D>
struct FaceSums {
    PartSum<D> open;
    std::vector<PartSum<D>> solid; ///< one for each cutter

    void reset(std::size_t cutters)
    {
        open = {};
        solid.assign(cutters, PartSum<D>{});
    }
};

/// Parts of the face with low corner `corner` and the given edges along `tangents`. Points within `tolerance` of a surface are on
/// it; points in several solids belong to the one with the smallest distance, ties to the first cutter. At most 64 cutters.
void clip_face(const Vec<2>& corner, const std::array<double, 1>& edges, const std::array<int, 1>& tangents,
               std::span<const Cutter<2>> cutters, double tolerance, FaceSums<2>& sums);
void clip_face(const Vec<3>& corner, const std::array<double, 2>& edges, const std::array<int, 2>& tangents,
               std::span<const Cutter<3>> cutters, double tolerance, FaceSums<3>& sums);

} // namespace gapflow
