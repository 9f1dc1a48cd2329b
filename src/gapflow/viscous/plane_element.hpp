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

/// What the rows consist of: Pi u is a sum of six monomials, that of number r with the factor sum_v project[v][r] value_v.
class PlaneProjection {
public:
    using Monomials = std::array<double, 6>;
    /// Of what the projection leaves at a side's start, middle and end: rows, and their weights.
    struct SideModes {
        std::array<std::array<double, 3>, 3> row;
        std::array<double, 3> weight;
    };

    explicit PlaneProjection(const std::vector<ElementSide>& sides) { find(sides); }
    PlaneProjection() = default;
    void find(const std::vector<ElementSide>& sides);
    /// Without area there is nothing else.
    bool empty() const { return project.empty(); }

    double area = 0;
    Vec<2> centroid = Vec<2>::Zero();
    Monomials energy;                   ///< of each monomial; they are orthogonal
    std::vector<Monomials> project;     ///< by values
    std::vector<Monomials> at;          ///< the monomials at the sides' starts, middles and ends
    Eigen::Matrix<double, 2, 6> moment; ///< of each monomial: int (x - centroid) m
    std::vector<SideModes> sides;

private:
    double centre(Vec<2>& middle);
    std::vector<ElementSide> lines_; ///< sides about the centroid
};

} // namespace gapflow
