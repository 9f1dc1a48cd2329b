// A vector with its moment, in the folder that compiles without contracted products.
#pragma once

#include "gapflow/core/types.hpp"

namespace gapflow {

/// (f, arm x f): wrench() of core/types.hpp, of which this folder must leave no copies (tools/check-copies).
template <int D>
Twist<D> lever(const Vec<D>& f, const Vec<D>& arm)
{
    Twist<D> w;
    w << f, moment<D>(arm, f);
    return w;
}

} // namespace gapflow
