// Thin bodies given by their middle surface.
#pragma once

#include "gapflow/core/error.hpp"
#include "gapflow/geometry/shape.hpp"

#include <string>
#include <vector>

namespace gapflow {

/// Why a middle surface and a thickness make no solid.
class SheetError : public InputError {
public:
    SheetError(bool of_thickness, const std::string& problem, const std::string& remedy)
        : InputError(problem + "; " + remedy), of_thickness(of_thickness), problem(problem), remedy(remedy)
    {
    }
    bool of_thickness; ///< false: of the middle surface
    std::string problem, remedy;
};

/// A polyline of two points or more; the last one may be the first: a ring.
SurfaceMesh<2> polyline(const std::vector<Vec<2>>& points);

/// The closed surface of a sheet: the middle surface moved by half the thickness to both sides. Where facets meet at an angle both sides are mitred:
/// a vertex moves so that it lies at half the thickness from the planes of the facets around it (with more than D planes: in the mean of squares,
/// weighted with the facets' angles). Rims are flat, at right angles to the middle surface. A middle surface without a rim gives a shell.
/// Vertices within 1e-6 of the size are one; facets may be oriented in any way. Throws SheetError where the middle surface branches, is one-sided or
/// cuts itself, and where the thickness is too large for its bends; facets are named by `lines` (one for each facet, or empty), else from 0.
template <int D>
SurfaceMesh<D> sheet_surface(SurfaceMesh<D> middle, double thickness, const std::vector<int>& lines = {});

} // namespace gapflow
