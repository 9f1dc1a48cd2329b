#include "gapflow/core/nested_dissection.hpp"

#include "gapflow/core/error.hpp"

#include <cholmod.h>

namespace gapflow {

Eigen::VectorXi nested_dissection(const Eigen::SparseMatrix<double>& a)
{
    Eigen::VectorXi order(a.cols());
    cholmod_common common;
    cholmod_start(&common);
    cholmod_sparse matrix{};
    matrix.nrow = matrix.ncol = static_cast<std::size_t>(a.cols());
    matrix.nzmax = static_cast<std::size_t>(a.nonZeros());
    matrix.p = const_cast<int*>(a.outerIndexPtr()); // read only
    matrix.i = const_cast<int*>(a.innerIndexPtr());
    matrix.stype = -1;
    matrix.itype = CHOLMOD_INT;
    matrix.xtype = CHOLMOD_PATTERN;
    matrix.sorted = matrix.packed = 1;
    const bool ordered = cholmod_metis(&matrix, nullptr, 0, /* postorder */ 0, order.data(), &common) != 0;
    cholmod_finish(&common);
    if (!ordered)
        throw ComputationError("METIS found no order of elimination");
    return order;
}

} // namespace gapflow
