// Cuts of faces by several solids, or by one in an uncommon way.
#pragma once

#include "gapflow/complex/cut_faces.hpp"

#include <optional>
#include <vector>

namespace gapflow {

template <int D>
class GeneralCut {
public:
    /// `faces`: with its grid.
    GeneralCut(const CutFaces<D>& faces, const GridPlanes<D>& planes, const DenseIndex<D>& index,
               const std::vector<PlacedSolid<D>>& solids, bool with_chords = false)
        : faces_(faces), planes_(planes), index_(index), solids_(solids)
    {
        square_.with_chords = with_chords;
    }

    /// `facets`: of the face's slab. Valid until the next call.
    Square& cut(const CutFace<D>& face, const FaceDetail& detail, const std::vector<std::optional<FacetCut<D>>>& facets);
    /// Of the last face: the corners of Square::corners, and the lines of Square::lines.
    const SharpCorner& corner(int k) const { return *sharp_[k]; }
    const FaceLine& line(int k) const { return lines_[k]; }

private:
    const CutFaces<D>& faces_;
    const GridPlanes<D>& planes_;
    const DenseIndex<D>& index_;
    const std::vector<PlacedSolid<D>>& solids_;
    Square square_;
    std::vector<Section> sections_;
    std::vector<const SharpCorner*> sharp_;
    std::vector<FaceLine> lines_;
};

} // namespace gapflow
