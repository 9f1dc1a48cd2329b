// Order of elimination by nested dissection.
#pragma once

#include <Eigen/Sparse>

namespace gapflow {

/// Places in the order -> rows of a symmetric matrix with both triangles: separators that divide its graph into halves come last, those of the halves before them
/// (George 1973), found by METIS (Karypis & Kumar 1998). The same for the same matrix.
Eigen::VectorXi nested_dissection(const Eigen::SparseMatrix<double>& a);

} // namespace gapflow
