// The element of a face in space: int |grad u|^2 over a polygon of a function that is known by its values at the ends and middles of the sides and by its mean.
//
// Its projection Pi u on quadratic functions q, int grad q . grad Pi u = boundary int u d_n q - (lap q) A mean u, is exact for quadratic u. What it leaves,
// e = u - Pi u, costs boundary int [e^2/delta + 0.33 min(delta, l) (de/ds)^2], delta = 2 area/perimeter (L. Beirao da Veiga et al., Comput. Methods Appl. Mech. Eng.
// 295 (2015) 327-346, of virtual elements).
#pragma once

#include "gapflow/core/types.hpp"

#include <array>
#include <vector>

namespace gapflow {

struct ElementSide {
    Vec<2> from, to; ///< the face at the left; sides in any order, of a closed border
};

/// Values: of each side at its start, middle and end, then the mean.
struct PlaneElement {
    double area = 0;
    Vec<2> centroid = Vec<2>::Zero();
    /// Rows by values, and their weights: int |grad u|^2 + the cost of the rest = sum w (r u)^2.
    Eigen::MatrixXd rows;
    Eigen::VectorXd weight;
    Eigen::MatrixXd moment; ///< 2 rows: int (x - centroid) u
};

PlaneElement plane_element(const std::vector<ElementSide>& sides);

} // namespace gapflow
