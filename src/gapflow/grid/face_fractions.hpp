// How much of every grid face is open and how much of it lies in each body (method, "Face fractions"):
//
//     a_f + sum_b s_{f,b} = 1,   with the centroid of every part.
//
// Cut-cell mode clips each face exactly where surfaces cross it: by the planes of flat-faced bodies, by the discs in which balls are
// cut, else (3D) by phi taken linear on >= 2 x 2 x 2 triangles: second order (after Ng, Min & Gibou, J. Comput. Phys. 228, 2009).
// Voxel mode gives a cell to the body that holds its centre (Robinson-Mosher, Schroeder & Fedkiw, J. Comput. Phys. 230, 2011); a
// face between cells of two different bodies is half of either (the pair of virtual faces of Qiu, Yu & Fedkiw, 2015).
#pragma once

#include "gapflow/geometry/solid.hpp"
#include "gapflow/grid/field.hpp"
#include "gapflow/grid/inline_vector.hpp"

#include <memory>
#include <span>
#include <vector>

namespace gapflow {

enum class FractionMode { cut_cell, voxel };

/// The part of a face inside one solid.
template <int D>
struct SolidPart {
    int solid;       ///< index into the list of solids
    double fraction; ///< its area over that of a face of the core: in the core, the part of the face's area
    Vec<D> centroid; ///< in the world, on the face
    Vec<D> arm;      ///< centroid minus the centre of the solid's image that lies here: lever of its wrench
};

/// One face cut into its parts, in areas of a face of the core. Postcondition: open + sum of fractions = 1 (outside the core the face's
/// relative area) to round-off, open is exactly 0 below 1e-12 of the face (1e-6 beside a single solid).
template <int D>
struct ClippedFace {
    double open = 1.0;
    Vec<D> open_centroid;                ///< face centre where open = 0
    InlineVector<SolidPart<D>, 1> solid; ///< at most one part a solid image, in the order of the solids' names
};

template <int D>
struct FaceFractions;
template <int D>
struct FractionsTrace;

/// Clips single faces. A pure function of the geometry: any rank gets the same bits for any face of the grid, also outside
/// its block (along periodic axes also outside the domain: indices are wrapped, centroids are returned near the index asked for).
///
/// Faces on a closed side belong wholly to its wall; walls cut no other face. Points within 1e-6 dx of a surface count as on
/// it. A solid that is inside out has no images: it fills all that lies outside its cavity.
template <int D>
class FaceClipper {
public:
    /// The solids' shapes must outlive the clipper. Throws std::logic_error if a closed side has no wall among the solids.
    FaceClipper(const Grid<D>& grid, std::span<const Solid<D>> solids, FractionMode mode);
    ~FaceClipper();

    void clip(int axis, const Index<D>& face, ClippedFace<D>& result) const;
    /// Centroid of that connected open piece of the face that holds its deepest point (largest distance from all solids);
    /// sampled 32 (3D: 12 x 12) points a face. Only meaningful if the face has an open part.
    Vec<D> deepest_open_centroid(int axis, const Index<D>& face) const;
    /// Images of solids (walls too) whose surface, or inside, may come within `reach` of x, a point in the domain or within
    /// 4 dx of it (along periodic axes with reach at most 4 dx). Indices into images(), ascending.
    void near(const Vec<D>& x, double reach, std::vector<int>& result) const;
    /// What near() finds, with the bins that list it: around a place close by they are often the same, and it finds nothing new.
    struct Nearby {
        std::vector<int> images;
        Index<D> low, high; ///< the first and the last bin
        bool binned = false;
    };
    void near(const Vec<D>& x, double reach, Nearby& nearby) const;
    const std::vector<Image<D>>& images() const;
    /// Points within this of a surface, a length, count as on it.
    double tolerance() const;

private:
    template <int E>
    friend FaceFractions<E> face_fractions(const Grid<E>& grid, const FaceClipper<E>& clipper, const FaceFractions<E>* before);

    struct Data;
    std::unique_ptr<Data> data_;
};

/// Fractions of all faces of this rank's cells and of one ghost layer of cells around them.
template <int D>
struct FaceFractions {
    FaceField<D>
        open; ///< a_f, open area over that of a face of the core; 0 on closed sides of the domain and beyond the faces that are filled
    FaceField<D, int> cut; ///< index into `faces`, or negative: wholly open, or solid with only its solid around
    std::vector<ClippedFace<D>> faces;
    std::vector<Index<D>> surface_cells; ///< this rank's cells that a solid other than a wall touches, first axis fastest
    std::shared_ptr<const FractionsTrace<D>> trace; ///< of how they were found, for those that follow
};

/// Clips the faces within reach of a surface and fills the rest by flood: open outside, closed inside. A wholly solid face
/// that borders a cell with any open or partly solid face, or with a face in another solid, has an entry in `faces` too (it
/// belongs to that cell's boundary); so has every face on a closed side. `before`, if given: fractions of the same solids on the same
/// grid (if they are others nothing is lost but time). Bins near no solid that has moved since are taken from them, to the same bits.
template <int D>
FaceFractions<D> face_fractions(const Grid<D>& grid, const FaceClipper<D>& clipper, const FaceFractions<D>* before = nullptr);

} // namespace gapflow
