// The grid's faces near films, other ranks' too.
#pragma once

#include "gapflow/film/key_map.hpp"
#include "gapflow/grid/face_fractions.hpp"

#include <deque>
#include <mutex>
#include <span>

namespace gapflow {

/// The grid's clipped faces for the films: any face of the domain, the same on every rank. Indices may lie outside the domain along
/// periodic axes. Threads may ask at once.
template <int D>
class FaceCache {
public:
    /// `fractions`: of this rank's faces; other ranks' are clipped when first asked for. All arguments must outlive it.
    FaceCache(const Grid<D>& grid, const FaceClipper<D>& clipper, std::span<const Solid<D>> solids,
              const FaceFractions<D>& fractions)
        : grid_(&grid), clipper_(&clipper), solids_(solids), fractions_(&fractions)
    {
    }

    double open(int axis, const Index<D>& f) const;
    /// Parts in solids, at the index stored (see displacement()). May be none for a face that lies wholly in one solid and
    /// whose cells do too.
    std::span<const SolidPart<D>> parts(int axis, const Index<D>& f) const;
    /// Centroid of the open part, next to the requested index.
    Vec<D> open_centroid(int axis, const Index<D>& f) const;
    /// A representative point of the open part, next to the requested index: the centroid, where that lies in no solid, nor on one, and the
    /// solids are too thick to divide a face, else the centroid of the open piece that contains the face's deepest point.
    Vec<D> open_point(int axis, const Index<D>& f) const;
    /// Displacement of the requested index from the stored one.
    Vec<D> displacement(const Index<D>& f) const;
    long key(int axis, const Index<D>& f) const;
    const Grid<D>& grid() const { return *grid_; }

private:
    bool mine(int axis, const Index<D>& stored) const;
    const ClippedFace<D>& clipped(int axis, const Index<D>& stored) const;
    bool centroid_stands(std::span<const SolidPart<D>> parts, const Vec<D>& centroid) const;

    const Grid<D>* grid_;
    const FaceClipper<D>* clipper_;
    std::span<const Solid<D>> solids_;
    const FaceFractions<D>* fractions_;
    mutable std::mutex mutex_;    ///< of what follows
    mutable KeyMap<int> numbers_; ///< of other ranks' faces in faces_
    mutable std::deque<ClippedFace<D>> faces_;
    mutable KeyMap<Vec<D>> open_points_;
};

} // namespace gapflow
